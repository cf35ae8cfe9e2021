"""Rotations of bodies with three equal moments of inertia, on the axes of space where the spec has omega on the body's.

With T a function of |omega|^2 the mass matrix is that of omega on any axes.  On those of space, constraints and forces of a ball
that rolls do not contain its orientation: R_y . omega is one component.  The state stays on the body's axes, and

    omega_space = R omega,    omega' = R^T omega_space',

for omega x omega = 0 (E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), sections 12 and 69).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.adapt import with_places
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.detour import Detour
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import form_value, make_frame, total_derivative, velocity_symbol
from nhc.mechanics.rotations.rotation import Rotation, make_rotation, put, spell
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import Form, System
from nhc.records import record


@record
class _Top:
    """A rotation on the body's axes, and the same with its omega in space."""

    own: Rotation
    there: Rotation
    kept: tuple[int, int, int]
    """The places of its omega among the velocities that the motion keeps."""

    def back(self, g: Graph) -> dict[Node, Node]:
        """omega on the body's axes by that in space, and R omega, as specs write it, itself."""
        found: dict[Node, Node] = {}
        for row, other in zip(self.own.matrix, self.there.omega, strict=True):
            put(g, found, g.dot(row, self.own.omega), other)
        for node, column in zip(self.own.omega, zip(*self.own.matrix, strict=True), strict=True):
            put(g, found, node, g.dot(column, self.there.omega))
        return found


def find_in_space(equations: Equations, kept: Sequence[Form]) -> list[Detour]:
    """The equations with each spherical top's omega in space, and by way of what is simpler there; none where there is no top or it
    does not help.

    ``kept`` are the forms whose values the velocities w are.
    """
    system = equations.system
    if not system.rotations or "spherical tops" in system.graph.off or len(kept) != system.n - system.l:
        return []
    tops = _read(system, kept)
    turned = _in_space(system, kept, tops) if tops else None
    found = _detour(equations, turned[0], turned[1], tops) if turned is not None else None
    if turned is None or found is None:
        return []
    other = _by_places(equations, kept, found, turned[0], tops)
    return [found] if other is None else [found, other]


def _read(system: System, kept: Sequence[Form]) -> list[_Top]:
    """The rotations for which T is that of a spherical top, and all of whose omega is kept."""
    g, values = system.graph, [form.value for form in kept]
    able = [r for r in system.rotations if r.sign > 0 and all(w in values for w in r.omega)]
    symbols = {rotation: _symbols(g, rotation) for rotation in able}
    mapping = {node: symbol for rotation in able for node, symbol in _in_symbols(g, rotation).items()}
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
            there = make_rotation(g, rotation.name, rotation.places, -1, rotation.e, rotation.v)
            first, second, third = (values.index(w) for w in rotation.omega)
            found.append(_Top(rotation, there, (first, second, third)))
    return found


def _symbols(g: Graph, rotation: Rotation) -> tuple[Node, ...]:
    """Stand for omega on the body's axes."""
    return tuple(g.symbol(f"{rotation.name}_turn{k}", "test") for k in range(3))


def _in_symbols(g: Graph, rotation: Rotation) -> dict[Node, Node]:
    mapping: dict[Node, Node] = {}
    for node, symbol in zip(rotation.omega, _symbols(g, rotation), strict=True):
        put(g, mapping, node, symbol)
    return mapping


def _in_space(system: System, kept: Sequence[Form], tops: Sequence[_Top]) -> tuple[System, list[Form]] | None:
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
        turned = _turn(g, own[rotation].own, (a, b, c)) if rotation in own else (a, b, c)
        torques += [turned] if turned is not None else []
    if len(written) < system.n or len(torques) < len(system.rotations):
        return None
    for top in tops:
        for place, omega in zip(top.kept, top.there.omega, strict=True):
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


def _form(g: Graph, form: Form, tops: Sequence[_Top]) -> Form | None:
    """A form as the spec wrote it, with the omega in space."""
    value = form.value
    if value is None:
        return form
    for top in tops:
        if not g.depends(value, g.mask(top.own.v)):
            continue
        mapping, turns = _in_symbols(g, top.own), _symbols(g, top.own)
        try:
            (a, b, c), rest = linear_form(g, substitute(g, [value], mapping, named=False)[0], turns)
        except NotLinear:
            return None
        turned = _turn(g, top.own, (a, b, c))
        if turned is None:
            return None
        value = g.add(rest, g.dot(turned, top.there.omega))
    return Form(form.name, form.coefficients, form.constant, form.place, form.equation, value)


def _turn(g: Graph, rotation: Rotation, components: Vector) -> Vector | None:
    """A vector on the axes of space that does not contain the orientation; None where it does."""
    own = spell(g, rotation)
    named = substitute(g, components, own.words, named=False)
    rows = []
    for k, node in enumerate(named):
        column = own.entries[k::3]
        try:
            parts, rest = linear_form(g, node, column)
        except NotLinear:
            return None
        if rest != g.zero or any(g.depends(part, g.mask(own.entries)) for part in parts):
            return None
        rows.append(parts)
    first, second, third = rows
    differences = [g.sub(x, y) for other in (second, third) for x, y in zip(first, other, strict=True)]
    return (first[0], first[1], first[2]) if all(are_zero(g, differences)) else None


def _detour(equations: Equations, system: System, forms: Sequence[Form], tops: Sequence[_Top]) -> Detour | None:
    """``system``'s equations; its omega by the state's, and back."""
    g, w = system.graph, equations.motion.w
    symbols, values, back = list(w), dict[Node, Node](), list(w)
    for top in tops:
        own = [w[place] for place in top.kept]
        there = [g.symbol(forms[place].name, "quasi") for place in top.kept]
        for place, symbol, row in zip(top.kept, there, top.own.matrix, strict=True):
            symbols[place], values[symbol] = symbol, g.dot(row, own)
        for place, column in zip(top.kept, zip(*top.own.matrix, strict=True), strict=True):
            back[place] = g.dot(column, there)
    try:
        frame = make_frame(system, forms, symbols)
        made = equations_of(
            system, Formulation("euler-lagrange", "I.2.15", frame, None, (), ""), kinetic_structure(system)
        )
    except Singular:
        return None
    return Detour(made, frame, values, (g.zero,) * len(w), tuple(back))


def _by_places(
    equations: Equations, kept: Sequence[Form], there: Detour, system: System, tops: Sequence[_Top]
) -> Detour | None:
    """By way of the rates of places and the spin about the normal, with omega' = R^T omega_space' as before."""
    g, own = system.graph, [w for top in tops for w in top.there.omega]
    names = {form.name for form in system.quasi}
    spoken = {name: omega for top in tops for name, omega in zip(_names(system, top), top.there.omega, strict=True)}
    if not spoken.keys() <= names:
        return None
    quasi = tuple(
        Form.written(form.name, spoken[form.name], g, system.v, form.place) if form.name in spoken else form
        for form in system.quasi
    )
    made = replace(system, quasi=quasi)
    first = tuple(there.frame.forms[system.l :])
    forms = with_places(made, (), first)
    if forms == first:
        return None
    symbols = [velocity_symbol(made, form) for form in forms]
    try:
        frame = make_frame(made, forms, symbols)
        inner = equations_of(
            made, Formulation("euler-lagrange", "I.2.15", frame, None, (), ""), kinetic_structure(made)
        )
    except Singular:
        return None
    on_there = moving(made, there.frame.kinematics)
    for node, symbol in zip(own, (there.frame.free[place] for top in tops for place in top.kept), strict=True):
        put(g, on_there, node, symbol)
    values = substitute(g, [form_value(made, form) for form in forms], on_there, named=False)
    still = dict.fromkeys(there.frame.free, g.zero)
    drift = [total_derivative(made, value, there.frame.kinematics, still) for value in values]
    turned = dict[int, Node]()
    for top in tops:
        omega = top.there.turning(g, [frame.kinematics[k] for k in top.there.places])[1:]
        for place, column in zip(top.kept, zip(*top.own.matrix, strict=True), strict=True):
            turned[place] = g.dot(column, omega)
    others = [k for k in range(len(kept)) if k not in turned]
    straight = substitute(g, [form_value(made, kept[k]) for k in others], moving(made, frame.kinematics))
    back = turned | dict(zip(others, straight, strict=True))
    flat = substitute(g, [*values, *drift], there.values)
    by_state, own_drift = dict(zip(frame.free, flat[: len(forms)], strict=True)), tuple(flat[len(forms) :])
    return Detour(inner, frame, by_state, own_drift, tuple(back[k] for k in range(len(kept))))


def _names(system: System, top: _Top) -> tuple[str, ...]:
    """Of the components of a top's omega."""
    spec = system.spec.rotations
    return next(tuple(r.velocities) for r in spec if r.name == top.own.name)
