"""voronec_particle, emitted by nhc 0.1.0 (nhc:1148c58447420d1f).

A particle whose T, U and constraint depend on the dependent coordinate, so that
    Caplygin's hypotheses fail.
Source: voronec_particle.yaml
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
rhs: 32 +-, 79 *, 2 /, 2 calls
velocities: 1 +-, 5 *, 0 /, 1 calls
accelerations: 35 +-, 82 *, 2 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 2 +-, 5 *, 0 /, 1 calls
reactions: 38 +-, 90 *, 2 /, 2 calls
energy: 10 +-, 21 *, 0 /, 2 calls
jacobian: 132 +-, 267 *, 2 /, 2 calls
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
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 1.0 + z * z + 0.3 * z2 + z1 * (0.3 * c_z + z3 * z1)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "rhs")
        s_z = math.sin(z)
        z5 = x * z
        z6 = z3 * z5
        z7 = 2.0 + s_z + 0.25 * (z5 * z6)
        z8 = c_z * z5
        z9 = 0.15 * z8 + 0.5 * (z1 * z6)
        z10 = 1.0 / z4
        z11 = z9 * z10
        z12 = z7 - z9 * z11
        # the mass matrix is singular
        if not abs(z12) > 1e-14 * z7:
            raise SingularModelError(2, "rhs")
        z13 = x_dot * z1 + 0.5 * (y_dot * z5)
        z14 = s_z * z13
        s1 = 0.5 * (y_dot * (z * x_dot + x * z13))
        z15 = x_dot * (y_dot * c_z - y_2 * z14) + s1
        z16 = 0.3 * (x_dot * z14) - 2.0 * (z13 * (x * x_dot)) - z3 * z15
        s2 = 0.3 * (z13 * z14) - 2.0 * (x_dot * (z * z13))
        z17 = s2 - 0.3 * (c_z * z15) + z1 * z16
        z18 = x_dot * x_dot
        z19 = z * z1
        z20 = y_dot * y_dot
        s3 = 0.5 * (2.0 * (z18 * z19) + z20 * z2 + 2.0 * (x * (z13 * z13)))
        z21 = s3 - 0.3 * (z13 * (x_dot * (s_z * z1)))
        z22 = z17 + (z21 - 0.5 * (2.0 * x + 6.0 * z19))
        z23 = z * z5
        s4 = 0.5 * (z18 * z23 + 0.5 * (z20 * z8))
        s5 = s4 - 0.15 * (z13 * (x_dot * (s_z * z5)))
        z24 = s5 - 0.5 * (4.0 * y_2 + 3.0 * z23)
        s6 = y_dot * (c_z * z13) - 0.5 * (z5 * z16) - z24 + z22 * z11
        z25 = s6 / z12
        dydt: list[float] = [
            # x' (I.4.9)
            x_dot,
            # y' (I.4.9)
            y_dot,
            # z' (I.4.9)
            z13,
            # x'' (I.4.9) 7:4
            z22 * z10 + z11 * z25,
            # y'' (I.4.9) 7:4
            -z25,
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
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        c_z = math.cos(z)
        qdot: list[float] = [
            # x' (I.2.4)
            x_dot,
            # y' (I.2.4)
            y_dot,
            # z' (I.2.4)
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
    """all accelerations q'' on the motion (I.4.9)

    Arguments: t (scalar), y (5,), p (0,).
    Returns qddot (3,).
    """
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 1.0 + z * z + 0.3 * z2 + z1 * (0.3 * c_z + z3 * z1)
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_z = math.sin(z)
        z5 = x * z
        z6 = z3 * z5
        z7 = 2.0 + s_z + 0.25 * (z5 * z6)
        z8 = c_z * z5
        z9 = 0.15 * z8 + 0.5 * (z1 * z6)
        z10 = 1.0 / z4
        z11 = z9 * z10
        z12 = z7 - z9 * z11
        # the mass matrix is singular
        if not abs(z12) > 1e-14 * z7:
            raise SingularModelError(2, "accelerations")
        z13 = x_dot * z1 + 0.5 * (y_dot * z5)
        z14 = s_z * z13
        z15 = x_dot * (y_dot * c_z - y_2 * z14)
        z16 = y_dot * (z * x_dot + x * z13)
        z17 = z15 + 0.5 * z16
        z18 = 0.3 * (x_dot * z14) - 2.0 * (z13 * (x * x_dot)) - z3 * z17
        s1 = 0.3 * (z13 * z14) - 2.0 * (x_dot * (z * z13))
        z19 = s1 - 0.3 * (c_z * z17) + z1 * z18
        z20 = x_dot * x_dot
        z21 = z * z1
        z22 = y_dot * y_dot
        s2 = 0.5 * (2.0 * (z20 * z21) + z22 * z2 + 2.0 * (x * (z13 * z13)))
        z23 = s2 - 0.3 * (z13 * (x_dot * (s_z * z1)))
        z24 = z19 + (z23 - 0.5 * (2.0 * x + 6.0 * z21))
        z25 = z * z5
        s3 = 0.5 * (z20 * z25 + 0.5 * (z22 * z8))
        s4 = s3 - 0.15 * (z13 * (x_dot * (s_z * z5)))
        z26 = s4 - 0.5 * (4.0 * y_2 + 3.0 * z25)
        s5 = y_dot * (c_z * z13) - 0.5 * (z5 * z18) - z26 + z24 * z11
        z27 = s5 / z12
        z28 = z24 * z10 + z11 * z27
        qddot: list[float] = [
            # x'' (I.4.9)
            z28,
            # y'' (I.4.9)
            -z27,
            # z'' (I.4.9)
            z15 + z1 * z28 + 0.5 * (z16 - z5 * z27),
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
    x = float(q[0])
    y = float(q[1])
    z = float(q[2])
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    z_dot = float(qdot[2])
    try:
        # state
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
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (5,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular
        if not abs(z5) > 0.0:
            raise SingularModelError(2, "reactions")
        s_z = math.sin(z)
        z6 = x * z
        z7 = z3 * z6
        z8 = 2.0 + s_z + 0.25 * (z6 * z7)
        z9 = c_z * z6
        z10 = 0.15 * z9 + 0.5 * (z1 * z7)
        z11 = 1.0 / z5
        z12 = z10 * z11
        z13 = z8 - z10 * z12
        # the mass matrix is singular
        if not abs(z13) > 1e-14 * z8:
            raise SingularModelError(2, "reactions")
        z14 = x_dot * z1 + 0.5 * (y_dot * z6)
        z15 = s_z * z14
        s1 = 0.5 * (y_dot * (z * x_dot + x * z14))
        z16 = x_dot * (y_dot * c_z - y_2 * z15) + s1
        z17 = 0.3 * (x_dot * z15) - 2.0 * (z14 * (x * x_dot)) - z3 * z16
        z18 = x_dot * x_dot
        z19 = y_dot * y_dot
        s2 = 0.5 * (2.0 * (z * z18) + z19 * c_z)
        z20 = 3.0 * z - (s2 - 0.3 * (z14 * (x_dot * s_z)))
        s3 = 0.3 * (z14 * z15) - 2.0 * (x_dot * (z * z14))
        z21 = s3 - 0.3 * (c_z * z16) + z1 * z17
        z22 = z * z1
        s4 = 0.5 * (2.0 * (z18 * z22) + z19 * z2 + 2.0 * (x * (z14 * z14)))
        z23 = s4 - 0.3 * (z14 * (x_dot * (s_z * z1)))
        z24 = z21 + (z23 - 0.5 * (2.0 * x + 6.0 * z22))
        z25 = z * z6
        s5 = 0.5 * (z18 * z25 + 0.5 * (z19 * z9))
        s6 = s5 - 0.15 * (z14 * (x_dot * (s_z * z6)))
        z26 = s6 - 0.5 * (4.0 * y_2 + 3.0 * z25)
        s7 = y_dot * (c_z * z14) - 0.5 * (z6 * z17) - z26 + z24 * z12
        z27 = s7 / z13
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 10:5
            z4 * (z24 * z11 + z12 * z27) - 0.5 * (z7 * z27) - (z17 - z20),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (5,), p (0,).
    Returns a scalar.
    """
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        z1 = z * z
        z2 = x * x
        s_z = math.sin(z)
        c_z = math.cos(z)
        z3 = x_dot * (y_2 * c_z) + 0.5 * (y_dot * (x * z))
        s1 = (1.0 + z1) * (x_dot * x_dot) + (2.0 + s_z) * (y_dot * y_dot)
        z4 = s1 + (1.0 + z2) * (z3 * z3)
        s2 = 0.5 * (3.0 * z1 + (z2 + 2.0 * (y_2 * y_2)))
        z5 = s2 + (0.5 * z4 + 0.3 * (x_dot * c_z * z3))
        value1 = z5
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
    x = float(y[0])
    y_2 = float(y[1])
    z = float(y[2])
    x_dot = float(y[3])
    y_dot = float(y[4])
    try:
        # state
        c_z = math.cos(z)
        z1 = y_2 * c_z
        z2 = c_z * z1
        z3 = 1.0 + x * x
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular
        if not abs(z5) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_z = math.sin(z)
        z6 = x * z
        z7 = z3 * z6
        z8 = 2.0 + s_z + 0.25 * (z6 * z7)
        z9 = c_z * z6
        z10 = 0.15 * z9 + 0.5 * (z1 * z7)
        z11 = 1.0 / z5
        z12 = z10 * z11
        z13 = z8 - z10 * z12
        # the mass matrix is singular
        if not abs(z13) > 1e-14 * z8:
            raise SingularModelError(2, "jacobian")
        z14 = x_dot * z1
        z15 = z14 + 0.5 * (y_dot * z6)
        z16 = z15 * z15
        z17 = z1 * z15
        z18 = y_dot * z4
        z19 = z * x_dot
        z20 = s_z * z15
        z21 = x * z15
        z22 = s_z * z1
        z23 = x_dot * z22
        z24 = x * x_dot
        s1 = 0.3 * z20 + (2.0 * z21 - 0.3 * z23 - 2.0 * (z1 * z24))
        z25 = 2.0 * z19 - s1 + 0.5 * (x * z18)
        z26 = x_dot * z4
        z27 = 0.3 * z14 + 0.3 * z15 + y_2 * z26
        z28 = z25 - s_z * z27
        z29 = 1.0 / z13
        z30 = c_z * z15
        z31 = y_dot * c_z
        z32 = z31 - y_2 * z20
        z33 = z19 + z21
        z34 = x_dot * z32 + 0.5 * (y_dot * z33)
        z35 = 0.3 * (x_dot * z20) - 2.0 * (z15 * z24) - z3 * z34
        z36 = x_dot * x_dot
        z37 = z * z6
        z38 = y_dot * y_dot
        z39 = s_z * z6
        z40 = x_dot * z39
        s2 = 0.5 * (z36 * z37 + 0.5 * (z38 * z9)) - 0.15 * (z15 * z40)
        z41 = s2 - 0.5 * (4.0 * y_2 + 3.0 * z37)
        z42 = z * z15
        z43 = z * z1
        s3 = 0.5 * (2.0 * (z36 * z43) + z38 * z2 + 2.0 * (x * z16))
        z44 = s3 - 0.3 * (z15 * z23)
        s4 = 0.3 * (z15 * z20) - 2.0 * (x_dot * z42) - 0.3 * (c_z * z34)
        z45 = s4 + z1 * z35 + (z44 - 0.5 * (2.0 * x + 6.0 * z43))
        z46 = z29 * (y_dot * z30 - 0.5 * (z6 * z35) - z41 + z45 * z12)
        z47 = z1 * z46
        z48 = 0.5 * (y_dot * z28) - (0.5 * (z3 * z47) + 0.15 * (c_z * z46))
        z49 = z45 * z11 + z12 * z46
        z50 = z1 * z49
        s5 = 1.0 - (z16 - 2.0 * (x_dot * z17)) + 0.5 * (z15 * z18)
        s6 = 2.0 * (x * (z1 * z34 - (0.5 * (z6 * z47) - z1 * z50)))
        z51 = s5 + z * z48 + s6
        z52 = z6 * z15
        z53 = y_dot * z7
        z54 = x_dot * z7
        z55 = 0.15 * (x_dot * z6) + 0.5 * (y_2 * z54)
        z56 = z31 + (0.15 * z40 + z6 * z24 + 0.25 * (x * z53) - s_z * z55)
        z57 = z7 * z46
        z58 = x_dot * z15
        z59 = s_z * z58
        z60 = 1.5 - 0.5 * z36
        z61 = z6 * z46
        z62 = 0.5 * z50 - 0.25 * z61
        z63 = 0.25 * z38 - 0.15 * z49
        s7 = 0.25 * z57 + (0.5 * z35 - (0.15 * z59 + z * z60)) - z3 * z62
        z64 = s7 + c_z * z63
        z65 = 0.5 * (y_dot * z56) - z64
        s8 = x_dot * z52 + 0.25 * (z15 * z53) + z * z65
        z66 = s8 + 2.0 * (x * (0.5 * (z6 * z34) + z6 * z62))
        z67 = z29 * (z66 - z12 * z51)
        z68 = 3.0 - z36
        z69 = 0.5 * z38 - 0.3 * z49
        s9 = z4 * z49 - (0.5 * z57 + (z35 - (0.3 * z59 + z * z68)))
        z70 = s9 + z3 * z50 - c_z * z69
        z71 = x_dot * z28 + z70
        z72 = z20 * z26 - c_z * z71
        z73 = x_dot * z56 + 0.5 * (z7 * z49)
        z74 = z29 * (2.0 - 0.5 * (z20 * z54) + c_z * z73 + z12 * z72)
        s10 = y_dot * z26 + (0.3 * z34 - (0.15 * z61 + z1 * z69))
        z75 = 0.3 * z50 + (s10 + y_2 * z71)
        s11 = 2.0 * z58 + z1 * z68 + 0.5 * (x_dot * z18) + x * z48
        z76 = c_z * (0.3 * (z1 * z58) - z15 * z27) + (s11 - s_z * z75)
        z77 = z76 + 2.0 * (z * z49)
        s12 = y_dot * z15 + (0.5 * (y_dot * z54) - z6 * z63) + y_2 * z73
        z78 = z6 * z60 + 0.25 * (x_dot * z53) + x * z65 - s_z * s12
        s13 = z78 - c_z * (z46 - (0.15 * (z6 * z58) - z15 * z55))
        z79 = z29 * (s13 - z12 * z77)
        s14 = 2.0 * z42 + 0.3 * (z15 * z22) - 0.3 * (z1 * z20)
        z80 = s14 + 2.0 * (x * z17) + 0.5 * (z * z18)
        z81 = z80 + z32 * z4 + z1 * z28 - 2.0 * (x_dot * z43)
        s15 = 0.15 * (z15 * z39) - 0.15 * (z6 * z20) + x * z52
        z82 = s15 + 0.25 * (z * z53) + 0.5 * (z32 * z7)
        z83 = z29 * (z82 + z1 * z56 - x_dot * z37 - z12 * z81)
        z84 = 0.5 * (z33 * z4) + c_z * z26 + 0.5 * (z6 * z28) - y_dot * z2
        s16 = z30 + 0.25 * (z33 * z7) + 0.5 * (c_z * z54)
        z85 = s16 + 0.5 * (z6 * z56) - 0.5 * (y_dot * z9)
        z86 = z29 * (z85 - z12 * z84)
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
            0.5 * (z * y_dot),
            # (I.4.9)
            x_dot * c_z,
            # (I.4.9)
            0.5 * (x * y_dot) - s_z * (y_2 * x_dot),
            # (I.4.9)
            z1,
            # (I.4.9)
            0.5 * z6,
            # (I.4.9)
            z12 * z67 - z11 * z51,
            # (I.4.9)
            z11 * z72 + z12 * z74,
            # (I.4.9)
            z12 * z79 - z11 * z77,
            # (I.4.9)
            z12 * z83 - z11 * z81,
            # (I.4.9)
            z12 * z86 - z11 * z84,
            # (I.4.9)
            -z67,
            # (I.4.9)
            -z74,
            # (I.4.9)
            -z79,
            # (I.4.9)
            -z83,
            # (I.4.9)
            -z86,
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
