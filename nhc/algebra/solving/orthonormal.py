"""Blocks of a linear system whose rows are orthonormal: the inverse is the transpose.

Velocities on the axes of a body, as those of an aircraft or an underwater vehicle are given, are such rows: u = R^T x'.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import probe_of

_NEAR = 1e-9
"""How far a product of two rows may be from 0 or 1 at a point, in doubles, to be looked at exactly."""


def is_orthonormal(graph: Graph, block: Sequence[Sequence[Node]]) -> bool:
    """Whether the rows are orthonormal for all values of their symbols."""
    g, probe = graph, probe_of(graph)
    values = [[probe.value(entry) for entry in row] for row in block]
    pairs = list(combinations_with_replacement(range(len(block)), 2))
    for i, j in pairs:
        total = sum(x * y for x, y in zip(values[i], values[j], strict=True))
        if not abs(total - (i == j)) <= _NEAR:  # nan says no
            return False
    dots = (g.dot(block[i], block[j]) for i, j in pairs)
    return all(are_zero(g, [g.sub(dot, g.one) if i == j else dot for dot, (i, j) in zip(dots, pairs, strict=True)]))


def solve_transposed(
    graph: Graph, block: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]]
) -> list[list[Node]]:
    """The unknowns for each right side, of orthonormal rows."""
    return [[graph.dot(lines, column) for lines in zip(*block, strict=True)] for column in columns]
