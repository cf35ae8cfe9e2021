"""Zero tests of what holds few signs: at one point these take both values, in place of the many points at which they fall so.

A polynomial of degree m in signs that vanishes where at most m of them differ from what they are at a point vanishes for all of
their values: its terms follow from these values one after the other, those of no sign first.  That takes two evaluations for one
sign, where random points take 24 for each value that it might have.  Nothing is concluded from a value that is not zero, for signs
that are taken for independent here need not be so: abs(x y) is abs(x) abs(y).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from math import comb

from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.signs import Signs, bits_of
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import made_of, reachable

_MOST = 64  # evaluations at a point
_TURNED = frozenset(("sign", "abs", "sqrt", "min", "max"))


def vanish_for_both_signs(signs: Signs, nodes: Sequence[Node], points: Sequence[FieldPoint]) -> set[Node]:
    """Those of the nodes, all of them zero at the points and evaluated there, that are so whichever values their signs have."""
    graph, alive = signs.graph, list(nodes)
    if not _are_apart(signs, nodes):
        return set()
    for chosen in _choices(signs, nodes):
        turned = {node for number in chosen for node in signs.holders[number]}
        stale = made_of(graph, alive, turned)
        for point in points:
            other = point.beside(stale)
            try:
                for node in turned.intersection(stale):
                    other.values[node] = _turn(graph, point, node)
                other.fill(node for node in stale if node not in turned)
            except Unlucky:
                return set()
            alive = [node for node in alive if not other.values[node]]
    return set(alive)


def _choices(signs: Signs, nodes: Sequence[Node]) -> Iterator[tuple[int, ...]]:
    """The sets of signs that change together."""
    mask, degree = signs.mask_and_degree(nodes)
    numbers = bits_of(mask)
    for size in range(1, degree + 1):
        yield from combinations(numbers, size)


def _are_apart(signs: Signs, nodes: Sequence[Node]) -> bool:
    """Whether the signs can be changed here: they are few, none stands in another, and each is one of a value, no turn or power."""
    graph = signs.graph
    mask, degree = signs.mask_and_degree(nodes)
    numbers = bits_of(mask)
    if sum(comb(len(numbers), size) for size in range(1, degree + 1)) > _MOST:
        return False
    holders = {node for number in numbers for node in signs.holders[number]}
    below = [child for node in holders for child in graph.children(node)]
    return all(graph.op[node] in _TURNED for node in holders) and holders.isdisjoint(reachable(graph, below))


def _turn(graph: Graph, point: FieldPoint, node: Node) -> int:
    """The value with the other sign: of two numbers the other one, else the negative."""
    whole = sum(point.values[child] for child in graph.children(node)) if graph.op[node] in ("min", "max") else 0
    return (whole - point.values[node]) % point.prime
