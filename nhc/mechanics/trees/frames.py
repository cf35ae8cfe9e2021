"""Axes that turn on axes, read from vectors that are fixed on them: angular velocities without derivatives of matrices.

A vector u = cos(a) v1 + sin(a) v2 + v3 with unit vectors v1, v2 at right angles and v3 along n = v1 x v2, all fixed on axes that
turn with omega, is fixed on axes that turn with omega + a' n, and

    u' = (omega + a' n) x u.

So the columns of a body's matrix are read from the inside: one turn at a time, each on the columns that the one before had.  All is
in space, and every identity is tested in the prime fields of :mod:`nhc.mechanics.moving.signatures`.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, list_terms
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.directions import list_factors
from nhc.mechanics.moving.signatures import Signature, Signatures
from nhc.mechanics.system import System
from nhc.mechanics.turns import Vector, add_vectors, cross
from nhc.records import identity_record

ZERO: Vector = (0, 0, 0)
_DEEP = 60  # turns on one another that are followed at once: those of bodies nearer to the root are known


@identity_record
class Frame:
    """Axes that turn about ``axis`` (in space) on those of ``parent``; ``rates``: the angle's rate by the velocities' numbers.

    ``own`` is what the angle's rate has beside these; ``omega`` the angular velocity over the velocities.
    """

    parent: Frame | None
    axis: Vector
    rates: tuple[tuple[int, Node], ...]
    own: Node
    omega: Vector
    depth: int


ROOT = Frame(None, ZERO, (), 0, ZERO, 0)


class Frames:
    """The frames of one system's vectors."""

    def __init__(self, system: System, marks: Signatures) -> None:
        self.system, self.marks = system, marks
        self.graph: Graph = system.graph
        self.moving = self.graph.mask((*system.q, system.t))
        self._zero = marks.of(self.graph.zero)
        self._known: dict[Vector, Frame | None] = {}
        self._frames: dict[tuple[int, Node, tuple[Signature, ...]], Frame] = {}
        self._columns: dict[tuple[Signature, ...], Vector] = {}

    @property
    def columns(self) -> list[Vector]:
        """Unit vectors that were met."""
        return list(self._columns.values())

    def fixed(self) -> list[tuple[Frame, Vector]]:
        """Unit vectors on the axes on which they were found, with the axis of each turn, completed to three at right angles."""
        found: list[tuple[Frame, Vector]] = []
        for vector, frame in list(self._known.items()):
            if frame is None or not self.vanishes([self.graph.sub(self.graph.dot(vector, vector), self.graph.one)]):
                continue
            own = self.as_known(vector)
            found += [(frame, own), (frame, frame.axis), (frame, self.as_known(cross(self.graph, frame.axis, own)))]
        return found

    def of(self, vector: Vector, depth: int = 0) -> Frame | None:
        """The axes on which the vector is fixed; None where it is not seen to be fixed on any."""
        if not any(self.graph.deps[x] & self.moving for x in vector):
            return ROOT
        if vector not in self._known:
            self._known[vector] = None  # while it is looked for
            self._known[vector] = self._turned(vector, depth + 1) if depth < _DEEP else None
        return self._known[vector]

    def common(self, parts: Sequence[tuple[Frame, Vector]]) -> Frame | None:
        """The axes on which all of them are fixed."""
        deepest = max((frame for frame, _ in parts), key=lambda frame: frame.depth)
        for frame, vector in parts:
            over: Frame | None = deepest
            while over is not None and over is not frame:
                if over.parent is None or not self.vanishes(cross(self.graph, over.axis, vector)):
                    return None
                over = over.parent
            if over is None:
                return None
        return deepest

    def vanishes(self, nodes: Sequence[Node]) -> bool:
        """Whether all of them are zero."""
        return all(self.marks.of(node) == self._zero for node in nodes)

    def mark(self, vector: Vector) -> tuple[Signature, ...]:
        """Its components' signatures."""
        return tuple(self.marks.of(x) for x in vector)

    def as_known(self, vector: Vector) -> Vector:
        """The vector in the nodes in which it was met first."""
        mark = self.mark(vector)
        opposite = self._columns.get(tuple(self.marks.negative(x) for x in mark))
        if mark not in self._columns and opposite is not None:
            x, y, z = map(self.graph.neg, opposite)
            return x, y, z
        return self._columns.setdefault(mark, vector)

    # --- one turn -------------------------------------------------------------------------------------------

    def _turned(self, vector: Vector, depth: int) -> Frame | None:
        g = self.graph
        rows = [[list_factors(g, term) for term in list_terms(g, x)] for x in vector]
        angles = {g.a[f] for row in rows for term in row for f in term if g.op[f] in ("sin", "cos")}
        for angle in sorted((a for a in angles if g.deps[a] & self.moving), reverse=True):
            x, y, z = (self._split(row, angle) for row in rows)
            across, along, still = zip(x, y, z, strict=True)
            if not self._is_turn(across, along, still):
                continue
            found = [(self.of(v, depth), v) for v in (across, along, still) if any(v)]
            parents = [(frame, v) for frame, v in found if frame is not None]
            parent = self.common(parents) if len(parents) == len(found) else None
            if parent is not None:
                self.as_known(across)
                self.as_known(along)
                return self._frame(parent, angle, across, along)
        return None

    def _split(self, row: Sequence[Sequence[Node]], angle: Node) -> Vector:
        """What a component has before cos(angle), sin(angle), and beside them."""
        g, parts = self.graph, [self.graph.zero] * 3
        for factors in row:
            rest = list(factors)
            own = next((f for f in rest if g.op[f] in ("sin", "cos") and g.a[f] == angle), None)
            if own is not None:
                rest.remove(own)
            k = 2 if own is None else int(g.op[own] == "sin")
            parts[k] = g.add(parts[k], g.product(rest))
        return parts[0], parts[1], parts[2]

    def _is_turn(self, x: Vector, y: Vector, still: Vector) -> bool:
        g = self.graph
        if not any(x) or not any(y):
            return False
        units = [g.sub(g.dot(x, x), g.one), g.sub(g.dot(y, y), g.one)]
        return self.vanishes([*units, g.dot(x, y), g.dot(x, still), g.dot(y, still)])

    def _frame(self, parent: Frame, angle: Node, x: Vector, y: Vector) -> Frame:
        g, system = self.graph, self.system
        axis = self.as_known(cross(g, x, y))
        key = (id(parent), angle, self.mark(axis))
        if key not in self._frames:
            *slopes, own = gradient(g, angle, (*system.q, system.t))
            rates = tuple((i, a) for i, a in enumerate(slopes) if a != g.zero)
            rate = g.add(g.sum([g.mul(a, system.v[i]) for i, a in rates]), own)
            turn = (g.mul(axis[0], rate), g.mul(axis[1], rate), g.mul(axis[2], rate))
            omega = add_vectors(g, parent.omega, turn)
            self._frames[key] = Frame(parent, axis, rates, own, omega, parent.depth + 1)
        return self._frames[key]
