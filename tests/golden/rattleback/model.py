"""rattleback, emitted by nhc 0.1.0 (nhc:5108d9d0c8f8a87b).

A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt,
    wobblestone).
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

Constraints, with the units of their reactions:
0: roll_x [cm/s^2]
1: roll_y [cm/s^2]
2: roll_z [cm/s^2]

Outputs:
out[0] = spin [rad/s]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 61 +-, 112 *, 5 /, 7 calls
velocities: 15 +-, 40 *, 2 /, 7 calls
accelerations: 94 +-, 161 *, 5 /, 7 calls
state: 3 +-, 6 *, 0 /, 4 calls
residuals: 18 +-, 40 *, 1 /, 7 calls
reactions: 86 +-, 154 *, 5 /, 7 calls
energy: 13 +-, 36 *, 1 /, 5 calls
jacobian: 439 +-, 662 *, 5 /, 7 calls
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
    "the mass matrix is singular, or the velocities that are kept do not suffice",
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
    """Right-hand side dy/dt = f(t, y; p) (I.2.15).

    Arguments: t (scalar), y (9,), p (9,).
    Returns dydt (9,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
        # the coframe is singular, if c_alpha is nearly 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z15 is nearly 0
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "rhs")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z22 is nearly 0
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
        z41 = z24 + (z3 * z40 - k3 * (z2 * z39))
        z42 = u1 - (k1 * (z2 * z37) - z9 * z40)
        z43 = w1 * z41 - (g * mu2 - w3 * z42)
        z44 = z23 + (z5 * z40 + k2 * (z2 * z38))
        z45 = w2 * z42 + (g * mu3 + w1 * z44)
        s2 = s_beta * z34 - (c_beta * z35 - (r3 * z43 - z6 * z45))
        z46 = w2 * z32 - s2
        z47 = I_d * w2 + I_a * w1
        z48 = w2 * z41 - (g * z1 + w3 * z44)
        z49 = w3 * z47 - w1 * z32 - (r3 * z48 - r1 * z45) - z14 * z46
        s3 = c_beta * z34 + (s_beta * z35 - (z6 * z48 - r1 * z43))
        z50 = w2 * z47 - s3 - z18 * z46
        z51 = (z50 + z21 * z49) / z22
        z52 = z20 * z49 + z21 * z51
        dydt: list[float] = [
            # x' (I.2.4)
            s_gamma * z26 - c_gamma * z27,
            # y' (I.2.4)
            -(s_gamma * z27 + c_gamma * z26),
            # z' (I.2.4)
            -(mu2 * z23 + c_alpha * z25),
            # alpha' (I.2.4)
            z28,
            # beta' (I.2.4)
            z31,
            # gamma' (I.2.4)
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
    """All velocities q' from the state (I.2.4).

    Arguments: t (scalar), y (9,), p (9,).
    Returns qdot (6,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
        # the coframe is singular, if c_alpha is nearly 0
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
    """All accelerations q'' on the motion (I.2.15).

    Arguments: t (scalar), y (9,), p (9,).
    Returns qddot (6,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
        # the coframe is singular, if c_alpha is nearly 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z15 is nearly 0
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "accelerations")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z22 is nearly 0
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
        z41 = k1 * (z2 * z36) + z9 * z39
        z42 = w1 * z40 + w3 * z41
        z43 = I_c * w3
        z44 = I_b * w2 + I_d * w1
        z45 = z31 * z44
        z46 = z28 * z44
        z47 = z42 - (w1 * z24 - (g * mu2 - w3 * u1))
        z48 = k2 * (z2 * z33) - z5 * z39
        z49 = w2 * z41 - w1 * z48
        z50 = z49 - (w2 * u1 + (g * mu3 + w1 * z23))
        s2 = s_beta * z45 - (c_beta * z46 + (r3 * z47 - z6 * z50))
        z51 = w2 * z43 - s2
        z52 = I_d * w2 + I_a * w1
        z53 = w2 * z40 + w3 * z48
        z54 = z53 + (w3 * z23 + (g * z1 - w2 * z24))
        z55 = w3 * z52 - w1 * z43 + (r3 * z54 - r1 * z50) - z14 * z51
        s3 = c_beta * z45 + (s_beta * z46 + (z6 * z54 - r1 * z47))
        z56 = w2 * z52 - s3 - z18 * z51
        z57 = (z56 + z21 * z55) / z22
        z58 = z20 * z55 + z21 * z57
        z59 = z13 * z51 - z14 * z58 - z18 * z57
        z60 = z42 - (r3 * z59 + r1 * z57)
        z61 = z53 - (r3 * z58 - z6 * z57)
        z62 = z49 + (r1 * z58 + z6 * z59)
        z63 = z35 * u1 + s_beta * z61 - (z37 * z24 + c_beta * z62)
        z64 = z32 * z23 - c_alpha * z60 + (z33 * z25 + mu2 * z63)
        z65 = s_beta * z24 - c_beta * u1
        z66 = s_gamma * z29
        z67 = z35 * z24 - s_beta * z62 + (z37 * u1 - c_beta * z61)
        s4 = z27 * (w1 * z35 - s_beta * z59 + (w3 * z37 - c_beta * z57))
        z68 = z27 * z27 * (z28 * z32) + s4
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z26 * z30 + s_gamma * z64 + (z65 * z66 + c_gamma * z67)),
            # y'' (I.2.15)
            z65 * z30 - s_gamma * z67 - (z26 * z66 - c_gamma * z64),
            # z'' (I.2.15)
            z32 * z25 - c_alpha * z63 - (z33 * z23 + mu2 * z60),
            # alpha'' (I.2.15)
            w3 * z35 + s_beta * z57 - (w1 * z37 + c_beta * z59),
            # beta'' (I.2.15)
            z29 * z33 + mu2 * z68 - z58,
            # gamma'' (I.2.15)
            -z68,
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
    """The state y from coordinates and velocities (I.2.1).

    Arguments: t (scalar), q (6,), qdot (6,), p (9,).
    Returns y (9,).
    """
    x = float(q[0])  # centre of mass [cm]
    y_2 = float(q[1])  # y: centre of mass [cm]
    z = float(q[2])  # centre of mass, downwards [cm]
    alpha = float(q[3])  # roll about the long axis [rad]
    beta = float(q[4])  # pitch [rad]
    gamma = float(q[5])  # heading [rad]
    alpha_dot = float(qdot[3])  # alpha' [rad/s]
    beta_dot = float(qdot[4])  # beta' [rad/s]
    gamma_dot = float(qdot[5])  # gamma' [rad/s]
    try:
        # from the coordinates and velocities
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
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (6,), qdot (6,), p (9,).
    Returns r (3,).
    """
    alpha = float(q[3])  # roll about the long axis [rad]
    beta = float(q[4])  # pitch [rad]
    gamma = float(q[5])  # heading [rad]
    x_dot = float(qdot[0])  # x' [cm/s]
    y_dot = float(qdot[1])  # y' [cm/s]
    z_dot = float(qdot[2])  # z' [cm/s]
    alpha_dot = float(qdot[3])  # alpha' [rad/s]
    beta_dot = float(qdot[4])  # beta' [rad/s]
    gamma_dot = float(qdot[5])  # gamma' [rad/s]
    a = float(p[0])  # half axis 1 of the ellipsoid [cm]
    b = float(p[1])  # half axis 2 [cm]
    c = float(p[2])  # half axis 3 [cm]
    h = float(p[3])  # from the centre of the ellipsoid down to the centre of mass [cm]
    try:
        # from the parameters alone
        k1 = a * a
        k2 = b * b
        k3 = c * c
        # from the coordinates and velocities
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
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (9,), p (9,).
    Returns lambda_ (3,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
        # the coframe is singular, if c_alpha is nearly 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z15 is nearly 0
        if not abs(z15) > 1e-13 * z11:
            raise _refuse(abs(z15), 1e-13 * z11, 2, "reactions")
        z16 = I_c + (z7 + z10)
        z17 = r1 * r3
        z18 = z17 * z13
        z19 = z6 * r3 + z12 * z18
        z20 = 1.0 / z15
        z21 = z19 * z20
        z22 = z16 - z17 * z18 - z19 * z21
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z22 is nearly 0
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
        s4 = (z6 * z24 - r3 * z41) * z53 + (r1 * z24 - r3 * z37) * z52
        z54 = (r1 * z41 - z6 * z37) * z51 - s4
        z55 = mu2 * c_gamma
        z56 = s_beta * s_gamma - c_beta * z55
        z57 = c_beta * s_gamma + s_beta * z55
        z58 = c_alpha * c_gamma
        s5 = (z6 * z56 + r3 * z58) * z53 + (r1 * z56 - r3 * z57) * z52
        z59 = (r1 * z58 + z6 * z57) * z51 + s5
        s6 = (mu3 * z6 + mu2 * r3) * z53 + (mu3 * r1 + z1 * r3) * z52
        z60 = (mu2 * r1 - z1 * z6) * z51 + s6
        lambda_: list[float] = [
            # reaction of roll_x: Q_i gains lambda_1 a_1i (I.4.1) 44:5
            -(z24 * z36 - (z37 * z40 + z41 * z42) + z54),
            # reaction of roll_y: Q_i gains lambda_2 a_2i (I.4.1) 45:5
            z59 - (z56 * z36 - (z57 * z40 - z58 * z42)),
            # reaction of roll_z: Q_i gains lambda_3 a_3i (I.4.1) 46:5
            z60 - (mu3 * z36 + (z1 * z40 + mu2 * z42)),
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [cm^2/s^2].

    Arguments: t (scalar), y (9,), p (9,).
    Returns a scalar.
    """
    z = float(y[2])  # centre of mass, downwards [cm]
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (9,), p (9,).
    Returns rows (9, 9): d rhs_i / d y_j stands at [i][j].
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    beta = float(y[4])  # pitch [rad]
    gamma = float(y[5])  # heading [rad]
    w1 = float(y[6])  # [rad/s]
    w2 = float(y[7])  # [rad/s]
    w3 = float(y[8])  # [rad/s]
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
        # the coframe is singular, if c_alpha is nearly 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z8 is 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z15 is nearly 0
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
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z23 is nearly 0
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
        z39 = r1 * w2
        z40 = z6 * w1
        z41 = z39 + z40
        z42 = s_beta * u1 + c_beta * z41
        z43 = k2 * z2
        z44 = z5 * z31 + c_alpha * z43
        z45 = w2 * z33 - w3 * z44
        z46 = w2 * z35 - w1 * z44
        z47 = s_beta * z45 + c_beta * z46
        z48 = mu2 * z26 + c_alpha * z36 + (c_alpha * z42 - mu2 * z47)
        c_gamma = math.cos(gamma)
        z49 = s_beta * z46 - c_beta * z45
        z50 = k4 * (mu3 * (z1 * z28))
        z51 = z3 * z50 + z1 * z32
        z52 = mu3 * z34 - z9 * z50
        z53 = w1 * z51 - w3 * z52
        z54 = s_beta * z41 - c_beta * u1
        z55 = z5 * z50
        z56 = w2 * z51 - w3 * z55
        z57 = w2 * z52 - w1 * z55
        z58 = z54 - (s_beta * z56 + c_beta * z57)
        z59 = c_alpha * z53 + mu2 * z58
        z60 = z42 + (s_beta * z57 - c_beta * z56)
        z61 = c_alpha * z26 - mu2 * z42
        z62 = c_beta * z6
        z63 = mu2 * z62 - c_alpha * r3
        z64 = s_beta * z6
        z65 = s_beta * r3 + c_beta * r1
        z66 = mu2 * z65
        z67 = s_beta * r1 - c_beta * r3
        z68 = mu2 * z64 + c_alpha * r1
        z69 = s_beta * w1 - c_beta * w3
        z70 = 1.0 / c_alpha
        z71 = z69 * (z70 * z70)
        z72 = mu2 * z71
        z73 = c_beta * w1 + s_beta * w3
        z74 = z70 * z73
        z75 = s_beta * z70
        z76 = c_beta * z70
        z77 = g * r3
        z78 = c_alpha * z73
        z79 = z6 * w2
        z80 = r3 * w3
        z81 = z79 - z80
        z82 = z3 * z24 - z5 * z40 - z9 * z81
        z83 = z27 * z82
        z84 = z2 * z83
        z85 = k2 * z84
        z86 = z70 * z69
        z87 = c_beta * z17
        z88 = z87 + s_beta * z8
        z89 = c_beta * z88
        z90 = k3 * z84
        z91 = z86 * z89 - (mu3 * z90 - z24 * z32)
        z92 = s_beta * z88
        z93 = k1 * z84
        z94 = z86 * z92 - (z1 * z93 + z81 * z34)
        z95 = z86 * z88 - c_beta * z91 - s_beta * z94
        z96 = s_beta * z17
        z97 = z69 * z8 - z73 * (z17 - z89) - c_alpha * z94
        z98 = z69 * z17
        z99 = z98 + z73 * (z8 - z92) - c_alpha * z91
        z100 = z69 * (z96 - c_beta * z8) + c_beta * z97 - s_beta * z99
        z101 = mu2 * z73
        z102 = w2 + mu2 * z86
        z103 = c_beta * z102
        z104 = s_beta * z101 - c_alpha * z103
        z105 = s_beta * z102
        z106 = c_alpha * z105 + c_beta * z101
        z107 = z5 * z78 - z9 * z104 - z3 * z106
        z108 = z2 * z107
        z109 = z27 * z108
        z110 = I_c * w3
        z111 = I_d * w1
        z112 = I_b * w2 + z111
        z113 = z73 * z112
        z114 = z69 * z112
        z115 = k3 * z106
        z116 = z2 * z115 + z3 * z109
        z117 = k1 * z104
        z118 = z2 * z117 + z9 * z109
        z119 = g * mu2 - (w3 * u1 + w1 * z41 - (w1 * z116 + w3 * z118))
        z120 = k2 * z78
        z121 = z2 * z120 - z5 * z109
        z122 = g * mu3 + (w1 * z26 + w2 * u1 - (w2 * z118 - w1 * z121))
        s2 = s_beta * z113 - (c_beta * z114 + (r3 * z119 + z6 * z122))
        z123 = w2 * z110 - s2
        z124 = I_d * w2
        z125 = z124 + I_a * w1
        z126 = g * z1 - (w2 * z41 - w3 * z26 - (w2 * z116 + w3 * z121))
        z127 = w3 * z125 - w1 * z110 + (r3 * z126 + r1 * z122) - z14 * z123
        z128 = 1.0 / z23
        s3 = c_beta * z113 + (s_beta * z114 + (z6 * z126 - r1 * z119))
        z129 = w2 * z125 - s3 - z18 * z123
        z130 = z128 * (z129 + z22 * z127)
        z131 = z21 * z127 + z22 * z130
        z132 = z13 * z123 - z14 * z131 - z18 * z130
        z133 = z6 * z132
        z134 = r1 * z131
        z135 = w3 * z81 - (w1 * z24 + (2.0 * z133 - (z122 - z134)))
        s4 = z77 + (z78 * z85 - z73 * z95 + z86 * z100)
        z136 = s4 - k2 * (z40 * z109 - z2 * z135)
        z137 = z27 * z27 * z108
        z138 = r3 * z132
        z139 = r1 * z130
        z140 = w2 * z81 + (w1 * z40 - (2.0 * z138 - (z119 - z139)))
        s5 = z115 * z24 + z120 * z40 - z117 * z81 + z107 * z83
        z141 = s5 - z3 * z140 + z5 * z135
        z142 = w2 * z24
        z143 = w3 * z40
        z144 = r3 * z130
        z145 = z6 * z131
        z146 = z142 + (z143 + (z144 + z145))
        z147 = z82 * z137 + 0.5 * (z28 * (z141 - z9 * z146))
        z148 = mu2 * z85 + z40 * z43
        z149 = mu2 * z100
        z150 = g * z6
        s6 = z150 - z106 * z90 + k3 * (z24 * z109 - z2 * z140)
        z151 = s6 - 2.0 * (z3 * z147)
        s7 = z104 * z93 + k1 * (z81 * z109 + z2 * z146)
        z152 = s7 + 2.0 * (z9 * z147)
        s8 = z73 * z148 + z105 * z91 - z103 * z94 - z71 * z149
        z153 = s8 + c_beta * z151 - s_beta * z152
        z154 = c_alpha * (z136 - 2.0 * (z5 * z147)) - mu2 * z153
        z155 = r1 * w1
        z156 = z80 + z155
        z157 = z9 * z39 - (z3 * z37 - z5 * z156)
        z158 = z27 * z157
        z159 = z2 * z158
        z160 = k2 * z159
        z161 = s_beta * z12 - c_beta * z19
        z162 = c_beta * z161
        z163 = k3 * z159
        z164 = z86 * z162 + (mu3 * z163 + z37 * z32)
        z165 = s_beta * z161
        z166 = k1 * z159
        z167 = z86 * z165 + (z1 * z166 - z39 * z34)
        z168 = z86 * z161 - c_beta * z164 - s_beta * z167
        z169 = z69 * z12 + z73 * (z19 + z162) - c_alpha * z167
        z170 = z69 * z19 - z73 * (z12 - z165) + c_alpha * z164
        s9 = z69 * (c_beta * z12 + s_beta * z19) - c_beta * z169
        z171 = s9 - s_beta * z170
        z172 = w3 * z39
        z173 = r1 * z132
        z174 = z172 - (z142 - (z144 - z173))
        z175 = r3 * z131
        z176 = z6 * z130
        z177 = w2 * z39 + (w1 * z156 - (2.0 * z175 - (z126 + z176)))
        s10 = z39 * z117 - (z37 * z115 + z120 * z156) + z107 * z158
        z178 = s10 + z3 * z177 - z5 * z174
        z179 = w2 * z37 + (w3 * z156 + (z133 - (z122 - 2.0 * z134)))
        z180 = z157 * z137 + 0.5 * (z28 * (z178 + z9 * z179))
        s11 = z78 * z160 + z73 * z168 + z86 * z171
        z181 = s11 + k2 * (z156 * z109 - z2 * z174) - 2.0 * (z5 * z180)
        z182 = mu2 * z160 - z43 * z156
        z183 = mu2 * z171
        z184 = g * r1
        s12 = z184 + z106 * z163 + k3 * (z37 * z109 - z2 * z177)
        z185 = s12 + 2.0 * (z3 * z180)
        s13 = z77 + z104 * z166 - k1 * (z39 * z109 + z2 * z179)
        z186 = s13 + 2.0 * (z9 * z180)
        s14 = z73 * z182 - z105 * z164 + z103 * z167 - z71 * z183
        z187 = s14 - c_beta * z185 - s_beta * z186
        z188 = c_alpha * z181 - mu2 * z187 + z14 * z154
        z189 = z79 - z155
        z190 = z3 * z189 - z5 * z38 - z9 * z25
        z191 = z27 * z190
        z192 = z2 * z191
        z193 = k2 * z192
        z194 = z96 + c_beta * z16
        z195 = c_beta * z194
        z196 = k3 * z192
        z197 = z86 * z195 + (mu3 * z196 - z189 * z32)
        z198 = s_beta * z194
        z199 = k1 * z192
        z200 = z86 * z198 + (z1 * z199 + z25 * z34)
        z201 = z86 * z194 - c_beta * z197 - s_beta * z200
        z202 = z98 - z73 * (z16 - z195) - c_alpha * z200
        z203 = z69 * z16 + z73 * (z17 - z198) - c_alpha * z197
        z204 = z69 * (z87 - s_beta * z16) - c_beta * z202 + s_beta * z203
        z205 = w3 * z25 - (w1 * z189 - (2.0 * z176 + (z126 - z175)))
        s15 = z184 - (z78 * z193 + z73 * z201 + z86 * z204)
        z206 = s15 + k2 * (z38 * z109 - z2 * z205)
        z207 = z172 + (z143 - (z145 - z173))
        s16 = z115 * z189 + z120 * z38 - z117 * z25 + z107 * z191
        z208 = s16 - z3 * z207 + z5 * z205
        z209 = w2 * z189 + (w3 * z38 - (z138 - (z119 - 2.0 * z139)))
        z210 = z190 * z137 + 0.5 * (z28 * (z208 - z9 * z209))
        z211 = mu2 * z193 + z38 * z43
        z212 = mu2 * z204
        s17 = z106 * z196 - k3 * (z189 * z109 - z2 * z207)
        z213 = s17 + 2.0 * (z3 * z210)
        s18 = z150 - z104 * z199 - k1 * (z25 * z109 + z2 * z209)
        z214 = s18 - 2.0 * (z9 * z210)
        s19 = z73 * z211 - z105 * z197 + z103 * z200 - z71 * z212
        z215 = s19 - c_beta * z213 + s_beta * z214
        s20 = c_alpha * (z206 + 2.0 * (z5 * z210)) + mu2 * z215
        z216 = z128 * (s20 - z18 * z154 - z22 * z188)
        z217 = z21 * z188 - z22 * z216
        z218 = z69 * z102
        z219 = z218 * z17
        z220 = z73 * z105 + z86 * z104
        z221 = z73 * z103 + z86 * z106
        z222 = s_beta * z220 + c_beta * z221 - z86 * z101
        z223 = z6 * z121
        z224 = I_d * w3 - z6 * z26
        z225 = r3 * z41
        z226 = r3 * z116
        z227 = z223 - (z224 + z225 - z226)
        s21 = z219 - (z113 - z222 * z8) + z220 * z88 + z101 * z94
        z228 = s21 - z102 * z99 + z69 * z227
        z229 = z6 * z81 - (r1 * z40 - (I_c * w2 - r3 * u1 + r3 * z118))
        z230 = c_beta * z112
        z231 = z230 + s_beta * z227 - c_beta * z229 + z70 * z149
        s22 = s_beta * z112 - c_alpha * z148 + mu2 * z95 - c_beta * z227
        z232 = s22 - s_beta * z229
        z233 = z222 * z17
        s23 = z233 + (z114 - z218 * z8) + z221 * z88 + z101 * z91
        z234 = s23 + z102 * z97 + z73 * z227
        s24 = z228 + z73 * z229 + w1 * z231 - w3 * z232 - c_alpha * z152
        s25 = z234 - z69 * z229 - w3 * z231 - w1 * z232 + c_alpha * z151
        z235 = c_beta * s24 - s_beta * s25
        z236 = z6 * z37 - (r3 * z156 + (w3 * k6 + r1 * z26 + r1 * z121))
        s26 = z222 * z12 - z218 * z19 + z220 * z161 + z101 * z167
        z237 = s26 + z102 * z170 - z69 * z236
        s27 = r1 * z156 - (z125 - I_c * w1 + r3 * z26 + r3 * z121)
        z238 = z6 * z39 - s27
        z239 = s_beta * z236 + c_beta * z238 + z70 * z183
        z240 = c_alpha * z182 + mu2 * z168 + c_beta * z236 - s_beta * z238
        s28 = z218 * z12 + z222 * z19 - z221 * z161 - z101 * z164
        z241 = s28 - z102 * z169 + z73 * z236
        s29 = z237 + z73 * z238 - w1 * z239 - w3 * z240 + c_alpha * z186
        s30 = z241 + z69 * z238 - w3 * z239 + w1 * z240 - c_alpha * z185
        z242 = c_beta * s29 + s_beta * s30
        z243 = z242 - z14 * z235
        s31 = r3 * z38 + (z111 - I_a * w2 + r1 * z41 - r1 * z116)
        z244 = z6 * z189 - s31
        s32 = z114 - z233 - z218 * z16 - z220 * z194 - z101 * z200
        z245 = s32 + z102 * z203 - z69 * z244
        z246 = r1 * z118
        z247 = z223 + (z225 - z246)
        z248 = s_beta * (z112 - z244) - c_beta * z247 + z70 * z212
        s33 = z230 + c_alpha * z211 + mu2 * z201 - c_beta * z244
        z249 = s33 + s_beta * z247
        s34 = z113 + z219 - z222 * z16 - z221 * z194 - z101 * z197
        z250 = s34 - z102 * z202 - z73 * z244
        s35 = z245 + z73 * z247 + w1 * z248 + w3 * z249 + c_alpha * z214
        s36 = z250 - z69 * z247 - w3 * z248 + w1 * z249 - c_alpha * z213
        z251 = c_beta * s35 - s_beta * s36
        z252 = z128 * (z251 + z18 * z235 - z22 * z243)
        z253 = z21 * z243 - z22 * z252
        z254 = s_beta * z231 - c_beta * z232
        z255 = s_beta * z239 + c_beta * z240 + z14 * z254
        s37 = s_beta * z248 + c_beta * z249 + z18 * z254 + z22 * z255
        z256 = z128 * s37
        z257 = z21 * z255 + z22 * z256
        z258 = r3 * z81 - (r1 * z24 + (w3 * k5 - z6 * u1 + z6 * z118 - z100))
        z259 = z226 + (z224 - z246) - z171 - z14 * z258
        s38 = z124 + (z125 - I_b * w1) + z6 * z41 - z6 * z116 - z204
        z260 = r3 * z25 - (r1 * z189 + s38)
        z261 = z128 * (z260 + z18 * z258 - z22 * z259)
        z262 = z21 * z259 - z22 * z261
        z263 = c_beta * z231 + s_beta * z232
        z264 = c_beta * z239 - s_beta * z240 + z14 * z263
        s39 = c_beta * z248 - s_beta * z249 + z18 * z263 + z22 * z264
        z265 = z128 * s39
        z266 = z21 * z264 + z22 * z265
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            c_gamma * z49 - s_gamma * z48,
            # (I.2.15)
            s_gamma * z59 - c_gamma * z60,
            # (I.2.15)
            s_gamma * z54 + c_gamma * z61,
            # (I.2.15)
            -(s_gamma * z63 + c_gamma * z64),
            # (I.2.15)
            -(s_gamma * z66 + c_gamma * z67),
            # (I.2.15)
            c_gamma * z62 - s_gamma * z68,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_gamma * z49 + c_gamma * z48,
            # (I.2.15)
            -(s_gamma * z60 + c_gamma * z59),
            # (I.2.15)
            s_gamma * z61 - c_gamma * z54,
            # (I.2.15)
            c_gamma * z63 - s_gamma * z64,
            # (I.2.15)
            c_gamma * z66 - s_gamma * z67,
            # (I.2.15)
            s_gamma * z62 + c_gamma * z68,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            mu2 * z36 + c_alpha * z47 - z61,
            # (I.2.15)
            c_alpha * z58 - mu2 * z53,
            0.0,
            # (I.2.15)
            -(mu2 * r3 + c_alpha * z62),
            # (I.2.15)
            -c_alpha * z65,
            # (I.2.15)
            mu2 * r1 - c_alpha * z64,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z69,
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
            z69 + mu2 * z72,
            # (I.2.15)
            mu2 * z74,
            0.0,
            # (I.2.15)
            mu2 * z75,
            # (I.2.15)
            1.0,
            # (I.2.15)
            -mu2 * z76,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z72,
            # (I.2.15)
            -z74,
            0.0,
            # (I.2.15)
            -z75,
            0.0,
            # (I.2.15)
            z76,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z18 * z216 - (z13 * z154 + z14 * z217),
            # (I.2.15)
            -(z13 * z235 - z14 * z253 + z18 * z252),
            0.0,
            # (I.2.15)
            -(z13 * z254 + z14 * z257 + z18 * z256),
            # (I.2.15)
            -(z13 * z258 - z14 * z262 + z18 * z261),
            # (I.2.15)
            z13 * z263 + z14 * z266 + z18 * z265,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z217,
            # (I.2.15)
            -z253,
            0.0,
            # (I.2.15)
            z257,
            # (I.2.15)
            -z262,
            # (I.2.15)
            -z266,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z216,
            # (I.2.15)
            -z252,
            0.0,
            # (I.2.15)
            -z256,
            # (I.2.15)
            -z261,
            # (I.2.15)
            z265,
        ]
        _finish("jacobian", J)
        return [J[k7 : k7 + 9] for k7 in range(0, 81, 9)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (9,), p (9,).
    Returns out (1,).
    """
    alpha = float(y[3])  # roll about the long axis [rad]
    w3 = float(y[8])  # [rad/s]
    try:
        # from the state
        c_alpha = math.cos(alpha)
        # the coframe is singular, if c_alpha is nearly 0
        if not abs(c_alpha) > 1e-12 * 4.0:
            raise _refuse(abs(c_alpha), 1e-12 * 4.0, 1, "outputs")
        out: list[float] = [
            # spin 53:9
            w3,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
