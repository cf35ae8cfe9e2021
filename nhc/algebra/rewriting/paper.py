"""The shortest known writing of a node, for paper: canonical forms, sums of angles joined, denominators in factors."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress

from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import ADD, POW, Graph, Node
from nhc.algebra.polynomial import normalise, polynomial, to_node
from nhc.algebra.rebuilding import rebuild, substitute
from nhc.algebra.rewriting.joined import join_sums, join_terms, make_product, split_factors
from nhc.algebra.walks import reachable

Size = Callable[[Node], int]
_TURNED = ("sin", "cos")
_READ = 40  # operations up to which a formula is read as a whole; what longer ones share with others counts more
_TRIED = 3 * _READ


def shortest(graph: Graph, node: Node, limit: int, size: Size) -> Node:
    """The node, or an equal one that is shorter; no canonical form has more than ``limit`` terms."""
    plain = min((node, normalise(graph, node, limit)), key=size)
    if size(plain) > _TRIED:
        return plain
    opened = _open_denominators(graph, node, limit, size)
    best = min(_forms(graph, dict.fromkeys((plain, node, opened)), limit), key=size)
    best = _shorten_sums(graph, best, limit, size)
    return best if size(best) <= _READ else plain


def _forms(graph: Graph, nodes: Iterable[Node], limit: int) -> list[Node]:
    found = list[Node]()
    for node in nodes:
        found += [node, normalise(graph, node, limit), *_joined(graph, node, limit)]
    return found


def _joined(graph: Graph, node: Node, limit: int) -> list[Node]:
    """With sums of angles, before and after the canonical form; none where no two terms can be joined."""
    op = graph.op
    if len({graph.a[part] for part in reachable(graph, [node]) if op[part] in _TURNED}) < 2:
        return []
    found = list[Node]()
    (joined,) = join_sums(graph, [node], {part: part for part in reachable(graph, [node]) if _is_divisor(graph, part)})
    if joined != node:
        found += [joined, normalise(graph, joined, limit)]
    with suppress(TooLarge):
        p = polynomial(graph, node, limit)
        made = join_terms(graph, p)
        if made != p:
            found.append(to_node(graph, made))
    return found


def _shorten_sums(graph: Graph, root: Node, limit: int, size: Size) -> Node:
    """With shorter forms of the sums in it: one that gets longer when multiplied out may stand beside one that vanishes."""
    new: dict[Node, Node] = {}
    for node in reachable(graph, [root]):
        children = graph.children(node)
        made = node
        if not _is_divisor(graph, node) and any(new[kid] != kid for kid in children):
            made = rebuild(graph, node, [new[kid] for kid in children])
        if graph.op[made] == ADD:
            made = min(_forms(graph, [made], limit), key=size)
        new[node] = made
    return new[root]


def _open_denominators(graph: Graph, node: Node, limit: int, size: Size) -> Node:
    """The factors of sums in denominators apart, so that they may cancel; what has none stays, the same wherever it stands."""
    new: dict[Node, Node] = {}
    for part in reachable(graph, [node]):
        if _is_divisor(graph, part):
            n, (k, factors) = graph.b[part], split_factors(graph, shortest(graph, graph.a[part], limit, size))
            if abs(k) != 1 or len(factors) > 1:
                apart = make_product(graph, tuple((f, e * n) for f, e in factors))
                new[part] = graph.mul(graph.power(graph.number(k), n), apart)
    return substitute(graph, [node], new)[0] if new else node


def _is_divisor(graph: Graph, node: Node) -> bool:
    """Whether the node is a sum below a fraction line."""
    return graph.op[node] == POW and graph.b[node] < 0 and graph.op[graph.a[node]] == ADD
