"""A step of an implicit Runge-Kutta method (``templates/c/methods/collocation.c.jinja`` in Python)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from math import sqrt

from nhc.simulate.methods.linear import SingularMatrix, factor, resolve
from nhc.simulate.methods.step import NoSolution, Step, Vector, combine
from nhc.simulate.methods.tableau import Collocation

SMALL = 1e-6
PATIENCE = 40
_PLACES = ((-2.0, 1 / 12), (-1.0, -8 / 12), (1.0, 8 / 12), (2.0, -1 / 12))


def attempt(s: Step, method: Collocation) -> float:
    """Solve for the stages by simplified Newton iteration; ``s.k[j]`` becomes y_j - y.  Returns the relative error or 0.

    Raises:
        NoSolution: the iteration does not converge.
    """
    jacobian = s.jacobian(s.t, s.y, s.slope)
    n, count = len(s.y), len(method.nodes)
    try:
        factors = factor(
            [
                [
                    (1.0 if (a, i) == (b, j) else 0.0) - s.h * method.rows[a][b] * jacobian[i][j]
                    for b in range(count)
                    for j in range(n)
                ]
                for a in range(count)
                for i in range(n)
            ]
        )
    except SingularMatrix as error:
        raise NoSolution from error
    s.k = [[s.h * node * f for f in s.slope] for node in method.nodes]
    found = _iterate(s, method, factors)
    if method.adaptive:
        s.reached = [y + z for y, z in zip(s.y, s.k[-1], strict=True)]
    else:
        s.reached = [y + s.h * combine(method.advance, found, i) for i, y in enumerate(s.y)]
    s.arrived, s.shape = s.rhs(s.t + s.h, s.reached), None
    return _estimate(s, method, jacobian) if s.tolerance > 0.0 else 0.0


def _iterate(s: Step, method: Collocation, factors: tuple[list[Vector], list[int]]) -> list[Vector]:
    """The slopes of the stages."""
    n, former, adaptive = len(s.y), math.inf, s.tolerance > 0.0
    sizes = [max(size, abs(y)) for size, y in zip(s.size, s.y, strict=True)]
    allowed = s.allowed(s.y) if adaptive else []
    for _ in range(PATIENCE):
        points = [[y + z for y, z in zip(s.y, stage, strict=True)] for stage in s.k]
        slopes = [s.rhs(s.t + c * s.h, point) for c, point in zip(method.nodes, points, strict=True)]
        right = [
            s.h * combine(row, slopes, i) - z[i] for row, z in zip(method.rows, s.k, strict=True) for i in range(n)
        ]
        change = resolve(factors, right)
        s.k = [[z[i] + change[j * n + i] for i in range(n)] for j, z in enumerate(s.k)]
        if adaptive:  # from rest an entry has no size but what this step gives it
            scale = [max(a, s.tolerance * abs(z)) for stage in s.k for a, z in zip(allowed, stage, strict=True)]
        else:  # what is zero but for rounding counts against the largest
            scale = [max(size, abs(z)) for stage in s.k for size, z in zip(sizes, stage, strict=True)]
            least = max(SMALL * max(scale), 1e-300)
            scale = [max(size, least) for size in scale]
        norm = max(abs(d) / size for d, size in zip(change, scale, strict=True))
        if not math.isfinite(norm):
            break
        if norm == 0.0:
            return slopes
        if norm <= 1e-3 or (norm <= 0.03 and norm >= former) if adaptive else norm <= 1e-9 and norm >= 0.5 * former:
            return slopes
        former = norm
    raise NoSolution


def _estimate(s: Step, method: Collocation, jacobian: list[Vector]) -> float:
    n, slope, norm = len(s.y), s.slope, math.inf
    matrix = [[(method.pole if i == j else 0.0) - s.h * jacobian[i][j] for j in range(n)] for i in range(n)]
    factors, allowed = factor(matrix), s.allowed(s.reached)
    s.damping = factors, method.pole
    for _ in range(2):
        right = resolve(factors, [s.h * f + combine(method.errors, s.k, i) for i, f in enumerate(slope)])
        s.errors = right
        norm = _size(right, allowed)
        if norm < 1.0 or not s.first:
            return norm
        damped = _moved_slope(s, jacobian, factors, allowed, right, norm)
        if damped is None:
            return norm
        slope = damped
    return norm


def _moved_slope(
    s: Step,
    jacobian: list[Vector],
    factors: tuple[list[Vector], list[int]],
    allowed: Vector,
    errors: Vector,
    norm: float,
) -> Vector | None:
    """The slope at the start moved by the errors, by which stiff parts of them are damped.

    None where a jump lies on the way: the slope is another one than the derivative says, and damps nothing.  If it lies within half
    of the error that is allowed, as where a motion starts at it, what comes after it counts.
    """
    moved = [combine(row, [[x] for x in errors], 0) for row in jacobian]
    for part in (1.0, 0.5 / norm):
        try:
            slope = s.rhs(s.t, [y + part * x for y, x in zip(s.y, errors, strict=True)])
        except ArithmeticError:
            return None
        bent = [s.h * (b - a - part * x) for a, b, x in zip(s.slope, slope, moved, strict=True)]
        far = not _size(resolve(factors, bent), allowed) <= 1.0
        if far == (part < 1.0):
            return [f + (1.0 - part) * x for f, x in zip(slope, moved, strict=True)]
    return None


def _size(errors: Sequence[float], allowed: Sequence[float]) -> float:
    """Relative to what is allowed."""
    return sqrt(sum((x / a) ** 2 for x, a in zip(errors, allowed, strict=True)) / len(errors))


def shape(s: Step, method: Collocation) -> list[Vector]:
    """The interpolant's terms: the collocation polynomial of Radau, Hermite's cubic or quintic for Gauss."""
    if method.adaptive:
        return _polynomial(s, method)
    cubic = s.cubic()
    if method.order <= 4:
        return cubic
    first, second = _bend(s, s.t, s.y, s.slope), _bend(s, s.t + s.h, s.reached, s.arrived)
    _, f1, f2 = cubic
    third = [0.5 * (b + 2 * u - 2 * v) for b, u, v in zip(first, f1, f2, strict=True)]
    fourth = [0.5 * (b + 2 * u + 4 * v) - w for b, u, v, w in zip(second, f1, f2, third, strict=True)]
    return [*cubic, third, fourth]


def _polynomial(s: Step, method: Collocation) -> list[Vector]:
    c0, c1, _ = method.nodes
    one = [(a / c0 - d) / (1 - c0) for a, d in zip(s.k[0], s.k[2], strict=True)]
    two = [(b / c1 - d) / (1 - c1) for b, d in zip(s.k[1], s.k[2], strict=True)]
    last = [(v - u) / (c1 - c0) for u, v in zip(one, two, strict=True)]
    return [s.k[2], [u - c0 * w for u, w in zip(one, last, strict=True)], last]


def _bend(s: Step, t: float, y: Vector, slope: Vector) -> Vector:
    """h^2 y'' along the motion: J f exactly, the rest by five points in time."""
    jacobian, delta = s.jacobian(t, y, slope), s.h / 16
    found = [s.h * s.h * combine(row, [[f] for f in slope], 0) for row in jacobian]
    for place, weight in _PLACES:
        moved = s.rhs(t + place * delta, y)
        found = [b + 16 * s.h * weight * f for b, f in zip(found, moved, strict=True)]
    return found
