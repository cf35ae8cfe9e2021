"""n_trailer3, emitted by nhc 0.1.0 (nhc:6a3caa6bf6794c7e).

A tractor with three trailers, each hitched to the axle before it; none of the four
    axles slips sideways.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: axle of the tractor
y[1] = y [m]: axle of the tractor
y[2] = theta0 [rad]: heading of the tractor
y[3] = theta1 [rad]: first trailer
y[4] = theta2 [rad]: second trailer
y[5] = theta3 [rad]: third trailer
y[6] = v [m/s]
y[7] = w [rad/s]

Parameters p:
p[0]: m0 = 1.0 [kg]: tractor
p[1]: J0 = 0.1 [kg*m^2]: tractor
p[2]: m = 0.5 [kg]: each trailer
p[3]: J = 0.05 [kg*m^2]: each trailer
p[4]: L = 0.8 [m]: from axle to axle

Constraints, with the units of their reactions:
0: axle0 [N]
1: axle1 [N]
2: axle2 [N]
3: axle3 [N]

Outputs:
out[0] = tail_x [m]
out[1] = tail_y [m]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 17 +-, 31 *, 2 /, 8 calls
velocities: 3 +-, 8 *, 1 /, 7 calls
accelerations: 24 +-, 47 *, 2 /, 8 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 10 +-, 17 *, 0 /, 8 calls
reactions: 38 +-, 75 *, 2 /, 6 calls
energy: 9 +-, 14 *, 1 /, 3 calls
jacobian: 66 +-, 138 *, 2 /, 8 calls
outputs: 6 +-, 2 *, 0 /, 6 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "theta0", "theta1", "theta2", "theta3")
STATE: tuple[str, ...] = ("x", "y", "theta0", "theta1", "theta2", "theta3", "v", "w")
PARAMETERS: tuple[str, ...] = ("m0", "J0", "m", "J", "L")
CONSTRAINTS: tuple[str, ...] = ("axle0", "axle1", "axle2", "axle3")
OUTPUTS: tuple[str, ...] = ("tail_x", "tail_y")
DEFAULTS: tuple[float, ...] = (1.0, 0.1, 0.5, 0.05, 0.8)

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

    Arguments: t (scalar), y (8,), p (5,).
    Returns dydt (8,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the mass matrix is singular, if J0 is 0
        if not abs(J0) > 0.0:
            raise _refuse(abs(J0), 0.0, 2, "rhs")
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "rhs")
        # from the parameters alone
        k1 = 1.0 / L
        k2 = k1 * (J * k1)
        # from the state
        z1 = theta2 - theta3
        s1 = math.sin(z1)
        z2 = theta0 - theta1
        c1 = math.cos(z2)
        z3 = theta1 - theta2
        c2 = math.cos(z3)
        z4 = c1 * c2
        z5 = s1 * z4
        s2 = math.sin(z2)
        s3 = math.sin(z3)
        z6 = c1 * s3
        c3 = math.cos(z1)
        z7 = c3 * z4
        s4 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6))
        z8 = s4 + m * (z7 * z7 + (c1 * c1 + z4 * z4))
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "rhs")
        c_theta0 = math.cos(theta0)
        s_theta0 = math.sin(theta0)
        z9 = v * k1
        z10 = s2 * z9
        z11 = z6 * z9
        z12 = z5 * z9
        z13 = s2 * (w - z10)
        z14 = c2 * z13 + (s2 - z6) * z11
        z15 = z7 * ((z6 - z5) * z12 + c3 * z14)
        dydt: list[float] = [
            # x' (I.2.4)
            c_theta0 * v,
            # y' (I.2.4)
            s_theta0 * v,
            # theta0' (I.2.4)
            w,
            # theta1' (I.2.4)
            z10,
            # theta2' (I.2.4)
            z11,
            # theta3' (I.2.4)
            z12,
            # v' (I.2.15) 30:4
            (m * (z15 + (c1 * z13 + z4 * z14)) - k2 * z15) * (v / z8),
            # w' (I.2.15) 30:4
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
    """All velocities q' from the state (I.2.4).

    Arguments: t (scalar), y (8,), p (5,).
    Returns qdot (6,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "velocities")
        # from the parameters alone
        k1 = 1.0 / L
        # from the state
        c_theta0 = math.cos(theta0)
        s_theta0 = math.sin(theta0)
        z1 = theta0 - theta1
        s1 = math.sin(z1)
        z2 = v * k1
        z3 = theta1 - theta2
        s2 = math.sin(z3)
        c1 = math.cos(z1)
        z4 = c1 * z2
        s3 = math.sin(theta2 - theta3)
        c2 = math.cos(z3)
        qdot: list[float] = [
            # x' (I.2.4)
            c_theta0 * v,
            # y' (I.2.4)
            s_theta0 * v,
            # theta0' (I.2.4)
            w,
            # theta1' (I.2.4)
            s1 * z2,
            # theta2' (I.2.4)
            s2 * z4,
            # theta3' (I.2.4)
            s3 * (c2 * z4),
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
    Returns qddot (6,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the mass matrix is singular, if J0 is 0
        if not abs(J0) > 0.0:
            raise _refuse(abs(J0), 0.0, 2, "accelerations")
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "accelerations")
        # from the parameters alone
        k1 = 1.0 / L
        k2 = k1 * (J * k1)
        # from the state
        z1 = theta2 - theta3
        s1 = math.sin(z1)
        z2 = theta0 - theta1
        c1 = math.cos(z2)
        z3 = theta1 - theta2
        c2 = math.cos(z3)
        z4 = c1 * c2
        z5 = s1 * z4
        s2 = math.sin(z2)
        s3 = math.sin(z3)
        z6 = c1 * s3
        c3 = math.cos(z1)
        z7 = c3 * z4
        s4 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6))
        z8 = s4 + m * (z7 * z7 + (c1 * c1 + z4 * z4))
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "accelerations")
        s_theta0 = math.sin(theta0)
        z9 = v * w
        c_theta0 = math.cos(theta0)
        z10 = v * k1
        z11 = (z6 - z5) * z10
        z12 = s2 * k1
        z13 = w - v * z12
        z14 = s2 * z13
        z15 = (s2 - z6) * z10
        z16 = c2 * z14 + z6 * z15
        z17 = z7 * (z5 * z11 + c3 * z16)
        z18 = c1 * z13
        z19 = v / z8 * (k2 * z17 - m * (z17 + (s2 * z18 + z4 * z16)))
        z20 = k1 * z19
        qddot: list[float] = [
            # x'' (I.2.15)
            -(s_theta0 * z9 + c_theta0 * z19),
            # y'' (I.2.15)
            c_theta0 * z9 - s_theta0 * z19,
            # theta0'' (I.2.15)
            0.0,
            # theta1'' (I.2.15)
            z18 * z10 - z12 * z19,
            # theta2'' (I.2.15)
            -(z10 * (s3 * z14 - z4 * z15) + z6 * z20),
            # theta3'' (I.2.15)
            z10 * (z7 * z11 - s1 * z16) - z5 * z20,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (5,).
    Returns y (8,).
    """
    x = float(q[0])  # axle of the tractor [m]
    y_2 = float(q[1])  # y: axle of the tractor [m]
    theta0 = float(q[2])  # heading of the tractor [rad]
    theta1 = float(q[3])  # first trailer [rad]
    theta2 = float(q[4])  # second trailer [rad]
    theta3 = float(q[5])  # third trailer [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta0_dot = float(qdot[2])  # theta0' [rad/s]
    try:
        # from the coordinates and velocities
        c_theta0 = math.cos(theta0)
        s_theta0 = math.sin(theta0)
        y: list[float] = [
            x,
            y_2,
            theta0,
            theta1,
            theta2,
            theta3,
            x_dot * c_theta0 + y_dot * s_theta0,
            theta0_dot,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (5,).
    Returns r (4,).
    """
    theta0 = float(q[2])  # heading of the tractor [rad]
    theta1 = float(q[3])  # first trailer [rad]
    theta2 = float(q[4])  # second trailer [rad]
    theta3 = float(q[5])  # third trailer [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta1_dot = float(qdot[3])  # theta1' [rad/s]
    theta2_dot = float(qdot[4])  # theta2' [rad/s]
    theta3_dot = float(qdot[5])  # theta3' [rad/s]
    L = float(p[4])  # from axle to axle [m]
    try:
        # from the coordinates and velocities
        s_theta0 = math.sin(theta0)
        c_theta0 = math.cos(theta0)
        s_theta1 = math.sin(theta1)
        z1 = theta1_dot * L
        x1_dot = x_dot + s_theta1 * z1
        c_theta1 = math.cos(theta1)
        y1_dot = y_dot - c_theta1 * z1
        s_theta2 = math.sin(theta2)
        z2 = theta2_dot * L
        x2_dot = x1_dot + s_theta2 * z2
        c_theta2 = math.cos(theta2)
        y2_dot = y1_dot - c_theta2 * z2
        s_theta3 = math.sin(theta3)
        z3 = theta3_dot * L
        c_theta3 = math.cos(theta3)
        s1 = c_theta3 * (y2_dot - c_theta3 * z3)
        r: list[float] = [
            # axle0 = 0 (I.1.1) 32:5
            y_dot * c_theta0 - x_dot * s_theta0,
            # axle1 = 0 (I.1.1) 33:5
            c_theta1 * y1_dot - s_theta1 * x1_dot,
            # axle2 = 0 (I.1.1) 34:5
            c_theta2 * y2_dot - s_theta2 * x2_dot,
            # axle3 = 0 (I.1.1) 35:5
            s1 - s_theta3 * (x2_dot + s_theta3 * z3),
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
    Returns lambda_ (4,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the mass matrix is singular, if J0 is 0
        if not abs(J0) > 0.0:
            raise _refuse(abs(J0), 0.0, 2, "reactions")
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "reactions")
        # from the parameters alone
        k1 = 1.0 / L
        k2 = J * k1
        k3 = k1 * k2
        # from the state
        z1 = theta2 - theta3
        s1 = math.sin(z1)
        z2 = theta0 - theta1
        c1 = math.cos(z2)
        z3 = theta1 - theta2
        c2 = math.cos(z3)
        z4 = c1 * c2
        z5 = s1 * z4
        s2 = math.sin(z2)
        s3 = math.sin(z3)
        z6 = c1 * s3
        c3 = math.cos(z1)
        z7 = c3 * z4
        s4 = m0 + k3 * (z5 * z5 + (s2 * s2 + z6 * z6))
        z8 = s4 + m * (z7 * z7 + (c1 * c1 + z4 * z4))
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "reactions")
        z9 = s2 * k1
        z10 = v * z9
        z11 = w - z10
        z12 = c1 * z11
        z13 = v * k1
        z14 = (z6 - z5) * z13
        z15 = s2 * z11
        z16 = (s2 - z6) * z13
        z17 = c2 * z15 + z6 * z16
        z18 = z5 * z14 + c3 * z17
        z19 = z7 * z18
        z20 = v / z8 * (k3 * z19 - m * (z19 + (s2 * z12 + z4 * z17)))
        z21 = k2 * (z12 * z13 - z9 * z20)
        z22 = k1 * z6
        z23 = k2 * (z13 * (s3 * z15 - z4 * z16) + z22 * z20)
        z24 = k1 * z5
        z25 = k2 * (z13 * (z7 * z14 - s1 * z17) - z24 * z20)
        z26 = m * (v * z18 + z7 * z20)
        z27 = m * (v * z17 + z4 * z20) - s1 * z25 + c3 * z26
        s5 = s2 * (m * (v * z15 + c1 * z20) + s3 * z23 + c2 * z27)
        z28 = m0 * (v * w) + c1 * z21 + s5
        z29 = m * v
        z30 = v * z29
        lambda_: list[float] = [
            # reaction of axle0: Q_i gains lambda_1 a_1i (I.4.1) 32:5
            z28,
            # reaction of axle1: Q_i gains lambda_2 a_2i (I.4.1) 33:5
            z10 * (c1 * z29) - z21 - c2 * z23 + s3 * z27,
            # reaction of axle2: Q_i gains lambda_3 a_3i (I.4.1) 34:5
            z4 * (z22 * z30) + z23 + c3 * z25 + s1 * z26,
            # reaction of axle3: Q_i gains lambda_4 a_4i (I.4.1) 35:5
            z7 * (z24 * z30) - z25,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (8,), p (5,).
    Returns a scalar.
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # from the parameters alone
        k1 = J / (L * L)
        k2 = m0 + k1
        # from the state
        c1 = math.cos(theta0 - theta1)
        c2 = math.cos(theta1 - theta2)
        z1 = c2 * c2
        c3 = math.cos(theta2 - theta3)
        z2 = c3 * c3
        s1 = c1 * c1 * (m * (1.0 + z1 * (1.0 + z2)) - k1 * (z1 * z2))
        z3 = (k2 + s1) * v * v
        value1 = 0.5 * (J0 * (w * w) + z3)
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
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])  # [m/s]
    w = float(y[7])  # [rad/s]
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J_2 = float(p[3])  # J: each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the mass matrix is singular, if J0 is 0
        if not abs(J0) > 0.0:
            raise _refuse(abs(J0), 0.0, 2, "jacobian")
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "jacobian")
        # from the parameters alone
        k1 = 1.0 / L
        k2 = k1 * (J_2 * k1)
        # from the state
        z1 = theta2 - theta3
        s1 = math.sin(z1)
        z2 = theta0 - theta1
        c1 = math.cos(z2)
        z3 = theta1 - theta2
        c2 = math.cos(z3)
        z4 = c1 * c2
        z5 = s1 * z4
        s2 = math.sin(z2)
        s3 = math.sin(z3)
        z6 = c1 * s3
        c3 = math.cos(z1)
        z7 = c3 * z4
        s4 = m0 + k2 * (z5 * z5 + (s2 * s2 + z6 * z6))
        z8 = s4 + m * (z7 * z7 + (c1 * c1 + z4 * z4))
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "jacobian")
        s_theta0 = math.sin(theta0)
        c_theta0 = math.cos(theta0)
        z9 = v * k1
        z10 = c1 * z9
        z11 = s2 * k1
        z12 = z9 * (s2 * s3)
        z13 = c2 * z10
        z14 = s2 * c2
        z15 = s1 * z9
        z16 = c3 * z13
        z17 = 1.0 / z8
        z18 = v * k2
        z19 = s2 * z18
        z20 = m * v
        z21 = z7 * z20
        z22 = z5 * z18
        z23 = z4 * z20 + c3 * z21 + s1 * z22
        z24 = z6 * z18
        z25 = c1 * z20 + c2 * z23 + s3 * z24
        z26 = c1 * z19 - s2 * z25
        z27 = w - v * z11
        z28 = c1 * z24
        z29 = c1 * z23
        z30 = c2 * z28 - s3 * z29
        z31 = z9 * z30
        z32 = c1 * z27
        z33 = k1 * (z6 - z5)
        z34 = v * z33
        z35 = s1 * z34
        z36 = s2 * z27
        z37 = k1 * (s2 - z6)
        z38 = v * z37
        z39 = s3 * z38
        z40 = c2 * z36 + c1 * z39
        z41 = z4 * z35 + c3 * z40
        z42 = z7 * z41
        z43 = k2 * z42 - m * (z42 + (s2 * z32 + z4 * z40))
        z44 = z43 * (v * z17)
        z45 = k2 * z44
        z46 = c2 * z38
        z47 = m * z44
        z48 = c3 * z34
        z49 = z41 * z20 + 2.0 * (z7 * z47)
        z50 = z4 * z22
        z51 = z4 * z21
        z52 = c3 * z50 - s1 * z51
        z53 = z9 * z52
        z54 = z53 - ((z4 * z48 - s1 * z40) * z18 - 2.0 * (z5 * z45))
        s5 = z48 * z22 - (z35 * z21 + (z40 * z20 + 2.0 * (z4 * z47)))
        z55 = s5 - c3 * z49 - s1 * z54
        s6 = z46 * z24 - (z39 * z23 + (z36 * z20 + 2.0 * (c1 * z47)))
        z56 = z27 * z19 + s6 + c2 * z55
        z57 = z31 - (z53 - ((s3 * z36 - c1 * z46) * z18 + 2.0 * (z6 * z45)))
        s7 = z27 * z25 - (z31 + (z32 * z18 - 2.0 * (s2 * z45)))
        z58 = c1 * (z9 * z26 + s7) + s2 * (z56 - s3 * z57)
        s8 = c2 * (z36 * z24 + z38 * z29 + c1 * z57)
        z59 = s8 - s3 * (z36 * z23 - z38 * z28 - c1 * z55)
        s9 = c3 * (z40 * z22 + z34 * z51 + z4 * z54)
        z60 = s9 - s1 * (z40 * z21 - z34 * z50 + z4 * z49)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_theta0 * v,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta0 * v,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_theta0,
            0.0,
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
            # (I.2.15)
            z10,
            # (I.2.15)
            -z10,
            0.0,
            0.0,
            # (I.2.15)
            z11,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z12,
            # (I.2.15)
            z13 + z12,
            # (I.2.15)
            -z13,
            0.0,
            # (I.2.15)
            k1 * z6,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z14 * z15,
            # (I.2.15)
            (z14 - z6) * z15,
            # (I.2.15)
            z16 + z6 * z15,
            # (I.2.15)
            -z16,
            # (I.2.15)
            k1 * z5,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z17 * z58,
            # (I.2.15)
            (z59 - z58) * z17,
            # (I.2.15)
            (z60 - z59) * z17,
            # (I.2.15)
            -z17 * z60,
            # (I.2.15)
            z17 * (z11 * z26 - (z37 * z30 + (z43 + z33 * z52))),
            # (I.2.15)
            -z17 * z26,
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
        return [J[k3 : k3 + 8] for k3 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (8,), p (5,).
    Returns out (2,).
    """
    x = float(y[0])  # axle of the tractor [m]
    y_2 = float(y[1])  # y: axle of the tractor [m]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    L = float(p[4])  # from axle to axle [m]
    try:
        # the coframe is singular, if L is 0
        if not abs(L) > 0.0:
            raise _refuse(abs(L), 0.0, 1, "outputs")
        # from the state
        c_theta3 = math.cos(theta3)
        c_theta1 = math.cos(theta1)
        c_theta2 = math.cos(theta2)
        s_theta3 = math.sin(theta3)
        s_theta1 = math.sin(theta1)
        s_theta2 = math.sin(theta2)
        out: list[float] = [
            # tail_x 40:11
            x - L * (c_theta3 + (c_theta1 + c_theta2)),
            # tail_y 41:11
            y_2 - L * (s_theta3 + (s_theta1 + s_theta2)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
