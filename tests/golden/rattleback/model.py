"""rattleback, emitted by nhc 0.1.0 (nhc:a6a63e6e2900aa36).

A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt,
    wobblestone).
Source: rattleback.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: quasi-velocities of the spec

State y:
y[0] = x [cm]: centre of mass
y[1] = y [cm]: centre of mass
y[2] = z [cm]: centre of mass, downwards
y[3] = alpha [rad]: roll about the long axis
y[4] = beta [rad]: pitch
y[5] = gamma [rad]: heading
y[6] = w1
y[7] = w2
y[8] = w3

Parameters p:
p[0]: a = 20.0 [cm]: half axis 1 of the ellipsoid
p[1]: b = 3.0 [cm]: half axis 2
p[2]: c = 2.0 [cm]: half axis 3
p[3]: h = 1.0 [cm]: from the centre of the ellipsoid down to the centre of mass
p[4]: I_a = 2.0 [cm^2]
p[5]: I_b = 16.0 [cm^2]
p[6]: I_c = 17.0 [cm^2]
p[7]: I_d = -0.2 [cm^2]: product of inertia, what makes it a rattleback
p[8]: g = 981.0 [cm/s^2]: acceleration of gravity

Constraints:
0: roll_x
1: roll_y
2: roll_z

Outputs:
out[0] = spin

Operations:
rhs: 81 +-, 142 *, 5 /, 7 calls
velocities: 17 +-, 46 *, 2 /, 7 calls
accelerations: 124 +-, 193 *, 6 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 103 +-, 178 *, 5 /, 7 calls
energy: 25 +-, 60 *, 2 /, 7 calls
jacobian: 521 +-, 740 *, 7 /, 7 calls
outputs: 0 +-, 0 *, 0 /, 1 calls

A singular point raises SingularModelError.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "z", "alpha", "beta", "gamma")
STATE: tuple[str, ...] = ("x", "y", "z", "alpha", "beta", "gamma", "w1", "w2", "w3")
PARAMETERS: tuple[str, ...] = ("a", "b", "c", "h", "I_a", "I_b", "I_c", "I_d", "g")
CONSTRAINTS: tuple[str, ...] = ("roll_x", "roll_y", "roll_z")
OUTPUTS: tuple[str, ...] = ("spin",)
DEFAULTS: tuple[float, ...] = (20.0, 3.0, 2.0, 1.0, 2.0, 16.0, 17.0, -0.2, 981.0)

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

    Arguments: t (scalar), y (9,), p (9,).
    Returns dydt (9,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    I_a = float(p[4])  # [cm^2]
    I_b = float(p[5])  # [cm^2]
    I_c = float(p[6])  # [cm^2]
    I_d = float(p[7])  # product of inertia, what makes it a rattleback [cm^2]
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "rhs")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z3 = 1.0 / math.sqrt(z2)
        z4 = mu3 * k3
        r3 = h - z3 * z4
        z5 = r3 * r3
        z6 = mu2 * k2
        z7 = z3 * z6
        z8 = z7 * z7
        z9 = I_a + (z5 + z8)
        # the mass matrix is singular
        if not abs(z9) > 0.0:
            raise SingularModelError(2, "rhs")
        z10 = z1 * k1
        r1 = z10 * z3
        z11 = r1 * r1
        z12 = I_b + (z5 + z11)
        z13 = I_d + r1 * z7
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "rhs")
        z17 = I_c + (z8 + z11)
        z18 = r1 * r3
        z19 = z18 * z14
        z20 = z7 * r3 + z13 * z19
        z21 = 1.0 / z16
        z22 = z20 * z21
        z23 = z17 - z18 * z19 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z17:
            raise SingularModelError(2, "rhs")
        s_gamma = math.sin(gamma)
        z24 = s_beta * w1 - c_beta * w3
        z25 = 1.0 / c_alpha
        z26 = z1 * w3 + mu3 * w1
        z27 = z25 * z26
        z28 = s_beta * z24 + c_beta * z27
        z29 = c_beta * z24 - s_beta * z27
        z30 = r3 * z28 + r1 * z29
        u1 = r3 * w2 - z7 * z29
        z31 = r1 * w2 + z7 * z28
        z32 = s_beta * u1 + c_beta * z31
        z33 = c_alpha * z30 - mu2 * z32
        c_gamma = math.cos(gamma)
        z34 = s_beta * z31 - c_beta * u1
        z35 = z25 * z24
        z36 = w2 + mu2 * z35
        z37 = I_c * z29
        z38 = c_beta * z36
        z39 = s_beta * z36
        z40 = z27 * z39
        z41 = mu2 * z27
        z42 = s_beta * z41 - c_alpha * z38
        z43 = z40 + z35 * z42
        z44 = z27 * z38
        z45 = c_alpha * z39 + c_beta * z41
        z46 = z44 + z35 * z45
        z47 = s_beta * z43 + c_beta * z46 - z35 * z41
        z48 = z25 * (z1 * z46 - mu3 * z43)
        z49 = z24 * z38 + s_beta * z47 - (z40 + c_beta * z48)
        z50 = I_d * z28 + I_b * w2
        z51 = z27 * z50
        z52 = z24 * z50
        z53 = (z10 * z42 - z6 * z26 + z4 * z45) * (z3 * (z3 * z3))
        z54 = z31 + (z4 * z53 - k3 * (z3 * z45))
        z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48)
        z56 = u1 - (k1 * (z3 * z42) - z10 * z53)
        z57 = z28 * z54 - (r3 * z49 + (g * mu2 - r1 * z55) + z29 * z56)
        z58 = z30 + (z6 * z53 + k2 * (z3 * z26))
        z59 = w2 * z56 + (g * mu3 + z7 * z49 + z28 * z58)
        s1 = s_beta * z51 - (c_beta * z52 - (r3 * z57 - z7 * z59))
        z60 = w2 * z37 - (I_a * z49 - s1)
        z61 = I_d * w2 + I_a * z28
        z62 = w2 * z54 - (g * z1 + z7 * z55 - z29 * z58)
        s2 = I_d * z49 - (z29 * z61 - z28 * z37 + (r3 * z62 - r1 * z59))
        z63 = s2 + z15 * z60
        s3 = c_beta * z51 + (s_beta * z52 - (z7 * z62 - r1 * z57))
        z64 = w2 * z61 - (I_c * z55 + s3)
        z65 = (z64 + z19 * z60 + z22 * z63) / z23
        z66 = z21 * z63 + z22 * z65
        dydt: list[float] = [
            # x' (I.2.15)
            s_gamma * z33 - c_gamma * z34,
            # y' (I.2.15)
            -(s_gamma * z34 + c_gamma * z33),
            # z' (I.2.15)
            -(mu2 * z30 + c_alpha * z32),
            # alpha' (I.2.15)
            z27,
            # beta' (I.2.15)
            z36,
            # gamma' (I.2.15)
            -z35,
            # w1' (I.2.15) 41:4
            z14 * z60 + z15 * z66 + z19 * z65,
            # w2' (I.2.15) 41:4
            -z66,
            # w3' (I.2.15) 41:4
            z65,
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

    Arguments: t (scalar), y (9,), p (9,).
    Returns qdot (6,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "velocities")
        s_gamma = math.sin(gamma)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r3 = h - z2 * (mu3 * k3)
        z3 = s_beta * w1 - c_beta * w3
        z4 = 1.0 / c_alpha
        z5 = z4 * (z1 * w3 + mu3 * w1)
        z6 = s_beta * z3 + c_beta * z5
        r1 = z1 * k1 * z2
        z7 = c_beta * z3 - s_beta * z5
        z8 = r3 * z6 + r1 * z7
        z9 = z2 * (mu2 * k2)
        u1 = r3 * w2 - z9 * z7
        z10 = r1 * w2 + z9 * z6
        z11 = s_beta * u1 + c_beta * z10
        z12 = c_alpha * z8 - mu2 * z11
        c_gamma = math.cos(gamma)
        z13 = s_beta * z10 - c_beta * u1
        z14 = z4 * z3
        qdot: list[float] = [
            # x' (I.2.4)
            s_gamma * z12 - c_gamma * z13,
            # y' (I.2.4)
            -(s_gamma * z13 + c_gamma * z12),
            # z' (I.2.4)
            -(mu2 * z8 + c_alpha * z11),
            # alpha' (I.2.4)
            z5,
            # beta' (I.2.4)
            w2 + mu2 * z14,
            # gamma' (I.2.4)
            -z14,
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

    Arguments: t (scalar), y (9,), p (9,).
    Returns qddot (6,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    I_a = float(p[4])  # [cm^2]
    I_b = float(p[5])  # [cm^2]
    I_c = float(p[6])  # [cm^2]
    I_d = float(p[7])  # product of inertia, what makes it a rattleback [cm^2]
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "accelerations")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z3 = 1.0 / math.sqrt(z2)
        z4 = mu3 * k3
        r3 = h - z3 * z4
        z5 = r3 * r3
        z6 = mu2 * k2
        z7 = z3 * z6
        z8 = z7 * z7
        z9 = I_a + (z5 + z8)
        # the mass matrix is singular
        if not abs(z9) > 0.0:
            raise SingularModelError(2, "accelerations")
        z10 = z1 * k1
        r1 = z10 * z3
        z11 = r1 * r1
        z12 = I_b + (z5 + z11)
        z13 = I_d + r1 * z7
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "accelerations")
        z17 = I_c + (z8 + z11)
        z18 = r1 * r3
        z19 = z18 * z14
        z20 = z7 * r3 + z13 * z19
        z21 = 1.0 / z16
        z22 = z20 * z21
        z23 = z17 - z18 * z19 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z17:
            raise SingularModelError(2, "accelerations")
        z24 = s_beta * w1 - c_beta * w3
        z25 = 1.0 / c_alpha
        z26 = z1 * w3 + mu3 * w1
        z27 = z25 * z26
        z28 = s_beta * z24 + c_beta * z27
        z29 = c_beta * z24 - s_beta * z27
        z30 = r3 * z28 + r1 * z29
        u1 = r3 * w2 - z7 * z29
        z31 = r1 * w2 + z7 * z28
        z32 = s_beta * u1 + c_beta * z31
        z33 = c_alpha * z30 - mu2 * z32
        c_gamma = math.cos(gamma)
        z34 = z25 * z24
        z35 = c_gamma * z34
        s_gamma = math.sin(gamma)
        z36 = mu2 * z27
        z37 = w2 + mu2 * z34
        z38 = c_beta * z37
        z39 = s_beta * z36 - c_alpha * z38
        z40 = s_beta * z37
        z41 = c_alpha * z40 + c_beta * z36
        z42 = (z10 * z39 - z6 * z26 + z4 * z41) * (z3 * (z3 * z3))
        z43 = z4 * z42 - k3 * (z3 * z41)
        z44 = z28 * z43
        z45 = z24 * z38
        z46 = I_c * z29
        z47 = z27 * z40
        z48 = z47 + z34 * z39
        z49 = z27 * z38
        z50 = z49 + z34 * z41
        z51 = s_beta * z48 + c_beta * z50 - z34 * z36
        z52 = z25 * (z1 * z50 - mu3 * z48)
        z53 = z45 + s_beta * z51 - (z47 + c_beta * z52)
        z54 = I_d * z28 + I_b * w2
        z55 = z27 * z54
        z56 = z24 * z54
        z57 = z24 * z40
        z58 = z57 - c_beta * z51 + (z49 - s_beta * z52)
        z59 = k1 * (z3 * z39) - z10 * z42
        z60 = z29 * z59
        s1 = z29 * u1 - z28 * z31 + (r3 * z53 - z44 - (r1 * z58 + z60))
        z61 = g * mu2 + s1
        z62 = z6 * z42 + k2 * (z3 * z26)
        z63 = z28 * z62
        z64 = w2 * z59
        z65 = g * mu3 + (z28 * z30 + w2 * u1 + (z7 * z53 + z63 - z64))
        s2 = s_beta * z55 - (c_beta * z56 + (r3 * z61 + z7 * z65))
        z66 = w2 * z46 - (I_a * z53 - s2)
        z67 = I_d * w2 + I_a * z28
        z68 = z29 * z62
        z69 = w2 * z43
        z70 = g * z1 - (w2 * z31 + z29 * z30 - (z7 * z58 - z68 - z69))
        s3 = I_d * z53 - (z29 * z67 - z28 * z46 - (r3 * z70 + r1 * z65))
        z71 = s3 + z15 * z66
        s4 = c_beta * z55 + (s_beta * z56 + (z7 * z70 - r1 * z61))
        z72 = w2 * z67 - (I_c * z58 + s4)
        z73 = (z72 + z19 * z66 + z22 * z71) / z23
        z74 = z21 * z71 + z22 * z73
        z75 = z14 * z66 + z15 * z74 + z19 * z73
        z76 = w1 * z38 + s_beta * z75 + (w3 * z40 - c_beta * z73)
        z77 = z36 / (c_alpha * c_alpha)
        s5 = z25 * (w3 * z39 - z1 * z73 + (w1 * z41 - mu3 * z75))
        z78 = z26 * z77 - s5
        z79 = z45 + s_beta * z76 - (z47 - c_beta * z78)
        z80 = z57 - c_beta * z76 + (z49 + s_beta * z78)
        z81 = z44 - r3 * z79 + (z60 + r1 * z80)
        z82 = z69 + r3 * z74 + (z68 - z7 * z80)
        z83 = z64 + r1 * z74 - (z63 + z7 * z79)
        z84 = u1 * z38 - s_beta * z82 - (z31 * z40 + c_beta * z83)
        z85 = z30 * z36 + c_alpha * z81 + (z26 * z32 + mu2 * z84)
        z86 = s_beta * z31 - c_beta * u1
        z87 = s_gamma * z34
        z88 = z31 * z38 - s_beta * z83 + (u1 * z40 + c_beta * z82)
        z89 = z24 * z77 + z25 * z76
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z33 * z35 + s_gamma * z85 + (z86 * z87 + c_gamma * z88)),
            # y'' (I.2.15)
            z86 * z35 - s_gamma * z88 - (z33 * z87 - c_gamma * z85),
            # z'' (I.2.15)
            z32 * z36 - c_alpha * z84 - (z26 * z30 - mu2 * z81),
            # alpha'' (I.2.15)
            z78,
            # beta'' (I.2.15)
            z26 * z34 + mu2 * z89 - z74,
            # gamma'' (I.2.15)
            -z89,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (9,).
    Returns y (9,).
    """
    x = float(q[0])  # centre of mass [cm]
    y_2 = float(q[1])  # centre of mass [cm]
    z = float(q[2])  # centre of mass, downwards [cm]
    alpha = float(q[3])  # roll about the long axis [rad]
    beta = float(q[4])  # pitch [rad]
    gamma = float(q[5])  # heading [rad]
    alpha_dot = float(qdot[3])
    beta_dot = float(qdot[4])
    gamma_dot = float(qdot[5])
    try:
        # state
        c_beta = math.cos(beta)
        s_beta = math.sin(beta)
        c_alpha = math.cos(alpha)
        z1 = gamma_dot * c_alpha
        mu2 = math.sin(alpha)
        y: list[float] = [
            x,
            y_2,
            z,
            alpha,
            beta,
            gamma,
            alpha_dot * c_beta - s_beta * z1,
            beta_dot + gamma_dot * mu2,
            alpha_dot * s_beta + c_beta * z1,
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

    Arguments: t (scalar), q (6,), qdot (6,), p (9,).
    Returns r (3,).
    """
    alpha = float(q[3])  # roll about the long axis [rad]
    beta = float(q[4])  # pitch [rad]
    gamma = float(q[5])  # heading [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    z_dot = float(qdot[2])
    alpha_dot = float(qdot[3])
    beta_dot = float(qdot[4])
    gamma_dot = float(qdot[5])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        c_beta = math.cos(beta)
        mu2 = math.sin(alpha)
        omega2 = beta_dot + gamma_dot * mu2
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r3 = h - z2 * (mu3 * k3)
        omega3 = alpha_dot * s_beta + gamma_dot * mu3
        z3 = z2 * (mu2 * k2)
        u1 = omega2 * r3 + omega3 * z3
        omega1 = alpha_dot * c_beta - gamma_dot * z1
        r1 = z1 * k1 * z2
        z4 = omega1 * z3 + omega2 * r1
        v1 = c_beta * u1 - s_beta * z4
        c_gamma = math.cos(gamma)
        u2 = omega3 * r1 - omega1 * r3
        z5 = s_beta * u1 + c_beta * z4
        e2 = c_alpha * u2 + mu2 * z5
        s_gamma = math.sin(gamma)
        r: list[float] = [
            # roll_x = 0 (I.1.1) 44:5
            x_dot - v1 * c_gamma + e2 * s_gamma,
            # roll_y = 0 (I.1.1) 45:5
            y_dot - v1 * s_gamma - e2 * c_gamma,
            # roll_z = 0 (I.1.1) 46:5
            z_dot - (mu2 * u2 - c_alpha * z5),
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

    Arguments: t (scalar), y (9,), p (9,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    I_a = float(p[4])  # [cm^2]
    I_b = float(p[5])  # [cm^2]
    I_c = float(p[6])  # [cm^2]
    I_d = float(p[7])  # product of inertia, what makes it a rattleback [cm^2]
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "reactions")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z3 = 1.0 / math.sqrt(z2)
        z4 = mu3 * k3
        r3 = h - z3 * z4
        z5 = r3 * r3
        z6 = mu2 * k2
        z7 = z3 * z6
        z8 = z7 * z7
        z9 = I_a + (z5 + z8)
        # the mass matrix is singular
        if not abs(z9) > 0.0:
            raise SingularModelError(2, "reactions")
        z10 = z1 * k1
        r1 = z10 * z3
        z11 = r1 * r1
        z12 = I_b + (z5 + z11)
        z13 = I_d + r1 * z7
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "reactions")
        z17 = I_c + (z8 + z11)
        z18 = r1 * r3
        z19 = z18 * z14
        z20 = z7 * r3 + z13 * z19
        z21 = 1.0 / z16
        z22 = z20 * z21
        z23 = z17 - z18 * z19 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z17:
            raise SingularModelError(2, "reactions")
        z24 = s_beta * w1 - c_beta * w3
        z25 = 1.0 / c_alpha
        z26 = z1 * w3 + mu3 * w1
        z27 = z25 * z26
        z28 = c_beta * z24 - s_beta * z27
        z29 = mu2 * z27
        z30 = z25 * z24
        z31 = w2 + mu2 * z30
        z32 = c_beta * z31
        z33 = s_beta * z29 - c_alpha * z32
        z34 = s_beta * z31
        z35 = c_alpha * z34 + c_beta * z29
        z36 = (z10 * z33 - z6 * z26 + z4 * z35) * (z3 * (z3 * z3))
        z37 = r3 * w2 - z7 * z28 - (k1 * (z3 * z33) - z10 * z36)
        z38 = z27 * z34
        z39 = z38 + z30 * z33
        z40 = z27 * z32
        z41 = z40 + z30 * z35
        z42 = s_beta * z39 + c_beta * z41 - z30 * z29
        z43 = z25 * (z1 * z41 - mu3 * z39)
        z44 = z24 * z32 + s_beta * z42 - (z38 + c_beta * z43)
        z45 = s_beta * z24 + c_beta * z27
        z46 = r3 * z45 + r1 * z28 + (z6 * z36 + k2 * (z3 * z26))
        z47 = w2 * z37 + (g * mu3 + z7 * z44 + z45 * z46)
        s_gamma = math.sin(gamma)
        z48 = mu2 * s_gamma
        c_gamma = math.cos(gamma)
        z49 = c_beta * z48 + s_beta * c_gamma
        z50 = r1 * w2 + z7 * z45 + (z4 * z36 - k3 * (z3 * z35))
        z51 = z24 * z34 - c_beta * z42 + (z40 - s_beta * z43)
        z52 = w2 * z50 - (g * z1 + z7 * z51 - z28 * z46)
        z53 = c_beta * c_gamma - s_beta * z48
        z54 = z45 * z50 - (r3 * z44 + (g * mu2 - r1 * z51) + z28 * z37)
        z55 = c_alpha * s_gamma
        z56 = I_d * w2 + I_a * z45
        z57 = I_d * z45 + I_b * w2
        z58 = z27 * z57
        z59 = z24 * z57
        s1 = c_beta * z58 + (s_beta * z59 - (z7 * z52 - r1 * z54))
        z60 = w2 * z56 - (I_c * z51 + s1)
        z61 = I_c * z28
        s2 = s_beta * z58 - (c_beta * z59 - (r3 * z54 - z7 * z47))
        z62 = w2 * z61 - (I_a * z44 - s2)
        s3 = I_d * z44 - (z28 * z56 - z45 * z61 + (r3 * z52 - r1 * z47))
        z63 = s3 + z15 * z62
        z64 = (z60 + z19 * z62 + z22 * z63) / z23
        z65 = z21 * z63 + z22 * z64
        z66 = z14 * z62 + z15 * z65 + z19 * z64
        s4 = z66 * (r3 * z55 - z7 * z49) - z65 * (r3 * z53 - r1 * z49)
        z67 = z64 * (z7 * z53 - r1 * z55) + s4
        z68 = mu2 * c_gamma
        z69 = c_beta * z68 - s_beta * s_gamma
        z70 = c_beta * s_gamma + s_beta * z68
        z71 = c_alpha * c_gamma
        s5 = z66 * (r3 * z71 - z7 * z69) + z65 * (r3 * z70 + r1 * z69)
        z72 = z64 * (z7 * z70 + r1 * z71) - s5
        s6 = z66 * (mu2 * r3 + mu3 * z7) - z65 * (z1 * r3 + mu3 * r1)
        z73 = z64 * (mu2 * r1 - z1 * z7) - s6
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z67 - (z47 * z49 + (z52 * z53 + z54 * z55)),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z47 * z69 - (z52 * z70 - z54 * z71) + z72,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z73 - (mu3 * z47 - (z1 * z52 + mu2 * z54)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (9,), p (9,).
    Returns a scalar.
    """
    z = float(y[2])  # centre of mass, downwards [cm]
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    I_a = float(p[4])  # [cm^2]
    I_b = float(p[5])  # [cm^2]
    I_c = float(p[6])  # [cm^2]
    I_d = float(p[7])  # product of inertia, what makes it a rattleback [cm^2]
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        s_gamma = math.sin(gamma)
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r3 = h - z2 * (mu3 * k3)
        z3 = s_beta * w1 - c_beta * w3
        z4 = 1.0 / c_alpha
        z5 = z4 * (z1 * w3 + mu3 * w1)
        z6 = c_beta * z5
        z7 = s_beta * z3 + z6
        r1 = z1 * k1 * z2
        z8 = s_beta * z5
        z9 = c_beta * z3 - z8
        z10 = r3 * z7 + r1 * z9
        z11 = z2 * (mu2 * k2)
        u1 = r3 * w2 - z11 * z9
        z12 = r1 * w2 + z11 * z7
        z13 = s_beta * u1 + c_beta * z12
        z14 = c_alpha * z10 - mu2 * z13
        c_gamma = math.cos(gamma)
        z15 = s_beta * z12 - c_beta * u1
        z16 = s_gamma * z14 - c_gamma * z15
        z17 = s_gamma * z15 + c_gamma * z14
        z18 = mu2 * z10 + c_alpha * z13
        z19 = z4 * z3
        omega1 = z6 + z1 * z19
        omega3 = z8 - mu3 * z19
        s2 = I_a * (omega1 * omega1) + I_b * (w2 * w2)
        s3 = z16 * z16 + z17 * z17 + z18 * z18
        z20 = s3 + (s2 + I_c * (omega3 * omega3))
        value1 = 0.5 * z20 + w2 * (I_d * omega1) - z * g
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (9,), p (9,).
    Returns rows (9, 9): d rhs_i / d y_j stands at [i][j].
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])
    w2 = float(y[7])
    w3 = float(y[8])
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    I_a = float(p[4])  # [cm^2]
    I_b = float(p[5])  # [cm^2]
    I_c = float(p[6])  # [cm^2]
    I_d = float(p[7])  # product of inertia, what makes it a rattleback [cm^2]
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        k4 = k1 - k3
        k5 = I_b - I_c
        k6 = I_a - I_c
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "jacobian")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z2 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z3 = 1.0 / math.sqrt(z2)
        z4 = mu3 * k3
        r3 = h - z3 * z4
        z5 = r3 * r3
        z6 = mu2 * k2
        z7 = z3 * z6
        z8 = z7 * z7
        z9 = I_a + (z5 + z8)
        # the mass matrix is singular
        if not abs(z9) > 0.0:
            raise SingularModelError(2, "jacobian")
        z10 = z1 * k1
        r1 = z10 * z3
        z11 = r1 * r1
        z12 = I_b + (z5 + z11)
        z13 = I_d + r1 * z7
        z14 = 1.0 / z9
        z15 = z13 * z14
        z16 = z12 - z13 * z15
        # the mass matrix is singular
        if not abs(z16) > 1e-14 * z12:
            raise SingularModelError(2, "jacobian")
        z17 = I_c + (z8 + z11)
        z18 = r1 * r3
        z19 = z18 * z14
        z20 = z7 * r3
        z21 = z20 + z13 * z19
        z22 = 1.0 / z16
        z23 = z21 * z22
        z24 = z17 - z18 * z19 - z21 * z23
        # the mass matrix is singular
        if not abs(z24) > 1e-14 * z17:
            raise SingularModelError(2, "jacobian")
        c_gamma = math.cos(gamma)
        z25 = s_beta * mu2
        z26 = k1 * z3
        z27 = z3 * z3
        z28 = z3 * z27
        z29 = c_beta * mu2
        z30 = z28 * (z10 * z25 - c_alpha * z6 + z4 * z29)
        z31 = z25 * z26 - z10 * z30
        z32 = z1 * w3 + mu3 * w1
        z33 = 1.0 / (c_alpha * c_alpha)
        z34 = mu2 * z33
        z35 = 1.0 / c_alpha
        z36 = z32 * z34 - z35 * (w3 * z25 + w1 * z29)
        z37 = c_beta * z36
        z38 = s_beta * w1 - c_beta * w3
        z39 = s_beta * z38
        z40 = z35 * z32
        z41 = c_beta * z40
        z42 = z39 + z41
        z43 = k2 * z3
        z44 = z6 * z30 + c_alpha * z43
        z45 = w2 * z31 - (z7 * z37 + z42 * z44)
        z46 = k3 * z3
        z47 = z4 * z30 - z29 * z46
        z48 = s_beta * z36
        z49 = c_beta * z38
        z50 = s_beta * z40
        z51 = z49 - z50
        z52 = w2 * z47 - (z7 * z48 - z51 * z44)
        z53 = s_beta * z45 - c_beta * z52
        s_gamma = math.sin(gamma)
        z54 = r3 * w2
        z55 = z7 * z51
        u1 = z54 - z55
        z56 = s_beta * u1
        z57 = r1 * w2
        z58 = z7 * z42
        z59 = z57 + z58
        z60 = c_beta * z59
        z61 = z56 + z60
        z62 = r3 * z37 - z42 * z47 - (r1 * z48 + z51 * z31)
        z63 = r3 * z42
        z64 = r1 * z51
        z65 = z63 + z64
        z66 = s_beta * z52 + c_beta * z45
        z67 = c_alpha * (z61 - z62) + mu2 * (z65 - z66)
        z68 = c_beta * w1 + s_beta * w3
        z69 = z35 * (mu3 * w3 - z1 * w1)
        z70 = z49 + s_beta * z68 - (z50 - c_beta * z69)
        z71 = k4 * (mu3 * (z1 * z28))
        z72 = z4 * z71 + z1 * z46
        z73 = z39 - c_beta * z68 + (z41 + s_beta * z69)
        z74 = mu3 * z26 - z10 * z71
        z75 = r3 * z70 + z42 * z72 - (r1 * z73 - z51 * z74)
        z76 = c_beta * u1
        z77 = z6 * z71
        z78 = w2 * z72 + (z7 * z73 + z51 * z77)
        z79 = s_beta * z59
        z80 = w2 * z74 + (z7 * z70 - z42 * z77)
        z81 = z76 + s_beta * z78 - (z79 - c_beta * z80)
        z82 = c_alpha * z75 - mu2 * z81
        z83 = z60 + s_beta * z80 + (z56 - c_beta * z78)
        z84 = z79 - z76
        z85 = c_alpha * z65
        z86 = mu2 * z61
        z87 = z85 - z86
        z88 = c_beta * z7
        z89 = mu2 * z88 - c_alpha * r3
        z90 = s_beta * z7
        z91 = s_beta * r3 + c_beta * r1
        z92 = mu2 * z91
        z93 = s_beta * r1 - c_beta * r3
        z94 = mu2 * z90 + c_alpha * r1
        z95 = z38 * z34
        z96 = z35 * z68
        z97 = s_beta * z35
        z98 = c_beta * z35
        z99 = g * r3
        z100 = z7 * w2
        z101 = r3 * z51
        z102 = z100 + z101
        z103 = z4 * z63 - z6 * z58 - z10 * z102
        z104 = z27 * z103
        z105 = z3 * z104
        z106 = k2 * z105
        z107 = z35 * z38
        z108 = z8 + (I_a + z5)
        z109 = c_beta * z18
        z110 = s_beta * z108 + z109
        z111 = s_beta * z18
        z112 = c_beta * z108 - z111
        z113 = z35 * z112
        z114 = c_beta * z110 - z1 * z113
        z115 = k3 * z105
        z116 = z107 * z114 - (mu3 * z115 - z63 * z46)
        z117 = s_beta * z110 + mu3 * z113
        z118 = k1 * z105
        z119 = z107 * z117 - (z1 * z118 + z102 * z26)
        z120 = z107 * z110 - c_beta * z116 - s_beta * z119
        z121 = z18 - z114
        z122 = z38 * z108 - z40 * z121 - c_alpha * z119
        z123 = z38 * z18
        z124 = z108 - z117
        z125 = z123 + z40 * z124 - c_alpha * z116
        z126 = c_beta * z122 - s_beta * z125
        z127 = mu2 * z40
        z128 = w2 + mu2 * z107
        z129 = c_beta * z128
        z130 = s_beta * z127 - c_alpha * z129
        z131 = s_beta * z128
        z132 = c_alpha * z131 + c_beta * z127
        z133 = z10 * z130 - z6 * z32 + z4 * z132
        z134 = z3 * z133
        z135 = z27 * z134
        z136 = z40 * z131
        z137 = z136 + z107 * z130
        z138 = z40 * z129
        z139 = z138 + z107 * z132
        z140 = s_beta * z137 + c_beta * z139 - z107 * z127
        z141 = z1 * z139 - mu3 * z137
        z142 = z35 * z141
        z143 = z38 * z129 + s_beta * z140 - (z136 + c_beta * z142)
        z144 = z7 * z143
        z145 = k1 * z130
        z146 = z3 * z145 - z10 * z135
        z147 = u1 - z146
        z148 = k2 * z32
        z149 = z3 * z148 + z6 * z135
        z150 = z65 + z149
        z151 = w2 * z147 + (g * mu3 + z144 + z42 * z150)
        z152 = I_d * w2
        z153 = z152 + I_a * z42
        z154 = I_c * z51
        z155 = k3 * z132
        z156 = z3 * z155 - z4 * z135
        z157 = z59 - z156
        z158 = z38 * z131 - c_beta * z140 + (z138 - s_beta * z142)
        z159 = z7 * z158
        z160 = w2 * z157 - (g * z1 + z159 - z51 * z150)
        z161 = I_d * z42
        z162 = z161 + I_b * w2
        z163 = z40 * z162
        z164 = z38 * z162
        z165 = r3 * z143
        z166 = r1 * z158
        z167 = z42 * z157 - (z165 + (g * mu2 - z166) + z51 * z147)
        s1 = s_beta * z163 - (c_beta * z164 - (r3 * z167 - z7 * z151))
        z168 = w2 * z154 - (I_a * z143 - s1)
        s2 = z51 * z153 - z42 * z154 + (r3 * z160 - r1 * z151)
        z169 = I_d * z143 - s2 + z15 * z168
        z170 = 1.0 / z24
        s3 = c_beta * z163 + (s_beta * z164 - (z7 * z160 - r1 * z167))
        z171 = w2 * z153 - (I_c * z158 + s3)
        z172 = z170 * (z171 + z19 * z168 + z23 * z169)
        z173 = z22 * z169 + z23 * z172
        z174 = r1 * z173
        z175 = z14 * z168 + z15 * z173 + z19 * z172
        z176 = z7 * z175
        z177 = z51 * z102 + (z42 * z63 - (z144 + (z151 - z174 + 2.0 * z176)))
        s4 = z99 + (z32 * z106 - z40 * z120 + z107 * z126)
        z178 = s4 + k2 * (z58 * z135 - z3 * z177)
        z179 = z134 / (z2 * z2)
        z180 = r1 * z172
        z181 = r3 * z175
        z182 = w2 * z102 + (z42 * z58 + (z165 - (z167 + z180 - 2.0 * z181)))
        s5 = z63 * z155 + z58 * z148 - z145 * z102 - z133 * z104
        z183 = s5 - z4 * z182 - z6 * z177
        z184 = r3 * z158
        z185 = r3 * z172
        z186 = z7 * z173
        z187 = w2 * z63 - (z51 * z58 - (z184 + (z185 + z186)))
        z188 = z103 * z179 - 0.5 * (z28 * (z183 - z10 * z187))
        z189 = z127 * z110 - z130 * z117 - z132 * z114 - mu2 * z126
        z190 = s_beta * z162
        z191 = I_d * z51
        z192 = z7 * z65
        z193 = r3 * z59
        z194 = r3 * z156
        z195 = z7 * z149
        z196 = z7 * z63 - (r3 * z58 + (z191 + z192 - z193 + z194 + z195))
        z197 = r1 * z58 - (I_c * w2 + z7 * z102) + r3 * z147
        s6 = z190 + z131 * z124 + z129 * z121 + mu2 * z120
        z198 = s6 + c_beta * z196 + s_beta * z197
        z199 = g * z7
        z200 = mu2 * z106 + z58 * z43 - z35 * z198
        s7 = k3 * (z63 * z135 + (z3 * z182 - 2.0 * (mu3 * z188)))
        z201 = s7 + (z132 * z115 - (z137 * z113 + (z199 + w1 * z200)))
        s8 = z33 * (z141 * z112 + z38 * z189 + z32 * z198)
        z202 = z131 * z116 - z129 * z119 + s8 - c_beta * z201
        s9 = k1 * (z102 * z135 - (z3 * z187 - 2.0 * (z1 * z188)))
        z203 = s9 - (z130 * z118 + (z139 * z113 - w3 * z200))
        s10 = c_alpha * (z178 + 2.0 * (z6 * z188))
        z204 = s10 - mu2 * (z202 + s_beta * z203)
        z205 = r1 * z42
        z206 = z101 - z205
        z207 = z4 * z54 + z6 * z206 - z10 * z57
        z208 = z27 * z207
        z209 = z3 * z208
        z210 = k2 * z209
        z211 = s_beta * z13 - c_beta * z20
        z212 = c_beta * z13 + s_beta * z20
        z213 = z35 * z212
        z214 = c_beta * z211 - z1 * z213
        z215 = k3 * z209
        z216 = z107 * z214 - (mu3 * z215 - z54 * z46)
        z217 = s_beta * z211 + mu3 * z213
        z218 = k1 * z209
        z219 = z107 * z217 - (z1 * z218 + z57 * z26)
        z220 = z107 * z211 - c_beta * z216 - s_beta * z219
        z221 = z20 + z214
        z222 = z38 * z13 + z40 * z221 - c_alpha * z219
        z223 = z13 - z217
        z224 = z38 * z20 - z40 * z223 + c_alpha * z216
        z225 = c_beta * z222 + s_beta * z224
        z226 = r1 * z143
        z227 = r1 * z175
        z228 = z57 * z51 + (z54 * z42 - (z184 + (z226 + (z185 + z227))))
        z229 = r3 * z173
        z230 = z7 * z172
        z231 = w2 * z57 - (z42 * z206 + (2.0 * z229 + (z160 - z230)))
        s11 = z54 * z155 - z148 * z206 - z57 * z145 - z133 * z208
        z232 = s11 - z4 * z231 - z6 * z228
        z233 = w2 * z54 + (z51 * z206 - (z176 + (z151 - 2.0 * z174)))
        z234 = z207 * z179 - 0.5 * (z28 * (z232 - z10 * z233))
        s12 = z32 * z210 - z40 * z220 + z107 * z225
        z235 = s12 - k2 * (z206 * z135 + z3 * z228) + 2.0 * (z6 * z234)
        z236 = z127 * z211 - z130 * z217 - z132 * z214 - mu2 * z225
        z237 = z51 * k6 + (r3 * z206 + z7 * z54) - r1 * z150
        z238 = z153 + (r1 * z206 - (I_c * z42 - z7 * z57)) + r3 * z150
        s13 = z131 * z223 - z129 * z221 + mu2 * z220 + c_beta * z237
        z239 = s13 - s_beta * z238
        z240 = g * r1
        z241 = mu2 * z210 - z206 * z43 - z35 * z239
        s14 = k3 * (z54 * z135 + (z3 * z231 - 2.0 * (mu3 * z234)))
        z242 = s14 + (z132 * z215 - (z137 * z213 + (z240 + w1 * z241)))
        s15 = z33 * (z141 * z212 + z38 * z236 + z32 * z239)
        z243 = z131 * z216 - z129 * z219 + s15 - c_beta * z242
        s16 = k1 * (z57 * z135 - (z3 * z233 - 2.0 * (z1 * z234)))
        z244 = s16 + (z99 - (z130 * z218 + (z139 * z213 - w3 * z241)))
        z245 = c_alpha * z235 - mu2 * (z243 + s_beta * z244) - z15 * z204
        z246 = z100 - z205
        z247 = z4 * z246 + z6 * z55 + z10 * z64
        z248 = z27 * z247
        z249 = z3 * z248
        z250 = k2 * z249
        z251 = z8 + (I_c + z11)
        z252 = z111 + c_beta * z251
        z253 = z109 - s_beta * z251
        z254 = z35 * z253
        z255 = c_beta * z252 - z1 * z254
        z256 = k3 * z249
        z257 = z107 * z255 + (mu3 * z256 - z246 * z46)
        z258 = s_beta * z252 + mu3 * z254
        z259 = k1 * z249
        z260 = z107 * z258 + (z1 * z259 - z64 * z26)
        z261 = z107 * z252 - c_beta * z257 - s_beta * z260
        z262 = z251 - z255
        z263 = z123 - z40 * z262 - c_alpha * z260
        z264 = z18 - z258
        z265 = z38 * z251 + z40 * z264 - c_alpha * z257
        z266 = c_beta * z263 - s_beta * z265
        s17 = z42 * z246 - (z159 + (2.0 * z230 - (z160 + z229)))
        z267 = z51 * z64 - s17
        s18 = z240 - (z32 * z250 + z40 * z261 - z107 * z266)
        z268 = s18 + k2 * (z55 * z135 - z3 * z267)
        z269 = w2 * z64 + (z55 * z42 + (z226 + (z186 + z227)))
        s19 = z155 * z246 - z55 * z148 + z64 * z145 - z133 * z248
        z270 = s19 + z4 * z269 + z6 * z267
        s20 = z51 * z55 - (z166 - (z181 - (z167 + 2.0 * z180)))
        z271 = w2 * z246 + s20
        z272 = z247 * z179 - 0.5 * (z28 * (z270 - z10 * z271))
        z273 = z127 * z252 - z130 * z258 - z132 * z255 - mu2 * z266
        z274 = r1 * u1
        z275 = r1 * z146
        z276 = z7 * z64 - (r1 * z55 + (z195 + (z192 + z274 - z275)))
        z277 = c_beta * z162
        z278 = z161 - (r3 * z55 + (I_a * w2 + z7 * z246)) + r1 * z157
        s21 = z277 + z131 * z264 + z129 * z262 + mu2 * z261
        z279 = s_beta * z276 - (s21 + c_beta * z278)
        z280 = mu2 * z250 - z55 * z43 - z35 * z279
        s22 = k3 * (z246 * z135 - (z3 * z269 + 2.0 * (mu3 * z272)))
        z281 = s22 + (z132 * z256 + (z137 * z254 - w1 * z280))
        s23 = z33 * (z141 * z253 + z38 * z273 - z32 * z279)
        z282 = z131 * z257 - z129 * z260 + s23 + c_beta * z281
        s24 = k1 * (z64 * z135 + (z3 * z271 - 2.0 * (z1 * z272)))
        z283 = s24 - (z199 - (z130 * z259 - (z139 * z254 + w3 * z280)))
        s25 = c_alpha * (z268 - 2.0 * (z6 * z272))
        z284 = s25 - mu2 * (z282 + s_beta * z283) - z19 * z204 + z23 * z245
        z285 = z170 * z284
        z286 = z22 * z245 + z23 * z285
        z287 = z142 * z18
        s26 = z163 - z140 * z108 - z287 - z137 * z110 - z127 * z119
        z288 = s26 + z128 * z125 + z38 * z196
        s27 = z277 + z129 * z108 - z131 * z18 - s_beta * z196
        z289 = z35 * z189 - (s27 + c_beta * z197)
        z290 = z140 * z18
        s28 = z164 - z142 * z108 + z290 + z139 * z110 + z127 * z116
        z291 = s28 + z128 * z122 - z40 * z196
        s29 = c_beta * (z288 + z40 * z197 + w1 * z289 - c_alpha * z203)
        s30 = s_beta * (z291 + z38 * z197 + w3 * z289 - c_alpha * z201)
        z292 = s29 + s30
        s31 = z140 * z13 - z142 * z20 + z137 * z211 + z127 * z219
        z293 = s31 + z128 * z224 - z38 * z237
        s32 = z129 * z13 + z131 * z20 - s_beta * z237 - c_beta * z238
        z294 = z35 * z236 - s32
        s33 = z142 * z13 + z140 * z20 - z139 * z211 - z127 * z216
        z295 = s33 - z128 * z222 + z40 * z237
        s34 = c_beta * (z293 + z40 * z238 - w1 * z294 + c_alpha * z244)
        s35 = s_beta * (z295 + z38 * z238 - w3 * z294 + c_alpha * z242)
        z296 = s34 + s35
        z297 = z296 + z15 * z292
        s36 = z164 - z290 - z142 * z251 - z137 * z252 - z127 * z260
        z298 = s36 + z128 * z265 + z38 * z278
        s37 = z190 - z129 * z18 + z131 * z251 + s_beta * z278
        z299 = z35 * z273 + (c_beta * z276 + s37)
        s38 = z163 + z287 - z140 * z251 - z139 * z252 - z127 * z257
        z300 = s38 - z128 * z263 + z40 * z278
        s39 = c_beta * (z40 * z276 - z298 - w1 * z299 + c_alpha * z283)
        s40 = s_beta * (z38 * z276 + z300 - w3 * z299 - c_alpha * z281)
        z301 = s39 + s40
        z302 = z170 * (z301 + z19 * z292 + z23 * z297)
        z303 = z22 * z297 + z23 * z302
        z304 = s_beta * z289 - mu3 * z200
        z305 = s_beta * z294 - mu3 * z241 - z15 * z304
        z306 = z170 * (s_beta * z299 + mu3 * z280 - z19 * z304 + z23 * z305)
        z307 = z22 * z305 + z23 * z306
        z308 = z7 * z147 + (z51 * k5 - (r1 * z63 - r3 * z102 - z126))
        s41 = r1 * z54 - (z194 - (z193 + (z191 - z274) + z275) + z225)
        z309 = r3 * z57 - s41 - z15 * z308
        s42 = r3 * z64 - (z19 * z308 + (I_b * z42 - z23 * z309))
        z310 = z153 + (z266 + (r1 * z246 + s42))
        z311 = z170 * (z7 * z157 + (z152 + z310))
        z312 = z22 * z309 + z23 * z311
        z313 = c_beta * z289 + z1 * z200
        z314 = c_beta * z294 + z1 * z241 - z15 * z313
        z315 = z170 * (c_beta * z299 - z1 * z280 - z19 * z313 + z23 * z314)
        z316 = z22 * z314 + z23 * z315
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z53 - s_gamma * z67,
            # (I.2.15)
            s_gamma * z82 - c_gamma * z83,
            # (I.2.15)
            s_gamma * z84 + c_gamma * z87,
            # (I.2.15)
            -(s_gamma * z89 + c_gamma * z90),
            # (I.2.15)
            -(s_gamma * z92 + c_gamma * z93),
            # (I.2.15)
            c_gamma * z88 - s_gamma * z94,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_gamma * z53 + c_gamma * z67,
            # (I.2.15)
            -(s_gamma * z83 + c_gamma * z82),
            # (I.2.15)
            s_gamma * z87 - c_gamma * z84,
            # (I.2.15)
            c_gamma * z89 - s_gamma * z90,
            # (I.2.15)
            c_gamma * z92 - s_gamma * z93,
            # (I.2.15)
            s_gamma * z88 + c_gamma * z94,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z86 + c_alpha * z66 - (z85 + mu2 * z62),
            # (I.2.15)
            -(mu2 * z75 + c_alpha * z81),
            0.0,
            # (I.2.15)
            -(mu2 * r3 + c_alpha * z88),
            # (I.2.15)
            -c_alpha * z91,
            # (I.2.15)
            mu2 * r1 - c_alpha * z90,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z36,
            # (I.2.15)
            z69,
            0.0,
            # (I.2.15)
            c_beta,
            0.0,
            # (I.2.15)
            s_beta,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z38 + mu2 * z95,
            # (I.2.15)
            mu2 * z96,
            0.0,
            # (I.2.15)
            mu2 * z97,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -mu2 * z98,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z95,
            # (I.2.15)
            -z96,
            0.0,
            # (I.2.15)
            -z97,
            0.0,
            # (I.2.15)
            z98,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z19 * z285 - (z14 * z204 - z15 * z286),
            # (I.2.15)
            z14 * z292 + z15 * z303 + z19 * z302,
            0.0,
            # (I.2.15)
            z14 * z304 - z15 * z307 - z19 * z306,
            # (I.2.15)
            z19 * z311 - (z14 * z308 - z15 * z312),
            # (I.2.15)
            z19 * z315 - (z14 * z313 - z15 * z316),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z286,
            # (I.2.15)
            -z303,
            0.0,
            # (I.2.15)
            z307,
            # (I.2.15)
            -z312,
            # (I.2.15)
            -z316,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z285,
            # (I.2.15)
            z302,
            0.0,
            # (I.2.15)
            -z306,
            # (I.2.15)
            z311,
            # (I.2.15)
            z315,
        ]
        _finish("jacobian", J)
        return [J[k7 : k7 + 9] for k7 in range(0, 81, 9)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (9,), p (9,).
    Returns out (1,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    w3 = float(y[8])
    try:
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "outputs")
        out: list[float] = [
            # spin 53:9
            w3,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
