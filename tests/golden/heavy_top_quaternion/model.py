"""heavy_top_quaternion, emitted by nhc 0.1.0 (nhc:f5dbacda94215264).

The symmetric top with a fixed point (Lagrange's top), its orientation a quaternion,
    so that it may stand upright.
Equations of motion: euler-lagrange (I.2.15)
Why: angular velocities and quasi-velocities of the spec

State y:
y[0] = R_0 [1]: quaternion of R, scalar part
y[1] = R_1 [1]: quaternion of R, along x
y[2] = R_2 [1]: quaternion of R, along y
y[3] = R_3 [1]: quaternion of R, along z
y[4] = w1 [rad/s]
y[5] = w2 [rad/s]
y[6] = w3 [rad/s]

Parameters p:
p[0]: I1 = 1.0 [kg*m^2]: across the axis, at the fixed point
p[1]: I3 = 1.5 [kg*m^2]: about the axis
p[2]: mgl = 2.0 [N*m]: weight times the distance of the centre of mass

Constraints, with the units of their reactions:
0: R_norm [N*m]

Outputs:
out[0] = height [1]
out[1] = L_z [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 16 +-, 32 *, 2 /, 0 calls
velocities: 8 +-, 16 *, 0 /, 0 calls
accelerations: 16 +-, 33 *, 2 /, 0 calls
state: 12 +-, 23 *, 1 /, 0 calls
residuals: 3 +-, 5 *, 0 /, 0 calls
positions: 4 +-, 4 *, 0 /, 0 calls
reactions: 0 +-, 0 *, 0 /, 0 calls
energy: 7 +-, 12 *, 1 /, 0 calls
jacobian: 14 +-, 56 *, 2 /, 0 calls
outputs: 9 +-, 17 *, 1 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("R_0", "R_1", "R_2", "R_3")
STATE: tuple[str, ...] = ("R_0", "R_1", "R_2", "R_3", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("I1", "I3", "mgl")
CONSTRAINTS: tuple[str, ...] = ("R_norm",)
OUTPUTS: tuple[str, ...] = ("height", "L_z")
DEFAULTS: tuple[float, ...] = (1.0, 1.5, 2.0)

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

    Arguments: t (scalar), y (7,), p (3,).
    Returns dydt (7,).
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "rhs")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = I1 - I3
        k2 = 1.0 / I1
        # from the state
        s1 = 2.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z1 = mgl * s1
        z2 = w3 * k1
        dydt: list[float] = [
            # R_0' (I.2.4)
            -0.5 * (R_3 * w3 + (R_1 * w1 + R_2 * w2)),
            # R_1' (I.2.4)
            0.5 * (R_2 * w3 + (R_0 * w1 - R_3 * w2)),
            # R_2' (I.2.4)
            (R_3 * w1 + R_0 * w2 - R_1 * w3) * 0.5,
            # R_3' (I.2.4)
            0.5 * (R_0 * w3 - (R_2 * w1 - R_1 * w2)),
            # w1' (I.2.15) 12:4
            k2 * (z1 * (R_0 * R_1 + R_2 * R_3) + w2 * z2),
            # w2' (I.2.15) 12:4
            k2 * (z1 * (R_0 * R_2 - R_1 * R_3) - w1 * z2),
            # w3' (I.2.15) 12:4
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
    """All velocities q' from the state (I.2.4).

    Arguments: t (scalar), y (7,), p (3,).
    Returns qdot (4,).
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    try:
        # from the state
        qdot: list[float] = [
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
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (7,), p (3,).
    Returns qddot (4,).
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "accelerations")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = 1.0 / I1
        k2 = 1.0 - I3 * k1
        k3 = mgl * k1
        # from the state
        z1 = 0.25 * (w3 * w3 + (w1 * w1 + w2 * w2))
        z2 = R_1 * R_1 + R_2 * R_2
        z3 = R_0 * R_0 + R_3 * R_3
        z4 = k3 / (z2 + z3)
        z5 = z1 + z2 * z4
        z6 = w3 * k2
        z7 = z1 - z3 * z4
        qddot: list[float] = [
            # R_0'' (I.2.15)
            0.5 * ((R_2 * w1 - R_1 * w2) * z6) - R_0 * z5,
            # R_1'' (I.2.15)
            0.5 * ((R_3 * w1 + R_0 * w2) * z6) - R_1 * z7,
            # R_2'' (I.2.15)
            -(R_2 * z7 + 0.5 * ((R_0 * w1 - R_3 * w2) * z6)),
            # R_3'' (I.2.15)
            -(R_3 * z5 + 0.5 * ((R_1 * w1 + R_2 * w2) * z6)),
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

    Arguments: t (scalar), q (4,), qdot (4,), p (3,).
    Returns y (7,).
    """
    R_0 = float(q[0])  # quaternion of R, scalar part [1]
    R_1 = float(q[1])  # quaternion of R, along x [1]
    R_2 = float(q[2])  # quaternion of R, along y [1]
    R_3 = float(q[3])  # quaternion of R, along z [1]
    R_0_dot = float(qdot[0])  # R_0' [1/s]
    R_1_dot = float(qdot[1])  # R_1' [1/s]
    R_2_dot = float(qdot[2])  # R_2' [1/s]
    R_3_dot = float(qdot[3])  # R_3' [1/s]
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
        y: list[float] = [R_0, R_1, R_2, R_3, 2.0 * s1, 2.0 * s2, 2.0 * s3]
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

    Arguments: t (scalar), q (4,), qdot (4,), p (3,).
    Returns r (1,).
    """
    R_0 = float(q[0])  # quaternion of R, scalar part [1]
    R_1 = float(q[1])  # quaternion of R, along x [1]
    R_2 = float(q[2])  # quaternion of R, along y [1]
    R_3 = float(q[3])  # quaternion of R, along z [1]
    R_0_dot = float(qdot[0])  # R_0' [1/s]
    R_1_dot = float(qdot[1])  # R_1' [1/s]
    R_2_dot = float(qdot[2])  # R_2' [1/s]
    R_3_dot = float(qdot[3])  # R_3' [1/s]
    try:
        # from the coordinates and velocities
        s1 = R_2 * R_2_dot + (R_0 * R_0_dot + R_1 * R_1_dot)
        r: list[float] = [
            # R_norm = 0 (I.1.1) 7:3
            2.0 * (R_3 * R_3_dot + s1),
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

    Arguments: t (scalar), q (4,), p (3,).
    Returns f (1,).
    """
    R_0 = float(q[0])  # quaternion of R, scalar part [1]
    R_1 = float(q[1])  # quaternion of R, along x [1]
    R_2 = float(q[2])  # quaternion of R, along y [1]
    R_3 = float(q[3])  # quaternion of R, along z [1]
    try:
        # from the coordinates
        f: list[float] = [
            # R_norm = 0 7:3
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

    Arguments: t (scalar), y (7,), p (3,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "reactions")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "reactions")
        # from the state
        lambda_: list[float] = [
            # reaction of R_norm: Q_i gains lambda_1 a_1i (I.4.1) 7:3
            0.0,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (7,), p (3,).
    Returns a scalar.
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # from the state
        z1 = R_1 * R_1 + R_2 * R_2
        s1 = mgl * (1.0 - 2.0 * (z1 / (z1 + (R_0 * R_0 + R_3 * R_3))))
        z2 = 0.5 * (I1 * (w1 * w1 + w2 * w2) + I3 * (w3 * w3)) + s1
        value1 = z2
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (7,), p (3,).
    Returns rows (7, 7): d rhs_i / d y_j stands at [i][j].
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "jacobian")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = 1.0 / I1
        k2 = (I1 - I3) * k1
        # from the state
        z1 = 0.5 * w1
        z2 = 0.5 * w2
        z3 = 0.5 * w3
        z4 = 0.5 * R_1
        z5 = 0.5 * R_2
        z6 = 0.5 * R_3
        z7 = 0.5 * R_0
        z8 = 1.0 / (R_3 * R_3 + (R_2 * R_2 + (R_0 * R_0 + R_1 * R_1)))
        z9 = mgl * z8
        z10 = 2.0 * (R_1 * z9)
        z11 = mgl * (z8 * z8)
        z12 = (R_0 * R_1 + R_2 * R_3) * z11
        z13 = 2.0 * (R_0 * z9)
        z14 = 2.0 * (R_3 * z9)
        z15 = 2.0 * (R_2 * z9)
        z16 = w3 * k2
        z17 = (R_0 * R_2 - R_1 * R_3) * z11
        J: list[float] = [
            0.0,
            # (I.2.15)
            -z1,
            # (I.2.15)
            -z2,
            # (I.2.15)
            -z3,
            # (I.2.15)
            -z4,
            # (I.2.15)
            -z5,
            # (I.2.15)
            -z6,
            # (I.2.15)
            z1,
            0.0,
            # (I.2.15)
            z3,
            # (I.2.15)
            -z2,
            # (I.2.15)
            z7,
            # (I.2.15)
            -z6,
            # (I.2.15)
            z5,
            # (I.2.15)
            z2,
            # (I.2.15)
            -z3,
            0.0,
            # (I.2.15)
            z1,
            # (I.2.15)
            z6,
            # (I.2.15)
            z7,
            # (I.2.15)
            -z4,
            # (I.2.15)
            z3,
            # (I.2.15)
            z2,
            # (I.2.15)
            -z1,
            0.0,
            # (I.2.15)
            -z5,
            # (I.2.15)
            z4,
            # (I.2.15)
            z7,
            # (I.2.15)
            k1 * (z10 - 4.0 * (R_0 * z12)),
            # (I.2.15)
            k1 * (z13 - 4.0 * (R_1 * z12)),
            # (I.2.15)
            k1 * (z14 - 4.0 * (R_2 * z12)),
            # (I.2.15)
            k1 * (z15 - 4.0 * (R_3 * z12)),
            0.0,
            # (I.2.15)
            z16,
            # (I.2.15)
            w2 * k2,
            # (I.2.15)
            k1 * (z15 - 4.0 * (R_0 * z17)),
            # (I.2.15)
            -k1 * (z14 + 4.0 * (R_1 * z17)),
            # (I.2.15)
            k1 * (z13 - 4.0 * (R_2 * z17)),
            # (I.2.15)
            -k1 * (z10 + 4.0 * (R_3 * z17)),
            # (I.2.15)
            -z16,
            0.0,
            # (I.2.15)
            -w1 * k2,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 7] for k3 in range(0, 49, 7)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (7,), p (3,).
    Returns out (2,).
    """
    R_0 = float(y[0])  # quaternion of R, scalar part [1]
    R_1 = float(y[1])  # quaternion of R, along x [1]
    R_2 = float(y[2])  # quaternion of R, along y [1]
    R_3 = float(y[3])  # quaternion of R, along z [1]
    w1 = float(y[4])  # [rad/s]
    w2 = float(y[5])  # [rad/s]
    w3 = float(y[6])  # [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    try:
        # from the state
        z1 = R_1 * R_1 + R_2 * R_2
        z2 = 1.0 / (z1 + (R_0 * R_0 + R_3 * R_3))
        z3 = I3 * w3
        s1 = R_0 * (R_2 * w1 - R_1 * w2) - R_3 * (R_1 * w1 + R_2 * w2)
        z4 = I1 * s1 + z3 * z1
        out: list[float] = [
            # height 15:11
            1.0 - 2.0 * (z1 * z2),
            # L_z 16:8
            z3 - 2.0 * (z2 * z4),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
