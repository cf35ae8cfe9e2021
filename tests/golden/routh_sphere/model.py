"""routh_sphere, emitted by nhc 0.1.0 (nhc:ee9c815b043f13ed).

A ball with its centre of mass off its centre, dynamically symmetric, rolls on a
    horizontal plane.
Source: routh_sphere.yaml
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec

State y:
y[0] = x [m]: geometric centre
y[1] = y [m]: geometric centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = phi'
y[6] = theta'
y[7] = psi'

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 1.0 [m]: radius
p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
p[4]: I3 = 0.42 [kg*m^2]: about the axis
p[5]: g = 9.81 [m/s^2]: acceleration of gravity

Constraints:
0: roll_x
1: roll_y

Outputs:
out[0] = jellett
out[1] = routh

Operations:
rhs: 26 +-, 53 *, 3 /, 4 calls
velocities: 2 +-, 8 *, 0 /, 3 calls
accelerations: 32 +-, 64 *, 3 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 4 +-, 8 *, 0 /, 3 calls
reactions: 37 +-, 85 *, 3 /, 4 calls
energy: 12 +-, 31 *, 0 /, 2 calls
jacobian: 48 +-, 134 *, 3 /, 4 calls
outputs: 5 +-, 17 *, 0 /, 3 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "phi", "theta", "psi")
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "psi", "phi'", "theta'", "psi'")
PARAMETERS: tuple[str, ...] = ("m", "R", "e", "I1", "I3", "g")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("jellett", "routh")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, -0.2, 0.38, 0.42, 9.81)

REASONS = (
    "",
    "",
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
    """right-hand side dy/dt = f(t, y; p) (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns dydt (8,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = R * R
        k2 = m * k1
        k3 = e * e
        k4 = m * k3
        k5 = I3 - (I1 + k4)
        k6 = m * R
        k7 = e * k6
        k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4)
        k9 = m * e
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "rhs")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k3 + R * z3)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "rhs")
        z5 = I3 + z1 * k2
        z6 = I3 * c_theta - z1 * k7
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "rhs")
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z10 = theta_dot * s_theta
        s1 = phi_dot * (k7 - c_theta * k8)
        z11 = z10 * (s1 - psi_dot * (I3 + c_theta * k7))
        s2 = phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))
        z12 = (z10 * s2 + z11 * z8) / z9
        s3 = phi_dot * (k7 - c_theta * k5)
        s4 = phi_dot * (s3 - psi_dot * (I3 + (R + Z) * k6))
        z13 = s4 + k9 * (g + R * (theta_dot * theta_dot))
        dydt: list[float] = [
            # x' (III.3)
            R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)),
            # y' (III.3)
            -R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)),
            # phi' (III.3)
            phi_dot,
            # theta' (III.3)
            theta_dot,
            # psi' (III.3)
            psi_dot,
            # phi'' (III.3) 26:4
            -(z11 * z7 + z8 * z12),
            # theta'' (III.3) 26:4
            s_theta * z13 / z4,
            # psi'' (III.3) 26:4
            z12,
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

    Arguments: t (scalar), y (8,), p (6,).
    Returns qdot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    R = float(p[1])  # radius [m]
    try:
        # state
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        c_phi = math.cos(phi)
        qdot: list[float] = [
            # x' (I.2.4)
            R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi)),
            # y' (I.2.4)
            -R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi)),
            # phi' (I.2.4)
            phi_dot,
            # theta' (I.2.4)
            theta_dot,
            # psi' (I.2.4)
            psi_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = R * R
        k2 = m * k1
        k3 = e * e
        k4 = m * k3
        k5 = I3 - (I1 + k4)
        k6 = m * R
        k7 = e * k6
        k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4)
        k9 = m * e
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "accelerations")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k3 + R * z3)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "accelerations")
        z5 = I3 + z1 * k2
        z6 = I3 * c_theta - z1 * k7
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "accelerations")
        c_phi = math.cos(phi)
        z10 = phi_dot * c_phi
        s_phi = math.sin(phi)
        s1 = phi_dot * (k7 - c_theta * k5)
        s2 = phi_dot * (s1 - psi_dot * (I3 + (R + Z) * k6))
        z11 = s2 + k9 * (g + R * (theta_dot * theta_dot))
        z12 = s_theta * z11 / z4
        z13 = theta_dot * c_theta
        z14 = phi_dot * s_phi
        z15 = theta_dot * s_theta
        s3 = phi_dot * (k7 - c_theta * k8)
        z16 = z15 * (s3 - psi_dot * (I3 + c_theta * k7))
        s4 = phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))
        z17 = (z15 * s4 + z16 * z8) / z9
        s5 = psi_dot * (c_phi * z13 - s_theta * z14)
        z18 = theta_dot * z10 + s_phi * z12 - (s5 + s_theta * c_phi * z17)
        s6 = psi_dot * (s_phi * z13 + s_theta * z10)
        z19 = theta_dot * z14 - c_phi * z12 - (s6 + s_theta * s_phi * z17)
        qddot: list[float] = [
            # x'' (III.3)
            R * z18,
            # y'' (III.3)
            R * z19,
            # phi'' (III.3)
            -(z16 * z7 + z8 * z17),
            # theta'' (III.3)
            z12,
            # psi'' (III.3)
            z17,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns y (8,).
    """
    x = float(q[0])  # geometric centre [m]
    y_2 = float(q[1])  # geometric centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    phi_dot = float(qdot[2])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    try:
        # state
        y: list[float] = [x, y_2, phi, theta, psi, phi_dot, theta_dot, psi_dot]
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

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns r (2,).
    """
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    R = float(p[1])  # radius [m]
    try:
        # state
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        c_phi = math.cos(phi)
        s1 = R * (theta_dot * s_phi - psi_dot * (s_theta * c_phi))
        s2 = R * (theta_dot * c_phi + psi_dot * (s_theta * s_phi))
        r: list[float] = [
            # roll_x = 0 (I.1.1) 29:5
            x_dot - s1,
            # roll_y = 0 (I.1.1) 30:5
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

    Arguments: t (scalar), y (8,), p (6,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = R * R
        k2 = m * k1
        k3 = e * e
        k4 = m * k3
        k5 = I3 - (I1 + k4)
        k6 = m * R
        k7 = e * k6
        k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4)
        k9 = m * e
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "reactions")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k3 + R * z3)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "reactions")
        z5 = I3 + z1 * k2
        z6 = I3 * c_theta - z1 * k7
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "reactions")
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z10 = psi_dot * R
        z11 = phi_dot * e - z10
        z12 = s_theta * (theta_dot * e)
        s1 = phi_dot * (theta_dot * c_phi * z3 - s_theta * s_phi * z11)
        z13 = s1 - theta_dot * (s_phi * z12 + c_theta * (c_phi * z10))
        z14 = s_theta * k6
        z15 = theta_dot * s_theta
        s2 = phi_dot * (k7 - c_theta * k8)
        z16 = z15 * (s2 - psi_dot * (I3 + c_theta * k7))
        s3 = phi_dot * (I3 + k6 * z3) - c_theta * (k1 * (psi_dot * m))
        z17 = (z15 * s3 + z16 * z8) / z9
        z18 = s_theta * k9
        z19 = z16 * z7 + z8 * z17
        z20 = R + Z
        s4 = phi_dot * (k7 - c_theta * k5) - psi_dot * (I3 + z20 * k6)
        z21 = phi_dot * s4 + k9 * (g + R * (theta_dot * theta_dot))
        z22 = s_theta * z21 / z4
        s5 = c_phi * z18 * z19 - z20 * (m * s_phi) * z22
        z23 = m * z13 - (c_phi * z14 * z17 + s5)
        s6 = phi_dot * (theta_dot * s_phi * z3 + s_theta * c_phi * z11)
        z24 = s6 + theta_dot * (c_phi * z12 - c_theta * (s_phi * z10))
        s7 = s_phi * z18 * z19 + z20 * (m * c_phi) * z22
        z25 = m * z24 - (s_phi * z14 * z17 + s7)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 29:5
            z23,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 30:5
            z25,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (8,), p (6,).
    Returns a scalar.
    """
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = R * R
        k2 = 0.5 * e
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = theta_dot * theta_dot
        c_theta = math.cos(theta)
        s1 = phi_dot * z1 * (0.5 * (phi_dot * e) - psi_dot * R)
        z3 = s1 + (z2 * (k2 + R * c_theta) + g * c_theta)
        z4 = psi_dot * psi_dot
        s2 = phi_dot * (0.5 * (I1 * z1) + I3 * (0.5 - 0.5 * z1))
        z5 = phi_dot * (c_theta * (psi_dot * I3) + s2)
        s3 = m * (e * z3 + k1 * (0.5 * z2 + 0.5 * (z1 * z4)))
        z6 = s3 + (z5 + (0.5 * (I1 * z2) + 0.5 * (I3 * z4)))
        value1 = z6
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = R * R
        k2 = m * k1
        k3 = e * e
        k4 = m * k3
        k5 = I3 - (I1 + k4)
        k6 = m * R
        k7 = e * k6
        k8 = 2.0 * I3 - (2.0 * I1 + 2.0 * k4)
        k9 = m * e
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular
        if not abs(z2) > 0.0:
            raise SingularModelError(2, "jacobian")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k3 + R * z3)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "jacobian")
        z5 = I3 + z1 * k2
        z6 = I3 * c_theta - z1 * k7
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "jacobian")
        s_phi = math.sin(phi)
        z10 = psi_dot * R
        z11 = s_theta * z10
        c_phi = math.cos(phi)
        z12 = theta_dot * R
        z13 = theta_dot * s_theta
        z14 = phi_dot * z13
        z15 = 1.0 / z9
        z16 = I3 + k6 * z3
        z17 = k1 * (psi_dot * m)
        z18 = phi_dot * z16 - c_theta * z17
        z19 = k7 - c_theta * k8
        z20 = I3 + c_theta * k7
        z21 = phi_dot * z19 - psi_dot * z20
        z22 = z13 * z21
        z23 = z15 * (z13 * z18 + z22 * z8)
        z24 = z22 * z7 + z8 * z23
        s1 = theta_dot * z21 - 2.0 * (s_theta * (k7 * z23 - k5 * z24))
        s2 = s_theta * (k7 * (psi_dot * z13) + z14 * k8 - I3 * z23)
        z25 = s2 + c_theta * s1
        s3 = theta_dot * z18 - 2.0 * (s_theta * (k2 * z23 + k7 * z24))
        s4 = s_theta * (2.0 * (e * (z14 * k6)) - (z13 * z17 - I3 * z24))
        z26 = s4 - c_theta * s3
        z27 = z15 * (z26 - z8 * z25)
        z28 = z13 * z19
        z29 = z15 * (z13 * z16 + z8 * z28)
        z30 = s_theta * z21
        z31 = z15 * (s_theta * z18 + z8 * z30)
        z32 = z13 * z20
        z33 = z15 * (m * (k1 * (c_theta * z13)) + z8 * z32)
        z34 = 1.0 / z4
        z35 = k7 - c_theta * k5
        z36 = I3 + (R + Z) * k6
        z37 = phi_dot * z35 - psi_dot * z36
        z38 = phi_dot * z37 + k9 * (g + R * (theta_dot * theta_dot))
        z39 = phi_dot * s_theta
        s5 = 2.0 * (R * (m * (s_theta * z38 * z34)))
        z40 = k5 * (phi_dot * z39) + e * (k6 * (psi_dot * z39) + s5)
        J: list[float] = [
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            s_phi * z11 + c_phi * z12,
            # (III.3)
            -c_theta * (c_phi * z10),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            R * s_phi,
            # (III.3)
            -R * (s_theta * c_phi),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            s_phi * z12 - c_phi * z11,
            # (III.3)
            -c_theta * (s_phi * z10),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -R * c_phi,
            # (III.3)
            -R * (s_theta * s_phi),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            z8 * z27 - z7 * z25,
            # (III.3)
            0.0,
            # (III.3)
            -(z7 * z28 + z8 * z29),
            # (III.3)
            -(z7 * z30 + z8 * z31),
            # (III.3)
            z7 * z32 + z8 * z33,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            z34 * (c_theta * z38 + s_theta * z40),
            # (III.3)
            0.0,
            # (III.3)
            z34 * (s_theta * z37 + z39 * z35),
            # (III.3)
            2.0 * (z34 * (theta_dot * (R * (s_theta * k9)))),
            # (III.3)
            -z34 * (z39 * z36),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -z27,
            # (III.3)
            0.0,
            # (III.3)
            z29,
            # (III.3)
            z31,
            # (III.3)
            -z33,
        ]
        _finish("jacobian", J)
        return [J[k10 : k10 + 8] for k10 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (8,), p (6,).
    Returns out (2,).
    """
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # parameters only
        k1 = I1 * I3
        k2 = I1 * (m * (R * R))
        k3 = m * I3
        # state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        c_theta = math.cos(theta)
        omega3 = psi_dot + phi_dot * c_theta
        z2 = e + R * c_theta
        out: list[float] = [
            # jellett 33:12
            R * (phi_dot * (I1 * z1)) + I3 * omega3 * z2,
            # routh 34:10
            omega3 * math.sqrt(k1 + z1 * k2 + k3 * (z2 * z2)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
