"""Models and numbers that others published, against nhc: written as a user would write them, compared as numbers.

Sources, case by case: SymPy's tests of its mechanics package (test_kane, _kane3, _kane5, _linearize), its issue 27631;
PyDy's exercises after Kane and Levinson 1985; Kane and Levinson 1982; Meijaard, Papadopoulos, Ruina and Schwab 2007; Basu-Mandal,
Chatterjee and Papadopoulos 2007; odelab's rolling disk; Chaplygin 1911; McLachlan and Perlmutter 2006.
"""

from __future__ import annotations

import cmath
import math
import random
from functools import cache
from types import ModuleType

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from nhc.diagnostics import SpecError
from nhc.language import Source, read
from nhc.pipeline import Options, emit, linearize
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Request
from tests.support import emitted_python, formulations, python_model, reference, seldom, spec_path

# --- SymPy's rolling disc: yaw q1, lean q2, spin q3; x, y is the point of contact ------------------------------

DISC = """
nhc: 1
system: disc
coordinates: [q1, q2, q3, x, y]
parameters: {{m: 1, r: 1, g: 1}}
define:
  X: x + r*sin(q1)*sin(q2)
  Y: y - r*cos(q1)*sin(q2)
  Z: r*cos(q2)
  w1: q2'
  w2: q3' + sin(q2)*q1'
  w3: cos(q2)*q1'
T: m/2*(X'^2 + Y'^2 + Z'^2) + m*r^2/8*(w1^2 + 2*w2^2 + w3^2)
V: m*g*Z
constraints:
  - roll_x: x' - r*q3'*cos(q1) = 0
  - roll_y: y' - r*q3'*sin(q1) = 0
quasi_velocities:
{speeds}
"""
LEAN_FRAME = "  u1: q2'\n  u2: q3' + sin(q2)*q1'\n  u3: cos(q2)*q1'"
BODY_FIXED = "  u1: cos(q3)*q2' - sin(q3)*cos(q2)*q1'\n  u2: q3' + sin(q2)*q1'\n  u3: sin(q3)*q2' + cos(q3)*cos(q2)*q1'"
KANE_1985 = "  u1: -q2'\n  u2: cos(q2)*q1'\n  u3: q3' + sin(q2)*q1'"
FORMULATIONS = ("euler-lagrange", "chaplygin", "voronec", "multipliers")


def disc_source(speeds: str) -> Source:
    return Source("disc.yaml", DISC.format(speeds=speeds))


@cache
def disc(speeds: str, formulation: str = "euler-lagrange") -> ModuleType:
    (text,) = emit(disc_source(speeds), "python", Options(formulation=formulation)).values()
    return python_model(text, "disc")


def random_states(count: int) -> list[tuple[list[float], list[float]]]:
    rng = random.Random(5)
    return [
        (
            [rng.uniform(-3, 3), rng.uniform(-1.3, 1.3), *(rng.uniform(-3, 3) for _ in range(3))],
            [rng.uniform(-2, 2) for _ in range(3)],
        )
        for _ in range(count)
    ]


@pytest.mark.parametrize(("g", "r", "m"), [(1.0, 1.0, 1.0), (9.81, 0.26, 3.43)])
def test_sympy_disc_in_the_lean_frame(g: float, r: float, m: float) -> None:
    """test_kane.py::test_rolling_disc."""
    for q, (u1, u2, u3) in random_states(20):
        rates = disc(LEAN_FRAME).rhs(0.0, [*q, u1, u2, u3], [m, r, g])[5:]
        s, tan = math.sin(q[1]), math.tan(q[1])
        expected = [
            (6 * u2 * u3 * r - u3**2 * r * tan + 4 * g * s) / (5 * r),
            -2 * u1 * u3 / 3,
            u1 * (-2 * u2 + u3 * tan),
        ]
        assert rates == pytest.approx(expected, rel=1e-11, abs=1e-11)


def test_kane_and_levinson_exercise_11_5() -> None:
    """PyDy examples/Kane1985, chapter 6, exercise 11.5."""
    g, radius = 9.81, 0.4
    for q, (u1, u2, u3) in random_states(20):
        rates = disc(KANE_1985).rhs(0.0, [*q, u1, u2, u3], [2.0, radius, g])[5:]
        s, tan = math.sin(q[1]), math.tan(q[1])
        expected = [(u2**2 * tan - 6 * u2 * u3 - 4 * g * s / radius) / 5, 2 * u3 * u1 - u1 * u2 * tan, 2 * u1 * u2 / 3]
        assert rates == pytest.approx(expected, rel=1e-11, abs=1e-11)


TEST_KANE5 = (
    *(0.126603940595934, 0.215942571601660, 1.28736069604936, 0.319764288376543, 0.0989146857254898),
    *(-0.925848952664489, -0.0181350656532944, 2.91695398184589, -0.00992793421754526, 0.0412861634829171),
)


def test_sympy_disc_with_body_fixed_speeds() -> None:
    """test_kane5.py: q', the rates of the three speeds, and the accelerations of the point of contact, to 1e-10."""
    p = [3.43, 0.26, 9.81]
    y = [0.3, 0.1, 1.97, -0.35, 2.27, -0.2, 1.3, 0.15]
    model = disc(BODY_FIXED)
    rates = model.rhs(0.0, y, p)
    found = [*rates, *model.accelerations(0.0, y, p)[3:]]
    assert max(abs(a - b) for a, b in zip(found, TEST_KANE5, strict=True)) < 1e-10


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_sympy_disc_in_every_formulation(formulation: str) -> None:
    """The same state gives the same accelerations, whatever velocities are kept."""
    p = [3.43, 0.26, 9.81]
    q, body = [0.3, 0.1, 1.97, -0.35, 2.27], disc(BODY_FIXED)
    y = [*q, -0.2, 1.3, 0.15]
    v, expected = body.velocities(0.0, y, p), body.accelerations(0.0, y, p)
    model = disc(BODY_FIXED, formulation)
    assert model.accelerations(0.0, model.state(0.0, q, v, p), p) == pytest.approx(expected, abs=1e-11)
    assert model.reactions(0.0, model.state(0.0, q, v, p), p) == pytest.approx(body.reactions(0.0, y, p), abs=1e-10)


@pytest.mark.parametrize("speeds", [LEAN_FRAME, BODY_FIXED])
def test_sympy_disc_at_rest_upright_is_zero_and_not_nan(speeds: str) -> None:
    assert disc(speeds).rhs(0.0, [0.0] * 8) == [0.0] * 8


def test_sympy_disc_linearised() -> None:
    """test_linearize.py::test_linearize_rolling_disc_kane: rows of the lean rate and of the yaw rate, m = r = g = 1."""
    speed = 0.8
    found = linearize(disc_source(LEAN_FRAME), Request(f"u2={speed}"))
    names = [found.flow.names[i] for i in found.linearisation.rest]
    assert names == ["q2", "u1", "u2", "u3"]
    expected = np.array([[0, 1, 0, 0], [0.8, 0, 0, 1.2 * speed], [0, 0, 0, 0], [0, -2 * speed, 0, 0]])
    assert np.abs(found.linearisation.full - expected).max() < 1e-12
    assert found.paper == (
        ("0", "1", "0", "0"), ("4*g/(5*r)", "0", "0", "6*u2/5"), ("0", "0", "0", "0"), ("0", "-2*u2", "0", "0"),
    )  # fmt: skip


def test_sympy_disc_at_its_critical_speed() -> None:
    """All eigenvalues vanish at 1/sqrt(3); and the crossing is found there."""
    critical = linearize(disc_source(LEAN_FRAME), Request("u2=1/sqrt(3)"))
    assert max(abs(x) for x in np.linalg.eigvals(critical.linearisation.full)) < 1e-7
    swept = linearize(disc_source(LEAN_FRAME), Request("u2=1", sweep=("u2", 0.1, 1.0, 4))).swept
    assert swept is not None
    assert [c.value for c in swept.crossings] == pytest.approx([1 / math.sqrt(3)], abs=1e-12)


# --- the wrong tutorial: SymPy issue 27631 ---------------------------------------------------------------------

TUTORIAL = """
nhc: 1
system: tutorial
about: The disc with the rolling conditions put into T before variation, which is wrong.
coordinates: [q1, q2, q3]
parameters: {m: 1, r: 1, g: 1}
define:
  w1: q2'
  w2: q3' + sin(q2)*q1'
  w3: cos(q2)*q1'
T: m/2*r^2*(w1^2 + w2^2) + m*r^2/8*(w1^2 + 2*w2^2 + w3^2)
V: m*g*r*cos(q2)
"""


@pytest.mark.parametrize("formulation", FORMULATIONS)
def test_the_disc_of_issue_27631(formulation: str) -> None:
    model = disc(LEAN_FRAME, formulation)
    q, (a, b, c) = [0.0, 0.3, 0.0, 0.0, 0.0], (0.7, -0.4, 1.3)
    found = model.accelerations(0.0, model.state(0.0, q, [a, b, c, c, 0.0]))
    assert found[:3] == pytest.approx([1.0886217, 1.4179810, 0.12411400], abs=6e-8)


def test_what_the_tutorial_gets_and_that_nhc_refuses_to() -> None:
    (text,) = emit(Source("tutorial.yaml", TUTORIAL), "python").values()
    y = [0.0, 0.3, 0.0, 0.7, -0.4, 1.3]
    assert python_model(text, "tutorial").accelerations(0.0, y) == pytest.approx(
        [3.6123216, 1.4179810, -0.80001981], abs=6e-8
    )
    with pytest.raises(SpecError) as caught:
        emit(disc_source(LEAN_FRAME), "python", Options(formulation="lagrange"))
    assert [d.code for d in caught.value.diagnostics] == ["E0411"]


# --- the bicycle ----------------------------------------------------------------------------------------------


def bicycle_rows(speed: float) -> tuple[np.ndarray, list[complex]]:
    """Rows of roll'' and steer'' over (roll, steer, roll', steer'), and the eigenvalues."""
    request = Request(f"z=-0.3, thR'=-{speed}/r_R")
    found = linearize(read(str(spec_path("bicycle"))), request, Options(formulation="voronec"))
    names = [found.flow.names[i] for i in found.linearisation.rest]
    pick = [names.index(x) for x in ("roll", "steer", "roll'", "steer'")]
    return found.linearisation.full[np.ix_(pick[2:], pick)], eigenvalues(found.linearisation)


SYMPY_BICYCLE = {
    1: [-3.13423125066578, 3.52696170990069 + 0.807740275199311j, -7.11008014637441],
    3: [1.70675605663973 + 2.31582447384324j, -2.63366137253665, -10.3510146724592],
    5: [-0.775341882195845 + 4.46486771378823j, -0.322866429004087, -14.0783896927982],
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("v", [1, seldom(3), 5])
def test_sympy_bicycle(v: int) -> None:
    """test_kane3.py::test_bicycle, tolerance 1e-12 there; bicycle_example.rst for the eigenvalues."""
    rows, found = bicycle_rows(v)
    expected = [
        [
            9.48977444677355,
            -0.891197738059089 * v**2 - 0.571523173729245,
            -0.105522449805691 * v,
            -0.330515398992311 * v,
        ],
        [11.7194768719633, -1.97171508499972 * v**2 + 30.9087533932407, 3.67680523332152 * v, -3.08486552743311 * v],
    ]
    assert np.abs(rows - np.array(expected)).max() < 2e-12 * max(1, v**2) * 10
    for x in SYMPY_BICYCLE[v]:
        assert min(abs(x - y) for y in found) < 1e-11 * max(1.0, abs(x))
    assert len(found) == 4


@pytest.mark.parametrize("formulation", formulations("bicycle"))
def test_basu_mandal_table_1(formulation: str) -> None:
    """All nine accelerations, to 1e-9 of the published digits and 1e-10 of the recomputed ones."""
    table = reference("bicycle")["basu_mandal_table1"]  # type: ignore[call-overload]
    model = emitted_python("bicycle", formulation)
    y = model.state(0.0, table["q"], table["v"])
    assert model.velocities(0.0, y) == pytest.approx(table["v"], abs=1e-11)
    found = model.accelerations(0.0, y)
    assert found == pytest.approx(table["published_qdd"], abs=1e-9)
    assert found == pytest.approx([float(x) for x in table["qdd"]], abs=1e-10)
    assert model.reactions(0.0, y) == pytest.approx([float(x) for x in table["lam"]], abs=1e-8)


def test_the_bicycle_hit_from_the_side() -> None:
    """4.6 m/s and a roll rate of 0.5, one second later; reference by extended precision."""
    run = reference("bicycle")["run_v4.6_rolldot0.5_t1"]  # type: ignore[call-overload]
    model = emitted_python("bicycle", "voronec")
    y0 = model.state(0.0, run["q0"], [float(x) for x in run["v0"]])
    made = solve_ivp(model.rhs, (0.0, 1.0), y0, method="DOP853", rtol=1e-11, atol=1e-12)
    assert made.y[:9, -1] == pytest.approx([float(x) for x in run["q_end"]], abs=1e-9)


# --- closed forms ---------------------------------------------------------------------------------------------


def integrate(
    model: ModuleType, y: list[float], end: float, p: list[float], times: list[float] | None = None
) -> np.ndarray:
    made = solve_ivp(
        lambda t, s: model.rhs(t, s, p), (0.0, end), y, method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times or [end]
    )
    assert made.success
    return np.asarray(made.y)


def test_the_vertical_disk_rolls_on_circles() -> None:
    """odelab's case: m = R = I = J = 1, turn 2, spin 1; the circle, and the reactions m wphi R wtheta (-sin, cos)."""
    model = emitted_python("vertical_disk")
    values = {"m": 1.0, "R": 1.0, "I": 1.0, "J": 1.0}
    assert set(model.PARAMETERS) == set(values)
    p = [values[name] for name in model.PARAMETERS]
    turn, spin, phi0 = 2.0, 1.0, 0.3
    start = model.state(0.0, [0.0, 0.0, phi0, 0.0], [math.cos(phi0), math.sin(phi0), turn, spin], p)
    for t in (0.7, 2.0, 5.0):
        y = [float(x) for x in integrate(model, start, t, p)[:, -1]]
        phi, rho = phi0 + turn * t, spin / turn
        expected = [rho * (math.sin(phi) - math.sin(phi0)), -rho * (math.cos(phi) - math.cos(phi0)), phi, spin * t]
        assert y[:4] == pytest.approx(expected, abs=1e-10)
        assert model.reactions(t, y, p) == pytest.approx([-turn * math.sin(phi), turn * math.cos(phi)], abs=1e-10)


def test_the_ball_circles_on_the_turntable_at_two_sevenths() -> None:
    """zeta' = i (2/7) Omega zeta + c: centre -0.5 + 0.55i, radius 1.25, period 5 pi at Omega = 1.4."""
    model = emitted_python("ball_on_table")
    start = model.state(0.0, [0.5, -0.2, 0.1, 1.0, 0.3], [0.3, 0.4, *_spins(0.5 - 0.2j, 0.3 + 0.4j)])
    assert model.velocities(0.0, start)[:2] == pytest.approx([0.3, 0.4], abs=1e-12)
    times = [0.5, 1.0, 2.5, 4.0]
    found = integrate(model, start, times[-1], list(model.DEFAULTS), times)
    for t, x, y in zip(times, found[0], found[1], strict=True):
        zeta = -0.5 + 0.55j + (1.0 - 0.75j) * cmath.exp(0.4j * t)
        assert complex(x, y) == pytest.approx(zeta, abs=1e-10)
    assert abs(1.0 - 0.75j) == 1.25 and 2 * math.pi / 0.4 == pytest.approx(15.707963267949, abs=1e-12)


def _spins(zeta: complex, slope: complex, phi: float = 0.1, theta: float = 1.0) -> list[float]:
    """phi', theta', psi' of a ball that rolls (a = 0.3, Omega = 1.4) with the centre's velocity ``slope`` and no omega_z."""
    a, table = 0.3, 1.4
    omega_y, omega_x = (slope.real + table * zeta.imag) / a, -(slope.imag - table * zeta.real) / a
    theta_dot = math.cos(phi) * omega_x + math.sin(phi) * omega_y
    psi_dot = (math.sin(phi) * omega_x - math.cos(phi) * omega_y) / math.sin(theta)
    return [-math.cos(theta) * psi_dot, theta_dot, psi_dot]


def test_the_sleigh_of_chaplygin() -> None:
    """v = A tanh Bt, w = w0 sech Bt; m = J = a = w0 = 1 at t = 5."""
    model = emitted_python("chaplygin_sleigh")
    p = [{"m": 1.0, "I": 1.0, "J": 1.0, "a": 1.0}[name] for name in model.PARAMETERS]
    y = [float(x) for x in integrate(model, model.state(0.0, [0.0] * 3, [0.0, 0.0, 1.0], p), 5.0, p)[:, -1]]
    x_dot, y_dot, theta_dot = model.velocities(5.0, y, p)
    assert y[:3] == pytest.approx([-0.81234668, 5.09331158, 2.1390354], abs=6e-8)
    assert theta_dot == pytest.approx(0.05823692410587801, abs=1e-11)
    assert x_dot * math.cos(y[2]) + y_dot * math.sin(y[2]) == pytest.approx(1.4118133450783685, abs=1e-11)


def test_the_rattleback_turns_back() -> None:
    """Kane and Levinson's stone, spun the wrong way at 5 rad/s: its spin is first zero after 2.35118487 s."""
    model = emitted_python("rattleback")

    def spin(t: float, y: list[float]) -> float:
        return float(y[8])

    start = [0.0, 0.0, 0.0, 0.0087, 0.0087, 0.0, 0.0, 0.0, -5.0]
    made = solve_ivp(model.rhs, (0.0, 2.5), start, method="DOP853", rtol=1e-11, atol=1e-13, events=spin)
    assert model.STATE[8] == "w3"
    assert made.t_events[0][0] == pytest.approx(2.35118487, abs=2e-8)


def test_the_contact_oscillator_keeps_both_invariants() -> None:
    """McLachlan and Perlmutter: H and H - H_y, with H_y = (y^2 + y'^2)/2, H = 1.5, H_y = 0.5."""
    model = emitted_python("contact_oscillator_eps")
    q = [1.15, 1.0, -0.7]
    start = model.state(0.0, q, [0.0, 0.0, 0.0])
    before = model.energy(0.0, start)
    y = [float(x) for x in integrate(model, start, 20.0, list(model.DEFAULTS))[:, -1]]
    v = model.velocities(20.0, y)
    assert model.energy(20.0, y) == pytest.approx(before, abs=1e-10)
    assert (y[1] ** 2 + v[1] ** 2) / 2 == pytest.approx(0.5, abs=1e-10)
