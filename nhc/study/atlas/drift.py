"""C1: the accelerations of the multiplier form keep the constraints to second order only, and errors feed on that."""

from __future__ import annotations

import math

import numpy as np

from nhc.simulate.task import DONE
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, grid, open_runner, open_system
from nhc.study.linearization.units import Matrix

MOVED = (
    *(("contact_oscillator", 0.1, 1000.0), ("chaplygin_sleigh", 0.02, 100.0), ("rolling_disk", 0.005, 50.0)),
    *(("chaplygin_ball", 0.02, 100.0), ("n_trailer3", 0.02, 100.0)),
)
"""System, step, end: constraints in the velocities alone."""


def run() -> Verdict:
    """The pendulum in Cartesian coordinates for 100 s, by RK4, and five rolling and sliding systems; nhc is told of the rod under
    `holonomic:`.
    """
    times = grid(100.0, 1001)
    naive = open_runner(open_system("cartesian_pendulum"), "reference", "rk4", "multipliers", hold=False)
    rough = naive.run(times, step=0.05)
    broken = rough.kind != DONE or max(abs(x) for row in rough.states for x in row) > 1e3
    fine = naive.run(times, step=0.01)
    speeds, places = _off(naive.checks(times, fine, "residual")), _circle(fine.states)
    own = open_runner(open_system("holonomic_pendulum"), "reference", "rk4", "multipliers")
    ends = [own.run(times, step=step) for step in (0.05, 0.01)]
    residual = max(_off(own.checks(times, end, "residual")) for end in ends)
    circle = max(_off(own.checks(times, end, "position")) for end in ends)
    slips = {name: [_slip(name, step, end, hold) for hold in (False, True)] for name, step, end in MOVED}
    kept = max(after for _, after in slips.values())
    told = ", ".join(f"{name} by {before:.1e}" for name, (before, _) in slips.items())
    return Verdict(
        Measure(
            f"accelerations alone: steps of 0.01 leave the constraint by {speeds:.1e} and the circle by {places:.1e}, "
            f"steps of 0.05 {'blow up' if broken else 'survive'}; {told}",
            places,
        ),
        Measure(
            f"brought back after each step, both steps: {residual:.1e} and {circle:.1e}; the others {kept:.1e} at most",
            max(residual, circle, kept),
        ),
        "velocities on the constraint to 1e-12, positions to 1e-10",
        broken
        and places > 1e-3
        and min(before for before, _ in slips.values()) > 1e-10
        and max(residual, kept) <= 1e-12
        and circle <= 1e-10
        and all(end.kind == DONE for end in ends),
    )


def _slip(name: str, step: float, end: float, hold: bool) -> float:
    """How far the velocities leave the constraints, at most; infinite where the run does not come to its end."""
    runner, times = open_runner(open_system(name), "reference", "rk4", "multipliers", hold=hold), grid(end, 1001)
    found = runner.run(times, step=step)
    return _off(runner.checks(times, found, "residual")) if found.kind == DONE else math.inf


def _off(columns: Matrix) -> float:
    return float(np.max(np.abs(columns)))


def _circle(states: list[list[float]]) -> float:
    return max(abs(row[0] ** 2 + row[1] ** 2 - 1.0) for row in states)


SCENARIO = Scenario("C1", "drift off the constraints", "cartesian_pendulum", run)
