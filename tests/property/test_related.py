"""Sines and cosines of related angles: the values stay, the calls become fewer, and never more work than before."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.nodes import Rational
from nhc.algebra.rewriting.related import relate_angles
from nhc.algebra.walks import reachable
from tests.property.expressions import QUIET

PLACE = (0.3, -1.1, 0.7)


def symbols(graph: Graph) -> list[Node]:
    return [graph.symbol(name) for name in "xyz"]


def combine(graph: Graph, factors: Sequence[float]) -> Node:
    return graph.sum(graph.mul_number(k, s) for k, s in zip(factors, symbols(graph), strict=True))


def count_calls(graph: Graph, roots: Sequence[Node]) -> int:
    return sum(graph.op[node] in ("sin", "cos") for node in reachable(graph, roots))


def turn(graph: Graph, angles: Sequence[Node], functions: Sequence[str] = ("sin", "cos")) -> list[Node]:
    return [graph.function(name, angle) for angle in angles for name in functions]


@pytest.mark.parametrize(
    ("angles", "calls"),
    [
        ([(1, 0, 0), (0, 1, 0), (1, -1, 0)], 4),
        ([(1, 0, 0), (2, 0, 0)], 2),
        ([(1, 0, 0), (3, 0, 0)], 2),
        ([(1, 0, 0), (2, 0, 0), (4, 0, 0)], 2),
        ([(1, 0, 0), (0, 1, 0), (1, 0, 1), (0, 1, 1)], 6),  # a snakeboard: x + z less x plus y
        ([(1, 1, 0), (1, -1, 0), (1, 0, 0)], 4),
        ([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], 6),
        ([(1, 1, 0), (0, 1, 1), (1, 0, 1)], 6),  # independent
        ([(1, 0, 0), (0, 2, 0), (1, 1, 0)], 6),  # no half angles
        ([(5, 0, 0), (1, 0, 0)], 4),  # too far apart
    ],
)
def test_the_simplest_angles_are_computed_and_the_others_come_from_them(
    angles: list[tuple[int, int, int]], calls: int
) -> None:
    g = Graph()
    roots = turn(g, [combine(g, factors) for factors in angles])
    made = relate_angles(g, roots)
    assert count_calls(g, made) == calls
    assert are_equal(g, made, roots)
    assert (made == roots) == (calls == 2 * len(angles))


def test_sums_of_sums_end_where_their_rounding_would_add_up() -> None:
    g = Graph()
    x = g.symbol("x")
    for count in (20, 200):
        roots = turn(g, [g.mul_number(k, x) for k in range(1, count + 1)])
        made = relate_angles(g, roots)
        exact = evaluate(g, roots, {x: 0.7})
        assert max(abs(a - b) for a, b in zip(evaluate(g, made, {x: 0.7}), exact, strict=True)) < 4e-15
        assert (count_calls(g, made) < count_calls(g, roots)) == (count == 20)


def test_no_second_function_is_called_to_spare_one() -> None:
    g = Graph()
    x, y, _ = symbols(g)
    roots = turn(g, [x, y, g.add(x, y)], ["sin"])
    assert relate_angles(g, roots) == roots
    assert count_calls(g, relate_angles(g, [*roots, g.function("cos", x), g.function("cos", y)])) == 4


def test_terms_that_stand_twice_in_a_sum_count_twice() -> None:
    g = Graph()
    x, y, z = symbols(g)
    angle = g.add(g.add(x, y), g.sub(z, x))  # the graph cancels neighbours only
    roots = turn(g, [angle, y, z])
    made = relate_angles(g, roots)
    assert count_calls(g, made) == 4
    assert are_equal(g, made, roots)


def test_multiples_of_a_sum_are_those_of_its_terms() -> None:
    g = Graph()
    x, y, _ = symbols(g)
    both = g.add(x, y)
    roots = turn(g, [both, g.mul_number(2, both), g.mul_number(3, g.sub(both, g.mul_number(2, y)))])
    made = relate_angles(g, roots)
    assert count_calls(g, made) == 4  # x + y, and 3 (x - y)
    assert are_equal(g, made, roots)


@pytest.mark.parametrize(
    "phases",
    [(0, Fraction(1, 2)), (0, -2, 1), (Fraction(3, 10), 1), (1, Fraction(3, 2), Fraction(-7, 3))],
)
def test_angles_that_differ_by_numbers_are_called_once(phases: tuple[Rational, ...]) -> None:
    """The sines and cosines of the numbers are numbers, which a compiler knows."""
    g = Graph()
    x, y, _ = symbols(g)
    turning = g.mul(x, y)
    roots = turn(g, [g.add(turning, g.number(phase)) for phase in phases])
    made = relate_angles(g, roots)
    moving = [n for n in reachable(g, made) if g.op[n] in ("sin", "cos") and g.deps[n]]
    assert len(moving) == 2
    values = dict(zip(symbols(g), PLACE, strict=True))
    assert evaluate(g, made, values) == pytest.approx(evaluate(g, roots, values), abs=1e-14)


def test_of_many_angles_sums_are_taken_and_multiples_are_not() -> None:
    """Those of an arm of many joints, by the angle of each against the one before it."""
    g = Graph()
    joints = [g.symbol(f"q{k}") for k in range(15)]
    sums = [g.sum(joints[i:j]) for i in range(15) for j in range(i + 1, 16)]
    roots = turn(g, [*sums, g.mul_number(7, joints[0])])
    made = relate_angles(g, roots)
    assert count_calls(g, made) <= 2 * 40 < count_calls(g, roots)
    values = {joint: 0.3 + 0.1 * k for k, joint in enumerate(joints)}
    assert evaluate(g, made, values) == pytest.approx(evaluate(g, roots, values), abs=1e-14)
    assert roots[-1] in made


def test_an_angle_that_holds_a_sine_is_left_alone() -> None:
    g = Graph()
    x, y, _ = symbols(g)
    inner = g.function("sin", g.add(x, y))
    roots = turn(g, [x, y, inner, g.add(x, inner)])
    made = relate_angles(g, roots)
    values = dict(zip(symbols(g), PLACE, strict=True))
    assert evaluate(g, made, values) == pytest.approx(evaluate(g, roots, values), abs=1e-14)
    assert count_calls(g, made) == 8  # sin(x + y) comes from x and y; the sums with a sine inside are called


@QUIET
@given(
    st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=2, max_size=7, unique=True),
    st.lists(st.sampled_from([("sin",), ("cos",), ("sin", "cos")]), min_size=7, max_size=7),
)
def test_random_angles_keep_their_values(angles: list[tuple[int, int, int]], functions: list[tuple[str, ...]]) -> None:
    g = Graph()
    roots = [
        node
        for factors, names in zip(angles, functions, strict=False)
        for node in turn(g, [combine(g, factors)], names)
    ]
    made = relate_angles(g, roots)
    values = dict(zip(symbols(g), PLACE, strict=True))
    assert evaluate(g, made, values) == pytest.approx(evaluate(g, roots, values), abs=1e-13)
    assert count_calls(g, made) <= count_calls(g, roots)
    assert all(math.isfinite(x) for x in evaluate(g, made, values))


def test_second_functions_of_angles_at_hand_cost_less_than_both_of_another() -> None:
    """sin x, sin y and both of x - y, as gravity and inertia of two rods need them."""
    g = Graph()
    x, y, _ = symbols(g)
    roots = [g.function("sin", x), g.function("sin", y), *turn(g, [g.sub(x, y)])]
    made = relate_angles(g, roots)
    called = {g.kids[node][0] for node in reachable(g, made) if g.op[node] in ("sin", "cos")}
    assert called == {x, y} and are_equal(g, made, roots)
