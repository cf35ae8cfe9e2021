"""Time to a relative error of 1e-9: nhc's compiled dop853, heyoka's Taylor method and SciPy on one right-hand side.

``python -m benchmarks.simulation [--write] [SYSTEM...]``.  Every solver integrates the same program in double precision.  A solver
runs on a ladder of tolerances; its time at the wanted error is interpolated geometrically between the two rungs around
it.  Compiling is not in the times.
"""

from __future__ import annotations

import ctypes
import math
import random
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from importlib.util import find_spec
from typing import Any

import numpy as np

from benchmarks.peers import taylor
from benchmarks.systems import ROOT
from benchmarks.systems import spec as write_spec
from benchmarks.table import PAGE, Row, describe_machine, print_section
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.simulate.c.compile import build
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.ensemble import load_lanes
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.task import DONE, Task
from nhc.simulate.workshop import load

SYSTEMS = ("sleigh", "disk", "trailers5", "snakeboard", "roller_racer")
_GALLERY = {"sleigh": "chaplygin_sleigh", "disk": "rolling_disk"}
WANTED = 1e-9
STARTS = 512
REPEATED = 8
"""Runs of one start within a timed call."""
_ROUNDS = 25
_LADDER = (1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)
_TAYLOR = (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14)
_SPREAD = 0.02
_WIDEST = 8
"""Lanes that heyoka is given beside the number that it recommends; its better time counts."""
SCIPY = ("DOP853", "LSODA", "odeint")
Solve = Callable[[Any], Any]

_SIMULATION = """\
## Simulation

Written by `make bench`, or alone by `python -m benchmarks.simulation --write`.  The time for one start to reach a relative
error of {wanted:g} at the end (the largest component of the error against the largest of the state).

- One start at a time, each by a call from Python that copies it in and out: nhc's compiled dop853 as `nhc run` compiles it,
  with its tests for singular places, against heyoka's Taylor method on the same program, and against the best of SciPy's
  {scipy} on nhc's compiled right-hand side through ctypes.
- {starts} starts: nhc's lanes in one call, against heyoka's batch mode with eight lanes or as many as it recommends, whichever
  is faster.  The error is that of the worst start.

Everything is compiled and warm beforehand.  The time is interpolated geometrically between runs at several tolerances, which
take turns; the quickest round of each counts, because other programs may use the machine.  heyoka's compiled expressions contain
the parameters as numbers, and no tests for singular places.
{missing}
Machine of this section: {machine}.
"""


@dataclass(frozen=True)
class Timed:
    """Seconds per start at the wanted error; None where the ladder does not reach it."""

    system: str
    nhc: float | None
    heyoka: float | None
    scipy: float | None
    best: str
    each: float | None
    batch: float | None
    lanes: int


def open_system(name: str) -> Job:
    """The job of a system's first scene on its whole state; trailers drive off bent."""
    if name.startswith("trailers"):
        text = write_spec(name).split("scenes:", 1)[0]
        bend = ", ".join(f"theta{i}: {0.05 * i:.2f}" for i in range(1, int(name[8:]) + 1))
        text += f"scenes:\n  drive: {{initial: {{phi: 0.2, {bend}, v: 1, w: 0.1}}, time: [0, 5]}}\n"
        return open_scene(Source(f"{name}.yaml", text), whole=True)
    path = ROOT / "specs" / f"{_GALLERY.get(name, name)}.yaml"
    job = open_scene(Source(path.name, path.read_text(encoding="utf-8")), whole=True)
    return replace(job, time=(job.time[0], min(job.time[1], job.time[0] + 5)))


def load_model(job: Job, lanes: bool = False) -> CompiledModel:
    """What ``nhc run`` loads, with alarms and all; ``lanes``: what it loads for an ensemble.

    Raises:
        ValueError: no compiler.
    """
    model, notes = load_lanes(job, "dop853") if lanes else load(job, "dop853")
    if not isinstance(model, CompiledModel):
        raise ValueError("; ".join(notes))
    return model


def solve_nhc(model: CompiledModel, job: Job, tolerance: float) -> Solve:
    """One start after the other, each by a call from Python, as heyoka's."""
    runner = model.runner(Task(job.p, job.y, job.time, tolerance), "dop853")
    begin, end = np.ctypeslib.as_array(runner.start), np.ctypeslib.as_array(runner.end)

    def solve(starts: Any) -> Any:
        ends = np.empty_like(starts)
        for i, start in enumerate(starts):
            begin[:] = start
            if runner.run() != DONE:
                raise ArithmeticError(f"{job.program.system} does not come to its end")
            ends[i] = end
        return ends

    return solve


def solve_many(model: CompiledModel, job: Job, tolerance: float) -> Solve:
    """All starts in one call."""
    task, news = Task(job.p, job.y, job.time, tolerance), model.news()
    values = np.tile(np.array(job.p or (0.0,)), STARTS)

    def solve(starts: Any) -> Any:
        given = values[: len(starts) * (len(values) // STARTS)]
        many = model.integrate_many(task, "dop853", starts.ravel(), given, news)
        if set(many.kinds) != {DONE}:
            raise ArithmeticError(f"{job.program.system} does not come to its end")
        return many.array()[:, -1]

    return solve


def solve_scipy(job: Job, method: str, tolerance: float) -> Solve:
    """SciPy on the compiled right-hand side through ctypes."""
    from scipy.integrate import odeint, solve_ivp

    system = job.program.system
    sources = render(job.program, "c", EmitOptions(only=("rhs",), trig="inline"))
    call = getattr(ctypes.CDLL(str(build(sources, f"{system}.c", ("-fvisibility=default",)))), f"{system}_rhs")
    call.argtypes = [ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]
    p = np.array(job.p or (0.0,))
    given = p.ctypes.data_as(ctypes.c_void_p)  # this keeps the array alive

    def rhs(t: float, y: Any) -> Any:
        slope = np.empty_like(y)
        if call(t, y.ctypes.data, given, slope.ctypes.data):
            slope[:] = math.nan  # left unwritten by a failed call
        return slope

    def solve(starts: Any) -> Any:
        ends = np.empty_like(starts)
        for i, y in enumerate(starts):
            absolute = tolerance * max(1e-3 * float(np.abs(y).max()), 1e-300)
            if method == "odeint":
                ends[i] = odeint(rhs, y, job.time, tfirst=True, rtol=tolerance, atol=absolute, mxstep=1_000_000)[-1]
            else:
                found = solve_ivp(rhs, job.time, y, method=method, rtol=tolerance, atol=absolute, t_eval=[job.time[1]])
                ends[i] = found.y[:, -1]
        return ends

    return solve


def measure(system: str) -> Timed:
    """Every solver on one start and on many, in one run; nhc and heyoka are timed in turn.

    Raises:
        ArithmeticError: the references of nhc and heyoka differ.
    """
    job = open_system(system)
    model, wide, exact = load_model(job), load_model(job, lanes=True), 1e-14
    one = np.array([job.y] * REPEATED)
    many = _spread(job)
    reference = solve_nhc(model, job, exact)(many)
    single = solve_nhc(model, job, exact)(one[:1])
    nhc: dict[float, Solve] = {tolerance: solve_nhc(model, job, tolerance) for tolerance in _LADDER}
    beside: dict[float, Solve] = {tolerance: solve_many(wide, job, tolerance) for tolerance in _LADDER}
    alone: dict[float, Solve] = {}
    batches: dict[int, dict[float, Solve]] = {}
    if taylor.is_installed():
        alone = {tolerance: taylor.Taylor(job, tolerance).run for tolerance in _TAYLOR}
        for width in sorted({taylor.Taylor.count_lanes(), _WIDEST}):
            batches[width] = {tolerance: taylor.Taylor(job, tolerance, width).run for tolerance in _TAYLOR}
        if find_error(alone[_TAYLOR[-1]](one[:1]), single) > 0.1 * WANTED:
            raise ArithmeticError(f"{system}: the references of nhc and heyoka differ")
    ours, peer = time_ladders((nhc, alone), one, single)
    each, *found = time_ladders((beside, *batches.values()), many, reference, 9)
    lane, lanes = min(
        ((seconds or math.inf, width) for seconds, width in zip(found, batches, strict=True)), default=(None, 0)
    )
    times = {}
    for method in SCIPY:
        ladder = {tolerance: solve_scipy(job, method, tolerance) for tolerance in _LADDER}
        times[method] = time_ladders((ladder,), one[:1], single, 7)[0] or math.inf
    best = min(times, key=lambda method: times[method])
    return Timed(system, ours, peer, times[best], best, each, lane, lanes)


def _spread(job: Job) -> Any:
    """Starts beside the job's; its state is one of independent velocities, so that each is consistent."""
    if job.holds:
        raise ValueError("a state with constraints cannot be moved freely")
    draw = random.Random(1977)
    return np.array([[x + _SPREAD * draw.uniform(-1, 1) for x in job.y] for _ in range(STARTS)])


def find_error(ends: Any, reference: Any) -> float:
    """The largest over the starts of max |y - y_ref| / max |y_ref|."""
    return float((np.abs(ends - reference).max(axis=1) / np.abs(reference).max(axis=1)).max())


def time_ladders(
    ladders: Sequence[dict[float, Solve]], starts: Any, reference: Any, rounds: int = _ROUNDS
) -> list[float | None]:
    """Seconds per start at the wanted error for each ladder, in turn, the quickest round of each rung; None for an empty one."""
    seconds: list[dict[float, list[float]]] = [{tolerance: [] for tolerance in ladder} for ladder in ladders]
    errors = [dict.fromkeys(ladder, 0.0) for ladder in ladders]
    for turn in range(rounds + 1):
        for ladder, found, error in zip(ladders, seconds, errors, strict=True):
            for tolerance, solve in ladder.items():
                before = time.perf_counter()
                ends = solve(starts)
                spent = (time.perf_counter() - before) / len(starts)
                off = find_error(ends, reference)
                error[tolerance] = max(error[tolerance], off if off >= 0 else math.inf)  # of every pass
                if turn:  # the first pass warms up
                    found[tolerance].append(spent)
    return [
        interpolate([(error[tolerance], min(found[tolerance])) for tolerance in found])
        for error, found in zip(errors, seconds, strict=True)
    ]


def interpolate(rungs: Sequence[tuple[float, float]], wanted: float = WANTED) -> float | None:
    """The time at the wanted error from (error, seconds) in falling tolerance; None where no rung is as exact.

    Where the first rung is exact enough already, its time.
    """
    for k, (error, seconds) in enumerate(rungs):
        if not error <= wanted:
            continue
        if k == 0 or error <= 0:
            return seconds
        coarse, less = rungs[k - 1]
        if not coarse < math.inf:
            return seconds
        part = math.log(coarse / wanted) / math.log(coarse / error)
        return float(less * (seconds / less) ** part)
    return None


def write_section(systems: tuple[str, ...]) -> list[str]:
    """Simulation against heyoka and SciPy."""
    missing = "" if find_spec("heyoka") else "\nheyoka was not installed for this run, and has no rows.\n"
    text = _SIMULATION.format(
        wanted=WANTED,
        scipy=", ".join(SCIPY),
        starts=STARTS,
        missing=missing,
        machine=describe_machine(),
    )
    return print_section(text, list_rows(systems))


def list_rows(systems: tuple[str, ...]) -> Iterator[Row]:
    for system in systems:
        made = measure(system)
        many = f"{system}, {STARTS} starts, heyoka in {made.lanes} lanes"
        for what, ours, peer, target in (
            (f"{system}, heyoka", made.nhc, made.heyoka, 0.75),
            (f"{system}, SciPy {made.best}", made.nhc, made.scipy, 0.02),
            (many, made.each, made.batch, 0.7),
        ):
            if peer is not None and ours is not None:
                yield Row(what, f"{ours * 1e6:.1f} us", f"{peer * 1e6:.1f} us", ours / peer, target)
            elif peer is not None:
                yield Row(what, "not reached", f"{peer * 1e6:.1f} us", float("inf"), target)


def main(arguments: tuple[str, ...] = ()) -> None:
    """Print the section, or put it into its page."""
    systems = tuple(name for name in arguments if name != "--write")
    section = "\n".join(write_section(systems or SYSTEMS))
    if "--write" not in arguments:
        print(section)
        return
    before, found, after = PAGE.read_text(encoding="utf-8").partition("## Simulation\n")
    if not found or systems:
        raise SystemExit("--write takes all systems, and a page that has the section")
    _, heading, rest = after.partition("\n## ")
    PAGE.write_text(f"{before}{section.rstrip()}\n{heading}{rest}", encoding="utf-8")


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
