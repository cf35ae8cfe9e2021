"""One step of a method in Python: what ``struct step`` is in C."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

Vector = list[float]


class Model(Protocol):
    """What a method asks of a model; a singular point raises an ArithmeticError."""

    def rhs(self, t: float, y: Sequence[float], p: Sequence[float]) -> Vector: ...

    def jacobian(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[Vector]: ...


class NoSolution(Exception):
    """The equations of an implicit step are not solved by Newton's iteration."""


@dataclass
class Step:
    """From (t, y) with slope to (t + h, reached) with arrived; ``tolerance`` 0 means fixed steps; ``shape`` is the interpolant."""

    model: Model
    p: Sequence[float]
    t: float
    y: Vector
    tolerance: float
    h: float = 0.0
    slope: Vector = field(default_factory=list)
    reached: Vector = field(default_factory=list)
    arrived: Vector = field(default_factory=list)
    size: Vector = field(default_factory=list)
    k: list[Vector] = field(default_factory=list)
    shape: list[Vector] | None = None
    first: bool = True
    status: int = 0
    calls: int = 0
    jacobians: int = 0

    def __post_init__(self) -> None:
        self.size = [abs(x) for x in self.y]

    def rhs(self, t: float, y: Vector) -> Vector:
        self.calls += 1
        return self.model.rhs(t, y, self.p)

    def jacobian(self, t: float, y: Vector) -> list[Vector]:
        self.jacobians += 1
        return self.model.jacobian(t, y, self.p)

    def allowed(self, reached: Vector) -> Vector:
        """The error that each component may make: relative to its own size in the run so far, this step's end included.

        From rest, where nothing has a size yet, what grows with a high power of the time counts beside what grows sooner.
        """
        sizes = [max(a, abs(b)) for a, b in zip(self.size, reached, strict=True)]
        least = 1e-6 * max(sizes, default=0.0)
        return [max(self.tolerance * max(size, least), sys.float_info.min) for size in sizes]

    def learn_sizes(self, square: float, trust: float) -> None:
        """From a state that is next to nothing: sizes to come, by a refused step that is right to the part ``trust`` of its end.

        Leaving rest as a power of the time, a motion has the same error relative to itself in each step from there, however short.
        ``square``: of the error relative to what is allowed.
        """
        ends = [abs(x) for x in self.reached]
        if square * self.tolerance**2 <= trust**2 and max(self.size, default=0.0) <= 1e-3 * max(ends, default=0.0):
            self.size = [max(a, b) for a, b in zip(self.size, ends, strict=True)]

    def cubic(self) -> list[Vector]:
        """Hermite's cubic through both ends, in the terms of ``interpolate``."""
        difference = [b - a for a, b in zip(self.y, self.reached, strict=True)]
        first = [self.h * f - d for f, d in zip(self.slope, difference, strict=True)]
        rows = zip(difference, self.slope, self.arrived, strict=True)
        return [difference, first, [2 * d - self.h * (f0 + f1) for d, f0, f1 in rows]]

    def interpolate(self, x: float) -> Vector:
        """y + x (f0 + (1 - x) (f1 + x (f2 + ...)))."""
        assert self.shape is not None
        value = [0.0] * len(self.y)
        for j in reversed(range(len(self.shape))):
            factor = x if j % 2 == 0 else 1.0 - x
            value = [(v + f) * factor for v, f in zip(value, self.shape[j], strict=True)]
        return [y + v for y, v in zip(self.y, value, strict=True)]


def combine(weights: Sequence[float], slopes: Sequence[Vector], i: int) -> float:
    """Sum of weight times slope, component i."""
    return sum(w * k[i] for w, k in zip(weights, slopes, strict=False) if w)
