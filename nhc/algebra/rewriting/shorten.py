"""Shorter equal expressions for a set of nodes: canonical polynomials where they cost less, judged on the shared graph."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise_all
from nhc.algebra.rewriting.digits import keep_digits
from nhc.algebra.walks import count

_TERMS = 40
"""Terms of a canonical polynomial that may still be shorter than what it came from."""

_SWOLLEN = 2000
"""Terms before any of them cancel, beyond which none is tried either."""
_LARGE = 1500
"""Operations beyond which no canonical form is tried: it would cost time and find nothing."""


_MIXED = 150
"""Operations up to which each node is chosen on its own."""


def canonical_form(graph: Graph, node: Node) -> Node:
    """The form that :func:`shorten` would try for a node alone, whether or not it is shorter and keeps the digits."""
    if count(graph, [node]) > _LARGE or "canonical forms" in graph.off:
        return node
    return normalise_all(graph, [node], _TERMS, _SWOLLEN)[0]


def shorten(graph: Graph, nodes: Sequence[Node], beside: Sequence[Node] = ()) -> list[Node]:
    """Equal nodes, cheaper together (and with what is computed ``beside`` them) where canonical forms help."""
    before = count(graph, nodes)
    shortest = 0 if beside else 1  # one operation may still be the same as one beside it
    if before <= shortest or before > _LARGE or "canonical forms" in graph.off:
        return list(nodes)
    made = normalise_all(graph, nodes, _TERMS, _SWOLLEN)
    changed = sum(x != y for x, y in zip(nodes, made, strict=True))
    if not changed:
        return made
    total = count(graph, [*nodes, *beside]) if beside else before
    if changed == 1 and count(graph, [*made, *beside]) >= total:
        return list(nodes)  # whatever its digits
    canonical = keep_digits(graph, nodes, made)
    other = count(graph, [*canonical, *beside])
    best, rest = (canonical, list(nodes)) if other < total else (list(nodes), canonical)
    least = min(total, other)
    if before > _MIXED:
        return best
    for k, node in enumerate(rest):
        if node != best[k]:
            trial = [*best[:k], node, *best[k + 1 :]]
            cost = count(graph, [*trial, *beside])
            if cost < least:
                best, least = trial, cost
    return best
