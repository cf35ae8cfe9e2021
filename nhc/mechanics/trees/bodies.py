"""Rigid bodies as a recursion: angular velocities and points in place of the derivatives of matrices.

T's points and axes have the velocities of :mod:`nhc.mechanics.trees.velocities`; its components of an angular velocity are
u . omega with vectors u fixed on the body, and nothing is added to their rates.  The equations of rotation take -omega x L, L = sum
of the momenta along the u (L. Euler), for which no form has to be differentiated.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from fractions import Fraction

from nhc.algebra.calculus import tangent
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import split_parameters
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.energies.whole_forms import whole_kinetic
from nhc.mechanics.motion import Motion
from nhc.mechanics.moving.signatures import Signatures
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Frames
from nhc.mechanics.trees.points import Components, Points, Unread
from nhc.mechanics.trees.rates import Rates
from nhc.mechanics.trees.recursion import Recursion, Terms
from nhc.mechanics.trees.sharing import Point
from nhc.mechanics.trees.triples import list_squares, place_of
from nhc.mechanics.trees.velocities import STILL, Variables, Velocities
from nhc.mechanics.trees.views import Turned, Views, list_views
from nhc.mechanics.trees.weight import Weighed, field_of, on_points, weigh, weigh_together
from nhc.records import fresh, structure

_FEW = 3  # coordinates of what moves in another way than by turning
_TILTS = 2  # turns at its end of which no point of a body tells


Named = dict[tuple[int, ...], tuple[Frame, Vector, Fraction]]


@structure
class Spatial:
    """``turns`` are the rates of the recursion's definitions where those they are made of have none; ``torques`` what the forms
    that are ``known`` give to the variables beside the rates of T's slopes.

    ``placed`` says what T's forms are of the variables as they are written; the recursion's forms may be their components on other
    axes, which have the same squares.  ``turned`` are the variables that are no rates; ``offsets`` the accelerations of the
    definitions that stand for weight, where it is the same for all masses.
    """

    kinetic: Kinetic
    recursion: Recursion
    turns: list[Node] = fresh(factory=list)
    torques: list[tuple[int, Node]] = fresh(factory=list)
    known: set[int] = fresh(factory=set)
    placed: list[Terms] = fresh(factory=list)
    turned: list[Turned] = fresh(factory=list)
    offsets: list[Node] = fresh(factory=list)
    weighed: Weighed | None = None


def read_bodies(system: System, motion: Motion, *, every: bool = False) -> list[Spatial]:
    """The recursions of T's forms along a motion on the axes of the body that carries the others, and on those of each; in space
    where these are not to be had, or with ``every``.

    None where T has no points in space that turn, or others than these.
    """
    writer = find_writer(system, motion)
    # each on a rotation of its own, in space: T's forms are over the kept velocities as they are written
    if writer is None or (system.rotations and not writer.turning):
        return []
    views = writer.views() if "own axes" not in system.graph.off else []
    found = [made for own in views if (made := _write(writer, own, (True, False))) is not None]
    in_space = _write(writer, {}, (False,)) if every or not found else None
    return [*found, *([in_space] if in_space is not None else [])]


def find_writer(system: System, motion: Motion) -> Writer | None:
    """T's forms as points and as components of angular velocities."""
    known: list[tuple[System, tuple[Node, ...], Writer | None]] = system.graph.memory.setdefault("bodies", [])
    moved = (*motion.w, *motion.velocities)
    for owner, same, writer in known:
        if owner is system and same == moved:
            return writer
    known.append((system, moved, _read_writer(system, motion)))
    return known[-1][2]


def _read_writer(system: System, motion: Motion) -> Writer | None:
    kinetic = whole_kinetic(system, system.graph.rate_of)
    squares = list_squares(system, kinetic) if kinetic is not None else []
    if kinetic is None or not any(len(group) > 1 for group in squares):
        return None
    g, rates = system.graph, Rates(system, motion)
    places = {k: place_of(g, kinetic.atoms[k]) for group in squares for k in group}
    own = [*kinetic.atoms, *(place for place, _ in places.values())]
    try:
        marks = Signatures(g, [*own, *rates.unbound.values()])
        marks.bind(rates.unbound)
        named = rates.named(own)
        if named is None:
            return None
        atoms, where = named[: len(kinetic.atoms)], dict(zip(places, named[len(kinetic.atoms) :], strict=True))
        frames = Frames(rates, marks)
        points = Points(frames, g.mask(system.p), where).read(squares)
        if not any(point.turns for _, point in points):
            return None
        signs = {k: sign for k, (_, sign) in places.items()}
        return Writer(rates, kinetic, atoms, marks, frames, points, signs)
    except (Unread, Unlucky, NotLinear):
        return None


def _write(writer: Writer, views: dict[int, Frame], ways: Sequence[bool]) -> Spatial | None:
    """The recursion on these views, direct where it can be."""
    for direct in ways:
        with suppress(Unread, NotLinear):
            return writer.write(Views(writer.frames, views, direct=direct))
    return None


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


def _depth(placed: tuple[Components, Point]) -> int:
    return max((frame.depth for frame, _ in placed[1].arms), default=0)


def _without_number(graph: Graph, atom: Node) -> tuple[Fraction, Node]:
    """A form as a number times another: a quaternion's angular velocity is twice a sum of its rates."""
    outer, rest = split_parameters(graph, atom, 0)
    return outer.number, rest


class Writer:
    """T's forms over the symbols of ``rates``: ``points`` with the forms that are their components (``inside``), and ``angular``,
    the components of angular velocities along vectors on frames, with a factor; ``field`` is what pulls at all masses.
    """

    def __init__(
        self,
        rates: Rates,
        kinetic: Kinetic,
        atoms: Sequence[Node],
        marks: Signatures,
        frames: Frames,
        points: Sequence[tuple[Components, Point]],
        signs: dict[int, int],
    ) -> None:
        self.rates, self.system, self.kinetic, self.atoms, self.marks = rates, rates.system, kinetic, atoms, marks
        self.graph: Graph = rates.graph
        self.frames, self.points, self.signs = frames, points, signs
        self._mask = self.graph.mask(self.system.p)
        read = [components for components, _ in points]
        self.weighed = on_points(self.graph, weigh(self.system, kinetic, coordinates=True), read)
        self.field = field_of(kinetic, read, signs, self.weighed[2])
        together = weigh_together(self.system, kinetic, read, signs) if self.field is None else None
        if together is not None:
            self.weighed, self.field = together, field_of(kinetic, read, signs, together[2])
        self.inside = {k for components, _ in points for k in components}
        self.angular: dict[int, tuple[Frame, Vector, Fraction]] = {}
        names = self._angular(_frames_of(point for _, point in points))
        for k, atom in enumerate(atoms):
            if k not in self.inside:
                number, bare = _without_number(self.graph, atom)
                found = names.get(self.marks.of(bare)) or self._last(bare, names)
                if found is not None:
                    self.angular[k] = *found[:2], found[2] * number

    @property
    def turning(self) -> bool:
        """Whether T has components of angular velocities."""
        return bool(self.angular)

    def views(self) -> list[dict[int, Frame]]:
        """The axes on which the recursion may be written beside those of space."""
        return list_views((point for _, point in self.points), (frame for frame, _, _ in self.angular.values()))

    # --- the recursion --------------------------------------------------------------------------------------

    def write(self, views: Views) -> Spatial:
        """Points from the root on, each frame when it is first needed; then T's other forms."""
        g, self._views = self.graph, views
        self._velocities = Velocities(self.rates, views, None if views.in_space else self.field)
        self.made = Spatial(self.kinetic, self._velocities.recursion, self._velocities.turns)
        self._momenta: dict[Variables, tuple[Frame, Vector]] = {}
        forms: list[Terms] = [{} for _ in self.atoms]
        in_space: dict[int, Terms] = {}
        waiting = dict(self.angular)
        for components, point in self.points if views.in_space else sorted(self.points, key=_depth):
            variables = self._velocities.place(point)
            view = views.of_point(point)
            matrix = views.on_motion(view)
            for axis, component in enumerate(components):
                if component is None and view is not ROOT and not self._velocities.rests(variables[axis]):
                    raise Unread  # T has no square of it
                if component is not None:
                    sign = g.number(self.signs[component])
                    forms[component] = {c: sign for c in variables[axis : axis + 1] if c != STILL}
                    row = zip(variables, matrix[axis], strict=True)
                    in_space[component] = {c: g.mul(sign, a) for c, a in row if a != g.zero and c != STILL}
            near = {id(frame) for frame, _ in point.arms}
            for k in [k for k, (frame, _, _) in waiting.items() if id(frame) in near]:
                forms[k] = self._component(k, *waiting.pop(k))
        for k, atom in enumerate(self.atoms):
            if k in waiting:
                forms[k] = self._component(k, *waiting.pop(k))
            elif k not in self.inside and k not in self.angular:
                forms[k] = self._plain(atom)
        for variables, (frame, momentum) in self._momenta.items():
            torque = self.rates.on_motion(cross(g, momentum, self._velocities.omega(frame)))
            self.made.torques += [pair for pair in zip(variables, torque, strict=True) if pair[0] != STILL]
        self.made.recursion.forms = [self._velocities.on_motion(terms) for terms in forms]
        self.made.placed = [in_space.get(k, terms) for k, terms in enumerate(self.made.recursion.forms)]
        self.made.turned = views.turned(self.made.recursion)
        self.made.offsets = self._velocities.list_offsets()
        self.made.weighed = self.weighed
        return self.made

    # --- T's other forms ------------------------------------------------------------------------------------

    def _angular(self, used: set[int]) -> Named:
        """Signatures of the components of angular velocities along vectors that are fixed on the axes, with their signs."""
        found: Named = {}
        self._add_names(found, sorted(self.frames.fixed(), key=lambda pair: id(pair[0]) not in used))
        return found

    def _add_names(self, found: Named, fixed: Iterable[tuple[Frame, Vector]]) -> None:
        for frame, vector in fixed:
            mark = self.marks.of(self.graph.dot(vector, frame.omega))
            found.setdefault(mark, (frame, vector, Fraction(1)))
            found.setdefault(self.marks.negative(mark), (frame, vector, Fraction(-1)))

    def _last(self, atom: Node, names: Named) -> tuple[Frame, Vector, Fraction] | None:
        """A component of an angular velocity that alone tells of the last turn: no point stands beside its axis."""
        g, symbols = self.graph, self.rates.symbols
        if sum(a != g.zero for a in linear_form(g, atom, symbols)[0]) <= _FEW:
            return None
        angles = {g.a[node] for node in reachable(g, [atom]) if g.op[node] in ("sin", "cos")}
        turned = sorted(angle for angle in angles if not self.frames.turns_by(angle))
        triples = self.frames.fixed()
        for _ in range(_TILTS):
            triples = self.frames.spun_on(triples, turned)
            self._add_names(names, triples)
            if (found := names.get(self.marks.of(atom))) is not None:
                return found
        return None

    def _component(self, k: int, frame: Frame, vector: Vector, sign: Fraction) -> Terms:
        """u . omega as a definition, with what it gives to omega: -omega x u times its momentum; the form is ``sign`` times it."""
        g = self.graph
        variables = self._velocities.spin(frame)
        vector = self._views.local(vector, self._views.of(frame))
        self.made.known.add(k)
        slope = g.mul(g.number(sign), self.kinetic.slope[k])
        total = self._momenta.get(variables, (frame, ZERO))[1]
        self._momenta[variables] = frame, add_vectors(g, total, scale_vector(g, slope, vector))
        terms = {c: a for c, a in zip(variables, vector, strict=True) if c != STILL and a != g.zero}
        if any(g.value(a) is None for a in terms.values()):
            terms = {self._velocities.define(terms, g.zero, g.zero): g.one}
        return {c: g.mul(g.number(sign), a) for c, a in terms.items()}

    def _plain(self, atom: Node) -> Terms:
        """Other forms, of few rates."""
        g, terms = self.graph, dict[int, Node]()
        found, constant = self.plain(atom)
        for v, a in found:
            self._velocities.add(terms, v, a)
        if len(found) == 1 and constant == g.zero and not any(g.deps[a] & ~self._mask for a in terms.values()):
            return terms
        (turn,) = tangent(g, [atom], self.rates.seeds)
        number = self._velocities.define(terms, constant, turn)
        return {number: g.one} if number != STILL else {}

    def plain(self, atom: Node) -> tuple[list[tuple[Node, Node]], Node]:
        """Coefficients and constant of a form of few rates.

        Raises:
            Unread: it has many.
        """
        symbols = self.rates.symbols
        coefficients, constant = linear_form(self.graph, atom, symbols)
        found = [(v, a) for v, a in zip(symbols, coefficients, strict=True) if a != self.graph.zero]
        if len(found) > _FEW:
            raise Unread
        return found, constant
