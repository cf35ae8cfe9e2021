"""The method for a run before it begins: a rule read off work-precision studies (docs/chart.md), and one trial.

For comparisons and smaller models, which are all run by one method.  ``nhc run`` looks along its way instead
(:mod:`nhc.simulate.pacing`).

Stiff: radau5.  Else dopri5 where 1e-2 is enough, and dop853 for all that is finer.  Stiff means here that a trial run of
dopri5 at a coarse tolerance takes steps as long as its stability allows, that what holds it there is a decaying mode
(a fast oscillation is part of the motion and has to be followed), that the trial does not come to the end of the scene,
and that radau5 goes on from there with steps that pay for what each of them costs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job
from nhc.simulate.stiffness import PAYS, TRIAL
from nhc.simulate.task import DONE, TOO_MANY, Outcome, Task

COARSE = 1e-2
TRIAL_TOLERANCE, TRIAL_STEPS = 1e-3, 200
_HELD = 2.0  # dopri5 is stable for real h lambda from -3.3 to 0; steps about that long swing between 2 and 3.3
_TURNS = 80
_SAME = 0.2


def choose_method(job: Job, tolerance: float) -> tuple[str, str]:
    """(method, why) for a relative accuracy; the job's program has the Jacobian."""
    model = InterpretedModel(job.program, job.events, job.holds, job.watch.dips)
    outcome = model.integrate(_task(job, TRIAL_TOLERANCE, TRIAL_STEPS), "dopri5", model.news())
    measured = _held(job, model, outcome)
    if measured > _HELD and outcome.kind == TOO_MANY and _pays(job, model, outcome, tolerance):
        return "radau5", f"stiff: a mode decays {measured:.2g} times within one coarse step of dopri5"
    if tolerance >= COARSE:
        return "dopri5", f"not stiff, and 1e-2 is enough (accuracy {tolerance:g})"
    return "dop853", f"not stiff, accuracy {tolerance:g}"


def _task(job: Job, tolerance: float, steps: int) -> Task:
    return Task(job.p, job.y, job.time, tolerance, 0.0, steps)


def _pays(job: Job, model: InterpretedModel, trial: Outcome, tolerance: float) -> bool:
    """Whether radau5, at the accuracy wanted, goes on from the end of a trial by steps as much longer as they are dearer."""
    length = abs(trial.t - job.time[0]) / trial.steps
    task = replace(_task(job, tolerance, TRIAL), y=trial.y, times=(trial.t, job.time[-1]), sizes=trial.sizes)
    found = model.integrate(task, "radau5", model.news())
    return found.steps > 0 and abs(found.t - trial.t) >= PAYS * length * found.steps


def _held(job: Job, model: InterpretedModel, outcome: Outcome) -> float:
    """Mean step of dopri5 times the rate of the fastest mode where its trial ends, if that mode decays; else 0."""
    if outcome.kind not in (DONE, TOO_MANY) or not outcome.steps:
        return 0.0
    try:
        matrix = model.jacobian(outcome.t, outcome.y, job.p)
    except ArithmeticError:
        return 0.0
    rate = decay_rate(matrix)
    return rate * abs(outcome.t - job.time[0]) / outcome.steps


def decay_rate(matrix: Sequence[Sequence[float]]) -> float:
    """-lambda of the eigenvalue of largest magnitude where it is real and negative; else 0.  Von Mises's iteration."""
    size = len(matrix)
    x = [math.cos(1.0 + 2.0 * k) for k in range(size)]
    for _ in range(_TURNS):
        norm = math.sqrt(sum(a * a for a in x))
        if not 0.0 < norm < math.inf:
            return 0.0
        x = [a / norm for a in x]
        image = [sum(a * b for a, b in zip(row, x, strict=True)) for row in matrix]
        value = sum(a * b for a, b in zip(image, x, strict=True))
        rest = math.sqrt(sum((a - value * b) ** 2 for a, b in zip(image, x, strict=True)))
        x = image
    return -value if value < 0.0 and rest <= _SAME * -value else 0.0
