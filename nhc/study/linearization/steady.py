"""The nearest steady motion to a guess."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np

from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.regular.trials import sampled_rows
from nhc.mechanics.regular.undefined import find_pole, find_undefined
from nhc.study.linearization.equations import all_but, bound, equations, exact_equations, turned
from nhc.study.linearization.field import RANK, SINGULAR, Hold, SteadyModel
from nhc.study.linearization.roots import newton_step, refined, undecided
from nhc.study.linearization.turns import Turn, combined
from nhc.study.linearization.units import Matrix, Vector, beside, is_steady, trials

_STEPS, _HALVINGS, _LEAST = 100, 40, 0.05
_WEAKEST = 1e-13  # singular values below this part of the largest one are rounding
_FAR = 3.0  # as far from the start as that: no longer near it
_LEAST_FRAME = 0.01  # of the coframe's relative determinant, per constraint


class NotSteady(ArithmeticError):
    """No steady motion was found; ``residual`` is the best that was reached, ``place`` the state where it was, ``entries`` those
    of the state whose rates were the largest there.

    ``advice`` says what to do about it.
    """

    def __init__(
        self,
        message: str,
        residual: float,
        place: Sequence[float] | Vector = (),
        advice: str = "",
        entries: Sequence[str] = (),
    ) -> None:
        super().__init__(message)
        self.residual, self.place, self.entries = residual, tuple(float(x) for x in place), tuple(entries)
        usual = "let `--about` name another state, or give the parameters other values with `--set`"
        if math.isfinite(residual):
            usual = "start nearer to a steady motion, or fix more of it with `--hold`; there may be none near"
        self.advice = advice or usual


class SingularFrame(NotSteady):
    """The coframe is singular at the steady motion, which its equations can neither find nor judge, or on the way to it."""


@dataclass(frozen=True)
class Steady:
    """A steady motion: the state, the largest rate that is left of what should stand still, the steps taken.

    ``turning`` is the turn that goes with it, made of ``turns``.  ``residual`` is in the
    units of :mod:`nhc.study.linearization.units`.  ``others`` are states of which it may as well be one, as far as digits tell.
    """

    y: tuple[float, ...]
    residual: float
    steps: int
    equilibrium: bool
    turning: Turn | None = field(default=None, compare=False)
    turns: tuple[Turn, ...] = field(default=(), compare=False)
    others: tuple[tuple[float, ...], ...] = field(default=(), compare=False)


_OTHER_POLE = "take coordinates that are regular there, such as angles about another axis, or look near another motion"
_IDLE = "`{}` moves nothing there, as an azimuth at its pole"


class Locked(NotSteady):
    """The coordinates are singular at the motion ``steady`` that was found: rates and slopes there are worth nothing.

    ``regularity`` says how nearly: in [0, 1], and next to nothing.
    """

    def __init__(self, steady: Steady, regularity: float, idle: Sequence[str] = ()) -> None:
        message = f"the coordinates are singular at the steady motion that is found (conditioning {regularity:.2g})"
        advice = "give the orientation as a `rotation`, take other angles, or look near another motion"
        if len(idle) == 1:
            advice = _OTHER_POLE
        message += f": {_IDLE.format(idle[0])}" if len(idle) == 1 else ", as angles are in a gimbal lock"
        super().__init__(message, math.inf, steady.y, advice)
        self.steady, self.regularity = steady, regularity


def find_steady(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold] = ()) -> Steady:
    """The steady motion near the guess: damped Gauss-Newton (Levenberg) steps of least norm.

    Without ``holds`` the nearest member of the family of steady motions is found; the steps keep to the leaf of the guess (to first
    order in each step), so that what a hidden holonomic constraint holds stays what it was, unless a hold or a holonomic constraint
    sets it.

    Raises:
        NotSteady: the iteration ends elsewhere, or the model is singular on the way, or at the motion itself.
    """
    found: list[tuple[float, Steady]] = []
    failed: list[NotSteady] = []
    try:
        own = model.in_units(guess)
    except ArithmeticError:
        own = model  # the iteration says why
    y = np.array(own.inside(guess))
    groups = own.symmetries or ((),)
    if groups[0] and not holds and not y[model.flow.system.n :].any():  # who asks about rest means an equilibrium
        with suppress(ArithmeticError):
            still = _iterate(own, (), y, holds)
            found.append((0.0, replace(still, turns=model.symmetries[0])))
            groups = ()
    for turns in groups:
        try:
            made = _iterate(own, turns, np.concatenate([y, _first_turn(own, turns, y)]), holds)
        except ArithmeticError as error:
            failed.append(
                _tell_way(own, y, error) if isinstance(error, NotSteady) else _tell_singular(model, guess, error)
            )
            continue
        found.append((round(float(np.linalg.norm(np.array(own.inside(made.y)) - y)), 6), made))
    if not found:
        check_frame(model, failed[0].place, "where the search for a steady motion ends")
        raise failed[0] from None
    best = min(found, key=lambda one: one[0])[1]  # of equally near ones that with fewer turns
    check_frame(model, best.y, "at the steady motion")
    check_coordinates(model, best, guess)
    return best


def _tell_singular(model: SteadyModel, guess: Sequence[float], error: ArithmeticError) -> NotSteady:
    """What it means that the equations have no values on the way from the guess."""
    idle = model.idle_velocities(guess, guess)
    if len(idle) == 1:
        why = _IDLE.format(idle[0])
        return NotSteady(f"the coordinates are singular where the search begins: {why}", math.inf, guess, _OTHER_POLE)
    what = _name_undefined(model, guess)
    if what:
        return NotSteady(f"{what} where the search for a steady motion begins", math.inf, guess)
    far = "the search for a steady motion runs off" if isinstance(error, OverflowError) else ""
    return NotSteady(far or f"the model is singular on the way: {error}", math.inf, guess)


def _name_undefined(model: SteadyModel, y: Sequence[float]) -> str:
    """What of the spec has no value, or no slope, at the state y, in words; empty where all has."""
    system = model.flow.system
    try:
        rates = [model.value(y, node) for node in model.flow.velocities]
    except ArithmeticError:  # a singular coframe
        return ""
    place = {**model.values(y), **dict(zip(system.v, rates, strict=True))}
    text, _ = find_undefined(system, place)
    return f"`{text}` has no real, finite value" if text else find_pole(system, place)[0]


def _tell_way(model: SteadyModel, y: Vector, error: NotSteady) -> NotSteady:
    """What it means where a search from y ended: with the motion far away the rates may fall for ever and never vanish."""
    if not math.isfinite(error.residual) or not error.place:
        return error
    way = np.abs(np.array(model.inside(error.place)) - y)
    k = int(np.argmax(way))
    if way[k] <= _FAR * (1.0 + float(np.max(np.abs(y)))):
        return error
    gone = f"{model.flow.names[k]} = {error.place[k]:.3g}"
    what = f"the search for a steady motion runs off, to {gone}: rates get smaller on its way, but do not vanish"
    advice = "start elsewhere, as beyond the place where the rates are largest, or fix values with `--hold`; there may be none"
    return NotSteady(what, error.residual, error.place, advice, error.entries)


def check_frame(model: SteadyModel, y: Sequence[float], where: str) -> None:
    """Nothing where the coframe is sound at the state y.

    Raises:
        SingularFrame: it is singular there, or so nearly that its equations are worth nothing.
    """
    if model.frame is None or not y:
        return
    rows = sampled_rows(model.flow.system, model.frame.forms, [model.values(y)])
    sound = _soundness(model, rows)
    if sound < _LEAST_FRAME:  # lengths in millimetres and angles in radians look alike only beside their masses
        lengths = model.lengths(y)
        sound = max(
            sound, _soundness(model, [[[x * d for x, d in zip(row, lengths, strict=True)] for row in m] for m in rows])
        )
    if sound < _LEAST_FRAME:
        raise SingularFrame(f"the coframe is singular {where} (conditioning {sound:.2g})", float("inf"))


def check_coordinates(model: SteadyModel, steady: Steady, guess: Sequence[float]) -> None:
    """Nothing where the coordinates are regular at a steady motion, to which a search from the guess led.

    Raises:
        Locked: they are not (Euler's angles in their lock, a sphere's azimuth at its pole).
    """
    regularity = min(model.regularity(steady.y), model.presence(steady.y, guess))
    if regularity <= SINGULAR:
        raise Locked(steady, regularity, model.idle_velocities(steady.y, guess))


def check_smooth(model: SteadyModel, steady: Steady) -> None:
    """Nothing where the field has a derivative at the steady motion.

    Raises:
        NotSteady: it jumps there, or bends (dry friction, stops): what it does to small perturbations is no matrix.
    """
    own = replace(model, turning=steady.turning, symmetries=(steady.turns,)).in_units(steady.y)
    y, rest = own.inside(steady.y), list(model.rest)
    rates, jacobian = own.field(y)
    most = 1e-5 * max(1.0, float(np.max(np.abs(jacobian), initial=0.0)))
    for near in beside(y):
        try:
            other, slopes = own.field(near)
        except ArithmeticError:  # the edge of a domain: nothing is told of the other side
            continue
        if max(float(np.max(np.abs(a - b)[rest], initial=0.0)) for a, b in ((other, rates), (slopes, jacobian))) > most:
            what = "the equations of motion have a jump or a kink at the steady motion: no matrix says what is near it"
            advice = "round it off (`tanh(v/eps)` for `sign(v)`), or look at a motion on one side of it"
            raise NotSteady(what, math.inf, steady.y, advice)


def _soundness(model: SteadyModel, rows: Sequence[Sequence[Sequence[float]]]) -> float:
    """The determinant of the coframe beside what its rows allow, for each constraint."""
    assert model.frame is not None
    power = len(model.frame.forms) / max(model.flow.system.l, 1)
    return min((relative_determinant(row, range(len(row))) ** power for row in rows), default=0.0)


def _first_turn(model: SteadyModel, turns: Sequence[Turn], y: Vector) -> Vector:
    """How fast the guess turns: what leaves the least of its rates."""
    if not turns:
        return np.zeros(0)
    rest = list(model.rest)
    along = np.array([turn.at(y) for turn in turns])[:, rest]
    return np.asarray(np.linalg.lstsq(along.T, model.field([float(x) for x in y])[0][rest], rcond=None)[0])


def _iterate(model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold]) -> Steady:
    """``y`` is the state, with the speed of each turn after it."""
    value, slopes, scale = equations(model, turns, y, holds)
    before, damping = np.zeros_like(y), 1.0
    for step in range(_STEPS + 1):
        size = float(np.max(np.abs(value), initial=0.0))
        move = _step(value, slopes, bound(model, y, slopes[len(model.rest) :]), damping)
        if size == 0.0 or float(np.linalg.norm(move)) <= 1e-14 * (1.0 + float(np.linalg.norm(y))):
            return _accept(model, turns, y, holds, step)
        factor = 2.0 if _halves(before, move) else 1.0
        for _ in range(_HALVINGS):
            trial = y + factor * move
            try:
                next_value, next_slopes, next_scale = equations(model, turns, trial, holds)
            except ArithmeticError:
                factor /= 2
                continue
            if float(np.linalg.norm(next_value)) < (1.0 - 1e-4 * min(1.0, factor)) * float(np.linalg.norm(value)):
                break
            factor /= 2
        else:
            if damping == 0.0 or size <= 1e-12 * scale:
                return _accept(model, turns, y, holds, step)
            damping = 0.0  # what is left lies along weak directions: plain Gauss-Newton from here on
            continue
        before = move
        if damping:
            damping = max(damping / 3, _LEAST) if factor >= 1.0 else min(damping * 3, 1.0)
        y, value, slopes, scale = trial, next_value, next_slopes, next_scale
    what = f"no steady motion after {_STEPS} steps from there"
    raise NotSteady(what, size, model.outside(y[: len(model.flow.y)]), entries=_fastest(model, value))


def _fastest(model: SteadyModel, value: Vector) -> list[str]:
    """The entries of the state whose rates are far from vanishing."""
    rates = np.abs(value[: len(model.rest)])
    most = float(np.max(rates, initial=0.0))
    return [model.flow.names[i] for i, rate in zip(model.rest, rates, strict=True) if rate > most / 3]


def _step(value: Vector, slopes: Matrix, across: Matrix, damping: float, rank: float = RANK) -> Vector:
    """Levenberg's step with ``damping`` |value|, within ``across``: quadratic also where solutions are not isolated, as in a
    family of steady motions, whose own directions are weak near it and must not be taken for wanted (Yamashita and Fukushima 2001).
    """
    inside = all_but(across, slopes.shape[1])
    left, sizes, right = np.linalg.svd(slopes @ inside.T, full_matrices=False)
    damping *= float(np.linalg.norm(value))
    weights = np.where(sizes > rank * sizes.max(initial=0.0), sizes / np.maximum(sizes**2 + damping**2, 1e-300), 0.0)
    return np.asarray(-(weights * (left.T @ value)) @ right @ inside)


def _halves(before: Vector, move: Vector) -> bool:
    """Steps that halve again and again lead to a double root: twice the step is right."""
    size, last = float(np.linalg.norm(move)), float(np.linalg.norm(before))
    return 0.45 * last < size < 0.55 * last and float(before @ move) > 0.99 * size * last


def _accept(model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold], steps: int) -> Steady:
    """The iteration can do no better: either rounding is all that is left, or there is nothing to find.

    Beside very steep slopes (a coframe that is almost singular) plain ones count as weak, and one step along them is left to do.
    """
    try:
        return _accepted(model, turns, y, holds, steps)
    except NotSteady:
        value, slopes, _ = equations(model, turns, y, holds)
        move = _step(value, slopes, bound(model, y, slopes[len(model.rest) :]), 0.0, _WEAKEST)
        with suppress(ArithmeticError):
            return _accepted(model, turns, y + move, holds, steps + 1)
        raise


def _accepted(model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold], steps: int) -> Steady:
    """The steady motion at y.

    Raises:
        NotSteady: there is none.
    """
    value, slopes, scale = equations(model, turns, y, holds)
    state, own = turned(model, turns, y)
    size, rest = float(np.max(np.abs(value), initial=0.0)), list(model.rest)

    def others() -> list[Vector]:
        return [np.concatenate([rates[rest], value[len(rest) :]]) for rates, _ in own.nearby(state)]

    if size > 1e-9 * scale or not is_steady(value, slopes, y, others):
        what = "the iteration stops where the motion is not steady"
        raise NotSteady(what, size, model.outside(state), entries=_fastest(model, value))
    y, places = _settled(model, turns, y, holds)
    count = len(model.flow.y)
    speeds = np.where(np.abs(y[count:]) > 1e-12 * scale, y[count:], 0.0)  # slower turns are rounding
    if turns and not combined(speeds, turns).moves(y[:count], rest):  # nor is there any about an axis through all of it
        speeds = np.zeros_like(speeds)
    y = np.concatenate([y[:count], speeds])
    state, own = turned(model, turns, y)
    size = float(np.max(np.abs(equations(model, turns, y, holds)[0]), initial=0.0))
    n, turning = model.flow.system.n, own.turning if turns else None
    still = bool(np.max(np.abs(model.field(state)[0][:n]), initial=0.0) <= 1e-9 * scale)
    if model.units is not None:
        states, time = np.array(model.units.states), model.units.time
        turning = None if turning is None else turning.outside(states, time)
        turns = [turn.outside(states) for turn in turns]
    return Steady(
        model.outside(state), size, steps, still, turning, tuple(turns), tuple(model.outside(place) for place in places)
    )


def _settled(
    model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold]
) -> tuple[Vector, list[list[float]]]:
    """The root itself where y is only near it, and states that may be the root as well for all that rounded parameters tell."""
    moved, slopes = _moved(model, turns, y, holds)
    if undecided(slopes, [equations(model, turns, place, holds)[1] for place in moved]):
        inside = all_but(bound(model, y, slopes[len(model.rest) :]), len(y))
        better = refined(exact_equations(model, turns, holds), inside, y)
        if better is not None:
            y, moved = better, _moved(model, turns, better, holds)[0]
    return y, [turned(model, turns, place)[0] for place in moved]


def _moved(model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold]) -> tuple[list[Vector], Matrix]:
    """Where one step of Newton's method from y goes with parameters that rounding may have made of them; the slopes at y."""
    slopes, found = equations(model, turns, y, holds)[1], list[Vector]()
    for _, p in trials(y.tolist()[: len(model.flow.y)], model.p):
        with suppress(ArithmeticError):
            place = y + newton_step(equations(replace(model, p=p), turns, y, holds)[0], slopes, y)
            equations(model, turns, place, holds)
            found.append(place)
    return found, slopes
