"""Velocities that nhc added are said where a user meets them, and are what is said."""

from __future__ import annotations

import json
import math
import random
import re

import pytest

from nhc.cli import main
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import python_model, spec_path


@pytest.mark.parametrize("name", ["cartesian_pendulum", "roller_racer", "skate_incline", "snakeboard"])
def test_a_velocity_that_nhc_added_is_what_its_header_says(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    text, draw = spec_path(name).read_text(), random.Random(name)
    formulation = "euler-lagrange"
    (source,) = emit(Source("spec.yaml", text), "python", Options(formulation=formulation)).values()
    model = python_model(source, f"added_{name}")
    assert model.__doc__ is not None
    header = " ".join(model.__doc__.split())
    place = model.STATE.index("v")
    found = re.search(rf"y\[{place}\] = v(?: \[[^]]*\])?: (.*?) (?:y\[|Parameters p:)", header)
    assert found is not None, header
    q, qdot = ([draw.uniform(-1, 1) for _ in model.COORDINATES] for _ in range(2))
    y = model.state(0.3, q, qdot)
    values = dict(zip(model.PARAMETERS, model.DEFAULTS, strict=True)) | dict(zip(model.COORDINATES, q, strict=True))
    values |= {"sin": math.sin, "cos": math.cos, "v": y[place]}
    said = found[1].replace("^", "**")
    if "' = " in said:  # what it makes of the coordinates' velocities, on the constraints
        moved = dict(zip(model.COORDINATES, model.velocities(0.3, y), strict=True))
        told = dict(part.split("' = ") for part in said.split(", "))
        assert len(told) > 2
        for x, value in told.items():
            assert moved[x] == pytest.approx(eval(value, {}, values))
    else:
        values |= {f"{x}_rate": v for x, v in zip(model.COORDINATES, qdot, strict=True)}
        assert y[place] == pytest.approx(eval(re.sub(r"(\w)'", r"\1_rate", said), {}, values))
    if name != "snakeboard":  # its own choice
        assert main(["check", name, "--json", "--explain"]) == 0
        said_there = json.loads(capsys.readouterr().out)["specs"][0]["data"]["formulation"]["added"]
        assert said_there == {"v": found[1]}


CAR = """nhc: 1
system: car
coordinates: {x: {unit: XY}, y: {unit: XY}, th: {unit: rad}, d: {unit: rad}, e: {unit: rad}}
parameters: {m: {value: 3, unit: kg}, I: {value: 0.7, unit: kg*XY^2}, a: {value: 0.5, unit: XY}, b: {value: 0.6, unit: XY}}
T: m/2*(x'^2 + y'^2) + I/2*(th'^2 + d'^2 + e'^2)
constraints:
  - -sin(th + d)*x' + cos(th + d)*y' + a*cos(d)*th' = 0
  - -sin(th + e)*x' + cos(th + e)*y' - b*cos(e)*th' = 0
"""
EDGE = "constraints:\n  - -sin(th)*x' + cos(th)*y' = 0\n  - d' = 0\n"


@pytest.mark.parametrize(
    ("length", "heading", "rest", "unit"),
    [
        ("m", "unit: rad", "", " [1/s]"),
        ("km", "unit: rad", "", " [1/s]"),
        ("m", "unit: rad", EDGE, " [m/s]"),
        ("km", "unit: rad", EDGE, " [km/s]"),
        ("m", "about: heading", "", ""),  # nobody knows th'
    ],
)
def test_a_velocity_that_nhc_added_has_its_unit(length: str, heading: str, rest: str, unit: str) -> None:
    text = CAR.replace("XY", length).replace("th: {unit: rad}", f"th: {{{heading}}}")
    text = text.partition("constraints:")[0] + rest if rest else text
    (source,) = emit(Source("car.yaml", text), "python", Options(formulation="euler-lagrange")).values()
    assert f"= v{unit}: " in source
    bare = re.sub(r"unit: [^,}]+", "about: none", text)
    (source,) = emit(Source("bare.yaml", bare), "python", Options(formulation="euler-lagrange")).values()
    assert "= v: " in source


METRES = CAR.replace("XY", "m")
PARALLEL = METRES.replace("b*cos(e)", "a*cos(e)")
HINGED = (
    METRES.partition("constraints:")[0]
    + """constraints:
  - -sin(th)*x' + cos(th)*y' = 0
  - -sin(th + d)*x' + cos(th + d)*y' + (a + b*cos(e))*cos(d)*th' = 0
"""
)


@pytest.mark.parametrize("text", [PARALLEL, HINGED], ids=["parallel", "hinged"])
def test_what_is_said_of_a_velocity_adds_nothing_unlike(text: str) -> None:
    """Lengths and rates of turn are not added, so that the form may be given to the spec: it is the same there."""
    made = []
    for source in (text, None):
        if source is None:
            header = " ".join(made[0].__doc__.split())
            found = re.search(r"= v \[1/s\]: (.*?) (?:y\[|Parameters p:)", header)
            assert found is not None and "..." not in found[1], header
            source = f'{text}quasi_velocities: {{v: "{found[1]}"}}\n'
        (python,) = emit(Source("axles.yaml", source), "python", Options(formulation="euler-lagrange")).values()
        made.append(python_model(python, f"unlike_{len(made)}"))
    assert [model.STATE for model in made] == [made[0].STATE] * 2
    y = [0.3, 0.2, 0.4, 0.7, -0.5, 0.9, 1.1, -0.6]
    assert made[0].rhs(0.0, y) == pytest.approx(made[1].rhs(0.0, y), rel=1e-12)
