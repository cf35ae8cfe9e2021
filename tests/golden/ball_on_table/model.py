# ruff: noqa: E741
"""ball_on_table, emitted by nhc 0.1.0 (nhc:f277ac4ddd1cd5fa).

A homogeneous ball that rolls on a turning table; its centre runs on a circle,
    though nothing holds it there.
Source: ball_on_table.yaml
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): the affine
    part b_alpha of the constraints contains the dependent coordinate `x`
Note: hypothesis of I.3 that fails (the generalized equations are used): the affine
    part b_alpha of the constraints contains the dependent coordinate `y`
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
y[5] = phi'
y[6] = theta'
y[7] = psi'

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: a = 0.3 [m]: radius
p[2]: k = 0.4: moment of inertia over m a^2; 2/5 for a homogeneous ball
p[3]: Omega0 = 1.4 [rad/s]: mean rate of the table
p[4]: Omega1 = 0.0 [rad/s]: amplitude of its modulation
p[5]: nu = 2.0 [rad/s]: frequency of its modulation

Constraints:
0: roll_x
1: roll_y

Outputs:
out[0] = spin
out[1] = moving_energy

Operations:
rhs: 25 +-, 57 *, 2 /, 6 calls
velocities: 5 +-, 12 *, 0 /, 4 calls
accelerations: 37 +-, 79 *, 2 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 7 +-, 12 *, 0 /, 4 calls
reactions: 36 +-, 76 *, 2 /, 6 calls
energy: 10 +-, 25 *, 0 /, 5 calls
jacobian: 40 +-, 136 *, 3 /, 6 calls
outputs: 15 +-, 29 *, 0 /, 3 calls

A singular point raises SingularModelError.
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
        super().__init__(f"{function}: {REASONS[status]}")
        self.status = status


def _finish(function: str, values: list[float]) -> list[float]:
    if not all(map(math.isfinite, values)):
        raise SingularModelError(NOT_FINITE, function)
    return values


def _single(function: str, value: float) -> float:
    if not math.isfinite(value):
        raise SingularModelError(NOT_FINITE, function)
    return value


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """right-hand side dy/dt = f(t, y; p) (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns dydt (8,).
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = k * k1
        k3 = 1.0 + k
        k4 = k1 * k3
        k5 = m * a
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = k5 / k4
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "rhs")
        # the mass matrix is singular
        if not abs(k4) > 0.0:
            raise SingularModelError(2, "rhs")
        s_theta = math.sin(theta)
        z1 = k1 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * (c_theta * k2)
        # the mass matrix is singular
        if not abs(z2) > 1e-14 * z1:
            raise SingularModelError(2, "rhs")
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z3 = t_ * nu
        s1 = math.sin(z3)
        z4 = Omega1 * s1
        Omega = Omega0 + z4
        z5 = 1.0 / z2
        z6 = k6 + z4
        z7 = x * c_phi
        z8 = y_2 * s_phi
        z9 = theta_dot * a
        c1 = math.cos(z3)
        z10 = nu * c1
        z11 = x * s_phi
        z12 = y_2 * c_phi
        z13 = z11 - z12
        z14 = z7 + z8
        z15 = phi_dot * k3
        s2 = z14 * k7 - z9 * (z15 + (Omega0 - psi_dot * c_theta * k3))
        z16 = Omega1 * (s1 * (z6 * z7 + (z6 * z8 - z9)) - z10 * z13) + s2
        z17 = s_theta * (psi_dot * a)
        s3 = Omega1 * (s1 * (z11 * z6 - (z6 * z12 + z17)) + z10 * z14)
        z18 = s3 - (z17 * (Omega0 + z15) - k7 * z13)
        s4 = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta))
        s5 = a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi))
        dydt: list[float] = [
            # x' (III.3)
            s4 - y_2 * Omega,
            # y' (III.3)
            x * Omega - s5,
            # phi' (III.3)
            phi_dot,
            # theta' (III.3)
            theta_dot,
            # psi' (III.3)
            psi_dot,
            # phi'' (III.3) 25:4
            s_theta * (theta_dot * psi_dot + z5 * (c_theta * k5) * z16),
            # theta'' (III.3) 25:4
            z18 * k8,
            # psi'' (III.3) 25:4
            -z16 * (s_theta * k5 * z5),
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all velocities q' from the state (I.2.4)

    Arguments: t (scalar), y (8,), p (6,).
    Returns qdot (5,).
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    a = float(p[1])  # radius [m]
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # state
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        s2 = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta))
        s3 = a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi))
        qdot: list[float] = [
            # x' (I.2.4)
            s2 - y_2 * Omega,
            # y' (I.2.4)
            x * Omega - s3,
            # phi' (I.2.4)
            phi_dot,
            # theta' (I.2.4)
            theta_dot,
            # psi' (I.2.4)
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
    """all accelerations q'' on the motion (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns qddot (5,).
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = k * k1
        k3 = 1.0 + k
        k4 = k1 * k3
        k5 = m * a
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = k5 / k4
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "accelerations")
        # the mass matrix is singular
        if not abs(k4) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_theta = math.sin(theta)
        z1 = k1 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * (c_theta * k2)
        # the mass matrix is singular
        if not abs(z2) > 1e-14 * z1:
            raise SingularModelError(2, "accelerations")
        z3 = t_ * nu
        c1 = math.cos(z3)
        z4 = nu * c1
        z5 = Omega1 * z4
        s1 = math.sin(z3)
        z6 = Omega1 * s1
        Omega = Omega0 + z6
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z7 = s_theta * s_phi
        z8 = phi_dot * c_phi
        z9 = x * s_phi
        z10 = k6 + z6
        z11 = y_2 * c_phi
        z12 = s_theta * (psi_dot * a)
        z13 = x * c_phi
        z14 = y_2 * s_phi
        z15 = z13 + z14
        z16 = phi_dot * k3
        z17 = z9 - z11
        s2 = Omega1 * (s1 * (z9 * z10 - (z10 * z11 + z12)) + z4 * z15)
        z18 = s2 - (z12 * (Omega0 + z16) - k7 * z17)
        z19 = z18 * k8
        z20 = phi_dot * s_phi
        z21 = theta_dot * c_theta
        z22 = c_phi * s_theta
        z23 = theta_dot * a
        s3 = Omega1 * (s1 * (z10 * z13 + (z10 * z14 - z23)) - z4 * z17)
        s4 = z15 * k7 - z23 * (z16 + (Omega0 - psi_dot * c_theta * k3))
        z24 = s3 + s4
        z25 = 1.0 / z2
        z26 = z24 * (s_theta * k5 * z25)
        s5 = psi_dot * (s_theta * z20 - c_phi * z21) + z22 * z26
        z27 = a * (theta_dot * z8 + s_phi * z19 + s5)
        s6 = psi_dot * (s_phi * z21 + s_theta * z8) - z7 * z26
        z28 = a * (theta_dot * z20 - c_phi * z19 - s6)
        s7 = Omega * (a * (theta_dot * c_phi + psi_dot * z7) - x * Omega)
        s8 = a * (theta_dot * s_phi - psi_dot * z22) - y_2 * Omega
        qddot: list[float] = [
            # x'' (III.3)
            z27 - (y_2 * z5 - s7),
            # y'' (III.3)
            x * z5 + Omega * s8 + z28,
            # phi'' (III.3)
            s_theta * (theta_dot * psi_dot + z25 * (c_theta * k5) * z24),
            # theta'' (III.3)
            z19,
            # psi'' (III.3)
            -z26,
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
    """the state y from coordinates and velocities (I.2.1)

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns y (8,).
    """
    x = float(q[0])  # centre [m]
    y_2 = float(q[1])  # centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    phi_dot = float(qdot[2])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    try:
        # state
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
    """left sides of the constraints, zero on every motion (I.1.1)

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
    Returns r (2,).
    """
    t_ = float(t)  # time
    x = float(q[0])  # centre [m]
    y = float(q[1])  # centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    a = float(p[1])  # radius [m]
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # state
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        s2 = a * (theta_dot * s_phi - psi_dot * (c_phi * s_theta))
        s3 = a * (theta_dot * c_phi + psi_dot * (s_theta * s_phi))
        r: list[float] = [
            # roll_x = 0 (I.1.1) 27:5
            x_dot - s2 + y * Omega,
            # roll_y = 0 (I.1.1) 28:5
            y_dot + s3 - x * Omega,
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (8,), p (6,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        k1 = m * (a * a)
        k2 = k * k1
        k3 = 1.0 + k
        k4 = k1 * k3
        k5 = m * a
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = Omega1 * Omega1
        k9 = k5 / k4
        # state
        # the mass matrix is singular
        if not abs(k2) > 0.0:
            raise SingularModelError(2, "reactions")
        # the mass matrix is singular
        if not abs(k4) > 0.0:
            raise SingularModelError(2, "reactions")
        s_theta = math.sin(theta)
        z1 = k1 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * (c_theta * k2)
        # the mass matrix is singular
        if not abs(z2) > 1e-14 * z1:
            raise SingularModelError(2, "reactions")
        c_phi = math.cos(phi)
        z3 = t_ * nu
        s1 = math.sin(z3)
        z4 = Omega1 * s1
        z5 = psi_dot * c_theta
        z6 = z4 + (Omega0 + (phi_dot - z5))
        s_phi = math.sin(phi)
        z7 = z4 + (phi_dot + Omega0)
        z8 = Omega0 * (Omega0 + 2.0 * z4) + k8 * (s1 * s1)
        c1 = math.cos(z3)
        s2 = theta_dot * c_phi * z6 + s_phi * (psi_dot * s_theta) * z7
        z9 = a * s2 - (x * z8 + c1 * (nu * (y_2 * Omega1)))
        z10 = x * s_phi
        z11 = k6 + z4
        z12 = y_2 * c_phi
        z13 = s_theta * (psi_dot * a)
        z14 = nu * c1
        z15 = x * c_phi
        z16 = y_2 * s_phi
        z17 = z15 + z16
        z18 = phi_dot * k3
        z19 = z10 - z12
        s3 = Omega1 * (s1 * (z10 * z11 - (z11 * z12 + z13)) + z14 * z17)
        z20 = s3 - (z13 * (Omega0 + z18) - k7 * z19)
        z21 = z20 * k9
        z22 = c_phi * k5
        z23 = theta_dot * a
        s4 = Omega1 * (s1 * (z11 * z15 + (z11 * z16 - z23)) - z14 * z19)
        z24 = s4 + (z17 * k7 - z23 * (z18 + (Omega0 - z5 * k3)))
        z25 = s_theta * k5
        z26 = z24 * (z25 / z2)
        s5 = theta_dot * s_phi * z6 - z7 * (s_theta * (psi_dot * c_phi))
        z27 = a * s5 - (y_2 * z8 - c1 * (nu * (x * Omega1)))
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            m * z9 + (s_phi * k5 * z21 + s_theta * z22 * z26),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            m * z27 - (z22 * z21 - s_phi * z25 * z26),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (8,), p (6,).
    Returns a scalar.
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        I = m * k * (a * a)
        # state
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        s_phi = math.sin(phi)
        omega_x = theta_dot * c_phi + psi_dot * (s_theta * s_phi)
        omega_y = theta_dot * s_phi - psi_dot * (c_phi * s_theta)
        c_theta = math.cos(theta)
        omega_z = phi_dot + psi_dot * c_theta
        s1 = math.sin(t_ * nu)
        Omega = Omega0 + Omega1 * s1
        z1 = a * omega_y - y_2 * Omega
        z2 = a * omega_x - x * Omega
        s2 = omega_x * omega_x + omega_y * omega_y + omega_z * omega_z
        z3 = 0.5 * (I * s2) + 0.5 * (m * (z1 * z1 + z2 * z2))
        value1 = z3
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (III.3)

    Arguments: t (scalar), y (8,), p (6,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        k1 = a * a
        k2 = m * k1
        k3 = k * k2
        k4 = 1.0 + k
        k5 = k2 * k4
        k6 = m * a
        k7 = 2.0 * Omega0
        k8 = Omega0 * Omega0
        k9 = 1.0 / k3
        k10 = 1.0 / k5
        k11 = k6 * k10
        # state
        # the mass matrix is singular
        if not abs(k3) > 0.0:
            raise SingularModelError(2, "jacobian")
        # the mass matrix is singular
        if not abs(k5) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_theta = math.sin(theta)
        z1 = k2 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * (c_theta * k3)
        # the mass matrix is singular
        if not abs(z2) > 1e-14 * z1:
            raise SingularModelError(2, "jacobian")
        z3 = t_ * nu
        s1 = math.sin(z3)
        z4 = Omega1 * s1
        Omega = Omega0 + z4
        c_phi = math.cos(phi)
        z5 = theta_dot * a
        s_phi = math.sin(phi)
        z6 = psi_dot * a
        z7 = s_theta * z6
        z8 = 1.0 / z2
        z9 = s_theta * k6
        z10 = z8 * (c_theta * z9)
        z11 = k7 + z4
        c1 = math.cos(z3)
        s2 = Omega1 * (z11 * (s1 * c_phi) - c1 * (nu * s_phi))
        z12 = s2 + c_phi * k8
        s3 = Omega1 * (z11 * (s1 * s_phi) + c1 * (nu * c_phi))
        z13 = s3 + s_phi * k8
        z14 = x * s_phi - y_2 * c_phi
        z15 = nu * c1
        z16 = x * c_phi
        z17 = y_2 * s_phi
        z18 = z16 + z17
        z19 = k8 * z14 + Omega1 * (z15 * z18 + s1 * (z11 * z14))
        z20 = theta_dot * psi_dot
        z21 = z15 * z14
        z22 = Omega1 * (s1 * (z11 * z16 + (z11 * z17 - z5)) - z21)
        z23 = z18 * k8
        z24 = phi_dot * k4
        z25 = psi_dot * c_theta
        z26 = z25 * k4
        z27 = z22 + (z23 - z5 * (z24 + (Omega0 - z26)))
        z28 = z9 * z8
        z29 = z27 * z28
        z30 = c_theta * (k * (k1 * (m * z20))) - s_theta * (k3 * z29)
        s4 = k6 * (z22 - (z5 * (z24 + (Omega0 - z25)) - z23))
        z31 = c_theta * (s4 - 2.0 * (s_theta * (k2 * z29)))
        s5 = k3 * (s_theta * (z20 + z8 * (c_theta * k6) * z27))
        z32 = s_theta * (psi_dot * (z9 * z5) + s5) - z31
        z33 = z8 * (z32 - c_theta * z30)
        z34 = s_theta * (k1 * (theta_dot * m))
        z35 = k4 * (z8 * (c_theta * z34))
        z36 = z24 + (Omega - z26)
        z37 = k1 * (psi_dot * m)
        z38 = Omega + z24
        z39 = s_theta * k2
        s6 = 1.0 + k4 * (z8 * (k2 * (c_theta * c_theta)))
        J: list[float] = [
            # (III.3)
            0.0,
            # (III.3)
            -Omega,
            # (III.3)
            c_phi * z5 + s_phi * z7,
            # (III.3)
            -c_theta * (c_phi * z6),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            a * s_phi,
            # (III.3)
            -a * (c_phi * s_theta),
            # (III.3)
            Omega,
            # (III.3)
            0.0,
            # (III.3)
            s_phi * z5 - c_phi * z7,
            # (III.3)
            -c_theta * (s_phi * z6),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            -a * c_phi,
            # (III.3)
            -a * (s_theta * s_phi),
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            z10 * z12,
            # (III.3)
            z10 * z13,
            # (III.3)
            -z10 * z19,
            # (III.3)
            k9 * z30 - c_theta * z33,
            # (III.3)
            0.0,
            # (III.3)
            -z35,
            # (III.3)
            s_theta * (psi_dot - z8 * (c_theta * k2) * z36),
            # (III.3)
            theta_dot * s_theta * s6,
            # (III.3)
            k11 * z13,
            # (III.3)
            -k11 * z12,
            # (III.3)
            k11 * (z23 - Omega1 * (z21 - s1 * (z11 * z18))),
            # (III.3)
            -k10 * (c_theta * z37) * z38,
            # (III.3)
            0.0,
            # (III.3)
            -k4 * (k10 * (s_theta * z37)),
            # (III.3)
            0.0,
            # (III.3)
            -z38 * (k10 * z39),
            # (III.3)
            -z28 * z12,
            # (III.3)
            -z28 * z13,
            # (III.3)
            z28 * z19,
            # (III.3)
            z33,
            # (III.3)
            0.0,
            # (III.3)
            k4 * (z8 * z34),
            # (III.3)
            z36 * (z8 * z39),
            # (III.3)
            -z35,
        ]
        _finish("jacobian", J)
        return [J[k12 : k12 + 8] for k12 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (8,), p (6,).
    Returns out (2,).
    """
    t_ = float(t)  # time
    x = float(y[0])  # centre [m]
    y_2 = float(y[1])  # centre [m]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])
    theta_dot = float(y[6])
    psi_dot = float(y[7])
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    k = float(p[2])  # moment of inertia over m a^2; 2/5 for a homogeneous ball
    Omega0 = float(p[3])  # mean rate of the table [rad/s]
    Omega1 = float(p[4])  # amplitude of its modulation [rad/s]
    nu = float(p[5])  # frequency of its modulation [rad/s]
    try:
        # parameters only
        k1 = a * a
        k2 = Omega1 * Omega1
        k3 = 0.5 * Omega0
        # state
        c_theta = math.cos(theta)
        z1 = psi_dot * c_theta
        s1 = math.sin(t_ * nu)
        z2 = Omega1 * s1
        z3 = x * x
        z4 = y_2 * y_2
        s2 = k2 * (s1 * s1) * (0.5 * z3 + 0.5 * z4)
        z5 = Omega0 * ((k3 + z2) * (z3 + z4)) + s2
        z6 = 0.5 * (theta_dot * theta_dot)
        s3 = psi_dot * (0.5 * psi_dot - (Omega0 + z2) * c_theta) + z6
        z7 = phi_dot * (z2 + (Omega0 - (0.5 * phi_dot + z1))) - s3
        s_theta = math.sin(theta)
        s4 = z6 + 0.5 * (s_theta * s_theta * (psi_dot * psi_dot))
        out: list[float] = [
            # spin 31:9
            phi_dot + z1,
            # moving_energy 32:18
            -m * (z5 + k1 * (k * z7 - s4)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
