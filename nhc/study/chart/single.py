"""One case of a chart: run once for its errors, then again and again for its time."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from nhc.records import record
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.natural import NaturalModel
from nhc.simulate.prepare import Job
from nhc.simulate.run import collect
from nhc.simulate.task import Task
from nhc.study.chart.case import RESOLVED, Case, Result
from nhc.study.chart.measure import Rows, energy_error, final_error, grid_error, time_repeats
from nhc.study.chart.model import RepeatedModel
from nhc.study.chart.reference import Solution

MOST = 100_000


@record
class Rig:
    """A formulation ready to be run beside the reference ``solution``; ``times`` are those of the reference's rows.

    ``compiled``: by method, none without a compiler; ``interpreted`` takes every method.
    """

    name: str
    job: Job
    times: tuple[float, ...]
    solution: Solution
    compiled: Mapping[str, RepeatedModel]
    interpreted: InterpretedModel | NaturalModel

    @property
    def right_side(self) -> RepeatedModel:
        """A compiled model, for what all methods' libraries have: the right-hand side and the needed quantities."""
        return next(iter(self.compiled.values()))


def run_case(rig: Rig, case: Case, budget: float) -> Result:
    """Errors and times of one case; a run that does not reach the end says why."""
    return follow_case(rig, case, budget)[0]


def follow_case(rig: Rig, case: Case, budget: float) -> tuple[Result, Rows]:
    """The same with the rows of columns and checks; none where the run failed."""
    model = rig.compiled[case.method] if case.language == "c" else rig.interpreted
    job = rig.job
    task = Task(job.p, job.y, rig.times, case.tolerance, case.step, MOST, job.stops)
    outcome = model.integrate(task, case.method, model.news())
    found = collect(job, case.method, model, task, outcome, 0.0, ())
    counts = Result(
        case, calls=outcome.calls, jacobians=outcome.jacobians, steps=outcome.steps, rejected=outcome.rejected
    )
    if found.ended != "done":
        return replace(counts, failed=f"{found.reason} (t = {outcome.t:.6g})"), ()
    rows = [(*row, *checks) for row, checks in zip(found.rows, found.checks, strict=True)]
    measured = judge(rig, counts, rows)
    if measured.failed:
        return measured, ()
    ends = replace(task, times=(rig.times[0], rig.times[-1]))
    timed = model.integrate(
        ends, case.method, model.news()
    )  # between its steps it needs no slopes: the work that is timed
    measured = replace(
        measured, calls=timed.calls, jacobians=timed.jacobians, steps=timed.steps, rejected=timed.rejected
    )

    def repeat(count: int) -> None:
        if case.language == "c":
            rig.compiled[case.method].repeat(ends, case.method, count)
            return
        for _ in range(count):
            rig.interpreted.integrate(ends, case.method, rig.interpreted.news())

    best, middle, repeats = time_repeats(repeat, budget)
    return replace(measured, best=best, median=middle, repeats=repeats), rows


def judge(rig: Rig, counts: Result, rows: Rows) -> Result:
    """The errors of rows of columns and checks against the reference."""
    solution, job = rig.solution, rig.job
    groups = [column.group for column in (*job.columns, *job.checks)]
    error = final_error(rows, solution.rows, solution.sizes)
    if not math.isfinite(error):
        return replace(counts, failed="a needed quantity is not finite")
    held = [k for k, group in enumerate(groups) if group in ("residual", "position")]
    return replace(
        counts,
        error=error,
        grid_error=grid_error(rows, solution.rows, solution.sizes),
        energy=energy_error(rows, solution.rows, groups),
        residual=max((abs(row[k]) for row in rows for k in held), default=math.nan),
        unresolved=not error >= RESOLVED * solution.about.error,
    )
