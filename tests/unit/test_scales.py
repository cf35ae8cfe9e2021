"""Units of one dimension and of different scales: told where nothing converts them."""

from __future__ import annotations

import math

import pytest
import sympy.physics.units
from sympy.physics.units.prefixes import PREFIXES

from nhc.diagnostics import Source
from nhc.language.units.dimensions import factor, parse_scale
from nhc.pipeline import check

SPEC = """nhc: 1
system: s
coordinates: {x: {unit: LENGTH}, th: {unit: ANGLE}}
parameters: {m: {value: 1, unit: MASS}, k: {value: 2, unit: STIFF}, w: {value: 2, unit: RATE}, I: {unit: INERTIA, value: 3}}
T: m/2*x'^2 + I/2*th'^2
V: k/2*x^2*WAVE
"""
KEYS = ("LENGTH", "ANGLE", "MASS", "STIFF", "RATE", "INERTIA", "WAVE")


def told(units: str, wave: str) -> list[tuple[str, str]]:
    text = SPEC
    for key, word in zip(KEYS, (*units.split(), wave), strict=True):
        text = text.replace(key, word)
    found = check(Source("spec.yaml", text), explain=False).diagnostics
    assert all(one.code == "W0430" for one in found)
    return [(one.message, one.help[0]) for one in found]


@pytest.mark.parametrize(
    ("units", "wave"),
    [
        ("m rad kg N/m 1/s kg*m^2", "sin(w*t)"),
        ("mm rad kg mN/mm 1/s kg*mm^2", "sin(w*t)"),
        ("m rad t kN/m Hz t*m^2", "sin(w*t)"),
        ("cm rad g g/s^2 1/s g*cm^2", "sin(w*t)"),
        ("dm rad kg N/m 1/s kg*L/dm", "sin(w*t)"),
        ("km rad kg N/m 1/s kg*km^2", "cos(th)"),
        ("m rad kg kN/m 1/s kg*m^2", "(1000*sin(w*t))"),
        ("m deg kg N/m 1/s kg*m^2", "sin(th*pi/180)"),
        ("m deg kg N/m 1/s kg*m^2", "sin(2*pi*th/360)"),
        ("m deg kg N/m 1/s kg*m^2", "sin(th/57.29578)"),
        ("m rad kg N/m 1/h kg*m^2", "sin(w*t/60/60)"),
        ("m deg kg N/m 1/s kg*m^2", "cos((th + 5)*pi/180)"),
    ],
)
def test_units_that_go_together_or_are_converted(units: str, wave: str) -> None:
    assert told(units, wave) == []


@pytest.mark.parametrize("value", ["pi/180", "0.0174533", "{value: pi/180, unit: 1}"])
def test_a_parameter_may_convert(value: str) -> None:
    text = SPEC.replace("{m: {", f"{{deg: {value}, m: {{")
    for key, word in zip(KEYS, ("m", "deg", "kg", "N/m", "1/s", "kg*m^2", "sin(th*deg)"), strict=True):
        text = text.replace(key, word)
    assert check(Source("spec.yaml", text), explain=False).diagnostics == ()


@pytest.mark.parametrize(
    ("units", "wave", "message", "help"),
    [
        (
            "m deg kg N/m 1/s kg*m^2",
            "sin(th)",
            "`th` is in degrees, and functions of angles take radians",
            "times pi/180",
        ),
        ("m rad kg N/m 1/min kg*m^2", "sin(w*t)", "`w` is in 1/min, and time is in seconds", "values times 0.0166667"),
        ("m rad kg kN/m 1/s kg*m^2", "sin(w*t)", "`k` is in kN/m, 1000 times what the other units make", "times 1000"),
        (
            "mm rad g mN/m 1/s kg*mm^2",
            "(60*th)",
            "`I` is in kg*mm^2, 1000 times what the other units make",
            "times 1000",
        ),
        ("m rad kg eV/m^2 1/s kg*m^2", "1", "`k` is in eV/m^2, 1.60218e-19 times what the other units make", "values"),
        ("m rad kg bar*m 1/s kg*m^2", "1", "`k` is in bar*m, 100000 times what the other units make", "times 100000"),
    ],
)
def test_units_of_other_scales_are_told(units: str, wave: str, message: str, help: str) -> None:
    ((said, advice),) = told(units, wave)
    assert said == message
    assert help in advice


BASE = "nhc: 1\nsystem: s\ncoordinates: {x: {unit: m}, a: {unit: rad}}\nT: m/2*x'^2 + J/2*a'^2\n"
FORCE = "k: {value: 3, unit: N}"
MASSES = "m: {value: 1, unit: kg}, J: {value: 1, unit: kg*m^2}"


@pytest.mark.parametrize(
    ("parameters", "rest", "told"),
    [
        # a number converts what it multiplies, and nothing else; outputs convert nothing
        ("k: {value: 3, unit: N/mm}", "V: k/2*x^2\noutputs: {mm: 1000*x}", ["k"]),
        ("k: {value: 3, unit: N/mm}", "V: 1000*k/2*x^2", []),
        ("k: {value: 3, unit: kN/m}, l: {value: 200, unit: mm}", "V: 1000*k/2*(x - l*sin(a))^2", ["l"]),
        ("k: {value: 3, unit: N/m}, l: {value: 200, unit: mm}", "V: k/2*(1000*x - l*sin(a))^2", []),
        (f"{FORCE}, b: {{value: 3, unit: deg}}, c: {{value: 4, unit: deg}}", "define: {B: b*pi/180}\nV: k*x*sin(B)*cos(c)", ["c"]),
        ("k: {value: 3, unit: N}, b: {value: 3, unit: deg}", "define: {B: b + 5, C: B*pi/180}\nV: k*x*sin(C)", []),
        ("k: {value: 1, unit: N/mm}, c: {value: 1000, unit: mm/m}", "V: c*k/2*x^2", []),
        ("v: {value: 50, unit: km/h}", "scenes: {s: {initial: {x': v/3.6}, time: [0, 1]}}", []),
        ("v: {value: 50, unit: km/h}", "scenes: {s: {initial: {x': v}, time: [0, 1]}}", ["v"]),
        (
            f"{FORCE}, w: {{value: 5, unit: 1/min}}, b: {{value: 1, unit: deg/s}}, l: {{unit: mm}}, L: {{unit: mm}}",
            "V: k*cos(w*t)*cos(b*t)*(l + L)",
            ["w", "b", "l"],
        ),
        ("p: {value: 2, unit: bar}, A: {value: 3, unit: cm^2}", "forces: {x: p*A}", ["p", "A"]),
    ],
)  # fmt: skip
def test_each_unit_is_told_unless_its_own_numbers_convert_it(parameters: str, rest: str, told: list[str]) -> None:
    text = f"{BASE}parameters: {{{MASSES}, {parameters}}}\n{rest}\n"
    found = check(Source("spec.yaml", text), explain=False).diagnostics
    scales = [one.message for one in found if one.code == "W0430"]
    assert [message.split("`")[1] for message in scales] == told
    if "deg/s" in parameters:
        assert "`b` is in deg/s, and functions of angles take radians" in scales


def test_scales_are_those_of_the_international_system() -> None:
    """Each prefix, and each unit that is no product of base units, by SymPy's tables."""
    units = {
        "g": "gram",
        "min": "minute",
        "h": "hour",
        "eV": "electronvolt",
        "bar": "bar",
        "L": "liter",
    }
    base = [sympy.physics.units.kilogram, sympy.physics.units.meter, sympy.physics.units.second]
    for name, word in units.items():
        there = sympy.physics.units.convert_to(getattr(sympy.physics.units, word), base)
        there = there.subs({unit: 1 for unit in base}).evalf()
        assert factor(parse_scale(name)) == pytest.approx(float(there), rel=1e-5), name
    for name, prefix in PREFIXES.items():
        assert factor(parse_scale(f"{name.replace('mu', 'u')}m")) == pytest.approx(float(prefix.scale_factor)), name
    assert factor(parse_scale("deg")) == pytest.approx(math.pi / 180)
    assert factor(parse_scale("km/h")) == pytest.approx(1 / 3.6)
    assert factor(parse_scale("(mm*t)^2/min")) == pytest.approx(1 / 60)
