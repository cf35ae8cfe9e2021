"""Derivatives on the graph, forward and reverse.

All passes loop over node numbers (children come before parents), so deep expressions need no deep stack.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, BINARY, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable


def partials(graph: Graph, node: Node) -> tuple[Node, ...]:
    """The derivatives of a power or function with respect to each of its operands."""
    g, op, x = graph, graph.op[node], graph.a[node]
    if op == POW:
        n = g.b[node]
        return (g.mul(g.number(n), g.power(x, n - 1)),)
    if op in BINARY:
        return _binary_partials(g, op, node, x, g.b[node])
    return (_unary_derivative(g, op, node, x),)


def list_slopes(graph: Graph, node: Node) -> Iterable[tuple[Node, Node]]:
    """What the operation depends on, with its derivative by that.

    x^(n/2) is a power of x, not of sqrt(x): n/2 x^(n/2 - 1) is 0 at x = 0, where the chain rule through the root has 0/0.
    """
    base, n = graph.a[node], graph.b[node]
    if graph.op[node] == POW and n > 2 and graph.op[base] == "sqrt":
        return ((graph.a[base], graph.mul(graph.number(Fraction(n, 2)), graph.power(base, n - 2))),)
    return zip(graph.kids[node], partials(graph, node), strict=True)


def _unary_derivative(g: Graph, op: str, node: Node, x: Node) -> Node:
    if op == "sin":
        return g.function("cos", x)
    if op == "cos":
        return g.neg(g.function("sin", x))
    if op == "asin":
        return g.inverse(g.function("sqrt", g.sub(g.one, g.power(x, 2))))
    if op == "acos":
        return g.neg(g.inverse(g.function("sqrt", g.sub(g.one, g.power(x, 2)))))
    if op == "atan":
        return g.inverse(g.add(g.one, g.power(x, 2)))
    if op == "sinh":
        return g.function("cosh", x)
    if op == "cosh":
        return g.function("sinh", x)
    if op == "tanh":
        return g.sub(g.one, g.power(node, 2))
    if op == "exp":
        return node
    if op == "log":
        return g.inverse(x)
    if op == "sqrt":
        size = g.size_of_part(x)
        return g.inverse(g.mul(g.number(2), node if size is None else g.function("sqrt", size)))
    if op == "abs":
        return g.function("sign", x)
    if op == "sign":  # zero almost everywhere
        return g.zero
    raise ValueError(f"no derivative is known for `{op}`")


def _binary_partials(g: Graph, op: str, node: Node, x: Node, y: Node) -> tuple[Node, Node]:
    if op == "atan2":  # atan2(x, y) = angle of (y, x)
        inverse = g.inverse(g.add(g.power(x, 2), g.power(y, 2)))
        return g.mul(y, inverse), g.neg(g.mul(x, inverse))
    if op == "powf":
        size = g.size_of_part(x)
        slope = g.mul(y, g.function("powf", x if size is None else size, g.sub(y, g.one)))
        growth = g.zero if g.value(y) is not None else g.mul(node, g.function("log", x))
        return slope, growth
    # min and max: one half of 1 + sign, almost everywhere
    half_sign = g.function("sign", g.sub(x, y))
    up = g.div(g.add(g.one, half_sign), g.number(2))
    down = g.div(g.sub(g.one, half_sign), g.number(2))
    return (up, down) if op == "max" else (down, up)


def tangent(graph: Graph, roots: Sequence[Node], seeds: Mapping[Node, Node]) -> list[Node]:
    """Directional derivatives of the roots along the vector whose components are the seeds (symbol -> component)."""
    dot: dict[Node, Node] = {symbol: value for symbol, value in seeds.items() if value}
    mask = graph.mask(dot)
    if not any(graph.deps[root] & mask for root in roots):
        return [graph.zero] * len(roots)
    add, mul, op, a, b = graph.add, graph.mul, graph.op, graph.a, graph.b
    for node in reachable(graph, roots, mask):
        if node in seeds:
            continue
        kind, x = op[node], a[node]
        if kind == ADD:
            terms = add(dot.get(x, 0), dot.get(b[node], 0))
        elif kind == MUL:
            y = b[node]
            dx, dy = dot.get(x), dot.get(y)
            terms = mul(y, dx) if dx else 0
            if dy:
                terms = add(terms, mul(x, dy))
        elif kind == NEG:
            terms = graph.neg(dot.get(x, 0))
        else:
            terms = 0
            if any(c in dot for c in graph.kids[node]):
                for child, partial in list_slopes(graph, node):
                    if child in dot:
                        terms = add(terms, mul(partial, dot[child]))
        if terms:
            dot[node] = terms
    return [dot.get(root, 0) for root in roots]


class Derivation:
    """The derivative along one vector field, each node's made once: what chains share is not walked through again."""

    def __init__(self, graph: Graph, seeds: Mapping[Node, Node]) -> None:
        self.graph = graph
        self._mask = graph.mask([symbol for symbol, value in seeds.items() if value])
        self._known: dict[Node, Node] = dict(seeds)

    def of(self, root: Node) -> Node:
        """The derivative of the root."""
        graph, known, mask = self.graph, self._known, self._mask
        deps, op, a, b = graph.deps, graph.op, graph.a, graph.b
        if root in known or not deps[root] & mask:
            return known.get(root, 0)
        for node in reachable(graph, (root,), mask, known):
            kind, x = op[node], a[node]
            if kind == ADD:
                made = graph.add(known.get(x, 0), known.get(b[node], 0))
            elif kind == MUL:
                y = b[node]
                made = graph.add(graph.mul(y, known.get(x, 0)), graph.mul(x, known.get(y, 0)))
            elif kind == NEG:
                made = graph.neg(known.get(x, 0))
            else:
                made = 0
                for child, partial in list_slopes(graph, node):
                    made = graph.add(made, graph.mul(partial, known.get(child, 0)))
            known[node] = made
        return known[root]


def gradient(graph: Graph, root: Node, wrt: Sequence[Node]) -> list[Node]:
    """d root / d symbol for each symbol, by one reverse sweep."""
    return pullback_gradient(graph, [(root, graph.one)], wrt)


def pullback_gradient(graph: Graph, weighted: Sequence[tuple[Node, Node]], wrt: Sequence[Node]) -> list[Node]:
    """sum of weight_k * d root_k / d symbol for each symbol, by one reverse sweep (weights are not differentiated)."""
    mask, deps = graph.mask(wrt), graph.deps
    bar: dict[Node, Node] = {}
    for root, weight in weighted:
        bar[root] = graph.add(bar.get(root, 0), weight)
    add, mul, op, a, b, get = graph.add, graph.mul, graph.op, graph.a, graph.b, bar.get
    for node in reversed(reachable(graph, [root for root, _ in weighted], mask)):
        seed = get(node, 0)
        if not seed:
            continue
        kind = op[node]
        if kind == ADD:
            x, y = a[node], b[node]
            if deps[x] & mask:
                bar[x] = add(get(x, 0), seed)
            if deps[y] & mask:
                bar[y] = add(get(y, 0), seed)
        elif kind == MUL:
            x, y = a[node], b[node]
            if deps[x] & mask:
                bar[x] = add(get(x, 0), mul(seed, y))
            if deps[y] & mask:
                bar[y] = add(get(y, 0), mul(seed, x))
        elif kind == NEG:
            x = a[node]
            bar[x] = add(get(x, 0), graph.neg(seed))
        elif kind != SYM:
            for child, partial in list_slopes(graph, node):
                if deps[child] & mask:
                    bar[child] = add(get(child, 0), mul(seed, partial))
    return [get(symbol, 0) for symbol in wrt]


def derivative(graph: Graph, root: Node, symbol: Node) -> Node:
    """d root / d symbol."""
    return tangent(graph, [root], {symbol: graph.one})[0]
