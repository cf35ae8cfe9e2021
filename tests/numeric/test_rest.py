"""Starts where everything is exactly zero, or some of it stays so: no method may scale by that."""

from __future__ import annotations

import csv
import io
import math
import subprocess
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.language import read
from nhc.pipeline import Options, emit
from nhc.simulate.c.compile import build, loop_flags
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import write_source
from nhc.simulate.methods import METHODS, RUNGE_KUTTA, is_adaptive
from nhc.simulate.opening import open_scene
from nhc.simulate.requests import RunError
from nhc.simulate.run import Settings, run
from nhc.simulate.task import DONE, Task
from nhc.simulate.workshop import load
from tests.support import COMPILER, both_ways, compile_c, spec_path

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


@pytest.mark.sample(3)
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


FALL = """nhc: 1
system: joined
about: Two bodies on a joint fall and do not turn; what turns them are sums of large terms that cancel.
rotation: {P: {velocities: [p1, p2, p3]}, Q: {velocities: [q1, q2, q3]}}
coordinates: [x, y, z, u, v, w]
parameters: {m: 1, n: 2, g: 9.81}
bodies:
  B: {at: [x, y, z], rotation: P, mass: m, inertia: [0.1, 0.2, 0.25]}
  C: {at: [u, v, w], rotation: Q, mass: n, centre: [0, 0, 0.1], inertia: {xx: 0.3, yy: 0.4, zz: 0.5, xy: 0.02}}
points:
  J: {parent: B, at: [0.5, 0, 0]}
  K: {parent: C, at: [-0.5, 0.1, 0]}
gravity: [0, 0, -g]
holonomic: [J_x = K_x, J_y = K_y, J_z = K_z]
scenes: {fall: {initial: {x: -0.5, u: {near: 0.5}, v: {near: -0.1}, w: {near: 0}}, time: [0, 1]}}
"""


@pytest.mark.parametrize(
    ("method", "compiled", "most"), [("dopri5", True, 2000), ("dopri5", False, 2000), ("dop853", True, 40000)]
)
def test_what_cancels_beside_entries_that_are_zero_is_rounding(method: str, compiled: bool, most: int) -> None:
    """No small move of a state whose turns are zero tells how the terms round that turn it: moves of the parameters do."""
    job = open_scene(Source("joined.yaml", FALL), method=method, needs=("x", "z", "P_1", "Q_3"))
    found = run(job, Settings(method, 1e-8, 0.0, 3, compiled))
    assert found.ended == "done" and found.outcome.calls <= most
    assert found.rows[-1] == pytest.approx([-0.5, -4.905, 0.0, 0.0], abs=1e-9)


def circle(count: int) -> float:
    """theta(10) of a pendulum that goes round at nearly one height, theta'' = sin(theta) (cos(theta) phi'^2 - g), with
    sin(theta)^2 phi' constant, by ``count`` steps of the classical method.
    """
    momentum = math.sin(1) ** 2 * 4.261055115606757

    def force(theta: float) -> float:
        return math.cos(theta) * momentum**2 / math.sin(theta) ** 3 - 9.81 * math.sin(theta)

    theta, speed, h = 1.0, 0.0, 10.0 / count
    for _ in range(count):
        a = force(theta)
        b = force(theta + h / 2 * speed)
        c = force(theta + h / 2 * (speed + h / 2 * a))
        d = force(theta + h * (speed + h / 2 * b))
        theta += h * (speed + h / 6 * (a + b + c))
        speed += h / 6 * (a + 2 * b + 2 * c + d)
    return theta


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("method", "compiled", "most"),
    [("dop853", True, 10000), ("dop853", False, 10000), ("dopri5", True, 25000), ("radau5", True, 150000)],
)
@pytest.mark.parametrize("needs", [(), ("theta", "phi")])
def test_lengths_do_not_follow_rounding_down(method: str, compiled: bool, most: int, needs: tuple[str, ...]) -> None:
    """theta' is 1e-6, of terms of order ten that cancel: beside a tolerance of 1e-12 their rounding is motion, and no step is
    refused while the next one is always hardly shorter, and none the better for it.
    """
    job = open_scene(read(str(spec_path("spherical_pendulum"))), "conical", method=method, needs=needs)
    found = run(job, Settings(method, 1e-12, 0.0, 2, compiled, most=200_000))
    assert found.ended == "done" and found.outcome.calls <= most
    assert found.rows[-1][0] == pytest.approx(circle(40_000), abs=1e-12)


def test_lengths_do_not_follow_rounding_down_in_a_driver(tmp_path: Path) -> None:
    files = emit(read(str(spec_path("spherical_pendulum"))), "c", Options(driver=True))
    counted = files["spherical_pendulum_main.c"].replace("s->tried % STRIDE", "s->tried % 2000")
    assert counted != files["spherical_pendulum_main.c"]
    counted = counted.replace("s->stalls >= PATIENCE", "1")  # gives up at the 2000th step
    program = compile_c({**files, "spherical_pendulum_main.c": counted}, tmp_path, "spherical_pendulum", library=False)
    done = subprocess.run([program, "conical", "2", "1e-13"], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert float(done.stdout.splitlines()[-1].split(",")[1]) == pytest.approx(circle(40_000), abs=1e-12)


SWIMMER = """nhc: 1
system: swimmer
about: A sleigh on an edge that a wheel turns to and fro; at the start everything is exactly zero, the wheel's torque too.
coordinates: [x, y, theta, delta]
parameters: {m: 1.2, I: 0.1, B: 0.03, a: 0.2, A: 0.5, Omega: 2}
T: m/2*((x' - a*sin(theta)*theta')^2 + (y' + a*cos(theta)*theta')^2) + I/2*theta'^2 + B/2*(theta' + delta')^2
forces: {delta: A*sin(Omega*t)}
constraints: ["-sin(theta)*x' + cos(theta)*y' = 0"]
scenes: {go: {time: [0, 20]}}
"""


def swim(t: float, y: list[float]) -> list[float]:
    """(x, y, theta, delta, v, omega, rho) by momentum and angular momentum about the edge: m v' = m a omega^2,
    (I + m a^2) omega' = -m a v omega - M, B rho' = M, where rho = theta' + delta'.
    """
    _, _, theta, _, v, omega, rho = y
    torque = 0.5 * math.sin(2 * t)
    turn = (-1.2 * 0.2 * v * omega - torque) / (0.1 + 1.2 * 0.04)
    return [v * math.cos(theta), v * math.sin(theta), omega, rho - omega, 0.2 * omega**2, turn, torque / 0.03]


@pytest.fixture(scope="module")
def swum() -> list[float]:
    """Where it ends."""
    from scipy.integrate import solve_ivp

    found = solve_ivp(swim, (0, 20), [0.0] * 7, method="DOP853", rtol=1e-13, atol=1e-15, max_step=0.05)
    return [float(x) for x in found.y[:4, -1]]


@pytest.mark.parametrize(("method", "compiled"), both_ways(*(m for m in RUNGE_KUTTA if is_adaptive(m))))
def test_what_grows_late_from_rest_holds_no_step_up(method: str, compiled: bool, swum: list[float]) -> None:
    """omega ~ t^2, v ~ t^5, y ~ t^9: in a step from zero the error of each is the same part of its size, however short it is."""
    found = run(
        open_scene(Source("swimmer.yaml", SWIMMER), method=method),
        Settings(method, 1e-9, 0.0, 2, compiled),
    )
    assert found.ended == "done", found.reason
    assert found.rows[-1] == pytest.approx(swum, abs=1e-7)


def test_a_driver_starts_from_rest(tmp_path: Path, swum: list[float]) -> None:
    files = emit(Source("swimmer.yaml", SWIMMER), "c", Options(driver=True))
    program = compile_c(files, tmp_path, "swimmer", library=False)
    for tolerance in ("1e-8", "1e-9", "1e-12"):
        done = subprocess.run([program, "go", "2", tolerance], capture_output=True, text=True, timeout=60)
        assert done.returncode == 0, done.stderr
        last = list(csv.reader(io.StringIO(done.stdout)))[-1]
        assert [float(x) for x in last[1:]] == pytest.approx(swum, abs=1e-6)


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("method", "torque", "compiled"),
    both_ways(
        ("dop853", "A*t^8"),
        ("dop853", "A*t^12"),
        ("dop853", "A*t^16"),
        ("dopri5", "A*t^4"),
        ("radau5", "A*t^3"),
        ("radau5", "A*t^5"),
        ("radau5", "A*t^12"),
        ("radau5", "A*max(0, t - 1)"),
    ),
)
def test_forces_of_a_high_power_of_the_time_from_rest(method: str, torque: str, compiled: bool) -> None:
    """B (theta + delta)'' = M by quadrature.  Even what grows first has one relative error in all steps from zero.

    They are tens of thousands at 1e-9; radau5 in Python goes in fewer, from the same start to the same end.
    """
    text = SWIMMER.replace("A*sin(Omega*t)", f'"{torque}"').replace("[0, 20]", "[0, 2]")
    text = text.replace("scenes:", "outputs: {wheel: theta + delta}\nscenes:")
    job = open_scene(Source("swimmer.yaml", text), method=method, formulation="multipliers", needs=("wheel",))
    found = run(job, Settings(method, 1e-9 if compiled or method != "radau5" else 1e-4, 0.0, 2, compiled))
    assert found.ended == "done", found.reason
    scale = 0.5 / 0.03
    exact = {
        "A*t^8": scale * 2**10 / 90,
        "A*t^4": scale * 2**6 / 30,
        "A*t^3": scale * 2**5 / 20,
        "A*t^5": scale * 2**7 / 42,
        "A*t^12": scale * 2**14 / 182,
        "A*t^16": scale * 2**18 / 306,
        "A*max(0, t - 1)": scale / 6,
    }
    assert found.rows[-1] == pytest.approx([exact[torque]], rel=1e-8)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-10])
def test_newton_s_iteration_from_rest_does_not_wait_for_the_last_bit(tolerance: float) -> None:
    """A speed that has no size yet is solved to a part of what the step makes of it; whether the last bit settles hangs on how a
    compiler rounds, and that on the methods beside it in the file."""
    source = read(str(spec_path("pendulum")))  # let go at rest
    job = open_scene(source, method="radau5", stay=True)
    found = []
    for methods in (["radau5"], ["dop853", "radau5"]):
        sources = write_source(
            job.program, [RUNGE_KUTTA[m] for m in methods], job.events, job.holds, dips=job.watch.dips
        )
        path = build(sources, "pendulum_run.c", loop_flags(len(job.y)))
        model = CompiledModel(path, "pendulum", len(job.y), job.width)
        found.append(model.integrate(Task(job.p, job.y, job.time, tolerance), "radau5", model.news()))
    alone, beside = found
    assert alone.y == pytest.approx(beside.y, rel=1e-3 * tolerance)
    assert (alone.steps, alone.rejected) == (beside.steps, beside.rejected)
    assert abs(alone.calls - beside.calls) <= 0.01 * alone.calls


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["dop853", "radau5"])
def test_a_root_of_the_time_from_rest(method: str, compiled: bool) -> None:
    """y'' = t^(1/3): no step from its zero was let pass, and at 1e-12 the run ended in an underflow."""
    text = SHAKEN.replace("cos(w*t + f)", '"t^(1/3)"').replace("40]", "10]")
    job = open_scene(Source("shaken.yaml", text), method=method, needs=("y", "y'"))
    for tolerance in (1e-3, 1e-12) if method == "dop853" else (1e-3, 1e-6):
        found = run(job, Settings(method, tolerance, 0.0, 2, compiled))
        assert found.ended == "done", found.reason
        assert found.rows[-1] == pytest.approx([10 ** (7 / 3) * 9 / 28, 10 ** (4 / 3) * 3 / 4], rel=10 * tolerance)


SHAKEN = """nhc: 1
system: shaken
about: A body at rest under a force that goes to and fro far faster than the first steps can see.
coordinates: [y]
parameters: {w: 50, f: 0}
T: y'^2/2
forces: {y: cos(w*t + f)}
scenes:
  go: {initial: {}, time: [0, 40]}
"""


def shaken(w: float, f: float, t: float) -> tuple[float, float]:
    """(y, y') of y'' = cos(w t + f) from rest."""
    place = (math.cos(f) - math.cos(w * t + f)) / w**2 - t * math.sin(f) / w
    return place, (math.sin(w * t + f) - math.sin(f)) / w


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", [m for m in RUNGE_KUTTA if is_adaptive(m)])
def test_sizes_that_do_not_come_are_taken_back(method: str, compiled: bool) -> None:
    """Refused steps over hundreds of periods told sizes that were thousands of times too large, and errors were held to them."""
    job = open_scene(Source("shaken.yaml", SHAKEN), method=method, needs=("y", "y'"))
    model = load(job, method, compiled)[0]
    phases = [(10 ** (k * 0.05 + 0.6), 0.37 * k * (k % 3)) for k in range(40 if compiled else 3)]
    for tolerance in (1e-2, 1e-3) if compiled else (1e-2,):
        for w, f in phases:
            times = (0.0, 20.0, 40.0)
            found = model.integrate(Task((w, f), job.y, times, 0.01 * tolerance), method, model.news())
            assert found.kind == DONE and len(found.states) == 3
            for t, (y, speed) in zip(times, found.states, strict=True):
                place, exact = shaken(w, f, t)
                assert speed == pytest.approx(exact, abs=10 * tolerance / w), (tolerance, w, f)
                assert y == pytest.approx(place, abs=10 * tolerance * t / w), (tolerance, w, f)


@pytest.mark.parametrize("method", ["dopri5", "dop853"])
def test_sizes_that_do_not_come_are_taken_back_in_lanes(method: str) -> None:
    job = open_scene(Source("shaken.yaml", SHAKEN), method=method, needs=("y", "y'"), whole=True)
    sources = write_source(job.program, [RUNGE_KUTTA[method]], job.events, job.holds, dips=job.watch.dips, lanes=True)
    model = CompiledModel(build(sources, "shaken_run.c", loop_flags(len(job.y))), "shaken", len(job.y), job.width)
    values = [(10 ** (k * 0.05 + 0.6), 0.37 * k * (k % 3)) for k in range(40)]
    for tolerance in (1e-2, 1e-3):
        task = Task(values[0], job.y, (0.0, 20.0, 40.0), 0.01 * tolerance)
        each = model.integrate_each(task, method, [job.y] * len(values), values, model.news())
        for (w, f), found in zip(values, each, strict=True):
            assert found.kind == DONE and len(found.states) == 3
            for t, (y, speed) in zip(task.times, found.states, strict=True):
                place, exact = shaken(w, f, t)
                assert speed == pytest.approx(exact, abs=10 * tolerance / w), (tolerance, w, f)
                assert y == pytest.approx(place, abs=10 * tolerance * t / w), (tolerance, w, f)


def test_a_driver_takes_them_back(tmp_path: Path) -> None:
    scenes = "\n".join(
        f"  s{k}: {{initial: {{}}, time: [0, 40], parameters: {{w: {10 ** (0.1 * k + 0.6)}}}}}" for k in range(24)
    )
    text = SHAKEN.replace("  go: {initial: {}, time: [0, 40]}", scenes).replace("scenes:", "outputs: {v: y'}\nscenes:")
    program = compile_c(emit(Source("shaken.yaml", text), "c", Options(driver=True)), tmp_path, "shaken", library=False)
    for k in range(24):
        done = subprocess.run([program, f"s{k}", "2", "1e-2"], capture_output=True, text=True, timeout=60)
        assert done.returncode == 0, done.stderr
        last = list(csv.reader(io.StringIO(done.stdout)))[-1]
        w = 10 ** (0.1 * k + 0.6)
        assert float(last[1]) == pytest.approx(shaken(w, 0.0, 40.0)[0], abs=10 * 1e-2 * 40 / w)


@pytest.mark.parametrize("compiled", [True, False])
def test_no_whole_number_of_periods_fits_the_first_step(compiled: bool) -> None:
    """90 Hz for 10 s: over a tenth of the run the stages of dopri5 saw a constant, and it went 50 m at any tolerance."""
    text = SHAKEN.replace("w: 50", "w: 2*pi*90").replace("40]", "10]" if compiled else "1]")
    job = open_scene(Source("shaken.yaml", text), method="dopri5", needs=("y",))
    found = run(job, Settings("dopri5", 1e-4, 0.0, 2, compiled))
    assert found.rows[-1] == pytest.approx([0.0], abs=1e-6)
