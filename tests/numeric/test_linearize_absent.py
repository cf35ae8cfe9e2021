"""Motions that are steady because parameters are 0: a spring to the ground, a slope."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from nhc.cli import main
from nhc.diagnostics import Source
from nhc.pipeline import Options, linearize
from nhc.study.linearization import sweep as sweep_module
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Findings, Request
from nhc.study.linearization.units import Matrix

SPEC = """nhc: 1
system: sled
coordinates: [x, y, th, ph]
parameters: {m: 2, a: 0.3, I: 0.5, k: 40, l: 0.4, M: 0.5, spring: SPRING, slope: SLOPE}
define: {X: x + a*cos(th), Y: y + a*sin(th), A: X - l*cos(th + ph), B: Y - l*sin(th + ph)}
T: m/2*(X'^2 + Y'^2) + I/2*th'^2 + M/2*(A'^2 + B'^2)
V: k/2*ph^2 SPRUNG
constraints: ["-sin(th)*x' + cos(th)*y' = 0"]
quasi_velocities: {v: cos(th)*x' + sin(th)*y', w: th', s: ph'}
"""
SPRUNG = "+ spring/2*(x^2 + y^2) - m*9.81*sin(slope)*X"


def ask(spring: str, slope: str, request: Request, sprung: str = SPRUNG, formulation: str | None = None) -> Findings:
    text = SPEC.replace("SPRUNG", sprung).replace("SPRING", spring).replace("SLOPE", slope)
    return linearize(Source("s.yaml", text), request, Options(formulation=formulation))


@pytest.mark.sample(2)
@pytest.mark.parametrize("formulation", [None, "euler-lagrange", "multipliers"])
@pytest.mark.parametrize("speed", ["2", "-3"])
def test_what_is_zero_ties_nothing_down(speed: str, formulation: str | None) -> None:
    found = ask("0", "0", Request(f"v={speed}"), formulation=formulation)
    plain = ask("0", "0", Request(f"v={speed}"), "", formulation)
    assert not found.lost and found.absent == ("spring", "slope") and plain.absent == ()
    for one, other in zip(eigenvalues(found.linearisation), eigenvalues(plain.linearisation), strict=True):
        assert one == pytest.approx(other, rel=1e-9, abs=1e-9)


def test_a_value_that_is_set_counts() -> None:
    found = ask("4", "0", Request("v=2", settings=("spring=0",)))
    assert not found.lost and "spring" in found.absent
    assert ask("4", "0", Request("x=0")).absent == ()  # at rest on the spring


def test_what_is_swept_stays() -> None:
    found = ask("0", "0", Request("v=2", sweep=("spring", 0.0, 1.0, 3)))
    assert found.lost and found.absent == ()
    swept = ask("0", "0", Request("v=2", sweep=("slope", 0.0, 0.1, 3))).swept
    assert swept is not None and swept.values == (0.0,)  # on a slope the speed grows
    assert [value for value, _ in swept.missing] == [0.05, 0.1]
    found = ask("0", "0", Request("v=2", sweep=("k", 30.0, 50.0, 3)))
    assert not found.lost and found.absent == ("spring", "slope")


@pytest.mark.slow
def test_what_does_not_vanish_is_no_steady_motion() -> None:
    found = ask("1e-6", "0", Request("v=2"))
    assert found.lost and found.absent == ()


def test_it_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "s.yaml"
    spec.write_text(
        SPEC.replace("SPRUNG", SPRUNG).replace("SPRING", "0").replace("SLOPE", "1").replace("sin(slope)", "spring")
    )
    assert main(["linearize", str(spec), "--about", "v=2"]) == 0
    out = capsys.readouterr().out
    assert "`spring` is 0, and is left out of the equations: more is steady for this value" in out


@pytest.mark.slow
def test_stability_has_the_same_motion(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "s.yaml"
    text = SPEC.replace("SPRUNG", SPRUNG).replace("SPRING", "0").replace("SLOPE", "0")
    spec.write_text(f"{text}scenes: {{go: {{initial: {{v: 2, ph: 0.1, s: 0.2}}, time: [0, 2]}}}}\n")
    assert main(["stability", str(spec)]) == 0
    out = capsys.readouterr().out.split("eigenvalues along")[0]
    assert "v = 2" in out and "left out" in out and "spring, slope" in out


COIN = """nhc: 1
system: coin
coordinates: [x, y, yaw, lean, roll]
parameters: {m: 1, a: 0.5, A: 0.0625, C: 0.125, g: 9.81, alpha: ALPHA}
bodies:
  frame: {at: [x, y, a*cos(lean)], turns: [z: yaw, x: lean]}
  coin: {parent: frame, turns: [y: roll], mass: m, inertia: [A, C, A]}
points: {P: {parent: frame, of: coin, at: [0, 0, -a]}}
gravity: [g*sin(alpha), 0, -g*cos(alpha)]
constraints: [P_vx = 0, P_vy = 0]
"""


def test_a_family_that_what_is_zero_hides_is_one() -> None:
    """On a slope that is none a coin may head anywhere: no zero of it is left, and none hides where rolling becomes stable."""
    request = Request("roll'=1", sweep=("roll'", 1.0, 4.0, 4))
    found = linearize(Source("coin.yaml", COIN.replace("ALPHA", "0")), request, Options())
    assert found.absent == ("alpha",) and found.swept is not None
    grow = math.sqrt((1 * 9.81 * 0.5 - 0.125 * (0.125 + 0.25) / 0.0625) / (0.0625 + 0.25))
    assert sorted(x.real for x in eigenvalues(found.linearisation)) == pytest.approx([-grow, grow], rel=1e-9)
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(math.sqrt(0.0625 * 9.81 * 0.5 / (0.125 * (0.125 + 0.25))), rel=1e-9)


TANGLED = """nhc: 1
system: tangled
coordinates: [x, y]
parameters: {k: 1, c: 0.1}
T: (x'^2 + y'^2)/2
V: x^4/4 + k*y^2/2
forces: {y: -c*y'}
"""


@pytest.mark.parametrize("sweep", [("k", -1.1, 1.9, 4), ("k", -1.0, 1.0, 3)])
def test_zeros_that_stay_hide_no_crossing(sweep: tuple[str, float, float, int]) -> None:
    """x'' = -x^3 has two zeros whatever k is, at which y becomes stable: between two values of the sweep, or at one of them."""
    found = linearize(Source("tangled.yaml", TANGLED), Request("x=0", sweep=sweep), Options())
    assert found.swept is not None and found.swept.unlocated == ()
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(0.0, abs=1e-10) and not crossing.unstable_above


def test_a_change_without_a_crossing_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sweep_module._Static, "between", lambda *_: [])
    spec = tmp_path / "tangled.yaml"
    spec.write_text(f"{TANGLED}scenes: {{s: {{time: [0, 1]}}}}\n")
    assert main(["linearize", str(spec), "--about", "x=0", "--sweep", "k=-1.1:1.9:4"]) == 0
    assert "between -0.1 and 0.9: another number of eigenvalues grows" in capsys.readouterr().out


TOUCHED = """nhc: 1
system: touched
coordinates: [x]
parameters: {a: 1, c: 0.1}
T: x'^2/2
V: a^2*(a - 0.3)*x^2/2
forces: {x: -c*x'}
"""


@pytest.mark.parametrize(
    ("sweep", "values"),
    [
        (("a", -1.0, 1.0, 5), [0.3]),  # 0 is a value of the sweep, where an eigenvalue touches zero and turns back
        (("a", -1.0, 1.0, 4), [0.3]),  # and where it is none
        (("a", -1.0, 0.5, 6), [0.3]),
        (("a", 0.3, 1.0, 3), [0.3]),  # the crossing is an end of the sweep
        (("a", -0.5, 0.3, 5), [0.3]),
        (("a", -1.0, 0.0, 3), []),
    ],
)
def test_a_zero_that_is_touched_is_no_crossing(sweep: tuple[str, float, float, int], values: list[float]) -> None:
    found = linearize(Source("touched.yaml", TOUCHED), Request("x=0", sweep=sweep), Options())
    assert found.swept is not None and found.swept.unlocated == ()
    assert [c.value for c in found.swept.crossings] == pytest.approx(values, abs=1e-9)
    assert not any(c.unstable_above for c in found.swept.crossings)


MERGED = """nhc: 1
system: merged
coordinates: [x, y]
parameters: {a: 0.1}
T: (x'^2 + y'^2)/2
V: x^2/2*(a - 0.5)*(a - 0.5)*a*(a - 0.75) + y^2/2
forces: {x: y' - a*y, y: a*x - x'}
"""
APART = """nhc: 1
system: apart
coordinates: [x, y]
parameters: {c: 0.1}
T: (x'^2 + y'^2)/2 + 1.5*(x*y' - y*x')
V: -x^2/2 - y^2
forces: {x: -c*x', y: -c*y'}
"""


def test_growing_roots_that_merge_cross_nothing() -> None:
    """Two real ones become a pair at a = 0.1487, far from the axis; one passes zero at 0.1024."""
    found = linearize(Source("merged.yaml", MERGED), Request("x=0", sweep=("a", 0.05, 1.0, 5)), Options())
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    real = [value.real for value in np.linalg.eigvals(merged(crossing.value)) if abs(value) < 1e-6]
    assert crossing.kind == "an eigenvalue passes zero" and len(real) == 1


def merged(a: float) -> Matrix:
    k = (a - 0.5) ** 2 * a * (a - 0.75)
    return np.array([[0, 0, 1, 0], [0, 0, 0, 1], [-k, -a, 0, 1], [a, -1, -1, 0]])


@pytest.mark.sample(3)
@pytest.mark.parametrize("ends", [(-0.2, 0.2), (-0.2, 0.0), (0.0, 0.2)])
def test_two_pairs_that_cross_at_one_value_do_not_meet(ends: tuple[float, float]) -> None:
    found = linearize(Source("apart.yaml", APART), Request("x=0", sweep=("c", *ends, 5)), Options())
    assert found.swept is not None
    kinds = {(c.kind, round(c.frequency, 4)) for c in found.swept.crossings}
    assert kinds == {("a pair crosses the axis", 2.3761), ("a pair crosses the axis", 0.5952)}
    assert [c.value for c in found.swept.crossings] == [0.0, 0.0]


DAMPED = """nhc: 1
system: damped
coordinates: [x]
parameters: {c: 0.1}
T: x'^2/2
V: x^2/2
forces: {x: -FORCE*x'}
"""


@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("force", "sweep", "expected"),
    [
        ("c", (0.0, 1.0, 5), [(0.0, False)]),
        ("c", (-1.0, 0.0, 5), [(0.0, False)]),
        ("(c - 0.3)", (0.3, 1.0, 3), [(0.3, False)]),
        ("(0.3 - c)", (0.3, 1.0, 3), [(0.3, True)]),
        ("c*(1 + c^2)", (0.0, 1.0, 5), [(0.0, False)]),
        ("c^2", (0.0, 1.0, 5), []),  # it is only touched
        ("c^2", (-1.0, 0.0, 5), []),
        *(("(-c^2)", ends, []) for ends in ((0.0, 1.0, 5), (-1.0, 0.0, 5), (-1.0, 1.0, 5), (-1.0, 1.0, 4))),
        ("c", (1e-3, 1.0, 5), []),
        ("c*0", (0.0, 1.0, 5), []),
    ],
)
def test_a_pair_that_crosses_at_an_end_is_named_once(
    force: str, sweep: tuple[float, float, int], expected: list[tuple[float, bool]]
) -> None:
    text = DAMPED.replace("FORCE", force)
    found = linearize(Source("damped.yaml", text), Request("x=0", sweep=("c", *sweep)), Options())
    assert found.swept is not None and found.swept.unlocated == ()
    told = found.swept.crossings
    assert [one.value for one in told] == pytest.approx([value for value, _ in expected], abs=1e-9)
    assert [(one.kind, one.unstable_above) for one in told] == [
        ("a pair crosses the axis", above) for _, above in expected
    ]


BRAKED = """nhc: 1
system: braked
coordinates: [x, y, th]
parameters: {m: 2, a: 0.3, I: 0.5, c: 0}
T: m/2*((x' - a*sin(th)*th')^2 + (y' + a*cos(th)*th')^2) + I/2*th'^2
constraints: ["-sin(th)*x' + cos(th)*y' = 0"]
quasi_velocities: {v: cos(th)*x' + sin(th)*y', w: th'}
forces: {v: -c*v}
scenes: {ahead: {initial: {x: 0, y: 0, th: 0, v: 2, w: 0}, time: [0, 1]}}
"""


@pytest.mark.slow
def test_a_sweep_that_comes_to_rest_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "braked.yaml"
    spec.write_text(BRAKED)
    assert main(["linearize", str(spec), "--sweep", "c=0:1:5"]) == 0
    assert "first at 0.25: v = 2 has become 0" in capsys.readouterr().out
    assert main(["stability", str(spec), "--sweep", "c=0:1:5"]) == 0
    assert "first at 0.25  not the motion asked about  v = 2 has become 0" in capsys.readouterr().out
    assert main(["linearize", str(spec), "--sweep", "v=0:1:5"]) == 0  # what is swept goes where it is sent
    assert "has become" not in capsys.readouterr().out
