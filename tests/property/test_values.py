"""Nodes of one value become one node: which do, which may not, and that nothing else changes."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.exact.residues import PRIMES, circle_point, circle_points, invert
from nhc.algebra.graph import ADD, POW, Graph, Node
from nhc.algebra.rewriting.factors import find_factors
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.rewriting.values import share_values
from nhc.algebra.walks import count, reachable
from tests.property.expressions import QUIET, Tree, build, rational_trees


def symbols(graph: Graph, names: str) -> list[Node]:
    return [graph.symbol(name, "coordinate") for name in names]


def test_products_and_sums_in_other_orders() -> None:
    g = Graph()
    a, b, c, d = symbols(g, "abcd")
    first, second = g.mul(a, g.mul(b, c)), g.mul(g.mul(a, b), c)
    assert first != second
    assert len(set(share_values(g, [first, second]))) == 1
    longer, other = g.sub(g.sub(a, b), g.mul(c, d)), g.sub(a, g.add(g.mul(d, c), b))
    assert len(set(share_values(g, [longer, other]))) == 1


def test_opposite_values_are_one_with_a_sign() -> None:
    g = Graph()
    a, b, c = symbols(g, "abc")
    left, right = g.mul(a, g.sub(b, c)), g.sub(g.mul(a, c), g.mul(b, a))
    made = share_values(g, [left, right])
    assert made[1] == g.neg(made[0])
    assert count(g, made) == 2


def test_angles_go_by_the_circle() -> None:
    g = Graph()
    x, y = symbols(g, "xy")
    sin, cos = (lambda z: g.function("sin", z)), (lambda z: g.function("cos", z))
    theorem = g.sub(g.mul(cos(x), cos(y)), g.mul(sin(x), sin(y)))
    made = share_values(g, [cos(g.add(x, y)), theorem])
    assert made[0] == made[1]


def test_what_vanishes_is_zero_and_what_is_a_symbol_is_this_symbol() -> None:
    g = Graph()
    a, b = symbols(g, "ab")
    zero = g.sub(g.mul(g.add(a, b), g.sub(a, b)), g.sub(g.power(a, 2), g.power(b, 2)))
    alone = g.div(g.sub(g.power(g.add(a, b), 2), g.add(g.power(a, 2), g.power(b, 2))), g.mul(g.number(2), a))
    assert zero != g.zero
    assert share_values(g, [zero, g.power(alone, 2)]) == [g.zero, g.power(b, 2)]


def test_a_product_stands_for_a_sum_in_which_digits_cancel() -> None:
    """1 - s*s is 0 in doubles where c*c is 1e-18."""
    g = Graph()
    x, k = symbols(g, "xk")
    sine, cosine = g.function("sin", x), g.function("cos", x)
    total, square = g.sub(g.one, g.power(sine, 2)), g.power(cosine, 2)
    assert g.op[total] == ADD and total < square
    made = share_values(g, [g.mul(k, total), square])
    assert made == [g.mul(k, square), square]


def test_nothing_gets_a_pole_that_it_did_not_have() -> None:
    g = Graph()
    x, y = symbols(g, "xy")
    quotient = g.div(g.sub(g.power(x, 3), g.power(y, 3)), g.sub(x, y))  # 0/0 at x = y
    polynomial = g.add(g.add(g.power(x, 2), g.mul(x, y)), g.power(y, 2))
    assert quotient < polynomial
    assert share_values(g, [quotient, polynomial])[1] == polynomial
    turned = Graph()
    x, y = symbols(turned, "xy")
    polynomial = turned.add(turned.add(turned.power(x, 2), turned.mul(x, y)), turned.power(y, 2))
    quotient = turned.div(turned.sub(turned.power(x, 3), turned.power(y, 3)), turned.sub(x, y))
    assert share_values(turned, [polynomial, quotient]) == [polynomial, polynomial]


def test_branches_of_roots_and_signs_are_not_taken_for_granted() -> None:
    g = Graph()
    x, y = symbols(g, "xy")
    for made in (g.function("abs", x), g.function("sqrt", g.add(g.power(x, 2), g.zero))):
        kept = share_values(g, [g.mul(made, y), g.mul(x, y)])
        assert len(set(kept)) == 2
    root = g.function("sqrt", g.add(x, y))
    square = g.mul(g.mul(root, y), root)
    assert share_values(g, [square, g.mul(y, g.add(x, y))])[1] == g.mul(y, g.add(x, y))
    same = [g.function("min", x, g.mul(x, g.mul(y, y))), g.function("min", x, g.mul(g.mul(x, y), y))]
    assert len(set(share_values(g, same))) == 1


@pytest.mark.parametrize("before", range(12))
def test_even_roots_by_broken_exponents_have_two_branches(before: int) -> None:
    """(x^6)^(1/6) is |x|; it was taken for x wherever the field's root happened to be x at both points."""
    g = Graph()
    others = [g.symbol(f"d{k}", "coordinate") for k in range(before)]
    x, y = (g.symbol(name, "coordinate") for name in "xy")
    for base, plain, n in ((g.power(x, 6), x, 6), (g.power(g.sub(x, y), 6), g.sub(x, y), 6), (g.power(x, 4), x, 4)):
        root = g.function("powf", base, g.number(Fraction(1, n)))
        roots = [g.function("cos", other) for other in others]
        roots += [g.mul(root, g.function("cos", y)), g.mul(plain, g.function("sin", y))]
        at = {x: -0.7, y: 0.4, **dict.fromkeys(others, 0.1)}
        assert evaluate(g, share_values(g, roots), at) == pytest.approx(evaluate(g, roots, at), rel=1e-14)


def test_names_stay_with_their_values() -> None:
    g = Graph()
    a, b, c = symbols(g, "abc")
    first, second = g.mul(a, g.mul(b, c)), g.mul(g.mul(a, b), c)
    g.labels[second] = "volume"
    made = share_values(g, [first, second])
    assert g.labels[made[0]] == "volume"


def test_without_the_rule_nothing_changes() -> None:
    g = WithoutRules(["equal values"])
    a, b, c = symbols(g, "abc")
    roots = [g.mul(a, g.mul(b, c)), g.mul(g.mul(a, b), c)]
    assert share_values(g, roots) == roots


@QUIET
@given(rational_trees, rational_trees)
def test_the_roots_keep_their_values_and_cost_no_more(first: Tree, second: Tree) -> None:
    g = Graph()
    try:
        roots = [build(g, first), build(g, second), g.mul(build(g, second), build(g, first))]
    except ZeroDivisionError:
        return
    made = share_values(g, roots)
    assert are_equal(g, made, roots)
    assert count(g, made) <= count(g, roots)
    poles = {g.a[n] for n in reachable(g, made) if g.op[n] == POW and g.b[n] < 0}
    before = {g.a[n] for n in reachable(g, roots) if g.op[n] == POW and g.b[n] < 0}
    assert len(poles) <= len(before)


def test_squares_of_sums_at_hand() -> None:
    g = Graph()
    a, b, k = symbols(g, "abk")
    total = g.add(a, b)
    long = g.add(g.power(a, 2), g.mul(b, g.add(b, g.mul(g.number(2), a))))
    assert find_factors(g, [g.mul(k, total), long]) == [g.mul(k, total), g.power(total, 2)]
    assert find_factors(g, [long]) == [long]


def test_multiples_of_what_is_at_hand() -> None:
    g = Graph()
    x, y, z, angle = symbols(g, "xyza")
    cosine, total = g.function("cos", angle), g.add(g.mul(x, y), z)
    long = g.sub(g.neg(g.mul(g.mul(cosine, x), y)), g.mul(cosine, z))
    roots = [total, cosine, long]
    made = find_factors(g, roots)
    assert made == [total, cosine, g.neg(g.mul(cosine, total))]
    assert count(g, made) < count(g, roots)


def test_factors_bring_no_poles_and_no_branches() -> None:
    g = Graph()
    x, y, z = symbols(g, "xyz")
    quotient = g.div(g.add(g.mul(x, y), z), x)
    sum_of_both = g.add(g.add(g.mul(x, y), z), g.zero)
    inverse = g.inverse(x)
    roots = [quotient, inverse, g.add(g.mul(g.mul(x, y), y), g.mul(z, y)), sum_of_both]
    assert are_equal(g, find_factors(g, roots), roots)
    root = g.function("sqrt", g.power(x, 2))
    long = g.add(g.mul(x, y), g.mul(x, g.mul(z, z)))
    assert find_factors(g, [root, g.add(y, g.mul(z, z)), long])[2] != g.mul(root, g.add(y, g.mul(z, z)))


@QUIET
@given(rational_trees, rational_trees)
def test_with_factors_the_roots_keep_their_values_and_cost_no_more(first: Tree, second: Tree) -> None:
    g = Graph()
    try:
        one, other = build(g, first), build(g, second)
        roots = [one, other, build(g, ("*", ("+", first, second), ("sym", 0))), g.add(one, other)]
    except ZeroDivisionError:
        return
    made = find_factors(g, share_values(g, roots))
    assert are_equal(g, made, roots)
    assert count(g, made) <= count(g, roots)


def test_inverses_with_one_inversion() -> None:
    p = PRIMES[1]
    assert [x * y % p for x, y in zip([2, 7, p - 1], invert([2, 7, p - 1], p), strict=True)] == [1, 1, 1]
    assert invert([], p) == []


def test_points_of_the_circle_with_one_inversion() -> None:
    p = PRIMES[0]
    us = [2, 3, p - 2, 123456789, (p + 1) // 2]
    assert circle_points(us, p) == [circle_point(u, p) for u in us]
    assert all((c * c + s * s) % p == 1 for c, s in circle_points(us, p))
