"""The mass matrix and the right side of a few bodies in space, each on its own axes: composite inertias, and forces by recursion.

A body and all that it carries are, for a turn at its joint, one rigid body: mass m, first moments h and inertia J about the joint,
ten numbers that are taken to the axes of the body before (M. W. Walker and D. E. Orin, J. Dyn. Syst. Meas. Control 104 (1982) 205).
A turn s asks for the force s x h and the moment J s at the joint, and what of these reaches the joints before are the entries of the
matrix.

Without the rates' rates, a body whose joint has the acceleration a takes m a + U h and J alpha + omega x J omega + h x a,
U = [alpha] + [omega]^2 (J. Y. S. Luh, M. W. Walker and R. P. C. Paul, J. Dyn. Syst. Meas. Control 102 (1980) 69).

For a few bodies this is shorter than articulated inertias (:mod:`nhc.mechanics.trees.tree`), which have 21 numbers each.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient, pullback_gradient, tangent
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.motion import Motion
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.bodies import Writer, find_writer
from nhc.mechanics.trees.chain import forces_of
from nhc.mechanics.trees.covectors import Sweeps
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Spin
from nhc.mechanics.trees.points import Point, Unread
from nhc.mechanics.trees.tensors import NONE, Tensor, add_product, add_tensors, move_inertia, times, turn_tensor
from nhc.mechanics.trees.views import Matrix, Views, between
from nhc.records import identity_record, record, structure


@record
class Assembled:
    """M w' = force."""

    mass: list[list[Node]]
    force: list[Node]


@structure
class _Load:
    """Mass, first moments and inertia about a link's origin, on its axes."""

    mass: Node = 0
    first: Vector = ZERO
    inertia: Tensor = NONE

    def add_point(self, graph: Graph, mass: Node, place: Vector) -> None:
        """A point mass."""
        self.inertia = move_inertia(graph, self.inertia, mass, ZERO, place)
        self.mass = graph.add(self.mass, mass)
        self.first = add_vectors(graph, self.first, scale_vector(graph, mass, place))

    def add(self, graph: Graph, other: _Load) -> None:
        """What is carried, too."""
        self.mass = graph.add(self.mass, other.mass)
        self.first = add_vectors(graph, self.first, other.first)
        self.inertia = add_tensors(graph, self.inertia, other.inertia)

    def turned(self, graph: Graph, matrix: Matrix) -> _Load:
        """On other axes."""
        return _Load(
            self.mass, times(graph, matrix, self.first), turn_tensor(graph, (matrix[0], matrix[1], matrix[2]), self.inertia)
        )

    def moved(self, graph: Graph, offset: Vector) -> _Load:
        """About a point from which the origin is ``offset``."""
        inertia = move_inertia(graph, self.inertia, self.mass, self.first, offset)
        return _Load(self.mass, add_vectors(graph, self.first, scale_vector(graph, self.mass, offset)), inertia)


@identity_record
class _Link:
    """Axes with an origin, which is ``offset`` on the axes of ``parent``; a root's is ``offset`` in space, and may move.

    ``joint`` has the turn by which they are turned on the parent's axes.
    """

    frame: Frame
    joint: Frame
    parent: _Link | None
    offset: Vector
    load: _Load


@identity_record
class _Turn:
    """What a velocity is at a link: a turn about ``axis``, or at a root a velocity along it; the velocity is number ``place`` of those
    kept, times ``factor``.
    """

    place: int
    factor: Node
    axis: Vector


@record
class _State:
    """Angular velocity, its rate, and the origin's acceleration, on a link's axes, where no rate changes."""

    omega: Vector
    alpha: Vector
    origin: Vector


@structure
class _Wrench:
    """Force, and moment about a link's origin, on its axes."""

    force: Vector = ZERO
    moment: Vector = ZERO

    def turned(self, graph: Graph, matrix: Matrix) -> _Wrench:
        """On other axes."""
        return _Wrench(times(graph, matrix, self.force), times(graph, matrix, self.moment))

    def moved(self, graph: Graph, offset: Vector) -> _Wrench:
        """About a point from which the origin is ``offset``."""
        return _Wrench(self.force, add_vectors(graph, self.moment, cross(graph, offset, self.force)))

    def add(self, graph: Graph, other: _Wrench) -> None:
        """The sum."""
        self.force = add_vectors(graph, self.force, other.force)
        self.moment = add_vectors(graph, self.moment, other.moment)


def assemble(system: System, motion: Motion) -> Assembled | None:
    """Of bodies in space that nothing holds; None where T has anything else, or its vectors are not read."""
    writer = find_writer(system, motion)
    if writer is None:
        return None
    try:
        return _Assembly(writer).assembled()
    except Unread:
        return None


class _Assembly:
    def __init__(self, writer: Writer) -> None:
        self.writer, self.rates, self.kinetic = writer, writer.rates, writer.kinetic
        self.graph: Graph = writer.graph
        self._views = Views(writer.frames, {})
        self._links: list[_Link] = []  # each after the one before it
        self._children: dict[tuple[int, int, Vector], _Link] = {}
        self._steps: dict[int, Matrix] = {}
        self._joints: dict[tuple[int, int], Frame] = {}
        self._places = {symbol: self._place(symbol) for symbol in self.rates.symbols}
        self._read_masses()
        self._read_inertias()

    def _place(self, symbol: Node) -> int:
        """The number of the kept velocity that a velocity is."""
        terms, constant, turn = self.rates.form(symbol)
        if list(terms.values()) != [self.graph.one] or constant != self.graph.zero or turn != self.graph.zero:
            raise Unread
        return next(iter(terms))

    # --- links and what they carry ------------------------------------------------------------------------------

    def _read_masses(self) -> None:
        g, hessian = self.graph, self.kinetic.hessian
        still = g.mask(self.writer.system.p)
        for row in hessian:
            if any(g.deps[h] & ~still for h in row):
                raise Unread
        plain = [g.sub(slope, g.dot(row, self.kinetic.u)) for slope, row in zip(self.kinetic.slope, hessian, strict=True)]
        if not all(are_zero(g, plain)):
            raise Unread
        for components, point in self.writer.points:
            k = next(k for k in components if k is not None)
            link, place = self._reach(point)
            link.load.add_point(g, hessian[k][k], place)

    def _read_inertias(self) -> None:
        g, angular, hessian = self.graph, self.writer.angular, self.kinetic.hessian
        for k, (frame, vector, factor) in angular.items():
            link = self._link_of(frame)
            for j, h in enumerate(hessian[k][: k + 1]):
                if h == g.zero:
                    continue
                if j not in angular or angular[j][0] is not frame:
                    raise Unread
                weight = g.mul(g.number(factor * angular[j][2] / (2 if j == k else 1)), h)
                x, y = (self._views.local(own, frame) for own in (vector, angular[j][1]))
                link.load.inertia = add_product(g, link.load.inertia, weight, x, y)
        plain = [k for k in range(len(hessian)) if k not in angular and k not in self.writer.inside]
        if any(hessian[k][j] != g.zero for k in plain for j in range(len(hessian)) if j not in plain):
            raise Unread
        self._plain = {k: self._read_plain(self.writer.atoms[k]) for k in plain}

    def _read_plain(self, atom: Node) -> tuple[list[tuple[int, Node]], Node]:
        """By the kept velocities, and the rate where these have none."""
        found, _ = self.writer.plain(atom)
        coefficients = self.rates.on_motion([a for _, a in found])
        terms = [(self._places[v], a) for (v, _), a in zip(found, coefficients, strict=True)]
        return terms, self.rates.on_motion(tangent(self.graph, [atom], self.rates.seeds))[0]

    def _reach(self, point: Point) -> tuple[_Link, Vector]:
        """The link that carries a point, and its place there."""
        g, arms, loose = self.graph, list[tuple[Frame, Vector]](), ZERO
        own: Point | None = point
        while own is not None:
            arms = [*own.arms, *arms]
            loose, own = add_vectors(g, loose, own.loose), own.base
        link, place = self._root(loose), ZERO
        for frame, vector in sorted(arms, key=self._order):
            for step, joint in self._way(link.frame, frame):
                link, place = self._child(link, step, joint, place), ZERO
            place = add_vectors(g, place, self._views.local(vector, frame))
        return link, place

    def _order(self, arm: tuple[Frame, Vector]) -> tuple[int, int]:
        """From the root on; of links that turn about parallel axes by sums of angles, the one with the fewest."""
        frame = arm[0]
        return frame.depth, 0 if frame.angle is None else self.graph.deps[frame.angle].bit_count()

    def _way(self, old: Frame, new: Frame) -> list[tuple[Frame, Frame]]:
        """The frames to another one, each with the turn from the one before it."""
        above = next((own for own in _with_parents(new) if own.parent is old.parent), None)
        if old is ROOT or above is None or above is old:
            return [(frame, frame) for frame in between(old, new)]
        return [(above, self._beside(old, above)), *((frame, frame) for frame in between(above, new))]

    def _beside(self, old: Frame, new: Frame) -> Frame:
        """A frame that turns about the same axis as the one it is counted from, by what its angle is more."""
        g, same = self.graph, old.angle is not None and new.angle is not None
        if not same or self.writer.frames.mark(old.spins[0].axis) != self.writer.frames.mark(new.spins[0].axis):
            raise Unread
        key = id(old), id(new)
        if key not in self._joints:
            (first,), (second,) = old.spins, new.spins
            rates = (*second.rates, *((v, g.neg(a)) for v, a in first.rates))
            total: dict[Node, Node] = {}
            for v, a in rates:
                total[v] = g.add(total.get(v, g.zero), a)
            left = tuple((v, a) for v, a in total.items() if a != g.zero)
            spin = Spin(second.axis, left, g.sub(second.own, first.own))
            angle = g.sub(new.angle or g.zero, old.angle or g.zero)
            self._joints[key] = Frame(old, (spin,), new.omega, old.depth + 1, angle)
        return self._joints[key]

    def _root(self, place: Vector) -> _Link:
        return self._made((0, 0, place), ROOT, ROOT, None)

    def _child(self, link: _Link, frame: Frame, joint: Frame, place: Vector) -> _Link:
        return self._made((id(link), id(frame), place), frame, joint, link)

    def _made(self, key: tuple[int, int, Vector], frame: Frame, joint: Frame, parent: _Link | None) -> _Link:
        if key not in self._children:
            self._children[key] = _Link(frame, joint, parent, key[2], _Load())
            self._links.append(self._children[key])
        return self._children[key]

    def _link_of(self, frame: Frame) -> _Link:
        """One with these axes, wherever its origin is."""
        found = next((link for link in self._links if link.frame is frame), None)
        if found is not None:
            return found
        if frame.parent is None:
            return self._root(ZERO)
        return self._child(self._link_of(frame.parent), frame, frame, ZERO)

    # --- along the motion ---------------------------------------------------------------------------------------

    def _step(self, frame: Frame) -> Matrix:
        """From a frame's axes to those of its parent, on the motion."""
        if id(frame) not in self._steps:
            matrix = self._views.step(frame)
            self._steps[id(frame)] = tuple((a, b, c) for a, b, c in map(self.rates.on_motion, matrix))
        return self._steps[id(frame)]

    def _spins_before(self, frame: Frame) -> bool:
        """Whether its spins are taken on the axes of its parent."""
        return self._views.axes_of_spins(frame, frame) is not frame

    def _turns(self, link: _Link) -> list[_Turn]:
        g, views, frame = self.graph, self._views, link.joint
        if link.parent is None:
            columns = [gradient(g, x, self.rates.system.q) for x in link.offset]
            moved = zip(self.rates.system.v, zip(*columns, strict=True), strict=True)
            return [_Turn(self._places[v], g.one, (x, y, z)) for v, (x, y, z) in moved if any((x, y, z))]
        at = views.axes_of_spins(frame, frame)
        found = []
        for spin in frame.spins:
            x, y, z = self.rates.on_motion(views.local(spin.axis, at))
            found += [_Turn(self._places[v], a, (x, y, z)) for v, a in spin.rates]
        return found

    def _states(self) -> dict[int, _State]:
        found: dict[int, _State] = {}
        for link in self._links:
            if link.parent is None:
                found[id(link)] = _State(ZERO, ZERO, self._fall(link))
                continue
            before, g = found[id(link.parent)], self.graph
            moved = self._spread(before, link.offset)
            here = _State(before.omega, before.alpha, add_vectors(g, before.origin, moved))
            first = self._spins_before(link.joint)
            here = self._spun(link.joint, here) if first else here
            back: Matrix = tuple((a, b, c) for a, b, c in zip(*self._step(link.joint), strict=True))
            here = _State(*(times(g, back, x) for x in (here.omega, here.alpha, here.origin)))
            found[id(link)] = here if first else self._spun(link.joint, here)
        return found

    def _fall(self, root: _Link) -> Vector:
        """The acceleration of a root's origin, against the field (J. le R. d'Alembert)."""
        g, system, found = self.graph, self.rates.system, list[Node]()
        for x, pull in zip(root.offset, self.writer.field or ZERO, strict=True):
            *slopes, own = gradient(g, x, (*system.q, system.t))
            rate = g.add(g.dot(slopes, system.v), own)
            turn = tangent(g, [rate], self.rates.seeds)
            found.append(g.sub(self.rates.on_motion(turn)[0], pull))
        return found[0], found[1], found[2]

    def _spun(self, frame: Frame, state: _State) -> _State:
        g, omega, alpha = self.graph, state.omega, state.alpha
        at = self._views.axes_of_spins(frame, frame)
        for spin in frame.spins:
            rate = g.add(g.sum([g.mul(a, v) for v, a in spin.rates]), spin.own)
            rate, growth = self.rates.on_motion([rate, *tangent(g, [rate], self.rates.seeds)])
            x, y, z = self.rates.on_motion(self._views.local(spin.axis, at))
            turn = scale_vector(g, rate, (x, y, z))
            tilt = cross(g, state.omega, turn)
            alpha = add_vectors(g, alpha, add_vectors(g, tilt, scale_vector(g, growth, (x, y, z))))
            omega = add_vectors(g, omega, turn)
        return _State(omega, alpha, state.origin)

    def _spread(self, state: _State, place: Vector) -> Vector:
        """U times a place."""
        g, (x, y, z), (a, b, c) = self.graph, state.omega, state.alpha
        xx, yy, zz = (g.power(w, 2) for w in state.omega)
        xy, yz, zx = g.mul(x, y), g.mul(y, z), g.mul(z, x)
        rows = (
            (g.neg(g.add(yy, zz)), g.sub(xy, c), g.add(zx, b)),
            (g.add(xy, c), g.neg(g.add(xx, zz)), g.sub(yz, a)),
            (g.sub(zx, b), g.add(yz, a), g.neg(g.add(xx, yy))),
        )
        return times(g, rows, place)

    # --- from the leaves to the roots ---------------------------------------------------------------------------

    def assembled(self) -> Assembled:
        """The matrix and the right side."""
        turns = {id(link): self._turns(link) for link in self._links}
        size = len(self.rates.motion.w)
        mass = [[self.graph.zero] * size for _ in range(size)]
        self._add_masses(mass, turns)
        taken = self._taken(turns)
        self._add_plain(mass, taken)
        forces = self._forces()
        return Assembled(mass, [self.graph.sub(f, b) for f, b in zip(forces, taken, strict=True)])

    def _add_plain(self, mass: list[list[Node]], taken: list[Node]) -> None:
        """T's other forms, a . w with the Hessian h: h a a^T, and h a times the rate."""
        g = self.graph
        for k, (terms, _) in self._plain.items():
            for j, (others, turn) in self._plain.items():
                h = self.kinetic.hessian[k][j]
                for i, a in terms if h != g.zero else ():
                    own = g.mul(h, a)
                    taken[i] = g.add(taken[i], g.mul(own, turn))
                    for o, b in others:
                        mass[i][o] = g.add(mass[i][o], g.mul(own, b))

    def _taken(self, turns: dict[int, list[_Turn]]) -> list[Node]:
        """What the masses take where no rate changes."""
        g, states, wrenches = self.graph, self._states(), dict[int, _Wrench]()
        taken = [g.zero] * len(self.rates.motion.w)
        for link in reversed(self._links):
            wrench, state = wrenches.pop(id(link), _Wrench()), states[id(link)]
            wrench.add(g, self._inertial(link.load, state))
            first = link.parent is not None and self._spins_before(link.joint)
            if link.parent is None or not first:
                self._give(taken, turns[id(link)], wrench, at_root=link.parent is None)
            if link.parent is None:
                continue
            wrench = wrench.turned(g, self._step(link.joint))
            if first:
                self._give(taken, turns[id(link)], wrench, at_root=False)
            wrenches.setdefault(id(link.parent), _Wrench()).add(g, wrench.moved(g, link.offset))
        return taken

    def _inertial(self, load: _Load, state: _State) -> _Wrench:
        g = self.graph
        force = add_vectors(g, scale_vector(g, load.mass, state.origin), self._spread(state, load.first))
        moment = cross(g, state.omega, times(g, load.inertia, state.omega))
        moment = add_vectors(g, moment, times(g, load.inertia, state.alpha))
        return _Wrench(force, add_vectors(g, moment, cross(g, load.first, state.origin)))

    def _give(self, taken: list[Node], turns: Sequence[_Turn], wrench: _Wrench, *, at_root: bool) -> None:
        g = self.graph
        for turn in turns:
            own = g.dot(turn.axis, wrench.force if at_root else wrench.moment)
            taken[turn.place] = g.add(taken[turn.place], g.mul(turn.factor, own))

    def _add_masses(self, mass: list[list[Node]], turns: dict[int, list[_Turn]]) -> None:
        g, loads = self.graph, {id(link): replace(link.load) for link in self._links}
        columns: dict[int, list[tuple[_Turn, _Wrench]]] = {}
        for link in reversed(self._links):
            load, held = loads[id(link)], columns.pop(id(link), [])
            if link.parent is None:
                self._join(mass, held, turns[id(link)], load, at_root=True)
                continue
            first, step = self._spins_before(link.joint), self._step(link.joint)
            if not first:
                self._join(mass, held, turns[id(link)], load, at_root=False)
            load, held = load.turned(g, step), [(turn, own.turned(g, step)) for turn, own in held]
            if first:
                self._join(mass, held, turns[id(link)], load, at_root=False)
            loads[id(link.parent)].add(g, load.moved(g, link.offset))
            columns.setdefault(id(link.parent), []).extend((turn, own.moved(g, link.offset)) for turn, own in held)

    def _join(
        self,
        mass: list[list[Node]],
        held: list[tuple[_Turn, _Wrench]],
        turns: Sequence[_Turn],
        load: _Load,
        *,
        at_root: bool,
    ) -> None:
        """The turns' wrenches to those that a link holds, and their entries with all of these."""
        g = self.graph
        for turn in turns:
            if at_root:
                own = _Wrench(scale_vector(g, load.mass, turn.axis), cross(g, load.first, turn.axis))
            else:
                own = _Wrench(cross(g, turn.axis, load.first), times(g, load.inertia, turn.axis))
            held.append((turn, own))
            for other, wrench in held:
                value = g.dot(turn.axis, wrench.force if at_root else wrench.moment)
                value = g.mul(g.mul(turn.factor, other.factor), value)
                for i, j in {(turn.place, other.place), (other.place, turn.place)}:
                    twice = turn is not other and turn.place == other.place
                    mass[i][j] = g.add(mass[i][j], g.mul(g.number(2), value) if twice else value)

    def _forces(self) -> list[Node]:
        """What pulls at the kept velocities besides."""
        g, kinetic, motion = self.graph, self.kinetic, self.rates.motion
        to_motion = moving(self.rates.system, motion.velocities)
        forms = substitute(g, kinetic.atoms, to_motion)
        to_motion.update(zip(kinetic.u, forms, strict=True))
        potential, places, _ = self.writer.weighed if self.writer.field is not None else (self.rates.system.U, {}, {})
        sweeps = Sweeps(self.rates.system, motion.velocities)
        pairs = forces_of(kinetic, sweeps, potential, places, to_motion, self.writer.angular)
        if pairs is None:
            raise Unread
        return pullback_gradient(g, pairs, motion.w)


def _with_parents(frame: Frame) -> Iterator[Frame]:
    over: Frame | None = frame
    while over is not None:
        yield over
        over = over.parent
