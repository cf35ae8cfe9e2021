"""Blocks of a linear system whose rows are orthonormal, but for factors of whole rows: the inverse is the transpose.

Velocities on the axes of a body, as those of an aircraft or an underwater vehicle are given, are such rows: u = R^T x'; and so are
those of a ball that rolls, written along tangents of a surface, with the spin about its normal.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations_with_replacement

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import take_out_common
from nhc.algebra.probe import probe_of
from nhc.algebra.rewriting.angles import normalise_angles

_TERMS = 120
_NEAR = 1e-9
"""How far a product of two rows may be from 0 or 1 at a point, in doubles, to be looked at exactly."""


def solve_orthonormal(
    graph: Graph, block: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]], scale: Callable[[], Node] | None
) -> tuple[list[list[Node]], list[tuple[Node, Node]]] | None:
    """Unknowns and guards, where the rows are orthonormal but for the factors in front of them, whose product the determinant is;
    ``scale`` gives the product of the 1-norms of its whole rows.
    """
    if not _seem_orthogonal(graph, block):
        return None
    short = [[normalise_angles(graph, x, _TERMS) for x in row] for row in block]
    factors, rows = zip(*(take_out_common(graph, row) for row in short), strict=True)
    if not _is_orthonormal(graph, rows):
        return None
    determinant = graph.product(factors)
    if graph.value(determinant) is not None:
        return _solve_transposed(graph, rows, factors, columns), []
    return _solve_transposed(graph, rows, factors, columns), [(determinant, scale() if scale else graph.one)]


def _seem_orthogonal(graph: Graph, block: Sequence[Sequence[Node]]) -> bool:
    """Whether the rows are at right angles at a point."""
    probe = probe_of(graph)
    values = [[probe.value(entry) for entry in row] for row in block]
    for i, first in enumerate(values):
        for second in values[:i]:
            total = sum(x * y for x, y in zip(first, second, strict=True))
            size = sum(abs(x * y) for x, y in zip(first, second, strict=True))
            if not abs(total) <= _NEAR * size:  # nan says no
                return False
    return True


def _is_orthonormal(graph: Graph, block: Sequence[Sequence[Node]]) -> bool:
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


def _solve_transposed(
    graph: Graph, block: Sequence[Sequence[Node]], factors: Sequence[Node], columns: Sequence[Sequence[Node]]
) -> list[list[Node]]:
    """The unknowns for each right side, of orthonormal rows with factors in front."""
    g = graph
    bare = [[g.div(x, factor) for x, factor in zip(column, factors, strict=True)] for column in columns]
    return [[g.dot(lines, column) for lines in zip(*block, strict=True)] for column in bare]
