"""A point where several expressions vanish at once, by damped least squares from given points.

K. Levenberg, A method for the solution of certain non-linear problems in least squares, Quart. Appl. Math. 2 (1944), 164-168.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Singular, solve_positive
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.sizes import size_of
from nhc.algebra.walks import reachable

_STEPS, _TRIES = 40, 8
_LARGE = 30_000  # nodes of the expressions and their derivatives
_SMALL = 1e-11  # of the size that the expressions have at the given points
_PART = 1e-3
_NEAR = 1e-3  # of a coordinate: steps that do not end belong to what only tends to zero

Point = dict[Node, float]


def find_common_zero(
    graph: Graph, roots: Sequence[Node], symbols: Sequence[Node], points: Sequence[Mapping[Node, float]]
) -> Point | None:
    """Values of the symbols at which all roots are zero to rounding; None where no search from the points found any."""
    g = graph
    moving = [s for s in symbols if any(g.depends(root, g.deps[s]) for root in roots)]
    if not moving:
        return None
    search = _Search(g, roots, moving)
    if len(reachable(g, search.flat)) > _LARGE:
        return None
    starts = [dict(point) for point in points[:_TRIES]]
    scales = _scales(g, roots, starts)
    for start in starts:
        found = search.descend(start, scales) if scales else None
        if found is not None:
            return found
    return None


def _scales(graph: Graph, roots: Sequence[Node], points: Sequence[Point]) -> list[float]:
    """How large each root is at the points, in the middle; at least a part of its terms, for a point may be next to a zero."""
    terms = [size_of(graph, root) for root in roots]
    values = [found for found in (_values(graph, [*roots, *terms], point) for point in points) if found is not None]
    middle = [sorted(map(abs, column))[len(values) // 2] for column in zip(*values, strict=True)]
    sizes = [max(x, _PART * y) for x, y in zip(middle, middle[len(roots) :], strict=False)]
    largest = max(sizes, default=0.0)
    return [size or largest or 1.0 for size in sizes]


def _values(graph: Graph, nodes: Sequence[Node], point: Mapping[Node, float]) -> list[float] | None:
    try:
        found = [float(x) for x in evaluate(graph, nodes, dict(point))]
    except (ArithmeticError, ValueError, TypeError):
        return None
    return found if all(map(math.isfinite, found)) else None


class _Search:
    """Expressions and their slopes that do not vanish identically, all in ``flat``, with the places of these."""

    def __init__(self, graph: Graph, roots: Sequence[Node], moving: Sequence[Node]) -> None:
        self.graph, self.moving, self.count = graph, moving, len(roots)
        columns = [tangent(graph, roots, {s: graph.one}) for s in moving]
        entries = [(j, k, x) for j, column in enumerate(columns) for k, x in enumerate(column) if x != graph.zero]
        self.flat = [*roots, *(x for _, _, x in entries)]
        self.places = [(j, k) for j, k, _ in entries]

    def descend(self, start: Point, scales: Sequence[float]) -> Point | None:
        """A common zero, by steps from a point; None where they do not lead to any."""
        graph, flat, count = self.graph, self.flat, self.count
        damping, point, moved = 1e-3, start, math.inf
        values = _values(graph, flat, point)
        for _ in range(_STEPS):
            if values is None:
                return None
            rest = [x / scale for x, scale in zip(values[:count], scales, strict=True)]
            off = max(map(abs, rest))
            if off == 0.0 or (off < _SMALL and moved < _NEAR):
                return point
            slopes: list[dict[int, float]] = [{} for _ in self.moving]
            for (j, k), x in zip(self.places, values[count:], strict=True):
                slopes[j][k] = x / scales[k]
            step = _step(slopes, rest, damping)
            if step is None:
                return None
            tried = {**point, **{s: point[s] + d for s, d in zip(self.moving, step, strict=True)}}
            new = _values(graph, flat, tried)
            if new is not None and _squares(new, scales) < _squares(values, scales):
                point, values, damping, moved = tried, new, damping / 8, max(map(abs, step))
            else:
                damping *= 5
        return None


def _squares(values: Sequence[float], scales: Sequence[float]) -> float:
    return math.fsum((x / scale) ** 2 for x, scale in zip(values, scales, strict=False))


def _step(slopes: Sequence[dict[int, float]], rest: Sequence[float], damping: float) -> list[float] | None:
    """-(J^T J + damping)^-1 J^T rest, or the same as -J^T (J J^T + damping)^-1 rest; ``slopes`` are the columns of J."""
    rows: list[dict[int, float]] = [{} for _ in rest]
    for j, column in enumerate(slopes):
        for k, x in column.items():
            rows[k][j] = x
    size = damping * (max(sum(x * x for x in column.values()) for column in slopes) or 1.0)
    try:
        if len(rows) < len(slopes):
            weights = solve_positive(_products(slopes, len(rows), size), rest)
            return [-sum(x * weights[k] for k, x in column.items()) for column in slopes]
        right = [-sum(x * rest[k] for k, x in column.items()) for column in slopes]
        return solve_positive(_products(rows, len(slopes), size), right)
    except (Singular, ArithmeticError):
        return None


def _products(vectors: Sequence[dict[int, float]], size: int, added: float) -> list[dict[int, float]]:
    """The sum of the vectors' products with themselves, row by row, with what is added to its diagonal."""
    found = [{k: added} for k in range(size)]
    for vector in vectors:
        for i, x in vector.items():
            row = found[i]
            for j, y in vector.items():
                row[j] = row.get(j, 0.0) + x * y
    return found
