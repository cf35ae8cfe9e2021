"""bicycle, emitted by nhc 0.1.0 (nhc:68a81b375983e2d4).

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
rhs: 647 +-, 980 *, 8 /, 16 calls
velocities: 101 +-, 177 *, 3 /, 16 calls
accelerations: 267 +-, 426 *, 6 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 185 *, 2 /, 12 calls
reactions: 567 +-, 865 *, 5 /, 12 calls
energy: 214 +-, 349 *, 3 /, 12 calls
jacobian: 4250 +-, 5860 *, 11 /, 16 calls
outputs: 93 +-, 157 *, 3 /, 14 calls

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
        k3 = r_F * s_lam - c * c_lam
        k4 = H_zz + F_xx
        k5 = H_xx + F_xx
        k6 = z_H * s_lam - c_lam * (x_H - k2)
        k7 = x_H * s_lam + c_lam * (r_R + z_H)
        k8 = c_lam * k2 - r_R * s_lam
        k9 = s_lam * k8
        k10 = c_lam * k8
        k11 = c_lam * c_lam
        k12 = w * s_lam + c_lam * (r_R - r_F)
        k13 = s_lam * s_lam
        k14 = s_lam * k3 - c_lam * k12
        k15 = c_lam * k3 + s_lam * k12
        k16 = abs(r_R)
        k17 = abs(r_F)
        k18 = abs(w)
        k19 = abs(c)
        k20 = 18.0 * k19 + (18.0 * k18 + (34.0 * k16 + 19.0 * k17))
        k21 = m_R + m_B
        k22 = m_B * k1
        k23 = x_B * m_B
        k24 = k1 * k22
        k25 = R_xx + B_xx + k24
        k26 = x_B * k23
        k27 = k24 + (B_yy + k26)
        k28 = B_xz - k1 * k23
        k29 = R_xx + B_zz + k26
        k30 = m_F * k12
        k31 = m_H + m_F
        k32 = m_H * k7
        k33 = k30 + k32
        k34 = m_F * k3
        k35 = m_H * k6
        k36 = k34 - k35
        k37 = H_xz * c_lam
        k38 = s_lam * k4 - k37
        k39 = H_xz * s_lam
        k40 = c_lam * k5 - k39
        k41 = k12 * k30
        k42 = k7 * k32
        k43 = c_lam * k40 + s_lam * k38 + k41 + k42
        k44 = s_lam * k40 - c_lam * k38 - k3 * k30 + k6 * k32
        k45 = k3 * k34
        k46 = k6 * k35
        k47 = k42 + (k41 + (H_yy + k45) + k46)
        k48 = k39 + c_lam * k4
        k49 = k37 + s_lam * k5
        k50 = c_lam * k49 - s_lam * k48 - k12 * k34 + k7 * k35
        k51 = k46 + (k45 + (s_lam * k49 + c_lam * k48))
        k52 = g * m_F
        k53 = g * m_H
        k54 = g * m_B
        k55 = g * k21
        k56 = x_B * k54
        k57 = k1 * k54
        k58 = k6 * k53
        k59 = k7 * k53
        k60 = g * k31
        k61 = k3 * k52
        k62 = k12 * k52
        k63 = k59 + k62
        k64 = k58 - k61
        # state
        c_roll = math.cos(roll)
        s_pitch = math.sin(pitch)
        s_steer = math.sin(steer)
        z1 = s_lam * s_steer
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = r_R * e3z
        z3 = s_pitch * c_roll
        z4 = z3 * z3 + e3z * e3z
        z5 = 1.0 / math.sqrt(z4)
        R3 = z2 * z5
        z6 = R3 + k9
        c_steer = math.cos(steer)
        z7 = z3 * c_lam + e3z * s_lam
        e2z = math.sin(roll)
        z8 = c_steer * z7 - e2z * s_steer
        z9 = z3 * s_lam - e3z * c_lam
        z10 = c_lam * z8 + s_lam * z9
        z11 = r_F * z10
        z12 = c_lam * z9 - s_lam * z8
        z13 = z10 * z10 + z12 * z12
        z14 = 1.0 / math.sqrt(z13)
        z15 = z11 * z14
        z16 = z15 - k15
        z17 = s_steer * z16
        z18 = z1 * z6 + c_lam * z17
        z19 = r_R * z3
        z20 = z19 * z5
        z21 = z20 + k10
        z22 = z1 * z21 - s_lam * z17
        z23 = s_pitch * z18 - c_pitch * z22
        z24 = s_lam * c_steer
        z25 = k11 + s_lam * z24
        z26 = c_lam * (s_lam - z24)
        z27 = z20 * z25 + R3 * z26
        z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16
        z29 = c_roll * z23 - e2z * z28
        z30 = c_lam * c_steer
        z31 = s_lam * (c_lam - z30)
        z32 = c_lam * z30 + k13
        z33 = z20 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z20 * z1
        z36 = r_F * z12
        z37 = z36 * z14
        z38 = k12 - c_lam * z37 - s_lam * z15
        z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38
        z40 = z37 + k14
        z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40
        z42 = z33 * z39 - z41 * z35
        z43 = c_steer * z38
        z44 = s_lam * z37
        z45 = c_lam * z15
        z46 = k3 + z44 - z45
        z47 = c_steer * z6 - c_lam * z43 + s_lam * z46
        z48 = c_steer * z21 + s_lam * z43 + c_lam * z46
        z49 = s_pitch * z47 - c_pitch * z48
        z50 = c_roll * z49 - e2z * z39
        z51 = s_steer * z40
        z52 = z34 * z6 + c_lam * z51
        z53 = z34 * z21 - s_lam * z51
        z54 = s_pitch * z52 - c_pitch * z53
        z55 = c_roll * z54 + e2z * z41
        z56 = z33 * z50 + z55 * z35
        z57 = z41 * z50 + z55 * z39
        z58 = z29 * z42 - z28 * z56 + z27 * z57
        s1 = 24.0 * k16
        s2 = s1 + 33.0 * k17
        s3 = 14.0 * k18 + s2
        s4 = k20 * (13.0 * k19 + s3)
        # the coframe is singular
        if not abs(z58) > 1e-12 * (k20 * s4):
            raise SingularModelError(1, "rhs")
        z59 = 1.0 / z58
        z60 = s_pitch * s_lam - c_pitch * c_lam
        z61 = s_steer * z60
        z62 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20)
        z63 = k12 * z61 + s_steer * z62
        z64 = k3 * z61
        z65 = z15 * z61 - (s_lam * z63 + c_lam * z64)
        z66 = c_pitch * s_lam + s_pitch * c_lam
        z67 = c_steer * z60
        s5 = z37 * (s_lam * z66 - c_lam * z67)
        s6 = s5 - z15 * (s_lam * z67 + c_lam * z66)
        z68 = s6 + (k12 * z67 + k3 * z66 + c_steer * z62)
        z69 = z37 * z61 + (s_lam * z64 - c_lam * z63)
        z70 = z33 * z68 - z35 * z69
        z71 = z41 * z68 - z39 * z69
        z72 = z59 * (z42 * z65 + z28 * z70 - z27 * z71)
        z73 = c_roll * z72
        z74 = s_pitch - c_pitch * z73
        z75 = c_pitch + s_pitch * z73
        z76 = c_lam * z74 + s_lam * z75
        z77 = R3 * z75 + z20 * z74
        z78 = z77 + (k10 * z74 + k9 * z75)
        z79 = z50 * z69 + z55 * z68
        z80 = z59 * (z29 * z70 + z56 * z65 + z27 * z79) + e2z * z72
        z81 = z59 * (z29 * z71 + z28 * z79 + z57 * z65) - z80
        z82 = R3 * z81
        z83 = z82 - k9 * z80
        z84 = z20 * z81
        z85 = z84 - k10 * z80
        z86 = c_lam * z83 - s_lam * z85
        z87 = c_steer * z78 + s_steer * z86
        z88 = c_lam * z75 - s_lam * z74
        z89 = s_steer * z80 - c_steer * z88
        z90 = k51 * z76 + (k36 * z87 - k50 * z89)
        z91 = c_steer * z80 + s_steer * z88
        z92 = c_steer * z86 - s_steer * z78
        z93 = c_lam * z85 + s_lam * z83
        z94 = k47 * z91 + (k33 * z92 - k36 * z93)
        z95 = k44 * z76 - (k33 * z87 + k43 * z89)
        z96 = k31 * z93 - k36 * z91
        z97 = k36 * z76 + (k31 * z87 + k33 * z89)
        z98 = k31 * z92 + k33 * z91
        z99 = z74 * k29 + (z77 * k23 + z75 * k28)
        z100 = z80 * k27 + (z82 * k22 - z84 * k23)
        z101 = z74 * k28 - (z77 * k22 - z75 * k25)
        z102 = z84 * k21 - z80 * k23
        z103 = z82 * k21 + z80 * k22
        z104 = z74 * k23 + (z77 * k21 - z75 * k22)
        s7 = z75 * z101 + (z84 * z102 + (z82 * z103 + z77 * z104))
        z105 = z74 * z99 + (z80 * z100 + s7)
        s8 = z89 * z95 - (z93 * z96 + (z87 * z97 + (z92 * z98 + z105)))
        z106 = z76 * z90 + (z91 * z94 - s8)
        z107 = z106 + R_yy * (z81 * z81) + F_yy * (z91 * z91)
        # the mass matrix is singular
        if not abs(z107) > 0.0:
            raise SingularModelError(2, "rhs")
        z108 = k3 + (z44 - z45)
        z109 = z33 * z108
        z110 = z41 * z108
        z111 = z59 * (z28 * z109 - z27 * z110)
        z112 = c_roll * z111
        z113 = c_pitch * z112
        z114 = s_pitch * z112
        z115 = 1.0 - (c_lam * z113 - s_lam * z114)
        z116 = R3 * z114 - z20 * z113
        z117 = z116 - (k10 * z113 - k9 * z114)
        z118 = z55 * z108
        z119 = z59 * (z29 * z109 + z27 * z118) + e2z * z111
        z120 = z59 * (z29 * z110 + z28 * z118) - z119
        z121 = R3 * z120
        z122 = z121 - k9 * z119
        z123 = z20 * z120
        z124 = z123 - k10 * z119
        z125 = c_lam * z122 - s_lam * z124
        z126 = c_steer * z117 + s_steer * z125
        z127 = c_lam * z114 + s_lam * z113
        z128 = s_steer * z119 - c_steer * z127
        z129 = k51 * z115 + (k36 * z126 - k50 * z128)
        z130 = c_steer * z119 + s_steer * z127
        z131 = c_steer * z125 - s_steer * z117
        z132 = c_lam * z124 + s_lam * z122
        z133 = k47 * z130 + (k33 * z131 - k36 * z132)
        z134 = k44 * z115 - (k33 * z126 + k43 * z128)
        z135 = k31 * z132 - k36 * z130
        z136 = k36 * z115 + (k31 * z126 + k33 * z128)
        z137 = k31 * z131 + k33 * z130
        z138 = z113 * k29 - (z116 * k23 + z114 * k28)
        z139 = z119 * k27 + (z121 * k22 - z123 * k23)
        z140 = z113 * k28 + (z116 * k22 - z114 * k25)
        z141 = z123 * k21 - z119 * k23
        z142 = z121 * k21 + z119 * k22
        z143 = z113 * k23 - (z116 * k21 - z114 * k22)
        s9 = z114 * z140 - (z123 * z141 + (z121 * z142 - z116 * z143))
        z144 = z113 * z138 + (z119 * z139 - s9)
        s10 = z132 * z135 + (z126 * z136 + (z131 * z137 + z144))
        z145 = z115 * z129 + (z130 * z133 - (z128 * z134 - s10))
        z146 = z145 + R_yy * (z120 * z120) + F_yy * (z130 * z130)
        s11 = z114 * z101 + (z123 * z102 + (z121 * z103 + z116 * z104))
        z147 = z113 * z99 - (z119 * z100 + s11)
        s12 = z128 * z95 - (z132 * z96 + (z126 * z97 + (z131 * z98 - z147)))
        z148 = z115 * z90 + (z130 * z94 - s12)
        z149 = R_yy * z81
        z150 = F_yy * z91
        z151 = z148 + z120 * z149 + z130 * z150
        z152 = 1.0 / z107
        z153 = z152 * z151
        z154 = z146 - z151 * z153
        # the mass matrix is singular
        if not abs(z154) > 1e-14 * z146:
            raise SingularModelError(2, "rhs")
        z155 = z37 * z35
        z156 = z37 * z39
        z157 = z59 * (z15 * z42 - z28 * z155 + z27 * z156)
        z158 = c_roll * z157
        z159 = c_pitch * z158
        z160 = s_pitch * z158
        z161 = c_lam * z159 - s_lam * z160
        z162 = R3 * z160 - z20 * z159
        z163 = z162 - (k10 * z159 - k9 * z160)
        z164 = z37 * z50
        z165 = z59 * (z29 * z155 - z15 * z56 - z27 * z164) - e2z * z157
        z166 = z59 * (z29 * z156 - z28 * z164 - z15 * z57) - z165
        z167 = R3 * z166
        z168 = z167 - k9 * z165
        z169 = z20 * z166
        z170 = z169 - k10 * z165
        z171 = c_lam * z168 - s_lam * z170
        z172 = c_steer * z163 - s_steer * z171
        z173 = c_lam * z160 + s_lam * z159
        z174 = s_steer * z165 + c_steer * z173
        z175 = c_steer * z165 - s_steer * z173
        z176 = c_steer * z171 + s_steer * z163
        z177 = c_lam * z170 + s_lam * z168
        s13 = z162 * (z159 * k23 - (z162 * k21 - z160 * k22))
        z178 = z167 * (z167 * k21 + z165 * k22) - s13
        s14 = z160 * (z159 * k28 + (z162 * k22 - z160 * k25))
        z179 = s14 - (z169 * (z169 * k21 - z165 * k23) + z178)
        s15 = z165 * (z165 * k27 + (z167 * k22 - z169 * k23)) - z179
        z180 = z159 * (z159 * k29 - (z162 * k23 + z160 * k28)) + s15
        s16 = z172 * (k36 * z161 - (k31 * z172 - k33 * z174))
        z181 = s16 - (z176 * (k31 * z176 + k33 * z175) + z180)
        s17 = z174 * (k44 * z161 + (k33 * z172 - k43 * z174))
        z182 = s17 - (z177 * (k31 * z177 - k36 * z175) - z181)
        s18 = z175 * (k47 * z175 + (k33 * z176 - k36 * z177)) - z182
        z183 = z161 * (k51 * z161 - (k36 * z172 + k50 * z174)) + s18
        z184 = 1.0 + z175
        z185 = z183 + R_yy * (z166 * z166) + F_yy * (z184 * z184)
        s19 = z160 * z101 - (z169 * z102 + (z167 * z103 - z162 * z104))
        z186 = z159 * z99 + (z165 * z100 - s19)
        s20 = z174 * z95 - (z177 * z96 - (z172 * z97 - (z176 * z98 + z186)))
        z187 = z161 * z90 + (z175 * z94 - s20)
        z188 = z187 + z166 * z149 + z184 * z150
        z189 = z152 * z188
        s21 = z160 * z140 + (z169 * z141 + (z167 * z142 + z162 * z143))
        z190 = z159 * z138 - (z165 * z139 + s21)
        s22 = z177 * z135 - (z172 * z136 - (z176 * z137 - z190))
        z191 = z161 * z129 + (z175 * z133 - (z174 * z134 - s22))
        z192 = R_yy * z120
        z193 = F_yy * z130
        z194 = z191 + z166 * z192 + z184 * z193 - z151 * z189
        z195 = 1.0 / z154
        z196 = z194 * z195
        z197 = z185 - z188 * z189 - z194 * z196
        # the mass matrix is singular
        if not abs(z197) > 1e-14 * z185:
            raise SingularModelError(2, "rhs")
        c_yaw = math.cos(yaw)
        z198 = roll_dot * c_pitch
        z199 = roll_dot * s_pitch
        z200 = steer_dot + (s_lam * z198 + c_lam * z199)
        z201 = s_lam * z199 - c_lam * z198
        z202 = c_steer * z201
        z203 = s_lam * z200 - c_lam * z202
        z204 = s_lam * z202 + c_lam * z200
        z205 = z198 * k9 + z199 * k10 + (z198 * R3 + z199 * z20)
        s23 = k12 * z202 + k3 * z200 + c_steer * z205
        z206 = z37 * z203 - z15 * z204 + s23
        z207 = s_steer * z201
        z208 = thF_dot + z207
        z209 = k3 * z207
        z210 = k12 * z207 + s_steer * z205
        z211 = z37 * z208 + (s_lam * z209 - c_lam * z210)
        z212 = z41 * z206 - z39 * z211
        z213 = z50 * z211 + z55 * z206
        z214 = z15 * z208 - (s_lam * z210 + c_lam * z209)
        z215 = z59 * (z29 * z212 + z28 * z213 + z57 * z214)
        z216 = z33 * z206 - z35 * z211
        z217 = z59 * (z29 * z216 + z56 * z214 + z27 * z213)
        z218 = z59 * (z42 * z214 + z28 * z216 - z27 * z212)
        z219 = z217 + e2z * z218
        z220 = z215 - z219
        a3 = z20 * z220
        a1 = R3 * z220
        z221 = s_pitch * a3 + c_pitch * a1
        s_yaw = math.sin(yaw)
        z222 = s_pitch * a1 - c_pitch * a3
        z223 = c_roll * z218
        w1_pitch = z198 + s_pitch * z223
        w3_pitch = z199 - c_pitch * z223
        v2_x = R3 * w1_pitch + z20 * w3_pitch
        z224 = e2z * z222 - c_roll * v2_x
        h2z = e2z * c_steer + s_steer * z7
        z225 = c_lam * w1_pitch - s_lam * w3_pitch
        z226 = s_steer * z219 - c_steer * z225
        z227 = c_steer * z219 + s_steer * z225
        z228 = F_yy * (thF_dot - z227) - k47 * z227
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z229 = k43 * z226 - k44 * w3_steer
        z230 = c_pitch * z217
        z231 = roll_dot * z230
        z232 = s_pitch * z217
        z233 = roll_dot * e2z
        z234 = steer_dot * c_steer
        z235 = roll_dot * z232
        z236 = s_lam * z231 + c_lam * z235
        z237 = z234 * z201 - s_steer * z236
        z238 = roll_dot * c_roll
        z239 = steer_dot * s_steer
        z240 = s_pitch * z233 + c_roll * z230
        z241 = c_pitch * z233 - c_roll * z232
        s24 = z7 * z239 + c_steer * (c_lam * z240 + s_lam * z241)
        z242 = s_steer * z238 + e2z * z234 + s24
        z243 = s_lam * z240 - c_lam * z241
        z244 = c_lam * z242 + s_lam * z243
        z245 = r_F * z14
        z246 = c_lam * z243 - s_lam * z242
        z247 = (z10 * z244 + z12 * z246) * (z14 / z13)
        z248 = z244 * z245 - z11 * z247
        z249 = k3 * z237
        z250 = r_R * z5
        z251 = (z3 * z240 + e3z * z241) * (z5 / z4)
        z252 = z250 * z241 - z2 * z251
        z253 = z250 * z240 - z19 * z251
        s25 = R3 * z235 - z198 * z252 - (z20 * z231 + z199 * z253)
        z254 = k9 * z235 - k10 * z231 + s25
        z255 = k12 * z237 + (z234 * z205 + s_steer * z254)
        z256 = s_lam * z239
        z257 = s_lam * z256
        z258 = c_lam * z256
        z259 = z20 * z257 + z25 * z253 - (R3 * z258 - z26 * z252)
        z260 = s_lam * z234
        z261 = z234 * z16 - s_steer * z248
        z262 = z1 * z253
        s26 = s_pitch * (z6 * z260 - z1 * z252 + c_lam * z261)
        s27 = z22 * z232 + c_pitch * (z21 * z260 - z262 - s_lam * z261)
        z263 = z18 * z230 - s26 + s27
        z264 = k10 * z257 - k9 * z258 + z259 - (z239 * z16 + c_steer * z248)
        s28 = z233 * z23 + c_roll * z263 + (z238 * z28 - e2z * z264)
        z265 = z215 * z259 + (z218 * s28 - z217 * z264)
        s29 = z15 * z237 - z208 * z248 - (c_lam * z249 + s_lam * z255)
        z266 = s29 + z265
        z267 = s_lam * z235 - c_lam * z231
        z268 = z239 * z201 + c_steer * z236
        z269 = z246 * z245 - z36 * z247
        s30 = z37 * (s_lam * z267 + c_lam * z268) - z203 * z269
        z270 = s30 + (z15 * (s_lam * z268 - c_lam * z267) + z204 * z248)
        z271 = c_lam * z234
        z272 = z34 * z252
        z273 = R3 * z271 - z272 - (z20 * z260 - z262)
        z274 = c_lam * z269 + s_lam * z248
        z275 = z239 * z38 - c_steer * z274
        z276 = s_lam * z269 - c_lam * z248
        s31 = z239 * z6 + c_steer * z252 - c_lam * z275 + s_lam * z276
        s32 = z239 * z21 + c_steer * z253 + s_lam * z275 + c_lam * z276
        z277 = z47 * z230 + s_pitch * s31 + (z48 * z232 - c_pitch * s32)
        z278 = k9 * z271 - k10 * z260 + z273 - (z234 * z38 + s_steer * z274)
        s33 = z233 * z49 + c_roll * z277 + (z238 * z39 + e2z * z278)
        z279 = z215 * z273 - (z218 * s33 + z217 * z278)
        s34 = k12 * z268 - k3 * z267 + (z239 * z205 - c_steer * z254)
        z280 = z270 - s34 + z279
        z281 = c_lam * z239
        z282 = s_lam * z281
        z283 = c_lam * z281
        z284 = z20 * z282 - z31 * z253 - (R3 * z283 + z32 * z252)
        z285 = z234 * z40 - s_steer * z269
        s35 = c_pitch * (z21 * z271 - z34 * z253 - s_lam * z285)
        s36 = z52 * z230 - s_pitch * (z6 * z271 - z272 + c_lam * z285)
        z286 = s36 + (z53 * z232 + s35)
        z287 = k10 * z282 - k9 * z283 + z284 - (z239 * z40 + c_steer * z269)
        s37 = z233 * z54 + c_roll * z286 - (z238 * z41 + e2z * z287)
        z288 = z215 * z284 + (z218 * s37 - z217 * z287)
        s38 = z37 * z237 - z208 * z269 + (s_lam * z249 - c_lam * z255)
        z289 = s38 + z288
        z290 = z33 * z280 - z35 * z289
        z291 = z41 * z280 - z39 * z289
        z292 = z59 * (z42 * z266 + z28 * z290 - z27 * z291)
        z293 = z233 * z218 - c_roll * z292
        z294 = z231 + (z223 * z232 - c_pitch * z293)
        z295 = z235 - (z223 * z230 + s_pitch * z293)
        z296 = c_lam * z294 - s_lam * z295
        s39 = w1_pitch * z252 - R3 * z295 + (w3_pitch * z253 + z20 * z294)
        z297 = a1 * w3_pitch - a3 * w1_pitch + s39
        z298 = k9 * z219
        z299 = k10 * z219
        s40 = w3_pitch * z298 - w1_pitch * z299 - (k10 * z294 - k9 * z295)
        z300 = z297 - s40
        z301 = z50 * z289 + z55 * z280
        s41 = z59 * (z29 * z290 + z56 * z266 + z27 * z301)
        z302 = s41 + (z238 * z218 + e2z * z292)
        z303 = z59 * (z29 * z291 + z28 * z301 + z57 * z266) - z302
        z304 = z219 * a3 - w3_pitch * v2_x + (z220 * z252 - R3 * z303)
        z305 = k10 * w3_pitch + k9 * w1_pitch
        z306 = z304 - (z219 * z299 + w3_pitch * z305 - k9 * z302)
        z307 = w1_pitch * v2_x - z219 * a1 + (z220 * z253 - z20 * z303)
        z308 = z307 + (w1_pitch * z305 + z219 * z298 + k10 * z302)
        z309 = c_lam * z306 - s_lam * z308
        z310 = c_steer * z300 + s_steer * z309
        z311 = c_lam * z295 + s_lam * z294
        z312 = z234 * z219 + s_steer * z302 + (z239 * z225 - c_steer * z311)
        s42 = k51 * z296 + (k36 * z310 + k50 * z312)
        z313 = h2z * k64 - (z226 * z228 + z227 * z229 + s42)
        z314 = k50 * z226 - k51 * w3_steer
        z315 = z239 * z219 - c_steer * z302 - (z234 * z225 + s_steer * z311)
        z316 = c_steer * z309 - s_steer * z300
        z317 = c_lam * z308 + s_lam * z306
        s43 = k47 * z315 + (k33 * z316 - k36 * z317)
        s44 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61)
        z318 = s44 - (w3_steer * z229 + z226 * z314 - s43)
        s45 = k44 * z296 - (k33 * z310 - k43 * z312)
        z319 = h2z * k63 + (z227 * z314 - w3_steer * z228 - s45)
        z320 = k33 * z226 + k36 * w3_steer
        z321 = k33 * z227
        s46 = z226 * z320 + z227 * z321 - (k31 * z317 - k36 * z315)
        z322 = z9 * k60 - s46
        z323 = k36 * z227
        s47 = k36 * z296 + (k31 * z310 - k33 * z312)
        z324 = h2z * k60 + (w3_steer * z321 - z226 * z323 + s47)
        s48 = z227 * z323 + w3_steer * z320 - (k31 * z316 + k33 * z315)
        z325 = z8 * k60 - s48
        z326 = R_yy * z220 - k27 * z219
        z327 = k25 * w1_pitch + k28 * w3_pitch
        s49 = k29 * z294 + (k23 * z297 - k28 * z295)
        z328 = e2z * k56 - (w1_pitch * z326 + z219 * z327 - s49)
        z329 = k28 * w1_pitch + k29 * w3_pitch
        s50 = k27 * z302 - (k22 * z304 - k23 * z307)
        s51 = w3_pitch * z327 - w1_pitch * z329 - s50
        z330 = z3 * k57 + e3z * k56 + s51
        s52 = k28 * z294 - (k22 * z297 + k25 * z295)
        z331 = e2z * k57 - (z219 * z329 + w3_pitch * z326 + s52)
        z332 = k22 * w1_pitch - k23 * w3_pitch
        z333 = k22 * z219
        s53 = w1_pitch * z332 + z219 * z333 - (k21 * z307 + k23 * z302)
        z334 = e3z * k55 + s53
        z335 = k23 * z219
        s54 = z219 * z335 - w3_pitch * z332 - (k21 * z304 - k22 * z302)
        z336 = z3 * k55 - s54
        s55 = k23 * z294 + (k21 * z297 + k22 * z295)
        z337 = e2z * k55 + (w3_pitch * z333 + w1_pitch * z335 + s55)
        s56 = z75 * z331 + (z84 * z334 - (z82 * z336 + z77 * z337))
        z338 = z74 * z328 + (z80 * z330 - s56)
        s57 = z89 * z319 + (z93 * z322 + (z87 * z324 + (z92 * z325 + z338)))
        z339 = z76 * z313 - (z91 * z318 + s57)
        z340 = z339 + z149 * z303 - z150 * z315
        s58 = z114 * z331 + (z123 * z334 - (z121 * z336 + z116 * z337))
        z341 = z113 * z328 - (z119 * z330 - s58)
        s59 = z132 * z322 + (z126 * z324 + (z131 * z325 - z341))
        z342 = z115 * z313 - (z130 * z318 + (z128 * z319 + s59))
        z343 = z342 + z192 * z303 - z193 * z315 - z340 * z153
        s60 = z160 * z331 - (z169 * z334 - (z167 * z336 - z162 * z337))
        z344 = z159 * z328 + (z165 * z330 + s60)
        s61 = z177 * z322 - (z172 * z324 - (z176 * z325 + z344))
        z345 = z161 * z313 - (z175 * z318 + (z174 * z319 + s61))
        s62 = z345 + R_yy * (z166 * z303) - F_yy * (z184 * z315)
        z346 = (s62 - z340 * z189 - z196 * z343) / z197
        z347 = z195 * z343 - z196 * z346
        dydt: list[float] = [
            # x' (I.2.15)
            s_yaw * z224 - c_yaw * z221,
            # y' (I.2.15)
            -(s_yaw * z221 + c_yaw * z224),
            # z' (I.2.15)
            c_roll * z222 + e2z * v2_x,
            # yaw' (I.2.15)
            -z218,
            # roll' (I.2.15)
            roll_dot,
            # pitch' (I.2.15)
            -z217,
            # steer' (I.2.15)
            steer_dot,
            # thR' (I.2.15)
            z215,
            # thF' (I.2.15)
            thF_dot,
            # roll'' (I.2.15) 112:4
            z189 * z346 - (z152 * z340 - z153 * z347),
            # steer'' (I.2.15) 112:4
            -z347,
            # thF'' (I.2.15) 112:4
            z346,
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
        k1 = r_F * s_lam - c * c_lam
        k2 = c_lam * (w + c) - r_R * s_lam
        k3 = s_lam * k2
        k4 = c_lam * k2
        k5 = c_lam * c_lam
        k6 = w * s_lam + c_lam * (r_R - r_F)
        k7 = s_lam * s_lam
        k8 = s_lam * k1 - c_lam * k6
        k9 = c_lam * k1 + s_lam * k6
        k10 = abs(r_R)
        k11 = abs(r_F)
        k12 = abs(w)
        k13 = abs(c)
        k14 = 18.0 * k13 + (18.0 * k12 + (34.0 * k10 + 19.0 * k11))
        # state
        c_roll = math.cos(roll)
        s_pitch = math.sin(pitch)
        s_steer = math.sin(steer)
        z1 = s_lam * s_steer
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = s_pitch * c_roll
        z3 = r_R / math.sqrt(z2 * z2 + e3z * e3z)
        R3 = e3z * z3
        z4 = k3 + R3
        c_steer = math.cos(steer)
        e2z = math.sin(roll)
        z5 = c_steer * (z2 * c_lam + e3z * s_lam) - e2z * s_steer
        z6 = z2 * s_lam - e3z * c_lam
        z7 = c_lam * z5 + s_lam * z6
        z8 = c_lam * z6 - s_lam * z5
        z9 = r_F / math.sqrt(z7 * z7 + z8 * z8)
        z10 = z7 * z9
        z11 = k9 - z10
        z12 = s_steer * z11
        z13 = z2 * z3
        z14 = k4 + z13
        z15 = s_lam * c_steer
        z16 = k5 + s_lam * z15
        z17 = c_lam * (s_lam - z15)
        z18 = z16 * z13 + z17 * R3
        z19 = k4 * z16 + k3 * z17 + z18 + c_steer * z11
        s1 = c_pitch * (z1 * z14 + s_lam * z12)
        s2 = c_roll * (s_pitch * (z1 * z4 - c_lam * z12) - s1)
        z20 = s2 - e2z * z19
        z21 = c_lam * c_steer
        z22 = s_lam * (c_lam - z21)
        z23 = c_lam * z21 + k7
        z24 = z22 * z13 + z23 * R3
        z25 = c_lam * s_steer
        z26 = z25 * R3 - z1 * z13
        z27 = z8 * z9
        z28 = k6 - c_lam * z27 - s_lam * z10
        z29 = z25 * k3 - z1 * k4 + z26 - s_steer * z28
        z30 = k8 + z27
        z31 = k4 * z22 + k3 * z23 + z24 + c_steer * z30
        z32 = z24 * z29 - z31 * z26
        z33 = c_steer * z28
        z34 = k1 + s_lam * z27 - c_lam * z10
        s3 = c_pitch * (c_steer * z14 + s_lam * z33 + c_lam * z34)
        z35 = s_pitch * (c_steer * z4 - c_lam * z33 + s_lam * z34) - s3
        z36 = c_roll * z35 - e2z * z29
        z37 = s_steer * z30
        s4 = c_pitch * (z25 * z14 - s_lam * z37)
        s5 = c_roll * (s_pitch * (z25 * z4 + c_lam * z37) - s4)
        z38 = s5 + e2z * z31
        z39 = z24 * z36 + z38 * z26
        z40 = z31 * z36 + z38 * z29
        z41 = z20 * z32 - z19 * z39 + z18 * z40
        s6 = 24.0 * k10
        s7 = s6 + 33.0 * k11
        s8 = 14.0 * k12 + s7
        s9 = k14 * (13.0 * k13 + s8)
        # the coframe is singular
        if not abs(z41) > 1e-12 * (k14 * s9):
            raise SingularModelError(1, "velocities")
        c_yaw = math.cos(yaw)
        z42 = 1.0 / z41
        z43 = roll_dot * c_pitch
        z44 = roll_dot * s_pitch
        z45 = steer_dot + (s_lam * z43 + c_lam * z44)
        z46 = s_lam * z44 - c_lam * z43
        z47 = c_steer * z46
        z48 = z43 * k3 + z44 * k4 + (z43 * R3 + z44 * z13)
        s10 = (s_lam * z45 - c_lam * z47) * z27
        s11 = s10 - (s_lam * z47 + c_lam * z45) * z10
        z49 = s11 + (k6 * z47 + k1 * z45 + c_steer * z48)
        z50 = s_steer * z46
        z51 = thF_dot + z50
        z52 = k1 * z50
        z53 = k6 * z50 + s_steer * z48
        z54 = z51 * z27 + (s_lam * z52 - c_lam * z53)
        z55 = z31 * z49 - z29 * z54
        z56 = z36 * z54 + z38 * z49
        z57 = z51 * z10 - (c_lam * z52 + s_lam * z53)
        z58 = z42 * (z20 * z55 + z19 * z56 + z40 * z57)
        z59 = z24 * z49 - z26 * z54
        z60 = z42 * (z20 * z59 + z39 * z57 + z18 * z56)
        z61 = z42 * (z32 * z57 + z19 * z59 - z18 * z55)
        z62 = z58 - (z60 + e2z * z61)
        a3 = z13 * z62
        a1 = R3 * z62
        z63 = s_pitch * a3 + c_pitch * a1
        s_yaw = math.sin(yaw)
        z64 = s_pitch * a1 - c_pitch * a3
        z65 = c_roll * z61
        v2_x = R3 * (z43 + s_pitch * z65) + z13 * (z44 - c_pitch * z65)
        z66 = e2z * z64 - c_roll * v2_x
        qdot: list[float] = [
            # x' (I.2.4)
            s_yaw * z66 - c_yaw * z63,
            # y' (I.2.4)
            -(s_yaw * z63 + c_yaw * z66),
            # z' (I.2.4)
            c_roll * z64 + e2z * v2_x,
            # yaw' (I.2.4)
            -z61,
            # roll' (I.2.4)
            roll_dot,
            # pitch' (I.2.4)
            -z60,
            # steer' (I.2.4)
            steer_dot,
            # thR' (I.2.4)
            z58,
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
        k1 = r_F * s_lam - c * c_lam
        k2 = c_lam * (w + c) - r_R * s_lam
        k3 = s_lam * k2
        k4 = c_lam * k2
        k5 = c_lam * c_lam
        k6 = w * s_lam + c_lam * (r_R - r_F)
        k7 = s_lam * s_lam
        k8 = s_lam * k1 - c_lam * k6
        k9 = c_lam * k1 + s_lam * k6
        # state
        s_pitch = math.sin(pitch)
        c_roll = math.cos(roll)
        z1 = s_pitch * c_roll
        z2 = r_R * z1
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z3 = z1 * z1 + e3z * e3z
        z4 = 1.0 / math.sqrt(z3)
        z5 = z2 * z4
        s_steer = math.sin(steer)
        z6 = s_lam * s_steer
        z7 = r_R * e3z
        R3 = z7 * z4
        z8 = R3 + k3
        c_steer = math.cos(steer)
        z9 = z1 * c_lam + e3z * s_lam
        e2z = math.sin(roll)
        z10 = c_steer * z9 - e2z * s_steer
        z11 = z1 * s_lam - e3z * c_lam
        z12 = c_lam * z10 + s_lam * z11
        z13 = r_F * z12
        z14 = c_lam * z11 - s_lam * z10
        z15 = z12 * z12 + z14 * z14
        z16 = 1.0 / math.sqrt(z15)
        z17 = z13 * z16
        z18 = z17 - k9
        z19 = s_steer * z18
        z20 = z6 * z8 + c_lam * z19
        z21 = z5 + k4
        z22 = z6 * z21 - s_lam * z19
        z23 = s_pitch * z20 - c_pitch * z22
        z24 = s_lam * c_steer
        z25 = k5 + s_lam * z24
        z26 = c_lam * (s_lam - z24)
        z27 = z5 * z25 + R3 * z26
        z28 = k4 * z25 + k3 * z26 + z27 - c_steer * z18
        z29 = c_roll * z23 - e2z * z28
        z30 = c_lam * c_steer
        z31 = s_lam * (c_lam - z30)
        z32 = c_lam * z30 + k7
        z33 = z5 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z5 * z6
        z36 = r_F * z14
        z37 = z36 * z16
        z38 = k6 - c_lam * z37 - s_lam * z17
        z39 = z34 * k3 - z6 * k4 + z35 - s_steer * z38
        z40 = z37 + k8
        z41 = k4 * z31 + k3 * z32 + z33 + c_steer * z40
        z42 = z33 * z39 - z41 * z35
        z43 = c_steer * z38
        z44 = k1 + s_lam * z37 - c_lam * z17
        z45 = c_steer * z8 - c_lam * z43 + s_lam * z44
        z46 = c_steer * z21 + s_lam * z43 + c_lam * z44
        z47 = s_pitch * z45 - c_pitch * z46
        z48 = c_roll * z47 - e2z * z39
        z49 = s_steer * z40
        z50 = z34 * z8 + c_lam * z49
        z51 = z34 * z21 - s_lam * z49
        z52 = s_pitch * z50 - c_pitch * z51
        z53 = c_roll * z52 + e2z * z41
        z54 = z33 * z48 + z53 * z35
        z55 = z41 * z48 + z53 * z39
        z56 = z29 * z42 - z28 * z54 + z27 * z55
        z57 = 1.0 / z56
        z58 = roll_dot * c_pitch
        z59 = roll_dot * s_pitch
        z60 = steer_dot + (s_lam * z58 + c_lam * z59)
        z61 = s_lam * z59 - c_lam * z58
        z62 = c_steer * z61
        z63 = s_lam * z60 - c_lam * z62
        z64 = s_lam * z62 + c_lam * z60
        z65 = z58 * k3 + z59 * k4 + (z58 * R3 + z59 * z5)
        z66 = z37 * z63 - z17 * z64 + (k6 * z62 + k1 * z60 + c_steer * z65)
        z67 = s_steer * z61
        z68 = thF_dot + z67
        z69 = k1 * z67
        z70 = k6 * z67 + s_steer * z65
        z71 = z37 * z68 + (s_lam * z69 - c_lam * z70)
        z72 = z41 * z66 - z39 * z71
        z73 = z48 * z71 + z53 * z66
        z74 = z17 * z68 - (s_lam * z70 + c_lam * z69)
        z75 = z29 * z72 + z28 * z73 + z55 * z74
        z76 = z33 * z66 - z35 * z71
        z77 = z29 * z76 + z54 * z74 + z27 * z73
        z78 = z57 * z77
        z79 = z42 * z74 + z28 * z76 - z27 * z72
        z80 = z57 * z79
        z81 = z57 * z75 - (z78 + e2z * z80)
        a3 = z5 * z81
        a1 = R3 * z81
        z82 = s_pitch * a3 + c_pitch * a1
        s_yaw = math.sin(yaw)
        z83 = s_yaw * z80
        c_yaw = math.cos(yaw)
        z84 = c_pitch * z78
        z85 = r_R * z4
        z86 = roll_dot * e2z
        z87 = s_pitch * z86 + c_roll * z84
        z88 = s_pitch * z78
        z89 = c_pitch * z86 - c_roll * z88
        z90 = (z1 * z87 + e3z * z89) * (z4 / z3)
        z91 = z85 * z87 - z2 * z90
        z92 = steer_dot * c_steer
        z93 = s_lam * z92
        z94 = z85 * z89 - z7 * z90
        z95 = roll_dot * c_roll
        z96 = steer_dot * s_steer
        s1 = z9 * z96 + c_steer * (c_lam * z87 + s_lam * z89)
        z97 = s_steer * z95 + e2z * z92 + s1
        z98 = s_lam * z87 - c_lam * z89
        z99 = c_lam * z97 + s_lam * z98
        z100 = r_F * z16
        z101 = c_lam * z98 - s_lam * z97
        z102 = (z12 * z99 + z14 * z101) * (z16 / z15)
        z103 = z99 * z100 - z13 * z102
        z104 = z92 * z18 - s_steer * z103
        z105 = z6 * z91
        s2 = z20 * z84 - s_pitch * (z8 * z93 - z6 * z94 + c_lam * z104)
        z106 = s2 + (z22 * z88 + c_pitch * (z21 * z93 - z105 - s_lam * z104))
        z107 = s_lam * z96
        z108 = s_lam * z107
        z109 = c_lam * z107
        z110 = z5 * z108 + z25 * z91 - (R3 * z109 - z26 * z94)
        z111 = k4 * z108 - k3 * z109 + z110 - (z96 * z18 + c_steer * z103)
        z112 = z86 * z23 + c_roll * z106 + (z95 * z28 - e2z * z111)
        z113 = c_lam * z96
        z114 = s_lam * z113
        z115 = c_lam * z113
        z116 = z5 * z114 - z31 * z91 - (R3 * z115 + z32 * z94)
        z117 = c_lam * z92
        z118 = z34 * z94
        z119 = R3 * z117 - z118 - (z5 * z93 - z105)
        z120 = z101 * z100 - z36 * z102
        z121 = c_lam * z120 + s_lam * z103
        z122 = k3 * z117 - k4 * z93 + z119 - (z92 * z38 + s_steer * z121)
        z123 = k4 * z114 - k3 * z115 + z116 - (z96 * z40 + c_steer * z120)
        z124 = z39 * z116 + z33 * z122 - (z35 * z123 + z41 * z119)
        z125 = z96 * z38 - c_steer * z121
        z126 = s_lam * z120 - c_lam * z103
        s3 = z96 * z8 + c_steer * z94 - c_lam * z125 + s_lam * z126
        s4 = z96 * z21 + c_steer * z91 + s_lam * z125 + c_lam * z126
        z127 = z45 * z84 + s_pitch * s3 + (z46 * z88 - c_pitch * s4)
        z128 = z86 * z47 + c_roll * z127 + (z95 * z39 + e2z * z122)
        z129 = z92 * z40 - s_steer * z120
        s5 = c_pitch * (z21 * z117 - z34 * z91 - s_lam * z129)
        s6 = z50 * z84 - s_pitch * (z8 * z117 - z118 + c_lam * z129)
        z130 = s6 + (z51 * z88 + s5)
        z131 = z86 * z52 + c_roll * z130 - (z95 * z41 + e2z * z123)
        z132 = z48 * z116 - z33 * z128 - (z35 * z131 - z53 * z119)
        z133 = z48 * z123 - z41 * z128 - (z39 * z131 - z53 * z122)
        s7 = z42 * z112 - z29 * z124 - (z54 * z111 - z28 * z132)
        z134 = s7 + (z55 * z110 - z27 * z133)
        z135 = z134 / (z56 * z56)
        z136 = roll_dot * z88 + c_pitch * roll_ddot
        z137 = roll_dot * z84 - s_pitch * roll_ddot
        z138 = steer_ddot + (s_lam * z136 - c_lam * z137)
        z139 = s_lam * z137 + c_lam * z136
        z140 = z96 * z61 + c_steer * z139
        s8 = z63 * z120 - z37 * (s_lam * z138 + c_lam * z140)
        z141 = s8 - (z64 * z103 + z17 * (s_lam * z140 - c_lam * z138))
        s9 = z58 * z94 - R3 * z136 + (z59 * z91 + z5 * z137)
        z142 = k3 * z136 - k4 * z137 - s9
        z143 = z141 + (k6 * z140 - k1 * z138 + (z96 * z65 - c_steer * z142))
        z144 = z92 * z61 - s_steer * z139
        z145 = thF_ddot + z144
        z146 = k1 * z144
        z147 = k6 * z144 + (z92 * z65 + s_steer * z142)
        z148 = z68 * z120 - z37 * z145 - (s_lam * z146 - c_lam * z147)
        z149 = z66 * z123 - z41 * z143 - (z71 * z122 - z39 * z148)
        z150 = z71 * z128 + z48 * z148 + (z66 * z131 + z53 * z143)
        z151 = z68 * z103 - z17 * z145 + (c_lam * z146 + s_lam * z147)
        s10 = z72 * z112 - z29 * z149 + (z73 * z111 + z28 * z150)
        z152 = s10 - (z74 * z133 - z55 * z151)
        z153 = z75 * z135 - z57 * z152
        z154 = z66 * z116 - z33 * z143 - (z71 * z119 - z35 * z148)
        s11 = z76 * z112 - z29 * z154 - (z74 * z132 - z54 * z151)
        z155 = s11 + (z73 * z110 + z27 * z150)
        z156 = z77 * z135 - z57 * z155
        s12 = z74 * z124 - z42 * z151 - (z76 * z111 - z28 * z154)
        z157 = s12 + (z72 * z110 - z27 * z149)
        z158 = z79 * z135 + z57 * z157
        z159 = z153 - (z156 + (z95 * z80 + e2z * z158))
        z160 = z81 * z91 - z5 * z159
        z161 = z81 * z94 - R3 * z159
        z162 = a3 * z84 + s_pitch * z160 - (a1 * z88 - c_pitch * z161)
        z163 = s_pitch * a1 - c_pitch * a3
        z164 = c_roll * z80
        w1_pitch = z58 + s_pitch * z164
        w3_pitch = z59 - c_pitch * z164
        v2_x = R3 * w1_pitch + z5 * w3_pitch
        z165 = e2z * z163 - c_roll * v2_x
        z166 = c_yaw * z80
        z167 = a1 * z84 + s_pitch * z161 + (a3 * z88 - c_pitch * z160)
        z168 = z86 * z80 - c_roll * z158
        s13 = w1_pitch * z94 - R3 * (z136 - (z164 * z84 + s_pitch * z168))
        s14 = w3_pitch * z91 + z5 * (z137 + (z164 * z88 - c_pitch * z168))
        z169 = s13 + s14
        z170 = z95 * z163 - e2z * z167 + (z86 * v2_x + c_roll * z169)
        qddot: list[float] = [
            # x'' (I.2.15)
            -(z82 * z83 - c_yaw * z162 + (z165 * z166 - s_yaw * z170)),
            # y'' (I.2.15)
            z82 * z166 + s_yaw * z162 - (z165 * z83 + c_yaw * z170),
            # z'' (I.2.15)
            z95 * v2_x - e2z * z169 - (z86 * z163 + c_roll * z167),
            # yaw'' (I.2.15)
            -z158,
            # roll'' (I.2.15)
            roll_ddot,
            # pitch'' (I.2.15)
            -z156,
            # steer'' (I.2.15)
            steer_ddot,
            # thR'' (I.2.15)
            z153,
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
        k3 = r_F * s_lam - c * c_lam
        k4 = H_zz + F_xx
        k5 = H_xx + F_xx
        k6 = z_H * s_lam - c_lam * (x_H - k2)
        k7 = x_H * s_lam + c_lam * (r_R + z_H)
        k8 = c_lam * k2 - r_R * s_lam
        k9 = s_lam * k8
        k10 = c_lam * k8
        k11 = c_lam * c_lam
        k12 = w * s_lam + c_lam * (r_R - r_F)
        k13 = s_lam * s_lam
        k14 = s_lam * k3 - c_lam * k12
        k15 = c_lam * k3 + s_lam * k12
        k16 = m_R + m_B
        k17 = m_B * k1
        k18 = x_B * m_B
        k19 = k1 * k17
        k20 = R_xx + B_xx + k19
        k21 = x_B * k18
        k22 = k19 + (B_yy + k21)
        k23 = B_xz - k1 * k18
        k24 = R_xx + B_zz + k21
        k25 = m_F * k12
        k26 = m_H + m_F
        k27 = m_H * k7
        k28 = k25 + k27
        k29 = m_F * k3
        k30 = m_H * k6
        k31 = k29 - k30
        k32 = H_xz * c_lam
        k33 = s_lam * k4 - k32
        k34 = H_xz * s_lam
        k35 = c_lam * k5 - k34
        k36 = k12 * k25
        k37 = k7 * k27
        k38 = c_lam * k35 + s_lam * k33 + k36 + k37
        k39 = s_lam * k35 - c_lam * k33 - k3 * k25 + k6 * k27
        k40 = k3 * k29
        k41 = k6 * k30
        k42 = k37 + (k36 + (H_yy + k40) + k41)
        k43 = k34 + c_lam * k4
        k44 = k32 + s_lam * k5
        k45 = c_lam * k44 - s_lam * k43 - k12 * k29 + k7 * k30
        k46 = k41 + (k40 + (s_lam * k44 + c_lam * k43))
        k47 = g * m_F
        k48 = g * m_H
        k49 = g * m_B
        k50 = g * k16
        k51 = x_B * k49
        k52 = k1 * k49
        k53 = k6 * k48
        k54 = k7 * k48
        k55 = g * k26
        k56 = k3 * k47
        k57 = k12 * k47
        k58 = k54 + k57
        k59 = k53 - k56
        # state
        s_yaw = math.sin(yaw)
        e2z = math.sin(roll)
        s_pitch = math.sin(pitch)
        c_roll = math.cos(roll)
        z1 = s_pitch * c_roll
        s_steer = math.sin(steer)
        z2 = s_lam * s_steer
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z3 = r_R * e3z
        z4 = z1 * z1 + e3z * e3z
        z5 = 1.0 / math.sqrt(z4)
        R3 = z3 * z5
        z6 = R3 + k9
        c_steer = math.cos(steer)
        z7 = z1 * c_lam + e3z * s_lam
        z8 = c_steer * z7 - e2z * s_steer
        z9 = z1 * s_lam - e3z * c_lam
        z10 = c_lam * z8 + s_lam * z9
        z11 = r_F * z10
        z12 = c_lam * z9 - s_lam * z8
        z13 = z10 * z10 + z12 * z12
        z14 = 1.0 / math.sqrt(z13)
        z15 = z11 * z14
        z16 = z15 - k15
        z17 = s_steer * z16
        z18 = z2 * z6 + c_lam * z17
        z19 = r_R * z1
        z20 = z19 * z5
        z21 = z20 + k10
        z22 = z2 * z21 - s_lam * z17
        z23 = s_pitch * z18 - c_pitch * z22
        z24 = s_lam * c_steer
        z25 = k11 + s_lam * z24
        z26 = c_lam * (s_lam - z24)
        z27 = z20 * z25 + R3 * z26
        z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16
        z29 = c_roll * z23 - e2z * z28
        z30 = c_lam * c_steer
        z31 = s_lam * (c_lam - z30)
        z32 = c_lam * z30 + k13
        z33 = z20 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z20 * z2
        z36 = r_F * z12
        z37 = z36 * z14
        z38 = k12 - c_lam * z37 - s_lam * z15
        z39 = z34 * k9 - z2 * k10 + z35 - s_steer * z38
        z40 = z37 + k14
        z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40
        z42 = z33 * z39 - z41 * z35
        z43 = c_steer * z38
        z44 = s_lam * z37
        z45 = c_lam * z15
        z46 = k3 + z44 - z45
        z47 = c_steer * z6 - c_lam * z43 + s_lam * z46
        z48 = c_steer * z21 + s_lam * z43 + c_lam * z46
        z49 = s_pitch * z47 - c_pitch * z48
        z50 = c_roll * z49 - e2z * z39
        z51 = s_steer * z40
        z52 = z34 * z6 + c_lam * z51
        z53 = z34 * z21 - s_lam * z51
        z54 = s_pitch * z52 - c_pitch * z53
        z55 = c_roll * z54 + e2z * z41
        z56 = z33 * z50 + z55 * z35
        z57 = z41 * z50 + z55 * z39
        z58 = 1.0 / (z29 * z42 - z28 * z56 + z27 * z57)
        z59 = roll_dot * c_pitch
        z60 = roll_dot * s_pitch
        z61 = steer_dot + (s_lam * z59 + c_lam * z60)
        z62 = s_lam * z60 - c_lam * z59
        z63 = c_steer * z62
        z64 = s_lam * z61 - c_lam * z63
        z65 = s_lam * z63 + c_lam * z61
        z66 = z59 * k9 + z60 * k10 + (z59 * R3 + z60 * z20)
        z67 = z37 * z64 - z15 * z65 + (k12 * z63 + k3 * z61 + c_steer * z66)
        z68 = s_steer * z62
        z69 = thF_dot + z68
        z70 = k3 * z68
        z71 = k12 * z68 + s_steer * z66
        z72 = z37 * z69 + (s_lam * z70 - c_lam * z71)
        z73 = z33 * z67 - z35 * z72
        z74 = z15 * z69 - (s_lam * z71 + c_lam * z70)
        z75 = z50 * z72 + z55 * z67
        z76 = z58 * (z29 * z73 + z56 * z74 + z27 * z75)
        z77 = z41 * z67 - z39 * z72
        z78 = z58 * (z42 * z74 + z28 * z73 - z27 * z77)
        z79 = z76 + e2z * z78
        z80 = k18 * z79
        z81 = c_roll * z78
        w3_pitch = z60 - c_pitch * z81
        w1_pitch = z59 + s_pitch * z81
        z82 = k17 * w1_pitch - k18 * w3_pitch
        z83 = z58 * (z29 * z77 + z28 * z75 + z57 * z74)
        z84 = z83 - z79
        a3 = z20 * z84
        v2_x = R3 * w1_pitch + z20 * w3_pitch
        z85 = r_R * z5
        z86 = roll_dot * e2z
        z87 = s_pitch * z76
        z88 = c_pitch * z86 - c_roll * z87
        z89 = c_pitch * z76
        z90 = s_pitch * z86 + c_roll * z89
        z91 = (z1 * z90 + e3z * z88) * (z5 / z4)
        z92 = z85 * z88 - z3 * z91
        z93 = roll_dot * z87
        z94 = roll_dot * z89
        z95 = s_lam * z93 - c_lam * z94
        z96 = steer_dot * s_steer
        z97 = s_lam * z94 + c_lam * z93
        z98 = z96 * z62 + c_steer * z97
        z99 = s_lam * z90 - c_lam * z88
        z100 = roll_dot * c_roll
        z101 = steer_dot * c_steer
        s1 = z7 * z96 + c_steer * (c_lam * z90 + s_lam * z88)
        z102 = s_steer * z100 + e2z * z101 + s1
        z103 = c_lam * z99 - s_lam * z102
        z104 = r_F * z14
        z105 = c_lam * z102 + s_lam * z99
        z106 = (z10 * z105 + z12 * z103) * (z14 / z13)
        z107 = z103 * z104 - z36 * z106
        z108 = z105 * z104 - z11 * z106
        s2 = z37 * (s_lam * z95 + c_lam * z98) - z64 * z107
        z109 = s2 + (z15 * (s_lam * z98 - c_lam * z95) + z65 * z108)
        z110 = z85 * z90 - z19 * z91
        s3 = R3 * z93 - z59 * z92 - (z20 * z94 + z60 * z110)
        z111 = k9 * z93 - k10 * z94 + s3
        z112 = c_lam * z101
        z113 = z34 * z92
        z114 = s_lam * z101
        z115 = z2 * z110
        z116 = R3 * z112 - z113 - (z20 * z114 - z115)
        z117 = c_lam * z107 + s_lam * z108
        z118 = z96 * z38 - c_steer * z117
        z119 = s_lam * z107 - c_lam * z108
        s4 = z96 * z6 + c_steer * z92 - c_lam * z118 + s_lam * z119
        s5 = z96 * z21 + c_steer * z110 + s_lam * z118 + c_lam * z119
        z120 = z47 * z89 + s_pitch * s4 + (z48 * z87 - c_pitch * s5)
        z121 = k9 * z112 - k10 * z114 + z116 - (z101 * z38 + s_steer * z117)
        s6 = z78 * (z86 * z49 + c_roll * z120 + (z100 * z39 + e2z * z121))
        z122 = z83 * z116 - (s6 + z76 * z121)
        s7 = z109 - (k12 * z98 - k3 * z95 + (z96 * z66 - c_steer * z111))
        z123 = s7 + z122
        z124 = z101 * z62 - s_steer * z97
        z125 = k3 * z124
        z126 = k12 * z124 + (z101 * z66 + s_steer * z111)
        z127 = c_lam * z96
        z128 = s_lam * z127
        z129 = c_lam * z127
        z130 = z20 * z128 - z31 * z110 - (R3 * z129 + z32 * z92)
        z131 = z101 * z40 - s_steer * z107
        s8 = c_pitch * (z21 * z112 - z34 * z110 - s_lam * z131)
        s9 = z52 * z89 - s_pitch * (z6 * z112 - z113 + c_lam * z131)
        z132 = s9 + (z53 * z87 + s8)
        z133 = k10 * z128 - k9 * z129 + z130 - (z96 * z40 + c_steer * z107)
        s10 = z78 * (z86 * z54 + c_roll * z132 - (z100 * z41 + e2z * z133))
        z134 = z83 * z130 + (s10 - z76 * z133)
        s11 = z37 * z124 - z69 * z107 + (s_lam * z125 - c_lam * z126)
        z135 = s11 + z134
        z136 = z41 * z123 - z39 * z135
        z137 = z50 * z135 + z55 * z123
        z138 = s_lam * z96
        z139 = s_lam * z138
        z140 = c_lam * z138
        z141 = z20 * z139 + z25 * z110 - (R3 * z140 - z26 * z92)
        z142 = z101 * z16 - s_steer * z108
        s12 = z18 * z89 - s_pitch * (z6 * z114 - z2 * z92 + c_lam * z142)
        s13 = z22 * z87 + c_pitch * (z21 * z114 - z115 - s_lam * z142)
        z143 = s12 + s13
        z144 = k10 * z139 - k9 * z140 + z141 - (z96 * z16 + c_steer * z108)
        s14 = z78 * (z86 * z23 + c_roll * z143 + (z100 * z28 - e2z * z144))
        z145 = z83 * z141 + (s14 - z76 * z144)
        s15 = z15 * z124 - z69 * z108 - (c_lam * z125 + s_lam * z126)
        z146 = s15 + z145
        z147 = z33 * z123 - z35 * z135
        z148 = z58 * (z42 * z146 + z28 * z147 - z27 * z136)
        s16 = z58 * (z29 * z147 + z56 * z146 + z27 * z137)
        z149 = s16 + (z100 * z78 + e2z * z148)
        z150 = z58 * (z29 * z136 + z28 * z137 + z57 * z146) - z149
        z151 = z79 * a3 - w3_pitch * v2_x + (z84 * z92 - R3 * z150)
        z152 = z37 * z39
        z153 = z37 * z50
        z154 = z37 * z35
        z155 = z58 * (z15 * z42 - z28 * z154 + z27 * z152)
        z156 = z58 * (z29 * z154 - z15 * z56 - z27 * z153) - e2z * z155
        z157 = z58 * (z29 * z152 - z28 * z153 - z15 * z57) - z156
        z158 = R3 * z157
        z159 = c_pitch * s_lam + s_pitch * c_lam
        z160 = s_pitch * s_lam - c_pitch * c_lam
        z161 = c_steer * z160
        z162 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20)
        s17 = z37 * (s_lam * z159 - c_lam * z161)
        s18 = s17 - z15 * (s_lam * z161 + c_lam * z159)
        z163 = s18 + (k12 * z161 + k3 * z159 + c_steer * z162)
        z164 = s_steer * z160
        z165 = k3 * z164
        z166 = k12 * z164 + s_steer * z162
        z167 = z37 * z164 + (s_lam * z165 - c_lam * z166)
        z168 = z41 * z163 - z39 * z167
        z169 = z50 * z167 + z55 * z163
        z170 = z15 * z164 - (s_lam * z166 + c_lam * z165)
        z171 = z33 * z163 - z35 * z167
        z172 = z58 * (z42 * z170 + z28 * z171 - z27 * z168)
        z173 = z58 * (z29 * z171 + z56 * z170 + z27 * z169) + e2z * z172
        z174 = z58 * (z29 * z168 + z28 * z169 + z57 * z170) - z173
        z175 = R3 * z174
        z176 = k3 + (z44 - z45)
        z177 = z41 * z176
        z178 = z55 * z176
        z179 = z33 * z176
        z180 = z58 * (z28 * z179 - z27 * z177)
        z181 = z58 * (z29 * z179 + z27 * z178) + e2z * z180
        z182 = z58 * (z29 * z177 + z28 * z178) - z181
        z183 = R3 * z182
        z184 = z158 * thF_ddot - (z175 * roll_ddot + z183 * steer_ddot)
        z185 = z156 * thF_ddot - (z173 * roll_ddot + z181 * steer_ddot)
        s19 = z79 * z80 - w3_pitch * z82 - (k16 * z151 - k17 * z149)
        z186 = z1 * k50 - s19 + (k16 * z184 + k17 * z185)
        h2z = e2z * c_steer + s_steer * z7
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z187 = c_lam * w1_pitch - s_lam * w3_pitch
        z188 = c_steer * z79 + s_steer * z187
        z189 = k28 * z188
        z190 = s_steer * z79 - c_steer * z187
        z191 = k31 * z188
        z192 = z86 * z78 - c_roll * z148
        z193 = z94 + (z81 * z87 - c_pitch * z192)
        z194 = z93 - (z81 * z89 + s_pitch * z192)
        z195 = c_lam * z193 - s_lam * z194
        a1 = R3 * z84
        s20 = w1_pitch * z92 - R3 * z194 + (w3_pitch * z110 + z20 * z193)
        z196 = a1 * w3_pitch - a3 * w1_pitch + s20
        z197 = k9 * z79
        z198 = k10 * z79
        s21 = w3_pitch * z197 - w1_pitch * z198 - (k10 * z193 - k9 * z194)
        z199 = z196 - s21
        z200 = k10 * w3_pitch + k9 * w1_pitch
        z201 = z151 - (z79 * z198 + w3_pitch * z200 - k9 * z149)
        z202 = w1_pitch * v2_x - z79 * a1 + (z84 * z110 - z20 * z150)
        z203 = z202 + (w1_pitch * z200 + z79 * z197 + k10 * z149)
        z204 = c_lam * z201 - s_lam * z203
        z205 = c_steer * z199 + s_steer * z204
        z206 = c_lam * z194 + s_lam * z193
        z207 = z101 * z79 + s_steer * z149 + (z96 * z187 - c_steer * z206)
        s22 = k31 * z195 + (k26 * z205 - k28 * z207)
        z208 = h2z * k55 + (w3_steer * z189 - z190 * z191 + s22)
        z209 = c_roll * z155
        z210 = c_pitch * z209
        z211 = s_pitch * z209
        z212 = c_roll * z172
        z213 = s_pitch - c_pitch * z212
        z214 = c_pitch + s_pitch * z212
        z215 = c_roll * z180
        z216 = c_pitch * z215
        z217 = s_pitch * z215
        s23 = (1.0 - (c_lam * z216 - s_lam * z217)) * steer_ddot
        s24 = (c_lam * z213 + s_lam * z214) * roll_ddot + s23
        z218 = (c_lam * z210 - s_lam * z211) * thF_ddot - s24
        z219 = R3 * z211 - z20 * z210
        z220 = z219 - (k10 * z210 - k9 * z211)
        z221 = z158 - k9 * z156
        z222 = z20 * z157
        z223 = z222 - k10 * z156
        z224 = c_lam * z221 - s_lam * z223
        z225 = R3 * z214 + z20 * z213
        z226 = z225 + (k10 * z213 + k9 * z214)
        z227 = z175 - k9 * z173
        z228 = z20 * z174
        z229 = z228 - k10 * z173
        z230 = c_lam * z227 - s_lam * z229
        z231 = R3 * z217 - z20 * z216
        z232 = z231 - (k10 * z216 - k9 * z217)
        z233 = z183 - k9 * z181
        z234 = z20 * z182
        z235 = z234 - k10 * z181
        z236 = c_lam * z233 - s_lam * z235
        s25 = (c_steer * z232 + s_steer * z236) * steer_ddot
        s26 = (c_steer * z226 + s_steer * z230) * roll_ddot + s25
        z237 = (c_steer * z220 - s_steer * z224) * thF_ddot + s26
        z238 = c_lam * z211 + s_lam * z210
        z239 = c_lam * z214 - s_lam * z213
        z240 = c_lam * z217 + s_lam * z216
        s27 = (s_steer * z181 - c_steer * z240) * steer_ddot
        s28 = (s_steer * z173 - c_steer * z239) * roll_ddot + s27
        z241 = (s_steer * z156 + c_steer * z238) * thF_ddot - s28
        z242 = z208 + (k31 * z218 - (k26 * z237 - k28 * z241))
        z243 = k28 * z190 + k31 * w3_steer
        z244 = c_steer * z204 - s_steer * z199
        z245 = z96 * z79 - c_steer * z149 - (z101 * z187 + s_steer * z206)
        s29 = (c_steer * z236 - s_steer * z232) * steer_ddot
        s30 = (c_steer * z230 - s_steer * z226) * roll_ddot + s29
        z246 = (c_steer * z224 + s_steer * z220) * thF_ddot - s30
        z247 = c_steer * z156 - s_steer * z238
        s31 = (c_steer * z181 + s_steer * z240) * steer_ddot
        z248 = (c_steer * z173 + s_steer * z239) * roll_ddot + s31
        z249 = z247 * thF_ddot - z248
        s32 = z188 * z191 + w3_steer * z243 - (k26 * z244 + k28 * z245)
        z250 = z8 * k55 - s32 + (k26 * z246 + k28 * z249)
        z251 = s_steer * z242 + c_steer * z250
        z252 = c_lam * z203 + s_lam * z201
        s33 = (c_lam * z235 + s_lam * z233) * steer_ddot
        s34 = (c_lam * z229 + s_lam * z227) * roll_ddot + s33
        z253 = (c_lam * z223 + s_lam * z221) * thF_ddot - s34
        s35 = z190 * z243 + z188 * z189 - (k26 * z252 - k31 * z245)
        z254 = z9 * k55 - s35 + (k26 * z253 - k31 * z249)
        z255 = c_lam * z251 + s_lam * z254
        z256 = z186 + z255
        z257 = k17 * z79
        z258 = z222 * thF_ddot - (z228 * roll_ddot + z234 * steer_ddot)
        s36 = w1_pitch * z82 + z79 * z257 - (k16 * z202 + k18 * z149)
        z259 = e3z * k50 + s36 - (k16 * z258 - k18 * z185)
        z260 = s_lam * z251 - c_lam * z254
        z261 = z259 + z260
        s37 = z157 * thF_ddot - (z174 * roll_ddot + z182 * steer_ddot)
        z262 = R_yy * (z150 - s37) + z20 * z261 - R3 * z256
        z263 = z58 * z262
        z264 = k20 * w1_pitch + k23 * w3_pitch
        z265 = k23 * w1_pitch + k24 * w3_pitch
        s38 = k22 * z149 - (k17 * z151 - k18 * z202)
        s39 = w3_pitch * z264 - w1_pitch * z265 - s38
        z266 = z1 * k52 + e3z * k51 + s39
        z267 = k38 * z190 - k39 * w3_steer
        z268 = k45 * z190 - k46 * w3_steer
        s40 = k42 * z245 + (k28 * z244 - k31 * z252)
        s41 = z8 * k54 + z9 * k53 + (z8 * k57 - z9 * k56)
        z269 = s41 - (w3_steer * z267 + z190 * z268 - s40)
        s42 = F_yy * (z245 - (z248 - (1.0 + z247) * thF_ddot))
        z270 = z269 + (k42 * z249 + (k28 * z246 - k31 * z253)) + s42
        s43 = z266 + (k22 * z185 + (k17 * z184 - k18 * z258)) + k10 * z260
        z271 = s43 - k9 * z255 + c_steer * z270
        z272 = F_yy * (thF_dot - z188) - k42 * z188
        s44 = k39 * z195 - (k28 * z205 - k38 * z207)
        z273 = h2z * k58 + (z188 * z268 - w3_steer * z272 - s44)
        z274 = z273 - (k39 * z218 + (k28 * z237 - k38 * z241))
        z275 = z271 + s_steer * z274 + z262
        z276 = z58 * z275
        z277 = z28 * z263 - z27 * z276
        z278 = R_yy * z84 - k22 * z79
        s45 = k24 * z193 + (k18 * z196 - k23 * z194)
        z279 = e2z * k51 - (w1_pitch * z278 + z79 * z264 - s45)
        z280 = z210 * thF_ddot - (z213 * roll_ddot - z216 * steer_ddot)
        z281 = z219 * thF_ddot + (z225 * roll_ddot + z231 * steer_ddot)
        z282 = z211 * thF_ddot + (z214 * roll_ddot + z217 * steer_ddot)
        z283 = c_steer * z242 - s_steer * z250
        z284 = s_steer * z270 - c_steer * z274
        s46 = k46 * z195 + (k31 * z205 + k45 * z207)
        z285 = h2z * k59 - (z190 * z272 + z188 * z267 + s46)
        z286 = z285 - (k46 * z218 - (k31 * z237 + k45 * z241))
        s47 = z279 + (k24 * z280 - (k18 * z281 + k23 * z282)) + k10 * z283
        z287 = s47 - s_lam * z284 - c_lam * z286
        s48 = k18 * z193 + (k16 * z196 + k17 * z194)
        z288 = e2z * k50 + (w3_pitch * z257 + w1_pitch * z80 + s48)
        z289 = z288 + (k18 * z280 - (k16 * z281 - k17 * z282)) + z283
        s49 = k23 * z193 - (k17 * z196 + k20 * z194)
        z290 = e2z * k52 - (z79 * z265 + w3_pitch * z278 + s49)
        s50 = z290 - (k23 * z280 + (k17 * z281 - k20 * z282)) - k9 * z283
        z291 = s50 - c_lam * z284 + s_lam * z286
        s51 = c_pitch * (z287 + z20 * z289) + s_pitch * (z291 - R3 * z289)
        z292 = z58 * (c_roll * s51 - e2z * z275)
        z293 = z29 * z263 - z27 * z292
        z294 = z29 * z276 - z28 * z292
        z295 = z50 * z277 - z39 * z293 + z35 * z294
        z296 = z57 * z263 - z56 * z276 + z42 * z292
        z297 = s_lam * z295 - c_lam * z296
        z298 = s_lam * z297
        z299 = z55 * z277 + z41 * z293 - z33 * z294
        z300 = c_lam * z295 + s_lam * z296
        z301 = s_steer * z299 + c_steer * z300
        z302 = c_lam * z301
        z303 = z256 - z298 - z302
        z304 = c_lam * z297
        z305 = s_lam * z301
        z306 = z261 + z304 - z305
        z307 = s_pitch * z303 + c_pitch * z306
        z308 = c_steer * z299 - s_steer * z300
        z309 = z289 - z308
        z310 = e2z * z307 - c_roll * z309
        c_yaw = math.cos(yaw)
        z311 = c_pitch * z303 - s_pitch * z306
        z312 = z298 + z302
        z313 = z304 - z305
        z314 = s_pitch * z312 - c_pitch * z313
        z315 = e2z * z314 - c_roll * z308
        z316 = c_pitch * z312 + s_pitch * z313
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            c_yaw * z311 - s_yaw * z310,
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            c_yaw * z310 + s_yaw * z311,
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            -(c_roll * z307 + e2z * z309),
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            c_yaw * z316 - s_yaw * z315,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            c_yaw * z315 + s_yaw * z316,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            -(c_roll * z314 + e2z * z308),
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
        k6 = s_lam * k5
        k7 = c_lam * k5
        k8 = c_lam * c_lam
        k9 = w * s_lam + c_lam * (r_R - r_F)
        k10 = s_lam * s_lam
        k11 = s_lam * k4 - c_lam * k9
        k12 = c_lam * k4 + s_lam * k9
        # state
        s_pitch = math.sin(pitch)
        c_roll = math.cos(roll)
        z1 = s_pitch * c_roll
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = r_R * e3z
        Sz = z - z1 * k2 + z2
        c_steer = math.cos(steer)
        z3 = z1 * c_lam + e3z * s_lam
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        z4 = c_steer * z3 - e2z * s_steer
        z5 = z1 * s_lam - e3z * c_lam
        z6 = c_lam * z4 + s_lam * z5
        z7 = c_lam * z5 - s_lam * z4
        s1 = z * m_R + m_B * (z - x_B * z1 + e3z * k1)
        z8 = s1 + m_H * (Sz + z6 * k3 - z_H * z7)
        z9 = r_F * z7
        c_yaw = math.cos(yaw)
        z10 = 1.0 / math.sqrt(z1 * z1 + e3z * e3z)
        z11 = r_R * (z1 * z10)
        z12 = s_lam * s_steer
        R3 = z2 * z10
        z13 = R3 + k6
        z14 = 1.0 / math.sqrt(z6 * z6 + z7 * z7)
        z15 = r_F * (z6 * z14)
        z16 = k12 - z15
        z17 = s_steer * z16
        z18 = k7 + z11
        z19 = s_lam * c_steer
        z20 = k8 + s_lam * z19
        z21 = c_lam * (s_lam - z19)
        z22 = R3 * z21 + z20 * z11
        z23 = k7 * z20 + k6 * z21 + z22 + c_steer * z16
        s2 = s_pitch * (z12 * z13 - c_lam * z17)
        s3 = c_roll * (s2 - c_pitch * (z12 * z18 + s_lam * z17))
        z24 = s3 - e2z * z23
        z25 = c_lam * c_steer
        z26 = c_lam * z25 + k10
        z27 = s_lam * (c_lam - z25)
        z28 = R3 * z26 + z27 * z11
        z29 = c_lam * s_steer
        z30 = R3 * z29 - z12 * z11
        z31 = z9 * z14
        z32 = k9 - c_lam * z31 - s_lam * z15
        z33 = z29 * k6 - z12 * k7 + z30 - s_steer * z32
        z34 = z31 + k11
        z35 = c_steer * z34 + (k7 * z27 + k6 * z26 + z28)
        z36 = z28 * z33 - z35 * z30
        z37 = c_steer * z32
        z38 = k4 + s_lam * z31 - c_lam * z15
        s4 = s_pitch * (c_steer * z13 - c_lam * z37 + s_lam * z38)
        z39 = s4 - c_pitch * (c_steer * z18 + s_lam * z37 + c_lam * z38)
        z40 = c_roll * z39 - e2z * z33
        z41 = s_steer * z34
        s5 = s_pitch * (z29 * z13 + c_lam * z41)
        s6 = c_roll * (s5 + c_pitch * (s_lam * z41 - z29 * z18))
        z42 = s6 + e2z * z35
        z43 = z28 * z40 + z42 * z30
        z44 = z35 * z40 + z42 * z33
        z45 = 1.0 / (z24 * z36 - z23 * z43 + z22 * z44)
        z46 = roll_dot * c_pitch
        z47 = roll_dot * s_pitch
        z48 = steer_dot + (s_lam * z46 + c_lam * z47)
        z49 = s_lam * z47 - c_lam * z46
        z50 = c_steer * z49
        z51 = z46 * k6 + z47 * k7 + (z46 * R3 + z47 * z11)
        s7 = z31 * (s_lam * z48 - c_lam * z50)
        s8 = s7 - (s_lam * z50 + c_lam * z48) * z15
        z52 = s8 + (k9 * z50 + k4 * z48 + c_steer * z51)
        z53 = s_steer * z49
        z54 = thF_dot + z53
        z55 = k4 * z53
        z56 = k9 * z53 + s_steer * z51
        z57 = z31 * z54 + (s_lam * z55 - c_lam * z56)
        z58 = z35 * z52 - z33 * z57
        z59 = z40 * z57 + z42 * z52
        z60 = z54 * z15 - (c_lam * z55 + s_lam * z56)
        z61 = z28 * z52 - z30 * z57
        z62 = z45 * (z24 * z61 + z43 * z60 + z22 * z59)
        z63 = z45 * (z36 * z60 + z23 * z61 - z22 * z58)
        z64 = z62 + e2z * z63
        z65 = z45 * (z24 * z58 + z23 * z59 + z44 * z60) - z64
        a3 = z11 * z65
        a1 = R3 * z65
        z66 = s_pitch * a3 + c_pitch * a1
        s_yaw = math.sin(yaw)
        z67 = s_pitch * a1 - c_pitch * a3
        z68 = c_roll * z63
        v2_x = R3 * (z46 + s_pitch * z68) + z11 * (z47 - c_pitch * z68)
        z69 = e2z * z67 - c_roll * v2_x
        z70 = c_yaw * z66 - s_yaw * z69
        z71 = s_yaw * z63
        z72 = s_pitch * z62
        z73 = roll_dot * c_roll
        z74 = c_yaw * z63
        z75 = s_yaw * z73 - e2z * z74
        z76 = s_yaw * e2z
        z77 = c_pitch * z62
        z78 = c_pitch * z71 + c_yaw * z72 - (s_pitch * z75 - z76 * z77)
        z79 = s_pitch * z71 - c_yaw * z77 + (z76 * z72 + c_pitch * z75)
        z80 = z70 - k2 * z78 - r_R * z79
        z81 = steer_dot * s_steer
        s9 = (c_yaw * c_pitch - z76 * s_pitch) * c_lam
        s10 = (s9 - (c_yaw * s_pitch + c_pitch * z76) * s_lam) * z81
        z82 = s10 - c_steer * (c_lam * z78 - s_lam * z79)
        z83 = steer_dot * c_steer
        z84 = c_roll * z83
        z85 = roll_dot * e2z
        z86 = z82 + (s_yaw * z84 - s_steer * (s_yaw * z85 + c_roll * z74))
        z87 = s_lam * z78 + c_lam * z79
        z88 = c_lam * z86 - s_lam * z87
        z89 = c_lam * z87 + s_lam * z86
        z90 = z80 - c * z88 + r_F * z89
        z91 = s_yaw * z66 + c_yaw * z69
        z92 = c_yaw * e2z
        z93 = c_yaw * z73 + e2z * z71
        z94 = s_yaw * z72 - c_pitch * z74 - (z92 * z77 - s_pitch * z93)
        z95 = s_pitch * z74 + s_yaw * z77 + (z92 * z72 + c_pitch * z93)
        z96 = z91 - k2 * z94 + r_R * z95
        s11 = (c_pitch * s_yaw + s_pitch * z92) * c_lam
        s12 = (s11 - (s_yaw * s_pitch - c_pitch * z92) * s_lam) * z81
        z97 = s12 - c_steer * (c_lam * z94 + s_lam * z95)
        z98 = z97 - (c_yaw * z84 - s_steer * (c_yaw * z85 - c_roll * z71))
        z99 = s_lam * z94 - c_lam * z95
        z100 = c_lam * z98 - s_lam * z99
        z101 = c_lam * z99 + s_lam * z98
        z102 = z96 - c * z100 + r_F * z101
        z103 = s_pitch * z85 + c_roll * z77
        z104 = c_pitch * z85 - c_roll * z72
        z105 = s_lam * z103 - c_lam * z104
        s13 = z3 * z81 + c_steer * (c_lam * z103 + s_lam * z104)
        z106 = s_steer * z73 + e2z * z83 + s13
        z107 = c_lam * z105 - s_lam * z106
        z108 = c_roll * z67 + e2z * v2_x
        z109 = r_R * z104 - (z108 + k2 * z103)
        z110 = c_lam * z106 + s_lam * z105
        z111 = r_F * z107 + (z109 + c * z110)
        w1 = z46 + z1 * z63
        w3 = z47 - e3z * z63
        z112 = c_lam * w1 - s_lam * w3
        z113 = s_steer * z64 - c_steer * z112
        ws = steer_dot + (s_lam * w1 + c_lam * w3)
        z114 = c_lam * z113 - s_lam * ws
        z115 = z114 * z114
        o3 = c_lam * ws + s_lam * z113
        z116 = o3 * o3
        z117 = c_steer * z64 + s_steer * z112
        z118 = thF_dot - z117
        s14 = m_F * (z90 * z90 + z102 * z102 + z111 * z111)
        z119 = s14 + F_xx * (z115 + z116) + F_yy * (z118 * z118)
        z120 = z80 - k3 * z88 - z_H * z89
        z121 = z96 - k3 * z100 - z_H * z101
        z122 = z109 + k3 * z110 - z_H * z107
        s15 = H_xx * z115 + H_yy * (z117 * z117) + H_zz * z116
        z123 = m_H * (z120 * z120 + z121 * z121 + z122 * z122) + s15
        z124 = w1 * w1
        z125 = w3 * w3
        s16 = m_R * (z70 * z70 + z91 * z91 + z108 * z108)
        z126 = s16 + R_xx * (z124 + z125) + R_yy * (z65 * z65)
        z127 = z70 - x_B * z78 - k1 * z79
        z128 = z91 - x_B * z94 + k1 * z95
        Bz_dot = z108 + x_B * z103 - k1 * z104
        s17 = m_B * (z127 * z127 + z128 * z128 + Bz_dot * Bz_dot)
        z129 = s17 + (B_xx * z124 + B_yy * (z64 * z64) + B_zz * z125)
        s18 = 0.5 * z126 + (0.5 * z129 + B_xz * (w1 * w3))
        z130 = 0.5 * z123 - H_xz * (z114 * o3) + s18
        value1 = 0.5 * z119 + z130 - g * (z8 + m_F * (Sz + c * z6 + z9))
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
        k3 = r_F * s_lam - c * c_lam
        k4 = H_zz + F_xx
        k5 = H_xx + F_xx
        k6 = z_H * s_lam - c_lam * (x_H - k2)
        k7 = x_H * s_lam + c_lam * (r_R + z_H)
        k8 = c_lam * k2 - r_R * s_lam
        k9 = s_lam * k8
        k10 = c_lam * k8
        k11 = c_lam * c_lam
        k12 = w * s_lam + c_lam * (r_R - r_F)
        k13 = s_lam * s_lam
        k14 = s_lam * k3 - c_lam * k12
        k15 = c_lam * k3 + s_lam * k12
        k16 = abs(r_R)
        k17 = abs(r_F)
        k18 = abs(w)
        k19 = abs(c)
        k20 = 18.0 * k19 + (18.0 * k18 + (34.0 * k16 + 19.0 * k17))
        k21 = m_R + m_B
        k22 = m_B * k1
        k23 = x_B * m_B
        k24 = k1 * k22
        k25 = R_xx + B_xx + k24
        k26 = x_B * k23
        k27 = k24 + (B_yy + k26)
        k28 = B_xz - k1 * k23
        k29 = R_xx + B_zz + k26
        k30 = m_F * k12
        k31 = m_H + m_F
        k32 = m_H * k7
        k33 = k30 + k32
        k34 = m_F * k3
        k35 = m_H * k6
        k36 = k34 - k35
        k37 = H_xz * c_lam
        k38 = s_lam * k4 - k37
        k39 = H_xz * s_lam
        k40 = c_lam * k5 - k39
        k41 = k12 * k30
        k42 = k7 * k32
        k43 = c_lam * k40 + s_lam * k38 + k41 + k42
        k44 = s_lam * k40 - c_lam * k38 - k3 * k30 + k6 * k32
        k45 = k3 * k34
        k46 = k6 * k35
        k47 = k42 + (k41 + (H_yy + k45) + k46)
        k48 = k39 + c_lam * k4
        k49 = k37 + s_lam * k5
        k50 = c_lam * k49 - s_lam * k48 - k12 * k34 + k7 * k35
        k51 = k46 + (k45 + (s_lam * k49 + c_lam * k48))
        k52 = g * m_F
        k53 = g * m_H
        k54 = g * m_B
        k55 = g * k21
        k56 = x_B * k54
        k57 = k1 * k54
        k58 = k6 * k53
        k59 = k7 * k53
        k60 = g * k31
        k61 = k3 * k52
        k62 = k12 * k52
        k63 = k59 + k62
        k64 = k58 - k61
        # state
        c_roll = math.cos(roll)
        s_pitch = math.sin(pitch)
        s_steer = math.sin(steer)
        z1 = s_lam * s_steer
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = r_R * e3z
        z3 = s_pitch * c_roll
        z4 = z3 * z3 + e3z * e3z
        z5 = 1.0 / math.sqrt(z4)
        R3 = z2 * z5
        z6 = R3 + k9
        c_steer = math.cos(steer)
        z7 = z3 * c_lam + e3z * s_lam
        e2z = math.sin(roll)
        z8 = c_steer * z7 - e2z * s_steer
        z9 = z3 * s_lam - e3z * c_lam
        z10 = c_lam * z8 + s_lam * z9
        z11 = r_F * z10
        z12 = c_lam * z9 - s_lam * z8
        z13 = z10 * z10 + z12 * z12
        z14 = 1.0 / math.sqrt(z13)
        z15 = z11 * z14
        z16 = z15 - k15
        z17 = s_steer * z16
        z18 = z1 * z6 + c_lam * z17
        z19 = r_R * z3
        z20 = z19 * z5
        z21 = z20 + k10
        z22 = z1 * z21 - s_lam * z17
        z23 = s_pitch * z18 - c_pitch * z22
        z24 = s_lam * c_steer
        z25 = k11 + s_lam * z24
        z26 = c_lam * (s_lam - z24)
        z27 = z20 * z25 + R3 * z26
        z28 = c_steer * z16
        z29 = k10 * z25 + k9 * z26 + z27 - z28
        z30 = c_roll * z23 - e2z * z29
        z31 = c_lam * c_steer
        z32 = s_lam * (c_lam - z31)
        z33 = c_lam * z31 + k13
        z34 = z20 * z32 + R3 * z33
        z35 = c_lam * s_steer
        z36 = R3 * z35
        z37 = z20 * z1
        z38 = z36 - z37
        z39 = r_F * z12
        z40 = z39 * z14
        z41 = k12 - c_lam * z40 - s_lam * z15
        z42 = s_steer * z41
        z43 = z35 * k9 - z1 * k10 + z38 - z42
        z44 = z40 + k14
        z45 = c_steer * z44
        z46 = k10 * z32 + k9 * z33 + z34 + z45
        z47 = z34 * z43 - z46 * z38
        z48 = c_steer * z41
        z49 = s_lam * z40
        z50 = c_lam * z15
        z51 = k3 + z49 - z50
        z52 = c_steer * z6 - c_lam * z48 + s_lam * z51
        z53 = c_steer * z21 + s_lam * z48 + c_lam * z51
        z54 = s_pitch * z52 - c_pitch * z53
        z55 = c_roll * z54 - e2z * z43
        z56 = s_steer * z44
        z57 = z35 * z6 + c_lam * z56
        z58 = z35 * z21 - s_lam * z56
        z59 = s_pitch * z57 - c_pitch * z58
        z60 = c_roll * z59 + e2z * z46
        z61 = z34 * z55 + z60 * z38
        z62 = z46 * z55 + z60 * z43
        z63 = z30 * z47 - z29 * z61 + z27 * z62
        s1 = 24.0 * k16
        s2 = s1 + 33.0 * k17
        s3 = 14.0 * k18 + s2
        s4 = k20 * (13.0 * k19 + s3)
        # the coframe is singular
        if not abs(z63) > 1e-12 * (k20 * s4):
            raise SingularModelError(1, "jacobian")
        z64 = 1.0 / z63
        z65 = s_pitch * s_lam - c_pitch * c_lam
        z66 = s_steer * z65
        z67 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20)
        z68 = k12 * z66 + s_steer * z67
        z69 = k3 * z66
        z70 = z15 * z66 - (s_lam * z68 + c_lam * z69)
        z71 = c_pitch * s_lam + s_pitch * c_lam
        z72 = c_steer * z65
        z73 = s_lam * z71 - c_lam * z72
        z74 = s_lam * z72 + c_lam * z71
        z75 = z40 * z73 - z15 * z74 + (k12 * z72 + k3 * z71 + c_steer * z67)
        z76 = z40 * z66 + (s_lam * z69 - c_lam * z68)
        z77 = z34 * z75 - z38 * z76
        z78 = z46 * z75 - z43 * z76
        z79 = z47 * z70 + z29 * z77 - z27 * z78
        z80 = z64 * z79
        z81 = c_roll * z80
        z82 = s_pitch - c_pitch * z81
        z83 = c_pitch + s_pitch * z81
        z84 = c_lam * z82 + s_lam * z83
        z85 = R3 * z83 + z20 * z82
        z86 = z85 + (k10 * z82 + k9 * z83)
        z87 = z55 * z76 + z60 * z75
        z88 = z30 * z78 + z29 * z87 + z62 * z70
        z89 = z64 * z88
        z90 = z30 * z77 + z61 * z70 + z27 * z87
        z91 = z64 * z90
        z92 = z91 + e2z * z80
        z93 = z89 - z92
        z94 = R3 * z93
        z95 = z94 - k9 * z92
        z96 = z20 * z93
        z97 = z96 - k10 * z92
        z98 = c_lam * z95 - s_lam * z97
        z99 = c_steer * z86 + s_steer * z98
        z100 = c_lam * z83 - s_lam * z82
        z101 = s_steer * z92 - c_steer * z100
        z102 = k51 * z84 + (k36 * z99 - k50 * z101)
        z103 = c_steer * z92 + s_steer * z100
        z104 = c_steer * z98 - s_steer * z86
        z105 = c_lam * z97 + s_lam * z95
        z106 = k47 * z103 + (k33 * z104 - k36 * z105)
        z107 = k44 * z84 - (k33 * z99 + k43 * z101)
        z108 = k31 * z105 - k36 * z103
        z109 = k36 * z84 + (k31 * z99 + k33 * z101)
        z110 = k31 * z104 + k33 * z103
        z111 = z82 * k29 + (z85 * k23 + z83 * k28)
        z112 = z92 * k27 + (z94 * k22 - z96 * k23)
        z113 = z82 * k28 - (z85 * k22 - z83 * k25)
        z114 = z96 * k21 - z92 * k23
        z115 = z94 * k21 + z92 * k22
        z116 = z82 * k23 + (z85 * k21 - z83 * k22)
        s5 = z83 * z113 + (z96 * z114 + (z94 * z115 + z85 * z116))
        z117 = z82 * z111 + (z92 * z112 + s5)
        s6 = z105 * z108 + (z99 * z109 + (z104 * z110 + z117))
        z118 = z84 * z102 + (z103 * z106 - (z101 * z107 - s6))
        z119 = z118 + R_yy * (z93 * z93) + F_yy * (z103 * z103)
        # the mass matrix is singular
        if not abs(z119) > 0.0:
            raise SingularModelError(2, "jacobian")
        z120 = k3 + (z49 - z50)
        z121 = z34 * z120
        z122 = z46 * z120
        z123 = z29 * z121 - z27 * z122
        z124 = z64 * z123
        z125 = c_roll * z124
        z126 = c_pitch * z125
        z127 = s_pitch * z125
        z128 = 1.0 - (c_lam * z126 - s_lam * z127)
        z129 = R3 * z127 - z20 * z126
        z130 = z129 - (k10 * z126 - k9 * z127)
        z131 = z60 * z120
        z132 = z30 * z122 + z29 * z131
        z133 = z64 * z132
        z134 = z30 * z121 + z27 * z131
        z135 = z64 * z134
        z136 = z135 + e2z * z124
        z137 = z133 - z136
        z138 = R3 * z137
        z139 = z138 - k9 * z136
        z140 = z20 * z137
        z141 = z140 - k10 * z136
        z142 = c_lam * z139 - s_lam * z141
        z143 = c_steer * z130 + s_steer * z142
        z144 = c_lam * z127 + s_lam * z126
        z145 = s_steer * z136 - c_steer * z144
        z146 = k51 * z128 + (k36 * z143 - k50 * z145)
        z147 = c_steer * z136 + s_steer * z144
        z148 = c_steer * z142 - s_steer * z130
        z149 = c_lam * z141 + s_lam * z139
        z150 = k47 * z147 + (k33 * z148 - k36 * z149)
        z151 = k44 * z128 - (k33 * z143 + k43 * z145)
        z152 = k31 * z149 - k36 * z147
        z153 = k36 * z128 + (k31 * z143 + k33 * z145)
        z154 = k31 * z148 + k33 * z147
        z155 = z126 * k29 - (z129 * k23 + z127 * k28)
        z156 = z136 * k27 + (z138 * k22 - z140 * k23)
        z157 = z126 * k28 + (z129 * k22 - z127 * k25)
        z158 = z140 * k21 - z136 * k23
        z159 = z138 * k21 + z136 * k22
        z160 = z126 * k23 - (z129 * k21 - z127 * k22)
        s7 = z127 * z157 - (z140 * z158 + (z138 * z159 - z129 * z160))
        z161 = z126 * z155 + (z136 * z156 - s7)
        s8 = z149 * z152 + (z143 * z153 + (z148 * z154 + z161))
        z162 = z128 * z146 + (z147 * z150 - (z145 * z151 - s8))
        z163 = z162 + R_yy * (z137 * z137) + F_yy * (z147 * z147)
        s9 = z127 * z113 + (z140 * z114 + (z138 * z115 + z129 * z116))
        z164 = z126 * z111 - (z136 * z112 + s9)
        s10 = z149 * z108 + (z143 * z109 + (z148 * z110 - z164))
        z165 = z128 * z102 + (z147 * z106 - (z145 * z107 - s10))
        z166 = z165 + R_yy * (z93 * z137) + F_yy * (z103 * z147)
        z167 = 1.0 / z119
        z168 = z166 * z167
        z169 = z163 - z166 * z168
        # the mass matrix is singular
        if not abs(z169) > 1e-14 * z163:
            raise SingularModelError(2, "jacobian")
        z170 = z40 * z38
        z171 = z40 * z43
        z172 = z15 * z47 - z29 * z170 + z27 * z171
        z173 = z64 * z172
        z174 = c_roll * z173
        z175 = c_pitch * z174
        z176 = s_pitch * z174
        z177 = c_lam * z175 - s_lam * z176
        z178 = R3 * z176 - z20 * z175
        z179 = z178 - (k10 * z175 - k9 * z176)
        z180 = z40 * z55
        z181 = z30 * z171 - z29 * z180 - z15 * z62
        z182 = z64 * z181
        z183 = z30 * z170 - z15 * z61 - z27 * z180
        z184 = z64 * z183
        z185 = z184 - e2z * z173
        z186 = z182 - z185
        z187 = R3 * z186
        z188 = z187 - k9 * z185
        z189 = z20 * z186
        z190 = z189 - k10 * z185
        z191 = c_lam * z188 - s_lam * z190
        z192 = c_steer * z179 - s_steer * z191
        z193 = c_lam * z176 + s_lam * z175
        z194 = s_steer * z185 + c_steer * z193
        z195 = k51 * z177 - (k36 * z192 + k50 * z194)
        z196 = c_steer * z185 - s_steer * z193
        z197 = c_steer * z191 + s_steer * z179
        z198 = c_lam * z190 + s_lam * z188
        z199 = k47 * z196 + (k33 * z197 - k36 * z198)
        z200 = k44 * z177 + (k33 * z192 - k43 * z194)
        z201 = k31 * z198 - k36 * z196
        z202 = k36 * z177 - (k31 * z192 - k33 * z194)
        z203 = k31 * z197 + k33 * z196
        z204 = z175 * k29 - (z178 * k23 + z176 * k28)
        z205 = z185 * k27 + (z187 * k22 - z189 * k23)
        z206 = z175 * k28 + (z178 * k22 - z176 * k25)
        z207 = z189 * k21 - z185 * k23
        z208 = z187 * k21 + z185 * k22
        z209 = z175 * k23 - (z178 * k21 - z176 * k22)
        s11 = z176 * z206 - (z189 * z207 + (z187 * z208 - z178 * z209))
        z210 = z175 * z204 + (z185 * z205 - s11)
        s12 = z198 * z201 - (z192 * z202 - (z197 * z203 + z210))
        z211 = z177 * z195 + (z196 * z199 - (z194 * z200 - s12))
        z212 = 1.0 + z196
        z213 = z211 + R_yy * (z186 * z186) + F_yy * (z212 * z212)
        s13 = z176 * z113 - (z189 * z114 + (z187 * z115 - z178 * z116))
        z214 = z175 * z111 + (z185 * z112 - s13)
        s14 = z198 * z108 - (z192 * z109 - (z197 * z110 + z214))
        z215 = z177 * z102 + (z196 * z106 - (z194 * z107 - s14))
        z216 = z215 + R_yy * (z93 * z186) + F_yy * (z103 * z212)
        z217 = z216 * z167
        s15 = z176 * z157 + (z189 * z158 + (z187 * z159 + z178 * z160))
        z218 = z175 * z155 - (z185 * z156 + s15)
        s16 = z198 * z152 - (z192 * z153 - (z197 * z154 - z218))
        z219 = z177 * z146 + (z196 * z150 - (z194 * z151 - s16))
        s17 = z219 + R_yy * (z137 * z186) + F_yy * (z147 * z212)
        z220 = s17 - z166 * z217
        z221 = 1.0 / z169
        z222 = z220 * z221
        z223 = z213 - z216 * z217 - z220 * z222
        # the mass matrix is singular
        if not abs(z223) > 1e-14 * z213:
            raise SingularModelError(2, "jacobian")
        s_yaw = math.sin(yaw)
        z224 = roll_dot * c_pitch
        z225 = roll_dot * s_pitch
        z226 = s_lam * z224 + c_lam * z225
        z227 = steer_dot + z226
        z228 = s_lam * z225 - c_lam * z224
        z229 = c_steer * z228
        z230 = s_lam * z227 - c_lam * z229
        z231 = s_lam * z229 + c_lam * z227
        z232 = k12 * z229
        z233 = z224 * k9 + z225 * k10 + (z224 * R3 + z225 * z20)
        z234 = c_steer * z233
        z235 = z40 * z230 - z15 * z231 + (z232 + k3 * z227 + z234)
        z236 = s_steer * z228
        z237 = thF_dot + z236
        z238 = k3 * z236
        z239 = k12 * z236 + s_steer * z233
        z240 = z40 * z237 + (s_lam * z238 - c_lam * z239)
        z241 = z46 * z235 - z43 * z240
        z242 = z55 * z240 + z60 * z235
        z243 = z15 * z237 - (s_lam * z239 + c_lam * z238)
        z244 = z30 * z241 + z29 * z242 + z62 * z243
        z245 = z64 * z244
        z246 = z34 * z235 - z38 * z240
        z247 = z30 * z246 + z61 * z243 + z27 * z242
        z248 = z64 * z247
        z249 = z47 * z243 + z29 * z246 - z27 * z241
        z250 = z64 * z249
        z251 = e2z * z250
        z252 = z248 + z251
        z253 = z245 - z252
        a3 = z20 * z253
        z254 = s_pitch * a3
        a1 = R3 * z253
        z255 = c_pitch * a1
        z256 = z254 + z255
        c_yaw = math.cos(yaw)
        z257 = s_pitch * a1
        z258 = c_pitch * a3
        z259 = z257 - z258
        z260 = e2z * z259
        z261 = c_roll * z250
        z262 = s_pitch * z261
        w1_pitch = z224 + z262
        z263 = c_pitch * z261
        w3_pitch = z225 - z263
        v2_x = R3 * w1_pitch + z20 * w3_pitch
        z264 = c_roll * v2_x
        z265 = z260 - z264
        z266 = e2z * s_pitch
        z267 = 1.0 / z4
        z268 = c_pitch * e2z
        z269 = z267 * (z5 * (z3 * z266 + e3z * z268))
        z270 = z5 * (r_R * z266) - z19 * z269
        z271 = 1.0 / (z63 * z63)
        z272 = z5 * (r_R * z268) - z2 * z269
        z273 = c_steer * (c_lam * z266 + s_lam * z268) + c_roll * s_steer
        z274 = s_lam * z266 - c_lam * z268
        z275 = c_lam * z273 + s_lam * z274
        z276 = 1.0 / z13
        z277 = c_lam * z274 - s_lam * z273
        z278 = z276 * (z14 * (z10 * z275 + z12 * z277))
        z279 = z14 * (r_F * z275) - z11 * z278
        z280 = s_steer * z279
        z281 = z1 * z270
        s18 = s_pitch * (z1 * z272 + c_lam * z280)
        z282 = e2z * z23 + c_roll * (s18 - c_pitch * (z281 - s_lam * z280))
        z283 = z25 * z270 + z26 * z272
        z284 = z283 - c_steer * z279
        z285 = z282 + (c_roll * z29 - e2z * z284)
        z286 = z32 * z270 + z33 * z272
        z287 = z35 * z272
        z288 = z287 - z281
        z289 = z14 * (r_F * z277) - z39 * z278
        z290 = c_lam * z289 + s_lam * z279
        z291 = z288 + s_steer * z290
        z292 = z286 + c_steer * z289
        z293 = z43 * z286 + z34 * z291 - (z38 * z292 + z46 * z288)
        z294 = c_steer * z290
        z295 = s_lam * z289 - c_lam * z279
        s19 = s_pitch * (c_steer * z272 + c_lam * z294 + s_lam * z295)
        s20 = c_pitch * (c_steer * z270 - s_lam * z294 + c_lam * z295)
        z296 = s19 - s20
        z297 = e2z * z54 + c_roll * z296 + (c_roll * z43 - e2z * z291)
        z298 = s_steer * z289
        s21 = c_pitch * (z35 * z270 - s_lam * z298)
        z299 = e2z * z59 + c_roll * (s_pitch * (z287 + c_lam * z298) - s21)
        z300 = z299 - (c_roll * z46 - e2z * z292)
        z301 = z55 * z286 + z34 * z297 + (z38 * z300 + z60 * z288)
        z302 = z55 * z292 + z46 * z297 + (z43 * z300 + z60 * z291)
        s22 = z47 * z285 + z30 * z293 - (z61 * z284 + z29 * z301)
        z303 = s22 + (z62 * z283 + z27 * z302)
        z304 = z271 * z303
        z305 = z224 * z272 + z225 * z270
        z306 = z230 * z289 - z231 * z279 + c_steer * z305
        z307 = s_steer * z305
        z308 = z237 * z289 - c_lam * z307
        z309 = z235 * z292 + z46 * z306 - (z240 * z291 + z43 * z308)
        z310 = z240 * z297 + z55 * z308 + (z235 * z300 + z60 * z306)
        z311 = z237 * z279 - s_lam * z307
        s23 = z241 * z285 + z30 * z309 + (z242 * z284 + z29 * z310)
        z312 = s23 + (z243 * z302 + z62 * z311)
        z313 = z244 * z304 - z64 * z312
        z314 = z235 * z286 + z34 * z306 - (z240 * z288 + z38 * z308)
        s24 = z246 * z285 + z30 * z314 + (z243 * z301 + z61 * z311)
        z315 = s24 + (z242 * z283 + z27 * z310)
        z316 = z247 * z304 - z64 * z315
        s25 = z243 * z293 + z47 * z311 + (z246 * z284 + z29 * z314)
        z317 = s25 - (z241 * z283 + z27 * z309)
        z318 = z249 * z304 - z64 * z317
        z319 = z313 - (z316 + (z261 + e2z * z318))
        z320 = z253 * z270 - z20 * z319
        z321 = z253 * z272 - R3 * z319
        z322 = s_pitch * z320 + c_pitch * z321
        z323 = s_pitch * z321 - c_pitch * z320
        z324 = z251 - c_roll * z318
        s26 = w3_pitch * z270 - z20 * (c_pitch * z324)
        z325 = w1_pitch * z272 + R3 * (s_pitch * z324) + s26
        z326 = c_roll * z259 - e2z * z323 + (e2z * v2_x + c_roll * z325)
        z327 = z9 * c_steer
        z328 = c_lam * z327 - s_lam * z7
        z329 = c_lam * z7 + s_lam * z327
        z330 = z276 * (z14 * (z10 * z328 - z12 * z329))
        z331 = z14 * (r_F * z328) - z11 * z330
        z332 = s_steer * z331
        z333 = R3 * z1
        s27 = s_pitch * z22 - c_pitch * (z333 + s_lam * z332)
        z334 = c_pitch * z18 - s_pitch * (z37 + c_lam * z332) + s27
        z335 = R3 * z25 - z20 * z26
        z336 = z335 + c_steer * z331
        z337 = c_roll * z334 - e2z * z336
        z338 = R3 * z32 - z20 * z33
        z339 = z20 * z35
        z340 = z339 + z333
        z341 = z14 * (r_F * z329) + z39 * z330
        z342 = c_lam * z341 - s_lam * z331
        z343 = z340 - s_steer * z342
        z344 = z338 + c_steer * z341
        z345 = z43 * z338 - z34 * z343 - (z38 * z344 - z46 * z340)
        z346 = c_steer * z342
        z347 = s_lam * z341 + c_lam * z331
        s28 = s_pitch * (c_steer * z20 - c_lam * z346 - s_lam * z347)
        s29 = c_pitch * (c_steer * R3 - s_lam * z346 + c_lam * z347)
        z348 = c_pitch * z52 - s28 + (s_pitch * z53 - s29)
        z349 = c_roll * z348 + e2z * z343
        z350 = s_steer * z341
        s30 = c_pitch * z57 - s_pitch * (z339 - c_lam * z350)
        z351 = s30 + (s_pitch * z58 - c_pitch * (z36 - s_lam * z350))
        z352 = c_roll * z351 + e2z * z344
        z353 = z55 * z338 + z34 * z349 + (z38 * z352 - z60 * z340)
        z354 = z55 * z344 + z46 * z349 + (z43 * z352 - z60 * z343)
        s31 = z47 * z337 + z30 * z345 - (z61 * z336 + z29 * z353)
        z355 = s31 + (z62 * z335 + z27 * z354)
        z356 = z271 * z355
        z357 = c_steer * z226
        s32 = z230 * z341 - z40 * (s_lam * z228 + c_lam * z357)
        z358 = s32 + (z231 * z331 - z15 * (s_lam * z357 - c_lam * z228))
        z359 = z225 * k9 - z224 * k10
        z360 = z358 + (k12 * z357 - k3 * z228 - c_steer * z359)
        z361 = s_steer * z226
        z362 = k3 * z361
        z363 = k12 * z361 - s_steer * z359
        z364 = z237 * z341 + z40 * z361 + (s_lam * z362 - c_lam * z363)
        z365 = z235 * z344 + z46 * z360 + (z240 * z343 - z43 * z364)
        z366 = z240 * z349 + z55 * z364 + (z235 * z352 + z60 * z360)
        z367 = z237 * z331 - z15 * z361 + (s_lam * z363 + c_lam * z362)
        s33 = z241 * z337 + z30 * z365 + (z242 * z336 + z29 * z366)
        z368 = s33 + (z243 * z354 - z62 * z367)
        z369 = z244 * z356 - z64 * z368
        z370 = z235 * z338 + z34 * z360 + (z240 * z340 - z38 * z364)
        s34 = z246 * z337 + z30 * z370 + (z243 * z353 - z61 * z367)
        z371 = s34 + (z242 * z335 + z27 * z366)
        z372 = z247 * z356 - z64 * z371
        s35 = z243 * z345 - z47 * z367 + (z246 * z336 + z29 * z370)
        z373 = s35 - (z241 * z335 + z27 * z365)
        z374 = z249 * z356 - z64 * z373
        z375 = z369 - (z372 + e2z * z374)
        z376 = a1 - z20 * z375
        z377 = a3 + R3 * z375
        z378 = z258 + s_pitch * z376 - (z257 + c_pitch * z377)
        z379 = z255 - s_pitch * z377 + (z254 - c_pitch * z376)
        z380 = c_roll * z374
        s36 = z20 * w1_pitch + R3 * (z225 - (z263 - s_pitch * z380))
        z381 = s36 - (R3 * w3_pitch + z20 * (z224 + (z262 + c_pitch * z380)))
        z382 = e2z * z379 + c_roll * z381
        h2z = e2z * c_steer + s_steer * z7
        z383 = c_lam * h2z
        z384 = s_lam * h2z
        z385 = z276 * (z14 * (z10 * z383 - z12 * z384))
        z386 = z14 * (r_F * z383) - z11 * z385
        z387 = z28 - s_steer * z386
        z388 = s_lam * z1
        z389 = c_lam * z1
        z390 = z20 * z388 - R3 * z389
        z391 = k10 * z388 - k9 * z389 + z390 - (z17 + c_steer * z386)
        s37 = c_pitch * (z21 * z24 - s_lam * z387)
        s38 = c_roll * (s_pitch * (z6 * z24 + c_lam * z387) - s37)
        z392 = s38 + e2z * z391
        z393 = s_lam * z35
        z394 = c_lam * z35
        z395 = z20 * z393 - R3 * z394
        z396 = R3 * z31 - z20 * z24
        z397 = z14 * (r_F * z384) + z39 * z385
        z398 = c_lam * z397 - s_lam * z386
        z399 = k9 * z31 - k10 * z24 + z396 - (z48 - s_steer * z398)
        z400 = k10 * z393 - k9 * z394 + z395 - (z56 - c_steer * z397)
        z401 = z43 * z395 + z34 * z399 - (z38 * z400 + z46 * z396)
        z402 = z42 + c_steer * z398
        z403 = s_lam * z397 + c_lam * z386
        s39 = c_pitch * (s_steer * z21 + s_lam * z402 - c_lam * z403)
        z404 = s_pitch * (s_steer * z6 - c_lam * z402 - s_lam * z403) - s39
        z405 = c_roll * z404 + e2z * z399
        z406 = z45 + s_steer * z397
        s40 = c_pitch * (z31 * z21 - s_lam * z406)
        s41 = c_roll * (s_pitch * (z31 * z6 + c_lam * z406) - s40)
        z407 = s41 + e2z * z400
        z408 = z55 * z395 - z34 * z405 + (z38 * z407 + z60 * z396)
        z409 = z55 * z400 - z46 * z405 + (z43 * z407 + z60 * z399)
        s42 = z47 * z392 + z30 * z401 + (z61 * z391 - z29 * z408)
        z410 = s42 - (z62 * z390 - z27 * z409)
        z411 = z271 * z410
        s43 = z230 * z397 + z40 * (c_lam * z236)
        z412 = z239 - (s43 + (z231 * z386 + z15 * (s_lam * z236)))
        z413 = k3 * z229
        z414 = z232 + z234
        z415 = z237 * z397 + z40 * z229 + (s_lam * z413 - c_lam * z414)
        z416 = z235 * z400 - z46 * z412 - (z240 * z399 + z43 * z415)
        z417 = z240 * z405 - z55 * z415 - (z235 * z407 - z60 * z412)
        z418 = z237 * z386 - z15 * z229 + (s_lam * z414 + c_lam * z413)
        s44 = z241 * z392 + z30 * z416 - (z242 * z391 + z29 * z417)
        z419 = s44 + (z243 * z409 - z62 * z418)
        z420 = z244 * z411 - z64 * z419
        z421 = z235 * z395 - z34 * z412 - (z240 * z396 + z38 * z415)
        s45 = z246 * z392 + z30 * z421 + (z243 * z408 - z61 * z418)
        z422 = s45 - (z242 * z390 + z27 * z417)
        z423 = z247 * z411 - z64 * z422
        s46 = z243 * z401 - z47 * z418 - (z246 * z391 - z29 * z421)
        z424 = s46 + (z241 * z390 - z27 * z416)
        z425 = z249 * z411 - z64 * z424
        z426 = z420 - (z423 + e2z * z425)
        z427 = z20 * z426
        z428 = R3 * z426
        z429 = s_pitch * z427 + c_pitch * z428
        z430 = s_pitch * z428 - c_pitch * z427
        z431 = c_roll * z425
        z432 = R3 * (s_pitch * z431) - z20 * (c_pitch * z431)
        z433 = e2z * z430 - c_roll * z432
        z434 = s_pitch * z94 - c_pitch * z96
        z435 = e2z * z434 - c_roll * z85
        z436 = s_pitch * z96 + c_pitch * z94
        z437 = s_pitch * z138 - c_pitch * z140
        z438 = e2z * z437 - c_roll * z129
        z439 = s_pitch * z140 + c_pitch * z138
        z440 = s_pitch * z187 - c_pitch * z189
        z441 = e2z * z440 + c_roll * z178
        z442 = s_pitch * z189 + c_pitch * z187
        z443 = 1.0 / z223
        z444 = steer_dot * s_steer
        z445 = roll_dot * e2z
        z446 = c_pitch * z248
        z447 = s_pitch * z445 + c_roll * z446
        z448 = s_pitch * z248
        z449 = c_pitch * z445 - c_roll * z448
        z450 = s_lam * z447 - c_lam * z449
        z451 = roll_dot * c_roll
        z452 = steer_dot * c_steer
        z453 = c_lam * z447 + s_lam * z449
        z454 = s_steer * z451 + e2z * z452 + (z7 * z444 + c_steer * z453)
        z455 = c_lam * z450 - s_lam * z454
        z456 = r_F * z455
        z457 = c_lam * z454 + s_lam * z450
        z458 = z10 * z457 + z12 * z455
        z459 = z14 * z458
        z460 = z276 * z459
        z461 = z14 * z456 - z39 * z460
        z462 = roll_dot * z448
        z463 = roll_dot * z446
        z464 = s_lam * z462 - c_lam * z463
        z465 = s_lam * z463 + c_lam * z462
        z466 = z444 * z228 + c_steer * z465
        z467 = s_lam * z464 + c_lam * z466
        z468 = r_F * z457
        z469 = z14 * z468 - z11 * z460
        z470 = s_lam * z466 - c_lam * z464
        z471 = r_R * z449
        z472 = z3 * z447 + e3z * z449
        z473 = z5 * z472
        z474 = z267 * z473
        z475 = z5 * z471 - z2 * z474
        z476 = r_R * z447
        z477 = z5 * z476 - z19 * z474
        s47 = R3 * z462 - z224 * z475 - (z20 * z463 + z225 * z477)
        z478 = k9 * z462 - k10 * z463 + s47
        s48 = k12 * z466 - k3 * z464 + (z444 * z233 - c_steer * z478)
        z479 = z230 * z461 - z40 * z467 - (z231 * z469 + z15 * z470) + s48
        z480 = c_lam * z452
        z481 = z35 * z475
        z482 = s_lam * z452
        z483 = z1 * z477
        z484 = R3 * z480 - z481 - (z20 * z482 - z483)
        z485 = c_lam * z461 + s_lam * z469
        z486 = z444 * z41 - c_steer * z485
        z487 = s_lam * z461 - c_lam * z469
        z488 = z444 * z6 + c_steer * z475 - c_lam * z486 + s_lam * z487
        z489 = z444 * z21 + c_steer * z477 + s_lam * z486 + c_lam * z487
        z490 = z52 * z446 + s_pitch * z488 + (z53 * z448 - c_pitch * z489)
        z491 = k9 * z480 - k10 * z482 + z484 - (z452 * z41 + s_steer * z485)
        z492 = z445 * z54 + c_roll * z490 + (z451 * z43 + e2z * z491)
        z493 = z479 - (z245 * z484 - (z250 * z492 + z248 * z491))
        z494 = z452 * z228 - s_steer * z465
        z495 = k3 * z494
        z496 = k12 * z494 + (z452 * z233 + s_steer * z478)
        z497 = c_lam * z444
        z498 = s_lam * z497
        z499 = c_lam * z497
        z500 = z20 * z498 - z32 * z477 - (R3 * z499 + z33 * z475)
        z501 = z452 * z44 - s_steer * z461
        z502 = z6 * z480 - z481 + c_lam * z501
        z503 = z21 * z480 - z35 * z477 - s_lam * z501
        z504 = z57 * z446 - s_pitch * z502 + (z58 * z448 + c_pitch * z503)
        z505 = k10 * z498 - k9 * z499 + z500 - (z444 * z44 + c_steer * z461)
        z506 = z445 * z59 + c_roll * z504 - (z451 * z46 + e2z * z505)
        s49 = z237 * z461 - z40 * z494 - (s_lam * z495 - c_lam * z496)
        z507 = s49 - (z245 * z500 + (z250 * z506 - z248 * z505))
        z508 = z34 * z493 - z38 * z507
        z509 = s_lam * z444
        z510 = s_lam * z509
        z511 = c_lam * z509
        z512 = z20 * z510 + z25 * z477 - (R3 * z511 - z26 * z475)
        z513 = z452 * z16 - s_steer * z469
        z514 = z6 * z482 - z1 * z475 + c_lam * z513
        z515 = z21 * z482 - z483 - s_lam * z513
        z516 = z18 * z446 - s_pitch * z514 + (z22 * z448 + c_pitch * z515)
        z517 = k10 * z510 - k9 * z511 + z512 - (z444 * z16 + c_steer * z469)
        z518 = z445 * z23 + c_roll * z516 + (z451 * z29 - e2z * z517)
        s50 = z237 * z469 - z15 * z494 + (s_lam * z496 + c_lam * z495)
        z519 = s50 - (z245 * z512 + (z250 * z518 - z248 * z517))
        z520 = z55 * z507 + z60 * z493
        z521 = z30 * z508 + z61 * z519 + z27 * z520
        z522 = z46 * z493 - z43 * z507
        z523 = z47 * z519 + z29 * z508 - z27 * z522
        z524 = z64 * z523
        z525 = z64 * z521 - (z451 * z250 - e2z * z524)
        z526 = c_lam * w1_pitch - s_lam * w3_pitch
        z527 = z445 * z250 + c_roll * z524
        z528 = z462 - (z261 * z446 + s_pitch * z527)
        z529 = z463 + (z261 * z448 - c_pitch * z527)
        z530 = c_lam * z528 + s_lam * z529
        z531 = z444 * z252 + c_steer * z525 - (z452 * z526 + s_steer * z530)
        z532 = z30 * z522 + z29 * z520 + z62 * z519
        z533 = z64 * z532 - z525
        z534 = c_lam * z529 - s_lam * z528
        s51 = w1_pitch * z475 - R3 * z528 + (w3_pitch * z477 + z20 * z529)
        z535 = s51 + (a1 * w3_pitch - a3 * w1_pitch)
        z536 = k9 * z252
        z537 = k10 * z252
        s52 = k10 * z529 - k9 * z528 - (w3_pitch * z536 - w1_pitch * z537)
        z538 = z535 + s52
        z539 = z253 * z475 + R3 * z533 + (z252 * a3 - w3_pitch * v2_x)
        z540 = k10 * w3_pitch + k9 * w1_pitch
        z541 = z539 - (k9 * z525 + (z252 * z537 + w3_pitch * z540))
        z542 = z253 * z477 + z20 * z533 + (w1_pitch * v2_x - z252 * a1)
        z543 = z542 - (k10 * z525 - (w1_pitch * z540 + z252 * z536))
        z544 = c_lam * z541 - s_lam * z543
        z545 = c_steer * z538 + s_steer * z544
        z546 = z452 * z252 - s_steer * z525 + (z444 * z526 - c_steer * z530)
        z547 = s_steer * z252 - c_steer * z526
        z548 = c_steer * z252 + s_steer * z526
        z549 = F_yy * (thF_dot - z548) - k47 * z548
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z550 = k43 * z547 - k44 * w3_steer
        s53 = k51 * z534 + (k36 * z545 + k50 * z546)
        z551 = h2z * k64 - (s53 + (z547 * z549 + z548 * z550))
        z552 = c_steer * z544 - s_steer * z538
        z553 = c_lam * z543 + s_lam * z541
        z554 = k50 * z547 - k51 * w3_steer
        s54 = k47 * z531 + (k33 * z552 - k36 * z553)
        s55 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61)
        z555 = s55 + (s54 - (w3_steer * z550 + z547 * z554))
        s56 = k44 * z534 - (k33 * z545 - k43 * z546)
        z556 = h2z * k63 - (s56 - (z548 * z554 - w3_steer * z549))
        z557 = k33 * z547 + k36 * w3_steer
        z558 = k33 * z548
        s57 = k31 * z553 - k36 * z531 - (z547 * z557 + z548 * z558)
        z559 = z9 * k60 + s57
        z560 = k36 * z548
        s58 = k36 * z534 + (k31 * z545 - k33 * z546)
        z561 = h2z * k60 + (s58 + (w3_steer * z558 - z547 * z560))
        s59 = k31 * z552 + k33 * z531 - (z548 * z560 + w3_steer * z557)
        z562 = z8 * k60 + s59
        z563 = R_yy * z253 - k27 * z252
        z564 = k25 * w1_pitch + k28 * w3_pitch
        s60 = k29 * z529 + (k23 * z535 - k28 * z528)
        z565 = e2z * k56 + (s60 - (w1_pitch * z563 + z252 * z564))
        z566 = k28 * w1_pitch + k29 * w3_pitch
        s61 = k27 * z525 + (k22 * z539 - k23 * z542)
        s62 = s61 + (w3_pitch * z564 - w1_pitch * z566)
        z567 = z3 * k57 + e3z * k56 + s62
        s63 = k28 * z529 - (k22 * z535 + k25 * z528)
        z568 = e2z * k57 - (s63 + (z252 * z566 + w3_pitch * z563))
        z569 = k22 * w1_pitch - k23 * w3_pitch
        z570 = k22 * z252
        s64 = k21 * z542 - k23 * z525 - (w1_pitch * z569 + z252 * z570)
        z571 = e3z * k55 - s64
        z572 = k23 * z252
        s65 = k23 * z529 + (k21 * z535 + k22 * z528)
        z573 = e2z * k55 + (s65 + (w3_pitch * z570 + w1_pitch * z572))
        s66 = k21 * z539 + k22 * z525 - (z252 * z572 - w3_pitch * z569)
        z574 = z3 * k55 + s66
        z575 = 1.0 / (z13 * z13)
        z576 = 1.0 / (z4 * z4)
        s67 = z176 * z568 - (z189 * z571 - (z187 * z574 - z178 * z573))
        z577 = z175 * z565 + (z185 * z567 + s67)
        s68 = z198 * z559 - (z192 * z561 - (z197 * z562 + z577))
        z578 = z177 * z551 - (z196 * z555 + (z194 * z556 + s68))
        s69 = z83 * z568 + (z96 * z571 - (z94 * z574 + z85 * z573))
        z579 = z82 * z565 + (z92 * z567 - s69)
        s70 = z105 * z559 + (z99 * z561 + (z104 * z562 + z579))
        z580 = z84 * z551 - (z103 * z555 + (z101 * z556 + s70))
        z581 = z580 - R_yy * (z93 * z533) - F_yy * (z103 * z531)
        s71 = z127 * z568 + (z140 * z571 - (z138 * z574 + z129 * z573))
        z582 = z126 * z565 - (z136 * z567 - s71)
        s72 = z149 * z559 + (z143 * z561 + (z148 * z562 - z582))
        z583 = z128 * z551 - (z147 * z555 + (z145 * z556 + s72))
        s73 = z583 - R_yy * (z137 * z533) - F_yy * (z147 * z531)
        z584 = s73 - z581 * z168
        s74 = z578 - R_yy * (z186 * z533) - F_yy * (z212 * z531)
        z585 = z443 * (s74 - z581 * z217 - z222 * z584)
        z586 = z221 * z584 - z222 * z585
        z587 = z581 * z167 - z168 * z586 - z217 * z585
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_yaw * z256 + c_yaw * z265,
            # (I.2.15)
            c_yaw * z322 + s_yaw * z326,
            # (I.2.15)
            s_yaw * z382 - c_yaw * z378,
            # (I.2.15)
            c_yaw * z429 - s_yaw * z433,
            0.0,
            0.0,
            # (I.2.15)
            s_yaw * z435 - c_yaw * z436,
            # (I.2.15)
            s_yaw * z438 - c_yaw * z439,
            # (I.2.15)
            c_yaw * z442 - s_yaw * z441,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            s_yaw * z265 - c_yaw * z256,
            # (I.2.15)
            s_yaw * z322 - c_yaw * z326,
            # (I.2.15)
            -(s_yaw * z378 + c_yaw * z382),
            # (I.2.15)
            s_yaw * z429 + c_yaw * z433,
            0.0,
            0.0,
            # (I.2.15)
            -(s_yaw * z436 + c_yaw * z435),
            # (I.2.15)
            -(s_yaw * z439 + c_yaw * z438),
            # (I.2.15)
            s_yaw * z442 + c_yaw * z441,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            z264 - e2z * z325 - (z260 + c_roll * z323),
            # (I.2.15)
            c_roll * z379 - e2z * z381,
            # (I.2.15)
            -(c_roll * z430 + e2z * z432),
            0.0,
            0.0,
            # (I.2.15)
            e2z * z85 + c_roll * z434,
            # (I.2.15)
            e2z * z129 + c_roll * z437,
            # (I.2.15)
            e2z * z178 - c_roll * z440,
            0.0,
            0.0,
            0.0,
            0.0,
            # (I.2.15)
            -z318,
            # (I.2.15)
            z374,
            # (I.2.15)
            z425,
            0.0,
            0.0,
            # (I.2.15)
            -z80,
            # (I.2.15)
            -z124,
            # (I.2.15)
            -z173,
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
            # (I.2.15)
            -z316,
            # (I.2.15)
            z372,
            # (I.2.15)
            z423,
            0.0,
            0.0,
            # (I.2.15)
            -z91,
            # (I.2.15)
            -z135,
            # (I.2.15)
            z184,
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
            # (I.2.15)
            z313,
            # (I.2.15)
            -z369,
            # (I.2.15)
            -z420,
            0.0,
            0.0,
            # (I.2.15)
            z89,
            # (I.2.15)
            z133,
            # (I.2.15)
            -z182,
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
        # one rate in each pass: its row of the matrix
        offsets1 = (108, 120, 132)
        for k65, offset1 in enumerate(offsets1):
            row_0 = 1.0 if k65 == 0 else 0.0
            row_1 = 1.0 if k65 == 1 else 0.0
            row_2 = 1.0 if k65 == 2 else 0.0
            z588 = row_1 - z168 * row_0
            z589 = z443 * (row_2 + z217 * row_0 + z222 * z588)
            z590 = z221 * z588 + z222 * z589
            z591 = z167 * row_0 - z168 * z590 + z217 * z589
            z592 = z185 * z589 - z136 * z590 - z92 * z591
            z593 = z189 * z589 - z140 * z590 - z96 * z591
            z594 = z187 * z589 - z138 * z590 - z94 * z591
            z595 = z177 * z589 - z128 * z590 - z84 * z591
            z596 = z194 * z589 - z145 * z590 - z101 * z591
            z597 = z192 * z589 + z143 * z590 + z99 * z591
            z598 = k36 * z595 + k33 * z596 - k31 * z597
            z599 = z196 * z589 - z147 * z590 - z103 * z591
            z600 = z197 * z589 - z148 * z590 - z104 * z591
            z601 = k33 * z599 + k31 * z600
            z602 = s_steer * z598 + c_steer * z601
            z603 = z198 * z589 - z149 * z590 - z105 * z591
            z604 = k36 * z599 - k31 * z603
            z605 = s_lam * z602 + c_lam * z604
            z606 = c_lam * z602 - s_lam * z604
            z607 = F_yy * z589
            z608 = F_yy * z590
            z609 = F_yy * z591
            s75 = z212 * z607 - z147 * z608 - z103 * z609 + k47 * z599
            z610 = s75 - k36 * z603 + k33 * z600
            s76 = k27 * z592 - k23 * z593 + k22 * z594 + k10 * z605
            z611 = s76 - k9 * z606 + c_steer * z610
            z612 = k50 * z595 - k43 * z596 + k33 * z597
            z613 = R_yy * z589
            z614 = R_yy * z590
            z615 = R_yy * z591
            z616 = k23 * z592 - k21 * z593 + z605
            z617 = k22 * z592 + k21 * z594 + z606
            s77 = z186 * z613 - z137 * z614 - z93 * z615 - z20 * z616
            z618 = s77 + R3 * z617
            z619 = z611 - s_steer * z612 - z618
            z620 = z64 * z618
            z621 = z64 * z619
            z622 = z175 * z589 + z126 * z590 - z82 * z591
            z623 = z176 * z589 + z127 * z590 + z83 * z591
            z624 = z178 * z589 + z129 * z590 + z85 * z591
            z625 = c_steer * z598 - s_steer * z601
            z626 = s_steer * z610 + c_steer * z612
            z627 = k51 * z595 - k44 * z596 - k36 * z597
            s78 = k29 * z622 - k28 * z623 - k23 * z624 + k10 * z625
            z628 = s78 - s_lam * z626 + c_lam * z627
            z629 = k23 * z622 + k22 * z623 - k21 * z624 + z625
            z630 = z628 + z20 * z629
            s79 = k28 * z622 - k25 * z623 + k22 * z624 + k9 * z625
            z631 = s79 + c_lam * z626 + s_lam * z627
            z632 = z631 + R3 * z629
            z633 = c_pitch * z630 - s_pitch * z632
            z634 = c_roll * z633 - e2z * z619
            z635 = z64 * z634
            z636 = z62 * z620 + z61 * z621 - z47 * z635
            z637 = z250 * z636
            z638 = z29 * z620 + z27 * z621
            z639 = z30 * z620 + z27 * z635
            z640 = z30 * z621 - z29 * z635
            z641 = z60 * z638 + z46 * z639 + z34 * z640
            z642 = z250 * z641
            z643 = z55 * z638 - z43 * z639 - z38 * z640
            z644 = z250 * z643
            z645 = z248 * z641 + e2z * z642
            z646 = c_roll * z642
            z647 = s_pitch * z646
            z648 = c_pitch * z646
            z649 = c_lam * z647 + s_lam * z648
            z650 = s_steer * z645 - c_steer * z649
            z651 = c_lam * z648 - s_lam * z647
            z652 = z248 * z643 + e2z * z644
            z653 = c_roll * z644
            z654 = s_pitch * z653
            z655 = c_pitch * z653
            z656 = c_lam * z654 + s_lam * z655
            s80 = z237 * z643 + z230 * z641 - c_lam * z650 - s_lam * z651
            z657 = s80 - c_steer * z652 - s_steer * z656
            z658 = z248 * z636 + e2z * z637
            z659 = c_roll * z637
            z660 = s_pitch * z659
            z661 = c_pitch * z659
            z662 = c_lam * z660 + s_lam * z661
            s81 = z231 * z641 - z237 * z636 + c_steer * z658 + s_steer * z662
            z663 = s81 - c_lam * z651 + s_lam * z650
            z664 = z39 * z657 - z11 * z663
            z665 = z276 * z664
            z666 = z14 * z665
            z667 = z12 * z666 - r_F * (z14 * z657)
            z668 = z10 * z666 + r_F * (z14 * z663)
            z669 = s_lam * z667 - c_lam * z668
            s82 = z250 * z619 + z29 * z637 - z43 * z642 - z46 * z644
            z670 = s82 - s_steer * z669
            z671 = w1_pitch * z629
            z672 = c_lam * z643 + s_lam * z636
            z673 = c_steer * z641 - s_steer * z672
            z674 = z245 * z636 - z658
            z675 = z245 * z643 - z652
            s83 = z671 + z253 * z617 + z224 * z673 - z26 * z674 - z1 * z660
            z676 = s83 + c_steer * z647 + z33 * z675
            z677 = z245 * z641 - z645
            z678 = z677 - z654
            z679 = z676 + z35 * z678
            z680 = w3_pitch * z629
            z681 = z661 - z677
            s84 = z680 - z253 * z616 + z225 * z673 - z25 * z674 + z1 * z681
            z682 = s84 - c_steer * z648 + z32 * z675
            z683 = z682 + z35 * z655
            z684 = z2 * z679 + z19 * z683
            z685 = z267 * z684
            z686 = z5 * z685
            z687 = c_steer * z669
            z688 = c_lam * z667 + s_lam * z668
            z689 = e3z * z686 - r_R * (z5 * z679) - s_lam * z687 - c_lam * z688
            z690 = z3 * z686 - r_R * (z5 * z683) - c_lam * z687 + s_lam * z688
            s85 = z524 * z633 + z516 * z637 - z490 * z642 + z504 * z644
            z691 = s85 - z448 * z689 + z446 * z690
            z692 = w1_pitch * z592 + z252 * z623
            z693 = z252 * z622 - w3_pitch * z592
            s86 = z570 * z624 - z569 * z594 - z564 * z592 + z563 * z623
            z694 = s86 + k29 * z692 + k28 * z693
            z695 = w1_pitch * z593 - w3_pitch * z594
            s87 = z694 - k23 * z695 + z536 * z625 + z540 * z606 - a1 * z629
            z696 = s87 + v2_x * z617 - z477 * z629
            z697 = w1_pitch * z605 + w3_pitch * z606
            z698 = z547 * z595 - w3_steer * z596
            s88 = z558 * z603 + z560 * z600 - z550 * z595 - z554 * z596
            z699 = s88 + k47 * z698 - k36 * (z547 * z597 - z548 * z600)
            z700 = F_yy * z698
            z701 = z699 + k33 * (z548 * z603 + w3_steer * z597) + z700
            z702 = z547 * z599 - z548 * z596
            z703 = z548 * z595 - w3_steer * z599
            s89 = z557 * z603 - z560 * z597 - z549 * z595 + z554 * z599
            z704 = s89 + k50 * z702 - k43 * z703
            z705 = z547 * z603 + w3_steer * z600
            z706 = z704 + k33 * z705
            z707 = z452 * z610 - z444 * z612 + s_steer * z701 - c_steer * z706
            s90 = z558 * z597 + z557 * z600 + z550 * z599 + z549 * z596
            z708 = s90 - k51 * z702 + k44 * z703
            z709 = z708 + k36 * z705
            z710 = w1_pitch * z616 + w3_pitch * z617
            z711 = z696 + k10 * z697 - s_lam * z707 + c_lam * z709 + z20 * z710
            s91 = z569 * z593 + z572 * z624 + z563 * z622 + z566 * z592
            z712 = s91 + k28 * z692 + k25 * z693
            s92 = z712 + k22 * z695 + z540 * z605 - z537 * z625 + v2_x * z616
            z713 = s92 + a3 * z629 - z475 * z629
            z714 = z713 + k9 * z697 + c_lam * z707 + s_lam * z709 + R3 * z710
            z715 = z448 * z630 + z446 * z632 + c_pitch * z711 - s_pitch * z714
            z716 = z585 * z589
            z717 = z175 * z716
            z718 = z176 * z716
            z719 = z178 * z716
            z720 = z586 * z589 - z585 * z590
            s93 = z565 * z589 + z204 * z716 + k29 * z717 - k28 * z718
            z721 = s93 - k23 * z719 - z155 * z720
            z722 = z587 * z589 - z585 * z591
            z723 = z177 * z716
            z724 = z194 * z716
            z725 = z192 * z716
            s94 = z551 * z589 - z195 * z716 - k51 * z723 + k44 * z724
            z726 = s94 + k36 * z725 - z146 * z720
            z727 = z726 - z102 * z722
            z728 = F_yy * z720
            z729 = F_yy * z722
            z730 = z196 * z716
            z731 = z198 * z716
            z732 = z197 * z716
            s95 = z555 * z589 + z199 * z716 + k47 * z730 - k36 * z731
            z733 = s95 + k33 * z732 + z150 * z720
            s96 = z531 * z607 + 2.0 * (z212 * (F_yy * z716)) + z147 * z728
            z734 = s96 + z103 * z729 + (z733 + z106 * z722)
            s97 = z556 * z589 - z200 * z716 - k50 * z723 + k43 * z724
            z735 = s97 - k33 * z725 - z151 * z720
            z736 = z735 - z107 * z722
            z737 = s_steer * z734 - c_steer * z736
            s98 = z561 * z589 + z202 * z716 + k36 * z723 + k33 * z724
            z738 = s98 - k31 * z725 + z153 * z720
            z739 = z738 + z109 * z722
            s99 = z562 * z589 + z203 * z716 + k33 * z730 + k31 * z732
            z740 = s99 + z154 * z720 + z110 * z722
            z741 = c_steer * z739 - s_steer * z740
            s100 = z573 * z589 + z209 * z716 + k23 * z717 + k22 * z718
            z742 = s100 - k21 * z719 - z160 * z720
            z743 = z742 + z116 * z722 + z741
            s101 = z721 + z111 * z722 - c_lam * z727 - s_lam * z737
            z744 = s101 + k10 * z741 + z20 * z743
            s102 = z568 * z589 - z206 * z716 - k28 * z717 + k25 * z718
            z745 = s102 - k22 * z719 + z157 * z720
            s103 = z745 - z113 * z722 + s_lam * z727 - c_lam * z737 - k9 * z741
            z746 = s103 - R3 * z743
            z747 = c_pitch * z744 + s_pitch * z746
            z748 = z586 * z590
            z749 = z175 * z720 + z126 * z748
            z750 = z176 * z720 + z127 * z748
            z751 = z178 * z720 + z129 * z748
            z752 = z587 * z590 + z586 * z591
            s104 = z565 * z590 - z155 * z748 - k29 * z749 + k28 * z750
            z753 = s104 + k23 * z751 + z111 * z752
            z754 = z177 * z720 - z128 * z748
            z755 = z194 * z720 - z145 * z748
            z756 = z192 * z720 + z143 * z748
            s105 = z551 * z590 - z146 * z748 + k51 * z754 - k44 * z755
            z757 = s105 - k36 * z756 - z102 * z752
            s106 = z531 * z608 + z555 * z590 - z212 * z728
            z758 = s106 + 2.0 * (z147 * (F_yy * z748)) + z150 * z748
            z759 = z196 * z720 - z147 * z748
            z760 = z198 * z720 - z149 * z748
            z761 = z197 * z720 - z148 * z748
            z762 = F_yy * z752
            s107 = z758 - k47 * z759 + k36 * z760 - k33 * z761 + z103 * z762
            z763 = s107 + z106 * z752
            s108 = z556 * z590 - z151 * z748 + k50 * z754 - k43 * z755
            z764 = s108 + k33 * z756 - z107 * z752
            z765 = s_steer * z763 - c_steer * z764
            s109 = z561 * z590 + z153 * z748 - k36 * z754 - k33 * z755
            z766 = s109 + k31 * z756 + z109 * z752
            s110 = z562 * z590 + z154 * z748 - k33 * z759 - k31 * z761
            z767 = s110 + z110 * z752
            z768 = c_steer * z766 - s_steer * z767
            s111 = z573 * z590 - z160 * z748 - k23 * z749 - k22 * z750
            z769 = s111 + k21 * z751 + z116 * z752
            z770 = z769 + z768
            z771 = z753 - c_lam * z757 - s_lam * z765 + k10 * z768 + z20 * z770
            s112 = z568 * z590 + z157 * z748 + k28 * z749 - k25 * z750
            z772 = s112 + k22 * z751 - z113 * z752
            z773 = z772 + s_lam * z757 - c_lam * z765 - k9 * z768 - R3 * z770
            z774 = c_pitch * z771 + s_pitch * z773
            z775 = z587 * z591
            z776 = z175 * z722 + z126 * z752 - z82 * z775
            z777 = z176 * z722 + z127 * z752 + z83 * z775
            z778 = z178 * z722 + z129 * z752 + z85 * z775
            z779 = z177 * z722 - z128 * z752 - z84 * z775
            z780 = z194 * z722 - z145 * z752 - z101 * z775
            z781 = z192 * z722 + z143 * z752 + z99 * z775
            s113 = z551 * z591 - z102 * z775 + k51 * z779 - k44 * z780
            z782 = s113 - k36 * z781
            s114 = z565 * z591 + z111 * z775 - k29 * z776 + k28 * z777
            z783 = s114 + k23 * z778 - c_lam * z782
            s115 = z531 * z609 + z555 * z591 - z212 * z729 + z147 * z762
            z784 = s115 + 2.0 * (z103 * (F_yy * z775))
            z785 = z196 * z722 - z147 * z752 - z103 * z775
            z786 = z198 * z722 - z149 * z752 - z105 * z775
            z787 = z197 * z722 - z148 * z752 - z104 * z775
            z788 = z784 + z106 * z775 - k47 * z785 + k36 * z786 - k33 * z787
            s116 = z556 * z591 - z107 * z775 + k50 * z779 - k43 * z780
            z789 = s116 + k33 * z781
            z790 = s_steer * z788 - c_steer * z789
            s117 = z561 * z591 + z109 * z775 - k36 * z779 - k33 * z780
            z791 = s117 + k31 * z781
            z792 = z562 * z591 + z110 * z775 - k33 * z785 - k31 * z787
            z793 = c_steer * z791 - s_steer * z792
            s118 = z573 * z591 + z116 * z775 - k23 * z776 - k22 * z777
            z794 = s118 + k21 * z778 + z793
            z795 = z783 - s_lam * z790 + k10 * z793 + z20 * z794
            s119 = z568 * z591 - z113 * z775 + k28 * z776 - k25 * z777
            z796 = s119 + k22 * z778 + s_lam * z782
            z797 = z796 - c_lam * z790 - k9 * z793 - R3 * z794
            z798 = c_pitch * z795 + s_pitch * z797
            z799 = w1_pitch * z622 + w3_pitch * z623
            z800 = z671 - z252 * z617
            z801 = z252 * z616 + z680
            s120 = R_yy * z799 + z477 * z616 - z475 * z617 + z20 * z800
            z802 = s120 - R3 * z801
            z803 = z500 * z643 + z484 * z641 + z512 * z636 + z802
            z804 = z64 * z803
            z805 = z15 * z641
            z806 = z40 * z641
            z807 = c_lam * z805 - s_lam * z806 - k3 * z641
            z808 = s_lam * z805 + c_lam * z806 - k12 * z641
            s121 = z40 * z643 + z15 * z636 + k3 * (s_lam * z643 - c_lam * z636)
            z809 = s121 - k12 * z672
            z810 = c_steer * z808 - s_steer * z809
            z811 = z630 - c_lam * z807 - s_lam * z810 + z20 * z673 + k10 * z673
            s122 = z261 * z632 - z18 * z659 + z52 * z646 - z57 * z653
            z812 = s122 + roll_dot * z811 - c_roll * z690
            z813 = z632 - s_lam * z807 + c_lam * z810 + R3 * z673 + k9 * z673
            s123 = z261 * z630 - z22 * z659 + z53 * z646 - z58 * z653
            z814 = s123 - roll_dot * z813 + c_roll * z689
            s124 = z570 * z593 + z572 * z594 + z564 * z622 + z566 * z623
            z815 = s124 - k27 * z799 + k23 * (w1_pitch * z624 + z252 * z594)
            s125 = z815 + k22 * (z252 * z593 + w3_pitch * z624) + z536 * z605
            z816 = s125 + z537 * z606 - a1 * z616
            s126 = z816 - a3 * z617 - z444 * z610 - z452 * z612
            z817 = s126 - k10 * (w1_pitch * z625 - z252 * z606)
            s127 = z817 + k9 * (z252 * z605 + w3_pitch * z625) + c_steer * z701
            z818 = s127 + s_steer * z706 - z802
            s128 = z505 * z643 + z491 * z641 + z517 * z636 + c_pitch * z812
            z819 = s128 + s_pitch * z814 - z818
            z820 = z64 * z819
            z821 = R_yy * z720
            z822 = R_yy * z722
            z823 = z185 * z716
            z824 = z189 * z716
            s129 = z571 * z589 - z207 * z716 + k23 * z823 - k21 * z824
            z825 = s129 - z158 * z720 - z114 * z722
            s130 = z559 * z589 + z201 * z716 - k36 * z730 + k31 * z731
            z826 = s130 + z152 * z720 + z108 * z722
            z827 = s_steer * z739 + c_steer * z740
            z828 = c_lam * z826 - s_lam * z827
            z829 = z825 - z828
            s131 = z533 * z613 + 2.0 * (z186 * (R_yy * z716)) + z137 * z821
            z830 = s131 + z93 * z822 - z20 * z829
            z831 = z187 * z716
            s132 = z574 * z589 + z208 * z716 + k22 * z823 + k21 * z831
            z832 = s132 + z159 * z720 + z115 * z722
            z833 = s_lam * z826 + c_lam * z827
            z834 = z832 + z833
            z835 = z830 + R3 * z834
            z836 = z64 * z835
            s133 = z567 * z589 + z205 * z716 + k27 * z823 - k23 * z824
            z837 = s133 + k22 * z831 + z156 * z720
            s134 = z837 + z112 * z722 + c_steer * z734 + s_steer * z736
            z838 = s134 - k10 * z828 - k9 * z833 - z835
            z839 = z64 * z838
            s135 = z522 * z620 + z508 * z621 - z241 * z804 + z246 * z820
            z840 = s135 + z171 * z836 + z170 * z839
            z841 = R_yy * z752
            z842 = z185 * z720 - z136 * z748
            z843 = z189 * z720 - z140 * z748
            s136 = z559 * z590 + z152 * z748 + k36 * z759 - k31 * z760
            z844 = s136 + z108 * z752
            z845 = s_steer * z766 + c_steer * z767
            z846 = c_lam * z844 - s_lam * z845
            s137 = z571 * z590 - z158 * z748 - k23 * z842 + k21 * z843
            z847 = s137 - z114 * z752 - z846
            s138 = z533 * z614 - z186 * z821 + 2.0 * (z137 * (R_yy * z748))
            z848 = s138 + z93 * z841 - z20 * z847
            z849 = z187 * z720 - z138 * z748
            z850 = s_lam * z844 + c_lam * z845
            s139 = z574 * z590 + z159 * z748 - k22 * z842 - k21 * z849
            z851 = s139 + z115 * z752 + z850
            z852 = z848 + R3 * z851
            z853 = z64 * z852
            s140 = z567 * z590 + z156 * z748 - k27 * z842 + k23 * z843
            z854 = s140 - k22 * z849 + z112 * z752
            s141 = z854 + c_steer * z763 + s_steer * z764 - k10 * z846
            z855 = s141 - k9 * z850 - z852
            z856 = z64 * z855
            z857 = z185 * z722 - z136 * z752 - z92 * z775
            z858 = z189 * z722 - z140 * z752 - z96 * z775
            z859 = z559 * z591 + z108 * z775 + k36 * z785 - k31 * z786
            z860 = s_steer * z791 + c_steer * z792
            z861 = c_lam * z859 - s_lam * z860
            z862 = z571 * z591 - z114 * z775 - k23 * z857 + k21 * z858 - z861
            s142 = z533 * z615 - z186 * z822 + z137 * z841
            z863 = s142 + 2.0 * (z93 * (R_yy * z775)) - z20 * z862
            z864 = z187 * z722 - z138 * z752 - z94 * z775
            z865 = s_lam * z859 + c_lam * z860
            z866 = z574 * z591 + z115 * z775 - k22 * z857 - k21 * z864 + z865
            z867 = z863 + R3 * z866
            z868 = z64 * z867
            s143 = z567 * z591 + z112 * z775 - k27 * z857 + k23 * z858
            z869 = s143 - k22 * z864 + c_steer * z788
            z870 = z869 + s_steer * z789 - k10 * z861 - k9 * z865 - z867
            z871 = z64 * z870
            s144 = z445 * z633 + z451 * z619 + z506 * z643 - z492 * z641
            z872 = s144 + z518 * z636 - c_roll * z715
            z873 = z872 + e2z * z818
            s145 = z532 * z618 + z521 * z619 - z523 * z634 - z244 * z803
            z874 = s145 + z247 * z819 - z249 * z873
            z875 = c_roll * z747 - e2z * z838
            z876 = c_roll * z774 - e2z * z855
            s146 = z874 + z181 * z835 + z183 * z838 + z172 * z875 - z132 * z852
            z877 = s146 - z134 * z855 + z123 * z876
            z878 = c_roll * z798 - e2z * z870
            z879 = z271 * (z877 - z88 * z867 - z90 * z870 + z79 * z878)
            s147 = z840 - z122 * z853 - z121 * z856 - z78 * z868 - z77 * z871
            z880 = s147 - z47 * z879
            z881 = z29 * z804 - z27 * z820
            z882 = z29 * z836 + z27 * z839
            z883 = z29 * z868 + z27 * z871
            s148 = z519 * z620 - z243 * z804 - z15 * z836 - z70 * z868
            z884 = s148 - z27 * z879
            s149 = z519 * z621 + z243 * z820 - z15 * z839 - z70 * z871
            z885 = s149 + z29 * z879
            s150 = z507 * z638 - z240 * z881 - z40 * z882 - z76 * z883
            z886 = s150 + z46 * z884 + z34 * z885
            s151 = z691 - z250 * z715 - z173 * z747 - z124 * z774 - z80 * z798
            z887 = s151 - z23 * z880 - z54 * z886
            z888 = z29 * z853 + z27 * z856
            s152 = z493 * z638 - z235 * z881 - z120 * z888 - z75 * z883
            z889 = s152 + z43 * z884 + z38 * z885
            s153 = z528 * z629 - z533 * z617 + z462 * z673 + w1_pitch * z710
            z890 = s153 - z253 * z801 - z511 * z674
            z891 = z64 * z873
            z892 = z30 * z804 - z27 * z891
            z893 = z30 * z820 - z29 * z891
            z894 = z60 * z881 + z46 * z892 - z34 * z893
            z895 = z55 * z881 - z43 * z892 + z38 * z893
            z896 = z62 * z804 - z61 * z820 + z47 * z891
            z897 = c_lam * z895 + s_lam * z896
            z898 = z444 * z641 + z452 * z672 - c_steer * z894 + s_steer * z897
            s154 = z890 - z499 * z675 + z480 * z677 - z224 * z898 + z176 * z743
            z899 = s154 - z186 * z834 + z127 * z770
            z900 = z64 * z878
            z901 = z30 * z868 + z27 * z900
            z902 = z30 * z871 - z29 * z900
            z903 = z60 * z883 + z46 * z901 + z34 * z902
            z904 = z55 * z883 - z43 * z901 - z38 * z902
            z905 = z62 * z868 + z61 * z871 - z47 * z900
            z906 = c_lam * z904 + s_lam * z905
            z907 = c_steer * z903 - s_steer * z906
            z908 = z64 * z875
            s155 = z520 * z621 + z522 * z635 + z242 * z820 + z241 * z891
            z909 = s155 - z180 * z839 + z171 * z908
            z910 = z64 * z876
            s156 = z520 * z620 - z508 * z635 - z451 * z637 - z242 * z804
            z911 = s156 - z246 * z891 - z180 * z836
            s157 = z911 - z170 * z908 - z131 * z853 + z121 * z910 - z87 * z868
            z912 = s157 + z77 * z900 + z61 * z879
            z913 = z912 - e2z * z880
            s158 = z909 - z131 * z856 - z122 * z910 - z87 * z871 - z78 * z900
            z914 = s158 - z62 * z879 + z913
            z915 = z30 * z856 - z29 * z910
            s159 = z519 * z635 + z243 * z891 - z15 * z908 - z70 * z900
            z916 = s159 + z30 * z879
            s160 = z493 * z640 + z235 * z893 - z120 * z915 - z75 * z902
            z917 = s160 + z55 * z885 - z43 * z916
            z918 = z30 * z853 + z27 * z910
            s161 = z493 * z639 + z451 * z644 - z235 * z892 - z120 * z918
            z919 = s161 - z75 * z901 + z55 * z884
            z920 = z919 + z38 * z916 + e2z * z889
            z921 = z917 + z920
            s162 = z899 + z137 * z851 + z83 * z794 + z93 * z866
            z922 = s162 + c_pitch * z907 - z26 * z914 - z33 * z921
            z923 = z445 * z637 - c_roll * z880
            z924 = z446 * z659 + s_pitch * z923
            z925 = z445 * z642 + c_roll * z886
            z926 = z446 * z646 + s_pitch * z925
            z927 = z445 * z644 - c_roll * z889
            z928 = z446 * z653 + s_pitch * z927
            s163 = z482 * z660 + z444 * z647 + z480 * z654 - z1 * z924
            z929 = s163 + c_steer * z926 - z35 * z928
            z930 = z30 * z839 - z29 * z908
            s164 = z507 * z640 + z240 * z893 - z40 * z930 - z76 * z902
            z931 = s164 - z60 * z885 - z46 * z916
            z932 = z30 * z836 + z27 * z908
            s165 = z507 * z639 - z451 * z642 - z240 * z892 - z40 * z932
            z933 = s165 - z76 * z901 - z60 * z884
            z934 = z933 + z34 * z916 + e2z * z886
            z935 = z931 + z934
            z936 = z922 - z929 + z35 * z935
            s166 = z529 * z629 - z533 * z616 + z463 * z673 - w3_pitch * z710
            z937 = s166 - z253 * z800 - z510 * z674
            s167 = z937 + z482 * z677 - z498 * z675 + z225 * z898 + z175 * z743
            z938 = s167 - z186 * z829 + z126 * z770
            s168 = z938 + z137 * z847 - z82 * z794 + z93 * z862
            z939 = s168 - s_pitch * z907 + z25 * z914 + z1 * z935
            z940 = z448 * z659 - c_pitch * z923
            z941 = z448 * z646 - c_pitch * z925
            z942 = z448 * z653 - c_pitch * z927
            s169 = z482 * z661 + z444 * z648 + z480 * z655 + z1 * z940
            z943 = s169 - c_steer * z941 + z35 * z942
            z944 = z939 + z32 * z921 - z943
            s170 = z471 * z679 + z476 * z683 - z472 * z685 - z2 * z936
            z945 = z5 * (z267 * (s170 + z19 * z944))
            z946 = z473 * z684 * z576 - 0.5 * z945
            s171 = z449 * z686 - k56 * z592 + k55 * z593 - 2.0 * (e3z * z946)
            z947 = s171 + r_R * (z474 * z679 + z5 * z936)
            z948 = k64 * z595 - k63 * z596 + k60 * z597
            s172 = z494 * z643 + z467 * z641 + z237 * z895 + z230 * z894
            z949 = s172 + z55 * z882 - z43 * z932
            z950 = c_lam * z926 - s_lam * z941
            z951 = z452 * z645 + z444 * z649 - s_steer * z934 + c_steer * z950
            s173 = z60 * z888 + z46 * z918 + z34 * z915
            z952 = s173 - (c_lam * z941 + s_lam * z926)
            z953 = c_lam * z928 - s_lam * z942
            s174 = z949 - z38 * z930 + z66 * z904 + z73 * z903 - c_lam * z951
            s175 = z444 * z652 - z452 * z656 - c_steer * z920 + s_steer * z953
            z954 = s174 + s_lam * z952 + s175
            s176 = z470 * z641 + z494 * z636 - z231 * z894 + z237 * z896
            z955 = s176 + z62 * z836 + z61 * z839
            z956 = c_lam * z924 - s_lam * z940
            s177 = z444 * z658 - z452 * z662 + c_steer * z913 + s_steer * z956
            z957 = z955 - z47 * z908 - z74 * z903 + z66 * z905 + s177
            z958 = z957 - c_lam * z952 - s_lam * z951
            s178 = z456 * z657 - z468 * z663 - z458 * z665 - z39 * z954
            z959 = z14 * (z276 * (s178 - z11 * z958))
            z960 = z459 * z664 * z575 - 0.5 * z959
            s179 = z455 * z666 - 2.0 * (z12 * z960)
            z961 = s179 + r_F * (z460 * z657 + z14 * z954)
            s180 = z457 * z666 - 2.0 * (z10 * z960)
            z962 = s180 - r_F * (z460 * z663 - z14 * z958)
            s181 = k62 * z599 + k60 * z600 + k59 * z599 + s_lam * z961
            z963 = s181 - c_lam * z962
            z964 = z444 * z669 - s_steer * z948 + c_steer * z963
            s182 = k61 * z599 - k60 * z603 - k58 * z599 + c_lam * z961
            z965 = s182 + s_lam * z962
            z966 = z947 - s_lam * z964 - c_lam * z965
            s183 = z447 * z686 - k57 * z592 - k55 * z594 - 2.0 * (z3 * z946)
            z967 = s183 + r_R * (z474 * z683 - z5 * z944)
            z968 = z967 - c_lam * z964 + s_lam * z965
            s184 = z250 * z633 + z23 * z637 - z54 * z642 + z59 * z644
            z969 = s184 + c_pitch * z689 + s_pitch * z690
            s185 = z524 * z619 + z517 * z637 + z491 * z642 + z505 * z644
            z970 = s185 - z250 * z818 + k56 * z622
            s186 = z970 + k57 * z623 - k55 * z624 - z173 * z838 - z124 * z855
            z971 = s186 - z80 * z870 - z29 * z880
            s187 = z452 * z669 + (z971 - z43 * z886 + z46 * z889)
            z972 = c_steer * z948 + (roll_dot * z969 - s187) + s_steer * z963
            s188 = roll_dot * z670 + (z887 - z59 * z889) + c_pitch * z966
            z973 = e2z * (s188 + s_pitch * z968) - c_roll * z972
            J[offset1 + 4] = -z973
            z974 = z469 * z641 - z15 * z894
            z975 = z461 * z641 - z40 * z894
            z976 = c_lam * z974 - s_lam * z975 + k3 * z894
            z977 = s_lam * z974 + c_lam * z975 + k12 * z894
            z978 = z461 * z643 + z469 * z636 - z40 * z895 - z15 * z896
            z979 = z978 - k3 * (s_lam * z895 - c_lam * z896) + k12 * z897
            z980 = z444 * z808 + z452 * z809 + c_steer * z977 - s_steer * z979
            s189 = z477 * z673 - z711 - c_lam * z976 - s_lam * z980
            z981 = s189 + z20 * z898 + k10 * z898
            s190 = z527 * z632 + z514 * z659 + z488 * z646 + z502 * z653
            z982 = s190 + z248 * z814 - z261 * z714
            z983 = z15 * z903
            z984 = z40 * z903
            z985 = c_lam * z983 - s_lam * z984 - k3 * z903
            z986 = s_lam * z983 + c_lam * z984 - k12 * z903
            s191 = z40 * z904 + z15 * z905 + k3 * (s_lam * z904 - c_lam * z905)
            z987 = s191 - k12 * z906
            z988 = c_steer * z986 - s_steer * z987
            s192 = z982 + z174 * z746 + z125 * z773 - z795 + z81 * z797
            z989 = s192 + c_lam * z985 + s_lam * z988
            s193 = z989 - z20 * z907 - z18 * z923 + z52 * z925 - z57 * z927
            z990 = z445 * z690 - (s193 - k10 * z907)
            s194 = z475 * z673 - z714 - s_lam * z976 + c_lam * z980 + R3 * z898
            z991 = s194 + k9 * z898
            s195 = z527 * z630 + z515 * z659 + z489 * z646 + z503 * z653
            z992 = s195 - z248 * z812 - z261 * z711
            s196 = z992 - z174 * z744 - z125 * z771 - z81 * z795 - z797
            z993 = s196 - s_lam * z985 + c_lam * z988
            s197 = z993 + R3 * z907 - z22 * z923 + z53 * z925 - z58 * z927
            z994 = z445 * z689 + (s197 + k9 * z907)
            s198 = c_pitch * (roll_dot * z981 - z990 - c_roll * z968)
            z995 = s198 - s_pitch * (roll_dot * z991 - z994 - c_roll * z966)
            J[offset1 + 5] = -z995
            s199 = z526 * z612 + z252 * z610 + z233 * z641 - z228 * z808
            s200 = s_lam * (z20 * z674 - k10 * z658)
            s201 = s_lam * (c_lam * (R3 * z674 - k9 * z658) - s200)
            z996 = s199 - z16 * z658 + s201
            s202 = s_lam * (z20 * z675 - k10 * z652)
            s203 = z996 - z41 * z649 - z21 * z648 + z6 * z647 - z44 * z652
            z997 = s203 - c_lam * (s202 - c_lam * (R3 * z675 - k9 * z652))
            z998 = z997 + z7 * z669
            s204 = z544 * z598 - z538 * z601 - z530 * z610 - z525 * z612
            z999 = s204 - z526 * z701 + z478 * z672
            s205 = z999 + z465 * z809 - z469 * z662 - z485 * z645 - z461 * z656
            z1000 = s205 - z252 * z706 - z193 * z734
            s206 = z1000 + z185 * z736 + z191 * z739 + z179 * z740
            z1001 = s206 - z144 * z763 - z136 * z764 - z142 * z766
            s207 = z1001 + z130 * z767 - z100 * z788 - z92 * z789 - z98 * z791
            z1002 = z233 * z897 + (s207 + z86 * z792)
            s208 = z228 * z979 + z1002 + z67 * z906 - z65 * z987 - z16 * z956
            z1003 = s208 + z41 * z934 - z44 * z953
            s209 = z477 * z655 + z475 * z678 - z21 * z942 - z6 * z928
            z1004 = s209 - R3 * z935 - k9 * z934
            s210 = z475 * z660 - z477 * z681 + z21 * z940 + z6 * z924
            z1005 = s210 - z20 * z935 - k10 * z934
            s211 = z451 * z669 + (z1003 + c_lam * z1004 - s_lam * z1005)
            z1006 = z7 * z948 - (steer_dot * z998 + s211) + e2z * z963
            s212 = z526 * z610 - z252 * z612 - z233 * z672 + z228 * z809
            z1007 = s212 - z16 * z662 + z41 * z645
            s213 = c_lam * (z21 * z655 - z6 * z654 + R3 * z677 - k9 * z645)
            z1008 = z1007 - z44 * z656 + s213
            s214 = s_lam * (z21 * z661 - z6 * z660 - z20 * z677 + k10 * z645)
            z1009 = z1008 + s214 - e2z * z669
            s215 = z538 * z598 + z544 * z601 - z530 * z612 + z525 * z610
            z1010 = s215 + z526 * z706 - z478 * z641
            s216 = z1010 - z465 * z808 - z469 * z658 + z485 * z649
            z1011 = s216 - z477 * z648 + z475 * z647 - z461 * z652
            s217 = z1011 + z453 * z669 - z252 * z701 + z185 * z734
            z1012 = s217 + z193 * z736 - z179 * z739 + z191 * z740
            s218 = z1012 - z136 * z763 + z144 * z764 - z130 * z766
            z1013 = s218 - z142 * z767 - z92 * z788 + z100 * z789
            s219 = z233 * z894 - (z1013 - z86 * z791 - z98 * z792)
            z1014 = z228 * z977 + s219 + z67 * z903 - z65 * z986
            s220 = s_lam * (z477 * z674 - z20 * z914 - k10 * z913)
            z1015 = c_lam * (z475 * z674 - R3 * z914 - k9 * z913) - s220
            s221 = z1014 + z16 * z913 - s_lam * z1015 + z41 * z950 - z21 * z941
            z1016 = s221 - z6 * z926 - z44 * z920
            s222 = s_lam * (z477 * z675 + z20 * z921 + k10 * z920)
            z1017 = s222 - c_lam * (z475 * z675 + R3 * z921 + k9 * z920)
            s223 = e2z * z948 + (steer_dot * z1009 + (z1016 + c_lam * z1017))
            z1018 = c_steer * z1006 - s_steer * (s223 - z7 * z963)
            J[offset1 + 6] = z1018
            s224 = z446 * z811 - z448 * z813 - e2z * z969 - c_roll * z670
            z1019 = s224 + s_pitch * z981 + c_pitch * z991
            J[offset1 + 9] = -z1019
            J[offset1 + 10] = z709 + z976 + c_steer * z1009 - s_steer * z998
            J[offset1 + 11] = -(z700 + z978)
        _finish("jacobian", J)
        return [J[k66 : k66 + 12] for k66 in range(0, 144, 12)]
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
        k4 = s_lam * k3
        k5 = c_lam * k3
        k6 = c_lam * c_lam
        k7 = w * s_lam + c_lam * (r_R - r_F)
        k8 = s_lam * s_lam
        k9 = s_lam * k2 - c_lam * k7
        k10 = c_lam * k2 + s_lam * k7
        k11 = abs(r_R)
        k12 = abs(r_F)
        k13 = abs(w)
        k14 = abs(c)
        k15 = 18.0 * k14 + (18.0 * k13 + (34.0 * k11 + 19.0 * k12))
        # state
        c_roll = math.cos(roll)
        s_pitch = math.sin(pitch)
        s_steer = math.sin(steer)
        z1 = s_lam * s_steer
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = r_R * e3z
        z3 = s_pitch * c_roll
        z4 = 1.0 / math.sqrt(z3 * z3 + e3z * e3z)
        R3 = z2 * z4
        z5 = R3 + k4
        c_steer = math.cos(steer)
        e2z = math.sin(roll)
        z6 = c_steer * (z3 * c_lam + e3z * s_lam) - e2z * s_steer
        z7 = z3 * s_lam - e3z * c_lam
        z8 = c_lam * z6 + s_lam * z7
        z9 = c_lam * z7 - s_lam * z6
        z10 = 1.0 / math.sqrt(z8 * z8 + z9 * z9)
        z11 = r_F * z8 * z10
        z12 = z11 - k10
        z13 = s_steer * z12
        z14 = r_R * z3 * z4
        z15 = z14 + k5
        z16 = s_lam * c_steer
        z17 = k6 + s_lam * z16
        z18 = c_lam * (s_lam - z16)
        z19 = z14 * z17 + R3 * z18
        z20 = k5 * z17 + k4 * z18 + z19 - c_steer * z12
        s1 = c_pitch * (z1 * z15 - s_lam * z13)
        s2 = c_roll * (s_pitch * (z1 * z5 + c_lam * z13) - s1)
        z21 = s2 - e2z * z20
        z22 = c_lam * c_steer
        z23 = s_lam * (c_lam - z22)
        z24 = c_lam * z22 + k8
        z25 = z14 * z23 + R3 * z24
        z26 = c_lam * s_steer
        z27 = R3 * z26 - z14 * z1
        z28 = r_F * z9
        z29 = z28 * z10
        z30 = k7 - c_lam * z29 - s_lam * z11
        z31 = z26 * k4 - z1 * k5 + z27 - s_steer * z30
        z32 = z29 + k9
        z33 = k5 * z23 + k4 * z24 + z25 + c_steer * z32
        z34 = c_steer * z30
        z35 = k2 + s_lam * z29 - c_lam * z11
        s3 = c_pitch * (c_steer * z15 + s_lam * z34 + c_lam * z35)
        z36 = s_pitch * (c_steer * z5 - c_lam * z34 + s_lam * z35) - s3
        z37 = c_roll * z36 - e2z * z31
        z38 = s_steer * z32
        s4 = c_pitch * (z26 * z15 - s_lam * z38)
        s5 = c_roll * (s_pitch * (z26 * z5 + c_lam * z38) - s4)
        z39 = s5 + e2z * z33
        z40 = z33 * z37 + z39 * z31
        s6 = z21 * (z25 * z31 - z33 * z27)
        z41 = s6 - z20 * (z25 * z37 + z39 * z27) + z19 * z40
        s7 = 24.0 * k11
        s8 = s7 + 33.0 * k12
        s9 = 14.0 * k13 + s8
        s10 = k15 * (13.0 * k14 + s9)
        # the coframe is singular
        if not abs(z41) > 1e-12 * (k15 * s10):
            raise SingularModelError(1, "outputs")
        z42 = roll_dot * c_pitch
        z43 = roll_dot * s_pitch
        z44 = steer_dot + (s_lam * z42 + c_lam * z43)
        z45 = s_lam * z43 - c_lam * z42
        z46 = c_steer * z45
        z47 = z42 * k4 + z43 * k5 + (z42 * R3 + z43 * z14)
        s11 = z29 * (s_lam * z44 - c_lam * z46)
        s12 = s11 - z11 * (s_lam * z46 + c_lam * z44)
        z48 = s12 + (k7 * z46 + k2 * z44 + c_steer * z47)
        z49 = s_steer * z45
        z50 = thF_dot + z49
        z51 = k2 * z49
        z52 = k7 * z49 + s_steer * z47
        z53 = z29 * z50 + (s_lam * z51 - c_lam * z52)
        s13 = z21 * (z33 * z48 - z31 * z53)
        s14 = z40 * (z11 * z50 - (s_lam * z52 + c_lam * z51))
        z54 = s13 + z20 * (z37 * z53 + z39 * z48) + s14
        out: list[float] = [
            # speed 123:10
            -r_R * (z54 / z41),
            # rear_height 124:16
            z + z3 * z14 + e3z * R3,
            # front_height 125:17
            z - z3 * k1 + z2 + c * z8 + z28 + z8 * z11 + z9 * z29,
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
