"""The grid of a chart: what is prepared, run, compared and timed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

from nhc.diagnostics import Source, several
from nhc.language import decode
from nhc.language.spec import Scene
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.simulate.c.compile import CompileError, find_compiler
from nhc.simulate.changes import changed
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
from nhc.simulate.methods import STRUCTURE as SCHEMES
from nhc.simulate.prepare import Job
from nhc.simulate.requests import find_need, find_scene, scene_of_needs
from nhc.simulate.run import list_times
from nhc.simulate.task import Task
from nhc.study.chart.ahead import AHEAD, Show, compile_ahead
from nhc.study.chart.case import Case, Cost, Result, Study
from nhc.study.chart.case_runner import CaseRunner
from nhc.study.chart.grid import METHODS, POINTS, SCOUT, STRUCTURE, Grid, Runs, settle_runs
from nhc.study.chart.jobs import Prepared, Shrunk, prepare_jobs
from nhc.study.chart.measure import describe_machine, time_repeats
from nhc.study.chart.model import ChartModel, LongModel, compile_chart, compile_long
from nhc.study.chart.peers import PEERS, run_peer
from nhc.study.chart.reference import METHODS as REFERENCE_METHODS
from nhc.study.chart.reference import Solution, make_reference
from nhc.study.chart.single import MOST, Rig
from nhc.study.chart.structure import prepare_natural, run_schemes


def chart(source: Source, grid: Grid, show: Show | None = None) -> Study:
    """The whole study of one scene.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
        nhc.simulate.requests.RunError: no such scene or quantity.
        nhc.study.chart.reference.NoReference: there is nothing to compare with.
    """
    spec = decode(source)
    spec, scene = changed(spec, find_scene(spec, grid.scene), grid.changes)
    needs = tuple(dict.fromkeys(find_need(spec, need) for need in grid.needs))
    system = resolve(spec)
    made, compiled = prepare_jobs(system, scene, grid.formulations, needs, bool(grid.scene)), bool(find_compiler())
    runs = settle_runs(grid, compiled)
    notes = grid.changes.notes
    notes += () if compiled else ("there is no C compiler here: only the emitted Python is charted",)
    notes += made.full.notes
    first = next(iter(made.jobs.values()))
    times = list_times(*first.time, POINTS)
    methods = tuple(m for m in grid.methods if m in RUNGE_KUTTA) if grid.methods else METHODS
    natural = prepare_structure(system, scene, grid, needs)
    schemes = [method for method in grid.methods if method in SCHEMES] or STRUCTURE
    if compiled:
        scheme_job = natural if "c" in runs.languages else None
        compile_ahead(made.full, [*made.distinct.values()], list_compiled(methods), scheme_job, schemes, show)
    solution = make_reference(made.full, times, open_long(made.full) if compiled else None)
    results, costs, left, anchor = run_formulations(made, grid, runs, methods, times, solution, show)
    kept, missing = run_schemes(natural, schemes, runs, times, solution, anchor) if natural is not None else ([], [])
    if show is not None:
        show(1.0, "")
    return Study(
        system=system.name,
        about=spec.about,
        scene=scene.name,
        time=first.time,
        needs=tuple(column.heading for column in first.columns),
        tolerances=runs.tolerances,
        methods=grid.methods or (*METHODS, *dict.fromkeys(r.case.method for r in kept)),
        languages=runs.languages,
        points=POINTS,
        costs=price_all(made, costs),
        results=(*results, *kept),
        reference=solution.about,
        left_out=tuple(dict.fromkeys((*made.skipped, *made.repeated, *left, *missing))),
        notes=notes,
        machine=describe_machine(),
    )


def run_formulations(
    made: Prepared,
    grid: Grid,
    runs: Runs,
    methods: Sequence[str],
    times: Sequence[float],
    solution: Solution,
    show: Show | None,
) -> tuple[list[Result], list[Cost], list[tuple[str, str]], int]:
    """All cases of all formulations, what a right-hand side costs in each, what was left out, and steps of the first one."""
    first, compiled = next(iter(made.jobs.values())), bool(find_compiler())
    results: list[Result] = []
    anchor, costs, left = 8, list[Cost](), list[tuple[str, str]]()
    for done, (name, job) in enumerate(made.distinct.items()):
        if show is not None:
            show(AHEAD + (1.0 - AHEAD) * done / len(made.distinct), name)
        rig = open_rig(name, job, times, solution, methods, compiled)
        costs.append(cost_of(rig, runs.languages, made.shrunk.get(name)))
        cases = [run_rig(rig, methods, runs)]
        if job is first:
            anchor = count_steps(rig)
            if grid.peers and "c" in runs.languages:
                cases.append(run_peers(rig, runs))
        for found, missing in cases:
            results += found
            left += missing
    return results, costs, left, anchor


def prepare_structure(system: System, scene: Scene, grid: Grid, needs: Sequence[str]) -> Job | None:
    """The job of the structure-preserving methods; None where others are asked for, or other formulations."""
    named = [method for method in grid.methods if method in SCHEMES]
    if grid.methods and not named:
        return None
    job = prepare_natural(system, scene_of_needs(system.spec, scene, needs), needs)
    return None if not named and grid.formulations and job.formulation.name not in grid.formulations else job


def list_compiled(methods: Sequence[str]) -> tuple[str, ...]:
    """The methods of which a formulation is compiled: the one that counts steps, and those of the chart."""
    return tuple(dict.fromkeys((SCOUT, *methods)))


def open_long(job: Job) -> LongModel | None:
    """The model in long double; None where the compiler does not take it."""
    try:
        return LongModel(compile_long(job, REFERENCE_METHODS), job)
    except CompileError:
        return None


def open_rig(
    name: str, job: Job, times: Sequence[float], solution: Solution, methods: Sequence[str], compiled: bool
) -> Rig:
    """Both models of a formulation, ready to be run."""
    models = {method: ChartModel(compile_chart(job, method), job) for method in list_compiled(methods) if compiled}
    return Rig(name, job, tuple(times), solution, models, InterpretedModel(job.program, job.events, job.holds))


def cost_of(rig: Rig, languages: Sequence[str], shrunk: Shrunk | None) -> Cost:
    """What one right-hand side costs, at states along the reference motion; no number where all of them are singular."""
    job, in_c, in_python = rig.job, math.nan, math.nan
    function = next(f for f in job.program.functions if f.name == "rhs")
    task = Task(job.p, job.y, rig.times, 1e-6, 0.0, MOST, job.stops)
    compiled, interpreted = rig.compiled.get(SCOUT), rig.interpreted
    model = compiled or interpreted
    outcome = model.integrate(task, SCOUT, model.news())
    times, states = _regular_states(rig, outcome.states)
    if isinstance(compiled, ChartModel) and "c" in languages and times:
        best, _, _ = time_repeats(compiled.rhs_at(times, states, job.p), 0.02)
        in_c = best / len(times)
    if isinstance(interpreted, InterpretedModel) and "python" in languages and times:

        def repeat(count: int) -> None:
            for _ in range(count):
                for t, y in zip(times, states, strict=True):
                    interpreted.rhs(t, y, job.p)

        in_python = time_repeats(repeat, 0.02)[0] / len(times)
    calls = (
        f"{function.adds} +-, {function.multiplications} *, {function.divisions} /, {several(function.calls, 'call')}"
    )
    form = job.formulation
    left, full = (shrunk.left, shrunk.full_states) if shrunk is not None else ((), len(job.y))
    return Cost(rig.name, form.number, form.reason, len(job.y), calls, in_c, in_python, left, full)


def _regular_states(rig: Rig, states: Sequence[Sequence[float]]) -> tuple[list[float], list[Sequence[float]]]:
    """The times and states at which the right-hand side has a value: a formulation may be singular where the scene starts."""
    times, kept = list[float](), list[Sequence[float]]()
    for t, y in zip(rig.times, states, strict=False):
        with suppress(ArithmeticError):
            if isinstance(rig.interpreted, InterpretedModel):
                rig.interpreted.rhs(t, y, rig.job.p)
            times.append(t)
            kept.append(y)
    return times, kept


def price_all(made: Prepared, costs: Sequence[Cost]) -> tuple[Cost, ...]:
    """The costs of all formulations in their order; one whose code is that of another has its numbers."""
    known = {cost.formulation: cost for cost in costs}
    for name, twin in made.twins.items():
        form = made.jobs[name].formulation
        known[name] = replace(known[twin], formulation=name, number=form.number, reason=form.reason, twin=twin)
    return tuple(known[name] for name in made.jobs)


def run_rig(rig: Rig, methods: Sequence[str], runs: Runs) -> tuple[list[Result], list[tuple[str, str]]]:
    """All cases of a formulation; what was left out, with the reason."""
    runner, anchor = CaseRunner(rig, runs.explicit, runs.budget), count_steps(rig)
    found = [
        result
        for method in methods
        for language in runs.languages
        for rung, tolerance in enumerate(runs.tolerances)
        for result in runner.run(
            Case(rig.name, method, language, tolerance, step_of(rig, method, tolerance, anchor)), rung
        )
    ]
    return found, runner.left()


def run_peers(rig: Rig, runs: Runs) -> tuple[list[Result], list[tuple[str, str]]]:
    """The cases of other integrators that are installed; those that are not."""
    found: list[Result] = []
    for peer in PEERS:
        if peer.there():
            every = runs.explicit or peer.stride == 1
            rungs = [t for k, t in enumerate(runs.tolerances) if every or k % peer.stride == 1]
            found += run_peer(rig, peer, rungs, runs.budget)
    return found, [(peer.language, "not installed") for peer in PEERS if not peer.there()]


def count_steps(rig: Rig) -> int:
    """Steps of the first adaptive method at 1e-3: where the ladders of fixed steps begin."""
    job = rig.job
    model = rig.compiled.get(SCOUT, rig.interpreted)
    ends = (rig.times[0], rig.times[-1])
    outcome = model.integrate(Task(job.p, job.y, ends, 1e-3, 0.0, MOST, job.stops), SCOUT, model.news())
    return max(8, 2 * outcome.steps)


def step_of(rig: Rig, method: str, tolerance: float, anchor: int) -> float:
    """The fixed step that stands for a tolerance: it shrinks as the method's order wants; 0 for an adaptive method."""
    if is_adaptive(method):
        return 0.0
    finer: float = (1e-3 / tolerance) ** (1.0 / RUNGE_KUTTA[method].order)
    count = math.ceil(anchor * finer)
    return abs(rig.times[-1] - rig.times[0]) / max(count, 2)
