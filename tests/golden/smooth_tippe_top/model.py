"""smooth_tippe_top, emitted by nhc 0.1.0 (nhc:8b943e3f8a6ef1d1).

The ball of routh_sphere on a plane without any friction.
Source: smooth_tippe_top.yaml
Equations of motion: lagrange (II.3)
Why: no constraints

State y:
y[0] = x [m]: geometric centre
y[1] = y [m]: geometric centre
y[2] = phi [rad]: precession
y[3] = theta [rad]: nutation
y[4] = psi [rad]: spin
y[5] = x'
y[6] = y'
y[7] = phi'
y[8] = theta'
y[9] = psi'

Parameters p:
p[0]: m = 1.0 [kg]: mass
p[1]: R = 1.0 [m]: radius
p[2]: e = -0.2 [m]: centre of mass along the axis of symmetry
p[3]: I1 = 0.38 [kg*m^2]: across the axis, at the centre of mass
p[4]: I3 = 0.42 [kg*m^2]: about the axis
p[5]: g = 9.81 [m/s^2]: acceleration of gravity

Outputs:
out[0] = jellett
out[1] = spin
out[2] = p_x
out[3] = p_y

Operations:
rhs: 32 +-, 74 *, 4 /, 4 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 32 +-, 74 *, 4 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 11 +-, 28 *, 3 /, 4 calls
energy: 11 +-, 25 *, 0 /, 4 calls
jacobian: 122 +-, 246 *, 4 /, 4 calls
outputs: 7 +-, 18 *, 0 /, 4 calls

A singular point raises SingularModelError.
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


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """right-hand side dy/dt = f(t, y; p) (II.3)

    Arguments: t (scalar), y (10,), p (6,).
    Returns dydt (10,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])
    y_dot = float(y[6])
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular
        if not abs(m) > 0.0:
            raise SingularModelError(2, "rhs")
        # parameters only
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = g * k1
        k5 = 1.0 / m
        # state
        s_theta = math.sin(theta)
        z1 = I3 - s_theta * s_theta * k3
        c_phi = math.cos(phi)
        z2 = s_theta * k1
        z3 = c_phi * z2
        z4 = z3 * k5
        s_phi = math.sin(phi)
        z5 = s_phi * z2
        z6 = z5 * k5
        z7 = z1 - z3 * z4 - z5 * z6
        # the mass matrix is singular
        if not abs(z7) > 1e-14 * z1:
            raise SingularModelError(2, "rhs")
        c_theta = math.cos(theta)
        z8 = c_theta * k1
        z9 = s_phi * z8
        z10 = k5 * z9
        z11 = c_phi * z8
        z12 = k5 * z11
        z13 = z3 * z10 - z5 * z12
        z14 = 1.0 / z7
        z15 = z14 * z13
        z16 = k2 - z9 * z10 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * k2:
            raise SingularModelError(2, "rhs")
        z17 = I3 * c_theta
        z18 = z17 * z14
        z19 = z18 * z13
        z20 = 1.0 / z16
        z21 = z19 * z20
        z22 = I3 - z17 * z18 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * I3:
            raise SingularModelError(2, "rhs")
        z23 = s_theta * theta_dot * theta_dot
        z24 = phi_dot * s_theta
        z25 = theta_dot * c_theta
        s1 = s_phi * z23 + phi_dot * (s_phi * z24 - 2.0 * (c_phi * z25))
        z26 = k1 * s1
        z27 = phi_dot * c_theta * k3
        z28 = psi_dot * I3
        s2 = c_phi * z23 + phi_dot * (c_phi * z24 + 2.0 * (s_phi * z25))
        z29 = k1 * s2
        s3 = theta_dot * s_theta * (2.0 * z27 + z28) - z4 * z26
        z30 = s3 + z6 * z29
        s4 = s_theta * (phi_dot * (z27 + z28) - k4) + z26 * z10
        z31 = s4 + z29 * z12 - z15 * z30
        z32 = (I3 * (theta_dot * z24) - z18 * z30 + z21 * z31) / z22
        z33 = z20 * z31 + z21 * z32
        z34 = z14 * z30 - z15 * z33 - z18 * z32
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
            k5 * z26 - z4 * z34 + z10 * z33,
            # y'' (II.3) 24:4
            -(k5 * z29 + z6 * z34 + z12 * z33),
            # phi'' (II.3) 24:4
            z34,
            # theta'' (II.3) 24:4
            -z33,
            # psi'' (II.3) 24:4
            z32,
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

    Arguments: t (scalar), y (10,), p (6,).
    Returns qdot (5,).
    """
    x_dot = float(y[5])
    y_dot = float(y[6])
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    try:
        # state
        qdot: list[float] = [
            # x' (I.2.4)
            x_dot,
            # y' (I.2.4)
            y_dot,
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
    """all accelerations q'' on the motion (II.3)

    Arguments: t (scalar), y (10,), p (6,).
    Returns qddot (5,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular
        if not abs(m) > 0.0:
            raise SingularModelError(2, "accelerations")
        # parameters only
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = g * k1
        k5 = 1.0 / m
        # state
        s_theta = math.sin(theta)
        z1 = I3 - s_theta * s_theta * k3
        c_phi = math.cos(phi)
        z2 = s_theta * k1
        z3 = c_phi * z2
        z4 = z3 * k5
        s_phi = math.sin(phi)
        z5 = s_phi * z2
        z6 = z5 * k5
        z7 = z1 - z3 * z4 - z5 * z6
        # the mass matrix is singular
        if not abs(z7) > 1e-14 * z1:
            raise SingularModelError(2, "accelerations")
        c_theta = math.cos(theta)
        z8 = c_theta * k1
        z9 = s_phi * z8
        z10 = k5 * z9
        z11 = c_phi * z8
        z12 = k5 * z11
        z13 = z3 * z10 - z5 * z12
        z14 = 1.0 / z7
        z15 = z14 * z13
        z16 = k2 - z9 * z10 - z11 * z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * k2:
            raise SingularModelError(2, "accelerations")
        z17 = I3 * c_theta
        z18 = z17 * z14
        z19 = z18 * z13
        z20 = 1.0 / z16
        z21 = z19 * z20
        z22 = I3 - z17 * z18 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * I3:
            raise SingularModelError(2, "accelerations")
        z23 = s_theta * theta_dot * theta_dot
        z24 = phi_dot * s_theta
        z25 = theta_dot * c_theta
        s1 = s_phi * z23 + phi_dot * (s_phi * z24 - 2.0 * (c_phi * z25))
        z26 = k1 * s1
        z27 = phi_dot * c_theta * k3
        z28 = psi_dot * I3
        s2 = c_phi * z23 + phi_dot * (c_phi * z24 + 2.0 * (s_phi * z25))
        z29 = k1 * s2
        s3 = theta_dot * s_theta * (2.0 * z27 + z28) - z4 * z26
        z30 = s3 + z6 * z29
        s4 = s_theta * (phi_dot * (z27 + z28) - k4) + z26 * z10
        z31 = s4 + z29 * z12 - z15 * z30
        z32 = (I3 * (theta_dot * z24) - z18 * z30 + z21 * z31) / z22
        z33 = z20 * z31 + z21 * z32
        z34 = z14 * z30 - z15 * z33 - z18 * z32
        qddot: list[float] = [
            # x'' (II.3)
            k5 * z26 - z4 * z34 + z10 * z33,
            # y'' (II.3)
            -(k5 * z29 + z6 * z34 + z12 * z33),
            # phi'' (II.3)
            z34,
            # theta'' (II.3)
            -z33,
            # psi'' (II.3)
            z32,
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
    Returns y (10,).
    """
    x = float(q[0])  # geometric centre [m]
    y_2 = float(q[1])  # geometric centre [m]
    phi = float(q[2])  # precession [rad]
    theta = float(q[3])  # nutation [rad]
    psi = float(q[4])  # spin [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    phi_dot = float(qdot[2])
    theta_dot = float(qdot[3])
    psi_dot = float(qdot[4])
    try:
        # state
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
    """left sides of the constraints, zero on every motion (I.1.1)

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
    """reactions lambda: Q_i gains lambda_a a_ai (I.4.1)

    Arguments: t (scalar), y (10,), p (6,).
    Returns lambda_ (0,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # the mass matrix is singular
        if not abs(m) > 0.0:
            raise SingularModelError(2, "reactions")
        # parameters only
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = 1.0 / m
        # state
        s_theta = math.sin(theta)
        z1 = I3 - s_theta * s_theta * k3
        c_phi = math.cos(phi)
        z2 = s_theta * k1
        z3 = c_phi * z2
        s_phi = math.sin(phi)
        z4 = s_phi * z2
        z5 = z1 - k4 * (z3 * z3) - k4 * (z4 * z4)
        # the mass matrix is singular
        if not abs(z5) > 1e-14 * z1:
            raise SingularModelError(2, "reactions")
        c_theta = math.cos(theta)
        z6 = c_theta * k1
        z7 = s_phi * z6
        z8 = k4 * z7
        z9 = c_phi * z6
        z10 = k4 * z9
        z11 = 1.0 / z5
        z12 = z3 * z8 - z4 * z10
        z13 = k2 - z7 * z8 - z9 * z10 - z11 * (z12 * z12)
        # the mass matrix is singular
        if not abs(z13) > 1e-14 * k2:
            raise SingularModelError(2, "reactions")
        z14 = I3 * c_theta
        z15 = z14 * z11
        z16 = z12 * z15
        s1 = z16 * z16 / z13
        s2 = I3 - z14 * z15 - s1
        # the mass matrix is singular
        if not abs(s2) > 1e-14 * I3:
            raise SingularModelError(2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

    Arguments: t (scalar), y (10,), p (6,).
    Returns a scalar.
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])
    y_dot = float(y[6])
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # parameters only
        k1 = e * (m * g)
        # state
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
    """d rhs_i / d y_j, row-major (II.3)

    Arguments: t (scalar), y (10,), p (6,).
    Returns rows (10, 10): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    m = float(p[0])  # mass [kg]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    g = float(p[5])  # acceleration of gravity [m/s^2]
    try:
        # the mass matrix is singular
        if not abs(m) > 0.0:
            raise SingularModelError(2, "jacobian")
        # parameters only
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = g * k1
        k5 = 1.0 / m
        # state
        s_theta = math.sin(theta)
        z1 = I3 - s_theta * s_theta * k3
        c_phi = math.cos(phi)
        z2 = s_theta * k1
        z3 = c_phi * z2
        z4 = z3 * k5
        s_phi = math.sin(phi)
        z5 = s_phi * z2
        z6 = z5 * k5
        z7 = z1 - z3 * z4 - z5 * z6
        # the mass matrix is singular
        if not abs(z7) > 1e-14 * z1:
            raise SingularModelError(2, "jacobian")
        c_theta = math.cos(theta)
        z8 = s_phi * k1
        z9 = c_theta * z8
        z10 = z9 * k5
        z11 = c_phi * k1
        z12 = c_theta * z11
        z13 = z12 * k5
        z14 = z3 * z10 - z5 * z13
        z15 = 1.0 / z7
        z16 = z14 * z15
        z17 = k2 - z9 * z10 - z12 * z13 - z14 * z16
        # the mass matrix is singular
        if not abs(z17) > 1e-14 * k2:
            raise SingularModelError(2, "jacobian")
        z18 = I3 * c_theta
        z19 = z18 * z15
        z20 = z14 * z19
        z21 = 1.0 / z17
        z22 = z20 * z21
        z23 = I3 - z18 * z19 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * I3:
            raise SingularModelError(2, "jacobian")
        z24 = phi_dot * k1
        z25 = c_theta * z24
        z26 = theta_dot * s_theta
        z27 = phi_dot * c_theta * k3
        z28 = psi_dot * I3
        z29 = 2.0 * z27 + z28
        z30 = phi_dot * s_theta
        z31 = theta_dot * c_phi
        z32 = s_phi * z30 - 2.0 * (c_theta * z31)
        z33 = theta_dot * theta_dot
        z34 = s_theta * z33
        z35 = k1 * (phi_dot * z32 + s_phi * z34)
        z36 = theta_dot * s_phi
        z37 = c_phi * z30 + 2.0 * (c_theta * z36)
        z38 = k1 * (phi_dot * z37 + c_phi * z34)
        z39 = z26 * z29 - z35 * z4 + z38 * z6
        z40 = z27 + z28
        z41 = phi_dot * z40 - k4
        z42 = s_theta * z41 + z35 * z10 + z38 * z13 - z16 * z39
        z43 = 1.0 / z23
        z44 = I3 * (phi_dot * theta_dot)
        z45 = z43 * (s_theta * z44 - z19 * z39 + z22 * z42)
        z46 = z21 * z42 + z22 * z45
        z47 = z15 * z39 - z16 * z46 - z19 * z45
        z48 = 2.0 * (theta_dot * z25) + z2 * z47
        z49 = k1 * z34 + z30 * z24 + k1 * (c_theta * z46)
        z50 = s_phi * z48 + c_phi * z49
        z51 = s_phi * z49 - c_phi * z48
        z52 = z35 * k5 - z4 * z47 + z10 * z46
        z53 = z38 * k5 + z6 * z47 + z13 * z46
        z54 = z6 * z51 + (z4 * z50 - (z5 * z52 + z3 * z53))
        z55 = z13 * z51 - (z10 * z50 - (z9 * z53 - z12 * z52)) - z16 * z54
        z56 = z43 * (z19 * z54 - z22 * z55)
        z57 = z21 * z55 - z22 * z56
        z58 = z15 * z54 - z16 * z57 + z19 * z56
        z59 = s_phi * z24
        s1 = c_theta * (phi_dot * z59 + (z33 * z8 - z11 * z47))
        z60 = s_theta * (2.0 * (z31 * z24) - z8 * z46) + s1
        z61 = z26 * k3
        s2 = k1 * (s_phi * z53 - c_phi * z52)
        s3 = theta_dot * z29 + (s2 + 2.0 * (k3 * (s_theta * z47)))
        z62 = c_theta * s3
        z63 = c_phi * z24
        s4 = c_theta * (phi_dot * z63 + (z33 * z11 + z8 * z47))
        z64 = s_theta * (2.0 * (z36 * z24) + z11 * z46) - s4
        s5 = s_theta * (2.0 * (phi_dot * z61) - I3 * z45) - z62
        z65 = s5 + z4 * z60 + z6 * z64
        z66 = z30 * k3
        s6 = s_theta * (phi_dot * z66 + (z11 * z53 + z8 * z52))
        z67 = c_theta * z41 - s6 + z10 * z60 - z13 * z64
        z68 = z67 + z16 * z65
        z69 = I3 * s_theta
        z70 = z43 * (c_theta * z44 + z69 * z47 + z19 * z65 + z22 * z68)
        z71 = z21 * z68 + z22 * z70
        z72 = z15 * z65 + z16 * z71 + z19 * z70
        z73 = k1 * z32 + s_theta * z59
        z74 = k1 * z37 + s_theta * z63
        z75 = 2.0 * (c_theta * z61) - z4 * z73 + z6 * z74
        s7 = s_theta * z40 + c_theta * z66 + z10 * z73 + z13 * z74
        z76 = s7 - z16 * z75
        z77 = z43 * (theta_dot * z69 - z19 * z75 + z22 * z76)
        z78 = z21 * z76 + z22 * z77
        z79 = z15 * z75 - z16 * z78 - z19 * z77
        z80 = c_phi * z25 - z26 * z8
        z81 = s_phi * z25 + z26 * z11
        z82 = s_theta * z29 + 2.0 * (z4 * z80) + 2.0 * (z6 * z81)
        z83 = 2.0 * (z10 * z80 - z13 * z81) + z16 * z82
        z84 = z43 * (phi_dot * z69 - z19 * z82 - z22 * z83)
        z85 = z21 * z83 - z22 * z84
        z86 = z15 * z82 + z16 * z85 - z19 * z84
        z87 = I3 * z26
        z88 = I3 * z30 - z16 * z87
        z89 = z43 * (z19 * z87 - z22 * z88)
        z90 = z21 * z88 - z22 * z89
        z91 = z15 * z87 - z16 * z90 + z19 * z89
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
            k5 * z50 + z4 * z58 - z10 * z57,
            # (II.3)
            k5 * z60 + z4 * z72 + z10 * z71,
            0.0,
            0.0,
            0.0,
            # (II.3)
            k5 * z73 - z4 * z79 + z10 * z78,
            # (II.3)
            -(2.0 * (k5 * z80) + z4 * z86 + z10 * z85),
            # (II.3)
            z10 * z90 - z4 * z91,
            0.0,
            0.0,
            # (II.3)
            k5 * z51 + z6 * z58 + z13 * z57,
            # (II.3)
            k5 * z64 + z6 * z72 - z13 * z71,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -(k5 * z74 + z6 * z79 + z13 * z78),
            # (II.3)
            z13 * z85 - (2.0 * (k5 * z81) + z6 * z86),
            # (II.3)
            -(z6 * z91 + z13 * z90),
            0.0,
            0.0,
            # (II.3)
            -z58,
            # (II.3)
            -z72,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z79,
            # (II.3)
            z86,
            # (II.3)
            z91,
            0.0,
            0.0,
            # (II.3)
            z57,
            # (II.3)
            -z71,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -z78,
            # (II.3)
            z85,
            # (II.3)
            -z90,
            0.0,
            0.0,
            # (II.3)
            z56,
            # (II.3)
            z70,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z77,
            # (II.3)
            z84,
            # (II.3)
            -z89,
        ]
        _finish("jacobian", J)
        return [J[k6 : k6 + 10] for k6 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (10,), p (6,).
    Returns out (4,).
    """
    phi = float(y[2])  # precession [rad]
    theta = float(y[3])  # nutation [rad]
    x_dot = float(y[5])
    y_dot = float(y[6])
    phi_dot = float(y[7])
    theta_dot = float(y[8])
    psi_dot = float(y[9])
    m = float(p[0])  # mass [kg]
    R = float(p[1])  # radius [m]
    e = float(p[2])  # centre of mass along the axis of symmetry [m]
    I1 = float(p[3])  # across the axis, at the centre of mass [kg*m^2]
    I3 = float(p[4])  # about the axis [kg*m^2]
    try:
        # parameters only
        k1 = R * I1
        # state
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
