"""Nodes as text with the names that the spec gave to their parts."""

from __future__ import annotations

from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.rewriting.joined import join_sums
from nhc.algebra.show import to_text
from nhc.mechanics.system import System


def named_text(system: System, node: Node, longest: int = 200) -> str:
    """A node as text in the spec's names: in coordinates, or with definitions and outputs by name, whichever is shorter; sums of
    angles are joined.
    """
    g = system.graph
    names = {output: name for name, output in system.outputs if g.children(output)}
    names.update({labelled: name for labelled, name in g.labels.items() if name in _defined(system)})
    if node in names:
        return names[node]
    symbols = {part: g.symbol(name) for part, name in sorted(names.items())}
    forms = (node, *join_sums(g, [node, substitute(g, [node], symbols)[0]]))
    return min((to_text(g, each, longest) for each in dict.fromkeys(forms)), key=len)


def zero_text(system: System, node: Node) -> str:
    """The shortest known expression with the same zeros, without a number in front."""
    graph = system.graph
    plain = graph.split_coefficient(node)[1]
    apart = normalise_angles(graph, plain, 40)
    forms = (plain, *(graph.split_coefficient(each)[1] for each in (apart, *join_sums(graph, [plain, apart]))))
    return min((named_text(system, each, 400) for each in dict.fromkeys(forms)), key=len)


def entry_text(system: System, node: Node) -> str:
    """The name of the matrix entry of a rotation that the node equals, with a minus if it is the negative; else empty."""
    g = system.graph
    for rotation, declared in zip(system.rotations, system.spec.rotations, strict=True):
        entries = [entry for row in rotation.matrix for entry in row]
        for sign in ("", "-"):
            apart = [g.add(node, entry) if sign else g.sub(node, entry) for entry in entries]
            found = [name for name, zero in zip(declared.entries, are_zero(g, apart), strict=True) if zero]
            if found:
                return sign + found[0]
    return ""


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
