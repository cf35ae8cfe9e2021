"""RADAU5: Radau IIA collocation at three points, order 5, for stiff equations, with the emitted Jacobian and
adaptive steps.

E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), sec. IV.5 (coefficients), IV.8
(error estimate).
"""

from __future__ import annotations

from math import sqrt

from nhc.simulate.methods.tableau import Collocation

_R = sqrt(6.0)
_LAST = ((16 - _R) / 36, (16 + _R) / 36, 1 / 9)

METHOD = Collocation(
    name="radau5",
    order=5,
    citation="Hairer and Wanner (1996), sec. IV.8",
    nodes=((4 - _R) / 10, (4 + _R) / 10, 1.0),
    rows=(
        ((88 - 7 * _R) / 360, (296 - 169 * _R) / 1800, (-2 + 3 * _R) / 225),
        ((296 + 169 * _R) / 1800, (88 + 7 * _R) / 360, (-2 - 3 * _R) / 225),
        _LAST,
    ),
    advance=_LAST,
    errors=(-(13 + 7 * _R) / 3, (-13 + 7 * _R) / 3, -1 / 3),
    pole=30 / (6 + 81 ** (1 / 3) - 9 ** (1 / 3)),
    exponent=4,
)
