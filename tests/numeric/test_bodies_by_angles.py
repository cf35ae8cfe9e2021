"""Bodies in space on joints by angles, read from their positions: the rates are the dense ones, and the work is linear."""

from __future__ import annotations

import random

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.trees.bodies import read_bodies
from nhc.mechanics.trees.chain import find_chain
from nhc.mechanics.trees.tree import Elimination
from nhc.pipeline import Model, model
from nhc.program.plan import factor, solve_factored
from nhc.program.planning.planner import Planner
from tests.trees import robot_arm

AXES = "xyz"
Matrix = list[list[str]]


class Joints:
    """A tree of bodies, each turned from its parent's axes, or from those of space, by angles about axes ``order``."""

    def __init__(self, seed: int, bodies: int, *, kind: str = "relative", joints: int = 0, alike: bool = False) -> None:
        draw = self.draw = random.Random(f"joints {seed}")
        self.coordinates: list[str] = ["x", "y", "z"] if kind == "free" else []
        self.parameters = {"g": 9.81, "k": 1.5, "M": 1.3, "a": 0.4}
        self.lines: list[str] = []
        self.kinetic = ["M/2*(x'^2 + y'^2 + z'^2)"] if kind == "free" else []
        self.potential: list[str] = []
        foot = {0: ["x", "y", "z"] if kind == "free" else ["a*sin(t)", "0", "a*t"] if kind == "driven" else ["0"] * 3}
        unit: Matrix = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
        turned: dict[int, tuple[Matrix, list[str]]] = {0: (unit, ["0", "0", "0"])}
        for i in range(1, bodies + 1):
            parent = i - 1 if alike else draw.choice((i - 1, i - 1, draw.randrange(i)))
            order = [0, 1] if alike else self._order(joints or draw.randint(1, 3))
            start = (unit, ["0", "0", "0"]) if kind == "absolute" else turned[parent]
            turned[i] = self._turn(i, *start, order, driven=kind == "driven" and i == 2)
            foot[i] = self._hang(i, foot[parent], *turned[i])

    def _order(self, joints: int) -> list[int]:
        """Axes of which no two neighbours are one: those would be one joint."""
        order = [self.draw.randrange(3)]
        while len(order) < joints:
            order.append((order[-1] + self.draw.choice((1, 2))) % 3)
        return order

    def _turn(
        self, i: int, matrix: Matrix, spin: list[str], order: list[int], driven: bool
    ) -> tuple[Matrix, list[str]]:
        for place, axis in enumerate(order):
            q = f"q{i}_{place}"
            self.coordinates.append(q)
            angle, rate = (f"({q} + a*sin(2*t))", f"({q}' + 2*a*cos(2*t))") if driven else (q, f"{q}'")
            matrix, old = [list(row) for row in matrix], matrix
            j, k = (axis + 1) % 3, (axis + 2) % 3
            name = f"S{i}_{place}"
            for row in range(3):
                u, v = old[row][j], old[row][k]
                self.lines.append(f"{name}_{row}{j}: ({u})*cos({angle}) + ({v})*sin({angle})")
                self.lines.append(f"{name}_{row}{k}: ({v})*cos({angle}) - ({u})*sin({angle})")
                matrix[row][j], matrix[row][k] = f"{name}_{row}{j}", f"{name}_{row}{k}"
            u, v, w = (f"({spin[n]})" for n in (j, k, axis))
            made = {j: f"{u}*cos({angle}) + {v}*sin({angle})", k: f"{v}*cos({angle}) - {u}*sin({angle})"}
            made[axis] = f"{w} + {rate}"
            self.lines += [f"W{i}_{place}_{n}: {text}" for n, text in made.items()]
            spin = [f"W{i}_{place}_{n}" for n in range(3)]
            self.potential.append(f"k/2*{q}^2")
        return matrix, spin

    def number(self, name: str, low: float, high: float) -> str:
        self.parameters[name] = round(self.draw.uniform(low, high), 3)
        return name

    def _hang(self, i: int, foot: list[str], matrix: Matrix, spin: list[str]) -> list[str]:
        ends = {}
        for end, size in (("c", 0.3), ("e", 1.0)):
            arm = [self.number(f"{end}{i}{axis}", -size, size) for axis in AXES]
            for axis, at, row in zip(AXES, foot, matrix, strict=True):
                terms = " + ".join(f"({u})*{d}" for u, d in zip(row, arm, strict=True))
                self.lines.append(f"{end}{i}_{axis}: {at} + {terms}")
            ends[end] = [f"{end}{i}_{axis}" for axis in AXES]
        m = self.number(f"m{i}", 0.5, 2)
        self.kinetic.append(f"{m}/2*({' + '.join(f'{c}{chr(39)}^2' for c in ends['c'])})")
        self.kinetic += [
            f"{self.number(f'J{i}{axis}', 0.3, 0.6)}/2*({w})^2" for axis, w in zip(AXES, spin, strict=True)
        ]
        self.kinetic.append(f"{self.number(f'D{i}', -0.05, 0.05)}*({spin[0]})*({spin[1]})")
        self.potential.append(f"{m}*g*{ends['c'][2]}")
        return ends["e"]

    def text(self) -> str:
        values = ", ".join(f"{name}: {value}" for name, value in self.parameters.items())
        lines = ["nhc: 1", "system: tree", f"coordinates: [{', '.join(self.coordinates)}]", f"parameters: {{{values}}}"]
        lines += ["define:", *(f"  {line}" for line in self.lines)]
        lines += [f"T: {' + '.join(self.kinetic)}", f"V: {' + '.join(self.potential)}"]
        lines.append(f"forces: {{{self.coordinates[-1]}: -0.1*{self.coordinates[-1]}'}}")
        return "\n".join(lines) + "\n"


def made(text: str) -> tuple[Model, list[Elimination]]:
    """The model, and the eliminations along the bodies: in space, and on the axes of bodies where these are chains."""
    found, trees = model(Source("tree.yaml", text)), list[Elimination]()
    for spatial in read_bodies(found.system, found.equations.motion, every=True):
        chain = find_chain(found.system, found.equations.motion, spatial.kinetic, spatial)
        assert chain is not None
        assert spatial.known
        trees.append(Elimination(chain))
    return found, trees


CASES = [pytest.param(Joints(s, 3, kind=k), id=f"{k}-{s}") for s in range(2) for k in ("relative", "free", "driven")]
CASES += [pytest.param(Joints(s, 3, kind="absolute", joints=3), id=f"absolute-{s}") for s in range(2, 6)]


@pytest.mark.sample(2)
@pytest.mark.parametrize("case", CASES)
def test_the_rates_are_the_dense_ones(case: Joints) -> None:
    found, trees = made(case.text())
    g = found.system.graph
    matrix = factor(g, found.equations.mass)
    right = [g.symbol(f"r{i}", "test") for i in range(found.system.n)]
    assert trees
    for tree in trees:
        assert are_equal(g, tree.rates, solve_factored(g, matrix, list(found.equations.force)))
        assert are_equal(g, tree.solve(right), solve_factored(g, matrix, right))


@pytest.mark.parametrize("seed", range(4))
def test_arms_of_hinges(seed: int) -> None:
    """Components of T come in any order and with zeros among them."""
    found, trees = made(robot_arm(seed, joints=4))
    g = found.system.graph
    dense = solve_factored(g, factor(g, found.equations.mass), list(found.equations.force))
    assert len(trees) == 3
    assert all(are_equal(g, tree.rates, dense) for tree in trees)


SINGLE = """
nhc: 1
system: arms
coordinates: [p, n, s, q, r]
parameters: {m: 1.2, g: 9.81, A: 0.3, B: 0.5, l: 0.8, h: 0.3}
define:
  ux: cos(p)*sin(n)
  uy: sin(p)*sin(n)
  uz: -cos(n)
  x1: l*ux
  y1: l*uy
  z1: l*uz
  X: x1 + FAR*sin(r)*ux + h*cos(r)*sin(q)
  Y: y1 + FAR*sin(r)*uy - h*cos(r)*cos(q)
  Z: z1 + FAR*sin(r)*uz + h*sin(r)
T: m/2*(x1'^2 + y1'^2 + z1'^2) + m/2*(X'^2 + Y'^2 + Z'^2) + A/2*(p'^2*sin(n)^2 + n'^2) + B/2*(s' + p'*cos(n))^2 + A/2*(q'^2 + r'^2)
V: m*g*(z1 + Z) + s^2
"""


@pytest.mark.parametrize("far", ["0", "h", "l"])
def test_vectors_that_only_look_like_turned_ones_are_not_taken_for_such(far: str) -> None:
    """A length that changes, a sum of two turned vectors with one factor, T written in squares of the rates."""
    found = model(Source("arms.yaml", SINGLE.replace("FAR", far)))
    g = found.system.graph
    for spatial in read_bodies(found.system, found.equations.motion, every=True):
        chain = find_chain(found.system, found.equations.motion, spatial.kinetic, spatial)
        assert chain is not None
        dense = solve_factored(g, factor(g, found.equations.mass), list(found.equations.force))
        assert are_equal(g, Elimination(chain).rates, dense)


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "joints", "each"), [("relative", 2, 790), ("absolute", 3, 620)])
def test_the_work_is_linear(kind: str, joints: int, each: int) -> None:
    sizes = {}
    for n in (5, 7, 9):
        tree = Joints(3, n, kind=kind, alike=True) if joints == 2 else Joints(3, n, kind=kind, joints=joints)
        found = model(Source("tree.yaml", tree.text()))
        sizes[n] = count(found.system.graph, Planner(found.equations, found.formulation).route.values)
    assert sizes[9] - sizes[7] <= 1.05 * (sizes[7] - sizes[5]) <= 2 * 1.05 * each


def hinged(axes: str, count: int, centre: str = "[0, 0, l/2]") -> str:
    """An arm by its bodies: equal lengths, centres on the line of joints, so that some turns leave all points where they are."""
    lines = ["nhc: 1", "system: arm", f"coordinates: [{', '.join(f'q{k}' for k in range(count))}]"]
    lines += ["parameters: {m: 1, A: 0.1, B: 0.2, C: 0.3, l: 1, a: 0.3, g: 9.81}", "bodies:"]
    for k in range(count):
        place = f"parent: b{k - 1}, at: [0, 0, l], " if k else ""
        lines.append(
            f"  b{k}: {{{place}turns: [{axes[k % len(axes)]}: q{k}], mass: m, centre: {centre}, inertia: [A, B, C]}}"
        )
    return "\n".join([*lines, "gravity: [0, 0, -g]"]) + "\n"


@pytest.mark.parametrize(
    ("axes", "count", "centre"),
    [("zyx", 5, "[0, 0, l/2]"), ("zyx", 7, "[0, 0, l/2]"), ("zyzy", 5, "[0, 0, l/2]"), ("xyz", 6, "[0, a, l/2]")],
)
def test_arms_whose_centres_lie_on_their_joints(axes: str, count: int, centre: str) -> None:
    """A turn about the line of the joints moves no point: it is read from what stands beyond it, or from angular velocities."""
    found, trees = made(hinged(axes, count, centre))
    g = found.system.graph
    dense = solve_factored(g, factor(g, found.equations.mass), list(found.equations.force))
    assert all(are_equal(g, tree.rates, dense) for tree in trees)
    known = [len(spatial.known) for spatial in read_bodies(found.system, found.equations.motion, every=True)]
    assert known == [known[0]] * 3
    assert known[0] >= 3 * (count - 2)


@pytest.mark.slow
def test_arms_of_hinges_take_operations_linear_in_their_length() -> None:
    def operations(length: int) -> list[int]:
        found, trees = made(hinged("zyx", length))
        return [count(found.system.graph, tree.rates) for tree in trees]

    for eight, twelve, sixteen in zip(*map(operations, (8, 12, 16)), strict=True):
        assert sixteen - twelve < 1.2 * (twelve - eight)


GYROSCOPE = """nhc: 1
system: gyroscope
coordinates: [az, el, spin]
parameters: {A: 0.02, C: 0.03, P: 0.01, Q: 0.012, S: 0.015, m: 0.4, h: 0.02, W: 0.2, roll: 0.2, n: 200, g: 9.81}
bodies:
  earth: {turns: [z: W*t, y: 0.7]}
  ship: {parent: earth, turns: [x: roll*sin(t)]}
  outer: {parent: ship, turns: [z: az], inertia: [0, 0, P]}
  inner: {parent: outer, turns: [y: el], mass: m, centre: [0, 0, -h], inertia: [P, Q, S]}
  rotor: {parent: inner, turns: [x: spin], inertia: [C, A, A]}
V: m*g*(inner_cx*earth_x3 + inner_cy*earth_y3 + inner_cz*earth_z3)
constraints: [rotor_w1 = n]
"""


def test_a_rotor_of_given_speed_leaves_the_bodies_to_the_tree() -> None:
    """The dense way differentiates the matrices of what carries the gyroscope, and is twice as long."""
    found = model(Source("gyroscope.yaml", GYROSCOPE))
    route = Planner(found.equations, found.formulation).route
    dense = solve_factored(
        found.system.graph, factor(found.system.graph, found.equations.mass), list(found.equations.force)
    )
    assert route.chained
    assert count(found.system.graph, route.values) <= 200
    assert are_equal(found.system.graph, list(route.values), dense)
