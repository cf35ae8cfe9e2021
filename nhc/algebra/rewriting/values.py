"""Nodes that are equal become one node, however they were made.

The graph makes two nodes one where they are written alike.  Sums over bodies, eliminations and derivatives also arrive at one value
by different ways: ``a*(b*c)`` and ``(a*b)*c``, ``x - (y + z)`` and ``(x - y) - z``, the mixed slopes of a potential.  Every node is
given its value at two random points of prime fields (as in global value numbering, Alpern, Wegman and Zadeck 1988, with values in
place of names: Gulwani and Necula 2004); what is equal at both, or opposite, is computed once.

Roots, absolute values and signs are arbitrary functions of their arguments' values here, so that no branch of theirs is taken for
granted.  What takes the place of another node divides by nothing, and takes no root or logarithm, that the other one does not; a
product is rather kept than a sum, in which digits may cancel.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.residues import PRIMES, circle_points
from nhc.algebra.graph import ADD, NEG, POW, Graph, Node
from nhc.algebra.rebuilding import rebuild_over
from nhc.algebra.walks import reachable

_LEAST = (0, 1)  # the nodes of these numbers: what vanishes is found, too
_POINTS, _DRAWS, _AT_ONCE = 2, 20, 4
_ARBITRARY = frozenset({"sqrt", "abs", "sign", "min", "max"})
_PARTIAL = frozenset({"sqrt", "log", "asin", "acos", "atan2", "powf"})
"""Operations that have no value, or no slope, everywhere."""


class ArbitraryPoint(FieldPoint):
    """A point at which roots and signs are arbitrary functions."""

    def __init__(self, graph: Graph, seed: int, prime: int) -> None:
        super().__init__(graph, seed, prime)
        self._points: dict[int, tuple[int, int]] = {}
        self._spare: list[tuple[int, int]] = []

    def _point(self, generator: int) -> tuple[int, int]:
        point = self._points.get(generator)
        if point is None:
            if not self._spare:
                self._spare = circle_points(
                    [self._random.randrange(2, self.prime) for _ in range(_AT_ONCE)], self.prime
                )
            point = self._points[generator] = self._spare.pop()
        return point

    def _generator(self, *key: object) -> int:
        value = self._generators.get(key)
        if value is None:  # in the order of the questions: no other point has to have the same
            value = self._generators[key] = self._random.randrange(2, self.prime - 1)
        return value

    def _root(self, x: int) -> int:
        return self._generator("sqrt", x)

    def complete(self, nodes: Sequence[Node]) -> None:
        """Residues of nodes that stand in order behind all that they are made of, where they have none yet.

        Raises:
            Unlucky: as in :meth:`evaluate`.
        """
        todo = [node for node in nodes if node not in self.values]
        self._prepare(todo)
        self.fill(todo)

    def _other(self, op: str, node: Node) -> int:
        if op in _ARBITRARY:
            return self._generator(op, *(self.values[child] for child in self.graph.kids[node]))
        return super()._other(op, node)


def find_equal(graph: Graph, nodes: Sequence[Node], first: Collection[Node] = ()) -> dict[Node, Node]:
    """For each of these nodes that has the value of another one, that other: one of ``first``, or the one that was made sooner.

    None has itself below it, so each may take the other's place.
    """
    keys: dict[Node, tuple[int, ...]] = dict.fromkeys(nodes, ())
    for index in range(_POINTS):
        point = draw_point(graph, index, reachable(graph, nodes))
        if point is None:
            return {}
        keys = {node: (*key, point.values[node]) for node, key in keys.items()}
    found, kept = dict[Node, Node](), dict[tuple[int, ...], Node]()
    for node in sorted(nodes, key=lambda node: (node not in first, node)):
        same = kept.setdefault(keys[node], node)
        if same != node and node not in reachable(graph, [same]):
            found[node] = same
    return found


def share_values(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots in which nodes of one value, up to its sign, are one node."""
    if "equal values" in graph.off:
        return list(roots)
    needed = [*_LEAST, *(node for node in reachable(graph, roots) if node not in _LEAST)]
    classes = [needed]
    for index in range(_POINTS):
        open_ = reachable(graph, [node for members in classes for node in members]) if index else needed
        point = draw_point(graph, index, open_)
        if point is None:
            return list(roots)
        classes = [part for members in classes for part in _split(graph, members, point)]
        if not classes:
            return list(roots)
    return _Merging(graph, needed, classes).replace(roots)


def draw_point(graph: Graph, index: int, nodes: Sequence[Node]) -> ArbitraryPoint | None:
    """A point modulo the index-th prime with values for the nodes, which stand in order behind all that they are made of.

    Values from other functions of the graph are taken over.
    """
    kept: dict[int, ArbitraryPoint] = graph.memory.setdefault("arbitrary points", {})
    for seed in range(_DRAWS):
        point = kept.get(index)
        if point is None:
            point = kept[index] = ArbitraryPoint(graph, 7_000_003 + seed, PRIMES[index])
        try:
            point.complete(nodes)
        except Unlucky:
            del kept[index]
        else:
            return point
    return None


def _split(graph: Graph, nodes: Iterable[Node], point: FieldPoint) -> list[list[Node]]:
    """The nodes in groups of one value up to its sign, in increasing order; those that are alone are left out."""
    first: dict[int, Node] = {}
    found: dict[int, list[Node]] = {}
    op, values, p = graph.op, point.values, point.prime
    for node in nodes:
        if op[node] != NEG:
            x = values[node]
            key = min(x, p - x)
            other = first.setdefault(key, node)
            if other != node:
                found.setdefault(key, [other]).append(node)
    return list(found.values())


class _Merging:
    """One node in the place of each class of equal ones, made from the operands upwards."""

    def __init__(self, graph: Graph, needed: Sequence[Node], classes: Iterable[list[Node]]) -> None:
        self.graph, self._needed = graph, needed
        self._same = {node: members for members in classes for node in members}
        self._values = graph.memory["arbitrary points"][0].values
        self._poles = find_poles(graph, needed, self._values)
        self._new: dict[Node, Node] = {}

    def replace(self, roots: Iterable[Node]) -> list[Node]:
        """The roots over one node for each class."""
        new, same, kids = self._new, self._same, self.graph.kids
        for node in self._needed:
            if node in same:
                if node not in new:
                    self._settle(node)
            elif new and node not in new:
                for kid in kids[node]:
                    if kid in new:
                        self._make(node)
                        break
        return [self._new.get(root, root) for root in roots]

    def _settle(self, node: Node, *, ahead: bool = True) -> None:
        """What becomes of a node whose operands are settled; ``ahead``: a later product of its value may be made first."""
        g, new, members = self.graph, self._new, self._same.get(node)
        if members is None:
            if new:
                self._make(node)
            return
        known = next((m for m in members if m in new and self._may_stand(m, node)), None)
        if known is None and ahead and g.op[node] == ADD:
            known = next((m for m in members if m > node and g.op[m] != ADD and self._may_stand(m, node)), None)
            if known is not None:
                for inner in self._list_above(known, node):
                    if inner not in new:
                        self._settle(inner, ahead=False)
        if known is None:
            self._make(node)
            new.setdefault(node, node)
            return
        made = new[known]
        if self._values[known] == self._values[node]:
            new[node] = made
            g.pass_label(node, made)
        else:
            new[node] = g.neg(made)

    def _make(self, node: Node) -> None:
        """The node over what its operands have become, where that is another one."""
        made = rebuild_over(self.graph, node, self._new)
        if made is not None:
            self._new[node] = made

    def _may_stand(self, other: Node, node: Node) -> bool:
        return not self._poles[other] & ~self._poles[node]

    def _list_above(self, root: Node, node: Node) -> list[Node]:
        """What the root is made of and that was made after the node."""
        found, stack = {root}, [root]
        while stack:
            for kid in self.graph.kids[stack.pop()]:
                if kid > node and kid not in found:
                    found.add(kid)
                    stack.append(kid)
        return sorted(found)


def find_poles(graph: Graph, nodes: Sequence[Node], values: Mapping[Node, int]) -> dict[Node, int]:
    """For each node the places where it has no value or no slope: a bit for each operation and value of its operand."""
    op, first, exponent, kids = graph.op, graph.a, graph.b, graph.kids
    bits: dict[tuple[str, int], int] = {}
    found: dict[Node, int] = {}
    for node in nodes:
        mask = 0
        for kid in kids[node]:
            mask |= found[kid]
        kind = op[node]
        if kind in _PARTIAL or (kind == POW and exponent[node] < 0):
            mask |= bits.setdefault((kind, values[first[node]]), 1 << len(bits))
        found[node] = mask
    return found
