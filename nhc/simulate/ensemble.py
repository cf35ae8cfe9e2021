"""A run from many starts: one compiled model, one call."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace

from nhc.mechanics.starts.scenes import Start
from nhc.program.runs.limits import LEAST_TOLERANCE, SAFETY
from nhc.program.runs.starting import note_negative_starts
from nhc.records import record
from nhc.simulate.c.compile import CompileError, build, lane_flags, tell_passing
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import write_source
from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
from nhc.simulate.outcomes import is_for_frame
from nhc.simulate.pacing import AUTO, first_method
from nhc.simulate.prepare import Job, move_start, prepare
from nhc.simulate.run import Settings, Shop, Trajectory, collect, list_times, run, tell_finest
from nhc.simulate.task import HELD, STOPPED, News, Outcome, Task
from nhc.simulate.waiting import Show, wait_for
from nhc.simulate.workshop import Model, Workshop, load


@record
class Ensemble:
    """``members`` in the order of the starts, fewer where it was stopped; ``seconds`` for all of them."""

    job: Job
    starts: int
    members: tuple[Trajectory, ...]
    seconds: float
    notes: tuple[str, ...]

    @property
    def failed(self) -> tuple[tuple[int, Trajectory], ...]:
        """(row number from 1, what there is of it) of each start that did not come to its end."""
        return tuple((k, found) for k, found in enumerate(self.members, 1) if found.ended != "done")

    def advise(self) -> list[str]:
        """What lets those starts go on that fail because they are to stay in a formulation whose coframe becomes singular."""
        lost = [number for number, found in self.failed if is_for_frame(found.job, found.outcome)]
        if not lost or self.job.formulation.frame is None:
            return []
        which = "" if len(lost) == len(self.failed) else f" for start {lost[0]}" + (", ..." if len(lost) > 1 else "")
        return [
            f"take `-f multipliers`{which}: it has no coframe that becomes singular; "
            "or leave `--stay` out: a run of its own then changes its coframe on the way"
        ]


def run_ensemble(
    job: Job, starts: Sequence[Start], settings: Settings, show: Show | None = None, alone: Settings | None = None
) -> Ensemble:
    """Integrate a job with a whole state from each start; one of nhc's Runge-Kutta methods, with its own or given steps.

    Several starts run side by side, each with its own steps; a start that fails does not keep the others from running.  With
    ``alone`` those that only a run of their own goes on from are run again so: where dry friction holds something, or the
    coframe becomes singular.  Ctrl-C stops it and keeps the starts before the first that is not done.  ``show`` is told the part
    that is done.
    """
    tolerance = settings.tolerance or job.tolerance
    method = first_method(tolerance) if settings.method == AUTO else settings.method
    model, notes = load_lanes(job, method, settings.compiled)
    jobs = [move_start(job, start) for start in starts]
    times = list_times(*job.time, settings.points)
    task = Task(job.p, job.y, times, max(SAFETY * tolerance, LEAST_TOLERANCE), settings.step)
    news = model.news()
    news.t = times[0]
    before = time.perf_counter()
    told = None if show is None else lambda _: show(news.done / len(starts))
    outcomes = wait_for(lambda: _integrate_each(model, task, method, jobs, news), news, told)
    seconds = time.perf_counter() - before
    members = [
        collect(one, method, model, task, outcome, seconds, ()) for one, outcome in zip(jobs, outcomes, strict=False)
    ]
    if is_adaptive(method) and settings.step <= 0:
        notes += tell_finest(tolerance)
    if job.recipe is not None:
        notes += note_negative_starts(job.recipe.equations, job.formulation, starts)
    if alone is not None and len(members) == len(starts):
        notes += _go_on(job, starts, members, alone)
    return Ensemble(job, len(starts), tuple(members), time.perf_counter() - before, (*job.notes, *notes))


def _go_on(job: Job, starts: Sequence[Start], members: list[Trajectory], settings: Settings) -> tuple[str, ...]:
    """Put runs of their own in place of members that only such a run goes on from; where one is stopped, the rest is left out."""
    shop = Shop(Workshop(settings.compiled, None))

    def goes_on(found: Trajectory) -> bool:
        outcome = found.outcome
        return outcome.kind == HELD or is_for_frame(found.job, outcome) or shop.sticking.is_slow(found.job, outcome)

    wanted = [k for k, found in enumerate(members) if found.ended == "failed" and goes_on(found)]
    if not wanted or job.recipe is None:
        return ()
    single = prepare(replace(job.recipe, weak=True), job.formulation, job.start)
    for k in wanted:
        try:
            found = run(move_start(single, starts[k]), settings, shop=shop)
        except KeyboardInterrupt:  # between two of its steps
            found = None
        if found is None or found.ended == "stopped":
            del members[k:]
            break
        members[k] = found
    which = f"start {wanted[0] + 1}" if len(wanted) == 1 else f"{len(wanted)} starts, {wanted[0] + 1} the first,"
    has = "has a run of its own" if len(wanted) == 1 else "have runs of their own"
    return (f"{which} {has}: dry friction holds something there, or other velocities take over",)


def load_lanes(job: Job, method: str, compiled: bool = True) -> tuple[Model, tuple[str, ...]]:
    """The model of a run, with lanes where it is compiled and has them."""
    if not compiled:
        return load(job, method, compiled)
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds, dips=job.watch.dips, lanes=True)
    try:
        path = build(sources, f"{job.program.system}_run.c", lane_flags(len(job.y)))
    except CompileError:
        return load(job, method, compiled)  # whose note says why
    return CompiledModel(path, job.program.system, len(job.y), job.width), tell_passing(path)


def _integrate_each(model: Model, task: Task, method: str, jobs: Sequence[Job], news: News) -> list[Outcome]:
    if isinstance(model, CompiledModel) and not any(job.stops for job in jobs):
        return model.integrate_each(task, method, [job.y for job in jobs], [job.p for job in jobs], news)
    found: list[Outcome] = []
    for job in jobs:
        outcome = model.integrate(
            Task(job.p, job.y, task.times, task.tolerance, task.step, task.most, job.stops), method, news
        )
        if outcome.kind == STOPPED:
            break
        found.append(outcome)
        news.done = len(found)
    return found
