"""Shorter equal expressions for a set of nodes: canonical polynomials where they cost less, judged on the shared graph."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import count
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise_all

_TERMS = 40
"""Terms of a canonical polynomial that may still be shorter than what it came from."""

_SWOLLEN = 2000
"""Terms before any of them cancel, beyond which none is tried either."""
_LARGE = 1500
"""Operations beyond which no canonical form is tried: it would cost time and find nothing."""


def shorten(graph: Graph, nodes: Sequence[Node]) -> list[Node]:
    """Equal nodes, cheaper together where canonical forms help."""
    before = count(graph, nodes)
    if before == 0 or before > _LARGE:
        return list(nodes)
    canonical = normalise_all(graph, nodes, _TERMS, _SWOLLEN)
    return canonical if count(graph, canonical) < before else list(nodes)
