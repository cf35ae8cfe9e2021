"""Do T and the constraints determine the accelerations?  If not, the spec is refused, with the coordinates that lack inertia."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import are_zero, rank
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, Span, quote
from nhc.mechanics.rotations.turning import moving
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
    bare = list_bare(system)
    what = quote(bare)
    still = [name for name in system.q_names if f"{name}'" in bare and _stands_without_prime(system, name)]
    advice = "give each coordinate an inertia, or remove the coordinate"
    if still:
        rates = quote(f"{name}'" for name in still)
        advice = f"write {rates} where a velocity is meant: `T` contains {quote(still)} without a prime only"
    bag = Bag(system.spec.origin)
    bag.error(
        "E0404",
        f"`T` has no second-order part in {what}" if bare else "the mass matrix is singular for every state",
        _place(system, bare),
        notes=("the accelerations would not be determined by the forces",),
        help=(advice,),
    )
    bag.raise_if_errors()


def _stands_without_prime(system: System, name: str) -> bool:
    """Whether T depends on a coordinate, and not on its velocity: a prime may have been forgotten."""
    g, index = system.graph, system.q_names.index(name)
    return g.depends(system.T, g.deps[system.q[index]]) and not g.depends(system.T, g.deps[system.v[index]])


def warn_of_bare(system: System, bag: Bag) -> None:
    """Say which coordinates have no inertia of their own although the constraints determine their accelerations."""
    bare = list_bare(system) if system.constraints else []
    if bare:
        what = "its acceleration follows" if len(bare) == 1 else "their accelerations follow"
        bag.warning(
            "W0426",
            f"`T` has no second-order part in {quote(bare)}: {what} from the constraints alone",
            _place(system, bare),
            help=(
                f"give {'it an' if len(bare) == 1 else 'them'} inertia in `T`, unless this is meant to have no mass",
            ),
        )


def list_bare(system: System) -> list[str]:
    """The velocities, and the components of angular velocities, in which T has no second-order part."""
    g = system.graph

    def is_bare(momentum: Node) -> bool:
        return all(are_zero(g, gradient(g, momentum, system.v)))

    turning = {i for rotation in system.rotations for i in rotation.places}
    momenta = gradient(g, system.T, system.v)
    bare = [f"{system.q_names[i]}'" for i, p in enumerate(momenta) if i not in turning and is_bare(p)]
    for rotation, declared in zip(system.rotations, system.spec.rotations, strict=True):
        for k, name in enumerate(declared.velocities):
            a, b, c = (g.one if j == k else g.zero for j in range(3))
            rates = rotation.velocities(g, (g.zero, a, b, c))
            x = dict(zip(rotation.places, rates, strict=True))
            turn = moving(system, [x.get(i, g.zero) for i in range(system.n)])
            if is_bare(tangent(g, [system.T], turn)[0]):
                bare.append(name)
    return bare


def _place(system: System, bare: Sequence[str]) -> Span:
    """T; where bodies make it, the coordinate that none of them moves with."""
    spec = system.spec
    lone = [entry.span for entry in spec.coordinates if bare == [f"{entry.name}'"]]
    return lone[0] if lone and spec.bodies else spec.kinetic.span
