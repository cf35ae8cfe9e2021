"""contact_oscillator, emitted by nhc 0.1.0 (nhc:0e2d82c18b1d389e).

Three equal oscillators with one contact constraint; reversible and integrable.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): a force
    acts on the dependent coordinate `x`

State y:
y[0] = x
y[1] = y
y[2] = z
y[3] = y'
y[4] = z'

No parameters.

Constraints:
0: contact

Outputs:
out[0] = H_y
out[1] = R

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 3 +-, 4 *, 1 /, 0 calls
velocities: 0 +-, 1 *, 0 /, 0 calls
accelerations: 4 +-, 4 *, 1 /, 0 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 1 +-, 1 *, 0 /, 0 calls
reactions: 3 +-, 3 *, 1 /, 0 calls
energy: 5 +-, 7 *, 0 /, 0 calls
jacobian: 4 +-, 9 *, 1 /, 0 calls
outputs: 4 +-, 8 *, 0 /, 0 calls

A singular point raises SingularModelError.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "z")
STATE: tuple[str, ...] = ("x", "y", "z", "y'", "z'")
PARAMETERS: tuple[str, ...] = ()
CONSTRAINTS: tuple[str, ...] = ("contact",)
OUTPUTS: tuple[str, ...] = ("H_y", "R")
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

    Arguments: t (scalar), y (5,), p (0,).
    Returns dydt (5,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = 1.0 + y_2 * y_2
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "rhs")
        dydt: list[float] = [
            # x' (I.1.2)
            -y_2 * z_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z_dot,
            # y'' (III.3) 7:4
            -y_2,
            # z'' (III.3) 7:4
            (y_2 * (x - y_dot * z_dot) - z) / z1,
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
    y_2 = float(y[1])  # y
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        qdot: list[float] = [
            # x' (I.1.2)
            -y_2 * z_dot,
            # y' (I.1.2)
            y_dot,
            # z' (I.1.2)
            z_dot,
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

    Arguments: t (scalar), y (5,), p (0,).
    Returns qddot (3,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = 1.0 + y_2 * y_2
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "accelerations")
        z2 = y_dot * z_dot
        z3 = (z - y_2 * (x - z2)) / z1
        qddot: list[float] = [
            # x'' (III.3)
            y_2 * z3 - z2,
            # y'' (III.3)
            -y_2,
            # z'' (III.3)
            -z3,
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
    y_dot = float(qdot[1])  # y'
    z_dot = float(qdot[2])  # z'
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, z, y_dot, z_dot]
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
    y = float(q[1])
    x_dot = float(qdot[0])  # x'
    z_dot = float(qdot[2])  # z'
    try:
        # from the coordinates and velocities
        r: list[float] = [
            # contact = 0 (I.1.1) 10:5
            x_dot + y * z_dot,
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
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = 1.0 + y_2 * y_2
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "reactions")
        lambda_: list[float] = [
            # reaction of contact: Q_i gains lambda_1 a_1i (I.4.1) 10:5
            (x + y_2 * z - y_dot * z_dot) / z1,
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
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = z_dot * z_dot
        s1 = z1 + (y_dot * y_dot + (x * x + z * z))
        z2 = 0.5 * (y_2 * y_2 * (1.0 + z1) + s1)
        value1 = z2
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

    Arguments: t (scalar), y (5,), p (0,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = 1.0 + y_2 * y_2
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "jacobian")
        z2 = 1.0 / z1
        z3 = y_2 * z2
        z4 = x - y_dot * z_dot
        J: list[float] = [
            0.0,
            # (III.3)
            -z_dot,
            0.0,
            0.0,
            # (III.3)
            -y_2,
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
            # (III.3)
            1.0,
            0.0,
            # (III.3)
            -1.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z3,
            # (III.3)
            z2 * (z4 + 2.0 * ((z - y_2 * z4) * z3)),
            # (III.3)
            -z2,
            # (III.3)
            -z_dot * z3,
            # (III.3)
            -y_dot * z3,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 5] for k1 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (0,).
    Returns out (2,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    z = float(y[2])
    y_dot = float(y[3])  # y'
    z_dot = float(y[4])  # z'
    try:
        # from the state
        z1 = y_2 * y_2
        out: list[float] = [
            # H_y 13:8
            0.5 * (y_dot * y_dot + z1),
            # R 14:6
            0.5 * (x * x + z * z + z_dot * z_dot * (1.0 + z1)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
