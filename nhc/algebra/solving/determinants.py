"""What tells that a block which was eliminated is singular: its determinant, for its pivots do not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.blocks import Matrix, determinant_of, without_sign
from nhc.algebra.solving.sizes import row_scale

_WRITTEN_OUT = 7  # rows of a determinant that is watched: its pivots' product has no value where one of them vanishes


def in_determinants(
    graph: Graph, guards: Sequence[tuple[Node, Node]], blocks: Mapping[Node, Matrix]
) -> list[tuple[Node, Node]]:
    """(quantity, scale) pairs with the determinants of ``blocks`` in place of their pivots: zero where a block is singular."""
    found = dict[tuple[Node, Node], None]()
    for value, scale in guards:
        block = blocks.get(without_sign(graph, value))
        if block is None:
            found[value, scale] = None
            continue
        pivots = [x for x, _ in guards if blocks.get(without_sign(graph, x)) == block]
        whole = determinant_of(graph, block) if len(block) <= _WRITTEN_OUT else graph.product(pivots)
        found[whole, row_scale(graph, block)] = None
    return list(found)
