"""rattleback, emitted by nhc 0.1.0 (nhc:2c5e74242f6954ff).

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
rhs: 147 +-, 282 *, 7 /, 7 calls
velocities: 17 +-, 46 *, 2 /, 7 calls
accelerations: 64 +-, 121 *, 4 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 88 +-, 167 *, 4 /, 7 calls
energy: 23 +-, 58 *, 2 /, 7 calls
jacobian: 1269 +-, 1933 *, 9 /, 7 calls
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
        if not abs(c_alpha) > 1e-12 * 4.0:
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
        z6 = z4 * z5
        z7 = 1.0 - z2
        z8 = z2 * k4
        z9 = z4 * (z5 * (z6 * z7 - 2.0 * (h * c_alpha)) + z4 * z8) + k5
        # the mass matrix is singular
        if not abs(z9) > 0.0:
            raise SingularModelError(2, "rhs")
        z10 = z1 * k1
        r1 = z10 * z4
        z11 = mu3 * k3
        r3 = h - z4 * z11
        z12 = c_beta * r1 + s_beta * r3
        z13 = c_alpha * z12
        s_gamma = math.sin(gamma)
        z14 = mu2 * z12
        c_gamma = math.cos(gamma)
        z15 = s_beta * r1 - c_beta * r3
        z16 = s_gamma * z14 + c_gamma * z15
        z17 = c_gamma * z14 - s_gamma * z15
        z18 = I_b + (z13 * z13 + (z16 * z16 + z17 * z17))
        z19 = 1.0 / c_alpha
        z20 = s_beta * z19
        z21 = z1 * z20 + c_beta * c_beta
        z22 = mu2 * k2
        z23 = z4 * z22
        z24 = z23 * z21
        z25 = c_beta * s_beta
        z26 = mu3 * z20 - z25
        z27 = z23 * z26
        z28 = c_beta * z24 - s_beta * z27
        z29 = r3 * z21 + r1 * z26
        z30 = c_alpha * z28 + mu2 * z29
        z31 = mu2 * z28 - c_alpha * z29
        z32 = s_beta * z24 + c_beta * z27
        z33 = s_gamma * z31 + c_gamma * z32
        z34 = c_gamma * z31 - s_gamma * z32
        z35 = I_d * z21 + (z30 * z13 + (z33 * z16 + z34 * z17))
        z36 = 1.0 / z9
        z37 = z35 * z36
        z38 = z18 - z35 * z37
        # the mass matrix is singular
        if not abs(z38) > 1e-14 * z18:
            raise SingularModelError(2, "rhs")
        z39 = 1.0 / z3
        z40 = s_beta * s_beta
        z41 = I_c + z39 * (z8 + k6 * (z40 * z7))
        z42 = h - c_alpha * z6
        z43 = r1 * z42
        z44 = z36 * z43
        z45 = z23 * z42 + z35 * z44
        z46 = 1.0 / z38
        z47 = z46 * z45
        z48 = z41 - z43 * z44 - z45 * z47
        # the mass matrix is singular
        if not abs(z48) > 1e-14 * z41:
            raise SingularModelError(2, "rhs")
        z49 = s_beta * w1 - c_beta * w3
        z50 = z19 * z49
        z51 = z1 * z50
        z52 = z1 * w3 + mu3 * w1
        z53 = z52 * z19
        omega1 = z51 + c_beta * z53
        z54 = r1 * w2 + z23 * omega1
        z55 = mu3 * z50
        z56 = z55 - s_beta * z53
        z57 = z23 * z56 - r3 * w2
        z58 = c_beta * z54 - s_beta * z57
        z59 = r3 * omega1 + r1 * z56
        e2 = mu2 * z58 - c_alpha * z59
        z60 = s_beta * z54 + c_beta * z57
        z61 = w2 + mu2 * z50
        z62 = s_beta * z61
        z63 = mu2 * z53
        z64 = c_alpha * z62 + c_beta * z63
        z65 = z63 / (c_alpha * c_alpha)
        z66 = c_beta * z61
        z67 = z49 * z65 + z19 * (w1 * z66 + w3 * z62)
        z68 = s_beta * z63 - c_alpha * z66
        z69 = z19 * (w3 * z68 + w1 * z64) - z52 * z65
        z70 = z50 * z64 - mu3 * z67 + (z53 * z66 - s_beta * z69)
        z71 = mu2 * z20
        z72 = c_beta * z71
        z73 = s_beta * z71
        z74 = c_beta * mu2
        s1 = z53 * z72 + z50 * (c_alpha * z73 + c_beta * z74)
        z75 = z56 * (c_beta * z66 + z20 * z64 - s1)
        z76 = I_d * omega1 + I_b * w2
        z77 = I_d * w2 + I_a * omega1
        s2 = z53 * z73 + z50 * (s_beta * z74 - c_alpha * z72)
        z78 = z77 * (c_beta * z62 + z20 * z68 - s2)
        z79 = z39 * (z4 * (z10 * z68 - z22 * z52 + z11 * z64))
        z80 = k1 * (z4 * z68) - z10 * z79
        z81 = z50 * z68 - z1 * z67 + (z53 * z62 + c_beta * z69)
        z82 = z22 * z79 + k2 * (z4 * z52)
        z83 = w2 * z80 + (z23 * z81 - omega1 * z82)
        z84 = z11 * z79 - k3 * (z4 * z64)
        z85 = z23 * z70 - z56 * z82 - w2 * z84
        z86 = z54 * z62 + c_beta * z83 + (z57 * z66 - s_beta * z85)
        z87 = r3 * z81 + omega1 * z84 + (r1 * z70 + z56 * z80)
        z88 = z58 * z63 + c_alpha * z86 - (z52 * z59 - mu2 * z87)
        z89 = c_gamma * z50
        z90 = z52 * z58 - mu2 * z86 + (z59 * z63 + c_alpha * z87)
        z91 = s_gamma * z50
        z92 = z54 * z66 - s_beta * z83 - (z57 * z62 + c_beta * z85)
        z93 = e2 * z89 - s_gamma * z90 - (z60 * z91 + c_gamma * z92)
        z94 = e2 * z91 + c_gamma * z90 + (z60 * z89 - s_gamma * z92)
        z95 = I_a * z81
        s3 = z78 + (z30 * z88 + (z33 * z93 - z34 * z94))
        z96 = z76 * (z55 - z52 * z20) - s3 - z21 * z95
        z97 = g * z30 - (I_c * (z26 * z70 + z75) - z96)
        s4 = z56 * z77 + (z13 * z88 + (z16 * z93 - z17 * z94))
        z98 = I_c * (omega1 * z56) - (I_d * z81 + s4)
        z99 = g * z13 + z98 - z37 * z97
        z100 = c_beta * z19
        z101 = z25 - z1 * z100
        z102 = z23 * z101
        z103 = mu3 * z100 + z40
        z104 = z23 * z103
        z105 = c_beta * z102 + s_beta * z104
        z106 = r3 * z101 - r1 * z103
        z107 = c_alpha * z105 + mu2 * z106
        z108 = mu2 * z100
        z109 = c_beta * z108
        z110 = s_beta * z108
        z111 = s_beta * mu2
        s5 = z53 * z109 + z50 * (c_alpha * z110 - c_beta * z111)
        z112 = z56 * (s_beta * z66 - z100 * z64 + s5)
        s6 = z53 * z110 - z50 * (s_beta * z111 + c_alpha * z109)
        z113 = z77 * (s_beta * z62 - z100 * z68 + s6)
        z114 = mu2 * z105 - c_alpha * z106
        z115 = s_beta * z102 - c_beta * z104
        s7 = (s_gamma * z114 + c_gamma * z115) * z93
        z116 = z107 * z88 + (s7 - (c_gamma * z114 - s_gamma * z115) * z94)
        s8 = z76 * (z51 + z52 * z100) - (z113 + z116) - z101 * z95
        z117 = I_c * (z103 * z70 - z112) + s8
        z118 = (g * z107 + z117 + z97 * z44 - z47 * z99) / z48
        z119 = z46 * z99 - z47 * z118
        dydt: list[float] = [
            # x' (I.2.15)
            -(s_gamma * e2 + c_gamma * z60),
            # y' (I.2.15)
            c_gamma * e2 - s_gamma * z60,
            # z' (I.2.15)
            -(c_alpha * z58 + mu2 * z59),
            # alpha' (I.2.15)
            z53,
            # beta' (I.2.15)
            z61,
            # gamma' (I.2.15)
            -z50,
            # w1' (I.2.15) 41:4
            -(z36 * z97 - z37 * z119 + z44 * z118),
            # w2' (I.2.15) 41:4
            -z119,
            # w3' (I.2.15) 41:4
            -z118,
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
    dydt = rhs(t, y, p)
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
    w1_dot = float(dydt[6])  # w1'
    w2_dot = float(dydt[7])  # w2'
    w3_dot = float(dydt[8])  # w3'
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # state
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        z2 = z1 * k1
        mu3 = c_beta * c_alpha
        z3 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z4 = 1.0 / math.sqrt(z3)
        r1 = z2 * z4
        z5 = mu2 * k2
        z6 = z4 * z5
        z7 = 1.0 / c_alpha
        z8 = s_beta * w1 - c_beta * w3
        z9 = z7 * z8
        z10 = z1 * w3 + mu3 * w1
        z11 = z10 * z7
        omega1 = z1 * z9 + c_beta * z11
        z12 = r1 * w2 + z6 * omega1
        z13 = mu3 * z9 - s_beta * z11
        z14 = mu3 * k3
        r3 = h - z4 * z14
        z15 = z6 * z13 - r3 * w2
        z16 = c_beta * z12 - s_beta * z15
        z17 = r3 * omega1 + r1 * z13
        e2 = mu2 * z16 - c_alpha * z17
        c_gamma = math.cos(gamma)
        z18 = c_gamma * z9
        s_gamma = math.sin(gamma)
        z19 = w2 + mu2 * z9
        z20 = s_beta * z19
        z21 = mu2 * z11
        z22 = c_beta * z19
        z23 = s_beta * z21 - c_alpha * z22
        z24 = c_alpha * z20 + c_beta * z21
        z25 = z4 * (z2 * z23 - z5 * z10 + z14 * z24) / z3
        z26 = k1 * (z4 * z23) - z2 * z25
        z27 = z5 * z25 + k2 * (z4 * z10)
        z28 = z21 / (c_alpha * c_alpha)
        s1 = w1 * z22 + s_beta * w1_dot + (w3 * z20 - c_beta * w3_dot)
        z29 = z8 * z28 + z7 * s1
        s2 = z7 * (w3 * z23 - z1 * w3_dot + (w1 * z24 - mu3 * w1_dot))
        z30 = z10 * z28 - s2
        z31 = z9 * z23 - z1 * z29 + (z11 * z20 - c_beta * z30)
        z32 = w2 * z26 - r1 * w2_dot - (omega1 * z27 - z6 * z31)
        z33 = z9 * z24 - mu3 * z29 + (z11 * z22 + s_beta * z30)
        z34 = z14 * z25 - k3 * (z4 * z24)
        z35 = z13 * z27 - z6 * z33 + (w2 * z34 - r3 * w2_dot)
        z36 = z12 * z20 + c_beta * z32 + (z15 * z22 + s_beta * z35)
        z37 = omega1 * z34 + r3 * z31 + (z13 * z26 + r1 * z33)
        z38 = z10 * z16 - mu2 * z36 + (z17 * z21 + c_alpha * z37)
        z39 = s_beta * z12 + c_beta * z15
        z40 = s_gamma * z9
        z41 = z12 * z22 - s_beta * z32 - (z15 * z20 - c_beta * z35)
        qddot: list[float] = [
            # x'' (I.2.15)
            e2 * z18 - s_gamma * z38 - (z39 * z40 + c_gamma * z41),
            # y'' (I.2.15)
            e2 * z40 + c_gamma * z38 + (z39 * z18 - s_gamma * z41),
            # z'' (I.2.15)
            z16 * z21 + c_alpha * z36 - (z10 * z17 - mu2 * z37),
            # alpha'' (I.2.15)
            z30,
            # beta'' (I.2.15)
            w2_dot + (z10 * z9 + mu2 * z29),
            # gamma'' (I.2.15)
            -z29,
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
    dydt = rhs(t, y, p)
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
    g = float(p[8])  # acceleration of gravity [cm/s^2]
    w1_dot = float(dydt[6])  # w1'
    w2_dot = float(dydt[7])  # w2'
    w3_dot = float(dydt[8])  # w3'
    try:
        # parameters only
        k1 = a * a
        k2 = b * b
        k3 = c * c
        k4 = k1 - k3
        k5 = k2 - k3
        k6 = k1 - k2
        # state
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        c_alpha = math.cos(alpha)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        z2 = z1 * k1
        z3 = mu2 * mu2
        z4 = k2 * z3
        mu3 = c_beta * c_alpha
        z5 = k1 * (z1 * z1) + z4 + k3 * (mu3 * mu3)
        z6 = 1.0 / math.sqrt(z5)
        r1 = z2 * z6
        z7 = mu2 * k2
        z8 = z6 * z7
        z9 = 1.0 / c_alpha
        z10 = s_beta * w1 - c_beta * w3
        z11 = z9 * z10
        z12 = z1 * w3 + mu3 * w1
        z13 = z12 * z9
        omega1 = z1 * z11 + c_beta * z13
        z14 = r1 * w2 + z8 * omega1
        z15 = mu3 * z11 - s_beta * z13
        z16 = mu3 * k3
        r3 = h - z6 * z16
        z17 = z8 * z15 - r3 * w2
        z18 = c_beta * z14 - s_beta * z17
        z19 = r3 * omega1 + r1 * z15
        e2 = mu2 * z18 - c_alpha * z19
        c_gamma = math.cos(gamma)
        z20 = c_gamma * z11
        s_gamma = math.sin(gamma)
        z21 = w2 + mu2 * z11
        z22 = s_beta * z21
        z23 = mu2 * z13
        z24 = c_beta * z21
        z25 = s_beta * z23 - c_alpha * z24
        z26 = c_alpha * z22 + c_beta * z23
        z27 = z6 * (z2 * z25 - z7 * z12 + z16 * z26) / z5
        z28 = k1 * (z6 * z25) - z2 * z27
        z29 = z23 / (c_alpha * c_alpha)
        z30 = z10 * z29 + z9 * (w1 * z24 + w3 * z22)
        z31 = z9 * (w3 * z25 + w1 * z26) - z12 * z29
        z32 = z11 * z25 - z1 * z30 + (z13 * z22 + c_beta * z31)
        z33 = z7 * z27 + k2 * (z6 * z12)
        z34 = w2 * z28 + (z8 * z32 - omega1 * z33)
        z35 = z11 * z26 - mu3 * z30 + (z13 * z24 - s_beta * z31)
        z36 = z16 * z27 - k3 * (z6 * z26)
        z37 = z8 * z35 - z15 * z33 - w2 * z36
        z38 = z14 * z22 + c_beta * z34 + (z17 * z24 - s_beta * z37)
        z39 = r3 * z32 + omega1 * z36 + (r1 * z35 + z15 * z28)
        z40 = z12 * z18 - mu2 * z38 + (z19 * z23 + c_alpha * z39)
        z41 = s_beta * z14 + c_beta * z17
        z42 = s_gamma * z11
        z43 = z14 * z24 - s_beta * z34 - (z17 * z22 + c_beta * z37)
        z44 = s_beta * s_gamma
        z45 = 1.0 - z3
        z46 = z4 + k1 * z45
        z47 = c_beta * z7
        z48 = z6 * w3_dot
        z49 = h * c_alpha
        z50 = c_beta * s_gamma
        z51 = z4 + k3 * z45
        z52 = s_beta * z7
        z53 = c_beta * c_gamma
        z54 = s_beta * mu2
        z55 = c_alpha * z6
        z56 = c_beta * mu2
        z57 = s_beta * c_gamma
        z58 = s_beta * k4
        s1 = z55 * (k3 * c_gamma + (s_gamma * z56 + z57) * z58)
        z59 = w2_dot * (h * (z53 - s_gamma * z54) - s1)
        s2 = w1_dot * (s_gamma * z49 - z6 * (z50 * z51 + c_gamma * z52))
        z60 = (z44 * z46 - c_gamma * z47) * z48 - (s2 + z59)
        s3 = z55 * (k3 * s_gamma + (z44 - c_gamma * z56) * z58)
        z61 = w2_dot * (h * (z50 + c_gamma * z54) - s3)
        s4 = w1_dot * (c_gamma * z49 - z6 * (z51 * z53 - s_gamma * z52))
        z62 = (z57 * z46 + s_gamma * z47) * z48 - (s4 - z61)
        z63 = mu3 * z6
        s5 = (h + z63 * k5) * (mu2 * w1_dot)
        s6 = s5 + (h + k4 * z63) * (z1 * w2_dot)
        z64 = k6 * (mu2 * (z1 * z48)) - s6
        s7 = g - (z18 * z23 + c_alpha * z38 - (z12 * z19 - mu2 * z39))
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            e2 * z20 - s_gamma * z40 - (z41 * z42 + c_gamma * z43) - z60,
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            e2 * z42 + c_gamma * z40 + (z41 * z20 - s_gamma * z43) + z62,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z64 - s7,
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
        z16 = z13 * z13 + z14 * z14 + z15 * z15 + s2
        value1 = 0.5 * z16 + w2 * (I_d * omega1) - z * g
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
        k7 = k1 - k3
        # state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
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
        z12 = z1 * k1
        r1 = z12 * z4
        z13 = mu3 * k3
        r3 = h - z4 * z13
        z14 = c_beta * r1 + s_beta * r3
        z15 = c_alpha * z14
        s_gamma = math.sin(gamma)
        z16 = mu2 * z14
        c_gamma = math.cos(gamma)
        z17 = s_beta * r1 - c_beta * r3
        z18 = s_gamma * z16 + c_gamma * z17
        z19 = c_gamma * z16 - s_gamma * z17
        z20 = I_b + (z15 * z15 + (z18 * z18 + z19 * z19))
        z21 = 1.0 / c_alpha
        z22 = s_beta * z21
        z23 = z1 * z22 + c_beta * c_beta
        z24 = mu2 * k2
        z25 = z4 * z24
        z26 = z25 * z23
        z27 = c_beta * s_beta
        z28 = mu3 * z22 - z27
        z29 = z25 * z28
        z30 = c_beta * z26 - s_beta * z29
        z31 = r3 * z23 + r1 * z28
        z32 = c_alpha * z30 + mu2 * z31
        z33 = mu2 * z30 - c_alpha * z31
        z34 = s_beta * z26 + c_beta * z29
        z35 = s_gamma * z33 + c_gamma * z34
        z36 = c_gamma * z33 - s_gamma * z34
        z37 = I_d * z23 + (z32 * z15 + (z35 * z18 + z36 * z19))
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
        z53 = z25 * z50 + z37 * z52
        z54 = 1.0 / z40
        z55 = z53 * z54
        z56 = z45 - z51 * z52 - z53 * z55
        # the mass matrix is singular
        if not abs(z56) > 1e-14 * z45:
            raise SingularModelError(2, "jacobian")
        z57 = s_beta * w1 - c_beta * w3
        z58 = z21 * z57
        z59 = z1 * z58
        z60 = z1 * w3 + mu3 * w1
        z61 = z60 * z21
        z62 = c_beta * z61
        omega1 = z59 + z62
        z63 = r1 * w2 + z25 * omega1
        z64 = c_beta * z63
        z65 = mu3 * z58
        z66 = s_beta * z61
        z67 = z65 - z66
        z68 = z25 * z67 - r3 * w2
        z69 = s_beta * z68
        z70 = z64 - z69
        z71 = s_beta * mu2
        z72 = c_beta * mu2
        s1 = k1 * (z1 * z71) - k2 * (c_alpha * mu2) + k3 * (mu3 * z72)
        z73 = z41 * (z4 * s1)
        z74 = z4 * (k1 * z71) - z12 * z73
        z75 = z24 * z73 + z4 * (c_alpha * k2)
        z76 = 1.0 / (c_alpha * c_alpha)
        z77 = mu2 * z76
        z78 = z57 * z77
        z79 = z21 * (w3 * z71 + w1 * z72) - z60 * z77
        z80 = z58 * z71 - z1 * z78 + c_beta * z79
        z81 = w2 * z74 - (omega1 * z75 - z25 * z80)
        z82 = z58 * z72 - mu3 * z78 - s_beta * z79
        z83 = z13 * z73 - z4 * (k3 * z72)
        z84 = z67 * z75 - z25 * z82 + w2 * z83
        z85 = c_beta * z81 + s_beta * z84
        z86 = r3 * omega1 + r1 * z67
        z87 = omega1 * z83 + r3 * z80 + (z67 * z74 + r1 * z82)
        z88 = c_alpha * z70 - mu2 * z85 + (mu2 * z86 + c_alpha * z87)
        z89 = s_beta * z81 - c_beta * z84
        z90 = s_beta * z63
        z91 = z41 * (z4 * (k7 * (z1 * mu3)))
        z92 = z4 * (mu3 * k1) - z12 * z91
        z93 = z24 * z91
        z94 = z21 * (c_beta * w1 + s_beta * w3)
        z95 = z21 * (mu3 * w3 - z1 * w1)
        z96 = z65 + z1 * z94 - (z66 - c_beta * z95)
        z97 = w2 * z92 - (omega1 * z93 - z25 * z96)
        z98 = c_beta * z68
        z99 = z59 - mu3 * z94 + (z62 + s_beta * z95)
        z100 = z13 * z91 + z4 * (z1 * k3)
        z101 = z67 * z93 + z25 * z99 + w2 * z100
        z102 = z90 - c_beta * z97 + (z98 - s_beta * z101)
        z103 = omega1 * z100 + r3 * z96 + (z67 * z92 - r1 * z99)
        z104 = mu2 * z102 + c_alpha * z103
        z105 = z64 + s_beta * z97 - (z69 + c_beta * z101)
        z106 = mu2 * z70
        z107 = c_alpha * z86
        e2 = z106 - z107
        z108 = z90 + z98
        z109 = c_beta * z21
        z110 = z27 - z1 * z109
        z111 = z25 * z110
        z112 = mu3 * z109 + z42
        z113 = z25 * z112
        z114 = c_beta * z111 + s_beta * z113
        z115 = r3 * z110 - r1 * z112
        z116 = mu2 * z114 - c_alpha * z115
        z117 = s_beta * z111 - c_beta * z113
        z118 = s_gamma * z116 + c_gamma * z117
        z119 = c_gamma * z116 - s_gamma * z117
        z120 = c_alpha * z114 + mu2 * z115
        z121 = mu2 * z22
        z122 = mu2 * z109
        z123 = 1.0 / z56
        z124 = w2 + mu2 * z58
        z125 = c_beta * z124
        z126 = s_beta * z124
        z127 = mu2 * z61
        z128 = c_alpha * z126 + c_beta * z127
        z129 = c_beta * z122
        z130 = s_beta * z122
        z131 = c_alpha * z130 - c_beta * z71
        z132 = s_beta * z125 - z109 * z128 + (z61 * z129 + z58 * z131)
        z133 = z127 * z76
        z134 = w1 * z125 + w3 * z126
        z135 = z57 * z133 + z21 * z134
        z136 = s_beta * z127 - c_alpha * z125
        z137 = w3 * z136 + w1 * z128
        z138 = z21 * z137 - z60 * z133
        z139 = z58 * z128 - mu3 * z135 + (z61 * z125 - s_beta * z138)
        z140 = z59 + z60 * z109
        z141 = I_d * omega1 + I_b * w2
        z142 = s_beta * z71 + c_alpha * z129
        z143 = s_beta * z126 - z109 * z136 + (z61 * z130 - z58 * z142)
        z144 = I_d * w2 + I_a * omega1
        z145 = z58 * z136 - z1 * z135 + (z61 * z126 + c_beta * z138)
        z146 = k1 * z136
        z147 = k1 * (z1 * z136) - k2 * (mu2 * z60) + k3 * (mu3 * z128)
        z148 = z4 * z147
        z149 = z148 * z41
        z150 = z4 * z146 - z12 * z149
        z151 = k2 * z60
        z152 = z24 * z149 + z4 * z151
        z153 = w2 * z150 - (omega1 * z152 - z25 * z145)
        z154 = k3 * z128
        z155 = z13 * z149 - z4 * z154
        z156 = z67 * z152 - z25 * z139 + w2 * z155
        z157 = z63 * z126 + c_beta * z153 + (z68 * z125 + s_beta * z156)
        z158 = omega1 * z155 + r3 * z145 + (z67 * z150 + r1 * z139)
        z159 = z70 * z127 + c_alpha * z157 - (z60 * z86 - mu2 * z158)
        z160 = g - z159
        z161 = s_gamma * z58
        z162 = z60 * z70 - mu2 * z157 + (z86 * z127 + c_alpha * z158)
        z163 = c_gamma * z58
        z164 = z63 * z125 - s_beta * z153 - (z68 * z126 - c_beta * z156)
        z165 = e2 * z161 + c_gamma * z162 + (z108 * z163 - s_gamma * z164)
        z166 = e2 * z163 - s_gamma * z162 - (z108 * z161 + c_gamma * z164)
        z167 = c_beta * z121
        z168 = s_beta * z121
        z169 = c_alpha * z168 + c_beta * z72
        z170 = c_beta * z125 + z22 * z128 - (z61 * z167 + z58 * z169)
        z171 = z65 - z60 * z22
        z172 = s_beta * z72 - c_alpha * z167
        z173 = c_beta * z126 + z22 * z136 - (z61 * z168 + z58 * z172)
        z174 = 1.0 / (c_alpha * c_alpha * c_alpha)
        s2 = z144 * z143 + (z120 * z159 + (z118 * z166 - z119 * z165))
        z175 = z141 * z140 - s2 - I_a * (z110 * z145)
        s3 = z144 * z173 + (z32 * z159 + (z35 * z166 - z36 * z165))
        z176 = z141 * z171 - s3 - I_a * (z23 * z145)
        z177 = z176 - I_c * (z28 * z139 + z67 * z170) + g * z32
        s4 = z67 * z144 + (z15 * z159 + (z18 * z166 - z19 * z165))
        z178 = I_d * z145 + s4 - I_c * (omega1 * z67)
        z179 = z178 - g * z15 + z177 * z39
        s5 = z175 + I_c * (z112 * z139 - z67 * z132) + g * z120
        z180 = s5 + z177 * z52 + z55 * z179
        z181 = z123 * z180
        z182 = z54 * z179 + z55 * z181
        z183 = z177 * z38 + z39 * z182 + z52 * z181
        z184 = 1.0 / (z3 * z3)
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z89 - s_gamma * z88,
            # (I.2.15)
            s_gamma * z104 - c_gamma * z105,
            # (I.2.15)
            s_gamma * z108 - c_gamma * e2,
            # (I.2.15)
            -z35,
            # (I.2.15)
            -z18,
            # (I.2.15)
            -z118,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z88 + s_gamma * z89,
            # (I.2.15)
            -(c_gamma * z104 + s_gamma * z105),
            # (I.2.15)
            -(s_gamma * e2 + c_gamma * z108),
            # (I.2.15)
            z36,
            # (I.2.15)
            z19,
            # (I.2.15)
            z119,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z106 + c_alpha * z85 - (z107 - mu2 * z87),
            # (I.2.15)
            c_alpha * z102 - mu2 * z103,
            0.0,
            # (I.2.15)
            -z32,
            # (I.2.15)
            -z15,
            # (I.2.15)
            -z120,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z79,
            # (I.2.15)
            z95,
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
            z57 + mu2 * z78,
            # (I.2.15)
            mu2 * z94,
            0.0,
            # (I.2.15)
            z121,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -z122,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z78,
            # (I.2.15)
            -z94,
            0.0,
            # (I.2.15)
            -z22,
            0.0,
            # (I.2.15)
            z109,
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
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
        # one rate in each pass: its row of the matrix
        offsets1 = (54, 63, 72)
        for k8, offset1 in enumerate(offsets1):
            row_0 = 1.0 if k8 == 0 else 0.0
            row_1 = 1.0 if k8 == 1 else 0.0
            row_2 = 1.0 if k8 == 2 else 0.0
            z185 = row_1 - z39 * row_0
            z186 = z123 * (row_2 + z52 * row_0 - z55 * z185)
            z187 = I_c * z186
            z188 = z67 * z187
            z189 = z54 * z185 - z55 * z186
            z190 = z38 * row_0 - z39 * z189 + z52 * z186
            z191 = I_c * z190
            z192 = z67 * z191
            z193 = z119 * z186 + z19 * z189 + z36 * z190
            z194 = z118 * z186 + z18 * z189 + z35 * z190
            z195 = s_gamma * z193 - c_gamma * z194
            z196 = z120 * z186 + z15 * z189 + z32 * z190
            z197 = c_gamma * z193 + s_gamma * z194
            z198 = c_alpha * z196 + mu2 * z197
            z199 = mu2 * z196 - c_alpha * z197
            z200 = c_beta * z195 + s_beta * z198
            z201 = z112 * z187 - z28 * z191 - r1 * z199 + z25 * z200
            z202 = I_a * z186
            z203 = I_a * z190
            z204 = s_beta * z195 - c_beta * z198
            s6 = z110 * z202 + z23 * z203 + I_d * z189 + r3 * z199
            z205 = s6 - z25 * z204
            z206 = mu3 * z201 - z1 * z205
            z207 = z21 * z206
            s7 = s_beta * z188 + c_beta * z192 + z63 * z195 + z68 * z198
            z208 = s7 - z61 * z201 + w1 * z207
            z209 = z144 * z186
            z210 = z144 * z190
            z211 = s_beta * z201 + c_beta * z205
            z212 = z21 * z211
            z213 = z67 * z199 - w2 * z204
            z214 = omega1 * z199 + w2 * z200
            z215 = z67 * z200 + omega1 * z204
            z216 = z13 * z214 + z24 * z215 - z12 * z213
            z217 = z41 * z216
            z218 = z4 * z217
            z219 = k1 * z218
            s8 = z109 * z209 - z22 * z210 - z58 * z205 - w3 * z212
            z220 = s8 - k1 * (z4 * z213) - z1 * z219
            z221 = z208 + c_alpha * z220
            s9 = s_beta * z209 + c_beta * z210 - z68 * z195 + z63 * z198
            z222 = s9 + z61 * z205 + w3 * z207
            z223 = k3 * z218
            s10 = z109 * z188 - z22 * z192 + z58 * z201 - w1 * z212
            z224 = s10 + k3 * (z4 * z214) - mu3 * z223
            z225 = z222 - c_alpha * z224
            z226 = c_beta * z221 + s_beta * z225
            z227 = z161 * z193 - z163 * z194
            z228 = z58 * z210
            z229 = z61 * z192 - c_alpha * z228
            z230 = z58 * z192
            z231 = c_alpha * z230 + z61 * z210
            z232 = c_beta * z229 + s_beta * z231
            z233 = z58 * z188
            z234 = z58 * z209
            z235 = c_beta * z233 + s_beta * z234
            z236 = c_beta * z230 + s_beta * z228
            z237 = k2 * z218
            z238 = z57 * z206 - z60 * z211
            s11 = z70 * z196 - z86 * z197 + z76 * z238 - c_beta * z224
            z239 = s11 - s_beta * z220
            s12 = s_beta * z235 + c_beta * z236 - z158 * z196 - z157 * z197
            z240 = s12 + z60 * z237 - z61 * z239
            z241 = z160 * z186
            z242 = z165 * z186
            z243 = z166 * z186
            z244 = c_gamma * z242 - s_gamma * z243
            z245 = z61 * z188 - c_alpha * z234
            z246 = c_alpha * z233 + z61 * z209
            z247 = c_beta * z245 + s_beta * z246
            z248 = z182 * z189
            z249 = z183 * z189 - z182 * z190
            z250 = z165 * z189 + 2.0 * (z19 * z248) - z36 * z249
            z251 = z166 * z189 - 2.0 * (z18 * z248) + z35 * z249
            z252 = c_gamma * z250 - s_gamma * z251
            z253 = z160 * z190 - z15 * z249
            z254 = z165 * z190 - z19 * z249
            z255 = z166 * z190 + z18 * z249
            z256 = c_gamma * z254 - s_gamma * z255
            s13 = z240 + z115 * z241 + z114 * z244 - z109 * z247 + z14 * z252
            z257 = s13 + z31 * z253 + z30 * z256
            z258 = z163 * z193 + z161 * z194
            z259 = z127 * z196 - z60 * z197 - mu2 * z227
            z260 = z125 * z195 + z126 * z198 - s_beta * z258 + c_beta * z259
            z261 = z126 * z195 - z125 * z198 + c_beta * z258 + s_beta * z259
            z262 = s_gamma * z242 + c_gamma * z243
            z263 = c_alpha * z241 + mu2 * z244
            z264 = s_beta * z262 - c_beta * z263
            z265 = c_beta * z262 + s_beta * z263
            z266 = z182 * z186 - z181 * z189
            z267 = s_gamma * z254 + c_gamma * z255
            z268 = c_alpha * z253 + mu2 * z256
            z269 = c_beta * z267 + s_beta * z268
            s14 = z112 * z265 + (z145 * z204 + (z139 * z200 + z50 * z266))
            z270 = z110 * z264 - s14 + z28 * z269
            z271 = s_beta * z267 - c_beta * z268
            z272 = omega1 * z260 - (z67 * z261 - (z270 + z23 * z271))
            s15 = z58 * z226 - (z70 * z227 + (z22 * z232 + z257))
            z273 = s15 + k2 * (z149 * z215 + z4 * z272)
            z274 = z181 * z186
            z275 = z41 * z274
            z276 = z183 * z190
            z277 = z4 * z276
            z278 = z5 * z277
            z279 = z183 * z186 + z181 * z190
            z280 = z25 * z266 + z48 * z279
            z281 = z50 * z279
            z282 = z7 * z278
            s16 = z49 * z280 - z47 * z281 + z10 * z276 + z9 * z277 + z5 * z282
            z283 = z154 * z214 - s16
            z284 = z60 * z196 + z127 * z197 - c_alpha * z227
            z285 = mu2 * z241 - c_alpha * z244
            z286 = s_gamma * z250 + c_gamma * z251
            z287 = z160 * z189 + 2.0 * (z15 * z248) - z32 * z249
            z288 = c_alpha * z287 + mu2 * z252
            z289 = mu2 * z253 - c_alpha * z256
            s17 = z145 * z199 - z110 * z285 - c_beta * z286 - s_beta * z288
            z290 = omega1 * z284 - (s17 - z23 * z289)
            z291 = w2 * z261 - z290
            s18 = z139 * z199 + z112 * z285 + s_beta * z286 - c_beta * z288
            z292 = z67 * z284 - (s18 - z28 * z289)
            z293 = w2 * z260 - z292
            s19 = z147 * z217 + (z146 * z213 + (z151 * z215 - z283))
            z294 = s19 - z13 * z291 + z24 * z272 + z12 * z293
            s20 = z184 * (z148 * z216 + z44 * z274)
            z295 = s20 + 0.5 * (z4 * (z41 * z294))
            s21 = k4 * (z275 + z4 * z277) - (z43 * z275 + z6 * z278)
            z296 = 2.0 * (mu2 * (s21 - k2 * z295))
            z297 = z4 * z280
            z298 = z4 * z281
            s22 = z5 * z297 - k1 * (s_beta * z298) - 2.0 * (h * z278)
            z299 = z129 * z234 - (z130 * z233 + s22)
            s23 = z157 * z196 + (z167 * z228 - (z168 * z230 + z299))
            z300 = 2.0 * (z127 * z238 * z174) + (z158 * z197 - s23)
            s24 = z114 * z241 - (z125 * z220 - (z126 * z224 + z300))
            z301 = z115 * z244 - s24 - z14 * z287 - z30 * z253
            s25 = z129 * z188 + z130 * z209 - z167 * z192 - z168 * z210
            z302 = s25 - z125 * z201 + z126 * z205
            z303 = I_c * z189
            s26 = z132 * z187 - omega1 * z303 + z144 * z189 + z170 * z191
            z304 = s26 + z150 * z199 + z152 * z200
            z305 = z304 - r1 * z284 - z25 * z261
            z306 = z143 * z186 + z67 * z189 + z173 * z190
            z307 = z140 * z186 + z171 * z190
            s27 = z67 * z303 - z155 * z199 - z152 * z204 - I_a * z306
            z308 = s27 + I_d * z307 + r3 * z284
            z309 = z308 - z25 * z260
            z310 = z302 + mu2 * z239 - s_beta * z305 - c_beta * z309
            s28 = z131 * z188 - z142 * z209 - z169 * z192 - z172 * z210
            z311 = s28 - z128 * z201 + z136 * z205
            z312 = z108 * z193 - e2 * z194
            z313 = e2 * z193 + z108 * z194
            z314 = z141 * z190
            z315 = z314 - z305
            z316 = z141 * z186
            z317 = z316 + z309
            s29 = z311 - c_gamma * z312 - s_gamma * z313 - mu3 * z315
            z318 = s29 - z1 * z317 + mu2 * z226
            z319 = z139 * z187 - r1 * z285 + z25 * z265
            z320 = z145 * z202 - r3 * z285 + z25 * z264
            s30 = z128 * z188 + z60 * z316 + z136 * z209 + mu3 * z319
            z321 = s30 + z1 * z320 - mu2 * z247
            z322 = z139 * z191 - r1 * z289 + z25 * z269
            z323 = z145 * z203 + I_d * z249 - r3 * z289 + z25 * z271
            s31 = z128 * z192 + z60 * z314 + z136 * z210 + mu3 * z322
            z324 = mu2 * z232 - (s31 + z1 * z323)
            s32 = z134 * z206 + z137 * z211 - c_beta * z321 - s_beta * z324
            z325 = z60 * z310 + (z57 * z318 + s32)
            s33 = z109 * z316 - z22 * z314 + z86 * z196 + z70 * z197
            z326 = s33 + z133 * z211 - k2 * (z4 * z215)
            z327 = z326 + mu2 * z237 - z21 * z310
            s34 = z135 * z201 + z128 * z223 - z109 * z319 + z22 * z322
            z328 = w1 * z327 + (z58 * z315 - s34)
            s35 = z328 - k3 * (z149 * z214 - z4 * z291)
            z329 = s35 + 2.0 * (mu3 * (k3 * z295))
            s36 = z135 * z205 - z136 * z219 + z109 * z320 - z22 * z323
            z330 = w3 * z327 + (z58 * z317 + s36)
            s37 = z330 + k1 * (z149 * z213 - z4 * z293)
            z331 = s37 + 2.0 * (z1 * (k1 * z295))
            s38 = z86 * z227 + (z301 + z31 * z256) - z76 * z325
            z332 = mu2 * (s38 - c_beta * z329 - s_beta * z331)
            J[offset1 + 3] = c_alpha * (z273 + z296) - z332
            z333 = z133 * z206 + z21 * z318
            s39 = z71 * z234 - (z126 * z209 + (z125 * z188 - z46 * z298))
            z334 = z122 * z246 - (mu2 * z235 + s39)
            s40 = z153 * z195 + (z121 * z231 + (z72 * z228 - z334))
            z335 = z127 * z220 - (z138 * z201 + (z156 * z198 - s40))
            s41 = z113 * z263 - (z111 * z262 + (z124 * z225 - z335))
            z336 = s41 + 2.0 * (s_beta * (z319 - k6 * (z7 * z275)))
            z337 = z320 - z322
            s42 = z336 - r1 * z286 + r3 * z288 - z26 * z267 - z29 * z268
            z338 = s42 - c_beta * z337 + z21 * z324
            s43 = w1 * z333 - (z61 * z305 + (z68 * z259 + (z63 * z258 + z338)))
            z339 = c_beta * (s43 - c_alpha * z331)
            s44 = z71 * z233 - k3 * (c_alpha * z297 + z8 * z277 + z4 * z282)
            z340 = z125 * z192 + (z122 * z245 - s44)
            s45 = z121 * z229 - (z126 * z210 - (z72 * z230 - z340))
            z341 = z153 * z198 + (z156 * z195 - (mu2 * z236 + s45))
            s46 = z124 * z221 - (z127 * z224 - (z138 * z205 + z341))
            z342 = z21 * z321 + (z111 * z263 + (z113 * z262 - s46))
            s47 = z342 + r3 * z286 + r1 * z288 - z29 * z267 - s_beta * z337
            z343 = s47 + z26 * z268 - 2.0 * (c_beta * z323)
            s48 = w3 * z333 + (z61 * z309 - (z63 * z259 - (z68 * z258 + z343)))
            z344 = s_beta * (s48 + c_alpha * z329)
            J[offset1 + 4] = z339 + z344
            s49 = z164 * z193 - z162 * z194 - z58 * z313 + z117 * z242
            z345 = s49 + z116 * z243 + z17 * z250
            s50 = z162 * z193 + z164 * z194 + z58 * z312 + z116 * z242
            z346 = s50 - z117 * z243 + z16 * z250
            s51 = c_gamma * (z345 + z16 * z251 + z34 * z254 + z33 * z255)
            s52 = s_gamma * (z346 - z17 * z251 + z33 * z254 - z34 * z255)
            z347 = s51 + s52
            J[offset1 + 5] = z347
            s53 = z125 * z207 + z128 * z212 + s_beta * z333
            J[offset1 + 6] = s53 - mu3 * z327
            s54 = z155 * z200 - z150 * z204 - I_b * z307 + I_d * z306
            z348 = s54 + r3 * z261 + r1 * z260
            J[offset1 + 7] = z226 + z348
            s55 = z126 * z207 + z136 * z212 - c_beta * z333
            J[offset1 + 8] = s55 - z1 * z327
        _finish("jacobian", J)
        return [J[k9 : k9 + 9] for k9 in range(0, 81, 9)]
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
