"""roller_racer, emitted by nhc 0.1.0 (nhc:1743c386034232db).

Two wheeled bodies with a hinge; it is driven by moving the hinge to and fro.
Source: roller_racer.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v, theta': the dependent velocities that nhc
    would choose (x', y') are singular somewhere

State y:
y[0] = x [m]: axle of the main body
y[1] = y [m]: axle of the main body
y[2] = theta [rad]: heading of the main body
y[3] = phi [rad]: second body, relative to the first
y[4] = v
y[5] = theta'

Parameters p:
p[0]: m = 1.0 [kg]: mass of the main body
p[1]: I1 = 0.2 [kg*m^2]
p[2]: I2 = 0.05 [kg*m^2]
p[3]: d1 = 0.6 [m]: from the hinge to the first axle
p[4]: d2 = 0.25 [m]: from the hinge to the second axle

Constraints:
0: rear
1: front

Outputs:
out[0] = speed

Operations:
rhs: 19 +-, 46 *, 3 /, 6 calls
velocities: 4 +-, 7 *, 1 /, 5 calls
accelerations: 26 +-, 52 *, 3 /, 6 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 6 +-, 7 *, 0 /, 5 calls
reactions: 28 +-, 63 *, 3 /, 6 calls
energy: 8 +-, 17 *, 1 /, 5 calls
jacobian: 99 +-, 193 *, 3 /, 6 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "theta", "phi")
STATE: tuple[str, ...] = ("x", "y", "theta", "phi", "v", "theta'")
PARAMETERS: tuple[str, ...] = ("m", "I1", "I2", "d1", "d2")
CONSTRAINTS: tuple[str, ...] = ("rear", "front")
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.2, 0.05, 0.6, 0.25)

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

    Arguments: t (scalar), y (6,), p (5,).
    Returns dydt (6,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "rhs")
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z1 = theta + phi
        c1 = math.cos(z1)
        s1 = math.sin(z1)
        z2 = (s_theta * c1 - c_theta * s1) * k1
        s2 = c_theta * (m * c_theta) + s_theta * (m * s_theta)
        z3 = s2 + z2 * (I2 * z2)
        # the mass matrix is singular
        if not abs(z3) > 0.0:
            raise SingularModelError(2, "rhs")
        c_phi = math.cos(phi)
        z4 = d2 + d1 * c_phi
        z5 = 1.0 - z4 * k1
        z6 = I2 * z5
        z7 = I1 + z5 * z6
        z8 = z2 * z6
        z9 = 1.0 / z3
        z10 = z8 * z9
        z11 = z7 - z8 * z10
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z7:
            raise SingularModelError(2, "rhs")
        z12 = c_theta * v
        z13 = s_theta * v
        z14 = k1 * (theta_dot * z4 + (c1 * z13 - s1 * z12))
        s_phi = math.sin(phi)
        z15 = theta_dot - z14
        z16 = v * (theta_dot * c_theta)
        z17 = v * (theta_dot * s_theta)
        s3 = z13 * (s1 * z15) - c1 * z16 + (z12 * (c1 * z15) - s1 * z17)
        z18 = theta_dot * (d1 * (z14 * s_phi)) - s3
        z19 = I2 * (k1 * z18)
        z20 = z2 * z19 - (c_theta * (m * z17) - s_theta * (m * z16))
        z21 = (z5 * z19 - z20 * z10) / z11
        dydt: list[float] = [
            # x' (I.2.15)
            z12,
            # y' (I.2.15)
            z13,
            # theta' (I.2.15)
            theta_dot,
            # phi' (I.2.15)
            -z14,
            # v' (I.2.15) 17:4
            z10 * z21 - z20 * z9,
            # theta'' (I.2.15) 17:4
            z21,
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

    Arguments: t (scalar), y (6,), p (5,).
    Returns qdot (4,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "velocities")
        c_theta = math.cos(theta)
        z1 = c_theta * v
        s_theta = math.sin(theta)
        z2 = s_theta * v
        c_phi = math.cos(phi)
        z3 = theta + phi
        c1 = math.cos(z3)
        s1 = math.sin(z3)
        qdot: list[float] = [
            # x' (I.2.4)
            z1,
            # y' (I.2.4)
            z2,
            # theta' (I.2.4)
            theta_dot,
            # phi' (I.2.4)
            -k1 * (theta_dot * (d2 + d1 * c_phi) + (c1 * z2 - s1 * z1)),
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

    Arguments: t (scalar), y (6,), p (5,).
    Returns qddot (4,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "accelerations")
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z1 = theta + phi
        c1 = math.cos(z1)
        s1 = math.sin(z1)
        z2 = (s_theta * c1 - c_theta * s1) * k1
        s2 = c_theta * (m * c_theta) + s_theta * (m * s_theta)
        z3 = s2 + z2 * (I2 * z2)
        # the mass matrix is singular
        if not abs(z3) > 0.0:
            raise SingularModelError(2, "accelerations")
        c_phi = math.cos(phi)
        z4 = d2 + d1 * c_phi
        z5 = 1.0 - z4 * k1
        z6 = I2 * z5
        z7 = I1 + z5 * z6
        z8 = z2 * z6
        z9 = 1.0 / z3
        z10 = z8 * z9
        z11 = z7 - z8 * z10
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z7:
            raise SingularModelError(2, "accelerations")
        z12 = v * (theta_dot * s_theta)
        z13 = s_theta * v
        z14 = c_theta * v
        z15 = k1 * (theta_dot * z4 + (c1 * z13 - s1 * z14))
        s_phi = math.sin(phi)
        z16 = theta_dot * (d1 * (z15 * s_phi))
        z17 = theta_dot - z15
        z18 = z13 * (s1 * z17)
        z19 = v * (theta_dot * c_theta)
        z20 = z14 * (c1 * z17)
        z21 = I2 * (k1 * (z16 - (z18 - c1 * z19 + (z20 - s1 * z12))))
        z22 = z2 * z21 - (c_theta * (m * z12) - s_theta * (m * z19))
        z23 = (z5 * z21 - z22 * z10) / z11
        z24 = z22 * z9 - z10 * z23
        z25 = z12 + c_theta * z24
        z26 = z19 - s_theta * z24
        qddot: list[float] = [
            # x'' (I.2.15)
            -z25,
            # y'' (I.2.15)
            z26,
            # theta'' (I.2.15)
            z23,
            # phi'' (I.2.15)
            -k1 * (z16 + z4 * z23 - (z18 - c1 * z26 + (z20 - s1 * z25))),
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

    Arguments: t (scalar), q (4,), qdot (4,), p (5,).
    Returns y (6,).
    """
    x = float(q[0])  # axle of the main body [m]
    y_2 = float(q[1])  # axle of the main body [m]
    theta = float(q[2])  # heading of the main body [rad]
    phi = float(q[3])  # second body, relative to the first [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    try:
        # state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        y: list[float] = [
            x,
            y_2,
            theta,
            phi,
            x_dot * c_theta + y_dot * s_theta,
            theta_dot,
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

    Arguments: t (scalar), q (4,), qdot (4,), p (5,).
    Returns r (2,).
    """
    theta = float(q[2])  # heading of the main body [rad]
    phi = float(q[3])  # second body, relative to the first [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    phi_dot = float(qdot[3])
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        z1 = theta + phi
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        c_phi = math.cos(phi)
        s2 = x_dot * s1 - y_dot * c1 - theta_dot * (d2 + d1 * c_phi)
        r: list[float] = [
            # rear = 0 (I.1.1) 19:5
            y_dot * c_theta - x_dot * s_theta,
            # front = 0 (I.1.1) 20:5
            phi_dot * d2 - s2,
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

    Arguments: t (scalar), y (6,), p (5,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "reactions")
        c_theta = math.cos(theta)
        z1 = m * c_theta
        s_theta = math.sin(theta)
        z2 = m * s_theta
        z3 = theta + phi
        c1 = math.cos(z3)
        s1 = math.sin(z3)
        z4 = (s_theta * c1 - c_theta * s1) * k1
        z5 = I2 * z4
        z6 = c_theta * z1 + s_theta * z2 + z4 * z5
        # the mass matrix is singular
        if not abs(z6) > 0.0:
            raise SingularModelError(2, "reactions")
        c_phi = math.cos(phi)
        z7 = d2 + d1 * c_phi
        z8 = 1.0 - z7 * k1
        z9 = I2 * z8
        z10 = I1 + z8 * z9
        z11 = z4 * z9
        z12 = 1.0 / z6
        z13 = z11 * z12
        z14 = z10 - z11 * z13
        # the mass matrix is singular
        if not abs(z14) > 1e-14 * z10:
            raise SingularModelError(2, "reactions")
        z15 = k1 * (c_theta * c1 + s_theta * s1)
        z16 = s_theta * v
        z17 = c_theta * v
        z18 = k1 * (theta_dot * z7 + (c1 * z16 - s1 * z17))
        s_phi = math.sin(phi)
        z19 = theta_dot - z18
        z20 = v * (theta_dot * c_theta)
        z21 = v * (theta_dot * s_theta)
        s2 = z16 * (s1 * z19) - c1 * z20 + (z17 * (c1 * z19) - s1 * z21)
        z22 = theta_dot * (d1 * (z18 * s_phi)) - s2
        z23 = I2 * (k1 * z22)
        z24 = m * z21
        z25 = m * z20
        z26 = z4 * z23 - (c_theta * z24 - s_theta * z25)
        z27 = (z8 * z23 - z26 * z13) / z14
        z28 = z26 * z12 - z13 * z27
        s3 = (s_theta * z1 - c_theta * z2 - z15 * z5) * z28
        s4 = z15 * z23 + (s_theta * z24 + c_theta * z25)
        z29 = s4 + (s3 - z15 * z9 * z27)
        lambda_: list[float] = [
            # reaction of rear: Q_i gains lambda_1 a_1i (I.4.1) 19:5
            z29,
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 20:5
            k1 * z5 * z28 + k1 * z9 * z27 - k1 * z23,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (6,), p (5,).
    Returns a scalar.
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        c_theta = math.cos(theta)
        z1 = c_theta * v
        s_theta = math.sin(theta)
        z2 = s_theta * v
        c_phi = math.cos(phi)
        z3 = theta + phi
        c1 = math.cos(z3)
        s1 = math.sin(z3)
        s2 = k1 * (theta_dot * (d2 + d1 * c_phi) + (c1 * z2 - s1 * z1))
        z4 = theta_dot - s2
        s3 = 0.5 * (I1 * (theta_dot * theta_dot))
        s4 = s3 + 0.5 * (m * (z1 * z1 + z2 * z2))
        z5 = s4 + 0.5 * (I2 * (z4 * z4))
        value1 = z5
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (6,), p (5,).
    Returns rows (6, 6): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])
    theta_dot = float(y[5])
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # parameters only
        k1 = 1.0 / d2
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "jacobian")
        c_theta = math.cos(theta)
        z1 = m * c_theta
        s_theta = math.sin(theta)
        z2 = m * s_theta
        z3 = theta + phi
        c1 = math.cos(z3)
        s1 = math.sin(z3)
        z4 = (s_theta * c1 - c_theta * s1) * k1
        z5 = I2 * z4
        z6 = c_theta * z1 + s_theta * z2 + z4 * z5
        # the mass matrix is singular
        if not abs(z6) > 0.0:
            raise SingularModelError(2, "jacobian")
        c_phi = math.cos(phi)
        z7 = d2 + d1 * c_phi
        z8 = z7 * k1
        z9 = 1.0 - z8
        z10 = I2 * z9
        z11 = I1 + z9 * z10
        z12 = z4 * z10
        z13 = 1.0 / z6
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "jacobian")
        z16 = s_theta * v
        z17 = c_theta * v
        z18 = s1 * (z16 * k1) + c1 * (z17 * k1)
        z19 = s1 * k1
        z20 = c1 * k1
        s_phi = math.sin(phi)
        z21 = theta_dot * c_theta
        z22 = v * z21
        z23 = k1 * z5
        z24 = k1 * (theta_dot * z7 + (c1 * z16 - s1 * z17))
        z25 = theta_dot - z24
        z26 = z17 * z23
        z27 = d1 * (theta_dot * z23)
        z28 = z16 * z23
        z29 = s1 * z28 + c1 * z26
        z30 = k1 * (s_phi * z27 + z29)
        z31 = d1 * (z24 * s_phi)
        z32 = s1 * z25
        z33 = c1 * z25
        z34 = theta_dot * s_theta
        z35 = v * z34
        s2 = z16 * z32 - c1 * z22 + (z17 * z33 - s1 * z35)
        z36 = I2 * (k1 * (theta_dot * z31 - s2))
        z37 = 1.0 / z15
        z38 = m * z35
        z39 = m * z22
        z40 = z4 * z36 - (c_theta * z38 - s_theta * z39)
        z41 = z37 * (z9 * z36 - z40 * z14)
        z42 = z36 - z10 * z41
        z43 = z40 * z13 - z14 * z41
        z44 = z4 * z43
        z45 = k1 * (z42 - z5 * z43 - I2 * z44)
        s3 = s1 * (z22 * z23 - z25 * z26 + z16 * z30 + s_theta * z45)
        s4 = c1 * (z35 * z23 - z25 * z28 - z17 * z30 - c_theta * z45)
        z46 = s3 - s4
        z47 = z33 * z23 + s1 * z30
        z48 = z2 + c1 * z23
        z49 = v * z48
        s5 = theta_dot * z49 - (z38 + z1 * z43 + m * (c_theta * z43))
        z50 = v * z47 - s5 + s1 * z45
        z51 = z32 * z23 - c1 * z30
        z52 = z1 - s1 * z23
        z53 = v * z52
        s6 = theta_dot * z53 - (z39 - z2 * z43 - m * (s_theta * z43))
        z54 = v * z51 + s6 - c1 * z45
        z55 = z46 - s_theta * z50 + c_theta * z54
        z56 = k1 * z10
        z57 = z17 * z56
        z58 = d1 * (theta_dot * z56)
        z59 = z16 * z56
        z60 = s1 * z59 + c1 * z57
        z61 = k1 * (s_phi * z58 + z60)
        z62 = k1 * (z10 * z43)
        s7 = s1 * (z22 * z56 - z25 * z57 + z16 * z61 - s_theta * z62)
        s8 = c1 * (z35 * z56 - z25 * z59 - z17 * z61 + c_theta * z62)
        z63 = s7 - s8
        z64 = c1 * z56
        z65 = v * z64
        z66 = z33 * z56 + s1 * z61
        z67 = s1 * z56
        z68 = v * z67
        z69 = z32 * z56 - c1 * z61
        s9 = z63 + s_theta * (theta_dot * z65 - v * z66 + s1 * z62)
        z70 = s9 - c_theta * (theta_dot * z68 - v * z69 - c1 * z62)
        z71 = z37 * (z70 - z14 * z55)
        s10 = s_phi * (d1 * (theta_dot * z30 + k1 * (I2 * (z4 * z41))))
        z72 = z46 - (c_phi * (z24 * z27) - s10)
        s11 = d1 * (theta_dot * z61 - k1 * (z42 - I2 * (z44 + z9 * z41)))
        z73 = c_phi * (z24 * z58) - s_phi * s11
        z74 = z37 * (z63 - z73 - z14 * z72)
        z75 = z21 * z48 - z34 * z52 - s_theta * z51 - c_theta * z47
        s12 = z21 * z64 + z34 * z67 - s_theta * z69 - c_theta * z66
        z76 = z37 * (s12 - z14 * z75)
        z77 = z29 - (z31 * z23 - s_theta * z53 + c_theta * z49) - z7 * z30
        s13 = z60 - (z31 * z56 + s_theta * z68 + c_theta * z65) - z7 * z61
        z78 = z37 * (s13 - z14 * z77)
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z16,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z17,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z18 - s_theta * (v * z19) - c_theta * (v * z20),
            # (I.2.15)
            s_phi * (d1 * (theta_dot * k1)) + z18,
            # (I.2.15)
            c_theta * z19 - s_theta * z20,
            # (I.2.15)
            -z8,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z13 * z55 - z14 * z71,
            # (I.2.15)
            z13 * z72 - z14 * z74,
            # (I.2.15)
            z14 * z76 - z13 * z75,
            # (I.2.15)
            z13 * z77 - z14 * z78,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z71,
            # (I.2.15)
            -z74,
            # (I.2.15)
            z76,
            # (I.2.15)
            -z78,
        ]
        _finish("jacobian", J)
        return [J[k2 : k2 + 6] for k2 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (6,), p (5,).
    Returns out (1,).
    """
    v = float(y[4])
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # state
        # the coframe is singular
        if not abs(d2) > 0.0:
            raise SingularModelError(1, "outputs")
        out: list[float] = [
            # speed 22:10
            v,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
