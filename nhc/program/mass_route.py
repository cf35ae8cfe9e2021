"""How the rates are solved for: by the dense L D L^T, or from the leaves of a tree to its root."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from nhc.algebra.calculus import count, substitute
from nhc.algebra.graph import Graph, Node
from nhc.algebra.shorten import shorten
from nhc.mechanics.associate import Equations
from nhc.mechanics.chain import find_chain
from nhc.mechanics.chain_forces import lift_forces
from nhc.program.plan import Factors, factor, solve_factored
from nhc.program.tree_plan import Elimination

_CHAINED = 8  # operations that the longer way from pivot to pivot of a tree is worth
_FEW = 3  # rates up to which both ways are written out and compared


@dataclass
class MassRoute:
    """``values`` of the rates; (pivot, scale) pairs that must not vanish; a tree's results get ``put_in`` put into them."""

    graph: Graph
    equations: Equations
    values: list[Node]
    pivots: list[tuple[Node, Node]]
    tree: Elimination | None = None
    put_in: Mapping[Node, Node] = field(default_factory=dict)
    _factors: Factors | None = None

    def solve(self, right: Sequence[Node]) -> list[Node]:
        """x with mass @ x = right."""
        if self.tree is not None:
            return substitute(self.graph, self.tree.solve(right), self.put_in)
        if self._factors is None:
            self._factors = factor(self.graph, self.equations.mass)
        return solve_factored(self.graph, self._factors, right)


def mass_route(equations: Equations, full: Equations, put_in: Mapping[Node, Node]) -> MassRoute:
    """The cheaper way; ``full`` are the equations before ``put_in`` was put into them: a tree is read from these."""
    tree = _tree_of(full)
    size = len(equations.mass)
    dense = _dense(equations) if tree is None or size <= _FEW else None
    if tree is None:
        assert dense is not None
        return dense
    g = equations.system.graph
    values = substitute(g, tree.rates(), put_in)
    other = count(g, dense.values) if dense is not None else _dense_cost(equations)
    if count(g, values) + _CHAINED * size >= other:
        return dense if dense is not None else _dense(equations)
    flat = substitute(g, [node for _, *pair in tree.pivots for node in pair], put_in)
    return MassRoute(g, equations, values, list(zip(flat[::2], flat[1::2], strict=True)), tree, put_in)


def _tree_of(equations: Equations) -> Elimination | None:
    size, motion = len(equations.motion.w), equations.motion
    if "trees" in equations.system.graph.off:
        return None
    if size < 2 or (size <= _FEW and motion.velocities != motion.w):
        return None
    chain = find_chain(equations.system, motion)
    return Elimination(lift_forces(chain)) if chain is not None else None


def _dense(equations: Equations) -> MassRoute:
    g = equations.system.graph
    factors = factor(g, equations.mass)
    values = shorten(g, solve_factored(g, factors, equations.force))
    pivots = [(pivot, equations.mass[k][k]) for k, pivot in enumerate(factors.pivots)]
    return MassRoute(g, equations, values, pivots, None, {}, factors)


def _dense_cost(equations: Equations) -> int:
    """Operations of the matrix, the right side and L D L^T, by the matrix's pattern."""
    g, size = equations.system.graph, len(equations.mass)
    rows = [{j for j in range(size) if equations.mass[i][j] != g.zero} for i in range(size)]
    total = 0
    for k in range(size):
        below = sorted(j for j in rows[k] if j > k)
        total += 1 + 5 * len(below) + len(below) * (len(below) + 1)
        for i in below:
            rows[i].update(below)
    return total + count(g, [*(entry for row in equations.mass for entry in row), *equations.force])
