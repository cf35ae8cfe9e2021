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
from functools import cache
from operator import add, mul, neg

from nhc.algebra.graph import ADD, BINARY, MUL, NEG, NUM, PI, SYM, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.probe import UNIT, bounded
from nhc.algebra.walks import count, reachable

_RANGES = ((0.95, 1.05), (0.3, 3.3), (0.01, 0.05)) * 3
_WORSE = 1000.0
"""How much larger a form's error bound may be: other orders of sums and products have bounds that differ by some ten times."""


class _Places:
    """Where the symbols are at all points, in the order in which they are asked for: the same in every graph, drawn once."""

    def __init__(self) -> None:
        self._draws = [(random.Random(9_000_011 + number), range_) for number, range_ in enumerate(_RANGES)]
        self._drawn: list[list[float]] = []

    def get(self, number: int) -> list[float]:
        """Of the symbol with this number."""
        while len(self._drawn) <= number:
            self._drawn.append([draw.uniform(*range_) * draw.choice((1, -1)) for draw, range_ in self._draws])
        return self._drawn[number]


@cache
def _places() -> _Places:
    return _Places()


class _Points:
    """Values at all points together, and their bounds, of the nodes that were asked for; where a symbol is does not depend on its
    name.
    """

    def __init__(self, graph: Graph) -> None:
        self._graph = graph
        self._symbols = 0  # that have a place
        self.values: dict[Node, list[float]] = {}
        self.errors: dict[Node, list[float]] = {}

    def evaluate(self, roots: Sequence[Node]) -> None:
        """Let values and bounds of these nodes be known."""
        op, first, second = self._graph.op, self._graph.a, self._graph.b
        v, e = self.values, self.errors
        for node in reachable(self._graph, roots, known=v):
            kind, a, b = op[node], first[node], second[node]
            if kind == ADD:
                values = v[node] = [*map(add, v[a], v[b])]
                e[node] = [d + f + abs(x) * UNIT for d, f, x in zip(e[a], e[b], values, strict=True)]
            elif kind == MUL:
                p, q = v[a], v[b]
                values = v[node] = [*map(mul, p, q)]
                e[node] = [
                    (abs(x) + d) * f + abs(y) * d + abs(z) * UNIT
                    for x, y, d, f, z in zip(p, q, e[a], e[b], values, strict=True)
                ]
            elif kind == NEG:
                v[node], e[node] = [*map(neg, v[a])], e[a]
            else:
                v[node], e[node] = self._other(kind, node, a, b)

    def loses(self, before: Node, after: Node) -> bool:
        """Whether the second form's bound is much larger at one of the points."""
        known = zip(self.values[before], self.errors[before], self.errors[after], strict=True)
        return any(math.isfinite(x) and bound < math.inf and not other <= _WORSE * bound for x, bound, other in known)

    def _other(self, kind: str, node: Node, a: int, b: int) -> tuple[list[float], list[float]]:
        if kind in (NUM, SYM, PI):
            values = self._place() if kind == SYM else [self._number(kind, node)] * len(_RANGES)
            return values, [abs(x) * UNIT for x in values]
        values, errors = list[float](), list[float]()
        nothing = [math.nan] * len(_RANGES)
        y, other = (self.values[b], self.errors[b]) if kind in BINARY else (nothing, nothing)
        for args in zip(self.values[a], self.errors[a], y, other, strict=True):
            try:
                x, bound = bounded(kind, b, *args)
            except (ArithmeticError, ValueError):
                x, bound = math.nan, math.nan
            values.append(x)
            errors.append(bound + abs(x) * UNIT)
        return values, errors

    def _place(self) -> list[float]:
        self._symbols += 1
        return _places().get(self._symbols - 1)

    def _number(self, kind: str, node: Node) -> float:
        try:
            return math.pi if kind == PI else float(self._graph.coefficient[node])
        except OverflowError:
            return math.nan


def keep_digits(graph: Graph, before: Sequence[Node], after: Sequence[Node]) -> list[Node]:
    """The second forms, or the first ones where the second would lose digits."""
    changed = [k for k, (x, y) in enumerate(zip(before, after, strict=True)) if x != y]
    if not changed:
        return list(after)
    points: _Points | None = graph.memory.get("digits")
    if points is None:
        points = graph.memory["digits"] = _Points(graph)
    points.evaluate([x for k in changed for x in (before[k], after[k])])
    kept = list(after)
    for k in changed:
        if points.loses(before[k], after[k]):
            kept[k] = before[k]
    return kept


def normalise_kept(graph: Graph, node: Node, limit: int) -> Node:
    """The node in canonical form, or the node itself where that would be longer than ``limit`` terms or lose digits."""
    return keep_digits(graph, [node], [normalise(graph, node, limit)])[0]


def shorter_kept(graph: Graph, node: Node, limit: int, beside: Sequence[Node] = ()) -> Node:
    """:func:`normalise_kept` where that takes fewer operations (with what is computed ``beside`` it), else the node itself."""
    made = normalise(graph, node, limit)
    if made == node or count(graph, [made, *beside]) >= count(graph, [node, *beside]):
        return node
    return keep_digits(graph, [node], [made])[0]
