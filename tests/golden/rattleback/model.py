"""rattleback, emitted by nhc 0.1.0 (nhc:d9deb92942b38bcf).

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

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 64 +-, 118 *, 5 /, 7 calls
velocities: 15 +-, 40 *, 2 /, 7 calls
accelerations: 97 +-, 161 *, 5 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 86 +-, 154 *, 5 /, 7 calls
energy: 13 +-, 36 *, 1 /, 5 calls
jacobian: 442 +-, 662 *, 5 /, 7 calls
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
        z28 = c_beta * w1 + s_beta * w3
        z29 = s_beta * w1 - c_beta * w3
        z30 = z29 / c_alpha
        z31 = w2 + mu2 * z30
        z32 = I_c * w3
        z33 = I_b * w2 + I_d * w1
        z34 = z28 * z33
        z35 = z29 * z33
        z36 = mu2 * z28
        z37 = s_beta * z36 - mu3 * z31
        z38 = c_alpha * z28
        z39 = c_beta * z36 + z1 * z31
        z40 = (z9 * z37 - z5 * z38 + z3 * z39) * (z2 * (z2 * z2))
        z41 = z3 * z40 - k3 * (z2 * z39)
        z42 = k1 * (z2 * z37) - z9 * z40
        z43 = g * mu2 - (w3 * u1 + w1 * z24 + (w1 * z41 - w3 * z42))
        z44 = z5 * z40 + k2 * (z2 * z38)
        z45 = g * mu3 + (w1 * z23 + w2 * u1 - (w2 * z42 - w1 * z44))
        s2 = s_beta * z34 - (c_beta * z35 + (r3 * z43 + z6 * z45))
        z46 = w2 * z32 - s2
        z47 = I_d * w2 + I_a * w1
        z48 = g * z1 - (w2 * z24 - w3 * z23 + (w2 * z41 - w3 * z44))
        z49 = w3 * z47 - w1 * z32 + (r3 * z48 + r1 * z45) - z14 * z46
        s3 = c_beta * z34 + (s_beta * z35 + (z6 * z48 - r1 * z43))
        z50 = w2 * z47 - s3 - z18 * z46
        z51 = (z50 + z21 * z49) / z22
        z52 = z20 * z49 + z21 * z51
        dydt: list[float] = [
            # x' (I.2.15)
            s_gamma * z26 - c_gamma * z27,
            # y' (I.2.15)
            -(s_gamma * z27 + c_gamma * z26),
            # z' (I.2.15)
            -(mu2 * z23 + c_alpha * z25),
            # alpha' (I.2.15)
            z28,
            # beta' (I.2.15)
            z31,
            # gamma' (I.2.15)
            -z30,
            # w1' (I.2.15) 41:4
            z18 * z51 - (z13 * z46 - z14 * z52),
            # w2' (I.2.15) 41:4
            -z52,
            # w3' (I.2.15) 41:4
            z51,
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
        z9 = (s_beta * w1 - c_beta * w3) / c_alpha
        qdot: list[float] = [
            # x' (I.2.4)
            s_gamma * z7 - c_gamma * z8,
            # y' (I.2.4)
            -(s_gamma * z8 + c_gamma * z7),
            # z' (I.2.4)
            -(mu2 * z3 + c_alpha * z6),
            # alpha' (I.2.4)
            c_beta * w1 + s_beta * w3,
            # beta' (I.2.4)
            w2 + mu2 * z9,
            # gamma' (I.2.4)
            -z9,
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
        z31 = c_beta * w1 + s_beta * w3
        z32 = mu2 * z31
        z33 = c_alpha * z31
        z34 = w2 + mu2 * z29
        z35 = c_beta * z34
        z36 = s_beta * z32 - c_alpha * z35
        z37 = s_beta * z34
        z38 = c_alpha * z37 + c_beta * z32
        z39 = z2 * (z2 * z2) * (z5 * z33 - z9 * z36 - z3 * z38)
        z40 = z3 * z39 + k3 * (z2 * z38)
        z41 = w1 * z40
        z42 = I_c * w3
        z43 = I_b * w2 + I_d * w1
        z44 = z31 * z43
        z45 = z28 * z43
        z46 = k1 * (z2 * z36) + z9 * z39
        z47 = w3 * z46
        z48 = g * mu2 - (w3 * u1 + w1 * z24 - (z41 + z47))
        z49 = w2 * z46
        z50 = k2 * (z2 * z33) - z5 * z39
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
        z67 = z32 * z23 - c_alpha * z63 + (z33 * z25 + mu2 * z66)
        z68 = s_beta * z24 - c_beta * u1
        z69 = s_gamma * z29
        z70 = z35 * z24 - s_beta * z65 + (z37 * u1 - c_beta * z64)
        s4 = z27 * (w1 * z35 - s_beta * z62 + (w3 * z37 - c_beta * z60))
        z71 = z27 * z27 * (z28 * z32) + s4
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z26 * z30 + s_gamma * z67 + (z68 * z69 + c_gamma * z70)),
            # y'' (I.2.15)
            z68 * z30 - s_gamma * z70 - (z26 * z69 - c_gamma * z67),
            # z'' (I.2.15)
            z32 * z25 - c_alpha * z66 - (z33 * z23 + mu2 * z63),
            # alpha'' (I.2.15)
            w3 * z35 + s_beta * z60 - (w1 * z37 + c_beta * z62),
            # beta'' (I.2.15)
            z29 * z33 + mu2 * z71 - z61,
            # gamma'' (I.2.15)
            -z71,
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
        c_gamma = math.cos(gamma)
        s_gamma = math.sin(gamma)
        z23 = mu2 * s_gamma
        z24 = s_beta * c_gamma + c_beta * z23
        z25 = r3 * w1 - r1 * w3
        u1 = r3 * w2 + z6 * w3
        z26 = c_beta * w1 + s_beta * w3
        z27 = mu2 * z26
        z28 = s_beta * w1 - c_beta * w3
        z29 = w2 + z28 * (mu2 / c_alpha)
        z30 = s_beta * z27 - mu3 * z29
        z31 = c_alpha * z26
        z32 = c_beta * z27 + z1 * z29
        z33 = z2 * (z2 * z2) * (z5 * z31 - z9 * z30 - z3 * z32)
        z34 = k1 * (z2 * z30) + z9 * z33
        z35 = k2 * (z2 * z31) - z5 * z33
        z36 = g * mu3 + (w1 * z25 + w2 * u1 - (w2 * z34 - w1 * z35))
        z37 = c_beta * c_gamma - s_beta * z23
        z38 = r1 * w2 + z6 * w1
        z39 = z3 * z33 + k3 * (z2 * z32)
        z40 = g * z1 - (w2 * z38 - w3 * z25 - (w2 * z39 + w3 * z35))
        z41 = c_alpha * s_gamma
        z42 = g * mu2 - (w3 * u1 + w1 * z38 - (w1 * z39 + w3 * z34))
        z43 = I_d * w2 + I_a * w1
        z44 = I_b * w2 + I_d * w1
        z45 = z26 * z44
        z46 = z28 * z44
        z47 = I_c * w3
        s2 = s_beta * z45 - (c_beta * z46 + (r3 * z42 + z6 * z36))
        z48 = w2 * z47 - s2
        s3 = c_beta * z45 + (s_beta * z46 + (z6 * z40 - r1 * z42))
        z49 = w2 * z43 - s3 - z18 * z48
        z50 = w3 * z43 - w1 * z47 + (r3 * z40 + r1 * z36) - z14 * z48
        z51 = (z49 + z21 * z50) / z22
        z52 = z20 * z50 + z21 * z51
        z53 = z13 * z48 - z14 * z52 - z18 * z51
        s4 = (r3 * z41 - z6 * z24) * z53 + (r3 * z37 - r1 * z24) * z52
        z54 = (z6 * z37 - r1 * z41) * z51 - s4
        z55 = mu2 * c_gamma
        z56 = s_beta * s_gamma - c_beta * z55
        z57 = c_beta * s_gamma + s_beta * z55
        z58 = c_alpha * c_gamma
        s5 = (r3 * z58 + z6 * z56) * z53 - (r3 * z57 - r1 * z56) * z52
        z59 = (z6 * z57 + r1 * z58) * z51 + s5
        s6 = (mu2 * r3 + mu3 * z6) * z53 + (z1 * r3 + mu3 * r1) * z52
        z60 = (mu2 * r1 - z1 * z6) * z51 + s6
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            z54 - (z24 * z36 - (z37 * z40 + z41 * z42)),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z59 - (z56 * z36 - (z57 * z40 - z58 * z42)),
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z60 - (mu3 * z36 + (z1 * z40 + mu2 * z42)),
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
        s_beta = math.sin(beta)
        z1 = c_alpha * s_beta
        mu2 = math.sin(alpha)
        c_beta = math.cos(beta)
        mu3 = c_beta * c_alpha
        s1 = k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3)
        z2 = 1.0 / math.sqrt(s1)
        r3 = h - z2 * (mu3 * k3)
        z3 = z2 * (mu2 * k2)
        u1 = r3 * w2 + z3 * w3
        r1 = z1 * k1 * z2
        z4 = r3 * w1 - r1 * w3
        z5 = r1 * w2 + z3 * w1
        s2 = I_c * (w3 * w3) + (I_b * (w2 * w2) + I_a * (w1 * w1))
        z6 = u1 * u1 + z4 * z4 + z5 * z5 + s2
        value1 = 0.5 * z6 + w2 * (I_d * w1) - z * g
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
        z77 = z75 * (z76 * z76)
        z78 = mu2 * z77
        z79 = c_beta * w1 + s_beta * w3
        z80 = z76 * z79
        z81 = s_beta * z76
        z82 = c_beta * z76
        z83 = g * r3
        z84 = c_alpha * z79
        z85 = z6 * w2
        z86 = r3 * w3
        z87 = z85 - z86
        z88 = z3 * z24 - z5 * z41 - z9 * z87
        z89 = z27 * z88
        z90 = z2 * z89
        z91 = k2 * z90
        z92 = z76 * z75
        z93 = c_beta * z17
        z94 = z93 + s_beta * z8
        z95 = c_beta * z94
        z96 = k3 * z90
        z97 = z92 * z95 - (mu3 * z96 - z24 * z32)
        z98 = s_beta * z94
        z99 = k1 * z90
        z100 = z92 * z98 - (z1 * z99 + z87 * z34)
        z101 = z92 * z94 - c_beta * z97 - s_beta * z100
        z102 = s_beta * z17
        z103 = z75 * z8 - z79 * (z17 - z95) - c_alpha * z100
        z104 = z75 * z17
        z105 = z104 + z79 * (z8 - z98) - c_alpha * z97
        z106 = z75 * (z102 - c_beta * z8) + c_beta * z103 - s_beta * z105
        z107 = mu2 * z79
        z108 = w2 + mu2 * z92
        z109 = c_beta * z108
        z110 = s_beta * z107 - c_alpha * z109
        z111 = s_beta * z108
        z112 = c_alpha * z111 + c_beta * z107
        z113 = z5 * z84 - z9 * z110 - z3 * z112
        z114 = z2 * z113
        z115 = z27 * z114
        z116 = I_c * w3
        z117 = I_d * w1
        z118 = I_b * w2 + z117
        z119 = z79 * z118
        z120 = z75 * z118
        z121 = k3 * z112
        z122 = z2 * z121 + z3 * z115
        z123 = k1 * z110
        z124 = z2 * z123 + z9 * z115
        z125 = g * mu2 - (w3 * u1 + w1 * z42 - (w1 * z122 + w3 * z124))
        z126 = k2 * z84
        z127 = z2 * z126 - z5 * z115
        z128 = g * mu3 + (w1 * z26 + w2 * u1 - (w2 * z124 - w1 * z127))
        s2 = s_beta * z119 - (c_beta * z120 + (r3 * z125 + z6 * z128))
        z129 = w2 * z116 - s2
        z130 = I_d * w2
        z131 = z130 + I_a * w1
        z132 = g * z1 - (w2 * z42 - w3 * z26 - (w2 * z122 + w3 * z127))
        z133 = w3 * z131 - w1 * z116 + (r3 * z132 + r1 * z128) - z14 * z129
        z134 = 1.0 / z23
        s3 = c_beta * z119 + (s_beta * z120 + (z6 * z132 - r1 * z125))
        z135 = w2 * z131 - s3 - z18 * z129
        z136 = z134 * (z135 + z22 * z133)
        z137 = z21 * z133 + z22 * z136
        z138 = z13 * z129 - z14 * z137 - z18 * z136
        z139 = z6 * z138
        z140 = r1 * z137
        z141 = w3 * z87 - (w1 * z24 + (2.0 * z139 - (z128 - z140)))
        s4 = z83 + (z84 * z91 - z79 * z101 + z92 * z106)
        z142 = s4 - k2 * (z41 * z115 - z2 * z141)
        z143 = z27 * z27 * z114
        z144 = r3 * z138
        z145 = r1 * z136
        z146 = w2 * z87 + (w1 * z41 - (2.0 * z144 - (z125 - z145)))
        s5 = z121 * z24 + z126 * z41 - z123 * z87 + z113 * z89
        z147 = s5 - z3 * z146 + z5 * z141
        z148 = w2 * z24
        z149 = w3 * z41
        z150 = r3 * z136
        z151 = z6 * z137
        z152 = z148 + (z149 + (z150 + z151))
        z153 = z88 * z143 + 0.5 * (z28 * (z147 - z9 * z152))
        z154 = mu2 * z91 + z41 * z45
        z155 = mu2 * z106
        z156 = g * z6
        s6 = z156 - z112 * z96 + k3 * (z24 * z115 - z2 * z146)
        z157 = s6 - 2.0 * (z3 * z153)
        s7 = z110 * z99 + k1 * (z87 * z115 + z2 * z152)
        z158 = s7 + 2.0 * (z9 * z153)
        s8 = z79 * z154 + z111 * z97 - z109 * z100 - z77 * z155
        z159 = s8 + c_beta * z157 - s_beta * z158
        z160 = c_alpha * (z142 - 2.0 * (z5 * z153)) - mu2 * z159
        z161 = r1 * w1
        z162 = z86 + z161
        z163 = z9 * z40 - (z3 * z37 - z5 * z162)
        z164 = z27 * z163
        z165 = z2 * z164
        z166 = k2 * z165
        z167 = s_beta * z12 - c_beta * z19
        z168 = c_beta * z167
        z169 = k3 * z165
        z170 = z92 * z168 + (mu3 * z169 + z37 * z32)
        z171 = s_beta * z167
        z172 = k1 * z165
        z173 = z92 * z171 + (z1 * z172 - z40 * z34)
        z174 = z92 * z167 - c_beta * z170 - s_beta * z173
        z175 = z75 * z12 + z79 * (z19 + z168) - c_alpha * z173
        z176 = z75 * z19 - z79 * (z12 - z171) + c_alpha * z170
        s9 = z75 * (c_beta * z12 + s_beta * z19) - c_beta * z175
        z177 = s9 - s_beta * z176
        z178 = w3 * z40
        z179 = r1 * z138
        z180 = z178 - (z148 - (z150 - z179))
        z181 = r3 * z137
        z182 = z6 * z136
        z183 = w2 * z40 + (w1 * z162 - (2.0 * z181 - (z132 + z182)))
        s10 = z40 * z123 - (z37 * z121 + z126 * z162) + z113 * z164
        z184 = s10 + z3 * z183 - z5 * z180
        z185 = w2 * z37 + (w3 * z162 + (z139 - (z128 - 2.0 * z140)))
        z186 = z163 * z143 + 0.5 * (z28 * (z184 + z9 * z185))
        s11 = z84 * z166 + z79 * z174 + z92 * z177
        z187 = s11 + k2 * (z162 * z115 - z2 * z180) - 2.0 * (z5 * z186)
        z188 = mu2 * z166 - z45 * z162
        z189 = mu2 * z177
        z190 = g * r1
        s12 = z190 + z112 * z169 + k3 * (z37 * z115 - z2 * z183)
        z191 = s12 + 2.0 * (z3 * z186)
        s13 = z83 + z110 * z172 - k1 * (z40 * z115 + z2 * z185)
        z192 = s13 + 2.0 * (z9 * z186)
        s14 = z79 * z188 - z111 * z170 + z109 * z173 - z77 * z189
        z193 = s14 - c_beta * z191 - s_beta * z192
        z194 = c_alpha * z187 - mu2 * z193 + z14 * z160
        z195 = z85 - z161
        z196 = z3 * z195 - z5 * z38 - z9 * z25
        z197 = z27 * z196
        z198 = z2 * z197
        z199 = k2 * z198
        z200 = z102 + c_beta * z16
        z201 = c_beta * z200
        z202 = k3 * z198
        z203 = z92 * z201 + (mu3 * z202 - z195 * z32)
        z204 = s_beta * z200
        z205 = k1 * z198
        z206 = z92 * z204 + (z1 * z205 + z25 * z34)
        z207 = z92 * z200 - c_beta * z203 - s_beta * z206
        z208 = z104 - z79 * (z16 - z201) - c_alpha * z206
        z209 = z75 * z16 + z79 * (z17 - z204) - c_alpha * z203
        z210 = z75 * (z93 - s_beta * z16) - c_beta * z208 + s_beta * z209
        z211 = w3 * z25 - (w1 * z195 - (2.0 * z182 + (z132 - z181)))
        s15 = z190 - (z84 * z199 + z79 * z207 + z92 * z210)
        z212 = s15 + k2 * (z38 * z115 - z2 * z211)
        z213 = z178 + (z149 - (z151 - z179))
        s16 = z121 * z195 + z126 * z38 - z123 * z25 + z113 * z197
        z214 = s16 - z3 * z213 + z5 * z211
        z215 = w2 * z195 + (w3 * z38 - (z144 - (z125 - 2.0 * z145)))
        z216 = z196 * z143 + 0.5 * (z28 * (z214 - z9 * z215))
        z217 = mu2 * z199 + z38 * z45
        z218 = mu2 * z210
        s17 = z112 * z202 - k3 * (z195 * z115 - z2 * z213)
        z219 = s17 + 2.0 * (z3 * z216)
        s18 = z156 - z110 * z205 - k1 * (z25 * z115 + z2 * z215)
        z220 = s18 - 2.0 * (z9 * z216)
        s19 = z79 * z217 - z111 * z203 + z109 * z206 - z77 * z218
        z221 = s19 - c_beta * z219 + s_beta * z220
        s20 = c_alpha * (z212 + 2.0 * (z5 * z216)) + mu2 * z221
        z222 = z134 * (s20 - z18 * z160 - z22 * z194)
        z223 = z21 * z194 - z22 * z222
        z224 = z75 * z108
        z225 = z224 * z17
        z226 = z79 * z111 + z92 * z110
        z227 = z79 * z109 + z92 * z112
        z228 = s_beta * z226 + c_beta * z227 - z92 * z107
        z229 = z6 * z127
        z230 = I_d * w3 - z6 * z26
        z231 = r3 * z42
        z232 = r3 * z122
        z233 = z229 - (z230 + z231 - z232)
        s21 = z225 - (z119 - z228 * z8) + z226 * z94 + z107 * z100
        z234 = s21 - z108 * z105 + z75 * z233
        z235 = z6 * z87 - (r1 * z41 - (I_c * w2 - r3 * u1 + r3 * z124))
        z236 = c_beta * z118
        z237 = z236 + s_beta * z233 - c_beta * z235 + z76 * z155
        s22 = s_beta * z118 - c_alpha * z154 + mu2 * z101 - c_beta * z233
        z238 = s22 - s_beta * z235
        z239 = z228 * z17
        s23 = z239 + (z120 - z224 * z8) + z227 * z94 + z107 * z97
        z240 = s23 + z108 * z103 + z79 * z233
        s24 = z234 + z79 * z235 + w1 * z237 - w3 * z238 - c_alpha * z158
        s25 = z240 - z75 * z235 - w3 * z237 - w1 * z238 + c_alpha * z157
        z241 = c_beta * s24 - s_beta * s25
        z242 = z6 * z37 - (r3 * z162 + (w3 * k6 + r1 * z26 + r1 * z127))
        s26 = z228 * z12 - z224 * z19 + z226 * z167 + z107 * z173
        z243 = s26 + z108 * z176 - z75 * z242
        s27 = r1 * z162 - (z131 - I_c * w1 + r3 * z26 + r3 * z127)
        z244 = z6 * z40 - s27
        z245 = s_beta * z242 + c_beta * z244 + z76 * z189
        z246 = c_alpha * z188 + mu2 * z174 + c_beta * z242 - s_beta * z244
        s28 = z224 * z12 + z228 * z19 - z227 * z167 - z107 * z170
        z247 = s28 - z108 * z175 + z79 * z242
        s29 = z243 + z79 * z244 - w1 * z245 - w3 * z246 + c_alpha * z192
        s30 = z247 + z75 * z244 - w3 * z245 + w1 * z246 - c_alpha * z191
        z248 = c_beta * s29 + s_beta * s30
        z249 = z248 - z14 * z241
        s31 = r3 * z38 + (z117 - I_a * w2 + r1 * z42 - r1 * z122)
        z250 = z6 * z195 - s31
        s32 = z120 - z239 - z224 * z16 - z226 * z200 - z107 * z206
        z251 = s32 + z108 * z209 - z75 * z250
        z252 = r1 * z124
        z253 = z229 + (z231 - z252)
        z254 = s_beta * (z118 - z250) - c_beta * z253 + z76 * z218
        s33 = z236 + c_alpha * z217 + mu2 * z207 - c_beta * z250
        z255 = s33 + s_beta * z253
        s34 = z119 + z225 - z228 * z16 - z227 * z200 - z107 * z203
        z256 = s34 - z108 * z208 - z79 * z250
        s35 = z251 + z79 * z253 + w1 * z254 + w3 * z255 + c_alpha * z220
        s36 = z256 - z75 * z253 - w3 * z254 + w1 * z255 - c_alpha * z219
        z257 = c_beta * s35 - s_beta * s36
        z258 = z134 * (z257 + z18 * z241 - z22 * z249)
        z259 = z21 * z249 - z22 * z258
        z260 = s_beta * z237 - c_beta * z238
        z261 = s_beta * z245 + c_beta * z246 + z14 * z260
        s37 = s_beta * z254 + c_beta * z255 + z18 * z260 + z22 * z261
        z262 = z134 * s37
        z263 = z21 * z261 + z22 * z262
        z264 = r3 * z87 - (r1 * z24 + (w3 * k5 - z6 * u1 + z6 * z124 - z106))
        z265 = z232 + (z230 - z252) - z177 - z14 * z264
        s38 = z130 + (z131 - I_b * w1) + z6 * z42 - z6 * z122 - z210
        z266 = r3 * z25 - (r1 * z195 + s38)
        z267 = z134 * (z266 + z18 * z264 - z22 * z265)
        z268 = z21 * z265 - z22 * z267
        z269 = c_beta * z237 + s_beta * z238
        z270 = c_beta * z245 - s_beta * z246 + z14 * z269
        s39 = c_beta * z254 - s_beta * z255 + z18 * z269 + z22 * z270
        z271 = z134 * s39
        z272 = z21 * z270 + z22 * z271
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
            z75 + mu2 * z78,
            # (I.2.15)
            mu2 * z80,
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
            -z78,
            # (I.2.15)
            -z80,
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
            z18 * z222 - (z13 * z160 + z14 * z223),
            # (I.2.15)
            -(z13 * z241 - z14 * z259 + z18 * z258),
            0.0,
            # (I.2.15)
            -(z13 * z260 + z14 * z263 + z18 * z262),
            # (I.2.15)
            -(z13 * z264 - z14 * z268 + z18 * z267),
            # (I.2.15)
            z13 * z269 + z14 * z272 + z18 * z271,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z223,
            # (I.2.15)
            -z259,
            0.0,
            # (I.2.15)
            z263,
            # (I.2.15)
            -z268,
            # (I.2.15)
            -z272,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z222,
            # (I.2.15)
            -z258,
            0.0,
            # (I.2.15)
            -z262,
            # (I.2.15)
            -z267,
            # (I.2.15)
            z271,
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
