"""Starts where everything is exactly zero, or some of it stays so: no method may scale by that."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.simulate.methods import METHODS, RUNGE_KUTTA, is_adaptive
from nhc.simulate.opening import RunError, open_scene
from nhc.simulate.run import Settings, run
from tests.support import COMPILER

PUSH = """nhc: 1
system: push
coordinates: [x, y, th]
parameters: {m: 2, J: 0.3, F: 1.5, k: 3}
T: m/2*(x'^2 + y'^2) + J/2*th'^2
V: k*y^2/2 - F*x
constraints:
  - edge: -sin(th)*x' + cos(th)*y' = 0
scenes:
  rest: {initial: {}, time: [0, 2]}
"""


pytestmark = pytest.mark.usefixtures("own_cache")


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", METHODS)
def test_a_body_is_pushed_from_rest(method: str, compiled: bool) -> None:
    """x = F t^2 / (2 m) along the edge; y and th stay exactly zero."""
    try:
        job = open_scene(Source("push.yaml", PUSH), method=method, needs=("x", "y", "th", "x'"))
    except RunError as error:
        raise AssertionError(f"{method} does not fit a natural system with a linear constraint") from error
    for tolerance in (1e-4, 1e-9):
        found = run(job, Settings(method, tolerance, 0.0 if is_adaptive(method) else 0.1, 5, compiled))
        assert found.ended == "done", found.reason
        for t, row in zip(found.times, found.rows, strict=True):
            assert row == pytest.approx([0.375 * t * t, 0.0, 0.0, 0.75 * t], abs=1e-9)
        assert all(math.isfinite(x) for row in found.rows for x in row)


@pytest.mark.parametrize("method", RUNGE_KUTTA)
def test_what_rests_in_balance_stays(method: str) -> None:
    """No error at all: steps grow, and nothing is divided by it."""
    text = PUSH.replace(" - F*x", "")
    job = open_scene(Source("push.yaml", text), method=method, needs=("x", "y", "th"))
    for compiled in (True, False) if COMPILER else (False,):
        found = run(job, Settings(method, 1e-8, 0.0 if is_adaptive(method) else 0.1, 3, compiled))
        assert found.ended == "done" and {x for row in found.rows for x in row} == {0.0}
        assert found.outcome.steps <= 25
