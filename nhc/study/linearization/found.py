"""What a search for a steady motion ends with: the motion, or why there is none; and whether its equations hold there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.regular.trials import sampled_rows
from nhc.mechanics.regular.undefined import find_pole, find_undefined
from nhc.study.linearization.field import SINGULAR, SteadyModel
from nhc.study.linearization.turns import Turn
from nhc.study.linearization.units import Vector, beside

_FAR = 3.0  # as far from the start as that: no longer near it
_LEAST_FRAME = 0.01  # of the coframe's relative determinant, per constraint
_OTHER_POLE = "take coordinates that are regular there, such as angles about another axis, or look near another motion"
_IDLE = "`{}` moves nothing there, as an azimuth at its pole"


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
            usual = "start nearer to a steady motion with `--about`, or fix more of it with `--hold`; there may be none near"
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


def tell_singular(model: SteadyModel, guess: Sequence[float], error: ArithmeticError) -> NotSteady:
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


def tell_way(model: SteadyModel, y: Vector, error: NotSteady) -> NotSteady:
    """What it means where a search from y ended: with the motion far away the rates may fall for ever and never vanish."""
    if not math.isfinite(error.residual) or not error.place:
        return error
    way = np.abs(np.array(model.inside(error.place)) - y)
    k = int(np.argmax(way))
    if not is_far(way, y):
        return error
    gone = f"{model.flow.names[k]} = {error.place[k]:.3g}"
    what = f"the search for a steady motion runs off, to {gone}: rates get smaller on its way, but do not vanish"
    advice = "start elsewhere, as beyond the place where the rates are largest, or fix values with `--hold`; there may be none"
    return NotSteady(what, error.residual, error.place, advice, error.entries)


def is_far(way: Vector, y: Vector) -> bool:
    """Whether a search that has gone this way from the state y has left what is near it."""
    return float(np.max(np.abs(way))) > _FAR * (1.0 + float(np.max(np.abs(y))))


def _name_undefined(model: SteadyModel, y: Sequence[float]) -> str:
    """What of the spec has no value, or no slope, at the state y, in words; empty where all has."""
    system = model.flow.system
    try:
        rates = [model.value(y, node) for node in model.flow.velocities]
    except ArithmeticError:  # a singular coframe
        return ""
    place = {**model.values(y), **dict(zip(system.v, rates, strict=True))}
    return find_undefined(system, place)[0] or find_pole(system, place)[0]


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
