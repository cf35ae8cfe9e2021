"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:afec02760c57712f).

A ball with three different moments of inertia rolls on a horizontal plane; its
    orientation is a quaternion.
Source: chaplygin_ball_quaternion.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: angular velocities and quasi-velocities of the spec

State y:
y[0] = x [m]: centre
y[1] = y [m]: centre
y[2] = R_0 [1]: quaternion of R, scalar part
y[3] = R_1 [1]: quaternion of R, along x
y[4] = R_2 [1]: quaternion of R, along y
y[5] = R_3 [1]: quaternion of R, along z
y[6] = w1
y[7] = w2
y[8] = w3

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: a = 1.0 [m]: radius
p[2]: I1 = 0.4 [kg*m^2]
p[3]: I2 = 0.5 [kg*m^2]
p[4]: I3 = 0.7 [kg*m^2]

Constraints:
0: roll_x
1: roll_y
2: R_norm

Outputs:
out[0] = K_x
out[1] = K_y
out[2] = K_z

Operations:
rhs: 53 +-, 110 *, 4 /, 0 calls
velocities: 23 +-, 47 *, 1 /, 0 calls
accelerations: 85 +-, 176 *, 4 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 29 +-, 50 *, 1 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 53 +-, 110 *, 4 /, 0 calls
energy: 19 +-, 41 *, 1 /, 0 calls
jacobian: 213 +-, 485 *, 4 /, 0 calls
outputs: 26 +-, 44 *, 1 /, 0 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "R_0", "R_1", "R_2", "R_3")
STATE: tuple[str, ...] = ("x", "y", "R_0", "R_1", "R_2", "R_3", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("m", "a", "I1", "I2", "I3")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y", "R_norm")
OUTPUTS: tuple[str, ...] = ("K_x", "K_y", "K_z")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 0.4, 0.5, 0.7)

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


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (9,), p (5,).
    Returns dydt (9,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * a * a
        k2 = a * (m * a)
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # state
        z1 = R_3 * R_3
        z2 = R_2 * R_2
        z3 = R_1 * R_1
        z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)))
        z5 = R_1 * z4
        z6 = R_2 * z5
        z7 = R_0 * z4
        z8 = R_3 * z7
        z9 = z6 + z8
        z10 = R_2 * z4
        z11 = R_3 * z4
        z12 = R_3 * z11
        R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12)
        z13 = I1 + k2 * (4.0 * (z9 * z9) + R_x1 * R_x1)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "rhs")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + k2 * (R_y2 * R_y2 + 4.0 * (z14 * z14))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = 4.0 * (R_1 * z8)
        s1 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18)
        z19 = s1 + 4.0 * (z2 * z8)
        z20 = z16 * z19
        z21 = 1.0 / z13
        z22 = z21 * z20
        z23 = z15 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z15:
            raise SingularModelError(2, "rhs")
        z24 = R_3 * z10 - R_1 * z7
        z25 = R_1 * z11 + R_2 * z7
        z26 = I3 + 4.0 * (k2 * (z24 * z24 + z25 * z25))
        z27 = 2.0 - 4.0 * (z4 * z17)
        z28 = R_3 * (2.0 - 4.0 * (z1 * z4))
        z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28)
        z30 = z21 * z29
        s2 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28)
        z31 = s2 + z20 * z30
        z32 = 1.0 / z23
        z33 = z31 * z32
        z34 = z26 - z29 * z30 - z31 * z33
        # the mass matrix is singular
        if not abs(z34) > 1e-14 * z26:
            raise SingularModelError(2, "rhs")
        z35 = w2 * w3 * k3
        z36 = w1 * w3 * k4 + z35 * z22
        z37 = (w1 * w2 * k5 - z35 * z30 - z33 * z36) / z34
        z38 = z32 * z36 - z33 * z37
        dydt: list[float] = [
            # x' (I.2.15)
            a * (2.0 * (z24 * w3) + (R_y2 * w2 + 2.0 * (z9 * w1))),
            # y' (I.2.15)
            -a * (2.0 * (z25 * w3) + (2.0 * (z14 * w2) + R_x1 * w1)),
            # R_0' (I.2.15)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.15)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.15)
            (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5,
            # R_3' (I.2.15)
            0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)),
            # w1' (I.2.15) 21:4
            z35 * z21 + z22 * z38 - z30 * z37,
            # w2' (I.2.15) 21:4
            -z38,
            # w3' (I.2.15) 21:4
            z37,
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

    Arguments: t (scalar), y (9,), p (5,).
    Returns qdot (6,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[1])  # radius [m]
    try:
        # state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_2 * z1
        z3 = R_0 * z1
        z4 = R_1 * z1
        z5 = R_3 * z1
        z6 = R_3 * z5
        z7 = R_2 * z4
        z8 = R_3 * z3
        s1 = (1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 * ((z7 + z8) * w1)
        omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + s1
        s2 = 2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 * z2 + z6)) * w1
        omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + s2
        qdot: list[float] = [
            # x' (I.2.4)
            a * omega_y,
            # y' (I.2.4)
            -a * omega_x,
            # R_0' (I.2.4)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.4)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.4)
            (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5,
            # R_3' (I.2.4)
            0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)),
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

    Arguments: t (scalar), y (9,), p (5,).
    Returns qddot (6,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * a * a
        k2 = a * (m * a)
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # state
        z1 = R_3 * R_3
        z2 = R_2 * R_2
        z3 = R_1 * R_1
        z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)))
        z5 = R_1 * z4
        z6 = R_2 * z5
        z7 = R_0 * z4
        z8 = R_3 * z7
        z9 = z6 + z8
        z10 = R_2 * z4
        z11 = R_3 * z4
        z12 = R_3 * z11
        R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12)
        z13 = I1 + (4.0 * (k2 * (z9 * z9)) + k2 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "accelerations")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = 4.0 * (R_1 * z8)
        s1 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18)
        z19 = s1 + 4.0 * (z2 * z8)
        z20 = z16 * z19
        z21 = 1.0 / z13
        z22 = z21 * z20
        z23 = z15 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z15:
            raise SingularModelError(2, "accelerations")
        z24 = R_3 * z10 - R_1 * z7
        z25 = R_1 * z11 + R_2 * z7
        z26 = I3 + 4.0 * (k2 * (z24 * z24 + z25 * z25))
        z27 = 2.0 - 4.0 * (z4 * z17)
        z28 = R_3 * (2.0 - 4.0 * (z1 * z4))
        z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28)
        z30 = z21 * z29
        s2 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28)
        z31 = s2 + z20 * z30
        z32 = 1.0 / z23
        z33 = z31 * z32
        z34 = z26 - z29 * z30 - z31 * z33
        # the mass matrix is singular
        if not abs(z34) > 1e-14 * z26:
            raise SingularModelError(2, "accelerations")
        z35 = w2 * w3 * k3
        z36 = w1 * w3 * k4 + z35 * z22
        z37 = (w1 * w2 * k5 - z35 * z30 - z33 * z36) / z34
        z38 = z32 * z36 - z33 * z37
        z39 = z35 * z21 + z22 * z38 - z30 * z37
        s3 = 2.0 * (0.5 * (w1 * (R_y2 * w3 - 2.0 * (z24 * w2))) + z9 * z39)
        z40 = 2.0 * (w2 * (z24 * w1 - z9 * w3)) - R_y2 * z38 + s3
        s4 = 2.0 * (0.5 * (w3 * (2.0 * (z9 * w2) - R_y2 * w1)) + z24 * z37)
        z41 = a * (s4 + z40)
        s5 = 0.5 * (w2 * (2.0 * (z25 * w1) - R_x1 * w3)) - z14 * z38
        z42 = 2.0 * s5 + (2.0 * (w1 * (z14 * w3 - z25 * w2)) + R_x1 * z39)
        s6 = 0.5 * (w3 * (R_x1 * w2 - 2.0 * (z14 * w1))) + z25 * z37
        z43 = a * (2.0 * s6 + z42)
        z44 = R_0 * w3 - (R_2 * w1 - R_1 * w2)
        z45 = R_2 * w3 + (R_0 * w1 - R_3 * w2)
        z46 = R_1 * w3 - (R_3 * w1 + R_0 * w2)
        s7 = 0.5 * (w1 * z45) + R_1 * z39 - (0.5 * (w2 * z46) + R_2 * z38)
        z47 = 0.5 * (w3 * z44) + R_3 * z37 + s7
        z48 = R_3 * w3 + (R_1 * w1 + R_2 * w2)
        s8 = 0.5 * (w1 * z48) - R_0 * z39 + (0.5 * (w2 * z44) - R_3 * z38)
        z49 = 0.5 * (w3 * z46) - R_2 * z37 + s8
        s9 = 0.5 * (w1 * z44) + R_3 * z39 - (0.5 * (w2 * z48) + R_0 * z38)
        z50 = 0.5 * (w3 * z45) + R_1 * z37 - s9
        s10 = 0.5 * (w1 * z46) - R_2 * z39 + (0.5 * (w2 * z45) - R_1 * z38)
        z51 = 0.5 * (w3 * z48) - R_0 * z37 - s10
        qddot: list[float] = [
            # x'' (I.2.15)
            z41,
            # y'' (I.2.15)
            -z43,
            # R_0'' (I.2.15)
            -0.5 * z47,
            # R_1'' (I.2.15)
            -0.5 * z49,
            # R_2'' (I.2.15)
            -0.5 * z50,
            # R_3'' (I.2.15)
            -0.5 * z51,
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
    Returns y (9,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # centre [m]
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    R_0_dot = float(qdot[2])
    R_1_dot = float(qdot[3])
    R_2_dot = float(qdot[4])
    R_3_dot = float(qdot[5])
    try:
        # state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_0 * z1
        z3 = R_1 * z1
        z4 = R_3 * z1
        z5 = R_2 * z1
        s1 = R_1_dot * z2 - R_0_dot * z3 + (R_2_dot * z4 - R_3_dot * z5)
        s2 = R_2_dot * z2 - R_0_dot * z5 + (R_3_dot * z3 - R_1_dot * z4)
        s3 = R_3_dot * z2 - R_0_dot * z4 + (R_1_dot * z5 - R_2_dot * z3)
        y: list[float] = [x, y_2, R_0, R_1, R_2, R_3, 2.0 * s1, 2.0 * s2, 2.0 * s3]
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
    Returns r (3,).
    """
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    R_0_dot = float(qdot[2])
    R_1_dot = float(qdot[3])
    R_2_dot = float(qdot[4])
    R_3_dot = float(qdot[5])
    a = float(p[1])  # radius [m]
    try:
        # state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_0 * z1
        z3 = R_1 * z1
        z4 = R_3 * z1
        z5 = R_2 * z1
        z6 = R_1_dot * z2 - R_0_dot * z3 + (R_2_dot * z4 - R_3_dot * z5)
        z7 = R_2 * z3
        z8 = R_3 * z2
        z9 = R_2_dot * z2 - R_0_dot * z5 + (R_3_dot * z3 - R_1_dot * z4)
        z10 = R_3 * z4
        z11 = R_3_dot * z2 - R_0_dot * z4 + (R_1_dot * z5 - R_2_dot * z3)
        s1 = 2.0 * (z9 * (1.0 - 2.0 * (R_1 * z3 + z10)))
        s2 = 4.0 * ((R_3 * z5 - R_1 * z2) * z11)
        omega_y = 4.0 * (z6 * (z7 + z8)) + s1 + s2
        s3 = 2.0 * (z6 * (1.0 - 2.0 * (R_2 * z5 + z10)))
        s4 = 4.0 * ((R_1 * z4 + R_2 * z2) * z11)
        omega_x = s3 + 4.0 * (z9 * (z7 - z8)) + s4
        s5 = R_2 * R_2_dot + (R_0 * R_0_dot + R_1 * R_1_dot)
        r: list[float] = [
            # roll_x = 0 (I.1.1) 23:5
            x_dot - a * omega_y,
            # roll_y = 0 (I.1.1) 24:5
            y_dot + a * omega_x,
            # R_norm = 0 (I.1.1) 10:3
            2.0 * (R_3 * R_3_dot + s5),
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def positions(
    t: float,
    q: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """residuals of the holonomic constraints at position level

    Arguments: t (scalar), q (6,), p (5,).
    Returns f (1,).
    """
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    try:
        # state
        f: list[float] = [
            # R_norm = 0 10:3
            R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)) - 1.0,
        ]
        return _finish("positions", f)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "positions") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (9,), p (5,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * a * a
        k2 = m * a
        k3 = a * k2
        k4 = I2 - I3
        k5 = I1 - I3
        k6 = I1 - I2
        # state
        z1 = R_3 * R_3
        z2 = R_2 * R_2
        z3 = R_1 * R_1
        z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)))
        z5 = R_1 * z4
        z6 = R_2 * z5
        z7 = R_0 * z4
        z8 = R_3 * z7
        z9 = z6 + z8
        z10 = R_2 * z4
        z11 = R_3 * z4
        z12 = R_3 * z11
        R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12)
        z13 = I1 + (4.0 * (k3 * (z9 * z9)) + k3 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "reactions")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k3 * (R_y2 * R_y2) + 4.0 * (k3 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = R_0 * R_1
        z19 = 4.0 * (z11 * z18)
        s1 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z19)
        z20 = s1 + 4.0 * (z2 * (R_0 * z11))
        z21 = z16 * z20
        z22 = 1.0 / z13
        z23 = z22 * z21
        z24 = z15 - z21 * z23
        # the mass matrix is singular
        if not abs(z24) > 1e-14 * z15:
            raise SingularModelError(2, "reactions")
        z25 = R_3 * z10 - R_1 * z7
        z26 = R_1 * z11 + R_2 * z7
        z27 = I3 + 4.0 * (k3 * (z25 * z25 + z26 * z26))
        z28 = R_1 * R_3
        z29 = 2.0 - 4.0 * (z1 * z4)
        z30 = 2.0 - 4.0 * (z4 * z17)
        z31 = z16 * (z28 * z29 + R_0 * (R_2 * z30 - z19))
        z32 = z22 * z31
        z33 = R_2 * R_3
        z34 = R_0 * R_2
        s2 = z16 * (z29 * z33 - R_0 * (R_1 * z30 + 4.0 * (z11 * z34)))
        z35 = s2 - z21 * z32
        z36 = 1.0 / z24
        z37 = z35 * z36
        z38 = z27 - z31 * z32 - z35 * z37
        # the mass matrix is singular
        if not abs(z38) > 1e-14 * z27:
            raise SingularModelError(2, "reactions")
        z39 = z4 * k2
        z40 = w2 * w3 * k4
        z41 = w1 * w3 * k5 + z40 * z23
        z42 = (w1 * w2 * k6 - z40 * z32 + z37 * z41) / z38
        z43 = z39 * z42
        z44 = R_0 * R_3
        z45 = R_1 * R_2
        z46 = z36 * z41 + z37 * z42
        z47 = z40 * z22 + z23 * z46 - z32 * z42
        s3 = k2 * ((1.0 - 2.0 * (z4 * (z3 + z1))) * z46)
        z48 = 2.0 * ((z44 + z45) * (z39 * z47)) - s3
        s4 = k2 * ((1.0 - 2.0 * (z4 * (z2 + z1))) * z47)
        z49 = s4 + 2.0 * ((z44 - z45) * (z39 * z46))
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 23:5
            z48 - 2.0 * ((z18 - z33) * z43),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 24:5
            -(2.0 * ((z28 + z34) * z43) + z49),
            # reaction of R_norm: Q_i gains lambda_3 a_3i (I.4.1) 10:3
            0.0,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

    Arguments: t (scalar), y (9,), p (5,).
    Returns a scalar.
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_2 * z1
        z3 = R_0 * z1
        z4 = R_1 * z1
        z5 = R_3 * z1
        z6 = R_3 * z5
        z7 = R_2 * z4
        z8 = R_3 * z3
        s1 = (1.0 - 2.0 * (R_1 * z4 + z6)) * w2 + 2.0 * ((z7 + z8) * w1)
        omega_y = 2.0 * ((R_3 * z2 - R_1 * z3) * w3) + s1
        z9 = a * omega_y
        s2 = 2.0 * ((z7 - z8) * w2) + (1.0 - 2.0 * (R_2 * z2 + z6)) * w1
        omega_x = 2.0 * ((R_1 * z5 + R_2 * z3) * w3) + s2
        z10 = a * omega_x
        s3 = I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3)
        z11 = m * (z9 * z9 + z10 * z10) + s3
        value1 = 0.5 * z11
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (9,), p (5,).
    Returns rows (9, 9): d rhs_i / d y_j stands at [i][j].
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * a * a
        k2 = a * (m * a)
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # state
        z1 = R_3 * R_3
        z2 = R_2 * R_2
        z3 = R_1 * R_1
        z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)))
        z5 = R_1 * z4
        z6 = R_2 * z5
        z7 = R_0 * z4
        z8 = R_3 * z7
        z9 = z6 + z8
        z10 = R_2 * z4
        z11 = R_3 * z4
        z12 = R_3 * z11
        R_x1 = 1.0 - 2.0 * (R_2 * z10 + z12)
        z13 = I1 + (4.0 * (k2 * (z9 * z9)) + k2 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "jacobian")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = 8.0 * z1 + 4.0 * z17
        z19 = 4.0 - z4 * z18
        z20 = R_0 * R_1
        z21 = R_3 * z20
        z22 = 4.0 * (z4 * z21)
        z23 = R_2 * z19 - z22
        z24 = R_0 * z2
        z25 = R_3 * z24
        z26 = R_1 * z23 + 4.0 * (z4 * z25)
        z27 = z16 * z26
        z28 = 1.0 / z13
        z29 = z27 * z28
        z30 = z15 - z27 * z29
        # the mass matrix is singular
        if not abs(z30) > 1e-14 * z15:
            raise SingularModelError(2, "jacobian")
        z31 = R_3 * z10 - R_1 * z7
        z32 = R_1 * z11 + R_2 * z7
        z33 = I3 + 4.0 * (k2 * (z31 * z31 + z32 * z32))
        z34 = 2.0 - 4.0 * (z4 * z17)
        z35 = z22 - R_2 * z34
        z36 = R_1 * R_3
        z37 = 2.0 - 4.0 * (z1 * z4)
        z38 = R_0 * z35 - z36 * z37
        z39 = z16 * z38
        z40 = z39 * z28
        z41 = R_0 * R_2
        z42 = R_3 * z41
        z43 = R_1 * z34 + 4.0 * (z4 * z42)
        z44 = R_2 * R_3
        z45 = R_0 * z43 - z37 * z44
        z46 = z16 * z45 - z27 * z40
        z47 = 1.0 / z30
        z48 = z46 * z47
        z49 = z33 - z39 * z40 - z46 * z48
        # the mass matrix is singular
        if not abs(z49) > 1e-14 * z33:
            raise SingularModelError(2, "jacobian")
        z50 = a * w1
        z51 = a * w3
        z52 = R_3 * z50 - R_1 * z51
        z53 = z4 * z52
        z54 = z4 * z4
        z55 = a * w2
        z56 = R_3 * z55
        z57 = R_3 * z51
        z58 = R_2 * z50
        z59 = z58 - R_1 * z55
        z60 = z54 * (R_3 * z56 - R_2 * z57 - R_1 * z59 - R_0 * z52)
        z61 = z7 * z51 + z5 * z55
        s1 = 2.0 * (z7 * z50 + z10 * z51 - z11 * z55 - z4 * z56)
        z62 = s1 + 4.0 * (R_3 * z60)
        z63 = z56 - R_2 * z51
        z64 = R_2 * z55
        z65 = z54 * (R_3 * z52 + R_2 * z58 - R_1 * z64 + R_0 * z63)
        z66 = 0.5 * w1
        z67 = 0.5 * w2
        z68 = 0.5 * w3
        z69 = 0.5 * R_1
        z70 = 0.5 * R_2
        z71 = 0.5 * R_3
        z72 = 0.5 * R_0
        z73 = 1.0 / z49
        z74 = w1 * k5
        z75 = w2 * k3
        z76 = w3 * z75
        z77 = w1 * k4
        z78 = w3 * z77 + z29 * z76
        z79 = z73 * (w2 * z74 + z40 * z76 - z48 * z78)
        z80 = z16 * z79
        z81 = z47 * z78 - z48 * z79
        z82 = z16 * z81
        z83 = z4 * z82
        z84 = R_3 * z83
        z85 = R_0 * z80
        z86 = R_1 * z82
        z87 = z85 - z86
        z88 = z4 * z87
        z89 = R_3 * z88
        z90 = z28 * z76 + z29 * z81 + z40 * z79
        z91 = k2 * z90
        z92 = z9 * z91
        z93 = R_3 * z92
        z94 = z36 * z80
        z95 = R_2 * z86
        s2 = 4.0 * (z1 * z94 + z85 * (R_2 * z17) + z25 * z82 + z21 * z87)
        z96 = s2 - z18 * z95
        z97 = R_x1 * z91
        z98 = R_3 * z97
        z99 = R_2 * z97
        s3 = z96 + k1 * (z38 * z79 + z26 * z81) + 4.0 * (R_3 * z98)
        z100 = s3 + 4.0 * (R_2 * z99)
        z101 = R_2 * z92
        z102 = z54 * (z100 - 8.0 * (R_1 * z101) - 8.0 * (R_0 * z93))
        s4 = z35 * z80 + 4.0 * (z2 * z84) + 4.0 * (R_1 * z89)
        z103 = s4 - 8.0 * (z4 * z93) - 2.0 * (R_0 * z102)
        z104 = z4 * z85
        z105 = R_3 * z104
        z106 = z16 * z90
        z107 = z4 * z106
        z108 = R_3 * z107
        z109 = R_1 * z106
        z110 = z4 * z109
        z111 = R_3 * z110
        z112 = k2 * z81
        z113 = z14 * z112
        z114 = R_3 * z113
        s5 = z43 * z80 + 4.0 * (R_2 * z105) - 4.0 * (z2 * z108)
        z115 = s5 + 4.0 * (R_1 * z111) - 8.0 * (z4 * z114)
        z116 = z44 * z80
        z117 = R_1 * z85
        z118 = R_2 * z109
        s6 = z42 * z85 + z1 * z116 - z17 * z117 - z25 * z106 + z21 * z109
        z119 = 4.0 * s6 + z18 * z118
        z120 = R_y2 * z112
        z121 = R_3 * z120
        z122 = 8.0 * (R_2 * z113) - 4.0 * (R_1 * z120)
        s7 = z119 + k1 * (z45 * z79 - z26 * z90) - 4.0 * (R_3 * z121)
        z123 = s7 + R_1 * z122 - 8.0 * (R_0 * z114)
        z124 = z54 * z123
        z125 = z115 - 2.0 * (R_0 * z124) - z29 * z103
        z126 = R_0 * z82
        z127 = z4 * z126
        z128 = R_3 * z127
        z129 = R_0 * z106
        z130 = z4 * z129
        z131 = R_3 * z130
        z132 = k2 * z79
        z133 = z32 * z132
        z134 = z31 * z132
        z135 = R_2 * z133 - R_1 * z134
        s8 = z43 * z82 + 4.0 * (R_2 * z128) - z35 * z106
        z136 = s8 - 4.0 * (R_1 * z131) + 8.0 * (z4 * z135)
        z137 = z44 * z82 - z36 * z106
        z138 = R_1 * z126 + R_2 * z129
        s9 = 4.0 * (z42 * z126 + z1 * z137 - z17 * z138 - z21 * z129)
        z139 = s9 + k1 * (z45 * z81 - z38 * z90)
        z140 = R_1 * z133
        z141 = R_3 * z134
        s10 = z139 + 8.0 * (R_3 * z140) + 8.0 * (R_2 * z141)
        z142 = z54 * (s10 + 8.0 * (R_0 * z135))
        z143 = z73 * (z136 - 2.0 * (R_0 * z142) - z40 * z103 - z48 * z125)
        z144 = z47 * z125 - z48 * z143
        z145 = z37 * z80
        z146 = R_3 * z145
        z147 = z10 * z87
        s11 = z146 - z23 * z82 - 4.0 * (R_0 * z89) + 8.0 * (z4 * z101)
        z148 = s11 + 2.0 * (R_1 * (z102 - 4.0 * z147))
        z149 = z34 * z85
        z150 = z4 * (z117 - z118)
        s12 = z149 - z23 * z106 + 4.0 * (R_0 * z111) - 4.0 * (z5 * z120)
        z151 = s12 + z4 * z122 - 2.0 * (R_1 * (z124 + 4.0 * z150))
        z152 = z151 + z29 * z148
        z153 = z37 * z106
        s13 = z34 * z126 + R_3 * z153 - 4.0 * (R_0 * z131)
        z154 = s13 + 8.0 * (z11 * z133) - 8.0 * (z7 * z134)
        z155 = z142 + 4.0 * (z4 * z138)
        z156 = z73 * (z154 - 2.0 * (R_1 * z155) + z40 * z148 - z48 * z152)
        z157 = z47 * z152 - z48 * z156
        s14 = z149 - z19 * z86 + 8.0 * (z5 * z92) - 4.0 * (z10 * z97)
        z158 = s14 - 4.0 * (z4 * z99)
        z159 = z158 + 2.0 * (R_2 * (z102 - 4.0 * (z147 + R_0 * z84)))
        s15 = z146 - 4.0 * (R_0 * z105) + z19 * z109 - 8.0 * (z5 * z113)
        z160 = s15 + 2.0 * (R_2 * (z124 + 4.0 * (z150 + R_0 * z108)))
        z161 = z160 - z29 * z159
        z162 = z37 * z82
        s16 = R_3 * z162 - 4.0 * (R_0 * z128) - z34 * z129
        z163 = s16 - 8.0 * (z7 * z133) - 8.0 * (z4 * z141)
        z164 = z73 * (z163 + 2.0 * (R_2 * z155) - z40 * z159 - z48 * z161)
        z165 = z47 * z161 - z48 * z164
        s17 = R_1 * z145 - 4.0 * (z24 * z83) - 4.0 * (z20 * z88)
        z166 = s17 + 8.0 * (z7 * z92) - 4.0 * (z11 * z97)
        s18 = 2.0 * (R_3 * (z102 - (4.0 * (z4 * z94) - 8.0 * (z4 * z95))))
        z167 = z166 - 4.0 * (z4 * z98) + s18
        s19 = R_2 * z145 - 4.0 * (z41 * z104) + 4.0 * (z24 * z107)
        z168 = s19 - 4.0 * (z20 * z110) + 8.0 * (z7 * z113)
        s20 = 2.0 * (R_3 * (z124 - (4.0 * (z4 * z116) + 8.0 * (z4 * z118))))
        z169 = z168 + 4.0 * (z11 * z120) + 4.0 * (z4 * z121) + s20
        z170 = z169 - z29 * z167
        s21 = R_2 * z162 - 4.0 * (z41 * z127) - R_1 * z153
        z171 = s21 + 4.0 * (z20 * z130) - 8.0 * (z10 * z134)
        s22 = 2.0 * (R_3 * (z142 - 4.0 * (z4 * z137)))
        z172 = z171 - 8.0 * (z4 * z140) + s22 - z40 * z167
        z173 = z73 * (z172 - z48 * z170)
        z174 = z47 * z170 - z48 * z173
        z175 = w3 * k4
        z176 = z73 * (w2 * k5 - z48 * z175)
        z177 = z47 * z175 - z48 * z176
        z178 = w3 * k3
        z179 = z29 * z178
        z180 = z73 * (z74 + z40 * z178 - z48 * z179)
        z181 = z47 * z179 - z48 * z180
        z182 = z77 + z29 * z75
        z183 = z73 * (z40 * z75 - z48 * z182)
        z184 = z47 * z182 - z48 * z183
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            2.0 * z53 + 4.0 * (R_0 * z60),
            # (I.2.15)
            4.0 * (R_1 * z60) - 2.0 * (z61 - z4 * z59),
            # (I.2.15)
            2.0 * (z5 * z50 + z4 * z57) + 4.0 * (R_2 * z60),
            # (I.2.15)
            z62,
            # (I.2.15)
            2.0 * (a * z9),
            # (I.2.15)
            a * R_y2,
            # (I.2.15)
            2.0 * (a * z31),
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (z4 * z63) - 4.0 * (R_0 * z65),
            # (I.2.15)
            -(2.0 * (z11 * z51 + z4 * z64) + 4.0 * (R_1 * z65)),
            # (I.2.15)
            -(2.0 * (z61 - z10 * z50 - z4 * z58) + 4.0 * (R_2 * z65)),
            # (I.2.15)
            2.0 * (z53 + (z7 * z55 + z11 * z50)) - 4.0 * (R_3 * z65),
            # (I.2.15)
            -a * R_x1,
            # (I.2.15)
            -2.0 * (a * z14),
            # (I.2.15)
            -2.0 * (a * z32),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z66,
            # (I.2.15)
            -z67,
            # (I.2.15)
            -z68,
            # (I.2.15)
            -z69,
            # (I.2.15)
            -z70,
            # (I.2.15)
            -z71,
            0.0,
            0.0,
            # (I.2.15)
            z66,
            0.0,
            # (I.2.15)
            z68,
            # (I.2.15)
            -z67,
            # (I.2.15)
            z72,
            # (I.2.15)
            -z71,
            # (I.2.15)
            z70,
            0.0,
            0.0,
            # (I.2.15)
            z67,
            # (I.2.15)
            -z68,
            0.0,
            # (I.2.15)
            z66,
            # (I.2.15)
            z71,
            # (I.2.15)
            z72,
            # (I.2.15)
            -z69,
            0.0,
            0.0,
            # (I.2.15)
            z68,
            # (I.2.15)
            z67,
            # (I.2.15)
            -z66,
            0.0,
            # (I.2.15)
            -z70,
            # (I.2.15)
            z69,
            # (I.2.15)
            z72,
            0.0,
            0.0,
            # (I.2.15)
            z28 * z103 - z29 * z144 - z40 * z143,
            # (I.2.15)
            -(z28 * z148 + z29 * z157 + z40 * z156),
            # (I.2.15)
            z40 * z164 - (z28 * z159 - z29 * z165),
            # (I.2.15)
            z40 * z173 - (z28 * z167 - z29 * z174),
            # (I.2.15)
            z29 * z177 + z40 * z176,
            # (I.2.15)
            z28 * z178 + z29 * z181 + z40 * z180,
            # (I.2.15)
            z28 * z75 + z29 * z184 + z40 * z183,
            0.0,
            0.0,
            # (I.2.15)
            z144,
            # (I.2.15)
            z157,
            # (I.2.15)
            -z165,
            # (I.2.15)
            -z174,
            # (I.2.15)
            -z177,
            # (I.2.15)
            -z181,
            # (I.2.15)
            -z184,
            0.0,
            0.0,
            # (I.2.15)
            -z143,
            # (I.2.15)
            -z156,
            # (I.2.15)
            z164,
            # (I.2.15)
            z173,
            # (I.2.15)
            z176,
            # (I.2.15)
            z180,
            # (I.2.15)
            z183,
        ]
        _finish("jacobian", J)
        return [J[k6 : k6 + 9] for k6 in range(0, 81, 9)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (9,), p (5,).
    Returns out (3,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # parameters only
        k1 = m * a * a
        k2 = I1 + k1
        k3 = I2 + k1
        # state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = I1 * w1
        z3 = I3 * w3
        z4 = I2 * w2
        s1 = k1 * (R_2 * w1 - (R_1 * w2 + R_0 * w3))
        z5 = s1 + (R_2 * z2 - (R_0 * z3 + R_1 * z4))
        z6 = R_3 * z2 + (R_0 * z4 - R_1 * z3)
        s2 = R_3 * (k1 * (R_3 * w1 + (R_0 * w2 - R_1 * w3)) + z6)
        z7 = z1 * (R_2 * z5 + s2)
        z8 = R_3 * z4 - (R_0 * z2 + R_2 * z3)
        s3 = R_3 * (k1 * (R_3 * w2 - (R_0 * w1 + R_2 * w3)) + z8)
        z9 = z1 * (R_1 * z5 - s3)
        out: list[float] = [
            # K_x 26:8
            w1 * k2 - 2.0 * z7,
            # K_y 27:8
            w2 * k3 + 2.0 * z9,
            # K_z 28:8
            z3 + 2.0 * (z1 * (R_1 * z6 + R_2 * z8)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
