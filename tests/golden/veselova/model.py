"""veselova, emitted by nhc 0.1.0 (nhc:4811f8e429aaa7c0).

A rigid body with a fixed point that must not turn about the vertical.
Source: veselova.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = phi [rad]: precession
y[1] = theta [rad]: nutation
y[2] = psi [rad]: spin
y[3] = w_x
y[4] = w_y

Parameters p:
p[0]: I1 = 1.0 [kg*m^2]
p[1]: I2 = 1.7 [kg*m^2]
p[2]: I3 = 2.3 [kg*m^2]

Constraints:
0: no_turn

Outputs:
out[0] = L_x
out[1] = L_y

Operations:
rhs: 30 +-, 57 *, 3 /, 6 calls
velocities: 2 +-, 9 *, 1 /, 4 calls
accelerations: 41 +-, 79 *, 4 /, 6 calls
state: 2 +-, 6 *, 0 /, 3 calls
residuals: 1 +-, 1 *, 0 /, 1 calls
reactions: 61 +-, 126 *, 4 /, 6 calls
energy: 7 +-, 23 *, 1 /, 6 calls
jacobian: 108 +-, 218 *, 4 /, 6 calls
outputs: 10 +-, 29 *, 1 /, 6 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("phi", "theta", "psi")
STATE: tuple[str, ...] = ("phi", "theta", "psi", "w_x", "w_y")
PARAMETERS: tuple[str, ...] = ("I1", "I2", "I3")
CONSTRAINTS: tuple[str, ...] = ("no_turn",)
OUTPUTS: tuple[str, ...] = ("L_x", "L_y")
DEFAULTS: tuple[float, ...] = (1.0, 1.7, 2.3)

REASONS = (
    "",
    "the coframe is singular",
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
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (5,), p (3,).
    Returns dydt (5,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # parameters only
        k1 = 2.0 * I1 - 2.0 * I2
        k2 = I1 - I2
        k3 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "rhs")
        s_phi = math.sin(phi)
        z1 = s_theta * s_theta
        s_psi = math.sin(psi)
        z2 = s_psi * s_psi
        z3 = 1.0 - z2
        s1 = I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1
        z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + s1
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z5 = c_theta * (s_psi * c_psi)
        z6 = I1 * z3 + I2 * z2
        z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6
        # the mass matrix is singular
        if not abs(-z7) > 0.0:
            raise SingularModelError(2, "rhs")
        z8 = k1 * (s_phi * z5)
        z9 = c_theta * c_theta
        s2 = z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9))
        z10 = z8 + c_phi * s2
        z11 = z6 + c_phi * z10
        z12 = s_phi * (c_phi * z4 - z8) + z5 * k2
        z13 = 1.0 / z7
        z14 = z12 * z13
        z15 = z11 + z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "rhs")
        z16 = 1.0 / s_theta
        z17 = s_phi * w_x - c_phi * w_y
        z18 = z16 * z17
        s3 = c_psi * (c_phi * w_x + s_phi * w_y)
        s4 = s_psi * (k2 * (z17 * (s_psi * c_theta) - s3))
        z19 = s4 + c_theta * (z17 * k3)
        z20 = s_theta * w_y * z19
        z21 = (z19 * (s_theta * w_x) - z20 * z14) / z15
        dydt: list[float] = [
            # phi' (I.2.15)
            -c_theta * z18,
            # theta' (I.2.15)
            (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z16,
            # psi' (I.2.15)
            z18,
            # w_x' (I.2.15) 24:4
            -(z20 * z13 + z14 * z21),
            # w_y' (I.2.15) 24:4
            -z21,
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

    Arguments: t (scalar), y (5,), p (3,).
    Returns qdot (3,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    try:
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "velocities")
        c_theta = math.cos(theta)
        z1 = 1.0 / s_theta
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z2 = z1 * (s_phi * w_x - c_phi * w_y)
        qdot: list[float] = [
            # phi' (I.2.4)
            -c_theta * z2,
            # theta' (I.2.4)
            (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1,
            # psi' (I.2.4)
            z2,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """all accelerations q'' on the motion (I.2.15)

    Arguments: t (scalar), y (5,), p (3,).
    Returns qddot (3,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # parameters only
        k1 = 2.0 * I1 - 2.0 * I2
        k2 = I1 - I2
        k3 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "accelerations")
        s_phi = math.sin(phi)
        z1 = s_theta * s_theta
        s_psi = math.sin(psi)
        z2 = s_psi * s_psi
        z3 = 1.0 - z2
        s1 = I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1
        z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + s1
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z5 = c_theta * (s_psi * c_psi)
        z6 = I1 * z3 + I2 * z2
        z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6
        # the mass matrix is singular
        if not abs(-z7) > 0.0:
            raise SingularModelError(2, "accelerations")
        z8 = k1 * (s_phi * z5)
        z9 = c_theta * c_theta
        s2 = z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9))
        z10 = z8 + c_phi * s2
        z11 = z6 + c_phi * z10
        z12 = s_phi * (c_phi * z4 - z8) + z5 * k2
        z13 = 1.0 / z7
        z14 = z12 * z13
        z15 = z11 + z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "accelerations")
        z16 = s_theta * s_phi
        z17 = s_theta * c_phi
        z18 = z16 * w_y + z17 * w_x
        z19 = 1.0 / s_theta
        z20 = s_phi * w_x - c_phi * w_y
        z21 = z19 * z20
        z22 = c_theta * (z18 * z19)
        z23 = z22 / (s_theta * s_theta)
        z24 = c_theta * z21
        z25 = c_phi * z24
        s3 = c_psi * (c_phi * w_x + s_phi * w_y)
        s4 = s_psi * (k2 * (z20 * (s_psi * c_theta) - s3))
        z26 = s4 + c_theta * (z20 * k3)
        z27 = s_theta * w_y * z26
        z28 = (z26 * (s_theta * w_x) - z27 * z14) / z15
        z29 = z27 * z13 + z14 * z28
        z30 = s_phi * z24
        s5 = z19 * (w_x * z25 + s_phi * z29 + (w_y * z30 - c_phi * z28))
        z31 = z20 * z23 + s5
        s6 = w_y * (s_phi * z22 - s_theta * z25) - z16 * z28
        z32 = s6 + (w_x * (c_phi * z22 + s_theta * z30) - z17 * z29)
        qddot: list[float] = [
            # phi'' (I.2.15)
            z18 * z21 + c_theta * z31,
            # theta'' (I.2.15)
            z19 * z32 - z18 * z23,
            # psi'' (I.2.15)
            -z31,
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

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns y (5,).
    """
    phi = float(q[0])  # precession [rad]
    theta = float(q[1])  # nutation [rad]
    psi = float(q[2])  # spin [rad]
    theta_dot = float(qdot[1])
    psi_dot = float(qdot[2])
    try:
        # state
        c_phi = math.cos(phi)
        s_theta = math.sin(theta)
        s_phi = math.sin(phi)
        y: list[float] = [
            phi,
            theta,
            psi,
            theta_dot * c_phi + psi_dot * (s_theta * s_phi),
            theta_dot * s_phi - psi_dot * (s_theta * c_phi),
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

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns r (1,).
    """
    theta = float(q[1])  # nutation [rad]
    phi_dot = float(qdot[0])
    psi_dot = float(qdot[2])
    try:
        # state
        c_theta = math.cos(theta)
        r: list[float] = [
            # no_turn = 0 (I.1.1) 26:5
            phi_dot + psi_dot * c_theta,
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

    Arguments: t (scalar), y (5,), p (3,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # parameters only
        k1 = 2.0 * I1 - 2.0 * I2
        k2 = I1 - I2
        k3 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "reactions")
        s_phi = math.sin(phi)
        z1 = s_theta * s_theta
        s_psi = math.sin(psi)
        z2 = s_psi * s_psi
        z3 = 1.0 - z2
        s1 = I1 * (1.0 - z2 * (2.0 - z1)) - I3 * z1
        z4 = I2 * (z1 * z3 - (1.0 - 2.0 * z2)) + s1
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z5 = c_theta * (s_psi * c_psi)
        z6 = I1 * z3 + I2 * z2
        z7 = s_phi * (s_phi * z4 + c_phi * z5 * k1) - z6
        # the mass matrix is singular
        if not abs(-z7) > 0.0:
            raise SingularModelError(2, "reactions")
        z8 = k1 * (s_phi * z5)
        z9 = c_theta * c_theta
        s2 = z2 * (k2 * (1.0 + z9)) + (I3 * (1.0 - z9) - (I1 - I2 * z9))
        z10 = z8 + c_phi * s2
        z11 = z6 + c_phi * z10
        z12 = s_phi * (c_phi * z4 - z8) + z5 * k2
        z13 = 1.0 / z7
        z14 = z12 * z13
        z15 = z11 + z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "reactions")
        z16 = s_theta * s_phi * w_y + s_theta * c_phi * w_x
        z17 = 1.0 / s_theta
        z18 = s_phi * w_x - c_phi * w_y
        z19 = z17 * z18
        z20 = c_theta * z19
        z21 = z16 * z17
        z22 = c_theta * z21
        z23 = z22 / (s_theta * s_theta)
        z24 = c_phi * z20
        z25 = s_phi * z20
        z26 = z18 * z23 + z17 * (w_x * z24 + w_y * z25)
        z27 = z16 * z19 + c_theta * z26
        z28 = s_theta * c_psi
        z29 = s_psi * z19
        z30 = c_psi * z22 - s_theta * z29
        z31 = c_psi * z19
        s3 = w_y * (s_phi * z22 - s_theta * z24)
        z32 = z17 * (s3 + w_x * (c_phi * z22 + s_theta * z25)) - z16 * z23
        z33 = s_theta * s_psi
        z34 = s_psi * z22 + s_theta * z31
        s4 = I1 * (z20 * z34 - z33 * z27 + (z21 * z29 - c_psi * z32))
        z35 = z33 * s4 + I1 * (z33 * z20 - c_psi * z21) * z34
        s5 = I2 * (z20 * z30 - z28 * z27 + (z21 * z31 + s_psi * z32))
        z36 = I2 * (z28 * z20 + s_psi * z21) * z30 + (z28 * s5 + z35)
        s6 = c_theta * (I3 * (z26 - (z16 * z20 + c_theta * z27))) + z36
        z37 = z16 * (I3 * (z19 - c_theta * z20)) + s6
        z38 = s_psi * c_theta
        s7 = k2 * (z18 * z38 - c_psi * (c_phi * w_x + s_phi * w_y))
        z39 = s_psi * s7 + c_theta * (z18 * k3)
        z40 = s_theta * w_y * z39
        z41 = (z39 * (s_theta * w_x) - z40 * z14) / z15
        s8 = s_psi * (k2 * (c_psi * c_phi - s_phi * z38))
        s9 = s_theta * (s8 - c_theta * s_phi * k3)
        z42 = s9 * (z40 * z13 + z14 * z41)
        s10 = s_psi * (k2 * (c_psi * s_phi + c_phi * z38))
        z43 = z42 + s_theta * (s10 + c_theta * c_phi * k3) * z41
        lambda_: list[float] = [
            # reaction of no_turn: Q_i gains lambda_1 a_1i (I.4.1) 26:5
            -(z37 + z43),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (5,), p (3,).
    Returns a scalar.
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # state
        s_theta = math.sin(theta)
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        z1 = 1.0 / s_theta
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z2 = z1 * (s_phi * w_x - c_phi * w_y)
        z3 = c_theta * z2
        c_psi = math.cos(psi)
        z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1
        z5 = s_theta * s_psi * z3 - c_psi * z4
        z6 = s_theta * c_psi * z3 + s_psi * z4
        omega3 = z2 - c_theta * z3
        s1 = I1 * (z5 * z5) + I2 * (z6 * z6) + I3 * (omega3 * omega3)
        value1 = 0.5 * s1
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (5,), p (3,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # parameters only
        k1 = 2.0 * I1 - 2.0 * I2
        k2 = I1 - I2
        k3 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "jacobian")
        s_phi = math.sin(phi)
        z1 = s_theta * s_theta
        s_psi = math.sin(psi)
        z2 = s_psi * s_psi
        z3 = 1.0 - z2
        z4 = 2.0 - z1
        s1 = I2 * (z1 * z3 - (1.0 - 2.0 * z2))
        z5 = s1 + (I1 * (1.0 - z2 * z4) - I3 * z1)
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z6 = s_psi * c_psi
        z7 = c_theta * z6
        z8 = s_phi * z5 + c_phi * z7 * k1
        z9 = I1 * z3 + I2 * z2
        z10 = s_phi * z8 - z9
        # the mass matrix is singular
        if not abs(-z10) > 0.0:
            raise SingularModelError(2, "jacobian")
        z11 = k1 * (s_phi * z7)
        z12 = c_theta * c_theta
        z13 = k2 * (1.0 + z12)
        z14 = z2 * z13 + (I3 * (1.0 - z12) - (I1 - I2 * z12))
        z15 = z11 + c_phi * z14
        z16 = z9 + c_phi * z15
        z17 = c_phi * z5 - z11
        z18 = s_phi * z17 + z7 * k2
        z19 = 1.0 / z10
        z20 = z18 * z19
        z21 = z16 + z18 * z20
        # the mass matrix is singular
        if not abs(z21) > 1e-14 * z16:
            raise SingularModelError(2, "jacobian")
        z22 = 1.0 / s_theta
        z23 = c_theta * z22
        z24 = s_phi * w_x - c_phi * w_y
        z25 = 1.0 / (s_theta * s_theta)
        z26 = c_phi * (w_x * z22)
        z27 = s_phi * (w_y * z22)
        z28 = s_theta * w_y
        z29 = s_psi * c_theta
        z30 = k2 * (s_psi * z28)
        z31 = k3 * (c_theta * z28) + z29 * z30
        z32 = c_psi * z30
        z33 = 1.0 / z21
        z34 = c_phi * w_x + s_phi * w_y
        z35 = k2 * (z24 * z29 - c_psi * z34)
        z36 = z24 * k3
        z37 = s_psi * z35 + c_theta * z36
        z38 = s_theta * w_x
        z39 = z28 * z37
        z40 = z33 * (z37 * z38 - z39 * z20)
        z41 = s_phi * z40
        z42 = k1 * z41
        z43 = z39 * z19 + z20 * z40
        z44 = s_phi * z43
        z45 = z5 * z44
        s2 = w_y * z32 - z17 * z40 + z7 * z42 + z8 * z43 + z45
        z46 = c_phi * (w_x * z31 - s2)
        z47 = k1 * z44
        s3 = s_phi * (w_y * z31 + (w_x * z32 - z5 * z41 + z7 * z47))
        z48 = z46 + s3
        z49 = k2 * (s_psi * z38)
        z50 = k3 * (c_theta * z38) + z29 * z49
        z51 = c_psi * z49
        z52 = c_phi * z40
        z53 = k1 * (z44 - z52)
        s4 = w_y * z50 + (z45 + (w_x * z51 + (z15 * z40 + z14 * z52)))
        s5 = c_phi * (w_x * z50 - (w_y * z51 + z17 * z43 - z7 * z53))
        z54 = s5 + s_phi * s4
        z55 = z33 * (z54 - z20 * z48)
        z56 = z24 * z30
        z57 = k2 * z40 - s_phi * z42 - c_phi * z47
        z58 = c_phi * z41 - s_phi * z44
        z59 = I1 * z58
        z60 = I2 * z58
        s6 = 2.0 * (s_theta * (I3 * z58 - z2 * z59 - z3 * z60))
        s7 = s_theta * (z28 * z36 + s_psi * z56 + z6 * z57)
        z61 = s7 - c_theta * (w_y * z37 - s6)
        z62 = z24 * z49
        z63 = c_phi * z52
        z64 = k2 * z43 - s_phi * z53
        s8 = z36 * z38 - 2.0 * (c_theta * (k2 * (z2 * z63) + k3 * z63))
        z65 = s_psi * z62 + s8 - z6 * z64
        z66 = c_phi * z44
        z67 = I1 * z66
        z68 = I2 * z66
        s9 = 2.0 * (s_theta * (I3 * z66 - z2 * z67 - z3 * z68))
        z69 = s_theta * z65 - c_theta * (w_x * z37 + s9)
        z70 = z33 * (z69 - z20 * z61)
        z71 = c_theta * z57
        s10 = 2.0 * z60 + (I2 * z43 - z4 * z59) - (I1 * z43 + z1 * z60)
        z72 = 2.0 * (s_psi * s10)
        s11 = c_psi * (z28 * z35 + c_theta * z56 + c_psi * z71 + z72)
        z73 = s_psi * (z34 * z30 - s_psi * z71) + s11
        z74 = c_theta * z64
        s12 = 2.0 * z68 + (z13 * z63 + I2 * z40 - z4 * z67)
        z75 = s12 - (I1 * z40 + z1 * z68)
        s13 = z35 * z38 + c_theta * z62 - c_psi * z74
        s14 = c_psi * (s13 - 2.0 * (s_psi * z75))
        z76 = s_psi * (z34 * z49 + s_psi * z74) + s14
        z77 = z33 * (z76 - z20 * z73)
        z78 = c_phi * z32 - s_phi * z31
        z79 = s_theta * z37
        z80 = z33 * (z79 - c_phi * z51 + s_phi * z50 + z20 * z78)
        z81 = s_phi * z32 - z79 + c_phi * z31
        z82 = z33 * (s_phi * z51 + c_phi * z50 - z20 * z81)
        s15 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z25 - z26
        J: list[float] = [
            # (I.2.15)
            -(c_phi * (w_x * z23) + s_phi * (w_y * z23)),
            # (I.2.15)
            z24 + c_theta * (z25 * (c_theta * z24)),
            # (I.2.15)
            0.0,
            # (I.2.15)
            -s_phi * z23,
            # (I.2.15)
            c_phi * z23,
            # (I.2.15)
            -z24,
            # (I.2.15)
            -c_theta * (s15 - z27),
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_phi,
            # (I.2.15)
            s_phi,
            # (I.2.15)
            z26 + z27,
            # (I.2.15)
            -c_theta * (z24 * z25),
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_phi * z22,
            # (I.2.15)
            -c_phi * z22,
            # (I.2.15)
            -(z19 * z48 + z20 * z55),
            # (I.2.15)
            z19 * z61 + z20 * z70,
            # (I.2.15)
            -(z19 * z73 + z20 * z77),
            # (I.2.15)
            z19 * z78 - z20 * z80,
            # (I.2.15)
            z19 * z81 + z20 * z82,
            # (I.2.15)
            -z55,
            # (I.2.15)
            z70,
            # (I.2.15)
            -z77,
            # (I.2.15)
            -z80,
            # (I.2.15)
            z82,
        ]
        _finish("jacobian", J)
        return [J[k4 : k4 + 5] for k4 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (5,), p (3,).
    Returns out (2,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])
    w_y = float(y[4])
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "outputs")
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        z1 = 1.0 / s_theta
        s_phi = math.sin(phi)
        z2 = z1 * (s_phi * w_x - c_phi * w_y)
        z3 = c_theta * z2
        z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1
        z5 = I1 * (s_theta * s_psi * z3 - c_psi * z4)
        z6 = I2 * (s_theta * c_psi * z3 + s_psi * z4)
        z7 = c_psi * z5 - s_psi * z6
        s1 = s_theta * (I3 * (z2 - c_theta * z3))
        z8 = c_theta * (s_psi * z5 + c_psi * z6) + s1
        out: list[float] = [
            # L_x 32:8
            s_phi * z8 - c_phi * z7,
            # L_y 33:8
            -(s_phi * z7 + c_phi * z8),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
