"""Linearisations along a parameter or a held quantity, and where eigenvalues cross the imaginary axis."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from nhc.records import record
from nhc.study.linearization.field import RANK, Hold, SteadyModel
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import ROUNDING, Linearisation, Mode, linearise_at, modes
from nhc.study.linearization.steady import find_motion, find_steady
from nhc.study.linearization.units import Matrix

_STEPS = 150
_DIGITS = 32.0
"""Units in the last place of a crossing, of which rounding decides in eigenvalues."""

_ROUNDED = 1e-11
"""Of the largest value of a sweep: a crossing this near to zero is there, for eigenvalues are not known better."""

_NEAR = 1e-5
"""Part of an interval in which a growth of the size of the eigenvalues does not come to nothing."""

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
    eigenvalues changes, and no crossing is found.
    """

    values: tuple[float, ...]
    points: tuple[Linearisation, ...]
    crossings: tuple[Crossing, ...]
    unlocated: tuple[tuple[float, float], ...] = ()


class Branch:
    """Steady motions along one number, each found from the nearest one before."""

    def __init__(self, model: Callable[[float], tuple[SteadyModel, tuple[Hold, ...]]], guess: Sequence[float]) -> None:
        self._model = model
        self._known: dict[float, tuple[float, ...]] = {}
        self._guess = tuple(guess)
        self.family: int | None = None
        self._turns: int | None = None  # how many, which tells the group

    def __call__(self, value: float) -> Linearisation:
        """The linearisation at a value.

        Raises:
            NotSteady: the branch ends before.
        """
        model, holds = self._model(value)
        near = min(self._known, key=lambda known: abs(known - value), default=None)
        if self._turns is not None:
            model = replace(model, symmetries=tuple(g for g in ((), *model.symmetries) if len(g) == self._turns))
        if near is None:
            steady = find_motion(model, self._guess, holds)
        else:  # nothing but the branch itself, which may end
            steady = find_steady(model, self._known[near], holds)
        self._known[value], self._turns = steady.y, len(steady.turns)
        return linearise_at(model, steady, self.family)


def sweep(branch: Branch, values: Sequence[float]) -> Sweep:
    """Linearise at the values and look for crossings between neighbours.

    Raises:
        NotSteady: with the value where the branch ends.
    """
    points = []
    for value in values:
        try:
            points.append(branch(value))
        except NotSteady as error:
            raise NotSteady(f"at {value:.10g}: {error}", error.residual, entries=error.entries) from None
    branch.family = min((point.family for point in points), default=0)
    points = [linearise_at(branch._model(v)[0], p.steady, branch.family) for v, p in zip(values, points, strict=True)]
    least = _ROUNDED * max(map(abs, values), default=0.0)
    found = tuple(
        replace(one, value=0.0) if abs(one.value) <= least else one for one in crossings(branch, values, points)
    )
    return Sweep(tuple(values), tuple(points), found, _unlocated(values, points, found))


def _unlocated(
    values: Sequence[float], points: Sequence[Linearisation], found: Sequence[Crossing]
) -> tuple[tuple[float, float], ...]:
    return tuple(
        (low, high)
        for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False)
        if _grow(a) != _grow(b) and not any(min(low, high) <= crossing.value <= max(low, high) for crossing in found)
    )


def crossings(branch: Branch, values: Sequence[float], points: Sequence[Linearisation]) -> tuple[Crossing, ...]:
    """Where the sign of the core's determinant or the number of growing oscillations changes."""
    found = []
    chains = [_chain(point.core) for point in points]
    zeros = [min(counts) for counts in zip(*chains, strict=False)]  # zero all along: no crossing, and no sign
    for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False):
        found += [*_static(branch, zeros, low, high, a, b), *_oscillatory(branch, low, high, a, b)]
    signs = [_told(_without(point.core, zeros)) for point in points]
    for k in range(1, len(points) - 1):
        if signs[k] == 0.0 and signs[k - 1] * signs[k + 1] < 0.0:
            found.append(Crossing(values[k], _ZERO, 0.0, 0.0, _grow(points[k + 1]) > _grow(points[k - 1])))
    return tuple(sorted(found, key=lambda crossing: crossing.value))


def _chain(core: Matrix) -> list[int]:
    """How many null directions a matrix has, then what is left of it beside these, and so on: all of its zeros."""
    found, left = list[int](), core
    while len(left):
        sizes = np.linalg.svd(left, compute_uv=False)
        count = int(np.sum(sizes <= RANK * sizes[0]))
        if not count:
            break
        found.append(count)
        left = _without(left, [count])
    return found


def _without(core: Matrix, zeros: Sequence[int]) -> Matrix:
    """What is left of a matrix beside as many null directions, then beside those of that."""
    for count in zeros:
        kept = np.linalg.svd(core)[2][: len(core) - count]
        core = np.asarray(kept @ core @ kept.T)
    return core


def _sign(core: Matrix) -> float:
    return float(np.linalg.slogdet(core)[0]) if len(core) else 1.0


def _told(core: Matrix) -> float:
    """The sign of the core's determinant; 0 where it is singular up to rounding, for there the sign is that of rounding."""
    sizes = np.linalg.svd(core, compute_uv=False) if len(core) else np.ones(1)
    return _sign(core) if sizes[-1] > 100.0 * ROUNDING * sizes[0] else 0.0


def _static(
    branch: Branch, zeros: Sequence[int], low: float, high: float, a: Linearisation, b: Linearisation
) -> list[Crossing]:
    before, after = (_without(made.core, zeros) for made in (a, b))
    first = _told(before)
    if first * _told(after) >= 0:
        return []

    def judge(made: Linearisation) -> tuple[bool, float]:
        core = _without(made.core, zeros)
        return _sign(core) == first, _determinant(core)

    ends = _End(low, a, True, _determinant(before)), _End(high, b, False, _determinant(after))
    low, high = (end.value for end in _narrow(branch, ends, judge))
    return [Crossing((low + high) / 2, _ZERO, 0.0, high - low, _grow(b) > _grow(a))]


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

    def judge(made: Linearisation) -> tuple[bool, float]:
        return (len(_pairs(made, strict)) >= least) == first, _growth(made, strict, least)

    def jumps(one: _End, other: _End) -> bool:
        """Whether a growth is left that no crossing has so near to it, for it goes through zero there."""
        end = one if one.like == first else other
        near = abs(one.value - other.value) <= _NEAR * (high - low)
        return near and not conservative and end.size > 0.01 * (1.0 / end.made.tick + _fastest(end.made))

    ends = _narrow(branch, (_End(low, a, True, judge(a)[1]), _End(high, b, False, judge(b)[1])), judge, jumps)
    inner = ends[0 if first else 1].made
    pairs = sorted(_pairs(inner, strict), key=lambda x: x.real)
    # where a pair becomes two real eigenvalues it does not cross the axis
    slow = 1e-6 * (1.0 / inner.tick + abs(pairs[0])) * (high - low) if pairs else 0.0
    low, high = (end.value for end in ends)
    if not pairs or (not conservative and pairs[0].real > slow):
        return []
    kind = "two pairs meet on the axis" if conservative else "a pair crosses the axis"
    return [Crossing((low + high) / 2, kind, abs(pairs[0].imag), high - low, after > before)]


def _determinant(core: Matrix) -> float:
    """The core's determinant beside what a matrix of its size has at most: a measure, not a sign."""
    sizes = np.linalg.svd(core, compute_uv=False) if len(core) else np.ones(1)
    return float(np.prod(sizes / max(sizes[0], 1e-300)))


def _growth(made: Linearisation, strict: bool, count: int) -> float:
    """The growth of the last of the ``count`` oscillations that grow fastest; infinite where there are fewer."""
    found = sorted(
        (mode.value.real - (mode.limit if strict else 0.0) for mode in modes(made) if _turns(made, mode)), reverse=True
    )
    return found[count - 1] if len(found) >= count else math.inf


def _fastest(made: Linearisation) -> float:
    return max((abs(mode.value) for mode in modes(made)), default=0.0)


@record
class _End:
    """One end of an interval with a crossing: whether it is ``like`` the low one, and a ``size`` that vanishes at a crossing."""

    value: float
    made: Linearisation
    like: bool
    size: float

    @property
    def signed(self) -> float:
        return abs(self.size) if self.like else -abs(self.size)


def _narrow(
    branch: Branch,
    ends: tuple[_End, _End],
    judge: Callable[[Linearisation], tuple[bool, float]],
    enough: Callable[[_End, _End], bool] = lambda one, other: False,
) -> tuple[_End, _End]:
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
        found = _End(value, made, *judge(made))
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


def _interpolated(before: _End, newest: _End, across: _End, tiny: float) -> float:
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
