"""Symmetric tensors in space, as inertias are: three rows of three."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Graph, Node
from nhc.mechanics.rotations.turns import Vector

Tensor = tuple[Vector, Vector, Vector]
NONE: Tensor = ((0, 0, 0), (0, 0, 0), (0, 0, 0))


def add_tensors(graph: Graph, x: Tensor, y: Tensor) -> Tensor:
    """x + y."""
    return _symmetric([[graph.add(x[i][j], y[i][j]) for j in range(3)] for i in range(3)])


def add_product(graph: Graph, tensor: Tensor, factor: Node, x: Vector, y: Vector) -> Tensor:
    """tensor + factor (x y^T + y x^T)."""
    g = graph
    rows = [[g.add(g.mul(x[i], y[j]), g.mul(y[i], x[j])) for j in range(3)] for i in range(3)]
    return add_tensors(g, tensor, _symmetric([[g.mul(factor, a) for a in row] for row in rows]))


def move_inertia(graph: Graph, inertia: Tensor, mass: Node, first: Vector, offset: Vector) -> Tensor:
    """About a point from which the origin of a mass with these first moments is ``offset`` (J. Steiner): J + (2 p h + m p p) 1 -
    p h^T - h p^T - m p p^T.
    """
    g, p = graph, offset
    if not any(p):
        return inertia
    # with k = h + m p/2 these are (2 p k) 1 - p k^T - k p^T
    half = g.div(mass, g.number(2))
    k = [g.add(h, g.mul(half, x)) for h, x in zip(first, p, strict=True)]
    twice = [g.mul(g.mul(g.number(2), x), y) for x, y in zip(p, k, strict=True)]
    rows = [list(row) for row in inertia]
    for i in range(3):
        one, two = (i + 1) % 3, (i + 2) % 3
        rows[i][i] = g.add(rows[i][i], g.add(twice[one], twice[two]))
        across = g.add(g.mul(p[i], k[one]), g.mul(k[i], p[one]))
        rows[i][one] = rows[one][i] = g.sub(rows[i][one], across)
    return _symmetric(rows)


def times(graph: Graph, rows: Sequence[Sequence[Node]], x: Sequence[Node]) -> Vector:
    """The rows times a vector."""
    a, b, c = (graph.dot(row, x) for row in rows)
    return a, b, c


def turn_tensor(graph: Graph, matrix: Sequence[Vector], tensor: Tensor) -> Tensor:
    """R J R^T; for a turn about one of the axes with ten operations in its plane and six beside it."""
    axis = next((k for k in range(3) if _is_about(graph, matrix, k)), None)
    if axis is None:
        half = [times(graph, tensor, row) for row in matrix]  # rows of (J R^T)^T
        return _symmetric([[graph.dot(row, other) for other in half] for row in matrix])
    g, i, j = graph, (axis + 1) % 3, (axis + 2) % 3
    c, s = matrix[i][i], matrix[j][i]
    rows = [list(row) for row in tensor]
    a, b, d = tensor[i][i], tensor[i][j], tensor[j][j]
    if c == g.zero:
        rows[i][i], rows[j][j], rows[i][j] = d, a, g.neg(b)
    elif s != g.zero:
        k = g.sub(g.mul(s, g.sub(d, a)), g.mul(g.mul(g.number(2), c), b))
        rows[i][i], rows[j][j] = g.add(a, g.mul(s, k)), g.sub(d, g.mul(s, k))
        rows[i][j] = g.neg(g.add(g.mul(c, k), b))
    x, y = tensor[axis][i], tensor[axis][j]
    rows[axis][i] = g.sub(g.mul(c, x), g.mul(s, y))
    rows[axis][j] = g.add(g.mul(s, x), g.mul(c, y))
    rows[j][i], rows[i][axis], rows[j][axis] = rows[i][j], rows[axis][i], rows[axis][j]
    return _symmetric(rows)


def _is_about(graph: Graph, matrix: Sequence[Vector], k: int) -> bool:
    g, i, j = graph, (k + 1) % 3, (k + 2) % 3
    still = (matrix[k][i], matrix[k][j], matrix[i][k], matrix[j][k]) == (g.zero,) * 4 and matrix[k][k] == g.one
    return still and matrix[i][i] == matrix[j][j] and matrix[i][j] == g.neg(matrix[j][i])


def _symmetric(rows: Sequence[Sequence[Node]]) -> Tensor:
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = rows
    return (xx, xy, xz), (xy, yy, yz), (xz, yz, zz)
