"""The nearest steady motion to a guess."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from nhc.study.linearization.equations import all_but, bound, equations, exact_equations, turned
from nhc.study.linearization.field import RANK, Hold, SteadyModel
from nhc.study.linearization.found import (
    Locked,
    NotSteady,
    SingularFrame,
    Steady,
    check_coordinates,
    check_frame,
    is_far,
    tell_singular,
    tell_way,
)
from nhc.study.linearization.roots import newton_step, refined, undecided
from nhc.study.linearization.turns import Turn, combined
from nhc.study.linearization.units import Matrix, Vector, is_steady, trials

_STEPS, _HALVINGS, _LEAST = 100, 40, 0.05
_PLAIN = 30  # steps of Newton's method, which has converged then or never does
_DAMPED, _UNDAMPED = 1.0, 0.0
_POSITIONS = 1e3  # how much more rates of positions count where a search begins than accelerations
_WEAKEST = 1e-13  # singular values below this part of the largest one are rounding


def find_motion(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold] = ()) -> Steady:
    """The steady motion near the guess, or where the search for one fails, an equilibrium near it.

    Far from an equilibrium, a search among all states may exchange a force against a friction that grows with the speed, and leave
    (van der Pol's oscillator); among the states at rest it cannot.

    Raises:
        NotSteady: neither is found.
    """
    try:
        return find_steady(model, guess, holds)
    except (SingularFrame, Locked):
        raise  # there is one, or it is for other coframes to say
    except NotSteady as error:
        resting = _find_rest(model, guess, (*holds, *model.leaf_holds))
        if resting is None and model.leaf_holds:
            resting = _find_rest(model, guess, holds)
        if resting is None:
            raise error
        return resting


def _find_rest(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold]) -> Steady | None:
    """The nearer of the equilibria to which Newton's method leads among the states at rest, with damping and without."""
    found: list[tuple[float, Steady]] = []
    for damping in (_UNDAMPED, _DAMPED):
        with suppress(ArithmeticError):
            own = model.in_units(guess)
            y = np.array(own.inside(guess))
            y[model.flow.system.n :] = 0.0
            made = _iterate(own, (), y, holds, damping, resting=True)
            way = np.array(own.inside(made.y)) - y
            if made.equilibrium and not is_far(
                way, y
            ):  # long steps may end anywhere, also where a force has faded away
                check_frame(model, made.y, "at the equilibrium")
                check_coordinates(model, made, guess)
                found.append((round(float(np.linalg.norm(way)), 6), made))
    return min(found, key=lambda one: one[0])[1] if found else None


def find_steady(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold] = ()) -> Steady:
    """The steady motion near the guess: damped Gauss-Newton (Levenberg) steps of least norm.

    Without ``holds`` the nearest member of the family of steady motions is found; the steps keep to the leaf of the guess (to first
    order in each step, and to the integrals that are known of it), so that what a hidden holonomic constraint holds stays what it
    was, unless a hold or a holonomic constraint sets it.

    Raises:
        NotSteady: the iteration ends elsewhere, or the model is singular on the way, or at the motion itself.
    """
    if model.leaf_holds:
        try:
            return _nearest(model, guess, holds)
        except Locked:
            raise
        except NotSteady:
            model = replace(model, leaf_holds=())  # there is none on the leaf
    return _nearest(model, guess, holds)


def _nearest(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold]) -> Steady:
    """The steady motion near the guess that has what is held.

    Raises:
        NotSteady: none is found.
    """
    every = (*holds, *model.leaf_holds)
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
            still = _iterate(own, (), y, every)
            found.append((0.0, replace(still, turns=model.symmetries[0])))
            groups = ()
    for turns in groups:
        try:
            made = _search(own, turns, np.concatenate([y, _first_turn(own, turns, y)]), every)
        except ArithmeticError as error:
            failed.append(
                tell_way(own, y, error) if isinstance(error, NotSteady) else tell_singular(model, guess, error)
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


def _first_turn(model: SteadyModel, turns: Sequence[Turn], y: Vector) -> Vector:
    """How fast the guess turns: what leaves the least of its rates, of positions above all, since velocities have yet to change."""
    if not turns:
        return np.zeros(0)
    rest = list(model.rest)
    weights = np.where(np.array(rest) < model.flow.system.n, _POSITIONS, 1.0)
    along = np.array([turn.at(y) for turn in turns])[:, rest]
    rates = model.field([float(x) for x in y])[0][rest]
    return np.asarray(np.linalg.lstsq((weights * along).T, weights * rates, rcond=None)[0])


@np.errstate(over="ignore", invalid="ignore")  # far away nothing need have a finite size
def _search(model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold]) -> Steady:
    """Where steps that must get nearer come to a halt, full ones of Newton's method may pass: what is held leaves few ways.

    Raises:
        NotSteady: neither ends at a steady motion.
    """
    try:
        return _iterate(model, turns, y, holds)
    except NotSteady:
        with suppress(ArithmeticError):
            place = y
            for step in range(_PLAIN if holds else 0):
                value, slopes, _ = equations(model, turns, place, holds)
                move = _step(value, slopes, bound(model, place, slopes[len(model.rest) :]), 0.0)
                place = place + move
                if float(np.linalg.norm(move)) <= 1e-14 * (1.0 + float(np.linalg.norm(place))):
                    return _accept(model, turns, place, holds, step)
        raise


@np.errstate(over="ignore", invalid="ignore")  # a trial far away may have no finite size: it is no better
def _iterate(
    model: SteadyModel,
    turns: Sequence[Turn],
    y: Vector,
    holds: Sequence[Hold],
    damping: float = _DAMPED,
    resting: bool = False,
) -> Steady:
    """``y`` is the state, with the speed of each turn after it; ``resting``: the steps leave the velocities as they are."""
    value, slopes, scale = equations(model, turns, y, holds)
    before, still = np.zeros_like(y), np.eye(len(y))[model.flow.system.n :] if resting else np.zeros((0, len(y)))
    for step in range(_STEPS + 1):
        size = float(np.max(np.abs(value), initial=0.0))
        across = np.vstack([bound(model, y, slopes[len(model.rest) :]), still])
        move = _step(value, slopes, across, damping)
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
    weights = np.where(
        sizes > rank * np.max(sizes, initial=0.0), sizes / np.maximum(sizes**2 + damping**2, 1e-300), 0.0
    )
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
    if model.in_doubles:
        return y, []
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
