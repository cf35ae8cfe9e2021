"""affine_voronec, emitted by nhc 0.1.0 (nhc:e1e4e3b2b7a39fae).

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
rhs: 63 +-, 142 *, 2 /, 6 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 68 +-, 145 *, 2 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 73 +-, 157 *, 2 /, 6 calls
energy: 18 +-, 38 *, 0 /, 5 calls
jacobian: 207 +-, 405 *, 2 /, 6 calls
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
        z8 = x * x
        z9 = 1.0 + z8
        z10 = z9 * z2
        z11 = z1 * z2 + 0.3 * (z6 * z7) + z6 * (0.3 * z7 + z6 * z10)
        # the mass matrix is singular
        if not abs(z11) > 0.0:
            raise SingularModelError(2, "rhs")
        s_z = math.sin(z)
        z12 = 2.0 + s_z
        z13 = x * z
        z14 = z13 * z10
        z15 = z12 * z2 + 0.25 * (z13 * z14)
        z16 = 0.15 * (z13 * z7) + 0.5 * (z6 * z14)
        z17 = 1.0 / z11
        z18 = z16 * z17
        z19 = z15 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z15:
            raise SingularModelError(2, "rhs")
        z20 = y_dot * z13
        z21 = 2.0 * t_
        s1 = math.sin(z21)
        z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z20) + 0.2 * s1
        c_t = math.cos(t_)
        z23 = x + t_ * x_dot
        s2 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z23)
        z24 = s2 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z25 = s_z * z22
        s3 = x_dot * (2.0 * (z2 * (z * z22)) + 0.2 * (z1 * c_t))
        z26 = 0.3 * (z2 * z22 * z25 - 0.2 * (c_z * (c_t * z22))) - s3
        z27 = x * z22 + z * x_dot
        s4 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3))
        z28 = s4 + 0.5 * (y_dot * z27)
        c1 = math.cos(z21)
        z29 = 0.3 * z27 + z28 + 0.4 * c1
        s5 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z25))
        z30 = s5 + z22 * (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t))
        z31 = z30 + z10 * z29
        z32 = z4 - 0.05 * z22
        z33 = x_dot * x_dot
        z34 = z * z6
        z35 = y_dot * y_dot
        s6 = 2.0 * (z33 * z34) + z35 * (c_z * z6)
        s7 = 0.5 * (s6 + 2.0 * (x * (z22 * z22)))
        z36 = s7 - 0.3 * (z22 * (x_dot * (s_z * z6)))
        s8 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z36
        z37 = s8 - 0.5 * (2.0 * x + 6.0 * z34)
        s9 = z24 - (z26 - 0.3 * (z7 * z29) - z6 * z31)
        z38 = s9 + (0.1 * x_dot - z6 * z32 - z37)
        z39 = 0.3 * z22
        s10 = y_dot * (z2 * (c_z * z22) + 0.2 * (z12 * c_t))
        s11 = z39 - 0.05 * (z13 * z23) - (0.15 * z20 - 0.4 * (x_dot * c_t))
        z40 = s11 - (s10 + 0.5 * (z13 * z31))
        z41 = z * z13
        s12 = 0.5 * (z33 * z41 + 0.5 * (z35 * (c_z * z13)))
        z42 = s12 - 0.15 * (z22 * (x_dot * (s_z * z13)))
        s13 = 0.1 * (z8 * z13) + z2 * z42 - 0.5 * (4.0 * y_2 + 3.0 * z41)
        z43 = 0.2 * y_dot - z39 - 0.5 * (z13 * z32) - s13
        z44 = (z40 - z43 + z38 * z18) / z19
        dydt: list[float] = [
            # x' (I.4.9)
            x_dot,
            # y' (I.4.9)
            y_dot,
            # z' (I.4.9)
            z22,
            # x'' (I.4.9) 11:4
            -(z38 * z17 + z18 * z44),
            # y'' (I.4.9) 11:4
            z44,
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
        z1 = x * z
        c_z = math.cos(z)
        s_t = math.sin(t_)
        s1 = math.sin(2.0 * t_)
        s2 = x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)
        z2 = 0.3 * z1 + s2 + 0.2 * s1
        qdot: list[float] = [
            # x' (I.2.4)
            x_dot,
            # y' (I.2.4)
            y_dot,
            # z' (I.2.4)
            z2,
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
        z8 = x * x
        z9 = 1.0 + z8
        z10 = z9 * z2
        z11 = z1 * z2 + 0.3 * (z6 * z7) + z6 * (0.3 * z7 + z6 * z10)
        # the mass matrix is singular
        if not abs(z11) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_z = math.sin(z)
        z12 = 2.0 + s_z
        z13 = x * z
        z14 = z13 * z10
        z15 = z12 * z2 + 0.25 * (z13 * z14)
        z16 = 0.15 * (z13 * z7) + 0.5 * (z6 * z14)
        z17 = 1.0 / z11
        z18 = z16 * z17
        z19 = z15 - z16 * z18
        # the mass matrix is singular
        if not abs(z19) > 1e-14 * z15:
            raise SingularModelError(2, "accelerations")
        c_t = math.cos(t_)
        z20 = x + t_ * x_dot
        z21 = y_dot * z13
        z22 = 2.0 * t_
        s1 = math.sin(z22)
        z23 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1
        s2 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20)
        z24 = s2 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z23))
        z25 = s_z * z23
        s3 = x_dot * (2.0 * (z2 * (z * z23)) + 0.2 * (z1 * c_t))
        z26 = 0.3 * (z2 * z23 * z25 - 0.2 * (c_z * (c_t * z23))) - s3
        z27 = x * z23 + z * x_dot
        z28 = 0.3 * z27
        z29 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3))
        z30 = y_dot * z27
        c1 = math.cos(z22)
        z31 = 0.4 * c1
        z32 = z28 + (z29 + 0.5 * z30) + z31
        s4 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z25))
        z33 = s4 + z23 * (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t))
        z34 = z33 + z10 * z32
        z35 = z4 - 0.05 * z23
        z36 = x_dot * x_dot
        z37 = z * z6
        z38 = y_dot * y_dot
        s5 = 2.0 * (z36 * z37) + z38 * (c_z * z6)
        s6 = 0.5 * (s5 + 2.0 * (x * (z23 * z23)))
        z39 = s6 - 0.3 * (z23 * (x_dot * (s_z * z6)))
        s7 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z39
        z40 = s7 - 0.5 * (2.0 * x + 6.0 * z37)
        s8 = z24 - (z26 - 0.3 * (z7 * z32) - z6 * z34)
        z41 = s8 + (0.1 * x_dot - z6 * z35 - z40)
        z42 = 0.3 * z23
        s9 = y_dot * (z2 * (c_z * z23) + 0.2 * (z12 * c_t))
        s10 = z42 - 0.05 * (z13 * z20) - (0.15 * z21 - 0.4 * (x_dot * c_t))
        z43 = s10 - (s9 + 0.5 * (z13 * z34))
        z44 = z * z13
        s11 = 0.5 * (z36 * z44 + 0.5 * (z38 * (c_z * z13)))
        z45 = s11 - 0.15 * (z23 * (x_dot * (s_z * z13)))
        s12 = 0.1 * (z8 * z13) + z2 * z45 - 0.5 * (4.0 * y_2 + 3.0 * z44)
        z46 = 0.2 * y_dot - z42 - 0.5 * (z13 * z35) - s12
        z47 = (z43 - z46 + z41 * z18) / z19
        z48 = z41 * z17 + z18 * z47
        qddot: list[float] = [
            # x'' (I.4.9)
            -z48,
            # y'' (I.4.9)
            z47,
            # z'' (I.4.9)
            z31 + (z28 + (z29 - z6 * z48 + 0.5 * (z30 + z13 * z47))),
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
        z1 = x * z
        c_z = math.cos(z)
        s_t = math.sin(t_)
        s1 = math.sin(2.0 * t_)
        s2 = x_dot * (y * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)
        z2 = 0.3 * z1 + s2 + 0.2 * s1
        r: list[float] = [
            # contact = 0 (I.1.1) 18:5
            z_dot - z2,
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
        z8 = x * x
        z9 = 1.0 + z8
        z10 = z9 * z2
        z11 = 0.3 * z7 + z6 * z10
        z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "reactions")
        s_z = math.sin(z)
        z13 = 2.0 + s_z
        z14 = x * z
        z15 = z14 * z10
        z16 = z13 * z2 + 0.25 * (z14 * z15)
        z17 = 0.15 * (z14 * z7) + 0.5 * (z6 * z15)
        z18 = 1.0 / z12
        z19 = z17 * z18
        z20 = z16 - z17 * z19
        # the mass matrix is singular
        if not abs(z20) > 1e-14 * z16:
            raise SingularModelError(2, "reactions")
        c_t = math.cos(t_)
        z21 = y_dot * z14
        z22 = 2.0 * t_
        s1 = math.sin(z22)
        z23 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1
        z24 = s_z * z23
        s2 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z24))
        z25 = s2 + z23 * (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t))
        z26 = x * z23 + z * x_dot
        s3 = x_dot * (z5 * (y_dot * c_z - y_2 * z24) + 0.1 * (c_t * z3))
        z27 = s3 + 0.5 * (y_dot * z26)
        c1 = math.cos(z22)
        z28 = 0.3 * z26 + z27 + 0.4 * c1
        z29 = z25 + z10 * z28
        z30 = x + t_ * x_dot
        z31 = z4 - 0.05 * z23
        z32 = x_dot * x_dot
        z33 = y_dot * y_dot
        s4 = 0.5 * (2.0 * (z * z32) + z33 * c_z)
        z34 = 0.2 * z8 + z2 * (s4 - 0.3 * (z23 * (x_dot * s_z)))
        s5 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z30)
        z35 = s5 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z23))
        s6 = x_dot * (2.0 * (z2 * (z * z23)) + 0.2 * (z1 * c_t))
        z36 = 0.3 * (z2 * z23 * z24 - 0.2 * (c_z * (c_t * z23))) - s6
        z37 = z * z6
        s7 = 2.0 * (z32 * z37) + z33 * (c_z * z6)
        s8 = 0.5 * (s7 + 2.0 * (x * (z23 * z23)))
        z38 = s8 - 0.3 * (z23 * (x_dot * (s_z * z6)))
        s9 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z38
        z39 = s9 - 0.5 * (2.0 * x + 6.0 * z37)
        s10 = z35 - (z36 - 0.3 * (z7 * z28) - z6 * z29)
        z40 = s10 + (0.1 * x_dot - z6 * z31 - z39)
        z41 = 0.3 * z23
        s11 = y_dot * (z2 * (c_z * z23) + 0.2 * (z13 * c_t))
        s12 = z41 - 0.05 * (z14 * z30) - (0.15 * z21 - 0.4 * (x_dot * c_t))
        z42 = s12 - (s11 + 0.5 * (z14 * z29))
        z43 = z * z14
        s13 = 0.5 * (z32 * z43 + 0.5 * (z33 * (c_z * z14)))
        z44 = s13 - 0.15 * (z23 * (x_dot * (s_z * z14)))
        s14 = 0.1 * (z8 * z14) + z2 * z44 - 0.5 * (4.0 * y_2 + 3.0 * z43)
        z45 = 0.2 * y_dot - z41 - 0.5 * (z14 * z31) - s14
        z46 = (z42 - z45 + z40 * z19) / z20
        s15 = z29 + (0.3 * y_dot + 0.1 * z30) - (z31 - (3.0 * z - z34))
        z47 = s15 - (z11 * (z40 * z18 + z19 * z46) - 0.5 * (z15 * z46))
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z47,
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
        c_t = math.cos(t_)
        z3 = x * z
        c_z = math.cos(z)
        s_t = math.sin(t_)
        s1 = math.sin(2.0 * t_)
        s2 = x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z3)
        z4 = 0.3 * z3 + s2 + 0.2 * s1
        s_z = math.sin(z)
        s3 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z5 = s3 + (1.0 + z2) * (z4 * z4)
        s4 = 0.4 * (y_2 * x_dot * c_t) - 0.3 * (z * y_dot)
        s5 = (1.0 + 0.2 * s_t) * (0.5 * z5 + 0.3 * (x_dot * c_z * z4))
        z6 = s4 + 0.1 * (t_ * (x * z4)) + s5
        s6 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        value1 = s6 + (0.2 * (z * z2) + z6)
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
        z8 = x * x
        z9 = 1.0 + z8
        z10 = z9 * z2
        z11 = 0.3 * z7 + z6 * z10
        z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_z = math.sin(z)
        z13 = 2.0 + s_z
        z14 = x * z
        z15 = z14 * z10
        z16 = z13 * z2 + 0.25 * (z14 * z15)
        z17 = 0.15 * (z14 * z7) + 0.5 * (z6 * z15)
        z18 = 1.0 / z12
        z19 = z17 * z18
        z20 = z16 - z17 * z19
        # the mass matrix is singular
        if not abs(z20) > 1e-14 * z16:
            raise SingularModelError(2, "jacobian")
        z21 = 0.3 + 0.5 * y_dot
        z22 = x_dot * z5
        z23 = y_dot * z14
        z24 = 2.0 * t_
        s1 = math.sin(z24)
        z25 = 0.3 * z14 + (x_dot * z6 + 0.5 * z23) + 0.2 * s1
        z26 = z25 * z25
        z27 = z6 * z25
        z28 = z2 * z27
        z29 = 0.3 * z11 + 0.5 * (y_dot * z11)
        z30 = s_z * z6
        z31 = x_dot * z30
        c_t = math.cos(t_)
        z32 = 2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t)
        s2 = 0.05 * z6 + (0.3 * (z2 * z31) - 2.0 * (z25 * (x * z2)))
        z33 = 0.1 * t_ - s2 - z6 * z32
        z34 = x_dot * z2
        z35 = z2 * z25
        z36 = z2 * z6
        z37 = x_dot * z11
        z38 = z5 * z37
        z39 = 0.3 * z35 + 0.3 * (x_dot * z36) + y_2 * z38
        z40 = s_z * z25
        s3 = z33 - 0.06 * (c_z * c_t) - 2.0 * (z * z34) + s_z * z39
        z41 = s3 + 0.3 * (z2 * z40)
        z42 = z41 - x * z29
        z43 = 1.0 / z20
        z44 = 0.3 * z25
        z45 = x + t_ * x_dot
        z46 = x_dot * c_t
        z47 = z2 * (c_z * z25) + 0.2 * (z13 * c_t)
        z48 = x * z25 + z * x_dot
        z49 = z5 * (y_dot * c_z - y_2 * z40) + 0.1 * (c_t * z3)
        c1 = math.cos(z24)
        z50 = 0.3 * z48 + (x_dot * z49 + 0.5 * (y_dot * z48)) + 0.4 * c1
        s4 = 0.3 * (0.2 * (x_dot * c_z * c_t) - z2 * (x_dot * z40))
        z51 = s4 + z25 * z32 + z10 * z50
        s5 = z44 - 0.05 * (z14 * z45) - (0.15 * z23 - 0.4 * z46)
        z52 = s5 - (y_dot * z47 + 0.5 * (z14 * z51))
        z53 = z4 - 0.05 * z25
        z54 = x_dot * x_dot
        z55 = z * z14
        z56 = y_dot * y_dot
        z57 = c_z * z14
        z58 = s_z * z14
        z59 = x_dot * z58
        s6 = 0.5 * (z54 * z55 + 0.5 * (z56 * z57)) - 0.15 * (z25 * z59)
        z60 = 0.1 * (z8 * z14) + z2 * s6
        s7 = 0.2 * y_dot - z44 - 0.5 * (z14 * z53)
        z61 = s7 - (z60 - 0.5 * (4.0 * y_2 + 3.0 * z55))
        z62 = y_dot * c_t
        s8 = 0.4 * (z62 - y_2 * s_t) + 0.1 * (z6 * z45)
        z63 = s8 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z25))
        z64 = c_t * z25
        z65 = 2.0 * (z2 * (z * z25)) + 0.2 * (z1 * c_t)
        s9 = 0.3 * (z35 * z40 - 0.2 * (c_z * z64)) - x_dot * z65
        z66 = s9 - 0.3 * (z7 * z50) - z6 * z51
        z67 = z * z6
        z68 = c_z * z6
        s10 = 0.5 * (2.0 * (z54 * z67) + z56 * z68 + 2.0 * (x * z26))
        z69 = s10 - 0.3 * (z25 * z31)
        s11 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z69
        z70 = s11 - 0.5 * (2.0 * x + 6.0 * z67)
        z71 = z63 - z66 + (0.1 * x_dot - z6 * z53 - z70)
        z72 = z43 * (z52 - z61 + z71 * z19)
        z73 = z6 * z72
        s12 = 0.3 * z42 + (0.4 - 0.5 * (z10 * z73) - 0.15 * (z7 * z72))
        z74 = 0.5 * (y_dot * z42) + s12
        s13 = 1.0 + (0.1 * z6 - z2 * z26 + 2.0 * (x_dot * z28))
        z75 = s13 + z25 * z29 - z * z74
        z76 = z71 * z18 + z19 * z72
        z77 = z6 * z76
        s14 = z2 * (z6 * z50 + (0.5 * (z14 * z73) - z6 * z77))
        z78 = 0.2 * z6 - (0.2 * (c_t * z27) + s14)
        z79 = z75 - 2.0 * (x * z78)
        z80 = z14 * z25
        z81 = z2 * z80
        z82 = 0.15 * z15 + 0.25 * (y_dot * z15)
        z83 = y_dot * z2
        z84 = z2 * z14
        z85 = x_dot * z15
        z86 = z5 * z85
        z87 = 0.15 * (x_dot * z84) + 0.5 * (y_2 * z86)
        s15 = 0.6 - (0.025 * z14 + 0.15 * (z2 * z59)) - 0.5 * (z14 * z32)
        z88 = s15 - c_z * z83 + s_z * z87
        z89 = z88 - x * z82
        z90 = 0.15 - 0.5 * z89
        z91 = z7 * z76
        z92 = z15 * z72
        z93 = z56 * z2
        z94 = c_z * z93
        z95 = x_dot * z35
        z96 = s_z * z95
        z97 = z54 * z2
        z98 = 1.5 - 0.5 * z97
        s16 = 0.5 * z53 + (0.25 * z94 + (0.1 * z8 - 0.15 * z96) - z * z98)
        z99 = 0.05 * z45 - s16
        z100 = z14 * z72
        z101 = 0.5 * z77 - 0.25 * z100
        s17 = 0.15 * z91 - (0.25 * z92 + (0.5 * z51 + z99) - z10 * z101)
        z102 = y_dot * z90 - (0.3 * z89 + s17)
        s18 = 0.1 * (c_t * z80) + z2 * (0.5 * (z14 * z50) - z14 * z101)
        z103 = x * (0.1 * z14 - s18)
        s19 = 0.05 * z14 + x_dot * z81 + z25 * z82 + z * z102 - 2.0 * z103
        z104 = s19 - z19 * z79
        z105 = z43 * z104
        z106 = 3.0 - z97
        s20 = z53 + (0.2 * z8 - 0.3 * z96 + 0.5 * z94 - z * z106)
        z107 = 0.1 * z45 + (0.3 * y_dot - s20)
        s21 = z11 * z76 - (0.5 * z92 + (z51 + z107)) + z10 * z77
        z108 = x_dot * z42 + (0.3 * z91 + s21)
        z109 = 0.1 * (c_t * z37) - z5 * z108
        z110 = 0.4 * s_t + z40 * z38 - c_z * z109
        z111 = 0.05 * (c_t * z85) - z5 * (x_dot * z89 + 0.5 * (z15 * z76))
        z112 = z43 * (2.0 - 0.5 * (z40 * z86) + c_z * z111 + z19 * z110)
        z113 = c_t * z6
        z114 = 0.3 * z77
        s22 = z2 * (z114 - (0.3 * z50 - (z114 - 0.15 * z100)))
        z115 = 0.06 * z64 - 0.5 * (z6 * z93) + y_dot * z38 - s22
        s23 = z6 * z106 + 2.0 * (z25 * z34) + x_dot * z29 - x * z74
        z116 = s23 - s_z * (0.06 * (x_dot * z113) + (z115 + y_2 * z109))
        s24 = c_z * (0.3 * (z6 * z95) - z25 * z39) + z116
        z117 = s24 + 2.0 * (z * (0.2 * z46 - z2 * z76))
        z118 = c_t * z14
        s25 = 0.25 * (z14 * z93) - z25 * z83 - 0.5 * (y_dot * z86)
        z119 = s25 + 0.15 * (z2 * (z14 * z76))
        s26 = s_z * (0.03 * (x_dot * z118) - (z119 - y_2 * z111))
        z120 = z14 * z98 + x_dot * z82 + x * z102 - s26
        s27 = 0.15 * (z14 * z95) - z25 * z87 + (0.2 * z62 + z2 * z72)
        z121 = z120 + c_z * s27 - z19 * z117
        z122 = z43 * z121
        s28 = z65 + (0.3 * (z35 * z30) + 0.1 * (t_ * z6))
        z123 = s28 - 0.3 * (z40 * z36) + 2.0 * (x * z28)
        s29 = 0.1 + (z123 + z * z29 + z49 * z11 - z6 * z42)
        z124 = s29 + 0.06 * (c_z * z113) - 2.0 * (x_dot * (z2 * z67))
        z125 = 0.4 * c_t
        s30 = z125 - 0.15 * (z35 * z58) - 0.05 * (t_ * z14)
        z126 = s30 + 0.15 * (z40 * z84) - x * z81
        s31 = z126 - z * z82 - 0.5 * (z49 * z15) + z6 * z89
        z127 = s31 - 0.03 * (c_z * z118) + x_dot * (z2 * z55)
        z128 = z43 * (z127 + z19 * z124)
        s32 = z125 + 0.3 * z6 + 0.5 * (z48 * z11) + c_z * z38
        z129 = s32 - 0.5 * (z14 * z42) - y_dot * (z2 * z68)
        s33 = z47 + 0.25 * (z48 * z15) + 0.5 * (c_z * z86) + z14 * z90
        z130 = 0.2 + s33 - 0.5 * (y_dot * (z2 * z57))
        z131 = z43 * (z130 - z19 * z129)
        J: list[float] = [
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            1.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            0.0,
            # (I.4.9)
            1.0,
            # (I.4.9)
            z * z21,
            # (I.4.9)
            c_z * z22,
            # (I.4.9)
            x * z21 - s_z * (y_2 * z22),
            # (I.4.9)
            z6,
            # (I.4.9)
            0.5 * z14,
            # (I.4.9)
            z19 * z105 - z18 * z79,
            # (I.4.9)
            z18 * z110 + z19 * z112,
            # (I.4.9)
            z19 * z122 - z18 * z117,
            # (I.4.9)
            -(z18 * z124 + z19 * z128),
            # (I.4.9)
            z19 * z131 - z18 * z129,
            # (I.4.9)
            -z105,
            # (I.4.9)
            -z112,
            # (I.4.9)
            -z122,
            # (I.4.9)
            z128,
            # (I.4.9)
            -z131,
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
