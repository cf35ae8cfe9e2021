"""chaplygin_ball, emitted by nhc 0.1.0 (nhc:ba01dedf98154a02).

A ball with three different moments of inertia and its centre of mass at its centre
    rolls on a horizontal plane.
Source: chaplygin_ball.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: centre
y[1] = y [m]: centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = w1
y[6] = w2
y[7] = w3

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: a = 1.0 [m]: radius
p[2]: I1 = 0.4 [kg*m^2]
p[3]: I2 = 0.5 [kg*m^2]
p[4]: I3 = 0.7 [kg*m^2]

Constraints:
0: roll_x
1: roll_y

Outputs:
out[0] = K1
out[1] = K2
out[2] = K3

Operations:
rhs: 23 +-, 55 *, 4 /, 6 calls
velocities: 5 +-, 17 *, 1 /, 6 calls
accelerations: 41 +-, 87 *, 5 /, 6 calls
state: 3 +-, 7 *, 0 /, 4 calls
residuals: 4 +-, 8 *, 0 /, 3 calls
reactions: 26 +-, 62 *, 3 /, 6 calls
energy: 11 +-, 25 *, 0 /, 4 calls
jacobian: 90 +-, 234 *, 5 /, 6 calls
outputs: 8 +-, 19 *, 0 /, 4 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "phi", "theta", "psi")
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "psi", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("m", "a", "I1", "I2", "I3")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("K1", "K2", "K3")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 0.4, 0.5, 0.7)

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

    Arguments: t (scalar), y (8,), p (5,).
    Returns dydt (8,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "rhs")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "rhs")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = c_psi * (s_psi * z4)
        z6 = 1.0 / z2
        z7 = z5 * z6
        z8 = z3 - z5 * z7
        # the mass matrix is singular
        if not abs(z8) > 1e-14 * z3:
            raise SingularModelError(2, "rhs")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = s_theta * k1
        z11 = c_theta * (s_psi * z10)
        z12 = z11 * z6
        z13 = c_theta * (c_psi * z10) + z5 * z12
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z9 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z9:
            raise SingularModelError(2, "rhs")
        c_phi = math.cos(phi)
        z17 = 1.0 / s_theta
        z18 = (c_psi * w2 + s_psi * w1) * z17
        z19 = w3 - c_theta * z18
        s_phi = math.sin(phi)
        z20 = z17 * (s_theta * c_psi * w1 - s_theta * s_psi * w2)
        z21 = w2 * w3 * k2
        z22 = w1 * w3 * k3 - z21 * z7
        z23 = (w1 * w2 * k4 + z21 * z12 - z15 * z22) / z16
        z24 = z14 * z22 - z15 * z23
        dydt: list[float] = [
            # x' (I.2.15)
            -a * (s_theta * c_phi * z19 - s_phi * z20),
            # y' (I.2.15)
            -a * (s_theta * s_phi * z19 + c_phi * z20),
            # phi' (I.2.15)
            z18,
            # theta' (I.2.15)
            z20,
            # psi' (I.2.15)
            z19,
            # w1' (I.2.15) 25:4
            z21 * z6 - z7 * z24 + z12 * z23,
            # w2' (I.2.15) 25:4
            -z24,
            # w3' (I.2.15) 25:4
            z23,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qdot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    a = float(p[1])  # radius [m]
    try:
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "velocities")
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z1 = 1.0 / s_theta
        z2 = (c_psi * w2 + s_psi * w1) * z1
        z3 = w3 - c_theta * z2
        s_phi = math.sin(phi)
        z4 = z1 * (s_theta * c_psi * w1 - s_theta * s_psi * w2)
        qdot: list[float] = [
            # x' (I.2.4)
            -a * (s_theta * c_phi * z3 - s_phi * z4),
            # y' (I.2.4)
            -a * (s_theta * s_phi * z3 + c_phi * z4),
            # phi' (I.2.4)
            z2,
            # theta' (I.2.4)
            z4,
            # psi' (I.2.4)
            z3,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "accelerations")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "accelerations")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = c_psi * (s_psi * z4)
        z6 = 1.0 / z2
        z7 = z5 * z6
        z8 = z3 - z5 * z7
        # the mass matrix is singular
        if not abs(z8) > 1e-14 * z3:
            raise SingularModelError(2, "accelerations")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = s_theta * k1
        z11 = c_theta * (s_psi * z10)
        z12 = z11 * z6
        z13 = c_theta * (c_psi * z10) + z5 * z12
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z9 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z9:
            raise SingularModelError(2, "accelerations")
        z17 = c_psi * w2 + s_psi * w1
        z18 = 1.0 / s_theta
        z19 = z17 * z18
        z20 = w3 - c_theta * z19
        c_phi = math.cos(phi)
        z21 = s_theta * c_psi
        z22 = s_theta * s_psi
        z23 = z21 * w1 - z22 * w2
        z24 = z18 * z23
        z25 = c_theta * z24
        s_phi = math.sin(phi)
        z26 = s_phi * z19
        z27 = w2 * w3 * k2
        z28 = w1 * w3 * k3 - z27 * z7
        z29 = (w1 * w2 * k4 + z27 * z12 - z15 * z28) / z16
        z30 = z25 / (s_theta * s_theta)
        z31 = s_psi * z20
        z32 = z14 * z28 - z15 * z29
        z33 = c_psi * z20
        z34 = z27 * z6 - z7 * z32 + z12 * z29
        s1 = z18 * (w2 * z31 + c_psi * z32 - (w1 * z33 + s_psi * z34))
        z35 = z17 * z30 + s1
        z36 = z29 + (z19 * z23 + c_theta * z35)
        z37 = c_phi * z19
        s2 = w1 * (c_psi * z25 - s_theta * z31) + z21 * z34
        z38 = s2 - (w2 * (s_psi * z25 + s_theta * z33) - z22 * z32)
        z39 = z23 * z30 - z18 * z38
        s3 = z20 * (c_phi * z25 - s_theta * z26) + s_theta * c_phi * z36
        z40 = s3 - (z24 * z37 - s_phi * z39)
        s4 = z20 * (s_phi * z25 + s_theta * z37) + s_theta * s_phi * z36
        z41 = s4 - (z24 * z26 + c_phi * z39)
        qddot: list[float] = [
            # x'' (I.2.15)
            -a * z40,
            # y'' (I.2.15)
            -a * z41,
            # phi'' (I.2.15)
            -z35,
            # theta'' (I.2.15)
            -z39,
            # psi'' (I.2.15)
            z36,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
    Returns y (8,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    phi_dot = float(qdot[2])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    try:
        # state
        s_theta = math.sin(theta)
        s_psi = math.sin(psi)
        c_psi = math.cos(psi)
        c_theta = math.cos(theta)
        y: list[float] = [
            x,
            y_2,
            phi,
            theta,
            psi,
            phi_dot * (s_theta * s_psi) + theta_dot * c_psi,
            phi_dot * (s_theta * c_psi) - theta_dot * s_psi,
            psi_dot + phi_dot * c_theta,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
    Returns r (2,).
    """
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    a = float(p[1])  # radius [m]
    try:
        # state
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        c_phi = math.cos(phi)
        s1 = a * (theta_dot * s_phi - psi_dot * (s_theta * c_phi))
        s2 = a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi))
        r: list[float] = [
            # roll_x = 0 (I.1.1) 27:5
            x_dot - s1,
            # roll_y = 0 (I.1.1) 28:5
            y_dot + s2,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        k5 = m * a
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "reactions")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "reactions")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = c_psi * (s_psi * z4)
        z6 = 1.0 / z2
        z7 = z5 * z6
        z8 = z3 - z5 * z7
        # the mass matrix is singular
        if not abs(z8) > 1e-14 * z3:
            raise SingularModelError(2, "reactions")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = s_theta * k1
        z11 = c_theta * (s_psi * z10)
        z12 = z11 * z6
        z13 = c_theta * (c_psi * z10) + z5 * z12
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z9 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z9:
            raise SingularModelError(2, "reactions")
        c_phi = math.cos(phi)
        z17 = s_theta * k5
        z18 = w2 * w3 * k2
        z19 = w1 * w3 * k3 - z18 * z7
        z20 = (w1 * w2 * k4 + z18 * z12 - z15 * z19) / z16
        s_phi = math.sin(phi)
        z21 = s_psi * c_theta
        z22 = z14 * z19 - z15 * z20
        z23 = z18 * z6 - z7 * z22 + z12 * z20
        z24 = c_psi * c_theta
        s1 = k5 * (c_psi * s_phi + c_phi * z21) * z23
        z25 = s1 + k5 * (s_psi * s_phi - c_phi * z24) * z22
        s2 = k5 * (c_psi * c_phi - s_phi * z21) * z23
        z26 = s2 + k5 * (s_psi * c_phi + s_phi * z24) * z22
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            z25 - c_phi * z17 * z20,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            -(s_phi * z17 * z20 + z26),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (8,), p (5,).
    Returns a scalar.
    """
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        # state
        s_theta = math.sin(theta)
        s_psi = math.sin(psi)
        z1 = w1 * w1
        z2 = 0.5 * z1
        z3 = w2 * w2
        z4 = 0.5 * z3
        c_psi = math.cos(psi)
        z5 = w3 * w3
        c_theta = math.cos(theta)
        s1 = s_psi * (s_psi * (z2 - z4) + w2 * (c_psi * w1))
        s2 = (c_psi * w2 + s_psi * w1) * (c_theta * w3)
        z6 = s_theta * (s1 - (0.5 * z5 - z4)) + s2
        s3 = 0.5 * (I3 * z5) + (0.5 * (I1 * z1) + 0.5 * (I2 * z3))
        z7 = k1 * (s_theta * z6 - (z2 + z4)) - s3
        value1 = -z7
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (8,), p (5,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "jacobian")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = s_theta * s_theta
        z3 = I1 + k1 * (1.0 - z1 * z2)
        # the mass matrix is singular
        if not abs(z3) > 0.0:
            raise SingularModelError(2, "jacobian")
        c_psi = math.cos(psi)
        z4 = c_psi * c_psi
        z5 = I2 + k1 * (1.0 - z4 * z2)
        z6 = k1 * z2
        z7 = s_psi * z6
        z8 = c_psi * z7
        z9 = 1.0 / z3
        z10 = z8 * z9
        z11 = z5 - z8 * z10
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z5:
            raise SingularModelError(2, "jacobian")
        z12 = I3 + z6
        c_theta = math.cos(theta)
        z13 = s_theta * k1
        z14 = s_psi * z13
        z15 = c_theta * z14
        z16 = z15 * z9
        z17 = c_psi * z13
        z18 = c_theta * z17 + z8 * z16
        z19 = 1.0 / z11
        z20 = z18 * z19
        z21 = z12 - z15 * z16 - z18 * z20
        # the mass matrix is singular
        if not abs(z21) > 1e-14 * z12:
            raise SingularModelError(2, "jacobian")
        c_phi = math.cos(phi)
        z22 = 1.0 / s_theta
        z23 = s_theta * c_psi
        z24 = s_theta * s_psi
        z25 = z23 * w1 - z24 * w2
        z26 = a * (z22 * z25)
        s_phi = math.sin(phi)
        z27 = c_psi * w2 + s_psi * w1
        z28 = z27 * z22
        z29 = a * (w3 - c_theta * z28)
        z30 = s_theta * z29
        z31 = a * (s_theta * c_phi)
        z32 = 1.0 / (s_theta * s_theta)
        z33 = a * s_phi
        z34 = c_theta * z31
        z35 = z33 * z22
        z36 = w1 * z35
        z37 = w2 * z35
        s1 = z32 * (z33 * z25 + z27 * z34) + c_phi * z29 - c_psi * z36
        z38 = c_theta * (s1 + s_psi * z37)
        z39 = z22 * z34
        z40 = a * (s_theta * s_phi)
        z41 = a * c_phi
        z42 = c_theta * z40
        z43 = z41 * z22
        z44 = w1 * z43
        z45 = w2 * z43
        s2 = z32 * (z41 * z25 - z27 * z42) - s_phi * z29 - c_psi * z44
        z46 = c_theta * (s2 + s_psi * z45)
        z47 = z22 * z42
        z48 = s_psi * (w2 * z22)
        z49 = c_psi * (w1 * z22)
        z50 = c_theta * z22
        z51 = 1.0 / z21
        z52 = w2 * w3 * k2
        z53 = w1 * w3 * k3 - z52 * z10
        z54 = z51 * (w1 * w2 * k4 + z52 * z16 - z20 * z53)
        z55 = c_theta * z54
        z56 = z19 * z53 - z20 * z54
        z57 = c_psi * z56
        z58 = z52 * z9 - z10 * z56 + z16 * z54
        z59 = k1 * z58
        s3 = 2.0 * (s_theta * (k1 * (s_psi * z57) - z1 * z59))
        z60 = s_theta * (z14 * z54) - c_theta * (k1 * (s_psi * z55) - s3)
        z61 = k1 * z56
        z62 = c_psi * z58
        s4 = 2.0 * (s_theta * (z4 * z61 - k1 * (s_psi * z62)))
        z63 = s_theta * (z17 * z54) - c_theta * (k1 * (c_psi * z55) - s4)
        z64 = z63 + z10 * z60
        z65 = c_theta * z56
        z66 = c_theta * z58
        s5 = k1 * (c_psi * z65 - s_psi * z66)
        s6 = c_theta * (s5 + 2.0 * (s_theta * (k1 * z54)))
        z67 = s_theta * (z17 * z56 - z14 * z58) - s6
        z68 = z51 * (z67 - z16 * z60 - z20 * z64)
        z69 = z19 * z64 - z20 * z68
        z70 = z13 * z55
        s7 = c_psi * (z70 - z6 * z57 + 2.0 * (s_psi * (z2 * z59)))
        z71 = s_psi * (z7 * z56) + s7
        s8 = s_psi * (z70 + z7 * z58 - 2.0 * (c_psi * (z2 * z61)))
        z72 = s8 - c_psi * (z6 * z62) - z10 * z71
        s9 = s_psi * (z13 * z65) + c_psi * (z13 * z66) + z16 * z71
        z73 = z51 * (s9 - z20 * z72)
        z74 = z19 * z72 - z20 * z73
        z75 = w3 * k3
        z76 = z51 * (w2 * k4 - z20 * z75)
        z77 = z19 * z75 - z20 * z76
        z78 = w3 * k2
        z79 = z10 * z78
        z80 = z51 * (w1 * k4 + z16 * z78 + z20 * z79)
        z81 = z19 * z79 + z20 * z80
        z82 = w2 * k2
        z83 = w1 * k3 - z10 * z82
        z84 = z51 * (z16 * z82 - z20 * z83)
        z85 = z19 * z83 - z20 * z84
        s10 = c_psi * (w1 * z39 - s_theta * z37)
        s11 = c_psi * (w1 * z47 + s_theta * z45)
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_phi * z26 + s_phi * z30,
            # (I.2.15)
            -(s_theta * (z31 * z28) + z38),
            # (I.2.15)
            s10 - s_psi * (w2 * z39 + s_theta * z36),
            # (I.2.15)
            z23 * z35 + s_psi * z39,
            # (I.2.15)
            c_psi * z39 - z24 * z35,
            # (I.2.15)
            -z31,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_phi * z26 - c_phi * z30,
            # (I.2.15)
            z46 - s_theta * (z40 * z28),
            # (I.2.15)
            s11 - s_psi * (w2 * z47 - s_theta * z44),
            # (I.2.15)
            s_psi * z47 - z23 * z43,
            # (I.2.15)
            z24 * z43 + c_psi * z47,
            # (I.2.15)
            -z40,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -c_theta * (z27 * z32),
            # (I.2.15)
            z49 - z48,
            # (I.2.15)
            s_psi * z22,
            # (I.2.15)
            c_psi * z22,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -c_theta * (z48 - (z49 - z25 * z32)),
            # (I.2.15)
            -z27,
            # (I.2.15)
            c_psi,
            # (I.2.15)
            -s_psi,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z27 + c_theta * (z32 * (c_theta * z27)),
            # (I.2.15)
            s_psi * (w2 * z50) - c_psi * (w1 * z50),
            # (I.2.15)
            -s_psi * z50,
            # (I.2.15)
            -c_psi * z50,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z16 * z68 - (z9 * z60 + z10 * z69),
            # (I.2.15)
            z9 * z71 - z10 * z74 + z16 * z73,
            # (I.2.15)
            z16 * z76 - z10 * z77,
            # (I.2.15)
            z9 * z78 + z10 * z81 + z16 * z80,
            # (I.2.15)
            z9 * z82 - z10 * z85 + z16 * z84,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z69,
            # (I.2.15)
            -z74,
            # (I.2.15)
            -z77,
            # (I.2.15)
            z81,
            # (I.2.15)
            -z85,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z68,
            # (I.2.15)
            z73,
            # (I.2.15)
            z76,
            # (I.2.15)
            z80,
            # (I.2.15)
            z84,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 8] for k5 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (8,), p (5,).
    Returns out (3,).
    """
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])
    w2 = float(y[6])
    w3 = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * (a * a)
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "outputs")
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z1 = c_psi * w2 + s_psi * w1
        z2 = c_theta * w3 + s_theta * z1
        out: list[float] = [
            # K1 35:7
            k1 * (w1 - s_theta * s_psi * z2) + I1 * w1,
            # K2 36:7
            k1 * (w2 - s_theta * c_psi * z2) + I2 * w2,
            # K3 37:7
            I3 * w3 - s_theta * k1 * (c_theta * z1 - s_theta * w3),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
