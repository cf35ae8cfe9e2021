"""Products that several longer products have in common, made once.

Products are binary and keep the order in which they were made: ``v*(k*a)`` and ``v*(k*b)`` do not show that they share ``v*k``.
Here the factors of each product are looked at together, and pairs that occur in several are taken out, the most frequent first.
What is used more than once is one factor and stays whole.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from heapq import heapify, heappop, heappush
from itertools import combinations

from nhc.algebra.calculus import reachable, rebuild_over
from nhc.algebra.graph import MUL, Graph, Node

_MOST_FACTORS = 10


def share_products(graph: Graph, roots: Sequence[Node], constants: int) -> list[Node]:
    """Equal roots in which products share more of their factors; what contains only ``constants`` (a mask) stays whole."""
    if "shared products" in graph.off:
        return list(roots)
    nodes, deps, moves = reachable(graph, roots), graph.deps, ~constants
    chains, inner = _chains(graph, nodes, roots, constants)
    before = {node: list(factors) for node, factors in chains.items()}
    pairs = _share(chains)
    if chains == before and not any(len([f for f in own if not deps[f] & moves]) > 1 for own in before.values()):
        return list(roots)
    new, labels = dict[Node, Node](), graph.labels

    def made(factor: int) -> Node:
        if factor in new:
            return new[factor]
        if factor < 0:
            first, second = pairs[-1 - factor]
            new[factor] = graph.mul(made(first), made(second))
        elif factor in chains:
            found = [new[f] if f in new else made(f) for f in chains[factor]]
            fixed = graph.product([x for x in found if not deps[x] & moves])
            moving = graph.product([x for x in found if deps[x] & moves])
            new[factor] = graph.mul(fixed, moving)
        else:
            over = rebuild_over(graph, factor, new)
            new[factor] = factor if over is None else over
        if factor in labels:
            graph.pass_label(factor, new[factor])
        return new[factor]

    kids = graph.kids
    for node in nodes:
        if node in inner or node in new:
            continue
        if node not in chains:
            for kid in kids[node]:
                if new.get(kid) != kid:
                    break
            else:
                new[node] = node
                continue
        made(node)
    return [new[root] for root in roots]


def _chains(
    graph: Graph, nodes: Sequence[Node], roots: Iterable[Node], constants: int
) -> tuple[dict[Node, list[int]], set[Node]]:
    """The factors of every product that is no part of a longer one, and the products that are."""
    op, kids, deps, moves = graph.op, graph.kids, graph.deps, ~constants
    uses = dict.fromkeys(nodes, 0)
    for root in roots:
        uses[root] += 1
    for node in nodes:
        for child in kids[node]:
            uses[child] += 1
    chains: dict[Node, list[int]] = {}
    inner: set[Node] = set()
    for node in reversed(nodes):
        if op[node] != MUL or node in inner or not deps[node] & moves:
            continue
        factors, stack = list[int](), [node]
        while stack:
            for child in kids[stack.pop()]:
                open_product = op[child] == MUL and uses[child] == 1 and deps[child] & moves
                if open_product and len(factors) + len(stack) < _MOST_FACTORS:
                    inner.add(child)
                    stack.append(child)
                else:
                    factors.append(child)
        factors.sort()
        chains[node] = factors
    return chains, inner


def _share(chains: dict[Node, list[int]]) -> list[tuple[int, int]]:
    """Take the most frequent pairs of factors out of the chains, as long as one occurs twice; the pairs get -1, -2, ...

    A pair that is a whole product of its own is taken out as that product, which may be a factor elsewhere.
    """
    users: dict[tuple[int, int], set[Node]] = {}
    for node, factors in chains.items():
        for pair in combinations(factors, 2):
            users.setdefault(pair, set()).add(node)
    heap = [(-len(own), pair) for pair, own in users.items() if len(own) > 1]
    heapify(heap)
    made: list[tuple[int, int]] = []
    while heap:
        count, pair = heappop(heap)
        own = users[pair]
        if len(own) != -count:
            if len(own) > 1:
                heappush(heap, (-len(own), pair))
            continue
        whole = next((node for node in sorted(own) if len(chains[node]) == 2), None)
        if whole is None:
            made.append(pair)
        else:
            own = own - {whole}
        symbol = -len(made) if whole is None else whole
        for node in sorted(own):
            factors = chains[node]
            for old in combinations(factors, 2):
                users[old].discard(node)
            factors.remove(pair[0])
            factors.remove(pair[1])
            factors.append(symbol)
            factors.sort()
            for fresh in combinations(factors, 2):
                users.setdefault(fresh, set()).add(node)
                if len(users[fresh]) > 1:
                    heappush(heap, (-len(users[fresh]), fresh))
    return made
