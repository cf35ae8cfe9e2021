"""affine_voronec, emitted by nhc 0.1.0 (nhc:5347453191f4c261).

A particle with everything at once; affine constraint, time, T of degrees 2, 1 and
    0, drag, a driving force.
Source: affine_voronec.yaml
Equations of motion: voronec (I.4.9)
Why: dependent velocities of the spec

State y:
y[0] = x
y[1] = y
y[2] = z
y[3] = x'
y[4] = y'

No parameters.

Constraints:
0: contact

Operations:
rhs: 62 +-, 105 *, 2 /, 4 calls
velocities: 4 +-, 9 *, 0 /, 3 calls
accelerations: 67 +-, 109 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 9 *, 0 /, 3 calls
reactions: 72 +-, 110 *, 2 /, 4 calls
energy: 18 +-, 36 *, 0 /, 4 calls
jacobian: 200 +-, 356 *, 2 /, 4 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "z")
STATE: tuple[str, ...] = ("x", "y", "z", "x'", "y'")
PARAMETERS: tuple[str, ...] = ()
CONSTRAINTS: tuple[str, ...] = ("contact",)
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = ()

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
    """right-hand side dy/dt = f(t, y; p) (I.4.9)

    Arguments: t (scalar), y (5,), p (0,).
    Returns dydt (5,).
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = 1.0 + z * z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        c_z = math.cos(z)
        z3 = y_2 * c_z
        z4 = 0.1 * s_t
        z5 = 1.0 + z4
        z6 = z3 * z5
        z7 = c_z * z2
        z8 = 0.3 * z7
        z9 = x * x
        z10 = 1.0 + z9
        z11 = z10 * z2
        z12 = z8 + z6 * z11
        z13 = z1 * z2 + z6 * (z8 + z12)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "rhs")
        z14 = x * z
        z15 = z14 * z12
        z16 = 1.0 / z13
        z17 = z15 * z16
        s_z = math.sin(z)
        z18 = 2.0 + s_z
        z19 = z18 * z2 + 0.25 * (z11 * (z14 * z14))
        z20 = 0.25 * (z15 * z17) - z19
        # the mass matrix is singular
        if not abs(-z20) > 1e-14 * z19:
            raise SingularModelError(2, "rhs")
        z21 = y_dot * z14
        c_t = math.cos(t_)
        z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        z23 = 0.06 * (c_z * c_t)
        z24 = s_z * z22
        z25 = 0.3 * z24
        z26 = z * x_dot
        z27 = x * z22
        z28 = z2 * x_dot * x_dot
        s1 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24))
        s2 = 0.4 - 0.8 * (s_t * s_t) + (z26 + z27) * (0.3 + 0.5 * y_dot)
        z29 = s1 + s2
        s3 = 0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t)))
        z30 = 0.3 * (z7 * z29) - s3
        s4 = x_dot * (0.1 + 0.2 * (z1 * c_t))
        s5 = z22 * (0.1 * t_ - z23 + z2 * (z25 - (2.0 * z26 - z27)))
        z31 = s5 - (s4 + (z * z6 * (3.0 - z28) + z30))
        z32 = c_z * y_dot * y_dot
        z33 = x_dot * z24
        z34 = x + t_ * x_dot
        z35 = z4 - 0.05 * z22
        s6 = x_dot * (z23 + z2 * (2.0 * z27 - z25))
        z36 = s6 + (z11 * z29 + 0.2 * (z10 * c_t * z22))
        s7 = 0.1 * z34 - (z35 - (0.3 * y_dot - 0.2 * z9) - z36)
        z37 = z2 * (0.5 * z32 - 0.3 * z33) - s7
        z38 = z31 + z6 * z37
        s8 = 0.05 * z34 - (0.1 * z9 + 0.5 * z35 - 0.5 * z36)
        z39 = z2 * (0.25 * z32 - 0.15 * z33) - s8
        s9 = 2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z38)
        z40 = 0.15 * z21 - (0.6 * z22 - s9)
        s10 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22))
        z41 = s10 + (z * z14 * (1.5 - 0.5 * z28) + z40)
        z42 = (z14 * z39 - z41) / z20
        dydt: list[float] = [
            # x' (I.4.9)
            x_dot,
            # y' (I.4.9)
            y_dot,
            # z' (I.4.9)
            z22,
            # x'' (I.4.9) 11:4
            z16 * z38 + 0.5 * (z17 * z42),
            # y'' (I.4.9) 11:4
            -z42,
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

    Arguments: t (scalar), y (5,), p (0,).
    Returns qdot (3,).
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        s_t = math.sin(t_)
        c_z = math.cos(z)
        c_t = math.cos(t_)
        s1 = 0.4 * (c_t * s_t) + x * z * (0.3 + 0.5 * y_dot)
        z1 = (1.0 + 0.1 * s_t) * (c_z * (y_2 * x_dot)) + s1
        qdot: list[float] = [
            # x' (I.2.4)
            x_dot,
            # y' (I.2.4)
            y_dot,
            # z' (I.2.4)
            z1,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (I.4.9)

    Arguments: t (scalar), y (5,), p (0,).
    Returns qddot (3,).
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = 1.0 + z * z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        c_z = math.cos(z)
        z3 = y_2 * c_z
        z4 = 0.1 * s_t
        z5 = 1.0 + z4
        z6 = z3 * z5
        z7 = c_z * z2
        z8 = 0.3 * z7
        z9 = x * x
        z10 = 1.0 + z9
        z11 = z10 * z2
        z12 = z8 + z6 * z11
        z13 = z1 * z2 + z6 * (z8 + z12)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "accelerations")
        z14 = x * z
        z15 = z14 * z12
        z16 = 1.0 / z13
        z17 = z15 * z16
        s_z = math.sin(z)
        z18 = 2.0 + s_z
        z19 = z18 * z2 + 0.25 * (z11 * (z14 * z14))
        z20 = 0.25 * (z15 * z17) - z19
        # the mass matrix is singular
        if not abs(-z20) > 1e-14 * z19:
            raise SingularModelError(2, "accelerations")
        z21 = y_dot * z14
        c_t = math.cos(t_)
        z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        z23 = 0.06 * (c_z * c_t)
        z24 = s_z * z22
        z25 = 0.3 * z24
        z26 = z * x_dot
        z27 = x * z22
        z28 = z2 * x_dot * x_dot
        z29 = z26 + z27
        z30 = 0.3 * z29
        z31 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24))
        z32 = y_dot * z29
        z33 = 0.4 - 0.8 * (s_t * s_t)
        z34 = z30 + (z31 + 0.5 * z32) + z33
        s1 = 0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t)))
        z35 = s1 - 0.3 * (z7 * z34)
        s2 = x_dot * (0.1 + 0.2 * (z1 * c_t))
        s3 = z22 * (0.1 * t_ - z23 + z2 * (z25 - (2.0 * z26 - z27)))
        z36 = s3 - (s2 + (z * z6 * (3.0 - z28) - z35))
        z37 = c_z * y_dot * y_dot
        z38 = x_dot * z24
        z39 = x + t_ * x_dot
        z40 = z4 - 0.05 * z22
        s4 = x_dot * (z23 + z2 * (2.0 * z27 - z25))
        z41 = s4 + (0.2 * (z10 * c_t * z22) + z11 * z34)
        s5 = 0.1 * z39 - (z40 - (0.3 * y_dot - 0.2 * z9) - z41)
        z42 = z2 * (0.5 * z37 - 0.3 * z38) - s5
        z43 = z36 + z6 * z42
        s6 = 0.05 * z39 - (0.1 * z9 + 0.5 * z40 - 0.5 * z41)
        z44 = z2 * (0.25 * z37 - 0.15 * z38) - s6
        s7 = 2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z43)
        z45 = 0.15 * z21 - (0.6 * z22 - s7)
        s8 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22))
        z46 = s8 + (z * z14 * (1.5 - 0.5 * z28) + z45)
        z47 = (z14 * z44 - z46) / z20
        z48 = z16 * z43 + 0.5 * (z17 * z47)
        qddot: list[float] = [
            # x'' (I.4.9)
            z48,
            # y'' (I.4.9)
            -z47,
            # z'' (I.4.9)
            z33 + (z30 + (z31 + z6 * z48 + 0.5 * (z32 - z14 * z47))),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns y (5,).
    """
    x = float(q[0])
    y_2 = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    try:
        # state
        y: list[float] = [x, y_2, z, x_dot, y_dot]
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

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns r (1,).
    """
    t_ = float(t)  # time
    x = float(q[0])
    y = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    z_dot = float(qdot[2])
    try:
        # state
        s_t = math.sin(t_)
        c_z = math.cos(z)
        c_t = math.cos(t_)
        s1 = x * z * (0.3 + 0.5 * y_dot) - (z_dot - 0.4 * (c_t * s_t))
        z1 = (1.0 + 0.1 * s_t) * (c_z * (y * x_dot)) + s1
        r: list[float] = [
            # contact = 0 (I.1.1) 18:5
            -z1,
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

    Arguments: t (scalar), y (5,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = 1.0 + z * z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        c_z = math.cos(z)
        z3 = y_2 * c_z
        z4 = 0.1 * s_t
        z5 = 1.0 + z4
        z6 = z3 * z5
        z7 = c_z * z2
        z8 = 0.3 * z7
        z9 = x * x
        z10 = 1.0 + z9
        z11 = z10 * z2
        z12 = z8 + z6 * z11
        z13 = z1 * z2 + z6 * (z8 + z12)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "reactions")
        s_z = math.sin(z)
        z14 = 2.0 + s_z
        z15 = x * z
        z16 = z15 * z11
        z17 = z14 * z2 + 0.25 * (z15 * z16)
        z18 = z15 * z12
        z19 = 1.0 / z13
        z20 = z18 * z19
        z21 = z17 - 0.25 * (z18 * z20)
        # the mass matrix is singular
        if not abs(z21) > 1e-14 * z17:
            raise SingularModelError(2, "reactions")
        z22 = c_z * y_dot * y_dot
        z23 = 0.5 * z22
        z24 = x_dot * x_dot
        z25 = y_dot * z15
        c_t = math.cos(t_)
        z26 = 0.3 * z15 + (x_dot * z6 + 0.5 * z25) + 0.4 * (c_t * s_t)
        z27 = s_z * z26
        z28 = x_dot * z27
        z29 = 0.3 * z28
        z30 = x + t_ * x_dot
        z31 = z4 - 0.05 * z26
        z32 = 0.06 * (c_z * c_t)
        z33 = x * z26
        z34 = 0.3 * z27
        z35 = z * x_dot
        s1 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z27))
        s2 = 0.4 - 0.8 * (s_t * s_t) + (z35 + z33) * (0.3 + 0.5 * y_dot)
        z36 = s1 + s2
        s3 = x_dot * (z32 + z2 * (2.0 * z33 - z34))
        z37 = s3 + (z11 * z36 + 0.2 * (z10 * c_t * z26))
        s4 = 0.05 * z30 - (0.1 * z9 + 0.5 * z31 - 0.5 * z37)
        z38 = z2 * (0.25 * z22 - 0.15 * z28) - s4
        z39 = z24 * z2
        s5 = 0.4 * z15 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t)))
        z40 = 0.3 * (z7 * z36) - s5
        s6 = x_dot * (0.1 + 0.2 * (z1 * c_t))
        s7 = z26 * (0.1 * t_ - z32 + z2 * (z34 - (2.0 * z35 - z33)))
        z41 = s7 - (s6 + (z * z6 * (3.0 - z39) + z40))
        z42 = 0.1 * z30
        z43 = 0.3 * y_dot
        z44 = 0.2 * z9
        s8 = z6 * (z2 * (z23 - z29) - (z42 - (z31 - (z43 - z44) - z37)))
        z45 = z41 + s8
        s9 = 2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z20 * z45)
        z46 = 0.15 * z25 - (0.6 * z26 - s9)
        s10 = y_dot * (0.2 * (z14 * c_t) + (0.2 + z7 * z26))
        z47 = s10 + (z * z15 * (1.5 - 0.5 * z39) + z46)
        s11 = z42 - (z31 + (z44 - (3.0 * z + z43 + z45 * (z12 * z19))))
        s12 = 0.5 * ((z16 - z12 * z20) * ((z15 * z38 - z47) / z21))
        z48 = s12 + (z37 + s11)
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z48 - z2 * (z23 + (z * z24 - z29)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (5,), p (0,).
    Returns a scalar.
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = z * z
        z2 = x * x
        s_t = math.sin(t_)
        s_z = math.sin(z)
        c_z = math.cos(z)
        z3 = y_2 * x_dot
        c_t = math.cos(t_)
        s1 = 0.4 * (c_t * s_t) + x * z * (0.3 + 0.5 * y_dot)
        z4 = (1.0 + 0.1 * s_t) * (c_z * z3) + s1
        s2 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z5 = s2 + (1.0 + z2) * (z4 * z4)
        s3 = 0.4 * (z3 * c_t) - 0.3 * (z * y_dot) + 0.1 * (t_ * x * z4)
        s4 = (1.0 + 0.2 * s_t) * (0.5 * z5 + 0.3 * (x_dot * c_z * z4))
        z6 = s4 + s3
        s5 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        value1 = s5 + (0.2 * (z * z2) + z6)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.4.9)

    Arguments: t (scalar), y (5,), p (0,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = 1.0 + z * z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        c_z = math.cos(z)
        z3 = y_2 * c_z
        z4 = 0.1 * s_t
        z5 = 1.0 + z4
        z6 = z3 * z5
        z7 = c_z * z2
        z8 = 0.3 * z7
        z9 = x * x
        z10 = 1.0 + z9
        z11 = z10 * z2
        z12 = z8 + z6 * z11
        z13 = z1 * z2 + z6 * (z8 + z12)
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_z = math.sin(z)
        z14 = 2.0 + s_z
        z15 = x * z
        z16 = z15 * z11
        z17 = z14 * z2 + 0.25 * (z15 * z16)
        z18 = z15 * z12
        z19 = 1.0 / z13
        z20 = z18 * z19
        z21 = z17 - 0.25 * (z18 * z20)
        # the mass matrix is singular
        if not abs(z21) > 1e-14 * z17:
            raise SingularModelError(2, "jacobian")
        z22 = 0.3 + 0.5 * y_dot
        z23 = x_dot * z5
        c_t = math.cos(t_)
        z24 = y_dot * z15
        z25 = 0.3 * z15 + (x_dot * z6 + 0.5 * z24) + 0.4 * (c_t * s_t)
        z26 = z6 * z25
        z27 = x * z25
        z28 = z * x_dot + z27
        z29 = s_z * z25
        z30 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z29)
        z31 = z28 * z22 - (0.8 * (s_t * s_t) - (0.4 + x_dot * z30))
        z32 = x + t_ * x_dot
        z33 = 0.1 * z32
        z34 = z4 - 0.05 * z25
        z35 = 0.3 * y_dot
        z36 = 0.2 * z9
        z37 = 0.06 * (c_z * c_t)
        z38 = x_dot * z2
        z39 = 0.2 * (z10 * c_t) + 2.0 * (x * z38)
        z40 = x_dot * (z37 - 0.3 * (z2 * z29)) + (z11 * z31 + z25 * z39)
        z41 = x_dot * x_dot
        z42 = z * z6
        z43 = y_dot * y_dot
        z44 = c_z * z6
        z45 = z25 * z25
        z46 = s_z * z6
        z47 = x_dot * z46
        z48 = y_dot * c_t
        z49 = z2 * z25
        z50 = c_t * z25
        s1 = 0.4 * (y_2 * s_t) - (x - 0.1 * (t_ * z25))
        z51 = 3.0 * z42 + (0.06 * (c_z * z50) - s1)
        z52 = 0.2 * (z1 * c_t) + 2.0 * (z * z49)
        s2 = 0.3 * (z49 * z29) - (0.3 * (z7 * z31) - (0.4 * z15 - z51))
        z53 = 0.4 * z48 - s2 + x_dot * (0.1 + z52)
        s3 = 0.5 * (z43 * z44) + (x * z45 - 0.3 * (z47 * z25))
        z54 = z2 * (z41 * z42 + s3) - z53
        z55 = z6 * (z33 - (z34 - (z35 - z36) - z40)) - z54
        z56 = 1.0 / z21
        z57 = 0.05 * z32
        z58 = 0.1 * z9
        z59 = 0.5 * z34
        z60 = 0.5 * z40
        z61 = z * z15
        z62 = c_z * z15
        z63 = s_z * z15
        z64 = x_dot * z63
        z65 = 0.2 * (z14 * c_t) + c_z * z49
        z66 = x_dot * c_t
        s4 = 0.6 * z25 - (1.5 * z61 + (2.0 * y_2 - 0.5 * (z20 * z55)))
        z67 = 0.15 * z24 - (0.4 * z66 + s4)
        s5 = 0.5 * (z41 * z61) + (0.25 * (z43 * z62) - 0.15 * (z64 * z25))
        z68 = z2 * s5 - (y_dot * (0.2 + z65) + z67)
        z69 = z56 * (z15 * (z57 - (z58 + z59 - z60)) - z68)
        z70 = z19 * z55 - 0.5 * (z20 * z69)
        z71 = z6 * z70
        z72 = z15 * z69
        z73 = 0.5 * z72
        z74 = z71 + z73
        z75 = z12 * z22
        z76 = z2 * z26
        z77 = x_dot * z12
        z78 = z5 * z77
        z79 = z2 * z6
        z80 = y_2 * z78 + 0.3 * (z49 + x_dot * z79)
        z81 = 0.1 * t_
        s6 = z37 - (s_z * z80 - (2.0 * (z * z38) - (z81 - x * z75)))
        z82 = s6 + z6 * (0.05 + z39)
        z83 = z2 * (0.3 * z47 - (2.0 * z27 + 0.3 * z29)) + z82
        z84 = 0.4 + 0.5 * (z12 * z69) - z22 * z83
        s7 = 0.1 * z6 + (2.0 * (x_dot * z76) + (1.0 - z * z84))
        z85 = z25 * z75 - (z2 * z45 - s7)
        s8 = 0.4 * (c_t * z26) - z6 * (0.4 - 2.0 * (z2 * (z31 - z74)))
        z86 = x * s8 + z85
        z87 = z15 * z25
        z88 = z15 * z70
        z89 = z16 * (0.15 + 0.25 * y_dot)
        z90 = z2 * z87
        z91 = y_dot * z2
        z92 = z2 * z15
        z93 = x_dot * z16
        z94 = z5 * z93
        z95 = 0.15 * (x_dot * z92) + 0.5 * (y_2 * z94)
        s9 = c_z * z91 - (s_z * z95 + (0.6 - x * z89))
        z96 = 0.15 * (z2 * z64) + s9 + z15 * (0.025 + 0.5 * z39)
        z97 = 0.15 + 0.5 * z96
        z98 = z12 * z70
        z99 = z41 * z2
        z100 = 1.5 - 0.5 * z99
        z101 = z43 * z2
        z102 = c_z * z101
        z103 = x_dot * z49
        z104 = s_z * z103
        s10 = z59 - (z * z100 - (0.25 * z102 + (z58 - 0.15 * z104))) - z60
        z105 = z57 - s10 - 0.25 * (z16 * z69)
        s11 = 0.3 * z96 - (0.5 * z98 - (z105 - 0.25 * (z11 * z72)))
        z106 = y_dot * z97 + s11
        s12 = z15 * (0.2 - z2 * (z31 - z73))
        s13 = 0.05 * z15 - (0.5 * (z20 * z86) - (x_dot * z90 + z * z106))
        s14 = x * (s12 - (0.2 * (c_t * z87) - z79 * z88))
        z107 = s14 - (z25 * z89 + s13)
        z108 = z56 * z107
        z109 = 3.0 - z99
        s15 = z34 - (z * z109 - (0.5 * z102 + (z36 - 0.3 * z104))) - z40
        z110 = z98 - (z33 + (z35 - s15))
        s16 = z5 * (x_dot * z83 - (z110 + z11 * z74 + 0.3 * (z7 * z70)))
        z111 = 0.1 * (c_t * z77) + s16
        z112 = 0.4 * s_t + z29 * z78 - c_z * z111
        z113 = 0.05 * (c_t * z93) + z5 * (x_dot * z96 - 0.5 * (z11 * z88))
        s17 = 2.0 - 0.5 * (z29 * z94) + c_z * z113 + 0.5 * (z20 * z112)
        z114 = z56 * s17
        z115 = c_t * z6
        s18 = y_dot * z78 + (0.06 * z50 - 0.5 * (z6 * z101))
        z116 = s18 - 0.3 * (z2 * (z74 - (z31 - z71)))
        s19 = z6 * z109 + 2.0 * (z25 * z38) + x_dot * z75 - x * z84
        z117 = s19 - s_z * (0.06 * (x_dot * z115) + (z116 + y_2 * z111))
        s20 = c_z * (0.3 * (z6 * z103) - z25 * z80) + z117
        z118 = s20 + 2.0 * (z * (0.2 * z66 - z2 * z70))
        z119 = c_t * z15
        s21 = 0.5 * (y_dot * z94) - (0.25 * (z15 * z101) - z25 * z91)
        z120 = s21 - 0.15 * (z2 * z88) + y_2 * z113
        s22 = s_z * (0.03 * (x_dot * z119) + z120)
        s23 = 0.15 * (z15 * z103) - z25 * z95 + (0.2 * z48 - z2 * z69)
        z121 = z15 * z100 + x_dot * z89 + x * z106 - s22 + c_z * s23
        z122 = z56 * (z121 - 0.5 * (z20 * z118))
        s24 = z * z75 + (0.1 + 2.0 * (x * z76)) - 2.0 * (z42 * z38)
        z123 = 0.06 * (c_z * z115) + s24
        s25 = 0.3 * (z46 * z49) - (0.3 * (z29 * z79) - (z12 * z30 + z123))
        z124 = z6 * (z81 + z83) + (z52 + s25)
        z125 = 0.4 * c_t
        s26 = 0.05 * (t_ * z15) - (z125 - 0.15 * (z63 * z49))
        z126 = s26 - 0.15 * (z29 * z92) + x * z90
        s27 = 0.5 * (z16 * z30) + (z126 + z * z89) + z6 * z96
        z127 = z61 * z38 - (0.03 * (c_z * z119) + s27)
        z128 = z56 * (z127 + 0.5 * (z20 * z124))
        s28 = c_z * z78 + (z125 + 0.3 * z6 + 0.5 * (z12 * z28))
        z129 = z44 * z91 - (s28 + 0.5 * (z15 * z83))
        s29 = 0.2 + (0.5 * (c_z * z94) + (0.25 * (z16 * z28) + z65))
        z130 = 0.5 * (z62 * z91) - (s29 + z15 * z97)
        z131 = z56 * (z130 - 0.5 * (z20 * z129))
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.4.9)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.4.9)
            1.0,
            # (I.4.9)
            z * z22,
            # (I.4.9)
            c_z * z23,
            # (I.4.9)
            x * z22 - y_2 * s_z * z23,
            # (I.4.9)
            z6,
            # (I.4.9)
            0.5 * z15,
            # (I.4.9)
            -(z19 * z86 + 0.5 * (z20 * z108)),
            # (I.4.9)
            z19 * z112 + 0.5 * (z20 * z114),
            # (I.4.9)
            0.5 * (z20 * z122) - z19 * z118,
            # (I.4.9)
            -(z19 * z124 + 0.5 * (z20 * z128)),
            # (I.4.9)
            z19 * z129 - 0.5 * (z20 * z131),
            # (I.4.9)
            z108,
            # (I.4.9)
            -z114,
            # (I.4.9)
            -z122,
            # (I.4.9)
            z128,
            # (I.4.9)
            z131,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 5] for k1 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (5,), p (0,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
