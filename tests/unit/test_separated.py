"""Integrals of constraints whose variables separate: SymPy finds their differentials parallel to the constraint's form."""

from __future__ import annotations

import random

import pytest
import sympy

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.properties.separated import find_separated
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import check

HEAD = (
    "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nparameters: {k: 1.5, r: 2}\nT: (x'^2 + y'^2 + z'^2)/2\n"
    'constraints: [c: "FORM = 0"]\n'
)
NAMES = dict(zip(("x", "y", "z", "t", "k", "r"), sympy.symbols("x y z t k r", positive=True), strict=True))


def find_integral(form: str) -> str:
    """The text of the integral that `check` tells, empty where it tells none."""
    found = [d for d in check(Source("s.yaml", HEAD.replace("FORM", form))).diagnostics if d.code == "W0410"]
    notes = [note for d in found for note in d.notes if note.startswith("its integral is")]
    return notes[0].removeprefix("its integral is `").removesuffix(" = const`") if notes else ""


@pytest.mark.parametrize(
    ("form", "entries"),
    [
        ("dx - 2*t*x*dt", {"x": "1", "t": "-2*t*x"}),
        ("dz - x*exp(-2*z)*dx", {"z": "1", "x": "-x*exp(-2*z)"}),
        ("(1 + y^2)*dx - (1 + x^2)*dy", {"x": "1 + y**2", "y": "-1 - x**2"}),
        ("(1 + 2*y^2)*dx - (4 - x^2)*dy", {"x": "1 + 2*y**2", "y": "x**2 - 4"}),
        ("y*z*dx + x*z*dy + x*y*dz", {"x": "y*z", "y": "x*z", "z": "x*y"}),
        ("y*z^2*dx + x*z^2*dy + k*x*y*dz", {"x": "y*z**2", "y": "x*z**2", "z": "k*x*y"}),
        ("dx - exp(x + y)*dy", {"x": "1", "y": "-exp(x + y)"}),
        ("dx - (x + x*y^2)*dy", {"x": "1", "y": "-(x + x*y**2)"}),
        ("dx - (x*y + x + y + 1)*dy", {"x": "1", "y": "-(x*y + x + y + 1)"}),
        ("dy - k*y/x*dx", {"y": "1", "x": "-k*y/x"}),
        ("sin(x)*dy - k*dx", {"y": "sin(x)", "x": "-k"}),
        ("cos(r*x)*dy - k*y^2*dx", {"y": "cos(r*x)", "x": "-k*y**2"}),
        ("dx - cos(x)^2*sin(y)^2*dy", {"x": "1", "y": "-cos(x)**2*sin(y)**2"}),
        ("sqrt(1 + 2*y^2)*dx - x*dy", {"x": "sqrt(1 + 2*y**2)", "y": "-x"}),
        ("sqrt(3 - y - 2*y^2)*dx - dy", {"x": "sqrt(3 - y - 2*y**2)", "y": "-1"}),
        ("dy - k*sqrt(y)*dx", {"y": "1", "x": "-k*sqrt(y)"}),
    ],
)
def test_separated_forms_have_their_integral(form: str, entries: dict[str, str]) -> None:
    text = find_integral(form)
    assert text
    integral = sympy.sympify(text.replace("^", "**"), {**NAMES, "abs": sympy.Abs})
    rng, variables = random.Random(form), [*entries]
    for _ in range(3):
        point = {symbol: sympy.Float(rng.uniform(0.2, 0.9), 30) for symbol in NAMES.values()}
        slopes = [complex(sympy.diff(integral, NAMES[x]).subs(point).evalf(30)) for x in variables]
        rates = [complex(sympy.sympify(entries[x], NAMES).subs(point).evalf(30)) for x in variables]
        assert max(map(abs, slopes)) > 1e-6
        for i, x in enumerate(variables):
            for j in range(i):
                assert abs(slopes[i] * rates[j] - slopes[j] * rates[i]) < 1e-12 * abs(slopes[i] * rates[j]) + 1e-14, x


@pytest.mark.parametrize("form", ["dx - (x + y)*dy", "dx - sin(x*y)*dy", "z*dx - y*dy + x*dz"])
def test_what_does_not_separate_is_left_out(form: str) -> None:
    assert find_separated(resolve(decode(Source("s.yaml", HEAD.replace("FORM", form))))) == []
