"""Evaluation of nodes in floats and, through any object with the same functions, in other arithmetics (mpmath)."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable

CLEAR = 1e-9
"""Of the sizes of two constants: a difference above it is no rounding."""


class Floats:
    """Double precision by the standard library; IEEE results where ``math`` would raise."""

    pi = math.pi
    sin, cos, asin, acos, atan, atan2 = math.sin, math.cos, math.asin, math.acos, math.atan, math.atan2
    sinh, cosh, tanh, exp, log, sqrt = math.sinh, math.cosh, math.tanh, math.exp, math.log, math.sqrt

    @staticmethod
    def number(numerator: int, denominator: int) -> float:
        return numerator / denominator


class Mpmath:
    """mpmath at its current precision (``mpmath.workdps``)."""

    def __init__(self) -> None:
        import mpmath

        self._mp = mpmath.mp

    def __getattr__(self, name: str) -> Any:
        return getattr(self._mp, name)

    def number(self, numerator: int, denominator: int) -> Any:
        return self._mp.mpf(numerator) / denominator

    def atan2(self, y: Any, x: Any) -> Any:
        """The angle of a real pair: what mpmath's roots of negative numbers give has none."""
        if self._mp.im(y) or self._mp.im(x):
            raise ValueError("the angle of numbers that are not real")
        return self._mp.atan2(self._mp.re(y), self._mp.re(x))


def evaluate(
    graph: Graph,
    roots: Sequence[Node],
    values: Mapping[Node, Any],
    arithmetic: Any = Floats,
    order: Sequence[Node] | None = None,
) -> list[Any]:
    """Values of the roots; ``values`` gives each symbol one.  ``order``: the roots' reachable nodes, where they are known.

    Raises:
        KeyError: a symbol without a value.
        ArithmeticError, ValueError: a pole, or a function outside its domain (mpmath's roots are complex there).
    """
    known: dict[Node, Any] = dict(values)
    evaluate_into(known, graph, reachable(graph, roots) if order is None else order, arithmetic)
    return [known[root] for root in roots]


def evaluate_into(known: dict[Node, Any], graph: Graph, order: Sequence[Node], arithmetic: Any = Floats) -> None:
    """Add the values of nodes, operands first, to those that are known."""
    ops, first, second = graph.op, graph.a, graph.b
    for node in order:
        if node in known:
            continue
        op, a, b = ops[node], first[node], second[node]
        if op == ADD:
            known[node] = known[a] + known[b]
        elif op == MUL:
            known[node] = known[a] * known[b]
        elif op == NEG:
            known[node] = -known[a]
        elif op == POW:
            known[node] = known[a] ** b
        elif op == NUM:
            value = graph.value(node)
            assert value is not None
            known[node] = arithmetic.number(value.numerator, value.denominator)
        elif op == PI:
            known[node] = +arithmetic.pi
        elif op == SYM:
            raise KeyError(graph.symbols[a].name)
        else:
            known[node] = apply_function(arithmetic, op, *(known[c] for c in graph.children(node)))


def apply_function(arithmetic: Any, op: str, x: Any, y: Any = None) -> Any:
    """The value of a function of the graph.

    Raises:
        ArithmeticError, ValueError: as in :func:`evaluate`.
    """
    if op == "abs":
        return abs(x)
    if op == "sign":
        return (x > 0) - (x < 0)
    if op == "min":
        return min(x, y)
    if op == "max":
        return max(x, y)
    if op == "powf":
        power = x**y
        if isinstance(power, complex):  # Python's own answer; math.sqrt raises there, too
            raise ValueError("a power of a negative number is not real")
        return power
    if y is not None:
        return getattr(arithmetic, op)(x, y)
    return getattr(arithmetic, op)(x)


def sign_of_constant(graph: Graph, first: Node, second: Node | None) -> int:
    """The sign of a constant, or of the difference of two, as floats tell it; 0 where they do not."""
    try:
        values = [float(value) for value in evaluate(graph, [first] if second is None else [first, second], {})]
    except (ArithmeticError, ValueError, TypeError):
        return 0
    difference, size = values[0] - sum(values[1:]), max(map(abs, values))
    return 0 if abs(difference) <= CLEAR * size else 1 if difference > 0 else -1
