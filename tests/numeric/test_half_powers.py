"""Powers such as x^(5/2) where x is 0: a Hertzian contact that does not touch has forces and slopes that are 0, not 0/0."""

from __future__ import annotations

import ctypes
import math
from fractions import Fraction
from pathlib import Path

import pytest

from nhc.algebra.calculus import derivative
from nhc.algebra.graph import Graph
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import CModel, compile_c, error, python_model

K, L = 200.0, 30.0
SPEC = Source(
    "contact.yaml",
    """
nhc: 1
system: contact
coordinates: [x, z]
parameters: {k: 200, l: 30}
define:
  depth: max(0, -z)
T: (x'^2 + z'^2)/2
V: 9*z + k*depth^(5/2) + l*depth^(3/2)*depth + x^2/2
forces: {x: -abs(x')*sqrt(abs(x'))*sign(x')}
outputs: {lost: "(2*depth)^(3/2)/sqrt(depth + 1)"}
""",
)


def rate(z: float) -> float:
    """z'' by hand: minus the slope of 9 z + (k + l) depth^(5/2)."""
    return -9 + 2.5 * (K + L) * max(0.0, -z) ** 1.5


def slope(z: float) -> float:
    return -3.75 * (K + L) * math.sqrt(max(0.0, -z))


STATES = [[0.3, 1.0, 0.2, -0.1], [0.3, 0.0, 0.0, 0.0], [-0.3, -0.25, -0.2, 0.0], [0.0, 2.0, 0.0, 1.0]]


@pytest.mark.parametrize("array", ["", "numpy"])
def test_a_contact_that_does_not_touch_has_no_force(array: str) -> None:
    (text,) = emit(SPEC, "python", Options(array=array)).values()
    model = python_model(text, "contact")
    for y in STATES:
        assert error(model.rhs(0.0, y), [y[2], y[3], drag(y), rate(y[1])]) < 1e-13
        assert error([float(row) for row in model.jacobian(0.0, y)[3]], [0, slope(y[1]), 0, 0]) < 1e-13
        assert error([float(row) for row in model.jacobian(0.0, y)[2]], [-1, 0, drag_slope(y), 0]) < 1e-13


def drag(y: list[float]) -> float:
    return -y[0] - math.copysign(abs(y[2]) ** 1.5, y[2])


def drag_slope(y: list[float]) -> float:
    return -1.5 * math.sqrt(abs(y[2]))


def test_half_powers_have_values_and_slopes_in_c(tmp_path: Path) -> None:
    path = compile_c(emit(SPEC, "c", Options()), tmp_path, "contact")
    model = CModel("contact", ctypes.CDLL(str(path)), {})
    for y in STATES:
        assert error(model("rhs", 4, 0.0, y, [K, L]), [y[2], y[3], drag(y), rate(y[1])]) < 1e-13
        found = model("jacobian", 16, 0.0, y, [K, L])
        assert error(found[8:], [-1, 0, drag_slope(y), 0, 0, slope(y[1]), 0, 0]) < 1e-13


def test_roots_of_what_is_cut_off_at_zero_have_no_slope_there() -> None:
    """sqrt(max(0, u)) and powers below 1 of it are constant where u < 0."""
    source = Source(
        "cut.yaml",
        """
nhc: 1
system: cut
coordinates: [x, z]
parameters: {n: 0.7}
T: (x'^2 + z'^2)/2
forces: {x: "-sqrt(max(0, x))*x'", z: "-max(-z, 0)^n - max(0, z)^(3/4)"}
""",
    )
    (text,) = emit(source, "python", Options()).values()
    model = python_model(text, "cut")
    for x, z in ((0.4, 0.3), (-0.4, -0.3), (-2.0, 0.1)):
        rows = model.jacobian(0.0, [x, z, 0.5, 0.1])
        root = math.sqrt(max(0.0, x))
        by_x = -0.5 / (2 * root) if x > 0 else 0.0
        by_z = -0.75 * z**-0.25 if z > 0 else 0.7 * (-z) ** -0.3
        assert error([*rows[2], *rows[3]], [by_x, 0, -root, 0, 0, by_z, 0, 0]) < 1e-14


@pytest.mark.parametrize("scale", [1, 3, Fraction(1, 2)])
@pytest.mark.parametrize(("m", "n"), [(1, -1), (2, -1), (3, -5), (-1, 3), (-2, 1)])
def test_powers_of_a_number_and_of_its_root_become_one(m: int, n: int, scale: Fraction) -> None:
    """x^m sqrt(k x)^n, also behind another factor, is one power of the root, with the same value."""
    g = Graph()
    x, y = g.symbol("x", "parameter"), g.symbol("y", "parameter")
    root = g.function("sqrt", g.mul_number(scale, x))
    product = g.mul(g.power(x, m), g.power(root, n))
    behind = g.mul(g.mul(g.power(root, n), y), g.power(x, m))
    assert behind == g.mul(y, product)
    exact = g.mul_number(Fraction(scale) ** -m, g.power(root, 2 * m + n))
    assert product == exact


def test_the_slope_of_a_half_power_is_one() -> None:
    g = Graph()
    x = g.symbol("x", "coordinate")
    root = g.function("sqrt", x)
    assert derivative(g, g.power(root, 3), x) == g.mul_number(Fraction(3, 2), root)
    both = derivative(g, g.add(g.power(root, 3), g.power(root, 5)), x)
    assert both == g.add(g.mul_number(Fraction(3, 2), root), g.mul_number(Fraction(5, 2), g.power(root, 3)))
