"""ENERGY: keeps the energy to rounding, by Gonzalez's discrete gradient with the constraints at the midpoint, order 2.

E. Celledoni, M. Farré Puiggalí, E. H. Høiseth and D. Martín de Diego, Energy-preserving integrators applied to
nonholonomic systems, J. Nonlinear Sci. 29 (2019) 1523-1562; O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449-467.  With
g the discrete gradient of H(q, p): q1 - q0 = h g_p, p1 - p0 = h (A(m)^T lambda - g_q), A(m) g_p = 0.  The
constraints hold in the mean of a step only.
"""

from __future__ import annotations

from nhc.simulate.methods.natural import Natural, Point, Vector, find_root, middle, push, size_of, times, velocity


class EnergyPreserving:
    """``Point.p`` is the momentum."""

    name = "energy"
    order = 2
    citation = "Celledoni, Farré Puiggalí, Høiseth and Martín de Diego, J. Nonlinear Sci. 29 (2019) 1523"
    constant_mass = False

    def start(self, system: Natural, q: Vector, v: Vector, h: float) -> Point:
        """The start itself."""
        return Point(q, times(system.mass(q), v))

    def advance(self, system: Natural, point: Point, h: float) -> Point:
        """Solve for the mean velocity, the force and the multipliers, so that small numbers stay small."""
        q0, p0, n = point.q, point.p, len(point.q)
        v0 = velocity(system, q0, p0)
        before = system.total(q0, v0)

        def split(x: Vector) -> tuple[Vector, Vector, Vector]:
            q1 = [a + h * b for a, b in zip(q0, x[:n], strict=True)]
            p1 = [a + h * b for a, b in zip(p0, x[n : 2 * n], strict=True)]
            return q1, p1, x[2 * n :]

        def residual(x: Vector) -> Vector:
            q1, p1, multipliers = split(x)
            m, pm = middle(q0, q1), middle(p0, p1)
            v = velocity(system, m, pm)
            down = system.slope(m, v)  # - dH/dq
            dq, dp = [b - a for a, b in zip(q0, q1, strict=True)], [b - a for a, b in zip(p0, p1, strict=True)]
            length = sum(a * a for a in (*dq, *dp))
            short = system.total(q1, velocity(system, q1, p1)) - before
            short -= sum(a * b for a, b in zip(v, dp, strict=True)) - sum(a * b for a, b in zip(down, dq, strict=True))
            part = short / length if length > 0.0 else 0.0
            rows = system.rows(m)
            gp = [a + part * b for a, b in zip(v, dp, strict=True)]
            force = [a - part * b + c for a, b, c in zip(down, dq, push(rows, multipliers, n), strict=True)]
            ends = (
                *(a - b for a, b in zip(x[:n], gp, strict=True)),
                *(a - b for a, b in zip(x[n : 2 * n], force, strict=True)),
            )
            return [*ends, *times(rows, gp)]

        guess = [*v0, *system.slope(q0, v0), *[0.0] * len(system.rows(q0))]
        # the difference of two energies is rounding over the square of a short step, which the multipliers feel
        length = sum((h * a) ** 2 for a in guess[: 2 * n])
        work = abs(before) + sum(abs(a * b) for a, b in zip(v0, p0, strict=True))
        floor = min(max(1e-10, 2e-14 * work / length if length > 0.0 else 0.0), 1e-6)
        q1, p1, _ = split(find_root(residual, guess, size_of(guess), floor))
        return Point(q1, p1)

    def read(self, system: Natural, point: Point, h: float) -> tuple[Vector, Vector]:
        """As it stands: the velocity may be off the constraints by a small multiple of the step."""
        return point.q, velocity(system, point.q, point.p)
