"""Polynomials divided by the sums below their fraction lines: the value stays, and what cancels is gone."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from nhc.algebra.divided import divide_sums
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.algebra.polynomial import normalise, polynomial
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.show import to_text
from nhc.algebra.walks import count
from tests.property.expressions import QUIET, Tree, build, rational_trees
from tests.property.test_algebra import Fractions, X, Y, Z, num, points, values_at

SPHERE = ("-", ("-", ("pow", Z, 2), ("pow", X, 2)), ("pow", Y, 2))
INVERSE = ("pow", SPHERE, -1)
ROOT = ("sqrt", SPHERE)
DIVISORS: list[Tree] = [SPHERE, ("+", X, Y), ("+", ("pow", X, 2), X), ("-", ("*", X, Y), ("+", Z, num(2)))]


@pytest.mark.parametrize(
    ("tree", "short"),
    [
        (("+", ("*", ("+", ("pow", X, 2), ("pow", Y, 2)), INVERSE), num(1)), "-z^2/(x^2 + y^2 - z^2)"),
        (("+", num(1), ("*", ("pow", X, 2), ("pow", ("-", ("pow", Y, 2), ("pow", X, 2)), -1))), "-y^2/(x^2 - y^2)"),
        (("*", ("+", ("+", ("*", X, Z), ("*", Y, Z)), num(1)), ("pow", ("+", X, Y), -1)), "1/(x + y) + z"),
        (
            ("*", ROOT, ("+", ("*", ("pow", X, 2), INVERSE), ("+", num(1), ("*", ("pow", Y, 2), INVERSE)))),
            "z^2/sqrt(z^2 - x^2 - y^2)",
        ),
        (("-", ("*", num(3), X), ("*", ("pow", ("+", X, Y), -1), ("*", ("*", num(3), X), Y))), "3*x^2/(x + y)"),
    ],
)
def test_what_the_divisor_divides_is_gone(tree: Tree, short: str) -> None:
    g, plain = Graph(), WithoutRules(["divided sums"])
    node, other = build(g, tree), build(plain, tree)
    (made,) = shorten(g, [node])
    assert to_text(g, made) == short
    assert are_equal(g, [made], [node])
    assert count(g, [made]) < count(plain, shorten(plain, [other]))


@QUIET
@given(st.lists(rational_trees, min_size=3, max_size=3), st.sampled_from(DIVISORS), points)
@example([("*", X, X), ("*", Y, Y), num(1)], SPHERE, (Fraction(3, 7), Fraction(2, 7), Fraction(5, 7)))
def test_powers_of_a_divisor_keep_the_value(parts: list[Tree], divisor: Tree, point: tuple[Fraction, ...]) -> None:
    """n_0 + n_1/D + n_2/D^2, exactly, over the rationals."""
    g = Graph()
    below = build(g, divisor)
    try:
        node = g.sum([g.div(build(g, part), g.power(below, k)) for k, part in enumerate(parts)])
        before = evaluate(g, [node], values_at(g, point), Fractions)[0]
    except ZeroDivisionError:
        assume(False)
    made = normalise(g, node)
    try:
        after = evaluate(g, [made], values_at(g, point), Fractions)[0]
    except ZeroDivisionError:
        assume(False)
    assert after == before


@QUIET
@given(st.lists(rational_trees, min_size=3, max_size=3), st.sampled_from(DIVISORS))
@example([("*", X, X), ("*", Y, Y), num(1)], SPHERE)
def test_roots_of_a_divisor_keep_the_value(parts: list[Tree], divisor: Tree) -> None:
    """n_0 sqrt(D) + n_1/sqrt(D) + n_2/sqrt(D)^3, modulo primes."""
    g = Graph()
    try:
        root = g.function("sqrt", build(g, divisor))
        node = g.sum([g.mul(build(g, part), g.power(root, 1 - 2 * k)) for k, part in enumerate(parts)])
        made = normalise(g, node)
    except ZeroDivisionError:
        assume(False)
    assert are_equal(g, [made], [node])


def test_what_vanishes_by_one_divisor_is_not_divided_by_the_next() -> None:
    """(x/(x + y) + y/(x + y) - 1)/(x + z), which the graph does not see to be zero when it is multiplied out."""
    g = Graph()
    x, y, z = (g.symbol(name) for name in "xyz")
    first, second = g.inverse(g.add(x, y)), g.inverse(g.add(x, z))
    p = {((x, 1), (first, 1), (second, 1)): 1, ((y, 1), (first, 1), (second, 1)): 1, ((second, 1),): -1}
    tidy = {tuple(sorted(m)): c for m, c in p.items()}
    assert divide_sums(g, tidy, lambda node: polynomial(g, node)) == {}


def test_division_ends() -> None:
    """x of x^2 + x divides the other term: dividing by it would make powers of x without end."""
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    below = g.add(g.power(x, 2), x)
    node = g.div(g.sum([g.power(x, 9), g.mul(y, x), g.one]), below)
    assert are_equal(g, [normalise(g, node)], [node])
