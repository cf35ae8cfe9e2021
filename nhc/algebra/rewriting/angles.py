"""Sines and cosines of sums of angles, written in those of the terms where that is shorter."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_terms
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count, reachable

_MOST_TERMS = 4

Pair = tuple[Node, Node]
"""Sine and cosine of an angle."""


def split_angles(graph: Graph, nodes: Sequence[Node]) -> list[Node]:
    """The nodes with sin(x + y) and cos(x + y) replaced by what the addition theorems say."""
    g, new = graph, dict[Node, Node]()
    for node in reachable(g, nodes):
        if g.op[node] in ("sin", "cos"):
            terms = list_terms(g, g.a[node])
            if 1 < len(terms) <= _MOST_TERMS:
                s, c = add_angles(g, ((g.function("sin", term), g.function("cos", term)) for term in terms))
                new[node] = s if g.op[node] == "sin" else c
    return substitute(g, nodes, new) if new else list(nodes)


def normalise_angles(graph: Graph, node: Node, limit: int) -> Node:
    """The canonical form in the angles as they stand, or in their terms: the shorter one."""
    whole = normalise(graph, node, limit)
    (expanded,) = split_angles(graph, [node])
    if expanded == node:
        return whole
    apart = normalise(graph, expanded, limit)
    return apart if count(graph, [apart]) < count(graph, [whole]) else whole


def shorter_of_angles(graph: Graph, node: Node, limit: int) -> Node:
    """:func:`normalise_angles` where that is not longer than the node itself, which stands for what would be longer.

    (x - y)^2 + (z - w)^2 multiplied out is not only longer: far from the origin it is the small difference of large terms.
    """
    made = normalise_angles(graph, node, limit)
    return node if count(graph, [node]) < count(graph, [made]) else made


def add_angles(graph: Graph, pairs: Iterable[Pair]) -> Pair:
    """Sine and cosine of the sum of angles from theirs."""
    g = graph
    s, c = g.zero, g.one
    for y, x in pairs:
        s, c = g.add(g.mul(s, x), g.mul(c, y)), g.sub(g.mul(c, x), g.mul(s, y))
    return s, c
