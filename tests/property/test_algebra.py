"""What the graph does to an expression keeps its value; derivatives, substitution, canonical forms and linear solves are right."""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from math import comb

import mpmath
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from nhc.algebra.calculus import derivative, gradient, tangent
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import Floats, Mpmath, evaluate
from nhc.algebra.exact.modular import FieldPoint, Unlucky, are_zero, is_zero
from nhc.algebra.expand import Expander, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise, polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.blocks import block_order
from nhc.algebra.solving.linear import NotLinear, linear_form, solve
from tests.property.expressions import (
    NAMES,
    QUIET,
    Tree,
    build,
    build_raw,
    rational_trees,
    smooth_trees,
    symbols,
    to_mpf,
    value,
)

points = st.tuples(*[st.builds(Fraction, st.integers(1, 30), st.integers(7, 19))] * 3)
X, Y, Z = (("sym", k) for k in range(3))


def num(top: int, bottom: int = 1) -> Tree:
    return ("num", Fraction(top, bottom))


@QUIET
@given(st.lists(smooth_trees, min_size=1, max_size=5))
@example([("-", ("*", num(4), X), ("*", num(4), ("+", X, Y)))])  # 4 (x - (x + y))
def test_numbers_stand_in_front(trees: list[Tree]) -> None:
    """What is left of a node without its number has none."""
    g = Graph()
    for tree in trees:
        build(g, tree)
    assert all(g.core[core] == core and g.coefficient[core] == 1 for core in g.core if core != g.zero)


def values_at(g: Graph, point: Sequence[object]) -> dict[Node, object]:
    return {g.symbol(name): x for name, x in zip(NAMES, point, strict=True)}


class Fractions:
    @staticmethod
    def number(top: int, bottom: int) -> Fraction:
        return Fraction(top, bottom)


RULES: dict[str, Tree] = {
    "zero is neutral": ("+", num(0), X),
    "k P + l P": ("+", ("*", num(2), X), ("*", num(-1, 3), X)),
    "x - x": ("-", ("*", X, Y), ("*", X, Y)),
    "the sign of a sum": ("+", ("neg", X), ("neg", Y)),
    "a circle": ("+", ("*", num(3), ("pow", ("sin", X), 2)), ("*", num(3), ("pow", ("cos", X), 2))),
    "a common factor": ("+", ("*", X, Y), ("neg", ("*", Z, Y))),
    "numbers to the front": ("*", ("*", num(2), X), ("*", num(3, 4), Y)),
    "powers of one base": ("*", ("pow", X, 3), ("pow", X, -1)),
    "a factor cancels": ("*", ("*", X, ("pow", Y, 2)), ("pow", Y, -1)),
    "twice a sum of halves": ("*", num(2), ("+", ("*", num(1, 2), X), ("*", num(-1, 2), Y))),
    "equal rational factors": ("+", ("*", num(2, 3), X), ("*", num(-2, 3), Y)),
    "signs of a product": ("*", ("neg", X), ("neg", Y)),
    "a power of a power": ("pow", ("pow", X, 2), -3),
    "an even power of -x": ("pow", ("neg", X), 2),
    "an odd power of -x": ("pow", ("neg", X), 3),
    "a power of k x": ("pow", ("*", num(2, 3), X), -2),
    "an even power of a root": ("pow", ("sqrt", X), -4),
    "a power of exp": ("pow", ("exp", X), -3),
    "sin is odd": ("sin", ("neg", X)),
    "cos is even": ("cos", ("neg", X)),
    "tanh of a negative number": ("tanh", num(-1, 3)),
    "sin of quarter turns": ("sin", ("*", num(7, 2), ("pi",))),
    "cos of quarter turns": ("cos", ("*", num(-5), ("pi",))),
    "abs of a root": ("abs", ("sqrt", X)),
    "abs of a number": ("abs", num(-7, 3)),
    "sign of a number": ("sign", num(-7, 3)),
    "exp of log": ("exp", ("log", X)),
    "log of exp": ("log", ("exp", X)),
    "log of one": ("log", num(1)),
    "a root of a square": ("sqrt", num(9, 16)),
    "a whole exponent": ("powf", X, num(3)),
    "half an exponent": ("powf", X, num(-3, 2)),
    "min of one thing": ("min", X, X),
    "max of numbers": ("max", num(1, 2), num(1, 3)),
    "a double sign": ("neg", ("neg", X)),
}


@pytest.mark.parametrize("rule", RULES)
def test_rule_fires_and_keeps_the_value(rule: str) -> None:
    g, tree = Graph(), RULES[rule]
    assert build(g, tree) != build_raw(g, tree)
    with mpmath.workdps(40):
        point = [to_mpf(Fraction(7, 5)), to_mpf(Fraction(3, 7)), to_mpf(Fraction(11, 4))]
        found = evaluate(g, [build(g, tree)], values_at(g, point), Mpmath())[0]
        assert abs(found - value(tree, tuple(point), to_mpf)) < mpmath.mpf(10) ** -36


@QUIET
@given(rational_trees, points)
def test_rational_expressions_keep_their_value(tree: Tree, point: tuple[Fraction, ...]) -> None:
    g = Graph()
    try:
        expected = value(tree, point)
        node = build(g, tree)
    except ZeroDivisionError:
        assume(False)
        return
    assert evaluate(g, [node], values_at(g, point), Fractions)[0] == expected


@QUIET
@given(smooth_trees, points)
def test_functions_keep_their_value(tree: Tree, point: tuple[Fraction, ...]) -> None:
    with mpmath.workdps(60):
        g, at = Graph(), tuple(to_mpf(x) for x in point)
        expected = value(tree, at, to_mpf)
        assume(abs(expected) < 1e12)
        found = evaluate(g, [build(g, tree)], values_at(g, at), Mpmath())[0]
        assert abs(found - expected) <= mpmath.mpf(10) ** -30 * (1 + abs(expected))


FUNCTIONS = ("sin", "cos", "tanh", "atan", "exp", "sqrt")


def is_flat(tree: Tree, inside: bool = False) -> bool:
    """No root, and only polynomials as arguments: what stands inside a function is known to the field by its value only, so that
    an unsimplified argument (never built by the graph) may count as a different one."""
    kind = tree[0]
    if kind == "sqrt" or (inside and (kind in FUNCTIONS or (kind == "pow" and tree[2] < 0))):
        return False
    deeper = inside or kind in FUNCTIONS
    return all(is_flat(part, deeper) for part in tree[1:] if isinstance(part, tuple))


@QUIET
@given(smooth_trees.filter(is_flat), st.integers(0, 10**6))
def test_rules_hold_modulo_a_prime(tree: Tree, seed: int) -> None:
    g = Graph()
    nodes = [build_raw(g, tree), build(g, tree)]
    for attempt in range(40):
        try:
            left, right = FieldPoint(g, seed + attempt).evaluate(nodes)
        except Unlucky:
            continue
        assert left == right
        return
    pytest.fail("no point of the field was found")


@QUIET
@given(smooth_trees, symbols, points)
def test_forward_and_reverse_derivatives_agree(tree: Tree, symbol: Tree, point: tuple[Fraction, ...]) -> None:
    """Forward and reverse mode agree exactly, and with a central difference in 80 digits."""
    g = Graph()
    node, wrt = build(g, tree), build(g, symbol)
    forward = derivative(g, node, wrt)
    assert is_zero(g, g.sub(forward, gradient(g, node, [g.symbol(n) for n in NAMES])[symbol[1]]))
    with mpmath.workdps(80):
        at = [to_mpf(x) for x in point]
        h = mpmath.mpf(10) ** -25
        ends = []
        for step in (h, -h):
            moved = list(at)
            moved[symbol[1]] += step
            ends.append(value(tree, tuple(moved), to_mpf))
        slope = (ends[0] - ends[1]) / (2 * h)
        assume(abs(slope) < 1e8 and abs(ends[0]) < 1e8)
        found = evaluate(g, [forward], values_at(g, at), Mpmath())[0]
        assert abs(found - slope) < mpmath.mpf(10) ** -15 * (1 + abs(slope))


@QUIET
@given(smooth_trees, smooth_trees, points)
def test_substitution(tree: Tree, inner: Tree, point: tuple[Fraction, ...]) -> None:
    g = Graph()
    node, put = build(g, tree), build(g, inner)
    replaced = substitute(g, [node], {g.symbol("x"): put})[0]
    with mpmath.workdps(60):
        at = tuple(to_mpf(x) for x in point)
        expected = value(tree, (value(inner, at, to_mpf), *at[1:]), to_mpf)
        assume(abs(expected) < 1e10)
        found = evaluate(g, [replaced], values_at(g, at), Mpmath())[0]
        assert abs(found - expected) <= mpmath.mpf(10) ** -25 * (1 + abs(expected))


@pytest.mark.parametrize("circle", [True, False])
def test_what_is_zero_by_a_cosine_below_is_zero(circle: bool) -> None:
    """k (1 - sin^2)/cos - k cos has three terms in the canonical form, and none with sin^2 written by cos^2."""
    g = Graph()
    k, x = g.symbol("k"), g.symbol("x")
    s, c = g.function("sin", x), g.function("cos", x)
    node = g.sub(g.div(g.sub(k, g.mul(k, g.power(s, 2))), c), g.mul(k, c))
    terms = polynomial(g, node, circle=circle)
    assert len(terms) == 3
    assert to_node(g, terms) == g.zero


@QUIET
@given(smooth_trees)
def test_canonical_form_is_equal(tree: Tree) -> None:
    g = Graph()
    node = build(g, tree)
    assert is_zero(g, g.sub(node, normalise(g, node)))


def test_high_powers_of_cosines_are_short() -> None:
    """cos^(2n) has n + 1 terms in sin^2, and 2^n on the way if equal ones do not meet; products of many have as many to the end."""
    g = Graph()
    x = [g.function("cos", g.symbol(f"x{k}")) for k in range(60)]
    short = Expander(g, 300, circle=True).expand([g.power(x[0], 80)])[0]
    sine = g.function("sin", g.symbol("x0"))
    assert short == {((sine, 2 * k),) if k else (): (-1) ** k * comb(40, k) for k in range(41)}
    with pytest.raises(TooLarge):
        Expander(g, 300, circle=True).expand([g.product([g.power(c, 2) for c in x])])


def test_a_length_that_is_a_difference_of_parameters_cancels_as_one_letter_would() -> None:
    """(b - a)^2 s c/((b - a) s) is (b - a) c; multiplied out, the fraction would stay."""
    g = Graph()
    a, b = (g.symbol(name, "parameter") for name in "ab")
    q = g.symbol("q", "coordinate")
    s, c, length = g.function("sin", q), g.function("cos", q), g.sub(b, a)
    area = g.sum([g.power(a, 2), g.power(b, 2), g.mul_number(-2, g.mul(a, b))])
    top = g.add(g.mul(g.power(length, 2), g.mul(s, c)), g.mul(g.mul(length, s), g.mul(length, c)))
    assert normalise(g, g.div(top, g.mul(length, s))) == g.mul_number(2, g.mul(length, c))
    squares = g.sub(g.power(g.add(a, b), 2), g.power(length, 2))
    assert normalise(g, g.mul(squares, c)) == normalise(g, g.mul_number(4, g.mul(g.mul(a, b), c)))
    assert is_zero(g, g.sub(normalise(g, g.sub(area, g.power(length, 2))), g.zero))


@QUIET
@given(rational_trees, rational_trees, rational_trees)
def test_linear_forms_are_read_off(a: Tree, b: Tree, c: Tree) -> None:
    g = Graph()
    u, v = g.symbol("u"), g.symbol("v")
    try:
        nodes = [build(g, tree) for tree in (a, b, c)]
    except ZeroDivisionError:
        assume(False)
        return
    form = g.add(g.mul(g.sub(nodes[0], nodes[1]), u), g.add(g.mul(nodes[1], g.add(u, v)), nodes[2]))
    try:
        (cu, cv), constant = linear_form(g, form, (u, v))
        assert all(are_zero(g, [g.sub(cu, nodes[0]), g.sub(cv, nodes[1]), g.sub(constant, nodes[2])]))
    except Unlucky:  # a reciprocal of what vanishes identically
        assume(False)
    with pytest.raises(NotLinear):
        linear_form(g, g.add(form, g.mul(u, v)), (u, v))


@QUIET
@given(st.integers(1, 5), st.integers(0, 10**6))
def test_solve_solves(size: int, seed: int) -> None:
    g, rng = Graph(), random.Random(seed)
    entries = [g.zero, g.zero, g.one, *(build(g, tree) for tree in (X, Y, ("sin", X), ("+", num(2), Z), ("*", X, Y)))]
    matrix = [[rng.choice(entries) for _ in range(size)] for _ in range(size)]
    column = [rng.choice(entries) for _ in range(size)]
    try:
        result = solve(g, matrix, [column])
    except Singular:
        from nhc.algebra.exact.modular import rank

        assert rank(g, matrix) < size
        return
    for row, right in zip(matrix, column, strict=True):
        left = g.sum([g.mul(a, x) for a, x in zip(row, result.unknowns[0], strict=True)])
        assert is_zero(g, g.sub(left, right))
    assert not any(are_zero(g, [guard for guard, _ in result.guards]))


@QUIET
@given(st.integers(1, 7), st.integers(0, 10**6))
def test_blocks_come_after_what_they_need(size: int, seed: int) -> None:
    rng = random.Random(seed)
    shift = rng.sample(range(size), size)
    pattern = [[shift[i] == j or rng.random() < 0.2 for j in range(size)] for i in range(size)]
    blocks = block_order(size, lambda i, j: pattern[i][j])
    assert sorted(i for rows, _ in blocks for i in rows) == list(range(size))
    known: set[int] = set()
    for rows, columns in blocks:
        assert len(rows) == len(columns)
        known |= set(columns)
        assert all(j in known for i in rows for j in range(size) if pattern[i][j])
    assert known == set(range(size))


def test_a_pattern_without_matching_is_singular() -> None:
    with pytest.raises(Singular):
        block_order(2, lambda i, j: j == 0)


def test_tangent_is_linear_in_its_seeds() -> None:
    g = Graph()
    x, y, u, v = (g.symbol(name) for name in "xyuv")
    node = g.function("sin", g.mul(x, g.power(y, 2)))
    whole = tangent(g, [node], {x: u, y: v})[0]
    parts = g.add(g.mul(u, derivative(g, node, x)), g.mul(v, derivative(g, node, y)))
    assert is_zero(g, g.sub(whole, parts))
    assert evaluate(g, [whole], {x: 0.3, y: 0.4, u: 0.0, v: 0.0}, Floats)[0] == 0.0


def test_the_slope_of_a_logarithm_is_a_reciprocal() -> None:
    """sign(y)/|y|, as log|y| and powers of |y| have it, is 0/0 at no other place than 1/y, and that is shorter."""
    g = Graph()
    y, z = g.symbol("y"), g.symbol("z")
    sign, size = g.function("sign", y), g.function("abs", y)
    assert derivative(g, g.function("log", size), y) == g.inverse(y)
    assert g.mul(g.inverse(size), g.mul(z, sign)) == g.div(z, y)
    assert g.mul(sign, g.power(size, -3)) == g.power(y, -3)
    for kept in (g.mul(sign, g.power(size, -2)), g.mul(g.power(sign, 2), g.inverse(size)), g.div(size, sign)):
        assert {g.op[node] for node in g.kids[kept]} & {"sign", "abs", "pow"}
    assert is_zero(g, g.sub(g.mul(sign, g.power(size, -3)), g.mul(g.power(sign, 5), g.power(size, -3))))
