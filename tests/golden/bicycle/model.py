"""bicycle, emitted by nhc 0.1.0 (nhc:2faf9f6efef38271).

Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x
    ahead, y right, z down.
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with roll', steer', thF': the dependent velocities of
    the spec (x', y', z', yaw', pitch', thF') are singular somewhere

State y:
y[0] = x [m]: centre of the rear wheel
y[1] = y [m]: centre of the rear wheel
y[2] = z [m]: centre of the rear wheel, downwards
y[3] = yaw [rad]: first turn of the rear frame, about z
y[4] = roll [rad]: second turn, about x
y[5] = pitch [rad]: third turn, about y
y[6] = steer [rad]: front frame against rear frame
y[7] = thR [rad]: rear wheel against rear frame
y[8] = thF [rad]: front wheel against front frame
y[9] = roll' [rad/s]
y[10] = steer' [rad/s]
y[11] = thF' [rad/s]

Parameters p:
p[0]: w = 1.02 [m]: wheelbase
p[1]: c = 0.08 [m]: trail
p[2]: lam = 0.3141592653589793 [rad]: tilt of the steering axis, 18 degrees
p[3]: g = 9.81 [m/s^2]: acceleration of gravity
p[4]: r_R = 0.3 [m]: radius of the rear wheel
p[5]: m_R = 2.0 [kg]: mass of the rear wheel
p[6]: R_xx = 0.0603 [kg*m^2]: rear wheel, across the axle
p[7]: R_yy = 0.12 [kg*m^2]: rear wheel, about the axle
p[8]: x_B = 0.3 [m]: rear frame and rider, ahead of the rear contact
p[9]: z_B = -0.9 [m]
p[10]: m_B = 85.0 [kg]
p[11]: B_xx = 9.2 [kg*m^2]
p[12]: B_xz = 2.4 [kg*m^2]
p[13]: B_yy = 11.0 [kg*m^2]
p[14]: B_zz = 2.8 [kg*m^2]
p[15]: x_H = 0.9 [m]: front frame, ahead of the rear contact
p[16]: z_H = -0.7 [m]
p[17]: m_H = 4.0 [kg]
p[18]: H_xx = 0.05892 [kg*m^2]
p[19]: H_xz = -0.00756 [kg*m^2]
p[20]: H_yy = 0.06 [kg*m^2]
p[21]: H_zz = 0.00708 [kg*m^2]
p[22]: r_F = 0.35 [m]: radius of the front wheel
p[23]: m_F = 3.0 [kg]: mass of the front wheel
p[24]: F_xx = 0.1405 [kg*m^2]: front wheel, across the axle
p[25]: F_yy = 0.28 [kg*m^2]: front wheel, about the axle

Constraints, with the units of their reactions:
0: rear_x [N]
1: rear_y [N]
2: rear_z [N]
3: front_x [N]
4: front_y [N]
5: front_z [N]

Outputs:
out[0] = speed [m/s]
out[1] = rear_height [m]
out[2] = front_height [m]

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 450 +-, 699 *, 6 /, 17 calls
velocities: 55 +-, 99 *, 3 /, 17 calls
accelerations: 153 +-, 264 *, 3 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 183 *, 2 /, 12 calls
reactions: 367 +-, 549 *, 3 /, 12 calls
energy: 125 +-, 198 *, 3 /, 15 calls
jacobian: 3683 +-, 5097 *, 7 /, 17 calls
outputs: 56 +-, 101 *, 3 /, 15 calls

A singular point raises SingularModelError.
Units are in brackets, and nothing is converted.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = (
    "x",
    "y",
    "z",
    "yaw",
    "roll",
    "pitch",
    "steer",
    "thR",
    "thF",
)
STATE: tuple[str, ...] = (
    "x",
    "y",
    "z",
    "yaw",
    "roll",
    "pitch",
    "steer",
    "thR",
    "thF",
    "roll'",
    "steer'",
    "thF'",
)
PARAMETERS: tuple[str, ...] = (
    "w",
    "c",
    "lam",
    "g",
    "r_R",
    "m_R",
    "R_xx",
    "R_yy",
    "x_B",
    "z_B",
    "m_B",
    "B_xx",
    "B_xz",
    "B_yy",
    "B_zz",
    "x_H",
    "z_H",
    "m_H",
    "H_xx",
    "H_xz",
    "H_yy",
    "H_zz",
    "r_F",
    "m_F",
    "F_xx",
    "F_yy",
)
CONSTRAINTS: tuple[str, ...] = (
    "rear_x",
    "rear_y",
    "rear_z",
    "front_x",
    "front_y",
    "front_z",
)
OUTPUTS: tuple[str, ...] = ("speed", "rear_height", "front_height")
DEFAULTS: tuple[float, ...] = (
    1.02,
    0.08,
    0.3141592653589793,
    9.81,
    0.3,
    2.0,
    0.0603,
    0.12,
    0.3,
    -0.9,
    85.0,
    9.2,
    2.4,
    11.0,
    2.8,
    0.9,
    -0.7,
    4.0,
    0.05892,
    -0.00756,
    0.06,
    0.00708,
    0.35,
    3.0,
    0.1405,
    0.28,
)

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

    Arguments: t (scalar), y (12,), p (26,).
    Returns dydt (12,).
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    g = float(p[3])  # acceleration of gravity [m/s^2]
    r_R = float(p[4])  # radius of the rear wheel [m]
    m_R = float(p[5])  # mass of the rear wheel [kg]
    R_xx = float(p[6])  # rear wheel, across the axle [kg*m^2]
    R_yy = float(p[7])  # rear wheel, about the axle [kg*m^2]
    x_B = float(p[8])  # rear frame and rider, ahead of the rear contact [m]
    z_B = float(p[9])  # [m]
    m_B = float(p[10])  # [kg]
    B_xx = float(p[11])  # [kg*m^2]
    B_xz = float(p[12])  # [kg*m^2]
    B_yy = float(p[13])  # [kg*m^2]
    B_zz = float(p[14])  # [kg*m^2]
    x_H = float(p[15])  # front frame, ahead of the rear contact [m]
    z_H = float(p[16])  # [m]
    m_H = float(p[17])  # [kg]
    H_xx = float(p[18])  # [kg*m^2]
    H_xz = float(p[19])  # [kg*m^2]
    H_yy = float(p[20])  # [kg*m^2]
    H_zz = float(p[21])  # [kg*m^2]
    r_F = float(p[22])  # radius of the front wheel [m]
    m_F = float(p[23])  # mass of the front wheel [kg]
    F_xx = float(p[24])  # front wheel, across the axle [kg*m^2]
    F_yy = float(p[25])  # front wheel, about the axle [kg*m^2]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = r_R + z_B
        k2 = w + c
        k3 = r_F * s_lam - c * c_lam
        k4 = H_zz + F_xx
        k5 = H_xx + F_xx
        k6 = R_xx + B_xx
        k7 = R_xx + B_zz
        k8 = x_H - k2
        k9 = r_R * s_lam - c_lam * k2
        k10 = z_H * s_lam - c_lam * k8
        k11 = r_R * c_lam + s_lam * k2
        k12 = c_lam * k1 + x_B * s_lam
        k13 = s_lam * k1 - x_B * c_lam
        k14 = abs(r_R)
        k15 = abs(r_F)
        k16 = abs(w)
        k17 = abs(c)
        k18 = 9.0 * k15
        k19 = 6.0 * k17 + (2.0 * k16 + (5.0 * k14 + k18))
        k20 = 6.0 * k16
        k21 = m_R + m_B
        k22 = m_B * k12
        k23 = m_B * k13
        k24 = B_xz * c_lam
        k25 = s_lam * k7 - k24
        k26 = B_xz * s_lam
        k27 = c_lam * k6 - k26
        k28 = k12 * k22
        k29 = s_lam * k25 + c_lam * k27 + k28
        k30 = c_lam * k25 - s_lam * k27 - k13 * k22
        k31 = k13 * k23
        k32 = k28 + (B_yy + k31)
        s2 = c_lam * (k26 + c_lam * k7) + s_lam * (k24 + s_lam * k6)
        k33 = k31 + s2
        k34 = m_H + m_F
        k35 = m_F * k3
        k36 = H_xz * c_lam
        k37 = s_lam * k4 - k36
        k38 = H_xz * s_lam
        k39 = c_lam * k5 - k38
        k40 = m_H * k10
        k41 = k35 - k40
        k42 = g * m_F
        k43 = g * m_H
        k44 = g * m_B
        k45 = g * k21
        k46 = k13 * k44
        k47 = k12 * k44
        k48 = g * k34
        k49 = k11 + (z_H * c_lam + s_lam * k8)
        k50 = r_F * c_lam + c * s_lam - k11
        k51 = 14.0 * k15 + 13.0 * k17
        k52 = k18 + 10.0 * k17
        k53 = m_F * k50
        k54 = m_H * k49
        k55 = k53 - k54
        k56 = k50 * k53 + k49 * k54
        k57 = s_lam * k37 + c_lam * k39 + k56
        k58 = c_lam * k37 - s_lam * k39 - k3 * k53 - k10 * k54
        k59 = k3 * k35 + k10 * k40
        k60 = k59 + (H_yy + k56)
        s3 = c_lam * (k38 + c_lam * k4) + s_lam * (k36 + s_lam * k5)
        k61 = s3 + k59
        k62 = k43 * k49 - k42 * k50
        k63 = k3 * k42 - k10 * k43
        # from the state
        c_roll = math.cos(roll)
        z1 = 1.0 / abs(c_roll)
        z2 = pitch + lam
        s1 = math.sin(z2)
        z3 = c_roll * s1
        z4 = r_R * z3
        z5 = z1 * z4
        z6 = k9 - z5
        c_steer = math.cos(steer)
        c1 = math.cos(z2)
        z7 = c_roll * c1
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z8 = e2z * s_steer - c_steer * z3
        z9 = 1.0 / math.sqrt(z7 * z7 + z8 * z8)
        z10 = r_F * z8
        z11 = z9 * z10
        z12 = k3 + z11
        z13 = z6 - c_steer * z12
        z14 = r_R * z7
        z15 = z1 * z14
        z16 = c_steer * z15
        z17 = c_steer * k9
        z18 = z17 - z12
        z19 = r_F * z7
        z20 = z9 * z19
        z21 = z20 - k50
        z22 = c_steer * z21
        z23 = c1 * z18 - s1 * z22
        z24 = z15 - z21
        z25 = s_steer * z24
        z26 = c_roll * z23 - e2z * z25
        z27 = s_steer * z15
        z28 = s_steer * k9
        z29 = s_steer * z21
        z30 = c1 * z28 - s1 * z29
        z31 = c_steer * z24
        z32 = c_roll * z30 + e2z * z31
        z33 = z16 * z26 + z27 * z32
        z34 = z31 * z26 + z32 * z25
        z35 = z13 * z33 + z5 * z34
        z36 = k20 + k14 * (9.0 + abs(z1))
        s4 = (z36 + k51) * (z36 + k52)
        # the coframe is singular, if -z35 is nearly 0
        if not abs(-z35) > 1e-12 * (k19 * s4):
            raise _refuse(abs(-z35), 1e-12 * (k19 * s4), 1, "rhs")
        z37 = r_R * z1
        z38 = c_roll * z37
        z39 = 1.0 / z35
        z40 = k9 * s1 - z38
        z41 = s1 * z12 - (c_steer * z40 + c1 * z22)
        z42 = s_steer * c1
        z43 = s_steer * z40 + z42 * z21
        z44 = z16 * z41 - z27 * z43
        z45 = z39 * (z13 * z44 + z5 * (z31 * z41 - z25 * z43))
        z46 = c_roll * z45
        z47 = s1 + c1 * z46
        z48 = c1 - s1 * z46
        z49 = s_steer * z12
        z50 = s1 * z49
        z51 = c_roll * z50 - e2z * z13
        s5 = z42 * (z12 * z33) - z51 * z44 + z5 * (z26 * z43 + z32 * z41)
        z52 = s5 * z39 - e2z * z45
        z53 = c_steer * z52 + s_steer * z48
        z54 = z15 * z52
        z55 = z38 - k9 * z47
        z56 = c_steer * z54 + s_steer * z55
        z57 = z6 * z52
        z58 = k60 * z53 + (k55 * z56 - k41 * z57)
        z59 = F_yy * z53
        z60 = k33 * z47 - (k23 * z38 + k30 * z48)
        z61 = c_steer * z55 - s_steer * z54
        z62 = s_steer * z52 - c_steer * z48
        z63 = k61 * z47 + (k41 * z61 + k58 * z62)
        z64 = z60 + z63
        z65 = k58 * z47 - (k55 * z61 - k57 * z62)
        z66 = k34 * z57 - k41 * z53
        z67 = k41 * z47 + (k34 * z61 - k55 * z62)
        z68 = k34 * z56 + k55 * z53
        z69 = z5 * z52
        z70 = k32 * z52 - (k22 * z54 + k23 * z69)
        z71 = k21 * z69 - k23 * z52
        z72 = k21 * z54 - k22 * z52
        z73 = k30 * z47 + (k22 * z38 - k29 * z48)
        s6 = z69 * z71 + (z54 * z72 - (z48 * z73 - R_yy * (z52 * z52)))
        z74 = z56 * z68 + (z52 * z70 + s6)
        s7 = z47 * z64 + (z62 * z65 + (z57 * z66 + (z61 * z67 + z74)))
        z75 = z53 * (z58 + z59) + s7
        z76 = z38 * (k23 * z47 - (k21 * z38 - k22 * z48)) - z75
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if -z76 is 0
        if not abs(-z76) > 0.0:
            raise _refuse(abs(-z76), 0.0, 2, "rhs")
        z77 = z16 * z12
        z78 = z12 * z31
        z79 = (z13 * z77 + z5 * z78) * z39
        z80 = c_roll * z79
        z81 = c1 * z80
        z82 = 1.0 + z81
        z83 = z12 * z32
        z84 = (z51 * z77 - z5 * z83) * z39 + e2z * z79
        z85 = (z51 * z78 + z13 * z83) * z39 - z84
        z86 = z15 * z85
        z87 = z17 * z81 + s_steer * z86
        z88 = s1 * z80
        z89 = s_steer * z84 - c_steer * z88
        z90 = k61 * z82 - (k41 * z87 + k58 * z89)
        z91 = k58 * z82 + (k55 * z87 - k57 * z89)
        z92 = k41 * z82 - (k34 * z87 - k55 * z89)
        z93 = k30 * z88 + k33 * z81
        z94 = z5 * z85
        z95 = k32 * z84 + (k22 * z86 + k23 * z94)
        z96 = k29 * z88 + k30 * z81
        z97 = k21 * z86 + k22 * z84
        z98 = k21 * z94 + k23 * z84
        s8 = z88 * z96 + (z86 * z97 + (z94 * z98 + R_yy * (z85 * z85)))
        z99 = z81 * z93 + (z84 * z95 + s8)
        z100 = z82 * z90 - (z89 * z91 + (z87 * z92 - z99))
        s9 = z88 * z73 + (z86 * z72 + (z94 * z71 + R_yy * (z85 * z52)))
        z101 = z81 * z60 - (z84 * z70 - s9)
        z102 = z82 * z63 - (z89 * z65 + (z87 * z67 - z101))
        z103 = 1.0 / z76
        z104 = z102 * z103
        z105 = z100 + z102 * z104
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z105 is nearly 0
        if not abs(z105) > 1e-13 * z100:
            raise _refuse(abs(z105), 1e-13 * z100, 2, "rhs")
        z106 = z20 * z13
        z107 = z20 * z25
        z108 = z39 * (z27 * z106 + z5 * z107)
        z109 = c_roll * z108
        z110 = c1 * z109
        z111 = k9 * z110
        z112 = e2z * z108
        z113 = (z51 * z107 - z26 * z106 + z11 * z34) * z39 - z112
        z114 = z15 * z113
        z115 = c_steer * z111 + s_steer * z114
        z116 = s1 * z109
        z117 = s_steer * z112 - c_steer * z116
        z118 = c_steer * z112 + s_steer * z116
        z119 = c_steer * z114 - s_steer * z111
        z120 = z5 * z113
        z121 = z120 + k9 * z112
        s10 = z114 * (k21 * z114 + k22 * z112)
        s11 = s10 + z120 * (k21 * z120 + k23 * z112)
        z122 = z116 * (k29 * z116 + k30 * z110) + s11
        s12 = z112 * (k32 * z112 + (k22 * z114 + k23 * z120)) + z122
        z123 = z110 * (k30 * z116 + k33 * z110) + s12
        s13 = z115 * (k41 * z110 - (k34 * z115 - k55 * z117))
        z124 = s13 - (z119 * (k34 * z119 - k55 * z118) + z123)
        s14 = z117 * (k58 * z110 + (k55 * z115 - k57 * z117))
        z125 = s14 - (z121 * (k34 * z121 - k41 * z118) - z124)
        s15 = z118 * (k60 * z118 - (k55 * z119 + k41 * z121)) - z125
        z126 = z110 * (k61 * z110 - (k41 * z115 + k58 * z117)) + s15
        z127 = 1.0 + z118
        z128 = z126 + R_yy * (z113 * z113) + F_yy * (z127 * z127)
        z129 = R_yy * z113
        s16 = z114 * z72 + (z120 * z71 + (z129 * z52 - z127 * z59))
        z130 = z112 * z70 - (z116 * z73 + s16)
        s17 = z117 * z65 + (z121 * z66 + (z115 * z67 - (z119 * z68 - z130)))
        z131 = z110 * z64 - (z118 * z58 + s17)
        z132 = z131 * z103
        s18 = z114 * z97 + (z120 * z98 + (z102 * z132 + z85 * z129))
        z133 = z112 * z95 + (z116 * z96 + s18)
        z134 = z110 * (z93 + z90) - (z117 * z91 + (z115 * z92 - z133))
        z135 = 1.0 / z105
        z136 = z134 * z135
        z137 = z128 + z131 * z132 - z134 * z136
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z137 is nearly 0
        if not abs(z137) > 1e-13 * z128:
            raise _refuse(abs(z137), 1e-13 * z128, 2, "rhs")
        c_yaw = math.cos(yaw)
        z138 = roll_dot * c1
        z139 = s_steer * z138
        z140 = thF_dot - z139
        z141 = k3 * z139 - z11 * z140
        z142 = roll_dot * s1
        v2_x = roll_dot * z38
        z143 = k9 * z142 - v2_x
        z144 = z20 * z140 + (z139 * k50 - s_steer * z143)
        z145 = steer_dot + z142
        z146 = c_steer * z138
        z147 = z145 * z12 - (c_steer * z143 + z146 * z21)
        z148 = z25 * z144 + z31 * z147
        z149 = z26 * z144 - z32 * z147
        z150 = (z141 * z34 - (z51 * z148 - z13 * z149)) * z39
        z151 = z27 * z144 + z16 * z147
        z152 = (z141 * z33 - z51 * z151 - z5 * z149) * z39
        z153 = z39 * (z13 * z151 + z5 * z148)
        z154 = z152 - e2z * z153
        z155 = z150 - z154
        z156 = z5 * z155
        z157 = z15 * z155
        z158 = s1 * z156 + c1 * z157
        s_yaw = math.sin(yaw)
        z159 = c_roll * v2_x
        z160 = c1 * z152
        z161 = roll_dot * z160
        z162 = c_roll * z153
        z163 = s1 * z152
        z164 = roll_dot * e2z
        z165 = steer_dot * s_steer
        z166 = z164 * c1 - c_roll * z163
        z167 = roll_dot * c_roll
        z168 = steer_dot * c_steer
        z169 = z164 * s1 + c_roll * z160
        z170 = s_steer * z167 + e2z * z168 + (z165 * z3 + c_steer * z169)
        z171 = (z7 * z166 - z8 * z170) * (z9 * (z9 * z9))
        z172 = r_F * z9
        z173 = z19 * z171 - z172 * z166
        z174 = z10 * z171 + z172 * z170
        s19 = c1 * (z165 * k9 + z174) - (z22 * z160 + z18 * z163)
        z175 = s1 * (z165 * z21 - c_steer * z173) - s19
        z176 = z1 * (c_roll * z164) * (z1 * z1)
        z177 = z14 * z176 - z37 * z166
        z178 = z177 - z173
        z179 = z168 * z24 + s_steer * z178
        z180 = roll_dot * z163
        z181 = k9 * z161
        s20 = z165 * z143 + (z145 * z174 + (c_steer * z181 - z152 * z179))
        z182 = z21 * (z165 * z138 - c_steer * z180) - (z146 * z173 - s20)
        s21 = c_roll * z175 - (z164 * z23 + (z167 * z25 + e2z * z179))
        s22 = z150 * (z168 * z15 + s_steer * z177) - (z12 * z161 - z182)
        z183 = z153 * s21 - s22
        s23 = z29 * z160 + (k9 * (z168 * c1) + z28 * z163)
        z184 = s1 * (z168 * z21 + s_steer * z173) - s23
        z185 = z165 * z24 - c_steer * z178
        z186 = z168 * z138 + s_steer * z180
        s24 = z140 * z173 - (z168 * z143 - (s_steer * z181 - z152 * z185))
        z187 = z150 * (z165 * z15 - c_steer * z177) - (z21 * z186 - s24)
        s25 = c_roll * z184 + (z164 * z30 - (z167 * z31 - e2z * z185))
        z188 = z153 * s25 + z187
        z189 = z16 * z183 - z27 * z188
        z190 = z31 * z183 - z25 * z188
        z191 = z39 * (z13 * z189 + z5 * z190)
        z192 = z164 * z153 + c_roll * z191
        z193 = z161 - (z162 * z163 - c1 * z192)
        z194 = z142 + c1 * z162
        z195 = z138 - s1 * z162
        z196 = z157 * z194 - z156 * z195
        z197 = z180 + (z162 * z160 + s1 * z192)
        z198 = k22 * z154
        z199 = k23 * z154
        s26 = k22 * z197 + (z194 * z198 + (e2z * k45 - z195 * z199))
        z200 = k23 * z193 - (k21 * z196 + s26)
        z201 = z4 * z176 - z37 * z169
        z202 = z201 - (z165 * z12 - c_steer * z174)
        s27 = c_roll * (z49 * z160 - s1 * (z168 * z12 + s_steer * z174))
        z203 = s27 + (z164 * z50 + (z167 * z13 - e2z * z202))
        s28 = z12 * z186 - (z150 * z201 + (z140 * z174 - z152 * z202))
        z204 = z153 * z203 + s28
        z205 = z26 * z188 + z32 * z183
        s29 = z39 * (z51 * z189 + z33 * z204 - z5 * z205)
        z206 = s29 - (z167 * z153 - e2z * z191)
        z207 = z165 * z154 - c_steer * z206 - (z168 * z195 + s_steer * z197)
        z208 = z39 * (z51 * z190 + z13 * z205 + z34 * z204) - z206
        z209 = z155 * z177 + z15 * z208 - (z154 * z156 - v2_x * z194)
        z210 = k9 * z154
        z211 = k9 * z194
        z212 = z209 - (z154 * z210 + z194 * z211)
        z213 = z196 - (k9 * z193 + z210 * z195)
        z214 = c_steer * z212 + s_steer * z213
        z215 = z155 * z201 + z5 * z208 - (v2_x * z195 - z154 * z157)
        z216 = z215 + (k9 * z206 + z195 * z211)
        w3_steer = steer_dot + z194
        z217 = s_steer * z154 - c_steer * z195
        z218 = k57 * z217 + k58 * w3_steer
        z219 = k58 * z217 + k61 * w3_steer
        s30 = k55 * z214 + (k41 * z216 - (w3_steer * z218 - z217 * z219))
        z220 = z8 * k62 - (k60 * z207 + s30)
        z221 = z7 * k63 - z220
        z222 = F_yy * z207
        z223 = R_yy * z155 - k32 * z154
        z224 = k29 * z195 - k30 * z194
        s31 = k33 * z193 - (k23 * z196 - k30 * z197)
        z225 = e2z * k46 - (s31 - (z195 * z223 + z154 * z224))
        h2z = e2z * c_steer + s_steer * z3
        z226 = c_steer * z213 - s_steer * z212
        z227 = z168 * z154 + s_steer * z206 + (z165 * z195 - c_steer * z197)
        z228 = c_steer * z154 + s_steer * z195
        z229 = F_yy * (thF_dot - z228) - k60 * z228
        s32 = k61 * z193 + (k41 * z226 - k58 * z227)
        z230 = h2z * k63 + (s32 + (z217 * z229 + z228 * z218))
        z231 = z225 - z230
        s33 = k58 * z193 - (k55 * z226 + k57 * z227)
        z232 = h2z * k62 + (s33 - (z228 * z219 + w3_steer * z229))
        z233 = k55 * z217 - k41 * w3_steer
        z234 = k55 * z228
        s34 = k34 * z216 + k41 * z207 - (z217 * z233 + z228 * z234)
        z235 = z7 * k48 + s34
        z236 = k41 * z228
        s35 = k41 * z193 + (k34 * z226 + k55 * z227)
        z237 = h2z * k48 + (s35 - (w3_steer * z234 + z217 * z236))
        s36 = k34 * z214 + k55 * z207 + (z228 * z236 - w3_steer * z233)
        z238 = z8 * k48 + s36
        z239 = k30 * z195 - k33 * z194
        s37 = k32 * z206 + (k22 * z209 + k23 * z215)
        z240 = z3 * k47 - z7 * k46 - (s37 - (z194 * z224 + z195 * z239))
        s38 = k30 * z193 + (k22 * z196 + k29 * z197)
        z241 = e2z * k47 + (s38 + (z154 * z239 - z194 * z223))
        z242 = k22 * z195 + k23 * z194
        s39 = k21 * z215 + k23 * z206 + (z195 * z242 + z154 * z198)
        z243 = z7 * k45 + s39
        s40 = k21 * z209 + k22 * z206 - (z154 * z199 + z194 * z242)
        z244 = z3 * k45 - s40
        z245 = R_yy * z208
        s41 = z48 * z241 - (z69 * z243 - (z54 * z244 - z52 * z245))
        z246 = z56 * z238 + (z52 * z240 - s41)
        s42 = z47 * z231 - (z62 * z232 - (z57 * z235 - (z61 * z237 + z246)))
        z247 = z53 * (z221 + z222) - s42
        z248 = z38 * z200 - z247
        s43 = z86 * z244 - (z94 * z243 - (z248 * z104 - z85 * z245))
        z249 = z84 * z240 - (z88 * z241 - s43)
        z250 = z82 * z230 - (z89 * z232 + (z87 * z237 + (z81 * z225 + z249)))
        s44 = z248 * z132 + (z136 * z250 - (z113 * z245 - z127 * z222))
        z251 = z114 * z244 - (z120 * z243 - s44)
        s45 = z119 * z238 - (z112 * z240 - (z116 * z241 - z251))
        z252 = z117 * z232 - (z121 * z235 - (z115 * z237 - s45))
        z253 = (z110 * z231 + (z118 * z221 + z252)) / z137
        z254 = z135 * z250 + z136 * z253
        dydt: list[float] = [
            # x' (I.2.4)
            -(c_yaw * z158 + s_yaw * z159),
            # y' (I.2.4)
            c_yaw * z159 - s_yaw * z158,
            # z' (I.2.4)
            e2z * v2_x,
            # yaw' (I.2.4)
            z153,
            # roll' (I.2.4)
            roll_dot,
            # pitch' (I.2.4)
            -z152,
            # steer' (I.2.4)
            steer_dot,
            # thR' (I.2.4)
            z150,
            # thF' (I.2.4)
            thF_dot,
            # roll'' (I.2.15) 112:4
            z248 * z103 + z104 * z254 - z132 * z253,
            # steer'' (I.2.15) 112:4
            z254,
            # thF'' (I.2.15) 112:4
            -z253,
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns qdot (9,).
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = r_R * s_lam - c_lam * k1
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        k5 = abs(r_R)
        k6 = abs(r_F)
        k7 = abs(w)
        k8 = abs(c)
        k9 = 9.0 * k6
        k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9))
        k11 = 6.0 * k7
        k12 = 14.0 * k6 + 13.0 * k8
        k13 = k9 + 10.0 * k8
        # from the state
        c_roll = math.cos(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        z2 = c_roll * s1
        z3 = 1.0 / abs(c_roll)
        z4 = r_R * z3
        z5 = z2 * z4
        c_steer = math.cos(steer)
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z6 = e2z * s_steer - c_steer * z2
        c1 = math.cos(z1)
        z7 = c_roll * c1
        z8 = r_F / math.sqrt(z7 * z7 + z6 * z6)
        z9 = z6 * z8
        z10 = k2 + z9
        z11 = k3 - z5 - c_steer * z10
        z12 = z7 * z4
        z13 = c_steer * z12
        z14 = z7 * z8
        z15 = k4 + z14
        z16 = s1 * z15
        z17 = z12 - z15
        z18 = s_steer * z17
        s2 = c_roll * (c_steer * z16 - c1 * (c_steer * k3 - z10))
        z19 = s2 + e2z * z18
        z20 = c_steer * z17
        z21 = c_roll * (s_steer * z16 - k3 * (s_steer * c1)) - e2z * z20
        z22 = s_steer * z12
        z23 = z13 * z19 + z21 * z22
        z24 = z20 * z19 + z21 * z18
        z25 = z11 * z23 + z5 * z24
        z26 = k11 + k5 * (9.0 + abs(z3))
        s3 = (z26 + k12) * (z26 + k13)
        # the coframe is singular, if z25 is nearly 0
        if not abs(z25) > 1e-12 * (k10 * s3):
            raise _refuse(abs(z25), 1e-12 * (k10 * s3), 1, "velocities")
        s_yaw = math.sin(yaw)
        v2_x = c_roll * (roll_dot * z4)
        z27 = c_roll * v2_x
        c_yaw = math.cos(yaw)
        z28 = s_steer * z2 * z10 - e2z * z11
        z29 = roll_dot * s1
        z30 = steer_dot + z29
        z31 = roll_dot * c1
        z32 = c_steer * z31
        z33 = k3 * z29 - v2_x
        z34 = z30 * z9 - z32 * z14 - (k4 * z32 - k2 * z30 + c_steer * z33)
        z35 = s_steer * z31
        z36 = thF_dot - z35
        z37 = z36 * z14 - (k4 * z35 + s_steer * z33)
        z38 = z20 * z34 + z18 * z37
        z39 = z19 * z37 - z21 * z34
        z40 = k2 * z35 - z36 * z9
        z41 = 1.0 / z25
        z42 = (z28 * z38 + z11 * z39 + z24 * z40) * z41
        z43 = z13 * z34 + z22 * z37
        z44 = (z28 * z43 + z23 * z40 - z5 * z39) * z41
        z45 = z41 * (z11 * z43 + z5 * z38)
        z46 = (z42 - (z44 + e2z * z45)) * (s1 * z5 + c1 * z12)
        qdot: list[float] = [
            # x' (I.2.4)
            -(s_yaw * z27 + c_yaw * z46),
            # y' (I.2.4)
            c_yaw * z27 - s_yaw * z46,
            # z' (I.2.4)
            e2z * v2_x,
            # yaw' (I.2.4)
            -z45,
            # roll' (I.2.4)
            roll_dot,
            # pitch' (I.2.4)
            -z44,
            # steer' (I.2.4)
            steer_dot,
            # thR' (I.2.4)
            z42,
            # thF' (I.2.4)
            thF_dot,
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns qddot (9,).
    """
    dydt = rhs(t, y, p)
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    roll_ddot = float(dydt[9])  # roll''
    steer_ddot = float(dydt[10])  # steer''
    thF_ddot = float(dydt[11])  # thF''
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = r_R * s_lam - c_lam * k1
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        # from the state
        s_yaw = math.sin(yaw)
        c_roll = math.cos(roll)
        z1 = 1.0 / abs(c_roll)
        z2 = pitch + lam
        s1 = math.sin(z2)
        z3 = c_roll * s1
        z4 = r_R * z3
        z5 = z1 * z4
        c_steer = math.cos(steer)
        c1 = math.cos(z2)
        z6 = c_roll * c1
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z7 = e2z * s_steer - c_steer * z3
        z8 = 1.0 / math.sqrt(z6 * z6 + z7 * z7)
        z9 = r_F * z7
        z10 = z8 * z9
        z11 = k2 + z10
        z12 = k3 - z5 - c_steer * z11
        z13 = r_R * z6
        z14 = z1 * z13
        z15 = c_steer * z14
        z16 = r_F * z6
        z17 = z8 * z16
        z18 = k4 + z17
        z19 = c_steer * z18
        z20 = c_steer * k3 - z11
        z21 = s1 * z19 - c1 * z20
        z22 = z14 - z18
        z23 = s_steer * z22
        z24 = c_roll * z21 + e2z * z23
        z25 = s_steer * z18
        z26 = s_steer * k3
        z27 = s1 * z25 - c1 * z26
        z28 = c_steer * z22
        z29 = c_roll * z27 - e2z * z28
        z30 = s_steer * z14
        z31 = z15 * z24 + z29 * z30
        z32 = z28 * z24 + z29 * z23
        z33 = 1.0 / (z12 * z31 + z5 * z32)
        z34 = roll_dot * s1
        z35 = steer_dot + z34
        z36 = roll_dot * c1
        z37 = c_steer * z36
        z38 = roll_dot * r_R
        z39 = c_roll * z38
        v2_x = z1 * z39
        z40 = v2_x - k3 * z34
        z41 = z10 * z35 - z17 * z37 - (k4 * z37 - k2 * z35 - c_steer * z40)
        z42 = s_steer * z36
        z43 = thF_dot - z42
        z44 = z17 * z43 - (k4 * z42 - s_steer * z40)
        z45 = z15 * z41 + z30 * z44
        z46 = z28 * z41 + z23 * z44
        z47 = z12 * z45 + z5 * z46
        z48 = z33 * z47
        z49 = s_yaw * z48
        z50 = s_steer * z11
        z51 = s1 * z50
        z52 = c_roll * z51 - e2z * z12
        z53 = z24 * z44 - z29 * z41
        z54 = k2 * z42 - z10 * z43
        z55 = z52 * z46 + z12 * z53 + z32 * z54
        z56 = z52 * z45 + z31 * z54 - z5 * z53
        z57 = z56 * z33
        z58 = z55 * z33 - (z57 + e2z * z48)
        z59 = z5 * z58
        z60 = s1 * z59 + z58 * (c1 * z14)
        c_yaw = math.cos(yaw)
        z61 = c1 * z57
        z62 = z59 * z61
        z63 = roll_dot * e2z
        z64 = z1 * (c_roll * z63) * (z1 * z1)
        z65 = r_R * z1
        z66 = z63 * s1 + c_roll * z61
        z67 = z4 * z64 - z65 * z66
        z68 = steer_dot * s_steer
        z69 = s1 * z57
        z70 = z63 * c1 - c_roll * z69
        z71 = roll_dot * c_roll
        z72 = steer_dot * c_steer
        z73 = s_steer * z71 + e2z * z72 + (z68 * z3 + c_steer * z66)
        z74 = z8 * (z8 * z8) * (z6 * z70 - z7 * z73)
        z75 = r_F * z8
        z76 = z9 * z74 + z75 * z73
        z77 = z67 - (z68 * z11 - c_steer * z76)
        z78 = z13 * z64 - z65 * z70
        z79 = z68 * z14 - c_steer * z78
        z80 = z16 * z74 - z75 * z70
        s2 = z19 * z61 + s1 * (z68 * z18 - c_steer * z80)
        z81 = s2 + (z20 * z69 - c1 * (z68 * k3 + z76))
        z82 = z78 - z80
        z83 = z72 * z22 + s_steer * z82
        z84 = z63 * z21 + c_roll * z81 - (z71 * z23 + e2z * z83)
        s3 = z25 * z61 - s1 * (z72 * z18 + s_steer * z80)
        z85 = s3 + (k3 * (z72 * c1) + z26 * z69)
        z86 = z68 * z22 - c_steer * z82
        z87 = z63 * z27 + c_roll * z85 + (z71 * z28 - e2z * z86)
        z88 = z72 * z14 + s_steer * z78
        z89 = z24 * z79 + z15 * z84 + (z30 * z87 - z29 * z88)
        z90 = z24 * z86 + z28 * z84 + (z23 * z87 - z29 * z83)
        z91 = z33 * z33 * (z31 * z77 + z12 * z89 - (z32 * z67 - z5 * z90))
        s4 = c_roll * (z50 * z61 - s1 * (z72 * z11 + s_steer * z76))
        z92 = z63 * z51 + s4 + (z71 * z12 - e2z * z77)
        z93 = s1 * roll_ddot - roll_dot * z61
        z94 = steer_ddot + z93
        z95 = c1 * roll_ddot + roll_dot * z69
        z96 = z68 * z36 - c_steer * z95
        z97 = z39 * z64 - z1 * (z63 * z38 - r_R * (c_roll * roll_ddot))
        z98 = k3 * z93 - z97
        s5 = k4 * z96 + k2 * z94 - (z68 * z40 + c_steer * z98)
        z99 = z10 * z94 + z35 * z76 + (z17 * z96 - z37 * z80) + s5
        z100 = z72 * z36 + s_steer * z95
        z101 = thF_ddot - z100
        s6 = k4 * z100 - (z72 * z40 - s_steer * z98)
        z102 = z17 * z101 + z43 * z80 - s6
        z103 = z41 * z86 - z28 * z99 - (z44 * z83 + z23 * z102)
        z104 = z44 * z84 - z24 * z102 - (z41 * z87 - z29 * z99)
        z105 = k2 * z100 - (z10 * z101 + z43 * z76)
        s7 = z46 * z92 + z52 * z103 + (z53 * z77 + z12 * z104)
        z106 = s7 + (z54 * z90 - z32 * z105)
        z107 = z55 * z91 - z33 * z106
        z108 = z41 * z79 - z15 * z99 - (z44 * z88 + z30 * z102)
        s8 = z45 * z92 + z52 * z108 + (z54 * z89 - z31 * z105)
        z109 = s8 + (z53 * z67 - z5 * z104)
        z110 = z56 * z91 - z33 * z109
        s9 = z33 * (z45 * z77 + z12 * z108 - (z46 * z67 - z5 * z103))
        z111 = z47 * z91 - s9
        z112 = z107 - (z110 + (z71 * z48 + e2z * z111))
        s10 = z62 + c1 * (z58 * z78 + z14 * z112)
        z113 = z62 - s1 * (z58 * z67 + z5 * z112) - s10
        z114 = c_roll * v2_x
        z115 = c_yaw * z48
        z116 = z63 * v2_x - c_roll * z97
        qddot: list[float] = [
            # x'' (I.2.15)
            z114 * z115 + s_yaw * z116 - (z49 * z60 - c_yaw * z113),
            # y'' (I.2.15)
            z115 * z60 + s_yaw * z113 + (z114 * z49 - c_yaw * z116),
            # z'' (I.2.15)
            z71 * v2_x + e2z * z97,
            # yaw'' (I.2.15)
            -z111,
            # roll'' (I.2.15)
            roll_ddot,
            # pitch'' (I.2.15)
            -z110,
            # steer'' (I.2.15)
            steer_ddot,
            # thR'' (I.2.15)
            z107,
            # thF'' (I.2.15)
            thF_ddot,
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

    Arguments: t (scalar), q (9,), qdot (9,), p (26,).
    Returns y (12,).
    """
    x = float(q[0])  # centre of the rear wheel [m]
    y_2 = float(q[1])  # y: centre of the rear wheel [m]
    z = float(q[2])  # centre of the rear wheel, downwards [m]
    yaw = float(q[3])  # first turn of the rear frame, about z [rad]
    roll = float(q[4])  # second turn, about x [rad]
    pitch = float(q[5])  # third turn, about y [rad]
    steer = float(q[6])  # front frame against rear frame [rad]
    thR = float(q[7])  # rear wheel against rear frame [rad]
    thF = float(q[8])  # front wheel against front frame [rad]
    roll_dot = float(qdot[4])  # roll' [rad/s]
    steer_dot = float(qdot[6])  # steer' [rad/s]
    thF_dot = float(qdot[8])  # thF' [rad/s]
    try:
        # from the coordinates and velocities
        y: list[float] = [
            x,
            y_2,
            z,
            yaw,
            roll,
            pitch,
            steer,
            thR,
            thF,
            roll_dot,
            steer_dot,
            thF_dot,
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

    Arguments: t (scalar), q (9,), qdot (9,), p (26,).
    Returns r (6,).
    """
    yaw = float(q[3])  # first turn of the rear frame, about z [rad]
    roll = float(q[4])  # second turn, about x [rad]
    pitch = float(q[5])  # third turn, about y [rad]
    steer = float(q[6])  # front frame against rear frame [rad]
    x_dot = float(qdot[0])  # x' [m/s]
    y_dot = float(qdot[1])  # y' [m/s]
    z_dot = float(qdot[2])  # z' [m/s]
    yaw_dot = float(qdot[3])  # yaw' [rad/s]
    roll_dot = float(qdot[4])  # roll' [rad/s]
    pitch_dot = float(qdot[5])  # pitch' [rad/s]
    steer_dot = float(qdot[6])  # steer' [rad/s]
    thR_dot = float(qdot[7])  # thR' [rad/s]
    thF_dot = float(qdot[8])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        # from the coordinates and velocities
        c_yaw = math.cos(yaw)
        c_pitch = math.cos(pitch)
        s_yaw = math.sin(yaw)
        e2z = math.sin(roll)
        z1 = s_yaw * e2z
        s_pitch = math.sin(pitch)
        e1x = c_yaw * c_pitch - z1 * s_pitch
        w2 = pitch_dot + yaw_dot * e2z
        z2 = thR_dot + w2
        c_roll = math.cos(roll)
        e3z = c_pitch * c_roll
        z3 = s_pitch * c_roll
        z4 = r_R / math.sqrt(z3 * z3 + e3z * e3z)
        R3 = e3z * z4
        a1 = z2 * R3
        z5 = s_yaw * c_roll
        w3 = roll_dot * s_pitch + yaw_dot * e3z
        z6 = z3 * z4
        w1 = roll_dot * c_pitch - yaw_dot * z3
        z7 = w3 * z6 + w1 * R3
        e3x = c_yaw * s_pitch + c_pitch * z1
        a3 = z2 * z6
        z8 = c_yaw * e2z
        e1y = c_pitch * s_yaw + s_pitch * z8
        e2y = c_yaw * c_roll
        e3y = s_yaw * s_pitch - c_pitch * z8
        z9 = z3 * a1
        z10 = yaw_dot * s_yaw
        z11 = pitch_dot * s_pitch
        z12 = yaw_dot * c_yaw
        z13 = roll_dot * c_roll
        z14 = e2z * z12 + s_yaw * z13
        z15 = pitch_dot * c_pitch
        z16 = c_pitch * z10 + c_yaw * z11 + (s_pitch * z14 + z1 * z15)
        z17 = s_pitch * z10 - c_yaw * z15 + (z1 * z11 - c_pitch * z14)
        z18 = e1x * c_lam - e3x * s_lam
        s_steer = math.sin(steer)
        z19 = steer_dot * s_steer
        c_steer = math.cos(steer)
        z20 = roll_dot * e2z
        z21 = steer_dot * c_steer
        s1 = z18 * z19 + c_steer * (c_lam * z16 - s_lam * z17)
        z22 = s1 + (s_steer * (c_roll * z12 - s_yaw * z20) + z5 * z21)
        z23 = s_lam * z16 + c_lam * z17
        s2 = c * (c_lam * z22 + s_lam * z23)
        s3 = x_dot - k1 * z16 - r_R * z17 + s2
        Fx_dot = s3 + r_F * (c_lam * z23 - s_lam * z22)
        f1x = c_steer * z18 - z5 * s_steer
        sx = e1x * s_lam + e3x * c_lam
        z24 = c_lam * w1 - s_lam * w3
        z25 = thF_dot + (c_steer * w2 - s_steer * z24)
        z26 = z3 * s_lam - e3z * c_lam
        z27 = z3 * c_lam + e3z * s_lam
        z28 = c_steer * z27 - e2z * s_steer
        z29 = c_lam * z26 - s_lam * z28
        z30 = c_lam * z28 + s_lam * z26
        z31 = r_F / math.sqrt(z30 * z30 + z29 * z29)
        z32 = z29 * z31
        z33 = z25 * z32
        ws = steer_dot + (s_lam * w1 + c_lam * w3)
        wf = c_steer * z24 + s_steer * w2
        z34 = z30 * z31
        s4 = (c_lam * ws - s_lam * wf) * z34
        z35 = s4 - (c_lam * wf + s_lam * ws) * z32
        b3 = z25 * z34
        s5 = Fx_dot - (c_lam * f1x + s_lam * sx) * z33
        s6 = s5 + (z5 * c_steer + z18 * s_steer) * z35
        z36 = s6 + (c_lam * sx - s_lam * f1x) * b3
        z37 = e2z * z10 - c_yaw * z13
        z38 = s_yaw * z11 - c_pitch * z12 - (z8 * z15 - s_pitch * z37)
        z39 = s_pitch * z12 + s_yaw * z15 + (z8 * z11 + c_pitch * z37)
        z40 = e1y * c_lam - e3y * s_lam
        s7 = s_steer * (c_roll * z10 + c_yaw * z20) - e2y * z21
        z41 = z40 * z19 + c_steer * (c_lam * z38 + s_lam * z39) + s7
        z42 = s_lam * z38 - c_lam * z39
        s8 = c * (c_lam * z41 + s_lam * z42)
        s9 = y_dot - k1 * z38 + r_R * z39 + s8
        Fy_dot = s9 + r_F * (c_lam * z42 - s_lam * z41)
        f1y = c_steer * z40 + e2y * s_steer
        sy = e1y * s_lam + e3y * c_lam
        s10 = Fy_dot - (c_lam * f1y + s_lam * sy) * z33
        s11 = s10 - (e2y * c_steer - s_steer * z40) * z35
        z43 = s11 + (c_lam * sy - s_lam * f1y) * b3
        z44 = z30 * z33
        z45 = c_roll * z15 - s_pitch * z20
        z46 = c_roll * z11 + c_pitch * z20
        s12 = z27 * z19 - c_steer * (c_lam * z45 - s_lam * z46)
        z47 = s12 + (s_steer * z13 + e2z * z21)
        z48 = s_lam * z45 + c_lam * z46
        s13 = c * (c_lam * z47 - s_lam * z48)
        s14 = z_dot - k1 * z45 - r_R * z46 - s13
        Fz_dot = s14 + r_F * (c_lam * z48 + s_lam * z47)
        r: list[float] = [
            # rear_x = 0 (I.1.1) 115:5
            x_dot + e1x * a1 + z5 * z7 + e3x * a3,
            # rear_y = 0 (I.1.1) 116:5
            y_dot + e1y * a1 - e2y * z7 + e3y * a3,
            # rear_z = 0 (I.1.1) 117:5
            z9 + (z_dot - z9 - e2z * z7),
            # front_x = 0 (I.1.1) 118:5
            z36,
            # front_y = 0 (I.1.1) 119:5
            z43,
            # front_z = 0 (I.1.1) 120:5
            Fz_dot + z44 - (e2z * c_steer + s_steer * z27) * z35 - z44,
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns lambda_ (6,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    dydt = rhs(t, y, p)
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    g = float(p[3])  # acceleration of gravity [m/s^2]
    r_R = float(p[4])  # radius of the rear wheel [m]
    m_R = float(p[5])  # mass of the rear wheel [kg]
    R_xx = float(p[6])  # rear wheel, across the axle [kg*m^2]
    R_yy = float(p[7])  # rear wheel, about the axle [kg*m^2]
    x_B = float(p[8])  # rear frame and rider, ahead of the rear contact [m]
    z_B = float(p[9])  # [m]
    m_B = float(p[10])  # [kg]
    B_xx = float(p[11])  # [kg*m^2]
    B_xz = float(p[12])  # [kg*m^2]
    B_yy = float(p[13])  # [kg*m^2]
    B_zz = float(p[14])  # [kg*m^2]
    x_H = float(p[15])  # front frame, ahead of the rear contact [m]
    z_H = float(p[16])  # [m]
    m_H = float(p[17])  # [kg]
    H_xx = float(p[18])  # [kg*m^2]
    H_xz = float(p[19])  # [kg*m^2]
    H_yy = float(p[20])  # [kg*m^2]
    H_zz = float(p[21])  # [kg*m^2]
    r_F = float(p[22])  # radius of the front wheel [m]
    m_F = float(p[23])  # mass of the front wheel [kg]
    F_xx = float(p[24])  # front wheel, across the axle [kg*m^2]
    F_yy = float(p[25])  # front wheel, about the axle [kg*m^2]
    roll_ddot = float(dydt[9])  # roll''
    steer_ddot = float(dydt[10])  # steer''
    thF_ddot = float(dydt[11])  # thF''
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = r_R + z_B
        k2 = w + c
        k3 = r_F * s_lam - c * c_lam
        k4 = H_zz + F_xx
        k5 = H_xx + F_xx
        k6 = R_xx + B_xx
        k7 = R_xx + B_zz
        k8 = x_H - k2
        k9 = r_R * s_lam - c_lam * k2
        k10 = z_H * s_lam - c_lam * k8
        k11 = r_R * c_lam + s_lam * k2
        k12 = c_lam * k1 + x_B * s_lam
        k13 = s_lam * k1 - x_B * c_lam
        k14 = m_R + m_B
        k15 = m_B * k12
        k16 = m_B * k13
        k17 = B_xz * c_lam
        k18 = s_lam * k7 - k17
        k19 = B_xz * s_lam
        k20 = c_lam * k6 - k19
        k21 = k12 * k15
        k22 = s_lam * k18 + c_lam * k20 + k21
        k23 = c_lam * k18 - s_lam * k20 - k13 * k15
        k24 = k13 * k16
        k25 = k21 + (B_yy + k24)
        s2 = c_lam * (k19 + c_lam * k7) + s_lam * (k17 + s_lam * k6)
        k26 = k24 + s2
        k27 = m_H + m_F
        k28 = m_F * k3
        k29 = H_xz * c_lam
        k30 = s_lam * k4 - k29
        k31 = H_xz * s_lam
        k32 = c_lam * k5 - k31
        k33 = m_H * k10
        k34 = k28 - k33
        k35 = g * m_F
        k36 = g * m_H
        k37 = g * m_B
        k38 = g * k14
        k39 = k13 * k37
        k40 = k12 * k37
        k41 = g * k27
        k42 = k3 * k35
        k43 = k11 + (z_H * c_lam + s_lam * k8)
        k44 = r_F * c_lam + c * s_lam - k11
        k45 = m_F * k44
        k46 = m_H * k43
        k47 = k45 - k46
        k48 = k44 * k45 + k43 * k46
        k49 = s_lam * k30 + c_lam * k32 + k48
        k50 = c_lam * k30 - s_lam * k32 - k3 * k45 - k10 * k46
        k51 = k3 * k28 + k10 * k33
        k52 = k51 + (H_yy + k48)
        s3 = c_lam * (k31 + c_lam * k4) + s_lam * (k29 + s_lam * k5)
        k53 = s3 + k51
        k54 = k10 * k36
        k55 = k36 * k43
        k56 = k35 * k44
        k57 = k55 - k56
        k58 = k42 - k54
        # from the state
        s_yaw = math.sin(yaw)
        e2z = math.sin(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        c_roll = math.cos(roll)
        z2 = c_roll * s1
        z3 = 1.0 / abs(c_roll)
        z4 = r_R * z2
        z5 = z3 * z4
        c_steer = math.cos(steer)
        c1 = math.cos(z1)
        z6 = c_roll * c1
        s_steer = math.sin(steer)
        z7 = e2z * s_steer - c_steer * z2
        z8 = 1.0 / math.sqrt(z6 * z6 + z7 * z7)
        z9 = r_F * z7
        z10 = z8 * z9
        z11 = k3 + z10
        z12 = k9 - z5 - c_steer * z11
        z13 = r_R * z6
        z14 = z3 * z13
        z15 = c_steer * z14
        z16 = c_steer * k9 - z11
        z17 = r_F * z6
        z18 = z8 * z17
        z19 = z18 - k44
        z20 = c_steer * z19
        z21 = c1 * z16 - s1 * z20
        z22 = z14 - z19
        z23 = s_steer * z22
        z24 = c_roll * z21 - e2z * z23
        z25 = s_steer * z14
        z26 = s_steer * k9
        z27 = s_steer * z19
        z28 = c1 * z26 - s1 * z27
        z29 = c_steer * z22
        z30 = c_roll * z28 + e2z * z29
        z31 = z15 * z24 + z25 * z30
        z32 = z29 * z24 + z30 * z23
        z33 = 1.0 / (z12 * z31 + z5 * z32)
        z34 = roll_dot * c1
        z35 = s_steer * z34
        z36 = thF_dot - z35
        z37 = k3 * z35 - z10 * z36
        z38 = s_steer * z11
        z39 = s1 * z38
        z40 = c_roll * z39 - e2z * z12
        z41 = roll_dot * s1
        z42 = r_R * z3
        z43 = c_roll * z42
        v2_x = roll_dot * z43
        z44 = k9 * z41 - v2_x
        z45 = z18 * z36 + (z35 * k44 - s_steer * z44)
        z46 = steer_dot + z41
        z47 = c_steer * z34
        s4 = c_steer * z44 - (k3 * z46 + z47 * k44)
        z48 = z10 * z46 - z18 * z47 - s4
        z49 = z23 * z45 + z29 * z48
        z50 = z24 * z45 - z30 * z48
        z51 = z33 * (z37 * z32 - (z40 * z49 - z12 * z50))
        z52 = z25 * z45 + z15 * z48
        z53 = z33 * (z37 * z31 - z40 * z52 - z5 * z50)
        z54 = z33 * (z12 * z52 + z5 * z49)
        z55 = z53 - e2z * z54
        z56 = z51 - z55
        z57 = roll_dot * e2z
        z58 = z3 * (c_roll * z57) * (z3 * z3)
        z59 = s1 * z53
        z60 = z57 * c1 - c_roll * z59
        z61 = z13 * z58 - z42 * z60
        z62 = roll_dot * c_roll
        z63 = steer_dot * c_steer
        z64 = steer_dot * s_steer
        z65 = c1 * z53
        z66 = z57 * s1 + c_roll * z65
        z67 = s_steer * z62 + e2z * z63 + (z64 * z2 + c_steer * z66)
        z68 = z8 * (z8 * z8) * (z6 * z60 - z7 * z67)
        z69 = r_F * z8
        z70 = z9 * z68 + z69 * z67
        z71 = roll_dot * z65
        z72 = z17 * z68 - z69 * z60
        z73 = roll_dot * z59
        z74 = z64 * z34 - c_steer * z73
        z75 = k9 * z71
        s5 = k44 * z74 + k3 * z71 - (z64 * z44 + c_steer * z75)
        z76 = z46 * z70 - z10 * z71 - (z47 * z72 - z18 * z74) - s5
        s6 = z20 * z65 + s1 * (z64 * z19 - c_steer * z72)
        z77 = s6 + (z16 * z59 - c1 * (z64 * k9 + z70))
        z78 = z61 - z72
        z79 = z63 * z22 + s_steer * z78
        s7 = z54 * (z57 * z21 - c_roll * z77 + (z62 * z23 + e2z * z79))
        z80 = z51 * (z63 * z14 + s_steer * z61) + (s7 - z53 * z79)
        z81 = z76 + z80
        z82 = z63 * z34 + s_steer * z73
        s8 = z27 * z65 - s1 * (z63 * z19 + s_steer * z72)
        z83 = s8 + (k9 * (z63 * c1) + z26 * z59)
        z84 = z64 * z22 - c_steer * z78
        s9 = z54 * (z57 * z28 - c_roll * z83 - (z62 * z29 - e2z * z84))
        z85 = z51 * (z64 * z14 - c_steer * z61) + (s9 - z53 * z84)
        s10 = k44 * z82 - (z63 * z44 - s_steer * z75)
        z86 = z36 * z72 - z18 * z82 + s10 + z85
        z87 = z29 * z81 + z23 * z86
        z88 = z24 * z86 - z30 * z81
        z89 = z4 * z58 - z42 * z66
        z90 = z89 - (z64 * z11 - c_steer * z70)
        s11 = c_roll * (z38 * z65 - s1 * (z63 * z11 + s_steer * z70))
        z91 = z57 * z39 + s11 + (z62 * z12 - e2z * z90)
        s12 = z51 * z89 - (z54 * z91 + z53 * z90)
        z92 = k3 * z82 - (z36 * z70 - z10 * z82) - s12
        z93 = z15 * z81 + z25 * z86
        z94 = z33 * (z12 * z93 + z5 * z87)
        s13 = z33 * (z40 * z93 - z31 * z92 + z5 * z88)
        z95 = s13 + (z62 * z54 + e2z * z94)
        z96 = z33 * (z40 * z87 - z12 * z88 - z32 * z92) - z95
        z97 = z5 * z56
        z98 = c_roll * z54
        z99 = z41 + c1 * z98
        z100 = z56 * z61 - z14 * z96 - (z55 * z97 - v2_x * z99)
        z101 = k16 * z55
        z102 = z34 - s1 * z98
        z103 = k15 * z102 + k16 * z99
        z104 = s1 * roll_ddot
        z105 = steer_ddot + z104
        z106 = c1 * roll_ddot
        z107 = c_steer * z106
        z108 = roll_ddot * z43
        z109 = k9 * z104 - z108
        s14 = k3 * z105 + k44 * z107 - c_steer * z109
        z110 = z10 * z105 - z18 * z107 + s14
        z111 = s_steer * z106
        z112 = thF_ddot - z111
        z113 = z18 * z112 + (k44 * z111 - s_steer * z109)
        z114 = z29 * z110 + z23 * z113
        z115 = z24 * z113 - z30 * z110
        z116 = k3 * z111 - z10 * z112
        z117 = z15 * z110 + z25 * z113
        z118 = z33 * (z12 * z117 + z5 * z114)
        z119 = z33 * (z40 * z117 - z31 * z116 + z5 * z115) + e2z * z118
        z120 = z33 * (z40 * z114 - z12 * z115 - z32 * z116) - z119
        z121 = z14 * z120
        s15 = k14 * z100 - k15 * z95 - (z55 * z101 + z99 * z103)
        z122 = z2 * k38 - s15 + (k14 * z121 + k15 * z119)
        h2z = e2z * c_steer + s_steer * z2
        z123 = z57 * z54 - c_roll * z94
        z124 = z71 - (z59 * z98 - c1 * z123)
        z125 = z14 * z56
        z126 = z125 * z99 - z97 * z102
        z127 = k9 * z55
        z128 = z126 - (k9 * z124 + z127 * z102)
        z129 = k9 * z99
        z130 = z100 - (z55 * z127 + z99 * z129)
        z131 = c_steer * z128 - s_steer * z130
        z132 = z73 + (z65 * z98 + s1 * z123)
        z133 = z63 * z55 - s_steer * z95 + (z64 * z102 - c_steer * z132)
        w3_steer = steer_dot + z99
        z134 = c_steer * z55 + s_steer * z102
        z135 = k47 * z134
        z136 = s_steer * z55 - c_steer * z102
        z137 = k34 * z134
        s16 = k34 * z124 + (k27 * z131 + k47 * z133)
        z138 = h2z * k41 + (s16 - (w3_steer * z135 + z136 * z137))
        z139 = c_roll * z118
        z140 = z104 + c1 * z139
        z141 = steer_ddot + z140
        z142 = z108 - k9 * z140
        z143 = c_steer * z142 - s_steer * z121
        z144 = z106 - s1 * z139
        z145 = s_steer * z119 + c_steer * z144
        z146 = z138 - (k34 * z141 + (k27 * z143 + k47 * z145))
        z147 = c_steer * z130 + s_steer * z128
        z148 = z64 * z55 + c_steer * z95 - (z63 * z102 + s_steer * z132)
        z149 = k47 * z136 - k34 * w3_steer
        z150 = c_steer * z121 + s_steer * z142
        z151 = c_steer * z119 - s_steer * z144
        s17 = k27 * z147 + k47 * z148 + (z134 * z137 - w3_steer * z149)
        z152 = z7 * k41 + s17 - (k27 * z150 - k47 * z151)
        z153 = z122 + s_steer * z146 - c_steer * z152
        z154 = z56 * z89 - z5 * z96 - (v2_x * z102 - z55 * z125)
        z155 = k15 * z55
        z156 = z5 * z120
        s18 = k14 * z154 - k16 * z95 + (z102 * z103 + z55 * z155)
        z157 = z6 * k38 + s18 - (k14 * z156 + k16 * z119)
        z158 = z154 - (k9 * z95 - z102 * z129)
        z159 = z156 + k9 * z119
        s19 = k27 * z158 + k34 * z148 - (z136 * z149 + z134 * z135)
        z160 = z6 * k41 + s19 - (k27 * z159 - k34 * z151)
        z161 = z157 + z160
        z162 = R_yy * (z96 + z120) - z5 * z161 + z14 * z153
        z163 = z33 * z162
        z164 = k22 * z102 - k23 * z99
        z165 = k23 * z102 - k26 * z99
        s20 = k25 * z95 - (k15 * z100 + k16 * z154)
        z166 = z2 * k40 - z6 * k39 + (s20 + (z99 * z164 + z102 * z165))
        z167 = k49 * z136 + k50 * w3_steer
        z168 = k50 * z136 + k53 * w3_steer
        s21 = k52 * z148 + (k47 * z147 + k34 * z158)
        s22 = z7 * k55 + z6 * k54 - (z6 * k42 + z7 * k56)
        z169 = s22 - (s21 - (w3_steer * z167 - z136 * z168))
        s23 = z169 - (k52 * z151 - (k47 * z150 + k34 * z159))
        z170 = s23 - F_yy * (z148 + (thF_ddot + z151))
        z171 = F_yy * (thF_dot - z134) - k52 * z134
        s24 = k50 * z124 - (k47 * z131 + k49 * z133)
        z172 = h2z * k57 + (s24 - (z134 * z168 + w3_steer * z171))
        z173 = z172 - (k50 * z141 - (k47 * z143 + k49 * z145))
        s25 = z166 + (k25 * z119 + (k15 * z121 + k16 * z156)) - k9 * z160
        z174 = s25 - c_steer * z170 + s_steer * z173
        z175 = z174 - z162
        z176 = z33 * z175
        z177 = z12 * z163 - z5 * z176
        z178 = R_yy * z56 - k25 * z55
        s26 = k23 * z124 + (k15 * z126 + k22 * z132)
        z179 = e2z * k40 + (s26 + (z55 * z165 - z99 * z178))
        s27 = z179 - (k23 * z140 + (k15 * z108 - k22 * z144))
        z180 = s1 * (s27 + s_steer * z170 + c_steer * z173)
        s28 = k53 * z124 + (k34 * z131 - k50 * z133)
        z181 = h2z * k58 + (s28 + (z136 * z171 + z134 * z167))
        s29 = k26 * z124 - (k16 * z126 - k23 * z132)
        z182 = e2z * k39 - (s29 - (z102 * z178 + z55 * z164))
        z183 = c_steer * z146 + s_steer * z152
        s30 = z182 + (k26 * z140 - (k16 * z108 + k23 * z144)) + k9 * z183
        z184 = z181 - (k53 * z141 + (k34 * z143 - k50 * z145)) - s30
        z185 = z33 * (c_roll * (z180 + c1 * z184) - e2z * z175)
        z186 = z40 * z163 - z5 * z185
        z187 = z40 * z176 - z12 * z185
        z188 = z24 * z177 - z23 * z186 - z25 * z187
        z189 = z30 * z177 + z29 * z186 + z15 * z187
        z190 = c_steer * z188 + s_steer * z189
        z191 = z153 - z190
        z192 = z32 * z163 + z31 * z176
        z193 = z161 + z192
        z194 = s1 * z191 + c1 * z193
        s31 = k16 * z124 - (k14 * z126 + k15 * z132)
        z195 = e2z * k38 - (s31 - (z99 * z155 - z102 * z101))
        z196 = s_steer * z188 - c_steer * z189
        s32 = z195 + (k16 * z140 - (k14 * z108 - k15 * z144)) + z183
        z197 = s32 + z196
        z198 = e2z * z194 - c_roll * z197
        c_yaw = math.cos(yaw)
        z199 = c1 * z191 - s1 * z193
        z200 = s1 * z190 - c1 * z192
        z201 = e2z * z200 + c_roll * z196
        z202 = c1 * z190 + s1 * z192
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            c_yaw * z199 - s_yaw * z198,
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            c_yaw * z198 + s_yaw * z199,
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            -(c_roll * z194 + e2z * z197),
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            c_yaw * z202 - s_yaw * z201,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            c_yaw * z201 + s_yaw * z202,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            e2z * z196 - c_roll * z200,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V [J].

    Arguments: t (scalar), y (12,), p (26,).
    Returns a scalar.
    """
    z = float(y[2])  # centre of the rear wheel, downwards [m]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    g = float(p[3])  # acceleration of gravity [m/s^2]
    r_R = float(p[4])  # radius of the rear wheel [m]
    m_R = float(p[5])  # mass of the rear wheel [kg]
    R_xx = float(p[6])  # rear wheel, across the axle [kg*m^2]
    R_yy = float(p[7])  # rear wheel, about the axle [kg*m^2]
    x_B = float(p[8])  # rear frame and rider, ahead of the rear contact [m]
    z_B = float(p[9])  # [m]
    m_B = float(p[10])  # [kg]
    B_xx = float(p[11])  # [kg*m^2]
    B_xz = float(p[12])  # [kg*m^2]
    B_yy = float(p[13])  # [kg*m^2]
    B_zz = float(p[14])  # [kg*m^2]
    x_H = float(p[15])  # front frame, ahead of the rear contact [m]
    z_H = float(p[16])  # [m]
    m_H = float(p[17])  # [kg]
    H_xx = float(p[18])  # [kg*m^2]
    H_xz = float(p[19])  # [kg*m^2]
    H_yy = float(p[20])  # [kg*m^2]
    H_zz = float(p[21])  # [kg*m^2]
    r_F = float(p[22])  # radius of the front wheel [m]
    m_F = float(p[23])  # mass of the front wheel [kg]
    F_xx = float(p[24])  # front wheel, across the axle [kg*m^2]
    F_yy = float(p[25])  # front wheel, about the axle [kg*m^2]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = r_R + z_B
        k2 = w + c
        k3 = r_F * s_lam - c * c_lam
        k4 = x_H - k2
        k5 = r_R * s_lam - c_lam * k2
        k6 = z_H * s_lam - c_lam * k4
        k7 = r_R * c_lam + s_lam * k2
        k8 = c_lam * k1 + x_B * s_lam
        k9 = s_lam * k1 - x_B * c_lam
        k10 = abs(r_R)
        k11 = abs(r_F)
        k12 = abs(w)
        k13 = abs(c)
        k14 = 9.0 * k11
        k15 = 6.0 * k13 + (2.0 * k12 + (5.0 * k10 + k14))
        k16 = 6.0 * k12
        k17 = k7 + (z_H * c_lam + s_lam * k4)
        k18 = r_F * c_lam + c * s_lam - k7
        k19 = 14.0 * k11 + 13.0 * k13
        k20 = k14 + 10.0 * k13
        # from the state
        c_roll = math.cos(roll)
        c_pitch = math.cos(pitch)
        s_pitch = math.sin(pitch)
        z1 = c_pitch * s_lam + s_pitch * c_lam
        z2 = c_roll * z1
        z3 = 1.0 / abs(c_roll)
        z4 = r_R * z3
        z5 = z2 * z4
        c_steer = math.cos(steer)
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z6 = e2z * s_steer - c_steer * z2
        z7 = c_pitch * c_lam - s_pitch * s_lam
        z8 = c_roll * z7
        z9 = r_F / math.sqrt(z8 * z8 + z6 * z6)
        z10 = z6 * z9
        z11 = k3 + z10
        z12 = k5 - z5 - c_steer * z11
        z13 = z8 * z4
        z14 = c_steer * z13
        z15 = z8 * z9
        z16 = k18 - z15
        z17 = z1 * z16
        z18 = z13 + z16
        z19 = s_steer * z18
        s1 = c_roll * (c_steer * z17 + z7 * (c_steer * k5 - z11))
        z20 = s1 - e2z * z19
        z21 = c_steer * z18
        z22 = c_roll * (s_steer * z17 + k5 * (s_steer * z7)) + e2z * z21
        z23 = s_steer * z13
        z24 = z14 * z20 + z22 * z23
        z25 = z21 * z20 + z22 * z19
        z26 = z12 * z24 + z5 * z25
        z27 = k16 + k10 * (9.0 + abs(z3))
        s2 = (z27 + k19) * (z27 + k20)
        # the coframe is singular, if -z26 is nearly 0
        if not abs(-z26) > 1e-12 * (k15 * s2):
            raise _refuse(abs(-z26), 1e-12 * (k15 * s2), 1, "energy")
        z28 = s_pitch * c_roll
        e3z = c_pitch * c_roll
        Sz = z - z28 * k2 + r_R * e3z
        z29 = c_lam * z6 + s_lam * z8
        z30 = c_lam * z8 - s_lam * z6
        s3 = z * m_R + m_B * (z - x_B * z28 + e3z * k1)
        z31 = s3 + m_H * (z_H * z30 + (Sz + k4 * z29))
        z32 = z11 * (s_steer * z2) - e2z * z12
        z33 = roll_dot * z1
        z34 = steer_dot + z33
        z35 = roll_dot * z7
        z36 = c_steer * z35
        v2_x = c_roll * (roll_dot * z4)
        z37 = v2_x - k5 * z33
        z38 = z34 * z10 - z36 * z15 + (k3 * z34 + k18 * z36 + c_steer * z37)
        z39 = s_steer * z35
        z40 = thF_dot - z39
        z41 = z40 * z15 + (k18 * z39 + s_steer * z37)
        z42 = z14 * z38 + z23 * z41
        z43 = k3 * z39 - z40 * z10
        z44 = z20 * z41 - z22 * z38
        z45 = 1.0 / z26
        z46 = z21 * z38 + z19 * z41
        z47 = z45 * (z12 * z42 + z5 * z46)
        w2 = (z32 * z42 - z24 * z43 + z5 * z44) * z45 + e2z * z47
        z48 = c_roll * z47
        z49 = z35 - z1 * z48
        z50 = c_steer * w2 - s_steer * z49
        z51 = thF_dot + z50
        z52 = (z32 * z46 - z12 * z44 - z25 * z43) * z45 - w2
        z53 = z13 * z52
        z54 = z33 + z7 * z48
        z55 = v2_x - k5 * z54
        z56 = c_steer * z53 + s_steer * z55
        z57 = z56 - k18 * z50
        z58 = c_steer * z55 - s_steer * z53
        w3_steer = steer_dot + z54
        z59 = s_steer * w2 + c_steer * z49
        z60 = z58 + (k3 * w3_steer + k18 * z59)
        z61 = z5 * z52
        z62 = z61 + k5 * w2
        z63 = z62 - k3 * z50
        z64 = c_lam * z59 + s_lam * w3_steer
        z65 = z64 * z64
        z66 = c_lam * w3_steer - s_lam * z59
        z67 = z66 * z66
        s4 = m_F * (z57 * z57 + z60 * z60 + z63 * z63)
        z68 = F_yy * (z51 * z51) + (s4 + F_xx * (z65 + z67))
        z69 = z56 + k17 * z50
        z70 = z58 - (k6 * w3_steer + k17 * z59)
        z71 = z62 + k6 * z50
        s5 = H_xx * z65 + H_yy * (z50 * z50) + H_zz * z67
        z72 = m_H * (z69 * z69 + z70 * z70 + z71 * z71) + s5
        z73 = c_lam * z49 + s_lam * z54
        z74 = z73 * z73
        z75 = c_lam * z54 - s_lam * z49
        z76 = z75 * z75
        s6 = m_R * (v2_x * v2_x + z53 * z53 + z61 * z61)
        z77 = R_yy * (z52 * z52) + (s6 + R_xx * (z74 + z76))
        z78 = z53 + k8 * w2
        z79 = v2_x - (k9 * z54 + k8 * z49)
        z80 = z61 + k9 * w2
        s7 = B_yy * (w2 * w2) + B_xx * z74 + B_zz * z76
        z81 = m_B * (z78 * z78 + z79 * z79 + z80 * z80) + s7
        s8 = 0.5 * z77 + (0.5 * z81 + B_xz * (z73 * z75))
        z82 = 0.5 * z72 + H_xz * (z64 * z66) + s8
        s9 = g * (m_F * (Sz - c * z29 - r_F * z30) + z31)
        value1 = 0.5 * z68 + z82 - s9
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (I.2.15).

    Arguments: t (scalar), y (12,), p (26,).
    Returns rows (12, 12): d rhs_i / d y_j stands at [i][j].
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    g = float(p[3])  # acceleration of gravity [m/s^2]
    r_R = float(p[4])  # radius of the rear wheel [m]
    m_R = float(p[5])  # mass of the rear wheel [kg]
    R_xx = float(p[6])  # rear wheel, across the axle [kg*m^2]
    R_yy = float(p[7])  # rear wheel, about the axle [kg*m^2]
    x_B = float(p[8])  # rear frame and rider, ahead of the rear contact [m]
    z_B = float(p[9])  # [m]
    m_B = float(p[10])  # [kg]
    B_xx = float(p[11])  # [kg*m^2]
    B_xz = float(p[12])  # [kg*m^2]
    B_yy = float(p[13])  # [kg*m^2]
    B_zz = float(p[14])  # [kg*m^2]
    x_H = float(p[15])  # front frame, ahead of the rear contact [m]
    z_H = float(p[16])  # [m]
    m_H = float(p[17])  # [kg]
    H_xx = float(p[18])  # [kg*m^2]
    H_xz = float(p[19])  # [kg*m^2]
    H_yy = float(p[20])  # [kg*m^2]
    H_zz = float(p[21])  # [kg*m^2]
    r_F = float(p[22])  # radius of the front wheel [m]
    m_F = float(p[23])  # mass of the front wheel [kg]
    F_xx = float(p[24])  # front wheel, across the axle [kg*m^2]
    F_yy = float(p[25])  # front wheel, about the axle [kg*m^2]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = r_R + z_B
        k2 = w + c
        k3 = c + (w - x_H)
        k4 = r_F * s_lam - c * c_lam
        k5 = H_zz + F_xx
        k6 = H_xx + F_xx
        k7 = R_xx + B_xx
        k8 = R_xx + B_zz
        k9 = z_H * s_lam + c_lam * k3
        k10 = r_R * s_lam - c_lam * k2
        k11 = r_R * c_lam
        k12 = s_lam * k2
        k13 = c_lam * k1 + x_B * s_lam
        k14 = s_lam * k1 - x_B * c_lam
        k15 = k12 + (z_H * c_lam - s_lam * k3 + k11)
        k16 = k12 - (r_F * c_lam + c * s_lam - k11)
        k17 = abs(r_R)
        k18 = abs(r_F)
        k19 = abs(w)
        k20 = abs(c)
        k21 = 9.0 * k18
        k22 = 6.0 * k20 + (2.0 * k19 + (5.0 * k17 + k21))
        k23 = 6.0 * k19
        k24 = 13.0 * k20 + (14.0 * k18 + k23)
        k25 = 10.0 * k20 + (k21 + k23)
        k26 = m_R + m_B
        k27 = m_B * k13
        k28 = m_B * k14
        k29 = B_xz * c_lam
        k30 = s_lam * k8 - k29
        k31 = B_xz * s_lam
        k32 = c_lam * k7 - k31
        k33 = k13 * k27
        k34 = s_lam * k30 + c_lam * k32 + k33
        k35 = c_lam * k30 - s_lam * k32 - k14 * k27
        k36 = k14 * k28
        k37 = k33 + (B_yy + k36)
        s2 = c_lam * (k31 + c_lam * k8) + s_lam * (k29 + s_lam * k7)
        k38 = k36 + s2
        k39 = m_F * k16
        k40 = m_H + m_F
        k41 = m_H * k15
        k42 = k39 + k41
        k43 = m_F * k4
        k44 = m_H * k9
        k45 = k43 - k44
        k46 = H_xz * c_lam
        k47 = s_lam * k5 - k46
        k48 = H_xz * s_lam
        k49 = c_lam * k6 - k48
        k50 = k16 * k39
        k51 = k15 * k41
        k52 = s_lam * k47 + c_lam * k49 + k50 + k51
        k53 = c_lam * k47 - s_lam * k49 + k4 * k39 - k9 * k41
        k54 = k4 * k43
        k55 = k9 * k44
        k56 = k51 + (k50 + (H_yy + k54) + k55)
        s3 = c_lam * (k48 + c_lam * k5) + s_lam * (k46 + s_lam * k6)
        k57 = k55 + (k54 + s3)
        k58 = g * m_F
        k59 = g * m_H
        k60 = g * m_B
        k61 = g * k26
        k62 = k14 * k60
        k63 = k13 * k60
        k64 = k9 * k59
        k65 = k15 * k59
        k66 = g * k40
        k67 = k4 * k58
        k68 = k16 * k58
        k69 = k65 + k68
        k70 = k64 - k67
        # from the state
        c_roll = math.cos(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        s_steer = math.sin(steer)
        c1 = math.cos(z1)
        z2 = c_roll * c1
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        z3 = c_roll * s1
        z4 = e2z * s_steer - c_steer * z3
        z5 = 1.0 / math.sqrt(z2 * z2 + z4 * z4)
        z6 = r_F * z4
        z7 = z5 * z6
        z8 = k4 + z7
        z9 = s_steer * z8
        z10 = s1 * z9
        z11 = 1.0 / abs(c_roll)
        z12 = r_R * z3
        z13 = z11 * z12
        z14 = k10 - z13 - c_steer * z8
        z15 = c_roll * z10 - e2z * z14
        z16 = r_R * z2
        z17 = z11 * z16
        z18 = c_steer * z17
        z19 = r_F * z2
        z20 = z5 * z19
        z21 = k16 + z20
        z22 = z17 - z21
        z23 = s_steer * z22
        z24 = c_steer * z22
        z25 = s_steer * z17
        z26 = z18 * z23 - z24 * z25
        z27 = c_steer * z21
        z28 = c_steer * k10 - z8
        z29 = s1 * z27 - c1 * z28
        z30 = c_roll * z29 + e2z * z23
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 - c1 * z32
        z34 = c_roll * z33 - e2z * z24
        z35 = z18 * z30 + z34 * z25
        z36 = z24 * z30 + z34 * z23
        z37 = z15 * z26 + z14 * z35 + z13 * z36
        z38 = k17 * (9.0 + abs(z11))
        s4 = k22 * (z38 + k24)
        s5 = (z38 + k25) * s4
        # the coframe is singular, if z37 is nearly 0
        if not abs(z37) > 1e-12 * s5:
            raise _refuse(abs(z37), 1e-12 * s5, 1, "jacobian")
        z39 = 1.0 / z37
        z40 = s_steer * c1
        z41 = z8 * z40
        z42 = c_steer * c1
        z43 = r_R * c_roll
        z44 = z11 * z43
        z45 = k10 * s1 - z44
        z46 = s1 * z7 - z20 * z42 - (k16 * z42 - k4 * s1 + c_steer * z45)
        z47 = z20 * z40 + (k16 * z40 + s_steer * z45)
        z48 = z18 * z46 - z25 * z47
        z49 = z24 * z46 - z23 * z47
        z50 = z26 * z41 - z14 * z48 - z13 * z49
        z51 = z39 * z50
        z52 = c_roll * z51
        z53 = s1 + c1 * z52
        z54 = z44 - k10 * z53
        z55 = z30 * z47 + z34 * z46
        z56 = z15 * z49 - z14 * z55 + z36 * z41
        z57 = z39 * z56
        z58 = z15 * z48 + z35 * z41 + z13 * z55
        z59 = z39 * z58
        z60 = z59 - e2z * z51
        z61 = z57 - z60
        z62 = z17 * z61
        z63 = c_steer * z54 + s_steer * z62
        z64 = c1 - s1 * z52
        z65 = s_steer * z60 - c_steer * z64
        z66 = k57 * z53 + (k45 * z63 + k53 * z65)
        z67 = c_steer * z60 + s_steer * z64
        z68 = c_steer * z62 - s_steer * z54
        z69 = z13 * z61
        z70 = z69 + k10 * z60
        z71 = k56 * z67 + (k42 * z68 - k45 * z70)
        z72 = k53 * z53 + (k42 * z63 + k52 * z65)
        z73 = k40 * z70 - k45 * z67
        z74 = k45 * z53 + (k40 * z63 + k42 * z65)
        z75 = k40 * z68 + k42 * z67
        z76 = k38 * z53 - (z44 * k28 + k35 * z64)
        z77 = z60 * k37 + (z62 * k27 + z69 * k28)
        z78 = k35 * z53 + (z44 * k27 - k34 * z64)
        z79 = z69 * k26 + z60 * k28
        z80 = z62 * k26 + z60 * k27
        z81 = k28 * z53 - (z44 * k26 - k27 * z64)
        s6 = z64 * z78 - (z69 * z79 + (z62 * z80 - z44 * z81))
        z82 = z53 * z76 + (z60 * z77 - s6)
        s7 = z65 * z72 + (z70 * z73 + (z63 * z74 + (z68 * z75 + z82)))
        z83 = z53 * z66 + (z67 * z71 + s7)
        z84 = z83 + R_yy * (z61 * z61) + F_yy * (z67 * z67)
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z84 is 0
        if not abs(z84) > 0.0:
            raise _refuse(abs(z84), 0.0, 2, "jacobian")
        z85 = z18 * z8
        z86 = z24 * z8
        z87 = z14 * z85 + z13 * z86
        z88 = z39 * z87
        z89 = c_roll * z88
        z90 = c1 * z89
        z91 = 1.0 - z90
        z92 = k10 * z90
        z93 = z34 * z8
        z94 = z15 * z86 - z14 * z93
        z95 = z39 * z94
        z96 = z15 * z85 + z13 * z93
        z97 = z39 * z96
        z98 = z97 + e2z * z88
        z99 = z95 - z98
        z100 = z17 * z99
        z101 = c_steer * z92 + s_steer * z100
        z102 = s1 * z89
        z103 = s_steer * z98 - c_steer * z102
        z104 = k57 * z91 + (k45 * z101 + k53 * z103)
        z105 = c_steer * z98 + s_steer * z102
        z106 = c_steer * z100 - s_steer * z92
        z107 = z13 * z99
        z108 = z107 + k10 * z98
        z109 = k56 * z105 + (k42 * z106 - k45 * z108)
        z110 = k53 * z91 + (k42 * z101 + k52 * z103)
        z111 = k40 * z108 - k45 * z105
        z112 = k45 * z91 + (k40 * z101 + k42 * z103)
        z113 = k40 * z106 + k42 * z105
        z114 = k35 * z102 + k38 * z90
        z115 = z98 * k37 + (z100 * k27 + z107 * k28)
        z116 = k34 * z102 + k35 * z90
        z117 = z100 * k26 + z98 * k27
        z118 = z107 * k26 + z98 * k28
        s8 = z98 * z115 + (z102 * z116 + (z100 * z117 + z107 * z118))
        z119 = z106 * z113 + (z90 * z114 + s8)
        s9 = z103 * z110 + (z108 * z111 + (z101 * z112 + z119))
        z120 = z91 * z104 + (z105 * z109 + s9) + R_yy * (z99 * z99)
        z121 = z120 + F_yy * (z105 * z105)
        s10 = z98 * z77 - (z102 * z78 - (z100 * z80 + z107 * z79))
        z122 = z106 * z75 - (z90 * z76 - s10)
        s11 = z105 * z71 + (z103 * z72 + (z108 * z73 + (z101 * z74 + z122)))
        z123 = z91 * z66 + s11 + R_yy * (z61 * z99)
        z124 = z123 + F_yy * (z67 * z105)
        z125 = 1.0 / z84
        z126 = z124 * z125
        z127 = z121 - z124 * z126
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z127 is nearly 0
        if not abs(z127) > 1e-13 * z121:
            raise _refuse(abs(z127), 1e-13 * z121, 2, "jacobian")
        z128 = z20 * z25
        z129 = z20 * z23
        z130 = z7 * z26 + z14 * z128 + z13 * z129
        z131 = z39 * z130
        z132 = c_roll * z131
        z133 = c1 * z132
        z134 = k10 * z133
        z135 = z20 * z30
        z136 = z15 * z129 + z14 * z135 - z7 * z36
        z137 = z39 * z136
        z138 = z15 * z128 - z7 * z35 - z13 * z135
        z139 = z39 * z138
        z140 = z139 + e2z * z131
        z141 = z137 - z140
        z142 = z17 * z141
        z143 = c_steer * z134 + s_steer * z142
        z144 = s1 * z132
        z145 = s_steer * z140 - c_steer * z144
        z146 = k57 * z133 - (k45 * z143 + k53 * z145)
        z147 = c_steer * z140 + s_steer * z144
        z148 = c_steer * z142 - s_steer * z134
        z149 = z13 * z141
        z150 = z149 + k10 * z140
        z151 = k56 * z147 + (k42 * z148 - k45 * z150)
        z152 = k53 * z133 - (k42 * z143 + k52 * z145)
        z153 = k40 * z150 - k45 * z147
        z154 = k45 * z133 - (k40 * z143 + k42 * z145)
        z155 = k40 * z148 + k42 * z147
        z156 = k35 * z144 + k38 * z133
        z157 = z140 * k37 + (z142 * k27 + z149 * k28)
        z158 = k34 * z144 + k35 * z133
        z159 = z142 * k26 + z140 * k27
        z160 = z149 * k26 + z140 * k28
        s12 = z140 * z157 + (z144 * z158 + (z142 * z159 + z149 * z160))
        z161 = z148 * z155 + (z133 * z156 + s12)
        s13 = z145 * z152 - (z150 * z153 - (z143 * z154 - z161))
        z162 = z133 * z146 + (z147 * z151 - s13) + R_yy * (z141 * z141)
        z163 = 1.0 - z147
        z164 = z162 + F_yy * (z163 * z163)
        s14 = z140 * z77 - (z144 * z78 - (z142 * z80 + z149 * z79))
        z165 = z148 * z75 - (z133 * z76 - s14)
        s15 = z147 * z71 + (z145 * z72 + (z150 * z73 + (z143 * z74 + z165)))
        z166 = z133 * z66 - s15 - R_yy * (z61 * z141)
        z167 = z166 + F_yy * (z67 * z163)
        z168 = z167 * z125
        s16 = z140 * z115 + (z144 * z116 + (z142 * z117 + z149 * z118))
        z169 = z148 * z113 + (z133 * z114 + s16)
        s17 = z145 * z110 + (z150 * z111 + (z143 * z112 + z169))
        z170 = z133 * z104 - (z147 * z109 + s17) - R_yy * (z99 * z141)
        z171 = z170 + F_yy * (z105 * z163) - z124 * z168
        z172 = 1.0 / z127
        z173 = z171 * z172
        z174 = z164 - z167 * z168 - z171 * z173
        # the mass matrix is singular, or the velocities that are kept do not suffice,
        # if z174 is nearly 0
        if not abs(z174) > 1e-13 * z164:
            raise _refuse(abs(z174), 1e-13 * z164, 2, "jacobian")
        s_yaw = math.sin(yaw)
        z175 = s1 * z62 - c1 * z69
        z176 = e2z * z175 - c_roll * z44
        c_yaw = math.cos(yaw)
        z177 = s1 * z69 + c1 * z62
        z178 = s1 * z100 - c1 * z107
        z179 = e2z * z178
        z180 = s1 * z107 + c1 * z100
        z181 = s1 * z142 - c1 * z149
        z182 = e2z * z181
        z183 = s1 * z149 + c1 * z142
        z184 = z11 * z11
        z185 = roll_dot * r_R
        z186 = c_roll * z185
        z187 = z5 * z5
        v2_x = z11 * z186
        z188 = z39 * z39
        z189 = roll_dot * c1
        z190 = s_steer * z189
        z191 = thF_dot - z190
        z192 = roll_dot * s1
        z193 = steer_dot + z192
        z194 = c_steer * z189
        z195 = v2_x - k10 * z192
        z196 = k4 * z190 - z7 * z191
        s18 = k16 * z194 - k4 * z193 - c_steer * z195
        z197 = z7 * z193 - z20 * z194 - s18
        z198 = z20 * z191 - (k16 * z190 - s_steer * z195)
        z199 = z18 * z197 + z25 * z198
        z200 = z24 * z197 + z23 * z198
        z201 = z26 * z196 - z14 * z199 - z13 * z200
        z202 = z30 * z198 - z34 * z197
        z203 = z15 * z199 + z35 * z196 - z13 * z202
        z204 = z15 * z200 + z14 * z202 + z36 * z196
        z205 = z39 * z201
        z206 = z39 * z204
        z207 = z39 * z203
        z208 = z207 - e2z * z205
        z209 = z206 - z208
        z210 = z17 * z209
        z211 = z13 * z209
        z212 = s1 * z210 - c1 * z211
        z213 = s1 * z211 + c1 * z210
        z214 = c_roll * v2_x - e2z * z212
        z272 = 1.0 / z174
        z273 = steer_dot * s_steer
        z274 = roll_dot * e2z
        z275 = s1 * z207
        z276 = z274 * c1 - c_roll * z275
        z277 = roll_dot * c_roll
        z278 = steer_dot * c_steer
        z279 = c1 * z207
        z280 = z274 * s1 + c_roll * z279
        z281 = s_steer * z277 + e2z * z278 + (z273 * z3 + c_steer * z280)
        z282 = z2 * z276 - z4 * z281
        z283 = z5 * z282
        z284 = z187 * z283
        z285 = r_F * z281
        z286 = z6 * z284 + z5 * z285
        z287 = roll_dot * z279
        z288 = r_F * z276
        z289 = z19 * z284 - z5 * z288
        z290 = roll_dot * z275
        z291 = z273 * z189 - c_steer * z290
        z292 = c_roll * z274
        z293 = z11 * z292
        z294 = z293 * z184
        z295 = z274 * z185
        z296 = z186 * z294 - z11 * z295 + k10 * z287
        s19 = k16 * z291 - k4 * z287 - (z273 * z195 - c_steer * z296)
        z297 = z193 * z286 - z7 * z287 - (z194 * z289 - z20 * z291) + s19
        z298 = r_R * z276
        z299 = z16 * z294 - z11 * z298
        z300 = z278 * z17 + s_steer * z299
        z301 = z273 * z21 - c_steer * z289
        z302 = z273 * k10 + z286
        z303 = z27 * z279 + s1 * z301 + (z28 * z275 - c1 * z302)
        z304 = z299 - z289
        z305 = z278 * z22 + s_steer * z304
        z306 = z274 * z29 + c_roll * z303 - (z277 * z23 + e2z * z305)
        z307 = z297 + (z206 * z300 - (z205 * z306 + z207 * z305))
        z308 = z278 * z189 + s_steer * z290
        z309 = z273 * z17 - c_steer * z299
        z310 = z278 * z21 + s_steer * z289
        z311 = z278 * k10
        z312 = z31 * z279 - s1 * z310 + (c1 * z311 + z32 * z275)
        z313 = z273 * z22 - c_steer * z304
        z314 = z274 * z33 + c_roll * z312 + (z277 * z24 - e2z * z313)
        s20 = k16 * z308 - (z278 * z195 + s_steer * z296)
        s21 = z206 * z309 - (z205 * z314 + z207 * z313)
        z315 = z191 * z289 - z20 * z308 - s20 + s21
        z316 = z18 * z307 + z25 * z315
        z317 = r_R * z280
        z318 = z12 * z294 - z11 * z317
        z319 = z278 * z8 + s_steer * z286
        z320 = z9 * z279 - s1 * z319
        z321 = z318 - (z273 * z8 - c_steer * z286)
        z322 = z274 * z10 + c_roll * z320 + (z277 * z14 - e2z * z321)
        s22 = z206 * z318 - (z205 * z322 + z207 * z321)
        z323 = k4 * z308 - (z191 * z286 - z7 * z308) - s22
        z324 = z30 * z315 - z34 * z307
        z325 = z15 * z316 + z35 * z323 - z13 * z324
        z326 = z24 * z307 + z23 * z315
        z327 = z26 * z323 - z14 * z316 - z13 * z326
        z328 = z39 * z327
        z329 = z39 * z325 - (z277 * z205 + e2z * z328)
        z330 = c_roll * z205
        z331 = z189 - s1 * z330
        z332 = z274 * z205 - c_roll * z328
        z333 = z290 + (z330 * z279 + s1 * z332)
        z334 = z273 * z208 - c_steer * z329 - (z278 * z331 + s_steer * z333)
        z335 = z15 * z326 + z14 * z324 + z36 * z323
        z336 = z39 * z335 - z329
        v2_x_2 = roll_dot * z44
        z337 = z192 + c1 * z330
        z338 = z209 * z299 + z17 * z336 - (z208 * z211 - v2_x_2 * z337)
        z339 = k10 * z208
        z340 = k10 * z337
        z341 = z338 - (z208 * z339 + z337 * z340)
        z342 = r_R * z274
        z343 = z43 * z294 - z11 * z342
        z344 = roll_dot * z343 - (z210 * z337 - z211 * z331)
        z345 = z287 - (z330 * z275 - c1 * z332)
        z346 = z344 + (k10 * z345 + z339 * z331)
        z347 = c_steer * z341 - s_steer * z346
        z348 = z209 * z318 + z13 * z336 - (v2_x_2 * z331 - z208 * z210)
        z349 = z348 + (k10 * z329 + z331 * z340)
        w3_steer = steer_dot + z337
        z350 = s_steer * z208 - c_steer * z331
        z351 = k52 * z350 + k53 * w3_steer
        z352 = k53 * z350 + k57 * w3_steer
        s23 = k56 * z334 - (k42 * z347 - k45 * z349)
        s24 = z4 * k65 + z2 * k64 + (z4 * k68 - z2 * k67)
        z353 = s24 - (s23 - (w3_steer * z351 - z350 * z352))
        h2z = e2z * c_steer + s_steer * z3
        z354 = c_steer * z346 + s_steer * z341
        z355 = z278 * z208 + s_steer * z329 + (z273 * z331 - c_steer * z333)
        z356 = c_steer * z208 + s_steer * z331
        z357 = F_yy * (thF_dot - z356) - k56 * z356
        s25 = k53 * z345 - (k42 * z354 + k52 * z355)
        z358 = h2z * k69 + (s25 - (z356 * z352 + w3_steer * z357))
        z359 = k42 * z350 + k45 * w3_steer
        z360 = k42 * z356
        s26 = k40 * z349 + k45 * z334 + (z350 * z359 + z356 * z360)
        z361 = z2 * k66 + s26
        z362 = k45 * z356
        s27 = k45 * z345 - (k40 * z354 + k42 * z355)
        z363 = h2z * k66 + (s27 + (w3_steer * z360 - z350 * z362))
        s28 = k40 * z347 - k42 * z334 + (z356 * z362 + w3_steer * z359)
        z364 = z4 * k66 + s28
        z365 = R_yy * z209 - k37 * z208
        z366 = k34 * z331 - k35 * z337
        s29 = k38 * z345 + (k28 * z344 + k35 * z333)
        z367 = e2z * k62 - (s29 - (z331 * z365 + z208 * z366))
        s30 = k57 * z345 - (k45 * z354 + k53 * z355)
        z368 = h2z * k70 - (s30 + (z350 * z357 + z356 * z351))
        z369 = z367 + z368
        z370 = k35 * z331 - k38 * z337
        s31 = k37 * z329 + (k27 * z338 + k28 * z348)
        z371 = z3 * k63 - z2 * k62 - (s31 - (z337 * z366 + z331 * z370))
        s32 = k35 * z345 - (k27 * z344 - k34 * z333)
        z372 = e2z * k63 + (s32 + (z208 * z370 - z337 * z365))
        z373 = k27 * z331 + k28 * z337
        z374 = k27 * z208
        s33 = k26 * z348 + k28 * z329 + (z331 * z373 + z208 * z374)
        z375 = z2 * k61 + s33
        z376 = k28 * z208
        s34 = k26 * z338 + k27 * z329 - (z208 * z376 + z337 * z373)
        z377 = z3 * k61 - s34
        s35 = k28 * z345 + (k26 * z344 - k27 * z333)
        z378 = e2z * k61 - (s35 - (z337 * z374 - z331 * z376))
        z379 = z184 * (1.0 / c_roll)
        z380 = z187 * z187
        s36 = z140 * z371 - (z144 * z372 - (z142 * z377 - z149 * z375))
        z381 = z148 * z364 - (z133 * z367 + s36)
        s37 = z145 * z358 - (z150 * z361 - (z143 * z363 - z381))
        z382 = z133 * z368 - (z147 * z353 - s37) - R_yy * (z141 * z336)
        s38 = z64 * z372 + (z69 * z375 - (z62 * z377 + z44 * z378))
        z383 = z53 * z367 - (z60 * z371 - s38)
        s39 = z65 * z358 - (z70 * z361 - (z63 * z363 - (z68 * z364 + z383)))
        z384 = z53 * z368 + (z67 * z353 - s39)
        z385 = z384 + R_yy * (z61 * z336) - F_yy * (z67 * z334)
        s40 = z98 * z371 - (z102 * z372 - (z100 * z377 - z107 * z375))
        z386 = z106 * z364 - (z90 * z367 + s40)
        s41 = z103 * z358 - (z108 * z361 - (z101 * z363 - z386))
        z387 = z91 * z368 + (z105 * z353 - s41) + R_yy * (z99 * z336)
        z388 = z387 - F_yy * (z105 * z334) - z385 * z126
        s42 = z382 - F_yy * (z163 * z334) - z385 * z168 - z173 * z388
        z389 = z272 * s42
        z390 = z172 * z388 - z173 * z389
        z391 = z385 * z125 - z126 * z390 - z168 * z389
        J: list[float] = [
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
            s_yaw * z176 - c_yaw * z177,
            # (I.2.15)
            s_yaw * z179 - c_yaw * z180,
            # (I.2.15)
            s_yaw * z182 - c_yaw * z183,
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
            -(s_yaw * z177 + c_yaw * z176),
            # (I.2.15)
            -(s_yaw * z180 + c_yaw * z179),
            # (I.2.15)
            -(s_yaw * z183 + c_yaw * z182),
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
            e2z * z44 + c_roll * z175,
            # (I.2.15)
            c_roll * z178,
            # (I.2.15)
            c_roll * z181,
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
            z51,
            # (I.2.15)
            -z88,
            # (I.2.15)
            -z131,
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
            0.0,
            # (I.2.15)
            -z59,
            # (I.2.15)
            -z97,
            # (I.2.15)
            -z139,
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
            z57,
            # (I.2.15)
            z95,
            # (I.2.15)
            z137,
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
        # one coordinate in each pass: a column of the velocities' rows
        offsets1 = (3, 4, 5, 6)
        for k71, offset1 in enumerate(offsets1):
            turn_3 = 1.0 if k71 == 0 else 0.0
            turn_4 = 1.0 if k71 == 1 else 0.0
            turn_5 = 1.0 if k71 == 2 else 0.0
            turn_6 = 1.0 if k71 == 3 else 0.0
            z215 = s_yaw * turn_3
            z216 = c1 * turn_5
            z217 = e2z * turn_4
            z218 = z184 * (z11 * (c_roll * z217))
            z219 = s1 * z217 - c_roll * z216
            z220 = z12 * z218 - z11 * (r_R * z219)
            z221 = c_steer * turn_6
            z222 = s1 * turn_5
            z223 = c1 * z217 + c_roll * z222
            z224 = c_roll * turn_4
            z225 = s_steer * turn_6
            z226 = s_steer * z224 + e2z * z221 + (z3 * z225 + c_steer * z219)
            z227 = z187 * (z5 * (z2 * z223 - z4 * z226))
            z228 = z6 * z227 + z5 * (r_F * z226)
            z229 = z220 - (z8 * z225 - c_steer * z228)
            s43 = c_roll * (z9 * z216 + s1 * (z8 * z221 + s_steer * z228))
            z230 = z10 * z217 - s43 + (z14 * z224 - e2z * z229)
            z231 = z16 * z218 - z11 * (r_R * z223)
            z232 = z17 * z225 - c_steer * z231
            z233 = z19 * z227 - z5 * (r_F * z223)
            z234 = z231 - z233
            z235 = z22 * z221 + s_steer * z234
            z236 = z22 * z225 - c_steer * z234
            z237 = z17 * z221 + s_steer * z231
            z238 = z23 * z232 - z18 * z235 - (z25 * z236 - z24 * z237)
            s44 = z27 * z216 - s1 * (z21 * z225 - c_steer * z233)
            z239 = s44 + (z28 * z222 + c1 * (z228 + k10 * z225))
            z240 = z29 * z217 - c_roll * z239 - (z23 * z224 + e2z * z235)
            s45 = z31 * z216 + s1 * (z21 * z221 + s_steer * z233)
            z241 = s45 + (z32 * z222 - c1 * (k10 * z221))
            z242 = z33 * z217 - c_roll * z241 + (z24 * z224 - e2z * z236)
            z243 = z30 * z232 + z18 * z240 + (z25 * z242 - z34 * z237)
            z244 = z30 * z236 + z24 * z240 + (z23 * z242 - z34 * z235)
            s46 = z26 * z230 + z15 * z238 + (z35 * z229 + z14 * z243)
            z245 = s46 - (z36 * z220 - z13 * z244)
            z246 = z188 * z245
            z247 = roll_dot * z216
            z248 = roll_dot * z222
            z249 = z189 * z225 + c_steer * z248
            z250 = z186 * z218 - z11 * (z185 * z217)
            z251 = z250 - k10 * z247
            s47 = k16 * z249 + k4 * z247 - (z195 * z225 - c_steer * z251)
            z252 = z193 * z228 + z7 * z247 - (z194 * z233 - z20 * z249) + s47
            z253 = z189 * z221 - s_steer * z248
            s48 = k16 * z253 - (z195 * z221 + s_steer * z251)
            z254 = z191 * z233 - z20 * z253 - s48
            z255 = z197 * z236 - z24 * z252 - (z198 * z235 + z23 * z254)
            z256 = z198 * z240 - z30 * z254 - (z197 * z242 - z34 * z252)
            z257 = k4 * z253 - (z191 * z228 - z7 * z253)
            s49 = z200 * z230 + z15 * z255 + (z202 * z229 + z14 * z256)
            z258 = s49 + (z196 * z244 - z36 * z257)
            z259 = z204 * z246 - z39 * z258
            z260 = z197 * z232 - z18 * z252 - (z198 * z237 + z25 * z254)
            s50 = z199 * z230 + z15 * z260 + (z196 * z243 - z35 * z257)
            z261 = s50 + (z202 * z220 - z13 * z256)
            z262 = z203 * z246 - z39 * z261
            s51 = z196 * z238 - z26 * z257 - (z199 * z229 + z14 * z260)
            z263 = s51 + (z200 * z220 - z13 * z255)
            z264 = z201 * z246 - z39 * z263
            z265 = z259 - (z262 - (z205 * z224 + e2z * z264))
            z266 = z209 * z220 + z13 * z265
            z267 = z209 * z231 + z17 * z265
            z268 = z211 * z216 + s1 * z266 - (z210 * z222 - c1 * z267)
            z269 = c_yaw * turn_3
            z270 = z210 * z216 + s1 * z267 + (z211 * z222 - c1 * z266)
            z271 = v2_x * z217 - c_roll * z250 + (z212 * z224 + e2z * z270)
            J[offset1] = z213 * z215 - c_yaw * z268 - (z214 * z269 - s_yaw * z271)
            s52 = z213 * z269 + s_yaw * z268
            J[offset1 + 12] = -(s52 + (z214 * z215 + c_yaw * z271))
            s53 = z212 * z217 - c_roll * z270
            J[offset1 + 24] = v2_x * z224 + e2z * z250 - s53
            J[offset1 + 36] = z264
            J[offset1 + 60] = -z262
            J[offset1 + 84] = z259
        # one rate in each pass: its row of the matrix
        offsets2 = (108, 120, 132)
        for k72, offset2 in enumerate(offsets2):
            row_0 = 1.0 if k72 == 0 else 0.0
            row_1 = 1.0 if k72 == 1 else 0.0
            row_2 = 1.0 if k72 == 2 else 0.0
            z392 = row_1 - z126 * row_0
            z393 = z272 * (row_2 + z168 * row_0 + z173 * z392)
            z394 = z172 * z392 + z173 * z393
            z395 = z125 * row_0 - z126 * z394 + z168 * z393
            z396 = z140 * z393 + z98 * z394 + z60 * z395
            z397 = z149 * z393 + z107 * z394 + z69 * z395
            z398 = z142 * z393 + z100 * z394 + z62 * z395
            z399 = z147 * z393 + z105 * z394 + z67 * z395
            z400 = z150 * z393 + z108 * z394 + z70 * z395
            z401 = k45 * z399 - k40 * z400
            z402 = F_yy * z393
            z403 = F_yy * z394
            z404 = F_yy * z395
            z405 = z148 * z393 + z106 * z394 + z68 * z395
            s54 = z163 * z402 - z105 * z403 - z67 * z404 - k56 * z399
            z406 = s54 + k45 * z400 - k42 * z405
            z407 = z133 * z393
            z408 = z53 * z395
            z409 = z407 - z91 * z394 - z408
            z410 = z145 * z393 + z103 * z394 + z65 * z395
            z411 = z143 * z393 + z101 * z394 + z63 * z395
            z412 = k53 * z409 - k52 * z410 - k42 * z411
            s55 = k37 * z396 + k28 * z397 + k27 * z398 - k10 * z401
            z413 = s55 - c_steer * z406 - s_steer * z412
            z414 = R_yy * z393
            z415 = R_yy * z394
            z416 = R_yy * z395
            z417 = z401 - (k28 * z396 + k26 * z397)
            z418 = k45 * z409 - k42 * z410 - k40 * z411
            z419 = k42 * z399 + k40 * z405
            z420 = s_steer * z418 - c_steer * z419
            z421 = k27 * z396 + k26 * z398 - z420
            s56 = z141 * z414 + z99 * z415 + z61 * z416 - z13 * z417
            z422 = s56 + z17 * z421
            z423 = z413 - z422
            z424 = z39 * z422
            z425 = z39 * z423
            z426 = z407 + z90 * z394 - z408
            z427 = z144 * z393 + z102 * z394 + z64 * z395
            z428 = z44 * z395
            s57 = k35 * z426 + k34 * z427 - k27 * z428 - s_steer * z406
            z429 = s57 + c_steer * z412
            s58 = k57 * z409 - k53 * z410 - k45 * z411 + k38 * z426
            z430 = s58 + k35 * z427 + k28 * z428
            z431 = c_steer * z418 + s_steer * z419
            z432 = z430 - k10 * z431
            z433 = s1 * z429 + c1 * z432
            z434 = c_roll * z433 + e2z * z423
            z435 = z39 * z434
            z436 = z36 * z424 + z35 * z425 - z26 * z435
            z437 = z205 * z436
            z438 = z14 * z424 - z13 * z425
            z439 = z15 * z424 + z13 * z435
            z440 = z15 * z425 + z14 * z435
            z441 = z34 * z438 - z24 * z439 - z18 * z440
            z442 = z205 * z441
            z443 = z30 * z438 + z23 * z439 + z25 * z440
            z444 = z205 * z443
            z445 = z207 * z436 - e2z * z437
            z446 = c_roll * z437
            z447 = s1 * z446
            z448 = c_roll * z442
            z449 = c1 * z448
            s59 = z193 * z441 + z191 * z436 - c_steer * z445 + s_steer * z447
            z450 = s59 + z449
            z451 = z207 * z441 - e2z * z442
            z452 = z207 * z443 - e2z * z444
            z453 = s_steer * z451 + c_steer * z452
            z454 = s1 * z448
            z455 = c_roll * z444
            z456 = s1 * z455
            s60 = z191 * z443 + z194 * z441 - c_steer * z454 + s_steer * z456
            z457 = z453 - s60
            z458 = z6 * z450 + z19 * z457
            z459 = z187 * z458
            z460 = z5 * z459
            z461 = r_F * (z5 * z450) - z4 * z460
            s61 = z205 * z423 - z14 * z437 + z23 * z442 + z24 * z444
            z462 = s61 + s_steer * z461
            z463 = s_steer * z443 - c_steer * z441
            z464 = z331 * z426 + z337 * z427
            z465 = k28 * z426 - k27 * z427 + k26 * z428 - z431
            z466 = z331 * z465 - z208 * z421
            z467 = z208 * z417 + z337 * z465
            s62 = R_yy * z464 + z318 * z417 - z299 * z421 - z13 * z466
            z468 = s62 + z17 * z467
            z469 = z309 * z443 - z300 * z441 - z318 * z436 - z468
            z470 = z39 * z469
            z471 = z21 * z441
            z472 = z21 * z443 - z7 * z436 - k4 * z436
            z473 = z429 + c_steer * z471 - s_steer * z472
            z474 = z206 * z441
            z475 = z206 * z443
            z476 = z209 * z421 - s_steer * z474 + z453 - c_steer * z475
            z477 = r_F * (z5 * z457) - r_R * (z11 * z476) - z2 * z460
            s63 = z330 * z432 - z28 * z448 + z32 * z455 - roll_dot * z473
            z478 = s63 + c_roll * z477
            z479 = z432 + z7 * z441 + k4 * z441 + k10 * z463
            z480 = z209 * z417 + z206 * z436 - z445
            z481 = r_R * (z11 * z480) - c_steer * z461
            s64 = z330 * z429 + z9 * z446 + z27 * z448 - z31 * z455
            z482 = s64 + roll_dot * z479 + c_roll * z481
            s65 = z374 * z397 - z376 * z398 - z366 * z426 + z370 * z427
            z483 = s65 + k37 * z464 + k28 * (z331 * z428 - z208 * z398)
            s66 = z483 + k27 * (z208 * z397 - z337 * z428) + z339 * z420
            z484 = s66 - z210 * z417 - z211 * z421
            z485 = z350 * z409 + w3_steer * z410
            s67 = z360 * z400 + z362 * z405 + z351 * z409 + z352 * z410
            z486 = s67 - k56 * z485 + k45 * (z350 * z411 + z356 * z405)
            z487 = F_yy * z485
            z488 = z486 + k42 * (z356 * z400 - w3_steer * z411) - z487
            s68 = k10 * (z331 * z431 - z208 * z420)
            z489 = z484 + z273 * z406 - z278 * z412 - s68 + c_steer * z488
            z490 = z350 * z399 - z356 * z410
            z491 = z356 * z409 + w3_steer * z399
            s69 = z359 * z400 + z362 * z411 + z357 * z409 - z352 * z399
            z492 = s69 - k53 * z490 + k52 * z491
            z493 = z350 * z400 + w3_steer * z405
            z494 = z492 + k42 * z493
            z495 = z489 + s_steer * z494 + z468
            s70 = z313 * z443 - z305 * z441 - z321 * z436 + s1 * z478
            z496 = s70 - c1 * z482 - z495
            z497 = z39 * z496
            z498 = z14 * z470 + z13 * z497
            z499 = z331 * z396 - z208 * z427
            z500 = z208 * z426 + z337 * z396
            s71 = z373 * z397 + z376 * z428 - z365 * z426 - z370 * z396
            z501 = s71 - k35 * z499 - k34 * z500
            z502 = z331 * z397 - z337 * z398
            s72 = z501 + k27 * z502 - z340 * z401 - z339 * z431
            z503 = s72 + v2_x_2 * z417 + z211 * z465 - z278 * z406
            z504 = z503 - z273 * z412 + s_steer * z488 - c_steer * z494
            s73 = z360 * z411 - z359 * z405 - z351 * z399 - z357 * z410
            z505 = s73 + k57 * z490 - k53 * z491
            z506 = z505 - k45 * z493
            s74 = z374 * z428 + z373 * z398 + z366 * z396 + z365 * z427
            z507 = s74 - k38 * z499 - k35 * z500
            s75 = z507 - k28 * z502 - z340 * z420 + z210 * z465
            z508 = s75 - v2_x_2 * z421 + k10 * (z331 * z401 - z337 * z420)
            z509 = z506 + z508
            z510 = z279 * z429 - z275 * z432 - s1 * z504 - c1 * z509
            s76 = z274 * z433 - z277 * z423 - z314 * z443 + z306 * z441
            z511 = s76 + z322 * z436 + c_roll * z510
            z512 = z511 - e2z * z495
            z513 = z39 * z512
            z514 = z15 * z470 - z13 * z513
            z515 = z15 * z497 + z14 * z513
            z516 = z30 * z498 + z23 * z514 - z25 * z515
            z517 = z34 * z498 - z24 * z514 + z18 * z515
            z518 = z278 * z443 + z273 * z441 + s_steer * z516 - c_steer * z517
            z519 = z294 * z463 + z11 * z518
            z520 = roll_dot * z465
            z521 = z43 * z520 + z186 * z463 - z12 * z480 + z16 * z476
            z522 = z184 * z521
            z523 = z11 * z522
            s77 = z328 * z433 - z320 * z437 - z303 * z442 + z312 * z444
            z524 = s77 - z279 * z481 + z275 * z477
            z525 = z389 * z393
            z526 = z133 * z525
            z527 = z145 * z525
            z528 = z143 * z525
            s78 = z393 * z369 - z146 * z525 - z156 * z525 - k57 * z526
            z529 = s78 + k53 * z527 + k45 * z528
            z530 = z144 * z525
            z531 = z390 * z393 - z389 * z394
            z532 = z391 * z393 - z389 * z395
            s79 = z529 - k38 * z526 - k35 * z530 - z104 * z531 + z114 * z531
            z533 = s79 - z66 * z532 - z76 * z532
            s80 = z363 * z393 + z154 * z525 + k45 * z526 - k42 * z527
            z534 = s80 - k40 * z528 + z112 * z531
            z535 = z534 + z74 * z532
            z536 = z147 * z525
            z537 = z148 * z525
            s81 = z364 * z393 + z155 * z525 + k42 * z536 + k40 * z537
            z538 = s81 - z113 * z531 - z75 * z532
            z539 = z533 + k10 * (c_steer * z535 + s_steer * z538)
            s82 = z372 * z393 + z158 * z525 + k35 * z526 + k34 * z530
            z540 = s82 - z116 * z531 + z78 * z532
            z541 = F_yy * z531
            z542 = F_yy * z532
            z543 = z150 * z525
            s83 = z353 * z393 + z151 * z525 + k56 * z536 - k45 * z543
            z544 = s83 + k42 * z537 - z109 * z531
            s84 = z334 * z402 + 2.0 * (z163 * (F_yy * z525)) + z105 * z541
            z545 = s84 + z67 * z542 - (z544 - z71 * z532)
            s85 = z358 * z393 + z152 * z525 + k53 * z526 - k52 * z527
            z546 = s85 - k42 * z528 + z110 * z531
            z547 = z546 + z72 * z532
            z548 = z540 - s_steer * z545 + c_steer * z547
            z549 = c1 * z539 - s1 * z548
            z550 = z390 * z394
            z551 = z133 * z531
            z552 = z551 - z91 * z550
            z553 = z145 * z531 + z103 * z550
            z554 = z143 * z531 + z101 * z550
            z555 = z391 * z394 + z390 * z395
            s86 = z368 * z394 - z104 * z550 + k57 * z552 - k53 * z553
            z556 = s86 - k45 * z554 - z66 * z555
            z557 = z551 + z90 * z550
            z558 = z144 * z531 + z102 * z550
            s87 = z363 * z394 + z112 * z550 - k45 * z552 + k42 * z553
            z559 = s87 + k40 * z554 + z74 * z555
            z560 = z147 * z531 + z105 * z550
            z561 = z148 * z531 + z106 * z550
            s88 = z364 * z394 - z113 * z550 - k42 * z560 - k40 * z561
            z562 = s88 - z75 * z555
            s89 = z367 * z394 + z114 * z550 + k38 * z557 + k35 * z558
            z563 = s89 - z76 * z555 + k10 * (c_steer * z559 + s_steer * z562)
            z564 = z556 + z563
            s90 = z334 * z403 - z353 * z394 - z163 * z541
            z565 = s90 + 2.0 * (z105 * (F_yy * z550)) + z109 * z550
            z566 = z150 * z531 + z108 * z550
            z567 = F_yy * z555
            s91 = z565 + k56 * z560 - k45 * z566 + k42 * z561 + z67 * z567
            z568 = s91 + z71 * z555
            s92 = z372 * z394 - z116 * z550 - k35 * z557 - k34 * z558
            z569 = s92 + z78 * z555 - s_steer * z568
            s93 = z358 * z394 + z110 * z550 - k53 * z552 + k52 * z553
            z570 = s93 + k42 * z554 + z72 * z555
            z571 = z569 + c_steer * z570
            z572 = c1 * z564 - s1 * z571
            z573 = z391 * z395
            z574 = z133 * z532
            z575 = z53 * z573
            z576 = z574 - z91 * z555 - z575
            z577 = z145 * z532 + z103 * z555 + z65 * z573
            z578 = z143 * z532 + z101 * z555 + z63 * z573
            s94 = z395 * z369 - z66 * z573 - z76 * z573 + k57 * z576
            z579 = s94 - k53 * z577 - k45 * z578
            z580 = z574 + z90 * z555 - z575
            z581 = z144 * z532 + z102 * z555 + z64 * z573
            z582 = z44 * z573
            s95 = z363 * z395 + z74 * z573 - k45 * z576 + k42 * z577
            z583 = s95 + k40 * z578
            z584 = z147 * z532 + z105 * z555 + z67 * z573
            z585 = z148 * z532 + z106 * z555 + z68 * z573
            z586 = z364 * z395 - z75 * z573 - k42 * z584 - k40 * z585
            z587 = c_steer * z583 + s_steer * z586
            z588 = z579 + k38 * z580 + k35 * z581 + k28 * z582 + k10 * z587
            s96 = z334 * z404 - z353 * z395 - z163 * z542 + z105 * z567
            z589 = s96 + 2.0 * (z67 * (F_yy * z573))
            z590 = z150 * z532 + z108 * z555 + z70 * z573
            z591 = z589 + z71 * z573 + k56 * z584 - k45 * z590 + k42 * z585
            s97 = z372 * z395 + z78 * z573 - k35 * z580 - k34 * z581
            z592 = s97 + k27 * z582 - s_steer * z591
            s98 = z358 * z395 + z72 * z573 - k53 * z576 + k52 * z577
            z593 = s98 + k42 * z578
            z594 = z592 + c_steer * z593
            z595 = c1 * z588 - s1 * z594
            s99 = z524 - z205 * z510 + z131 * z549 + z88 * z572 - z51 * z595
            z596 = 2.0 * (z293 * z521 * z379) + s99
            z597 = z331 * z417 + z337 * z421
            s100 = z378 * z395 - z81 * z573 + k28 * z580 - k27 * z581
            z598 = roll_dot * z597 - (s100 + k26 * z582)
            z599 = R_yy * z532
            z600 = R_yy * z555
            z601 = z361 * z395 - z73 * z573 + k45 * z584 - k40 * z590
            z602 = z140 * z532 + z98 * z555 + z60 * z573
            z603 = z149 * z532 + z107 * z555 + z69 * z573
            z604 = z601 + (z375 * z395 - z79 * z573 - k28 * z602 - k26 * z603)
            s101 = z336 * z416 - z141 * z599 - z99 * z600
            z605 = s101 - 2.0 * (z61 * (R_yy * z573)) + z13 * z604
            z606 = z142 * z532 + z100 * z555 + z62 * z573
            s102 = z377 * z395 + z80 * z573 + k27 * z602 + k26 * z606
            z607 = s102 + s_steer * z583 - c_steer * z586
            z608 = z605 - z17 * z607
            z609 = z39 * z608
            s103 = z371 * z395 + z77 * z573 + k37 * z602 + k28 * z603
            z610 = s103 + k27 * z606 + c_steer * z591
            z611 = z610 + s_steer * z593 - k10 * z601 + z608
            z612 = z39 * z611
            z613 = z14 * z609 + z13 * z612
            z614 = c_roll * z595 + e2z * z611
            z615 = z39 * z614
            z616 = z15 * z609 - z13 * z615
            z617 = z15 * z612 + z14 * z615
            z618 = z30 * z613 + z23 * z616 - z25 * z617
            z619 = z34 * z613 - z24 * z616 + z18 * z617
            z620 = s_steer * z618 - c_steer * z619
            z621 = z598 - z587 + z620
            z622 = R_yy * z531
            s104 = z361 * z393 + z153 * z525 - k45 * z536 + k40 * z543
            z623 = s104 - z111 * z531 - z73 * z532
            z624 = z140 * z525
            z625 = z149 * z525
            s105 = z375 * z393 + z160 * z525 + k28 * z624 + k26 * z625
            z626 = s105 - z118 * z531 - z79 * z532
            z627 = z623 + z626
            s106 = z336 * z414 + 2.0 * (z141 * (R_yy * z525)) - z99 * z622
            z628 = s106 - z61 * z599 + z13 * z627
            z629 = z142 * z525
            s107 = z377 * z393 - z159 * z525 - k27 * z624 - k26 * z629
            z630 = s107 + z117 * z531 + z80 * z532
            z631 = z630 + s_steer * z535 - c_steer * z538
            z632 = z628 - z17 * z631
            z633 = z39 * z632
            s108 = z371 * z393 - z157 * z525 - k37 * z624 - k28 * z625
            z634 = s108 - k27 * z629 + z115 * z531
            s109 = z634 + z77 * z532 + c_steer * z545 + s_steer * z547
            z635 = s109 - k10 * z623 + z632
            z636 = z39 * z635
            s110 = z326 * z424 + z316 * z425 + z200 * z470 - z199 * z497
            z637 = s110 + z129 * z633 - z128 * z636
            s111 = z361 * z394 - z111 * z550 + k45 * z560 - k40 * z566
            z638 = s111 - z73 * z555
            z639 = z140 * z531 + z98 * z550
            z640 = z149 * z531 + z107 * z550
            s112 = z375 * z394 - z118 * z550 - k28 * z639 - k26 * z640
            z641 = z638 + (s112 - z79 * z555)
            s113 = z336 * z415 - z141 * z622 - 2.0 * (z99 * (R_yy * z550))
            z642 = s113 - z61 * z600 + z13 * z641
            z643 = z142 * z531 + z100 * z550
            s114 = z377 * z394 + z117 * z550 + k27 * z639 + k26 * z643
            z644 = s114 + z80 * z555 + s_steer * z559
            z645 = z644 - c_steer * z562
            z646 = z642 - z17 * z645
            z647 = z39 * z646
            s115 = z371 * z394 + z115 * z550 + k37 * z639 + k28 * z640
            z648 = s115 + k27 * z643 + z77 * z555
            z649 = z648 + c_steer * z568 + s_steer * z570 - k10 * z638 + z646
            z650 = z39 * z649
            s116 = z335 * z422 + z325 * z423 - z327 * z434 + z204 * z469
            z651 = s116 - z203 * z496 + z201 * z512
            z652 = c_roll * z549 + e2z * z635
            z653 = c_roll * z572 + e2z * z649
            s117 = z651 + z136 * z632 - z138 * z635 - z130 * z652 + z94 * z646
            z654 = s117 - z96 * z649 - z87 * z653
            z655 = z188 * (z654 + z56 * z608 - z58 * z611 + z50 * z614)
            s118 = z637 + z86 * z647 - z85 * z650 + z49 * z609 - z48 * z612
            z656 = s118 - z26 * z655
            z657 = z14 * z633 + z13 * z636
            s119 = z323 * z424 + z196 * z470 - z7 * z633 + z41 * z609
            z658 = s119 - z13 * z655
            s120 = z323 * z425 - z196 * z497 + z7 * z636 - z41 * z612
            z659 = s120 - z14 * z655
            s121 = z315 * z438 + z198 * z498 + z20 * z657 - z47 * z613
            z660 = s121 + z24 * z658 + z18 * z659
            s122 = z274 * z523 - z596 + r_R * (z294 * z520 + z11 * z621)
            z661 = s122 + z10 * z656 + z29 * z660
            z662 = z14 * z647 + z13 * z650
            s123 = z307 * z438 + z197 * z498 + z8 * z662 + z46 * z613
            z663 = s123 - z23 * z658 - z25 * z659
            z664 = k70 * z409 + k69 * z410 + k66 * z411
            s124 = z336 * z417 + z324 * z425 - z326 * z435 - z209 * z466
            z665 = s124 - z202 * z497 + z200 * z513
            z666 = z39 * z652
            z667 = z39 * z653
            s125 = z665 - z141 * z627 - z135 * z636 + z129 * z666 - z99 * z641
            z668 = s125 + z93 * z650 + z86 * z667
            s126 = z324 * z424 + z316 * z435 + z277 * z437 + z202 * z470
            z669 = s126 - z199 * z513 + z135 * z633
            s127 = z669 - z128 * z666 - z93 * z647 - z85 * z667 - z55 * z609
            z670 = s127 - z48 * z615 - z35 * z655
            z671 = z670 - e2z * z656
            s128 = z668 - z61 * z604 + z55 * z612 + z49 * z615 + z36 * z655
            z672 = s128 + z671
            s129 = k63 * z396 + k61 * z398 + r_R * (z294 * z480 + z11 * z672)
            z673 = z273 * z461 + (s_steer * z664 + s129)
            z674 = z36 * z470 - z35 * z497 + z26 * z513
            s130 = z287 * z441 + z308 * z436 - z193 * z517 - z191 * z674
            z675 = s130 - z36 * z633 + z35 * z636
            z676 = z15 * z647 - z13 * z667
            z677 = z15 * z650 + z14 * z667
            z678 = z36 * z609 - z35 * z612 + z26 * z615
            s131 = z273 * z445 + z278 * z447 + z34 * z662 - z24 * z676
            z679 = s131 + z18 * z677 - z40 * z678
            z680 = z274 * z437 + c_roll * z656
            z681 = z279 * z446 + s1 * z680
            z682 = z274 * z442 + c_roll * z660
            z683 = z275 * z448 - c1 * z682
            s132 = z679 + c_steer * z671 - s_steer * z681 + z683
            z684 = z675 - z26 * z666 - s1 * z619 - s132
            s133 = z281 * z460 + k68 * z399 + k66 * z405 + k65 * z399
            z685 = s133 - r_F * (z284 * z450 - z5 * z684)
            z686 = z15 * z633 - z13 * z666
            s134 = z308 * z443 + z291 * z441 - z191 * z516 - z194 * z517
            z687 = s134 - z30 * z657 - z23 * z686
            z688 = z15 * z636 + z14 * z666
            s135 = z315 * z439 - z277 * z442 + z198 * z514 + z20 * z686
            z689 = s135 - z47 * z616 + z34 * z658
            s136 = z323 * z435 - z196 * z513 + z7 * z666 - z41 * z615
            z690 = s136 + z15 * z655
            z691 = z689 - z18 * z690 + e2z * z660
            s137 = z307 * z439 - z277 * z444 + z197 * z514 + z8 * z676
            z692 = s137 + z46 * z616 + z30 * z658
            z693 = z692 + z25 * z690 + e2z * z663
            z694 = z278 * z451 - z273 * z452 + s_steer * z691 + c_steer * z693
            z695 = z279 * z448 + s1 * z682
            z696 = z274 * z444 + c_roll * z663
            z697 = z279 * z455 + s1 * z696
            s138 = z273 * z454 + z278 * z456 + c_steer * z695 - s_steer * z697
            z698 = z687 + z25 * z688 + z40 * z618 - z42 * z619 + (z694 - s138)
            s139 = z285 * z450 - z288 * z457 + z282 * z459 - z6 * z684
            z699 = z5 * (z187 * (s139 + z19 * z698))
            z700 = z283 * z458 * z380 + 0.5 * z699
            z701 = z685 + 2.0 * (z4 * z700)
            z702 = z673 + c_steer * z701
            s140 = z276 * z460 + k67 * z399 - k66 * z400 - k64 * z399
            z703 = s140 - k62 * z396 - k61 * z397
            s141 = z336 * z421 - z209 * z467 - z278 * z474 + z273 * z475
            z704 = s141 - z141 * z631 - z99 * z645
            s142 = z315 * z440 - z198 * z515 - z20 * z688 + z47 * z617
            z705 = s142 + z34 * z659 + z24 * z690
            s143 = z307 * z440 - z197 * z515 - z8 * z677 - z46 * z617
            z706 = s143 + z30 * z659 - z23 * z690
            z707 = z704 - z61 * z607 + s_steer * z705 + z694 + c_steer * z706
            s144 = z703 + r_F * (z284 * z457 + z5 * z698)
            z708 = s144 - r_R * (z294 * z476 + z11 * z707) - 2.0 * (z2 * z700)
            s145 = z317 * z480 - z298 * z476 - z342 * z520 - z295 * z463
            z709 = s145 + z292 * z522 + z43 * z621
            s146 = z11 * (z184 * (z186 * z518 + z709 - z12 * z672 + z16 * z707))
            s147 = z185 * z519 + (z661 - z33 * z663) - s1 * z702 - c1 * z708
            z710 = s147 - c_roll * s146
            z711 = z11 * z463
            s148 = z205 * z433 - r_R * (z11 * z520) + z10 * z437 + z29 * z442
            z712 = s148 - z33 * z444 - z185 * z711
            z713 = z712 + c_roll * z523 + s1 * z481 + c1 * z477
            s149 = z328 * z423 + z321 * z437 + z305 * z442 - z313 * z444
            z714 = s149 + z205 * z495 + k62 * z426
            s150 = z714 - k63 * z427 + k61 * z428 + z131 * z635 + z88 * z649
            z715 = s150 - z51 * z611 + z14 * z656
            s151 = z278 * z461 + (z715 - z23 * z660 - z24 * z663)
            z716 = c_steer * z664 - (roll_dot * z713 - s151) - s_steer * z701
            J[offset2 + 4] = c_roll * z716 - e2z * (roll_dot * z462 - z710)
            z717 = z289 * z441 + z20 * z517 + k16 * z517
            z718 = z289 * z443 - z286 * z436 + z20 * z516 - z7 * z674
            z719 = z718 + (k16 * z516 - k4 * z674)
            s152 = z504 - z273 * z471 - z278 * z472 + c_steer * z717
            z720 = s152 - s_steer * z719
            s153 = z332 * z432 - z302 * z448 + z207 * z482 - z330 * z509
            z721 = s153 - z132 * z539 - z89 * z564
            z722 = z21 * z619
            z723 = z8 * z678 - z20 * z618 - k16 * z618
            s154 = z311 * z455 - (z594 + (z721 + z52 * z588)) - c_steer * z722
            z724 = s154 - s_steer * z723 + z28 * z682
            z725 = z286 * z441 + z7 * z517 + k4 * z517
            z726 = z725 + (z509 + k10 * z518)
            s155 = z332 * z429 - z319 * z446 + z301 * z448 + z310 * z455
            z727 = s155 - z207 * z478 - z330 * z504
            s156 = z727 + z132 * z548 + z89 * z571 + z588 - z52 * z594
            z728 = s156 - z7 * z619 - k4 * z619
            s157 = roll_dot * z726 - (z728 + z9 * z680 + z27 * z682 - z31 * z696)
            z729 = z274 * z481 - (s157 + k10 * z620)
            s158 = z274 * z477 + (roll_dot * z720 - (z724 - z32 * z696))
            z730 = s1 * (s158 - c_roll * z708) - c1 * (z729 - c_roll * z702)
            J[offset2 + 5] = z730
            s159 = z331 * z412 - z208 * z406 - z195 * z441 + z189 * z471
            z731 = s159 + z8 * z445 + k10 * z449
            z732 = z731 + z22 * z452 - z21 * z454 - z17 * z475 + z3 * z461
            s160 = z341 * z418 + z346 * z419 + z333 * z406 + z329 * z412
            z733 = s160 - z331 * z488 - z296 * z443
            s161 = z733 + z290 * z472 + z286 * z447 - z304 * z451 + z299 * z474
            z734 = s161 - z289 * z456 - z208 * z494
            s162 = z734 + z144 * z545 + z140 * z547 + z142 * z535 + z134 * z538
            z735 = s162 + z102 * z568 + z98 * z570
            s163 = z735 + z100 * z559 + z92 * z562 + z64 * z591 + z60 * z593
            z736 = s163 + z62 * z583 + z54 * z586
            s164 = z189 * z719 - (z195 * z516 - z736) + z45 * z618 - c1 * z723
            z737 = s164 - z8 * z681 - z22 * z691
            s165 = k10 * (z275 * z455 - c1 * z696)
            z738 = z3 * z664 + (z737 - z17 * z705 + z21 * z697 + s165)
            s166 = z331 * z406 + z208 * z412 - z195 * z443 + z189 * z472
            z739 = s166 + z8 * z447 - z22 * z451
            s167 = z739 + z17 * z474 - z21 * z456 + k10 * (c1 * z455)
            z740 = s167 + e2z * z461
            s168 = z346 * z418 - z341 * z419 - z333 * z412 + z329 * z406
            z741 = s168 + z331 * z494 + z296 * z441
            s169 = z741 - z290 * z471 - z286 * z445 - z304 * z452 + z289 * z454
            z742 = s169 + z299 * z475 + z280 * z461
            s170 = z742 - z208 * z488 + z140 * z545 - z144 * z547 + z134 * z535
            z743 = s170 - z142 * z538 + z98 * z568
            s171 = z743 - z102 * z570 + z92 * z559 - z100 * z562 + z60 * z591
            z744 = s171 - z64 * z593 + z54 * z583
            s172 = z189 * z717 - (z195 * z517 + (z744 - z62 * z586))
            z745 = s172 + z45 * z619 + c1 * z722 - z8 * z671
            s173 = z745 + k10 * z683 + z22 * z693 + z21 * z695 + z17 * z706
            z746 = steer_dot * z740 - (s173 - z3 * z701)
            s174 = steer_dot * z732 + (z277 * z461 + z738) - e2z * z701
            z747 = c_steer * s174 - s_steer * (e2z * z664 + z746)
            J[offset2 + 6] = z747
            s175 = z275 * z473 + z279 * z479 + z343 * z465 + z44 * z597
            z748 = s175 - r_R * (z274 * z711 - c_roll * z519)
            s176 = z748 + c1 * z720 - s1 * z726 + e2z * z713
            J[offset2 + 9] = c_roll * z462 - s176
            J[offset2 + 10] = z506 + z725 + c_steer * z740 + s_steer * z732
            J[offset2 + 11] = -(z487 + z718)
        _finish("jacobian", J)
        return [J[k73 : k73 + 12] for k73 in range(0, 144, 12)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (12,), p (26,).
    Returns out (3,).
    """
    z = float(y[2])  # centre of the rear wheel, downwards [m]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])  # roll' [rad/s]
    steer_dot = float(y[10])  # steer' [rad/s]
    thF_dot = float(y[11])  # thF' [rad/s]
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # from the parameters alone
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = r_R * s_lam - c_lam * k1
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        k5 = abs(r_R)
        k6 = abs(r_F)
        k7 = abs(w)
        k8 = abs(c)
        k9 = 9.0 * k6
        k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9))
        k11 = 6.0 * k7
        k12 = 14.0 * k6 + 13.0 * k8
        k13 = k9 + 10.0 * k8
        # from the state
        c_roll = math.cos(roll)
        c_pitch = math.cos(pitch)
        s_pitch = math.sin(pitch)
        z1 = c_pitch * s_lam + s_pitch * c_lam
        z2 = c_roll * z1
        z3 = c_roll * c_roll
        z4 = 1.0 / math.sqrt(z3)
        z5 = r_R * z4
        z6 = z2 * z5
        c_steer = math.cos(steer)
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z7 = e2z * s_steer - c_steer * z2
        z8 = c_pitch * c_lam - s_pitch * s_lam
        z9 = c_roll * z8
        z10 = c_lam * z7 + s_lam * z9
        z11 = c_lam * z9 - s_lam * z7
        z12 = 1.0 / math.sqrt(z10 * z10 + z11 * z11)
        z13 = r_F * z12
        z14 = z7 * z13
        z15 = k2 + z14
        z16 = k3 - z6 - c_steer * z15
        z17 = z9 * z5
        z18 = z9 * z13
        z19 = k4 + z18
        z20 = z1 * z19
        z21 = z17 - z19
        z22 = s_steer * z21
        s1 = c_roll * (c_steer * z20 - z8 * (c_steer * k3 - z15))
        z23 = s1 + e2z * z22
        z24 = c_steer * z21
        z25 = c_roll * (k3 * (s_steer * z8) - s_steer * z20) + e2z * z24
        z26 = z24 * z23 - z25 * z22
        z27 = z16 * (c_steer * z17 * z23 - s_steer * z17 * z25) + z6 * z26
        z28 = k11 + k5 * (9.0 + abs(z4))
        s2 = (z28 + k12) * (z28 + k13)
        # the coframe is singular, if z27 is nearly 0
        if not abs(z27) > 1e-12 * (k10 * s2):
            raise _refuse(abs(z27), 1e-12 * (k10 * s2), 1, "outputs")
        z29 = roll_dot * z8
        z30 = c_steer * z29
        z31 = roll_dot * z1
        z32 = steer_dot + z31
        z33 = c_roll * (roll_dot * z5) - k3 * z31
        z34 = k4 * z30 - k2 * z32 - c_steer * z33 - (z32 * z14 - z30 * z18)
        z35 = s_steer * z29
        z36 = thF_dot - z35
        z37 = k4 * z35 - s_steer * z33 - z36 * z18
        s3 = (s_steer * z2 * z15 - e2z * z16) * (z24 * z34 + z22 * z37)
        z38 = s3 + z16 * (z23 * z37 + z25 * z34)
        z39 = r_F * z11
        s4 = z - s_pitch * c_roll * k1 + r_R * (c_pitch * c_roll)
        z40 = s4 - c * z10 - z39 + z10 * (z10 * z13)
        out: list[float] = [
            # speed 123:10
            r_R * ((z38 - z26 * (k2 * z35 - z36 * z14)) / z27),
            # rear_height 124:16
            z + z3 * z5,
            # front_height 125:17
            z40 + z12 * (z11 * z39),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
