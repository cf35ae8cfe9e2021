"""Steady motions that are roots of a higher order: alone, and undecided to first order; and forces that only fade away.

A particle in the plane, x'' = -dV/dx - c x' and y'' = -2 y - c y', so that everything is known: where dV/dx has a double or triple
root the zero of the matrix belongs to no family, and a damped particle leaves the double one.
"""

from __future__ import annotations

import math

import pytest

from nhc.language import Source
from nhc.pipeline import Options, linearize
from nhc.study.linearize import eigenvalues, verdict
from nhc.study.motion import Findings, Request
from nhc.study.steady import NotSteady

SPEC = """\
nhc: 1
system: particle
coordinates: [x, y]
parameters: {{c: 0.5, k: 1}}
T: (x'^2 + y'^2)/2
V: {potential} + y^2
forces: {{x: -c*x', y: -c*y'}}
"""


def find(potential: str, about: str) -> Findings:
    return linearize(Source("particle.yaml", SPEC.format(potential=potential)), Request(about, (), (), None), Options())


@pytest.mark.parametrize(
    ("potential", "root"),
    [
        ("x^3", 0.0),
        ("-x^3/3", 0.0),
        ("(x - 1/3)^3", 1 / 3),
        ("sin(x) - x", 0.0),
        ("(x - 1)^4", 1.0),
        ("exp(x) - x - x^2/2", 0.0),
        ("(1 - k)*x^2/2 + x^4/4", 0.0),  # a pitchfork at its threshold
    ],
)
def test_a_root_of_higher_order_is_no_family(potential: str, root: float) -> None:
    made = find(potential, "x=0.7, y=0.1").linearisation
    assert made.steady.y[0] == pytest.approx(root, abs=1e-4)
    assert made.family == 0 and verdict(made) != "unstable"
    if abs(made.steady.y[0] - root) < 1e-6:
        assert made.zeros == 1 and verdict(made) == "marginal"
    slow = [x for x in eigenvalues(made) if abs(x) < 1e-6]
    assert len(slow) == 1 and len(eigenvalues(made)) == 4


def test_a_family_beside_a_root_of_higher_order_counts_alone() -> None:
    """Any speed y' goes with x = 0, a double root at each of them."""
    text = (
        "nhc: 1\nsystem: s\ncoordinates: [x, y]\nparameters: {c: 0.5}\nT: (x'^2 + y'^2)/2\nV: x^3\nforces: {x: -c*x'}\n"
    )
    made = linearize(Source("s.yaml", text), Request("x=0.1, y'=1", (), (), None), Options()).linearisation
    assert (made.zeros, made.family, verdict(made)) == (2, 1, "marginal")


def test_a_valley_is_a_family() -> None:
    valley = find("(x - y^2)^2 - y^2", "x=1, y=0.9").linearisation  # V = (x - y^2)^2 in all
    assert valley.family == 1 and verdict(valley) == "stable"


@pytest.mark.parametrize("potential", ["exp(-x^2)", "tanh(x)", "exp(-x)", "1/x", "atan(x)"])
def test_a_force_that_fades_away_has_no_equilibrium(potential: str) -> None:
    with pytest.raises(NotSteady):
        find(potential, "x=1, y=0.1")


def test_the_top_of_the_hill_is_one() -> None:
    made = find("exp(-x^2)", "x=0.3").linearisation
    slope = (-0.5 + math.sqrt(0.25 + 8.0)) / 2.0  # s^2 + c s - 2 = 0
    assert made.steady.y[0] == pytest.approx(0.0, abs=1e-12) and made.family == 0
    assert max(x.real for x in eigenvalues(made)) == pytest.approx(slope, rel=1e-12)
