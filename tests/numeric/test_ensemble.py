"""Ensembles: each start is the single run from there, rows are refused by number, failures leave no whole file."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.language import Source, decode, read
from nhc.program.runs.limits import LIMITS
from nhc.simulate.ensemble import Ensemble, run_ensemble
from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import move_start
from nhc.simulate.run import Settings, run
from nhc.simulate.starts import list_starts, read_starts
from tests.support import interrupt, spec_path

SLEIGH = "theta,w,m\n0,1.3,1\n0.5,1.2,2\n1,,1.5\n"

BLOW_UP = """nhc: 1
system: runaway
coordinates: [x]
parameters: {k: 1}
T: x'^2/2
V: -k*x^4/4
scenes:
  away: {initial: {x: 1}, time: [0, 1.8]}
"""

LOSES_RANK = """nhc: 1
system: row_that_vanishes
coordinates: [x, y, z]
parameters: {a: 2}
T: (x'^2 + y'^2 + z'^2)/2
V: z
formulation: multipliers
constraints: ["(a - cos(z))*x' + (a - cos(z))*y' = 0"]
scenes:
  fall: {time: [0, 5], initial: {x': 1, y': -1, z: 2.5, z': -1}, need: [x, z]}
"""

TURNS_ITS_SIGN = """nhc: 1
system: mass_that_vanishes
coordinates: [z, x, y]
parameters: {a: 4, h: 1}
T: (z'^2 + a*x'^2 + y'^2)/2 + cos(z)*x'*y'
scenes:
  fall: {time: [0, 3], initial: {z: 2.5, z': -1}, need: [x, z]}
"""


def run_table(name: str, table: str, settings: Settings, formulation: str = "") -> Ensemble:
    source = read(str(spec_path(name)))
    job = open_scene(source, "", formulation, method=settings.method, whole=True)
    starts = list_starts(job.system, job.scene, read_starts(table, decode(source)))
    return run_ensemble(job, starts, settings)


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_each_start_is_its_own_run(method: str) -> None:
    """Bit for bit: one call over all starts, and one run for each."""
    step = 0.0 if method in ("dop853", "dopri5", "radau5") else 0.05
    settings = Settings(method, 1e-6, step, 4)
    for name, table, formulation in (("chaplygin_sleigh", SLEIGH, ""), ("chaplygin_sleigh", SLEIGH, "multipliers")):
        found = run_table(name, table, settings, formulation)
        assert not found.failed and len(found.members) == found.starts == 3
        assert len({member.rows[-1] for member in found.members}) == 3
        for member in found.members:
            single = run(move_start(found.job, member.job.start), settings)
            assert member.compiled and (member.times, member.rows) == (single.times, single.rows)
            assert member.outcome.steps == single.outcome.steps


def test_without_a_compiler_it_is_the_same() -> None:
    compiled = run_table("chaplygin_sleigh", SLEIGH, Settings(tolerance=1e-6, points=3))
    interpreted = run_table("chaplygin_sleigh", SLEIGH, Settings(tolerance=1e-6, points=3, compiled=False))
    assert not interpreted.members[0].compiled
    for a, b in zip(compiled.members, interpreted.members, strict=True):
        assert a.times == b.times
        for one, other in zip(a.rows, b.rows, strict=True):
            assert one == pytest.approx(other, abs=1e-11)


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(["run", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


def rows_of(text: str) -> tuple[list[str], list[list[float]]]:
    header, *rows = csv.reader(io.StringIO(text))
    return header, [[float(cell) for cell in row] for row in rows]


def test_the_command_writes_what_the_scene_itself_would(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An empty cell is the scene's value, and a table that says nothing new gives the scene's own run."""
    table, target = tmp_path / "starts.csv", tmp_path / "out.csv"
    table.write_text("theta,w\n,\n0.25,\n")
    arguments = ["chaplygin_sleigh", "--ensemble", str(table), "--need", "x,theta,energy"]
    code, out, _ = call(capsys, *arguments)
    header, rows = rows_of(out)
    assert code == 0 and header == ["start", "t", "x", "theta", "energy"]
    assert [row[:2] for row in rows] == [[1, 0], [1, 10], [2, 0], [2, 10]] and rows[2][3] == 0.25
    _, single, _ = call(capsys, "chaplygin_sleigh", "--need", "x,theta,energy", "--points", "2")
    assert [row[1:] for row in rows[:2]] == rows_of(single)[1]
    assert call(capsys, *arguments, "-o", str(target))[0] == 0 and target.read_text() == out
    assert call(capsys, *arguments, "-o", str(target))[0] == 1  # it is there already
    code, out, _ = call(capsys, *arguments, "--points", "5")
    assert code == 0 and [row[1] for row in rows_of(out)[1]] == [0, 2.5, 5, 7.5, 10] * 2


def test_quaternions_of_a_table_have_any_length(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What four digits are left of, and empty cells for parts of the scene's own."""
    table = tmp_path / "starts.csv"
    arguments = ["free_rigid_body_quaternion", "--need", "R_0,R_1,R_2,R_3", "--points", "2"]
    table.write_text("R_0,R_1,R_2,R_3\n0.7071,0,0,0.7071\n2,0,0,2\n-1,0,0,-1\n")
    code, out, err = call(capsys, *arguments, "--ensemble", str(table))
    assert code == 0, err
    rows = [row[2:] for row in rows_of(out)[1]]
    assert rows[0] == pytest.approx([0.5**0.5, 0, 0, 0.5**0.5], abs=1e-15)
    assert rows[3] == pytest.approx(rows[1], abs=1e-12) and rows[5] == pytest.approx([-x for x in rows[1]], abs=1e-12)


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ("theta,ww\n1,2\n", "did you mean `w`?"),
        ("theta,theta\n1,2\n", "names `theta` twice"),
        ("theta\n1\nx\n", "row 2: `x` for `theta` is not a finite number"),
        ("theta\n1\ninf\n", "row 2: `inf`"),
        ("theta,w\n1,1\n1\n", "row 2 has 1 value, the header 2 names"),
        ("theta,y'\n0,\n0,1\n", "row 2: the initial velocities of the scene `reference` violate the constraints"),
        ("theta\n", "no starts"),
        ("", "no starts"),
    ],
)
def test_a_wrong_row_is_refused_by_its_number(
    table: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "starts.csv"
    path.write_text(table)
    code, out, err = call(capsys, "chaplygin_sleigh", "--ensemble", str(path), "-o", str(tmp_path / "out.csv"))
    assert (code, out) == (1, "") and says in err
    assert [each.name for each in tmp_path.iterdir()] == ["starts.csv"]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--until", "theta"], "exclude one another"),
        (["--project"], "exclude one another"),
        (["--method", "leapfrog"], "takes one of"),
        (["--method", "rk4"], "needs `--step`"),
        (["-o", "a.svg"], "writes a .csv file"),
    ],
)
def test_options_that_do_not_fit(arguments: list[str], says: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = call(capsys, "chaplygin_sleigh", "--ensemble", "starts.csv", *arguments)
    assert (code, out) == (2, "") and says in err


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_failures_are_told_by_row(how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The motion from x = 1 is infinite at 1.854; k = 4 and x = 2 both halve that time."""
    spec, table, target = tmp_path / "runaway.yaml", tmp_path / "starts.csv", tmp_path / "out.csv"
    spec.write_text(BLOW_UP)
    table.write_text("x,k\n1,1\n2,1\n1,4\n-1,1\n")
    code, out, err = call(capsys, str(spec), "--ensemble", str(table), "-o", str(target), *how)
    assert (code, out) == (3, "") and "2 of 4 starts fail" in err
    assert "start 2 fails at t = 0.9270" in err and "start 3 fails at t = 0.9270" in err
    assert not target.exists()
    _, rows = rows_of((tmp_path / "out.partial.csv").read_text())
    assert [row[0] for row in rows] == [1, 1, 4, 4] and math.isclose(rows[1][2], -rows[3][2], rel_tol=1e-12)
    code, out, _ = call(capsys, str(spec), "--ensemble", str(table), *how)
    assert (code, out) == (3, "")


@pytest.mark.sample(2)
@pytest.mark.parametrize("how", [(), ("--python",)])
def test_an_interrupt_keeps_the_starts_that_are_done(how: tuple[str, ...], tmp_path: Path) -> None:
    """SIGINT to the process: exit code 130, a partial file with whole starts only, and a message."""
    table, target = tmp_path / "starts.csv", tmp_path / "out.csv"
    spec = tmp_path / "long.yaml"
    spec.write_text(BLOW_UP.replace("-k*x^4", "k*x^4").replace("1.8]", "100]" if how else "100000]"))
    count = 2_000
    table.write_text("x\n" + "".join(f"{1 + k / count!r}\n" for k in range(count)))
    code, err = interrupt("run", str(spec), "--ensemble", str(table), "-o", str(target), *how)
    assert code == 130 and f"of {count} starts" in err and "interrupted after" in err, err
    assert not target.exists()
    _, rows = rows_of((tmp_path / "out.partial.csv").read_text())
    done = int(err.split("interrupted after ")[1].split()[0])
    assert 0 < done < count and [row[0] for row in rows] == [k for k in range(1, done + 1) for _ in range(2)]


def test_columns_have_names_of_their_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec, table = tmp_path / "runaway.yaml", tmp_path / "starts.csv"
    spec.write_text(BLOW_UP.replace("away:", "soon:").replace("1.8", "0.1").replace("x", "start"))
    table.write_text("start\n0.5\n0.25\n")
    assert main(["run", str(spec), "--ensemble", str(table)]) == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [(row["start_"], row["start"]) for row in rows if row["t"] == "0.0"] == [("1", "0.5"), ("2", "0.25")]
    table.write_text("start\n1_0\n")
    assert main(["run", str(spec), "--ensemble", str(table)]) == 1
    assert "`1_0` for `start` is not a finite number" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "says"),
    [(LOSES_RANK, "the constraints lose rank"), (TURNS_ITS_SIGN, "the mass matrix is singular")],
)
def test_what_only_a_row_can_lose_is_watched(
    text: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the spec's a nothing is singular anywhere; with the second row's the motion passes z = pi/3, where a run ends."""
    spec, starts = tmp_path / "s.yaml", tmp_path / "a.csv"
    spec.write_text(text.replace("a: 2", "a: 0.5").replace("a: 4", "a: 0.25"))
    alone = main(["run", str(spec), "--points", "2", "--stay"])
    told = capsys.readouterr().err
    assert alone == 3 and says in told
    spec.write_text(text)
    starts.write_text("a\n4\n0.5\n".replace("0.5", "0.25" if "a: 4" in text else "0.5"))
    assert main(["run", str(spec), "--points", "2", "--ensemble", str(starts)]) == 3
    rows = capsys.readouterr().err
    assert "start 2 fails" in rows and "start 1 fails" not in rows and says in rows


@pytest.mark.slow
def test_a_start_whose_end_is_out_of_reach_is_given_up() -> None:
    """At 1e10 radians per second it takes 1e10 steps: lanes see it as a single run does, and the others go on."""
    text = (
        "nhc: 1\nsystem: whirr\ncoordinates: [x]\nparameters: {k: 4}\nT: x'^2/2\nV: k*x^2/2\n"
        "scenes: {a: {initial: {x: 1}, time: [0, 1]}}\n"
    )
    source = Source("whirr.yaml", text)
    job = open_scene(source, method="dop853", whole=True)
    starts = list_starts(job.system, job.scene, read_starts("k\n1e20\n4\n1e20\n1e9\n", decode(source)))
    found = run_ensemble(job, starts, Settings("dop853", 1e-6, 0.0, 2)).members
    assert [member.ended for member in found] == ["failed", "done", "failed", "done"]
    one = run(move_start(job, starts[0]), Settings("dop853", 1e-6, 0.0, 2))
    for member in (found[0], found[2]):
        assert "out of reach" in member.reason and member.reason == one.reason
        assert member.outcome.steps + member.outcome.rejected == LIMITS.stride * LIMITS.patience
    assert found[1].rows[-1][0] == pytest.approx(math.cos(2), abs=1e-6)
    assert found[3].rows[-1][0] == pytest.approx(math.cos(1e9**0.5), abs=1e-3)


CAR = """
nhc: 1
system: car
about: the steering passes 90 degrees
coordinates: [x, y, th, d]
parameters: {m: 10, J: 2, Js: 0.1, L: 1.2}
T: m/2*(x'^2 + y'^2) + J/2*th'^2 + Js/2*(th' + d')^2
constraints:
  - rear: -sin(th)*x' + cos(th)*y' = 0
  - front: -sin(th + d)*(x' - L*sin(th)*th') + cos(th + d)*(y' + L*cos(th)*th') = 0
quasi_velocities: {v: "cos(th)*x' + sin(th)*y'", s: "d'"}
scenes:
  s: {initial: {v: 1, d: 0.2}, time: [0, 6], need: [x, y, th, d]}
"""


@pytest.mark.parametrize("formulation", ["euler-lagrange", "voronec"])
def test_starts_that_lose_their_coframe_go_on(
    formulation: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec, starts = tmp_path / "car.yaml", tmp_path / "starts.csv"
    spec.write_text(CAR)
    starts.write_text("v,s\n0.5,1.5\n0.5,0\n0.5,1.6\n")
    asked = ["run", str(spec), "--ensemble", str(starts), "-f"]
    assert main([*asked, formulation, "--stay"]) == 3
    err = capsys.readouterr().err
    assert "2 of 3 starts fail" in err and "help: take `-f multipliers`: " in err
    assert main([*asked, formulation]) == 0
    found, said = capsys.readouterr()
    assert "note: 2 starts, 1 the first, have runs of their own: " in said
    assert main([*asked, "multipliers"]) == 0
    rows, expected = (
        [[*map(float, line.split(","))] for line in text.split()[1:]] for text in (found, capsys.readouterr().out)
    )
    for row, other in zip(rows, expected, strict=True):
        assert row == pytest.approx(other, rel=1e-5, abs=1e-6)


def test_starts_that_fail_otherwise_are_not_sent_to_multipliers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec, starts = tmp_path / "car.yaml", tmp_path / "starts.csv"
    spec.write_text(CAR.replace("forces:", "").replace("T: ", "forces: {d: k*d'^3}\nT: ").replace("{m:", "{k: 0, m:"))
    starts.write_text("v,s,k\n0.5,0.5,1\n0.5,0,0\n")
    assert main(["run", str(spec), "--ensemble", str(starts)]) == 3
    assert "multipliers" not in capsys.readouterr().err
    starts.write_text("v,s,k\n0.5,0.5,1\n0.5,1.5,0\n")
    assert main(["run", str(spec), "--ensemble", str(starts), "--stay"]) == 3
    assert "help: take `-f multipliers` for start 2: " in capsys.readouterr().err


def test_starts_with_a_negative_energy_are_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    starts = tmp_path / "starts.csv"
    starts.write_text("m1,m2\n1,1\n1,-0.5\n-1,-2\n")
    assert main(["run", "double_pendulum", "--time", "0.1", "--ensemble", str(starts)]) == 0
    said = capsys.readouterr().err
    assert "note: 2 starts, 2 the first: the kinetic energy is negative for some motions" in said
    assert "`m2` is negative there (W0423)" in said
