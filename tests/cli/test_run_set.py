"""``nhc run --set`` and ``--time``: a scene with other values and another time than the spec gives."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main

SPEC = """nhc: 1
system: throw
parameters: {{g: {g}, m: 2}}
coordinates: [x, y]
T: m/2*(x'^2 + y'^2)
U: -m*g*y
quasi_velocities: {{v: x'}}
outputs: {{height: m*y/m}}
scenes:
  drop: {{initial: {{y: {y}, v: {v}}}, time: {time}, need: [x, height]}}
"""
USUAL = {"g": "9.81", "y": "1", "v": "0", "time": "[0, 1]"}


def write(folder: Path, **values: str) -> str:
    path = folder / "throw.yaml"
    path.write_text(SPEC.format(**{**USUAL, **values}))
    return str(path)


@pytest.mark.parametrize(
    ("options", "values"),
    [
        (["--set", "g=1.62"], {"g": "1.62"}),
        (["--set", "g=1.62, y=3"], {"g": "1.62", "y": "3"}),
        (["--set", "v=g/2", "--set", "y=pi"], {"v": "g/2", "y": "pi"}),
        (["--set", "x'=2", "--scene", "drop"], {"v": "2"}),
        (["--set", "g=0"], {"g": "0"}),
        (["--time", "2.5"], {"time": "[0, 2.5]"}),
        (["--time", " -1 : pi/2", "--set", "v=3"], {"time": "[-1, pi/2]", "v": "3"}),
    ],
)
@pytest.mark.parametrize("how", [[], ["--python"]])
def test_it_runs_as_if_the_spec_said_so(
    options: list[str], values: dict[str, str], how: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if values == {"v": "2"}:  # the velocity itself, beside the quasi-velocity of the spec, which says the same
        options = ["--set", "v=2", *options]
    assert main(["run", write(tmp_path), *options, *how]) == 0
    found = capsys.readouterr().out
    assert main(["run", write(tmp_path, **values), *how]) == 0
    assert found == capsys.readouterr().out
    assert main(["run", write(tmp_path), *how]) == 0
    assert found != capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "code", "place"),
    [
        (["--set", "g=1, z=3"], "E0419", "--set:1:6"),
        (["--set", "height=3"], "E0419", "--set:1:1"),
        (["--set", "g=9,81"], "E0208", "decimal numbers are written with `.`"),
        (["--set", "y_dot=1"], "E0419", "the velocity is written `y'`"),
        (["--set", "ẋ=1"], "E0419", "the velocity is written `x'`"),
        (["--set", "y=x"], "E0314", "--set:1:3"),
        (["--set", "y"], "E0208", "--set:1:1"),
        (["--set", "y=1/0"], "E0417", "--set:1:5"),
        (["--set", "v=1, x'=2"], "E0409", "throw.yaml:"),
        (["--time", "0"], "E0313", "starts at 0\n --> --time:1:1"),
        (["--time", "5:4"], "E0313", "--time:1:1"),
        (["--time", "1:2:3"], "E0301", "--time:1:1"),
        (["--time", "1: "], "E0301", "--time:1:1"),
        (["--time", "0: tau"], "E0314", "--time:1:4"),
        (["--time", "3 s"], "E0", "--time:1:"),
        (["--time", "inf"], "E0313", "--time:1:1"),
        (["--time", "1/0"], "E0417", "--time:1:1"),
        (["--time", "1e20:1e20+1"], "E0313", "not told apart"),
        (["--time", "1e-300"], "E0313", "steps underflow"),
    ],
)
def test_what_is_wrong_with_a_value_is_shown(
    options: list[str], code: str, place: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", write(tmp_path), *options]) == (1 if place.startswith("throw") else 2)
    out = capsys.readouterr()
    assert out.out == "" and f"error[{code}" in out.err and place in out.err


def test_an_ensemble_has_a_table_for_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "starts.csv"
    table.write_text("y\n1\n")
    assert main(["run", write(tmp_path), "--ensemble", str(table), "--set", "g=1"]) == 2
    assert "columns of it" in capsys.readouterr().err
    assert main(["run", write(tmp_path), "--ensemble", str(table), "--time", "1:3", "--points", "3"]) == 0
    assert [row.split(",")[1] for row in capsys.readouterr().out.splitlines()] == ["t", "1.0", "2.0", "3.0"]


def test_an_empty_time_is_no_time(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", write(tmp_path), "--time", ""]) == 2
    assert "'--time': it is empty" in capsys.readouterr().err


def test_a_negative_mass_is_noted_wherever_it_comes_from(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """`nhc check` warns of those in the spec and cannot know of others."""
    spec = write(tmp_path)
    noted = []
    for options in (["--set", "m=-9"], ["--set", "m=9"]):
        assert main(["run", spec, "--python", "--points", "2", *options]) == 0
        noted.append("scene starts: `m` is negative there (W0423)" in capsys.readouterr().err)
    assert noted == [True, False]


def test_degrees_are_noted_of_the_values_that_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A scene's own value, or one of the command line, takes the place of the spec's; other scenes are not spoken of."""
    spec = tmp_path / "slope.yaml"
    head = "nhc: 1\nsystem: slope\ncoordinates: {x: {}, th: {}}\nparameters: {g: 9.81, alpha: 30}\n"
    energies = "T: (x'^2 + th'^2)/2\nV: g*(cos(th) - x*sin(alpha))\n"
    spec.write_text(f"{head}{energies}scenes: {{a: {{time: [0, 1]}}, b: {{initial: {{th: 90}}, time: [0, 1]}}}}\n")
    told = []
    for options in ([], ["--set", "alpha=0.5"], ["--set", "alpha=0.5, th=45"], ["--scene", "b"]):
        assert main(["run", str(spec), "--python", "--points", "2", *options]) == 0
        told.append([line for line in capsys.readouterr().err.splitlines() if "W0431" in line])
    of_alpha = "note: `alpha` is 30: write `30*pi/180` if degrees are meant (W0431)"
    of_start = "note: `th` starts at {0}: write `{0}*pi/180` if degrees are meant (W0431)"
    assert told == [[of_alpha], [], [of_start.format(45)], [of_alpha, of_start.format(90)]]
