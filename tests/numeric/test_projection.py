"""Projection to velocities and positions: it keeps what it should, and the order of the method under it."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from nhc.language import read
from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, run
from tests.support import spec_path

# far enough down for the slope, far enough above rounding: the longer of two steps, and the end
FINE = 1 / 64
STEPS = {
    "contact_oscillator_eps": (2.0, {"dop853": 1 / 5, "gauss6": 1 / 10, "dopri5": 1 / 40}),
    "holonomic_pendulum": (1.0, {"dop853": 1 / 16, "gauss6": 1 / 32, "dopri5": 1 / 16}),
}


pytestmark = pytest.mark.usefixtures("own_cache")


def open_held(name: str, method: str, hold: bool = True) -> Job:
    job = open_scene(read(str(spec_path(name))), "", "multipliers", (), "", method, hold, checks=True, stay=True)
    return replace(job, time=(0.0, STEPS[name][0]))


def last(job: Job, method: str, step: float = 0.0, tolerance: float = 1e-12) -> list[float]:
    found = run(job, Settings(method, tolerance, step, 2, True))
    assert found.ended == "done", found.reason
    return list(found.rows[-1])


@pytest.mark.parametrize("method", RUNGE_KUTTA)
@pytest.mark.parametrize(("name", "levels"), [("contact_oscillator_eps", 1), ("holonomic_pendulum", 3)])
def test_projected_steps_keep_the_order(name: str, levels: int, method: str) -> None:
    """Velocities alone (nonholonomic), and positions as well (holonomic: two Newton steps, then the velocities)."""
    job = open_held(name, method)
    assert len(job.holds) == levels
    exact = last(open_held(name, "dop853"), "dop853")
    step = STEPS[name][1].get(method, FINE)
    coarse, fine = (max(abs(a - b) for a, b in zip(last(job, method, h), exact, strict=True)) for h in (step, step / 2))
    assert math.log2(coarse / fine) == pytest.approx(RUNGE_KUTTA[method].order, abs=0.1)


def test_without_projection_the_constraints_drift() -> None:
    """Rows of residuals after 2 s of coarse steps: rounding with it, the method's error without."""
    for name, least in (("holonomic_pendulum", 1e-7), ("contact_oscillator_eps", 1e-9)):
        kept, lost = (
            run(open_held(name, "rk4", hold), Settings("rk4", 1e-6, 0.05, 41, True)) for hold in (True, False)
        )
        groups = [column.group for column in kept.job.checks]
        places = [k for k, group in enumerate(groups) if "residual" in group or "constraint" in group]
        assert places, groups
        worst = [max(abs(row[k]) for row in found.checks for k in places) for found in (kept, lost)]
        assert worst[0] < 1e-10 and worst[1] > least, worst
