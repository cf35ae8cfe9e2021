"""point_mass, emitted by nhc 0.1.0 (nhc:94c21e76a579e2f5).

A point mass thrown in a uniform field of gravity, with linear drag.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = x [m]: horizontal
y[1] = y [m]: horizontal
y[2] = z [m]: height
y[3] = x' [m/s]
y[4] = y' [m/s]
y[5] = z' [m/s]

Parameters p:
p[0]: m = 2.0 [kg]: mass
p[1]: g = 9.81 [m/s^2]: acceleration of gravity
p[2]: c = 0.5 [kg/s]: drag coefficient

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 1 +-, 3 *, 1 /, 0 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 1 +-, 3 *, 1 /, 0 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 0 *, 0 /, 0 calls
energy: 3 +-, 7 *, 0 /, 0 calls
jacobian: 0 +-, 0 *, 1 /, 0 calls
outputs: 2 +-, 3 *, 0 /, 1 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "z")
STATE: tuple[str, ...] = ("x", "y", "z", "x'", "y'", "z'")
PARAMETERS: tuple[str, ...] = ("m", "g", "c")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (2.0, 9.81, 0.5)

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
    """Right-hand side dy/dt = f(t, y; p) (II.3).

    Arguments: t (scalar), y (6,), p (3,).
    Returns dydt (6,).
    """
    x_dot = float(y[3])  # x' [m/s]
    y_dot = float(y[4])  # y' [m/s]
    z_dot = float(y[5])  # z' [m/s]
    m = float(p[0])  # mass [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    c = float(p[2])  # drag coefficient [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = c / m
        # from the state
        dydt: list[float] = [
            # x' (II.3)
            x_dot,
            # y' (II.3)
            y_dot,
            # z' (II.3)
            z_dot,
            # x'' (II.3) 14:4
            -x_dot * k1,
            # y'' (II.3) 14:4
            -y_dot * k1,
            # z'' (II.3) 14:4
            -(g + z_dot * k1),
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state.

    Arguments: t (scalar), y (6,), p (3,).
    Returns qdot (3,).
    """
    x_dot = float(y[3])  # x' [m/s]
    y_dot = float(y[4])  # y' [m/s]
    z_dot = float(y[5])  # z' [m/s]
    try:
        # from the state
        qdot: list[float] = [
            # x'
            x_dot,
            # y'
            y_dot,
            # z'
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
    """All accelerations q'' on the motion (II.3).

    Arguments: t (scalar), y (6,), p (3,).
    Returns qddot (3,).
    """
    x_dot = float(y[3])  # x' [m/s]
    y_dot = float(y[4])  # y' [m/s]
    z_dot = float(y[5])  # z' [m/s]
    m = float(p[0])  # mass [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    c = float(p[2])  # drag coefficient [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = c / m
        # from the state
        qddot: list[float] = [
            # x'' (II.3)
            -x_dot * k1,
            # y'' (II.3)
            -y_dot * k1,
            # z'' (II.3)
            -(g + z_dot * k1),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns y (6,).
    """
    x = float(q[0])  # horizontal [m]
    y_2 = float(q[1])  # y: horizontal [m]
    z = float(q[2])  # height [m]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    z_dot = float(qdot[2])  # z' [m/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, z, x_dot, y_dot, z_dot]
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

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns r (0,).
    """
    try:
        r: list[float] = []
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (6,), p (3,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    m = float(p[0])  # mass [kg]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "reactions")
        # from the state
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (6,), p (3,).
    Returns a scalar.
    """
    z = float(y[2])  # height [m]
    x_dot = float(y[3])  # x' [m/s]
    y_dot = float(y[4])  # y' [m/s]
    z_dot = float(y[5])  # z' [m/s]
    m = float(p[0])  # mass [kg]
    g = float(p[1])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        # from the state
        s1 = 0.5 * (m * (x_dot * x_dot + y_dot * y_dot + z_dot * z_dot))
        value1 = s1 + z * k1
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (6,), p (3,).
    Returns rows (6, 6): d rhs_i / d y_j stands at [i][j].
    """
    m = float(p[0])  # mass [kg]
    c = float(p[2])  # drag coefficient [kg/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = c / m
        # from the state
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -k1,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -k1,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -k1,
        ]
        _finish("jacobian", J)
        return [J[k2 : k2 + 6] for k2 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (6,), p (3,).
    Returns out (1,).
    """
    x_dot = float(y[3])  # x' [m/s]
    y_dot = float(y[4])  # y' [m/s]
    z_dot = float(y[5])  # z' [m/s]
    try:
        # from the state
        out: list[float] = [
            # speed 21:10
            math.sqrt(x_dot * x_dot + y_dot * y_dot + z_dot * z_dot),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
