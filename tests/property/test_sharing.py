"""Products and sums in common, and sines of sums of angles: the values stay, and the cost does not grow."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.exact.modular import are_equal, is_zero
from nhc.algebra.graph import Graph
from nhc.algebra.rewriting.angles import normalise_angles, split_angles
from nhc.algebra.rewriting.sharing import share_parts
from nhc.algebra.rewriting.sums import pair_terms
from nhc.algebra.walks import count, reachable
from tests.property.expressions import QUIET, Tree, build, smooth_trees


@QUIET
@given(st.lists(smooth_trees, min_size=1, max_size=4))
def test_shared_products_are_equal(trees: list[Tree]) -> None:
    g = Graph()
    roots = [build(g, tree) for tree in trees]
    assert are_equal(g, share_parts(g, roots, 0), roots)


@pytest.mark.parametrize("seed", range(20))
def test_products_of_few_factors_share_them(seed: int) -> None:
    g, draw = Graph(), random.Random(seed)
    factors = [g.function(draw.choice(("sin", "exp")), g.symbol(f"x{k}", "coordinate")) for k in range(5)]
    masses = [g.symbol(f"m{k}", "parameter") for k in range(2)]
    roots = [g.product(draw.sample([*factors, *masses], draw.randrange(2, 6))) for _ in range(8)]
    shared = share_parts(g, roots, g.mask(masses))
    assert are_equal(g, shared, roots)
    assert count(g, shared) <= count(g, roots)


def test_the_pair_that_is_hidden_in_the_order_is_found() -> None:
    g = Graph()
    k, v, a, b, c = (g.symbol(name, "other") for name in "kvabc")
    roots = [g.mul(v, g.mul(k, x)) for x in (a, b, c)]
    assert count(g, share_parts(g, roots, 0)) == 4 < count(g, roots)


def test_what_is_constant_stays_in_front() -> None:
    g = Graph()
    m, r = (g.symbol(name, "parameter") for name in "mr")
    v, w = (g.symbol(name, "quasi") for name in "vw")
    (root,) = share_parts(g, [g.mul(v, g.mul(m, g.mul(w, r)))], g.mask((m, r)))
    roots = share_parts(g, [g.mul(v, g.mul(m, g.mul(w, r))), g.mul(r, g.mul(w, m))], g.mask((m, r)))
    assert is_zero(g, g.sub(root, g.product((m, r, v, w))))
    assert g.mul(m, r) in reachable(g, roots)


@pytest.mark.parametrize("seed", range(20))
def test_sums_of_few_terms_share_them(seed: int) -> None:
    g, draw = Graph(), random.Random(seed)
    terms = [g.symbol(f"x{k}", "coordinate") for k in range(6)]
    signed = [[draw.choice((g.neg(x), x)) for x in draw.sample(terms, draw.randrange(2, 7))] for _ in range(12)]
    roots = [g.sum(own) for own in signed]
    shared = share_parts(g, roots, 0)
    assert are_equal(g, shared, roots)
    assert count(g, shared) < count(g, roots)


def test_a_difference_is_found_with_either_sign() -> None:
    g = Graph()
    a, b, c, d, e = (g.symbol(name, "other") for name in "abcde")
    roots = [g.add(a, g.sub(c, b)), g.sub(g.sub(b, d), a), g.mul(e, g.sub(a, b))]
    shared = share_parts(g, roots, 0)
    assert are_equal(g, shared, roots)
    assert count(g, shared) == 4 < count(g, roots) == 6
    assert g.sub(a, b) in reachable(g, shared)


def test_a_sum_used_twice_stays_whole() -> None:
    g = Graph()
    a, b, c, d = (g.symbol(name, "other") for name in "abcd")
    inner = g.add(a, g.add(b, c))
    roots = [g.mul(inner, d), g.add(inner, d), g.sub(g.add(a, c), d)]
    shared = share_parts(g, roots, 0)
    assert are_equal(g, shared, roots)
    assert count(g, shared) == 5 < count(g, roots)


def test_many_sums_of_many_terms_take_no_longer_than_there_are_terms() -> None:
    def steps(size: int) -> int:
        g = Graph()
        x = [g.symbol(f"x{k}", "coordinate") for k in range(size)]
        made = [0]

        class Counted(dict[int, int]):
            def __getitem__(self, key: int) -> int:
                made[0] += 1
                return super().__getitem__(key)

        chains = {1000 + k: Counted({x[(k + j) % size]: 1 for j in range(6)}) for k in range(size)}
        pair_terms(chains)
        return made[0]

    assert steps(400) < 2.2 * steps(200)


def test_sines_of_sums_split_and_join() -> None:
    g = Graph()
    x, y = (g.symbol(name, "coordinate") for name in "xy")
    total = g.add(x, y)
    s, c = g.function("sin", total), g.function("cos", total)
    assert are_equal(g, split_angles(g, [s, c]), [s, c])
    turned_back = g.add(g.mul(c, g.function("cos", x)), g.mul(s, g.function("sin", x)))
    assert normalise_angles(g, turned_back, 60) == g.function("cos", y)
    assert normalise_angles(g, s, 60) == s
