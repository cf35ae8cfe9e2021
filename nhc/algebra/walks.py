"""Walks over the graph: which nodes others are made of, and how many.

All passes loop over node numbers (children come before parents), so deep expressions need no deep stack.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence

from nhc.algebra.graph import NEG, POW, Graph, Node

_WALKS = 32  # that are remembered


def reachable(
    graph: Graph, roots: Iterable[Node], within: int = -1, known: Container[Node] | None = None
) -> list[Node]:
    """The nodes that the roots are made of, in increasing order.

    With ``within``, only those that contain one of its symbols; what is ``known`` is left out, and not walked into.
    """
    if within == -1 and known is None:
        return _list_below(graph, roots).copy()
    kids, deps = graph.kids, graph.deps  # a loop for each kind of question: no work is done more often (decision 11)
    seen = {root for root in roots if within == -1 or deps[root] & within}
    if known is not None:
        seen = {root for root in seen if root not in known}
    found = list(seen)
    if known is None:
        for node in found:
            for child in kids[node]:
                if child not in seen and deps[child] & within:
                    seen.add(child)
                    found.append(child)
    elif within == -1:
        for node in found:
            for child in kids[node]:
                if child not in seen and child not in known:
                    seen.add(child)
                    found.append(child)
    else:
        for node in found:
            for child in kids[node]:
                if child not in seen and child not in known and deps[child] & within:
                    seen.add(child)
                    found.append(child)
    found.sort()
    return found


def _list_below(graph: Graph, roots: Iterable[Node]) -> list[Node]:
    """The nodes that the roots are made of, in increasing order: the graph's own list, which nobody else may change."""
    asked, reached = tuple(roots), graph.reached
    if asked in reached:  # passes ask for the same roots one after the other, and each point for those of all claims
        return reached[asked]
    kids = graph.kids
    seen = set(asked)
    found = list(seen)
    for node in found:  # which grows on the way
        for child in kids[node]:
            if child not in seen:
                seen.add(child)
                found.append(child)
    found.sort()
    if len(reached) == _WALKS:
        del reached[next(iter(reached))]
    reached[asked] = found
    return found


def made_of(graph: Graph, roots: Iterable[Node], parts: Iterable[Node]) -> list[Node]:
    """The nodes below the roots that are made of some of the parts, and these themselves, in increasing order."""
    found, kids = set(parts), graph.kids
    order = list[Node]()
    for node in _list_below(graph, roots):
        if node in found or not found.isdisjoint(kids[node]):
            found.add(node)
            order.append(node)
    return order


def count(graph: Graph, roots: Sequence[Node]) -> int:
    """Operations that the shared roots cost; leaves and signs are free, and powers are products."""
    op, kids, exponents, total = graph.op, graph.kids, graph.b, 0
    for node in _list_below(graph, roots):
        kind = op[node]
        if kind == POW:
            size = abs(exponents[node])  # multiplications by squaring, and the division of a negative one
            total += size.bit_length() + size.bit_count() - 2 + (exponents[node] < 0)
        elif kids[node] and kind != NEG:
            total += 1
    return total
