"""Linearisations along a parameter or a held quantity, and where eigenvalues cross the imaginary axis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from nhc.records import record
from nhc.study.linearization.branch import Branch, find_end, follow, runs_of
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import Linearisation, Mode, linearise_at, modes
from nhc.study.linearization.narrowing import End, narrow
from nhc.study.linearization.spectrum import ROUNDING
from nhc.study.linearization.units import Matrix
from nhc.study.linearization.zeros import chain_of, sign_of, size_of, told_sign, without

_ROUNDED = 1e-10
"""Of the largest value of a sweep: a crossing this near to zero is there, for eigenvalues are not known better."""

_NEAR = 1e-5
"""Part of an interval in which a growth of the size of the eigenvalues does not come to nothing."""

_MEETING = 1e-2
"""Of a rate: what is left of a growth, or between two frequencies, next to where two pairs meet: the root of the way to it."""

_BESIDE = 1e-3
"""Part of the way to a neighbour at which a zero has a sign."""

_ZERO = "an eigenvalue passes zero"


@record
class Crossing:
    """At ``value`` an eigenvalue (``frequency`` 0) or a pair (rad per unit of time) crosses the imaginary axis.

    ``error`` is the width of the last interval; ``unstable_above`` says on which side more eigenvalues have a positive real part.
    """

    value: float
    kind: str
    frequency: float
    error: float
    unstable_above: bool


@record
class Sweep:
    """Linearisations at ``values`` and the crossings between them; ``unlocated`` are neighbours between which the number of growing
    eigenvalues changes, and no crossing is found; ``gone``: at each value what has become of velocities that were asked for;
    ``missing``: values at which no steady motion was found, and why; ``ends``: neighbours of which only the first
    has one, as near to each other as was looked.
    """

    values: tuple[float, ...]
    points: tuple[Linearisation, ...]
    crossings: tuple[Crossing, ...]
    unlocated: tuple[tuple[float, float], ...] = ()
    gone: tuple[tuple[str, ...], ...] = ()
    missing: tuple[tuple[float, str], ...] = ()
    ends: tuple[tuple[float, float], ...] = ()

    def leaves(self) -> tuple[float, str] | None:
        """The first value at which the motion is not the one that was asked about, and what has become of that."""
        values = zip(self.values, self.gone, strict=bool(self.gone))
        return next(((value, "; ".join(gone)) for value, gone in values if gone), None)


def sweep(branch: Branch, values: Sequence[float], name: str, own: float) -> Sweep:
    """Linearise at the values and look for crossings between neighbours; ``name`` is varied, and ``own`` where the guess is.

    Raises:
        NotSteady: there is a steady motion at none of the values.
    """
    found, missing = follow(branch, values, name, own)
    given = [value for value in values if value in found]
    branch.family = min((point.family for point in found.values()), default=0)
    for value, point in found.items():
        found[value] = linearise_at(branch.model(value)[0], point.steady, branch.family)
    chains = [chain_of(found[value].core) for value in given]
    static = _Static(branch, [min(counts) for counts in zip(*chains, strict=False)])
    near = _NEAR * min((abs(b - a) for a, b in pairwise(values)), default=0.0)
    least = _ROUNDED * max(map(abs, values), default=0.0)
    crossed, unlocated = list[Crossing](), list[tuple[float, float]]()
    for run in runs_of(values, found):
        points = [found[value] for value in run]
        between = crossings(static, run, points, near)
        unlocated += _unlocated(static, run, points, between)
        crossed += _passed(between, near)
    passed = tuple(replace(one, value=0.0) if abs(one.value) <= least else one for one in crossed)
    ends = [
        find_end(branch, *((a, b) if a in found else (b, a)))
        for a, b in pairwise(values)
        if (a in found) != (b in found)
    ]
    return Sweep(
        tuple(given),
        tuple(found[value] for value in given),
        passed,
        tuple(unlocated),
        missing=missing,
        ends=tuple(ends),
    )


def _unlocated(
    static: _Static, values: Sequence[float], points: Sequence[Linearisation], found: Sequence[Crossing]
) -> tuple[tuple[float, float], ...]:
    return tuple(
        (low, high)
        for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False)
        if _grow(a) != _grow(b)
        and not any(min(low, high) <= crossing.value <= max(low, high) for crossing in found)
        and _grow(static.inside(low, a, high)[1]) != _grow(static.inside(high, b, low)[1])
    )


def crossings(
    static: _Static, values: Sequence[float], points: Sequence[Linearisation], near: float
) -> tuple[Crossing, ...]:
    """Where the sign of the core's determinant or the number of growing oscillations changes, ``near`` the ends also beyond."""
    found = []
    for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False):
        found += [*static.between((low, a), (high, b)), *_oscillatory(static.branch, low, high, a, b)]
    for k, (value, point) in enumerate(zip(values, points, strict=True)):
        found += static.at(value, point, values[max(k - 1, 0)], values[min(k + 1, len(values) - 1)])
    if len(values) > 1:
        for value, toward, point in ((values[0], values[1], points[0]), (values[-1], values[-2], points[-1])):
            found += [
                replace(one, value=value)
                for one in _beyond(static, value, toward, point)
                if abs(one.value - value) <= near
            ]
    return tuple(sorted(found, key=lambda crossing: crossing.value))


def _passed(found: Sequence[Crossing], near: float) -> list[Crossing]:
    """Without the pairs that only touch the axis: they come to it and turn back at nearly the same value."""
    passed = list[Crossing]()
    for one in sorted(found, key=lambda crossing: crossing.value):
        back = next((other for other in passed if one.value - other.value <= near and _undoes(one, other)), None)
        if back is None:
            passed.append(one)
        else:
            passed.remove(back)
    return passed


def _undoes(one: Crossing, other: Crossing) -> bool:
    """Whether it is the same pair that comes back."""
    same = abs(one.frequency - other.frequency) <= _MEETING * one.frequency
    return same and one.kind == other.kind != _ZERO and one.unstable_above != other.unstable_above


class _Static:
    """Crossings of real eigenvalues.  ``zeros`` are as many as there are all along: they cross nothing, and leave no sign.

    Where a value is a zero itself, which may be passed or only touched, the signs a little beside it tell.
    """

    def __init__(self, branch: Branch, zeros: Sequence[int]) -> None:
        self.branch, self.zeros = branch, zeros

    def core(self, made: Linearisation) -> Matrix:
        """What crosses, if anything does."""
        return without(made.core, self.zeros)

    def told(self, made: Linearisation) -> float:
        """The sign of the core's determinant; 0 where that says nothing."""
        return told_sign(self.core(made))

    def beside(self, value: float, toward: float) -> tuple[float, Linearisation] | None:
        """A little way from a value; None where the branch has ended."""
        near = value + _BESIDE * (toward - value)
        try:
            return near, self.branch(near)
        except NotSteady:
            return None

    def inside(self, value: float, made: Linearisation, toward: float) -> tuple[float, Linearisation]:
        """A value and its linearisation, or where that is a zero those a little beside it, if the branch goes on there."""
        return (None if self.told(made) else self.beside(value, toward)) or (value, made)

    def at(self, value: float, made: Linearisation, before: float, after: float) -> list[Crossing]:
        """The crossing at a value of the sweep, if there is one; at its ends the branch is followed a little beyond."""
        if self.told(made):
            return []
        low = before if before != value else 2.0 * value - after
        high = after if after != value else 2.0 * value - before
        left, right = self.beside(value, low), self.beside(value, high)
        if left is None or right is None or self.told(left[1]) * self.told(right[1]) >= 0.0:
            return []
        return [Crossing(value, _ZERO, 0.0, 0.0, _grow(right[1]) > _grow(left[1]))]

    def between(self, first: tuple[float, Linearisation], last: tuple[float, Linearisation]) -> list[Crossing]:
        """The crossing between two values, which may be zeros themselves."""
        (low, a), (high, b) = self.inside(*first, last[0]), self.inside(*last, first[0])
        sign, passed = self.told(a), False
        if sign * self.told(b) >= 0:
            return []

        def judge(value: float, made: Linearisation) -> tuple[bool, float]:
            nonlocal passed
            core = self.core(made)
            if not passed and not told_sign(core):  # a zero that is only touched has the same sign on both sides
                sides = [self.beside(value, end) for end in (low, high)]
                signs = {self.told(side[1]) for side in sides if side is not None}
                passed = len(signs) > 1
                if not passed and None not in sides:
                    return signs == {sign}, size_of(core)
            return sign_of(core) == sign, size_of(core)

        ends = (
            End(low, a, True, size_of(self.core(a))),
            End(high, b, False, size_of(self.core(b))),
        )
        begin, end = (end.value for end in narrow(self.branch, ends, judge))
        return [Crossing((begin + end) / 2, _ZERO, 0.0, end - begin, _grow(b) > _grow(a))]


def _grow(made: Linearisation) -> int:
    return sum(mode.grows for mode in modes(made))


def _pairs(made: Linearisation, strict: bool) -> list[complex]:
    """Growing oscillations, the fastest first; ``strict``: those whose growth is no rounding."""
    return [
        mode.value for mode in modes(made) if _turns(made, mode) and (mode.grows if strict else mode.value.real > 0.0)
    ]


def _turns(made: Linearisation, mode: Mode) -> bool:
    """Whether a mode oscillates (upper half plane)."""
    return mode.value.imag > max(mode.limit, ROUNDING / made.tick)


def _resting(made: Linearisation) -> int:
    """How many eigenvalues lie on the axis: where two pairs of them meet, one grows and one decays beyond.

    One pair alone may lie there at a value of the sweep that happens to be that of its crossing, or belong to a part without
    friction.  Zeros count, for one of two pairs may have come to zero at such a value.
    """
    return sum(not mode.grows and not mode.decays for mode in modes(made))


def _oscillatory(branch: Branch, low: float, high: float, a: Linearisation, b: Linearisation) -> list[Crossing]:
    before, after = len(_pairs(a, True)), len(_pairs(b, True))
    if before == after:
        return []
    calm, wild = (a, b) if before < after else (b, a)
    conservative = _resting(calm) - _resting(wild) >= 4 * abs(after - before)
    strict = conservative or _resting(wild) > 0  # what stays on the axis would grow and decay by rounding
    least = max(before, after)

    first = before == least

    def judge(_: float, made: Linearisation) -> tuple[bool, float]:
        return (len(_pairs(made, strict)) >= least) == first, _growth(made, strict, least)

    def jumps(one: End, other: End) -> bool:
        """Whether a growth is left that no crossing has so near to it, for it goes through zero there."""
        end = one if one.like == first else other
        near = abs(one.value - other.value) <= _NEAR * (high - low)
        return near and not conservative and end.size > 0.01 * (1.0 / end.made.tick + _fastest(end.made))

    ends = narrow(branch, (End(low, a, True, judge(low, a)[1]), End(high, b, False, judge(high, b)[1])), judge, jumps)
    inner = ends[0 if first else 1].made
    pairs = sorted(_pairs(inner, strict), key=lambda x: x.real)
    if not pairs:
        return []
    # where a pair becomes two real eigenvalues it does not cross the axis; where two pairs meet there, growth is a root
    slow = (_MEETING if conservative else 1e-6 * (high - low)) * (1.0 / inner.tick + abs(pairs[0]))
    if pairs[0].real > slow:
        return []
    low, high = (end.value for end in ends)
    meeting = conservative and _meet(ends[1 if first else 0].made, abs(pairs[0].imag))
    kind = "two pairs meet on the axis" if meeting else "a pair crosses the axis"
    return [Crossing((low + high) / 2, kind, abs(pairs[0].imag), high - low, after > before)]


def _beyond(static: _Static, value: float, toward: float, made: Linearisation) -> list[Crossing]:
    """Pairs that cross as the branch is followed a little beyond an end of the sweep."""
    beyond = static.beside(value, 2.0 * value - toward)
    if beyond is None:
        return []
    (low, a), (high, b) = sorted(((value, made), beyond), key=lambda end: end[0])
    return _oscillatory(static.branch, low, high, a, b)


def _meet(calm: Linearisation, frequency: float) -> bool:
    """Whether two pairs on the axis have nearly that frequency."""
    near = (abs(mode.value.imag - frequency) for mode in modes(calm) if not mode.grows and not mode.decays)
    return sum(gap <= _MEETING * (1.0 / calm.tick + frequency) for gap in near) > 1


def _growth(made: Linearisation, strict: bool, count: int) -> float:
    """The growth of the last of the ``count`` oscillations that grow fastest; infinite where there are fewer."""
    found = sorted(
        (mode.value.real - (mode.limit if strict else 0.0) for mode in modes(made) if _turns(made, mode)), reverse=True
    )
    return found[count - 1] if len(found) >= count else math.inf


def _fastest(made: Linearisation) -> float:
    return max((abs(mode.value) for mode in modes(made)), default=0.0)
