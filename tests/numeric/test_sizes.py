"""Each entry of the state is held to its own size: units of others do not matter, and what rounding makes holds no step up."""

from __future__ import annotations

import csv
import io
import math
import subprocess
from pathlib import Path

import pytest
from mpmath import mp

from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.pipeline import Options, emit
from nhc.simulate.ensemble import run_ensemble
from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
from nhc.simulate.opening import open_scene
from nhc.simulate.peers import SCIPY
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.starts import list_starts, read_starts
from tests.support import both_ways, compile_c, seldom, spec_path

ADAPTIVE = [method for method in RUNGE_KUTTA if is_adaptive(method)]

STATION = """nhc: 1
system: station
about: A pendulum beside a body at {far} units of length, {slow} per unit of time, that a spring holds; nothing couples them.
coordinates: [x, th]
parameters: {{m: 2, k: 0.3, w: 3}}
T: m/2*x'^2 + th'^2/2
V: k*x^2/2 - w^2*cos(th)
scenes:
  go: {{initial: {{x: {far}, x': {slow}, th: {angle}, th': {rate}}}, time: [0, 4]}}
"""


def swing(angle: float, rate: float, t: float) -> float:
    """The pendulum th'' = -9 sin(th), from rest or from below, by Jacobi's functions in 30 digits."""
    assert angle == 0.0 or rate == 0.0
    with mp.workdps(30):
        k = mp.mpf(rate) / 6 + mp.sin(
            mp.mpf(angle) / 2
        )  # th = 2 asin(k sn(3 t)) from below, cd in place of sn from rest
        return float(2 * mp.asin(k * mp.ellipfun("sn" if rate else "cd", 3 * mp.mpf(t), k=k)))


@pytest.fixture(scope="module", params=[(0.9, 0.0), (0.0, 1e-7), (1e-9, 0.0)], ids=("wide", "from zero", "tiny"))
def swung(request: pytest.FixtureRequest) -> tuple[float, float, float]:
    angle, rate = request.param
    return angle, rate, swing(angle, rate, 4.0)


def station(angle: float, rate: float, far: float = 1.5e11) -> Source:
    return Source("station.yaml", STATION.format(angle=angle, rate=rate, far=far, slow=far / 5e6))


@pytest.mark.sample(3)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ADAPTIVE)
def test_an_angle_beside_a_far_position(method: str, compiled: bool, swung: tuple[float, float, float]) -> None:
    """It was off by a tenth at a tolerance of 1e-6: its error was held to a millionth of the position."""
    angle, rate, end = swung
    job = open_scene(station(angle, rate), method=method, formulation="lagrange")
    for tolerance in (1e-6, 1e-9):
        found = run(job, Settings(method, tolerance, 0.0, 2, compiled))
        assert found.ended == "done", found.reason
        assert found.rows[-1][1] == pytest.approx(end, abs=10 * tolerance * max(angle, rate / 3))


@pytest.mark.parametrize("method", SCIPY)
def test_solvers_from_elsewhere_are_told_how_large_an_angle_becomes(method: str) -> None:
    """Held to a thousandth of the position at the start, it ended anywhere."""
    end = swing(0.9, 0.0, 4.0)
    job = open_scene(station(0.9, 0.0), method=method, formulation="lagrange")
    found = run(job, Settings(method, 1e-5, 0.0, 2))
    assert found.ended == "done"
    assert found.rows[-1][1] == pytest.approx(end, abs=1e-4)


def test_lanes_and_drivers_hold_it_too(tmp_path: Path, swung: tuple[float, float, float]) -> None:
    angle, rate, end = swung
    source = station(angle, rate)
    job = open_scene(source, method="dop853", formulation="lagrange", whole=True)
    starts = list_starts(job.system, job.scene, read_starts("x\n1.5e11\n1e3\n-4e7\n", decode(source)))
    for member in run_ensemble(job, starts, Settings("dop853", 1e-8, 0.0, 2)).members:
        assert member.rows[-1][1] == pytest.approx(end, abs=1e-7 * max(angle, rate / 3))
    program = compile_c(
        emit(source, "c", Options(driver=True, formulation="lagrange")), tmp_path, "station", library=False
    )
    done = subprocess.run([program, "go", "2", "1e-8"], capture_output=True, text=True, check=True, timeout=60)
    last = list(csv.reader(io.StringIO(done.stdout)))[-1]
    assert float(last[2]) == pytest.approx(end, abs=1e-7 * max(angle, rate / 3))


@pytest.mark.sample(3)
@pytest.mark.parametrize("method", ADAPTIVE)
def test_the_unit_of_a_length_changes_nothing(method: str) -> None:
    """The same motion in five units: rows agree to the tolerance, and steps are about as many."""

    def go(far: float) -> Trajectory:
        job = open_scene(station(0.9, 0.2, far), method=method, formulation="lagrange", needs=("x", "th", "x'", "th'"))
        return run(job, Settings(method, 1e-8, 0.0, 41))

    plain = go(1.0)
    for far in (1e-12, 1e-6, 1e6, 1e12):
        there = go(far)
        for here, row in zip(plain.rows, there.rows, strict=True):
            assert row[0] / far == pytest.approx(here[0], abs=1e-7)
            assert row[2] / far == pytest.approx(here[2], abs=1e-7)
            assert row[1::2] == pytest.approx(here[1::2], abs=1e-7)
        assert there.outcome.calls == pytest.approx(plain.outcome.calls, rel=0.1)


ROTORS = """nhc: 1
system: rotors
about: Two rotors that turn against each other on a cart; by symmetry it stays, but for rounding.
coordinates: [x, a, b]
parameters: {M: 3, m: 0.7, r: 0.3, I: 0.05, k: 2, c: 0.3}
T: M/2*x'^2 + m/2*((x' - r*sin(a)*a')^2 + (r*cos(a)*a')^2) + m/2*((x' + r*sin(b)*b')^2 + (r*cos(b)*b')^2) + I/2*(a'^2 + b'^2)
V: k*(1 - cos(a)) + k*(1 - cos(b)) + c*x^2
scenes:
  go: {initial: {a: 0.6, b: 0.6, a': 2.3, b': 2.3}, time: [0, 20]}
"""


@pytest.mark.parametrize(("method", "compiled"), both_ways(*ADAPTIVE))
def test_what_is_zero_but_for_rounding_holds_no_step_up(method: str, compiled: bool) -> None:
    """The cart's position has no other length beside it, and no size of its own."""
    tolerance = 1e-9 if method == "dop853" else 1e-6
    one = open_scene(Source("rotors.yaml", ROTORS), method=method, formulation="lagrange", needs=("x", "a"))
    found = run(one, Settings(method, tolerance, 0.0, 3, compiled))
    assert found.ended == "done", found.reason
    heavy = ROTORS.replace("M: 3", "M: 1e9")  # which no rounding moves
    there = run(
        open_scene(Source("rotors.yaml", heavy), method=method, formulation="lagrange"),
        Settings(method, tolerance, 0.0, 3),
    )
    assert found.outcome.steps < 1.2 * there.outcome.steps + 20
    assert all(abs(row[0]) < 1e-12 and math.isfinite(row[1]) for row in found.rows)


@pytest.mark.sample(2)
@pytest.mark.parametrize("method", ["dop853", seldom("dopri5"), "radau5"])
def test_terms_that_cancel_hold_no_step_up(method: str) -> None:
    """A bicycle next to straight on pitches by 1e-13, out of terms of 1e13 times that, and no move of its small angles tells their
    rounding: steps of 1e-7 s were taken for ever.
    """
    source = read(spec_path("bicycle"))
    nudged = Source(
        "bicycle.yaml",
        source.text
        + "  nudged: {initial: {z: -0.3, roll': 1e-5, thR': -35/3}, time: [0, 1], need: [x, y, roll, steer, pitch]}\n",
    )
    found = run(open_scene(nudged, "nudged", formulation="voronec", method=method), Settings(method, 1e-9, points=2))
    assert found.ended == "done" and found.outcome.rejected < 20 and found.outcome.steps < 1500
    sharp = run(
        open_scene(nudged, "nudged", formulation="voronec", method="gauss6"), Settings("gauss6", step=1e-3, points=2)
    )
    assert found.rows[-1] == pytest.approx(sharp.rows[-1], rel=1e-7, abs=1e-15)
