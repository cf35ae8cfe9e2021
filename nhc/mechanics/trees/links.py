"""Bodies in space as links: axes with an origin on those of the link before, and what they carry.

Points whose vectors begin alike stand on the same links.  Links that turn about parallel axes by sums of angles, whose axes are not
counted from one another, turn on each other by the difference.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.rotations.turns import Vector, add_vectors
from nhc.mechanics.trees.bodies import Writer
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Spin
from nhc.mechanics.trees.loads import Load
from nhc.mechanics.trees.points import Unread
from nhc.mechanics.trees.recursion import Terms
from nhc.mechanics.trees.sharing import Point
from nhc.mechanics.trees.tensors import add_product
from nhc.mechanics.trees.views import Views, between
from nhc.records import identity_record


@identity_record
class Link:
    """Axes with an origin, which is ``offset`` on the axes of ``parent``; a root's is ``offset`` in space, and may move.

    ``joint`` has the turn by which they are turned on the parent's axes.
    """

    frame: Frame
    joint: Frame
    parent: Link | None
    offset: Vector
    load: Load


@identity_record
class Turn:
    """What a velocity is at a link, a turn about ``axis``, or at a root a velocity along it: ``terms`` of the kept velocities."""

    terms: Terms
    axis: Vector


class Links:
    """Those of a system, and T's forms that no link has (``plain``: what they are of the kept velocities, and their rates where
    these have none).

    Raises:
        Unread: T has anything else, or its coefficients move.
    """

    def __init__(self, writer: Writer) -> None:
        self.writer, self.rates, self.kinetic = writer, writer.rates, writer.kinetic
        self.graph: Graph = writer.graph
        self.views = Views(writer.frames, {})
        self.links: list[Link] = []  # each after the one before it
        self._children: dict[tuple[int, int, Vector], Link] = {}
        self._joints: dict[tuple[int, int], Frame] = {}
        made = {symbol: self.rates.form(symbol) for symbol in self.rates.symbols}
        self._terms = {symbol: terms for symbol, (terms, _, _) in made.items()}
        self.seeds = {**self.rates.seeds, **{symbol: turn for symbol, (_, _, turn) in made.items()}}
        self._read_masses()
        self._read_inertias()

    def _by_kept(self, parts: Iterable[tuple[Node, Node]]) -> Terms:
        """A sum of velocities times what is on the motion, by the kept velocities."""
        g, terms = self.graph, dict[int, Node]()
        for symbol, factor in parts:
            for i, a in self._terms[symbol].items():
                terms[i] = g.add(terms.get(i, g.zero), g.mul(factor, a))
        return terms

    # --- links and what they carry ------------------------------------------------------------------------------

    def _read_masses(self) -> None:
        g, hessian = self.graph, self.kinetic.hessian
        still = g.mask(self.writer.system.p)
        for row in hessian:
            if any(g.deps[h] & ~still for h in row):
                raise Unread
        plain = [
            g.sub(slope, g.dot(row, self.kinetic.u)) for slope, row in zip(self.kinetic.slope, hessian, strict=True)
        ]
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
                x, y = (self.views.local(own, frame) for own in (vector, angular[j][1]))
                link.load.inertia = add_product(g, link.load.inertia, weight, x, y)
        plain = [k for k in range(len(hessian)) if k not in angular and k not in self.writer.inside]
        if any(hessian[k][j] != g.zero for k in plain for j in range(len(hessian)) if j not in plain):
            raise Unread
        self.plain = {k: self._read_plain(self.writer.atoms[k]) for k in plain}

    def _read_plain(self, atom: Node) -> tuple[Terms, Node]:
        """By the kept velocities, and the rate where these have none."""
        found, _ = self.writer.plain(atom)
        coefficients = self.rates.on_motion([a for _, a in found])
        terms = self._by_kept((v, a) for (v, _), a in zip(found, coefficients, strict=True))
        return terms, self.rates.on_motion(tangent(self.graph, [atom], self.seeds))[0]

    def _reach(self, point: Point) -> tuple[Link, Vector]:
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
            place = add_vectors(g, place, self.views.local(vector, frame))
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

    def _root(self, place: Vector) -> Link:
        return self._made((0, 0, place), ROOT, ROOT, None)

    def _child(self, link: Link, frame: Frame, joint: Frame, place: Vector) -> Link:
        return self._made((id(link), id(frame), place), frame, joint, link)

    def _made(self, key: tuple[int, int, Vector], frame: Frame, joint: Frame, parent: Link | None) -> Link:
        if key not in self._children:
            self._children[key] = Link(frame, joint, parent, key[2], Load())
            self.links.append(self._children[key])
        return self._children[key]

    def _link_of(self, frame: Frame) -> Link:
        """One with these axes, wherever its origin is."""
        found = next((link for link in self.links if link.frame is frame), None)
        if found is not None:
            return found
        if frame.parent is None:
            return self._root(ZERO)
        return self._child(self._link_of(frame.parent), frame, frame, ZERO)

    def turns(self, link: Link) -> list[Turn]:
        g, views, frame = self.graph, self.views, link.joint
        if link.parent is None:
            columns = [gradient(g, x, self.rates.system.q) for x in link.offset]
            moved = zip(self.rates.system.v, zip(*columns, strict=True), strict=True)
            return [Turn(self._by_kept([(v, g.one)]), (x, y, z)) for v, (x, y, z) in moved if any((x, y, z))]
        at = views.axes_of_spins(frame, frame)
        found = []
        for spin in frame.spins:
            x, y, z = self.rates.on_motion(views.local(spin.axis, at))
            terms = self._by_kept(spin.rates)
            found += [Turn(terms, (x, y, z))] if terms else []
        return found


def _with_parents(frame: Frame) -> Iterator[Frame]:
    over: Frame | None = frame
    while over is not None:
        yield over
        over = over.parent
