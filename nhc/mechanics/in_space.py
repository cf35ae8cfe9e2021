"""By way of a ball's angular velocity in space, where a motion keeps that on the ball's own axes.

The state stays on the body's axes, and

    omega_space = R omega,    omega' = R^T omega_space',

for omega x omega = 0 (E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), sections 12 and 69).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.adapt import with_places
from nhc.mechanics.detour import Detour, equations_over
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.mechanics.frame import form_value, total_derivative, velocity_symbol
from nhc.mechanics.rotations.rotation import put
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.spherical_tops import Top, put_in_space, read_tops
from nhc.mechanics.system import Form, System


def find_in_space(equations: Equations, kept: Sequence[Form]) -> list[Detour]:
    """The equations with each spherical top's omega in space, and by way of what is simpler there; none where there is no top or it
    does not help.

    ``kept`` are the forms whose values the velocities w are.
    """
    system = equations.system
    if not system.rotations or "spherical tops" in system.graph.off or len(kept) != system.n - system.l:
        return []
    tops = read_tops(system, kept)
    turned = put_in_space(system, kept, tops) if tops else None
    found = _detour(equations, turned[0], turned[1], tops) if turned is not None else None
    if turned is None or found is None:
        return []
    other = _by_places(equations, kept, found, turned[0], tops)
    return [found] if other is None else [found, other]


def _detour(equations: Equations, system: System, forms: Sequence[Form], tops: Sequence[Top]) -> Detour | None:
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
    found = equations_over(system, forms, symbols, kinetic_structure(system))
    if found is None:
        return None
    frame, made = found
    return Detour(made, frame, values, (g.zero,) * len(w), tuple(back))


def _by_places(
    equations: Equations, kept: Sequence[Form], there: Detour, system: System, tops: Sequence[Top]
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
    found = equations_over(made, forms, [velocity_symbol(made, form) for form in forms], kinetic_structure(made))
    if found is None:
        return None
    frame, inner = found
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


def _names(system: System, top: Top) -> tuple[str, ...]:
    """Of the components of a top's omega."""
    spec = system.spec.rotations
    return next(tuple(r.velocities) for r in spec if r.name == top.own.name)
