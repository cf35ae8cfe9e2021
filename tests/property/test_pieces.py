"""Trees between shared nodes: equal values, never more operations, nothing called that was not called before."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rewriting.pieces import shorten_pieces
from nhc.algebra.walks import count, reachable
from tests.property.expressions import QUIET, Tree, build, rational_trees
from tests.property.test_algebra import Fractions, X, Y, Z, num, points, values_at

HALF = num(Fraction(1, 2))


def shortened(tree: Tree) -> tuple[int, int]:
    """Operations before and after; the values agree exactly."""
    g = Graph()
    root = build(g, tree)
    made = shorten_pieces(g, [root])
    assert are_equal(g, made, [root])
    return count(g, [root]), count(g, made)


@pytest.mark.parametrize(
    ("tree", "least"),
    [
        (("*", HALF, ("+", ("*", num(2), ("*", X, Y)), ("*", num(6), ("*", X, Z)))), 4),  # x (y + 3 z)
        (("+", ("*", HALF, ("+", ("*", num(2), X), Y)), ("*", HALF, Y)), 1),  # x + y
        (("+", ("*", num(3), ("*", X, Y)), ("+", ("*", Y, Z), ("*", num(3), ("*", Z, X)))), 6),  # 3 x (y + z) + y z
    ],
)
def test_numbers_and_what_occurs_twice_come_together(tree: Tree, least: int) -> None:
    before, after = shortened(tree)
    assert after < before
    assert after <= least


def test_a_node_that_is_used_twice_stays_whole() -> None:
    g = Graph()
    shared = build(g, ("+", ("*", num(3), X), ("*", num(5), Y)))
    first = g.add(g.mul_number(2, g.mul(shared, g.symbol("z"))), g.mul_number(4, shared))
    second = g.function("sin", shared)
    made = shorten_pieces(g, [first, second])
    assert count(g, made) < count(g, [first, second])
    assert shared in reachable(g, made[:1])
    assert are_equal(g, made, [first, second])


def test_no_cosine_is_called_for_a_sine() -> None:
    g = Graph()
    sine = g.function("sin", g.symbol("x"))
    root = g.sub(g.number(3), g.mul_number(3, g.power(sine, 2)))
    shorter = normalise(g, root)
    assert any(g.op[node] == "cos" for node in reachable(g, [shorter])) and count(g, [shorter]) < count(g, [root])
    made = shorten_pieces(g, [root])
    assert not any(g.op[node] == "cos" for node in reachable(g, made))


@QUIET
@given(st.lists(rational_trees, min_size=1, max_size=3), points)
def test_random_trees_keep_their_values(trees: list[Tree], point: tuple[Fraction, ...]) -> None:
    g = Graph()
    try:
        roots: list[Node] = [build(g, tree) for tree in trees]
        values = evaluate(g, roots, values_at(g, point), Fractions)
        made = shorten_pieces(g, roots)
        found = evaluate(g, made, values_at(g, point), Fractions)
    except ZeroDivisionError:
        assume(False)
    assert found == values
    assert count(g, made) <= count(g, roots)


def turned_back(g: Graph, *, number: bool) -> Node:
    """The first component of a sum of two vectors, given on axes that are turned by two more angles, turned back by the first."""
    theta, steer, hitch = (g.symbol(name) for name in ("theta", "steer", "hitch"))
    thrust, drag = g.symbol("thrust"), g.symbol("drag")
    c, s = g.function("cos", theta), g.function("sin", theta)

    def in_space(length: Node, angle: Node) -> tuple[Node, Node]:
        a, b = g.function("cos", angle), g.function("sin", angle)
        return (
            g.mul(length, g.sub(g.mul(c, a), g.mul(s, b))),
            g.mul(length, g.add(g.mul(s, a), g.mul(c, b))),
        )

    (x, y), (u, v) = in_space(thrust, steer), in_space(g.power(drag, 3) if number else g.function("exp", drag), hitch)
    return g.add(g.mul(c, g.sub(x, u)), g.mul(s, g.sub(y, v)))


@pytest.mark.parametrize("number", [True, False])
def test_a_vector_that_is_turned_and_turned_back(number: bool) -> None:
    g = Graph()
    node = turned_back(g, number=number)
    (made,) = shorten_pieces(g, [node])
    assert are_equal(g, [made], [node])
    assert count(g, [made]) <= 7 < 18 <= count(g, [node])
    assert not g.depends(made, g.deps[g.symbol("theta")])


def test_squares_by_themselves_are_left_alone() -> None:
    g = Graph()
    a, b, m, n = (g.symbol(name) for name in "abmn")
    total = g.add(g.mul(m, g.power(g.sub(a, b), 2)), g.mul(n, g.power(g.add(a, g.function("exp", b)), 2)))
    assert shorten_pieces(g, [total]) == [total]
