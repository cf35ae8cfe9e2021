"""rattleback, emitted by nhc 0.1.0 (nhc:2611dc8668f84750).

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
y[6] = w1 [rad/s]
y[7] = w2 [rad/s]
y[8] = w3 [rad/s]

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
out[0] = spin [rad/s]

Operations:
rhs: 64 +-, 119 *, 5 /, 7 calls
velocities: 15 +-, 42 *, 2 /, 7 calls
accelerations: 98 +-, 163 *, 5 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 86 +-, 155 *, 5 /, 7 calls
energy: 19 +-, 48 *, 1 /, 7 calls
jacobian: 453 +-, 680 *, 5 /, 7 calls
outputs: 0 +-, 0 *, 0 /, 1 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "rhs")
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
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "rhs")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "rhs")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z22) > 1e-13 * z16:
            raise _refuse(abs(z22), 1e-13 * z16, 2, "rhs")
        s_gamma = math.sin(gamma)
        z23 = r3 * w1 - r1 * w3
        u1 = r3 * w2 + z6 * w3
        z24 = r1 * w2 + z6 * w1
        z25 = s_beta * u1 + c_beta * z24
        z26 = c_alpha * z23 - mu2 * z25
        c_gamma = math.cos(gamma)
        z27 = s_beta * z24 - c_beta * u1
        z28 = 1.0 / c_alpha
        z29 = z1 * w3 + mu3 * w1
        z30 = z28 * z29
        z31 = s_beta * w1 - c_beta * w3
        z32 = z28 * z31
        z33 = w2 + mu2 * z32
        z34 = I_c * w3
        z35 = I_b * w2 + I_d * w1
        z36 = z30 * z35
        z37 = z31 * z35
        z38 = mu2 * z30
        z39 = s_beta * z38 - mu3 * z33
        z40 = c_beta * z38 + z1 * z33
        z41 = (z9 * z39 - z5 * z29 + z3 * z40) * (z2 * (z2 * z2))
        z42 = z3 * z41 - k3 * (z2 * z40)
        z43 = k1 * (z2 * z39) - z9 * z41
        z44 = g * mu2 - (w3 * u1 + w1 * z24 + (w1 * z42 - w3 * z43))
        z45 = z5 * z41 + k2 * (z2 * z29)
        z46 = g * mu3 + (w1 * z23 + w2 * u1 - (w2 * z43 - w1 * z45))
        s2 = s_beta * z36 - (c_beta * z37 + (r3 * z44 + z6 * z46))
        z47 = w2 * z34 - s2
        z48 = I_d * w2 + I_a * w1
        z49 = g * z1 - (w2 * z24 - w3 * z23 + (w2 * z42 - w3 * z45))
        z50 = w3 * z48 - w1 * z34 + (r3 * z49 + r1 * z46) - z14 * z47
        s3 = c_beta * z36 + (s_beta * z37 + (z6 * z49 - r1 * z44))
        z51 = w2 * z48 - s3 - z18 * z47
        z52 = (z51 + z21 * z50) / z22
        z53 = z20 * z50 + z21 * z52
        dydt: list[float] = [
            # x' (I.2.15)
            s_gamma * z26 - c_gamma * z27,
            # y' (I.2.15)
            -(s_gamma * z27 + c_gamma * z26),
            # z' (I.2.15)
            -(mu2 * z23 + c_alpha * z25),
            # alpha' (I.2.15)
            z30,
            # beta' (I.2.15)
            z33,
            # gamma' (I.2.15)
            -z32,
            # w1' (I.2.15) 41:4
            z18 * z52 - (z13 * z47 - z14 * z53),
            # w2' (I.2.15) 41:4
            -z53,
            # w3' (I.2.15) 41:4
            z52,
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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "velocities")
        s_gamma = math.sin(gamma)
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r3 = h - z2 * (mu3 * k3)
        r1 = z1 * k1 * z2
        z3 = r3 * w1 - r1 * w3
        z4 = z2 * (mu2 * k2)
        u1 = r3 * w2 + z4 * w3
        z5 = r1 * w2 + z4 * w1
        z6 = s_beta * u1 + c_beta * z5
        z7 = c_alpha * z3 - mu2 * z6
        c_gamma = math.cos(gamma)
        z8 = s_beta * z5 - c_beta * u1
        z9 = 1.0 / c_alpha
        z10 = z9 * (s_beta * w1 - c_beta * w3)
        qdot: list[float] = [
            # x' (I.2.4)
            s_gamma * z7 - c_gamma * z8,
            # y' (I.2.4)
            -(s_gamma * z8 + c_gamma * z7),
            # z' (I.2.4)
            -(mu2 * z3 + c_alpha * z6),
            # alpha' (I.2.4)
            z9 * (z1 * w3 + mu3 * w1),
            # beta' (I.2.4)
            w2 + mu2 * z10,
            # gamma' (I.2.4)
            -z10,
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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "accelerations")
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
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "accelerations")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "accelerations")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z22) > 1e-13 * z16:
            raise _refuse(abs(z22), 1e-13 * z16, 2, "accelerations")
        z23 = r3 * w1 - r1 * w3
        u1 = r3 * w2 + z6 * w3
        z24 = r1 * w2 + z6 * w1
        z25 = s_beta * u1 + c_beta * z24
        z26 = c_alpha * z23 - mu2 * z25
        c_gamma = math.cos(gamma)
        z27 = 1.0 / c_alpha
        z28 = s_beta * w1 - c_beta * w3
        z29 = z27 * z28
        z30 = c_gamma * z29
        s_gamma = math.sin(gamma)
        z31 = z1 * w3 + mu3 * w1
        z32 = z27 * z31
        z33 = mu2 * z32
        z34 = w2 + mu2 * z29
        z35 = c_beta * z34
        z36 = s_beta * z33 - c_alpha * z35
        z37 = s_beta * z34
        z38 = c_alpha * z37 + c_beta * z33
        z39 = z2 * (z2 * z2) * (z5 * z31 - z9 * z36 - z3 * z38)
        z40 = z3 * z39 + k3 * (z2 * z38)
        z41 = w1 * z40
        z42 = I_c * w3
        z43 = I_b * w2 + I_d * w1
        z44 = z32 * z43
        z45 = z28 * z43
        z46 = k1 * (z2 * z36) + z9 * z39
        z47 = w3 * z46
        z48 = g * mu2 - (w3 * u1 + w1 * z24 - (z41 + z47))
        z49 = w2 * z46
        z50 = k2 * (z2 * z31) - z5 * z39
        z51 = w1 * z50
        z52 = g * mu3 + (w1 * z23 + w2 * u1 - (z49 - z51))
        s2 = s_beta * z44 - (c_beta * z45 + (r3 * z48 + z6 * z52))
        z53 = w2 * z42 - s2
        z54 = I_d * w2 + I_a * w1
        z55 = w2 * z40
        z56 = w3 * z50
        z57 = g * z1 - (w2 * z24 - w3 * z23 - (z55 + z56))
        z58 = w3 * z54 - w1 * z42 + (r3 * z57 + r1 * z52) - z14 * z53
        s3 = c_beta * z44 + (s_beta * z45 + (z6 * z57 - r1 * z48))
        z59 = w2 * z54 - s3 - z18 * z53
        z60 = (z59 + z21 * z58) / z22
        z61 = z20 * z58 + z21 * z60
        z62 = z13 * z53 - z14 * z61 - z18 * z60
        z63 = z41 - r3 * z62 + (z47 - r1 * z60)
        z64 = z55 - r3 * z61 + (z56 + z6 * z60)
        z65 = z49 + r1 * z61 - (z51 - z6 * z62)
        z66 = z35 * u1 + s_beta * z64 - (z37 * z24 + c_beta * z65)
        z67 = z33 * z23 - c_alpha * z63 + (z31 * z25 + mu2 * z66)
        z68 = s_beta * z24 - c_beta * u1
        z69 = s_gamma * z29
        z70 = z35 * z24 - s_beta * z65 + (z37 * u1 - c_beta * z64)
        z71 = z33 * (z27 * z27)
        s4 = z27 * (w1 * z35 - s_beta * z62 + (w3 * z37 - c_beta * z60))
        z72 = z28 * z71 + s4
        s5 = z27 * (w3 * z36 - z1 * z60 + (w1 * z38 + mu3 * z62))
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z26 * z30 + s_gamma * z67 + (z68 * z69 + c_gamma * z70)),
            # y'' (I.2.15)
            z68 * z30 - s_gamma * z70 - (z26 * z69 - c_gamma * z67),
            # z'' (I.2.15)
            z33 * z25 - c_alpha * z66 - (z31 * z23 + mu2 * z63),
            # alpha'' (I.2.15)
            z31 * z71 - s5,
            # beta'' (I.2.15)
            z31 * z29 + mu2 * z72 - z61,
            # gamma'' (I.2.15)
            -z72,
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
        # from the state
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
    """left minus right side of each constraint, zero on every motion (I.1.1)

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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
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
    """reactions lambda of the constraints (I.4.1)

    Arguments: t (scalar), y (9,), p (9,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "reactions")
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
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "reactions")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "reactions")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z22) > 1e-13 * z16:
            raise _refuse(abs(z22), 1e-13 * z16, 2, "reactions")
        s_gamma = math.sin(gamma)
        z23 = mu2 * s_gamma
        c_gamma = math.cos(gamma)
        z24 = c_beta * z23 + s_beta * c_gamma
        z25 = r3 * w1 - r1 * w3
        u1 = r3 * w2 + z6 * w3
        z26 = 1.0 / c_alpha
        z27 = z1 * w3 + mu3 * w1
        z28 = z26 * z27
        z29 = mu2 * z28
        z30 = s_beta * w1 - c_beta * w3
        z31 = w2 + z30 * (mu2 * z26)
        z32 = s_beta * z29 - mu3 * z31
        z33 = c_beta * z29 + z1 * z31
        z34 = z2 * (z2 * z2) * (z5 * z27 - z9 * z32 - z3 * z33)
        z35 = k1 * (z2 * z32) + z9 * z34
        z36 = k2 * (z2 * z27) - z5 * z34
        z37 = g * mu3 + (w1 * z25 + w2 * u1 - (w2 * z35 - w1 * z36))
        z38 = c_beta * c_gamma - s_beta * z23
        z39 = r1 * w2 + z6 * w1
        z40 = z3 * z34 + k3 * (z2 * z33)
        z41 = g * z1 - (w2 * z39 - w3 * z25 - (w2 * z40 + w3 * z36))
        z42 = c_alpha * s_gamma
        z43 = g * mu2 - (w3 * u1 + w1 * z39 - (w1 * z40 + w3 * z35))
        z44 = I_d * w2 + I_a * w1
        z45 = I_b * w2 + I_d * w1
        z46 = z28 * z45
        z47 = z30 * z45
        z48 = I_c * w3
        s2 = s_beta * z46 - (c_beta * z47 + (r3 * z43 + z6 * z37))
        z49 = w2 * z48 - s2
        s3 = c_beta * z46 + (s_beta * z47 + (z6 * z41 - r1 * z43))
        z50 = w2 * z44 - s3 - z18 * z49
        z51 = w3 * z44 - w1 * z48 + (r3 * z41 + r1 * z37) - z14 * z49
        z52 = (z50 + z21 * z51) / z22
        z53 = z20 * z51 + z21 * z52
        z54 = z13 * z49 - z14 * z53 - z18 * z52
        s4 = (r3 * z42 - z6 * z24) * z54 + (r3 * z38 - r1 * z24) * z53
        z55 = (z6 * z38 - r1 * z42) * z52 - s4
        z56 = mu2 * c_gamma
        z57 = c_beta * z56 - s_beta * s_gamma
        z58 = c_beta * s_gamma + s_beta * z56
        z59 = c_alpha * c_gamma
        s5 = (r3 * z59 - z6 * z57) * z54 - (r3 * z58 + r1 * z57) * z53
        z60 = (z6 * z58 + r1 * z59) * z52 + s5
        s6 = (mu2 * r3 + mu3 * z6) * z54 + (z1 * r3 + mu3 * r1) * z53
        z61 = (mu2 * r1 - z1 * z6) * z52 + s6
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z55 - (z24 * z37 - (z38 * z41 + z42 * z43)),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z57 * z37 + (z58 * z41 - z59 * z43) + z60,
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z61 - (mu3 * z37 + (z1 * z41 + mu2 * z43)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """energy T + V

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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the state
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
        r1 = z1 * k1 * z2
        z3 = r3 * w1 - r1 * w3
        z4 = z2 * (mu2 * k2)
        u1 = r3 * w2 + z4 * w3
        z5 = r1 * w2 + z4 * w1
        z6 = s_beta * u1 + c_beta * z5
        z7 = c_alpha * z3 - mu2 * z6
        c_gamma = math.cos(gamma)
        z8 = s_beta * z5 - c_beta * u1
        z9 = s_gamma * z7 - c_gamma * z8
        z10 = s_gamma * z8 + c_gamma * z7
        z11 = mu2 * z3 + c_alpha * z6
        s2 = I_b * (w2 * w2) + I_a * (w1 * w1) + I_c * (w3 * w3)
        z12 = z9 * z9 + z10 * z10 + z11 * z11 + s2
        value1 = 0.5 * z12 + w2 * (I_d * w1) - z * g
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15)

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
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        k4 = k1 - k3
        k5 = I_b - I_c
        k6 = I_a - I_c
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "jacobian")
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
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z8) > 0.0:
            raise _refuse(abs(z8), 0.0, 2, "jacobian")
        z9 = z1 * k1
        r1 = z9 * z2
        z10 = r1 * r1
        z11 = I_b + (z4 + z10)
        z12 = I_d + r1 * z6
        z13 = 1.0 / z8
        z14 = z12 * z13
        z15 = z11 - z12 * z14
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "jacobian")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3
        z20 = z19 + z12 * z18
        z21 = 1.0 / z15
        z22 = z20 * z21
        z23 = z16 - z17 * z18 - z20 * z22
        # the mass matrix is singular, or the velocities that are kept are
        if not abs(z23) > 1e-13 * z16:
            raise _refuse(abs(z23), 1e-13 * z16, 2, "jacobian")
        s_gamma = math.sin(gamma)
        z24 = r3 * w1
        z25 = r1 * w3
        z26 = z24 - z25
        z27 = z2 * z2
        z28 = z2 * z27
        z29 = s_beta * mu2
        z30 = c_beta * mu2
        z31 = z28 * (z9 * z29 - c_alpha * z5 + z3 * z30)
        z32 = k3 * z2
        z33 = z3 * z31 - z30 * z32
        z34 = k1 * z2
        z35 = z29 * z34 - z9 * z31
        z36 = w1 * z33 - w3 * z35
        z37 = r3 * w2
        z38 = z6 * w3
        u1 = z37 + z38
        z39 = s_beta * u1
        z40 = r1 * w2
        z41 = z6 * w1
        z42 = z40 + z41
        z43 = c_beta * z42
        z44 = z39 + z43
        z45 = k2 * z2
        z46 = z5 * z31 + c_alpha * z45
        z47 = w2 * z33 - w3 * z46
        z48 = w2 * z35 - w1 * z46
        z49 = s_beta * z47 + c_beta * z48
        z50 = mu2 * z26 + c_alpha * z36 + (c_alpha * z44 - mu2 * z49)
        c_gamma = math.cos(gamma)
        z51 = s_beta * z48 - c_beta * z47
        z52 = k4 * (mu3 * (z1 * z28))
        z53 = z3 * z52 + z1 * z32
        z54 = mu3 * z34 - z9 * z52
        z55 = w1 * z53 - w3 * z54
        z56 = c_beta * u1
        z57 = z5 * z52
        z58 = w2 * z53 - w3 * z57
        z59 = s_beta * z42
        z60 = w2 * z54 - w1 * z57
        z61 = z56 + s_beta * z58 - (z59 - c_beta * z60)
        z62 = c_alpha * z55 - mu2 * z61
        z63 = z43 + s_beta * z60 + (z39 - c_beta * z58)
        z64 = z59 - z56
        z65 = c_alpha * z26
        z66 = mu2 * z44
        z67 = z65 - z66
        z68 = c_beta * z6
        z69 = mu2 * z68 - c_alpha * r3
        z70 = s_beta * z6
        z71 = s_beta * r3 + c_beta * r1
        z72 = mu2 * z71
        z73 = s_beta * r1 - c_beta * r3
        z74 = mu2 * z70 + c_alpha * r1
        z75 = s_beta * w1 - c_beta * w3
        z76 = 1.0 / c_alpha
        z77 = z76 * z76
        z78 = mu2 * z77
        z79 = z75 * z78
        z80 = z1 * w3 + mu3 * w1
        z81 = s_beta * z76
        z82 = c_beta * z76
        z83 = g * r3
        z84 = z6 * w2
        z85 = r3 * w3
        z86 = z84 - z85
        z87 = z3 * z24 - z5 * z41 - z9 * z86
        z88 = z27 * z87
        z89 = z2 * z88
        z90 = k2 * z89
        z91 = z76 * z80
        z92 = z76 * z75
        z93 = c_beta * z17
        z94 = z93 + s_beta * z8
        z95 = z92 * z17
        z96 = k3 * z89
        z97 = z95 - (mu3 * z96 - z24 * z32)
        z98 = k1 * z89
        z99 = z92 * z8 - (z1 * z98 + z86 * z34)
        z100 = z92 * z94 - c_beta * z97 - s_beta * z99
        z101 = z75 * z8 - c_alpha * z99
        z102 = z75 * z17
        z103 = z102 - c_alpha * z97
        z104 = c_beta * z101 - s_beta * z103
        z105 = mu2 * z91
        z106 = w2 + mu2 * z92
        z107 = c_beta * z106
        z108 = s_beta * z105 - c_alpha * z107
        z109 = s_beta * z106
        z110 = c_alpha * z109 + c_beta * z105
        z111 = z5 * z80 - z9 * z108 - z3 * z110
        z112 = z2 * z111
        z113 = z27 * z112
        z114 = I_c * w3
        z115 = I_d * w1
        z116 = I_b * w2 + z115
        z117 = z91 * z116
        z118 = z75 * z116
        z119 = k3 * z110
        z120 = z2 * z119 + z3 * z113
        z121 = k1 * z108
        z122 = z2 * z121 + z9 * z113
        z123 = g * mu2 - (w3 * u1 + w1 * z42 - (w1 * z120 + w3 * z122))
        z124 = k2 * z80
        z125 = z2 * z124 - z5 * z113
        z126 = g * mu3 + (w1 * z26 + w2 * u1 - (w2 * z122 - w1 * z125))
        s2 = s_beta * z117 - (c_beta * z118 + (r3 * z123 + z6 * z126))
        z127 = w2 * z114 - s2
        z128 = I_d * w2
        z129 = z128 + I_a * w1
        z130 = g * z1 - (w2 * z42 - w3 * z26 - (w2 * z120 + w3 * z125))
        z131 = w3 * z129 - w1 * z114 + (r3 * z130 + r1 * z126) - z14 * z127
        z132 = 1.0 / z23
        s3 = c_beta * z117 + (s_beta * z118 + (z6 * z130 - r1 * z123))
        z133 = w2 * z129 - s3 - z18 * z127
        z134 = z132 * (z133 + z22 * z131)
        z135 = z21 * z131 + z22 * z134
        z136 = z13 * z127 - z14 * z135 - z18 * z134
        z137 = z6 * z136
        z138 = r1 * z135
        z139 = w3 * z86 - (w1 * z24 + (2.0 * z137 - (z126 - z138)))
        s4 = z83 + (z80 * z90 - z91 * z100 + z92 * z104)
        z140 = s4 - k2 * (z41 * z113 - z2 * z139)
        z141 = z27 * z27 * z112
        z142 = r3 * z136
        z143 = r1 * z134
        z144 = w2 * z86 + (w1 * z41 - (2.0 * z142 - (z123 - z143)))
        s5 = z119 * z24 + z124 * z41 - z121 * z86 + z111 * z88
        z145 = s5 - z3 * z144 + z5 * z139
        z146 = w2 * z24
        z147 = w3 * z41
        z148 = r3 * z134
        z149 = z6 * z135
        z150 = z146 + (z147 + (z148 + z149))
        z151 = z87 * z141 + 0.5 * (z28 * (z145 - z9 * z150))
        z152 = z91 * z107 + z92 * z110
        z153 = z91 * z109 + z92 * z108
        z154 = z1 * z152 - mu3 * z153
        z155 = s_beta * z17
        z156 = z155 - c_beta * z8
        z157 = z105 * z94 - z108 * z8 - z110 * z17 - mu2 * z104
        z158 = s_beta * z116
        z159 = z6 * z125
        z160 = I_d * w3 - z6 * z26
        z161 = r3 * z42
        z162 = r3 * z120
        z163 = z159 - (z160 + z161 - z162)
        z164 = z6 * z86 - (r1 * z41 - (I_c * w2 - r3 * u1 + r3 * z122))
        z165 = z158 + mu2 * z100 - c_beta * z163 - s_beta * z164
        z166 = g * z6
        z167 = z76 * z156
        z168 = mu2 * z90 + z41 * z45 - z76 * z165
        s6 = z166 - (z110 * z96 + z153 * z167) + w1 * z168
        z169 = s6 + k3 * (z24 * z113 - z2 * z144)
        z170 = z169 - 2.0 * (z3 * z151)
        s7 = z77 * (z154 * z156 - z75 * z157 - z80 * z165)
        z171 = z109 * z97 - z107 * z99 - s7 + c_beta * z170
        s8 = z108 * z98 - z152 * z167 - w3 * z168
        z172 = s8 + k1 * (z86 * z113 + z2 * z150) + 2.0 * (z9 * z151)
        s9 = c_alpha * (z140 - 2.0 * (z5 * z151))
        z173 = s9 - mu2 * (z171 - s_beta * z172)
        z174 = r1 * w1
        z175 = z85 + z174
        z176 = z9 * z40 - (z3 * z37 - z5 * z175)
        z177 = z27 * z176
        z178 = z2 * z177
        z179 = k2 * z178
        z180 = s_beta * z12 - c_beta * z19
        z181 = k3 * z178
        z182 = z92 * z19 - (mu3 * z181 + z37 * z32)
        z183 = k1 * z178
        z184 = z92 * z12 + (z1 * z183 - z40 * z34)
        z185 = z92 * z180 + c_beta * z182 - s_beta * z184
        z186 = z75 * z12 - c_alpha * z184
        z187 = z75 * z19 - c_alpha * z182
        z188 = c_beta * z186 + s_beta * z187
        z189 = w3 * z40
        z190 = r1 * z136
        z191 = z189 - (z146 - (z148 - z190))
        z192 = r3 * z135
        z193 = z6 * z134
        z194 = w2 * z40 + (w1 * z175 - (2.0 * z192 - (z130 + z193)))
        s10 = z40 * z121 - (z37 * z119 + z124 * z175) + z111 * z177
        z195 = s10 + z3 * z194 - z5 * z191
        z196 = w2 * z37 + (w3 * z175 + (z137 - (z126 - 2.0 * z138)))
        z197 = z176 * z141 + 0.5 * (z28 * (z195 + z9 * z196))
        s11 = z80 * z179 + z91 * z185 - z92 * z188
        z198 = s11 + k2 * (z175 * z113 - z2 * z191) - 2.0 * (z5 * z197)
        z199 = c_beta * z12 + s_beta * z19
        z200 = z105 * z180 - z108 * z12 + z110 * z19 - mu2 * z188
        z201 = z6 * z37 - (r3 * z175 + (w3 * k6 + r1 * z26 + r1 * z125))
        s12 = r1 * z175 - (z129 - I_c * w1 + r3 * z26 + r3 * z125)
        z202 = z6 * z40 - s12
        z203 = mu2 * z185 + c_beta * z201 - s_beta * z202
        z204 = g * r1
        z205 = z76 * z199
        z206 = mu2 * z179 - z175 * z45 + z76 * z203
        s13 = z204 + (z153 * z205 + z110 * z181) - w1 * z206
        z207 = s13 + k3 * (z37 * z113 - z2 * z194)
        z208 = z207 + 2.0 * (z3 * z197)
        s14 = z77 * (z154 * z199 + z75 * z200 + z80 * z203)
        z209 = z109 * z182 + z107 * z184 - s14 - c_beta * z208
        s15 = z83 - (z152 * z205 - z108 * z183) - w3 * z206
        z210 = s15 - k1 * (z40 * z113 + z2 * z196)
        z211 = z210 + 2.0 * (z9 * z197)
        z212 = c_alpha * z198 - mu2 * (z209 - s_beta * z211) + z14 * z173
        z213 = z84 - z174
        z214 = z3 * z213 - z5 * z38 - z9 * z25
        z215 = z27 * z214
        z216 = z2 * z215
        z217 = k2 * z216
        z218 = z155 + c_beta * z16
        z219 = k3 * z216
        z220 = z92 * z16 + (mu3 * z219 - z213 * z32)
        z221 = k1 * z216
        z222 = z95 + (z1 * z221 + z25 * z34)
        z223 = z92 * z218 - c_beta * z220 - s_beta * z222
        z224 = z102 - c_alpha * z222
        z225 = z75 * z16 - c_alpha * z220
        z226 = c_beta * z224 - s_beta * z225
        z227 = w3 * z25 - (w1 * z213 - (2.0 * z193 + (z130 - z192)))
        s16 = z204 - (z80 * z217 + z91 * z223 - z92 * z226)
        z228 = s16 + k2 * (z38 * z113 - z2 * z227)
        z229 = z189 + (z147 - (z149 - z190))
        s17 = z119 * z213 + z124 * z38 - z121 * z25 + z111 * z215
        z230 = s17 - z3 * z229 + z5 * z227
        z231 = w2 * z213 + (w3 * z38 - (z142 - (z123 - 2.0 * z143)))
        z232 = z214 * z141 + 0.5 * (z28 * (z230 - z9 * z231))
        z233 = z93 - s_beta * z16
        z234 = z105 * z218 - z108 * z17 - z110 * z16 - mu2 * z226
        z235 = c_beta * z116
        s18 = r3 * z38 + (z115 - I_a * w2 + r1 * z42 - r1 * z120)
        z236 = z6 * z213 - s18
        z237 = r1 * z122
        z238 = z159 + (z161 - z237)
        z239 = z235 + mu2 * z223 - c_beta * z236 + s_beta * z238
        z240 = z76 * z233
        z241 = mu2 * z217 + z38 * z45 + z76 * z239
        s19 = z110 * z219 + z153 * z240 - w1 * z241
        z242 = s19 - k3 * (z213 * z113 - z2 * z229) + 2.0 * (z3 * z232)
        s20 = z77 * (z154 * z233 + z75 * z234 + z80 * z239)
        z243 = z109 * z220 - z107 * z222 + s20 + c_beta * z242
        s21 = z166 - (z108 * z221 - z152 * z240) + w3 * z241
        z244 = s21 - k1 * (z25 * z113 + z2 * z231)
        z245 = z244 - 2.0 * (z9 * z232)
        s22 = c_alpha * (z228 + 2.0 * (z5 * z232))
        z246 = s22 - mu2 * (z243 - s_beta * z245) - z18 * z173 - z22 * z212
        z247 = z132 * z246
        z248 = z21 * z212 - z22 * z247
        z249 = z76 * z154
        z250 = z249 * z17
        z251 = s_beta * z153 + c_beta * z152 - z92 * z105
        s23 = z250 - (z117 - z251 * z8) + z153 * z94 + z105 * z99
        z252 = s23 - z106 * z103 + z75 * z163
        s24 = z109 * z17 - (z235 + z107 * z8) - s_beta * z163
        z253 = s24 + c_beta * z164 + z76 * z157
        z254 = z251 * z17
        s25 = z254 + (z118 - z249 * z8) + z152 * z94 + z105 * z97
        z255 = s25 + z106 * z101 + z91 * z163
        s26 = c_beta * (z252 + z91 * z164 - w1 * z253 - c_alpha * z172)
        s27 = s_beta * (z255 - z75 * z164 + w3 * z253 + c_alpha * z170)
        z256 = s26 - s27
        s28 = z251 * z12 - z249 * z19 + z153 * z180 + z105 * z184
        z257 = s28 + z106 * z187 - z75 * z201
        s29 = z107 * z12 + z109 * z19 - s_beta * z201 - c_beta * z202
        z258 = s29 - z76 * z200
        s30 = z249 * z12 + z251 * z19 - z152 * z180 + z105 * z182
        z259 = s30 - z106 * z186 + z91 * z201
        s31 = c_beta * (z257 + z91 * z202 + w1 * z258 + c_alpha * z211)
        s32 = s_beta * (z259 + z75 * z202 + w3 * z258 - c_alpha * z208)
        z260 = s31 + s32
        z261 = z260 - z14 * z256
        s33 = z118 - z254 - z249 * z16 - z153 * z218 - z105 * z222
        z262 = s33 + z106 * z225 - z75 * z236
        s34 = z107 * z17 - z158 - z109 * z16 + s_beta * z236
        z263 = s34 + c_beta * z238 - z76 * z234
        s35 = z117 + z250 - z251 * z16 - z152 * z218 - z105 * z220
        z264 = s35 - z106 * z224 - z91 * z236
        s36 = c_beta * (z262 + z91 * z238 - w1 * z263 + c_alpha * z245)
        s37 = s_beta * (z264 - z75 * z238 + w3 * z263 - c_alpha * z242)
        z265 = s36 - s37
        z266 = z132 * (z265 + z18 * z256 - z22 * z261)
        z267 = z21 * z261 - z22 * z266
        z268 = s_beta * z253 - mu3 * z168
        z269 = s_beta * z258 - mu3 * z206 + z14 * z268
        z270 = z132 * (s_beta * z263 - mu3 * z241 + z18 * z268 + z22 * z269)
        z271 = z21 * z269 + z22 * z270
        z272 = r3 * z86 - (r1 * z24 + (w3 * k5 - z6 * u1 + z6 * z122 - z104))
        z273 = z162 + (z160 - z237) + z188 - z14 * z272
        s38 = z128 + (z129 - I_b * w1) + z6 * z42 - z6 * z120 + z226
        z274 = r3 * z25 - (r1 * z213 + s38)
        z275 = z132 * (z274 + z18 * z272 - z22 * z273)
        z276 = z21 * z273 - z22 * z275
        z277 = c_beta * z253 + z1 * z168
        z278 = c_beta * z258 + z1 * z206 + z14 * z277
        z279 = z132 * (c_beta * z263 + z1 * z241 + z18 * z277 + z22 * z278)
        z280 = z21 * z278 + z22 * z279
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z51 - s_gamma * z50,
            # (I.2.15)
            s_gamma * z62 - c_gamma * z63,
            # (I.2.15)
            s_gamma * z64 + c_gamma * z67,
            # (I.2.15)
            -(s_gamma * z69 + c_gamma * z70),
            # (I.2.15)
            -(s_gamma * z72 + c_gamma * z73),
            # (I.2.15)
            c_gamma * z68 - s_gamma * z74,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_gamma * z51 + c_gamma * z50,
            # (I.2.15)
            -(s_gamma * z63 + c_gamma * z62),
            # (I.2.15)
            s_gamma * z67 - c_gamma * z64,
            # (I.2.15)
            c_gamma * z69 - s_gamma * z70,
            # (I.2.15)
            c_gamma * z72 - s_gamma * z73,
            # (I.2.15)
            s_gamma * z68 + c_gamma * z74,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z66 + c_alpha * z49 - (z65 - mu2 * z36),
            # (I.2.15)
            -(mu2 * z55 + c_alpha * z61),
            0.0,
            # (I.2.15)
            -(mu2 * r3 + c_alpha * z68),
            # (I.2.15)
            -c_alpha * z71,
            # (I.2.15)
            mu2 * r1 - c_alpha * z70,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            0.0,
            # (I.2.15)
            -z75,
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
            z75 + mu2 * z79,
            # (I.2.15)
            z80 * z78,
            0.0,
            # (I.2.15)
            mu2 * z81,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -mu2 * z82,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z79,
            # (I.2.15)
            -z76 * (c_beta * w1 + s_beta * w3),
            0.0,
            # (I.2.15)
            -z81,
            0.0,
            # (I.2.15)
            z82,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z18 * z247 - (z13 * z173 + z14 * z248),
            # (I.2.15)
            -(z13 * z256 - z14 * z267 + z18 * z266),
            0.0,
            # (I.2.15)
            z13 * z268 + z14 * z271 + z18 * z270,
            # (I.2.15)
            -(z13 * z272 - z14 * z276 + z18 * z275),
            # (I.2.15)
            -(z13 * z277 + z14 * z280 + z18 * z279),
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z248,
            # (I.2.15)
            -z267,
            0.0,
            # (I.2.15)
            -z271,
            # (I.2.15)
            -z276,
            # (I.2.15)
            z280,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z247,
            # (I.2.15)
            -z266,
            0.0,
            # (I.2.15)
            z270,
            # (I.2.15)
            -z275,
            # (I.2.15)
            -z279,
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
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "outputs")
        out: list[float] = [
            # spin 53:9
            w3,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
