"""The mass matrix and the right side of a few bodies in space, each on its own axes: composite inertias, and forces by recursion.

A body and all that it carries are, for a turn at its joint, one rigid body: mass m, first moments h and inertia J about the
joint, ten numbers that are taken to the axes of the body before (M. W. Walker and D. E. Orin, J. Dyn. Syst. Meas. Control 104
(1982) 205).  A turn s asks for the force s x h and the moment J s at the joint, and what of these reaches the joints before are
the entries of the matrix.

Without the rates' rates, a body whose joint has the acceleration a takes m a + U h and J alpha + omega x J omega + h x a,
U = [alpha] + [omega]^2 (J. Y. S. Luh, M. W. Walker and R. P. C. Paul, J. Dyn. Syst. Meas. Control 102 (1980) 69).

For a few bodies this is shorter than articulated inertias (:mod:`nhc.mechanics.trees.tree`), which have 21 numbers each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient, pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.linear import NotLinear
from nhc.mechanics.motion import Motion
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.bodies import Writer, find_writer
from nhc.mechanics.trees.chain import forces_of, on_motion
from nhc.mechanics.trees.covectors import Sweeps
from nhc.mechanics.trees.frames import ZERO, Frame
from nhc.mechanics.trees.links import Link, Links, Turn
from nhc.mechanics.trees.loads import Load, Wrench
from nhc.mechanics.trees.points import Unread
from nhc.mechanics.trees.recursion import Terms
from nhc.mechanics.trees.tensors import times
from nhc.mechanics.trees.views import Matrix
from nhc.records import record


@record
class Assembled:
    """M w' = force; ``residual`` is force - M w' of any rates w', by the recursion alone."""

    mass: list[list[Node]]
    force: list[Node]
    residual: Callable[[Sequence[Node]], list[Node]]


@record
class _State:
    """Angular velocity, its rate, and the origin's acceleration, on a link's axes."""

    omega: Vector
    alpha: Vector
    origin: Vector


def assemble(system: System, motion: Motion) -> Assembled | None:
    """Of bodies in space; None where T has vectors that are not read, or forms of many velocities beside them."""
    writer = find_writer(system, motion)
    if writer is None:
        return None
    try:
        return _Assembly(writer).assembled()
    except (Unread, NotLinear):
        return None


class _Assembly:
    def __init__(self, writer: Writer) -> None:
        self.writer, self.rates, self.kinetic = writer, writer.rates, writer.kinetic
        self.graph: Graph = writer.graph
        self._made = Links(writer)
        self._steps: dict[int, Matrix] = {}
        self._turns = {id(link): self._made.turns(link) for link in self._made.links}

    # --- along the motion ---------------------------------------------------------------------------------------

    def _step(self, frame: Frame) -> Matrix:
        """From a frame's axes to those of its parent, on the motion."""
        if id(frame) not in self._steps:
            matrix = self._made.views.step(frame)
            self._steps[id(frame)] = tuple((a, b, c) for a, b, c in map(self.rates.on_motion, matrix))
        return self._steps[id(frame)]

    def _spins_before(self, frame: Frame) -> bool:
        """Whether its spins are taken on the axes of its parent."""
        return self._made.views.axes_of_spins(frame, frame) is not frame

    def _states(self, rates: Sequence[Node]) -> dict[int, _State]:
        found: dict[int, _State] = {}
        for link in self._made.links:
            if link.parent is None:
                found[id(link)] = _State(ZERO, ZERO, self._driven(self._fall(link), link, rates))
                continue
            before, g = found[id(link.parent)], self.graph
            moved = self._spread(before, link.offset)
            here = _State(before.omega, before.alpha, add_vectors(g, before.origin, moved))
            first = self._spins_before(link.joint)
            here = self._spun(link, here, rates) if first else here
            back: Matrix = tuple((a, b, c) for a, b, c in zip(*self._step(link.joint), strict=True))
            here = _State(*(times(g, back, x) for x in (here.omega, here.alpha, here.origin)))
            found[id(link)] = here if first else self._spun(link, here, rates)
        return found

    def _driven(self, vector: Vector, link: Link, rates: Sequence[Node]) -> Vector:
        """With what the rates of the kept velocities give."""
        g = self.graph
        for turn in self._turns[id(link)]:
            rate = g.sum([g.mul(a, rates[i]) for i, a in turn.terms.items()])
            vector = add_vectors(g, vector, scale_vector(g, rate, turn.axis))
        return vector

    def _fall(self, root: Link) -> Vector:
        """The acceleration of a root's origin, against the field (J. le R. d'Alembert)."""
        g, system, found = self.graph, self.rates.system, list[Node]()
        for x, pull in zip(root.offset, self.writer.field or ZERO, strict=True):
            *slopes, own = gradient(g, x, (*system.q, system.t))
            rate = g.add(g.dot(slopes, system.v), own)
            turn = tangent(g, [rate], self._made.seeds)
            found.append(g.sub(self.rates.on_motion(turn)[0], pull))
        return found[0], found[1], found[2]

    def _spun(self, link: Link, state: _State, rates: Sequence[Node]) -> _State:
        g, omega, alpha, frame = self.graph, state.omega, state.alpha, link.joint
        at = self._made.views.axes_of_spins(frame, frame)
        for spin in frame.spins:
            rate = g.add(g.sum([g.mul(a, v) for v, a in spin.rates]), spin.own)
            rate, growth = self.rates.on_motion([rate, *tangent(g, [rate], self._made.seeds)])
            x, y, z = self.rates.on_motion(self._made.views.local(spin.axis, at))
            turn = scale_vector(g, rate, (x, y, z))
            tilt = cross(g, state.omega, turn)
            alpha = add_vectors(g, alpha, add_vectors(g, tilt, scale_vector(g, growth, (x, y, z))))
            omega = add_vectors(g, omega, turn)
        return _State(omega, self._driven(alpha, link, rates), state.origin)

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
        g, size = self.graph, len(self.rates.motion.w)
        mass = [[g.zero] * size for _ in range(size)]
        self._add_masses(mass)
        for terms, others, h, _ in self._plain():
            for i, a in terms.items():
                for o, b in others.items():
                    mass[i][o] = g.add(mass[i][o], g.mul(g.mul(h, a), b)) if i <= o else mass[i][o]
        mass = [[mass[min(i, j)][max(i, j)] for j in range(size)] for i in range(size)]
        forces = self._forces()

        def residual(rates: Sequence[Node]) -> list[Node]:
            return [g.sub(f, b) for f, b in zip(forces, self._taken(rates), strict=True)]

        return Assembled(mass, residual([g.zero] * size), residual)

    def _plain(self) -> Iterator[tuple[Terms, Terms, Node, Node]]:
        """Pairs of T's other forms, with their entry of the Hessian and the rate of the second where no rate changes."""
        for k, (terms, _) in self._made.plain.items():
            for j, (others, turn) in self._made.plain.items():
                if self.kinetic.hessian[k][j] != self.graph.zero:
                    yield terms, others, self.kinetic.hessian[k][j], turn

    def _taken(self, rates: Sequence[Node]) -> list[Node]:
        """What the masses take at these rates."""
        g, turns, states, wrenches = self.graph, self._turns, self._states(rates), dict[int, Wrench]()
        taken = [g.zero] * len(rates)
        for terms, others, h, turn in self._plain():
            grown = g.add(turn, g.sum([g.mul(b, rates[o]) for o, b in others.items()]))
            for i, a in terms.items():
                taken[i] = g.add(taken[i], g.mul(g.mul(h, a), grown))
        for link in reversed(self._made.links):
            wrench, state = wrenches.pop(id(link), Wrench()), states[id(link)]
            wrench.add(g, self._inertial(link.load, state))
            first = link.parent is not None and self._spins_before(link.joint)
            if link.parent is None or not first:
                self._give(taken, turns[id(link)], wrench, at_root=link.parent is None)
            if link.parent is None:
                continue
            wrench = wrench.turned(g, self._step(link.joint))
            if first:
                self._give(taken, turns[id(link)], wrench, at_root=False)
            wrenches.setdefault(id(link.parent), Wrench()).add(g, wrench.moved(g, link.offset))
        return taken

    def _inertial(self, load: Load, state: _State) -> Wrench:
        g = self.graph
        force = add_vectors(g, scale_vector(g, load.mass, state.origin), self._spread(state, load.first))
        moment = cross(g, state.omega, times(g, load.inertia, state.omega))
        moment = add_vectors(g, moment, times(g, load.inertia, state.alpha))
        return Wrench(force, add_vectors(g, moment, cross(g, load.first, state.origin)))

    def _give(self, taken: list[Node], turns: Sequence[Turn], wrench: Wrench, *, at_root: bool) -> None:
        g = self.graph
        for turn in turns:
            own = g.dot(turn.axis, wrench.force if at_root else wrench.moment)
            for i, a in turn.terms.items():
                taken[i] = g.add(taken[i], g.mul(a, own))

    def _add_masses(self, mass: list[list[Node]]) -> None:
        turns = self._turns
        g, loads = self.graph, {id(link): replace(link.load) for link in self._made.links}
        columns: dict[int, list[tuple[Turn, Wrench]]] = {}
        for link in reversed(self._made.links):
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
        held: list[tuple[Turn, Wrench]],
        turns: Sequence[Turn],
        load: Load,
        *,
        at_root: bool,
    ) -> None:
        """The turns' wrenches to those that a link holds, and their entries with all of these."""
        g = self.graph
        for turn in turns:
            if at_root:
                own = Wrench(scale_vector(g, load.mass, turn.axis), cross(g, load.first, turn.axis))
            else:
                own = Wrench(cross(g, turn.axis, load.first), times(g, load.inertia, turn.axis))
            held.append((turn, own))
            for other, wrench in held:
                value = g.dot(turn.axis, wrench.force if at_root else wrench.moment)
                for i, a in turn.terms.items():
                    for j, b in other.terms.items():
                        if turn is other and j < i:
                            continue
                        entry, (low, high) = g.mul(g.mul(a, b), value), sorted((i, j))
                        twice = g.number(2 if turn is not other and i == j else 1)
                        mass[low][high] = g.add(mass[low][high], g.mul(twice, entry))

    def _forces(self) -> list[Node]:
        """What pulls at the kept velocities besides."""
        g, kinetic, motion = self.graph, self.kinetic, self.rates.motion
        _, to_motion = on_motion(kinetic, motion)
        potential, places, _ = self.writer.weighed if self.writer.field is not None else (self.rates.system.U, {}, {})
        sweeps = Sweeps(self.rates.system, motion.velocities)
        pairs = forces_of(kinetic, sweeps, potential, places, to_motion, self.writer.angular)
        if pairs is None:
            raise Unread
        return pullback_gradient(g, pairs, motion.w)
