"""The velocities of points and axes as a recursion, on the axes of their views.

A point that is fixed at d on axes with omega, beside a point B, has B' + omega x d.  With the rates' own rates left out, B'' has
omega x (omega x d) added, and omega' gets omega_before x n a' of a turn about n.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Spin
from nhc.mechanics.trees.points import Unread
from nhc.mechanics.trees.rates import Rates
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.mechanics.trees.sharing import Point
from nhc.mechanics.trees.views import Triple, Views

Variables = tuple[int, int, int]
STILL = -1
"""In the place of a variable that is zero for all motions."""


class Velocities:
    """``turns`` are the rates of the recursion's definitions where those they are made of have none; ``field`` is what pulls at all
    masses.
    """

    def __init__(self, rates: Rates, views: Views, field: Vector | None) -> None:
        self.rates, self.system, self._views, self._field = rates, rates.system, views, field
        self.graph: Graph = rates.graph
        self.recursion = Recursion(len(rates.motion.w))
        self.turns: list[Node] = []
        self._mask = self.graph.mask(self.system.p)
        self._velocities: dict[Node, Terms] = {}
        self._variables: dict[int, Variables] = {}
        self._omegas: dict[int, Vector] = {}
        self._points: dict[int, Variables] = {}
        self._seen: dict[tuple[int, int], Variables] = {}
        self._offsets: dict[int, Node] = {}
        self._resting: set[int] = {STILL}

    def on_motion(self, terms: Terms) -> Terms:
        """Coefficients over coordinates and kept velocities."""
        return dict(zip(terms, self.rates.on_motion(list(terms.values())), strict=True))

    def define(self, terms: Terms, constant: Node, turn: Node) -> int:
        """A variable; what is zero for all motions is told by :data:`STILL`."""
        constant, turn = self.rates.on_motion([constant, turn])
        terms = {c: a for c, a in self.on_motion(terms).items() if a and c != STILL}
        if not terms and not constant and not turn:
            return STILL
        self.turns.append(turn)
        return self.recursion.define(terms, constant)

    def rests(self, variable: int) -> bool:
        """Whether a variable is zero for all motions."""
        return variable in self._resting

    def list_offsets(self) -> list[Node]:
        """The accelerations that stand for the field, of all definitions; none where there is no field."""
        numbers = range(self.recursion.rates, self.recursion.size)
        return [self._offsets.get(number, self.graph.zero) for number in numbers] if self._field is not None else []

    def _velocity(self, symbol: Node) -> Terms:
        """A velocity as a kept one, or as a variable of its own."""
        if symbol not in self._velocities:
            g = self.graph
            terms, constant, turn = self.rates.form(symbol)
            plain = constant == g.zero and not any(g.deps[a] & ~self._mask for a in terms.values())
            if not plain or len(terms) > 1:
                number = self.define(terms, constant, turn)
                terms = {number: g.one} if number != STILL else {}
            self._velocities[symbol] = terms
        return self._velocities[symbol]

    def add(self, row: Terms, symbol: Node, coefficient: Node) -> None:
        """A velocity with its coefficient, to what is being defined."""
        g = self.graph
        for c, a in self._velocity(symbol).items() if coefficient != g.zero else ():
            row[c] = g.add(row.get(c, g.zero), g.mul(coefficient, a))

    def place(self, point: Point) -> Variables:
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
        g, views, view = self.graph, self._views, self._views.of_point(point)
        below = self._see(point.base, view) if point.base is not None else None
        made = self._held(below)
        for frame, vector in point.arms:
            x, y, z = self.spin(frame)
            own = views.of(frame)
            d, omega = views.local(vector, own), self._omegas[id(frame)]
            arm = made if own is view else self._held()
            for row, one, two, first, second in ((0, y, z, 2, 1), (1, z, x, 0, 2), (2, x, y, 1, 0)):
                arm.rows[row][one] = g.add(arm.rows[row].get(one, g.zero), d[first])
                arm.rows[row][two] = g.sub(arm.rows[row].get(two, g.zero), d[second])
            drift = cross(g, omega, cross(g, omega, d))
            arm.turns = [g.add(a, b) for a, b in zip(arm.turns, drift, strict=True)]
            if arm is not made:
                made = made.plus(g, views.shift(arm, own, view))
        if view is ROOT:
            self._add_loose(point.loose, made)
        else:
            loose = self._held()
            self._add_loose(point.loose, loose)
            made = made.plus(g, views.settle(loose, view))
        variables = self._define_three(made)
        return variables if self._field is None or below is not None else self._lift(variables, view)

    def _lift(self, variables: Variables, view: Frame) -> Variables:
        """A point that stands on no other is accelerated against the field (d'Alembert), also where it is at rest."""
        g, found = self.graph, []
        for variable, column in zip(variables, zip(*self._views.on_motion(view), strict=True), strict=True):
            lift = g.neg(g.dot(column, self._field or ZERO))
            if lift != g.zero and variable == STILL:
                self.turns.append(g.zero)
                variable = self.recursion.define({}, g.zero)
                self._resting.add(variable)
            self._offsets[variable] = lift
            found.append(variable)
        return found[0], found[1], found[2]

    def _see(self, point: Point, view: Frame) -> Variables:
        """A point's velocity on the axes of a view."""
        own, key = self._views.of_point(point), (id(point), id(view))
        if own is view:
            return self._points[id(point)]
        if view.parent is None:
            raise Unread
        if key not in self._seen:  # one turn at a time: each has few entries
            made = self._held(self._see(point, view.parent))
            if self._views.of(view) is view:
                self.spin(view)  # beside what turns with it
            self._seen[key] = self._define_three(self._views.shift(made, view.parent, view))
        return self._seen[key]

    def _held(self, variables: Variables | None = None) -> Triple:
        """These variables alone, or nothing."""
        rows: list[Terms] = [{}, {}, {}] if variables is None else [{c: self.graph.one} for c in variables]
        return Triple(rows, list(ZERO), list(ZERO))

    def _add_loose(self, loose: Vector, made: Triple) -> None:
        """What moves in other ways than by turning, in space."""
        g, system = self.graph, self.system
        for axis, node in enumerate(loose):
            if node == g.zero:
                continue
            *slopes, made.constants[axis] = gradient(g, node, (*system.q, system.t))
            for v, a in zip(system.v, slopes, strict=True):
                self.add(made.rows[axis], v, a)
            rate = g.add(g.dot(slopes, system.v), made.constants[axis])
            made.turns[axis] = g.add(made.turns[axis], tangent(g, [rate], self.rates.seeds)[0])

    def omega(self, frame: Frame) -> Vector:
        """The angular velocity of a frame that has variables, on the axes of its view."""
        return self._omegas[id(frame)]

    def spin(self, frame: Frame) -> Variables:
        """The variables of a frame's angular velocity: on the last frame before it that has some."""
        if id(frame) in self._variables:
            return self._variables[id(frame)]
        views, view = self._views, self._views.of(frame)
        before = frame.parent
        if view is frame and before is not None and before is not ROOT and views.of(before) is before:
            self.spin(before)  # one turn at a time, as points
        path: list[Frame] = []
        top = frame
        while top.parent is not None and id(top) not in self._variables:
            path.append(top)
            top = top.parent
        axes, omega = views.of(top), self._omegas.get(id(top), ZERO)
        made = self._held(self._variables.get(id(top)))
        waiting: list[tuple[Frame, Vector]] = []
        for own in reversed(path):
            at = views.axes_of_spins(own, view)
            if at is not axes:
                made = views.shift(self._with_spins(waiting, axes, made), axes, at)
                omega, axes, waiting = views.shift_vector(omega, axes, at), at, []
            waiting.append((own, omega))
            for spin in own.spins:
                turned = scale_vector(self.graph, self._rate(spin), views.local(spin.axis, at))
                omega = add_vectors(self.graph, omega, turned)
        made = self._with_spins(waiting, axes, made)
        made = views.settle(made, view) if axes is ROOT else views.shift(made, axes, view)
        self._omegas[id(frame)] = views.shift_vector(omega, axes, view)
        self._variables[id(frame)] = self._define_three(made)
        return self._variables[id(frame)]

    def _rate(self, spin: Spin) -> Node:
        g = self.graph
        return g.add(g.sum([g.mul(a, v) for v, a in spin.rates]), spin.own)

    def _with_spins(self, waiting: Sequence[tuple[Frame, Vector]], axes: Frame, below: Triple) -> Triple:
        """The spins of frames, each with the angular velocity before it, on what they turn on."""
        g, made = self.graph, self._held()
        for frame, omega in reversed(waiting):
            for spin in frame.spins:
                rate, along = self._rate(spin), self._views.local(spin.axis, axes)
                tilt = scale_vector(g, rate, cross(g, omega, along))
                growth = tangent(g, [rate], self.rates.seeds)[0]
                for axis in range(3):
                    for v, a in spin.rates:
                        self.add(made.rows[axis], v, g.mul(along[axis], a))
                    made.constants[axis] = g.add(made.constants[axis], g.mul(along[axis], spin.own))
                    made.turns[axis] = g.add(g.add(made.turns[axis], tilt[axis]), g.mul(along[axis], growth))
        return made.plus(g, below)

    def _define_three(self, made: Triple) -> Variables:
        a, b, c = (
            self.define(row, k, turn) for row, k, turn in zip(made.rows, made.constants, made.turns, strict=True)
        )
        return a, b, c
