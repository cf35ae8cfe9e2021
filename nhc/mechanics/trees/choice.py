"""Whether a system is solved from the leaves of a tree: decided from the tree, before any matrix is assembled."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import count, reachable
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.kinetic import Kinetic
from nhc.mechanics.motion import Motion
from nhc.mechanics.system import System
from nhc.mechanics.trees.bodies import read_bodies
from nhc.mechanics.trees.chain import Chain, find_chain
from nhc.mechanics.trees.forces import lift_forces
from nhc.mechanics.trees.tree import Elimination

CHAINED = 4
"""Operations that the longer way from pivot to pivot of a tree is worth."""
ANGLE = 30
"""Operations that a sine with its cosine takes the time of."""
FEW = 3
"""Rates up to which both ways are written out and compared."""
_BOTH = 12
"""Rates up to which two recursions are both solved; beyond, the one that starts from less is."""
_SHORT = 30
"""Operations for each rate from which the elimination starts, up to which no other recursion is looked for."""
_ENTRY, _CARRIED = 8, 4
"""Operations for an entry of the mass matrix with its share of the forces, and for a rate in a form that holds it by another,
beside those of the coefficients and of the forces on the rates, which both ways have."""


def work(graph: Graph, nodes: Sequence[Node]) -> int:
    """Operations of the nodes; a sine and cosine of one angle are as many as ``ANGLE``."""
    return count(graph, nodes) + ANGLE * _angles(graph, nodes)


def _angles(graph: Graph, nodes: Sequence[Node]) -> int:
    return len({graph.a[node] for node in reachable(graph, nodes) if graph.op[node] in ("sin", "cos")})


def tree_of(system: System, motion: Motion, kinetic: Kinetic, beside: Sequence[Node] = ()) -> Elimination | None:
    """The elimination along the tree; None where there is no recursion, or a pivot vanishes identically.

    Bodies that turn in space by angles have two: of T's forms as they are written, and of the bodies.
    """
    written = find_chain(system, motion, kinetic)
    bodies = _chain_of_bodies(system, motion, written)
    if bodies is not None and written is not None and system.n > _BOTH:
        return _eliminate(min(written, bodies, key=_setting), beside)
    return _shorter(_eliminate(written, beside), _eliminate(bodies, beside))


def _chain_of_bodies(system: System, motion: Motion, written: Chain | None) -> Chain | None:
    """The recursion of bodies in space; None where there is none, or the one of T's forms starts from little."""
    if motion.velocities != system.v or motion.w != system.v:
        return None
    if written is not None and _setting(written) <= _SHORT * system.n:
        return None
    spatial = read_bodies(system)
    return find_chain(system, motion, spatial.kinetic, spatial) if spatial is not None else None


def _shorter(one: Elimination | None, other: Elimination | None) -> Elimination | None:
    if one is None or other is None:
        return one or other
    return min((one, other), key=lambda tree: work(tree.graph, tree.rates))


def _setting(chain: Chain) -> int:
    """Operations of what the elimination starts from."""
    coefficients = [a for terms in chain.definitions for a in terms.values()]
    return count(chain.graph, [*coefficients, *chain.turn, *chain.force])


def _eliminate(chain: Chain | None, beside: Sequence[Node]) -> Elimination | None:
    if chain is None:
        return None
    try:
        tree = Elimination(lift_forces(chain), beside)
    except ZeroDivisionError:
        return None
    return None if any(are_zero(tree.graph, [pivot for pivot, _ in tree.pivots])) else tree


def worthwhile_tree(system: System, motion: Motion, kinetic: Kinetic) -> Elimination | None:
    """The elimination along the tree, where it takes fewer operations than the matrix would."""
    if system.n > _BOTH:
        tree = tree_of(system, motion, kinetic)
        return tree if tree is not None and _is_worthwhile(tree, motion) else None
    written = find_chain(system, motion, kinetic)
    tree = _eliminate(written, ())
    if tree is None or not _is_worthwhile(tree, motion):
        return None  # both ways are compared when the other one is written out
    return _shorter(tree, _eliminate(_chain_of_bodies(system, motion, written), ()))


def _is_worthwhile(tree: Elimination, motion: Motion) -> bool:
    return work(tree.graph, tree.rates) + CHAINED * len(motion.w) < dense_cost(tree.chain)


def dense_cost(chain: Chain) -> int:
    """Operations of mass matrix, right side and L D L^T, by the pattern of which rates move the same forms."""
    g, rates = chain.graph, chain.rates
    total = work(g, [*(a for terms in chain.definitions for a in terms.values()), *chain.force])
    reach = [1 << i for i in range(rates)]
    for terms in chain.definitions:
        mask = 0
        for c, a in terms.items():
            mask |= reach[c]
            if c >= rates and g.value(a) is None:
                total += _CARRIED * reach[c].bit_count()
        reach.append(mask)
    rows = [1 << i for i in range(rates)]
    for a, b in chain.weights:
        for i in range(rates):
            if reach[a] >> i & 1:
                rows[i] |= reach[b]
            if reach[b] >> i & 1:
                rows[i] |= reach[a]
    total += _ENTRY * sum((rows[k] >> k).bit_count() for k in range(rates))
    for k in range(rates):
        below = rows[k] >> (k + 1)
        width = below.bit_count()
        total += 1 + 5 * width + width * (width + 1)
        for i in range(k + 1, rates):
            if rows[k] >> i & 1:
                rows[i] |= below << (k + 1)
    return total
