"""Rigid bodies by angles as a recursion: angular velocities and points in space in place of the derivatives of matrices.

A point that is fixed at d on axes with omega, beside a point B, has B' + omega x d, and omega is that of the axes before with the
rates of the joint; T's components of an angular velocity are u . omega with vectors u fixed on the body.  With the rates' own rates
left out, B'' has omega x (omega x d) added, omega' gets omega_before x n a', and u . omega nothing.  The equations of rotation take
-omega x L, L = sum of the momenta along the u (L. Euler), for which no form has to be differentiated.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, list_terms, tangent
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.graph import ADD, NEG, Graph, Node
from nhc.algebra.monomials import split_parameters
from nhc.algebra.solving.linear import linear_form
from nhc.mechanics.kinetic import Kinetic
from nhc.mechanics.moving.signatures import Signatures
from nhc.mechanics.system import System
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Frames
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.mechanics.trees.triples import list_triples, place_of
from nhc.mechanics.turns import Vector, add_vectors, cross
from nhc.mechanics.whole_forms import whole_kinetic
from nhc.records import fresh, structure

_FEW = 3  # coordinates of what moves in another way than by turning


@structure
class Point:
    """``base`` + the vectors d on their axes + what moves in other ways."""

    base: Point | None
    arms: list[tuple[Frame, Vector]]
    loose: Vector
    variables: tuple[int, int, int] | None = None


@structure
class Spatial:
    """``turns`` are the rates of the recursion's definitions where those they are made of have none; ``torques`` what the forms
    that are ``known`` give to the variables beside the rates of T's slopes.
    """

    kinetic: Kinetic
    recursion: Recursion
    turns: list[Node] = fresh(factory=list)
    torques: list[tuple[int, Node]] = fresh(factory=list)
    known: set[int] = fresh(factory=set)


class _Unread(Exception):
    """A vector that is no sum of vectors fixed on axes."""


def read_bodies(system: System) -> Spatial | None:
    """The recursion of T's forms over the velocities q'; None where T has no points in space that turn, or others than these."""
    kinetic = whole_kinetic(system, system.graph.rate_of) if not system.rotations else None
    if kinetic is None:
        return None
    triples = list_triples(system, kinetic)
    if not triples:
        return None
    g = system.graph
    found = [place_of(g, kinetic.atoms[k]) for triple in triples for k in triple]
    places = [place for place, _ in found]
    signs = {k: sign for k, (_, sign) in zip((k for triple in triples for k in triple), found, strict=True)}
    try:
        reader = _Reader(system, kinetic, Signatures(g, [*kinetic.atoms, *places]), places)
        points = [reader.point((a, b, c)) for a, b, c in zip(places[::3], places[1::3], places[2::3], strict=True)]
        if not reader.turned:
            return None
        return reader.write(triples, points, signs)
    except (_Unread, Unlucky):
        return None


class _Reader:
    def __init__(self, system: System, kinetic: Kinetic, marks: Signatures, places: Sequence[Node]) -> None:
        self.system, self.kinetic, self.marks = system, kinetic, marks
        self.graph: Graph = system.graph
        self.frames = Frames(system, marks)
        self.turned = False
        self._mask = self.graph.mask(system.p)
        self._moving = self.graph.mask((*system.q, system.t))
        self._points: dict[Vector, Point] = {}
        self._uses: dict[Node, int] = {}
        seen, stack = set[Node](), list(places)
        while stack:
            node = stack.pop()
            if node in seen or self.graph.op[node] not in (ADD, NEG):
                continue
            seen.add(node)
            for child in self.graph.kids[node]:
                self._uses[child] = self._uses.get(child, 0) + (self.graph.op[node] == ADD)
                stack.append(child)

    # --- positions ------------------------------------------------------------------------------------------

    def point(self, place: Vector) -> Point:
        """A position as the next one that others share, and the rest."""
        stack = [place]
        while stack:
            own = stack[-1]
            x, y, z = (self._shared(node) for node in own)
            standing = any((x, y, z)) and all(b != node for b, node in zip((x, y, z), own, strict=True))
            if standing and (x, y, z) not in self._points:
                stack.append((x, y, z))
                continue
            held = {x, y, z} if standing else set()
            rows = [[term for term in list_terms(self.graph, node, held) if term not in held] for node in own]
            self._points[own] = self._split(self._points[x, y, z] if standing else None, rows)
            stack.pop()
        return self._points[place]

    def _shared(self, place: Node) -> Node:
        """The largest sum within a sum that has a name or is used elsewhere, else such a term; zero where there is none."""
        g, sums, terms, stack = self.graph, list[Node](), list[Node](), [(place, False)]
        while stack:
            node, negative = stack.pop()
            if g.op[node] == NEG:
                stack.append((g.a[node], not negative))
                continue
            signed = g.neg(node) if negative else node
            named, often = node in g.labels or g.neg(node) in g.labels, self._uses.get(node, 0) > 1
            if g.op[node] != ADD:
                if named and often:
                    terms.append(signed)
            elif signed != place and (named or often):
                sums.append(signed)
            else:
                stack += [(child, negative) for child in g.kids[node]]
        return max(sums or terms, key=lambda own: g.a[own] if g.op[own] == NEG else own, default=g.zero)

    def _split(self, base: Point | None, rows: Sequence[Sequence[Node]]) -> Point:
        """By the parameters in front of the terms, then by the axes."""
        g = self.graph
        groups: dict[Node, list[list[Node]]] = {}
        for axis, row in enumerate(rows):
            for term in row:
                monomial, rest = split_parameters(g, term, self._mask)
                groups.setdefault(monomial.node(g), [[], [], []])[axis].append(rest)
        arms: dict[int, list[tuple[Frame, Vector, Node]]] = {}
        loose = ZERO
        for factor, (x, y, z) in groups.items():
            own = g.sum(x), g.sum(y), g.sum(z)
            frame = self.frames.of(own)
            if frame is None:
                loose = add_vectors(g, loose, self._times(factor, own))
            elif frame is not ROOT:
                own = self.frames.as_known(own)
                deepest = self._home(arms, frame, own)
                arms.setdefault(id(deepest), []).append((deepest, own, factor))
        self._check(loose)
        self.turned = self.turned or bool(arms)
        made = []
        for parts in arms.values():
            total = ZERO
            for _, own, factor in parts:
                total = add_vectors(g, total, self._times(factor, own))
            made.append((max((p[0] for p in parts), key=lambda f: f.depth), total))
        return Point(base, made, loose)

    def _home(self, arms: dict[int, list[tuple[Frame, Vector, Node]]], frame: Frame, own: Vector) -> Frame:
        """The axes of an arm that is there already, where both are fixed on one of the two; else the vector's own."""
        for key, parts in list(arms.items()):
            common = self.frames.common([(frame, own), *((f, v) for f, v, _ in parts)])
            if common is not None:
                arms[id(common)] = arms.pop(key)
                return common
        return frame

    def _times(self, factor: Node, vector: Vector) -> Vector:
        g = self.graph
        return g.mul(factor, vector[0]), g.mul(factor, vector[1]), g.mul(factor, vector[2])

    def _check(self, loose: Vector) -> None:
        g = self.graph
        if sum(any(g.depends(x, g.deps[q]) for x in loose) for q in self.system.q) > _FEW:
            raise _Unread

    # --- the recursion --------------------------------------------------------------------------------------

    def write(self, triples: Sequence[Sequence[int]], points: Sequence[Point], signs: dict[int, int]) -> Spatial:
        """Points from the root on, each frame when it is first needed; then T's other forms."""
        system, atoms = self.system, self.kinetic.atoms
        self.made = Spatial(self.kinetic, Recursion(system.n))
        self._variables: dict[int, tuple[int, int, int]] = {}
        self._momenta: dict[tuple[int, int, int], tuple[Frame, Vector]] = {}
        of: dict[int, tuple[Frame, Vector, int]] = {}
        inside = {k for triple in triples for k in triple}
        names = self._angular()
        for k, atom in enumerate(atoms):
            if k not in inside:
                found = names.get(self.marks.of(atom))
                if found is not None:
                    of[k] = found
        forms: list[Terms] = [{} for _ in atoms]
        waiting = dict(of)
        for triple, point in zip(triples, points, strict=True):
            for k, variable in zip(triple, self._place(point), strict=True):
                forms[k] = {variable: self.graph.number(signs[k])}
            near = {id(frame) for frame, _ in point.arms}
            for k in [k for k, (frame, _, _) in waiting.items() if id(frame) in near]:
                forms[k] = self._component(k, *waiting.pop(k))
        for k, atom in enumerate(atoms):
            if k in waiting:
                forms[k] = self._component(k, *waiting.pop(k))
            elif k not in inside and k not in of:
                forms[k] = self._plain(atom)
        for variables, (frame, momentum) in self._momenta.items():
            self.made.torques += zip(variables, cross(self.graph, momentum, frame.omega), strict=True)
        self.made.recursion.forms = forms
        return self.made

    def _define(self, terms: Terms, constant: Node, turn: Node) -> int:
        g = self.graph
        self.made.turns.append(turn)
        return self.made.recursion.define({c: a for c, a in terms.items() if a != g.zero}, constant)

    def _place(self, point: Point) -> tuple[int, int, int]:
        """The variables of a point's velocity, after those of the points below it."""
        below: list[Point] = []
        over: Point | None = point
        while over is not None and over.variables is None:
            below.append(over)
            over = over.base
        for own in reversed(below):
            own.variables = self._hang(own, own.base.variables if own.base is not None else None)
        assert point.variables is not None
        return point.variables

    def _hang(self, point: Point, below: tuple[int, int, int] | None) -> tuple[int, int, int]:
        g, system = self.graph, self.system
        rows: list[Terms] = [{} if below is None else {below[axis]: g.one} for axis in range(3)]
        constants, turns = list(ZERO), list(ZERO)
        for frame, d in point.arms:
            x, y, z = self._spin(frame)
            for row, one, two, first, second in ((0, y, z, 2, 1), (1, z, x, 0, 2), (2, x, y, 1, 0)):
                rows[row][one] = g.add(rows[row].get(one, g.zero), d[first])
                rows[row][two] = g.sub(rows[row].get(two, g.zero), d[second])
            drift = cross(g, frame.omega, cross(g, frame.omega, d))
            turns = [g.add(a, b) for a, b in zip(turns, drift, strict=True)]
        for axis, node in enumerate(point.loose):
            if node == g.zero:
                continue
            *slopes, constants[axis] = gradient(g, node, (*system.q, system.t))
            rows[axis].update((i, a) for i, a in enumerate(slopes) if a != g.zero)
            rate = g.add(g.dot(slopes, system.v), constants[axis])
            seeds = {**dict(zip(system.q, system.v, strict=True)), system.t: g.one}
            turns[axis] = g.add(turns[axis], tangent(g, [rate], seeds)[0])
        a, b, c = (self._define(row, k, turn) for row, k, turn in zip(rows, constants, turns, strict=True))
        return a, b, c

    def _spin(self, frame: Frame) -> tuple[int, int, int]:
        """The variables of a frame's angular velocity: on the last frame before it that has some."""
        if id(frame) in self._variables:
            return self._variables[id(frame)]
        g, system = self.graph, self.system
        rows: list[Terms] = [{}, {}, {}]
        constants, turns = list(ZERO), list(ZERO)
        seeds = {**dict(zip(system.q, system.v, strict=True)), system.t: g.one}
        top: Frame | None = frame
        while top is not None and top.parent is not None and id(top) not in self._variables:
            rate = g.add(g.sum([g.mul(a, system.v[i]) for i, a in top.rates]), top.own)
            tilt = self._times(rate, cross(g, top.parent.omega, top.axis))
            growth = tangent(g, [rate], seeds)[0]
            for axis in range(3):
                for i, a in top.rates:
                    rows[axis][i] = g.add(rows[axis].get(i, g.zero), g.mul(top.axis[axis], a))
                constants[axis] = g.add(constants[axis], g.mul(top.axis[axis], top.own))
                turns[axis] = g.add(g.add(turns[axis], tilt[axis]), g.mul(top.axis[axis], growth))
            top = top.parent
        if top is not None and id(top) in self._variables:
            for row, variable in zip(rows, self._variables[id(top)], strict=True):
                row[variable] = g.one
        a, b, c = (self._define(row, k, turn) for row, k, turn in zip(rows, constants, turns, strict=True))
        self._variables[id(frame)] = a, b, c
        return a, b, c

    # --- T's other forms ------------------------------------------------------------------------------------

    def _angular(self) -> dict[tuple[int, ...], tuple[Frame, Vector, int]]:
        """Signatures of the components of angular velocities along vectors that are fixed on the axes, with their signs."""
        g = self.graph
        found: dict[tuple[int, ...], tuple[Frame, Vector, int]] = {}
        for frame, vector in self.frames.fixed():
            mark = self.marks.of(g.dot(vector, frame.omega))
            found.setdefault(mark, (frame, vector, 1))
            found.setdefault(self.marks.negative(mark), (frame, vector, -1))
        return found

    def _component(self, k: int, frame: Frame, vector: Vector, sign: int) -> Terms:
        """u . omega as a definition, with what it gives to omega: -omega x u times its momentum."""
        g = self.graph
        variables = self._spin(frame)
        x, y, z = variables
        number = self._define({x: vector[0], y: vector[1], z: vector[2]}, g.zero, g.zero)
        self.made.known.add(k)
        slope = g.mul(g.number(sign), self.kinetic.slope[k])
        total = self._momenta.get(variables, (frame, ZERO))[1]
        self._momenta[variables] = frame, add_vectors(g, total, self._times(slope, vector))
        return {number: g.number(sign)}

    def _plain(self, atom: Node) -> Terms:
        """Other forms, of few rates."""
        g, system = self.graph, self.system
        coefficients, constant = linear_form(g, atom, system.v)
        terms = {i: a for i, a in enumerate(coefficients) if a != g.zero}
        if len(terms) > _FEW:
            raise _Unread
        if len(terms) == 1 and constant == g.zero and not any(g.deps[a] & ~self._mask for a in terms.values()):
            return terms
        seeds = {**dict(zip(system.q, system.v, strict=True)), system.t: g.one}
        (turn,) = tangent(g, [atom], seeds)
        return {self._define(terms, constant, turn): g.one}
