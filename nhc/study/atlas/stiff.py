"""C6: a fast decay that the solution no longer shows still dictates the steps of an explicit method."""

from __future__ import annotations

import math

import numpy as np

from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.task import DONE
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system
from nhc.study.stability.stepsize import amplification

RATE, END = 5e5, 3.0  # c/m, and the scene's time


def run() -> Verdict:
    """A falling mass with strong drag: it sinks at g m/c after some microseconds."""
    system, settings = open_system("point_mass"), (f"c={2 * RATE}",)
    limit = _limit() / RATE
    naive = open_runner(system, "reference", "rk4", settings=settings)
    ends = [naive.run((0.0, 2000 * limit), step=factor * limit) for factor in (0.95, 1.05)]
    sizes = [max(abs(x) for x in end.y) if end.kind == DONE else math.inf for end in ends]
    own = open_runner(system, "reference", "radau5", settings=settings)
    outcome = own.run((0.0, END), tolerance=1e-8)
    height = 10 - 9.81 / RATE * END + (4 + 9.81 / RATE) * -math.expm1(-RATE * END) / RATE
    error = abs(outcome.y[2] - height) / 10
    gain = END / outcome.steps / limit
    return Verdict(
        Measure(
            f"RK4 may step {limit:.3g} s: stable at 0.95 of it, "
            + ("not a number" if not math.isfinite(sizes[1]) else f"grown to {sizes[1]:.1e}")
            + " at 1.05",
            limit,
        ),
        Measure(f"radau5 steps {gain:.2g} times as long on average, height right to {error:.1e}", gain),
        "steps at least 100 times the explicit limit, error at most 1e-6",
        sizes[0] < 100 and sizes[1] > 1e6 and gain >= 100 and error <= 1e-6 and outcome.kind == DONE,
    )


def _limit() -> float:
    """The end of RK4's interval of stability on the negative axis."""
    low, high = 2.0, 3.0
    for _ in range(60):
        middle = (low + high) / 2
        grows = abs(amplification(RUNGE_KUTTA["rk4"], np.array([complex(-middle)]))[0]) > 1
        low, high = (low, middle) if grows else (middle, high)
    return low


SCENARIO = Scenario("C6", "stiffness", "point_mass", run)
