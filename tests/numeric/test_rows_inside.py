"""Rows and events inside steps are as accurate as asked, also where a mode is too fast for the steps and has died away."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from nhc.diagnostics import Source
from nhc.simulate.changes import Changes
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run

SPEC = """nhc: 1
system: overdamped
coordinates: [x, y]
parameters: {c: 30, k: 6}
T: x'^2/2 + y'^2/2
V: k/2*x^2 + y^2/2
forces: {x: "-c*x'"}
scenes:
  go: {time: [0, 8], initial: {x: 1, y: 1}, need: [x, "x'", y]}
"""


def exact(t: float, k: float) -> tuple[float, float, float]:
    """x, x' and y; of x'' + 30 x' + k x = 0 from rest at 1."""
    root = math.sqrt(225 - k)
    slow, fast = root - 15, -root - 15
    a, b = -fast / (slow - fast), slow / (slow - fast)
    x, v = (
        a * math.exp(slow * t) + b * math.exp(fast * t),
        a * slow * math.exp(slow * t) + b * fast * math.exp(fast * t),
    )
    return x, v, math.cos(t)


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-8, 1e-10])
@pytest.mark.parametrize("k", ["3", "6", "10"])
def test_rows_inside_steps_are_as_accurate_as_asked(k: str, tolerance: float, compiled: bool) -> None:
    job = open_scene(Source("s.yaml", SPEC), changes=Changes((f"k={k}",), ""))
    found = run(job, Settings(method="dop853", tolerance=tolerance, points=801, compiled=compiled))
    truth = [exact(t, float(k)) for t in found.times]
    for column in range(3):
        size = max(abs(row[column]) for row in truth)
        off = max(abs(row[column] - true[column]) for row, true in zip(found.rows, truth, strict=True))
        assert off < tolerance * size
    assert found.outcome.steps < len(found.times) / 2  # most rows lie inside


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize(("tolerance", "when"), [(1e-6, 1.6), (1e-8, 1.72), (1e-10, 1.8)])
def test_events_inside_steps_are_as_accurate_as_asked(tolerance: float, when: float, compiled: bool) -> None:
    x, v, _ = exact(when, 6.0)
    until = f"min(x' - ({v!r}), t - 1)"  # x' rises through v; before that it fell through it
    job = open_scene(Source("s.yaml", SPEC), until=until, method="dop853")
    found = run(job, Settings(method="dop853", tolerance=tolerance, points=2, compiled=compiled))
    bend = abs(30 * v + 6 * x)  # |x''|
    assert found.ended == "event"
    assert abs(found.times[-1] - when) < tolerance * 0.4 / bend  # x' was 0.39 at most
    assert all(a < b for a, b in pairwise(found.times))
