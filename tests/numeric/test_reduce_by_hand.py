"""Exact reductions of two systems outside the gallery, against equations written by hand."""

from __future__ import annotations

import math
import random
from types import ModuleType

import pytest

from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.pipeline import Options, reduce_scene
from nhc.program.reduced import build_scene_program
from nhc.program.scene_model import SceneModel
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import error, python_model

PARABOLA = """
nhc: 1
system: parabola
about: a bead on a wire y = a x^2, its constraint written with velocities
coordinates: {x: {unit: m}, y: {unit: m}, s: {unit: m}}
parameters: {m: {value: 1.3, unit: kg}, g: {value: 9.81, unit: m/s^2}, a: {value: 0.5, unit: 1/m}, c: {value: 0.2, unit: kg/s}}
T: m/2*(x'^2 + y'^2 + s'^2)
V: m*g*y
forces: {s: -c*s'}
constraints:
  - y' - 2*a*x*x' = 0
scenes:
  slide: {initial: {x: 1, y: 0.7, "s'": 1}, time: [0, 3], need: [x, y]}
  beside: {initial: {x: 1, y: 0.7, "s'": 1}, time: [0, 3], need: [s]}
"""
CENTRAL = """
nhc: 1
system: central
about: a planet on a spring, an oscillator that it drives, and one that nobody drives
coordinates: {r: {range: [0.1, 10]}, phi: {}, z: {}, h: {}}
parameters: {m: 2, k: 3, e: 0.4, n: 1.5}
T: m/2*(r'^2 + r^2*phi'^2) + z'^2/2 + h'^2/2
V: k/2*r^2 + n/2*z^2 + h^2
forces: {z: e*r}
scenes:
  distance: {initial: {r: 1, "phi'": 0.8, z: 0.1, h: 1}, time: [0, 4], need: [r]}
  angle: {initial: {r: 1, "phi'": 0.8, z: 0.1, h: 1}, time: [0, 4], need: [phi]}
  driven: {initial: {r: 1, "phi'": 0.8, z: 0.1, h: 1}, time: [0, 4], need: [z]}
  alone: {initial: {r: 1, "phi'": 0.8, z: 0.1, h: 1}, time: [0, 4], need: [h]}
"""


def reduced(text: str, scene: str) -> tuple[SceneModel, ModuleType]:
    made = reduce_scene(Source("spec.yaml", text), Options(scene=scene))
    (code,) = render(build_scene_program(made), "python", EmitOptions(scene=scene)).values()
    return made, python_model(code, f"{made.system.name}_{scene}")


def draws(count: int) -> list[list[float]]:
    chance = random.Random(5)
    return [[chance.uniform(0.3, 1.5) for _ in range(count)] for _ in range(8)]


def test_a_constraint_that_integrates_leaves_the_equation_of_the_wire() -> None:
    made, model = reduced(PARABOLA, "slide")
    assert made.reduction.state == ("x", "x'") and len(made.full_state) == 5
    reasons = {omission.name: omission.reason for omission in made.reduction.left}
    assert reasons["y"].startswith("integrated: y = y_0 + a*x^2, where y_0 is a parameter")
    assert reasons["s"].startswith("cyclic and not needed") and reasons["s'"].startswith("decoupled")
    for x, v, a, lift in draws(4):
        p = [1.3, 9.81, a, 0.2, lift]
        assert model.PARAMETERS == ("m", "g", "a", "c", "y_0")
        acceleration = -(4 * a * a * x * v * v + 2 * a * 9.81 * x) / (1 + 4 * a * a * x * x)
        assert error(model.rhs(0.0, [x, v], p), [v, acceleration]) < 1e-14
        assert error(model.outputs(0.0, [x, v], p), [x, lift + a * x * x]) < 1e-15
    data = build_scene_program(made).scenes[0]
    assert data.p[-1] == pytest.approx(0.2, abs=1e-15)  # 0.7 - 0.5*1^2


def test_what_is_beside_the_wire_is_by_itself() -> None:
    made, model = reduced(PARABOLA, "beside")
    assert made.reduction.state == ("s", "s'")
    assert error(model.rhs(0.0, [0.4, 1.2], model.DEFAULTS), [1.2, -0.2 / 1.3 * 1.2]) < 1e-15


def test_a_holonomic_constraint_is_solved_for_its_coordinate() -> None:
    text = PARABOLA.replace("constraints:\n  - y' - 2*a*x*x' = 0", "holonomic:\n  - y - 0.2*1 = a*x^2")
    text = text.replace("a: {value: 0.5, unit: 1/m}", "a: 0.5").replace(", unit: m}", "}").replace("{unit: m}", "{}")
    text = text.replace("unit: kg/s", "unit: kg/s").replace("c: {value: 0.2, unit: kg/s}", "c: 0.2")
    text = text.replace("m: {value: 1.3, unit: kg}", "m: 1.3").replace("g: {value: 9.81, unit: m/s^2}", "g: 9.81")
    made, model = reduced(text, "slide")
    assert made.reduction.state == ("x", "x'")
    assert model.outputs(0.0, [0.6, 0.0], model.DEFAULTS)[1] == pytest.approx(0.2 + 0.5 * 0.36, abs=1e-15)


def test_a_conserved_momentum_takes_the_place_of_its_velocity() -> None:
    made, model = reduced(CENTRAL, "distance")
    assert made.reduction.state == ("r", "r'") and model.PARAMETERS[-1] == "p_phi"
    for r, v, p in draws(3):
        expected = [v, p * p / (4 * r**3) - 3 / 2 * r]
        assert error(model.rhs(0.0, [r, v], [2.0, 3.0, 0.4, 1.5, p]), expected) < 1e-14


TABLE = """
nhc: 1
system: table
rotation: {R: {velocities: [w1, w2, w3], frame: space}}
coordinates: [x, y]
parameters: {a: 0.2, Om: 0.6}
T: (x'^2 + y'^2)/2 + a^2/5*(w1^2 + w2^2 + w3^2)
constraints: ["x' - a*w2 = -Om*y", "y' + a*w1 = Om*x"]
scenes: {roll: {initial: {x: 1, w1: 0.5, w3: 0.7}, time: [0, 10], need: [x, y]}}
"""


def test_what_stands_for_a_quaternion_is_none_of_length_zero() -> None:
    """A ball on a turning table goes round at 2/7 of its speed: of nine entries of its state two are left."""
    made, model = reduced(TABLE, "roll")
    assert made.reduction.state == ("x", "y")
    rates = [model.rhs(0.0, [x, y], [0.2, 0.6, *model.DEFAULTS[2:]]) for x, y in ((1.0, 0.5), (2.0, 0.5), (1.0, 1.5))]
    along, across = ([b - a for a, b in zip(rates[0], other, strict=True)] for other in rates[1:])
    assert error(along, [0.0, 1.2 / 7]) < 1e-14 and error(across, [-1.2 / 7, 0.0]) < 1e-14


WALL = """
nhc: 1
system: wall
coordinates: [X, u]
parameters: {m: 1, k: 3}
T: m/2*(X'^2*(2 + cos(u)) + u'^2)
V: k*max(0, X)
scenes:
  thrown: {initial: {X: -1, "X'": 1, "u'": 1}, time: [0, 5], need: [X, u]}
"""


@pytest.mark.parametrize("name", list("abcdefghij"))
def test_a_momentum_that_a_wall_changes_on_one_side_is_not_called_conserved(name: str) -> None:
    """A value of sign(X) is right by chance at every second point: by two points one name in four was taken."""
    made, _ = reduced(WALL.replace("X", name), "thrown")
    assert not [tried.reason for tried in made.tried if "conserved" in tried.reason]
    free, _ = reduced(WALL.replace("V: k*max(0, X)", "V: k*u^2").replace("X", name), "thrown")
    assert [tried.reason for tried in free.tried if f"conserved momentum p_{name}" in tried.reason]


def test_a_cyclic_coordinate_is_a_quadrature_where_it_is_needed() -> None:
    made, model = reduced(CENTRAL, "angle")
    assert made.reduction.state == ("r", "phi", "r'")
    assert [made.reduction.names[i] for i in made.reduction.kept if i not in made.reduction.driving] == ["phi"]
    for r, v, p in draws(3):
        assert error(model.rhs(0.0, [r, 0.3, v], [2.0, 3.0, 0.4, 1.5, p])[1:2], [p / (2 * r * r)]) < 1e-14


def test_decoupled_parts_are_left_out_and_driving_ones_are_not() -> None:
    made, model = reduced(CENTRAL, "driven")
    assert made.reduction.state == ("r", "z", "r'", "z'")
    assert error(model.rhs(0.0, [1.1, 0.2, 0.3, 0.4], model.DEFAULTS)[3:], [0.4 * 1.1 - 1.5 * 0.2]) < 1e-14
    made, model = reduced(CENTRAL, "alone")
    assert (
        made.reduction.state == ("h", "h'") and error(model.rhs(0.0, [0.7, 0.1], model.DEFAULTS), [0.1, -1.4]) < 1e-15
    )


def test_folded_values_stand_in_the_code_as_numbers() -> None:
    made = reduce_scene(Source("spec.yaml", CENTRAL.replace("e: 0.4", "e: 0")), Options(scene="driven", fold=True))
    assert made.reduction.state == ("z", "z'")  # what no longer drives is no longer there
    (code,) = render(build_scene_program(made), "python", EmitOptions(scene="driven")).values()
    model = python_model(code, "folded")
    wrong = [0.0] * len(model.PARAMETERS)
    assert error(model.rhs(0.0, [0.2, 0.4], wrong), [0.4, -0.3]) < 1e-15


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("text", "scene"),
    [(PARABOLA, "slide"), (PARABOLA, "beside"), (CENTRAL, "angle"), (CENTRAL, "driven"), (TABLE, "roll")],
)
def test_runs_agree_with_the_whole_state(text: str, scene: str) -> None:
    small = open_scene(Source("spec.yaml", text), scene)
    whole = open_scene(Source("spec.yaml", text), scene, needs=tuple(c.heading for c in small.columns))
    assert len(small.y) < len(whole.y)
    found, expected = (run(job, Settings(tolerance=1e-12, points=11)) for job in (small, whole))
    assert max(error(a, b) for a, b in zip(found.rows, expected.rows, strict=True)) < 1e-11


def test_the_emitted_header_says_what_was_left_out_and_why() -> None:
    made = reduce_scene(Source("spec.yaml", PARABOLA), Options(scene="slide"))
    for language, mark in (("c", " * "), ("python", "")):
        text = "\n".join(render(build_scene_program(made), language, EmitOptions(scene="slide")).values())
        head = " ".join(line.removeprefix(mark).strip() for line in text.splitlines()[:60])
        assert "2 of 5 states" in head and "left out: s: cyclic and not needed" in head
        assert "left out: y: integrated: y = y_0 + a*x^2" in head
    assert math.isclose(build_scene_program(made).scenes[0].p[-1], 0.2)
