"""Steps end at corners of abs, sign, min and max and go on behind them, against closed forms."""

from __future__ import annotations

import math
import subprocess
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import compile_c


def between_stops(stiffness: float, end: float) -> float:
    """Where a mass of 1 with the speed 0.7 is between two stops at 1 and -1: free flights and halves of a sine."""
    rate = math.sqrt(stiffness)
    whole = 2 / 0.7 + math.pi / rate
    count, after = divmod(end - 1 / 0.7 - math.pi / rate, whole)
    place = 1 - 0.7 * after if after < 2 / 0.7 else -1 - 0.7 / rate * math.sin(rate * (after - 2 / 0.7))
    return place if count % 2 == 0 else -place


def bounce(stiffness: float, tolerance: float, settings: Settings) -> float:
    """The error in tolerances after 16 bounces or so."""
    text = f"""nhc: 1
system: stops
coordinates: [x]
T: x'^2/2
V: {stiffness / 2}*max(x - 1, 0)^2 + {stiffness / 2}*min(x + 1, 0)^2
scenes:
  go: {{initial: {{x': 0.7}}, time: [0, 50], tolerance: {tolerance}, need: [x]}}
"""
    found = run(open_scene(Source("stops.yaml", text), method=settings.method), settings).rows[-1][0]
    return abs(found - between_stops(stiffness, 50.0)) / tolerance


@pytest.mark.sample(3)
@pytest.mark.parametrize("tolerance", [1e-6, 1e-8])
@pytest.mark.parametrize("stiffness", [1e2, 1e4, 1e5, 1e6, 1e7])
def test_no_error_is_lost_at_a_stop(stiffness: float, tolerance: float) -> None:
    """Steps across corners lost up to 3900 tolerances; speeds that are right to a tolerance drift by 25 in 50 s."""
    assert bounce(stiffness, tolerance, Settings(points=2)) < 25


@pytest.mark.parametrize(
    ("method", "compiled"), [("dopri5", True), ("radau5", True), ("dop853", False), ("radau5", False)]
)
def test_every_method_ends_at_stops(method: str, compiled: bool) -> None:
    assert bounce(1e4, 1e-6, Settings(method, points=2, compiled=compiled)) < 25


@pytest.mark.parametrize("compiled", [True, False])
def test_steps_go_on_behind_a_jump(compiled: bool) -> None:
    """A constant force towards the origin: parabolas, of a period of 4 sqrt(2)."""
    text = """nhc: 1
system: turned
coordinates: [x]
T: x'^2/2
forces: {x: -sign(x)}
scenes:
  go: {initial: {x: 1}, time: [0, 30], tolerance: 1e-8, need: [x, x']}
"""
    found = run(open_scene(Source("turned.yaml", text)), Settings(points=31, compiled=compiled))
    quarter = math.sqrt(2)
    for t, (x, speed) in zip(found.times, found.rows, strict=True):
        turn = t % (4 * quarter)
        if turn <= quarter or turn >= 3 * quarter:
            since = turn if turn <= quarter else turn - 4 * quarter
            expected = 1 - since * since / 2, -since
        else:
            since = turn - 2 * quarter
            expected = since * since / 2 - 1, since
        assert (x, speed) == pytest.approx(expected, abs=2e-8)


def test_a_driver_ends_its_steps_at_stops(tmp_path: Path) -> None:
    text = """nhc: 1
system: stops
coordinates: [x]
T: x'^2/2
V: 5e3*max(x - 1, 0)^2 + 5e3*min(x + 1, 0)^2
scenes:
  go: {initial: {x': 0.7}, time: [0, 50], tolerance: 1e-6, need: [x]}
"""
    program = compile_c(emit(Source("stops.yaml", text), "c", Options(driver=True)), tmp_path, "stops", library=False)
    last = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()[-1]
    assert abs(float(last.split(",")[1]) - between_stops(1e4, 50.0)) < 25e-6
