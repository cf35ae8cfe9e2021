"""The emitted driver brings its state back to the constraints, as ``nhc run`` does: long motions stay on them, and are right."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy
import pytest
from scipy.integrate import solve_ivp

from nhc.language import Source, read
from nhc.pipeline import Options, emit
from tests.numeric.test_driver_stop import drive
from tests.support import compile_c, python_model, spec_path

BOB = """nhc: 1
system: bob
coordinates: [x, y, z]
parameters: {m: 1.3, L: 1, g: 9.81}
T: m/2*(x'^2 + y'^2 + z'^2)
V: m*g*z
holonomic:
  - rod: x^2 + y^2 + z^2 = L^2
outputs: {gap: x^2 + y^2 + z^2 - L^2, slide: x*x' + y*y' + z*z', E: energy}
scenes:
  long: {initial: {x: 0.8, z: -0.6, y': 1}, time: [0, 200], need: [x, y, z, gap, slide, E], tolerance: 1e-6}
"""


def rows_of(source: Source, folder: Path, *arguments: str, **options: object) -> list[dict[str, float]]:
    done = drive(source, folder, *arguments, **options)
    assert done.returncode == 0, done.stderr
    return [{key: float(x) for key, x in row.items()} for row in csv.DictReader(io.StringIO(done.stdout))]


def swing(times: Sequence[float]) -> list[list[float]]:
    """The spherical pendulum in angles (away from its poles), by SciPy at a small tolerance."""

    def rhs(_: float, y: Sequence[float]) -> list[float]:
        theta, _, w, u = y  # theta from the downward axis, and the azimuth
        return [
            w,
            u,
            u * u * math.sin(theta) * math.cos(theta) - 9.81 * math.sin(theta),
            -2 * w * u * math.cos(theta) / math.sin(theta),
        ]

    theta = math.asin(0.8)
    found = solve_ivp(
        rhs, (0, times[-1]), [theta, 0, 0, 1 / 0.8], method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times
    )
    return [
        [math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), -math.cos(a)]
        for a, b in zip(found.y[0], found.y[1], strict=True)
    ]


@pytest.mark.sample(2)
@pytest.mark.parametrize("scene", ["", "long"])
def test_a_bob_stays_on_its_sphere(scene: str, tmp_path: Path) -> None:
    rows = rows_of(Source("bob.yaml", BOB), tmp_path, "long", "5", formulation="multipliers", scene=scene)
    expected = swing([row["t"] for row in rows])
    for row, point in zip(rows, expected, strict=True):
        assert abs(row["gap"]) < 1e-13 and abs(row["slide"]) < 1e-13
        assert numpy.abs(numpy.array([row["x"], row["y"], row["z"]]) - point).max() < 2e-3
        assert abs(row["E"] - rows[0]["E"]) < 1e-4


def test_parameters_of_the_scene_may_be_put_in(tmp_path: Path) -> None:
    """A driver of one scene keeps the whole state, also where the scene needs less: it must be brought back."""
    source = Source("bob.yaml", BOB.replace("need: [x, y, z, gap, slide, E]", "need: [z, gap]"))
    folded, plain = (
        rows_of(source, tmp_path, "long", "3", formulation="multipliers", scene="long", fold=fold)
        for fold in (True, False)
    )
    for one, other in zip(folded, plain, strict=True):
        assert abs(one["gap"]) < 1e-13 and abs(one["z"] - other["z"]) < 1e-9


def test_a_chain_of_positions_and_of_velocities_without_mass(tmp_path: Path) -> None:
    """A coordinate without mass that a velocity constraint alone holds, beside a holonomic one."""
    text = BOB.replace("coordinates: [x, y, z]", "coordinates: [x, y, z, s]").replace(
        "outputs: {", "constraints: [s' = x*y' - y*x' + 0.1*x]\noutputs: {lag: s' - x*y' + y*x' - 0.1*x, "
    )
    text = text.replace("need: [x", "need: [lag, x")
    rows = rows_of(Source("bob.yaml", text), tmp_path, "long", "3", formulation="multipliers")
    expected = swing([row["t"] for row in rows])
    for row, point in zip(rows, expected, strict=True):
        assert max(abs(row[name]) for name in ("gap", "slide", "lag")) < 1e-12
        assert numpy.abs(numpy.array([row["x"], row["y"], row["z"]]) - point).max() < 2e-3


def test_velocity_constraints_of_the_multiplier_form(tmp_path: Path) -> None:
    """The knife edge of the sleigh does not slip, though its equations keep the acceleration of that alone."""
    text = read(str(spec_path("chaplygin_sleigh"))).text
    text = text.replace("\noutputs:", "\noutputs:\n  slip: -sin(theta)*x' + cos(theta)*y'")
    assert "slip: -sin" in text
    text += "  far: {initial: {theta: 0.1, v: 1.0, w: 3}, time: [0, 300], need: [slip], tolerance: 1e-5}\n"
    rows = rows_of(Source("sleigh.yaml", text), tmp_path, "far", "4", formulation="multipliers", scene="far")
    assert all(abs(row["slip"]) < 1e-14 for row in rows)


def test_quaternions_keep_their_length(tmp_path: Path) -> None:
    text = read(str(spec_path("heavy_top_quaternion"))).text
    source = Source(
        "top.yaml", text + "  far: {initial: {R: {angle: 1, axis: [1, 0, 0]}}, time: [0, 5], tolerance: 1e-4}\n"
    )
    name = next(line.split()[1] for line in text.splitlines() if line.startswith("system:"))
    main = emit(source, "c", Options(driver=True))[f"{name}_main.c"]
    assert f"{name}_hold_q(t, y, s->p, held)" in main
    rows = rows_of(source, tmp_path, "far", "3")
    quaternion = [key for key in rows[0] if key.startswith("R_")][:4]
    assert all(abs(sum(row[key] ** 2 for key in quaternion) - 1) < 1e-15 for row in rows)


def test_what_needs_no_holding_has_none(tmp_path: Path) -> None:
    files = emit(read(str(spec_path("chaplygin_sleigh"))), "c", Options(driver=True))
    assert "hold" not in files["chaplygin_sleigh_main.c"].replace("it holds", "")
    compile_c(files, tmp_path, "chaplygin_sleigh", library=False)


@pytest.mark.parametrize("name", ["snakeboard", "cartesian_pendulum", "holonomic_pendulum", "double_pendulum"])
def test_the_tolerance_of_the_scene_is_met(name: str, tmp_path: Path) -> None:
    """Relative to each quantity's own size in the scene: against the driver itself at a far smaller tolerance."""
    source = read(str(spec_path(name)))
    rows, finer = (rows_of(source, tmp_path, "reference", "21", tolerance) for tolerance in ("1e-8", "1e-13"))
    for key in rows[0]:
        size = max(abs(row[key]) for row in finer)
        assert max(abs(a[key] - b[key]) for a, b in zip(rows, finer, strict=True)) <= 1e-8 * size


@pytest.mark.parametrize("formulation", ["chaplygin", "multipliers"])
def test_a_driver_ends_where_a_holonomic_constraint_jumps(formulation: str, tmp_path: Path) -> None:
    """theta = t on the unit circle: beyond the branch cut at t = pi the state would be brought to another motion."""
    text = """nhc: 1
system: bearing
coordinates: [x, y, theta]
T: (x'^2 + y'^2 + theta'^2)/2
V: (x^2 + y^2)/2
holonomic: ["theta - atan2(y, x) = 0"]
scenes: {a: {initial: {x: 1, y': 1}, time: [0, 4]}}
"""
    done = drive(Source("bearing.yaml", text), tmp_path, "a", "21", formulation=formulation)
    assert done.returncode == 3
    assert "a constraint jumps here" in done.stderr
    where = re.search(r"stops at t = ([0-9.]+)", done.stderr)
    assert where is not None and float(where[1]) == pytest.approx(math.pi, abs=1e-6)
    found = [[float(x) for x in row.values()] for row in csv.DictReader(io.StringIO(done.stdout))]
    assert len(found) == 16  # up to t = 3
    for t, *row in found:
        assert row == pytest.approx([math.cos(t), math.sin(t), t], abs=1e-6)


@pytest.mark.parametrize("held", ["u' = 0", "-2*u' = 0"])
def test_what_one_constraint_holds_by_itself_does_not_tremble(held: str, tmp_path: Path) -> None:
    """u'' is zero; what elimination left of zero, 7e-18 at some states, was no small part of u', and steps underflowed."""
    text = f"""nhc: 1
system: still
coordinates: [y, u, z]
T: y'^2 + u'^2 + 0.2*sin(2*y)*y'*u' + z'^2
constraints: ["{held}"]
scenes:
  s: {{initial: {{u: -0.3, y': -0.48}}, time: [0, 1], need: [y, u, z, u']}}
"""
    rows = rows_of(Source("still.yaml", text), tmp_path, "s", "2", formulation="multipliers")
    assert [rows[-1][name] for name in ("y", "u", "z", "u'")] == pytest.approx([-0.48, -0.3, 0.0, 0.0], abs=1e-15)
    (module,) = emit(Source("still.yaml", text), "python", Options(formulation="multipliers")).values()
    model = python_model(module, "still")
    y = [-0.00035, -0.3, 0.0, -0.48, 0.0, 0.0]
    assert model.rhs(0.0, y)[4] == 0.0
    moved = model.rhs(0.0, y)[3]
    assert 2 * moved == pytest.approx(0.0, abs=1e-15)  # T_yy y'' = 0 where u' = 0
    (reaction,) = model.reactions(0.0, y)
    assert (1 if held.startswith("u") else -2) * reaction == pytest.approx(0.4 * math.cos(2 * y[0]) * 0.48**2)
