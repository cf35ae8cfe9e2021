"""``nhc emit`` names the scenes whose start the functions refuse, and only these; ``--scene`` takes what is regular there."""

from __future__ import annotations

import math
import re
import subprocess
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import compile_c, python_model

SPECS = Path(__file__).resolve().parents[2] / "specs"
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
        (["--lang", "c", "--scene", "bad"], []),
        (["--lang", "c", "--scene", "bad", "-f", "euler-lagrange"], ["bad"]),
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


TWICE = SPEC.replace("{v: x', w: phi'}", "{v: x', w: phi'}\noutputs: {along: cos(phi)*x' + sin(phi)*y'}").replace(
    "y': 1, w: 0.1}, time: [0, 1]}", "y': 1, w: 0.1}, time: [0, 1], need: [x, y, v, w, along, energy]}"
)


def after(t: float) -> list[float]:
    """x, y, x', phi', the velocity along the blade and the energy of the skate that starts along y: it runs in a circle."""
    phi = math.pi / 2 + 0.1 * t
    return [10 * (math.sin(phi) - 1), -10 * math.cos(phi), math.cos(phi), 0.1, 1.0, 0.505]


@pytest.mark.parametrize("start", ["pi/2", "1.57", "pi/2 - 1e-9"])
def test_a_scene_has_a_coframe_that_is_regular_where_it_starts(start: str, tmp_path: Path) -> None:
    told: list[str] = []
    source = Source("two.yaml", TWICE.replace("phi: pi/2", f"phi: {start}"))
    files = emit(source, "c", Options(scene="bad", driver=True), told.append)
    assert not told
    why = "Why: chosen for the start of the scene bad, where euler-lagrange with v, w is singular or nearly so"
    assert all(why in " ".join(files[name].replace("\n *", "").split()) for name in ("two.h", "two.c"))
    program = compile_c(files, tmp_path, "two", library=False)
    done = subprocess.run([program, "bad", "2", "1e-11"], capture_output=True, text=True, check=True)
    begin, end = ([float(x) for x in line.split(",")[1:]] for line in done.stdout.splitlines()[1:])
    near = 2 * abs(math.pi / 2 - eval(start, {"pi": math.pi}))
    assert begin == pytest.approx(after(0.0), abs=1e-9 + near) and end == pytest.approx(after(1.0), abs=1e-9 + near)


def test_what_the_user_names_is_kept_and_other_scenes_are_as_they_were() -> None:
    told: list[str] = []
    (text,) = emit(
        Source("two.yaml", SPEC), "python", Options(formulation="euler-lagrange", scene="bad"), told.append
    ).values()
    assert len(told) == 1 and "the scene `bad` starts where the coframe is singular" in text
    (text,) = emit(Source("two.yaml", SPEC), "python", Options(scene="good"), told.append).values()
    assert len(told) == 1 and "Why: quasi-velocities of the spec" in text


ARMLESS = SPEC.replace("w: phi'}", "w: L*phi'}").replace("system: two", "system: two\nparameters: {L: 0}", 1)


@pytest.mark.parametrize("fold", [False, True])
def test_a_coframe_that_a_parameter_makes_singular(fold: bool) -> None:
    """w = L phi' says nothing of phi where L = 0, at whatever place a scene starts."""
    told: list[str] = []
    spec = ARMLESS.replace("w: 0.1}", "phi': 0.1}")
    (text,) = emit(Source("two.yaml", spec), "python", Options(), told.append).values()
    assert "the scene `good` starts where the coframe is singular" in " ".join(told)
    model = python_model(text, "two")
    with pytest.raises(model.SingularModelError):
        model.rhs(0.0, [0.0, 0.0, 0.0, 1.0, 0.0])
    told.clear()
    (text,) = emit(Source("two.yaml", spec), "python", Options(scene="good", fold=fold), told.append).values()
    assert not told and "Why: chosen for the start of the scene good" in text
    model = python_model(text, "two")
    assert all(math.isfinite(rate) for rate in model.rhs(0.0, [0.0] * len(model.STATE)))


def test_where_the_constraints_lose_rank_no_choice_is_called_better() -> None:
    """Wheels straight across the board: no velocities can be solved for, and rounding must not tell which are better."""
    text = (SPECS / "snakeboard.yaml").read_text()
    told: list[str] = []
    lost = "  lost: {initial: {p_b: pi/2, p_f: pi/2, psi': 1}, time: [0, 1]}\n"
    (made,) = emit(
        Source("board.yaml", f"{text.rstrip()}\n{lost}"), "python", Options(scene="lost"), told.append
    ).values()
    assert len(told) == 1 and "the scene `lost` starts where the constraint `front` follows" in " ".join(made.split())
    assert "chosen for the start" not in made
    told.clear()
    emit(Source("board.yaml", f"{text.rstrip()}\n{lost}"), "c", Options(formulation="multipliers"), told.append)
    assert [line.partition(": ")[2] for line in told] == ["the functions refuse that start, in every formulation"]


def test_a_function_that_the_scenes_model_lacks(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["emit", "chaplygin_sleigh", "-l", "c", "--scene", "speeds_only", "--stdout", "--only"]
    for name, advice in (("energy", "let the scene need `energy`"), ("velocities", "leave `--scene` out\n")):
        assert main([*command, name]) == 2
        assert advice in capsys.readouterr().err
