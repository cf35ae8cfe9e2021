"""rolling_disk, emitted by nhc 0.1.0 (nhc:a84ad538a46bb242).

A thin disk that rolls on a horizontal plane and may lean and fall (Euler's disk).
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: centre
y[1] = y [m]: centre
y[2] = phi [rad]: yaw, direction of the horizontal diameter
y[3] = theta [rad]: tilt of the plane of the disk, pi/2 upright
y[4] = psi [rad]: spin
y[5] = w_t [rad/s]
y[6] = w_u [rad/s]
y[7] = w_n [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 0.5 [m]: radius
p[2]: A = 0.0625 [kg*m^2]: moment of inertia about a diameter
p[3]: C = 0.125 [kg*m^2]: moment of inertia about the axis
p[4]: g = 9.81 [m/s^2]: acceleration of gravity

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]

Outputs:
out[0] = height [m]
out[1] = contact_x [m]
out[2] = contact_y [m]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 8 +-, 21 *, 4 /, 4 calls
velocities: 3 +-, 8 *, 1 /, 4 calls
accelerations: 15 +-, 41 *, 4 /, 4 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 5 +-, 8 *, 0 /, 4 calls
reactions: 9 +-, 22 *, 3 /, 4 calls
energy: 5 +-, 11 *, 0 /, 1 calls
jacobian: 8 +-, 44 *, 4 /, 4 calls
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

COORDINATES: tuple[str, ...] = ("x", "y", "phi", "theta", "psi")
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "psi", "w_t", "w_u", "w_n")
PARAMETERS: tuple[str, ...] = ("m", "R", "A", "C", "g")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("height", "contact_x", "contact_y")
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.0625, 0.125, 9.81)

REASONS = (
    "",
    "the coframe is singular",
    "the mass matrix is singular, or the velocities that are kept do not suffice",
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns dydt (8,).
    """
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    A = float(p[2])  # moment of inertia about a diameter [kg*m^2]
    C = float(p[3])  # moment of inertia about the axis [kg*m^2]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if A is 0
        if not abs(A) > 0.0:
            raise _refuse(abs(A), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = m * R
        k2 = R * k1
        k3 = C + k2
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "rhs")
        k4 = g * k1
        k5 = 1.0 / A
        k6 = A + k2
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "rhs")
        k7 = -1.0 / k6
        k8 = k2 / k3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "rhs")
        c_phi = math.cos(phi)
        z1 = R * w_n
        s_phi = math.sin(phi)
        z2 = R * (s_theta * w_t)
        z3 = w_u / s_theta
        c_theta = math.cos(theta)
        z4 = c_theta * z3
        z5 = A * z4
        dydt: list[float] = [
            # x' (I.2.4)
            s_phi * z2 - c_phi * z1,
            # y' (I.2.4)
            -(s_phi * z1 + c_phi * z2),
            # phi' (I.2.4)
            z3,
            # theta' (I.2.4)
            w_t,
            # psi' (I.2.4)
            w_n - z4,
            # w_t' (I.2.15) 22:4
            (c_theta * k4 + w_u * (w_n * k3 - z5)) * k7,
            # w_u' (I.2.15) 22:4
            k5 * (w_t * (C * w_n - z5)),
            # w_n' (I.2.15) 22:4
            k8 * (w_t * w_u),
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qdot (5,).
    """
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "velocities")
        s_phi = math.sin(phi)
        z1 = R * s_theta * w_t
        c_phi = math.cos(phi)
        z2 = R * w_n
        z3 = w_u / s_theta
        c_theta = math.cos(theta)
        qdot: list[float] = [
            # x' (I.2.4)
            s_phi * z1 - c_phi * z2,
            # y' (I.2.4)
            -(c_phi * z1 + s_phi * z2),
            # phi' (I.2.4)
            z3,
            # theta' (I.2.4)
            w_t,
            # psi' (I.2.4)
            w_n - c_theta * z3,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    A = float(p[2])  # moment of inertia about a diameter [kg*m^2]
    C = float(p[3])  # moment of inertia about the axis [kg*m^2]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if A is 0
        if not abs(A) > 0.0:
            raise _refuse(abs(A), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = m * R * R
        k2 = A + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k2 is 0
        if not abs(k2) > 0.0:
            raise _refuse(abs(k2), 0.0, 2, "accelerations")
        k3 = C + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "accelerations")
        k4 = g * (m * R)
        k5 = 1.0 / k2
        k6 = 1.0 / A
        k7 = k1 / k3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "accelerations")
        z = R * s_theta
        z1 = z * w_t
        c_phi = math.cos(phi)
        z2 = 1.0 / s_theta
        z3 = w_u * z2
        z4 = c_phi * z3
        s_phi = math.sin(phi)
        c_theta = math.cos(theta)
        z5 = c_theta * w_t
        z6 = A * (c_theta * z3)
        z7 = k5 * (c_theta * k4 + w_u * (w_n * k3 - z6))
        z8 = R * (w_t * z5) - z * z7
        z9 = R * w_n
        z10 = s_phi * z3
        z11 = w_t * w_u * k7
        z12 = R * z11
        z13 = z2 * z2 * (w_u * z5) - k6 * ((C * w_n - z6) * (w_t * z2))
        qddot: list[float] = [
            # x'' (I.2.15)
            z1 * z4 + s_phi * z8 + (z9 * z10 - c_phi * z12),
            # y'' (I.2.15)
            z1 * z10 - c_phi * z8 - (z9 * z4 + s_phi * z12),
            # phi'' (I.2.15)
            -z13,
            # theta'' (I.2.15)
            -z7,
            # psi'' (I.2.15)
            z11 + (z3 * (s_theta * w_t) + c_theta * z13),
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

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
    Returns y (8,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # y: centre [m]
    phi = float(q[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(q[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    psi = float(q[4])  # spin [rad]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        y: list[float] = [
            x,
            y_2,
            phi,
            theta,
            psi,
            theta_dot,
            phi_dot * s_theta,
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
    Returns r (2,).
    """
    phi = float(q[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(q[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
        c_theta = math.cos(theta)
        z1 = R * (psi_dot + phi_dot * c_theta)
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        z2 = theta_dot * (R * s_theta)
        r: list[float] = [
            # roll_x = 0 (I.1.1) 25:5
            x_dot + z1 * c_phi - s_phi * z2,
            # roll_y = 0 (I.1.1) 26:5
            y_dot + z1 * s_phi + c_phi * z2,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    A = float(p[2])  # moment of inertia about a diameter [kg*m^2]
    C = float(p[3])  # moment of inertia about the axis [kg*m^2]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if A is 0
        if not abs(A) > 0.0:
            raise _refuse(abs(A), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = m * R
        k2 = m * R * R
        k3 = A + k2
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "reactions")
        k4 = C + k2
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k4 is 0
        if not abs(k4) > 0.0:
            raise _refuse(abs(k4), 0.0, 2, "reactions")
        k5 = g * k1
        k6 = 1.0 / k3
        k7 = 1.0 - k2 / k4
        k8 = k4 * k6
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "reactions")
        c_phi = math.cos(phi)
        z1 = w_t * w_u * k7
        s_phi = math.sin(phi)
        c_theta = math.cos(theta)
        s1 = c_theta * (w_t * w_t + k6 * (A * (w_u * w_u) - s_theta * k5))
        z2 = s1 + w_u * w_n * (1.0 / s_theta - s_theta * k8)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 25:5
            k1 * (c_phi * z1 + s_phi * z2),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 26:5
            k1 * (s_phi * z1 - c_phi * z2),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (8,), p (5,).
    Returns a scalar.
    """
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    A = float(p[2])  # moment of inertia about a diameter [kg*m^2]
    C = float(p[3])  # moment of inertia about the axis [kg*m^2]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * R
        # from the state
        z1 = w_t * w_t
        z2 = w_n * w_n
        s_theta = math.sin(theta)
        s1 = k1 * (0.5 * (R * (z1 + z2)) + g * s_theta)
        z3 = s1 + 0.5 * (A * (w_u * w_u + z1) + C * z2)
        value1 = z3
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (8,), p (5,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    w_t = float(y[5])  # [rad/s]
    w_u = float(y[6])  # [rad/s]
    w_n = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    A = float(p[2])  # moment of inertia about a diameter [kg*m^2]
    C = float(p[3])  # moment of inertia about the axis [kg*m^2]
    g = float(p[4])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if A is 0
        if not abs(A) > 0.0:
            raise _refuse(abs(A), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = m * R * R
        k2 = A + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k2 is 0
        if not abs(k2) > 0.0:
            raise _refuse(abs(k2), 0.0, 2, "jacobian")
        k3 = C + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "jacobian")
        k4 = g * (m * R)
        k5 = 1.0 / k2
        k6 = 1.0 / A
        k7 = k1 / k3
        k8 = -k3 * k5
        k9 = C * k6
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "jacobian")
        c_phi = math.cos(phi)
        z = R * s_theta
        z1 = z * w_t
        s_phi = math.sin(phi)
        z2 = R * w_n
        c_theta = math.cos(theta)
        z_dot = R * (c_theta * w_t)
        z3 = 1.0 / s_theta
        z4 = z3 * z3
        z5 = w_u * z4
        z6 = c_theta * z5
        z7 = c_theta * z3
        z8 = A * (w_u * z7)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            c_phi * z1 + s_phi * z2,
            # (I.2.15)
            s_phi * z_dot,
            0.0,
            # (I.2.15)
            z * s_phi,
            0.0,
            # (I.2.15)
            -R * c_phi,
            0.0,
            0.0,
            # (I.2.15)
            s_phi * z1 - c_phi * z2,
            # (I.2.15)
            -c_phi * z_dot,
            0.0,
            # (I.2.15)
            -z * c_phi,
            0.0,
            # (I.2.15)
            -R * s_phi,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z6,
            0.0,
            0.0,
            # (I.2.15)
            z3,
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
            # (I.2.15)
            w_u + c_theta * z6,
            0.0,
            0.0,
            # (I.2.15)
            -z7,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            k5 * (s_theta * k4 - A * (z4 * (w_u * w_u))),
            0.0,
            0.0,
            # (I.2.15)
            (2.0 * z8 - w_n * k3) * k5,
            # (I.2.15)
            w_u * k8,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            w_t * z5,
            0.0,
            # (I.2.15)
            k6 * (C * w_n - z8),
            # (I.2.15)
            -w_t * z7,
            # (I.2.15)
            w_t * k9,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            w_u * k7,
            # (I.2.15)
            w_t * k7,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k10 : k10 + 8] for k10 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (8,), p (5,).
    Returns out (3,).
    """
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # yaw, direction of the horizontal diameter [rad]
    theta = float(y[3])  # tilt of the plane of the disk, pi/2 upright [rad]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12:
            raise _refuse(abs(s_theta), 1e-12, 1, "outputs")
        s_phi = math.sin(phi)
        c_theta = math.cos(theta)
        z1 = R * c_theta
        c_phi = math.cos(phi)
        out: list[float] = [
            # height 33:11
            R * s_theta,
            # contact_x 34:14
            x - s_phi * z1,
            # contact_y 35:14
            y_2 + c_phi * z1,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
