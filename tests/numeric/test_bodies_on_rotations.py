"""Trees in which rotations, angles and constraints stand together, and planar chains by matrices: the rates are the dense ones."""

from __future__ import annotations

import random
from dataclasses import dataclass, field

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.trees.bodies import read_bodies
from nhc.mechanics.trees.chain import find_chain
from nhc.mechanics.trees.forces import lift_forces
from nhc.mechanics.trees.tree import Elimination
from nhc.pipeline import Model, model
from nhc.program.plan import factor, solve_factored
from nhc.program.planning.planner import Planner
from tests.numeric.test_chains import residuals

AXES = "xyz"
Matrix = list[list[str]]
UNIT: Matrix = [["1", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]]
FOOT = {"fixed": ["0", "0", "0"], "free": ["x", "y", "z"], "rolling": ["x", "y", "0"], "skate": ["x", "y", "0"]}


@dataclass
class Mixed:
    """Bodies one on another; ``joints``: "R" a rotation from the body before, "S" one from space, else digits: axes of angles, and
    letters: those of constant ones.

    ``alike``: all bodies have one length, which sums then have in front; ``spheres``: the first has energy by components in space.
    """

    joints: tuple[str, ...]
    base: str = "fixed"
    frame: str = "body"
    alike: bool = False
    inline: bool = False
    spheres: bool = False
    parents: tuple[int, ...] = ()
    coordinates: list[str] = field(default_factory=list)
    rotations: list[str] = field(default_factory=list)
    lines: list[str] = field(default_factory=list)
    kinetic: list[str] = field(default_factory=list)
    potential: list[str] = field(default_factory=list)
    parameters: dict[str, float] = field(default_factory=dict)

    def number(self, name: str) -> str:
        draw = random.Random(name)
        self.parameters.setdefault(name, round(draw.uniform(0.3, 0.6), 3))
        return name

    def name(self, name: str, text: str) -> str:
        """The text under a name, or itself."""
        if self.inline or text in ("0", "1"):
            return text
        self.lines.append(f"{name}: {text}")
        return name

    def text(self) -> str:
        self.parameters.update(g=9.81, M=1.3, a=0.4)
        self.coordinates += [c for c in FOOT[self.base] if c != "0"]
        turned: list[tuple[Matrix, list[str]]] = [(UNIT, ["0", "0", "0"])]
        feet = [FOOT[self.base]]
        if self.coordinates:
            self.kinetic.append("M/2*(" + " + ".join(f"{c}'^2" for c in self.coordinates) + ")")
        for i, joint in enumerate(self.joints, 1):
            parent = self.parents[i - 1] if self.parents else i - 1
            matrix, spin = (
                self._rotate(i, joint, *turned[parent]) if joint in "RS" else self._turn(i, joint, *turned[parent])
            )
            turned.append((matrix, spin))
            feet.append(self._hang(i, feet[parent], matrix, spin))
        values = ", ".join(f"{name}: {value}" for name, value in self.parameters.items())
        lines = ["nhc: 1", "system: mixed", f"coordinates: [{', '.join(self.coordinates)}]"] if self.coordinates else []
        lines = lines or ["nhc: 1", "system: mixed"]
        lines += ["rotation:", *self.rotations] if self.rotations else []
        lines += [f"parameters: {{{values}}}"]
        lines += ["define:", *(f"  {line}" for line in self.lines)] if self.lines else []
        lines += [f"T: {' + '.join(self.kinetic)}", f"V: {' + '.join(self.potential)}"]
        return "\n".join(lines + self._constraints(turned[1][1], turned[1][0])) + "\n"

    def _constraints(self, spin: list[str], matrix: Matrix) -> list[str]:
        x, y, _ = (" + ".join(f"({u})*({w})" for u, w in zip(row, spin, strict=True)) for row in matrix)
        if self.base == "rolling":
            return ["constraints:", f"  - x' - a*({y}) = 0", f"  - y' + a*({x}) = 0"]
        return ["constraints:", f"  - ({matrix[0][1]})*x' + ({matrix[1][1]})*y' = 0"] if self.base == "skate" else []

    def _rotate(self, i: int, joint: str, old: Matrix, spin: list[str]) -> tuple[Matrix, list[str]]:
        own = [f"{c}{i}" for c in "pqr"]
        self.rotations.append(f"  R{i}: {{velocities: [{', '.join(own)}], frame: {self.frame}}}")
        entries = [[f"R{i}_{a}{j}" for j in (1, 2, 3)] for a in AXES]
        body = own
        if self.frame == "space" and not self.spheres:
            body = [" + ".join(f"R{i}_{a}{j}*{w}" for a, w in zip(AXES, own, strict=True)) for j in (1, 2, 3)]
        if self.spheres and old is UNIT:
            self.kinetic.append(f"{self.number('J')}/2*({' + '.join(f'{w}^2' for w in own)})")
            body = [" + ".join(f"R{i}_{a}{j}*{w}" for a, w in zip(AXES, own, strict=True)) for j in (1, 2, 3)]
        if joint == "S" or old is UNIT:
            return entries, [
                self.name(f"W{i}_{j}", f"({w})") if self.frame == "space" else w for j, w in enumerate(body)
            ]
        matrix = [
            [
                self.name(f"S{i}_{a}{j}", " + ".join(f"({u})*{entries[k][j]}" for k, u in enumerate(old[a])))
                for j in range(3)
            ]
            for a in range(3)
        ]
        carried = [" + ".join(f"{entries[k][j]}*({w})" for k, w in enumerate(spin)) for j in range(3)]
        return matrix, [
            self.name(f"W{i}_{j}", f"{c} + {w}") for j, (c, w) in enumerate(zip(carried, body, strict=True))
        ]

    def _turn(self, i: int, joint: str, old: Matrix, spin: list[str]) -> tuple[Matrix, list[str]]:
        for place, sign in enumerate(joint):
            tilted = sign in AXES
            axis = AXES.index(sign) if tilted else int(sign)
            q = self.number(f"b{i}_{place}") if tilted else f"q{i}_{place}"
            self.coordinates += [] if tilted else [q]
            c, s, j, k = f"cos({q})", f"sin({q})", (axis + 1) % 3, (axis + 2) % 3
            matrix = [list(row) for row in old]
            for a, row in enumerate(old):
                matrix[a][j] = self.name(f"S{i}_{place}_{a}{j}", f"({row[j]})*{c} + ({row[k]})*{s}")
                matrix[a][k] = self.name(f"S{i}_{place}_{a}{k}", f"({row[k]})*{c} - ({row[j]})*{s}")
            made = {j: f"({spin[j]})*{c} + ({spin[k]})*{s}", k: f"({spin[k]})*{c} - ({spin[j]})*{s}"}
            made[axis] = spin[axis] if tilted else f"{spin[axis]} + {q}'"
            old, spin = matrix, [self.name(f"W{i}_{place}_{n}", made[n]) for n in range(3)]
        return old, spin

    def _hang(self, i: int, foot: list[str], matrix: Matrix, spin: list[str]) -> list[str]:
        tag = "" if self.alike else str(i)
        arms = {
            "c": [self.number(f"c{tag}"), "0", self.number(f"h{tag}")],
            "e": ["0", "0", f"-{self.number(f'l{tag}')}"],
        }
        ends = {}
        for end, arm in arms.items():
            sums = [
                " + ".join([at, *(f"({u})*({d})" for u, d in zip(row, arm, strict=True) if d != "0")])
                for at, row in zip(foot, matrix, strict=True)
            ]
            ends[end] = [self.name(f"{end}{i}{axis}", text) for axis, text in zip(AXES, sums, strict=True)]
        squares = " + ".join(f"({text})'^2" for text in ends["c"])
        m = self.number(f"m{tag}")
        self.kinetic.append(f"{m}/2*({squares})")
        self.kinetic += [f"{self.number(f'J{tag}{axis}')}/2*({w})^2" for axis, w in zip(AXES, spin, strict=True)]
        self.potential.append(f"{m}*g*({ends['c'][2]})")
        return ends["e"]


def made(text: str) -> tuple[Model, list[Elimination]]:
    """The model, and the eliminations along the bodies: in space, on the axes of one body and on those of each."""
    found, trees = model(Source("mixed.yaml", text)), list[Elimination]()
    for spatial in read_bodies(found.system, found.equations.motion, every=True):
        assert spatial.known
        chain = find_chain(found.system, found.equations.motion, spatial.kinetic, spatial)
        assert chain is not None
        trees += [Elimination(chain), Elimination(lift_forces(chain))]
    assert trees
    return found, trees


CASES = {
    "rotations on rotations": Mixed(("R", "R", "R")),
    "alike": Mixed(("R", "R", "R"), alike=True),
    "alike, inline": Mixed(("R", "R", "R"), alike=True, inline=True),
    "in space": Mixed(("R", "R"), frame="space"),
    "in space, on angles": Mixed(("12", "R", "0"), frame="space"),
    "angles on a rotation": Mixed(("R", "01", "12"), base="free"),
    "tilted joints on a rotation": Mixed(("R", "x0", "y1"), base="free"),
    "a tilted joint, and a tilted body": Mixed(("R", "y2", "0x"), base="free"),
    "tilted twice": Mixed(("R", "yx2"), base="free"),
    "a rotation on a tilted joint": Mixed(("R", "x2", "R"), base="free"),
    "a rotation on angles": Mixed(("20", "R", "1")),
    "one of space on the end": Mixed(("R", "S", "0"), base="free"),
    "a tree": Mixed(("R", "01", "R", "2"), base="free", parents=(0, 1, 1, 2)),
    "a rolling ball": Mixed(("R", "01", "10"), base="rolling", alike=True),
    "a rolling ball, inline": Mixed(("R", "01"), base="rolling", inline=True),
    "a rolling ball in space": Mixed(("R", "02", "R"), base="rolling", frame="space"),
    "spheres by components in space": Mixed(("R", "02", "1"), base="rolling", frame="space", spheres=True),
    "a skate by angles": Mixed(("20", "12", "0"), base="skate"),
    "a skate on a rotation": Mixed(("R", "1", "0"), base="skate"),
}


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", CASES)
def test_the_rates_are_the_dense_ones(name: str) -> None:
    found, trees = made(CASES[name].text())
    g, motion = found.system.graph, found.equations.motion
    matrix = factor(g, found.equations.mass)
    right = [g.symbol(f"r{i}", "test") for i in range(len(motion.w))]
    assert len(trees) == (2 if name == "one of space on the end" else 6)  # where points hang on two families
    for tree in trees:
        assert are_equal(g, tree.rates, solve_factored(g, matrix, list(found.equations.force)))
        assert are_equal(g, tree.solve(right), solve_factored(g, matrix, right))
        assert are_equal(g, *residuals(found, tree))


def operations(text: str) -> int:
    """Of the rates, in the way that is taken."""
    found = model(Source("mixed.yaml", text))
    return count(found.system.graph, Planner(found.equations, found.formulation).route.values)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("joints", "base", "each"), [("R", "fixed", 1080), ("01", "rolling", 760), ("01", "free", 760)]
)
def test_the_work_is_linear(joints: str, base: str, each: int) -> None:
    """Also behind a base that a constraint holds: it stays with the base."""
    sizes = [operations(Mixed(("R", *[joints] * n), base=base, alike=True).text()) for n in (3, 5, 7)]
    assert sizes[2] - sizes[1] <= 1.05 * (sizes[1] - sizes[0]) <= 2 * 1.05 * each


@pytest.mark.parametrize(
    ("joints", "most"), [(("R", "y2", "1"), 1200), (("R", "2y", "1"), 860), (("R", "2", "1"), 800)]
)
def test_a_constant_tilt_costs_little(joints: tuple[str, ...], most: int) -> None:
    """And components of an angular velocity are known with a number in front: a quaternion's are twice a sum of its rates."""
    assert operations(Mixed(joints, base="free").text()) <= most


@pytest.mark.sample(2)
@pytest.mark.parametrize("alike", [False, True])
@pytest.mark.parametrize(("joints", "base"), [(("R", "R", "R"), "fixed"), (("R", "01", "01", "01"), "rolling")])
def test_names_of_points_make_no_difference(joints: tuple[str, ...], base: str, alike: bool) -> None:
    one, other = (operations(Mixed(joints, base=base, alike=alike, inline=inline).text()) for inline in (False, True))
    assert max(one, other) <= 1.1 * min(one, other)


PLANAR = """
nhc: 1
system: links
coordinates: [{coordinates}]
parameters: {{g: 9.81, l: 0.8, c: 0.3, m: 1.2, J: 0.1, k: 2}}
define:
{define}
T: {kinetic}
V: {potential}
"""


def planar(links: int, *, flipped: bool) -> str:
    """Links by the angles between them; each one's axes are those of the link before times a matrix of two rows."""
    define, kinetic, potential = [], [], []
    ax, az, x, z, spin = "0", "-1", "0", "0", "0"
    for i in range(links):
        c, s = f"cos(q{i})", f"sin(q{i})"
        define += [f"a{i}: ({ax})*{c} - ({az})*{s}", f"b{i}: ({ax})*{s} + ({az})*{c}", f"w{i}: {spin} + q{i}'"]
        ax, az, spin = f"a{i}", f"b{i}", f"w{i}"
        define += [f"X{i}: {x} + c*{ax}", f"Z{i}: {z} + c*{az}", f"x{i}: {x} + l*{ax}", f"z{i}: {z} + l*{az}"]
        x, z = f"x{i}", f"z{i}"
        squares = (f"Z{i}'^2", f"X{i}'^2") if flipped and i % 2 else (f"X{i}'^2", f"Z{i}'^2")
        kinetic.append(f"m/2*({' + '.join(squares)}) + J/2*w{i}^2")
        potential.append(f"m*g*Z{i} + k/2*q{i}^2")
    return PLANAR.format(
        coordinates=", ".join(f"q{i}" for i in range(links)),
        define="\n".join(f"  {line}" for line in define),
        kinetic=" + ".join(kinetic),
        potential=" + ".join(potential),
    )


@pytest.mark.parametrize("flipped", [False, True])
def test_a_planar_chain_by_matrices(flipped: bool) -> None:
    """Two components of a point are a vector too, in whatever order they stand."""
    found, trees = made(planar(5, flipped=flipped))
    g = found.system.graph
    dense = solve_factored(g, factor(g, found.equations.mass), list(found.equations.force))
    assert all(are_equal(g, tree.rates, dense) for tree in trees)
    sizes = [operations(planar(n, flipped=flipped)) for n in (8, 10, 12)]
    assert sizes[2] - sizes[1] <= 1.05 * (sizes[1] - sizes[0]) <= 2 * 1.05 * 110


WHEELS = """
nhc: 1
system: satellite
coordinates: [s, u]
rotation: {R: {velocities: [p, q, r]}}
parameters: {A: 10, B: 12, C: 14, J: 0.1, K: 0.06}
T: (A*p^2 + B*q^2 + C*r^2)/2 + J/2*((p + s')^2 + (q + u')^2)
  + K/2*((cos(s)*q + sin(s)*r)^2 + (cos(s)*r - sin(s)*q)^2 + (cos(u)*p - sin(u)*r)^2 + (cos(u)*r + sin(u)*p)^2)
"""


def test_wheels_whose_inertia_is_constant_are_solved_densely() -> None:
    """The mass matrix consists of parameters, which the rates that a form is made of do not tell."""
    found = model(Source("satellite.yaml", WHEELS))
    route = Planner(found.equations, found.formulation).route
    assert not route.chained
    assert count(found.system.graph, route.values) <= 60
