"""The Jacobian written out, by rows and by columns: three programs with the same values, and those of differences of ``rhs``."""

from __future__ import annotations

import ctypes
import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import pytest

import nhc.program.planning.jacobian as routes
from benchmarks.models import source
from nhc.algebra.graph import Node
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import read
from nhc.pipeline import Options, program
from nhc.program.ir import Evaluate, Program, Store, Sweep
from nhc.program.plan import SweepPlan
from nhc.program.planning.base import PlannerBase
from tests.numeric.test_bodies_on_rotations import Mixed
from tests.numeric.test_chains import ball_joints, links, spherical
from tests.numeric.test_spatial_chains import Tree
from tests.support import CModel, compile_c, error, python_model, spec_path
from tests.trees import joints

STRAIGHT = (
    "double_pendulum",
    "pumped_pendulum",
    "heavy_top",
)  # q' is the velocities that are kept: nothing to differentiate
SYSTEMS = ("rolling_disk", "n_trailer3", "n_snake3", "roller_racer", "snakeboard", *STRAIGHT)
CHAIN = "pendulum5"  # solved from its leaf: the rates themselves are differentiated, as of the heavy top, by a detour


def _program(name: str) -> Program:
    given = source(name) if name == CHAIN else read(str(spec_path(name)))
    return program(given, Options(only=("rhs", "jacobian")))


def _columns_only(planner: object, nodes: Sequence[Node], solve: object) -> SweepPlan:
    """In place of the sweep over rows: one that is never chosen."""
    return replace(SWEEP_ROWS(planner, nodes, solve), offsets=(0,) * 10_000)


SWEEP_ROWS: Callable[..., SweepPlan] = routes.sweep_rows


@pytest.mark.parametrize("name", [*SYSTEMS, CHAIN])
def test_all_routes_agree(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routes, "LONGEST", 10**9)
    monkeypatch.setattr(routes, "SPARED", 10**9)
    written = _program(name)
    monkeypatch.setattr(routes, "LONGEST", 0)
    found = {"written out": written, "chosen": _program(name)}
    monkeypatch.setattr(routes, "SPARED", -(10**9))
    monkeypatch.setattr(routes, "SLOWER", 10**9)
    found["velocities swept too"] = _program(name)
    monkeypatch.setattr(routes, "sweep_rows", _columns_only)
    found["columns"] = _program(name)
    sweeps = {key: [s for s in made.functions[-1].body if isinstance(s, Sweep)] for key, made in found.items()}
    assert not sweeps["written out"] and sweeps["chosen"] and sweeps["columns"]
    if name not in (*STRAIGHT, CHAIN):
        assert len(sweeps["velocities swept too"]) > len(sweeps["chosen"])
    modules = {
        key: python_model(render(made, "python", EmitOptions())[f"{name}.py"], name) for key, made in found.items()
    }
    module, rng, compared = modules["written out"], random.Random(name), 0
    size = len(module.STATE)
    for _ in range(6):
        t, y = rng.uniform(0, 2), [rng.uniform(0.1, 0.9) for _ in range(size)]
        try:
            expected = [x for row in module.jacobian(t, y) for x in row]
        except module.SingularModelError:
            continue
        compared += 1
        for other in [key for key in found if key != "written out"]:
            assert error([x for row in modules[other].jacobian(t, y) for x in row], expected) < 1e-11
        assert error(expected, _differences(module.rhs, t, y)) < 1e-6
    assert compared >= 3


def _by_matrix(planner: PlannerBase) -> list[Node]:
    return routes.make_residual(planner, *planner.dense_system())


def _along_tree(planner: PlannerBase) -> list[Node]:
    assert planner.route.residual is not None
    return planner.route.residual(planner.equations.motion.rates)


ALONG = {
    "planar": lambda: Source("t.yaml", links(3, 6, "driven")),
    "spherical": lambda: Source("t.yaml", spherical(2, 4, "fixed")),
    "bodies": lambda: joints(3),
    "Euler's angles": lambda: Source("t.yaml", ball_joints(5, 3, "free")),
    "rotations": lambda: Source("t.yaml", Tree(2, 3, base="free", frame="body").text()),
    "a rolling ball": lambda: Source("t.yaml", Mixed(("R", "01"), base="rolling").text()),
}


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", ALONG)
def test_a_pass_over_forces_and_accelerations_has_the_slopes_of_the_rates(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Rows by M^-1 of the residual along the tree; of that by the matrix, or of the rates themselves; columns; differences."""
    given, found = ALONG[name](), {}
    monkeypatch.setattr(routes, "LONGEST", 0)
    monkeypatch.setattr(routes, "_write_sparse", lambda *_: None)
    for key, worth, residual in (("rates", 0.0, _by_matrix), ("residual", 10.0, _along_tree)):
        monkeypatch.setattr(routes, "WORTH", worth)
        monkeypatch.setattr(routes, "_shorter_residual", residual)
        found[key] = program(given, Options(only=("rhs", "jacobian")))
    monkeypatch.setattr(routes, "sweep_rows", _columns_only)
    monkeypatch.setattr(routes, "_cost", lambda *_: 1)
    found["residual by columns"] = program(given, Options(only=("rhs", "jacobian")))
    bodies = {key: made.functions[-1].body for key, made in found.items()}
    assert len(set(map(repr, bodies.values()))) == 3
    modules = {
        key: python_model(next(iter(render(made, "python", EmitOptions()).values())), f"along_{k}")
        for k, (key, made) in enumerate(found.items())
    }
    rng = random.Random(name)
    for _ in range(4):
        t, y = rng.uniform(0, 2), [rng.uniform(0.1, 0.9) for _ in modules["rates"].STATE]
        expected = [x for row in modules["rates"].jacobian(t, y) for x in row]
        for other in ("residual", "residual by columns"):
            assert error([x for row in modules[other].jacobian(t, y) for x in row], expected) < 1e-11
        assert error(expected, _differences(modules["rates"].rhs, t, y)) < 1e-6


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["rolling_disk", "n_trailer3", "snakeboard", "bicycle", "chaplygin_ball_quaternion"])
def test_dense_routes_agree(name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Multiplier equations: each entry an unknown of a dense solve, or sweeps with rows of the inverse; in Python and in C."""
    found = {}
    for longest in (10**9, 0):
        monkeypatch.setattr(routes, "LONGEST", longest)
        options = Options(formulation="multipliers", only=("rhs", "jacobian"))
        found[longest] = program(read(str(spec_path(name))), options)
    assert not any(isinstance(s, Sweep) for s in found[10**9].functions[-1].body)
    assert any(isinstance(s, Sweep) for s in found[0].functions[-1].body)
    written, swept = (
        python_model(render(made, "python", EmitOptions())[f"{name}.py"], name) for made in found.values()
    )
    files = render(found[0], "c", EmitOptions())
    compiled = CModel(name, ctypes.CDLL(str(compile_c(files, tmp_path, name))), {})
    rng, size = random.Random(name), len(written.STATE)
    for _ in range(6):
        t, y = rng.uniform(0, 2), [rng.uniform(0.1, 0.9) for _ in range(size)]
        expected = [x for row in written.jacobian(t, y) for x in row]
        assert error([x for row in swept.jacobian(t, y) for x in row], expected) < 1e-10
        assert error(compiled("jacobian", size * size, t, y, written.DEFAULTS), expected) < 1e-10
        assert error(expected, _differences(written.rhs, t, y)) < 1e-5


def test_the_bicycle_has_a_sweep_for_its_velocities() -> None:
    """Its places depend on the angles in long expressions: four passes in place of some hundreds of operations."""
    (jacobian,) = (f for f in program(source("bicycle"), Options(only=("jacobian",))).functions if f.name == "jacobian")
    (velocities, rates) = (s for s in jacobian.body if isinstance(s, Sweep))
    written = len(set(velocities.offsets)) * sum(isinstance(s, Store) for s in velocities.body)
    assert len(velocities.offsets) == 4 and written == 24 and len(rates.offsets) == 3


def _differences(rhs: Callable[[float, list[float]], list[float]], t: float, y: list[float]) -> list[float]:
    h, size = 1e-5, len(y)
    columns = []
    for j in range(size):
        high, low = (rhs(t, [v + s * h * (k == j) for k, v in enumerate(y)]) for s in (1, -1))
        columns.append([(a - b) / (2 * h) for a, b in zip(high, low, strict=True)])
    return [columns[j][i] for i in range(size) for j in range(size)]


def test_a_long_model_calls_its_rhs_for_accelerations_and_reactions(monkeypatch: pytest.MonkeyPatch) -> None:
    from nhc.program.planning import planner

    made = {}
    for limit in (0, 10**9):
        monkeypatch.setattr(planner, "CALLED", limit)
        made[limit] = program(source("trailers3"), Options())
    calling = {f.name for f in made[0].functions if any(isinstance(s, Evaluate) for s in f.body)}
    assert calling == {"accelerations", "reactions"}
    assert not any(isinstance(s, Evaluate) for f in made[10**9].functions for s in f.body)
    first, second = (
        python_model(render(p, "python", EmitOptions())["trailers3.py"], "trailers3") for p in made.values()
    )
    rng = random.Random("trailers3")
    for _ in range(5):
        y = [rng.uniform(-0.7, 0.7) for _ in first.STATE]
        for function in ("accelerations", "reactions"):
            assert error(getattr(first, function)(0.0, y), getattr(second, function)(0.0, y)) < 1e-12
