"""skate_incline, emitted by nhc 0.1.0 (nhc:128780d565d239c5).

A skate on an inclined plane with its centre of mass above the edge; it never gets
    far downhill.
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v, phi': the dependent velocities that nhc would
    choose (y') are singular somewhere

State y:
y[0] = x [m]: down the slope
y[1] = y [m]: across the slope
y[2] = phi [rad]: heading, from the fall line
y[3] = v [m/s]: x'*cos(phi) + y'*sin(phi)
y[4] = phi' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: J = 0.4 [kg*m^2]: moment of inertia about the normal
p[2]: g = 9.81 [m/s^2]: acceleration of gravity
p[3]: alpha = 0.5235987755982988 [rad]: slope, 30 degrees

Constraints, with the units of their reactions:
0: slip [N]

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 0 +-, 4 *, 0 /, 3 calls
velocities: 0 +-, 2 *, 0 /, 2 calls
accelerations: 2 +-, 7 *, 0 /, 3 calls
state: 1 +-, 2 *, 0 /, 2 calls
residuals: 1 +-, 2 *, 0 /, 2 calls
reactions: 1 +-, 4 *, 0 /, 2 calls
energy: 2 +-, 8 *, 0 /, 1 calls
jacobian: 0 +-, 4 *, 0 /, 3 calls
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

COORDINATES: tuple[str, ...] = ("x", "y", "phi")
STATE: tuple[str, ...] = ("x", "y", "phi", "v", "phi'")
PARAMETERS: tuple[str, ...] = ("m", "J", "g", "alpha")
CONSTRAINTS: tuple[str, ...] = ("slip",)
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.4, 9.81, 0.5235987755982988)

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
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (5,), p (4,).
    Returns dydt (5,).
    """
    phi = float(y[2])  # heading, from the fall line [rad]
    v = float(y[3])  # [m/s]
    phi_dot = float(y[4])  # phi' [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the normal [kg*m^2]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    alpha = float(p[3])  # slope, 30 degrees [rad]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "rhs")
        # from the parameters alone
        s_alpha = math.sin(alpha)
        k1 = g * s_alpha
        # from the state
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        dydt: list[float] = [
            # x' (I.2.4)
            c_phi * v,
            # y' (I.2.4)
            s_phi * v,
            # phi' (I.2.4)
            phi_dot,
            # v' (I.2.15) 15:4
            c_phi * k1,
            # phi'' (I.2.15) 15:4
            0.0,
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

    Arguments: t (scalar), y (5,), p (4,).
    Returns qdot (3,).
    """
    phi = float(y[2])  # heading, from the fall line [rad]
    v = float(y[3])  # [m/s]
    phi_dot = float(y[4])  # phi' [rad/s]
    try:
        # from the state
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        qdot: list[float] = [
            # x' (I.2.4)
            c_phi * v,
            # y' (I.2.4)
            s_phi * v,
            # phi' (I.2.4)
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
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (5,), p (4,).
    Returns qddot (3,).
    """
    phi = float(y[2])  # heading, from the fall line [rad]
    v = float(y[3])  # [m/s]
    phi_dot = float(y[4])  # phi' [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the normal [kg*m^2]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    alpha = float(p[3])  # slope, 30 degrees [rad]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "accelerations")
        # from the parameters alone
        s_alpha = math.sin(alpha)
        k1 = g * s_alpha
        # from the state
        c_phi = math.cos(phi)
        z1 = c_phi * k1
        s_phi = math.sin(phi)
        z2 = phi_dot * v
        qddot: list[float] = [
            # x'' (I.2.15)
            c_phi * z1 - s_phi * z2,
            # y'' (I.2.15)
            s_phi * z1 + c_phi * z2,
            # phi'' (I.2.15)
            0.0,
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

    Arguments: t (scalar), q (3,), qdot (3,), p (4,).
    Returns y (5,).
    """
    x = float(q[0])  # down the slope [m]
    y_2 = float(q[1])  # y: across the slope [m]
    phi = float(q[2])  # heading, from the fall line [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    try:
        # from the coordinates and velocities
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        y: list[float] = [x, y_2, phi, x_dot * c_phi + y_dot * s_phi, phi_dot]
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

    Arguments: t (scalar), q (3,), qdot (3,), p (4,).
    Returns r (1,).
    """
    phi = float(q[2])  # heading, from the fall line [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    try:
        # from the coordinates and velocities
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        r: list[float] = [
            # slip = 0 (I.1.1) 18:5
            x_dot * s_phi - y_dot * c_phi,
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

    Arguments: t (scalar), y (5,), p (4,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # heading, from the fall line [rad]
    v = float(y[3])  # [m/s]
    phi_dot = float(y[4])  # phi' [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the normal [kg*m^2]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    alpha = float(p[3])  # slope, 30 degrees [rad]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "reactions")
        # the mass matrix is singular, if J is 0
        if not abs(J) > 0.0:
            raise _refuse(abs(J), 0.0, 2, "reactions")
        # from the parameters alone
        s_alpha = math.sin(alpha)
        k1 = g * s_alpha
        # from the state
        s_phi = math.sin(phi)
        lambda_: list[float] = [
            # reaction of slip: Q_i gains lambda_1 a_1i (I.4.1) 18:5
            -m * (phi_dot * v + s_phi * k1),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (5,), p (4,).
    Returns a scalar.
    """
    x = float(y[0])  # down the slope [m]
    v = float(y[3])  # [m/s]
    phi_dot = float(y[4])  # phi' [rad/s]
    m = float(p[0])  # mass [kg]
    J = float(p[1])  # moment of inertia about the normal [kg*m^2]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    alpha = float(p[3])  # slope, 30 degrees [rad]
    try:
        # from the parameters alone
        s_alpha = math.sin(alpha)
        k1 = g * s_alpha
        # from the state
        s1 = 0.5 * (J * (phi_dot * phi_dot))
        value1 = s1 + m * (0.5 * (v * v) - x * k1)
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (5,), p (4,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # heading, from the fall line [rad]
    v = float(y[3])  # [m/s]
    m = float(p[0])  # mass [kg]
    J_2 = float(p[1])  # J: moment of inertia about the normal [kg*m^2]
    g = float(p[2])  # acceleration of gravity [m/s^2]
    alpha = float(p[3])  # slope, 30 degrees [rad]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # the mass matrix is singular, if J_2 is 0
        if not abs(J_2) > 0.0:
            raise _refuse(abs(J_2), 0.0, 2, "jacobian")
        # from the parameters alone
        s_alpha = math.sin(alpha)
        k1 = -g * s_alpha
        # from the state
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -s_phi * v,
            # (I.2.15)
            c_phi,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_phi * v,
            # (I.2.15)
            s_phi,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            # (I.2.15)
            s_phi * k1,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k2 : k2 + 5] for k2 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (4,).
    Returns out (1,).
    """
    v = float(y[3])  # [m/s]
    try:
        # from the state
        out: list[float] = [
            # speed 20:10
            v,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
