"""Motions that are steady because parameters are 0: a spring to the ground, a slope."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.cli import main
from nhc.diagnostics import Source
from nhc.pipeline import Options, linearize
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Findings, Request

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
    with pytest.raises(NotSteady, match=r"^at 0\.05: "):  # on a slope the speed grows
        ask("0", "0", Request("v=2", sweep=("slope", 0.0, 0.1, 3)))
    found = ask("0", "0", Request("v=2", sweep=("k", 30.0, 50.0, 3)))
    assert not found.lost and found.absent == ("spring", "slope")


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
    assert "steady for these values of the parameters alone: `spring` is 0, and is left out of the equations" in out


def test_stability_has_the_same_motion(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "s.yaml"
    text = SPEC.replace("SPRUNG", SPRUNG).replace("SPRING", "0").replace("SLOPE", "0")
    spec.write_text(f"{text}scenes: {{go: {{initial: {{v: 2, ph: 0.1, s: 0.2}}, time: [0, 2]}}}}\n")
    assert main(["stability", str(spec)]) == 0
    out = capsys.readouterr().out.split("eigenvalues along")[0]
    assert "v = 2" in out and "left out" in out and "spring, slope" in out
