"""Expressions whose zero lies where they cease to have a value: sqrt(x - 1), of which a step beyond x = 1 sees nothing.

A product has a zero wherever one of its factors has.  Where this factor is a root or an arc cosine, which is not negative and is
zero only where its domain ends, what stands under it has the same zero and the same sign before, and a value beyond.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from nhc.algebra.bounds.interval import Interval, bounds
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import MUL, NEG, POW, Graph, Node


def continue_beyond(
    graph: Graph, event: Node, start: Mapping[Node, float], ranges: Mapping[Node, Interval] | None = None
) -> Node:
    """An expression with the zeros and signs of ``event``, and values beyond those at which it ends; ``start`` gives the symbols'
    values, at some place, and ``ranges`` intervals of some.

    An event without a value at the start, or that is zero there, stays as it is: nobody knows on which side the run is.
    """
    try:
        (value,) = evaluate(graph, [event], dict(start))
        settled = math.isfinite(float(value)) and float(value) != 0.0
    except (ArithmeticError, ValueError, TypeError):
        settled = False
    return _continue(graph, event, ranges or {}) if settled else event


def _continue(graph: Graph, node: Node, ranges: Mapping[Node, Interval]) -> Node:
    g, op = graph, graph.op[node]
    if op == NEG:
        return g.neg(_continue(g, g.a[node], ranges))
    if op == MUL:
        return g.mul(_continue(g, g.a[node], ranges), _continue(g, g.b[node], ranges))
    root = g.a[node] if op == POW and g.b[node] > 0 else node  # sqrt(u)^3
    under = g.a[root]
    if g.op[root] == "acos":
        return g.sub(g.one, under)
    exponent = g.value(g.b[root]) if g.op[root] == "powf" else None
    if g.op[root] == "sqrt" or (exponent is not None and exponent > 0):
        return node if bounds(g, under, ranges)[0] >= 0.0 else under  # sqrt(x^2 + y^2) has a value everywhere
    return node
