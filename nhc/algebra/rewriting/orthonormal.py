"""Entries of rotation matrices on paper: what is 0, 1 or another entry because rows and columns are orthonormal.

The entries are symbols here.  The three products R_ki R_kj of two columns, or R_ik R_jk of two rows, add up to 1 or 0, so that two
of three with one factor before them are minus the third; and an entry is its own minor, R_x1 = R_y2 R_z3 - R_y3 R_z2.  Each step
leaves fewer terms, or at least fewer products of entries.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations_with_replacement

from nhc.algebra.expand import Coefficient, Monomial, Polynomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.terms import add_term

Matrix = Sequence[Sequence[Node]]
_LIMIT = 150  # terms of a sum that is looked at


class Orthonormal:
    """Reduces sums over the entries of some matrices, each a rotation's."""

    def __init__(self, graph: Graph, matrices: Sequence[Matrix]) -> None:
        self.graph = graph
        self._triples: dict[Monomial, list[tuple[Monomial, Monomial, int]]] = {}
        """A product -> the two others with the number that the three add up to."""
        self._minors: dict[Monomial, list[tuple[Monomial, int, Node]]] = {}
        """A product -> the one that it is taken together with, the sign of the product, and the entry."""
        for matrix in matrices:
            for lines in (matrix, list(zip(*matrix, strict=True))):
                for i, j in combinations_with_replacement(range(3), 2):
                    self._add_triple([_product(a, b) for a, b in zip(lines[i], lines[j], strict=True)], int(i == j))
            for i in range(3):
                for j in range(3):
                    (k, m), (r, s) = ((i + 1) % 3, (i + 2) % 3), ((j + 1) % 3, (j + 2) % 3)
                    first, second = _product(matrix[k][r], matrix[m][s]), _product(matrix[k][s], matrix[m][r])
                    self._minors.setdefault(first, []).append((second, 1, matrix[i][j]))
                    self._minors.setdefault(second, []).append((first, -1, matrix[i][j]))
        self._entries = {entry for matrix in matrices for row in matrix for entry in row}
        self.mask = graph.mask(self._entries)

    def _add_triple(self, products: Sequence[Monomial], total: int) -> None:
        for k, own in enumerate(products):
            second, third = (p for i, p in enumerate(products) if i != k)
            self._triples.setdefault(own, []).append((second, third, total))

    def shorten(self, node: Node, size: Callable[[Node], int]) -> Node:
        """An equal node of a smaller size, where one is found."""
        try:
            p = polynomial(self.graph, node, _LIMIT)
        except TooLarge:
            return node
        found, before = [node], dict(p)
        for swap in (False, True):
            self._reduce(p, swap)
            if p != before:
                found.append(to_node(self.graph, p))
        return min(found, key=size)

    def _reduce(self, p: Polynomial, swap: bool) -> None:
        """Use the relations as long as they leave fewer terms, in place; with ``swap`` also a^2 + b^2 = 1 - c^2."""
        waiting = list(p)
        while waiting:
            m = waiting.pop()
            c = p.get(m)
            if c:
                waiting += self._step(p, m, c, swap)

    def _step(self, p: Polynomial, m: Monomial, c: Coefficient, swap: bool) -> list[Monomial]:
        """One relation with this term, where one fits: the terms that it has changed."""
        for product, rest in self._pairs(m):
            for second, third, total in self._triples.get(product, ()):
                others = [_times(rest, second), _times(rest, third)]
                here = [p.get(other) == c for other in others]
                if all(here):
                    return _replace(p, [m, *others], [(rest, c)] if total else [])
                if any(here) and (swap or not total):
                    own, left = others if here[0] else others[::-1]
                    return _replace(p, [m, own], [(left, -c), *([(rest, c)] if total else [])])
            for partner, sign, entry in self._minors.get(product, ()):
                other = _times(rest, partner)
                if p.get(other) == -c:
                    return _replace(p, [m, other], [(_times(rest, ((entry, 1),)), sign * c)])
        return []

    def _pairs(self, m: Monomial) -> Iterator[tuple[Monomial, Monomial]]:
        """The products of two entries in a monomial, with what is left of it."""
        own = [(f, e) for f, e in m if f in self._entries and e > 0]
        for k, (a, e) in enumerate(own):
            for b, _ in own[k:]:
                if a != b or e > 1:
                    product = _product(a, b)
                    yield product, _times(m, tuple((f, -n) for f, n in product))


def _replace(p: Polynomial, old: Sequence[Monomial], new: Sequence[tuple[Monomial, Coefficient]]) -> list[Monomial]:
    for m in old:
        del p[m]
    for m, c in new:
        add_term(p, m, c)
    return [m for m, _ in new]


def _product(a: Node, b: Node) -> Monomial:
    return ((a, 2),) if a == b else tuple(sorted(((a, 1), (b, 1))))


def _times(m: Monomial, other: Monomial) -> Monomial:
    powers = dict(m)
    for factor, n in other:
        powers[factor] = powers.get(factor, 0) + n
    return tuple(sorted((f, n) for f, n in powers.items() if n))
