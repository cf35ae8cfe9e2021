"""What polynomials have in common, multiplied out."""

from __future__ import annotations

import sys

import pytest

from nhc.algebra.exact.modular import is_zero
from nhc.algebra.expand import Polynomial
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import polynomial
from nhc.algebra.shared import find_shared
from nhc.algebra.show import to_text


def multiplied_out(g: Graph, node: Node, circle: bool) -> Node:
    p: Polynomial = polynomial(g, node, circle=circle)
    return g.sum([g.mul_number(k, g.product(g.power(x, n) for x, n in monomial)) for monomial, k in p.items()])


def build(g: Graph, name: str) -> Node:
    x, y, angle = g.symbol("x"), g.symbol("y"), g.symbol("th")
    s, c = g.function("sin", angle), g.function("cos", angle)
    return {
        "x": x,
        "2 + x": g.add(x, g.number(2)),
        "circle": g.sum([g.power(x, 2), g.power(y, 2), g.number(-1)]),
        "x (x + y)": g.mul(x, g.add(x, y)),
        "square": g.power(g.sub(x, y), 2),
        "sin": s,
        "1 - 2 cos": g.sub(g.one, g.mul_number(2, c)),
        "1 + cos": g.add(g.one, c),
        "turned": g.sub(g.mul(x, s), g.mul(y, c)),
        "nothing": g.one,
    }[name]


@pytest.mark.parametrize("circle", [False, True])
@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("x", ["x"]),
        ("2 + x", ["2 + x"]),
        ("circle", ["x^2 + y^2 - 1"]),
        ("x (x + y)", ["x", "x + y"]),
        ("square", ["x - y"]),
        ("sin", ["sin(th)"]),
        ("1 - 2 cos", ["1 - 2*cos(th)"]),
        ("1 + cos", ["cos(th/2)"]),
        ("nothing", []),
    ],
)
def test_factors_of_the_row_of_a_knife_edge(name: str, expected: list[str], circle: bool) -> None:
    """Also where cos^2 was written 1 - sin^2, so that no product is to be seen."""
    g = Graph()
    factor, angle = build(g, name), g.symbol("th")
    row = [g.neg(g.function("sin", angle)), g.function("cos", angle)]
    found = find_shared(g, [multiplied_out(g, g.mul(factor, x), circle) for x in row])
    assert sorted(to_text(g, x) for x in found) == expected


def test_a_factor_of_both_coordinates_and_an_angle() -> None:
    g = Graph()
    factor = build(g, "turned")
    (found,) = find_shared(g, [multiplied_out(g, g.mul(factor, build(g, x)), True) for x in ("2 + x", "circle", "sin")])
    assert is_zero(g, g.sub(found, factor)) or is_zero(g, g.add(found, factor))


def test_no_sympy_where_nothing_is_shared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "sympy", None)
    g = Graph()
    assert find_shared(g, [build(g, x) for x in ("x (x + y)", "circle", "2 + x", "sin")]) == []


def test_what_is_zero_by_the_circle_alone_is_left_out() -> None:
    g = Graph()
    s, c = g.function("sin", g.symbol("th")), g.function("cos", g.symbol("th"))
    zero = g.sum([g.power(s, 2), g.mul(c, g.sub(c, g.power(s, 2))), g.mul(c, g.power(s, 2)), g.number(-1)])
    assert is_zero(g, zero) and find_shared(g, [zero]) == []
    assert find_shared(g, [zero, g.mul(g.symbol("x"), c), g.mul(g.symbol("x"), s)]) == [g.symbol("x")]
