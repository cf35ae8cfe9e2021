"""The distance of a model from the full one, on a scene, by runs of emitted code."""

from __future__ import annotations

import math
from dataclasses import dataclass

from nhc.diagnostics import Source, SpecError
from nhc.language import Spec
from nhc.program.scene_model import count_operations_of
from nhc.simulate.opening import RunError, open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, Trajectory, run
from nhc.study.chart.measure import Rows, sizes_of
from nhc.study.simplify.ladder import Size

TIGHTER = 0.01
"""Of the wanted tolerance: the accuracy of every run; and of that, the accuracy of the reference."""
RESOLVED = 0.1
"""Of the wanted tolerance: the most that the reference may be wrong."""


class NotMeasured(Exception):
    """The full model's own run is not good enough to measure errors against it; ``help`` says what may be done."""

    def __init__(self, message: str, help: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.help = help


class Refused(Exception):
    """A smaller model cannot be had: it does not compile, or its run fails."""


@dataclass(frozen=True)
class Meter:
    """The reference, to hold models against; ``own`` are its own errors, ``sizes`` the quantities' largest magnitudes."""

    scene: str
    formulation: str
    tolerance: float
    job: Job
    compiled: bool
    needs: tuple[str, ...]
    rows: Rows
    sizes: tuple[float, ...]
    own: tuple[float, ...]
    size: Size
    notes: tuple[str, ...]

    def measure(self, text: str) -> tuple[tuple[float, ...], Size]:
        """The errors of the needed quantities and the size of the model that a spec's text describes.

        Raises:
            Refused: there is no such model, or its run does not come to the end.
        """
        try:
            job = open_scene(Source(f"{self.job.system.name}.yaml", text), self.scene, self.formulation)
        except SpecError as error:
            raise Refused(f"no model without it: {error.diagnostics[0].message}") from error
        except (RunError, ArithmeticError) as error:
            raise Refused(f"no model without it: {error}") from error
        found = run(job, self.settings)
        if found.headings != self.needs:
            raise Refused("the model without it delivers other quantities")
        if found.ended != "done":
            raise Refused(f"the run without it ends at t = {found.outcome.t:.6g}: {found.reason}")
        errors = errors_of(found.rows, self.rows, self.sizes)
        if not all(math.isfinite(error) for error in errors):
            raise Refused("the run without it gives no numbers")
        return errors, size_of(found)

    @property
    def settings(self) -> Settings:
        return Settings(tolerance=TIGHTER * self.tolerance)


def meter_of(source: Source, scene: str, formulation: str, tolerance: float) -> Meter:
    """Run the full model twice; the tighter run is the reference, their distance its own error.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
        nhc.simulate.opening.RunError: no such scene.
        NotMeasured: a run fails, or the two runs differ too much.
    """
    job = open_scene(source, scene, formulation)
    settings = Settings(tolerance=TIGHTER * tolerance)
    plain = _complete(run(job, settings))
    best = _complete(run(job, Settings(tolerance=TIGHTER * settings.tolerance)))
    sizes = tuple(sizes_of(best.rows, len(best.headings)))
    own = errors_of(plain.rows, best.rows, sizes)
    if not max(own) <= RESOLVED * tolerance:
        worst = best.headings[own.index(max(own))]
        raise NotMeasured(
            f"the full model's own runs differ by {max(own):.1e} in `{worst}`: too much to measure {tolerance:g}",
            ("take a shorter scene, a larger `--tol`, or leave a quantity that vanishes out of the scene's `need`",),
        )
    return Meter(
        *(job.scene.name, formulation, tolerance, job, plain.compiled, best.headings, best.rows, sizes, own),
        size_of(plain),
        plain.notes,
    )


def _complete(found: Trajectory) -> Trajectory:
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


def ranges_of(source: Source, spec: Spec, meter: Meter) -> tuple[tuple[str, float, float, str], ...]:
    """(name, least, largest, unit) of each coordinate and velocity of the full model on the output grid."""
    units = {c.name: c.unit for c in spec.coordinates}
    needs = tuple(name for c in spec.coordinates for name in (c.name, f"{c.name}'"))
    found = _complete(run(open_scene(source, meter.scene, meter.formulation, needs), meter.settings))
    columns = zip(found.headings, zip(*found.rows, strict=True), strict=True)
    return tuple((name, min(values), max(values), units.get(name, "")) for name, values in columns)
