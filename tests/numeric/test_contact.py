"""Contacts of Hertz: powers of roots have slopes where nothing touches."""

from __future__ import annotations

import math

import mpmath
import pytest
from scipy.integrate import quad, solve_ivp

from nhc.algebra.calculus import derivative, gradient, tangent
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph
from nhc.diagnostics import Source
from nhc.pipeline import emit
from tests.support import python_model

WALL = """\
nhc: 1
system: wall
coordinates: [x]
parameters: {m: 2, k: 3000}
T: m/2*x'^2
V: k*max(-x, 0)^2.5
scenes:
  fall: {initial: {x: 1, x': -1.5}, time: [0, 2]}
"""


def test_a_ball_bounces_off_a_wall_after_the_time_of_hertz() -> None:
    """m v^2/2 = k d^(5/2) at the deepest point; the contact takes 2 d/v times the integral of (1 - s^(5/2))^(-1/2) (Hertz 1882)."""
    m, k, v = 2.0, 3000.0, 1.5
    deepest = (m * v**2 / (2 * k)) ** 0.4
    lasts = 2 * deepest / v * quad(lambda s: 1 / math.sqrt(1 - s**2.5), 0, 1)[0]
    (text,) = emit(Source("wall.yaml", WALL), "python").values()
    model = python_model(text, "wall")
    end = 1 / v + lasts + 0.5
    found = solve_ivp(lambda t, y: model.rhs(t, list(y)), (0, end), [1, -v], method="LSODA", rtol=1e-11, atol=1e-12)
    assert found.success
    assert found.y[:, -1] == pytest.approx([0.5 * v, v], rel=1e-6)
    for x in (1.0, 0.0):
        assert model.rhs(0.0, [x, -v]) == [-v, 0.0]
        assert model.jacobian(0.0, [x, -v]) == [[0.0, 1.0], [0.0, 0.0]]


@pytest.mark.parametrize(("power", "at"), [(3, 0.0), (5, 0.0), (7, 0.0), (5, 0.3), (3, 2.5)])
def test_slopes_of_powers_of_roots(power: int, at: float) -> None:
    """d/dx (x + x^2)^(n/2), in each of the three ways that a derivative is taken."""
    g = Graph()
    x = g.symbol("x")
    node = g.power(g.function("sqrt", g.add(x, g.power(x, 2))), power)
    exact = float(mpmath.mpf(power) / 2 * (at + at * at) ** mpmath.mpf((power - 2) / 2) * (1 + 2 * at))
    slopes = [derivative(g, node, x), gradient(g, node, [x])[0], tangent(g, [node], {x: g.one})[0]]
    assert evaluate(g, slopes, {x: at}) == pytest.approx([exact] * 3, rel=1e-14)
