"""Axes that turn on axes, read from vectors that are fixed on them: angular velocities without derivatives of matrices.

A vector u = cos(a) v1 + sin(a) v2 + v3 with unit vectors v1, v2 at right angles and v3 along n = v1 x v2, all fixed on axes that
turn with omega, is fixed on axes that turn with omega + a' n, and

    u' = (omega + a' n) x u.

So the columns of a body's matrix are read from the inside: one turn at a time, each on the columns that the one before had.
The column u = R_1j v1 + R_2j v2 + R_3j v3 of a rotation, on right-handed axes v that are fixed in this way, turns with omega and
the columns times the components of R's own angular velocity.  All is in space, and every identity is tested in the prime fields
of :mod:`nhc.mechanics.moving.signatures`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_factors, list_terms
from nhc.mechanics.moving.signatures import Signature, Signatures
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.trees.rates import Rates
from nhc.records import identity_record, record

ZERO: Vector = (0, 0, 0)
_FEW_ANGLES = 6  # by which the parts of one vector turn at its end, and those of what its turn leaves
_DEEP = 60  # turns on one another that are followed at once


@record
class Spin:
    """A turn about ``axis`` (in space) with a rate over velocities; ``own`` is what the rate has beside these."""

    axis: Vector
    rates: tuple[tuple[Node, Node], ...]
    own: Node


class _DeepError(Exception):
    """A vector that is more turns away than are followed at once."""

    def __init__(self, vector: Vector) -> None:
        super().__init__()
        self.vector = vector


@identity_record
class Frame:
    """Axes that turn on those of ``parent``; ``omega`` is their angular velocity over the velocities.

    They turn by an ``angle`` about the axis of their one spin, or by the matrix of the rotation with this number, counted from
    three ``axes`` that are fixed on the parent.
    """

    parent: Frame | None
    spins: tuple[Spin, ...]
    omega: Vector
    depth: int
    angle: Node | None = None
    rotation: int | None = None
    axes: tuple[Vector, ...] = ()

    @property
    def axis(self) -> Vector | None:
        """The one about which it turns on its parent; None where it turns about all."""
        return self.spins[0].axis if len(self.spins) == 1 else None

    @property
    def tilted(self) -> bool:
        """Whether it stands still on its parent, turned by a constant angle."""
        return self.angle is not None and not self.spins[0].rates and self.spins[0].own == 0


ROOT = Frame(None, (), ZERO, 0)


class Frames:
    """The frames of one system's vectors, over the symbols of ``rates``."""

    def __init__(self, rates: Rates, marks: Signatures) -> None:
        self.rates, self.system, self.marks = rates, rates.system, marks
        self.graph: Graph = rates.graph
        self.moving = rates.moving
        self._zero = marks.of(self.graph.zero)
        self._known: dict[Vector, Frame | None] = {}
        self._frames: dict[tuple[int, Node, tuple[Signature, ...]], Frame] = {}
        self._bodies: list[tuple[Frame, Vector]] = []
        self._entries = {
            entry: (r, i, j)
            for r, matrix in enumerate(rates.entries)
            for i, row in enumerate(matrix)
            for j, entry in enumerate(row)
        }
        self._columns: dict[tuple[Signature, ...], Vector] = {}

    def rotation_of(self, entry: Node) -> int:
        """The number of the rotation with this entry."""
        return self._entries[entry][0]

    @property
    def columns(self) -> list[Vector]:
        """Unit vectors that were met."""
        return list(self._columns.values())

    def fixed(self) -> list[tuple[Frame, Vector]]:
        """Unit vectors on the axes on which they were found, with the axis of each turn, completed to three at right angles; those
        of which no two others are known come last.
        """
        found, alone = list[tuple[Frame, Vector]](), list[tuple[Frame, Vector]]()
        for vector, frame in list(self._known.items()):
            if frame is None or not self.vanishes([self.graph.sub(self.graph.dot(vector, vector), self.graph.one)]):
                continue
            own, axis = self.as_known(vector), frame.axis
            if axis is None:
                alone.append((frame, own))
            else:
                found += [(frame, own), (frame, axis), (frame, self.as_known(cross(self.graph, axis, own)))]
        return [*found, *self._bodies, *alone]

    def turns_by(self, angle: Node) -> bool:
        """Whether axes that turn by this angle are known."""
        return any(key[1] == angle for key in self._frames)

    def spun_on(self, triples: Sequence[tuple[Frame, Vector]], angles: Sequence[Node]) -> list[tuple[Frame, Vector]]:
        """Unit vectors on axes that turn by one of the angles about a vector of ``triples`` on its own.

        So the last body of an arm is read, of which no point is beside the axis: its angular velocity alone knows the angle.
        """
        found = list[tuple[Frame, Vector]]()
        for k in range(0, len(triples) - 2, 3):
            (parent, one), (second, two), (third, three) = triples[k : k + 3]
            if not parent is second is third:
                continue
            for x, y in permutations((one, two, three), 2):
                for angle in angles:
                    frame = self._frame(parent, angle, x, y)
                    if frame is not None:
                        found += [(frame, own) for own in self._turn(angle, x, y)]
        return found

    def of(self, vector: Vector) -> Frame | None:
        """The axes on which the vector is fixed, not tilted ones; None where it is not seen to be fixed on any."""
        waiting = [vector]
        while True:
            try:
                found = self._follow(waiting[-1], 0)
            except _DeepError as deep:
                if deep.vector in waiting:
                    self._known[deep.vector] = None  # it turns on itself
                else:
                    waiting.append(deep.vector)  # nearer to the root, first
                continue
            waiting.pop()
            if not waiting:
                while found is not None and found.tilted and found.parent is not None:
                    found = found.parent
                return found

    def _follow(self, vector: Vector, depth: int) -> Frame | None:
        if not any(self.graph.deps[x] & self.moving for x in vector):
            return ROOT
        if vector not in self._known:
            if depth == _DEEP:
                raise _DeepError(vector)
            self._known[vector] = None  # while it is looked for
            try:
                self._known[vector] = self._turned(vector, depth + 1) or self._rotated(vector, depth + 1)
            except _DeepError:
                del self._known[vector]
                raise
        return self._known[vector]

    def _parent(self, vectors: Sequence[Vector], depth: int) -> Frame | None:
        """The axes on which all the vectors are fixed; None where one of them is on none that are known."""
        found = [(self._follow(vector, depth), vector) for vector in vectors]
        parents = [(frame, vector) for frame, vector in found if frame is not None]
        return self.common(parents) if len(parents) == len(found) else None

    def common(self, parts: Sequence[tuple[Frame, Vector]]) -> Frame | None:
        """The axes on which all of them are fixed."""
        deepest = max((frame for frame, _ in parts), key=lambda frame: frame.depth)
        for frame, vector in parts:
            over: Frame | None = deepest
            while over is not None and over is not frame:
                if not over.tilted and (over.axis is None or not self.vanishes(cross(self.graph, over.axis, vector))):
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
        moving = {angle for angle in angles if g.deps[angle] & self.moving}
        if len(moving) > _FEW_ANGLES:
            return None  # a sum of vectors, which is taken apart before it comes back
        for angle in (*sorted(moving, reverse=True), *sorted(angles - moving, reverse=True)):
            across, along, still = self._parts(rows, angle)
            if not self._is_turn(across, along, still):
                continue
            parent = self._parent([v for v in (across, along, still) if any(v)], depth)
            if parent is not None:
                self.as_known(across)
                self.as_known(along)
                return self._frame(parent, angle, across, along)
        return None

    def _turn(self, angle: Node, x: Vector, y: Vector) -> tuple[Vector, Vector, Vector]:
        """What a turn by an angle makes of two unit vectors at right angles, and its axis."""
        g = self.graph
        c, s = g.function("cos", angle), g.function("sin", angle)
        ahead = add_vectors(g, scale_vector(g, c, x), scale_vector(g, s, y))
        aside = add_vectors(g, scale_vector(g, c, y), scale_vector(g, g.neg(s), x))
        return self.as_known(ahead), self.as_known(aside), self.as_known(cross(g, x, y))

    def _parts(self, rows: Sequence[Sequence[Sequence[Node]]], angle: Node) -> tuple[Vector, Vector, Vector]:
        """What a vector has before cos(angle), sin(angle), and beside them."""
        x, y, z = (self._split(row, angle) for row in rows)
        across, along, still = zip(x, y, z, strict=True)
        return across, along, still

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

    def _frame(self, parent: Frame, angle: Node, x: Vector, y: Vector) -> Frame | None:
        g, system = self.graph, self.system
        if self.rates.has_entries(angle):
            return None
        axis = self.as_known(cross(g, x, y))
        key = (id(parent), angle, self.mark(axis))
        if key not in self._frames:
            *slopes, own = gradient(g, angle, (*system.q, system.t))
            rates = tuple((v, a) for v, a in zip(system.v, slopes, strict=True) if a != g.zero)
            self._frames[key] = Frame(*self._spun(parent, (Spin(axis, rates, own),)), angle)
        return self._frames[key]

    def _spun(self, parent: Frame, spins: tuple[Spin, ...]) -> tuple[Frame, tuple[Spin, ...], Vector, int]:
        g, omega = self.graph, parent.omega
        for spin in spins:
            rate = g.add(g.sum([g.mul(a, v) for v, a in spin.rates]), spin.own)
            x, y, z = spin.axis
            omega = add_vectors(g, omega, (g.mul(x, rate), g.mul(y, rate), g.mul(z, rate)))
        return parent, spins, omega, parent.depth + 1

    # --- a rotation -----------------------------------------------------------------------------------------

    def _rotated(self, vector: Vector, depth: int) -> Frame | None:
        """The axes of a rotation of which the vector is a column."""
        g = self.graph
        rows = [[list_factors(g, term) for term in list_terms(g, x)] for x in vector]
        factors = {f for row in rows for term in row for f in term}
        for r, j in sorted(
            {(self._entries[f][0], self._entries[f][2]) for f in factors if f in self._entries}, reverse=True
        ):
            axes = self._split_column(rows, r, j)
            if axes is None:
                continue
            axes = self._right_handed(axes)
            if axes is None:
                continue
            parent = self._parent(axes, depth)
            if parent is not None:
                first, second, third = map(self.as_known, axes)
                return self._body(parent, r, (first, second, third))
        return None

    def _right_handed(self, axes: tuple[Vector, ...]) -> tuple[Vector, ...] | None:
        """Three unit vectors at right angles, all of them turned round where the column was a negative one."""
        g = self.graph
        first, second, third = axes
        units = [g.sub(g.dot(x, x), g.one) for x in axes[:2]]
        normal = cross(g, first, second)
        if not self.vanishes([*units, g.dot(first, second)]):
            return None
        if self.vanishes([g.sub(a, b) for a, b in zip(normal, third, strict=True)]):
            return axes
        if self.vanishes([g.add(a, b) for a, b in zip(normal, third, strict=True)]):
            return tuple((g.neg(x), g.neg(y), g.neg(z)) for x, y, z in axes)
        return None

    def _split_column(self, rows: Sequence[Sequence[Sequence[Node]]], r: int, j: int) -> tuple[Vector, ...] | None:
        """What stands before the entries of column j of rotation r; None where a term has none of these, or another."""
        g, parts = self.graph, [[self.graph.zero] * 3 for _ in range(3)]
        for component, row in enumerate(rows):
            for factors in row:
                own = [f for f in factors if f in self._entries and self._entries[f][0] == r]
                if len(own) != 1 or self._entries[own[0]][2] != j:
                    return None
                rest = list(factors)
                rest.remove(own[0])
                i = self._entries[own[0]][1]
                parts[i][component] = g.add(parts[i][component], g.product(rest))
        return tuple((x, y, z) for x, y, z in parts)

    def _body(self, parent: Frame, r: int, axes: tuple[Vector, Vector, Vector]) -> Frame:
        """The axes of a rotation on its parent's ``axes``."""
        g, matrix, omega = self.graph, self.rates.entries[r], self.rates.omega[r]
        key = (id(parent), omega[0], tuple(mark for axis in axes for mark in self.mark(axis)))
        if key not in self._frames:
            columns = []
            for j in range(3):
                x, y, z = (g.dot([matrix[i][j] for i in range(3)], [own[c] for own in axes]) for c in range(3))
                columns.append(self.as_known((x, y, z)))
            about = columns if self.system.rotations[r].sign > 0 else axes
            spins = [Spin(axis, ((w, g.one),), g.zero) for axis, w in zip(about, omega, strict=True)]
            self._frames[key] = Frame(*self._spun(parent, tuple(spins)), None, r, axes)
            self._bodies += [(self._frames[key], column) for column in columns]
        return self._frames[key]
