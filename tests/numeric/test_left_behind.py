"""Choices that numbers cannot tell apart, and scenes that a driver cannot start."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.resolving.resolve import resolve

NEAR = """nhc: 1
system: near
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2)/2
constraints:
  - x' + y' = 0
  - x' + (1 + SMALL*sin(z))*y' = 0
"""
START = """nhc: 1
system: start
coordinates: [x, y]
parameters: {m: 2}
T: m/2*(x'^2 + y'^2)
constraints: ["x' = 2*y'"]
scenes:
  bad: {initial: {x': 1, y': 2}, time: [0, 1]}
"""


@pytest.mark.parametrize("small", ["1e-2", "1e-3", "1e-6", "1e-16"])
def test_constraints_that_are_nearly_one_are_solved_for_what_they_contain(small: str, tmp_path: Path) -> None:
    system = resolve(decode(Source("near.yaml", NEAR.replace("SMALL", small))))
    assert choose_dependent(system).dependent == (0, 1)
    spec = tmp_path / "near.yaml"
    spec.write_text(NEAR.replace("SMALL", small))
    assert main(["check", str(spec)]) == 0


def test_a_driver_says_which_scenes_it_leaves_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "start.yaml"
    spec.write_text(START)
    command = ["emit", str(spec), "-l", "c", "--driver", "-o", str(tmp_path / "out")]
    assert main(command) == 1
    assert "error[E0409]: the initial velocities of the scene `bad`" in capsys.readouterr().err
    spec.write_text(f"{START}  good: {{time: [0, 1]}}\n")
    assert main(command) == 0
    assert "warning: the scene `bad` is left out of the driver: the initial velocities" in capsys.readouterr().err
    assert main([*command[:3], "c", "--force", "-o", str(tmp_path / "out")]) == 0
    assert "bad" not in capsys.readouterr().err
