"""Units of velocities, quasi-velocities, outputs, the energy and the reactions, where the spec gives units."""

from __future__ import annotations

import re

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode, read
from nhc.language.expressions.names import FUNCTIONS
from nhc.language.units.derived import derive_units
from nhc.language.units.dimensions import parse_unit
from nhc.pipeline import emit
from tests.support import GALLERY, spec_path

SLEIGH = """nhc: 1
system: sleigh
coordinates: {x: {unit: LENGTH}, y: {unit: LENGTH}, theta: {unit: rad}}
parameters:
  m: {value: 1, unit: MASS}
  I: {value: 1, unit: MASS*LENGTH^2}
  a: {value: 1, unit: LENGTH}
define: {spin: v/a}
T: m/2*(x'^2 + y'^2) + I/2*theta'^2
constraints:
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
quasi_velocities: {v: cos(theta)*x' + sin(theta)*y', w: theta' + sin(theta)*theta'}
outputs:
  heading: atan2(y', x')
  slope: y'/x'
  turns: theta - 2*theta
  both: w + spin
  lost: a*w
  work: T - U
  torque: I*(v/a)^2
  root: sqrt(a*v*1)
  nothing: 0
"""


def units(text: str) -> dict[str, str]:
    return derive_units(decode(Source("s.yaml", text)))


def test_units_follow_from_the_declared_ones() -> None:
    found = units(SLEIGH.replace("LENGTH", "m").replace("MASS", "kg"))
    assert found == {
        **{"x": "m", "y": "m", "theta": "rad", "x'": "m/s", "y'": "m/s", "theta'": "rad/s", "v": "m/s", "w": "rad/s"},
        **{"energy": "J", "lambda_slip": "N", "heading": "rad", "slope": "1", "turns": "rad", "both": "rad/s"},
        **{"lost": "m/s", "work": "J", "torque": "kg*m^2/s^2", "root": "m/s^(1/2)"},
    }


def test_base_units_keep_the_spelling_of_the_spec() -> None:
    found = units(SLEIGH.replace("LENGTH", "cm").replace("MASS", "g"))
    assert (found["v"], found["lambda_slip"], found["energy"]) == ("cm/s", "g*cm/s^2", "g*cm^2/s^2")


@pytest.mark.parametrize(("length", "mass"), [("mm", "J*s^2/m^2"), ("m", "kN*s^2/m"), ("m", "kg*h/s")])
def test_mixed_scales_give_no_unit(length: str, mass: str) -> None:
    """1 mm times 1 J s^2/m^2 over 1 s is no millimetre kilogram per second: a factor is missing."""
    text = SLEIGH.replace("unit: LENGTH}, y: {unit: LENGTH}", f"unit: {length}}}, y: {{unit: {length}}}")
    found = units(text.replace("LENGTH", "m").replace("MASS", mass))
    assert (found["x'"], found["theta'"]) == (f"{length}/s", "rad/s")
    assert not {"v", "w", "energy", "lambda_slip", "lost"} & found.keys()


def test_without_units_there_are_none() -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x]\nparameters: {m: 1}\nT: m*x'^2/2\noutputs: {f: m*x', g: sin(t)}\n"
    assert units(text) == {}
    some = units(text.replace("[x]", "{x: {unit: m}}"))  # m, the mass, has none
    assert some == {"x": "m", "x'": "m/s", "g": "1"}
    turned = "nhc: 1\nsystem: s\nrotation: {R: {velocities: [w1, w2, w3]}}\nparameters: {I: 1}\nT: I*(w1^2 + w2^2 + w3^2)/2\n"
    assert units(turned) == {} and decode(Source("s.yaml", turned)).time_unit == ""


@pytest.mark.parametrize(
    ("row", "unit"),
    [
        ("constraints: [c: x*x' + y*y' = 0]", "kg/s^2"),
        ("constraints: [c: x*dx + y*dy = 0]", "kg/s^2"),
        ("constraints: [c: theta' = 0]", "N*m"),
        ("constraints: [c: dy - a*dtheta = 0]", "N"),
        ("holonomic: [c: x^2 + y^2 = a^2]", "kg/s^2"),
        ("holonomic: [c: theta - 1 = 0]", "N*m"),
    ],
)
def test_a_reaction_makes_a_force_of_its_row(row: str, unit: str) -> None:
    """Q_i gains lambda a_i: [lambda] = [Q_i]/[a_i] = [T]/([q_i] [a_i]), by hand."""
    head, rest = SLEIGH.replace("LENGTH", "m").replace("MASS", "kg").split("constraints:")
    outputs = rest[rest.index("outputs:") :].replace("  both: w + spin\n", "").replace("  lost: a*w\n", "")
    text = (
        head.replace("define: {spin: v/a}\n", "") + row + "\n" + outputs.replace("I*(v/a)^2", "0").replace("a*v*1", "a")
    )
    assert units(text)["lambda_c"] == unit


UNITS_OF_FUNCTIONS = {  # of x and y in metres, theta in radians, a in metres
    **{f"{name}(theta)": "1" for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log")},
    **{f"{name}(x/a)": "1" for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log")},
    **{f"{name}(x/a)": "rad" for name in ("asin", "acos", "atan")},
    **{"atan2(y, x)": "rad", "abs(x)": "m", "min(x, y)": "m", "max(x, y)": "m", "sqrt(x*y)": "m"},
    **{"abs(theta)": "rad", "min(theta, 2)": "rad", "max(0, theta)": "rad", "max(0, x)": "m", "min(x, 0)": "m"},
    **{"sign(x)": "1", "sign(theta)": "1", "abs(x')": "m/s", "max(x', y')": "m/s", "sqrt(x'^2 + y'^2)": "m/s"},
}


def test_each_function_has_its_unit() -> None:
    assert {text.partition("(")[0] for text in UNITS_OF_FUNCTIONS} == set(FUNCTIONS)
    head = SLEIGH.replace("LENGTH", "m").replace("MASS", "kg").partition("outputs:")[0]
    lines = [f"  o{k}: {text}" for k, text in enumerate(UNITS_OF_FUNCTIONS)]
    found = units("\n".join([f"{head}outputs:", *lines, ""]))
    assert [found.get(f"o{k}") for k in range(len(lines))] == list(UNITS_OF_FUNCTIONS.values())


@pytest.mark.parametrize(
    "text",
    [
        *(f"{name}(x)" for name in FUNCTIONS if FUNCTIONS[name][1] == 1 and name not in ("abs", "sqrt", "sign")),
        *(f"{name}(x, x')" for name in ("atan2", "min", "max")),
        *(f"{name}(x) + x'" for name in ("abs", "sqrt", "sign")),
        *(f"{name}(x, y) + x'" for name in ("atan2", "min", "max")),
    ],
)
def test_each_function_asks_for_units_that_fit(text: str) -> None:
    head = SLEIGH.replace("LENGTH", "m").replace("MASS", "kg").partition("outputs:")[0]
    with pytest.raises(SpecError) as caught:
        decode(Source("s.yaml", f"{head}outputs: {{o: '{text.replace(chr(39), 2 * chr(39))}'}}\n"))
    assert [d.code for d in caught.value.diagnostics] == ["E0413"]


@pytest.mark.parametrize("name", GALLERY)
def test_units_of_the_gallery_are_units(name: str) -> None:
    for unit in derive_units(decode(read(str(spec_path(name))))).values():
        parse_unit(unit)


@pytest.mark.parametrize("language", ["c", "python"])
def test_emitted_files_show_them_for_reactions_and_the_energy(language: str) -> None:
    text = SLEIGH.replace("LENGTH", "m").replace("MASS", "kg")
    header = next(iter(emit(Source("s.yaml", text), language).values()))
    assert re.search(r"Constraints, with the units of their reactions:\n[ *]*0: slip \[N\]\n", header)
    assert re.search(r"(?i)energy T \+ V \[J\]\.?\n", header)
    bare = re.sub(r"(, )?unit: [^,}]*", "", text).replace("{, ", "{")
    plain = next(iter(emit(Source("s.yaml", bare), language).values()))
    assert re.search(r"Constraints:\n[ *]*0: slip\n", plain)
    assert re.search(r"(?i)energy T \+ V\.?\n", plain)


MISTAKEN = """nhc: 1
system: bad
coordinates: {x: {unit: m}, th: {unit: rad}}
parameters: {m: {value: 1, unit: kg}, k: {value: 2, unit: N/m}, I: {value: 1, unit: kg*m^2}}
T: m/2*x'^2 + I/2*th'
V: k*x^2 + m*x
forces: {th: x''}
outputs: {way: x + th}
scenes:
  a: {initial: {x: 1, q: 3}, time: [0, 1], need: [foo]}
"""


def told(text: str) -> list[tuple[str, int]]:
    source = Source("bad.yaml", text)
    with pytest.raises(SpecError) as error:
        decode(source)
    return [(d.code, text[: d.span.start].count("\n") + 1) for d in error.value.diagnostics]


def test_units_are_told_together_with_other_mistakes() -> None:
    units = [("E0413", 5), ("E0413", 6), ("E0413", 8)]
    assert told(MISTAKEN) == [*units[:2], ("E0207", 7), units[2], ("E0419", 10), ("E0419", 10)]
    sound = MISTAKEN.replace("x''", "0").replace(", q: 3", "").replace("foo", "x")
    assert told(sound) == units


@pytest.mark.parametrize(
    ("right", "wrong", "found"),
    [
        ("I/2*th'", "I/2*th'^2 + q", [("E0302", 5), ("E0413", 8)]),  # what T is made of is not known: V may be anything
        ("unit: kg*m^2", "unit: kgg*m^2", [("E0316", 4)]),  # nor are the units of what is declared
        ("parameters:", "params:", [("E0303", 4)]),
    ],
)
def test_units_of_what_is_not_sound_are_not_told(right: str, wrong: str, found: list[tuple[str, int]]) -> None:
    text = MISTAKEN.replace("k*x^2 + m*x", "k*x^2").replace("x''", "0").replace(", q: 3", "").replace("foo", "x")
    assert told(text.replace(right, wrong)) == found
