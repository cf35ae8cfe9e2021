"""Rotations of bodies with three equal moments of inertia, on the axes of space where the spec has omega on the body's.

With T a function of |omega|^2 the mass matrix is that of omega on any axes.  On those of space, constraints and forces of a ball
that rolls do not contain its orientation: R_y . omega is one component (E. T. Whittaker, Analytical Dynamics, 4th ed. (1937),
section 69).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.frame import Frame, make_frame
from nhc.mechanics.rotations.other_axes import (
    omega_in_symbols,
    omega_symbols,
    on_other_axes,
    turn_components,
    value_on_other_axes,
)
from nhc.mechanics.rotations.rotation import Rotation, put
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import Form, System
from nhc.records import record


@record
class Top:
    """A rotation on the body's axes, and the same with its omega in space."""

    own: Rotation
    there: Rotation
    kept: tuple[int, ...]
    """The places of its omega among the velocities that the motion keeps; none where it keeps others."""

    def back(self, g: Graph) -> dict[Node, Node]:
        """omega on the body's axes by that in space, and R omega, as specs write it, itself."""
        found: dict[Node, Node] = {}
        for row, other in zip(self.own.matrix, self.there.omega, strict=True):
            put(g, found, g.dot(row, self.own.omega), other)
        for node, column in zip(self.own.omega, zip(*self.own.matrix, strict=True), strict=True):
            put(g, found, node, g.dot(column, self.there.omega))
        return found


def turn_tops(system: System, frame: Frame) -> tuple[System, Frame] | None:
    """The system and its frame with the omega of spherical tops in space, of which the motion keeps nothing; None where there are
    none, or a constraint or a torque keeps the orientation.  The rows of its equations are the same.
    """
    if not system.rotations or "spherical tops" in system.graph.off:
        return None
    kept = frame.forms[system.l :]
    tops = read_tops(system, kept, whole=False)
    turned = put_in_space(system, kept, tops) if tops else None
    if turned is None:
        return None
    return turned[0], make_frame(*turned, frame.free, known=True)


def read_tops(system: System, kept: Sequence[Form], *, whole: bool = True) -> list[Top]:
    """The rotations for which T is that of a spherical top, and all of whose omega is kept; or, not ``whole``, nothing of it."""
    g, values = system.graph, [form.value for form in kept]
    able = [r for r in system.rotations if r.sign > 0 and {w in values for w in r.omega} == {whole}]
    symbols = {rotation: omega_symbols(g, rotation) for rotation in able}
    mapping = {node: symbol for rotation in able for node, symbol in omega_in_symbols(g, rotation).items()}
    (energy,) = substitute(g, [system.T], mapping, named=False)
    every = [symbol for rotation in able for symbol in symbols[rotation]]
    slopes = dict(zip(every, gradient(g, energy, every), strict=True))
    found = []
    for rotation in able:
        a, b, c = symbols[rotation]
        if g.depends(energy, g.mask(rotation.v)) or not g.depends(energy, g.mask((a, b, c))):
            continue
        x, y, z = slopes[a], slopes[b], slopes[c]
        if all(are_zero(g, [g.sub(g.mul(x, b), g.mul(y, a)), g.sub(g.mul(y, c), g.mul(z, b))])):
            places = tuple(values.index(w) for w in rotation.omega) if whole else ()
            found.append(Top(rotation, on_other_axes(g, rotation), places))
    return found


def put_in_space(system: System, kept: Sequence[Form], tops: Sequence[Top]) -> tuple[System, list[Form]] | None:
    """The system and the kept forms with the omega in space; None where a constraint or a torque keeps the orientation."""
    g, own = system.graph, {top.own: top for top in tops}
    isotropic: dict[Node, Node] = {}
    for top in tops:
        for node, other in zip(top.own.omega, top.there.omega, strict=True):
            put(g, isotropic, node, other)
    mine = {w for top in tops for w in top.own.omega}
    constraints = [_form(g, form, tops) for form in system.constraints]
    forms = [form if form.value in mine else _form(g, form, tops) for form in kept]
    written = [form for form in (*constraints, *forms) if form is not None]
    back = {node: value for top in tops for node, value in top.back(g).items()}
    torques = list[Vector]()
    for rotation, torque in zip(system.rotations, system.torques, strict=True):
        a, b, c = substitute(g, torque, back, named=False)
        turned = turn_components(g, rotation, (a, b, c)) if rotation in own else (a, b, c)
        torques += [turned] if turned is not None else []
    if len(written) < system.n or len(torques) < len(system.rotations):
        return None
    for top in tops:
        for place, omega in zip(top.kept, top.there.omega, strict=bool(top.kept)):
            form = forms[place]
            assert form is not None
            forms[place] = Form(f"{form.name} in space", form.coefficients, g.zero, form.place, value=omega)
    made = replace(
        system,
        T=substitute(g, [system.T], isotropic, named=False)[0],
        Q=tuple(substitute(g, system.Q, back, named=False)),
        constraints=tuple(form for form in constraints if form is not None),
        rotations=tuple(own[r].there if r in own else r for r in system.rotations),
        torques=tuple(torques),
    )
    return made, [form for form in forms if form is not None]


def _form(g: Graph, form: Form, tops: Sequence[Top]) -> Form | None:
    """A form as the spec wrote it, with the omega in space."""
    value = form.value
    if value is None:
        return form
    for top in tops:
        turned = value_on_other_axes(g, top.own, value)
        if turned is None:
            return None
        value = turned
    return Form(form.name, form.coefficients, form.constant, form.place, form.equation, value)
