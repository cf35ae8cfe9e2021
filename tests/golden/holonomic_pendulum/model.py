# ruff: noqa: E741
"""holonomic_pendulum, emitted by nhc 0.1.0 (nhc:fa3d76b1f8799a17).

The plane pendulum in Cartesian coordinates with the rod as a constraint on the
    positions.
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v: the dependent velocities that nhc would choose
    (x') are singular somewhere

State y:
y[0] = x [m]: across
y[1] = y [m]: up
y[2] = v [1/s]: (y*x' - x*y')/(x^2 + y^2)

Parameters p:
p[0]: m = 1.0 [kg]: mass of the bob
p[1]: g = 9.81 [m/s^2]: acceleration of gravity
p[2]: l = 1.0 [m]: length of the rod

Constraints, with the units of their reactions:
0: rod [kg/s^2]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 1 +-, 7 *, 1 /, 0 calls
velocities: 1 +-, 4 *, 0 /, 0 calls
accelerations: 3 +-, 10 *, 1 /, 0 calls
state: 2 +-, 4 *, 1 /, 0 calls
residuals: 1 +-, 2 *, 0 /, 0 calls
positions: 2 +-, 4 *, 0 /, 0 calls
reactions: 2 +-, 6 *, 1 /, 0 calls
energy: 2 +-, 8 *, 0 /, 0 calls
jacobian: 2 +-, 13 *, 1 /, 0 calls
outputs: 1 +-, 2 *, 0 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y")
STATE: tuple[str, ...] = ("x", "y", "v")
PARAMETERS: tuple[str, ...] = ("m", "g", "l")
CONSTRAINTS: tuple[str, ...] = ("rod",)
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = (1.0, 9.81, 1.0)

REASONS = (
    "",
    "the coframe is singular",
    "the mass matrix is singular, or the velocities that are kept do not suffice",
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
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (3,), p (3,).
    Returns dydt (3,).
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    m = float(p[0])  # mass of the bob [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        # from the state
        z1 = x * x + y_2 * y_2
        # the coframe is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 1, "rhs")
        z2 = m * z1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "rhs")
        dydt: list[float] = [
            # x' (I.2.4)
            y_2 * v,
            # y' (I.2.4)
            -x * v,
            # v' (I.2.15) 13:4
            x * k1 / z2,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state (I.2.4).

    Arguments: t (scalar), y (3,), p (3,).
    Returns qdot (2,).
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    try:
        s1 = x * x + y_2 * y_2
        # the coframe is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 1, "velocities")
        # from the state
        qdot: list[float] = [
            # x' (I.2.4)
            y_2 * v,
            # y' (I.2.4)
            -x * v,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (3,), p (3,).
    Returns qddot (2,).
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    m = float(p[0])  # mass of the bob [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        # from the state
        z1 = x * x + y_2 * y_2
        # the coframe is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 1, "accelerations")
        z2 = m * z1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "accelerations")
        z3 = v * v
        z4 = k1 * (x / z2)
        qddot: list[float] = [
            # x'' (I.2.15)
            y_2 * z4 - x * z3,
            # y'' (I.2.15)
            -(y_2 * z3 + x * z4),
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
    """The state y from coordinates and velocities (I.2.1).

    Arguments: t (scalar), q (2,), qdot (2,), p (3,).
    Returns y (3,).
    """
    x = float(q[0])  # across [m]
    y_2 = float(q[1])  # y: up [m]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, (y_2 * x_dot - x * y_dot) / (x * x + y_2 * y_2)]
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

    Arguments: t (scalar), q (2,), qdot (2,), p (3,).
    Returns r (1,).
    """
    x = float(q[0])  # across [m]
    y = float(q[1])  # up [m]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    try:
        # from the coordinates and velocities
        r: list[float] = [
            # rod = 0 (I.1.1) 16:5
            x * x_dot + y * y_dot,
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def positions(
    t: float,
    q: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Left minus right side of each holonomic constraint, zero on every motion.

    Arguments: t (scalar), q (2,), p (3,).
    Returns f (1,).
    """
    x = float(q[0])  # across [m]
    y = float(q[1])  # up [m]
    l = float(p[2])  # length of the rod [m]
    try:
        # from the parameters alone
        k1 = l * l
        # from the coordinates
        f: list[float] = [
            # rod = 0 16:5
            0.5 * (x * x + y * y - k1),
        ]
        return _finish("positions", f)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "positions") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (3,), p (3,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    m = float(p[0])  # mass of the bob [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the state
        z1 = x * x + y_2 * y_2
        # the coframe is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 1, "reactions")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if m * z1 is 0
        if not abs(m * z1) > 0.0:
            raise _refuse(abs(m * z1), 0.0, 2, "reactions")
        lambda_: list[float] = [
            # reaction of rod: Q_i gains lambda_1 a_1i (I.4.1) 16:5
            (y_2 * g / z1 - v * v) * m,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (3,), p (3,).
    Returns a scalar.
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    m = float(p[0])  # mass of the bob [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        # from the state
        z1 = y_2 * v
        z2 = x * v
        value1 = y_2 * k1 + 0.5 * (m * (z1 * z1 + z2 * z2))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (3,), p (3,).
    Returns rows (3, 3): d rhs_i / d y_j stands at [i][j].
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    v = float(y[2])  # [1/s]
    m = float(p[0])  # mass of the bob [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        k2 = m * k1
        # from the state
        z1 = x * x + y_2 * y_2
        # the coframe is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 1, "jacobian")
        z2 = m * z1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "jacobian")
        z3 = 1.0 / z2
        z4 = x * z3 * k2
        J: list[float] = [
            0.0,
            # (I.2.15)
            v,
            # (I.2.15)
            y_2,
            # (I.2.15)
            -v,
            0.0,
            # (I.2.15)
            -x,
            # (I.2.15)
            z3 * (k1 - 2.0 * (x * z4)),
            # (I.2.15)
            -2.0 * (z3 * (y_2 * z4)),
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 3] for k3 in range(0, 9, 3)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (3,), p (3,).
    Returns out (0,).
    """
    x = float(y[0])  # across [m]
    y_2 = float(y[1])  # y: up [m]
    try:
        s1 = x * x + y_2 * y_2
        # the coframe is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 1, "outputs")
        # from the state
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
