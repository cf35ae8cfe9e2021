"""Degrees of nodes as rational functions of the generators of a field point: what the Schwartz-Zippel bound needs.

A node's value is N / prod b^e over a common set of denominators b (reciprocals taken in the graph, circles of the angles, powers of
exponentials), so that sums take the least common multiple and not the product.  Square roots and signs are algebraic over the
generators: each one that occurs doubles the degree twice, once for the norm and once for the points where the root exists.
Every number here is an upper bound, a generous one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

from nhc.algebra.arguments import argument_terms
from nhc.algebra.exact.draw import stepwise_degree
from nhc.algebra.exact.field import INVERSE
from nhc.algebra.expand import Monomial, Polynomial
from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable

_WAVES = ("sin", "cos")
_EXPONENTIALS = ("exp", "sinh", "cosh", "tanh")

Key = tuple[object, ...]


@dataclass(frozen=True)
class Degree:
    """``top``: degree of the numerator; ``bottom``: exponents of the denominators."""

    top: int = 0
    bottom: Mapping[Key, int] = field(default_factory=dict)


Solved = tuple[Sequence[Node], Sequence[Sequence[Node]]]
"""Symbols, and the rows (coefficients and constant) of the linear equations that give them their values."""


class Degrees:
    """Degrees of everything under some roots; a symbol that stands for a node (``standing``) has that node's.

    Symbols that are ``solved`` for have those of Cramer's rule; what the equations leave open is random.  Later equations may
    hold the symbols of earlier ones.
    """

    def __init__(
        self,
        graph: Graph,
        roots: Sequence[Node],
        standing: Mapping[Node, Node] | None = None,
        solved: Sequence[Solved] = (),
    ) -> None:
        self.graph = graph
        self.known: dict[Node, Degree] = {}
        self._size: dict[Key, int] = {}
        self._arguments: dict[Node, Polynomial] = {}
        self.roots = 0  # square roots and signs
        self.opaque = 0  # what the arguments of other functions add
        meant = dict(standing or {})
        held = [[x for row in rows for x in row] for _, rows in solved]
        everything = [*roots, *meant.values(), *(x for flat in held for x in flat)]
        self._denominators = self._least_denominators(reachable(graph, everything))
        self._visit(reachable(graph, list(meant.values())))
        self.known.update({symbol: self.known[node] for symbol, node in meant.items()})
        for (symbols, rows), flat in zip(solved, held, strict=True):
            self._visit(reachable(graph, flat))
            self._solve(symbols, rows)
        self._visit(reachable(graph, roots))

    def _visit(self, nodes: Sequence[Node]) -> None:
        for node in nodes:
            if node not in self.known:
                self.known[node] = self._degree(node)

    def _solve(self, symbols: Sequence[Node], rows: Sequence[Sequence[Node]]) -> None:
        if not rows:
            return
        key: Key = ("solution", *symbols)
        self._size[key] = size = sum(self.over_common(row) + 1 for row in rows)
        self.known.update(dict.fromkeys(symbols, Degree(size + 1, {key: 1})))

    def of(self, node: Node) -> Degree:
        return self.known[node]

    def weight(self, bottom: Mapping[Key, int]) -> int:
        """Degree of a denominator."""
        return sum(self._size[key] * e for key, e in bottom.items())

    def over_common(self, nodes: Sequence[Node]) -> int:
        """Degree of the nodes' numerators over one common denominator, and of that: the larger."""
        common: dict[Key, int] = {}
        for node in nodes:
            for key, e in self.known[node].bottom.items():
                common[key] = max(common.get(key, 0), e)
        whole = self.weight(common)
        tops = [self.known[node].top + whole - self.weight(self.known[node].bottom) for node in nodes]
        return max([whole, *tops])

    # --- one node -----------------------------------------------------------------------------------------

    def _degree(self, node: Node) -> Degree:
        g, op = self.graph, self.graph.op[node]
        if op == NUM:
            return Degree()
        if op == SYM or not g.children(node):
            return Degree(1)
        x = self.known[g.a[node]]
        if op == NEG:
            return x
        if op == ADD or op in ("min", "max"):
            self.roots += op != ADD
            return self._sum(x, self.known[g.b[node]])
        if op == MUL:
            y = self.known[g.b[node]]
            return Degree(x.top + y.top, _add(x.bottom, y.bottom))
        if op == POW:
            return self._power(g.a[node], x, g.b[node])
        if op in _WAVES:
            return self._wave(g.a[node])
        if op in _EXPONENTIALS:
            return self._exponential(op, node)
        return self._algebraic(op, x, [self.known[c] for c in g.children(node)])

    def _sum(self, x: Degree, y: Degree) -> Degree:
        common = dict(x.bottom)
        for key, e in y.bottom.items():
            common[key] = max(common.get(key, 0), e)
        whole = self.weight(common)
        return Degree(max(x.top - self.weight(x.bottom), y.top - self.weight(y.bottom)) + whole, common)

    def _power(self, base: Node, x: Degree, n: int) -> Degree:
        if n > 0:
            return Degree(x.top * n, {key: e * n for key, e in x.bottom.items()})
        key: Key = ("reciprocal", base)
        self._size[key] = x.top
        return Degree(self.weight(x.bottom) * -n, {key: -n})

    def _wave(self, argument: Node) -> Degree:
        top, bottom = 0, dict[Key, int]()
        self._meet(argument)
        for monomial, k in self._arguments[argument].items():
            key: Key = ("circle", monomial)
            self._size[key] = size = 2 * self._inverse(monomial)
            turns = int(abs(Fraction(k)) * self._denominators[("angle", monomial)])
            top += size * turns
            bottom[key] = bottom.get(key, 0) + turns
        return Degree(top, bottom)

    def _meet(self, argument: Node) -> None:
        """An argument that holds velocities has a generator by its value; two different ones may meet at a point."""
        if self.graph.deps[argument] & self.graph.moving:
            d = self.known[argument]
            self.opaque += 2 * (d.top + self.weight(d.bottom))

    def _inverse(self, monomial: Monomial) -> int:
        """Degree of the point of the circle that a monomial owns; that of an inverse function holds a square root."""
        g, (atom, _) = self.graph, monomial[0] if monomial else (0, 0)
        if len(monomial) != 1 or g.op[atom] not in INVERSE:
            return 1
        self.roots += 1
        return 1 + sum(self.known[c].top + self.weight(self.known[c].bottom) for c in g.children(atom))

    def _exponential(self, op: str, node: Node) -> Degree:
        turns, bottom = 0, dict[Key, int]()
        self._meet(self.graph.a[node])
        for monomial, k in self._arguments[self.graph.a[node]].items():
            key: Key = ("exponential", monomial)
            self._size[key] = 1
            count = int(abs(Fraction(k)) * self._denominators[("exponent", monomial)])
            turns += count
            if k < 0 or op != "exp":
                bottom[key] = bottom.get(key, 0) + count
        if op != "tanh":
            return Degree(turns if op == "exp" else 2 * turns, bottom)
        own: Key = ("tanh", node)
        self._size[own] = 2 * turns
        return Degree(2 * turns, {own: 1})

    def _algebraic(self, op: str, x: Degree, operands: Sequence[Degree]) -> Degree:
        if op == "sqrt":
            self.roots += 1
            return Degree((x.top + self.weight(x.bottom) + 1) // 2, x.bottom)
        if op == "abs" or op == "sign":
            self.roots += 1
            return x if op == "abs" else Degree()
        # an independent generator; two different arguments may meet at a point
        self.opaque += sum(2 * (d.top + self.weight(d.bottom)) for d in operands)
        if op == "powf":
            self.roots += 4
            return Degree(x.top + self.weight(x.bottom) + 5040, x.bottom)
        return Degree(1)

    def _least_denominators(self, nodes: Sequence[Node]) -> dict[Key, int]:
        found: dict[Key, int] = {}
        for node in nodes:
            op = self.graph.op[node]
            family = "angle" if op in _WAVES else "exponent" if op in _EXPONENTIALS else ""
            if not family:
                continue
            argument = self.graph.a[node]
            terms = self._arguments[argument] = argument_terms(self.graph, argument)
            for monomial, c in terms.items():
                found[(family, monomial)] = lcm(found.get((family, monomial), 1), c.denominator)
        return found

    def inflate(self, degree: int) -> int:
        """The degree that counts in the bound: twice for the poles, four times for each square root, and the opaque arguments."""
        apart, count = stepwise_degree(self.graph, [node for node in self.known if self.graph.op[node] == "sqrt"])
        return 2 * (degree * apart * (1 << 2 * (self.roots - count)) + self.opaque)


def _add(x: Mapping[Key, int], y: Mapping[Key, int]) -> dict[Key, int]:
    result = dict(x)
    for key, e in y.items():
        result[key] = result.get(key, 0) + e
    return result
