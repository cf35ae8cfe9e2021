"""What to cite: the spec's own sources, and those of the formulation."""

from __future__ import annotations

from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.system import System

THESIS = (
    "A. Vigneront, Formes extérieures en mécanique des systèmes non holonomes, "
    "mémoire, Facultés universitaires Notre-Dame de la Paix, Namur, 1977"
)
GALLISSOT = "F. Gallissot, Les formes extérieures en mécanique, Annales de l'Institut Fourier 4 (1952) 145-297"
_SOURCES = {
    "newton": (),
    "lagrange": ("J.-L. Lagrange, Mécanique analytique, 1788",),
    "multipliers": ("J.-L. Lagrange, Mécanique analytique, 1788",),
    "euler-lagrange": (
        "H. Poincaré, Sur une forme nouvelle des équations de la mécanique, C. R. Acad. Sci. Paris 132 (1901) 369-371",
        "G. Hamel, Die Lagrange-Eulerschen Gleichungen der Mechanik, Z. Math. Phys. 50 (1904) 1-57",
    ),
    "chaplygin": (
        "S. A. Čaplygin (Chaplygin), On a motion of a heavy body of revolution on a horizontal plane (1897), "
        "reprinted in Regular and Chaotic Dynamics 7 (2002) 119-130",
    ),
    "voronec": (
        "P. V. Voronec (Voronets), On the equations of motion of nonholonomic systems, Matematicheskii Sbornik 22 (1901) 659-686",
    ),
}
_BOOK = "Ju. I. Neimark, N. A. Fufaev, Dynamics of Nonholonomic Systems, AMS, Providence, 1972"


def citation(system: System, formulation: Formulation) -> str:
    """A short bibliography, one entry a line."""
    lines = [f"{system.name}: {source}" for source in system.spec.sources]
    lines += [f"{formulation.name} ({formulation.number}): {source}" for source in _SOURCES[formulation.name]]
    lines.append(f"2-form Omega and its associated equations: {THESIS}")
    lines.append(f"2-form Omega and its associated equations: {GALLISSOT}")
    if system.constraints:
        lines.append(f"nonholonomic systems: {_BOOK}")
    return "\n".join(lines) + "\n"
