"""Powers of two that go into what is computed before: the same values to the last bit, and never more multiplications."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import MUL, NUM, Graph, Node
from nhc.algebra.rewriting import numbers
from nhc.algebra.rewriting.numbers import fold_numbers
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.walks import reachable
from nhc.mechanics.rotations.rotation import make_rotation
from tests.property.expressions import QUIET, Tree, build, rational_trees, smooth_trees
from tests.property.test_algebra import Fractions, points, values_at

FLOATS = (0.7371, -1.3313, 2.1913)


def multiplications(g: Graph, roots: list[Node]) -> int:
    """Those by a number that is no 1/x."""
    nodes = reachable(g, roots)
    by_number = [g.b[node] for node in nodes if g.op[node] == MUL and g.op[g.a[node]] == NUM]
    return sum(not (g.op[x] == "pow" and g.b[x] == -1) for x in by_number)


@pytest.fixture(autouse=True)
def _any_number(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numbers, "_FEW", 0)
    monkeypatch.setattr(numbers, "_RARE", 1000)


@QUIET
@given(st.lists(rational_trees, min_size=1, max_size=5), points)
def test_rational_expressions_keep_their_values(trees: list[Tree], point: tuple[Fraction, ...]) -> None:
    g = Graph()
    try:
        old = [build(g, tree) for tree in trees]
        before = evaluate(g, old, values_at(g, point), Fractions)
        new = fold_numbers(g, old)
        assert evaluate(g, new, values_at(g, point), Fractions) == before
    except ZeroDivisionError:
        assume(False)
    assert multiplications(g, new) <= multiplications(g, old)


@QUIET
@given(st.lists(smooth_trees, min_size=1, max_size=5))
def test_doubles_are_the_same_to_the_last_bit(trees: list[Tree]) -> None:
    g = Graph()
    old = [build(g, tree) for tree in trees]
    new = fold_numbers(g, old)
    assert multiplications(g, new) <= multiplications(g, old)
    values = {g.symbol(name): x for name, x in zip("xyz", FLOATS, strict=True)}
    try:
        before = evaluate(g, old, values)
    except (OverflowError, ZeroDivisionError, ValueError):
        assume(False)
    assert evaluate(g, new, values) == before


def test_the_entries_of_a_rotation_are_computed_whole() -> None:
    g = Graph()
    e = [g.symbol(f"e{k}", "coordinate") for k in range(4)]
    v = [g.symbol(f"e{k}", "velocity") for k in range(4)]
    rotation = make_rotation(g, "R", range(4), 1, e, v)
    w = [g.symbol(f"w{k}") for k in range(3)]
    roots = [g.dot(row, w) for row in rotation.matrix]
    assert multiplications(g, roots) > 6
    assert multiplications(g, fold_numbers(g, roots)) == 0
    off = WithoutRules(["folded numbers"])
    same = [
        off.dot([off.mul(off.number(2), off.symbol("x")) for _ in range(3)], [off.symbol(f"w{k}") for k in range(3)])
    ]
    assert fold_numbers(off, same) == same


def test_a_number_is_multiplied_once_where_all_uses_have_it() -> None:
    """2 x y z, 2 x y w and 2 x y u: 2 (x y), and no more."""
    g = Graph()
    x, y, *others = (g.symbol(name) for name in "xyzwu")
    product = g.mul(x, y)
    roots = [g.add(g.mul(g.number(2), g.mul(product, other)), other) for other in others]
    assert multiplications(g, roots) == 3
    assert multiplications(g, fold_numbers(g, roots)) == 1
    three = [g.mul(g.number(3), g.mul(product, other)) for other in others]
    assert fold_numbers(g, three) == three  # a multiplication by 3 rounds, and would round elsewhere
