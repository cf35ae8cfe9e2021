"""bead_on_rod, emitted by nhc 0.1.0 (nhc:1e1c51118c76392d).

A bead on a straight horizontal rod that turns at a constant rate; T has a part
    without velocities.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = r [m]: distance from the axis
y[1] = r' [m/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of the bead
p[1]: Omega = 2.0 [rad/s]: rate of the rod

Outputs:
out[0] = jacobi [kg*m^2/s^2]
out[1] = torque [kg*m^2/s^2]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 0 +-, 2 *, 0 /, 0 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 0 +-, 2 *, 0 /, 0 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 0 *, 0 /, 0 calls
energy: 1 +-, 6 *, 0 /, 0 calls
jacobian: 0 +-, 1 *, 0 /, 0 calls
outputs: 1 +-, 10 *, 0 /, 0 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("r",)
STATE: tuple[str, ...] = ("r", "r'")
PARAMETERS: tuple[str, ...] = ("m", "Omega")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("jacobi", "torque")
DEFAULTS: tuple[float, ...] = (1.0, 2.0)

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

    Arguments: t (scalar), y (2,), p (2,).
    Returns dydt (2,).
    """
    r = float(y[0])  # distance from the axis [m]
    r_dot = float(y[1])  # r' [m/s]
    m = float(p[0])  # mass of the bead [kg]
    Omega = float(p[1])  # rate of the rod [rad/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = Omega * Omega
        # from the state
        dydt: list[float] = [
            # r' (II.3)
            r_dot,
            # r'' (II.3) 14:4
            r * k1,
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

    Arguments: t (scalar), y (2,), p (2,).
    Returns qdot (1,).
    """
    r_dot = float(y[1])  # r' [m/s]
    try:
        # from the state
        qdot: list[float] = [
            # r'
            r_dot,
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

    Arguments: t (scalar), y (2,), p (2,).
    Returns qddot (1,).
    """
    r = float(y[0])  # distance from the axis [m]
    m = float(p[0])  # mass of the bead [kg]
    Omega = float(p[1])  # rate of the rod [rad/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = Omega * Omega
        # from the state
        qddot: list[float] = [
            # r'' (II.3)
            r * k1,
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

    Arguments: t (scalar), q (1,), qdot (1,), p (2,).
    Returns y (2,).
    """
    r = float(q[0])  # distance from the axis [m]
    r_dot = float(qdot[0])  # r' [m/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [r, r_dot]
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

    Arguments: t (scalar), q (1,), qdot (1,), p (2,).
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

    Arguments: t (scalar), y (2,), p (2,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    m = float(p[0])  # mass of the bead [kg]
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

    Arguments: t (scalar), y (2,), p (2,).
    Returns a scalar.
    """
    r = float(y[0])  # distance from the axis [m]
    r_dot = float(y[1])  # r' [m/s]
    m = float(p[0])  # mass of the bead [kg]
    Omega = float(p[1])  # rate of the rod [rad/s]
    try:
        # from the parameters alone
        k1 = Omega * Omega
        # from the state
        value1 = 0.5 * (m * (r_dot * r_dot + k1 * (r * r)))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (2,), p (2,).
    Returns rows (2, 2): d rhs_i / d y_j stands at [i][j].
    """
    m = float(p[0])  # mass of the bead [kg]
    Omega = float(p[1])  # rate of the rod [rad/s]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # from the state
        J: list[float] = [
            0.0,
            # (II.3)
            1.0,
            # (II.3)
            Omega * Omega,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 2] for k1 in range(0, 4, 2)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (2,), p (2,).
    Returns out (2,).
    """
    r = float(y[0])  # distance from the axis [m]
    r_dot = float(y[1])  # r' [m/s]
    m = float(p[0])  # mass of the bead [kg]
    Omega = float(p[1])  # rate of the rod [rad/s]
    try:
        # from the parameters alone
        k1 = Omega * Omega
        k2 = m * Omega
        # from the state
        out: list[float] = [
            # jacobi 16:11
            0.5 * (m * (r_dot * r_dot - k1 * (r * r))),
            # torque 17:11
            2.0 * (k2 * (r * r_dot)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
