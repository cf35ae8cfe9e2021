"""RK4: the classical method of order 4, with fixed steps.

W. Kutta, Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen, Z. Math. Phys. 46 (1901) 435-453.
Between the steps it is interpolated by Hermite's cubic.
"""

from __future__ import annotations

from nhc.simulate.methods.tableau import Explicit

METHOD = Explicit(
    name="rk4",
    order=4,
    citation="Kutta, Z. Math. Phys. 46 (1901) 435",
    nodes=(0.0, 0.5, 0.5, 1.0, 1.0),
    rows=((0.5,), (0.0, 0.5), (0.0, 0.0, 1.0), (1 / 6, 1 / 3, 1 / 3, 1 / 6)),
    stages=4,
    errors=(),
    dense=(),
    exponent=0,
)
