# ruff: noqa: E741
"""snakeboard, emitted by nhc 0.1.0 (nhc:3dc31d59ecbd9498).

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
y[6] = v
y[7] = psi'
y[8] = p_b'
y[9] = p_f'

Parameters p:
p[0]: m = 1.0 [kg]: mass of everything
p[1]: l = 0.5 [m]: from the centre to an axle
p[2]: J = 0.1 [kg*m^2]: board
p[3]: J_r = 0.05 [kg*m^2]: rotor
p[4]: J_w = 0.02 [kg*m^2]: each axle
p[5]: tau = 0.05 [N*m]: amplitude of the torque on the rotor
p[6]: sigma = 0.02 [N*m]: amplitude of the torques on the axles
p[7]: nu = 1.0 [rad/s]: frequency of the torques

Constraints:
0: back
1: front

Outputs:
out[0] = speed

Operations:
rhs: 72 +-, 138 *, 6 /, 11 calls
velocities: 15 +-, 33 *, 1 /, 9 calls
accelerations: 78 +-, 142 *, 6 /, 11 calls
state: 7 +-, 11 *, 0 /, 6 calls
residuals: 6 +-, 8 *, 0 /, 6 calls
reactions: 108 +-, 192 *, 6 /, 11 calls
energy: 21 +-, 44 *, 1 /, 8 calls
jacobian: 445 +-, 832 *, 7 /, 11 calls
outputs: 15 +-, 28 *, 1 /, 11 calls

A singular point raises SingularModelError.
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
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = c_p_b * c_p_f
        z2 = theta + p_b
        s1 = math.sin(z2)
        z3 = theta + p_f
        s2 = math.sin(z3)
        c1 = math.cos(z2)
        c2 = math.cos(z3)
        z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z5 = s2 * s2
        z6 = 1.0 - 2.0 * z5
        z7 = c1 * s2
        z8 = s1 * z6 - 2.0 * (c2 * z7)
        s4 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)))
        z9 = s4 + (z5 + s1 * z8)
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z9) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "rhs")
        z10 = s1 * c2 - z7
        z11 = 1.0 / z9
        z12 = z10 * z11
        z13 = J_w * z12
        z14 = z12 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = c1 * z15 + z16 * c2
        z18 = z17 * z11
        z19 = s1 * z15 + z16 * s2
        z20 = z19 * z11
        z21 = J_r * z12
        s6 = z18 * (m * z18) + z20 * (m * z20) + z12 * (J * z12)
        z22 = s6 + z12 * z21 + z14
        z23 = z14 + z22
        # the mass matrix is singular
        if not abs(z23) > 0.0:
            raise SingularModelError(2, "rhs")
        z24 = 1.0 / z23
        z25 = z21 * z24
        z26 = J_r - z21 * z25
        # the mass matrix is singular
        if not abs(z26) > 1e-14 * J_r:
            raise SingularModelError(2, "rhs")
        z27 = z13 * z24
        z28 = z13 * z27
        z29 = z21 * z27
        z30 = 1.0 / z26
        z31 = z29 * z30
        z32 = z29 * z31
        z33 = J_w - z28 - z32
        # the mass matrix is singular
        if not abs(z33) > 1e-14 * J_w:
            raise SingularModelError(2, "rhs")
        z34 = z28 + z32
        z35 = 1.0 / z33
        z36 = z34 * z35
        z37 = z33 - z34 * z36
        # the mass matrix is singular
        if not abs(z37) > 1e-14 * J_w:
            raise SingularModelError(2, "rhs")
        z38 = z17 * v
        z39 = z19 * v
        z40 = z10 * v
        z41 = z11 * z40
        z42 = p_b_dot * s_p_b
        z43 = p_f_dot * s_p_f
        z44 = p_b_dot - z41
        z45 = c1 * z44
        z46 = p_f_dot - z41
        z47 = c2 * z46
        z48 = s1 * z44
        z49 = s2 * z46
        s7 = 2.0 * (s2 * z45 + s1 * z47) - 2.0 * (c2 * z48 + c1 * z49)
        z50 = z4 * (c_p_f * z42 + c_p_b * z43) - z1 * s7
        z51 = s2 * z47
        z52 = s2 * z48 - c1 * z47
        s8 = z6 * z45 - 4.0 * (s1 * z51) + 2.0 * (z7 * z49 + c2 * z52)
        z53 = z8 * z45 + s1 * s8
        s9 = 2.0 * (s_p_b * (p_b_dot * c_p_b))
        s10 = k1 * (z50 + (s9 + 2.0 * (s_p_f * (p_f_dot * c_p_f))))
        z54 = s10 - (2.0 * z51 + z53)
        z55 = z54 / (z9 * z9)
        z56 = z40 * z55 + z11 * (v * (c2 * z45 - s1 * z49 + z52))
        z57 = J_w * z56
        z58 = z12 * z57
        z59 = J_r * z56
        z60 = l * z43
        z61 = l * z42
        s11 = z11 * (v * (z15 * z48 + c1 * z60 + (c2 * z61 + z16 * z49)))
        z62 = s11 - z38 * z55
        s12 = z11 * (v * (z15 * z45 - s1 * z60 - (s2 * z61 - z16 * z47)))
        z63 = z39 * z55 + s12
        s13 = z12 * (J * z56) - (z18 * (m * z62) - z20 * (m * z63))
        z64 = z58 + (z12 * z59 + s13)
        z65 = z58 + z64
        z66 = t_ * nu
        s3 = math.sin(z66)
        z67 = tau * s3 + z59 - z65 * z25
        c3 = math.cos(z66)
        z68 = sigma * c3
        z69 = z65 * z27
        z70 = z31 * z67
        z71 = z68 + z57 - z69 + z70
        z72 = (z70 - (z68 - z57 + z69) + z36 * z71) / z37
        z73 = z35 * z71 + z36 * z72
        z74 = z30 * z67 + z31 * z73 + z31 * z72
        dydt: list[float] = [
            # x' (I.2.15)
            z38 * z11,
            # y' (I.2.15)
            z11 * z39,
            # theta' (I.2.15)
            -z41,
            # psi' (I.2.15)
            psi_dot,
            # p_b' (I.2.15)
            p_b_dot,
            # p_f' (I.2.15)
            p_f_dot,
            # v' (I.2.15) 22:4
            z27 * z72 - (z65 * z24 - z25 * z74 - z27 * z73),
            # psi'' (I.2.15) 22:4
            z74,
            # p_b'' (I.2.15) 22:4
            z73,
            # p_f'' (I.2.15) 22:4
            z72,
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
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = theta + p_b
        s1 = math.sin(z1)
        z2 = theta + p_f
        s2 = math.sin(z2)
        c1 = math.cos(z1)
        c2 = math.cos(z2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        s3 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2))
        z3 = s3 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))
        z4 = s2 * s2
        z5 = c1 * s2
        s4 = z4 + s1 * (s1 * (1.0 - 2.0 * z4) - 2.0 * (c2 * z5))
        z6 = k1 * z3 + s4
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z6) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "velocities")
        z7 = l * c_p_f
        z8 = l * c_p_b
        z9 = 1.0 / z6
        qdot: list[float] = [
            # x' (I.2.4)
            (c1 * z7 + z8 * c2) * v * z9,
            # y' (I.2.4)
            z9 * ((s1 * z7 + z8 * s2) * v),
            # theta' (I.2.4)
            -z9 * ((s1 * c2 - z5) * v),
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
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = c_p_b * c_p_f
        z2 = theta + p_b
        s1 = math.sin(z2)
        z3 = theta + p_f
        s2 = math.sin(z3)
        c1 = math.cos(z2)
        c2 = math.cos(z3)
        z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z5 = s2 * s2
        z6 = 1.0 - 2.0 * z5
        z7 = c1 * s2
        z8 = s1 * z6 - 2.0 * (c2 * z7)
        s4 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)))
        z9 = s4 + (z5 + s1 * z8)
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z9) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "accelerations")
        z10 = s1 * c2 - z7
        z11 = 1.0 / z9
        z12 = z10 * z11
        z13 = J_w * z12
        z14 = z12 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = c1 * z15 + z16 * c2
        z18 = z17 * z11
        z19 = s1 * z15 + z16 * s2
        z20 = z19 * z11
        z21 = J_r * z12
        s6 = z18 * (m * z18) + z20 * (m * z20) + z12 * (J * z12)
        z22 = s6 + z12 * z21 + z14
        z23 = z14 + z22
        # the mass matrix is singular
        if not abs(z23) > 0.0:
            raise SingularModelError(2, "accelerations")
        z24 = 1.0 / z23
        z25 = z21 * z24
        z26 = J_r - z21 * z25
        # the mass matrix is singular
        if not abs(z26) > 1e-14 * J_r:
            raise SingularModelError(2, "accelerations")
        z27 = z13 * z24
        z28 = z13 * z27
        z29 = z21 * z27
        z30 = 1.0 / z26
        z31 = z29 * z30
        z32 = z29 * z31
        z33 = J_w - z28 - z32
        # the mass matrix is singular
        if not abs(z33) > 1e-14 * J_w:
            raise SingularModelError(2, "accelerations")
        z34 = z28 + z32
        z35 = 1.0 / z33
        z36 = z34 * z35
        z37 = z33 - z34 * z36
        # the mass matrix is singular
        if not abs(z37) > 1e-14 * J_w:
            raise SingularModelError(2, "accelerations")
        z38 = p_b_dot * s_p_b
        z39 = p_f_dot * s_p_f
        z40 = z10 * v
        z41 = z11 * z40
        z42 = p_b_dot - z41
        z43 = c1 * z42
        z44 = p_f_dot - z41
        z45 = c2 * z44
        z46 = s1 * z42
        z47 = s2 * z44
        s7 = 2.0 * (s2 * z43 + s1 * z45) - 2.0 * (c2 * z46 + c1 * z47)
        z48 = z4 * (c_p_f * z38 + c_p_b * z39) - z1 * s7
        z49 = s2 * z45
        z50 = s2 * z46 - c1 * z45
        s8 = z6 * z43 - 4.0 * (s1 * z49) + 2.0 * (z7 * z47 + c2 * z50)
        z51 = z8 * z43 + s1 * s8
        s9 = 2.0 * (s_p_b * (p_b_dot * c_p_b))
        s10 = k1 * (z48 + (s9 + 2.0 * (s_p_f * (p_f_dot * c_p_f))))
        z52 = s10 - (2.0 * z49 + z51)
        z53 = z52 / (z9 * z9)
        z54 = z17 * v * z53
        z55 = l * z39
        z56 = l * z38
        z57 = v * (z15 * z46 + c1 * z55 + (c2 * z56 + z16 * z47))
        z58 = z40 * z53
        z59 = v * (c2 * z43 - s1 * z47 + z50)
        z60 = z58 + z11 * z59
        z61 = J_w * z60
        z62 = z12 * z61
        z63 = J_r * z60
        z64 = z19 * v * z53
        z65 = v * (z15 * z43 - s1 * z55 - (s2 * z56 - z16 * z45))
        s11 = z18 * (m * (z11 * z57 - z54))
        z66 = z12 * (J * z60) - (s11 - z20 * (m * (z64 + z11 * z65)))
        z67 = z62 + (z62 + (z12 * z63 + z66))
        z68 = t_ * nu
        s3 = math.sin(z68)
        z69 = tau * s3 + z63 - z67 * z25
        c3 = math.cos(z68)
        z70 = sigma * c3
        z71 = z67 * z27
        z72 = z31 * z69
        z73 = z70 + z61 - z71 + z72
        z74 = (z72 - (z70 - z61 + z71) + z36 * z73) / z37
        z75 = z35 * z73 + z36 * z74
        z76 = z30 * z69 + z31 * z75 + z31 * z74
        z77 = z67 * z24 - z25 * z76 - z27 * z75 - z27 * z74
        qddot: list[float] = [
            # x'' (I.2.15)
            z54 - z11 * (z57 + z17 * z77),
            # y'' (I.2.15)
            z64 + z11 * (z65 - z19 * z77),
            # theta'' (I.2.15)
            -(z58 + z11 * (z59 - z10 * z77)),
            # psi'' (I.2.15)
            z76,
            # p_b'' (I.2.15)
            z75,
            # p_f'' (I.2.15)
            z74,
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
        # state
        z1 = theta + p_b
        s1 = math.sin(z1)
        z2 = theta + p_f
        c1 = math.cos(z2)
        c2 = math.cos(z1)
        s2 = math.sin(z2)
        c_p_f = math.cos(p_f)
        c_p_b = math.cos(p_b)
        s3 = x_dot * (l * (c2 * c_p_f + c_p_b * c1))
        z3 = s3 + y_dot * (l * (s1 * c_p_f + c_p_b * s2))
        y: list[float] = [
            x,
            y_2,
            theta,
            psi,
            p_b,
            p_f,
            z3 - theta_dot * (s1 * c1 - c2 * s2),
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
    """left sides of the constraints, zero on every motion (I.1.1)

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
        # state
        z1 = theta + p_b
        s1 = math.sin(z1)
        c1 = math.cos(z1)
        c_p_b = math.cos(p_b)
        z2 = theta + p_f
        s2 = math.sin(z2)
        c2 = math.cos(z2)
        c_p_f = math.cos(p_f)
        r: list[float] = [
            # back = 0 (I.1.1) 28:5
            -(x_dot * s1 - y_dot * c1 + theta_dot * (l * c_p_b)),
            # front = 0 (I.1.1) 29:5
            theta_dot * (l * c_p_f) - (x_dot * s2 - y_dot * c2),
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

    Arguments: t (scalar), y (10,), p (8,).
    Returns lambda_ (2,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
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
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = c_p_b * c_p_f
        z2 = theta + p_b
        s1 = math.sin(z2)
        z3 = theta + p_f
        s2 = math.sin(z3)
        c1 = math.cos(z2)
        c2 = math.cos(z3)
        z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z5 = s2 * s2
        z6 = 1.0 - 2.0 * z5
        z7 = c1 * s2
        z8 = s1 * z6 - 2.0 * (c2 * z7)
        s4 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)))
        z9 = s4 + (z5 + s1 * z8)
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z9) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "reactions")
        z10 = s1 * c2 - z7
        z11 = 1.0 / z9
        z12 = z10 * z11
        z13 = J_w * z12
        z14 = z12 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = c1 * z15 + z16 * c2
        z18 = z17 * z11
        z19 = m * z18
        z20 = s1 * z15 + z16 * s2
        z21 = z20 * z11
        z22 = m * z21
        z23 = J * z12
        z24 = J_r * z12
        z25 = z14 + (z18 * z19 + z21 * z22 + z12 * z23 + z12 * z24 + z14)
        # the mass matrix is singular
        if not abs(z25) > 0.0:
            raise SingularModelError(2, "reactions")
        z26 = 1.0 / z25
        z27 = z24 * z26
        z28 = J_r - z24 * z27
        # the mass matrix is singular
        if not abs(z28) > 1e-14 * J_r:
            raise SingularModelError(2, "reactions")
        z29 = z13 * z26
        z30 = z13 * z29
        z31 = z24 * z29
        z32 = 1.0 / z28
        z33 = z31 * z32
        z34 = z31 * z33
        z35 = J_w - z30 - z34
        # the mass matrix is singular
        if not abs(z35) > 1e-14 * J_w:
            raise SingularModelError(2, "reactions")
        z36 = z30 + z34
        z37 = 1.0 / z35
        z38 = z36 * z37
        z39 = z35 - z36 * z38
        # the mass matrix is singular
        if not abs(z39) > 1e-14 * J_w:
            raise SingularModelError(2, "reactions")
        z40 = l * (c1 * c_p_f + c_p_b * c2)
        z41 = l * (s1 * c_p_f + c_p_b * s2)
        z42 = z11 * (c2 * z40 + s2 * z41)
        z43 = z10 * v
        z44 = p_b_dot * s_p_b
        z45 = p_f_dot * s_p_f
        z46 = z11 * z43
        z47 = p_b_dot - z46
        z48 = c1 * z47
        z49 = p_f_dot - z46
        z50 = c2 * z49
        z51 = s1 * z47
        z52 = s2 * z49
        s6 = 2.0 * (s2 * z48 + s1 * z50) - 2.0 * (c2 * z51 + c1 * z52)
        z53 = z4 * (c_p_f * z44 + c_p_b * z45) - z1 * s6
        z54 = s2 * z50
        z55 = s2 * z51 - c1 * z50
        s7 = z6 * z48 - 4.0 * (s1 * z54) + 2.0 * (z7 * z52 + c2 * z55)
        z56 = z8 * z48 + s1 * s7
        s8 = 2.0 * (s_p_b * (p_b_dot * c_p_b))
        s9 = k1 * (z53 + (s8 + 2.0 * (s_p_f * (p_f_dot * c_p_f))))
        z57 = s9 - (2.0 * z54 + z56)
        z58 = z57 / (z9 * z9)
        z59 = z43 * z58 + z11 * (v * (c2 * z48 - s1 * z52 + z55))
        z60 = J_w * z59
        z61 = z42 * z60
        z62 = J_r * z59
        z63 = J * z59
        z64 = z11 * (z15 * z41 + c2 * z10)
        z65 = l * z45
        z66 = l * z44
        s10 = z11 * (v * (z15 * z51 + c1 * z65 + (c2 * z66 + z16 * z52)))
        z67 = s10 - z17 * v * z58
        z68 = m * z67
        z69 = z11 * (z15 * z40 - s2 * z10)
        s11 = z11 * (v * (z15 * z48 - s1 * z65 - (s2 * z66 - z16 * z50)))
        z70 = z20 * v * z58 + s11
        z71 = m * z70
        z72 = J_w * z42
        z73 = t_ * nu
        s3 = math.sin(z73)
        z74 = z12 * z60
        s12 = z74 + (z12 * z62 + (z12 * z63 - (z18 * z68 - z21 * z71)))
        z75 = z74 + s12
        z76 = tau * s3 + z62 - z75 * z27
        z77 = z33 * z76
        c3 = math.cos(z73)
        z78 = sigma * c3
        z79 = z75 * z29
        z80 = z78 + z60 - z79 + z77
        z81 = (z77 - (z78 - z60 + z79) + z38 * z80) / z39
        z82 = z37 * z80 + z38 * z81
        z83 = z42 * z13
        z84 = z32 * z76 + z33 * z82 + z33 * z81
        z85 = z75 * z26 - z27 * z84 - z29 * z82 - z29 * z81
        s13 = z83 - (z64 * z19 - z69 * z22 - z42 * z23 - z42 * z24 - z83)
        z86 = s13 * z85 + J_r * z42 * z84
        s14 = z61 + (z42 * z62 + (z42 * z63 + (z64 * z68 + z69 * z71)))
        z87 = z61 + s14 - (z72 * z81 + (z72 * z82 + z86))
        z88 = z11 * (c1 * z40 + s1 * z41)
        z89 = z88 * z60
        z90 = z11 * (z16 * z41 - c1 * z10)
        z91 = z11 * (z16 * z40 + s1 * z10)
        z92 = J_w * z88
        z93 = z88 * z13
        s15 = z93 + (z90 * z19 - z91 * z22 + z88 * z23 + z88 * z24 + z93)
        z94 = s15 * z85 + J_r * z88 * z84
        s16 = z89 + (z88 * z62 + (z88 * z63 - (z90 * z68 + z91 * z71)))
        z95 = z89 + s16 - (z92 * z81 + (z92 * z82 + z94))
        lambda_: list[float] = [
            # reaction of back: Q_i gains lambda_1 a_1i (I.4.1) 28:5
            z87,
            # reaction of front: Q_i gains lambda_2 a_2i (I.4.1) 29:5
            -z95,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

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
        # parameters only
        k1 = l * l
        # state
        z1 = theta + p_b
        c1 = math.cos(z1)
        c_p_f = math.cos(p_f)
        z2 = l * c_p_f
        c_p_b = math.cos(p_b)
        z3 = l * c_p_b
        z4 = theta + p_f
        c2 = math.cos(z4)
        s1 = math.sin(z1)
        s2 = math.sin(z4)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        s3 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2))
        z5 = s3 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))
        z6 = s2 * s2
        z7 = c1 * s2
        s4 = z6 + s1 * (s1 * (1.0 - 2.0 * z6) - 2.0 * (c2 * z7))
        z8 = 1.0 / (k1 * z5 + s4)
        z9 = (c1 * z2 + z3 * c2) * v * z8
        z10 = z8 * ((s1 * z2 + z3 * s2) * v)
        z11 = z8 * ((s1 * c2 - z7) * v)
        z12 = psi_dot - z11
        s5 = 0.5 * (m * (z9 * z9 + z10 * z10)) + 0.5 * (J * (z11 * z11))
        z13 = s5 + 0.5 * (J_r * (z12 * z12))
        z14 = p_b_dot - z11
        z15 = p_f_dot - z11
        value1 = z13 + 0.5 * (J_w * (z14 * z14 + z15 * z15))
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

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
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = c_p_b * c_p_f
        z2 = theta + p_b
        s1 = math.sin(z2)
        z3 = theta + p_f
        s2 = math.sin(z3)
        c1 = math.cos(z2)
        c2 = math.cos(z3)
        z4 = 2.0 * (s1 * s2) + 2.0 * (c1 * c2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        z5 = s2 * s2
        z6 = 1.0 - 2.0 * z5
        z7 = c1 * s2
        z8 = s1 * z6 - 2.0 * (c2 * z7)
        s4 = k1 * (z1 * z4 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b)))
        z9 = s4 + (z5 + s1 * z8)
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z9) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "jacobian")
        z10 = s1 * c2 - z7
        z11 = 1.0 / z9
        z12 = z10 * z11
        z13 = J_w * z12
        z14 = z12 * z13
        z15 = l * c_p_f
        z16 = l * c_p_b
        z17 = c1 * z15 + z16 * c2
        z18 = z17 * z11
        z19 = m * z18
        z20 = s1 * z15 + z16 * s2
        z21 = z20 * z11
        z22 = m * z21
        z23 = J_2 * z12
        z24 = J_r * z12
        z25 = z14 + (z18 * z19 + z21 * z22 + z12 * z23 + z12 * z24 + z14)
        # the mass matrix is singular
        if not abs(z25) > 0.0:
            raise SingularModelError(2, "jacobian")
        z26 = 1.0 / z25
        z27 = z24 * z26
        z28 = J_r - z24 * z27
        # the mass matrix is singular
        if not abs(z28) > 1e-14 * J_r:
            raise SingularModelError(2, "jacobian")
        z29 = z13 * z26
        z30 = z13 * z29
        z31 = z24 * z29
        z32 = 1.0 / z28
        z33 = z31 * z32
        z34 = z31 * z33
        z35 = J_w - z30 - z34
        # the mass matrix is singular
        if not abs(z35) > 1e-14 * J_w:
            raise SingularModelError(2, "jacobian")
        z36 = z30 + z34
        z37 = 1.0 / z35
        z38 = z36 * z37
        z39 = z35 - z36 * z38
        # the mass matrix is singular
        if not abs(z39) > 1e-14 * J_w:
            raise SingularModelError(2, "jacobian")
        z40 = z17 * v
        z41 = 1.0 / (z9 * z9)
        z42 = z40 * z41
        z43 = s1 * z42
        z44 = k1 * z42
        z45 = z1 * z44
        z46 = v * z11
        z47 = z16 * z46
        z48 = c2 * z43
        s6 = 2.0 * (s2 * (z42 - 2.0 * (s1 * z43))) + 2.0 * (s1 * z45)
        z49 = s6 - 2.0 * (c1 * z48)
        z50 = s2 * (2.0 * (z7 * z43) - 2.0 * (c1 * z45) + z47) + c2 * z49
        z51 = z15 * z46
        s7 = s1 * (2.0 * (c2 * z45) - z51 - 2.0 * (s2 * z48))
        z52 = s7 - c1 * (z8 * z42 + z6 * z43 + 2.0 * (s2 * z45))
        z53 = z4 * z44
        z54 = c2 * z46
        z55 = z20 * v
        z56 = z55 * z41
        z57 = s1 * z56
        z58 = k1 * z56
        z59 = z1 * z58
        z60 = c2 * z57
        s8 = 2.0 * (s2 * (z56 - 2.0 * (s1 * z57))) + 2.0 * (s1 * z59)
        z61 = z47 - s8 + 2.0 * (c1 * z60)
        z62 = s2 * (2.0 * (z7 * z57) - 2.0 * (c1 * z59)) - c2 * z61
        s9 = c1 * (z51 - (z8 * z56 + z6 * z57 + 2.0 * (s2 * z59)))
        z63 = s1 * (2.0 * (c2 * z59) - 2.0 * (s2 * z60)) + s9
        z64 = z4 * z58
        z65 = s1 * z46
        z66 = z10 * v
        z67 = z66 * z41
        z68 = s1 * z67
        z69 = k1 * z67
        z70 = z1 * z69
        z71 = z46 - 2.0 * (c2 * z68)
        s10 = 2.0 * (s2 * (z67 - 2.0 * (s1 * z68))) + 2.0 * (s1 * z70)
        z72 = c2 * (s10 + c1 * z71)
        z73 = s2 * (z65 + (2.0 * (z7 * z68) - 2.0 * (c1 * z70))) + z72
        s11 = c1 * (z54 - (z8 * z67 + z6 * z68 + 2.0 * (s2 * z70)))
        z74 = s1 * (2.0 * (c2 * z70) + s2 * z71) + s11
        z75 = z4 * z69
        z76 = z11 * z66
        z77 = p_b_dot - z76
        z78 = s1 * z77
        z79 = p_f_dot - z76
        z80 = c2 * z79
        z81 = s2 * z78 - c1 * z80
        z82 = z23 + (z24 + 2.0 * z13)
        z83 = z66 * z82 + z55 * z22 + z40 * z19
        z84 = z41 * z83
        z85 = s1 * z84
        z86 = k1 * z84
        z87 = z1 * z86
        z88 = p_b_dot * s_p_b
        z89 = l * z88
        z90 = z11 * z19
        z91 = v * z90
        z92 = c1 * z77
        z93 = z11 * z82
        z94 = v * z93
        z95 = 2.0 * z84 - 4.0 * (s1 * z85)
        z96 = z11 * z22
        z97 = v * z96
        z98 = z94 - 2.0 * (c2 * z85)
        z99 = s2 * z95 + 2.0 * (s1 * z87) - z16 * z97 + c1 * z98
        s12 = 2.0 * (z81 * z85) - 2.0 * (z78 * z87) + z89 * z91
        z100 = s12 - z92 * z94 + z79 * z99
        z101 = p_f_dot * s_p_f
        z102 = c_p_f * z88 + c_p_b * z101
        z103 = s2 * z79
        z104 = 2.0 * (s2 * z92 + s1 * z80) - 2.0 * (c2 * z78 + c1 * z103)
        z105 = p_b_dot * c_p_b
        z106 = p_f_dot * c_p_f
        z107 = s2 * z80
        z108 = z6 * z92 - 4.0 * (s1 * z107) + 2.0 * (z7 * z103 + c2 * z81)
        s13 = 2.0 * (s_p_b * z105) + 2.0 * (s_p_f * z106)
        s14 = 2.0 * z107 + (z8 * z92 + s1 * z108)
        z109 = k1 * (z4 * z102 - z1 * z104 + s13) - s14
        z110 = 1.0 / (z9 * z9 * z9)
        z111 = c2 * z92 - s1 * z103 + z81
        z112 = v * z111
        z113 = l * z101
        z114 = z15 * z92 - s1 * z113 - (s2 * z89 - z16 * z80)
        z115 = v * z114
        z116 = z15 * z78 + c1 * z113 + (c2 * z89 + z16 * z103)
        z117 = v * z116
        z118 = 2.0 * (z7 * z85) - 2.0 * (c1 * z87) + z16 * z91 + s1 * z94
        z119 = s2 * z118 + c2 * z99
        z120 = 2.0 * (c2 * z87) - z15 * z91 + s2 * z98
        s15 = z8 * z84 + z6 * z85 + 2.0 * (s2 * z87) - z15 * z97
        z121 = s15 - c2 * z94
        z122 = s1 * z120 - c1 * z121
        z123 = z119 - z122
        z124 = z109 * z41
        z125 = z66 * z124 + z11 * z112
        z126 = J_w * z125
        z127 = z12 * z126
        z128 = J_r * z125
        z129 = J_2 * z125
        z130 = m * (z11 * z117 - z40 * z124)
        z131 = m * (z55 * z124 + z11 * z115)
        s16 = z127 + (z12 * z128 + (z12 * z129 - (z18 * z130 - z21 * z131)))
        z132 = z127 + s16
        z133 = t_ * nu
        s3 = math.sin(z133)
        z134 = tau * s3 + z128 - z132 * z27
        c3 = math.cos(z133)
        z135 = sigma * c3
        z136 = z132 * z29
        z137 = z33 * z134
        z138 = z135 + z126 - z136 + z137
        z139 = 1.0 / z39
        z140 = z139 * (z137 - (z135 - z126 + z136) + z38 * z138)
        z141 = z37 * z138 + z38 * z140
        z142 = z32 * z134 + z33 * z141 + z33 * z140
        z143 = z132 * z26 - z27 * z142 - z29 * z141 - z29 * z140
        z144 = z12 * z143
        s17 = z129 + (z128 + 2.0 * z126) - 2.0 * (z13 * z143)
        z145 = s17 - J_w * (z140 + z141 + 2.0 * z144)
        s18 = z24 * z143 - z145 + J_r * (z142 + z144) + z23 * z143
        z146 = s18 + J_2 * z144
        z147 = z131 - z22 * z143 - m * (z21 * z143)
        s19 = z112 * z82 + z115 * z22 - z117 * z19 + z66 * z123
        z148 = s19 - z10 * z146 + z20 * z147
        z149 = z130 + z19 * z143 + m * (z18 * z143)
        z150 = 2.0 * (z109 * z83 * z110) + z41 * (z148 - z17 * z149)
        z151 = z92 * z84 + s1 * z150
        z152 = k1 * z150
        z153 = z102 * z86 - z1 * z152
        z154 = z124 * z19
        z155 = v * z154 - z11 * z149
        z156 = z124 * z82 + z11 * z123
        z157 = v * z156 - z11 * z146
        s20 = z100 - 2.0 * (z7 * z151) - 2.0 * (c1 * z153) - z16 * z155
        z158 = s2 * (s20 - s1 * z157)
        s21 = z80 * z95 + 2.0 * (z92 * z87) + z89 * z97 - z78 * z98
        s22 = 2.0 * (s2 * (z150 - 2.0 * (z92 * z85 + s1 * z151)))
        z159 = s21 + z79 * z118 + s22
        z160 = z124 * z22
        z161 = v * z160 + z11 * z147
        z162 = z157 + (2.0 * (z103 * z85) - 2.0 * (c2 * z151))
        s23 = c2 * (z159 - 2.0 * (s1 * z153) - z16 * z161 + c1 * z162)
        z163 = z158 - s23
        s24 = 2.0 * (z103 * z87) - z113 * z91 - z80 * z98 - z77 * z121
        z164 = s24 + 2.0 * (c2 * z153)
        s25 = z108 * z84 - 4.0 * (z107 * z85) + 2.0 * (z80 * z87)
        z165 = s25 + z113 * z97 + z103 * z94
        s26 = z165 - z77 * z120 + z8 * z150 + z6 * z151
        z166 = s26 - 2.0 * (s2 * z153) - z15 * z161
        s27 = s1 * (z164 + z15 * z155 - s2 * z162)
        z167 = s27 + c1 * (z166 - c2 * z157)
        z168 = z163 - z167
        z169 = J_r * z66
        z170 = z41 * z169
        z171 = s1 * z170
        z172 = k1 * z170
        z173 = z1 * z172
        z174 = J_r * z11
        z175 = v * z174
        z176 = 2.0 * z170 - 4.0 * (s1 * z171)
        z177 = z175 - 2.0 * (c2 * z171)
        z178 = s2 * z176 + 2.0 * (s1 * z173) + c1 * z177
        z179 = 2.0 * (z7 * z171) - 2.0 * (c1 * z173) + s1 * z175
        z180 = s2 * z179 + c2 * z178
        z181 = 2.0 * (c2 * z173) + s2 * z177
        z182 = z8 * z170 + z6 * z171 + 2.0 * (s2 * z173) - c2 * z175
        z183 = s1 * z181 - c1 * z182
        z184 = z180 - z183
        z185 = J_r * z143
        s28 = z41 * (J_r * z112 + z66 * z184 - z10 * z185)
        z186 = 2.0 * (z110 * (z109 * z169)) + s28
        z187 = z92 * z170 + s1 * z186
        s29 = 2.0 * (z81 * z171) - 2.0 * (z78 * z173) - z92 * z175
        z188 = s29 + z79 * z178 - 2.0 * (z7 * z187)
        z189 = k1 * z186
        z190 = z102 * z172 - z1 * z189
        z191 = J_r * z124 + z11 * z184
        z192 = v * z191 - z11 * z185
        s30 = z80 * z176 + 2.0 * (z92 * z173) - z78 * z177 + z79 * z179
        z193 = s30 + 2.0 * (s2 * (z186 - 2.0 * (z92 * z171 + s1 * z187)))
        z194 = z192 + (2.0 * (z103 * z171) - 2.0 * (c2 * z187))
        s31 = s2 * (z188 - 2.0 * (c1 * z190) - s1 * z192)
        z195 = s31 - c2 * (z193 - 2.0 * (s1 * z190) + c1 * z194)
        s32 = 2.0 * (z103 * z173) - z80 * z177 - z77 * z182
        z196 = s32 + 2.0 * (c2 * z190) - s2 * z194
        s33 = z108 * z170 - 4.0 * (z107 * z171) + 2.0 * (z80 * z173)
        z197 = s33 + z103 * z175 - z77 * z181
        s34 = z197 + z8 * z186 + z6 * z187 - 2.0 * (s2 * z190) - c2 * z192
        z198 = s1 * z196 + c1 * s34
        z199 = z195 - z198 - z27 * z168
        z200 = J_w * z66
        z201 = z41 * z200
        z202 = s1 * z201
        z203 = k1 * z201
        z204 = z1 * z203
        z205 = J_w * z11
        z206 = v * z205
        z207 = 2.0 * z201 - 4.0 * (s1 * z202)
        z208 = z206 - 2.0 * (c2 * z202)
        z209 = s2 * z207 + 2.0 * (s1 * z204) + c1 * z208
        z210 = 2.0 * (z7 * z202) - 2.0 * (c1 * z204) + s1 * z206
        z211 = s2 * z210 + c2 * z209
        z212 = 2.0 * (c2 * z204) + s2 * z208
        z213 = z8 * z201 + z6 * z202 + 2.0 * (s2 * z204) - c2 * z206
        z214 = s1 * z212 - c1 * z213
        z215 = z211 - z214
        z216 = J_w * z143
        s35 = z41 * (J_w * z112 + z66 * z215 - z10 * z216)
        z217 = 2.0 * (z110 * (z109 * z200)) + s35
        z218 = z92 * z201 + s1 * z217
        s36 = 2.0 * (z81 * z202) - 2.0 * (z78 * z204) - z92 * z206
        z219 = s36 + z79 * z209 - 2.0 * (z7 * z218)
        z220 = k1 * z217
        z221 = z102 * z203 - z1 * z220
        z222 = J_w * z124 + z11 * z215
        z223 = v * z222 - z11 * z216
        s37 = z80 * z207 + 2.0 * (z92 * z204) - z78 * z208 + z79 * z210
        z224 = s37 + 2.0 * (s2 * (z217 - 2.0 * (z92 * z202 + s1 * z218)))
        z225 = z223 + (2.0 * (z103 * z202) - 2.0 * (c2 * z218))
        s38 = s2 * (z219 - 2.0 * (c1 * z221) - s1 * z223)
        z226 = s38 - c2 * (z224 - 2.0 * (s1 * z221) + c1 * z225)
        s39 = 2.0 * (z103 * z204) - z80 * z208 - z77 * z213
        z227 = s39 + 2.0 * (c2 * z221) - s2 * z225
        s40 = z108 * z201 - 4.0 * (z107 * z202) + 2.0 * (z80 * z204)
        z228 = s40 + z103 * z206 - z77 * z212
        s41 = z228 + z8 * z217 + z6 * z218 - 2.0 * (s2 * z221) - c2 * z223
        z229 = s1 * z227 + c1 * s41
        z230 = z226 - z229 - z29 * z168 + z33 * z199
        z231 = z139 * (z230 + z38 * z230)
        z232 = z37 * z230 + z38 * z231
        z233 = z32 * z199 + z33 * z232 + z33 * z231
        z234 = z4 * z86
        z235 = c_p_f * z234 - l * (s2 * z97 + c2 * z91)
        z236 = s_p_b * z86
        z237 = z104 * z86 + z4 * z152
        s42 = l * (z80 * z97 - z103 * z91 + s2 * z161 + c2 * z155)
        z238 = z101 * z234 + 2.0 * (p_b_dot * z236) - c_p_f * z237 + s42
        s43 = 2.0 * (z105 * z86) + p_b_dot * z235 + 2.0 * (s_p_b * z152)
        z239 = z167 - (c_p_b * s43 - s_p_b * z238)
        z240 = z4 * z172
        z241 = c_p_f * z240
        z242 = s_p_b * z172
        z243 = z104 * z172 + z4 * z189
        s44 = 2.0 * (z105 * z172) + p_b_dot * z241 + 2.0 * (s_p_b * z189)
        s45 = s_p_b * (z101 * z240 + 2.0 * (p_b_dot * z242) - c_p_f * z243)
        z244 = c_p_b * s44 - s45
        z245 = z198 - z244 - z27 * z239
        z246 = z4 * z203
        z247 = c_p_f * z246
        z248 = s_p_b * z203
        z249 = z104 * z203 + z4 * z220
        s46 = 2.0 * (z105 * z203) + p_b_dot * z247 + 2.0 * (s_p_b * z220)
        s47 = s_p_b * (z101 * z246 + 2.0 * (p_b_dot * z248) - c_p_f * z249)
        z250 = c_p_b * s46 - s47
        z251 = z229 - z250 - z29 * z239 + z33 * z245
        z252 = z139 * (z251 + z38 * z251)
        z253 = z37 * z251 + z38 * z252
        z254 = z32 * z245 + z33 * z253 + z33 * z252
        z255 = c_p_b * z234 - l * (s1 * z97 + c1 * z91)
        z256 = s_p_f * z86
        s48 = l * (z92 * z97 - z78 * z91 + s1 * z161 + c1 * z155)
        z257 = z88 * z234 + 2.0 * (p_f_dot * z256) - c_p_b * z237 + s48
        s49 = 2.0 * (z106 * z86) + p_f_dot * z255 + 2.0 * (s_p_f * z152)
        z258 = z163 + (c_p_f * s49 - s_p_f * z257)
        z259 = c_p_b * z240
        z260 = s_p_f * z172
        s50 = 2.0 * (z106 * z172) + p_f_dot * z259 + 2.0 * (s_p_f * z189)
        s51 = s_p_f * (z88 * z240 + 2.0 * (p_f_dot * z260) - c_p_b * z243)
        z261 = c_p_f * s50 - s51
        z262 = z195 + z261 - z27 * z258
        z263 = c_p_b * z246
        z264 = s_p_f * z203
        s52 = 2.0 * (z106 * z203) + p_f_dot * z263 + 2.0 * (s_p_f * z220)
        s53 = s_p_f * (z88 * z246 + 2.0 * (p_f_dot * z264) - c_p_b * z249)
        z265 = c_p_f * s52 - s53
        z266 = z226 + z265 - z29 * z258 + z33 * z262
        z267 = z139 * (z266 + z38 * z266)
        z268 = z37 * z266 + z38 * z267
        z269 = z32 * z262 + z33 * z268 + z33 * z267
        s54 = z111 * z93 + z114 * z96 - z116 * z90 + z10 * z156
        z270 = s54 + z20 * z160 + z17 * z154
        z271 = z111 * z174 + z10 * z191 - z27 * z270
        z272 = z111 * z205 + z10 * z222 - z29 * z270 + z33 * z271
        z273 = z139 * (z272 + z38 * z272)
        z274 = z37 * z272 + z38 * z273
        z275 = z32 * z271 + z33 * z274 + z33 * z273
        z276 = 2.0 * (c_p_b * z236) + s_p_b * z235 + z122
        z277 = 2.0 * (c_p_b * z242) + s_p_b * z241 + z183 - z27 * z276
        s55 = 2.0 * (c_p_b * z248) + s_p_b * z247 + z214 - z29 * z276
        z278 = s55 + z33 * z277
        z279 = z139 * (z278 + z38 * z278)
        z280 = z37 * z278 + z38 * z279
        z281 = z32 * z277 + z33 * z280 + z33 * z279
        z282 = 2.0 * (c_p_f * z256) + s_p_f * z255 - z119
        z283 = 2.0 * (c_p_f * z260) + s_p_f * z259 - z180 - z27 * z282
        s56 = 2.0 * (c_p_f * z264) + s_p_f * z263 - z211 - z29 * z282
        z284 = s56 + z33 * z283
        z285 = z139 * (z284 + z38 * z284)
        z286 = z37 * z284 + z38 * z285
        z287 = z32 * z283 + z33 * z286 + z33 * z285
        s57 = s_p_b * (c_p_f * z53 - l * z54)
        s58 = s_p_f * (c_p_b * z53 - l * (c1 * z46))
        s59 = s_p_b * (c_p_f * z64 - l * (s2 * z46))
        s60 = s_p_f * (c_p_b * z64 - l * z65)
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z52 - z50,
            # (I.2.15)
            0.0,
            # (I.2.15)
            2.0 * (c_p_b * (s_p_b * z44)) + s57 + z52,
            # (I.2.15)
            2.0 * (c_p_f * (s_p_f * z44)) + s58 - z50,
            # (I.2.15)
            z18,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z63 - z62,
            # (I.2.15)
            0.0,
            # (I.2.15)
            2.0 * (c_p_b * (s_p_b * z58)) + s59 + z63,
            # (I.2.15)
            2.0 * (c_p_f * (s_p_f * z58)) + s60 - z62,
            # (I.2.15)
            z21,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z73 - z74,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -(2.0 * (c_p_b * (s_p_b * z69)) + s_p_b * (c_p_f * z75) + z74),
            # (I.2.15)
            z73 - (2.0 * (c_p_f * (s_p_f * z69)) + s_p_f * (c_p_b * z75)),
            # (I.2.15)
            -z12,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            1.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z29 * z231 - (z26 * z168 - z27 * z233 - z29 * z232),
            # (I.2.15)
            0.0,
            # (I.2.15)
            z26 * z239 - z27 * z254 - z29 * z253 - z29 * z252,
            # (I.2.15)
            z29 * z267 - (z26 * z258 - z27 * z269 - z29 * z268),
            # (I.2.15)
            z29 * z273 - (z26 * z270 - z27 * z275 - z29 * z274),
            # (I.2.15)
            0.0,
            # (I.2.15)
            z29 * z279 - (z26 * z276 - z27 * z281 - z29 * z280),
            # (I.2.15)
            z29 * z285 - (z26 * z282 - z27 * z287 - z29 * z286),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z233,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z254,
            # (I.2.15)
            z269,
            # (I.2.15)
            z275,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z281,
            # (I.2.15)
            z287,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z232,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z253,
            # (I.2.15)
            z268,
            # (I.2.15)
            z274,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z280,
            # (I.2.15)
            z286,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z231,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z252,
            # (I.2.15)
            z267,
            # (I.2.15)
            z273,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z279,
            # (I.2.15)
            z285,
        ]
        _finish("jacobian", J)
        return [J[k4 : k4 + 10] for k4 in range(0, 100, 10)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (10,), p (8,).
    Returns out (1,).
    """
    theta = float(y[2])  # heading of the board [rad]
    p_b = float(y[4])  # back axle, relative to the board [rad]
    p_f = float(y[5])  # front axle, relative to the board [rad]
    v = float(y[6])
    l = float(p[1])  # from the centre to an axle [m]
    try:
        # parameters only
        k1 = l * l
        k2 = abs(l)
        k3 = 2.0 + k2
        # state
        c_p_b = math.cos(p_b)
        c_p_f = math.cos(p_f)
        z1 = theta + p_b
        s1 = math.sin(z1)
        z2 = theta + p_f
        s2 = math.sin(z2)
        c1 = math.cos(z1)
        c2 = math.cos(z2)
        s_p_f = math.sin(p_f)
        s_p_b = math.sin(p_b)
        s3 = c_p_b * c_p_f * (2.0 * (s1 * s2) + 2.0 * (c1 * c2))
        z3 = s3 - (s_p_f * s_p_f - (2.0 - s_p_b * s_p_b))
        z4 = s2 * s2
        s4 = z4 + s1 * (s1 * (1.0 - 2.0 * z4) - 2.0 * (c2 * (c1 * s2)))
        z5 = k1 * z3 + s4
        s5 = (2.0 + 4.0 * k2) * k3
        # the coframe is singular
        if not abs(-z5) > 1e-12 * (k3 * s5):
            raise SingularModelError(1, "outputs")
        s_theta = math.sin(theta)
        c_theta = math.cos(theta)
        s6 = c_p_b * (s2 * s_theta + c2 * c_theta)
        z6 = l * v / z5 * (s6 + c_p_f * (s1 * s_theta + c1 * c_theta))
        out: list[float] = [
            # speed 32:10
            z6,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
