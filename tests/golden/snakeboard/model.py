# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:171a0d5565d08b90).

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
rhs: 58 +-, 110 *, 4 /, 9 calls
velocities: 18 +-, 34 *, 1 /, 7 calls
accelerations: 64 +-, 121 *, 4 /, 9 calls
state: 10 +-, 17 *, 0 /, 6 calls
residuals: 6 +-, 7 *, 0 /, 6 calls
reactions: 94 +-, 183 *, 4 /, 9 calls
energy: 24 +-, 42 *, 1 /, 6 calls
jacobian: 194 +-, 347 *, 2 /, 9 calls
outputs: 17 +-, 31 *, 1 /, 7 calls

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
        super().__init__(status, function)  # what copies and pickles make it of again
        self.status = status

    def __str__(self) -> str:
        return f"{self.args[1]}: {REASONS[self.status]}"


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
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "rhs")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        c1 = math.cos(z8)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        z13 = s1 * z11 - c1 * z12
        z14 = z7 * z13
        z15 = J * z14 * z14
        z16 = l * c_p_f
        z17 = l * c_p_b
        z18 = s1 * z16 + z17 * z12
        z19 = z7 * z18
        z20 = c1 * z16 + z17 * z11
        z21 = z7 * z20
        z22 = z15 + m * (z7 * (z18 * z19 + z20 * z21))
        s4 = z15 + m * (z19 * z19)
        s5 = s4 + m * (z21 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * s5:
            raise SingularModelError(2, "rhs")
        z23 = v * z7
        z24 = z13 * z23
        z25 = t_ * nu
        s2 = math.sin(z25)
        z26 = p_b_dot * c_p_b
        z27 = p_f_dot * c_p_f
        z28 = s_p_f * z27
        z29 = k1 * z28
        z30 = p_b_dot * s_p_b
        z31 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z27 - s_p_f * (c_p_f * z30 + c_p_b * z31)))
        z32 = z3 * z26 - 4.0 * (s_p_b * (z28 - z29)) - s6
        z33 = z7 * z7 * (z5 * z26 + s_p_b * z32 + (2.0 * z28 - 6.0 * z29))
        z34 = p_b_dot - z24
        z35 = c1 * z34
        z36 = p_f_dot - z24
        z37 = z12 * z36
        z38 = s1 * z34
        z39 = z11 * z36
        s7 = z7 * (z11 * z35 - s1 * z37 + (z12 * z38 - c1 * z39))
        z40 = v * (z33 * z13 - s7)
        z41 = J_r * z40
        z42 = tau * s2 - z41
        c2 = math.cos(z25)
        z43 = sigma * c2
        z44 = J_w * z40
        z45 = z43 - z44
        z46 = z43 + z44
        z47 = l * z31
        z48 = l * z30
        z49 = m * v
        s8 = z7 * (s1 * z47 - z16 * z35 + (z48 * z12 - z17 * z39))
        z50 = (z33 * z18 + s8) * (z19 * z49)
        s9 = z7 * (c1 * z47 + z16 * z38 + (z48 * z11 + z17 * z37))
        z51 = (z33 * z20 + s9) * (z21 * z49)
        s10 = z14 * (z42 + (z41 + (z45 + (z44 - (z46 - k7 * z40))))) + z50
        z52 = (s10 + z51) / z22
        z53 = z14 * z52
        dydt: list[float] = [
            # x' (I.2.15)
            z20 * z23,
            # y' (I.2.15)
            z18 * z23,
            # theta' (I.2.15)
            -z24,
            # psi' (I.2.15)
            psi_dot,
            # p_b' (I.2.15)
            p_b_dot,
            # p_f' (I.2.15)
            p_f_dot,
            # v' (I.2.15) 22:4
            z52,
            # psi'' (I.2.15) 22:4
            z53 + k5 * z42,
            # p_b'' (I.2.15) 22:4
            z53 + k6 * z45,
            # p_f'' (I.2.15) 22:4
            z53 - k6 * z46,
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
            (c1 * z12 - s1 * z10) * z11,
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
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "accelerations")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        c1 = math.cos(z8)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        z13 = s1 * z11 - c1 * z12
        z14 = z7 * z13
        z15 = J * z14 * z14
        z16 = l * c_p_f
        z17 = l * c_p_b
        z18 = s1 * z16 + z17 * z12
        z19 = z7 * z18
        z20 = c1 * z16 + z17 * z11
        z21 = z7 * z20
        z22 = z15 + m * (z7 * (z18 * z19 + z20 * z21))
        s4 = z15 + m * (z19 * z19)
        s5 = s4 + m * (z21 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * s5:
            raise SingularModelError(2, "accelerations")
        z23 = p_b_dot * c_p_b
        z24 = p_f_dot * c_p_f
        z25 = s_p_f * z24
        z26 = k1 * z25
        z27 = p_b_dot * s_p_b
        z28 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z24 - s_p_f * (c_p_f * z27 + c_p_b * z28)))
        z29 = z3 * z23 - 4.0 * (s_p_b * (z25 - z26)) - s6
        z30 = z7 * z7 * (z5 * z23 + s_p_b * z29 + (2.0 * z25 - 6.0 * z26))
        z31 = v * z30
        z32 = l * z28
        z33 = v * z13
        z34 = z7 * z33
        z35 = p_b_dot - z34
        z36 = s1 * z35
        z37 = l * z27
        z38 = p_f_dot - z34
        z39 = z12 * z38
        z40 = c1 * z32 + z16 * z36 + (z37 * z11 + z17 * z39)
        z41 = t_ * nu
        s2 = math.sin(z41)
        z42 = c1 * z35
        z43 = z11 * z38
        z44 = z11 * z42 - s1 * z39 + (z12 * z36 - c1 * z43)
        z45 = v * (z7 * z44 - z30 * z13)
        z46 = J_r * z45
        z47 = tau * s2 + z46
        c2 = math.cos(z41)
        z48 = sigma * c2
        z49 = J_w * z45
        z50 = z48 + z49
        z51 = z48 - z49
        z52 = s1 * z32 - z16 * z42 + (z37 * z12 - z17 * z43)
        z53 = m * v
        s7 = z14 * (z47 - (z46 - (z50 - (z49 + (z51 + k7 * z45)))))
        z54 = s7 + (z7 * z52 + z30 * z18) * (z19 * z53)
        z55 = (z54 + (z7 * z40 + z30 * z20) * (z21 * z53)) / z22
        z56 = z14 * z55
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z20 * z31 + z7 * (v * z40 - z20 * z55)),
            # y'' (I.2.15)
            -(z18 * z31 + z7 * (v * z52 - z18 * z55)),
            # theta'' (I.2.15)
            z30 * z33 - z7 * (v * z44 + z13 * z55),
            # psi'' (I.2.15)
            k5 * z47 + z56,
            # p_b'' (I.2.15)
            k6 * z50 + z56,
            # p_f'' (I.2.15)
            z56 - k6 * z51,
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
        c1 = math.cos(z8)
        z9 = c1 * c_p_f
        z10 = z9 - s1 * s_p_f
        z11 = s1 * c_p_f
        z12 = z11 + c1 * s_p_f
        z13 = c_p_b * z10 + s_p_b * z12
        z14 = c_p_b * z12 - s_p_b * z10
        z15 = s1 * z13 - c1 * z14
        z16 = z7 * z15
        z17 = J * z16 * z16
        z18 = l * c_p_f
        z19 = l * c_p_b
        z20 = s1 * z18 + z19 * z14
        z21 = z7 * z20
        z22 = c1 * z18 + z19 * z13
        z23 = z7 * z22
        z24 = z17 + m * (z7 * (z20 * z21 + z22 * z23))
        s4 = z17 + m * (z21 * z21)
        s5 = s4 + m * (z23 * z23)
        # the mass matrix is singular
        if not abs(z24) > 1e-14 * s5:
            raise SingularModelError(2, "reactions")
        z25 = l * (z11 + c_p_b * z14)
        z26 = c_p_b * s_p_f - c_p_f * s_p_b
        z27 = z7 * (z18 * z25 - z26 * z13)
        z28 = p_b_dot * c_p_b
        z29 = p_f_dot * c_p_f
        z30 = s_p_f * z29
        z31 = k1 * z30
        z32 = p_b_dot * s_p_b
        z33 = p_f_dot * s_p_f
        s6 = 2.0 * (k2 * (z4 * z29 - s_p_f * (c_p_f * z32 + c_p_b * z33)))
        z34 = z3 * z28 - 4.0 * (s_p_b * (z30 - z31)) - s6
        z35 = z7 * z7 * (z5 * z28 + s_p_b * z34 + (2.0 * z30 - 6.0 * z31))
        z36 = v * z35
        z37 = l * z33
        z38 = v * z15
        z39 = z7 * z38
        z40 = p_b_dot - z39
        z41 = s1 * z40
        z42 = l * z32
        z43 = p_f_dot - z39
        z44 = z14 * z43
        z45 = c1 * z37 + z18 * z41 + (z42 * z13 + z19 * z44)
        z46 = v * z7
        z47 = z22 * z36 + z45 * z46
        z48 = l * (z9 + c_p_b * z13)
        z49 = z7 * (z18 * z48 + z26 * z14)
        z50 = c1 * z40
        z51 = z13 * z43
        z52 = s1 * z37 - z18 * z50 + (z42 * z14 - z19 * z51)
        z53 = z20 * z36 + z52 * z46
        z54 = z7 * (z13 * z48 + z14 * z25)
        z55 = z13 * z50 - s1 * z44 + (z14 * z41 - c1 * z51)
        z56 = z35 * z38 - z55 * z46
        z57 = z54 * z56
        s7 = m * (z27 * z47 - z49 * z53) - J * z57 - J_r * z57
        z58 = s7 - 2.0 * (J_w * z57)
        z59 = t_ * nu
        c2 = math.cos(z59)
        z60 = sigma * c2
        z61 = v * (z7 * z55 - z35 * z15)
        z62 = J_w * z61
        z63 = z60 - z62
        s2 = math.sin(z59)
        z64 = J_r * z61
        z65 = tau * s2 + z64
        z66 = z60 + z62
        z67 = m * v
        s8 = z16 * (z65 - (z64 - (z66 - (z62 + (z63 + k7 * z61)))))
        z68 = s8 + (z7 * z52 + z35 * z20) * (z21 * z67)
        z69 = (z68 + (z7 * z45 + z35 * z22) * (z23 * z67)) / z24
        z70 = z16 * z69
        z71 = k6 * z63 - z70
        z72 = J_w * z54
        z73 = k6 * z66 + z70
        z74 = z16 * z54
        s9 = m * (z23 * z27 - z21 * z49) - J * z74 - J_r * z74
        z75 = s9 - 2.0 * (J_w * z74)
        z76 = J_r * (k5 * z65 + z70)
        z77 = z7 * (c1 * z26 + z19 * z25)
        z78 = z7 * (s1 * z26 - z19 * z48)
        z79 = z7 * (c1 * z48 + s1 * z25)
        z80 = z79 * z56
        s10 = m * (z77 * z47 + z78 * z53) + J * z80 + J_r * z80
        z81 = s10 + 2.0 * (J_w * z80)
        z82 = J_w * z79
        z83 = z16 * z79
        s11 = m * (z23 * z77 + z21 * z78) + J * z83 + J_r * z83
        z84 = s11 + 2.0 * (J_w * z83)
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            z58 + (z71 * z72 - (z73 * z72 + (z69 * z75 + z54 * z76))),
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            z81 - (z71 * z82 - (z73 * z82 - (z69 * z84 - z79 * z76))),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

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
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z7) > 1e-12 * (k4 * s3):
            raise SingularModelError(1, "jacobian")
        z8 = 1.0 / z7
        z9 = theta + p_b
        s1 = math.sin(z9)
        c1 = math.cos(z9)
        z10 = c1 * c_p_f - s1 * s_p_f
        z11 = s1 * c_p_f + c1 * s_p_f
        z12 = c_p_b * z10 + s_p_b * z11
        z13 = c_p_b * z11 - s_p_b * z10
        z14 = s1 * z12 - c1 * z13
        z15 = z14 * z8
        z16 = z14 * z15
        z17 = l * c_p_f
        z18 = s1 * z17
        z19 = l * c_p_b
        z20 = z19 * z13
        z21 = z18 + z20
        z22 = z21 * z8
        z23 = c1 * z17
        z24 = z19 * z12
        z25 = z23 + z24
        z26 = z25 * z8
        z27 = z21 * z22 + z25 * z26
        z28 = J_2 * (z8 * z16) + m * (z8 * z27)
        s4 = J_2 * (z15 * z15)
        s5 = s4 + m * (z22 * z22)
        s6 = s5 + m * (z26 * z26)
        # the mass matrix is singular
        if not abs(z28) > 1e-14 * s6:
            raise SingularModelError(2, "jacobian")
        z29 = v * z21
        z30 = v * z25
        z31 = z8 * z8
        z32 = c_p_f * s_p_b
        z33 = c_p_b * z3 + 2.0 * (z32 * z5)
        z34 = c_p_b * z6 + s_p_b * z33
        z35 = z31 * z34
        z36 = l * s_p_b
        z37 = z18 + z12 * z36
        z38 = v * z8
        z39 = c_p_f * s_p_f
        z40 = k1 * z39
        z41 = z39 - z40
        z42 = c_p_b * s_p_f
        s7 = 2.0 * (k2 * (c_p_f * z4 - s_p_f * z42))
        z43 = 4.0 * (s_p_b * z41) + s7
        z44 = s_p_b * z43 - (2.0 * z39 - 6.0 * z40)
        z45 = z44 * z31
        z46 = l * s_p_f
        z47 = z20 + c1 * z46
        z48 = z23 - z13 * z36
        z49 = z24 - s1 * z46
        z50 = v * z14
        z51 = s1 * z13 + c1 * z12
        z52 = z51 * z38
        z53 = z50 * z35 - z52
        z54 = z52 - z50 * z45
        z55 = z51 * z15
        z56 = z51 * z8
        z57 = z56 - z14 * z35
        z58 = z48 * z8 - z21 * z35
        z59 = z37 * z8 + z25 * z35
        s8 = z8 * (z48 * z22 + z21 * z58 - (z37 * z26 + z25 * z59))
        z60 = m * (z27 * z35 - s8)
        z61 = t_ * nu
        s2 = math.sin(z61)
        z62 = z50 * z8
        z63 = p_b_dot - z62
        z64 = c1 * z63
        z65 = p_f_dot - z62
        z66 = z13 * z65
        z67 = s1 * z63
        z68 = z12 * z65
        z69 = z12 * z64 - s1 * z66 + (z13 * z67 - c1 * z68)
        z70 = p_f_dot * c_p_f
        z71 = s_p_f * z70
        z72 = k1 * z71
        z73 = p_b_dot * c_p_b
        z74 = z71 - z72
        z75 = p_b_dot * s_p_b
        z76 = p_f_dot * s_p_f
        z77 = c_p_f * z75 + c_p_b * z76
        s9 = 2.0 * (k2 * (z4 * z70 - s_p_f * z77))
        z78 = z3 * z73 - 4.0 * (s_p_b * z74) - s9
        z79 = 2.0 * z71 - 6.0 * z72 + (s_p_b * z78 + z73 * z6)
        z80 = z31 * z79
        z81 = z8 * z69 - z14 * z80
        z82 = v * z81
        z83 = J_r * z82
        c2 = math.cos(z61)
        z84 = sigma * c2
        z85 = J_w * z82
        s10 = z83 - (z84 + z85 - (z85 + (z84 - z85 + k5 * z82)))
        z86 = tau * s2 + z83 - s10
        z87 = m * v
        z88 = l * z76
        z89 = s1 * z88
        z90 = l * z75
        z91 = z90 * z13
        z92 = z89 - z17 * z64 + (z91 - z19 * z68)
        z93 = z8 * z92 + z21 * z80
        z94 = z87 * z93
        z95 = c1 * z88
        z96 = z90 * z12
        z97 = z95 + z17 * z67 + (z96 + z19 * z66)
        z98 = z8 * z97 + z25 * z80
        z99 = z87 * z98
        z100 = z15 * z86 + z22 * z94 + z26 * z99
        z101 = 1.0 / z28
        z102 = z100 * (z101 * z101)
        z103 = z67 - c1 * z53
        z104 = z13 * z53
        z105 = z64 + s1 * z53
        z106 = z12 * z53
        s11 = z12 * z103 + (c1 * z66 + s1 * z104)
        z107 = s11 - (z13 * z105 + (s1 * z68 - c1 * z106))
        z108 = z51 * z80
        z109 = z79 * (z31 * z8)
        s12 = 2.0 * (k2 * (z32 * z70 - s_p_f * (s_p_b * z76 - c_p_f * z73)))
        z110 = z3 * z75 + 4.0 * (c_p_b * z74) - s12
        s13 = z31 * (c_p_b * z78 - s_p_b * z110 + (z73 * z33 - z75 * z6))
        z111 = 2.0 * (z34 * z109) - s13
        z112 = v * (z69 * z35 + z8 * z107 + (z108 - z14 * z111))
        z113 = J_2 * z15
        z114 = l * z73
        s14 = z95 + z17 * z103 + (z13 * z114 + (z36 * z68 - z19 * z106))
        z115 = z92 * z35 - z8 * s14
        z116 = z87 * z22
        s15 = z94 * z58 - (z115 - (z48 * z80 - z21 * z111)) * z116
        z117 = z86 * z57 + z112 * z113 + s15
        s16 = z89 - z17 * z105 - (z12 * z114 - (z36 * z66 - z19 * z104))
        z118 = z97 * z35 + z8 * s16
        z119 = z87 * z26
        s17 = z117 - (z99 * z59 + (z118 + (z37 * z80 + z25 * z111)) * z119)
        s18 = (J_2 * (z16 * z35 - z8 * (z55 + z14 * z57)) + z60) * z102
        z120 = s18 + z101 * s17
        z121 = z56 - z14 * z45
        z122 = z49 * z8 + z21 * z45
        z123 = z47 * z8 - z25 * z45
        s19 = z8 * (z49 * z22 + z21 * z122 - (z47 * z26 + z25 * z123))
        z124 = m * (z27 * z45 + s19)
        z125 = c1 * z54
        z126 = z68 + z13 * z54
        z127 = s1 * z54
        z128 = z66 - z12 * z54
        s20 = z13 * z64 - z12 * z125 + s1 * z126
        z129 = s20 - (z12 * z67 + z13 * z127 + c1 * z128)
        z130 = c_p_f * z70 - s_p_f * z76
        z131 = k1 * z130
        s21 = c_p_f * z77 - s_p_f * (s_p_f * z75 - c_p_b * z70)
        z132 = k2 * (z42 * z70 + z4 * z76 + s21)
        s22 = 4.0 * (z73 * z41 + s_p_b * (z130 - z131)) - 2.0 * z132
        z133 = z73 * z43 + s_p_b * s22 - (2.0 * z130 - 6.0 * z131)
        z134 = 2.0 * (z44 * z109) - z133 * z31
        z135 = v * (z69 * z45 - z8 * z129 + (z108 - z14 * z134))
        z136 = l * z70
        s23 = s1 * z136 + (z46 * z64 - z17 * z125) + (z96 + z19 * z128)
        z137 = z92 * z45 + z8 * s23
        s24 = z94 * z122 + z116 * (z137 + (z49 * z80 + z21 * z134))
        z138 = z86 * z121 + z113 * z135 - s24
        s25 = c1 * z136 - (z46 * z67 - z17 * z127) - (z91 - z19 * z126)
        z139 = z97 * z45 + z8 * s25
        s26 = z138 + (z99 * z123 - z119 * (z139 - (z47 * z80 - z25 * z134)))
        s27 = z102 * (J_2 * (z16 * z45 - z8 * (z55 + z14 * z121)) + z124)
        z140 = s27 + z101 * s26
        z141 = c1 * z15
        z142 = z13 * z15
        z143 = s1 * z15
        z144 = z12 * z15
        s28 = z38 * (z12 * z141 - s1 * z142 + (z13 * z143 - c1 * z144))
        z145 = z81 - s28
        s29 = m * (z22 * (z93 + z38 * (z17 * z141 + z19 * z144)))
        s30 = m * (z26 * (z98 - z38 * (z17 * z143 + z19 * z142)))
        z146 = z113 * z145 - s29 - s30
        z147 = z101 * z146
        z148 = v * z57
        z149 = z101 * (z113 * z148 + z58 * z116 - z59 * z119)
        z150 = v * z121
        z151 = z101 * (z113 * z150 - z116 * z122 + z119 * z123)
        z152 = z101 * z100
        z153 = z112 - (z152 * z57 + z15 * z120)
        z154 = z135 - (z152 * z121 + z15 * z140)
        z155 = z145 - z15 * z147
        z156 = z148 - z15 * z149
        z157 = z150 - z15 * z151
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
            z26,
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
            z22,
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
            -z15,
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
            z120,
            # (I.2.15)
            -z140,
            # (I.2.15)
            -z147,
            0.0,
            # (I.2.15)
            -z149,
            # (I.2.15)
            z151,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z153,
            # (I.2.15)
            z154,
            # (I.2.15)
            z155,
            0.0,
            # (I.2.15)
            z156,
            # (I.2.15)
            -z157,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z153,
            # (I.2.15)
            z154,
            # (I.2.15)
            z155,
            0.0,
            # (I.2.15)
            z156,
            # (I.2.15)
            -z157,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z153,
            # (I.2.15)
            z154,
            # (I.2.15)
            z155,
            0.0,
            # (I.2.15)
            z156,
            # (I.2.15)
            -z157,
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
        s1 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s1 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s2 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s2):
            raise SingularModelError(1, "outputs")
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        s3 = c_theta * (c_p_b * c_theta - s_theta * s_p_b)
        s4 = s_theta * (c_p_f * s_theta + c_theta * s_p_f)
        s5 = c_p_f * (s3 + s_theta * (c_p_b * s_theta + c_theta * s_p_b))
        s6 = c_p_b * (s4 + c_theta * (c_p_f * c_theta - s_theta * s_p_f))
        z5 = s5 + s6
        out: list[float] = [
            # speed 32:10
            l * (v / z4 * z5),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
