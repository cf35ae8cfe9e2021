"""Expansion into Laurent polynomials with packed monomials."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node

Monomial = tuple[tuple[Node, int], ...]
Coefficient = int | Fraction
Polynomial = dict[Monomial, Coefficient]
Packed = dict[int, Coefficient]

_EXPANDED = frozenset({ADD, MUL, NEG, POW})
_TOP = 1 << 15
_HIGHEST = 1 << 14  # an exponent that still has its own field


class TooLarge(Exception):
    """The canonical form has more terms than allowed."""


class Expander:
    """Expands nodes once each, to :data:`Packed` polynomials: the exponent of atom k stands in bits 16k to 16k + 15 (where it is
    less than zero, the next field lends), so that a product of monomials is a sum of integers.

    ``memo`` holds what is known; None for what has too many terms.  With ``closed``, a sum of parameters (a length b - a) is not
    multiplied out but an atom.
    """

    def __init__(self, graph: Graph, limit: int, circle: bool, closed: bool = False) -> None:
        self.graph, self.limit, self.circle, self.closed = graph, limit, circle, closed
        self.memo: dict[Node, Packed | None] = {}
        self.opened: set[Node] = set()  # in which a sum of parameters was multiplied out
        self._atoms: list[Node] = []
        self._index: dict[Node, int] = {}
        self._height: dict[Node, int] = {}  # the largest exponent that the node's polynomial may have
        self._sine: dict[int, int] = {}  # index of a cosine -> index of its sine
        self._shift = 0  # 2**15 - 2 in every field: a field's top bit then says that its exponent is at least 2
        self._cosines = 0  # the top bits of the cosines' fields

    @property
    def width(self) -> int:
        """How many factors have a place in its monomials."""
        return len(self._atoms)

    def expand(self, roots: Iterable[Node]) -> list[Polynomial]:
        """The roots' polynomials.

        Raises:
            TooLarge: one of them, or a part of it, has more terms than the limit.
        """
        return [self._unpack(self._expand(root)) for root in roots]

    def _expand(self, root: Node) -> Packed:
        memo, opened, kids = self.memo, self.opened, self.graph.kids
        for node in self._pending(root):
            try:
                memo[node] = self._expand_one(node)
            except TooLarge:
                memo[node] = memo[root] = None
                raise
            for kid in kids[node]:
                if kid in opened:
                    opened.add(node)
        known = memo[root]
        assert known is not None
        return known

    def _pending(self, root: Node) -> list[Node]:
        """What is not known yet under the root, operands first."""
        memo, kids = self.memo, self.graph.kids
        if root in memo:
            if memo[root] is None:
                raise TooLarge
            return []
        seen, stack = {root}, [root]
        while stack:
            node = stack.pop()
            if self.graph.op[node] not in _EXPANDED or (self.closed and is_length(self.graph, node)):
                continue
            for child in kids[node]:
                if child in memo:
                    if memo[child] is None:
                        memo[root] = None
                        raise TooLarge
                elif child not in seen:
                    seen.add(child)
                    stack.append(child)
        return sorted(seen)

    def _expand_one(self, node: Node) -> Packed:
        g, memo, height = self.graph, self.memo, self._height
        op, a, b = g.op[node], g.a[node], g.b[node]
        if op == NUM:
            height[node] = 0
            value = g.coefficient[node]
            return {0: value} if value else {}
        if op == ADD and not (self.closed and is_length(g, node)):
            p, q = memo[a], memo[b]
            assert p is not None and q is not None
            height[node] = max(height[a], height[b])
            if is_length(g, node):
                self.opened.add(node)
            return self._bounded(_sum(p, q))
        if op == NEG:
            p = memo[a]
            assert p is not None
            height[node] = height[a]
            return {m: -c for m, c in p.items()}
        if op == MUL:
            p, q = memo[a], memo[b]
            assert p is not None and q is not None
            height[node] = height[a] + height[b]
            if height[node] > _HIGHEST:
                raise TooLarge
            return self._times(p, q)
        if op == POW:
            return self._power(node, a, b)
        height[node] = 1
        return {1 << 16 * self._atom(node): 1}

    def _atom(self, node: Node) -> int:
        known = self._index.get(node)
        if known is None:
            known = self._index[node] = len(self._atoms)
            self._atoms.append(node)
            self._shift |= (_TOP - 2) << 16 * known
            if self.circle and self.graph.op[node] == "cos":
                self._cosines |= _TOP << 16 * known
        return known

    def _power(self, node: Node, base: Node, n: int) -> Packed:
        inner = self.memo[base]
        assert inner is not None
        self._height[node] = height = abs(n) * self._height[base]
        if abs(n) > self.limit or height > _HIGHEST:
            raise TooLarge
        if n < 0:
            if len(inner) == 1:
                ((monomial, c),) = inner.items()
                value = Fraction(c) ** n
                return {monomial * n: value.numerator if value.denominator == 1 else value}
            self._height[node] = -n
            inverse = node if n == -1 else self.graph.power(base, -1)
            return {-n << 16 * self._atom(inverse): 1}
        result: Packed = {0: 1}
        for _ in range(n):
            result = self._times(result, inner)
        return result

    def _times(self, p: Packed, q: Packed) -> Packed:
        if len(p) * len(q) > 8 * self.limit:
            raise TooLarge
        if len(p) == 1 or len(q) == 1:
            if len(q) == 1:
                p, q = q, p
            ((m1, c1),) = p.items()
            result = {m1 + m2: c1 * c2 for m2, c2 in q.items()}
        else:
            result = {}
            get = result.get
            for m1, c1 in p.items():
                for m2, c2 in q.items():
                    m = m1 + m2
                    result[m] = get(m, 0) + c1 * c2
            if 0 in result.values():
                result = {m: c for m, c in result.items() if c}
        if self._cosines:
            shift, cosines = self._shift, self._cosines
            if any(m + shift & cosines for m in result):
                result = self._reduce(result)
        return self._bounded(result)

    def _reduce(self, p: Packed) -> Packed:
        """cos^2 -> 1 - sin^2, until no square of a cosine is left.

        One square of each monomial at a time, so that equal monomials meet on the way: cos^40 has 21 terms, not 2^20.
        """
        done, pending = Packed(), p
        while pending:
            new = Packed()
            for monomial, c in pending.items():
                high = monomial + self._shift & self._cosines
                if not high:
                    done[monomial] = done.get(monomial, 0) + c
                    continue
                cosine = high.bit_length() // 16 - 1
                rest = monomial - (2 << 16 * cosine)
                other = rest + (2 << 16 * self._sine_of(cosine))
                new[rest] = new.get(rest, 0) + c
                new[other] = new.get(other, 0) - c
            if len(new) > 8 * self.limit:
                raise TooLarge
            pending = {m: c for m, c in new.items() if c}
        return {m: c for m, c in done.items() if c}

    def _sine_of(self, cosine: int) -> int:
        known = self._sine.get(cosine)
        if known is None:
            angle = self.graph.a[self._atoms[cosine]]
            known = self._sine[cosine] = self._atom(self.graph.function("sin", angle))
        return known

    def _bounded(self, p: Packed) -> Packed:
        if len(p) > self.limit:
            raise TooLarge
        return p

    def _unpack(self, p: Packed) -> Polynomial:
        return {self._monomial(m): c for m, c in p.items()}

    def _monomial(self, m: int) -> Monomial:
        factors, k = [], 0
        while m:
            empty = (m & -m).bit_length() - 1 >> 4
            m, k = m >> 16 * empty, k + empty
            e = (m + _TOP & 0xFFFF) - _TOP
            factors.append((self._atoms[k], e))
            m, k = m - e >> 16, k + 1
        return tuple(sorted(factors))


def is_length(graph: Graph, node: Node) -> bool:
    """Whether the node is a sum in which nothing stands but parameters and the time."""
    deps = graph.deps[node]
    return graph.op[node] == ADD and deps != 0 and not deps & ~graph.still


def _sum(p: Packed, q: Packed) -> Packed:
    result = dict(p)
    for m, c in q.items():
        known = result.get(m)
        if known is None:
            result[m] = c
        elif known + c:
            result[m] = known + c
        else:
            del result[m]
    return result
