"""Integrals of constraints in which the variables separate.

A form ``sum_i a_i(q, t) dq_i + a_0 dt`` whose coefficients are products can have an integrating factor that leaves to each
differential a function of its own variable alone: that of ``x' = 2 t x`` is 1/x, and ``log|x| - t^2`` is constant.  Of a variable
each coefficient but its own has then the same factors, which the integrating factor takes away.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.polynomial import polynomial
from nhc.algebra.shared import factor
from nhc.mechanics.properties.primitives import integrate
from nhc.mechanics.system import System

_MOST = 4  # differentials of a form
_TERMS = 40  # of what is integrated

_Factors = dict[Node, int]
"""Factors and their powers."""


def find_separated(system: System) -> list[Node]:
    """The terms of the integrals, up to numbers, of the constraints whose variables separate."""
    g, found = system.graph, list[Node]()
    for form in system.constraints:
        entries = [(x, a) for x, a in zip((*system.q, system.t), (*form.coefficients, form.constant), strict=True)]
        entries = [(x, a) for x, a in entries if a != g.zero]
        if not 1 < len(entries) <= _MOST:
            continue
        parts = separate(g, [x for x, _ in entries], [a for _, a in entries])
        for (x, _), part in zip(entries, parts or (), strict=parts is not None):
            found += _integrate(g, part, x)
    return list(dict.fromkeys(found))


def separate(graph: Graph, variables: Sequence[Node], coefficients: Sequence[Node]) -> list[_Factors] | None:
    """The coefficients times one integrating factor, up to numbers, each with its own variable alone; None where there is none."""
    masks = [graph.deps[x] for x in variables]
    every = graph.mask(variables)
    rows = []
    for a in coefficients:
        row: list[_Factors] = [{} for _ in (*variables, None)]  # by variable, and what is free of them
        for base, power in _list_factors(graph, a, every):
            held = [k for k, mask in enumerate(masks) if graph.deps[base] & mask]
            if len(held) > 1:
                return None
            part = row[held[0] if held else -1]
            part[base] = part.get(base, 0) + power
        rows.append([{base: power for base, power in part.items() if power} for part in row])
    found = []
    for k, row in enumerate(rows):
        others = [other[k] for i, other in enumerate(rows) if i != k]
        if any(other != others[0] for other in others):
            return None
        own = dict(row[k])
        for base, power in others[0].items():
            own[base] = own.get(base, 0) - power
        found.append({base: power for base, power in (*own.items(), *row[-1].items()) if power})
    return found


def _list_factors(graph: Graph, node: Node, variables: int) -> Iterator[tuple[Node, int]]:
    """The factors of a product, less its number; of what was multiplied out, too, and of the exponential of a sum."""
    stack = [(node, 1, False)]
    while stack:
        x, power, irreducible = stack.pop()
        op = graph.op[x]
        if op == MUL:
            stack += [(child, power, False) for child in graph.kids[x]]
        elif op == POW:
            stack.append((graph.a[x], power * graph.b[x], False))
        elif op == NEG:
            stack.append((graph.a[x], power, False))
        elif op == ADD and not irreducible and _holds_several(graph, x, variables):
            made = factor(graph, x)
            stack.append((made, power, made == x or graph.op[made] == ADD))
        elif op == "exp" and graph.op[graph.a[x]] == ADD and _holds_several(graph, x, variables):
            stack += [(graph.function("exp", term), power, True) for term in graph.kids[graph.a[x]]]
        elif graph.value(x) is None:
            yield x, power


def _holds_several(graph: Graph, node: Node, variables: int) -> bool:
    return (graph.deps[node] & variables).bit_count() > 1


def _integrate(graph: Graph, factors: _Factors, x: Node) -> Iterator[Node]:
    whole = graph.product(graph.power(base, power) for base, power in factors.items())
    try:
        terms = polynomial(graph, whole, _TERMS, circle=False)
    except TooLarge:
        return
    for term in terms:
        yield from integrate(graph, term, x)
