"""n_snake3, emitted by nhc 0.1.0 (nhc:780eacfce3a96c42).

Three links with a wheeled axle under the middle of each, hinged in a row with
    springs in the hinges.
Source: n_snake3.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: middle of the first link
y[1] = y [m]: middle of the first link
y[2] = theta1 [rad]: first link
y[3] = theta2 [rad]: second link
y[4] = theta3 [rad]: third link
y[5] = v
y[6] = w

Parameters p:
p[0]: m = 1.0 [kg]: each link
p[1]: J = 0.1 [kg*m^2]: each link
p[2]: a = 0.5 [m]: half the length of a link
p[3]: k = 0.5 [N*m]: stiffness of the hinges

Constraints:
0: wheel1
1: wheel2
2: wheel3

Operations:
rhs: 45 +-, 86 *, 3 /, 6 calls
velocities: 5 +-, 11 *, 1 /, 6 calls
accelerations: 56 +-, 97 *, 3 /, 6 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 11 +-, 15 *, 0 /, 6 calls
reactions: 66 +-, 118 *, 3 /, 4 calls
energy: 27 +-, 40 *, 1 /, 6 calls
jacobian: 191 +-, 301 *, 3 /, 6 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
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


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (7,), p (4,).
    Returns dydt (7,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "rhs")
        # parameters only
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        # state
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
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise SingularModelError(2, "rhs")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z10 * k3
        z15 = m * z11
        z16 = z13 * k4 - (k2 * z13 - z6 * z14) + z3 * z15
        z17 = 1.0 / z7
        z18 = z17 * z16
        z19 = z12 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z12:
            raise SingularModelError(2, "rhs")
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z20 = a * w
        z21 = v * s1 - c1 * z20
        z22 = k1 * z21
        v1_x2 = v * c1 + s1 * z20
        z23 = s2 * v1_x2 - c2 * z21
        z24 = w - z22
        z25 = c1 * z24
        z26 = s1 * z24
        z27 = v * z25 + z20 * z26
        z28 = k1 * (z21 - z23)
        z29 = c2 * z28
        z30 = v * z26 - z20 * z25
        z31 = s2 * z28
        z32 = v1_x2 * z29 - s2 * z30 + (z21 * z31 - c2 * z27)
        z33 = v1_x2 * z31 + c2 * z30 - (z21 * z29 + s2 * z27)
        s3 = k3 * (s1 * z27 + z6 * z32) - m * (c1 * z30 + z3 * z33)
        z34 = s3 - k * (k1 * (z1 * s1 - z2 * (s1 - z6)))
        s4 = k4 * (s1 * z30) + (k2 * (c1 * z27) - z32 * z14) + z33 * z15
        z35 = k * (z1 * (1.0 + c1) - z2 * (c1 + k1 * z10)) - s4
        z36 = (z35 - z34 * z18) / z19
        dydt: list[float] = [
            # x' (I.2.15)
            c_theta1 * v,
            # y' (I.2.15)
            s_theta1 * v,
            # theta1' (I.2.15)
            w,
            # theta2' (I.2.15)
            z22,
            # theta3' (I.2.15)
            k1 * z23,
            # v' (I.2.15) 22:4
            z18 * z36 - z17 * z34,
            # w' (I.2.15) 22:4
            -z36,
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

    Arguments: t (scalar), y (7,), p (4,).
    Returns qdot (5,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    a = float(p[2])  # half the length of a link [m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "velocities")
        # parameters only
        k1 = 1.0 / a
        # state
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
    """all accelerations q'' on the motion (I.2.15)

    Arguments: t (scalar), y (7,), p (4,).
    Returns qddot (5,).
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "accelerations")
        # parameters only
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        # state
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
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise SingularModelError(2, "accelerations")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z10 * k3
        z15 = m * z11
        z16 = z13 * k4 - (k2 * z13 - z6 * z14) + z3 * z15
        z17 = 1.0 / z7
        z18 = z17 * z16
        z19 = z12 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z12:
            raise SingularModelError(2, "accelerations")
        s_theta1 = math.sin(theta1)
        z20 = v * w
        c_theta1 = math.cos(theta1)
        z21 = a * w
        z22 = v * s1 - c1 * z21
        z23 = w - k1 * z22
        z24 = c1 * z23
        z25 = v * z24
        z26 = s1 * z23
        z27 = z21 * z26
        z28 = z25 + z27
        v1_x2 = v * c1 + s1 * z21
        z29 = k1 * (z22 - (s2 * v1_x2 - c2 * z22))
        z30 = c2 * z29
        z31 = v1_x2 * z30
        z32 = v * z26
        z33 = z21 * z24
        z34 = z32 - z33
        z35 = s2 * z29
        z36 = z22 * z35
        z37 = z31 - s2 * z34 + (z36 - c2 * z28)
        z38 = v1_x2 * z35 + c2 * z34 - (z22 * z30 + s2 * z28)
        s3 = k3 * (s1 * z28 + z6 * z37) - m * (c1 * z34 + z3 * z38)
        z39 = s3 - k * (k1 * (z1 * s1 - z2 * (s1 - z6)))
        s4 = k4 * (s1 * z34) + (k2 * (c1 * z28) - z37 * z14) + z38 * z15
        z40 = k * (z1 * (1.0 + c1) - z2 * (c1 + k1 * z10)) - s4
        z41 = (z40 - z39 * z18) / z19
        z42 = z17 * z39 - z18 * z41
        z43 = a * z41
        z44 = z25 - s1 * z42 + (z27 + c1 * z43)
        s5 = z31 - s2 * (z32 + c1 * z42 - (z33 - s1 * z43))
        z45 = k1 * (s5 + (z36 - c2 * z44))
        qddot: list[float] = [
            # x'' (I.2.15)
            -(s_theta1 * z20 + c_theta1 * z42),
            # y'' (I.2.15)
            c_theta1 * z20 - s_theta1 * z42,
            # theta1'' (I.2.15)
            -z41,
            # theta2'' (I.2.15)
            k1 * z44,
            # theta3'' (I.2.15)
            z45,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (4,).
    Returns y (7,).
    """
    x = float(q[0])  # middle of the first link [m]
    y_2 = float(q[1])  # middle of the first link [m]
    theta1 = float(q[2])  # first link [rad]
    theta2 = float(q[3])  # second link [rad]
    theta3 = float(q[4])  # third link [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta1_dot = float(qdot[2])
    try:
        # state
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
    """left sides of the constraints, zero on every motion (I.1.1)

    Arguments: t (scalar), q (5,), qdot (5,), p (4,).
    Returns r (3,).
    """
    theta1 = float(q[2])  # first link [rad]
    theta2 = float(q[3])  # second link [rad]
    theta3 = float(q[4])  # third link [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta1_dot = float(qdot[2])
    theta2_dot = float(qdot[3])
    theta3_dot = float(qdot[4])
    a = float(p[2])  # half the length of a link [m]
    try:
        # state
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
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (7,), p (4,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "reactions")
        # parameters only
        k1 = 1.0 / a
        k2 = J * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        k6 = m * k1
        # state
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
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise SingularModelError(2, "reactions")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z10 * k3
        z15 = m * z11
        z16 = z13 * k4 - (k2 * z13 - z6 * z14) + z3 * z15
        z17 = 1.0 / z7
        z18 = z17 * z16
        z19 = z12 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z12:
            raise SingularModelError(2, "reactions")
        z20 = a * w
        v1_x2 = v * c1 + s1 * z20
        z21 = v * s1 - c1 * z20
        z22 = s2 * v1_x2 - c2 * z21
        z23 = k1 * (z21 - z22)
        z24 = s2 * z23
        z25 = k1 * z21
        z26 = w - z25
        z27 = s1 * z26
        z28 = c1 * z26
        z29 = v * z27 - z20 * z28
        z30 = c2 * z23
        z31 = v * z28 + z20 * z27
        z32 = v1_x2 * z24 + c2 * z29 - (z21 * z30 + s2 * z31)
        z33 = v1_x2 * z30 - s2 * z29 + (z21 * z24 - c2 * z31)
        z34 = s1 * k1
        s3 = k3 * (s1 * z31 + z6 * z33) - m * (c1 * z29 + z3 * z32)
        z35 = s3 - k * (z1 * z34 - k1 * (z2 * (s1 - z6)))
        z36 = k1 * z10
        s4 = k4 * (s1 * z29) + (k2 * (c1 * z31) - z33 * z14) + z32 * z15
        z37 = k * (z1 * (1.0 + c1) - z2 * (c1 + z36)) - s4
        z38 = (z37 - z18 * z35) / z19
        z39 = z17 * z35 - z18 * z38
        z40 = m * (z32 + (z3 * z39 + z11 * z38))
        z41 = k1 * (k * z2 - J * (k1 * z33 - (k1 * (z6 * z39) + z36 * z38)))
        z42 = s2 * z40 - c2 * z41
        s5 = k1 * (k * (z1 - z2) - J * (k1 * z31 - (z34 * z39 - c1 * z38)))
        z43 = z42 + s5
        s6 = s1 * (m * (z29 + (c1 * z39 + z8 * z38)) + s2 * z41 + c2 * z40)
        z44 = c1 * z43 - s6
        lambda_: list[float] = [
            # reaction of wheel1: Q_i gains lambda_1 a_1i (I.4.1) 25:5
            m * (v * w) - z44,
            # reaction of wheel2: Q_i gains lambda_2 a_2i (I.4.1) 26:5
            m * (z25 * v1_x2) + z42 + z43,
            # reaction of wheel3: Q_i gains lambda_3 a_3i (I.4.1) 27:5
            k6 * (z22 * (c2 * v1_x2 + s2 * z21)) + z41,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

    Arguments: t (scalar), y (7,), p (4,).
    Returns a scalar.
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    m = float(p[0])  # each link [kg]
    J = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # parameters only
        k1 = 1.0 / a
        # state
        z1 = theta1 - theta2
        z2 = theta2 - theta3
        c_theta2 = math.cos(theta2)
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        s_theta2 = math.sin(theta2)
        z3 = c_theta2 * s_theta1 - c_theta1 * s_theta2
        z4 = a * w
        z5 = c_theta1 * c_theta2 + s_theta1 * s_theta2
        z6 = v * z3 - z4 * z5
        z7 = k1 * z6
        c_theta3 = math.cos(theta3)
        s_theta3 = math.sin(theta3)
        s1 = (s_theta2 * c_theta3 - c_theta2 * s_theta3) * (v * z5 + z4 * z3)
        z8 = s1 - (c_theta2 * c_theta3 + s_theta2 * s_theta3) * z6
        z9 = k1 * z8
        z10 = c_theta1 * v
        z11 = s_theta1 * v
        z12 = s_theta2 * z6
        x2_dot = z10 + s_theta1 * z4 + z12
        z13 = c_theta2 * z6
        y2_dot = z11 - c_theta1 * z4 - z13
        x3_dot = z12 + x2_dot + s_theta3 * z8
        z14 = z13 - y2_dot + c_theta3 * z8
        s2 = z10 * z10 + z11 * z11 + x2_dot * x2_dot + y2_dot * y2_dot
        z15 = s2 + x3_dot * x3_dot + z14 * z14
        s3 = J * (w * w + z7 * z7 + z9 * z9) + m * z15
        z16 = k * (z1 * z1 + z2 * z2) + s3
        value1 = 0.5 * z16
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (7,), p (4,).
    Returns rows (7, 7): d rhs_i / d y_j stands at [i][j].
    """
    theta1 = float(y[2])  # first link [rad]
    theta2 = float(y[3])  # second link [rad]
    theta3 = float(y[4])  # third link [rad]
    v = float(y[5])
    w = float(y[6])
    m = float(p[0])  # each link [kg]
    J_2 = float(p[1])  # each link [kg*m^2]
    a = float(p[2])  # half the length of a link [m]
    k = float(p[3])  # stiffness of the hinges [N*m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "jacobian")
        # parameters only
        k1 = 1.0 / a
        k2 = J_2 * k1
        k3 = k1 * k2
        k4 = m * a
        k5 = a * k4
        k6 = k2 - k4
        k7 = k * k1
        # state
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
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise SingularModelError(2, "jacobian")
        z8 = a * s1
        z9 = a * c1
        z10 = s2 * z8 + c2 * z9
        z11 = c2 * z8 - s2 * z9
        z12 = J_2 * z4 + k3 * (z10 * z10) + z5 * k5 + m * (z11 * z11)
        z13 = c1 * s1
        z14 = z10 * k3
        z15 = m * z11
        z16 = z13 * k4 - (k2 * z13 - z6 * z14) + z3 * z15
        z17 = 1.0 / z7
        z18 = z17 * z16
        z19 = z12 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z12:
            raise SingularModelError(2, "jacobian")
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        z20 = a * w
        v1_x2 = v * c1 + s1 * z20
        z21 = k1 * v1_x2
        z22 = s1 * k1
        z23 = v * s1 - c1 * z20
        z24 = k1 * (c2 * v1_x2 + s2 * z23)
        z25 = k1 * z10
        z26 = k1 * (z23 - (s2 * v1_x2 - c2 * z23))
        z27 = c2 * z26
        z28 = m * z3
        z29 = s2 * z26
        z30 = z6 * k3
        z31 = z23 * z28 + v1_x2 * z30
        z32 = v1_x2 * z28 - z23 * z30
        z33 = k1 * (c2 * z31 - s2 * z32)
        z34 = m * c1 + c2 * z28 + s2 * z30
        z35 = s1 * k3 + s2 * z28 - c2 * z30
        z36 = z20 * z34 + v * z35
        z37 = z20 * z35 - v * z34
        z38 = c1 * z36 + s1 * z37
        z39 = z27 * z28 + z29 * z30 + z33 + c2 * z33 - k1 * z38
        z40 = z29 * z28 - z27 * z30 + s2 * z33
        z41 = w - k1 * z23
        z42 = c1 * z41
        z43 = s1 * z41
        z44 = v * z42 + z20 * z43
        z45 = z2 * k7
        z46 = 1.0 / z19
        z47 = 1.0 + c1
        z48 = c1 + z25
        z49 = v * z43 - z20 * z42
        z50 = v1_x2 * z29 + c2 * z49 - (z23 * z27 + s2 * z44)
        z51 = v1_x2 * z27 - s2 * z49 + (z23 * z29 - c2 * z44)
        z52 = c1 * k2
        z53 = s1 * k4
        s3 = z50 * z15 - (z51 * z14 - z44 * z52 - z49 * z53)
        z54 = k * (z1 * z47 - z2 * z48) - s3
        z55 = k1 * (s1 - z6)
        s4 = k3 * (s1 * z44 + z6 * z51) - m * (c1 * z49 + z3 * z50)
        z56 = s4 - k * (z1 * z22 - z2 * z55)
        z57 = z46 * (z54 - z56 * z18)
        z58 = k6 * z57
        z59 = z56 * z17 - z18 * z57
        z60 = k3 * z59
        z61 = m * z50
        z62 = m * z57
        z63 = z11 * z62
        z64 = m * z59
        z65 = z3 * z64
        z66 = z61 + z63 + 2.0 * z65
        s5 = z41 * z37 + (z44 * k3 + z45 + c1 * z58 - 2.0 * (s1 * z60))
        z67 = s5 - s2 * z66
        z68 = z3 * z62
        z69 = k3 * z57
        z70 = z6 * z69
        z71 = z51 * k3
        z72 = z10 * z69
        z73 = z6 * z60
        z74 = z71 - z45 - z72 - 2.0 * z73
        s6 = v * z39 - (z20 * z40 - z67) - a * (c2 * z68 + s2 * z70)
        z75 = s6 - c2 * z74
        s7 = z41 * z36 - (m * z49 - s1 * z58 + 2.0 * (c1 * z64))
        z76 = z20 * z39 - (s7 - c2 * z66)
        s8 = s1 * (v * z40 + z76 - a * (s2 * z68 - c2 * z70) - s2 * z74)
        z77 = k * z22 + c1 * (z1 * k7 - z75) - s8
        z78 = z23 * z15 + v1_x2 * z14
        z79 = v1_x2 * z15 - z23 * z14
        z80 = k1 * (c2 * z78 - s2 * z79)
        z81 = z53 + c2 * z15 + s2 * z14
        z82 = z52 - s2 * z15 + c2 * z14
        z83 = z20 * z81 - v * z82
        z84 = z20 * z82 + v * z81
        z85 = c1 * z83 - s1 * z84
        z86 = z27 * z15 + z29 * z14 + z80 + c2 * z80 - k1 * z85
        z87 = z29 * z15 - z27 * z14 + s2 * z80
        z88 = k6 * z59
        z89 = z11 * z64
        s9 = z41 * z84 + (z49 * k4 - c1 * z88 + 2.0 * (k5 * (s1 * z57)))
        z90 = s9 + s2 * z89
        z91 = z65 + (z61 + 2.0 * z63)
        z92 = z45 + (z73 - (z71 - 2.0 * z72))
        z93 = z10 * z60
        s10 = v * z86 - (z20 * z87 + z90) - a * (c2 * z91 + s2 * z92)
        z94 = s10 + c2 * z93
        s11 = k * (z1 - z2) - z44 * k2 + s1 * z88
        z95 = z41 * z83 + (s11 - 2.0 * (J_2 * (c1 * z57)))
        s12 = v * z87 + (z20 * z86 - (z95 - c2 * z89))
        z96 = s12 - a * (s2 * z91 - c2 * z92)
        z97 = k * z47 + c1 * z94 + s1 * (z96 + s2 * z93)
        z98 = z46 * (z97 + z18 * z77)
        s13 = z44 * z28 - z49 * z30 - z26 * z32 + z9 * z68 - s1 * z66
        z99 = v1_x2 * z33 - s13
        s14 = z49 * z28 + z44 * z30 - z26 * z31 + z8 * z68 + c1 * z66
        z100 = z23 * z33 - s14
        s15 = k * z55 - c2 * (z99 + z8 * z70 - c1 * z74)
        z101 = s15 - s2 * (z100 - z9 * z70 - s1 * z74)
        z102 = z77 + z101
        s16 = z44 * z15 - z49 * z14 - z26 * z79 + z9 * z91 - s1 * z89
        z103 = v1_x2 * z80 - s16
        s17 = z49 * z15 + z44 * z14 - z26 * z78 + z8 * z91 + c1 * z89
        z104 = z23 * z80 - s17
        s18 = k * z48 + c2 * (z103 + z8 * z92 + c1 * z93)
        z105 = s18 + s2 * (z104 - z9 * z92 + s1 * z93)
        z106 = z46 * (z97 + z105 + z18 * z102)
        z107 = z46 * (z105 + z18 * z101)
        z108 = z42 * z35 - z43 * z34 + s1 * z39 - c1 * z40
        s19 = z42 * z82 + z43 * z81 - s1 * z86 + c1 * z87 + z18 * z108
        z109 = z46 * s19
        z110 = z38 + a * (z42 * z34 + z43 * z35 - s1 * z40 - c1 * z39)
        s20 = z85 + a * (z42 * z81 - z43 * z82 - s1 * z87 - c1 * z86)
        z111 = s20 - z18 * z110
        z112 = z46 * z111
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
            z21,
            # (I.2.15)
            -z21,
            0.0,
            # (I.2.15)
            z22,
            # (I.2.15)
            -c1,
            0.0,
            0.0,
            # (I.2.15)
            -z24,
            # (I.2.15)
            2.0 * z24,
            # (I.2.15)
            -z24,
            # (I.2.15)
            k1 * z6,
            # (I.2.15)
            z25,
            0.0,
            0.0,
            # (I.2.15)
            z17 * z77 + z18 * z98,
            # (I.2.15)
            -(z17 * z102 + z18 * z106),
            # (I.2.15)
            z17 * z101 + z18 * z107,
            # (I.2.15)
            -(z17 * z108 + z18 * z109),
            # (I.2.15)
            z18 * z112 - z17 * z110,
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
    """the spec's outputs

    Arguments: t (scalar), y (7,), p (4,).
    Returns out (0,).
    """
    a = float(p[2])  # half the length of a link [m]
    try:
        # the coframe is singular
        if not abs(a) > 0.0:
            raise SingularModelError(1, "outputs")
        # state
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
