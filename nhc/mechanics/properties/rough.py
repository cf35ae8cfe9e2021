"""Kinks and jumps of what the spec says, as warnings: what a derivative leaves out, and what motions cannot cross."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from types import MappingProxyType

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.calculus import gradient
from nhc.algebra.graph import POW, Node
from nhc.algebra.walks import reachable
from nhc.diagnostics import Bag, quote
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import coordinate_ranges, parameter_ranges

_ROUGH = frozenset({"abs", "sign", "min", "max"})
_HARMLESS = "nothing is wrong with it: adaptive steps of `nhc run` end there, while other methods of high order lose their order"


def list_torn(system: System) -> frozenset[str]:
    """The names of the constraints and quasi-velocities that jump somewhere."""
    forms = (*system.constraints, *system.quasi)
    return frozenset(form.name for form in forms if _shows_jumps(system, _held(form)))


def _shows_jumps(system: System, nodes: Sequence[Node], ranges: Mapping[Node, Interval] = MappingProxyType({})) -> bool:
    return has_jumps(system, nodes, undecided=False, openly=True, ranges=ranges)


def _held(form: Form) -> tuple[Node, ...]:
    return (*form.coefficients, form.constant, *(() if form.equation is None else (form.equation,)))


def _kinks(system: System, node: Node, ranges: Mapping[Node, Interval]) -> list[str]:
    """The functions with kinks that the node contains, but for those whose kinks lie beyond the ranges."""
    g, known, found = system.graph, {**parameter_ranges(system), **ranges}, set()
    for n in reachable(g, [node], g.mask((*system.q, *system.v, system.t))):
        if g.op[n] in _ROUGH:
            kink = g.sub(g.a[n], g.b[n]) if g.op[n] in ("min", "max") else g.a[n]
            if not cannot_vanish(g, kink, known):
                found.add(g.op[n])
    return sorted(found)


def _lacks_slopes(system: System, node: Node, ranges: Mapping[Node, Interval]) -> bool:
    """Whether a derivative of the node jumps, or has a pole at a kink; that of max(x, 0)^2 does not."""
    g, known = system.graph, {**parameter_ranges(system), **ranges}
    slopes = gradient(g, node, (*system.q, *system.v))
    below = [g.a[n] for n in reachable(g, slopes) if g.op[n] == POW and g.b[n] < 0]
    poles = [n for n in below if not cannot_vanish(g, n, known) and any(g.op[x] in _ROUGH for x in reachable(g, [n]))]
    return bool(poles) or has_jumps(system, slopes, ranges=ranges)


def warn_rough(system: System, torn: Collection[str], bag: Bag) -> None:
    """Warnings of what is rough where coordinates keep to the ranges that the spec expects; ``torn`` as of :func:`list_torn`."""
    spec, ranges = system.spec, coordinate_ranges(system)
    for key, node in (("T", system.T), (spec.potential_kind or "U", system.U)):
        if _shows_jumps(system, [node], ranges):
            bag.warning(
                "W0416",
                f"`{key}` jumps: the equations have no force for the jump, so the energy changes there",
                spec.key_span(key),
                help=("use a continuous function, or give the `range` of coordinates that stay at one side",),
            )
            continue
        found = _kinks(system, node, ranges)
        if found:
            lacks = _lacks_slopes(system, node, ranges)
            help = "use a smooth function, or give the `range` of coordinates that stay at one side of the kink"
            bag.warning(
                "W0416",
                f"`{key}` contains {quote(found)}: its derivative "
                + ("does not exist at every point" if lacks else "exists everywhere, higher ones need not"),
                spec.key_span(key),
                help=(help if lacks else _HARMLESS,),
            )
    spans = {entry.name: entry.span for entry in spec.constraints}
    spans |= {entry.name: entry.span for entry in spec.holonomic}
    spans |= {entry.name: entry.span for entry in spec.quasi_velocities}
    forms = [("constraint", form) for form in system.constraints] + [("quasi-velocity", form) for form in system.quasi]
    for kind, form in forms:
        if form.name in spans and form.name in torn and (not ranges or _shows_jumps(system, _held(form), ranges)):
            bag.warning(
                "W0416",
                f"the {kind} `{form.name}` jumps: no motion follows it across the jump",
                spans[form.name],
                help=("write it with continuous functions, or give the `range` of coordinates that stay at one side",),
            )
