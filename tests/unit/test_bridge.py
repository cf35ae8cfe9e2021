"""The bridge to SymPy: there and back, simplification that is checked, and the time limit."""

from __future__ import annotations

import time

import pytest

from nhc.algebra.bridge import Simplifier, from_sympy, to_sympy
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import count


def samples(g: Graph) -> list[Node]:
    x, y = g.symbol("x"), g.symbol("lambda")
    s, c = g.function("sin", x), g.function("cos", x)
    return [
        g.add(g.mul(s, y), g.power(c, 3)),
        g.div(g.function("sqrt", g.add(g.one, g.power(x, 2))), g.function("exp", y)),
        g.function("atan2", x, g.add(y, g.pi())),
        g.function("powf", g.function("abs", x), y),
        g.function("max", x, g.function("tanh", y)),
        g.function("asin", g.div(x, g.number(7))),
    ]


def test_there_and_back() -> None:
    g = Graph()
    for node in samples(g):
        assert is_zero(g, g.sub(from_sympy(g, to_sympy(g, node)), node))


def test_an_unknown_function_is_refused() -> None:
    import sympy

    with pytest.raises(ValueError, match="gamma"):
        from_sympy(Graph(), sympy.gamma(sympy.Rational(1, 3)))


def test_simplification_shortens_and_keeps_the_value() -> None:
    g = Graph()
    x = g.symbol("x")
    s, c = g.function("sin", x), g.function("cos", x)
    long = g.sub(g.power(c, 4), g.power(s, 4))  # cos 2x
    short = Simplifier(g, 30.0, lambda node: count(g, [node]))(long)
    assert count(g, [short]) < count(g, [long])
    assert is_zero(g, g.sub(short, long))


def test_the_time_limit_holds() -> None:
    g = Graph()
    node = g.symbol("x0")
    for k in range(1, 40):
        node = g.function("sin", g.add(g.power(node, 2), g.function("cos", g.mul(node, g.symbol(f"x{k}")))))
    start = time.monotonic()
    assert Simplifier(g, 0.2, lambda n: count(g, [n]))(node) == node
    assert time.monotonic() - start < 60  # a hang detector; the limit itself is 0.2 s
