"""The axes on which the vectors of bodies are written: those of space, of the body that carries the others, or of each body.

T's squares are those of a vector's components on any axes, and Newton's and Euler's equations hold for the components of velocities
and of accelerations on any axes.  A vector that is fixed on a body has constant components on its own axes, and on those of the
body that carries it what the angles between the two make of them: matrices are nowhere in the recursion but where axes change.
The acceleration V of the root's point on the root's axes stands in place of that of its coordinates: x'' = R V.

(R. Featherstone, Int. J. Robot. Res. 2 (1983) 13, writes each body on its own axes.)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from itertools import pairwise

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.trees.frames import ROOT, Frame, Frames
from nhc.mechanics.trees.points import Unread
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.mechanics.trees.sharing import Point
from nhc.records import record, structure

Matrix = tuple[Vector, ...]


@record
class Turned:
    """Three variables that are R^T times the rates of their numbers."""

    rates: tuple[int, int, int]
    matrix: Matrix

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


@structure
class Triple:
    """Three components: rows of variables, constants, and the rates of both where the variables have none."""

    rows: list[Terms]
    constants: list[Node]
    turns: list[Node]

    def plus(self, graph: Graph, other: Triple) -> Triple:
        """The sum."""
        g = graph
        rows = [dict(row) for row in self.rows]
        for row, more in zip(rows, other.rows, strict=True):
            for c, a in more.items():
                row[c] = g.add(row.get(c, g.zero), a)
        constants = [g.add(a, b) for a, b in zip(self.constants, other.constants, strict=True)]
        return Triple(rows, constants, [g.add(a, b) for a, b in zip(self.turns, other.turns, strict=True)])

    def turned(self, graph: Graph, matrix: Matrix) -> Triple:
        """M^T of it."""
        columns = [*zip(*matrix, strict=True)]
        made: list[Terms] = [{}, {}, {}]
        for own, column in zip(made, columns, strict=True):
            for a, row in zip(column, self.rows, strict=True):
                for c, b in row.items() if a != graph.zero else ():
                    own[c] = graph.add(own.get(c, graph.zero), graph.mul(a, b))
        constants, turns = ([graph.dot(own, part) for own in columns] for part in (self.constants, self.turns))
        return Triple(made, constants, turns)


class Views:
    """``views`` are the frames on whose axes what is fixed on a frame is written, by its identity; others are written in space.
    Nothing is ``direct`` where the root's velocities stand in something else than its point, too.
    """

    def __init__(self, frames: Frames, views: Mapping[int, Frame], *, direct: bool = True) -> None:
        self._frames, self._views, self._direct = frames, views, direct
        self.graph, self._rates = frames.graph, frames.rates
        self._inside: dict[int, dict[Node, Node]] = {id(ROOT): {}}
        self._steps: dict[int, Matrix] = {}
        self._matrices: dict[int, Matrix] = {id(ROOT): self._unit()}
        self._local: dict[tuple[int, Vector], Vector] = {}
        self._turned: Counter[Turned] = Counter()

    def _unit(self) -> Matrix:
        zero, one = self.graph.zero, self.graph.one
        return (one, zero, zero), (zero, one, zero), (zero, zero, one)

    @property
    def in_space(self) -> bool:
        """Whether there are none."""
        return not self._views

    def of(self, frame: Frame) -> Frame:
        """The axes for what is fixed on a frame."""
        return self._views.get(id(frame), ROOT)

    def axes_of_spins(self, frame: Frame, view: Frame) -> Frame:
        """Where a frame's spins are taken on the way to a view: on the frame itself, on what it turns on where its angular velocity
        has its components there, or on the view where the frame stands on that.
        """
        if not any(own is frame for own in _chain(view)):
            return view
        first = frame.rotation is not None and self._rates.system.rotations[frame.rotation].sign < 0
        assert frame.parent is not None
        return frame.parent if first else frame

    def of_point(self, point: Point) -> Frame:
        """The axes for a point's velocity: those of what it turns with, or of what it is told to go with."""
        if id(point) in self._views:
            return self._views[id(point)]
        if point.arms:
            return self.of(max((frame for frame, _ in point.arms), key=lambda frame: frame.depth))
        return self.of_point(point.base) if point.base is not None else ROOT

    def local(self, vector: Vector, view: Frame) -> Vector:
        """The components on a frame's axes of a vector that is fixed on these, or on what turns on them.

        Raises:
            Unread: it has more of the frame's turns than their sines and cosines.
        """
        if view is ROOT or not any(vector):
            return vector
        key = id(view), vector
        if key not in self._local:
            g, frames = self.graph, self._frames
            x, y, z = substitute(g, vector, self._at_rest(view), named=False)
            back = [g.dot(row, (x, y, z)) for row in self.matrix(view)]
            if not all(frames.marks.of(a) == frames.marks.of(b) for a, b in zip(back, vector, strict=True)):
                if not view.tilted or view.parent is None:
                    raise Unread
                x, y, z = self.shift_vector(self.local(vector, view.parent), view.parent, view)
            self._local[key] = x, y, z
        return self._local[key]

    def _at_rest(self, frame: Frame) -> dict[Node, Node]:
        """Values at which a frame and those before it are not turned."""
        if id(frame) not in self._inside:
            g, parent = self.graph, frame.parent
            found = dict(self._at_rest(parent)) if parent is not None else {}
            if frame.angle is not None:
                found.update({g.function("cos", frame.angle): g.one, g.function("sin", frame.angle): g.zero})
            else:
                entries = self._rates.entries[frame.rotation] if frame.rotation is not None else ()
                for row, unit in zip(entries, self._unit(), strict=True):
                    found.update(zip(row, unit, strict=True))
            self._inside[id(frame)] = found
        return self._inside[id(frame)]

    def matrix(self, frame: Frame) -> Matrix:
        """From a frame's axes to those of space, over the symbols of rotations."""
        if id(frame) not in self._matrices:
            assert frame.parent is not None
            self._matrices[id(frame)] = self._times(self.matrix(frame.parent), self.step(frame))
        return self._matrices[id(frame)]

    def _times(self, left: Matrix, right: Matrix) -> Matrix:
        if left == self._unit():
            return right
        columns = [*zip(*right, strict=True)]
        made = [[self.graph.dot(row, column) for column in columns] for row in left]
        return tuple((a, b, c) for a, b, c in made)

    def step(self, frame: Frame) -> Matrix:
        """From a frame's axes to those of its parent."""
        if id(frame) not in self._steps:
            self._steps[id(frame)] = self._turn(frame) if frame.angle is not None else self._rotation(frame)
        return self._steps[id(frame)]

    def _turn(self, frame: Frame) -> Matrix:
        """About a unit vector n: cos 1 + sin [n] + (1 - cos) n n^T (O. Rodrigues 1840)."""
        g, angle = self.graph, frame.angle
        assert frame.parent is not None
        assert angle is not None
        n = self.local(frame.spins[0].axis, frame.parent)
        c, s = g.function("cos", angle), g.function("sin", angle)
        rest = g.sub(g.one, c)
        rows = []
        for i in range(3):
            own = [g.mul(rest, g.mul(n[i], n[j])) for j in range(3)]
            own[i] = g.add(c, own[i])
            first, second = (i + 1) % 3, (i + 2) % 3
            own[first] = g.sub(own[first], g.mul(s, n[second]))
            own[second] = g.add(own[second], g.mul(s, n[first]))
            rows.append((own[0], own[1], own[2]))
        return tuple(rows)

    def _rotation(self, frame: Frame) -> Matrix:
        assert frame.parent is not None
        assert frame.rotation is not None
        columns = [self.local(axis, frame.parent) for axis in frame.axes]
        entries: Matrix = tuple(self._rates.entries[frame.rotation])
        return self._times(tuple((a, b, c) for a, b, c in zip(*columns, strict=True)), entries)

    def shift(self, triple: Triple, old: Frame, new: Frame) -> Triple:
        """On the axes of a frame that turns on those on which it is.

        Raises:
            Unread: it does not.
        """
        for frame in between(old, new):
            triple = triple.turned(self.graph, self.step(frame))
        return triple

    def shift_vector(self, vector: Vector, old: Frame, new: Frame) -> Vector:
        """The same for a vector."""
        for frame in between(old, new):
            x, y, z = (self.graph.dot(column, vector) for column in zip(*self.step(frame), strict=True))
            vector = x, y, z
        return vector

    def settle(self, triple: Triple, view: Frame) -> Triple:
        """What a point is in space, on a view; where it is three rates, their variables stand for it from now on."""
        if view is ROOT or not (any(triple.rows) or any(triple.constants) or any(triple.turns)):
            return triple
        one = [self.graph.one]
        kept = tuple(next(iter(row)) for row in triple.rows if self._direct and [*row.values()] == one)
        still = not any((*triple.constants, *triple.turns))
        if still and len({*kept}) == 3 and 0 <= min(kept) <= max(kept) < len(self._rates.motion.w):
            self._turned[Turned((kept[0], kept[1], kept[2]), self.on_motion(view))] += 1
            return triple
        return self.shift(triple, ROOT, view)

    def on_motion(self, view: Frame) -> Matrix:
        """The matrix of a view on the motion."""
        return tuple((a, b, c) for a, b, c in map(self._rates.on_motion, self.matrix(view)))

    def turned(self, recursion: Recursion) -> list[Turned]:
        """The variables that are no rates any more.

        Raises:
            Unread: they stand in something else than the points that they were turned for.
        """
        used = Counter(c for terms in (*recursion.definitions, *recursion.forms) for c in terms)
        if any(used[i] != times for turned, times in self._turned.items() for i in turned.rates):
            raise Unread
        return [*self._turned]


def _chain(frame: Frame) -> list[Frame]:
    """The frames from that next to space to this one."""
    found: list[Frame] = []
    while frame.parent is not None:
        found.append(frame)
        frame = frame.parent
    return found[::-1]


def between(old: Frame, new: Frame) -> list[Frame]:
    """The frames after one on the way to another, which turns on it.

    Raises:
        Unread: it does not.
    """
    before, whole = _chain(old), _chain(new)
    if before != whole[: len(before)]:
        raise Unread
    return whole[len(before) :]


# --- which axes --------------------------------------------------------------------------------------------------


def list_views(points: Iterable[Point], angular: Iterable[Frame]) -> list[dict[int, Frame]]:
    """For all families of frames on one next to space: the axes of the body that carries the others, and each body's own.

    Not where a point hangs on two families.
    """
    every: dict[int, Point] = {}
    for point in points:
        every.update((id(own), own) for own in _foundations(point))
    families: dict[int, dict[int, Frame]] = {}
    for frame in (*(frame for own in every.values() for frame, _ in own.arms), *angular):
        families.setdefault(id(_chain(frame)[0]), {})[id(frame)] = frame
    paths = {
        key: [frame for own in reversed(_foundations(point)) for frame, _ in own.arms] for key, point in every.items()
    }
    held = {key: {id(_chain(frame)[0]) for frame in path} for key, path in paths.items()}
    mixed = {family for found in held.values() if len(found) > 1 for family in found}
    crossed = {id(frame) for path in paths.values() for frame in _crossings(path)}
    carried: dict[int, Frame] = {}
    apart: dict[int, Frame] = {}
    tops: dict[int, Frame] = {}
    for family, frames in families.items():
        if len(frames) > 1 and family not in mixed:
            tops[family], own = _views_of([*frames.values()], crossed)
            carried.update(dict.fromkeys(frames, tops[family]))
            apart.update(own)
    for key, point in every.items():  # a body's own point in space goes with what stands on it, or begins as it does
        if not point.arms and point.base is None:
            above = [held[k] for k, other in every.items() if other.base is point or _begins_alike(point, other)]
            families_above = set[int]().union(*above)
            if all(above) and len(families_above) == 1 and families_above <= tops.keys():
                carried[key] = apart[key] = tops[families_above.pop()]
    return [carried, *([apart] if apart != carried else [])] if carried else []


def _views_of(frames: Sequence[Frame], crossed: Container[int]) -> tuple[Frame, dict[int, Frame]]:
    """The frame that carries all of these, and each one's own for those from that one on; the one below where it is crossed."""
    chains = [_chain(frame) for frame in frames]
    shared = [frame for k, frame in enumerate(chains[0]) if all(frame in chain[k : k + 1] for chain in chains)]
    found: dict[int, Frame] = {}
    for chain in chains:
        view = shared[-1]
        for frame in chain[len(shared) - 1 :]:
            view = view if id(frame) in crossed else frame
            found[id(frame)] = view
    return shared[-1], found


def _begins_alike(own: Point, other: Point) -> bool:
    return own is not other and own.base is other.base is None and own.loose == other.loose and bool(other.arms)


def _foundations(point: Point) -> list[Point]:
    """A point and those that it stands on, down to the first."""
    found, own = [point], point.base
    while own is not None:
        found.append(own)
        own = own.base
    return found


def _crossings(path: Sequence[Frame]) -> set[Frame]:
    """Frames beside the one before on the way to a point, and that one: links that turn about parallel axes by sums of angles."""
    found = set[Frame]()
    for one, other in pairwise(path):
        first, second = _chain(one), _chain(other)
        shared = sum(a is b for a, b in zip(first, second, strict=False))
        if shared < min(len(first), len(second)):
            found.update((*first[shared:], *second[shared:]))
    return found
