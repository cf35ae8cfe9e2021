"""veselova, emitted by nhc 0.1.0 (nhc:a4142730e1bd8188).

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
rhs: 29 +-, 52 *, 3 /, 6 calls
velocities: 2 +-, 9 *, 1 /, 4 calls
accelerations: 40 +-, 76 *, 3 /, 6 calls
state: 2 +-, 5 *, 0 /, 3 calls
residuals: 1 +-, 1 *, 0 /, 1 calls
reactions: 60 +-, 115 *, 3 /, 6 calls
energy: 7 +-, 22 *, 1 /, 6 calls
jacobian: 105 +-, 215 *, 3 /, 6 calls
outputs: 10 +-, 28 *, 1 /, 6 calls

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
        k1 = I1 - I2
        k2 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "rhs")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = 1.0 - z1
        z3 = I1 * z2 + I2 * z1
        s_phi = math.sin(phi)
        z4 = s_theta * s_theta
        s1 = I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4
        z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + s1
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        c_theta = math.cos(theta)
        z6 = s_psi * c_theta
        z7 = k1 * (c_psi * z6)
        z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7))
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "rhs")
        z9 = 2.0 * (s_phi * z7)
        z10 = c_theta * c_theta
        s2 = I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10))
        z11 = z9 + c_phi * s2
        z12 = z3 + c_phi * z11
        z13 = z7 + s_phi * (c_phi * z5 - z9)
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "rhs")
        z17 = 1.0 / s_theta
        z18 = s_phi * w_x - c_phi * w_y
        z19 = z17 * z18
        z20 = s_theta * w_y
        z21 = s_theta * w_x
        s3 = s_psi * (z18 * z6 - c_psi * (c_phi * w_x + s_phi * w_y))
        z22 = k1 * s3 + k2 * (c_theta * z18)
        z23 = z20 * z22
        z24 = (z21 * z22 + z23 * z15) / z16
        dydt: list[float] = [
            # phi' (I.2.15)
            -c_theta * z19,
            # theta' (I.2.15)
            z17 * (s_phi * z20 + c_phi * z21),
            # psi' (I.2.15)
            z19,
            # w_x' (I.2.15) 24:4
            z23 * z14 + z15 * z24,
            # w_y' (I.2.15) 24:4
            -z24,
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
        k1 = I1 - I2
        k2 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "accelerations")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = 1.0 - z1
        z3 = I1 * z2 + I2 * z1
        s_phi = math.sin(phi)
        z4 = s_theta * s_theta
        s1 = I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4
        z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + s1
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        c_theta = math.cos(theta)
        z6 = s_psi * c_theta
        z7 = k1 * (c_psi * z6)
        z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7))
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "accelerations")
        z9 = 2.0 * (s_phi * z7)
        z10 = c_theta * c_theta
        s2 = I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10))
        z11 = z9 + c_phi * s2
        z12 = z3 + c_phi * z11
        z13 = z7 + s_phi * (c_phi * z5 - z9)
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "accelerations")
        z17 = s_theta * s_phi
        z18 = s_theta * c_phi
        z19 = z17 * w_y + z18 * w_x
        z20 = 1.0 / s_theta
        z21 = s_phi * w_x - c_phi * w_y
        z22 = z20 * z21
        z23 = z20 * (c_theta * z19)
        z24 = z20 * z20 * z23
        z25 = c_theta * z22
        z26 = c_phi * z25
        s3 = s_psi * (z21 * z6 - c_psi * (c_phi * w_x + s_phi * w_y))
        z27 = k1 * s3 + k2 * (c_theta * z21)
        z28 = s_theta * z27
        z29 = w_y * z28
        z30 = (w_x * z28 + z15 * z29) / z16
        z31 = z14 * z29 + z15 * z30
        z32 = s_phi * z25
        s4 = z20 * (w_x * z26 - s_phi * z31 + (w_y * z32 - c_phi * z30))
        z33 = z21 * z24 + s4
        s5 = w_y * (s_theta * z26 - s_phi * z23) + z17 * z30
        z34 = s5 - (w_x * (s_theta * z32 + c_phi * z23) + z18 * z31)
        qddot: list[float] = [
            # phi'' (I.2.15)
            z19 * z22 + c_theta * z33,
            # theta'' (I.2.15)
            -(z19 * z24 + z20 * z34),
            # psi'' (I.2.15)
            -z33,
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
        s_phi = math.sin(phi)
        s_theta = math.sin(theta)
        z1 = psi_dot * s_theta
        y: list[float] = [
            phi,
            theta,
            psi,
            theta_dot * c_phi + s_phi * z1,
            theta_dot * s_phi - c_phi * z1,
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
        k1 = I1 - I2
        k2 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "reactions")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = 1.0 - z1
        z3 = I1 * z2 + I2 * z1
        s_phi = math.sin(phi)
        z4 = s_theta * s_theta
        s1 = I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4
        z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + s1
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        c_theta = math.cos(theta)
        z6 = s_psi * c_theta
        z7 = k1 * (c_psi * z6)
        z8 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z7))
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "reactions")
        z9 = 2.0 * (s_phi * z7)
        z10 = c_theta * c_theta
        s2 = I3 * (1.0 - z10) - (I1 - I2 * z10) + k1 * (z1 * (1.0 + z10))
        z11 = z9 + c_phi * s2
        z12 = z3 + c_phi * z11
        z13 = z7 + s_phi * (c_phi * z5 - z9)
        z14 = 1.0 / z8
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "reactions")
        z17 = s_theta * s_psi
        z18 = 1.0 / s_theta
        z19 = s_phi * w_x - c_phi * w_y
        z20 = z18 * z19
        z21 = c_theta * z20
        z22 = c_psi * z20
        z23 = s_theta * w_y
        z24 = s_theta * w_x
        z25 = s_phi * z23 + c_phi * z24
        z26 = z18 * z25
        z27 = c_theta * z26
        z28 = s_theta * z22 + s_psi * z27
        z29 = c_phi * z21
        z30 = s_phi * z21
        z31 = z18 * z18 * z27
        z32 = z18 * (w_x * z29 + w_y * z30) + z19 * z31
        z33 = z20 * z25 + c_theta * z32
        z34 = s_psi * z20
        s3 = w_y * (s_theta * z29 - s_phi * z27)
        z35 = z18 * (s3 - w_x * (s_theta * z30 + c_phi * z27)) + z25 * z31
        s4 = z17 * (z21 * z28 - z17 * z33 + (z34 * z26 + c_psi * z35))
        z36 = s4 + (z17 * z21 - c_psi * z26) * z28
        z37 = s_theta * c_psi
        z38 = s_theta * z34 - c_psi * z27
        s5 = z37 * (z21 * z38 + z37 * z33 - (z22 * z26 - s_psi * z35))
        z39 = s5 + (z37 * z21 + s_psi * z26) * z38
        s6 = c_theta * (z32 - (z21 * z25 + c_theta * z33))
        s7 = I3 * (s6 + (z20 - c_theta * z21) * z25)
        z40 = I1 * z36 - I2 * z39 + s7
        z41 = s_psi * k1
        z42 = c_theta * k2
        s8 = (z19 * z6 - c_psi * (c_phi * w_x + s_phi * w_y)) * z41
        z43 = s8 + z19 * z42
        z44 = z23 * z43
        z45 = (z24 * z43 + z15 * z44) / z16
        s9 = (c_psi * c_phi - s_phi * z6) * z41 - s_phi * z42
        z46 = s9 * (s_theta * (z14 * z44 + z15 * z45))
        s10 = (c_psi * s_phi + c_phi * z6) * z41 + c_phi * z42
        lambda_: list[float] = [
            # reaction of no_turn: Q_i gains lambda_1 a_1i (I.4.1) 26:5
            z46 - s10 * (s_theta * z45) - z40,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

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
        z1 = 1.0 / s_theta
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z2 = z1 * (s_phi * w_x - c_phi * w_y)
        c_theta = math.cos(theta)
        z3 = c_theta * z2
        omega3 = z2 - c_theta * z3
        c_psi = math.cos(psi)
        z4 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1
        s_psi = math.sin(psi)
        z5 = s_theta * z3
        z6 = c_psi * z4 - s_psi * z5
        z7 = s_psi * z4 + c_psi * z5
        s1 = I3 * (omega3 * omega3) + (I1 * (z6 * z6) + I2 * (z7 * z7))
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
        k1 = I1 - I2
        k2 = I2 - I3
        # state
        s_theta = math.sin(theta)
        # the coframe is singular
        if not abs(s_theta) > 1e-12 * 4.0:
            raise SingularModelError(1, "jacobian")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = 1.0 - z1
        z3 = I1 * z2 + I2 * z1
        s_phi = math.sin(phi)
        z4 = s_theta * s_theta
        z5 = 2.0 - z4
        s1 = I2 * (z4 * z2 - (1.0 - 2.0 * z1))
        z6 = s1 + (I1 * (1.0 - z1 * z5) - I3 * z4)
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z7 = s_psi * c_psi
        z8 = c_theta * z7
        z9 = z8 * k1
        z10 = s_phi * z6 + 2.0 * (c_phi * z9)
        z11 = z3 - s_phi * z10
        # the mass matrix is singular
        if not abs(z11) > 0.0:
            raise SingularModelError(2, "jacobian")
        z12 = c_theta * c_theta
        z13 = k1 * (1.0 + z12)
        z14 = z1 * z13 + (I3 * (1.0 - z12) - (I1 - I2 * z12))
        z15 = 2.0 * (s_phi * z9)
        z16 = c_phi * z14 + z15
        z17 = z3 + c_phi * z16
        z18 = c_phi * z6 - z15
        z19 = z9 + s_phi * z18
        z20 = 1.0 / z11
        z21 = z19 * z20
        z22 = z17 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * z17:
            raise SingularModelError(2, "jacobian")
        z23 = 1.0 / s_theta
        z24 = c_phi * w_x + s_phi * w_y
        z25 = z23 * z24
        z26 = s_phi * w_x - c_phi * w_y
        z27 = c_theta * (z23 * z23)
        z28 = z26 * z27
        z29 = s_phi * z23
        z30 = c_phi * z23
        z31 = s_theta * c_phi
        z32 = s_theta * s_phi
        z33 = s_theta * w_y
        z34 = c_theta * k2
        z35 = s_psi * c_theta
        z36 = s_psi * k1
        z37 = z33 * z36
        z38 = z33 * z34 + z35 * z37
        z39 = c_psi * z37
        z40 = 1.0 / z22
        z41 = k1 * (z26 * z35 - c_psi * z24)
        z42 = z26 * k2
        z43 = s_psi * z41 + c_theta * z42
        z44 = s_theta * w_x
        z45 = z33 * z43
        z46 = z40 * (z43 * z44 + z45 * z21)
        z47 = s_phi * z46
        z48 = k1 * z47
        z49 = z45 * z20 + z21 * z46
        z50 = s_phi * z49
        z51 = z6 * z50
        s2 = w_y * z39 - z18 * z46 + 2.0 * (z8 * z48) - z10 * z49 - z51
        z52 = w_x * z38 - s2
        z53 = k1 * z50
        s3 = w_y * z38 + (w_x * z39 - z6 * z47 - 2.0 * (z8 * z53))
        z54 = c_phi * z52 + s_phi * s3
        z55 = z44 * z36
        z56 = z44 * z34 + z35 * z55
        z57 = c_psi * z55
        z58 = c_phi * z46
        z59 = k1 * (z50 + z58)
        s4 = w_x * z56 - (w_y * z57 - z18 * z49 + 2.0 * (z8 * z59))
        s5 = w_y * z56 - (z51 - (w_x * z57 + (z16 * z46 + z14 * z58)))
        z60 = c_phi * s4 + s_phi * s5
        z61 = z40 * (z60 + z21 * z54)
        z62 = z26 * z37
        z63 = k1 * z46 - 2.0 * (s_phi * z48) + 2.0 * (c_phi * z53)
        z64 = c_phi * z47 + s_phi * z50
        z65 = I1 * z64
        z66 = I2 * z64
        s6 = 2.0 * (s_theta * (I3 * z64 - z1 * z65 - z2 * z66))
        s7 = s_theta * (z33 * z42 + s_psi * z62 + z7 * z63)
        z67 = s7 - c_theta * (w_y * z43 - s6)
        z68 = z26 * z55
        z69 = c_phi * z58
        z70 = k1 * z49 - 2.0 * (s_phi * z59)
        s8 = z42 * z44 - 2.0 * (c_theta * (k1 * (z1 * z69) + k2 * z69))
        z71 = s_psi * z68 + s8 + z7 * z70
        z72 = c_phi * z50
        z73 = I1 * z72
        z74 = I2 * z72
        s9 = 2.0 * (s_theta * (I3 * z72 - z1 * z73 - z2 * z74))
        z75 = s_theta * z71 - c_theta * (w_x * z43 - s9)
        z76 = z40 * (z75 + z21 * z67)
        z77 = c_theta * z63
        s10 = 2.0 * z66 - (I2 * z49 + z5 * z65) + (I1 * z49 - z4 * z66)
        z78 = 2.0 * (s_psi * s10)
        s11 = c_psi * (z33 * z41 + c_theta * z62 + c_psi * z77 + z78)
        z79 = s_psi * (z24 * z37 - s_psi * z77) + s11
        z80 = c_theta * z70
        s12 = 2.0 * z74 - (z13 * z69 + I2 * z46 + z5 * z73)
        z81 = s12 + (I1 * z46 - z4 * z74)
        s13 = z41 * z44 + c_theta * z68 + c_psi * z80
        s14 = c_psi * (s13 + 2.0 * (s_psi * z81))
        z82 = s_psi * (z24 * z55 - s_psi * z80) + s14
        z83 = z40 * (z82 + z21 * z79)
        z84 = c_phi * z39 - s_phi * z38
        z85 = s_theta * z43
        z86 = z40 * (z85 - c_phi * z57 + s_phi * z56 - z21 * z84)
        z87 = z85 - s_phi * z39 - c_phi * z38
        z88 = z40 * (s_phi * z57 + c_phi * z56 - z21 * z87)
        J: list[float] = [
            # (I.2.15)
            -c_theta * z25,
            # (I.2.15)
            z26 + c_theta * z28,
            0.0,
            # (I.2.15)
            -c_theta * z29,
            # (I.2.15)
            c_theta * z30,
            # (I.2.15)
            z23 * (z31 * w_y - z32 * w_x),
            # (I.2.15)
            z23 * (c_theta * z24) - (z32 * w_y + z31 * w_x) * z27,
            0.0,
            # (I.2.15)
            c_phi,
            # (I.2.15)
            s_phi,
            # (I.2.15)
            z25,
            # (I.2.15)
            -z28,
            0.0,
            # (I.2.15)
            z29,
            # (I.2.15)
            -z30,
            # (I.2.15)
            z20 * z54 + z21 * z61,
            # (I.2.15)
            -(z20 * z67 + z21 * z76),
            # (I.2.15)
            z20 * z79 + z21 * z83,
            # (I.2.15)
            z21 * z86 - z20 * z84,
            # (I.2.15)
            z20 * z87 - z21 * z88,
            # (I.2.15)
            -z61,
            # (I.2.15)
            z76,
            # (I.2.15)
            -z83,
            # (I.2.15)
            -z86,
            # (I.2.15)
            z88,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 5] for k3 in range(0, 25, 5)]
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
        s_phi = math.sin(phi)
        z1 = 1.0 / s_theta
        z2 = (s_theta * s_phi * w_y + s_theta * c_phi * w_x) * z1
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        z3 = z1 * (s_phi * w_x - c_phi * w_y)
        z4 = c_theta * z3
        z5 = s_theta * z4
        z6 = I1 * (c_psi * z2 - s_psi * z5)
        z7 = I2 * (s_psi * z2 + c_psi * z5)
        z8 = c_psi * z6 + s_psi * z7
        s1 = I3 * (s_theta * (z3 - c_theta * z4))
        z9 = c_theta * (s_psi * z6 - c_psi * z7) - s1
        out: list[float] = [
            # L_x 32:8
            c_phi * z8 - s_phi * z9,
            # L_y 33:8
            s_phi * z8 + c_phi * z9,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
