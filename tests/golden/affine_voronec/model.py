"""affine_voronec, emitted by nhc 0.1.0 (nhc:6589ca38ca2d0ffa).

A particle with everything at once; affine constraint, time, T of degrees 2, 1 and
    0, drag, a driving force.
Equations of motion: voronec (I.4.9)
Why: dependent velocities of the spec; Čaplygin's equations do not apply: T contains
    the dependent coordinate `z`

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
rhs: 54 +-, 91 *, 2 /, 4 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 59 +-, 114 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 60 +-, 117 *, 2 /, 4 calls
energy: 18 +-, 37 *, 0 /, 4 calls
jacobian: 223 +-, 435 *, 2 /, 4 calls
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
    """Right-hand side dy/dt = f(t, y; p) (I.4.9).

    Arguments: t (scalar), y (5,), p (0,).
    Returns dydt (5,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        s_z = math.sin(z)
        z1 = 2.0 + s_z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        z3 = x * z
        z4 = x * x
        z5 = 1.0 + z4
        z6 = z5 * z2
        z7 = z3 * z6
        z8 = z1 * z2 + 0.25 * (z3 * z7)
        # the mass matrix is singular, if z8 is nearly 0
        if not abs(z8) > 1e-13 * z8:
            raise _refuse(abs(z8), 1e-13 * z8, 2, "rhs")
        c_z = math.cos(z)
        z9 = y_2 * c_z
        z10 = 0.1 * s_t
        z11 = 1.0 + z10
        z12 = z9 * z11
        z13 = c_z * z2
        z14 = 1.0 + z * z
        z15 = z14 * z2
        z16 = 0.15 * (z3 * z13) + 0.5 * (z12 * z7)
        z17 = 1.0 / z8
        z18 = z16 * z17
        z19 = z12 * (0.6 * z13 + z12 * z6) + (z15 - z16 * z18)
        s1 = z15 + z6 * (z12 * z12)
        # the mass matrix is singular, if z19 is nearly 0
        if not abs(z19) > 1e-13 * s1:
            raise _refuse(abs(z19), 1e-13 * s1, 2, "rhs")
        z20 = 0.3 + 0.5 * y_dot
        c_t = math.cos(t_)
        z21 = z3 * z20 + (x_dot * z12 + 0.4 * (c_t * s_t))
        z22 = 0.1 * t_
        z23 = 0.06 * (c_z * c_t)
        z24 = z * x_dot
        z25 = x * z21
        z26 = s_z * z21
        z27 = z2 * z21
        s2 = z2 * (z24 - (2.0 * z25 - 0.3 * z26))
        z28 = x_dot * (s2 - (z22 + (z23 + 0.3 * (s_z * z27))))
        z29 = y_dot * c_z
        s3 = x_dot * (0.1 * (c_t * z9) + z11 * (z29 - y_2 * z26))
        z30 = s3 + (0.4 - 0.8 * (s_t * s_t) + z20 * (z24 + z25))
        s4 = 0.2 * z4 + (z10 - (0.1 * x + 3.0 * z + z6 * z30))
        z31 = z21 * (0.05 + 0.2 * (z5 * c_t)) - s4
        z32 = z28 - (y_dot * (0.3 - 0.5 * (z2 * z29)) + z31)
        s5 = 0.6 * z21 - (2.0 * y_2 - 0.4 * (x_dot * c_t))
        s6 = y_dot * (0.2 * (z1 * c_t) + (0.2 + c_z * z27))
        z33 = s5 + 0.5 * (z3 * z32) - s6
        s7 = 0.4 * (y_dot * c_t - y_2 * s_t) + 0.3 * (z13 * z30)
        z34 = 0.3 * (z27 * z26) - (z18 * z33 + s7)
        s8 = x_dot * (0.1 + 0.2 * (z14 * c_t)) - (z12 * z32 + z34)
        z35 = x * (1.0 - 0.4 * z) + s8
        z36 = (z21 * (z22 - z23 - z2 * (2.0 * z24 - z25)) - z35) / z19
        dydt: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z21,
            # x'' (I.4.9) 11:4
            z36,
            # y'' (I.4.9) 11:4
            z17 * z33 - z18 * z36,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state (I.1.2).

    Arguments: t (scalar), y (5,), p (0,).
    Returns qdot (3,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
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
    """All accelerations q'' on the motion (I.4.9).

    Arguments: t (scalar), y (5,), p (0,).
    Returns qddot (3,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        s_z = math.sin(z)
        z1 = 2.0 + s_z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        z3 = x * z
        z4 = x * x
        z5 = 1.0 + z4
        z6 = z5 * z2
        z7 = z3 * z6
        z8 = z1 * z2 + 0.25 * (z3 * z7)
        # the mass matrix is singular, if z8 is nearly 0
        if not abs(z8) > 1e-13 * z8:
            raise _refuse(abs(z8), 1e-13 * z8, 2, "accelerations")
        z9 = 1.0 + z * z
        c_z = math.cos(z)
        z10 = y_2 * c_z
        z11 = 0.1 * s_t
        z12 = 1.0 + z11
        z13 = z10 * z12
        z14 = z9 * z2 + z6 * (z13 * z13)
        z15 = c_z * z2
        z16 = 0.15 * (z3 * z15) + 0.5 * (z13 * z7)
        z17 = 1.0 / z8
        z18 = z16 * z17
        z19 = z14 + (0.6 * (z13 * z15) - z16 * z18)
        # the mass matrix is singular, if z19 is nearly 0
        if not abs(z19) > 1e-13 * z14:
            raise _refuse(abs(z19), 1e-13 * z14, 2, "accelerations")
        c_t = math.cos(t_)
        s1 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3))
        z20 = s1 + 0.4 * (c_t * s_t)
        z21 = s_z * z20
        z22 = x_dot * z2
        z23 = z21 * z22
        z24 = x_dot * c_t
        z25 = z * x_dot + x * z20
        z26 = y_dot * z25
        s2 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z21))
        z27 = 0.4 * (c_t * c_t - s_t * s_t) + (s2 + 0.3 * z25)
        z28 = 0.5 * z26 + z27
        s3 = z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z22))
        z29 = 0.06 * (c_z * z24) + s3 + z6 * z28
        z30 = 0.3 * z23 - z29
        z31 = z * z2
        s4 = x_dot * (0.2 * (z9 * c_t) + 2.0 * (z31 * z20))
        z32 = 0.3 * (z2 * z20 * z21) + (0.1 * (t_ * z20) - s4)
        s5 = 0.1 * x_dot + (x + (0.4 * (y_dot * c_t - y_2 * s_t) - z32))
        z33 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - s5
        s6 = 0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot * z31
        z34 = 3.0 * z - (z11 - 0.05 * z20) - s6
        z35 = z34 + (0.1 * (x + t_ * x_dot) + 0.3 * (y_dot + z23))
        s7 = c_z * (0.06 * (c_t * z20) + 0.3 * (z2 * z28))
        z36 = z13 * z30 - (s7 - (z33 - z13 * z35))
        z37 = 0.3 * z20
        s8 = 2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20)
        z38 = z37 + (z37 - (0.2 * y_dot + s8))
        z39 = 0.5 * (z3 * z30) + (0.4 * z24 + z38 - 0.5 * (z3 * z35))
        z40 = (z36 - z18 * z39) / z19
        z41 = z18 * z40 - z17 * z39
        qddot: list[float] = [
            # x'' (I.4.9)
            z40,
            # y'' (I.4.9)
            -z41,
            # z'' (I.4.9)
            z27 + (z13 * z40 + 0.5 * (z26 - z3 * z41)),
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
    """The state y from coordinates and velocities.

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns y (5,).
    """
    x = float(q[0])
    y_2 = float(q[1])  # y
    z = float(q[2])
    x_dot = float(qdot[0])  # x'
    y_dot = float(qdot[1])  # y'
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns r (1,).
    """
    t_ = float(t)  # t: time
    x = float(q[0])
    y = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])  # x'
    y_dot = float(qdot[1])  # y'
    z_dot = float(qdot[2])  # z'
    try:
        # from the coordinates and velocities
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
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (5,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        s_z = math.sin(z)
        z1 = 2.0 + s_z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        z3 = x * z
        z4 = x * x
        z5 = 1.0 + z4
        z6 = z5 * z2
        z7 = z3 * z6
        z8 = z1 * z2 + 0.25 * (z3 * z7)
        # the mass matrix is singular, if z8 is nearly 0
        if not abs(z8) > 1e-13 * z8:
            raise _refuse(abs(z8), 1e-13 * z8, 2, "reactions")
        z9 = 1.0 + z * z
        c_z = math.cos(z)
        z10 = y_2 * c_z
        z11 = 0.1 * s_t
        z12 = 1.0 + z11
        z13 = z10 * z12
        z14 = z9 * z2 + z6 * (z13 * z13)
        z15 = c_z * z2
        z16 = 0.15 * (z3 * z15) + 0.5 * (z13 * z7)
        z17 = 1.0 / z8
        z18 = z16 * z17
        z19 = z14 + (0.6 * (z13 * z15) - z16 * z18)
        # the mass matrix is singular, if z19 is nearly 0
        if not abs(z19) > 1e-13 * z14:
            raise _refuse(abs(z19), 1e-13 * z14, 2, "reactions")
        c_t = math.cos(t_)
        s1 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3))
        z20 = s1 + 0.4 * (c_t * s_t)
        z21 = z * z2
        s2 = 0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot * z21
        z22 = 3.0 * z - (z11 - 0.05 * z20) - s2
        z23 = s_z * z20
        z24 = x_dot * z2
        z25 = z23 * z24
        z26 = z22 + (0.1 * (x + t_ * x_dot) + 0.3 * (y_dot + z25))
        z27 = z * x_dot + x * z20
        s3 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z23))
        z28 = s3 + 0.5 * (y_dot * z27)
        z29 = z28 + (0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z27)
        z30 = x_dot * c_t
        s4 = z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z24))
        z31 = z6 * z29 + (0.06 * (c_z * z30) + s4)
        z32 = 0.3 * z25 - z31
        s5 = x_dot * (0.2 * (z9 * c_t) + 2.0 * (z21 * z20))
        z33 = 0.3 * (z2 * z20 * z23) + (0.1 * (t_ * z20) - s5)
        s6 = 0.1 * x_dot + (x + (0.4 * (y_dot * c_t - y_2 * s_t) - z33))
        z34 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - s6
        s7 = c_z * (0.06 * (c_t * z20) + 0.3 * (z2 * z29))
        z35 = z13 * z32 - (s7 - (z34 - z13 * z26))
        z36 = 0.3 * z20
        s8 = 2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20)
        z37 = z36 + (z36 - (0.2 * y_dot + s8))
        z38 = 0.4 * z30 + z37 - 0.5 * (z3 * z26) + 0.5 * (z3 * z32)
        z39 = (z35 - z18 * z38) / z19
        s9 = z6 * (z13 * z39 - 0.5 * (z3 * (z18 * z39 - z17 * z38)))
        z40 = 0.3 * (z15 * z39) + s9
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z26 - (z32 - z40),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V.

    Arguments: t (scalar), y (5,), p (0,).
    Returns a scalar.
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
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
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.4.9).

    Arguments: t (scalar), y (5,), p (0,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # t: time
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        s_z = math.sin(z)
        z1 = 2.0 + s_z
        s_t = math.sin(t_)
        z2 = 1.0 + 0.2 * s_t
        z3 = x * z
        z4 = x * x
        z5 = 1.0 + z4
        z6 = z5 * z2
        z7 = z3 * z6
        z8 = z1 * z2 + 0.25 * (z3 * z7)
        # the mass matrix is singular, if z8 is nearly 0
        if not abs(z8) > 1e-13 * z8:
            raise _refuse(abs(z8), 1e-13 * z8, 2, "jacobian")
        z9 = 1.0 + z * z
        c_z = math.cos(z)
        z10 = y_2 * c_z
        z11 = 0.1 * s_t
        z12 = 1.0 + z11
        z13 = z10 * z12
        z14 = z13 * z6
        z15 = z9 * z2 + z13 * z14
        z16 = c_z * z2
        z17 = 0.15 * (z3 * z16) + 0.5 * (z13 * z7)
        z18 = 1.0 / z8
        z19 = z17 * z18
        z20 = z15 + (0.6 * (z13 * z16) - z17 * z19)
        # the mass matrix is singular, if z20 is nearly 0
        if not abs(z20) > 1e-13 * z15:
            raise _refuse(abs(z20), 1e-13 * z15, 2, "jacobian")
        z21 = 0.3 + 0.5 * y_dot
        z22 = x_dot * z12
        c_t = math.cos(t_)
        s1 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3))
        z23 = s1 + 0.4 * (c_t * s_t)
        z24 = 1.0 / z20
        z25 = c_z * z24
        z26 = z19 * z24
        z27 = 0.5 * (z3 * z26) - z13 * z24
        z28 = 0.3 * (z2 * z25) - z6 * z27
        z29 = 0.3 * z28 + 0.5 * (y_dot * z28)
        z30 = z2 * z23
        z31 = x_dot * z30
        z32 = z31 * z27
        z33 = 0.2 * z + 0.5 * (z2 * (z23 * z23))
        z34 = x_dot * z24
        z35 = z2 * z34
        z36 = y_dot * z26
        z37 = z2 * z36
        z38 = x * z2
        z39 = 0.2 * (z5 * c_t) + 2.0 * (x_dot * z38)
        z40 = x * z24
        s2 = 0.1 * (t_ * z24) + (0.05 * z27 + 2.0 * (z30 * z40))
        z41 = z39 * z27 - (0.6 * z26 - s2)
        z42 = x_dot * z28
        z43 = z12 * z42
        z44 = x_dot * z2
        z45 = y_2 * z43 - 0.3 * (z44 * z27 - z30 * z24)
        z46 = s_z * z27
        z47 = s_z * z23
        s3 = 2.0 * (z * z35) - (c_z * z37 - (0.06 * (c_t * z25) - z41))
        z48 = s3 - s_z * z45 - 0.3 * (z2 * (x_dot * z46 + z47 * z24))
        z49 = x * z29 + z48
        z50 = z47 * z44
        z51 = 0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z47)
        z52 = z * x_dot + x * z23
        s4 = 0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z52
        z53 = x_dot * z51 + 0.5 * (y_dot * z52) + s4
        z54 = x_dot * c_t
        z55 = 0.3 * z50 - (z6 * z53 + (0.06 * (c_z * z54) + z23 * z39))
        z56 = z2 * y_dot * y_dot
        z57 = z2 * x_dot * x_dot
        s5 = 0.2 * z4 + 0.5 * (c_z * z56) + z * z57
        z58 = s5 - (3.0 * z - (z11 - 0.05 * z23))
        z59 = z58 - (0.1 * (x + t_ * x_dot) + 0.3 * (y_dot + z50))
        z60 = z55 + z59
        z61 = 0.3 * z23
        z62 = 0.2 * (z1 * c_t) + z16 * z23
        s6 = z61 + (z61 - (0.2 * y_dot + (2.0 * y_2 + y_dot * z62)))
        z63 = 0.4 * z54 + s6 + 0.5 * (z3 * z59)
        z64 = 0.5 * (z3 * z55) + z63
        z65 = 0.06 * (c_t * z23) + 0.3 * (z2 * z53)
        z66 = z * z2
        z67 = 0.2 * (z9 * c_t) + 2.0 * (z66 * z23)
        s7 = 0.3 * (z30 * z47) + (0.1 * (t_ * z23) - x_dot * z67)
        z68 = 0.4 * (y_dot * c_t - y_2 * s_t) - s7
        s8 = 2.0 * (x * z33) - (0.1 * x_dot + (x + z68)) + z13 * z59
        z69 = z13 * z55 - (c_z * z65 - s8)
        z70 = z69 - z19 * z64
        z71 = z70 * (z24 * z24)
        z72 = z24 * z64 - z17 * z71
        z73 = z18 * z18
        z74 = z72 * (z17 * z73)
        z75 = z19 * z71
        z76 = z75 - z18 * z72
        z77 = 0.5 * (z13 * z76) + 0.25 * (z3 * z74)
        s9 = 0.5 * (z26 * z60) - 0.25 * (z7 * z74) - z6 * z77
        z78 = 0.3 * z49 + (s9 - 0.15 * (z16 * z76))
        z79 = 0.5 * (y_dot * z49) + z78
        s10 = 2.0 * z32 + (0.1 * z27 - (z24 - 2.0 * (z33 * z24)))
        z80 = z23 * z29 - s10 + z * z79
        z81 = z23 * z27
        z82 = z13 * z71
        s11 = 0.2 * (c_t * z81) + z2 * (z53 * z27 + z3 * z77 - z13 * z82)
        z83 = 0.2 * z27 - s11
        z84 = z14 * z71
        s12 = z84 - (z24 * z55 + 0.5 * (z7 * z76) - z84 + z24 * z59)
        z85 = s12 + 0.6 * (z16 * z71)
        z86 = 0.1 * (c_t * z42) + z12 * (x_dot * z49 + z85)
        s13 = 3.0 * z27 - (z57 * z27 - 0.4 * z40) - 2.0 * (z23 * z35)
        z87 = x_dot * z29 - s13 + x * z79
        z88 = c_t * z27
        s14 = y_dot * z43 + (0.5 * (z56 * z27) + z65 * z24 - z23 * z37)
        z89 = s14 + z2 * (0.6 * z82 - 0.15 * (z3 * z76))
        s15 = c_z * (0.3 * z32 + z23 * z45 + (0.2 * (c_t * z36) + z2 * z74))
        z90 = z87 + s_z * (0.06 * (x_dot * z88) - (z89 + y_2 * z86)) - s15
        z91 = x_dot * z66
        z92 = 0.3 * (z30 * z46)
        z93 = 0.4 * (c_t * z26)
        s16 = z92 - (0.1 * (t_ * z27) - (z93 - z92) - z67 * z24)
        z94 = z * z29 - (2.0 * (z38 * z81) - s16)
        s17 = z13 * z49 + (0.1 * z24 + (z51 * z28 + z94))
        z95 = 2.0 * (z27 * z91) - (0.06 * (c_z * z88) - s17)
        z96 = y_dot * z16
        s18 = 0.3 * z27 - 0.4 * (c_t * z24) + z62 * z26
        z97 = c_z * z43 - (s18 - 0.5 * (z52 * z28))
        z98 = c_z * z26
        z99 = z18 + z19 * z26
        z100 = 0.5 * (z3 * z99) - z13 * z26
        z101 = 0.3 * (z2 * z98) - z6 * z100
        z102 = 0.3 * z101 + 0.5 * (y_dot * z101)
        z103 = z31 * z100
        z104 = x_dot * z26
        z105 = z2 * z104
        z106 = y_dot * z99
        z107 = z2 * z106
        z108 = x * z26
        s19 = 0.1 * (t_ * z26) + (0.05 * z100 + 2.0 * (z30 * z108))
        z109 = z39 * z100 - (0.6 * z99 - s19)
        z110 = x_dot * z101
        z111 = z12 * z110
        z112 = y_2 * z111 - 0.3 * (z44 * z100 - z30 * z26)
        z113 = s_z * z100
        s20 = 2.0 * (z * z105) - (c_z * z107 - (0.06 * (c_t * z98) - z109))
        z114 = s20 - s_z * z112 - 0.3 * (z2 * (x_dot * z113 + z47 * z26))
        z115 = x * z102 + z114
        z116 = z24 * z70 - z64 * z26 + z17 * z75
        z117 = z73 * (z64 - z17 * z116)
        z118 = z19 * z75 + z18 * z116
        z119 = 0.5 * (z13 * z118) + 0.25 * (z3 * z117)
        s21 = 0.5 * (z99 * z60) - 0.25 * (z7 * z117) - z6 * z119
        z120 = 0.3 * z115 + (s21 - 0.15 * (z16 * z118))
        z121 = 0.5 * (y_dot * z115) + z120
        s22 = 2.0 * z103 + (0.1 * z100 - (z26 - 2.0 * (z33 * z26)))
        z122 = z23 * z102 - s22 + z * z121
        z123 = z23 * z100
        z124 = z13 * z75
        s23 = z2 * (z53 * z100 + z3 * z119 - z13 * z124)
        z125 = 0.2 * z100 - (0.2 * (c_t * z123) + s23)
        z126 = z14 * z75
        s24 = z126 - (z59 * z26 + (z55 * z26 + 0.5 * (z7 * z118) - z126))
        z127 = s24 + 0.6 * (z16 * z75)
        z128 = 0.1 * (c_t * z110) + z12 * (x_dot * z115 + z127)
        s25 = 3.0 * z100 - (z57 * z100 - 0.4 * z108) - 2.0 * (z23 * z105)
        z129 = x_dot * z102 - s25 + x * z121
        z130 = c_t * z100
        s26 = y_dot * z111 + (0.5 * (z56 * z100) + z65 * z26 - z23 * z107)
        z131 = s26 + z2 * (0.6 * z124 - 0.15 * (z3 * z118))
        s27 = 0.3 * z103 + z23 * z112 + (0.2 * (c_t * z106) + z2 * z117)
        s28 = z129 + s_z * (0.06 * (x_dot * z130) - (z131 + y_2 * z128))
        z132 = s28 - c_z * s27
        z133 = 0.3 * (z30 * z113)
        s29 = 0.1 * (t_ * z100) - (0.4 * (c_t * z99) - z133) - z67 * z26
        z134 = 2.0 * (z38 * z123) - (z133 - s29)
        s30 = z13 * z115 + (0.1 * z26 + (z51 * z101 + (z * z102 - z134)))
        z135 = 0.06 * (c_z * z130) - s30
        s31 = z93 - 0.3 * z100 - z62 * z99 + 0.5 * (z52 * z101)
        z136 = 0.2 * z99 - (c_z * z111 + s31)
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
            z13,
            # (I.4.9)
            0.5 * z3,
            # (I.4.9)
            -(z80 + 2.0 * (x * z83)),
            # (I.4.9)
            2.0 * z26 + 0.4 * (s_t * z24) + z47 * z43 - c_z * z86,
            # (I.4.9)
            -(z90 + 2.0 * (z * (0.2 * (c_t * z34) + z2 * z71))),
            # (I.4.9)
            -z95,
            # (I.4.9)
            0.2 * z26 - z97 - 0.5 * (z3 * z49) - z27 * z96,
            # (I.4.9)
            z122 + 2.0 * (x * z125),
            # (I.4.9)
            c_z * z128 - (2.0 * z99 + 0.4 * (s_t * z26) + z47 * z111),
            # (I.4.9)
            z132 + 2.0 * (z * (0.2 * (c_t * z104) + z2 * z75)),
            # (I.4.9)
            2.0 * (z91 * z100) - z135,
            # (I.4.9)
            z96 * z100 - (z136 - 0.5 * (z3 * z115)),
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 5] for k1 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (0,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
