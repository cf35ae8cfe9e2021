"""Antiderivatives of a constraint's terms, held to their own derivatives; kinks of the energies, each by its name."""

from __future__ import annotations

import pytest

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.properties.primitives import find_primitives
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import check

TERMS = [
    *(
        "x^3",
        "1/x^2",
        "1/x",
        "y*x",
        "k*y^2/x",
        "x^2*cos(y)",
        "sin(x)",
        "cos(2*x + y)",
        "k*sin(k*x - 3*y)",
        "y*cos(x/2)",
    ),
    *("sinh(x)", "cosh(3*x)", "exp(-k*x)", "y^2*exp(x + y)", "sinh(y - x)", "k", "log(y)"),
    *(
        "1/(1 + x)",
        "y/(k + 2*x)^3",
        "tan(k*x)",
        "x/(1 + x^2)",
        "x*exp(x^2)",
        "log(x)/x",
        "sin(x)*cos(x)",
        "sin(x)^2*cos(x)",
    ),
    *("x*sqrt(y + x^2)", "x/sqrt(1 - x^2)", "1/(1 + x^2)", "y/(x^2 + 2*x + 5)", "exp(x)/(1 + exp(x))", "tanh(x)"),
]
SUMS = ["x*sin(x)", "x^2*exp(2*x)", "x^3*cosh(x)", "sin(x)^2", "y*cos(2*x)^4", "sin(x)^3*cos(x)^3", "x*cos(2*x - y)"]


@pytest.mark.parametrize("term", TERMS)
def test_the_derivative_of_an_antiderivative(term: str) -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nparameters: {k: 1.7}\nT: (x'^2 + y'^2 + z'^2)/2\n"
    system = resolve(decode(Source("s.yaml", f'{text}constraints: [c: "({term})*dx + dz = 0"]\n')))
    g, x = system.graph, system.q[0]
    (form,) = system.constraints
    slopes = [slope for node in find_primitives(system) if not is_zero(g, slope := derivative(g, node, x))]
    ratios = [g.div(slope, form.coefficients[0]) for slope in slopes]
    assert any(all(are_zero(g, gradient(g, ratio, (*system.q, *system.p)))) for ratio in ratios)  # a number


@pytest.mark.parametrize("term", [*TERMS, *SUMS])
def test_a_closed_form_has_its_integral(term: str) -> None:
    if "y" in term or "k" in term:
        term = term.replace("y", "1").replace("k", "3")
    text = f"nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nconstraints: [c: \"({term})*dx + dz = 0\"]\n"
    (found,) = [d for d in check(Source("s.yaml", text)).diagnostics if d.code == "W0410"]
    assert found.notes[0].startswith("its integral is")


@pytest.mark.parametrize("term", ["exp(x^2)", "sin(x)/x", "1/(1 + x^3)", "sqrt(1 + x^3)", "1/log(x)"])
def test_what_is_not_elementary_at_once_is_left_out(term: str) -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\n"
    system = resolve(decode(Source("s.yaml", f'{text}constraints: [c: "({term})*dx + dy = 0"]\n')))
    assert find_primitives(system) == [system.q[1]]


@pytest.mark.parametrize("key", ["T", "V", "U"])
@pytest.mark.parametrize(("function", "argument"), [("abs", "x"), ("min", "x, y"), ("max", "x, 0")])
def test_a_kink_is_told_with_its_function(key: str, function: str, argument: str) -> None:
    kink = f"{function}({argument})"
    energies = f"T: (x'^2 + y'^2)*(3 + {kink})/2\n" if key == "T" else f"T: (x'^2 + y'^2)/2\n{key}: {kink}\n"
    found = check(Source("s.yaml", f"nhc: 1\nsystem: s\ncoordinates: [x, y]\n{energies}")).diagnostics
    said = [d.message for d in found if d.code == "W0416"]
    assert said == [f"`{key}` contains `{function}`: its derivative does not exist at every point"]


@pytest.mark.parametrize(
    ("energy", "smooth"),
    [
        ("max(x, 0)^2", True),
        ("max(x, 0)^(3/2)", True),
        ("abs(x)^3", True),
        ("x*abs(x)", True),
        ("max(sqrt(x^2 + y^2) - 1, 0)^2", True),
        ("max(x, 0)^2 + abs(y)", False),
        ("max(x, 0)*y", False),
        ("sqrt(abs(x))", False),
        ("min(x^2, 1)", False),
    ],
)
def test_it_is_said_whether_the_derivative_exists(energy: str, smooth: bool) -> None:
    """Ropes that only pull, and contacts: the force has a kink, the energy has none."""
    said = "its derivative exists everywhere, higher ones need not" if smooth else "does not exist at every point"
    for text in (f"T: (x'^2 + y'^2)/2\nV: {energy}\n", f"T: (x'^2 + y'^2)*(4 + {energy})/2\n"):
        found = check(Source("s.yaml", f"nhc: 1\nsystem: s\ncoordinates: [x, y]\n{text}")).diagnostics
        (warning,) = [d.message for d in found if d.code == "W0416"]
        assert warning.endswith(said), text
