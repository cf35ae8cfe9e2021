"""Products in common, and sines of sums of angles: the values stay, and the cost does not grow."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.calculus import count, reachable
from nhc.algebra.exact.modular import are_equal, is_zero
from nhc.algebra.graph import Graph
from nhc.algebra.rewriting.angles import normalise_angles, split_angles
from nhc.algebra.rewriting.products import share_products
from tests.property.expressions import QUIET, Tree, build, smooth_trees


@QUIET
@given(st.lists(smooth_trees, min_size=1, max_size=4))
def test_shared_products_are_equal(trees: list[Tree]) -> None:
    g = Graph()
    roots = [build(g, tree) for tree in trees]
    assert are_equal(g, share_products(g, roots, 0), roots)


@pytest.mark.parametrize("seed", range(20))
def test_products_of_few_factors_share_them(seed: int) -> None:
    g, draw = Graph(), random.Random(seed)
    factors = [g.function(draw.choice(("sin", "exp")), g.symbol(f"x{k}", "coordinate")) for k in range(5)]
    masses = [g.symbol(f"m{k}", "parameter") for k in range(2)]
    roots = [g.product(draw.sample([*factors, *masses], draw.randrange(2, 6))) for _ in range(8)]
    shared = share_products(g, roots, g.mask(masses))
    assert are_equal(g, shared, roots)
    assert count(g, shared) <= count(g, roots)


def test_the_pair_that_is_hidden_in_the_order_is_found() -> None:
    g = Graph()
    k, v, a, b, c = (g.symbol(name, "other") for name in "kvabc")
    roots = [g.mul(v, g.mul(k, x)) for x in (a, b, c)]
    assert count(g, share_products(g, roots, 0)) == 4 < count(g, roots)


def test_what_is_constant_stays_in_front() -> None:
    g = Graph()
    m, r = (g.symbol(name, "parameter") for name in "mr")
    v, w = (g.symbol(name, "quasi") for name in "vw")
    (root,) = share_products(g, [g.mul(v, g.mul(m, g.mul(w, r)))], g.mask((m, r)))
    roots = share_products(g, [g.mul(v, g.mul(m, g.mul(w, r))), g.mul(r, g.mul(w, m))], g.mask((m, r)))
    assert is_zero(g, g.sub(root, g.product((m, r, v, w))))
    assert g.mul(m, r) in reachable(g, roots)


def test_sines_of_sums_split_and_join() -> None:
    g = Graph()
    x, y = (g.symbol(name, "coordinate") for name in "xy")
    total = g.add(x, y)
    s, c = g.function("sin", total), g.function("cos", total)
    assert are_equal(g, split_angles(g, [s, c]), [s, c])
    turned_back = g.add(g.mul(c, g.function("cos", x)), g.mul(s, g.function("sin", x)))
    assert normalise_angles(g, turned_back, 60) == g.function("cos", y)
    assert normalise_angles(g, s, 60) == s
