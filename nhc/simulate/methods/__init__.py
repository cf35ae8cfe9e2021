"""The methods by name."""

from __future__ import annotations

from nhc.simulate.methods import dop853, dopri5, gauss4, gauss6, radau5, rk4
from nhc.simulate.methods.tableau import Tableau

RUNGE_KUTTA: dict[str, Tableau] = {
    module.METHOD.name: module.METHOD for module in (dop853, dopri5, rk4, gauss4, gauss6, radau5)
}
DEFAULT = "dop853"
