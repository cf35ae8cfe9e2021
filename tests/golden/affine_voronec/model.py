"""affine_voronec, emitted by nhc 0.1.0 (nhc:e2a552e4213d61d7).

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
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 68 +-, 139 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 73 +-, 148 *, 2 /, 4 calls
energy: 18 +-, 37 *, 0 /, 4 calls
jacobian: 204 +-, 400 *, 2 /, 4 calls
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
        z1 = x * z
        c_z = math.cos(z)
        s_t = math.sin(t_)
        c_t = math.cos(t_)
        s1 = x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)
        z2 = 0.3 * z1 + s1 + 0.4 * (c_t * s_t)
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
        z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        s1 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20)
        z23 = s1 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z24 = 0.4 * (c_t * c_t - s_t * s_t)
        z25 = z * x_dot + x * z22
        z26 = 0.3 * z25
        z27 = s_z * z22
        z28 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z27))
        z29 = y_dot * z25
        z30 = z24 + (z26 + (z28 + 0.5 * z29))
        z31 = z2 * z22
        z32 = c_z * c_t
        s2 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z31))
        z33 = 0.3 * (z31 * z27 - 0.2 * (z22 * z32)) - s2
        z34 = x_dot * z27
        s3 = z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z35 = 0.3 * (z2 * z34 - 0.2 * (x_dot * z32)) - s3
        z36 = z10 * z30 - z35
        z37 = z4 - 0.05 * z22
        z38 = z * z6
        z39 = x_dot * x_dot
        z40 = c_z * y_dot * y_dot
        s4 = 2.0 * (x * (z22 * z22)) + (2.0 * (z39 * z38) + z6 * z40)
        z41 = 0.5 * s4 - 0.3 * (z6 * z34)
        s5 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z41
        z42 = 0.5 * (2.0 * x + 6.0 * z38) - s5
        s6 = z23 + (0.3 * (z7 * z30) - z33 + z6 * z36)
        z43 = s6 + (0.1 * x_dot - z6 * z37 + z42)
        z44 = 0.3 * z22
        s7 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z13 * z20) - z44)
        z45 = s7 + 0.5 * (z13 * z36)
        z46 = z * z13
        s8 = 0.5 * (z39 * z46 + 0.5 * (z13 * z40)) - 0.15 * (z13 * z34)
        z47 = 0.1 * (z8 * z13) + z2 * s8
        s9 = 0.2 * y_dot - z44 - 0.5 * (z13 * z37)
        z48 = s9 + (0.5 * (4.0 * y_2 + 3.0 * z46) - z47)
        s10 = y_dot * (0.2 * (z17 * c_t) + c_z * z31) + z45 + z48
        z49 = (s10 - 0.5 * (z16 * z43)) / z19
        z50 = z15 * z43 + 0.5 * (z16 * z49)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z50,
            # y'' (I.4.9)
            z49,
            # z'' (I.4.9)
            z24 + (z26 + (z28 - z6 * z50 + 0.5 * (z29 + z13 * z49))),
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
        c_t = math.cos(t_)
        s1 = x_dot * (y * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)
        z2 = 0.3 * z1 + s1 + 0.4 * (c_t * s_t)
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
        c_t = math.cos(t_)
        z21 = y_dot * z14
        z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        z23 = z * x_dot + x * z22
        z24 = s_z * z22
        s1 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24))
        z25 = s1 + 0.5 * (y_dot * z23)
        z26 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z23 + z25)
        z27 = x_dot * z24
        z28 = c_z * c_t
        s2 = z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z29 = 0.3 * (z2 * z27 - 0.2 * (x_dot * z28)) - s2
        z30 = z10 * z26 - z29
        z31 = x + t_ * x_dot
        z32 = z4 - 0.05 * z22
        z33 = x_dot * x_dot
        z34 = c_z * y_dot * y_dot
        s3 = 0.2 * z8 + z2 * (0.5 * (2.0 * (z * z33) + z34) - 0.3 * z27)
        z35 = 3.0 * z - s3
        s4 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z31)
        z36 = s4 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z37 = z2 * z22
        s5 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z37))
        z38 = 0.3 * (z37 * z24 - 0.2 * (z22 * z28)) - s5
        z39 = z * z6
        s6 = 2.0 * (x * (z22 * z22)) + (2.0 * (z33 * z39) + z6 * z34)
        z40 = 0.5 * s6 - 0.3 * (z6 * z27)
        s7 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z40
        z41 = 0.5 * (2.0 * x + 6.0 * z39) - s7
        s8 = z36 + (0.3 * (z7 * z26) - z38 + z6 * z30)
        z42 = s8 + (0.1 * x_dot - z6 * z32 + z41)
        z43 = 0.3 * z22
        s9 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z14 * z31) - z43)
        z44 = s9 + 0.5 * (z14 * z30)
        z45 = z * z14
        s10 = 0.5 * (z33 * z45 + 0.5 * (z14 * z34)) - 0.15 * (z14 * z27)
        z46 = 0.1 * (z8 * z14) + z2 * s10
        s11 = 0.2 * y_dot - z43 - 0.5 * (z14 * z32)
        z47 = s11 + (0.5 * (4.0 * y_2 + 3.0 * z45) - z46)
        s12 = y_dot * (0.2 * (z13 * c_t) + c_z * z37) + z44 + z47
        z48 = (s12 - 0.5 * (z19 * z42)) / z20
        s13 = z11 * (z18 * z42 - 0.5 * (z19 * z48)) + 0.5 * (z15 * z48)
        z49 = z30 + (0.3 * y_dot + 0.1 * z31) - (z32 - z35) - s13
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z49,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

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
        s_t = math.sin(t_)
        z4 = x * z
        c_z = math.cos(z)
        s1 = 0.5 * (y_dot * z4) + (1.0 + 0.1 * s_t) * (c_z * z3)
        z5 = 0.4 * (c_t * s_t) + (0.3 * z4 + s1)
        s_z = math.sin(z)
        s2 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z6 = s2 + (1.0 + z2) * (z5 * z5)
        s3 = 0.4 * (z3 * c_t) - 0.3 * (z * y_dot) + 0.1 * (t_ * x * z5)
        s4 = (1.0 + 0.2 * s_t) * (0.5 * z6 + 0.3 * (x_dot * c_z * z5))
        z7 = s3 + s4
        s5 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        value1 = s5 + (0.2 * (z * z2) + z7)
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
        c_t = math.cos(t_)
        z24 = 0.3 * z14 + (x_dot * z6 + 0.5 * z23) + 0.4 * (c_t * s_t)
        z25 = z24 * z24
        z26 = z6 * z24
        z27 = z2 * z26
        z28 = 0.3 * z11 + 0.5 * (y_dot * z11)
        z29 = s_z * z24
        z30 = x_dot * z11
        z31 = z5 * z30
        z32 = z2 * z24
        z33 = z2 * z6
        z34 = y_2 * z31 + 0.3 * (z32 + x_dot * z33)
        z35 = x_dot * z2
        z36 = 0.2 * (z9 * c_t) + 2.0 * (x * z35)
        z37 = s_z * z6
        z38 = x_dot * z37
        s1 = 0.1 * t_ - (0.05 * z6 + (0.3 * (z2 * z38) - 2.0 * (x * z32)))
        z39 = z6 * z36 - s1
        s2 = s_z * z34 - (2.0 * (z * z35) + (0.06 * (c_z * c_t) + z39))
        z40 = 0.3 * (z2 * z29) + s2
        z41 = x * z28 - z40
        z42 = 1.0 / z20
        z43 = 0.3 * z24
        z44 = z4 - 0.05 * z24
        z45 = z * z14
        z46 = x_dot * x_dot
        z47 = y_dot * y_dot
        z48 = c_z * z14
        z49 = s_z * z14
        z50 = x_dot * z49
        s3 = 0.5 * (z46 * z45 + 0.5 * (z47 * z48)) - 0.15 * (z50 * z24)
        z51 = 0.1 * (z8 * z14) + z2 * s3
        s4 = 0.2 * y_dot - z43 - 0.5 * (z14 * z44)
        z52 = s4 + (0.5 * (4.0 * y_2 + 3.0 * z45) - z51)
        z53 = 0.2 * (z13 * c_t) + c_z * z32
        z54 = x_dot * c_t
        z55 = x + t_ * x_dot
        z56 = z * x_dot + x * z24
        z57 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z29)
        s5 = 0.3 * z56 + (x_dot * z57 + 0.5 * (y_dot * z56))
        z58 = 0.4 * (c_t * c_t - s_t * s_t) + s5
        s6 = z24 * z36 + 0.3 * (0.2 * (c_z * z54) - z29 * z35)
        z59 = z10 * z58 + s6
        s7 = 0.15 * z23 - 0.4 * z54 + (0.05 * (z14 * z55) - z43)
        z60 = y_dot * z53 + (s7 + 0.5 * (z14 * z59))
        z61 = z * z6
        z62 = c_z * z6
        s8 = 0.5 * (2.0 * (z46 * z61) + z47 * z62 + 2.0 * (x * z25))
        z63 = s8 - 0.3 * (z38 * z24)
        s9 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z63
        z64 = 0.5 * (2.0 * x + 6.0 * z61) - s9
        z65 = y_dot * c_t
        s10 = 0.4 * (z65 - y_2 * s_t) + 0.1 * (z6 * z55)
        z66 = s10 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z24))
        z67 = c_t * z24
        z68 = 0.2 * (z1 * c_t) + 2.0 * (z * z32)
        s11 = 0.3 * (z32 * z29 - 0.2 * (c_z * z67)) - x_dot * z68
        z69 = 0.3 * (z7 * z58) - s11 + z6 * z59
        z70 = 0.1 * x_dot - z6 * z44 + z64 + (z66 + z69)
        z71 = z42 * (z52 + z60 - 0.5 * (z19 * z70))
        z72 = 0.5 * (y_dot * z41) + (0.3 * z41 - (0.4 + 0.5 * (z11 * z71)))
        s12 = 1.0 + (0.1 * z6 - z2 * z25 + 2.0 * (x_dot * z27))
        z73 = s12 + z24 * z28 + z * z72
        z74 = z18 * z70 - 0.5 * (z19 * z71)
        z75 = z6 * z74
        z76 = z14 * z71
        z77 = z75 + 0.5 * z76
        s13 = x * (0.2 * z6 - (0.2 * (c_t * z26) + z33 * (z58 - z77)))
        z78 = z73 - 2.0 * s13
        z79 = z14 * z24
        z80 = z2 * z79
        z81 = 0.15 * z15 + 0.25 * (y_dot * z15)
        z82 = z2 * z14
        z83 = x_dot * z15
        z84 = z5 * z83
        z85 = 0.15 * (x_dot * z82) + 0.5 * (y_2 * z84)
        z86 = y_dot * z2
        s14 = 0.6 - (0.025 * z14 + 0.15 * (z2 * z50)) - 0.5 * (z14 * z36)
        z87 = s_z * z85 - (c_z * z86 - s14)
        z88 = x * z81 - z87
        z89 = 0.15 + 0.5 * z88
        z90 = z11 * z74
        z91 = z46 * z2
        z92 = 1.5 - 0.5 * z91
        z93 = z47 * z2
        z94 = c_z * z93
        z95 = x_dot * z32
        z96 = s_z * z95
        s15 = 0.5 * z44 - (z * z92 - (0.25 * z94 + (0.1 * z8 - 0.15 * z96)))
        z97 = s15 - 0.5 * z59
        s16 = 0.05 * z55 - z97 - 0.25 * (z15 * z71) - 0.25 * (z10 * z76)
        z98 = 0.3 * z88 - (0.5 * z90 - s16)
        z99 = y_dot * z89 + z98
        z100 = z14 * z74
        s17 = 0.5 * (z14 * z58) - (0.25 * (z14 * z76) + 0.5 * (z6 * z100))
        z101 = 0.1 * (c_t * z79) + z2 * s17
        s18 = 0.05 * z14 + x_dot * z80 + z24 * z81 + z * z99
        z102 = s18 - 2.0 * (x * (0.1 * z14 - z101))
        z103 = z42 * (z102 - 0.5 * (z19 * z78))
        z104 = 3.0 - z91
        s19 = z44 - (z * z104 - (0.5 * z94 + (0.2 * z8 - 0.3 * z96)))
        z105 = 0.3 * y_dot - (s19 - z59)
        s20 = z90 - (0.1 * z55 + z105) + z10 * z77 + 0.3 * (z7 * z74)
        z106 = z5 * (x_dot * z41 - s20)
        z107 = 0.1 * (c_t * z30) + z106
        z108 = 0.4 * s_t + z29 * z31 - c_z * z107
        z109 = 0.05 * (c_t * z83) + z5 * (x_dot * z88 - 0.5 * (z10 * z100))
        s21 = 2.0 - 0.5 * (z29 * z84) + c_z * z109 + 0.5 * (z19 * z108)
        z110 = z42 * s21
        z111 = c_t * z6
        s22 = y_dot * z31 + (0.06 * z67 - 0.5 * (z6 * z93))
        z112 = s22 - 0.3 * (z2 * (z77 - (z58 - z75)))
        s23 = x_dot * z28 + (z6 * z104 + 2.0 * (z24 * z35)) + x * z72
        z113 = s23 - s_z * (0.06 * (x_dot * z111) + (z112 + y_2 * z107))
        s24 = c_z * (0.3 * (z6 * z95) - z24 * z34) + z113
        z114 = s24 + 2.0 * (z * (0.2 * z54 - z2 * z74))
        z115 = c_t * z14
        s25 = 0.5 * (y_dot * z84) - (0.25 * (z14 * z93) - z24 * z86)
        z116 = s25 - 0.15 * (z2 * z100) + y_2 * z109
        s26 = s_z * (0.03 * (x_dot * z115) + z116)
        s27 = 0.15 * (z14 * z95) - z24 * z85 + (0.2 * z65 - z2 * z71)
        z117 = z14 * z92 + x_dot * z81 + x * z99 - s26 + c_z * s27
        z118 = z42 * (z117 - 0.5 * (z19 * z114))
        s28 = z68 + (0.1 * (t_ * z6) + 0.3 * (z37 * z32))
        z119 = 2.0 * (x * z27) - (0.3 * (z29 * z33) - s28)
        s29 = 0.1 + (z11 * z57 + (z * z28 + z119)) + z6 * z41
        z120 = 2.0 * (z61 * z35) - (0.06 * (c_z * z111) + s29)
        z121 = 0.4 * c_t
        s30 = 0.05 * (t_ * z14) - (z121 - 0.15 * (z49 * z32))
        z122 = s30 - 0.15 * (z29 * z82) + x * z80
        s31 = z * z81 + z122 + 0.5 * (z15 * z57) + z6 * z88
        z123 = z45 * z35 - (0.03 * (c_z * z115) + s31)
        z124 = z42 * (z123 - 0.5 * (z19 * z120))
        s32 = c_z * z31 + (z121 + 0.3 * z6 + 0.5 * (z11 * z56))
        z125 = z62 * z86 - (s32 + 0.5 * (z14 * z41))
        s33 = 0.2 + (0.5 * (c_z * z84) + (z53 + 0.25 * (z15 * z56)))
        z126 = 0.5 * (y_dot * (z2 * z48)) - (z14 * z89 + s33)
        z127 = z42 * (z126 - 0.5 * (z19 * z125))
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
            0.5 * (z19 * z103) - z18 * z78,
            # (I.4.9)
            z18 * z108 + 0.5 * (z19 * z110),
            # (I.4.9)
            0.5 * (z19 * z118) - z18 * z114,
            # (I.4.9)
            z18 * z120 - 0.5 * (z19 * z124),
            # (I.4.9)
            z18 * z125 - 0.5 * (z19 * z127),
            # (I.4.9)
            -z103,
            # (I.4.9)
            -z110,
            # (I.4.9)
            -z118,
            # (I.4.9)
            z124,
            # (I.4.9)
            z127,
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
