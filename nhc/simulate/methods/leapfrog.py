"""LEAPFROG: the nonholonomic leapfrog, the geometric nonholonomic integrator of the trapezoidal Lagrangian, order 2.

S. Ferraro, D. Iglesias and D. Martín de Diego, Momentum and energy preserving integrators for nonholonomic
dynamics, Nonlinearity 21 (2008) 1911-1928.  At each position the momentum that arrives is reflected: its part along
the constraints goes on, its part along the reactions turns round.  So the mean of both is on the constraints.
"""

from __future__ import annotations

from nhc.simulate.methods.dla import leave
from nhc.simulate.methods.natural import (
    Natural,
    Point,
    Vector,
    find_root,
    impulse,
    move,
    quotient,
    size_of,
    times,
    velocity,
)


class Leapfrog:
    """``Point.p`` is the momentum with which the last step arrives."""

    name = "leapfrog"
    order = 2
    citation = "Ferraro, Iglesias and Martín de Diego, Nonlinearity 21 (2008) 1911"
    constant_mass = False

    def start(self, system: Natural, q: Vector, v: Vector, h: float) -> Point:
        """The start's momentum less the half impulse that a midpoint step finds; the first reflection adds the whole one."""
        p = times(system.mass(q), v)
        _, leaves = leave(system, q, p, h)
        return Point(q, [2 * a - b for a, b in zip(p, leaves, strict=True)])

    def advance(self, system: Natural, point: Point, h: float) -> Point:
        """Reflect, then go to the position whose step leaves with that momentum."""
        q0, n = point.q, len(point.q)
        leaves = move(point.p, 2.0, impulse(system, q0, point.p))
        here = system.mass(q0)

        def residual(v: Vector) -> Vector:
            q1 = move(q0, h, v)
            p = [0.5 * (a + b) for a, b in zip(times(here, v), times(system.mass(q1), v), strict=True)]
            return [a - b for a, b in zip(move(p, -0.5 * h, system.slope(q0, v)), leaves, strict=True)]

        guess = velocity(system, q0, leaves)
        v = find_root(residual, guess, size_of(guess))
        q1 = move(q0, h, v)
        v = quotient(q0, q1, h)
        p = [0.5 * (a + b) for a, b in zip(times(here, v), times(system.mass(q1), v), strict=True)]
        assert len(p) == n
        return Point(q1, move(p, 0.5 * h, system.slope(q1, v)))

    def read(self, system: Natural, point: Point, h: float) -> tuple[Vector, Vector]:
        """The mean of the momenta that arrive and leave."""
        p = move(point.p, 1.0, impulse(system, point.q, point.p))
        return point.q, velocity(system, point.q, p)
