"""chaotic, emitted by nhc 0.1.0 (nhc:025a8c6ddf5d2d2f).

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

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 20 +-, 24 *, 1 /, 0 calls
velocities: 2 +-, 3 *, 0 /, 0 calls
accelerations: 21 +-, 24 *, 1 /, 0 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 3 +-, 3 *, 0 /, 0 calls
reactions: 13 +-, 14 *, 1 /, 0 calls
energy: 19 +-, 22 *, 0 /, 0 calls
jacobian: 105 +-, 184 *, 4 /, 0 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "rhs")
        z8 = 1.0 + z1 * z1
        z9 = z2 * z2
        z10 = z1 * (z9 + z4)
        z11 = z3 * (1.0 + z6)
        z12 = z2 * (z5 + z8)
        s1 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot)
        z13 = s1 - (y3 * z11 + (y2 * z12 + (x + y1 * z10)))
        z14 = z13 / z7
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
            -y1 * z8,
            # y2'' (III.3) 10:4
            -y2 * (1.0 + z9),
            # y3'' (III.3) 10:4
            -y3 * (1.0 + z3 * z3),
            # z1'' (III.3) 10:4
            -(z10 + y1 * z14),
            # z2'' (III.3) 10:4
            -(z12 + y2 * z14),
            # z3'' (III.3) 10:4
            -(z11 + y3 * z14),
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
        # from the state
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
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "accelerations")
        z8 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot)
        z9 = 1.0 + z1 * z1
        z10 = z2 * (z5 + z9)
        z11 = z2 * z2
        z12 = z1 * (z11 + z4)
        z13 = z3 * (1.0 + z6)
        z14 = (z8 - (y1 * z12 + (x + (y3 * z13 + y2 * z10)))) / z7
        z15 = z10 + y2 * z14
        z16 = z12 + y1 * z14
        z17 = z13 + y3 * z14
        qddot: list[float] = [
            # x'' (III.3)
            y2 * z15 + (y1 * z16 + y3 * z17) - z8,
            # y1'' (III.3)
            -y1 * z9,
            # y2'' (III.3)
            -y2 * (1.0 + z11),
            # y3'' (III.3)
            -y3 * (1.0 + z3 * z3),
            # z1'' (III.3)
            -z16,
            # z2'' (III.3)
            -z15,
            # z3'' (III.3)
            -z17,
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
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (13,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
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
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "reactions")
        s1 = y2 * (z2 * (1.0 + (z5 + z1 * z1)))
        z8 = s1 + (x + y1 * (z1 * (z2 * z2 + z4)))
        s2 = y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot)
        z9 = (s2 - (y3 * (z3 * (1.0 + z6)) + z8)) / z7
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 13:5
            -z9,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V

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
        # from the state
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
        value1 = 0.5 * (z10 + (z3_dot * z3_dot + z12))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3)

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
        # from the state
        z4 = y3 * y3
        z5 = y2 * y2
        z6 = 1.0 + y1 * y1
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular
        if not abs(z7) > 0.0:
            raise _refuse(abs(z7), 0.0, 2, "jacobian")
        z8 = z1 * z1
        z9 = z2 * z2
        z10 = 1.0 / z6
        z11 = y1 * y2
        z12 = z11 * z10
        z13 = 1.0 + z5
        z14 = 1.0 / (z13 - z11 * z12)
        z15 = y2 - y1 * z12
        z16 = y1 * y3
        z17 = z16 * z10
        z18 = y2 * y3 - z11 * z17
        z19 = z18 * z14
        z20 = 1.0 + z4
        z21 = 1.0 / (z20 - z16 * z17 - z18 * z19)
        z22 = z21 * (y3 - y1 * z17 - z19 * z15)
        z23 = z14 * z15 - z19 * z22
        z24 = z8 + z13
        z25 = z2 * z24
        z26 = x - (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot))
        z27 = z9 + z6
        z28 = z1 * z27
        z29 = z3 * z20
        z30 = (z26 + (y1 * z28 + (y3 * z29 + y2 * z25))) / z7
        z31 = z25 - y2 * z30
        z32 = y2 * z31
        z33 = z29 - y3 * z30
        z34 = z26 + y3 * z33
        z35 = z28 - y1 * z30
        z36 = z32 + z34 - 2.0 * (y1 * (z1 - z35))
        z37 = y2 * z35 - z12 * z36
        z38 = z21 * (y3 * z35 - z17 * z36 - z19 * z37)
        z39 = z14 * z37 - z19 * z38
        z40 = y1 * z31
        z41 = y1 * z35
        z42 = z41 + z34 - 2.0 * (y2 * (z2 - z31)) - z12 * z40
        z43 = z21 * (y3 * z31 - z17 * z40 - z19 * z42)
        z44 = z14 * z42 - z19 * z43
        z45 = y1 * z33
        z46 = y2 * z33 - z12 * z45
        s1 = z41 + (z26 + z32) - 2.0 * (y3 * (z3 - z33)) - z17 * z45
        z47 = z21 * (s1 - z19 * z46)
        z48 = z14 * z46 - z19 * z47
        z49 = z1 * z2
        z50 = 2.0 * z49 - z12 * z27
        z51 = z21 * (z17 * z27 + z19 * z50)
        z52 = z14 * z50 + z19 * z51
        z53 = 2.0 * (z12 * z49) - z24
        z54 = z21 * (2.0 * (z17 * z49) - z19 * z53)
        z55 = z14 * z53 - z19 * z54
        z56 = z20 * z21
        z57 = z19 * z56
        z58 = y1 * z1_dot
        z59 = y2 * z1_dot - z58 * z12
        z60 = z21 * (y3 * z1_dot - z58 * z17 - z19 * z59)
        z61 = z14 * z59 - z19 * z60
        z62 = y1 * z2_dot
        z63 = y2 * z2_dot - z12 * z62
        z64 = z21 * (y3 * z2_dot - z17 * z62 - z19 * z63)
        z65 = z14 * z63 - z19 * z64
        z66 = y1 * z3_dot
        z67 = y2 * z3_dot - z12 * z66
        z68 = z21 * (y3 * z3_dot - z17 * z66 - z19 * z67)
        z69 = z14 * z67 - z19 * z68
        z70 = y1 * y1_dot
        z71 = y2 * y1_dot - z12 * z70
        z72 = z21 * (y3 * y1_dot - z17 * z70 - z19 * z71)
        z73 = z14 * z71 - z19 * z72
        z74 = y1 * y2_dot
        z75 = y2 * y2_dot - z12 * z74
        z76 = z21 * (y3 * y2_dot - z17 * z74 - z19 * z75)
        z77 = z14 * z75 - z19 * z76
        z78 = y1 * y3_dot
        z79 = y2 * y3_dot - z12 * z78
        z80 = z21 * (y3 * y3_dot - z17 * z78 - z19 * z79)
        z81 = z14 * z79 - z19 * z80
        J: list[float] = [
            0.0,
            # (III.3)
            -z1_dot,
            # (III.3)
            -z2_dot,
            # (III.3)
            -z3_dot,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            -y1,
            # (III.3)
            -y2,
            # (III.3)
            -y3,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            # (III.3)
            -(1.0 + z8),
            0.0,
            0.0,
            # (III.3)
            -2.0 * (y1 * z1),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            -(1.0 + z9),
            0.0,
            0.0,
            # (III.3)
            -2.0 * (y2 * z2),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            -(1.0 + z3 * z3),
            0.0,
            0.0,
            # (III.3)
            -2.0 * (y3 * z3),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            y1 * z10 - z12 * z23 - z17 * z22,
            # (III.3)
            z10 * z36 - z12 * z39 - z17 * z38,
            # (III.3)
            z10 * z40 - z12 * z44 - z17 * z43,
            # (III.3)
            z10 * z45 - z12 * z48 - z17 * z47,
            # (III.3)
            -(z10 * z27 - z12 * z52 + z17 * z51),
            # (III.3)
            -(2.0 * (z10 * z49) + z12 * z55 + z17 * z54),
            # (III.3)
            z17 * z56 - z12 * z57,
            # (III.3)
            z17 * z60 - (z58 * z10 - z12 * z61),
            # (III.3)
            z17 * z64 - (z10 * z62 - z12 * z65),
            # (III.3)
            z17 * z68 - (z10 * z66 - z12 * z69),
            # (III.3)
            z17 * z72 - (z10 * z70 - z12 * z73),
            # (III.3)
            z17 * z76 - (z10 * z74 - z12 * z77),
            # (III.3)
            z17 * z80 - (z10 * z78 - z12 * z81),
            # (III.3)
            z23,
            # (III.3)
            z39,
            # (III.3)
            z44,
            # (III.3)
            z48,
            # (III.3)
            -z52,
            # (III.3)
            z55,
            # (III.3)
            z57,
            # (III.3)
            -z61,
            # (III.3)
            -z65,
            # (III.3)
            -z69,
            # (III.3)
            -z73,
            # (III.3)
            -z77,
            # (III.3)
            -z81,
            # (III.3)
            z22,
            # (III.3)
            z38,
            # (III.3)
            z43,
            # (III.3)
            z47,
            # (III.3)
            z51,
            # (III.3)
            z54,
            # (III.3)
            -z56,
            # (III.3)
            -z60,
            # (III.3)
            -z64,
            # (III.3)
            -z68,
            # (III.3)
            -z72,
            # (III.3)
            -z76,
            # (III.3)
            -z80,
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
