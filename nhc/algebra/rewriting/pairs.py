"""Pairs of what products and sums have in common, the most frequent first, while pairs come and go."""

from __future__ import annotations

from collections.abc import Iterator
from heapq import heapify, heappop, heappush
from typing import Generic, TypeVar

from nhc.algebra.graph import Node

Pair = TypeVar("Pair", bound=tuple[int, ...])


class Pairs(Generic[Pair]):
    """``users`` are the nodes that have each pair; they may be taken out of it, and come in by :meth:`add`."""

    def __init__(self, users: dict[Pair, set[Node]]) -> None:
        self.users = users
        self._heap = [(-len(own), pair) for pair, own in users.items() if len(own) > 1]
        heapify(self._heap)

    def __iter__(self) -> Iterator[tuple[Pair, set[Node]]]:
        """Each time the pair that most nodes have, with these, as long as one is in two; the smaller one of two as frequent."""
        heap, users = self._heap, self.users
        while heap:
            count, pair = heappop(heap)
            own = users[pair]
            if len(own) == -count:
                yield pair, own
            elif len(own) > 1:
                heappush(heap, (-len(own), pair))

    def add(self, pair: Pair, node: Node) -> None:
        """The node has this pair, too."""
        own = self.users.setdefault(pair, set())
        own.add(node)
        if len(own) > 1:
            heappush(self._heap, (-len(own), pair))
