"""bicycle, emitted by nhc 0.1.0 (nhc:753704244b7e376f).

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
rhs: 650 +-, 985 *, 8 /, 16 calls
velocities: 101 +-, 177 *, 3 /, 16 calls
accelerations: 267 +-, 426 *, 6 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 185 *, 2 /, 12 calls
reactions: 1021 +-, 1367 *, 5 /, 12 calls
energy: 214 +-, 349 *, 3 /, 12 calls
jacobian: 4283 +-, 5921 *, 11 /, 16 calls
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
        k13 = s_lam * k3 - c_lam * k12
        k14 = s_lam * s_lam
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
        z32 = c_lam * z30 + k14
        z33 = z20 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z20 * z1
        z36 = r_F * z12
        z37 = z36 * z14
        z38 = k12 - c_lam * z37 - s_lam * z15
        z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38
        z40 = z37 + k13
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
        z225 = R_yy * z220
        h2z = e2z * c_steer + s_steer * z7
        z226 = c_lam * w1_pitch - s_lam * w3_pitch
        z227 = s_steer * z219 - c_steer * z226
        z228 = c_steer * z219 + s_steer * z226
        z229 = F_yy * (thF_dot - z228) - k47 * z228
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z230 = k43 * z227 - k44 * w3_steer
        z231 = c_pitch * z217
        z232 = roll_dot * z231
        z233 = s_pitch * z217
        z234 = roll_dot * e2z
        z235 = steer_dot * c_steer
        z236 = roll_dot * z233
        z237 = s_lam * z232 + c_lam * z236
        z238 = z235 * z201 - s_steer * z237
        z239 = roll_dot * c_roll
        z240 = steer_dot * s_steer
        z241 = s_pitch * z234 + c_roll * z231
        z242 = c_pitch * z234 - c_roll * z233
        s24 = z7 * z240 + c_steer * (c_lam * z241 + s_lam * z242)
        z243 = s_steer * z239 + e2z * z235 + s24
        z244 = s_lam * z241 - c_lam * z242
        z245 = c_lam * z243 + s_lam * z244
        z246 = r_F * z14
        z247 = c_lam * z244 - s_lam * z243
        z248 = (z10 * z245 + z12 * z247) * (z14 / z13)
        z249 = z245 * z246 - z11 * z248
        z250 = k3 * z238
        z251 = r_R * z5
        z252 = (z3 * z241 + e3z * z242) * (z5 / z4)
        z253 = z251 * z242 - z2 * z252
        z254 = z251 * z241 - z19 * z252
        s25 = R3 * z236 - z198 * z253 - (z20 * z232 + z199 * z254)
        z255 = k9 * z236 - k10 * z232 + s25
        z256 = k12 * z238 + (z235 * z205 + s_steer * z255)
        z257 = s_lam * z240
        z258 = s_lam * z257
        z259 = c_lam * z257
        z260 = z20 * z258 + z25 * z254 - (R3 * z259 - z26 * z253)
        z261 = s_lam * z235
        z262 = z235 * z16 - s_steer * z249
        z263 = z1 * z254
        s26 = s_pitch * (z6 * z261 - z1 * z253 + c_lam * z262)
        s27 = z22 * z233 + c_pitch * (z21 * z261 - z263 - s_lam * z262)
        z264 = z18 * z231 - s26 + s27
        z265 = k10 * z258 - k9 * z259 + z260 - (z240 * z16 + c_steer * z249)
        s28 = z234 * z23 + c_roll * z264 + (z239 * z28 - e2z * z265)
        z266 = z215 * z260 + (z218 * s28 - z217 * z265)
        s29 = z15 * z238 - z208 * z249 - (c_lam * z250 + s_lam * z256)
        z267 = s29 + z266
        z268 = s_lam * z236 - c_lam * z232
        z269 = z240 * z201 + c_steer * z237
        z270 = z247 * z246 - z36 * z248
        s30 = z37 * (s_lam * z268 + c_lam * z269) - z203 * z270
        z271 = s30 + (z15 * (s_lam * z269 - c_lam * z268) + z204 * z249)
        z272 = c_lam * z235
        z273 = z34 * z253
        z274 = R3 * z272 - z273 - (z20 * z261 - z263)
        z275 = c_lam * z270 + s_lam * z249
        z276 = z240 * z38 - c_steer * z275
        z277 = s_lam * z270 - c_lam * z249
        s31 = z240 * z6 + c_steer * z253 - c_lam * z276 + s_lam * z277
        s32 = z240 * z21 + c_steer * z254 + s_lam * z276 + c_lam * z277
        z278 = z47 * z231 + s_pitch * s31 + (z48 * z233 - c_pitch * s32)
        z279 = k9 * z272 - k10 * z261 + z274 - (z235 * z38 + s_steer * z275)
        s33 = z234 * z49 + c_roll * z278 + (z239 * z39 + e2z * z279)
        z280 = z215 * z274 - (z218 * s33 + z217 * z279)
        s34 = k12 * z269 - k3 * z268 + (z240 * z205 - c_steer * z255)
        z281 = z271 - s34 + z280
        z282 = c_lam * z240
        z283 = s_lam * z282
        z284 = c_lam * z282
        z285 = z20 * z283 - z31 * z254 - (R3 * z284 + z32 * z253)
        z286 = z235 * z40 - s_steer * z270
        s35 = c_pitch * (z21 * z272 - z34 * z254 - s_lam * z286)
        s36 = z52 * z231 - s_pitch * (z6 * z272 - z273 + c_lam * z286)
        z287 = s36 + (z53 * z233 + s35)
        z288 = k10 * z283 - k9 * z284 + z285 - (z240 * z40 + c_steer * z270)
        s37 = z234 * z54 + c_roll * z287 - (z239 * z41 + e2z * z288)
        z289 = z215 * z285 + (z218 * s37 - z217 * z288)
        s38 = z37 * z238 - z208 * z270 + (s_lam * z250 - c_lam * z256)
        z290 = s38 + z289
        z291 = z33 * z281 - z35 * z290
        z292 = z41 * z281 - z39 * z290
        z293 = z59 * (z42 * z267 + z28 * z291 - z27 * z292)
        z294 = z234 * z218 - c_roll * z293
        z295 = z232 + (z223 * z233 - c_pitch * z294)
        z296 = z236 - (z223 * z231 + s_pitch * z294)
        z297 = c_lam * z295 - s_lam * z296
        s39 = w1_pitch * z253 - R3 * z296 + (w3_pitch * z254 + z20 * z295)
        z298 = a1 * w3_pitch - a3 * w1_pitch + s39
        z299 = k9 * z219
        z300 = k10 * z219
        s40 = w3_pitch * z299 - w1_pitch * z300 - (k10 * z295 - k9 * z296)
        z301 = z298 - s40
        z302 = z50 * z290 + z55 * z281
        s41 = z59 * (z29 * z291 + z56 * z267 + z27 * z302)
        z303 = s41 + (z239 * z218 + e2z * z293)
        z304 = z59 * (z29 * z292 + z28 * z302 + z57 * z267) - z303
        z305 = z219 * a3 - w3_pitch * v2_x + (z220 * z253 - R3 * z304)
        z306 = k10 * w3_pitch + k9 * w1_pitch
        z307 = z305 - (z219 * z300 + w3_pitch * z306 - k9 * z303)
        z308 = w1_pitch * v2_x - z219 * a1 + (z220 * z254 - z20 * z304)
        z309 = z308 + (w1_pitch * z306 + z219 * z299 + k10 * z303)
        z310 = c_lam * z307 - s_lam * z309
        z311 = c_steer * z301 + s_steer * z310
        z312 = c_lam * z296 + s_lam * z295
        z313 = z235 * z219 + s_steer * z303 + (z240 * z226 - c_steer * z312)
        s42 = k51 * z297 + (k36 * z311 + k50 * z313)
        z314 = h2z * k64 - (z227 * z229 + z228 * z230 + s42)
        z315 = k50 * z227 - k51 * w3_steer
        z316 = z240 * z219 - c_steer * z303 - (z235 * z226 + s_steer * z312)
        z317 = c_steer * z310 - s_steer * z301
        z318 = c_lam * z309 + s_lam * z307
        s43 = k47 * z316 + (k33 * z317 - k36 * z318)
        s44 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61)
        z319 = s44 - (w3_steer * z230 + z227 * z315 - s43)
        s45 = k44 * z297 - (k33 * z311 - k43 * z313)
        z320 = h2z * k63 + (z228 * z315 - w3_steer * z229 - s45)
        z321 = k33 * z227 + k36 * w3_steer
        z322 = k33 * z228
        s46 = z227 * z321 + z228 * z322 - (k31 * z318 - k36 * z316)
        z323 = z9 * k60 - s46
        z324 = k36 * z228
        s47 = k36 * z297 + (k31 * z311 - k33 * z313)
        z325 = h2z * k60 + (w3_steer * z322 - z227 * z324 + s47)
        s48 = z228 * z324 + w3_steer * z321 - (k31 * z317 + k33 * z316)
        z326 = z8 * k60 - s48
        z327 = k27 * z219
        z328 = k25 * w1_pitch + k28 * w3_pitch
        s49 = k29 * z295 + (k23 * z298 - k28 * z296)
        z329 = e2z * k56 + (w1_pitch * z327 - z219 * z328 + s49)
        z330 = k28 * w1_pitch + k29 * w3_pitch
        s50 = k27 * z303 - (k22 * z305 - k23 * z308)
        s51 = w3_pitch * z328 - w1_pitch * z330 - s50
        z331 = z3 * k57 + e3z * k56 + s51
        s52 = k28 * z295 - (k22 * z298 + k25 * z296)
        z332 = e2z * k57 - (z219 * z330 - w3_pitch * z327 + s52)
        z333 = k22 * w1_pitch - k23 * w3_pitch
        z334 = k22 * z219
        s53 = w1_pitch * z333 + z219 * z334 - (k21 * z308 + k23 * z303)
        z335 = e3z * k55 + s53
        z336 = k23 * z219
        s54 = z219 * z336 - w3_pitch * z333 - (k21 * z305 - k22 * z303)
        z337 = z3 * k55 - s54
        s55 = k23 * z295 + (k21 * z298 + k22 * z296)
        z338 = e2z * k55 + (w3_pitch * z334 + w1_pitch * z336 + s55)
        s56 = z75 * z332 + (z84 * z335 - (z82 * z337 + z77 * z338))
        z339 = z74 * z329 + (z80 * z331 - s56)
        s57 = z89 * z320 + (z93 * z323 + (z87 * z325 + (z92 * z326 + z339)))
        z340 = z76 * z314 - (z91 * z319 + s57)
        z341 = roll_dot * z225
        z342 = z223 * z225 + z340 + z149 * z304 - z150 * z316 - z73 * z341
        s58 = z114 * z332 + (z123 * z335 - (z121 * z337 + z116 * z338))
        z343 = z113 * z329 - (z119 * z331 - s58)
        s59 = z132 * z323 + (z126 * z325 + (z131 * z326 - z343))
        z344 = z115 * z314 - (z130 * z319 + (z128 * z320 + s59))
        z345 = z344 + z192 * z304 - z193 * z316 - z112 * z341 - z342 * z153
        s60 = z160 * z332 - (z169 * z335 - (z167 * z337 - z162 * z338))
        z346 = z159 * z329 + (z165 * z331 + s60)
        s61 = z177 * z323 - (z172 * z325 - (z176 * z326 + z346))
        z347 = z161 * z314 - (z175 * z319 + (z174 * z320 + s61))
        s62 = z347 + R_yy * (z166 * z304) - F_yy * (z184 * z316)
        z348 = s62 + z158 * z341 - z342 * z189 - z196 * z345
        z349 = z348 / z197
        z350 = z195 * z345 - z196 * z349
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
            z189 * z349 - (z152 * z342 - z153 * z350),
            # steer'' (I.2.15) 112:4
            -z350,
            # thF'' (I.2.15) 112:4
            z349,
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
        k7 = s_lam * k1 - c_lam * k6
        k8 = s_lam * s_lam
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
        z23 = c_lam * z21 + k8
        z24 = z22 * z13 + z23 * R3
        z25 = c_lam * s_steer
        z26 = z25 * R3 - z1 * z13
        z27 = z8 * z9
        z28 = k6 - c_lam * z27 - s_lam * z10
        z29 = z25 * k3 - z1 * k4 + z26 - s_steer * z28
        z30 = k7 + z27
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
        k7 = s_lam * k1 - c_lam * k6
        k8 = s_lam * s_lam
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
        z32 = c_lam * z30 + k8
        z33 = z5 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z5 * z6
        z36 = r_F * z14
        z37 = z36 * z16
        z38 = k6 - c_lam * z37 - s_lam * z17
        z39 = z34 * k3 - z6 * k4 + z35 - s_steer * z38
        z40 = z37 + k7
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
        k13 = s_lam * k3 - c_lam * k12
        k14 = s_lam * s_lam
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
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        s_steer = math.sin(steer)
        s_pitch = math.sin(pitch)
        c_roll = math.cos(roll)
        z1 = s_pitch * c_roll
        c_pitch = math.cos(pitch)
        e3z = c_pitch * c_roll
        z2 = z1 * c_lam + e3z * s_lam
        h2z = e2z * c_steer + s_steer * z2
        z3 = s_lam * s_steer
        z4 = r_R * e3z
        z5 = z1 * z1 + e3z * e3z
        z6 = 1.0 / math.sqrt(z5)
        R3 = z4 * z6
        z7 = R3 + k9
        z8 = c_steer * z2 - e2z * s_steer
        z9 = z1 * s_lam - e3z * c_lam
        z10 = c_lam * z8 + s_lam * z9
        z11 = r_F * z10
        z12 = c_lam * z9 - s_lam * z8
        z13 = z10 * z10 + z12 * z12
        z14 = 1.0 / math.sqrt(z13)
        z15 = z11 * z14
        z16 = z15 - k15
        z17 = s_steer * z16
        z18 = z3 * z7 + c_lam * z17
        z19 = r_R * z1
        z20 = z19 * z6
        z21 = z20 + k10
        z22 = z3 * z21 - s_lam * z17
        z23 = s_pitch * z18 - c_pitch * z22
        z24 = s_lam * c_steer
        z25 = k11 + s_lam * z24
        z26 = c_lam * (s_lam - z24)
        z27 = z20 * z25 + R3 * z26
        z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16
        z29 = c_roll * z23 - e2z * z28
        z30 = c_lam * c_steer
        z31 = s_lam * (c_lam - z30)
        z32 = c_lam * z30 + k14
        z33 = z20 * z31 + R3 * z32
        z34 = c_lam * s_steer
        z35 = R3 * z34 - z20 * z3
        z36 = r_F * z12
        z37 = z36 * z14
        z38 = k12 - c_lam * z37 - s_lam * z15
        z39 = z34 * k9 - z3 * k10 + z35 - s_steer * z38
        z40 = z37 + k13
        z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40
        z42 = z33 * z39 - z41 * z35
        z43 = c_steer * z38
        z44 = s_lam * z37
        z45 = c_lam * z15
        z46 = k3 + z44 - z45
        z47 = c_steer * z7 - c_lam * z43 + s_lam * z46
        z48 = c_steer * z21 + s_lam * z43 + c_lam * z46
        z49 = s_pitch * z47 - c_pitch * z48
        z50 = c_roll * z49 - e2z * z39
        z51 = s_steer * z40
        z52 = z34 * z7 + c_lam * z51
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
        z80 = c_roll * z78
        w1_pitch = z59 + s_pitch * z80
        w3_pitch = z60 - c_pitch * z80
        z81 = c_lam * w1_pitch - s_lam * w3_pitch
        z82 = s_steer * z79 - c_steer * z81
        z83 = c_steer * z79 + s_steer * z81
        z84 = F_yy * (thF_dot - z83) - k42 * z83
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z85 = k38 * z82 - k39 * w3_steer
        z86 = c_pitch * z76
        z87 = roll_dot * z86
        z88 = s_pitch * z76
        z89 = roll_dot * e2z
        z90 = steer_dot * c_steer
        z91 = roll_dot * z88
        z92 = s_lam * z87 + c_lam * z91
        z93 = z90 * z62 - s_steer * z92
        z94 = roll_dot * c_roll
        z95 = steer_dot * s_steer
        z96 = s_pitch * z89 + c_roll * z86
        z97 = c_pitch * z89 - c_roll * z88
        s1 = z2 * z95 + c_steer * (c_lam * z96 + s_lam * z97)
        z98 = s_steer * z94 + e2z * z90 + s1
        z99 = s_lam * z96 - c_lam * z97
        z100 = c_lam * z98 + s_lam * z99
        z101 = r_F * z14
        z102 = c_lam * z99 - s_lam * z98
        z103 = (z10 * z100 + z12 * z102) * (z14 / z13)
        z104 = z100 * z101 - z11 * z103
        z105 = k3 * z93
        z106 = r_R * z6
        z107 = (z1 * z96 + e3z * z97) * (z6 / z5)
        z108 = z106 * z97 - z4 * z107
        z109 = z106 * z96 - z19 * z107
        s2 = R3 * z91 - z59 * z108 - (z20 * z87 + z60 * z109)
        z110 = k9 * z91 - k10 * z87 + s2
        z111 = k12 * z93 + (z90 * z66 + s_steer * z110)
        z112 = z58 * (z29 * z77 + z28 * z75 + z57 * z74)
        z113 = s_lam * z95
        z114 = s_lam * z113
        z115 = c_lam * z113
        z116 = z20 * z114 + z25 * z109 - (R3 * z115 - z26 * z108)
        z117 = s_lam * z90
        z118 = z90 * z16 - s_steer * z104
        z119 = z3 * z109
        s3 = z18 * z86 - s_pitch * (z7 * z117 - z3 * z108 + c_lam * z118)
        s4 = z22 * z88 + c_pitch * (z21 * z117 - z119 - s_lam * z118)
        z120 = s3 + s4
        z121 = k10 * z114 - k9 * z115 + z116 - (z95 * z16 + c_steer * z104)
        s5 = z78 * (z89 * z23 + c_roll * z120 + (z94 * z28 - e2z * z121))
        z122 = z112 * z116 + (s5 - z76 * z121)
        s6 = z15 * z93 - z69 * z104 - (c_lam * z105 + s_lam * z111)
        z123 = s6 + z122
        z124 = s_lam * z91 - c_lam * z87
        z125 = z95 * z62 + c_steer * z92
        z126 = z102 * z101 - z36 * z103
        s7 = z37 * (s_lam * z124 + c_lam * z125) - z64 * z126
        z127 = s7 + (z15 * (s_lam * z125 - c_lam * z124) + z65 * z104)
        z128 = c_lam * z90
        z129 = z34 * z108
        z130 = R3 * z128 - z129 - (z20 * z117 - z119)
        z131 = c_lam * z126 + s_lam * z104
        z132 = z95 * z38 - c_steer * z131
        z133 = s_lam * z126 - c_lam * z104
        s8 = z95 * z7 + c_steer * z108 - c_lam * z132 + s_lam * z133
        s9 = z95 * z21 + c_steer * z109 + s_lam * z132 + c_lam * z133
        z134 = z47 * z86 + s_pitch * s8 + (z48 * z88 - c_pitch * s9)
        z135 = k9 * z128 - k10 * z117 + z130 - (z90 * z38 + s_steer * z131)
        s10 = z78 * (z89 * z49 + c_roll * z134 + (z94 * z39 + e2z * z135))
        z136 = z112 * z130 - (s10 + z76 * z135)
        s11 = z127 - (k12 * z125 - k3 * z124 + (z95 * z66 - c_steer * z110))
        z137 = s11 + z136
        z138 = c_lam * z95
        z139 = s_lam * z138
        z140 = c_lam * z138
        z141 = z20 * z139 - z31 * z109 - (R3 * z140 + z32 * z108)
        z142 = z90 * z40 - s_steer * z126
        s12 = c_pitch * (z21 * z128 - z34 * z109 - s_lam * z142)
        s13 = z52 * z86 - s_pitch * (z7 * z128 - z129 + c_lam * z142)
        z143 = s13 + (z53 * z88 + s12)
        z144 = k10 * z139 - k9 * z140 + z141 - (z95 * z40 + c_steer * z126)
        s14 = z78 * (z89 * z54 + c_roll * z143 - (z94 * z41 + e2z * z144))
        z145 = z112 * z141 + (s14 - z76 * z144)
        s15 = z37 * z93 - z69 * z126 + (s_lam * z105 - c_lam * z111)
        z146 = s15 + z145
        z147 = z33 * z137 - z35 * z146
        z148 = z41 * z137 - z39 * z146
        z149 = z58 * (z42 * z123 + z28 * z147 - z27 * z148)
        z150 = z89 * z78 - c_roll * z149
        z151 = z87 + (z80 * z88 - c_pitch * z150)
        z152 = z91 - (z80 * z86 + s_pitch * z150)
        z153 = c_lam * z151 - s_lam * z152
        z154 = z112 - z79
        a1 = R3 * z154
        a3 = z20 * z154
        s16 = w1_pitch * z108 - R3 * z152 + (w3_pitch * z109 + z20 * z151)
        z155 = a1 * w3_pitch - a3 * w1_pitch + s16
        z156 = k9 * z79
        z157 = k10 * z79
        s17 = w3_pitch * z156 - w1_pitch * z157 - (k10 * z151 - k9 * z152)
        z158 = z155 - s17
        v2_x = R3 * w1_pitch + z20 * w3_pitch
        z159 = z50 * z146 + z55 * z137
        s18 = z58 * (z29 * z147 + z56 * z123 + z27 * z159)
        z160 = s18 + (z94 * z78 + e2z * z149)
        z161 = z58 * (z29 * z148 + z28 * z159 + z57 * z123) - z160
        z162 = z79 * a3 - w3_pitch * v2_x + (z154 * z108 - R3 * z161)
        z163 = k10 * w3_pitch + k9 * w1_pitch
        z164 = z162 - (z79 * z157 + w3_pitch * z163 - k9 * z160)
        z165 = w1_pitch * v2_x - z79 * a1 + (z154 * z109 - z20 * z161)
        z166 = z165 + (w1_pitch * z163 + z79 * z156 + k10 * z160)
        z167 = c_lam * z164 - s_lam * z166
        z168 = c_steer * z158 + s_steer * z167
        z169 = c_lam * z152 + s_lam * z151
        z170 = z90 * z79 + s_steer * z160 + (z95 * z81 - c_steer * z169)
        s19 = k46 * z153 + (k31 * z168 + k45 * z170)
        z171 = h2z * k59 - (z82 * z84 + z83 * z85 + s19)
        c_yaw = math.cos(yaw)
        s_yaw = math.sin(yaw)
        z172 = s_yaw * e2z
        e1x = c_yaw * c_pitch - z172 * s_pitch
        e3x = c_yaw * s_pitch + c_pitch * z172
        sx = e1x * s_lam + e3x * c_lam
        z173 = e1x * c_lam - e3x * s_lam
        z174 = s_yaw * c_roll
        f1x = c_steer * z173 - z174 * s_steer
        h3x = c_lam * sx - s_lam * f1x
        z175 = z174 * c_steer + z173 * s_steer
        h1x = c_lam * f1x + s_lam * sx
        z176 = z175 * z33 - h1x * z35
        z177 = z175 * z41 - h1x * z39
        z178 = z58 * (h3x * z42 - z28 * z176 + z27 * z177)
        z179 = c_roll * z178
        z180 = c_pitch * z179
        z181 = s_pitch * z179
        z182 = c_lam * z180 - s_lam * z181
        z183 = z171 * z182
        z184 = k45 * z82 - k46 * w3_steer
        z185 = z95 * z79 - c_steer * z160 - (z90 * z81 + s_steer * z169)
        z186 = c_steer * z167 - s_steer * z158
        z187 = c_lam * z166 + s_lam * z164
        s20 = k42 * z185 + (k28 * z186 - k31 * z187)
        s21 = z8 * k54 + z9 * k53 + (z8 * k57 - z9 * k56)
        z188 = s21 - (w3_steer * z85 + z82 * z184 - s20)
        z189 = h1x * z50 + z175 * z55
        z190 = z58 * (z29 * z176 - h3x * z56 + z27 * z189) - e2z * z178
        z191 = c_lam * z181 + s_lam * z180
        z192 = c_steer * z190 - s_steer * z191
        z193 = z188 * z192
        s22 = k39 * z153 - (k28 * z168 - k38 * z170)
        z194 = h2z * k58 + (z83 * z184 - w3_steer * z84 - s22)
        z195 = s_steer * z190 + c_steer * z191
        z196 = z194 * z195
        z197 = k28 * z82 + k31 * w3_steer
        z198 = k28 * z83
        s23 = z82 * z197 + z83 * z198 - (k26 * z187 - k31 * z185)
        z199 = z9 * k55 - s23
        z200 = z58 * (z29 * z177 + z28 * z189 - h3x * z57) - z190
        z201 = z20 * z200
        z202 = e3x + z201
        z203 = k10 * z190
        z204 = z202 - z203
        z205 = R3 * z200
        z206 = e1x + z205
        z207 = k9 * z190
        z208 = z206 - z207
        z209 = c_lam * z204 + s_lam * z208
        z210 = k31 * z83
        s24 = k31 * z153 + (k26 * z168 - k28 * z170)
        z211 = h2z * k55 + (w3_steer * z198 - z82 * z210 + s24)
        z212 = R3 * z181 - z20 * z180
        z213 = z174 - z212
        z214 = k10 * z180 - k9 * z181
        z215 = z213 + z214
        z216 = c_lam * z208 - s_lam * z204
        z217 = c_steer * z215 + s_steer * z216
        s25 = z83 * z210 + w3_steer * z197 - (k26 * z186 + k28 * z185)
        z218 = z8 * k55 - s25
        z219 = c_steer * z216 - s_steer * z215
        z220 = k22 * z79
        z221 = k20 * w1_pitch + k23 * w3_pitch
        s26 = k24 * z151 + (k18 * z155 - k23 * z152)
        z222 = e2z * k51 + (w1_pitch * z220 - z79 * z221 + s26)
        z223 = z222 * z180
        z224 = k23 * w1_pitch + k24 * w3_pitch
        s27 = k22 * z160 - (k17 * z162 - k18 * z165)
        s28 = w3_pitch * z221 - w1_pitch * z224 - s27
        z225 = z1 * k52 + e3z * k51 + s28
        z226 = z225 * z190
        s29 = k23 * z151 - (k17 * z155 + k20 * z152)
        z227 = e2z * k52 - (z79 * z224 - w3_pitch * z220 + s29)
        z228 = z227 * z181
        z229 = k17 * w1_pitch - k18 * w3_pitch
        z230 = k17 * z79
        s30 = w1_pitch * z229 + z79 * z230 - (k16 * z165 + k18 * z160)
        z231 = e3z * k50 + s30
        z232 = k18 * z79
        s31 = z79 * z232 - w3_pitch * z229 - (k16 * z162 - k17 * z160)
        z233 = z1 * k50 - s31
        s32 = k18 * z151 + (k16 * z155 + k17 * z152)
        z234 = e2z * k50 + (w3_pitch * z230 + w1_pitch * z232 + s32)
        s33 = z226 + (z228 - (z231 * z202 - (z233 * z206 + z234 * z213)))
        z235 = z211 * z217 + (z218 * z219 + (z223 + s33))
        z236 = R_yy * z200
        z237 = z161 * z236
        z238 = F_yy * z192
        z239 = z185 * z238
        z240 = z154 * (roll_dot * R_yy)
        z241 = z179 * z240
        z242 = z37 * z35
        z243 = z37 * z39
        z244 = z58 * (z15 * z42 - z28 * z242 + z27 * z243)
        z245 = c_roll * z244
        z246 = c_pitch * z245
        z247 = s_pitch * z245
        z248 = c_lam * z246 - s_lam * z247
        z249 = k46 * z182
        z250 = k45 * z195
        z251 = z249 + (k31 * z217 - z250)
        z252 = z37 * z50
        z253 = z58 * (z29 * z242 - z15 * z56 - z27 * z252) - e2z * z244
        z254 = c_lam * z247 + s_lam * z246
        z255 = c_steer * z253 - s_steer * z254
        z256 = k42 * z192
        z257 = z256 + (k28 * z219 - k31 * z209)
        z258 = s_steer * z253 + c_steer * z254
        z259 = k39 * z182
        z260 = k38 * z195
        z261 = z259 - (k28 * z217 + z260)
        z262 = z58 * (z29 * z243 - z28 * z252 - z15 * z57) - z253
        z263 = z20 * z262
        z264 = z263 - k10 * z253
        z265 = R3 * z262
        z266 = z265 - k9 * z253
        z267 = c_lam * z264 + s_lam * z266
        z268 = k31 * z192
        z269 = k26 * z209 - z268
        z270 = R3 * z247 - z20 * z246
        z271 = z270 - (k10 * z246 - k9 * z247)
        z272 = c_lam * z266 - s_lam * z264
        z273 = c_steer * z271 - s_steer * z272
        z274 = k31 * z182
        z275 = k28 * z195
        z276 = z274 + (k26 * z217 + z275)
        z277 = c_steer * z272 + s_steer * z271
        z278 = k28 * z192
        z279 = k26 * z219 + z278
        z280 = k24 * z180
        z281 = k23 * z181
        z282 = z280 + (k18 * z213 - z281)
        z283 = k22 * z190
        z284 = z283 + (k17 * z206 - k18 * z202)
        z285 = k23 * z180
        z286 = k20 * z181
        z287 = z285 - (k17 * z213 + z286)
        z288 = k18 * z190
        z289 = k16 * z202 - z288
        z290 = k17 * z190
        z291 = k16 * z206 + z290
        z292 = k18 * z180
        z293 = k17 * z181
        z294 = z292 + (k16 * z213 + z293)
        s34 = z247 * z287 - (z263 * z289 + (z265 * z291 - z270 * z294))
        z295 = z246 * z282 + (z253 * z284 - s34)
        s35 = z267 * z269 - (z273 * z276 - (z277 * z279 + z295))
        z296 = z248 * z251 + (z255 * z257 - (z258 * z261 - s35))
        z297 = z262 * z236
        z298 = 1.0 + z255
        z299 = z298 * z238
        z300 = s_pitch * s_lam - c_pitch * c_lam
        z301 = s_steer * z300
        z302 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20)
        z303 = k12 * z301 + s_steer * z302
        z304 = k3 * z301
        z305 = z15 * z301 - (s_lam * z303 + c_lam * z304)
        z306 = c_pitch * s_lam + s_pitch * c_lam
        z307 = c_steer * z300
        s36 = z37 * (s_lam * z306 - c_lam * z307)
        s37 = s36 - z15 * (s_lam * z307 + c_lam * z306)
        z308 = s37 + (k12 * z307 + k3 * z306 + c_steer * z302)
        z309 = z37 * z301 + (s_lam * z304 - c_lam * z303)
        z310 = z33 * z308 - z35 * z309
        z311 = z41 * z308 - z39 * z309
        z312 = z58 * (z42 * z305 + z28 * z310 - z27 * z311)
        z313 = c_roll * z312
        z314 = s_pitch - c_pitch * z313
        z315 = c_pitch + s_pitch * z313
        z316 = c_lam * z314 + s_lam * z315
        z317 = z50 * z309 + z55 * z308
        z318 = z58 * (z29 * z310 + z56 * z305 + z27 * z317) + e2z * z312
        z319 = c_lam * z315 - s_lam * z314
        z320 = c_steer * z318 + s_steer * z319
        z321 = s_steer * z318 - c_steer * z319
        z322 = z58 * (z29 * z311 + z28 * z317 + z57 * z305) - z318
        z323 = z20 * z322
        z324 = z323 - k10 * z318
        z325 = R3 * z322
        z326 = z325 - k9 * z318
        z327 = c_lam * z324 + s_lam * z326
        z328 = R3 * z315 + z20 * z314
        z329 = z328 + (k10 * z314 + k9 * z315)
        z330 = c_lam * z326 - s_lam * z324
        z331 = c_steer * z329 + s_steer * z330
        z332 = c_steer * z330 - s_steer * z329
        s38 = z315 * z287 + (z323 * z289 + (z325 * z291 + z328 * z294))
        z333 = z314 * z282 + (z318 * z284 + s38)
        s39 = z327 * z269 + (z331 * z276 + (z332 * z279 + z333))
        z334 = z316 * z251 + (z320 * z257 - (z321 * z261 - s39))
        z335 = z322 * z236
        z336 = z320 * z238
        z337 = k3 + (z44 - z45)
        z338 = z33 * z337
        z339 = z41 * z337
        z340 = z58 * (z28 * z338 - z27 * z339)
        z341 = c_roll * z340
        z342 = c_pitch * z341
        z343 = s_pitch * z341
        z344 = 1.0 - (c_lam * z342 - s_lam * z343)
        z345 = z55 * z337
        z346 = z58 * (z29 * z338 + z27 * z345) + e2z * z340
        z347 = c_lam * z343 + s_lam * z342
        z348 = c_steer * z346 + s_steer * z347
        z349 = s_steer * z346 - c_steer * z347
        z350 = z58 * (z29 * z339 + z28 * z345) - z346
        z351 = z20 * z350
        z352 = z351 - k10 * z346
        z353 = R3 * z350
        z354 = z353 - k9 * z346
        z355 = c_lam * z352 + s_lam * z354
        z356 = R3 * z343 - z20 * z342
        z357 = z356 - (k10 * z342 - k9 * z343)
        z358 = c_lam * z354 - s_lam * z352
        z359 = c_steer * z357 + s_steer * z358
        z360 = c_steer * z358 - s_steer * z357
        s40 = z343 * z287 + (z351 * z289 + (z353 * z291 + z356 * z294))
        z361 = z342 * z282 - (z346 * z284 + s40)
        s41 = z355 * z269 + (z359 * z276 + (z360 * z279 - z361))
        z362 = z344 * z251 + (z348 * z257 - (z349 * z261 - s41))
        z363 = z350 * z236
        z364 = z348 * z238
        s42 = steer_ddot * (z362 + z363 + z364)
        s43 = roll_ddot * (z334 + z335 + z336) + s42
        z365 = thF_ddot * (z296 + z297 + z299) - s43
        z366 = c_yaw * e2z
        e1y = c_pitch * s_yaw + s_pitch * z366
        e3y = s_yaw * s_pitch - c_pitch * z366
        sy = e1y * s_lam + e3y * c_lam
        z367 = e1y * c_lam - e3y * s_lam
        e2y = c_yaw * c_roll
        f1y = c_steer * z367 + e2y * s_steer
        h3y = c_lam * sy - s_lam * f1y
        h2y = e2y * c_steer - s_steer * z367
        h1y = c_lam * f1y + s_lam * sy
        z368 = h2y * z33 + h1y * z35
        z369 = h2y * z41 + h1y * z39
        z370 = z58 * (h3y * z42 + z28 * z368 - z27 * z369)
        z371 = c_roll * z370
        z372 = c_pitch * z371
        z373 = s_pitch * z371
        z374 = c_lam * z372 - s_lam * z373
        z375 = z171 * z374
        z376 = h1y * z50 - h2y * z55
        z377 = z58 * (z29 * z368 + h3y * z56 - z27 * z376) + e2z * z370
        z378 = c_lam * z373 + s_lam * z372
        z379 = c_steer * z377 + s_steer * z378
        z380 = z188 * z379
        z381 = s_steer * z377 - c_steer * z378
        z382 = z194 * z381
        z383 = z58 * (z29 * z369 - z28 * z376 + h3y * z57) - z377
        z384 = z20 * z383
        z385 = e3y - z384
        z386 = k10 * z377
        z387 = z385 + z386
        z388 = R3 * z383
        z389 = e1y - z388
        z390 = k9 * z377
        z391 = z389 + z390
        z392 = c_lam * z387 + s_lam * z391
        z393 = R3 * z373 - z20 * z372
        z394 = e2y + z393
        z395 = k10 * z372 - k9 * z373
        z396 = z394 - z395
        z397 = c_lam * z391 - s_lam * z387
        z398 = c_steer * z396 - s_steer * z397
        z399 = c_steer * z397 + s_steer * z396
        z400 = z222 * z372
        z401 = z225 * z377
        z402 = z227 * z373
        s44 = z401 - (z402 - (z231 * z385 - (z233 * z389 - z234 * z394)))
        z403 = z211 * z398 - (z218 * z399 + (z400 - s44))
        z404 = R_yy * z383
        z405 = z161 * z404
        z406 = F_yy * z379
        z407 = z185 * z406
        z408 = z371 * z240
        z409 = k46 * z374
        z410 = k45 * z381
        z411 = z409 - (k31 * z398 - z410)
        z412 = k42 * z379
        z413 = z412 - (k28 * z399 - k31 * z392)
        z414 = k39 * z374
        z415 = k38 * z381
        z416 = z414 + (k28 * z398 + z415)
        z417 = k31 * z379
        z418 = k26 * z392 + z417
        z419 = k31 * z374
        z420 = k28 * z381
        z421 = z419 - (k26 * z398 + z420)
        z422 = k28 * z379
        z423 = k26 * z399 - z422
        z424 = k24 * z372
        z425 = k23 * z373
        z426 = z424 - (k18 * z394 + z425)
        z427 = k22 * z377
        z428 = z427 - (k17 * z389 - k18 * z385)
        z429 = k23 * z372
        z430 = k20 * z373
        z431 = z429 + (k17 * z394 - z430)
        z432 = k18 * z377
        z433 = k16 * z385 + z432
        z434 = k17 * z377
        z435 = k16 * z389 - z434
        z436 = k18 * z372
        z437 = k17 * z373
        z438 = z436 - (k16 * z394 - z437)
        s45 = z247 * z431 - (z263 * z433 + (z265 * z435 - z270 * z438))
        z439 = z246 * z426 - (z253 * z428 + s45)
        s46 = z267 * z418 - (z273 * z421 - (z277 * z423 + z439))
        z440 = z248 * z411 - (z255 * z413 + (z258 * z416 - s46))
        z441 = z262 * z404
        z442 = z298 * z406
        s47 = z315 * z431 + (z323 * z433 + (z325 * z435 + z328 * z438))
        z443 = z314 * z426 - (z318 * z428 - s47)
        s48 = z327 * z418 + (z331 * z421 + (z332 * z423 + z443))
        z444 = z316 * z411 - (z320 * z413 + (z321 * z416 - s48))
        z445 = z322 * z404
        z446 = z320 * z406
        s49 = z343 * z431 + (z351 * z433 + (z353 * z435 + z356 * z438))
        z447 = z342 * z426 + (z346 * z428 - s49)
        s50 = z355 * z418 + (z359 * z421 + (z360 * z423 - z447))
        z448 = z344 * z411 - (z348 * z413 + (z349 * z416 - s50))
        z449 = z350 * z404
        z450 = z348 * z406
        s51 = steer_ddot * (z448 - z449 - z450)
        s52 = roll_ddot * (z444 - z445 - z446) + s51
        z451 = thF_ddot * (z440 - z441 - z442) - s52
        z452 = h2z * z33 - z10 * z35
        z453 = h2z * z41 - z10 * z39
        z454 = z58 * (z12 * z42 - z28 * z452 + z27 * z453)
        z455 = c_roll * z454
        z456 = c_pitch * z455
        z457 = s_pitch * z455
        z458 = c_lam * z456 - s_lam * z457
        z459 = z171 * z458
        z460 = z10 * z50 + h2z * z55
        z461 = z58 * (z29 * z452 - z12 * z56 + z27 * z460) - e2z * z454
        z462 = c_lam * z457 + s_lam * z456
        z463 = c_steer * z461 - s_steer * z462
        z464 = z188 * z463
        z465 = s_steer * z461 + c_steer * z462
        z466 = z194 * z465
        z467 = z58 * (z29 * z453 + z28 * z460 - z12 * z57) - z461
        z468 = z20 * z467
        z469 = e3z - z468
        z470 = k10 * z461
        z471 = z469 + z470
        z472 = R3 * z467
        z473 = z1 + z472
        z474 = k9 * z461
        z475 = z473 - z474
        z476 = c_lam * z471 - s_lam * z475
        z477 = R3 * z457 - z20 * z456
        z478 = e2z - z477
        z479 = k10 * z456 - k9 * z457
        z480 = z478 + z479
        z481 = c_lam * z475 + s_lam * z471
        z482 = c_steer * z480 + s_steer * z481
        z483 = c_steer * z481 - s_steer * z480
        z484 = z222 * z456
        z485 = z225 * z461
        z486 = z227 * z457
        s53 = z485 + (z486 + (z231 * z469 + (z233 * z473 + z234 * z478)))
        z487 = z211 * z482 + (z218 * z483 + (z484 + s53))
        z488 = R_yy * z467
        z489 = z161 * z488
        z490 = F_yy * z463
        z491 = z185 * z490
        z492 = z455 * z240
        z493 = k46 * z458
        z494 = k45 * z465
        z495 = z493 + (k31 * z482 - z494)
        z496 = k42 * z463
        z497 = z496 + (k28 * z483 + k31 * z476)
        z498 = k39 * z458
        z499 = k38 * z465
        z500 = z498 - (k28 * z482 + z499)
        z501 = k31 * z463
        z502 = k26 * z476 + z501
        z503 = k31 * z458
        z504 = k28 * z465
        z505 = z503 + (k26 * z482 + z504)
        z506 = k28 * z463
        z507 = k26 * z483 + z506
        z508 = k24 * z456
        z509 = k23 * z457
        z510 = z508 + (k18 * z478 - z509)
        z511 = k22 * z461
        z512 = z511 + (k17 * z473 + k18 * z469)
        z513 = k23 * z456
        z514 = k20 * z457
        z515 = z513 - (k17 * z478 + z514)
        z516 = k18 * z461
        z517 = k16 * z469 + z516
        z518 = k17 * z461
        z519 = k16 * z473 + z518
        z520 = k18 * z456
        z521 = k17 * z457
        z522 = z520 + (k16 * z478 + z521)
        s54 = z247 * z515 + (z263 * z517 - (z265 * z519 - z270 * z522))
        z523 = z246 * z510 + (z253 * z512 - s54)
        s55 = z267 * z502 + (z273 * z505 - (z277 * z507 + z523))
        z524 = z248 * z495 + (z255 * z497 - (z258 * z500 + s55))
        z525 = z262 * z488
        z526 = z298 * z490
        s56 = z315 * z515 - (z323 * z517 - (z325 * z519 + z328 * z522))
        z527 = z314 * z510 + (z318 * z512 + s56)
        s57 = z327 * z502 - (z331 * z505 + (z332 * z507 + z527))
        z528 = z316 * z495 + (z320 * z497 - (z321 * z500 + s57))
        z529 = z322 * z488
        z530 = z320 * z490
        s58 = z343 * z515 - (z351 * z517 - (z353 * z519 + z356 * z522))
        z531 = z342 * z510 - (z346 * z512 + s58)
        s59 = z355 * z502 - (z359 * z505 + (z360 * z507 - z531))
        z532 = z344 * z495 + (z348 * z497 - (z349 * z500 + s59))
        z533 = z350 * z488
        z534 = z348 * z490
        s60 = steer_ddot * (z532 + z533 + z534)
        s61 = roll_ddot * (z528 + z529 + z530) + s60
        z535 = thF_ddot * (z524 + z525 + z526) - s61
        z536 = z201 - z203
        z537 = z205 - z207
        z538 = c_lam * z536 + s_lam * z537
        z539 = z212 - z214
        z540 = c_lam * z537 - s_lam * z536
        z541 = c_steer * z539 - s_steer * z540
        z542 = c_steer * z540 + s_steer * z539
        s62 = z226 + (z228 - (z231 * z201 - (z233 * z205 - z234 * z212)))
        z543 = z211 * z541 - (z218 * z542 + (z223 + s62))
        z544 = z249 - (z250 + k31 * z541)
        z545 = z256 + (k28 * z542 - k31 * z538)
        z546 = z259 - (z260 - k28 * z541)
        z547 = z268 - k26 * z538
        z548 = z274 + (z275 - k26 * z541)
        z549 = z278 + k26 * z542
        z550 = z280 - (z281 + k18 * z212)
        z551 = z283 + (k17 * z205 - k18 * z201)
        z552 = z285 - (z286 - k17 * z212)
        z553 = z288 - k16 * z201
        z554 = z290 + k16 * z205
        z555 = z292 + (z293 - k16 * z212)
        s63 = z247 * z552 + (z263 * z553 - (z265 * z554 - z270 * z555))
        z556 = z246 * z550 + (z253 * z551 - s63)
        s64 = z267 * z547 + (z273 * z548 - (z277 * z549 + z556))
        z557 = z248 * z544 + (z255 * z545 - (z258 * z546 + s64))
        s65 = z315 * z552 - (z323 * z553 - (z325 * z554 + z328 * z555))
        z558 = z314 * z550 + (z318 * z551 + s65)
        s66 = z327 * z547 - (z331 * z548 + (z332 * z549 + z558))
        z559 = z316 * z544 + (z320 * z545 - (z321 * z546 + s66))
        s67 = z343 * z552 - (z351 * z553 - (z353 * z554 + z356 * z555))
        z560 = z342 * z550 - (z346 * z551 + s67)
        s68 = z355 * z547 - (z359 * z548 + (z360 * z549 - z560))
        z561 = z344 * z544 + (z348 * z545 - (z349 * z546 + s68))
        s69 = steer_ddot * (z364 + (z561 + z363))
        s70 = roll_ddot * (z336 + (z559 + z335)) + s69
        z562 = thF_ddot * (z299 + (z557 + z297)) - s70
        z563 = z384 - z386
        z564 = z388 - z390
        z565 = c_lam * z563 + s_lam * z564
        z566 = z393 - z395
        z567 = c_lam * z564 - s_lam * z563
        z568 = c_steer * z566 + s_steer * z567
        z569 = c_steer * z567 - s_steer * z566
        s71 = z401 - (z402 + (z231 * z384 - (z233 * z388 + z234 * z393)))
        z570 = z211 * z568 + (z218 * z569 - (z400 - s71))
        z571 = z409 + (z410 - k31 * z568)
        z572 = z412 + (k28 * z569 - k31 * z565)
        z573 = z414 + (z415 + k28 * z568)
        z574 = z417 - k26 * z565
        z575 = z419 - (z420 + k26 * z568)
        z576 = z422 + k26 * z569
        z577 = z424 - (z425 + k18 * z393)
        z578 = z427 + (k17 * z388 - k18 * z384)
        z579 = z429 - (z430 - k17 * z393)
        z580 = z432 - k16 * z384
        z581 = z434 + k16 * z388
        z582 = z436 + (z437 - k16 * z393)
        s72 = z247 * z579 - (z263 * z580 - (z265 * z581 + z270 * z582))
        z583 = z246 * z577 - (z253 * z578 + s72)
        s73 = z267 * z574 - (z273 * z575 + (z277 * z576 - z583))
        z584 = z248 * z571 - (z255 * z572 + (z258 * z573 - s73))
        s74 = z315 * z579 + (z323 * z580 - (z325 * z581 - z328 * z582))
        z585 = z314 * z577 - (z318 * z578 - s74)
        s75 = z327 * z574 + (z331 * z575 - (z332 * z576 - z585))
        z586 = z316 * z571 - (z320 * z572 + (z321 * z573 - s75))
        s76 = z343 * z579 + (z351 * z580 - (z353 * z581 - z356 * z582))
        z587 = z342 * z577 + (z346 * z578 - s76)
        s77 = z355 * z574 + (z359 * z575 - (z360 * z576 + z587))
        z588 = z344 * z571 - (z348 * z572 + (z349 * z573 - s77))
        s78 = steer_ddot * (z450 - (z588 - z449))
        s79 = roll_ddot * (z446 - (z586 - z445)) + s78
        z589 = thF_ddot * (z442 - (z584 - z441)) - s79
        z590 = z468 - z470
        z591 = z472 - z474
        z592 = c_lam * z590 + s_lam * z591
        z593 = z477 - z479
        z594 = c_lam * z591 - s_lam * z590
        z595 = c_steer * z593 - s_steer * z594
        z596 = c_steer * z594 + s_steer * z593
        s80 = z485 + (z486 - (z231 * z468 - (z233 * z472 - z234 * z477)))
        z597 = z211 * z595 - (z218 * z596 + (z484 + s80))
        z598 = z493 - (z494 + k31 * z595)
        z599 = z496 + (k28 * z596 - k31 * z592)
        z600 = z498 - (z499 - k28 * z595)
        z601 = z501 - k26 * z592
        z602 = z503 + (z504 - k26 * z595)
        z603 = z506 + k26 * z596
        z604 = z508 - (z509 + k18 * z477)
        z605 = z511 + (k17 * z472 - k18 * z468)
        z606 = z513 - (z514 - k17 * z477)
        z607 = z516 - k16 * z468
        z608 = z518 + k16 * z472
        z609 = z520 + (z521 - k16 * z477)
        s81 = z247 * z606 + (z263 * z607 - (z265 * z608 - z270 * z609))
        z610 = z246 * z604 + (z253 * z605 - s81)
        s82 = z267 * z601 + (z273 * z602 - (z277 * z603 + z610))
        z611 = z248 * z598 + (z255 * z599 - (z258 * z600 + s82))
        s83 = z315 * z606 - (z323 * z607 - (z325 * z608 + z328 * z609))
        z612 = z314 * z604 + (z318 * z605 + s83)
        s84 = z327 * z601 - (z331 * z602 + (z332 * z603 + z612))
        z613 = z316 * z598 + (z320 * z599 - (z321 * z600 + s84))
        s85 = z343 * z606 - (z351 * z607 - (z353 * z608 + z356 * z609))
        z614 = z342 * z604 - (z346 * z605 + s85)
        s86 = z355 * z601 - (z359 * z602 + (z360 * z603 - z614))
        z615 = z344 * z598 + (z348 * z599 - (z349 * z600 + s86))
        s87 = steer_ddot * (z534 + (z615 + z533))
        s88 = roll_ddot * (z530 + (z613 + z529)) + s87
        z616 = thF_ddot * (z526 + (z611 + z525)) - s88
        s89 = z183 - (z193 + (z196 + (z199 * z209 + z235))) + z237 - z239
        s90 = z375 + (z380 + (z382 - (z199 * z392 - z403))) - z405 + z407
        s91 = z459 - (z464 + (z466 - (z199 * z476 - z487))) + z489 - z491
        s92 = z237 + (z183 - (z193 + (z196 + (z199 * z538 - z543))))
        s93 = z405 - (z375 + (z380 + (z382 + (z199 * z565 + z570))))
        s94 = z489 + (z459 - (z464 + (z466 + (z199 * z592 - z597))))
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            z365 - (s89 + z241),
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            z451 - (s90 + z408),
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            s91 + z492 - z535,
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            z241 - (z239 - s92) - z562,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            z408 + (z407 - s93) + z589,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            z616 - (z492 - (z491 - s94)),
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
        k10 = s_lam * k4 - c_lam * k9
        k11 = s_lam * s_lam
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
        z26 = c_lam * z25 + k11
        z27 = s_lam * (c_lam - z25)
        z28 = R3 * z26 + z27 * z11
        z29 = c_lam * s_steer
        z30 = R3 * z29 - z12 * z11
        z31 = z9 * z14
        z32 = k9 - c_lam * z31 - s_lam * z15
        z33 = z29 * k6 - z12 * k7 + z30 - s_steer * z32
        z34 = z31 + k10
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
        k13 = s_lam * k3 - c_lam * k12
        k14 = s_lam * s_lam
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
        z33 = c_lam * z31 + k14
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
        z44 = z40 + k13
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
        z444 = R_yy * (z174 * z253)
        z445 = steer_dot * s_steer
        z446 = roll_dot * e2z
        z447 = c_pitch * z248
        z448 = s_pitch * z446 + c_roll * z447
        z449 = s_pitch * z248
        z450 = c_pitch * z446 - c_roll * z449
        z451 = s_lam * z448 - c_lam * z450
        z452 = roll_dot * c_roll
        z453 = steer_dot * c_steer
        z454 = c_lam * z448 + s_lam * z450
        z455 = s_steer * z452 + e2z * z453 + (z7 * z445 + c_steer * z454)
        z456 = c_lam * z451 - s_lam * z455
        z457 = r_F * z456
        z458 = c_lam * z455 + s_lam * z451
        z459 = z10 * z458 + z12 * z456
        z460 = z14 * z459
        z461 = z276 * z460
        z462 = z14 * z457 - z39 * z461
        z463 = roll_dot * z449
        z464 = roll_dot * z447
        z465 = s_lam * z463 - c_lam * z464
        z466 = s_lam * z464 + c_lam * z463
        z467 = z445 * z228 + c_steer * z466
        z468 = s_lam * z465 + c_lam * z467
        z469 = r_F * z458
        z470 = z14 * z469 - z11 * z461
        z471 = s_lam * z467 - c_lam * z465
        z472 = r_R * z450
        z473 = z3 * z448 + e3z * z450
        z474 = z5 * z473
        z475 = z267 * z474
        z476 = z5 * z472 - z2 * z475
        z477 = r_R * z448
        z478 = z5 * z477 - z19 * z475
        s47 = R3 * z463 - z224 * z476 - (z20 * z464 + z225 * z478)
        z479 = k9 * z463 - k10 * z464 + s47
        s48 = k12 * z467 - k3 * z465 + (z445 * z233 - c_steer * z479)
        z480 = z230 * z462 - z40 * z468 - (z231 * z470 + z15 * z471) + s48
        z481 = c_lam * z453
        z482 = z35 * z476
        z483 = s_lam * z453
        z484 = z1 * z478
        z485 = R3 * z481 - z482 - (z20 * z483 - z484)
        z486 = c_lam * z462 + s_lam * z470
        z487 = z445 * z41 - c_steer * z486
        z488 = s_lam * z462 - c_lam * z470
        z489 = z445 * z6 + c_steer * z476 - c_lam * z487 + s_lam * z488
        z490 = z445 * z21 + c_steer * z478 + s_lam * z487 + c_lam * z488
        z491 = z52 * z447 + s_pitch * z489 + (z53 * z449 - c_pitch * z490)
        z492 = k9 * z481 - k10 * z483 + z485 - (z453 * z41 + s_steer * z486)
        z493 = z446 * z54 + c_roll * z491 + (z452 * z43 + e2z * z492)
        z494 = z480 - (z245 * z485 - (z250 * z493 + z248 * z492))
        z495 = z453 * z228 - s_steer * z466
        z496 = k3 * z495
        z497 = k12 * z495 + (z453 * z233 + s_steer * z479)
        z498 = c_lam * z445
        z499 = s_lam * z498
        z500 = c_lam * z498
        z501 = z20 * z499 - z32 * z478 - (R3 * z500 + z33 * z476)
        z502 = z453 * z44 - s_steer * z462
        z503 = z6 * z481 - z482 + c_lam * z502
        z504 = z21 * z481 - z35 * z478 - s_lam * z502
        z505 = z57 * z447 - s_pitch * z503 + (z58 * z449 + c_pitch * z504)
        z506 = k10 * z499 - k9 * z500 + z501 - (z445 * z44 + c_steer * z462)
        z507 = z446 * z59 + c_roll * z505 - (z452 * z46 + e2z * z506)
        s49 = z237 * z462 - z40 * z495 - (s_lam * z496 - c_lam * z497)
        z508 = s49 - (z245 * z501 + (z250 * z507 - z248 * z506))
        z509 = z34 * z494 - z38 * z508
        z510 = s_lam * z445
        z511 = s_lam * z510
        z512 = c_lam * z510
        z513 = z20 * z511 + z25 * z478 - (R3 * z512 - z26 * z476)
        z514 = z453 * z16 - s_steer * z470
        z515 = z6 * z483 - z1 * z476 + c_lam * z514
        z516 = z21 * z483 - z484 - s_lam * z514
        z517 = z18 * z447 - s_pitch * z515 + (z22 * z449 + c_pitch * z516)
        z518 = k10 * z511 - k9 * z512 + z513 - (z445 * z16 + c_steer * z470)
        z519 = z446 * z23 + c_roll * z517 + (z452 * z29 - e2z * z518)
        s50 = z237 * z470 - z15 * z495 + (s_lam * z497 + c_lam * z496)
        z520 = s50 - (z245 * z513 + (z250 * z519 - z248 * z518))
        z521 = z55 * z508 + z60 * z494
        z522 = z30 * z509 + z61 * z520 + z27 * z521
        z523 = z46 * z494 - z43 * z508
        z524 = z47 * z520 + z29 * z509 - z27 * z523
        z525 = z64 * z524
        z526 = z64 * z522 - (z452 * z250 - e2z * z525)
        z527 = c_lam * w1_pitch - s_lam * w3_pitch
        z528 = z446 * z250 + c_roll * z525
        z529 = z463 - (z261 * z447 + s_pitch * z528)
        z530 = z464 + (z261 * z449 - c_pitch * z528)
        z531 = c_lam * z529 + s_lam * z530
        z532 = z445 * z252 + c_steer * z526 - (z453 * z527 + s_steer * z531)
        z533 = z30 * z523 + z29 * z521 + z62 * z520
        z534 = z64 * z533 - z526
        z535 = c_lam * z530 - s_lam * z529
        s51 = w1_pitch * z476 - R3 * z529 + (w3_pitch * z478 + z20 * z530)
        z536 = s51 + (a1 * w3_pitch - a3 * w1_pitch)
        z537 = k9 * z252
        z538 = k10 * z252
        s52 = k10 * z530 - k9 * z529 - (w3_pitch * z537 - w1_pitch * z538)
        z539 = z536 + s52
        z540 = z253 * z476 + R3 * z534 + (z252 * a3 - w3_pitch * v2_x)
        z541 = k10 * w3_pitch + k9 * w1_pitch
        z542 = z540 - (k9 * z526 + (z252 * z538 + w3_pitch * z541))
        z543 = z253 * z478 + z20 * z534 + (w1_pitch * v2_x - z252 * a1)
        z544 = z543 - (k10 * z526 - (w1_pitch * z541 + z252 * z537))
        z545 = c_lam * z542 - s_lam * z544
        z546 = c_steer * z539 + s_steer * z545
        z547 = z453 * z252 - s_steer * z526 + (z445 * z527 - c_steer * z531)
        z548 = s_steer * z252 - c_steer * z527
        z549 = c_steer * z252 + s_steer * z527
        z550 = F_yy * (thF_dot - z549) - k47 * z549
        w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch)
        z551 = k43 * z548 - k44 * w3_steer
        s53 = k51 * z535 + (k36 * z546 + k50 * z547)
        z552 = h2z * k64 - (s53 + (z548 * z550 + z549 * z551))
        z553 = c_steer * z545 - s_steer * z539
        z554 = c_lam * z544 + s_lam * z542
        z555 = k50 * z548 - k51 * w3_steer
        s54 = k47 * z532 + (k33 * z553 - k36 * z554)
        s55 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61)
        z556 = s55 + (s54 - (w3_steer * z551 + z548 * z555))
        s56 = k44 * z535 - (k33 * z546 - k43 * z547)
        z557 = h2z * k63 - (s56 - (z549 * z555 - w3_steer * z550))
        z558 = k33 * z548 + k36 * w3_steer
        z559 = k33 * z549
        s57 = k31 * z554 - k36 * z532 - (z548 * z558 + z549 * z559)
        z560 = z9 * k60 + s57
        z561 = k36 * z549
        s58 = k36 * z535 + (k31 * z546 - k33 * z547)
        z562 = h2z * k60 + (s58 + (w3_steer * z559 - z548 * z561))
        s59 = k31 * z553 + k33 * z532 - (z549 * z561 + w3_steer * z558)
        z563 = z8 * k60 + s59
        z564 = k27 * z252
        z565 = k25 * w1_pitch + k28 * w3_pitch
        s60 = k29 * z530 + (k23 * z536 - k28 * z529)
        z566 = e2z * k56 + (s60 + (w1_pitch * z564 - z252 * z565))
        z567 = k28 * w1_pitch + k29 * w3_pitch
        s61 = k27 * z526 + (k22 * z540 - k23 * z543)
        s62 = s61 + (w3_pitch * z565 - w1_pitch * z567)
        z568 = z3 * k57 + e3z * k56 + s62
        s63 = k28 * z530 - (k22 * z536 + k25 * z529)
        z569 = e2z * k57 - (s63 + (z252 * z567 - w3_pitch * z564))
        z570 = k22 * w1_pitch - k23 * w3_pitch
        z571 = k22 * z252
        s64 = k21 * z543 - k23 * z526 - (w1_pitch * z570 + z252 * z571)
        z572 = e3z * k55 - s64
        z573 = k23 * z252
        s65 = k23 * z530 + (k21 * z536 + k22 * z529)
        z574 = e2z * k55 + (s65 + (w3_pitch * z571 + w1_pitch * z573))
        s66 = k21 * z540 + k22 * z526 - (z252 * z573 - w3_pitch * z570)
        z575 = z3 * k55 + s66
        z576 = R_yy * (z125 * z253)
        z577 = R_yy * (z81 * z253)
        z578 = R_yy * z253
        z579 = 1.0 / (z13 * z13)
        z580 = 1.0 / (z4 * z4)
        s67 = z176 * z569 - (z189 * z572 - (z187 * z575 - z178 * z574))
        z581 = z175 * z566 + (z185 * z568 + s67)
        s68 = z198 * z560 - (z192 * z562 - (z197 * z563 + z581))
        z582 = z177 * z552 - (z196 * z556 + (z194 * z557 + s68))
        s69 = z83 * z569 + (z96 * z572 - (z94 * z575 + z85 * z574))
        z583 = z82 * z566 + (z92 * z568 - s69)
        s70 = z105 * z560 + (z99 * z562 + (z104 * z563 + z583))
        z584 = z84 * z552 - (z103 * z556 + (z101 * z557 + s70))
        s71 = z261 * z578 + z584 - R_yy * (z93 * z534)
        z585 = s71 - F_yy * (z103 * z532) - roll_dot * z577
        s72 = z127 * z569 + (z140 * z572 - (z138 * z575 + z129 * z574))
        z586 = z126 * z566 - (z136 * z568 - s72)
        s73 = z149 * z560 + (z143 * z562 + (z148 * z563 - z586))
        z587 = z128 * z552 - (z147 * z556 + (z145 * z557 + s73))
        s74 = z587 - R_yy * (z137 * z534) - F_yy * (z147 * z532)
        z588 = s74 - roll_dot * z576 - z585 * z168
        s75 = z582 - R_yy * (z186 * z534) - F_yy * (z212 * z532)
        z589 = s75 + roll_dot * z444 - z585 * z217 - z222 * z588
        z590 = z443 * z589
        z591 = z221 * z588 - z222 * z590
        z592 = z585 * z167 - z168 * z591 - z217 * z590
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
            z593 = row_1 - z168 * row_0
            z594 = z443 * (row_2 + z217 * row_0 + z222 * z593)
            z595 = z221 * z593 + z222 * z594
            z596 = z167 * row_0 - z168 * z595 + z217 * z594
            z597 = z185 * z594 - z136 * z595 - z92 * z596
            z598 = z189 * z594 - z140 * z595 - z96 * z596
            z599 = z187 * z594 - z138 * z595 - z94 * z596
            z600 = z177 * z594 - z128 * z595 - z84 * z596
            z601 = z194 * z594 - z145 * z595 - z101 * z596
            z602 = z192 * z594 + z143 * z595 + z99 * z596
            z603 = k36 * z600 + k33 * z601 - k31 * z602
            z604 = z196 * z594 - z147 * z595 - z103 * z596
            z605 = z197 * z594 - z148 * z595 - z104 * z596
            z606 = k33 * z604 + k31 * z605
            z607 = s_steer * z603 + c_steer * z606
            z608 = z198 * z594 - z149 * z595 - z105 * z596
            z609 = k36 * z604 - k31 * z608
            z610 = s_lam * z607 + c_lam * z609
            z611 = c_lam * z607 - s_lam * z609
            z612 = F_yy * z594
            z613 = F_yy * z595
            z614 = F_yy * z596
            s76 = z212 * z612 - z147 * z613 - z103 * z614 + k47 * z604
            z615 = s76 - k36 * z608 + k33 * z605
            s77 = k27 * z597 - k23 * z598 + k22 * z599 + k10 * z610
            z616 = s77 - k9 * z611 + c_steer * z615
            z617 = k50 * z600 - k43 * z601 + k33 * z602
            z618 = R_yy * z594
            z619 = R_yy * z595
            z620 = R_yy * z596
            z621 = k23 * z597 - k21 * z598 + z610
            z622 = k22 * z597 + k21 * z599 + z611
            s78 = z186 * z618 - z137 * z619 - z93 * z620 - z20 * z621
            z623 = s78 + R3 * z622
            z624 = z616 - s_steer * z617 - z623
            z625 = z64 * z623
            z626 = z64 * z624
            z627 = z175 * z594 + z126 * z595 - z82 * z596
            z628 = z176 * z594 + z127 * z595 + z83 * z596
            z629 = z178 * z594 + z129 * z595 + z85 * z596
            z630 = c_steer * z603 - s_steer * z606
            z631 = s_steer * z615 + c_steer * z617
            z632 = k51 * z600 - k44 * z601 - k36 * z602
            s79 = k29 * z627 - k28 * z628 - k23 * z629 + k10 * z630
            z633 = s79 - s_lam * z631 + c_lam * z632
            z634 = k23 * z627 + k22 * z628 - k21 * z629 + z630
            z635 = z633 + z20 * z634
            s80 = k28 * z627 - k25 * z628 + k22 * z629 + k9 * z630
            z636 = s80 + c_lam * z631 + s_lam * z632
            z637 = z636 + R3 * z634
            z638 = c_pitch * z635 - s_pitch * z637
            z639 = c_roll * z638 - e2z * z624
            z640 = z64 * z639
            z641 = z62 * z625 + z61 * z626 - z47 * z640
            z642 = z250 * z641
            z643 = z29 * z625 + z27 * z626
            z644 = z30 * z625 + z27 * z640
            z645 = z30 * z626 - z29 * z640
            z646 = z60 * z643 + z46 * z644 + z34 * z645
            z647 = z250 * z646
            z648 = z55 * z643 - z43 * z644 - z38 * z645
            z649 = z250 * z648
            z650 = z248 * z646 + e2z * z647
            z651 = c_roll * z647
            z652 = s_pitch * z651
            z653 = c_pitch * z651
            z654 = c_lam * z652 + s_lam * z653
            z655 = s_steer * z650 - c_steer * z654
            z656 = c_lam * z653 - s_lam * z652
            z657 = z248 * z648 + e2z * z649
            z658 = c_roll * z649
            z659 = s_pitch * z658
            z660 = c_pitch * z658
            z661 = c_lam * z659 + s_lam * z660
            s81 = z237 * z648 + z230 * z646 - c_lam * z655 - s_lam * z656
            z662 = s81 - c_steer * z657 - s_steer * z661
            z663 = z248 * z641 + e2z * z642
            z664 = c_roll * z642
            z665 = s_pitch * z664
            z666 = c_pitch * z664
            z667 = c_lam * z665 + s_lam * z666
            s82 = z231 * z646 - z237 * z641 + c_steer * z663 + s_steer * z667
            z668 = s82 - c_lam * z656 + s_lam * z655
            z669 = z39 * z662 - z11 * z668
            z670 = z276 * z669
            z671 = z14 * z670
            z672 = z12 * z671 - r_F * (z14 * z662)
            z673 = z10 * z671 + r_F * (z14 * z668)
            z674 = s_lam * z672 - c_lam * z673
            s83 = z250 * z624 + z29 * z642 - z43 * z647 - z46 * z649
            z675 = s83 - s_steer * z674
            z676 = w1_pitch * z634
            z677 = c_lam * z648 + s_lam * z641
            z678 = c_steer * z646 - s_steer * z677
            z679 = z245 * z641 - z663
            z680 = z245 * z648 - z657
            s84 = z676 + z253 * z622 + z224 * z678 - z26 * z679 - z1 * z665
            z681 = s84 + c_steer * z652 + z33 * z680
            z682 = z245 * z646 - z650
            z683 = z682 - z659
            z684 = z681 + z35 * z683
            z685 = w3_pitch * z634
            z686 = z666 - z682
            s85 = z685 - z253 * z621 + z225 * z678 - z25 * z679 + z1 * z686
            z687 = s85 - c_steer * z653 + z32 * z680
            z688 = z687 + z35 * z660
            z689 = z2 * z684 + z19 * z688
            z690 = z267 * z689
            z691 = z5 * z690
            z692 = c_steer * z674
            z693 = c_lam * z672 + s_lam * z673
            z694 = e3z * z691 - r_R * (z5 * z684) - s_lam * z692 - c_lam * z693
            z695 = z3 * z691 - r_R * (z5 * z688) - c_lam * z692 + s_lam * z693
            s86 = z525 * z638 + z517 * z642 - z491 * z647 + z505 * z649
            z696 = s86 - z449 * z694 + z447 * z695
            z697 = w1_pitch * z597 + z252 * z628
            z698 = z252 * z627 - w3_pitch * z597
            s87 = z571 * z629 - z570 * z599 - z565 * z597 - z564 * z628
            z699 = s87 + k29 * z697 + k28 * z698
            z700 = w1_pitch * z598 - w3_pitch * z599
            s88 = z699 - k23 * z700 + z537 * z630 + z541 * z611 - a1 * z634
            z701 = s88 + v2_x * z622 - z478 * z634
            z702 = w1_pitch * z610 + w3_pitch * z611
            z703 = z548 * z600 - w3_steer * z601
            s89 = z559 * z608 + z561 * z605 - z551 * z600 - z555 * z601
            z704 = s89 + k47 * z703 - k36 * (z548 * z602 - z549 * z605)
            z705 = F_yy * z703
            z706 = z704 + k33 * (z549 * z608 + w3_steer * z602) + z705
            z707 = z548 * z604 - z549 * z601
            z708 = z549 * z600 - w3_steer * z604
            s90 = z558 * z608 - z561 * z602 - z550 * z600 + z555 * z604
            z709 = s90 + k50 * z707 - k43 * z708
            z710 = z548 * z608 + w3_steer * z605
            z711 = z709 + k33 * z710
            z712 = z453 * z615 - z445 * z617 + s_steer * z706 - c_steer * z711
            s91 = z559 * z602 + z558 * z605 + z551 * z604 + z550 * z601
            z713 = s91 - k51 * z707 + k44 * z708
            z714 = z713 + k36 * z710
            z715 = w1_pitch * z621 + w3_pitch * z622
            z716 = z701 + k10 * z702 - s_lam * z712 + c_lam * z714 + z20 * z715
            s92 = z570 * z598 + z573 * z629 - z564 * z627 + z567 * z597
            z717 = s92 + k28 * z697 + k25 * z698
            s93 = z717 + k22 * z700 + z541 * z610 - z538 * z630 + v2_x * z621
            z718 = s93 + a3 * z634 - z476 * z634
            z719 = z718 + k9 * z702 + c_lam * z712 + s_lam * z714 + R3 * z715
            s94 = z578 * z596 + z449 * z635 + z447 * z637 + c_pitch * z716
            z720 = s94 - s_pitch * z719
            z721 = R_yy * (roll_dot * z594)
            z722 = z590 * z594
            z723 = z175 * z722
            z724 = z176 * z722
            z725 = z178 * z722
            z726 = z591 * z594 - z590 * z595
            s95 = z566 * z594 + z204 * z722 + k29 * z723 - k28 * z724
            z727 = s95 - k23 * z725 - z155 * z726
            z728 = z592 * z594 - z590 * z596
            z729 = z177 * z722
            z730 = z194 * z722
            z731 = z192 * z722
            s96 = z552 * z594 - z195 * z722 - k51 * z729 + k44 * z730
            z732 = s96 + k36 * z731 - z146 * z726
            z733 = z732 - z102 * z728
            z734 = F_yy * z726
            z735 = F_yy * z728
            z736 = z196 * z722
            z737 = z198 * z722
            z738 = z197 * z722
            s97 = z556 * z594 + z199 * z722 + k47 * z736 - k36 * z737
            z739 = s97 + k33 * z738 + z150 * z726
            s98 = z532 * z612 + 2.0 * (z212 * (F_yy * z722)) + z147 * z734
            z740 = s98 + z103 * z735 + (z739 + z106 * z728)
            s99 = z557 * z594 - z200 * z722 - k50 * z729 + k43 * z730
            z741 = s99 - k33 * z731 - z151 * z726
            z742 = z741 - z107 * z728
            z743 = s_steer * z740 - c_steer * z742
            s100 = z562 * z594 + z202 * z722 + k36 * z729 + k33 * z730
            z744 = s100 - k31 * z731 + z153 * z726
            z745 = z744 + z109 * z728
            s101 = z563 * z594 + z203 * z722 + k33 * z736 + k31 * z738
            z746 = s101 + z154 * z726 + z110 * z728
            z747 = c_steer * z745 - s_steer * z746
            s102 = z574 * z594 + z209 * z722 + k23 * z723 + k22 * z724
            z748 = s102 - k21 * z725 - z160 * z726
            z749 = z748 + z116 * z728 + z747
            s103 = z727 + z111 * z728 - c_lam * z733 - s_lam * z743
            z750 = s103 + k10 * z747 + z20 * z749
            s104 = z569 * z594 - z206 * z722 - k28 * z723 + k25 * z724
            z751 = s104 - k22 * z725 + z157 * z726
            s105 = z751 - z113 * z728 + s_lam * z733 - c_lam * z743 - k9 * z747
            z752 = s105 - R3 * z749
            z753 = z253 * z721 - c_pitch * z750 - s_pitch * z752
            z754 = R_yy * (roll_dot * z595)
            z755 = z591 * z595
            z756 = z175 * z726 + z126 * z755
            z757 = z176 * z726 + z127 * z755
            z758 = z178 * z726 + z129 * z755
            z759 = z592 * z595 + z591 * z596
            s106 = z566 * z595 - z155 * z755 - k29 * z756 + k28 * z757
            z760 = s106 + k23 * z758 + z111 * z759
            z761 = z177 * z726 - z128 * z755
            z762 = z194 * z726 - z145 * z755
            z763 = z192 * z726 + z143 * z755
            s107 = z552 * z595 - z146 * z755 + k51 * z761 - k44 * z762
            z764 = s107 - k36 * z763 - z102 * z759
            s108 = z532 * z613 + z556 * z595 - z212 * z734
            z765 = s108 + 2.0 * (z147 * (F_yy * z755)) + z150 * z755
            z766 = z196 * z726 - z147 * z755
            z767 = z198 * z726 - z149 * z755
            z768 = z197 * z726 - z148 * z755
            z769 = F_yy * z759
            s109 = z765 - k47 * z766 + k36 * z767 - k33 * z768 + z103 * z769
            z770 = s109 + z106 * z759
            s110 = z557 * z595 - z151 * z755 + k50 * z761 - k43 * z762
            z771 = s110 + k33 * z763 - z107 * z759
            z772 = s_steer * z770 - c_steer * z771
            s111 = z562 * z595 + z153 * z755 - k36 * z761 - k33 * z762
            z773 = s111 + k31 * z763 + z109 * z759
            s112 = z563 * z595 + z154 * z755 - k33 * z766 - k31 * z768
            z774 = s112 + z110 * z759
            z775 = c_steer * z773 - s_steer * z774
            s113 = z574 * z595 - z160 * z755 - k23 * z756 - k22 * z757
            z776 = s113 + k21 * z758 + z116 * z759
            z777 = z776 + z775
            z778 = z760 - c_lam * z764 - s_lam * z772 + k10 * z775 + z20 * z777
            s114 = z569 * z595 + z157 * z755 + k28 * z756 - k25 * z757
            z779 = s114 + k22 * z758 - z113 * z759
            z780 = z779 + s_lam * z764 - c_lam * z772 - k9 * z775 - R3 * z777
            z781 = z253 * z754 - c_pitch * z778 - s_pitch * z780
            z782 = R_yy * (roll_dot * z596)
            z783 = z592 * z596
            z784 = z175 * z728 + z126 * z759 - z82 * z783
            z785 = z176 * z728 + z127 * z759 + z83 * z783
            z786 = z178 * z728 + z129 * z759 + z85 * z783
            z787 = z177 * z728 - z128 * z759 - z84 * z783
            z788 = z194 * z728 - z145 * z759 - z101 * z783
            z789 = z192 * z728 + z143 * z759 + z99 * z783
            s115 = z552 * z596 - z102 * z783 + k51 * z787 - k44 * z788
            z790 = s115 - k36 * z789
            s116 = z566 * z596 + z111 * z783 - k29 * z784 + k28 * z785
            z791 = s116 + k23 * z786 - c_lam * z790
            s117 = z532 * z614 + z556 * z596 - z212 * z735 + z147 * z769
            z792 = s117 + 2.0 * (z103 * (F_yy * z783))
            z793 = z196 * z728 - z147 * z759 - z103 * z783
            z794 = z198 * z728 - z149 * z759 - z105 * z783
            z795 = z197 * z728 - z148 * z759 - z104 * z783
            z796 = z792 + z106 * z783 - k47 * z793 + k36 * z794 - k33 * z795
            s118 = z557 * z596 - z107 * z783 + k50 * z787 - k43 * z788
            z797 = s118 + k33 * z789
            z798 = s_steer * z796 - c_steer * z797
            s119 = z562 * z596 + z109 * z783 - k36 * z787 - k33 * z788
            z799 = s119 + k31 * z789
            z800 = z563 * z596 + z110 * z783 - k33 * z793 - k31 * z795
            z801 = c_steer * z799 - s_steer * z800
            s120 = z574 * z596 + z116 * z783 - k23 * z784 - k22 * z785
            z802 = s120 + k21 * z786 + z801
            z803 = z791 - s_lam * z798 + k10 * z801 + z20 * z802
            s121 = z569 * z596 - z113 * z783 + k28 * z784 - k25 * z785
            z804 = s121 + k22 * z786 + s_lam * z790
            z805 = z804 - c_lam * z798 - k9 * z801 - R3 * z802
            z806 = z253 * z782 - c_pitch * z803 - s_pitch * z805
            s122 = z174 * z721 + z125 * z754 + z81 * z782
            z807 = s122 - R_yy * (z261 * z596) + z478 * z621 - z476 * z622
            z808 = z676 - z252 * z622
            z809 = z252 * z621 + z685
            z810 = z807 + z20 * z808 - R3 * z809
            z811 = z501 * z648 + z485 * z646 + z513 * z641 + z810
            z812 = z64 * z811
            z813 = z15 * z646
            z814 = z40 * z646
            z815 = c_lam * z813 - s_lam * z814 - k3 * z646
            z816 = s_lam * z813 + c_lam * z814 - k12 * z646
            s123 = z40 * z648 + z15 * z641 + k3 * (s_lam * z648 - c_lam * z641)
            z817 = s123 - k12 * z677
            z818 = c_steer * z816 - s_steer * z817
            z819 = z635 - c_lam * z815 + z20 * z678 + k10 * z678 - s_lam * z818
            s124 = z261 * z637 - z18 * z664 + z52 * z651 - z57 * z658
            z820 = s124 + roll_dot * z819 - c_roll * z695
            z821 = z637 - s_lam * z815 + R3 * z678 + k9 * z678 + c_lam * z818
            s125 = z261 * z635 - z22 * z664 + z53 * z651 - z58 * z658
            z822 = s125 - roll_dot * z821 + c_roll * z694
            s126 = z571 * z598 + z573 * z599 + z565 * z627 + z567 * z628
            z823 = s126 - k27 * (w1_pitch * z627 + w3_pitch * z628)
            s127 = z823 + k23 * (w1_pitch * z629 + z252 * z599)
            z824 = s127 + k22 * (z252 * z598 + w3_pitch * z629) + z537 * z610
            s128 = z824 + z538 * z611 - a1 * z621 - a3 * z622 - z445 * z615
            z825 = s128 - z453 * z617 - k10 * (w1_pitch * z630 - z252 * z611)
            s129 = z825 + k9 * (z252 * z610 + w3_pitch * z630) + c_steer * z706
            z826 = s129 + s_steer * z711 - z810
            s130 = z506 * z648 + z492 * z646 + z518 * z641 + c_pitch * z820
            z827 = s130 + s_pitch * z822 - z826
            z828 = z64 * z827
            z829 = R_yy * z726
            z830 = R_yy * z728
            z831 = z185 * z722
            z832 = z189 * z722
            s131 = z572 * z594 - z207 * z722 + k23 * z831 - k21 * z832
            z833 = s131 - z158 * z726 - z114 * z728
            s132 = z560 * z594 + z201 * z722 - k36 * z736 + k31 * z737
            z834 = s132 + z152 * z726 + z108 * z728
            z835 = s_steer * z745 + c_steer * z746
            z836 = c_lam * z834 - s_lam * z835
            z837 = z833 - z836
            s133 = z534 * z618 + 2.0 * (z186 * (R_yy * z722)) + z137 * z829
            z838 = s133 + z93 * z830 - z20 * z837
            z839 = z187 * z722
            s134 = z575 * z594 + z208 * z722 + k22 * z831 + k21 * z839
            z840 = s134 + z159 * z726 + z115 * z728
            z841 = s_lam * z834 + c_lam * z835
            z842 = z840 + z841
            z843 = z838 + R3 * z842
            z844 = z64 * z843
            s135 = z568 * z594 + z205 * z722 + k27 * z831 - k23 * z832
            z845 = s135 + k22 * z839 + z156 * z726
            s136 = z845 + z112 * z728 + c_steer * z740 + s_steer * z742
            z846 = s136 - k10 * z836 - k9 * z841 - z843
            z847 = z64 * z846
            s137 = z523 * z625 + z509 * z626 - z241 * z812 + z246 * z828
            z848 = s137 + z171 * z844 + z170 * z847
            z849 = R_yy * z759
            z850 = z185 * z726 - z136 * z755
            z851 = z189 * z726 - z140 * z755
            s138 = z560 * z595 + z152 * z755 + k36 * z766 - k31 * z767
            z852 = s138 + z108 * z759
            z853 = s_steer * z773 + c_steer * z774
            z854 = c_lam * z852 - s_lam * z853
            s139 = z572 * z595 - z158 * z755 - k23 * z850 + k21 * z851
            z855 = s139 - z114 * z759 - z854
            s140 = z534 * z619 - z186 * z829 + 2.0 * (z137 * (R_yy * z755))
            z856 = s140 + z93 * z849 - z20 * z855
            z857 = z187 * z726 - z138 * z755
            z858 = s_lam * z852 + c_lam * z853
            s141 = z575 * z595 + z159 * z755 - k22 * z850 - k21 * z857
            z859 = s141 + z115 * z759 + z858
            z860 = z856 + R3 * z859
            z861 = z64 * z860
            s142 = z568 * z595 + z156 * z755 - k27 * z850 + k23 * z851
            z862 = s142 - k22 * z857 + z112 * z759
            s143 = z862 + c_steer * z770 + s_steer * z771 - k10 * z854
            z863 = s143 - k9 * z858 - z860
            z864 = z64 * z863
            z865 = z185 * z728 - z136 * z759 - z92 * z783
            z866 = z189 * z728 - z140 * z759 - z96 * z783
            z867 = z560 * z596 + z108 * z783 + k36 * z793 - k31 * z794
            z868 = s_steer * z799 + c_steer * z800
            z869 = c_lam * z867 - s_lam * z868
            z870 = z572 * z596 - z114 * z783 - k23 * z865 + k21 * z866 - z869
            s144 = z534 * z620 - z186 * z830 + z137 * z849
            z871 = s144 + 2.0 * (z93 * (R_yy * z783)) - z20 * z870
            z872 = z187 * z728 - z138 * z759 - z94 * z783
            z873 = s_lam * z867 + c_lam * z868
            z874 = z575 * z596 + z115 * z783 - k22 * z865 - k21 * z872 + z873
            z875 = z871 + R3 * z874
            z876 = z64 * z875
            s145 = z568 * z596 + z112 * z783 - k27 * z865 + k23 * z866
            z877 = s145 - k22 * z872 + c_steer * z796
            z878 = z877 + s_steer * z797 - k10 * z869 - k9 * z873 - z875
            z879 = z64 * z878
            s146 = z446 * z638 + z452 * z624 + z507 * z648 - z493 * z646
            z880 = s146 + z519 * z641 - c_roll * z720
            z881 = z880 + e2z * z826
            s147 = z533 * z623 + z522 * z624 - z524 * z639 - z244 * z811
            z882 = s147 + z247 * z827 - z249 * z881
            z883 = c_roll * z753 + e2z * z846
            z884 = c_roll * z781 + e2z * z863
            s148 = z882 + z181 * z843 + z183 * z846 - z172 * z883 - z132 * z860
            z885 = s148 - z134 * z863 - z123 * z884
            z886 = c_roll * z806 + e2z * z878
            z887 = z271 * (z885 - z88 * z875 - z90 * z878 - z79 * z886)
            s149 = z848 - z122 * z861 - z121 * z864 - z78 * z876 - z77 * z879
            z888 = s149 - z47 * z887
            z889 = z29 * z812 - z27 * z828
            z890 = z29 * z844 + z27 * z847
            z891 = z29 * z876 + z27 * z879
            s150 = z520 * z625 - z243 * z812 - z15 * z844 - z70 * z876
            z892 = s150 - z27 * z887
            s151 = z520 * z626 + z243 * z828 - z15 * z847 - z70 * z879
            z893 = s151 + z29 * z887
            s152 = z508 * z643 - z240 * z889 - z40 * z890 - z76 * z891
            z894 = s152 + z46 * z892 + z34 * z893
            s153 = z696 - z250 * z720 + z173 * z753 + z124 * z781 + z80 * z806
            z895 = s153 - z23 * z888 - z54 * z894
            z896 = z29 * z861 + z27 * z864
            s154 = z494 * z643 - z235 * z889 - z120 * z896 - z75 * z891
            z897 = s154 + z43 * z892 + z38 * z893
            s155 = z529 * z634 - z534 * z622 + z463 * z678 + w1_pitch * z715
            z898 = s155 - z253 * z809 - z512 * z679
            z899 = z64 * z881
            z900 = z30 * z812 - z27 * z899
            z901 = z30 * z828 - z29 * z899
            z902 = z60 * z889 + z46 * z900 - z34 * z901
            z903 = z55 * z889 - z43 * z900 + z38 * z901
            z904 = z62 * z812 - z61 * z828 + z47 * z899
            z905 = c_lam * z903 + s_lam * z904
            z906 = z445 * z646 + z453 * z677 - c_steer * z902 + s_steer * z905
            s156 = z898 - z500 * z680 + z481 * z682 - z224 * z906 + z176 * z749
            z907 = s156 - z186 * z842 + z127 * z777
            z908 = z64 * z886
            z909 = z30 * z876 - z27 * z908
            z910 = z30 * z879 + z29 * z908
            z911 = z60 * z891 + z46 * z909 + z34 * z910
            z912 = z55 * z891 - z43 * z909 - z38 * z910
            z913 = z62 * z876 + z61 * z879 + z47 * z908
            z914 = c_lam * z912 + s_lam * z913
            z915 = c_steer * z911 - s_steer * z914
            z916 = z64 * z883
            s157 = z521 * z626 + z523 * z640 + z242 * z828 + z241 * z899
            z917 = s157 - z180 * z847 - z171 * z916
            z918 = z64 * z884
            s158 = z521 * z625 - z509 * z640 - z452 * z642 - z242 * z812
            z919 = s158 - z246 * z899 - z180 * z844
            s159 = z919 + z170 * z916 - z131 * z861 - z121 * z918 - z87 * z876
            z920 = s159 - z77 * z908 + z61 * z887
            z921 = z920 - e2z * z888
            s160 = z917 - z131 * z864 + z122 * z918 - z87 * z879 + z78 * z908
            z922 = s160 - z62 * z887 + z921
            z923 = z30 * z864 + z29 * z918
            s161 = z520 * z640 + z243 * z899 + z15 * z916 + z70 * z908
            z924 = s161 + z30 * z887
            s162 = z494 * z645 + z235 * z901 - z120 * z923 - z75 * z910
            z925 = s162 + z55 * z893 - z43 * z924
            z926 = z30 * z861 - z27 * z918
            s163 = z494 * z644 + z452 * z649 - z235 * z900 - z120 * z926
            z927 = s163 - z75 * z909 + z55 * z892
            z928 = z927 + z38 * z924 + e2z * z897
            z929 = z925 + z928
            s164 = z907 + z137 * z859 + z83 * z802 + z93 * z874
            z930 = s164 + c_pitch * z915 - z26 * z922 - z33 * z929
            z931 = z446 * z642 - c_roll * z888
            z932 = z447 * z664 + s_pitch * z931
            z933 = z446 * z647 + c_roll * z894
            z934 = z447 * z651 + s_pitch * z933
            z935 = z446 * z649 - c_roll * z897
            z936 = z447 * z658 + s_pitch * z935
            s165 = z483 * z665 + z445 * z652 + z481 * z659 - z1 * z932
            z937 = s165 + c_steer * z934 - z35 * z936
            z938 = z30 * z847 + z29 * z916
            s166 = z508 * z645 + z240 * z901 - z40 * z938 - z76 * z910
            z939 = s166 - z60 * z893 - z46 * z924
            z940 = z30 * z844 - z27 * z916
            s167 = z508 * z644 - z452 * z647 - z240 * z900 - z40 * z940
            z941 = s167 - z76 * z909 - z60 * z892
            z942 = z941 + z34 * z924 + e2z * z894
            z943 = z939 + z942
            z944 = z930 - z937 + z35 * z943
            s168 = z530 * z634 - z534 * z621 + z464 * z678 - w3_pitch * z715
            z945 = s168 - z253 * z808 - z511 * z679
            s169 = z945 + z483 * z682 - z499 * z680 + z225 * z906 + z175 * z749
            z946 = s169 - z186 * z837 + z126 * z777
            s170 = z946 + z137 * z855 - z82 * z802 + z93 * z870
            z947 = s170 - s_pitch * z915 + z25 * z922 + z1 * z943
            z948 = z449 * z664 - c_pitch * z931
            z949 = z449 * z651 - c_pitch * z933
            z950 = z449 * z658 - c_pitch * z935
            s171 = z483 * z666 + z445 * z653 + z481 * z660 + z1 * z948
            z951 = s171 - c_steer * z949 + z35 * z950
            z952 = z947 + z32 * z929 - z951
            s172 = z472 * z684 + z477 * z688 - z473 * z690 - z2 * z944
            z953 = z5 * (z267 * (s172 + z19 * z952))
            z954 = z474 * z689 * z580 - 0.5 * z953
            s173 = z450 * z691 - k56 * z597 + k55 * z598 - 2.0 * (e3z * z954)
            z955 = s173 + r_R * (z475 * z684 + z5 * z944)
            z956 = k64 * z600 - k63 * z601 + k60 * z602
            s174 = z495 * z648 + z468 * z646 + z237 * z903 + z230 * z902
            z957 = s174 + z55 * z890 - z43 * z940
            z958 = c_lam * z934 - s_lam * z949
            z959 = z453 * z650 + z445 * z654 - s_steer * z942 + c_steer * z958
            s175 = z60 * z896 + z46 * z926 + z34 * z923
            z960 = s175 - (c_lam * z949 + s_lam * z934)
            z961 = c_lam * z936 - s_lam * z950
            s176 = z957 - z38 * z938 + z66 * z912 + z73 * z911 - c_lam * z959
            s177 = z445 * z657 - z453 * z661 - c_steer * z928 + s_steer * z961
            z962 = s176 + s_lam * z960 + s177
            s178 = z471 * z646 + z495 * z641 - z231 * z902 + z237 * z904
            z963 = s178 + z62 * z844 + z61 * z847
            z964 = c_lam * z932 - s_lam * z948
            s179 = z445 * z663 - z453 * z667 + c_steer * z921 + s_steer * z964
            z965 = z963 + z47 * z916 - z74 * z911 + z66 * z913 + s179
            z966 = z965 - c_lam * z960 - s_lam * z959
            s180 = z457 * z662 - z469 * z668 - z459 * z670 - z39 * z962
            z967 = z14 * (z276 * (s180 - z11 * z966))
            z968 = z460 * z669 * z579 - 0.5 * z967
            s181 = z456 * z671 - 2.0 * (z12 * z968)
            z969 = s181 + r_F * (z461 * z662 + z14 * z962)
            s182 = z458 * z671 - 2.0 * (z10 * z968)
            z970 = s182 - r_F * (z461 * z668 - z14 * z966)
            s183 = k62 * z604 + k60 * z605 + k59 * z604 + s_lam * z969
            z971 = s183 - c_lam * z970
            z972 = z445 * z674 - s_steer * z956 + c_steer * z971
            s184 = k61 * z604 - k60 * z608 - k58 * z604 + c_lam * z969
            z973 = s184 + s_lam * z970
            z974 = z955 - s_lam * z972 - c_lam * z973
            s185 = z448 * z691 - k57 * z597 - k55 * z599 - 2.0 * (z3 * z954)
            z975 = s185 + r_R * (z475 * z688 - z5 * z952)
            z976 = z975 - c_lam * z972 + s_lam * z973
            s186 = z250 * z638 + z23 * z642 - z54 * z647 + z59 * z649
            z977 = s186 + c_pitch * z694 + s_pitch * z695
            s187 = z525 * z624 + z518 * z642 + z492 * z647 + z506 * z649
            z978 = s187 - z250 * z826 + k56 * z627
            s188 = z978 + k57 * z628 - k55 * z629 - z173 * z846 - z124 * z863
            z979 = s188 - z80 * z878 - z29 * z888
            s189 = z453 * z674 + (z979 - z43 * z894 + z46 * z897)
            z980 = c_steer * z956 + (roll_dot * z977 - s189) + s_steer * z971
            s190 = roll_dot * z675 + (z895 - z59 * z897) + c_pitch * z974
            z981 = e2z * (s190 + s_pitch * z976) - c_roll * z980
            J[offset1 + 4] = -z981
            z982 = z470 * z646 - z15 * z902
            z983 = z462 * z646 - z40 * z902
            z984 = c_lam * z982 - s_lam * z983 + k3 * z902
            z985 = s_lam * z982 + c_lam * z983 + k12 * z902
            z986 = z462 * z648 + z470 * z641 - z40 * z903 - z15 * z904
            z987 = z986 - k3 * (s_lam * z903 - c_lam * z904) + k12 * z905
            z988 = z445 * z816 + z453 * z817 + c_steer * z985 - s_steer * z987
            s191 = z478 * z678 - z716 - c_lam * z984 + z20 * z906 + k10 * z906
            z989 = s191 - s_lam * z988
            s192 = z528 * z637 + z515 * z664 + z489 * z651 + z503 * z658
            z990 = s192 + z248 * z822 - z261 * z719
            z991 = z15 * z911
            z992 = z40 * z911
            z993 = c_lam * z991 - s_lam * z992 - k3 * z911
            s193 = z990 + z174 * z752 + z125 * z780 - z803 + z81 * z805
            z994 = s193 + c_lam * z993 - z20 * z915
            z995 = s_lam * z991 + c_lam * z992 - k12 * z911
            s194 = z40 * z912 + z15 * z913 + k3 * (s_lam * z912 - c_lam * z913)
            z996 = s194 - k12 * z914
            z997 = c_steer * z995 - s_steer * z996
            s195 = z994 + s_lam * z997 - z18 * z931 + z52 * z933 - z57 * z935
            z998 = z446 * z695 - (s195 - k10 * z915)
            s196 = z476 * z678 - z719 - s_lam * z984 + R3 * z906 + k9 * z906
            z999 = s196 + c_lam * z988
            s197 = z528 * z635 + z516 * z664 + z490 * z651 + z504 * z658
            z1000 = s197 - z248 * z820 - z261 * z716
            s198 = z1000 - z174 * z750 - z125 * z778 - z81 * z803 - z805
            z1001 = s198 - s_lam * z993 + R3 * z915
            s199 = z1001 + c_lam * z997 - z22 * z931 + z53 * z933 - z58 * z935
            z1002 = z446 * z694 + (s199 + k9 * z915)
            s200 = s_pitch * (roll_dot * z999 - z1002 - c_roll * z974)
            z1003 = c_pitch * (roll_dot * z989 - z998 - c_roll * z976) - s200
            J[offset1 + 5] = -z1003
            s201 = z527 * z617 + z252 * z615 + z233 * z646 - z228 * z816
            s202 = s_lam * (z20 * z679 - k10 * z663)
            s203 = s_lam * (c_lam * (R3 * z679 - k9 * z663) - s202)
            z1004 = s201 - z16 * z663 + s203
            s204 = s_lam * (z20 * z680 - k10 * z657)
            s205 = z1004 - z41 * z654 - z21 * z653 + z6 * z652 - z44 * z657
            z1005 = s205 - c_lam * (s204 - c_lam * (R3 * z680 - k9 * z657))
            z1006 = z1005 + z7 * z674
            s206 = z545 * z603 - z539 * z606 - z531 * z615 - z526 * z617
            z1007 = s206 - z527 * z706 + z479 * z677
            s207 = z1007 + z466 * z817 - z470 * z667 - z486 * z650
            z1008 = s207 - z462 * z661 - z252 * z711 - z193 * z740
            s208 = z1008 + z185 * z742 + z191 * z745 + z179 * z746
            z1009 = s208 - z144 * z770 - z136 * z771 - z142 * z773
            s209 = z1009 + z130 * z774 - z100 * z796 - z92 * z797 - z98 * z799
            z1010 = z233 * z905 + (s209 + z86 * z800)
            s210 = z228 * z987 + z1010 + z67 * z914 - z65 * z996 - z16 * z964
            z1011 = s210 + z41 * z942 - z44 * z961
            s211 = z478 * z660 + z476 * z683 - z21 * z950 - z6 * z936
            z1012 = s211 - R3 * z943 - k9 * z942
            s212 = z476 * z665 - z478 * z686 + z21 * z948 + z6 * z932
            z1013 = s212 - z20 * z943 - k10 * z942
            s213 = z452 * z674 + (z1011 + c_lam * z1012 - s_lam * z1013)
            z1014 = z7 * z956 - (steer_dot * z1006 + s213) + e2z * z971
            s214 = z527 * z615 - z252 * z617 - z233 * z677 + z228 * z817
            z1015 = s214 - z16 * z667 + z41 * z650
            s215 = c_lam * (z21 * z660 - z6 * z659 + R3 * z682 - k9 * z650)
            z1016 = z1015 - z44 * z661 + s215
            s216 = s_lam * (z21 * z666 - z6 * z665 - z20 * z682 + k10 * z650)
            z1017 = z1016 + s216 - e2z * z674
            s217 = z539 * z603 + z545 * z606 - z531 * z617 + z526 * z615
            z1018 = s217 + z527 * z711 - z479 * z646
            s218 = z1018 - z466 * z816 - z470 * z663 + z486 * z654
            z1019 = s218 - z478 * z653 + z476 * z652 - z462 * z657
            s219 = z1019 + z454 * z674 - z252 * z706 + z185 * z740
            z1020 = s219 + z193 * z742 - z179 * z745 + z191 * z746
            s220 = z1020 - z136 * z770 + z144 * z771 - z130 * z773
            z1021 = s220 - z142 * z774 - z92 * z796 + z100 * z797
            s221 = z233 * z902 - (z1021 - z86 * z799 - z98 * z800)
            z1022 = z228 * z985 + s221 + z67 * z911 - z65 * z995
            s222 = s_lam * (z478 * z679 - z20 * z922 - k10 * z921)
            z1023 = c_lam * (z476 * z679 - R3 * z922 - k9 * z921) - s222
            s223 = z1022 + z16 * z921 - s_lam * z1023 + z41 * z958 - z21 * z949
            z1024 = s223 - z6 * z934 - z44 * z928
            s224 = s_lam * (z478 * z680 + z20 * z929 + k10 * z928)
            z1025 = s224 - c_lam * (z476 * z680 + R3 * z929 + k9 * z928)
            s225 = e2z * z956 + (steer_dot * z1017 + (z1024 + c_lam * z1025))
            z1026 = c_steer * z1014 - s_steer * (s225 - z7 * z971)
            J[offset1 + 6] = z1026
            s226 = z444 * z594 + z576 * z595 + z577 * z596 - z447 * z819
            z1027 = s226 + z449 * z821 + e2z * z977
            s227 = z1027 + c_roll * z675 - s_pitch * z989
            J[offset1 + 9] = s227 - c_pitch * z999
            J[offset1 + 10] = z714 + z984 + c_steer * z1017 - s_steer * z1006
            J[offset1 + 11] = -(z705 + z986)
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
        k8 = s_lam * k2 - c_lam * k7
        k9 = s_lam * s_lam
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
        z24 = c_lam * z22 + k9
        z25 = z14 * z23 + R3 * z24
        z26 = c_lam * s_steer
        z27 = R3 * z26 - z14 * z1
        z28 = r_F * z9
        z29 = z28 * z10
        z30 = k7 - c_lam * z29 - s_lam * z11
        z31 = z26 * k4 - z1 * k5 + z27 - s_steer * z30
        z32 = z29 + k8
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
