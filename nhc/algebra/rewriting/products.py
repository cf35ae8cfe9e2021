"""Products that several longer products have in common, made once.

Products are binary and keep the order in which they were made: ``v*(k*a)`` and ``v*(k*b)`` do not show that they share ``v*k``.
Here the factors of each product are looked at together, and pairs that occur in several are taken out, the most frequent first.
What is used more than once is one factor and stays whole.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from nhc.algebra.graph import MUL, Graph, Node
from nhc.algebra.rewriting.pairs import Pairs

_MOST_FACTORS = 10
Factors = list[int]
"""In increasing order; -1, -2, ... are the pairs that were taken out."""


def share_factors(
    graph: Graph, nodes: Sequence[Node], uses: Mapping[Node, int], constants: int
) -> tuple[dict[Node, Factors], set[Node], list[tuple[int, int]]]:
    """The factors of the products among the nodes, what is only a part of these, and the pairs that they share; nothing where
    neither a pair occurs twice nor ``constants`` (a mask) stand apart in one.  What contains constants only stays whole.
    """
    if "shared products" in graph.off:
        return {}, set(), []
    chains, inner = _chains(graph, nodes, uses, constants)
    fixed = _constant_factors(graph, chains, constants)
    pairs, changed = _share(chains)
    return (chains, inner, pairs) if fixed or changed else ({}, set(), [])


def _constant_factors(graph: Graph, chains: Mapping[Node, Factors], constants: int) -> bool:
    """Whether some product has more than one constant factor."""
    deps, moves = graph.deps, ~constants
    return any(len([f for f in own if not deps[f] & moves]) > 1 for own in chains.values())


def _chains(
    graph: Graph, nodes: Sequence[Node], uses: Mapping[Node, int], constants: int
) -> tuple[dict[Node, Factors], set[Node]]:
    """The factors of every product that is no part of a longer one, and the products that are."""
    op, kids, deps, moves = graph.op, graph.kids, graph.deps, ~constants
    chains: dict[Node, Factors] = {}
    inner: set[Node] = set()
    for node in reversed(nodes):
        if op[node] != MUL or node in inner or not deps[node] & moves:
            continue
        factors, stack = Factors(), [node]
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


def _share(chains: dict[Node, Factors]) -> tuple[list[tuple[int, int]], bool]:
    """Take the most frequent pairs of factors out of the chains, as long as one occurs twice; the pairs get -1, -2, ...

    A pair that is a whole product of its own is taken out as that product, which may be a factor elsewhere.  Also whether any chain
    has changed.
    """
    users: dict[tuple[int, int], set[Node]] = {}
    for node, factors in chains.items():
        for pair in combinations(factors, 2):
            users.setdefault(pair, set()).add(node)
    pairs, made, changed = Pairs(users), list[tuple[int, int]](), False
    for pair, own in pairs:
        whole = next((node for node in sorted(own) if len(chains[node]) == 2), None)
        if whole is None:
            made.append(pair)
        symbol = -len(made) if whole is None else whole
        for node in sorted(own - {whole}):
            factors, changed = chains[node], True
            for old in combinations(factors, 2):
                users[old].discard(node)
            factors.remove(pair[0])
            factors.remove(pair[1])
            factors.append(symbol)
            factors.sort()
            for fresh in combinations(factors, 2):
                pairs.add(fresh, node)
    return made, changed
