"""Forces that bend or jump where a motion only just comes, or starts: no step is refused for what rounding does there."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run

RESTING = """nhc: 1
system: resting
coordinates: [x]
parameters: {k: 1e8}
T: x'^2/2
V: 9.81*x + k/2*max(0, 1 - x)^2
scenes: {go: {initial: {x: 1}, time: [0, 1]}}
"""
"""Let go in contact, which it leaves and touches once in a period."""

TAUT = """nhc: 1
system: taut
coordinates: [a, b]
parameters: {k: 1e8}
define: {pull: "max(0, b - a - 1)"}
T: (a'^2 + b'^2)/2
V: -9.81*(a + b) + k/2*pull^2 + 20*a^2
scenes: {go: {initial: {a: 0, b: 1}, time: [0, 1]}}
"""
"""Two masses on a spring that is just taut where they start, and stays so."""

RUBBED = """nhc: 1
system: rubbed
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: x^2/2
forces: {x: -0.1*sign(x'), y: "FOLLOWER"}
scenes: {go: {initial: {x: 2.03}, time: [0, 20]}}
"""


def go(
    text: str, method: str, tolerance: float, until: str = "", compiled: bool = True, end: float = 0.0
) -> Trajectory:
    """A run of the scene, up to ``end`` if it is given."""
    text = text.replace("time: [0, 1]", f"time: [0, {end}]") if end else text
    job = open_scene(Source("spec.yaml", text), until=until, method=method)
    return run(job, Settings(method, tolerance, 0.0, 2, compiled))


@pytest.mark.sample(3)
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
@pytest.mark.parametrize("k", [1e5, 1e8])
def test_what_is_let_go_in_contact(k: float, method: str, tolerance: float) -> None:
    found = go(RESTING.replace("k: 1e8", f"k: {k}"), method, tolerance)
    assert found.ended == "done" and found.outcome.steps + found.outcome.rejected < 600_000
    assert found.rows[-1][0] == pytest.approx(1 - 9.81 / k * (1 - math.cos(math.sqrt(k))), rel=2 * tolerance)


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10])
@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
def test_a_spring_that_is_just_taut(method: str, tolerance: float) -> None:
    one, both = (go(text, method, tolerance) for text in (TAUT, TAUT.replace('"max(0, b - a - 1)"', "b - a - 1")))
    assert one.ended == both.ended == "done"
    assert one.rows[-1] == pytest.approx(both.rows[-1], rel=tolerance)


@pytest.mark.parametrize("method", ["dop853", "radau5"])
@pytest.mark.parametrize("text", [RESTING, TAUT], ids=["resting", "taut"])
def test_python_does_the_same(text: str, method: str) -> None:
    compiled, interpreted = (go(text, method, 1e-8, compiled=compiled, end=1e-3) for compiled in (True, False))
    assert interpreted.ended == "done" and interpreted.outcome.steps < 2000
    assert interpreted.rows[-1] == pytest.approx(compiled.rows[-1], rel=1e-9)


@pytest.mark.sample(3)
@pytest.mark.parametrize(("follower", "compiled"), [("-y", True), ("-y", False), ("-1e6*(y - x) - 1e5*y'", True)])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9, 1e-10, 1e-11])
def test_a_jump_in_a_step_of_an_implicit_method(tolerance: float, follower: str, compiled: bool) -> None:
    """Arcs of cosines about 0.1 and -0.1; a second estimate of the error had seen the other side of the jump only."""
    found = go(RUBBED.replace("FOLLOWER", follower), "radau5", tolerance, compiled=compiled)
    x = 2.03 - 2 * 0.1 * 6
    assert found.rows[-1][0] == pytest.approx(0.1 + (x - 0.1) * math.cos(20 - 6 * math.pi), abs=3 * tolerance)


OSCILLATOR = """nhc: 1
system: oscillator
coordinates: [x]
T: x'^2/2
V: x^2/2
scenes: {go: {initial: {x: 1}, time: [0, 10]}}
"""


@pytest.mark.sample(4)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
def test_an_event_and_its_opposite_are_one(method: str, compiled: bool) -> None:
    """What reaches zero and stays, or goes back, does not cross it."""
    for expression in ("max(x, 0)", "min(x, 0)", "max(-x, 0)", "abs(x) - x", "min(0, t - 4)"):
        for sign in ("", "-"):
            assert go(OSCILLATOR, method, 1e-8, f"{sign}({expression})", compiled).ended == "done"
    for expression, time in (
        ("x", math.pi / 2),
        ("max(x, -0.5)", math.pi / 2),
        ("x*abs(x)", math.pi / 2),
        ("t - 4", 4.0),
    ):
        for sign in ("", "-"):
            found = go(OSCILLATOR, method, 1e-8, f"{sign}({expression})", compiled)
            assert found.ended == "event" and found.times[-1] == pytest.approx(time, rel=1e-7)
