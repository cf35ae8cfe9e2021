"""The model of a scene: never larger than the full one, equal to it on all that the scene needs, and as small as theory says."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks.scenes import Pair, list_pairs
from nhc.algebra.exact.modular import Unlucky
from nhc.cli import main
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.flow import flow_of
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.reduction.reduce import _agree, _Model
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit, program, reduce_scene
from nhc.program.reduced import build_scene_program
from nhc.program.scene_model import SceneModel
from nhc.program.validation.scenes import validate_scene
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.study.chart.measure import sizes_of
from tests.support import GALLERY, compile_c, emitted_python, error, python_model, spec_path

SCENES = [(name, scene.name) for name in GALLERY for scene in decode(read(str(spec_path(name)))).scenes]
LONGEST = {"bicycle": 0.1, "rattleback": 0.5}  # seconds; their right-hand sides take long in Python
ENTRIES = {
    ("rolling_disk", "lean"): 4,
    ("chaplygin_sleigh", "speeds_only"): 2,
    ("rattleback", "wrong_way"): 5,
    ("suslov", "rates_only"): 2,
    ("free_rigid_body", "flip"): 3,
    ("spherical_pendulum", "conical"): 2,
    ("heavy_top", "reference"): 4,
    ("heavy_top", "sleeping"): 3,  # momenta lose digits where it stands up
    ("bicycle", "upright_again"): 6,
    ("ball_on_table", "modulated"): 2,
    ("diff_drive", "reference"): 6,
    ("vertical_disk", "reference"): 2,
}


@cache
def reduction(name: str, scene: str, formulation: str = "") -> SceneModel:
    return reduce_scene(read(str(spec_path(name))), Options(formulation=formulation, scene=scene))


@cache
def reduced_python(name: str, scene: str) -> ModuleType:
    (text,) = render(build_scene_program(reduction(name, scene)), "python", EmitOptions(scene=scene)).values()
    return python_model(text, f"{name}_{scene}")


@cache
def full_python(name: str) -> ModuleType:
    return emitted_python(name)


def integrate(model: ModuleType, y: Any, p: Any, start: float, end: float) -> Any:
    """States at eleven times."""
    times = np.linspace(start, end, 11)
    done = solve_ivp(
        lambda t, y: model.rhs(t, y, p), (start, end), y, "DOP853", times, rtol=1e-12, atol=1e-13, max_step=0.1
    )
    assert done.success
    return times, done.y.T


def needed(model: ModuleType, need: Any, t: float, y: Any, p: Any) -> Iterator[float]:
    """The columns of a scene's needs from a full model."""
    for name in need:
        if name in model.STATE:
            yield y[model.STATE.index(name)]
        elif name in model.OUTPUTS:
            yield model.outputs(t, y, p)[model.OUTPUTS.index(name)]
        elif name == "energy":
            yield model.energy(t, y, p)
        elif name == "reactions":
            yield from model.reactions(t, y, p)
        else:
            yield model.velocities(t, y, p)[model.COORDINATES.index(name.removesuffix("'"))]


@pytest.mark.sample(6)
@pytest.mark.parametrize(("name", "scene"), SCENES)
def test_the_model_of_a_scene_is_the_full_one_on_its_needs(name: str, scene: str) -> None:
    made = reduction(name, scene)
    assert len(made.reduction.kept) <= len(made.full_state)
    assert made.operations <= made.full_operations or len(made.reduction.kept) < len(made.full_state)
    assert made.tried[made.chosen].cost <= 1.05 * made.tried[0].cost  # never dearer than the same formulation, reduced
    if not made.tried[0].constants:  # the same formulation, less of it
        assert made.tried[0].operations <= made.full_operations
    source = read(str(spec_path(name)))
    full_scene = program(source, Options(scene=scene, only=("rhs",))).scenes[0]
    small_scene = build_scene_program(made).scenes[0]
    full, small = full_python(name), reduced_python(name, scene)
    start, end = full_scene.time
    end = min(end, start + LONGEST.get(name, 1.0))
    times, states = integrate(full, full_scene.y, full_scene.p, start, end)
    _, fewer = integrate(small, small_scene.y, small_scene.p, start, end)
    for t, y, z in zip(times, states, fewer, strict=True):
        expected = list(needed(full, full_scene.need, t, y, full_scene.p))
        assert error(small.outputs(t, z, small_scene.p), expected) < 1e-9
        q, qdot = y[: len(full.COORDINATES)], full.velocities(t, y, full_scene.p)
        same = small.state(t, q, qdot, small_scene.p)
        assert error(small.outputs(t, same, small_scene.p), expected) < 1e-10
        rates = dict(zip(small.STATE, small.rhs(t, same, small_scene.p), strict=True))
        held = [i for i, coordinate in enumerate(full.COORDINATES) if coordinate in rates]
        assert error([rates[full.COORDINATES[i]] for i in held], [qdot[i] for i in held]) < 1e-10


@cache
def pairs() -> dict[tuple[str, str], Pair]:
    return {(pair.name, pair.scene): pair for pair in list_pairs()}


@pytest.mark.slow
def test_the_whole_scene_is_the_same_to_its_tolerance_in_emitted_c() -> None:
    """Over the whole time of every scene whose model is another one: exact reductions leave a thousandth of the tolerance."""
    found = {}
    for key, pair in pairs().items():
        full, small = (run(job, Settings(tolerance=1e-13, points=21)) for job in (pair.full, pair.reduced))
        assert full.ended == small.ended == "done" and full.headings == small.headings, key
        sizes = sizes_of(full.rows, len(full.headings))
        rows = zip(full.rows, small.rows, strict=True)
        error = max(abs(a - b) / size for row, other in rows for a, b, size in zip(row, other, sizes, strict=True))
        found[key] = error / pair.full.tolerance
    assert len(found) >= 25
    assert {key: ratio for key, ratio in found.items() if ratio > 0.1} == {}  # a free body amplifies rounding by 1e5
    assert sum(ratio < 2e-3 for ratio in found.values()) >= len(found) - 2


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "scene"), ENTRIES)
def test_sizes_of_theory(name: str, scene: str) -> None:
    assert len(reduction(name, scene).reduction.kept) == ENTRIES[name, scene]


def test_the_ball_on_a_table_needs_four_equations_before_its_momenta_are_used() -> None:
    sizes = [len(tried.state) for tried in reduction("ball_on_table", "modulated").tried if not tried.constants]
    assert min(sizes) == 4


def with_need(name: str, need: str) -> Source:
    """A gallery spec whose scene `asked` is its first one with other needs."""
    source = read(str(spec_path(name)))
    scene = decode(source).scenes[0]
    text = source.text[scene.span.start :]
    block = text.split("\n  ", 1)[1] if text.startswith(scene.name) else text
    lines = [line for line in _first_scene(block) if not line.strip().startswith("need:")]
    return Source(source.path, f"{source.text.rstrip()}\n  asked:\n" + "\n".join(lines) + f"\n    need: {need}\n")


def _first_scene(block: str) -> list[str]:
    lines = block.splitlines()
    body = []
    for line in ["  " + lines[0], *lines[1:]]:
        if line.strip() and not line.startswith("    "):
            break
        body.append(line)
    return [line for line in body if line.strip()]


@pytest.mark.parametrize(
    ("name", "need", "state"),
    [
        ("n_trailer3", "[theta1, v]", ("theta1", "theta2", "theta3", "v")),
        ("n_trailer3", "[theta0]", ("theta0",)),
        ("vertical_disk", "[x, y]", ("x", "y")),
        ("diff_drive", "[p_R, p_L, theta]", ("theta", "p_R", "v", "w")),
        ("vertical_disk", "[theta]", ("theta",)),
        ("chaplygin_sleigh", "[theta]", ("theta", "v", "w")),
        ("point_mass", "[z]", ("z", "z'")),
        ("chaplygin_ball", "[w1, w2, w3]", ("theta", "psi", "w1", "w2", "w3")),
        ("rolling_disk", "[energy]", ("theta", "w_t", "w_u", "w_n")),
    ],
)
def test_what_a_need_depends_on(name: str, need: str, state: tuple[str, ...]) -> None:
    assert reduce_scene(with_need(name, need), Options(scene="asked")).reduction.state == state


def test_the_users_formulation_is_kept() -> None:
    made = reduction("ball_on_table", "modulated", "voronec")
    assert made.reduction.formulation.name == "voronec"
    assert len(made.tried) == 1


def test_what_is_left_out_has_its_reason() -> None:
    left = {omission.name: omission.reason for omission in reduction("vertical_disk", "reference").reduction.left}
    assert left["theta'"].startswith("constant of the motion")
    assert left["theta"].startswith("integrated: theta = theta_0 + t*theta', where theta_0 is a parameter")
    assert sorted(left) == ["phi", "phi'", "theta", "theta'"]
    left = {omission.name: omission.reason for omission in reduction("diff_drive", "reference").reduction.left}
    assert left["p_L"].startswith("integrated: p_L = p_L_0 + p_R - 2*b*theta/r, where")
    left = {omission.name: omission.reason for omission in reduction("rolling_disk", "lean").reduction.left}
    assert left["psi"].startswith("cyclic and not needed")
    assert left["phi"] == "decoupled: only what is left out depends on it (x, y)"


FRICTION = """nhc: 1
system: dry
coordinates: [x, y]
parameters: {k: 0.5, h: 0}
T: (x'^2 + y'^2)/2
forces:
  x: -sign(y)*k + h*y
  y: -y
scenes:
  alone: {initial: {x: 1, y: 1}, time: [0, 1], need: [x]}
  other: {initial: {x: 1, y: 1}, time: [0, 1], need: [y]}
"""


def test_a_sign_is_a_dependence_though_its_slope_is_zero() -> None:
    text = FRICTION.replace(" + h*y", "")
    made = reduce_scene(Source("dry.yaml", text.replace(", h: 0", "")), Options(scene="alone"))
    assert made.reduction.state == ("x", "y", "x'", "y'")
    made = reduce_scene(Source("dry.yaml", text.replace(", h: 0", "")), Options(scene="other"))
    assert made.reduction.state == ("y", "y'")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("force", "need", "state"),
    [
        ("y*sign(x)*sign(x)", "y", ("y", "x", "y'", "x'")),
        ("y*sign(x - 2*y)^2", "y", ("y", "x", "y'", "x'")),
        ("sign(x')^2", "y'", ("x", "y'", "x'")),
        ("y*abs(x)/(abs(x) + 1) + y/(1 + abs(x))", "y", ("y", "y'")),
        ("y*(sign(x)*abs(x) - x + 1)", "y", ("y", "y'")),
    ],
)
def test_a_sign_is_zero_where_a_motion_may_stay(force: str, need: str, state: tuple[str, ...]) -> None:
    """x starts at 0 at rest and stays there: sign(x)^2 is 0 all the time, though it is 1 everywhere else."""
    text = (
        "nhc: 1\nsystem: still\ncoordinates: [y, x]\nT: (x'^2 + y'^2)/2\nV: x^2/2\n"
        f'forces: {{y: "{force}"}}\nscenes: {{s: {{initial: {{y: 1}}, time: [0, 1], need: ["{need}"]}}}}\n'
    )
    source = Source("still.yaml", text)
    made = reduce_scene(source, Options(scene="s"))
    assert made.reduction.state == state
    full = run(open_scene(source, "s", "multipliers", whole=True), Settings("dop853", 1e-10))
    small = run(open_scene(source, "s"), Settings("dop853", 1e-10))
    column = full.headings.index(need)
    assert [row[column] for row in full.rows] == pytest.approx([row[small.headings.index(need)] for row in small.rows])


SWITCH = """nhc: 1
system: switch
coordinates: [{a}, {b}]
parameters: {{k: 1, h: 2}}
T: ({a}'^2 + {b}'^2)/2
V: {a}^2/2
forces:
  {b}: {force}
scenes:
  s: {{initial: {{{a}: -1}}, time: [0, 1], need: [{b}]}}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "force",
    [
        "k*{a}/sqrt({a}^2)",
        "-k*{a}'/sqrt({a}'^2)",
        "k*{a}/sqrt({a}^2*h)",
        "k*cos(atan2(0, {a}))",
        "k*sin(acos(cos({a})))/sin({a})",
        "(1 + sign({b}' - h))*sign({a})",
    ],
)
def test_a_root_may_be_a_dependence_though_its_slope_is_zero(force: str) -> None:
    for a, b in (
        ("d", "y"),
        ("theta", "y"),
        ("x", "z"),
        ("z", "x"),
        ("q1", "q2"),
        ("r", "u"),
        ("psi", "s"),
        ("v", "w"),
    ):
        text = SWITCH.format(a=a, b=b, force=force.format(a=a, b=b))
        made = reduce_scene(Source("switch.yaml", text), Options(scene="s"))
        assert {a, f"{a}'"} <= set(made.reduction.state), (a, b)


def test_the_values_that_stand_for_what_is_left_out_are_compared_at_all_signs() -> None:
    """x - sqrt(x^2) and 0 agree at every second point."""
    system = resolve(decode(Source("switch.yaml", SWITCH.format(a="x", b="y", force="k*(x - sqrt(x^2))"))))
    g = system.graph
    flow = flow_of(equations_of(system, formulate(system)))
    parts = (flow.velocities, tuple(x for row in flow.matrix for x in row), (), ())
    before = _Model(flow.unknowns, (0, 1), parts[0], parts[1], flow.right, (), (), ())
    after = before.put(flow, system.p[0], g.zero)
    assert before.right != after.right
    assert not _agree(flow, before, after)
    assert _agree(flow, before, before)


def test_a_dependence_that_cancels_does_not_count() -> None:
    text = FRICTION.replace("-sign(y)*k + h*y", "sin(y)^2*k + k*cos(y)^2 - x")
    made = reduce_scene(Source("dry.yaml", text), Options(scene="alone"))
    assert made.reduction.state == ("x", "x'")


SIDES = """nhc: 1
system: sides
coordinates: [x, y]
T: (x'^2 + y'^2)/2
U: -y^2/2
constraints: ["{row}"]
scenes:
  one: {{initial: {{x: {x}, y: 0.2, y': 1}}, time: [0, 0.5], need: [x, y, energy]}}
"""


@pytest.mark.parametrize(
    ("row", "slope", "x", "entries"),
    [
        ("x' - x*y' = 0", lambda x: x, 0.7, 2),
        ("x' - x*y' = 0", lambda x: x, 0, 3),
        ("x' - x*y' = 0", lambda x: x, -0.7, 2),
        ("x' + x^2*y' = 0", lambda x: -x * x, 0.7, 2),
        ("x' + x^2*y' = 0", lambda x: -x * x, 0, 3),
        ("x' + x^2*y' = 0", lambda x: -x * x, -0.7, 2),
    ],
)
def test_an_integral_without_a_value_at_the_start_gives_no_coordinate(
    row: str, slope: Any, x: float, entries: int
) -> None:
    """y - log(abs(x)) and y - 1/x tell of all motions that x' = b(x) y' allows but those at x = 0; against y'' written by hand."""
    source = Source("sides.yaml", SIDES.format(row=row, x=x))
    made = reduce_scene(source, Options(scene="one"))
    assert len(made.reduction.kept) == entries
    built = build_scene_program(made)
    (text,) = render(built, "python", EmitOptions(scene="one")).values()
    small, scene = python_model(text, "sides"), built.scenes[0]
    _, states = integrate(small, scene.y, scene.p, 0, 0.5)

    def by_hand(
        t: float, s: Any
    ) -> list[float]:  # Lagrange's equation of the leaf: (1 + b^2) y'' + b b_x b y'^2 + y = 0
        b, step = slope(s[0]), 1e-6
        bend = (slope(s[0] + step) - slope(s[0] - step)) / (2 * step)
        return [b * s[2], s[2], -(b * bend * b * s[2] ** 2 + s[1]) / (1 + b * b)]

    end = solve_ivp(by_hand, (0, 0.5), [x, 0.2, 1], "DOP853", rtol=1e-11, atol=1e-12).y[:, -1]
    energy = (1 + slope(end[0]) ** 2) * end[2] ** 2 / 2 + end[1] ** 2 / 2
    assert error(small.outputs(0.5, states[-1], scene.p), [end[0], end[1], energy]) < 1e-8


@pytest.mark.parametrize(
    ("need", "state"),
    [("x", ("x", "x'")), ("p", ("p", "q")), ("r", ("r",)), ("R_z3", ("R_0", "R_1", "R_2", "R_3", "p", "q"))],
)
def test_a_rotation_that_is_left_out_with_what_it_drives(need: str, state: tuple[str, ...]) -> None:
    """The dropped rows divide by the length of the quaternion, whatever values it is given."""
    text = f"""nhc: 1
system: turned
rotation: {{R: {{velocities: [p, q, r]}}}}
coordinates: [x, s]
parameters: {{A: 0.4, C: 0.8, k: 3}}
T: (A*(p^2 + q^2) + C*r^2)/2 + x'^2/2 + s'^2/2
V: k/2*x^2
forces: {{s: R_z3}}
outputs: {{up: R_z3}}
scenes:
  a: {{initial: {{p: 0.1, r: 3, x': 1}}, time: [1, 4], need: [{need.replace("R_z3", "up")}]}}
"""
    made = reduce_scene(Source("turned.yaml", text), Options(scene="a"))
    assert made.reduction.state == state
    assert validate_scene(made)["rhs"] is True


POLES = """nhc: 1
system: poles
coordinates: [y, x, s]
T: (x'^2 + y'^2 + s'^2)/2
V: y^2/2
forces: {s: 1/(x*(x - 1)*(x - 2)POLE)}
scenes: {a: {initial: {y: 1, x: 3}, time: [0, 1], need: [y]}}
"""


@pytest.mark.parametrize(("pole", "told"), [("", False), ("*(x - pi/2)", True)])
def test_where_no_value_can_stand_for_an_entry_that_is_said(
    pole: str, told: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "poles.yaml"
    spec.write_text(POLES.replace("POLE", pole))
    assert main(["reduce", str(spec)]) == 0
    text = capsys.readouterr().out
    assert ("left out nothing: the equations are singular" in text) == told
    assert ("reduced  2 equations (y, y')" in text) != told
    assert main(["reduce", str(spec), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["undecided"] is told


def test_folded_values_reduce_further() -> None:
    text = FRICTION.replace("-sign(y)*k", "-x")
    source = Source("dry.yaml", text)
    assert len(reduce_scene(source, Options(scene="alone")).reduction.kept) == 4
    made = reduce_scene(source, Options(scene="alone", fold=True))
    assert made.reduction.state == ("x", "x'")


@pytest.mark.parametrize("name", ["ball_on_table", "rolling_disk", "spherical_pendulum"])
def test_the_jacobian_of_a_reduced_model_is_that_of_its_rates(name: str) -> None:
    scene = {"ball_on_table": "modulated", "rolling_disk": "lean", "spherical_pendulum": "conical"}[name]
    small = reduced_python(name, scene)
    data = build_scene_program(reduction(name, scene)).scenes[0]
    t, y = 0.3, [x + 0.1 for x in data.y]
    found, step = small.jacobian(t, y, data.p), 1e-6
    for j in range(len(y)):
        up = small.rhs(t, [x + step * (i == j) for i, x in enumerate(y)], data.p)
        down = small.rhs(t, [x - step * (i == j) for i, x in enumerate(y)], data.p)
        assert error([row[j] for row in found], [(a - b) / (2 * step) for a, b in zip(up, down, strict=True)]) < 1e-7


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "scene"), [("ball_on_table", "modulated"), ("rolling_disk", "lean"), ("holonomic_pendulum", "reference")]
)
def test_c_driver_prints_what_is_needed(name: str, scene: str, tmp_path: Path) -> None:
    ends = []
    for fold in (False, True):
        folder = tmp_path / f"fold{fold}"
        folder.mkdir()
        files = emit(read(str(spec_path(name))), "c", Options(scene=scene, driver=True, fold=fold))
        program_path = compile_c(files, folder, name, library=False)
        done = subprocess.run([str(program_path), scene, "5", "1e-11"], capture_output=True, text=True, check=True)
        rows = done.stdout.splitlines()
        assert rows[0].split(",") == ["t", *(column.name for column in reduction(name, scene).reduction.outputs)]
        assert len(rows) == 6
        ends.append(rows[-1].split(","))
    assert error(*ends) < 1e-8


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "scene", "states"),
    [
        ("rolling_disk", "lean", 4),
        ("chaplygin_sleigh", "speeds_only", 2),
        ("rattleback", "wrong_way", 5),
        ("vertical_disk", "reference", 2),
        ("diff_drive", "reference", 6),
        ("heavy_top", "waking", 4),
        ("spherical_pendulum", "conical", 3),
    ],
)
def test_a_run_uses_the_smallest_state(name: str, scene: str, states: int) -> None:
    """With the same fixed steps, which a look at what comes near would cut: the smaller model has less to look at."""
    source = read(str(spec_path(name)))
    job = open_scene(source, scene, stay=True)
    assert len(job.y) == states
    names = tuple(column.heading for column in job.columns)
    whole = open_scene(source, scene, needs=names, stay=True)
    assert len(whole.y) > states
    step = (job.time[1] - job.time[0]) / 2000
    found, expected = (run(each, Settings("rk4", step=step, points=11)) for each in (job, whole))
    assert found.headings == expected.headings
    for row, other in zip(found.rows, expected.rows, strict=True):
        assert error(row, other) < 1e-10


def test_a_motion_that_no_field_point_tells_about_keeps_everything(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*arguments: object) -> None:
        raise Unlucky

    monkeypatch.setattr("nhc.mechanics.reduction.reduce.find_dependence", fail)
    source = read(str(spec_path("rolling_disk")))
    made = reduce_scene(source, Options(scene="lean", formulation="euler-lagrange"))
    assert made.reduction.state == made.full_state
    assert made.operations == made.full_operations
    assert len(open_scene(source, "lean").y) == 8
