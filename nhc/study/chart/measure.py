"""Times of runs and distances from the reference."""

from __future__ import annotations

import math
import os
import platform
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from nhc.simulate.c.compile import FAST_FLAGS, CompileError, compiler_version, find_compiler, machine_flags
from nhc.study.chart.case import Machine
from nhc.version import __version__

BATCH = 5e-4  # seconds: what one reading of the clock measures at least
MOST_BATCHES = 20
MOST_COUNT = 1 << 24
LEAST_BATCHES = 3
LONG = 4.0  # budgets; a run that is longer is not worth a warm-up
Rows = Sequence[Sequence[float]]


def choose_clock() -> Callable[[], float]:
    """The processor's time, in seconds: beside other work a run waits for its turn, which says nothing of the run.

    Where that clock ticks too slowly for short runs, the time of the wall.
    """
    fine = time.get_clock_info("process_time").resolution <= 1e-2 * BATCH
    return time.process_time if fine else time.perf_counter


def time_repeats(repeat: Callable[[int], None], budget: float) -> tuple[float, float, int]:
    """(least, median, number) of the seconds of one run; ``repeat(n)`` runs it n times.  The first call is not counted.

    A run that takes longer than the budget is measured twice after that, one that is much longer once, without a warm-up.
    """
    clock = choose_clock()

    def take(count: int) -> float:
        before = clock()
        repeat(count)
        return clock() - before

    first = take(1)
    if first > LONG * budget:
        return first, first, 1
    once = take(1)
    if once > budget:
        twice = take(1)
        return min(once, twice), 0.5 * (once + twice), 2
    count = 1
    while (taken := take(count)) < BATCH and count < MOST_COUNT:
        count *= 2 if taken <= 0.0 else max(2, min(64, math.ceil(BATCH / taken)))
    found: list[float] = []
    end = clock() + budget
    while len(found) < LEAST_BATCHES or (len(found) < MOST_BATCHES and clock() < end):
        found.append(take(count) / count)
    return min(found), median(found), len(found)


def median(values: Sequence[float]) -> float:
    """The middle one."""
    ordered = sorted(values)
    half = len(ordered) // 2
    return ordered[half] if len(ordered) % 2 else 0.5 * (ordered[half - 1] + ordered[half])


def sizes_of(rows: Rows, width: int) -> list[float]:
    """The largest magnitude of each of the first ``width`` columns; 1 for a column of zeros."""
    return [max((abs(row[k]) for row in rows), default=0.0) or 1.0 for k in range(width)]


def final_error(rows: Rows, reference: Rows, sizes: Sequence[float]) -> float:
    """The largest error in the last row, relative to the sizes."""
    return max((abs(rows[-1][k] - reference[-1][k]) / size for k, size in enumerate(sizes)), default=math.nan)


def grid_error(rows: Rows, reference: Rows, sizes: Sequence[float]) -> float:
    """The root of the mean square over rows and columns of the errors relative to the sizes."""
    squares = [
        ((row[k] - other[k]) / size) ** 2
        for row, other in zip(rows, reference, strict=True)
        for k, size in enumerate(sizes)
    ]
    return math.sqrt(sum(squares) / len(squares)) if squares else math.nan


def energy_error(rows: Rows, reference: Rows, groups: Sequence[str]) -> float:
    """The largest distance from the reference's energy, relative to the largest of its |T + V| and T; ``groups`` of the columns."""
    if "energy" not in groups or not rows:
        return math.nan
    at, kinetic = groups.index("energy"), groups.index("kinetic")
    size = max(max(abs(row[at]), abs(row[kinetic])) for row in reference) or 1.0
    return max(abs(row[at] - other[at]) / size for row, other in zip(rows, reference, strict=True))


def describe_machine() -> Machine:
    """The processor, the compiler and the versions, without the machine's name."""
    compiler = find_compiler()
    try:
        line = compiler_version(compiler).split("\n", 1)[0].strip() if compiler else "no C compiler"
    except CompileError as error:
        line = str(error)
    flags = " ".join((*FAST_FLAGS, *machine_flags())) if compiler else ""
    return Machine(_processor(), os.cpu_count() or 1, line, flags, platform.python_version(), __version__)


def _processor() -> str:
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in text.splitlines() if line.startswith("model name")]
    return " ".join(names[0].split()) if names else platform.machine()
