"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:e32e9762b485d96b).

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
jacobian: 213 +-, 485 *, 5 /, 0 calls
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
            -0.5 * (R_1 * w3 - (R_3 * w1 + R_0 * w2)),
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
            -0.5 * (R_1 * w3 - (R_3 * w1 + R_0 * w2)),
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
    """T + V (II.1.4)

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
        z4 = z1 + (z2 + (R_0 * R_0 + z3))
        z5 = 1.0 / z4
        z6 = R_1 * z5
        z7 = R_2 * z6
        z8 = R_0 * z5
        z9 = R_3 * z8
        z10 = z7 + z9
        z11 = R_2 * z5
        z12 = R_3 * z5
        z13 = R_3 * z12
        R_x1 = 1.0 - 2.0 * (R_2 * z11 + z13)
        z14 = I1 + (4.0 * (k2 * (z10 * z10)) + k2 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z14) > 0.0:
            raise SingularModelError(2, "jacobian")
        R_y2 = 1.0 - 2.0 * (R_1 * z6 + z13)
        z15 = z7 - z9
        z16 = I2 + (k2 * (R_y2 * R_y2) + 4.0 * (k2 * (z15 * z15)))
        z17 = z5 * k1
        z18 = z3 + z2
        z19 = 8.0 * z1 + 4.0 * z18
        z20 = 4.0 - z5 * z19
        z21 = R_0 * R_1
        z22 = R_3 * z21
        z23 = 4.0 * (z5 * z22)
        z24 = R_2 * z20 - z23
        z25 = R_0 * z2
        z26 = R_3 * z25
        z27 = R_1 * z24 + 4.0 * (z5 * z26)
        z28 = z17 * z27
        z29 = 1.0 / z14
        z30 = z28 * z29
        z31 = z16 - z28 * z30
        # the mass matrix is singular
        if not abs(z31) > 1e-14 * z16:
            raise SingularModelError(2, "jacobian")
        z32 = R_3 * z11 - R_1 * z8
        z33 = R_1 * z12 + R_2 * z8
        z34 = I3 + 4.0 * (k2 * (z32 * z32 + z33 * z33))
        z35 = 2.0 - 4.0 * (z5 * z18)
        z36 = z23 - R_2 * z35
        z37 = R_1 * R_3
        z38 = 2.0 - 4.0 * (z1 * z5)
        z39 = R_0 * z36 - z37 * z38
        z40 = z17 * z39
        z41 = z40 * z29
        z42 = R_0 * R_2
        z43 = R_3 * z42
        z44 = R_1 * z35 + 4.0 * (z5 * z43)
        z45 = R_2 * R_3
        z46 = R_0 * z44 - z38 * z45
        z47 = z17 * z46 - z28 * z41
        z48 = 1.0 / z31
        z49 = z47 * z48
        z50 = z34 - z40 * z41 - z47 * z49
        # the mass matrix is singular
        if not abs(z50) > 1e-14 * z34:
            raise SingularModelError(2, "jacobian")
        z51 = a * w1
        z52 = a * w3
        z53 = R_3 * z51 - R_1 * z52
        z54 = z5 * z53
        z55 = 1.0 / (z4 * z4)
        z56 = a * w2
        z57 = R_3 * z56
        z58 = R_3 * z52
        z59 = R_2 * z51
        z60 = z59 - R_1 * z56
        z61 = z55 * (R_3 * z57 - R_2 * z58 - R_1 * z60 - R_0 * z53)
        z62 = z8 * z52 + z6 * z56
        s1 = 2.0 * (z8 * z51 + z11 * z52 - z12 * z56 - z5 * z57)
        z63 = s1 + 4.0 * (R_3 * z61)
        z64 = z57 - R_2 * z52
        z65 = R_2 * z56
        z66 = z55 * (R_3 * z53 + R_2 * z59 - R_1 * z65 + R_0 * z64)
        z67 = 0.5 * w1
        z68 = 0.5 * w2
        z69 = 0.5 * w3
        z70 = 0.5 * R_1
        z71 = 0.5 * R_2
        z72 = 0.5 * R_3
        z73 = 0.5 * R_0
        z74 = 1.0 / z50
        z75 = w1 * k5
        z76 = w2 * k3
        z77 = w3 * z76
        z78 = w1 * k4
        z79 = w3 * z78 + z30 * z77
        z80 = z74 * (w2 * z75 + z41 * z77 - z49 * z79)
        z81 = z17 * z80
        z82 = z48 * z79 - z49 * z80
        z83 = z17 * z82
        z84 = z5 * z83
        z85 = R_3 * z84
        z86 = R_0 * z81
        z87 = R_1 * z83
        z88 = z86 - z87
        z89 = z5 * z88
        z90 = R_3 * z89
        z91 = z29 * z77 + z30 * z82 + z41 * z80
        z92 = k2 * z91
        z93 = z10 * z92
        z94 = R_3 * z93
        z95 = z37 * z81
        z96 = R_2 * z87
        s2 = 4.0 * (z1 * z95 + z86 * (R_2 * z18) + z26 * z83 + z22 * z88)
        z97 = s2 - z19 * z96
        z98 = R_x1 * z92
        z99 = R_3 * z98
        z100 = R_2 * z98
        s3 = z97 + k1 * (z39 * z80 + z27 * z82) + 4.0 * (R_3 * z99)
        z101 = s3 + 4.0 * (R_2 * z100)
        z102 = R_2 * z93
        z103 = z55 * (z101 - 8.0 * (R_1 * z102) - 8.0 * (R_0 * z94))
        s4 = z36 * z81 + 4.0 * (z2 * z85) + 4.0 * (R_1 * z90)
        z104 = s4 - 8.0 * (z5 * z94) - 2.0 * (R_0 * z103)
        z105 = z5 * z86
        z106 = R_3 * z105
        z107 = z17 * z91
        z108 = z5 * z107
        z109 = R_3 * z108
        z110 = R_1 * z107
        z111 = z5 * z110
        z112 = R_3 * z111
        z113 = k2 * z82
        z114 = z15 * z113
        z115 = R_3 * z114
        s5 = z44 * z81 + 4.0 * (R_2 * z106) - 4.0 * (z2 * z109)
        z116 = s5 + 4.0 * (R_1 * z112) - 8.0 * (z5 * z115)
        z117 = z45 * z81
        z118 = R_1 * z86
        z119 = R_2 * z110
        s6 = z43 * z86 + z1 * z117 - z18 * z118 - z26 * z107 + z22 * z110
        z120 = 4.0 * s6 + z19 * z119
        z121 = R_y2 * z113
        z122 = R_3 * z121
        z123 = 8.0 * (R_2 * z114) - 4.0 * (R_1 * z121)
        s7 = z120 + k1 * (z46 * z80 - z27 * z91) - 4.0 * (R_3 * z122)
        z124 = s7 + R_1 * z123 - 8.0 * (R_0 * z115)
        z125 = z55 * z124
        z126 = z116 - 2.0 * (R_0 * z125) - z30 * z104
        z127 = R_0 * z83
        z128 = z5 * z127
        z129 = R_3 * z128
        z130 = R_0 * z107
        z131 = z5 * z130
        z132 = R_3 * z131
        z133 = k2 * z80
        z134 = z33 * z133
        z135 = z32 * z133
        z136 = R_2 * z134 - R_1 * z135
        s8 = z44 * z83 + 4.0 * (R_2 * z129) - z36 * z107
        z137 = s8 - 4.0 * (R_1 * z132) + 8.0 * (z5 * z136)
        z138 = z45 * z83 - z37 * z107
        z139 = R_1 * z127 + R_2 * z130
        s9 = 4.0 * (z43 * z127 + z1 * z138 - z18 * z139 - z22 * z130)
        z140 = s9 + k1 * (z46 * z82 - z39 * z91)
        z141 = R_1 * z134
        z142 = R_3 * z135
        s10 = z140 + 8.0 * (R_3 * z141) + 8.0 * (R_2 * z142)
        z143 = z55 * (s10 + 8.0 * (R_0 * z136))
        z144 = z74 * (z137 - 2.0 * (R_0 * z143) - z41 * z104 - z49 * z126)
        z145 = z48 * z126 - z49 * z144
        z146 = z38 * z81
        z147 = R_3 * z146
        z148 = z11 * z88
        s11 = z147 - z24 * z83 - 4.0 * (R_0 * z90) + 8.0 * (z5 * z102)
        z149 = s11 + 2.0 * (R_1 * (z103 - 4.0 * z148))
        z150 = z35 * z86
        z151 = z5 * (z118 - z119)
        s12 = z150 - z24 * z107 + 4.0 * (R_0 * z112) - 4.0 * (z6 * z121)
        z152 = s12 + z5 * z123 - 2.0 * (R_1 * (z125 + 4.0 * z151))
        z153 = z152 + z30 * z149
        z154 = z38 * z107
        s13 = z35 * z127 + R_3 * z154 - 4.0 * (R_0 * z132)
        z155 = s13 + 8.0 * (z12 * z134) - 8.0 * (z8 * z135)
        z156 = z143 + 4.0 * (z5 * z139)
        z157 = z74 * (z155 - 2.0 * (R_1 * z156) + z41 * z149 - z49 * z153)
        z158 = z48 * z153 - z49 * z157
        s14 = z150 - z20 * z87 + 8.0 * (z6 * z93) - 4.0 * (z11 * z98)
        z159 = s14 - 4.0 * (z5 * z100)
        z160 = z159 + 2.0 * (R_2 * (z103 - 4.0 * (z148 + R_0 * z85)))
        s15 = z147 - 4.0 * (R_0 * z106) + z20 * z110 - 8.0 * (z6 * z114)
        z161 = s15 + 2.0 * (R_2 * (z125 + 4.0 * (z151 + R_0 * z109)))
        z162 = z161 - z30 * z160
        z163 = z38 * z83
        s16 = R_3 * z163 - 4.0 * (R_0 * z129) - z35 * z130
        z164 = s16 - 8.0 * (z8 * z134) - 8.0 * (z5 * z142)
        z165 = z74 * (z164 + 2.0 * (R_2 * z156) - z41 * z160 - z49 * z162)
        z166 = z48 * z162 - z49 * z165
        s17 = R_1 * z146 - 4.0 * (z25 * z84) - 4.0 * (z21 * z89)
        z167 = s17 + 8.0 * (z8 * z93) - 4.0 * (z12 * z98)
        s18 = 2.0 * (R_3 * (z103 - (4.0 * (z5 * z95) - 8.0 * (z5 * z96))))
        z168 = z167 - 4.0 * (z5 * z99) + s18
        s19 = R_2 * z146 - 4.0 * (z42 * z105) + 4.0 * (z25 * z108)
        z169 = s19 - 4.0 * (z21 * z111) + 8.0 * (z8 * z114)
        s20 = 2.0 * (R_3 * (z125 - (4.0 * (z5 * z117) + 8.0 * (z5 * z119))))
        z170 = z169 + 4.0 * (z12 * z121) + 4.0 * (z5 * z122) + s20
        z171 = z170 - z30 * z168
        s21 = R_2 * z163 - 4.0 * (z42 * z128) - R_1 * z154
        z172 = s21 + 4.0 * (z21 * z131) - 8.0 * (z11 * z135)
        s22 = 2.0 * (R_3 * (z143 - 4.0 * (z5 * z138)))
        z173 = z172 - 8.0 * (z5 * z141) + s22 - z41 * z168
        z174 = z74 * (z173 - z49 * z171)
        z175 = z48 * z171 - z49 * z174
        z176 = w3 * k4
        z177 = z74 * (w2 * k5 - z49 * z176)
        z178 = z48 * z176 - z49 * z177
        z179 = w3 * k3
        z180 = z30 * z179
        z181 = z74 * (z75 + z41 * z179 - z49 * z180)
        z182 = z48 * z180 - z49 * z181
        z183 = z78 + z30 * z76
        z184 = z74 * (z41 * z76 - z49 * z183)
        z185 = z48 * z183 - z49 * z184
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            2.0 * z54 + 4.0 * (R_0 * z61),
            # (I.2.15)
            4.0 * (R_1 * z61) - 2.0 * (z62 - z5 * z60),
            # (I.2.15)
            2.0 * (z6 * z51 + z5 * z58) + 4.0 * (R_2 * z61),
            # (I.2.15)
            z63,
            # (I.2.15)
            2.0 * (a * z10),
            # (I.2.15)
            a * R_y2,
            # (I.2.15)
            2.0 * (a * z32),
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (z5 * z64) - 4.0 * (R_0 * z66),
            # (I.2.15)
            -(2.0 * (z12 * z52 + z5 * z65) + 4.0 * (R_1 * z66)),
            # (I.2.15)
            -(2.0 * (z62 - z11 * z51 - z5 * z59) + 4.0 * (R_2 * z66)),
            # (I.2.15)
            2.0 * (z54 + (z8 * z56 + z12 * z51)) - 4.0 * (R_3 * z66),
            # (I.2.15)
            -a * R_x1,
            # (I.2.15)
            -2.0 * (a * z15),
            # (I.2.15)
            -2.0 * (a * z33),
            0.0,
            0.0,
            0.0,
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
            # (I.2.15)
            -z72,
            0.0,
            0.0,
            # (I.2.15)
            z67,
            0.0,
            # (I.2.15)
            z69,
            # (I.2.15)
            -z68,
            # (I.2.15)
            z73,
            # (I.2.15)
            -z72,
            # (I.2.15)
            z71,
            0.0,
            0.0,
            # (I.2.15)
            z68,
            # (I.2.15)
            -z69,
            0.0,
            # (I.2.15)
            z67,
            # (I.2.15)
            z72,
            # (I.2.15)
            z73,
            # (I.2.15)
            -z70,
            0.0,
            0.0,
            # (I.2.15)
            z69,
            # (I.2.15)
            z68,
            # (I.2.15)
            -z67,
            0.0,
            # (I.2.15)
            -z71,
            # (I.2.15)
            z70,
            # (I.2.15)
            z73,
            0.0,
            0.0,
            # (I.2.15)
            z29 * z104 - z30 * z145 - z41 * z144,
            # (I.2.15)
            -(z29 * z149 + z30 * z158 + z41 * z157),
            # (I.2.15)
            z41 * z165 - (z29 * z160 - z30 * z166),
            # (I.2.15)
            z41 * z174 - (z29 * z168 - z30 * z175),
            # (I.2.15)
            z30 * z178 + z41 * z177,
            # (I.2.15)
            z29 * z179 + z30 * z182 + z41 * z181,
            # (I.2.15)
            z29 * z76 + z30 * z185 + z41 * z184,
            0.0,
            0.0,
            # (I.2.15)
            z145,
            # (I.2.15)
            z158,
            # (I.2.15)
            -z166,
            # (I.2.15)
            -z175,
            # (I.2.15)
            -z178,
            # (I.2.15)
            -z182,
            # (I.2.15)
            -z185,
            0.0,
            0.0,
            # (I.2.15)
            -z144,
            # (I.2.15)
            -z157,
            # (I.2.15)
            z165,
            # (I.2.15)
            z174,
            # (I.2.15)
            z177,
            # (I.2.15)
            z181,
            # (I.2.15)
            z184,
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
