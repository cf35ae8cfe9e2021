"""voronec_particle, emitted by nhc 0.1.0 (nhc:91638d0170f6b897).

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
rhs: 31 +-, 61 *, 2 /, 2 calls
velocities: 1 +-, 5 *, 0 /, 1 calls
accelerations: 34 +-, 64 *, 2 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 2 +-, 5 *, 0 /, 1 calls
reactions: 37 +-, 69 *, 2 /, 2 calls
energy: 10 +-, 20 *, 0 /, 2 calls
jacobian: 127 +-, 253 *, 2 /, 2 calls
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
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular
        if not abs(z5) > 0.0:
            raise SingularModelError(2, "rhs")
        s_z = math.sin(z)
        z6 = x * z
        z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6))
        z8 = z6 * z4
        z9 = 1.0 / z5
        z10 = z8 * z9
        z11 = z7 - 0.25 * (z8 * z10)
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z7:
            raise SingularModelError(2, "rhs")
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
        s4 = 0.5 * (z10 * z22) - (2.0 * y_2 + z12 * z18)
        z23 = z * z6 * (1.5 - 0.5 * z16) - s4
        s5 = z6 * (0.5 * z20 - (0.25 * (z17 * c_z) - 0.15 * (x_dot * z13)))
        z24 = (z23 + s5) / z11
        dydt: list[float] = [
            # x' (I.4.9)
            x_dot,
            # y' (I.4.9)
            y_dot,
            # z' (I.4.9)
            z12,
            # x'' (I.4.9) 7:4
            0.5 * (z10 * z24) - z9 * z22,
            # y'' (I.4.9) 7:4
            -z24,
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
        z4 = 0.3 * c_z + z3 * z1
        z5 = 1.0 + z * z + 0.3 * z2 + z1 * z4
        # the mass matrix is singular
        if not abs(z5) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_z = math.sin(z)
        z6 = x * z
        z7 = 2.0 + s_z + 0.25 * (z6 * (z3 * z6))
        z8 = z6 * z4
        z9 = 1.0 / z5
        z10 = z8 * z9
        z11 = z7 - 0.25 * (z8 * z10)
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z7:
            raise SingularModelError(2, "accelerations")
        z12 = x_dot * z1 + 0.5 * (y_dot * z6)
        z13 = s_z * z12
        z14 = 0.3 * z13
        z15 = x * z12
        z16 = x_dot * x_dot
        z17 = y_dot * y_dot
        z18 = y_dot * c_z
        z19 = x_dot * (z18 - y_2 * z13)
        z20 = y_dot * (z * x_dot + z15)
        z21 = z19 + 0.5 * z20
        z22 = z3 * z21 - x_dot * (z14 - 2.0 * z15)
        s1 = 0.5 * (z17 * z2) - (z1 * z22 + (x + 0.3 * (c_z * z21)))
        z23 = z * z1 * (3.0 - z16) - s1
        s2 = z12 * (x_dot * (2.0 * z + 0.3 * (s_z * z1)) - (z14 + z15))
        z24 = s2 + z23
        s3 = 0.5 * (z10 * z24) - (2.0 * y_2 + z12 * z18)
        z25 = z * z6 * (1.5 - 0.5 * z16) - s3
        s4 = z6 * (0.5 * z22 - (0.25 * (z17 * c_z) - 0.15 * (x_dot * z13)))
        z26 = (z25 + s4) / z11
        z27 = z9 * z24 - 0.5 * (z10 * z26)
        qddot: list[float] = [
            # x'' (I.4.9)
            -z27,
            # y'' (I.4.9)
            -z26,
            # z'' (I.4.9)
            z19 - z1 * z27 + 0.5 * (z20 - z6 * z26),
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
        z9 = z6 * z4
        z10 = 1.0 / z5
        z11 = z9 * z10
        z12 = z8 - 0.25 * (z9 * z11)
        # the mass matrix is singular
        if not abs(z12) > 1e-14 * z8:
            raise SingularModelError(2, "reactions")
        z13 = y_dot * c_z
        z14 = x_dot * z1 + 0.5 * (y_dot * z6)
        z15 = s_z * z14
        z16 = x * z14
        s1 = 0.5 * (y_dot * (z * x_dot + z16))
        z17 = x_dot * (z13 - y_2 * z15) + s1
        z18 = 0.3 * z15
        z19 = z3 * z17 - x_dot * (z18 - 2.0 * z16)
        z20 = x_dot * x_dot
        z21 = y_dot * y_dot
        z22 = z21 * c_z
        z23 = x_dot * z15
        s2 = 0.5 * (z21 * z2) - (z1 * z19 + (x + 0.3 * (c_z * z17)))
        z24 = z * z1 * (3.0 - z20) - s2
        s3 = z14 * (x_dot * (2.0 * z + 0.3 * (s_z * z1)) - (z18 + z16))
        z25 = s3 + z24
        s4 = 0.5 * (z11 * z25) - (2.0 * y_2 + z14 * z13)
        z26 = z * z6 * (1.5 - 0.5 * z20) - s4
        z27 = (z26 + z6 * (0.5 * z19 - (0.25 * z22 - 0.15 * z23))) / z12
        s5 = z19 + (3.0 * z - (0.5 * (2.0 * (z * z20) + z22) - 0.3 * z23))
        z28 = s5 - (z4 * (z10 * z25 - 0.5 * (z11 * z27)) + 0.5 * (z7 * z27))
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 10:5
            z28,
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
        z9 = z6 * z4
        z10 = 1.0 / z5
        z11 = z9 * z10
        z12 = z8 - 0.25 * (z9 * z11)
        # the mass matrix is singular
        if not abs(z12) > 1e-14 * z8:
            raise SingularModelError(2, "jacobian")
        z13 = x_dot * z1
        z14 = z13 + 0.5 * (y_dot * z6)
        z15 = z14 * z14
        z16 = z1 * z14
        z17 = y_dot * z4
        z18 = z * x_dot
        z19 = s_z * z14
        z20 = 0.3 * z19
        z21 = x * z14
        z22 = s_z * z1
        z23 = x_dot * z22
        z24 = x * x_dot
        s1 = 2.0 * z18 - (z20 + (2.0 * z21 - 0.3 * z23 - 2.0 * (z1 * z24)))
        z25 = s1 + 0.5 * (x * z17)
        z26 = x_dot * z4
        z27 = 0.3 * (z13 + z14) + y_2 * z26
        z28 = z25 - s_z * z27
        z29 = 1.0 / z12
        z30 = z * z6
        z31 = x_dot * x_dot
        z32 = 1.5 - 0.5 * z31
        z33 = y_dot * c_z
        z34 = z33 - y_2 * z19
        z35 = z18 + z21
        z36 = x_dot * z34 + 0.5 * (y_dot * z35)
        z37 = 0.3 * (x_dot * z19) - 2.0 * (z14 * z24) - z3 * z36
        z38 = y_dot * y_dot
        z39 = c_z * z6
        z40 = s_z * z6
        z41 = x_dot * z40
        z42 = z * z1
        z43 = 3.0 - z31
        z44 = z * z14
        s2 = 0.5 * (z38 * z2) - (2.0 * (x_dot * z44) + 0.3 * (c_z * z36))
        z45 = 0.3 * (z14 * (z19 - z23)) + (z1 * z37 + s2)
        z46 = x * (1.0 - z15) + (z42 * z43 - z45)
        z47 = c_z * z14
        s3 = 0.5 * (z11 * z46) - (2.0 * y_2 + y_dot * z47)
        z48 = 0.25 * (z38 * z39) - (0.15 * (z14 * z41) - s3)
        z49 = z29 * (z30 * z32 - (0.5 * (z6 * z37) + z48))
        z50 = y_dot * z28 - z4 * z49
        z51 = z10 * z46 - 0.5 * (z11 * z49)
        z52 = z6 * z49
        z53 = 0.5 * z52
        z54 = z1 * z51 + z53
        s4 = 1.0 - (z15 - 2.0 * (x_dot * z16)) + 0.5 * (z14 * z17)
        z55 = s4 + 0.5 * (z * z50) + 2.0 * ((z36 - z54) * (x * z1))
        z56 = z6 * z51
        z57 = y_dot * z7
        z58 = z6 * z14
        z59 = x_dot * z7
        z60 = 0.15 * (x_dot * z6) + 0.5 * (y_2 * z59)
        z61 = z33 + (0.15 * z41 + z6 * z24 + 0.25 * (x * z57) - s_z * z60)
        z62 = z4 * z51
        z63 = x_dot * z14
        z64 = s_z * z63
        s5 = 0.5 * z37 - (0.15 * z64 + z * z32) + 0.25 * (z7 * z49)
        z65 = s5 + 0.25 * (z3 * z52)
        z66 = 0.5 * (y_dot * z61) - (0.5 * z62 + (0.25 * (z38 * c_z) + z65))
        s6 = x_dot * z58 + z * z66 - 0.5 * (z11 * z55)
        z67 = x * (z1 * z56 - z6 * (z36 - z53)) - (0.25 * (z14 * z57) + s6)
        z68 = z29 * z67
        z69 = 0.5 * z38 + 0.3 * z51
        s7 = z37 - (0.3 * z64 + z * z43) + z62 + z3 * z54 + c_z * z69
        z70 = x_dot * z28 - s7
        z71 = z19 * z26 - c_z * z70
        z72 = x_dot * z61 - 0.5 * (z3 * z56)
        s8 = 2.0 - 0.5 * (z19 * z59) + c_z * z72 + 0.5 * (z11 * z71)
        z73 = z29 * s8
        s9 = 0.3 * z54 - (y_dot * z26 + (0.3 * z36 - z1 * z69) + y_2 * z70)
        s10 = 2.0 * z63 + z1 * z43 + 0.5 * (x_dot * z17) + 0.5 * (x * z50)
        z74 = s10 + s_z * s9
        z75 = c_z * (0.3 * (z1 * z63) - z14 * z27) + z74 - 2.0 * (z * z51)
        s11 = 0.15 * z56 + (0.25 * (z38 * z6) - y_2 * z72)
        z76 = s_z * (y_dot * (z14 + 0.5 * z59) - s11)
        s12 = 0.5 * (z11 * z75) - (0.25 * (x_dot * z57) + x * z66)
        z77 = c_z * (0.15 * (z6 * z63) - z14 * z60 - z49) + (z6 * z32 - s12)
        z78 = z29 * (z76 - z77)
        s13 = 2.0 * (x_dot * z42) - (2.0 * (x * z16) + 0.5 * (z * z17))
        z79 = 0.3 * (z14 * z22) + (z34 * z4 - s13)
        z80 = z1 * (z20 - z28) - (2.0 * z44 + z79)
        s14 = 0.15 * (z14 * z40 - z6 * z19) + x * z58 + 0.25 * (z * z57)
        z81 = s14 + 0.5 * (z34 * z7)
        z82 = z29 * (z81 + z1 * z61 - x_dot * z30 + 0.5 * (z11 * z80))
        z83 = 0.5 * (z35 * z4) + c_z * z26 + 0.5 * (z6 * z28) - y_dot * z2
        s15 = 0.5 * (z6 * z61 - (z11 * z83 - (c_z * z59 - y_dot * z39)))
        z84 = 0.25 * (z35 * z7) + s15
        z85 = z29 * (z47 + z84)
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
            0.5 * (x * y_dot) - s_z * (y_2 * x_dot),
            # (I.4.9)
            z1,
            # (I.4.9)
            0.5 * z6,
            # (I.4.9)
            -(z10 * z55 + 0.5 * (z11 * z68)),
            # (I.4.9)
            z10 * z71 + 0.5 * (z11 * z73),
            # (I.4.9)
            -(z10 * z75 + 0.5 * (z11 * z78)),
            # (I.4.9)
            z10 * z80 + 0.5 * (z11 * z82),
            # (I.4.9)
            0.5 * (z11 * z85) - z10 * z83,
            # (I.4.9)
            z68,
            # (I.4.9)
            -z73,
            # (I.4.9)
            z78,
            # (I.4.9)
            -z82,
            # (I.4.9)
            -z85,
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
