"""Bodies against their own mechanics: places by matrices, velocities by differentiating along a motion with 30 digits.

Nothing of what nhc writes out is used by the reference: an angular velocity is read off R'R^T, the velocity of matter at P is
that of a point which is fixed on the body where P is now.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any

import mpmath
import pytest

from nhc.algebra.evaluate import evaluate
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System

Path = Callable[[Any], Any]  # time -> value, as an mpmath number or matrix
PARAMETERS = {"a": 0.7, "b": -0.4, "c": 1.3, "m": 2.1, "A": 0.6, "B": 0.9, "C": 1.4, "D": 0.1, "g": 9.8}
COORDINATES = ("x", "y", "z", "p", "q", "r")


def elementary(axis: str, angle: Any) -> Any:
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    rows = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return mpmath.matrix(rows[axis])


def of_quaternion(e: list[Any]) -> Any:
    """The matrix of e v e*/|e|^2 by products of quaternions."""

    def product(a: list[Any], b: list[Any]) -> list[Any]:
        return [
            a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
        ]

    size, conjugate = sum(x * x for x in e), [e[0], -e[1], -e[2], -e[3]]
    columns = []
    for k in range(3):
        unit = [mpmath.mpf(j == k + 1) for j in range(4)]
        columns.append([x / size for x in product(product(e, unit), conjugate)[1:]])
    return mpmath.matrix(columns).T


class Reference:
    """One motion q(t) = q + v t; expressions of positions are evaluated by Python on it."""

    def __init__(self, q: dict[str, float], v: dict[str, float]) -> None:
        self.q, self.v = q, v
        self.matrix: dict[str, Path] = {"": lambda t: mpmath.eye(3)}
        self.origin: dict[str, Path] = {"": lambda t: mpmath.zeros(3, 1)}

    def value(self, text: str, t: Any) -> Any:
        names: dict[str, Any] = {name: mpmath.mpf(x) for name, x in PARAMETERS.items()}
        names |= {name: mpmath.mpf(x) + mpmath.mpf(self.v[name]) * t for name, x in self.q.items()}
        return eval(text, {"sin": mpmath.sin, "cos": mpmath.cos, "t": t}, names)

    def vector(self, texts: list[str], t: Any) -> Any:
        return mpmath.matrix([self.value(text, t) for text in [*texts, "0"][:3]])

    def add(self, name: str, on: str, at: list[str], turned: Path) -> None:
        self.origin[name] = lambda t: self.origin[on](t) + self.matrix[on](t) * self.vector(at, t)
        self.matrix[name] = lambda t: self.matrix[on](t) * turned(t)

    def turned(self, turns: list[tuple[str, str]]) -> Path:
        def matrix(t: Any) -> Any:
            made = mpmath.eye(3)
            for axis, angle in turns:
                made = made * elementary(axis, self.value(angle, t))
            return made

        return matrix

    def carried(self, R: str) -> Path:
        """The matrix of a rotation; its quaternion may have any length."""
        return lambda t: of_quaternion(
            [mpmath.mpf(self.q[f"{R}_{k}"]) + mpmath.mpf(self.v[f"{R}_{k}"]) * t for k in range(4)]
        )

    def omega(self, body: str) -> Any:
        """On the body's axes: R^T R' = [omega]."""
        R = self.matrix[body]
        skew = R(0).T * rate(R)
        return mpmath.matrix([skew[2, 1], skew[0, 2], skew[1, 0]])

    def matter(self, body: str, place: Any) -> Any:
        """The velocity, in space, of what is fixed on a body and is at a place in space now."""
        own = self.matrix[body](0).T * (place - self.origin[body](0))
        return rate(lambda t: self.origin[body](t) + self.matrix[body](t) * own)


def rate(path: Path) -> Any:
    """d/dt at 0 of a matrix, by a central difference of order four with 60 digits."""
    h = mpmath.mpf(10) ** -10
    return (8 * (path(h) - path(-h)) - (path(2 * h) - path(-2 * h))) / (12 * h)


def spec_of(keys: str, outputs: list[str], rotations: str = "") -> System:
    text = (
        f"nhc: 1\nsystem: s\ncoordinates: [{', '.join(COORDINATES)}]\n{rotations}"
        f"parameters: {{{', '.join(f'{n}: {x}' for n, x in PARAMETERS.items())}}}\n{keys}"
        "outputs: {" + ", ".join(f"o{k}: {name}" for k, name in enumerate(outputs)) + ", kinetic: T}\n"
    )
    return resolve(decode(Source("s.yaml", text)))


def values(system: System, q: dict[str, float], v: dict[str, float]) -> list[float]:
    known = {node: q[name] for node, name in zip(system.q, system.q_names, strict=True)}
    known |= {node: v[name] for node, name in zip(system.v, system.q_names, strict=True)}
    known |= {node: PARAMETERS[p.name] for node, p in zip(system.p, system.spec.parameters, strict=True)}
    known[system.t] = 0.0
    return list(evaluate(system.graph, [node for _, node in system.outputs], known))


def draw(seed: int, names: tuple[str, ...]) -> tuple[random.Random, dict[str, float], dict[str, float]]:
    chance = random.Random(seed)
    return chance, {n: chance.uniform(-1, 1) for n in names}, {n: chance.uniform(-1, 1) for n in names}


def check(found: list[float], expected: list[Any]) -> None:
    for have, want in zip(found, expected, strict=True):
        assert have == pytest.approx(float(want), abs=1e-11, rel=1e-11)


PLACES = (["x", "y"], ["x", "y", "z"], ["a", "0", "b"], ["a + x^2".replace("^", "**"), "b*y", "0"], ["0", "0", "c"])
INERTIAS = ("A", "[A, B, C]", "[A, B, A]", "[B, A, A]", "[A, A, C]", "{xx: A, yy: B, zz: C, xz: D, xy: -D, yz: 0.2}")
ANGLES = ("p", "q", "r", "-p", "a", "p - q", "2*r + b", "0.5", "-b", "t", "3*t + p")


TREES = [*((seed, ()) for seed in range(24)), *((seed, ("R", "S")) for seed in range(12))]


@pytest.mark.parametrize(("seed", "rotations"), TREES)
def test_trees_of_bodies(seed: int, rotations: tuple[str, ...]) -> None:
    """Turns and rotations one on another, in any order."""
    mpmath.mp.dps = 60
    chance, q, v = draw(seed, (*COORDINATES, *(f"{R}_{k}" for R in rotations for k in range(4))))
    carried = {R: chance.choice(("body", "space")) for R in rotations}
    reference = Reference(q, v)
    bodies, known, outputs, expected = "bodies:\n", [""], [], []
    energy = mpmath.mpf(0)
    for k in range(chance.randint(1, 4)):
        name, on = f"b{k}", chance.choice(known)
        at = chance.choice(PLACES)
        turns = [(chance.choice("xyz"), chance.choice(ANGLES)) for _ in range(chance.randint(0, 3))]
        centre = chance.choice(PLACES)
        inertia = chance.choice(INERTIAS)
        shown, turned = f"turns: [{', '.join(f'{axis}: {angle}' for axis, angle in turns)}]", reference.turned(turns)
        if carried and chance.random() < 0.4:
            R = chance.choice(list(carried))
            shown, turned = f"rotation: {R}", reference.carried(R)
        bodies += f"  {name}: {{{f'parent: {on}, ' if on else ''}at: {listed(at)}, {shown}, mass: m, "
        bodies += f"centre: {listed(centre)}, inertia: {inertia}}}\n"
        reference.add(name, on, at, turned)
        known.append(name)
        omega, R = reference.omega(name), reference.matrix[name]
        middle = rate(
            lambda t, n=name, c=centre: reference.origin[n](t) + reference.matrix[n](t) * reference.vector(c, t)
        )
        J = tensor(inertia)
        energy += (PARAMETERS["m"] * (middle.T * middle)[0] + (omega.T * J * omega)[0]) / 2
        outputs += [f"{name}_{x}" for x in "xyz"] + [f"{name}_{x}{j}" for x in "xyz" for j in "123"]
        outputs += [f"{name}_w{j}" for j in "123"]
        expected += [*reference.origin[name](0), *R(0), *omega]
    bodies += "points:\n"
    for k in range(3):
        on, of, at = chance.choice(known), chance.choice(known[1:]), chance.choice(PLACES)
        bodies += f"  s{k}: {{{f'parent: {on}, ' if on else ''}of: {of}, at: {listed(at)}}}\n"
        place = reference.origin[on](0) + reference.matrix[on](0) * reference.vector(at, mpmath.mpf(0))
        moved = reference.matter(of, place)
        outputs += [f"s{k}_{x}" for x in "xyz"] + [f"s{k}_v{x}" for x in "xyz"]
        expected += [*place, *moved]
        if on:
            outputs += [f"s{k}_v{j}" for j in "123"]
            expected += [*(reference.matrix[on](0).T * moved)]
    bodies += "T: " + " + ".join(f"{n}'^2" for n in COORDINATES) + "\n"
    own = sum(mpmath.mpf(v[n]) ** 2 for n in COORDINATES)
    declared = "".join(f"  {R}: {{frame: {frame}}}\n" for R, frame in carried.items())
    system = spec_of(bodies, outputs, f"rotation:\n{declared}" if declared else "")
    check(values(system, q, v), [*expected, energy + own])


def listed(at: list[str]) -> str:
    return "[" + ", ".join(at).replace("**", "^") + "]"


def tensor(inertia: str) -> Any:
    A, B, C, D = (mpmath.mpf(PARAMETERS[n]) for n in "ABCD")
    tenth = mpmath.mpf("0.2")
    return {
        "A": mpmath.diag([A, A, A]),
        "[A, B, C]": mpmath.diag([A, B, C]),
        "[A, B, A]": mpmath.diag([A, B, A]),
        "[B, A, A]": mpmath.diag([B, A, A]),
        "[A, A, C]": mpmath.diag([A, A, C]),
    }.get(inertia, mpmath.matrix([[A, -D, D], [-D, B, tenth], [D, tenth, C]]))


@pytest.mark.parametrize("frame", ["body", "space"])
@pytest.mark.parametrize("nested", [False, True])
@pytest.mark.parametrize("inertia", ["[A, B, C]", "A", "[A, B, A]"])
def test_bodies_by_quaternions_have_the_energy_of_their_matter(frame: str, nested: bool, inertia: str) -> None:
    """A body by quaternion in space or on a turned one, round about the last axis of that or not, its quaternion of any length."""
    mpmath.mp.dps = 60
    names = (*COORDINATES, "R_0", "R_1", "R_2", "R_3")
    _, q, v = draw(7 + nested, names)
    reference = Reference(q, v)
    reference.add("base", "", ["x", "y", "z"], reference.turned([("z", "p"), ("y", "q")]))
    matrix, on = reference.carried("R"), "base" if nested else ""
    reference.add("top", on, ["a", "0", "b"], matrix)
    bodies = "bodies:\n  base: {at: [x, y, z], turns: [z: p, y: q], mass: m}\n"
    place = "parent: base, " if nested else ""
    bodies += f"  top: {{{place}at: [a, 0, b], rotation: R, mass: m, centre: [0, c, 0], inertia: {inertia}}}\n"
    bodies += "points: {s: {parent: top, at: [a, b, c]}, k: {parent: base, of: top, at: [r, 0, b]}}\n"
    bodies += "T: " + " + ".join(f"{n}'^2" for n in COORDINATES) + "\n"
    omega = reference.omega("top")
    middle = rate(
        lambda t: reference.origin["top"](t) + matrix_of(reference, t) * mpmath.matrix([0, PARAMETERS["c"], 0])
    )
    base = rate(reference.origin["base"])
    J = tensor(inertia)
    energy = (PARAMETERS["m"] * ((middle.T * middle)[0] + (base.T * base)[0]) + (omega.T * J * omega)[0]) / 2
    energy += sum(mpmath.mpf(v[n]) ** 2 for n in COORDINATES)
    outputs = [f"top_w{j}" for j in "123"] + [f"s_v{x}" for x in "xyz"] + [f"k_v{x}" for x in "123"]
    tip = reference.origin["top"](0) + reference.matrix["top"](0) * reference.vector(["a", "b", "c"], 0)
    low = reference.origin["base"](0) + reference.matrix["base"](0) * reference.vector(["r", "0", "b"], 0)
    expected = [*omega, *reference.matter("top", tip), *(reference.matrix["base"](0).T * reference.matter("top", low))]
    system = spec_of(bodies, outputs, f"rotation: {{R: {{frame: {frame}}}}}\n")
    check(values(system, q, v), [*expected, energy])


def matrix_of(reference: Reference, t: Any) -> Any:
    return reference.matrix["top"](t)


@pytest.mark.parametrize("seed", range(6))
def test_forces_do_the_work_of_their_points(seed: int) -> None:
    """Q_i = F dw/dq_i' for a force on a position or on a velocity, against differences of the point's velocity."""
    mpmath.mp.dps = 60
    _, q, v = draw(100 + seed, COORDINATES)
    keys = (
        "bodies: {one: {at: [x, y, z], turns: [z: p, x: q], mass: m}, two: {parent: one, turns: [y: r + t], inertia: A}}\n"
        "points: {s: {parent: two, at: [a, b, c*x]}, k: {parent: one, of: two, at: [0, a, y]}}\n"
        "forces: {s_x: 2, s_z: -a, k_v2: 3, two_w3: b, x: 5}\n"
        "T: " + " + ".join(f"{n}'^2" for n in COORDINATES) + "\n"
    )
    system = spec_of(keys, ["1"])

    def powers(rates: dict[str, float]) -> Any:
        reference = Reference(q, rates)
        reference.add("one", "", ["x", "y", "z"], reference.turned([("z", "p"), ("x", "q")]))
        reference.add("two", "one", ["0", "0"], reference.turned([("y", "r + t")]))
        moving = rate(
            lambda t: reference.origin["two"](t) + reference.matrix["two"](t) * reference.vector(["a", "b", "c*x"], t)
        )
        low = reference.origin["one"](0) + reference.matrix["one"](0) * reference.vector(["0", "a", "y"], 0)
        slip = reference.matrix["one"](0).T * reference.matter("two", low)
        work = 2 * moving[0] - PARAMETERS["a"] * moving[2] + 3 * slip[1] + PARAMETERS["b"] * reference.omega("two")[2]
        return work + 5 * rates["x"]

    still = powers(dict.fromkeys(COORDINATES, 0.0))
    expected = [powers({n: float(n == name) for n in COORDINATES}) - still for name in COORDINATES]
    known = {node: q[name] for node, name in zip(system.q, system.q_names, strict=True)}
    known |= {node: v[name] for node, name in zip(system.v, system.q_names, strict=True)}
    known |= {node: PARAMETERS[p.name] for node, p in zip(system.p, system.spec.parameters, strict=True)}
    check(list(evaluate(system.graph, list(system.Q), {**known, system.t: 0.0})), expected)
