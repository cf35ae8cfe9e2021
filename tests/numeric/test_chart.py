"""Small charts of the gallery: errors fall with the tolerance, references confirm one another, failures stay failures."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from nhc.cli.entry import main
from nhc.language import Source, read
from nhc.report.chart_file import make_file
from nhc.simulate.auto import choose_method
from nhc.simulate.c import compile as compiling
from nhc.simulate.changes import Changes
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.opening import open_scene
from nhc.simulate.task import Task
from nhc.simulate.workshop import load
from nhc.study.chart.advice import advise
from nhc.study.chart.case import RESOLVED, Reference, Study
from nhc.study.chart.grid import Grid
from nhc.study.chart.model import ChartModel, compile_chart
from nhc.study.chart.reference import Solution
from nhc.study.chart.single import Rig
from nhc.study.chart.study import chart, cost_of
from tests.support import spec_path

STIFF = """
nhc: 1
system: stiff_drag
about: A particle whose drag in y is strong.
coordinates:
  x: {about: place}
  y: {about: height}
parameters:
  m: {value: 1, about: mass}
  c: {value: RATE, about: drag}
T: m/2*(x'^2 + y'^2)
U: m*cos(x)*y - m/2*x^2
forces:
  y: -c*y'
scenes:
  fall:
    initial: {x: 0.3}
    time: [0, 10]
"""
SMALL = Grid(budget=1e-4, peers=False)


def gallery(name: str) -> Source:
    return read(str(spec_path(name)))


@cache
def sleigh() -> Study:
    grid = replace(
        SMALL, methods=("dop853", "dopri5", "rk4"), tolerances=(1e-3, 1e-6, 1e-9), peers=True, languages=("c", "python")
    )
    return chart(gallery("chaplygin_sleigh"), grid)


def test_errors_fall_with_the_tolerance_in_every_line() -> None:
    lines: dict[tuple[str, str, str], list[float]] = {}
    for result in sleigh().results:
        if not result.failed:
            lines.setdefault(result.case.series, []).append(max(result.error, result.grid_error))
            assert result.best > 0 and result.best <= result.median and result.repeats >= 1
            assert result.error < 30 * result.case.tolerance * (300 if result.case.language == "scipy" else 1)
    assert {"euler-lagrange", "multipliers"} <= {series[0] for series in lines}
    for errors in lines.values():
        assert len(errors) == 3
        assert errors[0] > 30 * errors[1] > 900 * errors[2]


def test_a_chart_of_a_changed_scene_is_that_of_a_spec_with_these_values() -> None:
    grid = replace(SMALL, methods=("dop853",), tolerances=(1e-6,), languages=("c",))
    made = chart(Source("fall.yaml", STIFF.replace("RATE", "2")), replace(grid, changes=Changes(("c=1, y=2",), "4")))
    text = STIFF.replace("RATE", "1").replace("x: 0.3", "x: 0.3, y: 2").replace("[0, 10]", "[0, 4]")
    wanted = chart(Source("fall.yaml", text), grid)
    assert made.time == (0.0, 4.0)
    for kind in (".svg", ".html", ".md", ".json"):  # each of them may be all that a reader has
        assert "scene: c=1, y=2; time 4" in make_file(made, kind) and "other values" not in make_file(wanted, kind)
    assert [r.error for r in made.results] == [r.error for r in wanted.results] and made.results


def test_every_kind_of_chart_says_what_was_measured() -> None:
    made = sleigh()
    for kind in (".svg", ".html", ".md"):
        assert f"Quantities: {', '.join(made.needs)}; t from 0 to {made.time[1]:g}" in make_file(made, kind)
    assert "1 calls" not in "".join(make_file(made, kind) for kind in (".svg", ".md"))


def test_nothing_is_recommended_where_no_run_errs() -> None:
    """A particle that stays where it is."""
    grid = replace(SMALL, methods=("dop853", "rk4"), tolerances=(1e-3, 1e-6), languages=("c",))
    made = chart(Source("fall.yaml", STIFF.replace("RATE", "2").replace("initial: {x: 0.3}", "initial: {}")), grid)
    resting = replace(made, results=tuple(replace(r, error=0.0) for r in made.results))
    assert {a.text.split(":")[0] for a in advise(resting)} == {"nothing to choose by"}
    assert all(a.best is None for a in advise(resting))
    assert any(a.best is not None for a in advise(sleigh()))


LOCKS = """
nhc: 1
system: locks
coordinates: [x, y, th]
parameters: {m: 1, J: 0.5}
T: m/2*(x'^2 + y'^2) + J/2*th'^2
constraints: [cos(th)*y' - sin(th)*x' = 0]
scenes: {turns: {initial: {x': 1, th': 1}, time: [0, 4]}}
"""


def test_equations_that_fail_on_the_way_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """y' = tan(th) x' at a quarter turn: other equations of the same system pass it."""
    path = tmp_path / "locks.yaml"
    path.write_text(LOCKS, encoding="utf-8")
    small = ["--formulations", "voronec", "--methods", "dop853", "--langs", "c", "--no-peers"]
    assert main(["chart", str(path), *small, "-o", str(tmp_path / "locks.md")]) == 3
    told = capsys.readouterr().err
    assert "with the equations of voronec neither dop853 nor radau5 comes to the end" in told
    assert "`nhc run -f voronec --stay` says where they fail" in told


def test_a_chart_notes_a_negative_mass() -> None:
    grid = replace(SMALL, methods=("dop853",), tolerances=(1e-6,), languages=("python",))
    made = chart(Source("fall.yaml", STIFF.replace("RATE", "0.1")), replace(grid, changes=Changes(("m=-1",), "1")))
    assert [note.endswith("`m` is negative there (W0423)") for note in made.notes] == [False, True]


def test_only_right_hand_sides_are_timed_and_no_conversions_of_states(monkeypatch: pytest.MonkeyPatch) -> None:
    job = open_scene(gallery("chaplygin_sleigh"))
    model = ChartModel(compile_chart(job, "dop853"), job)
    repeat = model.rhs_at(job.time[:1], (job.y,), job.p)

    def refuse(values: object) -> None:
        raise AssertionError("an array is made while the clock runs")

    monkeypatch.setattr("nhc.study.chart.model.doubles", refuse)
    repeat(3)
    with pytest.raises(AssertionError):
        model.rhs_at(job.time[:1], (job.y,), job.p)


def test_a_right_hand_side_is_timed_along_the_motion_in_both_languages(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not at the start alone, which may be at rest or lie on one side of a jump."""
    job = open_scene(gallery("pendulum"))
    times = (0.0, 0.5, 1.0)
    nothing = Solution([], [], Reference("", "", "", 0.0, 0.0))
    model = InterpretedModel(job.program, job.events, job.holds)
    rig = Rig("lagrange", job, times, nothing, {}, model)
    seen: set[float] = set()
    whole = model.rhs

    def rhs(t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        seen.add(t)
        return whole(t, y, p)

    def repeat_once(repeat: Callable[[int], None], budget: float) -> tuple[float, float, int]:
        monkeypatch.setattr(model, "rhs", rhs)
        repeat(1)
        return 6.0, 6.0, 1

    monkeypatch.setattr("nhc.study.chart.study.time_repeats", repeat_once)
    cost = cost_of(rig, ("python",), None)
    assert seen == set(times) and cost.python == 2.0  # of three states


def test_a_formulation_that_is_singular_at_the_start_fails_beside_the_others() -> None:
    text = """
nhc: 1
system: skewed
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2)/2
constraints: [sin(z)*x' + cos(z)*y' + z' = 0]
dependent: [x]
scenes: {go: {initial: {y': 1}, time: [0, 0.5]}}
"""
    grid = Grid(methods=("dopri5",), formulations=("multipliers", "voronec"), tolerances=(1e-4,), peers=False)
    study = chart(Source("skewed.yaml", text), grid)
    costs = {cost.formulation: cost for cost in study.costs}
    assert math.isnan(costs["voronec"].python) and math.isfinite(costs["multipliers"].python)
    assert {r.case.formulation for r in study.results if r.failed} == {"voronec"}


def test_c_and_python_make_the_same_errors() -> None:
    known = {(*r.case.series, r.case.tolerance): r for r in sleigh().results if not r.failed}
    compared = 0
    for key, result in known.items():
        if key[2] == "python":
            twin = known[(*key[:2], "c", key[3])]
            assert math.isclose(result.error, twin.error, rel_tol=1e-3, abs_tol=1e-13)
            assert (result.calls, result.steps) == (twin.calls, twin.steps)
            compared += 1
    assert compared == 18


def test_a_fixed_block_that_is_crossed_is_shown_as_failed() -> None:
    made = sleigh()
    crossed = [r for r in made.results if r.case.formulation in ("chaplygin", "voronec")]
    assert crossed and all(
        "determinant" in r.failed and "results beyond it would be wrong" in r.failed and math.isnan(r.error)
        for r in crossed
    )
    assert {what for what, _ in made.left_out} >= {"newton", "lagrange"}
    assert all(a.best is None or a.best.case.formulation not in ("chaplygin", "voronec") for a in advise(made))


def test_the_reference_states_its_own_error_and_is_right() -> None:
    made = sleigh()
    assert 0 <= made.reference.error < 1e-14 and "gauss6" in made.reference.confirmed_by
    assert "dop853" in made.reference.method and made.machine.nhc in made.machine.line
    for result in made.results:
        if not result.failed:
            assert result.unresolved == (not result.error >= RESOLVED * made.reference.error)
            # the sleigh keeps its energy; in the coframe of the knife edge it cannot slip
            assert result.energy < 1e3 * result.case.tolerance
            assert result.residual < 1e-15 or result.case.formulation != "euler-lagrange"


def test_all_formulations_end_at_the_same_reference() -> None:
    grid = replace(SMALL, methods=("dop853",), languages=("c",), tolerances=(1e-12,))
    made = chart(gallery("rolling_disk"), grid)
    assert {r.case.formulation for r in made.results} == {"euler-lagrange", "chaplygin", "multipliers"}
    assert {cost.formulation: cost.twin for cost in made.costs if cost.twin} == {"voronec": "chaplygin"}
    assert ("voronec", "its code is that of chaplygin, statement for statement") in made.left_out
    assert made.reference.error < 1e-12 and all(r.error < 1e-10 for r in made.results)


def test_without_a_compiler_it_charts_python_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiling, "find_compiler", lambda: "")
    monkeypatch.setattr("nhc.study.chart.study.find_compiler", lambda: "")
    monkeypatch.setattr("nhc.study.chart.measure.find_compiler", lambda: "")
    grid = replace(
        SMALL, methods=("dop853",), tolerances=(1e-3, 1e-6), formulations=("auto",), languages=("c", "python")
    )
    made = chart(gallery("chaplygin_sleigh"), grid)
    assert (
        made.languages == ("python",) and "no C compiler" in made.notes[0] and made.machine.compiler == "no C compiler"
    )
    assert [r.case.language for r in made.results] == ["python", "python"]
    assert made.results[0].error > made.results[1].error > 0
    assert made.reference.arithmetic == "double, interpreted" and made.reference.error < 1e-9
    assert math.isnan(made.costs[0].c) and made.costs[0].python > 0


@pytest.mark.parametrize(
    ("rate", "accuracy", "method"),
    [
        ("1e4", 1e-6, "radau5"),
        ("3", 1e-6, "dop853"),
        ("3", 5e-2, "dopri5"),
        ("30", 1e-6, "dop853"),
        ("300", 1e-6, "radau5"),
        ("300", 1e-9, "dop853"),
    ],
)
def test_auto_follows_its_rule(rate: str, accuracy: float, method: str) -> None:
    """A mode of 30/s holds the steps of dopri5 too, but there are only a hundred of them; radau5's at 1e-9 are too short to pay."""
    source = Source("stiff.yaml", STIFF.replace("RATE", rate))
    chosen, why = choose_method(open_scene(source, method="radau5"), accuracy)
    assert chosen == method and ("stiff" in why)


def test_the_rule_of_auto_is_what_a_study_says() -> None:
    """For the stiff particle radau5 needs the least work of the adaptive methods, for the sleigh dop853."""
    grid = replace(SMALL, methods=("dop853", "dopri5", "radau5"), languages=("c",), tolerances=(1e-4, 1e-6))
    stiff = chart(Source("stiff.yaml", STIFF.replace("RATE", "1e4")), replace(grid, formulations=("auto",)))
    assert stiff.reference.error < 1e-12 and "radau5" in stiff.reference.confirmed_by + stiff.reference.method
    work = {r.case.method: r.calls for r in stiff.results if not r.failed and r.case.tolerance == 1e-6}
    assert work["radau5"] < 0.1 * work["dopri5"] and work["radau5"] < 0.1 * work["dop853"]
    calls = {
        r.case.method: r.calls
        for r in sleigh().results
        if r.case.tolerance == 1e-9 and r.case.series[::2] == ("euler-lagrange", "c")
    }
    assert calls["dop853"] < calls["dopri5"] < calls["rk4"]


def test_the_verb_writes_four_files_and_refuses_to_overwrite_others(tmp_path: Path) -> None:
    options = [
        "--methods",
        "dop853",
        "--langs",
        "c",
        "--tolerances",
        "1e-4,1e-8",
        "--formulations",
        "auto",
        "--no-peers",
    ]
    asked = ["chart", "chaplygin_sleigh", "--scene", "glide", *options, "-o", str(tmp_path)]
    assert main(asked) == 0
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == [f"chaplygin_sleigh_glide_chart{kind}" for kind in (".html", ".json", ".md", ".svg")]
    data = json.loads((tmp_path / names[1]).read_text())
    assert data["needs"] == ["x", "y"] and data["tolerances"] == [1e-4, 1e-8] and len(data["results"]) == 2
    assert not any(str(tmp_path) in path.read_text() for path in tmp_path.iterdir())
    (tmp_path / names[2]).write_text("mine")
    assert (
        main(["chart", *["chaplygin_sleigh", "--scene", "glide", *options, "-o", str(tmp_path)]]) != 0
        and (tmp_path / names[2]).read_text() == "mine"
    )


def test_a_named_scene_is_charted_on_its_smallest_state_beside_the_whole_one() -> None:
    grid = replace(SMALL, scene="lean", methods=("dop853",), languages=("c",), tolerances=(1e-6, 1e-11))
    made = chart(gallery("rolling_disk"), grid)
    costs = {cost.formulation: cost for cost in made.costs}
    assert list(costs)[:2] == ["euler-lagrange", "euler-lagrange, full"]
    assert (costs["euler-lagrange"].states, costs["euler-lagrange"].full_states) == (4, 8)
    assert dict(costs["chaplygin"].left).keys() == {"x", "y", "phi", "psi"} and not costs["euler-lagrange, full"].left
    assert costs["multipliers"].states == 10 and not costs["multipliers"].left
    for result in made.results:
        assert not result.failed and result.error < 200 * result.case.tolerance
        assert result.energy < 200 * result.case.tolerance  # the reduced state determines the energy
    text = make_file(made, ".md")
    assert "euler-lagrange (4 of 8 states), chaplygin (4 of 8 states)" in text
    assert "- `phi`: decoupled: only what is left out depends on it (x, y)" in text
    assert json.loads(make_file(made, ".json"))["formulations"][0]["left"][0] == [
        "x",
        "cyclic and not needed: nothing depends on it",
    ]
    assert "What the scene does not need" in make_file(made, ".html")


def test_the_model_that_emit_writes_for_a_scene_is_in_its_chart() -> None:
    """A sleeping top: with its conserved momentum as a parameter it is cheaper than in any formulation of the spec."""
    grid = replace(SMALL, scene="sleeping", methods=("dop853",), languages=("c",), tolerances=(1e-5, 1e-9), peers=True)
    made = chart(gallery("heavy_top"), grid)
    own = made.costs[0]
    assert (
        own.formulation == "scene"
        and own.states == 3
        and ("omega3", "constant of the motion") in [(name, reason[:22]) for name, reason in own.left]
    )
    errors = {
        r.case.tolerance: r.error for r in made.results if r.case.formulation == "scene" and r.case.language == "c"
    }
    assert errors[1e-9] < 1e-7 and errors[1e-9] < 1e-2 * errors[1e-5]


def test_other_needs_reduce_otherwise() -> None:
    grid = replace(SMALL, scene="reference", methods=("dop853",), languages=("c",), tolerances=(1e-8,))
    small = chart(gallery("chaplygin_sleigh"), replace(grid, needs=("v", "w"), formulations=("euler-lagrange",)))
    assert [cost.states for cost in small.costs] == [2] and small.needs == ("v", "w")
    assert all(r.error < 1e-5 for r in small.results)


def test_structure_preserving_methods_stand_in_the_chart_where_they_apply() -> None:
    grid = replace(SMALL, languages=("c",), tolerances=(1e-4, 1e-6), formulations=("multipliers",), methods=())
    made = chart(gallery("contact_oscillator"), grid)
    lines: dict[str, list[float]] = {}
    for result in made.results:
        lines.setdefault(result.case.method, []).append(result.error)
        assert not result.failed and result.best > 0
    assert {"leapfrog", "dla", "perlmutter", "energy"} <= set(lines) and set(made.methods) == set(lines)
    for name in ("leapfrog", "dla", "perlmutter", "energy"):
        coarse, fine = lines[name]
        assert 20 < coarse / fine < 400  # order 2: steps about a tenth as long for two decades
    energies = {r.case.method: r.energy for r in made.results if r.case.tolerance == 1e-4}
    assert energies["energy"] < 1e-10 < energies["rk4"]


def test_structure_preserving_methods_count_the_same_in_both_languages() -> None:
    grid = replace(SMALL, languages=("c", "python"), tolerances=(1e-4,), methods=("leapfrog", "energy"))
    calls: dict[str, set[int]] = {}
    for result in chart(gallery("contact_oscillator"), grid).results:
        calls.setdefault(result.case.method, set()).add(result.calls)
    assert calls.keys() == {"leapfrog", "energy"}
    assert all(max(counts) - min(counts) <= 0.02 * min(counts) and min(counts) > 20 for counts in calls.values())


@pytest.mark.slow
def test_where_they_do_not_apply_it_says_why() -> None:
    sleigh_ = chart(gallery("chaplygin_sleigh"), replace(SMALL, methods=("perlmutter",), tolerances=(1e-2,)))
    assert (
        sleigh_.results == () and ("perlmutter", "does not apply: its mass matrix is not constant") in sleigh_.left_out
    )
    table = chart(
        gallery("ball_on_table"), replace(SMALL, methods=("leapfrog", "dla"), tolerances=(1e-2,), languages=("c",))
    )
    assert {why for what, why in table.left_out if what in ("leapfrog", "dla")} == {
        "does not apply: a constraint is not homogeneous in the velocities"
    }


def test_an_implicit_method_beside_explicit_ones_solves_its_steps() -> None:
    """What starts at zero and stays there but for rounding does not keep the iteration from ending."""
    grid = replace(SMALL, methods=("dop853", "gauss6"), languages=("c", "python"), tolerances=(1e-3, 1e-6))
    made = chart(gallery("chaplygin_sleigh"), replace(grid, formulations=("euler-lagrange",)))
    found = [r for r in made.results if r.case.method == "gauss6"]
    assert len(found) == 4 and not any(r.failed for r in found) and max(r.error for r in found) < 1e-4


class FakeCvode:
    """SciPy under the face of scikit-sundae's CVODE."""

    def __init__(self, fill: Any, **options: Any) -> None:
        self.fill, self.options = fill, options

    def solve(self, times: Any, start: Any) -> Any:
        def rhs(t: float, y: Any) -> Any:
            out = np.empty(len(y))
            self.fill(t, y, out)
            return out

        done = solve_ivp(rhs, (times[0], times[-1]), start, "LSODA", times, rtol=self.options["rtol"], atol=1e-12)
        return SimpleNamespace(success=True, y=done.y.T, t=done.t, njev=None, message="")


def test_sundials_runs_on_the_same_right_hand_side(monkeypatch: pytest.MonkeyPatch) -> None:
    module = SimpleNamespace(CVODE=FakeCvode)
    monkeypatch.setitem(sys.modules, "sksundae", cast(Any, SimpleNamespace(cvode=module)))
    monkeypatch.setitem(sys.modules, "sksundae.cvode", cast(Any, module))
    monkeypatch.setattr("nhc.study.chart.peers.find_spec", lambda name: name == "sksundae" or None)
    grid = replace(SMALL, methods=("dop853",), languages=("c",), tolerances=(1e-4, 1e-7), peers=True)
    made = chart(gallery("chaplygin_sleigh"), replace(grid, formulations=("euler-lagrange",)))
    found = [r for r in made.results if r.case.language == "sundials"]
    assert [r.case.method for r in found] == ["Adams", "Adams", "BDF", "BDF"] and all(r.calls > 10 for r in found)
    assert not any(r.failed for r in found) and found[1].error < 1e-5 < 1e-2
    assert {what for what, _ in made.left_out} >= {"scipy", "heyoka", "diffrax"}


def test_what_is_too_large_for_xla_is_shown_as_failed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("nhc.study.chart.diffrax_peer.MOST_OPERATIONS", 1)
    monkeypatch.setattr("nhc.study.chart.peers.find_spec", lambda name: name == "diffrax" or None)
    grid = replace(SMALL, methods=("dop853",), languages=("c",), tolerances=(1e-4,), peers=True)
    made = chart(gallery("chaplygin_sleigh"), replace(grid, formulations=("euler-lagrange",)))
    (found,) = [r for r in made.results if r.case.language == "diffrax"]
    assert "more than XLA compiles in good time" in found.failed


def test_work_is_that_of_the_run_that_is_timed() -> None:
    """Rows between the steps take more slopes of dop853; SciPy's steps are its own, and not the rows."""
    methods = ("dop853", "dopri5", "radau5")
    grid = replace(
        SMALL, methods=methods, tolerances=(1e-3, 1e-6), peers=True, languages=("c",), formulations=("lagrange",)
    )
    source = gallery("pendulum")
    study = chart(source, grid)
    for result in study.results:
        method = result.case.method
        if result.case.language == "c":
            job = open_scene(source, formulation="lagrange", method=method, whole=True)
            model, _ = load(job, method)
            task = Task(job.p, job.y, job.time, result.case.tolerance, result.case.step)
            alone = model.integrate(task, method, model.news())
            assert (result.calls, result.steps) == (alone.calls, alone.steps)
    scipy = {r.case.tolerance: r for r in study.results if (r.case.language, r.case.method) == ("scipy", "DOP853")}
    job = open_scene(source, formulation="lagrange", method="dop853", whole=True)
    for tolerance, result in scipy.items():
        assert result.calls >= 11 * result.steps  # twelve stages, the first of which is the last one's end
        assert result.steps != study.points - 1 and 5 <= result.steps <= 200, tolerance
