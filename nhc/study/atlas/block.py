"""C4: dependent velocities that can be solved for at the start, but not a little later."""

from __future__ import annotations

import math
from dataclasses import replace

from nhc.simulate.task import CROSSED
from nhc.study.atlas.scenario import Measure, Runner, Scenario, Verdict, open_runner, open_system

END, STEP, SPIN = 2.0, 0.05, 1.5


def run() -> Verdict:
    """The skate on a slope turns through the fall line's normal, where y' is not determined by x' and phi'."""
    free = open_system("skate_incline")
    fixed = replace(free, dependent=(free.q_names.index("y"),))
    naive = _error(open_runner(fixed, "reference", "rk4", "voronec", watch=False))
    watched = open_runner(fixed, "reference", "rk4", "voronec").run((0.0, END), step=STEP)
    own = _error(open_runner(free, "reference", "rk4"))
    refused = watched.kind == CROSSED and abs(watched.t - math.pi / 2 / SPIN) < STEP
    return Verdict(
        Measure(f"RK4 over the singular block without a guard ends {naive:.2g} m off and reports success", naive),
        Measure(
            f"in the coframe that nhc chooses {own:.1e} m; the fixed block is refused at t = {watched.t:.6f}"
            if refused
            else f"the fixed block is not refused; {own:.1e} m in nhc's own coframe",
            own,
        ),
        "the fixed block refused within a step of the singular point; 1e-3 of the naive error in the regular coframe",
        naive > 1e-2 and refused and own < 1e-3 * naive,
    )


def _error(runner: Runner) -> float:
    """Distance from x = (g sin a/2 w^2) sin^2 wt, y = (g sin a/2 w^2)(wt - sin(2wt)/2) at the end."""
    outcome = runner.run((0.0, END), step=STEP)
    scale, angle = 9.81 * math.sin(math.pi / 6) / (2 * SPIN**2), SPIN * END
    x, y = scale * math.sin(angle) ** 2, scale * (angle - math.sin(2 * angle) / 2)
    return math.hypot(outcome.y[0] - x, outcome.y[1] - y)


SCENARIO = Scenario("C4", "singular dependent block", "skate_incline", run)
