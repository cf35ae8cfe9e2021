"""suslov, emitted by nhc 0.1.0 (nhc:668069c421086a16).

A rigid body with a fixed point that must not turn about one of its own axes.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = phi [rad]: precession
y[1] = theta [rad]: nutation
y[2] = psi [rad]: spin
y[3] = w1 [rad/s]
y[4] = w2 [rad/s]

Parameters p:
p[0]: I11 = 1.0 [kg*m^2]
p[1]: I22 = 1.6 [kg*m^2]
p[2]: I33 = 2.0 [kg*m^2]
p[3]: I13 = 0.3 [kg*m^2]
p[4]: I23 = -0.2 [kg*m^2]

Constraints, with the units of their reactions:
0: no_spin [N*m]

Outputs:
out[0] = M3 [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 3 +-, 11 *, 3 /, 4 calls
velocities: 2 +-, 5 *, 1 /, 4 calls
accelerations: 11 +-, 30 *, 3 /, 4 calls
state: 2 +-, 5 *, 0 /, 3 calls
residuals: 1 +-, 1 *, 0 /, 1 calls
reactions: 4 +-, 8 *, 2 /, 1 calls
energy: 1 +-, 5 *, 0 /, 0 calls
jacobian: 6 +-, 22 *, 3 /, 4 calls
outputs: 1 +-, 2 *, 0 /, 1 calls

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
STATE: tuple[str, ...] = ("phi", "theta", "psi", "w1", "w2")
PARAMETERS: tuple[str, ...] = ("I11", "I22", "I33", "I13", "I23")
CONSTRAINTS: tuple[str, ...] = ("no_spin",)
OUTPUTS: tuple[str, ...] = ("M3",)
DEFAULTS: tuple[float, ...] = (1.0, 1.6, 2.0, 0.3, -0.2)

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

    Arguments: t (scalar), y (5,), p (5,).
    Returns dydt (5,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I11 = float(p[0])  # [kg*m^2]
    I22 = float(p[1])  # [kg*m^2]
    I13 = float(p[3])  # [kg*m^2]
    I23 = float(p[4])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I11 is 0
        if not abs(I11) > 0.0:
            raise _refuse(abs(I11), 0.0, 2, "rhs")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I22 is 0
        if not abs(I22) > 0.0:
            raise _refuse(abs(I22), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = -1.0 / I11
        k2 = 1.0 / I22
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "rhs")
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z1 = (c_psi * w2 + s_psi * w1) / s_theta
        c_theta = math.cos(theta)
        z2 = I13 * w1 + I23 * w2
        dydt: list[float] = [
            # phi' (I.2.4)
            z1,
            # theta' (I.2.4)
            c_psi * w1 - s_psi * w2,
            # psi' (I.2.4)
            -c_theta * z1,
            # w1' (I.2.15) 20:4
            w2 * z2 * k1,
            # w2' (I.2.15) 20:4
            w1 * z2 * k2,
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

    Arguments: t (scalar), y (5,), p (5,).
    Returns qdot (3,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
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
            -c_theta * z1,
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

    Arguments: t (scalar), y (5,), p (5,).
    Returns qddot (3,).
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I11 = float(p[0])  # [kg*m^2]
    I22 = float(p[1])  # [kg*m^2]
    I13 = float(p[3])  # [kg*m^2]
    I23 = float(p[4])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I11 is 0
        if not abs(I11) > 0.0:
            raise _refuse(abs(I11), 0.0, 2, "accelerations")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I22 is 0
        if not abs(I22) > 0.0:
            raise _refuse(abs(I22), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = 1.0 / I11
        k2 = 1.0 / I22
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "accelerations")
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        z1 = c_psi * w2 + s_psi * w1
        c_theta = math.cos(theta)
        z2 = s_psi * w2 - c_psi * w1
        z3 = 1.0 / s_theta
        z4 = z1 * z3
        z5 = c_theta * z4
        z6 = s_psi * z5
        z7 = I13 * w1 + I23 * w2
        z8 = w1 * z7 * k2
        z9 = c_psi * z5
        z10 = w2 * z7 * k1
        s1 = z3 * (w2 * z6 + c_psi * z8 - (w1 * z9 + s_psi * z10))
        z11 = z1 * (c_theta * z2 * (z3 * z3)) + s1
        qddot: list[float] = [
            # phi'' (I.2.15)
            z11,
            # theta'' (I.2.15)
            w2 * z9 - s_psi * z8 + (w1 * z6 - c_psi * z10),
            # psi'' (I.2.15)
            -(z4 * (s_theta * z2) + c_theta * z11),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (5,).
    Returns y (5,).
    """
    phi = float(q[0])  # precession [rad]
    theta = float(q[1])  # nutation [rad]
    psi = float(q[2])  # spin [rad]
    phi_dot = float(qdot[0])  # phi' [rad/s]
    theta_dot = float(qdot[1])  # theta' [rad/s]
    try:
        # from the coordinates and velocities
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        s_theta = math.sin(theta)
        z1 = phi_dot * s_theta
        y: list[float] = [
            phi,
            theta,
            psi,
            theta_dot * c_psi + s_psi * z1,
            c_psi * z1 - theta_dot * s_psi,
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

    Arguments: t (scalar), q (3,), qdot (3,), p (5,).
    Returns r (1,).
    """
    theta = float(q[1])  # nutation [rad]
    phi_dot = float(qdot[0])  # phi' [rad/s]
    psi_dot = float(qdot[2])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        c_theta = math.cos(theta)
        r: list[float] = [
            # no_spin = 0 (I.1.1) 22:5
            psi_dot + phi_dot * c_theta,
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

    Arguments: t (scalar), y (5,), p (5,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta = float(y[1])  # nutation [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I11 = float(p[0])  # [kg*m^2]
    I22 = float(p[1])  # [kg*m^2]
    I13 = float(p[3])  # [kg*m^2]
    I23 = float(p[4])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I11 is 0
        if not abs(I11) > 0.0:
            raise _refuse(abs(I11), 0.0, 2, "reactions")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I22 is 0
        if not abs(I22) > 0.0:
            raise _refuse(abs(I22), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = I11 - I22
        k2 = I13 / I11
        k3 = I23 / I22
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "reactions")
        z1 = I13 * w1 + I23 * w2
        lambda_: list[float] = [
            # reaction of no_spin: Q_i gains lambda_1 a_1i (I.4.1) 22:5
            -(w1 * w2 * k1 + (w2 * z1 * k2 - w1 * z1 * k3)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (5,), p (5,).
    Returns a scalar.
    """
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I11 = float(p[0])  # [kg*m^2]
    I22 = float(p[1])  # [kg*m^2]
    try:
        # from the state
        value1 = 0.5 * (I11 * (w1 * w1) + I22 * (w2 * w2))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (5,), p (5,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I11 = float(p[0])  # [kg*m^2]
    I22 = float(p[1])  # [kg*m^2]
    I13 = float(p[3])  # [kg*m^2]
    I23 = float(p[4])  # [kg*m^2]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I11 is 0
        if not abs(I11) > 0.0:
            raise _refuse(abs(I11), 0.0, 2, "jacobian")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if I22 is 0
        if not abs(I22) > 0.0:
            raise _refuse(abs(I22), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = 1.0 / I11
        k2 = 1.0 / I22
        k3 = -I13 * k1
        k4 = I23 * k2
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
        z7 = I23 * w2
        z8 = I13 * w1
        z9 = z8 + z7
        J: list[float] = [
            0.0,
            # (I.2.15)
            -z3,
            # (I.2.15)
            -z4,
            # (I.2.15)
            z5,
            # (I.2.15)
            z6,
            0.0,
            0.0,
            # (I.2.15)
            -z2,
            # (I.2.15)
            c_psi,
            # (I.2.15)
            -s_psi,
            0.0,
            # (I.2.15)
            z2 + c_theta * z3,
            # (I.2.15)
            c_theta * z4,
            # (I.2.15)
            -c_theta * z5,
            # (I.2.15)
            -c_theta * z6,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            w2 * k3,
            # (I.2.15)
            -k1 * (z7 + z9),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            k2 * (z8 + z9),
            # (I.2.15)
            w1 * k4,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 5] for k5 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (5,).
    Returns out (1,).
    """
    theta = float(y[1])  # nutation [rad]
    w1 = float(y[3])  # [rad/s]
    w2 = float(y[4])  # [rad/s]
    I13 = float(p[3])  # [kg*m^2]
    I23 = float(p[4])  # [kg*m^2]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "outputs")
        out: list[float] = [
            # M3 28:7
            I13 * w1 + I23 * w2,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
