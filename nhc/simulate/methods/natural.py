"""What structure-preserving methods share: a natural system with linear constraints, its projections, Newton's method."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Protocol

from nhc.records import record
from nhc.simulate.methods.linear import Matrix, SingularMatrix, factor, resolve, solve
from nhc.simulate.methods.step import NoSolution

Vector = list[float]


class Natural(Protocol):
    """L = v M(q) v / 2 - V(q) with A(q) v = 0; ``slope`` is dL/dq."""

    def mass(self, q: Sequence[float]) -> Matrix: ...

    def slope(self, q: Sequence[float], v: Sequence[float]) -> Vector: ...

    def rows(self, q: Sequence[float]) -> Matrix: ...

    def total(self, q: Sequence[float], v: Sequence[float]) -> float: ...


@record
class Point:
    """What a method carries from step to step: positions and a velocity or momentum, as it defines it."""

    q: Vector
    p: Vector


class Scheme(Protocol):
    """A method: ``start`` from (q, v) on the constraints, ``advance`` by a step, ``read`` (q, v) on the constraints."""

    name: str
    order: int
    citation: str
    constant_mass: bool

    def start(self, system: Natural, q: Vector, v: Vector, h: float) -> Point: ...

    def advance(self, system: Natural, point: Point, h: float) -> Point: ...

    def read(self, system: Natural, point: Point, h: float) -> tuple[Vector, Vector]: ...


def times(matrix: Matrix, x: Sequence[float]) -> Vector:
    """Matrix times vector."""
    return [sum(a * b for a, b in zip(row, x, strict=True)) for row in matrix]


def push(rows: Matrix, multipliers: Sequence[float], size: int) -> Vector:
    """A^T lambda."""
    return [sum(row[i] * x for row, x in zip(rows, multipliers, strict=True)) for i in range(size)]


def impulse(system: Natural, q: Vector, p: Vector) -> Vector:
    """A^T mu such that A M^-1 (p + A^T mu) = 0: what the constraints add to a momentum to hold it."""
    rows, mass = system.rows(q), factor(system.mass(q))
    if not rows:
        return [0.0] * len(q)
    columns = [resolve(mass, row) for row in rows]
    block = [[sum(a * b for a, b in zip(row, column, strict=True)) for column in columns] for row in rows]
    v = resolve(mass, p)
    return push(rows, solve(block, [-x for x in times(rows, v)]), len(q))


def velocity(system: Natural, q: Vector, p: Vector) -> Vector:
    """M^-1 p."""
    return solve(system.mass(q), p)


def find_root(residual: Callable[[Vector], Vector], x: Vector, scale: float, floor: float = 1e-10) -> Vector:
    """Newton's method with the derivative by differences, down to rounding; ``floor``: changes that may only come and go, relative.

    Raises:
        NoSolution: it does not converge.
    """
    former, factors = math.inf, None
    for turn in range(30):
        r = residual(x)
        if factors is None or turn % 6 == 0:
            factors = _slopes(residual, x, r, scale)
        change = resolve(factors, r)
        x = [a - b for a, b in zip(x, change, strict=True)]
        norm = max(map(abs, change), default=0.0) / max(scale, 1e-300)
        if not math.isfinite(norm):
            break
        if norm <= 4e-16 or (norm <= floor and norm >= 0.3 * former):
            return x
        former = norm
    raise NoSolution


def _slopes(residual: Callable[[Vector], Vector], x: Vector, r: Vector, scale: float) -> tuple[Matrix, list[int]]:
    columns = []
    for j, value in enumerate(x):
        step = 1e-7 * max(abs(value), scale, 1e-8)
        moved = residual([*x[:j], value + step, *x[j + 1 :]])
        columns.append([(b - a) / step for a, b in zip(r, moved, strict=True)])
    try:
        return factor([list(row) for row in zip(*columns, strict=True)])
    except SingularMatrix as error:
        raise NoSolution from error


def size_of(*vectors: Sequence[float]) -> float:
    """The largest magnitude, at least 1e-3."""
    return max(1e-3, *(abs(x) for vector in vectors for x in vector))


def middle(a: Vector, b: Vector) -> Vector:
    """(a + b) / 2."""
    return [0.5 * (x + y) for x, y in zip(a, b, strict=True)]


def quotient(a: Vector, b: Vector, h: float) -> Vector:
    """(b - a) / h."""
    return [(y - x) / h for x, y in zip(a, b, strict=True)]


def move(a: Vector, h: float, b: Vector) -> Vector:
    """a + h b."""
    return [x + h * y for x, y in zip(a, b, strict=True)]
