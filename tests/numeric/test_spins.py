"""Balls that roll on surfaces, by the rates of their places and the spin about the normal."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.added_forms import describe_added
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.choosing.spins import spins
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.pipeline import derive
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.numeric.test_squares import operations, program_of

# the coordinates, the place of the centre, the normal, two rows of rolling (t: around the z axis, d: down from it), and a start
BAD = Path(__file__).resolve().parents[1] / "bad" / "mechanics"
SURFACES = {
    "cone": (
        "s, phi",
        ("s*sin(al)*cos(phi)", "s*sin(al)*sin(phi)", "s*cos(al)"),
        ("-cos(al)*cos(phi)", "-cos(al)*sin(phi)", "sin(al)"),
        "xy",
        "s: 1, phi': 1",
    ),
    "bowl": (
        "th, phi",
        ("b*sin(th)*cos(phi)", "b*sin(th)*sin(phi)", "-b*cos(th)"),
        ("-sin(th)*cos(phi)", "-sin(th)*sin(phi)", "cos(th)"),
        "xy",
        "th: 1, phi': 1",
    ),
    "pipe": (
        "phi, z",
        ("b*cos(phi)", "b*sin(phi)", "z"),
        ("-cos(phi)", "-sin(phi)", "0"),
        "tz",
        "z: 1, phi': 2",
    ),
    "dome": (  # along tangents, where sines and cosines have to be seen to cancel
        "th, phi",
        ("b*sin(th)*cos(phi)", "b*sin(th)*sin(phi)", "b*cos(th)"),
        ("sin(th)*cos(phi)", "sin(th)*sin(phi)", "cos(th)"),
        "dt",
        "th: 0.5, phi': 1",
    ),
    "trough": (
        "phi, x",
        ("x", "b*sin(phi)", "-b*cos(phi)"),
        ("0", "-sin(phi)", "cos(phi)"),
        "xy",
        "x: 1, phi: 0.3, x': 1",
    ),
    "slope": (
        "x, y",
        ("x*cos(al)", "y", "x*sin(al) + a"),
        ("-sin(al)", "0", "cos(al)"),
        "xy",
        "x: 1, y': 1",
    ),
}
MOST = {"cone": 67, "bowl": 82, "pipe": 52, "dome": 71, "trough": 53, "slope": 39}
"""Operations; with the angular velocity in the state they are 113, 145, 64, 142, 67 and 47."""
NORMALS = {
    "cone": "cos(phi)*cos(al)*wx + sin(phi)*cos(al)*wy - sin(al)*wz",
    "bowl": "sin(th)*cos(phi)*wx + sin(th)*sin(phi)*wy - cos(th)*wz",
    "pipe": "cos(phi)*wx + sin(phi)*wy",
    "dome": "sin(th)*cos(phi)*wx + sin(th)*sin(phi)*wy + cos(th)*wz",
    "trough": "cos(phi)*wz - sin(phi)*wy",
    "slope": "cos(al)*wz - sin(al)*wx",
}


def text_of(name: str, *, body: bool = False) -> str:
    coordinates, place, normal, rows, start = SURFACES[name]
    entries = [[f"R_{axis}{k}*{w}" for k, w in enumerate(("wx", "wy", "wz"), 1)] for axis in "xyz"]
    x, y, z = (f"({' + '.join(row)})" for row in entries) if body else ("wx", "wy", "wz")
    on_x, on_y, on_z = f"px' - a*({y}*nz - {z}*ny)", f"py' - a*({z}*nx - {x}*nz)", f"pz' - a*({x}*ny - {y}*nx)"
    rolling = {
        "x": on_x,
        "y": on_y,
        "z": on_z,
        "t": f"cos(phi)*({on_y}) - sin(phi)*({on_x})",
        "d": f"cos(th)*(cos(phi)*({on_x}) + sin(phi)*({on_y})) - sin(th)*({on_z})",
    }
    named = "".join(
        f"  {kind}{axis}: {value}\n"
        for kind, values in (("p", place), ("n", normal))
        for axis, value in zip("xyz", values, strict=True)
    )
    return f"""nhc: 1
system: {name}
coordinates: [{coordinates}]
rotation: {{R: {{velocities: [wx, wy, wz]{"" if body else ", frame: space"}}}}}
parameters: {{m: 1.2, a: 0.1, k: 0.4, g: 9.81, b: 1.1, al: 0.7, c: 0.02}}
define:
{named}T: m/2*(px'^2 + py'^2 + pz'^2) + k*m*a^2/2*(wx^2 + wy^2 + wz^2)
V: m*g*pz
constraints:
{"".join(f"  - {rolling[axis]} = 0" + chr(10) for axis in rows)}scenes:
  go: {{initial: {{{start}}}, time: [0, 3]}}
"""


def system_of(text: str) -> System:
    return resolve(decode(Source("ball.yaml", text)))


@pytest.mark.parametrize("name", SURFACES)
def test_the_spin_about_the_normal_stands_beside_the_rates_of_the_place(name: str) -> None:
    system = system_of(text_of(name))
    formulation = formulate(system)
    kept = [form.name for form in kept_forms(system, formulation.frame)]
    assert kept == ["v", *system.q_names[:2]]
    assert describe_added(system, formulation.frame) == {"v": NORMALS[name]}
    mass = equations_of(system, formulation).mass
    assert all(entry == system.graph.zero for k, row in enumerate(mass) for entry in row[:k])
    assert operations(program_of(system)) <= MOST[name]


@pytest.mark.parametrize("name", SURFACES)
def test_formulations_agree(name: str) -> None:
    assert certify(system_of(text_of(name))).holds


def test_in_a_pipe_it_comes_up_again() -> None:
    """z'' = -(k w^2 (z - z0) + g)/(1 + k) with the rate w of the angle, which is constant, and z0 from the spin: a solid ball
    swings sqrt(2/7) times in a turn (M. Gualtieri and others, Golfer's dilemma, Am. J. Phys. 74 (2006) 497).
    """
    job = open_scene(Source("ball.yaml", text_of("pipe")), needs=("z", "phi"))
    found = run(job, Settings(points=61, tolerance=1e-11))
    start, k, g, w = found.rows[0], 0.4, 9.81, 2.0
    rate = w * math.sqrt(k / (1 + k))
    # the spin, zero at the start, changes by w (z(0) - z)/a, and in the middle of the swing it pulls as the weight does
    centre = start[0] - g / (k * w**2)
    for t, row in zip(found.times, found.rows, strict=True):
        assert row[0] == pytest.approx(centre + (start[0] - centre) * math.cos(rate * t), abs=1e-7)
        assert row[1] == pytest.approx(w * t, abs=1e-7)


def test_where_it_sees_how_the_ball_has_turned_there_is_none() -> None:
    """On the ball's own axes the normal turns with it: there the angular velocity is kept."""
    system = system_of(text_of("bowl", body=True))
    assert spins(system) == []
    assert [form.name for form in kept_forms(system, formulate(system).frame)] == ["wx", "wy", "wz"]


def test_a_velocity_of_the_spec_s_own_is_not_taken_for_its_name() -> None:
    text = text_of("trough").replace("wx", "u").replace("wy", "v").replace("wz", "w")
    system = system_of(text)
    kept = [form.name for form in kept_forms(system, formulate(system).frame)]
    assert kept == ["v2", "phi", "x"]


def test_no_velocities_are_taken_that_fail_where_the_others_did_not() -> None:
    """Of a ball on a ball X', Y' and the rates of the contact's angles leave no digits at the equator; angular velocities do."""
    system = system_of((BAD / "quasi_at_the_pole.yaml").read_text(encoding="utf-8"))
    assert [form.name for form in kept_forms(system, formulate(system).frame)] == ["a1", "a2", "a3", "b1", "b2", "b3"]


def test_a_velocity_of_the_spec_s_own_comes_first_and_is_not_called_added() -> None:
    system = system_of(text_of("cone").replace("T: ", 'quasi_velocities: {us: "s\'"}\nT: ', 1))
    formulation = formulate(system)
    assert [form.name for form in kept_forms(system, formulation.frame)] == ["us", "v", "phi"]
    assert formulation.added == ("v", "phi'")


def test_a_derivation_says_what_the_spin_is_made_of() -> None:
    """Its form is written in the rates of the quaternion, since the angular velocities are not part of the coframe."""
    shown = derive(Source("ball.yaml", text_of("cone")))
    (line,) = (line for line in shown.splitlines() if line.startswith("  v = "))
    assert line == "  v = cos(phi)*cos(al) wx + sin(phi)*cos(al) wy - sin(al) wz"
