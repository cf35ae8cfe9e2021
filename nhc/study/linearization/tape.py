"""Nodes evaluated again and again at other points: the order of operations is found once."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable

_ADD, _MUL, _NEG, _POW, _SIN, _COS, _SQRT, _OTHER = range(8)
_CODES = {ADD: _ADD, MUL: _MUL, NEG: _NEG, POW: _POW, "sin": _SIN, "cos": _COS, "sqrt": _SQRT}
_RECENT = 24
"""Results that a tape remembers: a search asks for the same places again, to judge what it has found there."""


class Tape:
    """Values of ``roots`` from values of their symbols."""

    def __init__(self, graph: Graph, roots: Sequence[Node]) -> None:
        self._constants: list[tuple[int, float]] = []
        self._inputs: list[tuple[int, Node]] = []
        self._steps: list[tuple[int, int, int, int]] = []
        self._others: list[Callable[[list[float]], float]] = []
        self._recent: dict[bytes, NDArray[np.float64]] = {}
        order = reachable(graph, roots)
        place = {node: k for k, node in enumerate(order)}
        self._size = len(order)
        self._roots = [place[root] for root in roots]
        for k, node in enumerate(order):
            op = graph.op[node]
            children = [place[c] for c in graph.children(node)]
            if op == SYM:
                self._inputs.append((k, node))
            elif op == NUM or not children:
                self._constants.append((k, float(evaluate(graph, [node], {})[0])))
            elif op in _CODES:
                second = children[1] if len(children) > 1 else graph.b[node]
                self._steps.append((_CODES[op], children[0], second, k))
            else:
                self._steps.append((_OTHER, len(self._others), 0, k))
                self._others.append(_other(graph, node, children))

    def __call__(self, values: Mapping[Node, float]) -> NDArray[np.float64]:
        """The roots' values, shape (len(roots),).

        Raises:
            ArithmeticError: a pole, or a function outside its domain.
        """
        given = tuple(values[node] for _, node in self._inputs)
        place = array("d", given).tobytes()  # zeros of either sign are two
        if place in self._recent:
            return self._recent[place].copy()
        known = [0.0] * self._size
        for k, number in self._constants:
            known[k] = number
        for (k, _), number in zip(self._inputs, given, strict=True):
            known[k] = number
        try:
            self._run(known)
            found = np.array([known[k] for k in self._roots], dtype=float)
        except (ValueError, TypeError) as error:  # TypeError: a complex power
            raise ArithmeticError(str(error)) from None
        if not np.all(np.isfinite(found)):
            raise ArithmeticError("a value is not finite")
        if len(self._recent) >= _RECENT:
            del self._recent[next(iter(self._recent))]
        self._recent[place] = found.copy()
        return found

    def _run(self, known: list[float]) -> None:
        sin, cos, sqrt = math.sin, math.cos, math.sqrt
        for code, a, b, k in self._steps:
            if code == _ADD:
                known[k] = known[a] + known[b]
            elif code == _MUL:
                known[k] = known[a] * known[b]
            elif code == _NEG:
                known[k] = -known[a]
            elif code == _POW:
                known[k] = known[a] ** b
            elif code == _SIN:
                known[k] = sin(known[a])
            elif code == _COS:
                known[k] = cos(known[a])
            elif code == _SQRT:
                known[k] = sqrt(known[a])
            else:
                known[k] = self._others[a](known)


def _other(graph: Graph, node: Node, children: Sequence[int]) -> Callable[[list[float]], float]:
    """The rare functions, through the one evaluator on a graph that holds nothing else."""
    small = Graph()
    operands = [small.symbol(f"x{k}") for k in range(len(children))]
    root = small.function(graph.op[node], *operands)

    def value(known: list[float]) -> float:
        at = {symbol: known[k] for symbol, k in zip(operands, children, strict=True)}
        return float(evaluate(small, [root], at)[0])

    return value


class Tapes:
    """The tapes and gradients of one model, each made when it is first used."""

    def __init__(self, graph: Graph, symbols: Sequence[Node]) -> None:
        self._graph, self._symbols = graph, tuple(symbols)
        self._tapes: dict[tuple[Node, ...], Tape] = {}
        self._gradients: dict[Node, tuple[Node, ...]] = {}

    def numbers(self, nodes: Sequence[Node], values: Mapping[Node, float]) -> NDArray[np.float64]:
        """Values of nodes; see :class:`Tape`."""
        key = tuple(nodes)
        if key not in self._tapes:
            self._tapes[key] = Tape(self._graph, key)
        return self._tapes[key](values)

    def slopes(self, node: Node, values: Mapping[Node, float]) -> NDArray[np.float64]:
        """The gradient of a node over the symbols."""
        if node not in self._gradients:
            self._gradients[node] = tuple(gradient(self._graph, node, self._symbols))
        return self.numbers(self._gradients[node], values)
