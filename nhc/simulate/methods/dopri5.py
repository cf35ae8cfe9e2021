"""DOPRI5: order 5 with an embedded estimate of order 4 and an interpolant of order 4.

J. R. Dormand and P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19-26;
the interpolant is that of E. Hairer, S. P. Nørsett and G. Wanner, Solving Ordinary Differential Equations I, 2nd
ed. (1993), sec. II.6.
"""

from __future__ import annotations

from nhc.simulate.methods.tableau import Explicit

_ADVANCE = (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84)

METHOD = Explicit(
    name="dopri5",
    order=5,
    citation="Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19",
    nodes=(0.0, 0.2, 0.3, 0.8, 8 / 9, 1.0, 1.0),
    rows=(
        (0.2,),
        (3 / 40, 9 / 40),
        (44 / 45, -56 / 15, 32 / 9),
        (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
        (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
        _ADVANCE,
    ),
    stages=6,
    errors=((71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40),),
    dense=(
        (
            -12715105075 / 11282082432,
            0.0,
            87487479700 / 32700410799,
            -10690763975 / 1880347072,
            701980252875 / 199316789632,
            -1453857185 / 822651844,
            69997945 / 29380423,
        ),
    ),
    exponent=5,
)
