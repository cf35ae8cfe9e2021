"""routh_sphere, emitted by nhc 0.1.0 (nhc:74f77ef1779647fb).

A ball with its centre of mass off its centre, dynamically symmetric, rolls on a
    horizontal plane.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec

State y:
y[0] = x [m]: geometric centre
y[1] = y [m]: geometric centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = phi' [rad/s]
y[6] = theta' [rad/s]
y[7] = psi' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 1.0 [m]: radius
p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
p[4]: I3 = 0.42 [kg*m^2]: about the axis
p[5]: g = 9.81 [m/s^2]: acceleration of gravity

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]

Outputs:
out[0] = jellett [kg*m^3/s]
out[1] = routh [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 24 +-, 47 *, 3 /, 4 calls
velocities: 2 +-, 7 *, 0 /, 3 calls
accelerations: 29 +-, 59 *, 3 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 4 +-, 7 *, 0 /, 3 calls
reactions: 34 +-, 73 *, 3 /, 4 calls
energy: 9 +-, 22 *, 0 /, 2 calls
jacobian: 46 +-, 124 *, 3 /, 4 calls
outputs: 5 +-, 17 *, 0 /, 3 calls

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
PARAMETERS: tuple[str, ...] = ("m", "R", "e", "I1", "I3", "g")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("jellett", "routh")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, -0.2, 0.38, 0.42, 9.81)

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
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * R * R
        k2 = m * e
        k3 = m * R
        k4 = e * e
        k5 = I3 - (I1 + m * k4)
        k6 = e * k3
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular, if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "rhs")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k4 + R * z3)
        # the mass matrix is singular, if z4 is 0
        if not abs(z4) > 0.0:
            raise _refuse(abs(z4), 0.0, 2, "rhs")
        z5 = I3 + z1 * k1
        z6 = I3 * c_theta - z1 * k6
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z5:
            raise _refuse(abs(z9), 1e-13 * z5, 2, "rhs")
        c_phi = math.cos(phi)
        z10 = s_theta * (psi_dot * R)
        s_phi = math.sin(phi)
        z11 = theta_dot * R
        z12 = theta_dot * s_theta
        z13 = c_theta * k5
        s1 = phi_dot * (k6 - 2.0 * z13) - psi_dot * (I3 + c_theta * k6)
        z14 = z12 * s1
        s2 = z12 * (phi_dot * (I3 + k3 * z3) - c_theta * (psi_dot * k1))
        z15 = (z14 * z8 + s2) / z9
        s3 = phi_dot * (k6 - z13) - psi_dot * (I3 + (R + Z) * k3)
        z16 = phi_dot * s3 + k2 * (g + theta_dot * z11)
        dydt: list[float] = [
            # x' (I.1.2)
            s_phi * z11 - c_phi * z10,
            # y' (I.1.2)
            -(c_phi * z11 + s_phi * z10),
            # phi' (I.1.2)
            phi_dot,
            # theta' (I.1.2)
            theta_dot,
            # psi' (I.1.2)
            psi_dot,
            # phi'' (III.3) 26:4
            -(z14 * z7 + z8 * z15),
            # theta'' (III.3) 26:4
            s_theta * z16 / z4,
            # psi'' (III.3) 26:4
            z15,
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
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the state
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        z1 = s_theta * (psi_dot * R)
        s_phi = math.sin(phi)
        z2 = theta_dot * R
        qdot: list[float] = [
            # x' (I.1.2)
            s_phi * z2 - c_phi * z1,
            # y' (I.1.2)
            -(c_phi * z2 + s_phi * z1),
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
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * R * R
        k2 = m * e
        k3 = m * R
        k4 = e * e
        k5 = I3 - (I1 + m * k4)
        k6 = e * k3
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular, if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "accelerations")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k4 + R * z3)
        # the mass matrix is singular, if z4 is 0
        if not abs(z4) > 0.0:
            raise _refuse(abs(z4), 0.0, 2, "accelerations")
        z5 = I3 + z1 * k1
        z6 = I3 * c_theta - z1 * k6
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z5:
            raise _refuse(abs(z9), 1e-13 * z5, 2, "accelerations")
        c_phi = math.cos(phi)
        z10 = phi_dot * c_phi
        z11 = theta_dot * R
        s_phi = math.sin(phi)
        z12 = c_theta * k5
        s1 = phi_dot * (k6 - z12) - psi_dot * (I3 + (R + Z) * k3)
        z13 = phi_dot * s1 + k2 * (g + R * (theta_dot * theta_dot))
        z14 = s_theta * z13 / z4
        z15 = R * z14
        z16 = phi_dot * s_phi
        z17 = psi_dot * R
        z18 = s_theta * z17
        z19 = theta_dot * s_theta
        s2 = phi_dot * (k6 - 2.0 * z12) - psi_dot * (I3 + c_theta * k6)
        z20 = z19 * s2
        s3 = z19 * (phi_dot * (I3 + k3 * z3) - k1 * (psi_dot * c_theta))
        z21 = (z20 * z8 + s3) / z9
        z22 = theta_dot * c_theta * z17 + R * (s_theta * z21)
        qddot: list[float] = [
            # x'' (III.3)
            z10 * z11 + s_phi * z15 + (z16 * z18 - c_phi * z22),
            # y'' (III.3)
            z16 * z11 - c_phi * z15 - (z10 * z18 + s_phi * z22),
            # phi'' (III.3)
            -(z20 * z7 + z8 * z21),
            # theta'' (III.3)
            z14,
            # psi'' (III.3)
            z21,
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
    x = float(q[0])  # geometric centre [m]
    y_2 = float(q[1])  # y: geometric centre [m]
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
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    R = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        r: list[float] = [
            # roll_x = 0 (I.1.1) 29:5
            x_dot - R * (theta_dot * s_phi - c_phi * z1),
            # roll_y = 0 (I.1.1) 30:5
            y_dot + R * (theta_dot * c_phi + s_phi * z1),
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
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * R * R
        k2 = m * e
        k3 = m * R
        k4 = e * e
        k5 = I3 - (I1 + m * k4)
        k6 = e * k3
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular, if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "reactions")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k4 + R * z3)
        # the mass matrix is singular, if z4 is 0
        if not abs(z4) > 0.0:
            raise _refuse(abs(z4), 0.0, 2, "reactions")
        z5 = I3 + z1 * k1
        z6 = I3 * c_theta - z1 * k6
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z5:
            raise _refuse(abs(z9), 1e-13 * z5, 2, "reactions")
        c_phi = math.cos(phi)
        z10 = s_theta * c_phi
        z11 = theta_dot * s_theta
        z12 = c_theta * k5
        s1 = phi_dot * (k6 - 2.0 * z12) - psi_dot * (I3 + c_theta * k6)
        z13 = z11 * s1
        s2 = z11 * (phi_dot * (I3 + k3 * z3) - k1 * (psi_dot * c_theta))
        z14 = (z13 * z8 + s2) / z9
        z15 = k3 * z14
        z16 = k2 * (z13 * z7 + z8 * z14)
        s_phi = math.sin(phi)
        z17 = R + Z
        s3 = phi_dot * (phi_dot * (k6 - z12) - psi_dot * (I3 + z17 * k3))
        z18 = s3 + k2 * (g + R * (theta_dot * theta_dot))
        z19 = m * z17 * (s_theta * z18 / z4)
        z20 = phi_dot * R
        z21 = phi_dot * e
        s4 = e * (theta_dot * z11) + s_theta * (phi_dot * z21)
        z22 = s_theta * (psi_dot * z20) - s4
        z23 = theta_dot * c_theta
        z24 = R * (psi_dot * z23) - theta_dot * z20 - 2.0 * (z23 * z21)
        z25 = s_theta * s_phi
        s5 = z10 * z15 + (z10 * z16 - s_phi * z19)
        s6 = z25 * z15 + (z25 * z16 + c_phi * z19)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 29:5
            m * (s_phi * z22 - c_phi * z24) - s5,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 30:5
            -(s6 + m * (c_phi * z22 + s_phi * z24)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (8,), p (6,).
    Returns a scalar.
    """
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * g
        # from the state
        c_theta = math.cos(theta)
        Z = e * c_theta
        omega3 = psi_dot + phi_dot * c_theta
        s_theta = math.sin(theta)
        z1 = e * s_theta
        z2 = theta_dot * z1
        z3 = theta_dot * (R + Z)
        z4 = phi_dot * z1 - R * (psi_dot * s_theta)
        s1 = s_theta * s_theta * (phi_dot * phi_dot)
        s2 = m * (z2 * z2 + (z3 * z3 + z4 * z4))
        z5 = I1 * (theta_dot * theta_dot + s1) + s2
        value1 = Z * k1 + 0.5 * (I3 * (omega3 * omega3) + z5)
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
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    theta_dot = float(y[6])  # theta' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = m * R * R
        k2 = m * e
        k3 = m * R
        k4 = e * e
        k5 = I3 - (I1 + m * k4)
        k6 = e * k3
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        z2 = I3 - z1 * k5
        # the mass matrix is singular, if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "jacobian")
        c_theta = math.cos(theta)
        Z = e * c_theta
        z3 = R + 2.0 * Z
        z4 = I1 + m * (k4 + R * z3)
        # the mass matrix is singular, if z4 is 0
        if not abs(z4) > 0.0:
            raise _refuse(abs(z4), 0.0, 2, "jacobian")
        z5 = I3 + z1 * k1
        z6 = I3 * c_theta - z1 * k6
        z7 = 1.0 / z2
        z8 = z6 * z7
        z9 = z5 - z6 * z8
        # the mass matrix is singular, if z9 is nearly 0
        if not abs(z9) > 1e-13 * z5:
            raise _refuse(abs(z9), 1e-13 * z5, 2, "jacobian")
        c_phi = math.cos(phi)
        z10 = theta_dot * R
        s_phi = math.sin(phi)
        z11 = psi_dot * R
        z12 = s_theta * z11
        z13 = c_theta * z11
        z14 = R * s_theta
        z15 = theta_dot * s_theta
        z16 = phi_dot * z15
        z17 = 1.0 / z9
        z18 = c_theta * k5
        z19 = k6 - 2.0 * z18
        z20 = I3 + c_theta * k6
        z21 = phi_dot * z19 - psi_dot * z20
        z22 = z15 * z21
        z23 = I3 + k3 * z3
        z24 = psi_dot * k1
        z25 = phi_dot * z23 - c_theta * z24
        z26 = z17 * (z22 * z8 + z15 * z25)
        z27 = z22 * z7 + z8 * z26
        s1 = theta_dot * z21 - 2.0 * (s_theta * (k6 * z26 - k5 * z27))
        s2 = s_theta * (k6 * (psi_dot * z15) + 2.0 * (z16 * k5) - I3 * z26)
        z28 = s2 + c_theta * s1
        s3 = theta_dot * z25 - 2.0 * (s_theta * (k1 * z26 + k6 * z27))
        s4 = s_theta * (2.0 * (z16 * k6) - (z15 * z24 - I3 * z27))
        z29 = s4 - c_theta * s3
        z30 = z17 * (z29 - z8 * z28)
        z31 = z15 * z19
        z32 = z17 * (z15 * z23 + z8 * z31)
        z33 = s_theta * z21
        z34 = z17 * (z8 * z33 + s_theta * z25)
        z35 = z15 * z20
        z36 = z17 * (z8 * z35 + k1 * (c_theta * z15))
        z37 = 1.0 / z4
        z38 = k6 - z18
        z39 = I3 + (R + Z) * k3
        z40 = phi_dot * z38 - psi_dot * z39
        z41 = phi_dot * z40 + k2 * (g + R * (theta_dot * theta_dot))
        z42 = phi_dot * s_theta
        z43 = z14 * z37
        s5 = e * (k3 * (psi_dot * z42) + 2.0 * (m * (z41 * z43)))
        z44 = s_theta * (k5 * (phi_dot * z42) + s5)
        J: list[float] = [
            0.0,
            0.0,
            # (III.3)
            c_phi * z10 + s_phi * z12,
            # (III.3)
            -c_phi * z13,
            0.0,
            0.0,
            # (III.3)
            R * s_phi,
            # (III.3)
            -c_phi * z14,
            0.0,
            0.0,
            # (III.3)
            s_phi * z10 - c_phi * z12,
            # (III.3)
            -s_phi * z13,
            0.0,
            0.0,
            # (III.3)
            -R * c_phi,
            # (III.3)
            -s_phi * z14,
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
            0.0,
            0.0,
            0.0,
            # (III.3)
            z8 * z30 - z7 * z28,
            0.0,
            # (III.3)
            -(z7 * z31 + z8 * z32),
            # (III.3)
            -(z7 * z33 + z8 * z34),
            # (III.3)
            z7 * z35 + z8 * z36,
            0.0,
            0.0,
            0.0,
            # (III.3)
            z37 * (c_theta * z41 + z44),
            0.0,
            # (III.3)
            z37 * (s_theta * z40 + z42 * z38),
            # (III.3)
            2.0 * (k2 * (theta_dot * z43)),
            # (III.3)
            -z37 * (z42 * z39),
            0.0,
            0.0,
            0.0,
            # (III.3)
            -z30,
            0.0,
            # (III.3)
            z32,
            # (III.3)
            z34,
            # (III.3)
            -z36,
        ]
        _finish("jacobian", J)
        return [J[k7 : k7 + 8] for k7 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (8,), p (6,).
    Returns out (2,).
    """
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[5])  # phi' [rad/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 * I3
        k2 = I1 * (m * (R * R))
        k3 = m * I3
        k4 = R * I1
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        c_theta = math.cos(theta)
        omega3 = psi_dot + phi_dot * c_theta
        z2 = e + R * c_theta
        out: list[float] = [
            # jellett 33:12
            phi_dot * z1 * k4 + I3 * (omega3 * z2),
            # routh 34:10
            omega3 * math.sqrt(k1 + z1 * k2 + k3 * (z2 * z2)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
