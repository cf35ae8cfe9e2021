"""Sums are written as a reader looks for their terms, in whatever order they were made."""

from __future__ import annotations

from itertools import permutations

import pytest

from nhc.algebra.graph import Graph
from nhc.algebra.reading import Reading
from nhc.algebra.show import to_text
from nhc.diagnostics import Source
from nhc.pipeline import derive


def build() -> tuple[Graph, dict[str, int]]:
    g = Graph()
    x, y = (g.symbol(name, "coordinate") for name in "xy")
    v = g.symbol("x", "velocity")
    m, k = (g.symbol(name, "parameter") for name in "mk")
    a = g.symbol("x", "acceleration")
    return g, {"x": x, "y": y, "v": v, "m": m, "k": k, "a": a}


@pytest.mark.parametrize("order", list(permutations(range(3))))
def test_terms_are_ordered_by_what_moves(order: tuple[int, ...]) -> None:
    g, s = build()
    x2, y2, one = g.power(s["x"], 2), g.power(s["y"], 2), g.one
    sums = {
        "m*x'' + k*x'^2 - x": [g.mul(s["m"], s["a"]), g.mul(s["k"], g.power(s["v"], 2)), g.neg(s["x"])],
        "x^2 + y^2 - 1": [x2, y2, g.neg(one)],
        "1 - x - y": [one, g.neg(s["x"]), g.neg(s["y"])],
        "m + x^2 + y^2": [s["m"], x2, y2],
        "x^2 + y^2 - m": [x2, y2, g.neg(s["m"])],
        "-m - x - y": [g.neg(s["m"]), g.neg(s["x"]), g.neg(s["y"])],
    }
    for expected, terms in sums.items():
        assert to_text(g, g.sum([terms[i] for i in order])) == expected


def test_a_given_order_goes_before_that_of_declaration() -> None:
    g, s = build()
    total = g.add(s["x"], s["y"])
    assert [node for _, node in Reading(g, [s["y"], s["x"]]).terms(total)] == [s["y"], s["x"]]
    assert [node for _, node in Reading(g).terms(total)] == [s["x"], s["y"]]
    assert [node for _, node in Reading(g).terms(g.add(total, s["v"]), {total})] == [s["v"], total]


def test_equations_begin_with_their_accelerations() -> None:
    text = (
        "nhc: 1\nsystem: swing\ncoordinates: [b, a]\nparameters: {m: 1, g: 9.8, l: 0.3, c: 0.1}\n"
        "T: m*l^2*(a'^2 + b'^2)/2\nV: -m*g*l*cos(a) - m*g*l*cos(b)\nforces: {a: -c*a'}\n"
    )
    shown = derive(Source("swing.yaml", text))
    assert "da:  m*l*(l*a'' + g*sin(a)) + c*a' = 0" in shown
    assert "T = m*l^2*(b'^2 + a'^2)/2" in shown
