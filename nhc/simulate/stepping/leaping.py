"""Whether a step leaps over a place where what the model is made of is short, as ``templates/c/methods/leaps.c.jinja`` has it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import pairwise
from math import copysign, inf
from sys import float_info
from typing import Protocol

from nhc.program.ir import CORNER
from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.step import Model, Step
from nhc.simulate.stepping.rounding import measure_rounding
from nhc.simulate.task import Task

_CLOSE = 1e-3  # to an end: what an argument does between them is how it goes there
_LOOKS = (0.0, _CLOSE, 2.0 * _CLOSE, 0.29, 0.5, 1.0 - 2.0 * _CLOSE, 1.0 - _CLOSE, 1.0)
# of the step, between two corners: closer ones may lie between two stages; closer still, they are one
_APART, _SAME = 0.5, 1e-9
_FEW = 100.0  # times its rounding, what an argument is that is next to nothing
_TIP = 1e-9  # of the step: what of it lies beyond a corner is as good as nothing
_SHORT = 1e-9  # of the state: a way aside
_WIDER = 20  # times fourfold: until a place is beyond a corner


class Placed(Model, Protocol):
    """A model whose steps must not leap over places: arguments, and of each what :class:`nhc.program.ir.Leaps` says of it."""

    @property
    def parts(self) -> Sequence[tuple[float, float]]: ...

    def places(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]: ...


def find_most(step: Step, model: Placed, task: Task, error: float, landings: int) -> tuple[float, float]:
    """How long the step after the one that was tried may be; 0 where that one leaps over something.  And the part of it at which
    the next attempt is to end, at the first corner; 1 where it passes none, or was to end there ``landings`` times before.
    """
    scale = max(abs(step.t), abs(task.times[-1] - task.times[0]))
    if not model.parts or task.step > 0 or abs(step.h) <= 1e-12 * scale:
        return inf, 1.0
    try:
        looks = [_look(step, model, x) for x in _LOOKS]
        ahead = model.places(step.t + _CLOSE * step.h, _along(step, _CLOSE * step.h), step.p)
    except ArithmeticError:
        return inf, 1.0
    courses = [_Course(values, *part) for values, part in zip(zip(*looks, strict=True), model.parts, strict=True)]
    for c, value in zip(courses, ahead, strict=True):
        c.tangent = (value - c.u) / _CLOSE
    wrong = error > 1.0
    lands = landings < (LIMITS.landings // 2 if wrong else LIMITS.landings)
    most = inf if wrong else _judge(step, model, courses)
    passed = lands and any(c.find_corner(wrong) < 1.0 for c in courses)
    if (most == 0.0 and any(c.part == 0.0 for c in courses)) or passed:  # it may be rounding that goes to and fro
        starts = [c.u for c in courses]
        noise = measure_rounding(lambda t, y: model.places(t, y, step.p), step.t, step.y, starts)
        for c, change in zip(courses, noise, strict=True):
            c.noise = change
        first = min(c.find_corner(wrong) for c in courses) if lands else 1.0
        if first < 1.0 and first * abs(step.h) > 1e-12 * scale:  # else it slides along it
            return 0.0, first * (1.0 - 1e-12)  # not beyond it, where the last stages may see another force
        most = _judge(step, model, courses) if most == 0.0 else most
    return most, 1.0


def hop(step: Step, model: Placed, next: float, bound: float) -> None:
    """A step has ended where it was to, at a corner: if that is just ahead, beside the length of the next step, the run goes on
    just behind it, where the slope may be another one, but not behind ``bound``.
    """
    h = 1e-3 * step.h
    try:
        near = _find_near(step, model, h, _TIP * next)
    except ArithmeticError:
        return
    length = max((2.0 * time for _, time in near), default=-1.0) + 4.0 * float_info.epsilon * abs(step.t)
    if length < 0.0 or length >= abs(bound - step.t):
        return
    moved = copysign(length, h)
    y = _along(step, moved)
    with suppress(ArithmeticError):
        step.slope = step.rhs(step.t + moved, y)
        step.t, step.y = step.t + moved, y


def find_held(step: Step, model: Placed, length: float) -> int:
    """The argument whose zero the state is at, beside the ``length`` of the next step, and which is driven back to it from either
    side, as dry friction does where it sticks; -1: there is none.

    The motion would slide along the jump (Filippov 1988, sec. 4), by a force that the model does not give.
    """
    h = 1e-3 * length
    try:
        near = _find_near(step, model, h, _TIP * abs(length))
        return next((k for k, time in near if _is_held(step, model, k, time, h)), -1)
    except ArithmeticError:
        return -1


def _find_near(step: Step, model: Placed, h: float, within: float) -> list[tuple[int, float]]:
    """The corners' arguments that are zero now or ``within`` a time by the slope alone, and when; ``h``: as long as rates are found
    over.
    """
    at, ahead = model.places(step.t, step.y, step.p), model.places(step.t + h, _along(step, h), step.p)
    near = list[tuple[int, float]]()
    for k, (place, later, part) in enumerate(zip(at, ahead, model.parts, strict=True)):
        change = later - place
        time = abs(h * place / change) if change else inf if place else 0.0
        if part == CORNER and place * change <= 0.0 and time < within:
            near.append((k, time))
    return near


def _is_held(step: Step, model: Placed, k: int, time: float, h: float) -> bool:
    """Whether argument ``k``, which is zero after a ``time``, has rates at either side of that with opposite signs, and other ones
    than what they vary by there.
    """
    moved = copysign(2.0 * time + 4.0 * float_info.epsilon * max(abs(step.t), abs(h)), h)
    aside = [moved * f for f in step.slope]
    for _ in range(_WIDER):  # the state's rounding may hide what it does
        if _find_at(step, model, k, moved, aside, -1.0) * _find_at(step, model, k, moved, aside, 1.0) < 0.0:
            break
        moved, aside = 4.0 * moved, [4.0 * a for a in aside]
    else:  # at rest it stays zero along the slope
        moved, aside = 0.0, _find_way(step, model, k)
        if _find_at(step, model, k, moved, aside, -1.0) * _find_at(step, model, k, moved, aside, 1.0) >= 0.0:
            return False
    before, behind, earlier, later = (_find_rate(step, model, k, moved, aside, x, h) for x in (-1.0, 1.0, -2.0, 2.0))
    driven = _find_at(step, model, k, moved, aside, -1.0) * before * h < 0.0 and before * behind < 0.0
    return driven and min(abs(before), abs(behind)) > 10.0 * (abs(earlier - before) + abs(later - behind))


def _find_way(step: Step, model: Placed, k: int) -> list[float]:
    """A short way along the entry of the state that argument ``k`` changes most with."""
    length = _SHORT * (max(map(abs, step.size), default=0.0) or 1.0)
    begin, most, way = model.places(step.t, step.y, step.p)[k], 0.0, [0.0] * len(step.y)
    for i in range(len(step.y)):
        moved = [y + length if i == j else y for j, y in enumerate(step.y)]
        change = abs(model.places(step.t, moved, step.p)[k] - begin)
        if change > most:
            most, way = change, [length if i == j else 0.0 for j in range(len(step.y))]
    return way


def _find_at(step: Step, model: Placed, k: int, moved: float, aside: Sequence[float], part: float) -> float:
    """Argument ``k`` at a part of the way ``aside``, which takes the time ``moved``."""
    return model.places(step.t + part * moved, [y + part * a for y, a in zip(step.y, aside, strict=True)], step.p)[k]


def _find_rate(step: Step, model: Placed, k: int, moved: float, aside: Sequence[float], part: float, h: float) -> float:
    """The same argument's rate there, over the time ``h``."""
    t, y = step.t + part * moved, [y + part * a for y, a in zip(step.y, aside, strict=True)]
    later = [a + h * f for a, f in zip(y, step.rhs(t, y), strict=True)]
    return (model.places(t + h, later, step.p)[k] - model.places(t, y, step.p)[k]) / h


def _judge(step: Step, model: Placed, courses: Sequence[_Course]) -> float:
    """As :func:`find_most`, by the courses of the arguments."""
    most, zeros, points = inf, list[float](), list[float]()
    for c in courses:
        if c.is_nothing():
            continue
        if c.is_fast():
            return 0.0
        if c.part > 0.0 and c.b != 0.0:
            most = min(most, 0.99 * c.ahead * abs(step.h) / abs(c.b))
        if c.part == 0.0 and c.u * c.v < 0.0:
            zeros.append(c.find_zero())
            points.append(zeros[-1])
        if c.part == 0.0 and abs(c.u) < 1e-9 * abs(c.v):
            zeros.append(0.0)  # it starts at a corner
        if c.a * c.b < 0.0:
            meet = (c.v - c.b - c.u) / (c.a - c.b)
            points += [meet] if 0.0 < meet < 1.0 else []
        points += c.find_turns()
    if any(_SAME < after - before < _APART for before, after in pairwise(sorted(zeros))):
        return 0.0
    for x in points:
        try:
            at = _look(step, model, x)
        except ArithmeticError:
            continue
        if any(not c.is_nothing() and c.is_narrow(x, value) for c, value in zip(courses, at, strict=True)):
            return 0.0
    return most


def _look(step: Step, model: Placed, x: float) -> list[float]:
    """The arguments at a part of the step; the state there is Hermite's cubic."""
    state = [
        y + x * (z - y) + x * (1.0 - x) * ((1.0 - x) * (step.h * f - z + y) - x * (step.h * g - z + y))
        for y, z, f, g in zip(step.y, step.reached, step.slope, step.arrived, strict=True)
    ]
    return model.places(step.t + x * step.h, state, step.p)


def _along(step: Step, time: float) -> list[float]:
    """The state after a time, by the slope at the start alone."""
    return [y + time * f for y, f in zip(step.y, step.slope, strict=True)]


class _Course:
    """An argument over a step by Hermite's cubic: from u to v, by a at first and by b at last; its bends there."""

    def __init__(self, values: Sequence[float], part: float, least: float) -> None:
        u, after, later, third, middle, early, before, v = values
        self.u, self.v, self.part, self.least, self.noise, self.tangent = u, v, part, least, 0.0, 0.0
        self.a = (4.0 * after - 3.0 * u - later) / (2.0 * _CLOSE)
        self.b = (3.0 * v - 4.0 * before + early) / (2.0 * _CLOSE)
        self.bend = abs(u - 2.0 * after + later) / _CLOSE**2
        self.bending = abs(v - 2.0 * before + early) / _CLOSE**2
        # in two places, so that nothing periodic looks as if it were at rest
        off = [abs(x - self.find_between(part)) - 0.25 * abs(x) for x, part in ((third, 0.29), (middle, 0.5))]
        self.off = max(0.0, *off)

    @property
    def ahead(self) -> float:
        """By how much it may change in the step after this one."""
        return (self.part if self.v * self.b < 0.0 else 4.0 * self.part) * abs(self.v) + self.least

    def is_nothing(self) -> bool:
        """Whether it is a corner's, and zero but for rounding from end to end: steps of every length see the same there."""
        largest = max(abs(self.u), abs(self.v), abs(self.find_between(0.5)), self.off)
        return self.part == 0.0 and largest < _FEW * self.noise

    def is_fast(self) -> bool:
        """Whether the step is too long for it by what it does at its ends and in the middle."""
        u, v, part, least = abs(self.u), abs(self.v), self.part, self.least
        if part == 0.0:
            off, bend = self.off - 4.0 * self.noise, max(self.bend, self.bending) - 8.0 * self.noise / _CLOSE**2
            return off > 0.1 * max(u, v) or bend > 10.0 * max(u, v)
        if u == 0.0 and least == 0.0:  # it leaves a root's zero, and does so alike in steps of every length
            return self.off > 0.0
        return (
            abs(self.a) > (part if self.u * self.a < 0.0 else 4.0 * part) * u + least
            or abs(self.b) > (part if self.v * self.b > 0.0 else 4.0 * part) * v + least
            or self.bend > 20.0 * u + 4.0 * least
            or self.bending > 20.0 * v + 4.0 * least
            or self.off > least
        )

    def is_narrow(self, x: float, at: float) -> bool:
        """Whether, with the value ``at`` at the part x of the step, it goes near zero and back; a corner for less than half."""
        u, v = abs(self.u), abs(self.v)
        if self.part > 0.0:
            return 4.0 * abs(at) + 2.0 * self.least < min(u, v)
        height = -at if self.u < 0.0 else at
        if self.u * self.v <= 0.0 or height >= 0.25 * max(u, v) or height >= min(u, v):
            return False
        return -height * (x / (u - height) + (1.0 - x) / (v - height)) < _APART

    def find_between(self, x: float) -> float:
        """Its value at the part x of the step."""
        u, d = self.u, self.v - self.u
        return u + x * d + x * (1.0 - x) * ((1.0 - x) * (self.a - d) - x * (self.b - d))

    def find_corner(self, wrong: bool) -> float:
        """Where a corner's argument is zero for the first time that is seen, as a part of the step; 1 where it is not.

        A step that has gone far beyond a corner may be all ``wrong``: then the slope at its start alone tells.
        """
        few, v, leaves = _FEW * self.noise, self.v, abs(self.u) <= _FEW * self.noise  # it begins at the corner
        left, u = (1e-3, self.find_between(1e-3)) if leaves else (0.0, self.u)
        if (self.part, self.least) != CORNER or (u * v < 0.0 and abs(v) <= few):
            return 1.0
        last = next(iter(self.find_turns()), 1.0) if u * v > 0.0 else 1.0  # it may go there and back
        if last <= left or (u * v if last == 1.0 else u * self.find_between(last)) >= 0.0:
            return 1.0
        zero, line = _halve(self.find_between, left, last), -u / self.tangent if u * self.tangent < 0.0 else 1.0
        if (zero < 0.5 * line or line < 0.9) if wrong else zero < 0.5 * line < 0.5:
            zero = line
        return zero if _TIP < zero < (1.0 if wrong else 1.0 - _TIP) else 1.0

    def find_zero(self) -> float:
        """The part of the step at which it is zero; its signs differ at the ends."""
        return _halve(self.find_between, 0.0, 1.0)

    def find_turns(self) -> list[float]:
        """Where it turns, in either half."""
        signs = [_slope(self, x) for x in (0.0, 0.5, 1.0)]
        halves = ((0.0, 0.5, signs[0] * signs[1]), (0.5, 1.0, signs[1] * signs[2]))
        return [_halve(lambda x: _slope(self, x), low, high) for low, high, product in halves if product < 0.0]


def _slope(c: _Course, x: float) -> float:
    d = c.v - c.u
    return c.a + x * (6.0 * d - 4.0 * c.a - 2.0 * c.b + 3.0 * x * (c.a + c.b - 2.0 * d))


def _halve(f: Callable[[float], float], left: float, right: float) -> float:
    """Where f loses the sign that it has at the left end."""
    negative = f(left) < 0.0
    for _ in range(50):
        middle = 0.5 * (left + right)
        left, right = (middle, right) if (f(middle) < 0.0) == negative else (left, middle)
    return left
