"""What a rotation brings into a spec: names, coordinates, a constraint, forms, definitions, starts."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main
from nhc.diagnostics import Source, SpecError
from nhc.language import Spec, decode, read
from nhc.language.expressions.unparse import unparse
from nhc.pipeline import check

HEAD = "nhc: 1\nsystem: s\n"


def make(text: str) -> Spec:
    return decode(Source("s.yaml", HEAD + text))


def test_the_default_names() -> None:
    spec = make("rotation: [R]\nT: R_w1^2 + R_w2^2 + R_w3^2")
    (rotation,) = spec.rotations
    assert rotation.frame == "body"
    assert rotation.coordinates == ("R_0", "R_1", "R_2", "R_3")
    assert rotation.velocities == ("R_w1", "R_w2", "R_w3")
    assert rotation.entries[:4] == ("R_x1", "R_x2", "R_x3", "R_y1")
    assert make("rotation: {R: {frame: space}}\nT: R_wx^2").rotations[0].velocities == ("R_wx", "R_wy", "R_wz")


def test_names_of_ones_own() -> None:
    text = "rotation: {R: {velocities: [p, q, ω], quaternion: [e0, e1, e2, e3], about: a body}}\nT: p^2 + q^2 + omega^2"
    (rotation,) = make(text).rotations
    assert rotation.velocities == ("p", "q", "omega")
    assert rotation.coordinates == ("e0", "e1", "e2", "e3")
    assert rotation.about == "a body"


def test_what_it_brings() -> None:
    text = (
        "coordinates: [x]\nrotation: {R: {velocities: [a, b, c]}}\ndefine: {X: x + R_x3}\nT: x'^2 + a^2 + b^2 + c^2\n"
        "holonomic: [x = R_y2]\nquasi_velocities: {v: 2*x'}"
    )
    spec = make(text)
    assert [c.name for c in spec.coordinates] == ["x", "R_0", "R_1", "R_2", "R_3"]
    assert [float(c.start) for c in spec.coordinates] == [0, 1, 0, 0, 0]
    assert [h.name for h in spec.holonomic] == ["h1", "R_norm"]
    assert [d.name for d in spec.quasi_velocities] == ["v", "a", "b", "c"]
    assert [d.name for d in spec.definitions] == [
        "R_x3",
        "R_y2",
        "X",
    ]  # entries that are spoken of, in the matrix's order
    assert unparse(spec.definitions[0].value) == "2*(R_1*R_3 + R_0*R_2)/(R_0^2 + R_1^2 + R_2^2 + R_3^2)"


def test_rates_of_entries_may_be_written_in_every_way() -> None:
    spec = make("rotation: {R: {velocities: [a, b, c]}}\nT: a^2 + b^2 + c^2 + R_z3'^2 + R_x1dot^2 + dot(R_y2)^2")
    assert [d.name for d in spec.definitions] == ["R_x1", "R_y2", "R_z3"]


def test_an_entry_may_be_shown() -> None:
    spec = make("rotation: {R: {velocities: [a, b, c]}}\nT: a^2 + b^2 + c^2\noutputs: {R_z3: R_z3, E: energy}")
    assert [o.name for o in spec.outputs] == ["R_z3", "E"]


@pytest.mark.parametrize("frame", ["body", "space"])
def test_a_force_may_be_given_on_an_entry(frame: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    head = f"{HEAD}rotation: {{R: {{velocities: [p, q, r], frame: {frame}}}}}\nT: p^2 + 2*q^2 + 3*r^2\n"
    texts = {
        "entry": "forces: {R_z3: 0.1 + R_x1, R_y1: -R_y1'}\n",
        "named": "define: {Z: R_z3, Y: R_y1}\nforces: {Z: 0.1 + R_x1, Y: -Y'}\n",
        "other": "forces: {R_z3: 0.1 + R_x1, R_y2: -R_y1'}\n",
    }
    paths = [tmp_path / f"{name}.yaml" for name in texts]
    for path, text in zip(paths, texts.values(), strict=True):
        path.write_text(head + text)
    assert make(head.removeprefix(HEAD) + texts["entry"]).forces[1].name == "R_y1"
    assert main(["compare", str(paths[0]), str(paths[1])]) == 0
    assert "the same motion, for all values" in capsys.readouterr().out
    assert main(["compare", str(paths[0]), str(paths[2])]) == 1


def test_a_start_gives_all_four_parts() -> None:
    text = (
        "rotation: {R: {velocities: [a, b, c]}}\nparameters: {k: 2}\nT: a^2 + b^2 + c^2\n"
        "scenes: {s: {time: [0, 1], initial: {R: {axis: [0, 0, 2], angle: k}, a: 1}}}"
    )
    starts = {i.name: unparse(i.value) for i in make(text).scenes[0].initial}
    assert starts["R_0"] == "cos(k/2)"
    assert starts["R_3"] == "sin(k/2)*(2/sqrt(0^2 + 0^2 + 2^2))"
    assert list(starts) == ["R_0", "R_1", "R_2", "R_3", "a"]


@pytest.mark.parametrize(
    ("given", "parts"),
    [
        ("R_0: 1", ["1", "0", "0", "0"]),
        ("R_0: 0.6, R_2: -0.8", ["0.6", "0", "-0.8", "0"]),
        ("R_0: 2, R_3: 2", [f"{part}/sqrt(2^2 + 0^2 + 0^2 + 2^2)" for part in ("2", "0", "0", "2")]),
        ("R_1: k", [f"{part}/sqrt(1^2 + k^2 + 0^2 + 0^2)" for part in ("1", "k", "0", "0")]),
    ],
)
def test_parts_of_a_quaternion_have_any_length(given: str, parts: list[str]) -> None:
    """What has length 1 stays as it is written."""
    text = (
        "rotation: {R: {velocities: [a, b, c]}}\nparameters: {k: 2}\nT: a^2 + b^2 + c^2\n"
        f"scenes: {{s: {{time: [0, 1], initial: {{{given}, a: 1}}}}}}"
    )
    starts = {i.name: unparse(i.value) for i in make(text).scenes[0].initial}
    assert [starts[f"R_{k}"] for k in range(4)] == parts and starts["a"] == "1"


def test_a_quaternion_of_no_length_is_refused() -> None:
    text = "rotation: {R: {velocities: [a, b, c]}}\nT: a^2 + b^2 + c^2\nscenes: {s: {time: [0, 1], initial: {R_0: 0}}}"
    with pytest.raises(SpecError) as raised:
        check(Source("s.yaml", HEAD + text))
    assert any("a quaternion must not be zero" in help for one in raised.value.diagnostics for help in one.help)


def test_a_spec_may_extend_one_with_a_rotation(tmp_path: Path) -> None:
    base = "rotation: {R: {velocities: [a, b, c]}}\nT: a^2 + b^2 + c^2\n"
    (tmp_path / "base.yaml").write_text(HEAD + base)
    (tmp_path / "own.yaml").write_text("nhc: 1\nextends: base.yaml\nrotation: {R: {frame: space}, Q: {}}\n")
    spec = decode(read(tmp_path / "own.yaml"))
    assert [(r.name, r.frame, r.velocities[0]) for r in spec.rotations] == [("R", "space", "a"), ("Q", "body", "Q_w1")]


def test_a_misspelt_torque_is_told_what_there_is_although_no_coordinate_is_declared() -> None:
    with pytest.raises(SpecError) as raised:
        make("rotation: {R: {velocities: [turn, roll, lean]}}\nT: turn^2 + roll^2 + lean^2\nforces: {zzz: 1}")
    assert raised.value.diagnostics[0].help == ("the velocities are `turn`, `roll`, `lean`",)
