"""Nodes as text with the names that the spec gave to their parts."""

from __future__ import annotations

from nhc.algebra.calculus import substitute
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import Node
from nhc.algebra.show import to_text
from nhc.mechanics.system import System


def named_text(system: System, node: Node, longest: int = 200) -> str:
    """The shorter of the node's own text and that with definitions and outputs by their names."""
    g = system.graph
    names = {output: name for name, output in system.outputs if g.children(output)}
    names.update({labelled: name for labelled, name in g.labels.items() if name in _defined(system)})
    if node in names:
        return names[node]
    symbols = {part: g.symbol(name) for part, name in sorted(names.items())}
    plain = to_text(g, node, longest)
    named = to_text(g, substitute(g, [node], symbols)[0], longest)
    return named if len(named) < len(plain) else plain


def _defined(system: System) -> frozenset[str]:
    spec = system.spec
    return frozenset(entry.name for entry in (*spec.definitions, *spec.quasi_velocities))


def energy_name(system: System) -> str:
    """E, where the spec has no other E (a modulus)."""
    return "(T + V)" if "E" in _declared(system) else "E"


def momentum_name(system: System, coordinate: str, momentum: Node) -> str:
    """p_x, where nothing else in the spec is called so; an output may show it."""
    g, name = system.graph, f"p_{coordinate}"
    shown = dict(system.outputs).get(name)
    if name not in _declared(system) or (shown is not None and is_zero(g, g.sub(shown, momentum))):
        return name
    return f"dT/d{coordinate}'"


def _declared(system: System) -> set[str]:
    spec = system.spec
    names = {entry.name for entry in (*spec.definitions, *spec.quasi_velocities, *spec.outputs)}
    return names | {c.name for c in spec.coordinates} | {p.name for p in spec.parameters}
