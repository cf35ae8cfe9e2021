"""``forces``: generalized forces Q_i, and the torques on rotations, from the work that is done."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.language.spec import Definition
from nhc.mechanics.resolving.expressions import Resolver, tangent_slopes
from nhc.mechanics.rotations.turning import spread
from nhc.mechanics.system import Form, Given, Pulls, Torques


def resolve_forces(build: Resolver, quasi: Sequence[Form]) -> tuple[Given, Pulls | None]:
    """Q_i with the torques of the rotations, and Q_i by positions: a force does the work of the rate of what it is given on.

    On a coordinate it is Q_i itself, on a component of an angular velocity its torque.  On another velocity w, or on a
    position whose rate is w, it is Q_i = F dw/dq_i', with the torques F dw/domega_k.
    """
    g, spec, turned = build.graph, build.spec, build.rotations
    given = {force.name: build.node(force.value) for force in spec.forces}
    own = [given.get(c.name, g.zero) for c in spec.coordinates]
    angular = [w for rotation in spec.rotations for w in rotation.velocities]
    known = {*(c.name for c in spec.coordinates), *angular}
    forms = {form.name: form for form in quasi}
    pushes = [(given[name], form) for name, form in forms.items() if name in given]
    pulls, arms = list[tuple[Node, Node]](), dict[str, Sequence[Node]]()
    others = list(pushes)
    for force in spec.forces:
        if force.name in known:
            continue
        form = forms.get(force.name)
        if form is None:
            form, place = _moved(build, force)
            pushes.append((given[force.name], form))
            if place is None:
                others.append(pushes[-1])
            else:
                pulls.append((place, given[force.name]))
        reach = spread(g, build.v, turned, form.value) if turned and form.value is not None else None
        if reach is not None:
            arms[force.name] = reach[0][len(build.v) :]

    def total(without: Collection[str]) -> tuple[tuple[Node, ...], Torques]:
        torques = [given.get(name, g.zero) if name not in without else g.zero for name in angular]
        for name, own_arms in arms.items():
            if name not in without:
                torques = [g.add(m, g.mul(given[name], a)) for m, a in zip(torques, own_arms, strict=True)]
        triples = tuple((torques[k], torques[k + 1], torques[k + 2]) for k in range(0, len(torques), 3))
        return _push(g, own, [(push, form) for push, form in pushes if form.name not in without]), triples

    pulls += [(q, force) for q, force in zip(build.q, own, strict=True) if force != g.zero]
    joined = Pulls(tuple(pulls), _push(g, [g.zero] * len(own), others)) if pulls and not turned else None
    return Given(*total(()), tuple(pushes), total), joined


def _push(graph: Graph, Q: Sequence[Node], pushes: Sequence[tuple[Node, Form]]) -> tuple[Node, ...]:
    """Q_i with the forces on the velocities."""
    for push, form in pushes:
        Q = [graph.add(q, graph.mul(push, a)) for q, a in zip(Q, form.coefficients, strict=True)]
    return tuple(Q)


def _moved(build: Resolver, force: Definition) -> tuple[Form, Node | None]:
    """The velocity that a force on a defined position or velocity does its work with, and the position.

    What holds no velocities is a position, but for a velocity of a body that nothing but the time moves this way.
    """
    g, node = build.graph, build.names[force.name]
    moves = force.name in build.spec.velocities or any(tangent_slopes(g, node, build.v))
    rate = node if moves else build.derivation.of(node)
    form = build.form(force.name, rate, force.span, "E0424", "the velocity")
    if not any(tangent_slopes(g, rate, build.v)):
        help = ("name a position that depends on the coordinates, or a velocity that depends on theirs",)
        build.bag.error("E0424", f"`{force.name}` does not move: a force on it does no work", force.span, help=help)
    return form, None if moves else node
