"""True singularities end a run with exit code 3, wherever the steps fall; nearness is said; ordinary scenes raise no alarm."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.language import Source, decode, read
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.task import DONE, Task
from nhc.simulate.workshop import load
from tests.support import SPECS, spec_path

BOARD = """
  through:
    initial: {theta: 0.2, p_b: 0.4, p_f: FRONT, x': 0.3, psi': 2, p_b': 1, p_f': 1}
    parameters: {sigma: 0, tau: 0}
    time: [0, 3]
    need: [x, y, theta, p_b, p_f]
"""
CLOSED = 1.1707963267948966  # p_b = p_f = pi/2


def board(front: str = "0.4") -> Source:
    """The snakeboard with a scene in which both axles turn along the board."""
    lines = [line for line in spec_path("snakeboard").read_text().splitlines() if not line.startswith("dependent")]
    return Source("board.yaml", "\n".join(lines) + BOARD.replace("FRONT", front))


def follow(source: Source, scene: str, formulation: str = "", method: str = "dop853", **more: object) -> Trajectory:
    job = open_scene(source, scene, formulation, method=method)
    return run(job, Settings(method, points=31, **more))  # type: ignore[arg-type]


@pytest.mark.sample(4)
@pytest.mark.parametrize("formulation", ["", "voronec", "multipliers"])
@pytest.mark.parametrize(
    ("method", "step"), [("dop853", 0.0), ("dopri5", 0.0), ("radau5", 0.0), ("rk4", 0.1), ("rk4", 0.013)]
)
def test_no_run_through_a_loss_of_rank(formulation: str, method: str, step: float) -> None:
    """C5: both axles along the board: nothing changes its sign there, and nothing blows up."""
    found = follow(board(), "through", formulation, method, step=step)
    assert found.ended == "failed" and found.outcome.t == pytest.approx(CLOSED, abs=1e-5)
    assert found.times[-1] < CLOSED and any("nearly" in note for note in found.notes)


def test_python_stops_where_c_does() -> None:
    c, python = (follow(board(), "through", "", "rk4", step=0.1, compiled=compiled) for compiled in (True, False))
    assert c.ended == python.ended == "failed" and c.outcome.t == pytest.approx(python.outcome.t, abs=1e-9)
    assert [note.partition(" t = ")[0] for note in c.notes] == [note.partition(" t = ")[0] for note in python.notes]


def test_close_by_it_goes_on_says_so_and_is_right() -> None:
    """A thousandth of a radian beside it the board is caught for a while; two formulations agree on what follows."""
    one, other = (follow(board("0.401"), "through", name, "auto", tolerance=1e-9) for name in ("", "multipliers"))
    assert one.ended == other.ended == "done"
    assert max(abs(a - b) for a, b in zip(one.rows[-1], other.rows[-1], strict=True)) < 1e-7
    assert any("digits are lost" in note for note in one.notes)
    assert any("the constraints nearly lose rank" in note for note in other.notes)


SPIRAL = """nhc: 1
system: spiral
about: A mass on a logarithmic spiral, whose pole it comes to at constant speed.
coordinates: [x, y]
parameters: {m: 1, b: 0.3}
T: m/2*(x'^2 + y'^2)
constraints:
  - angle: x*x' + y*y' = -b*(x*y' - y*x')
scenes: {in: {initial: {x: START, y': START}, time: [0, 5]}, out: {initial: {x: START, y': -START}, time: [0, 5]}}
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize("formulation", ["", "voronec", "multipliers"])
@pytest.mark.parametrize(("method", "start"), [("auto", "1"), ("auto", "1e4"), ("dop853", "1e-3"), ("radau5", "1")])
def test_no_run_through_a_place_where_a_constraint_vanishes(formulation: str, method: str, start: str) -> None:
    """Its coefficients vanish together, none of them before the others: at (x, y) = 0, after the length sqrt(1 + 1/b^2)."""
    source = Source("spiral.yaml", SPIRAL.replace("START", start))
    found = follow(source, "in", formulation, method)
    assert found.ended == "failed" and found.outcome.t == pytest.approx(1 / 0.3, abs=1e-5)
    assert "all coefficients of one of them vanish" in found.reason
    assert any("the constraints nearly lose rank" in note for note in found.notes)
    assert follow(source, "out", formulation, method).ended == "done"


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_what_comes_to_rest_keeps_its_size_through_all_parts_of_a_run(method: str, compiled: bool) -> None:
    """The axles stop, and their speeds go to zero as fast as e^(-1000 t) does.  A run in four parts, for looks at its stiffness and
    at the rank, takes the steps of a single part: what is left of a speed does not count as all of it.
    """
    job = open_scene(board("0.401"), "through", "multipliers", method=method)
    legs = run(job, Settings(method, 1e-9, 0.0, 3, compiled))
    one = open_scene(board("0.401"), "through", "multipliers", method=method, stay=True)
    model, _ = load(one, method, compiled)
    whole = model.integrate(Task(one.p, one.y, (0.0, 3.0), 1e-11), method, model.news())
    assert legs.ended == "done" and whole.kind == DONE
    assert legs.outcome.steps + legs.outcome.rejected < 1.1 * (whole.steps + whole.rejected)


def body(d: str) -> Source:
    """C3: Euler's angles pass their lock at a distance proportional to d."""
    text = spec_path("free_rigid_body").read_text()
    scene = f"scenes: {{lock: {{initial: {{theta: 1, w1: -1, w2: {d}}}, time: [0, 2], need: [w1, w2, w3, theta]}}}}\n"
    return Source("body.yaml", text[: text.index("scenes:")] + scene)


@pytest.mark.parametrize("formulation", ["", "lagrange"])
@pytest.mark.parametrize("method", ["dop853", "rk4"])
def test_gimbal_lock_is_a_stop(formulation: str, method: str) -> None:
    found = follow(body("0"), "lock", formulation, method, step=0.07 if method == "rk4" else 0.0)
    assert found.ended == "failed" and found.outcome.t == pytest.approx(1.0, abs=0.05 if method == "rk4" else 1e-5)


@pytest.mark.parametrize(
    ("formulation", "d", "said"),
    [
        ("", "0.2", False),
        ("", "0.01", True),
        ("", "0.0001", True),
        ("lagrange", "0.01", False),
        ("lagrange", "0.0001", True),
    ],
)
def test_near_the_lock_it_is_said(formulation: str, d: str, said: bool) -> None:
    """The spin of the free body's own axes is known from Euler's equations, which know of no angles."""
    found = follow(body(d), "lock", formulation, tolerance=1e-9)
    assert found.ended == "done" and any("digits are lost" in note for note in found.notes) == said
    text = spec_path("free_rigid_body_quaternion").read_text()
    scene = f"scenes: {{lock: {{initial: {{w1: -1, w2: {d}}}, time: [0, 2], need: [w1, w2, w3]}}}}\n"
    free = follow(Source("free.yaml", text[: text.index("scenes:")] + scene), "lock", tolerance=1e-12)
    assert found.rows[-1][:3] == pytest.approx(free.rows[-1], abs=1e-7)


def test_a_pendulum_through_its_pole() -> None:
    """Spherical angles: along a meridian nothing is felt of the pole, but phi has no meaning there."""
    text = spec_path("spherical_pendulum").read_text()
    scene = "scenes: {meridian: {initial: {theta: 1}, time: [0, 3], need: [theta, phi]}}\n"
    for step in (0.0, 0.05):
        found = follow(
            Source("pole.yaml", text[: text.index("scenes:")] + scene),
            "meridian",
            method="rk4" if step else "dop853",
            step=step,
        )
        assert found.ended == "failed" and "mass matrix" in found.reason
        assert abs(math.remainder(found.outcome.y[0], math.pi)) < 1e-3


COUPLED = """nhc: 1
system: coupled
coordinates: [x, y, z]
T: x'^2/2 + y'^2/2 + 3/2*sin(z)*x'*y' + z'^2/2
scenes: {still: {initial: {z': 1}, time: [0, 3]}}
"""


@pytest.mark.parametrize(("method", "step"), [("dop853", 0.0), ("rk4", 0.3)])
def test_a_mass_matrix_that_changes_its_sign(method: str, step: float) -> None:
    """At sin z = 2/3 the coupling outweighs the masses; at rest in x and y nothing is felt of it."""
    found = follow(Source("coupled.yaml", COUPLED), "still", method=method, step=step)
    assert found.ended == "failed" and found.outcome.t == pytest.approx(math.asin(2 / 3), abs=1e-6)
    assert "the mass matrix is singular" in found.reason


def cranks(unit: float = 1.0, factor: float = 1.0) -> Source:
    """Three cranks in a row on two couplers, in four rows; at a = 0 all bars lie on one line and may go on in several ways.

    ``unit``: of the angle a; ``factor``: what a row is multiplied by.
    """
    a = "(a/u)"
    return Source(
        "cranks.yaml",
        "nhc: 1\nsystem: cranks\ncoordinates: [a, b, c, e, f]\n"
        f"parameters: {{u: {unit}, s: {factor}, k: 3}}\n"
        f"T: ((a'/u)^2 + 2*b'^2 + c'^2 + e'^2 + 3*f'^2)/2 + 0.3*a'/u*b'*cos({a} - b) + 0.2*c'*f'*cos(c - f)\n"
        f"V: k*sin({a})\nconstraints:\n"
        f"  - s*(-sin({a})*a'/u - 2*sin(b)*b' + sin(c)*c') = 0\n"
        f"  - cos({a})*a'/u + 2*cos(b)*b' - cos(c)*c' = 0\n"
        "  - -sin(c)*c' - 2*sin(f)*f' + sin(e)*e' = 0\n"
        "  - cos(c)*c' + 2*cos(f)*f' - cos(e)*e' = 0\n"
        f"scenes: {{go: {{initial: {{a: {unit}, c: 1, e: 1, a': {-2 * unit}, c': -2, e': -2}}, time: [0, 3]}}}}\n",
    )


@pytest.mark.sample(3)
@pytest.mark.parametrize(("unit", "factor"), [(1.0, 1.0), (1e6, 1.0), (1.0, 1e-5)])
@pytest.mark.parametrize(("method", "step"), [("dop853", 0.0), ("dopri5", 0.0), ("radau5", 0.0), ("rk4", 0.1)])
def test_no_run_through_a_loss_of_rank_of_many_rows(method: str, step: float, unit: float, factor: float) -> None:
    """Their minors are too many to be written down: the multiplier form tells it itself, whatever the units."""
    found = follow(cranks(unit, factor), "go", "multipliers", method, step=step)
    assert found.ended == "failed" and abs(found.outcome.y[0]) < 1e-5 * unit
    assert "do not determine the accelerations here" in found.reason
    assert any("hardly determine the accelerations" in note for note in found.notes)


def test_python_stops_at_many_rows_where_c_does() -> None:
    c, python = (follow(cranks(), "go", "multipliers", "rk4", step=0.1, compiled=how) for how in (True, False))
    assert python.ended == "failed" and python.outcome.t == pytest.approx(c.outcome.t, abs=1e-9)
    assert [note.partition(" t = ")[0] for note in c.notes] == [note.partition(" t = ")[0] for note in python.notes]


@pytest.mark.parametrize("method", ["dop853", "radau5"])
def test_gimbal_lock_of_the_multiplier_form_is_a_stop(method: str) -> None:
    """A disk whose axis goes through the vertical turns a wheel: the rows stay independent, the masses do not stay regular."""
    source = Source(
        "gimbal.yaml",
        "nhc: 1\nsystem: gimbal\ncoordinates: [phi, theta, psi, x]\ndefine: {w: psi' + cos(theta)*phi'}\n"
        "T: theta'^2/2 + sin(theta)^2*phi'^2/2 + w^2 + x'^2/2\nconstraints: [x' - w = 0]\n"
        "scenes: {lock: {initial: {theta: 1.01, theta': -1}, time: [0, 3]}}\n",
    )
    found = follow(source, "lock", "multipliers", method)
    assert found.ended == "failed" and found.outcome.t == pytest.approx(1.01, abs=1e-5)
    assert "do not determine the accelerations here" in found.reason


def test_what_the_multiplier_form_loses_near_a_lock_is_said() -> None:
    found = follow(Source("disk.yaml", spec_path("rolling_disk").read_text()), "bounce", "multipliers")
    assert found.ended == "done" and any("digits are lost" in note for note in found.notes)


SCENES = [(path.stem, scene.name) for path in sorted(SPECS.glob("*.yaml")) for scene in decode(read(str(path))).scenes]
NEAR = {("rolling_disk", "bounce")}
"""A disk that falls almost flat; a top a hundredth of a radian from upright loses two digits of its Euler's angles, no more."""


@pytest.mark.slow
@pytest.mark.parametrize(("name", "scene"), SCENES)
def test_no_scene_of_the_gallery_raises_an_alarm(name: str, scene: str) -> None:
    found = run(open_scene(read(str(spec_path(name))), scene), Settings())
    assert found.ended == "done"
    assert any("digits are lost" in note for note in found.notes) == ((name, scene) in NEAR)
    assert all("digits are lost" in note for note in found.notes)


# --- the command --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_the_command_tells_place_reason_and_help(
    how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec, target = tmp_path / "board.yaml", tmp_path / "board.csv"
    spec.write_text(board().text)
    code = main(["run", str(spec), "--scene", "through", "-f", "multipliers", "-o", str(target), *how])
    out, err = capsys.readouterr()
    assert (code, out) == (3, "") and not target.exists()
    for part in (
        "fails at t = 1.17079",
        "the constraints lose rank here",
        "p_b = 1.570",
        "no formulation has a motion",
    ):
        assert part in err
    spec.write_text(body("0").text)
    code = main(["run", str(spec), "-f", "lagrange", "-o", str(target), *how])
    out, err = capsys.readouterr()
    assert (code, out) == (3, "") and not target.exists() and "such as a `rotation:`" in err


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_a_root_of_a_negative_number_is_no_singular_mass_matrix(
    how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """C hands a NaN on to the pivots, Python raises before them: the reason is the same, and the true one."""
    text = "nhc: 1\nsystem: root\ncoordinates: [x, y]\nT: x'^2*sqrt(y)/2 + y'^2/2 + x'*y'*y/4\n"
    path = tmp_path / "root.yaml"
    path.write_text(text + "scenes: {go: {initial: {x': 0.3, y: -0.2}, time: [0, 1]}}\n")
    assert main(["run", str(path), *how]) == 3
    said = capsys.readouterr().err
    assert "`sqrt(y)` has no real, finite value" in said and "mass matrix" not in said


@pytest.mark.parametrize("formulation", ["voronec", "chaplygin"])
def test_a_choice_that_is_singular_is_not_blamed_on_the_masses(
    formulation: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """The roller racer straight ahead: x' and y' do not follow, as sin(phi) = 0; the masses are regular there.

    The mass matrix on theta' and phi' has that sine squared in its denominators, so that its pivots are lost first.
    """
    assert main(["run", "roller_racer", "-f", formulation, "--stay", "--points", "2"]) == 3
    said = capsys.readouterr().err
    assert "the constraints cannot be solved for x', y'" in said and "mass matrix" not in said
    assert "leave `--stay` out" in said


FACTORED = """\
nhc: 1
system: factored
coordinates: [x, y, th]
T: (x'^2 + y'^2)/2 + th'^2/4
V: x
constraints: ["{factor}*(-sin(th)*x' + cos(th)*y') = 0"]
scenes: {{go: {{initial: {{x: 1, th: 0.4, x': 1}}, time: [0, 5]}}}}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize("formulation", ["auto", "voronec", "multipliers"])
@pytest.mark.parametrize(("factor", "stops"), [("x", True), ("x*sin(t/2)^2", True), ("exp(-9*x)", False)])
def test_a_constraint_that_vanishes_as_a_whole_ends_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], formulation: str, factor: str, stops: bool
) -> None:
    """Measured against its own size it is as good as ever; a factor that only becomes small does no harm."""
    path = tmp_path / "factored.yaml"
    path.write_text(FACTORED.format(factor=factor).replace("time: [0", "time: [0.1"))
    code = main(["run", str(path), "--points", "2", "-f", formulation])
    out, err = capsys.readouterr()
    assert code == (3 if stops else 0) and ("constraints lose rank" in err) is stops
    assert (out == "") is stops


@pytest.mark.sample(3)
@pytest.mark.parametrize("formulation", ["auto", "voronec", "multipliers"])
@pytest.mark.parametrize("factor", ["k", "k^2", "sin(k)^3", "k^2*x"])
def test_a_constraint_with_a_parameter_in_front_that_is_zero_in_a_scene(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], formulation: str, factor: str
) -> None:
    """The velocities follow without the factor; where it is zero nothing holds them."""
    path = tmp_path / "loose.yaml"
    text = FACTORED.format(factor=factor).replace("T:", "parameters: {k: 2}\nT:")
    for scene, code in ((text, 0), (text.replace("time:", "parameters: {k: 0}, time:"), 3)):
        path.write_text(scene.replace("[0, 5]", "[0, 1]"))
        assert main(["run", str(path), "--points", "2", "-f", formulation]) == code
        out, err = capsys.readouterr()
        assert ("constraints lose rank" in err) is (out == "") is (code == 3)


MULTIPLIED_OUT = {
    "x^2 + 2*x": ("-x^2*sin(th)*x' - 2*sin(th)*x*x' + x^2*cos(th)*y' + 2*cos(th)*x*y' = 0", 0.0),
    "x^2*(x + 2)": ("-(x^3*sin(th) + 2*x^2*sin(th))*x' + (x^3*cos(th) + 2*x^2*cos(th))*y' = 0", 0.0),
    "x*(2 + cos(th))": ("-(2*x*sin(th) + x*sin(th)*cos(th))*x' + (2*x*cos(th) + x*cos(th)^2)*y' = 0", 0.0),
    "x*(x + y - 1e-4)": (
        "(-x^2*sin(th) - x*y*sin(th) + x*sin(th)/10000)*x' + (x^2*cos(th) + x*y*cos(th) - x*cos(th)/10000)*y' = 0",
        0.001,
    ),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("formulation", ["auto", "multipliers"])
@pytest.mark.parametrize("factor", MULTIPLIED_OUT)
def test_a_shared_factor_that_was_multiplied_out_ends_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], formulation: str, factor: str
) -> None:
    """Its terms vanish with it where they have x as a factor, so that no size of them tells; nor does the sign of x (x + y) where
    both change theirs within one step.
    """
    row, y = MULTIPLIED_OUT[factor]
    path = tmp_path / "expanded.yaml"
    text = FACTORED.replace("{factor}*(-sin(th)*x' + cos(th)*y') = 0", row).replace("{{", "{").replace("}}", "}")
    path.write_text(text.replace("x': 1}", f"y: {y}, x': -1, y': {-math.tan(0.4)}}}"))
    assert main(["run", str(path), "--points", "2", "-f", formulation]) == 3
    out, err = capsys.readouterr()
    assert "constraints lose rank" in err and out == ""


SHARED_MINORS = """\
nhc: 1
system: shared_minors
coordinates: [x, y, z, th]
T: (x'^2 + y'^2 + z'^2)/2 + 3*th'^2/10
V: x/10 + y^2/5
constraints:
  - z' - y*x' - x^2*y'/3 = 0
  - z' - y*x' - x^2*y'/3 + (x^2 + x/2)*(sin(th)*y' - cos(th)*x') + th'*x^2 + th'*x/2 = 0
scenes: {go: {initial: {x: 0.5, y: 0.2, th: 0.3, x': -1, y': -0.3}, time: [0, 3]}}
"""


@pytest.mark.parametrize("formulation", ["auto", "multipliers"])
def test_a_factor_that_only_the_minors_share_ends_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], formulation: str
) -> None:
    """At x = 0 both constraints are the same, and no row vanishes."""
    path = tmp_path / "minors.yaml"
    path.write_text(SHARED_MINORS)
    assert main(["run", str(path), "--project", "--points", "2", "-f", formulation]) == 3
    said = capsys.readouterr().err
    assert "t = 0.50643" in said and "constraints lose rank" in said


@pytest.mark.parametrize("python", [False, True])
@pytest.mark.parametrize(
    ("rest", "said"),
    [
        ("V: sqrt(x) + y\n", "`V` has no finite value, or slope\n"),
        ("constraints: [\"x*x' + y*y' = 0\"]\n", "no formulation has a motion: let the scene start elsewhere"),
    ],
)
def test_what_ends_a_run_at_its_start(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], rest: str, said: str, python: bool
) -> None:
    """A slope that is infinite where its function has a value; a start at which there is no `before` to end the scene."""
    path = tmp_path / "begin.yaml"
    head = "nhc: 1\nsystem: begin\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\n"
    path.write_text(f"{head}{rest}scenes: {{go: {{initial: {{z': 1}}, time: [0, 1]}}}}\n")
    assert main(["run", str(path), *(["--python"] if python else [])]) == 3
    out, err = capsys.readouterr()
    assert said in err and out == ""
