"""Canonical forms are taken only where they keep the digits: emitted values against slopes in 60 digits, near small differences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import mpmath as mp
import pytest

from nhc.algebra.graph import Graph
from nhc.algebra.polynomial import normalise
from nhc.algebra.rewriting.digits import keep_digits, normalise_kept
from nhc.language import Source
from nhc.pipeline import Options, emit
from tests.support import python_model

STEP = mp.mpf(10) ** -15

ROOT_OF_POWER = """nhc: 1
system: root_of_power
coordinates: [u]
parameters: {b: 1.5}
define:
  X: (cos(u)^8)^(1/8)
  Y: -min(cos(u), -cos(u))
T: b/2*(u'^2 + X'^2) + b/2*Y'^2
U: sqrt(cos(u)^2*(cos(u)^2 + 1))
"""

COFRAME = """nhc: 1
system: coframe
coordinates: [x, y, theta]
parameters: {a: 1.5, b: 2, m: 1}
define:
  X: x + b*(x - y - 1)^8*cos(theta)
  Y: y + b*(x - y - 1)^8*sin(theta)
T: m/2*(X'^2 + Y'^2) + a/2*theta'^2
constraints:
  - slip: -sin(theta)*X' + cos(theta)*Y' = 0
"""


def model(text: str, name: str, formulation: str = "") -> Any:
    (code,) = emit(Source(f"{name}.yaml", text), "python", Options(formulation)).values()
    return python_model(code, name)


def slope(f: Callable[[Any], Any], x: Any) -> Any:
    return (f(x + STEP) - f(x - STEP)) / (2 * STEP)


@pytest.mark.parametrize("u", [-1.824, -1.4, 1.2, 1.45, 1.65, 2.9])
def test_a_high_power_of_a_cosine_under_a_root(u: float) -> None:
    made, speed, b = model(ROOT_OF_POWER, "root_of_power"), 0.9, 1.5
    with mp.workdps(60):
        x = lambda z: abs(mp.cos(z))  # noqa: E731
        first, second = (lambda z: slope(x, z)), mp.mpf(u)
        potential = lambda z: mp.sqrt(mp.cos(z) ** 2 * (mp.cos(z) ** 2 + 1))  # noqa: E731
        mass = b * (1 + 2 * first(second) ** 2)  # X = Y = |cos(u)|
        force = slope(potential, second) - 2 * b * first(second) * slope(first, second) * mp.mpf(speed) ** 2
        expected = float(force / mass)
    assert made.accelerations(0.0, [u, speed]) == pytest.approx([expected], rel=1e-11)


@pytest.mark.parametrize("formulation", ["", "multipliers"])
@pytest.mark.parametrize("distance", [0.2, 0.25, -0.2])
def test_a_determinant_that_is_a_power_of_a_difference(formulation: str, distance: float) -> None:
    """The rate of the constraint on the motion: a(q)' q' + a(q) q'' = 0, with slopes in 60 digits."""
    made, q = model(COFRAME, "coframe", formulation), [0.45 + distance, -0.55, 0.7]

    def residual(q: Sequence[Any], v: Sequence[Any]) -> Any:
        along = [lambda h, k=k: q[k] + h * v[k] for k in range(3)]
        X = lambda h: along[0](h) + 2 * (along[0](h) - along[1](h) - 1) ** 8 * mp.cos(along[2](h))  # noqa: E731
        Y = lambda h: along[1](h) + 2 * (along[0](h) - along[1](h) - 1) ** 8 * mp.sin(along[2](h))  # noqa: E731
        return -mp.sin(q[2]) * slope(X, mp.mpf(0)) + mp.cos(q[2]) * slope(Y, mp.mpf(0))

    with mp.workdps(90):
        place = [mp.mpf(x) for x in q]
        row = [residual(place, [mp.mpf(int(i == k)) for i in range(3)]) for k in range(3)]
        v = [mp.mpf("0.3"), mp.mpf("-0.2")]
        v.append(-(row[0] * v[0] + row[1] * v[1]) / row[2])
        y = made.state(0.0, q, [float(x) for x in v])
        a = made.accelerations(0.0, y)
        rate = slope(lambda h: residual([x + h * w for x, w in zip(place, v, strict=True)], v), mp.mpf(0))
        rest = rate + sum(mp.mpf(x) * w for x, w in zip(a, row, strict=True))
        size = abs(rate) + sum(abs(mp.mpf(x) * w) for x, w in zip(a, row, strict=True))
    assert abs(float(rest / size)) < 1e-11


def test_which_forms_are_kept() -> None:
    g = Graph()
    x, y = (g.symbol(name, "coordinate") for name in "xy")
    power = g.power(g.sub(x, y), 6)
    assert normalise(g, power, 60) != power
    assert normalise_kept(g, power, 60) == power
    square = g.mul(g.add(x, y), g.add(x, y))
    s, c = g.function("sin", x), g.function("cos", x)
    one = g.add(g.mul(y, g.power(s, 2)), g.mul(g.power(c, 2), y))
    assert keep_digits(g, [one], [y]) == [y]
    assert keep_digits(g, [square, power], [square, normalise(g, power, 60)]) == [square, power]
