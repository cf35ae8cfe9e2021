"""Stiff scenes: found along the run, handed to an implicit method, and back where that no longer pays."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.language import Source, read
from nhc.program.runs.limits import MANY_STEPS
from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.methods.tableau import Explicit
from nhc.simulate.opening import open_scene
from nhc.simulate.pacing import Pace
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.stiffness import spectral_size
from nhc.simulate.task import TOO_MANY, Outcome, Task
from nhc.simulate.unstable import LIMITS
from tests.support import spec_path

SYRUP = """nhc: 1
system: syrup
coordinates: [x, y]
T: x'^2/2 + y'^2/2
V: y^2/2
forces: {x: "FORCE"}
scenes: {pour: {initial: {y: 1}, time: [0, 10], need: [x, y]}}
"""
DRAG = "-5e5*(x' - cos(t))"
THAW = "-1e5*exp(-8*t^2)*(x' - cos(t)) - sin(t) - 400*(x - sin(t))"


def pour(force: str, method: str = "auto", tolerance: float = 1e-6, start: str = "y: 1") -> Trajectory:
    source = Source("syrup.yaml", SYRUP.replace("FORCE", force).replace("y: 1", start))
    return run(open_scene(source, method=method), Settings(method, tolerance, points=21))


def test_strong_drag_is_handed_over() -> None:
    """C6: an explicit method is bound to steps of about 1.2e-5; the whole run takes steps a hundred times as long on average."""
    found = pour(DRAG)
    assert found.ended == "done" and found.method == "dop853, radau5"
    (note,) = found.notes
    assert "the scene is stiff" in note and "the run goes on with radau5" in note
    assert found.outcome.steps < 10 / 1.2e-5 / 100
    for t, row in zip(found.times, found.rows, strict=True):
        # the transient of the start moves x by 1/5e5
        assert row == pytest.approx([math.sin(t) - 2e-6 * (math.cos(t) - 1), math.cos(t)], abs=5e-6)


def test_a_method_that_is_asked_for_is_kept_and_warned_of() -> None:
    found = pour("-2e4*(x' - cos(t))", "dop853")
    (note,) = found.notes
    assert found.method == "dop853" and "leave `--method` out, or take radau5" in note
    assert pour("-2e4*(x' - cos(t))", "radau5").notes == ()
    assert pour("-2*(x' - cos(t))", "dop853").notes == ()


@pytest.mark.parametrize(("method", "compiled"), [("radau5", True), ("radau5", False), ("auto", True)])
def test_rounding_of_stiff_slopes_is_damped(method: str, compiled: bool) -> None:
    """Van der Pol's oscillator on its slow way, t = mu (log(x) - x^2/2) + const: what rounding makes of x'' in a step, if nothing
    damped it, would be more than the state.
    """
    text = SYRUP.replace("FORCE", "1e6*(1 - x^2)*x' - x").replace("y: 1", "x: 2").replace("10]", "7e5]")
    job = open_scene(Source("syrup.yaml", text), method=method, needs=("x",))
    found = run(job, Settings(method, 1e-8, points=2, compiled=compiled))
    x = found.rows[-1][0]
    assert math.log(x) - x**2 / 2 - (math.log(2) - 2) == pytest.approx(0.7, abs=1e-7)


def test_many_steps_say_that_errors_add_up() -> None:
    """Where accuracy makes them many; not where stability does, of which another note speaks."""
    spring = SYRUP.replace("FORCE", "-9*x").replace("y: 1", "x: 1")
    for end, many in ((20000, True), (200, False)):
        job = open_scene(Source("spring.yaml", spring.replace("[0, 10]", f"[0, {end}]")), method="dop853")
        found = run(job, Settings("dop853", 1e-6, points=21))
        assert (found.outcome.steps > MANY_STEPS) == many
        assert [(str(found.outcome.steps) in note, "errors may add up" in note) for note in found.notes] == [
            (True, True)
        ] * many


def test_back_where_the_implicit_method_no_longer_pays() -> None:
    """The drag is gone after a second; then a spring's motion is to be followed, which is not stiff."""
    found = pour(THAW, tolerance=1e-9, start="y: 1, x': 1")
    assert found.ended == "done" and len(found.notes) == 2, found.notes
    assert (
        "goes on with radau5" in found.notes[0]
        and "radau5 no longer pays: the run goes on with dop853" in found.notes[1]
    )
    # x = sin t is a solution, and the start is on it
    assert max(abs(row[0] - math.sin(t)) for t, row in zip(found.times, found.rows, strict=True)) < 1e-6


def test_an_oscillation_is_not_stiff() -> None:
    """The fast spring of the disks swings: its motion has to be followed."""
    for scene in ("reference", "stiff"):
        found = run(open_scene(read(str(spec_path("disk_chain2"))), scene), Settings())
        assert found.method == "dop853" and found.notes == ()


def test_the_interpreted_run_does_the_same() -> None:
    source = Source("syrup.yaml", SYRUP.replace("FORCE", "-3e3*(x' - cos(t))").replace("10]", "1]"))
    found = run(open_scene(source), Settings(tolerance=1e-5, points=3, compiled=False))
    assert found.method.endswith("radau5") and found.rows[-1][0] == pytest.approx(math.sin(1), abs=1e-3)


def test_the_size_of_the_fastest_mode() -> None:
    """Real, imaginary and defective ones."""
    matrices = [
        ([[-3.0, 1.0], [0.0, -200.0]], 200.0),
        ([[0.0, 1.0], [-400.0, 0.0]], 20.0),
        ([[0.0, 1.0], [0.0, 0.0]], 0.0),
    ]
    for matrix, size in matrices:
        found = spectral_size(
            lambda y, m=matrix: [sum(a * x for a, x in zip(r, y, strict=True)) for r in m], [1.0, 0.5]
        )
        assert found == pytest.approx(size, rel=0.05, abs=1e-6)


@pytest.mark.parametrize("how", [(), ("--python",)])
def test_the_command_says_so(how: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "syrup.yaml"
    spec.write_text(SYRUP.replace("FORCE", "-3e3*(x' - cos(t))").replace("10]", "1]"))
    code = main(["run", str(spec), "--tol", "1e-5", *how])
    out, err = capsys.readouterr()
    assert code == 0 and out.startswith("t,x,y\n") and "the scene is stiff" in err and "goes on with radau5" in err


def test_refused_steps_count_against_the_limit_of_all_legs() -> None:
    """Legs may take 100 steps together, accepted or refused; a look after each 40 of them does not lengthen a run."""
    pace = Pace("dop853", Task([], [1.0], [0.0, 1.0], 1e-6, most=100), True, print, looks=40)
    left = []
    for _ in range(3):
        left.append(pace.most)
        pace.count(Outcome(TOO_MANY, 0, 0.5, [1.0], 1e-3, steps=25, rejected=15))
    assert left == [40, 40, 20]
    assert pace.most == 0


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["radau5", "gauss4", "gauss6", "midpoint"])
def test_implicit_methods_start_where_the_jacobian_has_no_value(method: str, compiled: bool) -> None:
    """A fall from rest, dragged by v sqrt(v^2): the derivative as it is written is 0/0 at rest.  z = -log(cosh(sqrt(g c) t))/c."""
    text = (
        "nhc: 1\nsystem: parachute\ncoordinates: [x, z]\nT: (x'^2 + z'^2)/2\nV: 9*z\ndefine: {v: sqrt(x'^2 + z'^2)}\n"
    )
    text += "forces: {x: -v*x'/4, z: -v*z'/4}\nscenes: {drop: {time: [0, 2], need: [z]}}\n"
    job = open_scene(Source("parachute.yaml", text), method=method)
    found = run(job, Settings(method, 1e-6, step=0.0 if method == "radau5" else 0.005, points=3, compiled=compiled))
    assert found.ended == "done" and found.rows[-1][0] == pytest.approx(-4 * math.log(math.cosh(3)), rel=1e-5)


CAR = """nhc: 1
system: car
coordinates: [x, y, th, d]
parameters: {m: 10, J: 2, Js: 0.1, L: 1.2, c: 0.5, tq: 0.05}
T: m/2*(x'^2 + y'^2) + J/2*th'^2 + Js/2*(th' + d')^2
forces: {d: tq}
constraints:
  - rear: -sin(th)*x' + cos(th)*y' = 0
  - front: -sin(th + d)*(x' - L*sin(th)*th') + cos(th + d)*(y' + L*cos(th)*th') = 0
scenes: {s: {initial: {x': 1, d: 0.2}, time: [0, 8], need: [energy]}}
"""


def fixed(text: str, method: str, step: float) -> Trajectory:
    return run(open_scene(Source("s.yaml", text), method=method), Settings(method, 0.0, step, points=11))


def test_the_limits_of_stability_are_those_of_the_coefficients() -> None:
    """R(z) = 1 + z b (1 - z A)^-1 e: beyond the limit |R| > 1 at all angles of the left half of the plane, and not much before."""
    for name, limit in LIMITS.items():
        method = RUNGE_KUTTA[name]
        assert isinstance(method, Explicit)
        weights = [list(method.rows[i - 1][:i]) if i else [] for i in range(method.stages)]
        powers, coefficients = [1.0] * method.stages, [1.0]
        for _ in range(method.stages):
            coefficients.append(sum(b * x for b, x in zip(method.rows[method.stages - 1], powers, strict=False)))
            powers = [sum(a * x for a, x in zip(row, powers, strict=False)) for row in weights]

        def damped(z: complex, known: tuple[float, ...] = tuple(coefficients)) -> bool:
            return abs(sum(c * z**k for k, c in enumerate(known))) <= 1.0

        reach = max(
            length / 50
            for angle in range(91)
            for length in range(600)
            if damped(cmath.rect(length / 50, math.pi * (0.5 + angle / 180)))
        )
        assert limit - 0.15 < reach <= limit


@pytest.mark.parametrize("formulation", ["euler-lagrange", "voronec"])
def test_fixed_steps_that_end_anywhere_are_told_to_be_too_long(formulation: str) -> None:
    job = open_scene(Source("s.yaml", CAR), formulation=formulation, method="dop853")
    found = run(job, Settings("dop853", 0.0, 3.0, points=3))
    assert found.ended == "failed" or abs(found.rows[-1][0]) > 1e10
    assert any("beyond the stability of dop853 (h |lambda|" in note for note in found.notes), found.notes
    assert not [note for note in run(job, Settings("dop853", 0.0, 0.05, points=3)).notes if "stability" in note]


@pytest.mark.parametrize(("method", "step"), [("dop853", 7.0), ("dopri5", 3.6), ("rk4", 3.1)])
def test_an_oscillation_that_grows_by_its_steps(method: str, step: float) -> None:
    text = SYRUP.replace("FORCE", "-x").replace("time: [0, 10]", f"time: [0, {200 * step}]")
    found = fixed(text, method, step)
    assert abs(found.rows[-1][1]) > 1e6 and any(f"beyond the stability of {method}" in note for note in found.notes)
    assert fixed(text, method, step / 10).notes == ()


def test_steps_of_implicit_methods_and_short_passages_are_not_too_long() -> None:
    stiff = SYRUP.replace("FORCE", DRAG)
    assert any("beyond the stability" in note for note in fixed(stiff, "dop853", 0.01).notes)
    assert fixed(stiff, "radau5", 0.01).notes == ()
    passing = SYRUP.replace("FORCE", "-100*exp(-400*t^2)*x'").replace("{y: 1}", "{y: 1, x': 1}")
    assert fixed(passing, "dop853", 0.1).notes == ()
