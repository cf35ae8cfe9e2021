"""bicycle, emitted by nhc 0.1.0 (nhc:08bb9ecc40865bb7).

Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x
    ahead, y right, z down.
Source: bicycle.yaml
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
y[9] = roll'
y[10] = steer'
y[11] = thF'

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

Constraints:
0: rear_x
1: rear_y
2: rear_z
3: front_x
4: front_y
5: front_z

Outputs:
out[0] = speed
out[1] = rear_height
out[2] = front_height

Operations:
rhs: 501 +-, 760 *, 7 /, 17 calls
velocities: 62 +-, 108 *, 3 /, 17 calls
accelerations: 172 +-, 286 *, 5 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 185 *, 2 /, 12 calls
reactions: 432 +-, 660 *, 4 /, 12 calls
energy: 177 +-, 292 *, 3 /, 12 calls
jacobian: 3688 +-, 5105 *, 10 /, 17 calls
outputs: 64 +-, 112 *, 5 /, 17 calls

A singular point raises SingularModelError.
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns dydt (12,).
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
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
        # parameters only
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
        k10 = c_lam * k2 - r_R * s_lam
        k11 = c_lam * k1 + x_B * s_lam
        k12 = x_B * c_lam - s_lam * k1
        k13 = r_R * c_lam
        k14 = s_lam * k2
        k15 = z_H * c_lam - s_lam * k3 + k13 + k14
        k16 = k14 - (r_F * c_lam + c * s_lam - k13)
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
        k27 = m_B * k11
        k28 = m_B * k12
        k29 = B_xz * c_lam
        k30 = s_lam * k8 - k29
        k31 = B_xz * s_lam
        k32 = c_lam * k7 - k31
        k33 = k11 * k27
        k34 = s_lam * k30 + c_lam * k32 + k33
        k35 = c_lam * k30 - s_lam * k32 + k12 * k27
        k36 = k12 * k28
        k37 = k33 + (B_yy + k36)
        k38 = k31 + c_lam * k8
        k39 = k29 + s_lam * k7
        k40 = s_lam * k38 - c_lam * k39 + k11 * k28
        k41 = k36 + (c_lam * k38 + s_lam * k39)
        k42 = m_F * k16
        k43 = m_H + m_F
        k44 = m_H * k15
        k45 = k42 + k44
        k46 = m_F * k4
        k47 = m_H * k9
        k48 = k46 - k47
        k49 = H_xz * c_lam
        k50 = s_lam * k5 - k49
        k51 = H_xz * s_lam
        k52 = c_lam * k6 - k51
        k53 = k16 * k42
        k54 = k15 * k44
        k55 = s_lam * k50 + c_lam * k52 + k53 + k54
        k56 = c_lam * k50 - s_lam * k52 + k4 * k42 - k9 * k44
        k57 = k4 * k46
        k58 = k9 * k47
        k59 = k54 + (k53 + (H_yy + k57) + k58)
        k60 = k51 + c_lam * k5
        k61 = k49 + s_lam * k6
        k62 = s_lam * k60 - c_lam * k61 + k16 * k46 - k15 * k47
        k63 = k58 + (k57 + (c_lam * k60 + s_lam * k61))
        k64 = g * m_F
        k65 = g * m_H
        k66 = g * m_B
        k67 = g * k26
        k68 = k12 * k66
        k69 = k11 * k66
        k70 = g * k43
        k71 = k15 * k65 + k16 * k64
        k72 = k9 * k65 - k4 * k64
        # state
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
        z5 = z2 * z2 + z4 * z4
        z6 = 1.0 / math.sqrt(z5)
        z7 = r_F * z4
        z8 = z6 * z7
        z9 = k4 + z8
        z10 = s_steer * z9
        z11 = s1 * z10
        z12 = 1.0 / abs(c_roll)
        z13 = r_R * z3
        z14 = z12 * z13
        z15 = k10 + z14 + c_steer * z9
        z16 = c_roll * z11 + e2z * z15
        z17 = r_R * z2
        z18 = z12 * z17
        z19 = c_steer * z18
        z20 = r_F * z2
        z21 = z6 * z20
        z22 = k16 + z21
        z23 = z18 - z22
        z24 = s_steer * z23
        z25 = c_steer * z23
        z26 = s_steer * z18
        z27 = z19 * z24 - z25 * z26
        z28 = c_steer * z22
        z29 = c_steer * k10 + z9
        z30 = s1 * z28 + c1 * z29
        z31 = c_roll * z30 + e2z * z24
        z32 = s_steer * z22
        z33 = s_steer * k10
        z34 = s1 * z32 + c1 * z33
        z35 = c_roll * z34 - e2z * z25
        z36 = z19 * z31 + z35 * z26
        z37 = z25 * z31 + z35 * z24
        z38 = z16 * z27 - z15 * z36 + z14 * z37
        z39 = k17 * (9.0 + abs(z12))
        s2 = (z39 + k24) * (z39 + k25)
        # the coframe is singular
        if not abs(z38) > 1e-12 * (k22 * s2):
            raise SingularModelError(1, "rhs")
        z40 = r_R * c_roll
        z41 = z40 * z12
        z42 = 1.0 / z38
        z43 = s_steer * c1
        z44 = z9 * z43
        z45 = k10 * s1 + z41
        z46 = s_steer * z45 - z22 * z43
        z47 = s1 * z9 + (c_steer * z45 - c1 * z28)
        z48 = z26 * z46 + z19 * z47
        z49 = z24 * z46 + z25 * z47
        z50 = z42 * (z27 * z44 + z15 * z48 - z14 * z49)
        z51 = c_roll * z50
        z52 = s1 + c1 * z51
        z53 = c1 - s1 * z51
        z54 = z31 * z46 - z35 * z47
        z55 = z42 * (z36 * z44 + z16 * z48 - z14 * z54) - e2z * z50
        z56 = c_steer * z55 + s_steer * z53
        z57 = z42 * (z37 * z44 + (z16 * z49 - z15 * z54)) - z55
        z58 = z18 * z57
        z59 = z41 + k10 * z52
        z60 = c_steer * z58 - s_steer * z59
        z61 = z14 * z57
        z62 = z61 - k10 * z55
        z63 = k59 * z56 + (k45 * z60 - k48 * z62)
        z64 = z63 + F_yy * z56
        z65 = k41 * z52 + (z41 * k28 - k40 * z53)
        z66 = c_steer * z59 + s_steer * z58
        z67 = s_steer * z55 - c_steer * z53
        z68 = k63 * z52 + (k48 * z66 + k62 * z67)
        z69 = z65 + z68
        z70 = k56 * z52 + (k45 * z66 + k55 * z67)
        z71 = k43 * z62 - k48 * z56
        z72 = k48 * z52 + (k43 * z66 + k45 * z67)
        z73 = k43 * z60 + k45 * z56
        z74 = k37 * z55 + (k27 * z58 - k28 * z61)
        z75 = k26 * z61 - k28 * z55
        z76 = k26 * z58 + k27 * z55
        z77 = k35 * z52 + (z41 * k27 - k34 * z53)
        s3 = z61 * z75 + (z58 * z76 - (z53 * z77 - R_yy * (z57 * z57)))
        z78 = z60 * z73 + (z55 * z74 + s3)
        s4 = z52 * z69 + (z67 * z70 + (z62 * z71 + (z66 * z72 + z78)))
        z79 = z41 * (k28 * z52 + (z41 * k26 - k27 * z53)) + (z56 * z64 + s4)
        # the mass matrix is singular
        if not abs(z79) > 0.0:
            raise SingularModelError(2, "rhs")
        z80 = z19 * z9
        z81 = z35 * z9
        z82 = z25 * z9
        z83 = z42 * (z15 * z80 - z14 * z82)
        z84 = z42 * (z16 * z80 + z14 * z81) - e2z * z83
        z85 = c_roll * z83
        z86 = s1 * z85
        z87 = c_steer * z84 - s_steer * z86
        z88 = z42 * (z16 * z82 + z15 * z81) - z84
        z89 = z18 * z88
        z90 = c1 * z85
        z91 = k10 * z90
        z92 = c_steer * z89 - s_steer * z91
        z93 = z14 * z88
        z94 = z93 - k10 * z84
        z95 = k59 * z87 + (k45 * z92 - k48 * z94)
        z96 = 1.0 + z90
        z97 = c_steer * z91 + s_steer * z89
        z98 = s_steer * z84 + c_steer * z86
        z99 = k63 * z96 + (k48 * z97 + k62 * z98)
        z100 = k56 * z96 + (k45 * z97 + k55 * z98)
        z101 = k43 * z94 - k48 * z87
        z102 = k48 * z96 + (k43 * z97 + k45 * z98)
        z103 = k43 * z92 + k45 * z87
        z104 = k40 * z86 + k41 * z90
        z105 = z84 * k37 + (z89 * k27 - z93 * k28)
        z106 = k34 * z86 + k35 * z90
        z107 = z89 * k26 + z84 * k27
        z108 = z93 * k26 - z84 * k28
        s5 = z86 * z106 + (z89 * z107 + (z93 * z108 + R_yy * (z88 * z88)))
        z109 = z90 * z104 + (z84 * z105 + s5)
        s6 = z98 * z100 + (z94 * z101 + (z97 * z102 + (z92 * z103 + z109)))
        z110 = z87 * (z95 + F_yy * z87) + (z96 * z99 + s6)
        s7 = z86 * z77 + (z89 * z76 + (z93 * z75 + R_yy * (z88 * z57)))
        z111 = z90 * z65 + (z84 * z74 + s7)
        s8 = z98 * z70 + (z94 * z71 + (z97 * z72 + (z92 * z73 + z111)))
        z112 = z87 * z64 + (z96 * z68 + s8)
        z113 = 1.0 / z79
        z114 = z112 * z113
        z115 = z110 - z112 * z114
        # the mass matrix is singular
        if not abs(z115) > 1e-14 * z110:
            raise SingularModelError(2, "rhs")
        z116 = z21 * z26
        z117 = z21 * z24
        z118 = z42 * (z8 * z27 - z15 * z116 + z14 * z117)
        z119 = c_roll * z118
        z120 = c1 * z119
        z121 = k10 * z120
        z122 = z21 * z31
        z123 = z42 * (z16 * z116 - z8 * z36 - z14 * z122) + e2z * z118
        z124 = z42 * (z16 * z117 - z15 * z122 - z8 * z37) - z123
        z125 = z18 * z124
        z126 = c_steer * z121 - s_steer * z125
        z127 = s1 * z119
        z128 = s_steer * z123 - c_steer * z127
        z129 = c_steer * z123 + s_steer * z127
        z130 = c_steer * z125 + s_steer * z121
        z131 = z14 * z124
        z132 = z131 - k10 * z123
        s9 = z125 * (z125 * k26 + z123 * k27)
        s10 = s9 + z131 * (z131 * k26 - z123 * k28)
        z133 = z127 * (k34 * z127 + k35 * z120) + s10
        s11 = z123 * (z123 * k37 + (z125 * k27 - z131 * k28)) + z133
        z134 = z120 * (k40 * z127 + k41 * z120) + s11
        s12 = z126 * (k48 * z120 + (k43 * z126 - k45 * z128))
        z135 = s12 + (z130 * (k43 * z130 + k45 * z129) + z134)
        s13 = z128 * (k56 * z120 + (k45 * z126 - k55 * z128))
        z136 = s13 - (z132 * (k43 * z132 - k48 * z129) + z135)
        s14 = z129 * (k59 * z129 + (k45 * z130 - k48 * z132)) - z136
        z137 = z120 * (k63 * z120 + (k48 * z126 - k62 * z128)) + s14
        z138 = 1.0 - z129
        z139 = z137 + R_yy * (z124 * z124) + F_yy * (z138 * z138)
        z140 = R_yy * z124
        z141 = F_yy * z138
        s15 = z125 * z76 + (z131 * z75 + (z140 * z57 - z141 * z56))
        z142 = z123 * z74 - (z127 * z77 - s15)
        s16 = z128 * z70 + (z132 * z71 - (z126 * z72 - (z130 * z73 + z142)))
        z143 = z120 * z69 - (z129 * z63 + s16)
        z144 = z143 * z113
        s17 = z131 * z108 + (z88 * z140 - z87 * z141 + z112 * z144)
        z145 = z127 * z106 - (z125 * z107 + s17)
        s18 = z126 * z102 - (z130 * z103 + (z123 * z105 - z145))
        z146 = z129 * z95 + (z128 * z100 + (z132 * z101 - s18))
        z147 = z120 * (z104 + z99) - z146
        z148 = 1.0 / z115
        z149 = z147 * z148
        z150 = z139 - z143 * z144 - z147 * z149
        # the mass matrix is singular
        if not abs(z150) > 1e-14 * z139:
            raise SingularModelError(2, "rhs")
        c_yaw = math.cos(yaw)
        z151 = roll_dot * c1
        z152 = s_steer * z151
        z153 = thF_dot - z152
        z154 = k4 * z152 - z8 * z153
        z155 = roll_dot * r_R
        z156 = c_roll * z155
        z157 = z12 * z156
        z158 = roll_dot * s1
        z159 = z157 + k10 * z158
        z160 = z21 * z153 - (k16 * z152 - s_steer * z159)
        z161 = steer_dot + z158
        z162 = c_steer * z151
        z163 = z161 * z9 + (c_steer * z159 - z22 * z162)
        z164 = z24 * z160 + z25 * z163
        z165 = z31 * z160 - z35 * z163
        z166 = z42 * (z37 * z154 + (z16 * z164 - z15 * z165))
        z167 = z26 * z160 + z19 * z163
        z168 = z42 * (z36 * z154 + z16 * z167 - z14 * z165)
        z169 = z42 * (z27 * z154 + z15 * z167 - z14 * z164)
        z170 = z168 - e2z * z169
        z171 = z166 - z170
        z172 = z14 * z171
        z173 = z18 * z171
        z174 = s1 * z172 + c1 * z173
        s_yaw = math.sin(yaw)
        z175 = s1 * z173 - c1 * z172
        z176 = c_roll * z157 - e2z * z175
        z177 = c1 * z168
        z178 = roll_dot * z177
        z179 = c_roll * z169
        z180 = s1 * z168
        z181 = roll_dot * e2z
        z182 = steer_dot * c_steer
        z183 = z181 * c1 - c_roll * z180
        z184 = roll_dot * c_roll
        z185 = steer_dot * s_steer
        z186 = z181 * s1 + c_roll * z177
        z187 = s_steer * z184 + e2z * z182 + (z185 * z3 + c_steer * z186)
        z188 = (z2 * z183 - z4 * z187) * (z6 * (z6 * z6))
        z189 = r_F * z6
        z190 = z7 * z188 + z189 * z187
        z191 = z181 * z12
        z192 = z191 / c_roll
        z193 = r_R * z12
        z194 = z13 * z192 - z186 * z193
        z195 = z194 - (z185 * z9 - c_steer * z190)
        s19 = c_roll * (z10 * z177 - s1 * (z182 * z9 + s_steer * z190))
        z196 = s19 + (z181 * z11 - (z184 * z15 + e2z * z195))
        z197 = roll_dot * z180
        z198 = z182 * z151 + s_steer * z197
        s20 = z9 * z198 - (z166 * z194 + (z153 * z190 - z168 * z195))
        z199 = z169 * z196 + s20
        z200 = z20 * z188 - z189 * z183
        s21 = z28 * z177 - z29 * z180 + c1 * (z185 * k10 - z190)
        z201 = s1 * (z185 * z22 - c_steer * z200) + s21
        z202 = z17 * z192 - z183 * z193
        z203 = z202 - z200
        z204 = z182 * z23 + s_steer * z203
        z205 = k10 * z178 - (z156 * z192 - z155 * z191)
        s22 = z185 * z159 - (z161 * z190 - (c_steer * z205 + z168 * z204))
        z206 = z22 * (z185 * z151 - c_steer * z197) - (z162 * z200 + s22)
        s23 = c_roll * z201 + (z181 * z30 - (z184 * z24 + e2z * z204))
        s24 = z166 * (z182 * z18 + s_steer * z202) - (z9 * z178 - z206)
        z207 = z169 * s23 - s24
        s25 = z32 * z177 - (z33 * z180 + k10 * (z182 * c1))
        z208 = s1 * (z182 * z22 + s_steer * z200) - s25
        z209 = z185 * z23 - c_steer * z203
        s26 = z153 * z200 + (z182 * z159 - (s_steer * z205 + z168 * z209))
        z210 = z166 * (z185 * z18 - c_steer * z202) - (z22 * z198 - s26)
        s27 = c_roll * z208 - (z181 * z34 + (z184 * z25 - e2z * z209))
        z211 = z169 * s27 + z210
        z212 = z19 * z207 - z26 * z211
        z213 = z25 * z207 - z24 * z211
        z214 = z42 * (z27 * z199 - z15 * z212 + z14 * z213)
        z215 = z181 * z169 - c_roll * z214
        z216 = z178 - (z179 * z180 - c1 * z215)
        z217 = z158 + c1 * z179
        z218 = z151 - s1 * z179
        s28 = roll_dot * (z181 * z193 - z40 * z192)
        z219 = z173 * z217 - z172 * z218 + s28
        z220 = k27 * z170
        z221 = k28 * z170
        z222 = z197 + (z179 * z177 + s1 * z215)
        s29 = z217 * z220 + (e2z * k67 + z218 * z221) + k27 * z222
        z223 = k28 * z216 + (k26 * z219 + s29)
        z224 = z31 * z211 + z35 * z207
        s30 = z42 * (z16 * z212 - z36 * z199 + z14 * z224)
        z225 = s30 + (z184 * z169 + e2z * z214)
        z226 = z185 * z170 + c_steer * z225 - (z182 * z218 + s_steer * z222)
        z227 = k10 * z170
        z228 = k10 * z217
        v2_x = roll_dot * z41
        z229 = z42 * (z16 * z213 + z15 * z224 - z37 * z199) - z225
        z230 = z170 * z172 - v2_x * z217 - (z171 * z202 - z18 * z229)
        z231 = z170 * z227 + z217 * z228 - z230
        z232 = z219 + (z227 * z218 + k10 * z216)
        z233 = c_steer * z231 + s_steer * z232
        w3_steer = steer_dot + z217
        z234 = s_steer * z170 - c_steer * z218
        z235 = k55 * z234 + k56 * w3_steer
        z236 = k62 * z234 + k63 * w3_steer
        z237 = v2_x * z218 - z170 * z173 - (z171 * z194 - z14 * z229)
        z238 = z237 + (z218 * z228 - k10 * z225)
        s31 = k45 * z233 + (w3_steer * z235 - z234 * z236 + k48 * z238)
        z239 = z4 * k71 - (k59 * z226 - s31)
        z240 = z2 * k72 + z239
        z241 = F_yy * z226
        z242 = z240 - z241
        z243 = R_yy * z171 - k37 * z170
        z244 = k34 * z218 - k35 * z217
        s32 = k41 * z216 + (k28 * z219 + k40 * z222)
        z245 = e2z * k68 - (z218 * z243 + z170 * z244 - s32)
        h2z = e2z * c_steer + s_steer * z3
        z246 = c_steer * z170 + s_steer * z218
        z247 = F_yy * (thF_dot - z246) - k59 * z246
        z248 = c_steer * z232 - s_steer * z231
        z249 = z182 * z170 - s_steer * z225 + (z185 * z218 - c_steer * z222)
        s33 = k63 * z216 + (k48 * z248 - k62 * z249)
        z250 = h2z * k72 - (z234 * z247 + z246 * z235 + s33)
        z251 = z245 - z250
        s34 = k56 * z216 + (k45 * z248 - k55 * z249)
        z252 = h2z * k71 - (z246 * z236 + w3_steer * z247 - s34)
        z253 = k45 * z234 + k48 * w3_steer
        z254 = k45 * z246
        s35 = z234 * z253 + z246 * z254 - (k43 * z238 - k48 * z226)
        z255 = z2 * k70 + s35
        z256 = k48 * z246
        s36 = k48 * z216 + (k43 * z248 - k45 * z249)
        z257 = h2z * k70 + (w3_steer * z254 - z234 * z256 + s36)
        s37 = z246 * z256 + w3_steer * z253 + (k43 * z233 - k45 * z226)
        z258 = z4 * k70 + s37
        z259 = k40 * z218 - k41 * z217
        s38 = k37 * z225 + (k27 * z230 - k28 * z237)
        z260 = z3 * k69 + z2 * k68 + (z217 * z244 + z218 * z259 + s38)
        s39 = k35 * z216 + (k27 * z219 + k34 * z222)
        z261 = e2z * k69 + (z170 * z259 - z217 * z243 + s39)
        z262 = k27 * z218 - k28 * z217
        s40 = z218 * z262 + z170 * z220 - (k26 * z237 - k28 * z225)
        z263 = z2 * k67 + s40
        s41 = z170 * z221 - z217 * z262 - (k26 * z230 + k27 * z225)
        z264 = z3 * k67 - s41
        z265 = R_yy * z229
        s42 = z53 * z261 + (z61 * z263 - (z58 * z264 + z57 * z265))
        z266 = z60 * z258 - (z55 * z260 - s42)
        s43 = z52 * z251 + (z67 * z252 - (z62 * z255 - (z66 * z257 - z266)))
        z267 = z41 * z223 - (z56 * z242 - s43)
        s44 = z89 * z264 - (z93 * z263 + (z267 * z114 - z88 * z265))
        z268 = z84 * z260 + (z86 * z261 + s44)
        s45 = z94 * z255 - (z97 * z257 - (z92 * z258 - (z90 * z245 + z268)))
        z269 = z96 * z250 - (z98 * z252 - s45)
        z270 = z87 * z242 + z269
        s46 = z267 * z144 - (z149 * z270 - (z124 * z265 - z138 * z241))
        z271 = z125 * z264 - (z131 * z263 - s46)
        s47 = z130 * z258 - (z123 * z260 - (z127 * z261 - z271))
        z272 = z128 * z252 - (z132 * z255 + (z126 * z257 + s47))
        z273 = (z120 * z251 + (z129 * z240 - z272)) / z150
        z274 = z148 * z270 + z149 * z273
        dydt: list[float] = [
            # x' (I.2.15)
            -(c_yaw * z174 + s_yaw * z176),
            # y' (I.2.15)
            c_yaw * z176 - s_yaw * z174,
            # z' (I.2.15)
            e2z * z157 + c_roll * z175,
            # yaw' (I.2.15)
            z169,
            # roll' (I.2.15)
            roll_dot,
            # pitch' (I.2.15)
            -z168,
            # steer' (I.2.15)
            steer_dot,
            # thR' (I.2.15)
            z166,
            # thF' (I.2.15)
            thF_dot,
            # roll'' (I.2.15) 112:4
            z267 * z113 + z114 * z274 - z144 * z273,
            # steer'' (I.2.15) 112:4
            -z274,
            # thF'' (I.2.15) 112:4
            -z273,
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns qdot (9,).
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = c_lam * k1 - r_R * s_lam
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        k5 = abs(r_R)
        k6 = abs(r_F)
        k7 = abs(w)
        k8 = abs(c)
        k9 = 9.0 * k6
        k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9))
        k11 = 6.0 * k7
        k12 = 13.0 * k8 + (14.0 * k6 + k11)
        k13 = 10.0 * k8 + (k9 + k11)
        # state
        s_steer = math.sin(steer)
        c_roll = math.cos(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        z2 = c_roll * s1
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        z3 = e2z * s_steer - c_steer * z2
        c1 = math.cos(z1)
        z4 = c_roll * c1
        z5 = r_F / math.sqrt(z4 * z4 + z3 * z3)
        z6 = z3 * z5
        z7 = k2 + z6
        z8 = 1.0 / abs(c_roll)
        z9 = r_R * z8
        z10 = z2 * z9
        z11 = k3 + z10 + c_steer * z7
        z12 = s_steer * z2 * z7 + e2z * z11
        z13 = z4 * z9
        z14 = c_steer * z13
        z15 = z4 * z5
        z16 = k4 + z15
        z17 = z13 - z16
        z18 = s_steer * z17
        z19 = c_steer * z17
        z20 = s_steer * z13
        z21 = z14 * z18 - z19 * z20
        z22 = s1 * z16
        s2 = c_roll * (c_steer * z22 + c1 * (c_steer * k3 + z7))
        z23 = s2 + e2z * z18
        z24 = c_roll * (s_steer * z22 + k3 * (s_steer * c1)) - e2z * z19
        z25 = z14 * z23 + z24 * z20
        z26 = z19 * z23 + z24 * z18
        z27 = z12 * z21 - z11 * z25 + z10 * z26
        z28 = k5 * (9.0 + abs(z8))
        s3 = (z28 + k12) * (z28 + k13)
        # the coframe is singular
        if not abs(z27) > 1e-12 * (k10 * s3):
            raise SingularModelError(1, "velocities")
        c_yaw = math.cos(yaw)
        z29 = 1.0 / z27
        z30 = roll_dot * s1
        z31 = steer_dot + z30
        z32 = roll_dot * c1
        z33 = c_steer * z32
        z34 = c_roll * (roll_dot * z9)
        z35 = k3 * z30 + z34
        z36 = z31 * z6 - z33 * z15 - (k4 * z33 - k2 * z31 - c_steer * z35)
        z37 = s_steer * z32
        z38 = thF_dot - z37
        z39 = z38 * z15 - (k4 * z37 - s_steer * z35)
        z40 = z19 * z36 + z18 * z39
        z41 = z23 * z39 - z24 * z36
        z42 = k2 * z37 - z38 * z6
        z43 = z29 * (z12 * z40 - z11 * z41 + z26 * z42)
        z44 = z14 * z36 + z20 * z39
        z45 = z29 * (z12 * z44 + z25 * z42 - z10 * z41)
        z46 = z29 * (z21 * z42 + z11 * z44 - z10 * z40)
        z47 = z43 - (z45 - e2z * z46)
        z48 = z10 * z47
        z49 = z13 * z47
        z50 = s1 * z48 + c1 * z49
        s_yaw = math.sin(yaw)
        z51 = s1 * z49 - c1 * z48
        z52 = c_roll * z34 - e2z * z51
        qdot: list[float] = [
            # x' (I.2.4)
            -(c_yaw * z50 + s_yaw * z52),
            # y' (I.2.4)
            c_yaw * z52 - s_yaw * z50,
            # z' (I.2.4)
            e2z * z34 + c_roll * z51,
            # yaw' (I.2.4)
            z46,
            # roll' (I.2.4)
            roll_dot,
            # pitch' (I.2.4)
            -z45,
            # steer' (I.2.4)
            steer_dot,
            # thR' (I.2.4)
            z43,
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
    """all accelerations q'' on the motion (I.2.15)

    Arguments: t (scalar), y (12,), p (26,).
    Returns qddot (9,).
    """
    dydt = rhs(t, y, p)
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    roll_ddot = float(dydt[9])  # roll''
    steer_ddot = float(dydt[10])  # steer''
    thF_ddot = float(dydt[11])  # thF''
    try:
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = c_lam * k1 - r_R * s_lam
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        # state
        z1 = pitch + lam
        s1 = math.sin(z1)
        c_roll = math.cos(roll)
        z2 = 1.0 / abs(c_roll)
        z3 = c_roll * s1
        z4 = r_R * z3
        z5 = z2 * z4
        s_steer = math.sin(steer)
        c1 = math.cos(z1)
        z6 = c_roll * c1
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        z7 = e2z * s_steer - c_steer * z3
        z8 = z6 * z6 + z7 * z7
        z9 = 1.0 / math.sqrt(z8)
        z10 = r_F * z7
        z11 = z9 * z10
        z12 = k2 + z11
        z13 = s_steer * z12
        z14 = s1 * z13
        z15 = k3 + z5 + c_steer * z12
        z16 = c_roll * z14 + e2z * z15
        z17 = r_R * z6
        z18 = z2 * z17
        z19 = c_steer * z18
        z20 = r_F * z6
        z21 = z9 * z20
        z22 = k4 + z21
        z23 = z18 - z22
        z24 = s_steer * z23
        z25 = c_steer * z23
        z26 = s_steer * z18
        z27 = z19 * z24 - z25 * z26
        z28 = c_steer * z22
        z29 = c_steer * k3 + z12
        z30 = s1 * z28 + c1 * z29
        z31 = c_roll * z30 + e2z * z24
        z32 = s_steer * z22
        z33 = s_steer * k3
        z34 = s1 * z32 + c1 * z33
        z35 = c_roll * z34 - e2z * z25
        z36 = z19 * z31 + z35 * z26
        z37 = z25 * z31 + z35 * z24
        z38 = z16 * z27 - z15 * z36 + z5 * z37
        z39 = 1.0 / z38
        z40 = roll_dot * s1
        z41 = steer_dot + z40
        z42 = roll_dot * c1
        z43 = c_steer * z42
        z44 = roll_dot * r_R
        z45 = c_roll * z44
        z46 = z2 * z45
        z47 = z46 + k3 * z40
        z48 = z11 * z41 - z21 * z43 - (k4 * z43 - k2 * z41 - c_steer * z47)
        z49 = s_steer * z42
        z50 = thF_dot - z49
        z51 = z21 * z50 - (k4 * z49 - s_steer * z47)
        z52 = z25 * z48 + z24 * z51
        z53 = z31 * z51 - z35 * z48
        z54 = k2 * z49 - z11 * z50
        z55 = z16 * z52 - z15 * z53 + z37 * z54
        z56 = z19 * z48 + z26 * z51
        z57 = z16 * z56 + z36 * z54 - z5 * z53
        z58 = z39 * z57
        z59 = z27 * z54 + z15 * z56 - z5 * z52
        z60 = z39 * z59
        z61 = z39 * z55 - (z58 - e2z * z60)
        z62 = z5 * z61
        z63 = z18 * z61
        z64 = s1 * z62 + c1 * z63
        s_yaw = math.sin(yaw)
        z65 = s_yaw * z60
        c_yaw = math.cos(yaw)
        z66 = c1 * z58
        z67 = roll_dot * e2z
        z68 = z2 * (c_roll * z67) / (c_roll * c_roll)
        z69 = z67 * s1 + c_roll * z66
        z70 = r_R * z2
        z71 = z4 * z68 - z69 * z70
        z72 = steer_dot * c_steer
        z73 = s1 * z58
        z74 = z67 * c1 - c_roll * z73
        z75 = roll_dot * c_roll
        z76 = steer_dot * s_steer
        z77 = s_steer * z75 + e2z * z72 + (z76 * z3 + c_steer * z69)
        z78 = (z6 * z74 - z7 * z77) * (z9 * (z9 * z9))
        z79 = r_F * z9
        z80 = z10 * z78 + z79 * z77
        z81 = z71 - (z76 * z12 - c_steer * z80)
        s2 = c_roll * (z13 * z66 - s1 * (z72 * z12 + s_steer * z80))
        z82 = z67 * z14 + s2 - (z75 * z15 + e2z * z81)
        z83 = z17 * z68 - z74 * z70
        z84 = z76 * z18 - c_steer * z83
        z85 = z20 * z78 - z79 * z74
        z86 = z83 - z85
        z87 = z72 * z23 + s_steer * z86
        z88 = z76 * z23 - c_steer * z86
        z89 = z72 * z18 + s_steer * z83
        z90 = z24 * z84 - z19 * z87 - (z26 * z88 - z25 * z89)
        s3 = z28 * z66 + s1 * (z76 * z22 - c_steer * z85)
        z91 = s3 - (z29 * z73 - c1 * (z76 * k3 - z80))
        z92 = z67 * z30 + c_roll * z91 - (z75 * z24 + e2z * z87)
        s4 = z32 * z66 - s1 * (z72 * z22 + s_steer * z85)
        z93 = s4 - (z33 * z73 + k3 * (z72 * c1))
        z94 = z67 * z34 + c_roll * z93 + (z75 * z25 - e2z * z88)
        z95 = z31 * z84 + z19 * z92 + (z26 * z94 - z35 * z89)
        z96 = z31 * z88 + z25 * z92 + (z24 * z94 - z35 * z87)
        s5 = z27 * z82 + z16 * z90 + (z36 * z81 - z15 * z95)
        z97 = s5 - (z37 * z71 - z5 * z96)
        z98 = z97 / (z38 * z38)
        z99 = roll_dot * z66 - s1 * roll_ddot
        z100 = steer_ddot - z99
        z101 = roll_dot * z73 + c1 * roll_ddot
        z102 = z76 * z42 - c_steer * z101
        z103 = z45 * z68 - z2 * (z67 * z44 - r_R * (c_roll * roll_ddot))
        z104 = k3 * z99 - z103
        s6 = k4 * z102 + k2 * z100 - (z76 * z47 + c_steer * z104)
        z105 = z11 * z100 + z41 * z80 + (z21 * z102 - z43 * z85) + s6
        z106 = z72 * z42 + s_steer * z101
        z107 = thF_ddot - z106
        s7 = k4 * z106 - (z72 * z47 - s_steer * z104)
        z108 = z21 * z107 + z50 * z85 - s7
        z109 = z48 * z88 - z25 * z105 - (z51 * z87 + z24 * z108)
        z110 = z51 * z92 - z31 * z108 - (z48 * z94 - z35 * z105)
        z111 = k2 * z106 - (z11 * z107 + z50 * z80)
        s8 = z52 * z82 + z16 * z109 + (z53 * z81 - z15 * z110)
        z112 = s8 + (z54 * z96 - z37 * z111)
        z113 = z55 * z98 - z39 * z112
        z114 = z48 * z84 - z19 * z105 - (z51 * z89 + z26 * z108)
        s9 = z56 * z82 + z16 * z114 + (z54 * z95 - z36 * z111)
        z115 = s9 + (z53 * z71 - z5 * z110)
        z116 = z57 * z98 - z39 * z115
        s10 = z54 * z90 - z27 * z111 - (z56 * z81 - z15 * z114)
        z117 = s10 + (z52 * z71 - z5 * z109)
        z118 = z59 * z98 - z39 * z117
        z119 = z113 - (z116 - (z75 * z60 + e2z * z118))
        z120 = z61 * z71 + z5 * z119
        z121 = z61 * z83 + z18 * z119
        z122 = z62 * z66 - s1 * z120 - (z63 * z73 + c1 * z121)
        z123 = s1 * z63 - c1 * z62
        z124 = c_roll * z46 - e2z * z123
        z125 = c_yaw * z60
        z126 = z63 * z66 - s1 * z121 + (z62 * z73 + c1 * z120)
        z127 = z67 * z46 - c_roll * z103 + (z75 * z123 - e2z * z126)
        qddot: list[float] = [
            # x'' (I.2.15)
            z64 * z65 + c_yaw * z122 - (z124 * z125 - s_yaw * z127),
            # y'' (I.2.15)
            -(z64 * z125 - s_yaw * z122 + (z124 * z65 + c_yaw * z127)),
            # z'' (I.2.15)
            z75 * z46 + e2z * z103 - (z67 * z123 + c_roll * z126),
            # yaw'' (I.2.15)
            z118,
            # roll'' (I.2.15)
            roll_ddot,
            # pitch'' (I.2.15)
            -z116,
            # steer'' (I.2.15)
            steer_ddot,
            # thR'' (I.2.15)
            z113,
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
    """the state y from coordinates and velocities (I.2.1)

    Arguments: t (scalar), q (9,), qdot (9,), p (26,).
    Returns y (12,).
    """
    x = float(q[0])  # centre of the rear wheel [m]
    y_2 = float(q[1])  # centre of the rear wheel [m]
    z = float(q[2])  # centre of the rear wheel, downwards [m]
    yaw = float(q[3])  # first turn of the rear frame, about z [rad]
    roll = float(q[4])  # second turn, about x [rad]
    pitch = float(q[5])  # third turn, about y [rad]
    steer = float(q[6])  # front frame against rear frame [rad]
    thR = float(q[7])  # rear wheel against rear frame [rad]
    thF = float(q[8])  # front wheel against front frame [rad]
    roll_dot = float(qdot[4])
    steer_dot = float(qdot[6])
    thF_dot = float(qdot[8])
    try:
        # state
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
    """left sides of the constraints, zero on every motion (I.1.1)

    Arguments: t (scalar), q (9,), qdot (9,), p (26,).
    Returns r (6,).
    """
    yaw = float(q[3])  # first turn of the rear frame, about z [rad]
    roll = float(q[4])  # second turn, about x [rad]
    pitch = float(q[5])  # third turn, about y [rad]
    steer = float(q[6])  # front frame against rear frame [rad]
    x_dot = float(qdot[0])
    y_dot = float(qdot[1])
    z_dot = float(qdot[2])
    yaw_dot = float(qdot[3])
    roll_dot = float(qdot[4])
    pitch_dot = float(qdot[5])
    steer_dot = float(qdot[6])
    thR_dot = float(qdot[7])
    thF_dot = float(qdot[8])
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        # state
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
        z9 = yaw_dot * s_yaw
        z10 = pitch_dot * s_pitch
        z11 = yaw_dot * c_yaw
        z12 = roll_dot * c_roll
        z13 = e2z * z11 + s_yaw * z12
        z14 = pitch_dot * c_pitch
        z15 = c_pitch * z9 + c_yaw * z10 + (s_pitch * z13 + z1 * z14)
        z16 = s_pitch * z9 - c_yaw * z14 + (z1 * z10 - c_pitch * z13)
        z17 = e1x * c_lam - e3x * s_lam
        s_steer = math.sin(steer)
        z18 = steer_dot * s_steer
        c_steer = math.cos(steer)
        z19 = roll_dot * e2z
        z20 = steer_dot * c_steer
        s1 = z17 * z18 + c_steer * (c_lam * z15 - s_lam * z16)
        z21 = s1 + (s_steer * (c_roll * z11 - s_yaw * z19) + z5 * z20)
        z22 = s_lam * z15 + c_lam * z16
        s2 = c * (c_lam * z21 + s_lam * z22)
        s3 = x_dot - k1 * z15 - r_R * z16 + s2
        Fx_dot = s3 + r_F * (c_lam * z22 - s_lam * z21)
        f1x = c_steer * z17 - z5 * s_steer
        sx = e1x * s_lam + e3x * c_lam
        z23 = c_lam * w1 - s_lam * w3
        z24 = thF_dot + (c_steer * w2 - s_steer * z23)
        z25 = z3 * s_lam - e3z * c_lam
        z26 = z3 * c_lam + e3z * s_lam
        z27 = c_steer * z26 - e2z * s_steer
        z28 = c_lam * z25 - s_lam * z27
        z29 = c_lam * z27 + s_lam * z25
        z30 = r_F / math.sqrt(z29 * z29 + z28 * z28)
        z31 = z28 * z30
        z32 = z24 * z31
        ws = steer_dot + (s_lam * w1 + c_lam * w3)
        wf = c_steer * z23 + s_steer * w2
        z33 = z29 * z30
        s4 = (c_lam * ws - s_lam * wf) * z33
        z34 = s4 - (c_lam * wf + s_lam * ws) * z31
        b3 = z24 * z33
        s5 = Fx_dot - (c_lam * f1x + s_lam * sx) * z32
        s6 = s5 + (z5 * c_steer + z17 * s_steer) * z34
        z35 = s6 + (c_lam * sx - s_lam * f1x) * b3
        z36 = e2z * z9 - c_yaw * z12
        z37 = s_yaw * z10 - c_pitch * z11 - (z8 * z14 - s_pitch * z36)
        z38 = s_pitch * z11 + s_yaw * z14 + (z8 * z10 + c_pitch * z36)
        z39 = e1y * c_lam - e3y * s_lam
        s7 = z39 * z18 + c_steer * (c_lam * z37 + s_lam * z38)
        z40 = s7 + (s_steer * (c_roll * z9 + c_yaw * z19) - e2y * z20)
        z41 = s_lam * z37 - c_lam * z38
        s8 = c * (c_lam * z40 + s_lam * z41)
        s9 = y_dot - k1 * z37 + r_R * z38 + s8
        Fy_dot = s9 + r_F * (c_lam * z41 - s_lam * z40)
        f1y = c_steer * z39 + e2y * s_steer
        sy = e1y * s_lam + e3y * c_lam
        s10 = Fy_dot - (c_lam * f1y + s_lam * sy) * z32
        s11 = s10 - (e2y * c_steer - s_steer * z39) * z34
        z42 = s11 + (c_lam * sy - s_lam * f1y) * b3
        z43 = c_roll * z14 - s_pitch * z19
        z44 = c_roll * z10 + c_pitch * z19
        s12 = z26 * z18 - c_steer * (c_lam * z43 - s_lam * z44)
        z45 = s12 + (s_steer * z12 + e2z * z20)
        z46 = s_lam * z43 + c_lam * z44
        s13 = c * (c_lam * z45 - s_lam * z46)
        s14 = z_dot - k1 * z43 - r_R * z44 - s13
        Fz_dot = s14 + r_F * (c_lam * z46 + s_lam * z45)
        s15 = Fz_dot + z29 * z32 - (e2z * c_steer + s_steer * z26) * z34
        r: list[float] = [
            # rear_x = 0 (I.1.1) 115:5
            x_dot + e1x * a1 + z5 * z7 + e3x * a3,
            # rear_y = 0 (I.1.1) 116:5
            y_dot + e1y * a1 - e2y * z7 + e3y * a3,
            # rear_z = 0 (I.1.1) 117:5
            z_dot - z3 * a1 - e2z * z7 + e3z * a3,
            # front_x = 0 (I.1.1) 118:5
            z35,
            # front_y = 0 (I.1.1) 119:5
            z42,
            # front_z = 0 (I.1.1) 120:5
            s15 - z28 * b3,
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns lambda_ (6,).
    Q_i gains lambda_a a_ai: lambda_a times the coefficient of q'_i in constraint a.
    """
    dydt = rhs(t, y, p)
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
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
        # parameters only
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
        k10 = c_lam * k2 - r_R * s_lam
        k11 = c_lam * k1 + x_B * s_lam
        k12 = x_B * c_lam - s_lam * k1
        k13 = r_R * c_lam
        k14 = s_lam * k2
        k15 = z_H * c_lam - s_lam * k3 + k13 + k14
        k16 = k14 - (r_F * c_lam + c * s_lam - k13)
        k17 = m_R + m_B
        k18 = m_B * k11
        k19 = m_B * k12
        k20 = B_xz * c_lam
        k21 = s_lam * k8 - k20
        k22 = B_xz * s_lam
        k23 = c_lam * k7 - k22
        k24 = k11 * k18
        k25 = s_lam * k21 + c_lam * k23 + k24
        k26 = c_lam * k21 - s_lam * k23 + k12 * k18
        k27 = k12 * k19
        k28 = k24 + (B_yy + k27)
        k29 = k22 + c_lam * k8
        k30 = k20 + s_lam * k7
        k31 = s_lam * k29 - c_lam * k30 + k11 * k19
        k32 = k27 + (c_lam * k29 + s_lam * k30)
        k33 = m_F * k16
        k34 = m_H + m_F
        k35 = m_H * k15
        k36 = k33 + k35
        k37 = m_F * k4
        k38 = m_H * k9
        k39 = k37 - k38
        k40 = H_xz * c_lam
        k41 = s_lam * k5 - k40
        k42 = H_xz * s_lam
        k43 = c_lam * k6 - k42
        k44 = k16 * k33
        k45 = k15 * k35
        k46 = s_lam * k41 + c_lam * k43 + k44 + k45
        k47 = c_lam * k41 - s_lam * k43 + k4 * k33 - k9 * k35
        k48 = k4 * k37
        k49 = k9 * k38
        k50 = k45 + (k44 + (H_yy + k48) + k49)
        k51 = k42 + c_lam * k5
        k52 = k40 + s_lam * k6
        k53 = s_lam * k51 - c_lam * k52 + k16 * k37 - k15 * k38
        k54 = k49 + (k48 + (c_lam * k51 + s_lam * k52))
        k55 = g * m_F
        k56 = g * m_H
        k57 = g * m_B
        k58 = g * k17
        k59 = k12 * k57
        k60 = k11 * k57
        k61 = k9 * k56
        k62 = k15 * k56
        k63 = g * k34
        k64 = k4 * k55
        k65 = k16 * k55
        k66 = k62 + k65
        k67 = k61 - k64
        # state
        s_yaw = math.sin(yaw)
        e2z = math.sin(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        c_roll = math.cos(roll)
        z2 = 1.0 / abs(c_roll)
        c1 = math.cos(z1)
        z3 = c_roll * c1
        z4 = r_R * z3
        z5 = z2 * z4
        s_steer = math.sin(steer)
        c_steer = math.cos(steer)
        z6 = c_roll * s1
        z7 = e2z * s_steer - c_steer * z6
        z8 = z3 * z3 + z7 * z7
        z9 = 1.0 / math.sqrt(z8)
        z10 = r_F * z7
        z11 = z9 * z10
        z12 = k4 + z11
        z13 = s_steer * z12
        z14 = s1 * z13
        z15 = r_R * z6
        z16 = z2 * z15
        z17 = k10 + z16 + c_steer * z12
        z18 = c_roll * z14 + e2z * z17
        z19 = c_steer * z5
        z20 = r_F * z3
        z21 = z9 * z20
        z22 = k16 + z21
        z23 = z5 - z22
        z24 = s_steer * z23
        z25 = c_steer * z23
        z26 = s_steer * z5
        z27 = z19 * z24 - z25 * z26
        z28 = c_steer * z22
        z29 = c_steer * k10 + z12
        z30 = s1 * z28 + c1 * z29
        z31 = c_roll * z30 + e2z * z24
        z32 = s_steer * z22
        z33 = s_steer * k10
        z34 = s1 * z32 + c1 * z33
        z35 = c_roll * z34 - e2z * z25
        z36 = z19 * z31 + z35 * z26
        z37 = z25 * z31 + z35 * z24
        z38 = 1.0 / (z18 * z27 - z17 * z36 + z16 * z37)
        z39 = z21 * z24
        z40 = z21 * z31
        z41 = z21 * z26
        z42 = z38 * (z11 * z27 - z17 * z41 + z16 * z39)
        z43 = z38 * (z18 * z41 - z11 * z36 - z16 * z40) + e2z * z42
        z44 = z38 * (z18 * z39 - z17 * z40 - z11 * z37) - z43
        z45 = z5 * z44
        z46 = c_steer * c1
        z47 = r_R * c_roll
        z48 = z47 * z2
        z49 = k10 * s1 + z48
        z50 = s1 * z11 - z21 * z46 - (k16 * z46 - k4 * s1 - c_steer * z49)
        z51 = s_steer * c1
        z52 = z21 * z51 + (k16 * z51 - s_steer * z49)
        z53 = z25 * z50 - z24 * z52
        z54 = z31 * z52 + z35 * z50
        z55 = z12 * z51
        z56 = z19 * z50 - z26 * z52
        z57 = z38 * (z27 * z55 + z17 * z56 - z16 * z53)
        z58 = z38 * (z18 * z56 + z36 * z55 + z16 * z54) - e2z * z57
        z59 = z38 * (z18 * z53 + z17 * z54 + z37 * z55) - z58
        z60 = z5 * z59
        z61 = z25 * z12
        z62 = z35 * z12
        z63 = z19 * z12
        z64 = z38 * (z17 * z63 - z16 * z61)
        z65 = z38 * (z18 * z63 + z16 * z62) - e2z * z64
        z66 = z38 * (z18 * z61 + z17 * z62) - z65
        z67 = z5 * z66
        z68 = z45 * thF_ddot + (z60 * roll_ddot + z67 * steer_ddot)
        z69 = z43 * thF_ddot + (z58 * roll_ddot + z65 * steer_ddot)
        z70 = roll_dot * s1
        z71 = steer_dot + z70
        z72 = roll_dot * c1
        z73 = c_steer * z72
        z74 = roll_dot * r_R
        z75 = c_roll * z74
        z76 = z2 * z75 + k10 * z70
        z77 = z11 * z71 - z21 * z73 - (k16 * z73 - k4 * z71 - c_steer * z76)
        z78 = s_steer * z72
        z79 = thF_dot - z78
        z80 = z21 * z79 - (k16 * z78 - s_steer * z76)
        z81 = z19 * z77 + z26 * z80
        z82 = k4 * z78 - z11 * z79
        z83 = z31 * z80 - z35 * z77
        z84 = z38 * (z18 * z81 + z36 * z82 - z16 * z83)
        z85 = z25 * z77 + z24 * z80
        z86 = z38 * (z27 * z82 + z17 * z81 - z16 * z85)
        z87 = z84 - e2z * z86
        z88 = k19 * z87
        z89 = c_roll * z86
        z90 = z70 + c1 * z89
        z91 = z72 - s1 * z89
        z92 = k18 * z91 - k19 * z90
        z93 = z38 * (z18 * z85 - z17 * z83 + z37 * z82)
        z94 = z93 - z87
        z95 = z16 * z94
        v2_x = roll_dot * z48
        z96 = roll_dot * e2z
        z97 = z96 * z2
        z98 = z97 / c_roll
        z99 = s1 * z84
        z100 = z96 * c1 - c_roll * z99
        z101 = r_R * z2
        z102 = z4 * z98 - z100 * z101
        z103 = c1 * z84
        z104 = roll_dot * z103
        z105 = roll_dot * c_roll
        z106 = steer_dot * c_steer
        z107 = steer_dot * s_steer
        z108 = z96 * s1 + c_roll * z103
        z109 = s_steer * z105 + e2z * z106 + (z107 * z6 + c_steer * z108)
        z110 = (z3 * z100 - z7 * z109) * (z9 * (z9 * z9))
        z111 = r_F * z9
        z112 = z10 * z110 + z111 * z109
        z113 = roll_dot * z99
        z114 = z107 * z72 - c_steer * z113
        z115 = z20 * z110 - z111 * z100
        z116 = k10 * z104 - (z75 * z98 - z74 * z97)
        s2 = k16 * z114 - k4 * z104 - (z107 * z76 + c_steer * z116)
        z117 = z11 * z104 - z71 * z112 - (z21 * z114 - z73 * z115) - s2
        s3 = z28 * z103 + s1 * (z107 * z22 - c_steer * z115)
        z118 = s3 - (z29 * z99 - c1 * (z107 * k10 - z112))
        z119 = z115 - z102
        z120 = z106 * z23 - s_steer * z119
        s4 = z86 * (z96 * z30 + c_roll * z118 - (z105 * z24 + e2z * z120))
        z121 = z93 * (z106 * z5 + s_steer * z102) - (s4 + z84 * z120)
        z122 = z117 - z121
        z123 = z106 * z72 + s_steer * z113
        s5 = z32 * z103 - s1 * (z106 * z22 + s_steer * z115)
        z124 = s5 - (z33 * z99 + k10 * (z106 * c1))
        z125 = z107 * z23 + c_steer * z119
        s6 = z86 * (z96 * z34 + c_roll * z124 + (z105 * z25 - e2z * z125))
        z126 = z93 * (z107 * z5 - c_steer * z102) - (s6 + z84 * z125)
        s7 = k16 * z123 - (z106 * z76 - s_steer * z116)
        z127 = z21 * z123 - z79 * z115 + s7 - z126
        z128 = z25 * z122 + z24 * z127
        z129 = z31 * z127 - z35 * z122
        z130 = z15 * z98 - z108 * z101
        z131 = z107 * z12 - c_steer * z112 - z130
        s8 = c_roll * (z13 * z103 - s1 * (z106 * z12 + s_steer * z112))
        z132 = z96 * z14 + s8 - (z105 * z17 - e2z * z131)
        s9 = z93 * z130 - (z86 * z132 - z84 * z131)
        z133 = k4 * z123 + (z11 * z123 - z79 * z112) - s9
        z134 = z19 * z122 + z26 * z127
        z135 = z38 * (z27 * z133 - z17 * z134 + z16 * z128)
        s10 = z38 * (z18 * z134 - z36 * z133 - z16 * z129)
        z136 = s10 + (z105 * z86 + e2z * z135)
        z137 = z38 * (z18 * z128 - z17 * z129 - z37 * z133) - z136
        z138 = z87 * z95 - v2_x * z90 - (z94 * z102 - z5 * z137)
        s11 = z6 * k58 - (z87 * z88 - z90 * z92 - (k17 * z138 + k18 * z136))
        z139 = k17 * z68 + k18 * z69 - s11
        z140 = c_roll * z42
        z141 = c1 * z140
        z142 = z141 * thF_ddot
        z143 = c_roll * z57
        z144 = s1 + c1 * z143
        z145 = z144 * roll_ddot
        z146 = c_roll * z64
        z147 = c1 * z146
        z148 = z142 - (z145 + (1.0 + z147) * steer_ddot)
        z149 = k10 * z141
        z150 = z48 + k10 * z144
        z151 = k10 * z147
        s12 = (c_steer * z151 + s_steer * z67) * steer_ddot
        s13 = (c_steer * z150 + s_steer * z60) * roll_ddot + s12
        z152 = (c_steer * z149 - s_steer * z45) * thF_ddot - s13
        z153 = s1 * z140
        z154 = c1 - s1 * z143
        z155 = s1 * z146
        s14 = (s_steer * z65 + c_steer * z155) * steer_ddot
        s15 = (s_steer * z58 - c_steer * z154) * roll_ddot + s14
        z156 = (s_steer * z43 - c_steer * z153) * thF_ddot + s15
        h2z = e2z * c_steer + s_steer * z6
        w3_steer = steer_dot + z90
        z157 = c_steer * z87 + s_steer * z91
        z158 = k36 * z157
        z159 = s_steer * z87 - c_steer * z91
        z160 = k39 * z157
        z161 = z96 * z86 - c_roll * z135
        z162 = z104 - (z89 * z99 - c1 * z161)
        z163 = z5 * z94
        z164 = z163 * z90 - z95 * z91 + roll_dot * (z96 * z101 - z47 * z98)
        z165 = k10 * z87
        z166 = z164 + (z165 * z91 + k10 * z162)
        z167 = k10 * z90
        z168 = z87 * z165 + z90 * z167 - z138
        z169 = c_steer * z166 - s_steer * z168
        z170 = z113 + (z89 * z103 + s1 * z161)
        z171 = z106 * z87 - s_steer * z136 + (z107 * z91 - c_steer * z170)
        s16 = k39 * z162 + (k34 * z169 - k36 * z171)
        z172 = h2z * k63 + (w3_steer * z158 - z159 * z160 + s16)
        z173 = k39 * z148 + (k34 * z152 - k36 * z156) + z172
        s17 = (c_steer * z67 - s_steer * z151) * steer_ddot
        s18 = (c_steer * z60 - s_steer * z150) * roll_ddot + s17
        z174 = (c_steer * z45 + s_steer * z149) * thF_ddot + s18
        z175 = c_steer * z43 + s_steer * z153
        s19 = (c_steer * z65 - s_steer * z155) * steer_ddot
        z176 = (c_steer * z58 + s_steer * z154) * roll_ddot + s19
        z177 = z175 * thF_ddot + z176
        z178 = k36 * z159 + k39 * w3_steer
        z179 = c_steer * z168 + s_steer * z166
        z180 = z107 * z87 + c_steer * z136 - (z106 * z91 + s_steer * z170)
        s20 = z157 * z160 + w3_steer * z178 + (k34 * z179 - k36 * z180)
        z181 = k34 * z174 + k36 * z177 + (z7 * k63 + s20)
        z182 = z139 - s_steer * z173 + c_steer * z181
        z183 = z16 * z44
        z184 = z16 * z59
        z185 = z16 * z66
        z186 = z183 * thF_ddot + (z184 * roll_ddot + z185 * steer_ddot)
        z187 = k18 * z87
        z188 = v2_x * z91 - z87 * z163 - (z94 * z130 - z16 * z137)
        s21 = z91 * z92 + z87 * z187 - (k17 * z188 - k19 * z136)
        z189 = k17 * z186 - k19 * z69 + (z3 * k58 + s21)
        s22 = (z185 - k10 * z65) * steer_ddot
        s23 = (z184 - k10 * z58) * roll_ddot + s22
        z190 = (z183 - k10 * z43) * thF_ddot + s23
        z191 = z188 + (z91 * z167 - k10 * z136)
        s24 = z159 * z178 + z157 * z158 - (k34 * z191 - k39 * z180)
        z192 = k34 * z190 - k39 * z177 + (z3 * k63 + s24)
        z193 = z189 + z192
        s25 = z44 * thF_ddot + (z59 * roll_ddot + z66 * steer_ddot) - z137
        z194 = R_yy * s25 + z16 * z193 + z5 * z182
        z195 = z38 * z194
        z196 = k25 * z91 - k26 * z90
        z197 = k31 * z91 - k32 * z90
        s26 = k28 * z136 + (k18 * z138 - k19 * z188)
        z198 = z6 * k60 + z3 * k59 + (z90 * z196 + z91 * z197 + s26)
        z199 = k46 * z159 + k47 * w3_steer
        z200 = k53 * z159 + k54 * w3_steer
        s27 = k50 * z180 - (k36 * z179 + k39 * z191)
        s28 = z7 * k62 + z3 * k61 + (z7 * k65 - z3 * k64)
        z201 = s28 + (w3_steer * z199 - z159 * z200 - s27)
        s29 = F_yy * (z176 - (1.0 - z175) * thF_ddot - z180)
        z202 = k50 * z177 + (k36 * z174 - k39 * z190) + z201 + s29
        z203 = F_yy * (thF_dot - z157) - k50 * z157
        s30 = k47 * z162 + (k36 * z169 - k46 * z171)
        z204 = h2z * k66 - (z157 * z200 + w3_steer * z203 - s30)
        z205 = k47 * z148 + (k36 * z152 - k46 * z156) + z204
        s31 = k28 * z69 + (k18 * z68 - k19 * z186) - z198 - k10 * z192
        z206 = s31 + c_steer * z202 - s_steer * z205
        z207 = z206 - z194
        z208 = z38 * z207
        z209 = z17 * z195 + z16 * z208
        z210 = z142 - (z145 + z147 * steer_ddot)
        z211 = z48 * roll_ddot
        z212 = z153 * thF_ddot + (z154 * roll_ddot - z155 * steer_ddot)
        z213 = R_yy * z94 - k28 * z87
        s32 = k26 * z162 + (k18 * z164 + k25 * z170)
        z214 = e2z * k60 + (z87 * z197 - z90 * z213 + s32)
        s33 = k26 * z210 - (k18 * z211 - k25 * z212) + z214
        z215 = s1 * (s33 + s_steer * z202 + c_steer * z205)
        s34 = k54 * z162 + (k39 * z169 - k53 * z171)
        z216 = h2z * k67 - (z159 * z203 + z157 * z199 + s34)
        s35 = k32 * z162 + (k19 * z164 + k31 * z170)
        z217 = e2z * k59 - (z91 * z213 + z87 * z196 - s35)
        z218 = c_steer * z173 + s_steer * z181
        s36 = k32 * z210 - (k19 * z211 - k31 * z212) + z217 + k10 * z218
        z219 = k54 * z148 + (k39 * z152 - k53 * z156) - z216 + s36
        z220 = z38 * (c_roll * (z215 + c1 * z219) + e2z * z207)
        z221 = z18 * z195 + z16 * z220
        z222 = z18 * z208 - z17 * z220
        z223 = z31 * z209 - z24 * z221 - z26 * z222
        z224 = c_steer * z223
        z225 = z35 * z209 + z25 * z221 + z19 * z222
        z226 = s_steer * z225
        z227 = z182 + z224 + z226
        z228 = z37 * z195 + z36 * z208 - z27 * z220
        z229 = z193 - z228
        z230 = s1 * z227 - c1 * z229
        s37 = k19 * z162 + (k17 * z164 + k18 * z170)
        z231 = e2z * k58 + (z90 * z187 + z91 * z88 + s37)
        z232 = s_steer * z223 - c_steer * z225
        z233 = k19 * z210 - (k17 * z211 - k18 * z212) + z231 + z218 + z232
        z234 = e2z * z230 + c_roll * z233
        c_yaw = math.cos(yaw)
        z235 = c1 * z227 + s1 * z229
        z236 = z224 + z226
        z237 = s1 * z236 + c1 * z228
        z238 = e2z * z237 + c_roll * z232
        z239 = c1 * z236 - s1 * z228
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            s_yaw * z234 - c_yaw * z235,
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            -(c_yaw * z234 + s_yaw * z235),
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            c_roll * z230 - e2z * z233,
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            c_yaw * z239 - s_yaw * z238,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            c_yaw * z238 + s_yaw * z239,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            e2z * z232 - c_roll * z237,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V (II.1.4)

    Arguments: t (scalar), y (12,), p (26,).
    Returns a scalar.
    """
    z = float(y[2])  # centre of the rear wheel, downwards [m]
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
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
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = r_R + z_B
        k2 = w + c
        k3 = c + (w - x_H)
        k4 = r_F * s_lam - c * c_lam
        k5 = c_lam * k2 - r_R * s_lam
        k6 = s_lam * k2 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        # state
        s_pitch = math.sin(pitch)
        c_roll = math.cos(roll)
        z1 = s_pitch * c_roll
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        Sz = z - z1 * k2 + r_R * e3z
        c_steer = math.cos(steer)
        z2 = z1 * c_lam + e3z * s_lam
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z3 = e2z * s_steer
        z4 = c_steer * z2 - z3
        z5 = z1 * s_lam - e3z * c_lam
        z6 = c_lam * z4 + s_lam * z5
        z7 = c_lam * z5 - s_lam * z4
        s1 = z * m_R + m_B * (z - x_B * z1 + e3z * k1)
        z8 = s1 + m_H * (Sz + z6 * k3 - z_H * z7)
        c_yaw = math.cos(yaw)
        z9 = s_pitch * c_lam + c_pitch * s_lam
        z10 = c_roll * z9
        z11 = r_R / abs(c_roll)
        z12 = z10 * z11
        z13 = z3 - c_steer * z10
        z14 = c_pitch * c_lam - s_pitch * s_lam
        z15 = c_roll * z14
        z16 = r_F / math.sqrt(z15 * z15 + z13 * z13)
        z17 = z13 * z16
        z18 = k4 + z17
        z19 = k5 + z12 + c_steer * z18
        z20 = z18 * (s_steer * z10) + e2z * z19
        z21 = z15 * z11
        z22 = c_steer * z21
        z23 = z15 * z16
        z24 = k6 + z23
        z25 = z21 - z24
        z26 = s_steer * z25
        z27 = c_steer * z25
        z28 = s_steer * z21
        z29 = z22 * z26 - z27 * z28
        z30 = z9 * z24
        s2 = c_roll * (c_steer * z30 + z14 * (c_steer * k5 + z18))
        z31 = s2 + e2z * z26
        z32 = c_roll * (s_steer * z30 + k5 * (s_steer * z14)) - e2z * z27
        z33 = z22 * z31 + z32 * z28
        z34 = z27 * z31 + z32 * z26
        z35 = 1.0 / (z20 * z29 - z19 * z33 + z12 * z34)
        z36 = roll_dot * z9
        z37 = steer_dot + z36
        z38 = roll_dot * z14
        z39 = c_steer * z38
        z40 = roll_dot * c_roll
        z41 = z40 * z11
        z42 = k5 * z36 + z41
        z43 = z37 * z17 - z39 * z23 - (k6 * z39 - k4 * z37 - c_steer * z42)
        z44 = s_steer * z38
        z45 = thF_dot - z44
        z46 = z45 * z23 - (k6 * z44 - s_steer * z42)
        z47 = z27 * z43 + z26 * z46
        z48 = z31 * z46 - z32 * z43
        z49 = k4 * z44 - z45 * z17
        z50 = z22 * z43 + z28 * z46
        z51 = z35 * (z20 * z50 + z33 * z49 - z12 * z48)
        z52 = z35 * (z29 * z49 + z19 * z50 - z12 * z47)
        z53 = z51 - e2z * z52
        z54 = z35 * (z20 * z47 - z19 * z48 + z34 * z49) - z53
        z55 = z12 * z54
        z56 = z21 * z54
        z57 = z9 * z55 + z14 * z56
        s_yaw = math.sin(yaw)
        z58 = z9 * z56 - z14 * z55
        z59 = c_roll * z41 - e2z * z58
        z60 = c_yaw * z57 + s_yaw * z59
        z61 = s_yaw * z52
        z62 = s_pitch * z51
        z63 = c_yaw * z52
        z64 = s_yaw * z40 + e2z * z63
        z65 = s_yaw * e2z
        z66 = c_pitch * z51
        z67 = c_pitch * z61 - c_yaw * z62 + (s_pitch * z64 - z65 * z66)
        z68 = s_pitch * z61 + c_yaw * z66 - (z65 * z62 + c_pitch * z64)
        z69 = z60 + k2 * z67 + r_R * z68
        z70 = steer_dot * s_steer
        s3 = (c_yaw * c_pitch - z65 * s_pitch) * c_lam
        s4 = (s3 - (c_yaw * s_pitch + c_pitch * z65) * s_lam) * z70
        z71 = s4 + c_steer * (c_lam * z67 - s_lam * z68)
        z72 = steer_dot * c_steer
        z73 = c_roll * z72
        z74 = roll_dot * e2z
        z75 = z71 + (s_yaw * z73 - s_steer * (s_yaw * z74 - c_roll * z63))
        z76 = s_lam * z67 + c_lam * z68
        z77 = c_lam * z75 + s_lam * z76
        z78 = c_lam * z76 - s_lam * z75
        z79 = z69 - c * z77 - r_F * z78
        z80 = s_yaw * z57 - c_yaw * z59
        z81 = c_yaw * e2z
        z82 = c_yaw * z40 - e2z * z61
        z83 = s_yaw * z62 + c_pitch * z63 - (z81 * z66 - s_pitch * z82)
        z84 = s_pitch * z63 - s_yaw * z66 - (z81 * z62 + c_pitch * z82)
        z85 = z80 - k2 * z83 - r_R * z84
        s5 = (c_pitch * s_yaw + s_pitch * z81) * c_lam
        s6 = (s5 - (s_yaw * s_pitch - c_pitch * z81) * s_lam) * z70
        z86 = s6 - c_steer * (c_lam * z83 - s_lam * z84)
        z87 = z86 - (c_yaw * z73 - s_steer * (c_yaw * z74 + c_roll * z61))
        z88 = s_lam * z83 + c_lam * z84
        z89 = c_lam * z87 - s_lam * z88
        z90 = c_lam * z88 + s_lam * z87
        z91 = z85 - c * z89 + r_F * z90
        z92 = e2z * z41 + c_roll * z58
        z93 = s_pitch * z74 + c_roll * z66
        z94 = c_pitch * z74 - c_roll * z62
        z95 = z92 + k2 * z93 - r_R * z94
        s7 = z2 * z70 + c_steer * (c_lam * z93 + s_lam * z94)
        z96 = s_steer * z40 + e2z * z72 + s7
        z97 = s_lam * z93 - c_lam * z94
        z98 = c_lam * z96 + s_lam * z97
        z99 = c_lam * z97 - s_lam * z96
        Fz_dot = z95 - c * z98 - r_F * z99
        w1 = roll_dot * c_pitch - z1 * z52
        w3 = roll_dot * s_pitch + e3z * z52
        z100 = c_lam * w1 - s_lam * w3
        z101 = s_steer * z53 - c_steer * z100
        ws = steer_dot + (s_lam * w1 + c_lam * w3)
        z102 = c_lam * z101 - s_lam * ws
        z103 = z102 * z102
        o3 = c_lam * ws + s_lam * z101
        z104 = o3 * o3
        z105 = c_steer * z53 + s_steer * z100
        z106 = thF_dot - z105
        s8 = m_F * (z79 * z79 + z91 * z91 + Fz_dot * Fz_dot)
        z107 = s8 + F_xx * (z103 + z104) + F_yy * (z106 * z106)
        z108 = z69 - k3 * z77 + z_H * z78
        z109 = z85 - k3 * z89 - z_H * z90
        Hz_dot = z95 - k3 * z98 + z_H * z99
        s9 = m_H * (z108 * z108 + z109 * z109 + Hz_dot * Hz_dot)
        z110 = s9 + (H_xx * z103 + H_yy * (z105 * z105) + H_zz * z104)
        z111 = w1 * w1
        z112 = w3 * w3
        s10 = m_R * (z60 * z60 + z80 * z80 + z92 * z92)
        z113 = s10 + R_xx * (z111 + z112) + R_yy * (z54 * z54)
        z114 = z60 + x_B * z67 + k1 * z68
        z115 = z80 - x_B * z83 - k1 * z84
        Bz_dot = z92 + x_B * z93 - k1 * z94
        s11 = m_B * (z114 * z114 + z115 * z115 + Bz_dot * Bz_dot)
        z116 = s11 + (B_xx * z111 + B_yy * (z53 * z53) + B_zz * z112)
        s12 = 0.5 * z113 + (0.5 * z116 + B_xz * (w1 * w3))
        z117 = 0.5 * z110 - H_xz * (z102 * o3) + s12
        s13 = g * (z8 + m_F * (Sz + c * z6 + r_F * z7))
        value1 = 0.5 * z107 + z117 - s13
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """d rhs_i / d y_j, row-major (I.2.15)

    Arguments: t (scalar), y (12,), p (26,).
    Returns rows (12, 12): d rhs_i / d y_j stands at [i][j].
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
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
        # parameters only
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
        k10 = c_lam * k2 - r_R * s_lam
        k11 = c_lam * k1 + x_B * s_lam
        k12 = x_B * c_lam - s_lam * k1
        k13 = r_R * c_lam
        k14 = s_lam * k2
        k15 = z_H * c_lam - s_lam * k3 + k13 + k14
        k16 = k14 - (r_F * c_lam + c * s_lam - k13)
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
        k27 = m_B * k11
        k28 = m_B * k12
        k29 = B_xz * c_lam
        k30 = s_lam * k8 - k29
        k31 = B_xz * s_lam
        k32 = c_lam * k7 - k31
        k33 = k11 * k27
        k34 = s_lam * k30 + c_lam * k32 + k33
        k35 = c_lam * k30 - s_lam * k32 + k12 * k27
        k36 = k12 * k28
        k37 = k33 + (B_yy + k36)
        k38 = k31 + c_lam * k8
        k39 = k29 + s_lam * k7
        k40 = s_lam * k38 - c_lam * k39 + k11 * k28
        k41 = k36 + (c_lam * k38 + s_lam * k39)
        k42 = m_F * k16
        k43 = m_H + m_F
        k44 = m_H * k15
        k45 = k42 + k44
        k46 = m_F * k4
        k47 = m_H * k9
        k48 = k46 - k47
        k49 = H_xz * c_lam
        k50 = s_lam * k5 - k49
        k51 = H_xz * s_lam
        k52 = c_lam * k6 - k51
        k53 = k16 * k42
        k54 = k15 * k44
        k55 = s_lam * k50 + c_lam * k52 + k53 + k54
        k56 = c_lam * k50 - s_lam * k52 + k4 * k42 - k9 * k44
        k57 = k4 * k46
        k58 = k9 * k47
        k59 = k54 + (k53 + (H_yy + k57) + k58)
        k60 = k51 + c_lam * k5
        k61 = k49 + s_lam * k6
        k62 = s_lam * k60 - c_lam * k61 + k16 * k46 - k15 * k47
        k63 = k58 + (k57 + (c_lam * k60 + s_lam * k61))
        k64 = g * m_F
        k65 = g * m_H
        k66 = g * m_B
        k67 = g * k26
        k68 = k12 * k66
        k69 = k11 * k66
        k70 = k9 * k65
        k71 = k15 * k65
        k72 = g * k43
        k73 = k4 * k64
        k74 = k16 * k64
        k75 = k71 + k74
        k76 = k70 - k73
        # state
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
        z5 = z2 * z2 + z4 * z4
        z6 = 1.0 / math.sqrt(z5)
        z7 = r_F * z4
        z8 = z6 * z7
        z9 = k4 + z8
        z10 = s_steer * z9
        z11 = s1 * z10
        z12 = 1.0 / abs(c_roll)
        z13 = r_R * z3
        z14 = z12 * z13
        z15 = k10 + z14 + c_steer * z9
        z16 = c_roll * z11 + e2z * z15
        z17 = r_R * z2
        z18 = z12 * z17
        z19 = c_steer * z18
        z20 = r_F * z2
        z21 = z6 * z20
        z22 = k16 + z21
        z23 = z18 - z22
        z24 = s_steer * z23
        z25 = c_steer * z23
        z26 = s_steer * z18
        z27 = z19 * z24 - z25 * z26
        z28 = c_steer * z22
        z29 = c_steer * k10 + z9
        z30 = s1 * z28 + c1 * z29
        z31 = c_roll * z30 + e2z * z24
        z32 = s_steer * z22
        z33 = s_steer * k10
        z34 = s1 * z32 + c1 * z33
        z35 = c_roll * z34 - e2z * z25
        z36 = z19 * z31 + z35 * z26
        z37 = z25 * z31 + z35 * z24
        z38 = z16 * z27 - z15 * z36 + z14 * z37
        z39 = k17 * (9.0 + abs(z12))
        s2 = k22 * (z39 + k24)
        s3 = (z39 + k25) * s2
        # the coframe is singular
        if not abs(z38) > 1e-12 * s3:
            raise SingularModelError(1, "jacobian")
        z40 = 1.0 / z38
        z41 = s_steer * c1
        z42 = z9 * z41
        z43 = c_steer * c1
        z44 = r_R * c_roll
        z45 = z44 * z12
        z46 = k10 * s1 + z45
        z47 = s1 * z8 - z21 * z43 - (k16 * z43 - k4 * s1 - c_steer * z46)
        z48 = z21 * z41 + (k16 * z41 - s_steer * z46)
        z49 = z19 * z47 - z26 * z48
        z50 = z25 * z47 - z24 * z48
        z51 = z27 * z42 + z15 * z49 - z14 * z50
        z52 = z40 * z51
        z53 = c_roll * z52
        z54 = s1 + c1 * z53
        z55 = z45 + k10 * z54
        z56 = z31 * z48 + z35 * z47
        z57 = z16 * z50 + z15 * z56 + z37 * z42
        z58 = z40 * z57
        z59 = z16 * z49 + z36 * z42 + z14 * z56
        z60 = z40 * z59
        z61 = z60 - e2z * z52
        z62 = z58 - z61
        z63 = z18 * z62
        z64 = c_steer * z55 + s_steer * z63
        z65 = c1 - s1 * z53
        z66 = s_steer * z61 - c_steer * z65
        z67 = k63 * z54 + (k48 * z64 + k62 * z66)
        z68 = c_steer * z61 + s_steer * z65
        z69 = c_steer * z63 - s_steer * z55
        z70 = z14 * z62
        z71 = z70 - k10 * z61
        z72 = k59 * z68 + (k45 * z69 - k48 * z71)
        z73 = k56 * z54 + (k45 * z64 + k55 * z66)
        z74 = k43 * z71 - k48 * z68
        z75 = k48 * z54 + (k43 * z64 + k45 * z66)
        z76 = k43 * z69 + k45 * z68
        z77 = k41 * z54 + (z45 * k28 - k40 * z65)
        z78 = z61 * k37 + (z63 * k27 - z70 * k28)
        z79 = k35 * z54 + (z45 * k27 - k34 * z65)
        z80 = z70 * k26 - z61 * k28
        z81 = z63 * k26 + z61 * k27
        z82 = k28 * z54 + (z45 * k26 - k27 * z65)
        s4 = z65 * z79 - (z70 * z80 + (z63 * z81 + z45 * z82))
        z83 = z54 * z77 + (z61 * z78 - s4)
        s5 = z66 * z73 + (z71 * z74 + (z64 * z75 + (z69 * z76 + z83)))
        z84 = z54 * z67 + (z68 * z72 + s5)
        z85 = z84 + R_yy * (z62 * z62) + F_yy * (z68 * z68)
        # the mass matrix is singular
        if not abs(z85) > 0.0:
            raise SingularModelError(2, "jacobian")
        z86 = z19 * z9
        z87 = z25 * z9
        z88 = z15 * z86 - z14 * z87
        z89 = z40 * z88
        z90 = c_roll * z89
        z91 = c1 * z90
        z92 = 1.0 + z91
        z93 = k10 * z91
        z94 = z35 * z9
        z95 = z16 * z87 + z15 * z94
        z96 = z40 * z95
        z97 = z16 * z86 + z14 * z94
        z98 = z40 * z97
        z99 = z98 - e2z * z89
        z100 = z96 - z99
        z101 = z18 * z100
        z102 = c_steer * z93 + s_steer * z101
        z103 = s1 * z90
        z104 = s_steer * z99 + c_steer * z103
        z105 = k63 * z92 + (k48 * z102 + k62 * z104)
        z106 = c_steer * z99 - s_steer * z103
        z107 = c_steer * z101 - s_steer * z93
        z108 = z14 * z100
        z109 = z108 - k10 * z99
        z110 = k59 * z106 + (k45 * z107 - k48 * z109)
        z111 = k56 * z92 + (k45 * z102 + k55 * z104)
        z112 = k43 * z109 - k48 * z106
        z113 = k48 * z92 + (k43 * z102 + k45 * z104)
        z114 = k43 * z107 + k45 * z106
        z115 = k40 * z103 + k41 * z91
        z116 = z99 * k37 + (z101 * k27 - z108 * k28)
        z117 = k34 * z103 + k35 * z91
        z118 = z101 * k26 + z99 * k27
        z119 = z108 * k26 - z99 * k28
        s6 = z99 * z116 + (z103 * z117 + (z101 * z118 + z108 * z119))
        z120 = z107 * z114 + (z91 * z115 + s6)
        s7 = z104 * z111 + (z109 * z112 + (z102 * z113 + z120))
        z121 = z92 * z105 + (z106 * z110 + s7) + R_yy * (z100 * z100)
        z122 = z121 + F_yy * (z106 * z106)
        s8 = z99 * z78 + (z103 * z79 + (z101 * z81 + z108 * z80))
        z123 = z107 * z76 + (z91 * z77 + s8)
        s9 = z106 * z72 + (z104 * z73 + (z109 * z74 + (z102 * z75 + z123)))
        z124 = z92 * z67 + s9 + R_yy * (z62 * z100)
        z125 = z124 + F_yy * (z68 * z106)
        z126 = 1.0 / z85
        z127 = z125 * z126
        z128 = z122 - z125 * z127
        # the mass matrix is singular
        if not abs(z128) > 1e-14 * z122:
            raise SingularModelError(2, "jacobian")
        z129 = z21 * z26
        z130 = z21 * z24
        z131 = z8 * z27 - z15 * z129 + z14 * z130
        z132 = z40 * z131
        z133 = c_roll * z132
        z134 = c1 * z133
        z135 = k10 * z134
        z136 = z21 * z31
        z137 = z16 * z130 - z15 * z136 - z8 * z37
        z138 = z40 * z137
        z139 = z16 * z129 - z8 * z36 - z14 * z136
        z140 = z40 * z139
        z141 = z140 + e2z * z132
        z142 = z138 - z141
        z143 = z18 * z142
        z144 = c_steer * z135 - s_steer * z143
        z145 = s1 * z133
        z146 = s_steer * z141 - c_steer * z145
        z147 = k63 * z134 + (k48 * z144 - k62 * z146)
        z148 = c_steer * z141 + s_steer * z145
        z149 = c_steer * z143 + s_steer * z135
        z150 = z14 * z142
        z151 = z150 - k10 * z141
        z152 = k59 * z148 + (k45 * z149 - k48 * z151)
        z153 = k56 * z134 + (k45 * z144 - k55 * z146)
        z154 = k43 * z151 - k48 * z148
        z155 = k48 * z134 + (k43 * z144 - k45 * z146)
        z156 = k43 * z149 + k45 * z148
        z157 = k40 * z145 + k41 * z134
        z158 = z141 * k37 + (z143 * k27 - z150 * k28)
        z159 = k34 * z145 + k35 * z134
        z160 = z143 * k26 + z141 * k27
        z161 = z150 * k26 - z141 * k28
        s10 = z141 * z158 + (z145 * z159 + (z143 * z160 + z150 * z161))
        z162 = z149 * z156 + (z134 * z157 + s10)
        s11 = z146 * z153 - (z151 * z154 + (z144 * z155 + z162))
        z163 = z134 * z147 + (z148 * z152 - s11) + R_yy * (z142 * z142)
        z164 = 1.0 - z148
        z165 = z163 + F_yy * (z164 * z164)
        s12 = z141 * z78 - (z145 * z79 - (z143 * z81 + z150 * z80))
        z166 = z149 * z76 - (z134 * z77 - s12)
        s13 = z148 * z72 + (z146 * z73 + (z151 * z74 - (z144 * z75 - z166)))
        z167 = z134 * z67 - s13 - R_yy * (z62 * z142)
        z168 = z167 + F_yy * (z68 * z164)
        z169 = z168 * z126
        s14 = z141 * z116 - (z145 * z117 - (z143 * z118 + z150 * z119))
        z170 = z149 * z114 - (z134 * z115 - s14)
        s15 = z146 * z111 + (z151 * z112 - (z144 * z113 - z170))
        z171 = z134 * z105 - (z148 * z110 + s15) - R_yy * (z100 * z142)
        z172 = z171 + F_yy * (z106 * z164) - z125 * z169
        z173 = 1.0 / z128
        z174 = z172 * z173
        z175 = z165 - z168 * z169 - z172 * z174
        # the mass matrix is singular
        if not abs(z175) > 1e-14 * z165:
            raise SingularModelError(2, "jacobian")
        s_yaw = math.sin(yaw)
        z176 = s1 * z63 - c1 * z70
        z177 = e2z * z176 - c_roll * z45
        c_yaw = math.cos(yaw)
        z178 = s1 * z70 + c1 * z63
        z179 = s1 * z101 - c1 * z108
        z180 = e2z * z179
        z181 = s1 * z108 + c1 * z101
        z182 = s1 * z143 - c1 * z150
        z183 = e2z * z182
        z184 = s1 * z150 + c1 * z143
        z185 = 1.0 / (c_roll * c_roll)
        z186 = roll_dot * r_R
        z187 = c_roll * z186
        z188 = z6 * z6
        z189 = z12 * z187
        z190 = 1.0 / (z38 * z38)
        z191 = roll_dot * c1
        z192 = s_steer * z191
        z193 = thF_dot - z192
        z194 = roll_dot * s1
        z195 = steer_dot + z194
        z196 = c_steer * z191
        z197 = z189 + k10 * z194
        z198 = k4 * z192 - z8 * z193
        s16 = k16 * z196 - k4 * z195 - c_steer * z197
        z199 = z8 * z195 - z21 * z196 - s16
        z200 = z21 * z193 - (k16 * z192 - s_steer * z197)
        z201 = z19 * z199 + z26 * z200
        z202 = z25 * z199 + z24 * z200
        z203 = z27 * z198 + z15 * z201 - z14 * z202
        z204 = z31 * z200 - z35 * z199
        z205 = z16 * z201 + z36 * z198 - z14 * z204
        z206 = z16 * z202 - z15 * z204 + z37 * z198
        z207 = z40 * z203
        z208 = z40 * z206
        z209 = z40 * z205
        z210 = z209 - e2z * z207
        z211 = z208 - z210
        z212 = z18 * z211
        z213 = z14 * z211
        z214 = s1 * z212 - c1 * z213
        z215 = s1 * z213 + c1 * z212
        z216 = c_roll * z189 - e2z * z214
        z274 = 1.0 / z175
        z275 = steer_dot * s_steer
        z276 = roll_dot * e2z
        z277 = s1 * z209
        z278 = z276 * c1 - c_roll * z277
        z279 = roll_dot * c_roll
        z280 = steer_dot * c_steer
        z281 = c1 * z209
        z282 = z276 * s1 + c_roll * z281
        z283 = s_steer * z279 + e2z * z280 + (z275 * z3 + c_steer * z282)
        z284 = z2 * z278 - z4 * z283
        z285 = z6 * z284
        z286 = z188 * z285
        z287 = r_F * z283
        z288 = z7 * z286 + z6 * z287
        z289 = roll_dot * z281
        z290 = r_F * z278
        z291 = z20 * z286 - z6 * z290
        z292 = roll_dot * z277
        z293 = z275 * z191 - c_steer * z292
        z294 = c_roll * z276
        z295 = z12 * z294
        z296 = z295 * z185
        z297 = z276 * z186
        z298 = z187 * z296 - z12 * z297 - k10 * z289
        s17 = k16 * z293 - k4 * z289 - (z275 * z197 - c_steer * z298)
        z299 = z195 * z288 - z8 * z289 - (z196 * z291 - z21 * z293) + s17
        z300 = r_R * z278
        z301 = z17 * z296 - z12 * z300
        z302 = z280 * z18 + s_steer * z301
        z303 = z275 * z22 - c_steer * z291
        z304 = z275 * k10 - z288
        z305 = z28 * z281 + s1 * z303 - (z29 * z277 - c1 * z304)
        z306 = z301 - z291
        z307 = z280 * z23 + s_steer * z306
        z308 = z276 * z30 + c_roll * z305 - (z279 * z24 + e2z * z307)
        z309 = z299 + (z208 * z302 - (z207 * z308 + z209 * z307))
        z310 = z280 * z191 + s_steer * z292
        z311 = z275 * z18 - c_steer * z301
        z312 = z280 * z22 + s_steer * z291
        z313 = z280 * k10
        z314 = z32 * z281 - s1 * z312 - (c1 * z313 + z33 * z277)
        z315 = z275 * z23 - c_steer * z306
        z316 = z276 * z34 + c_roll * z314 + (z279 * z25 - e2z * z315)
        s18 = k16 * z310 - (z280 * z197 + s_steer * z298)
        s19 = z208 * z311 - (z207 * z316 + z209 * z315)
        z317 = z193 * z291 - z21 * z310 - s18 + s19
        z318 = z19 * z309 + z26 * z317
        z319 = r_R * z282
        z320 = z13 * z296 - z12 * z319
        z321 = z280 * z9 + s_steer * z288
        z322 = z10 * z281 - s1 * z321
        z323 = z320 - (z275 * z9 - c_steer * z288)
        z324 = z276 * z11 + c_roll * z322 - (z279 * z15 + e2z * z323)
        s20 = z208 * z320 - (z207 * z324 + z209 * z323)
        z325 = k4 * z310 - (z193 * z288 - z8 * z310) - s20
        z326 = z31 * z317 - z35 * z309
        z327 = z16 * z318 + z36 * z325 - z14 * z326
        z328 = z25 * z309 + z24 * z317
        z329 = z27 * z325 + z15 * z318 - z14 * z328
        z330 = z40 * z329
        z331 = z40 * z327 - (z279 * z207 + e2z * z330)
        z332 = c_roll * z207
        z333 = z191 - s1 * z332
        z334 = z276 * z207 - c_roll * z330
        z335 = z292 + (z332 * z281 + s1 * z334)
        z336 = z275 * z210 - c_steer * z331 - (z280 * z333 + s_steer * z335)
        z337 = z16 * z328 - z15 * z326 + z37 * z325
        z338 = z40 * z337 - z331
        v2_x = roll_dot * z45
        z339 = z194 + c1 * z332
        z340 = z211 * z301 + z18 * z338 - (z210 * z213 - v2_x * z339)
        z341 = k10 * z210
        z342 = k10 * z339
        z343 = z340 + (z210 * z341 + z339 * z342)
        z344 = r_R * z276
        z345 = z12 * z344 - z44 * z296
        z346 = roll_dot * z345 + (z212 * z339 - z213 * z333)
        z347 = z289 - (z332 * z277 - c1 * z334)
        z348 = z346 + (k10 * z347 + z341 * z333)
        z349 = c_steer * z343 + s_steer * z348
        z350 = z211 * z320 + z14 * z338 - (v2_x * z333 - z210 * z212)
        z351 = z350 - (k10 * z331 + z333 * z342)
        w3_steer = steer_dot + z339
        z352 = s_steer * z210 - c_steer * z333
        z353 = k55 * z352 + k56 * w3_steer
        z354 = k62 * z352 + k63 * w3_steer
        s21 = k59 * z336 - (k45 * z349 - k48 * z351)
        s22 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73)
        z355 = s22 - (s21 - (w3_steer * z353 - z352 * z354))
        h2z = e2z * c_steer + s_steer * z3
        z356 = c_steer * z348 - s_steer * z343
        z357 = z280 * z210 + s_steer * z331 + (z275 * z333 - c_steer * z335)
        z358 = c_steer * z210 + s_steer * z333
        z359 = F_yy * (thF_dot - z358) - k59 * z358
        s23 = k56 * z347 + (k45 * z356 - k55 * z357)
        z360 = h2z * k75 + (s23 - (z358 * z354 + w3_steer * z359))
        z361 = k45 * z352 + k48 * w3_steer
        z362 = k45 * z358
        s24 = k43 * z351 + k48 * z336 + (z352 * z361 + z358 * z362)
        z363 = z2 * k72 + s24
        z364 = k48 * z358
        s25 = k48 * z347 + (k43 * z356 - k45 * z357)
        z365 = h2z * k72 + (s25 + (w3_steer * z362 - z352 * z364))
        s26 = k43 * z349 - k45 * z336 + (z358 * z364 + w3_steer * z361)
        z366 = z4 * k72 + s26
        z367 = R_yy * z211 - k37 * z210
        z368 = k34 * z333 - k35 * z339
        s27 = k41 * z347 + (k28 * z346 + k40 * z335)
        z369 = e2z * k68 + (s27 - (z333 * z367 + z210 * z368))
        s28 = k63 * z347 + (k48 * z356 - k62 * z357)
        z370 = h2z * k76 - (s28 + (z352 * z359 + z358 * z353))
        z371 = z369 - z370
        z372 = k40 * z333 - k41 * z339
        s29 = k37 * z331 + (k27 * z340 - k28 * z350)
        z373 = z3 * k69 + z2 * k68 - (s29 - (z339 * z368 + z333 * z372))
        s30 = k35 * z347 + (k27 * z346 + k34 * z335)
        z374 = e2z * k69 + (s30 + (z210 * z372 - z339 * z367))
        z375 = k27 * z333 - k28 * z339
        z376 = k27 * z210
        s31 = k26 * z350 - k28 * z331 + (z333 * z375 + z210 * z376)
        z377 = z2 * k67 + s31
        z378 = k28 * z210
        s32 = k26 * z340 + k27 * z331 + (z210 * z378 - z339 * z375)
        z379 = z3 * k67 - s32
        s33 = k28 * z347 + (k26 * z346 + k27 * z335)
        z380 = e2z * k67 + (s33 + (z339 * z376 + z333 * z378))
        z381 = 1.0 / (z5 * z5)
        z382 = 1.0 / (c_roll * c_roll * c_roll)
        s34 = z141 * z373 - (z145 * z374 - (z143 * z379 - z150 * z377))
        z383 = z149 * z366 + (z134 * z369 - s34)
        s35 = z146 * z360 - (z151 * z363 + (z144 * z365 + z383))
        z384 = z134 * z370 - (z148 * z355 - s35) - R_yy * (z142 * z338)
        s36 = z65 * z374 + (z70 * z377 - (z63 * z379 + z45 * z380))
        z385 = z54 * z369 + (z61 * z373 - s36)
        s37 = z66 * z360 - (z71 * z363 - (z64 * z365 - (z69 * z366 - z385)))
        z386 = z54 * z370 + (z68 * z355 - s37)
        z387 = z386 + R_yy * (z62 * z338) - F_yy * (z68 * z336)
        s38 = z99 * z373 + (z103 * z374 + (z101 * z379 - z108 * z377))
        z388 = z107 * z366 - (z91 * z369 + s38)
        s39 = z104 * z360 - (z109 * z363 - (z102 * z365 - z388))
        z389 = z92 * z370 + (z106 * z355 - s39) + R_yy * (z100 * z338)
        z390 = z389 - F_yy * (z106 * z336) - z387 * z127
        s40 = z384 - F_yy * (z164 * z336) - z387 * z169 - z174 * z390
        z391 = z274 * s40
        z392 = z173 * z390 - z174 * z391
        z393 = z387 * z126 - z127 * z392 - z169 * z391
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
            s_yaw * z177 - c_yaw * z178,
            # (I.2.15)
            s_yaw * z180 - c_yaw * z181,
            # (I.2.15)
            s_yaw * z183 - c_yaw * z184,
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
            -(s_yaw * z178 + c_yaw * z177),
            # (I.2.15)
            -(s_yaw * z181 + c_yaw * z180),
            # (I.2.15)
            -(s_yaw * z184 + c_yaw * z183),
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
            e2z * z45 + c_roll * z176,
            # (I.2.15)
            c_roll * z179,
            # (I.2.15)
            c_roll * z182,
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
            z52,
            # (I.2.15)
            z89,
            # (I.2.15)
            -z132,
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
            -z60,
            # (I.2.15)
            -z98,
            # (I.2.15)
            -z140,
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
            z58,
            # (I.2.15)
            z96,
            # (I.2.15)
            z138,
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
        for k77, offset1 in enumerate(offsets1):
            turn_3 = 1.0 if k77 == 0 else 0.0
            turn_4 = 1.0 if k77 == 1 else 0.0
            turn_5 = 1.0 if k77 == 2 else 0.0
            turn_6 = 1.0 if k77 == 3 else 0.0
            z217 = s_yaw * turn_3
            z218 = c1 * turn_5
            z219 = e2z * turn_4
            z220 = z185 * (z12 * (c_roll * z219))
            z221 = s1 * z219 - c_roll * z218
            z222 = z13 * z220 - z12 * (r_R * z221)
            z223 = c_steer * turn_6
            z224 = s1 * turn_5
            z225 = c1 * z219 + c_roll * z224
            z226 = c_roll * turn_4
            z227 = s_steer * turn_6
            z228 = s_steer * z226 + e2z * z223 + (z3 * z227 + c_steer * z221)
            z229 = z188 * (z6 * (z2 * z225 - z4 * z228))
            z230 = z7 * z229 + z6 * (r_F * z228)
            z231 = z222 - (z9 * z227 - c_steer * z230)
            s41 = c_roll * (z10 * z218 + s1 * (z9 * z223 + s_steer * z230))
            z232 = z11 * z219 - s41 - (z15 * z226 + e2z * z231)
            z233 = z17 * z220 - z12 * (r_R * z225)
            z234 = z18 * z227 - c_steer * z233
            z235 = z20 * z229 - z6 * (r_F * z225)
            z236 = z233 - z235
            z237 = z23 * z223 + s_steer * z236
            z238 = z23 * z227 - c_steer * z236
            z239 = z18 * z223 + s_steer * z233
            z240 = z24 * z234 - z19 * z237 - (z26 * z238 - z25 * z239)
            s42 = z28 * z218 - s1 * (z22 * z227 - c_steer * z235)
            z241 = s42 - (z29 * z224 - c1 * (z230 - k10 * z227))
            z242 = z30 * z219 - c_roll * z241 - (z24 * z226 + e2z * z237)
            s43 = z32 * z218 + s1 * (z22 * z223 + s_steer * z235)
            z243 = s43 - (z33 * z224 - c1 * (k10 * z223))
            z244 = z34 * z219 - c_roll * z243 + (z25 * z226 - e2z * z238)
            z245 = z31 * z234 + z19 * z242 + (z26 * z244 - z35 * z239)
            z246 = z31 * z238 + z25 * z242 + (z24 * z244 - z35 * z237)
            s44 = z27 * z232 + z16 * z240 + (z36 * z231 - z15 * z245)
            z247 = s44 - (z37 * z222 - z14 * z246)
            z248 = z190 * z247
            z249 = roll_dot * z218
            z250 = roll_dot * z224
            z251 = z191 * z227 + c_steer * z250
            z252 = z187 * z220 - z12 * (z186 * z219)
            z253 = z252 + k10 * z249
            s45 = k16 * z251 + k4 * z249 - (z197 * z227 - c_steer * z253)
            z254 = z195 * z230 + z8 * z249 - (z196 * z235 - z21 * z251) + s45
            z255 = z191 * z223 - s_steer * z250
            s46 = k16 * z255 - (z197 * z223 + s_steer * z253)
            z256 = z193 * z235 - z21 * z255 - s46
            z257 = z199 * z238 - z25 * z254 - (z200 * z237 + z24 * z256)
            z258 = z200 * z242 - z31 * z256 - (z199 * z244 - z35 * z254)
            z259 = k4 * z255 - (z193 * z230 - z8 * z255)
            s47 = z202 * z232 + z16 * z257 + (z204 * z231 - z15 * z258)
            z260 = s47 + (z198 * z246 - z37 * z259)
            z261 = z206 * z248 - z40 * z260
            z262 = z199 * z234 - z19 * z254 - (z200 * z239 + z26 * z256)
            s48 = z201 * z232 + z16 * z262 + (z198 * z245 - z36 * z259)
            z263 = s48 + (z204 * z222 - z14 * z258)
            z264 = z205 * z248 - z40 * z263
            s49 = z198 * z240 - z27 * z259 - (z201 * z231 - z15 * z262)
            z265 = s49 + (z202 * z222 - z14 * z257)
            z266 = z203 * z248 - z40 * z265
            z267 = z261 - (z264 - (z207 * z226 + e2z * z266))
            z268 = z211 * z222 + z14 * z267
            z269 = z211 * z233 + z18 * z267
            z270 = z213 * z218 + s1 * z268 - (z212 * z224 - c1 * z269)
            z271 = c_yaw * turn_3
            z272 = z212 * z218 + s1 * z269 + (z213 * z224 - c1 * z268)
            z273 = z189 * z219 - c_roll * z252 + (z214 * z226 + e2z * z272)
            J[offset1] = z215 * z217 - c_yaw * z270 - (z216 * z271 - s_yaw * z273)
            s50 = z215 * z271 + s_yaw * z270
            J[offset1 + 12] = -(s50 + (z216 * z217 + c_yaw * z273))
            s51 = z214 * z219 - c_roll * z272
            J[offset1 + 24] = z189 * z226 + e2z * z252 - s51
            J[offset1 + 36] = z266
            J[offset1 + 60] = -z264
            J[offset1 + 84] = z261
        # one rate in each pass: its row of the matrix
        offsets2 = (108, 120, 132)
        for k78, offset2 in enumerate(offsets2):
            row_0 = 1.0 if k78 == 0 else 0.0
            row_1 = 1.0 if k78 == 1 else 0.0
            row_2 = 1.0 if k78 == 2 else 0.0
            z394 = row_1 - z127 * row_0
            z395 = z274 * (row_2 + z169 * row_0 + z174 * z394)
            z396 = z173 * z394 + z174 * z395
            z397 = z126 * row_0 - z127 * z396 + z169 * z395
            z398 = z141 * z395 + z99 * z396 + z61 * z397
            z399 = z150 * z395 + z108 * z396 + z70 * z397
            z400 = z143 * z395 + z101 * z396 + z63 * z397
            z401 = z148 * z395 + z106 * z396 + z68 * z397
            z402 = z151 * z395 + z109 * z396 + z71 * z397
            z403 = k48 * z401 - k43 * z402
            z404 = F_yy * z395
            z405 = F_yy * z396
            z406 = F_yy * z397
            z407 = z149 * z395 + z107 * z396 + z69 * z397
            s52 = z164 * z404 - z106 * z405 - z68 * z406 - k59 * z401
            z408 = s52 + k48 * z402 - k45 * z407
            z409 = z134 * z395
            z410 = z54 * z397
            z411 = z409 - z92 * z396 - z410
            z412 = z146 * z395 + z104 * z396 + z66 * z397
            z413 = z144 * z395 - z102 * z396 - z64 * z397
            z414 = k62 * z411 - k55 * z412 + k45 * z413
            s53 = k37 * z398 - k28 * z399 + k27 * z400 + k10 * z403
            z415 = s53 - c_steer * z408 - s_steer * z414
            z416 = R_yy * z395
            z417 = R_yy * z396
            z418 = R_yy * z397
            z419 = z403 + (k28 * z398 - k26 * z399)
            z420 = k48 * z411 - k45 * z412 + k43 * z413
            z421 = k45 * z401 + k43 * z407
            z422 = s_steer * z420 - c_steer * z421
            z423 = k27 * z398 + k26 * z400 - z422
            s54 = z142 * z416 + z100 * z417 + z62 * z418 - z14 * z419
            z424 = s54 + z18 * z423
            z425 = z415 - z424
            z426 = z40 * z424
            z427 = z40 * z425
            z428 = z409 - z91 * z396 - z410
            z429 = z145 * z395 - z103 * z396 + z65 * z397
            z430 = z45 * z397
            s55 = k40 * z428 + k34 * z429 - k27 * z430 - s_steer * z408
            z431 = s55 + c_steer * z414
            s56 = k63 * z411 - k56 * z412 + k48 * z413 + k41 * z428
            z432 = s56 + k35 * z429 - k28 * z430
            z433 = c_steer * z420 + s_steer * z421
            z434 = z432 + k10 * z433
            z435 = s1 * z431 + c1 * z434
            z436 = c_roll * z435 + e2z * z425
            z437 = z40 * z436
            z438 = z37 * z426 + z36 * z427 - z27 * z437
            z439 = z207 * z438
            z440 = z15 * z426 + z14 * z427
            z441 = z16 * z426 + z14 * z437
            z442 = z16 * z427 - z15 * z437
            z443 = z35 * z440 + z25 * z441 + z19 * z442
            z444 = z207 * z443
            z445 = z31 * z440 - z24 * z441 - z26 * z442
            z446 = z207 * z445
            z447 = z209 * z438 - e2z * z439
            z448 = c_roll * z439
            z449 = s1 * z448
            z450 = c_roll * z444
            z451 = c1 * z450
            s57 = z195 * z443 - z193 * z438 + c_steer * z447 - s_steer * z449
            z452 = s57 + z451
            z453 = z209 * z443 - e2z * z444
            z454 = z209 * z445 - e2z * z446
            z455 = s_steer * z453 + c_steer * z454
            z456 = s1 * z450
            z457 = c_roll * z446
            z458 = s1 * z457
            s58 = z193 * z445 + z196 * z443 - c_steer * z456 + s_steer * z458
            z459 = z455 - s58
            z460 = z7 * z452 + z20 * z459
            z461 = z188 * z460
            z462 = z6 * z461
            z463 = r_F * (z6 * z452) - z4 * z462
            s59 = z207 * z425 + z15 * z439 - z24 * z444 - z25 * z446
            z464 = s59 - s_steer * z463
            z465 = s_steer * z445 - c_steer * z443
            z466 = z333 * z428 + z339 * z429
            z467 = k28 * z428 + k27 * z429 - k26 * z430 + z433
            z468 = z333 * z467 + z210 * z423
            z469 = z210 * z419 - z339 * z467
            s60 = R_yy * z466 + z320 * z419 - z301 * z423 + z14 * z468
            z470 = s60 + z18 * z469
            z471 = z311 * z445 - z302 * z443 + z320 * z438 + z470
            z472 = z40 * z471
            z473 = z22 * z443
            z474 = z22 * z445 + z8 * z438 + k4 * z438
            z475 = z431 - c_steer * z473 + s_steer * z474
            z476 = z208 * z443
            z477 = z208 * z445
            z478 = z211 * z423 + s_steer * z476 - z455 + c_steer * z477
            z479 = r_F * (z6 * z459) + r_R * (z12 * z478) - z2 * z462
            s61 = z332 * z434 - z29 * z450 + z33 * z457 - roll_dot * z475
            z480 = s61 - c_roll * z479
            z481 = z434 - z8 * z443 - k4 * z443 + k10 * z465
            z482 = z211 * z419 + z208 * z438 - z447
            z483 = r_R * (z12 * z482) + c_steer * z463
            s62 = z332 * z431 + z10 * z448 - z28 * z450 + z32 * z457
            z484 = s62 + roll_dot * z481 + c_roll * z483
            s63 = z376 * z399 + z378 * z400 - z368 * z428 + z372 * z429
            z485 = s63 + k37 * z466 - k28 * (z333 * z430 - z210 * z400)
            s64 = z485 + k27 * (z210 * z399 - z339 * z430) - z341 * z422
            z486 = s64 - z212 * z419 - z213 * z423
            z487 = z352 * z411 + w3_steer * z412
            s65 = z362 * z402 + z364 * z407 + z353 * z411 + z354 * z412
            z488 = s65 - k59 * z487 - k48 * (z352 * z413 - z358 * z407)
            z489 = F_yy * z487
            z490 = z488 + k45 * (z358 * z402 + w3_steer * z413) - z489
            s66 = k10 * (z333 * z433 - z210 * z422)
            z491 = z486 + z275 * z408 - z280 * z414 + s66 + c_steer * z490
            z492 = z352 * z401 - z358 * z412
            z493 = z358 * z411 + w3_steer * z401
            s67 = z361 * z402 - z364 * z413 + z359 * z411 - z354 * z401
            z494 = s67 - k62 * z492 + k55 * z493
            z495 = z352 * z402 + w3_steer * z407
            z496 = z494 + k45 * z495
            z497 = z491 + s_steer * z496 + z470
            s68 = z315 * z445 - z307 * z443 + z323 * z438 - s1 * z480
            z498 = s68 + c1 * z484 + z497
            z499 = z40 * z498
            z500 = z15 * z472 - z14 * z499
            z501 = z333 * z398 - z210 * z429
            z502 = z210 * z428 + z339 * z398
            s69 = z375 * z399 - z378 * z430 - z367 * z428 - z372 * z398
            z503 = s69 - k40 * z501 - k34 * z502
            z504 = z333 * z399 - z339 * z400
            s70 = z503 + k27 * z504 + z342 * z403 + z341 * z433 + v2_x * z419
            z505 = s70 - z213 * z467 - z280 * z408
            z506 = z505 - z275 * z414 + s_steer * z490 - c_steer * z496
            s71 = z362 * z413 + z361 * z407 + z353 * z401 + z359 * z412
            z507 = s71 - k63 * z492 + k56 * z493
            z508 = z507 + k48 * z495
            s72 = z376 * z430 + z375 * z400 + z368 * z398 + z367 * z429
            z509 = s72 - k41 * z501 - k35 * z502
            s73 = z509 + k28 * z504 + z342 * z422 - z212 * z467 - v2_x * z423
            z510 = s73 - k10 * (z333 * z403 - z339 * z422)
            z511 = z508 - z510
            z512 = z281 * z431 - z277 * z434 - s1 * z506 + c1 * z511
            s74 = z276 * z435 - z279 * z425 + z316 * z445 - z308 * z443
            z513 = s74 + z324 * z438 + c_roll * z512
            z514 = z513 - e2z * z497
            z515 = z40 * z514
            z516 = z16 * z472 + z14 * z515
            z517 = z16 * z499 + z15 * z515
            z518 = z31 * z500 - z24 * z516 + z26 * z517
            z519 = z35 * z500 + z25 * z516 - z19 * z517
            z520 = z280 * z445 + z275 * z443 - s_steer * z518 + c_steer * z519
            z521 = z296 * z465 + z12 * z520
            z522 = roll_dot * z467
            z523 = z44 * z522 + z187 * z465 + z13 * z482 - z17 * z478
            z524 = z185 * z523
            z525 = z12 * z524
            s75 = z330 * z435 - z322 * z439 + z305 * z444 - z314 * z446
            z526 = s75 - z281 * z483 - z277 * z479
            z527 = z391 * z395
            z528 = z134 * z527
            z529 = z146 * z527
            z530 = z144 * z527
            s76 = z395 * z371 + z147 * z527 + z157 * z527 + k63 * z528
            z531 = s76 - k56 * z529 + k48 * z530
            z532 = z145 * z527
            z533 = z392 * z395 - z391 * z396
            z534 = z393 * z395 - z391 * z397
            s77 = z531 + k41 * z528 + k35 * z532 + z105 * z533 + z115 * z533
            z535 = s77 + z67 * z534 + z77 * z534
            s78 = z365 * z395 + z155 * z527 + k48 * z528 - k45 * z529
            z536 = s78 + k43 * z530 + z113 * z533
            z537 = z536 + z75 * z534
            z538 = z148 * z527
            z539 = z149 * z527
            s79 = z366 * z395 + z156 * z527 + k45 * z538 + k43 * z539
            z540 = s79 - z114 * z533 - z76 * z534
            z541 = z535 + k10 * (c_steer * z537 + s_steer * z540)
            s80 = z374 * z395 + z159 * z527 + k40 * z528 + k34 * z532
            z542 = s80 + z117 * z533 + z79 * z534
            z543 = F_yy * z533
            z544 = F_yy * z534
            z545 = z151 * z527
            s81 = z355 * z395 + z152 * z527 + k59 * z538 - k48 * z545
            z546 = s81 + k45 * z539 - z110 * z533
            s82 = z336 * z404 + 2.0 * (z164 * (F_yy * z527)) + z106 * z543
            z547 = s82 + z68 * z544 - (z546 - z72 * z534)
            s83 = z360 * z395 + z153 * z527 + k62 * z528 - k55 * z529
            z548 = s83 + k45 * z530 + z111 * z533
            z549 = z548 + z73 * z534
            z550 = z542 - s_steer * z547 + c_steer * z549
            z551 = c1 * z541 + s1 * z550
            z552 = z392 * z396
            z553 = z134 * z533
            z554 = z553 - z92 * z552
            z555 = z146 * z533 + z104 * z552
            z556 = z144 * z533 - z102 * z552
            z557 = z393 * z396 + z392 * z397
            s84 = z370 * z396 - z105 * z552 + k63 * z554 - k56 * z555
            z558 = s84 + k48 * z556 - z67 * z557
            z559 = z553 - z91 * z552
            z560 = z145 * z533 - z103 * z552
            s85 = z365 * z396 + z113 * z552 - k48 * z554 + k45 * z555
            z561 = s85 - k43 * z556 + z75 * z557
            z562 = z148 * z533 + z106 * z552
            z563 = z149 * z533 + z107 * z552
            s86 = z366 * z396 - z114 * z552 - k45 * z562 - k43 * z563
            z564 = s86 - z76 * z557
            s87 = z369 * z396 + z115 * z552 - k41 * z559 - k35 * z560
            s88 = k10 * (c_steer * z561 + s_steer * z564)
            z565 = z558 - (s87 + z77 * z557) - s88
            s89 = z336 * z405 - z355 * z396 - z164 * z543
            z566 = s89 + 2.0 * (z106 * (F_yy * z552)) + z110 * z552
            z567 = z151 * z533 + z109 * z552
            z568 = F_yy * z557
            s90 = z566 + k59 * z562 - k48 * z567 + k45 * z563 + z68 * z568
            z569 = s90 + z72 * z557
            s91 = z374 * z396 + z117 * z552 - k40 * z559 - k34 * z560
            z570 = s91 + z79 * z557 - s_steer * z569
            s92 = z360 * z396 + z111 * z552 - k62 * z554 + k55 * z555
            z571 = s92 - k45 * z556 + z73 * z557
            z572 = z570 + c_steer * z571
            z573 = c1 * z565 - s1 * z572
            z574 = z393 * z397
            z575 = z134 * z534
            z576 = z54 * z574
            z577 = z575 - z92 * z557 - z576
            z578 = z146 * z534 + z104 * z557 + z66 * z574
            z579 = z144 * z534 - z102 * z557 - z64 * z574
            s93 = z397 * z371 + z67 * z574 + z77 * z574 - k63 * z577
            z580 = s93 + k56 * z578 - k48 * z579
            z581 = z575 - z91 * z557 - z576
            z582 = z145 * z534 - z103 * z557 + z65 * z574
            z583 = z45 * z574
            s94 = z365 * z397 + z75 * z574 - k48 * z577 + k45 * z578
            z584 = s94 - k43 * z579
            z585 = z148 * z534 + z106 * z557 + z68 * z574
            z586 = z149 * z534 + z107 * z557 + z69 * z574
            z587 = z366 * z397 - z76 * z574 - k45 * z585 - k43 * z586
            z588 = c_steer * z584 + s_steer * z587
            z589 = z580 - k41 * z581 - k35 * z582 + k28 * z583 + k10 * z588
            s95 = z336 * z406 - z355 * z397 - z164 * z544 + z106 * z568
            z590 = s95 + 2.0 * (z68 * (F_yy * z574))
            z591 = z151 * z534 + z109 * z557 + z71 * z574
            z592 = z590 + z72 * z574 + k59 * z585 - k48 * z591 + k45 * z586
            s96 = z374 * z397 + z79 * z574 - k40 * z581 - k34 * z582
            z593 = s96 + k27 * z583 - s_steer * z592
            s97 = z360 * z397 + z73 * z574 - k62 * z577 + k55 * z578
            z594 = s97 - k45 * z579
            z595 = z593 + c_steer * z594
            z596 = c1 * z589 + s1 * z595
            s98 = z526 - z207 * z512 - z132 * z551 - z89 * z573 + z52 * z596
            z597 = 2.0 * (z295 * z523 * z382) - s98
            z598 = R_yy * z533
            z599 = R_yy * z534
            s99 = z363 * z395 + z154 * z527 - k48 * z538 + k43 * z545
            z600 = s99 - z112 * z533 - z74 * z534
            z601 = z141 * z527
            z602 = z150 * z527
            s100 = z377 * z395 + z161 * z527 - k28 * z601 + k26 * z602
            z603 = s100 - z119 * z533 - z80 * z534
            z604 = z600 + z603
            s101 = z338 * z416 + 2.0 * (z142 * (R_yy * z527)) - z100 * z598
            z605 = s101 - z62 * z599 + z14 * z604
            z606 = z143 * z527
            s102 = z379 * z395 - z160 * z527 - k27 * z601 - k26 * z606
            z607 = s102 + z118 * z533 + z81 * z534
            z608 = z607 + s_steer * z537 - c_steer * z540
            z609 = z605 - z18 * z608
            z610 = z40 * z609
            s103 = z373 * z395 - z158 * z527 - k37 * z601 + k28 * z602
            z611 = s103 - k27 * z606 + z116 * z533
            s104 = z611 + z78 * z534 + c_steer * z547 + s_steer * z549
            z612 = s104 + k10 * z600 + z609
            z613 = z40 * z612
            s105 = z328 * z426 + z318 * z427 - z202 * z472 + z201 * z499
            z614 = s105 + z130 * z610 - z129 * z613
            z615 = R_yy * z557
            s106 = z363 * z396 - z112 * z552 + k48 * z562 - k43 * z567
            z616 = s106 - z74 * z557
            z617 = z141 * z533 + z99 * z552
            z618 = z150 * z533 + z108 * z552
            s107 = z377 * z396 - z119 * z552 + k28 * z617 - k26 * z618
            z619 = z616 + (s107 - z80 * z557)
            s108 = z338 * z417 - z142 * z598 - 2.0 * (z100 * (R_yy * z552))
            z620 = s108 - z62 * z615 + z14 * z619
            z621 = z143 * z533 + z101 * z552
            s109 = z379 * z396 + z118 * z552 + k27 * z617 + k26 * z621
            z622 = s109 + z81 * z557 + s_steer * z561
            z623 = z622 - c_steer * z564
            z624 = z620 - z18 * z623
            z625 = z40 * z624
            s110 = z373 * z396 + z116 * z552 + k37 * z617 - k28 * z618
            z626 = s110 + k27 * z621 + z78 * z557
            z627 = z626 + c_steer * z569 + s_steer * z571 + k10 * z616 + z624
            z628 = z40 * z627
            z629 = z363 * z397 - z74 * z574 + k48 * z585 - k43 * z591
            z630 = z141 * z534 + z99 * z557 + z61 * z574
            z631 = z150 * z534 + z108 * z557 + z70 * z574
            z632 = z629 + (z377 * z397 - z80 * z574 + k28 * z630 - k26 * z631)
            s111 = z338 * z418 - z142 * z599 - z100 * z615
            z633 = s111 - 2.0 * (z62 * (R_yy * z574)) + z14 * z632
            z634 = z143 * z534 + z101 * z557 + z63 * z574
            s112 = z379 * z397 + z81 * z574 + k27 * z630 + k26 * z634
            z635 = s112 + s_steer * z584 - c_steer * z587
            z636 = z633 - z18 * z635
            z637 = z40 * z636
            s113 = z373 * z397 + z78 * z574 + k37 * z630 - k28 * z631
            z638 = s113 + k27 * z634 + c_steer * z592
            z639 = z638 + s_steer * z594 + k10 * z629 + z636
            z640 = z40 * z639
            s114 = z337 * z424 + z327 * z425 - z329 * z436 - z206 * z471
            z641 = s114 + z205 * z498 + z203 * z514
            z642 = c_roll * z551 - e2z * z612
            z643 = c_roll * z573 + e2z * z627
            s115 = z641 + z137 * z609 - z139 * z612 + z131 * z642 + z95 * z624
            z644 = s115 - z97 * z627 + z88 * z643
            z645 = c_roll * z596 - e2z * z639
            z646 = z190 * (z644 + z57 * z636 - z59 * z639 - z51 * z645)
            s116 = z614 + z87 * z625 - z86 * z628 + z50 * z637 - z49 * z640
            z647 = s116 - z27 * z646
            z648 = z15 * z610 - z14 * z613
            z649 = z15 * z637 - z14 * z640
            s117 = z325 * z426 - z198 * z472 - z8 * z610 + z42 * z637
            z650 = s117 - z14 * z646
            s118 = z325 * z427 + z198 * z499 + z8 * z613 - z42 * z640
            z651 = s118 + z15 * z646
            s119 = z317 * z440 - z200 * z500 + z21 * z648 - z48 * z649
            z652 = s119 - z25 * z650 - z19 * z651
            z653 = z15 * z625 - z14 * z628
            s120 = z309 * z440 - z199 * z500 + z9 * z653 + z47 * z649
            z654 = s120 + z24 * z650 + z26 * z651
            z655 = z333 * z419 + z339 * z423
            s121 = z380 * z397 + z82 * z574 - k28 * z581 - k27 * z582
            z656 = roll_dot * z655 - (s121 + k26 * z583)
            z657 = z40 * z645
            z658 = z16 * z637 + z14 * z657
            z659 = z16 * z640 + z15 * z657
            z660 = z31 * z649 - z24 * z658 + z26 * z659
            z661 = z35 * z649 + z25 * z658 - z19 * z659
            z662 = s_steer * z660 - c_steer * z661
            z663 = z656 - z588 - z662
            s122 = z319 * z482 - z300 * z478 + z344 * z522 + z297 * z465
            z664 = s122 - z294 * z524 + z44 * z663
            s123 = z338 * z419 + z326 * z427 - z328 * z437 + z211 * z468
            z665 = s123 + z204 * z499 + z202 * z515
            z666 = z40 * z642
            z667 = z40 * z643
            s124 = z665 - z142 * z604 - z136 * z613 - z130 * z666 - z100 * z619
            z668 = s124 + z94 * z628 + z87 * z667
            s125 = z326 * z426 + z318 * z437 + z279 * z439 - z204 * z472
            z669 = s125 - z201 * z515 + z136 * z610
            s126 = z669 + z129 * z666 - z94 * z625 - z86 * z667 - z56 * z637
            z670 = s126 + z49 * z657 - z36 * z646
            z671 = z670 - e2z * z647
            s127 = z668 - z62 * z632 + z56 * z640 - z50 * z657 + z37 * z646
            z672 = s127 + z671
            s128 = z338 * z423 - z211 * z469 + z280 * z476 - z275 * z477
            z673 = s128 - z142 * z608 - z100 * z623
            z674 = z16 * z613 + z15 * z666
            s129 = z325 * z437 - z198 * z515 - z8 * z666 + z42 * z657
            z675 = s129 + z16 * z646
            s130 = z317 * z442 + z200 * z517 - z21 * z674 + z48 * z659
            z676 = s130 + z35 * z651 + z25 * z675
            z677 = z16 * z610 + z14 * z666
            s131 = z317 * z441 + z279 * z444 - z200 * z516 + z21 * z677
            z678 = s131 - z48 * z658 + z35 * z650
            z679 = z678 - z19 * z675 - e2z * z652
            z680 = z16 * z625 - z14 * z667
            s132 = z309 * z441 + z279 * z446 - z199 * z516 + z9 * z680
            z681 = s132 + z47 * z658 + z31 * z650
            z682 = z681 + z26 * z675 - e2z * z654
            z683 = z280 * z453 - z275 * z454 - s_steer * z679 - c_steer * z682
            z684 = z16 * z628 - z15 * z667
            s133 = z309 * z442 + z199 * z517 - z9 * z684 - z47 * z659
            z685 = s133 + z31 * z651 - z24 * z675
            z686 = z673 - z62 * z635 + s_steer * z676 - z683 + c_steer * z685
            s134 = z276 * z525 - z597 - z11 * z647 + z30 * z652 - z34 * z654
            s135 = z12 * (z185 * (z187 * z520 - z664 + z13 * z672 - z17 * z686))
            z687 = z186 * z521 + s134 - c_roll * s135
            z688 = k76 * z411 + k75 * z412 - k72 * z413
            s136 = k69 * z398 + k67 * z400 + r_R * (z296 * z482 + z12 * z672)
            z689 = z275 * z463 - (s_steer * z688 + s136)
            z690 = z37 * z472 - z36 * z499 - z27 * z515
            s137 = z289 * z443 - z310 * z438 + z195 * z519 - z193 * z690
            z691 = s137 + z37 * z610 - z36 * z613
            z692 = z37 * z637 - z36 * z640 - z27 * z657
            s138 = z275 * z447 + z280 * z449 - z35 * z653 - z25 * z680
            z693 = s138 + z19 * z684 - z41 * z692
            z694 = z276 * z439 + c_roll * z647
            z695 = z281 * z448 + s1 * z694
            z696 = z276 * z444 + c_roll * z652
            z697 = z277 * z450 - c1 * z696
            s139 = z693 + c_steer * z671 - s_steer * z695 - z697
            z698 = z691 - z27 * z666 - s1 * z661 + s139
            s140 = z283 * z462 - k74 * z401 - k72 * z407 - k71 * z401
            z699 = s140 - r_F * (z286 * z452 - z6 * z698)
            s141 = z310 * z445 + z293 * z443 + z193 * z518 + z196 * z519
            z700 = s141 - z31 * z648 + z24 * z677
            z701 = z281 * z450 + s1 * z696
            z702 = z276 * z446 + c_roll * z654
            z703 = z281 * z457 + s1 * z702
            s142 = z275 * z456 + z280 * z458 + c_steer * z701 - s_steer * z703
            z704 = z700 - z26 * z674 + z41 * z660 - z43 * z661 + (z683 - s142)
            s143 = z287 * z452 - z290 * z459 + z284 * z461 - z7 * z698
            z705 = z6 * (z188 * (s143 + z20 * z704))
            z706 = z285 * z460 * z381 + 0.5 * z705
            z707 = z699 + 2.0 * (z4 * z706)
            z708 = z689 + c_steer * z707
            s144 = z278 * z462 - k73 * z401 + k72 * z402 + k70 * z401
            z709 = s144 - k68 * z398 + k67 * z399
            s145 = z709 + r_F * (z286 * z459 + z6 * z704)
            z710 = s145 + r_R * (z296 * z478 + z12 * z686) - 2.0 * (z2 * z706)
            s146 = z687 + r_R * (z296 * z522 - z12 * z663) - s1 * z708
            z711 = roll_dot * z464 + (s146 - c1 * z710)
            z712 = z12 * z465
            s147 = z207 * z435 + r_R * (z12 * z522) + z11 * z439 - z30 * z444
            z713 = s147 + z34 * z446 + z186 * z712
            z714 = z713 - c_roll * z525 + s1 * z483 - c1 * z479
            s148 = z330 * z425 + z323 * z439 - z307 * z444 + z315 * z446
            z715 = s148 + z207 * z497 - k68 * z428
            s149 = z715 - k69 * z429 + k67 * z430 + z132 * z612 - z89 * z627
            z716 = s149 - z52 * z639 - z15 * z647
            s150 = z280 * z463 - (z716 + z24 * z652 + z25 * z654)
            z717 = c_steer * z688 - (roll_dot * z714 + s150) + s_steer * z707
            J[offset2 + 4] = c_roll * z717 - e2z * z711
            z718 = z291 * z443 - z21 * z519 - k16 * z519
            z719 = z291 * z445 + z288 * z438 - z21 * z518 - z8 * z690
            z720 = z719 - (k16 * z518 + k4 * z690)
            s151 = z506 + z275 * z473 + z280 * z474 - c_steer * z718
            z721 = s151 + s_steer * z720
            s152 = z334 * z434 - z304 * z450 + z209 * z484 + z332 * z511
            z722 = s152 + z133 * z541 + z90 * z565
            z723 = z22 * z661
            z724 = z9 * z692 + z21 * z660 + k16 * z660
            s153 = z313 * z457 - (z595 + (z722 - z53 * z589)) + c_steer * z723
            z725 = s153 - s_steer * z724 + z29 * z696
            z726 = z288 * z443 - z8 * z519 - k4 * z519
            z727 = z726 + (z511 - k10 * z520)
            s154 = z334 * z431 - z321 * z448 - z303 * z450 - z312 * z457
            z728 = s154 - z209 * z480 - z332 * z506
            s155 = z728 + z133 * z550 - z90 * z572 - z589 - z53 * z595
            z729 = s155 + z8 * z661 + k4 * z661
            s156 = z729 + z10 * z694 - z28 * z696 + z32 * z702
            z730 = z276 * z483 + (roll_dot * z727 + s156 - k10 * z662)
            s157 = z276 * z479 - (roll_dot * z721 - (z725 - z33 * z702))
            z731 = s1 * (s157 - c_roll * z710) + c1 * (z730 + c_roll * z708)
            J[offset2 + 5] = -z731
            s158 = z333 * z414 - z210 * z408 + z197 * z443 - z191 * z473
            z732 = s158 + z9 * z447 + k10 * z451
            z733 = z732 - z23 * z454 + z22 * z456 + z18 * z477 - z3 * z463
            s159 = z343 * z420 - z348 * z421 + z335 * z408 + z331 * z414
            z734 = s159 - z333 * z490 + z298 * z445
            s160 = z734 - z292 * z474 + z288 * z449 + z306 * z453 - z301 * z476
            z735 = s160 + z291 * z458 - z210 * z496
            s161 = z735 + z145 * z547 + z141 * z549 + z143 * z537 - z135 * z540
            z736 = s161 - z103 * z569 + z99 * z571
            s162 = z736 + z101 * z561 + z93 * z564 + z65 * z592 + z61 * z594
            z737 = s162 + z63 * z584 + z55 * z587
            s163 = z191 * z720 + (z197 * z518 - z737) - z46 * z660 + c1 * z724
            z738 = s163 + z9 * z695 + z23 * z679
            s164 = k10 * (z277 * z457 - c1 * z702)
            z739 = z3 * z688 - (z738 + z18 * z676 + z22 * z703 - s164)
            s165 = z333 * z408 + z210 * z414 + z197 * z445 - z191 * z474
            z740 = s165 + z9 * z449 + z23 * z453
            s166 = z740 - z18 * z476 + z22 * z458 + k10 * (c1 * z457)
            z741 = s166 - e2z * z463
            s167 = z348 * z420 + z343 * z421 + z335 * z414 - z331 * z408
            z742 = s167 - z333 * z496 + z298 * z443
            s168 = z742 - z292 * z473 + z288 * z447 - z306 * z454 + z291 * z456
            z743 = s168 + z301 * z477 + z282 * z463
            s169 = z743 + z210 * z490 - z141 * z547 + z145 * z549 + z135 * z537
            z744 = s169 + z143 * z540 - z99 * z569
            s170 = z744 - z103 * z571 - z93 * z561 + z101 * z564 - z61 * z592
            z745 = s170 + z65 * z594 - z55 * z584
            s171 = z191 * z718 + (z197 * z519 - (z745 + z63 * z587))
            z746 = s171 - z46 * z661 + c1 * z723 + z9 * z671
            s172 = z746 - k10 * z697 - z23 * z682 + z22 * z701 - z18 * z685
            z747 = steer_dot * z741 + (s172 - z3 * z707)
            s173 = steer_dot * z733 - (z279 * z463 - z739) + e2z * z707
            z748 = c_steer * s173 - s_steer * (e2z * z688 + z747)
            J[offset2 + 6] = z748
            s174 = z277 * z475 + z281 * z481 + z345 * z467 + z45 * z655
            z749 = s174 + r_R * (z276 * z712 - c_roll * z521)
            s175 = z749 + c1 * z721 + s1 * z727 + e2z * z714
            J[offset2 + 9] = c_roll * z464 - s175
            J[offset2 + 10] = s_steer * z733 - (z508 + z726 - c_steer * z741)
            J[offset2 + 11] = z719 - z489
        _finish("jacobian", J)
        return [J[k79 : k79 + 12] for k79 in range(0, 144, 12)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """the spec's outputs

    Arguments: t (scalar), y (12,), p (26,).
    Returns out (3,).
    """
    z = float(y[2])  # centre of the rear wheel, downwards [m]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thF_dot = float(y[11])
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    try:
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = c_lam * k1 - r_R * s_lam
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        k5 = abs(r_R)
        k6 = abs(r_F)
        k7 = abs(w)
        k8 = abs(c)
        k9 = 9.0 * k6
        k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9))
        k11 = 6.0 * k7
        k12 = 13.0 * k8 + (14.0 * k6 + k11)
        k13 = 10.0 * k8 + (k9 + k11)
        # state
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z1 = e2z * s_steer
        c_steer = math.cos(steer)
        c_roll = math.cos(roll)
        s_pitch = math.sin(pitch)
        c_pitch = math.cos(pitch)
        z2 = s_pitch * c_lam + c_pitch * s_lam
        z3 = c_roll * z2
        z4 = z1 - c_steer * z3
        z5 = c_pitch * c_lam - s_pitch * s_lam
        z6 = c_roll * z5
        z7 = r_F / math.sqrt(z6 * z6 + z4 * z4)
        z8 = z4 * z7
        z9 = k2 + z8
        z10 = c_roll * c_roll
        z11 = 1.0 / math.sqrt(z10)
        z12 = r_R * z11
        z13 = z3 * z12
        z14 = k3 + z13 + c_steer * z9
        z15 = z9 * (s_steer * z3) + e2z * z14
        z16 = z6 * z12
        z17 = c_steer * z16
        z18 = z6 * z7
        z19 = k4 + z18
        z20 = z16 - z19
        z21 = s_steer * z20
        z22 = c_steer * z20
        z23 = s_steer * z16
        z24 = z2 * z19
        s1 = c_roll * (c_steer * z24 + z5 * (c_steer * k3 + z9))
        z25 = s1 + e2z * z21
        z26 = c_roll * (s_steer * z24 + k3 * (s_steer * z5)) - e2z * z22
        z27 = z22 * z25 + z26 * z21
        s2 = z15 * (z17 * z21 - z22 * z23)
        z28 = s2 - z14 * (z17 * z25 + z26 * z23) + z13 * z27
        z29 = k5 * (9.0 + abs(z11))
        s3 = (z29 + k12) * (z29 + k13)
        # the coframe is singular
        if not abs(z28) > 1e-12 * (k10 * s3):
            raise SingularModelError(1, "outputs")
        z30 = roll_dot * z5
        z31 = s_steer * z30
        z32 = thF_dot - z31
        z33 = roll_dot * z2
        z34 = steer_dot + z33
        z35 = c_steer * z30
        z36 = c_roll * (roll_dot * z12) + k3 * z33
        z37 = z34 * z8 - z35 * z18 - (k4 * z35 - k2 * z34 - c_steer * z36)
        z38 = z32 * z18 - (k4 * z31 - s_steer * z36)
        s4 = z15 * (z22 * z37 + z21 * z38)
        s5 = s4 - z14 * (z25 * z38 - z26 * z37)
        z39 = z27 * (k2 * z31 - z32 * z8) + s5
        z40 = s_pitch * c_roll
        e3z = c_pitch * c_roll
        z41 = c_steer * (z40 * c_lam + e3z * s_lam) - z1
        z42 = z40 * s_lam - e3z * c_lam
        z43 = c_lam * z41 + s_lam * z42
        z44 = c_lam * z42 - s_lam * z41
        z45 = r_F * z44
        z46 = z43 * z43
        z47 = 1.0 / math.sqrt(z46 + z44 * z44)
        s6 = z - z40 * k1 + r_R * e3z + c * z43 + z45 + r_F * (z46 * z47)
        z48 = s6 + z47 * (z44 * z45)
        out: list[float] = [
            # speed 123:10
            -r_R * (z39 / z28),
            # rear_height 124:16
            z + r_R * (z10 / math.sqrt(z40 * z40 + e3z * e3z)),
            # front_height 125:17
            z48,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
