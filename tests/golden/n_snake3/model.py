"""n_snake3, emitted by nhc 0.1.0 (nhc:16e380a70ff730ec).

Three links with a wheeled axle under the middle of each, hinged in a row with
    springs in the hinges.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: middle of the first link
y[1] = y [m]: middle of the first link
y[2] = theta1 [rad]: first link
y[3] = theta2 [rad]: second link
y[4] = theta3 [rad]: third link
y[5] = v [m/s]
y[6] = w [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: each link
p[1]: J = 0.1 [kg*m^2]: each link
p[2]: a = 0.5 [m]: half the length of a link
p[3]: k = 0.5 [N*m]: stiffness of the hinges

Constraints, with the units of their reactions:
0: wheel1 [N]
1: wheel2 [N]
2: wheel3 [N]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 42 +-, 78 *, 3 /, 6 calls
velocities: 5 +-, 11 *, 1 /, 6 calls
accelerations: 53 +-, 97 *, 3 /, 6 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 11 +-, 15 *, 0 /, 6 calls
reactions: 66 +-, 115 *, 3 /, 4 calls
energy: 13 +-, 23 *, 1 /, 4 calls
jacobian: 190 +-, 301 *, 3 /, 6 calls
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

COORDINATES: tuple[str, ...] = ("x", "y", "theta1", "theta2", "theta3")
STATE: tuple[str, ...] = ("x", "y", "theta1", "theta2", "theta3", "v", "w")
PARAMETERS: tuple[str, ...] = ("m", "J", "a", "k")
CONSTRAINTS: tuple[str, ...] = ("wheel1", "wheel2", "wheel3")
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = (1.0, 0.1, 0.5, 0.5)

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

    Arguments: t (scalar), y (7,), p (4,).
    Returns dydt (7,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "rhs")
        # from the parameters alone
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        k6 = k * k1
        # from the state
        z1 = theta1 - theta2
        c1 = math.cos(z1)
        z2 = theta2 - theta3
        c2 = math.cos(z2)
        s1 = math.sin(z1)
        s2 = math.sin(z2)
        z3 = c1 * c2 + s1 * s2
        z4 = z3 * z3 + (1.0 + c1 * c1)
        z5 = s1 * s1
        z6 = c1 * s2 - s1 * c2
        z7 = z6 * z6
        z8 = m * z4 + k3 * (z5 + z7)
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "rhs")
        z9 = z5 * k5 + J * z4 + z7 * k5
        z10 = c1 * s1
        z11 = a * z3
        z12 = z6 * z11
        z13 = z10 * k4 - (k2 * z10 - k3 * z12) - m * z12
        z14 = 1.0 / z8
        z15 = z14 * z13
        z16 = z9 - z13 * z15
        # the mass matrix is singular, if z16 is nearly 0
        if not abs(z16) > 1e-13 * z9:
            raise _refuse(abs(z16), 1e-13 * z9, 2, "rhs")
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z17 = a * w
        z18 = v * s1 - c1 * z17
        z19 = k1 * z18
        v1_x2 = v * c1 + s1 * z17
        z20 = s2 * v1_x2 - c2 * z18
        z21 = w - z19
        z22 = c1 * z21
        z23 = s1 * z21
        z24 = v * z22 + z17 * z23
        z25 = k1 * (z18 - z20)
        z26 = c2 * z25
        z27 = v * z23 - z17 * z22
        z28 = s2 * z25
        z29 = v1_x2 * z26 - s2 * z27 + (z18 * z28 - c2 * z24)
        z30 = v1_x2 * z28 + c2 * z27 - (z18 * z26 + s2 * z24)
        s3 = k3 * (s1 * z24 + z6 * z29) - m * (c1 * z27 + z3 * z30)
        z31 = s3 - k6 * (s1 * (z1 - z2) + z2 * z6)
        s4 = k4 * (s1 * z27) + (k2 * (c1 * z24) - k3 * (z29 * z11))
        z32 = s4 - k4 * (z6 * z30)
        s5 = z31 * z15 - (k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z32)
        z33 = s5 / z16
        dydt: list[float] = [
            # x' (I.2.4)
            c_theta1 * v,
            # y' (I.2.4)
            s_theta1 * v,
            # theta1' (I.2.4)
            w,
            # theta2' (I.2.4)
            z19,
            # theta3' (I.2.4)
            k1 * z20,
            # v' (I.2.15) 22:4
            -(z14 * z31 + z15 * z33),
            # w' (I.2.15) 22:4
            z33,
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

    Arguments: t (scalar), y (7,), p (4,).
    Returns qdot (5,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    a = float(p[2])  # half the length of a link [m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "velocities")
        # from the parameters alone
        k1 = 1.0 / a
        # from the state
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z1 = theta1 - theta2
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        z2 = a * w
        z3 = v * s1 - c1 * z2
        z4 = theta2 - theta3
        s2 = math.sin(z4)
        c2 = math.cos(z4)
        qdot: list[float] = [
            # x' (I.2.4)
            c_theta1 * v,
            # y' (I.2.4)
            s_theta1 * v,
            # theta1' (I.2.4)
            w,
            # theta2' (I.2.4)
            k1 * z3,
            # theta3' (I.2.4)
            k1 * (s2 * (v * c1 + s1 * z2) - c2 * z3),
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

    Arguments: t (scalar), y (7,), p (4,).
    Returns qddot (5,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "accelerations")
        # from the parameters alone
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        # from the state
        z1 = theta1 - theta2
        c1 = math.cos(z1)
        z2 = theta2 - theta3
        c2 = math.cos(z2)
        s1 = math.sin(z1)
        s2 = math.sin(z2)
        z3 = c1 * c2 + s1 * s2
        z4 = 1.0 + c1 * c1
        z5 = s1 * s1
        z6 = c1 * s2 - s1 * c2
        z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6)
        # the mass matrix is singular, if z7 is 0
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "accelerations")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z6 * z10
        z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14
        z16 = 1.0 / z7
        z17 = z16 * z15
        z18 = z12 - z15 * z17
        # the mass matrix is singular, if z18 is nearly 0
        if not abs(z18) > 1e-13 * z12:
            raise _refuse(abs(z18), 1e-13 * z12, 2, "accelerations")
        s_theta1 = math.sin(theta1)
        z19 = v * w
        c_theta1 = math.cos(theta1)
        z20 = a * w
        z21 = v * s1 - c1 * z20
        z22 = w - k1 * z21
        z23 = s1 * z22
        z24 = c1 * z22
        z25 = v * z23 - z20 * z24
        v1_x2 = v * c1 + s1 * z20
        z26 = k1 * (z21 - (s2 * v1_x2 - c2 * z21))
        z27 = s2 * z26
        z28 = c2 * z26
        z29 = v * z24 + z20 * z23
        z30 = v1_x2 * z27 + c2 * z25 - (z21 * z28 + s2 * z29)
        z31 = v1_x2 * z28 + z21 * z27
        z32 = z31 - (s2 * z25 + c2 * z29)
        s3 = m * (c1 * z25 + z3 * z30) - k3 * (s1 * z29 + z6 * z32)
        z33 = s3 + k * (k1 * (z1 * s1 - z2 * (s1 - z6)))
        s4 = k4 * (s1 * z25) + (k2 * (c1 * z29) - k3 * (z10 * z32))
        z34 = m * (z11 * z30) + s4
        s5 = k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z34 - z17 * z33
        z35 = s5 / z18
        z36 = z16 * z33 - z17 * z35
        z37 = a * z35
        z38 = z29 + (s1 * z36 + c1 * z37)
        qddot: list[float] = [
            # x'' (I.2.15)
            c_theta1 * z36 - s_theta1 * z19,
            # y'' (I.2.15)
            c_theta1 * z19 + s_theta1 * z36,
            # theta1'' (I.2.15)
            -z35,
            # theta2'' (I.2.15)
            k1 * z38,
            # theta3'' (I.2.15)
            k1 * (z31 - (s2 * (z25 - (c1 * z36 - s1 * z37)) + c2 * z38)),
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

    Arguments: t (scalar), q (5,), qdot (5,), p (4,).
    Returns y (7,).
    """
    x = float(q[0])  # middle of the first link [m]
    y_2 = float(q[1])  # y: middle of the first link [m]
    theta1 = float(q[2])  # first link [rad]
    theta2 = float(q[3])  # second link [rad]
    theta3 = float(q[4])  # third link [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta1_dot = float(qdot[2])  # theta1' [rad/s]
    try:
        # from the coordinates and velocities
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        y: list[float] = [
            x,
            y_2,
            theta1,
            theta2,
            theta3,
            x_dot * c_theta1 + y_dot * s_theta1,
            theta1_dot,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (4,).
    Returns r (3,).
    """
    theta1 = float(q[2])  # first link [rad]
    theta2 = float(q[3])  # second link [rad]
    theta3 = float(q[4])  # third link [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta1_dot = float(qdot[2])  # theta1' [rad/s]
    theta2_dot = float(qdot[3])  # theta2' [rad/s]
    theta3_dot = float(qdot[4])  # theta3' [rad/s]
    a = float(p[2])  # half the length of a link [m]
    try:
        # from the coordinates and velocities
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        s_theta2 = math.sin(theta2)
        z1 = theta1_dot * a
        z2 = theta2_dot * a
        z3 = s_theta2 * z2
        x2_dot = x_dot + s_theta1 * z1 + z3
        c_theta2 = math.cos(theta2)
        z4 = c_theta2 * z2
        y2_dot = y_dot - c_theta1 * z1 - z4
        s_theta3 = math.sin(theta3)
        z5 = theta3_dot * a
        c_theta3 = math.cos(theta3)
        s1 = s_theta3 * (z3 + x2_dot + s_theta3 * z5)
        r: list[float] = [
            # wheel1 = 0 (I.1.1) 25:5
            y_dot * c_theta1 - x_dot * s_theta1,
            # wheel2 = 0 (I.1.1) 26:5
            c_theta2 * y2_dot - s_theta2 * x2_dot,
            # wheel3 = 0 (I.1.1) 27:5
            -(s1 + c_theta3 * (z4 - y2_dot + c_theta3 * z5)),
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

    Arguments: t (scalar), y (7,), p (4,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "reactions")
        # from the parameters alone
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        k6 = m * k1
        # from the state
        z1 = theta1 - theta2
        c1 = math.cos(z1)
        z2 = theta2 - theta3
        c2 = math.cos(z2)
        s1 = math.sin(z1)
        s2 = math.sin(z2)
        z3 = c1 * c2 + s1 * s2
        z4 = 1.0 + c1 * c1
        z5 = s1 * s1
        z6 = c1 * s2 - s1 * c2
        z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6)
        # the mass matrix is singular, if z7 is 0
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "reactions")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z6 * z10
        z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14
        z16 = 1.0 / z7
        z17 = z16 * z15
        z18 = z12 - z15 * z17
        # the mass matrix is singular, if z18 is nearly 0
        if not abs(z18) > 1e-13 * z12:
            raise _refuse(abs(z18), 1e-13 * z12, 2, "reactions")
        z19 = a * w
        v1_x2 = v * c1 + s1 * z19
        z20 = v * s1 - c1 * z19
        z21 = s2 * v1_x2 - c2 * z20
        z22 = k1 * (z20 - z21)
        z23 = s2 * z22
        z24 = k1 * z20
        z25 = w - z24
        z26 = s1 * z25
        z27 = c1 * z25
        z28 = v * z26 - z19 * z27
        z29 = c2 * z22
        z30 = v * z27 + z19 * z26
        z31 = v1_x2 * z23 + c2 * z28 - (z20 * z29 + s2 * z30)
        z32 = v1_x2 * z29 - s2 * z28 + (z20 * z23 - c2 * z30)
        s3 = k3 * (s1 * z30 + z6 * z32) - m * (c1 * z28 + z3 * z31)
        z33 = s3 - k * (k1 * (z1 * s1 - z2 * (s1 - z6)))
        s4 = k2 * (c1 * z30) - k3 * (z10 * z32) + k4 * (s1 * z28)
        z34 = s4 + m * (z11 * z31)
        s5 = z34 - k * (z1 * (1.0 + c1) - z2 * (c1 + z3)) - z17 * z33
        z35 = s5 / z18
        z36 = z16 * z33 - z17 * z35
        z37 = a * z35
        z38 = c1 * z36 - s1 * z37
        z39 = s1 * z36 + c1 * z37
        z40 = m * (z31 + (c2 * z38 + s2 * z39))
        z41 = k1 * (k * z2 - k2 * (z32 - (s2 * z38 - c2 * z39)))
        z42 = s2 * z40 - c2 * z41
        z43 = z42 + k1 * (k * (z1 - z2) - k2 * (z30 - z39))
        s6 = c1 * z43 - s1 * (m * (z28 + z38) + s2 * z41 + c2 * z40)
        z44 = m * (v * w) - s6
        lambda_: list[float] = [
            # reaction of wheel1: Q_i gains lambda_1 a_1i (I.4.1) 25:5
            z44,
            # reaction of wheel2: Q_i gains lambda_2 a_2i (I.4.1) 26:5
            m * (z24 * v1_x2) + z42 + z43,
            # reaction of wheel3: Q_i gains lambda_3 a_3i (I.4.1) 27:5
            k6 * (z21 * (c2 * v1_x2 + s2 * z20)) + z41,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (7,), p (4,).
    Returns a scalar.
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # from the parameters alone
        k1 = 1.0 / a
        # from the state
        z1 = theta1 - theta2
        z2 = theta2 - theta3
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        z3 = a * w
        z4 = v * s1 - c1 * z3
        z5 = k1 * z4
        s2 = math.sin(z2)
        v1_x2 = v * c1 + s1 * z3
        c2 = math.cos(z2)
        z6 = k1 * (s2 * v1_x2 - c2 * z4)
        v1_x3 = c2 * v1_x2 + s2 * z4
        s3 = m * (v * v + v1_x2 * v1_x2 + v1_x3 * v1_x3)
        z7 = J * (w * w + z5 * z5 + z6 * z6) + s3
        value1 = 0.5 * (k * (z1 * z1 + z2 * z2) + z7)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (7,), p (4,).
    Returns rows (7, 7): d rhs_i / d y_j stands at [i][j].
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])  # [m/s]
    w = float(y[6])  # [rad/s]
    m = float(p[0])  # each link [kg]
    J_2 = float(p[1])  # J: each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "jacobian")
        # from the parameters alone
        k1 = 1.0 / a
        k2 = J_2 * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        k6 = k2 - k4
        k7 = k * k1
        # from the state
        z1 = theta1 - theta2
        c1 = math.cos(z1)
        z2 = theta2 - theta3
        c2 = math.cos(z2)
        s1 = math.sin(z1)
        s2 = math.sin(z2)
        z3 = c1 * c2 + s1 * s2
        z4 = 1.0 + c1 * c1
        z5 = s1 * s1
        z6 = c1 * s2 - s1 * c2
        z7 = m * (z3 * z3 + z4) + k3 * (z5 + z6 * z6)
        # the mass matrix is singular, if z7 is 0
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "jacobian")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J_2 * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z6 * z10
        z15 = k2 * z13 - k3 * z14 - z13 * k4 + m * z14
        z16 = 1.0 / z7
        z17 = z16 * z15
        z18 = z12 - z15 * z17
        # the mass matrix is singular, if z18 is nearly 0
        if not abs(z18) > 1e-13 * z12:
            raise _refuse(abs(z18), 1e-13 * z12, 2, "jacobian")
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        z19 = a * w
        v1_x2 = v * c1 + s1 * z19
        z20 = k1 * v1_x2
        z21 = s1 * k1
        z22 = v * s1 - c1 * z19
        z23 = k1 * (c2 * v1_x2 + s2 * z22)
        z24 = k1 * (z22 - (s2 * v1_x2 - c2 * z22))
        z25 = c2 * z24
        z26 = m * z3
        z27 = s2 * z24
        z28 = z6 * k3
        z29 = z22 * z26 + v1_x2 * z28
        z30 = v1_x2 * z26 - z22 * z28
        z31 = k1 * (c2 * z29 - s2 * z30)
        z32 = m * c1 + c2 * z26 + s2 * z28
        z33 = c2 * z28 - (s1 * k3 + s2 * z26)
        z34 = z19 * z32 - v * z33
        z35 = z19 * z33 + v * z32
        z36 = c1 * z34 - s1 * z35
        z37 = z25 * z26 + z27 * z28 + z31 + c2 * z31 - k1 * z36
        z38 = z27 * z26 - z25 * z28 + s2 * z31
        z39 = w - k1 * z22
        z40 = c1 * z39
        z41 = s1 * z39
        z42 = v * z40 + z19 * z41
        z43 = z2 * k7
        z44 = 1.0 / z18
        z45 = v * z41 - z19 * z40
        z46 = v1_x2 * z25 - s2 * z45 + (z22 * z27 - c2 * z42)
        z47 = v1_x2 * z27 + c2 * z45 - (z22 * z25 + s2 * z42)
        z48 = k1 * (s1 - z6)
        s3 = k3 * (s1 * z42 + z6 * z46) - m * (c1 * z45 + z3 * z47)
        z49 = s3 - k * (z1 * z21 - z2 * z48)
        z50 = 1.0 + c1
        z51 = c1 + z3
        z52 = c1 * k2
        z53 = z10 * k3
        z54 = s1 * k4
        z55 = m * z11
        s4 = z42 * z52 - z46 * z53 + z45 * z54 + z47 * z55
        z56 = k * (z1 * z50 - z2 * z51) - s4
        z57 = z44 * (z49 * z17 + z56)
        z58 = k6 * z57
        z59 = z49 * z16 + z17 * z57
        z60 = k3 * z59
        s5 = z39 * z35 - (z42 * k3 + z43 + c1 * z58 - 2.0 * (s1 * z60))
        z61 = z19 * z38 + s5
        z62 = m * z57
        z63 = z3 * z62
        z64 = k3 * z57
        z65 = z6 * z64
        z66 = m * z47
        z67 = z11 * z62
        z68 = m * z59
        z69 = z3 * z68
        z70 = z66 + z67 + 2.0 * z69
        s6 = z1 * k7 - (v * z37 - z61 - a * (c2 * z63 + s2 * z65))
        z71 = s6 + s2 * z70
        z72 = z46 * k3 - z43
        z73 = z10 * z64
        z74 = z6 * z60
        z75 = z72 - (z73 + 2.0 * z74)
        s7 = z39 * z34 - (m * z45 - s1 * z58 + 2.0 * (c1 * z68))
        z76 = v * z38 + (z19 * z37 - s7)
        s8 = s1 * (z76 - a * (s2 * z63 - c2 * z65) + c2 * z70 - s2 * z75)
        z77 = k * z21 + c1 * (z71 + c2 * z75) - s8
        z78 = z22 * z55 + v1_x2 * z53
        z79 = v1_x2 * z55 - z22 * z53
        z80 = k1 * (c2 * z78 - s2 * z79)
        z81 = z54 + c2 * z55 + s2 * z53
        z82 = z52 - s2 * z55 + c2 * z53
        z83 = z19 * z81 - v * z82
        z84 = z19 * z82 + v * z81
        z85 = c1 * z83 - s1 * z84
        z86 = z25 * z55 + z27 * z53 + z80 + c2 * z80 - k1 * z85
        z87 = z27 * z55 - z25 * z53 + s2 * z80
        z88 = k6 * z59
        s9 = z39 * z84 + (z45 * k4 - c1 * z88 + 2.0 * (k5 * (s1 * z57)))
        z89 = z19 * z87 + s9
        z90 = z69 + (z66 + 2.0 * z67)
        z91 = z72 - (2.0 * z73 + z74)
        z92 = z11 * z68
        z93 = z10 * z60
        s10 = v * z86 - z89 - a * (c2 * z90 - s2 * z91) - s2 * z92
        z94 = s10 + c2 * z93
        s11 = k * (z1 - z2) - z42 * k2 + s1 * z88
        z95 = z39 * z83 + (s11 - 2.0 * (J_2 * (c1 * z57)))
        s12 = v * z87 + (z19 * z86 - z95) - a * (s2 * z90 + c2 * z91)
        z96 = s12 + c2 * z92
        z97 = k * z50 + c1 * z94 + s1 * (z96 + s2 * z93)
        z98 = z44 * (z97 - z17 * z77)
        s13 = v1_x2 * z31 - (z42 * z26 - z45 * z28 - z24 * z30 + z9 * z63)
        z99 = s13 + z8 * z65
        s14 = z22 * z31 - (z45 * z26 + z42 * z28 - z24 * z29 + z8 * z63)
        z100 = s14 - z9 * z65
        s15 = k * z48 - c2 * (z99 + s1 * z70 - c1 * z75)
        z101 = s15 - s2 * (z100 - c1 * z70 - s1 * z75)
        z102 = z77 + z101
        s16 = v1_x2 * z80 - (z42 * z55 - z45 * z53 - z24 * z79 + z9 * z90)
        z103 = s16 - z8 * z91
        s17 = z22 * z80 - (z45 * z55 + z42 * z53 - z24 * z78 + z8 * z90)
        z104 = s17 + z9 * z91
        s18 = k * z51 + c2 * (z103 + s1 * z92 + c1 * z93)
        z105 = s18 + s2 * (z104 - c1 * z92 + s1 * z93)
        z106 = z44 * (z97 + z105 - z17 * z102)
        z107 = z44 * (z105 - z17 * z101)
        z108 = z40 * z33 + z41 * z32 - s1 * z37 + c1 * z38
        s19 = z40 * z82 + z41 * z81 - s1 * z86 + c1 * z87 + z17 * z108
        z109 = z44 * s19
        z110 = z36 + a * (z40 * z32 - z41 * z33 - s1 * z38 - c1 * z37)
        s20 = z85 + a * (z40 * z81 - z41 * z82 - s1 * z87 - c1 * z86)
        z111 = s20 + z17 * z110
        z112 = z44 * z111
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_theta1 * v,
            0.0,
            0.0,
            # (I.2.15)
            c_theta1,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_theta1 * v,
            0.0,
            0.0,
            # (I.2.15)
            s_theta1,
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
            z20,
            # (I.2.15)
            -z20,
            0.0,
            # (I.2.15)
            z21,
            # (I.2.15)
            -c1,
            0.0,
            0.0,
            # (I.2.15)
            -z23,
            # (I.2.15)
            2.0 * z23,
            # (I.2.15)
            -z23,
            # (I.2.15)
            k1 * z6,
            # (I.2.15)
            z3,
            0.0,
            0.0,
            # (I.2.15)
            z16 * z77 - z17 * z98,
            # (I.2.15)
            z17 * z106 - z16 * z102,
            # (I.2.15)
            z16 * z101 - z17 * z107,
            # (I.2.15)
            z16 * z108 + z17 * z109,
            # (I.2.15)
            -(z16 * z110 + z17 * z112),
            0.0,
            0.0,
            # (I.2.15)
            -z98,
            # (I.2.15)
            z106,
            # (I.2.15)
            -z107,
            # (I.2.15)
            z109,
            # (I.2.15)
            -z112,
        ]
        _finish("jacobian", J)
        return [J[k8 : k8 + 7] for k8 in range(0, 49, 7)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (7,), p (4,).
    Returns out (0,).
    """
    a = float(p[2])  # half the length of a link [m]
    try:
        # the coframe is singular, if a is 0
        if not abs(a) > 0.0:
            raise _refuse(abs(a), 0.0, 1, "outputs")
        # from the state
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
