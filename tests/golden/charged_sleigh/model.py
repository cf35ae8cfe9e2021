"""charged_sleigh, emitted by nhc 0.1.0 (nhc:f5ad5bf82e12e989).

Čaplygin's sleigh with a charge at its centre of mass in a magnetic field; T depends
    on x and y.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: point of the edge
y[1] = y [m]: point of the edge
y[2] = theta [rad]: heading
y[3] = v [m/s]
y[4] = w [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: J = 0.5 [kg*m^2]: moment of inertia about the centre of mass
p[2]: a = 0.7 [m]: from the edge to the centre of mass
p[3]: B = 0.9 [kg/s]: charge times field

Constraints, with the units of their reactions:
0: slip [N]

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 2 +-, 10 *, 2 /, 2 calls
velocities: 0 +-, 2 *, 0 /, 2 calls
accelerations: 4 +-, 13 *, 2 /, 2 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 1 +-, 2 *, 0 /, 2 calls
reactions: 2 +-, 5 *, 1 /, 0 calls
energy: 7 +-, 15 *, 0 /, 2 calls
jacobian: 3 +-, 12 *, 2 /, 2 calls
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

COORDINATES: tuple[str, ...] = ("x", "y", "theta")
STATE: tuple[str, ...] = ("x", "y", "theta", "v", "w")
PARAMETERS: tuple[str, ...] = ("m", "J", "a", "B")
CONSTRAINTS: tuple[str, ...] = ("slip",)
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.7, 0.9)

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
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (5,), p (4,).
    Returns dydt (5,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the centre of mass [kg*m^2]
    a = float(p[2])  # from the edge to the centre of mass [m]
    B = float(p[3])  # charge times field [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = J + m * (a * a)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "rhs")
        k2 = 1.0 / m
        k3 = -1.0 / k1
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z1 = a * (B + m * w)
        dydt: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            w,
            # v' (I.2.15) 18:4
            k2 * (w * z1),
            # w' (I.2.15) 18:4
            k3 * (v * z1),
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

    Arguments: t (scalar), y (5,), p (4,).
    Returns qdot (3,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    try:
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        qdot: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            w,
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

    Arguments: t (scalar), y (5,), p (4,).
    Returns qddot (3,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the centre of mass [kg*m^2]
    a = float(p[2])  # from the edge to the centre of mass [m]
    B = float(p[3])  # charge times field [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = J + m * (a * a)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "accelerations")
        k2 = 1.0 / m
        k3 = -1.0 / k1
        # from the state
        s_theta = math.sin(theta)
        z1 = v * w
        c_theta = math.cos(theta)
        z2 = a * (B + m * w)
        z3 = k2 * (w * z2)
        qddot: list[float] = [
            # x'' (I.2.15)
            c_theta * z3 - s_theta * z1,
            # y'' (I.2.15)
            c_theta * z1 + s_theta * z3,
            # theta'' (I.2.15)
            k3 * (v * z2),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (4,).
    Returns y (5,).
    """
    x = float(q[0])  # point of the edge [m]
    y_2 = float(q[1])  # y: point of the edge [m]
    theta = float(q[2])  # heading [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    try:
        # from the coordinates and velocities
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        y: list[float] = [x, y_2, theta, x_dot * c_theta + y_dot * s_theta, theta_dot]
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

    Arguments: t (scalar), q (3,), qdot (3,), p (4,).
    Returns r (1,).
    """
    theta = float(q[2])  # heading [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    try:
        # from the coordinates and velocities
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        r: list[float] = [
            # slip = 0 (I.1.1) 20:5
            y_dot * c_theta - x_dot * s_theta,
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

    Arguments: t (scalar), y (5,), p (4,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the centre of mass [kg*m^2]
    a = float(p[2])  # from the edge to the centre of mass [m]
    B = float(p[3])  # charge times field [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = J + m * (a * a)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "reactions")
        k2 = J / k1
        # from the state
        lambda_: list[float] = [
            # reaction of slip: Q_i gains lambda_1 a_1i (I.4.1) 20:5
            v * (B + m * w) * k2,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (5,), p (4,).
    Returns a scalar.
    """
    x = float(y[0])  # point of the edge [m]
    y_2 = float(y[1])  # y: point of the edge [m]
    theta = float(y[2])  # heading [rad]
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the centre of mass [kg*m^2]
    a = float(p[2])  # from the edge to the centre of mass [m]
    B = float(p[3])  # charge times field [kg/s]
    try:
        # from the parameters alone
        k1 = a * a
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        s1 = a * w * (a + (x * c_theta + y_2 * s_theta))
        z1 = v * (x * s_theta - y_2 * c_theta) + s1
        z2 = w * w
        value1 = 0.5 * (B * z1 + (J * z2 + m * (z2 * k1 + v * v)))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (5,), p (4,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[3])  # [m/s]
    w = float(y[4])  # [rad/s]
    m = float(p[0])  # mass [kg]
    J_2 = float(p[1])  # J: moment of inertia about the centre of mass [kg*m^2]
    a = float(p[2])  # from the edge to the centre of mass [m]
    B = float(p[3])  # charge times field [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = m * a
        k2 = J_2 + m * (a * a)
        # the mass matrix is singular, if k2 is 0
        if not abs(k2) > 0.0:
            raise _refuse(abs(k2), 0.0, 2, "jacobian")
        k3 = 1.0 / m
        k4 = 1.0 / k2
        k5 = -k1 * k4
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        z1 = a * (B + m * w)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_theta * v,
            # (I.2.15)
            c_theta,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta * v,
            # (I.2.15)
            s_theta,
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
            k3 * (z1 + w * k1),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -k4 * z1,
            # (I.2.15)
            v * k5,
        ]
        _finish("jacobian", J)
        return [J[k6 : k6 + 5] for k6 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (4,).
    Returns out (1,).
    """
    v = float(y[3])  # [m/s]
    try:
        # from the state
        out: list[float] = [
            # speed 25:10
            v,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
