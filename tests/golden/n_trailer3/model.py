"""n_trailer3, emitted by nhc 0.1.0 (nhc:08e150f4ef6aa428).

A tractor with three trailers, each hitched to the axle before it; none of the four
    axles slips sideways.
Source: n_trailer3.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: axle of the tractor
y[1] = y [m]: axle of the tractor
y[2] = theta0 [rad]: heading of the tractor
y[3] = theta1 [rad]: first trailer
y[4] = theta2 [rad]: second trailer
y[5] = theta3 [rad]: third trailer
y[6] = v
y[7] = w

Parameters p:
p[0]: m0 = 1.0 [kg]: tractor
p[1]: J0 = 0.1 [kg*m^2]: tractor
p[2]: m = 0.5 [kg]: each trailer
p[3]: J = 0.05 [kg*m^2]: each trailer
p[4]: L = 0.8 [m]: from axle to axle

Constraints:
0: axle0
1: axle1
2: axle2
3: axle3

Outputs:
out[0] = tail_x
out[1] = tail_y

Operations:
rhs: 57 +-, 123 *, 2 /, 8 calls
velocities: 7 +-, 19 *, 1 /, 8 calls
accelerations: 76 +-, 142 *, 2 /, 8 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 10 +-, 20 *, 0 /, 8 calls
reactions: 129 +-, 227 *, 2 /, 8 calls
energy: 20 +-, 51 *, 1 /, 8 calls
jacobian: 213 +-, 377 *, 2 /, 8 calls
outputs: 6 +-, 2 *, 0 /, 6 calls

A singular point raises SingularModelError.
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
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (8,), p (5,).
    Returns dydt (8,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "rhs")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "rhs")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "rhs")
        c_theta0 = math.cos(theta0)
        s_theta0 = math.sin(theta0)
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z1 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0)
        c_theta2 = math.cos(theta2)
        z2 = s_theta0 - L * (c_theta1 * z1)
        s_theta2 = math.sin(theta2)
        z3 = c_theta0 + L * (s_theta1 * z1)
        z4 = k1 * (c_theta2 * z2 - s_theta2 * z3)
        s1 = c_theta0 * (m0 * c_theta0) + s_theta0 * (m0 * s_theta0)
        z5 = s1 + z1 * (J * z1) + z4 * (J * z4)
        c_theta3 = math.cos(theta3)
        z6 = z2 - L * (c_theta2 * z4)
        s_theta3 = math.sin(theta3)
        z7 = z3 + L * (s_theta2 * z4)
        z8 = k1 * (c_theta3 * z6 - s_theta3 * z7)
        s2 = z5 + z8 * (J * z8) + z3 * (m * z3) + z2 * (m * z2)
        z9 = s2 + z7 * (m * z7)
        z10 = z7 + L * (s_theta3 * z8)
        z11 = z6 - L * (c_theta3 * z8)
        z12 = z9 + z6 * (m * z6) + z10 * (m * z10) + z11 * (m * z11)
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "rhs")
        # the mass matrix is singular
        if not abs(J0) > 0.0:
            raise SingularModelError(2, "rhs")
        z13 = c_theta0 * v
        z14 = s_theta0 * v
        z15 = k1 * (c_theta1 * z14 - s_theta1 * z13)
        z16 = c_theta1 * z15
        y1_dot = z14 - L * z16
        z17 = s_theta1 * z15
        x1_dot = z13 + L * z17
        z18 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        z19 = c_theta2 * z18
        y2_dot = y1_dot - L * z19
        z20 = s_theta2 * z18
        x2_dot = x1_dot + L * z20
        z21 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot)
        z22 = v * (c_theta0 * w)
        z23 = v * (s_theta0 * w)
        s3 = z14 * z17 - c_theta1 * z22 + (z13 * z16 - s_theta1 * z23)
        z24 = k1 * s3
        z25 = z22 + L * (z15 * z17 + c_theta1 * z24)
        z26 = z23 - L * (z15 * z16 - s_theta1 * z24)
        s4 = y1_dot * z20 - c_theta2 * z25
        z27 = k1 * (s4 + (x1_dot * z19 - s_theta2 * z26))
        z28 = z25 + L * (z18 * z20 + c_theta2 * z27)
        z29 = s_theta3 * z21
        z30 = c_theta3 * z21
        z31 = z26 - L * (z18 * z19 - s_theta2 * z27)
        s5 = y2_dot * z29 - c_theta3 * z28
        z32 = k1 * (s5 + (x2_dot * z30 - s_theta3 * z31))
        s6 = c_theta0 * (m0 * z23) - s_theta0 * (m0 * z22)
        z33 = z4 * (J * z27) + (z1 * (J * z24) + s6)
        s7 = z2 * (m * z25) - (z3 * (m * z26) + (z8 * (J * z32) + z33))
        z34 = z7 * (m * z31) - s7
        s8 = z10 * (m * (z31 - L * (z21 * z30 - s_theta3 * z32)))
        z35 = s8 - (z6 * (m * z28) - z34)
        s9 = -(z11 * (m * (z28 + L * (z21 * z29 + c_theta3 * z32))) - z35)
        dydt: list[float] = [
            # x' (I.2.15)
            z13,
            # y' (I.2.15)
            z14,
            # theta0' (I.2.15)
            w,
            # theta1' (I.2.15)
            z15,
            # theta2' (I.2.15)
            z18,
            # theta3' (I.2.15)
            z21,
            # v' (I.2.15) 30:4
            s9 / z12,
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
    """all velocities q' from the state (I.2.4)

    Arguments: t (scalar), y (8,), p (5,).
    Returns qdot (6,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "velocities")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "velocities")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "velocities")
        c_theta0 = math.cos(theta0)
        z1 = c_theta0 * v
        s_theta0 = math.sin(theta0)
        z2 = s_theta0 * v
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z3 = k1 * (c_theta1 * z2 - s_theta1 * z1)
        c_theta2 = math.cos(theta2)
        y1_dot = z2 - L * (c_theta1 * z3)
        s_theta2 = math.sin(theta2)
        x1_dot = z1 + L * (s_theta1 * z3)
        z4 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        c_theta3 = math.cos(theta3)
        s_theta3 = math.sin(theta3)
        s1 = c_theta3 * (y1_dot - L * (c_theta2 * z4))
        qdot: list[float] = [
            # x' (I.2.4)
            z1,
            # y' (I.2.4)
            z2,
            # theta0' (I.2.4)
            w,
            # theta1' (I.2.4)
            z3,
            # theta2' (I.2.4)
            z4,
            # theta3' (I.2.4)
            k1 * (s1 - s_theta3 * (x1_dot + L * (s_theta2 * z4))),
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qddot (6,).
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "accelerations")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "accelerations")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "accelerations")
        c_theta0 = math.cos(theta0)
        s_theta0 = math.sin(theta0)
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z1 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0)
        c_theta2 = math.cos(theta2)
        z2 = s_theta0 - L * (c_theta1 * z1)
        s_theta2 = math.sin(theta2)
        z3 = c_theta0 + L * (s_theta1 * z1)
        z4 = k1 * (c_theta2 * z2 - s_theta2 * z3)
        s1 = c_theta0 * (m0 * c_theta0) + s_theta0 * (m0 * s_theta0)
        z5 = s1 + z1 * (J * z1) + z4 * (J * z4)
        c_theta3 = math.cos(theta3)
        z6 = z2 - L * (c_theta2 * z4)
        s_theta3 = math.sin(theta3)
        z7 = z3 + L * (s_theta2 * z4)
        z8 = k1 * (c_theta3 * z6 - s_theta3 * z7)
        s2 = z5 + z8 * (J * z8) + z3 * (m * z3) + z2 * (m * z2)
        z9 = s2 + z7 * (m * z7)
        z10 = z7 + L * (s_theta3 * z8)
        z11 = z6 - L * (c_theta3 * z8)
        z12 = z9 + z6 * (m * z6) + z10 * (m * z10) + z11 * (m * z11)
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "accelerations")
        # the mass matrix is singular
        if not abs(J0) > 0.0:
            raise SingularModelError(2, "accelerations")
        z13 = v * (s_theta0 * w)
        z14 = v * (c_theta0 * w)
        z15 = s_theta0 * v
        z16 = c_theta0 * v
        z17 = k1 * (c_theta1 * z15 - s_theta1 * z16)
        z18 = s_theta1 * z17
        z19 = z17 * z18
        z20 = z15 * z18
        z21 = c_theta1 * z17
        z22 = z16 * z21
        z23 = k1 * (z20 - c_theta1 * z14 + (z22 - s_theta1 * z13))
        z24 = z14 + L * (z19 + c_theta1 * z23)
        y1_dot = z15 - L * z21
        x1_dot = z16 + L * z18
        z25 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        z26 = s_theta2 * z25
        z27 = z25 * z26
        z28 = y1_dot * z26
        z29 = c_theta2 * z25
        z30 = x1_dot * z29
        z31 = z17 * z21
        z32 = z13 - L * (z31 - s_theta1 * z23)
        z33 = k1 * (z28 - c_theta2 * z24 + (z30 - s_theta2 * z32))
        z34 = z24 + L * (z27 + c_theta2 * z33)
        y2_dot = y1_dot - L * z29
        x2_dot = x1_dot + L * z26
        z35 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot)
        z36 = s_theta3 * z35
        z37 = y2_dot * z36
        z38 = c_theta3 * z35
        z39 = x2_dot * z38
        z40 = z25 * z29
        z41 = z32 - L * (z40 - s_theta2 * z33)
        z42 = k1 * (z37 - c_theta3 * z34 + (z39 - s_theta3 * z41))
        s3 = c_theta0 * (m0 * z13) - s_theta0 * (m0 * z14)
        z43 = z4 * (J * z33) + (z1 * (J * z23) + s3)
        s4 = z2 * (m * z24) - (z3 * (m * z32) + (z8 * (J * z42) + z43))
        z44 = z7 * (m * z41) - s4
        s5 = z10 * (m * (z41 - L * (z35 * z38 - s_theta3 * z42)))
        z45 = s5 - (z6 * (m * z34) - z44)
        s6 = z11 * (m * (z34 + L * (z35 * z36 + c_theta3 * z42))) - z45
        z46 = s6 / z12
        z47 = z13 + c_theta0 * z46
        z48 = z14 - s_theta0 * z46
        z49 = k1 * (z20 - c_theta1 * z48 + (z22 - s_theta1 * z47))
        z50 = z48 + L * (z19 + c_theta1 * z49)
        z51 = z47 - L * (z31 - s_theta1 * z49)
        z52 = k1 * (z28 - c_theta2 * z50 + (z30 - s_theta2 * z51))
        s7 = z37 - c_theta3 * (z50 + L * (z27 + c_theta2 * z52))
        z53 = s7 + (z39 - s_theta3 * (z51 - L * (z40 - s_theta2 * z52)))
        qddot: list[float] = [
            # x'' (I.2.15)
            -z47,
            # y'' (I.2.15)
            z48,
            # theta0'' (I.2.15)
            0.0,
            # theta1'' (I.2.15)
            -z49,
            # theta2'' (I.2.15)
            -z52,
            # theta3'' (I.2.15)
            -k1 * z53,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (5,).
    Returns y (8,).
    """
    x = float(q[0])  # axle of the tractor [m]
    y_2 = float(q[1])  # axle of the tractor [m]
    theta0 = float(q[2])  # heading of the tractor [rad]
    theta1 = float(q[3])  # first trailer [rad]
    theta2 = float(q[4])  # second trailer [rad]
    theta3 = float(q[5])  # third trailer [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta0_dot = float(qdot[2])
    try:
        # state
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
    """left sides of the constraints, zero on every motion (I.1.1)

    Arguments: t (scalar), q (6,), qdot (6,), p (5,).
    Returns r (4,).
    """
    theta0 = float(q[2])  # heading of the tractor [rad]
    theta1 = float(q[3])  # first trailer [rad]
    theta2 = float(q[4])  # second trailer [rad]
    theta3 = float(q[5])  # third trailer [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta1_dot = float(qdot[3])
    theta2_dot = float(qdot[4])
    theta3_dot = float(qdot[5])
    L = float(p[4])  # from axle to axle [m]
    try:
        # state
        s_theta0 = math.sin(theta0)
        c_theta0 = math.cos(theta0)
        s_theta1 = math.sin(theta1)
        x1_dot = x_dot + L * (theta1_dot * s_theta1)
        c_theta1 = math.cos(theta1)
        y1_dot = y_dot - L * (theta1_dot * c_theta1)
        s_theta2 = math.sin(theta2)
        x2_dot = x1_dot + L * (theta2_dot * s_theta2)
        c_theta2 = math.cos(theta2)
        y2_dot = y1_dot - L * (theta2_dot * c_theta2)
        s_theta3 = math.sin(theta3)
        c_theta3 = math.cos(theta3)
        s1 = c_theta3 * (y2_dot - L * (theta3_dot * c_theta3))
        r: list[float] = [
            # axle0 = 0 (I.1.1) 32:5
            y_dot * c_theta0 - x_dot * s_theta0,
            # axle1 = 0 (I.1.1) 33:5
            c_theta1 * y1_dot - s_theta1 * x1_dot,
            # axle2 = 0 (I.1.1) 34:5
            c_theta2 * y2_dot - s_theta2 * x2_dot,
            # axle3 = 0 (I.1.1) 35:5
            s1 - s_theta3 * (x2_dot + L * (theta3_dot * s_theta3)),
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns lambda_ (4,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "reactions")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "reactions")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "reactions")
        c_theta0 = math.cos(theta0)
        z1 = m0 * c_theta0
        s_theta0 = math.sin(theta0)
        z2 = m0 * s_theta0
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z3 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0)
        z4 = J * z3
        c_theta2 = math.cos(theta2)
        z5 = s_theta0 - L * (c_theta1 * z3)
        s_theta2 = math.sin(theta2)
        z6 = c_theta0 + L * (s_theta1 * z3)
        z7 = k1 * (c_theta2 * z5 - s_theta2 * z6)
        z8 = J * z7
        c_theta3 = math.cos(theta3)
        z9 = z5 - L * (c_theta2 * z7)
        s_theta3 = math.sin(theta3)
        z10 = z6 + L * (s_theta2 * z7)
        z11 = k1 * (c_theta3 * z9 - s_theta3 * z10)
        z12 = J * z11
        z13 = m * z6
        s1 = c_theta0 * z1 + s_theta0 * z2 + z3 * z4 + z7 * z8
        z14 = s1 + z11 * z12 + z6 * z13
        z15 = m * z5
        z16 = m * z10
        z17 = m * z9
        z18 = z10 + L * (s_theta3 * z11)
        z19 = m * z18
        z20 = z9 - L * (c_theta3 * z11)
        z21 = m * z20
        s2 = z14 + z5 * z15 + z10 * z16 + z9 * z17 + z18 * z19
        z22 = s2 + z20 * z21
        # the mass matrix is singular
        if not abs(z22) > 0.0:
            raise SingularModelError(2, "reactions")
        # the mass matrix is singular
        if not abs(J0) > 0.0:
            raise SingularModelError(2, "reactions")
        z23 = v * (c_theta0 * w)
        z24 = s_theta0 * v
        z25 = c_theta0 * v
        z26 = k1 * (c_theta1 * z24 - s_theta1 * z25)
        z27 = s_theta1 * z26
        z28 = c_theta1 * z26
        z29 = v * (s_theta0 * w)
        s3 = z24 * z27 - c_theta1 * z23 + (z25 * z28 - s_theta1 * z29)
        z30 = k1 * s3
        z31 = z23 + L * (z26 * z27 + c_theta1 * z30)
        y1_dot = z24 - L * z28
        x1_dot = z25 + L * z27
        z32 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        z33 = s_theta2 * z32
        z34 = c_theta2 * z32
        z35 = z29 - L * (z26 * z28 - s_theta1 * z30)
        s4 = y1_dot * z33 - c_theta2 * z31
        z36 = k1 * (s4 + (x1_dot * z34 - s_theta2 * z35))
        z37 = z31 + L * (z32 * z33 + c_theta2 * z36)
        y2_dot = y1_dot - L * z34
        x2_dot = x1_dot + L * z33
        z38 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot)
        z39 = s_theta3 * z38
        z40 = c_theta3 * z38
        z41 = z35 - L * (z32 * z34 - s_theta2 * z36)
        s5 = y2_dot * z39 - c_theta3 * z37
        z42 = k1 * (s5 + (x2_dot * z40 - s_theta3 * z41))
        z43 = m * (z37 + L * (z38 * z39 + c_theta3 * z42))
        z44 = k1 * (c_theta1 * c_theta0 + s_theta1 * s_theta0)
        z45 = c_theta0 - L * (c_theta1 * z44)
        z46 = s_theta0 - L * (s_theta1 * z44)
        z47 = k1 * (c_theta2 * z45 + s_theta2 * z46)
        z48 = z45 - L * (c_theta2 * z47)
        z49 = z46 - L * (s_theta2 * z47)
        z50 = k1 * (c_theta3 * z48 + s_theta3 * z49)
        z51 = z48 - L * (c_theta3 * z50)
        z52 = m * (z41 - L * (z38 * z40 - s_theta3 * z42))
        z53 = z49 - L * (s_theta3 * z50)
        z54 = m * z37
        z55 = m * z41
        z56 = m * z31
        z57 = m * z35
        z58 = J * z42
        z59 = J * z36
        z60 = J * z30
        z61 = m0 * z29
        z62 = m0 * z23
        s6 = z47 * z59 + (z44 * z60 - (s_theta0 * z61 + c_theta0 * z62))
        z63 = z46 * z57 - (z50 * z58 + s6)
        s7 = s_theta0 * z1 - c_theta0 * z2 - z44 * z4 - z47 * z8
        z64 = s7 - z50 * z12 + z46 * z13
        s8 = z7 * z59 + (z3 * z60 + (c_theta0 * z61 - s_theta0 * z62))
        z65 = z6 * z57 + (z11 * z58 + s8)
        s9 = z18 * z52 - (z9 * z54 - (z10 * z55 - (z5 * z56 - z65)))
        z66 = (z20 * z43 - s9) / z22
        s10 = z64 - z45 * z15 + z49 * z16 - z48 * z17 + z19 * z53
        z67 = (s10 - z21 * z51) * z66
        s11 = z52 * z53 + (z48 * z54 + (z49 * z55 + (z45 * z56 + z63)))
        z68 = z43 * z51 + s11 + z67
        z69 = k1 * (c_theta1 * c_theta2 + s_theta1 * s_theta2)
        z70 = c_theta1 - L * (c_theta2 * z69)
        z71 = s_theta1 - L * (s_theta2 * z69)
        z72 = k1 * (c_theta3 * z70 + s_theta3 * z71)
        z73 = z70 - L * (c_theta3 * z72)
        z74 = z71 - L * (s_theta3 * z72)
        s12 = s_theta1 * z57 - (z72 * z58 - (k1 * z60 - z69 * z59))
        z75 = z71 * z55 + (c_theta1 * z56 + s12)
        s13 = k1 * z4 - z69 * z8 - z72 * z12 + s_theta1 * z13
        z76 = s13 - c_theta1 * z15 + z71 * z16
        s14 = (z76 - z70 * z17 + z19 * z74 - z21 * z73) * z66
        z77 = z43 * z73 + (z52 * z74 + (z70 * z54 + z75)) + s14
        z78 = k1 * (c_theta2 * c_theta3 + s_theta2 * s_theta3)
        z79 = c_theta2 - L * (c_theta3 * z78)
        z80 = s_theta2 - L * (s_theta3 * z78)
        s15 = c_theta2 * z54 + (s_theta2 * z55 + (k1 * z59 - z78 * z58))
        z81 = z43 * z79 + (z52 * z80 + s15)
        s16 = k1 * z8 - z78 * z12 + s_theta2 * z16 - c_theta2 * z17
        z82 = s16 + z19 * z80 - z21 * z79
        s17 = (k1 * z12 + s_theta3 * z19 - c_theta3 * z21) * z66
        z83 = c_theta3 * z43 + (k1 * z58 + s_theta3 * z52) + s17
        lambda_: list[float] = [
            # reaction of axle0: Q_i gains lambda_1 a_1i (I.4.1) 32:5
            z68,
            # reaction of axle1: Q_i gains lambda_2 a_2i (I.4.1) 33:5
            z77,
            # reaction of axle2: Q_i gains lambda_3 a_3i (I.4.1) 34:5
            z81 + z82 * z66,
            # reaction of axle3: Q_i gains lambda_4 a_4i (I.4.1) 35:5
            z83,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (8,), p (5,).
    Returns a scalar.
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        c_theta0 = math.cos(theta0)
        z1 = c_theta0 * v
        s_theta1 = math.sin(theta1)
        c_theta1 = math.cos(theta1)
        s_theta0 = math.sin(theta0)
        z2 = s_theta0 * v
        z3 = k1 * (c_theta1 * z2 - s_theta1 * z1)
        x1_dot = z1 + L * (s_theta1 * z3)
        s_theta2 = math.sin(theta2)
        c_theta2 = math.cos(theta2)
        y1_dot = z2 - L * (c_theta1 * z3)
        z4 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        x2_dot = x1_dot + L * (s_theta2 * z4)
        s_theta3 = math.sin(theta3)
        c_theta3 = math.cos(theta3)
        y2_dot = y1_dot - L * (c_theta2 * z4)
        z5 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot)
        x3_dot = x2_dot + L * (s_theta3 * z5)
        y3_dot = y2_dot - L * (c_theta3 * z5)
        s1 = 0.5 * (m * (x1_dot * x1_dot + y1_dot * y1_dot))
        s2 = 0.5 * (m0 * (z1 * z1 + z2 * z2)) + 0.5 * (J0 * (w * w))
        z6 = s2 + (s1 + 0.5 * (J * (z3 * z3)))
        s3 = 0.5 * (m * (x3_dot * x3_dot + y3_dot * y3_dot))
        s4 = 0.5 * (m * (x2_dot * x2_dot + y2_dot * y2_dot))
        z7 = s3 + 0.5 * (J * (z5 * z5)) + (s4 + 0.5 * (J * (z4 * z4)) + z6)
        value1 = z7
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (8,), p (5,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    theta0 = float(y[2])  # heading of the tractor [rad]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    v = float(y[6])
    w = float(y[7])
    m0 = float(p[0])  # tractor [kg]
    J0 = float(p[1])  # tractor [kg*m^2]
    m = float(p[2])  # each trailer [kg]
    J_2 = float(p[3])  # each trailer [kg*m^2]
    L = float(p[4])  # from axle to axle [m]
    try:
        # parameters only
        k1 = 1.0 / L
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "jacobian")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "jacobian")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "jacobian")
        c_theta0 = math.cos(theta0)
        z1 = m0 * c_theta0
        s_theta0 = math.sin(theta0)
        z2 = m0 * s_theta0
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        z3 = k1 * (c_theta1 * s_theta0 - s_theta1 * c_theta0)
        z4 = J_2 * z3
        c_theta2 = math.cos(theta2)
        z5 = s_theta0 - L * (c_theta1 * z3)
        s_theta2 = math.sin(theta2)
        z6 = c_theta0 + L * (s_theta1 * z3)
        z7 = k1 * (c_theta2 * z5 - s_theta2 * z6)
        z8 = J_2 * z7
        c_theta3 = math.cos(theta3)
        z9 = z5 - L * (c_theta2 * z7)
        s_theta3 = math.sin(theta3)
        z10 = z6 + L * (s_theta2 * z7)
        z11 = k1 * (c_theta3 * z9 - s_theta3 * z10)
        z12 = J_2 * z11
        z13 = m * z6
        s1 = c_theta0 * z1 + s_theta0 * z2 + z3 * z4 + z7 * z8
        z14 = s1 + z11 * z12 + z6 * z13
        z15 = m * z5
        z16 = m * z10
        z17 = m * z9
        z18 = z10 + L * (s_theta3 * z11)
        z19 = m * z18
        z20 = z9 - L * (c_theta3 * z11)
        z21 = m * z20
        s2 = z14 + z5 * z15 + z10 * z16 + z9 * z17 + z18 * z19
        z22 = s2 + z20 * z21
        # the mass matrix is singular
        if not abs(z22) > 0.0:
            raise SingularModelError(2, "jacobian")
        # the mass matrix is singular
        if not abs(J0) > 0.0:
            raise SingularModelError(2, "jacobian")
        z23 = s_theta0 * v
        z24 = c_theta0 * v
        z25 = c_theta1 * k1
        z26 = s_theta1 * k1
        z27 = k1 * (c_theta1 * c_theta2 + s_theta1 * s_theta2)
        z28 = c_theta2 * k1 - c_theta1 * z27
        z29 = s_theta2 * k1 - s_theta1 * z27
        z30 = k1 * (c_theta1 * z23 - s_theta1 * z24)
        z31 = s_theta1 * z30
        x1_dot = z24 + L * z31
        z32 = c_theta1 * z30
        y1_dot = z23 - L * z32
        z33 = k1 * (c_theta2 * c_theta3 + s_theta2 * s_theta3)
        z34 = c_theta3 * k1 - c_theta2 * z33
        z35 = s_theta3 * k1 - s_theta2 * z33
        z36 = L * z35
        z37 = L * z34
        z38 = k1 * (s_theta1 * z36 + c_theta1 * z37)
        z39 = z34 - c_theta1 * z38
        z40 = z35 - s_theta1 * z38
        z41 = k1 * (c_theta2 * y1_dot - s_theta2 * x1_dot)
        z42 = s_theta2 * z41
        x2_dot = x1_dot + L * z42
        z43 = c_theta2 * z41
        y2_dot = y1_dot - L * z43
        z44 = 1.0 / z22
        z45 = L * z21
        z46 = L * z19
        z47 = k1 * (z12 - c_theta3 * z45 + s_theta3 * z46)
        z48 = m * (z10 + z18) - s_theta3 * z47
        z49 = L * z48
        z50 = m * (z9 + z20) + c_theta3 * z47
        z51 = L * z50
        z52 = k1 * (z8 + s_theta2 * z49 - c_theta2 * z51)
        z53 = z13 + z48 - s_theta2 * z52
        z54 = L * z53
        z55 = z15 + z50 + c_theta2 * z52
        z56 = L * z55
        z57 = k1 * (z4 + s_theta1 * z54 - c_theta1 * z56)
        z58 = k1 * (c_theta3 * y2_dot - s_theta3 * x2_dot)
        z59 = s_theta3 * z58
        z60 = c_theta3 * z58
        z61 = z58 * z46 - x2_dot * z47
        z62 = z58 * z45 - y2_dot * z47
        z63 = k1 * (z59 * z45 + z60 * z46 + c_theta3 * z61 + s_theta3 * z62)
        z64 = z59 * z47 - c_theta3 * z63
        z65 = z60 * z47 + s_theta3 * z63
        z66 = z41 * z51 - y1_dot * z52 - L * z65
        z67 = z41 * z49 - x1_dot * z52 + L * z64
        z68 = k1 * (z43 * z49 + z42 * z51 + s_theta2 * z66 + c_theta2 * z67)
        z69 = z42 * z52 + z64 - c_theta2 * z68
        z70 = z43 * z52 + z65 + s_theta2 * z68
        z71 = z30 * z56 - z23 * z57 - L * z70
        z72 = z30 * z54 - z24 * z57 + L * z69
        z73 = k1 * (z32 * z54 + z31 * z56 + s_theta1 * z71 + c_theta1 * z72)
        z74 = z31 * z57 + z69 - c_theta1 * z73
        z75 = z1 + z53 - s_theta1 * z57
        z76 = v * z75
        z77 = c_theta0 * w
        z78 = v * z77
        z79 = m0 * z78
        z80 = s_theta0 * w
        z81 = v * z80
        s3 = z23 * z31 - c_theta1 * z78 + (z24 * z32 - s_theta1 * z81)
        z82 = k1 * s3
        z83 = z78 + L * (z30 * z31 + c_theta1 * z82)
        z84 = z81 - L * (z30 * z32 - s_theta1 * z82)
        s4 = y1_dot * z42 - c_theta2 * z83
        z85 = k1 * (s4 + (x1_dot * z43 - s_theta2 * z84))
        z86 = z83 + L * (z41 * z42 + c_theta2 * z85)
        z87 = z84 - L * (z41 * z43 - s_theta2 * z85)
        s5 = y2_dot * z59 - c_theta3 * z86
        z88 = k1 * (s5 + (x2_dot * z60 - s_theta3 * z87))
        z89 = m * (z86 + L * (z58 * z59 + c_theta3 * z88))
        z90 = m * (z87 - L * (z58 * z60 - s_theta3 * z88))
        z91 = m * z86
        z92 = m * z87
        z93 = m * z83
        z94 = m * z84
        z95 = J_2 * z88
        z96 = J_2 * z85
        z97 = J_2 * z82
        z98 = m0 * z81
        s6 = z7 * z96 + (z3 * z97 + (c_theta0 * z98 - s_theta0 * z79))
        z99 = z6 * z94 + (z11 * z95 + s6)
        s7 = z18 * z90 - (z9 * z91 - (z10 * z92 - (z5 * z93 - z99)))
        z100 = (z20 * z89 - s7) * z44
        z101 = z89 - z21 * z100 - m * (z20 * z100)
        z102 = L * z101
        z103 = z90 + z19 * z100 + m * (z18 * z100)
        z104 = L * z103
        s8 = z95 + z12 * z100 + J_2 * (z11 * z100) + c_theta3 * z102
        z105 = k1 * (s8 + s_theta3 * z104)
        s9 = z101 + (z91 - z17 * z100 - m * (z9 * z100))
        z106 = s9 - c_theta3 * z105
        s10 = z103 + (z92 + z16 * z100 + m * (z10 * z100))
        z107 = s10 - s_theta3 * z105
        z108 = L * z107
        z109 = L * z106
        s11 = z96 + z8 * z100 + J_2 * (z7 * z100) + s_theta2 * z108
        z110 = k1 * (s11 + c_theta2 * z109)
        z111 = z93 - z15 * z100 - m * (z5 * z100) + z106 - c_theta2 * z110
        z112 = z94 + z13 * z100 + m * (z6 * z100) + z107 - s_theta2 * z110
        z113 = L * z112
        z114 = L * z111
        s12 = z97 + z4 * z100 + J_2 * (z3 * z100) + s_theta1 * z113
        z115 = k1 * (s12 + c_theta1 * z114)
        s13 = w * z76 - (z79 - z2 * z100 - m0 * (s_theta0 * z100)) - z111
        z116 = v * z74 + (s13 + c_theta1 * z115)
        z117 = z32 * z57 + z70 + s_theta1 * z73
        z118 = z2 + z55 + c_theta1 * z57
        z119 = v * z118
        s14 = w * z119 - (z98 + z1 * z100 + m0 * (c_theta0 * z100)) - z112
        z120 = v * z117 - (s14 + s_theta1 * z115)
        s15 = z82 * z54 - z81 * z57 - z30 * z71 + z24 * z73 + z3 * z113
        z121 = s15 - c_theta0 * z115
        s16 = z82 * z56 + z78 * z57 + z30 * z72 + z23 * z73 - z3 * z114
        z122 = s16 - s_theta0 * z115
        s17 = z85 * z49 - z84 * z52 - z41 * z66 + x1_dot * z68 + z7 * z108
        z123 = s17 - z6 * z110
        s18 = z85 * z51 + z83 * z52 + z41 * z67 + y1_dot * z68 - z7 * z109
        z124 = s18 - z5 * z110
        s19 = z58 * z62 - (z88 * z46 - z87 * z47 + z11 * z104)
        z125 = x2_dot * z63 - s19 - z10 * z105
        s20 = z58 * z61 + (z88 * z45 + z86 * z47 - z11 * z102)
        z126 = y2_dot * z63 + s20 - z9 * z105
        s21 = s_theta1 * (c_theta2 * z30 + z23 * z27)
        s22 = s_theta1 * (z30 * z37 + z23 * z38)
        s23 = s_theta2 * (c_theta3 * z41 + z33 * y1_dot)
        s24 = z77 * z118 - z80 * z75 - s_theta0 * z74 - c_theta0 * z117
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z23,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z24,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta0 * (v * z25) + s_theta0 * (v * z26),
            # (I.2.15)
            -(c_theta1 * (z24 * k1) + s_theta1 * (z23 * k1)),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta0 * z25 - c_theta0 * z26,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta0 * (v * z28) + s_theta0 * (v * z29),
            # (I.2.15)
            s21 - c_theta1 * (s_theta2 * z30 - z24 * z27),
            # (I.2.15)
            -(c_theta2 * (k1 * x1_dot) + s_theta2 * (k1 * y1_dot)),
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta0 * z28 - c_theta0 * z29,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta0 * (v * z39) + s_theta0 * (v * z40),
            # (I.2.15)
            s22 - c_theta1 * (z30 * z36 - z24 * z38),
            # (I.2.15)
            s23 - c_theta2 * (s_theta3 * z41 - z33 * x1_dot),
            # (I.2.15)
            -(c_theta3 * (k1 * x2_dot) + s_theta3 * (k1 * y2_dot)),
            # (I.2.15)
            s_theta0 * z39 - c_theta0 * z40,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z44 * (c_theta0 * z116 - s_theta0 * z120),
            # (I.2.15)
            z44 * (c_theta1 * z121 + s_theta1 * z122),
            # (I.2.15)
            z44 * (c_theta2 * z123 + s_theta2 * z124),
            # (I.2.15)
            z44 * (c_theta3 * z125 + s_theta3 * z126),
            # (I.2.15)
            -z44 * s24,
            # (I.2.15)
            -z44 * (c_theta0 * z119 - s_theta0 * z76),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k2 : k2 + 8] for k2 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (8,), p (5,).
    Returns out (2,).
    """
    x = float(y[0])  # axle of the tractor [m]
    y_2 = float(y[1])  # axle of the tractor [m]
    theta1 = float(y[3])  # first trailer [rad]
    theta2 = float(y[4])  # second trailer [rad]
    theta3 = float(y[5])  # third trailer [rad]
    L = float(p[4])  # from axle to axle [m]
    try:
        # state
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "outputs")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "outputs")
        # the coframe is singular
        if not abs(-L) > 0.0:
            raise SingularModelError(1, "outputs")
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
