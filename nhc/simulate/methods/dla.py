"""DLA: the discrete Lagrange-d'Alembert principle with the midpoint Lagrangian and the midpoint constraint, order 2.

J. Cortés and S. Martínez, Non-holonomic integrators, Nonlinearity 14 (2001) 1365-1392.  With q1 the next position,
m the midpoint and v = (q1 - q0)/h: the momenta h/2 dL/dq(m, v) -+ dL/dv(m, v) of neighbouring steps differ by
A(q)^T lambda, and A(m) v = 0.
"""

from __future__ import annotations

from nhc.simulate.methods.natural import (
    Natural,
    Point,
    Vector,
    find_root,
    impulse,
    middle,
    move,
    push,
    quotient,
    size_of,
    times,
    velocity,
)


class LagrangeDAlembert:
    """``Point.p`` is the momentum with which the last step arrives, before the constraints act."""

    name = "dla"
    order = 2
    citation = "Cortés and Martínez, Nonlinearity 14 (2001) 1365"
    constant_mass = False

    def start(self, system: Natural, q: Vector, v: Vector, h: float) -> Point:
        """The momentum of the start itself."""
        return Point(q, times(system.mass(q), v))

    def advance(self, system: Natural, point: Point, h: float) -> Point:
        """Solve for the next position and the multipliers."""
        q0 = point.q
        q1, _ = leave(system, q0, point.p, h)
        m, v = middle(q0, q1), quotient(q0, q1, h)
        arrives = move(times(system.mass(m), v), 0.5 * h, system.slope(m, v))
        return Point(q1, arrives)

    def read(self, system: Natural, point: Point, h: float) -> tuple[Vector, Vector]:
        """The momentum, projected along the reactions."""
        p = move(point.p, 1.0, impulse(system, point.q, point.p))
        return point.q, velocity(system, point.q, p)


def leave(system: Natural, q0: Vector, p: Vector, h: float) -> tuple[Vector, Vector]:
    """(q1, momentum with which it leaves q0): the momentum p changed by reactions so that A(m) (q1 - q0) = 0."""
    rows, n = system.rows(q0), len(q0)

    def residual(x: Vector) -> Vector:
        v, multipliers = x[:n], x[n:]
        m = move(q0, 0.5 * h, v)
        leaves = move(times(system.mass(m), v), -0.5 * h, system.slope(m, v))
        given = move(p, 1.0, push(rows, multipliers, n))
        return [*(a - b for a, b in zip(leaves, given, strict=True)), *times(system.rows(m), v)]

    guess = velocity(system, q0, move(p, 1.0, impulse(system, q0, p)))
    x = find_root(residual, [*guess, *[0.0] * len(rows)], size_of(guess))
    return move(q0, h, x[:n]), move(p, 1.0, push(rows, x[n:], n))
