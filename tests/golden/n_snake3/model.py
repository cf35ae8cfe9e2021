"""n_snake3, emitted by nhc 0.1.0 (nhc:48e89ccaaba043f9).

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
rhs: 84 +-, 153 *, 3 /, 6 calls
velocities: 8 +-, 16 *, 1 /, 6 calls
accelerations: 102 +-, 169 *, 3 /, 6 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 11 +-, 18 *, 0 /, 6 calls
reactions: 148 +-, 248 *, 3 /, 6 calls
energy: 22 +-, 37 *, 1 /, 6 calls
jacobian: 365 +-, 560 *, 3 /, 6 calls
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
        # parameters only
        k1 = 1.0 / a
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "rhs")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "rhs")
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        c_theta2 = math.cos(theta2)
        s_theta2 = math.sin(theta2)
        z1 = c_theta2 * s_theta1 - c_theta1 * s_theta2
        z2 = k1 * z1
        c_theta3 = math.cos(theta3)
        z3 = a * (c_theta2 * z2)
        z4 = s_theta1 - z3
        z5 = z3 - z4
        s_theta3 = math.sin(theta3)
        z6 = a * (s_theta2 * z2)
        z7 = c_theta1 + z6
        z8 = z6 + z7
        z9 = c_theta3 * z5 + s_theta3 * z8
        z10 = k1 * z9
        s1 = c_theta1 * (m * c_theta1) + s_theta1 * (m * s_theta1)
        z11 = s1 + z2 * (J * z2) + z10 * (J * z10)
        z12 = z8 - a * (s_theta3 * z10)
        z13 = z5 - a * (c_theta3 * z10)
        s2 = z11 + z7 * (m * z7) + z4 * (m * z4) + z12 * (m * z12)
        z14 = s2 + z13 * (m * z13)
        # the mass matrix is singular
        if not abs(z14) > 0.0:
            raise SingularModelError(2, "rhs")
        z15 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2
        z16 = k1 * z15
        z17 = J * z16
        z18 = c_theta2 * z16
        z19 = c_theta1 - z18
        z20 = z18 - z19
        z21 = s_theta2 * z16
        z22 = s_theta1 - z21
        z23 = z21 - z22
        z24 = c_theta3 * (a * z20) + s_theta3 * (a * z23)
        z25 = k1 * z24
        z26 = J * z25
        z27 = a * z22
        z28 = m * z27
        z29 = a * z19
        z30 = m * z29
        z31 = a * (z23 - s_theta3 * z25)
        z32 = m * z31
        z33 = a * (z20 - c_theta3 * z25)
        z34 = m * z33
        s3 = J + z16 * z17 + z25 * z26 + z27 * z28 + z29 * z30
        z35 = s3 + z31 * z32 + z33 * z34
        s4 = z2 * z17 + z10 * z26 - z7 * z28 + z4 * z30 + z12 * z32
        z36 = s4 + z13 * z34
        z37 = 1.0 / z14
        z38 = z36 * z37
        z39 = z35 - z36 * z38
        # the mass matrix is singular
        if not abs(z39) > 1e-14 * z35:
            raise SingularModelError(2, "rhs")
        z40 = c_theta1 * v
        z41 = s_theta1 * v
        z42 = c_theta1 * w
        z43 = z41 - a * z42
        z44 = s_theta1 * w
        z45 = z40 + a * z44
        z46 = k1 * (c_theta2 * z43 - s_theta2 * z45)
        z47 = c_theta2 * z46
        z48 = a * z47
        z49 = z48 - (z43 - z48)
        z50 = s_theta2 * z46
        z51 = a * z50
        z52 = z51 + (z45 + z51)
        z53 = k1 * (c_theta3 * z49 + s_theta3 * z52)
        z54 = v * z42
        z55 = z54 + a * (w * z44)
        z56 = v * z44
        z57 = z56 - a * (w * z42)
        s5 = z43 * z50 - c_theta2 * z55 + (z45 * z47 - s_theta2 * z57)
        z58 = k1 * s5
        z59 = a * (z46 * z50 + c_theta2 * z58)
        z60 = z55 + z59
        z61 = z59 + z60
        z62 = s_theta3 * z53
        z63 = c_theta3 * z53
        z64 = a * (z46 * z47 - s_theta2 * z58)
        z65 = z57 - z64
        z66 = z64 - z65
        s6 = z49 * z62 - c_theta3 * z61 - (z52 * z63 - s_theta3 * z66)
        z67 = k1 * s6
        z68 = m * (z61 + a * (z53 * z62 + c_theta3 * z67))
        z69 = m * (z66 + a * (z53 * z63 - s_theta3 * z67))
        z70 = m * z60
        z71 = m * z65
        z72 = J * z67
        z73 = J * z58
        s7 = z2 * z73 + (c_theta1 * (m * z56) - s_theta1 * (m * z54))
        z74 = z7 * z71 - (z10 * z72 - s7)
        z75 = theta1 - theta2
        z76 = theta2 - theta3
        s8 = k * (2.0 * (z75 * z2) - 2.0 * (z76 * (k1 * (z1 + z9))))
        z77 = z13 * z68 - (z12 * z69 + (z4 * z70 - z74)) + 0.5 * s8
        s9 = z29 * z70 + (z27 * z71 - (z16 * z73 - z25 * z72))
        z78 = z33 * z68 - (z31 * z69 + s9)
        s10 = 2.0 * (z75 * (1.0 + z16)) - 2.0 * (z76 * (k1 * (z15 + z24)))
        z79 = z78 + 0.5 * (k * s10)
        z80 = (z79 - z77 * z38) / z39
        dydt: list[float] = [
            # x' (I.2.15)
            z40,
            # y' (I.2.15)
            z41,
            # theta1' (I.2.15)
            w,
            # theta2' (I.2.15)
            z46,
            # theta3' (I.2.15)
            -z53,
            # v' (I.2.15) 22:4
            z77 * z37 - z38 * z80,
            # w' (I.2.15) 22:4
            -z80,
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
        # parameters only
        k1 = 1.0 / a
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "velocities")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "velocities")
        c_theta1 = math.cos(theta1)
        z1 = c_theta1 * v
        s_theta1 = math.sin(theta1)
        z2 = s_theta1 * v
        c_theta2 = math.cos(theta2)
        z3 = z2 - a * (c_theta1 * w)
        s_theta2 = math.sin(theta2)
        z4 = z1 + a * (s_theta1 * w)
        z5 = k1 * (c_theta2 * z3 - s_theta2 * z4)
        c_theta3 = math.cos(theta3)
        z6 = a * (c_theta2 * z5)
        s_theta3 = math.sin(theta3)
        z7 = a * (s_theta2 * z5)
        s1 = c_theta3 * (z6 - (z3 - z6)) + s_theta3 * (z7 + (z4 + z7))
        qdot: list[float] = [
            # x' (I.2.4)
            z1,
            # y' (I.2.4)
            z2,
            # theta1' (I.2.4)
            w,
            # theta2' (I.2.4)
            z5,
            # theta3' (I.2.4)
            -k1 * s1,
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
        # parameters only
        k1 = 1.0 / a
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "accelerations")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "accelerations")
        c_theta1 = math.cos(theta1)
        s_theta1 = math.sin(theta1)
        c_theta2 = math.cos(theta2)
        s_theta2 = math.sin(theta2)
        z1 = c_theta2 * s_theta1 - c_theta1 * s_theta2
        z2 = k1 * z1
        c_theta3 = math.cos(theta3)
        z3 = a * (c_theta2 * z2)
        z4 = s_theta1 - z3
        z5 = z3 - z4
        s_theta3 = math.sin(theta3)
        z6 = a * (s_theta2 * z2)
        z7 = c_theta1 + z6
        z8 = z6 + z7
        z9 = c_theta3 * z5 + s_theta3 * z8
        z10 = k1 * z9
        s1 = c_theta1 * (m * c_theta1) + s_theta1 * (m * s_theta1)
        z11 = s1 + z2 * (J * z2) + z10 * (J * z10)
        z12 = z8 - a * (s_theta3 * z10)
        z13 = z5 - a * (c_theta3 * z10)
        s2 = z11 + z7 * (m * z7) + z4 * (m * z4) + z12 * (m * z12)
        z14 = s2 + z13 * (m * z13)
        # the mass matrix is singular
        if not abs(z14) > 0.0:
            raise SingularModelError(2, "accelerations")
        z15 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2
        z16 = k1 * z15
        z17 = J * z16
        z18 = c_theta2 * z16
        z19 = c_theta1 - z18
        z20 = z18 - z19
        z21 = s_theta2 * z16
        z22 = s_theta1 - z21
        z23 = z21 - z22
        z24 = c_theta3 * (a * z20) + s_theta3 * (a * z23)
        z25 = k1 * z24
        z26 = J * z25
        z27 = a * z22
        z28 = m * z27
        z29 = a * z19
        z30 = m * z29
        z31 = a * (z23 - s_theta3 * z25)
        z32 = m * z31
        z33 = a * (z20 - c_theta3 * z25)
        z34 = m * z33
        s3 = J + z16 * z17 + z25 * z26 + z27 * z28 + z29 * z30
        z35 = s3 + z31 * z32 + z33 * z34
        s4 = z2 * z17 + z10 * z26 - z7 * z28 + z4 * z30 + z12 * z32
        z36 = s4 + z13 * z34
        z37 = 1.0 / z14
        z38 = z36 * z37
        z39 = z35 - z36 * z38
        # the mass matrix is singular
        if not abs(z39) > 1e-14 * z35:
            raise SingularModelError(2, "accelerations")
        z40 = s_theta1 * w
        z41 = v * z40
        z42 = c_theta1 * w
        z43 = s_theta1 * v - a * z42
        z44 = c_theta1 * v + a * z40
        z45 = k1 * (c_theta2 * z43 - s_theta2 * z44)
        z46 = s_theta2 * z45
        z47 = z45 * z46
        z48 = z43 * z46
        z49 = v * z42
        z50 = w * z40
        z51 = z49 + a * z50
        z52 = c_theta2 * z45
        z53 = z44 * z52
        z54 = w * z42
        z55 = z41 - a * z54
        z56 = k1 * (z48 - c_theta2 * z51 + (z53 - s_theta2 * z55))
        z57 = a * (z47 + c_theta2 * z56)
        z58 = z51 + z57
        z59 = z57 + z58
        z60 = a * z52
        z61 = z60 - (z43 - z60)
        z62 = a * z46
        z63 = z62 + (z44 + z62)
        z64 = k1 * (c_theta3 * z61 + s_theta3 * z63)
        z65 = s_theta3 * z64
        z66 = z61 * z65
        z67 = c_theta3 * z64
        z68 = z63 * z67
        z69 = z45 * z52
        z70 = a * (z69 - s_theta2 * z56)
        z71 = z55 - z70
        z72 = z70 - z71
        z73 = k1 * (z66 - c_theta3 * z59 - (z68 - s_theta3 * z72))
        z74 = m * (z59 + a * (z64 * z65 + c_theta3 * z73))
        z75 = m * (z72 + a * (z64 * z67 - s_theta3 * z73))
        z76 = m * z58
        z77 = m * z71
        z78 = J * z73
        z79 = J * z56
        s5 = z2 * z79 + (c_theta1 * (m * z41) - s_theta1 * (m * z49))
        z80 = z7 * z77 - (z10 * z78 - s5)
        z81 = theta1 - theta2
        z82 = theta2 - theta3
        s6 = k * (2.0 * (z81 * z2) - 2.0 * (z82 * (k1 * (z1 + z9))))
        z83 = z13 * z74 - (z12 * z75 + (z4 * z76 - z80)) + 0.5 * s6
        s7 = z29 * z76 + (z27 * z77 - (z16 * z79 - z25 * z78))
        z84 = z33 * z74 - (z31 * z75 + s7)
        s8 = 2.0 * (z81 * (1.0 + z16)) - 2.0 * (z82 * (k1 * (z15 + z24)))
        z85 = z84 + 0.5 * (k * s8)
        z86 = (z85 - z83 * z38) / z39
        z87 = z83 * z37 - z38 * z86
        z88 = z41 - c_theta1 * z87
        z89 = z49 + s_theta1 * z87
        z90 = z89 + a * (z50 + c_theta1 * z86)
        z91 = z88 - a * (z54 - s_theta1 * z86)
        z92 = k1 * (z48 - c_theta2 * z90 + (z53 - s_theta2 * z91))
        z93 = a * (z47 + c_theta2 * z92)
        z94 = a * (z69 - s_theta2 * z92)
        s9 = z66 - c_theta3 * (z93 + (z90 + z93))
        qddot: list[float] = [
            # x'' (I.2.15)
            -z88,
            # y'' (I.2.15)
            z89,
            # theta1'' (I.2.15)
            -z86,
            # theta2'' (I.2.15)
            -z92,
            # theta3'' (I.2.15)
            -k1 * (s9 - (z68 - s_theta3 * (z94 - (z91 - z94)))),
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
        z1 = a * (theta2_dot * s_theta2)
        x2_dot = x_dot + a * (theta1_dot * s_theta1) + z1
        c_theta2 = math.cos(theta2)
        z2 = a * (theta2_dot * c_theta2)
        y2_dot = y_dot - a * (theta1_dot * c_theta1) - z2
        s_theta3 = math.sin(theta3)
        c_theta3 = math.cos(theta3)
        s1 = s_theta3 * (z1 + x2_dot + a * (theta3_dot * s_theta3))
        z3 = s1 + c_theta3 * (z2 - y2_dot + a * (theta3_dot * c_theta3))
        r: list[float] = [
            # wheel1 = 0 (I.1.1) 25:5
            y_dot * c_theta1 - x_dot * s_theta1,
            # wheel2 = 0 (I.1.1) 26:5
            c_theta2 * y2_dot - s_theta2 * x2_dot,
            # wheel3 = 0 (I.1.1) 27:5
            -z3,
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
        # parameters only
        k1 = 1.0 / a
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "reactions")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "reactions")
        c_theta1 = math.cos(theta1)
        z1 = m * c_theta1
        s_theta1 = math.sin(theta1)
        z2 = m * s_theta1
        c_theta2 = math.cos(theta2)
        s_theta2 = math.sin(theta2)
        z3 = c_theta2 * s_theta1 - c_theta1 * s_theta2
        z4 = k1 * z3
        z5 = J * z4
        c_theta3 = math.cos(theta3)
        z6 = a * (c_theta2 * z4)
        z7 = s_theta1 - z6
        z8 = z6 - z7
        s_theta3 = math.sin(theta3)
        z9 = a * (s_theta2 * z4)
        z10 = c_theta1 + z9
        z11 = z9 + z10
        z12 = c_theta3 * z8 + s_theta3 * z11
        z13 = k1 * z12
        z14 = J * z13
        z15 = m * z10
        z16 = m * z7
        s1 = c_theta1 * z1 + s_theta1 * z2 + z4 * z5 + z13 * z14
        z17 = s1 + z10 * z15 + z7 * z16
        z18 = z11 - a * (s_theta3 * z13)
        z19 = m * z18
        z20 = z8 - a * (c_theta3 * z13)
        z21 = m * z20
        z22 = z17 + z18 * z19 + z20 * z21
        # the mass matrix is singular
        if not abs(z22) > 0.0:
            raise SingularModelError(2, "reactions")
        z23 = a * c_theta1 * c_theta2 + a * s_theta1 * s_theta2
        z24 = k1 * z23
        z25 = J * z24
        z26 = c_theta2 * z24
        z27 = c_theta1 - z26
        z28 = z26 - z27
        z29 = s_theta2 * z24
        z30 = s_theta1 - z29
        z31 = z29 - z30
        z32 = c_theta3 * (a * z28) + s_theta3 * (a * z31)
        z33 = k1 * z32
        z34 = J * z33
        z35 = a * z30
        z36 = m * z35
        z37 = a * z27
        z38 = m * z37
        z39 = a * (z31 - s_theta3 * z33)
        z40 = m * z39
        z41 = a * (z28 - c_theta3 * z33)
        z42 = m * z41
        s2 = J + z24 * z25 + z33 * z34 + z35 * z36 + z37 * z38
        z43 = s2 + z39 * z40 + z41 * z42
        s3 = z4 * z25 + z13 * z34 - z10 * z36 + z7 * z38 + z18 * z40
        z44 = s3 + z20 * z42
        z45 = 1.0 / z22
        z46 = z44 * z45
        z47 = z43 - z44 * z46
        # the mass matrix is singular
        if not abs(z47) > 1e-14 * z43:
            raise SingularModelError(2, "reactions")
        z48 = c_theta1 * w
        z49 = s_theta1 * v - a * z48
        z50 = s_theta1 * w
        z51 = c_theta1 * v + a * z50
        z52 = k1 * (c_theta2 * z49 - s_theta2 * z51)
        z53 = s_theta2 * z52
        z54 = v * z48
        z55 = z54 + a * (w * z50)
        z56 = c_theta2 * z52
        z57 = v * z50
        z58 = z57 - a * (w * z48)
        s4 = z49 * z53 - c_theta2 * z55 + (z51 * z56 - s_theta2 * z58)
        z59 = k1 * s4
        z60 = a * (z52 * z53 + c_theta2 * z59)
        z61 = z55 + z60
        z62 = z60 + z61
        z63 = a * z56
        z64 = z63 - (z49 - z63)
        z65 = a * z53
        z66 = z65 + (z51 + z65)
        z67 = k1 * (c_theta3 * z64 + s_theta3 * z66)
        z68 = s_theta3 * z67
        z69 = c_theta3 * z67
        z70 = a * (z52 * z56 - s_theta2 * z59)
        z71 = z58 - z70
        z72 = z70 - z71
        s5 = z64 * z68 - c_theta3 * z62 - (z66 * z69 - s_theta3 * z72)
        z73 = k1 * s5
        z74 = m * (z62 + a * (z67 * z68 + c_theta3 * z73))
        z75 = c_theta1 * c_theta2 + s_theta1 * s_theta2
        z76 = k1 * z75
        z77 = a * (c_theta2 * z76)
        z78 = c_theta1 - z77
        z79 = z77 - z78
        z80 = a * (s_theta2 * z76)
        z81 = s_theta1 - z80
        z82 = z80 - z81
        z83 = c_theta3 * z79 + s_theta3 * z82
        z84 = k1 * z83
        z85 = z79 - a * (c_theta3 * z84)
        z86 = m * (z72 + a * (z67 * z69 - s_theta3 * z73))
        z87 = z82 - a * (s_theta3 * z84)
        z88 = m * z61
        z89 = m * z71
        z90 = J * z73
        z91 = J * z59
        z92 = m * z57
        z93 = m * z54
        s6 = z84 * z90 - (z76 * z91 - (s_theta1 * z92 + c_theta1 * z93))
        z94 = z78 * z88 + (z81 * z89 + s6)
        z95 = theta1 - theta2
        z96 = theta2 - theta3
        s7 = k * (2.0 * (z95 * z76) - 2.0 * (z96 * (k1 * (z75 + z83))))
        z97 = z74 * z85 - (z86 * z87 + z94) + 0.5 * s7
        s8 = s_theta1 * z1 - c_theta1 * z2 - z76 * z5 - z84 * z14
        z98 = s8 + z81 * z15 - z78 * z16
        s9 = z13 * z90 - (z4 * z91 + (c_theta1 * z92 - s_theta1 * z93))
        z99 = z7 * z88 - (z10 * z89 - s9)
        s10 = k * (2.0 * (z95 * z4) - 2.0 * (z96 * (k1 * (z3 + z12))))
        z100 = z20 * z74 - (z18 * z86 + z99) + 0.5 * s10
        s11 = z37 * z88 + (z35 * z89 - (z24 * z91 - z33 * z90))
        z101 = z41 * z74 - (z39 * z86 + s11)
        s12 = 2.0 * (z95 * (1.0 + z24)) - 2.0 * (z96 * (k1 * (z23 + z32)))
        z102 = z101 + 0.5 * (k * s12)
        z103 = (z102 - z100 * z46) / z47
        z104 = z100 * z45 - z46 * z103
        s13 = z76 * z25 + z84 * z34 + z81 * z36 + z78 * z38 + z40 * z87
        z105 = s13 + z42 * z85
        s14 = 2.0 * (c_theta2 * c_theta3) + 2.0 * (s_theta2 * s_theta3)
        z106 = k1 * s14
        z107 = 2.0 * c_theta2 - a * (c_theta3 * z106)
        z108 = 2.0 * s_theta2 - a * (s_theta3 * z106)
        s15 = c_theta2 * z88 + (s_theta2 * z89 + (k1 * z91 - z106 * z90))
        z109 = z74 * z107 - (z86 * z108 - s15)
        s16 = k1 * z5 + z106 * z14 + s_theta2 * z15 - c_theta2 * z16
        z110 = s16 + z19 * z108 + z21 * z107
        s17 = k1 * z25 + z106 * z34 - s_theta2 * z36 - c_theta2 * z38
        z111 = s17 + z40 * z108 + z42 * z107
        s18 = 0.5 * (k * (2.0 * (z95 * k1) - 2.0 * (z96 * (k1 + z106))))
        z112 = z109 + s18 - (z110 * z104 + z111 * z103)
        s19 = (k1 * z14 - s_theta3 * z19 - c_theta3 * z21) * z104
        z113 = s19 + (k1 * z34 - s_theta3 * z40 - c_theta3 * z42) * z103
        s20 = c_theta3 * z74 + (k1 * z90 - s_theta3 * z86)
        lambda_: list[float] = [
            # reaction of wheel1: Q_i gains lambda_1 a_1i (I.4.1) 25:5
            -(z97 + ((z98 - z19 * z87 - z21 * z85) * z104 - z105 * z103)),
            # reaction of wheel2: Q_i gains lambda_2 a_2i (I.4.1) 26:5
            z112,
            # reaction of wheel3: Q_i gains lambda_3 a_3i (I.4.1) 27:5
            s20 + k * (z96 * k1) + z113,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

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
        c_theta1 = math.cos(theta1)
        z3 = c_theta1 * v
        s_theta1 = math.sin(theta1)
        z4 = s_theta1 * v
        z5 = z3 + a * (s_theta1 * w)
        s_theta2 = math.sin(theta2)
        c_theta2 = math.cos(theta2)
        z6 = z4 - a * (c_theta1 * w)
        z7 = k1 * (c_theta2 * z6 - s_theta2 * z5)
        z8 = a * (s_theta2 * z7)
        x2_dot = z5 + z8
        z9 = a * (c_theta2 * z7)
        y2_dot = z6 - z9
        z10 = z8 + x2_dot
        s_theta3 = math.sin(theta3)
        c_theta3 = math.cos(theta3)
        z11 = z9 - y2_dot
        z12 = k1 * (c_theta3 * z11 + s_theta3 * z10)
        x3_dot = z10 - a * (s_theta3 * z12)
        z13 = z11 - a * (c_theta3 * z12)
        s1 = z3 * z3 + z4 * z4 + x2_dot * x2_dot + y2_dot * y2_dot
        z14 = s1 + x3_dot * x3_dot + z13 * z13
        s2 = 0.5 * (m * z14) + 0.5 * (J * (w * w + z7 * z7 + z12 * z12))
        z15 = 0.5 * (k * (z1 * z1 + z2 * z2)) + s2
        value1 = z15
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
        # parameters only
        k1 = 1.0 / a
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "jacobian")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "jacobian")
        c_theta1 = math.cos(theta1)
        z1 = m * c_theta1
        s_theta1 = math.sin(theta1)
        z2 = m * s_theta1
        c_theta2 = math.cos(theta2)
        s_theta2 = math.sin(theta2)
        z3 = c_theta2 * s_theta1 - c_theta1 * s_theta2
        z4 = k1 * z3
        z5 = J_2 * z4
        c_theta3 = math.cos(theta3)
        z6 = a * (c_theta2 * z4)
        z7 = s_theta1 - z6
        z8 = z6 - z7
        s_theta3 = math.sin(theta3)
        z9 = a * (s_theta2 * z4)
        z10 = c_theta1 + z9
        z11 = z9 + z10
        z12 = c_theta3 * z8 + s_theta3 * z11
        z13 = k1 * z12
        z14 = J_2 * z13
        z15 = m * z10
        z16 = m * z7
        s1 = c_theta1 * z1 + s_theta1 * z2 + z4 * z5 + z13 * z14
        z17 = s1 + z10 * z15 + z7 * z16
        z18 = z11 - a * (s_theta3 * z13)
        z19 = m * z18
        z20 = z8 - a * (c_theta3 * z13)
        z21 = m * z20
        z22 = z17 + z18 * z19 + z20 * z21
        # the mass matrix is singular
        if not abs(z22) > 0.0:
            raise SingularModelError(2, "jacobian")
        z23 = a * c_theta1
        z24 = a * s_theta1
        z25 = z23 * c_theta2 + z24 * s_theta2
        z26 = k1 * z25
        z27 = J_2 * z26
        z28 = c_theta2 * z26
        z29 = c_theta1 - z28
        z30 = z28 - z29
        z31 = a * z30
        z32 = s_theta2 * z26
        z33 = s_theta1 - z32
        z34 = z32 - z33
        z35 = a * z34
        z36 = c_theta3 * z31 + s_theta3 * z35
        z37 = k1 * z36
        z38 = J_2 * z37
        z39 = a * z33
        z40 = m * z39
        z41 = a * z29
        z42 = m * z41
        z43 = a * (z34 - s_theta3 * z37)
        z44 = m * z43
        z45 = a * (z30 - c_theta3 * z37)
        z46 = m * z45
        s2 = J_2 + z26 * z27 + z37 * z38 + z39 * z40 + z41 * z42
        z47 = s2 + z43 * z44 + z45 * z46
        s3 = z4 * z27 + z13 * z38 - z10 * z40 + z7 * z42 + z18 * z44
        z48 = s3 + z20 * z46
        z49 = 1.0 / z22
        z50 = z48 * z49
        z51 = z47 - z48 * z50
        # the mass matrix is singular
        if not abs(z51) > 1e-14 * z47:
            raise SingularModelError(2, "jacobian")
        z52 = s_theta1 * v
        z53 = c_theta1 * v
        z54 = c_theta2 * k1
        z55 = s_theta2 * k1
        z56 = s_theta1 * w
        z57 = z53 + a * z56
        z58 = c_theta1 * w
        z59 = z52 - a * z58
        s4 = 2.0 * (c_theta2 * c_theta3) + 2.0 * (s_theta2 * s_theta3)
        z60 = k1 * s4
        z61 = s_theta3 * k1 - s_theta2 * z60
        z62 = a * z61
        z63 = c_theta3 * k1 - c_theta2 * z60
        z64 = a * z63
        z65 = k1 * (c_theta2 * z59 - s_theta2 * z57)
        s5 = c_theta2 * (2.0 * (s_theta3 * z65) - z60 * z57)
        z66 = s5 - s_theta2 * (2.0 * (c_theta3 * z65) + z60 * z59)
        z67 = s_theta2 * z65
        z68 = a * z67
        z69 = z68 + (z57 + z68)
        z70 = c_theta2 * z65
        z71 = a * z70
        z72 = z71 - (z59 - z71)
        z73 = a * z21
        z74 = a * z19
        z75 = k1 * (z14 - c_theta3 * z73 - s_theta3 * z74)
        z76 = z19 + s_theta3 * z75
        z77 = z15 + z76
        z78 = a * (z76 + z77)
        z79 = z21 + c_theta3 * z75
        z80 = z16 - z79
        z81 = a * (z79 - z80)
        z82 = k1 * (z5 + s_theta2 * z78 + c_theta2 * z81)
        z83 = k1 * (c_theta3 * z72 + s_theta3 * z69)
        z84 = s_theta3 * z83
        z85 = c_theta3 * z83
        z86 = z83 * z74 - z69 * z75
        z87 = z83 * z73 - z72 * z75
        z88 = k1 * (z84 * z73 - z85 * z74 - c_theta3 * z86 + s_theta3 * z87)
        z89 = z84 * z75 - c_theta3 * z88
        z90 = z85 * z75 + s_theta3 * z88
        z91 = z65 * z81 + z59 * z82 + 2.0 * (a * z90)
        z92 = z65 * z78 - z57 * z82 + 2.0 * (a * z89)
        z93 = k1 * (z70 * z78 - z67 * z81 - s_theta2 * z91 + c_theta2 * z92)
        z94 = z67 * z82 + z89 - c_theta2 * z93
        z95 = z80 + c_theta2 * z82
        z96 = a * z95
        z97 = z77 - s_theta2 * z82
        z98 = z1 + z97
        z99 = z70 * z82 + z90 + s_theta2 * z93
        z100 = w * z96 - v * z98 - a * z99
        z101 = v * z58
        z102 = m * z101
        z103 = z101 + a * (w * z56)
        z104 = v * z56
        z105 = z104 - a * (w * z58)
        s6 = z59 * z67 - c_theta2 * z103 + (z57 * z70 - s_theta2 * z105)
        z106 = k1 * s6
        z107 = a * (z65 * z67 + c_theta2 * z106)
        z108 = z103 + z107
        z109 = z107 + z108
        z110 = a * (z65 * z70 - s_theta2 * z106)
        z111 = z105 - z110
        z112 = z110 - z111
        s7 = z72 * z84 - c_theta3 * z109 - (z69 * z85 - s_theta3 * z112)
        z113 = k1 * s7
        z114 = m * (z109 + a * (z83 * z84 + c_theta3 * z113))
        z115 = m * (z112 + a * (z83 * z85 - s_theta3 * z113))
        z116 = m * z108
        z117 = m * z111
        z118 = J_2 * z113
        z119 = J_2 * z106
        z120 = m * z104
        s8 = z13 * z118 - (z4 * z119 + (c_theta1 * z120 - s_theta1 * z102))
        z121 = z7 * z116 - (z10 * z117 - s8)
        z122 = theta1 - theta2
        z123 = theta2 - theta3
        z124 = z3 + z12
        z125 = k1 * z124
        s9 = 0.5 * (k * (2.0 * (z122 * z4) - 2.0 * (z123 * z125)))
        z126 = z20 * z114 - (z18 * z115 + z121) + s9
        z127 = 1.0 / z51
        s10 = z41 * z116 + (z39 * z117 - (z26 * z119 - z37 * z118))
        z128 = z45 * z114 - (z43 * z115 + s10)
        z129 = 1.0 + z26
        z130 = k1 * (z25 + z36)
        s11 = 0.5 * (k * (2.0 * (z122 * z129) - 2.0 * (z123 * z130)))
        z131 = z127 * (z128 + s11 - z126 * z50)
        z132 = z126 * z49 - z50 * z131
        z133 = m * (z18 * z131)
        z134 = m * (z20 * z131)
        z135 = a * z134
        z136 = a * z133
        z137 = k1 * (J_2 * (z13 * z131) - c_theta3 * z135 - s_theta3 * z136)
        z138 = z133 + s_theta3 * z137
        z139 = m * (z10 * z131) + z138
        z140 = z116 + z42 * z131
        z141 = z7 * z132
        z142 = z114 - z46 * z131
        z143 = z20 * z132
        z144 = z142 - z21 * z132 - m * z143
        z145 = k * z123
        z146 = z118 + z38 * z131
        z147 = z13 * z132
        z148 = a * z144
        z149 = z115 + z44 * z131
        z150 = z18 * z132
        z151 = z149 + z19 * z132 + m * z150
        z152 = a * z151
        s12 = z146 + z14 * z132 + J_2 * z147 + c_theta3 * z148
        z153 = k1 * (z145 + (s12 - s_theta3 * z152))
        z154 = z144 - c_theta3 * z153
        z155 = z140 + z16 * z132 + m * z141 + z154
        z156 = z119 + k * z122 - z27 * z131
        z157 = z4 * z132
        z158 = z151 + s_theta3 * z153
        z159 = z117 + z40 * z131
        z160 = z10 * z132
        z161 = z159 - z15 * z132 - m * z160 - z158
        z162 = a * (z158 - z161)
        z163 = a * (z154 + z155)
        s13 = z156 - z5 * z132 - J_2 * z157 - s_theta2 * z162
        z164 = k1 * (z145 - (s13 + c_theta2 * z163))
        s14 = z102 + z2 * z132 + m * (s_theta1 * z132) - a * z139 + z155
        z165 = w * z100 + (s14 + c_theta2 * z164)
        z166 = a * (z138 + z139)
        z167 = z134 + c_theta3 * z137
        z168 = m * (z7 * z131) - z167
        z169 = a * (z167 - z168)
        z170 = k1 * (J_2 * (z4 * z131) + s_theta2 * z166 + c_theta2 * z169)
        z171 = a * z97
        z172 = z2 + z95
        z173 = w * z171 + v * z172 + a * z94
        s15 = z120 - z1 * z132 - m * (c_theta1 * z132) - a * z168 + z161
        z174 = w * z173 - (s15 + s_theta2 * z164)
        s16 = k * z4 + c_theta1 * (v * z94 - z165 - a * (s_theta2 * z170))
        z175 = s16 - s_theta1 * (v * z99 - z174 - a * (c_theta2 * z170))
        z176 = a * z46
        z177 = a * z44
        z178 = k1 * (z38 - c_theta3 * z176 - s_theta3 * z177)
        z179 = z44 + s_theta3 * z178
        z180 = z40 - z179
        z181 = a * (z179 - z180)
        z182 = z46 + c_theta3 * z178
        z183 = z42 - z182
        z184 = a * (z182 - z183)
        z185 = k1 * (z27 + s_theta2 * z181 + c_theta2 * z184)
        z186 = z83 * z177 - z69 * z178
        z187 = z83 * z176 - z72 * z178
        s17 = z84 * z176 - z85 * z177 - c_theta3 * z186 + s_theta3 * z187
        z188 = k1 * s17
        z189 = z84 * z178 - c_theta3 * z188
        z190 = z85 * z178 + s_theta3 * z188
        z191 = z65 * z184 + z59 * z185 + 2.0 * (a * z190)
        z192 = z65 * z181 - z57 * z185 + 2.0 * (a * z189)
        s18 = z70 * z181 - z67 * z184 - s_theta2 * z191 + c_theta2 * z192
        z193 = k1 * s18
        z194 = z67 * z185 + z189 - c_theta2 * z193
        z195 = z183 + c_theta2 * z185
        z196 = a * z195
        z197 = z180 + s_theta2 * z185
        z198 = z70 * z185 + z190 + s_theta2 * z193
        z199 = w * z196 + v * z197 - a * z198
        z200 = z149 + m * (z150 + z43 * z131)
        z201 = z142 - m * (z143 + z45 * z131)
        z202 = a * z201
        z203 = a * z200
        s19 = z146 + J_2 * (z147 + z37 * z131) + c_theta3 * z202
        z204 = k1 * (z145 + (s19 - s_theta3 * z203))
        z205 = z200 + s_theta3 * z204
        z206 = z159 - m * (z160 - z39 * z131) - z205
        z207 = z46 * z132
        z208 = a * z207
        z209 = z44 * z132
        z210 = a * z209
        z211 = k1 * (z38 * z132 - c_theta3 * z208 - s_theta3 * z210)
        z212 = z207 + c_theta3 * z211
        z213 = z42 * z132 - z212
        z214 = z209 + s_theta3 * z211
        z215 = z40 * z132 - z214
        z216 = a * (z214 - z215)
        z217 = a * (z212 - z213)
        z218 = k1 * (z27 * z132 + s_theta2 * z216 + c_theta2 * z217)
        z219 = a * (z205 - z206)
        z220 = z201 - c_theta3 * z204
        z221 = z140 + m * (z141 + z41 * z131) + z220
        z222 = a * (z220 + z221)
        s20 = z156 - J_2 * (z157 + z26 * z131) - s_theta2 * z219
        z223 = k1 * (z145 - (s20 + c_theta2 * z222))
        s21 = v * z194 - (w * z199 + (a * z206 + z213 + c_theta2 * z218))
        z224 = s21 - a * (s_theta2 * z223)
        z225 = a * z197
        z226 = w * z225 - v * z195 - a * z194
        s22 = v * z198 + (w * z226 - (a * z221 - z215 - s_theta2 * z218))
        z227 = s22 - a * (c_theta2 * z223)
        s23 = k * z129 + c_theta1 * z224 - s_theta1 * z227 - z50 * z175
        z228 = z127 * s23
        s24 = z106 * z78 - z105 * z82 + z65 * z91 + z57 * z93 - z26 * z166
        z229 = s24 - z24 * z170
        s25 = z106 * z81 - z103 * z82 - z65 * z92 - z59 * z93 - z26 * z169
        z230 = s25 - z23 * z170
        s26 = c_theta2 * (z229 - z4 * z162 + c_theta1 * z164)
        s27 = s_theta2 * (z230 + z4 * z163 - s_theta1 * z164)
        z231 = k * (k1 * (z3 + z124)) - s26 + s27
        s28 = z106 * z181 - z105 * z185 + z65 * z191 + z57 * z193
        z232 = s28 - z26 * z219 - z24 * z223
        s29 = z106 * z184 - z103 * z185 - z65 * z192 - z59 * z193
        z233 = s29 + z26 * z222 - z23 * z223
        s30 = c_theta2 * (z232 - z4 * z216 + c_theta1 * z218)
        s31 = s_theta2 * (z233 - z4 * z217 - s_theta1 * z218)
        z234 = k * (z129 + z130) - s30 + s31
        z235 = z127 * (z234 - z50 * z231)
        s32 = z113 * z74 - z112 * z75 + z37 * z136 + z13 * z152
        z236 = z69 * z88 + (z83 * z87 + s32)
        s33 = z113 * z73 + z109 * z75 + z37 * z135 - z13 * z148
        z237 = z72 * z88 - (z83 * z86 - s33)
        s34 = k * z125 + c_theta3 * (z236 - z35 * z137 - z11 * z153)
        z238 = s34 - s_theta3 * (z237 - z31 * z137 - z8 * z153)
        s35 = z113 * z177 - z112 * z178 + z37 * z203 + z13 * z210
        z239 = z69 * z188 + (z83 * z187 + s35)
        s36 = z113 * z176 + z109 * z178 - z37 * z202 + z13 * z208
        z240 = z72 * z188 - (z83 * z186 - s36)
        s37 = k * z130 + c_theta3 * (z239 - z35 * z204 - z11 * z211)
        z241 = s37 - s_theta3 * (z240 - z31 * z204 - z8 * z211)
        z242 = z127 * (z241 - z50 * z238)
        z243 = z58 * z172 - z56 * z98 - s_theta1 * z94 - c_theta1 * z99
        s38 = z58 * z195 + z56 * z197 - s_theta1 * z194 - c_theta1 * z198
        z244 = z127 * (s38 - z50 * z243)
        z245 = z58 * z171 + z56 * z96 + s_theta1 * z100 + c_theta1 * z173
        s39 = z58 * z225 - z56 * z196 - s_theta1 * z199 + c_theta1 * z226
        z246 = z127 * (s39 + z50 * z245)
        s40 = s_theta1 * (c_theta2 * w + v * z55)
        s41 = s_theta1 * (w * z64 + v * z61)
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z52,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_theta1,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z53,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta1,
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
            s40 - c_theta1 * (s_theta2 * w - v * z54),
            # (I.2.15)
            -(c_theta2 * (k1 * z57) + s_theta2 * (k1 * z59)),
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_theta1 * z54 - c_theta1 * z55,
            # (I.2.15)
            -(c_theta1 * c_theta2 + s_theta1 * s_theta2),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s41 - c_theta1 * (w * z62 - v * z63),
            # (I.2.15)
            -z66,
            # (I.2.15)
            s_theta3 * (k1 * z72) - c_theta3 * (k1 * z69),
            # (I.2.15)
            s_theta1 * z63 - c_theta1 * z61,
            # (I.2.15)
            -(s_theta1 * z62 + c_theta1 * z64),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z49 * z175 - z50 * z228,
            # (I.2.15)
            z50 * z235 - z49 * z231,
            # (I.2.15)
            z49 * z238 - z50 * z242,
            # (I.2.15)
            z50 * z244 - z49 * z243,
            # (I.2.15)
            -(z49 * z245 + z50 * z246),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z228,
            # (I.2.15)
            z235,
            # (I.2.15)
            -z242,
            # (I.2.15)
            z244,
            # (I.2.15)
            -z246,
        ]
        _finish("jacobian", J)
        return [J[k2 : k2 + 7] for k2 in range(0, 49, 7)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (7,), p (4,).
    Returns out (0,).
    """
    a = float(p[2])  # half the length of a link [m]
    try:
        # state
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "outputs")
        # the coframe is singular
        if not abs(-a) > 0.0:
            raise SingularModelError(1, "outputs")
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
