"""heavy_top, emitted by nhc 0.1.0 (nhc:b3a05b73a1eafb55).

The symmetric top with a fixed point (Lagrange's top).
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = phi [rad]: precession
y[1] = theta [rad]: nutation
y[2] = psi [rad]: spin
y[3] = phi' [rad/s]
y[4] = theta' [rad/s]
y[5] = psi' [rad/s]

Parameters p:
p[0]: I1 = 1.0 [kg*m^2]: across the axis, at the fixed point
p[1]: I3 = 1.5 [kg*m^2]: about the axis
p[2]: mgl = 2.0 [N*m]: weight times the distance of the centre of mass

Outputs:
out[0] = p_phi [kg*m^2/s]
out[1] = p_psi [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 5 +-, 13 *, 2 /, 2 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 5 +-, 13 *, 2 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 0 +-, 2 *, 0 /, 1 calls
energy: 4 +-, 10 *, 0 /, 2 calls
jacobian: 14 +-, 33 *, 2 /, 2 calls
outputs: 2 +-, 6 *, 0 /, 2 calls

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
STATE: tuple[str, ...] = ("phi", "theta", "psi", "phi'", "theta'", "psi'")
PARAMETERS: tuple[str, ...] = ("I1", "I3", "mgl")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("p_phi", "p_psi")
DEFAULTS: tuple[float, ...] = (1.0, 1.5, 2.0)

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
    theta = float(y[1])  # nutation [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    theta_dot = float(y[4])  # theta' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "rhs")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = 1.0 / I1
        k2 = I3 * k1
        k3 = mgl * k1
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * s1 is 0
        if not abs(I1 * s1) > 0.0:
            raise _refuse(abs(I1 * s1), 0.0, 2, "rhs")
        c_theta = math.cos(theta)
        z1 = phi_dot * c_theta
        z2 = (psi_dot + z1) * k2
        z3 = theta_dot / s_theta * (2.0 * z1 - z2)
        dydt: list[float] = [
            # phi' (II.3)
            phi_dot,
            # theta' (II.3)
            theta_dot,
            # psi' (II.3)
            psi_dot,
            # phi'' (II.3) 16:4
            -z3,
            # theta'' (II.3) 16:4
            s_theta * (k3 + phi_dot * (z1 - z2)),
            # psi'' (II.3) 16:4
            s_theta * (phi_dot * theta_dot) + c_theta * z3,
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
    phi_dot = float(y[3])  # phi' [rad/s]
    theta_dot = float(y[4])  # theta' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    try:
        # from the state
        qdot: list[float] = [
            # phi'
            phi_dot,
            # theta'
            theta_dot,
            # psi'
            psi_dot,
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
    theta = float(y[1])  # nutation [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    theta_dot = float(y[4])  # theta' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "accelerations")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = 1.0 / I1
        k2 = I3 * k1
        k3 = mgl * k1
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * s1 is 0
        if not abs(I1 * s1) > 0.0:
            raise _refuse(abs(I1 * s1), 0.0, 2, "accelerations")
        c_theta = math.cos(theta)
        z1 = phi_dot * c_theta
        z2 = (psi_dot + z1) * k2
        z3 = theta_dot / s_theta * (2.0 * z1 - z2)
        qddot: list[float] = [
            # phi'' (II.3)
            -z3,
            # theta'' (II.3)
            s_theta * (k3 + phi_dot * (z1 - z2)),
            # psi'' (II.3)
            s_theta * (phi_dot * theta_dot) + c_theta * z3,
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
    phi = float(q[0])  # precession [rad]
    theta = float(q[1])  # nutation [rad]
    psi = float(q[2])  # spin [rad]
    phi_dot = float(qdot[0])  # phi' [rad/s]
    theta_dot = float(qdot[1])  # theta' [rad/s]
    psi_dot = float(qdot[2])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [phi, theta, psi, phi_dot, theta_dot, psi_dot]
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
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "reactions")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "reactions")
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * s1 is 0
        if not abs(I1 * s1) > 0.0:
            raise _refuse(abs(I1 * s1), 0.0, 2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (6,), p (3,).
    Returns a scalar.
    """
    theta = float(y[1])  # nutation [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    theta_dot = float(y[4])  # theta' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        omega3 = psi_dot + phi_dot * c_theta
        s1 = s_theta * s_theta * (phi_dot * phi_dot)
        s2 = I1 * (theta_dot * theta_dot + s1) + I3 * (omega3 * omega3)
        z1 = 0.5 * s2 + mgl * c_theta
        value1 = z1
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
    theta = float(y[1])  # nutation [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    theta_dot = float(y[4])  # theta' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    mgl = float(p[2])  # weight times the distance of the centre of mass [N*m]
    try:
        # the mass matrix is singular, if I1 is 0
        if not abs(I1) > 0.0:
            raise _refuse(abs(I1), 0.0, 2, "jacobian")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = 1.0 / I1
        k2 = I3 * k1
        k3 = mgl * k1
        k4 = 2.0 - k2
        # from the state
        s_theta = math.sin(theta)
        s1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * s1 is 0
        if not abs(I1 * s1) > 0.0:
            raise _refuse(abs(I1 * s1), 0.0, 2, "jacobian")
        c_theta = math.cos(theta)
        z1 = phi_dot * c_theta
        z2 = (psi_dot + z1) * k2
        z3 = 2.0 * z1 - z2
        z4 = 1.0 / s_theta
        z5 = theta_dot * z4
        z6 = phi_dot * s_theta
        z7 = z3 * (theta_dot * c_theta * (z4 * z4)) + z5 * (z6 * k4)
        z8 = z5 * (c_theta * k4)
        z9 = z4 * z3
        z10 = k2 * z5
        z11 = z1 - z2
        z12 = z6 * k2
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
            # (II.3)
            z7,
            0.0,
            # (II.3)
            -z8,
            # (II.3)
            -z9,
            # (II.3)
            z10,
            0.0,
            # (II.3)
            c_theta * (k3 + phi_dot * z11) - z6 * (z6 - z12),
            0.0,
            # (II.3)
            s_theta * (z11 + phi_dot * (c_theta - c_theta * k2)),
            0.0,
            # (II.3)
            -z12,
            0.0,
            # (II.3)
            theta_dot * z1 - (theta_dot * z3 + c_theta * z7),
            0.0,
            # (II.3)
            theta_dot * s_theta + c_theta * z8,
            # (II.3)
            z6 + c_theta * z9,
            # (II.3)
            -c_theta * z10,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 6] for k5 in range(0, 36, 6)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (6,), p (3,).
    Returns out (2,).
    """
    theta = float(y[1])  # nutation [rad]
    phi_dot = float(y[3])  # phi' [rad/s]
    psi_dot = float(y[5])  # psi' [rad/s]
    I1 = float(p[0])  # across the axis, at the fixed point [kg*m^2]
    I3 = float(p[1])  # about the axis [kg*m^2]
    try:
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        z1 = I3 * (psi_dot + phi_dot * c_theta)
        out: list[float] = [
            # p_phi 19:10
            phi_dot * (I1 * (s_theta * s_theta)) + c_theta * z1,
            # p_psi 20:10
            z1,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
