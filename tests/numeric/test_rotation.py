"""Systems with rotations: against Euler's equations, against their twins in Euler's angles, through what locks those."""

from __future__ import annotations

import json
import math
import random
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.flow import flow_of
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.linearize import cyclic_of
from nhc.mechanics.properties.symmetry import symmetries_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import kept_velocities, start_of
from nhc.pipeline import Options, check, emit
from tests.support import ROOT, c_model, emitted_python, error, formulations, python_model, spec_path

GALLERY = ("free_rigid_body_quaternion", "heavy_top_quaternion", "chaplygin_ball_quaternion")
TWO = ROOT / "tests" / "specs" / "two_rotations.yaml"
Vector = Sequence[float]


def matrix(e: Vector) -> Any:
    """R of a quaternion of any length, its scalar part first."""
    return Rotation.from_quat([*e[1:], e[0]]).as_matrix()


def hat(w: Vector) -> Any:
    return np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])


def from_angles(angles: Vector) -> list[float]:
    """The quaternion of Euler's angles zxz, scalar part first."""
    x, y, z, w = Rotation.from_euler("ZXZ", angles).as_quat()
    return [w, x, y, z]


def euler(inertia: Vector, torque: Callable[[Any, Any], Any], R: Any, w: Vector, end: float) -> tuple[Any, Any]:
    """R and w at the end, by Euler's equations and R' = R [w]: no quaternion, and nothing of nhc's."""
    moments = np.array(inertia)

    def rates(t: float, y: Any) -> Any:
        now, turning = y[:9].reshape(3, 3), y[9:]
        turned = (np.cross(moments * turning, turning) + torque(now, turning)) / moments
        return np.concatenate([(now @ hat(turning)).ravel(), turned])

    found = solve_ivp(rates, (0.0, end), np.concatenate([R.ravel(), w]), method="DOP853", rtol=1e-13, atol=1e-14)
    return found.y[:9, -1].reshape(3, 3), found.y[9:, -1]


def integrate(model: ModuleType, y: Vector, end: float) -> list[float]:
    found = solve_ivp(model.rhs, (0.0, end), y, method="DOP853", rtol=1e-13, atol=1e-14)
    assert found.success
    return [float(x) for x in found.y[:, -1]]


# --- the formulations agree -------------------------------------------------------------------------------


def test_two_rotations_under_constraints_and_torques_agree_in_every_formulation() -> None:
    """Body and space axes, moving points, torques, forces of time, constraints that mix all of them."""
    certificate = certify(resolve(decode(read(str(TWO)))))
    assert certificate.holds
    assert {a.name for a in certificate.agreements} == {"multipliers", "euler-lagrange", "voronec"}


@pytest.mark.parametrize("name", GALLERY)
def test_quaternions_of_any_length_are_one_motion(name: str) -> None:
    """In every formulation: a longer quaternion has longer rates; velocities, energy and outputs do not notice."""
    rng = random.Random(5)
    for formulation in formulations(name):
        model = emitted_python(name, formulation)
        e = [k for k, c in enumerate(model.COORDINATES) if c.startswith("R_")]
        q = [rng.uniform(-1, 1) for _ in model.COORDINATES]
        kept = emitted_python(name, "euler-lagrange")
        w = [rng.uniform(-1, 1) for _ in range(len(kept.STATE) - len(q))]
        v = kept.velocities(0.0, [*q, *w])
        longer = [3.7 * x if k in e else x for k, x in enumerate(q)]
        faster = [3.7 * x if k in e else x for k, x in enumerate(v)]
        y, z = model.state(0.0, q, v), model.state(0.0, longer, faster)
        assert error(model.residuals(0.0, q, v), [0.0] * len(model.CONSTRAINTS)) < 1e-14
        scaled = [3.7 * x if k in e else x for k, x in enumerate(model.accelerations(0.0, y))]
        assert error(model.accelerations(0.0, z), scaled) < 1e-13
        assert error(model.outputs(0.0, z), model.outputs(0.0, y)) < 1e-14
        assert error([model.energy(0.0, z)], [model.energy(0.0, y)]) < 1e-14
        norm = model.CONSTRAINTS.index("R_norm")
        assert abs(model.reactions(0.0, y)[norm]) < 1e-13


# --- Euler's equations ------------------------------------------------------------------------------------


def test_the_free_body_is_eulers() -> None:
    model, rng = emitted_python("free_rigid_body_quaternion"), random.Random(2)
    assert model.STATE == ("R_0", "R_1", "R_2", "R_3", "w1", "w2", "w3")
    for _ in range(5):
        e, w = [rng.uniform(-2, 2) for _ in range(4)], [rng.uniform(-2, 2) for _ in range(3)]
        rates = model.rhs(0.0, [*e, *w])
        I = (1.0, 2.0, 3.0)  # noqa: E741
        turned = [(I[(k + 1) % 3] - I[(k + 2) % 3]) * w[(k + 1) % 3] * w[(k + 2) % 3] / I[k] for k in range(3)]
        assert error(rates[4:], turned) < 1e-15
        assert abs(np.dot(rates[:4], e)) < 1e-15 * np.dot(e, e) * 10


def test_runs_are_those_of_eulers_equations() -> None:
    w = [0.3648422012815879, 0.2897762197704170, 1.0814384485702310]
    R, turned = euler([1, 2, 3], lambda R, w: np.zeros(3), matrix(from_angles([0.3, 1.1, 0.2])), w, 20.0)
    y = integrate(emitted_python("free_rigid_body_quaternion"), [*from_angles([0.3, 1.1, 0.2]), *w], 20.0)
    assert error(y[4:], turned) < 1e-10 and np.max(np.abs(matrix(y[:4]) - R)) < 1e-10
    assert abs(np.dot(y[:4], y[:4]) - 1.0) < 1e-11

    start = Rotation.from_rotvec([0.5, 0.0, 0.0]).as_matrix()
    R, turned = euler([1, 1, 1.5], lambda R, w: 2.0 * np.cross(R[2], [0.0, 0.0, 1.0]), start, [0.0, 0.0, 3.0], 10.0)
    y = integrate(emitted_python("heavy_top_quaternion"), [math.cos(0.25), math.sin(0.25), 0, 0, 0, 0, 3], 10.0)
    assert error(y[4:], turned) < 1e-10 and np.max(np.abs(matrix(y[:4]) - R)) < 1e-10


def test_the_ball_is_chaplygins() -> None:
    """K' = K x w on the body's axes, K = (diag I + m a^2 (1 - n n^T)) w."""
    inertia = np.diag([0.4, 0.5, 0.7])

    def rates(t: float, y: Any) -> Any:
        R, K = y[:9].reshape(3, 3), y[9:12]
        n = R[2]
        w = np.linalg.solve(inertia + np.eye(3) - np.outer(n, n), K)
        turning = R @ w
        return np.concatenate([(R @ hat(w)).ravel(), np.cross(K, w), [turning[1], -turning[0]]])

    e, w = from_angles([0.1, 1.0, 0.3]), [0.6, -0.4, 1.1]
    R = matrix(e)
    K = (inertia + np.eye(3) - np.outer(R[2], R[2])) @ w
    there = solve_ivp(rates, (0, 5), np.concatenate([R.ravel(), K, [0, 0]]), method="DOP853", rtol=1e-13, atol=1e-14)
    y = integrate(emitted_python("chaplygin_ball_quaternion"), [0.0, 0.0, *e, *w], 5.0)
    assert error(y[:2], there.y[12:, -1]) < 1e-10
    assert np.max(np.abs(matrix(y[2:6]) - there.y[:9, -1].reshape(3, 3))) < 1e-10


# --- the twins in Euler's angles --------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "places"), [("free_rigid_body", 0), ("chaplygin_ball", 2)])
def test_the_same_rates_as_in_angles(name: str, places: int) -> None:
    angles, quaternion, rng = emitted_python(name), emitted_python(f"{name}_quaternion"), random.Random(9)
    for _ in range(8):
        q, w = [rng.uniform(0.2, 2.9) for _ in range(places + 3)], [rng.uniform(-2, 2) for _ in range(3)]
        by_angles, by_quaternion = [*q, *w], [*q[:places], *from_angles(q[places:]), *w]
        there, here = angles.rhs(0.0, by_angles), quaternion.rhs(0.0, by_quaternion)
        assert error(here[:places], there[:places]) < 1e-13
        assert error(here[-3:], there[-3:]) < 1e-12
        assert quaternion.energy(0.0, by_quaternion) == pytest.approx(angles.energy(0.0, by_angles), rel=1e-13)
        h = 1e-6  # e' along the twin's motion
        moved = [[x + s * h * r for x, r in zip(q[places:], there[places:], strict=False)] for s in (1, -1)]
        slope = [(a - b) / (2 * h) for a, b in zip(*(from_angles(m) for m in moved), strict=True)]
        assert error(here[places : places + 4], slope) < 1e-8


def test_the_tops_run_together() -> None:
    angles, quaternion = emitted_python("heavy_top"), emitted_python("heavy_top_quaternion")
    y = integrate(angles, angles.state(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 3.0]), 10.0)
    z = integrate(quaternion, [*from_angles([0.0, 0.5, 0.0]), 0.0, 0.0, 3.0], 10.0)
    assert np.max(np.abs(matrix(from_angles(y[:3])) - matrix(z[:4]))) < 1e-9


# --- no lock ----------------------------------------------------------------------------------------------


def test_through_the_lock(capsys: pytest.CaptureFixture[str]) -> None:
    """The body passes theta = 0 at t = 1: with angles that is refused, with a quaternion it is a place like any other."""
    assert main(["run", str(spec_path("free_rigid_body_quaternion")), "--scene", "lock", "--points", "3"]) == 0
    rows = [[float(x) for x in line.split(",")] for line in capsys.readouterr().out.splitlines()[1:]]
    for t, *e in rows:
        assert np.max(np.abs(matrix(e) - Rotation.from_rotvec([1.0 - t, 0.0, 0.0]).as_matrix())) < 1e-9
        assert sum(x * x for x in e) == pytest.approx(1.0, abs=1e-15)


def test_every_orientation_costs_the_same() -> None:
    """Evaluations of a run do not depend on where the body is, nor on how near it passes to anything."""
    model, counts = emitted_python("free_rigid_body_quaternion"), []
    for e in ([1, 0, 0, 0], from_angles([0, 1, 0]), from_angles([0.3, 1e-9, 2.0]), [0.1, -0.7, 0.2, 0.6]):
        e = [x / math.dist(e, [0.0] * 4) for x in e]
        found = solve_ivp(model.rhs, (0, 5), [*e, 1.0, -0.4, 0.3], method="DOP853", rtol=1e-10, atol=1e-10)
        counts.append(found.nfev)
    assert max(counts) <= 1.3 * min(counts)


@pytest.mark.parametrize("name", ["free_rigid_body", "heavy_top", "chaplygin_ball"])
def test_a_quaternion_costs_no_more_than_angles(name: str) -> None:
    """No function is called; all operations together are fewer than those in angles with 20 for a sine or cosine."""
    angles, quaternion = (operations(n) for n in (name, f"{name}_quaternion"))
    assert quaternion[3] == 0
    assert sum(quaternion[:3]) <= sum(angles[:3]) + 20 * angles[3]


def operations(name: str) -> list[int]:
    """Sums, products, divisions and calls of a right-hand side, from its header."""
    header = emit(read(str(spec_path(name))), "c", Options(only=("rhs",)))[f"{name}.h"]
    found = re.search(r"rhs: (\d+) \+-, (\d+) \*, (\d+) /, (\d+) calls", header)
    assert found is not None
    return [int(x) for x in found.groups()]


# --- emitted code -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", GALLERY)
def test_c_is_python(name: str, tmp_path: Path) -> None:
    python, c = emitted_python(name, "euler-lagrange"), c_model(name, "euler-lagrange", tmp_path)
    rng = random.Random(3)
    y = [rng.uniform(-1, 1) for _ in python.STATE]
    p = c.defaults(len(python.PARAMETERS))
    assert error(c("rhs", len(y), 0.0, y, p), python.rhs(0.0, y)) < 1e-14
    assert error(c("outputs", len(python.OUTPUTS), 0.0, y, p), python.outputs(0.0, y)) < 1e-14
    assert error(c("positions", 1, 0.0, y[: len(python.COORDINATES)], p), python.positions(0.0, y)) < 1e-14


def test_a_quaternion_that_is_zero_is_refused(tmp_path: Path) -> None:
    name = "heavy_top_quaternion"
    python, c = emitted_python(name), c_model(name, "", tmp_path)
    y = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]
    with pytest.raises(ArithmeticError):
        c("rhs", 7, 0.0, y, c.defaults(3))
    with pytest.raises(ArithmeticError):
        python.rhs(0.0, y)


# --- starts -----------------------------------------------------------------------------------------------

STARTS = {
    "[1, 2, -1, 0.5]": Rotation.from_quat([2, -1, 0.5, 1]),
    "{axis: [1, 2, -2], angle: 0.7}": Rotation.from_rotvec(0.7 * np.array([1, 2, -2]) / 3),
    "{axis: [0, 0, c], angle: c*pi}": Rotation.from_rotvec([0, 0, 0.3 * math.pi]),
    "{order: zxz, angles: [0.3, 1.1, 0.2]}": Rotation.from_euler("ZXZ", [0.3, 1.1, 0.2]),
    "{order: xyx, angles: [0.3, c, 0.2]}": Rotation.from_euler("XYX", [0.3, 0.3, 0.2]),
    "{order: yxz, angles: [-0.3, 1.1, 2]}": Rotation.from_euler("YXZ", [-0.3, 1.1, 2]),
    "{yaw: 0.3, pitch: -0.4, roll: 1}": Rotation.from_euler("ZYX", [0.3, -0.4, 1]),
    "{pitch: -0.4}": Rotation.from_euler("Y", -0.4),
    "{order: zxz, angles: [0, 0, 0]}": Rotation.identity(),
    "": Rotation.identity(),
}


@pytest.mark.parametrize("text", STARTS, ids=lambda text: text or "left out")
def test_a_rotation_starts_as_each_form_of_its_start_says(text: str) -> None:
    initial = f"{{R: {text}, a2: 1.5}}" if text else "{a2: 1.5}"
    spec = f"""
nhc: 1
system: s
rotation: {{R: {{velocities: [a1, a2, a3]}}}}
parameters: {{c: 0.3}}
T: a1^2 + a2^2 + a3^2
scenes: {{s: {{time: [0, 1], initial: {initial}}}}}
"""
    system = resolve(decode(Source("s.yaml", spec)))
    start = start_of(system, system.spec.scenes[0])
    assert math.dist(start.q, [0.0] * 4) == pytest.approx(1.0, abs=1e-15)
    assert np.max(np.abs(matrix(start.q) - STARTS[text].as_matrix())) < 1e-14
    e, v = start.q, start.v
    about_first = 2 * (e[0] * v[1] - e[1] * v[0] + e[3] * v[2] - e[2] * v[3])
    about_second = 2 * (e[0] * v[2] - e[2] * v[0] + e[1] * v[3] - e[3] * v[1])
    assert (about_first, about_second) == pytest.approx((0.0, 1.5), abs=1e-14)


def test_a_ball_whose_velocity_alone_is_given_starts_without_spin_in_every_orientation() -> None:
    """Not with the spin at which some entries of the quaternion would rest."""
    spec = """
nhc: 1
system: s
rotation: {R: {velocities: [wx, wy, wz], frame: space}}
coordinates: [x, y]
T: x'^2 + y'^2 + wx^2 + wy^2 + wz^2
constraints: ["x' - wy = 0", "y' + wx = 0"]
scenes: {s: {time: [0, 1], initial: {R: {axis: [1, 2, 0], angle: 0.5}, x': 1}}}
"""
    system = resolve(decode(Source("s.yaml", spec)))
    start = start_of(system, system.spec.scenes[0])
    assert kept_velocities(system, system.quasi, start) == pytest.approx([0.0, 1.0, 0.0], abs=1e-15)


# --- torques, and what the studies make of it ---------------------------------------------------------------

TORQUE = """
nhc: 1
system: pushed
rotation: {{R: {{velocities: [p, q, r], frame: {frame}}}}}
parameters: {{A: 2, B: 3}}
T: A*(p^2 + q^2 + r^2)/2 + B*(R_x1')^2/2
forces: {{p: 0.7 - q, r: R_z3}}
"""


@pytest.mark.parametrize("frame", ["body", "space"])
def test_torques_do_their_work(frame: str) -> None:
    """d(T + V)/dt = M w, in every formulation."""
    source = Source("s.yaml", TORQUE.format(frame=frame))
    y = [0.9, 0.1, -0.3, 0.2, 0.4, -1.1, 0.6]
    w: Callable[[Vector], tuple[float, ...]] = lambda y: tuple(y[4:])  # noqa: E731
    (text,) = emit(source, "python").values()
    kept = python_model(text, f"pushed_{frame}")
    for formulation in ("euler-lagrange", "multipliers", "voronec"):
        (text,) = emit(source, "python", Options(formulation=formulation)).values()
        model = python_model(text, f"pushed_{frame}_{formulation.replace('-', '_')}")
        state = model.state(0.0, y[:4], kept.velocities(0.0, y))
        rates, h = model.rhs(0.0, state), 1e-6
        moved = [[x + s * h * r for x, r in zip(state, rates, strict=True)] for s in (1, -1)]
        power = (model.energy(0.0, moved[0]) - model.energy(0.0, moved[1])) / (2 * h)
        p, q, r = w(y)
        assert power == pytest.approx((0.7 - q) * p + matrix(y[:4])[2][2] * r, rel=1e-8)


def test_an_equilibrium_on_the_sphere(capsys: pytest.CaptureFixture[str]) -> None:
    """The top hung up: two pairs of frequency sqrt(mgl/I1), the length of the quaternion left out."""
    spec = str(spec_path("heavy_top_quaternion"))
    assert main(["linearize", spec, "--about", "R_0=0, R_1=1", "--json"]) == 0
    out = capsys.readouterr().out
    assert out.count(f"{math.sqrt(2.0):.10f}"[:11]) >= 2


def linearised(capsys: pytest.CaptureFixture[str], *arguments: str) -> Any:
    assert main(["linearize", *arguments, "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_the_sleeping_top(capsys: pytest.CaptureFixture[str]) -> None:
    """(I3 w3)^2 = 4 I1 mgl, found upright, where the angles lock; one turn of space goes with the motion."""
    spec = str(spec_path("heavy_top_quaternion"))
    found = linearised(capsys, spec, "--about", "w3=1.5", "--sweep", "w3=1.5:2.5:5")
    assert found["state"]["w3"] == 1.5 and found["kind"] == "steady motion" and found["turns"] == 1
    (crossing,) = found["crossings"]
    assert crossing["value"] == pytest.approx(math.sqrt(32 / 9), abs=1e-9) and not crossing["up"]
    # u'' = i w3 u' (2 I1 - I3)/I1 + ... seen from the body: roots of the sleeping top's quadratic, shifted by its own turn
    growth = math.sqrt(4 * 2.0 - (1.5 * 1.5) ** 2) / 2
    assert max(x["real"] for x in found["eigenvalues"]) == pytest.approx(growth, rel=1e-9)


def test_steady_precession_is_that_of_the_angles(capsys: pytest.CaptureFixture[str]) -> None:
    """At the same tilt and spin: the same nutation, and as many directions of the family."""
    about = ("--about", "reference")
    here = linearised(capsys, str(spec_path("heavy_top_quaternion")), *about, "--hold", "height", "--hold", "w3=3")
    there = linearised(capsys, str(spec_path("heavy_top")), *about, "--hold", "theta", "--hold", "p_psi=4.5")
    assert here["structural_zeros"] == there["structural_zeros"] == 2 and here["turns"] == 2
    frequencies = [sorted(x["imag"] for x in found["eigenvalues"]) for found in (here, there)]
    assert frequencies[0] == pytest.approx(frequencies[1], rel=1e-9) and len(frequencies[0]) == 2


def test_symmetries_are_turns() -> None:
    """The top's field knows no direction about the vertical, nor about its own axis; the ball's none about the vertical."""
    for name, count in (("heavy_top_quaternion", [1, 2]), ("chaplygin_ball_quaternion", [1])):
        system = resolve(decode(read(str(spec_path(name)))))
        formulation = formulate(system)
        flow = flow_of(equations_of(system, formulation))
        rest = [i for i in range(len(flow.y)) if i not in cyclic_of(flow)]
        assert [len(group) for group in symmetries_of(flow, formulation.frame, rest)] == count
    for text in (TORQUE.format(frame="body"), TORQUE.format(frame="space")):
        system = resolve(decode(Source("s.yaml", text)))
        formulation = formulate(system)
        flow = flow_of(equations_of(system, formulation))
        assert symmetries_of(flow, formulation.frame, range(len(flow.y))) == ()


def test_a_scene_that_needs_angular_velocity_has_three_equations(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reduce", str(spec_path("free_rigid_body_quaternion")), "--scene", "flip"]) == 0
    assert "reduced  3 equations (w1, w2, w3)" in capsys.readouterr().out


def test_the_angular_momentum_in_space_is_found(capsys: pytest.CaptureFixture[str]) -> None:
    """The angular momentum in space, by its components; of the ball, about the point of contact."""
    for name, constants in (
        ("free_rigid_body_quaternion", "L_R_x, L_R_y, L_R_z, E"),
        ("heavy_top_quaternion", "w3, L_R_z, E"),
        ("chaplygin_ball_quaternion", "L_R_z, a p_x + L_R_y, a p_y - L_R_x, E"),
    ):
        assert main(["check", "--explain", str(spec_path(name))]) == 0
        assert f"constants of the motion: {constants} (sought among" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "method"),
    [*(("heavy_top_quaternion", m) for m in ("leapfrog", "dla", "energy")), ("chaplygin_ball_quaternion", "leapfrog")],
)
def test_structure_preserving_methods(name: str, method: str, capsys: pytest.CaptureFixture[str]) -> None:
    """They need an inertia for the length of a quaternion, which is lent to it: order 2 towards the same motion."""

    def end(*settings: str) -> Any:
        assert main(["run", str(spec_path(name)), "--points", "2", "--need", "R_0,R_1,R_2,R_3,energy", *settings]) == 0
        return np.array([float(x) for x in capsys.readouterr().out.splitlines()[-1].split(",")[1:]])

    exact = end("--tol", "1e-10")
    errors = [np.max(np.abs(end("--method", method, "--step", h) - exact)) for h in ("0.02", "0.01")]
    assert 3.5 < errors[0] / errors[1] < 4.5 and errors[0] < 0.01


ON_A_TURNING_BOWL = """nhc: 1
system: ball_in_a_turning_bowl
coordinates: [u, v]
rotation: {R: {frame: space}}
parameters: {m: 1.2, a: 0.2, k: 0.7, Om: 1.1, g: 9.81}
define:
  s: sqrt(1 + k^2*(u^2 + v^2))
  nx: -k*u/s
  ny: -k*v/s
  nz: 1/s
  X: u + a*nx
  Y: v + a*ny
  Z: k*(u^2 + v^2)/2 + a*nz
  sx: X' - a*(R_wy*nz - R_wz*ny) + Om*v
  sy: Y' - a*(R_wz*nx - R_wx*nz) - Om*u
  sz: Z' - a*(R_wx*ny - R_wy*nx)
T: m/2*(X'^2 + Y'^2 + Z'^2) + m*a^2/5*(R_wx^2 + R_wy^2 + R_wz^2)
V: m*g*Z
constraints: [sx + k*u*sz = 0, sy + k*v*sz = 0]
"""


def test_a_moving_energy_is_found_by_velocities_in_space() -> None:
    """Fasso and Sansonetto 2016: on a surface that turns uniformly E - Om J is constant, J the angular momentum about its axis."""
    facts = check(Source("bowl.yaml", ON_A_TURNING_BOWL)).facts
    assert any("the moving energy E - Om L_R_z - Om (u p_v - v p_u)" in fact for fact in facts)
