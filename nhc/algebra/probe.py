"""Floats with error bounds at one fixed point: what is clearly not zero needs no exact test.

A running error analysis (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. (2002), sec. 3.3) goes with every
value; a node whose value is ten thousand times its bound is not the zero function.  The other way round nothing is concluded: what
looks like zero here is left to :mod:`nhc.algebra.exact.modular`.

Each node of a graph is evaluated once, in the order of the numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from hashlib import blake2b
from zlib import crc32

from nhc.algebra.graph import ADD, BINARY, MUL, NEG, NUM, PI, POW, SYM, Graph, Node, Symbol
from nhc.algebra.minors import find_lone_entries

_Bounded = tuple[list[float], list[float]]  # values and their bounds
UNIT = 2.0**-52
_CLEAR = 1e4
_CLEAR_PIVOT = 100.0  # times its bound
_SIGNED_PROBES = 8
_MANY = 8  # rows beyond which entries are looked for that are alone in their row or column


class Probe:
    """Values and error bounds of a graph's nodes; nan where there is no value."""

    def __init__(self, graph: Graph, number: int = 0) -> None:
        self._number = number
        self.values: list[float] = []
        self.errors: list[float] = []
        self._graph_lists = (graph.op, graph.a, graph.b)
        self._symbols = graph.symbols
        self._coefficients = graph.coefficient

    def is_clear(self, node: Node) -> bool:
        """Whether the node is certainly not zero (False: not known)."""
        if node >= len(self.values):
            self._extend()
        return abs(self.values[node]) > _CLEAR * self.errors[node]

    def value(self, node: Node) -> float:
        """The node's value here."""
        if node >= len(self.values):
            self._extend()
        return self.values[node]

    def has_full_rank(self, rows: Sequence[Sequence[Node]]) -> bool:
        """Whether elimination with full pivoting finds clear pivots in all rows, or in all columns (False: not known).

        The bounds go along: entries that are as good as a pivot may rest on nothing but the errors of others.
        """
        if _MANY < len(rows) <= len(rows[0]):
            rows = self._without_lone_entries(rows)
        work: list[_Bounded] = []
        for row in rows:
            values = [self.value(x) if x else 0.0 for x in row]
            errors = [self.errors[x] if x else 0.0 for x in row]
            scale = max(map(abs, values))
            if not (0.0 < scale < math.inf and sum(errors) < math.inf):
                return False
            work.append(([x / scale for x in values], [x / scale for x in errors]))
        sizes = [1.0] * len(work)
        return all(_take_pivot(work, sizes, step) for step in range(min(len(work), len(work[0][0])) if work else 0))

    def _without_lone_entries(self, rows: Sequence[Sequence[Node]]) -> list[Sequence[Node]]:
        """What is left beside clear entries that are alone in their row or column: those rows are independent, whatever is left."""
        held = [[j for j, x in enumerate(row) if x] for row in rows]
        taken = dict(find_lone_entries(held, len(rows[0]), lambda i, j: self.is_clear(rows[i][j])))
        gone = {*taken.values()}
        columns = [j for j in range(len(rows[0])) if j not in gone]
        return [[row[j] for j in columns] for i, row in enumerate(rows) if i not in taken]

    def _extend(self) -> None:
        self._fill(range(len(self.values), len(self._graph_lists[0])))

    def _fill(self, nodes: Iterable[Node]) -> None:
        """Values and bounds of these nodes, operands first."""
        op, first, second = self._graph_lists
        v, e = self.values, self.errors
        more = [math.nan] * (len(op) - len(v))
        v += more
        e += more
        for node in nodes:
            kind, a = op[node], first[node]
            if kind == ADD:
                b = second[node]
                x = v[a] + v[b]
                bound = e[a] + e[b]
            elif kind == MUL:
                b = second[node]
                p, q = v[a], v[b]
                x = p * q
                bound = (abs(p) + e[a]) * e[b] + abs(q) * e[a]
            elif kind == NEG:
                v[node] = -v[a]
                e[node] = e[a]
                continue
            else:
                try:
                    x, bound = self._other(kind, node, a, second[node])
                except (ArithmeticError, ValueError):
                    x, bound = math.nan, math.nan
            v[node] = x
            e[node] = bound + abs(x) * UNIT

    def _other(self, kind: str, node: Node, a: int, b: int) -> tuple[float, float]:
        if kind == NUM:
            return float(self._coefficients[node]), 0.0
        if kind == SYM:
            return self._place(self._symbols[a]), 0.0
        if kind == PI:
            return math.pi, 0.0
        y, other = (self.values[b], self.errors[b]) if kind in BINARY else (math.nan, math.nan)
        return bounded(kind, b, self.values[a], self.errors[a], y, other)

    def _place(self, symbol: Symbol) -> float:
        """Where a symbol is: in (0.4, 1.6), but for the first point also in (-1.6, -0.4)."""
        if not self._number:
            return 0.4 + 1.2 * crc32(f"{symbol.kind} {symbol.name}".encode()) / 2**32
        # no checksum: those are linear, and names of one length would all change their signs together
        text = f"{self._number} {symbol.kind} {symbol.name}".encode()
        drawn = int.from_bytes(blake2b(text, digest_size=4).digest(), "big")
        size = 0.4 + 1.2 * (drawn >> 1) / 2**31
        return -size if drawn & 1 else size


def bounded(kind: str, n: int, x: float, bound: float, y: float, other: float) -> tuple[float, float]:
    """Value and bound of a power, x^n, or a function of x, or of x and y, whose bounds are given.

    Raises:
        ArithmeticError, ValueError: it has none.
    """
    if kind == POW:
        if abs(x) <= _CLEAR * bound:
            return (0.0, math.inf) if n > 0 else (math.nan, math.nan)
        power = x**n
        return power, abs(n * power / x) * bound + abs(power) * UNIT
    if kind in ("sin", "cos"):
        return (math.sin(x) if kind == "sin" else math.cos(x)), bound + UNIT
    if kind in BINARY:
        return _binary(kind, x, bound, y, other)
    return _unary(kind, x, bound)


def _take_pivot(work: list[_Bounded], sizes: list[float], step: int) -> bool:
    """Eliminate below the largest entry from row ``step`` on, whose column becomes zero; False where it is not clear.

    ``sizes`` are the rows' largest entries.
    """
    best = max(sizes[step:])
    i = sizes.index(best, step)
    j = next((j for j, x in enumerate(work[i][0]) if abs(x) == best), 0)
    pivot, bounds = work[i]
    if not best > _CLEAR_PIVOT * bounds[j]:
        return False
    work[step], work[i] = work[i], work[step]
    sizes[step], sizes[i] = sizes[i], sizes[step]
    entries = [(c, y, bounds[c]) for c, y in enumerate(pivot) if y or bounds[c]]
    for k in range(step + 1, len(work)):
        values, errors = work[k]
        if not values[j] and not errors[j]:
            continue
        factor = values[j] / pivot[j]
        doubt = (errors[j] + abs(factor) * bounds[j]) / (best - bounds[j]) + abs(factor) * UNIT
        size = abs(factor)
        for c, y, bound in entries:
            x = values[c]
            errors[c] += size * bound + doubt * (abs(y) + bound) + (abs(x) + size * abs(y)) * UNIT
            values[c] = x - factor * y
        values[j] = errors[j] = 0.0
        sizes[k] = max(map(abs, values))
    return True


def _unary(kind: str, x: float, bound: float) -> tuple[float, float]:
    if kind == "abs":
        return abs(x), bound
    if kind == "sign":
        return (math.copysign(1.0, x), 0.0) if abs(x) > _CLEAR * bound else (math.nan, math.nan)
    value = float(getattr(math, kind)(x))
    if kind in ("sqrt", "log"):
        return value, bound / (2 * value if kind == "sqrt" else x)
    if kind in ("asin", "acos"):
        return value, bound / math.sqrt(1 - x * x)
    steepest = math.cosh(x) if kind in ("sinh", "cosh") else value if kind == "exp" else 1.0
    return value, bound * steepest + abs(value) * UNIT


def _binary(kind: str, x: float, bound: float, y: float, other: float) -> tuple[float, float]:
    if kind == "atan2":
        if y < 0 and abs(x) <= _CLEAR * bound:
            raise ArithmeticError  # on which side of the cut is not known
        return math.atan2(x, y), (bound + other) / math.hypot(x, y)
    if kind == "powf":
        value = math.pow(x, y)
        return value, abs(value) * (abs(y / x) * bound + abs(math.log(x)) * other + 4 * UNIT)
    return (min(x, y) if kind == "min" else max(x, y)), bound + other


def probe_of(graph: Graph) -> Probe:
    """The probe of a graph, which knows what was evaluated before."""
    known = graph.memory.get("probe")
    if not isinstance(known, Probe):
        known = graph.memory["probe"] = Probe(graph)
    return known


def signed_probes(graph: Graph) -> list[Probe]:
    """Probes at points of both signs, for expressions that hold signs."""
    known: list[Probe] = graph.memory.setdefault("signed probes", [])
    if not known:
        known += [Probe(graph, number) for number in range(1, _SIGNED_PROBES + 1)]
    return known
