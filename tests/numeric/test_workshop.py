"""Two models of one job: compiled as it is written for the first steps, optimised for what takes more."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from nhc.language import read
from nhc.simulate import workshop
from nhc.simulate.c.compile import HASTY_FLAGS, CompileError
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, list_times, run
from nhc.simulate.task import DONE, STOPPED, TOO_MANY, News, Outcome, Task
from nhc.simulate.workshop import Workshop, load
from tests.support import spec_path

METHODS = ("dop853", "radau5", "leapfrog")


def job_of(method: str) -> Job:
    return open_scene(read(str(spec_path("contact_oscillator_eps"))), method=method)


def task_of(job: Job, method: str) -> Task:
    return Task(job.p, job.y, list_times(*job.time, 11), 1e-8, 0.01 if method == "leapfrog" else 0.0, 10**6, job.stops)


@pytest.fixture
def flags(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether each model that is compiled from now on is a hasty one."""
    told: list[bool] = []
    whole = workshop.build

    def build(sources: dict[str, str], unit: str, given: tuple[str, ...]) -> Path:
        told.append(given == HASTY_FLAGS)
        return whole(sources, unit, given)

    monkeypatch.setattr(workshop, "build", build)
    return told


@pytest.mark.parametrize("method", METHODS)
def test_few_steps_are_done_by_the_hasty_model(method: str, flags: list[bool]) -> None:
    job = job_of(method)
    made = Workshop(compiled=True, show=None)
    assert made.integrate(job, method, task_of(job, method)).kind == DONE
    assert flags == [True]


@pytest.mark.parametrize("method", METHODS)
def test_more_steps_are_done_from_the_start_by_the_optimised_model(
    method: str, flags: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the hasty one did is not counted, nor kept."""
    job = job_of(method)
    task = task_of(job, method)
    model, _ = load(job, method)
    expected = model.integrate(task, method, model.news())
    assert expected.steps > 20
    flags.clear()
    monkeypatch.setattr(workshop, "_find_haste", lambda job, method: 20)
    made = Workshop(compiled=True, show=None)
    assert made.integrate(job, method, task) == expected
    assert flags == [True, False]
    assert made.integrate(job, method, task) == expected
    assert flags == [True, False]


def test_large_states_leave_an_implicit_method_less_haste() -> None:
    """Its steps take a number of operations that grows with their cube."""
    job = job_of("radau5")
    large = replace(job, y=job.y * 20)
    small, much = (workshop._find_haste(job, method) for method in ("radau5", "dop853"))
    assert small < much
    assert 100 * workshop._find_haste(large, "radau5") < small
    assert workshop._find_haste(large, "dop853") == much


def test_haste_is_spent_over_the_legs_of_a_run(flags: list[bool], monkeypatch: pytest.MonkeyPatch) -> None:
    job = job_of("dop853")
    monkeypatch.setattr(workshop, "_find_haste", lambda job, method: 20)
    made = Workshop(compiled=True, show=None)
    short = replace(task_of(job, "dop853"), most=12)
    for expected in ([True], [True, False]):
        found = made.integrate(job, "dop853", short)
        assert (found.kind, found.steps + found.rejected) == (TOO_MANY, 12)
        assert flags == expected


def test_the_run_goes_on_where_nothing_can_be_optimised(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = workshop.build

    def build(sources: dict[str, str], unit: str, given: tuple[str, ...]) -> Path:
        if given != HASTY_FLAGS:
            raise CompileError("the compiler takes longer than 600 s")
        return whole(sources, unit, given)

    job = job_of("dop853")
    expected = run(job, Settings("dop853", 1e-8))
    monkeypatch.setattr(workshop, "build", build)
    monkeypatch.setattr(workshop, "_find_haste", lambda job, method: 20)
    found = run(job, Settings("dop853", 1e-8))
    assert (found.ended, found.rows) == ("done", expected.rows)
    assert found.notes[0] == "the compiler takes longer than 600 s; the run goes on without optimisation"


def test_both_models_agree(optimised_models: None) -> None:
    """As far as fused products and sums let them.  The last test here: the fixture stays for all of the module's that follow."""
    job = job_of("dop853")
    task = task_of(job, "dop853")
    models = [load(job, "dop853", hasty=hasty)[0] for hasty in (True, False)]
    assert all(isinstance(model, CompiledModel) for model in models)
    hasty, optimised = (model.integrate(task, "dop853", model.news()) for model in models)
    assert (hasty.steps, hasty.rejected) == (optimised.steps, optimised.rejected)
    for a, b in zip(hasty.states, optimised.states, strict=True):
        assert a == pytest.approx(b, rel=1e-11, abs=1e-11)


def test_an_interrupt_of_the_compiler_keeps_what_the_hasty_model_has_reached(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(self: Workshop, made: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(workshop, "_find_haste", lambda job, method: 20)
    monkeypatch.setattr(Workshop, "_optimise", interrupt)
    found = run(job_of("dop853"), Settings("dop853"), lambda t: None)
    assert (found.ended, found.outcome.kind) == ("stopped", STOPPED)
    assert found.times[0] < found.outcome.t < found.job.time[1]
    assert found.rows and len(found.rows) == len(found.times)


def test_an_interrupt_between_two_models_is_heard(monkeypatch: pytest.MonkeyPatch) -> None:
    """The hasty model has taken its last step, the optimised one not its first."""
    whole = CompiledModel.integrate
    seen = list[int]()

    def integrate(self: CompiledModel, task: Task, method: str, news: News) -> Outcome:
        found = whole(self, task, method, news)
        seen.append(found.kind)
        news.stop = True
        return found

    monkeypatch.setattr(workshop, "_find_haste", lambda job, method: 20)
    monkeypatch.setattr(CompiledModel, "integrate", integrate)
    found = run(job_of("dop853"), Settings("dop853"), lambda t: None)
    assert seen == [TOO_MANY] and found.ended == "stopped"
    assert found.times[0] < found.outcome.t < found.job.time[1]


def test_an_interrupt_after_the_last_step_keeps_all_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    whole, calls = CompiledModel.quantities, list[int]()

    def quantities(self: CompiledModel, *given: Any) -> Any:
        calls.append(len(calls))
        if len(calls) == 1:
            raise KeyboardInterrupt
        return whole(self, *given)

    monkeypatch.setattr(CompiledModel, "quantities", quantities)
    found = run(job_of("dop853"), Settings("dop853"), lambda t: None)
    assert found.ended == "stopped" and len(found.times) == 201 and found.outcome.t == found.job.time[1]
