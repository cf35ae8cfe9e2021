"""smooth_tippe_top, emitted by nhc 0.1.0 (nhc:596df2742f42f6ce).

The ball of routh_sphere on a plane without any friction.
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = x [m]: geometric centre
y[1] = y [m]: geometric centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = x' [m/s]
y[6] = y' [m/s]
y[7] = phi' [rad/s]
y[8] = theta' [rad/s]
y[9] = psi' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 1.0 [m]: radius
p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
p[4]: I3 = 0.42 [kg*m^2]: about the axis
p[5]: g = 9.81 [m/s^2]: acceleration of gravity

Outputs:
out[0] = jellett [kg*m^3/s]
out[1] = spin [rad/s]
out[2] = p_x [kg*m/s]
out[3] = p_y [kg*m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 12 +-, 33 *, 3 /, 4 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 12 +-, 34 *, 3 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 2 +-, 6 *, 0 /, 1 calls
energy: 11 +-, 25 *, 0 /, 4 calls
jacobian: 38 +-, 116 *, 3 /, 4 calls
outputs: 7 +-, 18 *, 0 /, 4 calls

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
STATE: tuple[str, ...] = (
    "x",
    "y",
    "phi",
    "theta",
    "psi",
    "x'",
    "y'",
    "phi'",
    "theta'",
    "psi'",
)
PARAMETERS: tuple[str, ...] = ("m", "R", "e", "I1", "I3", "g")
CONSTRAINTS: tuple[str, ...] = ()
OUTPUTS: tuple[str, ...] = ("jellett", "spin", "p_x", "p_y")
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
    """Right-hand side dy/dt = f(t, y; p) (II.3).

    Arguments: t (scalar), y (10,), p (6,).
    Returns dydt (10,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])  # x' [m/s]
    y_dot = float(y[6])  # y' [m/s]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = m * e
        k2 = e * k1
        k3 = 1.0 / I1
        k4 = I1 + k2
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * z1 is nearly 0
        if not abs(I1 * z1) > 1e-13 * (z1 * k4):
            raise _refuse(abs(I1 * z1), 1e-13 * (z1 * k4), 2, "rhs")
        z2 = I1 + z1 * k2
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * k4:
            raise _refuse(abs(z2), 1e-13 * k4, 2, "rhs")
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        z3 = phi_dot * c_theta
        omega3 = psi_dot + z3
        z4 = k3 * (omega3 * (theta_dot * I3))
        s_phi = math.sin(phi)
        z5 = theta_dot * theta_dot
        z6 = I3 * omega3
        z7 = I1 * z3
        z8 = (phi_dot * (z6 - z7) - k1 * (g - e * (c_theta * z5))) / z2
        z9 = s_theta * (z5 + phi_dot * phi_dot + c_theta * z8)
        z10 = theta_dot / (I1 * s_theta) * (z6 - 2.0 * z7)
        dydt: list[float] = [
            # x' (II.3)
            x_dot,
            # y' (II.3)
            y_dot,
            # phi' (II.3)
            phi_dot,
            # theta' (II.3)
            theta_dot,
            # psi' (II.3)
            psi_dot,
            # x'' (II.3) 24:4
            (s_phi * z9 - c_phi * z4) * e,
            # y'' (II.3) 24:4
            -e * (s_phi * z4 + c_phi * z9),
            # phi'' (II.3) 24:4
            z10,
            # theta'' (II.3) 24:4
            -s_theta * z8,
            # psi'' (II.3) 24:4
            s_theta * (phi_dot * theta_dot) - c_theta * z10,
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

    Arguments: t (scalar), y (10,), p (6,).
    Returns qdot (5,).
    """
    x_dot = float(y[5])  # x' [m/s]
    y_dot = float(y[6])  # y' [m/s]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    try:
        # from the state
        qdot: list[float] = [
            # x'
            x_dot,
            # y'
            y_dot,
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

    Arguments: t (scalar), y (10,), p (6,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = m * e
        k2 = m * e * e
        k3 = I1 + k2
        k4 = 1.0 / I1
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * z1 is nearly 0
        if not abs(I1 * z1) > 1e-13 * (z1 * k3):
            raise _refuse(abs(I1 * z1), 1e-13 * (z1 * k3), 2, "accelerations")
        z2 = I1 + z1 * k2
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * k3:
            raise _refuse(abs(z2), 1e-13 * k3, 2, "accelerations")
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        z3 = phi_dot * c_theta
        omega3 = psi_dot + z3
        z4 = k4 * (omega3 * (theta_dot * I3))
        s_phi = math.sin(phi)
        z5 = theta_dot * theta_dot
        z6 = I3 * omega3
        z7 = I1 * z3
        z8 = (phi_dot * (z6 - z7) - k1 * (g - e * (c_theta * z5))) / z2
        z9 = s_theta * (z5 + phi_dot * phi_dot + c_theta * z8)
        z10 = theta_dot / (I1 * s_theta) * (z6 - 2.0 * z7)
        qddot: list[float] = [
            # x'' (II.3)
            (s_phi * z9 - c_phi * z4) * e,
            # y'' (II.3)
            -e * (s_phi * z4 + c_phi * z9),
            # phi'' (II.3)
            z10,
            # theta'' (II.3)
            -s_theta * z8,
            # psi'' (II.3)
            s_theta * (phi_dot * theta_dot) - c_theta * z10,
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
    Returns y (10,).
    """
    x = float(q[0])  # geometric centre [m]
    y_2 = float(q[1])  # y: geometric centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    phi_dot = float(qdot[2])  # phi' [rad/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [
            x,
            y_2,
            phi,
            theta,
            psi,
            x_dot,
            y_dot,
            phi_dot,
            theta_dot,
            psi_dot,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (6,).
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

    Arguments: t (scalar), y (10,), p (6,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    theta = float(y[3])  # nutation [rad]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "reactions")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = m * e * e
        k2 = I1 + k1
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * z1 is nearly 0
        if not abs(I1 * z1) > 1e-13 * (z1 * k2):
            raise _refuse(abs(I1 * z1), 1e-13 * (z1 * k2), 2, "reactions")
        s1 = I1 + z1 * k1
        # the mass matrix is singular, if s1 is nearly 0
        if not abs(s1) > 1e-13 * k2:
            raise _refuse(abs(s1), 1e-13 * k2, 2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (10,), p (6,).
    Returns a scalar.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])  # x' [m/s]
    y_dot = float(y[6])  # y' [m/s]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # from the parameters alone
        k1 = e * (m * g)
        # from the state
        c_theta = math.cos(theta)
        omega3 = psi_dot + phi_dot * c_theta
        s_theta = math.sin(theta)
        s_phi = math.sin(phi)
        z1 = theta_dot * e
        z2 = c_theta * z1
        c_phi = math.cos(phi)
        z3 = phi_dot * (e * s_theta)
        X_dot = x_dot + (s_phi * z2 + c_phi * z3)
        Y_dot = y_dot - (c_phi * z2 - s_phi * z3)
        z4 = s_theta * z1
        s1 = s_theta * s_theta * (phi_dot * phi_dot)
        s2 = m * (X_dot * X_dot + Y_dot * Y_dot + z4 * z4)
        z5 = I1 * (theta_dot * theta_dot + s1) + s2
        value1 = 0.5 * (I3 * (omega3 * omega3) + z5) + c_theta * k1
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3).

    Arguments: t (scalar), y (10,), p (6,).
    Returns rows (10, 10): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular, if m is 0
        if not abs(m) > 0.0:
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # the mass matrix is singular, if I3 is 0
        if not abs(I3) > 0.0:
            raise _refuse(abs(I3), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = m * e
        k2 = e * k1
        k3 = m * e * e
        k4 = I1 + k3
        k5 = I1 - I3
        k6 = 1.0 / I1
        # from the state
        s_theta = math.sin(theta)
        z1 = s_theta * s_theta
        # the mass matrix is singular, if I1 * z1 is nearly 0
        if not abs(I1 * z1) > 1e-13 * (z1 * k4):
            raise _refuse(abs(I1 * z1), 1e-13 * (z1 * k4), 2, "jacobian")
        z2 = I1 + z1 * k3
        # the mass matrix is singular, if z2 is nearly 0
        if not abs(z2) > 1e-13 * k4:
            raise _refuse(abs(z2), 1e-13 * k4, 2, "jacobian")
        c_phi = math.cos(phi)
        z3 = s_theta * c_phi
        z4 = theta_dot * theta_dot
        c_theta = math.cos(theta)
        z5 = 1.0 / z2
        z6 = c_theta * z5
        z7 = e * z4
        z8 = phi_dot * c_theta
        omega3 = psi_dot + z8
        z9 = I3 * omega3
        z10 = phi_dot * I1
        z11 = c_theta * z10
        z12 = z9 - z11
        z13 = k1 * (g - c_theta * z7) - phi_dot * z12
        z14 = z4 + phi_dot * phi_dot - z6 * z13
        s_phi = math.sin(phi)
        z15 = theta_dot * I3
        z16 = s_phi * z15
        z17 = omega3 * k6
        z18 = c_theta * z14
        z19 = s_theta * s_phi
        z20 = phi_dot * s_theta
        z21 = I3 * z20
        z22 = s_theta * z10
        z23 = k1 * (s_theta * z7) + phi_dot * (z21 - z22)
        z24 = s_theta * z5
        z25 = k3 * (s_theta * c_theta * (z5 * z5))
        z26 = z6 * z23 - z13 * (z24 + 2.0 * (c_theta * z25))
        z27 = c_phi * z15
        z28 = z27 * k6
        z29 = z8 * k5 - z12
        z30 = 2.0 * phi_dot - z6 * z29
        z31 = theta_dot * c_theta * k2
        z32 = theta_dot + z6 * z31
        z33 = I3 * z17
        z34 = phi_dot * I3
        z35 = z6 * z34
        z36 = k6 * z16
        z37 = 1.0 / (I1 * s_theta)
        z38 = theta_dot * z37
        z39 = I1 * c_theta
        z40 = z9 - 2.0 * z11
        s1 = z39 * (z37 * z37 * (theta_dot * z40))
        z41 = z38 * (z21 - 2.0 * z22) + s1
        z42 = z38 * (I3 * c_theta - 2.0 * z39)
        z43 = z37 * z40
        z44 = I3 * z38
        J: list[float] = [
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
            0.0,
            0.0,
            0.0,
            0.0,
            # (II.3)
            1.0,
            0.0,
            0.0,
            # (II.3)
            e * (z3 * z14 + z16 * z17),
            # (II.3)
            e * (s_phi * z18 - z19 * z26 + z20 * z28),
            0.0,
            0.0,
            0.0,
            # (II.3)
            e * (z19 * z30 - c_theta * z28),
            # (II.3)
            e * (2.0 * (z19 * z32) - c_phi * z33),
            # (II.3)
            (z19 * z35 - z28) * e,
            0.0,
            0.0,
            # (II.3)
            e * (z19 * z14 - z27 * z17),
            # (II.3)
            (z20 * z36 - (c_phi * z18 - z3 * z26)) * e,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -e * (z3 * z30 + c_theta * z36),
            # (II.3)
            -e * (2.0 * (z3 * z32) + s_phi * z33),
            # (II.3)
            -e * (z36 + z3 * z35),
            0.0,
            0.0,
            0.0,
            # (II.3)
            -z41,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z42,
            # (II.3)
            z43,
            # (II.3)
            z44,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z24 * z23 + z13 * (z6 - 2.0 * (s_theta * z25)),
            0.0,
            0.0,
            0.0,
            # (II.3)
            z24 * z29,
            # (II.3)
            -2.0 * (z24 * z31),
            # (II.3)
            -z24 * z34,
            0.0,
            0.0,
            0.0,
            # (II.3)
            theta_dot * z8 + (z40 * (s_theta * z38) + c_theta * z41),
            0.0,
            0.0,
            0.0,
            # (II.3)
            theta_dot * s_theta - c_theta * z42,
            # (II.3)
            z20 - c_theta * z43,
            # (II.3)
            -c_theta * z44,
        ]
        _finish("jacobian", J)
        return [J[k7 : k7 + 10] for k7 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (10,), p (6,).
    Returns out (4,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])  # x' [m/s]
    y_dot = float(y[6])  # y' [m/s]
    phi_dot = float(y[7])  # phi' [rad/s]
    theta_dot = float(y[8])  # theta' [rad/s]
    psi_dot = float(y[9])  # psi' [rad/s]
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # from the parameters alone
        k1 = R * I1
        # from the state
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        omega3 = psi_dot + phi_dot * c_theta
        s_phi = math.sin(phi)
        z1 = e * (theta_dot * c_theta)
        c_phi = math.cos(phi)
        z2 = phi_dot * (e * s_theta)
        s1 = k1 * (phi_dot * (s_theta * s_theta))
        out: list[float] = [
            # jellett 27:12
            s1 + I3 * (omega3 * (e + R * c_theta)),
            # spin 28:9
            omega3,
            # p_x 29:8
            m * (x_dot + (s_phi * z1 + c_phi * z2)),
            # p_y 30:8
            m * (y_dot - (c_phi * z1 - s_phi * z2)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
