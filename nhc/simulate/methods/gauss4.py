"""GAUSS4: collocation at the two points of Gauss, order 4, symmetric and symplectic, with fixed steps.

J. C. Butcher, Implicit Runge-Kutta processes, Math. Comp. 18 (1964) 50-64; E. Hairer, C. Lubich and G. Wanner, Geometric Numerical
Integration, 2nd ed. (2006), sec. II.1.3.
"""

from __future__ import annotations

from math import sqrt

from nhc.simulate.methods.tableau import Collocation

_R = sqrt(3.0)

METHOD = Collocation(
    name="gauss4",
    order=4,
    citation="Butcher, Math. Comp. 18 (1964) 50",
    nodes=(0.5 - _R / 6, 0.5 + _R / 6),
    rows=((0.25, 0.25 - _R / 6), (0.25 + _R / 6, 0.25)),
    advance=(0.5, 0.5),
    errors=(),
    pole=0.0,
    exponent=0,
)
