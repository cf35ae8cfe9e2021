# ruff: noqa: E741
"""ball_on_table, emitted by nhc 0.1.0 (nhc:32f296e355220656).

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
rhs: 16 +-, 42 *, 2 /, 6 calls
velocities: 5 +-, 11 *, 0 /, 4 calls
accelerations: 29 +-, 67 *, 2 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 7 +-, 11 *, 0 /, 4 calls
reactions: 24 +-, 55 *, 2 /, 6 calls
energy: 10 +-, 23 *, 0 /, 5 calls
jacobian: 29 +-, 113 *, 3 /, 6 calls
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
        k1 = m * a
        k2 = a * k1
        # the mass matrix is singular, if k * k2 is 0
        if not abs(k * k2) > 0.0:
            raise _refuse(abs(k * k2), 0.0, 2, "rhs")
        k3 = 1.0 + k
        k4 = Omega1 * nu
        k5 = k2 * k3
        # the mass matrix is singular, if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "rhs")
        k6 = -k1 / k5
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = z1 * k5
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * (k2 * (k + z1)):
            raise _refuse(abs(z2), 1e-13 * (k2 * (k + z1)), 2, "rhs")
        z3 = t_ * nu
        s1 = math.sin(z3)
        Omega = Omega0 + Omega1 * s1
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z4 = psi_dot * s_theta
        c_theta = math.cos(theta)
        z5 = Omega * Omega
        c1 = math.cos(z3)
        z6 = c1 * k4
        z7 = c_phi * z5 - s_phi * z6
        z8 = s_phi * z5 + c_phi * z6
        z9 = Omega + phi_dot * k3
        s2 = a * (theta_dot * (z9 - psi_dot * c_theta * k3))
        z10 = k1 * (x * z7 + y_2 * z8 - s2) / z2
        dydt: list[float] = [
            # x' (I.1.2)
            a * (theta_dot * s_phi - c_phi * z4) - y_2 * Omega,
            # y' (I.1.2)
            x * Omega - a * (theta_dot * c_phi + s_phi * z4),
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # psi' (I.1.2)
            psi_dot,
            # phi'' (III.3) 25:4
            s_theta * (theta_dot * psi_dot + c_theta * z10),
            # theta'' (III.3) 25:4
            (a * (z4 * z9) - (x * z8 - y_2 * z7)) * k6,
            # psi'' (III.3) 25:4
            -s_theta * z10,
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
        k1 = m * a
        k2 = m * a * a
        k3 = k * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "accelerations")
        k4 = 1.0 + k
        k5 = k2 * k4
        # the mass matrix is singular, if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "accelerations")
        k6 = Omega1 * nu
        k7 = k1 / k5
        # from the state
        s_theta = math.sin(theta)
        z1 = k2 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k3
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "accelerations")
        z3 = t_ * nu
        s1 = math.sin(z3)
        Omega = Omega0 + Omega1 * s1
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z4 = s_theta * s_phi
        c1 = math.cos(z3)
        z5 = c1 * k6
        z6 = phi_dot * c_phi
        z7 = Omega + phi_dot * k4
        z8 = Omega * Omega
        z9 = s_phi * z8 + c_phi * z5
        z10 = c_phi * z8 - s_phi * z5
        z11 = k7 * (a * (psi_dot * s_theta * z7) - (x * z9 - y_2 * z10))
        z12 = phi_dot * s_phi
        z13 = theta_dot * c_theta
        z14 = c_phi * s_theta
        s2 = a * (theta_dot * (z7 - psi_dot * c_theta * k4))
        z15 = (x * z10 + y_2 * z9 - s2) * (k1 / z2)
        z16 = s_theta * z15
        s3 = psi_dot * (s_theta * z12 - c_phi * z13) + z14 * z16
        z17 = a * (theta_dot * z6 - s_phi * z11 + s3)
        s4 = psi_dot * (s_phi * z13 + s_theta * z6) - z4 * z16
        z18 = a * (theta_dot * z12 + c_phi * z11 - s4)
        s5 = Omega * (a * (theta_dot * c_phi + psi_dot * z4) - x * Omega)
        s6 = a * (theta_dot * s_phi - psi_dot * z14) - y_2 * Omega
        qddot: list[float] = [
            # x'' (III.3)
            s5 - y_2 * z5 + z17,
            # y'' (III.3)
            Omega * s6 + x * z5 + z18,
            # phi'' (III.3)
            s_theta * (theta_dot * psi_dot + c_theta * z15),
            # theta'' (III.3)
            -z11,
            # psi'' (III.3)
            -z16,
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
        k1 = m * a
        k2 = m * a * a
        k3 = k * k2
        # the mass matrix is singular, if k3 is 0
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "reactions")
        k4 = 1.0 + k
        k5 = k2 * k4
        # the mass matrix is singular, if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "reactions")
        k6 = Omega1 * nu
        k7 = k1 / k5
        # from the state
        s_theta = math.sin(theta)
        z1 = k2 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k3
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "reactions")
        z3 = t_ * nu
        s1 = math.sin(z3)
        Omega = Omega0 + Omega1 * s1
        z4 = Omega * Omega
        c1 = math.cos(z3)
        z5 = c1 * k6
        c_phi = math.cos(phi)
        z6 = psi_dot * c_theta
        z7 = phi_dot + Omega
        z8 = theta_dot * (z6 - z7)
        s_phi = math.sin(phi)
        z9 = psi_dot * s_theta
        z10 = z9 * z7
        z11 = Omega + phi_dot * k4
        z12 = s_phi * z4 + c_phi * z5
        z13 = c_phi * z4 - s_phi * z5
        z14 = k7 * (a * (z9 * z11) - (x * z12 - y_2 * z13))
        z15 = c_phi * k1
        z16 = s_theta * k1
        s2 = x * z13 + y_2 * z12 - a * (theta_dot * (z11 - z6 * k4))
        z17 = s2 * (z16 / z2)
        s3 = m * (x * z4 + y_2 * z5 + a * (c_phi * z8 - s_phi * z10))
        z18 = s3 + (k1 * (s_phi * z14) - z15 * (s_theta * z17))
        s4 = m * (y_2 * z4 - x * z5 + a * (s_phi * z8 + c_phi * z10))
        z19 = s4 - (z14 * z15 + s_phi * z16 * z17)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            -z18,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            -z19,
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
        k1 = a * a
        I = m * k * k1
        k2 = m * a
        k3 = m * k1
        k4 = k * k3
        # the mass matrix is singular, if k4 is 0
        if not abs(k4) > 0.0:
            raise _refuse(abs(k4), 0.0, 2, "jacobian")
        k5 = 1.0 + k
        k6 = k3 * k5
        # the mass matrix is singular, if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "jacobian")
        k7 = Omega1 * nu
        k8 = 1.0 / k4
        k9 = 1.0 / k6
        k10 = k2 * k9
        k11 = -k5 * k10
        # from the state
        s_theta = math.sin(theta)
        z1 = k3 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k4
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "jacobian")
        z3 = t_ * nu
        s1 = math.sin(z3)
        Omega = Omega0 + Omega1 * s1
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z4 = s_theta * s_phi
        z5 = psi_dot * a
        z6 = c_theta * z5
        z7 = c_phi * s_theta
        z8 = Omega * Omega
        c1 = math.cos(z3)
        z9 = c1 * k7
        z10 = c_phi * z8 - s_phi * z9
        z11 = s_theta * k2
        z12 = 1.0 / z2
        z13 = z11 * z12
        z14 = z10 * z13
        z15 = s_phi * z8 + c_phi * z9
        z16 = z15 * z13
        z17 = y_2 * z11
        z18 = x * z11
        s2 = c_phi * (z8 * z17 - z9 * z18)
        z19 = z12 * (s2 - s_phi * (z8 * z18 + z9 * z17))
        z20 = theta_dot * psi_dot
        z21 = theta_dot * a
        z22 = Omega + phi_dot * k5
        z23 = psi_dot * c_theta
        z24 = x * z10 + y_2 * z15
        z25 = z21 * (z22 - z23 * k5) - z24
        z26 = z13 * z25
        z27 = s_theta * k4
        z28 = I * (c_theta * z20) + z26 * z27
        z29 = z21 * z11
        z30 = z23 - z22
        s3 = psi_dot * z29 + (z20 - k2 * (z25 * (c_theta * z12))) * z27
        s4 = k2 * (z24 + z21 * z30) + 2.0 * (k3 * (s_theta * z26))
        z31 = s_theta * s3 - c_theta * s4
        z32 = z12 * (z31 - c_theta * z28)
        z33 = k5 * (z12 * z29)
        z34 = c_theta * z33
        z35 = I * (psi_dot * s_theta)
        z36 = z12 * (a * (z11 * z30) + c_theta * z35)
        z37 = x * k2
        z38 = y_2 * k2
        z39 = k9 * (k2 * z22)
        s5 = c_phi * (z8 * z37 + z9 * z38)
        J: list[float] = [
            0.0,
            # (III.3)
            -Omega,
            # (III.3)
            a * (theta_dot * c_phi + psi_dot * z4),
            # (III.3)
            -c_phi * z6,
            0.0,
            0.0,
            # (III.3)
            a * s_phi,
            # (III.3)
            -a * z7,
            # (III.3)
            Omega,
            0.0,
            # (III.3)
            a * (theta_dot * s_phi - psi_dot * z7),
            # (III.3)
            -s_phi * z6,
            0.0,
            0.0,
            # (III.3)
            -a * c_phi,
            # (III.3)
            -a * z4,
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
            c_theta * z14,
            # (III.3)
            c_theta * z16,
            # (III.3)
            c_theta * z19,
            # (III.3)
            k8 * z28 - c_theta * z32,
            0.0,
            # (III.3)
            -z34,
            # (III.3)
            k8 * z35 + c_theta * z36,
            # (III.3)
            z33,
            # (III.3)
            k10 * z15,
            # (III.3)
            -k10 * z10,
            # (III.3)
            k9 * (s5 + s_phi * (z8 * z38 - z9 * z37)),
            # (III.3)
            -z39 * z6,
            0.0,
            # (III.3)
            s_theta * z5 * k11,
            0.0,
            # (III.3)
            -a * (s_theta * z39),
            # (III.3)
            -z14,
            # (III.3)
            -z16,
            # (III.3)
            -z19,
            # (III.3)
            z32,
            0.0,
            # (III.3)
            z33,
            # (III.3)
            -z36,
            # (III.3)
            -z34,
        ]
        _finish("jacobian", J)
        return [J[k12 : k12 + 8] for k12 in range(0, 64, 8)]
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
