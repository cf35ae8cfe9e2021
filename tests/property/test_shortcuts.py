"""Shortcuts of the derivation against the long way: floats that clear, orders without coefficients, passes that remember."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import combinations

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from nhc.algebra.calculus import Derivation, tangent
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.exact.modular import are_zero, is_zero, rank
from nhc.algebra.expand import Expander, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.minors import float_determinant, relative_minors
from nhc.algebra.polynomial import normalise
from nhc.algebra.probe import probe_of
from nhc.algebra.rebuilding import Replacement, substitute
from nhc.algebra.solving.linear import degrees, is_clearly_linear, is_clearly_regular, linear_form, solve_rows
from nhc.algebra.solving.sizes import form_size
from tests.property.expressions import NAMES, QUIET, Tree, build, build_raw, smooth_trees

X, Y, Z = (("sym", k) for k in range(3))


@QUIET
@given(smooth_trees)
def test_what_vanishes_is_never_cleared(tree: Tree) -> None:
    """The same expression with the graph's rules and without them: their difference is zero, and looks like rounding."""
    g = Graph()
    difference = g._make("add", build(g, tree), g._make("neg", build_raw(g, tree), 0, 0), 0)
    assert not probe_of(g).is_clear(difference)


@QUIET
@given(smooth_trees, smooth_trees)
def test_what_is_cleared_is_not_zero(left: Tree, right: Tree) -> None:
    g = Graph()
    node = g.sub(build(g, left), build(g, right))
    if probe_of(g).is_clear(node):
        place = {s: probe_of(g).value(s) for s in g.symbols_in(node)}
        assert evaluate(g, [node], place)[0] != 0.0


def test_a_probe_clears_ordinary_expressions() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    sine, cosine = g.function("sin", x), g.function("cos", x)
    circle = g.add(g.power(sine, 2), g.power(g.function("cos", g.add(x, g.zero)), 2))
    assert all(map(probe_of(g).is_clear, (x, g.sub(x, y), g.mul(sine, cosine), circle, g.inverse(g.sub(x, y)))))
    assert not probe_of(g).is_clear(g.zero)
    assert not probe_of(g).is_clear(g.function("log", g.neg(g.power(x, 2))))  # no value: nothing is known


def _rows(rng: random.Random, g: Graph, size: int, *, chain: bool) -> tuple[list[Node], list[Node], list[list[Node]]]:
    """Rows that are linear in the unknowns, as nodes that share parts, with their coefficients."""
    unknowns = [g.symbol(f"u{k}", "unknown") for k in range(size)]
    pool = [g.one, *(build(g, tree) for tree in (X, Y, ("sin", X), ("cos", Y), ("+", ("num", 2), Z), ("*", X, Y)))]
    matrix, rows, before = [], [], [g.zero] * size
    for i in range(size):
        own = list(before) if chain else [g.zero] * size
        for j in range(i + 1 if chain else size):
            if rng.random() < 0.5:
                own[j] = g.add(own[j], rng.choice(pool))
        matrix.append(own)
        rows.append(g.sub(g.sum([g.mul(a, u) for a, u in zip(own, unknowns, strict=True)]), rng.choice(pool)))
        before = own
    order = rng.sample(range(size), size)
    return [rows[i] for i in order], unknowns, [matrix[i] for i in order]


@QUIET
@given(st.integers(1, 6), st.integers(0, 10**6), st.booleans())
def test_rows_are_solved(size: int, seed: int, chain: bool) -> None:
    g, rng = Graph(), random.Random(seed)
    rows, unknowns, matrix = _rows(rng, g, size, chain=chain)
    try:
        found, guards = solve_rows(g, rows, unknowns)
    except Singular:
        assert rank(g, matrix) < size
        assert not is_clearly_regular(g, rows, unknowns)
        return
    assert all(are_zero(g, substitute(g, rows, dict(zip(unknowns, found, strict=True)))))
    assert not any(are_zero(g, [guard for guard, _ in guards]))
    assert rank(g, matrix) == size


@QUIET
@given(st.integers(1, 5), st.integers(0, 10**6), st.booleans())
def test_the_size_of_a_row_bounds_its_coefficients(size: int, seed: int, chain: bool) -> None:
    g, rng = Graph(), random.Random(seed)
    rows, unknowns, _ = _rows(rng, g, size, chain=chain)
    place = {g.symbol(name): rng.uniform(-2, 2) for name in NAMES}
    for row in rows:
        assert is_clearly_linear(g, row, unknowns)
        coefficients, _ = linear_form(g, row, unknowns)
        bound = form_size(g, row, g.mask(unknowns))
        assert bound is not None
        at, *values = evaluate(g, [bound, *coefficients], place)
        assert sum(map(abs, values)) <= at * (1 + 1e-12)
    u = unknowns[0]
    assert form_size(g, g.mul(u, g.add(u, g.one)), g.mask(unknowns)) is None
    cubic = g.mul(g.add(u, g.one), g.power(u, 2))
    assert degrees(g, unknowns)[cubic] == 3
    assert not is_clearly_linear(g, g.function("sin", u), unknowns)


@QUIET
@given(smooth_trees, smooth_trees, smooth_trees)
def test_passes_that_remember_give_the_same_nodes(first: Tree, second: Tree, put: Tree) -> None:
    g = Graph()
    nodes = [build(g, first), build(g, second), build(g, ("*", first, second))]
    x, y = g.symbol("x"), g.symbol("y")
    seeds, mapping = {x: g.one, y: g.symbol("y'")}, {x: build(g, put)}
    derivation, replacement = Derivation(g, seeds), Replacement(g, mapping)
    try:
        assert all(
            are_zero(g, [g.sub(derivation.of(n), d) for n, d in zip(nodes, tangent(g, nodes, seeds), strict=True)])
        )
    except Unlucky:
        assume(False)
    assert replacement.of(nodes) == substitute(g, nodes, mapping)
    assert derivation.of(nodes[2]) == Derivation(g, seeds).of(nodes[2])  # what it remembers changes nothing


def test_exponents_beyond_their_field_are_refused() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    high = g.mul(g.power(x, 200), y)
    node = high
    for _ in range(8):
        node = g._make("mul", node, node, g.deps[node])  # x^(200 * 256): its field would overflow
    with pytest.raises(TooLarge):
        Expander(g, 300, True).expand([node])
    assert normalise(g, node) == node
    (found,) = Expander(g, 300, True).expand([g.div(high, g.power(y, 3))])
    assert found == {((x, 200), (y, -2)): 1}


@QUIET
@given(st.integers(1, 4), st.integers(0, 3), st.integers(0, 10**6))
def test_minors_are_determinants(rows: int, more: int, seed: int) -> None:
    rng = random.Random(seed)
    matrix = [[float(rng.randrange(-3, 4)) for _ in range(rows + more)] for _ in range(rows)]
    subsets = list(combinations(range(rows + more), rows))
    scale = math.prod(math.sqrt(sum(x * x for x in row)) for row in matrix)
    for subset, found in zip(subsets, relative_minors(matrix, subsets), strict=True):
        expected = abs(float_determinant([[row[j] for j in subset] for row in matrix]))
        assert found**rows * scale == pytest.approx(expected, abs=1e-9 * (1 + scale))


@pytest.mark.parametrize("seed", range(40))
def test_sparse_determinants_and_ranks_are_those_of_all_entries(seed: int) -> None:
    """With entries that are alone in their row or column, and with rows that depend on others; sign included."""
    rng = random.Random(seed)
    size, density = rng.randint(9, 14), rng.choice([0.05, 0.1, 0.15, 0.4])
    places = rng.sample(range(size), size)
    numbers = [[rng.choice([-3, -2, 1, 2]) if rng.random() < density else 0 for _ in range(size)] for _ in range(size)]
    for i, j in enumerate(places):
        numbers[i][j] = rng.choice([-2, 1, 3])
    if seed % 4 == 0:
        numbers[places[0]] = [a - 2 * b for a, b in zip(numbers[places[1]], numbers[places[2]], strict=True)]
    exact = _determinant(numbers)
    assert float_determinant(numbers) == pytest.approx(float(exact), rel=1e-12, abs=1e-9)
    g = Graph()
    flat = [[g.number(x) for x in row] for row in numbers]
    wide = [[*row, g.symbol(f"x{i % 3}")] for i, row in enumerate(flat)]
    assert probe_of(g).has_full_rank(flat) == (exact != 0) == (rank(g, flat) == size)
    assert not probe_of(g).has_full_rank(wide) or rank(g, wide) == size


def _determinant(numbers: list[list[int]]) -> Fraction:
    """By elimination in fractions."""
    rows, found = [[Fraction(x) for x in row] for row in numbers], Fraction(1)
    while rows:
        k = next((k for k, row in enumerate(rows) if row[0]), None)
        if k is None:
            return Fraction(0)
        own = rows.pop(k)
        found *= -own[0] if k % 2 else own[0]
        rows = [[x - row[0] / own[0] * y for x, y in zip(row[1:], own[1:], strict=True)] for row in rows]
    return found


def test_tests_of_zero_remember_and_stay_right() -> None:
    g = Graph()
    x = g.symbol("x")
    sine, cosine = g.function("sin", x), g.function("cos", x)
    double = g.function("sin", g.mul(g.number(2), x))
    assert is_zero(g, g.sub(double, g.mul(g.number(2), g.mul(sine, cosine))))
    half = g.function("cos", g.div(x, g.number(2)))  # finer than the points that are remembered
    assert is_zero(g, g.sub(g.sub(g.mul(g.number(2), g.power(half, 2)), g.one), cosine))
    assert not is_zero(g, g.sub(half, cosine))
