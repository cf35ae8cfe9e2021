"""free_rigid_body, emitted by nhc 0.1.0 (nhc:101c61649f69419b).

A free rigid body; the components of its angular velocity on body axes are the
    quasi-velocities.
Equations of motion: euler-lagrange (I.2.14)
Why: quasi-velocities of the spec

State y:
y[0] = phi [rad]: precession
y[1] = theta [rad]: nutation
y[2] = psi [rad]: spin
y[3] = w1 [rad/s]
y[4] = w2 [rad/s]
y[5] = w3 [rad/s]

Parameters p:
p[0]: I1 = 1.0 [kg*m^2]
p[1]: I2 = 2.0 [kg*m^2]
p[2]: I3 = 3.0 [kg*m^2]

Outputs:
out[0] = L_squared [kg^2*m^4/s^2]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 6 +-, 11 *, 4 /, 4 calls
velocities: 3 +-, 5 *, 1 /, 4 calls
accelerations: 15 +-, 29 *, 4 /, 4 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 0 *, 0 /, 1 calls
energy: 2 +-, 7 *, 0 /, 0 calls
jacobian: 6 +-, 20 *, 4 /, 4 calls
outputs: 2 +-, 9 *, 0 /, 1 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("phi", "theta", "psi")
STATE: tuple[str, ...] = ("phi", "theta", "psi", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("I1", "I2", "I3")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("L_squared",)
DEFAULTS: tuple[float, ...] = (1.0, 2.0, 3.0)

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
    """Right-hand side dy/dt = f(t, y; p) (I.2.14).

    Arguments: t (scalar), y (6,), p (3,).
    Returns dydt (6,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "rhs")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I2 is 0
        if not abs(I2) > 0.0:
            raise _refuse(abs(I2), 0.0, 2, "rhs")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = (I2 - I3) / I1
        k2 = -(I1 - I3) / I2
        k3 = (I1 - I2) / I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "rhs")
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z1 = (c_psi * w2 + s_psi * w1) / s_theta
        c_theta = math.cos(theta)
        dydt: list[float] = [
            # phi' (I.2.4)
            z1,
            # theta' (I.2.4)
            c_psi * w1 - s_psi * w2,
            # psi' (I.2.4)
            w3 - c_theta * z1,
            # w1' (I.2.14) 18:4
            w2 * w3 * k1,
            # w2' (I.2.14) 18:4
            w1 * w3 * k2,
            # w3' (I.2.14) 18:4
            w1 * w2 * k3,
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

    Arguments: t (scalar), y (6,), p (3,).
    Returns qdot (3,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "velocities")
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z1 = (c_psi * w2 + s_psi * w1) / s_theta
        c_theta = math.cos(theta)
        qdot: list[float] = [
            # phi' (I.2.4)
            z1,
            # theta' (I.2.4)
            c_psi * w1 - s_psi * w2,
            # psi' (I.2.4)
            w3 - c_theta * z1,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All accelerations q'' on the motion (I.2.14).

    Arguments: t (scalar), y (6,), p (3,).
    Returns qddot (3,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "accelerations")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I2 is 0
        if not abs(I2) > 0.0:
            raise _refuse(abs(I2), 0.0, 2, "accelerations")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = (I2 - I3) / I1
        k2 = (I1 - I3) / I2
        k3 = (I1 - I2) / I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "accelerations")
        z1 = 1.0 / s_theta
        s_psi = math.sin(psi)
        c_psi = math.cos(psi)
        z2 = s_psi * w2 - c_psi * w1
        c_theta = math.cos(theta)
        z3 = c_psi * w2 + s_psi * w1
        z4 = w3 - c_theta * (z3 * z1)
        z5 = s_psi * z4
        z6 = w1 * w3 * k2
        z7 = c_psi * z4
        z8 = w2 * w3 * k1
        s1 = z1 * (w2 * z5 + c_psi * z6 - (w1 * z7 + s_psi * z8))
        z9 = z1 * z1 * (z2 * (c_theta * z3)) - s1
        qddot: list[float] = [
            # phi'' (I.2.14)
            z9,
            # theta'' (I.2.14)
            -(w2 * z7 - s_psi * z6 + (w1 * z5 - c_psi * z8)),
            # psi'' (I.2.14)
            w1 * w2 * k3 - (z3 * z2 + c_theta * z9),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns y (6,).
    """
    phi = float(q[0])  # precession [rad]
    theta = float(q[1])  # nutation [rad]
    psi = float(q[2])  # spin [rad]
    phi_dot = float(qdot[0])  # phi' [rad/s]
    theta_dot = float(qdot[1])  # theta' [rad/s]
    psi_dot = float(qdot[2])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        s_theta = math.sin(theta)
        z1 = phi_dot * s_theta
        s_psi = math.sin(psi)
        c_psi = math.cos(psi)
        c_theta = math.cos(theta)
        y: list[float] = [
            phi,
            theta,
            psi,
            z1 * s_psi + theta_dot * c_psi,
            z1 * c_psi - theta_dot * s_psi,
            psi_dot + phi_dot * c_theta,
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
    theta = float(y[1])  # nutation [rad]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "reactions")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I2 is 0
        if not abs(I2) > 0.0:
            raise _refuse(abs(I2), 0.0, 2, "reactions")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "reactions")
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (6,), p (3,).
    Returns a scalar.
    """
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the state
        value1 = 0.5 * (I3 * (w3 * w3) + (I1 * (w1 * w1) + I2 * (w2 * w2)))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.14).

    Arguments: t (scalar), y (6,), p (3,).
    Returns rows (6, 6): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "jacobian")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I2 is 0
        if not abs(I2) > 0.0:
            raise _refuse(abs(I2), 0.0, 2, "jacobian")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = (I2 - I3) / I1
        k2 = -(I1 - I3) / I2
        k3 = (I1 - I2) / I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "jacobian")
        z1 = 1.0 / s_theta
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z2 = c_psi * w2 + s_psi * w1
        z3 = z1 * z1 * (c_theta * z2)
        z4 = z1 * (s_psi * w2 - c_psi * w1)
        z5 = s_psi * z1
        z6 = c_psi * z1
        J: list[float] = [
            0.0,
            # (I.2.14)
            -z3,
            # (I.2.14)
            -z4,
            # (I.2.14)
            z5,
            # (I.2.14)
            z6,
            0.0,
            0.0,
            0.0,
            # (I.2.14)
            -z2,
            # (I.2.14)
            c_psi,
            # (I.2.14)
            -s_psi,
            0.0,
            0.0,
            # (I.2.14)
            z2 + c_theta * z3,
            # (I.2.14)
            c_theta * z4,
            # (I.2.14)
            -c_theta * z5,
            # (I.2.14)
            -c_theta * z6,
            # (I.2.14)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.14)
            w3 * k1,
            # (I.2.14)
            w2 * k1,
            0.0,
            0.0,
            0.0,
            # (I.2.14)
            w3 * k2,
            0.0,
            # (I.2.14)
            w1 * k2,
            0.0,
            0.0,
            0.0,
            # (I.2.14)
            w2 * k3,
            # (I.2.14)
            w1 * k3,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k4 : k4 + 6] for k4 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (6,), p (3,).
    Returns out (1,).
    """
    theta = float(y[1])  # nutation [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    w3 = float(y[5])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 * I1
        k2 = I2 * I2
        k3 = I3 * I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "outputs")
        out: list[float] = [
            # L_squared 24:14
            w3 * w3 * k3 + (w1 * w1 * k1 + w2 * w2 * k2),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
