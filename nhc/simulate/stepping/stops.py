"""The times at which adaptive steps have to end (:mod:`nhc.program.runs.clock`), for a run that is under way."""

from __future__ import annotations

import math
from itertools import pairwise

from nhc.simulate.methods.step import Step
from nhc.simulate.task import Task


def next_bound(task: Task, t: float, stop: int) -> tuple[int, float]:
    """(number of the next of the task's stops from ``stop`` on, where steps have to end): that stop, or the run's end."""
    start, end = task.times[0], task.times[-1]
    sign = math.copysign(1.0, end - start)
    if task.step > 0:
        return stop, end
    while stop < len(task.stops) and sign * (task.stops[stop][0] - t) <= 0.0:
        stop += 1
    inside = stop < len(task.stops) and sign * (end - task.stops[stop][0]) > 0.0
    return stop, task.stops[stop][0] if inside else end


def cross(task: Task, t: float, stop: int, rows: int) -> tuple[float, int]:
    """(time after a stop at t, rows that lie between them, after the first ``rows``)."""
    end, after = task.times[-1], task.stops[stop][1]
    sign = math.copysign(1.0, end - t)
    between = [row for row in task.times[rows:] if sign * (row - t) > 0.0 and sign * (after - row) >= 0.0]
    return after if sign * (end - after) > 0.0 else end, len(between)


def foresee(step: Step, task: Task) -> None:
    """Sizes that what is short will give the state: a hundredth of its push on the state of the start.

    From rest there is no other size, and the rounding of a force that is nearly zero would count as motion.
    """
    if task.step > 0:
        return
    duration = abs(task.times[-1] - task.times[0])
    for (_, after), (before, _) in pairwise(task.stops):
        length = abs(before - after)
        if length >= 0.0625 * duration:
            continue
        try:
            slope = step.rhs(after, step.y)
        except ArithmeticError:
            continue
        pushes = (0.01 * length * abs(a - b) for a, b in zip(slope, step.slope, strict=True))
        step.size = [max(size, push) for size, push in zip(step.size, pushes, strict=True)]
