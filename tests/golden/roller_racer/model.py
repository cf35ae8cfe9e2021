"""roller_racer, emitted by nhc 0.1.0 (nhc:88e368dc973133e8).

Two wheeled bodies with a hinge; it is driven by moving the hinge to and fro.
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v, theta': the dependent velocities that nhc
    would choose (x', y') are singular somewhere

State y:
y[0] = x [m]: axle of the main body
y[1] = y [m]: axle of the main body
y[2] = theta [rad]: heading of the main body
y[3] = phi [rad]: second body, relative to the first
y[4] = v [m/s]: x'*cos(theta) + y'*sin(theta)
y[5] = theta' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of the main body
p[1]: I1 = 0.2 [kg*m^2]
p[2]: I2 = 0.05 [kg*m^2]
p[3]: d1 = 0.6 [m]: from the hinge to the first axle
p[4]: d2 = 0.25 [m]: from the hinge to the second axle

Constraints, with the units of their reactions:
0: rear [N]
1: front [N]

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 8 +-, 28 *, 3 /, 4 calls
velocities: 2 +-, 6 *, 1 /, 4 calls
accelerations: 13 +-, 34 *, 3 /, 4 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 7 +-, 11 *, 0 /, 4 calls
reactions: 12 +-, 34 *, 3 /, 2 calls
energy: 5 +-, 11 *, 1 /, 2 calls
jacobian: 36 +-, 92 *, 3 /, 4 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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


def _refuse(
    value: float,
    bound: float,
    status: int,
    function: str,
) -> SingularModelError:
    """What to raise of a block that does not exceed its bound: it is singular, or no number."""
    singular = value <= bound < math.inf
    return SingularModelError(status if singular else NOT_FINITE, function)


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (6,), p (5,).
    Returns dydt (6,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "rhs")
        # from the parameters alone
        k1 = 1.0 / d2
        k2 = I2 * k1
        k3 = k1 * k2
        # from the state
        s_phi = math.sin(phi)
        z1 = m + k3 * (s_phi * s_phi)
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "rhs")
        c_phi = math.cos(phi)
        z2 = d1 * c_phi
        z3 = z2 * k1
        z4 = I1 + I2 * (z3 * z3)
        z5 = k2 * z3
        z6 = s_phi * z5
        z7 = 1.0 / z1
        z8 = z7 * z6
        z9 = z4 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z4:
            raise _refuse(abs(z9), 1e-13 * z4, 2, "rhs")
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z10 = k1 * (theta_dot * (d2 + z2) - v * s_phi)
        z11 = d1 * (z10 * (theta_dot * s_phi)) + z10 * (c_phi * v)
        z12 = k3 * (s_phi * z11)
        z13 = (z11 * z5 - z12 * z8) / z9
        dydt: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            theta_dot,
            # phi' (I.2.4)
            -z10,
            # v' (I.2.15) 17:4
            z7 * z12 - z8 * z13,
            # theta'' (I.2.15) 17:4
            -z13,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state (I.2.4).

    Arguments: t (scalar), y (6,), p (5,).
    Returns qdot (4,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "velocities")
        # from the parameters alone
        k1 = -1.0 / d2
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        qdot: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            theta_dot,
            # phi' (I.2.4)
            k1 * (theta_dot * (d2 + d1 * c_phi) - v * s_phi),
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (6,), p (5,).
    Returns qddot (4,).
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "accelerations")
        # from the parameters alone
        k1 = 1.0 / d2
        k2 = I2 * k1
        k3 = k1 * k2
        # from the state
        s_phi = math.sin(phi)
        z1 = m + k3 * (s_phi * s_phi)
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "accelerations")
        c_phi = math.cos(phi)
        z2 = d2 + d1 * c_phi
        z3 = 1.0 - z2 * k1
        z4 = I1 + I2 * (z3 * z3)
        z5 = z3 * k2
        z6 = s_phi * z5
        z7 = 1.0 / z1
        z8 = z7 * z6
        z9 = z4 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z4:
            raise _refuse(abs(z9), 1e-13 * z4, 2, "accelerations")
        s_theta = math.sin(theta)
        z10 = theta_dot * v
        c_theta = math.cos(theta)
        z11 = k1 * (theta_dot * z2 - v * s_phi)
        z12 = d1 * (z11 * (theta_dot * s_phi)) + z11 * (c_phi * v)
        z13 = k3 * (s_phi * z12)
        z14 = (z12 * z5 - z13 * z8) / z9
        z15 = z7 * z13 - z8 * z14
        qddot: list[float] = [
            # x'' (I.2.15)
            c_theta * z15 - s_theta * z10,
            # y'' (I.2.15)
            c_theta * z10 + s_theta * z15,
            # theta'' (I.2.15)
            z14,
            # phi'' (I.2.15)
            -k1 * (z12 + (z2 * z14 - s_phi * z15)),
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
    """The state y from coordinates and velocities (I.2.1).

    Arguments: t (scalar), q (4,), qdot (4,), p (5,).
    Returns y (6,).
    """
    x = float(q[0])  # axle of the main body [m]
    y_2 = float(q[1])  # y: axle of the main body [m]
    theta = float(q[2])  # heading of the main body [rad]
    phi = float(q[3])  # second body, relative to the first [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (4,), qdot (4,), p (5,).
    Returns r (2,).
    """
    theta = float(q[2])  # heading of the main body [rad]
    phi = float(q[3])  # second body, relative to the first [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    phi_dot = float(qdot[3])  # phi' [rad/s]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # from the coordinates and velocities
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        s1 = x_dot * (s_theta * c_phi + c_theta * s_phi)
        s2 = s1 - y_dot * (c_theta * c_phi - s_theta * s_phi)
        z1 = theta_dot * (d2 + d1 * c_phi) - s2
        r: list[float] = [
            # rear = 0 (I.1.1) 19:5
            y_dot * c_theta - x_dot * s_theta,
            # front = 0 (I.1.1) 20:5
            phi_dot * d2 + z1,
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (6,), p (5,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "reactions")
        # from the parameters alone
        k1 = 1.0 / d2
        k2 = I2 * k1
        k3 = k1 * k2
        # from the state
        s_phi = math.sin(phi)
        z1 = m + k3 * (s_phi * s_phi)
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "reactions")
        c_phi = math.cos(phi)
        z2 = d2 + d1 * c_phi
        z3 = 1.0 - z2 * k1
        z4 = I1 + I2 * (z3 * z3)
        z5 = z3 * k2
        z6 = s_phi * z5
        z7 = 1.0 / z1
        z8 = z7 * z6
        z9 = z4 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z4:
            raise _refuse(abs(z9), 1e-13 * z4, 2, "reactions")
        z10 = k1 * (theta_dot * z2 - v * s_phi)
        z11 = d1 * (z10 * (theta_dot * s_phi)) + z10 * (c_phi * v)
        z12 = k3 * (s_phi * z11)
        z13 = (z11 * z5 - z12 * z8) / z9
        s1 = k1 * z11 - (k1 * (s_phi * (z7 * z12 - z8 * z13)) + z3 * z13)
        z14 = k2 * s1
        lambda_: list[float] = [
            # reaction of rear: Q_i gains lambda_1 a_1i (I.4.1) 19:5
            m * (theta_dot * v) + c_phi * z14,
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 20:5
            -z14,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (6,), p (5,).
    Returns a scalar.
    """
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # from the parameters alone
        k1 = 1.0 / d2
        # from the state
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z1 = theta_dot - k1 * (theta_dot * (d2 + d1 * c_phi) - v * s_phi)
        s1 = I2 * (z1 * z1) + (I1 * (theta_dot * theta_dot) + m * (v * v))
        value1 = 0.5 * s1
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (6,), p (5,).
    Returns rows (6, 6): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[2])  # heading of the main body [rad]
    phi = float(y[3])  # second body, relative to the first [rad]
    v = float(y[4])  # [m/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass of the main body [kg]
    I1 = float(p[1])  # [kg*m^2]
    I2 = float(p[2])  # [kg*m^2]
    d1 = float(p[3])  # from the hinge to the first axle [m]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "jacobian")
        # from the parameters alone
        k1 = 1.0 / d2
        k2 = I2 * k1
        k3 = k1 * k2
        # from the state
        s_phi = math.sin(phi)
        z1 = m + k3 * (s_phi * s_phi)
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "jacobian")
        c_phi = math.cos(phi)
        z2 = d2 + d1 * c_phi
        z3 = z2 * k1
        z4 = 1.0 - z3
        z5 = I1 + I2 * (z4 * z4)
        z6 = z4 * k2
        z7 = s_phi * z6
        z8 = 1.0 / z1
        z9 = z8 * z7
        z10 = z5 - z7 * z9
        # the mass matrix is singular, if z10 is nearly 0
        if not abs(z10) > 1e-13 * z5:
            raise _refuse(abs(z10), 1e-13 * z5, 2, "jacobian")
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        z11 = theta_dot * d1
        z12 = s_phi * k1
        z13 = s_phi * k3
        z14 = v * z13
        z15 = z11 * z13
        z16 = k1 * (c_phi * z14 + s_phi * z15)
        z17 = k1 * (theta_dot * z2 - v * s_phi)
        z18 = d1 * (s_phi * z17)
        z19 = c_phi * z17
        z20 = theta_dot * z18 + v * z19
        z21 = 1.0 / z10
        z22 = z20 * z13
        z23 = z21 * (z20 * z6 - z9 * z22)
        z24 = k2 * z23
        z25 = z8 * z22 - z9 * z23
        s1 = z17 * z15 + (z20 * k3 - z4 * z24 - 2.0 * (z13 * z25))
        z26 = c_phi * (v * z16 - s1)
        s2 = s_phi * (z17 * z14 + d1 * (theta_dot * z16 + z12 * z24))
        z27 = z26 + s2
        z28 = v * z6
        z29 = z11 * z6
        z30 = k1 * (c_phi * z28 + s_phi * z29)
        z31 = k2 * z25
        s3 = k1 * (z20 * k2 - 2.0 * (I2 * (z4 * z23)) - s_phi * z31)
        z32 = d1 * (theta_dot * z30 - s3)
        s4 = c_phi * (v * z30 - (z17 * z29 - z4 * z31))
        z33 = s4 + s_phi * (z17 * z28 + z32) - z9 * z27
        z34 = z21 * z33
        z35 = z19 * z13 - s_phi * z16
        z36 = z21 * (z19 * z6 - s_phi * z30 - z9 * z35)
        z37 = z18 * z13 + z2 * z16
        z38 = z21 * (z18 * z6 + z2 * z30 - z9 * z37)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_theta * v,
            0.0,
            # (I.2.15)
            c_theta,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta * v,
            0.0,
            # (I.2.15)
            s_theta,
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
            # (I.2.15)
            k1 * (c_phi * v + s_phi * z11),
            # (I.2.15)
            z12,
            # (I.2.15)
            -z3,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z9 * z34 - z8 * z27,
            # (I.2.15)
            z8 * z35 - z9 * z36,
            # (I.2.15)
            z8 * z37 - z9 * z38,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z34,
            # (I.2.15)
            z36,
            # (I.2.15)
            z38,
        ]
        _finish("jacobian", J)
        return [J[k4 : k4 + 6] for k4 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (6,), p (5,).
    Returns out (1,).
    """
    v = float(y[4])  # [m/s]
    d2 = float(p[4])  # from the hinge to the second axle [m]
    try:
        # the coframe is singular, if d2 is 0
        if not abs(d2) > 0.0:
            raise _refuse(abs(d2), 0.0, 1, "outputs")
        # from the state
        out: list[float] = [
            # speed 22:10
            v,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
