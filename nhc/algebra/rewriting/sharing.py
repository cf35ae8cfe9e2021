"""Products and sums that longer ones have in common, made once: the nodes over the pairs of
:mod:`nhc.algebra.rewriting.products` and :mod:`nhc.algebra.rewriting.sums`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import rebuild_over
from nhc.algebra.rewriting.products import share_factors
from nhc.algebra.rewriting.sums import share_terms
from nhc.algebra.walks import reachable


def share_parts(graph: Graph, roots: Sequence[Node], constants: int) -> list[Node]:
    """Equal roots in which products share more of their factors, and sums of their terms.

    A product has the factors that contain ``constants`` (a mask) alone first; a product of these stays whole.
    """
    nodes = reachable(graph, roots)
    kids, uses = graph.kids, dict.fromkeys(nodes, 0)
    for root in roots:
        uses[root] += 1
    for node in nodes:
        for child in kids[node]:
            uses[child] += 1
    building = _Building(graph, nodes, uses, constants)
    return building.replace(nodes, roots) if building.products or building.sums else list(roots)


class _Building:
    """The products and sums that share, each over its pairs."""

    def __init__(self, graph: Graph, nodes: Sequence[Node], uses: dict[Node, int], constants: int) -> None:
        self.graph, self._moves = graph, ~constants
        self.products, inner_products, self._factor_pairs = share_factors(graph, nodes, uses, constants)
        self.sums, inner_sums, self._term_pairs = share_terms(graph, nodes, uses)
        self._inner = inner_products | inner_sums
        self._new: dict[Node, Node] = {}
        self._made_factors: dict[int, Node] = {}
        self._made_terms: dict[int, Node] = {}

    def replace(self, nodes: Iterable[Node], roots: Iterable[Node]) -> list[Node]:
        """The roots over all that the nodes have become."""
        new, inner, products, sums, kids = self._new, self._inner, self.products, self.sums, self.graph.kids
        for node in nodes:
            if node in inner or node in new:
                continue
            if node in products or node in sums:
                self._make(node)
                continue
            for kid in kids[node]:
                if new[kid] != kid:
                    self._make(node)
                    break
            else:
                new[node] = node
        return [new[root] for root in roots]

    def _make(self, node: Node) -> Node:
        graph, new = self.graph, self._new
        if node in new:
            return new[node]
        if node in self.products:
            new[node] = self._multiply([new[f] if f in new else self._factor(f) for f in self.products[node]])
        elif node in self.sums:
            terms = [(self._term(term), sign) for term, sign in self.sums[node].items()]
            new[node] = graph.sum([term if sign > 0 else graph.neg(term) for term, sign in terms])
        else:
            over = rebuild_over(graph, node, new)
            new[node] = node if over is None else over
        if node in graph.labels:
            graph.pass_label(node, new[node])
        return new[node]

    def _multiply(self, factors: Sequence[Node]) -> Node:
        graph, deps, moves = self.graph, self.graph.deps, self._moves
        fixed = graph.product([x for x in factors if not deps[x] & moves])
        return graph.mul(fixed, graph.product([x for x in factors if deps[x] & moves]))

    def _factor(self, factor: int) -> Node:
        """A factor of a product, or a pair of them."""
        if factor >= 0:
            return self._make(factor)
        made = self._made_factors
        if factor not in made:
            first, second = self._factor_pairs[-1 - factor]
            made[factor] = self.graph.mul(self._factor(first), self._factor(second))
        return made[factor]

    def _term(self, term: int) -> Node:
        """A term of a sum, or a pair of them."""
        if term >= 0:
            return self._make(term)
        made = self._made_terms
        if term not in made:
            first, second, sign = self._term_pairs[-1 - term]
            a, b = self._term(first), self._term(second)
            made[term] = self.graph.add(a, b) if sign > 0 else self.graph.sub(a, b)
        return made[term]
