"""Systems from textbooks that are in no gallery, as the book states them, against its closed forms and critical values.

Routh 1884 (balls on a ball, in a cylinder, on a tilted turning table); the curve of pursuit (Bouguer 1732); the bifilar
pendulum; the rocking ellipsoid; the ball on a beam; Meijaard, Papadopoulos, Ruina and Schwab 2007 for a bicycle of two point
masses, as in Kooijman et al. 2011.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from nhc.diagnostics import Source
from nhc.language import read
from nhc.pipeline import Options, emit, linearize, stability
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Findings, Request
from nhc.study.stability.laboratory import Question
from tests.support import python_model, spec_path

BALL_ON_BALL = """
nhc: 1
system: ball_on_ball
about: A ball spins and rolls on the top of a fixed ball.
coordinates: [X, Y]
rotation: {R: {frame: space, velocities: [wx, wy, wz]}}
parameters: {m: 1, a: 0.2, b: 0.8, k: 0.016, g: 9.81}
define:
  c: a + b
  Z: sqrt(c^2 - X^2 - Y^2)
  n1: X/c
  n2: Y/c
  n3: Z/c
T: m/2*(X'^2 + Y'^2 + Z'^2) + m*k/2*(wx^2 + wy^2 + wz^2)
V: m*g*Z
constraints:
  - X' - a*(wy*n3 - wz*n2) = 0
  - Y' - a*(wz*n1 - wx*n3) = 0
quasi_velocities: {n: wx*n1 + wy*n2 + wz*n3}
scenes: {top: {initial: {X: 0.001, n: 10}, time: [0, 2]}}
"""

BALL_IN_CYLINDER = """
nhc: 1
system: ball_in_cylinder
coordinates: [phi, z]
rotation: {R: {frame: space, velocities: [wx, wy, wz]}}
parameters: {m: 2, a: 0.1, b: 0.9, J: 0.008, g: 9.81}
T: m/2*(b^2*phi'^2 + z'^2) + J/2*(wx^2 + wy^2 + wz^2)
V: m*g*z
constraints:
  - around: b*phi' + wz*a = 0
  - along: z' + a*(wx*sin(phi) - wy*cos(phi)) = 0
quasi_velocities: {w: phi', u: z', wn: wx*cos(phi) + wy*sin(phi)}
scenes: {up_and_down: {initial: {w: 2, u: 0.3, wn: 1}, time: [0, 20], need: [z, phi], tolerance: 1e-9}}
"""

TILTED_TABLE = """
nhc: 1
system: tilted_table
coordinates: [x, y]
rotation: {B: {frame: space}}
parameters: {m: 1, a: 0.05, J: 0.001, W: 6, g: 9.81, tilt: pi/36}
T: m/2*(x'^2 + y'^2) + J/2*(B_wx^2 + B_wy^2 + B_wz^2)
V: -m*g*sin(tilt)*x
constraints:
  - x' - a*B_wy = -W*y
  - y' + a*B_wx = W*x
scenes: {drift: {initial: {x: 0.1, x': 0.2, y': 0}, time: [0, 30], need: [x', y'], tolerance: 1e-10}}
"""

PURSUIT = """
nhc: 1
system: pursuit
about: A dog runs towards a man who walks along the y axis.
coordinates: [x, y]
parameters: {m: 10, v: 1.5}
T: m/2*(x'^2 + y'^2)
constraints: ["(v*t - y)*dx + x*dy = 0"]
quasi_velocities: {s: "-(x*x' - (v*t - y)*y')/sqrt(x^2 + (v*t - y)^2)"}
scenes: {hunt: {initial: {x: 10, s: 2}, time: [0, 9], need: [x, y], tolerance: 1e-9}}
"""

BIFILAR = """
nhc: 1
system: bifilar
coordinates: [x, y, z, phi, th]
parameters: {m: 1, J: 0.05, a: 0.3, L: 1.2, g: 9.81}
T: m/2*(x'^2 + y'^2 + z'^2) + J/2*(th'^2 + cos(th)^2*phi'^2)
V: m*g*z
holonomic:
  - left: (x + a*cos(th)*cos(phi) - a)^2 + (y + a*cos(th)*sin(phi))^2 + (z + a*sin(th))^2 = L^2
  - right: (x - a*cos(th)*cos(phi) + a)^2 + (y - a*cos(th)*sin(phi))^2 + (z - a*sin(th))^2 = L^2
"""

ELLIPSOID = """
nhc: 1
system: ellipsoid
coordinates: [x, y]
rotation: {Q: {velocities: [p, q, r]}}
parameters: {m: 1.3, a1: 0.3, a2: 0.2, a3: 0.1, g: 9.81}
define:
  A: m/5*(a2^2 + a3^2)
  B: m/5*(a1^2 + a3^2)
  C: m/5*(a1^2 + a2^2)
  h: sqrt(a1^2*Q_z1^2 + a2^2*Q_z2^2 + a3^2*Q_z3^2)
  v1: (r*a2^2*Q_z2 - q*a3^2*Q_z3)/h     # of the point of contact against the centre
  v2: (p*a3^2*Q_z3 - r*a1^2*Q_z1)/h
  v3: (q*a1^2*Q_z1 - p*a2^2*Q_z2)/h
T: m/2*(x'^2 + y'^2 + h'^2) + (A*p^2 + B*q^2 + C*r^2)/2
V: m*g*h
constraints:
  - x' + Q_x1*v1 + Q_x2*v2 + Q_x3*v3 = 0
  - y' + Q_y1*v1 + Q_y2*v2 + Q_y3*v3 = 0
"""

BEAM = """
nhc: 1
system: ball_on_beam
about: A ball rolls along a beam that is tilted by a given angle; it may turn as it likes about the other axes.
coordinates: [x, y]
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: 0.3, a: 0.02, A: 0.2, W: 1.5, g: 9.81}
define: {tilt: A*sin(W*t)}
bodies:
  beam: {turns: [x: tilt]}
  place: {parent: beam, at: [x, y, a]}
  ball: {parent: place, rotation: R, mass: m, inertia: 2/5*m*a^2}
gravity: [0, 0, -g]
constraints:
  - x' - a*(R_y1*p + R_y2*q + R_y3*r) = 0
  - y' + a*(R_x1*p + R_x2*q + R_x3*r) = 0
"""

ZERO = ["R_xx", "R_yy", "F_xx", "F_yy", "B_xx", "B_xz", "B_yy", "B_zz", "H_xx", "H_xz", "H_yy", "H_zz", "m_R", "m_F"]
TWO_MASSES = {"w": 1.0, "c": -0.02, "lam": math.pi / 36, "r_R": 0.1, "r_F": 0.1, "m_B": 10.0, "x_B": 1.2, "z_B": -0.4}
TWO_MASSES |= {"m_H": 1.0, "x_H": 1.02, "z_H": -0.2, **dict.fromkeys(ZERO, 0.0)}


def linear(text: str, about: str, sweep: tuple[str, float, float, int] | None = None) -> Findings:
    return linearize(Source("s.yaml", text), Request(about, sweep=sweep), Options())


def moved(text: str, rows: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """The times and the columns of the scene."""
    found = run(open_scene(Source("s.yaml", text)), Settings(points=rows))
    table = np.array(found.rows)
    return np.array(found.times), {name: table[:, k] for k, name in enumerate(found.headings)}


def swings(found: Findings) -> list[float]:
    """The frequencies of a motion whose perturbations neither grow nor decay."""
    values = eigenvalues(found.linearisation)
    assert max(abs(x.real) for x in values) < 1e-9
    return sorted(x.imag for x in values if x.imag > 1e-9)


def test_a_ball_stays_on_a_ball_if_it_spins_fast() -> None:
    """n^2 > 35 g (a + b)/a^2 for homogeneous balls."""
    found = linear(BALL_ON_BALL, "n=90", ("n", 85.0, 100.0, 4))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(math.sqrt(35 * 9.81 / 0.04), rel=1e-9) and not crossing.unstable_above


def test_sizes_of_a_ball_on_a_ball_are_not_tied_by_rounding() -> None:
    """The spin n stands still; what rounding makes of its rate's slopes ties it to nothing, and no size is out of the domain."""
    found = stability(Source("s.yaml", BALL_ON_BALL), Question(), Options())
    X, Y = found.bench.sizes[:2]
    assert 0.04 < X < 1.0 and 0.1 < Y < 1.0
    assert {drift.what for drift in found.runs[0].drifts} >= {"T + V", "n"}


def test_a_ball_in_a_cylinder_goes_up_and_down() -> None:
    """It does not fall: w = sqrt(2/7) phi' for a homogeneous ball."""
    t, found = moved(BALL_IN_CYLINDER, 401)
    w = math.sqrt(2 / 7) * 2.0
    harmonic = np.column_stack([np.ones_like(t), np.cos(w * t), np.sin(w * t)])
    fit = np.linalg.lstsq(harmonic, found["z"], rcond=None)[0]
    assert np.abs(harmonic @ fit - found["z"]).max() < 1e-8 * np.abs(found["z"]).max()
    assert found["phi"] == pytest.approx(2.0 * t, abs=1e-8)


def test_a_ball_on_a_tilted_turning_table_drifts_across_the_slope() -> None:
    """u = x' + i y' obeys u' = (2/7) i W u + (5/7) g sin(tilt): circles about a drift of (5/2) g sin(tilt)/W along y."""
    t, found = moved(TILTED_TABLE, 301)
    k, a = 12 / 7, 5 / 7 * 9.81 * math.sin(math.pi / 36)
    exact = (0.2 + a / (1j * k)) * np.exp(1j * k * t) - a / (1j * k)
    assert a / k == pytest.approx(2.5 * 9.81 * math.sin(math.pi / 36) / 6)
    assert found["x'"] + 1j * found["y'"] == pytest.approx(exact, abs=1e-8)


def test_the_curve_of_pursuit() -> None:
    """No work is done on the dog, and its way is Bouguer's curve with k the ratio of the speeds."""
    _, found = moved(PURSUIT, 91)
    k, x = 1.5 / 2.0, found["x"] / 10
    exact = 10 * ((x ** (1 + k) / (1 + k) - x ** (1 - k) / (1 - k)) / 2 + k / (1 - k * k))
    assert found["y"] == pytest.approx(exact, abs=1e-6) and x[-1] < 0.1


def test_a_bifilar_pendulum_twists_and_swings() -> None:
    """The twist at m g a^2/(J L), swings in both directions at g/L."""
    found = swings(linear(BIFILAR, "z=-1.2"))
    assert found == pytest.approx([math.sqrt(9.81 / 1.2)] * 2 + [math.sqrt(9.81 * 0.09 / (0.05 * 1.2))], rel=1e-9)


def test_an_ellipsoid_rocks_on_its_flattest_point() -> None:
    """w^2 = m g (b^2/c - c)/(A + m c^2) about each horizontal axis, with the radius of curvature b^2/c."""
    found = swings(linear(ELLIPSOID, "p=0"))
    m, c = 1.3, 0.1
    about = [m * 9.81 * (b * b / c - c) / (m / 5 * (b * b + c * c) + m * c * c) for b in (0.2, 0.3)]
    assert found == pytest.approx([math.sqrt(x) for x in about], rel=1e-9)


@pytest.mark.parametrize("formulation", ["euler-lagrange", "multipliers"])
def test_a_ball_on_a_beam_that_turns(formulation: str) -> None:
    """7/5 (y'' - a tilt'') = y tilt'^2 - g sin(tilt), from T of the plane motion; the ball is carried by a rotation on the beam."""
    (text,) = emit(Source("s.yaml", BEAM), "python", Options(formulation=formulation)).values()
    model = python_model(text, f"beam_{formulation.replace('-', '_')}")
    a, A, W, g = 0.02, 0.2, 1.5, 9.81
    for t, y in ((0.0, 0.3), (0.4, -0.2), (2.0, 0.7)):
        q, speed = [0.1, y, 0.6, -0.2, 0.3, 0.1], 0.35
        tilt, rate, bend = A * math.sin(W * t), A * W * math.cos(W * t), -A * W * W * math.sin(W * t)
        turning = quaternion_rate(q[2:], [-speed / a, 0.0, 0.0])
        state = model.state(t, q, [0.0, speed, *turning])
        assert model.residuals(t, q, model.velocities(t, state)) == pytest.approx([0.0] * 3, abs=1e-12)
        assert model.velocities(t, state)[:2] == pytest.approx([0.0, speed], abs=1e-12)
        expected = a * bend + 5 / 7 * (y * rate**2 - g * math.sin(tilt))
        assert model.accelerations(t, state)[1] == pytest.approx(expected, rel=1e-10)


def quaternion_rate(e: list[float], w: list[float]) -> list[float]:
    """e' = (0, w) e/2 for an angular velocity w in the axes that the rotation leads to."""
    s, v = e[0], np.array(e[1:])
    return [float(-np.dot(w, v) / 2), *(float(x) for x in (s * np.array(w) + np.cross(w, v)) / 2)]


def test_a_bicycle_of_two_point_masses() -> None:
    """M, C, K0, K2 of Meijaard et al., appendix A, for a bicycle without wheels' inertia and with its contact ahead of the axis."""
    settings = ", ".join(f"{name}={value!r}" for name, value in TWO_MASSES.items())
    about = "z=-0.1, thR'=-40"
    found = linearize(read(str(spec_path("bicycle"))), Request(about, (settings,)), Options(formulation="voronec"))
    assert sorted_values(eigenvalues(found.linearisation)) == pytest.approx(sorted_values(two_masses(4.0)), rel=1e-6)


def sorted_values(values: list[complex]) -> list[complex]:
    return sorted((complex(x) for x in values), key=lambda x: (round(x.real, 6), x.imag))


def two_masses(v: float) -> list[complex]:
    """Eigenvalues of M q'' + v C q' + (g K0 + v^2 K2) q = 0."""
    p, g = TWO_MASSES, 9.81
    cos, sin = math.cos(p["lam"]), math.sin(p["lam"])
    mu = p["c"] / p["w"] * cos
    mx, mz = p["m_B"] * p["x_B"] + p["m_H"] * p["x_H"], p["m_B"] * p["z_B"] + p["m_H"] * p["z_H"]
    xx, zz = (p["m_B"] * p[f"{k}_B"] ** 2 + p["m_H"] * p[f"{k}_H"] ** 2 for k in ("z", "x"))
    xz = -p["m_B"] * p["x_B"] * p["z_B"] - p["m_H"] * p["x_H"] * p["z_H"]
    u = (p["x_H"] - p["w"] - p["c"]) * cos - p["z_H"] * sin
    across, along, S = -p["m_H"] * u * p["z_H"], p["m_H"] * u * p["x_H"], p["m_H"] * u + mu * mx
    mixed = across + mu * xz
    M = np.array([[xx, mixed], [mixed, p["m_H"] * u * u + 2 * mu * along + mu * mu * zz]])
    K = g * np.array([[mz, -S], [-S, -S * sin]]) + v * v * cos / p["w"] * np.array([[0, -mz], [0, S]])
    C = np.array([[0, xz * cos / p["w"] - mu * mz], [0, along * cos / p["w"] + mu * (S + zz * cos / p["w"])]])
    whole = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, K), -np.linalg.solve(M, v * C)]])
    return list(np.linalg.eigvals(whole))
