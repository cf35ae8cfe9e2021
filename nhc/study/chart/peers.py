"""Other integrators on the same grid, with the same emitted right-hand side."""

from __future__ import annotations

import ctypes
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib.util import find_spec
from typing import Any

from nhc.study.chart.case import Case, Result
from nhc.study.chart.measure import time_repeats
from nhc.study.chart.model import doubles
from nhc.study.chart.single import Bench, judge
from nhc.study.chart.taylor import LANGUAGE, METHOD, run_taylor

LEAST_SCIPY = 3e-14  # SciPy raises smaller relative tolerances by itself
MOST_CALLS = 10_000


@dataclass(frozen=True, slots=True)
class Peer:
    """``language`` is its name in the chart, ``module`` what must be there; every ``stride``-th tolerance is run."""

    language: str
    method: str
    module: str
    stride: int = 1

    def there(self) -> bool:
        """Whether it is installed."""
        return find_spec(self.module) is not None


PEERS = (
    Peer("scipy", "DOP853", "scipy"),
    Peer("scipy", "LSODA", "scipy"),
    Peer(LANGUAGE, METHOD, "heyoka", 3),  # compiles for each tolerance
)


class TooManyCalls(Exception):
    """A peer's run is stopped."""


def run_peer(bench: Bench, peer: Peer, tolerance: float, budget: float) -> Result:
    """A peer's case; SciPy calls the compiled right-hand side through ctypes, as its users do."""
    if peer.language == LANGUAGE:
        return run_taylor(bench, tolerance, budget)
    case = Case(bench.name, peer.method, peer.language, tolerance)
    if tolerance < LEAST_SCIPY:
        return Result(case, failed=f"SciPy does not take a relative tolerance below {LEAST_SCIPY:g}")
    solve = _bind(bench, peer.method, tolerance)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = solve(True)
            if found.status != 0:
                return Result(case, calls=int(found.nfev), failed=" ".join(str(found.message).lower().split()))
            counts = Result(case, calls=int(found.nfev), jacobians=int(found.njev), steps=len(found.t) - 1)
            assert bench.compiled is not None
            rows = bench.compiled.quantities(bench.times, [list(map(float, y)) for y in found.y.T], bench.job.p)
            measured = judge(bench, counts, rows)
            if measured.failed:
                return measured

            def repeat(count: int) -> None:
                for _ in range(count):
                    solve(False)

            best, middle, repeats = time_repeats(repeat, budget)
    except (ArithmeticError, TooManyCalls) as error:
        return Result(case, failed=str(error) or "the right-hand side is singular")
    return replace(measured, best=best, median=middle, repeats=repeats)


def _bind(bench: Bench, method: str, tolerance: float) -> Callable[[bool], Any]:
    """A run of ``solve_ivp``, with the rows of the reference or with the last one alone."""
    import numpy as np
    from scipy.integrate import solve_ivp

    job = bench.job
    assert bench.compiled is not None
    function = getattr(bench.compiled.library, f"{job.program.system}_slope")
    function.argtypes = (ctypes.c_double, ctypes.c_void_p, ctypes.POINTER(ctypes.c_double), ctypes.c_void_p)
    p, start = doubles(job.p), np.array(job.y)
    state, slope = np.empty(len(start)), np.empty(len(start))
    into, out = state.ctypes.data, slope.ctypes.data
    # absolute: like nhc's own, relative to the size of the state, where a component is small
    floor = tolerance * 1e-6 * max(1e-3, float(np.max(np.abs(start), initial=0.0)))
    calls = 0

    def rhs(t: float, y: Any) -> Any:
        nonlocal calls
        calls += 1
        if calls > MOST_CALLS:
            raise TooManyCalls(f"stopped after {MOST_CALLS} right-hand sides")
        state[:] = y
        if function(t, into, p, out):
            raise ArithmeticError(f"singular at t = {t:.6g}")
        return slope.copy()

    def solve(rows: bool) -> Any:
        nonlocal calls
        calls = 0
        ends, wanted = (bench.times[0], bench.times[-1]), bench.times if rows else (bench.times[-1],)
        return solve_ivp(rhs, ends, start, method=method, rtol=tolerance, atol=floor, t_eval=wanted)

    return solve
