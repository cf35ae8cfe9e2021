"""Velocities along the axes of a body, in place of the row of minors that completes its constraints.

The row of minors is regular wherever the constraints are, but long: for two axles that steer it is a sum of products of the sines
and cosines of both.  Where the constraints are those of a body that turns in a plane, they look the same on its axes whatever its
heading, and the velocity along one of these axes, cos(heading) x' + sin(heading) y', often completes them as well: its product
with the row of minors is what the determinant is, does not contain the heading, and may be one that cannot vanish.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.carry import carry
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.mechanics.regular.regularity import coframe_weakness, intervals
from nhc.mechanics.system import Form, System

_LIMIT = 200  # terms of a product with a row of minors


def along_headings(system: System, forms: Sequence[Form]) -> tuple[Form, ...]:
    """The forms with velocities along axes for rows of three minors or more, where none is singular more often for that."""
    made = [_along_axis(system, form) or form for form in forms]
    if all(new is old for new, old in zip(made, forms, strict=True)):
        return tuple(forms)
    weak, before = (coframe_weakness(system, (*system.constraints, *own))[0] for own in (made, forms))
    return tuple(forms) if weak > before else tuple(made)


def _along_axis(system: System, form: Form) -> Form | None:
    """The velocity along an axis in place of a row of minors; None where none is known to be regular."""
    g = system.graph
    minors = [j for j, node in enumerate(form.coefficients) if node != g.zero]
    for i, j in combinations(minors, 2) if len(minors) > 2 else ():
        pair = form.coefficients[i], form.coefficients[j]
        found = _find_axis(system, pair)
        if found is not None:
            heading, across = found
            s, c = g.function("sin", heading), g.function("cos", heading)
            coefficients = [g.zero] * system.n
            coefficients[i], coefficients[j] = (g.neg(s), c) if across else (c, s)
            return Form(form.name, tuple(coefficients), g.zero)
    return None


def _find_axis(system: System, pair: Sequence[Node]) -> tuple[Node, bool] | None:
    """The heading of axes of which one, the second if true, is one along which two minors cannot vanish together.

    On a graph of its own: what is tried leaves no nodes behind, whose order is part of what is derived later.
    """
    scratch, symbols = Graph(), dict[Node, Node]()
    for node in dict.fromkeys((*system.graph.symbols_in(pair[0]), *system.graph.symbols_in(pair[1]))):
        symbol = system.graph.symbol_of(node)
        assert symbol is not None
        symbols[node] = scratch.symbol(symbol.name, symbol.kind)
    x, y = carry(system.graph, scratch, pair, symbols)
    known = {symbols[node]: bounds for node, bounds in intervals(system).items() if node in symbols}
    for heading in (q for q in system.q if q in symbols):
        s, c = scratch.function("sin", symbols[heading]), scratch.function("cos", symbols[heading])
        along, across = scratch.dot((c, s), (x, y)), scratch.sub(scratch.mul(c, y), scratch.mul(s, x))
        for product in (along, across):
            if _is_regular(scratch, product, symbols[heading], known):
                return heading, product == across
    return None


def _is_regular(graph: Graph, product: Node, heading: Node, known: Mapping[Node, Interval]) -> bool:
    determinant = normalise_angles(graph, product, _LIMIT)
    return not graph.depends(determinant, graph.mask((heading,))) and cannot_vanish(graph, determinant, known)
