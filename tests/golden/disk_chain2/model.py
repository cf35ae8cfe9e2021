# ruff: noqa: E741
"""disk_chain2, emitted by nhc 0.1.0 (nhc:d6b235d8a12ba702).

Two upright rolling disks joined by a spring; the first link of a chain that may be
    made as long as one likes.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): a force
    acts on the dependent coordinates `x1`, `y1`, `x2`, `y2`
Note: hypothesis of I.3 that fails (the generalized equations are used): the force
    on `x1` contains the dependent coordinate `x2`
Note: hypothesis of I.3 that fails (the generalized equations are used): the force
    on `y1` contains the dependent coordinate `y2`
Note: hypothesis of I.3 that fails (the generalized equations are used): the force
    on `x2` contains the dependent coordinate `x1`
Note: hypothesis of I.3 that fails (the generalized equations are used): the force
    on `y2` contains the dependent coordinate `y1`

State y:
y[0] = x1 [m]: first disk
y[1] = y1 [m]: first disk
y[2] = phi1 [rad]: heading
y[3] = theta1 [rad]: angle rolled
y[4] = x2 [m]: second disk
y[5] = y2 [m]: second disk
y[6] = phi2 [rad]: heading
y[7] = theta2 [rad]: angle rolled
y[8] = phi1' [rad/s]
y[9] = theta1' [rad/s]
y[10] = phi2' [rad/s]
y[11] = theta2' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of each
p[1]: R = 0.5 [m]: radius
p[2]: I = 0.125 [kg*m^2]: about the axle
p[3]: J = 0.0625 [kg*m^2]: about the vertical
p[4]: k = 1.0 [N/m]: stiffness of the spring

Constraints, with the units of their reactions:
0: roll_x1 [N]
1: roll_y1 [N]
2: roll_x2 [N]
3: roll_y2 [N]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 5 +-, 15 *, 1 /, 4 calls
velocities: 0 +-, 6 *, 0 /, 4 calls
accelerations: 9 +-, 23 *, 1 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 4 +-, 6 *, 0 /, 4 calls
reactions: 13 +-, 25 *, 1 /, 4 calls
energy: 9 +-, 18 *, 0 /, 0 calls
jacobian: 5 +-, 21 *, 1 /, 4 calls
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

COORDINATES: tuple[str, ...] = (
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2",
)
STATE: tuple[str, ...] = (
    "x1",
    "y1",
    "phi1",
    "theta1",
    "x2",
    "y2",
    "phi2",
    "theta2",
    "phi1'",
    "theta1'",
    "phi2'",
    "theta2'",
)
PARAMETERS: tuple[str, ...] = ("m", "R", "I", "J", "k")
CONSTRAINTS: tuple[str, ...] = ("roll_x1", "roll_y1", "roll_x2", "roll_y2")
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.125, 0.0625, 1.0)

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

    Arguments: t (scalar), y (12,), p (5,).
    Returns dydt (12,).
    """
    x1 = float(y[0])  # first disk [m]
    y1 = float(y[1])  # first disk [m]
    phi1 = float(y[2])  # heading [rad]
    x2 = float(y[4])  # second disk [m]
    y2 = float(y[5])  # second disk [m]
    phi2 = float(y[6])  # heading [rad]
    phi1_dot = float(y[8])  # phi1' [rad/s]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    phi2_dot = float(y[10])  # phi2' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    m = float(p[0])  # mass of each [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # about the axle [kg*m^2]
    J = float(p[3])  # about the vertical [kg*m^2]
    k = float(p[4])  # stiffness of the spring [N/m]
    try:
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = I + m * (R * R)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "rhs")
        k2 = R * k / k1
        # from the state
        c_phi1 = math.cos(phi1)
        v1_x1 = theta1_dot * R
        s_phi1 = math.sin(phi1)
        c_phi2 = math.cos(phi2)
        v1_x2 = theta2_dot * R
        s_phi2 = math.sin(phi2)
        z1 = x1 - x2
        z2 = y1 - y2
        dydt: list[float] = [
            # x1' (I.1.2)
            c_phi1 * v1_x1,
            # y1' (I.1.2)
            s_phi1 * v1_x1,
            # phi1' (I.1.2)
            phi1_dot,
            # theta1' (I.1.2)
            theta1_dot,
            # x2' (I.1.2)
            c_phi2 * v1_x2,
            # y2' (I.1.2)
            s_phi2 * v1_x2,
            # phi2' (I.1.2)
            phi2_dot,
            # theta2' (I.1.2)
            theta2_dot,
            # phi1'' (III.3) 24:4
            0.0,
            # theta1'' (III.3) 24:4
            -(z1 * c_phi1 + z2 * s_phi1) * k2,
            # phi2'' (III.3) 24:4
            0.0,
            # theta2'' (III.3) 24:4
            (z1 * c_phi2 + z2 * s_phi2) * k2,
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

    Arguments: t (scalar), y (12,), p (5,).
    Returns qdot (8,).
    """
    phi1 = float(y[2])  # heading [rad]
    phi2 = float(y[6])  # heading [rad]
    phi1_dot = float(y[8])  # phi1' [rad/s]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    phi2_dot = float(y[10])  # phi2' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        c_phi1 = math.cos(phi1)
        v1_x1 = theta1_dot * R
        s_phi1 = math.sin(phi1)
        c_phi2 = math.cos(phi2)
        v1_x2 = theta2_dot * R
        s_phi2 = math.sin(phi2)
        qdot: list[float] = [
            # x1' (I.1.2)
            c_phi1 * v1_x1,
            # y1' (I.1.2)
            s_phi1 * v1_x1,
            # phi1' (I.1.2)
            phi1_dot,
            # theta1' (I.1.2)
            theta1_dot,
            # x2' (I.1.2)
            c_phi2 * v1_x2,
            # y2' (I.1.2)
            s_phi2 * v1_x2,
            # phi2' (I.1.2)
            phi2_dot,
            # theta2' (I.1.2)
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
    """All accelerations q'' on the motion (III.3).

    Arguments: t (scalar), y (12,), p (5,).
    Returns qddot (8,).
    """
    x1 = float(y[0])  # first disk [m]
    y1 = float(y[1])  # first disk [m]
    phi1 = float(y[2])  # heading [rad]
    x2 = float(y[4])  # second disk [m]
    y2 = float(y[5])  # second disk [m]
    phi2 = float(y[6])  # heading [rad]
    phi1_dot = float(y[8])  # phi1' [rad/s]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    phi2_dot = float(y[10])  # phi2' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    m = float(p[0])  # mass of each [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # about the axle [kg*m^2]
    J = float(p[3])  # about the vertical [kg*m^2]
    k = float(p[4])  # stiffness of the spring [N/m]
    try:
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = I + m * (R * R)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "accelerations")
        k2 = R * k / k1
        # from the state
        s_phi1 = math.sin(phi1)
        z1 = R * (phi1_dot * theta1_dot)
        c_phi1 = math.cos(phi1)
        z2 = x1 - x2
        z3 = y1 - y2
        z4 = (z2 * c_phi1 + z3 * s_phi1) * k2
        z5 = R * z4
        s_phi2 = math.sin(phi2)
        z6 = R * (phi2_dot * theta2_dot)
        c_phi2 = math.cos(phi2)
        z7 = (z2 * c_phi2 + z3 * s_phi2) * k2
        z8 = R * z7
        qddot: list[float] = [
            # x1'' (III.3)
            -(s_phi1 * z1 + c_phi1 * z5),
            # y1'' (III.3)
            c_phi1 * z1 - s_phi1 * z5,
            # phi1'' (III.3)
            0.0,
            # theta1'' (III.3)
            -z4,
            # x2'' (III.3)
            c_phi2 * z8 - s_phi2 * z6,
            # y2'' (III.3)
            c_phi2 * z6 + s_phi2 * z8,
            # phi2'' (III.3)
            0.0,
            # theta2'' (III.3)
            z7,
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

    Arguments: t (scalar), q (8,), qdot (8,), p (5,).
    Returns y (12,).
    """
    x1 = float(q[0])  # first disk [m]
    y1 = float(q[1])  # first disk [m]
    phi1 = float(q[2])  # heading [rad]
    theta1 = float(q[3])  # angle rolled [rad]
    x2 = float(q[4])  # second disk [m]
    y2 = float(q[5])  # second disk [m]
    phi2 = float(q[6])  # heading [rad]
    theta2 = float(q[7])  # angle rolled [rad]
    phi1_dot = float(qdot[2])  # phi1' [rad/s]
    theta1_dot = float(qdot[3])  # theta1' [rad/s]
    phi2_dot = float(qdot[6])  # phi2' [rad/s]
    theta2_dot = float(qdot[7])  # theta2' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [
            x1,
            y1,
            phi1,
            theta1,
            x2,
            y2,
            phi2,
            theta2,
            phi1_dot,
            theta1_dot,
            phi2_dot,
            theta2_dot,
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

    Arguments: t (scalar), q (8,), qdot (8,), p (5,).
    Returns r (4,).
    """
    phi1 = float(q[2])  # heading [rad]
    phi2 = float(q[6])  # heading [rad]
    x1_dot = float(qdot[0])  # x1' [m/s]
    y1_dot = float(qdot[1])  # y1' [m/s]
    theta1_dot = float(qdot[3])  # theta1' [rad/s]
    x2_dot = float(qdot[4])  # x2' [m/s]
    y2_dot = float(qdot[5])  # y2' [m/s]
    theta2_dot = float(qdot[7])  # theta2' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
        c_phi1 = math.cos(phi1)
        v1_x1 = theta1_dot * R
        s_phi1 = math.sin(phi1)
        c_phi2 = math.cos(phi2)
        v1_x2 = theta2_dot * R
        s_phi2 = math.sin(phi2)
        r: list[float] = [
            # roll_x1 = 0 (I.1.1) 27:5
            x1_dot - c_phi1 * v1_x1,
            # roll_y1 = 0 (I.1.1) 28:5
            y1_dot - s_phi1 * v1_x1,
            # roll_x2 = 0 (I.1.1) 29:5
            x2_dot - c_phi2 * v1_x2,
            # roll_y2 = 0 (I.1.1) 30:5
            y2_dot - s_phi2 * v1_x2,
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

    Arguments: t (scalar), y (12,), p (5,).
    Returns lambda_ (4,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    x1 = float(y[0])  # first disk [m]
    y1 = float(y[1])  # first disk [m]
    phi1 = float(y[2])  # heading [rad]
    x2 = float(y[4])  # second disk [m]
    y2 = float(y[5])  # second disk [m]
    phi2 = float(y[6])  # heading [rad]
    phi1_dot = float(y[8])  # phi1' [rad/s]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    phi2_dot = float(y[10])  # phi2' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    m = float(p[0])  # mass of each [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # about the axle [kg*m^2]
    J = float(p[3])  # about the vertical [kg*m^2]
    k = float(p[4])  # stiffness of the spring [N/m]
    try:
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = m * R
        k2 = m * R * R
        k3 = I + k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "reactions")
        k4 = k2 / k3
        # from the state
        s_phi1 = math.sin(phi1)
        z1 = k1 * (phi1_dot * theta1_dot)
        z2 = x1 - x2
        c_phi1 = math.cos(phi1)
        z3 = y1 - y2
        z4 = (z2 * c_phi1 + z3 * s_phi1) * k4
        s_phi2 = math.sin(phi2)
        z5 = k1 * (phi2_dot * theta2_dot)
        c_phi2 = math.cos(phi2)
        z6 = (z2 * c_phi2 + z3 * s_phi2) * k4
        lambda_: list[float] = [
            # reaction of roll_x1: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            k * (z2 - c_phi1 * z4) - s_phi1 * z1,
            # reaction of roll_y1: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            c_phi1 * z1 + k * (z3 - s_phi1 * z4),
            # reaction of roll_x2: Q_i gains lambda_3 a_3i (I.4.1) 29:5
            -(s_phi2 * z5 + k * (z2 - c_phi2 * z6)),
            # reaction of roll_y2: Q_i gains lambda_4 a_4i (I.4.1) 30:5
            c_phi2 * z5 - k * (z3 - s_phi2 * z6),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (12,), p (5,).
    Returns a scalar.
    """
    x1 = float(y[0])  # first disk [m]
    y1 = float(y[1])  # first disk [m]
    x2 = float(y[4])  # second disk [m]
    y2 = float(y[5])  # second disk [m]
    phi1_dot = float(y[8])  # phi1' [rad/s]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    phi2_dot = float(y[10])  # phi2' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    m = float(p[0])  # mass of each [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # about the axle [kg*m^2]
    J = float(p[3])  # about the vertical [kg*m^2]
    k = float(p[4])  # stiffness of the spring [N/m]
    try:
        # from the state
        z1 = x1 - x2
        z2 = y1 - y2
        v1_x1 = theta1_dot * R
        v1_x2 = theta2_dot * R
        s1 = I * (theta1_dot * theta1_dot) + m * (v1_x1 * v1_x1)
        s2 = I * (theta2_dot * theta2_dot) + m * (v1_x2 * v1_x2)
        s3 = J * (phi1_dot * phi1_dot) + s1
        z3 = s3 + (J * (phi2_dot * phi2_dot) + s2)
        value1 = 0.5 * (k * (z1 * z1 + z2 * z2) + z3)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

    Arguments: t (scalar), y (12,), p (5,).
    Returns rows (12, 12): d rhs_i / d y_j stands at [i][j].
    """
    x1 = float(y[0])  # first disk [m]
    y1 = float(y[1])  # first disk [m]
    phi1 = float(y[2])  # heading [rad]
    x2 = float(y[4])  # second disk [m]
    y2 = float(y[5])  # second disk [m]
    phi2 = float(y[6])  # heading [rad]
    theta1_dot = float(y[9])  # theta1' [rad/s]
    theta2_dot = float(y[11])  # theta2' [rad/s]
    m = float(p[0])  # mass of each [kg]
    R = float(p[1])  # radius [m]
    I = float(p[2])  # about the axle [kg*m^2]
    J_2 = float(p[3])  # J: about the vertical [kg*m^2]
    k = float(p[4])  # stiffness of the spring [N/m]
    try:
        # the mass matrix is singular, if J_2 is 0
        if not abs(J_2) > 0.0:
            raise _refuse(abs(J_2), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = I + m * (R * R)
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "jacobian")
        k2 = R * k / k1
        # from the state
        s_phi1 = math.sin(phi1)
        z1 = R * s_phi1
        c_phi1 = math.cos(phi1)
        z2 = R * c_phi1
        s_phi2 = math.sin(phi2)
        z3 = R * s_phi2
        c_phi2 = math.cos(phi2)
        z4 = R * c_phi2
        z5 = c_phi1 * k2
        z6 = s_phi1 * k2
        z7 = y1 - y2
        z8 = x1 - x2
        z9 = c_phi2 * k2
        z10 = s_phi2 * k2
        J: list[float] = [
            0.0,
            0.0,
            # (III.3)
            -theta1_dot * z1,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z2,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            theta1_dot * z2,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z1,
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
            # (III.3)
            -theta2_dot * z3,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z4,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            theta2_dot * z4,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z3,
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
            # (III.3)
            -z5,
            # (III.3)
            -z6,
            # (III.3)
            (z8 * s_phi1 - z7 * c_phi1) * k2,
            0.0,
            # (III.3)
            z5,
            # (III.3)
            z6,
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
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z9,
            # (III.3)
            z10,
            0.0,
            0.0,
            # (III.3)
            -z9,
            # (III.3)
            -z10,
            # (III.3)
            k2 * (z7 * c_phi2 - z8 * s_phi2),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 12] for k3 in range(0, 144, 12)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (12,), p (5,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
