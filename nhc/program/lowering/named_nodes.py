"""Which nodes of a function become lets: those used twice, those of functions worth a name, those that end a long expression."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from nhc.algebra.graph import MUL, NEG, POW, Graph, Node

LONG = 10  # operations in one expression


Operands = Sequence[tuple[Node, ...]]
"""The operands of every node of a graph; of powers that are made of other powers, these."""


def count_uses(graph: Graph, kids: Operands, needed: Sequence[Node], roots: Iterable[Node]) -> dict[Node, int]:
    """How often each node is needed by others; a minus sign passes its uses on, and a square needs its base twice."""
    op, exponent = graph.op, graph.b
    uses: dict[Node, int] = dict.fromkeys(needed, 0)
    for root in roots:
        uses[root] += 1
    for node in reversed(needed):
        kind = op[node]
        weight = uses[node] if kind == NEG else 1
        for child in kids[node]:
            uses[child] += weight
        if kind == POW and exponent[node] in (2, -2) and len(kids[node]) == 1:
            uses[kids[node][0]] += 1
    return uses


def choose_names(
    graph: Graph, kids: Operands, needed: Sequence[Node], roots: Iterable[Node], boundary: set[Node]
) -> list[Node]:
    """The nodes that become lets, in the order of ``needed``; those of ``boundary`` do in any case."""
    uses, size = count_uses(graph, kids, needed, roots), dict[Node, int]()
    op = graph.op
    each_divides = "shared reciprocals" in graph.off
    chosen: list[Node] = []
    for node in needed:
        children = kids[node]
        if not children:
            size[node] = 0
            continue
        kind = op[node]
        if kind == NEG:
            size[node] = size[children[0]]
            continue
        total = 1
        for child in children:
            total += size[child]
        shared = uses[node] > 1 and not (each_divides and kind == POW and graph.b[node] < 0)
        if shared or total > LONG or kind in ("sin", "cos") or node in boundary:
            chosen.append(node)
            total = 0
        size[node] = total
    return chosen


def find_constants(graph: Graph, kids: Operands, needed: Sequence[Node], parameters: int) -> set[Node]:
    """Parameter-only nodes that other work uses: the largest ones."""
    op, deps, moving = graph.op, graph.deps, ~parameters
    boundary = set[Node]()
    for node in needed:
        if not deps[node] & moving and deps[node]:
            continue
        for child in kids[node]:
            if deps[child] and not deps[child] & moving:
                inner = kids[child][0] if op[child] == NEG else child
                if kids[inner]:
                    boundary.add(inner)
    return boundary


def find_shared(graph: Graph, needed: Sequence[Node], seeds: int) -> set[Node]:
    """What the passes of a sweep have in common and use: it is computed once, before them."""
    op, kids, deps, boundary = graph.op, graph.kids, graph.deps, set[Node]()
    for node in needed:
        if deps[node] & seeds:
            for child in kids[node]:
                if not deps[child] & seeds:
                    inner = kids[child][0] if op[child] == NEG else child
                    if kids[inner]:
                        boundary.add(inner)
    return boundary


def find_turned(
    graph: Graph,
    kids: Operands,
    targets: Iterable[Node],
    roots: Iterable[Node],
    needed: Sequence[Node],
    named: Collection[Node],
    is_constant: Callable[[Node], bool],
) -> dict[Node, Node]:
    """Products without a name of which minus is a target, each with a named constant factor that nothing but such products uses: it
    takes the sign, once and not at every state.
    """
    g = graph
    inner = [g.a[node] for node in targets if g.op[node] == NEG]
    products = [node for node in inner if g.op[node] == MUL and node not in named]
    if not products:
        return {}
    uses = count_uses(graph, kids, needed, roots)
    users: dict[Node, list[Node]] = {}
    for product in dict.fromkeys(products):
        if uses[product] == 1:
            for factor in g.kids[product]:
                if factor in named and is_constant(factor):
                    users.setdefault(factor, []).append(product)
    found = dict[Node, Node]()
    for factor, own in users.items():
        if uses[factor] == len(own) and found.keys().isdisjoint(own):
            found |= dict.fromkeys(own, factor)
    return found
