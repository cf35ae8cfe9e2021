# ruff: noqa: E741
"""ball_on_table, emitted by nhc 0.1.0 (nhc:bac903fe9a622cdd).

A homogeneous ball that rolls on a turning table; its centre runs on a circle,
    though nothing holds it there.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): the affine
    part b_alpha of the constraints contains the dependent coordinates `x`, `y`
Note: hypothesis of I.3 that fails (the generalized equations are used): the
    constraints are not homogeneous (b_alpha is not zero)
Note: hypothesis of I.3 that fails (the generalized equations are used): the time t
    occurs in T, U or the constraints

State y:
y[0] = x [m]: centre
y[1] = y [m]: centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = phi' [rad/s]
y[6] = theta' [rad/s]
y[7] = psi' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: a = 0.3 [m]: radius
p[2]: k = 0.4: moment of inertia over m a^2; 2/5 for a homogeneous ball
p[3]: Omega0 = 1.4 [rad/s]: mean rate of the table
p[4]: Omega1 = 0.0 [rad/s]: amplitude of its modulation
p[5]: nu = 2.0 [rad/s]: frequency of its modulation

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]

Outputs:
out[0] = spin [rad/s]
out[1] = moving_energy [J]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 17 +-, 40 *, 3 /, 6 calls
velocities: 5 +-, 11 *, 0 /, 4 calls
accelerations: 20 +-, 47 *, 3 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 7 +-, 11 *, 0 /, 4 calls
reactions: 9 +-, 26 *, 1 /, 5 calls
energy: 10 +-, 23 *, 0 /, 5 calls
jacobian: 18 +-, 64 *, 3 /, 6 calls
outputs: 11 +-, 23 *, 0 /, 3 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "phi", "theta", "psi")
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "psi", "phi'", "theta'", "psi'")
PARAMETERS: tuple[str, ...] = ("m", "a", "k", "Omega0", "Omega1", "nu")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("spin", "moving_energy")
DEFAULTS: tuple[float, ...] = (1.0, 0.3, 0.4, 1.4, 0.0, 2.0)

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

    Arguments: t (scalar), y (8,), p (6,).
    Returns dydt (8,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        k1 = m * a * a
        # the mass matrix is singular, if k * k1 is 0
        if not abs(k * k1) > 0.0:
            raise _refuse(abs(k * k1), 0.0, 2, "rhs")
        k2 = 1.0 + k
        k3 = k1 * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "rhs")
        k4 = Omega1 * nu
        k5 = 1.0 / k2
        k6 = 1.0 / a
        # from the state
        s_theta = math.sin(theta)
        # the mass matrix is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-07 * 4.0:
            raise _refuse(abs(s_theta), 1e-07 * 4.0, 2, "rhs")
        z1 = t_ * nu
        s1 = math.sin(z1)
        Omega = Omega0 + Omega1 * s1
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z2 = psi_dot * s_theta
        z3 = 1.0 / s_theta
        c_theta = math.cos(theta)
        z4 = Omega * Omega
        c1 = math.cos(z1)
        z5 = c1 * k4
        z6 = c_phi * z4 - s_phi * z5
        z7 = s_phi * z4 + c_phi * z5
        z8 = k5 * (theta_dot * Omega - k6 * (x * z6 + y_2 * z7))
        s2 = theta_dot * psi_dot - c_theta * (phi_dot * theta_dot + z8)
        dydt: list[float] = [
            # x' (I.1.2)
            a * (theta_dot * s_phi - c_phi * z2) - y_2 * Omega,
            # y' (I.1.2)
            x * Omega - a * (theta_dot * c_phi + s_phi * z2),
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # psi' (I.1.2)
            psi_dot,
            # phi'' (III.3) 25:4
            z3 * s2,
            # theta'' (III.3) 25:4
            -(k5 * (Omega * z2 - k6 * (x * z7 - y_2 * z6)) + phi_dot * z2),
            # psi'' (III.3) 25:4
            z3 * (theta_dot * (phi_dot - psi_dot * c_theta) + z8),
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

    Arguments: t (scalar), y (8,), p (6,).
    Returns qdot (5,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    a = float(p[1])  # radius [m]
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the state
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        qdot: list[float] = [
            # x' (I.1.2)
            a * (theta_dot * s_phi - c_phi * z1) - y_2 * Omega,
            # y' (I.1.2)
            x * Omega - a * (theta_dot * c_phi + s_phi * z1),
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # psi' (I.1.2)
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
    """All accelerations q'' on the motion (III.3).

    Arguments: t (scalar), y (8,), p (6,).
    Returns qddot (5,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        k1 = m * a * a
        # the mass matrix is singular, if k * k1 is 0
        if not abs(k * k1) > 0.0:
            raise _refuse(abs(k * k1), 0.0, 2, "accelerations")
        k2 = 1.0 + k
        k3 = k1 * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "accelerations")
        k4 = Omega1 * nu
        k5 = 1.0 / k2
        k6 = 1.0 / a
        k7 = 1.0 - k5
        k8 = a * k7
        # from the state
        s_theta = math.sin(theta)
        # the mass matrix is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-07 * 4.0:
            raise _refuse(abs(s_theta), 1e-07 * 4.0, 2, "accelerations")
        z1 = t_ * nu
        s1 = math.sin(z1)
        Omega = Omega0 + Omega1 * s1
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z2 = psi_dot * s_theta
        z3 = x * k7
        c1 = math.cos(z1)
        z4 = c1 * k4
        z5 = y_2 * k7
        z6 = 1.0 / s_theta
        c_theta = math.cos(theta)
        z7 = Omega * Omega
        z8 = c_phi * z7 - s_phi * z4
        z9 = s_phi * z7 + c_phi * z4
        z10 = k5 * (theta_dot * Omega - k6 * (x * z8 + y_2 * z9))
        s2 = Omega * ((theta_dot * c_phi + s_phi * z2) * k8 - Omega * z3)
        s3 = Omega * ((theta_dot * s_phi - c_phi * z2) * k8 - Omega * z5)
        s4 = theta_dot * psi_dot - c_theta * (phi_dot * theta_dot + z10)
        qddot: list[float] = [
            # x'' (III.3)
            s2 - z4 * z5,
            # y'' (III.3)
            s3 + z4 * z3,
            # phi'' (III.3)
            z6 * s4,
            # theta'' (III.3)
            -(k5 * (Omega * z2 - k6 * (x * z9 - y_2 * z8)) + phi_dot * z2),
            # psi'' (III.3)
            z6 * (theta_dot * (phi_dot - psi_dot * c_theta) + z10),
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

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns y (8,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # y: centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, phi, theta, psi, phi_dot, theta_dot, psi_dot]
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

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns r (2,).
    """
    t_ = float(t)  # t: time
    x = float(q[0])  # centre [m]
    y = float(q[1])  # centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    a = float(p[1])  # radius [m]
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the coordinates and velocities
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        r: list[float] = [
            # roll_x = 0 (I.1.1) 27:5
            y * Omega + (x_dot - a * (theta_dot * s_phi - c_phi * z1)),
            # roll_y = 0 (I.1.1) 28:5
            y_dot + a * (theta_dot * c_phi + s_phi * z1) - x * Omega,
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

    Arguments: t (scalar), y (8,), p (6,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        k1 = m * a * a
        # the mass matrix is singular, if k * k1 is 0
        if not abs(k * k1) > 0.0:
            raise _refuse(abs(k * k1), 0.0, 2, "reactions")
        k2 = 1.0 + k
        k3 = k1 * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "reactions")
        k4 = Omega1 * nu
        k5 = 1.0 - 1.0 / k2
        k6 = a * k5
        # from the state
        s_theta = math.sin(theta)
        # the mass matrix is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-07 * 4.0:
            raise _refuse(abs(s_theta), 1e-07 * 4.0, 2, "reactions")
        z1 = t_ * nu
        s1 = math.sin(z1)
        Omega = Omega0 + Omega1 * s1
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z2 = psi_dot * s_theta
        z3 = x * k5
        c1 = math.cos(z1)
        z4 = c1 * k4
        z5 = y_2 * k5
        s2 = Omega * ((theta_dot * c_phi + s_phi * z2) * k6 - Omega * z3)
        s3 = Omega * ((theta_dot * s_phi - c_phi * z2) * k6 - Omega * z5)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            m * (s2 - z4 * z5),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            m * (s3 + z4 * z3),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (8,), p (6,).
    Returns a scalar.
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        I = m * k * a * a
        # from the state
        c_theta = math.cos(theta)
        omega_z = phi_dot + psi_dot * c_theta
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        omega_x = theta_dot * c_phi + s_phi * z1
        omega_y = theta_dot * s_phi - c_phi * z1
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        z2 = y_2 * Omega - a * omega_y
        z3 = x * Omega - a * omega_x
        s2 = omega_z * omega_z + (omega_x * omega_x + omega_y * omega_y)
        z4 = I * s2 + m * (z2 * z2 + z3 * z3)
        value1 = 0.5 * z4
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

    Arguments: t (scalar), y (8,), p (6,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        k1 = m * a * a
        # the mass matrix is singular, if k * k1 is 0
        if not abs(k * k1) > 0.0:
            raise _refuse(abs(k * k1), 0.0, 2, "jacobian")
        k2 = 1.0 + k
        k3 = k1 * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "jacobian")
        k4 = Omega1 * nu
        k5 = 1.0 / k2
        k6 = 1.0 / a
        k7 = k5 * k6
        # from the state
        s_theta = math.sin(theta)
        # the mass matrix is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-07 * 4.0:
            raise _refuse(abs(s_theta), 1e-07 * 4.0, 2, "jacobian")
        z1 = t_ * nu
        s1 = math.sin(z1)
        Omega = Omega0 + Omega1 * s1
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z2 = s_theta * s_phi
        c_theta = math.cos(theta)
        z3 = psi_dot * c_theta
        z4 = a * c_phi
        z5 = a * s_phi
        z6 = c_phi * s_theta
        z7 = 1.0 / s_theta
        z8 = c_theta * z7
        z9 = Omega * Omega
        c1 = math.cos(z1)
        z10 = c1 * k4
        z11 = c_phi * z9 - s_phi * z10
        z12 = z11 * k7
        z13 = s_phi * z9 + c_phi * z10
        z14 = z13 * k7
        z15 = (x * z13 - y_2 * z11) * k7
        z16 = k6 * (x * z11 + y_2 * z13)
        z17 = k5 * (theta_dot * Omega - z16)
        z18 = phi_dot * theta_dot + z17
        z19 = theta_dot * psi_dot
        z20 = c_theta * (z7 * z7)
        z21 = theta_dot * z8
        z22 = Omega * k5
        z23 = phi_dot + z22
        z24 = theta_dot * z7
        z25 = phi_dot - z3
        J: list[float] = [
            0.0,
            # (III.3)
            -Omega,
            # (III.3)
            a * (theta_dot * c_phi + psi_dot * z2),
            # (III.3)
            -z3 * z4,
            0.0,
            0.0,
            # (III.3)
            z5,
            # (III.3)
            -a * z6,
            # (III.3)
            Omega,
            0.0,
            # (III.3)
            a * (theta_dot * s_phi - psi_dot * z6),
            # (III.3)
            -z3 * z5,
            0.0,
            0.0,
            # (III.3)
            -z4,
            # (III.3)
            -a * z2,
            0.0,
            0.0,
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
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            z8 * z12,
            # (III.3)
            z8 * z14,
            # (III.3)
            -z8 * z15,
            # (III.3)
            z18 - (z19 - c_theta * z18) * z20,
            0.0,
            # (III.3)
            -z21,
            # (III.3)
            z7 * (psi_dot - c_theta * z23),
            # (III.3)
            z24,
            # (III.3)
            z14,
            # (III.3)
            -z12,
            # (III.3)
            k5 * z16,
            # (III.3)
            -z3 * z23,
            0.0,
            # (III.3)
            -psi_dot * s_theta,
            0.0,
            # (III.3)
            -s_theta * z23,
            # (III.3)
            -z7 * z12,
            # (III.3)
            -z7 * z14,
            # (III.3)
            z7 * z15,
            # (III.3)
            z19 - (theta_dot * z25 + z17) * z20,
            0.0,
            # (III.3)
            z24,
            # (III.3)
            z7 * (z25 + z22),
            # (III.3)
            -z21,
        ]
        _finish("jacobian", J)
        return [J[k8 : k8 + 8] for k8 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (8,), p (6,).
    Returns out (2,).
    """
    t_ = float(t)  # t: time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # y: centre [m]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # from the parameters alone
        k1 = a * a
        # from the state
        c_theta = math.cos(theta)
        z1 = psi_dot * c_theta
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        z2 = theta_dot * theta_dot
        s_theta = math.sin(theta)
        s2 = 0.5 * z2 + psi_dot * (0.5 * psi_dot - Omega * c_theta)
        z3 = s2 - phi_dot * (Omega - (0.5 * phi_dot + z1))
        s3 = 0.5 * (z2 + s_theta * s_theta * (psi_dot * psi_dot))
        s4 = 0.5 * (Omega * Omega * (x * x + y_2 * y_2))
        z4 = s4 - k1 * (s3 + k * z3)
        out: list[float] = [
            # spin 31:9
            phi_dot + z1,
            # moving_energy 32:18
            -m * z4,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
