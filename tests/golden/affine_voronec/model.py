"""affine_voronec, emitted by nhc 0.1.0 (nhc:113533fe9185ec98).

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
rhs: 61 +-, 102 *, 2 /, 4 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 65 +-, 134 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 71 +-, 141 *, 2 /, 4 calls
energy: 18 +-, 37 *, 0 /, 4 calls
jacobian: 202 +-, 384 *, 2 /, 4 calls
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
        s1 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z24))
        s2 = 0.4 - 0.8 * (s_t * s_t) + (0.3 + 0.5 * y_dot) * (z26 + z27)
        z28 = s1 + s2
        s3 = 0.4 * z14 - (0.4 * (y_dot * c_t) + (x - 0.4 * (y_2 * s_t)))
        z29 = 0.3 * (z7 * z28) - s3
        s4 = z22 * (0.1 * t_ - z23 + z2 * (z25 - (2.0 * z26 - z27)))
        z30 = s4 - (x_dot * (0.1 + 0.2 * (z1 * c_t)) + z29)
        z31 = c_z * y_dot * y_dot
        z32 = z * x_dot * x_dot
        z33 = x_dot * z24
        z34 = x + t_ * x_dot
        z35 = 3.0 * z - (z4 - 0.05 * z22)
        s5 = x_dot * (z23 + z2 * (2.0 * z27 - z25))
        z36 = s5 + (z11 * z28 + 0.2 * (z10 * c_t * z22))
        s6 = 0.1 * z34 - (0.2 * z9 - (0.3 * y_dot + z35) - z36)
        z37 = z2 * (0.5 * z31 + (z32 - 0.3 * z33)) - s6
        z38 = z30 + z6 * z37
        s7 = 0.05 * z34 - (0.1 * z9 - 0.5 * z35 - 0.5 * z36)
        z39 = z2 * (0.25 * z31 + (0.5 * z32 - 0.15 * z33)) - s7
        s8 = 2.0 * y_2 - 0.4 * (x_dot * c_t) + 0.5 * (z17 * z38)
        z40 = 0.15 * z21 - (0.6 * z22 - s8)
        s9 = y_dot * (0.2 * (z18 * c_t) + (0.2 + z7 * z22)) + z40
        z41 = (z14 * z39 - s9) / z20
        dydt: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z22,
            # x'' (I.4.9) 11:4
            z16 * z38 + 0.5 * (z17 * z41),
            # y'' (I.4.9) 11:4
            -z41,
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
        s4 = (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t)) * z22
        z33 = s4 - 0.3 * (z2 * z32 - 0.2 * (x_dot * z26))
        z34 = z33 + z10 * z31
        z35 = 3.0 * z - (z4 - 0.05 * z22)
        z36 = z * x_dot * x_dot
        z37 = c_z * y_dot * y_dot
        s5 = 2.0 * (x * (z22 * z22)) + (2.0 * (z6 * z36) + z6 * z37)
        z38 = 0.5 * s5 - 0.3 * (z6 * z32)
        s6 = 0.2 * (2.0 * z13 + z8 * z6) + z2 * z38
        z39 = x + 0.1 * x_dot + z6 * z35 - s6
        z40 = z23 - (z27 - 0.3 * (z7 * z31) - z6 * z34) + z39
        z41 = 0.3 * z22
        s7 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z13 * z20) - z41)
        z42 = s7 + 0.5 * (z13 * z34)
        s8 = 0.5 * (z13 * z36 + 0.5 * (z13 * z37)) - 0.15 * (z13 * z32)
        z43 = 0.1 * (z8 * z13) + z2 * s8
        s9 = 2.0 * y_2 + (0.2 * y_dot - z41) + 0.5 * (z13 * z35) - z43
        z44 = y_dot * (0.2 * (z17 * c_t) + c_z * z24) + z42 + s9
        z45 = (z44 - 0.5 * (z16 * z40)) / z19
        z46 = z15 * z40 + 0.5 * (z16 * z45)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z46,
            # y'' (I.4.9)
            z45,
            # z'' (I.4.9)
            z30 - (z6 * z46 - 0.5 * (z29 + z13 * z45)),
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
        z23 = 3.0 * z - (z4 - 0.05 * z22)
        z24 = z * x_dot * x_dot
        z25 = c_z * y_dot * y_dot
        z26 = s_z * z22
        z27 = x_dot * z26
        s1 = 2.0 * (x * (z22 * z22)) + (2.0 * (z6 * z24) + z6 * z25)
        z28 = 0.5 * s1 - 0.3 * (z6 * z27)
        s2 = 0.2 * (2.0 * z14 + z8 * z6) + z2 * z28
        z29 = x + 0.1 * x_dot + z6 * z23 - s2
        z30 = x + t_ * x_dot
        s3 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.1 * (z6 * z30)
        z31 = s3 + (0.3 * (y_dot * z6) - 0.1 * (t_ * z22))
        z32 = z * x_dot + x * z22
        s4 = x_dot * (0.1 * (c_t * z3) + z5 * (y_dot * c_z - y_2 * z26))
        z33 = s4 + 0.5 * (y_dot * z32)
        z34 = 0.4 * (c_t * c_t - s_t * s_t) + (0.3 * z32 + z33)
        z35 = z2 * z22
        z36 = c_z * c_t
        s5 = x_dot * (0.2 * (z1 * c_t) + 2.0 * (z * z35))
        z37 = 0.3 * (z35 * z26 - 0.2 * (z22 * z36)) - s5
        s6 = (2.0 * (z2 * (x * x_dot)) + 0.2 * (z9 * c_t)) * z22
        z38 = s6 - 0.3 * (z2 * z27 - 0.2 * (x_dot * z36))
        z39 = z10 * z34 + z38
        z40 = z29 + (z31 + (0.3 * (z7 * z34) - z37 + z6 * z39))
        z41 = 0.3 * z22
        s7 = 0.5 * (z14 * z24 + 0.5 * (z14 * z25)) - 0.15 * (z14 * z27)
        z42 = 0.1 * (z8 * z14) + z2 * s7
        s8 = 0.15 * z21 - 0.4 * (x_dot * c_t) + (0.05 * (z14 * z30) - z41)
        z43 = s8 + 0.5 * (z14 * z39)
        s9 = 2.0 * y_2 + (0.2 * y_dot - z41) + 0.5 * (z14 * z23) - z42
        z44 = s9 + (y_dot * (0.2 * (z13 * c_t) + c_z * z35) + z43)
        z45 = (z44 - 0.5 * (z19 * z40)) / z20
        s10 = z23 - (0.2 * z8 + z2 * (0.5 * (2.0 * z24 + z25) - 0.3 * z27))
        z46 = s10 + (0.3 * y_dot + 0.1 * z30 + z39)
        s11 = z11 * (z18 * z40 - 0.5 * (z19 * z45)) + 0.5 * (z15 * z45)
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z46 - s11,
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
        z37 = x_dot * c_t
        z38 = x_dot * z2
        z39 = z28 * z38
        z40 = 0.2 * (z10 * c_t) + 2.0 * (x * z38)
        z41 = z11 * z30 + (0.3 * (0.2 * (c_z * z37) - z39) + z25 * z40)
        s3 = 0.3 * (z34 * z28 - 0.2 * (c_z * z35)) - x_dot * z36
        z42 = 0.3 * (z7 * z30) - s3 + z6 * z41
        z43 = 3.0 * z - (z4 - 0.05 * z25)
        z44 = s_z * z6
        z45 = x_dot * z44
        z46 = z25 * z25
        z47 = x_dot * x_dot
        z48 = z * z6
        z49 = y_dot * y_dot
        s4 = 2.0 * (x * z46) + (2.0 * (z47 * z48) + z6 * (z49 * c_z))
        z50 = 0.3 * (z45 * z25) - 0.5 * s4
        s5 = 0.2 * (2.0 * z15 + z9 * z6) - z2 * z50
        z51 = x + 0.1 * x_dot + z6 * z43 - s5
        z52 = z33 + z42 + z51
        z53 = 1.0 / z21
        z54 = 0.3 * z25
        z55 = z * z15
        z56 = c_z * z15
        z57 = s_z * z15
        z58 = x_dot * z57
        s6 = 0.5 * (z47 * z55 + 0.5 * (z49 * z56)) - 0.15 * (z58 * z25)
        z59 = 0.1 * (z9 * z15) + z2 * s6
        z60 = 0.2 * (z14 * c_t) + c_z * z34
        s7 = 0.15 * z24 - 0.4 * z37 + (0.05 * (z15 * z32) - z54)
        z61 = y_dot * z60 + (s7 + 0.5 * (z15 * z41))
        s8 = 2.0 * y_2 + (0.2 * y_dot - z54) + 0.5 * (z15 * z43) - z59
        z62 = s8 + z61 - 0.5 * (z20 * z52)
        z63 = z53 * z62
        z64 = z19 * z52 - 0.5 * (z20 * z63)
        z65 = z6 * z64
        z66 = z15 * z63
        z67 = z65 + 0.5 * z66
        z68 = z30 - z67
        z69 = 0.3 * z12 + 0.5 * (y_dot * z12)
        z70 = x_dot * z34
        z71 = z6 * z70
        s9 = 0.1 * t_ - (0.05 * z6 + 0.3 * (z2 * z45) - 2.0 * (x * z34))
        z72 = z6 * z40 - s9
        z73 = x_dot * z12
        z74 = z5 * z73
        z75 = y_2 * z74 + 0.3 * (z34 + z6 * z38)
        s10 = 2.0 * (z * z38) + (0.06 * (c_z * c_t) + z72) - s_z * z75
        z76 = 0.3 * (z2 * z28) - s10
        z77 = x * z69 - z76
        z78 = 0.5 * (y_dot * z77) + (0.3 * z77 - (0.4 + 0.5 * (z12 * z63)))
        s11 = z25 * z69 + (2.0 * z71 + (0.1 * z6 + (1.0 - z2 * z46)))
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
        z87 = 0.5 * (y_2 * z86) + 0.15 * (z15 * z38)
        s14 = 0.6 - (0.025 * z15 + 0.15 * (z2 * z58)) - 0.5 * (z15 * z40)
        z88 = c_z * z84 - s14 - s_z * z87
        z89 = x * z83 + z88
        z90 = 0.15 + 0.5 * z89
        z91 = z12 * z64
        z92 = z47 * z2
        z93 = z * z92
        z94 = 0.25 * (z16 * z63)
        z95 = z49 * z2
        z96 = c_z * z95
        s15 = 0.5 * z41 - (0.25 * z96 + (0.1 * z9 - 0.15 * z39))
        z97 = z94 + (z94 - (0.05 * z32 + s15))
        s16 = 0.3 * z89 - (0.5 * z91 - (0.5 * z43 - (0.5 * z93 + z97)))
        z98 = y_dot * z90 + s16
        s17 = z25 * z83 + z15 * (0.05 + z70) + z * z98
        z99 = 2.0 * (x * (0.1 * z15 - z82)) - s17
        z100 = z53 * (z99 - 0.5 * (z20 * z79))
        s18 = z41 - (z93 + (0.5 * z96 + (0.2 * z9 - z43 - 0.3 * z39)))
        z101 = 0.1 * z32 + (0.3 * y_dot + s18)
        s19 = x_dot * z77 - (0.3 * (z7 * z64) + (z11 * z67 + (z91 - z101)))
        z102 = 0.1 * (c_t * z73) + z5 * s19
        z103 = 0.4 * s_t + z28 * z74 - c_z * z102
        z104 = 0.05 * (c_t * z85) + z5 * (x_dot * z89 - 0.5 * (z11 * z81))
        s20 = 2.0 - 0.5 * (z28 * z86) + c_z * z104 + 0.5 * (z20 * z103)
        z105 = z53 * s20
        z106 = c_t * z6
        s21 = y_dot * z74 + (0.06 * z35 - 0.5 * (z6 * z95))
        z107 = s21 - 0.3 * (z2 * (z65 - z68)) + y_2 * z102
        s22 = x_dot * z69 + (2.0 * z70 + z6 * (3.0 - z92)) + x * z78
        z108 = s22 - s_z * (0.06 * (x_dot * z106) + z107)
        s23 = c_z * (0.3 * z71 - z25 * z75) + z108
        z109 = 2.0 * (z * (0.2 * z37 - z2 * z64)) + s23
        z110 = c_t * z15
        s24 = 0.5 * (y_dot * z86) - (0.25 * (z15 * z95) - z25 * z84)
        z111 = s24 - 0.15 * (z2 * z81) + y_2 * z104
        s25 = 1.5 * z15 - 0.5 * (z15 * z92) + x_dot * z83 + x * z98
        z112 = s_z * (0.03 * (x_dot * z110) + z111) - s25
        s26 = 0.15 * (z15 * z70) - z25 * z87 + (0.2 * z31 - z2 * z63)
        z113 = c_z * s26 - z112 - 0.5 * (z20 * z109)
        z114 = z53 * z113
        z115 = x * z2
        z116 = 0.3 * (z44 * z34)
        s27 = 2.0 * (z115 * z26) - (z116 - (z36 + (0.1 * (t_ * z6) + z116)))
        z117 = z12 * z29 + (z * z69 + s27)
        s28 = 0.06 * (c_z * z106) + (z6 * z77 + (0.1 + z117))
        z118 = 2.0 * (z48 * z38) - s28
        z119 = 0.15 * (z57 * z34)
        z120 = 0.4 * c_t
        s29 = z119 - (0.05 * (t_ * z15) - (z120 - z119)) - z115 * z80
        z121 = 0.5 * (z16 * z29) + (z * z83 - s29)
        s30 = z55 * z38 - (0.03 * (c_z * z110) + (z6 * z89 + z121))
        z122 = z53 * (s30 - 0.5 * (z20 * z118))
        s31 = c_z * z74 + (z120 + 0.3 * z6 + 0.5 * (z12 * z27))
        z123 = y_dot * z8 - (s31 + 0.5 * (z15 * z77))
        s32 = 0.2 + (0.5 * (c_z * z86) + (z60 + 0.25 * (z16 * z27)))
        z124 = 0.5 * (z56 * z84) - (z15 * z90 + s32)
        z125 = z53 * (z124 - 0.5 * (z20 * z123))
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
            z19 * z103 + 0.5 * (z20 * z105),
            # (I.4.9)
            0.5 * (z20 * z114) - z19 * z109,
            # (I.4.9)
            z19 * z118 - 0.5 * (z20 * z122),
            # (I.4.9)
            z19 * z123 - 0.5 * (z20 * z125),
            # (I.4.9)
            z100,
            # (I.4.9)
            -z105,
            # (I.4.9)
            -z114,
            # (I.4.9)
            z122,
            # (I.4.9)
            z125,
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
