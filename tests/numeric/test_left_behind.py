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
LIGHT = """nhc: 1
system: light
coordinates: [x, y]
parameters: {m: 2, M: 1}
T: m/2*x'^2 + M/2*y'^2
V: M*y
scenes:
  a: {MASStime: [0, 1], initial: {x': 1}, need: [y]}
"""
HELP = """nhc: 1
system: help
coordinates: [x, y, z]
parameters: {m: 1, k: 2}
T: m/2*(x'^2 + y'^2 + z'^2)
V: x
constraints: [x' + y' = k]
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


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("V: x", "V: max(x,)", "write `max(x, y)`"),
        ("V: x", "V: atan2()", "write `atan2(y, x)`"),
        ("V: x", "V: floor(x)", "`nhc explain E0206` lists the functions"),
        ("x' + y' = k", "x' + y' = m, x' + y' = k", "together they ask for a relation of parameters or the time alone"),
        ("x' + y' = k", "x' + y' = 1, x' + y' = 2", "together they ask for `0 = 1`"),
        ("x: 1", "x: log(-k)", "correct the expression, or the values of the parameters in the scene\n"),
    ],
)
def test_what_helps_is_told(old: str, new: str, told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As many arguments as a function takes, what constraints really ask for, no quaternion where there is none."""
    spec = tmp_path / "help.yaml"
    text = f"{HELP}scenes: {{a: {{initial: {{x: 1}}, time: [0, 1]}}}}\n"
    assert old in text
    spec.write_text(text.replace(old, new))
    assert main(["check", str(spec)]) == 1
    assert told in capsys.readouterr().out


@pytest.mark.parametrize("more", [[], ["-f", "newton"], ["--python"], ["--set", "m=0"]])
def test_a_coordinate_without_inertia_has_no_motion_though_the_scene_does_not_need_it(
    more: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The mass cancels in y'' = -1, and x'' is not determined; as `check` says it, and the driver."""
    spec = tmp_path / "light.yaml"
    mass = "" if "--set" in more else "parameters: {m: 0}, "
    spec.write_text(LIGHT.replace("MASS", mass))
    assert main(["run", str(spec), "--points", "2", *more]) == 3
    found = capsys.readouterr()
    assert "fails at t = 0.0" in found.err and "the mass matrix is singular" in found.err and not found.out


def test_a_run_that_fails_at_its_start_says_what_check_says(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "pole.yaml"
    spec.write_text("nhc: 1\nsystem: pole\ncoordinates: [x]\nT: x'^2/2\nV: 1/x\nscenes: {a: {time: [0, 1]}}\n")
    assert main(["run", str(spec)]) == 3 and main(["check", str(spec)]) == 0
    found = capsys.readouterr()
    for said in (
        "note: `x` starts at 0, since `initial` does not give a value",
        "help: say in `initial` where `x` starts",
    ):
        assert said in found.err and said in found.out
    assert main(["run", "pendulum", "--set", "m=0"]) == 3
    assert "note: `m` is zero there\n  = help: give `m` a value, " in capsys.readouterr().err


@pytest.mark.parametrize("words", [["emit", "--lang", "c", "-o", "made"], ["reduce"]])
def test_what_is_made_for_a_scene_without_inertia_is_refused(
    words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("light.yaml").write_text(LIGHT.replace("MASS", "parameters: {m: 0}, "))
    assert main([words[0], "light.yaml", *words[1:], "--scene", "a"]) == 1
    found = capsys.readouterr()
    assert "error[E0404]" in found.err and "`m` is zero there" in found.err and not found.out
    assert not Path("made").exists()
    Path("light.yaml").write_text(LIGHT.replace("MASS", ""))
    assert main([words[0], "light.yaml", *words[1:], "--scene", "a"]) == 0


@pytest.mark.parametrize("more", [[], ["--python"]])
def test_constraints_without_rank_are_refused_though_the_scene_does_not_need_them(
    more: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """z falls by itself, but the motion of the other two is not determined; as `check` says it."""
    spec = tmp_path / "rank.yaml"
    spec.write_text(
        "nhc: 1\nsystem: rank\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nV: z\n"
        "constraints: [\"x*x' + y*y' = 0\"]\nquasi_velocities: {v: x', w: z'}\n"
        "scenes: {a: {time: [0, 1], need: [z]}}\n"
    )
    assert main(["check", str(spec)]) == 0
    assert "the scene `a` cannot run: the constraint `c1` restricts no velocity" in capsys.readouterr().out
    assert main(["run", str(spec), *more]) == 3
    found = capsys.readouterr()
    assert "no formulation has a motion" in found.err and not found.out
