"""rattleback, emitted by nhc 0.1.0 (nhc:e71df528ea135fe1).

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
rhs: 84 +-, 148 *, 5 /, 7 calls
velocities: 17 +-, 46 *, 2 /, 7 calls
accelerations: 124 +-, 193 *, 6 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 106 +-, 184 *, 5 /, 7 calls
energy: 25 +-, 60 *, 2 /, 7 calls
jacobian: 530 +-, 754 *, 7 /, 7 calls
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
        z54 = z4 * z53 - k3 * (z3 * z45)
        z55 = z24 * z39 - c_beta * z47 + (z44 - s_beta * z48)
        z56 = k1 * (z3 * z42) - z10 * z53
        s1 = r3 * z49 - z28 * z54 - (r1 * z55 + z29 * z56)
        z57 = z29 * u1 - z28 * z31 + s1
        z58 = g * mu2 + z57
        z59 = z6 * z53 + k2 * (z3 * z26)
        s2 = z28 * z30 + w2 * u1 + (z7 * z49 + z28 * z59 - w2 * z56)
        z60 = g * mu3 + s2
        s3 = s_beta * z51 - (c_beta * z52 + (r3 * z58 + z7 * z60))
        z61 = w2 * z37 - (I_a * z49 - s3)
        z62 = I_d * w2 + I_a * z28
        s4 = w2 * z31 + z29 * z30 - (z7 * z55 - z29 * z59 - w2 * z54)
        z63 = g * z1 - s4
        s5 = I_d * z49 - (z29 * z62 - z28 * z37 - (r3 * z63 + r1 * z60))
        z64 = s5 + z15 * z61
        s6 = c_beta * z51 + (s_beta * z52 + (z7 * z63 - r1 * z58))
        z65 = w2 * z62 - (I_c * z55 + s6)
        z66 = (z65 + z19 * z61 + z22 * z64) / z23
        z67 = z21 * z64 + z22 * z66
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
            z14 * z61 + z15 * z67 + z19 * z66,
            # w2' (I.2.15) 41:4
            -z67,
            # w3' (I.2.15) 41:4
            z66,
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
        z28 = s_beta * z24 + c_beta * z27
        z29 = c_beta * z24 - s_beta * z27
        z30 = r3 * z28 + r1 * z29
        u1 = r3 * w2 - z7 * z29
        z31 = z25 * z24
        z32 = w2 + mu2 * z31
        z33 = c_beta * z32
        z34 = s_beta * z32
        z35 = z27 * z34
        z36 = mu2 * z27
        z37 = s_beta * z36 - c_alpha * z33
        z38 = z35 + z31 * z37
        z39 = z27 * z33
        z40 = c_alpha * z34 + c_beta * z36
        z41 = z39 + z31 * z40
        z42 = s_beta * z38 + c_beta * z41 - z31 * z36
        z43 = z25 * (z1 * z41 - mu3 * z38)
        z44 = z24 * z33 + s_beta * z42 - (z35 + c_beta * z43)
        z45 = (z10 * z37 - z6 * z26 + z4 * z40) * (z3 * (z3 * z3))
        z46 = z6 * z45 + k2 * (z3 * z26)
        z47 = k1 * (z3 * z37) - z10 * z45
        s1 = z28 * z30 + w2 * u1 + (z7 * z44 + z28 * z46 - w2 * z47)
        z48 = g * mu3 + s1
        s_gamma = math.sin(gamma)
        z49 = mu2 * s_gamma
        c_gamma = math.cos(gamma)
        z50 = c_beta * z49 + s_beta * c_gamma
        z51 = r1 * w2 + z7 * z28
        z52 = z24 * z34 - c_beta * z42 + (z39 - s_beta * z43)
        z53 = z4 * z45 - k3 * (z3 * z40)
        s2 = w2 * z51 + z29 * z30 - (z7 * z52 - z29 * z46 - w2 * z53)
        z54 = g * z1 - s2
        z55 = c_beta * c_gamma - s_beta * z49
        s3 = r3 * z44 - z28 * z53 - (r1 * z52 + z29 * z47)
        z56 = z29 * u1 - z28 * z51 + s3
        z57 = g * mu2 + z56
        z58 = c_alpha * s_gamma
        z59 = I_d * w2 + I_a * z28
        z60 = I_d * z28 + I_b * w2
        z61 = z27 * z60
        z62 = z24 * z60
        s4 = c_beta * z61 + (s_beta * z62 + (z7 * z54 - r1 * z57))
        z63 = w2 * z59 - (I_c * z52 + s4)
        z64 = I_c * z29
        s5 = s_beta * z61 - (c_beta * z62 + (r3 * z57 + z7 * z48))
        z65 = w2 * z64 - (I_a * z44 - s5)
        s6 = I_d * z44 - (z29 * z59 - z28 * z64 - (r3 * z54 + r1 * z48))
        z66 = s6 + z15 * z65
        z67 = (z63 + z19 * z65 + z22 * z66) / z23
        z68 = z21 * z66 + z22 * z67
        z69 = z14 * z65 + z15 * z68 + z19 * z67
        s7 = z69 * (r3 * z58 - z7 * z50) - z68 * (r3 * z55 - r1 * z50)
        z70 = z67 * (z7 * z55 - r1 * z58) + s7
        z71 = mu2 * c_gamma
        z72 = c_beta * z71 - s_beta * s_gamma
        z73 = c_beta * s_gamma + s_beta * z71
        z74 = c_alpha * c_gamma
        s8 = z69 * (r3 * z74 - z7 * z72) + z68 * (r3 * z73 + r1 * z72)
        z75 = z67 * (z7 * z73 + r1 * z74) - s8
        s9 = z69 * (mu2 * r3 + mu3 * z7) - z68 * (z1 * r3 + mu3 * r1)
        z76 = z67 * (mu2 * r1 - z1 * z7) - s9
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z70 - (z48 * z50 - (z54 * z55 + z57 * z58)),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z48 * z72 + (z54 * z73 - z57 * z74) + z75,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z76 - (mu3 * z48 + (z1 * z54 + mu2 * z57)),
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
        s_gamma = math.sin(gamma)
        z25 = s_beta * w1 - c_beta * w3
        z26 = s_beta * z25
        z27 = 1.0 / c_alpha
        z28 = z1 * w3 + mu3 * w1
        z29 = z27 * z28
        z30 = c_beta * z29
        z31 = z26 + z30
        z32 = r3 * z31
        z33 = c_beta * z25
        z34 = s_beta * z29
        z35 = z33 - z34
        z36 = r1 * z35
        z37 = z32 + z36
        z38 = 1.0 / (c_alpha * c_alpha)
        z39 = mu2 * z38
        z40 = s_beta * mu2
        z41 = c_beta * mu2
        z42 = z28 * z39 - z27 * (w3 * z40 + w1 * z41)
        z43 = c_beta * z42
        z44 = z3 * z3
        z45 = z3 * z44
        z46 = z45 * (z10 * z40 - c_alpha * z6 + z4 * z41)
        z47 = k3 * z3
        z48 = z4 * z46 - z41 * z47
        z49 = s_beta * z42
        z50 = k1 * z3
        z51 = z40 * z50 - z10 * z46
        z52 = r3 * z43 - z31 * z48 - (r1 * z49 + z35 * z51)
        z53 = r3 * w2
        z54 = z7 * z35
        u1 = z53 - z54
        z55 = s_beta * u1
        z56 = r1 * w2
        z57 = z7 * z31
        z58 = z56 + z57
        z59 = c_beta * z58
        z60 = z55 + z59
        z61 = k2 * z3
        z62 = z6 * z46 + c_alpha * z61
        z63 = w2 * z48 - (z7 * z49 - z35 * z62)
        z64 = w2 * z51 - (z7 * z43 + z31 * z62)
        z65 = s_beta * z63 + c_beta * z64
        z66 = mu2 * z37 - c_alpha * z52 + (c_alpha * z60 - mu2 * z65)
        c_gamma = math.cos(gamma)
        z67 = s_beta * z64 - c_beta * z63
        z68 = c_beta * w1 + s_beta * w3
        z69 = z27 * (mu3 * w3 - z1 * w1)
        z70 = z33 + s_beta * z68 - (z34 - c_beta * z69)
        z71 = k4 * (mu3 * (z1 * z45))
        z72 = z4 * z71 + z1 * z47
        z73 = z26 - c_beta * z68 + (z30 + s_beta * z69)
        z74 = mu3 * z50 - z10 * z71
        z75 = r3 * z70 + z31 * z72 - (r1 * z73 - z35 * z74)
        z76 = c_beta * u1
        z77 = z6 * z71
        z78 = w2 * z72 + (z7 * z73 + z35 * z77)
        z79 = s_beta * z58
        z80 = w2 * z74 + (z7 * z70 - z31 * z77)
        z81 = z76 + s_beta * z78 - (z79 - c_beta * z80)
        z82 = c_alpha * z75 - mu2 * z81
        z83 = z59 + s_beta * z80 + (z55 - c_beta * z78)
        z84 = z79 - z76
        z85 = c_alpha * z37
        z86 = mu2 * z60
        z87 = z85 - z86
        z88 = c_beta * z7
        z89 = mu2 * z88 - c_alpha * r3
        z90 = s_beta * z7
        z91 = s_beta * r3 + c_beta * r1
        z92 = mu2 * z91
        z93 = s_beta * r1 - c_beta * r3
        z94 = mu2 * z90 + c_alpha * r1
        z95 = z25 * z39
        z96 = z27 * z68
        z97 = s_beta * z27
        z98 = c_beta * z27
        z99 = g * r3
        z100 = z7 * w2
        z101 = r3 * z35
        z102 = z100 + z101
        z103 = z4 * z32 - z6 * z57 - z10 * z102
        z104 = z44 * z103
        z105 = z3 * z104
        z106 = k2 * z105
        z107 = z27 * z25
        z108 = z8 + (I_a + z5)
        z109 = c_beta * z18
        z110 = s_beta * z108 + z109
        z111 = s_beta * z18
        z112 = c_beta * z108 - z111
        z113 = z27 * z112
        z114 = c_beta * z110 - z1 * z113
        z115 = k3 * z105
        z116 = z107 * z114 - (mu3 * z115 - z32 * z47)
        z117 = s_beta * z110 + mu3 * z113
        z118 = k1 * z105
        z119 = z107 * z117 - (z1 * z118 + z102 * z50)
        z120 = z107 * z110 - c_beta * z116 - s_beta * z119
        z121 = z18 - z114
        z122 = z25 * z108 - z29 * z121 - c_alpha * z119
        z123 = z25 * z18
        z124 = z108 - z117
        z125 = z123 + z29 * z124 - c_alpha * z116
        z126 = c_beta * z122 - s_beta * z125
        z127 = mu2 * z29
        z128 = w2 + mu2 * z107
        z129 = c_beta * z128
        z130 = s_beta * z127 - c_alpha * z129
        z131 = s_beta * z128
        z132 = c_alpha * z131 + c_beta * z127
        z133 = z10 * z130 - z6 * z28 + z4 * z132
        z134 = z3 * z133
        z135 = z44 * z134
        z136 = z29 * z131
        z137 = z136 + z107 * z130
        z138 = z29 * z129
        z139 = z138 + z107 * z132
        z140 = s_beta * z137 + c_beta * z139 - z107 * z127
        z141 = z1 * z139 - mu3 * z137
        z142 = z27 * z141
        z143 = z25 * z129 + s_beta * z140 - (z136 + c_beta * z142)
        z144 = z7 * z143
        z145 = k2 * z28
        z146 = z3 * z145 + z6 * z135
        z147 = k1 * z130
        z148 = z3 * z147 - z10 * z135
        s1 = z31 * z37 + w2 * u1 + (z144 + z31 * z146 - w2 * z148)
        z149 = g * mu3 + s1
        z150 = I_d * w2
        z151 = z150 + I_a * z31
        z152 = I_c * z35
        z153 = z25 * z131 - c_beta * z140 + (z138 - s_beta * z142)
        z154 = z7 * z153
        z155 = k3 * z132
        z156 = z3 * z155 - z4 * z135
        s2 = w2 * z58 + z35 * z37 - (z154 - z35 * z146 + w2 * z156)
        z157 = g * z1 - s2
        z158 = I_d * z31
        z159 = z158 + I_b * w2
        z160 = z29 * z159
        z161 = z25 * z159
        z162 = r3 * z143
        z163 = r1 * z153
        s3 = z162 + z31 * z156 - (z163 + z35 * z148)
        z164 = g * mu2 + (z35 * u1 - z31 * z58 + s3)
        s4 = s_beta * z160 - (c_beta * z161 + (r3 * z164 + z7 * z149))
        z165 = w2 * z152 - (I_a * z143 - s4)
        s5 = z35 * z151 - z31 * z152 - (r3 * z157 + r1 * z149)
        z166 = I_d * z143 - s5 + z15 * z165
        z167 = 1.0 / z24
        s6 = c_beta * z160 + (s_beta * z161 + (z7 * z157 - r1 * z164))
        z168 = w2 * z151 - (I_c * z153 + s6)
        z169 = z167 * (z168 + z19 * z165 + z23 * z166)
        z170 = z22 * z166 + z23 * z169
        z171 = r1 * z170
        z172 = z14 * z165 + z15 * z170 + z19 * z169
        z173 = z7 * z172
        z174 = z35 * z102 + (z31 * z32 - (z144 + (z149 - z171 + 2.0 * z173)))
        s7 = z99 + (z28 * z106 - z29 * z120 + z107 * z126)
        z175 = s7 + k2 * (z57 * z135 - z3 * z174)
        z176 = z134 / (z2 * z2)
        z177 = r1 * z169
        z178 = r3 * z172
        z179 = w2 * z102 + (z31 * z57 + (z162 + (z164 - z177 + 2.0 * z178)))
        s8 = z32 * z155 + z57 * z145 - z147 * z102 - z133 * z104
        z180 = s8 - z4 * z179 - z6 * z174
        z181 = r3 * z153
        z182 = r3 * z169
        z183 = z7 * z170
        z184 = w2 * z32 - (z35 * z57 - (z181 + (z182 + z183)))
        z185 = z103 * z176 - 0.5 * (z45 * (z180 - z10 * z184))
        z186 = z127 * z110 - z130 * z117 - z132 * z114 - mu2 * z126
        z187 = s_beta * z159
        z188 = I_d * z35
        z189 = z7 * z37
        z190 = r3 * z58
        z191 = r3 * z156
        z192 = z7 * z146
        z193 = z7 * z32 - (r3 * z57 + (z188 + z189 - z190 + z191 + z192))
        z194 = z7 * z102 - (r1 * z57 - (I_c * w2 - r3 * u1 + r3 * z148))
        s9 = z187 + z131 * z124 + z129 * z121 + mu2 * z120
        z195 = s9 + c_beta * z193 - s_beta * z194
        z196 = g * z7
        z197 = mu2 * z106 + z57 * z61 - z27 * z195
        s10 = z132 * z115 - z137 * z113 - z196 - w1 * z197
        z198 = s10 + k3 * (z32 * z135 + z3 * z179)
        z199 = z198 - 2.0 * (z4 * z185)
        s11 = z38 * (z141 * z112 + z25 * z186 + z28 * z195)
        z200 = z131 * z116 - z129 * z119 + s11 - c_beta * z199
        s12 = z130 * z118 + z139 * z113 - w3 * z197
        z201 = s12 - k1 * (z102 * z135 - z3 * z184) - 2.0 * (z10 * z185)
        s13 = c_alpha * (z175 + 2.0 * (z6 * z185))
        z202 = s13 - mu2 * (z200 - s_beta * z201)
        z203 = r1 * z31
        z204 = z101 - z203
        z205 = z4 * z53 + z6 * z204 - z10 * z56
        z206 = z44 * z205
        z207 = z3 * z206
        z208 = k2 * z207
        z209 = s_beta * z13 - c_beta * z20
        z210 = c_beta * z13 + s_beta * z20
        z211 = z27 * z210
        z212 = c_beta * z209 - z1 * z211
        z213 = k3 * z207
        z214 = z107 * z212 - (mu3 * z213 - z53 * z47)
        z215 = s_beta * z209 + mu3 * z211
        z216 = k1 * z207
        z217 = z107 * z215 - (z1 * z216 + z56 * z50)
        z218 = z107 * z209 - c_beta * z214 - s_beta * z217
        z219 = z20 + z212
        z220 = z25 * z13 + z29 * z219 - c_alpha * z217
        z221 = z13 - z215
        z222 = z25 * z20 - z29 * z221 + c_alpha * z214
        z223 = c_beta * z220 + s_beta * z222
        z224 = r1 * z143
        z225 = r1 * z172
        z226 = z56 * z35 + (z53 * z31 - (z181 + (z224 + (z182 + z225))))
        z227 = r3 * z170
        z228 = z7 * z169
        z229 = w2 * z56 - (z31 * z204 + (2.0 * z227 - (z157 + z228)))
        s14 = z53 * z155 - z145 * z204 - z56 * z147 - z133 * z206
        z230 = s14 - z4 * z229 - z6 * z226
        z231 = w2 * z53 + (z35 * z204 - (z173 + (z149 - 2.0 * z171)))
        z232 = z205 * z176 - 0.5 * (z45 * (z230 - z10 * z231))
        s15 = z28 * z208 - z29 * z218 + z107 * z223
        z233 = s15 - k2 * (z204 * z135 + z3 * z226) + 2.0 * (z6 * z232)
        z234 = z127 * z209 - z130 * z215 - z132 * z212 - mu2 * z223
        z235 = z7 * z53 + (r3 * z204 + (z35 * k6 - r1 * z37 - r1 * z146))
        s16 = r1 * z204 + (z151 - I_c * z31 + r3 * z37 + r3 * z146)
        z236 = z7 * z56 + s16
        s17 = z131 * z221 - z129 * z219 + mu2 * z218 + c_beta * z235
        z237 = s17 - s_beta * z236
        z238 = g * r1
        z239 = mu2 * z208 - z204 * z61 - z27 * z237
        s18 = z132 * z213 - z137 * z211 - z238 - w1 * z239
        z240 = s18 + k3 * (z53 * z135 + z3 * z229)
        z241 = z240 - 2.0 * (z4 * z232)
        s19 = z38 * (z141 * z210 + z25 * z234 + z28 * z237)
        z242 = z131 * z214 - z129 * z217 + s19 - c_beta * z241
        s20 = z99 - (z130 * z216 + z139 * z211) + w3 * z239
        z243 = s20 + k1 * (z56 * z135 - z3 * z231)
        z244 = z243 + 2.0 * (z10 * z232)
        z245 = c_alpha * z233 - mu2 * (z242 + s_beta * z244) - z15 * z202
        z246 = z100 - z203
        z247 = z4 * z246 + z6 * z54 + z10 * z36
        z248 = z44 * z247
        z249 = z3 * z248
        z250 = k2 * z249
        z251 = z8 + (I_c + z11)
        z252 = z111 + c_beta * z251
        z253 = z109 - s_beta * z251
        z254 = z27 * z253
        z255 = c_beta * z252 - z1 * z254
        z256 = k3 * z249
        z257 = z107 * z255 + (mu3 * z256 - z246 * z47)
        z258 = s_beta * z252 + mu3 * z254
        z259 = k1 * z249
        z260 = z107 * z258 + (z1 * z259 - z36 * z50)
        z261 = z107 * z252 - c_beta * z257 - s_beta * z260
        z262 = z251 - z255
        z263 = z123 - z29 * z262 - c_alpha * z260
        z264 = z18 - z258
        z265 = z25 * z251 + z29 * z264 - c_alpha * z257
        z266 = c_beta * z263 - s_beta * z265
        s21 = z31 * z246 - (z154 + (2.0 * z228 + (z157 - z227)))
        z267 = z35 * z36 - s21
        s22 = z238 - (z28 * z250 + z29 * z261 - z107 * z266)
        z268 = s22 + k2 * (z54 * z135 - z3 * z267)
        z269 = w2 * z36 + (z54 * z31 + (z224 + (z183 + z225)))
        s23 = z155 * z246 - z54 * z145 + z36 * z147 - z133 * z248
        z270 = s23 + z4 * z269 + z6 * z267
        s24 = z35 * z54 - (z163 - (z178 + (z164 - 2.0 * z177)))
        z271 = w2 * z246 + s24
        z272 = z247 * z176 - 0.5 * (z45 * (z270 - z10 * z271))
        z273 = z127 * z252 - z130 * z258 - z132 * z255 - mu2 * z266
        z274 = c_beta * z159
        s25 = r3 * z54 - (z158 - I_a * w2 + r1 * z58 - r1 * z156)
        z275 = z7 * z246 + s25
        z276 = r1 * u1
        z277 = r1 * z148
        z278 = z7 * z36 - (r1 * z54 + (z192 + (z189 + z276 - z277)))
        s26 = z274 + z131 * z264 + z129 * z262 + mu2 * z261
        z279 = s26 - c_beta * z275 - s_beta * z278
        z280 = mu2 * z250 - z54 * z61 + z27 * z279
        s27 = z132 * z256 + z137 * z254 - w1 * z280
        z281 = s27 + k3 * (z246 * z135 - z3 * z269) - 2.0 * (z4 * z272)
        s28 = z38 * (z141 * z253 + z25 * z273 + z28 * z279)
        z282 = z131 * z257 - z129 * z260 + s28 + c_beta * z281
        s29 = z196 - (z130 * z259 - z139 * z254) + w3 * z280
        z283 = s29 - k1 * (z36 * z135 + z3 * z271)
        z284 = z283 + 2.0 * (z10 * z272)
        s30 = c_alpha * (z268 - 2.0 * (z6 * z272))
        z285 = s30 - mu2 * (z282 - s_beta * z284) - z19 * z202 + z23 * z245
        z286 = z167 * z285
        z287 = z22 * z245 + z23 * z286
        z288 = z142 * z18
        s31 = z160 - z140 * z108 - z288 - z137 * z110 - z127 * z119
        z289 = s31 + z128 * z125 + z25 * z193
        s32 = z274 + z129 * z108 - z131 * z18 - s_beta * z193
        z290 = s32 - c_beta * z194 - z27 * z186
        z291 = z140 * z18
        s33 = z161 - z142 * z108 + z291 + z139 * z110 + z127 * z116
        z292 = s33 + z128 * z122 - z29 * z193
        s34 = c_beta * (z289 - z29 * z194 - w1 * z290 + c_alpha * z201)
        s35 = s_beta * (z292 - z25 * z194 - w3 * z290 - c_alpha * z199)
        z293 = s34 + s35
        s36 = z140 * z13 - z142 * z20 + z137 * z209 + z127 * z217
        z294 = s36 + z128 * z222 - z25 * z235
        s37 = z129 * z13 + z131 * z20 - s_beta * z235 - c_beta * z236
        z295 = s37 - z27 * z234
        s38 = z142 * z13 + z140 * z20 - z139 * z209 - z127 * z214
        z296 = s38 - z128 * z220 + z29 * z235
        s39 = c_beta * (z294 + z29 * z236 + w1 * z295 + c_alpha * z244)
        s40 = s_beta * (z296 + z25 * z236 + w3 * z295 + c_alpha * z241)
        z297 = s39 + s40
        z298 = z297 + z15 * z293
        s41 = z161 - z291 - z142 * z251 - z137 * z252 - z127 * z260
        z299 = s41 + z128 * z265 - z25 * z275
        s42 = z187 - z129 * z18 + z131 * z251 - s_beta * z275
        z300 = s42 + c_beta * z278 + z27 * z273
        s43 = z160 + z288 - z140 * z251 - z139 * z252 - z127 * z257
        z301 = s43 - z128 * z263 - z29 * z275
        s44 = c_beta * (z299 - z29 * z278 + w1 * z300 + c_alpha * z284)
        s45 = s_beta * (z301 + z25 * z278 - w3 * z300 - c_alpha * z281)
        z302 = s44 - s45
        z303 = z167 * (z302 - z19 * z293 - z23 * z298)
        z304 = z22 * z298 - z23 * z303
        z305 = s_beta * z290 + mu3 * z197
        z306 = s_beta * z295 + mu3 * z239 - z15 * z305
        z307 = z167 * (s_beta * z300 + mu3 * z280 + z19 * z305 - z23 * z306)
        z308 = z22 * z306 - z23 * z307
        s46 = r1 * z32 - (z35 * k5 + z7 * u1 - z7 * z148 + z126)
        z309 = r3 * z102 - s46
        s47 = r1 * z53 - (z191 - (z190 + (z188 - z276) + z277) + z223)
        z310 = r3 * z56 - s47 - z15 * z309
        s48 = z150 + (z151 - I_b * z31) + z7 * z58 - z7 * z156 + z266
        z311 = r3 * z36 + (r1 * z246 + s48)
        z312 = z167 * (z311 - z19 * z309 + z23 * z310)
        z313 = z22 * z310 + z23 * z312
        z314 = c_beta * z290 - z1 * z197
        z315 = c_beta * z295 - z1 * z239 - z15 * z314
        z316 = z167 * (c_beta * z300 - z1 * z280 + z19 * z314 - z23 * z315)
        z317 = z22 * z315 - z23 * z316
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z67 - s_gamma * z66,
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
            s_gamma * z67 + c_gamma * z66,
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
            z86 + c_alpha * z65 - (z85 + mu2 * z52),
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
            z42,
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
            z25 + mu2 * z95,
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
            z19 * z286 - (z14 * z202 - z15 * z287),
            # (I.2.15)
            z14 * z293 + z15 * z304 - z19 * z303,
            0.0,
            # (I.2.15)
            -(z14 * z305 - z15 * z308 + z19 * z307),
            # (I.2.15)
            z19 * z312 - (z14 * z309 - z15 * z313),
            # (I.2.15)
            z14 * z314 - z15 * z317 + z19 * z316,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z287,
            # (I.2.15)
            -z304,
            0.0,
            # (I.2.15)
            -z308,
            # (I.2.15)
            -z313,
            # (I.2.15)
            z317,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z286,
            # (I.2.15)
            -z303,
            0.0,
            # (I.2.15)
            -z307,
            # (I.2.15)
            z312,
            # (I.2.15)
            z316,
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
