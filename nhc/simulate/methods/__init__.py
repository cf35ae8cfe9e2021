"""The methods by name."""

from __future__ import annotations

from nhc.simulate.methods import dop853, dopri5, gauss4, gauss6, midpoint, radau5, rk4
from nhc.simulate.methods.dla import LagrangeDAlembert
from nhc.simulate.methods.energy import EnergyPreserving
from nhc.simulate.methods.leapfrog import Leapfrog
from nhc.simulate.methods.natural import Scheme
from nhc.simulate.methods.perlmutter import Perlmutter
from nhc.simulate.methods.tableau import Tableau

RUNGE_KUTTA: dict[str, Tableau] = {
    module.METHOD.name: module.METHOD for module in (dop853, dopri5, rk4, radau5, gauss4, gauss6, midpoint)
}
STRUCTURE: dict[str, Scheme] = {
    scheme.name: scheme for scheme in (Leapfrog(), LagrangeDAlembert(), Perlmutter(), EnergyPreserving())
}
METHODS = (*RUNGE_KUTTA, *STRUCTURE)
DEFAULT = "dop853"


def is_adaptive(name: str) -> bool:
    """Whether a method chooses its steps by a tolerance."""
    return name in RUNGE_KUTTA and RUNGE_KUTTA[name].adaptive
