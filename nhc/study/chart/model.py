"""The compiled model of a chart: runs repeated inside C, the right-hand side by itself, reference runs in long double."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from pathlib import Path

from nhc.emit.environment import File, render_file
from nhc.records import record
from nhc.simulate.c.compile import build, loop_flags
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import size, write_natural, write_source
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.prepare import Job
from nhc.simulate.task import Task
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

FUNCTIONS = (
    *("acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "ceil", "copysign", "cos", "cosh", "exp"),
    *("expm1", "fabs", "floor", "fmax", "fmin", "fmod", "hypot", "log", "log10", "log1p", "log2", "nextafter", "pow"),
    *("round", "sin", "sinh", "sqrt", "tan", "tanh", "trunc"),
)
_Number, _Whole = ctypes.c_double, ctypes.c_long


def doubles(values: Sequence[float]) -> ctypes.Array[ctypes.c_double]:
    """An array that C can read."""
    return (_Number * max(len(values), 1))(*values)


def compile_chart(job: Job, method: str) -> Path:
    """The library of a formulation with one method: with others in its file gcc would leave calls that it puts in place in a run.

    Raises:
        nhc.simulate.c.compile.CompileError: no compiler.
    """
    name = job.program.system
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds)
    context: dict[str, object] = {
        "head": f"{name}_chart.c: runs for a chart, emitted by nhc {__version__} ({PLACEHOLDER})",
        "name": name,
        "method": method,
    }
    unit = f"{name}_chart.c"
    files = sources | {unit: render_file(File(unit, "c/chart/repeat.c.jinja", context))}
    return build(files, unit, loop_flags(len(job.y)))


def compile_long(job: Job, methods: Sequence[str]) -> Path:
    """The library of the same in long double.

    Raises:
        nhc.simulate.c.compile.CompileError: no compiler.
    """
    name = job.program.system
    functions = {function.name: function for function in job.program.functions}
    sources = write_source(job.program, [RUNGE_KUTTA[method] for method in methods], job.events, job.holds, trig="")
    context: dict[str, object] = {
        "head": f"{name}_long.c: reference runs, emitted by nhc {__version__} ({PLACEHOLDER})",
        "name": name,
        "methods": tuple(methods),
        "functions": FUNCTIONS,
        "parameters": len(job.p),
        "needed": size(functions["needed"]),
    }
    unit = f"{name}_long.c"
    return build(sources | {unit: render_file(File(unit, "c/chart/long.c.jinja", context))}, unit)


def compile_natural(job: Job, method: str) -> Path:
    """The library of a structure-preserving method on a natural system.

    Raises:
        nhc.simulate.c.compile.CompileError: no compiler.
    """
    name = job.program.system
    context: dict[str, object] = {
        "head": f"{name}_chart.c: runs for a chart, emitted by nhc {__version__} ({PLACEHOLDER})",
        "name": name,
        "method": method,
    }
    unit = f"{name}_chart.c"
    text = render_file(File(unit, "c/chart/natural.c.jinja", context))
    return build(write_natural(job.program, STRUCTURE[method]) | {unit: text}, unit)


class RepeatedModel(CompiledModel):
    """A compiled model that repeats its runs in C."""

    def __init__(self, path: Path, job: Job) -> None:
        super().__init__(path, job.program.system, len(job.y), len(job.columns) + len(job.checks))

    def repeat(self, task: Task, method: str, count: int) -> None:
        """The same run ``count`` times, from the first time to the last."""
        function = getattr(self.library, f"{self.system}_repeat_{method}")
        ends = doubles((task.times[0], task.times[-1]))
        stops = (doubles([t for stop in task.stops for t in stop]), _Whole(len(task.stops)))
        numbers = (_Number(task.tolerance), _Number(task.step), _Whole(task.most), *stops)
        function(_Whole(count), doubles(task.p), doubles(task.y), ends, *numbers)


class ChartModel(RepeatedModel):
    """Repeated runs of a compiled model, and repeated calls of its right-hand side alone, for timing."""

    def rhs_at(
        self, times: Sequence[float], states: Sequence[Sequence[float]], p: Sequence[float]
    ) -> Callable[[int], None]:
        """What calls the right-hand side n times at each of the states; its arrays are made here, so that this is not timed."""
        function = getattr(self.library, f"{self.system}_repeat_rhs")
        function.restype = _Number
        flat, out = doubles([x for state in states for x in state]), doubles([0.0] * self.states)
        fixed = (_Whole(len(times)), doubles(times), flat, doubles(p), out)

        def repeat(n: int) -> None:
            function(_Whole(n), *fixed)

        return repeat


@record
class LongDoubleRun:
    """A run in long double: ``rows`` of needed columns, or none where the run failed."""

    rows: list[list[float]]
    steps: int


class LongModel:
    """A model in long double."""

    def __init__(self, path: Path, job: Job) -> None:
        self.library, self.job = ctypes.CDLL(str(path)), job

    @property
    def digits(self) -> int:
        """Binary digits of its numbers: 64 on x86, 53 where long double is double."""
        return int(getattr(self.library, f"{self.job.program.system}_digits")())

    def integrate(self, method: str, times: Sequence[float], tolerance: float, step: float, most: int) -> LongDoubleRun:
        """A run of one method; fixed steps where ``step`` is positive."""
        job, steps = self.job, ctypes.c_long(0)
        width = len(job.columns) + len(job.checks)
        out = (_Number * max(len(times) * width, 1))()
        function = getattr(self.library, f"{job.program.system}_long_{method}")
        numbers = (_Number(tolerance), _Number(step), _Whole(most), _Whole(len(times)))
        stops = (doubles([t for stop in job.stops for t in stop]), _Whole(len(job.stops)))
        failed = function(*numbers, doubles(times), doubles(job.y), doubles(job.p), *stops, out, ctypes.byref(steps))
        values = list(out[: len(times) * width])
        rows = [] if failed else [values[k : k + width] for k in range(0, len(values), width)]
        return LongDoubleRun(rows, steps.value)
