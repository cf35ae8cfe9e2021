"""chaotic, emitted by nhc 0.1.0 (nhc:ca49dacb4ce13574).

Seven coupled oscillators with one contact constraint; reversible and chaotic.
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
jacobian: 53 +-, 102 *, 1 /, 0 calls
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
    """Right-hand side dy/dt = f(t, y; p) (III.3).

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
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
    try:
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular, if z7 is 0
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
            # x' (I.1.2)
            -(y3 * z3_dot + (y1 * z1_dot + y2 * z2_dot)),
            # y1' (I.1.2)
            y1_dot,
            # y2' (I.1.2)
            y2_dot,
            # y3' (I.1.2)
            y3_dot,
            # z1' (I.1.2)
            z1_dot,
            # z2' (I.1.2)
            z2_dot,
            # z3' (I.1.2)
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
    """All velocities q' from the state (I.1.2).

    Arguments: t (scalar), y (13,), p (0,).
    Returns qdot (7,).
    """
    y1 = float(y[1])
    y2 = float(y[2])
    y3 = float(y[3])
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
    try:
        # from the state
        qdot: list[float] = [
            # x' (I.1.2)
            -(y3 * z3_dot + (y1 * z1_dot + y2 * z2_dot)),
            # y1' (I.1.2)
            y1_dot,
            # y2' (I.1.2)
            y2_dot,
            # y3' (I.1.2)
            y3_dot,
            # z1' (I.1.2)
            z1_dot,
            # z2' (I.1.2)
            z2_dot,
            # z3' (I.1.2)
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
    """All accelerations q'' on the motion (III.3).

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
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
    try:
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular, if z7 is 0
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
    """The state y from coordinates and velocities.

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
    y1_dot = float(qdot[1])  # y1'
    y2_dot = float(qdot[2])  # y2'
    y3_dot = float(qdot[3])  # y3'
    z1_dot = float(qdot[4])  # z1'
    z2_dot = float(qdot[5])  # z2'
    z3_dot = float(qdot[6])  # z3'
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (7,), qdot (7,), p (0,).
    Returns r (1,).
    """
    y1 = float(q[1])
    y2 = float(q[2])
    y3 = float(q[3])
    x_dot = float(qdot[0])  # x'
    z1_dot = float(qdot[4])  # z1'
    z2_dot = float(qdot[5])  # z2'
    z3_dot = float(qdot[6])  # z3'
    try:
        # from the coordinates and velocities
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
    """Reactions lambda of the constraints (I.4.1).

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
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
    try:
        # from the state
        z4 = 1.0 + y1 * y1
        z5 = y2 * y2
        z6 = y3 * y3
        z7 = z4 + (z5 + z6)
        # the mass matrix is singular, if z7 is 0
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
    """Energy T + V.

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
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
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
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

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
    y1_dot = float(y[7])  # y1'
    y2_dot = float(y[8])  # y2'
    y3_dot = float(y[9])  # y3'
    z1_dot = float(y[10])  # z1'
    z2_dot = float(y[11])  # z2'
    z3_dot = float(y[12])  # z3'
    try:
        # from the state
        z4 = y1 * y1
        z5 = 1.0 + z4
        z6 = y2 * y2
        z7 = y3 * y3
        z8 = z5 + (z6 + z7)
        # the mass matrix is singular, if z8 is 0
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "jacobian")
        z9 = 1.0 + z1 * z1
        z10 = y1 * z1
        z11 = z2 * z2
        z12 = 1.0 + z11
        z13 = y2 * z2
        z14 = 1.0 / z8
        z15 = y1 * z14
        z16 = z6 + z9
        z17 = z2 * z16
        z18 = x - (y3_dot * z3_dot + (y1_dot * z1_dot + y2_dot * z2_dot))
        z19 = z11 + z5
        z20 = z1 * z19
        z21 = 1.0 + z7
        z22 = z3 * z21
        z23 = z14 * (z18 + (y1 * z20 + (y3 * z22 + y2 * z17)))
        z24 = z17 - y2 * z23
        z25 = y2 * z24
        z26 = z22 - y3 * z23
        z27 = z18 + y3 * z26
        z28 = z20 - y1 * z23
        z29 = z25 + z27 - 2.0 * (y1 * (z1 - z28))
        z30 = z14 * (z7 * z28 + (y1 * z29 + z6 * z28))
        z31 = y1 * z28
        z32 = z31 + z27 - 2.0 * (y2 * (z2 - z24))
        z33 = z14 * (z7 * z24 + (z4 * z24 + y2 * z32))
        z34 = z24 - z33
        z35 = z31 + (z18 + z25) - 2.0 * (y3 * (z3 - z26))
        z36 = z14 * (y3 * z35 + (z4 + z6) * z26)
        z37 = z26 - z36
        z38 = z1 * z13
        z39 = 2.0 * (z1 * z2)
        z40 = z2 * z10
        z41 = 2.0 * z40 + y2 * z16
        z42 = y3 * z14
        z43 = z21 * z42
        z44 = y2 * z14
        z45 = z28 - z30
        z46 = y1 * z19 + 2.0 * z38
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
            -z9,
            0.0,
            0.0,
            # (III.3)
            -2.0 * z10,
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
            -z12,
            0.0,
            0.0,
            # (III.3)
            -2.0 * z13,
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
            z15,
            # (III.3)
            z29 - y1 * z30,
            # (III.3)
            y1 * z34,
            # (III.3)
            y1 * z37,
            # (III.3)
            y1 * (2.0 * (z14 * z38) - y1 * (1.0 - z19 * z14)) - z12,
            # (III.3)
            z15 * z41 - z39,
            # (III.3)
            y1 * z43,
            # (III.3)
            -z1_dot * z15,
            # (III.3)
            -z2_dot * z15,
            # (III.3)
            -z3_dot * z15,
            # (III.3)
            -y1_dot * z15,
            # (III.3)
            -y2_dot * z15,
            # (III.3)
            -y3_dot * z15,
            # (III.3)
            z44,
            # (III.3)
            y2 * z45,
            # (III.3)
            z32 - y2 * z33,
            # (III.3)
            y2 * z37,
            # (III.3)
            z44 * z46 - z39,
            # (III.3)
            y2 * (2.0 * (z14 * z40) - y2 * (1.0 - z16 * z14)) - z9,
            # (III.3)
            y2 * z43,
            # (III.3)
            -z1_dot * z44,
            # (III.3)
            -z2_dot * z44,
            # (III.3)
            -z3_dot * z44,
            # (III.3)
            -y1_dot * z44,
            # (III.3)
            -y2_dot * z44,
            # (III.3)
            -y3_dot * z44,
            # (III.3)
            z42,
            # (III.3)
            y3 * z45,
            # (III.3)
            y3 * z34,
            # (III.3)
            z35 - y3 * z36,
            # (III.3)
            z42 * z46,
            # (III.3)
            z42 * z41,
            # (III.3)
            -(1.0 + z7 * (1.0 - z21 * z14)),
            # (III.3)
            -z1_dot * z42,
            # (III.3)
            -z2_dot * z42,
            # (III.3)
            -z3_dot * z42,
            # (III.3)
            -y1_dot * z42,
            # (III.3)
            -y2_dot * z42,
            # (III.3)
            -y3_dot * z42,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 13] for k1 in range(0, 169, 13)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (13,), p (0,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
