"""Points of a prime field at which dozens of square roots exist: symbols are drawn one after the other."""

from __future__ import annotations

from itertools import combinations, islice

import pytest

from nhc.algebra.exact.degree import Degrees
from nhc.algebra.exact.draw import QuickPoint, draw_points
from nhc.algebra.exact.field import FieldPoint
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Graph, Node
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.pairs.verdict import compare_specs
from nhc.mechanics.resolving.resolve import resolve


def distances(count: int) -> tuple[Graph, list[Node], list[Node]]:
    """The graph, the places of points in a plane, and the distances between every two of them."""
    g = Graph()
    x, y = ([g.symbol(f"{c}{k}", "coordinate") for k in range(count)] for c in "xy")
    roots = [
        g.function("sqrt", g.add(g.power(g.sub(x[i], x[j]), 2), g.power(g.sub(y[i], y[j]), 2)))
        for i, j in combinations(range(count), 2)
    ]
    return g, [*x, *y], roots


@pytest.mark.parametrize("kind", [FieldPoint, QuickPoint])
@pytest.mark.parametrize("count", [5, 8])
def test_all_roots_exist_where_points_are_drawn(count: int, kind: type[FieldPoint]) -> None:
    """28 independent roots exist together at one point in 2^28."""
    g, places, roots = distances(count)
    prime = primes_of(g)[0]
    drawn = [list(islice(draw_points(g, roots, prime, range(100, 200), kind=kind), 3)) for _ in range(2)]
    for found in drawn:
        assert len(found) == 3
        for _, point in found:
            assert [x * x % prime for x in point.evaluate(roots)] == point.evaluate([g.a[root] for root in roots])
    values = [[(seed, *point.evaluate(places)) for seed, point in found] for found in drawn]
    assert values[0] == values[1]  # what a certificate repeats
    assert len({row[1:] for row in values[0]}) == 3


def test_values_that_are_given_are_kept() -> None:
    g, places, roots = distances(7)
    prime = primes_of(g)[0]
    fixed = {places[-1]: 17, places[3]: 0}
    ((_, point),) = islice(draw_points(g, roots, prime, range(100), fixed), 1)
    assert point.evaluate(list(fixed)) == [17, 0] and len(point.evaluate(roots)) == 21


def test_what_never_exists_is_given_up() -> None:
    """-1 is no square modulo these primes, whatever the other roots."""
    g, places, roots = distances(6)
    never = g.function("sqrt", g.neg(g.power(places[0], 2)))
    assert not list(draw_points(g, [*roots, never], primes_of(g)[0], range(10_000)))


def test_zeros_and_others_are_told_apart_among_many_roots() -> None:
    g, _, roots = distances(8)
    total = g.sum(roots)
    squares = g.sum(
        [*(g.power(r, 2) for r in roots), *(g.mul_number(2, g.mul(r, s)) for r, s in combinations(roots, 2))]
    )
    zero, other = g.sub(g.power(total, 2), squares), g.sub(g.power(total, 2), g.add(squares, g.number(1)))
    assert are_zero(g, [zero, other]) == [True, False]


def test_degrees_add_up_one_symbol_after_the_other() -> None:
    """Of 28 distances symbols complete 7, 6, ..., 1: the sum of 4^k in place of 4^28."""
    g, _, roots = distances(8)
    next(draw_points(g, roots, primes_of(g)[0], range(10)))
    apart = sum(4**k for k in range(1, 8))
    assert Degrees(g, roots).inflate(3) == 2 * 3 * apart
    few, _, some = distances(3)
    assert Degrees(few, some).inflate(3) == 2 * 3 * 4**3


def net(stiffness: str = "k") -> Source:
    """Springs between neighbours of a net of 4 x 4 masses in space; one corner moves along a curve that it may not leave."""
    size = range(4)
    names = [f"{c}{i}{j}" for i in size for j in size for c in "xyz"]
    pairs = [((i, j), (i + 1, j)) for i in size[:-1] for j in size] + [
        ((i, j), (i, j + 1)) for i in size for j in size[:-1]
    ]
    lengths = ["sqrt(" + " + ".join(f"({c}{i}{j} - {c}{k}{m})^2" for c in "xyz") + ")" for (i, j), (k, m) in pairs]
    springs = [f"{'k' if n else stiffness}*({length} - l)^2/2" for n, length in enumerate(lengths)]
    return Source(
        "net.yaml",
        f"nhc: 1\nsystem: net\ncoordinates: [{', '.join(names)}]\nparameters: {{m: 1, k: 3, l: 0.8}}\n"
        f"T: m/2*({' + '.join(f'''{name}'^2''' for name in names)})\nV: {' + '.join(springs)}\n"
        "constraints: [\"z00*x00' = (1 + y00)*y00'\"]\n",
    )


@pytest.mark.slow
def test_a_net_of_springs_is_derived_alike_in_every_formulation() -> None:
    made = certify(resolve(decode(net())))
    assert made.holds and made.is_sure and len(made.agreements) == 4


def test_a_single_spring_makes_a_difference() -> None:
    def verdict(stiffness: str) -> tuple[bool, ...]:
        return compare_specs(net(), net(stiffness), (), ("one", "other")).found.equal

    assert all(verdict("(k + k)/2"))
    assert verdict("(k + 1e-9)").count(False) == 6  # both ends of it
