"""Start values may speak of definitions that parameters alone make up, as they may of parameters."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main
from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of

SPEC = """\
nhc: 1
system: bowl
coordinates: {x: {unit: m}, y: {unit: m}}
parameters: {R: {value: 0.5, unit: m}, a: {value: 0.1, unit: m}, g: {value: 9.81, unit: m/s^2}, none: {value: 0, unit: s}}
define:
  d: 2*half
  w: sqrt(g/d)
  half: (R - a)/2
  late: t*g
  high: y + a
  fast: a/none
T: (x'^2 + y'^2)/2
V: g*y
holonomic: [x^2 + y^2 = d^2]
quasi_velocities: {v: (x*y' - y*x')/d}
scenes:
  go: {initial: {y: -d, START}, time: [0, 1], need: [v, y]}
  wide: {parameters: {R: 1.1}, initial: {y: -2*half, v: d*w}, time: [0, 1]}
"""


def write(folder: Path, start: str) -> str:
    path = folder / "bowl.yaml"
    path.write_text(SPEC.replace("START", start))
    return str(path)


def test_definitions_have_their_values_in_the_scene() -> None:
    spec = decode(Source("bowl.yaml", SPEC.replace("START", "v: w*d/2")))
    system = resolve(spec)
    go, wide = (start_of(system, scene) for scene in spec.scenes)
    assert go.q == pytest.approx((0, -0.4)) and go.v == pytest.approx(((9.81 * 0.4) ** 0.5 / 2, 0))
    assert wide.q == pytest.approx((0, -1)) and wide.v == pytest.approx((9.81**0.5, 0))


@pytest.mark.parametrize("name", ["late", "high"])
def test_what_varies_is_refused(name: str) -> None:
    with pytest.raises(SpecError) as refused:
        decode(Source("bowl.yaml", SPEC.replace("START", f"v: {name}*w")))
    (found,) = refused.value.diagnostics
    assert found.code == "E0314" and found.message.startswith(f"`{name}` is not constant")


def test_a_definition_without_a_value_is_no_start() -> None:
    spec = decode(Source("bowl.yaml", SPEC.replace("START", "v: fast")))
    with pytest.raises(SpecError, match="no real, finite value"):
        start_of(resolve(spec), spec.scenes[0])


def test_units_of_definitions_count(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", write(tmp_path, "v: w")]) == 1
    assert "the start of `v` must be m/s, found 1/s" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "spoken", "written"),
    [
        (["run", "--points", "3", "--set"], "v=d/5", "v=(R - a)/5"),
        (["linearize", "--about"], "y=-d", "y=a - R"),
    ],
)
def test_the_command_line_takes_them_too(
    options: list[str], spoken: str, written: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, outputs = write(tmp_path, "v: 0"), list[str]()
    for pair in (spoken, written):
        assert main([*options, pair, path]) == 0
        outputs.append(capsys.readouterr().out)
    assert outputs[0] == outputs[1]


def test_a_held_value_may_be_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["linearize", "--about", "y=-d", "--hold", "y=-d", write(tmp_path, "v: 0")]) == 0
    assert "damping ratio" in capsys.readouterr().out


def test_a_smaller_spec_keeps_those_of_its_start(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, smaller = write(tmp_path, "v: w*d/20"), tmp_path / "smaller.yaml"
    assert main(["reduce", path, "--scene", "go", "--tol", "0.01", "-o", str(smaller)]) == 0
    capsys.readouterr()
    assert main(["check", str(smaller)]) == 0
    assert "w*d/20" in smaller.read_text() and "w: sqrt(g/d)" in smaller.read_text()


@pytest.mark.parametrize("quasi", ["", "quasi_velocities: {spin: 0.001*wx + wz, u: x'}\n"])
def test_an_angular_velocity_says_nothing_of_quasi_velocities(quasi: str) -> None:
    """What a scene leaves open is zero: components beside the one that is given, not a form that would make them large."""
    text = "nhc: 1\nsystem: s\ncoordinates: [x]\nrotation: {R: {velocities: [wx, wy, wz], frame: space}}\n"
    text += f"T: (x'^2 + wx^2 + wy^2 + wz^2)/2\n{quasi}scenes: {{go: {{initial: {{wz: 1}}, time: [0, 1]}}}}\n"
    system = resolve(decode(Source("s.yaml", text)))
    start = start_of(system, system.spec.scenes[0])
    assert list(start.v) == pytest.approx([0, 0, 0, 0, 0.5])


def test_a_derivation_does_not_replace_its_spec(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = write(tmp_path, "")
    assert main(["derive", path, "-o", path, "--force"]) == 2
    assert "is the spec itself" in capsys.readouterr().err
    assert Path(path).read_text(encoding="utf-8").startswith("nhc: 1")
