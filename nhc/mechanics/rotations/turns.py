"""Turns of axes, chains of them, and the change of components between chains.

A vector has three components; a planar one has zero for the third.  A turn by phi in the plane of axes (i, j) takes
components l on the turned axes to

    o_i = cos(phi) l_i - sin(phi) l_j,    o_j = sin(phi) l_i + cos(phi) l_j

on the axes it started from.  A path is a chain of turns from the axes of the spec inwards.  Two paths that part in turns of the
same plane are joined by one turn by the difference of their angles, which is what makes a chain of planar bodies cheap.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.records import record

Vector = tuple[Node, Node, Node]


@record
class Turn:
    """A turn by ``angle`` in the plane of the axes ``plane``, from the first to the second."""

    plane: tuple[int, int]
    angle: Node


Path = tuple[Turn, ...]


def turn_in(graph: Graph, turn: Turn, outer: Vector) -> Vector:
    """Components on the turned axes of a vector given on the axes before the turn."""
    i, j = turn.plane
    if outer[i] == graph.zero and outer[j] == graph.zero:
        return outer
    c, s = graph.function("cos", turn.angle), graph.function("sin", turn.angle)
    inner = list(outer)
    inner[i] = graph.add(graph.mul(c, outer[i]), graph.mul(s, outer[j]))
    inner[j] = graph.sub(graph.mul(c, outer[j]), graph.mul(s, outer[i]))
    return inner[0], inner[1], inner[2]


def turn_out(graph: Graph, turn: Turn, inner: Vector) -> Vector:
    """Components on the axes before the turn of a vector given on the turned axes."""
    return turn_in(graph, Turn(turn.plane, graph.neg(turn.angle)), inner)


def change_axes(graph: Graph, vector: Vector, source: Path, target: Path) -> Vector:
    """Components on the axes of ``target`` of a vector given on those of ``source``."""
    shared = 0
    while shared < min(len(source), len(target)) and source[shared] == target[shared]:
        shared += 1
    out, into = list(source[shared:]), list(target[shared:])
    while len(out) > 1 or (out and not (into and out[0].plane == into[0].plane)):
        vector = turn_out(graph, out.pop(), vector)
    if out:
        vector = turn_in(graph, Turn(out[0].plane, graph.sub(into[0].angle, out[0].angle)), vector)
        into.pop(0)
    for turn in into:
        vector = turn_in(graph, turn, vector)
    return vector


def cross(graph: Graph, x: Sequence[Node], y: Sequence[Node]) -> Vector:
    """x times y."""
    g = graph
    return (
        g.sub(g.mul(x[1], y[2]), g.mul(x[2], y[1])),
        g.sub(g.mul(x[2], y[0]), g.mul(x[0], y[2])),
        g.sub(g.mul(x[0], y[1]), g.mul(x[1], y[0])),
    )


def add_vectors(graph: Graph, x: Vector, y: Vector) -> Vector:
    """x + y."""
    return graph.add(x[0], y[0]), graph.add(x[1], y[1]), graph.add(x[2], y[2])


def scale_vector(graph: Graph, factor: Node, x: Vector) -> Vector:
    """factor x."""
    return graph.mul(factor, x[0]), graph.mul(factor, x[1]), graph.mul(factor, x[2])


def climb(graph: Graph, start: Vector, at: Path, path: Path, parts: Iterable[tuple[Path, Vector]]) -> Vector:
    """A vector on the axes of ``at`` and parts on axes of their own, added up on the axes of ``path``.

    Parts that have the axes of ``at`` are added before these are changed: one change for both.
    """
    total, rest = start, list(parts)
    for there in (at, path):
        total, at = change_axes(graph, total, at, there), there
        for own in [part for part in rest if part[0] == there]:
            total = add_vectors(graph, total, own[1])
            rest.remove(own)
    for source, local in rest:
        total = add_vectors(graph, total, change_axes(graph, local, source, path))
    return total


def add_spin(graph: Graph, turn: Turn, outer: Vector, rate: Node) -> Vector:
    """Angular velocity of the turned axes, on themselves, from that of the axes before the turn and the angle's rate."""
    i, j = turn.plane
    normal = 3 - i - j
    inner = list(turn_in(graph, turn, outer))
    # (0, 1), (1, 2), (2, 0) turn positively about the axis that is left over
    positive = (j - i) % 3 == 1
    inner[normal] = graph.add(inner[normal], rate if positive else graph.neg(rate))
    return inner[0], inner[1], inner[2]
