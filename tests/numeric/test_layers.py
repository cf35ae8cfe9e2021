"""What no stage asks for is computed after the stages, and is what it was: against the model, with dense output and events."""

from __future__ import annotations

from fractions import Fraction

import pytest

from nhc.diagnostics import Source
from nhc.emit.statements import drop_unused, fill_stores, split_hoisted
from nhc.language import read
from nhc.program.ir import Guard, Let, Load, Number, Ref, Store
from nhc.simulate.c.compile import build, lane_flags, loop_flags
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.layers import Split, split_layers
from nhc.simulate.c.source import write_source
from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
from nhc.simulate.methods.tableau import Explicit
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, run
from nhc.simulate.task import DONE, Outcome, Task
from tests.support import spec_path

EXPLICIT = [name for name, method in RUNGE_KUTTA.items() if isinstance(method, Explicit)]

FOLLOWERS = """nhc: 1
system: followers
coordinates: [q, x, y, z]
parameters: {k: 1.3, m: 0.7}
constraints:
  - x' - m*exp(-sin(q)^2)*q' = 0
  - y' - (atan2(x, 3) + sqrt(1 + x^2)*cos(k*x))*q' = 0
  - z' - (sin(k*x)*cos(2*t) + abs(x) + m*exp(-sin(q)^2))*q' = 0
T: q'^2/2
V: -k*cos(q)
scenes:
  swing: {initial: {q: 0.3, q': 1}, time: [0, 3]}
"""

FREE = """nhc: 1
system: free_point
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: y
scenes:
  throw: {initial: {x': 1, y': 2}, time: [0, 3]}
"""


def open_job(name: str, until: str = "") -> Job:
    texts = {"followers": FOLLOWERS, "free_point": FREE}
    source = Source(f"{name}.yaml", texts[name]) if name in texts else read(str(spec_path(name)))
    return open_scene(source, until=until, whole=True)


def split_job(job: Job) -> Split:
    rhs = next(function for function in job.program.functions if function.name == "rhs")
    body = tuple(statement for statement in drop_unused(rhs.body) if not isinstance(statement, Store))
    return split_layers(split_hoisted(body + fill_stores(rhs))[1])


def load_model(job: Job, method: str, trig: str) -> CompiledModel:
    """``trig``: "inline" has the kernel, "libm" calls the model."""
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds, trig=trig, dips=job.watch.dips)
    path = build(sources, f"{job.program.system}_run.c", loop_flags(len(job.y)))
    return CompiledModel(path, job.program.system, len(job.y), job.width)


def assert_same(found: Outcome, expected: Outcome, tolerance: float) -> None:
    assert found.kind == expected.kind == DONE and found.steps == expected.steps
    for row, other in zip(found.states, expected.states, strict=True):
        assert row == pytest.approx(other, rel=tolerance, abs=tolerance)


def test_what_waits_for_what() -> None:
    """By name: a heading that only the position asks for waits too, and one that the velocities ask for does not."""
    layers = {}
    for name in ("chaplygin_sleigh", "rolling_disk", "pendulum", "followers", "free_point"):
        job = open_job(name)
        names = [quantity.name for quantity in job.program.state]
        layers[name] = [{names[entry] for entry in layer.entries} for layer in split_job(job).layers]
    assert layers == {
        "chaplygin_sleigh": [{"theta"}, {"x", "y"}],
        "rolling_disk": [{"phi"}, {"x", "y", "psi"}],
        "pendulum": [],
        "followers": [{"x"}, {"y", "z"}],
        "free_point": [{"x'", "y'"}, {"x", "y"}],
    }


def test_a_guard_is_asked_at_each_stage() -> None:
    """y1' = y0 y0, y0' = y2, y2' = 1: y0 would wait, but a guard reads it, and so do what it is made of."""
    zero, one = Number(Fraction(0)), Number(Fraction(1))
    body = (
        Load("a", "y", 0),
        Load("b", "y", 2),
        Let("c", Ref("a")),
        Store("dydt", 0, Ref("b")),
        Store("dydt", 1, Ref("c")),
        Store("dydt", 2, one),
    )
    assert [layer.entries for layer in split_layers(body).layers] == [(2,), (0,), (1,)]
    guarded = split_layers((*body[:3], Guard(Ref("c"), zero, 0.0, 1, "c"), *body[3:]))
    assert [layer.entries for layer in guarded.layers] == [(1,)] and guarded.kept == ("c",)


@pytest.mark.sample(3)
@pytest.mark.parametrize("method", EXPLICIT)
@pytest.mark.parametrize("name", ["chaplygin_sleigh", "rolling_disk", "snakeboard", "followers", "free_point"])
def test_the_kernel_is_the_model(name: str, method: str) -> None:
    """Rows within the steps too, for which the interpolant needs the slopes of all stages."""
    job = open_job(name)
    times = tuple(job.time[0] + 2.0 * k / 23 for k in range(24))
    adaptive = is_adaptive(method)
    task = Task(job.p, job.y, times, 1e-7, 0.0 if adaptive else 0.02)
    kernel, model = (load_model(job, method, trig) for trig in ("inline", "libm"))
    found, expected = (m.integrate(task, method, m.news()) for m in (kernel, model))
    assert_same(found, expected, 1e-11)
    fixed = Task(job.p, job.y, times, 1e-7, 0.03)
    assert_same(kernel.integrate(fixed, method, kernel.news()), model.integrate(fixed, method, model.news()), 1e-12)


@pytest.mark.parametrize("method", EXPLICIT)
def test_where_the_kernel_does_not_count(method: str) -> None:
    """A large angle of an entry that waits: each step is the model's, and some steps are, some are not."""
    job = open_job("chaplygin_sleigh")
    step = 0.0 if is_adaptive(method) else 0.02
    kernel, model = (load_model(job, method, trig) for trig in ("inline", "libm"))
    for angle in (2e5, 1e5 - 2.0):
        start = [job.y[0], job.y[1], angle, *job.y[3:]]
        task = Task(job.p, start, tuple(0.37 * k for k in range(12)), 1e-6, step)
        found, expected = (m.integrate(task, method, m.news()) for m in (kernel, model))
        assert_same(found, expected, 1e-9)
        assert found.states[-1][2] - angle > 2.0  # it passes 1e5


@pytest.mark.parametrize("method", EXPLICIT)
def test_an_event_of_what_waits(method: str) -> None:
    """C finds it where Python does."""
    job = open_job("followers", "z - 0.4")
    step = 0.0 if is_adaptive(method) else 0.02
    compiled, interpreted = (run(job, Settings(method, 1e-7, step, 9, c)) for c in (True, False))
    assert compiled.ended == interpreted.ended != "done" and 0 < compiled.outcome.t < 3
    assert compiled.outcome.t == pytest.approx(interpreted.outcome.t, abs=1e-9)
    assert compiled.outcome.y == pytest.approx(interpreted.outcome.y, abs=1e-9)
    assert compiled.outcome.y[3] == pytest.approx(0.4, abs=1e-9)


@pytest.mark.sample(3)
@pytest.mark.parametrize("method", EXPLICIT)
@pytest.mark.parametrize("name", ["followers", "free_point", "rolling_disk"])
def test_lanes_too(name: str, method: str) -> None:
    job = open_job(name)
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, dips=job.watch.dips, lanes=True)
    path = build(sources, f"{job.program.system}_run.c", lane_flags(len(job.y)))
    wide = CompiledModel(path, job.program.system, len(job.y), job.width)
    alone = load_model(job, method, "inline")
    times, step = (0.0, 0.5, 1.7), 0.0 if is_adaptive(method) else 0.02
    starts = [[x + 0.01 * k for x in job.y] for k in range(11)]
    task = Task(job.p, job.y, times, 1e-8, step)
    for start, found in zip(starts, wide.integrate_each(task, method, starts, [job.p] * 11, wide.news()), strict=True):
        assert_same(found, alone.integrate(Task(job.p, start, times, 1e-8, step), method, alone.news()), 1e-13)
