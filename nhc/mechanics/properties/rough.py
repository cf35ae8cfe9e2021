"""Kinks and jumps of what the spec says, as warnings: what a derivative leaves out, and what motions cannot cross."""

from __future__ import annotations

from collections.abc import Collection

from nhc.algebra.calculus import reachable
from nhc.diagnostics import Bag, quote
from nhc.mechanics.properties.constancy import shows_jumps
from nhc.mechanics.system import System

_ROUGH = frozenset({"abs", "sign", "min", "max"})


def list_torn(system: System) -> frozenset[str]:
    """The names of the constraints and quasi-velocities that jump somewhere."""
    torn = set()
    for form in (*system.constraints, *system.quasi):
        held = (*form.coefficients, form.constant, *(() if form.equation is None else (form.equation,)))
        if shows_jumps(system, held, undecided=False):
            torn.add(form.name)
    return frozenset(torn)


def warn_rough(system: System, torn: Collection[str], bag: Bag) -> None:
    """``torn``: what :func:`list_torn` found."""
    g, spec = system.graph, system.spec
    for key, node in (("T", system.T), (spec.potential_kind or "U", system.U)):
        if shows_jumps(system, [node], undecided=False):
            bag.warning(
                "W0416",
                f"`{key}` jumps: the equations have no force for the jump, so the energy changes there",
                spec.key_span(key),
                help=("use a continuous function, or keep the motion at one side",),
            )
            continue
        found = sorted({g.op[n] for n in reachable(g, [node])} & _ROUGH)
        if found:
            bag.warning(
                "W0416",
                f"`{key}` contains {quote(found)}: its derivative does not exist at every point",
                spec.key_span(key),
                help=("use a smooth function if the motion crosses the kink",),
            )
    spans = {entry.name: entry.span for entry in spec.constraints}
    spans |= {entry.name: entry.span for entry in spec.holonomic}
    spans |= {entry.name: entry.span for entry in spec.quasi_velocities}
    forms = [("constraint", form) for form in system.constraints] + [("quasi-velocity", form) for form in system.quasi]
    for kind, form in forms:
        if form.name in spans and form.name in torn:
            bag.warning(
                "W0416",
                f"the {kind} `{form.name}` jumps: no motion follows it across the jump",
                spans[form.name],
                help=("write it with continuous functions, or keep the motion at one side",),
            )
