"""Nodes as integers: the parallel lists behind the graph, its leaves, and what can be asked of a node."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

NUM, SYM, PI, ADD, MUL, NEG, POW = "num", "sym", "pi", "add", "mul", "neg", "pow"
UNARY = frozenset({"sin", "cos", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs", "sign"})
BINARY = frozenset({"atan2", "min", "max", "powf"})

_LEAVES, _DYADIC = frozenset({NUM, SYM, PI}), BINARY | {ADD, MUL}

Node = int
LONGEST_NUMBER = 1 << 15  # bits of a numerator or denominator: far beyond what a double holds
ONE, MINUS_ONE = Fraction(1), Fraction(-1)


@dataclass(frozen=True, slots=True)
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
    """Operations, operands and dependencies of every node; equal nodes are one."""

    def __init__(self) -> None:
        self.op: list[str] = []
        self.a: list[int] = []
        self.b: list[int] = []
        self.deps: list[int] = []  # bit k: depends on the symbol number k
        self.kids: list[tuple[int, ...]] = []  # the operands that are nodes
        self.symbols: list[Symbol] = []
        self.labels: dict[Node, str] = {}  # names that the user gave, printed as such
        self._symbol_nodes: list[Node] = []
        self._numbers: list[Fraction] = []
        self._number_index: dict[Fraction, Node] = {}
        self._symbol_index: dict[Symbol, Node] = {}
        self._cache: dict[tuple[str, int, int], Node] = {}
        self.zero = self.number(0)
        self.one = self.number(1)

    def __len__(self) -> int:
        return len(self.op)

    # --- leaves -------------------------------------------------------------------------------------------

    def number(self, value: int | Fraction) -> Node:
        value = Fraction(value)
        if max(value.numerator.bit_length(), value.denominator.bit_length()) > LONGEST_NUMBER:
            raise NumberTooLong
        node = self._number_index.get(value)
        if node is None:
            self._numbers.append(value)
            node = self._append(NUM, len(self._numbers) - 1, 0, 0)
            self._number_index[value] = node
        return node

    def symbol(self, name: str, kind: str = "other") -> Node:
        key = Symbol(name, kind)
        node = self._symbol_index.get(key)
        if node is None:
            self.symbols.append(key)
            bit = 1 << (len(self.symbols) - 1)
            node = self._append(SYM, len(self.symbols) - 1, 0, bit)
            self._symbol_nodes.append(node)
            self._symbol_index[key] = node
        return node

    def pi(self) -> Node:
        return self._make(PI, 0, 0, 0)

    def _append(self, op: str, a: int, b: int, deps: int) -> Node:
        self.op.append(op)
        self.a.append(a)
        self.b.append(b)
        self.deps.append(deps)
        self.kids.append(() if op in _LEAVES else (a, b) if op in _DYADIC else (a,))
        return len(self.op) - 1

    def _make(self, op: str, a: int, b: int, deps: int) -> Node:
        key = (op, a, b)
        node = self._cache.get(key)
        if node is None:
            node = self._cache[key] = self._append(op, a, b, deps)
        return node

    # --- questions ----------------------------------------------------------------------------------------

    def value(self, node: Node) -> Fraction | None:
        """The rational that the node is, or None."""
        return self._numbers[self.a[node]] if self.op[node] == NUM else None

    def symbol_of(self, node: Node) -> Symbol | None:
        return self.symbols[self.a[node]] if self.op[node] == SYM else None

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

    def split_coefficient(self, node: Node) -> tuple[Fraction, Node]:
        """(k, x) with node = k*x, k rational, x without a rational factor in front."""
        op, a = self.op, self.a
        negative = op[node] == NEG
        if negative:
            node = a[node]
        kind = op[node]
        if kind == NUM:
            value, node = self._numbers[a[node]], self.one
        elif kind == MUL and op[a[node]] == NUM:
            value, node = self._numbers[a[a[node]]], self.b[node]
        else:
            return (MINUS_ONE if negative else ONE), node
        return (-value if negative else value), node
