"""Čaplygin's equations are not refused for what nhc chose: other dependent velocities are sought that allow them."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.mechanics.choosing.choose import applicable
from nhc.pipeline import Options, emit, model
from tests.support import python_model

CART = """nhc: 1
system: cart
about: Two driven wheels on one axle, which the centre of mass is ahead of.  Nothing is said of dependent velocities.
coordinates: [x, y, theta, p_R, p_L]
parameters: {m: 10, I: 0.6, J_w: 0.02, r: 0.1, b: 0.25, d: 0.1, tau_R: 0.3, tau_L: 0.2}
T: m/2*((x + d*cos(theta))'^2 + (y + d*sin(theta))'^2) + I/2*theta'^2 + J_w/2*(p_R'^2 + p_L'^2)
forces: {p_R: tau_R, p_L: tau_L}
constraints:
  - -sin(theta)*x' + cos(theta)*y' = 0
  - cos(theta)*x' + sin(theta)*y' + b*theta' - r*p_R' = 0
  - cos(theta)*x' + sin(theta)*y' - b*theta' - r*p_L' = 0
"""
ROLLERS = """nhc: 1
system: rollers
about: A cylinder rolls on a cylinder that rolls on the ground.
coordinates: [x, f1, f2, al]
parameters: {M: 3, m: 1, R: 0.5, r: 0.2, I1: 0.4, I2: 0.02, g: 9.81}
define: {X: x + (R + r)*sin(al), Z: R + (R + r)*cos(al)}
T: M/2*x'^2 + I1/2*f1'^2 + m/2*(X'^2 + Z'^2) + I2/2*f2'^2
U: -m*g*Z
constraints:
  - x' + R*f1' = 0
  - X'*cos(al) - Z'*sin(al) + r*f2' - (x'*cos(al) - R*f1') = 0
"""


def _names(text: str) -> list[str]:
    made = model(Source("s.yaml", text), Options(formulation="chaplygin"))
    assert made.formulation.dependent is not None
    return [made.system.q_names[i] for i in made.formulation.dependent.dependent]


def test_a_cart_on_two_wheels() -> None:
    """Against its equations in closed form: (m + 2 J_w/r^2) v' = m d w^2 + (tau_R + tau_L)/r, and the like for w."""
    assert "theta" not in _names(CART)
    m, inertia, wheel, r, b, d, right, left = 10, 0.6, 0.02, 0.1, 0.25, 0.1, 0.3, 0.2
    v, w, theta = 0.7, -0.4, 0.6
    v_rate = (m * d * w**2 + (right + left) / r) / (m + 2 * wheel / r**2)
    w_rate = (b * (right - left) / r - m * d * v * w) / (inertia + m * d**2 + 2 * wheel * b**2 / r**2)
    cos, sin = math.cos(theta), math.sin(theta)
    expected = [
        v_rate * cos - v * w * sin,
        v_rate * sin + v * w * cos,
        w_rate,
        (v_rate + b * w_rate) / r,
        (v_rate - b * w_rate) / r,
    ]
    (text,) = emit(Source("s.yaml", CART), "python", Options(formulation="chaplygin")).values()
    module = python_model(text, "cart_chaplygin")
    q = [0.3, -0.2, theta, 0.1, 0.4]
    y = module.state(0.0, q, [v * cos, v * sin, w, (v + b * w) / r, (v - b * w) / r])
    assert module.accelerations(0.0, y) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("text", [CART, ROLLERS])
def test_check_counts_it_among_those_that_apply(text: str) -> None:
    assert "chaplygin" in [f.name for f in applicable(model(Source("s.yaml", text)).system)]


def test_auto_takes_them_where_their_block_never_vanishes() -> None:
    made = model(Source("s.yaml", ROLLERS))
    assert made.formulation.name == "chaplygin" and made.formulation.dependent is not None
    assert made.formulation.dependent.regular


def test_what_the_spec_gives_is_kept() -> None:
    with pytest.raises(SpecError, match="E0411"):
        model(Source("s.yaml", CART + "dependent: [x, y, theta]\n"), Options(formulation="chaplygin"))
