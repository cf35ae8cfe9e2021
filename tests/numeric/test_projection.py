"""Projection to velocities and positions: it keeps what it should, and the order of the method under it."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from nhc.diagnostics import Source
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


def open_held(name: str, method: str, hold: bool = True) -> Job:
    job = open_scene(read(str(spec_path(name))), "", "multipliers", method=method, hold=hold, checks=True, stay=True)
    return replace(job, time=(0.0, STEPS[name][0]))


def last(job: Job, method: str, step: float = 0.0, tolerance: float = 1e-12) -> list[float]:
    found = run(job, Settings(method, tolerance, step, 2, True))
    assert found.ended == "done", found.reason
    return list(found.rows[-1])


@pytest.mark.sample(2)
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


CART = """nhc: 1
system: cart
coordinates: [x, phi, X, Y]
parameters: {M: 1, m: 0.5, l: 1, r: 0.1, g: 9.81}
T: M/2*x'^2 + m/2*(X'^2 + Y'^2)
V: m*g*Y
constraints: ["x' = r*phi'"]
holonomic: ["(X - x)^2 + Y^2 = l^2"]
outputs: {off: "(X - x)^2 + Y^2 - l^2", roll: x - r*phi}
scenes: {go: {initial: {X: l}, time: [0, 0.4], need: [x, off, roll]}}
"""
ROD = """nhc: 1
system: rod
rotation: {R: {velocities: [p, q, r]}}
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2)/2 + 0.05*(p^2 + q^2)
V: 9.81*z
constraints: ["r = 0"]
holonomic: ["x = R_x3", "y = R_y3", "z = R_z3"]
outputs: {off: z - R_z3, spin: R_3}
scenes: {go: {initial: {z: 1, p: 1}, time: [0, 1], need: [z, off, spin]}}
"""
SPUN = """nhc: 1
system: spun
coordinates: [r, theta, z]
parameters: {W: 1}
T: (r'^2 + r^2*theta'^2 + z'^2)/2
V: 9.81*z
constraints: ["theta' = W"]
holonomic: ["z = r^2"]
outputs: {off: z - r^2, turn: theta - W*t}
scenes: {go: {initial: {}, time: [0, 1], need: [r, off, turn]}}
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize("python", [False, True])
@pytest.mark.parametrize("formulation", ["", "multipliers"])
@pytest.mark.parametrize(
    ("text", "calls"),
    [
        (CART, ("hold_q",)),
        (ROD, ("hold_q",)),
        (SPUN, ("hold_q", "hold_q_within")),  # without mass on its axis only, where this scene begins and stays
    ],
    ids=["cart", "rod", "spun"],
)
def test_coordinates_without_mass_are_held_by_the_velocity_rows(
    text: str, calls: tuple[str, ...], formulation: str, python: bool
) -> None:
    """No projection is shortest where a displacement has no mass: there it goes where the velocity rows allow it."""
    kept, free = (
        run(
            open_scene(Source("massless.yaml", text), "", formulation, method="dop853", hold=hold, stay=True),
            Settings("dop853", 1e-9, 0.0, 2, python),
        )
        for hold in (True, False)
    )
    assert kept.job.holds[0] == calls
    assert (kept.ended, free.ended) == ("done", "done"), kept.reason
    first, off, integral = kept.rows[-1]
    assert first == pytest.approx(free.rows[-1][0], abs=1e-8)
    assert abs(off) < 1e-13 and abs(integral) < 1e-8
