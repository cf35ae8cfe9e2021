"""Roots of squares, sqrt(r^2 cos(f)^2 + r^2 sin(f)^2) = r, where the declared ranges of coordinates tell the sign."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from fractions import Fraction

from nhc.algebra.bounds.interval import Interval, bounds
from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import Replacement
from nhc.algebra.terms import root
from nhc.mechanics.system import System
from nhc.mechanics.values import coordinate_ranges

_TERMS = 60
"""Terms under a root that is looked at."""
_ROUNDING = 1e-12
"""Of the sine at ends of ranges, as at pi."""


def open_roots(system: System, nodes: Sequence[Node]) -> tuple[list[Node], list[str], list[str]]:
    """The nodes without roots of what is a square in the ranges of the system's coordinates; the names of the coordinates whose
    ranges were needed, and of those that would need one.
    """
    opened = _Roots(system.graph, system.q, coordinate_ranges(system))
    made, pairs = opened.of(nodes), list(zip(system.q_names, system.q, strict=True))
    used = [name for name, q in pairs if system.graph.deps[q] & opened.used]
    return made, used, [name for name, q in pairs if q in opened.unsigned]


class _Roots(Replacement):
    """``used`` are the symbols whose ranges were needed, as a mask; ``unsigned`` those that may have either sign."""

    def __init__(self, graph: Graph, coordinates: Sequence[Node], ranges: Mapping[Node, Interval]) -> None:
        super().__init__(graph, {q: q for q in coordinates}, named=False)
        self._ranges, self.used = ranges, 0
        self.unsigned = set[Node]()

    def make(self, node: Node, children: Sequence[Node]) -> Node:
        if self.graph.op[node] == "sqrt":
            with suppress(TooLarge):
                opened = self._open(children[0])
                if opened is not None:
                    return opened
        return super().make(node, children)

    def _open(self, under: Node) -> Node | None:
        g, p = self.graph, polynomial(self.graph, under, _TERMS)
        found = root(g, p) if p else None
        if found is None:
            return None
        square, monomial = found
        size = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
        odd = [factor for factor, e in monomial if e % 2]
        signs = [self._sign(factor) for factor in odd]
        if size**2 != square or not all(signs):
            self.unsigned.update(factor for factor, sign in zip(odd, signs, strict=True) if not sign)
            return None
        self.used |= g.deps[g.product(odd)]
        return g.mul_number(math.prod(signs), to_node(g, {monomial: size}))

    def _sign(self, factor: Node) -> int:
        """1 or -1 where the factor is of one sign for the ranges, else 0."""
        low, high = bounds(self.graph, factor, self._ranges)
        return 1 if low >= -_ROUNDING else -1 if high <= _ROUNDING else 0
