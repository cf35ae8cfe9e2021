"""Nodes as integers: the parallel lists behind the graph, its leaves, and what can be asked of a node."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from nhc.records import record

NUM, SYM, PI, ADD, MUL, NEG, POW = "num", "sym", "pi", "add", "mul", "neg", "pow"
UNARY = frozenset({"sin", "cos", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs", "sign"})
BINARY = frozenset({"atan2", "min", "max", "powf"})

_LEAVES, _DYADIC = frozenset({NUM, SYM, PI}), BINARY | {ADD, MUL}
_MOVING = ("velocity", "quasi", "rate", "acceleration", "multiplier")

Node = int
Rational = int | Fraction
LONGEST_NUMBER = 1 << 15  # bits of a numerator or denominator: far beyond what a double holds


@record
class Symbol:
    """``kind`` is one of time, coordinate, velocity, quasi, parameter, acceleration, multiplier, other."""

    name: str
    kind: str


class NumberTooLong(ArithmeticError):
    """A constant that would take more than LONGEST_NUMBER bits to write exactly."""


def exact_power(value: Fraction, n: int) -> Fraction:
    """value**n, refused before it is computed where it would be too long: ``((9^999)^999)^999`` is a short text."""
    bits = max(value.numerator.bit_length(), value.denominator.bit_length()) - 1
    if bits * abs(n) > LONGEST_NUMBER:
        raise NumberTooLong
    return value**n


class NodeStore:
    """Operations, operands and dependencies of every node; equal nodes are one.

    Node 0 is zero and node 1 is one.  ``coefficient[x]`` and ``core[x]`` are k and y of x = k*y, where y has no rational factor.
    """

    off: frozenset[str] = frozenset()  # rules that are not applied (nhc.algebra.rewriting.rules)

    def __init__(self) -> None:
        self.op: list[str] = []
        self.a: list[int] = []
        self.b: list[int] = []
        self.deps: list[int] = []  # bit k: depends on the symbol number k
        self.kids: list[tuple[int, ...]] = []  # the operands that are nodes
        self.coefficient: list[Rational] = []  # an int wherever it is whole
        self.core: list[Node] = []
        self.symbols: list[Symbol] = []
        self.moving = 0  # the mask of the symbols that are no parameters, coordinates or the time
        self.parameters = 0  # the mask of the parameters
        self.still = 0  # the mask of the parameters and the time
        self.labels: dict[Node, str] = {}  # names that the user gave, printed as such
        self.rate_of: dict[Node, Node] = {}  # what a node is the rate of, where the user differentiated it
        self.memory: dict[str, Any] = {}  # what passes know of these nodes, under the passes' names
        self.reached: dict[tuple[Node, ...], list[Node]] = {}  # the last roots, and what they are made of
        self._symbol_nodes: list[Node] = []
        self._numbers: list[Fraction] = []
        self._number_index: dict[Rational, Node] = {}
        self._symbol_index: dict[tuple[str, str], Node] = {}
        self._adds: dict[tuple[Node, Node], Node] = {}
        self._muls: dict[tuple[Node, Node], Node] = {}
        self._negs: dict[Node, Node] = {}
        self._cache: dict[tuple[str, int, int], Node] = {}
        self.zero = self.number(0)
        self.one = self.number(1)

    def __len__(self) -> int:
        return len(self.op)

    # --- leaves -------------------------------------------------------------------------------------------

    def number(self, value: Rational) -> Node:
        node = self._number_index.get(value)
        if node is None:
            exact = Fraction(value)
            if max(exact.numerator.bit_length(), exact.denominator.bit_length()) > LONGEST_NUMBER:
                raise NumberTooLong
            self._numbers.append(exact)
            node = self._append(NUM, len(self._numbers) - 1, 0, 0, ())
            self.coefficient[node] = exact.numerator if exact.denominator == 1 else exact
            self.core[node] = 1
            self._number_index[value] = node
        return node

    def symbol(self, name: str, kind: str = "other") -> Node:
        node = self._symbol_index.get((name, kind))
        if node is None:
            bit = 1 << len(self.symbols)
            self.symbols.append(Symbol(name, kind))
            if kind in _MOVING:
                self.moving |= bit
            elif kind == "parameter":
                self.parameters |= bit
            if kind in ("parameter", "time"):
                self.still |= bit
            node = self._append(SYM, len(self.symbols) - 1, 0, bit, ())
            self._symbol_nodes.append(node)
            self._symbol_index[name, kind] = node
        return node

    def pi(self) -> Node:
        return self._make(PI, 0, 0, 0)

    def _append(self, op: str, a: int, b: int, deps: int, kids: tuple[Node, ...]) -> Node:
        node = len(self.op)
        self.op.append(op)
        self.a.append(a)
        self.b.append(b)
        self.deps.append(deps)
        self.kids.append(kids)
        self.coefficient.append(1)
        self.core.append(node)
        return node

    def _make(self, op: str, a: int, b: int, deps: int) -> Node:
        """The node of an operation, without any rule (sums, products and signs that the graph builds have tables of their own)."""
        key = (op, a, b)
        node = self._cache.get(key)
        if node is None:
            kids = () if op in _LEAVES else (a, b) if op in _DYADIC else (a,)
            node = self._cache[key] = self._append(op, a, b, deps, kids)
        return node

    def raw(self, op: str, a: int, b: int) -> Node:
        """The node of an operation as it stands: no rule is applied, and nothing is to be calculated with it any more."""
        return self._make(op, a, b, self.deps[a] | (self.deps[b] if op in _DYADIC else 0))

    # --- questions ----------------------------------------------------------------------------------------

    def pass_label(self, node: Node, made: Node) -> None:
        """Give the user's name of a node to what has come in its place, unless that has one."""
        if node in self.labels and made != node:
            self.labels.setdefault(made, self.labels[node])

    def value(self, node: Node) -> Fraction | None:
        """The rational that the node is, or None."""
        return self._numbers[self.a[node]] if self.op[node] == NUM else None

    def symbol_of(self, node: Node) -> Symbol | None:
        return self.symbols[self.a[node]] if self.op[node] == SYM else None

    def known_negative(self, node: Node) -> Node | None:
        """Minus the node, where that is a node, too."""
        if self.op[node] == NEG:
            return self.a[node]
        return self._number_index.get(-self.coefficient[node]) if self.op[node] == NUM else self._negs.get(node)

    def children(self, node: Node) -> tuple[Node, ...]:
        return self.kids[node]

    def depends(self, node: Node, mask: int) -> bool:
        """Whether the node contains one of the symbols of ``mask`` (see :meth:`mask`)."""
        return bool(self.deps[node] & mask)

    def mask(self, symbols: Iterable[Node]) -> int:
        result = 0
        for node in symbols:
            result |= self.deps[node]
        return result

    def symbols_in(self, node: Node) -> tuple[Node, ...]:
        deps, found, index = self.deps[node], [], 0
        while deps:
            if deps & 1:
                found.append(self._symbol_nodes[index])
            deps >>= 1
            index += 1
        return tuple(found)

    def split_coefficient(self, node: Node) -> tuple[Rational, Node]:
        """(k, x) with node = k*x, k rational, x without a rational factor in front."""
        return self.coefficient[node], self.core[node]
