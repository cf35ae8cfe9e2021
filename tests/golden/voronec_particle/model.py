"""voronec_particle, emitted by nhc 0.1.0 (nhc:f59ddd0565b78ef4).

A particle whose T, U and constraint depend on the dependent coordinate, so that
    Čaplygin's hypotheses fail.
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
rhs: 31 +-, 60 *, 2 /, 2 calls
velocities: 1 +-, 5 *, 0 /, 1 calls
accelerations: 34 +-, 78 *, 2 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 2 +-, 5 *, 0 /, 1 calls
reactions: 37 +-, 82 *, 2 /, 2 calls
energy: 10 +-, 20 *, 0 /, 2 calls
jacobian: 125 +-, 254 *, 2 /, 2 calls
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
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular, if z5 is 0
        if not abs(z5) > 0.0:
            raise _refuse(abs(z5), 0.0, 2, "rhs")
        s_z = math.sin(z)
        z6 = x * z
        z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6))
        z8 = z6 * z4
        z9 = 1.0 / z5
        z10 = z8 * z9
        z11 = z7 - 0.25 * (z8 * z10)
        # the mass matrix is singular, if z11 is nearly 0
        if not abs(z11) > 1e-13 * z7:
            raise _refuse(abs(z11), 1e-13 * z7, 2, "rhs")
        z12 = x_dot * z1 + 0.5 * (y_dot * z6)
        z13 = s_z * z12
        z14 = 0.3 * z13
        z15 = x * z12
        z16 = x_dot * x_dot
        z17 = y_dot * y_dot
        z18 = y_dot * c_z
        s1 = 0.5 * (y_dot * (z * x_dot + z15))
        z19 = x_dot * (z18 - y_2 * z13) + s1
        z20 = z3 * z19 - x_dot * (z14 - 2.0 * z15)
        s2 = 0.5 * (z17 * z2) - (z1 * z20 + (x + 0.3 * (c_z * z19)))
        z21 = z * z1 * (3.0 - z16) - s2
        s3 = z12 * (x_dot * (2.0 * z + 0.3 * (s_z * z1)) - (z14 + z15))
        z22 = s3 + z21
        s4 = 0.5 * z20 - (0.25 * (z17 * c_z) - 0.15 * (x_dot * z13))
        z23 = z * (1.5 - 0.5 * z16) + s4
        z24 = (0.5 * (z10 * z22) - (2.0 * y_2 + z12 * z18) - z6 * z23) / z11
        dydt: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z12,
            # x'' (I.4.9) 7:4
            -(z9 * z22 + 0.5 * (z10 * z24)),
            # y'' (I.4.9) 7:4
            z24,
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
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        c_z = math.cos(z)
        qdot: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            x_dot * (y_2 * c_z) + 0.5 * (y_dot * (x * z)),
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
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular, if z5 is 0
        if not abs(z5) > 0.0:
            raise _refuse(abs(z5), 0.0, 2, "accelerations")
        s_z = math.sin(z)
        z6 = x * z
        z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6))
        z8 = z6 * z4
        z9 = 1.0 / z5
        z10 = z8 * z9
        z11 = z7 - 0.25 * (z8 * z10)
        # the mass matrix is singular, if z11 is nearly 0
        if not abs(z11) > 1e-13 * z7:
            raise _refuse(abs(z11), 1e-13 * z7, 2, "accelerations")
        z12 = y_dot * c_z
        z13 = x_dot * z1 + 0.5 * (y_dot * z6)
        z14 = s_z * z13
        z15 = x_dot * (z12 - y_2 * z14)
        z16 = y_dot * (z * x_dot + x * z13)
        z17 = z15 + 0.5 * z16
        z18 = x_dot * z13
        z19 = z3 * z17 - (0.3 * (x_dot * z14) - 2.0 * (x * z18))
        z20 = z * z1
        z21 = x_dot * x_dot
        z22 = y_dot * y_dot
        z23 = s_z * z18
        s1 = 0.5 * (2.0 * (z21 * z20) + z22 * z2 + 2.0 * (x * (z13 * z13)))
        z24 = s1 - 0.3 * (z1 * z23)
        s2 = 0.3 * (c_z * z17) - (0.3 * (z13 * z14) - 2.0 * (z * z18))
        z25 = s2 + z1 * z19 + (0.5 * (2.0 * x + 6.0 * z20) - z24)
        z26 = z * z6
        s3 = 0.5 * (z21 * z26 + 0.5 * (c_z * (z22 * z6)))
        z27 = 0.5 * (4.0 * y_2 + 3.0 * z26) - (s3 - 0.15 * (z6 * z23))
        z28 = (z13 * z12 + 0.5 * (z6 * z19) + z27 - 0.5 * (z10 * z25)) / z11
        z29 = z9 * z25 - 0.5 * (z10 * z28)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z29,
            # y'' (I.4.9)
            -z28,
            # z'' (I.4.9)
            z15 - z1 * z29 + 0.5 * (z16 - z6 * z28),
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
    x = float(q[0])
    y = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])  # x'
    y_dot = float(qdot[1])  # y'
    z_dot = float(qdot[2])  # z'
    try:
        # from the coordinates and velocities
        c_z = math.cos(z)
        r: list[float] = [
            # contact = 0 (I.1.1) 10:5
            z_dot - (x_dot * (y * c_z) + 0.5 * (y_dot * (x * z))),
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
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular, if z5 is 0
        if not abs(z5) > 0.0:
            raise _refuse(abs(z5), 0.0, 2, "reactions")
        s_z = math.sin(z)
        z6 = x * z
        z7 = z3 * z6
        z8 = 2.0 + s_z + 0.25 * (z6 * z7)
        z9 = z6 * z4
        z10 = 1.0 / z5
        z11 = z9 * z10
        z12 = z8 - 0.25 * (z9 * z11)
        # the mass matrix is singular, if z12 is nearly 0
        if not abs(z12) > 1e-13 * z8:
            raise _refuse(abs(z12), 1e-13 * z8, 2, "reactions")
        z13 = y_dot * c_z
        z14 = x_dot * z1 + 0.5 * (y_dot * z6)
        z15 = s_z * z14
        s1 = 0.5 * (y_dot * (z * x_dot + x * z14))
        z16 = x_dot * (z13 - y_2 * z15) + s1
        z17 = x_dot * z14
        z18 = 0.3 * (x_dot * z15)
        z19 = z3 * z16 - (z18 - 2.0 * (x * z17))
        z20 = z * z1
        z21 = x_dot * x_dot
        z22 = y_dot * y_dot
        z23 = s_z * z17
        s2 = 0.5 * (2.0 * (z21 * z20) + z22 * z2 + 2.0 * (x * (z14 * z14)))
        z24 = s2 - 0.3 * (z1 * z23)
        s3 = 0.3 * (c_z * z16) - (0.3 * (z14 * z15) - 2.0 * (z * z17))
        z25 = s3 + z1 * z19 + (0.5 * (2.0 * x + 6.0 * z20) - z24)
        z26 = z * z6
        z27 = z22 * c_z
        s4 = 0.15 * (z6 * z23) - 0.5 * (z21 * z26 + 0.5 * (z6 * z27))
        z28 = 0.5 * (4.0 * y_2 + 3.0 * z26) + s4
        s5 = 0.5 * (z11 * z25) - (z14 * z13 + 0.5 * (z6 * z19) + z28)
        z29 = s5 / z12
        s6 = z4 * (z10 * z25 + 0.5 * (z11 * z29)) - 0.5 * (z7 * z29)
        z30 = s6 - (z19 + (3.0 * z - (0.5 * (2.0 * (z * z21) + z27) - z18)))
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 10:5
            -z30,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V.

    Arguments: t (scalar), y (5,), p (0,).
    Returns a scalar.
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        z1 = z * z
        z2 = x * x
        s_z = math.sin(z)
        c_z = math.cos(z)
        z3 = x_dot * c_z
        z4 = 0.5 * (y_dot * (x * z)) + y_2 * z3
        s1 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z5 = s1 + (1.0 + z2) * (z4 * z4)
        s2 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        z6 = s2 + (0.5 * z5 + 0.3 * (z3 * z4))
        value1 = z6
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
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    x_dot = float(y[3])  # x'
    y_dot = float(y[4])  # y'
    try:
        # from the state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular, if z5 is 0
        if not abs(z5) > 0.0:
            raise _refuse(abs(z5), 0.0, 2, "jacobian")
        s_z = math.sin(z)
        z6 = x * z
        z7 = z3 * z6
        z8 = 2.0 + s_z + 0.25 * (z6 * z7)
        z9 = z6 * z4
        z10 = 1.0 / z5
        z11 = z9 * z10
        z12 = z8 - 0.25 * (z9 * z11)
        # the mass matrix is singular, if z12 is nearly 0
        if not abs(z12) > 1e-13 * z8:
            raise _refuse(abs(z12), 1e-13 * z8, 2, "jacobian")
        z13 = x_dot * s_z
        z14 = y_dot * c_z
        z15 = x_dot * z1
        z16 = z15 + 0.5 * (y_dot * z6)
        z17 = s_z * z16
        z18 = z14 - y_2 * z17
        z19 = z * x_dot
        z20 = x * z16
        z21 = z19 + z20
        z22 = x_dot * z18 + 0.5 * (y_dot * z21)
        z23 = z * z16
        z24 = x_dot * z17
        z25 = 0.3 * z24
        z26 = x * x_dot
        z27 = z25 - 2.0 * (z16 * z26) - z3 * z22
        z28 = z * z1
        z29 = x_dot * x_dot
        z30 = y_dot * y_dot
        z31 = z16 * z16
        z32 = z1 * z13
        s1 = 0.5 * (2.0 * (z29 * z28) + z30 * z2 + 2.0 * (x * z31))
        z33 = s1 - 0.3 * (z16 * z32)
        s2 = 0.3 * (z16 * z17) - 2.0 * (x_dot * z23) - 0.3 * (c_z * z22)
        z34 = s2 + z1 * z27 - (0.5 * (2.0 * x + 6.0 * z28) - z33)
        z35 = 1.0 / z12
        z36 = c_z * z16
        z37 = z * z6
        z38 = c_z * z6
        z39 = z6 * z13
        s3 = 0.5 * (z29 * z37 + 0.5 * (z30 * z38)) - 0.15 * (z16 * z39)
        z40 = 0.5 * (4.0 * y_2 + 3.0 * z37) - s3
        s4 = y_dot * z36 - 0.5 * (z6 * z27) + z40 + 0.5 * (z11 * z34)
        z41 = z35 * s4
        z42 = z10 * z34 + 0.5 * (z11 * z41)
        z43 = z6 * z41
        z44 = z1 * z42 - 0.5 * z43
        z45 = y_dot * z4
        z46 = x_dot * z16
        z47 = z1 * z46
        z48 = x_dot * z4
        z49 = 0.3 * (z15 + z16) + y_2 * z48
        s5 = 0.3 * z17 - (2.0 * (z1 * z26) - (2.0 * z20 - 0.3 * z32))
        z50 = 0.5 * (x * z45) + (2.0 * z19 - s5)
        z51 = s_z * z49 - z50
        z52 = y_dot * z51 + z4 * z41
        s6 = 0.5 * (z16 * z45) + (1.0 - (z31 - 2.0 * z47))
        z53 = 2.0 * ((z22 + z44) * (x * z1)) + (s6 - 0.5 * (z * z52))
        z54 = z6 * z42
        z55 = z6 * z46
        z56 = y_dot * z7
        z57 = x_dot * z7
        z58 = 0.15 * (x_dot * z6) + 0.5 * (y_2 * z57)
        s7 = s_z * z58 - (0.25 * (x * z56) + (z6 * z26 + 0.15 * z39))
        z59 = z14 - s7
        z60 = z4 * z42
        z61 = 0.25 * (z7 * z41)
        z62 = 1.5 - 0.5 * z29
        s8 = z61 + (0.5 * z27 - (0.15 * z24 + z * z62) + z61)
        z63 = 0.5 * z60 - (0.25 * (z30 * c_z) + s8)
        z64 = 0.5 * (y_dot * z59) + z63
        s9 = 0.5 * (z6 * z22) - (0.25 * (z6 * z43) - 0.5 * (z1 * z54))
        z65 = 2.0 * (x * s9) + (z55 + 0.25 * (z16 * z56) + z * z64)
        z66 = z35 * (z65 - 0.5 * (z11 * z53))
        z67 = 0.5 * z30 - 0.3 * z42
        z68 = 3.0 - z29
        s10 = c_z * z67 - (z3 * z44 - (z27 - (z25 + z * z68) - z60))
        z69 = x_dot * z51 + s10
        z70 = z17 * z48 + c_z * z69
        z71 = x_dot * z59 + 0.5 * (z3 * z54)
        s11 = 2.0 - 0.5 * (z17 * z57) + c_z * z71 + 0.5 * (z11 * z70)
        z72 = z35 * s11
        z73 = x_dot * z45
        s12 = s_z * (0.3 * z44 + (z73 + (0.3 * z22 - z1 * z67) - y_2 * z69))
        z74 = 2.0 * z46 + z1 * z68 + 0.5 * z73 - 0.5 * (x * z52) - s12
        z75 = 2.0 * (z * z42) + (c_z * (0.3 * z47 - z16 * z49) + z74)
        z76 = x_dot * z56
        s13 = y_dot * z16 - (0.25 * (z30 * z6) - 0.5 * z76) + y_2 * z71
        z77 = s_z * (0.15 * z54 + s13)
        s14 = z6 * z62 + 0.25 * z76 + x * z64 - z77
        z78 = c_z * (0.15 * z55 - z16 * z58 - z41) + s14
        z79 = z35 * (z78 - 0.5 * (z11 * z75))
        s15 = z18 * z4 + (0.5 * (z * z45) + 2.0 * (z23 + z1 * z20))
        z80 = 2.0 * (x_dot * z28) + (z1 * z51 - s15)
        s16 = z1 * z59 + (0.5 * (z18 * z7) + (0.25 * (z * z56) + z6 * z20))
        z81 = x_dot * z37 - s16
        z82 = z35 * (z81 - 0.5 * (z11 * z80))
        z83 = y_dot * z2 - (0.5 * (z21 * z4) + c_z * z48 - 0.5 * (z6 * z51))
        s17 = z36 + 0.25 * (z21 * z7) + 0.5 * (c_z * z57)
        z84 = 0.5 * (y_dot * z38) - (s17 + 0.5 * (z6 * z59))
        z85 = z35 * (z84 - 0.5 * (z11 * z83))
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
            0.5 * (z * y_dot),
            # (I.4.9)
            x_dot * c_z,
            # (I.4.9)
            0.5 * (x * y_dot) - y_2 * z13,
            # (I.4.9)
            z1,
            # (I.4.9)
            0.5 * z6,
            # (I.4.9)
            0.5 * (z11 * z66) - z10 * z53,
            # (I.4.9)
            z10 * z70 + 0.5 * (z11 * z72),
            # (I.4.9)
            0.5 * (z11 * z79) - z10 * z75,
            # (I.4.9)
            z10 * z80 - 0.5 * (z11 * z82),
            # (I.4.9)
            z10 * z83 - 0.5 * (z11 * z85),
            # (I.4.9)
            -z66,
            # (I.4.9)
            -z72,
            # (I.4.9)
            -z79,
            # (I.4.9)
            z82,
            # (I.4.9)
            z85,
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
