# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:88c5a56701d273d0).

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
y[6] = v: x'*l*(cos(theta + p_b)*cos(p_f) + cos(p_b)*cos(theta + p_f)) +
    y'*l*(sin(theta + p_b)*cos(p_f) + cos(p_b)*sin(theta + p_f)) +
    theta'*(cos(p_b)*sin(p_f) - cos(p_f)*sin(p_b))
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
rhs: 51 +-, 103 *, 4 /, 9 calls
velocities: 18 +-, 34 *, 1 /, 7 calls
accelerations: 62 +-, 117 *, 4 /, 9 calls
state: 10 +-, 17 *, 0 /, 6 calls
residuals: 9 +-, 15 *, 0 /, 6 calls
reactions: 64 +-, 119 *, 2 /, 9 calls
energy: 26 +-, 45 *, 1 /, 7 calls
jacobian: 164 +-, 299 *, 2 /, 9 calls
outputs: 10 +-, 18 *, 1 /, 5 calls

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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = J + J_r
        k6 = 1.0 / J_r
        k7 = 1.0 / J_w
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z6), 1e-12 * (k4 * s3), 1, "rhs")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        c1 = math.cos(z8)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        z13 = s1 * z11 - c1 * z12
        z14 = z7 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = s1 * z15 + z16 * z12
        z18 = z7 * z17
        z19 = c1 * z15 + z16 * z11
        z20 = z7 * z19
        z21 = z17 * z18 + z19 * z20
        z22 = J * (z14 * z14) + m * (z7 * z21)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z22) > 1e-13 * z22:
            raise _refuse(abs(z22), 1e-13 * z22, 2, "rhs")
        z23 = v * z7
        z24 = z23 * z13
        z25 = p_b_dot * c_p_b
        z26 = p_f_dot * c_p_f
        z27 = s_p_f * z26
        z28 = k1 * z27
        z29 = p_b_dot * s_p_b
        z30 = p_f_dot * s_p_f
        s4 = 2.0 * (k2 * (z4 * z26 - s_p_f * (c_p_f * z29 + c_p_b * z30)))
        z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - s4
        z32 = z7 * z7 * (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28))
        z33 = p_b_dot - z24
        z34 = s1 * z33
        z35 = l * z29
        z36 = l * z30
        z37 = p_f_dot - z24
        z38 = z12 * z37
        z39 = c1 * z33
        z40 = z11 * z37
        s5 = z20 * (z15 * z34 + (z35 * z11 + (c1 * z36 + z16 * z38)))
        s6 = z18 * (z15 * z39 - (z35 * z12 + (s1 * z36 - z16 * z40)))
        z41 = s5 - s6
        z42 = t_ * nu
        s2 = math.sin(z42)
        s7 = z7 * (z11 * z39 - s1 * z38 + (z12 * z34 - c1 * z40))
        z43 = v * (z32 * z13 - s7)
        z44 = tau * s2 - J_r * z43
        s8 = m * (v * (z32 * z21 + z7 * z41)) + z14 * (z44 + k5 * z43)
        z45 = s8 / z22
        z46 = z14 * z45
        c2 = math.cos(z42)
        z47 = sigma * c2
        z48 = J_w * z43
        dydt: list[float] = [
            # x' (I.2.4)
            z23 * z19,
            # y' (I.2.4)
            z23 * z17,
            # theta' (I.2.4)
            -z24,
            # psi' (I.2.4)
            psi_dot,
            # p_b' (I.2.4)
            p_b_dot,
            # p_f' (I.2.4)
            p_f_dot,
            # v' (I.2.15) 22:4
            z45,
            # psi'' (I.2.15) 22:4
            k6 * z44 + z46,
            # p_b'' (I.2.15) 22:4
            k7 * (z47 - z48) + z46,
            # p_f'' (I.2.15) 22:4
            z46 - k7 * (z47 + z48),
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        s2 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s2 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z4), 1e-12 * (k4 * s3), 1, "velocities")
        z5 = v / z4
        z6 = theta + p_b
        c1 = math.cos(z6)
        z7 = l * c_p_f
        z8 = l * c_p_b
        s1 = math.sin(z6)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        qdot: list[float] = [
            # x' (I.2.4)
            z5 * (c1 * z7 + z8 * z11),
            # y' (I.2.4)
            z5 * (s1 * z7 + z8 * z12),
            # theta' (I.2.4)
            (c1 * z12 - s1 * z11) * z5,
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = 1.0 / J_r
        k6 = 1.0 / J_w
        k7 = J + J_w
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z6), 1e-12 * (k4 * s3), 1, "accelerations")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        c1 = math.cos(z8)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        z13 = s1 * z11 - c1 * z12
        z14 = z7 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = s1 * z15 + z16 * z12
        z18 = z7 * z17
        z19 = c1 * z15 + z16 * z11
        z20 = z7 * z19
        z21 = J * (z14 * z14) + m * (z7 * (z17 * z18 + z19 * z20))
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z21) > 1e-13 * z21:
            raise _refuse(abs(z21), 1e-13 * z21, 2, "accelerations")
        z22 = p_b_dot * c_p_b
        z23 = p_f_dot * c_p_f
        z24 = s_p_f * z23
        z25 = k1 * z24
        z26 = p_b_dot * s_p_b
        z27 = p_f_dot * s_p_f
        s4 = 2.0 * (k2 * (z4 * z23 - s_p_f * (c_p_f * z26 + c_p_b * z27)))
        z28 = z3 * z22 - 4.0 * (s_p_b * (z24 - z25)) - s4
        z29 = z7 * z7 * (z5 * z22 + s_p_b * z28 + (2.0 * z24 - 6.0 * z25))
        z30 = v * z29
        z31 = l * z27
        z32 = v * z13
        z33 = z7 * z32
        z34 = p_b_dot - z33
        z35 = s1 * z34
        z36 = l * z26
        z37 = p_f_dot - z33
        z38 = z12 * z37
        z39 = c1 * z31 + z15 * z35 + (z36 * z11 + z16 * z38)
        z40 = t_ * nu
        s2 = math.sin(z40)
        z41 = c1 * z34
        z42 = z11 * z37
        z43 = z11 * z41 - s1 * z38 + (z12 * z35 - c1 * z42)
        z44 = v * (z7 * z43 - z29 * z13)
        z45 = J_r * z44
        z46 = tau * s2 + z45
        c2 = math.cos(z40)
        z47 = sigma * c2
        z48 = J_w * z44
        z49 = z47 + z48
        z50 = z47 - z48
        z51 = s1 * z31 - z15 * z41 + (z36 * z12 - z16 * z42)
        z52 = m * v
        s5 = z14 * (z46 - (z45 - (z49 - (z48 + (z50 + k7 * z44)))))
        z53 = s5 + (z7 * z51 + z29 * z17) * (z18 * z52)
        z54 = (z53 + (z7 * z39 + z29 * z19) * (z20 * z52)) / z21
        z55 = z14 * z54
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z19 * z30 + z7 * (v * z39 - z19 * z54)),
            # y'' (I.2.15)
            -(z17 * z30 + z7 * (v * z51 - z17 * z54)),
            # theta'' (I.2.15)
            z29 * z32 - z7 * (v * z43 + z13 * z54),
            # psi'' (I.2.15)
            k5 * z46 + z55,
            # p_b'' (I.2.15)
            k6 * z49 + z55,
            # p_f'' (I.2.15)
            z55 - k6 * z50,
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
        s2 = x_dot * (l * (z2 + c_p_b * (c_p_b * z3 + s_p_b * z5)))
        z6 = s2 + y_dot * (l * (z4 + c_p_b * (c_p_b * z5 - s_p_b * z3)))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            theta_dot * (c_p_b * s_p_f - c_p_f * s_p_b) + z6,
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = J + J_w
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z6), 1e-12 * (k4 * s3), 1, "reactions")
        z7 = c_p_b * s_p_f - c_p_f * s_p_b
        z8 = 1.0 / z6
        z9 = z7 * z8
        z10 = theta + p_b
        s1 = math.sin(z10)
        z11 = s1 * c_p_f
        c1 = math.cos(z10)
        z12 = z11 + c1 * s_p_f
        z13 = c1 * c_p_f
        z14 = z13 - s1 * s_p_f
        z15 = c_p_b * z12 - s_p_b * z14
        z16 = l * (z11 + c_p_b * z15)
        z17 = z8 * z16
        z18 = c_p_b * z14 + s_p_b * z12
        z19 = l * (z13 + c_p_b * z18)
        z20 = z8 * z19
        z21 = m * z8
        z22 = J * (z9 * z9) + (z16 * z17 + z19 * z20) * z21
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z22) > 1e-13 * z22:
            raise _refuse(abs(z22), 1e-13 * z22, 2, "reactions")
        z23 = t_ * nu
        s2 = math.sin(z23)
        z24 = tau * s2
        z25 = p_b_dot * c_p_b
        z26 = p_f_dot * c_p_f
        z27 = s_p_f * z26
        z28 = k1 * z27
        z29 = p_b_dot * s_p_b
        z30 = p_f_dot * s_p_f
        s4 = 2.0 * (k2 * (z4 * z26 - s_p_f * (c_p_f * z29 + c_p_b * z30)))
        z31 = z3 * z25 - 4.0 * (s_p_b * (z27 - z28)) - s4
        z32 = z8 * z8 * (z5 * z25 + s_p_b * z31 + (2.0 * z27 - 6.0 * z28))
        z33 = v * z9
        z34 = p_b_dot + z33
        z35 = c1 * z34
        z36 = p_f_dot + z33
        z37 = z15 * z36
        z38 = s1 * z34
        z39 = z18 * z36
        s5 = z8 * (z18 * z35 - s1 * z37 + (z15 * z38 - c1 * z39))
        z40 = v * (z7 * z32 + s5)
        z41 = J_r * z40
        c2 = math.cos(z23)
        z42 = sigma * c2
        z43 = J_w * z40
        z44 = l * z30
        z45 = l * c_p_f
        z46 = l * z29
        z47 = l * c_p_b
        s6 = z8 * (s1 * z44 - z45 * z35 + (z46 * z15 - z47 * z39))
        z48 = v * (z32 * z16 + s6)
        s7 = z41 - (z42 + z43 - (z43 + (z42 - z43 + k5 * z40)))
        z49 = z9 * (z24 + z41 - s7) - m * (z17 * z48)
        s8 = z8 * (c1 * z44 + z45 * z38 + (z46 * z18 + z47 * z37))
        z50 = v * (z32 * z19 + s8)
        z51 = (z49 - m * (z20 * z50)) / z22
        z52 = z8 * (z24 - J * (z40 + z9 * z51))
        z53 = z21 * (z48 + z17 * z51)
        z54 = z16 * z52 + z7 * z53
        z55 = z21 * (z50 + z20 * z51)
        z56 = z19 * z52 + z7 * z55
        z57 = z19 * z53 - z16 * z55
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            -(z15 * z54 + z18 * z56 + z45 * z57),
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            s1 * z54 + c1 * z56 - z47 * z57,
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        s2 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        z3 = s_p_b * (s2 - 2.0 * (s_p_f * (c_p_b * c_p_f) * k2))
        z4 = z3 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z4), 1e-12 * (k4 * s3), 1, "energy")
        z5 = v / z4
        z6 = theta + p_b
        c1 = math.cos(z6)
        z7 = l * c_p_f
        z8 = l * c_p_b
        s1 = math.sin(z6)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = z5 * (c1 * z7 + z8 * z11)
        z13 = c_p_b * z10 - s_p_b * z9
        z14 = z5 * (s1 * z7 + z8 * z13)
        z15 = z5 * (s1 * z11 - c1 * z13)
        z16 = psi_dot - z15
        z17 = p_b_dot - z15
        z18 = p_f_dot - z15
        s4 = m * (z12 * z12 + z14 * z14) + J * (z15 * z15)
        z19 = s4 + J_r * (z16 * z16) + J_w * (z17 * z17 + z18 * z18)
        value1 = 0.5 * z19
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        k5 = J_2 + J_w
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        z3 = 1.0 - z2 - k1 * (3.0 - z2)
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z4 = c_p_b * c_p_f
        z5 = s_p_b * z3 - 2.0 * (s_p_f * z4 * k2)
        z6 = s_p_b * z5 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z6) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z6), 1e-12 * (k4 * s3), 1, "jacobian")
        z7 = 1.0 / z6
        z8 = theta + p_b
        s1 = math.sin(z8)
        c1 = math.cos(z8)
        z9 = c1 * c_p_f - s1 * s_p_f
        z10 = s1 * c_p_f + c1 * s_p_f
        z11 = c_p_b * z9 + s_p_b * z10
        z12 = c_p_b * z10 - s_p_b * z9
        z13 = s1 * z11 - c1 * z12
        z14 = z7 * z13
        z15 = l * c_p_f
        z16 = s1 * z15
        z17 = l * c_p_b
        z18 = z17 * z12
        z19 = z16 + z18
        z20 = z7 * z19
        z21 = c1 * z15
        z22 = z17 * z11
        z23 = z21 + z22
        z24 = z7 * z23
        z25 = z19 * z20 + z23 * z24
        z26 = J_2 * (z14 * z14) + m * (z7 * z25)
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z26) > 1e-13 * z26:
            raise _refuse(abs(z26), 1e-13 * z26, 2, "jacobian")
        z27 = v * z7
        z28 = l * s_p_b
        z29 = z16 + z11 * z28
        z30 = z7 * z7
        z31 = c_p_f * s_p_b
        z32 = k2 * (s_p_f * z31)
        z33 = c_p_b * z3 + 2.0 * z32
        z34 = c_p_b * z5 + s_p_b * z33
        z35 = z30 * z34
        z36 = z7 * z29 + z23 * z35
        z37 = v * z36
        z38 = l * s_p_f
        z39 = z18 + c1 * z38
        z40 = c_p_f * s_p_f
        z41 = c_p_b * s_p_f
        z42 = 4.0 * z32 + 2.0 * (k2 * (c_p_f * z4 - s_p_f * z41))
        z43 = 2.0 * z40 - 6.0 * (k1 * z40) - s_p_b * z42
        z44 = z30 * z43
        z45 = z7 * z39 + z23 * z44
        z46 = v * z45
        z47 = z21 - z12 * z28
        z48 = z7 * z47 - z19 * z35
        z49 = v * z48
        z50 = z22 - s1 * z38
        z51 = z7 * z50 - z19 * z44
        z52 = v * z51
        z53 = s1 * z12 + c1 * z11
        z54 = z7 * z53
        z55 = z54 - z13 * z35
        z56 = v * z55
        z57 = z54 + z13 * z44
        z58 = v * z57
        z59 = z13 * z14
        z60 = z14 * z53
        z61 = z7 * (z60 + z13 * z55)
        z62 = 1.0 / z26
        z63 = t_ * nu
        s2 = math.sin(z63)
        z64 = p_b_dot * c_p_b
        z65 = p_f_dot * c_p_f
        z66 = s_p_f * z65
        z67 = k1 * z66
        z68 = z66 - z67
        z69 = p_b_dot * s_p_b
        z70 = p_f_dot * s_p_f
        z71 = c_p_f * z69 + c_p_b * z70
        s4 = 2.0 * (k2 * (z4 * z65 - s_p_f * z71))
        z72 = z3 * z64 - 4.0 * (s_p_b * z68) - s4
        z73 = z5 * z64 + s_p_b * z72 + (2.0 * z66 - 6.0 * z67)
        z74 = z30 * z73
        z75 = z27 * z13
        z76 = p_b_dot - z75
        z77 = c1 * z76
        z78 = p_f_dot - z75
        z79 = z12 * z78
        z80 = s1 * z76
        z81 = z11 * z78
        z82 = z11 * z77 - s1 * z79 + (z12 * z80 - c1 * z81)
        z83 = z74 * z13 - z7 * z82
        z84 = v * z83
        z85 = J_r * z84
        c2 = math.cos(z63)
        z86 = sigma * c2
        z87 = J_w * z84
        s5 = z85 + (z86 - z87 + (z87 - (z86 + z87 - k5 * z84)))
        z88 = tau * s2 - z85 + s5
        z89 = m * v
        z90 = l * z70
        z91 = s1 * z90
        z92 = l * z69
        z93 = z92 * z12
        z94 = z91 - z15 * z77 + (z93 - z17 * z81)
        z95 = z74 * z19 + z7 * z94
        z96 = z89 * z95
        z97 = c1 * z90
        z98 = z92 * z11
        z99 = z97 + z15 * z80 + (z98 + z17 * z79)
        z100 = z74 * z23 + z7 * z99
        z101 = z89 * z100
        z102 = z14 * z88 + z20 * z96 + z24 * z101
        z103 = z62 * z62 * z102
        z104 = J_2 * z14
        z105 = z80 + c1 * z56
        z106 = z12 * z56
        z107 = z77 - s1 * z56
        z108 = z11 * z56
        s6 = z11 * z105 - (s1 * z106 - c1 * z79)
        z109 = s6 - (z12 * z107 + (c1 * z108 + s1 * z81))
        z110 = z74 * z53 + z7 * z109
        z111 = k2 * (z31 * z65 - s_p_f * (s_p_b * z70 - c_p_f * z64))
        s7 = s_p_b * (z3 * z69 + 4.0 * (c_p_b * z68) - 2.0 * z111)
        z112 = z64 * z33 - z5 * z69 + (c_p_b * z72 - s7)
        z113 = z73 * (z30 * z7)
        z114 = z30 * z112 - 2.0 * (z34 * z113)
        z115 = v * (z110 + (z82 * z35 + z13 * z114))
        z116 = z20 * z89
        z117 = l * z64
        s8 = z97 + z15 * z105 + (z12 * z117 + (z17 * z108 + z81 * z28))
        z118 = z35 * z94 - z7 * s8
        s9 = z48 * z96 + z116 * (z74 * z47 + z19 * z114 - z118)
        z119 = z55 * z88 + z104 * z115 + s9
        z120 = z24 * z89
        s10 = z91 - z15 * z107 - (z11 * z117 - (z17 * z106 + z79 * z28))
        z121 = z35 * z99 + z7 * s10
        s11 = z119 - (z36 * z101 + z120 * (z74 * z29 - z23 * z114 + z121))
        s12 = (J_2 * (z59 * z35 - z61) + m * (z61 + z25 * z35)) * z103
        z122 = s12 + z62 * s11
        z123 = z7 * (z60 + z13 * z57)
        z124 = c_p_f * z65 - s_p_f * z70
        s13 = c_p_f * z71 - s_p_f * (s_p_f * z69 - c_p_b * z65)
        z125 = 2.0 * (k2 * (2.0 * (z41 * z65) + s13))
        s14 = z64 * z42 + s_p_b * (4.0 * z111 - z125)
        z126 = z30 * (2.0 * z124 - 6.0 * (k1 * z124) - s14)
        z127 = z126 - 2.0 * (z43 * z113)
        z128 = v * (z110 - (z82 * z44 + z13 * z127))
        z129 = l * z65
        s15 = s1 * z129 + (z77 * z38 - z21 * z58)
        z130 = z7 * (s15 + (z98 + z17 * (z79 - z11 * z58)))
        s16 = z116 * (z44 * z94 - z130 - (z74 * z50 + z19 * z127))
        z131 = z57 * z88 + z104 * z128 - (z51 * z96 - s16)
        s17 = c1 * z129 - (z80 * z38 - z16 * z58)
        z132 = z7 * (s17 - (z93 - z17 * (z81 + z12 * z58)))
        s18 = z120 * (z44 * z99 - z132 + (z74 * z39 - z23 * z127))
        z133 = z62 * (z131 + (z45 * z101 + s18))
        s19 = (J_2 * (z59 * z44 + z123) - m * (z123 - z25 * z44)) * z103
        z134 = s19 - z133
        z135 = m * z24
        z136 = m * z20
        s20 = (z95 + z27 * (z23 * z14)) * z136 + z83 * z104
        z137 = (z100 - z27 * (z19 * z14)) * z135 + s20
        z138 = z62 * z137
        z139 = z62 * (z56 * z104 + z49 * z136 - z37 * z135)
        z140 = z62 * (z58 * z104 - z52 * z136 + z46 * z135)
        z141 = z62 * z102
        z142 = z115 - (z55 * z141 + z14 * z122)
        z143 = z128 - (z57 * z141 - z14 * z134)
        z144 = z83 - z14 * z138
        z145 = z56 - z14 * z139
        z146 = z58 - z14 * z140
        J: list[float] = [
            0.0,
            0.0,
            # (I.2.15)
            -z27 * z19,
            0.0,
            # (I.2.15)
            -z37,
            # (I.2.15)
            -z46,
            # (I.2.15)
            z24,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z27 * z23,
            0.0,
            # (I.2.15)
            z49,
            # (I.2.15)
            z52,
            # (I.2.15)
            z20,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z56,
            # (I.2.15)
            z58,
            # (I.2.15)
            -z14,
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
            z122,
            # (I.2.15)
            z134,
            # (I.2.15)
            z138,
            0.0,
            # (I.2.15)
            -z139,
            # (I.2.15)
            z140,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z142,
            # (I.2.15)
            z143,
            # (I.2.15)
            -z144,
            0.0,
            # (I.2.15)
            z145,
            # (I.2.15)
            -z146,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z142,
            # (I.2.15)
            z143,
            # (I.2.15)
            -z144,
            0.0,
            # (I.2.15)
            z145,
            # (I.2.15)
            -z146,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z142,
            # (I.2.15)
            z143,
            # (I.2.15)
            -z144,
            0.0,
            # (I.2.15)
            z145,
            # (I.2.15)
            -z146,
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
        k1 = l * l
        k2 = 1.0 - k1
        k3 = abs(l)
        k4 = 2.0 + k3
        # from the state
        s_p_b = math.sin(p_b)
        s_p_f = math.sin(p_f)
        z1 = s_p_f * s_p_f
        z2 = 2.0 * z1
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z3 = c_p_b * c_p_f
        s1 = s_p_b * (1.0 - z2 - k1 * (3.0 - z2))
        s2 = s_p_b * (s1 - 2.0 * (s_p_f * z3 * k2))
        z4 = s2 + (z1 + k1 * (4.0 - 3.0 * z1))
        s3 = (2.0 + 4.0 * k3) * k4
        # the coframe is singular
        if not abs(z4) > 1e-12 * (k4 * s3):
            raise _refuse(abs(z4), 1e-12 * (k4 * s3), 1, "outputs")
        out: list[float] = [
            # speed 32:10
            2.0 * (l * (z3 * v / z4)),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
