"""What a chart runs: a job for each formulation, with the whole state or with the scene's smallest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.language.spec import FORMULATIONS, Scene
from nhc.mechanics.choosing.choose import Formulation, formulate, of_name
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.reduction.reduce import Reduction
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.program.ir import Function, Let, Origin, Result, Section, Statement, Store, Sweep
from nhc.program.runs.starting import note_negative
from nhc.program.scene_model import reduce_one, scene_model
from nhc.records import record
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.reduced import job_of
from nhc.simulate.requests import scene_of_needs

SCENE = "scene"
"""The name of the model that `nhc emit --scene` writes, where its coframe is none of the spec's formulations."""
FULL = ", full"


@record
class Shrunk:
    """What a reduced job leaves out: (name, reason) of each entry of the full state, and that state's size."""

    left: tuple[tuple[str, str], ...]
    full_states: int


@record
class Prepared:
    """The jobs of a study by name, the one that nhc would choose first; what does not apply, with the reason.

    ``full`` is a job with the whole state, for the reference; ``shrunk`` says what the jobs of these names leave out;
    ``twins``: of jobs whose code is that of an earlier one, this one's name.
    """

    jobs: dict[str, Job]
    skipped: tuple[tuple[str, str], ...]
    full: Job
    shrunk: dict[str, Shrunk]
    twins: dict[str, str]

    @property
    def distinct(self) -> dict[str, Job]:
        """The jobs without those that have the code of another."""
        return {name: job for name, job in self.jobs.items() if name not in self.twins}

    @property
    def repeated(self) -> list[tuple[str, str]]:
        """(name, reason) of those that are not run for that."""
        return [(name, f"its code is that of {twin}, statement for statement") for name, twin in self.twins.items()]


def prepare_jobs(system: System, scene: Scene, wanted: Sequence[str], needs: Sequence[str], reduced: bool) -> Prepared:
    """A job for each formulation: those that are named, else all that apply.

    ``reduced``: on the state that the needs depend on, with the model that ``nhc emit --scene`` writes as the first and the full
    state of its formulation beside it (unless formulations are named).

    Raises:
        nhc.diagnostics.SpecError: nothing that was named applies, or the scene cannot start.
    """
    base = formulate(system)
    names = list(dict.fromkeys(base.name if name == "auto" else name for name in wanted or FORMULATIONS))
    needed = scene_of_needs(system.spec, scene, needs)
    start = start_of(system, needed)
    jobs: dict[str, Job] = {}
    shrunk: dict[str, Shrunk] = {}
    skipped: list[tuple[str, str]] = []
    full: Job | None = None
    if reduced and (not wanted or "auto" in wanted):
        own = scene_model(system, base, needed, only_base=base.name == system.spec.formulation)
        if own.chosen:
            jobs[SCENE] = job_of(own.planner, start, jacobian=True, energy=True)
            shrunk[SCENE] = _shrunk(own.reduction)
    for name in names:
        try:
            form = of_name(system, name)
        except NotApplicable as error:
            skipped.append((name, f"does not apply: {error.reasons[0]}"))
            continue
        equations = equations_of(system, form)
        planner = reduce_one(equations, form, start) if reduced and not equations.multipliers else None
        if planner is None or not planner.reduction.left:
            jobs[name] = _full_job(system, form, needed, needs)
            full = full or jobs[name]
            continue
        jobs[name] = job_of(planner, start, jacobian=True, energy=True)
        shrunk[name] = _shrunk(planner.reduction)
        if full is None or name == base.name:
            full = _full_job(system, form, needed, needs)
            if name == base.name and not wanted:
                jobs[name + FULL] = full
    if full is None:
        formulate(system, names[0])  # raises: it says why nothing that was named applies
        raise AssertionError("a formulation that does not apply was built")
    return Prepared(jobs, tuple(skipped), full, shrunk, _find_twins(jobs))


def _find_twins(jobs: dict[str, Job]) -> dict[str, str]:
    """The jobs that would run the same statements as an earlier one: timed apart they would differ by noise alone."""
    codes = {
        name: (job.y, job.p, job.stops, job.holds, [(f.name, _bare(f)) for f in job.program.functions])
        for name, job in jobs.items()
    }
    names = list(jobs)
    found: dict[str, str] = {}
    for k, name in enumerate(names):
        first = next((other for other in names[:k] if codes[other] == codes[name]), "")
        if first:
            found[name] = first
    return found


def _bare(function: Function) -> tuple[Statement, ...]:
    """A function's statements without the numbers of the equations that they come from."""

    def bare(statement: Statement) -> Statement:
        if isinstance(statement, Sweep):
            body = tuple(replace(one, origin=Origin()) for one in statement.body)
            return replace(statement, body=body)
        if isinstance(statement, (Section, Let, Store, Result)):
            return replace(statement, origin=Origin())
        return statement

    return tuple(bare(statement) for statement in function.body)


def _full_job(system: System, form: Formulation, scene: Scene, needs: Sequence[str]) -> Job:
    equations, start = equations_of(system, form), start_of(system, scene)
    job = prepare(Recipe(equations, tuple(needs), jacobian=True, checks=True), form, start)
    return replace(job, notes=note_negative(equations, form, start))


def _shrunk(made: Reduction) -> Shrunk:
    return Shrunk(tuple((omission.name, omission.reason) for omission in made.left), len(made.names))
