"""Spec -> System: syntax trees become nodes, constraints become forms, and what cannot be mechanics is refused with its place."""

from __future__ import annotations

import sys
from collections.abc import Collection, Sequence
from fractions import Fraction

from nhc.algebra.graph import Graph, Node
from nhc.language import Spec
from nhc.language.expressions.syntax import Syntax
from nhc.mechanics.regular.dependent_rows import check_freedom, check_rank
from nhc.mechanics.resolving.expressions import Resolver, define_names, tangent_slopes
from nhc.mechanics.resolving.forces import resolve_forces
from nhc.mechanics.resolving.short_rows import short_row
from nhc.mechanics.system import Form, System

_LARGEST = Fraction(sys.float_info.max)
_LARGEST_EXPONENT = 2**53


def resolve(spec: Spec, graph: Graph | None = None, *, drawn: bool = False, absent: Collection[str] = ()) -> System:
    """The system that a spec declares, on a graph of its own or on the one given.

    ``drawn``: what it draws is looked at, too; ``absent``: parameters in whose place 0 stands.

    Raises:
        nhc.diagnostics.SpecError: everything that is wrong with it as mechanics, all at once.
    """
    build = Resolver(spec, graph)
    build.names.update(dict.fromkeys(absent, build.graph.zero))
    _check_parameters(build)
    define_names(build)
    T = build.node(spec.kinetic)
    U = _potential(build)
    constraints = _constraints(build)
    quasi = tuple(
        _short_row(
            build, build.form(entry.name, build.names[entry.name], entry.value.span, "E0412", "the quasi-velocity")
        )
        for entry in spec.quasi_velocities
    )
    given, pulls = resolve_forces(build, quasi)
    energies = {"T": T, "U": U, "V": build.graph.neg(U), "energy": build.graph.sub(T, U)}
    visible = {**energies, **build.names}
    outputs = tuple((entry.name, build.node(entry.value, visible)) for entry in spec.outputs)
    build.bag.raise_if_errors()
    system = System(
        spec=spec,
        graph=build.graph,
        t=build.t,
        q=build.q,
        v=build.v,
        p=build.p,
        T=T,
        U=U,
        Q=given.Q,
        constraints=constraints,
        quasi=quasi,
        dependent=tuple(build.coordinate(name) for name in spec.dependent),
        outputs=outputs,
        places=_places(build),
        rotations=build.rotations,
        torques=given.torques,
        pulls=pulls,
        given=given,
    )
    check_rank(build.bag, build.spec, system)
    if not build.bag.has_errors:
        check_freedom(build.bag, spec, system)
    if drawn and not build.bag.has_errors:
        _check_apart(build, [tree for figure in spec.draw for tree in figure.expressions])
    build.bag.raise_if_errors()
    return system


def _check_parameters(build: Resolver) -> None:
    """Values that are expressions, exactly; on a graph of its own, for the model holds the parameters' symbols."""
    _check_apart(build, [p.value for p in build.spec.parameters if p.value and not isinstance(p.value, Fraction)])
    build.bag.raise_if_errors()  # nothing is sampled without them


def _potential(build: Resolver) -> Node:
    spec, g = build.spec, build.graph
    if spec.potential is None:
        return g.zero
    node = build.node(spec.potential)
    moving = [v for v, slope in zip(build.v, tangent_slopes(g, node, build.v), strict=True) if slope]
    if moving:
        symbol = g.symbol_of(moving[0])
        assert symbol is not None
        build.bag.error(
            "E0405",
            f"`{spec.potential_kind}` depends on the velocity `{symbol.name}'`",
            spec.potential.span,
            help=("put what depends on velocities into `forces:`, or into `T` when it belongs to the Lagrangian",),
        )
    return node if spec.potential_kind == "U" else g.neg(node)


def _constraints(build: Resolver) -> tuple[Form, ...]:
    """Constraints in their order, then the holonomic ones as their derivatives."""
    g, rows = build.graph, []
    for entry in build.spec.constraints:
        node = g.sub(build.node(entry.left), build.node(entry.right))
        rows.append(build.form(entry.name, node, entry.span, "E0401", "the constraint"))
    for held in build.spec.holonomic:
        f = g.sub(build.node(held.left), build.node(held.right))
        if any(tangent_slopes(g, f, build.v)):
            build.bag.error(
                "E0415",
                f"the holonomic constraint `{held.name}` depends on velocities",
                held.span,
                help=("move it to `constraints:`",),
            )
            continue
        form = build.form(held.name, build.derivation.of(f), held.span, "E0401", "the constraint")
        form.equation = f
        rows.append(form)
    return tuple(_short_row(build, form) for form in rows)


def _short_row(build: Resolver, form: Form) -> Form:
    turned = build.graph.mask([v for rotation in build.rotations for v in rotation.v])
    return short_row(build.graph, build.q, build.v, form, turned)


def _places(build: Resolver) -> dict[str, str]:
    spec = build.spec
    places = {"T": build.place(spec.kinetic.span)}
    if spec.potential is not None:
        places["U"] = build.place(spec.potential.span)
    for entry in (*spec.forces, *spec.outputs, *spec.quasi_velocities):
        places[entry.name] = build.place(entry.value.span)
    return places


def _check_apart(build: Resolver, trees: Sequence[Syntax]) -> None:
    """On a graph of its own: these must leave no mark on what is derived."""
    if trees:
        probe = Resolver(build.spec)
        define_names(probe)
        probe.bag = build.bag
        for tree in trees:
            probe.node(tree)
