"""``nhc emit`` names the scenes whose start the emitted functions refuse, and only these."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import python_model

SPEC = """nhc: 1
system: two
coordinates: [x, y, phi]
T: (x'^2 + y'^2 + phi'^2)/2
constraints:
  - skate: sin(phi)*x' - cos(phi)*y' = 0
quasi_velocities: {v: x', w: phi'}
scenes:
  good: {initial: {v: 1, w: 0.1}, time: [0, 1]}
  bad: {initial: {phi: pi/2, y': 1, w: 0.1}, time: [0, 1]}
"""


def warned(text: str) -> list[str]:
    """The scenes that warnings name."""
    return re.findall(r"warning: the scene `(\w+)` starts where", text)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (["--lang", "c"], ["bad"]),
        (["--lang", "python", "--array", "numpy"], ["bad"]),
        (["--lang", "c", "--driver"], ["bad"]),
        (["--lang", "c", "--scene", "bad"], ["bad"]),
        (["--lang", "c", "--only", "rhs", "-f", "voronec"], ["bad"]),
        (["--lang", "c", "--scene", "good"], []),
        (["--lang", "c", "-f", "multipliers"], []),
    ],
)
def test_scenes_are_named(
    options: list[str],
    expected: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "cache"))
    path = tmp_path / "two.yaml"
    path.write_text(SPEC)
    for _ in range(2):  # derived, and kept
        assert main(["emit", str(path), *options, "-o", str(tmp_path / "out")]) == 0
        assert warned(capsys.readouterr().err) == expected
    names = {file.name for file in (tmp_path / "out").iterdir()}
    assert all(name.startswith("two") for name in names)


def test_the_functions_do_refuse_that_start_and_no_other() -> None:
    told: list[str] = []
    (text,) = emit(Source("two.yaml", SPEC), "python", Options(), told.append).values()
    assert len(told) == 1 and "Warning: the scene `bad` starts where the coframe is singular" in text
    model = python_model(text, "two")
    assert model.rhs(0.0, [0.0, 0.0, 0.0, 1.0, 0.1])
    with pytest.raises(model.SingularModelError):
        model.rhs(0.0, [0.0, 0.0, 1.5707963267948966, 0.0, 0.1])
