"""affine_voronec, emitted by nhc 0.1.0 (nhc:8bffdf129c6ccae0).

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
rhs: 56 +-, 100 *, 2 /, 4 calls
velocities: 4 +-, 10 *, 0 /, 3 calls
accelerations: 60 +-, 119 *, 2 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 5 +-, 10 *, 0 /, 3 calls
reactions: 65 +-, 126 *, 2 /, 4 calls
energy: 18 +-, 37 *, 0 /, 4 calls
jacobian: 224 +-, 460 *, 2 /, 4 calls
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
        c_t = math.cos(t_)
        z20 = z3 * (0.3 + 0.5 * y_dot) + (x_dot * z12 + 0.4 * (c_t * s_t))
        z21 = 0.1 * t_
        z22 = c_z * c_t
        z23 = z * x_dot
        z24 = x * z20
        z25 = z2 * z20
        z26 = y_dot * c_z
        s2 = 0.2 * z4 + (z10 - (0.05 * z20 + (0.1 * x + 3.0 * z)))
        z27 = y_dot * (0.3 - 0.5 * (z2 * z26)) - s2
        z28 = x_dot * (0.3 * (s_z * z25) + (z21 - z2 * z23)) + z27
        z29 = s_z * z20
        s3 = (z23 + z24) * (0.03 + 0.05 * y_dot)
        s4 = x_dot * (0.01 * (c_t * z9) + 0.1 * (z11 * (z26 - y_2 * z29)))
        z30 = s4 + (0.04 - 0.08 * (s_t * s_t) + s3)
        s5 = x_dot * (0.6 * z22 + z2 * (20.0 * z24 - 3.0 * z29))
        z31 = s5 + (100.0 * (z6 * z30) + 2.0 * (z5 * c_t * z20))
        s6 = 0.6 * z20 - (2.0 * y_2 - 0.4 * (x_dot * c_t))
        z32 = s6 - z3 * (0.5 * z28 + 0.05 * z31)
        z33 = y_dot * (0.2 * (z1 * c_t) + (0.2 + c_z * z25)) - z32
        s7 = 0.4 * (y_dot * c_t - y_2 * s_t) + 3.0 * (z13 * z30)
        z34 = 0.3 * (z25 * z29) - (s7 - z18 * z33)
        s8 = x_dot * (0.1 + 0.2 * (z14 * c_t))
        z35 = x * (1.0 - 0.4 * z) + (s8 + (z12 * (z28 + 0.1 * z31) - z34))
        s9 = z20 * (z21 - 0.06 * z22 - z2 * (2.0 * z23 - z24)) - z35
        z36 = s9 / z19
        dydt: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z20,
            # x'' (I.4.9) 11:4
            z36,
            # y'' (I.4.9) 11:4
            -(z18 * z36 + z17 * z33),
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
        z24 = z * x_dot + x * z20
        z25 = 0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z24
        z26 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z21))
        z27 = y_dot * z24
        z28 = 0.1 * z25 + (0.1 * z26 + 0.05 * z27)
        z29 = x_dot * c_t
        s2 = z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z22))
        z30 = 100.0 * (z6 * z28) + 10.0 * (0.06 * (c_z * z29) + s2)
        z31 = 3.0 * z23 - z30
        z32 = z * z2
        s3 = x_dot * (0.2 * (z9 * c_t) + 2.0 * (z20 * z32))
        z33 = 0.3 * (z20 * (z2 * z21)) + (0.1 * (t_ * z20) - s3)
        s4 = 0.1 * x_dot + (x + (0.4 * (y_dot * c_t - y_2 * s_t) - z33))
        z34 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - s4
        s5 = 0.2 * z4 + 0.5 * (y_dot * y_dot * z15) + x_dot * x_dot * z32
        z35 = 3.0 * z - (z11 - 0.05 * z20) - s5
        z36 = z35 + (0.1 * (x + t_ * x_dot) + 0.3 * (y_dot + z23))
        s6 = c_z * (0.06 * (c_t * z20) + 3.0 * (z2 * z28))
        z37 = 0.1 * (z13 * z31) - (s6 - (z34 - z13 * z36))
        z38 = 0.3 * z20
        s7 = 2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20)
        z39 = z38 + (z38 - (0.2 * y_dot + s7))
        z40 = 0.05 * (z3 * z31) + (0.4 * z29 + z39 - 0.5 * (z3 * z36))
        z41 = (z37 - z18 * z40) / z19
        z42 = z18 * z41 - z17 * z40
        qddot: list[float] = [
            # x'' (I.4.9)
            z41,
            # y'' (I.4.9)
            -z42,
            # z'' (I.4.9)
            z25 + (0.5 * (z27 - z3 * z42) + (z26 + z13 * z41)),
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
        z27 = z20 * (0.2 * (z5 * c_t) + 2.0 * (x * z24))
        z28 = x_dot * c_t
        z29 = c_z * z28
        z30 = z * x_dot + x * z20
        z31 = 0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z30
        z32 = x_dot * (0.1 * (c_t * z10) + z12 * (y_dot * c_z - y_2 * z23))
        z33 = y_dot * z30
        z34 = 0.1 * z31 + (0.1 * z32 + 0.05 * z33)
        z35 = 3.0 * z25 - (100.0 * (z6 * z34) + 10.0 * (0.06 * z29 + z27))
        s3 = x_dot * (0.2 * (z9 * c_t) + 2.0 * (z20 * z21))
        z36 = 0.3 * (z20 * (z2 * z23)) + (0.1 * (t_ * z20) - s3)
        s4 = 0.1 * x_dot + (x + (0.4 * (y_dot * c_t - y_2 * s_t) - z36))
        z37 = 2.0 * (x * (0.2 * z + 0.5 * (z2 * (z20 * z20)))) - s4
        s5 = c_z * (0.06 * (c_t * z20) + 3.0 * (z2 * z34))
        z38 = 0.1 * (z13 * z35) - (s5 - (z37 - z13 * z26))
        z39 = 0.3 * z20
        s6 = 2.0 * y_2 + y_dot * (0.2 * (z1 * c_t) + z15 * z20)
        z40 = z39 + (z39 - (0.2 * y_dot + s6))
        z41 = 0.05 * (z3 * z35) + (0.4 * z28 + z40 - 0.5 * (z3 * z26))
        z42 = (z38 - z18 * z41) / z19
        s7 = z6 * (z13 * z42 - 0.5 * (z3 * (z18 * z42 - z17 * z41)))
        z43 = 0.3 * (z15 * z42) + s7
        s8 = z6 * (z31 + (z32 + 0.5 * z33))
        z44 = z26 + (z27 + 0.3 * (0.2 * z29 - z25) + s8 + z43)
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            z44,
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
        z23 = 1.0 / z20
        z24 = z19 * z23
        z25 = z13 * z23 - 0.5 * (z3 * z24)
        c_t = math.cos(t_)
        s1 = 0.3 * z3 + (x_dot * z13 + 0.5 * (y_dot * z3))
        z26 = s1 + 0.4 * (c_t * s_t)
        z27 = 0.2 * z + 0.5 * (z2 * (z26 * z26))
        z28 = z26 * z25
        z29 = z2 * z28
        z30 = c_z * z23
        z31 = 3.0 * (z2 * z30) + 10.0 * (z6 * z25)
        z32 = 0.03 * z31 + 0.05 * (y_dot * z31)
        z33 = s_z * z26
        z34 = x_dot * z2
        z35 = z33 * z34
        z36 = z * x_dot + x * z26
        z37 = y_dot * c_z
        z38 = 0.1 * (c_t * z10) + z12 * (z37 - y_2 * z33)
        s2 = 0.1 * (0.4 * (c_t * c_t - s_t * s_t) + 0.3 * z36)
        z39 = s2 + (0.1 * (x_dot * z38) + 0.05 * (y_dot * z36))
        z40 = x_dot * c_t
        z41 = 0.2 * (z5 * c_t) + 2.0 * (x * z34)
        s3 = 100.0 * (z6 * z39) + 10.0 * (0.06 * (c_z * z40) + z26 * z41)
        z42 = 3.0 * z35 - s3
        z43 = z42 * z24
        z44 = z2 * y_dot * y_dot
        z45 = z2 * x_dot * x_dot
        s4 = 0.2 * z4 + 0.5 * (c_z * z44) + z * z45
        z46 = s4 - (3.0 * z - (z11 - 0.05 * z26))
        z47 = z46 - (0.1 * (x + t_ * x_dot) + 0.3 * (y_dot + z35))
        z48 = z47 * z24
        z49 = 0.3 * z26
        z50 = z2 * z26
        z51 = 0.2 * (z1 * c_t) + c_z * z50
        s5 = z49 + (z49 - (0.2 * y_dot + (2.0 * y_2 + y_dot * z51)))
        z52 = 0.4 * z40 + s5 + 0.5 * (z3 * z47)
        z53 = 0.05 * (z3 * z42) + z52
        z54 = 0.06 * (c_t * z26) + 3.0 * (z2 * z39)
        z55 = 0.2 * (z9 * c_t) + 2.0 * (z * z50)
        s6 = 0.3 * (z50 * z33) + (0.1 * (t_ * z26) - x_dot * z55)
        z56 = 0.4 * (y_dot * c_t - y_2 * s_t) - s6
        s7 = 2.0 * (x * z27) - (0.1 * x_dot + (x + z56)) + z13 * z47
        z57 = 0.1 * (z13 * z42) - (c_z * z54 - s7)
        z58 = z57 - z19 * z53
        z59 = z58 * (z23 * z23)
        z60 = z23 * z53 - z17 * z59
        z61 = z18 * z18
        z62 = z60 * (z17 * z61)
        z63 = z19 * z59
        z64 = z63 - z18 * z60
        z65 = 0.5 * (z13 * z64) + 0.25 * (z3 * z62)
        s8 = 0.05 * z43 + 0.5 * z48 - 0.25 * (z7 * z62) - z6 * z65
        z66 = s8 - 0.15 * (z16 * z64)
        z67 = s_z * z25
        z68 = x_dot * z23
        z69 = z2 * z68
        z70 = y_dot * z24
        z71 = z2 * z70
        z72 = x * z23
        s9 = 0.1 * (t_ * z23) - (0.05 * z25 - 2.0 * (z50 * z72))
        z73 = 0.6 * z24 - s9 + z41 * z25
        z74 = x_dot * z31
        z75 = z12 * z74
        z76 = 0.1 * (y_2 * z75) + 0.3 * (z50 * z23 + z34 * z25)
        s10 = 2.0 * (z * z69) - (c_z * z71 - (0.06 * (c_t * z30) + z73))
        z77 = 0.3 * (z2 * (x_dot * z67 - z33 * z23)) + (s10 - s_z * z76)
        z78 = x * z32 + z77
        z79 = z66 + 0.3 * z78 + 0.5 * (y_dot * z78)
        s11 = 0.1 * z25 + (z23 - 2.0 * (z27 * z23)) + 2.0 * (x_dot * z29)
        z80 = s11 + z26 * z32 + z * z79
        z81 = z13 * z59
        s12 = z2 * (10.0 * (z39 * z25) - z3 * z65 + z13 * z81)
        z82 = 0.2 * z25 - (0.2 * (c_t * z28) + s12)
        z83 = z14 * z59
        s13 = z83 - (0.1 * (z42 * z23) + 0.5 * (z7 * z64) - z83 + z23 * z47)
        z84 = s13 + 0.6 * (z16 * z59)
        z85 = 0.01 * (c_t * z74) + z12 * (z84 + x_dot * z78)
        s14 = 3.0 * z25 - (z45 * z25 + 0.4 * z72) + 2.0 * (z26 * z69)
        z86 = s14 + x_dot * z32 + x * z79
        z87 = c_t * z25
        s15 = 0.5 * (z44 * z25) - z54 * z23 + z26 * z71
        s16 = z2 * (0.6 * z81 - 0.15 * (z3 * z64))
        z88 = s15 - 0.1 * (y_dot * z75) - s16
        z89 = x_dot * z50
        s17 = 0.3 * (z89 * z25) - z26 * z76 - (0.2 * (c_t * z70) + z2 * z62)
        s18 = z86 - s_z * (0.06 * (x_dot * z87) - (z88 - y_2 * z85))
        z90 = s18 + c_z * s17
        z91 = z * z34
        z92 = 0.3 * (z50 * z67)
        z93 = 0.4 * (c_t * z24)
        s19 = z92 - (0.1 * (t_ * z25) + (z93 + z92) + z23 * z55)
        z94 = z * z32 - (s19 - 2.0 * (x * z29))
        s20 = 0.1 * z23 + (z94 + 0.1 * (z38 * z31)) + z13 * z78
        z95 = 2.0 * (z91 * z25) - (0.06 * (c_z * z87) + s20)
        z96 = z2 * z37
        s21 = 0.3 * z25 + 0.4 * (c_t * z23) - z51 * z24
        z97 = 0.1 * (c_z * z75) + (s21 + 0.05 * (z36 * z31))
        z98 = z18 + z19 * z24
        z99 = z13 * z24 - 0.5 * (z3 * z98)
        z100 = z26 * z99
        z101 = z2 * z100
        z102 = c_z * z24
        z103 = 3.0 * (z2 * z102) + 10.0 * (z6 * z99)
        z104 = 0.03 * z103 + 0.05 * (y_dot * z103)
        z105 = z23 * z58 - z53 * z24 + z17 * z63
        z106 = z61 * (z53 - z17 * z105)
        z107 = z19 * z63 + z18 * z105
        z108 = 0.5 * (z13 * z107) + 0.25 * (z3 * z106)
        s22 = 0.05 * (z42 * z98) + 0.5 * (z47 * z98) - 0.25 * (z7 * z106)
        z109 = s22 - z6 * z108 - 0.15 * (z16 * z107)
        z110 = s_z * z99
        z111 = x_dot * z24
        z112 = z2 * z111
        z113 = y_dot * z98
        z114 = z2 * z113
        z115 = x * z24
        s23 = 0.1 * (t_ * z24) - (0.05 * z99 - 2.0 * (z50 * z115))
        z116 = 0.6 * z98 - s23 + z41 * z99
        z117 = x_dot * z103
        z118 = z12 * z117
        z119 = 0.1 * (y_2 * z118) + 0.3 * (z50 * z24 + z34 * z99)
        s24 = 2.0 * (z * z112) - (c_z * z114 - (0.06 * (c_t * z102) + z116))
        z120 = 0.3 * (z2 * (x_dot * z110 - z33 * z24)) + (s24 - s_z * z119)
        z121 = x * z104 + z120
        z122 = z109 + 0.3 * z121 + 0.5 * (y_dot * z121)
        s25 = 0.1 * z99 + (z24 - 2.0 * (z27 * z24)) + 2.0 * (x_dot * z101)
        z123 = s25 + z26 * z104 + z * z122
        z124 = z13 * z63
        s26 = z2 * (10.0 * (z39 * z99) - z3 * z108 + z13 * z124)
        z125 = 0.2 * z99 - (0.2 * (c_t * z100) + s26)
        z126 = z14 * z63
        s27 = z126 - (z48 + (0.1 * z43 + 0.5 * (z7 * z107) - z126))
        z127 = s27 + 0.6 * (z16 * z63) + x_dot * z121
        z128 = 0.01 * (c_t * z117) + z12 * z127
        s28 = 3.0 * z99 - (z45 * z99 + 0.4 * z115) + 2.0 * (z26 * z112)
        z129 = s28 + x_dot * z104 + x * z122
        z130 = c_t * z99
        s29 = 0.5 * (z44 * z99) - z54 * z24 + z26 * z114
        s30 = z2 * (0.6 * z124 - 0.15 * (z3 * z107))
        z131 = s29 - 0.1 * (y_dot * z118) - s30
        s31 = 0.3 * (z89 * z99) - z26 * z119
        s32 = z129 - s_z * (0.06 * (x_dot * z130) - (z131 - y_2 * z128))
        z132 = s32 + c_z * (s31 - (0.2 * (c_t * z113) + z2 * z106))
        z133 = 0.3 * (z50 * z110)
        s33 = 0.1 * (t_ * z99) + (0.4 * (c_t * z98) + z133) + z55 * z24
        z134 = z133 - s33 - 2.0 * (x * z101)
        s34 = 0.1 * z24 + (z * z104 - z134 + 0.1 * (z38 * z103))
        z135 = 0.06 * (c_z * z130) + (s34 + z13 * z121)
        s35 = z93 + 0.3 * z99 - z51 * z98 + 0.05 * (z36 * z103)
        z136 = 0.2 * z98 - (0.1 * (c_z * z118) + s35)
        s36 = 2.0 * z24 + 0.4 * (s_t * z23) + 0.1 * (z33 * z75)
        s37 = 2.0 * z98 + 0.4 * (s_t * z24) + 0.1 * (z33 * z118)
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
            2.0 * (x * z82) - z80,
            # (I.4.9)
            s36 - c_z * z85,
            # (I.4.9)
            -(z90 + 2.0 * (z * (0.2 * (c_t * z68) + z2 * z59))),
            # (I.4.9)
            z95,
            # (I.4.9)
            z96 * z25 + (0.2 * z24 - z97 - 0.5 * (z3 * z78)),
            # (I.4.9)
            z123 - 2.0 * (x * z125),
            # (I.4.9)
            c_z * z128 - s37,
            # (I.4.9)
            z132 + 2.0 * (z * (0.2 * (c_t * z111) + z2 * z63)),
            # (I.4.9)
            z135 - 2.0 * (z91 * z99),
            # (I.4.9)
            -(z96 * z99 + (z136 - 0.5 * (z3 * z121))),
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
