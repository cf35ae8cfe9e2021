"""affine_voronec, emitted by nhc 0.1.0 (nhc:3ab117b0e617724e).

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

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 62 +-, 105 *, 2 /, 4 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 66 +-, 139 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 73 +-, 148 *, 2 /, 4 calls
energy: 18 +-, 37 *, 0 /, 4 calls
jacobian: 203 +-, 387 *, 2 /, 4 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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
        # from the state
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
            raise _refuse(abs(z13), 0.0, 2, "rhs")
        z14 = x * z
        z15 = z14 * z12
        z16 = 1.0 / z13
        z17 = z15 * z16
        s_z = math.sin(z)
        z18 = 2.0 + s_z
        z19 = z18 * z2 + 0.25 * (z11 * (z14 * z14))
        z20 = 0.25 * (z15 * z17) - z19
        # the mass matrix is singular
        if not abs(-z20) > 1e-13 * z19:
            raise _refuse(abs(-z20), 1e-13 * z19, 2, "rhs")
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
        s2 = 0.4 - 0.8 * (s_t * s_t) + (0.3 + 0.5 * y_dot) * (z26 + z27)
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
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
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
    """all velocities q' from the state (I.1.2)

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
        # from the state
        z1 = x * z
        c_z = math.cos(z)
        s_t = math.sin(t_)
        c_t = math.cos(t_)
        s1 = x_dot * (y_2 * c_z * (1.0 + 0.1 * s_t)) + 0.5 * (y_dot * z1)
        z2 = 0.3 * z1 + s1 + 0.4 * (c_t * s_t)
        qdot: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
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
        # from the state
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
            raise _refuse(abs(z12), 0.0, 2, "accelerations")
        z13 = x * z
        z14 = z13 * z11
        z15 = 1.0 / z12
        z16 = z14 * z15
        s_z = math.sin(z)
        z17 = 2.0 + s_z
        z18 = z17 * z2 + 0.25 * (z10 * (z13 * z13))
        z19 = 0.25 * (z14 * z16) - z18
        # the mass matrix is singular
        if not abs(-z19) > 1e-13 * z18:
            raise _refuse(abs(-z19), 1e-13 * z18, 2, "accelerations")
        c_t = math.cos(t_)
        z20 = x + t_ * x_dot
        z21 = y_dot * z13
        z22 = 0.3 * z13 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        s1 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z20)
        z23 = s1 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z24 = z2 * z22
        z25 = s_z * z22
        z26 = c_z * c_t
        s2 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z24))
        z27 = 0.3 * (z24 * z25 - 0.2 * (z22 * z26)) - s2
        z28 = z * x_dot + x * z22
        z29 = y_dot * z28
        s3 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z25))
        z30 = 0.4 * (c_t * c_t - s_t * s_t) + (s3 + 0.3 * z28)
        z31 = 0.5 * z29 + z30
        z32 = x_dot * z25
        s4 = z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z33 = 0.3 * (z2 * z32 - 0.2 * (x_dot * z26)) - s4
        z34 = z33 - z10 * z31
        z35 = z4 - 0.05 * z22
        z36 = z * z6
        z37 = x_dot * x_dot
        z38 = c_z * y_dot * y_dot
        s5 = 2.0 * (x * (z22 * z22)) + (2.0 * (z37 * z36) + z6 * z38)
        z39 = 0.5 * s5 - 0.3 * (z6 * z32)
        s6 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z39
        z40 = 0.5 * (2.0 * x + 6.0 * z36) - s6
        s7 = z23 - (z27 - 0.3 * (z7 * z31) + z6 * z34)
        z41 = s7 + (0.1 * x_dot - z6 * z35 + z40)
        z42 = 0.3 * z22
        s8 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z13 * z20) - z42)
        z43 = s8 - 0.5 * (z13 * z34)
        z44 = z * z13
        s9 = 0.5 * (z37 * z44 + 0.5 * (z13 * z38)) - 0.15 * (z13 * z32)
        z45 = 0.1 * (z8 * z13) + z2 * s9
        s10 = 0.2 * y_dot - z42 - 0.5 * (z13 * z35)
        z46 = s10 + (0.5 * (4.0 * y_2 + 3.0 * z44) - z45)
        s11 = y_dot * (0.2 * (z17 * c_t) + c_z * z24) + z43 + z46
        z47 = (s11 - 0.5 * (z16 * z41)) / z19
        z48 = z15 * z41 + 0.5 * (z16 * z47)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z48,
            # y'' (I.4.9)
            z47,
            # z'' (I.4.9)
            z30 - (z6 * z48 - 0.5 * (z29 + z13 * z47)),
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
    """the state y from coordinates and velocities

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns y (5,).
    """
    x = float(q[0])
    y_2 = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    try:
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (5,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # time
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # from the state
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
            raise _refuse(abs(z12), 0.0, 2, "reactions")
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
        if not abs(z20) > 1e-13 * z16:
            raise _refuse(abs(z20), 1e-13 * z16, 2, "reactions")
        z21 = y_dot * z14
        c_t = math.cos(t_)
        z22 = 0.3 * z14 + (x_dot * z6 + 0.5 * z21) + 0.4 * (c_t * s_t)
        z23 = z4 - 0.05 * z22
        z24 = z * z6
        z25 = x_dot * x_dot
        z26 = c_z * y_dot * y_dot
        z27 = s_z * z22
        z28 = x_dot * z27
        s1 = 2.0 * (x * (z22 * z22)) + (2.0 * (z25 * z24) + z6 * z26)
        z29 = 0.5 * s1 - 0.3 * (z6 * z28)
        s2 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z29
        z30 = 0.5 * (2.0 * x + 6.0 * z24) - s2
        z31 = x + t_ * x_dot
        s3 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z31)
        z32 = s3 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z33 = z * x_dot + x * z22
        s4 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z27))
        z34 = s4 + 0.5 * (y_dot * z33)
        z35 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z33 + z34)
        z36 = z2 * z22
        z37 = c_z * c_t
        s5 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z36))
        z38 = 0.3 * (z36 * z27 - 0.2 * (z22 * z37)) - s5
        s6 = z22 * (0.2 * (z9 * c_t) + 2.0 * (x * (x_dot * z2)))
        z39 = 0.3 * (z2 * z28 - 0.2 * (x_dot * z37)) - s6
        z40 = z10 * z35 - z39
        s7 = z32 + (0.3 * (z7 * z35) - z38 + z6 * z40)
        z41 = 0.1 * x_dot - z6 * z23 + z30 + s7
        z42 = 0.3 * z22
        z43 = z * z14
        s8 = 0.5 * (z25 * z43 + 0.5 * (z14 * z26)) - 0.15 * (z14 * z28)
        z44 = 0.1 * (z8 * z14) + z2 * s8
        s9 = 0.2 * y_dot - z42 - 0.5 * (z14 * z23)
        z45 = s9 + (0.5 * (4.0 * y_2 + 3.0 * z43) - z44)
        s10 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z14 * z31) - z42)
        z46 = s10 + 0.5 * (z14 * z40)
        s11 = z45 + (y_dot * (0.2 * (z13 * c_t) + c_z * z36) + z46)
        z47 = (s11 - 0.5 * (z19 * z41)) / z20
        s12 = 0.2 * z8 + z2 * (0.5 * (2.0 * (z * z25) + z26) - 0.3 * z28)
        z48 = 3.0 * z - s12
        s13 = z11 * (z18 * z41 - 0.5 * (z19 * z47)) + 0.5 * (z15 * z47)
        z49 = s13 + (z23 - z48 - (0.3 * y_dot + 0.1 * z31 + z40))
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            -z49,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V

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
        # from the state
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
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.4.9)

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
        # from the state
        z1 = 1.0 + z * z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        c_z = math.cos(z)
        z3 = y_2 * c_z
        z4 = 0.1 * s_t
        z5 = 1.0 + z4
        z6 = z3 * z5
        z7 = c_z * z2
        z8 = z6 * z7
        z9 = x * x
        z10 = 1.0 + z9
        z11 = z10 * z2
        z12 = 0.3 * z7 + z6 * z11
        z13 = z1 * z2 + 0.3 * z8 + z6 * z12
        # the mass matrix is singular
        if not abs(z13) > 0.0:
            raise _refuse(abs(z13), 0.0, 2, "jacobian")
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
        if not abs(z21) > 1e-13 * z17:
            raise _refuse(abs(z21), 1e-13 * z17, 2, "jacobian")
        z22 = 0.3 + 0.5 * y_dot
        z23 = x_dot * z5
        c_t = math.cos(t_)
        z24 = y_dot * z15
        z25 = 0.3 * z15 + (x_dot * z6 + 0.5 * z24) + 0.4 * (c_t * s_t)
        z26 = z6 * z25
        z27 = z * x_dot + x * z25
        z28 = s_z * z25
        z29 = 0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z28)
        s1 = 0.3 * z27 + (x_dot * z29 + 0.5 * (y_dot * z27))
        z30 = 0.4 * (c_t * c_t - s_t * s_t) + s1
        z31 = y_dot * c_t
        z32 = x + t_ * x_dot
        s2 = 0.4 * (z31 - y_2 * s_t) + 0.1 * (z6 * z32)
        z33 = s2 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z25))
        z34 = z2 * z25
        z35 = c_t * z25
        z36 = 0.2 * (z1 * c_t) + 2.0 * (z * z34)
        z37 = x_dot * z2
        z38 = 0.2 * (z10 * c_t) + 2.0 * (x * z37)
        z39 = x_dot * c_t
        z40 = z28 * z37
        z41 = z11 * z30 + (z25 * z38 + 0.3 * (0.2 * (c_z * z39) - z40))
        s3 = 0.3 * (z34 * z28 - 0.2 * (c_z * z35)) - x_dot * z36
        z42 = 0.3 * (z7 * z30) - s3 + z6 * z41
        z43 = z4 - 0.05 * z25
        z44 = z * z6
        z45 = s_z * z6
        z46 = x_dot * z45
        z47 = z25 * z25
        z48 = x_dot * x_dot
        z49 = y_dot * y_dot
        s4 = 2.0 * (x * z47) + (2.0 * (z48 * z44) + z6 * (z49 * c_z))
        z50 = 0.3 * (z46 * z25) - 0.5 * s4
        s5 = 0.2 * (2.0 * z15 + z9 * z6) - z2 * z50
        z51 = 0.5 * (2.0 * x + 6.0 * z44) - s5
        z52 = z33 + z42 + (0.1 * x_dot - z6 * z43 + z51)
        z53 = 1.0 / z21
        z54 = 0.3 * z25
        z55 = z * z15
        z56 = c_z * z15
        z57 = s_z * z15
        z58 = x_dot * z57
        s6 = 0.5 * (z48 * z55 + 0.5 * (z49 * z56)) - 0.15 * (z58 * z25)
        z59 = 0.1 * (z9 * z15) + z2 * s6
        s7 = 0.2 * y_dot - z54 - 0.5 * (z15 * z43)
        z60 = s7 + (0.5 * (4.0 * y_2 + 3.0 * z55) - z59)
        z61 = 0.2 * (z14 * c_t) + c_z * z34
        s8 = 0.15 * z24 - 0.4 * z39 + (0.05 * (z15 * z32) - z54)
        z62 = y_dot * z61 + (s8 + 0.5 * (z15 * z41))
        z63 = z53 * (z60 + z62 - 0.5 * (z20 * z52))
        z64 = z19 * z52 - 0.5 * (z20 * z63)
        z65 = z6 * z64
        z66 = z15 * z63
        z67 = z65 + 0.5 * z66
        z68 = z30 - z67
        z69 = 0.3 * z12 + 0.5 * (y_dot * z12)
        z70 = x_dot * z34
        z71 = z6 * z70
        s9 = 0.1 * t_ - (0.05 * z6 + (0.3 * (z2 * z46) - 2.0 * (x * z34)))
        z72 = z6 * z38 - s9
        z73 = x_dot * z12
        z74 = z5 * z73
        z75 = y_2 * z74 + 0.3 * (z34 + z6 * z37)
        s10 = 2.0 * (z * z37) + (0.06 * (c_z * c_t) + z72) - s_z * z75
        z76 = 0.3 * (z2 * z28) - s10
        z77 = x * z69 - z76
        z78 = 0.5 * (y_dot * z77) + (0.3 * z77 - (0.4 + 0.5 * (z12 * z63)))
        s11 = z25 * z69 + (1.0 + (2.0 * z71 + (0.1 * z6 - z2 * z47)))
        s12 = 2.0 * (x * (0.2 * z6 - (0.2 * (c_t * z26) + z2 * z6 * z68)))
        z79 = s12 - (s11 + z * z78)
        z80 = z15 * z25
        z81 = z15 * z64
        s13 = 0.5 * (z15 * z30) - (0.25 * (z15 * z66) + 0.5 * (z6 * z81))
        z82 = 0.1 * (c_t * z80) + z2 * s13
        z83 = 0.15 * z16 + 0.25 * (y_dot * z16)
        z84 = y_dot * z2
        z85 = x_dot * z16
        z86 = z5 * z85
        z87 = 0.5 * (y_2 * z86) + 0.15 * (z15 * z37)
        s14 = 0.6 - (0.025 * z15 + 0.15 * (z2 * z58)) - 0.5 * (z15 * z38)
        z88 = c_z * z84 - s14 - s_z * z87
        z89 = x * z83 + z88
        z90 = 0.15 + 0.5 * z89
        z91 = z12 * z64
        z92 = 0.25 * (z16 * z63)
        z93 = z48 * z2
        z94 = 1.5 - 0.5 * z93
        z95 = z49 * z2
        z96 = c_z * z95
        s15 = 0.5 * z43 - (z * z94 - (0.25 * z96 + (0.1 * z9 - 0.15 * z40)))
        z97 = 0.5 * z41 - s15
        s16 = 0.3 * z89 - (0.5 * z91 + (z92 + (z92 - (0.05 * z32 + z97))))
        z98 = y_dot * z90 + s16
        s17 = z25 * z83 + z15 * (0.05 + z70) + z * z98
        z99 = 2.0 * (x * (0.1 * z15 - z82)) - s17
        z100 = z53 * (z99 - 0.5 * (z20 * z79))
        z101 = 3.0 - z93
        s18 = z43 - (z * z101 - (0.5 * z96 + (0.2 * z9 - 0.3 * z40)))
        z102 = 0.3 * y_dot + (z41 - s18)
        s19 = 0.3 * (z7 * z64) + (z11 * z67 + (z91 - (0.1 * z32 + z102)))
        z103 = z5 * (x_dot * z77 - s19)
        z104 = 0.1 * (c_t * z73) + z103
        z105 = 0.4 * s_t + z28 * z74 - c_z * z104
        z106 = 0.05 * (c_t * z85) + z5 * (x_dot * z89 - 0.5 * (z11 * z81))
        s20 = 2.0 - 0.5 * (z28 * z86) + c_z * z106 + 0.5 * (z20 * z105)
        z107 = z53 * s20
        z108 = c_t * z6
        s21 = y_dot * z74 + (0.06 * z35 - 0.5 * (z6 * z95))
        z109 = s21 - 0.3 * (z2 * (z65 - z68)) + y_2 * z104
        s22 = x_dot * z69 + (2.0 * z70 + z6 * z101) + x * z78
        z110 = s22 - s_z * (0.06 * (x_dot * z108) + z109)
        s23 = c_z * (0.3 * z71 - z25 * z75) + z110
        z111 = 2.0 * (z * (0.2 * z39 - z2 * z64)) + s23
        z112 = c_t * z15
        s24 = 0.5 * (y_dot * z86) - (0.25 * (z15 * z95) - z25 * z84)
        z113 = s24 - 0.15 * (z2 * z81) + y_2 * z106
        s25 = 0.15 * (z15 * z70) - z25 * z87 + (0.2 * z31 - z2 * z63)
        s26 = s_z * (0.03 * (x_dot * z112) + z113)
        z114 = c_z * s25 - (s26 - (z15 * z94 + x_dot * z83 + x * z98))
        z115 = z53 * (z114 - 0.5 * (z20 * z111))
        z116 = x * z2
        z117 = 0.3 * (z45 * z34)
        s27 = 2.0 * (z116 * z26) - (z117 - (z36 + (0.1 * (t_ * z6) + z117)))
        z118 = z12 * z29 + (z * z69 + s27)
        s28 = 0.06 * (c_z * z108) + (z6 * z77 + (0.1 + z118))
        z119 = 2.0 * (z44 * z37) - s28
        z120 = 0.15 * (z57 * z34)
        z121 = 0.4 * c_t
        s29 = z120 - (0.05 * (t_ * z15) - (z121 - z120)) - z116 * z80
        z122 = 0.5 * (z16 * z29) + (z * z83 - s29)
        s30 = z55 * z37 - (0.03 * (c_z * z112) + (z6 * z89 + z122))
        z123 = z53 * (s30 - 0.5 * (z20 * z119))
        s31 = c_z * z74 + (z121 + 0.3 * z6 + 0.5 * (z12 * z27))
        z124 = y_dot * z8 - (s31 + 0.5 * (z15 * z77))
        s32 = 0.2 + (0.5 * (c_z * z86) + (z61 + 0.25 * (z16 * z27)))
        z125 = 0.5 * (z56 * z84) - (z15 * z90 + s32)
        z126 = z53 * (z125 - 0.5 * (z20 * z124))
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
            z19 * z79 - 0.5 * (z20 * z100),
            # (I.4.9)
            z19 * z105 + 0.5 * (z20 * z107),
            # (I.4.9)
            0.5 * (z20 * z115) - z19 * z111,
            # (I.4.9)
            z19 * z119 - 0.5 * (z20 * z123),
            # (I.4.9)
            z19 * z124 - 0.5 * (z20 * z126),
            # (I.4.9)
            z100,
            # (I.4.9)
            -z107,
            # (I.4.9)
            -z115,
            # (I.4.9)
            z123,
            # (I.4.9)
            z126,
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
