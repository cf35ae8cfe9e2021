"""affine_voronec, emitted by nhc 0.1.0 (nhc:afe4b76a1dcf9e58).

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
rhs: 62 +-, 134 *, 2 /, 6 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 67 +-, 137 *, 2 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 72 +-, 146 *, 2 /, 6 calls
energy: 18 +-, 37 *, 0 /, 5 calls
jacobian: 203 +-, 398 *, 2 /, 6 calls
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
        z11 = 0.3 * z7 + z6 * z10
        z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "rhs")
        z13 = x * z
        z14 = z13 * z11
        z15 = 1.0 / z12
        z16 = z14 * z15
        s_z = math.sin(z)
        z17 = 2.0 + s_z
        z18 = z17 * z2 + 0.25 * (z10 * (z13 * z13))
        z19 = 0.25 * (z14 * z16) - z18
        # the mass matrix is singular
        if not abs(-z19) > 1e-14 * z18:
            raise SingularModelError(2, "rhs")
        z20 = y_dot * z13
        z21 = 2.0 * t_
        s1 = math.sin(z21)
        z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z20) + 0.2 * s1
        c_t = math.cos(t_)
        z23 = x + t_ * x_dot
        s2 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z23)
        z24 = s2 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z25 = x * z22 + z * x_dot
        z26 = s_z * z22
        s3 = x_dot * (z5 * (y_dot * c_z - y_2 * z26) + 0.1 * (c_t * z3))
        z27 = s3 + 0.5 * (y_dot * z25)
        c1 = math.cos(z21)
        z28 = 0.3 * z25 + z27 + 0.4 * c1
        z29 = z2 * z22
        z30 = c_z * c_t
        s4 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z29))
        z31 = 0.3 * (z29 * z26 - 0.2 * (z22 * z30)) - s4
        z32 = x_dot * z26
        s5 = z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z33 = 0.3 * (z2 * z32 - 0.2 * (x_dot * z30)) - s5
        z34 = z10 * z28 - z33
        z35 = z4 - 0.05 * z22
        z36 = z * z6
        z37 = x_dot * x_dot
        z38 = c_z * y_dot * y_dot
        s6 = 2.0 * (x * (z22 * z22)) + (2.0 * (z37 * z36) + z6 * z38)
        z39 = 0.5 * s6 - 0.3 * (z6 * z32)
        s7 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z39
        z40 = 0.5 * (2.0 * x + 6.0 * z36) - s7
        s8 = z24 + (0.3 * (z7 * z28) - z31 + z6 * z34)
        z41 = s8 + (0.1 * x_dot - z6 * z35 + z40)
        z42 = 0.3 * z22
        s9 = z42 - 0.05 * (z13 * z23) - (0.15 * z20 - 0.4 * (x_dot * c_t))
        z43 = s9 - 0.5 * (z13 * z34)
        z44 = z * z13
        s10 = 0.5 * (z37 * z44 + 0.5 * (z13 * z38)) - 0.15 * (z13 * z32)
        z45 = 0.1 * (z8 * z13) + z2 * s10
        s11 = 0.2 * y_dot - z42 - 0.5 * (z13 * z35)
        z46 = s11 + (0.5 * (4.0 * y_2 + 3.0 * z44) - z45)
        s12 = y_dot * (c_z * z29 + 0.2 * (z17 * c_t)) - z43 + z46
        z47 = (s12 - 0.5 * (z16 * z41)) / z19
        dydt: list[float] = [
            # x' (I.4.9)
            x_dot,
            # y' (I.4.9)
            y_dot,
            # z' (I.4.9)
            z22,
            # x'' (I.4.9) 11:4
            -(z15 * z41 + 0.5 * (z16 * z47)),
            # y'' (I.4.9) 11:4
            z47,
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
        z11 = 0.3 * z7 + z6 * z10
        z12 = z1 * z2 + 0.3 * (z6 * z7) + z6 * z11
        # the mass matrix is singular
        if not abs(z12) > 0.0:
            raise SingularModelError(2, "accelerations")
        z13 = x * z
        z14 = z13 * z11
        z15 = 1.0 / z12
        z16 = z14 * z15
        s_z = math.sin(z)
        z17 = 2.0 + s_z
        z18 = z17 * z2 + 0.25 * (z10 * (z13 * z13))
        z19 = 0.25 * (z14 * z16) - z18
        # the mass matrix is singular
        if not abs(-z19) > 1e-14 * z18:
            raise SingularModelError(2, "accelerations")
        c_t = math.cos(t_)
        z20 = x + t_ * x_dot
        z21 = y_dot * z13
        z22 = 2.0 * t_
        s1 = math.sin(z22)
        z23 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1
        s2 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20)
        z24 = s2 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z23))
        z25 = x * z23 + z * x_dot
        z26 = 0.3 * z25
        z27 = s_z * z23
        z28 = x_dot * (z5 * (y_dot * c_z - y_2 * z27) + 0.1 * (c_t * z3))
        z29 = y_dot * z25
        c1 = math.cos(z22)
        z30 = 0.4 * c1
        z31 = z26 + (z28 + 0.5 * z29) + z30
        z32 = z2 * z23
        z33 = c_z * c_t
        s3 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z32))
        z34 = 0.3 * (z32 * z27 - 0.2 * (z23 * z33)) - s3
        z35 = x_dot * z27
        s4 = z23 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z36 = 0.3 * (z2 * z35 - 0.2 * (x_dot * z33)) - s4
        z37 = z10 * z31 - z36
        z38 = z4 - 0.05 * z23
        z39 = z * z6
        z40 = x_dot * x_dot
        z41 = c_z * y_dot * y_dot
        s5 = 2.0 * (x * (z23 * z23)) + (2.0 * (z40 * z39) + z6 * z41)
        z42 = 0.5 * s5 - 0.3 * (z6 * z35)
        s6 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z42
        z43 = 0.5 * (2.0 * x + 6.0 * z39) - s6
        s7 = z24 + (0.3 * (z7 * z31) - z34 + z6 * z37)
        z44 = s7 + (0.1 * x_dot - z6 * z38 + z43)
        z45 = 0.3 * z23
        s8 = z45 - 0.05 * (z13 * z20) - (0.15 * z21 - 0.4 * (x_dot * c_t))
        z46 = s8 - 0.5 * (z13 * z37)
        z47 = z * z13
        s9 = 0.5 * (z40 * z47 + 0.5 * (z13 * z41)) - 0.15 * (z13 * z35)
        z48 = 0.1 * (z8 * z13) + z2 * s9
        s10 = 0.2 * y_dot - z45 - 0.5 * (z13 * z38)
        z49 = s10 + (0.5 * (4.0 * y_2 + 3.0 * z47) - z48)
        s11 = y_dot * (c_z * z32 + 0.2 * (z17 * c_t)) - z46 + z49
        z50 = (s11 - 0.5 * (z16 * z44)) / z19
        z51 = z15 * z44 + 0.5 * (z16 * z50)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z51,
            # y'' (I.4.9)
            z50,
            # z'' (I.4.9)
            z30 + (z26 + (z28 - z6 * z51 + 0.5 * (z29 + z13 * z50))),
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
        z17 = z14 * z11
        z18 = 1.0 / z12
        z19 = z17 * z18
        z20 = z16 - 0.25 * (z17 * z19)
        # the mass matrix is singular
        if not abs(z20) > 1e-14 * z16:
            raise SingularModelError(2, "reactions")
        z21 = y_dot * z14
        z22 = 2.0 * t_
        s1 = math.sin(z22)
        z23 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.2 * s1
        z24 = x * z23 + z * x_dot
        z25 = s_z * z23
        c_t = math.cos(t_)
        s2 = x_dot * (z5 * (y_dot * c_z - y_2 * z25) + 0.1 * (c_t * z3))
        z26 = s2 + 0.5 * (y_dot * z24)
        c1 = math.cos(z22)
        z27 = 0.3 * z24 + z26 + 0.4 * c1
        z28 = x_dot * z25
        z29 = c_z * c_t
        s3 = z23 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z30 = 0.3 * (z2 * z28 - 0.2 * (x_dot * z29)) - s3
        z31 = z10 * z27 - z30
        z32 = x + t_ * x_dot
        z33 = z4 - 0.05 * z23
        z34 = x_dot * x_dot
        z35 = c_z * y_dot * y_dot
        s4 = 0.2 * z8 + z2 * (0.5 * (2.0 * (z * z34) + z35) - 0.3 * z28)
        z36 = 3.0 * z - s4
        s5 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z32)
        z37 = s5 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z23))
        z38 = z2 * z23
        s6 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z38))
        z39 = 0.3 * (z38 * z25 - 0.2 * (z23 * z29)) - s6
        z40 = z * z6
        s7 = 2.0 * (x * (z23 * z23)) + (2.0 * (z34 * z40) + z6 * z35)
        z41 = 0.5 * s7 - 0.3 * (z6 * z28)
        s8 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z41
        z42 = 0.5 * (2.0 * x + 6.0 * z40) - s8
        s9 = z37 + (0.3 * (z7 * z27) - z39 + z6 * z31)
        z43 = s9 + (0.1 * x_dot - z6 * z33 + z42)
        z44 = 0.3 * z23
        s10 = z44 - 0.05 * (z14 * z32) - (0.15 * z21 - 0.4 * (x_dot * c_t))
        z45 = s10 - 0.5 * (z14 * z31)
        z46 = z * z14
        s11 = 0.5 * (z34 * z46 + 0.5 * (z14 * z35)) - 0.15 * (z14 * z28)
        z47 = 0.1 * (z8 * z14) + z2 * s11
        s12 = 0.2 * y_dot - z44 - 0.5 * (z14 * z33)
        z48 = s12 + (0.5 * (4.0 * y_2 + 3.0 * z46) - z47)
        s13 = y_dot * (c_z * z38 + 0.2 * (z13 * c_t)) - z45 + z48
        z49 = (s13 - 0.5 * (z19 * z43)) / z20
        s14 = z11 * (z18 * z43 - 0.5 * (z19 * z49)) + 0.5 * (z15 * z49)
        z50 = z31 + (0.3 * y_dot + 0.1 * z32) - (z33 - z36) - s14
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z50,
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
        z3 = y_2 * x_dot
        c_t = math.cos(t_)
        s1 = math.sin(2.0 * t_)
        z4 = x * z
        s_t = math.sin(t_)
        c_z = math.cos(z)
        s2 = 0.5 * (y_dot * z4) + (1.0 + 0.1 * s_t) * (c_z * z3)
        z5 = 0.2 * s1 + (0.3 * z4 + s2)
        s_z = math.sin(z)
        s3 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z6 = s3 + (1.0 + z2) * (z5 * z5)
        s4 = 0.4 * (z3 * c_t) - 0.3 * (z * y_dot) + 0.1 * (t_ * x * z5)
        s5 = (1.0 + 0.2 * s_t) * (0.5 * z6 + 0.3 * (x_dot * c_z * z5))
        z7 = s4 + s5
        s6 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        value1 = s6 + (0.2 * (z * z2) + z7)
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
        z17 = z14 * z11
        z18 = 1.0 / z12
        z19 = z17 * z18
        z20 = z16 - 0.25 * (z17 * z19)
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
        z30 = s_z * z25
        z31 = z2 * z25
        z32 = z2 * z6
        z33 = x_dot * z11
        z34 = z5 * z33
        z35 = 0.3 * (z31 + x_dot * z32) + y_2 * z34
        z36 = x_dot * z2
        c_t = math.cos(t_)
        z37 = s_z * z6
        z38 = x_dot * z37
        z39 = 0.2 * (z9 * c_t) + 2.0 * (x * z36)
        s2 = 0.1 * t_ - (0.05 * z6 + (0.3 * (z2 * z38) - 2.0 * (x * z31)))
        z40 = s2 - z6 * z39
        s3 = s_z * z35 - (2.0 * (z * z36) + (0.06 * (c_z * c_t) - z40))
        z41 = 0.3 * (z2 * z30) + s3
        z42 = x * z29 - z41
        z43 = 1.0 / z20
        z44 = 0.3 * z25
        z45 = z4 - 0.05 * z25
        z46 = x_dot * x_dot
        z47 = z * z14
        z48 = y_dot * y_dot
        z49 = c_z * z14
        z50 = s_z * z14
        z51 = x_dot * z50
        s4 = 0.5 * (z46 * z47 + 0.5 * (z48 * z49)) - 0.15 * (z25 * z51)
        z52 = 0.1 * (z8 * z14) + z2 * s4
        s5 = 0.2 * y_dot - z44 - 0.5 * (z14 * z45)
        z53 = s5 - (z52 - 0.5 * (4.0 * y_2 + 3.0 * z47))
        z54 = c_z * z31 + 0.2 * (z13 * c_t)
        z55 = x + t_ * x_dot
        z56 = x_dot * c_t
        z57 = x * z25 + z * x_dot
        z58 = z5 * (y_dot * c_z - y_2 * z30) + 0.1 * (c_t * z3)
        c1 = math.cos(z24)
        z59 = 0.3 * z57 + (x_dot * z58 + 0.5 * (y_dot * z57)) + 0.4 * c1
        s6 = z25 * z39 + 0.3 * (0.2 * (c_z * z56) - z30 * z36)
        z60 = z10 * z59 + s6
        s7 = z44 - 0.05 * (z14 * z55) - (0.15 * z23 - 0.4 * z56)
        z61 = y_dot * z54 - (s7 - 0.5 * (z14 * z60))
        z62 = z * z6
        z63 = c_z * z6
        s8 = 0.5 * (2.0 * (z46 * z62) + z48 * z63 + 2.0 * (x * z26))
        z64 = s8 - 0.3 * (z25 * z38)
        s9 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z64
        z65 = s9 - 0.5 * (2.0 * x + 6.0 * z62)
        z66 = y_dot * c_t
        s10 = 0.4 * (z66 - y_2 * s_t) + 0.1 * (z6 * z55)
        z67 = s10 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z25))
        z68 = c_t * z25
        z69 = 0.2 * (z1 * c_t) + 2.0 * (z * z31)
        s11 = 0.3 * (z31 * z30 - 0.2 * (c_z * z68)) - x_dot * z69
        z70 = 0.3 * (z7 * z59) - s11 + z6 * z60
        z71 = 0.1 * x_dot - z6 * z45 - z65 + (z67 + z70)
        z72 = z43 * (z53 + z61 - 0.5 * (z19 * z71))
        z73 = 0.5 * (y_dot * z42) + (0.3 * z42 - (0.4 + 0.5 * (z11 * z72)))
        s12 = 1.0 + (0.1 * z6 - z2 * z26 + 2.0 * (x_dot * z28))
        z74 = s12 + z25 * z29 + z * z73
        z75 = z18 * z71 - 0.5 * (z19 * z72)
        z76 = z6 * z75
        z77 = z14 * z72
        z78 = z76 + 0.5 * z77
        s13 = x * (0.2 * z6 - (0.2 * (c_t * z27) + z32 * (z59 - z78)))
        z79 = z74 - 2.0 * s13
        z80 = z14 * z25
        z81 = z2 * z80
        z82 = 0.15 * z15 + 0.25 * (y_dot * z15)
        z83 = z2 * z14
        z84 = x_dot * z15
        z85 = z5 * z84
        z86 = 0.15 * (x_dot * z83) + 0.5 * (y_2 * z85)
        z87 = y_dot * z2
        s14 = 0.6 - (0.025 * z14 + 0.15 * (z2 * z51)) - 0.5 * (z14 * z39)
        z88 = s_z * z86 - (c_z * z87 - s14)
        z89 = x * z82 - z88
        z90 = 0.15 + 0.5 * z89
        z91 = z11 * z75
        z92 = z48 * z2
        z93 = c_z * z92
        z94 = x_dot * z31
        z95 = s_z * z94
        z96 = z46 * z2
        z97 = 1.5 - 0.5 * z96
        s15 = 0.5 * z45 + (0.25 * z93 + (0.1 * z8 - 0.15 * z95) - z * z97)
        z98 = s15 - 0.5 * z60
        s16 = 0.05 * z55 - z98 - 0.25 * (z15 * z72) - 0.25 * (z10 * z77)
        z99 = 0.3 * z89 - (0.5 * z91 - s16)
        z100 = y_dot * z90 + z99
        z101 = z14 * z75
        s17 = 0.5 * (z14 * z59) - (0.25 * (z14 * z77) + 0.5 * (z6 * z101))
        z102 = 0.1 * (c_t * z80) + z2 * s17
        s18 = 0.05 * z14 + x_dot * z81 + z25 * z82 + z * z100
        z103 = s18 - 2.0 * (x * (0.1 * z14 - z102))
        z104 = z43 * (z103 - 0.5 * (z19 * z79))
        z105 = 3.0 - z96
        s19 = z45 + (0.2 * z8 - 0.3 * z95 + 0.5 * z93 - z * z105) - z60
        z106 = 0.3 * y_dot - s19
        s20 = z91 - (0.1 * z55 + z106) + z10 * z78 + 0.3 * (z7 * z75)
        z107 = z5 * (x_dot * z42 - s20)
        z108 = 0.1 * (c_t * z33) + z107
        z109 = 0.4 * s_t + z30 * z34 - c_z * z108
        z110 = 0.05 * (c_t * z84) + z5 * (x_dot * z89 - 0.5 * (z10 * z101))
        s21 = 2.0 - 0.5 * (z30 * z85) + c_z * z110 + 0.5 * (z19 * z109)
        z111 = z43 * s21
        z112 = c_t * z6
        s22 = 0.06 * z68 - 0.5 * (z6 * z92) + y_dot * z34
        z113 = s22 - 0.3 * (z2 * (z78 - (z59 - z76)))
        s23 = z6 * z105 + 2.0 * (z25 * z36) + x_dot * z29 + x * z73
        z114 = s23 - s_z * (0.06 * (x_dot * z112) + (z113 + y_2 * z108))
        s24 = c_z * (0.3 * (z6 * z94) - z25 * z35) + z114
        z115 = s24 + 2.0 * (z * (0.2 * z56 - z2 * z75))
        z116 = c_t * z14
        s25 = 0.25 * (z14 * z92) - z25 * z87 - 0.5 * (y_dot * z85)
        z117 = s25 + 0.15 * (z2 * z101) - y_2 * z110
        s26 = s_z * (0.03 * (x_dot * z116) - z117)
        s27 = 0.15 * (z14 * z94) - z25 * z86 + (0.2 * z66 - z2 * z72)
        z118 = z14 * z97 + x_dot * z82 + x * z100 - s26 + c_z * s27
        z119 = z43 * (z118 - 0.5 * (z19 * z115))
        s28 = z69 + (0.3 * (z31 * z37) + 0.1 * (t_ * z6))
        z120 = 2.0 * (x * z28) - (0.3 * (z30 * z32) - s28)
        s29 = 0.1 + (z58 * z11 + (z * z29 + z120)) + z6 * z42
        z121 = 0.06 * (c_z * z112) + s29 - 2.0 * (z62 * z36)
        z122 = 0.4 * c_t
        s30 = z122 - 0.15 * (z31 * z50) - 0.05 * (t_ * z14)
        z123 = s30 + 0.15 * (z30 * z83) - x * z81
        s31 = z123 - z * z82 - 0.5 * (z58 * z15) - z6 * z89
        z124 = 0.03 * (c_z * z116) - s31 - z47 * z36
        z125 = z43 * (z124 - 0.5 * (z19 * z121))
        s32 = z122 + 0.3 * z6 + 0.5 * (z57 * z11) + c_z * z34
        z126 = s32 + 0.5 * (z14 * z42) - z63 * z87
        s33 = 0.2 + (0.5 * (c_z * z85) + (z54 + 0.25 * (z57 * z15)))
        z127 = 0.5 * (y_dot * (z2 * z49)) - (s33 + z14 * z90)
        z128 = z43 * (z127 + 0.5 * (z19 * z126))
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
            z * z21,
            # (I.4.9)
            c_z * z22,
            # (I.4.9)
            x * z21 - y_2 * s_z * z22,
            # (I.4.9)
            z6,
            # (I.4.9)
            0.5 * z14,
            # (I.4.9)
            0.5 * (z19 * z104) - z18 * z79,
            # (I.4.9)
            z18 * z109 + 0.5 * (z19 * z111),
            # (I.4.9)
            0.5 * (z19 * z119) - z18 * z115,
            # (I.4.9)
            0.5 * (z19 * z125) - z18 * z121,
            # (I.4.9)
            -(z18 * z126 + 0.5 * (z19 * z128)),
            # (I.4.9)
            -z104,
            # (I.4.9)
            -z111,
            # (I.4.9)
            -z119,
            # (I.4.9)
            -z125,
            # (I.4.9)
            z128,
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
