"""A velocity that the state keeps may have no value where a scene starts, or at the states that `check` tries: log(x) x' at x = 0.

Each verb says so, or takes another formulation; none ends with an internal error.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main

HEAD = "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\n"
SCENE = "scenes: {u: {initial: {x: -1, y': 1}, time: [0, 1], need: [y]}}\n"
FORMS = ["log(x)*x' + z'", "asin(2 + y)*x'", "x'/y", "sqrt(x - 1)*x'", "acos(2 + y)*x' + y'"]


def spec(folder: Path, text: str) -> str:
    path = folder / "s.yaml"
    path.write_text(HEAD + text, encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("form", ["log(x)*z'", "acos(x)*z'", "sqrt(x - 2)*z'", "z'/x"])
def test_check_of_a_constraint_with_a_domain(form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", spec(tmp_path, f'dependent: [z]\nconstraints: ["{form} = x*y*x\'"]\n'), "--explain"]) == 0
    assert "truly nonholonomic" in capsys.readouterr().out


@pytest.mark.sample(4)
@pytest.mark.parametrize("constraint", ["", "constraints: [\"z' = y*x'\"]\n"])
@pytest.mark.parametrize("form", FORMS)
def test_every_verb_about_a_start_without_value(
    form: str, constraint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = f'quasi_velocities: {{v: "{form}"}}\n{constraint}'
    assert main(["check", spec(tmp_path, text)]) == 0
    path = spec(tmp_path, text + SCENE)
    capsys.readouterr()
    assert main(["check", path]) == 0
    capsys.readouterr()
    for more in ([], ["-f", "multipliers"]):
        code = main(["run", path, "--points", "2", *more])
        out = capsys.readouterr().out
        assert code == 0 or (code == 3 and not more)  # where no other formulation is taken it says why
        assert code == 3 or float(out.split(",")[-1]) == pytest.approx(1.0, rel=1e-9)  # y' stays 1
    assert main(["reduce", path, "--scene", "u"]) in (0, 1)
    assert main(["emit", path, "--lang", "python", "--scene", "u", "--stdout"]) in (0, 1)
    assert main(["emit", path, "--lang", "c", "--driver", "-o", str(tmp_path / "c")]) == 0
    assert main(["linearize", path, "--about", "u"]) in (0, 3)


@pytest.mark.parametrize("form", ["log(x)*x' + z'", "x'/y + z'", "x'/(x - 2) + z'"])
def test_a_form_without_value_where_what_is_left_out_is_zero(
    form: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A free particle: what a run leaves out of its state may have no value of its own at 0."""
    scene = "scenes: {u: {initial: {x: 3, y: 2, z: 1, y': 0.5}, time: [0, 1], need: [%s]}}\n"
    for need, end in (("y", 2.5), ("x", 3.0), ("z", 1.0)):
        path = spec(tmp_path, f'quasi_velocities: {{v: "{form}"}}\n' + scene % need)
        for more in ([], ["-f", "multipliers"], ["-f", "euler-lagrange"]):
            assert main(["run", path, "--points", "2", *more]) == 0
            assert float(capsys.readouterr().out.split(",")[-1]) == pytest.approx(end, rel=1e-9)
