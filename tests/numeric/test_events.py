"""Events of `--until` that are easily missed: two changes of sign in one step, poles where steps meet.  x = cos t throughout."""

from __future__ import annotations

import math
from itertools import product

import pytest

from nhc.language import Source
from nhc.simulate.opening import open_scene
from nhc.simulate.peers import SCIPY
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.stepping.watching import may_dip

TEXT = """nhc: 1
system: circle
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: (x^2 + y^2)/2
scenes: {a: {initial: {x: 1, y': 1}, time: [0, 10]}}
"""
SLOW = TEXT.replace("initial: {x: 1, y': 1}", "initial: {x: 1}")
METHODS = [("dop853", 0.0), ("dopri5", 0.0), ("radau5", 0.0), ("rk4", 0.01)]


def until(expression: str, method: str, step: float, compiled: bool) -> Trajectory:
    job = open_scene(Source("circle.yaml", TEXT), until=expression, method=method)
    return run(job, Settings(method, 1e-9, step, 11, compiled))


@pytest.mark.sample(3)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
@pytest.mark.parametrize("depth", [1e-3, 1e-5, 1e-7])
def test_a_dip_within_a_step_is_seen(depth: float, method: str, step: float, compiled: bool) -> None:
    """x falls to -1 + depth, is beyond it for 2 sqrt(2 depth), and comes back: dop853 steps over all of it."""
    found = until(f"x + {1 - depth!r}", method, step, compiled)
    assert found.ended == "event"
    assert found.times[-1] == pytest.approx(math.acos(depth - 1), abs=1e-8 / math.sqrt(depth))


@pytest.mark.sample(3)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
@pytest.mark.parametrize("angle", [0.3, 1.1, 2.5])
def test_a_target_that_is_passed_within_a_step_is_met(angle: float, method: str, step: float, compiled: bool) -> None:
    """Distances fall and rise along lines, below zero for a short while only, where a parabola sees nothing."""
    x, y, near = math.cos(angle), math.sin(angle), 1e-4
    beside = until(f"abs(x - {x!r}) - {near}", method, step, compiled)
    apart = until(f"sqrt((x - {x!r})^2 + (y - {y!r})^2) - {near}", method, step, compiled)
    assert (beside.ended, apart.ended) == ("event", "event")
    assert beside.times[-1] == pytest.approx(math.acos(x + near), abs=1e-8)
    assert apart.times[-1] == pytest.approx(angle - 2 * math.asin(near / 2), abs=1e-8)


@pytest.mark.sample(4)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
@pytest.mark.parametrize(
    ("expression", "x"),
    [
        ("sqrt(x - 0.5)", 0.5),
        ("-(y + 2)*(x - 0.5)^(3/4)", 0.5),
        ("sqrt(x - 0.5)^3/(2 + t)", 0.5),
        ("3*acos(1.5 - x)", 0.5),
        ("log(x - 0.5) + 9", 0.5 + math.exp(-9)),
        ("log(x - 0.5) + 40", 0.5),  # no double lies between the zero and the edge
        ("log(log(1/2 + x) + 1e-3) + 5", math.exp(math.exp(-5) - 1e-3) - 0.5),
        ("sqrt(x - 0.5) - 1e-4", 0.5 + 1e-8),
        ("sqrt(x - 0.5) - 1e-9", 0.5),
        ("(x - 0.5)^(-3/4) - 1e6", 0.5 + 1e-8),
        ("asin(x - 1.5) + pi/2 - 1e-5", 0.5 + 5e-11),
        ("acos(1.5 - x) - 1e-5", 0.5 + 5e-11),
    ],
)
def test_a_zero_at_the_end_of_what_has_a_value_or_shortly_before(
    expression: str, x: float, method: str, step: float, compiled: bool
) -> None:
    """Beyond x = 1/2 there is no value to change its sign."""
    found = until(expression, method, step, compiled)
    assert found.ended == "event"
    assert found.times[-1] == pytest.approx(math.acos(x), abs=1e-8)


@pytest.mark.parametrize("expression", ["sqrt(x - 1)", "sqrt(x - 2)", "log(x - 1) + 9"])
def test_what_has_no_value_at_the_start(expression: str) -> None:
    found = until(expression, "dop853", 0.0, True)
    assert found.ended == "failed"
    assert "`--until` has no value" in found.reason


@pytest.mark.sample(3)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
@pytest.mark.parametrize(
    "expression", ["sqrt(x - 0.5) + 1", "log(x - 0.5) - 9", "acos(1.5 - x) + 1e-9", "(x - 0.5)^(-3/4) + 1"]
)
def test_what_ends_without_a_zero(expression: str, method: str, step: float, compiled: bool) -> None:
    """The run ends at the edge itself, not a step before, and says what ends there."""
    found = until(expression, method, step, compiled)
    assert found.ended == "failed"
    assert "`--until` has no value beyond this place, where `" in found.reason
    assert found.outcome.t == pytest.approx(math.pi / 3, abs=1e-8)


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
def test_what_only_comes_near_is_no_event(method: str, step: float, compiled: bool) -> None:
    assert until("(x - 0.5)^2 + 1e-9", method, step, compiled).ended == "done"
    assert until("x + 1.0000001", method, step, compiled).ended == "done"


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("expression", ["x - 1", "1 - x", "y^2", "x^2 + y^2 - 1"])
def test_what_begins_at_zero_leaves_it(expression: str, compiled: bool) -> None:
    """Beside the start the interpolant may be off by a last digit, on the other side of zero: no event ends a run at once."""
    for tolerance in (1e-4, 1e-5, 1e-7, 1e-9):
        job = open_scene(Source("circle.yaml", SLOW), until=expression, method="radau5")
        assert run(job, Settings("radau5", tolerance, 0.0, 11, compiled)).times[-1] > 1e-3


@pytest.mark.parametrize("method", SCIPY)
@pytest.mark.parametrize("expression", ["3*x - 1.8", "x - 0.6"])
def test_solvers_from_elsewhere_leave_it_too(expression: str, method: str) -> None:
    text = TEXT.replace("initial: {x: 1, y': 1}", "initial: {x: 0.6, x': 0.5}")
    job = open_scene(Source("circle.yaml", text), until=expression, method=method)
    found = run(job, Settings(method, 1e-9, 0.0, 11, True))
    assert found.ended == "event"
    assert found.times[-1] == pytest.approx(2 * math.atan2(0.5, 0.6), abs=1e-6)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
def test_what_begins_at_zero_but_for_rounding_leaves_it(method: str, step: float, compiled: bool) -> None:
    """3 * 0.6 is a last digit below 1.8, and x grows at first: the event is where it comes back."""
    assert 3 * 0.6 < 1.8
    text = TEXT.replace("initial: {x: 1, y': 1}", "initial: {x: 0.6, x': 0.5}")
    job = open_scene(Source("circle.yaml", text), until="3*x - 1.8", method=method)
    found = run(job, Settings(method, 1e-9, step, 11, compiled))
    assert found.ended == "event"
    assert found.times[-1] == pytest.approx(2 * math.atan2(0.5, 0.6), abs=1e-7)


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), METHODS)
def test_a_pole_where_two_steps_meet_is_none(method: str, step: float, compiled: bool) -> None:
    """This tangent has its pole beside t = 1, a step's end of rk4, and its zero at 1 + pi/2."""
    found = until("tan(t - 1 + 1.5707963267948966)", method, step, compiled)
    assert found.times[-1] == pytest.approx(1 + math.pi / 2, abs=1e-12)
    assert until("sign(x)", method, step, compiled).times[-1] == pytest.approx(math.pi / 2, abs=1e-8)


def test_every_parabola_that_touches_zero_is_looked_at() -> None:
    """With heights b and a at its ends it begins with the slope -2 (b + sqrt(a b)), whatever the units of its heights."""
    for unit in (1e-140, 1.0, 1e140):
        for b, a in product((1e-9, 0.3, 1.0, 7.0, 1e9), repeat=2):
            slope = -2.0 * (b + math.sqrt(a * b))
            for share in (0.2, 1.0, 5.0):  # how the value went in the step before is not how it goes in this one
                trend = share * slope * unit
                assert may_dip([b * unit], [trend], [a * unit], 1.0, 1.0, 0)
                assert may_dip([-b * unit], [trend], [-a * unit], -1.0, -1.0, 0)
    assert not may_dip([1.0], [-0.6], [1.1], 1.0, 1.0, 0)
    assert not may_dip([1.0], [0.6], [0.1], 1.0, 1.0, 0)
    assert may_dip([1.0], [0.0], [1.1], 1.0, 0.2, 0)  # a fifth of the step does not tell how the rest goes


ROD = """nhc: 1
system: rod
coordinates: [th]
bodies: {rod: {turns: [y: th], mass: 1, centre: [0, 0, -1]}}
points: {tip: {parent: rod, at: [0, 0, -2]}}
scenes: {turn: {initial: {th': 0.5}, time: [0, 10], need: [th]}}
"""


@pytest.mark.parametrize(
    ("expression", "angle"), [("rod_x1 - 0.5", math.pi / 3), ("tip_x + 1", math.pi / 6), ("tip_z'", math.pi)]
)
def test_names_of_bodies_that_nothing_else_uses(expression: str, angle: float) -> None:
    found = run(open_scene(Source("rod.yaml", ROD), until=expression), Settings(tolerance=1e-9, points=2))
    assert found.ended == "event" and found.rows[-1][0] == pytest.approx(angle, abs=1e-7)
