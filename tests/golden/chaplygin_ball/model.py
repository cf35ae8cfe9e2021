"""chaplygin_ball, emitted by nhc 0.1.0 (nhc:7476701bb74ebc41).

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
rhs: 23 +-, 49 *, 4 /, 6 calls
velocities: 5 +-, 12 *, 1 /, 6 calls
accelerations: 37 +-, 77 *, 4 /, 6 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 4 +-, 7 *, 0 /, 3 calls
reactions: 26 +-, 57 *, 3 /, 6 calls
energy: 11 +-, 22 *, 0 /, 4 calls
jacobian: 73 +-, 178 *, 4 /, 6 calls
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
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "rhs")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "rhs")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = s_psi * c_psi * z4
        z6 = 1.0 / z2
        z7 = z6 * z5
        z8 = z3 - z5 * z7
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is nearly 0
        if not abs(z8) > 1e-13 * z3:
            raise _refuse(abs(z8), 1e-13 * z3, 2, "rhs")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = c_theta * (s_theta * k1)
        z11 = s_psi * z10
        z12 = z6 * z11
        z13 = c_psi * z10 + z5 * z12
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z9 - z11 * z12 - z13 * z15
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z16 is nearly 0
        if not abs(z16) > 1e-13 * z9:
            raise _refuse(abs(z16), 1e-13 * z9, 2, "rhs")
        s_phi = math.sin(phi)
        z17 = s_psi * w2 - c_psi * w1
        v2_x = a * z17
        c_phi = math.cos(phi)
        z18 = (c_psi * w2 + s_psi * w1) / s_theta
        z19 = w3 - c_theta * z18
        z20 = a * (s_theta * z19)
        z21 = w2 * w3 * k2
        z22 = w1 * w3 * k3 - z21 * z7
        z23 = (w1 * w2 * k4 + z21 * z12 - z15 * z22) / z16
        z24 = z14 * z22 - z15 * z23
        dydt: list[float] = [
            # x' (I.2.4)
            -(s_phi * v2_x + c_phi * z20),
            # y' (I.2.4)
            c_phi * v2_x - s_phi * z20,
            # phi' (I.2.4)
            z18,
            # theta' (I.2.4)
            -z17,
            # psi' (I.2.4)
            z19,
            # w1' (I.2.15) 25:4
            z21 * z6 - z7 * z24 + z12 * z23,
            # w2' (I.2.15) 25:4
            -z24,
            # w3' (I.2.15) 25:4
            z23,
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
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "accelerations")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "accelerations")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = s_psi * c_psi * z4
        z6 = 1.0 / z2
        z7 = z6 * z5
        z8 = z3 - z5 * z7
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is nearly 0
        if not abs(z8) > 1e-13 * z3:
            raise _refuse(abs(z8), 1e-13 * z3, 2, "accelerations")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = c_theta * (s_theta * k1)
        z11 = s_psi * z10
        z12 = z6 * z11
        z13 = c_psi * z10 + z5 * z12
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z9 - z11 * z12 - z13 * z15
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z16 is nearly 0
        if not abs(z16) > 1e-13 * z9:
            raise _refuse(abs(z16), 1e-13 * z9, 2, "accelerations")
        z17 = s_psi * w2 - c_psi * w1
        v2_x = a * z17
        c_phi = math.cos(phi)
        z18 = 1.0 / s_theta
        z19 = c_psi * w2 + s_psi * w1
        z20 = z18 * z19
        z21 = c_phi * z20
        s_phi = math.sin(phi)
        z22 = w3 - c_theta * z20
        z23 = c_psi * z22
        z24 = w2 * w3 * k2
        z25 = w1 * w3 * k3 - z24 * z7
        z26 = (w1 * w2 * k4 + z24 * z12 - z15 * z25) / z16
        z27 = z14 * z25 - z15 * z26
        z28 = s_psi * z22
        z29 = z24 * z6 - z7 * z27 + z12 * z26
        z30 = w2 * z23 - s_psi * z27 + (w1 * z28 - c_psi * z29)
        z31 = a * z30
        z32 = a * z22
        z33 = s_theta * z32
        z34 = s_phi * z20
        z35 = c_theta * z17
        s1 = z18 * (w2 * z28 + c_psi * z27 - (w1 * z23 + s_psi * z29))
        z36 = z18 * z18 * (z19 * z35) - s1
        z37 = z26 - (z19 * z17 + c_theta * z36)
        z38 = z32 * z35 - a * (s_theta * z37)
        qddot: list[float] = [
            # x'' (I.2.15)
            z33 * z34 + c_phi * z38 - (v2_x * z21 + s_phi * z31),
            # y'' (I.2.15)
            -(v2_x * z34 - c_phi * z31 + (z33 * z21 - s_phi * z38)),
            # phi'' (I.2.15)
            z36,
            # theta'' (I.2.15)
            -z30,
            # psi'' (I.2.15)
            z37,
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
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "reactions")
        s_psi = math.sin(psi)
        z1 = s_theta * s_theta
        z2 = I1 + k1 * (1.0 - s_psi * s_psi * z1)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "reactions")
        c_psi = math.cos(psi)
        z3 = I2 + k1 * (1.0 - c_psi * c_psi * z1)
        z4 = k1 * z1
        z5 = s_psi * c_psi * z4
        z6 = 1.0 / z2
        z7 = z6 * z5
        z8 = z3 - z5 * z7
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is nearly 0
        if not abs(z8) > 1e-13 * z3:
            raise _refuse(abs(z8), 1e-13 * z3, 2, "reactions")
        z9 = I3 + z4
        c_theta = math.cos(theta)
        z10 = s_psi * c_theta
        z11 = s_theta * k1
        z12 = z10 * z11
        z13 = z6 * z12
        z14 = c_psi * c_theta
        z15 = z14 * z11 + z5 * z13
        z16 = 1.0 / z8
        z17 = z16 * z15
        z18 = z9 - z12 * z13 - z15 * z17
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z18 is nearly 0
        if not abs(z18) > 1e-13 * z9:
            raise _refuse(abs(z18), 1e-13 * z9, 2, "reactions")
        c_phi = math.cos(phi)
        z19 = w2 * w3 * k3
        z20 = w1 * w3 * k4 - z19 * z7
        z21 = (w1 * w2 * k5 + z19 * z13 - z20 * z17) / z18
        z22 = s_theta * k2 * z21
        s_phi = math.sin(phi)
        z23 = z16 * z20 - z17 * z21
        z24 = k2 * (z19 * z6 - z7 * z23 + z13 * z21)
        z25 = k2 * z23
        s1 = (c_psi * s_phi + c_phi * z10) * z24
        z26 = c_phi * z22 - (s1 + (s_psi * s_phi - c_phi * z14) * z25)
        s2 = (c_psi * c_phi - s_phi * z10) * z24
        z27 = s_phi * z22 + (s2 + (s_psi * c_phi + s_phi * z14) * z25)
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 27:5
            -z26,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 28:5
            -z27,
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
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "jacobian")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = s_theta * s_theta
        z3 = I1 + k1 * (1.0 - z1 * z2)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z3 is 0
        if not abs(z3) > 0.0:
            raise _refuse(abs(z3), 0.0, 2, "jacobian")
        c_psi = math.cos(psi)
        z4 = c_psi * c_psi
        z5 = I2 + k1 * (1.0 - z4 * z2)
        z6 = k1 * z2
        z7 = s_psi * z6
        z8 = c_psi * z7
        z9 = 1.0 / z3
        z10 = z8 * z9
        z11 = z5 - z8 * z10
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z11 is nearly 0
        if not abs(z11) > 1e-13 * z5:
            raise _refuse(abs(z11), 1e-13 * z5, 2, "jacobian")
        z12 = I3 + z6
        c_theta = math.cos(theta)
        z13 = s_theta * k1
        z14 = s_psi * z13
        z15 = c_theta * z14
        z16 = z15 * z9
        z17 = c_psi * z13
        z18 = c_theta * z17 + z8 * z16
        z19 = 1.0 / z11
        z20 = z18 * z19
        z21 = z12 - z15 * z16 - z18 * z20
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z21 is nearly 0
        if not abs(z21) > 1e-13 * z12:
            raise _refuse(abs(z21), 1e-13 * z12, 2, "jacobian")
        c_phi = math.cos(phi)
        z22 = s_psi * w2 - c_psi * w1
        v2_x = a * z22
        s_phi = math.sin(phi)
        z23 = 1.0 / s_theta
        z24 = c_psi * w2 + s_psi * w1
        z25 = c_theta * z24
        z26 = a * (w3 - z23 * z25)
        z27 = s_theta * z26
        z28 = a * s_theta
        z29 = z23 * z23 * z25
        z30 = z24 + c_theta * z29
        z31 = c_theta * z26 + z28 * z30
        z32 = a * z24
        z33 = z23 * z22
        z34 = c_theta * z33
        z35 = z28 * z34
        z36 = a * c_psi
        z37 = s_psi * z23
        z38 = c_theta * z37
        z39 = z38 * z28
        z40 = a * s_psi
        z41 = c_psi * z23
        z42 = c_theta * z41
        z43 = z42 * z28
        z44 = 1.0 / z21
        z45 = w1 * k4
        z46 = w2 * k2
        z47 = w3 * z46
        z48 = w1 * k3
        z49 = w3 * z48 - z10 * z47
        z50 = z44 * (w2 * z45 + z16 * z47 - z20 * z49)
        z51 = s_theta * z50
        z52 = c_theta * z50
        z53 = s_psi * k1
        z54 = z19 * z49 - z20 * z50
        z55 = c_psi * z54
        z56 = z9 * z47 - z10 * z54 + z16 * z50
        z57 = k1 * z56
        s1 = z52 * z53 - 2.0 * (s_theta * (z55 * z53 - z1 * z57))
        z58 = z14 * z51 - c_theta * s1
        z59 = c_psi * z56
        s2 = 2.0 * (s_theta * (k1 * (z4 * z54) - z59 * z53))
        z60 = z17 * z51 - c_theta * (k1 * (c_psi * z52) - s2)
        z61 = z60 + z10 * z58
        z62 = c_theta * z54
        z63 = c_theta * z56
        s3 = k1 * (c_psi * z62 - s_psi * z63) + 2.0 * (k1 * z51)
        z64 = s_theta * (z17 * z54 - z14 * z56) - c_theta * s3
        z65 = z44 * (z64 - z16 * z58 - z20 * z61)
        z66 = z19 * z61 - z20 * z65
        z67 = z13 * z52
        z68 = z6 * z55
        z69 = z57 * (s_psi * z2)
        z70 = z54 * (s_psi * z7) + c_psi * (z67 - z68 + 2.0 * z69)
        s4 = z59 * (c_psi * z6) + s_psi * (2.0 * z68 - (z67 + z69))
        z71 = z10 * z70 + s4
        z72 = z44 * (z14 * z62 + z17 * z63 + z16 * z70 + z20 * z71)
        z73 = z19 * z71 + z20 * z72
        z74 = w3 * k3
        z75 = z44 * (w2 * k4 - z20 * z74)
        z76 = z19 * z74 - z20 * z75
        z77 = w3 * k2
        z78 = z10 * z77
        z79 = z44 * (z45 + z16 * z77 + z20 * z78)
        z80 = z19 * z78 + z20 * z79
        z81 = z48 - z10 * z46
        z82 = z44 * (z16 * z46 - z20 * z81)
        z83 = z19 * z81 - z20 * z82
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            s_phi * z27 - c_phi * v2_x,
            # (I.2.15)
            -c_phi * z31,
            # (I.2.15)
            -(s_phi * z32 + c_phi * z35),
            # (I.2.15)
            s_phi * z36 + c_phi * z39,
            # (I.2.15)
            c_phi * z43 - s_phi * z40,
            # (I.2.15)
            -c_phi * z28,
            0.0,
            0.0,
            # (I.2.15)
            -(s_phi * v2_x + c_phi * z27),
            # (I.2.15)
            -s_phi * z31,
            # (I.2.15)
            c_phi * z32 - s_phi * z35,
            # (I.2.15)
            s_phi * z39 - c_phi * z36,
            # (I.2.15)
            c_phi * z40 + s_phi * z43,
            # (I.2.15)
            -s_phi * z28,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z29,
            # (I.2.15)
            -z33,
            # (I.2.15)
            z37,
            # (I.2.15)
            z41,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z24,
            # (I.2.15)
            c_psi,
            # (I.2.15)
            -s_psi,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z30,
            # (I.2.15)
            z34,
            # (I.2.15)
            -z38,
            # (I.2.15)
            -z42,
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z16 * z65 - (z9 * z58 + z10 * z66),
            # (I.2.15)
            z9 * z70 + z10 * z73 + z16 * z72,
            # (I.2.15)
            z16 * z75 - z10 * z76,
            # (I.2.15)
            z9 * z77 + z10 * z80 + z16 * z79,
            # (I.2.15)
            z9 * z46 - z10 * z83 + z16 * z82,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z66,
            # (I.2.15)
            z73,
            # (I.2.15)
            -z76,
            # (I.2.15)
            z80,
            # (I.2.15)
            -z83,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z65,
            # (I.2.15)
            z72,
            # (I.2.15)
            z75,
            # (I.2.15)
            z79,
            # (I.2.15)
            z82,
        ]
        _finish("jacobian", J)
        return [J[k5 : k5 + 8] for k5 in range(0, 64, 8)]
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
