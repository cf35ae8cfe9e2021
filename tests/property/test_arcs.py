"""Sines and cosines of arcs are algebraic: the values stay, modulo primes and in doubles, and no call is left."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.arcs import open_arcs
from nhc.algebra.rewriting.related import relate_angles
from nhc.algebra.walks import reachable
from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.pipeline import Options, model, program
from tests.property.expressions import QUIET


def list_calls(graph: Graph, roots: list[Node]) -> list[str]:
    return sorted(
        graph.op[node]
        for node in reachable(graph, roots)
        if graph.op[node] in ("sin", "cos", "asin", "acos", "atan", "atan2")
    )


@QUIET
@given(
    st.lists(st.tuples(st.sampled_from(["asin", "acos", "atan"]), st.sampled_from([1, -1])), min_size=1, max_size=2),
    st.sampled_from([-2, -1, 0, 1]),
)
def test_sines_of_sums_with_arcs_keep_their_values(arcs: list[tuple[str, int]], factor: int) -> None:
    g = Graph()
    x, y, z = (g.symbol(name) for name in "xyz")
    angle = g.mul_number(factor, z)
    for (name, sign), argument in zip(arcs, (g.mul(x, g.function("sin", y)), y), strict=False):
        angle = g.add(angle, g.mul_number(sign, g.function(name, argument)))
    roots = [g.function("sin", angle), g.function("cos", angle)]
    made = open_arcs(g, roots)
    assert are_equal(g, made, roots)
    allowed = 2 * (factor != 0) + any(g.op[node] == "sin" and g.a[node] == y for node in reachable(g, made))
    assert len(list_calls(g, made)) <= allowed
    place = {x: 0.4, y: -0.7, z: 1.3}
    for exact, found in zip(evaluate(g, roots, place), evaluate(g, made, place), strict=True):
        assert found == pytest.approx(exact, abs=1e-15)


def test_arcs_of_arcs_are_opened_together() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    inner = g.function("sin", g.add(y, g.function("atan", x)))
    roots = [g.function("cos", g.function("asin", g.mul_number(1, inner)))]
    made = open_arcs(g, roots)
    assert are_equal(g, made, roots)
    assert list_calls(g, made) == ["cos", "sin"]


def test_an_arc_whose_tangent_may_be_infinite_stays() -> None:
    """At x = 0 y/x over its own length is no number, and exp(x)^2 is no double from 355 on; a cosine is never zero."""
    g = Graph()
    x, y, k = g.symbol("x", "coordinate"), g.symbol("y", "coordinate"), g.symbol("k", "parameter")
    for tangent in (g.div(y, x), g.div(y, k), g.function("exp", x), g.function("log", g.power(x, 2))):
        kept = [g.function("cos", g.function("atan", tangent))]
        assert relate_angles(g, kept) == kept
    for tangent in (g.mul(k, g.power(y, 3)), g.mul(k, g.function("tan", x))):
        roots = [g.function("cos", g.function("atan", tangent))]
        assert "atan" not in list_calls(g, relate_angles(g, roots))
        assert math.isfinite(evaluate(g, open_arcs(g, roots), {x: math.pi / 2, y: 3.0, k: 0.5})[0])


def test_a_connecting_rod_by_its_arc_takes_no_call_of_it() -> None:
    text = """nhc: 1
system: slider_crank
coordinates: [a]
parameters: {r: 0.2, l: 0.7, J: 0.1, m: 1, K: 0.05, M: 2, g: 9.81}
define:
  b: asin(r/l*sin(a))
  X: r*cos(a) + l/2*cos(b)
  Y: r/2*sin(a)
  s: r*cos(a) + l*cos(b)
T: J/2*a'^2 + m/2*(X'^2 + Y'^2) + K/2*b'^2 + M/2*s'^2
V: m*g*Y
"""
    source = Source("slider_crank.yaml", text)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.calls == 3  # sine, cosine and the root
    assert all(agreement.accelerations for agreement in certify(model(source).system, points=1).agreements)
