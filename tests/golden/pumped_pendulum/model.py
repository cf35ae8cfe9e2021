# ruff: noqa: E741
"""pumped_pendulum, emitted by nhc 0.1.0 (nhc:80491f4f18741f56).

A pendulum whose pivot is moved to and fro; T depends on time and is not homogeneous
    in the velocities.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = theta [rad]: angle from the downward vertical
y[1] = theta' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of the bob
p[1]: l = 1.0 [m]: length of the rod
p[2]: g = 9.81 [m/s^2]: acceleration of gravity
p[3]: a = 0.3 [m]: amplitude of the pivot
p[4]: nu = 3.0 [rad/s]: frequency of the pivot

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 1 +-, 9 *, 1 /, 3 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 1 +-, 9 *, 1 /, 3 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 2 *, 0 /, 0 calls
energy: 3 +-, 13 *, 0 /, 3 calls
jacobian: 1 +-, 9 *, 1 /, 3 calls
outputs: 0 +-, 0 *, 0 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("theta",)
STATE: tuple[str, ...] = ("theta", "theta'")
PARAMETERS: tuple[str, ...] = ("m", "l", "g", "a", "nu")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ()
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 9.81, 0.3, 3.0)

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

    Arguments: t (scalar), y (2,), p (5,).
    Returns dydt (2,).
    """
    t_ = float(t)  # t: time
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[1])  # theta' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    a = float(p[3])  # amplitude of the pivot [m]
    nu = float(p[4])  # frequency of the pivot [rad/s]
    try:
        s2 = m * (l * l)
        # the mass matrix is singular, if s2 is 0
        if not abs(s2) > 0.0:
            raise _refuse(abs(s2), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = a * nu * nu
        k2 = -1.0 / l
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        s1 = math.sin(t_ * nu)
        dydt: list[float] = [
            # theta' (II.3)
            theta_dot,
            # theta'' (II.3) 17:4
            (g * s_theta - c_theta * (s1 * k1)) * k2,
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

    Arguments: t (scalar), y (2,), p (5,).
    Returns qdot (1,).
    """
    theta_dot = float(y[1])  # theta' [rad/s]
    try:
        # from the state
        qdot: list[float] = [
            # theta'
            theta_dot,
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

    Arguments: t (scalar), y (2,), p (5,).
    Returns qddot (1,).
    """
    t_ = float(t)  # t: time
    theta = float(y[0])  # angle from the downward vertical [rad]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    a = float(p[3])  # amplitude of the pivot [m]
    nu = float(p[4])  # frequency of the pivot [rad/s]
    try:
        s2 = m * (l * l)
        # the mass matrix is singular, if s2 is 0
        if not abs(s2) > 0.0:
            raise _refuse(abs(s2), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = a * nu * nu
        k2 = -1.0 / l
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        s1 = math.sin(t_ * nu)
        qddot: list[float] = [
            # theta'' (II.3)
            (g * s_theta - c_theta * (s1 * k1)) * k2,
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

    Arguments: t (scalar), q (1,), qdot (1,), p (5,).
    Returns y (2,).
    """
    theta = float(q[0])  # angle from the downward vertical [rad]
    theta_dot = float(qdot[0])  # theta' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [theta, theta_dot]
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

    Arguments: t (scalar), q (1,), qdot (1,), p (5,).
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

    Arguments: t (scalar), y (2,), p (5,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    try:
        s1 = m * (l * l)
        # the mass matrix is singular, if s1 is 0
        if not abs(s1) > 0.0:
            raise _refuse(abs(s1), 0.0, 2, "reactions")
        # from the state
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (2,), p (5,).
    Returns a scalar.
    """
    t_ = float(t)  # t: time
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[1])  # theta' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    a = float(p[3])  # amplitude of the pivot [m]
    nu = float(p[4])  # frequency of the pivot [rad/s]
    try:
        # from the parameters alone
        k1 = a * nu
        k2 = l * (m * g)
        # from the state
        c1 = math.cos(t_ * nu)
        c_theta = math.cos(theta)
        z1 = theta_dot * l
        x_dot = c1 * k1 + c_theta * z1
        s_theta = math.sin(theta)
        y_dot = s_theta * z1
        value1 = 0.5 * (m * (x_dot * x_dot + y_dot * y_dot)) - c_theta * k2
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (2,), p (5,).
    Returns rows (2, 2): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # t: time
    theta = float(y[0])  # angle from the downward vertical [rad]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    a = float(p[3])  # amplitude of the pivot [m]
    nu = float(p[4])  # frequency of the pivot [rad/s]
    try:
        s2 = m * (l * l)
        # the mass matrix is singular, if s2 is 0
        if not abs(s2) > 0.0:
            raise _refuse(abs(s2), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = a * nu * nu
        k2 = -1.0 / l
        # from the state
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        s1 = math.sin(t_ * nu)
        J: list[float] = [
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            k2 * (g * c_theta + s_theta * (s1 * k1)),
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 2] for k3 in range(0, 4, 2)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (2,), p (5,).
    Returns out (0,).
    """
    try:
        out: list[float] = []
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
