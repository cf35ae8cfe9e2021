"""C4: dependent velocities that can be solved for at the start, but not a little later."""

from __future__ import annotations

import math
from dataclasses import replace

from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.simulate.task import CROSSED
from nhc.study.atlas.scenario import Measure, Runner, Scenario, Verdict, edit_spec, open_runner, open_system

END, STEP, SPIN = 2.0, 0.05, 1.5
BLOCKS = (
    ("chaplygin_sleigh", "y"),
    ("roller_racer", "x, y"),
    ("snakeboard", "x, y"),
    ("skate_incline", "y"),
)
TOLERANCE = 1e-10


def run() -> Verdict:
    """The skate on a slope turns through the fall line's normal, where y' is not determined by x' and phi'; and other blocks."""
    free = open_system("skate_incline")
    fixed = replace(free, dependent=(free.q_names.index("y"),))
    naive = _error(open_runner(fixed, "reference", "rk4", "voronec", watch=False))
    stopped = open_runner(fixed, "reference", "rk4", "voronec").run((0.0, END), step=STEP)
    own = _error(open_runner(free, "reference", "rk4"))
    refused = stopped.kind == CROSSED and abs(stopped.t - math.pi / 2 / SPIN) < STEP
    found = [_follow(name, dependent) for name, dependent in BLOCKS]
    worst, changes = max(error for error, _ in found), [count for _, count in found]
    return Verdict(
        Measure(f"RK4 over the singular block without a guard ends {naive:.2g} m off and reports success", naive),
        Measure(
            f"in the coframe that nhc chooses {own:.1e} m; kept to the block it is refused at t = {stopped.t:.6f}; "
            f"{len(BLOCKS)} forced blocks are left {min(changes)} to {max(changes)} times, and end {worst:.1e} off",
            worst,
        ),
        "a fixed block refused within a step of its singular point; 1e-3 of the naive error in the regular coframe; "
        "100 times the tolerance where the run changes its block",
        naive > 1e-2 and refused and own < 1e-3 * naive and worst <= 100 * TOLERANCE and min(changes) > 0,
    )


def _error(runner: Runner) -> float:
    """Distance from x = (g sin a/2 w^2) sin^2 wt, y = (g sin a/2 w^2)(wt - sin(2wt)/2) at the end."""
    outcome = runner.run((0.0, END), step=STEP)
    scale, angle = 9.81 * math.sin(math.pi / 6) / (2 * SPIN**2), SPIN * END
    x, y = scale * math.sin(angle) ** 2, scale * (angle - math.sin(2 * angle) / 2)
    return math.hypot(outcome.y[0] - x, outcome.y[1] - y)


def _follow(name: str, dependent: str) -> tuple[float, int]:
    """(largest relative distance from the multiplier form at the end, changes of the formulation) with a forced block."""
    source = edit_spec(name, ("dependent:",), f"dependent: [{dependent}]")
    settings = Settings("dop853", TOLERANCE, points=2)
    names = open_system(name).q_names
    found, exact = (
        run_scene(open_scene(source, formulation=form, needs=names, method="dop853"), settings)
        for form in ("voronec", "multipliers")
    )
    if found.ended != "done" or exact.ended != "done":
        return math.inf, 0
    size = max(abs(x) for x in exact.rows[-1])
    pairs = zip(found.rows[-1], exact.rows[-1], strict=True)
    error = max(abs(a - b) / max(abs(b), 1e-3 * size) for a, b in pairs)
    return error, sum("goes on with" in note for note in found.notes)


SCENARIO = Scenario("C4", "singular dependent block", "skate_incline", run)
