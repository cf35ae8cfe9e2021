"""Velocities along the row of minors: two axles that steer, on a floor at rest, on a belt and on a turntable."""

from __future__ import annotations

import ctypes
import math
import random
from pathlib import Path
from types import ModuleType

import pytest

from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.system import Form
from nhc.pipeline import Options, emit, model, program
from tests.support import CModel, compile_c, python_model

AXLES = """nhc: 1
system: axles
coordinates: [x, y, th, d, e]
parameters: {m: 3, I: 0.7, J: 0.1, a: 0.5, b: 0.6, W: 0.4, k: 2}
T: m/2*(x'^2 + y'^2) + I/2*(th' + 0.1*d')^2 + J/2*(d'^2 + e'^2)
V: x*y + th^2/3
constraints:
  - front: FACTOR(-sin(th + d)*(x' - FIRST) + cos(th + d)*(y' - SECOND) + a*cos(d)*(th' - THIRD)) = 0
  - rear: -sin(th + e)*(x' - FIRST) + cos(th + e)*(y' - SECOND) - b*cos(e)*(th' - THIRD) = 0
"""
FLOORS = {"rest": ("0", "0", "0"), "belt": ("W*exp(-t)", "0", "0"), "table": ("-W*y", "W*x", "W")}


def axles(floor: str, factor: str = "") -> Source:
    text = AXLES.replace("FACTOR", f"{factor}*" if factor else "")
    for word, value in zip(("FIRST", "SECOND", "THIRD"), FLOORS[floor], strict=True):
        text = text.replace(word, value)
    return Source("axles.yaml", text)


def added(source: Source) -> Form:
    found = model(source)
    assert found.formulation.frame is not None
    return found.formulation.frame.forms[found.system.l]


def as_python(source: Source, formulation: str) -> ModuleType:
    (text,) = emit(source, "python", Options(formulation=formulation)).values()
    return python_model(text, f"axles_{formulation}_{abs(hash(source.text))}")


@pytest.mark.parametrize("floor", FLOORS)
def test_the_velocities_are_the_minors_times_one(floor: str) -> None:
    """The rates have one division, for the mass; on what moves they have its velocity besides."""
    source, draw = axles(floor), random.Random(floor)
    line = added(source).line
    assert line is not None and line.columns == (0, 1, 2)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.divisions <= 3 and rhs.adds + rhs.multiplications + rhs.divisions <= 120
    own = as_python(source, "auto")
    for _ in range(5):
        q = [draw.uniform(-3, 3) for _ in range(5)]
        none, one, two = (own.velocities(0.3, [*q, v, 0.0, 0.0]) for v in (0.0, 1.0, 2.0))
        for x, y, z in zip(none, one, two, strict=True):
            assert z - y == pytest.approx(y - x, rel=1e-12, abs=1e-14)
        assert own.state(0.3, q, two)[5] == pytest.approx(2.0, rel=1e-10)
    assert certify(model(source).system).holds


@pytest.mark.parametrize("floor", FLOORS)
def test_accelerations_and_reactions_are_those_of_the_multipliers(floor: str) -> None:
    source, draw = axles(floor), random.Random(floor)
    own, whole = as_python(source, "auto"), as_python(source, "multipliers")
    for k in range(12):
        q = [draw.uniform(-3, 3) for _ in range(5)]
        if k == 0:
            q[3:] = [0.0, 0.0]  # straight ahead: th' alone does not tell the motion
        qdot = own.velocities(0.3, [*q, *(draw.uniform(-2, 2) for _ in range(3))])
        y, z = own.state(0.3, q, qdot), whole.state(0.3, q, qdot)
        assert own.accelerations(0.3, y) == pytest.approx(whole.accelerations(0.3, z), rel=1e-9, abs=1e-9)
        assert own.reactions(0.3, y) == pytest.approx(whole.reactions(0.3, z), rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("factor", ["", "k", "k^2"])
def test_where_the_constraints_lose_rank_every_language_refuses(factor: str, tmp_path: Path) -> None:
    """Nothing is divided by what vanishes there; it is guarded all the same."""
    source = axles("table", factor)
    own = as_python(source, "auto")
    library = compile_c(emit(source, "c"), tmp_path, "axles")
    c = CModel("axles", ctypes.CDLL(str(library)), {})
    q, w = [0.2, 0.1, 0.3, 0.4, -0.2], [1.0, 0.1, 0.2]
    across, p = [*q[:3], math.pi / 2, math.pi / 2], list(own.DEFAULTS)
    loose = [*p[:-1], 0.0]  # nothing holds the front axle
    assert c("rhs", 8, 0.0, [*q, *w], p) == pytest.approx(own.rhs(0.0, [*q, *w], p), rel=1e-13)
    for function, size in (("rhs", 8), ("velocities", 5), ("accelerations", 5), ("reactions", 2)):
        for place, values in ((across, p), (q, loose)) if factor else ((across, p),):
            with pytest.raises(ArithmeticError) as refused:
                c(function, size, 0.0, [*place, *w], values)
            assert refused.value.args == (1,)
            with pytest.raises(own.SingularModelError) as found:
                getattr(own, function)(0.0, [*place, *w], values)
            assert found.value.status == 1


def test_a_floor_that_is_not_written_as_one_is_solved_for() -> None:
    """Multiplied out, what moves is not to be read off: the constraints are solved, and the motion is the same."""
    source = axles("table")
    apart = source.text.replace("-sin(th + d)*(x' - -W*y)", "-sin(th + d)*x' - sin(th + d)*W*y")
    apart = apart.replace("-sin(th + e)*(x' - -W*y)", "-sin(th + e)*x' - sin(th + e)*W*y")
    other = Source("apart.yaml", apart)
    assert added(source).line is not None and added(other).line is None
    one, two = as_python(source, "auto"), as_python(other, "auto")
    q = [0.4, -0.3, 0.5, 0.6, -0.7]
    qdot = one.velocities(0.0, [*q, 0.8, 0.1, -0.2])
    first, second = (each.accelerations(0.0, each.state(0.0, q, qdot)) for each in (one, two))
    assert first == pytest.approx(second, rel=1e-12)


FERRY = """nhc: 1
system: ferry
coordinates: [x, y, th, d, e, r]
parameters: {m: 900, I: 1100, J: 2, a: 1.2, b: 1.4, W: 0.3, mp: 60, h: 0.9, g: 9.81, k: 300, F: 500}
define:
  w: W*(1 + sin(t/2)/2)
  px: x - h*sin(r)*sin(th)
  py: y + h*sin(r)*cos(th)
  pz: -h*cos(r)
T: m/2*(x'^2 + y'^2) + I/2*th'^2 + J/2*((th' + d')^2 + (th' + e')^2) + mp/2*(px'^2 + py'^2 + pz'^2)
V: mp*g*pz + k/2*((d - 0.2)^2 + (e + 0.1)^2)
forces: {x: F*cos(th), y: F*sin(th)}
constraints:
  - front: -sin(th + d)*(x' + w*y) + cos(th + d)*(y' - w*x) + a*cos(d)*(th' - w) = 0
  - rear: -sin(th + e)*(x' + w*y) + cos(th + e)*(y' - w*x) - b*cos(e)*(th' - w) = 0
"""


def test_what_swings_on_such_a_car_takes_no_axes_that_hide_the_minors() -> None:
    """A pendulum across, on a turntable whose speed changes: 195 operations, on axes that turn with the car 378."""
    source, draw = Source("ferry.yaml", FERRY), random.Random(3)
    assert added(source).line is not None
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions <= 200
    own, whole = as_python(source, "auto"), as_python(source, "multipliers")
    for _ in range(6):
        q = [draw.uniform(-3, 3) for _ in range(6)]
        qdot = own.velocities(0.3, [*q, *(draw.uniform(-2, 2) for _ in range(4))])
        y, z = own.state(0.3, q, qdot), whole.state(0.3, q, qdot)
        assert own.accelerations(0.3, y) == pytest.approx(whole.accelerations(0.3, z), rel=1e-9, abs=1e-9)


def test_velocities_of_the_spec_are_what_it_says() -> None:
    """A user's own row of minors keeps its length."""
    text = axles("rest").text + "quasi_velocities: {s: y*x' - x*y', u: d', w: e'}\n"
    circle = "\n".join(line for line in text.splitlines() if "front" not in line and "rear" not in line)
    circle += "\n"
    source = Source("own.yaml", circle.replace("constraints:\n", "constraints: [x*x' + y*y' = 0, th' = 0]\n"))
    form = added(source)
    assert form.name == "s" and form.line is None
    bare = Source("bare.yaml", source.text.replace("quasi_velocities: {s: y*x' - x*y', u: d', w: e'}\n", ""))
    line = added(bare).line
    assert line is not None and line.columns == (0, 1)


WAVE = """nhc: 1
system: surfer
coordinates: [x, y, s]
parameters: {m: 2, I: 0.1, h: 0.3, c: 0.8, g: 9.81}
define: {z: h*sin(x - c*t)*cos(y)}
T: m/2*(x'^2 + y'^2 + z'^2) + I/2*s'^2
V: m*g*z
constraints: [sin(s)*(x' - c) - cos(s)*y' = 0]
"""


def test_a_keel_that_moves_with_a_wave() -> None:
    """v is counted from the wave's own motion though its direction has length one: 41 operations in place of 59."""
    source = Source("surfer.yaml", WAVE)
    line, found = added(source).line, model(source)
    assert line is not None and line.carried == (found.system.p[3], 0, 0)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions <= 45
    own, whole = as_python(source, "auto"), as_python(source, "multipliers")
    y = [0.3, -0.4, 0.9, 0.7, 1.1]
    qdot = own.velocities(0.3, y)
    z = whole.state(0.3, y[:3], qdot)
    assert own.accelerations(0.3, y) == pytest.approx(whole.accelerations(0.3, z), rel=1e-12)
    assert own.reactions(0.3, y) == pytest.approx(whole.reactions(0.3, z), rel=1e-12)
    assert certify(found.system).holds
