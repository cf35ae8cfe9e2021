"""Formulations that may give a scene a smaller model than the spec's own: other coframes, other kept velocities."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import Unlucky
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, build
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.dependence import find_vanishing
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.flow import flow_of
from nhc.mechanics.frame import (
    complete_basis,
    coordinate_form,
    kept_forms,
    make_frame,
    total_derivative,
    velocity_symbol,
)
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import Form, System


def list_formulations(system: System, base: Formulation, kinetic: Kinetic, scene: Scene) -> list[Formulation]:
    """Formulations to compare with ``base`` for a scene; multipliers keep more velocities than any of them and are left out."""
    found = []
    for name in ("euler-lagrange", "chaplygin", "voronec", "lagrange"):
        if name == base.name:
            continue
        try:
            made = build(system, name)
        except NotApplicable:
            continue
        if made.dependent is None or made.dependent.regular:
            found.append(made)
    needed = [
        coordinate_form(system, system.q_names.index(need.name.removesuffix("'")))
        for need in scene.need
        if need.kind in ("coordinate", "velocity")
    ]
    every = [coordinate_form(system, i) for i in range(system.n)]
    pools = (
        ("the velocities that the scene needs", [*needed, *system.quasi, *kinetic.forms, *every]),
        ("velocity forms of T", [*kinetic.forms, *every]),
    )
    for reason, pool in pools:
        made_frame = _complete(system, pool, f"quasi-velocities chosen for the scene: {reason}")
        if made_frame is not None:
            found.append(made_frame)
    return found


def _complete(system: System, pool: Sequence[Form], reason: str) -> Formulation | None:
    """The first forms of the pool that complete the constraints to a coframe."""
    chosen = complete_basis(system, system.constraints, pool)
    return _in_frame(system, chosen, reason) if system.l + len(chosen) == system.n else None


def _in_frame(system: System, forms: Sequence[Form], reason: str) -> Formulation | None:
    """The Euler-Lagrange formulation on the constraints and these forms."""
    named = _named(system, forms)
    try:
        frame = make_frame(system, named, [velocity_symbol(system, form) for form in named])
    except Singular:
        return None
    held = [x for form in named for x in (*form.coefficients, form.constant)]
    if has_jumps(system, held, elsewhere=True, openly=True):  # it would be continuous in place of the velocities
        return None
    return Formulation("euler-lagrange", "I.2.15" if system.l else "I.2.14", frame, None, (), reason)


def _named(system: System, forms: Sequence[Form]) -> list[Form]:
    """The forms under names that nothing else in the spec bears; T's own forms get those of the spec's definitions."""
    spec = system.spec
    own = [form.name for form in system.quasi]
    taken = {*system.q_names, *own, *(p.name for p in spec.parameters), *(name for name, _ in system.outputs)}
    found = []
    for form in forms:
        if any(form is q for q in system.quasi) or form.name in system.q_names:
            found.append(form)
            continue
        name = system.graph.labels.get(form.value, form.name) if form.value is not None else form.name
        while name in taken:
            name += "_"
        taken.add(name)
        found.append(Form(name, form.coefficients, form.constant, form.place, None, form.value, form.line))
    return found


def momentum_formulation(equations: Equations, formulation: Formulation) -> Formulation | None:
    """The coframe in which conserved momenta p_mu = e_mu dT/dq' take the place of their velocities (Routh); None without any.

    The determinant changes by a principal minor of the mass matrix, so this frame is singular only where that matrix is.
    """
    system, g = equations.system, equations.system.graph
    if not equations.motion.w or equations.multipliers:
        return None
    slopes = gradient(g, system.T, system.v)
    momenta = [g.dot(e, slopes) for e in equations.motion.vectors]
    conserved = _conserved(equations, momenta)
    if not any(conserved):
        return None
    forms, names = [], []
    for form, momentum, constant in zip(kept_forms(system, formulation.frame), momenta, conserved, strict=True):
        if not constant:
            forms.append(form)
            continue
        try:
            coefficients, rest = linear_form(g, momentum, system.v)
        except NotLinear:
            return None
        forms.append(Form(f"p_{form.name}", coefficients, rest, form.place, None, momentum))
        names.append(f"p_{form.name}")
    values = [form.value for form in forms if form.value is not None and form.name in names]
    if has_jumps(system, values, elsewhere=True):
        return None
    what = "conserved momentum" if len(names) == 1 else "conserved momenta"
    return _in_frame(system, forms, f"{what} {', '.join(names)} in place of the velocity (Routh)")


def _conserved(equations: Equations, momenta: Sequence[Node]) -> list[bool]:
    """Which momenta have a rate that vanishes identically while no velocity's own does."""
    system, motion = equations.system, equations.motion
    g, flow = system.graph, flow_of(equations)
    on = moving(system, motion.velocities)
    rates = dict(zip(motion.w, motion.rates, strict=True))
    nodes = [total_derivative(system, node, motion.velocities, rates) for node in substitute(g, momenta, on)]
    try:
        zero = find_vanishing(flow, nodes)
    except Unlucky:
        return [False] * len(nodes)
    size = len(flow.y)
    return [vanishes and not own for vanishes, own in zip(zero[size:], zero[system.n : size], strict=True)]
