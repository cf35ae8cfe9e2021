"""double_pendulum, emitted by nhc 0.1.0 (nhc:5f10a6770be8c094).

Two pendulums in a row, absolute angles; the model gives positions and nhc
    differentiates them.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = theta1 [rad]: upper rod from the downward vertical
y[1] = theta2 [rad]: lower rod from the downward vertical
y[2] = theta1' [rad/s]
y[3] = theta2' [rad/s]

Parameters p:
p[0]: m1 = 1.0 [kg]
p[1]: m2 = 1.0 [kg]
p[2]: l1 = 1.0 [m]
p[3]: l2 = 1.0 [m]
p[4]: g = 9.81 [m/s^2]: acceleration of gravity

Outputs:
out[0] = tip_x [m]
out[1] = tip_y [m]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 6 +-, 14 *, 3 /, 4 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 6 +-, 14 *, 3 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 2 +-, 2 *, 0 /, 1 calls
energy: 7 +-, 20 *, 0 /, 4 calls
jacobian: 15 +-, 49 *, 3 /, 4 calls
outputs: 2 +-, 4 *, 0 /, 4 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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
    """Right-hand side dy/dt = f(t, y; p) (II.3).

    Arguments: t (scalar), y (4,), p (5,).
    Returns dydt (4,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])  # theta1' [rad/s]
    theta2_dot = float(y[3])  # theta2' [rad/s]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m2 is 0
        if not abs(m2) > 0.0:
            raise _refuse(abs(m2), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = -1.0 / l1
        k2 = 1.0 / l2
        # from the state
        z1 = theta1 - theta2
        s1 = math.sin(z1)
        z2 = m2 * s1
        z3 = m1 + s1 * z2
        # the mass matrix is singular, if z3 is nearly 0
        if not abs(z3) > 1e-13 * m1:
            raise _refuse(abs(z3), 1e-13 * m1, 2, "rhs")
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        z4 = l1 * (theta1_dot * theta1_dot) + g * c_theta1
        c1 = math.cos(z1)
        z5 = (l2 * (theta2_dot * theta2_dot) + z4 * c1) * (z2 / z3)
        dydt: list[float] = [
            # theta1' (II.3)
            theta1_dot,
            # theta2' (II.3)
            theta2_dot,
            # theta1'' (II.3) 20:4
            k1 * (g * s_theta1 + z5),
            # theta2'' (II.3) 20:4
            k2 * (z4 * s1 + c1 * z5),
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state.

    Arguments: t (scalar), y (4,), p (5,).
    Returns qdot (2,).
    """
    theta1_dot = float(y[2])  # theta1' [rad/s]
    theta2_dot = float(y[3])  # theta2' [rad/s]
    try:
        # from the state
        qdot: list[float] = [
            # theta1'
            theta1_dot,
            # theta2'
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
    """All accelerations q'' on the motion (II.3).

    Arguments: t (scalar), y (4,), p (5,).
    Returns qddot (2,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])  # theta1' [rad/s]
    theta2_dot = float(y[3])  # theta2' [rad/s]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m2 is 0
        if not abs(m2) > 0.0:
            raise _refuse(abs(m2), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = -1.0 / l1
        k2 = 1.0 / l2
        # from the state
        z1 = theta1 - theta2
        s1 = math.sin(z1)
        z2 = m2 * s1
        z3 = m1 + s1 * z2
        # the mass matrix is singular, if z3 is nearly 0
        if not abs(z3) > 1e-13 * m1:
            raise _refuse(abs(z3), 1e-13 * m1, 2, "accelerations")
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        z4 = l1 * (theta1_dot * theta1_dot) + g * c_theta1
        c1 = math.cos(z1)
        z5 = (l2 * (theta2_dot * theta2_dot) + z4 * c1) * (z2 / z3)
        qddot: list[float] = [
            # theta1'' (II.3)
            k1 * (g * s_theta1 + z5),
            # theta2'' (II.3)
            k2 * (z4 * s1 + c1 * z5),
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
    """The state y from coordinates and velocities.

    Arguments: t (scalar), q (2,), qdot (2,), p (5,).
    Returns y (4,).
    """
    theta1 = float(q[0])  # upper rod from the downward vertical [rad]
    theta2 = float(q[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(qdot[0])  # theta1' [rad/s]
    theta2_dot = float(qdot[1])  # theta2' [rad/s]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

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
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (4,), p (5,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    try:
        # the mass matrix is singular, if m2 is 0
        if not abs(m2) > 0.0:
            raise _refuse(abs(m2), 0.0, 2, "reactions")
        # from the state
        s1 = math.sin(theta1 - theta2)
        s2 = m1 + s1 * (m2 * s1)
        # the mass matrix is singular, if s2 is nearly 0
        if not abs(s2) > 1e-13 * m1:
            raise _refuse(abs(s2), 1e-13 * m1, 2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (4,), p (5,).
    Returns a scalar.
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])  # theta1' [rad/s]
    theta2_dot = float(y[3])  # theta2' [rad/s]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m1 * l1
        # from the state
        c_theta1 = math.cos(theta1)
        z1 = g * c_theta1
        c_theta2 = math.cos(theta2)
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        s1 = theta2_dot * (c_theta1 * c_theta2 + s_theta1 * s_theta2)
        z2 = l1 * (z1 - theta1_dot * (0.5 * (theta1_dot * l1) + l2 * s1))
        s2 = l2 * (0.5 * (l2 * (theta2_dot * theta2_dot)) - g * c_theta2)
        s3 = k1 * (0.5 * (l1 * (theta1_dot * theta1_dot)) - z1)
        z3 = s3 + m2 * (s2 - z2)
        value1 = z3
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (4,), p (5,).
    Returns rows (4, 4): d rhs_i / d y_j stands at [i][j].
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    theta1_dot = float(y[2])  # theta1' [rad/s]
    theta2_dot = float(y[3])  # theta2' [rad/s]
    m1 = float(p[0])  # [kg]
    m2 = float(p[1])  # [kg]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m2 is 0
        if not abs(m2) > 0.0:
            raise _refuse(abs(m2), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = 1.0 / l1
        k2 = 1.0 / l2
        # from the state
        z1 = theta1 - theta2
        s1 = math.sin(z1)
        z2 = m2 * s1
        z3 = m1 + s1 * z2
        # the mass matrix is singular, if z3 is nearly 0
        if not abs(z3) > 1e-13 * m1:
            raise _refuse(abs(z3), 1e-13 * m1, 2, "jacobian")
        c_theta1 = math.cos(theta1)
        z4 = g * c_theta1
        z5 = 1.0 / z3
        c1 = math.cos(z1)
        z6 = l1 * (theta1_dot * theta1_dot) + z4
        z7 = z6 * c1
        z8 = m2 * (l2 * (theta2_dot * theta2_dot) + z7)
        z9 = c1 * z8
        z10 = z6 * s1
        s_theta1 = math.sin(theta1)
        z11 = g * s_theta1
        z12 = c1 * z2
        z13 = s1 * z8
        z14 = 2.0 * (z5 * z5 * (z12 * z13))
        z15 = z5 * (z9 - z2 * (z10 + z11 * c1)) - z14
        z16 = z5 * (z9 - z2 * z10) - z14
        x1_dot = theta1_dot * l1
        z17 = z5 * (x1_dot * z12)
        z18 = l2 * (z5 * (theta2_dot * z2))
        z19 = z7 - z13 * (s1 * z5)
        J: list[float] = [
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            -k1 * (z4 + z15),
            # (II.3)
            k1 * z16,
            # (II.3)
            -2.0 * (k1 * z17),
            # (II.3)
            -2.0 * (k1 * z18),
            # (II.3)
            k2 * (z19 - (z11 * s1 - c1 * z15)),
            # (II.3)
            -k2 * (z19 + c1 * z16),
            # (II.3)
            2.0 * (k2 * (x1_dot * s1 + c1 * z17)),
            # (II.3)
            2.0 * (k2 * (c1 * z18)),
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 4] for k3 in range(0, 16, 4)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (4,), p (5,).
    Returns out (2,).
    """
    theta1 = float(y[0])  # upper rod from the downward vertical [rad]
    theta2 = float(y[1])  # lower rod from the downward vertical [rad]
    l1 = float(p[2])  # [m]
    l2 = float(p[3])  # [m]
    try:
        # from the state
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
