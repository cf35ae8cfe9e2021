"""Joints whose axis leans by a constant angle in the plane of the turn before: a bicycle's steering axis, a caster's pin.

On axes that lean with the joint the next turn is about a coordinate axis and the lean is gone: the turn before goes by the sum of
both angles.  So sine and cosine of that turn's angle phi are written in those of psi = phi + lean,

    sin(phi) = sin(psi) cos(lean) - cos(psi) sin(lean),    cos(phi) = cos(psi) cos(lean) + sin(psi) sin(lean),

and what is on the body's axes consists of parameters either way.  The coordinate stays what it is, and no value changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import Derivation
from nhc.algebra.graph import ADD, NEG, POW, Graph, Node
from nhc.algebra.rebuilding import Replacement
from nhc.algebra.rewriting.digits import shorter_kept
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.frame import Frame, make_frame
from nhc.mechanics.rotations.turns import Path, Turn
from nhc.mechanics.system import Form, System
from nhc.records import record

_TERMS = 40  # of a canonical form that is tried


@record
class Lean:
    """``angle`` is that of a turn, ``tilt`` the constant turn behind it, in the same plane."""

    angle: Node
    tilt: Turn

    @property
    def back(self) -> Turn:
        """From the joint's axes to the axes before the tilt."""
        i, j = self.tilt.plane
        return Turn((j, i), self.tilt.angle)


def find_lean(graph: Graph, paths: Sequence[Path]) -> Lean | None:
    """The first joint that leans: a turn, a constant one in its plane, and another turn."""
    if all(len(path) < 3 for path in paths) or "leaning joints" in graph.off:
        return None
    constant = {turn.angle for path in paths for turn in path if _is_constant(graph, turn.angle)}
    for path in paths:
        for before, tilt, _ in zip(path, path[1:], path[2:], strict=False):
            if tilt.angle not in constant or before.angle in constant:
                continue
            if set(before.plane) == set(tilt.plane):
                angle = tilt.angle if before.plane == tilt.plane else graph.neg(tilt.angle)
                return Lean(before.angle, Turn(before.plane, angle))
    return None


def _is_constant(graph: Graph, angle: Node) -> bool:
    kinds = {symbol.kind for symbol in map(graph.symbol_of, graph.symbols_in(angle)) if symbol is not None}
    return kinds <= {"parameter"}


class Counted(Replacement):
    """Expressions with the angle counted from the joint.

    Components of directions, which hold sines and cosines of coordinates only, are written in canonical form where that is
    shorter; positions and velocities keep the terms by which they are read.
    """

    def __init__(self, graph: Graph, lean: Lean) -> None:
        g = graph
        whole = g.add(lean.angle, lean.tilt.angle)
        s, c = g.function("sin", whole), g.function("cos", whole)
        k, h = g.function("sin", lean.tilt.angle), g.function("cos", lean.tilt.angle)
        sine, cosine = g.function("sin", lean.angle), g.function("cos", lean.angle)
        super().__init__(g, {sine: g.sub(g.mul(s, h), g.mul(c, k)), cosine: g.add(g.mul(c, h), g.mul(s, k))})
        self._moves: dict[Node, bool] = {}

    def make(self, node: Node, children: Sequence[Node]) -> Node:
        made = super().make(node, children)
        if made == node or not self._is_direction_sum(made):
            return made
        return shorter_kept(self.graph, made, _TERMS)

    def differentiate(self, system: System) -> None:
        """Rates of the spec's positions are those of the new expressions, not new expressions of the rates."""
        g = self.graph
        derivation = Derivation(g, {**dict(zip(system.q, system.v, strict=True)), system.t: g.one})
        for rate, place in list(g.rate_of.items()):
            if g.deps[place] & self._mask:
                new = self.one(place)
                made = self._known[rate] = derivation.of(new)
                if g.op[rate] == NEG:  # T's forms have no sign
                    self._known[g.a[rate]] = g.neg(made)
                g.rate_of.setdefault(made, new)

    def _is_direction_sum(self, node: Node) -> bool:
        """Whether the node is a component of a direction, and no sum of squares of some."""
        g = self.graph
        squares = any(g.op[g.core[child]] == POW for child in g.kids[node])
        return g.op[node] == ADD and not squares and self._is_direction(node)

    def _is_direction(self, node: Node) -> bool:
        """Whether no coordinate and no velocity stands outside of sines and cosines."""
        g, known = self.graph, self._moves
        if node not in known:
            symbol = g.symbol_of(node)
            if symbol is not None:
                known[node] = symbol.kind == "parameter"
            else:
                known[node] = g.op[node] in ("sin", "cos") or all(self._is_direction(child) for child in g.kids[node])
        return known[node]

    def one(self, node: Node) -> Node:
        return self.of([node])[0]

    def form(self, form: Form, velocities: tuple[Node, ...]) -> Form:
        if form.value is None:
            coefficients = tuple(self.of(form.coefficients))
            return Form(form.name, coefficients, self.one(form.constant), form.place, form.equation)
        value = self.one(form.value)
        return Form.written(form.name, value, self.graph, velocities, form.place, form.equation)


def count_from_joint(lean: Lean, system: System, kinetic: Kinetic, frame: Frame) -> tuple[System, Kinetic, Frame]:
    """The same system, structure of T and frame, with the angle counted from the joint's axis."""
    counted = Counted(system.graph, lean)
    counted.differentiate(system)
    forms = [counted.form(form, system.v) for form in frame.forms]
    moved = replace(
        system,
        T=counted.one(system.T),
        U=counted.one(system.U),
        constraints=tuple(forms[: system.l]),
    )
    made = Kinetic(
        system=moved,
        atoms=tuple(counted.of(kinetic.atoms)),
        u=kinetic.u,
        tau=counted.one(kinetic.tau),
        slope=tuple(counted.of(kinetic.slope)),
        hessian=tuple(tuple(counted.of(row)) for row in kinetic.hessian),
    )
    return moved, made, make_frame(moved, forms[system.l :], frame.free, known=True)
