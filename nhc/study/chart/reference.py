"""The reference solution: in long double by one method, confirmed by another."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from nhc.records import record
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job
from nhc.simulate.task import DONE, ModelError, Task
from nhc.study.chart.case import Reference
from nhc.study.chart.measure import choose_clock, energy_error, sizes_of
from nhc.study.chart.model import LongModel

METHODS = ("dop853", "radau5", "gauss6")
LONG_TOLERANCE, TOLERANCE = 1e-17, 1e-14
MOST = 400_000
MOST_PYTHON = 20_000
ENOUGH, POOR = 1e-16, 1e-12
PATIENCE = 1.5  # seconds of one run
Solve = Callable[[str, float, float, int], list[list[float]]]  # method, tolerance, step, most steps -> rows or nothing


class NoReference(Exception):
    """No method comes to the end of the scene in this formulation."""

    def __init__(self, message: str, formulation: str) -> None:
        super().__init__(message)
        self.formulation = formulation


@record
class Solution:
    """``rows`` follow the job's columns, then its checks."""

    rows: list[list[float]]
    sizes: list[float]
    about: Reference


def make_reference(job: Job, times: Sequence[float], model: LongModel | None) -> Solution:
    """dop853 far below every tolerance of a chart (radau5 where it fails), compared with gauss6 by halved steps.

    Raises:
        NoReference: no method comes to the end.
    """
    if model is None:
        solve, arithmetic, tolerance, most = _in_python(job, times), "double, interpreted", TOLERANCE, MOST_PYTHON
    else:
        solve, most, digits = _in_long(model, times), MOST, model.digits
        long = digits > 53
        arithmetic = f"long double, {digits} binary digits" if long else "double (long double is no longer here)"
        tolerance = LONG_TOLERANCE if long else TOLERANCE
    for method, looser in (("dop853", 1.0), ("dop853", 1e3), ("radau5", 1e2), ("radau5", 1e4)):
        rows = solve(method, looser * tolerance, 0.0, most)
        if rows:
            return _confirm(job, solve, rows, (method, looser * tolerance), arithmetic, most)
    name = job.formulation.name
    raise NoReference(
        f"with the equations of {name} neither dop853 nor radau5 comes to the end of the scene at a tight tolerance",
        name,
    )


def _in_long(model: LongModel, times: Sequence[float]) -> Solve:
    def solve(method: str, tolerance: float, step: float, most: int) -> list[list[float]]:
        return model.integrate(method, times, tolerance, step, most).rows

    return solve


def _in_python(job: Job, times: Sequence[float]) -> Solve:
    model = InterpretedModel(job.program, job.events, job.holds)

    def solve(method: str, tolerance: float, step: float, most: int) -> list[list[float]]:
        outcome = model.integrate(Task(job.p, job.y, times, tolerance, step, most, job.stops), method, model.news())
        try:
            return model.quantities(times, outcome.states, job.p) if outcome.kind == DONE else []
        except ModelError:
            return []

    return solve


def _confirm(
    job: Job, solve: Solve, rows: list[list[float]], how: tuple[str, float], arithmetic: str, most: int
) -> Solution:
    """Halve the steps of gauss6, extrapolated, for as long as it comes nearer and does not take too long; where it fails radau5.

    Its rows between steps are interpolated, so only steps that meet every row are taken.
    """
    width = len(job.columns)
    sizes = sizes_of(rows, width)
    groups = [column.group for column in (*job.columns, *job.checks)]
    intervals, duration = len(rows) - 1, abs(job.time[1] - job.time[0])
    best, energy, confirmed = math.inf, math.nan, "nothing: no second method comes to the end"

    def distance_of(other: list[list[float]]) -> float:
        pairs = list(zip(rows, other, strict=True))
        return max((abs(a[k] - b[k]) / s for a, b in pairs for k, s in enumerate(sizes)), default=0.0)

    clock = choose_clock()
    steps, former = intervals, None
    while steps <= most // 4:
        before = clock()
        fine = solve("gauss6", 0.0, duration / steps, most)
        taken = clock() - before
        if fine and former:
            other = extrapolate(former, fine)
            distance = distance_of(other)
            if distance > best:
                break
            better, best, confirmed = distance < 0.5 * best, distance, f"gauss6 with {steps} steps, extrapolated"
            energy = energy_error(other, rows, groups)
            if not better or best < ENOUGH:
                break
        if taken > PATIENCE:
            break
        steps, former = 2 * steps, fine
    if best > POOR and how[0] != "radau5":
        other = solve("radau5", 1e2 * how[1], 0.0, most)
        if other and distance_of(other) < best:
            confirmed = f"radau5 at tolerance {1e2 * how[1]:.0e}"
            best, energy = distance_of(other), energy_error(other, rows, groups)
    method = f"{how[0]} at tolerance {how[1]:.0e}"
    return Solution(rows, sizes, Reference(method, confirmed, arithmetic, best, energy))


def extrapolate(coarse: list[list[float]], fine: list[list[float]]) -> list[list[float]]:
    """Without the leading error of gauss6: h^6, and the next is h^8, for the method is symmetric."""
    return [[b + (b - a) / 63.0 for a, b in zip(*pair, strict=True)] for pair in zip(coarse, fine, strict=True)]
