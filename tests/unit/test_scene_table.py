"""What `nhc reduce --set` writes: the spec with the scene's values changed, and nothing else."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from nhc.cli import main
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.pipeline import Options, program
from nhc.simulate.changes import Changes, changed
from nhc.study.simplify.draft import draft_of
from nhc.study.simplify.text import write_draft
from tests.support import python_model

CRANK = """nhc: 1
system: crank
coordinates: [a, b, x, v]
parameters: {l: 3}
quasi_velocities: {w: 2*a'}
T: (a'^2 + b'^2 + x'^2 + v'^2)/2
holonomic: ["cos(a) + l*cos(b) = x", "sin(a) - l*sin(b) = 0"]
scenes:
  still: {time: [0, 1]}
  crank: {initial: {a: pi/4, b: {near: 0.2}, x: {near: 4}, w: 1}, time: [0, 1], need: [x]}
"""
SPIN = """nhc: 1
system: spin
coordinates: [x]
parameters: [m]
rotation: {R: {velocities: [p, q, r]}}
T: m/2*x'^2 + p^2/2 + q^2 + r^2
V: R_z3
scenes: {go: {initial: {R: {axis: [1, 0, 0], angle: 1}, r: 2}, time: [0, 1], parameters: {m: 2}}}
"""


@pytest.mark.parametrize(
    ("text", "scene", "values", "time"),
    [
        (CRANK, "crank", ("a=pi/3, l=7/2, v'=l/2",), ""),
        (CRANK, "still", ("x=4, v'=0.1",), "1/3 : 2*pi"),
        (CRANK, "crank", (), "5"),
        (SPIN, "go", ("R_1=0.25, q=1",), "2"),
        (SPIN, "go", ("m=1e-3",), ""),
    ],
)
def test_the_written_scene_is_the_changed_one(text: str, scene: str, values: tuple[str, ...], time: str) -> None:
    """Same start, values and time, though each key of the scene may be there or not; other scenes go, as ever."""
    source = Source("own.yaml", text)
    spec = decode(source)
    chosen = next(one for one in spec.scenes if one.name == scene)
    spec, wanted = changed(spec, chosen, Changes(values, time))
    draft = draft_of(source, wanted, changed=True)
    again = decode(Source("own.yaml", write_draft(draft, draft.change([]))))
    start = start_of(resolve(spec), wanted)
    (found,) = again.scenes
    own = start_of(resolve(again), found)
    assert (own.time, own.p) == (start.time, start.p)
    assert [need.name for need in found.need] == [need.name for need in chosen.need]
    assert (own.q, own.v) == (pytest.approx(start.q, abs=1e-15), pytest.approx(start.v, abs=1e-15))


def test_the_emitted_model_is_that_of_the_changed_scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By its start and by what its functions deliver there; what was changed stands in its head."""
    source = Source("crank.yaml", CRANK)
    (tmp_path / "crank.yaml").write_text(CRANK)
    slope = math.asin(math.sin(math.pi / 4) / 4)
    cases: list[tuple[Changes, list[str], list[float], tuple[float, float]]] = [
        (Changes(), [], [math.cos(math.pi / 4) + math.sqrt(8.5)], (0, 1)),
        (Changes(("w=3, l=4",), "1:2", ("b", "a'")), ["w=3, l=4; time 1:2"], [slope, 1.5], (1, 2)),
        (Changes(("w=3", "l=4"), "", ("b",)), ["w=3, l=4"], [slope], (0, 1)),
    ]
    for changes, notes, wanted, time in cases:
        made = program(source, Options(scene="crank", reduce=True, changes=changes))
        (data,) = made.scenes
        assert (data.time, data.need) == (time, changes.needs or ("x",))
        model = python_model(render(made, "python", EmitOptions())["crank.py"], "crank")
        assert model.outputs(time[0], data.y, data.p) == pytest.approx(wanted, abs=1e-12)
        options = [*(word for value in changes.values for word in ("--set", value)), "--time", changes.time or "0:1"]
        options += ["--need", ",".join(changes.needs or ["x"])]
        assert main(["emit", str(tmp_path / "crank.yaml"), "-l", "c", "--scene", "crank", *options, "--stdout"]) == 0
        text = capsys.readouterr().out
        assert [f"other values than those of the spec's scene: {note}" in text for note in notes] == [True] * len(notes)
        assert all(f"out[{k}] = {name}" in text for k, name in enumerate(changes.needs))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--lang", "c", "--set", "w=3"], "they need `--scene`"),
        (["--lang", "latex", "--scene", "crank", "--need", "a"], "they need `--scene`"),
        (["--lang", "c", "--scene", "crank", "--set", "u=3"], "`u`"),
        (["--lang", "c", "--scene", "crank", "--time", "0"], "ends where it starts"),
        (["--lang", "python", "--scene", "crank", "--need", "q"], "names `q`, which is no quantity"),
    ],
)
def test_changes_that_nothing_can_be_made_of(
    options: list[str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "crank.yaml").write_text(CRANK)
    assert main(["emit", str(tmp_path / "crank.yaml"), *options, "-o", str(tmp_path / "out")]) in (1, 2)
    assert message in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_the_exact_model_is_that_of_the_changed_scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With the spring gone, and not before, the one mass does not depend on the other, and that other one goes on as it is."""
    spec = tmp_path / "pair.yaml"
    spec.write_text(
        "nhc: 1\nsystem: pair\ncoordinates: [x, y]\nparameters: {k: 2}\nT: x'^2 + y'^2\nV: x^2 + k*(x - y)^2\n"
        "scenes: {go: {initial: {x: 1}, time: [0, 1], need: [x]}}\n"
    )
    found = []
    for options in ((), ("--set", "k=0"), ("--need", "ydot, energy, x, energy"), ("--need", "y", "--set", "k=0")):
        assert main(["reduce", str(spec), "--fold", "--json", *options]) == 0
        data = json.loads(capsys.readouterr().out)
        found.append((data["reduced"]["state"], data["need"], data["changes"]))
    assert found == [
        (["x", "y", "x'", "y'"], ["x"], []),
        (["x", "x'"], ["x"], ["other values than those of the spec's scene: k=0"]),
        (["x", "y", "x'", "y'"], ["y'", "energy", "x"], []),
        (["y"], ["y"], ["other values than those of the spec's scene: k=0"]),
    ]
    assert main(["reduce", str(spec), "--need", "x,z"]) == 2
    assert "`--need` names `z`, which is no quantity of this spec" in capsys.readouterr().err
    assert main(["reduce", str(spec), "--need", "y'", "--tol", "1e-3", "-o", str(tmp_path / "less.yaml")]) == 0
    assert "    need: [y']\n" in (tmp_path / "less.yaml").read_text()
