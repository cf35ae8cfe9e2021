"""Runs that do not keep the energy that their motion conserves say so, where it was asked for."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run

KEPLER = """nhc: 1
system: kepler
coordinates: [x, y]
parameters: {c: 0}
T: (x'^2 + y'^2)/2
V: -1/sqrt(x^2 + y^2)
forces: {x: -c*x'}
scenes:
  flat: {initial: {x: 1.99999, y': 2.2361e-3}, time: [0, 100], need: [x, energy]}
  round: {initial: {x: 1, y': 1}, time: [0, 100], need: [x, energy]}
"""
"""The flat orbit passes the centre sixteen times, at 450 times the speed that its size goes with."""
FREE = KEPLER.replace("parameters: {c: 0}\n", "").replace("forces: {x: -c*x'}\n", "")


def notes(text: str, scene: str, method: str = "dop853", tolerance: float = 1e-8, step: float = 0.0) -> str:
    job = open_scene(Source("kepler.yaml", text), scene, method=method)
    return " ".join(run(job, Settings(method, tolerance, step, 11, compiled=True)).notes)


@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_an_orbit_past_the_centre(method: str) -> None:
    assert "the energy, which the motion conserves, changes by" in notes(FREE, "flat", method)
    assert "the energy" not in notes(FREE, "round", method)


def test_steps_that_are_too_long() -> None:
    assert "these steps are too long for it" in notes(FREE, "flat", "rk4", step=0.01)
    assert "the energy" not in notes(FREE, "round", "rk4", step=0.01)


def test_what_is_not_conserved_may_change() -> None:
    assert "the energy" not in notes(KEPLER.replace("c: 0", "c: 0.001"), "round")
    assert "the energy" not in notes(FREE.replace(", energy]", "]"), "flat")


def test_a_run_that_ends_at_a_pole() -> None:
    """x = 1/(1 - t)."""
    text = "nhc: 1\nsystem: kepler\ncoordinates: [x]\nT: x'^2/2\nV: -x^4/2\nscenes: {go: {initial: {x: 1, x': 1}, time: [0, 1]}}\n"
    assert "the motion comes to a singular place at its end" in notes(text, "go")
    assert "singular" not in notes(text.replace("[0, 1]", "[0, 0.99]"), "go")


SLEIGH = """nhc: 1
system: sleigh
coordinates: [x, y, th]
T: (x'^2 + y'^2 + th'^2)/2
V: cos(x)
define: {lift: cos(th)*x' + sin(th)*y'}
constraints:
  - sin(th)*x' - cos(th)*y' = 0
scenes: {go: {initial: {th: 0, x': 1, th': 0.4}, time: [0, 50]}}
"""


@pytest.mark.parametrize(
    ("until", "constant"),
    [("energy - 1.58 - E", True), ("lift^2/2 + cos(x) - 1.5 - E", True), ("th - 3", False), ("sign(th - 3)", False)],
)
def test_what_a_run_waits_for_may_be_constant(until: str, constant: bool) -> None:
    """Errors and rounding make it cross zero; that is no event of the motion."""
    for value in (0.0, 1e-16, -1e-16, 1e-10, -1e-10):
        job = open_scene(Source("sleigh.yaml", SLEIGH), until=until.replace("E", repr(value)), method="dop853")
        found = run(job, Settings("dop853", 1e-6, 0.0, 11, compiled=True))
        if found.ended == "event":
            break
    assert found.ended == "event"
    assert any("is a constant of the motion" in note for note in found.notes) == constant
