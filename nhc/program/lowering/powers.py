"""Integer powers as products that share their parts.

``r^6`` and ``r^12`` cost four multiplications together: ``r^2``, ``r^3``, ``r^6 = r^3*r^3``, ``r^12 = r^6*r^6``.  Exponents are
made as in addition chains (Knuth, The Art of Computer Programming, vol. 2, 4.6.3): each is the sum of two at hand, or its two
halves are made first.  What is divided by in several powers is divided by once, and so is what stands under a root of which the
reciprocal is known.

The graph has one node for ``x^3`` however it came about, so that the parts of a power are told beside it: they take the place of
its operands wherever a function is put in order.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.algebra.graph import POW, Graph, Node

HIGHEST = 64
"""Exponents up to which products are as accurate as they should be: k factors lose k/2 units in the last place at most."""


def chain(exponents: Iterable[int]) -> dict[int, tuple[int, int]]:
    """An addition chain: each exponent above 1 that is needed, in increasing order, as a sum of two smaller ones (or 1)."""
    found: dict[int, tuple[int, int]] = {}

    def make(n: int) -> None:
        if n == 1 or n in found:
            return
        larger = (a for a in sorted(found, reverse=True) if n <= 2 * a < 2 * n)
        pair = next(((a, n - a) for a in larger if n - a == 1 or n - a in found), None)
        if pair is None:
            pair = n - n // 2, n // 2
            make(pair[1])
            make(pair[0])
        found[n] = pair

    for n in sorted(exponents):
        make(n)
    return dict(sorted(found.items()))


def part_powers(graph: Graph, needed: Sequence[Node]) -> tuple[Sequence[Node], Sequence[tuple[Node, ...]]]:
    """The nodes of a function with those that their powers are made of, in an order in which all are known when they are used, and
    the operands of every node of the graph.

    Two operands of a power are its factors; one that is not its base is its reciprocal.
    """
    if "shared powers" in graph.off:
        return needed, graph.kids
    exponents: dict[Node, set[int]] = {}
    for node in needed:
        if graph.op[node] == POW:
            exponents.setdefault(graph.a[node], set()).add(graph.b[node])
    if not any(_is_worth_parts(graph, base, own) for base, own in exponents.items()):
        return needed, graph.kids
    parts: dict[Node, tuple[Node, ...]] = {}
    while exponents:
        base = max(exponents)  # even powers of a root are powers of what is under it, which comes later
        for node, factors in _part(graph, base, exponents.pop(base)).items():
            parts.setdefault(node, factors)
            for factor in factors:
                if graph.op[factor] == POW and graph.a[factor] != base:
                    exponents.setdefault(graph.a[factor], set()).add(graph.b[factor])
    kids = list(graph.kids)
    for node, factors in parts.items():
        kids[node] = factors
    return _put_in_order(needed, kids), kids


def _is_worth_parts(graph: Graph, base: Node, exponents: set[int]) -> bool:
    return max(map(abs, exponents)) > 2 or (-1 in exponents and (min(exponents) < -1 or graph.op[base] == "sqrt"))


def _part(graph: Graph, base: Node, exponents: set[int]) -> dict[Node, tuple[Node, ...]]:
    """The factors of the base's powers, and of those that these are made of; of 1/x where the base is the root of x."""
    power, found = graph.power, dict[Node, tuple[Node, ...]]()
    below = {-e for e in exponents if -HIGHEST <= e < 0}
    above = {e for e in exponents if 1 < e <= HIGHEST}
    if len(below) == 1 and max(below) > 2:
        (n,) = below
        found[power(base, -n)] = (power(base, n),)
        above.add(n)
    elif len(below) > 1:
        found |= {power(base, -n): (power(base, -k), power(base, -m)) for n, (k, m) in chain(below).items()}
    found |= {power(base, n): (power(base, k), power(base, m)) for n, (k, m) in chain(above).items()}
    found = {node: factors for node, factors in found.items() if graph.a[node] == base and graph.op[node] == POW}
    if graph.op[base] == "sqrt" and (1 in below or len(below) > 1):
        under = graph.a[base]
        if graph.op[under] != POW or graph.b[under] > 0:  # 1/z under the root is made of z, which is its reciprocal
            found[power(under, -1)] = (power(base, -1),) * 2
    return found


def _put_in_order(needed: Iterable[Node], kids: Sequence[tuple[Node, ...]]) -> list[Node]:
    """The nodes and what they need, each after its own operands."""
    ordered: dict[Node, None] = {}
    for root in needed:
        if root in ordered:
            continue
        stack = [root]
        while stack:
            top = stack[-1]
            waiting = [kid for kid in kids[top] if kid not in ordered]
            if waiting:
                stack += reversed(waiting)
                continue
            stack.pop()
            ordered[top] = None
    return list(ordered)
