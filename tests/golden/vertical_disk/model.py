# ruff: noqa: E741
"""vertical_disk, emitted by nhc 0.1.0 (nhc:6d92d73aaf98ba7b).

A disk that stays upright and rolls without slipping.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec

State y:
y[0] = x [m]: point of contact
y[1] = y [m]: point of contact
y[2] = phi [rad]: heading
y[3] = theta [rad]: angle rolled
y[4] = phi' [rad/s]
y[5] = theta' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 0.5 [m]: radius
p[2]: I = 0.125 [kg*m^2]: moment of inertia about the axle
p[3]: J = 0.0625 [kg*m^2]: moment of inertia about the vertical

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 1 +-, 5 *, 0 /, 2 calls
velocities: 0 +-, 3 *, 0 /, 2 calls
accelerations: 1 +-, 6 *, 0 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 2 +-, 3 *, 0 /, 2 calls
reactions: 1 +-, 6 *, 0 /, 2 calls
energy: 2 +-, 7 *, 0 /, 0 calls
jacobian: 1 +-, 6 *, 0 /, 2 calls
outputs: 0 +-, 1 *, 0 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "phi", "theta")
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "phi'", "theta'")
PARAMETERS: tuple[str, ...] = ("m", "R", "I", "J")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.125, 0.0625)

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
    """Right-hand side dy/dt = f(t, y; p) (III.3).

    Arguments: t (scalar), y (6,), p (4,).
    Returns dydt (6,).
    """
    phi = float(y[2])  # heading [rad]
    phi_dot = float(y[4])  # phi' [rad/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # moment of inertia about the axle [kg*m^2]
    J = float(p[3])  # moment of inertia about the vertical [kg*m^2]
    try:
        s1 = I + R * (m * R)
        # the mass matrix is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 2, "rhs")
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "rhs")
        # from the state
        c_phi = math.cos(phi)
        v1_x = theta_dot * R
        s_phi = math.sin(phi)
        dydt: list[float] = [
            # x' (I.1.2)
            c_phi * v1_x,
            # y' (I.1.2)
            s_phi * v1_x,
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # phi'' (III.3) 16:4
            0.0,
            # theta'' (III.3) 16:4
            0.0,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state (I.1.2).

    Arguments: t (scalar), y (6,), p (4,).
    Returns qdot (4,).
    """
    phi = float(y[2])  # heading [rad]
    phi_dot = float(y[4])  # phi' [rad/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        c_phi = math.cos(phi)
        v1_x = theta_dot * R
        s_phi = math.sin(phi)
        qdot: list[float] = [
            # x' (I.1.2)
            c_phi * v1_x,
            # y' (I.1.2)
            s_phi * v1_x,
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All accelerations q'' on the motion (III.3).

    Arguments: t (scalar), y (6,), p (4,).
    Returns qddot (4,).
    """
    phi = float(y[2])  # heading [rad]
    phi_dot = float(y[4])  # phi' [rad/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # moment of inertia about the axle [kg*m^2]
    J = float(p[3])  # moment of inertia about the vertical [kg*m^2]
    try:
        s1 = I + R * (m * R)
        # the mass matrix is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 2, "accelerations")
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "accelerations")
        # from the state
        s_phi = math.sin(phi)
        z1 = R * (phi_dot * theta_dot)
        c_phi = math.cos(phi)
        qddot: list[float] = [
            # x'' (III.3)
            -s_phi * z1,
            # y'' (III.3)
            c_phi * z1,
            # phi'' (III.3)
            0.0,
            # theta'' (III.3)
            0.0,
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

    Arguments: t (scalar), q (4,), qdot (4,), p (4,).
    Returns y (6,).
    """
    x = float(q[0])  # point of contact [m]
    y_2 = float(q[1])  # y: point of contact [m]
    phi = float(q[2])  # heading [rad]
    theta = float(q[3])  # angle rolled [rad]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, phi, theta, phi_dot, theta_dot]
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

    Arguments: t (scalar), q (4,), qdot (4,), p (4,).
    Returns r (2,).
    """
    phi = float(q[2])  # heading [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
        c_phi = math.cos(phi)
        v1_x = theta_dot * R
        s_phi = math.sin(phi)
        r: list[float] = [
            # roll_x = 0 (I.1.1) 18:5
            x_dot - c_phi * v1_x,
            # roll_y = 0 (I.1.1) 19:5
            y_dot - s_phi * v1_x,
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

    Arguments: t (scalar), y (6,), p (4,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # heading [rad]
    phi_dot = float(y[4])  # phi' [rad/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # moment of inertia about the axle [kg*m^2]
    J = float(p[3])  # moment of inertia about the vertical [kg*m^2]
    try:
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = m * R
        # the mass matrix is singular, if I + R * k1 is 0
        if not abs(I + R * k1) > 0.0:
            raise _refuse(abs(I + R * k1), 0.0, 2, "reactions")
        # from the state
        s_phi = math.sin(phi)
        z1 = k1 * (phi_dot * theta_dot)
        c_phi = math.cos(phi)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            -s_phi * z1,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 19:5
            c_phi * z1,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (6,), p (4,).
    Returns a scalar.
    """
    phi_dot = float(y[4])  # phi' [rad/s]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # moment of inertia about the axle [kg*m^2]
    J = float(p[3])  # moment of inertia about the vertical [kg*m^2]
    try:
        # from the parameters alone
        k1 = I + m * (R * R)
        # from the state
        value1 = 0.5 * (J * (phi_dot * phi_dot) + theta_dot * theta_dot * k1)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

    Arguments: t (scalar), y (6,), p (4,).
    Returns rows (6, 6): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # heading [rad]
    theta_dot = float(y[5])  # theta' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # moment of inertia about the axle [kg*m^2]
    J_2 = float(p[3])  # J: moment of inertia about the vertical [kg*m^2]
    try:
        s1 = I + R * (m * R)
        # the mass matrix is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 2, "jacobian")
        # the mass matrix is singular, if J_2 is 0
        if not abs(J_2) > 0.0:
            raise _refuse(abs(J_2), 0.0, 2, "jacobian")
        # from the state
        s_phi = math.sin(phi)
        z1 = R * s_phi
        c_phi = math.cos(phi)
        z2 = R * c_phi
        J: list[float] = [
            0.0,
            0.0,
            # (III.3)
            -theta_dot * z1,
            0.0,
            0.0,
            # (III.3)
            z2,
            0.0,
            0.0,
            # (III.3)
            theta_dot * z2,
            0.0,
            0.0,
            # (III.3)
            z1,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
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
            0.0,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 6] for k1 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (6,), p (4,).
    Returns out (1,).
    """
    theta_dot = float(y[5])  # theta' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        out: list[float] = [
            # speed 22:10
            theta_dot * R,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
