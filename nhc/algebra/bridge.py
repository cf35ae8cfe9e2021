"""The bridge to SymPy: printing's last resort, on request and under a time limit, and factors of polynomials.  Nothing else in nhc
imports SymPy.

What comes back of a simplification is believed only after the exact identity test, and kept only if it is shorter.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import FrameType
from typing import TYPE_CHECKING, Any

from nhc.algebra.exact.modular import Unlucky, is_zero
from nhc.algebra.graph import ADD, BINARY, MUL, NEG, NUM, PI, POW, SYM, UNARY, Graph, Node
from nhc.algebra.walks import reachable

if TYPE_CHECKING:
    import sympy

Powers = Mapping[tuple[int, ...], Fraction]
"""A polynomial: the powers of its unknowns, and what stands before them."""
_MOST_FACTORED = 60  # terms beyond which a polynomial is not taken apart but for its powers
_TO = {"abs": "Abs", "min": "Min", "max": "Max", "powf": "Pow"}
_FROM = {name: key for key, name in _TO.items() if key != "powf"}


class TimeIsUp(Exception):
    """The time limit has passed."""


def to_sympy(graph: Graph, node: Node) -> sympy.Expr:
    """The node as a SymPy expression over real symbols ``s0, s1, ...`` (one for each symbol of the graph, by number)."""
    import sympy

    made: dict[Node, Any] = {}
    for n in reachable(graph, [node]):
        op, a, b = graph.op[n], graph.a[n], graph.b[n]
        if op == NUM:
            value = graph.value(n)
            assert value is not None
            made[n] = sympy.Rational(value.numerator, value.denominator)
        elif op == SYM:
            made[n] = sympy.Symbol(f"s{a}", real=True)
        elif op == PI:
            made[n] = sympy.pi
        elif op == ADD:
            made[n] = made[a] + made[b]
        elif op == MUL:
            made[n] = made[a] * made[b]
        elif op == NEG:
            made[n] = -made[a]
        elif op == POW:
            made[n] = made[a] ** b
        else:
            function = getattr(sympy, _TO.get(op, op))
            made[n] = function(*(made[c] for c in graph.children(n)))
    return made[node]


def from_sympy(graph: Graph, expression: sympy.Expr) -> Node:
    """The node of an expression over the symbols that :func:`to_sympy` makes.

    Raises:
        ValueError: a function or a number that the graph does not know.
    """
    import sympy

    if isinstance(expression, sympy.Rational):
        return graph.number(Fraction(int(expression.p), int(expression.q)))
    if expression == sympy.pi:
        return graph.pi()
    if isinstance(expression, sympy.Symbol):
        symbol = graph.symbols[int(expression.name[1:])]
        return graph.symbol(symbol.name, symbol.kind)
    operands = [from_sympy(graph, argument) for argument in expression.args]
    if expression.is_Add:
        return graph.sum(operands)
    if expression.is_Mul:
        return graph.product(operands)
    if expression.is_Pow:
        return graph.function("powf", *operands)
    name = type(expression).__name__
    name = _FROM.get(name, name)
    if name not in UNARY | BINARY | {"tan"}:
        raise ValueError(f"no operation of the graph for `{name}`")
    return graph.function(name, *operands)


def shared_factors(polynomials: Sequence[Powers]) -> list[Powers]:
    """The factors of the polynomials' greatest common divisor, each once; numbers are left out."""
    import sympy

    count = len(next(iter(polynomials[0])))
    unknowns = sympy.symbols(f"s:{count}")
    terms = ({powers: sympy.Rational(k.numerator, k.denominator) for powers, k in p.items()} for p in polynomials)
    shared, *others = (sympy.Poly(own, *unknowns, domain="QQ") for own in terms)
    for other in others:
        if shared.is_ground:
            return []
        shared = sympy.gcd(shared, other)
    few = len(shared.terms()) <= _MOST_FACTORED
    _, factors = shared.factor_list() if few else shared.sqf_list()
    return [
        {powers: Fraction(int(k.p), int(k.q)) for powers, k in factor.terms()}
        for factor, _ in factors
        if not factor.is_ground
    ]


class Simplifier:
    """``simplify`` on nodes, all calls together within ``seconds``; a node that takes too long stays as it is.

    The limit needs the main thread of a POSIX system (``setitimer``); elsewhere nothing is simplified, which is correct too.
    """

    def __init__(self, graph: Graph, seconds: float, cost: Callable[[Node], int]) -> None:
        self.graph, self.cost = graph, cost
        self._end = time.monotonic() + seconds
        self._usable = hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()

    def __call__(self, node: Node) -> Node:
        left = self._end - time.monotonic()
        if left <= 0 or not self._usable or not self.graph.children(node):
            return node
        try:
            candidate = _within(left, lambda: self._simplified(node))
        except (TimeIsUp, ValueError, Unlucky, RecursionError, ZeroDivisionError):
            return node
        return candidate

    def _simplified(self, node: Node) -> Node:
        import sympy

        candidate = from_sympy(self.graph, sympy.simplify(to_sympy(self.graph, node)))
        shorter = self.cost(candidate) < self.cost(node)
        return candidate if shorter and is_zero(self.graph, self.graph.sub(candidate, node)) else node


def _within(seconds: float, work: Callable[[], Node]) -> Node:
    """The result of the work, or TimeIsUp."""

    def ring(_: int, __: FrameType | None) -> None:
        raise TimeIsUp

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, max(seconds, 1e-3))
    try:
        return work()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
