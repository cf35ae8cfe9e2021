"""What a motion passes faster than its steps can see is not leapt over.

Against SciPy's DOP853 with steps that are short everywhere, and closed forms.
"""

from __future__ import annotations

import math
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from scipy.integrate import quad, solve_ivp

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.pipeline import Options, emit
from nhc.simulate.ensemble import run_ensemble
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.starts import list_starts, read_starts
from nhc.study.chart.grid import Grid
from nhc.study.chart.model import LongModel, compile_long
from nhc.study.chart.study import chart
from nhc.study.stability.bench import open_bench
from tests.support import compile_c, seldom

pytestmark = pytest.mark.usefixtures("optimised_models")

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
    "h*cos((x - 50)/40)^200000": lambda x: 5e4 * math.cos((x - 50.0) / 40.0) ** 199999 * math.sin((x - 50.0) / 40.0),
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("potential", PASSED)
def test_a_place_that_is_short_beside_the_motion(potential: str) -> None:
    found = go(potential)
    assert found.rows[-1] == pytest.approx(reference(PASSED[potential]), rel=1e-6, abs=1e-6)
    assert found.outcome.steps < 250


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
    rows = LongModel(compile_long(job, ("dop853",)), job).integrate("dop853", job.time, 1e-14, 0.0, 100_000)
    return tuple(rows.rows[-1][:2])


def test_the_laboratory_knows_it_too() -> None:
    """Its reference motion comes back from the wall, and its energy is that of the start."""
    text = f"{HEAD}{SCENE}coordinates: [x]\nT: x'^2/2\nV: h*exp(-((x - 50)/w)^2)\n"
    system = resolve(decode(Source("passer.yaml", text)))
    formulation = formulate(system)
    bench = open_bench(equations_of(system, formulation), formulation, start_of(system, system.spec.scenes[0]))
    assert bench.reference[-1].tolist() == pytest.approx(reference(bump(10.0, 50.0)), rel=1e-8)


# --- places that are passed often, and who passes them -----------------------------------------------------------


def swing(potential: str, end: float, settings: Settings, force: str = "0") -> Trajectory:
    """From x = 1 at rest, in V = x^2/2 and what is added to it."""
    text = f"""nhc: 1
system: passer
coordinates: [x]
T: x'^2/2
V: x^2/2 + {potential}
forces: {{x: "{force}"}}
scenes:
  go: {{initial: {{x: 1}}, time: [0, {end}], tolerance: 1e-9}}
"""
    return run(open_scene(Source("passer.yaml", text), needs=("x", "x'"), method=settings.method), settings)


OFTEN = {
    "0.3*exp(-((x - 0.5)/0.001)^2)": lambda x: bump(0.3, 0.5, 0.001)(x),
    "0.05*exp(-((x - 0.5)/0.01)^2)": lambda x: bump(0.05, 0.5, 0.01)(x),
    "0.1*tanh((x - 0.5)/0.002)": lambda x: -50.0 * (1 - math.tanh((x - 0.5) / 0.002) ** 2),
    "1000*max(0, 0.02 - abs(x - 0.5))^2": lambda x: 2000 * max(0.0, 0.02 - abs(x - 0.5)) * math.copysign(1.0, x - 0.5),
    "-0.001/(0.0001 + (x - 0.3)^2)": lambda x: -0.002 * (x - 0.3) / (0.0001 + (x - 0.3) ** 2) ** 2,
}


@pytest.mark.sample(4)
@pytest.mark.parametrize("potential", [one if one.startswith(("0.3", "1000")) else seldom(one) for one in OFTEN])
def test_a_place_that_is_passed_again_and_again(potential: str) -> None:
    """Thirty times, or fifteen: more turns of the argument than a grid over the scene can tell."""
    span = 25.0 if "max" in potential else 50.0
    found = swing(potential, span, Settings(points=2))
    short = solve_ivp(
        lambda t, y: [y[1], -y[0] + OFTEN[potential](y[0])],
        (0.0, span),
        [1.0, 0.0],
        method="DOP853",
        rtol=1e-11,
        atol=1e-12,
        max_step=0.0005 if "max" in potential else 0.001,
    )
    assert found.rows[-1] == pytest.approx([float(v) for v in short.y[:, -1]], rel=1e-5, abs=1e-5)


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
@pytest.mark.parametrize("compiled", [True, False])
def test_every_adaptive_method_with_and_without_a_compiler(method: str, compiled: bool) -> None:
    """A wall that is 0.1 high where the kinetic energy is 3/8: each pass delays."""
    wall = "250*max(0, 0.02 - abs(x - 0.5))^2"
    found = swing(wall, 10.0, Settings(method, points=2, compiled=compiled))
    free = 10.0 - swing_delay(3)
    assert found.rows[-1] == pytest.approx([math.cos(free), -math.sin(free)], rel=1e-6, abs=1e-6)


def swing_delay(passes: int) -> float:
    """How much later than a free one the mass is after so many passes of that wall: the integral of 1/v - 1/v_free."""

    def loss(x: float) -> float:
        free = 1.0 - x * x
        return 1.0 / math.sqrt(free - 500.0 * max(0.0, 0.02 - abs(x - 0.5)) ** 2) - 1.0 / math.sqrt(free)

    return passes * sum(quad(loss, a, b, epsabs=1e-13)[0] for a, b in ((0.48, 0.5), (0.5, 0.52)))


def pushes(force: str, end: float, settings: Settings) -> tuple[float, ...]:
    text = f"""nhc: 1
system: pushed
coordinates: [x]
T: x'^2/2
forces: {{x: "{force}"}}
scenes:
  go: {{initial: {{x: 0}}, time: [0, {end}], tolerance: 1e-9, need: [x']}}
"""
    return run(open_scene(Source("pushed.yaml", text)), settings).rows[-1]


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "force", ["exp(-(sin(pi*t)/0.01)^2)", "max(0, sin(2*pi*t) - 0.999)", "(1 + sign(sin(2*pi*t) - 0.999))/2"]
)
def test_short_pulses_far_more_often_than_a_grid_can_tell(force: str) -> None:
    """On a body at rest; all pulses are equal, and one of them is an integral."""
    end, half = 1000.0, math.acos(0.999) / (2 * math.pi)
    if force.startswith("exp"):
        push = quad(lambda t: math.exp(-((math.sin(math.pi * t) / 0.01) ** 2)), -0.1, 0.1, epsabs=1e-14, points=[0])[0]
    elif force.startswith("max"):
        push = quad(lambda t: math.cos(2 * math.pi * t) - 0.999, -half, half, epsabs=1e-14)[0]
    else:
        push = 2 * half
    assert pushes(force, end, Settings(points=2))[0] == pytest.approx(end * push, rel=1e-5)


def bumpy(speed: float = 1.0) -> Source:
    text = f"""nhc: 1
system: bumpy
parameters: {{w: 0.1}}
coordinates: [x]
T: x'^2/2
V: 0.3*exp(-((x - 50)/w)^2)
scenes:
  go: {{initial: {{x: 0, x': {speed}}}, time: [0, 100], tolerance: 1e-9, need: [x, x']}}
  thin: {{initial: {{x: 0, x': {speed}}}, time: [0, 100], tolerance: 1e-9, need: [x, x'], parameters: {{w: 1e-4}}}}
"""
    return Source("bumpy.yaml", text)


def delay(speed: float, width: float) -> float:
    """The way that is lost over the bump."""
    part = quad(lambda s: 1 / math.sqrt(1 - 0.6 / speed**2 * math.exp(-s * s)) - 1, -9, 9, epsabs=1e-13, points=[0])[0]
    return width * float(part)


def test_starts_that_meet_the_bump_at_times_of_their_own() -> None:
    source = bumpy()
    job = open_scene(source, "go", whole=True)
    table = "x',w\n1,0.1\n2,0.1\n0.5,0.1\n1,1e-4\n3,1e-6\n0.3,0.1\n"
    members = run_ensemble(
        job, list_starts(job.system, job.scene, read_starts(table, decode(source))), Settings()
    ).members
    rows = [found.rows[-1] for found in members]
    for (x, v), (speed, width) in zip(
        rows, ((1, 0.1), (2, 0.1), (0.5, 0.1), (1, 1e-4), (3, 1e-6), (0.3, 0.1)), strict=True
    ):
        if speed == 0.5:
            assert v == pytest.approx(-0.139895178, rel=1e-6)  # hardly under way when it turns: v from SciPy's DOP853
        elif speed < 1.0:
            assert (x, v) == (pytest.approx(30.0, rel=1e-9), pytest.approx(0.3, rel=1e-9))
        else:
            assert x == pytest.approx(100 * speed - delay(speed, width), abs=3e-7) and v == pytest.approx(
                speed, rel=1e-8
            )


def test_the_emitted_driver_meets_it(tmp_path: Path) -> None:
    program = compile_c(emit(bumpy(), "c", Options(driver=True)), tmp_path, "bumpy", library=False)
    for scene, width in (("go", 0.1), ("thin", 1e-4)):
        for rows in ("2", "30"):
            done = subprocess.run([program, scene, rows, "1e-9"], capture_output=True, text=True, timeout=60)
            _, x, v = map(float, done.stdout.splitlines()[-1].split(","))
            assert done.returncode == 0 and v == pytest.approx(1.0, rel=1e-8)
            assert x == pytest.approx(100 - delay(1.0, width), abs=1e-7)


def test_what_has_no_such_places_is_emitted_as_before() -> None:
    source = Source("plain.yaml", bumpy().text.replace("exp(-((x - 50)/w)^2)", "sin(x/w)"))
    assert "places" not in "".join(emit(source, "c", Options(driver=True)).values())
    assert "places" in "".join(emit(bumpy(), "c", Options(driver=True)).values())


def test_a_model_on_less_than_the_whole_state() -> None:
    """What is left out (y) is not asked for: a friction that turns within 1e-3 of rest, for x alone."""
    text = """nhc: 1
system: rubbing
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: x^2/2
forces: {x: "-0.1*tanh(x'/1e-3)", y: "-0.1*tanh(y'/1e-3)"}
scenes:
  go: {initial: {x: 1, y': 1}, time: [0, 6], tolerance: 1e-9, need: [x]}
"""
    job = open_scene(Source("rubbing.yaml", text))
    assert job.state_names == ("x", "x'")
    short = solve_ivp(
        lambda t, y: [y[1], -y[0] - 0.1 * math.tanh(y[1] / 1e-3)],
        (0.0, 6.0),
        [1.0, 0.0],
        method="DOP853",
        rtol=1e-11,
        atol=1e-12,
        max_step=0.001,
    )
    assert run(job, Settings(points=2)).rows[-1][0] == pytest.approx(float(short.y[0, -1]), rel=1e-7)


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_an_argument_that_leaves_the_doubles_far_away(method: str, compiled: bool) -> None:
    """exp(-exp(u)): the outer argument is infinite where the bump is far; the inner one tells of it all the same."""
    text = (
        "nhc: 1\nsystem: passer\ncoordinates: [x, z]\nparameters: {w: 0.1}\nT: x'^2/2 + z'^2/2\n"
        'forces: {z: "exp(-exp(((x - 50)/w)^2/20))"}\n'
        "scenes: {go: {initial: {x': 1}, time: [0, 100]}}\n"
    )
    found = run(open_scene(Source("passer.yaml", text), needs=("z'",)), Settings(method, 1e-6, 0.0, 2, compiled))
    push, _ = quad(lambda u: math.exp(-math.exp(u * u / 20)), -12, 12)
    assert found.rows[-1][0] == pytest.approx(0.1 * push, rel=1e-5)
