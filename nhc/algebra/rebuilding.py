"""Nodes made anew with others in their place: substitution, at once or with a memory."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.walks import reachable


def substitute(graph: Graph, roots: Sequence[Node], mapping: Mapping[Node, Node], *, named: bool = True) -> list[Node]:
    """The roots with symbols (or whole nodes, below which nothing is looked at) replaced; what does not contain them is kept.

    ``named``: the new values are the old ones where they are used (on the motion, in a scene), so that the user's names stay
    true of them.  They do not where a symbol is put to zero to find its coefficient.
    """
    mask, deps = 0, graph.deps
    for key in mapping:
        mask |= deps[key]
    if not any(deps[root] & mask for root in roots):
        return [mapping.get(root, root) for root in roots]
    new: dict[Node, Node] = dict(mapping)
    op, a, b, labels = graph.op, graph.a, graph.b, graph.labels
    whole = mapping if any(graph.kids[key] for key in mapping) else None
    for node in reachable(graph, roots, mask, whole):
        if node in new:
            continue
        kind, x = op[node], a[node]
        if kind == ADD:
            y = b[node]
            made = graph.add(new.get(x, x), new.get(y, y))
        elif kind == MUL:
            y = b[node]
            made = graph.mul(new.get(x, x), new.get(y, y))
        elif kind == NEG:
            made = graph.neg(new.get(x, x))
        elif kind == POW:
            made = graph.power(new.get(x, x), b[node])
        else:
            made = rebuild(graph, node, [new.get(c, c) for c in graph.kids[node]])
        new[node] = made
        if named and node in labels:
            graph.pass_label(node, made)
    return [new.get(root, root) for root in roots]


class Replacement:
    """A substitution that is used again and again: each node is rebuilt once.  ``named`` as in :func:`substitute`."""

    def __init__(self, graph: Graph, mapping: Mapping[Node, Node], *, named: bool = True) -> None:
        self.graph, self._mask, self._named = graph, graph.mask(tuple(mapping)), named
        self._known: dict[Node, Node] = dict(mapping)

    def of(self, nodes: Sequence[Node]) -> list[Node]:
        """The nodes with the mapping applied."""
        graph, known = self.graph, self._known
        kids, labels = graph.kids, graph.labels
        for node in reachable(graph, nodes, self._mask, known):
            made = known[node] = self.make(node, [known.get(c, c) for c in kids[node]])
            if self._named and node in labels:
                graph.pass_label(node, made)
        return [known.get(node, node) for node in nodes]

    def make(self, node: Node, children: Sequence[Node]) -> Node:
        """What becomes of a node when its operands have been replaced."""
        return rebuild(self.graph, node, children)


def rebuild(graph: Graph, node: Node, children: Sequence[Node]) -> Node:
    """The node's operation on other children."""
    op = graph.op[node]
    if not children:
        return node
    if op == ADD:
        return graph.add(*children)
    if op == MUL:
        return graph.mul(*children)
    if op == NEG:
        return graph.neg(*children)
    if op == POW:
        return graph.power(children[0], graph.b[node])
    return graph.function(op, *children)


def rebuild_over(graph: Graph, node: Node, new: Mapping[Node, Node]) -> Node | None:
    """The node's operation on what its operands have become, with its name; None where they are what they were."""
    kids = graph.kids[node]
    for kid in kids:
        if new.get(kid, kid) != kid:
            made = rebuild(graph, node, [new.get(child, child) for child in kids])
            if node in graph.labels:
                graph.pass_label(node, made)
            return made
    return None
