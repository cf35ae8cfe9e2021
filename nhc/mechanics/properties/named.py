"""Nodes as text with the names that the spec gave to their parts."""

from __future__ import annotations

from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.rewriting.joined import join_sums
from nhc.algebra.shared import factor
from nhc.algebra.show import to_text
from nhc.algebra.walks import count
from nhc.mechanics.system import System

LONG = "a long expression"
_NAMED = 2  # operations of what is told by its name
_SHORT = 60  # characters up to which no names of outputs are needed


def named_text(system: System, node: Node, longest: int = 200) -> str:
    """A node as text in the spec's names: in coordinates, or with definitions by name, whichever is shorter; where that is long,
    with outputs and what bodies bring, too.  Sums of angles are joined.  A name that stands for the cosine of an angle is longer
    to look up than to read.
    """
    g, defined = system.graph, _defined(system)
    outputs = {output: name for name, output in system.outputs}
    labelled = {node: name for node, name in g.labels.items() if name in defined}
    own = [name for name in labelled.values() if not system.spec.is_brought(name)]
    names = {whole: name for whole, name in (outputs | labelled).items() if count(g, [whole]) >= _NAMED}
    if node in names:
        return names[node]
    texts = []
    for known in ({whole: name for whole, name in names.items() if name in own}, names):
        symbols = {part: g.symbol(name) for part, name in sorted(known.items())}
        forms = (node, *join_sums(g, [node, substitute(g, [node], symbols)[0]]))
        texts.append(min((to_text(g, each, longest) for each in dict.fromkeys(forms)), key=len))
        if len(texts[-1]) <= _SHORT:
            break
    return min(texts, key=len)


def product_text(system: System, node: Node, longest: int = 200) -> str:
    """The same of a determinant, as a product where it is one: its factors tell where it vanishes."""
    made = factor(system.graph, node)
    text = named_text(system, made, longest)
    return named_text(system, node, longest) if made != node and is_cut(text) else text


def is_cut(text: str) -> bool:
    """Whether a node's text has not all of it: nobody is shown such a text as a formula."""
    return text.endswith("…")


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
