# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:327fc616f2363325).

A board on two steerable axles and a rotor; it moves by turning the rotor and the
    axles to and fro.
Source: snakeboard.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of
    the spec (x', y') are singular somewhere

State y:
y[0] = x [m]: centre of the board
y[1] = y [m]: centre of the board
y[2] = theta [rad]: heading of the board
y[3] = psi [rad]: rotor, relative to the board
y[4] = p_b [rad]: back axle, relative to the board
y[5] = p_f [rad]: front axle, relative to the board
y[6] = v
y[7] = psi'
y[8] = p_b'
y[9] = p_f'

Parameters p:
p[0]: m = 1.0 [kg]: mass of everything
p[1]: l = 0.5 [m]: from the centre to an axle
p[2]: J = 0.1 [kg*m^2]: board
p[3]: J_r = 0.05 [kg*m^2]: rotor
p[4]: J_w = 0.02 [kg*m^2]: each axle
p[5]: tau = 0.05 [N*m]: amplitude of the torque on the rotor
p[6]: sigma = 0.02 [N*m]: amplitude of the torques on the axles
p[7]: nu = 1.0 [rad/s]: frequency of the torques

Constraints:
0: back
1: front

Outputs:
out[0] = speed

Operations:
rhs: 55 +-, 108 *, 5 /, 9 calls
velocities: 18 +-, 34 *, 1 /, 7 calls
accelerations: 61 +-, 119 *, 5 /, 9 calls
state: 10 +-, 17 *, 0 /, 6 calls
residuals: 6 +-, 7 *, 0 /, 6 calls
reactions: 91 +-, 181 *, 5 /, 9 calls
energy: 24 +-, 42 *, 1 /, 6 calls
jacobian: 188 +-, 340 *, 5 /, 8 calls
outputs: 10 +-, 18 *, 1 /, 5 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "theta", "psi", "p_b", "p_f")
STATE: tuple[str, ...] = (
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f",
    "v",
    "psi'",
    "p_b'",
    "p_f'",
)
PARAMETERS: tuple[str, ...] = ("m", "l", "J", "J_r", "J_w", "tau", "sigma", "nu")
CONSTRAINTS: tuple[str, ...] = ("back", "front")
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.1, 0.05, 0.02, 0.05, 0.02, 1.0)

REASONS = (
    "",
    "the coframe is singular",
    "the mass matrix is singular",
    "a result is not finite or not defined",
)
NOT_FINITE = 3


class SingularModelError(ArithmeticError):
    """The model is singular here; ``status`` is the code that C returns."""

    def __init__(self, status: int, function: str) -> None:
        super().__init__(f"{function}: {REASONS[status]}")
        self.status = status


def _finish(function: str, values: list[float]) -> list[float]:
    if not all(map(math.isfinite, values)):
        raise SingularModelError(NOT_FINITE, function)
    return values


def _single(function: str, value: float) -> float:
    if not math.isfinite(value):
        raise SingularModelError(NOT_FINITE, function)
    return value


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns dydt (10,).
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular
        if not abs(J_r) > 0.0:
            raise SingularModelError(2, "rhs")
        # the mass matrix is singular
        if not abs(J_w) > 0.0:
            raise SingularModelError(2, "rhs")
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = 1.0 / J_r
        k6 = 1.0 / J_w
        k7 = J + J_w
        k8 = J_r - J_w
        # state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "rhs")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        z9 = l * c_p_f
        z10 = l * c_p_b
        c1 = math.cos(z8)
        z11 = s1 * c_p_f + c1 * s_p_f
        z12 = c1 * c_p_f - s1 * s_p_f
        z13 = c_p_b * z11 - s_p_b * z12
        z14 = s1 * z9 + z10 * z13
        z15 = z7 * z14
        z16 = c_p_b * z12 + s_p_b * z11
        z17 = c1 * z9 + z10 * z16
        z18 = z7 * z17
        z19 = z14 * z15 + z17 * z18
        z20 = s1 * z16 - c1 * z13
        z21 = z7 * z20
        z22 = z7 * (m * z19 + J * (z20 * z21))
        s4 = z18 * z18 + z15 * z15
        s5 = J * (z21 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * (s5 + m * s4):
            raise SingularModelError(2, "rhs")
        z23 = v * z7
        z24 = z20 * z23
        z25 = p_b_dot * c_p_b
        z26 = p_f_dot * c_p_f
        z27 = s_p_f * z26
        z28 = k1 * z27
        z29 = p_b_dot * s_p_b
        z30 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z26 - s_p_f * (c_p_f * z29 + c_p_b * z30)))
        z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - s6
        z32 = (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28)) / (z6 * z6)
        z33 = p_b_dot - z24
        z34 = s1 * z33
        z35 = l * z29
        z36 = l * z30
        z37 = p_f_dot - z24
        z38 = z13 * z37
        z39 = c1 * z33
        z40 = z16 * z37
        s7 = z18 * (z9 * z34 + (z35 * z16 + (c1 * z36 + z10 * z38)))
        z41 = s7 - z15 * (z9 * z39 - (z35 * z13 + (s1 * z36 - z10 * z40)))
        s8 = z7 * (z16 * z39 - s1 * z38 + (z13 * z34 - c1 * z40))
        z42 = v * (z32 * z20 - s8)
        z43 = t_ * nu
        s2 = math.sin(z43)
        z44 = tau * s2 - J_r * z42
        s9 = z21 * (k7 * z42 + (z44 + k8 * z42))
        z45 = m * (v * (z32 * z19 + z7 * z41)) + s9
        z46 = z45 / z22
        z47 = z21 * z46
        c2 = math.cos(z43)
        z48 = sigma * c2
        z49 = J_w * z42
        dydt: list[float] = [
            # x' (I.2.15)
            z17 * z23,
            # y' (I.2.15)
            z14 * z23,
            # theta' (I.2.15)
            -z24,
            # psi' (I.2.15)
            psi_dot,
            # p_b' (I.2.15)
            p_b_dot,
            # p_f' (I.2.15)
            p_f_dot,
            # v' (I.2.15) 22:4
            z46,
            # psi'' (I.2.15) 22:4
            k5 * z44 + z47,
            # p_b'' (I.2.15) 22:4
            k6 * (z48 - z49) + z47,
            # p_f'' (I.2.15) 22:4
            z47 - k6 * (z48 + z49),
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all velocities q' from the state (I.2.4)

    Arguments: t (scalar), y (10,), p (8,).
    Returns qdot (6,).
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        # state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        s2 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s2 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "velocities")
        z5 = theta + p_b
        c1 = math.cos(z5)
        z6 = l * c_p_f
        z7 = l * c_p_b
        s1 = math.sin(z5)
        z8 = c1 * c_p_f - s1 * s_p_f
        z9 = s1 * c_p_f + c1 * s_p_f
        z10 = c_p_b * z8 + s_p_b * z9
        z11 = v / z4
        z12 = c_p_b * z9 - s_p_b * z8
        qdot: list[float] = [
            # x' (I.2.4)
            (c1 * z6 + z7 * z10) * z11,
            # y' (I.2.4)
            (s1 * z6 + z7 * z12) * z11,
            # theta' (I.2.4)
            -(s1 * z10 - c1 * z12) * z11,
            # psi' (I.2.4)
            psi_dot,
            # p_b' (I.2.4)
            p_b_dot,
            # p_f' (I.2.4)
            p_f_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns qddot (6,).
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular
        if not abs(J_r) > 0.0:
            raise SingularModelError(2, "accelerations")
        # the mass matrix is singular
        if not abs(J_w) > 0.0:
            raise SingularModelError(2, "accelerations")
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = 1.0 / J_r
        k6 = 1.0 / J_w
        k7 = J + J_w
        k8 = J_r - J_w
        # state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "accelerations")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        z9 = l * c_p_f
        z10 = l * c_p_b
        c1 = math.cos(z8)
        z11 = s1 * c_p_f + c1 * s_p_f
        z12 = c1 * c_p_f - s1 * s_p_f
        z13 = c_p_b * z11 - s_p_b * z12
        z14 = s1 * z9 + z10 * z13
        z15 = z7 * z14
        z16 = c_p_b * z12 + s_p_b * z11
        z17 = c1 * z9 + z10 * z16
        z18 = z7 * z17
        z19 = z14 * z15 + z17 * z18
        z20 = s1 * z16 - c1 * z13
        z21 = z7 * z20
        z22 = z7 * (m * z19 + J * (z20 * z21))
        s4 = z18 * z18 + z15 * z15
        s5 = J * (z21 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * (s5 + m * s4):
            raise SingularModelError(2, "accelerations")
        z23 = p_b_dot * c_p_b
        z24 = p_f_dot * c_p_f
        z25 = s_p_f * z24
        z26 = k1 * z25
        z27 = p_b_dot * s_p_b
        z28 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z24 - s_p_f * (c_p_f * z27 + c_p_b * z28)))
        z29 = z3 * z23 - 4.0 * (s_p_b * (z25 - z26)) - s6
        z30 = (z5 * z23 + s_p_b * z29 + (2.0 * z25 - 6.0 * z26)) / (z6 * z6)
        z31 = v * z30
        z32 = l * z28
        z33 = v * z20
        z34 = z7 * z33
        z35 = p_b_dot - z34
        z36 = s1 * z35
        z37 = l * z27
        z38 = p_f_dot - z34
        z39 = z13 * z38
        z40 = c1 * z32 + z9 * z36 + (z37 * z16 + z10 * z39)
        z41 = c1 * z35
        z42 = z16 * z38
        z43 = z16 * z41 - s1 * z39 + (z13 * z36 - c1 * z42)
        z44 = v * (z7 * z43 - z30 * z20)
        z45 = t_ * nu
        s2 = math.sin(z45)
        z46 = tau * s2 + J_r * z44
        z47 = s1 * z32 - z9 * z41 + (z37 * z13 - z10 * z42)
        s7 = m * (v * (z30 * z19 + z7 * (z15 * z47 + z18 * z40)))
        z48 = z21 * (k7 * z44 - (z46 - z44 * k8)) - s7
        z49 = z48 / z22
        z50 = z21 * z49
        c2 = math.cos(z45)
        z51 = sigma * c2
        z52 = J_w * z44
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z17 * z31 + z7 * (v * z40 + z17 * z49)),
            # y'' (I.2.15)
            -(z14 * z31 + z7 * (v * z47 + z14 * z49)),
            # theta'' (I.2.15)
            z30 * z33 - z7 * (v * z43 - z20 * z49),
            # psi'' (I.2.15)
            k5 * z46 - z50,
            # p_b'' (I.2.15)
            k6 * (z51 + z52) - z50,
            # p_f'' (I.2.15)
            -(k6 * (z51 - z52) + z50),
        ]
        return _finish("accelerations", qddot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "accelerations") from error


def state(
    t: float,
    q: Sequence[float],
    qdot: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """the state y from coordinates and velocities (I.2.1)

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns y (10,).
    """
    x = float(q[0])  # centre of the board [m]
    y_2 = float(q[1])  # centre of the board [m]
    theta = float(q[2])  # heading of the board [rad]
    psi = float(q[3])  # rotor, relative to the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    psi_dot = float(qdot[3])
    p_b_dot = float(qdot[4])
    p_f_dot = float(qdot[5])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = theta + p_b
        c1 = math.cos(z1)
        z2 = c1 * c_p_f
        s1 = math.sin(z1)
        z3 = z2 - s1 * s_p_f
        z4 = s1 * c_p_f
        z5 = z4 + c1 * s_p_f
        s2 = x_dot * (l * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5)))
        z6 = s2 + y_dot * (l * (z4 + c_p_b * (c_p_b * z5 - s_p_b * z3)))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z6,
            psi_dot,
            p_b_dot,
            p_f_dot,
        ]
        return _finish("state", y)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "state") from error


def residuals(
    t: float,
    q: Sequence[float],
    qdot: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """left sides of the constraints, zero on every motion (I.1.1)

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns r (2,).
    """
    theta = float(q[2])  # heading of the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # state
        z1 = theta + p_b
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        c_p_b = math.cos(p_b)
        z2 = theta_dot * l
        z3 = theta + p_f
        s2 = math.sin(z3)
        c2 = math.cos(z3)
        c_p_f = math.cos(p_f)
        r: list[float] = [
            # back = 0 (I.1.1) 28:5
            -(x_dot * s1 - y_dot * c1 + c_p_b * z2),
            # front = 0 (I.1.1) 29:5
            c_p_f * z2 - (x_dot * s2 - y_dot * c2),
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (10,), p (8,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular
        if not abs(J_r) > 0.0:
            raise SingularModelError(2, "reactions")
        # the mass matrix is singular
        if not abs(J_w) > 0.0:
            raise SingularModelError(2, "reactions")
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = 1.0 / J_r
        k6 = 1.0 / J_w
        k7 = J + J_w
        k8 = J_r - J_w
        # state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "reactions")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        z9 = l * c_p_f
        z10 = l * c_p_b
        z11 = s1 * c_p_f
        c1 = math.cos(z8)
        z12 = z11 + c1 * s_p_f
        z13 = c1 * c_p_f
        z14 = z13 - s1 * s_p_f
        z15 = c_p_b * z12 - s_p_b * z14
        z16 = s1 * z9 + z10 * z15
        z17 = z7 * z16
        z18 = c_p_b * z14 + s_p_b * z12
        z19 = c1 * z9 + z10 * z18
        z20 = z7 * z19
        z21 = z16 * z17 + z19 * z20
        z22 = s1 * z18 - c1 * z15
        z23 = z7 * z22
        z24 = z7 * (m * z21 + J * (z22 * z23))
        s4 = z20 * z20 + z17 * z17
        s5 = J * (z23 * z23)
        # the mass matrix is singular
        if not abs(z24) > 1e-14 * (s5 + m * s4):
            raise SingularModelError(2, "reactions")
        z25 = l * (z13 + c_p_b * z18)
        z26 = l * (z11 + c_p_b * z15)
        z27 = z7 * (z18 * z25 + z15 * z26)
        z28 = p_b_dot * c_p_b
        z29 = p_f_dot * c_p_f
        z30 = s_p_f * z29
        z31 = k1 * z30
        z32 = p_b_dot * s_p_b
        z33 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z29 - s_p_f * (c_p_f * z32 + c_p_b * z33)))
        z34 = z3 * z28 - 4.0 * (s_p_b * (z30 - z31)) - s6
        z35 = (z5 * z28 + s_p_b * z34 + (2.0 * z30 - 6.0 * z31)) / (z6 * z6)
        z36 = v * z22
        z37 = z7 * z36
        z38 = p_b_dot - z37
        z39 = c1 * z38
        z40 = p_f_dot - z37
        z41 = z15 * z40
        z42 = s1 * z38
        z43 = z18 * z40
        z44 = z7 * (z18 * z39 - s1 * z41 + (z15 * z42 - c1 * z43))
        z45 = z35 * z36 - v * z44
        z46 = z27 * z45
        z47 = l * z33
        z48 = l * z32
        z49 = c1 * z47 + z9 * z42 + (z48 * z18 + z10 * z41)
        z50 = v * (z7 * z49 + z35 * z19)
        z51 = c_p_b * s_p_f - c_p_f * s_p_b
        z52 = z7 * (z9 * z26 - z51 * z18)
        z53 = s1 * z47 - z9 * z39 + (z48 * z15 - z10 * z43)
        z54 = v * (z7 * z53 + z35 * z16)
        z55 = z7 * (z9 * z25 + z51 * z15)
        s7 = J_r * z46 - (m * (z50 * z52 - z54 * z55) - J * z46)
        z56 = 2.0 * (J_w * z46) + s7
        z57 = t_ * nu
        c2 = math.cos(z57)
        z58 = sigma * c2
        z59 = v * (z44 - z35 * z22)
        z60 = J_w * z59
        s2 = math.sin(z57)
        z61 = tau * s2 + J_r * z59
        s8 = m * (v * (z35 * z21 + z7 * (z17 * z53 + z20 * z49)))
        z62 = z23 * (k7 * z59 - (z61 - z59 * k8)) - s8
        z63 = z62 / z24
        z64 = z23 * z63
        z65 = k6 * (z58 - z60) + z64
        z66 = J_w * z27
        z67 = k6 * (z58 + z60) - z64
        z68 = z23 * z27
        s9 = m * (z20 * z52 - z17 * z55) - J * z68 - J_r * z68
        z69 = s9 - 2.0 * (J_w * z68)
        z70 = J_r * (k5 * z61 - z64)
        z71 = z7 * (c1 * z25 + s1 * z26)
        z72 = z71 * z45
        z73 = z7 * (c1 * z51 + z10 * z26)
        z74 = z7 * (s1 * z51 - z10 * z25)
        s10 = J_r * z72 + (m * (z50 * z73 + z54 * z74) + J * z72)
        z75 = 2.0 * (J_w * z72) + s10
        z76 = J_w * z71
        z77 = z23 * z71
        s11 = m * (z20 * z73 + z17 * z74) + J * z77 + J_r * z77
        z78 = s11 + 2.0 * (J_w * z77)
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            z65 * z66 - (z67 * z66 - (z63 * z69 - z27 * z70)) - z56,
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            z75 - (z65 * z76 - (z67 * z76 + (z63 * z78 + z71 * z70))),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (10,), p (8,).
    Returns a scalar.
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    try:
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        # state
        z1 = theta + p_b
        c1 = math.cos(z1)
        c_p_f = math.cos(p_f)
        z2 = l * c_p_f
        c_p_b = math.cos(p_b)
        z3 = l * c_p_b
        s1 = math.sin(z1)
        s_p_f = math.sin(p_f)
        z4 = c1 * c_p_f - s1 * s_p_f
        s_p_b = math.sin(p_b)
        z5 = s1 * c_p_f + c1 * s_p_f
        z6 = c_p_b * z4 + s_p_b * z5
        z7 = s_p_f * s_p_f
        z8 = 2.0 * z7
        s2 = s_p_b * (1.0 - z8 - k1 * (3.0 - z8))
        z9 = s_p_b * (s2 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z10 = v / (z9 + (z7 + k1 * (4.0 - 3.0 * z7)))
        z11 = (c1 * z2 + z3 * z6) * z10
        z12 = c_p_b * z5 - s_p_b * z4
        z13 = (s1 * z2 + z3 * z12) * z10
        z14 = (s1 * z6 - c1 * z12) * z10
        z15 = psi_dot - z14
        z16 = p_b_dot - z14
        z17 = p_f_dot - z14
        s3 = m * (z11 * z11 + z13 * z13) + J * (z14 * z14)
        z18 = s3 + J_r * (z15 * z15) + J_w * (z16 * z16 + z17 * z17)
        value1 = 0.5 * z18
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns rows (10, 10): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J_2 = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular
        if not abs(J_r) > 0.0:
            raise SingularModelError(2, "jacobian")
        # the mass matrix is singular
        if not abs(J_w) > 0.0:
            raise SingularModelError(2, "jacobian")
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = J_2 + J_w
        # state
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        s_p_b = math.sin(p_b)
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_f * k2
        z6 = s_p_b * z3 - 2.0 * (z4 * z5)
        z7 = z1 + k1 * (4.0 - 3.0 * z1) + s_p_b * z6
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z7) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "jacobian")
        z8 = 1.0 / z7
        z9 = theta + p_b
        s1 = math.sin(z9)
        z10 = l * c_p_f
        z11 = s1 * z10
        z12 = l * c_p_b
        c1 = math.cos(z9)
        z13 = s1 * c_p_f + c1 * s_p_f
        z14 = c1 * c_p_f - s1 * s_p_f
        z15 = c_p_b * z13 - s_p_b * z14
        z16 = z12 * z15
        z17 = z11 + z16
        z18 = z17 * z8
        z19 = c1 * z10
        z20 = c_p_b * z14 + s_p_b * z13
        z21 = z12 * z20
        z22 = z19 + z21
        z23 = z22 * z8
        z24 = z17 * z18 + z22 * z23
        z25 = s1 * z20 - c1 * z15
        z26 = z25 * z8
        z27 = z25 * z26
        z28 = z8 * (m * z24 + J_2 * z27)
        s4 = z23 * z23 + z18 * z18
        s5 = J_2 * (z26 * z26)
        # the mass matrix is singular
        if not abs(z28) > 1e-14 * (s5 + m * s4):
            raise SingularModelError(2, "jacobian")
        z29 = v * z17
        z30 = v * z22
        z31 = 1.0 / (z7 * z7)
        z32 = c_p_f * s_p_b
        z33 = c_p_b * z3 + 2.0 * (z32 * z5)
        z34 = c_p_b * z6 + s_p_b * z33
        z35 = z31 * z34
        z36 = l * s_p_b
        z37 = z11 + z20 * z36
        z38 = v * z8
        z39 = c_p_f * s_p_f
        z40 = k1 * z39
        z41 = z39 - z40
        z42 = c_p_b * s_p_f
        s6 = 2.0 * (k2 * (c_p_f * z4 - s_p_f * z42))
        z43 = 4.0 * (s_p_b * z41) + s6
        z44 = s_p_b * z43 - (2.0 * z39 - 6.0 * z40)
        z45 = z44 * z31
        z46 = l * s_p_f
        z47 = z16 + c1 * z46
        z48 = z19 - z15 * z36
        z49 = z21 - s1 * z46
        z50 = v * z25
        z51 = s1 * z15 + c1 * z20
        z52 = z51 * z38
        z53 = z50 * z35 - z52
        z54 = z52 - z50 * z45
        z55 = z51 * z26
        z56 = z51 * z8
        z57 = z56 - z25 * z35
        z58 = z48 * z8 - z17 * z35
        z59 = z37 * z8 + z22 * z35
        s7 = z8 * (z48 * z18 + z17 * z58 - (z37 * z23 + z22 * z59))
        z60 = m * (z24 * z35 - s7)
        z61 = m * v
        z62 = p_f_dot * s_p_f
        z63 = l * z62
        z64 = c1 * z63
        z65 = z50 * z8
        z66 = p_b_dot - z65
        z67 = s1 * z66
        z68 = p_b_dot * s_p_b
        z69 = l * z68
        z70 = z69 * z20
        z71 = p_f_dot - z65
        z72 = z15 * z71
        z73 = z64 + z10 * z67 + (z70 + z12 * z72)
        z74 = p_f_dot * c_p_f
        z75 = s_p_f * z74
        z76 = k1 * z75
        z77 = p_b_dot * c_p_b
        z78 = z75 - z76
        z79 = c_p_f * z68 + c_p_b * z62
        s8 = 2.0 * (k2 * (z4 * z74 - s_p_f * z79))
        z80 = z3 * z77 - 4.0 * (s_p_b * z78) - s8
        z81 = 2.0 * z75 - 6.0 * z76 + (s_p_b * z80 + z77 * z6)
        z82 = z31 * z81
        z83 = z8 * z73 + z22 * z82
        z84 = z61 * z83
        z85 = s1 * z63
        z86 = c1 * z66
        z87 = z69 * z15
        z88 = z20 * z71
        z89 = z85 - z10 * z86 + (z87 - z12 * z88)
        z90 = z8 * z89 + z17 * z82
        z91 = z61 * z90
        z92 = z20 * z86 - s1 * z72 + (z15 * z67 - c1 * z88)
        z93 = z8 * z92 - z25 * z82
        z94 = v * z93
        s2 = math.sin(t_ * nu)
        z95 = k5 * z94 - (tau * s2 + J_w * z94)
        z96 = z23 * z84 + (z18 * z91 - z26 * z95)
        z97 = z96 / (z28 * z28)
        z98 = 1.0 / z28
        z99 = z86 + s1 * z53
        z100 = l * z77
        z101 = z15 * z53
        s9 = z85 - z10 * z99 - (z20 * z100 - (z36 * z72 - z12 * z101))
        z102 = z73 * z35 + z8 * s9
        z103 = z81 / (z7 * z7 * z7)
        s10 = 2.0 * (k2 * (z32 * z74 - s_p_f * (s_p_b * z62 - c_p_f * z77)))
        z104 = z3 * z68 + 4.0 * (c_p_b * z78) - s10
        s11 = z31 * (c_p_b * z80 - s_p_b * z104 + (z77 * z33 - z68 * z6))
        z105 = 2.0 * (z34 * z103) - s11
        z106 = z61 * z23
        z107 = z67 - c1 * z53
        z108 = z20 * z53
        s12 = z64 + z10 * z107 + (z15 * z100 + (z36 * z88 - z12 * z108))
        z109 = z89 * z35 - z8 * s12
        z110 = z61 * z18
        z111 = J_2 * z26
        z112 = z51 * z82
        s13 = c1 * (z72 + z108) + (z20 * z107 - z15 * z99)
        s14 = z92 * z35 + (z112 - z25 * z105)
        z113 = z8 * (s1 * (z88 - z101) - s13) - s14
        z114 = v * z113
        s15 = z91 * z58 - (z109 - (z48 * z82 - z17 * z105)) * z110
        z115 = s15 - (z57 * z95 + z111 * z114)
        s16 = z84 * z59 + (z102 + (z37 * z82 + z22 * z105)) * z106 - z115
        s17 = (J_2 * (z27 * z35 - z8 * (z55 + z25 * z57)) + z60) * z97
        z116 = s17 - z98 * s16
        z117 = z56 - z25 * z45
        z118 = z49 * z8 + z17 * z45
        z119 = z47 * z8 - z22 * z45
        s18 = z8 * (z49 * z18 + z17 * z118 - (z47 * z23 + z22 * z119))
        z120 = m * (z24 * z45 + s18)
        z121 = l * z74
        z122 = s1 * z54
        z123 = z88 + z15 * z54
        s19 = c1 * z121 - (z46 * z67 - z10 * z122) - (z87 - z12 * z123)
        z124 = z73 * z45 + z8 * s19
        z125 = c_p_f * z74 - s_p_f * z62
        z126 = k1 * z125
        s20 = c_p_f * z79 - s_p_f * (s_p_f * z68 - c_p_b * z74)
        z127 = k2 * (z42 * z74 + z4 * z62 + s20)
        s21 = 4.0 * (z77 * z41 + s_p_b * (z125 - z126)) - 2.0 * z127
        z128 = z77 * z43 + s_p_b * s21 - (2.0 * z125 - 6.0 * z126)
        z129 = 2.0 * (z44 * z103) - z128 * z31
        z130 = c1 * z54
        z131 = z72 - z20 * z54
        s22 = s1 * z121 + (z46 * z86 - z10 * z130) + (z70 + z12 * z131)
        z132 = z89 * z45 + z8 * s22
        s23 = z20 * (z67 + z130) - (s1 * z123 - c1 * z131)
        s24 = z92 * z45 + (z112 - z25 * z129)
        z133 = s24 - z8 * (z15 * (z86 - z122) - s23)
        z134 = v * z133
        s25 = z91 * z118 + z110 * (z132 + (z49 * z82 + z17 * z129))
        z135 = s25 + (z117 * z95 - z111 * z134)
        s26 = z84 * z119 - z106 * (z124 - (z47 * z82 - z22 * z129)) - z135
        s27 = (J_2 * (z27 * z45 - z8 * (z55 + z25 * z117)) + z120) * z97
        z136 = s27 + z98 * s26
        z137 = c1 * z26
        z138 = z15 * z26
        z139 = s1 * z26
        z140 = z20 * z26
        s28 = z38 * (z20 * z137 - s1 * z138 + (z15 * z139 - c1 * z140))
        z141 = z93 - s28
        s29 = z12 * (z23 * z138 - z18 * z140)
        s30 = z38 * (s29 + z10 * (z23 * z139 - z18 * z137))
        z142 = s30 - (z23 * z83 + z18 * z90)
        z143 = z98 * (z141 * z111 + m * z142)
        z144 = v * z57
        z145 = z98 * (z111 * z144 + z61 * (z18 * z58 - z23 * z59))
        z146 = v * z117
        z147 = z98 * (z111 * z146 - z61 * (z18 * z118 - z23 * z119))
        z148 = z98 * z96
        z149 = z114 + (z57 * z148 + z26 * z116)
        z150 = z134 - (z117 * z148 + z26 * z136)
        z151 = z141 - z26 * z143
        z152 = z144 - z26 * z145
        z153 = z146 - z26 * z147
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -z29 * z8,
            0.0,
            # (I.2.15)
            -(z30 * z35 + z37 * z38),
            # (I.2.15)
            z30 * z45 - z47 * z38,
            # (I.2.15)
            z23,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z30 * z8,
            0.0,
            # (I.2.15)
            z48 * z38 - z29 * z35,
            # (I.2.15)
            z29 * z45 + z49 * z38,
            # (I.2.15)
            z18,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z53,
            # (I.2.15)
            z54,
            # (I.2.15)
            -z26,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z116,
            # (I.2.15)
            -z136,
            # (I.2.15)
            -z143,
            0.0,
            # (I.2.15)
            -z145,
            # (I.2.15)
            z147,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z149,
            # (I.2.15)
            z150,
            # (I.2.15)
            z151,
            0.0,
            # (I.2.15)
            z152,
            # (I.2.15)
            -z153,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z149,
            # (I.2.15)
            z150,
            # (I.2.15)
            z151,
            0.0,
            # (I.2.15)
            z152,
            # (I.2.15)
            -z153,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z149,
            # (I.2.15)
            z150,
            # (I.2.15)
            z151,
            0.0,
            # (I.2.15)
            z152,
            # (I.2.15)
            -z153,
        ]
        _finish("jacobian", J)
        return [J[k6 : k6 + 10] for k6 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (10,), p (8,).
    Returns out (1,).
    """
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # parameters only
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        # state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z3 = c_p_b * c_p_f
        s1 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        s2 = s_p_b * (s1 - 2.0 * (s_p_f * z3 * k2))
        z4 = s2 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "outputs")
        out: list[float] = [
            # speed 32:10
            2.0 * (l * (z3 * v / z4)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
