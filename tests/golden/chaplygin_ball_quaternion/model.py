"""chaplygin_ball_quaternion, emitted by nhc 0.1.0 (nhc:4c20d73a72c652e4).

A ball with three different moments of inertia rolls on a horizontal plane; its
    orientation is a quaternion.
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
rhs: 46 +-, 76 *, 4 /, 0 calls
velocities: 23 +-, 47 *, 1 /, 0 calls
accelerations: 78 +-, 158 *, 4 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 29 +-, 50 *, 1 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 37 +-, 85 *, 4 /, 0 calls
energy: 15 +-, 37 *, 1 /, 0 calls
jacobian: 153 +-, 350 *, 4 /, 0 calls
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
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (9,), p (5,).
    Returns dydt (9,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = a * (m * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
        z1 = 2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_1 * z1
        z3 = R_1 * z2
        z4 = R_2 * z1
        z5 = R_2 * z4
        R_z3 = 1.0 - (z3 + z5)
        z6 = k1 * R_z3 * R_z3
        z7 = R_3 * z4
        z8 = R_0 * z1
        z9 = R_1 * z8
        R_z2 = z7 + z9
        z10 = R_z2 * R_z2
        z11 = I1 + z6 + k1 * z10
        # the mass matrix is singular, if z11 is 0
        if not abs(z11) > 0.0:
            raise _refuse(abs(z11), 0.0, 2, "rhs")
        z12 = R_3 * z1
        z13 = R_1 * z12
        z14 = R_2 * z8
        R_z1 = z13 - z14
        z15 = R_z1 * R_z1
        z16 = I2 + z6 + k1 * z15
        z17 = R_z2 * k1
        z18 = R_z1 * z17
        z19 = 1.0 / z11
        z20 = z19 * z18
        z21 = z16 - z18 * z20
        # the mass matrix is singular, if z21 is nearly 0
        if not abs(z21) > 1e-13 * z16:
            raise _refuse(abs(z21), 1e-13 * z16, 2, "rhs")
        z22 = I3 + k1 * (z10 + z15)
        z23 = k1 * (R_z1 * R_z3)
        z24 = z23 * z19
        z25 = R_z3 * z17 + z24 * z18
        z26 = 1.0 / z21
        z27 = z25 * z26
        z28 = z22 - z23 * z24 - z25 * z27
        # the mass matrix is singular, if z28 is nearly 0
        if not abs(z28) > 1e-13 * z22:
            raise _refuse(abs(z28), 1e-13 * z22, 2, "rhs")
        z29 = R_3 * z12
        z30 = R_2 * z2
        z31 = R_3 * z8
        z32 = w2 * w3 * k2
        z33 = w1 * w3 * k3 - z32 * z20
        z34 = (w1 * w2 * k4 + z32 * z24 - z27 * z33) / z28
        z35 = z26 * z33 - z27 * z34
        s1 = (z7 - z9) * w3 + ((1.0 - (z3 + z29)) * w2 + (z30 + z31) * w1)
        s2 = (z30 - z31) * w2 + (1.0 - (z5 + z29)) * w1
        dydt: list[float] = [
            # x' (I.2.4)
            a * s1,
            # y' (I.2.4)
            -a * ((z13 + z14) * w3 + s2),
            # R_0' (I.2.4)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.4)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.4)
            (R_0 * w2 + R_3 * w1 - R_1 * w3) * 0.5,
            # R_3' (I.2.4)
            0.5 * (R_0 * w3 + (R_1 * w2 - R_2 * w1)),
            # w1' (I.2.15) 21:4
            z32 * z19 - z20 * z35 + z24 * z34,
            # w2' (I.2.15) 21:4
            -z35,
            # w3' (I.2.15) 21:4
            z34,
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

    Arguments: t (scalar), y (9,), p (5,).
    Returns qdot (6,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (9,), p (5,).
    Returns qddot (6,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = a * (m * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_1 * z1
        z3 = R_1 * z2
        z4 = R_2 * z1
        z5 = R_2 * z4
        R_z3 = 1.0 - 2.0 * (z3 + z5)
        z6 = k1 * R_z3 * R_z3
        z7 = R_3 * z4
        z8 = R_0 * z1
        z9 = R_1 * z8
        z10 = z7 + z9
        z11 = z10 * z10
        z12 = I1 + z6 + 4.0 * (k1 * z11)
        # the mass matrix is singular, if z12 is 0
        if not abs(z12) > 0.0:
            raise _refuse(abs(z12), 0.0, 2, "accelerations")
        z13 = R_3 * z1
        z14 = R_1 * z13
        z15 = R_2 * z8
        z16 = z14 - z15
        z17 = z16 * z16
        z18 = I2 + z6 + 4.0 * (k1 * z17)
        z19 = z10 * k1
        z20 = z16 * z19
        z21 = 1.0 / z12
        z22 = z21 * z20
        z23 = z18 - 16.0 * (z20 * z22)
        # the mass matrix is singular, if z23 is nearly 0
        if not abs(z23) > 1e-13 * z18:
            raise _refuse(abs(z23), 1e-13 * z18, 2, "accelerations")
        z24 = I3 + 4.0 * (k1 * (z11 + z17))
        z25 = k1 * (z16 * R_z3)
        z26 = z25 * z21
        z27 = 2.0 * (R_z3 * z19) + 8.0 * (z26 * z20)
        z28 = 1.0 / z23
        z29 = z27 * z28
        z30 = z24 - 4.0 * (z25 * z26) - z27 * z29
        # the mass matrix is singular, if z30 is nearly 0
        if not abs(z30) > 1e-13 * z24:
            raise _refuse(abs(z30), 1e-13 * z24, 2, "accelerations")
        z31 = R_2 * z2
        z32 = R_3 * z8
        z33 = z31 + z32
        z34 = R_3 * z13
        R_y2 = 1.0 - 2.0 * (z3 + z34)
        z35 = z7 - z9
        z36 = w2 * w3 * k2
        z37 = w1 * w3 * k3 - 4.0 * (z36 * z22)
        z38 = (w1 * w2 * k4 + 2.0 * (z36 * z26) - z29 * z37) / z30
        z39 = z28 * z37 - z29 * z38
        z40 = z36 * z21 - 4.0 * (z22 * z39) + 2.0 * (z26 * z38)
        s1 = 0.5 * (w1 * (R_y2 * w3 - 2.0 * (z35 * w2))) + z33 * z40
        z41 = 2.0 * (w2 * (z35 * w1 - z33 * w3)) - R_y2 * z39 + 2.0 * s1
        s2 = 0.5 * (w3 * (2.0 * (z33 * w2) - R_y2 * w1)) + z35 * z38
        z42 = a * (2.0 * s2 + z41)
        R_x1 = 1.0 - 2.0 * (z5 + z34)
        z43 = z31 - z32
        z44 = z14 + z15
        s3 = 0.5 * (w2 * (2.0 * (z44 * w1) - R_x1 * w3)) - z43 * z39
        z45 = 2.0 * s3 + (2.0 * (w1 * (z43 * w3 - z44 * w2)) + R_x1 * z40)
        s4 = 0.5 * (w3 * (R_x1 * w2 - 2.0 * (z43 * w1))) + z44 * z38
        z46 = a * (2.0 * s4 + z45)
        z47 = R_0 * w3 + (R_1 * w2 - R_2 * w1)
        z48 = R_2 * w3 + (R_0 * w1 - R_3 * w2)
        z49 = R_1 * w3 - (R_0 * w2 + R_3 * w1)
        s5 = 0.5 * (w1 * z48) + R_1 * z40 - (0.5 * (w2 * z49) + R_2 * z39)
        z50 = 0.5 * (w3 * z47) + R_3 * z38 + s5
        z51 = R_3 * w3 + (R_1 * w1 + R_2 * w2)
        s6 = 0.5 * (w1 * z51) - R_0 * z40 + (0.5 * (w2 * z47) - R_3 * z39)
        z52 = 0.5 * (w3 * z49) - R_2 * z38 + s6
        s7 = 0.5 * (w2 * z51) + R_0 * z39 - (0.5 * (w1 * z47) + R_3 * z40)
        z53 = 0.5 * (w3 * z48) + R_1 * z38 + s7
        s8 = 0.5 * (w2 * z48) - R_1 * z39 + (0.5 * (w1 * z49) - R_2 * z40)
        z54 = 0.5 * (w3 * z51) - R_0 * z38 - s8
        qddot: list[float] = [
            # x'' (I.2.15)
            z42,
            # y'' (I.2.15)
            -z46,
            # R_0'' (I.2.15)
            -0.5 * z50,
            # R_1'' (I.2.15)
            -0.5 * z52,
            # R_2'' (I.2.15)
            -0.5 * z53,
            # R_3'' (I.2.15)
            -0.5 * z54,
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
    Returns y (9,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # y: centre [m]
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    R_0_dot = float(qdot[2])  # R_0' [1/s]
    R_1_dot = float(qdot[3])  # R_1' [1/s]
    R_2_dot = float(qdot[4])  # R_2' [1/s]
    R_3_dot = float(qdot[5])  # R_3' [1/s]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (6,), qdot (6,), p (5,).
    Returns r (3,).
    """
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    R_0_dot = float(qdot[2])  # R_0' [1/s]
    R_1_dot = float(qdot[3])  # R_1' [1/s]
    R_2_dot = float(qdot[4])  # R_2' [1/s]
    R_3_dot = float(qdot[5])  # R_3' [1/s]
    a = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each holonomic constraint, zero on every motion.

    Arguments: t (scalar), q (6,), p (5,).
    Returns f (1,).
    """
    R_0 = float(q[2])  # quaternion of R, scalar part [1]
    R_1 = float(q[3])  # quaternion of R, along x [1]
    R_2 = float(q[4])  # quaternion of R, along y [1]
    R_3 = float(q[5])  # quaternion of R, along z [1]
    try:
        # from the coordinates
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
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (9,), p (5,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a
        k2 = a * k1
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        # from the state
        z1 = R_3 * R_3
        z2 = R_1 * R_1
        z3 = R_0 * R_0 + z2
        z4 = 1.0 / (z1 + (R_2 * R_2 + z3))
        z5 = R_2 * z4
        z6 = R_0 * z4
        z7 = R_3 * z5 + R_1 * z6
        z8 = z7 * z7
        R_z3 = 1.0 - 2.0 * (R_2 * z5 + z2 * z4)
        z9 = k2 * R_z3 * R_z3
        z10 = 4.0 * (k2 * z8) + (I1 + z9)
        # the mass matrix is singular, if z10 is 0
        if not abs(z10) > 0.0:
            raise _refuse(abs(z10), 0.0, 2, "reactions")
        z11 = R_1 * R_3
        z12 = R_2 * z6 - z4 * z11
        z13 = z12 * z12
        z14 = I2 + z9 + 4.0 * (k2 * z13)
        z15 = z7 * k2
        z16 = z15 * z12
        z17 = 1.0 / z10
        z18 = z16 * z17
        z19 = z14 - 16.0 * (z16 * z18)
        # the mass matrix is singular, if z19 is nearly 0
        if not abs(z19) > 1e-13 * z14:
            raise _refuse(abs(z19), 1e-13 * z14, 2, "reactions")
        z20 = I3 + 4.0 * (k2 * (z8 + z13))
        z21 = k2 * (z12 * R_z3)
        z22 = z21 * z17
        z23 = 2.0 * (z15 * R_z3) + 8.0 * (z16 * z22)
        z24 = 1.0 / z19
        z25 = z23 * z24
        z26 = z20 - 4.0 * (z21 * z22) - z23 * z25
        # the mass matrix is singular, if z26 is nearly 0
        if not abs(z26) > 1e-13 * z20:
            raise _refuse(abs(z26), 1e-13 * z20, 2, "reactions")
        z27 = z4 * k1
        z28 = w2 * w3 * k3
        z29 = w1 * w3 * k4 + 4.0 * (z28 * z18)
        z30 = (w1 * w2 * k5 - 2.0 * (z28 * z22) - z25 * z29) / z26
        z31 = z27 * z30
        z32 = R_1 * R_2
        z33 = R_0 * R_3
        z34 = z24 * z29 - z25 * z30
        z35 = z28 * z17 + 4.0 * (z18 * z34) - 2.0 * (z22 * z30)
        s1 = k1 * ((1.0 - 2.0 * (z4 * (z2 + z1))) * z34)
        z36 = 2.0 * ((z32 + z33) * (z27 * z35)) - s1
        s2 = k1 * ((1.0 - 2.0 * (z3 * z4)) * z35)
        s3 = s2 + 2.0 * ((z32 - z33) * (z27 * z34))
        z37 = 2.0 * ((z11 + R_0 * R_2) * z31) - s3
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 23:5
            2.0 * ((R_2 * R_3 - R_0 * R_1) * z31) + z36,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 24:5
            -z37,
            # reaction of R_norm: Q_i gains lambda_3 a_3i (I.4.1) 10:3
            0.0,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (9,), p (5,).
    Returns a scalar.
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the state
        z1 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z2 = R_1 * z1
        z3 = R_2 * z1
        R_z3 = 1.0 - 2.0 * (R_1 * z2 + R_2 * z3)
        z4 = a * w2
        z5 = R_0 * z1
        z6 = R_3 * z3 + R_1 * z5
        z7 = a * w3
        z8 = R_z3 * z4 - 2.0 * (z6 * z7)
        z9 = a * w1
        z10 = R_2 * z5 - R_3 * z2
        z11 = R_z3 * z9 + 2.0 * (z7 * z10)
        z12 = z6 * z9 + z4 * z10
        s1 = I1 * (w1 * w1) + I2 * (w2 * w2) + I3 * (w3 * w3)
        z13 = s1 + m * (z8 * z8 + z11 * z11 + 4.0 * (z12 * z12))
        value1 = 0.5 * z13
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (9,), p (5,).
    Returns rows (9, 9): d rhs_i / d y_j stands at [i][j].
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = a * (m * a)
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        # from the state
        z1 = R_1 * R_1
        z2 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + z1)))
        z3 = R_1 * z2
        z4 = R_1 * z3
        z5 = R_2 * z2
        z6 = R_2 * z5
        R_z3 = 1.0 - 2.0 * (z4 + z6)
        z7 = k1 * R_z3 * R_z3
        z8 = R_3 * z5
        z9 = R_0 * z2
        z10 = R_1 * z9
        z11 = z8 + z10
        z12 = z11 * z11
        z13 = I1 + z7 + 4.0 * (k1 * z12)
        # the mass matrix is singular, if z13 is 0
        if not abs(z13) > 0.0:
            raise _refuse(abs(z13), 0.0, 2, "jacobian")
        z14 = R_3 * z2
        z15 = R_1 * z14
        z16 = R_2 * z9
        z17 = z15 - z16
        z18 = z17 * z17
        z19 = I2 + z7 + 4.0 * (k1 * z18)
        z20 = z11 * k1
        z21 = z17 * z20
        z22 = 1.0 / z13
        z23 = z22 * z21
        z24 = z19 - 16.0 * (z21 * z23)
        # the mass matrix is singular, if z24 is nearly 0
        if not abs(z24) > 1e-13 * z19:
            raise _refuse(abs(z24), 1e-13 * z19, 2, "jacobian")
        z25 = I3 + 4.0 * (k1 * (z12 + z18))
        z26 = k1 * (z17 * R_z3)
        z27 = z26 * z22
        z28 = 2.0 * (R_z3 * z20) + 8.0 * (z27 * z21)
        z29 = 1.0 / z24
        z30 = z28 * z29
        z31 = z25 - 4.0 * (z26 * z27) - z28 * z30
        # the mass matrix is singular, if z31 is nearly 0
        if not abs(z31) > 1e-13 * z25:
            raise _refuse(abs(z31), 1e-13 * z25, 2, "jacobian")
        z32 = a * w1
        z33 = a * w3
        z34 = R_3 * z32 - R_1 * z33
        z35 = z2 * z34
        z36 = z2 * z2
        z37 = a * w2
        z38 = R_3 * z37
        z39 = R_3 * z33
        z40 = R_2 * z32
        z41 = z40 - R_1 * z37
        z42 = z36 * (R_3 * z38 - R_2 * z39 - R_1 * z41 - R_0 * z34)
        z43 = z9 * z33 + z3 * z37
        z44 = z14 * z37
        z45 = R_2 * z3
        z46 = R_3 * z9
        z47 = R_3 * z14
        z48 = z38 - R_2 * z33
        z49 = R_2 * z37
        z50 = z36 * (R_3 * z34 + R_2 * z40 - R_1 * z49 + R_0 * z48)
        z51 = z5 * z32
        z52 = 0.5 * w1
        z53 = 0.5 * w2
        z54 = 0.5 * w3
        z55 = 0.5 * R_1
        z56 = 0.5 * R_2
        z57 = 0.5 * R_3
        z58 = 0.5 * R_0
        z59 = 1.0 / z31
        z60 = w1 * k4
        z61 = w2 * k2
        z62 = w3 * z61
        z63 = w1 * k3
        z64 = w3 * z63 - 4.0 * (z23 * z62)
        z65 = z59 * (w2 * z60 + 2.0 * (z27 * z62) - z30 * z64)
        z66 = k1 * z65
        z67 = 2.0 * (R_z3 * z66)
        z68 = z29 * z64 - z30 * z65
        z69 = k1 * z68
        z70 = z11 * z69
        z71 = z67 - 4.0 * z70
        z72 = z17 * z69
        z73 = k1 * (z22 * z62 - 4.0 * (z23 * z68) + 2.0 * (z27 * z65))
        z74 = z11 * z73
        z75 = 4.0 * z72 + 8.0 * z74
        z76 = R_2 * z71 + R_1 * z75
        z77 = R_1 * z71
        z78 = z17 * z66
        z79 = R_z3 * z73
        z80 = z78 - z79
        z81 = R_3 * z75 + 4.0 * (R_2 * z80)
        z82 = z36 * (R_3 * z77 - R_2 * z81 - 4.0 * (z1 * z80) - R_0 * z76)
        z83 = z2 * z76 + 2.0 * (R_0 * z82)
        z84 = 8.0 * z72 + 4.0 * z74
        z85 = z17 * z73
        z86 = z67 + 4.0 * z85
        z87 = R_2 * z84 - R_1 * z86
        z88 = R_1 * z84
        z89 = z11 * z66
        z90 = R_z3 * z69
        z91 = z89 + z90
        z92 = R_3 * z86 - 4.0 * (R_2 * z91)
        z93 = z36 * (R_3 * z88 + R_2 * z92 - 4.0 * (z1 * z91) - R_0 * z87)
        z94 = z2 * z87 + 2.0 * (R_0 * z93) + 4.0 * (z23 * z83)
        z95 = 8.0 * z78 - 2.0 * z79
        z96 = 8.0 * z89 + 2.0 * z90
        z97 = R_2 * z95 - R_1 * z96
        z98 = R_1 * z95
        z99 = z70 - z85
        z100 = R_3 * z96 - 4.0 * (R_2 * z99)
        z101 = z36 * (R_3 * z98 + R_2 * z100 - 4.0 * (z1 * z99) - R_0 * z97)
        s1 = z2 * z97 + 2.0 * (R_0 * z101) - 2.0 * (z27 * z83)
        z102 = z59 * (s1 - z30 * z94)
        z103 = z29 * z94 - z30 * z102
        z104 = 4.0 * (z3 * z80)
        z105 = 2.0 * (R_1 * z82) + (z104 - (z14 * z71 - z9 * z75 - z104))
        z106 = 4.0 * (z3 * z91)
        s2 = 2.0 * (R_1 * z93) + (z106 - (z14 * z84 + z9 * z86 - z106))
        z107 = s2 + 4.0 * (z23 * z105)
        z108 = 4.0 * (z3 * z99)
        s3 = 2.0 * (R_1 * z101) + (z108 - (z14 * z95 + z9 * z96 - z108))
        z109 = s3 - 2.0 * (z27 * z105)
        z110 = z59 * (z109 - z30 * z107)
        z111 = z29 * z107 - z30 * z110
        z112 = z9 * z71 + 4.0 * (z5 * z80) + z2 * z81 + 2.0 * (R_2 * z82)
        s4 = z9 * z84 + 4.0 * (z5 * z91) - z2 * z92 + 2.0 * (R_2 * z93)
        z113 = s4 + 4.0 * (z23 * z112)
        s5 = z9 * z95 + 4.0 * (z5 * z99) - z2 * z100 + 2.0 * (R_2 * z101)
        z114 = s5 - 2.0 * (z27 * z112)
        z115 = z59 * (z114 - z30 * z113)
        z116 = z29 * z113 - z30 * z115
        z117 = z5 * z75 - z2 * z77 + 2.0 * (R_3 * z82)
        z118 = z5 * z86 + z2 * z88 - 2.0 * (R_3 * z93) - 4.0 * (z23 * z117)
        s6 = z5 * z96 + z2 * z98 - 2.0 * (R_3 * z101)
        z119 = s6 + 2.0 * (z27 * z117) - z30 * z118
        z120 = z59 * z119
        z121 = z29 * z118 - z30 * z120
        z122 = w3 * k3
        z123 = z59 * (w2 * k4 - z30 * z122)
        z124 = z29 * z122 - z30 * z123
        z125 = w3 * k2
        z126 = z23 * z125
        z127 = z59 * (z60 + 2.0 * (z27 * z125) + 4.0 * (z30 * z126))
        z128 = 4.0 * (z29 * z126) + z30 * z127
        z129 = z63 - 4.0 * (z23 * z61)
        z130 = z59 * (2.0 * (z27 * z61) - z30 * z129)
        z131 = z29 * z129 - z30 * z130
        s7 = 2.0 * (z44 - (z9 * z32 + z5 * z33 - z44))
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            2.0 * z35 + 4.0 * (R_0 * z42),
            # (I.2.15)
            4.0 * (R_1 * z42) - 2.0 * (z43 - z2 * z41),
            # (I.2.15)
            2.0 * (z3 * z32 + z2 * z39) + 4.0 * (R_2 * z42),
            # (I.2.15)
            4.0 * (R_3 * z42) - s7,
            # (I.2.15)
            2.0 * (a * (z45 + z46)),
            # (I.2.15)
            a * (1.0 - 2.0 * (z4 + z47)),
            # (I.2.15)
            2.0 * (a * (z8 - z10)),
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (z2 * z48) - 4.0 * (R_0 * z50),
            # (I.2.15)
            -(4.0 * (R_1 * z50) + 2.0 * (z2 * (z39 + z49))),
            # (I.2.15)
            2.0 * (z51 - (z43 - z51)) - 4.0 * (R_2 * z50),
            # (I.2.15)
            2.0 * (z35 + (z9 * z37 + z14 * z32)) - 4.0 * (R_3 * z50),
            # (I.2.15)
            (2.0 * (z6 + z47) - 1.0) * a,
            # (I.2.15)
            -2.0 * (a * (z45 - z46)),
            # (I.2.15)
            -2.0 * (a * (z15 + z16)),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z52,
            # (I.2.15)
            -z53,
            # (I.2.15)
            -z54,
            # (I.2.15)
            -z55,
            # (I.2.15)
            -z56,
            # (I.2.15)
            -z57,
            0.0,
            0.0,
            # (I.2.15)
            z52,
            0.0,
            # (I.2.15)
            z54,
            # (I.2.15)
            -z53,
            # (I.2.15)
            z58,
            # (I.2.15)
            -z57,
            # (I.2.15)
            z56,
            0.0,
            0.0,
            # (I.2.15)
            z53,
            # (I.2.15)
            -z54,
            0.0,
            # (I.2.15)
            z52,
            # (I.2.15)
            z57,
            # (I.2.15)
            z58,
            # (I.2.15)
            -z55,
            0.0,
            0.0,
            # (I.2.15)
            z54,
            # (I.2.15)
            z53,
            # (I.2.15)
            -z52,
            0.0,
            # (I.2.15)
            -z56,
            # (I.2.15)
            z55,
            # (I.2.15)
            z58,
            0.0,
            0.0,
            # (I.2.15)
            2.0 * (z27 * z102) - (z22 * z83 + 4.0 * (z23 * z103)),
            # (I.2.15)
            2.0 * (z27 * z110) - (z22 * z105 + 4.0 * (z23 * z111)),
            # (I.2.15)
            2.0 * (z27 * z115) - (z22 * z112 + 4.0 * (z23 * z116)),
            # (I.2.15)
            -(z22 * z117 - 4.0 * (z23 * z121) + 2.0 * (z27 * z120)),
            # (I.2.15)
            2.0 * (z27 * z123) - 4.0 * (z23 * z124),
            # (I.2.15)
            z22 * z125 + 4.0 * (z23 * z128) + 2.0 * (z27 * z127),
            # (I.2.15)
            z22 * z61 - 4.0 * (z23 * z131) + 2.0 * (z27 * z130),
            0.0,
            0.0,
            # (I.2.15)
            -z103,
            # (I.2.15)
            -z111,
            # (I.2.15)
            -z116,
            # (I.2.15)
            z121,
            # (I.2.15)
            -z124,
            # (I.2.15)
            z128,
            # (I.2.15)
            -z131,
            0.0,
            0.0,
            # (I.2.15)
            z102,
            # (I.2.15)
            z110,
            # (I.2.15)
            z115,
            # (I.2.15)
            -z120,
            # (I.2.15)
            z123,
            # (I.2.15)
            z127,
            # (I.2.15)
            z130,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 9] for k5 in range(0, 81, 9)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (9,), p (5,).
    Returns out (3,).
    """
    R_0 = float(y[2])  # quaternion of R, scalar part [1]
    R_1 = float(y[3])  # quaternion of R, along x [1]
    R_2 = float(y[4])  # quaternion of R, along y [1]
    R_3 = float(y[5])  # quaternion of R, along z [1]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
