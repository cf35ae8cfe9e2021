"""Taylor coefficients against derivatives written down; growth vectors against brackets written down."""

from __future__ import annotations

import math
import random
from itertools import product

import pytest

from nhc.algebra.calculus import derivative
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.jets import Jets, make_box, plan_jets
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.properties.flag import Field, growth_vector
from nhc.mechanics.properties.integrability import lie_bracket

LENGTHS, ORDER = (2, 1), 3


def variables_of(graph: Graph, count: int) -> list[Node]:
    return [graph.symbol(name, "coordinate") for name in "xyzuvw"[:count]]


def random_expression(graph: Graph, leaves: list[Node], rng: random.Random, depth: int) -> Node:
    if not depth:
        return rng.choice(leaves)
    a, b = (random_expression(graph, leaves, rng, depth - 1) for _ in range(2))
    kind = rng.randrange(9)
    if kind < 2:
        return graph.add(a, b)
    if kind < 5:
        return graph.mul(a, b)
    if kind == 5:
        return graph.power(graph.add(a, graph.one), rng.choice((-2, -1, 2, 3)))
    if kind == 6:
        return graph.function(rng.choice(("sin", "cos", "exp", "tanh", "atan")), a)
    if kind == 7:
        return graph.function("powf", graph.add(a, graph.number(3)), rng.choice((b, graph.symbol("c", "parameter"))))
    return graph.function("atan2", a, graph.add(b, graph.number(2)))


@pytest.mark.parametrize("seed", range(40))
def test_coefficients_are_derivatives(seed: int) -> None:
    """Along x + s + 2 d_0 + 3 d_1 and so on: the coefficient of s^k d_0^i d_1^j is a directional derivative over factorials."""
    rng, g = random.Random(seed), Graph()
    variables = variables_of(g, 2)
    node = random_expression(g, [*variables, g.symbol("c", "parameter"), g.number(2)], rng, 3)
    box = make_box(LENGTHS)
    steps = [[rng.randrange(1, 50) for _ in range(3)] for _ in variables]

    def along(f: Node, which: int) -> Node:
        slopes = (g.mul(g.number(step[which]), derivative(g, f, x)) for x, step in zip(variables, steps, strict=True))
        return g.sum(list(slopes))

    wanted: dict[tuple[int, int, int], Node] = {}
    for i, j, k in product(range(LENGTHS[0] + 1), range(LENGTHS[1] + 1), range(ORDER + 1)):
        f = node
        for which, times in enumerate((k, i, j)):
            for _ in range(times):
                f = along(f, which)
        wanted[i, j, k] = f
    plan = plan_jets(g, [node], variables)
    for number in range(20):
        point = FieldPoint(g, number)
        try:
            point.prepare([*plan.nodes, *wanted.values()])
            place = []
            for x, (first, second, third) in zip(point.evaluate(variables), steps, strict=True):
                series = [[0] * (ORDER + 1) for _ in box.parts]
                series[0][0], series[0][1], series[1][0], series[LENGTHS[0] + 1][0] = x, first, second, third
                place.append(series)
            jets = Jets(plan, point, place, box)
            for k in range(ORDER + 1):
                jets.extend(k)
            values = dict(zip(wanted, point.evaluate(wanted.values()), strict=True))
            break
        except Unlucky:
            continue
    for (i, j, k), value in values.items():
        factor = math.factorial(i) * math.factorial(j) * math.factorial(k)
        assert jets.series[node][i + (LENGTHS[0] + 1) * j][k] * factor % point.prime == value, (i, j, k)


def written_growth(graph: Graph, variables: list[Node], fields: list[Field]) -> tuple[int, ...]:
    """D_{k+1} = D_k + [D_1, D_k] with all brackets as expressions."""
    spanned, newest = list(fields), list(fields)
    ranks = [rank(graph, spanned)]
    while ranks[-1] < len(variables) and len(ranks) < 4:
        newest = [lie_bracket(graph, variables, x, y) for x in fields for y in newest if x != y]
        newest = [field for field in newest if any(node != graph.zero for node in field)]
        spanned += newest
        ranks.append(rank(graph, spanned))
        if ranks[-1] == ranks[-2]:
            return tuple(ranks[:-1])
    return tuple(ranks)


@pytest.mark.parametrize("seed", range(30))
def test_growth_of_random_fields(seed: int) -> None:
    rng, g = random.Random(1000 + seed), Graph()
    count = rng.choice((3, 4, 5, 6))
    variables = variables_of(g, count)
    number = rng.choice((2, 2, 3))
    depth = rng.choice((0, 1, 2))
    leaves = [*variables[: rng.choice((2, count))], g.one, g.zero, g.symbol("c", "parameter")]
    fields: list[Field] = []
    for k in range(number):
        tail = [random_expression(g, leaves, rng, depth) for _ in range(count - number)]
        fields.append((*(g.one if j == k else g.zero for j in range(number)), *tail))
    try:
        wanted = written_growth(g, variables, fields)
    except ZeroDivisionError:
        return
    found = growth_vector(g, variables, fields)
    assert found[: len(wanted)] == wanted
    assert len(found) == len(wanted) or len(wanted) == 4


def test_deep_flags() -> None:
    """Goursat's normal form with n variables needs brackets of n - 1 fields; Engel's chain with two shafts runs twice as wide."""
    g = Graph()
    x = [g.symbol(f"x{k}", "coordinate") for k in range(24)]
    chain = (g.one, g.zero, *x[1:-1])
    turn = (g.zero, g.one, *([g.zero] * 22))
    assert growth_vector(g, x, [chain, turn]) == tuple(range(2, 25))
    y = x[:9]
    wide = (g.one, g.zero, g.zero, *y[1:7])
    shafts = [tuple(g.one if j == k else g.zero for j in range(9)) for k in (1, 2)]
    assert growth_vector(g, y, [wide, *shafts]) == (3, 5, 7, 9)


def test_roots_of_squares_have_a_sign() -> None:
    """|x| is x or -x: the field along it and the field along x commute with what does not hold x."""
    g = Graph()
    x, y, z = variables_of(g, 3)
    size = g.function("sqrt", g.power(x, 2))
    assert growth_vector(g, [x, y, z], [(g.one, g.zero, size), (g.zero, g.one, g.zero)]) == (2,)
    assert growth_vector(g, [x, y, z], [(g.one, g.zero, g.mul(size, y)), (g.zero, g.one, g.zero)]) == (2, 3)


@pytest.mark.parametrize(
    ("letters", "size", "ranks"), [(2, 14, (2, 3, 5, 8, 14)), (2, 16, (2, 3, 5, 8, 14, 16)), (3, 16, (3, 6, 14, 16))]
)
def test_growth_of_generic_fields(letters: int, size: int, ranks: tuple[int, ...]) -> None:
    """Brackets of generic fields are as independent as in the free Lie algebra (Witt 1937: 2, 1, 2, 3, 6; 3, 3, 8)."""
    rng, g = random.Random(size), Graph()
    x = [g.symbol(f"x{k}", "coordinate") for k in range(size)]
    fields: list[Field] = []
    for k in range(letters):
        tail = []
        for _ in range(size - letters):
            powers = [g.product(g.power(v, rng.randrange(1, 4)) for v in rng.sample(x[:letters], 2)) for _ in range(4)]
            tail.append(
                g.sum([g.scale(rng.randrange(1, 9), power) for power in [*powers, *rng.sample(x[letters:], 2)]])
            )
        fields.append((*(g.one if i == k else g.zero for i in range(letters)), *tail))
    assert growth_vector(g, x, fields) == ranks


def test_brackets_of_more_than_one_random_field() -> None:
    """x'' and y'' drive z' = x y'' - y x'' and more: brackets that one generic field alone does not lead to."""
    g = Graph()
    x = [g.symbol(f"x{k}", "coordinate") for k in range(9)]
    rest = (g.one, x[0], x[1], g.mul(x[0], x[3]), g.mul(x[1], x[4]), g.mul(x[2], x[5]), g.mul(x[2], x[6]))
    fields: list[Field] = [(g.one, g.zero, *(g.zero for _ in rest)), (g.zero, g.one, *rest)]
    assert growth_vector(g, x, fields) == written_growth(g, x, fields)
