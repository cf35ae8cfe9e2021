"""GAUSS6: collocation at the three points of Gauss, order 6, symmetric and symplectic, with fixed steps.

J. C. Butcher, Implicit Runge-Kutta processes, Math. Comp. 18 (1964) 50-64; E. Hairer, C. Lubich and G. Wanner, Geometric Numerical
Integration, 2nd ed. (2006), sec. II.1.3.
"""

from __future__ import annotations

from math import sqrt

from nhc.simulate.methods.tableau import Collocation

_R = sqrt(15.0)

METHOD = Collocation(
    name="gauss6",
    order=6,
    citation="Butcher, Math. Comp. 18 (1964) 50",
    nodes=(0.5 - _R / 10, 0.5, 0.5 + _R / 10),
    rows=(
        (5 / 36, 2 / 9 - _R / 15, 5 / 36 - _R / 30),
        (5 / 36 + _R / 24, 2 / 9, 5 / 36 - _R / 24),
        (5 / 36 + _R / 30, 2 / 9 + _R / 15, 5 / 36),
    ),
    advance=(5 / 18, 4 / 9, 5 / 18),
    errors=(),
    pole=0.0,
    exponent=0,
)
