# ruff: noqa: E741
"""spherical_pendulum, emitted by nhc 0.1.0 (nhc:20b984da7bc9ea11).

A pendulum that swings in space.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = theta [rad]: angle from the downward vertical
y[1] = phi [rad]: azimuth
y[2] = theta' [rad/s]
y[3] = phi' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of the bob
p[1]: l = 1.0 [m]: length of the rod
p[2]: g = 9.81 [m/s^2]: acceleration of gravity

Outputs:
out[0] = L_z [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 1 +-, 10 *, 2 /, 2 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 1 +-, 10 *, 2 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 4 *, 0 /, 1 calls
energy: 2 +-, 9 *, 0 /, 2 calls
jacobian: 2 +-, 20 *, 2 /, 2 calls
outputs: 0 +-, 5 *, 0 /, 1 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("theta", "phi")
STATE: tuple[str, ...] = ("theta", "phi", "theta'", "phi'")
PARAMETERS: tuple[str, ...] = ("m", "l", "g")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("L_z",)
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 9.81)

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

    Arguments: t (scalar), y (4,), p (3,).
    Returns dydt (4,).
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[2])  # theta' [rad/s]
    phi_dot = float(y[3])  # phi' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * l * l
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "rhs")
        k2 = g / l
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if k1 * s1 is 0
        if not abs(k1 * s1) > 0.0:
            raise _refuse(abs(k1 * s1), 0.0, 2, "rhs")
        c_theta = math.cos(theta)
        dydt: list[float] = [
            # theta' (II.3)
            theta_dot,
            # phi' (II.3)
            phi_dot,
            # theta'' (II.3) 13:4
            s_theta * (phi_dot * phi_dot * c_theta - k2),
            # phi'' (II.3) 13:4
            -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta),
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

    Arguments: t (scalar), y (4,), p (3,).
    Returns qdot (2,).
    """
    theta_dot = float(y[2])  # theta' [rad/s]
    phi_dot = float(y[3])  # phi' [rad/s]
    try:
        # from the state
        qdot: list[float] = [
            # theta'
            theta_dot,
            # phi'
            phi_dot,
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

    Arguments: t (scalar), y (4,), p (3,).
    Returns qddot (2,).
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[2])  # theta' [rad/s]
    phi_dot = float(y[3])  # phi' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * l * l
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "accelerations")
        k2 = g / l
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if k1 * s1 is 0
        if not abs(k1 * s1) > 0.0:
            raise _refuse(abs(k1 * s1), 0.0, 2, "accelerations")
        c_theta = math.cos(theta)
        qddot: list[float] = [
            # theta'' (II.3)
            s_theta * (phi_dot * phi_dot * c_theta - k2),
            # phi'' (II.3)
            -2.0 * (c_theta * (theta_dot * phi_dot) / s_theta),
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

    Arguments: t (scalar), q (2,), qdot (2,), p (3,).
    Returns y (4,).
    """
    theta = float(q[0])  # angle from the downward vertical [rad]
    phi = float(q[1])  # azimuth [rad]
    theta_dot = float(qdot[0])  # theta' [rad/s]
    phi_dot = float(qdot[1])  # phi' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [theta, phi, theta_dot, phi_dot]
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

    Arguments: t (scalar), y (4,), p (3,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    try:
        # from the parameters alone
        k1 = m * l * l
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "reactions")
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if k1 * s1 is 0
        if not abs(k1 * s1) > 0.0:
            raise _refuse(abs(k1 * s1), 0.0, 2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (4,), p (3,).
    Returns a scalar.
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[2])  # theta' [rad/s]
    phi_dot = float(y[3])  # phi' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * l
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        s1 = s_theta * s_theta * (phi_dot * phi_dot)
        value1 = k1 * (0.5 * (l * (theta_dot * theta_dot + s1)) - g * c_theta)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (4,), p (3,).
    Returns rows (4, 4): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    theta_dot = float(y[2])  # theta' [rad/s]
    phi_dot = float(y[3])  # phi' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * l * l
        # the mass matrix is singular, if k1 is 0
        if not abs(k1) > 0.0:
            raise _refuse(abs(k1), 0.0, 2, "jacobian")
        k2 = g / l
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        # the mass matrix is singular, if k1 * z1 is 0
        if not abs(k1 * z1) > 0.0:
            raise _refuse(abs(k1 * z1), 0.0, 2, "jacobian")
        c_theta = math.cos(theta)
        z2 = phi_dot * c_theta
        z3 = 1.0 / s_theta
        J: list[float] = [
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            phi_dot * phi_dot * (1.0 - 2.0 * z1) - c_theta * k2,
            0.0,
            0.0,
            # (II.3)
            2.0 * (s_theta * z2),
            # (II.3)
            2.0 * (theta_dot * phi_dot * (z3 * z3)),
            0.0,
            # (II.3)
            -2.0 * (z3 * z2),
            # (II.3)
            -2.0 * (theta_dot * c_theta * z3),
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 4] for k3 in range(0, 16, 4)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (4,), p (3,).
    Returns out (1,).
    """
    theta = float(y[0])  # angle from the downward vertical [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    m = float(p[0])  # mass of the bob [kg]
    l = float(p[1])  # length of the rod [m]
    try:
        # from the parameters alone
        k1 = m * l * l
        # from the state
        s_theta = math.sin(theta)
        out: list[float] = [
            # L_z 16:8
            phi_dot * (k1 * (s_theta * s_theta)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
