"""Steady motions that are roots of a higher order: alone, and undecided to first order; and forces that only fade away.

A particle in the plane, x'' = -dV/dx - c x' and y'' = -2 y - c y', so that everything is known: where dV/dx has a double or triple
root the zero of the matrix belongs to no family, and a damped particle leaves the double one.
"""

from __future__ import annotations

import math

import pytest

from nhc.language import Source
from nhc.pipeline import Options, linearize
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import eigenvalues, verdict
from nhc.study.linearization.motion import Findings, Request

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
        ("x^6", 0.0),
        ("(x - 1/3)^6", 1 / 3),
    ],
)
def test_a_root_of_higher_order_is_no_family(potential: str, root: float) -> None:
    made = find(potential, "x=0.7, y=0.1").linearisation
    assert made.steady.y[0] == pytest.approx(root, abs=1e-8)
    assert (made.family, made.zeros, verdict(made)) == (0, 1, "marginal")
    slow = [x for x in eigenvalues(made) if abs(x) < 1e-6]
    assert len(slow) == 1 and len(eigenvalues(made)) == 4


HOOP = """\
nhc: 1
system: hoop
coordinates: [th]
parameters: {m: 1, R: 0.5, g: 9.81, Om: 1, c: 0.3}
T: m*R^2/2*(th'^2 + sin(th)^2*Om^2)
V: -m*g*R*cos(th)
forces: {th: -c*th'}
"""


@pytest.mark.parametrize("start", [0.4, -0.9, 1.3])
def test_a_bead_on_a_hoop_at_its_critical_speed_is_undecided(start: float) -> None:
    """Three equilibria meet at th = 0.  Doubles end the search at 7e-6, where the matrix is that of something stable."""
    text = HOOP.replace("Om: 1", "Om: sqrt(9.81/0.5)") if start > 1.0 else HOOP
    request = Request(f"th={start}", () if start > 1.0 else ("Om=sqrt(9.81/0.5)",), (), None)
    made = linearize(Source("hoop.yaml", text), request, Options()).linearisation
    assert abs(made.steady.y[0]) < 1e-7 and verdict(made) == "marginal"
    assert eigenvalues(made) == [0.0, pytest.approx(-1.2)]


@pytest.mark.parametrize(
    ("off", "told"), [(1e-6, "stable"), (-1e-6, "stable"), (1e-15, "marginal"), (-1e-15, "marginal")]
)
def test_beside_the_critical_speed_it_is_decided_where_the_digits_tell(off: float, told: str) -> None:
    """The slow eigenvalue is d/1.2 below it and -2 d/1.2 above it, with d = Om^2 - g/R, in the limit."""
    made = linearize(
        Source("hoop.yaml", HOOP), Request("th=0.4", (f"Om=sqrt(9.81/0.5)*(1 + {off})",), (), None), Options()
    ).linearisation
    assert verdict(made) == told
    away = 2 * off * 19.62
    expected = (-2 * away if away > 0 else away) / 1.2 if told == "stable" else 0.0
    assert eigenvalues(made)[0].real == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(
    ("potential", "told"),
    [("x^3/3 - x*(k - 0.9999999)", "stable"), ("x^3/3 - x*(k - 2*c*(1 - 1e-15))", "marginal")],
)
def test_a_fold_that_the_parameters_decide(potential: str, told: str) -> None:
    """Its two equilibria lie sqrt(1e-7) off; or so near one another that the rounding of k may join them."""
    made = find(potential, "x=0.4").linearisation
    assert verdict(made) == told and (told == "marginal" or made.steady.y[0] == pytest.approx(1e-7**0.5, rel=1e-8))


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
