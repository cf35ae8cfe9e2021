"""Whether one form of an expression keeps the digits of another: what is multiplied out may be a small difference of large terms.

``(x - y)^6`` has an error of its own size, the sum of its seven terms one of the size of ``x^6``; and ``cos(x)^14`` in powers of
the sine has one that is larger than itself where the cosine is small.  Both forms are evaluated with running error bounds
(:mod:`nhc.algebra.probe`) at a few points: anywhere, where all symbols are nearly 1 or -1, so that differences and sums of them are
small, and where all are small themselves.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

from nhc.algebra.calculus import reachable
from nhc.algebra.graph import Graph, Node, Symbol
from nhc.algebra.polynomial import normalise
from nhc.algebra.probe import Probe

_RANGES = ((0.95, 1.05), (0.3, 3.3), (0.01, 0.05)) * 3
_WORSE = 1000.0
"""How much larger a form's error bound may be: other orders of sums and products have bounds that differ by some ten times."""


class _Point(Probe):
    """A probe that evaluates only what is asked for; where a symbol is does not depend on its name."""

    def __init__(self, graph: Graph, number: int) -> None:
        super().__init__(graph, number)
        self._graph = graph
        self._draw, self._range = random.Random(9_000_011 + number), _RANGES[number]
        self._places: dict[Symbol, float] = {}
        self._seen = set[Node]()

    def evaluate(self, roots: Sequence[Node]) -> None:
        """Let values and bounds of these nodes be known."""
        new = reachable(self._graph, roots, known=self._seen)
        self._fill(new)
        self._seen.update(new)

    def loses(self, before: Node, after: Node) -> bool:
        """Whether the second form's bound is much larger here."""
        value, bound, other = self.values[before], self.errors[before], self.errors[after]
        return math.isfinite(value) and bound < math.inf and not other <= _WORSE * bound

    def _place(self, symbol: Symbol) -> float:
        place = self._places.get(symbol)
        if place is None:
            place = self._places[symbol] = self._draw.uniform(*self._range) * self._draw.choice((1, -1))
        return place


def keep_digits(graph: Graph, before: Sequence[Node], after: Sequence[Node]) -> list[Node]:
    """The second forms, or the first ones where the second would lose digits."""
    changed = [k for k, (x, y) in enumerate(zip(before, after, strict=True)) if x != y]
    if not changed:
        return list(after)
    points: list[_Point] = graph.memory.setdefault("digits", [])
    if not points:
        points += [_Point(graph, number) for number in range(len(_RANGES))]
    kept = list(after)
    for point in points:
        point.evaluate([x for k in changed for x in (before[k], after[k])])
        for k in changed:
            if point.loses(before[k], after[k]):
                kept[k] = before[k]
    return kept


def normalise_kept(graph: Graph, node: Node, limit: int) -> Node:
    """The node in canonical form, or the node itself where that would be longer than ``limit`` terms or lose digits."""
    return keep_digits(graph, [node], [normalise(graph, node, limit)])[0]
