"""SUNDIALS's CVODE as a peer: the compiled right-hand side under scikit-sundae's multistep methods."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nhc.study.chart.single import Rig
from nhc.study.chart.slope import Rows, Slope, absolute_tolerance

LANGUAGE = "sundials"
METHODS = ("Adams", "BDF")
MOST_STEPS = 100_000


class NoCvode(Exception):
    """Its run fails."""


def bind(rig: Rig, method: str, tolerance: float) -> tuple[Callable[[Rows], Any], Slope]:
    """A run of CVODE with the rows of the reference, the last one alone or its own steps; the counter of its right-hand sides."""
    from sksundae.cvode import CVODE

    slope = Slope(rig)
    options = {"method": method, "rtol": tolerance, "atol": absolute_tolerance(rig, tolerance)}

    def fill(t: float, y: Any, out: Any) -> None:
        out[:] = slope(t, y)

    start, end = rig.times[0], rig.times[-1]
    # two times mean every step
    wanted = {"grid": rig.times, "end": (start, 0.5 * (start + end), end), "steps": (start, end)}

    def solve(rows: Rows) -> Any:
        slope.calls = 0
        found = CVODE(fill, max_num_steps=MOST_STEPS, **options).solve(wanted[rows], list(rig.job.y))
        if not found.success:
            raise NoCvode(" ".join(str(found.message).lower().split()))
        return found

    return solve, slope
