"""Balls whose angular velocity is on their own axes: solved for in space with the same rates, in fewer operations."""

from __future__ import annotations

import random
import re

import pytest

from benchmarks.systems import spec
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.solving.sizes import size_of
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.in_space import find_in_space
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.rotations.other_axes import turn_omega
from nhc.program.planning.planner import Planner
from tests.numeric.test_detours import assert_slopes, module_of
from tests.numeric.test_spins import SURFACES, text_of
from tests.numeric.test_squares import operations, program_of
from tests.property.test_rules import transplant

HEAD = (
    "nhc: 1\nsystem: s\nparameters: {m: 1.3, a: 0.2, b: 0.3, R: 1, J: 0.05, K: 0.07, g: 9.81, W: 0.7, k: 0.1, h: 0.4}\n"
)
BALL = "bodies: {ball: {at: [x, y, a], rotation: B, mass: m, inertia: J}}\npoints: {c: {of: ball, at: [x, y, 0]}}\n"
PLANE = f"{HEAD}coordinates: [x, y]\nrotation: {{B: {{velocities: [p, q, r]}}}}\n{BALL}"
ROLLING = "constraints: [c_vx = 0, c_vy = 0]\n"
ON_BALL = """coordinates: [x, y, u, v]
rotation: {B: {velocities: [p, q, r]}, C: {velocities: [i, j, l]}}
define: {n1: sin(u)*cos(v), n2: sin(v), n3: cos(u)*cos(v)}
bodies:
  low: {at: [x, y, a], rotation: B, mass: m, inertia: J}
  high: {at: [x + (a + b)*n1, y + (a + b)*n2, a + (a + b)*n3], rotation: C, mass: m/2, inertia: K}
gravity: [0, 0, -g]
points:
  foot: {of: low, at: [x, y, 0]}
  top: {of: low, at: [x + a*n1, y + a*n2, a + a*n3]}
  under: {of: high, at: [x + a*n1, y + a*n2, a + a*n3]}
constraints:
  - foot_vx = 0
  - foot_vy = 0
  - (top_vx - under_vx)*cos(u) - (top_vz - under_vz)*sin(u) = 0
  - (top_vy - under_vy)*cos(v) - sin(v)*((top_vx - under_vx)*sin(u) + (top_vz - under_vz)*cos(u)) = 0
"""
SYSTEMS = {
    "turntable": f"{PLANE}constraints: [c_vx = -W*y, c_vy = W*x]\n",
    "table that speeds up": f"{PLANE}constraints: [c_vx = -W*t*y, c_vy = W*t*x]\n",
    "friction and springs": f"{PLANE}{ROLLING}V: k*x^2 + k*B_z3\nforces: {{p: -k*p, q: -k*q, r: -k*r, x: -k*x'}}\n",
    "torques on the body": f"{PLANE}{ROLLING}forces: {{p: h, r: -k*r^3}}\n",
    "rolling": f"{PLANE}{ROLLING}",
    "slipping": f"{PLANE}forces: {{c_vx: -k*c_vx, c_vy: -k*c_vy}}\n",
    "ball on ball": HEAD + ON_BALL,
    "one of two": f"{HEAD}{ON_BALL}".replace("inertia: K", "inertia: [K, J, K]"),
    "in a bowl": text_of("bowl", body=True),
    "in a cone": text_of("cone", body=True).replace(
        "scenes", "forces: {wx: -c*wx, wy: -c*wy, wz: -c*wz, s: c*sin(t)}\nscenes"
    ),
}
"""Those that are brought to the axes of space, wholly or in part."""


def by_spin(name: str, *, body: bool) -> str:
    """A ball on a surface whose state is the spin about the normal and the rates of the place: nothing on the ball's own axes."""
    text, spin = text_of(name, body=body), "nx*{x} + ny*{y} + nz*{z}"
    rows = {axis: f"(R_{axis}1*wx + R_{axis}2*wy + R_{axis}3*wz)" if body else f"w{axis}" for axis in "xyz"}
    first, second = SURFACES[name][0].split(", ")
    quasi = f"quasi_velocities: {{vn: {spin.format(**rows)}, u1: {first}', u2: {second}'}}"
    return text.replace("scenes:", f"forces: {{{first}: -c*{first}'}}\n{quasi}\nscenes:")


def rates(text: str, graph: Graph) -> list[Node]:
    made = resolve(decode(Source("s.yaml", text)), graph)
    formulation = formulate(made)
    return [target.node for target in Planner(equations_of(made, formulation), formulation).rhs().targets]


def is_found(text: str) -> bool:
    made = resolve(decode(Source("s.yaml", text)))
    formulation = formulate(made)
    return bool(find_in_space(equations_of(made, formulation), kept_forms(made, formulation.frame)))


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_the_rates_are_the_same(name: str) -> None:
    text, with_all, without = SYSTEMS[name], Graph(), WithoutRules(["spherical tops"])
    short, long = rates(text, with_all), rates(text, without)
    assert are_equal(without, transplant(short, with_all, without), long)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_the_jacobian_is_that_of_the_rates(name: str) -> None:
    source = Source("s.yaml", SYSTEMS[name])
    assert_slopes(module_of(source), module_of(source, ("spherical tops",)), name)


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_is_found(name: str) -> None:
    """A torque that turns with the ball would bring the orientation back."""
    assert is_found(SYSTEMS[name]) == (name != "torques on the body")


@pytest.mark.parametrize(
    "change",
    [
        ("inertia: J", "inertia: [J, J, K]"),
        ("inertia: J", "inertia: J, centre: [0, 0, h]"),
        ("velocities: [p, q, r]", "velocities: [p, q, r], frame: space"),
        ("constraints", 'quasi_velocities: {vx: "x\'"}\nconstraints'),
        ("constraints", "T: h*r\nconstraints"),
    ],
)
def test_what_is_no_spherical_top_is_left_alone(change: tuple[str, str]) -> None:
    """Other moments, a centre of mass elsewhere, a rotor, velocities in space, or not all of omega kept."""
    text = f"{PLANE}{ROLLING}".replace(*change)
    assert text != f"{PLANE}{ROLLING}"
    assert not is_found(text)


@pytest.mark.parametrize(("name", "most"), [("in a bowl", 190), ("in a cone", 213)])
def test_by_way_of_the_spin_about_the_normal(name: str, most: int) -> None:
    """The state is what the spec has, on the ball's own axes; by omega in space it would be 232 operations, with friction 229."""
    system = resolve(decode(Source("s.yaml", SYSTEMS[name])))
    formulation = formulate(system)
    found = find_in_space(equations_of(system, formulation), kept_forms(system, formulation.frame))
    assert found[1].frame.forms[system.l].name == "v"
    assert operations(program_of(system)) <= most


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SURFACES)
def test_on_which_axes_omega_is_does_not_matter_where_it_is_not_kept(name: str) -> None:
    """The same operations, and the same rates as without the rules, where rows with the orientation are solved."""
    text, off = by_spin(name, body=True), ("spherical tops", "other axes")
    with_all, without = Graph(), WithoutRules(off)
    assert are_equal(without, transplant(rates(text, with_all), with_all, without), rates(text, without))
    counts = [operations(program_of(resolve(decode(Source("s.yaml", by_spin(name, body=k)))))) for k in (True, False)]
    assert counts[0] <= counts[1] + 1
    source = Source("s.yaml", text)
    assert_slopes(module_of(source), module_of(source, off), name)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SURFACES)
def test_what_else_is_emitted_for_it(name: str) -> None:
    """The energy, velocities, accelerations and reactions at random states, as without the rules."""
    source = Source("s.yaml", by_spin(name, body=True))
    short, long = (module_of(source, off, only=()) for off in ((), ("spherical tops", "other axes")))
    rng = random.Random(name)
    for _ in range(3):
        y = [rng.uniform(0.3, 1.2) for _ in short.STATE]
        for function in ("energy", "velocities", "accelerations", "reactions", "rhs"):
            got, expected = (getattr(m, function)(0.2, y, m.DEFAULTS) for m in (short, long))
            assert got == pytest.approx(expected, rel=1e-11, abs=1e-11), function


TURNED = spec("turned_top")


def test_quasi_velocities_on_the_other_axes() -> None:
    """A top's own rates are those of Euler's equations, whatever axes the angular velocity is written on."""
    system = resolve(decode(Source("s.yaml", TURNED)))
    assert operations(program_of(system)) <= 59
    g = system.graph
    formulation = formulate(system)
    assert formulation.frame is not None
    (own,), (base,) = formulation.frame.turned, formulation.frame.bases
    assert (own.sign, base.sign) == (-1, 1)
    w = formulation.frame.free
    assert own.turning(g, formulation.frame.kinematics)[1:] == turn_omega(g, own, w)


def test_a_top_with_its_state_in_space() -> None:
    """Solved for on its own axes, where the moments of inertia do not move; back, for omega x omega = 0."""
    rows = [f"B_{axis}1*p + B_{axis}2*q + B_{axis}3*r" for axis in "xyz"]
    text = TURNED.replace(", frame: space", "")
    for k, (row, own) in enumerate(zip(rows, "pqr", strict=True), 1):
        text = re.sub(rf"u{k}: w{k}\b", f"u{k}: {row}", text)
        text = re.sub(rf"\bw{k}: .*", f"w{k}: {own}", text)
    with_all, without = Graph(), WithoutRules(["other axes", "detours"])
    assert are_equal(without, transplant(rates(text, with_all), with_all, without), rates(text, without))
    assert operations(program_of(resolve(decode(Source("s.yaml", text))))) <= 117
    source = Source("s.yaml", text)
    assert_slopes(module_of(source), module_of(source, ("other axes", "detours")), "turned_top")


def test_a_ball_that_rolls_freely_has_no_matrix_to_watch() -> None:
    """Its rates are zero; pivots on its own axes would be the only use of the mass matrix there."""
    assert operations(program_of(resolve(decode(Source("s.yaml", f"{PLANE}{ROLLING}"))))) <= 70


def test_entries_of_the_matrix_count_as_one() -> None:
    """What a pivot is measured against does not hold the quaternion again."""
    made = resolve(decode(Source("s.yaml", PLANE)))
    g, (rotation,) = made.graph, made.rotations
    for row in rotation.matrix:
        assert [size_of(g, x) for x in row] == [g.one] * 3
        assert size_of(g, g.neg(g.mul(made.p[0], row[0]))) == g.function("abs", made.p[0])
