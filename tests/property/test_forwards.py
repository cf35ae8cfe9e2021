"""Brackets along a path, by series: they are those that are written down."""

from __future__ import annotations

from itertools import count

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.dense import pack
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.jets import WIDTH
from nhc.algebra.graph import Graph
from nhc.mechanics.properties.flag import growth_vector, terminal_rank
from nhc.mechanics.properties.forwards import Field, Forwards
from nhc.mechanics.properties.integrability import lie_bracket
from tests.property.expressions import NAMES, QUIET, Tree, build, rational_trees, smooth_trees

TERMS = 4


def fields_of(g: Graph, trees: list[list[Tree]]) -> list[Field]:
    return [tuple(build(g, tree) for tree in row) for row in trees]


@QUIET
@given(
    st.lists(st.lists(rational_trees | smooth_trees, min_size=3, max_size=3), min_size=2, max_size=2),
    st.integers(0, 10**6),
)
def test_brackets_by_series_are_those_that_are_written_down(trees: list[list[Tree]], seed: int) -> None:
    g = Graph()
    variables = [g.symbol(name) for name in NAMES]
    try:
        first, second = fields_of(g, trees)
        weights = [g.symbol(f"weight {k}", "other") for k in range(2)]
        mixed = tuple(g.dot(weights, column) for column in zip(first, second, strict=True))
        path, point = Forwards(g, variables, [first, second], mixed), FieldPoint(g, seed)
        jets = path._follow(point, TERMS)
        packed = {y: pack(jets.series[y][0], WIDTH) for y in path._turning}
        lifts = path.linear.lifts(TERMS, point.prime)
        vector = [list(jets.series[x][0]) for x in second]
        written: Field = second
        for left in range(TERMS, 1, -1):
            vector = path._bracket(vector, packed, lifts, jets, left)
            written = lie_bracket(g, variables, mixed, written)
            assert [series[0] for series in vector] == point.evaluate(written)
    except (Unlucky, ZeroDivisionError):
        return  # a pole, or a root that the field does not have


@pytest.mark.parametrize(
    ("size", "rank"),
    [(3, 3), (6, 6), (17, 17), (40, 40), (6, 5), (40, 39)],
)
def test_long_chains_fill_the_space_or_do_not(size: int, rank: int) -> None:
    """x_1' = u, x_2' = v, x_{k+1}' = x_k v: each needs one bracket more; a copy of the last one adds no direction."""
    g, number = Graph(), count(1)
    x = [g.symbol(f"x{next(number)}") for _ in range(size)]
    chained = [g.one if k == 1 else x[0] if k == 2 else x[k - 1] for k in range(1, size)]
    if rank < size:
        chained[-1] = chained[-2]
    fields = [(g.one, *[g.zero] * (size - 1)), (g.zero, *chained)]
    assert terminal_rank(g, x, fields) == rank
    if size < 20:
        assert growth_vector(g, x, fields)[-1] == rank
