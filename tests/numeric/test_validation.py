"""What is emitted is what the equations say, exactly; whatever is wrong in it is told, in whichever function."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.trees.sphere import Sphere
from nhc.pipeline import Options, compare, model, reduce_scene
from nhc.program.build import build_functions
from nhc.program.ir import Binary, Function, Number, Result, Solve, Statement, Store, Sweep
from nhc.program.planning.planner import Planner
from nhc.program.planning.scene import ScenePlanner
from nhc.program.reduced import build_scene_functions
from nhc.program.validation.scenes import validate_scene, validate_scene_functions
from nhc.program.validation.validate import Kept, validate, validate_functions
from tests.numeric.test_exchanges import CASES, case
from tests.numeric.test_spheres import hanging
from tests.support import ROOT

GALLERY = sorted((ROOT / "specs").glob("*.yaml"))
_ONE = Number(Fraction(1))

JUMPS = """nhc: 1
system: jumps
coordinates: [x, y, th]
parameters: {m: 1.3, J: 0.4, k: 2, mu: 0.3}
T: m/2*(x'^2 + y'^2) + J/2*th'^2
V: k*abs(x)^3 + sqrt(x^2 + y^2) + max(x, y)^2 + exp(-th)*atan2(y, x)
forces: {th: -mu*sign(th')*x^(4/3)}
constraints: ["x'*sin(th) - y'*cos(th) = 0"]
outputs: {far: abs(x' + y)}
"""


def planners(source: Source) -> Iterator[Planner]:
    system = resolve(decode(source))
    for formulation in applicable(system):
        yield Planner(equations_of(system, formulation), formulation)


def verdicts(text: str) -> dict[str, Kept]:
    return compare(Source("spec.yaml", text))[1]


@pytest.mark.sample(2)
@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)
def test_of_every_gallery_system(path: Path) -> None:
    system = resolve(decode(read(str(path))))
    for formulation in applicable(system):
        kept = validate(equations_of(system, formulation), formulation)
        assert set(kept.values()) == {True}
        assert {"rhs", "velocities", "accelerations", "reactions", "energy", "jacobian"} <= kept.keys()


def test_of_functions_that_jump() -> None:
    for functions in verdicts(JUMPS).values():
        assert set(functions.values()) == {True}


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "name",
    ["chaplygin_sleigh", "snakeboard", "heavy_top_quaternion", "holonomic_pendulum", "n_snake3", "pumped_pendulum"],
)
def test_whatever_is_changed_is_seen(name: str) -> None:
    """Each result, and what is solved by numbers."""
    source = read(str(ROOT / "specs" / f"{name}.yaml"))
    changed = 0
    for planner in planners(source):
        functions = build_functions(planner)
        for k, function in enumerate(functions):
            for body in _changes(function):
                spoilt = [*functions]
                spoilt[k] = replace(function, body=body)
                found = validate_functions(planner, spoilt)
                assert False in found.values(), (planner.formulation.name, function.name)
                changed += 1
    assert changed > 20


def test_what_stands_in_is_looked_at() -> None:
    """Where a pivot of the order of elimination is small, another function stands in."""
    found = model(case(*CASES[0]).source)
    planner = Planner(found.equations, found.formulation)
    functions = build_functions(planner)
    (rhs,) = (function for function in functions if function.name == "rhs")
    assert rhs.otherwise is not None
    assert set(validate_functions(planner, functions).values()) == {True}
    for body in _changes(rhs.otherwise):
        other = replace(rhs, otherwise=replace(rhs.otherwise, body=body))
        kept = validate_functions(planner, [other if function is rhs else function for function in functions])
        assert False in kept.values()


def _changes(function: Function) -> Iterator[tuple[Statement, ...]]:
    """The function's body with one result that is one too large, or one right side of what is solved for."""
    for k, statement in enumerate(function.body):
        for other in _spoil(statement):
            yield (*function.body[:k], other, *function.body[k + 1 :])


def _spoil(statement: Statement) -> Iterator[Statement]:
    if isinstance(statement, Store | Result):
        yield replace(statement, value=Binary("+", _ONE, statement.value))
    elif isinstance(statement, Solve):
        for k, column in enumerate(statement.columns):
            other = (Binary("+", _ONE, column[0]), *column[1:])
            yield replace(statement, columns=(*statement.columns[:k], other, *statement.columns[k + 1 :]))
    elif isinstance(statement, Sweep):
        for k, inner in enumerate(statement.body):
            if isinstance(inner, Store):
                (changed,) = _spoil(inner)
                assert isinstance(changed, Store)
                yield replace(statement, body=(*statement.body[:k], changed, *statement.body[k + 1 :]))


def test_an_error_on_the_way_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Rods of unequal lengths that are taken for those of equal ones: an error that there was."""
    text = hanging("fixed", 2, 5).replace(" l1*(", " 2*(").replace(" l2*(", " 3*(")
    assert verdicts(text)["lagrange"]["accelerations"]
    whole = Sphere.on_foot
    monkeypatch.setattr(
        Sphere, "on_foot", lambda self, graph, vector: [graph.scale(2, x) for x in whole(self, graph, vector)]
    )
    assert verdicts(text)["lagrange"]["reactions"] is False
    path = tmp_path / "rods.yaml"
    path.write_text(text)
    assert main(["compare", str(path)]) == 1
    assert "of lagrange do NOT give what its equations say" in capsys.readouterr().out
    assert main(["compare", str(path), "--json"]) == 1
    assert False in json.loads(capsys.readouterr().out)["emitted"]["lagrange"].values()


# --- the models of scenes -----------------------------------------------------------------------------------


@pytest.mark.sample(6)
@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)
def test_of_every_scene_of_the_gallery(path: Path) -> None:
    source = read(str(path))
    for scene in decode(source).scenes:
        for fold in (False, True):
            made = reduce_scene(source, Options(scene=scene.name, reduce=True, fold=fold))
            assert set(validate_scene(made).values()) == {True}


@pytest.mark.parametrize(
    ("name", "scene"), [("rolling_disk", "lean"), ("diff_drive", "spiral"), ("heavy_top", "waking")]
)
def test_whatever_is_changed_in_a_model_is_seen(name: str, scene: str) -> None:
    source = read(str(ROOT / "specs" / f"{name}.yaml"))
    planner = reduce_scene(source, Options(scene=scene, reduce=True)).planner
    functions = build_scene_functions(planner, ())
    for function in functions:
        for body in _changes(function):
            spoilt = [replace(f, body=body) if f is function else f for f in functions]
            assert validate_scene_functions(planner, spoilt)[function.name] is False


def test_a_model_that_is_wrong_is_told(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reduce", "rolling_disk", "--scene", "lean"]) == 0
    assert "exact at every state: rhs, state, outputs, jacobian" in capsys.readouterr().out

    def without(planner: ScenePlanner, only: Sequence[str]) -> tuple[Function, ...]:
        functions = build_scene_functions(planner, only)
        return tuple(replace(f, body=next(_changes(f))) if f.name == "rhs" else f for f in functions)

    monkeypatch.setattr("nhc.program.validation.scenes.build_scene_functions", without)
    assert main(["reduce", "rolling_disk", "--scene", "lean", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)["exact"]
    assert found["rhs"] is False and found["state"] is True
    assert main(["reduce", "rolling_disk", "--scene", "lean"]) == 1
    assert "NOT what the full equations give: rhs" in capsys.readouterr().out
