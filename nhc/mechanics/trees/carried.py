"""What stands on a body with a `rotation:`, on that body's axes in place of those of space.

A vector of a body that stands on another one is R d, d on the axes of the root body, and R is an orthogonal matrix: T's squares are
those of R^T v, Newton's and Euler's equations hold for the components of velocities and accelerations on any axes, and what is left
of d is a function of the angles between the bodies.  So the matrix is nowhere in the recursion but at the root's own point, whose
acceleration V on the root's axes stands in place of that of its coordinates: x'' = R V.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.frames import Frame
from nhc.mechanics.trees.points import Components, Point, Unread
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.records import record


@record
class Turned:
    """Three variables that are R^T times the rates of their numbers."""

    rates: tuple[int, int, int]
    matrix: tuple[Vector, ...]

    def from_space(self, graph: Graph, values: list[Node]) -> None:
        """R^T x for what stands at the three places."""
        own = [values[i] for i in self.rates]
        for i, column in zip(self.rates, zip(*self.matrix, strict=True), strict=True):
            values[i] = graph.dot(column, own)

    def to_space(self, graph: Graph, values: list[Node]) -> None:
        """R x."""
        own = [values[i] for i in self.rates]
        for i, row in zip(self.rates, self.matrix, strict=True):
            values[i] = graph.dot(row, own)


def root_of(frame: Frame) -> Frame:
    """The axes next to those of space on which a frame turns."""
    while frame.parent is not None and frame.parent.parent is not None:
        frame = frame.parent
    return frame


def find_carriers(points: Sequence[tuple[Components, Point]]) -> dict[int, int]:
    """The rotation on whose axes a point is written, by the point's identity; nothing where no body stands on one with a rotation,
    or where two of a point's components are all that T has.
    """
    every: dict[int, Point] = {}
    hanging: dict[int, list[int]] = {}
    for _, point in points:
        own: Point | None = point
        while own is not None and id(own) not in every:
            every[id(own)] = own
            if own.base is not None:
                hanging.setdefault(id(own.base), []).append(id(own))
            own = own.base
    over: dict[int, dict[int, Frame]] = {}  # axes next to space on which what a point is made of turns
    for key, own in every.items():
        found, below = dict[int, Frame](), own
        while True:
            found.update((id(root_of(frame)), root_of(frame)) for frame, _ in below.arms)
            if below.base is None:
                break
            below = below.base
        over[key] = found
    carriers = {
        key: top.rotation
        for key, found in over.items()
        if len(found) == 1
        for top in found.values()
        if top.rotation is not None
    }
    for key in [
        key for key, found in over.items() if not found
    ]:  # a body's own point in space goes with what stands on it
        above = {carriers.get(k) for k in hanging.get(key, ())}
        carrier = above.pop() if len(above) == 1 else None
        if carrier is not None:
            carriers[key] = carrier
    mixed = {top.rotation for key, found in over.items() if key not in carriers for top in found.values()}
    carriers = {key: carrier for key, carrier in carriers.items() if carrier not in mixed}
    flat = any(None in components for components, point in points if id(point) in carriers)
    stacked = any(root_of(frame) is not frame for key in carriers for frame, _ in every[key].arms)
    return carriers if stacked and not flat else {}


@record
class Stand:
    """What a point is before its arms, on its carrier's axes: rows of variables, constants, and the rates of both."""

    rows: list[Terms]
    constants: list[Node]
    turns: list[Node]


class Carried:
    """The points, by their identity, with the rotations that carry them; nothing is ``direct`` where the root's velocities stand in
    something else than its point, too.
    """

    def __init__(self, system: System, rates: int, carriers: Mapping[int, int], *, direct: bool = True) -> None:
        self.system, self.graph, self.carriers = system, system.graph, carriers
        self.axes = {*carriers.values()}
        self._rates, self._direct = rates, direct
        self._turned: Counter[Turned] = Counter()

    def row(self, point: int, axis: int) -> Vector:
        """What one of a point's components in space is of its variables."""
        carrier = self.carriers.get(point)
        if carrier is not None:
            return self.system.rotations[carrier].matrix[axis]
        x, y, z = (self.graph.number(int(axis == k)) for k in range(3))
        return x, y, z

    def turn(self, rows: list[Terms], constants: list[Node], turns: list[Node], carrier: int) -> Stand:
        """R^T of what a point is in space; where it is three rates, their variables stand for it from now on."""
        g, matrix = self.graph, self.system.rotations[carrier].matrix
        columns = [*zip(*matrix, strict=True)]
        kept = tuple(next(iter(row)) for row in rows if self._direct and [*row.values()] == [g.one])
        if len({*kept}) == 3 and 0 <= min(kept) <= max(kept) < self._rates and not any((*constants, *turns)):
            self._turned[Turned((kept[0], kept[1], kept[2]), matrix)] += 1
            return Stand(rows, constants, turns)
        made: list[Terms] = [{}, {}, {}]
        for own, column in zip(made, columns, strict=True):
            for a, row in zip(column, rows, strict=True):
                for c, b in row.items():
                    own[c] = g.add(own.get(c, g.zero), g.mul(a, b))
        return Stand(made, [g.dot(own, constants) for own in columns], [g.dot(own, turns) for own in columns])

    def turned(self, recursion: Recursion) -> list[Turned]:
        """The variables that are no rates any more.

        Raises:
            Unread: they stand in something else than the points that they were turned for.
        """
        used = Counter(c for terms in (*recursion.definitions, *recursion.forms) for c in terms)
        if any(used[i] != times for turned, times in self._turned.items() for i in turned.rates):
            raise Unread
        return [*self._turned]
