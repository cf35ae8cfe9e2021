"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:c8c65ba43053c0ee).

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
rhs: 53 +-, 107 *, 4 /, 0 calls
velocities: 23 +-, 47 *, 1 /, 0 calls
accelerations: 85 +-, 173 *, 4 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 29 +-, 50 *, 1 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 49 +-, 102 *, 4 /, 0 calls
energy: 19 +-, 41 *, 1 /, 0 calls
jacobian: 213 +-, 464 *, 4 /, 0 calls
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
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
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
        z13 = I1 + k1 * (4.0 * (z9 * z9) + R_x1 * R_x1)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "rhs")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + k1 * (R_y2 * R_y2 + 4.0 * (z14 * z14))
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
        z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25))
        z27 = 2.0 - 4.0 * (z4 * z17)
        z28 = R_3 * (2.0 - 4.0 * z12)
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
        z35 = w2 * w3 * k2
        z36 = w1 * w3 * k3 + z35 * z22
        z37 = (w1 * w2 * k4 - z35 * z30 - z33 * z36) / z34
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
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
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
        z13 = I1 + (4.0 * (k1 * (z9 * z9)) + k1 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "accelerations")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = 4.0 * (R_1 * z8)
        s1 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z17)) - z18)
        z19 = s1 + 4.0 * (z2 * z8)
        z20 = z16 * z19
        z21 = 1.0 / z13
        z22 = z20 * z21
        z23 = z15 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z15:
            raise SingularModelError(2, "accelerations")
        z24 = R_3 * z10 - R_1 * z7
        z25 = R_1 * z11 + R_2 * z7
        z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25))
        z27 = 2.0 - 4.0 * (z4 * z17)
        z28 = R_3 * (2.0 - 4.0 * z12)
        z29 = z16 * (R_0 * (R_2 * z27 - z18) + R_1 * z28)
        z30 = z29 * z21
        s2 = z16 * (R_0 * (R_1 * z27 + 4.0 * (R_2 * z8)) - R_2 * z28)
        z31 = s2 + z20 * z30
        z32 = 1.0 / z23
        z33 = z31 * z32
        z34 = z26 - z29 * z30 - z31 * z33
        # the mass matrix is singular
        if not abs(z34) > 1e-14 * z26:
            raise SingularModelError(2, "accelerations")
        z35 = w2 * w3 * k2
        z36 = w1 * w3 * k3 + z35 * z22
        z37 = (w1 * w2 * k4 - z35 * z30 - z33 * z36) / z34
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
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # state
        z1 = R_3 * R_3
        z2 = R_2 * R_2
        z3 = R_1 * R_1
        z4 = 1.0 / (z1 + (z2 + (R_0 * R_0 + z3)))
        R_x1 = 1.0 - 2.0 * (z4 * (z2 + z1))
        z5 = R_0 * z4
        z6 = R_3 * z5
        z7 = R_1 * R_2
        z8 = z4 * z7
        z9 = z6 + z8
        z10 = I1 + (k1 * (R_x1 * R_x1) + 4.0 * (k1 * (z9 * z9)))
        # the mass matrix is singular
        if not abs(z10) > 0.0:
            raise SingularModelError(2, "reactions")
        R_y2 = 1.0 - 2.0 * (z4 * (z3 + z1))
        z11 = z6 - z8
        z12 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z11 * z11)))
        z13 = z4 * k1
        z14 = z3 + z2
        z15 = R_3 * z4
        z16 = R_0 * R_1
        z17 = 4.0 * (z15 * z16)
        s1 = R_1 * (R_2 * (4.0 - z4 * (8.0 * z1 + 4.0 * z14)) - z17)
        z18 = s1 + 4.0 * (z2 * (R_0 * z15))
        z19 = z13 * z18
        z20 = 1.0 / z10
        z21 = z19 * z20
        z22 = z12 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * z12:
            raise SingularModelError(2, "reactions")
        z23 = R_1 * z15 + R_2 * z5
        z24 = R_1 * z5 - R_2 * z15
        z25 = I3 + 4.0 * (k1 * (z23 * z23 + z24 * z24))
        z26 = R_1 * R_3
        z27 = 2.0 - 4.0 * (R_3 * z15)
        z28 = 2.0 - 4.0 * (z4 * z14)
        z29 = z13 * (z26 * z27 + R_0 * (R_2 * z28 - z17))
        z30 = z29 * z20
        z31 = R_2 * R_3
        z32 = R_0 * R_2
        s2 = z13 * (z31 * z27 - R_0 * (R_1 * z28 + 4.0 * (z15 * z32)))
        z33 = s2 - z19 * z30
        z34 = 1.0 / z22
        z35 = z33 * z34
        z36 = z25 - z29 * z30 - z33 * z35
        # the mass matrix is singular
        if not abs(z36) > 1e-14 * z25:
            raise SingularModelError(2, "reactions")
        z37 = z4 * k2
        z38 = w2 * w3 * k3
        z39 = w1 * w3 * k4 + z38 * z21
        z40 = (w1 * w2 * k5 - z38 * z30 + z35 * z39) / z36
        z41 = z37 * z40
        z42 = R_0 * R_3
        z43 = z34 * z39 + z35 * z40
        z44 = z38 * z20 + z21 * z43 - z30 * z40
        s3 = 2.0 * (z37 * (z42 + z7) * z44) - k2 * (R_y2 * z43)
        z45 = 2.0 * ((z16 - z31) * z41) - s3
        s4 = k2 * (R_x1 * z44) + 2.0 * (z37 * (z42 - z7) * z43)
        z46 = 2.0 * ((z26 + z32) * z41) + s4
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 23:5
            -z45,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 24:5
            -z46,
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
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
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
        z13 = I1 + (4.0 * (k1 * (z9 * z9)) + k1 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "jacobian")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)))
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
        z33 = I3 + 4.0 * (k1 * (z31 * z31 + z32 * z32))
        z34 = 2.0 - 4.0 * (z4 * z17)
        z35 = z22 - R_2 * z34
        z36 = R_1 * R_3
        z37 = 2.0 - 4.0 * z12
        z38 = R_0 * z35 - z36 * z37
        z39 = z16 * z38
        z40 = z39 * z28
        z41 = R_0 * R_2
        z42 = R_3 * z41
        z43 = R_1 * z34 + 4.0 * (z4 * z42)
        z44 = R_2 * R_3
        z45 = R_0 * z43 - z44 * z37
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
        z62 = z11 * z55
        z63 = z56 - R_2 * z51
        z64 = R_2 * z55
        z65 = z54 * (R_3 * z52 + R_2 * z58 - R_1 * z64 + R_0 * z63)
        z66 = z10 * z50
        z67 = 0.5 * w1
        z68 = 0.5 * w2
        z69 = 0.5 * w3
        z70 = 0.5 * R_1
        z71 = 0.5 * R_2
        z72 = 0.5 * R_3
        z73 = 0.5 * R_0
        z74 = 1.0 / z49
        z75 = w1 * k4
        z76 = w2 * k2
        z77 = w3 * z76
        z78 = w1 * k3
        z79 = w3 * z78 + z29 * z77
        z80 = z74 * (w2 * z75 + z40 * z77 - z48 * z79)
        z81 = z16 * z80
        z82 = z47 * z79 - z48 * z80
        z83 = z16 * z82
        z84 = z4 * z83
        z85 = R_3 * z2
        z86 = R_0 * z81
        z87 = R_1 * z83
        z88 = z86 - z87
        z89 = z4 * z88
        z90 = R_3 * z89
        z91 = z28 * z77 + z29 * z82 + z40 * z80
        z92 = k1 * z91
        z93 = z9 * z92
        z94 = R_3 * z93
        z95 = z36 * z81
        z96 = R_2 * z87
        s1 = 4.0 * (z1 * z95 + z86 * (R_2 * z17) + z25 * z83 + z21 * z88)
        z97 = s1 - z18 * z96
        z98 = R_x1 * z92
        s2 = z97 + k1 * (z38 * z80 + z26 * z82) + 4.0 * (z1 * z98)
        z99 = s2 + 4.0 * (z2 * z98)
        z100 = R_2 * z93
        z101 = z54 * (z99 - 8.0 * (R_1 * z100) - 8.0 * (R_0 * z94))
        s3 = z35 * z81 + 4.0 * (z84 * z85) + 4.0 * (R_1 * z90)
        z102 = s3 - 8.0 * (z4 * z94) - 2.0 * (R_0 * z101)
        z103 = z4 * z86
        z104 = R_3 * z103
        z105 = z16 * z91
        z106 = z4 * z105
        z107 = R_1 * z105
        z108 = z4 * z107
        z109 = k1 * z82
        z110 = z14 * z109
        z111 = R_3 * z110
        s4 = z43 * z81 + 4.0 * (R_2 * z104) - 4.0 * (z85 * z106)
        z112 = s4 + 4.0 * (z36 * z108) - 8.0 * (z4 * z111)
        z113 = z44 * z81
        z114 = R_1 * z86
        z115 = R_2 * z107
        s5 = z42 * z86 + z1 * z113 - z17 * z114 - z25 * z105 + z21 * z107
        z116 = 4.0 * s5 + z18 * z115
        z117 = R_y2 * z109
        z118 = 8.0 * (R_2 * z110) - 4.0 * (R_1 * z117)
        s6 = z116 + k1 * (z45 * z80 - z26 * z91) - 4.0 * (z1 * z117)
        z119 = s6 + R_1 * z118 - 8.0 * (R_0 * z111)
        z120 = z54 * z119
        z121 = z112 - 2.0 * (R_0 * z120) - z29 * z102
        z122 = R_0 * z83
        z123 = z4 * z122
        z124 = R_3 * z123
        z125 = R_0 * z105
        z126 = z4 * z125
        z127 = R_3 * z126
        z128 = 4.0 * (R_1 * z127)
        z129 = k1 * z80
        z130 = z32 * z129
        z131 = z31 * z129
        z132 = R_2 * z130 - R_1 * z131
        z133 = z44 * z83 - z36 * z105
        z134 = R_1 * z122 + R_2 * z125
        s7 = 4.0 * (z42 * z122 + z1 * z133 - z17 * z134 - z21 * z125)
        z135 = s7 + k1 * (z45 * z82 - z38 * z91)
        z136 = R_1 * z130
        z137 = R_3 * z131
        s8 = z135 + 8.0 * (R_3 * z136) + 8.0 * (R_2 * z137)
        z138 = z54 * (s8 + 8.0 * (R_0 * z132))
        s9 = z43 * z83 + 4.0 * (R_2 * z124) - z35 * z105 - z128
        z139 = s9 + 8.0 * (z4 * z132) - 2.0 * (R_0 * z138)
        z140 = z74 * (z139 - z40 * z102 - z48 * z121)
        z141 = z47 * z121 - z48 * z140
        z142 = z37 * z81
        z143 = R_3 * z142
        z144 = z10 * z88
        s10 = z143 - z23 * z83 - 4.0 * (R_0 * z90) + 8.0 * (z4 * z100)
        z145 = s10 + 2.0 * (R_1 * (z101 - 4.0 * z144))
        z146 = z34 * z86
        z147 = z4 * (z114 - z115)
        s11 = z128 + (z146 - z23 * z105) - 4.0 * (z5 * z117) + z4 * z118
        z148 = s11 - 2.0 * (R_1 * (z120 + 4.0 * z147))
        z149 = z148 + z29 * z145
        z150 = z37 * z105
        s12 = z34 * z122 + R_3 * z150 - 4.0 * (R_0 * z127)
        z151 = s12 + 8.0 * (z11 * z130) - 8.0 * (z7 * z131)
        z152 = z138 + 4.0 * (z4 * z134)
        z153 = z74 * (z151 - 2.0 * (R_1 * z152) + z40 * z145 - z48 * z149)
        z154 = z47 * z149 - z48 * z153
        z155 = 4.0 * (z10 * z98)
        s13 = z155 - (z146 - z19 * z87 + 8.0 * (z5 * z93) - z155)
        z156 = s13 - 2.0 * (R_2 * (z101 - 4.0 * (z124 + z144)))
        s14 = z143 - 4.0 * (R_0 * z104) + z19 * z107 - 8.0 * (z5 * z110)
        z157 = s14 + 2.0 * (R_2 * (z120 + 4.0 * (z127 + z147)))
        z158 = z157 + z29 * z156
        z159 = z37 * z83
        s15 = R_3 * z159 - 4.0 * (R_0 * z124) - z34 * z125
        z160 = s15 - 8.0 * (z7 * z130) - 8.0 * (z4 * z137)
        z161 = z74 * (z160 + 2.0 * (R_2 * z152) + z40 * z156 - z48 * z158)
        z162 = z47 * z158 - z48 * z161
        z163 = 4.0 * (z11 * z98)
        s16 = R_1 * z142 - 4.0 * (z24 * z84) - 4.0 * (z20 * z89)
        z164 = s16 + 8.0 * (z7 * z93) - z163
        s17 = 2.0 * (R_3 * (z101 - (4.0 * (z4 * z95) - 8.0 * (z4 * z96))))
        z165 = z163 - z164 - s17
        z166 = 4.0 * (z11 * z117)
        s18 = R_2 * z142 - 4.0 * (z41 * z103) + 4.0 * (z24 * z106)
        z167 = s18 - 4.0 * (z20 * z108) + 8.0 * (z7 * z110)
        s19 = 2.0 * (R_3 * (z120 - (4.0 * (z4 * z113) + 8.0 * (z4 * z115))))
        z168 = z166 + (z167 + z166) + s19
        z169 = z168 + z29 * z165
        s20 = R_2 * z159 - 4.0 * (z41 * z123) - R_1 * z150
        z170 = s20 + 4.0 * (z20 * z126) - 8.0 * (z10 * z131)
        s21 = 2.0 * (R_3 * (z138 - 4.0 * (z4 * z133)))
        z171 = z170 - 8.0 * (z4 * z136) + s21 + z40 * z165
        z172 = z74 * (z171 - z48 * z169)
        z173 = z47 * z169 - z48 * z172
        z174 = w3 * k3
        z175 = z74 * (w2 * k4 - z48 * z174)
        z176 = z47 * z174 - z48 * z175
        z177 = w3 * k2
        z178 = z29 * z177
        z179 = z74 * (z75 + z40 * z177 - z48 * z178)
        z180 = z47 * z178 - z48 * z179
        z181 = z78 + z29 * z76
        z182 = z74 * (z40 * z76 - z48 * z181)
        z183 = z47 * z181 - z48 * z182
        s22 = 2.0 * (z62 - (z7 * z50 + z10 * z51 - z62))
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
            4.0 * (R_3 * z60) - s22,
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
            -(4.0 * (R_1 * z65) + 2.0 * (z4 * (z57 + z64))),
            # (I.2.15)
            2.0 * (z66 - (z61 - z66)) - 4.0 * (R_2 * z65),
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
            z28 * z102 - z29 * z141 - z40 * z140,
            # (I.2.15)
            -(z28 * z145 + z29 * z154 + z40 * z153),
            # (I.2.15)
            z28 * z156 + z29 * z162 + z40 * z161,
            # (I.2.15)
            z28 * z165 + z29 * z173 + z40 * z172,
            # (I.2.15)
            z29 * z176 + z40 * z175,
            # (I.2.15)
            z28 * z177 + z29 * z180 + z40 * z179,
            # (I.2.15)
            z28 * z76 + z29 * z183 + z40 * z182,
            0.0,
            0.0,
            # (I.2.15)
            z141,
            # (I.2.15)
            z154,
            # (I.2.15)
            -z162,
            # (I.2.15)
            -z173,
            # (I.2.15)
            -z176,
            # (I.2.15)
            -z180,
            # (I.2.15)
            -z183,
            0.0,
            0.0,
            # (I.2.15)
            -z140,
            # (I.2.15)
            -z153,
            # (I.2.15)
            z161,
            # (I.2.15)
            z172,
            # (I.2.15)
            z175,
            # (I.2.15)
            z179,
            # (I.2.15)
            z182,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 9] for k5 in range(0, 81, 9)]
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
