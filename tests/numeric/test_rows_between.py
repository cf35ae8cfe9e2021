"""Rows and events within a step are as good as its ends, also where a mode has died away that decays too fast for the step."""

from __future__ import annotations

import pytest

from nhc.language import Source
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, run
from nhc.simulate.task import DONE, Task
from nhc.simulate.workshop import load

DAMPER = """nhc: 1
system: damper
coordinates: [x, y]
T: x'^2/2 + y'^2/2
V: x^2/2
forces: {y: "-400*y - 126*y'"}
scenes: {go: {initial: {x: 1, y: 0.1}, time: [0, 30], need: [x, y, y']}}
"""
"""y is damped with the rates 3.3 and 122.7; x swings, and lets steps be some two units of time long."""


def opened(method: str = "dop853") -> Job:
    return open_scene(Source("damper.yaml", DAMPER), method=method)


@pytest.mark.parametrize("compiled", [True, False], ids=["C", "Python"])
@pytest.mark.parametrize("method", ["auto", "dop853", "dopri5"])
def test_rows_of_a_step_that_stability_holds(method: str, compiled: bool) -> None:
    """They were right to 30 tolerances only; the ends of the steps are right to a hundredth."""
    found = run(opened(method), Settings(method, 1e-8, points=1001, compiled=compiled))
    fastest = max(abs(row[2]) for row in found.rows)
    late = [row[2] for t, row in zip(found.times, found.rows, strict=True) if t > 8]
    assert found.ended == "done"
    assert max(map(abs, late)) < 3e-8 * fastest


@pytest.mark.parametrize("compiled", [True, False], ids=["C", "Python"])
def test_rows_where_a_mode_has_died_away(compiled: bool) -> None:
    """As after a trial of an implicit method: nothing of y is left, its size is known, and steps become far too long for it.

    Rows were off by as much as the motion had ever had.
    """
    job = opened()
    start, sizes = [1.0, 1e-26, 0.0, 1e-26], [1.0, 0.1, 1.0, 0.3]
    times = [0.01 * k for k in range(1001)]
    model, _ = load(job, "dop853", compiled)
    outcome = model.integrate(Task(job.p, start, times, 1e-10, sizes=sizes), "dop853", model.news())
    assert outcome.kind == DONE
    assert max(abs(row[3]) for row in outcome.states) < 3e-8 * sizes[3]
    assert max(abs(row[1]) for row in outcome.states) < 3e-8 * sizes[1]


@pytest.mark.parametrize("compiled", [True, False], ids=["C", "Python"])
def test_smooth_steps_are_not_refused(compiled: bool) -> None:
    job = open_scene(Source("damper.yaml", DAMPER.replace("126*y'", "20*y'")), method="dop853")
    model, _ = load(job, "dop853", compiled)
    tasks = [Task(job.p, job.y, [30.0 * k / n for k in range(n + 1)], 1e-10) for n in (1, 1000)]
    few, many = (model.integrate(task, "dop853", model.news()) for task in tasks)
    assert (few.steps, few.rejected, few.y) == (many.steps, many.rejected, many.y)


TOY = """nhc: 1
system: toy
coordinates: [x, y, theta, delta]
parameters: {m: 0.8, I: 0.01, J: 0.0005, a: 0.06, b: 0.14, W: 0.7, k: 0.02, c: 0.002, F: 0.4}
define: {X: x + a*cos(theta), Y: y + a*sin(theta), ux: x' + W*y, uy: y' - W*x, xf: x + b*cos(theta), yf: y + b*sin(theta)}
T: m/2*(X'^2 + Y'^2) + I/2*theta'^2 + J/2*(theta' + delta')^2
forces: {u: F, delta: "-k*delta - c*delta'"}
constraints:
  - -sin(theta)*ux + cos(theta)*uy = 0
  - -sin(theta + delta)*(xf' + W*yf) + cos(theta + delta)*(yf' - W*xf) = 0
quasi_velocities: {u: cos(theta)*ux + sin(theta)*uy, w: delta'}
scenes: {go: {initial: {x: 0.3, theta: 0.4, delta: 0.2, u: 0.2}, time: [0, 3.5], need: [x, y, theta, delta, delta', theta']}}
"""
"""A car on a turntable, whose steering is damped the faster the faster it drives."""


@pytest.mark.parametrize("compiled", [True, False], ids=["C", "Python"])
def test_a_mode_that_decays_beside_other_motions(compiled: bool) -> None:
    """The steering's speed was off by up to 25 tolerances within steps: there it is more than the mode that decays."""
    job = open_scene(Source("toy.yaml", TOY), method="dop853")
    exact = run(open_scene(Source("toy.yaml", TOY), method="radau5"), Settings("radau5", 1e-11, points=701))
    size = [max(abs(row[k]) for row in exact.rows) for k in range(6)]
    for tolerance in (1e-6, 1e-7, 1e-8, 1e-9):
        found = run(job, Settings("dop853", tolerance, points=701, compiled=compiled))
        assert found.ended == exact.ended == "done"
        wrong = [
            abs(a - b) / s
            for mine, other in zip(found.rows, exact.rows, strict=True)
            for a, b, s in zip(mine, other, size, strict=True)
        ]
        assert max(wrong) < 3 * tolerance
