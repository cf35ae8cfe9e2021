"""The emitted driver stops where ``nhc run --stay`` does: where the model is lost between two steps that both succeed."""

from __future__ import annotations

import math
import re
import subprocess
from pathlib import Path

import pytest

from nhc.language import Source, read
from nhc.pipeline import Options, emit
from nhc.simulate.methods.dop853 import METHOD
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.numeric.test_singular_stop import CLOSED, SPIRAL, board, body
from tests.support import compile_c, spec_path

VESELOVA = Source(
    "ves.yaml",
    """nhc: 1
system: ves
rotation: {R: {velocities: [p, q, r]}}
parameters: {A: 1, B: 1.5, C: 2.1}
T: (A*p^2+B*q^2+C*r^2)/2
constraints:
  - ves: R_z1*p + 2*R_z2*q + R_z3*r = 0
scenes: {go: {initial: {p: 0.4, q: 0.9}, time: [0, 30], tolerance: 1e-8}}
""",
)
# names of the driver itself and of the headers that it alone includes
CROWDED = Source(
    "crowded.yaml",
    """nhc: 1
system: crowded
coordinates: [stdin, EIO, NODES]
parameters: {LOSSES: 1, STAGES: 2, before: 3}
T: LOSSES*stdin'^2/2 + STAGES*EIO'^2/2 + before*NODES'^2/2
constraints:
  - slip: sin(NODES)*stdin' - cos(NODES)*EIO' = 0
formulation: voronec
scenes: {go: {initial: {NODES': 1, stdin': 0.1}, time: [0, 2]}}
""",
)


# the blade crosses the cart's axis behind it, where the rates of the two angles do not tell the speed
TOWED = Source(
    "towed.yaml",
    """nhc: 1
system: towed
coordinates: [x, y, th, al]
parameters: {M: 12, m: 3, I: 0.8, J: 0.4, d: 0.3, e: 0.7}
define: {xs: x - d*cos(th) - e*cos(th + al), ys: y - d*sin(th) - e*sin(th + al)}
T: M/2*(x'^2 + y'^2) + I/2*th'^2 + m/2*(xs'^2 + ys'^2) + J/2*(th' + al')^2
forces: {th: 0.6*cos(t), al: -1}
constraints:
  - axle: -sin(th)*x' + cos(th)*y' = 0
  - blade: -sin(th + al)*xs' + cos(th + al)*ys' = 0
formulation: voronec
dependent: [x', y']
scenes: {go: {initial: {al: -2.5, x': 1.5, al': 1.5*sin(2.5)/0.7}, time: [0, 6]}}
""",
)


def drive(source: Source, folder: Path, *arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
    """Emit with the driver, compile strictly, run."""
    files = emit(source, "c", Options(driver=True, **options))  # type: ignore[arg-type]
    name = next(iter(files)).removesuffix(".h")
    program = compile_c(files, folder, name, ("-Wshadow",), library=False)
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60)


def find_stop(done: subprocess.CompletedProcess[str]) -> float:
    """The time at which a driver stopped; no row may be later."""
    found = re.search(r"stops at t = (\S+): ", done.stderr)
    assert done.returncode == 3 and found is not None, done.stderr
    stop = float(found[1])
    assert float(done.stdout.splitlines()[-1].split(",")[0]) <= stop
    return stop


@pytest.mark.sample(2)
@pytest.mark.parametrize("tolerance", ["1e-4", "1e-8", "1e-12"])
@pytest.mark.parametrize("points", ["2", "1000"])
def test_a_pivot_without_bound_between_two_steps(tolerance: str, points: str, tmp_path: Path) -> None:
    """A mass matrix grows without bound at t = 1.602 and is positive on both sides."""
    done = drive(VESELOVA, tmp_path, "go", points, tolerance)
    trajectory = run(open_scene(VESELOVA, "go", stay=True), Settings("dop853", points=2))
    assert trajectory.ended == "failed"
    assert find_stop(done) == pytest.approx(trajectory.outcome.t, abs=1e-6)
    # that is why: the run asks, and the driver's text leaves both open
    assert "the coframe is singular" in trajectory.reason
    assert "the mass matrix is singular" in done.stderr and "or the velocities that are kept" in done.stderr


@pytest.mark.parametrize("scene", ["", "reference"])
@pytest.mark.parametrize("fold", [False, True])
def test_a_block_of_dependent_velocities(scene: str, fold: bool, tmp_path: Path) -> None:
    """The skate's heading reaches pi/2 at 1.5 per second; also in the model of the scene alone."""
    source = read(str(spec_path("skate_incline")))
    options = {"formulation": "voronec", "scene": scene, "fold": fold and bool(scene)}
    done = drive(source, tmp_path, "reference", "6", "1e-6", **options)
    assert find_stop(done) == pytest.approx(math.pi / 3, abs=1e-9)
    assert "the constraints cannot be solved for y'" in done.stderr


@pytest.mark.parametrize(
    ("source", "scene", "why"),
    [
        (read(str(spec_path("skate_incline"))), "reference", "the constraints cannot be solved for y'"),
        (TOWED, "go", "a pivot of it vanishes here"),
    ],
    ids=["determinant", "pivot"],
)
def test_where_the_choice_of_velocities_fails_a_way_out_is_named(
    source: Source, scene: str, why: str, tmp_path: Path
) -> None:
    """Where a pivot has the determinant in it, the pivot is lost first."""
    stopped = drive(source, tmp_path, scene, "6", formulation="voronec")
    assert why in stopped.stderr
    advised = re.search(r"`--formulation ([\w-]+)`", stopped.stderr)
    assert advised is not None
    done = drive(source, tmp_path, scene, "6", formulation=advised[1])
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("formulation", ["", "multipliers"])
def test_what_only_touches_zero(formulation: str, tmp_path: Path) -> None:
    """Both axles of the snakeboard along the board: nothing changes its sign there, and nothing blows up."""
    done = drive(board(), tmp_path, "through", "31", formulation=formulation)
    assert find_stop(done) == pytest.approx(CLOSED, abs=1e-5)
    assert find_stop(done) == pytest.approx(run_to_stop(board(), "through", formulation), abs=1e-6)


def run_to_stop(source: Source, scene: str, formulation: str) -> float:
    """The time at which a run that keeps its formulation stops."""
    trajectory = run(open_scene(source, scene, formulation, stay=True), Settings("dop853", points=2))
    assert trajectory.ended == "failed"
    return trajectory.outcome.t


@pytest.mark.parametrize("reduce", [False, True])
def test_where_a_constraint_vanishes(reduce: bool, tmp_path: Path) -> None:
    source = Source("spiral.yaml", SPIRAL.replace("START", "1"))
    done = drive(source, tmp_path, "in", scene="in", reduce=reduce)
    assert (
        find_stop(done) == pytest.approx(1 / 0.3, abs=1e-5) and "all coefficients of one of them vanish" in done.stderr
    )
    if not reduce:
        assert drive(source, tmp_path, "out").returncode == 0


def test_close_by_it_goes_on(tmp_path: Path) -> None:
    done = drive(board("0.401"), tmp_path, "through", "31")
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("formulation", ["", "lagrange"])
def test_gimbal_lock(formulation: str, tmp_path: Path) -> None:
    source = Source("body.yaml", body("0").text.replace("need: [w1, w2, w3, theta]", "need: [theta]"))
    assert find_stop(drive(source, tmp_path, "lock", "31", formulation=formulation)) == pytest.approx(1.0, abs=1e-5)


def test_names_of_the_driver_may_be_coordinates(tmp_path: Path) -> None:
    assert find_stop(drive(CROWDED, tmp_path)) == pytest.approx(math.pi / 2, abs=1e-9)


def test_the_model_is_the_same_without_a_driver() -> None:
    plain, driven = (emit(VESELOVA, "c", Options(driver=driver)) for driver in (False, True))
    assert {name: driven[name] for name in plain} == plain and set(driven) - set(plain) == {"ves_main.c"}


def test_the_interpolant_is_that_of_runs() -> None:
    """The driver's tables against the tableau: what it finds between steps is only as good as they are."""
    text = emit(VESELOVA, "c", Options(driver=True))["ves_main.c"]
    for name, rows in (("MORE_NODES", (METHOD.nodes[13:],)), ("MORE", METHOD.rows[12:]), ("DENSE", METHOD.dense)):
        table = re.search(rf"double {name}\[.*? = \{{(.*?)\}};", text, re.DOTALL)
        assert table is not None
        written = [float(x) for x in re.findall(r"-?\d+\.\d+", table[1])]
        assert written == [x for row in rows for x in row]


def test_a_motion_that_slides_along_a_jump(tmp_path: Path) -> None:
    """Dry friction holds the body at rest from t = 10 on, which the driver says as soon as it is there."""
    source = Source(
        "stick.yaml",
        """nhc: 1
system: stick
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: x^2/2
forces: {y: "-0.1*sign(y')"}
scenes: {go: {initial: {x: 1, y': 1}, time: [0, 12], tolerance: 1e-9, need: [x, x', y, y']}}
""",
    )
    done = drive(source, tmp_path, "go", "13")
    assert find_stop(done) == pytest.approx(10.0, abs=1e-8)
    assert "the motion is held where `y'` is zero" in done.stderr and "sticks" in done.stderr
    assert float(done.stdout.splitlines()[-1].split(",")[-1]) == pytest.approx(0.0, abs=1e-8)
