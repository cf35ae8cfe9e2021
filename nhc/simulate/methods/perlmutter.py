"""PERLMUTTER: the symmetric method (4.18) of McLachlan and Perlmutter for a constant mass matrix, order 2.

R. McLachlan and M. Perlmutter, Integrators for nonholonomic mechanical systems, J. Nonlinear Sci. 16 (2006) 283-328.
q = q0 + h/2 v0, M (v1 - v0) = h (f(q) + A(q)^T lambda), q1 = q + h/2 v1, A(q1) v1 = 0.
"""

from __future__ import annotations

from nhc.simulate.methods.natural import Natural, Point, Vector, find_root, move, push, size_of, times


class Perlmutter:
    """``Point.p`` is the velocity, on the constraints."""

    name = "perlmutter"
    order = 2
    citation = "McLachlan and Perlmutter, J. Nonlinear Sci. 16 (2006) 283, eq. (4.18)"
    constant_mass = True

    def start(self, system: Natural, q: Vector, v: Vector, h: float) -> Point:
        """The start itself."""
        return Point(q, v)

    def advance(self, system: Natural, point: Point, h: float) -> Point:
        """Solve for the velocity and the multipliers."""
        v0, n = point.p, len(point.q)
        half = move(point.q, 0.5 * h, v0)
        mass, force, rows = system.mass(half), system.slope(half, v0), system.rows(half)

        def residual(x: Vector) -> Vector:
            v = x[:n]
            changes = times(mass, [a - b for a, b in zip(v, v0, strict=True)])
            given = push(rows, x[n:], n)
            held = times(system.rows(move(half, 0.5 * h, v)), v)
            return [*(a - h * (b + c) for a, b, c in zip(changes, force, given, strict=True)), *held]

        x = find_root(residual, [*v0, *[0.0] * len(rows)], size_of(v0))
        return Point(move(half, 0.5 * h, x[:n]), x[:n])

    def read(self, system: Natural, point: Point, h: float) -> tuple[Vector, Vector]:
        """As it stands."""
        return point.q, point.p
