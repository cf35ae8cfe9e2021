"""Rolling bodies with a rotation: on their own axes the equations have the same values, exactly, in fewer operations."""

from __future__ import annotations

import random

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import reachable
from nhc.language import read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.mechanics.formulate import _route, equations_of
from nhc.mechanics.moving.on_body import move_on_bodies
from nhc.mechanics.system import System
from tests.numeric.test_moving import assert_same, system_of
from tests.support import spec_path

# the contact from the centre of the body on its axes, and the height of the centre; g1, g2, g3 is the normal on the same axes
SURFACES = {
    "ball": (("-a*g1", "-a*g2", "-a*g3"), "a"),
    "ellipsoid": (("-a^2*g1/h", "-b^2*g2/h", "-c^2*g3/h"), "h"),
    "disc": (("-a*g1/s", "-a*g2/s", "0"), "a*s"),
    "torus": (("-a*g1/s - b*g1", "-a*g2/s - b*g2", "-b*g3"), "a*s + b"),
}


def rolling(surface: str, seed: int, *, plate: bool = False, rubber: bool = False) -> str:
    """A body that rolls on a plane with any normal, on one that turns if ``plate``, without spin about the normal if it is of
    ``rubber``, with any centre of mass and inertia.
    """
    draw = random.Random(f"{surface} {seed}")
    k = draw.randrange(3)
    i, j = (k + 1) % 3, (k + 2) % 3
    place, height = SURFACES[surface]
    at = ["", "", ""]
    at[i], at[j], at[k] = "u", "v", "height"
    letters = "xyz"
    normal = [f"R_{letters[k]}{column}" for column in "123"]
    centre = draw.choice(["[0, 0, 0]", "[0, 0, e]", "[e, -f, 2*e]"])
    inertia = draw.choice(["[A, B, C]", "[A, A, C]", "{xx: A, yy: B, zz: C, xz: D, xy: -D}"])
    weight = ["0", "0", "0"]
    weight[k] = "-g"
    moving = {i: "-W*v", j: "W*u"} if plate else {i: "0", j: "0"}
    rows = []
    for axis in draw.sample([i, j], 2):
        factor = draw.choice(["", "-", "2*", "m*"])
        rows.append(f"  - roll_{letters[axis]}: {factor}P_v{letters[axis]} = {factor}({moving[axis]})")
    rows += ["  - twist: g1*p + g2*q + g3*r = 0"] if rubber else []
    force = draw.choice(["", "forces: {p: -D*p, u: D*sin(t)}"])
    names = "\n".join(f"  g{n + 1}: {entry}" for n, entry in enumerate(normal))
    return f"""
nhc: 1
system: rolling
coordinates: [u, v]
rotation: {{R: {{velocities: [p, q, r]}}}}
parameters: {{m: 1.3, a: 0.5, b: 0.4, c: 0.3, e: 0.05, f: 0.02, g: 9.81, A: 0.3, B: 0.35, C: 0.4, D: 0.02, W: 0.7}}
define:
{names}
  s: sqrt(g1^2 + g2^2)
  h: sqrt(a^2*g1^2 + b^2*g2^2 + c^2*g3^2)
  height: {height}
bodies:
  body: {{at: [{", ".join(at)}], rotation: R, mass: m, centre: {centre}, inertia: {inertia}}}
gravity: [{", ".join(weight)}]
points:
  P: {{parent: body, of: body, at: [{", ".join(place)}]}}
constraints:
{chr(10).join(rows)}
{force}
"""


def cost(system: System) -> tuple[int, int]:
    """Operations on the axes of space and on those of the body."""
    kinetic, formulation = kinetic_structure(system), formulate(system)
    assert formulation.frame is not None
    moved = move_on_bodies(system, kinetic, formulation.frame)
    assert moved is not None
    g = system.graph
    return _route(system, formulation, kinetic).cost(g), _route(system, formulation, kinetic, moved).cost(g)


@pytest.mark.sample(3)
@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize("seed", range(4))
def test_rolling_bodies(surface: str, seed: int) -> None:
    system = system_of(rolling(surface, seed))
    assert assert_same(system) > 0
    before, after = cost(system)
    assert after < before


@pytest.mark.parametrize("seed", range(4))
def test_balls_on_a_plate_that_turns(seed: int) -> None:
    assert assert_same(system_of(rolling("ball", seed, plate=True))) > 0


@pytest.mark.parametrize("surface", ["ball", "ellipsoid"])
def test_bodies_of_rubber(surface: str) -> None:
    system = system_of(rolling(surface, 1, rubber=True))
    assert assert_same(system) > 0
    before, after = cost(system)
    assert after < before


def test_what_the_equations_are_made_of() -> None:
    """With a ball's centre of mass at its centre they are I omega' + ... with I + m a^2 (1 - gamma gamma^T), as in the books."""
    system = system_of(read(spec_path("chaplygin_ball_quaternion")).text)
    formulation = formulate(system)
    g = system.graph
    made = equations_of(system, formulation)
    (rotation,) = system.rotations
    gamma = rotation.matrix[2]
    at = {c.name: symbol for c, symbol in zip(system.spec.parameters, system.p, strict=True)}
    square = g.mul(at["m"], g.power(at["a"], 2))
    for i in range(3):
        for j in range(3):
            outer = g.mul(gamma[i], gamma[j])
            own = g.sub(g.add(at[f"I{i + 1}"], square), g.mul(square, outer)) if i == j else g.neg(g.mul(square, outer))
            assert are_equal(g, [made.mass[i][j]], [own])
    entries_in_use = [x for row in rotation.matrix[:2] for x in row]
    used = set(reachable(g, [node for row in made.mass for node in row]))
    assert used.isdisjoint(entries_in_use)


def test_a_top_on_a_fixed_point_needs_no_matrix_for_its_inertia() -> None:
    text = """
nhc: 1
system: top
coordinates: [s]
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: 1, b: 0.3, c: 0.1, d: 0.02, A: 0.06, B: 0.07, C: 0.08, g: 9.81}
bodies:
  top: {rotation: R, mass: m, centre: [b, c, d], inertia: [A, B, C]}
gravity: [0, 0, -g]
T: s'^2/2
"""
    system = system_of(text)
    assert assert_same(system) > 0
    made = equations_of(system, formulate(system))
    g = system.graph
    assert not any(g.deps[node] & ~g.mask(system.p) for row in made.mass for node in row)


def test_what_does_not_roll_is_left_as_it_is() -> None:
    """A free body's velocity is none that its rotation makes, and a rotation counted on the axes of space has others."""
    free = """
nhc: 1
system: free
coordinates: [x, y, z]
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: 1, b: 0.3, A: 0.06}
bodies:
  body: {at: [x, y, z], rotation: R, mass: m, centre: [b, 0, 0], inertia: A}
"""
    spun = rolling("ball", 1).replace("velocities: [p, q, r]", "velocities: [p, q, r], frame: space")
    for text in (free, spun):
        system = system_of(text)
        formulation = formulate(system)
        assert formulation.frame is not None
        assert move_on_bodies(system, kinetic_structure(system), formulation.frame) is None


def crossed(surface: str, seed: int, *, three: bool) -> str:
    """The body that rolls, its contact's velocity written as books do, by omega x k in space; its height too if ``three``."""
    draw = random.Random(f"{surface} {seed} {three}")
    place, height = SURFACES[surface]
    entries = {a: [f"R_{a}{n}" for n in (1, 2, 3)] for a in "xyz"}
    turning = {
        a: "(" + " + ".join(f"{x}*{w}" for x, w in zip(row, "pqr", strict=True)) + ")" for a, row in entries.items()
    }
    arm = {a: " + ".join(f"{x}*k{n}" for n, x in enumerate(row, 1)) for a, row in entries.items()}
    rows = []
    for n, a in enumerate("xyz" if three else "xy"):
        b, c = "xyz"[(n + 1) % 3], "xyz"[(n + 2) % 3]
        sign = draw.choice(["", "-", "2*"])
        rows.append(f'  - "{sign}({a}\' + {turning[b]}*c{c} - {turning[c]}*c{b}) = 0"')
    squares = ["x'^2", "y'^2", "z'^2" if three else "height'^2"]
    draw.shuffle(squares)
    names = "\n".join(f"  g{n}: R_z{n}" for n in (1, 2, 3))
    contact = "\n".join(f"  k{n}: {own}" for n, own in enumerate(place, 1))
    return f"""
nhc: 1
system: rolling
coordinates: [x, y{", z" if three else ""}]
rotation: {{R: {{velocities: [p, q, r]}}}}
parameters: {{m: 1.3, a: 0.5, b: 0.4, c: 0.3, g: 9.81, A: 0.3, B: 0.35, C: 0.4, D: 0.02}}
define:
{names}
  s: sqrt(g1^2 + g2^2)
  h: sqrt(a^2*g1^2 + b^2*g2^2 + c^2*g3^2)
  height: {height}
{contact}
{chr(10).join(f"  c{a}: {own}" for a, own in arm.items())}
T: m/2*({" + ".join(squares)}) + (A*p^2 + B*q^2 + C*r^2)/2 + D*p*q
V: m*g*{"z" if three else "height"}
constraints:
{chr(10).join(rows)}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize("three", [False, True])
@pytest.mark.parametrize("surface", SURFACES)
def test_velocities_by_vector_products_in_space(surface: str, three: bool) -> None:
    """R_i x R_j is the third row, and what the third component says of V is as good as what it should be."""
    for seed in range(2):
        system = system_of(crossed(surface, seed, three=three))
        assert assert_same(system) > 0
        before, after = cost(system)
        assert after < 0.85 * before
