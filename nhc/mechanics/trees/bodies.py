"""Rigid bodies by angles as a recursion: angular velocities and points in space in place of the derivatives of matrices.

A point that is fixed at d on axes with omega, beside a point B, has B' + omega x d, and omega is that of the axes before with the
rates of the joint; T's components of an angular velocity are u . omega with vectors u fixed on the body.  With the rates' own rates
left out, B'' has omega x (omega x d) added, omega' gets omega_before x n a', and u . omega nothing.  The equations of rotation take
-omega x L, L = sum of the momenta along the u (L. Euler), for which no form has to be differentiated.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.energies.whole_forms import whole_kinetic
from nhc.mechanics.motion import Motion
from nhc.mechanics.moving.signatures import Signatures
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.carried import Carried, Turned, find_carriers
from nhc.mechanics.trees.frames import ZERO, Frame, Frames
from nhc.mechanics.trees.points import Components, Point, Points, Unread
from nhc.mechanics.trees.rates import Rates
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.mechanics.trees.triples import list_squares, place_of
from nhc.records import fresh, structure

_FEW = 3  # coordinates of what moves in another way than by turning


Variables = tuple[int, int, int]
Named = dict[tuple[int, ...], tuple[Frame, Vector, int]]
_STILL = -1


@structure
class Spatial:
    """``turns`` are the rates of the recursion's definitions where those they are made of have none; ``torques`` what the forms
    that are ``known`` give to the variables beside the rates of T's slopes.

    ``placed`` says what T's forms are of the variables as they are written; the recursion's forms may be their components on other
    axes, which have the same squares.  ``turned`` are the variables that are no rates.
    """

    kinetic: Kinetic
    recursion: Recursion
    turns: list[Node] = fresh(factory=list)
    torques: list[tuple[int, Node]] = fresh(factory=list)
    known: set[int] = fresh(factory=set)
    placed: list[Terms] = fresh(factory=list)
    turned: list[Turned] = fresh(factory=list)


def read_bodies(system: System, motion: Motion) -> list[Spatial]:
    """The recursions of T's forms along a motion: in space, and on the axes of bodies with a `rotation:` where others stand on
    them.  None where T has no points in space that turn, or others than these.
    """
    kinetic = whole_kinetic(system, system.graph.rate_of)
    squares = list_squares(system, kinetic) if kinetic is not None else []
    if kinetic is None or not any(len(group) > 1 for group in squares):
        return []
    g, rates = system.graph, Rates(system, motion)
    places = {k: place_of(g, kinetic.atoms[k]) for group in squares for k in group}
    own = [*kinetic.atoms, *(place for place, _ in places.values())]
    try:
        marks = Signatures(g, [*own, *rates.unbound.values()])
        marks.bind(rates.unbound)
        named = rates.named(own)
        if named is None:
            return []
        atoms, where = named[: len(kinetic.atoms)], dict(zip(places, named[len(kinetic.atoms) :], strict=True))
        frames = Frames(rates, marks)
        points = Points(frames, g.mask(system.p), where).read(squares)
        if not any(point.turns for _, point in points):
            return []
        signs = {k: sign for k, (_, sign) in places.items()}
        found = [_Writer(rates, kinetic, atoms, marks, frames, Carried(system, len(motion.w), {})).write(points, signs)]
        # each on a rotation of its own, in space: T's forms are over the kept velocities as they are written
        if system.rotations and not found[0].known:
            return []
    except (Unread, Unlucky, NotLinear):
        return []
    carriers = find_carriers(points)
    for direct in (True, False) if carriers else ():
        with suppress(Unread, NotLinear):
            carried = Carried(system, len(motion.w), carriers, direct=direct)
            found.append(_Writer(rates, kinetic, atoms, marks, frames, carried).write(points, signs))
            break
    return found


def _frames_of(points: Iterable[Point]) -> set[int]:
    """The axes on which the points' vectors are fixed, with those on which these turn."""
    found, over = set[int](), list(points)
    while over:
        point = over.pop()
        over += [point.base] if point.base is not None else []
        for frame, _ in point.arms:
            top: Frame | None = frame
            while top is not None and id(top) not in found:
                found.add(id(top))
                top = top.parent
    return found


class _Writer:
    """T's forms over the symbols of ``rates``, with what is ``carried`` on the axes of its rotation."""

    def __init__(
        self,
        rates: Rates,
        kinetic: Kinetic,
        atoms: Sequence[Node],
        marks: Signatures,
        frames: Frames,
        carried: Carried,
    ) -> None:
        self.rates, self.system, self.kinetic, self.atoms, self.marks = rates, rates.system, kinetic, atoms, marks
        self.graph: Graph = rates.graph
        self.frames, self._carried = frames, carried
        self._mask = self.graph.mask(self.system.p)

    # --- the recursion --------------------------------------------------------------------------------------

    def write(self, points: Sequence[tuple[Components, Point]], signs: dict[int, int]) -> Spatial:
        """Points from the root on, each frame when it is first needed; then T's other forms."""
        g, atoms = self.graph, self.atoms
        self.made = Spatial(self.kinetic, Recursion(len(self.rates.motion.w)))
        self._velocities: dict[Node, Terms] = {}
        self._variables: dict[int, Variables] = {}
        self._points: dict[int, Variables] = {}
        self._momenta: dict[Variables, tuple[Frame, Vector]] = {}
        of: dict[int, tuple[Frame, Vector, int]] = {}
        inside = {k for components, _ in points for k in components}
        names = self._angular(_frames_of(point for _, point in points))
        for k, atom in enumerate(atoms):
            if k not in inside:
                found = names.get(self.marks.of(atom)) or self._last(atom, names)
                if found is not None:
                    of[k] = found
        forms: list[Terms] = [{} for _ in atoms]
        in_space: dict[int, Terms] = {}
        waiting = dict(of)
        for components, point in points:
            variables = self._place(point)
            for axis, component in enumerate(components):
                if component is not None:
                    sign = g.number(signs[component])
                    forms[component] = {c: sign for c in variables[axis : axis + 1] if c != _STILL}
                    in_space[component] = {
                        c: g.mul(sign, a)
                        for c, a in zip(variables, self._carried.row(id(point), axis), strict=True)
                        if a != g.zero and c != _STILL
                    }
            near = {id(frame) for frame, _ in point.arms}
            for k in [k for k, (frame, _, _) in waiting.items() if id(frame) in near]:
                forms[k] = self._component(k, *waiting.pop(k))
        for k, atom in enumerate(atoms):
            if k in waiting:
                forms[k] = self._component(k, *waiting.pop(k))
            elif k not in inside and k not in of:
                forms[k] = self._plain(atom)
        for variables, (frame, momentum) in self._momenta.items():
            torque = self._put(cross(g, momentum, frame.omega))
            self.made.torques += [pair for pair in zip(variables, torque, strict=True) if pair[0] != _STILL]
        self.made.recursion.forms = [self._put_terms(terms) for terms in forms]
        self.made.placed = [in_space.get(k, terms) for k, terms in enumerate(self.made.recursion.forms)]
        self.made.turned = self._carried.turned(self.made.recursion)
        return self.made

    def _put(self, nodes: Sequence[Node]) -> list[Node]:
        """Vectors of what stands on a carrier have no entries of its matrix but those that are nodes already."""
        return self.rates.on_axes(nodes, self._carried.axes)

    def _put_terms(self, terms: Terms) -> Terms:
        return dict(zip(terms, self._put(list(terms.values())), strict=True))

    def _define(self, terms: Terms, constant: Node, turn: Node) -> int:
        """A variable; what is zero for all motions is told by :data:`_STILL`."""
        constant, turn = self._put([constant, turn])
        terms = {c: a for c, a in self._put_terms(terms).items() if a and c != _STILL}
        if not terms and not constant and not turn:
            return _STILL
        self.made.turns.append(turn)
        return self.made.recursion.define(terms, constant)

    def _velocity(self, symbol: Node) -> Terms:
        """A velocity as a kept one, or as a variable of its own."""
        if symbol not in self._velocities:
            g = self.graph
            terms, constant, turn = self.rates.form(symbol)
            plain = constant == g.zero and not any(g.deps[a] & ~self._mask for a in terms.values())
            if not plain or len(terms) > 1:
                number = self._define(terms, constant, turn)
                terms = {number: g.one} if number != _STILL else {}
            self._velocities[symbol] = terms
        return self._velocities[symbol]

    def _add_velocity(self, row: Terms, symbol: Node, coefficient: Node) -> None:
        g = self.graph
        for c, a in self._velocity(symbol).items() if coefficient != g.zero else ():
            row[c] = g.add(row.get(c, g.zero), g.mul(coefficient, a))

    def _place(self, point: Point) -> Variables:
        """The variables of a point's velocity, after those of the points below it."""
        below: list[Point] = []
        over: Point | None = point
        while over is not None and id(over) not in self._points:
            below.append(over)
            over = over.base
        for own in reversed(below):
            self._points[id(own)] = self._hang(own)
        return self._points[id(point)]

    def _hang(self, point: Point) -> Variables:
        g, base, carrier = self.graph, point.base, self._carried.carriers.get(id(point))
        near = base is not None and self._carried.carriers.get(id(base)) == carrier
        below = self._points[id(base)] if base is not None else None
        rows: list[Terms] = [{} if below is None or not near else {below[axis]: g.one} for axis in range(3)]
        constants, turns = list(ZERO), list(ZERO)
        for frame, d in point.arms:
            x, y, z = self._spin(frame)
            for row, one, two, first, second in ((0, y, z, 2, 1), (1, z, x, 0, 2), (2, x, y, 1, 0)):
                rows[row][one] = g.add(rows[row].get(one, g.zero), d[first])
                rows[row][two] = g.sub(rows[row].get(two, g.zero), d[second])
            drift = cross(g, frame.omega, cross(g, frame.omega, d))
            turns = [g.add(a, b) for a, b in zip(turns, drift, strict=True)]
        if carrier is None:
            self._add_loose(point.loose, rows, constants, turns)
            return self._define_three(rows, constants, turns)
        outer: list[Terms] = [{} if below is None or near else {below[axis]: g.one} for axis in range(3)]
        still, growth = list(ZERO), list(ZERO)
        self._add_loose(point.loose, outer, still, growth)
        turned = self._carried.turn(outer, still, growth, carrier)
        for axis, more in enumerate(turned.rows):
            rows[axis].update(more)
        turns = [g.add(a, b) for a, b in zip(turns, turned.turns, strict=True)]
        return self._define_three(rows, turned.constants, turns)

    def _add_loose(self, loose: Vector, rows: list[Terms], constants: list[Node], turns: list[Node]) -> None:
        """What moves in other ways than by turning, in space."""
        g, system = self.graph, self.system
        for axis, node in enumerate(loose):
            if node == g.zero:
                continue
            *slopes, constants[axis] = gradient(g, node, (*system.q, system.t))
            for v, a in zip(system.v, slopes, strict=True):
                self._add_velocity(rows[axis], v, a)
            rate = g.add(g.dot(slopes, system.v), constants[axis])
            turns[axis] = g.add(turns[axis], tangent(g, [rate], self.rates.seeds)[0])

    def _spin(self, frame: Frame) -> Variables:
        """The variables of a frame's angular velocity: on the last frame before it that has some."""
        if id(frame) in self._variables:
            return self._variables[id(frame)]
        g = self.graph
        rows: list[Terms] = [{}, {}, {}]
        constants, turns = list(ZERO), list(ZERO)
        top: Frame | None = frame
        while top is not None and top.parent is not None and id(top) not in self._variables:
            if self._is_seen_from_space(top) and top is not frame:
                self._spin(top)
                continue
            for spin in top.spins:
                rate = g.add(g.sum([g.mul(a, v) for v, a in spin.rates]), spin.own)
                tilt = scale_vector(g, rate, cross(g, top.parent.omega, spin.axis))
                growth = tangent(g, [rate], self.rates.seeds)[0]
                for axis in range(3):
                    for v, a in spin.rates:
                        self._add_velocity(rows[axis], v, g.mul(spin.axis[axis], a))
                    constants[axis] = g.add(constants[axis], g.mul(spin.axis[axis], spin.own))
                    turns[axis] = g.add(g.add(turns[axis], tilt[axis]), g.mul(spin.axis[axis], growth))
            top = top.parent
        if top is not None and id(top) in self._variables:
            for row, variable in zip(rows, self._variables[id(top)], strict=True):
                row[variable] = g.one
        if frame.rotation is not None and self._is_seen_from_space(frame):
            seen = self._carried.turn(rows, constants, turns, frame.rotation)
            rows, constants, turns = seen.rows, seen.constants, seen.turns
        self._variables[id(frame)] = self._define_three(rows, constants, turns)
        return self._variables[id(frame)]

    def _is_seen_from_space(self, frame: Frame) -> bool:
        """Whether the angular velocity of a carrier has its components in space."""
        return frame.rotation in self._carried.axes and self.system.rotations[frame.rotation].sign < 0

    def _define_three(self, rows: Sequence[Terms], constants: Sequence[Node], turns: Sequence[Node]) -> Variables:
        a, b, c = (self._define(row, k, turn) for row, k, turn in zip(rows, constants, turns, strict=True))
        return a, b, c

    # --- T's other forms ------------------------------------------------------------------------------------

    def _angular(self, used: set[int]) -> Named:
        """Signatures of the components of angular velocities along vectors that are fixed on the axes, with their signs."""
        found: Named = {}
        self._add_names(found, sorted(self.frames.fixed(), key=lambda pair: id(pair[0]) not in used))
        return found

    def _add_names(self, found: Named, fixed: Iterable[tuple[Frame, Vector]]) -> None:
        for frame, vector in fixed:
            mark = self.marks.of(self.graph.dot(vector, frame.omega))
            found.setdefault(mark, (frame, vector, 1))
            found.setdefault(self.marks.negative(mark), (frame, vector, -1))

    def _last(self, atom: Node, names: Named) -> tuple[Frame, Vector, int] | None:
        """A component of an angular velocity that alone tells of the last turn: no point stands beside its axis."""
        g, symbols = self.graph, self.rates.symbols
        if sum(a != g.zero for a in linear_form(g, atom, symbols)[0]) <= _FEW:
            return None
        angles = {g.a[node] for node in reachable(g, [atom], self.frames.moving) if g.op[node] in ("sin", "cos")}
        turned = sorted(angle for angle in angles if not self.frames.turns_by(angle))
        self._add_names(names, self.frames.spun_on(self.frames.fixed(), turned))
        return names.get(self.marks.of(atom))

    def _component(self, k: int, frame: Frame, vector: Vector, sign: int) -> Terms:
        """u . omega as a definition, with what it gives to omega: -omega x u times its momentum."""
        g = self.graph
        variables = self._spin(frame)
        self.made.known.add(k)
        slope = g.mul(g.number(sign), self.kinetic.slope[k])
        total = self._momenta.get(variables, (frame, ZERO))[1]
        self._momenta[variables] = frame, add_vectors(g, total, scale_vector(g, slope, vector))
        terms = {c: a for c, a in zip(variables, vector, strict=True) if c != _STILL and a != g.zero}
        if any(g.value(a) is None for a in terms.values()):
            terms = {self._define(terms, g.zero, g.zero): g.one}
        return {c: g.mul(g.number(sign), a) for c, a in terms.items()}

    def _plain(self, atom: Node) -> Terms:
        """Other forms, of few rates."""
        g, symbols = self.graph, self.rates.symbols
        coefficients, constant = linear_form(g, atom, symbols)
        coefficients = tuple(self.rates.on_motion(coefficients))
        (constant,) = self.rates.on_motion([constant])
        found = [(v, a) for v, a in zip(symbols, coefficients, strict=True) if a != g.zero]
        if len(found) > _FEW:
            raise Unread
        terms: Terms = {}
        for v, a in found:
            self._add_velocity(terms, v, a)
        if len(found) == 1 and constant == g.zero and not any(g.deps[a] & ~self._mask for a in terms.values()):
            return terms
        (turn,) = self.rates.on_motion(tangent(g, [atom], self.rates.seeds))
        number = self._define(terms, constant, turn)
        return {number: g.one} if number != _STILL else {}
