"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:90f527a2ecd106f0).

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
y[6] = w1 [rad/s]
y[7] = w2 [rad/s]
y[8] = w3 [rad/s]

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
out[0] = K_x [kg*m^2/s]
out[1] = K_y [kg*m^2/s]
out[2] = K_z [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 53 +-, 113 *, 4 /, 0 calls
velocities: 23 +-, 47 *, 1 /, 0 calls
accelerations: 85 +-, 179 *, 4 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 29 +-, 50 *, 1 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 49 +-, 108 *, 4 /, 0 calls
energy: 19 +-, 41 *, 1 /, 0 calls
jacobian: 213 +-, 519 *, 4 /, 0 calls
outputs: 26 +-, 44 *, 1 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
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
            raise _refuse(abs(z13), 0.0, 2, "rhs")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + k1 * (R_y2 * R_y2 + 4.0 * (z14 * z14))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = R_1 * z11
        z19 = R_0 * z18
        s1 = R_1 * (R_2 * (1.0 - z4 * (2.0 * z1 + z17)) - z19) + z2 * z8
        z20 = z16 * s1
        z21 = 1.0 / z13
        z22 = z21 * z20
        z23 = z15 - 16.0 * (z20 * z22)
        # the mass matrix is singular
        if not abs(z23) > 1e-13 * z15:
            raise _refuse(abs(z23), 1e-13 * z15, 2, "rhs")
        z24 = R_3 * z10
        z25 = z24 - R_1 * z7
        z26 = z18 + R_2 * z7
        z27 = I3 + 4.0 * (k1 * (z25 * z25 + z26 * z26))
        z28 = 1.0 - 2.0 * (z4 * z17)
        z29 = R_3 * (1.0 - 2.0 * z12)
        z30 = z16 * (R_0 * (R_2 * z28 - 2.0 * z19) + R_1 * z29)
        z31 = z21 * z30
        s2 = z16 * (R_0 * (R_1 * z28 + 2.0 * (R_0 * z24)) - R_2 * z29)
        z32 = 2.0 * s2 + 8.0 * (z20 * z31)
        z33 = 1.0 / z23
        z34 = z33 * z32
        z35 = z27 - 4.0 * (z30 * z31) - z32 * z34
        # the mass matrix is singular
        if not abs(z35) > 1e-13 * z27:
            raise _refuse(abs(z35), 1e-13 * z27, 2, "rhs")
        z36 = w2 * w3 * k2
        z37 = w1 * w3 * k3 + 4.0 * (z36 * z22)
        z38 = (w1 * w2 * k4 - 2.0 * (z36 * z31) - z37 * z34) / z35
        z39 = z33 * z37 - z34 * z38
        dydt: list[float] = [
            # x' (I.2.15)
            a * (2.0 * (z25 * w3) + (R_y2 * w2 + 2.0 * (z9 * w1))),
            # y' (I.2.15)
            -a * (2.0 * (z26 * w3) + (2.0 * (z14 * w2) + R_x1 * w1)),
            # R_0' (I.2.15)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.15)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.15)
            (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5,
            # R_3' (I.2.15)
            0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)),
            # w1' (I.2.15) 21:4
            z36 * z21 + 4.0 * (z22 * z39) - 2.0 * (z31 * z38),
            # w2' (I.2.15) 21:4
            -z39,
            # w3' (I.2.15) 21:4
            z38,
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
        # from the state
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
            (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5,
            # R_3' (I.2.4)
            0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)),
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
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
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
            raise _refuse(abs(z13), 0.0, 2, "accelerations")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = R_1 * z8
        s1 = z2 * z8 + R_1 * (R_2 * (1.0 - z4 * (2.0 * z1 + z17)) - z18)
        z19 = z16 * s1
        z20 = 1.0 / z13
        z21 = z20 * z19
        z22 = z15 - 16.0 * (z19 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-13 * z15:
            raise _refuse(abs(z22), 1e-13 * z15, 2, "accelerations")
        z23 = R_3 * z10 - R_1 * z7
        z24 = R_1 * z11 + R_2 * z7
        z25 = I3 + 4.0 * (k1 * (z23 * z23 + z24 * z24))
        z26 = R_3 * (1.0 - 2.0 * z12)
        z27 = 1.0 - 2.0 * (z4 * z17)
        z28 = z16 * (R_1 * z26 + R_0 * (R_2 * z27 - 2.0 * z18))
        z29 = z20 * z28
        s2 = z16 * (R_2 * z26 - R_0 * (R_1 * z27 + 2.0 * (R_2 * z8)))
        z30 = 2.0 * s2 - 8.0 * (z19 * z29)
        z31 = 1.0 / z22
        z32 = z30 * z31
        z33 = z25 - 4.0 * (z28 * z29) - z30 * z32
        # the mass matrix is singular
        if not abs(z33) > 1e-13 * z25:
            raise _refuse(abs(z33), 1e-13 * z25, 2, "accelerations")
        z34 = w2 * w3 * k2
        z35 = w1 * w3 * k3 + 4.0 * (z34 * z21)
        z36 = (w1 * w2 * k4 - 2.0 * (z34 * z29) + z32 * z35) / z33
        z37 = z31 * z35 + z32 * z36
        z38 = z34 * z20 + 4.0 * (z21 * z37) - 2.0 * (z29 * z36)
        s3 = 2.0 * (0.5 * (w1 * (R_y2 * w3 - 2.0 * (z23 * w2))) + z9 * z38)
        z39 = 2.0 * (w2 * (z23 * w1 - z9 * w3)) - R_y2 * z37 + s3
        s4 = 2.0 * (0.5 * (w3 * (2.0 * (z9 * w2) - R_y2 * w1)) + z23 * z36)
        z40 = a * (s4 + z39)
        s5 = 0.5 * (w2 * (2.0 * (z24 * w1) - R_x1 * w3)) - z14 * z37
        z41 = 2.0 * s5 + (2.0 * (w1 * (z14 * w3 - z24 * w2)) + R_x1 * z38)
        s6 = 0.5 * (w3 * (R_x1 * w2 - 2.0 * (z14 * w1))) + z24 * z36
        z42 = a * (2.0 * s6 + z41)
        z43 = R_0 * w3 + (R_1 * w2 - R_2 * w1)
        z44 = R_2 * w3 + (R_0 * w1 - R_3 * w2)
        z45 = R_1 * w3 - (R_0 * w2 + R_3 * w1)
        s7 = 0.5 * (w1 * z44) + R_1 * z38 - (0.5 * (w2 * z45) + R_2 * z37)
        z46 = 0.5 * (w3 * z43) + R_3 * z36 + s7
        z47 = R_3 * w3 + (R_1 * w1 + R_2 * w2)
        s8 = 0.5 * (w1 * z47) - R_0 * z38 + (0.5 * (w2 * z43) - R_3 * z37)
        z48 = 0.5 * (w3 * z45) - R_2 * z36 + s8
        s9 = 0.5 * (w2 * z47) + R_0 * z37 - (0.5 * (w1 * z43) + R_3 * z38)
        z49 = 0.5 * (w3 * z44) + R_1 * z36 + s9
        s10 = 0.5 * (w2 * z44) - R_1 * z37 + (0.5 * (w1 * z45) - R_2 * z38)
        z50 = 0.5 * (w3 * z47) - R_0 * z36 - s10
        qddot: list[float] = [
            # x'' (I.2.15)
            z40,
            # y'' (I.2.15)
            -z42,
            # R_0'' (I.2.15)
            -0.5 * z46,
            # R_1'' (I.2.15)
            -0.5 * z48,
            # R_2'' (I.2.15)
            -0.5 * z49,
            # R_3'' (I.2.15)
            -0.5 * z50,
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
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
        # from the state
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
    """left minus right side of each holonomic constraint, zero on every motion

    Arguments: t (scalar), q (6,), p (5,).
    Returns f (1,).
    """
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    try:
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (9,), p (5,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
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
        # from the parameters alone
        k1 = m * a * a
        k2 = m * a
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # from the state
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
            raise _refuse(abs(z10), 0.0, 2, "reactions")
        R_y2 = 1.0 - 2.0 * (z4 * (z3 + z1))
        z11 = z6 - z8
        z12 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z11 * z11)))
        z13 = z4 * k1
        z14 = z3 + z2
        z15 = R_3 * z4
        z16 = R_0 * R_1
        z17 = z15 * z16
        s1 = R_1 * (R_2 * (1.0 - z4 * (2.0 * z1 + z14)) - z17)
        z18 = z13 * (s1 + z15 * (R_0 * z2))
        z19 = 1.0 / z10
        z20 = z18 * z19
        z21 = z12 - 16.0 * (z18 * z20)
        # the mass matrix is singular
        if not abs(z21) > 1e-13 * z12:
            raise _refuse(abs(z21), 1e-13 * z12, 2, "reactions")
        z22 = R_1 * z15 + R_2 * z5
        z23 = R_1 * z5 - R_2 * z15
        z24 = I3 + 4.0 * (k1 * (z22 * z22 + z23 * z23))
        z25 = R_1 * R_3
        z26 = 1.0 - 2.0 * (R_3 * z15)
        z27 = 1.0 - 2.0 * (z4 * z14)
        z28 = z13 * (z25 * z26 + R_0 * (R_2 * z27 - 2.0 * z17))
        z29 = z28 * z19
        z30 = R_2 * R_3
        z31 = R_0 * R_2
        s2 = z13 * (z30 * z26 - R_0 * (R_1 * z27 + 2.0 * (z15 * z31)))
        z32 = 2.0 * s2 - 8.0 * (z18 * z29)
        z33 = 1.0 / z21
        z34 = z32 * z33
        z35 = z24 - 4.0 * (z28 * z29) - z32 * z34
        # the mass matrix is singular
        if not abs(z35) > 1e-13 * z24:
            raise _refuse(abs(z35), 1e-13 * z24, 2, "reactions")
        z36 = z4 * k2
        z37 = w2 * w3 * k3
        z38 = w1 * w3 * k4 + 4.0 * (z37 * z20)
        z39 = (w1 * w2 * k5 - 2.0 * (z37 * z29) + z34 * z38) / z35
        z40 = z36 * z39
        z41 = R_0 * R_3
        z42 = z33 * z38 + z34 * z39
        z43 = z37 * z19 + 4.0 * (z20 * z42) - 2.0 * (z29 * z39)
        s3 = 2.0 * (z36 * (z41 + z7) * z43) - k2 * (R_y2 * z42)
        z44 = 2.0 * ((z16 - z30) * z40) - s3
        s4 = k2 * (R_x1 * z43) + 2.0 * (z36 * (z41 - z7) * z42)
        z45 = 2.0 * ((z25 + z31) * z40) + s4
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 23:5
            -z44,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 24:5
            -z45,
            # reaction of R_norm: Q_i gains lambda_3 a_3i (I.4.1) 10:3
            0.0,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V

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
        # from the state
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
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)

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
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
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
            raise _refuse(abs(z13), 0.0, 2, "jacobian")
        R_y2 = 1.0 - 2.0 * (R_1 * z5 + z12)
        z14 = z6 - z8
        z15 = I2 + (k1 * (R_y2 * R_y2) + 4.0 * (k1 * (z14 * z14)))
        z16 = z4 * k1
        z17 = z3 + z2
        z18 = 2.0 * z1 + z17
        z19 = 1.0 - z4 * z18
        z20 = R_0 * R_1
        z21 = R_3 * z20
        z22 = z4 * z21
        z23 = R_2 * z19 - z22
        z24 = R_0 * z2
        z25 = R_3 * z24
        z26 = R_1 * z23 + z4 * z25
        z27 = z16 * z26
        z28 = 1.0 / z13
        z29 = z27 * z28
        z30 = z15 - 16.0 * (z27 * z29)
        # the mass matrix is singular
        if not abs(z30) > 1e-13 * z15:
            raise _refuse(abs(z30), 1e-13 * z15, 2, "jacobian")
        z31 = R_3 * z10 - R_1 * z7
        z32 = R_1 * z11 + R_2 * z7
        z33 = I3 + 4.0 * (k1 * (z31 * z31 + z32 * z32))
        z34 = 1.0 - 2.0 * (z4 * z17)
        z35 = 2.0 * z22 - R_2 * z34
        z36 = R_1 * R_3
        z37 = 1.0 - 2.0 * z12
        z38 = R_0 * z35 - z36 * z37
        z39 = z16 * z38
        z40 = z39 * z28
        z41 = R_0 * R_2
        z42 = R_3 * z41
        z43 = R_1 * z34 + 2.0 * (z4 * z42)
        z44 = R_2 * R_3
        z45 = R_0 * z43 - z44 * z37
        z46 = 2.0 * (z16 * z45) - 8.0 * (z27 * z40)
        z47 = 1.0 / z30
        z48 = z46 * z47
        z49 = z33 - 4.0 * (z39 * z40) - z46 * z48
        # the mass matrix is singular
        if not abs(z49) > 1e-13 * z33:
            raise _refuse(abs(z49), 1e-13 * z33, 2, "jacobian")
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
        z79 = w3 * z78 + 4.0 * (z29 * z77)
        z80 = z74 * (w2 * z75 + 2.0 * (z40 * z77) - z48 * z79)
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
        z91 = z28 * z77 + 4.0 * (z29 * z82) + 2.0 * (z40 * z80)
        z92 = k1 * z91
        z93 = z9 * z92
        z94 = R_3 * z93
        s1 = 2.0 * (z35 * z81) + 4.0 * (z84 * z85) + 4.0 * (R_1 * z90)
        z95 = s1 - 8.0 * (z4 * z94)
        z96 = z36 * z81
        z97 = R_2 * z87
        s2 = z1 * z96 + z86 * (R_2 * z17) + z25 * z83 + z21 * z88
        z98 = 4.0 * (s2 - z18 * z97)
        z99 = R_x1 * z92
        s3 = z98 + k1 * (2.0 * (z38 * z80) + 4.0 * (z26 * z82))
        z100 = s3 + 4.0 * (z1 * z99) + 4.0 * (z2 * z99)
        z101 = R_2 * z93
        z102 = z54 * (z100 - 8.0 * (R_1 * z101) - 8.0 * (R_0 * z94))
        z103 = z95 - 2.0 * (R_0 * z102)
        z104 = z4 * z86
        z105 = R_3 * z104
        z106 = z16 * z91
        z107 = z4 * z106
        z108 = R_1 * z106
        z109 = z4 * z108
        s4 = 2.0 * (z43 * z81) + 4.0 * (R_2 * z105) - 4.0 * (z85 * z107)
        z110 = s4 + 4.0 * (z36 * z109)
        z111 = k1 * z82
        z112 = z14 * z111
        z113 = R_3 * z112
        z114 = z44 * z81
        z115 = R_1 * z86
        z116 = R_2 * z108
        s5 = z42 * z86 + z1 * z114 - z17 * z115 - z25 * z106 + z21 * z108
        z117 = s5 + z18 * z116
        z118 = R_y2 * z111
        s6 = 4.0 * z117 + k1 * (2.0 * (z45 * z80) - 4.0 * (z26 * z91))
        z119 = s6 - 4.0 * (z1 * z118)
        z120 = 8.0 * (R_2 * z112) - 4.0 * (R_1 * z118)
        z121 = z54 * (z119 + R_1 * z120 - 8.0 * (R_0 * z113))
        s7 = z110 - 8.0 * (z4 * z113) - 2.0 * (R_0 * z121)
        z122 = s7 - 4.0 * (z29 * z103)
        z123 = R_0 * z83
        z124 = z4 * z123
        z125 = R_3 * z124
        z126 = R_0 * z106
        z127 = z4 * z126
        z128 = R_3 * z127
        z129 = 4.0 * (R_1 * z128)
        z130 = k1 * z80
        z131 = z32 * z130
        z132 = z31 * z130
        z133 = R_2 * z131 - R_1 * z132
        s8 = 2.0 * (z43 * z83) + 4.0 * (R_2 * z125) - 2.0 * (z35 * z106)
        z134 = s8 - z129 + 8.0 * (z4 * z133)
        z135 = z44 * z83 - z36 * z106
        z136 = R_1 * z123 + R_2 * z126
        s9 = 4.0 * (z42 * z123 + z1 * z135 - z17 * z136 - z21 * z126)
        z137 = s9 + 2.0 * (k1 * (z45 * z82 - z38 * z91))
        z138 = R_1 * z131
        z139 = R_3 * z132
        s10 = z137 + 8.0 * (R_3 * z138) + 8.0 * (R_2 * z139)
        z140 = z54 * (s10 + 8.0 * (R_0 * z133))
        s11 = z134 - 2.0 * (R_0 * z140) - 2.0 * (z40 * z103) - z48 * z122
        z141 = z74 * s11
        z142 = z47 * z122 - z48 * z141
        z143 = z37 * z81
        z144 = 2.0 * (R_3 * z143)
        z145 = z10 * z88
        s12 = z144 - 4.0 * (z23 * z83) - 4.0 * (R_0 * z90)
        z146 = s12 + 8.0 * (z4 * z101) + 2.0 * (R_1 * (z102 - 4.0 * z145))
        z147 = 2.0 * (z34 * z86)
        z148 = z4 * (z115 - z116)
        s13 = z129 + (z147 - 4.0 * (z23 * z106)) - 4.0 * (z5 * z118)
        z149 = s13 + z4 * z120 - 2.0 * (R_1 * (z121 + 4.0 * z148))
        z150 = z149 + 4.0 * (z29 * z146)
        z151 = z37 * z106
        s14 = 2.0 * (z34 * z123 + R_3 * z151) - 4.0 * (R_0 * z128)
        z152 = s14 + 8.0 * (z11 * z131) - 8.0 * (z7 * z132)
        z153 = z140 + 4.0 * (z4 * z136)
        s15 = z152 - 2.0 * (R_1 * z153) + 2.0 * (z40 * z146) - z48 * z150
        z154 = z74 * s15
        z155 = z47 * z150 - z48 * z154
        z156 = 4.0 * (z10 * z99)
        s16 = z156 - (z147 - 4.0 * (z19 * z87) + 8.0 * (z5 * z93) - z156)
        z157 = s16 - 2.0 * (R_2 * (z102 - 4.0 * (z125 + z145)))
        s17 = z144 - 4.0 * (R_0 * z105) + 4.0 * (z19 * z108)
        s18 = 2.0 * (R_2 * (z121 + 4.0 * (z128 + z148)))
        z158 = s17 - 8.0 * (z5 * z112) + s18
        z159 = z158 + 4.0 * (z29 * z157)
        z160 = z37 * z83
        s19 = 2.0 * (R_3 * z160) - 4.0 * (R_0 * z125) - 2.0 * (z34 * z126)
        z161 = s19 - 8.0 * (z7 * z131)
        s20 = z161 - 8.0 * (z4 * z139) + 2.0 * (R_2 * z153)
        z162 = s20 + 2.0 * (z40 * z157) - z48 * z159
        z163 = z74 * z162
        z164 = z47 * z159 - z48 * z163
        z165 = 4.0 * (z11 * z99)
        s21 = 2.0 * (R_1 * z143) - 4.0 * (z24 * z84) - 4.0 * (z20 * z89)
        z166 = s21 + 8.0 * (z7 * z93)
        s22 = 2.0 * (R_3 * (z102 - (4.0 * (z4 * z96) - 8.0 * (z4 * z97))))
        z167 = z165 - (z166 - z165) - s22
        z168 = 4.0 * (z11 * z118)
        s23 = 2.0 * (R_2 * z143) - 4.0 * (z41 * z104) + 4.0 * (z24 * z107)
        z169 = s23 - 4.0 * (z20 * z109)
        s24 = 2.0 * (R_3 * (z121 - (4.0 * (z4 * z114) + 8.0 * (z4 * z116))))
        z170 = z168 + (z169 + 8.0 * (z7 * z112) + z168) + s24
        z171 = z170 + 4.0 * (z29 * z167)
        s25 = 2.0 * (R_2 * z160) - 4.0 * (z41 * z124) - 2.0 * (R_1 * z151)
        z172 = s25 + 4.0 * (z20 * z127)
        s26 = z172 - 8.0 * (z10 * z132) - 8.0 * (z4 * z138)
        z173 = s26 + 2.0 * (R_3 * (z140 - 4.0 * (z4 * z135)))
        z174 = z74 * (z173 + 2.0 * (z40 * z167) - z48 * z171)
        z175 = z47 * z171 - z48 * z174
        z176 = w3 * k3
        z177 = z74 * (w2 * k4 - z48 * z176)
        z178 = z47 * z176 - z48 * z177
        z179 = w3 * k2
        z180 = z29 * z179
        z181 = z74 * (z75 + 2.0 * (z40 * z179) - 4.0 * (z48 * z180))
        z182 = 4.0 * (z47 * z180) - z48 * z181
        z183 = z78 + 4.0 * (z29 * z76)
        z184 = z74 * (2.0 * (z40 * z76) - z48 * z183)
        z185 = z47 * z183 - z48 * z184
        s27 = 2.0 * (z62 - (z7 * z50 + z10 * z51 - z62))
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
            4.0 * (R_3 * z60) - s27,
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
            z28 * z103 - 4.0 * (z29 * z142) - 2.0 * (z40 * z141),
            # (I.2.15)
            -(z28 * z146 + 4.0 * (z29 * z155) + 2.0 * (z40 * z154)),
            # (I.2.15)
            z28 * z157 + 4.0 * (z29 * z164) + 2.0 * (z40 * z163),
            # (I.2.15)
            z28 * z167 + 4.0 * (z29 * z175) + 2.0 * (z40 * z174),
            # (I.2.15)
            4.0 * (z29 * z178) + 2.0 * (z40 * z177),
            # (I.2.15)
            z28 * z179 + 4.0 * (z29 * z182) + 2.0 * (z40 * z181),
            # (I.2.15)
            z28 * z76 + 4.0 * (z29 * z185) + 2.0 * (z40 * z184),
            0.0,
            0.0,
            # (I.2.15)
            z142,
            # (I.2.15)
            z155,
            # (I.2.15)
            -z164,
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
            -z141,
            # (I.2.15)
            -z154,
            # (I.2.15)
            z163,
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
        # from the parameters alone
        k1 = m * a * a
        k2 = I1 + k1
        k3 = I2 + k1
        # from the state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = I1 * w1
        z3 = I3 * w3
        z4 = I2 * w2
        s1 = k1 * (R_2 * w1 - (R_0 * w3 + R_1 * w2))
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
