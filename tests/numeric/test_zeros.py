"""Long expressions that vanish are told by their factors, and never cut."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.properties.named import is_cut, product_text
from nhc.mechanics.properties.zeros import where_all_zero, where_zero
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System

SPEC = """nhc: 1
system: spot
coordinates: {x: {}, y: {}, z: {range: [1, 2]}}
parameters: {a: 1}
T: (x'^2 + y'^2 + z'^2)/2
U: EXPRESSION
"""
LONG = (
    "(sin(x)^3 + y^2*exp(x*y - a) - cos(y)^2*atan(x + y)*(x^3 - a) + tanh(x - y)*sin(x*y - a) + (x - a*y)^3*(y - x*a)^5"
)
LONG += " - exp(y^2)*x + atan(y^3 - a)*(cos(x)^5 - y) - exp(x - 2*y)*tanh(a*x^3 + y))"


def spot(expression: str) -> System:
    return resolve(decode(Source("spot.yaml", SPEC.replace("EXPRESSION", expression))))


@pytest.mark.parametrize(
    ("expression", "told"),
    [
        ("cos(x)*y", "`y*cos(x) = 0`"),
        (f"x*cos(y)*z*exp(x)*{LONG}", "`x = 0`, `cos(y) = 0` or another factor, a long expression, vanishes"),
        (f"a*{LONG}", "a long expression vanishes"),
    ],
)
def test_short_factors_that_may_vanish_are_told(expression: str, told: str) -> None:
    """Parameters, exponentials and coordinates that are positive in their range are not."""
    system = spot(expression)
    assert where_zero(system, system.U, "`") == told


def test_factors_that_all_have_are_told_first() -> None:
    system = spot(f"sin(x)*{LONG}")
    other = system.graph.mul(system.U, system.graph.function("cos", system.q[1]))
    texts = ["a" * 300, "b" * 300]
    together = "$sin(x) = 0$, or where 2 minors, long expressions, vanish together"
    assert where_all_zero(system, [system.U, other], texts, 6, "$") == together
    assert where_all_zero(system, [system.U, other], ["a", "b"], 6, "$") == "$a = b = 0$"


@pytest.mark.parametrize(
    ("expression", "told"),
    [
        ("a^2*cos(x)*y + a*y^2*cos(x) + a*y*(2 - sin(x)^2)*y + y^2*a*sin(x)^2 - 2*a*y^2", "a*y*cos(x)*(a + y)"),
        ("a^2*cos(x) + y^2*cos(x) + a*y*(2 - sin(x)^2)", "(a + y*cos(x))*(y + a*cos(x))"),
        ("a*(x^2 - y^2)", "a*(x + y)*(x - y)"),
        ("x^2 + y", "y + x^2"),
        (f"a*{LONG}", "…"),
    ],
)
def test_a_determinant_is_a_product_where_it_is_one(expression: str, told: str) -> None:
    system = spot(expression)
    text = product_text(system, system.U, 100)
    assert sorted(text) == sorted(told) if told != "…" else is_cut(text)


def test_cut_texts_are_not_shown() -> None:
    system = spot("cos(x)")
    assert where_all_zero(system, [system.U] * 7, ["cos(…"] * 7, 6, "$").endswith(
        "7 minors, long expressions, vanish together"
    )
