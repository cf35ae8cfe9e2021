"""Pulses and jumps of what depends on time alone: found before a run, and met by the ends of its steps.

A mass at rest under a force of time: its velocity at the end is the force's integral, its place the integral's moment.
"""

from __future__ import annotations

import math
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from nhc.program.runs.clock import find_stops
from nhc.simulate.ensemble import run_ensemble
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.simulate.starts import list_starts, read_starts
from nhc.study.chart.model import LongModel, compile_long
from tests.support import ROOT, compile_c

END = 100.0
PAIR = "5*(sign(t - at) - sign(t - at - 0.1))/2"
HIGH = math.sqrt(math.pi) * math.exp(math.lgamma(50000.5) - math.lgamma(50001.0))  # of cos^100000, over a half turn
PULSES = {
    PAIR: (0.5, 40.05),
    "5*max(0, 0.1 - abs(t - at))": (0.05, 40.0),
    "5*min(1, max(0, 0.3 - 10*abs(t - at)))": (5 * 0.3 * 0.03, 40.0),
    "5*(1 + sign(0.0025 - (t - at)^2))/2": (0.5, 40.0),
    "5*exp(-((t - at)/0.05)^2)": (0.25 * math.sqrt(math.pi), 40.0),
    "5*exp(-((t - at)/0.0001)^2)": (0.0005 * math.sqrt(math.pi), 40.0),
    "5*(1 - tanh(100*(t - at))^2)": (0.1, 40.0),
    "5/cosh(100*(t - at))^2": (0.1, 40.0),
    "5/(1 + (10000*(t - at))^2)^2": (0.0005 * math.pi / 2, 40.0),
    "5*cos((t - at)/40)^100000": (200 * HIGH, 40.0),
}


def write(force: str, time: str = "[0, 100]") -> Source:
    return Source(
        "struck.yaml",
        f"""nhc: 1
system: struck
coordinates: [x]
parameters: {{m: 1, at: 40}}
T: m*x'^2/2
forces:
  x: {force}
scenes:
  go: {{initial: {{x: 0, x': 0}}, time: {time}, need: [x, x'], tolerance: 1e-9}}
  late: {{initial: {{x: 0, x': 0}}, time: {time}, need: [x, x'], parameters: {{at: 70.3}}}}
""",
    )


def assert_struck(row: tuple[float, ...], impulse: float, middle: float, bound: float = 1e-7) -> None:
    x, v = row
    assert v == pytest.approx(impulse, rel=bound) and x == pytest.approx(impulse * (END - middle), rel=bound)


@pytest.mark.parametrize("force", PULSES)
def test_a_mass_at_rest_is_struck(force: str) -> None:
    found = run(open_scene(write(force), "go"), Settings(points=3))
    assert found.ended == "done" and found.times == (0.0, 50.0, 100.0)
    assert_struck(found.rows[-1], *PULSES[force])


@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
@pytest.mark.parametrize("compiled", [True, False])
def test_every_adaptive_method_meets_the_stops(method: str, compiled: bool) -> None:
    found = run(open_scene(write(PAIR), "go", method=method), Settings(method, points=2, compiled=compiled))
    assert_struck(found.rows[-1], *PULSES[PAIR])
    assert found.outcome.rejected < 5 and found.outcome.steps < 100


def test_a_row_at_the_very_jump_and_a_scene_of_its_own_values() -> None:
    found = run(open_scene(write(PAIR), "go"), Settings(points=101))
    assert found.times[40] == 40.0 and found.rows[40] == (0.0, 0.0) and len(found.rows) == 101
    late = run(open_scene(write(PAIR), "late"), Settings(points=101))
    assert late.rows[70] == (0.0, 0.0)
    assert_struck(late.rows[-1], 0.5, 70.35)


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [True, False])
def test_stops_that_are_nothing_apart_do_not_end_a_run(compiled: bool) -> None:
    """A saw tooth of period 1: it jumps at a pole, around which stops are some last digits apart, and so are the steps to them."""
    found = run(open_scene(write("atan(tan(pi*t))"), "go"), Settings(points=2, compiled=compiled))
    assert found.ended == "done" and found.rows[-1][1] == pytest.approx(0.0, abs=1e-8)


def test_an_event_at_a_jump() -> None:
    found = run(open_scene(write(PAIR), "go", until="sign(t - 40.1)"), Settings())
    assert found.ended == "event" and found.outcome.t == pytest.approx(40.1, abs=1e-9)
    assert found.outcome.y[1] == pytest.approx(0.5, rel=1e-7)


def test_starts_with_parameters_of_their_own() -> None:
    source = write(PAIR)
    job = open_scene(source, "go", whole=True)
    starts = list_starts(job.system, job.scene, read_starts("at,m\n40,1\n70.3,2\n", decode(source)))
    first, second = run_ensemble(job, starts, Settings(points=2)).members
    assert_struck(first.rows[-1], 0.5, 40.05)
    assert_struck(second.rows[-1], 0.25, 70.35)


@pytest.mark.parametrize("force", [PAIR, "5*exp(-((t - at)/0.05)^2)", "5*(1 - tanh(100*(t - at))^2)"])
def test_the_emitted_driver(force: str, tmp_path: Path) -> None:
    program = compile_c(emit(write(force), "c", Options(driver=True)), tmp_path, "struck", library=False)
    for scene, middle in (("go", PULSES[force][1]), ("late", PULSES[force][1] + 30.3)):
        done = subprocess.run([program, scene, "11", "1e-9"], capture_output=True, text=True, timeout=60)
        rows = [tuple(map(float, line.split(","))) for line in done.stdout.splitlines()[1:]]
        assert done.returncode == 0 and [row[0] for row in rows] == [10.0 * k for k in range(11)]
        assert_struck(rows[-1][1:], PULSES[force][0], middle)


def test_a_reference_in_long_doubles() -> None:
    job = open_scene(write(PAIR), "go", checks=True)
    rows = LongModel(compile_long(job, ("dop853",)), job).integrate("dop853", (0.0, END), 1e-14, 0.0, 10_000).rows
    assert_struck(tuple(rows[-1][:2]), *PULSES[PAIR], 1e-12)


# --- clocks that go many times round in a step -------------------------------------------------------------------


def write_clocks(force: str, y: float = 0.0, tolerance: str = "1e-6") -> Source:
    return Source(
        "clocks.yaml",
        f"""nhc: 1
system: clocks
coordinates: [y]
parameters: {{w: 400}}
T: y'^2/2
forces: {{y: "{force}"}}
scenes: {{go: {{initial: {{y: {y}, y': 0}}, time: [0, 20], need: [y, y'], tolerance: {tolerance}}}}}
""",
    )


WEAK = "cos(t) + 1e-3*cos(w*t)"


def error_of(rows: Sequence[Sequence[float]], w: float = 400.0, weak: float = 1e-3) -> float:
    """Of y and y' at 0, 1, ..., 20, relative to their sizes, which are 2 and 1."""
    exact = [
        (1 - math.cos(t) + weak / w**2 * (1 - math.cos(w * t)), math.sin(t) + weak / w * math.sin(w * t))
        for t in range(21)
    ]
    pairs = [pair for row, true in zip(rows, exact, strict=True) for pair in zip(row, true, (2, 1), strict=True)]
    return max(abs(a - b) / size for a, b, size in pairs)


@pytest.mark.parametrize("method", ["dop853", "dopri5", "radau5"])
@pytest.mark.parametrize("tolerance", [1e-4, 1e-5, 1e-6])
def test_a_fast_force_beside_a_slow_one(method: str, tolerance: float) -> None:
    """The stages of a step that spans its periods meet phases by chance: the error was up to a hundred tolerances."""
    found = run(open_scene(write_clocks(WEAK), "go", method=method), Settings(method, tolerance, points=21))
    assert error_of(found.rows) < tolerance


@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_the_interpreted_run_asks_the_clocks_too(method: str) -> None:
    source = write_clocks(WEAK.replace("w*t", "40*t - y"))
    one, other = (
        run(open_scene(source, "go", method=method), Settings(method, 1e-3, points=2, compiled=compiled))
        for compiled in (True, False)
    )
    assert one.rows[-1] == pytest.approx(other.rows[-1], rel=1e-9)
    assert (one.outcome.steps, one.outcome.calls) == (other.outcome.steps, other.outcome.calls)


@pytest.mark.parametrize(
    ("force", "same"),
    [
        ("cos(t) + 1e-3*sin(w*t)^2", "cos(t) + 5e-4 - 5e-4*cos(2*w*t)"),
        ("cos(t) + 1e-3*cos(5*t^2)", "cos(t) + 1e-3*cos(5*t^2)"),
    ],
)
def test_powers_of_clocks_and_clocks_that_are_not_steady(force: str, same: str) -> None:
    """They agree with a much smaller tolerance, of the same force written otherwise."""
    found = run(open_scene(write_clocks(force), "go"), Settings(tolerance=1e-5, points=21))
    sharp = run(open_scene(write_clocks(same), "go"), Settings(tolerance=1e-11, points=21))
    for row, true in zip(found.rows, sharp.rows, strict=True):
        assert row == pytest.approx(true, abs=1e-5)


def test_a_fast_force_that_moves_nothing_costs_nothing() -> None:
    """All of it, for as long as a step, is below what a step may err by."""
    found = run(open_scene(write_clocks("cos(t) + 1e-9*cos(w*t)"), "go"), Settings(points=21))
    plain = run(open_scene(write_clocks("cos(t)"), "go"), Settings(points=21))
    assert error_of(found.rows, weak=1e-9) < 1e-6
    assert found.outcome.steps <= plain.outcome.steps + 5 and found.outcome.calls <= 1.5 * plain.outcome.calls


def test_steps_of_half_a_radian_are_asked_nothing() -> None:
    """What a force makes of the motion decides, where it is not weak: nothing is asked, in a single run or in lanes."""
    source = write_clocks("-400*y + cos(w*t)", 1.0)
    job = open_scene(source, "go", whole=True)
    single = run(job, Settings(tolerance=1e-9))
    tried = single.outcome.steps + single.outcome.rejected
    assert single.outcome.calls <= 12 * tried + 3 * single.outcome.steps + 20
    table = "w\n" + "\n".join(str(20 + k) for k in range(9))
    found = run_ensemble(job, list_starts(job.system, job.scene, read_starts(table, decode(source))), Settings())
    for k, member in enumerate(found.members):
        w = 20.0 + k
        far = (math.cos(w * 20) - math.cos(400.0)) / (400 - w * w) if k else 20 * math.sin(400.0) / 40
        assert member.rows[-1][0] == pytest.approx(math.cos(400.0) + far, abs=3e-6)


def test_starts_whose_clocks_are_fast_leave_their_lanes() -> None:
    source = write_clocks(WEAK)
    job = open_scene(source, "go", whole=True)
    speeds = [300.0 + 20 * k for k in range(9)]
    starts = list_starts(job.system, job.scene, read_starts("w\n" + "\n".join(map(str, speeds)), decode(source)))
    members = run_ensemble(job, starts, Settings(points=21)).members
    for w, member in zip(speeds, members, strict=True):
        assert error_of(member.rows, w) < 1e-6


def test_the_emitted_driver_asks_the_clocks(tmp_path: Path) -> None:
    program = compile_c(emit(write_clocks(WEAK), "c", Options(driver=True)), tmp_path, "clocks", library=False)
    done = subprocess.run([program, "go", "21", "1e-5"], capture_output=True, text=True, timeout=60)
    rows = [tuple(map(float, line.split(",")))[1:] for line in done.stdout.splitlines()[1:]]
    assert done.returncode == 0 and error_of(rows) < 1e-5


# --- where the stops are ----------------------------------------------------------------------------------------


def stops_of(force: str, time: tuple[float, float] = (0.0, END)) -> list[float]:
    system = resolve(decode(write(force)))
    found = find_stops(system, (1.0, 40.0), time)
    assert all(before <= after <= before + 1e-12 for before, after in found)
    return [0.5 * (before + after) for before, after in found]


def test_jumps_are_found_to_the_last_digits() -> None:
    assert stops_of(PAIR) == pytest.approx([40.0, 40.1], abs=1e-13)
    assert stops_of(PAIR, (0.0, 40.05)) == pytest.approx([40.0], abs=1e-13)
    assert stops_of("abs(sin(pi*t))", (0.0, 3.5)) == pytest.approx([1.0, 2.0, 3.0], abs=1e-12)
    assert stops_of("sign(max(0, t - at) - 1e-3)") == pytest.approx([40.0, 40.001], abs=1e-12)


def test_a_pulse_is_met_from_both_sides_at_its_own_width() -> None:
    found = stops_of("exp(-((t - at)/0.05)^2)")
    assert any(abs(t - 40.0) < 1e-9 for t in found)
    assert 0.01 < min(abs(t - 40.0) for t in found if abs(t - 40.0) > 1e-6) < 0.05
    assert min(found) < 39.6 and max(found) > 40.4


@pytest.mark.parametrize(
    "force",
    [
        "sin(3*t)",
        "exp(-t/10)*cos(20*t)",
        "1/(2 + sin(t))",
        "t^3 - sqrt(1 + t^2)",
        "x*exp(-(x - 1)^2)",
        "sign(x - at)",
        "0",
        "1/(1 + exp(1/(t - at)))",
    ],
)
def test_what_is_never_quiet_or_no_function_of_time_needs_none(force: str) -> None:
    assert stops_of(force) == []


def test_of_what_jumps_too_often_the_first_places_are_listed() -> None:
    found = stops_of("sign(sin(1000*t))")
    assert 10 < len(found) <= 256
    assert found == pytest.approx([0.001 * math.pi * (k + 1) for k in range(len(found))], rel=1e-12)


def test_a_function_without_value_does_not_hide_another_one() -> None:
    found = stops_of("log(t - at) + asin(t) + exp(1000*t)*sign(t - 70)")
    assert any(abs(t - 70.0) < 1e-12 for t in found)


def test_the_gallery_has_nothing_so_short() -> None:
    """Pumping and steering by sines: the steps of these scenes are what they were."""
    moved = set()
    for path in sorted((ROOT / "specs").glob("*.yaml")):
        system = resolve(decode(read(str(path))))
        if any(system.graph.deps[node] & system.graph.deps[system.t] for node in (system.T, system.U, *system.Q)):
            moved.add(path.stem)
        assert find_stops(system, [1.0] * len(system.p), (0.0, END)) == ()
    assert "pumped_pendulum" in moved
