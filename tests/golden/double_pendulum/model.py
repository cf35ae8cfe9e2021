"""double_pendulum, emitted by nhc 0.1.0 (nhc:677b11b0215a5622).

Two pendulums in a row, absolute angles; the model gives positions and nhc
    differentiates them.
Source: double_pendulum.yaml
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = theta1 [rad]: upper rod from the downward vertical
y[1] = theta2 [rad]: lower rod from the downward vertical
y[2] = theta1'
y[3] = theta2'

Parameters p:
p[0]: m1 = 1.0 [kg]
p[1]: m2 = 1.0 [kg]
p[2]: l1 = 1.0 [m]
p[3]: l2 = 1.0 [m]
p[4]: g = 9.81 [m/s^2]: acceleration of gravity

Outputs:
out[0] = tip_x
out[1] = tip_y

Operations:
rhs: 9 +-, 30 *, 2 /, 4 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 9 +-, 30 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 3 +-, 11 *, 1 /, 4 calls
energy: 7 +-, 20 *, 0 /, 4 calls
jacobian: 29 +-, 87 *, 2 /, 4 calls
outputs: 2 +-, 4 *, 0 /, 4 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("theta1", "theta2")
STATE: tuple[str, ...] = ("theta1", "theta2", "theta1'", "theta2'")
PARAMETERS: tuple[str, ...] = ("m1", "m2", "l1", "l2", "g")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("tip_x", "tip_y")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0, 9.81)

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
    """right-hand side dy/dt = f(t, y; p) (II.3)

    Arguments: t (scalar), y (4,), p (5,).
    Returns dydt (4,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])
    theta2_dot = float(y[3])
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = m1 * g
        k2 = (m1 + m2) * (l1 * l1)
        k3 = l2 * (m2 * l1)
        k4 = m2 * (l2 * l2)
        k5 = m2 * l2
        k6 = 1.0 / k2
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "rhs")
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        z1 = k3 * (s_theta1 * s_theta2 + c_theta1 * c_theta2)
        z2 = z1 * k6
        z3 = k4 - z1 * z2
        # the mass matrix is singular
        if not abs(z3) > 1e-14 * k4:
            raise SingularModelError(2, "rhs")
        z4 = s_theta1 * c_theta2 - c_theta1 * s_theta2
        s1 = m2 * (l2 * (theta2_dot * theta2_dot) * z4 + g * s_theta1)
        z5 = l1 * (s1 + s_theta1 * k1)
        s2 = k5 * (z4 * (l1 * (theta1_dot * theta1_dot)) - g * s_theta2)
        z6 = (s2 + z5 * z2) / z3
        dydt: list[float] = [
            # theta1' (II.3)
            theta1_dot,
            # theta2' (II.3)
            theta2_dot,
            # theta1'' (II.3) 20:4
            -(z5 * k6 + z2 * z6),
            # theta2'' (II.3) 20:4
            z6,
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

    Arguments: t (scalar), y (4,), p (5,).
    Returns qdot (2,).
    """
    theta1_dot = float(y[2])
    theta2_dot = float(y[3])
    try:
        # state
        qdot: list[float] = [
            # theta1' (I.2.4)
            theta1_dot,
            # theta2' (I.2.4)
            theta2_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (II.3)

    Arguments: t (scalar), y (4,), p (5,).
    Returns qddot (2,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])
    theta2_dot = float(y[3])
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = m1 * g
        k2 = (m1 + m2) * (l1 * l1)
        k3 = l2 * (m2 * l1)
        k4 = m2 * (l2 * l2)
        k5 = m2 * l2
        k6 = 1.0 / k2
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        z1 = k3 * (s_theta1 * s_theta2 + c_theta1 * c_theta2)
        z2 = z1 * k6
        z3 = k4 - z1 * z2
        # the mass matrix is singular
        if not abs(z3) > 1e-14 * k4:
            raise SingularModelError(2, "accelerations")
        z4 = s_theta1 * c_theta2 - c_theta1 * s_theta2
        s1 = m2 * (l2 * (theta2_dot * theta2_dot) * z4 + g * s_theta1)
        z5 = l1 * (s1 + s_theta1 * k1)
        s2 = k5 * (z4 * (l1 * (theta1_dot * theta1_dot)) - g * s_theta2)
        z6 = (s2 + z5 * z2) / z3
        qddot: list[float] = [
            # theta1'' (II.3)
            -(z5 * k6 + z2 * z6),
            # theta2'' (II.3)
            z6,
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

    Arguments: t (scalar), q (2,), qdot (2,), p (5,).
    Returns y (4,).
    """
    theta1 = float(q[0])  # upper rod from the downward vertical [rad]
    theta2 = float(q[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(qdot[0])
    theta2_dot = float(qdot[1])
    try:
        # state
        y: list[float] = [theta1, theta2, theta1_dot, theta2_dot]
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

    Arguments: t (scalar), q (2,), qdot (2,), p (5,).
    Returns r (0,).
    """
    try:
        r: list[float] = []
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (4,), p (5,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    try:
        # parameters only
        k1 = (m1 + m2) * (l1 * l1)
        k2 = l2 * (m2 * l1)
        k3 = m2 * (l2 * l2)
        k4 = 1.0 / k1
        # state
        # the mass matrix is singular
        if not abs(k1) > 0.0:
            raise SingularModelError(2, "reactions")
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        z1 = k2 * (s_theta1 * s_theta2 + c_theta1 * c_theta2)
        s1 = k3 - z1 * (z1 * k4)
        # the mass matrix is singular
        if not abs(s1) > 1e-14 * k3:
            raise SingularModelError(2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (4,), p (5,).
    Returns a scalar.
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])
    theta2_dot = float(y[3])
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = m1 * l1
        # state
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        z1 = g * c_theta1
        s1 = (s_theta1 * s_theta2 + c_theta1 * c_theta2) * (theta2_dot * l2)
        z2 = l1 * (theta1_dot * (s1 + 0.5 * (theta1_dot * l1)) - z1)
        s2 = l2 * (0.5 * (l2 * (theta2_dot * theta2_dot)) - g * c_theta2)
        s3 = k1 * (0.5 * (l1 * (theta1_dot * theta1_dot)) - z1)
        z3 = m2 * (z2 + s2) + s3
        value1 = z3
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (II.3)

    Arguments: t (scalar), y (4,), p (5,).
    Returns rows (4, 4): d rhs_i / d y_j stands at [i][j].
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])
    theta2_dot = float(y[3])
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = m1 * g
        k2 = (m1 + m2) * (l1 * l1)
        k3 = m2 * l1
        k4 = l2 * k3
        k5 = m2 * (l2 * l2)
        k6 = m2 * l2
        k7 = 1.0 / k2
        k8 = l1 * k1 + g * k3
        k9 = g * k6
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        z1 = k4 * (s_theta1 * s_theta2 + c_theta1 * c_theta2)
        z2 = z1 * k7
        z3 = k5 - z1 * z2
        # the mass matrix is singular
        if not abs(z3) > 1e-14 * k5:
            raise SingularModelError(2, "jacobian")
        z4 = l2 * (theta2_dot * theta2_dot)
        z5 = k3 * z4
        z6 = 1.0 / z3
        z7 = s_theta1 * c_theta2 - c_theta1 * s_theta2
        z8 = l1 * (theta1_dot * theta1_dot)
        z9 = l1 * (m2 * (z4 * z7 + g * s_theta1) + s_theta1 * k1)
        z10 = z6 * (k6 * (z7 * z8 - g * s_theta2) + z9 * z2)
        z11 = k4 * z10
        s1 = c_theta1 * (k8 + c_theta2 * z5 + s_theta2 * z11)
        z12 = s_theta1 * (s_theta2 * z5 - c_theta2 * z11) + s1
        z13 = k6 * z8
        z14 = k4 * (z9 * k7 + z2 * z10)
        s2 = s_theta1 * (s_theta2 * z13 - c_theta2 * z14)
        z15 = s2 + c_theta1 * (c_theta2 * z13 + s_theta2 * z14) + z2 * z12
        z16 = z6 * z15
        s3 = s_theta2 * (s_theta1 * z5 + c_theta1 * z11)
        z17 = s3 + c_theta2 * (c_theta1 * z5 - s_theta1 * z11)
        s4 = c_theta2 * (k9 + c_theta1 * z13 - s_theta1 * z14)
        z18 = s_theta2 * (s_theta1 * z13 + c_theta1 * z14) + s4 + z2 * z17
        z19 = z6 * z18
        z20 = z6 * (theta1_dot * (l1 * (z7 * k6)))
        z21 = theta2_dot * (l2 * (k3 * z7))
        z22 = z6 * (z2 * z21)
        J: list[float] = [
            # (II.3)
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            -(k7 * z12 + z2 * z16),
            # (II.3)
            k7 * z17 + z2 * z19,
            # (II.3)
            -2.0 * (z2 * z20),
            # (II.3)
            -(2.0 * (k7 * z21) + 2.0 * (z2 * z22)),
            # (II.3)
            z16,
            # (II.3)
            -z19,
            # (II.3)
            2.0 * z20,
            # (II.3)
            2.0 * z22,
        ]
        _finish("jacobian", J)
        return [J[k10 : k10 + 4] for k10 in range(0, 16, 4)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (4,), p (5,).
    Returns out (2,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    try:
        # state
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        out: list[float] = [
            # tip_x 23:10
            l1 * s_theta1 + l2 * s_theta2,
            # tip_y 24:10
            -(l1 * c_theta1 + l2 * c_theta2),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
