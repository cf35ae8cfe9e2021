"""From a spec to a program ready to print, in one process beside SymPy's KanesMethod and cse.

``python -m benchmarks.derivation [SYSTEM...]``.  SymPy starts from Python objects in memory (frames and points; its import is not
counted) and ends at the cse of the mass matrix and forcing, before any solve.  nhc ends at the Program of the right-hand side,
solved; it is timed from the decoded spec, which is what SymPy's objects are, and from the YAML text.
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
from nhc.language import Spec, decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.model import build_program

SYSTEMS = ("sleigh", "disk", "trailers5", "trailers10", "snake5", "pendulum5", "pendulum10", "bicycle")
SCALING = (5, 10, 20, 50, 100)


@dataclass(frozen=True)
class Derivation:
    """Seconds, ``nhc`` from the decoded spec and ``text`` from its text.

    ``capped`` where the peer was stopped at ``CAP`` (its time is then a lower bound).
    """

    system: str
    nhc: float
    text: float
    kane: float
    capped: bool

    @property
    def ratio(self) -> float:
        return self.kane / self.nhc


def measure(system: str, rounds: int = 5) -> Derivation:
    """Median of ``rounds`` of nhc and of up to as many of the peer (one where it takes seconds), interleaved."""
    ours, read, theirs = [], [], []
    text = source(system)
    spec = decode(text)
    derive_nhc(spec)
    kane, capped = time_kane(system)
    theirs.append(kane)
    for _ in range(rounds):
        ours.append(_time(lambda: derive_nhc(spec)))
        read.append(_time(lambda: derive_nhc(decode(text))))
        if sum(theirs) < 3 and not capped:
            theirs.append(time_kane(system)[0])
    return Derivation(system, statistics.median(ours), statistics.median(read), statistics.median(theirs), capped)


def derive_nhc(spec: Spec) -> None:
    """The stages behind ``nhc emit --only rhs`` after reading."""
    system = resolve(spec)
    formulation = formulate(system)
    build_program(system, formulation, equations_of(system, formulation), ("rhs",), scenes=False)


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
        spec = decode(source(f"{family}{count}"))
        found[count] = min(_time(partial(derive_nhc, spec)) for _ in range(rounds))
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
    print(f"{'system':12}{'nhc ms':>10}{'from text':>10}{'Kane+cse ms':>14}{'ratio':>8}")
    for system in systems or SYSTEMS:
        made = measure(system)
        mark = ">" if made.capped else " "
        ours = f"{made.nhc * 1e3:10.2f}{made.text * 1e3:10.2f}"
        print(f"{system:12}{ours}{mark}{made.kane * 1e3:13.1f}{mark}{made.ratio:7.0f}", flush=True)
    for family in () if systems else ("trailers", "snake"):
        times = measure_scaling(family)
        print(family, ", ".join(f"{n}: {s * 1e3:.1f} ms" for n, s in times.items()), f"exponent {slope(times):.2f}")


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
