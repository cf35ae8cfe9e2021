"""From a spec to a program ready to print, in one process beside SymPy's KanesMethod and cse.

``python -m benchmarks.derivation [SYSTEM...]``.  Both sides start from what a user writes (nhc from the YAML text, Kane
from frames and points; SymPy's import is not counted) and end at common-subexpression form: nhc's Program of the
right-hand side, SymPy's cse of the mass matrix and forcing, before any solve.
"""

from __future__ import annotations

import gc
import math
import statistics
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from benchmarks.capped import CAP, run_capped
from benchmarks.models import source
from nhc.diagnostics import Source
from nhc.pipeline import Options, program

SYSTEMS = ("sleigh", "disk", "trailers5", "trailers10", "snake5", "pendulum5", "pendulum10", "bicycle")
SCALING = (5, 10, 20, 50, 100)


@dataclass(frozen=True)
class Derivation:
    """Seconds; ``capped`` where the peer was stopped at ``CAP`` (its time is then a lower bound)."""

    system: str
    nhc: float
    kane: float
    capped: bool

    @property
    def ratio(self) -> float:
        return self.kane / self.nhc


def measure(system: str, rounds: int = 5) -> Derivation:
    """Median of ``rounds`` of nhc and of up to as many of the peer (one where it takes seconds), interleaved."""
    ours, theirs = [], []
    text = source(system)
    derive_nhc(text)
    kane, capped = time_kane(system)
    theirs.append(kane)
    for _ in range(rounds):
        ours.append(_time(lambda: derive_nhc(text)))
        if sum(theirs) < 3 and not capped:
            theirs.append(time_kane(system)[0])
    return Derivation(system, statistics.median(ours), statistics.median(theirs), capped)


def derive_nhc(text: Source) -> None:
    program(text, Options(only=("rhs",)))


def time_kane(system: str, cap: float = CAP) -> tuple[float, bool]:
    """Seconds of KanesMethod and cse, and whether they were stopped."""
    from sympy import cse
    from sympy.core.cache import clear_cache

    from benchmarks.peers.kane import derive

    def run() -> None:
        made = derive(system)
        cse([made.mass_matrix, made.forcing, made.rates])

    clear_cache()
    gc.collect()
    timed = run_capped(run, cap)
    return timed.seconds, timed.capped


def measure_scaling(family: str, sizes: tuple[int, ...] = SCALING, rounds: int = 3) -> dict[int, float]:
    """Seconds by number of links."""
    found = {}
    for count in sizes:
        text = source(f"{family}{count}")
        found[count] = min(_time(partial(derive_nhc, text)) for _ in range(rounds if count < 50 else 1))
    return found


def slope(times: dict[int, float]) -> float:
    """Exponent of the power law through all points (least squares in log-log)."""
    points = [(math.log(n), math.log(s)) for n, s in times.items()]
    mean_x, mean_y = (sum(column) / len(points) for column in zip(*points, strict=True))
    rise = sum((x - mean_x) * (y - mean_y) for x, y in points)
    return float(rise / sum((x - mean_x) ** 2 for x, _ in points))


def _time(run: Callable[[], None]) -> float:
    gc.collect()
    start = time.perf_counter()
    run()
    return time.perf_counter() - start


def main(systems: tuple[str, ...] = ()) -> None:
    print(f"{'system':12}{'nhc ms':>10}{'Kane+cse ms':>14}{'ratio':>8}")
    for system in systems or SYSTEMS:
        made = measure(system)
        mark = ">" if made.capped else " "
        print(f"{system:12}{made.nhc * 1e3:10.2f}{mark}{made.kane * 1e3:13.1f}{mark}{made.ratio:7.0f}", flush=True)
    for family in () if systems else ("trailers", "snake"):
        times = measure_scaling(family)
        print(family, ", ".join(f"{n}: {s * 1e3:.1f} ms" for n, s in times.items()), f"exponent {slope(times):.2f}")


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
