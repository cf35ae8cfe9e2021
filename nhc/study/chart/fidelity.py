"""Models of one scene held against the finest of them: the error of the model, and what a run of it costs."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import PurePath

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.language.spec import Scene, Spec
from nhc.mechanics.about import known_pairs
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.program.scene_model import SceneModel, count_operations_of, scene_model
from nhc.records import record
from nhc.simulate.auto import choose_method
from nhc.simulate.c.compile import find_compiler
from nhc.simulate.changes import Changes, changed
from nhc.simulate.methods import is_adaptive
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.reduced import job_of
from nhc.simulate.requests import find_need, find_scene, scene_of_needs
from nhc.simulate.run import list_times
from nhc.study.chart.case import RESOLVED, Case, Machine, Reference, Result
from nhc.study.chart.comparable import check_comparable
from nhc.study.chart.grid import Grid
from nhc.study.chart.measure import Rows, describe_machine
from nhc.study.chart.reference import Solution, make_reference
from nhc.study.chart.single import Rig, follow_case
from nhc.study.chart.study import cost_of, count_steps, open_long, open_rig, step_of

TOLERANCES = tuple(float(f"1e-{k}") for k in range(2, 11))
POINTS = 201
Show = Callable[[float, str], None]


@record
class Rung:
    """A model of the comparison; errors are those of its finest run, the largest on the grid relative to the quantity's size.

    ``own``: how much its own last two tolerances differ, so what of ``error`` is the integrator's; ``rhs``: seconds of one
    right-hand side; ``run``: seconds of its fastest run whose integrator errs by no more than the scene's tolerance; ``left``:
    what the scene's model leaves out of the ``full_states`` entries, with the reason; ``rows``: the needed quantities at the
    study's times.
    """

    name: str
    path: str
    system: str
    about: str
    formulation: str
    reason: str
    method: str
    why: str
    states: int
    full_states: int
    operations: int
    rhs: float
    run: float
    left: tuple[tuple[str, str], ...]
    errors: tuple[float, ...]
    own: float
    rows: tuple[tuple[float, ...], ...]

    @property
    def error(self) -> float:
        return max(self.errors, default=math.nan)


@record
class Comparison:
    """Models in the order in which they were named, the finest one last; each of the ``results`` has a model's name as its
    formulation, and as its error the largest on the grid against the finest model's reference.
    """

    scene: str
    finest: str
    time: tuple[float, float]
    tolerance: float
    needs: tuple[str, ...]
    units: tuple[str, ...]
    time_unit: str
    times: tuple[float, ...]
    sizes: tuple[float, ...]
    rungs: tuple[Rung, ...]
    results: tuple[Result, ...]
    reference: Reference
    notes: tuple[str, ...]
    machine: Machine


@record
class _Opened:
    """A spec with its scene and what is compared of it."""

    name: str
    source: Source
    spec: Spec
    scene: Scene
    made: SceneModel
    job: Job


def compare_models(sources: Sequence[Source], finest: Source, grid: Grid, show: Show | None = None) -> Comparison:
    """The error of each model against the finest one on the same scene, and the time of its runs.

    Raises:
        nhc.diagnostics.SpecError: a spec has errors, or lacks what the finest one's scene needs.
        nhc.simulate.requests.RunError: the finest spec has no such scene or quantity.
        nhc.study.chart.reference.NoReference: the finest model does not come to the end of the scene.
    """
    truth = decode(finest)
    truth, scene = changed(truth, find_scene(truth, grid.scene), grid.changes)
    needs = tuple(dict.fromkeys(find_need(truth, need) for need in grid.needs)) or tuple(n.name for n in scene.need)
    models = {source.path: source for source in (*sources, finest)}
    names = name_models(list(models))
    specs = {path: _changed(decode(source), scene.name, grid.changes) for path, source in models.items()}
    for path, spec in specs.items():
        check_comparable(spec, truth, scene, needs, names[path])
    opened = [_open(names[path], models[path], spec, scene.name, needs) for path, spec in specs.items()]
    best = next(one for one in opened if one.source.path == finest.path)
    opened = [*(one for one in opened if one is not best), best]
    times = list_times(*best.job.time, POINTS)
    compiled = bool(find_compiler())
    solution = make_reference(best.job, times, open_long(best.job) if compiled else None)
    tolerances = tuple(sorted(grid.tolerances or TOLERANCES, reverse=True))
    rungs: list[Rung] = []
    results: list[Result] = []
    for k, one in enumerate(opened):
        if show is not None:
            show(k / len(opened), one.name)
        rung, found = _run(one, times, solution, tolerances, grid, compiled)
        rungs.append(rung)
        results += found
    if show is not None:
        show(1.0, "")
    return Comparison(
        scene=scene.name,
        finest=best.name,
        time=best.job.time,
        tolerance=best.job.tolerance,
        needs=tuple(column.heading for column in best.job.columns),
        units=tuple(column.unit for column in best.job.columns),
        time_unit=truth.time_unit,
        times=times,
        sizes=tuple(solution.sizes),
        rungs=tuple(rungs),
        results=tuple(results),
        reference=solution.about,
        notes=(
            *grid.changes.notes,
            *(() if compiled else ("there is no C compiler here: the emitted Python is timed",)),
        ),
        machine=describe_machine(),
    )


def _changed(spec: Spec, scene: str, changes: Changes) -> Spec:
    """The spec with its scene of that name changed, if it has one, as far as it has the names."""
    own = next((one for one in spec.scenes if one.name == scene), None)
    if own is None:
        return spec
    return changed(spec, own, Changes(known_pairs(spec, changes.values), changes.time))[0]


def name_models(paths: Sequence[str]) -> dict[str, str]:
    """The file's stem for each path; with as much of the path as tells them apart where stems are the same."""
    parts = {path: PurePath(path).with_suffix("").parts for path in paths}
    for count in range(1, max((len(p) for p in parts.values()), default=1) + 1):
        names = {path: "/".join(p[-count:]) for path, p in parts.items()}
        if len(set(names.values())) == len(names):
            return names
    return {path: path for path in paths}


def _open(name: str, source: Source, spec: Spec, scene: str, needs: Sequence[str]) -> _Opened:
    system = resolve(spec)
    base = formulate(system)
    own = scene_of_needs(spec, find_scene(spec, scene), needs)
    made = scene_model(system, base, own, only_base=spec.formulation not in ("", "auto"))
    if made.chosen or made.reduction.left:
        job = job_of(made.planner, start_of(system, own), jacobian=True)
    else:
        job = prepare(Recipe(equations_of(system, base), tuple(needs), jacobian=True), base, start_of(system, own))
    return _Opened(name, source, spec, own, made, job)


def _run(
    one: _Opened, times: Sequence[float], solution: Solution, tolerances: Sequence[float], grid: Grid, compiled: bool
) -> tuple[Rung, list[Result]]:
    """A model at every tolerance: the rung, and what each run gave."""
    method, why = choose_method(one.job, tolerances[-1])
    chosen = grid.methods or (method,)
    rig = open_rig(one.name, one.job, times, solution, chosen, compiled)
    language = "c" if compiled else "python"
    lines = [_follow(rig, name, language, tolerances, grid.budget) for name in chosen]
    kept = [(result, rows) for result, rows in lines[0] if not result.failed]
    width = len(one.job.columns)
    finest = kept[-1][1] if kept else ()
    errors = errors_of(finest, solution.rows, solution.sizes) if kept else (math.nan,) * width
    own = max(errors_of(kept[-2][1], finest, solution.sizes)) if len(kept) > 1 else math.nan
    cost = cost_of(rig, (language,), None)
    rhs = next(function for function in one.job.program.functions if function.name == "rhs")
    return Rung(
        name=one.name,
        path=PurePath(one.source.path).name,
        system=one.spec.system,
        about=one.spec.about,
        formulation=one.job.formulation.name,
        reason=one.job.formulation.reason,
        method=chosen[0],
        why=why if chosen[0] == method else "named",
        states=len(one.job.y),
        full_states=len(one.made.full_state),
        operations=count_operations_of(rhs),
        rhs=cost.c if compiled else cost.python,
        run=_time_within(one.job.tolerance, kept, own, solution.sizes),
        left=tuple((omission.name, omission.reason) for omission in one.made.reduction.left),
        errors=errors,
        own=own,
        rows=tuple(tuple(row[:width]) for row in finest),
    ), [result for line in lines for result, _ in line]


def _follow(
    rig: Rig, method: str, language: str, tolerances: Sequence[float], budget: float
) -> list[tuple[Result, Rows]]:
    """A method's runs, from coarse to fine, each with its rows; fixed steps shrink as the method's order wants."""
    anchor = 0 if is_adaptive(method) else count_steps(rig)
    solution, found = rig.solution, []
    for tolerance in tolerances:
        case = Case(rig.name, method, language, tolerance, step_of(rig, method, tolerance, anchor))
        result, rows = follow_case(rig, case, budget)
        if not result.failed:
            error = max(errors_of(rows, solution.rows, solution.sizes))
            result = replace(result, error=error, unresolved=not error >= RESOLVED * solution.about.error)
        found.append((result, rows))
    return found


def _time_within(tolerance: float, kept: Sequence[tuple[Result, Rows]], own: float, sizes: Sequence[float]) -> float:
    """Seconds of the fastest run that is no farther than this from the model's finest one, which itself is ``own`` off."""
    coarse = [(max(errors_of(rows, kept[-1][1], sizes)), result.best) for result, rows in kept[:-1]]
    found = [*coarse, *((own, result.best) for result, _ in kept[-1:])]
    return min((best for error, best in found if error <= tolerance), default=math.nan)


def errors_of(rows: Rows, truth: Rows, sizes: Sequence[float]) -> tuple[float, ...]:
    """The largest error of each quantity over the rows, relative to its size."""
    return tuple(
        max((abs(a[k] - b[k]) for a, b in zip(rows, truth, strict=True)), default=math.nan) / size
        for k, size in enumerate(sizes)
    )
