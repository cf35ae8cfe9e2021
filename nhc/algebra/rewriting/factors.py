"""What is a product of two values at hand is made as this product, though nothing in it shows them as factors.

``l^2 + 2 l r + r^2`` is the square of ``l + r`` where that is needed, too, and ``cos(a) x + cos(a) y`` a multiple of ``x + y``.
Values modulo primes show it: a value divided by that of a symbol, a sine, a cosine or a power is looked up among all others, and so
are squares of sums.  Sums of values at hand are not sought: digits may cancel in them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.exact.residues import invert
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.rebuilding import rebuild_over
from nhc.algebra.rewriting.values import draw_point, find_poles
from nhc.algebra.walks import count, reachable

_SIMPLE = frozenset({SYM, "sin", "cos", POW})
_Pair = tuple[Node, Node, bool]  # factors, and whether the product has the other sign
_MOST = 20_000  # pairs of a value and a factor; beyond them it takes longer than it saves


def find_factors(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots with products of what is at hand in the place of longer expressions."""
    if "equal values" in graph.off:
        return list(roots)
    needed = reachable(graph, roots)
    own = _count_own(graph, needed, roots)
    wanted = [node for node in needed if own[node] > 1 and graph.op[node] in (ADD, MUL)]
    simple = [node for node in needed if graph.op[node] in _SIMPLE]
    if len(wanted) * len(simple) > _MOST:
        return list(roots)
    pairs = _find_pairs(graph, needed, wanted, simple)
    if not pairs:
        return list(roots)
    new: dict[Node, Node] = {}
    for node in needed:
        if node in pairs:
            first, second, opposite = pairs[node]
            made = graph.mul(new.get(first, first), new.get(second, second))
            new[node] = graph.neg(made) if opposite else made
            if not opposite:
                graph.pass_label(node, made)
        elif (over := rebuild_over(graph, node, new)) is not None:
            new[node] = over
    found = [new.get(root, root) for root in roots]
    return found if count(graph, found) < count(graph, roots) else list(roots)


def _count_own(graph: Graph, needed: Sequence[Node], roots: Sequence[Node]) -> dict[Node, int]:
    """For each node the operations that would go with it: its own, and of its operands those that nothing else uses."""
    op, kids, uses = graph.op, graph.kids, dict.fromkeys(needed, 0)
    for root in roots:
        uses[root] += 1
    for node in needed:
        for kid in kids[node]:
            uses[kid] += 1
    own: dict[Node, int] = {}
    for node in needed:
        cost = 0 if not kids[node] or op[node] == NEG else 1
        for kid in kids[node]:
            if uses[kid] == 1:
                cost += own[kid]
        own[node] = cost
    return own


def _find_pairs(
    graph: Graph, needed: Sequence[Node], wanted: Sequence[Node], simple: Sequence[Node]
) -> dict[Node, _Pair]:
    """The wanted nodes that are products of nodes made before them, with these."""
    point = draw_point(graph, 0, needed)
    if point is None:
        return {}
    p, values = point.prime, point.values
    at_hand = {p - values[node]: ~node for node in reversed(needed)}  # ~n: the opposite of n
    at_hand |= {values[node]: node for node in reversed(needed)}
    squares = {values[node] ** 2 % p: node for node in reversed(needed) if graph.op[node] == ADD}
    simple = [node for node in simple if values[node]]
    deps, kids = graph.deps, graph.kids
    inverses = [*zip(simple, invert([values[node] for node in simple], p), strict=True)]
    may_hold: dict[int, list[tuple[Node, int]]] = {}  # by the symbols of a value what may be a factor of it
    candidates: dict[Node, list[_Pair]] = {}
    for node in wanted:
        value, own = values[node], deps[node]
        if own not in may_hold:
            may_hold[own] = [pair for pair in inverses if not deps[pair[0]] & ~own]
        root = squares.get(value)
        pairs = [] if root is None or root >= node else [(root, root, False)]
        for factor, rest in [(f, at_hand[x]) for f, inverse in may_hold[own] if (x := value * inverse % p) in at_hand]:
            other = rest if rest >= 0 else ~rest
            if other > 1 and other < node and factor < node and {factor, other}.isdisjoint(kids[node]):
                pairs.append((factor, other, rest < 0))
        if pairs:
            candidates[node] = pairs
    return _keep_true(graph, candidates, values) if candidates else {}


def _keep_true(
    graph: Graph, candidates: Mapping[Node, Sequence[_Pair]], values: Mapping[Node, int]
) -> dict[Node, _Pair]:
    """For each node the first of its pairs that divides by nothing else and is right at the second point, too."""
    factors = [x for pairs in candidates.values() for first, second, _ in pairs for x in (first, second)]
    own = reachable(graph, [*candidates, *factors])
    point = draw_point(graph, 1, own)
    if point is None:
        return {}
    q, others, poles = point.prime, point.values, find_poles(graph, own, values)
    found: dict[Node, _Pair] = {}
    for node, pairs in candidates.items():
        for first, second, opposite in pairs:
            product = others[first] * others[second]
            rest = others[node] + product if opposite else others[node] - product
            if rest % q == 0 and not (poles[first] | poles[second]) & ~poles[node]:
                found[node] = first, second, opposite
                break
    return found
