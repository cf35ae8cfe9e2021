"""veselova, emitted by nhc 0.1.0 (nhc:f9d97e9fda3fe193).

A rigid body with a fixed point that must not turn about the vertical.
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = phi [rad]: precession
y[1] = theta [rad]: nutation
y[2] = psi [rad]: spin
y[3] = w_x [rad/s]
y[4] = w_y [rad/s]

Parameters p:
p[0]: I1 = 1.0 [kg*m^2]
p[1]: I2 = 1.7 [kg*m^2]
p[2]: I3 = 2.3 [kg*m^2]

Constraints, with the units of their reactions:
0: no_turn [N*m]

Outputs:
out[0] = L_x [kg*m^2/s]
out[1] = L_y [kg*m^2/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 22 +-, 41 *, 3 /, 6 calls
velocities: 2 +-, 5 *, 1 /, 4 calls
accelerations: 30 +-, 59 *, 3 /, 6 calls
state: 2 +-, 5 *, 0 /, 3 calls
residuals: 1 +-, 1 *, 0 /, 1 calls
reactions: 35 +-, 71 *, 3 /, 6 calls
energy: 7 +-, 18 *, 1 /, 6 calls
jacobian: 95 +-, 196 *, 3 /, 6 calls
outputs: 10 +-, 24 *, 1 /, 6 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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

    Arguments: t (scalar), y (5,), p (3,).
    Returns dydt (5,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 - I2
        k2 = I2 - I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "rhs")
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z8 is 0
        if not abs(-z8) > 0.0:
            raise _refuse(abs(-z8), 0.0, 2, "rhs")
        z9 = c_phi * z5 - 2.0 * (s_phi * z7)
        z10 = z7 + s_phi * z9
        z11 = 1.0 / z8
        z12 = z10 * z11
        z13 = z3 - c_phi * z9
        z14 = z10 * z12 - z13
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z14 is nearly 0
        if not abs(-z14) > 1e-13 * z13:
            raise _refuse(abs(-z14), 1e-13 * z13, 2, "rhs")
        z15 = s_phi * w_x - c_phi * w_y
        z16 = z15 / s_theta
        z17 = c_phi * w_x + s_phi * w_y
        s2 = k1 * (s_psi * (c_psi * z17 - z15 * z6))
        z18 = s_theta * (s2 - k2 * (c_theta * z15))
        z19 = w_y * z18
        z20 = (w_x * z18 + z19 * z12) / z14
        dydt: list[float] = [
            # phi' (I.2.4)
            -c_theta * z16,
            # theta' (I.2.4)
            z17,
            # psi' (I.2.4)
            z16,
            # w_x' (I.2.15) 24:4
            z12 * z20 - z19 * z11,
            # w_y' (I.2.15) 24:4
            -z20,
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

    Arguments: t (scalar), y (5,), p (3,).
    Returns qdot (3,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "velocities")
        c_theta = math.cos(theta)
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z1 = (s_phi * w_x - c_phi * w_y) / s_theta
        qdot: list[float] = [
            # phi' (I.2.4)
            -c_theta * z1,
            # theta' (I.2.4)
            c_phi * w_x + s_phi * w_y,
            # psi' (I.2.4)
            z1,
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

    Arguments: t (scalar), y (5,), p (3,).
    Returns qddot (3,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 - I2
        k2 = I2 - I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "accelerations")
        s_psi = math.sin(psi)
        z1 = s_psi * s_psi
        z2 = 1.0 - z1
        z3 = I1 * z2 + I2 * z1
        s_phi = math.sin(phi)
        z4 = s_theta * s_theta
        s1 = I1 * (1.0 - z1 * (2.0 - z4)) - I3 * z4
        z5 = I2 * (z4 * z2 - (1.0 - 2.0 * z1)) + s1
        c_phi = math.cos(phi)
        c_theta = math.cos(theta)
        c_psi = math.cos(psi)
        z6 = c_theta * (s_psi * c_psi) * k1
        z7 = z3 - s_phi * (s_phi * z5 + 2.0 * (c_phi * z6))
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z7 is 0
        if not abs(-z7) > 0.0:
            raise _refuse(abs(-z7), 0.0, 2, "accelerations")
        z8 = c_phi * z5 - 2.0 * (s_phi * z6)
        z9 = z6 + s_phi * z8
        z10 = 1.0 / z7
        z11 = z9 * z10
        z12 = z3 - c_phi * z8
        z13 = z9 * z11 - z12
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z13 is nearly 0
        if not abs(-z13) > 1e-13 * z12:
            raise _refuse(abs(-z13), 1e-13 * z12, 2, "accelerations")
        z14 = 1.0 / s_theta
        z15 = s_phi * w_x - c_phi * w_y
        z16 = z14 * z15
        z17 = c_phi * w_x + s_phi * w_y
        z18 = c_theta * z15
        z19 = c_theta * z16
        z20 = c_phi * z19
        s2 = k2 * z18 - k1 * (s_psi * (c_psi * z17 - s_psi * z18))
        z21 = s_theta * s2
        z22 = w_y * z21
        z23 = (w_x * z21 + z22 * z11) / z13
        z24 = z22 * z10 - z11 * z23
        z25 = s_phi * z19
        s3 = z14 * (w_x * z20 - s_phi * z24 + (w_y * z25 + c_phi * z23))
        z26 = z14 * z14 * (z17 * z18) + s3
        qddot: list[float] = [
            # phi'' (I.2.15)
            z16 * (s_theta * z17) + c_theta * z26,
            # theta'' (I.2.15)
            w_x * z25 + c_phi * z24 - (w_y * z20 - s_phi * z23),
            # psi'' (I.2.15)
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
    """The state y from coordinates and velocities (I.2.1).

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns y (5,).
    """
    phi = float(q[0])  # precession [rad]
    theta = float(q[1])  # nutation [rad]
    psi = float(q[2])  # spin [rad]
    theta_dot = float(qdot[1])  # theta' [rad/s]
    psi_dot = float(qdot[2])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (3,), qdot (3,), p (3,).
    Returns r (1,).
    """
    theta = float(q[1])  # nutation [rad]
    phi_dot = float(qdot[0])  # phi' [rad/s]
    psi_dot = float(qdot[2])  # psi' [rad/s]
    try:
        # from the coordinates and velocities
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
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (5,), p (3,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 - I2
        k2 = I2 - I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "reactions")
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z8 is 0
        if not abs(-z8) > 0.0:
            raise _refuse(abs(-z8), 0.0, 2, "reactions")
        z9 = c_phi * z5 - 2.0 * (s_phi * z7)
        z10 = z7 + s_phi * z9
        z11 = 1.0 / z8
        z12 = z10 * z11
        z13 = z3 - c_phi * z9
        z14 = z10 * z12 - z13
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z14 is nearly 0
        if not abs(-z14) > 1e-13 * z13:
            raise _refuse(abs(-z14), 1e-13 * z13, 2, "reactions")
        z15 = s_phi * w_x - c_phi * w_y
        z16 = z15 / s_theta
        z17 = c_theta * z16
        z18 = c_phi * w_x + s_phi * w_y
        z19 = s_theta * c_psi
        z20 = c_theta * z18
        z21 = s_theta * s_psi
        z22 = c_psi * z18
        s2 = I2 * ((z19 * z17 + s_psi * z18) * (c_psi * z20 - z21 * z16))
        z23 = s2 + I1 * ((z21 * z17 - z22) * (s_psi * z20 + z19 * z16))
        z24 = s_psi * k1
        z25 = c_theta * k2
        z26 = s_theta * ((z22 - z15 * z6) * z24 - z15 * z25)
        z27 = w_y * z26
        z28 = (w_x * z26 + z12 * z27) / z14
        s3 = (c_psi * c_phi - s_phi * z6) * z24 - s_phi * z25
        z29 = s3 * (s_theta * (z11 * z27 - z12 * z28))
        s4 = (c_psi * s_phi + c_phi * z6) * z24 + c_phi * z25
        s5 = I3 * ((z16 - c_theta * z17) * (s_theta * z18)) + z23
        z30 = s5 + (z29 + s4 * (s_theta * z28))
        lambda_: list[float] = [
            # reaction of no_turn: Q_i gains lambda_1 a_1i (I.4.1) 26:5
            -z30,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (5,), p (3,).
    Returns a scalar.
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "energy")
        s_phi = math.sin(phi)
        c_phi = math.cos(phi)
        z1 = (s_phi * w_x - c_phi * w_y) / s_theta
        c_theta = math.cos(theta)
        z2 = c_theta * z1
        omega3 = z1 - c_theta * z2
        c_psi = math.cos(psi)
        z3 = c_phi * w_x + s_phi * w_y
        s_psi = math.sin(psi)
        z4 = s_theta * z2
        z5 = c_psi * z3 - s_psi * z4
        z6 = s_psi * z3 + c_psi * z4
        s1 = I3 * (omega3 * omega3) + (I1 * (z5 * z5) + I2 * (z6 * z6))
        value1 = 0.5 * s1
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (5,), p (3,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the parameters alone
        k1 = I1 - I2
        k2 = I2 - I3
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "jacobian")
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z11 is 0
        if not abs(-z11) > 0.0:
            raise _refuse(abs(-z11), 0.0, 2, "jacobian")
        z12 = c_phi * z6 - 2.0 * (s_phi * z9)
        z13 = z9 + s_phi * z12
        z14 = 1.0 / z11
        z15 = z13 * z14
        z16 = z3 - c_phi * z12
        z17 = z13 * z15 - z16
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z17 is nearly 0
        if not abs(-z17) > 1e-13 * z16:
            raise _refuse(abs(-z17), 1e-13 * z16, 2, "jacobian")
        z18 = 1.0 / s_theta
        z19 = c_phi * w_x + s_phi * w_y
        z20 = z18 * z19
        z21 = s_phi * w_x - c_phi * w_y
        z22 = z18 * z18 * (c_theta * z21)
        z23 = s_phi * z18
        z24 = c_phi * z18
        z25 = 1.0 / z17
        z26 = s_psi * c_theta
        z27 = k1 * (c_psi * z19 - z21 * z26)
        z28 = z21 * k2
        z29 = s_psi * z27 - c_theta * z28
        z30 = s_theta * w_x
        z31 = s_theta * w_y
        z32 = z31 * z29
        z33 = z25 * (z29 * z30 + z32 * z15)
        z34 = z32 * z14 - z15 * z33
        z35 = s_phi * z34
        z36 = z12 * z33 - z6 * z35
        z37 = s_phi * z33
        z38 = k1 * z37
        z39 = c_theta * k2
        z40 = s_psi * k1
        z41 = z31 * z40
        z42 = z31 * z39 + z26 * z41
        z43 = c_psi * z41
        z44 = w_x * z43
        z45 = k1 * z35
        s2 = z10 * z34 + (2.0 * (z8 * z38) - (w_x * z42 - w_y * z43))
        s3 = s_phi * (z44 + (w_y * z42 - (z6 * z37 - 2.0 * (z8 * z45))))
        z46 = c_phi * (z36 - s2) + s3
        z47 = z30 * z40
        z48 = z30 * z39 + z26 * z47
        z49 = c_phi * z33
        z50 = k1 * (z35 - z49)
        z51 = c_psi * z47
        s4 = c_phi * (z44 - (w_x * z48 - (z12 * z34 - 2.0 * (z8 * z50))))
        z52 = s4 + s_phi * (z36 + (z6 * z49 - w_x * (z42 + z51)))
        z53 = z25 * (z52 - z15 * z46)
        z54 = z21 * z41
        z55 = k1 * z33 - 2.0 * (s_phi * z38) - 2.0 * (c_phi * z45)
        z56 = c_phi * z37 - s_phi * z35
        z57 = I1 * z56
        z58 = I2 * z56
        s5 = 2.0 * (s_theta * (I3 * z56 - z1 * z57 - z2 * z58))
        s6 = s_theta * (z31 * z28 + s_psi * z54 + z7 * z55)
        z59 = s6 + c_theta * (w_y * z29 + s5)
        z60 = z21 * z47
        z61 = c_phi * z49
        z62 = k1 * z61
        z63 = k1 * z34 - 2.0 * (s_phi * z50)
        s7 = z28 * z30 - 2.0 * (c_theta * (z1 * z62 + k2 * z61))
        z64 = s_psi * z60 + s7 - z7 * z63
        z65 = c_phi * z35
        z66 = I1 * z65
        z67 = I2 * z65
        s8 = 2.0 * (s_theta * (I3 * z65 - z1 * z66 - z2 * z67))
        z68 = s_theta * z64 + c_theta * (w_x * z29 - s8)
        z69 = z25 * (z68 + z15 * z59)
        z70 = c_theta * z55
        s9 = 2.0 * z58 + (I2 * z34 - z5 * z57) - (I1 * z34 + z4 * z58)
        z71 = 2.0 * (s_psi * s9)
        s10 = c_psi * (z31 * z27 - c_theta * z54 - c_psi * z70 - z71)
        z72 = s_psi * (z19 * z41 - s_psi * z70) - s10
        z73 = c_theta * z63
        s11 = 2.0 * z67 + (z5 * z62 + I2 * z33 - z5 * z66)
        z74 = s11 - (I1 * z33 + z4 * z67)
        s12 = z27 * z30 - c_theta * z60 + c_psi * z73
        s13 = c_psi * (s12 + 2.0 * (s_psi * z74))
        z75 = s_psi * (z19 * z47 + s_psi * z73) - s13
        z76 = z25 * (z75 + z15 * z72)
        z77 = s_phi * z42 - c_phi * z43
        z78 = s_theta * z29
        z79 = z25 * (z78 - s_phi * z48 + c_phi * z51 - z15 * z77)
        z80 = z78 + c_phi * z42 + s_phi * z43
        z81 = z25 * (c_phi * z48 + s_phi * z51 + z15 * z80)
        J: list[float] = [
            # (I.2.15)
            -c_theta * z20,
            # (I.2.15)
            z21 + c_theta * z22,
            0.0,
            # (I.2.15)
            -c_theta * z23,
            # (I.2.15)
            c_theta * z24,
            # (I.2.15)
            -z21,
            0.0,
            0.0,
            # (I.2.15)
            c_phi,
            # (I.2.15)
            s_phi,
            # (I.2.15)
            z20,
            # (I.2.15)
            -z22,
            0.0,
            # (I.2.15)
            z23,
            # (I.2.15)
            -z24,
            # (I.2.15)
            z14 * z46 + z15 * z53,
            # (I.2.15)
            z15 * z69 - z14 * z59,
            # (I.2.15)
            z14 * z72 - z15 * z76,
            # (I.2.15)
            z14 * z77 + z15 * z79,
            # (I.2.15)
            z15 * z81 - z14 * z80,
            # (I.2.15)
            -z53,
            # (I.2.15)
            -z69,
            # (I.2.15)
            z76,
            # (I.2.15)
            -z79,
            # (I.2.15)
            -z81,
        ]
        _finish("jacobian", J)
        return [J[k3 : k3 + 5] for k3 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (3,).
    Returns out (2,).
    """
    phi = float(y[0])  # precession [rad]
    theta = float(y[1])  # nutation [rad]
    psi = float(y[2])  # spin [rad]
    w_x = float(y[3])  # [rad/s]
    w_y = float(y[4])  # [rad/s]
    I1 = float(p[0])  # [kg*m^2]
    I2 = float(p[1])  # [kg*m^2]
    I3 = float(p[2])  # [kg*m^2]
    try:
        # from the state
        s_theta = math.sin(theta)
        # the coframe is singular, if s_theta is nearly 0
        if not abs(s_theta) > 1e-12 * 4.0:
            raise _refuse(abs(s_theta), 1e-12 * 4.0, 1, "outputs")
        c_phi = math.cos(phi)
        c_psi = math.cos(psi)
        s_phi = math.sin(phi)
        z1 = c_phi * w_x + s_phi * w_y
        s_psi = math.sin(psi)
        c_theta = math.cos(theta)
        z2 = (s_phi * w_x - c_phi * w_y) / s_theta
        z3 = c_theta * z2
        z4 = s_theta * z3
        z5 = I1 * (c_psi * z1 - s_psi * z4)
        z6 = I2 * (s_psi * z1 + c_psi * z4)
        z7 = c_psi * z5 + s_psi * z6
        s1 = I3 * (s_theta * (z2 - c_theta * z3))
        z8 = c_theta * (s_psi * z5 - c_psi * z6) - s1
        out: list[float] = [
            # L_x 32:8
            c_phi * z7 - s_phi * z8,
            # L_y 33:8
            s_phi * z7 + c_phi * z8,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
