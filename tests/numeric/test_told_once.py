"""What the terminal says once and no longer than can be read: long expressions, facts of a rotation, the time before a failure."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.cli.linearize import LONGEST

SCENE = """
nhc: 1
system: sled
parameters: {m: 2, I: 3, a: 0.4}
coordinates: [x, y, phi]
T: m/2*(x'^2 + y'^2) + I/2*phi'^2
constraints:
  - slip: cos(phi)*y' - sin(phi)*x' = 0
scenes: {bend: {initial: {phi: 0.5, x': 1, phi': 1}, time: START}}
"""


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main([*arguments])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.mark.parametrize(("time", "option"), [("[0, 3]", "2.62"), ("[2, 5]", "2:4.62")])
def test_a_run_that_fails_names_the_time_that_ends_before(
    time: str, option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "sled.yaml"
    path.write_text(SCENE.replace("START", time))
    asked = ["run", str(path), "-f", "voronec", "--stay"]
    code, out, err = call(capsys, *asked)
    assert (code, out) == (3, "")
    (told,) = re.findall(r"help: `--time (.*)` writes the motion until shortly before", err)
    assert told == option  # the motion turns to phi = pi, where the constraint loses the dependent velocity, in 2.64
    code, out, _ = call(capsys, *asked, "--time", told)
    assert code == 0
    rows = out.splitlines()
    assert float(rows[-1].split(",")[0]) == float(told.split(":")[-1])
    assert float(rows[1].split(",")[0]) == (2 if time == "[2, 5]" else 0)


def test_a_run_that_fails_at_its_start_names_no_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "sled.yaml"
    path.write_text(SCENE.replace("START", "[0, 1]"))
    code, _, err = call(capsys, "run", str(path), "--until", "log(x - 1)")
    assert code == 3 and "writes the motion" not in err


def test_a_length_of_a_rotation_is_told_once(capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = call(capsys, "stability", "free_rigid_body_quaternion", "--json")
    assert code == 0
    for run in json.loads(out)["drift"]:
        names = [quantity["what"] for quantity in run["quantities"]]
        assert len(names) == len(set(names)) and [name for name in names if "norm" in name] == ["R_norm, position"]
        assert not any("R_0^2" in name for name in names)


@pytest.mark.parametrize(
    ("system", "motion", "long"), [("rattleback", "w3=5", True), ("rolling_disk", "theta=pi/2, w_n=3", False)]
)
def test_long_expressions_are_left_to_json(
    system: str, motion: str, long: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["linearize", system, "--about", motion]
    code, out, _ = call(capsys, *asked)
    shown = [line for line in out.splitlines() if " <- " in line]
    assert code == 0 and max(map(len, shown)) < LONGEST + 40
    assert (f"expressions of more than {LONGEST} characters are left out; `--json` has them" in out) == long
    code, text, _ = call(capsys, *asked, "--json")
    entries = [entry for row in json.loads(text)["symbolic"] for entry in row if entry not in ("", "0")]
    assert code == 0 and (max(map(len, entries)) > LONGEST) == long
    kept = [entry for entry in entries if len(entry) <= LONGEST]
    assert kept and all(any(line.endswith(f"  {entry}") for line in shown) for entry in kept)


@pytest.mark.parametrize("points", ["2", "3", "201"])
@pytest.mark.parametrize(("left", "when"), [("sqrt(0.5 - x)", 0.5), ("log(1 - x)", 1.0)])
def test_a_column_that_is_lost_is_lost_at_its_time(
    left: str, when: float, points: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A row may come long after the loss, and in another run a row may lie on the very place."""
    path = tmp_path / "column.yaml"
    path.write_text(
        f"nhc: 1\nsystem: column\ncoordinates: [x]\nT: x'^2/2\noutputs: {{left: {left}}}\n"
        "scenes: {go: {initial: {x': 1}, time: [0, 2], need: [x, left]}}\n"
    )
    code, _, err = call(capsys, "run", str(path), "--points", points)
    assert code == 3
    assert float(re.findall(r"fails at t = (\S+) ", err)[0]) == pytest.approx(when, abs=3e-8)
    (told,) = re.findall(r"help: `--time (.*)` writes the motion until shortly before", err)
    assert (
        float(told) == pytest.approx(0.99 * when)
        and call(capsys, "run", str(path), "--points", points, "--time", told)[0] == 0
    )


def test_the_value_that_fits_is_taken(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, value = tmp_path / "skate.yaml", "9"
    for _ in range(2):
        path.write_text(
            "nhc: 1\nsystem: skate\ncoordinates: [x, y, th]\nT: (x'^2 + y'^2 + th'^2)/2\n"
            "constraints: [\"-sin(th)*x' + cos(th)*y' = 0\"]\n"
            f"scenes: {{go: {{initial: {{th: pi/3, x': {value}, y': 0.5}}, time: [0, 1]}}}}\n"
        )
        code, out, _ = call(capsys, "check", str(path))
        if value == "9":
            assert code == 1
            (value,) = re.findall(r"let `x'` be (.*), which fits", out)
    assert code == 0, out
