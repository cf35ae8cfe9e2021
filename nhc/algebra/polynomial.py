"""Canonical Laurent polynomials over the graph: what is small enough is brought to one form modulo sin^2 + cos^2 = 1.

A monomial is a tuple of (node, exponent) pairs in increasing order of node, a polynomial maps monomials to rationals.  An atom is
whatever is not a sum, product or integer power (symbols, sin, sqrt, reciprocals of sums).  Everything is bounded by ``limit``
terms: what would grow past it raises :class:`TooLarge` and the caller keeps the graph's own form.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node

Monomial = tuple[tuple[Node, int], ...]
Coefficient = int | Fraction
Polynomial = dict[Monomial, Coefficient]
Packed = dict[int, Coefficient]

ONE: Monomial = ()
_EXPANDED = frozenset({ADD, MUL, NEG, POW})
_TOP = 1 << 15
_HIGHEST = 1 << 14  # an exponent that still has its own field


class TooLarge(Exception):
    """The canonical form has more terms than allowed."""


def polynomial(graph: Graph, node: Node, limit: int = 300, circle: bool = True) -> Polynomial:
    """The node as a canonical polynomial; with ``circle``, cos^2 is written 1 - sin^2."""
    return Expander(graph, limit, circle).expand([node])[0]


class Expander:
    """Expands nodes once each, to :data:`Packed` polynomials: the exponent of atom k stands in bits 16k to 16k + 15 (where it is
    less than zero, the next field lends), so that a product of monomials is a sum of integers.

    ``memo`` holds what is known; None for what has too many terms.
    """

    def __init__(self, graph: Graph, limit: int, circle: bool) -> None:
        self.graph, self.limit, self.circle = graph, limit, circle
        self.memo: dict[Node, Packed | None] = {}
        self._atoms: list[Node] = []
        self._index: dict[Node, int] = {}
        self._height: dict[Node, int] = {}  # the largest exponent that the node's polynomial may have
        self._sine: dict[int, int] = {}  # index of a cosine -> index of its sine
        self._shift = 0  # 2**15 - 2 in every field: a field's top bit then says that its exponent is at least 2
        self._cosines = 0  # the top bits of the cosines' fields

    def expand(self, roots: Iterable[Node]) -> list[Polynomial]:
        """The roots' polynomials.

        Raises:
            TooLarge: one of them, or a part of it, has more terms than the limit.
        """
        return [self._unpack(self._expand(root)) for root in roots]

    def _expand(self, root: Node) -> Packed:
        memo = self.memo
        for node in self._pending(root):
            try:
                memo[node] = self._expand_one(node)
            except TooLarge:
                memo[node] = memo[root] = None
                raise
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
            if self.graph.op[node] not in _EXPANDED:
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
        if op == ADD:
            p, q = memo[a], memo[b]
            assert p is not None and q is not None
            height[node] = max(height[a], height[b])
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
        """cos^2 -> 1 - sin^2, until no square of a cosine is left."""
        pending, done = list(p.items()), Packed()
        while pending:
            monomial, c = pending.pop()
            high = monomial + self._shift & self._cosines
            if not high:
                c += done.get(monomial, 0)
                if c:
                    done[monomial] = c
                else:
                    done.pop(monomial, None)
                continue
            cosine = high.bit_length() // 16 - 1
            rest = monomial - (2 << 16 * cosine)
            pending.append((rest, c))
            pending.append((rest + (2 << 16 * self._sine_of(cosine)), -c))
        return done

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
            if not m & 0xFFFF:
                m, k = m >> 16, k + 1
                continue
            e = (m + _TOP & 0xFFFF) - _TOP
            factors.append((self._atoms[k], e))
            m, k = m - e >> 16, k + 1
        return tuple(sorted(factors))


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


def _add(p: Polynomial, q: Polynomial) -> Polynomial:
    result = dict(p)
    for m, c in q.items():
        c += result.get(m, 0)
        if c:
            result[m] = c
        else:
            result.pop(m, None)
    return result


def _merge(m1: Monomial, m2: Monomial) -> Monomial:
    if not m1:
        return m2
    if not m2:
        return m1
    exponents = dict(m1)
    for factor, e in m2:
        e += exponents.get(factor, 0)
        if e:
            exponents[factor] = e
        else:
            exponents.pop(factor, None)
    return tuple(sorted(exponents.items()))


# --- back to the graph, factored --------------------------------------------------------------------------


def to_node(graph: Graph, p: Polynomial) -> Node:
    """A short expression for the polynomial: common factors out first, sums of squares of sin and cos as 1."""
    if not p:
        return graph.zero
    shortest = p
    for _ in range(6):  # sin^2 -> 1 - cos^2 where that leaves fewer terms
        candidate = _swap_sines(graph, shortest)
        if candidate is None:
            break
        shortest = candidate
    return _horner(graph, shortest)


def _swap_sines(graph: Graph, p: Polynomial) -> Polynomial | None:
    """The polynomial with one angle's sin^2 written 1 - cos^2, if that has fewer terms."""
    sines = sorted({f for m in p for f, e in m if e >= 2 and graph.op[f] == "sin"})
    for sine in sines:
        cosine = graph.function("cos", graph.a[sine])
        result: Polynomial = {}
        for monomial, c in p.items():
            exponents = dict(monomial)
            e = exponents.get(sine, 0)
            if e < 2:
                result = _add(result, {monomial: c})
                continue
            exponents[sine] = e - 2
            rest = tuple(sorted((f, k) for f, k in exponents.items() if k))
            result = _add(result, {rest: c})
            result = _add(result, {_merge(rest, ((cosine, 2),)): -c})
        if len(result) < len(p):
            return result
    return None


def _horner(graph: Graph, p: Polynomial) -> Node:
    common = _common(p)
    if common:
        rest = {_divide(m, common): c for m, c in p.items()}
        return graph.mul(_monomial(graph, common, 1), _horner(graph, rest))
    if len(p) == 1:
        ((m, c),) = p.items()
        return _monomial(graph, m, c)
    factor = _most_frequent(p)
    if factor is None:
        return graph.sum([_monomial(graph, m, c) for m, c in sorted(p.items())])
    inside = {m: c for m, c in p.items() if any(f == factor[0] and e * factor[1] > 0 for f, e in m)}
    outside = {m: c for m, c in p.items() if m not in inside}
    return graph.add(_horner(graph, inside), _horner(graph, outside))


def _common(p: Polynomial) -> Monomial:
    """The largest monomial that divides every term."""
    if len(p) < 2:
        return ONE
    first, *others = p
    exponents = dict(first)
    for m in others:
        own = dict(m)
        for f in list(exponents):
            a, b = exponents[f], own.get(f, 0)
            e = min(a, b) if a > 0 and b > 0 else max(a, b) if a < 0 and b < 0 else 0
            if e:
                exponents[f] = e
            else:
                del exponents[f]
    return tuple(sorted(exponents.items()))


def _divide(m: Monomial, by: Monomial) -> Monomial:
    return _merge(m, tuple((f, -e) for f, e in by))


def _most_frequent(p: Polynomial) -> tuple[Node, int] | None:
    seen: dict[tuple[Node, int], int] = {}
    for m in p:
        for f, e in m:
            key = (f, 1 if e > 0 else -1)
            seen[key] = seen.get(key, 0) + 1
    best = max(seen, key=lambda key: (seen[key], -key[0], key[1]), default=None)
    return best if best is not None and seen[best] > 1 else None


def _monomial(graph: Graph, m: Monomial, c: Coefficient) -> Node:
    top = graph.product([graph.power(f, e) for f, e in m if e > 0])
    bottom = graph.product([graph.power(f, -e) for f, e in m if e < 0])
    result = graph.mul(graph.number(-c if c < 0 else c), top)
    if bottom != graph.one:
        result = graph.div(result, bottom)
    return graph.neg(result) if c < 0 else result


def normalise(graph: Graph, node: Node, limit: int = 300) -> Node:
    """The node in canonical short form, or the node itself where that would be longer than ``limit`` terms."""
    return normalise_all(graph, [node], limit)[0]


def normalise_all(graph: Graph, nodes: Iterable[Node], limit: int = 300) -> list[Node]:
    """Each node in canonical short form where that has at most ``limit`` terms; common parts are expanded once."""
    expander, result = Expander(graph, limit, True), []
    for node in nodes:
        try:
            result.append(to_node(graph, expander.expand([node])[0]))
        except TooLarge:
            result.append(node)
    return result


def shortest(graph: Graph, node: Node, cost: Callable[[Node], int], limit: int = 300) -> Node:
    """The cheaper of the node and its canonical form."""
    candidate = normalise(graph, node, limit)
    return candidate if cost(candidate) < cost(node) else node
