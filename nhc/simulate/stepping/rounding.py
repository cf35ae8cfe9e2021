"""What rounding makes of slopes (``templates/c/methods/rounding.c.jinja`` in Python)."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.linear import resolve
from nhc.simulate.methods.step import NoSolution, Step, Vector

_FEW = 4.0 * sys.float_info.epsilon
_PART = 2.0**-40
_GOLDEN = 0.6180339887498949


def measure_noise(s: Step, t: float, y: Vector, slope: Vector) -> None:
    """What rounding may make of the slopes, sixteen times: how far the slope at (t, y), which is known, goes with the state.

    Each entry moves by some 2^-40 of itself, there and back; the lesser of both counts, for a jump lies on one side.  And it moves
    by what the slopes that went so make of it in a step of length h, for they are slopes of others.  So do the parameters, for
    entries that are zero do not move, and what cancels beside them is made of parameters.  Terms that cancel have
    rounding that no small move of the state tells: it is what the sums of the slopes there and back differ by, of which each has a
    way of its own; but not more than four times as far as the slope goes, for it may jump.
    """
    parts = _shares(len(y) + len(s.p))
    moment, moved = _PART * abs(t), [0.0] * len(y)
    place = t + moment if s.h < 0.0 else t - moment
    sums = list[Vector]()
    for share in (8.0, 9.0, 10.0):
        least, both = [math.inf] * len(y), [0.0] * len(y)
        for far in (0.1 * share, -0.1 * share):
            rows = zip(y, parts, _carry(s, moved, parts), strict=False)
            near = [x + far * (_PART * x * part + m) for x, part, m in rows]
            given = [x + far * (_PART * x) * part for x, part in zip(s.p, parts[len(y) :], strict=True)]
            at = _call(s, place, near, given, slope)
            least = [min(a, abs(b - c)) for a, b, c in zip(least, at, slope, strict=True)]
            both = [b - c + a for a, b, c in zip(both, at, slope, strict=True)]
        moved = least
        sums.append(both)
    rounded = [min(max(each) - min(each), 4.0 * gone) for gone, *each in zip(moved, *sums, strict=True)]
    usual = [16.0 / _PART * sys.float_info.epsilon * gone for gone in moved]
    s.noise = [max(a, 16.0 * b) for a, b in zip(usual, rounded, strict=True)]


def _carry(s: Step, moved: Vector, parts: Vector) -> Vector:
    """What slopes that went so far make of the state in a step: an implicit one damps it, and the longer the more."""
    straight = [s.h * m * part for m, part in zip(moved, parts, strict=False)]
    if s.damping is None:
        return straight
    factors, pole = s.damping
    return [pole * x for x in resolve(factors, straight)]


def _shares(count: int) -> Vector:
    """How far each entry goes, beside the others: no two alike, for what they do must not cancel."""
    parts = [(_GOLDEN * (i + 1)) % 1.0 for i in range(count)]
    return [-0.5 - part if part < 0.5 else part for part in parts]


def _call(s: Step, t: float, y: Vector, p: Vector, slope: Vector) -> Vector:
    """The slope with parameters that have moved, or with those of the run, for a power of what is negative is an integer."""
    try:
        return s.rhs(t, y, p)
    except ArithmeticError:
        with suppress(ArithmeticError):
            return s.rhs(t, y)
        return slope


def look_at_length(s: Step) -> None:
    """A step of a length of its own is taken: where steps have become four times shorter, it is asked at its end what rounding
    makes of the slopes, for lengths that go down smoothly may follow rounding down while no step is refused.
    """
    h = abs(s.h)
    if h >= LIMITS.shorter * s.longest_since:
        s.longest_since = max(s.longest_since, h)
        return
    measure_noise(s, s.t, s.y, s.slope)
    s.longest_since = s.measured_step = h
    rows = zip(s.noise, s.size, strict=True)
    s.noise = [noise if LIMITS.steady * h * noise > s.tolerance * size else 0.0 for noise, size in rows]


def is_noisy(s: Step) -> bool:
    """Whether rounding allows some entry more than its size does."""
    rows = zip(s.size, s.noise, s.reached, strict=True)
    return any(abs(s.h) * noise > s.tolerance * max(size, abs(end)) for size, noise, end in rows)


def is_faint(s: Step) -> bool:
    """Whether some entry is so small beside the largest that rounding alone may have made it; one that is exactly zero is right."""
    sizes = [max(size, abs(end)) for size, end in zip(s.size, s.reached, strict=True)]
    return min((size for size in sizes if size > 0.0), default=sys.float_info.max) < LIMITS.faint * max(
        sizes, default=0.0
    )


def reconsider(s: Step, error: float, twice: bool, again: Callable[[], float]) -> float:
    """The error of an attempt that failed after another one (``twice``), or with an entry that is next to nothing.

    An entry that is zero but for rounding has errors beside its own size that no shorter step makes less.  What is asked where this
    step ends is not believed of others, unless it is taken: it may end anywhere.

    Raises:
        NoSolution: an implicit step has none with what rounding allows.
    """
    former, measured_step, s.measured_step = s.noise, s.measured_step, 0.0
    measure_noise(s, s.t + s.h, s.reached, s.arrived)
    if twice:
        s.set_floors()
    try:
        found = again() if s.floor_part or is_noisy(s) else error
    except (ArithmeticError, NoSolution):
        s.noise, s.measured_step = former, measured_step
        raise
    if not 0.0 <= found <= 1.0:
        s.noise, s.measured_step = former, measured_step
    return found


def measure_rounding(look: Callable[[float, Vector], Vector], t: float, y: Sequence[float], values: Vector) -> Vector:
    """What rounding of the state and of the time changes ``values`` by, the first of those that ``look`` gives at (t, y)."""
    changes = [0.0] * len(values)
    for k in range(len(y) + 1):
        moved, time = list(y), t
        if k < len(moved):
            moved[k] *= 1.0 + _FEW
        else:
            time *= 1.0 + _FEW
        with suppress(ArithmeticError):
            at = look(time, moved)
            changes = [change + abs(a - b) for change, a, b in zip(changes, at, values, strict=False)]
    return changes
