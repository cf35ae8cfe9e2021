"""Events that cease to have a value somewhere: sqrt(x - 1), or log(x - 1) + 9, of which a step beyond x = 1 sees nothing.

Each root, logarithm or arc is continued beyond its domain by values that the event cannot confuse with its own: those of the
domain's end, and on from there as it came.  So the event is followed to its last value, be it a zero, as that of sqrt(x - 1), or
one that follows a zero too closely to be seen, as that of log(x - 1) + 40.  The run ends at the edge if no zero came before.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from nhc.algebra.bounds.interval import Interval, bounds
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import NEG, Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.show import to_text
from nhc.algebra.walks import reachable
from nhc.program.runs.watch import Event

_LEAST = 1000
"""2 to the minus this is as good as the zero at which a logarithm is infinite."""
_LONGEST = 60


def continue_beyond(
    graph: Graph, event: Node, start: Mapping[Node, float], ranges: Mapping[Node, Interval] | None = None
) -> Event:
    """The event with values beyond those at which it ends, and the edges of what it is made of; ``start`` gives the symbols'
    values, at some place, and ``ranges`` intervals of some.

    An event without a value at the start, or at an edge there, stays as it is: nobody knows on which side the run is.
    """
    new, edges, told = dict[Node, Node](), list[Node](), list[str]()
    for node in reachable(graph, [event], graph.mask(tuple(start))):
        inside = _inside(graph, node, ranges or {})
        if inside is None:
            continue
        edge, made = substitute(graph, [inside, _continued(graph, node)], new)
        new[node] = made
        edges.append(edge)
        told.append(_tell(graph, inside))
    try:
        settled = bool(edges) and all(float(value) > 0.0 for value in evaluate(graph, edges, dict(start)))
    except (ArithmeticError, ValueError, TypeError):
        settled = False
    return Event(substitute(graph, [event], new)[0], tuple(edges), tuple(told)) if settled else Event(event)


def _inside(graph: Graph, node: Node, ranges: Mapping[Node, Interval]) -> Node | None:
    """What is positive inside the domain of a function and negative beyond; None where it has values everywhere."""
    g, op, under = graph, graph.op[node], graph.a[node]
    if op in ("acos", "asin"):
        inside = g.sub(g.one, g.function("abs", under))
    elif op in ("sqrt", "log") or (op == "powf" and g.value(g.b[node]) is not None):
        inside = under
    else:
        return None
    least = bounds(g, inside, ranges)[0]  # sqrt(x^2 + y^2) has a value everywhere
    return None if least > 0.0 or (least == 0.0 and op != "log") else inside


def _tell(graph: Graph, inside: Node) -> str:
    negative = graph.op[inside] == NEG
    text = to_text(graph, graph.a[inside] if negative else inside, _LONGEST)
    return f"`{text}` becomes {'positive' if negative else 'negative'}"


def _continued(graph: Graph, node: Node) -> Node:
    """A function of :func:`_inside` with values everywhere: the same inside its domain."""
    g, op, under = graph, graph.op[node], graph.a[node]
    exponent = g.value(g.b[node]) if op == "powf" else None
    if op in ("acos", "asin"):
        near = g.function("max", g.number(-1), g.function("min", g.one, under))
        gone = g.sub(under, near)
        return g.add(g.function(op, near), gone if op == "asin" else g.neg(gone))
    if exponent is not None and exponent < 0:
        least = g.number(Fraction(1, 2 ** (_LEAST // -int(exponent // 1))))
        return g.function(op, g.function("max", least, under), g.b[node])
    if op == "log":
        return g.function(op, g.function("max", g.number(Fraction(1, 2**_LEAST)), under))
    rest = (g.b[node],) if op == "powf" else ()
    return g.add(g.function(op, g.function("max", g.zero, under), *rest), g.function("min", g.zero, under))
