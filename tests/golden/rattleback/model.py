"""rattleback, emitted by nhc 0.1.0 (nhc:ef0e680078cb24e4).

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
accelerations: 124 +-, 194 *, 5 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 106 +-, 184 *, 5 /, 7 calls
energy: 25 +-, 60 *, 2 /, 7 calls
jacobian: 530 +-, 755 *, 5 /, 7 calls
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
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        z3 = mu3 * k3
        r3 = h - z2 * z3
        z4 = r3 * r3
        z5 = mu2 * k2
        z6 = z2 * z5
        z7 = z6 * z6
        z8 = I_a + (z4 + z7)
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "rhs")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "rhs")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * z16:
            raise SingularModelError(2, "rhs")
        s_gamma = math.sin(gamma)
        z23 = s_beta * w1 - c_beta * w3
        z24 = 1.0 / c_alpha
        z25 = z1 * w3 + mu3 * w1
        z26 = z24 * z25
        z27 = s_beta * z23 + c_beta * z26
        z28 = c_beta * z23 - s_beta * z26
        z29 = r3 * z27 + r1 * z28
        u1 = r3 * w2 - z6 * z28
        z30 = r1 * w2 + z6 * z27
        z31 = s_beta * u1 + c_beta * z30
        z32 = c_alpha * z29 - mu2 * z31
        c_gamma = math.cos(gamma)
        z33 = s_beta * z30 - c_beta * u1
        z34 = z24 * z23
        z35 = w2 + mu2 * z34
        z36 = I_c * z28
        z37 = c_beta * z35
        z38 = s_beta * z35
        z39 = z26 * z38
        z40 = mu2 * z26
        z41 = s_beta * z40 - c_alpha * z37
        z42 = z39 + z34 * z41
        z43 = z26 * z37
        z44 = c_alpha * z38 + c_beta * z40
        z45 = z43 + z34 * z44
        z46 = s_beta * z42 + c_beta * z45 - z34 * z40
        z47 = z24 * (z1 * z45 - mu3 * z42)
        z48 = z23 * z37 + s_beta * z46 - (z39 + c_beta * z47)
        z49 = I_d * z27 + I_b * w2
        z50 = z26 * z49
        z51 = z23 * z49
        z52 = (z9 * z41 - z5 * z25 + z3 * z44) * (z2 * (z2 * z2))
        z53 = z3 * z52 - k3 * (z2 * z44)
        z54 = z23 * z38 - c_beta * z46 + (z43 - s_beta * z47)
        z55 = k1 * (z2 * z41) - z9 * z52
        s2 = r3 * z48 - z27 * z53 - (r1 * z54 + z28 * z55)
        z56 = z28 * u1 - z27 * z30 + s2
        z57 = g * mu2 + z56
        z58 = z5 * z52 + k2 * (z2 * z25)
        s3 = z27 * z29 + w2 * u1 + (z6 * z48 + z27 * z58 - w2 * z55)
        z59 = g * mu3 + s3
        s4 = s_beta * z50 - (c_beta * z51 + (r3 * z57 + z6 * z59))
        z60 = w2 * z36 - (I_a * z48 - s4)
        z61 = I_d * w2 + I_a * z27
        s5 = w2 * z30 + z28 * z29 - (z6 * z54 - z28 * z58 - w2 * z53)
        z62 = g * z1 - s5
        s6 = I_d * z48 - (z28 * z61 - z27 * z36 - (r3 * z62 + r1 * z59))
        z63 = s6 + z14 * z60
        s7 = c_beta * z50 + (s_beta * z51 + (z6 * z62 - r1 * z57))
        z64 = w2 * z61 - (I_c * z54 + s7)
        z65 = (z64 + z18 * z60 + z21 * z63) / z22
        z66 = z20 * z63 + z21 * z65
        dydt: list[float] = [
            # x' (I.2.15)
            s_gamma * z32 - c_gamma * z33,
            # y' (I.2.15)
            -(s_gamma * z33 + c_gamma * z32),
            # z' (I.2.15)
            -(mu2 * z29 + c_alpha * z31),
            # alpha' (I.2.15)
            z26,
            # beta' (I.2.15)
            z35,
            # gamma' (I.2.15)
            -z34,
            # w1' (I.2.15) 41:4
            z13 * z60 + z14 * z66 + z18 * z65,
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
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        z3 = mu3 * k3
        r3 = h - z2 * z3
        z4 = r3 * r3
        z5 = mu2 * k2
        z6 = z2 * z5
        z7 = z6 * z6
        z8 = I_a + (z4 + z7)
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "accelerations")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "accelerations")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * z16:
            raise SingularModelError(2, "accelerations")
        z23 = s_beta * w1 - c_beta * w3
        z24 = 1.0 / c_alpha
        z25 = z1 * w3 + mu3 * w1
        z26 = z24 * z25
        z27 = s_beta * z23 + c_beta * z26
        z28 = c_beta * z23 - s_beta * z26
        z29 = r3 * z27 + r1 * z28
        u1 = r3 * w2 - z6 * z28
        z30 = r1 * w2 + z6 * z27
        z31 = s_beta * u1 + c_beta * z30
        z32 = c_alpha * z29 - mu2 * z31
        c_gamma = math.cos(gamma)
        z33 = z24 * z23
        z34 = c_gamma * z33
        s_gamma = math.sin(gamma)
        z35 = mu2 * z26
        z36 = w2 + mu2 * z33
        z37 = c_beta * z36
        z38 = s_beta * z35 - c_alpha * z37
        z39 = s_beta * z36
        z40 = c_alpha * z39 + c_beta * z35
        z41 = (z9 * z38 - z5 * z25 + z3 * z40) * (z2 * (z2 * z2))
        z42 = z3 * z41 - k3 * (z2 * z40)
        z43 = z27 * z42
        z44 = z23 * z37
        z45 = I_c * z28
        z46 = z26 * z39
        z47 = z46 + z33 * z38
        z48 = z26 * z37
        z49 = z48 + z33 * z40
        z50 = s_beta * z47 + c_beta * z49 - z33 * z35
        z51 = z24 * (z1 * z49 - mu3 * z47)
        z52 = z44 + s_beta * z50 - (z46 + c_beta * z51)
        z53 = I_d * z27 + I_b * w2
        z54 = z26 * z53
        z55 = z23 * z53
        z56 = z23 * z39
        z57 = z56 - c_beta * z50 + (z48 - s_beta * z51)
        z58 = k1 * (z2 * z38) - z9 * z41
        z59 = z28 * z58
        s2 = z28 * u1 - z27 * z30 + (r3 * z52 - z43 - (r1 * z57 + z59))
        z60 = g * mu2 + s2
        z61 = z5 * z41 + k2 * (z2 * z25)
        z62 = z27 * z61
        z63 = w2 * z58
        z64 = g * mu3 + (z27 * z29 + w2 * u1 + (z6 * z52 + z62 - z63))
        s3 = s_beta * z54 - (c_beta * z55 + (r3 * z60 + z6 * z64))
        z65 = w2 * z45 - (I_a * z52 - s3)
        z66 = I_d * w2 + I_a * z27
        z67 = z28 * z61
        z68 = w2 * z42
        z69 = g * z1 - (w2 * z30 + z28 * z29 - (z6 * z57 - z67 - z68))
        s4 = I_d * z52 - (z28 * z66 - z27 * z45 - (r3 * z69 + r1 * z64))
        z70 = s4 + z14 * z65
        s5 = c_beta * z54 + (s_beta * z55 + (z6 * z69 - r1 * z60))
        z71 = w2 * z66 - (I_c * z57 + s5)
        z72 = (z71 + z18 * z65 + z21 * z70) / z22
        z73 = z20 * z70 + z21 * z72
        z74 = z13 * z65 + z14 * z73 + z18 * z72
        z75 = w1 * z37 + s_beta * z74 + (w3 * z39 - c_beta * z72)
        z76 = z35 * (z24 * z24)
        s6 = z24 * (w3 * z38 - z1 * z72 + (w1 * z40 - mu3 * z74))
        z77 = z25 * z76 - s6
        z78 = z44 + s_beta * z75 - (z46 - c_beta * z77)
        z79 = z56 - c_beta * z75 + (z48 + s_beta * z77)
        z80 = z43 - r3 * z78 + (z59 + r1 * z79)
        z81 = z68 + r3 * z73 + (z67 - z6 * z79)
        z82 = z63 + r1 * z73 - (z62 + z6 * z78)
        z83 = u1 * z37 - s_beta * z81 - (z30 * z39 + c_beta * z82)
        z84 = z29 * z35 + c_alpha * z80 + (z25 * z31 + mu2 * z83)
        z85 = s_beta * z30 - c_beta * u1
        z86 = s_gamma * z33
        z87 = z30 * z37 - s_beta * z82 + (u1 * z39 + c_beta * z81)
        z88 = z23 * z76 + z24 * z75
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z32 * z34 + s_gamma * z84 + (z85 * z86 + c_gamma * z87)),
            # y'' (I.2.15)
            z85 * z34 - s_gamma * z87 - (z32 * z86 - c_gamma * z84),
            # z'' (I.2.15)
            z31 * z35 - c_alpha * z83 - (z25 * z29 - mu2 * z80),
            # alpha'' (I.2.15)
            z77,
            # beta'' (I.2.15)
            z25 * z33 + mu2 * z88 - z73,
            # gamma'' (I.2.15)
            -z88,
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
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        z3 = mu3 * k3
        r3 = h - z2 * z3
        z4 = r3 * r3
        z5 = mu2 * k2
        z6 = z2 * z5
        z7 = z6 * z6
        z8 = I_a + (z4 + z7)
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "reactions")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "reactions")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular
        if not abs(z22) > 1e-14 * z16:
            raise SingularModelError(2, "reactions")
        z23 = s_beta * w1 - c_beta * w3
        z24 = 1.0 / c_alpha
        z25 = z1 * w3 + mu3 * w1
        z26 = z24 * z25
        z27 = s_beta * z23 + c_beta * z26
        z28 = c_beta * z23 - s_beta * z26
        z29 = r3 * z27 + r1 * z28
        u1 = r3 * w2 - z6 * z28
        z30 = z24 * z23
        z31 = w2 + mu2 * z30
        z32 = c_beta * z31
        z33 = s_beta * z31
        z34 = z26 * z33
        z35 = mu2 * z26
        z36 = s_beta * z35 - c_alpha * z32
        z37 = z34 + z30 * z36
        z38 = z26 * z32
        z39 = c_alpha * z33 + c_beta * z35
        z40 = z38 + z30 * z39
        z41 = s_beta * z37 + c_beta * z40 - z30 * z35
        z42 = z24 * (z1 * z40 - mu3 * z37)
        z43 = z23 * z32 + s_beta * z41 - (z34 + c_beta * z42)
        z44 = (z9 * z36 - z5 * z25 + z3 * z39) * (z2 * (z2 * z2))
        z45 = z5 * z44 + k2 * (z2 * z25)
        z46 = k1 * (z2 * z36) - z9 * z44
        s2 = z27 * z29 + w2 * u1 + (z6 * z43 + z27 * z45 - w2 * z46)
        z47 = g * mu3 + s2
        s_gamma = math.sin(gamma)
        z48 = mu2 * s_gamma
        c_gamma = math.cos(gamma)
        z49 = c_beta * z48 + s_beta * c_gamma
        z50 = r1 * w2 + z6 * z27
        z51 = z23 * z33 - c_beta * z41 + (z38 - s_beta * z42)
        z52 = z3 * z44 - k3 * (z2 * z39)
        s3 = w2 * z50 + z28 * z29 - (z6 * z51 - z28 * z45 - w2 * z52)
        z53 = g * z1 - s3
        z54 = c_beta * c_gamma - s_beta * z48
        s4 = r3 * z43 - z27 * z52 - (r1 * z51 + z28 * z46)
        z55 = z28 * u1 - z27 * z50 + s4
        z56 = g * mu2 + z55
        z57 = c_alpha * s_gamma
        z58 = I_d * w2 + I_a * z27
        z59 = I_d * z27 + I_b * w2
        z60 = z26 * z59
        z61 = z23 * z59
        s5 = c_beta * z60 + (s_beta * z61 + (z6 * z53 - r1 * z56))
        z62 = w2 * z58 - (I_c * z51 + s5)
        z63 = I_c * z28
        s6 = s_beta * z60 - (c_beta * z61 + (r3 * z56 + z6 * z47))
        z64 = w2 * z63 - (I_a * z43 - s6)
        s7 = I_d * z43 - (z28 * z58 - z27 * z63 - (r3 * z53 + r1 * z47))
        z65 = s7 + z14 * z64
        z66 = (z62 + z18 * z64 + z21 * z65) / z22
        z67 = z20 * z65 + z21 * z66
        z68 = z13 * z64 + z14 * z67 + z18 * z66
        s8 = z68 * (r3 * z57 - z6 * z49) - z67 * (r3 * z54 - r1 * z49)
        z69 = z66 * (z6 * z54 - r1 * z57) + s8
        z70 = mu2 * c_gamma
        z71 = c_beta * z70 - s_beta * s_gamma
        z72 = c_beta * s_gamma + s_beta * z70
        z73 = c_alpha * c_gamma
        s9 = z68 * (r3 * z73 - z6 * z71) + z67 * (r3 * z72 + r1 * z71)
        z74 = z66 * (z6 * z72 + r1 * z73) - s9
        s10 = z68 * (mu2 * r3 + mu3 * z6) - z67 * (z1 * r3 + mu3 * r1)
        z75 = z66 * (mu2 * r1 - z1 * z6) - s10
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z69 - (z47 * z49 - (z53 * z54 + z56 * z57)),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z47 * z71 + (z53 * z72 - z56 * z73) + z74,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z75 - (mu3 * z47 + (z1 * z53 + mu2 * z56)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

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
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        z3 = mu3 * k3
        r3 = h - z2 * z3
        z4 = r3 * r3
        z5 = mu2 * k2
        z6 = z2 * z5
        z7 = z6 * z6
        z8 = I_a + (z4 + z7)
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "jacobian")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular
        if not abs(z15) > 1e-14 * z11:
            raise SingularModelError(2, "jacobian")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3
        z20 = z19 + z12 * z18
        z21 = 1.0 / z15
        z22 = z20 * z21
        z23 = z16 - z17 * z18 - z20 * z22
        # the mass matrix is singular
        if not abs(z23) > 1e-14 * z16:
            raise SingularModelError(2, "jacobian")
        s_gamma = math.sin(gamma)
        z24 = s_beta * w1 - c_beta * w3
        z25 = s_beta * z24
        z26 = 1.0 / c_alpha
        z27 = z1 * w3 + mu3 * w1
        z28 = z26 * z27
        z29 = c_beta * z28
        z30 = z25 + z29
        z31 = r3 * z30
        z32 = c_beta * z24
        z33 = s_beta * z28
        z34 = z32 - z33
        z35 = r1 * z34
        z36 = z31 + z35
        z37 = z26 * z26
        z38 = mu2 * z37
        z39 = s_beta * mu2
        z40 = c_beta * mu2
        z41 = z27 * z38 - z26 * (w3 * z39 + w1 * z40)
        z42 = c_beta * z41
        z43 = z2 * z2
        z44 = z2 * z43
        z45 = z44 * (z9 * z39 - c_alpha * z5 + z3 * z40)
        z46 = k3 * z2
        z47 = z3 * z45 - z40 * z46
        z48 = s_beta * z41
        z49 = k1 * z2
        z50 = z39 * z49 - z9 * z45
        z51 = r3 * z42 - z30 * z47 - (r1 * z48 + z34 * z50)
        z52 = r3 * w2
        z53 = z6 * z34
        u1 = z52 - z53
        z54 = s_beta * u1
        z55 = r1 * w2
        z56 = z6 * z30
        z57 = z55 + z56
        z58 = c_beta * z57
        z59 = z54 + z58
        z60 = k2 * z2
        z61 = z5 * z45 + c_alpha * z60
        z62 = w2 * z47 - (z6 * z48 - z34 * z61)
        z63 = w2 * z50 - (z6 * z42 + z30 * z61)
        z64 = s_beta * z62 + c_beta * z63
        z65 = mu2 * z36 - c_alpha * z51 + (c_alpha * z59 - mu2 * z64)
        c_gamma = math.cos(gamma)
        z66 = s_beta * z63 - c_beta * z62
        z67 = c_beta * w1 + s_beta * w3
        z68 = z26 * (mu3 * w3 - z1 * w1)
        z69 = z32 + s_beta * z67 - (z33 - c_beta * z68)
        z70 = k4 * (mu3 * (z1 * z44))
        z71 = z3 * z70 + z1 * z46
        z72 = z25 - c_beta * z67 + (z29 + s_beta * z68)
        z73 = mu3 * z49 - z9 * z70
        z74 = r3 * z69 + z30 * z71 - (r1 * z72 - z34 * z73)
        z75 = c_beta * u1
        z76 = z5 * z70
        z77 = w2 * z71 + (z6 * z72 + z34 * z76)
        z78 = s_beta * z57
        z79 = w2 * z73 + (z6 * z69 - z30 * z76)
        z80 = z75 + s_beta * z77 - (z78 - c_beta * z79)
        z81 = c_alpha * z74 - mu2 * z80
        z82 = z58 + s_beta * z79 + (z54 - c_beta * z77)
        z83 = z78 - z75
        z84 = c_alpha * z36
        z85 = mu2 * z59
        z86 = z84 - z85
        z87 = c_beta * z6
        z88 = mu2 * z87 - c_alpha * r3
        z89 = s_beta * z6
        z90 = s_beta * r3 + c_beta * r1
        z91 = mu2 * z90
        z92 = s_beta * r1 - c_beta * r3
        z93 = mu2 * z89 + c_alpha * r1
        z94 = z24 * z38
        z95 = z26 * z67
        z96 = s_beta * z26
        z97 = c_beta * z26
        z98 = g * r3
        z99 = z6 * w2
        z100 = r3 * z34
        z101 = z99 + z100
        z102 = z3 * z31 - z5 * z56 - z9 * z101
        z103 = z43 * z102
        z104 = z2 * z103
        z105 = k2 * z104
        z106 = z26 * z24
        z107 = z7 + (I_a + z4)
        z108 = c_beta * z17
        z109 = s_beta * z107 + z108
        z110 = s_beta * z17
        z111 = c_beta * z107 - z110
        z112 = z26 * z111
        z113 = c_beta * z109 - z1 * z112
        z114 = k3 * z104
        z115 = z106 * z113 - (mu3 * z114 - z31 * z46)
        z116 = s_beta * z109 + mu3 * z112
        z117 = k1 * z104
        z118 = z106 * z116 - (z1 * z117 + z101 * z49)
        z119 = z106 * z109 - c_beta * z115 - s_beta * z118
        z120 = z17 - z113
        z121 = z24 * z107 - z28 * z120 - c_alpha * z118
        z122 = z24 * z17
        z123 = z107 - z116
        z124 = z122 + z28 * z123 - c_alpha * z115
        z125 = c_beta * z121 - s_beta * z124
        z126 = mu2 * z28
        z127 = w2 + mu2 * z106
        z128 = c_beta * z127
        z129 = s_beta * z126 - c_alpha * z128
        z130 = s_beta * z127
        z131 = c_alpha * z130 + c_beta * z126
        z132 = z9 * z129 - z5 * z27 + z3 * z131
        z133 = z2 * z132
        z134 = z43 * z133
        z135 = z28 * z130
        z136 = z135 + z106 * z129
        z137 = z28 * z128
        z138 = z137 + z106 * z131
        z139 = s_beta * z136 + c_beta * z138 - z106 * z126
        z140 = z1 * z138 - mu3 * z136
        z141 = z26 * z140
        z142 = z24 * z128 + s_beta * z139 - (z135 + c_beta * z141)
        z143 = z6 * z142
        z144 = k2 * z27
        z145 = z2 * z144 + z5 * z134
        z146 = k1 * z129
        z147 = z2 * z146 - z9 * z134
        s2 = z30 * z36 + w2 * u1 + (z143 + z30 * z145 - w2 * z147)
        z148 = g * mu3 + s2
        z149 = I_d * w2
        z150 = z149 + I_a * z30
        z151 = I_c * z34
        z152 = z24 * z130 - c_beta * z139 + (z137 - s_beta * z141)
        z153 = z6 * z152
        z154 = k3 * z131
        z155 = z2 * z154 - z3 * z134
        s3 = w2 * z57 + z34 * z36 - (z153 - z34 * z145 + w2 * z155)
        z156 = g * z1 - s3
        z157 = I_d * z30
        z158 = z157 + I_b * w2
        z159 = z28 * z158
        z160 = z24 * z158
        z161 = r3 * z142
        z162 = r1 * z152
        s4 = z161 + z30 * z155 - (z162 + z34 * z147)
        z163 = g * mu2 + (z34 * u1 - z30 * z57 + s4)
        s5 = s_beta * z159 - (c_beta * z160 + (r3 * z163 + z6 * z148))
        z164 = w2 * z151 - (I_a * z142 - s5)
        s6 = z34 * z150 - z30 * z151 - (r3 * z156 + r1 * z148)
        z165 = I_d * z142 - s6 + z14 * z164
        z166 = 1.0 / z23
        s7 = c_beta * z159 + (s_beta * z160 + (z6 * z156 - r1 * z163))
        z167 = w2 * z150 - (I_c * z152 + s7)
        z168 = z166 * (z167 + z18 * z164 + z22 * z165)
        z169 = z21 * z165 + z22 * z168
        z170 = r1 * z169
        z171 = z13 * z164 + z14 * z169 + z18 * z168
        z172 = z6 * z171
        z173 = z34 * z101 + (z30 * z31 - (z143 + (z148 - z170 + 2.0 * z172)))
        s8 = z98 + (z27 * z105 - z28 * z119 + z106 * z125)
        z174 = s8 + k2 * (z56 * z134 - z2 * z173)
        z175 = z43 * z43 * z133
        z176 = r1 * z168
        z177 = r3 * z171
        z178 = w2 * z101 + (z30 * z56 + (z161 + (z163 - z176 + 2.0 * z177)))
        s9 = z31 * z154 + z56 * z144 - z146 * z101 - z132 * z103
        z179 = s9 - z3 * z178 - z5 * z173
        z180 = r3 * z152
        z181 = r3 * z168
        z182 = z6 * z169
        z183 = w2 * z31 - (z34 * z56 - (z180 + (z181 + z182)))
        z184 = z102 * z175 - 0.5 * (z44 * (z179 - z9 * z183))
        z185 = z126 * z109 - z129 * z116 - z131 * z113 - mu2 * z125
        z186 = s_beta * z158
        z187 = I_d * z34
        z188 = z6 * z36
        z189 = r3 * z57
        z190 = r3 * z155
        z191 = z6 * z145
        z192 = z6 * z31 - (r3 * z56 + (z187 + z188 - z189 + z190 + z191))
        z193 = z6 * z101 - (r1 * z56 - (I_c * w2 - r3 * u1 + r3 * z147))
        s10 = z186 + z130 * z123 + z128 * z120 + mu2 * z119
        z194 = s10 + c_beta * z192 - s_beta * z193
        z195 = g * z6
        z196 = mu2 * z105 + z56 * z60 - z26 * z194
        s11 = z131 * z114 - z136 * z112 - z195 - w1 * z196
        z197 = s11 + k3 * (z31 * z134 + z2 * z178)
        z198 = z197 - 2.0 * (z3 * z184)
        s12 = z37 * (z140 * z111 + z24 * z185 + z27 * z194)
        z199 = z130 * z115 - z128 * z118 + s12 - c_beta * z198
        s13 = z129 * z117 + z138 * z112 - w3 * z196
        z200 = s13 - k1 * (z101 * z134 - z2 * z183) - 2.0 * (z9 * z184)
        s14 = c_alpha * (z174 + 2.0 * (z5 * z184))
        z201 = s14 - mu2 * (z199 - s_beta * z200)
        z202 = r1 * z30
        z203 = z100 - z202
        z204 = z3 * z52 + z5 * z203 - z9 * z55
        z205 = z43 * z204
        z206 = z2 * z205
        z207 = k2 * z206
        z208 = s_beta * z12 - c_beta * z19
        z209 = c_beta * z12 + s_beta * z19
        z210 = z26 * z209
        z211 = c_beta * z208 - z1 * z210
        z212 = k3 * z206
        z213 = z106 * z211 - (mu3 * z212 - z52 * z46)
        z214 = s_beta * z208 + mu3 * z210
        z215 = k1 * z206
        z216 = z106 * z214 - (z1 * z215 + z55 * z49)
        z217 = z106 * z208 - c_beta * z213 - s_beta * z216
        z218 = z19 + z211
        z219 = z24 * z12 + z28 * z218 - c_alpha * z216
        z220 = z12 - z214
        z221 = z24 * z19 - z28 * z220 + c_alpha * z213
        z222 = c_beta * z219 + s_beta * z221
        z223 = r1 * z142
        z224 = r1 * z171
        z225 = z55 * z34 + (z52 * z30 - (z180 + (z223 + (z181 + z224))))
        z226 = r3 * z169
        z227 = z6 * z168
        z228 = w2 * z55 - (z30 * z203 + (2.0 * z226 - (z156 + z227)))
        s15 = z52 * z154 - z144 * z203 - z55 * z146 - z132 * z205
        z229 = s15 - z3 * z228 - z5 * z225
        z230 = w2 * z52 + (z34 * z203 - (z172 + (z148 - 2.0 * z170)))
        z231 = z204 * z175 - 0.5 * (z44 * (z229 - z9 * z230))
        s16 = z27 * z207 - z28 * z217 + z106 * z222
        z232 = s16 - k2 * (z203 * z134 + z2 * z225) + 2.0 * (z5 * z231)
        z233 = z126 * z208 - z129 * z214 - z131 * z211 - mu2 * z222
        z234 = z6 * z52 + (r3 * z203 + (z34 * k6 - r1 * z36 - r1 * z145))
        s17 = r1 * z203 + (z150 - I_c * z30 + r3 * z36 + r3 * z145)
        z235 = z6 * z55 + s17
        s18 = z130 * z220 - z128 * z218 + mu2 * z217 + c_beta * z234
        z236 = s18 - s_beta * z235
        z237 = g * r1
        z238 = mu2 * z207 - z203 * z60 - z26 * z236
        s19 = z131 * z212 - z136 * z210 - z237 - w1 * z238
        z239 = s19 + k3 * (z52 * z134 + z2 * z228)
        z240 = z239 - 2.0 * (z3 * z231)
        s20 = z37 * (z140 * z209 + z24 * z233 + z27 * z236)
        z241 = z130 * z213 - z128 * z216 + s20 - c_beta * z240
        s21 = z98 - (z129 * z215 + z138 * z210) + w3 * z238
        z242 = s21 + k1 * (z55 * z134 - z2 * z230)
        z243 = z242 + 2.0 * (z9 * z231)
        z244 = c_alpha * z232 - mu2 * (z241 + s_beta * z243) - z14 * z201
        z245 = z99 - z202
        z246 = z3 * z245 + z5 * z53 + z9 * z35
        z247 = z43 * z246
        z248 = z2 * z247
        z249 = k2 * z248
        z250 = z7 + (I_c + z10)
        z251 = z110 + c_beta * z250
        z252 = z108 - s_beta * z250
        z253 = z26 * z252
        z254 = c_beta * z251 - z1 * z253
        z255 = k3 * z248
        z256 = z106 * z254 + (mu3 * z255 - z245 * z46)
        z257 = s_beta * z251 + mu3 * z253
        z258 = k1 * z248
        z259 = z106 * z257 + (z1 * z258 - z35 * z49)
        z260 = z106 * z251 - c_beta * z256 - s_beta * z259
        z261 = z250 - z254
        z262 = z122 - z28 * z261 - c_alpha * z259
        z263 = z17 - z257
        z264 = z24 * z250 + z28 * z263 - c_alpha * z256
        z265 = c_beta * z262 - s_beta * z264
        s22 = z30 * z245 - (z153 + (2.0 * z227 + (z156 - z226)))
        z266 = z34 * z35 - s22
        s23 = z237 - (z27 * z249 + z28 * z260 - z106 * z265)
        z267 = s23 + k2 * (z53 * z134 - z2 * z266)
        z268 = w2 * z35 + (z53 * z30 + (z223 + (z182 + z224)))
        s24 = z154 * z245 - z53 * z144 + z35 * z146 - z132 * z247
        z269 = s24 + z3 * z268 + z5 * z266
        s25 = z34 * z53 - (z162 - (z177 + (z163 - 2.0 * z176)))
        z270 = w2 * z245 + s25
        z271 = z246 * z175 - 0.5 * (z44 * (z269 - z9 * z270))
        z272 = z126 * z251 - z129 * z257 - z131 * z254 - mu2 * z265
        z273 = c_beta * z158
        s26 = r3 * z53 - (z157 - I_a * w2 + r1 * z57 - r1 * z155)
        z274 = z6 * z245 + s26
        z275 = r1 * u1
        z276 = r1 * z147
        z277 = z6 * z35 - (r1 * z53 + (z191 + (z188 + z275 - z276)))
        s27 = z273 + z130 * z263 + z128 * z261 + mu2 * z260
        z278 = s27 - c_beta * z274 - s_beta * z277
        z279 = mu2 * z249 - z53 * z60 + z26 * z278
        s28 = z131 * z255 + z136 * z253 - w1 * z279
        z280 = s28 + k3 * (z245 * z134 - z2 * z268) - 2.0 * (z3 * z271)
        s29 = z37 * (z140 * z252 + z24 * z272 + z27 * z278)
        z281 = z130 * z256 - z128 * z259 + s29 + c_beta * z280
        s30 = z195 - (z129 * z258 - z138 * z253) + w3 * z279
        z282 = s30 - k1 * (z35 * z134 + z2 * z270)
        z283 = z282 + 2.0 * (z9 * z271)
        s31 = c_alpha * (z267 - 2.0 * (z5 * z271))
        z284 = s31 - mu2 * (z281 - s_beta * z283) - z18 * z201 + z22 * z244
        z285 = z166 * z284
        z286 = z21 * z244 + z22 * z285
        z287 = z141 * z17
        s32 = z159 - z139 * z107 - z287 - z136 * z109 - z126 * z118
        z288 = s32 + z127 * z124 + z24 * z192
        s33 = z273 + z128 * z107 - z130 * z17 - s_beta * z192
        z289 = s33 - c_beta * z193 - z26 * z185
        z290 = z139 * z17
        s34 = z160 - z141 * z107 + z290 + z138 * z109 + z126 * z115
        z291 = s34 + z127 * z121 - z28 * z192
        s35 = c_beta * (z288 - z28 * z193 - w1 * z289 + c_alpha * z200)
        s36 = s_beta * (z291 - z24 * z193 - w3 * z289 - c_alpha * z198)
        z292 = s35 + s36
        s37 = z139 * z12 - z141 * z19 + z136 * z208 + z126 * z216
        z293 = s37 + z127 * z221 - z24 * z234
        s38 = z128 * z12 + z130 * z19 - s_beta * z234 - c_beta * z235
        z294 = s38 - z26 * z233
        s39 = z141 * z12 + z139 * z19 - z138 * z208 - z126 * z213
        z295 = s39 - z127 * z219 + z28 * z234
        s40 = c_beta * (z293 + z28 * z235 + w1 * z294 + c_alpha * z243)
        s41 = s_beta * (z295 + z24 * z235 + w3 * z294 + c_alpha * z240)
        z296 = s40 + s41
        z297 = z296 + z14 * z292
        s42 = z160 - z290 - z141 * z250 - z136 * z251 - z126 * z259
        z298 = s42 + z127 * z264 - z24 * z274
        s43 = z186 - z128 * z17 + z130 * z250 - s_beta * z274
        z299 = s43 + c_beta * z277 + z26 * z272
        s44 = z159 + z287 - z139 * z250 - z138 * z251 - z126 * z256
        z300 = s44 - z127 * z262 - z28 * z274
        s45 = c_beta * (z298 - z28 * z277 + w1 * z299 + c_alpha * z283)
        s46 = s_beta * (z300 + z24 * z277 - w3 * z299 - c_alpha * z280)
        z301 = s45 - s46
        z302 = z166 * (z301 - z18 * z292 - z22 * z297)
        z303 = z21 * z297 - z22 * z302
        z304 = s_beta * z289 + mu3 * z196
        z305 = s_beta * z294 + mu3 * z238 - z14 * z304
        z306 = z166 * (s_beta * z299 + mu3 * z279 + z18 * z304 - z22 * z305)
        z307 = z21 * z305 - z22 * z306
        s47 = r1 * z31 - (z34 * k5 + z6 * u1 - z6 * z147 + z125)
        z308 = r3 * z101 - s47
        s48 = r1 * z52 - (z190 - (z189 + (z187 - z275) + z276) + z222)
        z309 = r3 * z55 - s48 - z14 * z308
        s49 = z149 + (z150 - I_b * z30) + z6 * z57 - z6 * z155 + z265
        z310 = r3 * z35 + (r1 * z245 + s49)
        z311 = z166 * (z310 - z18 * z308 + z22 * z309)
        z312 = z21 * z309 + z22 * z311
        z313 = c_beta * z289 - z1 * z196
        z314 = c_beta * z294 - z1 * z238 - z14 * z313
        z315 = z166 * (c_beta * z299 - z1 * z279 + z18 * z313 - z22 * z314)
        z316 = z21 * z314 - z22 * z315
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z66 - s_gamma * z65,
            # (I.2.15)
            s_gamma * z81 - c_gamma * z82,
            # (I.2.15)
            s_gamma * z83 + c_gamma * z86,
            # (I.2.15)
            -(s_gamma * z88 + c_gamma * z89),
            # (I.2.15)
            -(s_gamma * z91 + c_gamma * z92),
            # (I.2.15)
            c_gamma * z87 - s_gamma * z93,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_gamma * z66 + c_gamma * z65,
            # (I.2.15)
            -(s_gamma * z82 + c_gamma * z81),
            # (I.2.15)
            s_gamma * z86 - c_gamma * z83,
            # (I.2.15)
            c_gamma * z88 - s_gamma * z89,
            # (I.2.15)
            c_gamma * z91 - s_gamma * z92,
            # (I.2.15)
            s_gamma * z87 + c_gamma * z93,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z85 + c_alpha * z64 - (z84 + mu2 * z51),
            # (I.2.15)
            -(mu2 * z74 + c_alpha * z80),
            0.0,
            # (I.2.15)
            -(mu2 * r3 + c_alpha * z87),
            # (I.2.15)
            -c_alpha * z90,
            # (I.2.15)
            mu2 * r1 - c_alpha * z89,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z41,
            # (I.2.15)
            z68,
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
            z24 + mu2 * z94,
            # (I.2.15)
            mu2 * z95,
            0.0,
            # (I.2.15)
            mu2 * z96,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -mu2 * z97,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z94,
            # (I.2.15)
            -z95,
            0.0,
            # (I.2.15)
            -z96,
            0.0,
            # (I.2.15)
            z97,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z18 * z285 - (z13 * z201 - z14 * z286),
            # (I.2.15)
            z13 * z292 + z14 * z303 - z18 * z302,
            0.0,
            # (I.2.15)
            -(z13 * z304 - z14 * z307 + z18 * z306),
            # (I.2.15)
            z18 * z311 - (z13 * z308 - z14 * z312),
            # (I.2.15)
            z13 * z313 - z14 * z316 + z18 * z315,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z286,
            # (I.2.15)
            -z303,
            0.0,
            # (I.2.15)
            -z307,
            # (I.2.15)
            -z312,
            # (I.2.15)
            z316,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z285,
            # (I.2.15)
            -z302,
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
