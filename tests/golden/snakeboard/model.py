# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:3113e078fdc21525).

A board on two steerable axles and a rotor; it moves by turning the rotor and the
    axles to and fro.
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with v, psi', p_b', p_f': the dependent velocities of
    the spec (x', y') are singular somewhere

State y:
y[0] = x [m]: centre of the board
y[1] = y [m]: centre of the board
y[2] = theta [rad]: heading of the board
y[3] = psi [rad]: rotor, relative to the board
y[4] = p_b [rad]: back axle, relative to the board
y[5] = p_f [rad]: front axle, relative to the board
y[6] = v [1/s]: x' = l*(cos(theta + p_b)*cos(p_f) + cos(p_b)*cos(theta + p_f))*v, y'
    = l*(sin(theta + p_b)*cos(p_f) + cos(p_b)*sin(theta + p_f))*v, theta' =
    (cos(p_b)*sin(p_f) - cos(p_f)*sin(p_b))*v
y[7] = psi' [rad/s]
y[8] = p_b' [rad/s]
y[9] = p_f' [rad/s]

Parameters p:
p[0]: m = 1.0 [kg]: mass of everything
p[1]: l = 0.5 [m]: from the centre to an axle
p[2]: J = 0.1 [kg*m^2]: board
p[3]: J_r = 0.05 [kg*m^2]: rotor
p[4]: J_w = 0.02 [kg*m^2]: each axle
p[5]: tau = 0.05 [N*m]: amplitude of the torque on the rotor
p[6]: sigma = 0.02 [N*m]: amplitude of the torques on the axles
p[7]: nu = 1.0 [rad/s]: frequency of the torques

Constraints, with the units of their reactions:
0: back [N]
1: front [N]

Outputs:
out[0] = speed [m/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 33 +-, 55 *, 3 /, 9 calls
velocities: 11 +-, 22 *, 0 /, 7 calls
accelerations: 41 +-, 63 *, 3 /, 9 calls
state: 12 +-, 20 *, 2 /, 6 calls
residuals: 9 +-, 15 *, 0 /, 6 calls
reactions: 48 +-, 84 *, 3 /, 9 calls
energy: 16 +-, 27 *, 0 /, 6 calls
jacobian: 94 +-, 155 *, 1 /, 9 calls
outputs: 10 +-, 25 *, 0 /, 7 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "theta", "psi", "p_b", "p_f")
STATE: tuple[str, ...] = (
    "x",
    "y",
    "theta",
    "psi",
    "p_b",
    "p_f",
    "v",
    "psi'",
    "p_b'",
    "p_f'",
)
PARAMETERS: tuple[str, ...] = ("m", "l", "J", "J_r", "J_w", "tau", "sigma", "nu")
CONSTRAINTS: tuple[str, ...] = ("back", "front")
OUTPUTS: tuple[str, ...] = ("speed",)
DEFAULTS: tuple[float, ...] = (1.0, 0.5, 0.1, 0.05, 0.02, 0.05, 0.02, 1.0)

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

    Arguments: t (scalar), y (10,), p (8,).
    Returns dydt (10,).
    """
    t_ = float(t)  # t: time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_r is 0
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "rhs")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_w is 0
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = J + J_r
        k2 = abs(l)
        k3 = m * l
        k4 = 1.0 / J_r
        k5 = 1.0 / J_w
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        z2 = z1 * z1
        z3 = theta + p_b
        c1 = math.cos(z3)
        z4 = c1 * c_p_f
        s1 = math.sin(z3)
        z5 = z4 - s1 * s_p_f
        z6 = s1 * c_p_f
        z7 = z6 + c1 * s_p_f
        z8 = c_p_b * z5 + s_p_b * z7
        z9 = c_p_b * z8
        z10 = l * (z4 + z9)
        z11 = c_p_b * z7 - s_p_b * z5
        z12 = c_p_b * z11
        z13 = l * (z6 + z12)
        z14 = z10 * z10 + z13 * z13
        s3 = 4.0 + 8.0 * (k2 * k2)
        # the coframe is singular, if z2 + z14 is nearly 0
        if not abs(z2 + z14) > 1e-12 * s3:
            raise _refuse(abs(z2 + z14), 1e-12 * s3, 1, "rhs")
        z15 = J * z2 + m * z14
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z15 is nearly 0
        if not abs(z15) > 1e-13 * z15:
            raise _refuse(abs(z15), 1e-13 * z15, 2, "rhs")
        z16 = z1 * v
        z17 = t_ * nu
        s2 = math.sin(z17)
        z18 = p_b_dot * s_p_b
        z19 = p_f_dot * s_p_f
        s4 = c_p_b * c_p_f * (p_b_dot - p_f_dot)
        z20 = v * (s4 + (s_p_f * z18 - s_p_b * z19))
        z21 = tau * s2 + J_r * z20
        z22 = p_f_dot + z16
        z23 = p_b_dot + z16
        s5 = z10 * (z18 * z8 + (z22 * z12 + (c1 * z19 + z6 * z23)))
        z24 = s5 + z13 * (z18 * z11 - (z4 * z23 - (s1 * z19 - z22 * z9)))
        z25 = (z1 * (z21 - k1 * z20) - k3 * (v * z24)) / z15
        z26 = z1 * z25
        c2 = math.cos(z17)
        z27 = sigma * c2
        z28 = J_w * z20
        dydt: list[float] = [
            # x' (I.2.4)
            v * z10,
            # y' (I.2.4)
            v * z13,
            # theta' (I.2.4)
            z16,
            # psi' (I.2.4)
            psi_dot,
            # p_b' (I.2.4)
            p_b_dot,
            # p_f' (I.2.4)
            p_f_dot,
            # v' (I.2.15) 22:4
            -z25,
            # psi'' (I.2.15) 22:4
            k4 * z21 + z26,
            # p_b'' (I.2.15) 22:4
            k5 * (z27 + z28) + z26,
            # p_f'' (I.2.15) 22:4
            z26 - k5 * (z27 - z28),
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

    Arguments: t (scalar), y (10,), p (8,).
    Returns qdot (6,).
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the parameters alone
        k1 = abs(l)
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        z2 = theta + p_b
        c1 = math.cos(z2)
        z3 = c1 * c_p_f
        s1 = math.sin(z2)
        z4 = z3 - s1 * s_p_f
        z5 = s1 * c_p_f
        z6 = z5 + c1 * s_p_f
        z7 = l * (z3 + c_p_b * (c_p_b * z4 + s_p_b * z6))
        z8 = l * (z5 + c_p_b * (c_p_b * z6 - s_p_b * z4))
        s2 = z7 * z7 + z8 * z8
        s3 = z1 * z1 + s2
        s4 = 4.0 + 8.0 * (k1 * k1)
        # the coframe is singular, if s3 is nearly 0
        if not abs(s3) > 1e-12 * s4:
            raise _refuse(abs(s3), 1e-12 * s4, 1, "velocities")
        qdot: list[float] = [
            # x' (I.2.4)
            v * z7,
            # y' (I.2.4)
            v * z8,
            # theta' (I.2.4)
            z1 * v,
            # psi' (I.2.4)
            psi_dot,
            # p_b' (I.2.4)
            p_b_dot,
            # p_f' (I.2.4)
            p_f_dot,
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

    Arguments: t (scalar), y (10,), p (8,).
    Returns qddot (6,).
    """
    t_ = float(t)  # t: time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_r is 0
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "accelerations")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_w is 0
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = m * l * l
        k2 = abs(l)
        k3 = 1.0 / J_r
        k4 = 1.0 / J_w
        k5 = J + J_w
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        z2 = z1 * z1
        z3 = theta + p_b
        c1 = math.cos(z3)
        z4 = c1 * c_p_f
        s1 = math.sin(z3)
        z5 = z4 - s1 * s_p_f
        z6 = s1 * c_p_f
        z7 = z6 + c1 * s_p_f
        z8 = c_p_b * z5 + s_p_b * z7
        z9 = z4 + c_p_b * z8
        z10 = l * z9
        z11 = c_p_b * z7 - s_p_b * z5
        z12 = z6 + c_p_b * z11
        z13 = l * z12
        s3 = z10 * z10
        s4 = z2 + (s3 + z13 * z13)
        s5 = 4.0 + 8.0 * (k2 * k2)
        # the coframe is singular, if s4 is nearly 0
        if not abs(s4) > 1e-12 * s5:
            raise _refuse(abs(s4), 1e-12 * s5, 1, "accelerations")
        z14 = J * z2 + k1 * (z9 * z9 + z12 * z12)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z14 is nearly 0
        if not abs(z14) > 1e-13 * z14:
            raise _refuse(abs(z14), 1e-13 * z14, 2, "accelerations")
        z15 = l * v
        z16 = p_f_dot * s_p_f
        z17 = z1 * v
        z18 = p_b_dot + z17
        z19 = p_b_dot * s_p_b
        z20 = c_p_b * (p_f_dot + z17)
        z21 = z15 * (c1 * z16 + z6 * z18 + (z19 * z8 + z11 * z20))
        z22 = t_ * nu
        s2 = math.sin(z22)
        z23 = c_p_b * c_p_f
        s6 = s_p_f * z19 - p_f_dot * z23 - (s_p_b * z16 - p_b_dot * z23)
        z24 = v * s6
        z25 = J_r * z24
        z26 = tau * s2 + z25
        c2 = math.cos(z22)
        z27 = sigma * c2
        z28 = J_w * z24
        z29 = z27 + z28
        z30 = z27 - z28
        z31 = z15 * (s1 * z16 - z4 * z18 + (z19 * z11 - z8 * z20))
        s7 = z1 * (z26 - (z25 - (z29 - (z28 + (z30 + k5 * z24)))))
        z32 = s7 - m * (z13 * z31) - m * (z10 * z21)
        z33 = z32 / z14
        z34 = z1 * z33
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z21 + z10 * z33),
            # y'' (I.2.15)
            -(z31 + z13 * z33),
            # theta'' (I.2.15)
            -(z24 + z34),
            # psi'' (I.2.15)
            k3 * z26 + z34,
            # p_b'' (I.2.15)
            k4 * z29 + z34,
            # p_f'' (I.2.15)
            z34 - k4 * z30,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns y (10,).
    """
    x = float(q[0])  # centre of the board [m]
    y_2 = float(q[1])  # y: centre of the board [m]
    theta = float(q[2])  # heading of the board [rad]
    psi = float(q[3])  # rotor, relative to the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    psi_dot = float(qdot[3])  # psi' [rad/s]
    p_b_dot = float(qdot[4])  # p_b' [rad/s]
    p_f_dot = float(qdot[5])  # p_f' [rad/s]
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the parameters alone
        k1 = 1.0 / l
        # from the coordinates and velocities
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = theta + p_b
        c1 = math.cos(z1)
        z2 = c1 * c_p_f
        s1 = math.sin(z1)
        z3 = z2 - s1 * s_p_f
        z4 = s1 * c_p_f
        z5 = z4 + c1 * s_p_f
        s2 = x_dot * (k1 * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5)))
        z6 = s2 + y_dot * (k1 * (z4 + c_p_b * (c_p_b * z5 - s_p_b * z3)))
        s3 = theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z6
        z7 = s3 / (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            -0.5 * z7,
            psi_dot,
            p_b_dot,
            p_f_dot,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns r (2,).
    """
    theta = float(q[2])  # heading of the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    theta_dot = float(qdot[2])  # theta' [rad/s]
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the coordinates and velocities
        z1 = theta + p_b
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        c_p_b = math.cos(p_b)
        z2 = theta_dot * l
        c_p_f = math.cos(p_f)
        s_p_f = math.sin(p_f)
        z3 = s1 * c_p_f + c1 * s_p_f
        s_p_b = math.sin(p_b)
        z4 = c1 * c_p_f - s1 * s_p_f
        s2 = x_dot * (c_p_b * z3 - s_p_b * z4)
        z5 = s2 - y_dot * (c_p_b * z4 + s_p_b * z3) - c_p_f * z2
        r: list[float] = [
            # back = 0 (I.1.1) 28:5
            -(x_dot * s1 - y_dot * c1 + c_p_b * z2),
            # front = 0 (I.1.1) 29:5
            -z5,
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

    Arguments: t (scalar), y (10,), p (8,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # t: time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_r is 0
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "reactions")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_w is 0
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = 1.0 / l
        k2 = m * l * l
        k3 = abs(l)
        k4 = J + J_w
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        z2 = z1 * z1
        z3 = theta + p_b
        c1 = math.cos(z3)
        z4 = c1 * c_p_f
        s1 = math.sin(z3)
        z5 = z4 - s1 * s_p_f
        z6 = s1 * c_p_f
        z7 = z6 + c1 * s_p_f
        z8 = c_p_b * z5 + s_p_b * z7
        z9 = z4 + c_p_b * z8
        z10 = l * z9
        z11 = c_p_b * z7 - s_p_b * z5
        z12 = z6 + c_p_b * z11
        z13 = l * z12
        s3 = z10 * z10
        s4 = z2 + (s3 + z13 * z13)
        s5 = 4.0 + 8.0 * (k3 * k3)
        # the coframe is singular, if s4 is nearly 0
        if not abs(s4) > 1e-12 * s5:
            raise _refuse(abs(s4), 1e-12 * s5, 1, "reactions")
        z14 = J * z2 + k2 * (z9 * z9 + z12 * z12)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z14 is nearly 0
        if not abs(z14) > 1e-13 * z14:
            raise _refuse(abs(z14), 1e-13 * z14, 2, "reactions")
        z15 = k1 * z12
        z16 = 1.0 / (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))
        z17 = t_ * nu
        s2 = math.sin(z17)
        z18 = tau * s2
        z19 = p_b_dot * s_p_b
        z20 = c_p_b * c_p_f
        z21 = p_f_dot * s_p_f
        s6 = s_p_f * z19 - p_f_dot * z20 - (s_p_b * z21 - p_b_dot * z20)
        z22 = v * s6
        z23 = J_r * z22
        c2 = math.cos(z17)
        z24 = sigma * c2
        z25 = J_w * z22
        z26 = l * v
        z27 = z1 * v
        z28 = p_b_dot + z27
        z29 = c_p_b * (p_f_dot + z27)
        z30 = z26 * (s1 * z21 - z4 * z28 + (z19 * z11 - z8 * z29))
        s7 = z23 - (z24 + z25 - (z25 + (z24 - z25 + k4 * z22)))
        z31 = z1 * (z18 + z23 - s7) - m * (z13 * z30)
        z32 = z26 * (c1 * z21 + z6 * z28 + (z19 * z8 + z11 * z29))
        z33 = (z31 - m * (z10 * z32)) / z14
        z34 = z16 * (z18 - J * (z22 + z1 * z33))
        z35 = m * z16
        z36 = (z30 + z13 * z33) * z35
        z37 = z15 * z34 + z1 * z36
        z38 = k1 * z9
        z39 = (z32 + z10 * z33) * z35
        z40 = z38 * z34 + z1 * z39
        z41 = l * (z38 * z36 - z15 * z39)
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            0.5 * (z11 * z37 + z8 * z40 + c_p_f * z41),
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            (c_p_b * z41 - (s1 * z37 + c1 * z40)) * 0.5,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (10,), p (8,).
    Returns a scalar.
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    psi_dot = float(y[7])  # psi' [rad/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    try:
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = (c_p_b * s_p_f - c_p_f * s_p_b) * v
        z2 = p_b_dot + z1
        z3 = p_f_dot + z1
        z4 = psi_dot + z1
        z5 = l * v
        z6 = theta + p_b
        c1 = math.cos(z6)
        z7 = c1 * c_p_f
        s1 = math.sin(z6)
        z8 = z7 - s1 * s_p_f
        z9 = s1 * c_p_f
        z10 = z9 + c1 * s_p_f
        z11 = z5 * (z7 + c_p_b * (c_p_b * z8 + s_p_b * z10))
        z12 = z5 * (z9 + c_p_b * (c_p_b * z10 - s_p_b * z8))
        s2 = J * (z1 * z1) + m * (z11 * z11 + z12 * z12)
        z13 = J_w * (z2 * z2 + z3 * z3) + (J_r * (z4 * z4) + s2)
        value1 = 0.5 * z13
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (10,), p (8,).
    Returns rows (10, 10): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # t: time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    p_b_dot = float(y[8])  # p_b' [rad/s]
    p_f_dot = float(y[9])  # p_f' [rad/s]
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J_2 = float(p[2])  # J: board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_r is 0
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "jacobian")
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if J_w is 0
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = m * l * l
        k2 = abs(l)
        k3 = J_2 + J_w
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        z2 = z1 * z1
        z3 = theta + p_b
        c1 = math.cos(z3)
        z4 = c1 * c_p_f
        s1 = math.sin(z3)
        z5 = s1 * s_p_f
        z6 = z4 - z5
        z7 = s1 * c_p_f
        z8 = c1 * s_p_f
        z9 = z7 + z8
        z10 = c_p_b * z6 + s_p_b * z9
        z11 = c_p_b * z10
        z12 = z4 + z11
        z13 = l * z12
        z14 = c_p_b * z9 - s_p_b * z6
        z15 = c_p_b * z14
        z16 = z7 + z15
        z17 = l * z16
        s3 = z13 * z13
        s4 = z2 + (s3 + z17 * z17)
        s5 = 4.0 + 8.0 * (k2 * k2)
        # the coframe is singular, if s4 is nearly 0
        if not abs(s4) > 1e-12 * s5:
            raise _refuse(abs(s4), 1e-12 * s5, 1, "jacobian")
        z18 = J_2 * z2 + k1 * (z12 * z12 + z16 * z16)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z18 is nearly 0
        if not abs(z18) > 1e-13 * z18:
            raise _refuse(abs(z18), 1e-13 * z18, 2, "jacobian")
        z19 = l * v
        z20 = z7 + s_p_b * z10
        z21 = z19 * z20
        z22 = z8 + z15
        z23 = z19 * z22
        z24 = z4 - s_p_b * z14
        z25 = z19 * z24
        z26 = z5 - z11
        z27 = z19 * z26
        z28 = c_p_b * c_p_f + s_p_b * s_p_f
        z29 = v * z28
        z30 = J_2 * z1
        z31 = z30 * z28
        z32 = 1.0 / z18
        z33 = t_ * nu
        s2 = math.sin(z33)
        z34 = p_b_dot * s_p_b
        z35 = p_f_dot * c_p_f
        z36 = p_f_dot * s_p_f
        z37 = p_b_dot * c_p_b
        z38 = s_p_f * z34 - c_p_b * z35 - (s_p_b * z36 - c_p_f * z37)
        z39 = v * z38
        z40 = J_r * z39
        c2 = math.cos(z33)
        z41 = sigma * c2
        z42 = J_w * z39
        s6 = z40 - (z41 + z42 - (z42 + (z41 - z42 + z39 * k3)))
        z43 = tau * s2 + z40 - s6
        z44 = z1 * v
        z45 = p_b_dot + z44
        z46 = c1 * z45
        z47 = s1 * z36
        z48 = z34 * z14
        z49 = p_f_dot + z44
        z50 = z49 * z10
        z51 = c_p_f * z46 - z47 - (z48 - c_p_b * z50)
        z52 = m * z19
        z53 = z51 * z52
        z54 = s1 * z45
        z55 = c1 * z36
        z56 = z34 * z10
        z57 = z49 * z14
        z58 = c_p_f * z54 + z55 + (z56 + c_p_b * z57)
        z59 = z58 * z52
        z60 = z1 * z43 + z17 * z53 - z13 * z59
        z61 = z32 * z32 * z60
        z62 = v * (s_p_f * z37 + s_p_b * z35 - (c_p_b * z36 + c_p_f * z34))
        z63 = z28 * z43 + z30 * z62
        z64 = l * z53
        z65 = z17 * z52
        z66 = c1 * z29
        z67 = z10 * z29
        s7 = z37 * z14 + (s_p_b * z50 + c_p_b * z67)
        z68 = z24 * z64 - z65 * (z55 + c_p_f * (z54 + z66) + s7)
        z69 = l * z59
        z70 = z13 * z52
        z71 = s1 * z29
        z72 = z14 * z29
        s8 = z37 * z10 - (s_p_b * z57 + c_p_b * z72)
        z73 = z20 * z69 + z70 * (z47 - c_p_f * (z46 - z71) - s8)
        s9 = 2.0 * ((k1 * (z12 * z20 - z16 * z24) + z31) * z61)
        z74 = s9 - z32 * (z63 - z68 - z73)
        s10 = s_p_f * z46 - c_p_f * z66 + s1 * z35
        z75 = z26 * z64 + z65 * (s10 + (z56 + c_p_b * (z57 - z67)))
        s11 = s_p_f * z54 - c_p_f * z71 - c1 * z35
        z76 = z22 * z69 + z70 * (s11 + (z48 - c_p_b * (z50 + z72)))
        s12 = 2.0 * (z61 * (k1 * (z12 * z22 + z16 * z26) - z31))
        z77 = s12 + z32 * (z63 - z75 + z76)
        z78 = c_p_b * z1
        z79 = m * z17
        z80 = m * z13
        s13 = z38 * z30 - (l * z51 + z19 * (z4 * z1 + z10 * z78)) * z79
        z81 = s13 + (l * z58 + z19 * (z7 * z1 + z14 * z78)) * z80
        z82 = z32 * z81
        z83 = z30 * z29
        z84 = z32 * (z83 - z25 * z79 + z21 * z80)
        z85 = z32 * (z83 - z27 * z79 - z23 * z80)
        z86 = z62 - z60 * (z28 * z32)
        z87 = z1 * z74 + z86
        z88 = z86 - z1 * z77
        z89 = z38 - z1 * z82
        z90 = z29 - z1 * z84
        z91 = z29 - z1 * z85
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -v * z17,
            0.0,
            # (I.2.15)
            -z21,
            # (I.2.15)
            -z23,
            # (I.2.15)
            z13,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            v * z13,
            0.0,
            # (I.2.15)
            z25,
            # (I.2.15)
            -z27,
            # (I.2.15)
            z17,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z29,
            # (I.2.15)
            z29,
            # (I.2.15)
            z1,
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
            # (I.2.15)
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
            # (I.2.15)
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
            # (I.2.15)
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z74,
            # (I.2.15)
            -z77,
            # (I.2.15)
            z82,
            0.0,
            # (I.2.15)
            z84,
            # (I.2.15)
            -z85,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z87,
            # (I.2.15)
            -z88,
            # (I.2.15)
            z89,
            0.0,
            # (I.2.15)
            z90,
            # (I.2.15)
            -z91,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z87,
            # (I.2.15)
            -z88,
            # (I.2.15)
            z89,
            0.0,
            # (I.2.15)
            z90,
            # (I.2.15)
            -z91,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z87,
            # (I.2.15)
            -z88,
            # (I.2.15)
            z89,
            0.0,
            # (I.2.15)
            z90,
            # (I.2.15)
            -z91,
        ]
        _finish("jacobian", J)
        return [J[k4 : k4 + 10] for k4 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (10,), p (8,).
    Returns out (1,).
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])  # [1/s]
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the parameters alone
        k1 = abs(l)
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = c_p_b * s_p_f - c_p_f * s_p_b
        c_theta = math.cos(theta)
        s_theta = math.sin(theta)
        s1 = c_p_f * (c_p_b * c_theta - s_theta * s_p_b)
        z2 = l * (s1 + c_p_b * (c_p_f * c_theta - s_theta * s_p_f))
        s2 = c_p_f * (c_p_b * s_theta + c_theta * s_p_b)
        z3 = l * (s2 + c_p_b * (c_p_f * s_theta + c_theta * s_p_f))
        s3 = z2 * z2 + z3 * z3
        s4 = z1 * z1 + s3
        s5 = 4.0 + 8.0 * (k1 * k1)
        # the coframe is singular, if s4 is nearly 0
        if not abs(s4) > 1e-12 * s5:
            raise _refuse(abs(s4), 1e-12 * s5, 1, "outputs")
        out: list[float] = [
            # speed 32:10
            2.0 * (l * (c_p_b * c_p_f * v)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
