"""Boxes say of expressions that they never vanish at once only where they do not."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.bounds.subdivision import cannot_vanish_together
from nhc.algebra.graph import Graph, Node
from nhc.diagnostics import Source
from nhc.pipeline import check

GRAPH = Graph()
X, Y = GRAPH.symbol("x"), GRAPH.symbol("y")


def wave(name: str, p: int, q: int, shift: Node | None = None) -> Node:
    """A sine or cosine of p x + q y."""
    g = GRAPH
    angle = g.add(g.mul(g.number(p), X), g.mul(g.number(q), Y))
    return g.function(name, angle if shift is None else g.add(angle, shift))


@pytest.mark.parametrize("seed", range(30))
def test_two_waves_against_a_fine_grid(seed: int) -> None:
    """a + sin(px + qy) and b + cos(rx + sy): their zeros, where there are any, are found by solving for the angles."""
    rng = np.random.default_rng(seed)
    p, q, r, s = (int(k) for k in rng.integers(-2, 3, 4))
    a, b = (round(float(x), 2) for x in rng.uniform(-1.6, 1.6, 2))
    g = GRAPH
    first = g.add(g.number(a), wave("sin", p, q))
    second = g.add(g.number(b), wave("cos", r, s))
    grid = np.linspace(-math.pi, math.pi, 1201)
    x, y = np.meshgrid(grid, grid)
    least = float(np.min(np.maximum(abs(a + np.sin(p * x + q * y)), abs(b + np.cos(r * x + s * y)))))
    apart = cannot_vanish_together(g, [first, second], {})
    if least < 1e-4:
        assert not apart
    if least > 0.05:
        assert apart
    zero = find_common_zero(g, [first, second], [X, Y], [{X: u, Y: v} for u in (0.1, 1.3, -1.1) for v in (0.4, -0.9)])
    if apart or least > 0.05:
        assert zero is None
    if zero is not None:
        assert abs(a + math.sin(p * zero[X] + q * zero[Y])) < 1e-9
        assert abs(b + math.cos(r * zero[X] + s * zero[Y])) < 1e-9


def test_half_angles_go_around_twice() -> None:
    """cos(x/2) + 1/2 is positive for all |x| <= pi, and zero at x = 4 pi/3."""
    g = GRAPH
    half = g.function("cos", g.mul(g.div(g.one, g.number(2)), X))
    assert not cannot_vanish_together(g, [g.add(half, g.div(g.one, g.number(2)))], {})
    assert cannot_vanish_together(g, [g.add(half, g.div(g.one, g.number(2)))], {X: (-math.pi, math.pi)})


def test_what_also_stands_outside_a_sine_has_no_period() -> None:
    """x/4 + sin x has another zero than 0 nowhere near, x/100 + cos x has many: both vanish, and neither repeats."""
    g = GRAPH
    for tilt, name in ((4, "sin"), (100, "cos")):
        assert not cannot_vanish_together(g, [g.add(g.div(X, g.number(tilt)), g.function(name, X))], {})
    assert cannot_vanish_together(g, [g.add(g.div(X, g.number(4)), g.number(9)), X], {X: (-1.0, 1.0)})


def power(n: int) -> Node:
    return GRAPH.power(X, n)


@pytest.mark.parametrize(
    "roots",
    [
        (GRAPH.function("sin", power(4)), power(2)),
        (GRAPH.function("sin", GRAPH.function("abs", power(3))), GRAPH.sub(GRAPH.function("cosh", X), GRAPH.one)),
        (GRAPH.function("sin", GRAPH.mul(GRAPH.number(8), power(4))), GRAPH.function("sin", X)),
        (GRAPH.sub(GRAPH.one, GRAPH.function("cos", power(4))), GRAPH.function("tanh", X)),
    ],
)
def test_zeros_of_a_high_order_are_seen(roots: tuple[Node, ...]) -> None:
    """All vanish at x = 0, so flatly that a bound's rounding is larger than the values nearby."""
    for known in ({}, {X: (-5.0, 5.0)}, {X: (-0.0, 0.3)}, {X: (-1.0, 3.0)}):
        assert not cannot_vanish_together(GRAPH, roots, known)


def test_sums_that_cancel_are_rounded_outwards() -> None:
    """x^4 + a + b - c - d is x^4 for a = c = 0.1, b = d = 0.2, and more where doubles add up."""
    g = GRAPH
    a, b, c, d = (g.symbol(name) for name in "abcd")
    node = g.sub(g.sub(g.add(g.add(power(4), a), b), c), d)
    known = {a: (0.1, 0.1), b: (0.2, 0.2), c: (0.1, 0.1), d: (0.2, 0.2), X: (-5.0, 5.0)}
    assert 0.1 + 0.2 - 0.1 - 0.2 > 1e-17
    assert not cannot_vanish_together(g, [node, g.function("sin", X)], known)
    assert cannot_vanish_together(g, [g.add(node, g.div(g.one, g.number(1000))), g.function("sin", X)], known)


def test_a_pole_at_a_full_turn_is_no_mistake() -> None:
    g = GRAPH
    pole = g.inverse(g.sub(g.one, g.function("cos", X)))
    assert cannot_vanish_together(g, [g.add(pole, g.one)], {})


def test_what_only_tends_to_zero_has_none() -> None:
    g = GRAPH
    assert find_common_zero(g, [g.function("exp", X)], [X], [{X: 0.0}, {X: -3.0}]) is None


@pytest.mark.parametrize("seed", range(6))
def test_a_common_zero_is_found(seed: int) -> None:
    """A circle and a line meet where Vieta says; a wave and a power where the power is; neither where the circle is too small."""
    g, rng = GRAPH, np.random.default_rng(seed)
    near = [{X: 4.0 + float(rng.uniform(-1, 1)), Y: 3.0 + float(rng.uniform(-1, 1))}]
    circle = g.sub(g.add(power(2), g.power(Y, 2)), g.number(25))
    line = g.sub(g.sub(X, Y), g.one)
    found = find_common_zero(g, [circle, line], [X, Y], near)
    assert found is not None and (found[X], found[Y]) == pytest.approx((4.0, 3.0), rel=1e-9)
    wave = g.function("sin", g.add(X, Y))
    found = find_common_zero(g, [wave, g.sub(power(3), g.number(64))], [X, Y], near)
    assert found is not None and found[X] == pytest.approx(4.0, rel=1e-6)
    assert math.sin(found[X] + found[Y]) == pytest.approx(0.0, abs=1e-9)
    small = g.sub(
        g.add(power(2), g.power(Y, 2)), g.div(g.one, g.number(3))
    )  # the line's distance from the centre is sqrt(1/2)
    assert find_common_zero(g, [small, line], [X, Y], near) is None


def test_the_cosine_of_an_arc_vanishes_nowhere() -> None:
    """It is 1/sqrt(1 + x^2); what stands beside it still counts."""
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    arc = g.function("cos", g.function("atan", x))
    assert cannot_vanish(g, arc, {}) and cannot_vanish(g, g.neg(g.power(g.mul(arc, g.function("cosh", y)), 2)), {})
    assert not cannot_vanish(g, g.mul(arc, y), {}) and not cannot_vanish(
        g, g.function("sin", g.function("atan", x)), {}
    )
    assert not cannot_vanish(g, g.sub(arc, g.number(1)), {})


@pytest.mark.parametrize(
    ("text", "apart"),
    [
        ("exp(x)", True),
        ("exp(-t/5)", True),
        ("exp(sin(x) - y)*(2 - cos(y))", True),
        ("(1 + x^2)/(1 + y^2)", True),
        ("x*exp(x)", False),
        ("exp(x) - 1", False),
        ("(1 + x)/(1 + y^2)", False),
    ],
)
def test_what_tends_to_zero_and_reaches_it_nowhere(text: str, apart: bool) -> None:
    """Quasi-velocities are warned of where their determinant vanishes, not for exp x."""
    spec = "nhc: 1\nsystem: w\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nconstraints: [z' = y*x']\n"
    found = check(Source("w.yaml", f"{spec}quasi_velocities: {{u: x'*({text}), w: y'}}\n"), explain=False)
    assert ("W0408" in {one.code for one in found.diagnostics}) != apart
