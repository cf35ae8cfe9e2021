"""The distance of a model from the full one, on a scene, by runs of emitted code; and what the model costs."""

from __future__ import annotations

import math
from dataclasses import replace

from nhc.diagnostics import Source, SpecError
from nhc.program.scene_model import count_operations_of
from nhc.records import record
from nhc.simulate.auto import choose_method
from nhc.simulate.changes import UNCHANGED, Changes
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.requests import RunError
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.task import TOO_MANY, Task
from nhc.study.chart.measure import Rows, sizes_of, time_repeats
from nhc.study.chart.model import ChartModel, compile_chart
from nhc.study.simplify.ladder import Price, Size
from nhc.study.simplify.on_the_way import Way, list_asked, way_of

TIGHTER = 0.01
"""Of the wanted tolerance: the accuracy of every run; and of that, the accuracy of the reference."""
RESOLVED = 0.1
"""Of the wanted tolerance: the most that the reference may be wrong."""
SECOND = {"dop853": "dopri5", "dopri5": "dop853"}
"""The method that measures again; radau5, whose rows are interpolated by cubics, measures again at a tighter tolerance."""
PATIENCE = 0.4  # seconds of an interpreted run, below which the C compiler would take longer
LONGER, FIRST = 4, 400
"""Times the full model's steps, and that many more: a smaller model whose interpreted run needs more, as where a force all but
jumps, goes on to the C compiler.
"""
PATIENT, _LEAST_MOST = 20, 50_000
"""Times the steps of the full model's longest run, and that many more: what a run of a smaller model may take."""
LARGE = 1500  # operations, beyond which the Jacobian takes too long for the sake of choosing a method
_FAR = 2.0  # times the tolerance: no noise of a run makes up for that
_BUDGET, _MOST = 0.02, 1_000_000


class NotMeasured(Exception):
    """The full model's own run is not good enough to measure errors against it; ``help`` says what may be done."""

    def __init__(self, message: str, help: tuple[str, ...]) -> None:
        super().__init__(message)
        self.help = help


class Refused(Exception):
    """A smaller model cannot be had: it does not compile, or its run fails."""


@record
class Meter:
    """The reference, to hold models against; ``own`` are its own errors, ``sizes`` the quantities' largest magnitudes.

    ``quick``: steps up to which trials run the emitted Python, since the motion is short; the emitted C, which takes over there,
    makes the same numbers to rounding.  0: it does all of them.  ``most``: steps after which a trial is given up.
    """

    scene: str
    formulation: str
    tolerance: float
    method: str
    second: Settings
    quick: int
    most: int
    job: Job
    compiled: bool
    needs: tuple[str, ...]
    rows: Rows
    sizes: tuple[float, ...]
    own: tuple[float, ...]
    size: Size
    notes: tuple[str, ...]
    way: Way

    def measure(self, text: str, again: bool = False) -> tuple[tuple[float, ...], Size]:
        """The errors of the needed quantities and the size of the model that a spec's text describes; ``again``: by the second way.

        Finding the scene's smallest state takes longer than a run: a model that is far off on its whole state keeps that one.

        Raises:
            Refused: there is no such model, or its run does not come to the end.
        """
        if not again:
            try:
                found = self._run(self.open(text, whole=True), again)
            except Refused:
                found = None  # perhaps for the sake of what the scene does not need
            if found is not None and max(found[0]) > _FAR * self.tolerance:
                return found
        job = self.open(text)
        errors, size = self._run(job, again)
        lost = self.way.find_lost(job) if not again and max(errors) <= self.tolerance else None
        if lost is not None:
            raise Refused(f"no model without it: the constraints lose their rank at t = {lost:.6g}")
        return errors, size

    def _run(self, job: Job, again: bool) -> tuple[tuple[float, ...], Size]:
        settings = replace(self.second if again else self.settings, most=self.most)
        try:
            found = None if again or not self.quick else run(job, replace(settings, compiled=False, most=self.quick))
            if found is None or found.outcome.kind == TOO_MANY:
                found = run(job, settings)
        except ArithmeticError as error:
            raise Refused(f"the run without it fails: {error}") from error
        if found.ended == "stopped":
            raise KeyboardInterrupt  # it was heard by the run
        if found.headings != self.needs:
            raise Refused("the model without it delivers other quantities")
        if found.outcome.kind == TOO_MANY:
            raise Refused(
                f"the run without it takes more than {self.most} steps, and is at t = {found.outcome.t:.6g} then"
            )
        if found.ended != "done":
            raise Refused(f"the run without it ends at t = {found.outcome.t:.6g}: {found.reason}")
        errors = errors_of(found.rows, self.rows, self.sizes)
        if not all(math.isfinite(error) for error in errors):
            raise Refused("the run without it gives no numbers")
        return errors, size_of(found)

    def open(self, text: str, whole: bool = False) -> Job:
        """The model of a spec's text; ``whole``: with all of its state, also where the scene does not need it.

        Raises:
            Refused: there is none.
        """
        try:
            source = Source(f"{self.job.system.name}.yaml", text)
            needs = tuple(need.name for need in self.job.scene.need) if whole else ()
            return open_scene(source, self.scene, self.formulation, needs=needs, method=self.method)
        except SpecError as error:
            raise Refused(f"no model without it: {error.diagnostics[0].message}") from error
        except (RunError, ArithmeticError) as error:
            raise Refused(f"no model without it: {error}") from error

    def price(self, text: str) -> Price:
        """What the model of a text costs in emitted C, or Python where there is no compiler."""
        job = self.open(text)
        task = Task(job.p, job.y, job.time, self.settings.tolerance * TIGHTER, 0.0, _MOST, job.stops)
        if not self.compiled:
            slow = InterpretedModel(job.program, job.events, job.holds)
            rhs = time_repeats(lambda n: _call(slow, job, n), _BUDGET)[0]
            return Price(rhs, time_repeats(lambda n: _repeat(slow, task, self.method, n), _BUDGET)[0])
        model = ChartModel(compile_chart(job, self.method), job)
        rhs = time_repeats(model.rhs_at((job.time[0],), (job.y,), job.p), _BUDGET)[0]
        return Price(rhs, time_repeats(lambda n: model.repeat(task, self.method, n), _BUDGET)[0])

    @property
    def settings(self) -> Settings:
        return Settings(self.method, tolerance=TIGHTER * self.tolerance)


def _call(model: InterpretedModel, job: Job, count: int) -> None:
    for _ in range(count):
        model.rhs(job.time[0], job.y, job.p)


def _repeat(model: InterpretedModel, task: Task, method: str, count: int) -> None:
    for _ in range(count):
        model.integrate(task, method, model.news())


def meter_of(source: Source, scene: str, formulation: str, tolerance: float, changes: Changes = UNCHANGED) -> Meter:
    """Run the full model three times; the tightest run is the reference, the distance of the others its own error.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
        nhc.simulate.requests.RunError: no such scene.
        NotMeasured: a run fails, or the runs differ too much.
    """
    job, method = _open(source, scene, formulation, tolerance, changes)
    settings = Settings(method, tolerance=TIGHTER * tolerance)
    finest = replace(settings, tolerance=TIGHTER * settings.tolerance)
    second = (
        Settings(SECOND[method], finest.tolerance)
        if method in SECOND
        else replace(finest, tolerance=1e-1 * finest.tolerance)
    )
    plain, best, other = (_complete(run(job, each)) for each in (settings, finest, second))
    sizes = tuple(sizes_of(best.rows, len(best.headings)))
    pairs = zip(errors_of(plain.rows, best.rows, sizes), errors_of(other.rows, best.rows, sizes), strict=True)
    own = tuple(max(pair) for pair in pairs)
    if not max(own) <= RESOLVED * tolerance:
        worst = best.headings[own.index(max(own))]
        raise NotMeasured(
            f"the full model's own runs differ by {max(own):.1e} in `{worst}`: too much to measure {tolerance:g}",
            ("take a shorter scene, a larger `--tol`, or leave a quantity that vanishes out of the scene's `need`",),
        )
    everything = open_scene(source, scene, formulation, changes=changes, needs=list_asked(job.system), method=method)
    whole = _complete(run(everything, settings))
    steps = plain.outcome.steps + plain.outcome.rejected
    quick = LONGER * steps + FIRST if plain.compiled and _is_quick(job, settings, steps) else 0
    most = PATIENT * max(each.outcome.steps + each.outcome.rejected for each in (plain, best, other)) + _LEAST_MOST
    return Meter(
        *(job.scene.name, formulation, tolerance, method, second, quick, most, job, plain.compiled),
        *(best.headings, best.rows, sizes, own, size_of(plain), plain.notes, way_of(whole)),
    )


def _is_quick(job: Job, settings: Settings, steps: int) -> bool:
    """Whether the interpreted run is short, by the time that its first steps take."""
    first = max(1, min(steps, FIRST))
    return run(job, replace(settings, compiled=False, most=first)).seconds * steps < PATIENCE * first


def _open(source: Source, scene: str, formulation: str, tolerance: float, changes: Changes) -> tuple[Job, str]:
    """The full model and the method that fits it."""
    job = open_scene(source, scene, formulation, changes=changes)
    rhs = next(function for function in job.program.functions if function.name == "rhs")
    if count_operations_of(rhs) > LARGE:
        return job, "dop853"
    implicit = open_scene(source, scene, formulation, changes=changes, method="radau5")
    method, _ = choose_method(implicit, TIGHTER * tolerance)
    return (implicit if method == "radau5" else job), method


def _complete(found: Trajectory) -> Trajectory:
    if found.ended == "stopped":
        raise KeyboardInterrupt
    if found.ended != "done":
        advice = ("`nhc run` says where the scene fails",)
        raise NotMeasured(f"the full model's run ends at t = {found.outcome.t:.6g}: {found.reason}", advice)
    return found


def errors_of(rows: Rows, reference: Rows, sizes: tuple[float, ...]) -> tuple[float, ...]:
    """The largest error of each column on the output grid, relative to the column's size."""
    pairs = list(zip(rows, reference, strict=True))
    return tuple(
        max((abs(a[k] - b[k]) if a[k] == a[k] else math.inf) for a, b in pairs) / size for k, size in enumerate(sizes)
    )


def size_of(found: Trajectory) -> Size:
    """What a run's model costs."""
    rhs = next(function for function in found.job.program.functions if function.name == "rhs")
    return Size(len(found.job.y), count_operations_of(rhs), found.outcome.calls)
