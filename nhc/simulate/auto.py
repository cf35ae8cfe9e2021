"""The method for a run before it begins: a rule read off work-precision studies (docs/chart.md), and one trial.

For comparisons and smaller models, which are all run by one method.  ``nhc run`` looks along its way instead
(:mod:`nhc.simulate.pacing`).

Stiff: radau5.  Else dopri5 where 1e-2 is enough, and dop853 for all that is finer.  Stiff means here that a trial run of
dopri5 at a coarse tolerance takes steps as long as its stability allows, and that what holds it there is a decaying mode
(a fast oscillation is part of the motion and has to be followed).
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job
from nhc.simulate.task import DONE, TOO_MANY, Task

COARSE = 1e-2
TRIAL_TOLERANCE, TRIAL_STEPS = 1e-3, 200
_HELD = 2.0  # dopri5 is stable for real h lambda from -3.3 to 0; steps about that long swing between 2 and 3.3
_TURNS = 80
_SAME = 0.2


def choose_method(job: Job, tolerance: float) -> tuple[str, str]:
    """(method, why) for a relative accuracy; the job's program has the Jacobian."""
    measured = _trial(job)
    if measured > _HELD:
        return "radau5", f"stiff: a mode decays {measured:.2g} times within one coarse step of dopri5"
    if tolerance >= COARSE:
        return "dopri5", f"not stiff, and 1e-2 is enough (accuracy {tolerance:g})"
    return "dop853", f"not stiff, accuracy {tolerance:g}"


def _trial(job: Job) -> float:
    """Mean step of dopri5 times the rate of the fastest mode where the trial ends, if that mode decays; else 0."""
    model = InterpretedModel(job.program, job.events, job.holds, job.watch.dips)
    task = Task(job.p, job.y, job.time, TRIAL_TOLERANCE, 0.0, TRIAL_STEPS)
    outcome = model.integrate(task, "dopri5", model.news())
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
