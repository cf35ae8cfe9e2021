"""Composite inertias: the matrix and the right side are those of the dense way, as rational functions, and arms get shorter."""

from __future__ import annotations

import random
from copy import deepcopy

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.trees.composite import assemble
from nhc.pipeline import Model, model
from nhc.program.planning.planner import Planner
from tests.numeric.test_bodies_by_angles import Joints, hinged
from tests.numeric.test_bodies_on_rotations import CASES, Mixed
from tests.trees import robot_arm

TREES = deepcopy(CASES)  # each is written once
KINDS = ("R", "0", "1", "2", "01", "12", "20", "x0", "y1", "z2", "yx2", "0x")


def assert_same(text: str) -> Model:
    found = model(Source("bodies.yaml", text))
    g, size = found.system.graph, len(found.equations.motion.w)
    made = assemble(found.system, found.equations.motion)
    assert made is not None
    flat = [x for row in found.equations.mass for x in row]
    assert are_equal(g, [x for row in made.mass for x in row], flat)
    assert are_equal(g, made.force, found.equations.force)
    rates = [g.symbol(f"rate {i}", "test") for i in range(size)]
    dense = [g.sub(f, g.dot(row, rates)) for row, f in zip(found.equations.mass, found.equations.force, strict=True)]
    assert are_equal(g, made.residual(rates), dense)
    assert all(made.mass[i][j] == made.mass[j][i] for i in range(size) for j in range(size))
    return found


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", [name for name in TREES if name != "one of space on the end"])
def test_bodies_on_rotations_and_under_constraints(name: str) -> None:
    assert_same(deepcopy(TREES[name]).text())


def random_tree(seed: int) -> str:
    draw = random.Random(seed)
    joints = tuple(draw.choice(KINDS) for _ in range(draw.choice((2, 3, 4))))
    parents = (0, *(draw.randrange(1, i + 1) for i in range(1, len(joints))))
    base, frame = draw.choice(("fixed", "free")), draw.choice(("body", "space"))
    return Mixed(joints, base=base, frame=frame, alike=seed % 2 == 0, inline=seed % 3 == 0, parents=parents).text()


@pytest.mark.sample(2)
@pytest.mark.parametrize("seed", [seed for seed in range(14) if seed != 6])
def test_random_trees(seed: int) -> None:
    assert_same(random_tree(seed))


def test_what_is_not_read_is_left_to_other_ways() -> None:
    """A rotation in components of space on two hinges: its vectors are not seen on axes of their own."""
    found = model(Source("bodies.yaml", random_tree(6)))
    assert assemble(found.system, found.equations.motion) is None


@pytest.mark.sample(2)
@pytest.mark.parametrize("kind", ["relative", "free", "driven"])
@pytest.mark.parametrize("seed", range(3))
def test_trees_by_angles(kind: str, seed: int) -> None:
    """With products of inertia, springs, and feet and angles that are prescribed."""
    assert_same(Joints(seed, 3, kind=kind).text())


@pytest.mark.parametrize("seed", range(4))
def test_arms_of_hinges(seed: int) -> None:
    assert_same(robot_arm(seed, joints=4))


ARM = """nhc: 1
system: arm
coordinates: [{coordinates}]
parameters: {{g: 9.81, l: 0.4, c: 0.15, m: 1.2, A: 0.01, B: 0.03, C: 0.04{tilts}}}
bodies:
{bodies}
gravity: [0, 0, -g]
"""


def arm(joints: int, tilt: str) -> str:
    """Hinges about z, each tilted about x against the one before (s), or every second one, and the others parallel."""
    lines = []
    for k in range(joints):
        place = f"parent: b{k - 1}, at: [l, 0, 0], " if k else ""
        turns = f"x: s{k}, z: q{k}" if tilt == "s" and k else f"x: {tilt}, z: q{k}" if tilt and k % 2 else f"z: q{k}"
        lines.append(f"  b{k}: {{{place}turns: [{turns}], mass: m, centre: [c, 0, 0], inertia: [A, B, C]}}")
    tilts = "".join(f", s{k}: 0.{k + 1}" for k in range(joints)) if tilt == "s" else ""
    return ARM.format(coordinates=", ".join(f"q{k}" for k in range(joints)), bodies="\n".join(lines), tilts=tilts)


@pytest.mark.parametrize("tilt", ["", "pi/2", "s"])
def test_parallel_axes_and_tilts(tilt: str) -> None:
    """Angles of parallel hinges come as sums: their bodies' axes are not counted from one another."""
    assert_same(arm(5, tilt))


MANIPULATOR = """nhc: 1
system: manipulator
coordinates: [x, y, th, q1, q2, q3]
parameters: {m: 20, I: 2, a: 0.1, h: 0.4, g: 9.81, l: 0.5, k: 0.05, n: 3}
bodies:
  base: {at: [x, y, 0], turns: [z: th], mass: m, inertia: [I, I, I], centre: [a, 0, 0]}
  shoulder: {parent: base, at: [a, 0, h], turns: [z: q1], mass: n, inertia: [k, k, k]}
  upper: {parent: shoulder, turns: [y: q2], mass: n, centre: [l/2, 0, 0], inertia: [k, 2*k, 2*k]}
  fore: {parent: upper, at: [l, 0, 0], turns: [y: q3], mass: n, centre: [l/2, 0, 0.1], inertia: [k, 2*k, 2*k]}
gravity: [0, 0, -g]
constraints:
  - -x'*sin(th) + y'*cos(th) = 0
"""


def test_an_arm_on_wheels() -> None:
    """Centres at half a length: squares have the fourth in front, and two arms of one length have it in common."""
    assert_same(MANIPULATOR)


def operations(text: str) -> int:
    found = model(Source("bodies.yaml", text))
    return count(found.system.graph, Planner(found.equations, found.formulation).route.values)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("joints", "tilt", "most"), [(4, "s", 600), (6, "pi/2", 850), (6, "s", 1280), (8, "pi/2", 1450)]
)
def test_arms_are_short(joints: int, tilt: str, most: int) -> None:
    assert operations(arm(joints, tilt)) <= most


@pytest.mark.slow
def test_long_arms_stay_linear() -> None:
    """From some length on articulated inertias are shorter, and nothing else is taken."""
    short, middle, long = (operations(hinged("zyx", n)) for n in (16, 20, 24))
    assert long - middle <= 1.1 * (middle - short)
