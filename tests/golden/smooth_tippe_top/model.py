"""smooth_tippe_top, emitted by nhc 0.1.0 (nhc:2b34b40bcf85f0ca).

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

Operations:
rhs: 25 +-, 60 *, 4 /, 4 calls
velocities: 0 +-, 0 *, 0 /, 0 calls
accelerations: 25 +-, 62 *, 4 /, 4 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 0 +-, 0 *, 0 /, 0 calls
reactions: 8 +-, 21 *, 2 /, 4 calls
energy: 11 +-, 25 *, 0 /, 4 calls
jacobian: 77 +-, 184 *, 4 /, 4 calls
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
            raise _refuse(abs(m), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = m * e
        k2 = g * k1
        k3 = 1.0 / m
        k4 = I1 + e * k1
        k5 = I3 - k4
        # from the state
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        z1 = s_theta * k1
        z2 = s_phi * z1
        z3 = z2 * k3
        c_phi = math.cos(phi)
        z4 = c_phi * z1
        z5 = z4 * k3
        z6 = I3 - s_theta * s_theta * k5
        z7 = z2 * z3 + (z4 * z5 - z6)
        # the mass matrix is singular
        if not abs(-z7) > 1e-13 * z6:
            raise _refuse(abs(-z7), 1e-13 * z6, 2, "rhs")
        c_theta = math.cos(theta)
        z8 = c_theta * k1
        z9 = c_phi * z8
        z10 = k3 * z9
        z11 = s_phi * z8
        z12 = k3 * z11
        z13 = z9 * z10 - (k4 - z11 * z12)
        # the mass matrix is singular
        if not abs(-z13) > 1e-13 * k4:
            raise _refuse(abs(-z13), 1e-13 * k4, 2, "rhs")
        z14 = I3 * c_theta
        z15 = 1.0 / z7
        z16 = z14 * z15
        z17 = I3 + z14 * z16
        # the mass matrix is singular
        if not abs(z17) > 1e-13 * I3:
            raise _refuse(abs(z17), 1e-13 * I3, 2, "rhs")
        z18 = theta_dot * s_theta
        z19 = theta_dot * z18
        z20 = phi_dot * s_theta
        z21 = theta_dot * c_theta
        s1 = s_phi * z19 + phi_dot * (s_phi * z20 - 2.0 * (c_phi * z21))
        z22 = k1 * s1
        z23 = psi_dot * I3
        z24 = phi_dot * c_theta * k5
        s2 = c_phi * z19 + phi_dot * (c_phi * z20 + 2.0 * (s_phi * z21))
        z25 = k1 * s2
        z26 = z18 * (z23 + 2.0 * z24) - z5 * z22 + z3 * z25
        z27 = (I3 * (theta_dot * z20) + z16 * z26) / z17
        z28 = z15 * z26 - z16 * z27
        s3 = s_theta * (k2 - phi_dot * (z23 + z24)) - z12 * z22
        z29 = (s3 - z10 * z25) / z13
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
            k3 * z22 + z5 * z28 + z12 * z29,
            # y'' (II.3) 24:4
            -(k3 * z25 - z3 * z28 + z10 * z29),
            # phi'' (II.3) 24:4
            -z28,
            # theta'' (II.3) 24:4
            -z29,
            # psi'' (II.3) 24:4
            z27,
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
        # from the state
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
            raise _refuse(abs(m), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = g * k1
        k5 = 1.0 / m
        # from the state
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
        if not abs(z7) > 1e-13 * z1:
            raise _refuse(abs(z7), 1e-13 * z1, 2, "accelerations")
        c_theta = math.cos(theta)
        z8 = c_theta * k1
        z9 = c_phi * z8
        z10 = k5 * z9
        z11 = s_phi * z8
        z12 = k5 * z11
        z13 = z9 * z10 - (k2 - z11 * z12)
        # the mass matrix is singular
        if not abs(-z13) > 1e-13 * k2:
            raise _refuse(abs(-z13), 1e-13 * k2, 2, "accelerations")
        z14 = I3 * c_theta
        z15 = 1.0 / z7
        z16 = z14 * z15
        z17 = I3 - z14 * z16
        # the mass matrix is singular
        if not abs(z17) > 1e-13 * I3:
            raise _refuse(abs(z17), 1e-13 * I3, 2, "accelerations")
        z18 = s_theta * theta_dot * theta_dot
        z19 = phi_dot * s_theta
        z20 = theta_dot * c_theta
        s1 = s_phi * z18 + phi_dot * (s_phi * z19 - 2.0 * (c_phi * z20))
        z21 = k1 * s1
        z22 = phi_dot * c_theta * k3
        z23 = psi_dot * I3
        s2 = c_phi * z18 + phi_dot * (c_phi * z19 + 2.0 * (s_phi * z20))
        z24 = k1 * s2
        s3 = theta_dot * s_theta * (2.0 * z22 + z23) - z4 * z21
        z25 = s3 + z6 * z24
        z26 = (I3 * (theta_dot * z19) - z16 * z25) / z17
        z27 = z15 * z25 - z16 * z26
        s4 = s_theta * (phi_dot * (z22 + z23) - k4) + z12 * z21
        z28 = (s4 + z10 * z24) / z13
        qddot: list[float] = [
            # x'' (II.3)
            k5 * z21 - z4 * z27 - z12 * z28,
            # y'' (II.3)
            z10 * z28 - (k5 * z24 + z6 * z27),
            # phi'' (II.3)
            z27,
            # theta'' (II.3)
            z28,
            # psi'' (II.3)
            z26,
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
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (10,), p (6,).
    Returns lambda_ (0,).
    The force on q_i gains lambda_a times the coefficient of q'_i in constraint a,
        for each a.
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
            raise _refuse(abs(m), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = 1.0 / m
        # from the state
        s_theta = math.sin(theta)
        z1 = I3 - s_theta * s_theta * k3
        c_phi = math.cos(phi)
        z2 = s_theta * k1
        z3 = c_phi * z2
        s_phi = math.sin(phi)
        z4 = s_phi * z2
        z5 = z1 - k4 * (z3 * z3) - k4 * (z4 * z4)
        # the mass matrix is singular
        if not abs(z5) > 1e-13 * z1:
            raise _refuse(abs(z5), 1e-13 * z1, 2, "reactions")
        c_theta = math.cos(theta)
        z6 = c_theta * k1
        z7 = s_phi * z6
        z8 = c_phi * z6
        s1 = k2 - k4 * (z7 * z7)
        s2 = s1 - k4 * (z8 * z8)
        # the mass matrix is singular
        if not abs(s2) > 1e-13 * k2:
            raise _refuse(abs(s2), 1e-13 * k2, 2, "reactions")
        z9 = I3 * c_theta
        s3 = I3 - z9 * z9 / z5
        # the mass matrix is singular
        if not abs(s3) > 1e-13 * I3:
            raise _refuse(abs(s3), 1e-13 * I3, 2, "reactions")
        lambda_: list[float] = []
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V

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
    """Jacobian matrix of rhs, d rhs_i / d y_j (II.3)

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
            raise _refuse(abs(m), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = m * e
        k2 = I1 + m * (e * e)
        k3 = I3 - k2
        k4 = g * k1
        k5 = 1.0 / m
        # from the state
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
        if not abs(z7) > 1e-13 * z1:
            raise _refuse(abs(z7), 1e-13 * z1, 2, "jacobian")
        c_theta = math.cos(theta)
        z8 = s_phi * k1
        z9 = c_theta * z8
        z10 = z9 * k5
        z11 = c_phi * k1
        z12 = c_theta * z11
        z13 = z12 * k5
        z14 = k2 - z9 * z10 - z12 * z13
        # the mass matrix is singular
        if not abs(z14) > 1e-13 * k2:
            raise _refuse(abs(z14), 1e-13 * k2, 2, "jacobian")
        z15 = I3 * c_theta
        z16 = 1.0 / z7
        z17 = z15 * z16
        z18 = I3 - z15 * z17
        # the mass matrix is singular
        if not abs(z18) > 1e-13 * I3:
            raise _refuse(abs(z18), 1e-13 * I3, 2, "jacobian")
        z19 = phi_dot * k1
        z20 = c_theta * z19
        z21 = phi_dot * s_theta
        z22 = theta_dot * s_phi
        z23 = c_phi * z21 + 2.0 * (c_theta * z22)
        z24 = theta_dot * theta_dot
        z25 = s_theta * z24
        z26 = k1 * (phi_dot * z23 + c_phi * z25)
        z27 = theta_dot * c_phi
        z28 = s_phi * z21 - 2.0 * (c_theta * z27)
        z29 = k1 * (phi_dot * z28 + s_phi * z25)
        z30 = theta_dot * s_theta
        z31 = psi_dot * I3
        z32 = phi_dot * k3
        z33 = c_theta * z32
        z34 = z31 + 2.0 * z33
        z35 = z26 * z6 - (z29 * z4 - z30 * z34)
        z36 = 1.0 / z18
        z37 = I3 * (phi_dot * theta_dot)
        z38 = z36 * (s_theta * z37 - z17 * z35)
        z39 = z16 * z35 - z17 * z38
        z40 = 2.0 * (theta_dot * z20) + z2 * z39
        z41 = 1.0 / z14
        z42 = k4 - phi_dot * (z31 + z33)
        z43 = z41 * (z26 * z13 + (z29 * z10 - s_theta * z42))
        z44 = k1 * z25 + z21 * z19 + k1 * (c_theta * z43)
        z45 = k5 * (s_phi * z40 + c_phi * z44)
        z46 = s_phi * z19
        s1 = c_theta * (phi_dot * z46 + (z24 * z8 - z11 * z39))
        z47 = s_theta * (2.0 * (z27 * z19) - z8 * z43) + s1
        z48 = z30 * k3
        z49 = k5 * (s_phi * z44 - c_phi * z40)
        z50 = s_theta * z39
        s2 = k1 * (s_phi * z45 - c_phi * z49) + 2.0 * (k3 * z50)
        s3 = s_theta * (2.0 * (phi_dot * z48) - I3 * z38)
        z51 = s3 - c_theta * (theta_dot * z34 + s2)
        z52 = c_phi * z19
        s4 = c_theta * (phi_dot * z52 + (z24 * z11 + z8 * z39))
        z53 = s_theta * (2.0 * (z22 * z19) + z11 * z43) - s4
        z54 = z51 + z4 * z47 + z6 * z53
        z55 = z36 * (c_theta * z37 + I3 * z50 + z17 * z54)
        z56 = z16 * z54 + z17 * z55
        s5 = s_theta * (z21 * z32 + (z11 * z45 + z8 * z49))
        z57 = c_theta * z42 + s5 - z10 * z47 + z13 * z53
        z58 = z41 * z57
        z59 = k1 * z28 + s_theta * z46
        z60 = k1 * z23 + s_theta * z52
        z61 = 2.0 * (c_theta * z48) - z4 * z59 + z6 * z60
        z62 = I3 * z30
        z63 = z36 * (z62 - z17 * z61)
        z64 = z16 * z61 - z17 * z63
        z65 = z13 * z60 + (z10 * z59 + s_theta * z34)
        z66 = z41 * z65
        z67 = c_phi * z20 - theta_dot * z5
        z68 = s_phi * z20 + theta_dot * z3
        z69 = z41 * (z10 * z67 - z13 * z68)
        z70 = I3 * z21
        z71 = z36 * (z70 - z17 * z65)
        z72 = z16 * z65 - z17 * z71
        z73 = z41 * z70
        z74 = z62 * (z17 * z36)
        z75 = z16 * z62 + z17 * z74
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
            z45,
            # (II.3)
            k5 * z47 + z4 * z56 - z10 * z58,
            0.0,
            0.0,
            0.0,
            # (II.3)
            k5 * z59 - z4 * z64 + z10 * z66,
            # (II.3)
            -(2.0 * (z10 * z69) + (2.0 * (k5 * z67) + z4 * z72)),
            # (II.3)
            z10 * z73 - z4 * z75,
            0.0,
            0.0,
            # (II.3)
            z49,
            # (II.3)
            k5 * z53 + z6 * z56 + z13 * z58,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -(k5 * z60 + z6 * z64 + z13 * z66),
            # (II.3)
            2.0 * (z13 * z69) - (2.0 * (k5 * z68) + z6 * z72),
            # (II.3)
            -(z13 * z73 + z6 * z75),
            0.0,
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            -z56,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z64,
            # (II.3)
            z72,
            # (II.3)
            z75,
            0.0,
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            z58,
            0.0,
            0.0,
            0.0,
            # (II.3)
            -z66,
            # (II.3)
            2.0 * z69,
            # (II.3)
            -z73,
            0.0,
            0.0,
            # (II.3)
            0.0,
            # (II.3)
            z55,
            0.0,
            0.0,
            0.0,
            # (II.3)
            z63,
            # (II.3)
            z71,
            # (II.3)
            -z74,
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
