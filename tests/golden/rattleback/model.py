"""rattleback, emitted by nhc 0.1.0 (nhc:7c89d422c5e942c3).

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
rhs: 147 +-, 294 *, 7 /, 7 calls
velocities: 17 +-, 46 *, 2 /, 7 calls
accelerations: 187 +-, 318 *, 7 /, 7 calls
state: 3 +-, 7 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 175 +-, 344 *, 7 /, 7 calls
energy: 23 +-, 59 *, 2 /, 7 calls
jacobian: 992 +-, 1593 *, 9 /, 7 calls
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
        k4 = b * b * b * b
        k5 = I_a + h * h
        k6 = a * a * a * a
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "rhs")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        z2 = mu2 * mu2
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3)
        z4 = 1.0 / math.sqrt(z3)
        z5 = c_beta * k3
        z6 = 1.0 - z2
        z7 = z2 * k4
        s1 = z4 * (z5 * (z4 * z5 * z6 - 2.0 * (h * c_alpha)) + z4 * z7)
        z8 = s1 + k5
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "rhs")
        s_gamma = math.sin(gamma)
        z9 = z1 * k1
        r1 = z9 * z4
        z10 = mu3 * k3
        r3 = h - z4 * z10
        z11 = c_beta * r1 + s_beta * r3
        z12 = mu2 * z11
        c_gamma = math.cos(gamma)
        z13 = s_beta * r1 - c_beta * r3
        z14 = s_gamma * z12 + c_gamma * z13
        z15 = c_gamma * z12 - s_gamma * z13
        z16 = c_alpha * z11
        z17 = I_b + (z14 * z14 + z15 * z15 + z16 * z16)
        z18 = mu2 * k2
        z19 = z4 * z18
        z20 = 1.0 / c_alpha
        z21 = s_beta * z20
        z22 = z1 * z21 + c_beta * c_beta
        z23 = z19 * z22
        z24 = c_beta * s_beta
        z25 = mu3 * z21 - z24
        z26 = z19 * z25
        z27 = c_beta * z23 - s_beta * z26
        z28 = r3 * z22 + r1 * z25
        z29 = mu2 * z27 - c_alpha * z28
        z30 = s_beta * z23 + c_beta * z26
        z31 = s_gamma * z29 + c_gamma * z30
        z32 = c_gamma * z29 - s_gamma * z30
        z33 = c_alpha * z27 + mu2 * z28
        z34 = z31 * z14 + z32 * z15 + z33 * z16 + I_d * z22
        z35 = 1.0 / z8
        z36 = z34 * z35
        z37 = z17 - z34 * z36
        # the mass matrix is singular
        if not abs(z37) > 1e-14 * z17:
            raise SingularModelError(2, "rhs")
        z38 = 1.0 / z3
        z39 = s_beta * s_beta
        z40 = I_c + z38 * (z7 + z6 * (z39 * k6))
        z41 = h - z4 * (c_alpha * z5)
        z42 = z4 * (s_beta * (c_alpha * k1)) * z41
        z43 = z42 * z35
        z44 = z19 * z41 + z34 * z43
        z45 = 1.0 / z37
        z46 = z44 * z45
        z47 = z40 - z42 * z43 - z44 * z46
        # the mass matrix is singular
        if not abs(z47) > 1e-14 * z40:
            raise SingularModelError(2, "rhs")
        z48 = s_beta * w1 - c_beta * w3
        z49 = z20 * z48
        z50 = z1 * z49
        z51 = z1 * w3 + mu3 * w1
        z52 = z51 * z20
        omega1 = z50 + c_beta * z52
        z53 = r1 * w2 + z19 * omega1
        z54 = mu3 * z49
        z55 = z54 - s_beta * z52
        z56 = z19 * z55 - r3 * w2
        z57 = c_beta * z53 - s_beta * z56
        z58 = r3 * omega1 + r1 * z55
        e2 = mu2 * z57 - c_alpha * z58
        z59 = s_beta * z53 + c_beta * z56
        z60 = w2 + mu2 * z49
        z61 = I_c * z55
        z62 = c_beta * z60
        z63 = s_beta * z60
        z64 = mu2 * z52
        z65 = c_alpha * z63 + c_beta * z64
        z66 = mu2 * z21
        z67 = c_beta * z66
        z68 = s_beta * z66
        z69 = c_beta * mu2
        s2 = z52 * z67 + z49 * (c_alpha * z68 + c_beta * z69)
        z70 = z61 * (c_beta * z62 + z21 * z65 - s2)
        z71 = z64 / (c_alpha * c_alpha)
        z72 = z48 * z71 + z20 * (w1 * z62 + w3 * z63)
        z73 = s_beta * z64 - c_alpha * z62
        z74 = z20 * (w3 * z73 + w1 * z65) - z51 * z71
        z75 = z49 * z65 - mu3 * z72 + (z52 * z62 - s_beta * z74)
        z76 = I_c * z75
        z77 = I_d * omega1 + I_b * w2
        z78 = I_d * w2 + I_a * omega1
        s3 = z52 * z68 + z49 * (s_beta * z69 - c_alpha * z67)
        z79 = z78 * (c_beta * z63 + z21 * z73 - s3)
        z80 = z49 * z73 - z1 * z72 + (z52 * z63 + c_beta * z74)
        z81 = I_a * z80
        s4 = 2.0 * (k1 * (z1 * z73)) - 2.0 * (k2 * (mu2 * z51))
        z82 = s4 + 2.0 * (k3 * (mu3 * z65))
        z83 = z4 * z82 * z38
        z84 = z4 * (k1 * z73) - 0.5 * (z9 * z83)
        z85 = 0.5 * (z18 * z83) + z4 * (k2 * z51)
        z86 = w2 * z84 - (omega1 * z85 - z19 * z80)
        z87 = 0.5 * (z10 * z83) - z4 * (k3 * z65)
        z88 = z55 * z85 - z19 * z75 + w2 * z87
        z89 = z53 * z63 + c_beta * z86 + (z56 * z62 + s_beta * z88)
        z90 = omega1 * z87 + r3 * z80 + (z55 * z84 + r1 * z75)
        z91 = z57 * z64 + c_alpha * z89 - (z51 * z58 - mu2 * z90)
        z92 = c_gamma * z49
        z93 = z51 * z57 - mu2 * z89 + (z58 * z64 + c_alpha * z90)
        z94 = s_gamma * z49
        z95 = z53 * z62 - s_beta * z86 - (z56 * z63 - c_beta * z88)
        z96 = e2 * z92 - s_gamma * z93 - (z59 * z94 + c_gamma * z95)
        z97 = e2 * z94 + c_gamma * z93 + (z59 * z92 - s_gamma * z95)
        s5 = z79 + (z22 * z81 + (z33 * z91 + (z31 * z96 - z32 * z97)))
        z98 = z77 * (z54 - z51 * z21) - s5
        z99 = z70 + (z25 * z76 - z98) - g * z33
        s6 = z55 * z78 + (z16 * z91 + (z14 * z96 - z15 * z97))
        z100 = omega1 * z61 - (I_d * z80 + s6)
        z101 = z100 + g * z16 + z99 * z36
        z102 = c_beta * z20
        z103 = mu2 * z102
        z104 = c_beta * z103
        z105 = s_beta * z103
        z106 = s_beta * mu2
        s7 = z52 * z104 + z49 * (c_alpha * z105 - c_beta * z106)
        z107 = z61 * (s_beta * z62 - z102 * z65 + s7)
        z108 = mu3 * z102 + z39
        s8 = z52 * z105 - z49 * (s_beta * z106 + c_alpha * z104)
        z109 = z78 * (s_beta * z63 - z102 * z73 + s8)
        z110 = z24 - z1 * z102
        z111 = z19 * z110
        z112 = z19 * z108
        z113 = c_beta * z111 + s_beta * z112
        z114 = r3 * z110 - r1 * z108
        z115 = c_alpha * z113 + mu2 * z114
        z116 = mu2 * z113 - c_alpha * z114
        z117 = s_beta * z111 - c_beta * z112
        s9 = (s_gamma * z116 + c_gamma * z117) * z96
        z118 = z115 * z91 + (s9 - (c_gamma * z116 - s_gamma * z117) * z97)
        s10 = z77 * (z50 + z51 * z102) - (z109 + (z110 * z81 + z118))
        z119 = z107 - (z108 * z76 + s10) - g * z115
        z120 = (z119 + z99 * z43 + z46 * z101) / z47
        z121 = z45 * z101 + z46 * z120
        dydt: list[float] = [
            # x' (I.2.15)
            -(s_gamma * e2 + c_gamma * z59),
            # y' (I.2.15)
            c_gamma * e2 - s_gamma * z59,
            # z' (I.2.15)
            -(c_alpha * z57 + mu2 * z58),
            # alpha' (I.2.15)
            z52,
            # beta' (I.2.15)
            z60,
            # gamma' (I.2.15)
            -z49,
            # w1' (I.2.15) 41:4
            z99 * z35 + z36 * z121 + z43 * z120,
            # w2' (I.2.15) 41:4
            -z121,
            # w3' (I.2.15) 41:4
            z120,
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
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "velocities")
        s_gamma = math.sin(gamma)
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r1 = z1 * k1 * z2
        z3 = z2 * (mu2 * k2)
        z4 = 1.0 / c_alpha
        z5 = z4 * (s_beta * w1 - c_beta * w3)
        z6 = (z1 * w3 + mu3 * w1) * z4
        omega1 = z1 * z5 + c_beta * z6
        z7 = r1 * w2 + z3 * omega1
        z8 = mu3 * z5 - s_beta * z6
        r3 = h - z2 * (mu3 * k3)
        z9 = z3 * z8 - r3 * w2
        z10 = c_beta * z7 - s_beta * z9
        z11 = r3 * omega1 + r1 * z8
        e2 = mu2 * z10 - c_alpha * z11
        c_gamma = math.cos(gamma)
        z12 = s_beta * z7 + c_beta * z9
        qdot: list[float] = [
            # x' (I.2.4)
            -(s_gamma * e2 + c_gamma * z12),
            # y' (I.2.4)
            c_gamma * e2 - s_gamma * z12,
            # z' (I.2.4)
            -(c_alpha * z10 + mu2 * z11),
            # alpha' (I.2.4)
            z6,
            # beta' (I.2.4)
            w2 + mu2 * z5,
            # gamma' (I.2.4)
            -z5,
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
        k4 = b * b * b * b
        k5 = I_a + h * h
        k6 = a * a * a * a
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "accelerations")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        z2 = mu2 * mu2
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3)
        z4 = 1.0 / math.sqrt(z3)
        z5 = c_beta * k3
        z6 = 1.0 - z2
        z7 = z2 * k4
        s1 = z4 * (z5 * (z4 * z5 * z6 - 2.0 * (h * c_alpha)) + z4 * z7)
        z8 = s1 + k5
        # the mass matrix is singular
        if not abs(z8) > 0.0:
            raise SingularModelError(2, "accelerations")
        s_gamma = math.sin(gamma)
        z9 = z1 * k1
        r1 = z9 * z4
        z10 = mu3 * k3
        r3 = h - z4 * z10
        z11 = c_beta * r1 + s_beta * r3
        z12 = mu2 * z11
        c_gamma = math.cos(gamma)
        z13 = s_beta * r1 - c_beta * r3
        z14 = s_gamma * z12 + c_gamma * z13
        z15 = c_gamma * z12 - s_gamma * z13
        z16 = c_alpha * z11
        z17 = I_b + (z14 * z14 + z15 * z15 + z16 * z16)
        z18 = mu2 * k2
        z19 = z4 * z18
        z20 = 1.0 / c_alpha
        z21 = s_beta * z20
        z22 = z1 * z21 + c_beta * c_beta
        z23 = z19 * z22
        z24 = c_beta * s_beta
        z25 = mu3 * z21 - z24
        z26 = z19 * z25
        z27 = c_beta * z23 - s_beta * z26
        z28 = r3 * z22 + r1 * z25
        z29 = mu2 * z27 - c_alpha * z28
        z30 = s_beta * z23 + c_beta * z26
        z31 = s_gamma * z29 + c_gamma * z30
        z32 = c_gamma * z29 - s_gamma * z30
        z33 = c_alpha * z27 + mu2 * z28
        z34 = z31 * z14 + z32 * z15 + z33 * z16 + I_d * z22
        z35 = 1.0 / z8
        z36 = z34 * z35
        z37 = z17 - z34 * z36
        # the mass matrix is singular
        if not abs(z37) > 1e-14 * z17:
            raise SingularModelError(2, "accelerations")
        z38 = 1.0 / z3
        z39 = s_beta * s_beta
        z40 = I_c + z38 * (z7 + z6 * (z39 * k6))
        z41 = h - z4 * (c_alpha * z5)
        z42 = z4 * (s_beta * (c_alpha * k1)) * z41
        z43 = z42 * z35
        z44 = z19 * z41 + z34 * z43
        z45 = 1.0 / z37
        z46 = z44 * z45
        z47 = z40 - z42 * z43 - z44 * z46
        # the mass matrix is singular
        if not abs(z47) > 1e-14 * z40:
            raise SingularModelError(2, "accelerations")
        z48 = s_beta * w1 - c_beta * w3
        z49 = z20 * z48
        z50 = z1 * z49
        z51 = z1 * w3 + mu3 * w1
        z52 = z51 * z20
        omega1 = z50 + c_beta * z52
        z53 = r1 * w2 + z19 * omega1
        z54 = mu3 * z49
        z55 = z54 - s_beta * z52
        z56 = z19 * z55 - r3 * w2
        z57 = c_beta * z53 - s_beta * z56
        z58 = r3 * omega1 + r1 * z55
        e2 = mu2 * z57 - c_alpha * z58
        z59 = c_gamma * z49
        z60 = e2 * z59
        z61 = z51 * z57
        z62 = w2 + mu2 * z49
        z63 = s_beta * z62
        z64 = z53 * z63
        z65 = mu2 * z52
        z66 = c_beta * z62
        z67 = s_beta * z65 - c_alpha * z66
        z68 = c_alpha * z63 + c_beta * z65
        s2 = 2.0 * (k1 * (z1 * z67)) - 2.0 * (k2 * (mu2 * z51))
        z69 = s2 + 2.0 * (k3 * (mu3 * z68))
        z70 = z4 * z69 * z38
        z71 = z4 * (k1 * z67) - 0.5 * (z9 * z70)
        z72 = w2 * z71
        z73 = I_c * z55
        z74 = z49 * z67
        z75 = z65 / (c_alpha * c_alpha)
        z76 = z48 * z75
        z77 = w1 * z66
        z78 = w3 * z63
        z79 = z76 + z20 * (z77 + z78)
        z80 = z52 * z63
        z81 = w3 * z67
        z82 = w1 * z68
        z83 = z51 * z75
        z84 = z20 * (z81 + z82) - z83
        z85 = z74 - z1 * z79 + (z80 + c_beta * z84)
        z86 = I_d * w2 + I_a * omega1
        z87 = z57 * z65
        z88 = 0.5 * (z18 * z70) + z4 * (k2 * z51)
        z89 = omega1 * z88
        z90 = z72 - (z89 - z19 * z85)
        z91 = z56 * z66
        z92 = z55 * z88
        z93 = z49 * z68
        z94 = z52 * z66
        z95 = z93 - mu3 * z79 + (z94 - s_beta * z84)
        z96 = 0.5 * (z10 * z70) - z4 * (k3 * z68)
        z97 = w2 * z96
        z98 = z92 - z19 * z95 + z97
        z99 = z64 + c_beta * z90 + (z91 + s_beta * z98)
        z100 = z51 * z58
        z101 = omega1 * z96
        z102 = z55 * z71
        z103 = z101 + r3 * z85 + (z102 + r1 * z95)
        z104 = z87 + c_alpha * z99 - (z100 - mu2 * z103)
        z105 = z58 * z65
        z106 = z61 - mu2 * z99 + (z105 + c_alpha * z103)
        z107 = s_beta * z53 + c_beta * z56
        z108 = s_gamma * z49
        z109 = z107 * z108
        z110 = z53 * z66
        z111 = z56 * z63
        z112 = z110 - s_beta * z90 - (z111 - c_beta * z98)
        z113 = z60 - s_gamma * z106 - (z109 + c_gamma * z112)
        z114 = e2 * z108
        z115 = z107 * z59
        z116 = z114 + c_gamma * z106 + (z115 - s_gamma * z112)
        s3 = z55 * z86 + (z16 * z104 + (z14 * z113 - z15 * z116))
        z117 = omega1 * z73 - (I_d * z85 + s3)
        z118 = mu2 * z21
        z119 = c_beta * z118
        z120 = s_beta * z118
        z121 = c_beta * mu2
        s4 = z52 * z119 + z49 * (c_alpha * z120 + c_beta * z121)
        z122 = z73 * (c_beta * z66 + z21 * z68 - s4)
        z123 = I_c * z95
        z124 = I_d * omega1 + I_b * w2
        s5 = z52 * z120 + z49 * (s_beta * z121 - c_alpha * z119)
        z125 = z86 * (c_beta * z63 + z21 * z67 - s5)
        z126 = I_a * z85
        s6 = z125 + (z22 * z126 + (z33 * z104 + (z31 * z113 - z32 * z116)))
        z127 = z124 * (z54 - z51 * z21) - s6
        z128 = z122 + (z25 * z123 - z127) - g * z33
        z129 = z117 + g * z16 + z128 * z36
        z130 = c_beta * z20
        z131 = mu2 * z130
        z132 = c_beta * z131
        z133 = s_beta * z131
        z134 = s_beta * mu2
        s7 = z52 * z132 + z49 * (c_alpha * z133 - c_beta * z134)
        z135 = z73 * (s_beta * z66 - z130 * z68 + s7)
        z136 = mu3 * z130 + z39
        s8 = z52 * z133 - z49 * (s_beta * z134 + c_alpha * z132)
        z137 = z86 * (s_beta * z63 - z130 * z67 + s8)
        z138 = z24 - z1 * z130
        z139 = z19 * z138
        z140 = z19 * z136
        z141 = c_beta * z139 + s_beta * z140
        z142 = r3 * z138 - r1 * z136
        z143 = c_alpha * z141 + mu2 * z142
        z144 = mu2 * z141 - c_alpha * z142
        z145 = s_beta * z139 - c_beta * z140
        s9 = (s_gamma * z144 + c_gamma * z145) * z113
        z146 = z143 * z104 + (s9 - (c_gamma * z144 - s_gamma * z145) * z116)
        s10 = z124 * (z50 + z51 * z130) - (z137 + (z138 * z126 + z146))
        z147 = z135 - (z136 * z123 + s10) - g * z143
        z148 = (z147 + z128 * z43 + z46 * z129) / z47
        z149 = z45 * z129 + z46 * z148
        z150 = z128 * z35 + z36 * z149 + z43 * z148
        z151 = z76 + z20 * (z77 + s_beta * z150 + (z78 - c_beta * z148))
        z152 = z83 - z20 * (z81 - z1 * z148 + (z82 - mu3 * z150))
        z153 = z74 - z1 * z151 + (z80 - c_beta * z152)
        z154 = z72 + r1 * z149 - (z89 - z19 * z153)
        z155 = z93 - mu3 * z151 + (z94 + s_beta * z152)
        z156 = z92 - z19 * z155 + (z97 + r3 * z149)
        z157 = z64 + c_beta * z154 + (z91 + s_beta * z156)
        z158 = z101 + r3 * z153 + (z102 + r1 * z155)
        z159 = z61 - mu2 * z157 + (z105 + c_alpha * z158)
        z160 = z110 - s_beta * z154 - (z111 - c_beta * z156)
        qddot: list[float] = [
            # x'' (I.2.15)
            z60 - s_gamma * z159 - (z109 + c_gamma * z160),
            # y'' (I.2.15)
            z114 + c_gamma * z159 + (z115 - s_gamma * z160),
            # z'' (I.2.15)
            z87 + c_alpha * z157 - (z100 - mu2 * z158),
            # alpha'' (I.2.15)
            z152,
            # beta'' (I.2.15)
            z51 * z49 + mu2 * z151 - z149,
            # gamma'' (I.2.15)
            -z151,
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
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        mu2 = math.sin(alpha)
        y: list[float] = [
            x,
            y_2,
            z,
            alpha,
            beta,
            gamma,
            alpha_dot * c_beta - gamma_dot * (c_alpha * s_beta),
            beta_dot + gamma_dot * mu2,
            alpha_dot * s_beta + gamma_dot * (c_beta * c_alpha),
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
        k4 = b * b * b * b
        k5 = I_a + h * h
        k6 = a * a * a * a
        k7 = k1 - k3
        k8 = k2 - k3
        k9 = k1 - k2
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "reactions")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        z2 = mu2 * mu2
        z3 = k2 * z2
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z4 = k1 * (z1 * z1) + z3 + k3 * (mu3 * mu3)
        z5 = 1.0 / math.sqrt(z4)
        z6 = c_beta * k3
        z7 = 1.0 - z2
        z8 = h * c_alpha
        z9 = z2 * k4
        z10 = z5 * (z6 * (z5 * z6 * z7 - 2.0 * z8) + z5 * z9) + k5
        # the mass matrix is singular
        if not abs(z10) > 0.0:
            raise SingularModelError(2, "reactions")
        s_gamma = math.sin(gamma)
        z11 = z1 * k1
        r1 = z11 * z5
        z12 = mu3 * k3
        r3 = h - z5 * z12
        z13 = c_beta * r1 + s_beta * r3
        z14 = mu2 * z13
        c_gamma = math.cos(gamma)
        z15 = s_beta * r1 - c_beta * r3
        z16 = s_gamma * z14 + c_gamma * z15
        z17 = c_gamma * z14 - s_gamma * z15
        z18 = c_alpha * z13
        z19 = I_b + (z16 * z16 + z17 * z17 + z18 * z18)
        z20 = mu2 * k2
        z21 = z5 * z20
        z22 = 1.0 / c_alpha
        z23 = s_beta * z22
        z24 = z1 * z23 + c_beta * c_beta
        z25 = z21 * z24
        z26 = c_beta * s_beta
        z27 = mu3 * z23 - z26
        z28 = z21 * z27
        z29 = c_beta * z25 - s_beta * z28
        z30 = r3 * z24 + r1 * z27
        z31 = mu2 * z29 - c_alpha * z30
        z32 = s_beta * z25 + c_beta * z28
        z33 = s_gamma * z31 + c_gamma * z32
        z34 = c_gamma * z31 - s_gamma * z32
        z35 = c_alpha * z29 + mu2 * z30
        z36 = z33 * z16 + z34 * z17 + z35 * z18 + I_d * z24
        z37 = 1.0 / z10
        z38 = z36 * z37
        z39 = z19 - z36 * z38
        # the mass matrix is singular
        if not abs(z39) > 1e-14 * z19:
            raise SingularModelError(2, "reactions")
        z40 = 1.0 / z4
        z41 = s_beta * s_beta
        z42 = I_c + z40 * (z9 + z7 * (z41 * k6))
        z43 = h - z5 * (c_alpha * z6)
        z44 = z5 * (s_beta * (c_alpha * k1)) * z43
        z45 = z44 * z37
        z46 = z21 * z43 + z36 * z45
        z47 = 1.0 / z39
        z48 = z46 * z47
        z49 = z42 - z44 * z45 - z46 * z48
        # the mass matrix is singular
        if not abs(z49) > 1e-14 * z42:
            raise SingularModelError(2, "reactions")
        z50 = s_beta * w1 - c_beta * w3
        z51 = z22 * z50
        z52 = z1 * z51
        z53 = z1 * w3 + mu3 * w1
        z54 = z53 * z22
        omega1 = z52 + c_beta * z54
        z55 = r1 * w2 + z21 * omega1
        z56 = mu3 * z51
        z57 = z56 - s_beta * z54
        z58 = z21 * z57 - r3 * w2
        z59 = c_beta * z55 - s_beta * z58
        z60 = r3 * omega1 + r1 * z57
        e2 = mu2 * z59 - c_alpha * z60
        z61 = c_gamma * z51
        z62 = w2 + mu2 * z51
        z63 = s_beta * z62
        z64 = mu2 * z54
        z65 = c_beta * z62
        z66 = s_beta * z64 - c_alpha * z65
        z67 = c_alpha * z63 + c_beta * z64
        s1 = 2.0 * (k1 * (z1 * z66)) - 2.0 * (k2 * (mu2 * z53))
        z68 = s1 + 2.0 * (k3 * (mu3 * z67))
        z69 = z5 * z68 * z40
        z70 = z5 * (k1 * z66) - 0.5 * (z11 * z69)
        z71 = 0.5 * (z20 * z69) + z5 * (k2 * z53)
        z72 = z64 / (c_alpha * c_alpha)
        z73 = z50 * z72 + z22 * (w1 * z65 + w3 * z63)
        z74 = z22 * (w3 * z66 + w1 * z67) - z53 * z72
        z75 = z51 * z66 - z1 * z73 + (z54 * z63 + c_beta * z74)
        z76 = w2 * z70 - (omega1 * z71 - z21 * z75)
        z77 = z51 * z67 - mu3 * z73 + (z54 * z65 - s_beta * z74)
        z78 = 0.5 * (z12 * z69) - z5 * (k3 * z67)
        z79 = z57 * z71 - z21 * z77 + w2 * z78
        z80 = z55 * z63 + c_beta * z76 + (z58 * z65 + s_beta * z79)
        z81 = omega1 * z78 + r3 * z75 + (z57 * z70 + r1 * z77)
        z82 = z53 * z59 - mu2 * z80 + (z60 * z64 + c_alpha * z81)
        z83 = s_beta * z55 + c_beta * z58
        z84 = s_gamma * z51
        z85 = z55 * z65 - s_beta * z76 - (z58 * z63 - c_beta * z79)
        z86 = e2 * z61 - s_gamma * z82 - (z83 * z84 + c_gamma * z85)
        z87 = s_beta * s_gamma
        z88 = z3 + k1 * z7
        z89 = mu2 * (c_beta * k2)
        z90 = I_c * z57
        z91 = c_beta * z22
        z92 = mu2 * z91
        z93 = c_beta * z92
        z94 = s_beta * z92
        z95 = s_beta * mu2
        s2 = z54 * z93 + z51 * (c_alpha * z94 - c_beta * z95)
        z96 = z90 * (s_beta * z65 - z91 * z67 + s2)
        z97 = mu3 * z91 + z41
        z98 = I_c * z77
        z99 = I_d * omega1 + I_b * w2
        z100 = I_d * w2 + I_a * omega1
        s3 = z54 * z94 - z51 * (s_beta * z95 + c_alpha * z93)
        z101 = z100 * (s_beta * z63 - z91 * z66 + s3)
        z102 = z26 - z1 * z91
        z103 = I_a * z75
        z104 = z21 * z102
        z105 = z21 * z97
        z106 = c_beta * z104 + s_beta * z105
        z107 = r3 * z102 - r1 * z97
        z108 = c_alpha * z106 + mu2 * z107
        z109 = z59 * z64 + c_alpha * z80 - (z53 * z60 - mu2 * z81)
        z110 = mu2 * z106 - c_alpha * z107
        z111 = s_beta * z104 - c_beta * z105
        z112 = e2 * z84 + c_gamma * z82 + (z83 * z61 - s_gamma * z85)
        s4 = (c_gamma * z110 - s_gamma * z111) * z112
        z113 = z108 * z109 + ((s_gamma * z110 + c_gamma * z111) * z86 - s4)
        s5 = z99 * (z52 + z53 * z91) - (z101 + (z102 * z103 + z113))
        z114 = z96 - (z97 * z98 + s5) - g * z108
        z115 = mu2 * z23
        z116 = c_beta * z115
        z117 = s_beta * z115
        z118 = c_beta * mu2
        s6 = z54 * z116 + z51 * (c_alpha * z117 + c_beta * z118)
        z119 = z90 * (c_beta * z65 + z23 * z67 - s6)
        s7 = z54 * z117 + z51 * (s_beta * z118 - c_alpha * z116)
        z120 = z100 * (c_beta * z63 + z23 * z66 - s7)
        s8 = z120 + (z24 * z103 + (z35 * z109 + (z33 * z86 - z34 * z112)))
        z121 = z99 * (z56 - z53 * z23) - s8
        z122 = z119 + (z27 * z98 - z121) - g * z35
        s9 = z57 * z100 + (z18 * z109 + (z16 * z86 - z17 * z112))
        z123 = omega1 * z90 - (I_d * z75 + s9)
        z124 = z123 + g * z18 + z122 * z38
        z125 = (z114 + z122 * z45 + z48 * z124) / z49
        z126 = c_beta * s_gamma
        z127 = z3 + k3 * z7
        z128 = mu2 * (s_beta * k2)
        z129 = z47 * z124 + z48 * z125
        z130 = z122 * z37 + z38 * z129 + z45 * z125
        z131 = c_alpha * z5
        z132 = s_beta * c_gamma
        z133 = c_beta * c_gamma
        s10 = s_beta * ((z132 + s_gamma * z118) * k7) + k3 * c_gamma
        z134 = z131 * s10 - h * (z133 - s_gamma * z95)
        s11 = (z5 * (z126 * z127 + c_gamma * z128) - s_gamma * z8) * z130
        z135 = z5 * (z87 * z88 - c_gamma * z89) * z125 + (s11 - z134 * z129)
        s12 = z131 * (s_beta * (k7 * (z87 - c_gamma * z118)) + k3 * s_gamma)
        z136 = s12 - h * (z126 + c_gamma * z95)
        s13 = (z5 * (z133 * z127 - s_gamma * z128) - c_gamma * z8) * z130
        z137 = z5 * (z132 * z88 + s_gamma * z89) * z125 + (s13 + z136 * z129)
        z138 = mu3 * z5
        s14 = mu2 * (h + z138 * k8) * z130 - z1 * (h + k7 * z138) * z129
        z139 = z5 * (z1 * mu2) * k9 * z125 - s14
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z86 - z135,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z112 + z137,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z139 - (g - z109),
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
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r1 = z1 * k1 * z2
        z3 = z2 * (mu2 * k2)
        z4 = 1.0 / c_alpha
        z5 = z4 * (s_beta * w1 - c_beta * w3)
        z6 = (z1 * w3 + mu3 * w1) * z4
        omega1 = z1 * z5 + c_beta * z6
        z7 = r1 * w2 + z3 * omega1
        z8 = mu3 * z5 - s_beta * z6
        r3 = h - z2 * (mu3 * k3)
        z9 = z3 * z8 - r3 * w2
        z10 = c_beta * z7 - s_beta * z9
        z11 = r3 * omega1 + r1 * z8
        e2 = mu2 * z10 - c_alpha * z11
        c_gamma = math.cos(gamma)
        z12 = s_beta * z7 + c_beta * z9
        z13 = s_gamma * e2 + c_gamma * z12
        z14 = c_gamma * e2 - s_gamma * z12
        z15 = c_alpha * z10 + mu2 * z11
        s2 = I_a * (omega1 * omega1) + I_b * (w2 * w2) + I_c * (z8 * z8)
        z16 = 0.5 * (z13 * z13 + z14 * z14 + z15 * z15) + 0.5 * s2
        value1 = z16 + w2 * (I_d * omega1) - z * g
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
        k4 = b * b * b * b
        k5 = I_a + h * h
        k6 = a * a * a * a
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "jacobian")
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        z2 = mu2 * mu2
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        z3 = k1 * (z1 * z1) + k2 * z2 + k3 * (mu3 * mu3)
        z4 = 1.0 / math.sqrt(z3)
        z5 = c_beta * k3
        z6 = z4 * z5
        z7 = 1.0 - z2
        z8 = z6 * z7 - 2.0 * (h * c_alpha)
        z9 = z2 * k4
        z10 = z5 * z8 + z4 * z9
        z11 = z4 * z10 + k5
        # the mass matrix is singular
        if not abs(z11) > 0.0:
            raise SingularModelError(2, "jacobian")
        s_gamma = math.sin(gamma)
        z12 = z1 * k1
        r1 = z12 * z4
        z13 = mu3 * k3
        r3 = h - z4 * z13
        z14 = c_beta * r1 + s_beta * r3
        z15 = mu2 * z14
        c_gamma = math.cos(gamma)
        z16 = s_beta * r1 - c_beta * r3
        z17 = s_gamma * z15 + c_gamma * z16
        z18 = c_gamma * z15 - s_gamma * z16
        z19 = c_alpha * z14
        z20 = I_b + (z17 * z17 + z18 * z18 + z19 * z19)
        z21 = mu2 * k2
        z22 = z4 * z21
        z23 = 1.0 / c_alpha
        z24 = s_beta * z23
        z25 = z1 * z24 + c_beta * c_beta
        z26 = z22 * z25
        z27 = c_beta * s_beta
        z28 = mu3 * z24 - z27
        z29 = z22 * z28
        z30 = c_beta * z26 - s_beta * z29
        z31 = r3 * z25 + r1 * z28
        z32 = mu2 * z30 - c_alpha * z31
        z33 = s_beta * z26 + c_beta * z29
        z34 = s_gamma * z32 + c_gamma * z33
        z35 = c_gamma * z32 - s_gamma * z33
        z36 = c_alpha * z30 + mu2 * z31
        z37 = z34 * z17 + z35 * z18 + z36 * z19 + I_d * z25
        z38 = 1.0 / z11
        z39 = z37 * z38
        z40 = z20 - z37 * z39
        # the mass matrix is singular
        if not abs(z40) > 1e-14 * z20:
            raise SingularModelError(2, "jacobian")
        z41 = 1.0 / z3
        z42 = s_beta * s_beta
        z43 = z42 * k6
        z44 = z9 + z7 * z43
        z45 = I_c + z41 * z44
        z46 = c_alpha * k1
        z47 = s_beta * z46
        z48 = z4 * z47
        z49 = c_alpha * z5
        z50 = h - z4 * z49
        z51 = z48 * z50
        z52 = z51 * z38
        z53 = z22 * z50 + z37 * z52
        z54 = 1.0 / z40
        z55 = z53 * z54
        z56 = z45 - z51 * z52 - z53 * z55
        # the mass matrix is singular
        if not abs(z56) > 1e-14 * z45:
            raise SingularModelError(2, "jacobian")
        z57 = s_beta * w1 - c_beta * w3
        z58 = z23 * z57
        z59 = z1 * z58
        z60 = z1 * w3 + mu3 * w1
        z61 = z60 * z23
        omega1 = z59 + c_beta * z61
        z62 = r1 * w2 + z22 * omega1
        z63 = mu3 * z58
        z64 = z63 - s_beta * z61
        z65 = z22 * z64 - r3 * w2
        z66 = c_beta * z62 - s_beta * z65
        z67 = mu2 * s_gamma
        z68 = s_beta * z67 - c_beta * c_gamma
        z69 = c_beta * z67 + s_beta * c_gamma
        z70 = z68 * z64 - z69 * omega1
        z71 = c_alpha * s_gamma
        z72 = z71 * omega1 - z68 * w2
        z73 = z71 * z64 - z69 * w2
        z74 = z4 * (z41 * (z13 * z72 - z21 * z70 - z12 * z73))
        z75 = r3 * omega1 + r1 * z64
        z76 = 1.0 / (c_alpha * c_alpha)
        z77 = r1 * z71 + z22 * z68
        z78 = z22 * z69 - r3 * z71
        z79 = mu3 * z77 - z1 * z78
        z80 = s_beta * z77 + c_beta * z78
        z81 = z80 * z23
        z82 = z77 * z58 - w1 * z81 - k3 * (z4 * z72) + mu3 * (k3 * z74)
        z83 = z78 * z58 + w3 * z81 - k1 * (z4 * z73) - z1 * (k1 * z74)
        s1 = s_gamma * z75 - z76 * (z57 * z79 - z80 * z60) + c_beta * z82
        z84 = mu2 * (s1 - s_beta * z83)
        z85 = z23 * z79
        s2 = c_gamma * z62 - z67 * z65 + z77 * z61 - w1 * z85
        s3 = c_gamma * z65 + z67 * z62 + z78 * z61 + w3 * z85
        s4 = c_beta * (s2 + c_alpha * z83)
        z86 = s4 - s_beta * (s3 - c_alpha * z82)
        e2 = mu2 * z66 - c_alpha * z75
        z87 = s_beta * z62 + c_beta * z65
        z88 = mu2 * c_gamma
        z89 = s_beta * z88 + c_beta * s_gamma
        z90 = c_beta * z88 - s_beta * s_gamma
        z91 = z89 * z64 - z90 * omega1
        z92 = c_alpha * c_gamma
        z93 = z92 * omega1 - z89 * w2
        z94 = z92 * z64 - z90 * w2
        z95 = z4 * (z41 * (z13 * z93 - z21 * z91 - z12 * z94))
        z96 = r1 * z92 + z22 * z89
        z97 = z22 * z90 - r3 * z92
        z98 = mu3 * z96 - z1 * z97
        z99 = s_beta * z96 + c_beta * z97
        z100 = z99 * z23
        z101 = z96 * z58 - w1 * z100 - k3 * (z4 * z93) + mu3 * (k3 * z95)
        z102 = z97 * z58 + w3 * z100 - k1 * (z4 * z94) - z1 * (k1 * z95)
        s5 = c_gamma * z75 - z76 * (z57 * z98 - z99 * z60)
        z103 = mu2 * (s5 + c_beta * z101 - s_beta * z102)
        z104 = z23 * z98
        s6 = s_gamma * z62 + z88 * z65 - z96 * z61 + w1 * z104
        s7 = s_gamma * z65 - z88 * z62 - z97 * z61 - w3 * z104
        s8 = c_beta * (s6 - c_alpha * z102)
        z105 = s8 - s_beta * (s7 + c_alpha * z101)
        z106 = z1 * z64 - mu3 * omega1
        z107 = mu2 * omega1 + z1 * w2
        z108 = mu2 * z64 + mu3 * w2
        z109 = z4 * (z41 * (z13 * z107 + z21 * z106 - z12 * z108))
        z110 = mu2 * r1 - z1 * z22
        z111 = mu3 * z22 + mu2 * r3
        z112 = mu3 * z110 + z1 * z111
        z113 = s_beta * z110 - c_beta * z111
        z114 = z113 * z23
        s9 = z110 * z58 - w1 * z114 - k3 * (z4 * z107)
        z115 = s9 + mu3 * (k3 * z109)
        z116 = z111 * z58 - w3 * z114 + k1 * (z4 * z108) + z1 * (k1 * z109)
        s10 = z66 - z76 * (z57 * z112 - z113 * z60) + c_beta * z115
        s11 = c_alpha * (z75 - k2 * (z4 * z106) + mu2 * (k2 * z109))
        z117 = s11 - mu2 * (s10 + s_beta * z116)
        z118 = z23 * z112
        s12 = c_alpha * z65 + z110 * z61 - w1 * z118 - c_alpha * z116
        s13 = c_alpha * z62 + z111 * z61 - w3 * z118 + c_alpha * z115
        z119 = c_beta * s12 + s_beta * s13
        z120 = c_beta * (w1 * z23)
        z121 = s_beta * (w3 * z23)
        z122 = mu2 * z23
        z123 = c_beta * z23
        z124 = I_c * z64
        z125 = s_gamma * z35 - c_gamma * z34
        z126 = c_gamma * z35 + s_gamma * z34
        z127 = c_alpha * z36 + mu2 * z126
        z128 = mu2 * z36 - c_alpha * z126
        z129 = c_beta * z125 + s_beta * z127
        z130 = I_c * z28 + r1 * z128 - z22 * z129
        z131 = s_beta * z125 - c_beta * z127
        z132 = I_a * z25 + r3 * z128 - z22 * z131
        z133 = mu3 * z130 + z1 * z132
        z134 = z23 * z133
        z135 = I_d * w2 + I_a * omega1
        z136 = s_beta * z130 - c_beta * z132
        z137 = z23 * z136
        z138 = z64 * z128 - w2 * z131
        z139 = omega1 * z128 + w2 * z129
        z140 = z64 * z129 + omega1 * z131
        z141 = 0.5 * (z13 * z139) + 0.5 * (z21 * z140) - 0.5 * (z12 * z138)
        z142 = z41 * z141
        z143 = z4 * z142
        z144 = k1 * z143
        s14 = z24 * z135 + z58 * z132 - w3 * z137 + k1 * (z4 * z138)
        z145 = s14 + 2.0 * (z1 * z144)
        s15 = c_beta * z124 + z62 * z125 + z65 * z127 + z61 * z130
        z146 = s15 - w1 * z134 - c_alpha * z145
        z147 = k3 * z143
        s16 = z24 * z124 + z58 * z130 - w1 * z137 - k3 * (z4 * z139)
        z148 = s16 + 2.0 * (mu3 * z147)
        s17 = c_beta * z135 - z65 * z125 + z62 * z127 + z61 * z132
        z149 = s17 - w3 * z134 + c_alpha * z148
        z150 = c_beta * z146 + s_beta * z149
        z151 = s_gamma * z58
        z152 = c_gamma * z58
        z153 = z35 * z151 - z34 * z152
        z154 = z58 * z135
        z155 = z61 * z124 - c_alpha * z154
        z156 = z58 * z124
        z157 = c_alpha * z156 + z61 * z135
        z158 = c_beta * z155 + s_beta * z157
        z159 = c_beta * z156 + s_beta * z154
        z160 = mu2 * z61
        z161 = w2 + mu2 * z58
        z162 = c_beta * z161
        z163 = s_beta * z160 - c_alpha * z162
        z164 = s_beta * z161
        z165 = c_alpha * z164 + c_beta * z160
        s18 = 2.0 * (k1 * (z1 * z163)) - 2.0 * (k2 * (mu2 * z60))
        z166 = s18 + 2.0 * (k3 * (mu3 * z165))
        z167 = z4 * z166
        z168 = z167 * z41
        z169 = k3 * z165
        z170 = 0.5 * (z13 * z168) - z4 * z169
        z171 = z160 * z76
        z172 = w1 * z162 + w3 * z164
        z173 = z57 * z171 + z23 * z172
        z174 = w3 * z163 + w1 * z165
        z175 = z23 * z174 - z60 * z171
        z176 = z58 * z163 - z1 * z173 + (z61 * z164 + c_beta * z175)
        z177 = k1 * z163
        z178 = z4 * z177 - 0.5 * (z12 * z168)
        z179 = z58 * z165 - mu3 * z173 + (z61 * z162 - s_beta * z175)
        z180 = omega1 * z170 + r3 * z176 + (z64 * z178 + r1 * z179)
        z181 = k2 * z60
        z182 = 0.5 * (z21 * z168) + z4 * z181
        z183 = w2 * z178 - (omega1 * z182 - z22 * z176)
        z184 = z64 * z182 - z22 * z179 + w2 * z170
        z185 = z62 * z164 + c_beta * z183 + (z65 * z162 + s_beta * z184)
        z186 = k2 * z143
        z187 = z57 * z133 - z60 * z136
        s19 = z66 * z36 - z75 * z126 - z76 * z187 + c_beta * z148
        z188 = s19 + s_beta * z145
        z189 = z66 * z160 + c_alpha * z185 - (z60 * z75 - mu2 * z180)
        z190 = z60 * z66 - mu2 * z185 + (z75 * z160 + c_alpha * z180)
        z191 = z62 * z162 - s_beta * z183 - (z65 * z164 - c_beta * z184)
        z192 = e2 * z152 - s_gamma * z190 - (z87 * z151 + c_gamma * z191)
        z193 = e2 * z151 + c_gamma * z190 + (z87 * z152 - s_gamma * z191)
        s20 = z64 * z135 + (z19 * z189 + (z17 * z192 - z18 * z193))
        z194 = omega1 * z124 - (I_d * z176 + s20)
        z195 = mu2 * z24
        z196 = c_beta * z195
        z197 = s_beta * z195
        z198 = c_beta * mu2
        z199 = c_alpha * z197 + c_beta * z198
        z200 = c_beta * z162 + z24 * z165 - (z61 * z196 + z58 * z199)
        z201 = I_c * z179
        z202 = I_d * omega1 + I_b * w2
        z203 = z63 - z60 * z24
        z204 = s_beta * z198 - c_alpha * z196
        z205 = c_beta * z164 + z24 * z163 - (z61 * z197 + z58 * z204)
        z206 = I_a * z176
        s21 = z25 * z206 + (z36 * z189 + (z34 * z192 - z35 * z193))
        z207 = z202 * z203 - (z135 * z205 + s21)
        z208 = z124 * z200 + (z28 * z201 - z207) - g * z36
        z209 = z194 + g * z19 + z208 * z39
        z210 = 1.0 / z56
        z211 = mu2 * z123
        z212 = c_beta * z211
        z213 = s_beta * z211
        z214 = s_beta * mu2
        z215 = c_alpha * z213 - c_beta * z214
        z216 = s_beta * z162 - z123 * z165 + (z61 * z212 + z58 * z215)
        z217 = mu3 * z123 + z42
        z218 = z59 + z60 * z123
        z219 = s_beta * z214 + c_alpha * z212
        z220 = s_beta * z164 - z123 * z163 + (z61 * z213 - z58 * z219)
        z221 = z27 - z1 * z123
        z222 = z22 * z221
        z223 = z22 * z217
        z224 = c_beta * z222 + s_beta * z223
        z225 = r3 * z221 - r1 * z217
        z226 = c_alpha * z224 + mu2 * z225
        z227 = mu2 * z224 - c_alpha * z225
        z228 = s_beta * z222 - c_beta * z223
        z229 = s_gamma * z227 + c_gamma * z228
        z230 = c_gamma * z227 - s_gamma * z228
        s22 = z221 * z206 + (z226 * z189 + (z229 * z192 - z230 * z193))
        z231 = z202 * z218 - (z135 * z220 + s22)
        s23 = z124 * z216 - (z217 * z201 + z231) - g * z226 + z208 * z52
        z232 = z210 * (s23 + z55 * z209)
        z233 = z54 * z209 + z55 * z232
        z234 = z35 * z233
        z235 = z34 * z233
        z236 = c_gamma * z234 + s_gamma * z235
        s24 = c_beta * z159 - z36 * z180 - z185 * z126
        z237 = s24 + 2.0 * (z60 * z186) - z61 * z188 - z14 * z236
        z238 = g - z189
        z239 = z19 * z233
        z240 = z238 - z239
        z241 = z18 * z233
        z242 = z193 - z241
        z243 = z17 * z233
        z244 = z192 + z243
        z245 = c_gamma * z242 - s_gamma * z244
        z246 = z35 * z152 + z34 * z151
        z247 = z36 * z160 - z60 * z126 - mu2 * z153
        z248 = z162 * z125 + z164 * z127 - s_beta * z246 + c_beta * z247
        z249 = z164 * z125 - z162 * z127 + c_beta * z246 + s_beta * z247
        z250 = s_gamma * z242 + c_gamma * z244
        z251 = c_alpha * z240 + mu2 * z245
        z252 = c_beta * z250 + s_beta * z251
        z253 = s_beta * z250 - c_beta * z251
        s25 = z179 * z129 + z176 * z131 - z28 * z252 - z25 * z253
        z254 = omega1 * z248 - (z64 * z249 + s25)
        s26 = z66 * z153 + (z24 * z158 + (z237 + z31 * z240 + z30 * z245))
        z255 = z58 * z150 - s26 + k2 * (0.5 * (z168 * z140) + z4 * z254)
        z256 = z208 * z38 + z39 * z233 + z52 * z232
        z257 = z4 * z256
        z258 = z5 * z257
        z259 = 1.0 / (z3 * z3)
        z260 = z48 * z232
        z261 = z50 * z232
        z262 = z7 * z258
        s27 = z49 * z260 - z47 * z261 + z10 * z256 + z9 * z257 + z5 * z262
        z263 = z169 * z139 + s27
        z264 = z60 * z36 + z160 * z126 - c_alpha * z153
        z265 = s_gamma * z234 - c_gamma * z235
        z266 = z36 * z233
        z267 = c_alpha * z266 + mu2 * z236
        z268 = mu2 * z240 - c_alpha * z245
        s28 = z176 * z128 + c_beta * z265 + s_beta * z267 - z25 * z268
        z269 = w2 * z249 - (omega1 * z264 - s28)
        s29 = z179 * z128 - s_beta * z265 + c_beta * z267 - z28 * z268
        z270 = w2 * z248 - (z64 * z264 - s29)
        s30 = z166 * z142 + (z177 * z138 + (z181 * z140 - z263))
        z271 = s30 - z13 * z269 + z21 * z254 + z12 * z270
        z272 = z167 * z141 * z259 + 0.5 * (z4 * (z41 * z271))
        z273 = 1.0 / (c_alpha * c_alpha * c_alpha)
        z274 = z4 * z260
        z275 = z4 * z261
        s31 = z5 * z274 - k1 * (s_beta * z275) - 2.0 * (h * z258)
        z276 = z196 * z154 - (z197 * z156 + s31)
        s32 = z180 * z126 - (z36 * z185 + z276)
        s33 = z164 * z148 + (2.0 * (z160 * z187 * z273) - s32)
        z277 = z162 * z145 - s33
        s34 = z178 * z128 + z182 * z129 + I_c * z200 - r1 * z264
        z278 = s34 - z22 * z249
        s35 = z124 * z196 + z135 * z197 - z162 * z130 - z164 * z132
        z279 = s35 - mu2 * z188 + s_beta * z278
        s36 = z170 * z128 + z182 * z131 + I_a * z205 - I_d * z203
        z280 = s36 - r3 * z264 + z22 * z248
        z281 = z279 - c_beta * z280
        z282 = z87 * z35 - e2 * z34
        z283 = e2 * z35 + z87 * z34
        s37 = z124 * z199 + z135 * z204 - z165 * z130 - z163 * z132
        z284 = s37 + c_gamma * z282 + s_gamma * z283
        z285 = z202 - z278
        z286 = z284 + mu3 * z285 - z1 * z280 - mu2 * z150
        z287 = mu2 * z158
        z288 = z124 * z165 + z60 * z202 + z135 * z163
        z289 = z201 - r1 * z268 + z22 * z252
        z290 = z206 + I_d * z233 - r3 * z268 + z22 * z253
        z291 = z287 - (z288 + mu3 * z289 + z1 * z290)
        s38 = z57 * z286 + (z172 * z133 + z174 * z136 + s_beta * z291)
        s39 = z75 * z153 - (z277 - z14 * z266 + z30 * z240 - z31 * z245)
        z292 = s39 + z76 * (z60 * z281 + s38)
        s40 = z24 * z202 - z75 * z36 - z66 * z126 + z171 * z136
        z293 = s40 + k2 * (z4 * z140) - 2.0 * (mu2 * z186)
        z294 = z293 - z23 * z281
        s41 = z58 * z285 + (z173 * z130 - 2.0 * (z165 * z147) - z24 * z289)
        z295 = w1 * z294 - s41 + k3 * (0.5 * (z168 * z139) - z4 * z269)
        z296 = z295 - 2.0 * (mu3 * (k3 * z272))
        s42 = z58 * z280 - (z173 * z132 - 2.0 * (z163 * z144) - z24 * z290)
        z297 = w3 * z294 + s42 - k1 * (0.5 * (z168 * z138) - z4 * z270)
        z298 = z297 - 2.0 * (z1 * (k1 * z272))
        s43 = 2.0 * (mu2 * (k4 * (z4 * z257) - z6 * z258 + k2 * z272))
        s44 = mu2 * (z292 + c_beta * z296 + s_beta * z298)
        z299 = c_alpha * (z255 - s43) - s44
        z300 = s_gamma * z18 - c_gamma * z17
        z301 = c_gamma * z18 + s_gamma * z17
        z302 = c_alpha * z19 + mu2 * z301
        z303 = mu2 * z19 - c_alpha * z301
        z304 = c_beta * z300 + s_beta * z302
        z305 = r1 * z303 - z22 * z304
        z306 = s_beta * z300 - c_beta * z302
        z307 = I_d + r3 * z303 - z22 * z306
        z308 = mu3 * z305 + z1 * z307
        z309 = z23 * z308
        z310 = s_beta * z305 - c_beta * z307
        z311 = z23 * z310
        z312 = z64 * z303 - w2 * z306
        z313 = omega1 * z303 + w2 * z304
        z314 = z64 * z304 + omega1 * z306
        z315 = 0.5 * (z13 * z313) + 0.5 * (z21 * z314) - 0.5 * (z12 * z312)
        z316 = z41 * z315
        z317 = z4 * z316
        z318 = k1 * z317
        s45 = z58 * z307 - w3 * z311 + k1 * (z4 * z312)
        z319 = s45 + 2.0 * (z1 * z318)
        s46 = z62 * z300 + z65 * z302 + z61 * z305 - w1 * z309
        z320 = s46 - c_alpha * z319
        z321 = k3 * z317
        s47 = z58 * z305 - w1 * z311 - k3 * (z4 * z313)
        z322 = s47 + 2.0 * (mu3 * z321)
        s48 = z65 * z300 - z62 * z302 - z61 * z307 + w3 * z309
        z323 = s48 - c_alpha * z322
        z324 = c_beta * z320 - s_beta * z323
        z325 = z18 * z151 - z17 * z152
        z326 = k2 * z317
        z327 = z57 * z308 - z60 * z310
        s49 = z66 * z19 - z75 * z301 - z76 * z327 + c_beta * z322
        z328 = s49 + s_beta * z319
        z329 = z193 - 2.0 * z241 + z35 * z256
        z330 = z192 + 2.0 * z243 - z34 * z256
        z331 = c_gamma * z329 - s_gamma * z330
        z332 = z19 * z256
        s50 = z19 * z180 + z185 * z301 - 2.0 * (z60 * z326) + z61 * z328
        z333 = s50 - z14 * z331 - z31 * z332
        z334 = z18 * z256
        z335 = z17 * z256
        z336 = c_gamma * z334 + s_gamma * z335
        z337 = z18 * z152 + z17 * z151
        z338 = z19 * z160 - z60 * z301 - mu2 * z325
        z339 = z162 * z300 + z164 * z302 - s_beta * z337 + c_beta * z338
        z340 = z164 * z300 - z162 * z302 + c_beta * z337 + s_beta * z338
        z341 = s_gamma * z334 - c_gamma * z335
        z342 = c_alpha * z332 + mu2 * z336
        z343 = c_beta * z341 + s_beta * z342
        z344 = s_beta * z341 - c_beta * z342
        s51 = z176 * z306 + (z179 * z304 + z261) - z28 * z343 - z25 * z344
        z345 = omega1 * z339 - (z64 * z340 + s51)
        s52 = z58 * z324 - (z66 * z325 - (z333 - z30 * z336))
        z346 = s52 + k2 * (0.5 * (z168 * z314) + z4 * z345)
        z347 = z22 * z232
        z348 = z60 * z19 + z160 * z301 - c_alpha * z325
        z349 = s_gamma * z329 + c_gamma * z330
        z350 = z238 - 2.0 * z239 + z36 * z256
        z351 = c_alpha * z350 + mu2 * z331
        z352 = mu2 * z332 - c_alpha * z336
        s53 = z176 * z303 - c_beta * z349 - s_beta * z351 - z25 * z352
        z353 = w2 * z340 - (omega1 * z348 - s53)
        s54 = z177 * z312 + (z181 * z314 - (z169 * z313 - z49 * z347))
        z354 = z166 * z316 + s54 - z13 * z353
        s55 = z179 * z303 + s_beta * z349 - c_beta * z351 - z28 * z352
        z355 = w2 * z339 - (z64 * z348 - s55)
        s56 = 0.5 * (z4 * (z41 * (z354 + z21 * z345 + z12 * z355)))
        z356 = z259 * (z167 * z315) + s56
        z357 = z4 * z347
        s57 = z180 * z301 - (z19 * z185 + z5 * z357)
        z358 = z164 * z322 + (2.0 * (z273 * (z160 * z327)) - s57)
        s58 = z135 + z178 * z303 + z182 * z304 - I_c * omega1 - r1 * z348
        z359 = s58 - z22 * z340
        s59 = z124 - z170 * z303 - z182 * z306 - I_a * z64 + r3 * z348
        z360 = s59 - z22 * z339
        s60 = z162 * z305 + z164 * z307 + mu2 * z328 - s_beta * z359
        z361 = s60 - c_beta * z360
        z362 = z87 * z18 - e2 * z17
        z363 = e2 * z18 + z87 * z17
        s61 = z165 * z305 + z163 * z307 - c_gamma * z362 - s_gamma * z363
        z364 = s61 + mu3 * z359 - z1 * z360
        z365 = z364 + mu2 * z324
        z366 = r1 * z352 - z22 * z343
        z367 = I_d * z256 + r3 * z352 - z22 * z344
        z368 = mu3 * z366 + z1 * z367
        s62 = z162 * z319 - z358 + z14 * z350 + z30 * z332 - z31 * z336
        s63 = z57 * z365 - (z172 * z308 + z174 * z310 + s_beta * z368)
        z369 = z75 * z325 - s62 - z76 * (z60 * z361 + s63)
        s64 = z75 * z19 + z66 * z301 - z171 * z310 - k2 * (z4 * z314)
        z370 = s64 + 2.0 * (mu2 * z326)
        z371 = z370 - z23 * z361
        s65 = z58 * z359 - (z173 * z305 - 2.0 * (z165 * z321) + z24 * z366)
        z372 = w1 * z371 - s65 - k3 * (0.5 * (z168 * z313) - z4 * z353)
        z373 = z372 + 2.0 * (mu3 * (k3 * z356))
        s66 = z58 * z360 + (z173 * z307 - 2.0 * (z163 * z318) + z24 * z367)
        z374 = w3 * z371 + s66 + k1 * (0.5 * (z168 * z312) - z4 * z355)
        z375 = z374 + 2.0 * (z1 * (k1 * z356))
        s67 = c_alpha * (z346 - 2.0 * (mu2 * (k2 * z356)))
        z376 = s67 - mu2 * (z369 - c_beta * z373 - s_beta * z375)
        z377 = z376 - z39 * z299
        z378 = c_gamma * z230 + s_gamma * z229
        z379 = mu2 * z226 - c_alpha * z378
        z380 = s_gamma * z230 - c_gamma * z229
        z381 = c_alpha * z226 + mu2 * z378
        z382 = c_beta * z380 + s_beta * z381
        z383 = omega1 * z379 + w2 * z382
        z384 = s_beta * z380 - c_beta * z381
        z385 = z64 * z382 + omega1 * z384
        z386 = z64 * z379 - w2 * z384
        z387 = 0.5 * (z13 * z383) + 0.5 * (z21 * z385) - 0.5 * (z12 * z386)
        z388 = z41 * z387
        z389 = z4 * z388
        z390 = k2 * z389
        z391 = I_c * z217 - r1 * z379 + z22 * z382
        z392 = I_a * z221 + r3 * z379 - z22 * z384
        z393 = mu3 * z391 - z1 * z392
        z394 = s_beta * z391 + c_beta * z392
        z395 = z57 * z393 - z60 * z394
        z396 = z23 * z394
        z397 = k3 * z389
        s68 = z123 * z124 + z58 * z391 - w1 * z396 + k3 * (z4 * z383)
        z398 = s68 - 2.0 * (mu3 * z397)
        z399 = k1 * z389
        s69 = z123 * z135 - z58 * z392 - w3 * z396 - k1 * (z4 * z386)
        z400 = s69 - 2.0 * (z1 * z399)
        s70 = z66 * z226 - z75 * z378 + z76 * z395 - c_beta * z398
        z401 = s70 - s_beta * z400
        s71 = s_beta * z159 - z226 * z180 - z185 * z378
        z402 = s71 + 2.0 * (z60 * z390) - z61 * z401 + z225 * z238
        z403 = c_gamma * z193 - s_gamma * z192
        z404 = z230 * z151 - z229 * z152
        z405 = z23 * z393
        s72 = s_beta * z124 + z62 * z380 + z65 * z381 - z61 * z391
        z406 = s72 + w1 * z405 + c_alpha * z400
        s73 = s_beta * z135 - z65 * z380 + z62 * z381 + z61 * z392
        z407 = s73 + w3 * z405 - c_alpha * z398
        z408 = c_beta * z406 + s_beta * z407
        z409 = z230 * z152 + z229 * z151
        z410 = z226 * z160 - z60 * z378 - mu2 * z404
        z411 = z162 * z380 + z164 * z381 - s_beta * z409 + c_beta * z410
        z412 = z164 * z380 - z162 * z381 + c_beta * z409 + s_beta * z410
        z413 = s_gamma * z193 + c_gamma * z192
        z414 = c_alpha * z238 + mu2 * z403
        z415 = s_beta * z413 - c_beta * z414
        z416 = c_beta * z413 + s_beta * z414
        s74 = z217 * z416 + (z176 * z384 + (z179 * z382 - z50 * z233))
        z417 = z64 * z412 - (z221 * z415 - s74)
        z418 = omega1 * z411 - z417
        s75 = z402 + z224 * z403 - z123 * z158 + z66 * z404 - z58 * z408
        z419 = s75 - k2 * (0.5 * (z168 * z385) + z4 * z418)
        z420 = z41 * z232
        z421 = mu2 * z238 - c_alpha * z403
        z422 = z60 * z226 + z160 * z378 - c_alpha * z404
        z423 = z179 * z379 + z217 * z421 - z64 * z422 + w2 * z411
        z424 = z176 * z379 - z221 * z421 - omega1 * z422 + w2 * z412
        z425 = z22 * z233 + z48 * z256
        z426 = z50 * z256
        s76 = z181 * z385 - (z169 * z383 + (z49 * z425 - z47 * z426))
        z427 = z166 * z388 + (z177 * z386 + s76)
        s77 = z4 * (z41 * (z12 * z423 - (z13 * z424 - z427 - z21 * z418)))
        z428 = z259 * (z167 * z387 - z44 * z232) + 0.5 * s77
        z429 = z201 - r1 * z421 + z22 * z416
        z430 = z206 - r3 * z421 + z22 * z415
        z431 = z287 - (z288 + mu3 * z429 + z1 * z430)
        z432 = z87 * z230 - e2 * z229
        z433 = e2 * z230 + z87 * z229
        s78 = z124 * z215 - z135 * z219 - z165 * z391 + z163 * z392
        z434 = s78 - c_gamma * z432 - s_gamma * z433
        s79 = z178 * z379 + z182 * z382 + I_c * z216 - r1 * z422
        z435 = s79 - z22 * z412
        s80 = z170 * z379 + z182 * z384 + I_a * z220 - I_d * z218
        z436 = s80 - r3 * z422 + z22 * z411
        z437 = z202 - z436
        z438 = z434 + mu3 * z435 - z1 * z437 + mu2 * z408
        s81 = z124 * z212 + z135 * z213 - z162 * z391 + z164 * z392
        z439 = s81 + mu2 * z401 - s_beta * z435
        z440 = z439 + c_beta * z436
        z441 = z4 * z425
        z442 = z4 * z426
        s82 = z213 * z156 - (z5 * z441 - k1 * (s_beta * z442))
        z443 = z180 * z378 - (z226 * z185 - (z212 * z154 - s82))
        s83 = z164 * z398 + (2.0 * (z273 * (z160 * z395)) + z443)
        z444 = z225 * z403 - (z224 * z238 - (z162 * z400 - s83))
        s84 = z172 * z393 + z174 * z394 + c_beta * z431 + z57 * z438
        z445 = z76 * (s84 + z60 * z440) - (z75 * z404 + z444)
        s85 = z123 * z202 + z75 * z226 + z66 * z378 + z171 * z394
        z446 = s85 - k2 * (z4 * z385) + 2.0 * (mu2 * z390)
        z447 = z446 - z23 * z440
        s86 = z173 * z391 + 2.0 * (z165 * z397) - z123 * z429 + z58 * z435
        z448 = s86 - w1 * z447 + k3 * (0.5 * (z168 * z383) - z4 * z424)
        z449 = z448 - 2.0 * (mu3 * (k3 * z428))
        s87 = z173 * z392 - 2.0 * (z163 * z399) + z123 * z430 + z58 * z437
        z450 = s87 + w3 * z447 + k1 * (0.5 * (z168 * z386) - z4 * z423)
        z451 = z450 + 2.0 * (z1 * (k1 * z428))
        s88 = z419 + 2.0 * (mu2 * ((k4 - z43) * z420 + k2 * z428))
        z452 = c_alpha * s88 - mu2 * (z445 - c_beta * z449 + s_beta * z451)
        z453 = z210 * (z452 - z52 * z299 + z55 * z377)
        z454 = z54 * z377 + z55 * z453
        z455 = z171 * z133 + z23 * z286
        s89 = z183 * z125 + (z195 * z157 + (z198 * z154 - z46 * z275))
        z456 = z175 * z130 - (z184 * z127 - s89)
        s90 = z161 * z149 + (z160 * z145 - z456) - r1 * z265 + r3 * z267
        z457 = s90 + z26 * z250 + z29 * z251
        s91 = z62 * z246 - (z457 - c_beta * z289 - z23 * z291)
        z458 = w1 * z455 + (z61 * z278 + (z65 * z247 + s91))
        z459 = mu2 * z159
        z460 = z135 * z164
        z461 = z124 * z162
        s92 = z461 - k3 * (c_alpha * z274 + z8 * z257 + z4 * z262)
        z462 = z195 * z155 - (z460 - (z198 * z156 - s92))
        s93 = z175 * z132 + (z183 * z127 + (z184 * z125 - (z459 + z462)))
        z463 = z161 * z146 + (z160 * z148 + s93)
        s94 = z463 + r3 * z265 + r1 * z267 + z29 * z250 - s_beta * z289
        z464 = s94 - z26 * z251 + 2.0 * (c_beta * z290)
        s95 = w3 * z455 + (z61 * z280 + (z62 * z247 - (z65 * z246 - z464)))
        z465 = s_beta * (s95 + c_alpha * z296)
        z466 = c_beta * (z458 - c_alpha * z298) + z465
        z467 = z171 * z308 - z23 * z365
        s96 = z183 * z300 - z184 * z302 + z175 * z305 - z160 * z319
        z468 = s96 + z161 * z323 - r1 * z349
        s97 = z468 + r3 * z351 - z26 * z341 - z29 * z342 - c_beta * z366
        z469 = z62 * z337 + (s97 + z23 * z368)
        s98 = z183 * z302 + (z184 * z300 + k3 * (c_alpha * z357))
        z470 = z161 * z320 + (z160 * z322 + (z175 * z307 + s98))
        s99 = z470 - r3 * z349 - r1 * z351 + z29 * z341 + s_beta * z366
        z471 = s99 - z26 * z342 - 2.0 * (c_beta * z367)
        s100 = w3 * z467 - (z61 * z360 - (z62 * z338 - (z65 * z337 - z471)))
        z472 = s_beta * (s100 - c_alpha * z373)
        s101 = w1 * z467 + (z61 * z359 + (z65 * z338 + z469))
        z473 = c_beta * (s101 + c_alpha * z375) + z472 - z39 * z466
        z474 = z171 * z393 + z23 * z438
        s102 = z459 + (z214 * z154 - (z460 + (z461 + z46 * z442)))
        z475 = z184 * z381 - (z183 * z380 - (z211 * z157 - s102))
        s103 = z161 * z407 - (z160 * z400 - (z175 * z391 + z475))
        s104 = 2.0 * (s_beta * (z429 + k6 * (z7 * z420)))
        z476 = z223 * z414 - (z222 * z413 + s103) + s104
        s105 = z65 * z410 + (z62 * z409 - (c_beta * z430 - z476))
        z477 = w1 * z474 - (z61 * z435 + s105) - c_alpha * z451
        s106 = z211 * z155 - (z214 * z156 + k3 * (c_alpha * z441))
        z478 = z175 * z392 + (z183 * z381 + (z184 * z380 + s106))
        s107 = z223 * z413 - (z161 * z406 - (z160 * z398 - z478))
        z479 = s_beta * z430 + (z23 * z431 - (z222 * z414 + s107))
        s108 = w3 * z474 - (z61 * z436 + (z62 * z410 - (z65 * z409 - z479)))
        z480 = s_beta * (s108 - c_alpha * z449)
        z481 = z210 * (c_beta * z477 + z480 - z52 * z466 + z55 * z473)
        z482 = z54 * z473 + z55 * z481
        s109 = z35 * z191 - z34 * z190 - z58 * z283 - z16 * z234
        z483 = s109 + z15 * z235 + z33 * z242
        s110 = z35 * z190 + z34 * z191 + z58 * z282 - z15 * z234
        z484 = s110 - z16 * z235 + z32 * z242
        s111 = c_gamma * (z483 + z32 * z244)
        z485 = s111 + s_gamma * (z484 - z33 * z244)
        s112 = z18 * z191 - z17 * z190 - z58 * z363 + z16 * z329
        z486 = s112 + z15 * z330 + z33 * z334
        s113 = z18 * z190 + z17 * z191 + z58 * z362 + z15 * z329
        z487 = s113 - z16 * z330 + z32 * z334
        s114 = c_gamma * (z486 - z32 * z335)
        z488 = s114 + s_gamma * (z487 + z33 * z335) - z39 * z485
        s115 = z230 * z191 - z229 * z190 - z58 * z433 + z228 * z193
        s116 = z230 * z190 + z229 * z191 + z58 * z432 + z227 * z193
        s117 = c_gamma * (s115 + z227 * z192)
        z489 = s117 + s_gamma * (s116 - z228 * z192)
        z490 = z210 * (z489 + z52 * z485 - z55 * z488)
        z491 = z54 * z488 - z55 * z490
        z492 = z162 * z134 + z165 * z137 + s_beta * z455 - mu3 * z294
        s118 = z162 * z309 + z165 * z311 + s_beta * z467 + mu3 * z371
        z493 = s118 - z39 * z492
        s119 = z162 * z405 + z165 * z396 + s_beta * z474 - mu3 * z447
        z494 = s119 - z52 * z492 + z55 * z493
        z495 = z210 * z494
        z496 = z54 * z493 + z55 * z495
        s120 = z170 * z129 - z178 * z131 - I_b * z203 + I_d * z205
        z497 = s120 + r3 * z249 + r1 * z248
        z498 = z150 + z497
        s121 = z170 * z304 - z178 * z306 + I_d * z64 + r3 * z340
        z499 = z324 + (s121 + r1 * z339) - z39 * z498
        s122 = z170 * z382 - z178 * z384 - I_b * z218 + I_d * z220
        z500 = s122 + r3 * z412 + r1 * z411
        z501 = z210 * (z408 + z500 + z52 * z498 - z55 * z499)
        z502 = z54 * z499 - z55 * z501
        z503 = z164 * z134 + z163 * z137 - c_beta * z455 - z1 * z294
        s123 = z164 * z309 + z163 * z311 - c_beta * z467 + z1 * z371
        z504 = s123 - z39 * z503
        s124 = z164 * z405 + z163 * z396 - c_beta * z474 - z1 * z447
        z505 = s124 - z52 * z503 + z55 * z504
        z506 = z210 * z505
        z507 = z54 * z504 + z55 * z506
        s125 = c_alpha * (s_gamma * z66 - k2 * (z4 * z70) - mu2 * (k2 * z74))
        s126 = c_alpha * (c_gamma * z66 - k2 * (z4 * z91) - mu2 * (k2 * z95))
        J: list[float] = [
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -(s125 + z84),
            # (I.2.15)
            -z86,
            # (I.2.15)
            s_gamma * z87 - c_gamma * e2,
            # (I.2.15)
            s_beta * z85 - mu3 * z81,
            # (I.2.15)
            -(r1 * z69 + r3 * z68),
            # (I.2.15)
            -(c_beta * z85 + z1 * z81),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s126 + z103,
            # (I.2.15)
            -z105,
            # (I.2.15)
            -(s_gamma * e2 + c_gamma * z87),
            # (I.2.15)
            mu3 * z100 - s_beta * z104,
            # (I.2.15)
            r1 * z90 + r3 * z89,
            # (I.2.15)
            c_beta * z104 + z1 * z100,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z117,
            # (I.2.15)
            z119,
            # (I.2.15)
            0.0,
            # (I.2.15)
            mu3 * z114 - s_beta * z118,
            # (I.2.15)
            -(mu3 * r1 + z1 * r3),
            # (I.2.15)
            c_beta * z118 + z1 * z114,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            mu2 * (z60 * z76 - z120 - z121),
            # (I.2.15)
            -z57,
            # (I.2.15)
            0.0,
            # (I.2.15)
            c_beta,
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_beta,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z57 + mu2 * (z76 * (mu2 * z57)),
            # (I.2.15)
            c_beta * (w1 * z122) + s_beta * (w3 * z122),
            # (I.2.15)
            0.0,
            # (I.2.15)
            s_beta * z122,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -c_beta * z122,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -mu2 * (z57 * z76),
            # (I.2.15)
            -(z120 + z121),
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z24,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z123,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z38 * z299 - z39 * z454 - z52 * z453,
            # (I.2.15)
            z52 * z481 - (z38 * z466 - z39 * z482),
            # (I.2.15)
            z38 * z485 - z39 * z491 + z52 * z490,
            # (I.2.15)
            z52 * z495 - (z38 * z492 - z39 * z496),
            # (I.2.15)
            z38 * z498 - z39 * z502 + z52 * z501,
            # (I.2.15)
            z52 * z506 - (z38 * z503 - z39 * z507),
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            z454,
            # (I.2.15)
            -z482,
            # (I.2.15)
            z491,
            # (I.2.15)
            -z496,
            # (I.2.15)
            z502,
            # (I.2.15)
            -z507,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z453,
            # (I.2.15)
            z481,
            # (I.2.15)
            z490,
            # (I.2.15)
            z495,
            # (I.2.15)
            z501,
            # (I.2.15)
            z506,
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
        if not abs(-c_alpha) > 1e-12 * 4.0:
            raise SingularModelError(1, "outputs")
        out: list[float] = [
            # spin 53:9
            w3,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
