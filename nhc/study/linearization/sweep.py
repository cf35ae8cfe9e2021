"""Linearisations along a parameter or a held quantity, and where eigenvalues cross the imaginary axis."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from nhc.records import record
from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.linearize import ROUNDING, Linearisation, Mode, linearise_at, modes
from nhc.study.linearization.steady import NotSteady, find_steady

_BISECTIONS = 60
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
    """Linearisations at ``values`` and the crossings between them."""

    values: tuple[float, ...]
    points: tuple[Linearisation, ...]
    crossings: tuple[Crossing, ...]


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
        steady = find_steady(model, self._guess if near is None else self._known[near], holds)
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
    return Sweep(tuple(values), tuple(points), crossings(branch, values, points))


def crossings(branch: Branch, values: Sequence[float], points: Sequence[Linearisation]) -> tuple[Crossing, ...]:
    """Where the sign of the core's determinant or the number of growing oscillations changes, by bisection."""
    found = []
    for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False):
        found += [*_static(branch, low, high, a, b), *_oscillatory(branch, low, high, a, b)]
    for value, before, at, after in zip(values[1:], points, points[1:], points[2:], strict=False):
        if _told(at) == 0.0 and _told(before) * _told(after) < 0.0:
            found.append(Crossing(value, _ZERO, 0.0, 0.0, _grow(after) > _grow(before)))
    return tuple(sorted(found, key=lambda crossing: crossing.value))


def _sign(made: Linearisation) -> float:
    return float(np.linalg.slogdet(made.core)[0]) if len(made.core) else 1.0


def _told(made: Linearisation) -> float:
    """The sign of the core's determinant; 0 where it is singular up to rounding, for there the sign is that of rounding."""
    sizes = np.linalg.svd(made.core, compute_uv=False) if len(made.core) else np.ones(1)
    return _sign(made) if sizes[-1] > 100.0 * ROUNDING * sizes[0] else 0.0


def _static(branch: Branch, low: float, high: float, a: Linearisation, b: Linearisation) -> list[Crossing]:
    first = _told(a)
    if first * _told(b) >= 0:
        return []
    low, high = _bisect(lambda value: _sign(branch(value)) == first, low, high)
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

    def grows(value: float) -> bool:
        return len(_pairs(branch(value), strict)) >= least

    first = before == least
    start, (low, high) = (low, high), _bisect(lambda value: grows(value) == first, low, high)
    inner = branch(low if first else high)
    pairs = sorted(_pairs(inner, strict), key=lambda x: x.real)
    # where a pair becomes two real eigenvalues it does not cross the axis
    slow = 1e-6 * (1.0 / inner.tick + abs(pairs[0])) * (start[1] - start[0]) if pairs else 0.0
    if not pairs or (not conservative and pairs[0].real > slow):
        return []
    kind = "two pairs meet on the axis" if conservative else "a pair crosses the axis"
    return [Crossing((low + high) / 2, kind, abs(pairs[0].imag), high - low, after > before)]


def _bisect(like_low: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if like_low(middle):
            low = middle
        else:
            high = middle
    return low, high
