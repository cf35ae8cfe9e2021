"""chaplygin_ball, emitted by nhc 0.1.0 (nhc:2835ae8c7c49e660).

A ball with three different moments of inertia and its centre of mass at its centre
    rolls on a horizontal plane.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [m]: centre
y[1] = y [m]: centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = w1 [rad/s]
y[6] = w2 [rad/s]
y[7] = w3 [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: a = 1.0 [m]: radius
p[2]: I1 = 0.4 [kg*m^2]
p[3]: I2 = 0.5 [kg*m^2]
p[4]: I3 = 0.7 [kg*m^2]

Constraints, with the units of their reactions:
0: roll_x [N]
1: roll_y [N]

Outputs:
out[0] = K1 [kg*m^2/s]
out[1] = K2 [kg*m^2/s]
out[2] = K3 [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 21 +-, 40 *, 5 /, 6 calls
velocities: 5 +-, 12 *, 1 /, 6 calls
accelerations: 35 +-, 69 *, 5 /, 6 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 4 +-, 7 *, 0 /, 3 calls
reactions: 24 +-, 49 *, 4 /, 6 calls
energy: 11 +-, 22 *, 0 /, 4 calls
jacobian: 65 +-, 174 *, 5 /, 6 calls
outputs: 8 +-, 18 *, 0 /, 4 calls

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
STATE: tuple[str, ...] = ("x", "y", "phi", "theta", "psi", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("m", "a", "I1", "I2", "I3")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y")
OUTPUTS: tuple[str, ...] = ("K1", "K2", "K3")
DEFAULTS: tuple[float, ...] = (1.0, 1.0, 0.4, 0.5, 0.7)

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

    Arguments: t (scalar), y (8,), p (5,).
    Returns dydt (8,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        k5 = I2 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "rhs")
        k6 = I1 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "rhs")
        k7 = I3 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k7 is 0
        if not abs(k7) > 0.0:
            raise _refuse(abs(k7), 0.0, 2, "rhs")
        k8 = 1.0 / k6
        k9 = 1.0 / k5
        k10 = 1.0 / k7
        k11 = k8 - k9
        k12 = k9 - k10
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "rhs")
        s_psi = math.sin(psi)
        s1 = k1 * (k10 + s_theta * s_theta * (s_psi * s_psi * k11 + k12))
        z1 = 1.0 - s1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z1 is nearly 0
        if not abs(z1) > 1e-13:
            raise _refuse(abs(z1), 1e-13, 2, "rhs")
        s_phi = math.sin(phi)
        c_psi = math.cos(psi)
        z2 = s_psi * w2 - c_psi * w1
        v2_x = a * z2
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        z3 = (c_psi * w2 + s_psi * w1) / s_theta
        z4 = w3 - c_theta * z3
        z5 = s_theta * (a * z4)
        z6 = w2 * w3 * k2
        z7 = s_theta * s_psi
        z8 = w1 * w2 * k4
        z9 = w1 * w3 * k3
        z10 = s_theta * c_psi
        s2 = z8 * (c_theta * k10) + (z6 * (z7 * k8) - z9 * (z10 * k9))
        z11 = k1 / z1 * s2
        dydt: list[float] = [
            # x' (I.2.4)
            -(s_phi * v2_x + c_phi * z5),
            # y' (I.2.4)
            c_phi * v2_x - s_phi * z5,
            # phi' (I.2.4)
            z3,
            # theta' (I.2.4)
            -z2,
            # psi' (I.2.4)
            z4,
            # w1' (I.2.15) 25:4
            k8 * (z6 + z7 * z11),
            # w2' (I.2.15) 25:4
            (z10 * z11 - z9) * k9,
            # w3' (I.2.15) 25:4
            k10 * (z8 + c_theta * z11),
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qdot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    a = float(p[1])  # radius [m]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "velocities")
        s_phi = math.sin(phi)
        s_psi = math.sin(psi)
        c_psi = math.cos(psi)
        z1 = s_psi * w2 - c_psi * w1
        v2_x = a * z1
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        z2 = (c_psi * w2 + s_psi * w1) / s_theta
        z3 = w3 - c_theta * z2
        z4 = s_theta * (a * z3)
        qdot: list[float] = [
            # x' (I.2.4)
            -(s_phi * v2_x + c_phi * z4),
            # y' (I.2.4)
            c_phi * v2_x - s_phi * z4,
            # phi' (I.2.4)
            z2,
            # theta' (I.2.4)
            -z1,
            # psi' (I.2.4)
            z3,
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        k5 = I2 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "accelerations")
        k6 = I1 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "accelerations")
        k7 = I3 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k7 is 0
        if not abs(k7) > 0.0:
            raise _refuse(abs(k7), 0.0, 2, "accelerations")
        k8 = 1.0 / k6
        k9 = 1.0 / k5
        k10 = 1.0 / k7
        k11 = k8 - k9
        k12 = k9 - k10
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "accelerations")
        s_psi = math.sin(psi)
        s1 = k1 * (k10 + s_theta * s_theta * (s_psi * s_psi * k11 + k12))
        z1 = 1.0 - s1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z1 is nearly 0
        if not abs(z1) > 1e-13:
            raise _refuse(abs(z1), 1e-13, 2, "accelerations")
        c_psi = math.cos(psi)
        z2 = s_psi * w2 - c_psi * w1
        v2_x = a * z2
        c_phi = math.cos(phi)
        z3 = 1.0 / s_theta
        z4 = c_psi * w2 + s_psi * w1
        z5 = z3 * z4
        z6 = c_phi * z5
        s_phi = math.sin(phi)
        c_theta = math.cos(theta)
        z7 = w3 - c_theta * z5
        z8 = c_psi * z7
        z9 = w1 * w3 * k3
        z10 = s_theta * c_psi
        z11 = w1 * w2 * k4
        z12 = w2 * w3 * k2
        z13 = s_theta * s_psi
        s2 = z11 * (c_theta * k10) + (z12 * (z13 * k8) - z9 * (z10 * k9))
        z14 = k1 / z1 * s2
        z15 = k9 * (z9 - z10 * z14)
        z16 = s_psi * z7
        z17 = k8 * (z12 + z13 * z14)
        z18 = w2 * z8 - s_psi * z15 + (w1 * z16 - c_psi * z17)
        z19 = a * z18
        z20 = a * z7
        z21 = s_theta * z20
        z22 = s_phi * z5
        z23 = c_theta * z2
        s3 = z3 * (w2 * z16 + c_psi * z15 - (w1 * z8 + s_psi * z17))
        z24 = z4 * (z23 * (z3 * z3)) - s3
        s4 = z5 * (s_theta * z2) + c_theta * z24
        z25 = k10 * (z11 + c_theta * z14) - s4
        z26 = z20 * z23 - s_theta * (a * z25)
        qddot: list[float] = [
            # x'' (I.2.15)
            z21 * z22 + c_phi * z26 - (v2_x * z6 + s_phi * z19),
            # y'' (I.2.15)
            -(v2_x * z22 - c_phi * z19 + (z21 * z6 - s_phi * z26)),
            # phi'' (I.2.15)
            z24,
            # theta'' (I.2.15)
            -z18,
            # psi'' (I.2.15)
            z25,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
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
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        s_theta = math.sin(theta)
        z1 = phi_dot * s_theta
        c_theta = math.cos(theta)
        y: list[float] = [
            x,
            y_2,
            phi,
            theta,
            psi,
            theta_dot * c_psi + s_psi * z1,
            c_psi * z1 - theta_dot * s_psi,
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

    Arguments: t (scalar), q (5,), qdot (5,), p (5,).
    Returns r (2,).
    """
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[3])  # theta' [rad/s]
    psi_dot = float(qdot[4])  # psi' [rad/s]
    a = float(p[1])  # radius [m]
    try:
        # from the coordinates and velocities
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        r: list[float] = [
            # roll_x = 0 (I.1.1) 27:5
            x_dot - a * (theta_dot * s_phi - c_phi * z1),
            # roll_y = 0 (I.1.1) 28:5
            y_dot + a * (theta_dot * c_phi + s_phi * z1),
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

    Arguments: t (scalar), y (8,), p (5,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        k2 = m * a
        k3 = I2 - I3
        k4 = I1 - I3
        k5 = I1 - I2
        k6 = I2 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "reactions")
        k7 = I1 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k7 is 0
        if not abs(k7) > 0.0:
            raise _refuse(abs(k7), 0.0, 2, "reactions")
        k8 = I3 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k8 is 0
        if not abs(k8) > 0.0:
            raise _refuse(abs(k8), 0.0, 2, "reactions")
        k9 = 1.0 / k7
        k10 = 1.0 / k6
        k11 = 1.0 / k8
        k12 = k9 - k10
        k13 = k10 - k11
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "reactions")
        s_psi = math.sin(psi)
        s1 = k1 * (k11 + s_theta * s_theta * (s_psi * s_psi * k12 + k13))
        z1 = 1.0 - s1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z1 is nearly 0
        if not abs(z1) > 1e-13:
            raise _refuse(abs(z1), 1e-13, 2, "reactions")
        c_phi = math.cos(phi)
        z2 = w1 * w2 * k5
        c_theta = math.cos(theta)
        z3 = s_theta * s_psi
        z4 = w2 * w3 * k3
        c_psi = math.cos(psi)
        z5 = s_theta * c_psi
        z6 = w1 * w3 * k4
        s2 = k11 * (c_theta * z2) + (k9 * (z3 * z4) - k10 * (z5 * z6))
        z7 = k1 * (s2 / z1)
        z8 = s_theta * k2 * (k11 * (z2 + c_theta * z7))
        z9 = s_psi * c_theta
        s_phi = math.sin(phi)
        z10 = k2 * (k9 * (z4 + z3 * z7))
        z11 = c_psi * c_theta
        z12 = k2 * (k10 * (z6 - z5 * z7))
        s3 = (s_psi * s_phi - c_phi * z11) * z12
        z13 = c_phi * z8 - ((c_phi * z9 + c_psi * s_phi) * z10 + s3)
        s4 = (s_psi * c_phi + s_phi * z11) * z12
        z14 = s_phi * z8 - ((s_phi * z9 - c_psi * c_phi) * z10 - s4)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            -z13,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            -z14,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (8,), p (5,).
    Returns a scalar.
    """
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        # from the state
        z1 = w3 * w3
        z2 = w1 * w1
        z3 = w2 * w2
        s_theta = math.sin(theta)
        c_psi = math.cos(psi)
        z4 = c_psi * w2
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        s1 = s_psi * (0.5 * (s_psi * (z2 - z3)) + w1 * z4)
        s2 = (z4 + s_psi * w1) * (c_theta * w3)
        z5 = s2 - s_theta * (0.5 * (z1 - z3) - s1)
        s3 = 0.5 * (I3 * z1 + (I1 * z2 + I2 * z3))
        z6 = s3 + k1 * (0.5 * (z2 + z3) - s_theta * z5)
        value1 = z6
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (8,), p (5,).
    Returns rows (8, 8): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        k2 = I2 - I3
        k3 = I1 - I3
        k4 = I1 - I2
        k5 = I2 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k5 is 0
        if not abs(k5) > 0.0:
            raise _refuse(abs(k5), 0.0, 2, "jacobian")
        k6 = I1 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k6 is 0
        if not abs(k6) > 0.0:
            raise _refuse(abs(k6), 0.0, 2, "jacobian")
        k7 = I3 + k1
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if k7 is 0
        if not abs(k7) > 0.0:
            raise _refuse(abs(k7), 0.0, 2, "jacobian")
        k8 = 1.0 / k6
        k9 = 1.0 / k5
        k10 = 1.0 / k7
        k11 = k8 - k9
        k12 = k9 - k10
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "jacobian")
        z1 = s_theta * s_theta
        s_psi = math.sin(psi)
        z2 = s_psi * s_psi
        z3 = 1.0 - k1 * (k10 + z1 * (z2 * k11 + k12))
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z3 is nearly 0
        if not abs(z3) > 1e-13:
            raise _refuse(abs(z3), 1e-13, 2, "jacobian")
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        z4 = s_psi * w2 - c_psi * w1
        v2_x = a * z4
        s_phi = math.sin(phi)
        z5 = 1.0 / s_theta
        c_theta = math.cos(theta)
        z6 = c_psi * w2 + s_psi * w1
        z7 = c_theta * z6
        z8 = a * (w3 - z5 * z7)
        z9 = s_theta * z8
        z10 = a * s_theta
        z11 = z5 * z5 * z7
        z12 = z6 + c_theta * z11
        z13 = c_theta * z8 + z10 * z12
        z14 = a * z6
        z15 = z5 * z4
        z16 = c_theta * z15
        z17 = z10 * z16
        z18 = a * c_psi
        z19 = s_psi * z5
        z20 = c_theta * z19
        z21 = z20 * z10
        z22 = a * s_psi
        z23 = c_psi * z5
        z24 = c_theta * z23
        z25 = z24 * z10
        z26 = s_theta * k1
        z27 = s_psi * z26
        z28 = w1 * k4
        z29 = w2 * z28
        z30 = k1 / z3
        z31 = c_theta * k10
        z32 = s_theta * s_psi
        z33 = z32 * k8
        z34 = w2 * k2
        z35 = w3 * z34
        z36 = s_theta * c_psi
        z37 = z36 * k9
        z38 = w1 * k3
        z39 = w3 * z38
        z40 = z30 * (z31 * z29 + (z33 * z35 - z37 * z39))
        z41 = k10 * (z29 + c_theta * z40)
        z42 = s_theta * z41
        z43 = c_theta * z41
        z44 = s_psi * k1
        z45 = k9 * (z39 - z36 * z40)
        z46 = c_psi * z45
        z47 = k8 * (z35 + z32 * z40)
        z48 = k1 * z47
        s1 = z43 * z44 - 2.0 * (s_theta * (z46 * z44 - z2 * z48))
        z49 = z27 * z42 - c_theta * s1
        z50 = c_psi * z26
        z51 = c_theta * z45
        z52 = c_theta * z47
        s2 = k1 * (c_psi * z51 - s_psi * z52) + 2.0 * (k1 * z42)
        z53 = s_theta * (z50 * z45 - z27 * z47) - c_theta * s2
        z54 = c_psi * z47
        s3 = 2.0 * (s_theta * (k1 * (c_psi * c_psi * z45) - z54 * z44))
        z55 = c_theta * (k1 * (c_psi * z43) - s3)
        z56 = z50 * z42 - z55
        z57 = z30 * (z31 * z53 - (z33 * z49 + z37 * z56))
        z58 = k1 * z1
        z59 = z26 * z43
        z60 = z58 * z46
        z61 = s_psi * z1 * z48
        z62 = z2 * z58 * z45 + c_psi * (z59 - z60 + 2.0 * z61)
        z63 = z27 * z51 + z50 * z52
        z64 = c_psi * z58 * z54 + s_psi * (2.0 * z60 - (z59 + z61))
        z65 = z30 * (z31 * z63 + (z33 * z62 + z37 * z64))
        z66 = w3 * k3
        z67 = w2 * k4
        z68 = z30 * (z37 * z66 - z31 * z67)
        z69 = w3 * k2
        z70 = z30 * (z33 * z69 + z31 * z28)
        z71 = z30 * (z34 * z33 - z38 * z37)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            s_phi * z9 - c_phi * v2_x,
            # (I.2.15)
            -c_phi * z13,
            # (I.2.15)
            -(s_phi * z14 + c_phi * z17),
            # (I.2.15)
            s_phi * z18 + c_phi * z21,
            # (I.2.15)
            c_phi * z25 - s_phi * z22,
            # (I.2.15)
            -c_phi * z10,
            0.0,
            0.0,
            # (I.2.15)
            -(s_phi * v2_x + c_phi * z9),
            # (I.2.15)
            -s_phi * z13,
            # (I.2.15)
            c_phi * z14 - s_phi * z17,
            # (I.2.15)
            s_phi * z21 - c_phi * z18,
            # (I.2.15)
            c_phi * z22 + s_phi * z25,
            # (I.2.15)
            -s_phi * z10,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z11,
            # (I.2.15)
            -z15,
            # (I.2.15)
            z19,
            # (I.2.15)
            z23,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z6,
            # (I.2.15)
            c_psi,
            # (I.2.15)
            -s_psi,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z12,
            # (I.2.15)
            z16,
            # (I.2.15)
            -z20,
            # (I.2.15)
            -z24,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            (z32 * z57 - z49) * k8,
            # (I.2.15)
            k8 * (z62 + z32 * z65),
            # (I.2.15)
            -z33 * z68,
            # (I.2.15)
            k8 * (z69 + z32 * z70),
            # (I.2.15)
            k8 * (z34 + z32 * z71),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            (z36 * z57 - z56) * k9,
            # (I.2.15)
            k9 * (z64 + z36 * z65),
            # (I.2.15)
            -k9 * (z66 + z36 * z68),
            # (I.2.15)
            z37 * z70,
            # (I.2.15)
            (z36 * z71 - z38) * k9,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            k10 * (z53 + c_theta * z57),
            # (I.2.15)
            k10 * (z63 + c_theta * z65),
            # (I.2.15)
            k10 * (z67 - c_theta * z68),
            # (I.2.15)
            k10 * (z28 + c_theta * z70),
            # (I.2.15)
            z31 * z71,
        ]
        _finish("jacobian", J)
        return [J[k13 : k13 + 8] for k13 in range(0, 64, 8)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (8,), p (5,).
    Returns out (3,).
    """
    theta = float(y[3])  # nutation [rad]
    psi = float(y[4])  # spin [rad]
    w1 = float(y[5])  # [rad/s]
    w2 = float(y[6])  # [rad/s]
    w3 = float(y[7])  # [rad/s]
    m = float(p[0])  # mass [kg]
    a = float(p[1])  # radius [m]
    I1 = float(p[2])  # [kg*m^2]
    I2 = float(p[3])  # [kg*m^2]
    I3 = float(p[4])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = m * a * a
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "outputs")
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z1 = c_psi * w2 + s_psi * w1
        z2 = s_theta * (c_theta * w3 + s_theta * z1)
        out: list[float] = [
            # K1 35:7
            I1 * w1 + k1 * (w1 - s_psi * z2),
            # K2 36:7
            I2 * w2 + k1 * (w2 - c_psi * z2),
            # K3 37:7
            I3 * w3 + k1 * (s_theta * (s_theta * w3 - c_theta * z1)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
