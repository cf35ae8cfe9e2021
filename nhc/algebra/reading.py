"""The terms of a sum as a reader looks for them; the graph has them in the order in which they were made."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nhc.algebra.graph import ADD, NEG, Graph, Node

_STILL = 2
"""Place of what does not move: behind accelerations (0) and velocities (1), before positions; behind all where it is taken away."""
_LEVELS = {"acceleration": 0, "rate": 0, "coordinate": 3, "entry": 3, "time": 3, "constant": 3, "other": 3}
_VELOCITIES, _POSITIONS, _TAKEN = 1, 3, 4


class Reading:
    """The order of terms: J w' + m v^2 - k x, x^2 + y^2 - 1, 1 - x.

    By the highest derivatives in each, then in the ``order`` of these symbols, or in that of their declaration; one that is
    positive comes first where there is one.
    """

    def __init__(self, graph: Graph, order: Sequence[Node] = ()) -> None:
        self.graph = graph
        self._masks = [0] * (_POSITIONS + 1)
        for k, symbol in enumerate(graph.symbols):
            if symbol.kind != "parameter":
                self._masks[_LEVELS.get(symbol.kind, _VELOCITIES)] |= 1 << k
        known = [graph.deps[node].bit_length() - 1 for node in order]
        self._ranks = {k: i - len(known) for i, k in enumerate(known)}

    def terms(self, total: Node, names: Collection[Node] = ()) -> list[tuple[bool, Node]]:
        """(negative, node) of the terms of a sum; ``names``: nodes inside that are no sums to the reader."""
        g, found, stack = self.graph, list[tuple[bool, Node]](), [(False, total)]
        while stack:
            negative, node = stack.pop()
            op = g.op[node] if node == total or node not in names else ""
            if op == ADD:
                stack += [(negative, g.b[node]), (negative, g.a[node])]
            elif op == NEG:
                stack.append((not negative, g.a[node]))
            else:
                found.append((negative, node))
        mixed = len({self._is_taken(*term) for term in found}) > 1  # the sign of all stands before them
        found.sort(key=lambda term: self._place(mixed and self._is_taken(*term), term[1]))
        first = next((k for k, term in enumerate(found) if not self._is_taken(*term)), 0)
        return [found[first], *found[:first], *found[first + 1 :]]

    def _is_taken(self, negative: bool, node: Node) -> bool:
        value = self.graph.value(node)
        return negative != ((self.graph.split_coefficient(node)[0] if value is None else value) < 0)

    def _place(self, taken: bool, node: Node) -> tuple[int, list[int]]:
        deps = self.graph.deps[node]
        for level, mask in enumerate(self._masks):
            moving = deps & mask
            if moving:
                bits = (k for k in range(moving.bit_length()) if moving >> k & 1)
                return level, sorted(self._ranks.get(k, k) for k in bits)
        return _TAKEN if taken else _STILL, []
