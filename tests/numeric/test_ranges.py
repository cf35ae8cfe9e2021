"""A run says where a coordinate leaves the range that is declared for it."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main

SPEC = """nhc: 1
system: swing
coordinates: {theta: {range: [LOW, 0.5]}, x: {range: [0, 1]}}
T: theta'^2/2 + x'^2/2
U: cos(theta)
scenes:
  swing: {initial: {theta: 0.5, x': 0.5}, time: [0, 3], need: [NEED]}
"""


@pytest.mark.parametrize(
    ("low", "need", "told"),
    [
        ("-0.5", "theta, x", ["`x` leaves the range declared for it, [0, 1], at t = 2.1: it goes from 0 to 1.5"]),
        ("-0.5", "theta", []),
        ("0.4", "theta", ["`theta` leaves the range declared for it, [0.4, 0.5], at t = 0.75: it goes from -0.49"]),
        ("-9", "x", ["`x` leaves"]),
    ],
)
@pytest.mark.parametrize("more", [[], ["--python"]])
def test_it_is_told_where_a_coordinate_leaves_its_range(
    low: str, need: str, told: list[str], more: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "swing.yaml"
    spec.write_text(SPEC.replace("LOW", low).replace("NEED", need))
    assert main(["run", str(spec), "--points", "21", *more]) == 0
    notes = [line for line in capsys.readouterr().err.splitlines() if "leaves the range" in line]
    assert len(notes) == len(told)
    assert all(line.startswith(f"note: {text}") for line, text in zip(notes, told, strict=True))
