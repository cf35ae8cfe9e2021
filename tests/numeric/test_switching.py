"""Runs through places where the dependent choice is singular: other formulations take over, and the trajectory is the same."""

from __future__ import annotations

import csv
import io
import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.language import Source, read
from nhc.mechanics.choosing.conditioning import GAIN
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run
from tests.support import spec_path

SKATER = """nhc: 1
system: skater
about: A skate on a spring to the middle of the rink; its torque turns it through all headings, to and fro.
coordinates: [x, y, phi]
parameters: {m: 1.3, J: 0.2, k: 0.7, tau: 1.1, c: 0.1}
T: m/2*(x'^2 + y'^2) + J/2*phi'^2
V: k/2*(x^2 + y^2)
forces: {phi: "tau*sin(0.9*t) - c*phi'"}
constraints:
  - edge: sin(phi)*x' - cos(phi)*y' = 0
scenes:
  spin:
    initial: {x: 1, y: 0.4, phi: 0.3, phi': 2}
    time: [0, 12]
    need: [x, y, phi, x', y', phi']
"""

WELL = """nhc: 1
system: ball_in_a_turning_well
about: A ball rolls inside a vertical cylinder that turns (Neimark and Fufaev 1972); solved for rates of its quaternion.
coordinates: [beta, z]
rotation: {S: {velocities: [w_x, w_y, w_z], frame: space}}
parameters: {m: 1, a: 0.1, R: 1, g: 9.81, Om: 1}
T: m/2*((R - a)^2*beta'^2 + z'^2) + m*a^2/5*(w_x^2 + w_y^2 + w_z^2)
V: m*g*z
constraints:
  - up: z' + a*(w_x*sin(beta) - w_y*cos(beta)) = 0
  - around: (R - a)*beta' + a*w_z = R*Om
scenes:
  golf: {initial: {beta': 3}, time: [0, 2.1], need: [z]}
"""


BRICARD = """nhc: 1
system: bricard
about: Six links, each hinge at right angles to the next (Bricard 1927); the sixth equation of closure follows from five.
coordinates: [a1, a2, a3, a4, a5, a6]
T: (a1'^2 + 2*a2'^2 + a3'^2*(2+cos(a2)) + a4'^2 + 3*a5'^2 + a6'^2)/2 + a1'*a2'*cos(a1-a2)/3
V: sin(a1)/2 + cos(a3)/3
holonomic:
  - (-sin(a1)*sin(a3) + cos(a1)*cos(a2)*cos(a3))*(-sin(a1)*sin(a3) + cos(a1)*cos(a2)*cos(a3) + cos(a1)*cos(a2) +
    cos(a1)) + (sin(a2)*cos(a3) + sin(a2))*sin(a2)*cos(a3) + (sin(a1)*cos(a2)*cos(a3) +
    sin(a3)*cos(a1))*(sin(a1)*cos(a2)*cos(a3) + sin(a1)*cos(a2) + sin(a1) + sin(a3)*cos(a1)) - sin(a4)*sin(a6) +
    cos(a4)*cos(a5)*cos(a6) + cos(a4)*cos(a5) + cos(a4) = 0
  - (sin(a2)*cos(a3) + sin(a2))*cos(a2) - (-sin(a1)*sin(a3) + cos(a1)*cos(a2)*cos(a3) + cos(a1)*cos(a2) +
    cos(a1))*sin(a2)*cos(a1) - (sin(a1)*cos(a2)*cos(a3) + sin(a1)*cos(a2) + sin(a1) +
    sin(a3)*cos(a1))*sin(a1)*sin(a2) + sin(a4)*cos(a5)*cos(a6) + sin(a4)*cos(a5) + sin(a4) + sin(a6)*cos(a4) = 0
  - (sin(a1)*cos(a3) + sin(a3)*cos(a1)*cos(a2))*(-sin(a1)*sin(a3) + cos(a1)*cos(a2)*cos(a3) + cos(a1)*cos(a2) +
    cos(a1)) + (sin(a2)*cos(a3) + sin(a2))*sin(a2)*sin(a3) + (sin(a1)*sin(a3)*cos(a2) -
    cos(a1)*cos(a3))*(sin(a1)*cos(a2)*cos(a3) + sin(a1)*cos(a2) + sin(a1) + sin(a3)*cos(a1)) - sin(a5)*cos(a6) -
    sin(a5) = 0
  - -sin(a2)*cos(a1) - sin(a4)*cos(a5)*cos(a6) - sin(a6)*cos(a4) = 0
  - sin(a1)*cos(a3) + sin(a3)*cos(a1)*cos(a2) + sin(a5)*cos(a6) = 0
scenes:
  s:
    initial:
      {a1: 1.340199, a2: {near: 1.757925}, a3: {near: 1.340199}, a4: {near: 1.757925},
       a5: {near: 1.340199}, a6: {near: 1.757925}, a1': 2}
    time: [0, 1]
"""


def forced(text: str, dependent: str) -> Source:
    """The spec with these dependent velocities, its own quasi-velocities left out."""
    kept = [line for line in text.splitlines() if not line.startswith("dependent:")]
    return Source("forced.yaml", "\n".join([*kept, f"dependent: [{dependent}]", ""]))


def follow(source: Source, formulation: str, tolerance: float, end: float = 0.0, compiled: bool = True) -> Trajectory:
    names = tuple(c for c in open_scene(source).system.q_names)
    job = open_scene(source, formulation=formulation, needs=(*names, *(f"{name}'" for name in names)))
    job = replace(job, time=(0.0, end)) if end else job
    return run(job, Settings("dop853", tolerance, points=301, compiled=compiled))


def apart(found: Trajectory, exact: Trajectory) -> float:
    assert found.ended == exact.ended == "done" and found.times == exact.times
    assert found.headings == exact.headings
    sizes = [max(abs(row[k]) for row in exact.rows) for k in range(len(exact.headings))]
    pairs = zip(found.rows, exact.rows, strict=True)
    return max(
        abs(a - b) / max(size, 1e-3 * max(sizes)) for f, e in pairs for a, b, size in zip(f, e, sizes, strict=True)
    )


@pytest.mark.parametrize("dependent", ["x", "y"])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
def test_every_choice_becomes_singular_and_the_run_goes_on(dependent: str, tolerance: float) -> None:
    """The skater passes through several turns: solved for x' or for y' alone it would stop a dozen times."""
    exact = follow(Source("skater.yaml", SKATER), "multipliers", 1e-12)
    found = follow(forced(SKATER, dependent), "voronec", tolerance)
    headings = [row[2] for row in exact.rows]
    assert max(headings) - min(headings) > 2 * math.pi
    changes = [note for note in found.notes if "goes on with" in note]
    assert len(changes) >= 5 and f"voronec solved for {dependent}'" in changes[0]
    assert apart(found, exact) < 100 * tolerance


@pytest.mark.parametrize("tolerance", [1e-6, 1e-7])
def test_no_step_goes_over_a_singular_place_or_close_to_it(tolerance: float) -> None:
    """Near a pole of the rates the estimated errors are thousands of times too small: 30 changes once lost 3e-4 of the motion."""
    source = Source("well.yaml", WELL)
    exact = follow(source, "euler-lagrange", 1e-11)
    found = follow(source, "voronec", tolerance)
    assert len(found.notes) > 6 and apart(found, exact) < 10 * tolerance


def test_python_changes_where_c_does() -> None:
    c, python = (follow(forced(SKATER, "x"), "voronec", 1e-6, 3.0, compiled) for compiled in (True, False))
    told = [[note.partition("the run")[2] for note in found.notes] for found in (c, python)]
    assert told[0] == told[1] and abs(c.outcome.steps - python.outcome.steps) <= 3 and apart(c, python) < 1e-6


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "dependent"),
    [  # C4 of the atlas: each of these blocks becomes singular in the scene
        ("chaplygin_sleigh", "y"),
        ("chaplygin_sleigh", "x"),
        ("snakeboard", "x, y"),
        ("roller_racer", "x, y"),
        ("roller_racer", "y, phi"),
        ("n_trailer3", "x, theta1, theta2, theta3"),
        ("skate_incline", "y"),
    ],
)
def test_blocks_of_the_gallery(name: str, dependent: str) -> None:
    """The error stays within 100 times the tolerance, and the columns are those that were asked for."""
    source = read(str(spec_path(name)))
    exact = follow(source, "multipliers", 1e-12)
    found = follow(forced(source.text, dependent), "voronec", 1e-10)
    assert apart(found, exact) < 1e-8
    assert found.headings == tuple(f"{q}" for q in exact.headings)


def test_a_regular_choice_is_left_alone() -> None:
    for name in ("vertical_disk", "chaplygin_sleigh", "roller_racer", "n_trailer3", "diff_drive"):
        assert run(open_scene(read(str(spec_path(name)))), Settings()).notes == ()


def test_it_does_not_chatter() -> None:
    """A skate that swings about the heading where x' and y' serve equally well changes once at most; about a singular one, too."""
    text = SKATER.replace("tau*sin(0.9*t) - c*phi'", "-40*(phi - HEADING)").replace("phi: 0.3, phi': 2", "phi: START")
    for heading, start in (("pi/4", "0.6"), ("pi/2", "1.3"), ("pi/2 - 0.06", "1.3")):
        source = Source("swing.yaml", text.replace("HEADING", heading).replace("START", start))
        found = follow(forced(source.text, "y"), "voronec", 1e-8)
        changes = [note for note in found.notes if "goes on with" in note]
        assert len(changes) == (0 if heading == "pi/4" else 1)
        assert apart(found, follow(source, "multipliers", 1e-11)) < 1e-6
    assert GAIN > 2


def test_a_start_that_is_singular_for_the_choice() -> None:
    """The sleigh starts along x: solved for x' there is no first step."""
    source = forced(SKATER.replace("phi: 0.3", "phi: 0"), "x")
    found = follow(source, "voronec", 1e-8)
    assert "at t = 0 the run goes on with voronec solved for y'" in found.notes[0]
    assert apart(found, follow(source, "multipliers", 1e-12)) < 1e-6


def test_backwards_with_an_event_and_with_fixed_steps() -> None:
    source = forced(SKATER, "x")
    jobs = (open_scene(source, formulation=name, needs=("x", "y", "phi")) for name in ("voronec", "multipliers"))
    back, exact = (run(replace(job, time=(0.0, -6.0)), Settings("dop853", 1e-10)) for job in jobs)
    assert any("goes on with" in note for note in back.notes) and back.times[-1] == -6.0
    assert apart(back, exact) < 1e-8
    for method in ("rk4", "gauss6", "radau5"):
        job = open_scene(forced(SKATER, "x"), formulation="voronec", until="phi - 5", method=method)
        found = run(job, Settings(method, 1e-8, 0.0 if method == "radau5" else 2e-3, points=50))
        assert found.ended == "event" and found.rows[-1][2] == pytest.approx(5.0, abs=1e-9)
        assert any("goes on with" in note for note in found.notes)


# --- the command --------------------------------------------------------------------------------------------


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(["run", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_the_command_goes_on_and_says_so(
    how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "skater.yaml"
    spec.write_text(forced(SKATER, "x").text)
    arguments = [str(spec), "--points", "7", "-f", "voronec"]
    code, out, err = call(capsys, *arguments, *how)
    rows = list(csv.reader(io.StringIO(out)))
    assert code == 0 and rows[0] == ["t", "x", "y", "phi", "x'", "y'", "phi'"] and len(rows) == 8
    assert "the run goes on with voronec solved for y' (conditioning 1)" in err
    code, out, err = call(capsys, *arguments, "--stay", *how)
    assert (code, out) == (3, "") and "cannot be solved for x'" in err and "leave `--stay` out" in err


def test_a_start_by_a_quasi_velocity_that_the_other_choice_does_not_have() -> None:
    text = SKATER.replace("scenes:", "quasi_velocities: {u: x'}\nscenes:").replace("phi': 2}", "phi': 2, u: 0.5}")
    source = Source("skater.yaml", text)
    found = follow(source, "euler-lagrange", 1e-8)
    assert any("euler-lagrange with v, phi'" in note and "in place of" in note for note in found.notes)
    assert apart(found, follow(source, "multipliers", 1e-11)) < 1e-6


def test_a_needed_quasi_velocity_outlives_a_change_of_the_coframe() -> None:
    """x' as a quasi-velocity is no free velocity where the blade points along y; it is still a velocity."""
    text = SKATER.replace("scenes:", "quasi_velocities: {v: x', w: phi'}\nscenes:")
    text = text.replace("phi: 0.3,", "phi: pi/2,").replace("[0, 12]", "[0, 3]").replace("y', phi']", "y', phi', v, w]")
    job = open_scene(Source("quasi.yaml", text))
    found = run(job, Settings("dop853", 1e-10, points=31))
    assert found.ended == "done" and any("goes on with" in note for note in found.notes)
    places = [found.headings.index(name) for name in ("x'", "phi'", "v", "w")]
    for row in found.rows:
        rates = [row[k] for k in places]
        assert rates[2:] == pytest.approx(rates[:2], rel=1e-9, abs=1e-12)
    assert abs(found.rows[-1][places[0]]) > 0.01


@pytest.mark.parametrize("method", ["scipy-dop853", "scipy-lsoda"])
def test_other_solvers_end_where_the_choice_becomes_singular(
    method: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """They would step across, with results that are wrong beyond; an event of the user's is theirs as ever."""
    spec = tmp_path / "skater.yaml"
    spec.write_text(forced(SKATER, "x").text)
    arguments = [str(spec), "--method", method, "--points", "2"]
    code, out, err = call(capsys, *arguments, "-f", "voronec")
    assert (code, out) == (3, "") and "cannot be solved for x'" in err and f"leave `--method {method}` out" in err
    code, out, _ = call(capsys, *arguments, "-f", "multipliers", "--until", "phi - 1")
    assert code == 0 and float(out.split()[-1].split(",")[3]) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("formulation", ["voronec", "euler-lagrange"])
def test_pivots_that_vanish_where_the_block_is_regular(formulation: str) -> None:
    """Five rows without constant pivots are eliminated in a fixed order, which fails where all angles of the linkage are right
    ones: its constraints are independent there, and rows are exchanged near that place.
    """
    source = Source("bricard.yaml", BRICARD)
    found = follow(source, formulation, 1e-10)
    assert not any("multipliers" in note or "singular" in note for note in found.notes)
    assert apart(found, follow(source, "multipliers", 1e-10)) < 1e-8


def test_a_mass_matrix_that_is_lost_for_its_coframe_is_a_reason_to_change() -> None:
    """A stone whose shape is not quite an ellipsoid's: the last level at which its coframe is weak is passed long before."""
    text = spec_path("rattleback").read_text(encoding="utf-8")
    source = Source("stone.yaml", text.replace(" + c^2*mu3^2)", ")").replace("time: [0, 5]", "time: [0, 1.6]"))
    ended = [run(open_scene(source, "reference", f), Settings("dop853", 1e-9)) for f in ("", "multipliers")]
    assert [found.ended for found in ended] == ["done", "done"]
    last, other = (dict(zip(found.headings, found.rows[-1], strict=True)) for found in ended)
    assert all(abs(last[name] - other[name]) < 1e-5 * max(1, abs(other[name])) for name in ("alpha", "beta", "gamma"))


def test_rates_of_the_constraints_divide_by_nothing_that_velocities_do_not() -> None:
    """Without the rear wheel's inertia other velocities are kept: six constraints are then solved for the others, and again for
    the rates of these.  Upright, some pivots of the second time were zero, and no guard had looked at them.
    """
    text = spec_path("bicycle").read_text(encoding="utf-8").replace("T: T_R + T_B", "T: T_B")
    ended = [
        run(open_scene(Source("b.yaml", text), "reference", f), Settings("dop853", 1e-9)) for f in ("", "multipliers")
    ]
    assert [found.ended for found in ended] == ["done", "done"]
    assert (
        max(abs(a - b) for own in zip(*(f.rows for f in ended), strict=True) for a, b in zip(*own, strict=True)) < 1e-7
    )


@pytest.mark.slow
def test_a_coframe_of_six_rows_is_left_before_it_is_singular() -> None:
    """A bicycle whose determinant is everywhere a small part of what its rows allow."""
    text = (
        spec_path("bicycle")
        .read_text(encoding="utf-8")
        .replace("  sz: sin(lam)*e1z + cos(lam)*e3z", "  sz: sin(lam)*e1z")
    )
    ended = [
        run(open_scene(Source("b.yaml", text), "reference", f), Settings("dop853", 1e-9)) for f in ("", "multipliers")
    ]
    assert [found.ended for found in ended] == ["done", "done"]
    assert any("goes on with" in note for note in ended[0].notes)
    rows = zip(*(found.rows for found in ended), strict=True)
    assert max(abs(a - b) for own in rows for a, b in zip(*own, strict=True)) < 1e-4


def test_what_is_watched_has_values_where_a_pivot_vanishes() -> None:
    """The rear wheel of a bicycle at a given speed ahead: upright, the pivots of its velocities are zero, and so are those of an
    event on a velocity.
    """
    text = re.sub(r"\n  x: \{unit: m.*", "", spec_path("bicycle").read_text(encoding="utf-8"))
    text = text.replace("parameters:\n", "parameters:\n  ahead: {value: 4.6, unit: m/s}\n")
    text = text.replace("define:\n", "define:\n  x: ahead*t\n").replace("rear_x: x' +", "rear_x: ahead +")
    text = re.sub(r"\ndependent: .*", "", text.split("  upright_again:")[0])
    source = Source("b.yaml", text)
    ended = [
        run(open_scene(source, "reference", f, until="pitch' - 1e-3"), Settings("dop853", 1e-9))
        for f in ("", "multipliers")
    ]
    assert [found.ended for found in ended] == ["event", "event"]
    assert ended[0].outcome.t == pytest.approx(ended[1].outcome.t, abs=1e-7)
