"""Expressions in messages: spelled as in a spec, and equal to what they stand for."""

from __future__ import annotations

import random
from collections.abc import Mapping
from fractions import Fraction

import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.show import to_text
from tests.readers import TextReader

NAMES = ("a", "b", "x")


def grow(g: Graph, symbols: Mapping[str, Node], rng: random.Random, depth: int) -> Node:
    """A random expression of sums, products, quotients, powers, signs and functions."""
    if depth == 0:
        return rng.choice([*symbols.values(), g.number(Fraction(rng.randint(1, 9), rng.randint(1, 6)))])
    left, right = (grow(g, symbols, rng, depth - rng.randint(1, depth)) for _ in range(2))
    makers = (g.add, g.sub, g.mul, lambda p, q: g.mul(p, g.power(g.add(g.power(q, 2), g.one), -rng.randint(1, 2))))
    made = rng.choice(makers)(left, right)
    ends = (made, g.neg(made), g.function("sin", made), g.power(made, 2), g.mul(g.number(Fraction(2, 3)), made))
    return rng.choice(ends)


@pytest.mark.parametrize("seed", range(60))
def test_messages_say_what_the_node_is(seed: int) -> None:
    g, rng = Graph(), random.Random(seed)
    symbols = {name: g.symbol(name) for name in NAMES}
    node = grow(g, symbols, rng, 4)
    values = {name: rng.uniform(0.3, 0.8) for name in NAMES}
    (wanted,) = evaluate(g, [node], {symbols[name]: number for name, number in values.items()})
    text = to_text(g, node, 5000)
    assert TextReader(text, values).value() == pytest.approx(float(wanted), rel=1e-9, abs=1e-12), text


def test_one_fraction_line() -> None:
    g = Graph()
    a, b, x = (g.symbol(name) for name in NAMES)
    half = g.number(Fraction(1, 2))
    assert to_text(g, g.mul(half, g.mul(a, g.add(x, b)))) == "a*(b + x)/2"
    assert to_text(g, g.mul(half, g.pi())) == "pi/2"
    quotient = g.mul(g.mul(g.number(-4), a), g.mul(g.inverse(g.add(x, b)), x))
    assert to_text(g, quotient) == "-4*a*x/(b + x)"
    assert to_text(g, g.mul(a, g.mul(g.inverse(b), g.power(x, -2)))) == "a/(b*x^2)"
    assert to_text(g, g.function("powf", x, g.number(Fraction(7, 3)))) == "x^(7/3)"
