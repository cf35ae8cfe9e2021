"""Boxes say of expressions that they never vanish at once only where they do not."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nhc.algebra.common_zero import find_common_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.subdivision import cannot_vanish_together

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


def test_what_only_tends_to_zero_has_none() -> None:
    g = GRAPH
    assert find_common_zero(g, [g.function("exp", X)], [X], [{X: 0.0}, {X: -3.0}]) is None
