# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:acd4490588483611).

A board on two steerable axles and a rotor; it moves by turning the rotor and the
    axles to and fro.
Source: snakeboard.yaml
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
y[6] = v: x'*(cos(theta + p_b)*cos(p_f) + cos(p_b)*cos(theta + p_f)) + y'*(sin(theta
    + p_b)*cos(p_f) + cos(p_b)*sin(theta + p_f)) + theta'*l*(cos(p_b)*sin(p_f) -
    cos(p_f)*sin(p_b))
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
rhs: 39 +-, 87 *, 6 /, 9 calls
velocities: 12 +-, 25 *, 2 /, 7 calls
accelerations: 47 +-, 104 *, 6 /, 9 calls
state: 10 +-, 16 *, 0 /, 6 calls
residuals: 9 +-, 15 *, 0 /, 6 calls
reactions: 55 +-, 131 *, 4 /, 9 calls
energy: 20 +-, 35 *, 2 /, 7 calls
jacobian: 131 +-, 302 *, 4 /, 9 calls
outputs: 4 +-, 9 *, 1 /, 5 calls

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
    "the mass matrix is singular, or the velocities that are kept are",
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
    """right-hand side dy/dt = f(t, y; p) (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns dydt (10,).
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "rhs")
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "rhs")
        # from the parameters alone
        k1 = 1.0 / l
        k2 = abs(l)
        k3 = 2.0 + k2
        k4 = J + J_r
        k5 = 1.0 / J_r
        k6 = 1.0 / J_w
        k7 = J * (k1 * k1)
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s3 = (4.0 + 2.0 * k2) * k3
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k3 * s3):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k3 * s3), 1, "rhs")
        z3 = 1.0 / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = z5 - s1 * s_p_f
        z7 = s1 * c_p_f
        z8 = z7 + c1 * s_p_f
        z9 = c_p_b * z6 + s_p_b * z8
        z10 = z5 + c_p_b * z9
        z11 = z3 * z10
        z12 = c_p_b * z8 - s_p_b * z6
        z13 = z7 + c_p_b * z12
        z14 = z3 * z13
        z15 = s1 * z9 - c1 * z12
        z16 = z3 * z15
        z17 = m * (z11 * z11 + z14 * z14) + k7 * (z16 * z16)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z17) > 1e-13 * z17:
            raise _refuse(abs(z17), 1e-13 * z17, 2, "rhs")
        z18 = 0.5 * (v / z2 * z15)
        z19 = p_b_dot * s_p_b
        z20 = p_f_dot * s_p_f
        z21 = z3 * z3 * (c_p_b * z19 + c_p_f * z20)
        z22 = p_b_dot + z18
        z23 = s1 * z22
        z24 = p_f_dot + z18
        z25 = z12 * z24
        z26 = c1 * z22
        z27 = z9 * z24
        s4 = z14 * (z19 * z12 - (c_p_f * z26 - (s1 * z20 - c_p_b * z27)))
        s5 = z11 * (z19 * z9 + (c_p_f * z23 + (c1 * z20 + c_p_b * z25)))
        z28 = s5 + s4
        z29 = k1 * z16
        z30 = t_ * nu
        s2 = math.sin(z30)
        s6 = z3 * (z9 * z26 - s1 * z25 + (z12 * z23 - c1 * z27))
        z31 = 2.0 * (z15 * z21) - s6
        z32 = k1 * (v * z31)
        z33 = tau * s2 + 0.5 * (J_r * z32)
        s7 = m * (v * ((z10 * z11 + z13 * z14) * z21 + 0.5 * (z3 * z28)))
        z34 = s7 - z29 * (z33 - 0.5 * (k4 * z32))
        z35 = z34 / z17
        z36 = z29 * z35
        c2 = math.cos(z30)
        z37 = sigma * c2
        z38 = 0.5 * (J_w * z32)
        dydt: list[float] = [
            # x' (I.2.4)
            -0.5 * (v * z11),
            # y' (I.2.4)
            -0.5 * (v * z14),
            # theta' (I.2.4)
            z18,
            # psi' (I.2.4)
            psi_dot,
            # p_b' (I.2.4)
            p_b_dot,
            # p_f' (I.2.4)
            p_f_dot,
            # v' (I.2.15) 22:4
            2.0 * z35,
            # psi'' (I.2.15) 22:4
            k5 * z33 - z36,
            # p_b'' (I.2.15) 22:4
            k6 * (z37 + z38) - z36,
            # p_f'' (I.2.15) 22:4
            -(k6 * (z37 - z38) + z36),
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

    Arguments: t (scalar), y (10,), p (8,).
    Returns qdot (6,).
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the parameters alone
        k1 = abs(l)
        k2 = 2.0 + k1
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s2 = (4.0 + 2.0 * k1) * k2
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k2 * s2):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k2 * s2), 1, "velocities")
        z3 = v / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = z5 - s1 * s_p_f
        z7 = s1 * c_p_f
        z8 = z7 + c1 * s_p_f
        z9 = c_p_b * z6 + s_p_b * z8
        z10 = c_p_b * z8 - s_p_b * z6
        qdot: list[float] = [
            # x' (I.2.4)
            -0.5 * (z3 * (z5 + c_p_b * z9)),
            # y' (I.2.4)
            -0.5 * (z3 * (z7 + c_p_b * z10)),
            # theta' (I.2.4)
            0.5 * (v / z2 * (s1 * z9 - c1 * z10)),
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
    """all accelerations q'' on the motion (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns qddot (6,).
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "accelerations")
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "accelerations")
        # from the parameters alone
        k1 = 1.0 / l
        k2 = abs(l)
        k3 = 2.0 + k2
        k4 = 1.0 / J_r
        k5 = 1.0 / J_w
        k6 = J + J_w
        k7 = J * (k1 * k1)
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s3 = (4.0 + 2.0 * k2) * k3
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k3 * s3):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k3 * s3), 1, "accelerations")
        z3 = 1.0 / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = z5 - s1 * s_p_f
        z7 = s1 * c_p_f
        z8 = z7 + c1 * s_p_f
        z9 = c_p_b * z6 + s_p_b * z8
        z10 = z5 + c_p_b * z9
        z11 = z3 * z10
        z12 = c_p_b * z8 - s_p_b * z6
        z13 = z7 + c_p_b * z12
        z14 = z3 * z13
        z15 = s1 * z9 - c1 * z12
        z16 = z3 * z15
        z17 = m * (z11 * z11 + z14 * z14) + k7 * (z16 * z16)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z17) > 1e-13 * z17:
            raise _refuse(abs(z17), 1e-13 * z17, 2, "accelerations")
        z18 = p_f_dot * s_p_f
        z19 = 1.0 / z2
        z20 = v * z15
        z21 = 0.5 * (z19 * z20)
        z22 = p_b_dot + z21
        z23 = s1 * z22
        z24 = p_b_dot * s_p_b
        z25 = p_f_dot + z21
        z26 = z12 * z25
        z27 = c_p_b * z24 + c_p_f * z18
        z28 = z3 * z3 * z27
        s4 = z3 * (c1 * z18 + c_p_f * z23 + (z24 * z9 + c_p_b * z26))
        z29 = s4 + 2.0 * (z10 * z28)
        z30 = v * z29
        z31 = k1 * z16
        z32 = t_ * nu
        s2 = math.sin(z32)
        z33 = c1 * z22
        z34 = z9 * z25
        z35 = z9 * z33 - s1 * z26 + (z12 * z23 - c1 * z34)
        z36 = k1 * (v * (z3 * z35 - 2.0 * (z15 * z28)))
        z37 = 0.5 * (J_r * z36)
        z38 = tau * s2 - z37
        c2 = math.cos(z32)
        z39 = sigma * c2
        z40 = 0.5 * (J_w * z36)
        z41 = z39 - z40
        z42 = z39 + z40
        s5 = z3 * (s1 * z18 - c_p_f * z33 + (z24 * z12 - c_p_b * z34))
        z43 = s5 + 2.0 * (z13 * z28)
        z44 = v * z43
        s6 = z31 * (z38 + (z37 + (z41 + (z40 - (z42 - 0.5 * (k6 * z36))))))
        z45 = s6 - 0.5 * (m * (z14 * z44))
        z46 = (z45 - 0.5 * (m * (z11 * z30))) / z17
        s7 = 2.0 * (l * (z20 * (z19 * z19 * z27)))
        z47 = s7 - z19 * (v * z35 - 2.0 * (z15 * z46))
        z48 = z31 * z46
        qddot: list[float] = [
            # x'' (I.2.15)
            0.5 * (z30 + 2.0 * (z11 * z46)),
            # y'' (I.2.15)
            0.5 * (z44 + 2.0 * (z14 * z46)),
            # theta'' (I.2.15)
            -0.5 * z47,
            # psi'' (I.2.15)
            z48 + k4 * z38,
            # p_b'' (I.2.15)
            z48 + k5 * z41,
            # p_f'' (I.2.15)
            z48 - k5 * z42,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns y (10,).
    """
    x = float(q[0])  # centre of the board [m]
    y_2 = float(q[1])  # centre of the board [m]
    theta = float(q[2])  # heading of the board [rad]
    psi = float(q[3])  # rotor, relative to the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    psi_dot = float(qdot[3])
    p_b_dot = float(qdot[4])
    p_f_dot = float(qdot[5])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the state
        c_p_b = math.cos(p_b)
        s_p_f = math.sin(p_f)
        c_p_f = math.cos(p_f)
        s_p_b = math.sin(p_b)
        z1 = theta + p_b
        c1 = math.cos(z1)
        z2 = c1 * c_p_f
        s1 = math.sin(z1)
        z3 = z2 - s1 * s_p_f
        z4 = s1 * c_p_f
        z5 = z4 + c1 * s_p_f
        s2 = x_dot * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5))
        z6 = s2 + y_dot * (z4 + c_p_b * (c_p_b * z5 - s_p_b * z3))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            theta_dot * (l * (c_p_b * s_p_f - c_p_f * s_p_b)) + z6,
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

    Arguments: t (scalar), q (6,), qdot (6,), p (8,).
    Returns r (2,).
    """
    theta = float(q[2])  # heading of the board [rad]
    p_b = float(q[4])  # back axle, relative to the board [rad]
    p_f = float(q[5])  # front axle, relative to the board [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    theta_dot = float(qdot[2])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (10,), p (8,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "reactions")
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "reactions")
        # from the parameters alone
        k1 = 1.0 / l
        k2 = abs(l)
        k3 = 2.0 + k2
        k4 = J + J_w
        k5 = J * (k1 * k1)
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s3 = (4.0 + 2.0 * k2) * k3
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k3 * s3):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k3 * s3), 1, "reactions")
        z3 = 1.0 / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = z5 - s1 * s_p_f
        z7 = s1 * c_p_f
        z8 = z7 + c1 * s_p_f
        z9 = c_p_b * z6 + s_p_b * z8
        z10 = z5 + c_p_b * z9
        z11 = z3 * z10
        z12 = c_p_b * z8 - s_p_b * z6
        z13 = z7 + c_p_b * z12
        z14 = z3 * z13
        z15 = c_p_b * s_p_f - c_p_f * s_p_b
        z16 = z15 * z3
        z17 = m * (z11 * z11 + z14 * z14) + k5 * (z16 * z16)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z17) > 1e-13 * z17:
            raise _refuse(abs(z17), 1e-13 * z17, 2, "reactions")
        z18 = t_ * nu
        s2 = math.sin(z18)
        z19 = tau * s2
        z20 = 1.0 / z2
        z21 = p_b_dot * s_p_b
        z22 = p_f_dot * s_p_f
        z23 = c_p_b * z21 + c_p_f * z22
        z24 = z15 * v
        z25 = 0.5 * (z20 * z24)
        z26 = p_b_dot - z25
        z27 = c1 * z26
        z28 = p_f_dot - z25
        z29 = z12 * z28
        z30 = s1 * z26
        z31 = z9 * z28
        z32 = z9 * z27 - s1 * z29 + (z12 * z30 - c1 * z31)
        z33 = k1 * z16
        z34 = z3 * z3 * z23
        z35 = k1 * (v * (z3 * z32 + 2.0 * (z15 * z34)))
        z36 = 0.5 * (J_r * z35)
        c2 = math.cos(z18)
        z37 = sigma * c2
        z38 = 0.5 * (J_w * z35)
        s4 = z36 + (z37 - z38 + (z38 - (z37 + z38 - 0.5 * (k4 * z35))))
        z39 = z33 * (z19 - z36 + s4)
        s5 = z3 * (s1 * z22 - c_p_f * z27 + (z21 * z12 - c_p_b * z31))
        z40 = 2.0 * (z13 * z34) + s5
        z41 = v * z40
        s6 = z3 * (c1 * z22 + c_p_f * z30 + (z21 * z9 + c_p_b * z29))
        z42 = 2.0 * (z10 * z34) + s6
        z43 = v * z42
        s7 = z39 + 0.5 * (m * (z14 * z41)) + 0.5 * (m * (z11 * z43))
        z44 = s7 / z17
        s8 = 2.0 * (l * (z20 * z20 * z23 * z24)) + v * z20 * z32
        z45 = s8 - 2.0 * (z33 * z44)
        z46 = k1 * (z3 * (z19 + 0.5 * (J * z45)))
        z47 = z46 * (c1 * z9 + s1 * z12)
        z48 = l * z15
        z49 = m * z20
        z50 = (z41 - 2.0 * (z14 * z44)) * z49
        z51 = z48 * z50
        z52 = (z43 - 2.0 * (z11 * z44)) * z49
        z53 = z48 * z52
        z54 = l * (z10 * z50 - z13 * z52)
        s9 = 0.5 * (c_p_b * z46 + c_p_f * z47) - 0.25 * (z12 * z51)
        z55 = s9 - 0.25 * (z9 * z53) - 0.25 * (c_p_f * z54)
        s10 = 0.5 * (c_p_f * z46 + c_p_b * z47) - 0.25 * (s1 * z51)
        z56 = s10 - 0.25 * (c1 * z53) + 0.25 * (c_p_b * z54)
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            z55,
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            -z56,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V [J]

    Arguments: t (scalar), y (10,), p (8,).
    Returns a scalar.
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    psi_dot = float(y[7])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    try:
        # from the parameters alone
        k1 = abs(l)
        k2 = 2.0 + k1
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s2 = (4.0 + 2.0 * k1) * k2
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k2 * s2):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k2 * s2), 1, "energy")
        z3 = v / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = z5 - s1 * s_p_f
        z7 = s1 * c_p_f
        z8 = z7 + c1 * s_p_f
        z9 = c_p_b * z6 + s_p_b * z8
        z10 = z3 * (z5 + c_p_b * z9)
        z11 = c_p_b * z8 - s_p_b * z6
        z12 = z3 * (z7 + c_p_b * z11)
        z13 = v / z2 * (s1 * z9 - c1 * z11)
        z14 = 0.5 * z13
        z15 = psi_dot + z14
        s3 = 0.25 * (m * (z10 * z10 + z12 * z12) + J * (z13 * z13))
        z16 = s3 + J_r * (z15 * z15)
        z17 = p_b_dot + z14
        z18 = p_f_dot + z14
        value1 = 0.5 * (z16 + J_w * (z17 * z17 + z18 * z18))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)

    Arguments: t (scalar), y (10,), p (8,).
    Returns rows (10, 10): d rhs_i / d y_j stands at [i][j].
    """
    t_ = float(t)  # time
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    p_b_dot = float(y[8])
    p_f_dot = float(y[9])
    m = float(p[0])  # mass of everything [kg]
    l = float(p[1])  # from the centre to an axle [m]
    J_2 = float(p[2])  # board [kg*m^2]
    J_r = float(p[3])  # rotor [kg*m^2]
    J_w = float(p[4])  # each axle [kg*m^2]
    tau = float(p[5])  # amplitude of the torque on the rotor [N*m]
    sigma = float(p[6])  # amplitude of the torques on the axles [N*m]
    nu = float(p[7])  # frequency of the torques [rad/s]
    try:
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_r) > 0.0:
            raise _refuse(abs(J_r), 0.0, 2, "jacobian")
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(J_w) > 0.0:
            raise _refuse(abs(J_w), 0.0, 2, "jacobian")
        # from the parameters alone
        k1 = 1.0 / l
        k2 = abs(l)
        k3 = 2.0 + k2
        k4 = J_2 + J_w
        k5 = J_2 * (k1 * k1)
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        z2 = l * z1
        s3 = (4.0 + 2.0 * k2) * k3
        # the coframe is singular
        if not abs(2.0 * z2) > 1e-12 * (k3 * s3):
            raise _refuse(abs(2.0 * z2), 1e-12 * (k3 * s3), 1, "jacobian")
        z3 = 1.0 / z1
        z4 = theta + p_b
        c1 = math.cos(z4)
        c_p_f = math.cos(p_f)
        z5 = c1 * c_p_f
        c_p_b = math.cos(p_b)
        s1 = math.sin(z4)
        z6 = s1 * s_p_f
        z7 = z5 - z6
        z8 = s1 * c_p_f
        z9 = c1 * s_p_f
        z10 = z8 + z9
        z11 = c_p_b * z7 + s_p_b * z10
        z12 = c_p_b * z11
        z13 = z5 + z12
        z14 = z3 * z13
        z15 = c_p_b * z10 - s_p_b * z7
        z16 = c_p_b * z15
        z17 = z8 + z16
        z18 = z3 * z17
        z19 = s1 * z11 - c1 * z15
        z20 = z3 * z19
        z21 = m * (z14 * z14 + z18 * z18) + k5 * (z20 * z20)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z21) > 1e-13 * z21:
            raise _refuse(abs(z21), 1e-13 * z21, 2, "jacobian")
        z22 = z8 + s_p_b * z11
        z23 = z3 * z3
        z24 = c_p_b * s_p_b
        z25 = z23 * z24
        z26 = z3 * z22 + 2.0 * (z13 * z25)
        z27 = v * z26
        z28 = z9 + z16
        z29 = c_p_f * s_p_f
        z30 = z23 * z29
        z31 = z3 * z28 + 2.0 * (z13 * z30)
        z32 = v * z31
        z33 = z5 - s_p_b * z15
        z34 = z3 * z33 - 2.0 * (z17 * z25)
        z35 = v * z34
        z36 = z6 - z12
        z37 = z3 * z36 + 2.0 * (z17 * z30)
        z38 = v * z37
        z39 = v * z19
        z40 = 1.0 / z2
        z41 = z39 * (l * (z40 * z40))
        z42 = c1 * z11 + s1 * z15
        z43 = v * z40 * z42
        z44 = 2.0 * (z24 * z41) - z43
        z45 = z43 + 2.0 * (z29 * z41)
        z46 = z40 * z19
        z47 = z3 * z42
        z48 = z47 - 2.0 * (z19 * z25)
        z49 = k5 * z20
        z50 = 1.0 / z21
        z51 = k1 * z20
        z52 = t_ * nu
        s2 = math.sin(z52)
        z53 = k1 * v
        z54 = 0.5 * (z40 * z39)
        z55 = p_b_dot + z54
        z56 = c1 * z55
        z57 = p_f_dot + z54
        z58 = z15 * z57
        z59 = s1 * z55
        z60 = z11 * z57
        z61 = z11 * z56 - s1 * z58 + (z15 * z59 - c1 * z60)
        z62 = p_b_dot * c_p_b
        z63 = p_f_dot * c_p_f
        z64 = s_p_b * z62 + s_p_f * z63
        z65 = z23 * z64
        z66 = z3 * z61 - 2.0 * (z65 * z19)
        z67 = z53 * z66
        z68 = 0.5 * (J_r * z67)
        c2 = math.cos(z52)
        z69 = sigma * c2
        z70 = 0.5 * (J_w * z67)
        s4 = z68 + (z69 - z70 + (z70 - (z69 + z70 - 0.5 * (k4 * z67))))
        z71 = tau * s2 - z68 + s4
        z72 = p_f_dot * s_p_f
        z73 = s1 * z72
        z74 = p_b_dot * s_p_b
        z75 = z74 * z15
        z76 = z73 - c_p_f * z56 + (z75 - c_p_b * z60)
        z77 = z3 * z76 + 2.0 * (z65 * z17)
        z78 = m * v
        z79 = z77 * z78
        z80 = c1 * z72
        z81 = z74 * z11
        z82 = z80 + c_p_f * z59 + (z81 + c_p_b * z58)
        z83 = z3 * z82 + 2.0 * (z65 * z13)
        z84 = z83 * z78
        z85 = z51 * z71 - 0.5 * (z18 * z79) - 0.5 * (z14 * z84)
        z86 = z50 * z50 * z85
        z87 = k1 * z48
        z88 = z59 + 0.5 * (c1 * z44)
        z89 = z15 * z44
        z90 = z56 - 0.5 * (s1 * z44)
        z91 = z11 * z44
        s5 = z11 * z88 + (c1 * z58 - 0.5 * (s1 * z89))
        z92 = s5 - (z15 * z90 + (s1 * z60 + 0.5 * (c1 * z91)))
        z93 = z3 * z92
        z94 = z65 * z42
        z95 = z64 * (z23 * z3)
        z96 = z23 * (c_p_b * z62 - s_p_b * z74) - 4.0 * (z24 * z95)
        z97 = z53 * (2.0 * (z61 * z25) + z93 + 2.0 * (z94 + z19 * z96))
        z98 = J_2 * z51
        z99 = z18 * z78
        s6 = z62 * z15 + (s_p_b * z60 + 0.5 * (c_p_b * z91))
        z100 = 2.0 * (z76 * z25) - z3 * (z80 + c_p_f * z88 + s6)
        s7 = z34 * z79 - z99 * (z100 - 2.0 * (z65 * z33 + z17 * z96))
        z101 = z71 * z87 - 0.5 * (z97 * z98) - 0.5 * s7
        z102 = z14 * z78
        s8 = z62 * z11 - (s_p_b * z58 + 0.5 * (c_p_b * z89))
        z103 = 2.0 * (z82 * z25) + z3 * (z73 - c_p_f * z90 - s8)
        s9 = z26 * z84 + z102 * (z103 + 2.0 * (z65 * z22 - z13 * z96))
        z104 = z50 * (z101 + 0.5 * s9)
        s10 = 2.0 * ((m * (z14 * z26 - z18 * z34) - z48 * z49) * z86)
        z105 = s10 + z104
        z106 = z47 + 2.0 * (z19 * z30)
        s11 = c1 * z63 - (s_p_f * z59 + 0.5 * (z8 * z45))
        z107 = s11 - (z75 - c_p_b * (z60 - 0.5 * (z15 * z45)))
        z108 = z23 * (c_p_f * z63 - s_p_f * z72) - 4.0 * (z29 * z95)
        s12 = 2.0 * (z65 * z28 - z13 * z108)
        z109 = z31 * z84 + z102 * (2.0 * (z82 * z30) - z3 * z107 + s12)
        s13 = s1 * z63 + (s_p_f * z56 + 0.5 * (z5 * z45))
        z110 = s13 + (z81 + c_p_b * (z58 + 0.5 * (z11 * z45)))
        s14 = 2.0 * (z65 * z36 - z17 * z108)
        z111 = z37 * z79 + z99 * (2.0 * (z76 * z30) - z3 * z110 + s14)
        z112 = k1 * z106
        z113 = z53 * (2.0 * (z94 - z19 * z108) - (2.0 * (z61 * z30) - z93))
        s15 = 0.5 * z109 + (0.5 * z111 - (z71 * z112 - 0.5 * (z98 * z113)))
        s16 = 2.0 * (z86 * (m * (z14 * z31 + z18 * z37) + z106 * z49))
        z114 = s16 + z50 * s15
        z115 = v * z3
        z116 = m * z14
        z117 = m * z18
        z118 = k1 * z66
        s17 = (z77 - 0.5 * (z115 * (z13 * z46))) * z117 - z118 * z98
        z119 = (z83 + 0.5 * (z115 * (z17 * z46))) * z116 + s17
        z120 = z50 * z119
        z121 = z53 * z48
        z122 = z50 * (z121 * z98 + z35 * z117 - z27 * z116)
        z123 = z53 * z106
        z124 = z50 * (z123 * z98 + z38 * z117 + z32 * z116)
        z125 = z50 * z85
        z126 = 0.5 * z97 + (z87 * z125 + z51 * z105)
        z127 = 0.5 * z113 + (z112 * z125 - z51 * z114)
        z128 = 0.5 * (z118 + z51 * z120)
        z129 = 0.5 * (z121 - z51 * z122)
        z130 = 0.5 * (z123 - z51 * z124)
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            0.5 * (v * z18),
            0.0,
            # (I.2.15)
            0.5 * z27,
            # (I.2.15)
            0.5 * z32,
            # (I.2.15)
            -0.5 * z14,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -0.5 * (v * z14),
            0.0,
            # (I.2.15)
            -0.5 * z35,
            # (I.2.15)
            0.5 * z38,
            # (I.2.15)
            -0.5 * z18,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -0.5 * z44,
            # (I.2.15)
            -0.5 * z45,
            # (I.2.15)
            0.5 * z46,
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
            -2.0 * z105,
            # (I.2.15)
            -2.0 * z114,
            # (I.2.15)
            z120,
            0.0,
            # (I.2.15)
            -z122,
            # (I.2.15)
            z124,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z126,
            # (I.2.15)
            -z127,
            # (I.2.15)
            -z128,
            0.0,
            # (I.2.15)
            -z129,
            # (I.2.15)
            z130,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z126,
            # (I.2.15)
            -z127,
            # (I.2.15)
            -z128,
            0.0,
            # (I.2.15)
            -z129,
            # (I.2.15)
            z130,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z126,
            # (I.2.15)
            -z127,
            # (I.2.15)
            -z128,
            0.0,
            # (I.2.15)
            -z129,
            # (I.2.15)
            z130,
        ]
        _finish("jacobian", J)
        return [J[k6 : k6 + 10] for k6 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (10,), p (8,).
    Returns out (1,).
    """
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # from the parameters alone
        k1 = abs(l)
        k2 = 2.0 + k1
        # from the state
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z1 = s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)
        s1 = 2.0 * (l * z1)
        s2 = (4.0 + 2.0 * k1) * k2
        # the coframe is singular
        if not abs(s1) > 1e-12 * (k2 * s2):
            raise _refuse(abs(s1), 1e-12 * (k2 * s2), 1, "outputs")
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        out: list[float] = [
            # speed 32:10
            -c_p_b * c_p_f * v / z1,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
