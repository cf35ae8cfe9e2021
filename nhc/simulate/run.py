"""A run: the best model that this machine can have, a method, and what came out of it, complete or not."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace

from nhc.simulate.compile import CompileError, build, loop_flags
from nhc.simulate.compiled import CompiledModel
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.methods import DEFAULT, RUNGE_KUTTA, STRUCTURE, is_adaptive
from nhc.simulate.natural import NaturalModel
from nhc.simulate.peers import PEERS, PeerModel
from nhc.simulate.prepare import Job
from nhc.simulate.source import write_natural, write_source
from nhc.simulate.task import (
    CROSSED,
    DONE,
    EVENT,
    NO_SOLUTION,
    SINGULAR,
    STOPPED,
    TOO_MANY,
    UNDERFLOW,
    ModelError,
    Outcome,
    Task,
)
from nhc.simulate.waiting import Show, wait_for

SAFETY = 0.01  # of the wanted accuracy, for errors add up and grow
LEAST_TOLERANCE = 3e-15
POINTS = 201
MOST_HALVINGS = 20
Model = CompiledModel | InterpretedModel | NaturalModel


@dataclass(frozen=True, slots=True)
class Settings:
    """``tolerance`` 0: the scene's; ``step`` 0: adaptive, or found by halving for a method with fixed steps."""

    method: str = DEFAULT
    tolerance: float = 0.0
    step: float = 0.0
    points: int = POINTS
    compiled: bool = True


@dataclass(frozen=True)
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


def load(job: Job, method: str, compiled: bool = True) -> tuple[Model, tuple[str, ...]]:
    """The compiled model, or the emitted Python where there is no compiler; notes say so."""
    notes: tuple[str, ...] = ()
    if method in PEERS:
        return PeerModel(job.program, job.events), ()
    if compiled:
        try:
            if method in STRUCTURE:
                sources = write_natural(job.program, STRUCTURE[method])
            else:
                sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds, dips=job.watch.dips)
            path = build(sources, f"{job.program.system}_run.c", loop_flags(len(job.y)))
            return CompiledModel(path, job.program.system, len(job.y), job.width), ()
        except CompileError as error:
            notes = (f"{error}; running the emitted Python, which is some hundred times slower",)
    if method in STRUCTURE:
        return NaturalModel(job.program), notes
    return InterpretedModel(job.program, job.events, job.holds, job.watch.dips), notes


def list_times(start: float, end: float, points: int) -> tuple[float, ...]:
    """Equally spaced times, the first and the last exactly the ends."""
    inner = (start + (end - start) * (k / (points - 1)) for k in range(1, points - 1))
    return (start, *inner, end)


def run(job: Job, settings: Settings, show: Show | None = None) -> Trajectory:
    """Integrate a job; ``show`` is told the time reached, some times a second.  Ctrl-C stops it and keeps what there is."""
    model, notes = load(job, settings.method, settings.compiled)
    notes = (*job.notes, *notes)
    tolerance = settings.tolerance or job.tolerance
    times = list_times(*job.time, settings.points)
    task = Task(job.p, job.y, times, max(SAFETY * tolerance, LEAST_TOLERANCE), settings.step)
    before = time.perf_counter()
    if settings.step <= 0 and not (is_adaptive(settings.method) or settings.method in PEERS):
        task, more = _find_step(model, task, settings.method, tolerance, show)
        notes += more
    outcome = _integrate(model, task, settings.method, show)
    seconds = time.perf_counter() - before
    return collect(job, settings.method, model, task, outcome, seconds, notes)


def _integrate(model: Model, task: Task, method: str, show: Show | None) -> Outcome:
    """In a thread of its own, so that Ctrl-C is heard here."""
    news = model.news()
    news.t = task.times[0]
    return wait_for(lambda: model.integrate(task, method, news), news, show)


def _find_step(
    model: Model, task: Task, method: str, tolerance: float, show: Show | None
) -> tuple[Task, tuple[str, ...]]:
    """Halve the step until the end no longer moves by more than the tolerance; the last step is the one taken."""
    duration = abs(task.times[-1] - task.times[0])
    ends = (task.times[0], task.times[-1])
    step, former = duration / 64, None
    for _ in range(MOST_HALVINGS):
        trial = replace(task, times=ends, step=step)
        outcome = _integrate(model, trial, method, show)
        if outcome.kind == STOPPED:
            break
        if outcome.kind == DONE:
            if former is not None and _is_close(former, outcome.y, task.y, tolerance):
                break
            former = outcome.y
        else:
            former = None
        step /= 2
    return replace(task, step=step), (f"steps of {step:.6g} reach the tolerance (found by halving)",)


def _is_close(a: list[float], b: list[float], start: tuple[float, ...] | object, tolerance: float) -> bool:
    size = max(1e-300, *(abs(x) for x in b))
    return all(abs(x - y) <= tolerance * max(abs(y), 1e-3 * size) for x, y in zip(a, b, strict=True))


def collect(
    job: Job, method: str, model: Model, task: Task, outcome: Outcome, seconds: float, notes: tuple[str, ...]
) -> Trajectory:
    """Rows of what is needed out of rows of states; a quantity without value ends the trajectory there."""
    times, states = list(task.times[: len(outcome.states)]), outcome.states
    if outcome.kind in (EVENT, STOPPED) and abs(outcome.t - times[0]) > abs(times[-1] - times[0]):
        times, states = [*times, outcome.t], [*states, outcome.y]
    ended, reason = _describe(job, outcome)
    try:
        rows = model.quantities(times, states, job.p)
    except ModelError as error:
        times, states = times[: error.row], states[: error.row]
        rows = model.quantities(times, states, job.p)
        where = task.times[error.row] if error.row < len(task.times) else outcome.t
        outcome = replace(outcome, t=where)
        ended, reason = (
            "failed",
            f"a needed quantity has no value: {job.meanings.get(error.status, 'it is not finite')}",
        )
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


def _describe(job: Job, outcome: Outcome) -> tuple[str, str]:
    """(how it ended, why)."""
    match outcome.kind:
        case 0:
            return "done", ""
        case 4:
            return "event", "the expression of `--until` crosses zero"
    if outcome.kind == STOPPED:
        return "stopped", "interrupted"
    meaning = job.meanings.get(outcome.status, "a result is not finite")
    reasons = {
        SINGULAR: meaning,
        UNDERFLOW: "the step size underflows: the motion approaches a singularity, or is not smooth there",
        TOO_MANY: "it takes too many steps",
        NO_SOLUTION: f"the equations of the implicit step are not solved (step {abs(outcome.h):.3g}); take a smaller one",
    }
    if outcome.kind == CROSSED:
        return "failed", _crossing(job, outcome.status)
    return "failed", reasons.get(outcome.kind, "it fails")


def _crossing(job: Job, index: int) -> str:
    """What it means that a watched value changed its sign."""
    watch = job.watch
    what, kind = watch.about[index], watch.kinds[index]
    beyond = "results beyond it would be wrong"
    if index < watch.dips:
        return f"{what}: the determinant changes its sign here, and {beyond}"
    if kind == "mass":
        return f"{what}: a pivot of it vanishes here, where the coordinates do not tell the motion, and {beyond}"
    if kind == "rank":
        return f"{what} here: their minors vanish together, and {beyond}"
    return f"{what}: the determinant vanishes here, and {beyond}"


def describe_state(job: Job, outcome: Outcome, longest: int = 12) -> str:
    """``x = 1, y = 2, ...`` at the place where a run ended."""
    pairs = list(zip(job.state_names, outcome.y, strict=True))
    shown = ", ".join(f"{name} = {value:.9g}" for name, value in pairs[:longest])
    return shown + (", ..." if len(pairs) > longest else "")


def rank_left(job: Job, outcome: Outcome) -> float | None:
    """The smallest singular value of the constraints where a run ended; None without constraints.

    Coordinates that the model does not carry stand at their start: the rank does not depend on them.
    """
    from nhc.mechanics.singular import smallest_singular_value

    if not job.system.constraints:
        return None
    place = job.start.values(job.system) | {job.system.t: outcome.t}
    carried = dict(zip(job.state_names, outcome.y, strict=True))
    place |= {q: carried[name] for q, name in zip(job.system.q, job.system.q_names, strict=True) if name in carried}
    try:
        return smallest_singular_value(job.system, place)
    except (ArithmeticError, ValueError):
        return None


def energy_change(found: Trajectory) -> list[float]:
    """The energy's change since the start at each row, relative to the largest of |T + V| and T met (none: as it is)."""
    groups = [column.group for column in found.job.checks]
    energy = [row[groups.index("energy")] for row in found.checks]
    kinetic = [row[groups.index("kinetic")] for row in found.checks]
    size = max((abs(x) for x in (*energy, *kinetic) if math.isfinite(x)), default=0.0) or 1.0
    return [(x - energy[0]) / size for x in energy]
