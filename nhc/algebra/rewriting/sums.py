"""Sums that several longer sums have in common, made once.

Sums are binary and keep the order in which they were made: ``(a + b) - c`` and ``(a - c) + d`` do not show that they share
``a - c``.  As :mod:`nhc.algebra.rewriting.products` does for factors, the terms of each sum are looked at together, and pairs that
occur in several are taken out, the most frequent first; ``b - a`` is ``a - b`` with the other sign.  What is used more than once is
one term and stays whole.

Most functions have few sums with two terms in common.  So terms of one sum alone are left out before any pairs are made; and when a
pair is taken out, only the pairs with one of its terms change.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations

from nhc.algebra.graph import ADD, NEG, Graph, Node
from nhc.algebra.rewriting.pairs import Pairs

_MOST_TERMS = 12
Terms = dict[int, int]
"""The sign of each term, in the order of the sum."""
Pair = tuple[int, int, int]
"""Two terms in increasing order, and the product of their signs: their sum, or their difference."""


def share_terms(
    graph: Graph, nodes: Sequence[Node], uses: Mapping[Node, int]
) -> tuple[dict[Node, Terms], set[Node], list[Pair]]:
    """The terms of those sums among the nodes that share some, what is only a part of these, and the pairs that they share."""
    if "shared sums" in graph.off:
        return {}, set(), []
    chains, parts = _chains(graph, nodes, uses)
    pairs, changed = pair_terms(chains)
    return {node: chains[node] for node in changed}, {part for node in changed for part in parts.get(node, ())}, pairs


def _chains(
    graph: Graph, nodes: Sequence[Node], uses: Mapping[Node, int]
) -> tuple[dict[Node, Terms], dict[Node, list[Node]]]:
    """The terms of every sum that is no part of a longer one, and the nodes that are parts of each."""
    op, kids = graph.op, graph.kids
    chains: dict[Node, Terms] = {}
    parts: dict[Node, list[Node]] = {}
    inner: set[Node] = set()
    for node in [node for node in reversed(nodes) if op[node] == ADD]:
        if node in inner:
            continue
        first, second = kids[node]
        terms, within, stack = Terms(), list[Node](), [(second, 1), (first, 1)]
        while stack:
            child, sign = stack.pop()
            kind = op[child]
            if kind == NEG:
                own, side = kids[child][0], -sign
                kind = op[own]
            else:
                own, side = child, sign
            if kind == ADD and uses[child] == 1 and uses[own] == 1 and len(terms) + len(stack) + 2 <= _MOST_TERMS:
                within += (child, own)
                stack += [(part, side) for part in reversed(kids[own])]
            elif own in terms:
                break
            else:
                terms[own] = side
        else:
            chains[node] = terms
            if within:
                parts[node] = within
                inner.update(within)
    return chains, parts


def pair_terms(chains: Mapping[Node, Terms]) -> tuple[list[Pair], set[Node]]:
    """Take the most frequent pairs of terms out of the chains, as long as one occurs twice; the pairs get -1, -2, ...

    A pair that is a whole sum of its own is taken out as that sum.  Also the sums that have changed.
    """
    often: dict[int, int] = {}
    for terms in chains.values():
        for term in terms:
            often[term] = often.get(term, 0) + 1
    users: dict[Pair, set[Node]] = {}
    for node, terms in chains.items():
        common = [term for term in terms if often[term] > 1]
        if len(common) > 1:
            for a, b in combinations(common, 2):
                users.setdefault(_key(terms, a, b), set()).add(node)
    pairs, made, changed = Pairs(users), list[Pair](), set[Node]()
    for pair, own in pairs:
        a, b = pair[:2]
        whole = next((node for node in sorted(own) if len(chains[node]) == 2), None)
        if whole is None:
            made.append(pair)
            symbol, turn = -len(made), 1
        else:
            symbol, turn = whole, chains[whole][a]
        for node in sorted(own):
            terms = chains[node]
            if node == whole or symbol in terms:
                own.discard(node)
                continue
            changed.add(node)
            _leave(users, terms, node, pair)
            side = terms[a] * turn
            del terms[a], terms[b]
            others = [term for term in terms if often.get(term) != 1]
            terms[symbol] = side
            for term in others:
                pairs.add(_key(terms, symbol, term), node)
    return made, changed


def _leave(users: Mapping[Pair, set[Node]], terms: Terms, node: Node, pair: Pair) -> None:
    """The sum no longer has the pairs that contain a term of this one."""
    for term in pair[:2]:
        for other in terms:
            own = users.get(_key(terms, term, other)) if other != term else None
            if own is not None:
                own.discard(node)


def _key(terms: Mapping[int, int], a: int, b: int) -> Pair:
    return (a, b, terms[a] * terms[b]) if a < b else (b, a, terms[a] * terms[b])
