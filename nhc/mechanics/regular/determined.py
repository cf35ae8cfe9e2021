"""Do T and the constraints determine the accelerations?  If not, the spec is refused, with the coordinates that lack inertia."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero, rank
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, quote
from nhc.mechanics.system import System


def check_determined(system: System, mass: Sequence[Sequence[Node]], *, bordered: bool) -> None:
    """The mass matrix (``bordered``: with the constraint rows beside it) must be regular at a generic state.

    Raises:
        nhc.diagnostics.SpecError: E0404 at T.
    """
    g, zero = system.graph, system.graph.zero
    rows = [list(row) for row in mass]
    if bordered:
        rows = [[*row, *(c.coefficients[i] for c in system.constraints)] for i, row in enumerate(rows)]
        rows += [[*c.coefficients, *([zero] * system.l)] for c in system.constraints]
    if rank(g, rows) == len(rows):
        return
    momenta = gradient(g, system.T, system.v)
    bare = [f"{system.q_names[i]}'" for i, p in enumerate(momenta) if all(are_zero(g, gradient(g, p, system.v)))]
    for rotation in system.spec.rotations:
        parts = [f"{name}'" for name in rotation.coordinates]
        if set(parts) <= set(bare):
            bare = [name for name in bare if name not in parts] + list(rotation.velocities)
    what = quote(bare)
    bag = Bag(system.spec.origin)
    bag.error(
        "E0404",
        f"`T` has no second-order part in {what}" if bare else "the mass matrix is singular for every state",
        system.spec.kinetic.span,
        notes=("the accelerations would not be determined by the forces",),
        help=("give each coordinate an inertia, or remove the coordinate",),
    )
    bag.raise_if_errors()
