"""Other integrators on the same grid, with the same emitted right-hand side."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.util import find_spec
from typing import Any

from nhc.records import record
from nhc.study.chart import cvode, diffrax_peer
from nhc.study.chart.case import Case, Result
from nhc.study.chart.measure import time_repeats
from nhc.study.chart.single import Rig, judge
from nhc.study.chart.slope import Rows, Slope, TooManyCalls, absolute_tolerance
from nhc.study.chart.taylor import LANGUAGE, METHOD, run_taylor

LEAST_SCIPY = 3e-14  # SciPy raises smaller relative tolerances by itself


@record
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
    *(Peer(cvode.LANGUAGE, method, "sksundae") for method in cvode.METHODS),
    Peer(LANGUAGE, METHOD, "heyoka", 3),  # compiles for each tolerance
    Peer(diffrax_peer.LANGUAGE, diffrax_peer.METHOD, "diffrax", 3),
)


def run_peer(rig: Rig, peer: Peer, tolerances: Sequence[float], budget: float) -> list[Result]:
    """A peer's cases; SciPy and SUNDIALS call the compiled right-hand side through ctypes, as their users do."""
    if peer.language == LANGUAGE:
        return [run_taylor(rig, tolerance, budget) for tolerance in tolerances]
    if peer.language == diffrax_peer.LANGUAGE:
        return _run_diffrax(rig, tolerances, budget)
    bind = _bind_scipy if peer.language == "scipy" else cvode.bind
    return [_run(rig, Case(rig.name, peer.method, peer.language, t), bind, budget) for t in tolerances]


def _run(
    rig: Rig,
    case: Case,
    bind: Callable[[Rig, str, float], tuple[Callable[[Rows], Any], Slope]],
    budget: float,
) -> Result:
    if case.language == "scipy" and case.tolerance < LEAST_SCIPY:
        return Result(case, failed=f"SciPy does not take a relative tolerance below {LEAST_SCIPY:g}")
    solve, slope = bind(rig, case.method, case.tolerance)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found, steps = solve("grid"), len(solve("steps").t) - 1
            states = found.y.T if case.language == "scipy" else found.y
            solve("end")  # what is timed: between its steps it needs no slopes
            counts = Result(case, calls=slope.calls, jacobians=int(found.njev or 0), steps=steps)
            rows = rig.right_side.quantities(rig.times, [list(map(float, y)) for y in states], rig.job.p)
            measured = judge(rig, counts, rows)
            if measured.failed:
                return measured
            best, middle, repeats = time_repeats(lambda count: _repeat(solve, count), budget)
    except (ArithmeticError, TooManyCalls, cvode.NoCvode) as error:
        return Result(case, calls=slope.calls, failed=str(error) or "the right-hand side is singular")
    return replace(measured, best=best, median=middle, repeats=repeats)


def _repeat(solve: Callable[[Rows], Any], count: int) -> None:
    for _ in range(count):
        solve("end")


def _bind_scipy(rig: Rig, method: str, tolerance: float) -> tuple[Callable[[Rows], Any], Slope]:
    """A run of ``solve_ivp``, with the rows of the reference, the last one alone, or those of its own steps."""
    import numpy as np
    from scipy.integrate import solve_ivp

    slope, start = Slope(rig), np.array(rig.job.y)
    floor = absolute_tolerance(rig, tolerance)

    ends = rig.times[0], rig.times[-1]
    wanted = {"grid": rig.times, "end": ends[1:], "steps": None}

    def solve(rows: Rows) -> Any:
        slope.calls = 0
        found = solve_ivp(slope, ends, start, method=method, rtol=tolerance, atol=floor, t_eval=wanted[rows])
        if found.status != 0:
            raise ArithmeticError(" ".join(str(found.message).lower().split()))
        return found

    return solve, slope


def _run_diffrax(rig: Rig, tolerances: Sequence[float], budget: float) -> list[Result]:
    cases = [Case(rig.name, diffrax_peer.METHOD, diffrax_peer.LANGUAGE, tolerance) for tolerance in tolerances]
    try:
        run = diffrax_peer.bind(rig)
    except diffrax_peer.NoDiffrax as error:
        return [Result(case, failed=str(error)) for case in cases]
    return [_take_diffrax(rig, case, run, budget) for case in cases]


def _take_diffrax(
    rig: Rig, case: Case, run: Callable[[bool, float], tuple[list[list[float]], int]], budget: float
) -> Result:
    try:
        states, steps = run(True, case.tolerance)
        values = rig.interpreted.quantities(rig.times, states, rig.job.p)
    except (diffrax_peer.NoDiffrax, ArithmeticError) as error:
        return Result(case, failed=str(error) or "it is singular")
    measured = judge(rig, Result(case, steps=steps), values)
    if measured.failed:
        return measured
    run(False, case.tolerance)  # compiles

    def repeat(count: int) -> None:
        for _ in range(count):
            run(False, case.tolerance)

    best, middle, repeats = time_repeats(repeat, budget)
    return replace(measured, best=best, median=middle, repeats=repeats)
