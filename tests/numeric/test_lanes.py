"""Lanes: many starts side by side give what each gives by itself, and what is uncommon in one lane is that lane's own affair."""

from __future__ import annotations

import random
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.language import read
from nhc.simulate.c.compile import build, lane_flags, loop_flags
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import write_source
from nhc.simulate.ensemble import load_lanes
from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
from nhc.simulate.methods.tableau import Explicit
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.task import DONE, STOPPED, UNDERFLOW, Outcome, Task
from tests.support import COMPILER, STRICT, seldom, spec_path

EXPLICIT = [name for name, method in RUNGE_KUTTA.items() if isinstance(method, Explicit)]
STARTS = 19

RUNAWAY = """nhc: 1
system: runaway
coordinates: [x]
parameters: {k: 1}
T: x'^2/2
V: -k*x^4/4
scenes:
  away: {initial: {x: 1}, time: [0, 1.5]}
"""

ODD = """nhc: 1
system: odd_names
coordinates: [lanes, pack]
parameters: {far: 2, bad: 0.5, spread: 1.5}
T: far*lanes'^2/2 + (1 + exp(-pack^2))*pack'^2/2
V: bad*sqrt(1 + lanes^2) + spread*abs(pack)^3/3 + tan(bad*sin(lanes)) + max(lanes, pack)^2/2 + atan2(pack, 3)
scenes:
  swing: {initial: {lanes: 0.3, pack: 0.2, pack': 1}, time: [0, 3]}
"""


pytestmark = pytest.mark.usefixtures("optimised_models")


def open_job(name: str) -> Job:
    return open_scene(read(str(spec_path(name))), whole=True)


def load_alone(job: Job, method: str, trig: str = "inline") -> CompiledModel:
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds, trig=trig, dips=job.watch.dips)
    path = build(sources, f"{job.program.system}_run.c", loop_flags(len(job.y)))
    return CompiledModel(path, job.program.system, len(job.y), job.width)


def load_wide(job: Job, method: str) -> CompiledModel:
    model, _ = load_lanes(job, method)
    assert isinstance(model, CompiledModel)
    return model


def spread_starts(job: Job, by: float = 0.05) -> list[list[float]]:
    draw = random.Random(7)
    return [[x + by * draw.uniform(-1, 1) for x in job.y] for _ in range(STARTS)]


def integrate(model: CompiledModel, task: Task, method: str, starts: Sequence[Sequence[float]]) -> list[Outcome]:
    return model.integrate_each(task, method, starts, [task.p] * len(starts), model.news())


def assert_close(found: Outcome, single: Outcome, tolerance: float) -> None:
    """The same end by nearly the same steps: where an error is just what is allowed, rounding decides."""
    assert (found.kind, found.status, len(found.states)) == (single.kind, single.status, len(single.states))
    assert abs(found.steps - single.steps) <= 1 and found.calls == pytest.approx(single.calls, rel=0.1)
    for one, other in zip(found.states, single.states, strict=True):
        size = max(1.0, *map(abs, other))
        assert max(abs(a - b) for a, b in zip(one, other, strict=True)) <= tolerance * size


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("name", "method"),
    [
        *((name, "dop853") for name in ("rolling_disk", "pumped_pendulum")),
        *(seldom(name, "dop853") for name in ("roller_racer", "snakeboard")),
        *(("chaplygin_sleigh", method) for method in EXPLICIT),
        *(("pumped_pendulum", method) for method in EXPLICIT if method != "dop853"),
    ],
)
def test_lanes_are_single_runs(name: str, method: str) -> None:
    """Rows within steps, values that are watched, time in the equations, fixed steps."""
    job = open_job(name)
    starts = spread_starts(job, 0.01)
    end = job.time[0] + 2.0
    times = tuple(job.time[0] + (end - job.time[0]) * part for part in (0.0, 0.3, 0.31, 0.7, 1.0))
    task = Task(job.p, job.y, times, 1e-9, 0.0 if is_adaptive(method) else 0.01)
    wide, alone = load_wide(job, method), load_alone(job, method)
    together, single = (integrate(model, task, method, starts) for model in (wide, alone))
    assert len(together) == STARTS and len({tuple(found.y) for found in together}) == STARTS
    for one, other in zip(together, single, strict=True):
        assert one.kind == DONE
        assert_close(one, other, 1e-9)


def test_lanes_run_backwards() -> None:
    job = open_job("chaplygin_sleigh")
    task = Task(job.p, job.y, (1.0, 0.25, 0.0), 1e-10)
    wide, alone = load_wide(job, "dop853"), load_alone(job, "dop853")
    for one, other in zip(*(integrate(m, task, "dop853", spread_starts(job)) for m in (wide, alone)), strict=True):
        assert_close(one, other, 1e-10)


def test_one_lane_that_fails_spoils_no_other() -> None:
    job = open_scene(Source("runaway.yaml", RUNAWAY), whole=True)
    starts = [[3.0 if k % 4 == 2 else 1.0 + 0.01 * k, *job.y[1:]] for k in range(STARTS)]
    task = Task(job.p, job.y, job.time, 1e-10)
    wide, alone = load_wide(job, "dop853"), load_alone(job, "dop853")
    together, single = (integrate(model, task, "dop853", starts) for model in (wide, alone))
    for k, (one, other) in enumerate(zip(together, single, strict=True)):
        assert one.kind == (UNDERFLOW if k % 4 == 2 else DONE)
        assert_close(one, other, 1e-9)
        if k % 4 == 2:  # 1.854.../3: where the motion is infinite
            assert one.t == pytest.approx(1.8540746773 / 3, abs=1e-6) and len(one.states) == 1


def test_angles_too_large_for_the_kernel() -> None:
    """Lanes and single runs hand them to the model, whose sine knows them."""
    job = open_job("chaplygin_sleigh")
    turns = 2.0 * 3.141592653589793 * 50_000
    starts = [[*job.y[:2], job.y[2] + (turns if k % 3 == 0 else 0.0) + 0.1 * k, *job.y[3:]] for k in range(STARTS)]
    task = Task(job.p, job.y, (0.0, 2.0), 1e-9)
    plain = load_alone(job, "dop853", trig="")
    exact = integrate(plain, task, "dop853", starts)
    for model in (load_wide(job, "dop853"), load_alone(job, "dop853")):
        for one, other in zip(integrate(model, task, "dop853", starts), exact, strict=True):
            assert one.kind == other.kind == DONE
            assert max(abs(a - b) for a, b in zip(one.y[:2], other.y[:2], strict=True)) < 1e-9


@pytest.mark.slow
def test_kernel_and_model_take_the_same_steps() -> None:
    """With libm's sine there is no kernel."""
    for name in ("rolling_disk", "double_pendulum", "suslov"):
        job = replace(open_job(name), time=(0.0, 2.0))
        task = Task(job.p, job.y, job.time, 1e-8)
        by_kernel, by_model = (load_alone(job, "dop853", trig) for trig in ("inline", ""))
        one, other = (m.integrate(task, "dop853", m.news()) for m in (by_kernel, by_model))
        assert one.steps == other.steps and one.y == pytest.approx(other.y, rel=1e-9, abs=1e-9)


def test_names_and_functions_of_all_kinds(tmp_path: Path) -> None:
    """The kernel's own names are not the spec's; functions without a vector are called lane by lane; no warning."""
    job = open_scene(Source("odd_names.yaml", ODD), whole=True)
    wide, alone = load_wide(job, "dopri5"), load_alone(job, "dopri5")
    task = Task(job.p, job.y, job.time, 1e-6)  # steps that a kink's rounding does not decide
    for one, other in zip(*(integrate(m, task, "dopri5", spread_starts(job)) for m in (wide, alone)), strict=True):
        assert_close(one, other, 1e-9)
    sources = write_source(job.program, [RUNGE_KUTTA["dopri5"]], 0, dips=job.watch.dips, lanes=True)
    for file, text in sources.items():
        (tmp_path / file).write_text(text)
    for flags in ((), lane_flags(len(job.y))):
        command = [COMPILER, *STRICT, "-O1", *flags, "-c", "odd_names_run.c"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr


def test_who_asks_to_stop_gets_what_is_done() -> None:
    job = open_job("chaplygin_sleigh")
    model, news = load_wide(job, "dop853"), None
    news = model.news()
    news.stop = True
    task = Task(job.p, job.y, job.time, 1e-9)
    assert model.integrate_each(task, "dop853", spread_starts(job), [job.p] * STARTS, news) == []
    assert model.integrate(task, "dop853", news).kind == STOPPED


def test_a_runner_starts_anew_each_time() -> None:
    job = open_job("chaplygin_sleigh")
    model = load_alone(job, "dop853")
    task = Task(job.p, job.y, job.time, 1e-9)
    runner = model.runner(task, "dop853")
    for start in spread_starts(job)[:3]:
        runner.start[:] = [*start]
        assert runner.run() == DONE
        assert list(runner.end) == model.integrate(replace(task, y=start), "dop853", model.news()).y
