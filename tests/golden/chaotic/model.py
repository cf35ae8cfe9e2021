"""chaotic, emitted by nhc 0.1.0 (nhc:df341cbb6ff0cf06).

Seven coupled oscillators with one contact constraint; reversible and chaotic.
Source: chaotic.yaml
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): a force
    acts on the dependent coordinate `x`

State y:
y[0] = x
y[1] = y1
y[2] = y2
y[3] = y3
y[4] = z1
y[5] = z2
y[6] = z3
y[7] = y1'
y[8] = y2'
y[9] = y3'
y[10] = z1'
y[11] = z2'
y[12] = z3'

No parameters.

Constraints:
0: contact

Operations:
rhs: 33 +-, 41 *, 3 /, 0 calls
velocities: 2 +-, 3 *, 0 /, 0 calls
accelerations: 36 +-, 41 *, 3 /, 0 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 3 +-, 3 *, 0 /, 0 calls
reactions: 36 +-, 37 *, 3 /, 0 calls
energy: 19 +-, 23 *, 0 /, 0 calls
jacobian: 116 +-, 186 *, 3 /, 0 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y1", "y2", "y3", "z1", "z2", "z3")
STATE: tuple[str, ...] = (
    "x",
    "y1",
    "y2",
    "y3",
    "z1",
    "z2",
    "z3",
    "y1'",
    "y2'",
    "y3'",
    "z1'",
    "z2'",
    "z3'",
)
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
    """right-hand side dy/dt = f(t, y; p) (III.3)

    Arguments: t (scalar), y (13,), p (0,).
    Returns dydt (13,).
    """
    x = float(y[0])
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    z1 = float(y[4])
    z2 = float(y[5])
    z3 = float(y[6])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        z4 = 1.0 + y1 * y1
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "rhs")
        z5 = 1.0 + y2 * y2
        z6 = y1 * y2
        z7 = 1.0 / z4
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "rhs")
        z10 = 1.0 + y3 * y3
        z11 = y1 * y3
        z12 = z11 * z7
        z13 = y2 * y3 - z6 * z12
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z10 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z10:
            raise SingularModelError(2, "rhs")
        z17 = 1.0 + z1 * z1
        z18 = 1.0 + z2 * z2
        z19 = y3_dot * z3_dot
        z20 = y2_dot * z2_dot
        z21 = y1_dot * z1_dot
        z22 = y1 * (z19 + (z20 + (z21 - (x - y1 * z1)))) + z1 * z18
        s1 = y2 * (z19 + (z20 + (z21 - (x - y2 * z2)))) + z2 * z17
        z23 = s1 - z22 * z8
        s2 = z3 + y3 * (z19 + (z20 + (z21 - (x - y3 * z3)))) - z22 * z12
        z24 = s2 - z15 * z23
        z25 = z24 / z16
        z26 = z14 * z23 - z15 * z25
        dydt: list[float] = [
            # x' (III.3)
            -(y3 * z3_dot + (y1 * z1_dot + y2 * z2_dot)),
            # y1' (III.3)
            y1_dot,
            # y2' (III.3)
            y2_dot,
            # y3' (III.3)
            y3_dot,
            # z1' (III.3)
            z1_dot,
            # z2' (III.3)
            z2_dot,
            # z3' (III.3)
            z3_dot,
            # y1'' (III.3) 10:4
            -y1 * z17,
            # y2'' (III.3) 10:4
            -y2 * z18,
            # y3'' (III.3) 10:4
            -y3 * (1.0 + z3 * z3),
            # z1'' (III.3) 10:4
            z12 * z25 - (z22 * z7 - z8 * z26),
            # z2'' (III.3) 10:4
            -z26,
            # z3'' (III.3) 10:4
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

    Arguments: t (scalar), y (13,), p (0,).
    Returns qdot (7,).
    """
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        qdot: list[float] = [
            # x' (I.2.4)
            -(y3 * z3_dot + (y1 * z1_dot + y2 * z2_dot)),
            # y1' (I.2.4)
            y1_dot,
            # y2' (I.2.4)
            y2_dot,
            # y3' (I.2.4)
            y3_dot,
            # z1' (I.2.4)
            z1_dot,
            # z2' (I.2.4)
            z2_dot,
            # z3' (I.2.4)
            z3_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (III.3)

    Arguments: t (scalar), y (13,), p (0,).
    Returns qddot (7,).
    """
    x = float(y[0])
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    z1 = float(y[4])
    z2 = float(y[5])
    z3 = float(y[6])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        z4 = 1.0 + y1 * y1
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "accelerations")
        z5 = 1.0 + y2 * y2
        z6 = y1 * y2
        z7 = 1.0 / z4
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "accelerations")
        z10 = 1.0 + y3 * y3
        z11 = y1 * y3
        z12 = z11 * z7
        z13 = y2 * y3 - z6 * z12
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z10 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z10:
            raise SingularModelError(2, "accelerations")
        z17 = y3_dot * z3_dot
        z18 = y2_dot * z2_dot
        z19 = y1_dot * z1_dot
        z20 = 1.0 + z2 * z2
        z21 = y1 * (z17 + (z18 + (z19 - (x - y1 * z1)))) + z1 * z20
        z22 = 1.0 + z1 * z1
        s1 = y2 * (z17 + (z18 + (z19 - (x - y2 * z2)))) + z2 * z22
        z23 = s1 - z21 * z8
        s2 = z3 + y3 * (z17 + (z18 + (z19 - (x - y3 * z3)))) - z21 * z12
        z24 = s2 - z15 * z23
        z25 = z24 / z16
        z26 = z14 * z23 - z15 * z25
        z27 = z21 * z7 - z8 * z26 - z12 * z25
        qddot: list[float] = [
            # x'' (III.3)
            -(z17 - y3 * z25 + (z19 - y1 * z27 + (z18 - y2 * z26))),
            # y1'' (III.3)
            -y1 * z22,
            # y2'' (III.3)
            -y2 * z20,
            # y3'' (III.3)
            -y3 * (1.0 + z3 * z3),
            # z1'' (III.3)
            -z27,
            # z2'' (III.3)
            -z26,
            # z3'' (III.3)
            -z25,
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

    Arguments: t (scalar), q (7,), qdot (7,), p (0,).
    Returns y (13,).
    """
    x = float(q[0])
    y1 = float(q[1])
    y2 = float(q[2])
    y3 = float(q[3])
    z1 = float(q[4])
    z2 = float(q[5])
    z3 = float(q[6])
    y1_dot = float(qdot[1])
    y2_dot = float(qdot[2])
    y3_dot = float(qdot[3])
    z1_dot = float(qdot[4])
    z2_dot = float(qdot[5])
    z3_dot = float(qdot[6])
    try:
        # state
        y: list[float] = [
            x,
            y1,
            y2,
            y3,
            z1,
            z2,
            z3,
            y1_dot,
            y2_dot,
            y3_dot,
            z1_dot,
            z2_dot,
            z3_dot,
        ]
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

    Arguments: t (scalar), q (7,), qdot (7,), p (0,).
    Returns r (1,).
    """
    y1 = float(q[1])
    y2 = float(q[2])
    y3 = float(q[3])
    x_dot = float(qdot[0])
    z1_dot = float(qdot[4])
    z2_dot = float(qdot[5])
    z3_dot = float(qdot[6])
    try:
        # state
        r: list[float] = [
            # contact = 0 (I.1.1) 13:5
            x_dot + y1 * z1_dot + y2 * z2_dot + y3 * z3_dot,
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

    Arguments: t (scalar), y (13,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    x = float(y[0])
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    z1 = float(y[4])
    z2 = float(y[5])
    z3 = float(y[6])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        z4 = 1.0 + y1 * y1
        # the mass matrix is singular
        if not abs(z4) > 0.0:
            raise SingularModelError(2, "reactions")
        z5 = 1.0 + y2 * y2
        z6 = y1 * y2
        z7 = 1.0 / z4
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular
        if not abs(z9) > 1e-14 * z5:
            raise SingularModelError(2, "reactions")
        z10 = 1.0 + y3 * y3
        z11 = y1 * y3
        z12 = z11 * z7
        z13 = y2 * y3 - z6 * z12
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z10 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z10:
            raise SingularModelError(2, "reactions")
        z17 = y3_dot * z3_dot
        z18 = y1_dot * z1_dot
        z19 = y2_dot * z2_dot
        s1 = y1 * (z17 + (z19 + (z18 - (x - y1 * z1))))
        z20 = s1 + z1 * (1.0 + z2 * z2)
        s2 = y2 * (z17 + (z19 + (z18 - (x - y2 * z2))))
        z21 = s2 + z2 * (1.0 + z1 * z1) - z20 * z8
        s3 = z3 + y3 * (z17 + (z19 + (z18 - (x - y3 * z3)))) - z20 * z12
        z22 = s3 - z15 * z21
        z23 = z22 / z16
        z24 = z14 * z21 - z15 * z23
        s4 = y3 * z23 + (y1 * (z20 * z7 - z8 * z24 - z12 * z23) + y2 * z24)
        z25 = x - (z17 + (z18 + z19)) + s4
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 13:5
            z25,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (13,), p (0,).
    Returns a scalar.
    """
    x = float(y[0])
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    z1 = float(y[4])
    z2 = float(y[5])
    z3 = float(y[6])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        z4 = y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z1 * z1
        z8 = z2 * z2
        z9 = z3 * z3
        s1 = z4 * z7 + z5 * z8 + z6 * z9 + z7 * z8
        z10 = x * x + z4 + z5 + z6 + z7 + z8 + z9 + s1
        z11 = y3 * z3_dot + (y1 * z1_dot + y2 * z2_dot)
        s2 = y2_dot * y2_dot + (y1_dot * y1_dot + z11 * z11)
        z12 = z2_dot * z2_dot + (z1_dot * z1_dot + (y3_dot * y3_dot + s2))
        value1 = 0.5 * z10 + 0.5 * (z3_dot * z3_dot + z12)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (III.3)

    Arguments: t (scalar), y (13,), p (0,).
    Returns rows (13, 13): d rhs_i / d y_j stands at [i][j].
    """
    x = float(y[0])
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    z1 = float(y[4])
    z2 = float(y[5])
    z3 = float(y[6])
    y1_dot = float(y[7])
    y2_dot = float(y[8])
    y3_dot = float(y[9])
    z1_dot = float(y[10])
    z2_dot = float(y[11])
    z3_dot = float(y[12])
    try:
        # state
        z4 = y1 * y1
        z5 = 1.0 + z4
        # the mass matrix is singular
        if not abs(z5) > 0.0:
            raise SingularModelError(2, "jacobian")
        z6 = y2 * y2
        z7 = 1.0 + z6
        z8 = y1 * y2
        z9 = 1.0 / z5
        z10 = z8 * z9
        z11 = z7 - z8 * z10
        # the mass matrix is singular
        if not abs(z11) > 1e-14 * z7:
            raise SingularModelError(2, "jacobian")
        z12 = 1.0 + y3 * y3
        z13 = y1 * y3
        z14 = z13 * z9
        z15 = y2 * y3 - z8 * z14
        z16 = 1.0 / z11
        z17 = z15 * z16
        z18 = z12 - z13 * z14 - z15 * z17
        # the mass matrix is singular
        if not abs(z18) > 1e-14 * z12:
            raise SingularModelError(2, "jacobian")
        z19 = 1.0 + z1 * z1
        z20 = y1 * z1
        z21 = 1.0 + z2 * z2
        z22 = y2 * z2
        z23 = y3 * z3
        z24 = y2 - y1 * z10
        z25 = 1.0 / z18
        z26 = z25 * (y3 - y1 * z14 - z17 * z24)
        z27 = z16 * z24 - z17 * z26
        z28 = y3_dot * z3_dot
        z29 = y2_dot * z2_dot
        z30 = y1_dot * z1_dot
        z31 = z28 + (z29 + (z30 - (x - z20)))
        z32 = y1 * z31 + z1 * z21
        z33 = z28 + (z29 + (z30 - (x - z22)))
        z34 = y2 * z33 + z2 * z19 - z32 * z10
        z35 = z28 + (z29 + (z30 - (x - z23)))
        z36 = z25 * (z3 + y3 * z35 - z32 * z14 - z17 * z34)
        z37 = z16 * z34 - z17 * z36
        z38 = z32 * z9 - z10 * z37 - z14 * z36
        z39 = y1 * z38
        z40 = y2 * z37
        z41 = y3 * z36
        z42 = 2.0 * z39 + (z40 + (z41 - (z20 + z31)))
        z43 = y2 * z38 - z10 * z42
        z44 = z25 * (y3 * z38 - z14 * z42 - z17 * z43)
        z45 = z16 * z43 - z17 * z44
        z46 = y1 * z37
        z47 = 2.0 * z40 + (z39 + (z41 - (z22 + z33))) - z10 * z46
        z48 = z25 * (y3 * z37 - z14 * z46 - z17 * z47)
        z49 = z16 * z47 - z17 * z48
        z50 = y1 * z36
        z51 = y2 * z36 - z10 * z50
        s1 = 2.0 * z41 + (z39 + (z40 - (z23 + z35))) - z14 * z50
        z52 = z25 * (s1 - z17 * z51)
        z53 = z16 * z51 - z17 * z52
        z54 = z4 + z21
        z55 = z1 * z2
        z56 = 2.0 * z55 - z10 * z54
        z57 = z25 * (z14 * z54 + z17 * z56)
        z58 = z16 * z56 + z17 * z57
        z59 = z6 + z19 - 2.0 * (z10 * z55)
        z60 = z25 * (2.0 * (z14 * z55) + z17 * z59)
        z61 = z16 * z59 + z17 * z60
        z62 = z12 * z25
        z63 = z17 * z62
        z64 = y1 * z1_dot
        z65 = y2 * z1_dot - z64 * z10
        z66 = z25 * (y3 * z1_dot - z64 * z14 - z17 * z65)
        z67 = z16 * z65 - z17 * z66
        z68 = y1 * z2_dot
        z69 = y2 * z2_dot - z10 * z68
        z70 = z25 * (y3 * z2_dot - z14 * z68 - z17 * z69)
        z71 = z16 * z69 - z17 * z70
        z72 = y1 * z3_dot
        z73 = y2 * z3_dot - z10 * z72
        z74 = z25 * (y3 * z3_dot - z14 * z72 - z17 * z73)
        z75 = z16 * z73 - z17 * z74
        z76 = y1 * y1_dot
        z77 = y2 * y1_dot - z10 * z76
        z78 = z25 * (y3 * y1_dot - z14 * z76 - z17 * z77)
        z79 = z16 * z77 - z17 * z78
        z80 = y1 * y2_dot
        z81 = y2 * y2_dot - z10 * z80
        z82 = z25 * (y3 * y2_dot - z14 * z80 - z17 * z81)
        z83 = z16 * z81 - z17 * z82
        z84 = y1 * y3_dot
        z85 = y2 * y3_dot - z10 * z84
        z86 = z25 * (y3 * y3_dot - z14 * z84 - z17 * z85)
        z87 = z16 * z85 - z17 * z86
        J: list[float] = [
            # (III.3)
            0.0,
            # (III.3)
            -z1_dot,
            # (III.3)
            -z2_dot,
            # (III.3)
            -z3_dot,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -y1,
            # (III.3)
            -y2,
            # (III.3)
            -y3,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            -z19,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -2.0 * z20,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -z21,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -2.0 * z22,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -(1.0 + z3 * z3),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -2.0 * z23,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            y1 * z9 - z10 * z27 - z14 * z26,
            # (III.3)
            z9 * z42 - z10 * z45 - z14 * z44,
            # (III.3)
            z9 * z46 - z10 * z49 - z14 * z48,
            # (III.3)
            z9 * z50 - z10 * z53 - z14 * z52,
            # (III.3)
            -(z9 * z54 - z10 * z58 + z14 * z57),
            # (III.3)
            -(2.0 * (z9 * z55) - z10 * z61 + z14 * z60),
            # (III.3)
            z14 * z62 - z10 * z63,
            # (III.3)
            z14 * z66 - (z64 * z9 - z10 * z67),
            # (III.3)
            z14 * z70 - (z9 * z68 - z10 * z71),
            # (III.3)
            z14 * z74 - (z9 * z72 - z10 * z75),
            # (III.3)
            z14 * z78 - (z9 * z76 - z10 * z79),
            # (III.3)
            z14 * z82 - (z9 * z80 - z10 * z83),
            # (III.3)
            z14 * z86 - (z9 * z84 - z10 * z87),
            # (III.3)
            z27,
            # (III.3)
            z45,
            # (III.3)
            z49,
            # (III.3)
            z53,
            # (III.3)
            -z58,
            # (III.3)
            -z61,
            # (III.3)
            z63,
            # (III.3)
            -z67,
            # (III.3)
            -z71,
            # (III.3)
            -z75,
            # (III.3)
            -z79,
            # (III.3)
            -z83,
            # (III.3)
            -z87,
            # (III.3)
            z26,
            # (III.3)
            z44,
            # (III.3)
            z48,
            # (III.3)
            z52,
            # (III.3)
            z57,
            # (III.3)
            z60,
            # (III.3)
            -z62,
            # (III.3)
            -z66,
            # (III.3)
            -z70,
            # (III.3)
            -z74,
            # (III.3)
            -z78,
            # (III.3)
            -z82,
            # (III.3)
            -z86,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 13] for k1 in range(0, 169, 13)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (13,), p (0,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
