# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:942ca59eab617072).

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
rhs: 55 +-, 100 *, 5 /, 11 calls
velocities: 15 +-, 26 *, 1 /, 9 calls
accelerations: 61 +-, 111 *, 5 /, 11 calls
state: 7 +-, 11 *, 0 /, 8 calls
residuals: 6 +-, 7 *, 0 /, 6 calls
reactions: 91 +-, 175 *, 5 /, 11 calls
energy: 21 +-, 34 *, 1 /, 8 calls
jacobian: 191 +-, 338 *, 5 /, 11 calls
outputs: 15 +-, 23 *, 1 /, 11 calls

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
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "rhs")
        z7 = theta + p_b
        s1 = math.sin(z7)
        z8 = theta + p_f
        c1 = math.cos(z8)
        c2 = math.cos(z7)
        s2 = math.sin(z8)
        z9 = s1 * c1 - c2 * s2
        z10 = 1.0 / z6
        z11 = z9 * z10
        z12 = J * z11 * z11
        z13 = l * c_p_f
        z14 = l * c_p_b
        z15 = s1 * z13 + z14 * s2
        z16 = z15 * z10
        z17 = c2 * z13 + z14 * c1
        z18 = z17 * z10
        z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18))
        s5 = z12 + m * (z16 * z16)
        s6 = s5 + m * (z18 * z18)
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * s6:
            raise SingularModelError(2, "rhs")
        z20 = v * z11
        z21 = t_ * nu
        s3 = math.sin(z21)
        z22 = p_b_dot * c_p_b
        z23 = p_f_dot * c_p_f
        z24 = s_p_f * z23
        z25 = k1 * z24
        z26 = p_b_dot * s_p_b
        z27 = p_f_dot * s_p_f
        s7 = 2.0 * (k2 * (z4 * z23 - s_p_f * (c_p_f * z26 + c_p_b * z27)))
        z28 = z3 * z22 - 4.0 * (s_p_b * (z24 - z25)) - s7
        z29 = (z5 * z22 + s_p_b * z28 + (2.0 * z24 - 6.0 * z25)) / (z6 * z6)
        z30 = p_b_dot - z20
        z31 = c2 * z30
        z32 = p_f_dot - z20
        z33 = s2 * z32
        z34 = s1 * z30
        z35 = c1 * z32
        s8 = z10 * (c1 * z31 - s1 * z33 + (s2 * z34 - c2 * z35))
        z36 = v * (z9 * z29 - s8)
        z37 = J_r * z36
        z38 = tau * s3 - z37
        c3 = math.cos(z21)
        z39 = sigma * c3
        z40 = J_w * z36
        z41 = z39 - z40
        z42 = z39 + z40
        z43 = l * z27
        z44 = l * z26
        z45 = m * v
        s9 = z10 * (s1 * z43 - z13 * z31 + (s2 * z44 - z14 * z35))
        z46 = (z15 * z29 + s9) * (z16 * z45)
        s10 = z10 * (c2 * z43 + z13 * z34 + (c1 * z44 + z14 * z33))
        z47 = (z17 * z29 + s10) * (z18 * z45)
        s11 = z11 * (z38 + (z37 + (z41 + (z40 - (z42 - k7 * z36))))) + z46
        z48 = (s11 + z47) / z19
        z49 = z11 * z48
        dydt: list[float] = [
            # x' (I.2.15)
            v * z18,
            # y' (I.2.15)
            v * z16,
            # theta' (I.2.15)
            -z20,
            # psi' (I.2.15)
            psi_dot,
            # p_b' (I.2.15)
            p_b_dot,
            # p_f' (I.2.15)
            p_f_dot,
            # v' (I.2.15) 22:4
            z48,
            # psi'' (I.2.15) 22:4
            z49 + k5 * z38,
            # p_b'' (I.2.15) 22:4
            z49 + k6 * z41,
            # p_f'' (I.2.15) 22:4
            z49 - k6 * z42,
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
        s3 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s3 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "velocities")
        z5 = theta + p_b
        c1 = math.cos(z5)
        z6 = l * c_p_f
        z7 = l * c_p_b
        z8 = theta + p_f
        c2 = math.cos(z8)
        z9 = v / z4
        s1 = math.sin(z5)
        s2 = math.sin(z8)
        qdot: list[float] = [
            # x' (I.2.4)
            (c1 * z6 + z7 * c2) * z9,
            # y' (I.2.4)
            (s1 * z6 + z7 * s2) * z9,
            # theta' (I.2.4)
            -(s1 * c2 - c1 * s2) * z9,
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
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "accelerations")
        z7 = theta + p_b
        s1 = math.sin(z7)
        z8 = theta + p_f
        c1 = math.cos(z8)
        c2 = math.cos(z7)
        s2 = math.sin(z8)
        z9 = s1 * c1 - c2 * s2
        z10 = 1.0 / z6
        z11 = z9 * z10
        z12 = J * z11 * z11
        z13 = l * c_p_f
        z14 = l * c_p_b
        z15 = s1 * z13 + z14 * s2
        z16 = z15 * z10
        z17 = c2 * z13 + z14 * c1
        z18 = z17 * z10
        z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18))
        s5 = z12 + m * (z16 * z16)
        s6 = s5 + m * (z18 * z18)
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * s6:
            raise SingularModelError(2, "accelerations")
        z20 = p_b_dot * c_p_b
        z21 = p_f_dot * c_p_f
        z22 = s_p_f * z21
        z23 = k1 * z22
        z24 = p_b_dot * s_p_b
        z25 = p_f_dot * s_p_f
        s7 = 2.0 * (k2 * (z4 * z21 - s_p_f * (c_p_f * z24 + c_p_b * z25)))
        z26 = z3 * z20 - 4.0 * (s_p_b * (z22 - z23)) - s7
        z27 = (z5 * z20 + s_p_b * z26 + (2.0 * z22 - 6.0 * z23)) / (z6 * z6)
        z28 = z17 * z27
        z29 = z9 * v
        z30 = z10 * z29
        z31 = p_b_dot - z30
        z32 = s1 * z31
        z33 = l * z25
        z34 = l * z24
        z35 = p_f_dot - z30
        z36 = s2 * z35
        z37 = z13 * z32 + c2 * z33 + (c1 * z34 + z14 * z36)
        z38 = t_ * nu
        s3 = math.sin(z38)
        z39 = c2 * z31
        z40 = c1 * z35
        z41 = c1 * z39 - s1 * z36 + (s2 * z32 - c2 * z40)
        z42 = v * (z10 * z41 - z9 * z27)
        z43 = J_r * z42
        z44 = tau * s3 + z43
        c3 = math.cos(z38)
        z45 = sigma * c3
        z46 = J_w * z42
        z47 = z45 + z46
        z48 = z45 - z46
        z49 = z13 * z39 - s1 * z33 - (s2 * z34 - z14 * z40)
        z50 = z15 * z27
        z51 = m * v
        s8 = z11 * (z44 - (z43 - (z47 - (z46 + (z48 + z42 * k7)))))
        z52 = s8 - (z10 * z49 - z50) * (z16 * z51)
        z53 = (z52 + (z10 * z37 + z28) * (z18 * z51)) / z19
        z54 = z11 * z53
        qddot: list[float] = [
            # x'' (I.2.15)
            -(v * z28 + z10 * (v * z37 - z17 * z53)),
            # y'' (I.2.15)
            z10 * (v * z49 + z15 * z53) - v * z50,
            # theta'' (I.2.15)
            z29 * z27 - z10 * (v * z41 + z9 * z53),
            # psi'' (I.2.15)
            k5 * z44 + z54,
            # p_b'' (I.2.15)
            k6 * z47 + z54,
            # p_f'' (I.2.15)
            z54 - k6 * z48,
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
        z2 = theta + p_f
        c2 = math.cos(z2)
        s1 = math.sin(z1)
        s2 = math.sin(z2)
        s3 = x_dot * (l * (c1 * c_p_f + c_p_b * c2))
        z3 = s3 + y_dot * (l * (s1 * c_p_f + c_p_b * s2))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z3,
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
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "reactions")
        z7 = theta + p_b
        s1 = math.sin(z7)
        z8 = theta + p_f
        c1 = math.cos(z8)
        c2 = math.cos(z7)
        s2 = math.sin(z8)
        z9 = s1 * c1 - c2 * s2
        z10 = 1.0 / z6
        z11 = z9 * z10
        z12 = J * z11 * z11
        z13 = l * c_p_f
        z14 = l * c_p_b
        z15 = s1 * z13 + z14 * s2
        z16 = z15 * z10
        z17 = c2 * z13 + z14 * c1
        z18 = z17 * z10
        z19 = z12 + m * (z10 * (z15 * z16 + z17 * z18))
        s5 = z12 + m * (z16 * z16)
        s6 = s5 + m * (z18 * z18)
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * s6:
            raise SingularModelError(2, "reactions")
        z20 = l * (s1 * c_p_f + c_p_b * s2)
        z21 = c_p_b * s_p_f - c_p_f * s_p_b
        z22 = z10 * (z13 * z20 - c1 * z21)
        z23 = p_b_dot * c_p_b
        z24 = p_f_dot * c_p_f
        z25 = s_p_f * z24
        z26 = k1 * z25
        z27 = p_b_dot * s_p_b
        z28 = p_f_dot * s_p_f
        s7 = 2.0 * (k2 * (z4 * z24 - s_p_f * (c_p_f * z27 + c_p_b * z28)))
        z29 = z3 * z23 - 4.0 * (s_p_b * (z25 - z26)) - s7
        z30 = (z5 * z23 + s_p_b * z29 + (2.0 * z25 - 6.0 * z26)) / (z6 * z6)
        z31 = z17 * z30
        z32 = z9 * v
        z33 = z10 * z32
        z34 = p_b_dot - z33
        z35 = s1 * z34
        z36 = l * z28
        z37 = l * z27
        z38 = p_f_dot - z33
        z39 = s2 * z38
        z40 = z13 * z35 + c2 * z36 + (c1 * z37 + z14 * z39)
        z41 = v * z10
        z42 = v * z31 + z40 * z41
        z43 = l * (c2 * c_p_f + c_p_b * c1)
        z44 = z10 * (z13 * z43 + s2 * z21)
        z45 = z15 * z30
        z46 = c2 * z34
        z47 = c1 * z38
        z48 = z13 * z46 - s1 * z36 - (s2 * z37 - z14 * z47)
        z49 = v * z45 - z48 * z41
        z50 = z10 * (c1 * z43 + s2 * z20)
        z51 = c1 * z46 - s1 * z39 + (s2 * z35 - c2 * z47)
        z52 = z32 * z30 - z51 * z41
        z53 = z50 * z52
        s8 = m * (z22 * z42 - z44 * z49) - J * z53 - J_r * z53
        z54 = s8 - 2.0 * (J_w * z53)
        z55 = t_ * nu
        c3 = math.cos(z55)
        z56 = sigma * c3
        z57 = v * (z10 * z51 - z9 * z30)
        z58 = J_w * z57
        z59 = z56 - z58
        s3 = math.sin(z55)
        z60 = J_r * z57
        z61 = tau * s3 + z60
        z62 = z56 + z58
        z63 = m * v
        s9 = z11 * (z61 - (z60 - (z62 - (z58 + (z59 + z57 * k7)))))
        z64 = s9 - (z10 * z48 - z45) * (z16 * z63)
        z65 = (z64 + (z10 * z40 + z31) * (z18 * z63)) / z19
        z66 = z11 * z65
        z67 = k6 * z59 - z66
        z68 = J_w * z50
        z69 = k6 * z62 + z66
        z70 = z11 * z50
        s10 = m * (z18 * z22 - z16 * z44) - J * z70 - J_r * z70
        z71 = s10 - 2.0 * (J_w * z70)
        z72 = J_r * (k5 * z61 + z66)
        z73 = z10 * (z14 * z20 + c2 * z21)
        z74 = z10 * (z14 * z43 - s1 * z21)
        z75 = z10 * (c2 * z43 + s1 * z20)
        z76 = z75 * z52
        s11 = m * (z73 * z42 - z74 * z49) + J * z76 + J_r * z76
        z77 = s11 + 2.0 * (J_w * z76)
        z78 = J_w * z75
        z79 = z11 * z75
        s12 = m * (z18 * z73 - z16 * z74) + J * z79 + J_r * z79
        z80 = s12 + 2.0 * (J_w * z79)
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            z54 + (z67 * z68 - (z69 * z68 + (z65 * z71 + z50 * z72))),
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            z77 - (z67 * z78 - (z69 * z78 - (z65 * z80 - z75 * z72))),
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
        z4 = theta + p_f
        c2 = math.cos(z4)
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z5 = s_p_f * s_p_f
        z6 = 2.0 * z5
        s3 = s_p_b * (1.0 - z6 - k1 * (3.0 - z6))
        z7 = s_p_b * (s3 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z8 = v / (z7 + (z5 + k1 * (4.0 - 3.0 * z5)))
        z9 = (c1 * z2 + z3 * c2) * z8
        s1 = math.sin(z1)
        s2 = math.sin(z4)
        z10 = (s1 * z2 + z3 * s2) * z8
        z11 = (s1 * c2 - c1 * s2) * z8
        z12 = psi_dot - z11
        z13 = p_b_dot - z11
        z14 = p_f_dot - z11
        s4 = m * (z9 * z9 + z10 * z10) + J * (z11 * z11)
        z15 = s4 + J_r * (z12 * z12) + J_w * (z13 * z13 + z14 * z14)
        value1 = 0.5 * z15
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
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
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
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z7) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "jacobian")
        z8 = 1.0 / z7
        z9 = theta + p_b
        s1 = math.sin(z9)
        z10 = theta + p_f
        c1 = math.cos(z10)
        c2 = math.cos(z9)
        s2 = math.sin(z10)
        z11 = s1 * c1 - c2 * s2
        z12 = z11 * z8
        z13 = z11 * z12
        z14 = l * c_p_f
        z15 = s1 * z14
        z16 = l * c_p_b
        z17 = z16 * s2
        z18 = z15 + z17
        z19 = z18 * z8
        z20 = c2 * z14
        z21 = z16 * c1
        z22 = z20 + z21
        z23 = z22 * z8
        z24 = z18 * z19 + z22 * z23
        z25 = J_2 * (z8 * z13) + m * (z8 * z24)
        s5 = J_2 * (z12 * z12)
        s6 = s5 + m * (z19 * z19)
        s7 = s6 + m * (z23 * z23)
        # the mass matrix is singular
        if not abs(z25) > 1e-14 * s7:
            raise SingularModelError(2, "jacobian")
        z26 = z18 * v
        z27 = z22 * v
        z28 = 1.0 / (z7 * z7)
        z29 = c_p_f * s_p_b
        z30 = c_p_b * z3 + 2.0 * (z29 * z5)
        z31 = c_p_b * z6 + s_p_b * z30
        z32 = z28 * z31
        z33 = l * s_p_b
        z34 = z15 + c1 * z33
        z35 = v * z8
        z36 = c_p_f * s_p_f
        z37 = k1 * z36
        z38 = z36 - z37
        z39 = c_p_b * s_p_f
        s8 = 2.0 * (k2 * (c_p_f * z4 - s_p_f * z39))
        z40 = 4.0 * (s_p_b * z38) + s8
        z41 = s_p_b * z40 - (2.0 * z36 - 6.0 * z37)
        z42 = z41 * z28
        z43 = l * s_p_f
        z44 = z17 + c2 * z43
        z45 = z20 - s2 * z33
        z46 = z21 - s1 * z43
        z47 = z11 * v
        z48 = s1 * s2 + c2 * c1
        z49 = z48 * z35
        z50 = z47 * z32 - z49
        z51 = z49 - z47 * z42
        z52 = z48 * z12
        z53 = z48 * z8
        z54 = z53 - z11 * z32
        z55 = z45 * z8 - z18 * z32
        z56 = z34 * z8 + z22 * z32
        s9 = z8 * (z45 * z19 + z18 * z55 - (z34 * z23 + z22 * z56))
        z57 = m * (z24 * z32 - s9)
        z58 = t_ * nu
        s3 = math.sin(z58)
        z59 = z47 * z8
        z60 = p_b_dot - z59
        z61 = c2 * z60
        z62 = p_f_dot - z59
        z63 = s2 * z62
        z64 = s1 * z60
        z65 = c1 * z62
        z66 = c1 * z61 - s1 * z63 + (s2 * z64 - c2 * z65)
        z67 = p_f_dot * c_p_f
        z68 = s_p_f * z67
        z69 = k1 * z68
        z70 = p_b_dot * c_p_b
        z71 = z68 - z69
        z72 = p_b_dot * s_p_b
        z73 = p_f_dot * s_p_f
        z74 = c_p_f * z72 + c_p_b * z73
        s10 = 2.0 * (k2 * (z4 * z67 - s_p_f * z74))
        z75 = z3 * z70 - 4.0 * (s_p_b * z71) - s10
        z76 = 2.0 * z68 - 6.0 * z69 + (s_p_b * z75 + z70 * z6)
        z77 = z28 * z76
        z78 = z8 * z66 - z11 * z77
        z79 = v * z78
        z80 = J_r * z79
        c3 = math.cos(z58)
        z81 = sigma * c3
        z82 = J_w * z79
        s11 = z80 - (z81 + z82 - (z82 + (z81 - z82 + k5 * z79)))
        z83 = tau * s3 + z80 - s11
        z84 = m * v
        z85 = l * z73
        z86 = s1 * z85
        z87 = l * z72
        z88 = s2 * z87
        z89 = z86 - z14 * z61 + (z88 - z16 * z65)
        z90 = z8 * z89 + z18 * z77
        z91 = z84 * z90
        z92 = c2 * z85
        z93 = c1 * z87
        z94 = z92 + z14 * z64 + (z93 + z16 * z63)
        z95 = z8 * z94 + z22 * z77
        z96 = z84 * z95
        z97 = z12 * z83 + z19 * z91 + z23 * z96
        z98 = z97 / (z25 * z25)
        z99 = 1.0 / z25
        z100 = z64 - c2 * z50
        z101 = s2 * z50
        z102 = z61 + s1 * z50
        z103 = c1 * z50
        s12 = c1 * z100 + (c2 * z63 + s1 * z101)
        z104 = s12 - (s2 * z102 + (s1 * z65 - c2 * z103))
        z105 = z48 * z77
        z106 = z76 / (z7 * z7 * z7)
        s13 = 2.0 * (k2 * (z29 * z67 - s_p_f * (s_p_b * z73 - c_p_f * z70)))
        z107 = z3 * z72 + 4.0 * (c_p_b * z71) - s13
        s14 = z28 * (c_p_b * z75 - s_p_b * z107 + (z70 * z30 - z72 * z6))
        z108 = 2.0 * (z31 * z106) - s14
        z109 = v * (z66 * z32 + z8 * z104 + (z105 - z11 * z108))
        z110 = J_2 * z12
        z111 = l * z70
        s15 = z92 + z14 * z100 + (s2 * z111 + (z33 * z65 - z16 * z103))
        z112 = z89 * z32 - z8 * s15
        z113 = z84 * z19
        s16 = z91 * z55 - (z112 - (z45 * z77 - z18 * z108)) * z113
        z114 = z83 * z54 + z109 * z110 + s16
        s17 = z86 - z14 * z102 - (c1 * z111 - (z33 * z63 - z16 * z101))
        z115 = z94 * z32 + z8 * s17
        z116 = z84 * z23
        s18 = z114 - (z96 * z56 + (z115 + (z34 * z77 + z22 * z108)) * z116)
        s19 = (J_2 * (z13 * z32 - z8 * (z52 + z11 * z54)) + z57) * z98
        z117 = s19 + z99 * s18
        z118 = z53 - z11 * z42
        z119 = z46 * z8 + z18 * z42
        z120 = z44 * z8 - z22 * z42
        s20 = z8 * (z46 * z19 + z18 * z119 - (z44 * z23 + z22 * z120))
        z121 = m * (z24 * z42 + s20)
        z122 = c2 * z51
        z123 = z65 + s2 * z51
        z124 = s1 * z51
        z125 = z63 - c1 * z51
        s21 = s2 * z61 - c1 * z122 + s1 * z123
        z126 = s21 - (c1 * z64 + s2 * z124 + c2 * z125)
        z127 = c_p_f * z67 - s_p_f * z73
        z128 = k1 * z127
        s22 = c_p_f * z74 - s_p_f * (s_p_f * z72 - c_p_b * z67)
        z129 = k2 * (z39 * z67 + z4 * z73 + s22)
        s23 = 4.0 * (z70 * z38 + s_p_b * (z127 - z128)) - 2.0 * z129
        z130 = z70 * z40 + s_p_b * s23 - (2.0 * z127 - 6.0 * z128)
        z131 = 2.0 * (z41 * z106) - z130 * z28
        z132 = v * (z66 * z42 - z8 * z126 + (z105 - z11 * z131))
        z133 = l * z67
        s24 = s1 * z133 + (z43 * z61 - z14 * z122) + (z93 + z16 * z125)
        z134 = z89 * z42 + z8 * s24
        s25 = z91 * z119 + z113 * (z134 + (z46 * z77 + z18 * z131))
        z135 = z83 * z118 + z110 * z132 - s25
        s26 = c2 * z133 - (z43 * z64 - z14 * z124) - (z88 - z16 * z123)
        z136 = z94 * z42 + z8 * s26
        s27 = z135 + (z96 * z120 - z116 * (z136 - (z44 * z77 - z22 * z131)))
        s28 = z98 * (J_2 * (z13 * z42 - z8 * (z52 + z11 * z118)) + z121)
        z137 = s28 + z99 * s27
        z138 = c2 * z12
        z139 = s2 * z12
        z140 = s1 * z12
        z141 = c1 * z12
        s29 = z35 * (c1 * z138 - s1 * z139 + (s2 * z140 - c2 * z141))
        z142 = z78 - s29
        s30 = m * (z19 * (z90 + z35 * (z14 * z138 + z16 * z141)))
        s31 = m * (z23 * (z95 - z35 * (z14 * z140 + z16 * z139)))
        z143 = z110 * z142 - s30 - s31
        z144 = z99 * z143
        z145 = v * z54
        z146 = z99 * (z110 * z145 + z55 * z113 - z56 * z116)
        z147 = v * z118
        z148 = z99 * (z110 * z147 - z113 * z119 + z116 * z120)
        z149 = z99 * z97
        z150 = z109 - (z149 * z54 + z12 * z117)
        z151 = z132 - (z149 * z118 + z12 * z137)
        z152 = z142 - z12 * z144
        z153 = z145 - z12 * z146
        z154 = z147 - z12 * z148
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -z26 * z8,
            0.0,
            # (I.2.15)
            -(z27 * z32 + z34 * z35),
            # (I.2.15)
            z27 * z42 - z44 * z35,
            # (I.2.15)
            z23,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z27 * z8,
            0.0,
            # (I.2.15)
            z45 * z35 - z26 * z32,
            # (I.2.15)
            z26 * z42 + z46 * z35,
            # (I.2.15)
            z19,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z50,
            # (I.2.15)
            z51,
            # (I.2.15)
            -z12,
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
            z117,
            # (I.2.15)
            -z137,
            # (I.2.15)
            -z144,
            0.0,
            # (I.2.15)
            -z146,
            # (I.2.15)
            z148,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z150,
            # (I.2.15)
            z151,
            # (I.2.15)
            z152,
            0.0,
            # (I.2.15)
            z153,
            # (I.2.15)
            -z154,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z150,
            # (I.2.15)
            z151,
            # (I.2.15)
            z152,
            0.0,
            # (I.2.15)
            z153,
            # (I.2.15)
            -z154,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z150,
            # (I.2.15)
            z151,
            # (I.2.15)
            z152,
            0.0,
            # (I.2.15)
            z153,
            # (I.2.15)
            -z154,
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
    theta = float(y[2])  # heading of the board [rad]
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
        s3 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s3 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s4 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s4):
            raise SingularModelError(1, "outputs")
        z5 = theta + p_f
        s1 = math.sin(z5)
        s_theta = math.sin(theta)
        c1 = math.cos(z5)
        c_theta = math.cos(theta)
        z6 = theta + p_b
        s2 = math.sin(z6)
        c2 = math.cos(z6)
        s5 = c_p_b * (s1 * s_theta + c1 * c_theta)
        z7 = v / z4 * (s5 + c_p_f * (s2 * s_theta + c2 * c_theta))
        out: list[float] = [
            # speed 32:10
            l * z7,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
