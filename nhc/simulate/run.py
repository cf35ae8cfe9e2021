"""A run: a job, a method, and what came out of it, complete or not."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from nhc.program.runs.limits import FINEST, LEAST_TOLERANCE, MANY_STEPS, MOST_STEPS, SAFETY
from nhc.records import record
from nhc.simulate.drifting import tell_conserved
from nhc.simulate.halving import REFERENCE, find_step
from nhc.simulate.methods import is_adaptive
from nhc.simulate.outcomes import describe_outcome, describe_valueless
from nhc.simulate.pacing import AUTO, first_method
from nhc.simulate.peers import PEERS
from nhc.simulate.prepare import Job
from nhc.simulate.ranges import tell_ranges
from nhc.simulate.stepping_over import tell_jumps
from nhc.simulate.sticking import Sticking
from nhc.simulate.switching import Follower, Leg
from nhc.simulate.task import DONE, EVENT, STOPPED, ModelError, Outcome, Task
from nhc.simulate.unstable import tell_unstable
from nhc.simulate.waiting import Show
from nhc.simulate.workshop import Model, Workshop

POINTS = 201
_SMOOTH = 8  # rows in the time of a step: methods of high order step over a good part of a period
_MOST = 2001  # rows of a picture, which has some 700 pixels for them
_SHORT_END = 1e-12  # of the run: a last step that is no longer
_ROWS_OF_JUMPS = 401
_ROUNDS, _BETWEEN = 4, 100  # to find a time to 8 digits of the way between two rows
_LONGEST = 1_000_000  # rows of a scene of which an event leaves a part


@record
class Settings:
    """``tolerance`` 0: the scene's; ``step`` 0: adaptive, or found by halving for a method with fixed steps; ``most``: attempts at
    steps after which the run fails with what it has.
    """

    method: str = AUTO
    tolerance: float = 0.0
    step: float = 0.0
    points: int = POINTS
    compiled: bool = True
    most: int = MOST_STEPS


@record
class Trajectory:
    """``rows`` follow the job's columns and ``checks`` its checks, ``drawn`` its sketch, one row for each of ``times``.

    ``ended`` is "done" or "event"; else "stopped" or "failed", and then the rows end before the end.
    """

    job: Job
    method: str
    compiled: bool
    times: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]
    checks: tuple[tuple[float, ...], ...]
    outcome: Outcome
    ended: str
    reason: str
    step: float
    seconds: float
    notes: tuple[str, ...]
    drawn: tuple[tuple[float, ...], ...] = ()

    @property
    def headings(self) -> tuple[str, ...]:
        return tuple(column.heading for column in self.job.columns)


def list_times(start: float, end: float, points: int) -> tuple[float, ...]:
    """Equally spaced times, the first and the last exactly the ends."""
    inner = (start + (end - start) * (k / (points - 1)) for k in range(1, points - 1))
    return (start, *inner, end)


def picture_points(found: Trajectory) -> int:
    """How many rows of the scene it takes to draw a motion as a curve: no more than there are where these will do.

    Between fixed steps rows are interpolated, and what a method conserves at its steps is not conserved there.  A motion that an
    event ends has few of the scene's rows, and gets as many of its own.
    """
    wanted, whole = min(_SMOOTH * found.outcome.steps + 1, _MOST), found.ended == "done"
    if found.ended == "event":
        wanted = max(wanted, POINTS)
    if not (whole or found.ended == "event") or found.step > 0 or wanted <= 2 * len(found.times):
        return len(found.times)
    start, end = found.job.time
    share = 1.0 if whole else (found.times[-1] - start) / (end - start)
    return min(math.ceil((wanted - 1) / share), _LONGEST) + 1 if share > 0 else len(found.times)


@dataclass
class Shop:
    """What runs of jobs that are moved from one another have in common."""

    workshop: Workshop
    sticking: Sticking = field(default_factory=lambda: Sticking(lambda line: None))


def run(job: Job, settings: Settings, show: Show | None = None, shop: Shop | None = None) -> Trajectory:
    """Integrate a job; ``show`` is told the time reached, some times a second.  Ctrl-C stops it and keeps what there is.

    Where the formulation becomes nearly singular another one takes over, and with the method ``auto`` an implicit method where
    an explicit one is held by its stability; notes say so.  ``shop``: that of runs of jobs from which this one was moved.
    """
    shop = shop or Shop(Workshop(settings.compiled, show))
    workshop = shop.workshop
    tolerance = settings.tolerance or job.tolerance
    method = first_method(tolerance) if settings.method == AUTO else settings.method
    workshop.model(job, method)  # so that compiling is not counted
    times = list_times(*job.time, settings.points)
    wanted = max(SAFETY * tolerance, LEAST_TOLERANCE)
    task = Task(job.p, job.y, times, wanted, settings.step, settings.most, job.stops)
    adaptive = is_adaptive(method) or method in PEERS

    def begin() -> Follower:
        return Follower(job, method, workshop.integrate, settings.method == AUTO, sticking=shop.sticking)

    follower = begin()
    before, notes = time.perf_counter() - workshop.seconds, job.notes
    if settings.step <= 0 and not adaptive:
        beside = Follower(job, REFERENCE, workshop.integrate, auto=True)
        task, more = find_step(
            lambda one: _go(workshop, follower, one), lambda one: _go(workshop, beside, one), task, tolerance
        )
        notes += (more,)
    if adaptive and settings.step <= 0:
        notes += tell_finest(tolerance)
    if method in PEERS:
        notes += _tell_passed(method, task)
    legs = follower.run(task)
    seconds = time.perf_counter() - before - workshop.seconds
    try:
        found = _gather(workshop, legs)
    except KeyboardInterrupt:  # what was integrated is kept, unless there is a second one
        workshop.stopped, found = True, _gather(workshop, legs)
    if workshop.stopped and found.ended in ("done", "event"):
        found = replace(found, ended="stopped")
    found = _without_friction(found, follower)
    if found.ended == "failed" and found.outcome.kind == DONE:
        found = _find_loss(found, lambda one: _go(workshop, begin(), one), task)
    notes += tell_ranges(legs, found.headings, found.times, found.rows)
    if task.step > 0 and job.jumping is not None:
        notes += _tell_jumps(_look_between(workshop, job, method, task, legs))
    if settings.step > 0:
        notes += (*_tell_passed(f"{method} of fixed length", task), *tell_unstable(legs))
    bounded = adaptive and settings.step <= 0 and method not in PEERS and not follower.notes
    if bounded and found.outcome.steps > MANY_STEPS:  # else stability or a singular place may have made them many
        notes += (
            f"{found.outcome.steps} steps, each held to {wanted:.2g}: in so many, errors may add up to more than the accuracy of"
            f" {tolerance:.3g}; see whether the end changes with a smaller `--tol`",
        )
    if adaptive and settings.step <= 0 and method not in PEERS and found.ended == "done":
        notes += _tell_short_end(found, task)
    notes += tell_conserved(job, found.rows, tolerance if settings.step <= 0 else 0.0, found.ended == "event")
    return replace(found, seconds=seconds, notes=(*dict.fromkeys((*workshop.notes, *notes, *follower.notes)),))


def _without_friction(found: Trajectory, follower: Follower) -> Trajectory:
    """A run to its end with the job of the spec, and not of what friction held first."""
    held = found.job.recipe is not None and found.job.recipe.held.frictions
    return replace(found, job=follower.job) if held and found.ended in ("done", "event") else found


def _look_between(workshop: Workshop, job: Job, method: str, task: Task, legs: list[Leg]) -> list[Leg]:
    """A run with more rows, where a sign may change and change back between two of them."""
    if len(task.times) >= _ROWS_OF_JUMPS:
        return legs
    between = replace(task, times=list_times(*job.time, _ROWS_OF_JUMPS))
    return Follower(job, method, workshop.integrate).run(between)


def _tell_jumps(legs: Sequence[Leg]) -> tuple[str, ...]:
    found = [
        tell_jumps(job.system, job.jumping, job.symbols, job.p, leg.task.times, leg.outcome.states)
        for leg in legs
        if (job := leg.job).jumping is not None
    ]
    return tuple(dict.fromkeys(note for notes in found for note in notes))


def _tell_passed(method: str, task: Task) -> tuple[str, ...]:
    """A note where functions of the time jump, bend or pulse, and the solver does not know of that."""
    if not task.stops:
        return ()
    first = ", ".join(f"{stop[0]:.6g}" for stop in task.stops[:3])
    more = f" and at {len(task.stops) - 3} more times" if len(task.stops) > 3 else ""
    return (
        f"functions of the time jump, bend or pulse at t = {first}{more}, where the steps of {method} do not end: it may pass over"
        " them; nhc's own adaptive methods end steps there",
    )


def _tell_short_end(found: Trajectory, task: Task) -> tuple[str, ...]:
    """A note where steps have become as short as they can be just where the run ends, though no stop cut the last one."""
    end, duration = task.times[-1], abs(task.times[-1] - task.times[0])
    cut = any(abs(end - after) < 1e-6 * duration for _, after in task.stops)
    if not 0.0 < abs(found.outcome.h) < _SHORT_END * duration or cut:
        return ()
    return (
        f"the last step is only {abs(found.outcome.h):.1g} long: the motion comes to a singular place at its end, and what stands"
        " there may have no correct digits",
    )


def tell_finest(tolerance: float) -> tuple[str, ...]:
    """A note where an accuracy is asked for that adaptive steps in doubles do not have."""
    finer = f"rounding is what limits steps at a tolerance of {FINEST:.0e}, and {tolerance:.3g} asks for the same ones"
    return (finer,) if tolerance < FINEST * (1.0 - 1e-9) else ()


def _find_loss(found: Trajectory, again: Callable[[Task], Trajectory], task: Task) -> Trajectory:
    """The same rows, and as their end where a needed quantity loses its value: between the last row and the one without it."""
    lost, good = found.outcome, found.times[-1] if found.times else task.times[0]
    for _ in range(_ROUNDS):
        if not good < lost.t:
            break
        between = [good + (lost.t - good) * k / _BETWEEN for k in range(1, _BETWEEN + 1)]
        closer = again(replace(task, times=(task.times[0], *between)))
        if closer.ended != "failed" or closer.outcome.kind != DONE or not closer.times:
            break
        lost, good = closer.outcome, max(good, closer.times[-1])
        found = replace(found, outcome=replace(found.outcome, t=lost.t, y=lost.y), reason=closer.reason)
    return found


def _go(workshop: Workshop, follower: Follower, task: Task) -> Trajectory:
    return _gather(workshop, follower.run(task))


def _gather(workshop: Workshop, legs: Sequence[Leg]) -> Trajectory:
    """The legs of a run as one trajectory."""
    parts = (collect(leg.job, leg.method, workshop.model(leg.job, leg.method), leg.task, leg.outcome) for leg in legs)
    return join([*parts])


def join(parts: Sequence[Trajectory]) -> Trajectory:
    """The parts of a run as one trajectory, which has the first part's job where it is complete, else the last one's.

    Each part after the first starts where the one before it ended, with a row that nobody asked for.
    """
    whole = parts[0]
    for part in parts[1:]:
        if len(whole.times) < len(whole.outcome.states):
            break  # a needed quantity has no value
        a, b = whole.outcome, part.outcome
        total = replace(
            b,
            steps=a.steps + b.steps,
            rejected=a.rejected + b.rejected,
            calls=a.calls + b.calls,
            jacobians=a.jacobians + b.jacobians,
            states=[*a.states, *b.states[1:]],
        )
        whole = replace(
            part,
            job=part.job if part.ended == "failed" else whole.job,
            method=whole.method if part.method in whole.method.split(", ") else f"{whole.method}, {part.method}",
            times=(*whole.times, *part.times[1:]),
            rows=(*whole.rows, *part.rows[1:]),
            checks=(*whole.checks, *part.checks[1:]),
            drawn=(*whole.drawn, *part.drawn[1:]),
            outcome=total,
        )
    return whole


def collect(
    job: Job,
    method: str,
    model: Model,
    task: Task,
    outcome: Outcome,
    seconds: float = 0.0,
    notes: tuple[str, ...] = (),
) -> Trajectory:
    """Rows of what is needed out of rows of states; a quantity without value ends the trajectory there."""
    times, states = list(task.times[: len(outcome.states)]), outcome.states
    if outcome.kind in (EVENT, STOPPED) and abs(outcome.t - times[0]) > abs(times[-1] - times[0]):
        times, states = [*times, outcome.t], [*states, outcome.y]
    ended, reason = describe_outcome(job, outcome)
    try:
        rows = model.quantities(times, states, job.p)
    except ModelError as error:
        bad = states[error.row]
        times, states = times[: error.row], states[: error.row]
        rows = model.quantities(times, states, job.p)
        where = task.times[error.row] if error.row < len(task.times) else outcome.t
        outcome = replace(outcome, t=where, y=list(bad), kind=DONE)  # the motion goes on there, whatever ends it later
        ended, reason = "failed", describe_valueless(job, outcome, error.status)
    width = len(job.columns)
    drawn = width + len(job.checks)
    return Trajectory(
        job,
        method,
        model.compiled,
        tuple(times),
        tuple(tuple(row[:width]) for row in rows),
        tuple(tuple(row[width:drawn]) for row in rows),
        outcome,
        ended,
        reason,
        task.step,
        seconds,
        notes,
        tuple(tuple(row[drawn:]) for row in rows),
    )


def energy_change(found: Trajectory) -> list[float]:
    """The energy's change since the start at each row, relative to the largest of |T + V| and T met (none: as it is)."""
    groups = [column.group for column in found.job.checks]
    energy = [row[groups.index("energy")] for row in found.checks]
    kinetic = [row[groups.index("kinetic")] for row in found.checks]
    size = max((abs(x) for x in (*energy, *kinetic) if math.isfinite(x)), default=0.0) or 1.0
    return [(x - energy[0]) / size for x in energy]
