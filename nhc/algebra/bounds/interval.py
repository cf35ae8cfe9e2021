"""Interval bounds on nodes: a sound answer to "can this vanish?".

Coordinates range over given intervals (all reals when unknown), parameters are points.  What is rounded is rounded outwards: sums
that cancel leave bounds of the size of their rounding, where no relative margin tells zero from what is near it.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable

Interval = tuple[float, float]
EVERYTHING: Interval = (-math.inf, math.inf)
_MARGIN = 1e-9


def bounds(graph: Graph, root: Node, known: Mapping[Node, Interval]) -> Interval:
    """An interval that contains every value of the root for symbols in their intervals."""
    return list_bounds(graph, reachable(graph, [root]), known)[root]


def list_bounds(graph: Graph, order: Sequence[Node], known: Mapping[Node, Interval]) -> dict[Node, Interval]:
    """The intervals of nodes that stand after their children."""
    value: dict[Node, Interval] = {}
    for node in order:
        value[node] = _bound(graph, node, value, known)
    return value


def cannot_vanish(graph: Graph, root: Node, known: Mapping[Node, Interval]) -> bool:
    """Whether the root is bounded away from zero for symbols in their intervals, but for factors that tend to zero without limits
    to their symbols, and reach it nowhere: cos(atan x), which is 1/sqrt(1 + x^2), exp(x), and one over what is away from zero.
    """
    rest = [factor for factor in _factors(graph, root) if not _reaches_no_zero(graph, factor, known)]
    return excludes_zero(bounds(graph, graph.product(rest), known))


def _reaches_no_zero(graph: Graph, factor: Node, known: Mapping[Node, Interval]) -> bool:
    if graph.op[factor] == POW:
        return graph.b[factor] < 0 and excludes_zero(bounds(graph, graph.a[factor], known))
    return _tends_to_zero(graph, factor)


def _tends_to_zero(graph: Graph, factor: Node) -> bool:
    """Without reaching it."""
    op = graph.op[factor]
    return op == "exp" or (op == "cos" and graph.op[graph.a[factor]] == "atan")


def _factors(graph: Graph, root: Node) -> list[Node]:
    """The factors of a product and of its positive powers; the root alone where there is none among them that tends to zero."""
    found, stack = list[Node](), [root]
    while stack:
        node = stack.pop()
        if graph.op[node] == MUL:
            stack += [graph.b[node], graph.a[node]]
        elif graph.op[node] in (NEG, POW) and (graph.op[node] == NEG or graph.b[node] > 0):
            stack.append(graph.a[node])
        else:
            found.append(node)
    return found if any(graph.op[node] == POW or _tends_to_zero(graph, node) for node in found) else [root]


def excludes_zero(interval: Interval) -> bool:
    """Whether an interval is away from zero, by more than the rounding of its bounds."""
    low, high = interval
    size = max(abs(low), abs(high)) if math.isfinite(low) and math.isfinite(high) else 1.0
    return low > _MARGIN * size or high < -_MARGIN * size


def _bound(g: Graph, node: Node, value: Mapping[Node, Interval], known: Mapping[Node, Interval]) -> Interval:
    op, a, b = g.op[node], g.a[node], g.b[node]
    if op == NUM:
        number = g.value(node)
        assert number is not None
        return _enclose(number)
    if op == SYM:
        return known.get(node, EVERYTHING)
    if op == PI:
        return _outwards(math.pi, math.pi)
    if op == ADD:
        return _sum(value[a], value[b])
    if op == NEG:
        p, q = value[a]
        return -q, -p
    if op == MUL:
        return _product(value[a], value[b])
    if op == POW:
        return _power(value[a], b)
    return _function(op, value[a])


def _enclose(number: Fraction) -> Interval:
    """The doubles next to a number; products of numbers that are written may be larger than any double."""
    try:
        near = float(number)
    except OverflowError:
        largest = sys.float_info.max
        return (largest, math.inf) if number > 0 else (-math.inf, -largest)
    if near == 0.0 != number:
        least = math.ulp(0.0)
        return (0.0, least) if number > 0 else (-least, 0.0)
    return (near, near) if near == number else _outwards(near, near)


def _outwards(low: float, high: float) -> Interval:
    """The next doubles outwards; zero is exact wherever it comes up."""
    return (math.nextafter(low, -math.inf) if low else low), (math.nextafter(high, math.inf) if high else high)


def _sum(x: Interval, y: Interval) -> Interval:
    (p, q), (r, s) = x, y
    low, high = p + r, q + s
    if low - p != r or low - r != p:  # rounded, or infinite
        low = math.nextafter(low, -math.inf)
    if high - q != s or high - s != q:
        high = math.nextafter(high, math.inf)
    return low, high


def _product(x: Interval, y: Interval) -> Interval:
    corners = [0.0 if 0.0 in (p, q) else p * q for p in x for q in y]
    return _outwards(min(corners), max(corners))


def _power(x: Interval, n: int) -> Interval:
    if n < 0:
        low, high = _power(x, -n)
        if low > 0 or high < 0:
            return _outwards(1 / high, 1 / low)
        return (0.0 if low >= 0 else -math.inf), math.inf
    try:
        corners = [end**n for end in x]
    except OverflowError:
        return (0.0, math.inf) if n % 2 == 0 else EVERYTHING
    if n % 2 == 0 and x[0] < 0 < x[1]:
        corners.append(0.0)
    return _outwards(min(corners), max(corners))


def _function(op: str, x: Interval) -> Interval:
    low, high = x
    if op in ("sin", "cos"):
        if low == high and math.isfinite(low):
            at = math.sin(low) if op == "sin" else math.cos(low)
            return _outwards(at, at)
        return _wave(op, low, high)
    if op == "tanh" or op == "sign":
        return -1.0, 1.0
    if op == "cosh":
        return 1.0, math.inf
    if op == "exp":
        return (0.0 if low == -math.inf else math.exp(min(low, 700)) * (1 - 1e-12)), math.inf
    if op == "sqrt":
        return _outwards(math.sqrt(max(low, 0.0)), math.sqrt(high) if high >= 0 else math.inf)
    if op == "abs":
        return (0.0 if low <= 0 <= high else min(abs(low), abs(high))), max(abs(low), abs(high))
    if op == "atan":
        return _outwards(math.atan(low), math.atan(high))
    if op == "asin":
        return -math.pi / 2, math.pi / 2
    return EVERYTHING


def _wave(op: str, low: float, high: float) -> Interval:
    if not math.isfinite(high - low) or high - low >= 2 * math.pi:
        return -1.0, 1.0
    shift = 0.0 if op == "cos" else -math.pi / 2  # sin x = cos(x - pi/2)
    p, q = low + shift, high + shift
    ends = [math.sin(low), math.sin(high)] if op == "sin" else [math.cos(low), math.cos(high)]
    top = 1.0 if math.floor(q / (2 * math.pi)) > math.floor(p / (2 * math.pi)) or p <= 0 <= q else max(ends)
    bottom = (
        -1.0 if math.floor((q - math.pi) / (2 * math.pi)) > math.floor((p - math.pi) / (2 * math.pi)) else min(ends)
    )
    bottom, top = _outwards(bottom, top)
    return max(-1.0, bottom), min(1.0, top)
