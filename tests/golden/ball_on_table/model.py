# ruff: noqa: E741
"""ball_on_table, emitted by nhc 0.1.0 (nhc:cbf9b8e22f4edd71).

A homogeneous ball that rolls on a turning table; its centre runs on a circle,
    though nothing holds it there.
Source: ball_on_table.yaml
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
rhs: 23 +-, 50 *, 2 /, 6 calls
velocities: 5 +-, 11 *, 0 /, 4 calls
accelerations: 36 +-, 76 *, 2 /, 6 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 7 +-, 11 *, 0 /, 4 calls
reactions: 33 +-, 69 *, 2 /, 6 calls
energy: 10 +-, 23 *, 0 /, 5 calls
jacobian: 37 +-, 108 *, 4 /, 6 calls
outputs: 13 +-, 28 *, 0 /, 3 calls

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
        # from the parameters alone
        k1 = m * a
        k2 = a * k1
        # the mass matrix is singular
        if not abs(k * k2) > 0.0:
            raise _refuse(abs(k * k2), 0.0, 2, "rhs")
        k3 = 1.0 + k
        k4 = 2.0 * Omega0
        k5 = Omega0 * Omega0
        k6 = k2 * k3
        # the mass matrix is singular
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "rhs")
        k7 = k1 / k6
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = z1 * k6
        # the mass matrix is singular
        if not abs(z2) > 1e-13 * (k2 * (k + z1)):
            raise _refuse(abs(z2), 1e-13 * (k2 * (k + z1)), 2, "rhs")
        z3 = t_ * nu
        s1 = math.sin(z3)
        z4 = Omega1 * s1
        Omega = Omega0 + z4
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z5 = psi_dot * s_theta
        c_theta = math.cos(theta)
        z6 = k4 + z4
        z7 = x * c_phi
        z8 = theta_dot * a
        z9 = y_2 * s_phi
        c1 = math.cos(z3)
        z10 = nu * c1
        z11 = x * s_phi
        z12 = y_2 * c_phi
        z13 = z11 - z12
        z14 = z7 + z9
        z15 = Omega0 + phi_dot * k3
        s2 = Omega1 * (s1 * (z6 * z7 - (z8 - z6 * z9)) - z10 * z13)
        z16 = s2 + (z14 * k5 - z8 * (z15 - psi_dot * c_theta * k3))
        z17 = k1 * z16 / z2
        z18 = a * z5
        s3 = Omega1 * (z10 * z14 + s1 * (z11 * z6 - (z6 * z12 + z18)))
        z19 = s3 + (k5 * z13 - z15 * z18)
        dydt: list[float] = [
            # x' (I.1.2)
            a * (theta_dot * s_phi - c_phi * z5) - y_2 * Omega,
            # y' (I.1.2)
            x * Omega - a * (theta_dot * c_phi + s_phi * z5),
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # psi' (I.1.2)
            psi_dot,
            # phi'' (III.3) 25:4
            s_theta * (theta_dot * psi_dot + c_theta * z17),
            # theta'' (III.3) 25:4
            k7 * z19,
            # psi'' (III.3) 25:4
            -s_theta * z17,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all velocities q' from the state (I.1.2)

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
        # from the parameters alone
        k1 = m * a
        k2 = m * a * a
        k3 = k * k2
        # the mass matrix is singular
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "accelerations")
        k4 = 1.0 + k
        k5 = k2 * k4
        # the mass matrix is singular
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "accelerations")
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = k1 / k5
        # from the state
        s_theta = math.sin(theta)
        z1 = k2 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k3
        # the mass matrix is singular
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "accelerations")
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
        z9 = x * c_phi
        z10 = y_2 * s_phi
        z11 = z9 + z10
        z12 = x * s_phi
        z13 = k6 + z6
        z14 = y_2 * c_phi
        z15 = a * (psi_dot * s_theta)
        z16 = z12 - z14
        z17 = Omega0 + phi_dot * k4
        s2 = Omega1 * (z4 * z11 + s1 * (z12 * z13 - (z13 * z14 + z15)))
        z18 = s2 + (k7 * z16 - z17 * z15)
        z19 = k8 * z18
        z20 = phi_dot * s_phi
        z21 = theta_dot * c_theta
        z22 = c_phi * s_theta
        z23 = theta_dot * a
        s3 = Omega1 * (s1 * (z13 * z9 - (z23 - z13 * z10)) - z4 * z16)
        z24 = s3 + (z11 * k7 - z23 * (z17 - psi_dot * c_theta * k4))
        z25 = z24 * (k1 / z2)
        z26 = s_theta * z25
        s4 = psi_dot * (s_theta * z20 - c_phi * z21) + z22 * z26
        z27 = a * (theta_dot * z8 + s_phi * z19 + s4)
        s5 = psi_dot * (s_phi * z21 + s_theta * z8) - z7 * z26
        z28 = a * (theta_dot * z20 - c_phi * z19 - s5)
        s6 = Omega * (a * (theta_dot * c_phi + psi_dot * z7) - x * Omega)
        s7 = a * (theta_dot * s_phi - psi_dot * z22) - y_2 * Omega
        qddot: list[float] = [
            # x'' (III.3)
            z27 - (y_2 * z5 - s6),
            # y'' (III.3)
            x * z5 + Omega * s7 + z28,
            # phi'' (III.3)
            s_theta * (theta_dot * psi_dot + c_theta * z25),
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
    """the state y from coordinates and velocities

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
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (8,), p (6,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
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
        # from the parameters alone
        k1 = m * a
        k2 = m * a * a
        k3 = k * k2
        # the mass matrix is singular
        if not abs(k3) > 0.0:
            raise _refuse(abs(k3), 0.0, 2, "reactions")
        k4 = 1.0 + k
        k5 = k2 * k4
        # the mass matrix is singular
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "reactions")
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = k1 / k5
        k9 = Omega1 * Omega1
        # from the state
        s_theta = math.sin(theta)
        z1 = k2 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k3
        # the mass matrix is singular
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "reactions")
        c_phi = math.cos(phi)
        z3 = psi_dot * c_theta
        z4 = t_ * nu
        s1 = math.sin(z4)
        z5 = Omega1 * s1
        z6 = z5 + (phi_dot + Omega0)
        z7 = theta_dot * (z3 - z6)
        s_phi = math.sin(phi)
        z8 = psi_dot * s_theta
        z9 = z8 * z6
        c1 = math.cos(z4)
        z10 = nu * c1
        z11 = Omega1 * z10
        z12 = Omega0 * (Omega0 + 2.0 * z5) + k9 * (s1 * s1)
        z13 = x * c_phi
        z14 = y_2 * s_phi
        z15 = z13 + z14
        z16 = x * s_phi
        z17 = k6 + z5
        z18 = y_2 * c_phi
        z19 = a * z8
        z20 = z16 - z18
        z21 = Omega0 + phi_dot * k4
        s2 = Omega1 * (z10 * z15 + s1 * (z16 * z17 - (z17 * z18 + z19)))
        z22 = s2 + (k7 * z20 - z21 * z19)
        z23 = k8 * z22
        z24 = c_phi * k1
        z25 = theta_dot * a
        s3 = Omega1 * (s1 * (z17 * z13 - (z25 - z17 * z14)) - z10 * z20)
        z26 = s3 + (z15 * k7 - z25 * (z21 - z3 * k4))
        z27 = s_theta * k1
        z28 = z26 * (z27 / z2)
        s4 = m * (a * (c_phi * z7 - s_phi * z9) + (y_2 * z11 + x * z12))
        z29 = s4 - (k1 * (s_phi * z23) + z24 * (s_theta * z28))
        s5 = m * (a * (s_phi * z7 + c_phi * z9) - (x * z11 - y_2 * z12))
        z30 = s5 + (z23 * z24 - s_phi * z27 * z28)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            -z29,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            -z30,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V [J]

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
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3)

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
        # from the parameters alone
        k1 = a * a
        I = m * k * k1
        k2 = m * a
        k3 = m * k1
        k4 = k * k3
        # the mass matrix is singular
        if not abs(k4) > 0.0:
            raise _refuse(abs(k4), 0.0, 2, "jacobian")
        k5 = 1.0 + k
        # the mass matrix is singular
        if not abs(k3 * k5) > 0.0:
            raise _refuse(abs(k3 * k5), 0.0, 2, "jacobian")
        k6 = 2.0 * Omega0
        k7 = Omega0 * Omega0
        k8 = 1.0 / k4
        k9 = 1.0 / k5
        k10 = 1.0 / (a * k5)
        # from the state
        s_theta = math.sin(theta)
        z1 = k3 * (k + s_theta * s_theta)
        c_theta = math.cos(theta)
        z2 = z1 - c_theta * c_theta * k4
        # the mass matrix is singular
        if not abs(z2) > 1e-13 * z1:
            raise _refuse(abs(z2), 1e-13 * z1, 2, "jacobian")
        z3 = t_ * nu
        s1 = math.sin(z3)
        z4 = Omega1 * s1
        Omega = Omega0 + z4
        c_phi = math.cos(phi)
        s_phi = math.sin(phi)
        z5 = s_theta * s_phi
        z6 = psi_dot * c_theta
        z7 = a * c_phi
        z8 = a * s_phi
        z9 = c_phi * s_theta
        z10 = s_theta * k2
        z11 = 1.0 / z2
        z12 = c_theta * z11
        z13 = z10 * z12
        z14 = k6 + z4
        z15 = s1 * z14
        c1 = math.cos(z3)
        z16 = nu * c1
        z17 = c_phi * k7 + Omega1 * (c_phi * z15 - s_phi * z16)
        z18 = s_phi * k7 + Omega1 * (s_phi * z15 + c_phi * z16)
        z19 = x * s_phi - y_2 * c_phi
        z20 = x * c_phi
        z21 = y_2 * s_phi
        z22 = z20 + z21
        z23 = k7 * z19 + Omega1 * (z16 * z22 + z19 * z15)
        z24 = theta_dot * psi_dot
        z25 = z10 * z11
        z26 = theta_dot * a
        z27 = phi_dot * k5
        z28 = Omega0 + z27
        z29 = z6 * k5
        z30 = z16 * z19
        z31 = z22 * k7
        z32 = Omega1 * (s1 * (z14 * z20 - (z26 - z14 * z21)) - z30) + z31
        z33 = z26 * (z28 - z29) - z32
        z34 = z25 * z33
        z35 = s_theta * k4
        z36 = I * (c_theta * z24) + z34 * z35
        z37 = z26 * z10
        z38 = s_theta * k3
        s2 = c_theta * (k2 * (z26 * (z6 - z28) + z32) + 2.0 * (z38 * z34))
        s3 = s_theta * (psi_dot * z37 + (z24 - k2 * (z33 * z12)) * z35)
        z39 = s3 - s2
        z40 = z11 * (z39 - c_theta * z36)
        z41 = k5 * z37
        z42 = z41 * z12
        z43 = z27 + (Omega - z29)
        z44 = z11 * z41
        z45 = phi_dot + Omega * k9
        J: list[float] = [
            0.0,
            # (III.3)
            -Omega,
            # (III.3)
            a * (theta_dot * c_phi + psi_dot * z5),
            # (III.3)
            -z6 * z7,
            0.0,
            0.0,
            # (III.3)
            z8,
            # (III.3)
            -a * z9,
            # (III.3)
            Omega,
            0.0,
            # (III.3)
            a * (theta_dot * s_phi - psi_dot * z9),
            # (III.3)
            -z6 * z8,
            0.0,
            0.0,
            # (III.3)
            -z7,
            # (III.3)
            -a * z5,
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
            z13 * z17,
            # (III.3)
            z13 * z18,
            # (III.3)
            -z23 * z13,
            # (III.3)
            k8 * z36 - c_theta * z40,
            0.0,
            # (III.3)
            -z42,
            # (III.3)
            s_theta * (psi_dot - k3 * (z43 * z12)),
            # (III.3)
            z44,
            # (III.3)
            k10 * z18,
            # (III.3)
            -k10 * z17,
            # (III.3)
            k10 * (z31 - Omega1 * (z30 - z22 * z15)),
            # (III.3)
            -z6 * z45,
            0.0,
            # (III.3)
            -psi_dot * s_theta,
            0.0,
            # (III.3)
            -s_theta * z45,
            # (III.3)
            -z25 * z17,
            # (III.3)
            -z25 * z18,
            # (III.3)
            z25 * z23,
            # (III.3)
            z40,
            0.0,
            # (III.3)
            z44,
            # (III.3)
            z43 * (z11 * z38),
            # (III.3)
            -z42,
        ]
        _finish("jacobian", J)
        return [J[k11 : k11 + 8] for k11 in range(0, 64, 8)]
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
        # from the parameters alone
        k1 = a * a
        k2 = Omega1 * Omega1
        k3 = 0.5 * Omega0
        # from the state
        c_theta = math.cos(theta)
        z1 = psi_dot * c_theta
        s1 = math.sin(t_ * nu)
        z2 = Omega1 * s1
        z3 = x * x + y_2 * y_2
        z4 = theta_dot * theta_dot
        s_theta = math.sin(theta)
        Omega = Omega0 + z2
        s2 = psi_dot * (0.5 * psi_dot - Omega * c_theta) + 0.5 * z4
        z5 = s2 - phi_dot * (Omega - (0.5 * phi_dot + z1))
        s3 = 0.5 * (z4 + s_theta * s_theta * (psi_dot * psi_dot))
        s4 = Omega0 * ((k3 + z2) * z3) + 0.5 * (k2 * (s1 * s1 * z3))
        z6 = s4 - k1 * (s3 + k * z5)
        out: list[float] = [
            # spin 31:9
            phi_dot + z1,
            # moving_energy 32:18
            -m * z6,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
