"""Angles of which only sums and differences occur: cos(a) cos(b) + sin(a) sin(b) as cos(a - b), where that leaves fewer angles."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.joined import join_sums
from nhc.algebra.rewriting.related import count_angles
from nhc.algebra.walks import count

_MOST = 12
"""Angles beyond which nothing is joined."""


def join_angles(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots with fewer angles whose sines and cosines have to be called; the roots themselves where there are none."""
    if "joined angles" in graph.off:
        return list(roots)
    called = count_angles(graph, roots)[0]
    if not 2 <= called <= _MOST:
        return list(roots)
    joined = join_sums(graph, roots)
    fewer = count_angles(graph, joined)[0] < called
    return joined if fewer and count(graph, joined) <= count(graph, roots) else list(roots)
