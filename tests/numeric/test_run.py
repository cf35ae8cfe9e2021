"""Runs of gallery scenes: C and Python agree, orders, accuracy, events, failures, and what the command writes."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from nhc.cli.entry import main
from nhc.language import Source, read
from nhc.report.page import list_charts
from nhc.report.trajectory import npz_bytes
from nhc.simulate.c import compile as compiling
from nhc.simulate.c.compile import CacheError, CompileError, build, cache_folder
from nhc.simulate.c.source import write_natural, write_source
from nhc.simulate.methods import METHODS, RUNGE_KUTTA, STRUCTURE, is_adaptive
from nhc.simulate.opening import open_scene
from nhc.simulate.peers import SCIPY
from nhc.simulate.prepare import Job
from nhc.simulate.requests import RunError
from nhc.simulate.run import Settings, Trajectory, run
from tests.conftest import Compile
from tests.support import COMPILER, STRICT, formulations, interrupt, reference, spec_path


def job_of(
    name: str,
    method: str = "dop853",
    end: float = 0.0,
    formulation: str = "",
    needs: tuple[str, ...] = (),
    until: str = "",
) -> Job:
    job = open_scene(read(str(spec_path(name))), "", formulation, needs=needs, until=until, method=method)
    return replace(job, time=(0.0, end)) if end else job


def last(job: Job, method: str, step: float = 0.0, tolerance: float = 0.0) -> list[float]:
    found = run(job, Settings(method, tolerance, step, 2))
    assert found.ended == "done", found.reason
    return list(found.rows[-1])


def distance(a: list[float], b: list[float]) -> float:
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


@pytest.mark.sample(3)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["contact_oscillator_eps", "chaplygin_sleigh"])
def test_order_by_slope(name: str, method: str) -> None:
    if method == "perlmutter" and name == "chaplygin_sleigh":
        with pytest.raises(RunError, match="mass matrix is not constant"):
            job_of(name, method)
        return
    job, order = job_of(name, method, 2.0), (RUNGE_KUTTA.get(method) or STRUCTURE[method]).order
    # far enough down for the slope, far enough above rounding
    steps = {"dop853": (0.2, 0.1), "gauss6": (0.1, 0.05), "dopri5": (0.025, 0.0125)}.get(method, (0.05, 0.025))
    exact = last(job_of(name, end=2.0), "dop853", tolerance=1e-12)
    coarse, fine = (distance(last(job, method, h), exact) for h in steps)
    assert math.log2(coarse / fine) == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_c_and_python_take_the_same_steps(method: str) -> None:
    for name, formulation in (("chaplygin_sleigh", "multipliers"), ("pumped_pendulum", "")):
        job = job_of(name, method, 1.0, formulation)
        step = 0.0 if is_adaptive(method) else 0.02
        compiled, interpreted = (run(job, Settings(method, 1e-4, step, 17, c)) for c in (True, False))
        assert compiled.compiled and not interpreted.compiled
        assert compiled.outcome.steps == interpreted.outcome.steps > 3
        for a, b in zip(compiled.rows, interpreted.rows, strict=True):
            assert distance(list(a), list(b)) < 1e-11


@pytest.mark.sample(3)
@pytest.mark.parametrize("entry", reference("final_states"), ids=lambda e: e["system"])
def test_the_tolerance_is_honoured_at_the_end(entry: dict[str, Any]) -> None:
    """By the default formulation and method, where the motion does not magnify errors by itself."""
    job = open_scene(read(str(spec_path(entry["system"]))), "reference")
    names = [c.name for c in job.program.coordinates]
    job = open_scene(read(str(spec_path(entry["system"]))), "reference", needs=tuple(names))
    for tolerance in (1e-5, 1e-9):
        found = run(job, Settings(tolerance=tolerance))
        assert found.times[-1] == job.time[1] == entry["t_end"]
        sizes = [max(abs(row[k]) for row in found.rows) for k in range(len(names))]
        wanted = [float(x) for x in entry["q_end"]]
        for value, exact, size in zip(found.rows[-1], wanted, sizes, strict=True):
            assert abs(value - exact) <= tolerance * max(size, 1e-3 * max(sizes)) * max(1.0, entry["sensitivity"])


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_the_emitted_source_is_clean(method: str, tmp_path: Path) -> None:
    """Warnings are errors for the model and its integrator together, with everything that a run can have in it."""
    job = open_scene(read(str(spec_path("holonomic_pendulum"))), "", "multipliers", until="x", method=method)
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds)
    for file, text in sources.items():
        (tmp_path / file).write_text(text)
    done = subprocess.run(
        [COMPILER, *STRICT, "-O1", "-c", "holonomic_pendulum_run.c"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", STRUCTURE)
def test_structure_in_c_and_in_python(method: str, tmp_path: Path) -> None:
    """The same motion from both, and C that compiles without a warning, with constraints and without."""
    for name in ("contact_oscillator", "pendulum", "chaplygin_sleigh"):
        if name == "chaplygin_sleigh" and method == "perlmutter":
            continue
        job = job_of(name, method, 1.0)
        compiled, interpreted = (run(job, Settings(method, step=0.05, points=13, compiled=c)) for c in (True, False))
        assert compiled.compiled and not interpreted.compiled
        assert compiled.outcome.steps == interpreted.outcome.steps == 20
        for a, b in zip(compiled.rows, interpreted.rows, strict=True):
            assert distance(list(a), list(b)) < 1e-11
        for file, text in write_natural(job.program, STRUCTURE[method]).items():
            (tmp_path / file).write_text(text)
        command = [COMPILER, *STRICT, "-O1", "-c", f"{name}_run.c"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr


def test_the_constraints_are_kept() -> None:
    """C1: the multiplier form drifts; brought back after each step it does not, at velocity and at position level."""
    source = read(str(spec_path("holonomic_pendulum")))
    for hold, low, high in ((True, 0.0, 1e-14), (False, 1e-3, 1.0)):
        job = open_scene(source, formulation="multipliers", method="rk4", hold=hold, checks=True)
        found = run(job, Settings("rk4", step=0.05, points=40))
        for group in ("residual", "position"):
            (k,) = [k for k, column in enumerate(job.checks) if column.group == group]
            assert low <= max(abs(row[k]) for row in found.checks) <= high


@pytest.mark.parametrize(
    ("name", "method", "low", "high"),
    [  # C8: the energy's error, first tenth and last
        ("contact_oscillator", "leapfrog", 0.025, 0.035),
        ("contact_oscillator", "dla", 0.005, 0.02),
        ("contact_oscillator", "perlmutter", 0.020, 0.028),
        ("contact_oscillator", "midpoint", 0.0025, 0.004),
        ("contact_oscillator", "energy", 0.0, 1e-12),
    ],
)
def test_energy_over_long_times(name: str, method: str, low: float, high: float) -> None:
    job = job_of(name, method, 120.0, needs=("energy",))
    found = run(job, Settings(method, step=0.2, points=601))
    error = [abs(row[0] - found.rows[0][0]) for row in found.rows]
    first, final = max(error[:60]), max(error[-60:])
    assert low <= final <= high
    assert final <= 1.25 * max(first, 1e-13) + 1e-13


@pytest.mark.parametrize("step", [2e-3, 6.25e-4, 2e-4])
def test_short_steps_keep_the_energy_too(step: float) -> None:
    """The discrete gradient divides a difference of energies by the square of the step: its rounding must not stop Newton's
    iteration.  The end is the catalogue's closed form.
    """
    job = job_of("chaplygin_sleigh", "energy", 10.0, needs=("x", "y", "theta", "energy"))
    found = run(job, Settings("energy", step=step, points=3))
    assert found.ended == "done"
    end = (-10.9308426171971, 5.14045341778171, 2.84991153461490)
    assert max(abs(a - b) for a, b in zip(found.rows[-1], end, strict=False)) < 10.0 * step**2
    assert abs(found.rows[-1][3] - found.rows[0][3]) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("method", ["leapfrog", "dla", "perlmutter", "midpoint"])
def test_energy_does_not_drift(method: str) -> None:
    for name, h in (("contact_oscillator", 0.2), ("nh_particle_pot", 0.1)):
        found = run(
            job_of(name, method, 2000.0, needs=("energy",)), Settings(method, step=h, points=round(2000 / h) + 1)
        )
        error, tenth = [abs(row[0] - found.rows[0][0]) for row in found.rows], len(found.rows) // 10
        assert max(error[-tenth:]) <= 1.1 * max(error[:tenth])


def test_an_integrator_without_structure_does_drift() -> None:
    found = run(job_of("contact_oscillator", "rk4", 400.0, needs=("energy",)), Settings("rk4", step=0.2, points=2001))
    error = [abs(row[0] - found.rows[0][0]) for row in found.rows]
    assert max(error[-200:]) > 5 * max(error[:200])


@pytest.mark.parametrize("method", SCIPY)
def test_peers_agree(method: str) -> None:
    """At one tolerance, within what multistep methods make of it."""
    found = run(job_of("rolling_disk", method, 2.0), Settings(method, 1e-7, points=3))
    assert found.ended == "done" and not found.compiled
    exact = last(job_of("rolling_disk", end=2.0), "dop853", tolerance=1e-12)
    assert distance(list(found.rows[-1]), exact) < 1e-5


def test_stiff_equations_need_few_steps() -> None:
    """C6: drag so strong that an explicit method is bound to steps of 5.6e-6."""
    spec = """nhc: 1
system: syrup
coordinates: [x, y]
T: x'^2/2 + y'^2/2
V: y^2/2
forces: {x: "-5e5*(x' - cos(t))"}
scenes: {pour: {initial: {y: 1}, time: [0, 10], need: [x, y]}}
"""
    found = run(open_scene(Source("syrup.yaml", spec), method="radau5"), Settings("radau5", 1e-6, points=2))
    assert found.ended == "done" and found.outcome.steps < 10 / 5.6e-6 / 100
    assert found.rows[-1][0] == pytest.approx(math.sin(10), abs=1e-5)
    assert found.rows[-1][1] == pytest.approx(math.cos(10), abs=1e-5)


# --- the command --------------------------------------------------------------------------------------------


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(["run", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


def table(text: str) -> tuple[list[str], list[list[float]]]:
    header, *rows = csv.reader(io.StringIO(text))
    return header, [[float(x) for x in row] for row in rows]


def test_csv_has_what_is_needed(capsys: pytest.CaptureFixture[str]) -> None:
    for formulation in formulations("chaplygin_sleigh"):
        needs = "y,x',v,speed,energy,reactions"
        arguments = ["chaplygin_sleigh", "--scene", "glide", "--need", needs, "--points", "5", "-f", formulation]
        code, out, _ = call(capsys, *arguments)
        header, rows = table(out)
        assert code == 0 and header == ["t", "y", "x'", "v", "speed", "energy", "lambda_slip"]
        assert [row[0] for row in rows] == [0.0, 5.0, 10.0, 15.0, 20.0]
        for row in rows:
            assert row[3] == row[4] and row[5] == pytest.approx(rows[0][5], abs=1e-7)


def test_a_coordinate_may_be_called_energy(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    spec = tmp_path / "fall.yaml"
    head = "nhc: 1\nsystem: fall\ncoordinates: [energy, x]\nT: (energy'^2 + x'^2)/2\nforces: {energy: 2}\n"
    spec.write_text(head + "scenes: {go: {time: [0, 3], need: [energy]}}\n")
    for how in (["-f", "multipliers"], ["--need", "x,energy"], ["--python"]):
        code, out, _ = call(capsys, str(spec), "--points", "2", *how)
        columns, rows = table(out)
        assert code == 0 and [row[columns.index("energy")] for row in rows] == pytest.approx([0.0, 9.0])
    code, _, err = call(capsys, str(spec), "--need", "reactions")
    assert code == 2 and "there are no reactions" in err


def test_an_event_ends_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    for how in ((), ("--python",)):
        code, out, err = call(capsys, "chaplygin_sleigh", "--until", "theta - 1", *how)
        _, rows = table(out)
        assert code == 0 and rows[-1][3] == pytest.approx(1.0, abs=1e-12) and "stopped at t = 0.715316" in err
        assert [row[0] for row in rows] == sorted({row[0] for row in rows})


@pytest.mark.sample(3)
@pytest.mark.parametrize("how", [(), ("--python",), ("--method", "radau5"), ("--method", "rk4", "--step", "0.07")])
@pytest.mark.parametrize(
    ("until", "time"),
    [
        ("tan(3*t)", math.pi / 3),  # the first poles are those at pi/6 and, beside the zero, pi/2
        ("(t - 1.5)/(t - 1)", 1.5),  # a pole which halving hits
        ("(t - 1.5)/(t - 1)^3", 1.5),
        ("(theta - 1)/(theta - 0.3)", None),  # of the state
        ("1/(t - 1)", 10.0),  # no zero at all
        ("sign(t - 1)", 1.0),  # a jump ends it as a zero does
        ("1e-9*(t - 1)^3", 1.0),
    ],
)
def test_a_change_of_sign_through_a_pole_is_no_zero(
    until: str, time: float | None, how: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    code, out, err = call(capsys, "chaplygin_sleigh", "--until", until, "--points", "2", *how)
    assert code == 0, err
    columns, rows = table(out)
    if time is None:
        assert rows[-1][columns.index("theta")] == pytest.approx(1.0, abs=1e-9)
    else:
        assert rows[-1][0] == pytest.approx(time, abs=1e-6 if "^3" in until else 1e-9)
    assert ("stopped at" in err) == (time != 10.0)


@pytest.mark.parametrize(
    ("arguments", "code", "says"),
    [
        (["--until", "thata"], 2, "did you mean `theta`?"),
        (["--until", "theta +"], 2, "error[E0"),
        (["--until", "0.5"], 2, "`0.5` never crosses zero"),
        (["--until", "log(theta - 0.05)"], 3, "expression of `--until` has no value within the next step"),
        (["--need", "speeed"], 2, "did you mean `speed`?"),
        (["--scene", "glyde"], 2, "did you mean `glide`?"),
        (["--tol", "-1"], 2, "must be positive"),
        (["--tol", "2"], 2, "relative accuracy"),
        (["--points", "1"], 2, "--points"),
        (["-o", "a.txt"], 2, "should end in"),
        (["--method", "leapfrog", "--until", "x"], 2, "does not look for events"),
        (["--method", "perlmutter"], 2, "mass matrix is not constant"),
    ],
)
def test_mistaken_options_are_refused(
    arguments: list[str], code: int, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    found, out, err = call(capsys, "chaplygin_sleigh", *arguments)
    assert (found, out) == (code, "") and says in err


BLOW_UP = """nhc: 1
system: runaway
coordinates: [x]
T: x'^2/2
V: -x^4/4
scenes:
  away: {initial: {x: 1}, time: [0, 10]}
  long: {initial: {x: 1}, time: [0, 1e8]}
"""


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_a_failure_tells_time_state_and_reason(
    how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec, target = tmp_path / "runaway.yaml", tmp_path / "runaway.csv"
    spec.write_text(BLOW_UP)
    code, out, err = call(capsys, str(spec), "-o", str(target), *how)
    assert (code, out) == (3, "") and "t = 1.85407467" in err and "x = " in err and "step size underflows" in err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["runaway.yaml"]


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_no_run_across_a_singular_block(how: tuple[str, ...], capsys: pytest.CaptureFixture[str]) -> None:
    """C4: the sleigh heads along y once; solved for y' it must stop there."""
    code, out, err = call(capsys, "chaplygin_sleigh", "-f", "voronec", "--stay", *how)
    assert (code, out) == (3, "") and "cannot be solved for y'" in err and "theta = 1.57079633" in err


@pytest.mark.parametrize(
    ("how", "time"),
    [((), 0.0), (("-f", "voronec"), 0.0), (("--need", "x,gap"), 1.0), (("--need", "gap", "--points", "9"), 1.0)],
)
def test_a_needed_quantity_without_a_value_is_named(
    how: tuple[str, ...], time: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also where the state is reduced, and where another formulation takes over at the start."""
    spec = tmp_path / "still.yaml"
    spec.write_text(
        "nhc: 1\nsystem: still\ncoordinates: [x, y, th]\nT: x'^2 + y'^2 + th'^2\n"
        "constraints: [\"sin(th)*x' = cos(th)*y'\"]\noutputs: {bend: th'/sqrt(x'^2 + y'^2), gap: log(1 - t)}\n"
        "scenes: {go: {initial: {th': 1}, time: [0, 2], need: [x, bend]}}\n"
    )
    code, out, err = call(capsys, str(spec), "--python", *how)
    name = "gap" if time else "bend"
    assert (code, out) == (3, "") and f"fails at t = {time!r} (dop853): `{name}`, which is needed, has no real" in err
    assert "leave it out of what is needed or drawn, or end the scene before" in err


def test_an_inconsistent_start_is_refused_or_projected(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "skid.yaml"
    text = spec_path("chaplygin_sleigh").read_text()
    spec.write_text(text.replace("{theta: 0.1, v: 1, w: 0.5}", "{theta: 0, x': 1, y': 0.1, theta': 0.5}"))
    arguments = [str(spec), "--scene", "glide", "--points", "2", "--need", "x',y',theta'"]
    code, out, err = call(capsys, *arguments)
    assert (code, out) == (1, "") and "violate the constraints by 0.1" in err and "`nhc run --project` move" in err
    code, out, err = call(capsys, *arguments, "--project")
    assert code == 0 and "y' 0.1 -> 0" in err and "energy changes from" in err
    # m = 1, J = 1/2, a = 7/10: y' + a theta' is what the impulse at the edge leaves to the spin
    turned = 0.5 + 0.1 * 0.7 / (0.5 + 0.49)
    assert table(out)[1][0] == pytest.approx([0.0, 1.0, 0.0, turned], abs=1e-14)


def test_what_a_violated_start_leaves_out_follows_from_the_constraints_that_hold(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A wheel that rolls along x and slips a little along y: only y' is moved, and the spin keeps its value."""
    spec = tmp_path / "wheel.yaml"
    spec.write_text(
        "nhc: 1\nsystem: wheel\ncoordinates: [x, y, s, u]\nT: (x'^2 + y'^2 + s'^2/2 + 3*u'^2)/2 + x'*u'/5\n"
        "constraints: [x' = 2*s', y' = 0]\n"
        "scenes: {go: {initial: {s': 1, y': 0.1}, time: [0, 1], need: [x', y', s', u']}}\n"
    )
    assert call(capsys, str(spec))[0] == 1
    code, out, err = call(capsys, str(spec), "--points", "2", "--project")
    assert code == 0 and "projected: y' 0.1 -> 0\n" in err
    assert table(out)[1][0] == pytest.approx([0.0, 2.0, 0.0, 1.0, 0.0], abs=1e-14)


def test_steps_of_fixed_length_tell_what_they_go_over(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A sign that changes and changes back between two rows, and one of the time."""
    spec = tmp_path / "jump.yaml"
    spec.write_text(
        "nhc: 1\nsystem: jump\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\n"
        "forces: {x: -sign(x-1), y: sign(sin(3*t)) - 0.5*y'}\nscenes: {s: {initial: {x': 2, y': 1}, time: [0, 6]}}\n"
    )
    code, _, err = call(capsys, str(spec), "--points", "2", "--step", "0.1", "--method", "rk4")
    assert code == 0 and "jump with the sign of `1 - x`, which changes 2 times" in err
    assert "jump, bend or pulse at t = 1.0472, 2.0944, 3.14159 and at 2 more times, where the steps of rk4" in err
    code, _, err = call(capsys, str(spec), "--points", "2")
    assert code == 0 and "jump" not in err.replace("jump.yaml", "")


def test_velocities_that_contradict_each_other_are_named(capsys: pytest.CaptureFixture[str]) -> None:
    """At theta = 0 the scene's v is x': no projection helps, but the other value does."""
    sleigh = ["chaplygin_sleigh", "--points", "2", "--need", "x',y'"]
    for values in ("x'=1", "x'=1, y'=1"):
        code, out, err = call(capsys, *sleigh, "--set", values, "--project")
        assert (code, out) == (1, "") and "`x' = 1` contradicts `v = -0.6` of the scene" in err
        assert "or let `v` be 1, which fits" in err and "nhc run --project" not in err and "slip" not in err
        code, out, err = call(capsys, *sleigh, "--set", f"{values}, v=1", "--project")
        assert code == 0 and table(out)[1][0] == pytest.approx([0.0, 1.0, 0.0])
    code, out, err = call(capsys, *sleigh, "--set", "x'=1, y'=1")
    assert code == 1 and "`y' = 1` contradicts the constraint `slip`" in err and "nhc run --project" not in err


def test_what_contradicts_by_a_constraint_is_named_with_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "slope.yaml"
    spec.write_text(
        "nhc: 1\nsystem: slope\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nconstraints: [{rail: x*x' + y' = 0}]\n"
        "scenes: {s: {initial: {x: 2, z': 1, x': 1, y': 2}, time: [0, 1]}}\n"
    )
    code, out, err = call(capsys, str(spec))
    assert (code, out) == (1, "") and "`y' = 2` contradicts `x' = 1` and the constraint `rail`" in err
    assert (
        "or let `x'` be -1, which fits" in err
        and "`nhc run --project` move" in err
        and "z'" not in err.split("= note")[1]
    )
    assert call(capsys, str(spec), "--set", "x'=-1")[0] == 0
    assert call(capsys, str(spec), "--project")[0] == 0


def test_files_of_each_kind(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    import xml.etree.ElementTree as ElementTree

    import numpy as np

    for kind in ("csv", "npz", "svg", "html"):
        path = tmp_path / f"glide.{kind}"
        arguments = ["rolling_disk", "-f", "multipliers", "-o", str(path), "--points", "33"]
        assert call(capsys, *arguments)[0] == 0
        before = path.read_bytes()
        assert call(capsys, *arguments)[0] == 1  # it is there already
        assert call(capsys, *arguments, "--force")[0] == 0
        assert path.read_bytes() == before
    _, rows = table((tmp_path / "glide.csv").read_text())
    with np.load(tmp_path / "glide.npz") as archive:
        assert archive["theta"].shape == (33,) and archive["t"][-1] == rows[-1][0]
        assert archive["theta"].tolist() == [row[4] for row in rows]
    root = ElementTree.parse(tmp_path / "glide.svg").getroot()
    assert len(root.findall(".//{*}polyline")) == 5
    page = (tmp_path / "glide.html").read_text()
    data = json.loads(page.split('id="data">')[1].split("</script>")[0])
    assert [len(chart["x"]) for chart in data] == [33] * 4
    assert "http" not in page.replace("http://www.w3.org/2000/svg", "")


def test_an_interrupt_keeps_what_there_is(tmp_path: Path) -> None:
    spec = tmp_path / "long.yaml"
    spec.write_text(BLOW_UP.replace("-x^4", "x^4"))
    how = ("--points", "100000", "--method", "rk4", "--step", "0.1")
    code, seen = interrupt("run", str(spec), "--scene", "long", "-o", str(tmp_path / "a.csv"), *how)
    assert code == 130
    assert re.search(r"\r\[#+\.+\] +[1-9]\d* %  t = [\d.e+]+", seen)
    assert not (tmp_path / "a.csv").exists()
    _, rows = table((tmp_path / "a.partial.csv").read_text())
    assert 2 <= len(rows) < 100000 and f"interrupted at t = {rows[-1][0]!r}" in seen


# --- the cache ----------------------------------------------------------------------------------------------

UNIT = {"one.c": '#include "two.h"\nint value(void) { return TWO; }\n', "two.h": "#define TWO 2\n"}


def test_the_cache_is_addressed_by_content(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "models"))
    first = build(UNIT, "one.c")
    stamp = first.stat().st_mtime_ns
    assert build(UNIT, "one.c") == first and first.stat().st_mtime_ns == stamp
    others = {first, build({**UNIT, "two.h": "#define TWO 3\n"}, "one.c"), build(UNIT, "one.c", ("-O1",))}
    assert len(others) == 3
    assert sorted(path.name for path in (tmp_path / "models").iterdir()) == sorted(p.parent.name for p in others)
    with pytest.raises(CompileError, match="does not compile"):
        build({**UNIT, "two.h": ""}, "one.c")
    assert len(list((tmp_path / "models").iterdir())) == 3


@pytest.mark.parametrize("wins", [True, False])
def test_who_comes_second_keeps_the_first_one_s(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wins: bool) -> None:
    """Two runs compile the same model at once; where nobody has made the entry, that it cannot be is said."""
    rename = os.rename

    def come_second(work: Path, entry: Path) -> None:
        shutil.copytree(work, entry) if wins else entry.mkdir()
        (entry / "first").write_text("")
        rename(work, entry)

    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "models"))
    monkeypatch.setattr(os, "rename", come_second)
    if wins:
        assert (build(UNIT, "one.c").parent / "first").exists()
    else:
        with pytest.raises(CacheError, match="cannot write into the cache"):
            build(UNIT, "one.c")
    assert len(list((tmp_path / "models").iterdir())) == 1  # nothing is left lying about


@pytest.mark.parametrize("harm", ["cut", "zeros", "gone"])
def test_what_is_left_of_a_compiled_model_is_never_loaded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, harm: str
) -> None:
    """A crash of the machine cuts files or fills them with zeros; what clears old files away may take one of an entry."""
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "models"))
    library = build(UNIT, "one.c")
    content = library.read_bytes()
    half = content[: len(content) // 2]
    library.unlink()
    if harm != "gone":
        library.write_bytes(half + (bytes(len(content) - len(half)) if harm == "zeros" else b""))
    assert build(UNIT, "one.c") == library and library.read_bytes() == content
    assert len(list((tmp_path / "models").iterdir())) == 1


def test_what_killed_processes_left_is_cleared_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And nothing else: the cache may be put where the user has old files of their own, whose names begin with a dot."""
    monkeypatch.setenv("NHC_CACHE", str(tmp_path))
    key = "0123456789abcdef" * 2
    left, young, theirs = (tmp_path / name for name in (f".{key}.old", f".{key}.young", ".ssh"))
    for folder in (left, young, theirs):
        folder.mkdir()
        (folder / "one.c").write_text("")
    for folder in (left, theirs):
        os.utime(folder, (0.0, 0.0))
    monkeypatch.setattr(tempfile, "mkdtemp", killed)
    with pytest.raises(KeyboardInterrupt):
        build(UNIT, "one.c")
    monkeypatch.undo()
    monkeypatch.setenv("NHC_CACHE", str(tmp_path))
    (mine,) = {path for path in tmp_path.iterdir() if path.name.startswith(".")} - {left, young, theirs}
    os.utime(mine, (0.0, 0.0))
    build(UNIT, "one.c")
    assert young.exists() and theirs.exists() and not left.exists() and not mine.exists()


def killed(*, prefix: str, dir: Path) -> str:
    """A working folder is made, and then its maker is gone."""
    os.mkdir(dir / f"{prefix}made")
    raise KeyboardInterrupt


def test_without_a_compiler_it_runs_python_and_says_so(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    code, out, err = call(capsys, "pendulum", "--points", "3")
    assert code == 0 and len(table(out)[1]) == 3 and "no C compiler" in err and "emitted Python" in err


COMPILERS = {  # what stands in the script that ``CC`` names -> what the note says of it
    "exit 0": "it writes no library",
    "exit 1": "it ends with status 1 and without a word",
    "kill -9 $$": "it was killed by signal 9",
    "echo 'cannot open the license' >&2; exit 2": "cannot open the license",
    "printf 'fehlt: \\344\\n' >&2; exit 2": "fehlt: \ufffd",  # in another encoding than ours
}


@pytest.fixture
def as_for_users(quick_models: Compile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The compiler that a user has named, and a cache without a model."""
    monkeypatch.setattr(compiling, "_compile", quick_models)
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "models"))


@pytest.mark.parametrize("script", COMPILERS)
@pytest.mark.usefixtures("as_for_users")
def test_why_a_compiler_makes_nothing_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], script: str
) -> None:
    """A compiler is named by a path from this folder, and called from another one."""
    monkeypatch.chdir(tmp_path)
    Path("mycc").write_text(f"#!/bin/sh\n{script}\n")
    Path("mycc").chmod(0o755)
    monkeypatch.setenv("CC", "./mycc")
    code, out, err = call(capsys, "pendulum", "--points", "2")
    assert code == 0 and len(table(out)[1]) == 2
    assert f"note: `mycc` does not compile the emitted source: {COMPILERS[script]}; running the emitted Python" in err


@pytest.mark.usefixtures("as_for_users")
def test_only_the_compiler_that_is_named_compiles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CC", "no_such_compiler")
    code, _, err = call(capsys, "pendulum", "--points", "2")
    assert code == 0 and "note: no C compiler: `CC` names `no_such_compiler`, which is not found; running the" in err
    monkeypatch.setenv("CC", "env LC_ALL=C cc")  # a compiler with what stands before it, as `ccache gcc`
    code, _, err = call(capsys, "pendulum", "--points", "2")
    assert code == 0 and "note" not in err and len(list((tmp_path / "models").glob("*/*.so"))) == 1


@pytest.mark.usefixtures("as_for_users")
def test_a_chart_ends_with_advice_where_nothing_compiles(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CC", "false")
    code = main(["chart", "pendulum", "--no-peers", "--tolerances", "1e-3", "--methods", "rk4"])
    err = capsys.readouterr().err
    assert code == 2 and "= help: name another compiler in `CC`" in err and "internal error" not in err


@pytest.mark.slow
def test_methods_that_keep_all_velocities_say_that_they_do(capsys: pytest.CaptureFixture[str]) -> None:
    for formulation, said in (("euler-lagrange", True), ("multipliers", False)):
        code, _, err = call(capsys, "cvt", "-m", "perlmutter", "-f", formulation, "--points", "2")
        assert code == 0 and ("`perlmutter` keeps all velocities" in err) == said


def test_the_cache_is_where_it_is_said_to_be(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NHC_CACHE", "/somewhere")
    assert cache_folder() == Path("/somewhere")
    monkeypatch.delenv("NHC_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/elsewhere")
    assert cache_folder() == Path("/elsewhere/nhc")


def test_npz_is_the_same_each_time() -> None:
    job = job_of("pendulum", end=1.0)
    found: list[Trajectory] = [run(job, Settings(compiled=False, points=5)) for _ in range(2)]
    assert npz_bytes(found[0]) == npz_bytes(found[1])


def test_a_lost_rank_is_told_with_its_singular_value(tmp_path: Path) -> None:
    text = spec_path("snakeboard").read_text()
    text = text[: text.index("scenes:")] + (
        "scenes:\n  lost:\n    initial: {p_b: 1.5707963267948966, p_f: 1.5707963267948966, psi': 1}\n    time: [0, 1]\n"
    )
    path = tmp_path / "lost.yaml"
    path.write_text(text)
    done = subprocess.run([sys.executable, "-m", "nhc", "run", str(path)], capture_output=True, text=True, check=False)
    assert done.returncode == 3
    assert done.stdout == ""
    assert "smallest singular value of the constraints there: " in done.stderr
    assert "lose rank" in done.stderr


def test_small_quantities_do_not_lie_flat_beside_large_ones() -> None:
    text = (
        "nhc: 1\nsystem: far\ncoordinates: {x: {unit: m}, y: {unit: m}, z: {unit: m}, rest: {unit: m}, phi: {unit: rad}}\n"
        "parameters: {m: {value: 1, unit: kg}, I: {value: 1, unit: kg*m^2}}\nT: m/2*(x'^2 + y'^2 + z'^2 + rest'^2) + I/2*phi'^2\n"
        "scenes: {go: {initial: {x': 100, y': 0.5, z': 10, phi': 1}, time: [0, 2]}}\n"
    )
    found = run(open_scene(Source("far.yaml", text)), Settings(points=5, compiled=False))
    charts = list_charts(found)
    assert [[series.label for series in chart.series] for chart in charts] == [["x", "z", "rest"], ["y"], ["phi"]]
    assert [chart.y.label for chart in charts] == ["x, z, rest [m]", "y [m]", "phi [rad]"]
    assert charts[0].title and not charts[1].title


def test_a_page_names_units_and_says_where_a_change_of_energy_is_no_error(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "pushed.yaml"
    spec.write_text(
        "nhc: 1\nsystem: pushed\ncoordinates: {x: {unit: m}}\nparameters: {m: {value: 2, unit: kg}, F: {value: 0.5, unit: N}}\n"
        "T: m/2*x'^2\nforces: {x: F}\nscenes: {go: {time: [0, 4]}, idle: {time: [0, 4], parameters: {F: 0}}}\n"
    )
    assert call(capsys, str(spec), "-o", str(tmp_path / "go.html"))[0] == 0
    page = (tmp_path / "go.html").read_text()
    assert "<td>0 to 4 s, 201 rows</td>" in page
    (read,) = [
        chart for chart in json.loads(re.findall(r'id="data">(.*?)</script>', page)[0]) if chart["names"] == ["x"]
    ]
    assert (read["time"], read["unit"]) == ("s", "m")
    assert "<td>m\u00a0=\u00a02\u00a0kg, F\u00a0=\u00a00.5\u00a0N</td>" in page
    assert "<td>T + V goes from 0 J to 1 J; it need not be constant, because of the force on x</td>" in page.replace(
        "\u00a0", " "
    )
    assert "<td>all coordinates and velocities are zero</td>" in page
    assert call(capsys, str(spec), "--set", "x=1/4, x'=-3", "-o", str(tmp_path / "set.html"))[0] == 0
    assert "<td>x\u00a0=\u00a00.25\u00a0m, x&#x27;\u00a0=\u00a0-3\u00a0m/s</td>" in (tmp_path / "set.html").read_text()
    assert call(capsys, str(spec), "--set", "x'=2e-20", "-o", str(tmp_path / "slow.html"))[0] == 0
    assert "<td>x&#x27;\u00a0=\u00a02e-20\u00a0m/s</td>" in (tmp_path / "slow.html").read_text()
    assert call(capsys, str(spec), "--set", "F=4e14, m=2e-9", "-o", str(tmp_path / "large.html"))[0] == 0
    assert "<td>m\u00a0=\u00a02e-9\u00a0kg, F\u00a0=\u00a04e14\u00a0N</td>" in (tmp_path / "large.html").read_text()
    assert call(capsys, "double_pendulum", "-o", str(tmp_path / "double.html"))[0] == 0
    assert "need not be constant" not in (tmp_path / "double.html").read_text()
    assert call(capsys, "bicycle", "--time", "0.1", "--python", "-o", str(tmp_path / "bicycle.html"))[0] == 0
    (start,) = re.findall(r"start</td><td>(.*?)</td>", (tmp_path / "bicycle.html").read_text())
    assert "x&#x27;\u00a0=\u00a04.6\u00a0m/s" in start and "yaw&#x27;" not in start


@pytest.mark.parametrize(
    ("kind", "more", "rows"), [("svg", [], 2001), ("csv", [], 201), ("svg", ["--points", "50"], 50)]
)
def test_what_oscillates_is_drawn_as_a_curve(
    kind: str, more: list[str], rows: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A hundred periods in 201 rows are two points each: a picture would show other peaks and another frequency."""
    spec = tmp_path / "spring.yaml"
    spec.write_text(
        "nhc: 1\nsystem: spring\ncoordinates: [x]\nT: x'^2/2\nV: 98696*x^2/2\n"
        "scenes:\n  go: {initial: {x: 1}, time: [0, 2]}\n"
    )
    assert main(["run", str(spec), "-o", str(tmp_path / f"x.{kind}"), *more]) == 0
    assert f"{rows} rows, " in capsys.readouterr().err


@pytest.mark.parametrize(("kind", "more", "rows"), [("html", [], 202), ("csv", [], 8), ("html", ["--points", "50"], 3)])
def test_what_an_event_ends_is_drawn_as_a_motion(
    kind: str, more: list[str], rows: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of a scene's 201 rows few may be left, too few for a picture that moves."""
    spec = tmp_path / "free.yaml"
    spec.write_text(
        "nhc: 1\nsystem: free\ncoordinates: [x]\nT: x'^2/2\nscenes:\n  go: {initial: {x': 1}, time: [0, 30]}\n"
    )
    assert main(["run", str(spec), "--until", "x - 1", "-o", str(tmp_path / f"x.{kind}"), *more]) == 0
    assert f"{rows} rows, " in capsys.readouterr().err
