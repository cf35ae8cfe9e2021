"""How the rates are solved for: by the dense L D L^T, or from the leaves of a tree to its root."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from nhc.algebra.calculus import substitute
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.shorten import shorten
from nhc.mechanics.associate import Equations
from nhc.mechanics.system import Form
from nhc.mechanics.trees import FEW
from nhc.program.plan import Factors, factor, solve_factored
from nhc.records import fresh, structure

if TYPE_CHECKING:
    from nhc.mechanics.trees.tree import Elimination


@structure
class MassRoute:
    """``values`` of the rates; (pivot, scale) pairs that must not vanish; a tree's results get ``put_in`` put into them.

    ``held``: those of the reactions' matrix of a held tree, which tell how many digits are left.
    """

    graph: Graph
    equations: Equations
    values: list[Node]
    pivots: list[tuple[Node, Node]]
    tree: Elimination | None = None
    put_in: Mapping[Node, Node] = fresh(factory=dict)
    held: list[tuple[Node, Node]] = fresh(factory=list)
    _factors: Factors | None = None

    def solve(self, right: Sequence[Node]) -> list[Node]:
        """x with mass @ x = right."""
        if self.tree is not None:
            return substitute(self.graph, self.tree.solve(right), self.put_in)
        if self._factors is None:
            self._factors = factor(self.graph, self.equations.mass)
        return solve_factored(self.graph, self._factors, right)


def mass_route(equations: Equations, full: Equations, put_in: Mapping[Node, Node], kept: Sequence[Form]) -> MassRoute:
    """The cheapest way; ``full`` are the equations before ``put_in`` was put into them: a tree is read from these.

    ``kept`` are the forms whose values the velocities w are.
    """
    g, size = equations.system.graph, len(equations.motion.w)
    if full.tree is not None:
        return _along(equations, full.tree.rates, full.tree.pivots, put_in, full.tree)
    found = [_dense(equations)]
    tree = _other_tree(full)
    if tree is not None:
        found.append(_along(equations, tree.rates, tree.pivots, put_in, tree))
    held = _along_held(equations, full, put_in, kept)
    if held is not None:
        found.append(held)
    if len(found) == 1:
        return found[0]
    from nhc.mechanics.trees.choice import CHAINED, work

    return min(found, key=lambda way: work(g, way.values) + (0 if way is found[0] else CHAINED * size))


def _along_held(
    equations: Equations, full: Equations, put_in: Mapping[Node, Node], kept: Sequence[Form]
) -> MassRoute | None:
    """By a tree that constraints hold, where there are few of them."""
    if not 0 < 2 * full.system.l <= len(full.motion.w) or len(full.motion.w) <= FEW:
        return None
    from nhc.program.held_tree import held_tree

    held = held_tree(full, kept)
    if held is None:
        return None
    way = _along(equations, held.rates, [*held.pivots, *held.held], put_in)
    way.pivots, way.held = way.pivots[: len(held.pivots)], way.pivots[len(held.pivots) :]
    return way


def _along(
    equations: Equations,
    rates: Sequence[Node],
    pivots: Sequence[tuple[Node, Node]],
    put_in: Mapping[Node, Node],
    tree: Elimination | None = None,
) -> MassRoute:
    g = equations.system.graph
    flat = substitute(g, [node for pair in pivots for node in pair], put_in)
    values = substitute(g, rates, put_in)
    return MassRoute(g, equations, values, list(zip(flat[::2], flat[1::2], strict=True)), tree, put_in)


def _other_tree(equations: Equations) -> Elimination | None:
    """A tree that was not surely worth it, or under constraints that leave many rates: it is held against the dense way."""
    size, motion = len(equations.motion.w), equations.motion
    if size < 2 or (size <= FEW and motion.velocities != motion.w):
        return None
    from nhc.mechanics.trees.choice import tree_of
    from nhc.mechanics.whole_forms import whole_kinetic

    kinetic = whole_kinetic(equations.system)
    return tree_of(equations.system, motion, kinetic) if kinetic is not None else None


def _dense(equations: Equations) -> MassRoute:
    g = equations.system.graph
    factors = factor(g, equations.mass)
    values = shorten(g, solve_factored(g, factors, equations.force))
    pivots = [(pivot, equations.mass[k][k]) for k, pivot in zip(factors.order, factors.pivots, strict=True)]
    return MassRoute(g, equations, values, pivots, None, {}, _factors=factors)
