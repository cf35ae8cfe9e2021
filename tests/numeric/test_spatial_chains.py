"""Bodies in space on ball joints: solved from the leaves, equal to the dense solution and to Newton's and Euler's equations."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit, model, program
from nhc.program.planning import mass_route
from nhc.program.planning.planner import Planner
from tests.numeric.test_chains import dense, made, residuals
from tests.support import error, python_model
from tests.trees import hinges, joints

AXES = "xyz"


class Tree:
    """Bodies with a rotation each, body i hung on ``parent[i]`` at that body's ``ends``; all numbers are drawn."""

    def __init__(
        self, seed: int, bodies: int, *, base: str = "fixed", frame: str = "body", alike: bool = False
    ) -> None:
        draw = self.draw = random.Random(f"ball joints {seed}")
        self.base, self.frame = base, frame
        self.parent = [0, *(draw.choice((i - 1, i - 1, draw.randrange(i))) for i in range(1, bodies + 1))]
        if alike:
            self.parent = [0, *range(bodies)]
        self.mass = [draw.uniform(0.5, 2) for _ in range(bodies + 1)]
        self.centre = [[draw.uniform(-0.3, 0.3) for _ in AXES] for _ in range(bodies + 1)]
        self.ends = [[draw.uniform(-1, 1) for _ in AXES] for _ in range(bodies + 1)]
        self.inertia = [[draw.uniform(0.3, 0.5) for _ in AXES] for _ in range(bodies + 1)]
        self.products = [[draw.uniform(-0.05, 0.05) for _ in AXES] for _ in range(bodies + 1)]
        self.friction = [draw.uniform(0.1, 0.3) for _ in range(bodies + 1)]
        self.bodies = bodies

    def tensor(self, i: int) -> Any:
        made = np.diag(self.inertia[i])
        for value, (a, b) in zip(self.products[i], ((1, 2), (2, 0), (0, 1)), strict=True):
            made[a, b] = made[b, a] = -value
        return made

    def text(self) -> str:
        """The spec: every position by the entries of the rotations' matrices."""
        lines = ["nhc: 1", "system: tree"]
        foot = {"fixed": ("0", "0", "0"), "free": ("x", "y", "z"), "driven": ("sin(2*t)", "t^2", "0")}[self.base]
        lines += ["coordinates: [x, y, z]"] * (self.base == "free") + ["rotation:"]
        of = range(1, self.bodies + 1)
        lines += [f"  R{i}: {{velocities: [p{i}, q{i}, r{i}], frame: {self.frame}}}" for i in of]
        values = {"g": 9.81, "M": 1.3}
        for i in of:
            for name, given in (("m", [self.mass[i]]), ("f", [self.friction[i]])):
                values[f"{name}{i}"] = given[0]
            for name, row in zip("cejd", (self.centre, self.ends, self.inertia, self.products), strict=True):
                values.update({f"{name}{i}{axis}": x for axis, x in zip(AXES, row[i], strict=True)})
        lines += ["parameters: {" + ", ".join(f"{name}: {value!r}" for name, value in values.items()) + "}", "define:"]
        kinetic, potential, forces = ["M/2*(x'^2 + y'^2 + z'^2)"] * (self.base == "free"), [], []
        for i in of:
            start = foot if not self.parent[i] else [f"e{self.parent[i]}_{axis}" for axis in AXES]
            for axis, at in zip(AXES, start, strict=True):
                for end in "ce":
                    arm = " + ".join(f"R{i}_{axis}{k + 1}*{end}{i}{AXES[k]}" for k in range(3))
                    lines.append(f"  {end}{i}_{axis}: {at} + {arm}")
            p, q, r = self._on_the_body(i)
            squares = " + ".join(f"j{i}{axis}/2*({w})^2" for axis, w in zip(AXES, (p, q, r), strict=True))
            mixed = "".join(f" - d{i}{a}*({u})*({v})" for a, u, v in (("x", q, r), ("y", r, p), ("z", p, q)))
            kinetic.append(
                f"m{i}/2*({' + '.join(f'c{i}_{axis}' + chr(39) + '^2' for axis in AXES)}) + {squares}{mixed}"
            )
            potential.append(f"m{i}*g*c{i}_z")
            forces += [f"{w}{i}: -f{i}*{w}{i}" for w in "pqr"]
        lines += [f"T: {' + '.join(kinetic)}", f"V: {' + '.join(potential)}", f"forces: {{{', '.join(forces)}}}"]
        return "\n".join(lines) + "\n"

    def _on_the_body(self, i: int) -> list[str]:
        if self.frame == "body":
            return [f"{w}{i}" for w in "pqr"]
        return [" + ".join(f"R{i}_{axis}{k}*{w}{i}" for axis, w in zip(AXES, "pqr", strict=True)) for k in (1, 2, 3)]

    def accelerations(self, t: float, turns: Sequence[Any], spins: Sequence[Any]) -> tuple[list[Any], list[Any]]:
        """(acceleration of the free base, angular accelerations in space) from Newton's and Euler's equations of free bodies.

        The joints are held by their accelerations; spins are in space.
        """
        n, free = self.bodies, self.base == "free"
        size, joints = 6 * n + 3 * free, 3 * n
        matrix, right = np.zeros((size + joints, size + joints)), np.zeros(size + joints)
        if free:
            matrix[6 * n : size, 6 * n : size] = 1.3 * np.eye(3)
        for i in range(1, n + 1):
            R, w, at = turns[i], spins[i], 6 * (i - 1)
            J = R @ self.tensor(i) @ R.T
            matrix[at : at + 3, at : at + 3] = self.mass[i] * np.eye(3)
            matrix[at + 3 : at + 6, at + 3 : at + 6] = J
            right[at + 2] = -self.mass[i] * 9.81
            right[at + 3 : at + 6] = -np.cross(w, J @ w) - self.friction[i] * w
            row, up = size + 3 * (i - 1), self.parent[i]
            to_joint = R @ -np.array(self.centre[i])
            held = [(at, np.eye(3)), (at + 3, -skew(to_joint))]
            drift = np.cross(w, np.cross(w, to_joint))
            if up:
                S, v, below = turns[up], spins[up], 6 * (up - 1)
                arm = S @ (np.array(self.ends[up]) - np.array(self.centre[up]))
                held += [(below, -np.eye(3)), (below + 3, skew(arm))]
                drift -= np.cross(v, np.cross(v, arm))
            elif free:
                held.append((6 * n, -np.eye(3)))
            elif self.base == "driven":
                drift -= np.array([-4 * np.sin(2 * t), 2.0, 0.0])
            for place, block in held:
                matrix[row : row + 3, place : place + 3] = block
                matrix[place : place + 3, row : row + 3] = block.T
            right[row : row + 3] = -drift
        found = np.linalg.solve(matrix, right)
        base = list(found[6 * n : size])
        return base, [found[6 * i + 3 : 6 * i + 6] for i in range(n)]


def skew(a: Any) -> Any:
    """a x."""
    return np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def matrix_of(e: Any) -> Any:
    """Of a quaternion of length 1."""
    turn = skew(e[1:])
    return np.eye(3) + 2 * e[0] * turn + 2 * turn @ turn


KINDS = [(0, "fixed", "body"), (1, "fixed", "space"), (2, "free", "body"), (3, "free", "space"), (4, "driven", "body")]
CASES = [pytest.param(Tree(s, 3 - s % 2, base=b, frame=f), id=f"{b}-{f}") for s, b, f in KINDS]


@pytest.mark.sample(2)
@pytest.mark.parametrize("case", CASES)
def test_the_rates_are_the_dense_ones(case: Tree) -> None:
    found, tree = made(case.text())
    assert are_equal(found.system.graph, tree.rates, dense(found, list(found.equations.force)))


@pytest.mark.parametrize("case", CASES[:3])
def test_any_right_side_is_solved(case: Tree) -> None:
    found, tree = made(case.text())
    g = found.system.graph
    right = [g.symbol(f"r{i}", "test") for i in range(len(found.equations.motion.w))]
    assert are_equal(g, tree.solve(right), dense(found, right))
    assert are_equal(g, *residuals(found, tree))


@pytest.mark.sample(4)
@pytest.mark.parametrize(("seed", "base", "frame"), [*((s + 10, b, f) for s, b, f in KINDS), (15, "driven", "space")])
def test_accelerations_are_those_of_newton_and_euler(seed: int, base: str, frame: str) -> None:
    case = Tree(seed, 6, base=base, frame=frame)
    source = Source("tree.yaml", case.text())
    found = model(source)
    assert Planner(found.equations, found.formulation).route.chained
    run = python_model(next(iter(emit(source, "python").values())), f"ball_tree_{seed}")
    draw, t = np.random.default_rng(seed), 0.3
    free = 3 * (base == "free")
    place, moving = draw.uniform(-1, 1, free), draw.uniform(-1, 1, free)
    quaternions, w = draw.normal(size=(6, 4)), draw.uniform(-1, 1, (6, 3))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    speeds = dict(zip(AXES[:free], moving, strict=True))
    speeds |= {f"{name}{i + 1}": w[i, k] for i in range(6) for k, name in enumerate("pqr")}
    kept = [found.system.symbol_name(x).rstrip("'") for x in found.equations.motion.w]
    state = [*place, *quaternions.ravel(), *(speeds[name] for name in kept)]
    rates = dict(zip(kept, np.array(run.rhs(t, state))[free + 24 :], strict=True))
    turns = [None, *map(matrix_of, quaternions)]
    spins = [None, *(R @ x if frame == "body" else x for R, x in zip(turns[1:], w, strict=True))]
    start, expected = case.accelerations(t, turns, spins)
    own = [x if frame == "space" else R.T @ x for R, x in zip(turns[1:], expected, strict=True)]
    assert error([rates[name] for name in speeds], [*start, *np.ravel(own)]) < 1e-11


@pytest.mark.sample(2)
@pytest.mark.parametrize(("frame", "each"), [("body", 760), ("space", 820)])
def test_the_work_is_linear(frame: str, each: int) -> None:
    sizes = {}
    for n in (5, 7, 9):
        case = Tree(3, n, frame=frame, alike=True)
        case.products = [[0.0] * 3] * (n + 1)
        found = model(Source("tree.yaml", case.text()))
        sizes[n] = count(found.system.graph, Planner(found.equations, found.formulation).route.values)
    assert sizes[9] - sizes[7] <= 1.05 * (sizes[7] - sizes[5]) <= 2 * 1.05 * each


def test_the_lengths_of_quaternions_have_no_reaction() -> None:
    found = model(Source("tree.yaml", Tree(5, 8, alike=True).text()))
    assert found.equations.tree is not None
    zero = found.system.graph.zero
    assert all(row.force == zero and set(row.mass) == {zero} for row in found.equations.reactions)


def test_a_potential_that_sees_the_length_has_its_reaction() -> None:
    """V of a bare quaternion part is no function of the orientation: its reaction is what the dense rows say."""
    text = Tree(5, 4).text().replace("V: ", "V: R1_0^2 + ")
    found, tree = made(text)
    g = found.system.graph
    assert are_equal(g, tree.rates, dense(found, list(found.equations.force)))
    assert any(row.force != g.zero for row in found.equations.reactions)


@pytest.mark.slow
def test_axes_are_followed_to_any_depth() -> None:
    """34 universal joints are 68 turns on one another."""
    short, long = (count_rates(joints(bodies)) for bodies in (12, 34))
    assert long / 34 < 1.1 * short / 12


@pytest.mark.slow
def test_of_two_recursions_that_start_from_as_much_the_shorter_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    """T's own forms are a little fewer operations than the bodies' are from 13 hinges on, and what is solved is twice as much.

    By recursions alone: composite inertias take 12 in still fewer.
    """
    monkeypatch.setattr(mass_route, "_of_bodies", lambda *_: None)
    short, long = (count_rates(hinges(bodies)) for bodies in (12, 14))
    assert long / 14 < 1.15 * short / 12


def count_rates(source: Source) -> int:
    """Operations of the accelerations."""
    (rhs,) = (f for f in program(source, Options(only=("rhs",))).functions if f.name == "rhs")
    return rhs.adds + rhs.multiplications + rhs.divisions
