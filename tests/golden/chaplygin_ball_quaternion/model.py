"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:d3802051a05cbad7).

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

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]
2: R_norm [N*m]

Outputs:
out[0] = K_x [kg*m^2/s]
out[1] = K_y [kg*m^2/s]
out[2] = K_z [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 52 +-, 113 *, 4 /, 0 calls
velocities: 23 +-, 47 *, 1 /, 0 calls
accelerations: 84 +-, 179 *, 4 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 29 +-, 50 *, 1 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 48 +-, 108 *, 4 /, 0 calls
energy: 19 +-, 41 *, 1 /, 0 calls
jacobian: 212 +-, 519 *, 4 /, 0 calls
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
        z1 = R_2 * R_2
        z2 = R_1 * R_1 + z1
        z3 = R_3 * R_3
        z4 = 1.0 / (z2 + (R_0 * R_0 + z3))
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
        z16 = k1 * z4
        z17 = R_1 * z11
        z18 = R_0 * z17
        s1 = R_1 * (R_2 * (1.0 - (2.0 * z3 + z2) * z4) - z18) + z1 * z8
        z19 = z16 * s1
        z20 = 1.0 / z13
        z21 = z20 * z19
        z22 = z15 - 16.0 * (z19 * z21)
        # the mass matrix is singular
        if not abs(z22) > 1e-13 * z15:
            raise _refuse(abs(z22), 1e-13 * z15, 2, "rhs")
        z23 = R_3 * z10
        z24 = z23 - R_1 * z7
        z25 = z17 + R_2 * z7
        z26 = I3 + 4.0 * (k1 * (z24 * z24 + z25 * z25))
        z27 = R_3 * (1.0 - 2.0 * z12)
        z28 = 1.0 - 2.0 * (z2 * z4)
        z29 = z16 * (R_1 * z27 + R_0 * (R_2 * z28 - 2.0 * z18))
        z30 = z20 * z29
        s2 = z16 * (R_2 * z27 - R_0 * (R_1 * z28 + 2.0 * (R_0 * z23)))
        z31 = 2.0 * s2 - 8.0 * (z19 * z30)
        z32 = 1.0 / z22
        z33 = z31 * z32
        z34 = z26 - 4.0 * (z29 * z30) - z31 * z33
        # the mass matrix is singular
        if not abs(z34) > 1e-13 * z26:
            raise _refuse(abs(z34), 1e-13 * z26, 2, "rhs")
        z35 = w2 * w3 * k2
        z36 = w1 * w3 * k3 + 4.0 * (z35 * z21)
        z37 = (w1 * w2 * k4 - 2.0 * (z35 * z30) + z33 * z36) / z34
        z38 = z32 * z36 + z33 * z37
        dydt: list[float] = [
            # x' (I.2.4)
            a * (2.0 * (w3 * z24) + (w2 * R_y2 + 2.0 * (w1 * z9))),
            # y' (I.2.4)
            -a * (2.0 * (w3 * z25) + (2.0 * (w2 * z14) + w1 * R_x1)),
            # R_0' (I.2.4)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.4)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.4)
            (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5,
            # R_3' (I.2.4)
            0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)),
            # w1' (I.2.15) 21:4
            z35 * z20 + 4.0 * (z21 * z38) - 2.0 * (z30 * z37),
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
        z1 = R_2 * R_2
        z2 = R_1 * R_1 + z1
        z3 = R_3 * R_3
        z4 = 1.0 / (z2 + (R_0 * R_0 + z3))
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
        z16 = k1 * z4
        z17 = R_1 * z8
        s1 = z1 * z8 + R_1 * (R_2 * (1.0 - (2.0 * z3 + z2) * z4) - z17)
        z18 = z16 * s1
        z19 = 1.0 / z13
        z20 = z18 * z19
        z21 = z15 - 16.0 * (z18 * z20)
        # the mass matrix is singular
        if not abs(z21) > 1e-13 * z15:
            raise _refuse(abs(z21), 1e-13 * z15, 2, "accelerations")
        z22 = R_3 * z10 - R_1 * z7
        z23 = R_1 * z11 + R_2 * z7
        z24 = I3 + 4.0 * (k1 * (z22 * z22 + z23 * z23))
        z25 = R_3 * (1.0 - 2.0 * z12)
        z26 = 1.0 - 2.0 * (z2 * z4)
        z27 = z16 * (R_1 * z25 + R_0 * (R_2 * z26 - 2.0 * z17))
        z28 = z27 * z19
        s2 = z16 * (R_2 * z25 - R_0 * (R_1 * z26 + 2.0 * (R_2 * z8)))
        z29 = 2.0 * s2 - 8.0 * (z18 * z28)
        z30 = 1.0 / z21
        z31 = z29 * z30
        z32 = z24 - 4.0 * (z27 * z28) - z29 * z31
        # the mass matrix is singular
        if not abs(z32) > 1e-13 * z24:
            raise _refuse(abs(z32), 1e-13 * z24, 2, "accelerations")
        z33 = w2 * w3 * k2
        z34 = w1 * w3 * k3 + 4.0 * (z33 * z20)
        z35 = (w1 * w2 * k4 - 2.0 * (z33 * z28) + z31 * z34) / z32
        z36 = z30 * z34 + z31 * z35
        z37 = z33 * z19 + 4.0 * (z20 * z36) - 2.0 * (z28 * z35)
        s3 = 2.0 * (0.5 * (w1 * (w3 * R_y2 - 2.0 * (w2 * z22))) + z9 * z37)
        z38 = 2.0 * (w2 * (w1 * z22 - w3 * z9)) - R_y2 * z36 + s3
        s4 = 2.0 * (0.5 * (w3 * (2.0 * (w2 * z9) - w1 * R_y2)) + z22 * z35)
        z39 = a * (s4 + z38)
        s5 = 0.5 * (w2 * (2.0 * (w1 * z23) - w3 * R_x1)) - z14 * z36
        z40 = 2.0 * s5 + (2.0 * (w1 * (w3 * z14 - w2 * z23)) + R_x1 * z37)
        s6 = 0.5 * (w3 * (w2 * R_x1 - 2.0 * (w1 * z14))) + z23 * z35
        z41 = a * (2.0 * s6 + z40)
        z42 = R_0 * w3 + (R_1 * w2 - R_2 * w1)
        z43 = R_2 * w3 + (R_0 * w1 - R_3 * w2)
        z44 = R_1 * w3 - (R_0 * w2 + R_3 * w1)
        s7 = 0.5 * (w1 * z43) + R_1 * z37 - (0.5 * (w2 * z44) + R_2 * z36)
        z45 = 0.5 * (w3 * z42) + R_3 * z35 + s7
        z46 = R_3 * w3 + (R_1 * w1 + R_2 * w2)
        s8 = 0.5 * (w1 * z46) - R_0 * z37 + (0.5 * (w2 * z42) - R_3 * z36)
        z47 = 0.5 * (w3 * z44) - R_2 * z35 + s8
        s9 = 0.5 * (w2 * z46) + R_0 * z36 - (0.5 * (w1 * z42) + R_3 * z37)
        z48 = 0.5 * (w3 * z43) + R_1 * z35 + s9
        s10 = 0.5 * (w2 * z43) - R_1 * z36 + (0.5 * (w1 * z44) - R_2 * z37)
        z49 = 0.5 * (w3 * z46) - R_0 * z35 - s10
        qddot: list[float] = [
            # x'' (I.2.15)
            z39,
            # y'' (I.2.15)
            -z41,
            # R_0'' (I.2.15)
            -0.5 * z45,
            # R_1'' (I.2.15)
            -0.5 * z47,
            # R_2'' (I.2.15)
            -0.5 * z48,
            # R_3'' (I.2.15)
            -0.5 * z49,
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
        z1 = R_1 * R_1
        z2 = R_2 * R_2
        z3 = z1 + z2
        z4 = R_3 * R_3
        z5 = 1.0 / (z3 + (R_0 * R_0 + z4))
        z6 = R_0 * z5
        z7 = R_3 * z6
        z8 = R_1 * R_2
        z9 = z5 * z8
        z10 = z7 + z9
        R_x1 = 1.0 - 2.0 * ((z2 + z4) * z5)
        z11 = I1 + (4.0 * (k1 * (z10 * z10)) + k1 * (R_x1 * R_x1))
        # the mass matrix is singular
        if not abs(z11) > 0.0:
            raise _refuse(abs(z11), 0.0, 2, "reactions")
        z12 = z7 - z9
        R_y2 = 1.0 - 2.0 * ((z1 + z4) * z5)
        z13 = I2 + (4.0 * (k1 * (z12 * z12)) + k1 * (R_y2 * R_y2))
        z14 = k1 * z5
        z15 = R_0 * R_1
        z16 = R_3 * z5
        z17 = z15 * z16
        s1 = R_1 * (R_2 * (1.0 - (2.0 * z4 + z3) * z5) - z17)
        z18 = z14 * (s1 + R_0 * z2 * z16)
        z19 = 1.0 / z11
        z20 = z18 * z19
        z21 = z13 - 16.0 * (z18 * z20)
        # the mass matrix is singular
        if not abs(z21) > 1e-13 * z13:
            raise _refuse(abs(z21), 1e-13 * z13, 2, "reactions")
        z22 = R_1 * z16 + R_2 * z6
        z23 = R_1 * z6 - R_2 * z16
        z24 = I3 + 4.0 * (k1 * (z22 * z22 + z23 * z23))
        z25 = 1.0 - 2.0 * (z3 * z5)
        z26 = R_1 * R_3
        z27 = 1.0 - 2.0 * (R_3 * z16)
        z28 = z14 * (R_0 * (R_2 * z25 - 2.0 * z17) + z26 * z27)
        z29 = z28 * z19
        z30 = R_0 * R_2
        z31 = R_2 * R_3
        s2 = z14 * (R_0 * (R_1 * z25 + 2.0 * (z30 * z16)) - z31 * z27)
        z32 = 2.0 * s2 + 8.0 * (z18 * z29)
        z33 = 1.0 / z21
        z34 = z32 * z33
        z35 = z24 - 4.0 * (z28 * z29) - z32 * z34
        # the mass matrix is singular
        if not abs(z35) > 1e-13 * z24:
            raise _refuse(abs(z35), 1e-13 * z24, 2, "reactions")
        z36 = k2 * z5
        z37 = w2 * w3 * k3
        z38 = w1 * w3 * k4 + 4.0 * (z37 * z20)
        z39 = (w1 * w2 * k5 - 2.0 * (z37 * z29) - z34 * z38) / z35
        z40 = z36 * z39
        z41 = z33 * z38 - z34 * z39
        z42 = z37 * z19 + 4.0 * (z20 * z41) - 2.0 * (z29 * z39)
        z43 = R_0 * R_3
        s3 = 2.0 * (z42 * ((z43 + z8) * z36)) - k2 * (R_y2 * z41)
        z44 = 2.0 * ((z15 - z31) * z40) - s3
        s4 = k2 * (R_x1 * z42) + 2.0 * (z41 * ((z43 - z8) * z36))
        z45 = 2.0 * ((z26 + z30) * z40) + s4
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
    """energy T + V [J]

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
        z1 = R_2 * R_2
        z2 = R_1 * R_1 + z1
        z3 = R_3 * R_3
        z4 = 1.0 / (z2 + (R_0 * R_0 + z3))
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
        z16 = k1 * z4
        z17 = 2.0 * z3 + z2
        z18 = 1.0 - z17 * z4
        z19 = R_0 * R_1
        z20 = R_3 * z19
        z21 = z20 * z4
        z22 = R_2 * z18 - z21
        z23 = R_0 * z1
        z24 = R_3 * z23
        z25 = R_1 * z22 + z24 * z4
        z26 = z16 * z25
        z27 = 1.0 / z13
        z28 = z27 * z26
        z29 = z15 - 16.0 * (z26 * z28)
        # the mass matrix is singular
        if not abs(z29) > 1e-13 * z15:
            raise _refuse(abs(z29), 1e-13 * z15, 2, "jacobian")
        z30 = R_3 * z10 - R_1 * z7
        z31 = R_1 * z11 + R_2 * z7
        z32 = I3 + 4.0 * (k1 * (z30 * z30 + z31 * z31))
        z33 = R_1 * R_3
        z34 = 1.0 - 2.0 * z12
        z35 = 1.0 - 2.0 * (z2 * z4)
        z36 = R_2 * z35 - 2.0 * z21
        z37 = z33 * z34 + R_0 * z36
        z38 = z16 * z37
        z39 = z27 * z38
        z40 = R_2 * R_3
        z41 = R_0 * R_2
        z42 = R_3 * z41
        z43 = R_1 * z35 + 2.0 * (z42 * z4)
        z44 = z40 * z34 - R_0 * z43
        z45 = 2.0 * (z16 * z44) - 8.0 * (z26 * z39)
        z46 = 1.0 / z29
        z47 = z45 * z46
        z48 = z32 - 4.0 * (z38 * z39) - z45 * z47
        # the mass matrix is singular
        if not abs(z48) > 1e-13 * z32:
            raise _refuse(abs(z48), 1e-13 * z32, 2, "jacobian")
        z49 = a * w1
        z50 = a * w3
        z51 = R_3 * z49 - R_1 * z50
        z52 = z4 * z51
        z53 = a * w2
        z54 = R_3 * z53
        z55 = R_3 * z50
        z56 = R_2 * z49
        z57 = z56 - R_1 * z53
        z58 = z4 * z4
        z59 = (R_3 * z54 - R_2 * z55 - R_1 * z57 - R_0 * z51) * z58
        z60 = z7 * z50 + z5 * z53
        z61 = z11 * z53
        z62 = z54 - R_2 * z50
        z63 = R_2 * z53
        z64 = (R_3 * z51 + R_2 * z56 - R_1 * z63 + R_0 * z62) * z58
        z65 = z10 * z49
        z66 = 0.5 * w1
        z67 = 0.5 * w2
        z68 = 0.5 * w3
        z69 = 0.5 * R_1
        z70 = 0.5 * R_2
        z71 = 0.5 * R_3
        z72 = 0.5 * R_0
        z73 = 1.0 / z48
        z74 = w1 * k4
        z75 = w2 * k2
        z76 = w3 * z75
        z77 = w1 * k3
        z78 = w3 * z77 + 4.0 * (z76 * z28)
        z79 = z73 * (w2 * z74 - 2.0 * (z76 * z39) + z47 * z78)
        z80 = z16 * z79
        z81 = z46 * z78 + z47 * z79
        z82 = z16 * z81
        z83 = z4 * z82
        z84 = R_3 * z1
        z85 = R_0 * z80
        z86 = R_1 * z82
        z87 = z85 - z86
        z88 = z4 * z87
        z89 = R_3 * z88
        z90 = z27 * z76 + 4.0 * (z28 * z81) - 2.0 * (z39 * z79)
        z91 = k1 * z90
        z92 = z9 * z91
        z93 = R_3 * z92
        s1 = 2.0 * (z36 * z80) - 4.0 * (z83 * z84) - 4.0 * (R_1 * z89)
        z94 = s1 + 8.0 * (z4 * z93)
        z95 = z33 * z80
        z96 = R_2 * z86
        s2 = z3 * z95 + z85 * (R_2 * z2) + z24 * z82 + z20 * z87
        z97 = 4.0 * (s2 - z17 * z96)
        z98 = R_x1 * z91
        s3 = z97 - k1 * (2.0 * (z37 * z79) - 4.0 * (z25 * z81))
        z99 = s3 + 4.0 * (z3 * z98) + 4.0 * (z1 * z98)
        z100 = R_2 * z92
        z101 = z58 * (z99 - 8.0 * (R_1 * z100) - 8.0 * (R_0 * z93))
        z102 = z94 + 2.0 * (R_0 * z101)
        z103 = z4 * z85
        z104 = R_3 * z103
        z105 = z16 * z90
        z106 = z4 * z105
        z107 = R_1 * z105
        z108 = z4 * z107
        s4 = 2.0 * (z43 * z80) + 4.0 * (R_2 * z104) - 4.0 * (z84 * z106)
        z109 = s4 + 4.0 * (z33 * z108)
        z110 = k1 * z81
        z111 = z14 * z110
        z112 = R_3 * z111
        z113 = z40 * z80
        z114 = R_1 * z85
        z115 = R_2 * z107
        s5 = z42 * z85 + z3 * z113 - z2 * z114 - z24 * z105 + z20 * z107
        z116 = s5 + z17 * z115
        z117 = R_y2 * z110
        s6 = 4.0 * z116 - k1 * (2.0 * (z44 * z79) + 4.0 * (z25 * z90))
        z118 = s6 - 4.0 * (z3 * z117)
        z119 = 8.0 * (R_2 * z111) - 4.0 * (R_1 * z117)
        z120 = z58 * (z118 + R_1 * z119 - 8.0 * (R_0 * z112))
        s7 = z109 - 8.0 * (z4 * z112) - 2.0 * (R_0 * z120)
        z121 = s7 + 4.0 * (z28 * z102)
        z122 = R_0 * z82
        z123 = z4 * z122
        z124 = R_3 * z123
        z125 = R_0 * z105
        z126 = z4 * z125
        z127 = R_3 * z126
        z128 = 4.0 * (R_1 * z127)
        z129 = k1 * z79
        z130 = z31 * z129
        z131 = z30 * z129
        z132 = R_2 * z130 - R_1 * z131
        s8 = 2.0 * (z43 * z82) + 4.0 * (R_2 * z124) + 2.0 * (z36 * z105)
        z133 = s8 - z128 + 8.0 * (z4 * z132)
        z134 = z40 * z82 - z33 * z105
        z135 = R_1 * z122 + R_2 * z125
        s9 = 4.0 * (z42 * z122 + z3 * z134 - z2 * z135 - z20 * z125)
        z136 = s9 - 2.0 * (k1 * (z44 * z81 - z37 * z90))
        z137 = R_1 * z130
        z138 = R_3 * z131
        s10 = z136 + 8.0 * (R_3 * z137) + 8.0 * (R_2 * z138)
        z139 = z58 * (s10 + 8.0 * (R_0 * z132))
        s11 = z133 - 2.0 * (R_0 * z139) - 2.0 * (z39 * z102) + z47 * z121
        z140 = z73 * s11
        z141 = z46 * z121 + z47 * z140
        z142 = z34 * z80
        z143 = 2.0 * (R_3 * z142)
        z144 = z10 * z87
        s12 = z143 - 4.0 * (z22 * z82) - 4.0 * (R_0 * z89)
        z145 = s12 + 8.0 * (z4 * z100) + 2.0 * (R_1 * (z101 - 4.0 * z144))
        z146 = 2.0 * (z35 * z85)
        z147 = z4 * (z114 - z115)
        s13 = z128 + (z146 - 4.0 * (z22 * z105)) - 4.0 * (z5 * z117)
        z148 = s13 + z4 * z119 - 2.0 * (R_1 * (z120 + 4.0 * z147))
        z149 = z148 + 4.0 * (z28 * z145)
        z150 = z34 * z105
        s14 = 2.0 * (z35 * z122 + R_3 * z150) - 4.0 * (R_0 * z127)
        z151 = s14 + 8.0 * (z11 * z130) - 8.0 * (z7 * z131)
        z152 = z139 + 4.0 * (z4 * z135)
        s15 = z151 - 2.0 * (R_1 * z152) - 2.0 * (z39 * z145) + z47 * z149
        z153 = z73 * s15
        z154 = z46 * z149 + z47 * z153
        z155 = 4.0 * (z10 * z98)
        s16 = z155 - (z146 - 4.0 * (z18 * z86) + 8.0 * (z5 * z92) - z155)
        z156 = s16 - 2.0 * (R_2 * (z101 - 4.0 * (z124 + z144)))
        s17 = z143 - 4.0 * (R_0 * z104) + 4.0 * (z18 * z107)
        s18 = 2.0 * (R_2 * (z120 + 4.0 * (z127 + z147)))
        z157 = s17 - 8.0 * (z5 * z111) + s18
        z158 = z157 + 4.0 * (z28 * z156)
        z159 = z34 * z82
        s19 = 2.0 * (R_3 * z159) - 4.0 * (R_0 * z124) - 2.0 * (z35 * z125)
        z160 = s19 - 8.0 * (z7 * z130)
        s20 = z160 - 8.0 * (z4 * z138) + 2.0 * (R_2 * z152)
        z161 = s20 - 2.0 * (z39 * z156) + z47 * z158
        z162 = z73 * z161
        z163 = z46 * z158 + z47 * z162
        z164 = 4.0 * (z11 * z98)
        s21 = 2.0 * (R_1 * z142) - 4.0 * (z23 * z83) - 4.0 * (z19 * z88)
        z165 = s21 + 8.0 * (z7 * z92)
        s22 = 2.0 * (R_3 * (z101 - (4.0 * (z4 * z95) - 8.0 * (z4 * z96))))
        z166 = z164 - (z165 - z164) - s22
        z167 = 4.0 * (z11 * z117)
        s23 = 2.0 * (R_2 * z142) - 4.0 * (z41 * z103) + 4.0 * (z23 * z106)
        z168 = s23 - 4.0 * (z19 * z108)
        s24 = 2.0 * (R_3 * (z120 - (4.0 * (z4 * z113) + 8.0 * (z4 * z115))))
        z169 = z167 + (z168 + 8.0 * (z7 * z111) + z167) + s24
        z170 = z169 + 4.0 * (z28 * z166)
        s25 = 2.0 * (R_2 * z159) - 4.0 * (z41 * z123) - 2.0 * (R_1 * z150)
        z171 = s25 + 4.0 * (z19 * z126)
        s26 = z171 - 8.0 * (z10 * z131) - 8.0 * (z4 * z137)
        z172 = s26 + 2.0 * (R_3 * (z139 - 4.0 * (z4 * z134)))
        z173 = z73 * (z172 - 2.0 * (z39 * z166) + z47 * z170)
        z174 = z46 * z170 + z47 * z173
        z175 = w3 * k3
        z176 = z73 * (w2 * k4 + z175 * z47)
        z177 = z175 * z46 + z47 * z176
        z178 = w3 * k2
        z179 = z178 * z28
        z180 = z73 * (z74 - 2.0 * (z178 * z39) + 4.0 * (z47 * z179))
        z181 = 4.0 * (z46 * z179) + z47 * z180
        z182 = z77 + 4.0 * (z75 * z28)
        z183 = z73 * (2.0 * (z75 * z39) - z47 * z182)
        z184 = z46 * z182 - z47 * z183
        s27 = 2.0 * (z61 - (z7 * z49 + z10 * z50 - z61))
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            2.0 * z52 + 4.0 * (R_0 * z59),
            # (I.2.15)
            4.0 * (R_1 * z59) - 2.0 * (z60 - z4 * z57),
            # (I.2.15)
            2.0 * (z5 * z49 + z4 * z55) + 4.0 * (R_2 * z59),
            # (I.2.15)
            4.0 * (R_3 * z59) - s27,
            # (I.2.15)
            2.0 * (a * z9),
            # (I.2.15)
            a * R_y2,
            # (I.2.15)
            2.0 * (a * z30),
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (z4 * z62) - 4.0 * (R_0 * z64),
            # (I.2.15)
            -(4.0 * (R_1 * z64) + 2.0 * (z4 * (z55 + z63))),
            # (I.2.15)
            2.0 * (z65 - (z60 - z65)) - 4.0 * (R_2 * z64),
            # (I.2.15)
            2.0 * (z52 + (z7 * z53 + z11 * z49)) - 4.0 * (R_3 * z64),
            # (I.2.15)
            -a * R_x1,
            # (I.2.15)
            -2.0 * (a * z14),
            # (I.2.15)
            -2.0 * (a * z31),
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
            2.0 * (z39 * z140) - (z27 * z102 + 4.0 * (z28 * z141)),
            # (I.2.15)
            2.0 * (z39 * z153) - (z27 * z145 + 4.0 * (z28 * z154)),
            # (I.2.15)
            z27 * z156 + 4.0 * (z28 * z163) - 2.0 * (z39 * z162),
            # (I.2.15)
            z27 * z166 + 4.0 * (z28 * z174) - 2.0 * (z39 * z173),
            # (I.2.15)
            4.0 * (z28 * z177) - 2.0 * (z39 * z176),
            # (I.2.15)
            z27 * z178 + 4.0 * (z28 * z181) - 2.0 * (z39 * z180),
            # (I.2.15)
            z27 * z75 + 4.0 * (z28 * z184) + 2.0 * (z39 * z183),
            0.0,
            0.0,
            # (I.2.15)
            z141,
            # (I.2.15)
            z154,
            # (I.2.15)
            -z163,
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
            -z140,
            # (I.2.15)
            -z153,
            # (I.2.15)
            z162,
            # (I.2.15)
            z173,
            # (I.2.15)
            z176,
            # (I.2.15)
            z180,
            # (I.2.15)
            -z183,
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
