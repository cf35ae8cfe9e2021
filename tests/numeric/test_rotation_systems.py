"""Systems of rotations as users may write them: random ones, constraints on angular velocities, chains of bodies."""

from __future__ import annotations

import math
import random
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.pipeline import Options, check, emit
from tests.support import error, python_model


def random_system(seed: int) -> str:
    """One or two rotations on either axes, moving points, mixed constraints, torques: what the language lets one write."""
    rng = random.Random(seed)
    coordinates = rng.sample(["x", "y", "z"], rng.randint(0, 2))
    names = ["A", "B"][: rng.choice([1, 1, 2])]
    w = [f"{name.lower()}{i}" for name in names for i in (1, 2, 3)]

    def entry() -> str:
        return f"{rng.choice(names)}_{rng.choice('xyz')}{rng.choice('123')}"

    def point() -> str:
        terms = [f"{rng.randint(1, 5)}/7*{entry()}" for _ in range(rng.randint(1, 2))]
        return " + ".join(terms + ([rng.choice(coordinates)] if coordinates and rng.random() < 0.6 else []))

    def constraint() -> str:
        kind = rng.randrange(3)
        if kind == 0:
            return f"{rng.choice(w)} + {entry()}*{rng.choice(w)}/2 = 0"
        if kind == 1:
            return f"({point()})' = {entry()}*{rng.choice(w)}"
        return f"{entry()}*{rng.choice(w)} - {entry()}*{rng.choice(w)} = {rng.choice(['0', '1', 'sin(t)'])}"

    squares = [f"{rng.randint(1, 6)}/5*{x}^2" for x in w] + [f"{rng.randint(1, 4)}/3*{c}'^2" for c in coordinates]
    squares += [f"({point()})'^2/3" for _ in range(rng.randint(0, 2))] + [f"{rng.choice(w)}*{entry()}/4"]
    held = [constraint() for _ in range(rng.randint(0, 1 + len(coordinates)))]
    lines = [
        "nhc: 1\nsystem: random_rotations",
        *([f"coordinates: [{', '.join(coordinates)}]"] if coordinates else []),
        "rotation:",
        *(
            f"  {name}: {{velocities: [{', '.join(w[3 * k : 3 * k + 3])}], frame: {rng.choice(['body', 'space'])}}}"
            for k, name in enumerate(names)
        ),
        f"parameters: {{g: 2}}\nT: {' + '.join(squares)}\nV: g*({entry()}*{entry()} + 3*{entry()})",
        f"forces: {{{rng.choice(w)}: {entry()} - {rng.choice(w)}/3}}",
        *(["constraints:", *(f"  - {text}" for text in held)] if held else []),
    ]
    return "\n".join(lines)


@pytest.mark.sample(2)
@pytest.mark.parametrize("seed", range(8))
def test_random_systems_agree_in_every_formulation(seed: int) -> None:
    assert certify(resolve(decode(Source("s.yaml", random_system(seed))))).holds


# --- constraints on angular velocities ---------------------------------------------------------------------

TWIST = """
nhc: 1
system: no_twist
rotation: {{R: {{velocities: [w1, w2, w3], frame: {frame}}}}}
T: (w1^2 + 2*w2^2 + 3*w3^2)/2
constraints: [{row} = 0]
scenes: {{s: {{time: [0, 1], initial: {{R: {{axis: [1, 0, 0], angle: {angle}}}, w1: 1}}}}}}
"""
JOINT = """
nhc: 1
system: joint
rotation: {A: {velocities: [a1, a2, a3]}, B: {velocities: [b1, b2, b3]}}
T: a1^2 + 2*a2^2 + 3*a3^2 + b1^2 + 3*b2^2 + 2*b3^2
V: A_z3
holonomic: [A_x3*B_x1 + A_y3*B_y1 + A_z3*B_z1 = 0]
scenes: {s: {time: [0, 1], initial: {a1: 1, b3: 1}}}
"""
ROW = "R_z1*w1 + R_z2*w2 + R_z3*w3"
OBLIQUE = "R_z1*w1 + 2*R_z2*w2 + R_z3*w3"  # along no axis of space


def kept(text: str) -> list[str]:
    """The velocities that the model keeps, at whose start it must be regular."""
    (source,) = emit(Source("s.yaml", text), "python").values()
    model = python_model(source, f"kept_{abs(hash(text))}")
    system = resolve(decode(Source("s.yaml", text)))
    start = start_of(system, system.spec.scenes[0])
    assert all(math.isfinite(x) for x in model.rhs(0.0, model.state(0.0, start.q, start.v)))
    return list(model.STATE[len(model.COORDINATES) :])


def test_constraints_take_the_angular_velocity_that_they_determine_at_the_start() -> None:
    assert kept(TWIST.format(frame="body", row=OBLIQUE, angle="0.1")) == ["w1", "w2"]
    assert kept(TWIST.format(frame="body", row=OBLIQUE, angle="pi/2")) == ["w1", "w3"]
    assert kept(TWIST.format(frame="space", row="w3", angle="pi/2")) == ["w1", "w2"]
    assert kept(JOINT) == ["a1", "a2", "a3", "b1", "b3"]
    assert certify(resolve(decode(Source("s.yaml", JOINT)))).holds


@pytest.mark.parametrize(("frame", "row"), [("body", ROW), ("space", "R_x3*w1 + R_y3*w2 + R_z3*w3")])
def test_a_component_on_the_other_axes_leaves_the_two_beside_it_free(frame: str, row: str) -> None:
    """Veselova's constraint: two components on the spec's axes are singular somewhere, those on the others nowhere."""
    text = TWIST.format(frame=frame, row=row, angle="0.1").replace("T: ", "V: R_x1 + 2*R_y3 - R_z2*R_z3\nT: ")
    assert kept(text) == ["v", "v2"]
    assert not check(Source("s.yaml", text)).diagnostics
    models = [
        python_model(
            next(iter(emit(Source("s.yaml", text), "python", Options(formulation=name)).values())), f"{frame}_{name}"
        )
        for name in ("", "multipliers")
    ]
    rng = np.random.default_rng(7)
    for turn in (
        Rotation.from_euler("x", 90, degrees=True),
        Rotation.from_euler("y", 90, degrees=True),
        *Rotation.random(20, 7),
    ):
        e = np.roll(turn.as_quat(), 1)
        matrix = turn.as_matrix()
        axis = matrix[2] if frame == "body" else matrix[:, 2]
        w = np.cross(axis, rng.normal(size=3))
        a, (b, c, d) = e[0], e[1:]
        side = 1 if frame == "body" else -1
        rows = np.array([[-b, -c, -d], [a, -side * d, side * c], [side * d, a, -side * b], [-side * c, side * b, a]])
        v = 0.5 * rows @ w
        found = [model.accelerations(0.0, model.state(0.0, e, v)) for model in models]
        assert found[0] == pytest.approx(found[1], rel=1e-11, abs=1e-12)


BLADE = """
nhc: 1
system: blade
rotation: {{R: {{velocities: [p, q, r]}}}}
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2 + p^2 + 2*q^2 + 3*r^2)/2
constraints: [{rows}]
scenes: {{s: {{time: [0, 1], initial: {{R: {{axis: {axis}, angle: pi/2}}, q: 1}}}}}}
"""
ACROSS, ALONG = (f"x'*R_x{k} + y'*R_y{k} + z'*R_z{k} = 0" for k in (2, 1))


@pytest.mark.parametrize(
    ("rows", "axis", "free"),
    [
        (ACROSS, "[0, 1, 0]", ["x'", "z'"]),  # y' is determined
        (ACROSS, "[0, 0, 1]", ["y'", "z'"]),
        (ACROSS, "[1, 0, 0]", ["x'", "y'"]),
        (f"{ACROSS}, {ALONG}", "[0, 0, 1]", ["z'"]),
        (f"{ACROSS}, {ALONG}", "[1, 0, 0]", ["y'"]),
        (f"{ACROSS}, p = y'", "[0, 0, 1]", ["z'"]),
    ],
)
def test_constraints_take_the_other_velocities_that_they_determine_at_the_start(
    rows: str, axis: str, free: list[str]
) -> None:
    """The rate R_z2 of the third coordinate alone would be singular at all starts but one."""
    found = kept(BLADE.format(rows=rows, axis=axis))
    assert [name for name in found if name not in "pqr"] == free


def test_a_start_where_the_coframe_is_singular_keeps_its_digits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """With starts at which different components are determined, the run changes over, from the start as it was given."""
    text = TWIST.format(frame="body", row=OBLIQUE, angle="0") + (
        "  turned: {time: [0, 5], initial: {R: {axis: [1, 0, 0], angle: pi/2}, w1: 1, w3: 0.3}}\n"
    )
    path = tmp_path / "no_twist.yaml"
    path.write_text(text.replace("scenes: {s: ", "scenes:\n  s: ").replace("w1: 1}}}", "w1: 1}}", 1))
    ends = []
    for formulation in ((), ("-f", "multipliers")):
        wanted = ("--need", "w1,w2,w3,energy", "--points", "2", "--tol", "1e-10")
        assert main(["run", str(path), "--scene", "turned", *wanted, *formulation]) == 0
        captured = capsys.readouterr()
        assert formulation or "the run goes on with euler-lagrange with w1, w3" in captured.err
        rows = [[float(x) for x in line.split(",")[1:]] for line in captured.out.splitlines()[1:]]
        assert rows[0] == pytest.approx([1.0, 0.0, 0.3, 0.635], abs=1e-13)
        ends.append(rows[-1])
    assert ends[0] == pytest.approx(ends[1], abs=1e-8)


# --- several bodies ----------------------------------------------------------------------------------------


def chain(bodies: int, joints: bool) -> str:
    """A chain of rods: centres of mass by definitions, or as coordinates held by joints."""
    kinetic, potential, lines = [], [], []
    for k in range(1, bodies + 1):
        for c in "xyz":
            before = f"{c}{k - 1} - a*R{k - 1}_{c}3" if k > 1 else "0"
            lines.append(f"  - {c}{k} = {before} - a*R{k}_{c}3" if joints else f"  {c}{k}: {before} - a*R{k}_{c}3")
        kinetic.append(f"m/2*(x{k}'^2 + y{k}'^2 + z{k}'^2) + J/2*(p{k}^2 + q{k}^2) + C/2*r{k}^2")
        potential.append(f"m*g*z{k}")
    coordinates = ", ".join(f"{c}{k}" for k in range(1, bodies + 1) for c in "xyz")
    return "\n".join(
        [
            f"nhc: 1\nsystem: chain_{'held' if joints else 'free'}",
            *([f"coordinates: [{coordinates}]"] if joints else []),
            "rotation:",
            *(f"  R{k}: {{velocities: [p{k}, q{k}, r{k}]}}" for k in range(1, bodies + 1)),
            "parameters: {m: 1, a: 0.5, g: 9.81, J: 0.1, C: 0.02}",
            "holonomic:" if joints else "define:",
            *lines,
            f"T: {' + '.join(kinetic)}",
            f"V: {' + '.join(potential)}",
        ]
    )


def test_a_chain_by_definitions_is_one_held_by_joints() -> None:
    """The kept velocities are the angular ones in both; the joints only add coordinates and reactions."""
    rng, models = random.Random(8), []
    for joints in (False, True):
        (text,) = emit(Source("chain.yaml", chain(3, joints)), "python", Options()).values()
        models.append(python_model(text, f"chain_{joints}"))
    free, held = models
    for _ in range(3):
        e = [rng.uniform(-1, 1) for _ in range(12)]
        w = [rng.uniform(-1, 1) for _ in range(9)]
        place, centres = np.zeros(3), []
        for k in range(3):
            axis = Rotation.from_quat(np.roll(e[4 * k : 4 * k + 4], -1)).as_matrix()[:, 2]
            centres += list(place - 0.5 * axis)
            place = place - axis
        y, z = [*e, *w], [*centres, *e, *w]
        assert (
            error(held.positions(0.0, z[:21]), [0.0] * 9 + [np.dot(e[i : i + 4], e[i : i + 4]) - 1 for i in (0, 4, 8)])
            < 1e-14
        )
        assert error(held.rhs(0.0, z)[21:], free.rhs(0.0, y)[12:]) < 1e-12
        assert held.energy(0.0, z) == pytest.approx(free.energy(0.0, y), rel=1e-13)
