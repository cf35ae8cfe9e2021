"""MIDPOINT: the implicit midpoint rule, Gauss's method with one point, order 2, symmetric and symplectic, with fixed steps.

On the reduced state (coordinates and free velocities) it keeps the constraints exactly; as an integrator of nonholonomic systems
it is compared in K. Modin and O. Verdier, What makes nonholonomic integrators work?, Numer. Math. 145 (2020) 405-435.
"""

from __future__ import annotations

from nhc.simulate.methods.tableau import Collocation

METHOD = Collocation(
    name="midpoint",
    order=2,
    citation="Modin and Verdier, Numer. Math. 145 (2020) 405",
    nodes=(0.5,),
    rows=((0.5,),),
    advance=(1.0,),
    errors=(),
    pole=0.0,
    exponent=0,
)
