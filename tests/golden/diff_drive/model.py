# ruff: noqa: E741
"""diff_drive, emitted by nhc 0.1.0 (nhc:72281fa5aff623d0).

A cart with two driven wheels and a caster; three velocity constraints, one of which
    is holonomic in disguise.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: midpoint of the axle
y[1] = y [m]: midpoint of the axle
y[2] = theta [rad]: heading
y[3] = p_R [rad]: right wheel
y[4] = p_L [rad]: left wheel
y[5] = v [m/s]
y[6] = w [rad/s]

Parameters p:
p[0]: m = 10.0 [kg]: mass
p[1]: I = 0.6 [kg*m^2]: of the whole about the vertical through the centre of mass
p[2]: J_w = 0.02 [kg*m^2]: of a wheel about its axle
p[3]: r = 0.1 [m]: radius of the wheels
p[4]: b = 0.25 [m]: half the track
p[5]: d = 0.1 [m]: from the axle to the centre of mass
p[6]: tau_R = 0.3 [N*m]: torque on the right wheel
p[7]: tau_L = 0.2 [N*m]: torque on the left wheel

Constraints, with the units of their reactions:
0: slip [N]
1: roll_R [N]
2: roll_L [N]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 9 +-, 22 *, 3 /, 2 calls
velocities: 2 +-, 5 *, 1 /, 2 calls
accelerations: 11 +-, 24 *, 3 /, 2 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 6 +-, 7 *, 0 /, 2 calls
reactions: 12 +-, 24 *, 3 /, 0 calls
energy: 4 +-, 13 *, 1 /, 0 calls
jacobian: 3 +-, 17 *, 3 /, 2 calls
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

COORDINATES: tuple[str, ...] = ("x", "y", "theta", "p_R", "p_L")
STATE: tuple[str, ...] = ("x", "y", "theta", "p_R", "p_L", "v", "w")
PARAMETERS: tuple[str, ...] = ("m", "I", "J_w", "r", "b", "d", "tau_R", "tau_L")
CONSTRAINTS: tuple[str, ...] = ("slip", "roll_R", "roll_L")
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = (10.0, 0.6, 0.02, 0.1, 0.25, 0.1, 0.3, 0.2)

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

    Arguments: t (scalar), y (7,), p (8,).
    Returns dydt (7,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # mass [kg]
    # of the whole about the vertical through the centre of mass [kg*m^2]
    I = float(p[1])
    J_w = float(p[2])  # of a wheel about its axle [kg*m^2]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    d = float(p[5])  # from the axle to the centre of mass [m]
    tau_R = float(p[6])  # torque on the right wheel [N*m]
    tau_L = float(p[7])  # torque on the left wheel [N*m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "rhs")
        # from the parameters alone
        k1 = 1.0 / r
        k2 = b * k1
        k3 = m + 2.0 * (k1 * (J_w * k1))
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "rhs")
        k4 = m * d
        k5 = k1 * (tau_R + tau_L)
        k6 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)))
        # the mass matrix is singular, if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "rhs")
        k7 = k2 * (tau_R - tau_L)
        k8 = 1.0 / k3
        k9 = -1.0 / k6
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z1 = b * w
        dydt: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            w,
            # p_R' (I.2.4)
            k1 * (v + z1),
            # p_L' (I.2.4)
            k1 * (v - z1),
            # v' (I.2.15) 24:4
            (k4 * (w * w) + k5) * k8,
            # w' (I.2.15) 24:4
            (v * w * k4 - k7) * k9,
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

    Arguments: t (scalar), y (7,), p (8,).
    Returns qdot (5,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "velocities")
        # from the parameters alone
        k1 = 1.0 / r
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        z1 = b * w
        qdot: list[float] = [
            # x' (I.2.4)
            c_theta * v,
            # y' (I.2.4)
            s_theta * v,
            # theta' (I.2.4)
            w,
            # p_R' (I.2.4)
            k1 * (v + z1),
            # p_L' (I.2.4)
            k1 * (v - z1),
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

    Arguments: t (scalar), y (7,), p (8,).
    Returns qddot (5,).
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # mass [kg]
    # of the whole about the vertical through the centre of mass [kg*m^2]
    I = float(p[1])
    J_w = float(p[2])  # of a wheel about its axle [kg*m^2]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    d = float(p[5])  # from the axle to the centre of mass [m]
    tau_R = float(p[6])  # torque on the right wheel [N*m]
    tau_L = float(p[7])  # torque on the left wheel [N*m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "accelerations")
        # from the parameters alone
        k1 = 1.0 / r
        k2 = b * k1
        k3 = m + 2.0 * (k1 * (J_w * k1))
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "accelerations")
        k4 = m * d
        k5 = k1 * (tau_R + tau_L)
        k6 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)))
        # the mass matrix is singular, if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "accelerations")
        k7 = k2 * (tau_R - tau_L)
        k8 = 1.0 / k3
        k9 = 1.0 / k6
        # from the state
        c_theta = math.cos(theta)
        z1 = (k4 * (w * w) + k5) * k8
        s_theta = math.sin(theta)
        z2 = v * w
        z3 = (z2 * k4 - k7) * k9
        z4 = b * z3
        qddot: list[float] = [
            # x'' (I.2.15)
            c_theta * z1 - s_theta * z2,
            # y'' (I.2.15)
            s_theta * z1 + c_theta * z2,
            # theta'' (I.2.15)
            -z3,
            # p_R'' (I.2.15)
            k1 * (z1 - z4),
            # p_L'' (I.2.15)
            k1 * (z1 + z4),
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

    Arguments: t (scalar), q (5,), qdot (5,), p (8,).
    Returns y (7,).
    """
    x = float(q[0])  # midpoint of the axle [m]
    y_2 = float(q[1])  # y: midpoint of the axle [m]
    theta = float(q[2])  # heading [rad]
    p_R = float(q[3])  # right wheel [rad]
    p_L = float(q[4])  # left wheel [rad]
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
            p_R,
            p_L,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (8,).
    Returns r (3,).
    """
    theta = float(q[2])  # heading [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    p_R_dot = float(qdot[3])  # p_R' [rad/s]
    p_L_dot = float(qdot[4])  # p_L' [rad/s]
    r_2 = float(p[3])  # r: radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    try:
        # from the coordinates and velocities
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        v = x_dot * c_theta + y_dot * s_theta
        z1 = theta_dot * b
        r: list[float] = [
            # slip = 0 (I.1.1) 29:5
            y_dot * c_theta - x_dot * s_theta,
            # roll_R = 0 (I.1.1) 30:5
            v + z1 - p_R_dot * r_2,
            # roll_L = 0 (I.1.1) 31:5
            v - z1 - p_L_dot * r_2,
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

    Arguments: t (scalar), y (7,), p (8,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # mass [kg]
    # of the whole about the vertical through the centre of mass [kg*m^2]
    I = float(p[1])
    J_w = float(p[2])  # of a wheel about its axle [kg*m^2]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    d = float(p[5])  # from the axle to the centre of mass [m]
    tau_R = float(p[6])  # torque on the right wheel [N*m]
    tau_L = float(p[7])  # torque on the left wheel [N*m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "reactions")
        # from the parameters alone
        k1 = 1.0 / r
        k2 = b * k1
        k3 = J_w * k1
        k4 = m + 2.0 * (k1 * k3)
        # the mass matrix is singular, if k4 is 0
        if not abs(k4) > 0.0:
            raise _refuse(abs(k4), 0.0, 2, "reactions")
        k5 = m * d
        k6 = k1 * (tau_R + tau_L)
        k7 = d * k5 + (I + 2.0 * (k2 * (J_w * k2)))
        # the mass matrix is singular, if k7 is 0
        if not abs(k7) > 0.0:
            raise _refuse(abs(k7), 0.0, 2, "reactions")
        k8 = k2 * (tau_R - tau_L)
        k9 = 1.0 / k4
        k10 = 1.0 / k7
        # from the state
        z1 = v * w
        z2 = (z1 * k5 - k8) * k10
        z3 = (k5 * (w * w) + k6) * k9
        z4 = b * z2
        lambda_: list[float] = [
            # reaction of slip: Q_i gains lambda_1 a_1i (I.4.1) 29:5
            m * (z1 - d * z2),
            # reaction of roll_R: Q_i gains lambda_2 a_2i (I.4.1) 30:5
            k1 * (tau_R - k3 * (z3 - z4)),
            # reaction of roll_L: Q_i gains lambda_3 a_3i (I.4.1) 31:5
            k1 * (tau_L - k3 * (z3 + z4)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (7,), p (8,).
    Returns a scalar.
    """
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # mass [kg]
    # of the whole about the vertical through the centre of mass [kg*m^2]
    I = float(p[1])
    J_w = float(p[2])  # of a wheel about its axle [kg*m^2]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    d = float(p[5])  # from the axle to the centre of mass [m]
    try:
        # from the parameters alone
        k1 = 1.0 / (r * r)
        k2 = k1 * (J_w * (b * b)) + 0.5 * (I + m * (d * d))
        k3 = 0.5 * m + J_w * k1
        # from the state
        value1 = w * w * k2 + v * v * k3
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (7,), p (8,).
    Returns rows (7, 7): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[2])  # heading [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # mass [kg]
    # of the whole about the vertical through the centre of mass [kg*m^2]
    I = float(p[1])
    J_w = float(p[2])  # of a wheel about its axle [kg*m^2]
    r = float(p[3])  # radius of the wheels [m]
    b = float(p[4])  # half the track [m]
    d = float(p[5])  # from the axle to the centre of mass [m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "jacobian")
        # from the parameters alone
        k1 = 1.0 / r
        k2 = b * k1
        k3 = m + 2.0 * (k1 * (J_w * k1))
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "jacobian")
        k4 = m * d
        k5 = d * k4 + (I + 2.0 * (k2 * (J_w * k2)))
        # the mass matrix is singular, if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "jacobian")
        k6 = 1.0 / k3
        k7 = 1.0 / k5
        k8 = -k4 * k7
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        z1 = w * k4
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_theta * v,
            0.0,
            0.0,
            # (I.2.15)
            c_theta,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta * v,
            0.0,
            0.0,
            # (I.2.15)
            s_theta,
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
            # (I.2.15)
            k1,
            # (I.2.15)
            k2,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            k1,
            # (I.2.15)
            -k2,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (k6 * z1),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -k7 * z1,
            # (I.2.15)
            v * k8,
        ]
        _finish("jacobian", J)
        return [J[k9 : k9 + 7] for k9 in range(0, 49, 7)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (7,), p (8,).
    Returns out (0,).
    """
    r = float(p[3])  # radius of the wheels [m]
    try:
        # the coframe is singular, if r is 0
        if not abs(r) > 0.0:
            raise _refuse(abs(r), 0.0, 1, "outputs")
        # from the state
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
