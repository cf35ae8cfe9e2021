"""What was given of a steady motion is kept, and a run needs no orientation: balls that roll around in a cylinder and in a bowl."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, linearize
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Findings, Request
from tests.numeric.test_spins import text_of

CYLINDER = """
nhc: 1
system: sphere_in_cylinder
coordinates: [phi, z]
rotation: {R: {velocities: [p, q, r], frame: space}}
parameters: {m: 1, a: 0.1, b: 0.5, g: 9.81}
define: {d: b - a, X: d*cos(phi), Y: d*sin(phi)}
T: m/2*(X'^2 + Y'^2 + z'^2) + m*a^2/5*(p^2 + q^2 + r^2)
V: m*g*z
constraints:
  - along: d*phi' + a*r = 0
  - up: z' + a*(p*sin(phi) - q*cos(phi)) = 0
scenes:
  drop: {initial: {phi': 6, p: 1}, time: [0, 6]}
"""
BOWL = """
nhc: 1
system: ball_in_bowl
coordinates: {rho: {range: [0.05, 3]}, phi: {}}
rotation: {Q: {velocities: [p, q, r], frame: space}}
parameters: {m: 1, a: 0.1, k: 1, g: 9.81}
define:
  X: rho*cos(phi)
  Y: rho*sin(phi)
  Z: k*rho^2/2
  N: sqrt(1 + k^2*rho^2)
  nx: -k*rho*cos(phi)/N
  ny: -k*rho*sin(phi)/N
  nz: 1/N
T: m/2*(X'^2 + Y'^2 + Z'^2) + m*a^2/5*(p^2 + q^2 + r^2)
V: m*g*Z
constraints:
  - cx: X' - a*(q*nz - r*ny) = 0
  - cy: Y' - a*(r*nx - p*nz) = 0
"""


def find(text: str, about: str, *holds: str) -> Findings:
    return linearize(Source("spec.yaml", text), Request(about, holds=holds), Options())


@pytest.mark.parametrize(("about", "holds"), [("drop", ()), ("drop", ("phi'",)), ("phi'=6, p=1", ()), ("phi'=6", ())])
def test_a_ball_goes_around_a_cylinder_as_fast_as_was_said(about: str, holds: tuple[str, ...]) -> None:
    """Gravity is held by the spin v = -5 g/(2 a phi') about the normal; up and down at sqrt(2/7) phi' (Neimark and Fufaev)."""
    found = find(CYLINDER, about, *holds).linearisation
    _phi, z, *_, v, around, up = found.steady.y
    assert (v, around) == pytest.approx((-5 * 9.81 / (2 * 0.1 * 6), 6), rel=1e-9)
    assert z == up == 0.0
    assert max(value.imag for value in eigenvalues(found)) == pytest.approx(6 * math.sqrt(2 / 7), rel=1e-6)


@pytest.mark.slow
def test_all_that_was_given_stays_where_there_is_such_a_motion() -> None:
    """The radius, too, and nothing of the search's rounding is left in what it should not have moved."""
    rho, *rest = find(BOWL, "rho=1, phi'=2.6").linearisation.steady.y
    assert rho == 1.0
    assert rest[:5] == [0.0, 1.0, 0.0, 0.0, 0.0] and rest[6] == 0.0
    model = find(BOWL, "rho=1, phi'=2.6")
    assert model.linearisation.steady.turning is not None and not model.lost


def test_a_rate_of_what_stays_was_a_disturbance() -> None:
    """A ball goes around in a cone at any distance from its tip, if its spin is right: the distance that was given is kept."""
    plain, disturbed = (find(text_of("cone"), about) for about in ("s=1, phi'=2", "s=1, s'=0.05, phi'=2"))
    for found in (plain, disturbed):
        s, *_, spin, away, around = found.linearisation.steady.y
        assert (s, around) == (1.0, 2.0) and abs(away) < 1e-15
        assert spin == pytest.approx(plain.linearisation.steady.y[-3], rel=1e-9)
    assert not plain.lost and any("s'" in text for text in disturbed.lost)


def test_an_orientation_that_nothing_needs_is_not_integrated() -> None:
    """Though its quaternion has a length to hold; where it is needed all of the state is there."""
    short = open_scene(Source("spec.yaml", CYLINDER.replace("6]", "6], need: [phi, z, energy]")), "drop")
    whole = open_scene(Source("spec.yaml", CYLINDER.replace("6]", "6], need: [phi, z, energy, R_0]")), "drop")
    assert len(short.y) == 3 and len(whole.y) == 9
    rows = [run(job, Settings(tolerance=1e-11)) for job in (short, whole)]
    assert rows[0].rows[-1] == pytest.approx(rows[1].rows[-1][:3], rel=1e-8)
    assert rows[0].outcome.calls < rows[1].outcome.calls / 2
