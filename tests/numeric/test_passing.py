"""What a motion passes faster than its steps can see is found: against SciPy's DOP853 with steps that are short everywhere."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import pytest
from scipy.integrate import quad, solve_ivp

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolve import resolve
from nhc.mechanics.scenes import start_of
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, look_ahead, run
from nhc.study.chart.grid import Grid
from nhc.study.chart.model import LongModel, compile_long
from nhc.study.chart.study import chart
from nhc.study.stability.bench import open_bench

pytestmark = pytest.mark.usefixtures("own_cache")

HEAD = "nhc: 1\nsystem: passer\nparameters: {h: 10, w: 0.1}\nscenes:\n"
SCENE = "  go: {initial: {x: 0, x': 1}, time: [0, 100], tolerance: 1e-9}\n"


def go(potential: str, settings: Settings | None = None) -> Trajectory:
    text = f"{HEAD}{SCENE}coordinates: [x]\nT: x'^2/2\nV: {potential}\n"
    return run(open_scene(Source("passer.yaml", text), needs=("x", "x'")), settings or Settings(points=2))


def reference(force: Callable[[float], float], end: float = 100.0, longest: float = 0.02) -> list[float]:
    found = solve_ivp(
        lambda t, y: [y[1], force(y[0])],
        (0.0, end),
        [0.0, 1.0],
        method="DOP853",
        rtol=1e-11,
        atol=1e-11,
        max_step=longest,
    )
    return [float(value) for value in found.y[:, -1]]


def bump(height: float, place: float, width: float = 0.1) -> Callable[[float], float]:
    return lambda x: 2 * height * (x - place) / width**2 * math.exp(-(((x - place) / width) ** 2))


PASSED = {
    "h*exp(-((x - 50)/w)^2)": bump(10.0, 50.0),
    "0.3*exp(-((x - 50)/w)^2)": bump(0.3, 50.0),
    "0.3*exp(-((x - 30)/w)^2) + h*exp(-((x - 60)/w)^2)": lambda x: bump(0.3, 30.0)(x) + bump(10.0, 60.0)(x),
    "2000*max(0, w - abs(x - 50))^2/2": lambda x: 2000.0 * max(0.0, 0.1 - abs(x - 50.0)) * math.copysign(1.0, x - 50.0),
}


@pytest.mark.parametrize("potential", PASSED)
def test_a_place_that_is_short_beside_the_motion(potential: str) -> None:
    found = go(potential)
    assert found.rows[-1] == pytest.approx(reference(PASSED[potential]), rel=1e-6, abs=1e-6)
    assert any("would leap over" in note for note in found.notes)


def test_the_delay_of_a_bump_in_closed_form() -> None:
    """Energy 1/2: the bump of height h < 1/2 delays by the integral of 1/v - 1."""
    x, v = go("0.3*exp(-((x - 50)/w)^2)").rows[-1]
    delay = quad(lambda s: 1 / math.sqrt(1 - 0.6 * math.exp(-((s / 0.1) ** 2))) - 1, -1, 1, epsabs=1e-13)[0]
    assert v == pytest.approx(1.0, rel=1e-8) and x == pytest.approx(100.0 - delay, rel=1e-8)


def test_without_a_compiler_too() -> None:
    found = go("h*exp(-((x - 50)/w)^2)", Settings(points=2, compiled=False))
    assert found.rows[-1] == pytest.approx(go("h*exp(-((x - 50)/w)^2)").rows[-1], rel=1e-7)


@pytest.mark.parametrize(
    "potential", ["h*max(0, x - 50)^2/2", "h*max(0, abs(x - 3) - 3)^2/2", "-0.01/((x - 50)^2 + 0.01^2)", "exp(-x/10)"]
)
def test_what_steps_see_by_themselves_is_left_alone(potential: str) -> None:
    found = go(potential)
    assert found.notes == ()
    if potential.startswith("-0.01"):
        force = reference(lambda x: -0.02 * (x - 50.0) / ((x - 50.0) ** 2 + 1e-4) ** 2, longest=0.01)
        assert found.rows[-1] == pytest.approx(force, rel=1e-8)


def test_a_sleigh_over_a_bump_in_the_road() -> None:
    text = f"""{HEAD}  go: {{initial: {{v: 2, theta: 0.3}}, time: [0, 40], need: [x, y, theta, v], tolerance: 1e-9}}
coordinates: [x, y, theta]
T: ((x' - 0.2*sin(theta)*theta')^2 + (y' + 0.2*cos(theta)*theta')^2)/2 + theta'^2/6
V: exp(-((x - 30)/w)^2 - (y/20)^2)
constraints:
  - slip: sin(theta)*x' - cos(theta)*y' = 0
quasi_velocities: {{v: cos(theta)*x' + sin(theta)*y', turn: theta'}}
"""
    job = open_scene(Source("passer.yaml", text))
    found = run(job, Settings(points=2))

    def rates(_: float, state: list[float]) -> list[float]:
        """Edge at (x, y), centre of mass a ahead: v' = a w^2 + F_v, (J + a^2) w' = -a v w, with m = 1 and J = 1/3."""
        x, y, theta, v, w = state
        a, height = 0.2, math.exp(-(((x - 30) / 0.1) ** 2) - (y / 20) ** 2)
        pull = 2 * (x - 30) / 0.01 * height * math.cos(theta) + 2 * y / 400 * height * math.sin(theta)
        return [v * math.cos(theta), v * math.sin(theta), w, a * w * w + pull, -a * v * w / (1 / 3 + a * a)]

    oracle = solve_ivp(rates, (0, 40), [0, 0, 0.3, 2, 0], method="DOP853", rtol=1e-11, atol=1e-11, max_step=0.02)
    x, y, theta, v, _ = (float(value) for value in oracle.y[:, -1])
    assert found.rows[-1] == pytest.approx([x, y, theta, v], rel=1e-6)
    assert abs(x - 80 * math.cos(0.3)) > 0.02  # the bump matters


def test_a_chart_knows_what_is_passed() -> None:
    text = f"{HEAD}{SCENE}coordinates: [x]\nT: x'^2/2\nV: h*exp(-((x - 50)/w)^2)\n"
    grid = Grid(methods=("dop853",), languages=("c",), tolerances=(1e-6, 1e-9), peers=False, budget=0.01)
    made = chart(Source("passer.yaml", text), grid)
    assert made.reference.error < 1e-9
    errors = {result.case.tolerance: result.error for result in made.results if not result.failed}
    assert len(errors) == 2 and errors[1e-9] < 1e-6 and errors[1e-6] < 1e-3
    motion = make_reference_end(text)
    assert motion == pytest.approx(reference(bump(10.0, 50.0)), rel=1e-8)


def make_reference_end(text: str) -> tuple[float, ...]:
    """What the chart's reference solution says of the end."""
    job = open_scene(Source("passer.yaml", text), needs=("x", "x'"), checks=True)
    stops = look_ahead(job)
    rows = LongModel(compile_long(job, ("dop853",)), replace(job, stops=stops)).integrate(
        "dop853", job.time, 1e-14, 0.0, 100_000
    )
    return tuple(rows.rows[-1][:2])


def test_the_laboratory_knows_it_too() -> None:
    """Its reference motion comes back from the wall, and its energy is that of the start."""
    text = f"{HEAD}{SCENE}coordinates: [x]\nT: x'^2/2\nV: h*exp(-((x - 50)/w)^2)\n"
    system = resolve(decode(Source("passer.yaml", text)))
    formulation = formulate(system)
    bench = open_bench(equations_of(system, formulation), formulation, start_of(system, system.spec.scenes[0]))
    assert bench.reference[-1].tolist() == pytest.approx(reference(bump(10.0, 50.0)), rel=1e-8)
