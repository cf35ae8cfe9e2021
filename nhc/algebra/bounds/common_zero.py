"""A point where several expressions vanish at once, by damped least squares from given points.

K. Levenberg, A method for the solution of certain non-linear problems in least squares, Quart. Appl. Math. 2 (1944), 164-168.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from operator import mul

from nhc.algebra.calculus import reachable, tangent
from nhc.algebra.dense import Singular, solve_double
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node

_STEPS, _TRIES = 40, 8
_LARGE = 30_000  # nodes of the expressions and their derivatives
_SMALL = 1e-11  # of the size that the expressions have at the given points
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
    flat = [*roots, *(x for s in moving for x in tangent(g, roots, {s: g.one}))]
    if len(reachable(g, flat)) > _LARGE:
        return None
    starts = [dict(point) for point in points[:_TRIES]]
    values = [found for found in (_values(g, roots, point) for point in starts) if found is not None]
    sizes = [sorted(abs(row[k]) for row in values)[len(values) // 2] for k in range(len(roots))] if values else []
    largest = max(sizes, default=0.0)
    scales = [size or largest or 1.0 for size in sizes]
    for start in starts:
        found = _descend(g, flat, moving, start, scales) if scales else None
        if found is not None:
            return found
    return None


def _values(graph: Graph, nodes: Sequence[Node], point: Mapping[Node, float]) -> list[float] | None:
    try:
        found = [float(x) for x in evaluate(graph, nodes, dict(point))]
    except (ArithmeticError, ValueError, TypeError):
        return None
    return found if all(map(math.isfinite, found)) else None


def _descend(
    graph: Graph, flat: Sequence[Node], moving: Sequence[Node], start: Point, scales: Sequence[float]
) -> Point | None:
    count, damping, point, moved = len(scales), 1e-3, start, math.inf
    values = _values(graph, flat, point)
    for _ in range(_STEPS):
        if values is None:
            return None
        rest = [x / scale for x, scale in zip(values[:count], scales, strict=True)]
        off = max(map(abs, rest))
        if off == 0.0 or (off < _SMALL and moved < _NEAR):
            return point
        slopes = [
            [x / scale for x, scale in zip(values[k : k + count], scales, strict=True)]
            for k in range(count, len(values), count)
        ]
        step = _step(slopes, rest, damping)
        if step is None:
            return None
        tried = {**point, **{s: point[s] + d for s, d in zip(moving, step, strict=True)}}
        new = _values(graph, flat, tried)
        if new is not None and _squares(new, scales) < _squares(values, scales):
            point, values, damping, moved = tried, new, damping / 8, max(map(abs, step))
        else:
            damping *= 5
    return None


def _squares(values: Sequence[float], scales: Sequence[float]) -> float:
    return math.fsum((x / scale) ** 2 for x, scale in zip(values, scales, strict=False))


def _step(slopes: Sequence[Sequence[float]], rest: Sequence[float], damping: float) -> list[float] | None:
    """-(J^T J + damping)^-1 J^T rest; ``slopes`` are the columns of J."""
    normal = [[sum(map(mul, a, b)) for b in slopes] for a in slopes]
    size = max(row[k] for k, row in enumerate(normal)) or 1.0
    for k, row in enumerate(normal):
        row[k] += damping * size
    try:
        return solve_double(normal, [-sum(map(mul, a, rest)) for a in slopes])
    except (Singular, ArithmeticError):
        return None
