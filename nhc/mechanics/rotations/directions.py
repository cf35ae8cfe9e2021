"""Rows as components along a direction in a plane: where sin and cos of one angle multiply two of their terms."""

from __future__ import annotations

from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_factors, list_terms
from nhc.mechanics.rotations.turns import Path, Turn
from nhc.records import record


@record
class Sided:
    """scale (cos(angle) c + sin(angle) s) + rest, as a row has it."""

    angle: Node
    c: Node
    s: Node
    scale: Node
    rest: Node

    @property
    def path(self) -> Path:
        return (Turn((0, 1), self.angle),)


def along_direction(graph: Graph, row: Node) -> Sided | None:
    """The row as a component along a direction, where sin and cos of one angle multiply two of its terms."""
    known: dict[Node, Sided | None] = graph.memory.setdefault("directions", {})
    if row not in known:
        known[row] = _read_direction(graph, row)
    return known[row]


def _read_direction(graph: Graph, row: Node) -> Sided | None:
    g = graph
    terms = list_terms(g, row)
    products = [list_factors(g, term) for term in terms]
    users: dict[tuple[str, Node], list[int]] = {}
    for k, product in enumerate(products):
        for own in dict.fromkeys(product):
            if g.op[own] in ("sin", "cos"):
                users.setdefault((g.op[own], g.a[own]), []).append(k)
    for (name, angle), found in users.items():
        mate = users.get(("cos", angle), [])
        if name != "sin" or len(found) != 1 or len(mate) != 1 or found[0] == mate[0]:
            continue
        (k,), (j,) = found, mate
        with_sin, with_cos = list(products[k]), list(products[j])
        with_sin.remove(g.function("sin", angle))
        with_cos.remove(g.function("cos", angle))
        scale = g.one
        for factor in list(with_sin):
            if factor in with_cos and factor in with_sin:
                with_sin.remove(factor)
                with_cos.remove(factor)
                scale = g.mul(scale, factor)
        rest = g.sum([t for i, t in enumerate(terms) if i not in (k, j)])
        return Sided(angle, g.product(with_cos), g.product(with_sin), scale, rest)
    return None
