"""How good a coframe is at a place: closed forms of |det| over the lengths of its rows."""

from __future__ import annotations

import math
from statistics import median

import pytest

from nhc.algebra.graph import Node
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import build
from nhc.mechanics.choosing.conditioning import conditioning, find_start, is_mass_sound
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System

HEAD = "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\n"


def make(text: str) -> System:
    return resolve(decode(Source("s.yaml", HEAD + text)))


def at(system: System, **values: float) -> dict[Node, float]:
    place = dict.fromkeys((*system.q, *system.v, system.t), 0.0)
    return place | {system.q[system.q_names.index(name)]: value for name, value in values.items()}


@pytest.mark.parametrize("angle", (0.0, 0.3, 1.2, math.pi / 2, -2.5))
def test_the_sine_of_the_angle_between_two_rows(angle: float) -> None:
    """cos(z) x' + sin(z) y' = 0 beside u = y' and w = z': the determinant is cos(z), all rows have length 1."""
    system = make("constraints: [c: cos(z)*x' + sin(z)*y' = 0]\nquasi_velocities: {u: y', w: z'}\n")
    found = conditioning(system, build(system, "euler-lagrange"), at(system, z=angle))
    assert found == pytest.approx(abs(math.cos(angle)), abs=1e-15)


def test_the_root_of_as_many_constraints() -> None:
    """Two rows with an angle z to the directions that are left: the determinant cos(z)^2, and its square root."""
    rows = "constraints: [a: cos(z)*x' + sin(z)*z' = 0, b: cos(z)*y' + sin(z)*z' = 0]\nquasi_velocities: {w: z'}\n"
    system = make(rows)
    found = conditioning(system, build(system, "euler-lagrange"), at(system, z=0.7))
    assert found == pytest.approx(math.cos(0.7), rel=1e-14)


def test_a_free_form_that_vanishes_is_no_good_one() -> None:
    """u = x y' has the length |x|: as good as any where that is usual or more, and worth its part of that where it is less."""
    system = make("constraints: [c: x' - z' = 0]\nquasi_velocities: {u: x*y', w: z' + x'}\n")
    formulation = build(system, "euler-lagrange")
    usual = median(abs(point[system.q[0]]) for point in trial_points(system))
    for x in (1e-9, 1e-4, 0.01 * usual, 0.5 * usual):
        assert conditioning(system, formulation, at(system, x=x)) == pytest.approx(x / usual, rel=1e-9)
    for x in (2 * usual, 100 * usual):
        assert conditioning(system, formulation, at(system, x=x)) == pytest.approx(1.0, rel=1e-14)
    assert conditioning(system, formulation, at(system, x=0.0)) == 0.0


def test_the_mass_near_the_centre_of_polar_coordinates() -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nT: (x'^2 + x^2*y'^2)/2\n"
    system = resolve(decode(Source("s.yaml", text)))
    formulation = build(system, "lagrange")
    assert is_mass_sound(system, formulation, at(system, x=1.0))
    assert not is_mass_sound(system, formulation, at(system, x=1e-3))
    coupled = resolve(decode(Source("s.yaml", text.replace("x^2*y'^2", "y'^2 + 2*sin(x)*x'*y'"))))
    formulation = build(coupled, "lagrange")  # the eigenvalues 1 -+ sin(x)
    assert is_mass_sound(coupled, formulation, at(coupled, x=1.4))
    assert not is_mass_sound(coupled, formulation, at(coupled, x=1.5))


CONE = """
nhc: 1
system: ball_in_a_cone
coordinates: {r: {range: [0.1, 3]}, phi: {}}
rotation: {R: {velocities: [wx, wy, wz], frame: space}}
parameters: {a: 1, g: 9.81}
define:
  wn: -(wx*cos(phi) + wy*sin(phi))*cos(0.7) + wz*sin(0.7)
  we: (wx*cos(phi) + wy*sin(phi))*sin(0.7) + wz*cos(0.7)
  wt: -wx*sin(phi) + wy*cos(phi)
T: (r'^2/sin(0.7)^2 + r^2*phi'^2)/2 + a^2/5*(wx^2 + wy^2 + wz^2)
V: g*r/tan(0.7)
constraints: [up: r'/sin(0.7) - a*wt = 0, round: r*phi' + a*we = 0]
quasi_velocities: {u: r', w: phi', s: wn}
scenes: {circle: {parameters: {a: 1}, initial: {r: 1, w: 3, s: 0}, time: [0, 10]}}
"""


@pytest.mark.parametrize("size", ("1", "0.3", "0.1", "0.03", "1e-3"))
def test_a_small_ball_on_a_large_cone_is_no_singular_choice(size: str) -> None:
    system = resolve(decode(Source("cone.yaml", CONE.replace("a: 1", f"a: {size}"))))
    start = start_of(system, system.spec.scenes[0])
    assert find_start(system, build(system, "euler-lagrange"), start) is None


def test_where_the_way_around_has_no_length_another_choice_is_found() -> None:
    """With the turn about the wall as a free velocity, phi' is that times a/r: near the axis it is another one."""
    text = CONE.replace("a: 1", "a: 0.1").replace("w: phi'", "w: we").replace("{r: 1, w: 3", "{r: 1e-6, w: 0")
    system = resolve(decode(Source("cone.yaml", text)))
    start = start_of(system, system.spec.scenes[0])
    found = find_start(system, build(system, "euler-lagrange"), start)
    assert found is not None and "singular or nearly so" in found.reason
