"""Where in a step a watched value changes its sign or touches zero, as ``templates/c/methods/loop.c.jinja`` has it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from math import copysign, inf
from typing import Protocol

from nhc.program.runs.watch import WEAK
from nhc.simulate.methods.step import Step
from nhc.simulate.stepping.rounding import measure_rounding

Look = Callable[[float], list[float]]
"""The watched values at a part of the step."""

PIECES = 8
_GOLDEN = 0.61803398874989485
_TURNS = 40
LOW = 0.3
"""Of what a coframe's entries allow its determinant: below, the place where it vanishes counts as near."""
MOST_HALVINGS = 8
_GROWN = 1e3
_ASIDE = 0.375
_EPSILON = sys.float_info.epsilon


class Watching(Protocol):
    """A model with watched values: those from ``dips`` on are sought where they only touch zero; ``frames``: where those begin that
    tell how weak coframes are, and how many coframes these are.
    """

    @property
    def dips(self) -> int: ...

    @property
    def frames(self) -> tuple[int, int]: ...

    def watch(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]: ...


def watch_start(model: Watching, t: float, y: Sequence[float], p: Sequence[float], events: int) -> list[float]:
    """The watched values at the start.  A run that starts at the zero of an event leaves it: what rounding of the state would
    change it by is no more than a zero.
    """
    before = model.watch(t, y, p)
    if not events:
        return before
    changes = measure_rounding(lambda time, moved: model.watch(time, moved, p), t, y, before[:events])
    return [0.0 if abs(b) <= change else b for b, change in zip(before, changes, strict=False)] + before[events:]


def approaches(before: Sequence[float], after: Sequence[float], frames: tuple[int, int]) -> bool:
    """Whether a step leads more than half of the way to a place where a coframe is singular.

    Its determinant, which is not large against what its entries allow, has fallen by half.  The rates have poles there, and methods
    of high order that take such steps believe themselves far more exact than they are.
    """
    first, count = frames
    deepest, between = float(WEAK[0] ** 2), float(WEAK[0] ** 2 - WEAK[1] ** 2)
    for i in range(first, first + count * len(WEAK), len(WEAK)):  # the square minus two fractions of what is allowed
        allowed = (after[i + 1] - after[i]) / between
        square = after[i] + deepest * allowed
        former = before[i] + deepest * (before[i + 1] - before[i]) / between
        if square < 0.25 * former and square < LOW**2 * allowed:
            return True
    return False


def find_change(before: Sequence[float], after: Sequence[float]) -> int:
    """The first watched value whose sign is the other one ``after``, or -1: zero is not yet the other one."""
    pairs = zip(before, after, strict=True)
    return next((i for i, (a, b) in enumerate(pairs) if a < 0.0 < b or b < 0.0 < a), -1)


def keep_signs(before: Sequence[float], after: Sequence[float]) -> list[float]:
    """The values before the next piece; a zero keeps the sign that came before it."""
    return [b if b != 0.0 else a for a, b in zip(before, after, strict=True)]


def find_trend(s: Step, model: Watching, before: Sequence[float], h: float) -> list[float]:
    """Before the first step: how fast the values go, by a way of length h along the slope; without an answer they may dip."""
    try:
        at = model.watch(s.t + h, [y + h * f for y, f in zip(s.y, s.slope, strict=True)], s.p)
    except ArithmeticError:
        at = [0.0] * len(before)
    return [(b - a) / h for a, b in zip(before, at, strict=True)]


def may_dip(
    before: Sequence[float], trend: Sequence[float], after: Sequence[float], h: float, span: float, first: int
) -> bool:
    """Whether a value from ``first`` on may touch zero within a step: three such steps would bring it there as it went so far, and
    up again to what it is after, or as high as it was before.  How it went in a step ``span`` of a quarter of the length tells
    nothing.
    """
    if abs(h) > 4.0 * abs(span):
        return True
    rows = list(zip(before, trend, after, strict=True))[first:]
    return any(b * f * h < 0.0 and abs(b) + min(abs(b), abs(a)) < 3.0 * abs(f * h) for b, f, a in rows)


def may_touch(s: Step, model: Watching, before: Sequence[float], after: Sequence[float]) -> bool:
    """Whether a value may have touched zero in the step: its heights at nine places on Hermite's cubic, as find_deep sees them."""
    between = list(zip(s.y, s.reached, s.slope, s.arrived, strict=True))
    places = [before]
    for x in (piece / PIECES for piece in range(1, PIECES)):
        y = [
            a + x * (b - a) + x * (1 - x) * ((1 - x) * (s.h * f - b + a) - x * (s.h * g - b + a))
            for a, b, f, g in between
        ]
        try:
            places.append(model.watch(s.t + x * s.h, y, s.p))
        except ArithmeticError:
            return True
        if find_change(before, places[-1]) >= 0:
            return True
    columns = list(zip(*places, after, strict=True))[model.dips :]
    return any(find_deep([abs(value) for value in column]) >= 0 for column in columns)


def find_deep(heights: Sequence[float]) -> int:
    """The place of the lowest height, or -1 where neither the parabola through it and its neighbours nor the lines beside it, as a
    distance has them, go down by half of it.
    """
    last = len(heights) - 1
    place = min(range(last + 1), key=lambda i: heights[i])
    middle = min(max(place, 1), last - 1)
    a, b, c = heights[middle - 1 : middle + 2]
    if place == 0:  # it must fall at first
        return place if 4.0 * b < 3.0 * a + c or 2.0 * b - c < 0.5 * a else -1
    if place == last:  # it must rise at last
        return place if 3.0 * c + a > 4.0 * b or 2.0 * b - a < 0.5 * c else -1
    smooth = b < 0.01 * a or (c - a) ** 2 > 4.0 * b * (a - 2.0 * b + c)
    return place if smooth or find_fold(heights, place if c < a else place - 1) < 0.5 * b else -1


def find_fold(heights: Sequence[float], k: int) -> float:
    """Where between the heights k and k + 1 the lines meet that go through those before and those after: at which height."""
    if k == 0:
        return 2.0 * heights[1] - heights[2]
    if k == len(heights) - 2:
        return 2.0 * heights[k] - heights[k - 1]
    fall, rise = heights[k - 1] - heights[k], heights[k + 2] - heights[k + 1]
    return heights[k] - fall * (rise + heights[k] - heights[k + 1]) / (fall + rise) if fall > 0.0 < rise else heights[k]


def find_event(look: Look, before: list[float], events: int, first: int) -> tuple[float, int, list[float]]:
    """(part of the step, index of the value, values just before) of the first change of sign; part 2 where there is none.

    The first ``events`` values, and those from ``first`` on, are followed down to their least between the pieces, too.  One of the
    first ``events`` values that changes its sign through a pole goes on: it has no zero there.
    """
    heights, passed = [[abs(value)] for value in before], 0.0
    for piece in range(1, PIECES + 1):
        after = look(piece / PIECES)
        for column, value in zip(heights, after, strict=True):
            column.append(abs(value))
        for _ in range(PIECES):
            which = find_change(before, after)
            left, last = max((piece - 1) / PIECES, passed), piece / PIECES if which >= 0 else 2.0
            # what touches zero, or goes beyond it and back, may do so on the way to that change, or to the end
            for i in range(len(after) if which >= 0 or piece == PIECES else 0):
                if events <= i < first or (i < events and before[i] == 0.0):
                    continue
                sign = copysign(1.0, before[i])
                place = -1 if sign * after[i] <= 0.0 else find_deep(heights[i]) if piece > 1 else 0
                if place < 0 or (place == 0 and heights[i][0] == 0.0 and i < events):  # what begins at zero leaves it
                    continue
                low, high = max((place - 1) / PIECES, passed), min(place + 1, piece) / PIECES
                dip = _find_dip(look, i, sign, (low, high), i >= events) if low < high else -1.0
                if 0.0 <= dip < last:
                    which, left, last = i, low, dip
            if which < 0:
                break
            passed, which, before, height = _halve(look, before, after, (left, last), which, events)
            if not height:
                return passed, which, before
            before[which] = height
        before = keep_signs(before, after)
    return 2.0, -1, before


def _halve(
    look: Look, before: list[float], after: list[float], ends: tuple[float, float], which: int, events: int
) -> tuple[float, int, list[float], float]:
    """(part, the value that changes its sign up to there, values before it, its height beyond if that is a pole or else 0)."""
    left, right = ends
    beyond, least = after, [inf] * len(before)

    def is_pole() -> bool:
        """It is far larger at both sides than on the way there: towards a zero it becomes small, at a jump it stays."""
        return which < events and min(abs(before[which]), abs(beyond[which])) > _GROWN * least[which]

    for _ in range(60):
        if right - left <= _EPSILON:
            break
        middle = 0.5 * (left + right)
        try:
            after = look(middle)
        except ArithmeticError:  # at the pole itself, which is left at one side
            middle = left + _ASIDE * (right - left)
            try:
                after = look(middle)
            except ArithmeticError:
                if is_pole():
                    break
                raise
        least = [min(a, abs(b)) if b else a for a, b in zip(least, after, strict=True)]
        found = find_change(before, after)
        if found < 0:
            before, left = keep_signs(before, after), middle
        else:
            which, right, beyond = found, middle, after
    return right, which, list(before), beyond[which] if is_pole() else 0.0


def _find_dip(look: Look, i: int, sign: float, ends: tuple[float, float], at_zero: bool) -> float:
    """A place where value i has lost its sign (``at_zero``: zero is none), or -1: golden sections towards its least height."""
    left, right = ends
    low, high = right - _GOLDEN * (right - left), left + _GOLDEN * (right - left)
    at_low, at_high = sign * look(low)[i], sign * look(high)[i]
    for _ in range(_TURNS):
        if at_low < 0.0 or at_high < 0.0 or (at_zero and 0.0 in (at_low, at_high)):
            return low if at_low < 0.0 or (at_zero and at_low == 0.0) else high
        if at_low < at_high:
            right, high, at_high = high, low, at_low
            low = right - _GOLDEN * (right - left)
            at_low = sign * look(low)[i]
        else:
            left, low, at_low = low, high, at_high
            high = left + _GOLDEN * (right - left)
            at_high = sign * look(high)[i]
    return -1.0
