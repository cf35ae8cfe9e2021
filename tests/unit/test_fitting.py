"""Texts for people fit the terminal; what goes to a pipe keeps its lines."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest

from nhc.cli.fitting import fit, measure
from nhc.report.ladder import _stacked
from tests.support import ROOT

REMARK = "  rounding reaches 1 %  far beyond the scene  extrapolated: when rounding has grown to 1 % of the motion"
NUMBER = "  multipliers     I.4.1   accelerations equal, reactions equal; in doubles within 1e-15 at 17 states"


def test_a_last_column_goes_on_in_its_column_or_has_lines_of_its_own() -> None:
    assert fit(NUMBER, 60).split("\n") == [
        "  multipliers     I.4.1   accelerations equal, reactions",
        "                          equal; in doubles within 1e-15 at",
        "                          17 states",
    ]
    assert fit(REMARK, 60).split("\n") == [
        "  rounding reaches 1 %  far beyond the scene",
        "                        extrapolated: when rounding has",
        "                        grown to 1 % of the motion",
    ]


def test_what_marks_a_place_of_a_spec_is_left_alone() -> None:
    shown = "117 |   - rear_z: z' + a1*e1z + a2*e2z + a3*e3z + a4*e4z + a5*e5z = 0\n    |     ^^^^^^"
    assert fit(shown, 40) == shown
    told = fit("    = help: give its integral under `holonomic:`, so that positions are held to it too", 40)
    assert told.split("\n")[1].startswith(" " * 12 + "`holonomic:`")


def test_colour_takes_no_columns() -> None:
    line = "\x1b[1m" + "word " * 11 + "word\x1b[0m"
    assert measure(line) == 59 and fit(line, 60) == line


@pytest.mark.parametrize("width", [30, 60, 72, 80, 100, 200])
def test_tables_in_markdown_lose_no_cell(width: int) -> None:
    rows = [
        "| equations | why | C | Python |",
        "| --- | --- | ---: | ---: |",
        "| chaplygin | dependent velocities of the spec, chosen by hand and kept | 1.48 ns | 574 ns |",
        "| multipliers | all velocities kept, reactions \\| forces as unknowns | 5.47 ns | 18.6 µs |",
    ]
    lines = fit("\n".join(["before", *rows, "after"]), width).split("\n")
    assert max(map(measure, lines)) <= width and (lines[0], lines[-1]) == ("before", "after")
    words = " ".join(lines).replace(";", "").split()
    for cell in ("chaplygin", "hand", "kept", "1.48", "574", "multipliers", "|", "5.47", "18.6", "unknowns"):
        assert cell in words


def test_a_ladder_that_is_too_wide_is_stacked() -> None:
    head = ["", "equations", "error", "roll", "steer", "left out"]
    row = ["1", "6", "1.0e-04", "1.0e-04", "2.0e-05", "without what is long to tell"]
    assert _stacked([head, row], [1, 9, 7, 7, 7, 30], 3) == [
        "   equations    error",
        "1          6  1.0e-04",
        "   without what is long to tell",
        "   roll 1.0e-04, steer 2.0e-05",
    ]


def at_a_terminal(columns: int, *arguments: str) -> list[str]:
    """The lines of nhc's stdout on a terminal of so many columns."""
    screen, terminal = pty.openpty()
    environment = {**os.environ, "COLUMNS": str(columns), "NO_COLOR": "1"}
    command = [sys.executable, "-m", "nhc", *arguments]
    with subprocess.Popen(command, cwd=ROOT, stdout=terminal, stderr=subprocess.DEVNULL, env=environment) as process:
        os.close(terminal)
        seen = b""
        try:
            while more := os.read(screen, 4096):
                seen += more
        except OSError:  # the terminal's end
            pass
        assert process.wait(timeout=120) == 0
    os.close(screen)
    return seen.decode().replace("\r", "").rstrip("\n").split("\n")


@pytest.mark.parametrize(
    "arguments",
    [
        ("compare", "rolling_disk"),
        ("compare", "heavy_top", "heavy_top"),
        ("reduce", "rolling_disk", "--scene", "lean"),
        ("linearize", "heavy_top"),
        ("check", "--explain", "rolling_disk"),
        ("derive", "nh_particle"),
        ("cite", "bicycle"),
        ("gallery",),
        ("explain",),
        ("explain", "W0408"),
    ],
    ids=" ".join,
)
@pytest.mark.parametrize("columns", [60])
def test_verbs_fit_a_terminal(arguments: tuple[str, ...], columns: int) -> None:
    lines = at_a_terminal(columns, *arguments)
    wide = [line for line in lines if len(line) > columns and len(line.split()) > 1]
    assert not [line for line in wide if "|" not in line], wide


def test_a_pipe_gets_whole_lines(tmp_path: Path) -> None:
    environment = {**os.environ, "COLUMNS": "60"}
    command = [sys.executable, "-m", "nhc", "compare", "rolling_disk"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, env=environment, check=True)
    assert max(map(len, done.stdout.splitlines())) > 100
