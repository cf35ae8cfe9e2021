"""The interval about a crossing of a sweep, made as narrow as rounding allows."""

from __future__ import annotations

import math
from collections.abc import Callable

from nhc.records import record
from nhc.study.linearization.linearize import Linearisation

_STEPS = 150
_DIGITS = 32.0
"""Units in the last place of a crossing, of which rounding decides in eigenvalues."""


@record
class End:
    """One end of an interval with a crossing: whether it is ``like`` the low one, and a ``size`` that vanishes at a crossing."""

    value: float
    made: Linearisation
    like: bool
    size: float

    @property
    def signed(self) -> float:
        return abs(self.size) if self.like else -abs(self.size)


def narrow(
    branch: Callable[[float], Linearisation],
    ends: tuple[End, End],
    judge: Callable[[float, Linearisation], tuple[bool, float]],
    enough: Callable[[End, End], bool] = lambda one, other: False,
) -> tuple[End, End]:
    """The interval about a crossing, as narrow as rounding allows: the low end and the high one.

    Which side a value is on is what ``judge`` counts; where to look next is told by the sizes (inverse quadratic interpolation,
    Chandrupatla 1997), as long as the interval loses half of itself in three steps, else it is halved.  ``enough`` ends it before.
    """
    newest, across = ends[1], ends[0]
    before, part, width, slow, close = ends[0], 0.5, abs(ends[1].value - ends[0].value), 0, 1.0
    tiny = 1e-14 * max((abs(end.size) for end in ends if math.isfinite(end.size)), default=0.0)
    for _ in range(_STEPS):
        digit = max(math.ulp(newest.value), math.ulp(across.value))
        value = newest.value + part * (across.value - newest.value)
        if abs(across.value - newest.value) <= _DIGITS * digit or value in (newest.value, across.value):
            break
        made = branch(value)
        found = End(value, made, *judge(value, made))
        if found.like == newest.like:
            before = newest
        else:
            before, across = across, newest
        newest = found
        if enough(newest, across):
            break
        left = abs(across.value - newest.value)
        width, slow = (left, 0) if left <= width / 2 else (width, slow + 1)
        # next to a crossing rounding decides on the sides: from there on in steps that get longer
        least = min(close * digit / left, 0.5)
        part = _interpolated(before, newest, across, tiny) if slow < 3 or close > 1.0 else 0.5
        close = 4.0 * close if not least < part < 1.0 - least else 1.0
        part = min(max(part, least), 1.0 - least)
    low, high = sorted((newest, across), key=lambda end: end.value)
    return low, high


def _interpolated(before: End, newest: End, across: End, tiny: float) -> float:
    """The part of the way from the newest end to the other one where the size vanishes, if the three tell; else a half.

    A ``tiny`` size is zero but for rounding.
    """
    a, b, c = newest.signed, across.signed, before.signed
    if min(abs(a), abs(b)) <= tiny:
        return 0.0 if abs(a) <= abs(b) else 1.0
    if a == b or c in (a, b) or before.value == across.value or not math.isfinite(a + b + c):
        return 0.5
    place = (newest.value - across.value) / (before.value - across.value)
    size = (a - b) / (c - b)
    if not (size**2 < place and (1.0 - size) ** 2 < 1.0 - place):
        return 0.5
    way = (before.value - newest.value) / (across.value - newest.value)
    return a / (b - a) * c / (b - c) + way * a / (c - a) * b / (c - b)
