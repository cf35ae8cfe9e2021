"""bicycle, emitted by nhc 0.1.0 (nhc:5ab4979f47c645fa).

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
accelerations: 172 +-, 288 *, 3 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 185 *, 2 /, 12 calls
reactions: 432 +-, 660 *, 4 /, 12 calls
energy: 177 +-, 292 *, 3 /, 12 calls
jacobian: 3688 +-, 5104 *, 7 /, 17 calls
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
        z5 = 1.0 / math.sqrt(z2 * z2 + z4 * z4)
        z6 = r_F * z4
        z7 = z5 * z6
        z8 = k4 + z7
        z9 = s_steer * z8
        z10 = s1 * z9
        z11 = 1.0 / abs(c_roll)
        z12 = r_R * z3
        z13 = z11 * z12
        z14 = k10 + z13 + c_steer * z8
        z15 = c_roll * z10 + e2z * z14
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
        z28 = c_steer * k10 + z8
        z29 = s1 * z27 + c1 * z28
        z30 = c_roll * z29 + e2z * z23
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z24
        z35 = z18 * z30 + z34 * z25
        z36 = z24 * z30 + z34 * z23
        z37 = z15 * z26 - z14 * z35 + z13 * z36
        z38 = k17 * (9.0 + abs(z11))
        s2 = (z38 + k24) * (z38 + k25)
        # the coframe is singular
        if not abs(z37) > 1e-12 * (k22 * s2):
            raise SingularModelError(1, "rhs")
        z39 = r_R * c_roll
        z40 = z39 * z11
        z41 = 1.0 / z37
        z42 = s_steer * c1
        z43 = z8 * z42
        z44 = k10 * s1 + z40
        z45 = s_steer * z44 - z21 * z42
        z46 = s1 * z8 + (c_steer * z44 - c1 * z27)
        z47 = z25 * z45 + z18 * z46
        z48 = z23 * z45 + z24 * z46
        z49 = z41 * (z26 * z43 + z14 * z47 - z13 * z48)
        z50 = c_roll * z49
        z51 = s1 + c1 * z50
        z52 = c1 - s1 * z50
        z53 = z30 * z45 - z34 * z46
        z54 = z41 * (z35 * z43 + z15 * z47 - z13 * z53) - e2z * z49
        z55 = c_steer * z54 + s_steer * z52
        z56 = z41 * (z36 * z43 + (z15 * z48 - z14 * z53)) - z54
        z57 = z17 * z56
        z58 = z40 + k10 * z51
        z59 = c_steer * z57 - s_steer * z58
        z60 = z13 * z56
        z61 = z60 - k10 * z54
        z62 = k59 * z55 + (k45 * z59 - k48 * z61)
        z63 = z62 + F_yy * z55
        z64 = k41 * z51 + (z40 * k28 - k40 * z52)
        z65 = c_steer * z58 + s_steer * z57
        z66 = s_steer * z54 - c_steer * z52
        z67 = k63 * z51 + (k48 * z65 + k62 * z66)
        z68 = z64 + z67
        z69 = k56 * z51 + (k45 * z65 + k55 * z66)
        z70 = k43 * z61 - k48 * z55
        z71 = k48 * z51 + (k43 * z65 + k45 * z66)
        z72 = k43 * z59 + k45 * z55
        z73 = k37 * z54 + (k27 * z57 - k28 * z60)
        z74 = k26 * z60 - k28 * z54
        z75 = k26 * z57 + k27 * z54
        z76 = k35 * z51 + (z40 * k27 - k34 * z52)
        s3 = z60 * z74 + (z57 * z75 - (z52 * z76 - R_yy * (z56 * z56)))
        z77 = z59 * z72 + (z54 * z73 + s3)
        s4 = z51 * z68 + (z66 * z69 + (z61 * z70 + (z65 * z71 + z77)))
        z78 = z40 * (k28 * z51 + (z40 * k26 - k27 * z52)) + (z55 * z63 + s4)
        # the mass matrix is singular
        if not abs(z78) > 0.0:
            raise SingularModelError(2, "rhs")
        z79 = z18 * z8
        z80 = z34 * z8
        z81 = z24 * z8
        z82 = z41 * (z14 * z79 - z13 * z81)
        z83 = z41 * (z15 * z79 + z13 * z80) - e2z * z82
        z84 = c_roll * z82
        z85 = s1 * z84
        z86 = c_steer * z83 - s_steer * z85
        z87 = z41 * (z15 * z81 + z14 * z80) - z83
        z88 = z17 * z87
        z89 = c1 * z84
        z90 = k10 * z89
        z91 = c_steer * z88 - s_steer * z90
        z92 = z13 * z87
        z93 = z92 - k10 * z83
        z94 = k59 * z86 + (k45 * z91 - k48 * z93)
        z95 = 1.0 + z89
        z96 = c_steer * z90 + s_steer * z88
        z97 = s_steer * z83 + c_steer * z85
        z98 = k63 * z95 + (k48 * z96 + k62 * z97)
        z99 = k56 * z95 + (k45 * z96 + k55 * z97)
        z100 = k43 * z93 - k48 * z86
        z101 = k48 * z95 + (k43 * z96 + k45 * z97)
        z102 = k43 * z91 + k45 * z86
        z103 = k40 * z85 + k41 * z89
        z104 = z83 * k37 + (z88 * k27 - z92 * k28)
        z105 = k34 * z85 + k35 * z89
        z106 = z88 * k26 + z83 * k27
        z107 = z92 * k26 - z83 * k28
        s5 = z85 * z105 + (z88 * z106 + (z92 * z107 + R_yy * (z87 * z87)))
        z108 = z89 * z103 + (z83 * z104 + s5)
        s6 = z97 * z99 + (z93 * z100 + (z96 * z101 + (z91 * z102 + z108)))
        z109 = z86 * (z94 + F_yy * z86) + (z95 * z98 + s6)
        s7 = z85 * z76 + (z88 * z75 + (z92 * z74 + R_yy * (z87 * z56)))
        z110 = z89 * z64 + (z83 * z73 + s7)
        s8 = z97 * z69 + (z93 * z70 + (z96 * z71 + (z91 * z72 + z110)))
        z111 = z86 * z63 + (z95 * z67 + s8)
        z112 = 1.0 / z78
        z113 = z111 * z112
        z114 = z109 - z111 * z113
        # the mass matrix is singular
        if not abs(z114) > 1e-14 * z109:
            raise SingularModelError(2, "rhs")
        z115 = z20 * z25
        z116 = z20 * z23
        z117 = z41 * (z7 * z26 - z14 * z115 + z13 * z116)
        z118 = c_roll * z117
        z119 = c1 * z118
        z120 = k10 * z119
        z121 = z20 * z30
        z122 = z41 * (z15 * z115 - z7 * z35 - z13 * z121) + e2z * z117
        z123 = z41 * (z15 * z116 - z14 * z121 - z7 * z36) - z122
        z124 = z17 * z123
        z125 = c_steer * z120 - s_steer * z124
        z126 = s1 * z118
        z127 = s_steer * z122 - c_steer * z126
        z128 = c_steer * z122 + s_steer * z126
        z129 = c_steer * z124 + s_steer * z120
        z130 = z13 * z123
        z131 = z130 - k10 * z122
        s9 = z124 * (z124 * k26 + z122 * k27)
        s10 = s9 + z130 * (z130 * k26 - z122 * k28)
        z132 = z126 * (k34 * z126 + k35 * z119) + s10
        s11 = z122 * (z122 * k37 + (z124 * k27 - z130 * k28)) + z132
        z133 = z119 * (k40 * z126 + k41 * z119) + s11
        s12 = z125 * (k48 * z119 + (k43 * z125 - k45 * z127))
        z134 = s12 + (z129 * (k43 * z129 + k45 * z128) + z133)
        s13 = z127 * (k56 * z119 + (k45 * z125 - k55 * z127))
        z135 = s13 - (z131 * (k43 * z131 - k48 * z128) + z134)
        s14 = z128 * (k59 * z128 + (k45 * z129 - k48 * z131)) - z135
        z136 = z119 * (k63 * z119 + (k48 * z125 - k62 * z127)) + s14
        z137 = 1.0 - z128
        z138 = z136 + R_yy * (z123 * z123) + F_yy * (z137 * z137)
        z139 = R_yy * z123
        z140 = F_yy * z137
        s15 = z124 * z75 + (z130 * z74 + (z139 * z56 - z140 * z55))
        z141 = z122 * z73 - (z126 * z76 - s15)
        s16 = z127 * z69 + (z131 * z70 - (z125 * z71 - (z129 * z72 + z141)))
        z142 = z119 * z68 - (z128 * z62 + s16)
        z143 = z142 * z112
        s17 = z130 * z107 + (z87 * z139 - z86 * z140 + z111 * z143)
        z144 = z126 * z105 - (z124 * z106 + s17)
        s18 = z125 * z101 - (z129 * z102 + (z122 * z104 - z144))
        z145 = z128 * z94 + (z127 * z99 + (z131 * z100 - s18))
        z146 = z119 * (z103 + z98) - z145
        z147 = 1.0 / z114
        z148 = z146 * z147
        z149 = z138 - z142 * z143 - z146 * z148
        # the mass matrix is singular
        if not abs(z149) > 1e-14 * z138:
            raise SingularModelError(2, "rhs")
        c_yaw = math.cos(yaw)
        z150 = roll_dot * c1
        z151 = s_steer * z150
        z152 = thF_dot - z151
        z153 = k4 * z151 - z7 * z152
        z154 = roll_dot * r_R
        z155 = c_roll * z154
        z156 = z11 * z155
        z157 = roll_dot * s1
        z158 = z156 + k10 * z157
        z159 = z20 * z152 - (k16 * z151 - s_steer * z158)
        z160 = steer_dot + z157
        z161 = c_steer * z150
        z162 = z160 * z8 + (c_steer * z158 - z21 * z161)
        z163 = z23 * z159 + z24 * z162
        z164 = z30 * z159 - z34 * z162
        z165 = z41 * (z36 * z153 + (z15 * z163 - z14 * z164))
        z166 = z25 * z159 + z18 * z162
        z167 = z41 * (z35 * z153 + z15 * z166 - z13 * z164)
        z168 = z41 * (z26 * z153 + z14 * z166 - z13 * z163)
        z169 = z167 - e2z * z168
        z170 = z165 - z169
        z171 = z13 * z170
        z172 = z17 * z170
        z173 = s1 * z171 + c1 * z172
        s_yaw = math.sin(yaw)
        z174 = s1 * z172 - c1 * z171
        z175 = c_roll * z156 - e2z * z174
        z176 = c1 * z167
        z177 = roll_dot * z176
        z178 = c_roll * z168
        z179 = s1 * z167
        z180 = roll_dot * e2z
        z181 = steer_dot * c_steer
        z182 = z180 * c1 - c_roll * z179
        z183 = roll_dot * c_roll
        z184 = steer_dot * s_steer
        z185 = z180 * s1 + c_roll * z176
        z186 = s_steer * z183 + e2z * z181 + (z184 * z3 + c_steer * z185)
        z187 = (z2 * z182 - z4 * z186) * (z5 * (z5 * z5))
        z188 = r_F * z5
        z189 = z6 * z187 + z188 * z186
        z190 = z180 * z11
        z191 = z190 / c_roll
        z192 = r_R * z11
        z193 = z12 * z191 - z185 * z192
        z194 = z193 - (z184 * z8 - c_steer * z189)
        s19 = c_roll * (z9 * z176 - s1 * (z181 * z8 + s_steer * z189))
        z195 = s19 + (z180 * z10 - (z183 * z14 + e2z * z194))
        z196 = roll_dot * z179
        z197 = z181 * z150 + s_steer * z196
        s20 = z8 * z197 - (z165 * z193 + (z152 * z189 - z167 * z194))
        z198 = z168 * z195 + s20
        z199 = z19 * z187 - z188 * z182
        s21 = z27 * z176 - z28 * z179 + c1 * (z184 * k10 - z189)
        z200 = s1 * (z184 * z21 - c_steer * z199) + s21
        z201 = z16 * z191 - z182 * z192
        z202 = z201 - z199
        z203 = z181 * z22 + s_steer * z202
        z204 = k10 * z177 - (z155 * z191 - z154 * z190)
        s22 = z184 * z158 - (z160 * z189 - (c_steer * z204 + z167 * z203))
        z205 = z21 * (z184 * z150 - c_steer * z196) - (z161 * z199 + s22)
        s23 = c_roll * z200 + (z180 * z29 - (z183 * z23 + e2z * z203))
        s24 = z165 * (z181 * z17 + s_steer * z201) - (z8 * z177 - z205)
        z206 = z168 * s23 - s24
        s25 = z31 * z176 - (z32 * z179 + k10 * (z181 * c1))
        z207 = s1 * (z181 * z21 + s_steer * z199) - s25
        z208 = z184 * z22 - c_steer * z202
        s26 = z152 * z199 + (z181 * z158 - (s_steer * z204 + z167 * z208))
        z209 = z165 * (z184 * z17 - c_steer * z201) - (z21 * z197 - s26)
        s27 = c_roll * z207 - (z180 * z33 + (z183 * z24 - e2z * z208))
        z210 = z168 * s27 + z209
        z211 = z18 * z206 - z25 * z210
        z212 = z24 * z206 - z23 * z210
        z213 = z41 * (z26 * z198 - z14 * z211 + z13 * z212)
        z214 = z180 * z168 - c_roll * z213
        z215 = z177 - (z178 * z179 - c1 * z214)
        z216 = z157 + c1 * z178
        z217 = z150 - s1 * z178
        s28 = roll_dot * (z180 * z192 - z39 * z191)
        z218 = z172 * z216 - z171 * z217 + s28
        z219 = k27 * z169
        z220 = k28 * z169
        z221 = z196 + (z178 * z176 + s1 * z214)
        s29 = z216 * z219 + (e2z * k67 + z217 * z220) + k27 * z221
        z222 = k28 * z215 + (k26 * z218 + s29)
        z223 = z30 * z210 + z34 * z206
        s30 = z41 * (z15 * z211 - z35 * z198 + z13 * z223)
        z224 = s30 + (z183 * z168 + e2z * z213)
        z225 = z184 * z169 + c_steer * z224 - (z181 * z217 + s_steer * z221)
        z226 = k10 * z169
        z227 = k10 * z216
        v2_x = roll_dot * z40
        z228 = z41 * (z15 * z212 + z14 * z223 - z36 * z198) - z224
        z229 = z169 * z171 - v2_x * z216 - (z170 * z201 - z17 * z228)
        z230 = z169 * z226 + z216 * z227 - z229
        z231 = z218 + (z226 * z217 + k10 * z215)
        z232 = c_steer * z230 + s_steer * z231
        w3_steer = steer_dot + z216
        z233 = s_steer * z169 - c_steer * z217
        z234 = k55 * z233 + k56 * w3_steer
        z235 = k62 * z233 + k63 * w3_steer
        z236 = v2_x * z217 - z169 * z172 - (z170 * z193 - z13 * z228)
        z237 = z236 + (z217 * z227 - k10 * z224)
        s31 = k45 * z232 + (w3_steer * z234 - z233 * z235 + k48 * z237)
        z238 = z4 * k71 - (k59 * z225 - s31)
        z239 = z2 * k72 + z238
        z240 = F_yy * z225
        z241 = z239 - z240
        z242 = R_yy * z170 - k37 * z169
        z243 = k34 * z217 - k35 * z216
        s32 = k41 * z215 + (k28 * z218 + k40 * z221)
        z244 = e2z * k68 - (z217 * z242 + z169 * z243 - s32)
        h2z = e2z * c_steer + s_steer * z3
        z245 = c_steer * z169 + s_steer * z217
        z246 = F_yy * (thF_dot - z245) - k59 * z245
        z247 = c_steer * z231 - s_steer * z230
        z248 = z181 * z169 - s_steer * z224 + (z184 * z217 - c_steer * z221)
        s33 = k63 * z215 + (k48 * z247 - k62 * z248)
        z249 = h2z * k72 - (z233 * z246 + z245 * z234 + s33)
        z250 = z244 - z249
        s34 = k56 * z215 + (k45 * z247 - k55 * z248)
        z251 = h2z * k71 - (z245 * z235 + w3_steer * z246 - s34)
        z252 = k45 * z233 + k48 * w3_steer
        z253 = k45 * z245
        s35 = z233 * z252 + z245 * z253 - (k43 * z237 - k48 * z225)
        z254 = z2 * k70 + s35
        z255 = k48 * z245
        s36 = k48 * z215 + (k43 * z247 - k45 * z248)
        z256 = h2z * k70 + (w3_steer * z253 - z233 * z255 + s36)
        s37 = z245 * z255 + w3_steer * z252 + (k43 * z232 - k45 * z225)
        z257 = z4 * k70 + s37
        z258 = k40 * z217 - k41 * z216
        s38 = k37 * z224 + (k27 * z229 - k28 * z236)
        z259 = z3 * k69 + z2 * k68 + (z216 * z243 + z217 * z258 + s38)
        s39 = k35 * z215 + (k27 * z218 + k34 * z221)
        z260 = e2z * k69 + (z169 * z258 - z216 * z242 + s39)
        z261 = k27 * z217 - k28 * z216
        s40 = z217 * z261 + z169 * z219 - (k26 * z236 - k28 * z224)
        z262 = z2 * k67 + s40
        s41 = z169 * z220 - z216 * z261 - (k26 * z229 + k27 * z224)
        z263 = z3 * k67 - s41
        z264 = R_yy * z228
        s42 = z52 * z260 + (z60 * z262 - (z57 * z263 + z56 * z264))
        z265 = z59 * z257 - (z54 * z259 - s42)
        s43 = z51 * z250 + (z66 * z251 - (z61 * z254 - (z65 * z256 - z265)))
        z266 = z40 * z222 - (z55 * z241 - s43)
        s44 = z88 * z263 - (z92 * z262 + (z266 * z113 - z87 * z264))
        z267 = z83 * z259 + (z85 * z260 + s44)
        s45 = z93 * z254 - (z96 * z256 - (z91 * z257 - (z89 * z244 + z267)))
        z268 = z95 * z249 - (z97 * z251 - s45)
        z269 = z86 * z241 + z268
        s46 = z266 * z143 - (z148 * z269 - (z123 * z264 - z137 * z240))
        z270 = z124 * z263 - (z130 * z262 - s46)
        s47 = z129 * z257 - (z122 * z259 - (z126 * z260 - z270))
        z271 = z127 * z251 - (z131 * z254 + (z125 * z256 + s47))
        z272 = (z119 * z250 + (z128 * z239 - z271)) / z149
        z273 = z147 * z269 + z148 * z272
        dydt: list[float] = [
            # x' (I.2.15)
            -(c_yaw * z173 + s_yaw * z175),
            # y' (I.2.15)
            c_yaw * z175 - s_yaw * z173,
            # z' (I.2.15)
            e2z * z156 + c_roll * z174,
            # yaw' (I.2.15)
            z168,
            # roll' (I.2.15)
            roll_dot,
            # pitch' (I.2.15)
            -z167,
            # steer' (I.2.15)
            steer_dot,
            # thR' (I.2.15)
            z165,
            # thF' (I.2.15)
            thF_dot,
            # roll'' (I.2.15) 112:4
            z266 * z112 + z113 * z273 - z143 * z272,
            # steer'' (I.2.15) 112:4
            -z273,
            # thF'' (I.2.15) 112:4
            -z272,
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
        z8 = 1.0 / math.sqrt(z6 * z6 + z7 * z7)
        z9 = r_F * z7
        z10 = z8 * z9
        z11 = k2 + z10
        z12 = s_steer * z11
        z13 = s1 * z12
        z14 = k3 + z5 + c_steer * z11
        z15 = c_roll * z13 + e2z * z14
        z16 = r_R * z6
        z17 = z2 * z16
        z18 = c_steer * z17
        z19 = r_F * z6
        z20 = z8 * z19
        z21 = k4 + z20
        z22 = z17 - z21
        z23 = s_steer * z22
        z24 = c_steer * z22
        z25 = s_steer * z17
        z26 = z18 * z23 - z24 * z25
        z27 = c_steer * z21
        z28 = c_steer * k3 + z11
        z29 = s1 * z27 + c1 * z28
        z30 = c_roll * z29 + e2z * z23
        z31 = s_steer * z21
        z32 = s_steer * k3
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z24
        z35 = z18 * z30 + z34 * z25
        z36 = z24 * z30 + z34 * z23
        z37 = 1.0 / (z15 * z26 - z14 * z35 + z5 * z36)
        z38 = roll_dot * s1
        z39 = steer_dot + z38
        z40 = roll_dot * c1
        z41 = c_steer * z40
        z42 = roll_dot * r_R
        z43 = c_roll * z42
        z44 = z2 * z43
        z45 = z44 + k3 * z38
        z46 = z10 * z39 - z20 * z41 - (k4 * z41 - k2 * z39 - c_steer * z45)
        z47 = s_steer * z40
        z48 = thF_dot - z47
        z49 = z20 * z48 - (k4 * z47 - s_steer * z45)
        z50 = z24 * z46 + z23 * z49
        z51 = z30 * z49 - z34 * z46
        z52 = k2 * z47 - z10 * z48
        z53 = z15 * z50 - z14 * z51 + z36 * z52
        z54 = z18 * z46 + z25 * z49
        z55 = z15 * z54 + z35 * z52 - z5 * z51
        z56 = z37 * z55
        z57 = z26 * z52 + z14 * z54 - z5 * z50
        z58 = z37 * z57
        z59 = z37 * z53 - (z56 - e2z * z58)
        z60 = z5 * z59
        z61 = z17 * z59
        z62 = s1 * z60 + c1 * z61
        s_yaw = math.sin(yaw)
        z63 = s_yaw * z58
        c_yaw = math.cos(yaw)
        z64 = c1 * z56
        z65 = roll_dot * e2z
        z66 = z2 * (c_roll * z65) * (z2 * z2)
        z67 = z65 * s1 + c_roll * z64
        z68 = r_R * z2
        z69 = z4 * z66 - z67 * z68
        z70 = steer_dot * c_steer
        z71 = s1 * z56
        z72 = z65 * c1 - c_roll * z71
        z73 = roll_dot * c_roll
        z74 = steer_dot * s_steer
        z75 = s_steer * z73 + e2z * z70 + (z74 * z3 + c_steer * z67)
        z76 = (z6 * z72 - z7 * z75) * (z8 * (z8 * z8))
        z77 = r_F * z8
        z78 = z9 * z76 + z77 * z75
        z79 = z69 - (z74 * z11 - c_steer * z78)
        s2 = c_roll * (z12 * z64 - s1 * (z70 * z11 + s_steer * z78))
        z80 = z65 * z13 + s2 - (z73 * z14 + e2z * z79)
        z81 = z16 * z66 - z72 * z68
        z82 = z74 * z17 - c_steer * z81
        z83 = z19 * z76 - z77 * z72
        z84 = z81 - z83
        z85 = z70 * z22 + s_steer * z84
        z86 = z74 * z22 - c_steer * z84
        z87 = z70 * z17 + s_steer * z81
        z88 = z23 * z82 - z18 * z85 - (z25 * z86 - z24 * z87)
        s3 = z27 * z64 + s1 * (z74 * z21 - c_steer * z83)
        z89 = s3 - (z28 * z71 - c1 * (z74 * k3 - z78))
        z90 = z65 * z29 + c_roll * z89 - (z73 * z23 + e2z * z85)
        s4 = z31 * z64 - s1 * (z70 * z21 + s_steer * z83)
        z91 = s4 - (z32 * z71 + k3 * (z70 * c1))
        z92 = z65 * z33 + c_roll * z91 + (z73 * z24 - e2z * z86)
        z93 = z30 * z82 + z18 * z90 + (z25 * z92 - z34 * z87)
        z94 = z30 * z86 + z24 * z90 + (z23 * z92 - z34 * z85)
        s5 = z26 * z80 + z15 * z88 + (z35 * z79 - z14 * z93)
        z95 = s5 - (z36 * z69 - z5 * z94)
        z96 = z37 * z37 * z95
        z97 = roll_dot * z64 - s1 * roll_ddot
        z98 = steer_ddot - z97
        z99 = roll_dot * z71 + c1 * roll_ddot
        z100 = z74 * z40 - c_steer * z99
        z101 = z43 * z66 - z2 * (z65 * z42 - r_R * (c_roll * roll_ddot))
        z102 = k3 * z97 - z101
        s6 = k4 * z100 + k2 * z98 - (z74 * z45 + c_steer * z102)
        z103 = z10 * z98 + z39 * z78 + (z20 * z100 - z41 * z83) + s6
        z104 = z70 * z40 + s_steer * z99
        z105 = thF_ddot - z104
        s7 = k4 * z104 - (z70 * z45 - s_steer * z102)
        z106 = z20 * z105 + z48 * z83 - s7
        z107 = z46 * z86 - z24 * z103 - (z49 * z85 + z23 * z106)
        z108 = z49 * z90 - z30 * z106 - (z46 * z92 - z34 * z103)
        z109 = k2 * z104 - (z10 * z105 + z48 * z78)
        s8 = z50 * z80 + z15 * z107 + (z51 * z79 - z14 * z108)
        z110 = s8 + (z52 * z94 - z36 * z109)
        z111 = z53 * z96 - z37 * z110
        z112 = z46 * z82 - z18 * z103 - (z49 * z87 + z25 * z106)
        s9 = z54 * z80 + z15 * z112 + (z52 * z93 - z35 * z109)
        z113 = s9 + (z51 * z69 - z5 * z108)
        z114 = z55 * z96 - z37 * z113
        s10 = z52 * z88 - z26 * z109 - (z54 * z79 - z14 * z112)
        z115 = s10 + (z50 * z69 - z5 * z107)
        z116 = z57 * z96 - z37 * z115
        z117 = z111 - (z114 - (z73 * z58 + e2z * z116))
        z118 = z59 * z69 + z5 * z117
        z119 = z59 * z81 + z17 * z117
        z120 = z60 * z64 - s1 * z118 - (z61 * z71 + c1 * z119)
        z121 = s1 * z61 - c1 * z60
        z122 = c_roll * z44 - e2z * z121
        z123 = c_yaw * z58
        z124 = z61 * z64 - s1 * z119 + (z60 * z71 + c1 * z118)
        z125 = z65 * z44 - c_roll * z101 + (z73 * z121 - e2z * z124)
        qddot: list[float] = [
            # x'' (I.2.15)
            z62 * z63 + c_yaw * z120 - (z122 * z123 - s_yaw * z125),
            # y'' (I.2.15)
            -(z62 * z123 - s_yaw * z120 + (z122 * z63 + c_yaw * z125)),
            # z'' (I.2.15)
            z73 * z44 + e2z * z101 - (z65 * z121 + c_roll * z124),
            # yaw'' (I.2.15)
            z116,
            # roll'' (I.2.15)
            roll_ddot,
            # pitch'' (I.2.15)
            -z114,
            # steer'' (I.2.15)
            steer_ddot,
            # thR'' (I.2.15)
            z111,
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
        z8 = 1.0 / math.sqrt(z3 * z3 + z7 * z7)
        z9 = r_F * z7
        z10 = z8 * z9
        z11 = k4 + z10
        z12 = s_steer * z11
        z13 = s1 * z12
        z14 = r_R * z6
        z15 = z2 * z14
        z16 = k10 + z15 + c_steer * z11
        z17 = c_roll * z13 + e2z * z16
        z18 = c_steer * z5
        z19 = r_F * z3
        z20 = z8 * z19
        z21 = k16 + z20
        z22 = z5 - z21
        z23 = s_steer * z22
        z24 = c_steer * z22
        z25 = s_steer * z5
        z26 = z18 * z23 - z24 * z25
        z27 = c_steer * z21
        z28 = c_steer * k10 + z11
        z29 = s1 * z27 + c1 * z28
        z30 = c_roll * z29 + e2z * z23
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z24
        z35 = z18 * z30 + z34 * z25
        z36 = z24 * z30 + z34 * z23
        z37 = 1.0 / (z17 * z26 - z16 * z35 + z15 * z36)
        z38 = z20 * z23
        z39 = z20 * z30
        z40 = z20 * z25
        z41 = z37 * (z10 * z26 - z16 * z40 + z15 * z38)
        z42 = z37 * (z17 * z40 - z10 * z35 - z15 * z39) + e2z * z41
        z43 = z37 * (z17 * z38 - z16 * z39 - z10 * z36) - z42
        z44 = z5 * z43
        z45 = c_steer * c1
        z46 = r_R * c_roll
        z47 = z46 * z2
        z48 = k10 * s1 + z47
        z49 = s1 * z10 - z20 * z45 - (k16 * z45 - k4 * s1 - c_steer * z48)
        z50 = s_steer * c1
        z51 = z20 * z50 + (k16 * z50 - s_steer * z48)
        z52 = z24 * z49 - z23 * z51
        z53 = z30 * z51 + z34 * z49
        z54 = z11 * z50
        z55 = z18 * z49 - z25 * z51
        z56 = z37 * (z26 * z54 + z16 * z55 - z15 * z52)
        z57 = z37 * (z17 * z55 + z35 * z54 + z15 * z53) - e2z * z56
        z58 = z37 * (z17 * z52 + z16 * z53 + z36 * z54) - z57
        z59 = z5 * z58
        z60 = z24 * z11
        z61 = z34 * z11
        z62 = z18 * z11
        z63 = z37 * (z16 * z62 - z15 * z60)
        z64 = z37 * (z17 * z62 + z15 * z61) - e2z * z63
        z65 = z37 * (z17 * z60 + z16 * z61) - z64
        z66 = z5 * z65
        z67 = z44 * thF_ddot + (z59 * roll_ddot + z66 * steer_ddot)
        z68 = z42 * thF_ddot + (z57 * roll_ddot + z64 * steer_ddot)
        z69 = roll_dot * s1
        z70 = steer_dot + z69
        z71 = roll_dot * c1
        z72 = c_steer * z71
        z73 = roll_dot * r_R
        z74 = c_roll * z73
        z75 = z2 * z74 + k10 * z69
        z76 = z10 * z70 - z20 * z72 - (k16 * z72 - k4 * z70 - c_steer * z75)
        z77 = s_steer * z71
        z78 = thF_dot - z77
        z79 = z20 * z78 - (k16 * z77 - s_steer * z75)
        z80 = z18 * z76 + z25 * z79
        z81 = k4 * z77 - z10 * z78
        z82 = z30 * z79 - z34 * z76
        z83 = z37 * (z17 * z80 + z35 * z81 - z15 * z82)
        z84 = z24 * z76 + z23 * z79
        z85 = z37 * (z26 * z81 + z16 * z80 - z15 * z84)
        z86 = z83 - e2z * z85
        z87 = k19 * z86
        z88 = c_roll * z85
        z89 = z69 + c1 * z88
        z90 = z71 - s1 * z88
        z91 = k18 * z90 - k19 * z89
        z92 = z37 * (z17 * z84 - z16 * z82 + z36 * z81)
        z93 = z92 - z86
        z94 = z15 * z93
        v2_x = roll_dot * z47
        z95 = roll_dot * e2z
        z96 = z95 * z2
        z97 = z96 / c_roll
        z98 = s1 * z83
        z99 = z95 * c1 - c_roll * z98
        z100 = r_R * z2
        z101 = z4 * z97 - z99 * z100
        z102 = c1 * z83
        z103 = roll_dot * z102
        z104 = roll_dot * c_roll
        z105 = steer_dot * c_steer
        z106 = steer_dot * s_steer
        z107 = z95 * s1 + c_roll * z102
        z108 = s_steer * z104 + e2z * z105 + (z106 * z6 + c_steer * z107)
        z109 = (z3 * z99 - z7 * z108) * (z8 * (z8 * z8))
        z110 = r_F * z8
        z111 = z9 * z109 + z110 * z108
        z112 = roll_dot * z98
        z113 = z106 * z71 - c_steer * z112
        z114 = z19 * z109 - z110 * z99
        z115 = k10 * z103 - (z74 * z97 - z73 * z96)
        s2 = k16 * z113 - k4 * z103 - (z106 * z75 + c_steer * z115)
        z116 = z10 * z103 - z70 * z111 - (z20 * z113 - z72 * z114) - s2
        s3 = z27 * z102 + s1 * (z106 * z21 - c_steer * z114)
        z117 = s3 - (z28 * z98 - c1 * (z106 * k10 - z111))
        z118 = z114 - z101
        z119 = z105 * z22 - s_steer * z118
        s4 = z85 * (z95 * z29 + c_roll * z117 - (z104 * z23 + e2z * z119))
        z120 = z92 * (z105 * z5 + s_steer * z101) - (s4 + z83 * z119)
        z121 = z116 - z120
        z122 = z105 * z71 + s_steer * z112
        s5 = z31 * z102 - s1 * (z105 * z21 + s_steer * z114)
        z123 = s5 - (z32 * z98 + k10 * (z105 * c1))
        z124 = z106 * z22 + c_steer * z118
        s6 = z85 * (z95 * z33 + c_roll * z123 + (z104 * z24 - e2z * z124))
        z125 = z92 * (z106 * z5 - c_steer * z101) - (s6 + z83 * z124)
        s7 = k16 * z122 - (z105 * z75 - s_steer * z115)
        z126 = z20 * z122 - z78 * z114 + s7 - z125
        z127 = z24 * z121 + z23 * z126
        z128 = z30 * z126 - z34 * z121
        z129 = z14 * z97 - z107 * z100
        z130 = z106 * z11 - c_steer * z111 - z129
        s8 = c_roll * (z12 * z102 - s1 * (z105 * z11 + s_steer * z111))
        z131 = z95 * z13 + s8 - (z104 * z16 - e2z * z130)
        s9 = z92 * z129 - (z85 * z131 - z83 * z130)
        z132 = k4 * z122 + (z10 * z122 - z78 * z111) - s9
        z133 = z18 * z121 + z25 * z126
        z134 = z37 * (z26 * z132 - z16 * z133 + z15 * z127)
        s10 = z37 * (z17 * z133 - z35 * z132 - z15 * z128)
        z135 = s10 + (z104 * z85 + e2z * z134)
        z136 = z37 * (z17 * z127 - z16 * z128 - z36 * z132) - z135
        z137 = z86 * z94 - v2_x * z89 - (z93 * z101 - z5 * z136)
        s11 = z6 * k58 - (z86 * z87 - z89 * z91 - (k17 * z137 + k18 * z135))
        z138 = k17 * z67 + k18 * z68 - s11
        z139 = c_roll * z41
        z140 = c1 * z139
        z141 = z140 * thF_ddot
        z142 = c_roll * z56
        z143 = s1 + c1 * z142
        z144 = z143 * roll_ddot
        z145 = c_roll * z63
        z146 = c1 * z145
        z147 = z141 - (z144 + (1.0 + z146) * steer_ddot)
        z148 = k10 * z140
        z149 = z47 + k10 * z143
        z150 = k10 * z146
        s12 = (c_steer * z150 + s_steer * z66) * steer_ddot
        s13 = (c_steer * z149 + s_steer * z59) * roll_ddot + s12
        z151 = (c_steer * z148 - s_steer * z44) * thF_ddot - s13
        z152 = s1 * z139
        z153 = c1 - s1 * z142
        z154 = s1 * z145
        s14 = (s_steer * z64 + c_steer * z154) * steer_ddot
        s15 = (s_steer * z57 - c_steer * z153) * roll_ddot + s14
        z155 = (s_steer * z42 - c_steer * z152) * thF_ddot + s15
        h2z = e2z * c_steer + s_steer * z6
        w3_steer = steer_dot + z89
        z156 = c_steer * z86 + s_steer * z90
        z157 = k36 * z156
        z158 = s_steer * z86 - c_steer * z90
        z159 = k39 * z156
        z160 = z95 * z85 - c_roll * z134
        z161 = z103 - (z88 * z98 - c1 * z160)
        z162 = z5 * z93
        z163 = z162 * z89 - z94 * z90 + roll_dot * (z95 * z100 - z46 * z97)
        z164 = k10 * z86
        z165 = z163 + (z164 * z90 + k10 * z161)
        z166 = k10 * z89
        z167 = z86 * z164 + z89 * z166 - z137
        z168 = c_steer * z165 - s_steer * z167
        z169 = z112 + (z88 * z102 + s1 * z160)
        z170 = z105 * z86 - s_steer * z135 + (z106 * z90 - c_steer * z169)
        s16 = k39 * z161 + (k34 * z168 - k36 * z170)
        z171 = h2z * k63 + (w3_steer * z157 - z158 * z159 + s16)
        z172 = k39 * z147 + (k34 * z151 - k36 * z155) + z171
        s17 = (c_steer * z66 - s_steer * z150) * steer_ddot
        s18 = (c_steer * z59 - s_steer * z149) * roll_ddot + s17
        z173 = (c_steer * z44 + s_steer * z148) * thF_ddot + s18
        z174 = c_steer * z42 + s_steer * z152
        s19 = (c_steer * z64 - s_steer * z154) * steer_ddot
        z175 = (c_steer * z57 + s_steer * z153) * roll_ddot + s19
        z176 = z174 * thF_ddot + z175
        z177 = k36 * z158 + k39 * w3_steer
        z178 = c_steer * z167 + s_steer * z165
        z179 = z106 * z86 + c_steer * z135 - (z105 * z90 + s_steer * z169)
        s20 = z156 * z159 + w3_steer * z177 + (k34 * z178 - k36 * z179)
        z180 = k34 * z173 + k36 * z176 + (z7 * k63 + s20)
        z181 = z138 - s_steer * z172 + c_steer * z180
        z182 = z15 * z43
        z183 = z15 * z58
        z184 = z15 * z65
        z185 = z182 * thF_ddot + (z183 * roll_ddot + z184 * steer_ddot)
        z186 = k18 * z86
        z187 = v2_x * z90 - z86 * z162 - (z93 * z129 - z15 * z136)
        s21 = z90 * z91 + z86 * z186 - (k17 * z187 - k19 * z135)
        z188 = k17 * z185 - k19 * z68 + (z3 * k58 + s21)
        s22 = (z184 - k10 * z64) * steer_ddot
        s23 = (z183 - k10 * z57) * roll_ddot + s22
        z189 = (z182 - k10 * z42) * thF_ddot + s23
        z190 = z187 + (z90 * z166 - k10 * z135)
        s24 = z158 * z177 + z156 * z157 - (k34 * z190 - k39 * z179)
        z191 = k34 * z189 - k39 * z176 + (z3 * k63 + s24)
        z192 = z188 + z191
        s25 = z43 * thF_ddot + (z58 * roll_ddot + z65 * steer_ddot) - z136
        z193 = R_yy * s25 + z15 * z192 + z5 * z181
        z194 = z37 * z193
        z195 = k25 * z90 - k26 * z89
        z196 = k31 * z90 - k32 * z89
        s26 = k28 * z135 + (k18 * z137 - k19 * z187)
        z197 = z6 * k60 + z3 * k59 + (z89 * z195 + z90 * z196 + s26)
        z198 = k46 * z158 + k47 * w3_steer
        z199 = k53 * z158 + k54 * w3_steer
        s27 = k50 * z179 - (k36 * z178 + k39 * z190)
        s28 = z7 * k62 + z3 * k61 + (z7 * k65 - z3 * k64)
        z200 = s28 + (w3_steer * z198 - z158 * z199 - s27)
        s29 = F_yy * (z175 - (1.0 - z174) * thF_ddot - z179)
        z201 = k50 * z176 + (k36 * z173 - k39 * z189) + z200 + s29
        z202 = F_yy * (thF_dot - z156) - k50 * z156
        s30 = k47 * z161 + (k36 * z168 - k46 * z170)
        z203 = h2z * k66 - (z156 * z199 + w3_steer * z202 - s30)
        z204 = k47 * z147 + (k36 * z151 - k46 * z155) + z203
        s31 = k28 * z68 + (k18 * z67 - k19 * z185) - z197 - k10 * z191
        z205 = s31 + c_steer * z201 - s_steer * z204
        z206 = z205 - z193
        z207 = z37 * z206
        z208 = z16 * z194 + z15 * z207
        z209 = z141 - (z144 + z146 * steer_ddot)
        z210 = z47 * roll_ddot
        z211 = z152 * thF_ddot + (z153 * roll_ddot - z154 * steer_ddot)
        z212 = R_yy * z93 - k28 * z86
        s32 = k26 * z161 + (k18 * z163 + k25 * z169)
        z213 = e2z * k60 + (z86 * z196 - z89 * z212 + s32)
        s33 = k26 * z209 - (k18 * z210 - k25 * z211) + z213
        z214 = s1 * (s33 + s_steer * z201 + c_steer * z204)
        s34 = k54 * z161 + (k39 * z168 - k53 * z170)
        z215 = h2z * k67 - (z158 * z202 + z156 * z198 + s34)
        s35 = k32 * z161 + (k19 * z163 + k31 * z169)
        z216 = e2z * k59 - (z90 * z212 + z86 * z195 - s35)
        z217 = c_steer * z172 + s_steer * z180
        s36 = k32 * z209 - (k19 * z210 - k31 * z211) + z216 + k10 * z217
        z218 = k54 * z147 + (k39 * z151 - k53 * z155) - z215 + s36
        z219 = z37 * (c_roll * (z214 + c1 * z218) + e2z * z206)
        z220 = z17 * z194 + z15 * z219
        z221 = z17 * z207 - z16 * z219
        z222 = z30 * z208 - z23 * z220 - z25 * z221
        z223 = c_steer * z222
        z224 = z34 * z208 + z24 * z220 + z18 * z221
        z225 = s_steer * z224
        z226 = z181 + z223 + z225
        z227 = z36 * z194 + z35 * z207 - z26 * z219
        z228 = z192 - z227
        z229 = s1 * z226 - c1 * z228
        s37 = k19 * z161 + (k17 * z163 + k18 * z169)
        z230 = e2z * k58 + (z89 * z186 + z90 * z87 + s37)
        z231 = s_steer * z222 - c_steer * z224
        z232 = k19 * z209 - (k17 * z210 - k18 * z211) + z230 + z217 + z231
        z233 = e2z * z229 + c_roll * z232
        c_yaw = math.cos(yaw)
        z234 = c1 * z226 + s1 * z228
        z235 = z223 + z225
        z236 = s1 * z235 + c1 * z227
        z237 = e2z * z236 + c_roll * z231
        z238 = c1 * z235 - s1 * z227
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            s_yaw * z233 - c_yaw * z234,
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            -(c_yaw * z233 + s_yaw * z234),
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            c_roll * z229 - e2z * z232,
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            c_yaw * z238 - s_yaw * z237,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            c_yaw * z237 + s_yaw * z238,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            e2z * z231 - c_roll * z236,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """T + V

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
        z5 = 1.0 / math.sqrt(z2 * z2 + z4 * z4)
        z6 = r_F * z4
        z7 = z5 * z6
        z8 = k4 + z7
        z9 = s_steer * z8
        z10 = s1 * z9
        z11 = 1.0 / abs(c_roll)
        z12 = r_R * z3
        z13 = z11 * z12
        z14 = k10 + z13 + c_steer * z8
        z15 = c_roll * z10 + e2z * z14
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
        z28 = c_steer * k10 + z8
        z29 = s1 * z27 + c1 * z28
        z30 = c_roll * z29 + e2z * z23
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z24
        z35 = z18 * z30 + z34 * z25
        z36 = z24 * z30 + z34 * z23
        z37 = z15 * z26 - z14 * z35 + z13 * z36
        z38 = k17 * (9.0 + abs(z11))
        s2 = k22 * (z38 + k24)
        s3 = (z38 + k25) * s2
        # the coframe is singular
        if not abs(z37) > 1e-12 * s3:
            raise SingularModelError(1, "jacobian")
        z39 = 1.0 / z37
        z40 = s_steer * c1
        z41 = z8 * z40
        z42 = c_steer * c1
        z43 = r_R * c_roll
        z44 = z43 * z11
        z45 = k10 * s1 + z44
        z46 = s1 * z7 - z20 * z42 - (k16 * z42 - k4 * s1 - c_steer * z45)
        z47 = z20 * z40 + (k16 * z40 - s_steer * z45)
        z48 = z18 * z46 - z25 * z47
        z49 = z24 * z46 - z23 * z47
        z50 = z26 * z41 + z14 * z48 - z13 * z49
        z51 = z39 * z50
        z52 = c_roll * z51
        z53 = s1 + c1 * z52
        z54 = z44 + k10 * z53
        z55 = z30 * z47 + z34 * z46
        z56 = z15 * z49 + z14 * z55 + z36 * z41
        z57 = z39 * z56
        z58 = z15 * z48 + z35 * z41 + z13 * z55
        z59 = z39 * z58
        z60 = z59 - e2z * z51
        z61 = z57 - z60
        z62 = z17 * z61
        z63 = c_steer * z54 + s_steer * z62
        z64 = c1 - s1 * z52
        z65 = s_steer * z60 - c_steer * z64
        z66 = k63 * z53 + (k48 * z63 + k62 * z65)
        z67 = c_steer * z60 + s_steer * z64
        z68 = c_steer * z62 - s_steer * z54
        z69 = z13 * z61
        z70 = z69 - k10 * z60
        z71 = k59 * z67 + (k45 * z68 - k48 * z70)
        z72 = k56 * z53 + (k45 * z63 + k55 * z65)
        z73 = k43 * z70 - k48 * z67
        z74 = k48 * z53 + (k43 * z63 + k45 * z65)
        z75 = k43 * z68 + k45 * z67
        z76 = k41 * z53 + (z44 * k28 - k40 * z64)
        z77 = z60 * k37 + (z62 * k27 - z69 * k28)
        z78 = k35 * z53 + (z44 * k27 - k34 * z64)
        z79 = z69 * k26 - z60 * k28
        z80 = z62 * k26 + z60 * k27
        z81 = k28 * z53 + (z44 * k26 - k27 * z64)
        s4 = z64 * z78 - (z69 * z79 + (z62 * z80 + z44 * z81))
        z82 = z53 * z76 + (z60 * z77 - s4)
        s5 = z65 * z72 + (z70 * z73 + (z63 * z74 + (z68 * z75 + z82)))
        z83 = z53 * z66 + (z67 * z71 + s5)
        z84 = z83 + R_yy * (z61 * z61) + F_yy * (z67 * z67)
        # the mass matrix is singular
        if not abs(z84) > 0.0:
            raise SingularModelError(2, "jacobian")
        z85 = z18 * z8
        z86 = z24 * z8
        z87 = z14 * z85 - z13 * z86
        z88 = z39 * z87
        z89 = c_roll * z88
        z90 = c1 * z89
        z91 = 1.0 + z90
        z92 = k10 * z90
        z93 = z34 * z8
        z94 = z15 * z86 + z14 * z93
        z95 = z39 * z94
        z96 = z15 * z85 + z13 * z93
        z97 = z39 * z96
        z98 = z97 - e2z * z88
        z99 = z95 - z98
        z100 = z17 * z99
        z101 = c_steer * z92 + s_steer * z100
        z102 = s1 * z89
        z103 = s_steer * z98 + c_steer * z102
        z104 = k63 * z91 + (k48 * z101 + k62 * z103)
        z105 = c_steer * z98 - s_steer * z102
        z106 = c_steer * z100 - s_steer * z92
        z107 = z13 * z99
        z108 = z107 - k10 * z98
        z109 = k59 * z105 + (k45 * z106 - k48 * z108)
        z110 = k56 * z91 + (k45 * z101 + k55 * z103)
        z111 = k43 * z108 - k48 * z105
        z112 = k48 * z91 + (k43 * z101 + k45 * z103)
        z113 = k43 * z106 + k45 * z105
        z114 = k40 * z102 + k41 * z90
        z115 = z98 * k37 + (z100 * k27 - z107 * k28)
        z116 = k34 * z102 + k35 * z90
        z117 = z100 * k26 + z98 * k27
        z118 = z107 * k26 - z98 * k28
        s6 = z98 * z115 + (z102 * z116 + (z100 * z117 + z107 * z118))
        z119 = z106 * z113 + (z90 * z114 + s6)
        s7 = z103 * z110 + (z108 * z111 + (z101 * z112 + z119))
        z120 = z91 * z104 + (z105 * z109 + s7) + R_yy * (z99 * z99)
        z121 = z120 + F_yy * (z105 * z105)
        s8 = z98 * z77 + (z102 * z78 + (z100 * z80 + z107 * z79))
        z122 = z106 * z75 + (z90 * z76 + s8)
        s9 = z105 * z71 + (z103 * z72 + (z108 * z73 + (z101 * z74 + z122)))
        z123 = z91 * z66 + s9 + R_yy * (z61 * z99)
        z124 = z123 + F_yy * (z67 * z105)
        z125 = 1.0 / z84
        z126 = z124 * z125
        z127 = z121 - z124 * z126
        # the mass matrix is singular
        if not abs(z127) > 1e-14 * z121:
            raise SingularModelError(2, "jacobian")
        z128 = z20 * z25
        z129 = z20 * z23
        z130 = z7 * z26 - z14 * z128 + z13 * z129
        z131 = z39 * z130
        z132 = c_roll * z131
        z133 = c1 * z132
        z134 = k10 * z133
        z135 = z20 * z30
        z136 = z15 * z129 - z14 * z135 - z7 * z36
        z137 = z39 * z136
        z138 = z15 * z128 - z7 * z35 - z13 * z135
        z139 = z39 * z138
        z140 = z139 + e2z * z131
        z141 = z137 - z140
        z142 = z17 * z141
        z143 = c_steer * z134 - s_steer * z142
        z144 = s1 * z132
        z145 = s_steer * z140 - c_steer * z144
        z146 = k63 * z133 + (k48 * z143 - k62 * z145)
        z147 = c_steer * z140 + s_steer * z144
        z148 = c_steer * z142 + s_steer * z134
        z149 = z13 * z141
        z150 = z149 - k10 * z140
        z151 = k59 * z147 + (k45 * z148 - k48 * z150)
        z152 = k56 * z133 + (k45 * z143 - k55 * z145)
        z153 = k43 * z150 - k48 * z147
        z154 = k48 * z133 + (k43 * z143 - k45 * z145)
        z155 = k43 * z148 + k45 * z147
        z156 = k40 * z144 + k41 * z133
        z157 = z140 * k37 + (z142 * k27 - z149 * k28)
        z158 = k34 * z144 + k35 * z133
        z159 = z142 * k26 + z140 * k27
        z160 = z149 * k26 - z140 * k28
        s10 = z140 * z157 + (z144 * z158 + (z142 * z159 + z149 * z160))
        z161 = z148 * z155 + (z133 * z156 + s10)
        s11 = z145 * z152 - (z150 * z153 + (z143 * z154 + z161))
        z162 = z133 * z146 + (z147 * z151 - s11) + R_yy * (z141 * z141)
        z163 = 1.0 - z147
        z164 = z162 + F_yy * (z163 * z163)
        s12 = z140 * z77 - (z144 * z78 - (z142 * z80 + z149 * z79))
        z165 = z148 * z75 - (z133 * z76 - s12)
        s13 = z147 * z71 + (z145 * z72 + (z150 * z73 - (z143 * z74 - z165)))
        z166 = z133 * z66 - s13 - R_yy * (z61 * z141)
        z167 = z166 + F_yy * (z67 * z163)
        z168 = z167 * z125
        s14 = z140 * z115 - (z144 * z116 - (z142 * z117 + z149 * z118))
        z169 = z148 * z113 - (z133 * z114 - s14)
        s15 = z145 * z110 + (z150 * z111 - (z143 * z112 - z169))
        z170 = z133 * z104 - (z147 * z109 + s15) - R_yy * (z99 * z141)
        z171 = z170 + F_yy * (z105 * z163) - z124 * z168
        z172 = 1.0 / z127
        z173 = z171 * z172
        z174 = z164 - z167 * z168 - z171 * z173
        # the mass matrix is singular
        if not abs(z174) > 1e-14 * z164:
            raise SingularModelError(2, "jacobian")
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
        z188 = z11 * z186
        z189 = z39 * z39
        z190 = roll_dot * c1
        z191 = s_steer * z190
        z192 = thF_dot - z191
        z193 = roll_dot * s1
        z194 = steer_dot + z193
        z195 = c_steer * z190
        z196 = z188 + k10 * z193
        z197 = k4 * z191 - z7 * z192
        s16 = k16 * z195 - k4 * z194 - c_steer * z196
        z198 = z7 * z194 - z20 * z195 - s16
        z199 = z20 * z192 - (k16 * z191 - s_steer * z196)
        z200 = z18 * z198 + z25 * z199
        z201 = z24 * z198 + z23 * z199
        z202 = z26 * z197 + z14 * z200 - z13 * z201
        z203 = z30 * z199 - z34 * z198
        z204 = z15 * z200 + z35 * z197 - z13 * z203
        z205 = z15 * z201 - z14 * z203 + z36 * z197
        z206 = z39 * z202
        z207 = z39 * z205
        z208 = z39 * z204
        z209 = z208 - e2z * z206
        z210 = z207 - z209
        z211 = z17 * z210
        z212 = z13 * z210
        z213 = s1 * z211 - c1 * z212
        z214 = s1 * z212 + c1 * z211
        z215 = c_roll * z188 - e2z * z213
        z273 = 1.0 / z174
        z274 = steer_dot * s_steer
        z275 = roll_dot * e2z
        z276 = s1 * z208
        z277 = z275 * c1 - c_roll * z276
        z278 = roll_dot * c_roll
        z279 = steer_dot * c_steer
        z280 = c1 * z208
        z281 = z275 * s1 + c_roll * z280
        z282 = s_steer * z278 + e2z * z279 + (z274 * z3 + c_steer * z281)
        z283 = z2 * z277 - z4 * z282
        z284 = z5 * z283
        z285 = z187 * z284
        z286 = r_F * z282
        z287 = z6 * z285 + z5 * z286
        z288 = roll_dot * z280
        z289 = r_F * z277
        z290 = z19 * z285 - z5 * z289
        z291 = roll_dot * z276
        z292 = z274 * z190 - c_steer * z291
        z293 = c_roll * z275
        z294 = z11 * z293
        z295 = z294 * z184
        z296 = z275 * z185
        z297 = z186 * z295 - z11 * z296 - k10 * z288
        s17 = k16 * z292 - k4 * z288 - (z274 * z196 - c_steer * z297)
        z298 = z194 * z287 - z7 * z288 - (z195 * z290 - z20 * z292) + s17
        z299 = r_R * z277
        z300 = z16 * z295 - z11 * z299
        z301 = z279 * z17 + s_steer * z300
        z302 = z274 * z21 - c_steer * z290
        z303 = z274 * k10 - z287
        z304 = z27 * z280 + s1 * z302 - (z28 * z276 - c1 * z303)
        z305 = z300 - z290
        z306 = z279 * z22 + s_steer * z305
        z307 = z275 * z29 + c_roll * z304 - (z278 * z23 + e2z * z306)
        z308 = z298 + (z207 * z301 - (z206 * z307 + z208 * z306))
        z309 = z279 * z190 + s_steer * z291
        z310 = z274 * z17 - c_steer * z300
        z311 = z279 * z21 + s_steer * z290
        z312 = z279 * k10
        z313 = z31 * z280 - s1 * z311 - (c1 * z312 + z32 * z276)
        z314 = z274 * z22 - c_steer * z305
        z315 = z275 * z33 + c_roll * z313 + (z278 * z24 - e2z * z314)
        s18 = k16 * z309 - (z279 * z196 + s_steer * z297)
        s19 = z207 * z310 - (z206 * z315 + z208 * z314)
        z316 = z192 * z290 - z20 * z309 - s18 + s19
        z317 = z18 * z308 + z25 * z316
        z318 = r_R * z281
        z319 = z12 * z295 - z11 * z318
        z320 = z279 * z8 + s_steer * z287
        z321 = z9 * z280 - s1 * z320
        z322 = z319 - (z274 * z8 - c_steer * z287)
        z323 = z275 * z10 + c_roll * z321 - (z278 * z14 + e2z * z322)
        s20 = z207 * z319 - (z206 * z323 + z208 * z322)
        z324 = k4 * z309 - (z192 * z287 - z7 * z309) - s20
        z325 = z30 * z316 - z34 * z308
        z326 = z15 * z317 + z35 * z324 - z13 * z325
        z327 = z24 * z308 + z23 * z316
        z328 = z26 * z324 + z14 * z317 - z13 * z327
        z329 = z39 * z328
        z330 = z39 * z326 - (z278 * z206 + e2z * z329)
        z331 = c_roll * z206
        z332 = z190 - s1 * z331
        z333 = z275 * z206 - c_roll * z329
        z334 = z291 + (z331 * z280 + s1 * z333)
        z335 = z274 * z209 - c_steer * z330 - (z279 * z332 + s_steer * z334)
        z336 = z15 * z327 - z14 * z325 + z36 * z324
        z337 = z39 * z336 - z330
        v2_x = roll_dot * z44
        z338 = z193 + c1 * z331
        z339 = z210 * z300 + z17 * z337 - (z209 * z212 - v2_x * z338)
        z340 = k10 * z209
        z341 = k10 * z338
        z342 = z339 + (z209 * z340 + z338 * z341)
        z343 = r_R * z275
        z344 = z11 * z343 - z43 * z295
        z345 = roll_dot * z344 + (z211 * z338 - z212 * z332)
        z346 = z288 - (z331 * z276 - c1 * z333)
        z347 = z345 + (k10 * z346 + z340 * z332)
        z348 = c_steer * z342 + s_steer * z347
        z349 = z210 * z319 + z13 * z337 - (v2_x * z332 - z209 * z211)
        z350 = z349 - (k10 * z330 + z332 * z341)
        w3_steer = steer_dot + z338
        z351 = s_steer * z209 - c_steer * z332
        z352 = k55 * z351 + k56 * w3_steer
        z353 = k62 * z351 + k63 * w3_steer
        s21 = k59 * z335 - (k45 * z348 - k48 * z350)
        s22 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73)
        z354 = s22 - (s21 - (w3_steer * z352 - z351 * z353))
        h2z = e2z * c_steer + s_steer * z3
        z355 = c_steer * z347 - s_steer * z342
        z356 = z279 * z209 + s_steer * z330 + (z274 * z332 - c_steer * z334)
        z357 = c_steer * z209 + s_steer * z332
        z358 = F_yy * (thF_dot - z357) - k59 * z357
        s23 = k56 * z346 + (k45 * z355 - k55 * z356)
        z359 = h2z * k75 + (s23 - (z357 * z353 + w3_steer * z358))
        z360 = k45 * z351 + k48 * w3_steer
        z361 = k45 * z357
        s24 = k43 * z350 + k48 * z335 + (z351 * z360 + z357 * z361)
        z362 = z2 * k72 + s24
        z363 = k48 * z357
        s25 = k48 * z346 + (k43 * z355 - k45 * z356)
        z364 = h2z * k72 + (s25 + (w3_steer * z361 - z351 * z363))
        s26 = k43 * z348 - k45 * z335 + (z357 * z363 + w3_steer * z360)
        z365 = z4 * k72 + s26
        z366 = R_yy * z210 - k37 * z209
        z367 = k34 * z332 - k35 * z338
        s27 = k41 * z346 + (k28 * z345 + k40 * z334)
        z368 = e2z * k68 + (s27 - (z332 * z366 + z209 * z367))
        s28 = k63 * z346 + (k48 * z355 - k62 * z356)
        z369 = h2z * k76 - (s28 + (z351 * z358 + z357 * z352))
        z370 = z368 - z369
        z371 = k40 * z332 - k41 * z338
        s29 = k37 * z330 + (k27 * z339 - k28 * z349)
        z372 = z3 * k69 + z2 * k68 - (s29 - (z338 * z367 + z332 * z371))
        s30 = k35 * z346 + (k27 * z345 + k34 * z334)
        z373 = e2z * k69 + (s30 + (z209 * z371 - z338 * z366))
        z374 = k27 * z332 - k28 * z338
        z375 = k27 * z209
        s31 = k26 * z349 - k28 * z330 + (z332 * z374 + z209 * z375)
        z376 = z2 * k67 + s31
        z377 = k28 * z209
        s32 = k26 * z339 + k27 * z330 + (z209 * z377 - z338 * z374)
        z378 = z3 * k67 - s32
        s33 = k28 * z346 + (k26 * z345 + k27 * z334)
        z379 = e2z * k67 + (s33 + (z338 * z375 + z332 * z377))
        z380 = z187 * z187
        z381 = z184 * (1.0 / c_roll)
        s34 = z140 * z372 - (z144 * z373 - (z142 * z378 - z149 * z376))
        z382 = z148 * z365 + (z133 * z368 - s34)
        s35 = z145 * z359 - (z150 * z362 + (z143 * z364 + z382))
        z383 = z133 * z369 - (z147 * z354 - s35) - R_yy * (z141 * z337)
        s36 = z64 * z373 + (z69 * z376 - (z62 * z378 + z44 * z379))
        z384 = z53 * z368 + (z60 * z372 - s36)
        s37 = z65 * z359 - (z70 * z362 - (z63 * z364 - (z68 * z365 - z384)))
        z385 = z53 * z369 + (z67 * z354 - s37)
        z386 = z385 + R_yy * (z61 * z337) - F_yy * (z67 * z335)
        s38 = z98 * z372 + (z102 * z373 + (z100 * z378 - z107 * z376))
        z387 = z106 * z365 - (z90 * z368 + s38)
        s39 = z103 * z359 - (z108 * z362 - (z101 * z364 - z387))
        z388 = z91 * z369 + (z105 * z354 - s39) + R_yy * (z99 * z337)
        z389 = z388 - F_yy * (z105 * z335) - z386 * z126
        s40 = z383 - F_yy * (z163 * z335) - z386 * z168 - z173 * z389
        z390 = z273 * s40
        z391 = z172 * z389 - z173 * z390
        z392 = z386 * z125 - z126 * z391 - z168 * z390
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
            z88,
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
        for k77, offset1 in enumerate(offsets1):
            turn_3 = 1.0 if k77 == 0 else 0.0
            turn_4 = 1.0 if k77 == 1 else 0.0
            turn_5 = 1.0 if k77 == 2 else 0.0
            turn_6 = 1.0 if k77 == 3 else 0.0
            z216 = s_yaw * turn_3
            z217 = c1 * turn_5
            z218 = e2z * turn_4
            z219 = z184 * (z11 * (c_roll * z218))
            z220 = s1 * z218 - c_roll * z217
            z221 = z12 * z219 - z11 * (r_R * z220)
            z222 = c_steer * turn_6
            z223 = s1 * turn_5
            z224 = c1 * z218 + c_roll * z223
            z225 = c_roll * turn_4
            z226 = s_steer * turn_6
            z227 = s_steer * z225 + e2z * z222 + (z3 * z226 + c_steer * z220)
            z228 = z187 * (z5 * (z2 * z224 - z4 * z227))
            z229 = z6 * z228 + z5 * (r_F * z227)
            z230 = z221 - (z8 * z226 - c_steer * z229)
            s41 = c_roll * (z9 * z217 + s1 * (z8 * z222 + s_steer * z229))
            z231 = z10 * z218 - s41 - (z14 * z225 + e2z * z230)
            z232 = z16 * z219 - z11 * (r_R * z224)
            z233 = z17 * z226 - c_steer * z232
            z234 = z19 * z228 - z5 * (r_F * z224)
            z235 = z232 - z234
            z236 = z22 * z222 + s_steer * z235
            z237 = z22 * z226 - c_steer * z235
            z238 = z17 * z222 + s_steer * z232
            z239 = z23 * z233 - z18 * z236 - (z25 * z237 - z24 * z238)
            s42 = z27 * z217 - s1 * (z21 * z226 - c_steer * z234)
            z240 = s42 - (z28 * z223 - c1 * (z229 - k10 * z226))
            z241 = z29 * z218 - c_roll * z240 - (z23 * z225 + e2z * z236)
            s43 = z31 * z217 + s1 * (z21 * z222 + s_steer * z234)
            z242 = s43 - (z32 * z223 - c1 * (k10 * z222))
            z243 = z33 * z218 - c_roll * z242 + (z24 * z225 - e2z * z237)
            z244 = z30 * z233 + z18 * z241 + (z25 * z243 - z34 * z238)
            z245 = z30 * z237 + z24 * z241 + (z23 * z243 - z34 * z236)
            s44 = z26 * z231 + z15 * z239 + (z35 * z230 - z14 * z244)
            z246 = s44 - (z36 * z221 - z13 * z245)
            z247 = z189 * z246
            z248 = roll_dot * z217
            z249 = roll_dot * z223
            z250 = z190 * z226 + c_steer * z249
            z251 = z186 * z219 - z11 * (z185 * z218)
            z252 = z251 + k10 * z248
            s45 = k16 * z250 + k4 * z248 - (z196 * z226 - c_steer * z252)
            z253 = z194 * z229 + z7 * z248 - (z195 * z234 - z20 * z250) + s45
            z254 = z190 * z222 - s_steer * z249
            s46 = k16 * z254 - (z196 * z222 + s_steer * z252)
            z255 = z192 * z234 - z20 * z254 - s46
            z256 = z198 * z237 - z24 * z253 - (z199 * z236 + z23 * z255)
            z257 = z199 * z241 - z30 * z255 - (z198 * z243 - z34 * z253)
            z258 = k4 * z254 - (z192 * z229 - z7 * z254)
            s47 = z201 * z231 + z15 * z256 + (z203 * z230 - z14 * z257)
            z259 = s47 + (z197 * z245 - z36 * z258)
            z260 = z205 * z247 - z39 * z259
            z261 = z198 * z233 - z18 * z253 - (z199 * z238 + z25 * z255)
            s48 = z200 * z231 + z15 * z261 + (z197 * z244 - z35 * z258)
            z262 = s48 + (z203 * z221 - z13 * z257)
            z263 = z204 * z247 - z39 * z262
            s49 = z197 * z239 - z26 * z258 - (z200 * z230 - z14 * z261)
            z264 = s49 + (z201 * z221 - z13 * z256)
            z265 = z202 * z247 - z39 * z264
            z266 = z260 - (z263 - (z206 * z225 + e2z * z265))
            z267 = z210 * z221 + z13 * z266
            z268 = z210 * z232 + z17 * z266
            z269 = z212 * z217 + s1 * z267 - (z211 * z223 - c1 * z268)
            z270 = c_yaw * turn_3
            z271 = z211 * z217 + s1 * z268 + (z212 * z223 - c1 * z267)
            z272 = z188 * z218 - c_roll * z251 + (z213 * z225 + e2z * z271)
            J[offset1] = z214 * z216 - c_yaw * z269 - (z215 * z270 - s_yaw * z272)
            s50 = z214 * z270 + s_yaw * z269
            J[offset1 + 12] = -(s50 + (z215 * z216 + c_yaw * z272))
            s51 = z213 * z218 - c_roll * z271
            J[offset1 + 24] = z188 * z225 + e2z * z251 - s51
            J[offset1 + 36] = z265
            J[offset1 + 60] = -z263
            J[offset1 + 84] = z260
        # one rate in each pass: its row of the matrix
        offsets2 = (108, 120, 132)
        for k78, offset2 in enumerate(offsets2):
            row_0 = 1.0 if k78 == 0 else 0.0
            row_1 = 1.0 if k78 == 1 else 0.0
            row_2 = 1.0 if k78 == 2 else 0.0
            z393 = row_1 - z126 * row_0
            z394 = z273 * (row_2 + z168 * row_0 + z173 * z393)
            z395 = z172 * z393 + z173 * z394
            z396 = z125 * row_0 - z126 * z395 + z168 * z394
            z397 = z140 * z394 + z98 * z395 + z60 * z396
            z398 = z149 * z394 + z107 * z395 + z69 * z396
            z399 = z142 * z394 + z100 * z395 + z62 * z396
            z400 = z147 * z394 + z105 * z395 + z67 * z396
            z401 = z150 * z394 + z108 * z395 + z70 * z396
            z402 = k48 * z400 - k43 * z401
            z403 = F_yy * z394
            z404 = F_yy * z395
            z405 = F_yy * z396
            z406 = z148 * z394 + z106 * z395 + z68 * z396
            s52 = z163 * z403 - z105 * z404 - z67 * z405 - k59 * z400
            z407 = s52 + k48 * z401 - k45 * z406
            z408 = z133 * z394
            z409 = z53 * z396
            z410 = z408 - z91 * z395 - z409
            z411 = z145 * z394 + z103 * z395 + z65 * z396
            z412 = z143 * z394 - z101 * z395 - z63 * z396
            z413 = k62 * z410 - k55 * z411 + k45 * z412
            s53 = k37 * z397 - k28 * z398 + k27 * z399 + k10 * z402
            z414 = s53 - c_steer * z407 - s_steer * z413
            z415 = R_yy * z394
            z416 = R_yy * z395
            z417 = R_yy * z396
            z418 = z402 + (k28 * z397 - k26 * z398)
            z419 = k48 * z410 - k45 * z411 + k43 * z412
            z420 = k45 * z400 + k43 * z406
            z421 = s_steer * z419 - c_steer * z420
            z422 = k27 * z397 + k26 * z399 - z421
            s54 = z141 * z415 + z99 * z416 + z61 * z417 - z13 * z418
            z423 = s54 + z17 * z422
            z424 = z414 - z423
            z425 = z39 * z423
            z426 = z39 * z424
            z427 = z408 - z90 * z395 - z409
            z428 = z144 * z394 - z102 * z395 + z64 * z396
            z429 = z44 * z396
            s55 = k40 * z427 + k34 * z428 - k27 * z429 - s_steer * z407
            z430 = s55 + c_steer * z413
            s56 = k63 * z410 - k56 * z411 + k48 * z412 + k41 * z427
            z431 = s56 + k35 * z428 - k28 * z429
            z432 = c_steer * z419 + s_steer * z420
            z433 = z431 + k10 * z432
            z434 = s1 * z430 + c1 * z433
            z435 = c_roll * z434 + e2z * z424
            z436 = z39 * z435
            z437 = z36 * z425 + z35 * z426 - z26 * z436
            z438 = z206 * z437
            z439 = z14 * z425 + z13 * z426
            z440 = z15 * z425 + z13 * z436
            z441 = z15 * z426 - z14 * z436
            z442 = z34 * z439 + z24 * z440 + z18 * z441
            z443 = z206 * z442
            z444 = z30 * z439 - z23 * z440 - z25 * z441
            z445 = z206 * z444
            z446 = z208 * z437 - e2z * z438
            z447 = c_roll * z438
            z448 = s1 * z447
            z449 = c_roll * z443
            z450 = c1 * z449
            s57 = z194 * z442 - z192 * z437 + c_steer * z446 - s_steer * z448
            z451 = s57 + z450
            z452 = z208 * z442 - e2z * z443
            z453 = z208 * z444 - e2z * z445
            z454 = s_steer * z452 + c_steer * z453
            z455 = s1 * z449
            z456 = c_roll * z445
            z457 = s1 * z456
            s58 = z192 * z444 + z195 * z442 - c_steer * z455 + s_steer * z457
            z458 = z454 - s58
            z459 = z6 * z451 + z19 * z458
            z460 = z187 * z459
            z461 = z5 * z460
            z462 = r_F * (z5 * z451) - z4 * z461
            s59 = z206 * z424 + z14 * z438 - z23 * z443 - z24 * z445
            z463 = s59 - s_steer * z462
            z464 = s_steer * z444 - c_steer * z442
            z465 = z332 * z427 + z338 * z428
            z466 = k28 * z427 + k27 * z428 - k26 * z429 + z432
            z467 = z332 * z466 + z209 * z422
            z468 = z209 * z418 - z338 * z466
            s60 = R_yy * z465 + z319 * z418 - z300 * z422 + z13 * z467
            z469 = s60 + z17 * z468
            z470 = z310 * z444 - z301 * z442 + z319 * z437 + z469
            z471 = z39 * z470
            z472 = z21 * z442
            z473 = z21 * z444 + z7 * z437 + k4 * z437
            z474 = z430 - c_steer * z472 + s_steer * z473
            z475 = z207 * z442
            z476 = z207 * z444
            z477 = z210 * z422 + s_steer * z475 - z454 + c_steer * z476
            z478 = r_F * (z5 * z458) + r_R * (z11 * z477) - z2 * z461
            s61 = z331 * z433 - z28 * z449 + z32 * z456 - roll_dot * z474
            z479 = s61 - c_roll * z478
            z480 = z433 - z7 * z442 - k4 * z442 + k10 * z464
            z481 = z210 * z418 + z207 * z437 - z446
            z482 = r_R * (z11 * z481) + c_steer * z462
            s62 = z331 * z430 + z9 * z447 - z27 * z449 + z31 * z456
            z483 = s62 + roll_dot * z480 + c_roll * z482
            s63 = z375 * z398 + z377 * z399 - z367 * z427 + z371 * z428
            z484 = s63 + k37 * z465 - k28 * (z332 * z429 - z209 * z399)
            s64 = z484 + k27 * (z209 * z398 - z338 * z429) - z340 * z421
            z485 = s64 - z211 * z418 - z212 * z422
            z486 = z351 * z410 + w3_steer * z411
            s65 = z361 * z401 + z363 * z406 + z352 * z410 + z353 * z411
            z487 = s65 - k59 * z486 - k48 * (z351 * z412 - z357 * z406)
            z488 = F_yy * z486
            z489 = z487 + k45 * (z357 * z401 + w3_steer * z412) - z488
            s66 = k10 * (z332 * z432 - z209 * z421)
            z490 = z485 + z274 * z407 - z279 * z413 + s66 + c_steer * z489
            z491 = z351 * z400 - z357 * z411
            z492 = z357 * z410 + w3_steer * z400
            s67 = z360 * z401 - z363 * z412 + z358 * z410 - z353 * z400
            z493 = s67 - k62 * z491 + k55 * z492
            z494 = z351 * z401 + w3_steer * z406
            z495 = z493 + k45 * z494
            z496 = z490 + s_steer * z495 + z469
            s68 = z314 * z444 - z306 * z442 + z322 * z437 - s1 * z479
            z497 = s68 + c1 * z483 + z496
            z498 = z39 * z497
            z499 = z14 * z471 - z13 * z498
            z500 = z332 * z397 - z209 * z428
            z501 = z209 * z427 + z338 * z397
            s69 = z374 * z398 - z377 * z429 - z366 * z427 - z371 * z397
            z502 = s69 - k40 * z500 - k34 * z501
            z503 = z332 * z398 - z338 * z399
            s70 = z502 + k27 * z503 + z341 * z402 + z340 * z432 + v2_x * z418
            z504 = s70 - z212 * z466 - z279 * z407
            z505 = z504 - z274 * z413 + s_steer * z489 - c_steer * z495
            s71 = z361 * z412 + z360 * z406 + z352 * z400 + z358 * z411
            z506 = s71 - k63 * z491 + k56 * z492
            z507 = z506 + k48 * z494
            s72 = z375 * z429 + z374 * z399 + z367 * z397 + z366 * z428
            z508 = s72 - k41 * z500 - k35 * z501
            s73 = z508 + k28 * z503 + z341 * z421 - z211 * z466 - v2_x * z422
            z509 = s73 - k10 * (z332 * z402 - z338 * z421)
            z510 = z507 - z509
            z511 = z280 * z430 - z276 * z433 - s1 * z505 + c1 * z510
            s74 = z275 * z434 - z278 * z424 + z315 * z444 - z307 * z442
            z512 = s74 + z323 * z437 + c_roll * z511
            z513 = z512 - e2z * z496
            z514 = z39 * z513
            z515 = z15 * z471 + z13 * z514
            z516 = z15 * z498 + z14 * z514
            z517 = z30 * z499 - z23 * z515 + z25 * z516
            z518 = z34 * z499 + z24 * z515 - z18 * z516
            z519 = z279 * z444 + z274 * z442 - s_steer * z517 + c_steer * z518
            z520 = z295 * z464 + z11 * z519
            z521 = roll_dot * z466
            z522 = z43 * z521 + z186 * z464 + z12 * z481 - z16 * z477
            z523 = z184 * z522
            z524 = z11 * z523
            s75 = z329 * z434 - z321 * z438 + z304 * z443 - z313 * z445
            z525 = s75 - z280 * z482 - z276 * z478
            z526 = z390 * z394
            z527 = z133 * z526
            z528 = z145 * z526
            z529 = z143 * z526
            s76 = z394 * z370 + z146 * z526 + z156 * z526 + k63 * z527
            z530 = s76 - k56 * z528 + k48 * z529
            z531 = z144 * z526
            z532 = z391 * z394 - z390 * z395
            z533 = z392 * z394 - z390 * z396
            s77 = z530 + k41 * z527 + k35 * z531 + z104 * z532 + z114 * z532
            z534 = s77 + z66 * z533 + z76 * z533
            s78 = z364 * z394 + z154 * z526 + k48 * z527 - k45 * z528
            z535 = s78 + k43 * z529 + z112 * z532
            z536 = z535 + z74 * z533
            z537 = z147 * z526
            z538 = z148 * z526
            s79 = z365 * z394 + z155 * z526 + k45 * z537 + k43 * z538
            z539 = s79 - z113 * z532 - z75 * z533
            z540 = z534 + k10 * (c_steer * z536 + s_steer * z539)
            s80 = z373 * z394 + z158 * z526 + k40 * z527 + k34 * z531
            z541 = s80 + z116 * z532 + z78 * z533
            z542 = F_yy * z532
            z543 = F_yy * z533
            z544 = z150 * z526
            s81 = z354 * z394 + z151 * z526 + k59 * z537 - k48 * z544
            z545 = s81 + k45 * z538 - z109 * z532
            s82 = z335 * z403 + 2.0 * (z163 * (F_yy * z526)) + z105 * z542
            z546 = s82 + z67 * z543 - (z545 - z71 * z533)
            s83 = z359 * z394 + z152 * z526 + k62 * z527 - k55 * z528
            z547 = s83 + k45 * z529 + z110 * z532
            z548 = z547 + z72 * z533
            z549 = z541 - s_steer * z546 + c_steer * z548
            z550 = c1 * z540 + s1 * z549
            z551 = z391 * z395
            z552 = z133 * z532
            z553 = z552 - z91 * z551
            z554 = z145 * z532 + z103 * z551
            z555 = z143 * z532 - z101 * z551
            z556 = z392 * z395 + z391 * z396
            s84 = z369 * z395 - z104 * z551 + k63 * z553 - k56 * z554
            z557 = s84 + k48 * z555 - z66 * z556
            z558 = z552 - z90 * z551
            z559 = z144 * z532 - z102 * z551
            s85 = z364 * z395 + z112 * z551 - k48 * z553 + k45 * z554
            z560 = s85 - k43 * z555 + z74 * z556
            z561 = z147 * z532 + z105 * z551
            z562 = z148 * z532 + z106 * z551
            s86 = z365 * z395 - z113 * z551 - k45 * z561 - k43 * z562
            z563 = s86 - z75 * z556
            s87 = z368 * z395 + z114 * z551 - k41 * z558 - k35 * z559
            s88 = k10 * (c_steer * z560 + s_steer * z563)
            z564 = z557 - (s87 + z76 * z556) - s88
            s89 = z335 * z404 - z354 * z395 - z163 * z542
            z565 = s89 + 2.0 * (z105 * (F_yy * z551)) + z109 * z551
            z566 = z150 * z532 + z108 * z551
            z567 = F_yy * z556
            s90 = z565 + k59 * z561 - k48 * z566 + k45 * z562 + z67 * z567
            z568 = s90 + z71 * z556
            s91 = z373 * z395 + z116 * z551 - k40 * z558 - k34 * z559
            z569 = s91 + z78 * z556 - s_steer * z568
            s92 = z359 * z395 + z110 * z551 - k62 * z553 + k55 * z554
            z570 = s92 - k45 * z555 + z72 * z556
            z571 = z569 + c_steer * z570
            z572 = c1 * z564 - s1 * z571
            z573 = z392 * z396
            z574 = z133 * z533
            z575 = z53 * z573
            z576 = z574 - z91 * z556 - z575
            z577 = z145 * z533 + z103 * z556 + z65 * z573
            z578 = z143 * z533 - z101 * z556 - z63 * z573
            s93 = z396 * z370 + z66 * z573 + z76 * z573 - k63 * z576
            z579 = s93 + k56 * z577 - k48 * z578
            z580 = z574 - z90 * z556 - z575
            z581 = z144 * z533 - z102 * z556 + z64 * z573
            z582 = z44 * z573
            s94 = z364 * z396 + z74 * z573 - k48 * z576 + k45 * z577
            z583 = s94 - k43 * z578
            z584 = z147 * z533 + z105 * z556 + z67 * z573
            z585 = z148 * z533 + z106 * z556 + z68 * z573
            z586 = z365 * z396 - z75 * z573 - k45 * z584 - k43 * z585
            z587 = c_steer * z583 + s_steer * z586
            z588 = z579 - k41 * z580 - k35 * z581 + k28 * z582 + k10 * z587
            s95 = z335 * z405 - z354 * z396 - z163 * z543 + z105 * z567
            z589 = s95 + 2.0 * (z67 * (F_yy * z573))
            z590 = z150 * z533 + z108 * z556 + z70 * z573
            z591 = z589 + z71 * z573 + k59 * z584 - k48 * z590 + k45 * z585
            s96 = z373 * z396 + z78 * z573 - k40 * z580 - k34 * z581
            z592 = s96 + k27 * z582 - s_steer * z591
            s97 = z359 * z396 + z72 * z573 - k62 * z576 + k55 * z577
            z593 = s97 - k45 * z578
            z594 = z592 + c_steer * z593
            z595 = c1 * z588 + s1 * z594
            s98 = z525 - z206 * z511 - z131 * z550 - z88 * z572 + z51 * z595
            z596 = 2.0 * (z294 * z522 * z381) - s98
            z597 = R_yy * z532
            z598 = R_yy * z533
            s99 = z362 * z394 + z153 * z526 - k48 * z537 + k43 * z544
            z599 = s99 - z111 * z532 - z73 * z533
            z600 = z140 * z526
            z601 = z149 * z526
            s100 = z376 * z394 + z160 * z526 - k28 * z600 + k26 * z601
            z602 = s100 - z118 * z532 - z79 * z533
            z603 = z599 + z602
            s101 = z337 * z415 + 2.0 * (z141 * (R_yy * z526)) - z99 * z597
            z604 = s101 - z61 * z598 + z13 * z603
            z605 = z142 * z526
            s102 = z378 * z394 - z159 * z526 - k27 * z600 - k26 * z605
            z606 = s102 + z117 * z532 + z80 * z533
            z607 = z606 + s_steer * z536 - c_steer * z539
            z608 = z604 - z17 * z607
            z609 = z39 * z608
            s103 = z372 * z394 - z157 * z526 - k37 * z600 + k28 * z601
            z610 = s103 - k27 * z605 + z115 * z532
            s104 = z610 + z77 * z533 + c_steer * z546 + s_steer * z548
            z611 = s104 + k10 * z599 + z608
            z612 = z39 * z611
            s105 = z327 * z425 + z317 * z426 - z201 * z471 + z200 * z498
            z613 = s105 + z129 * z609 - z128 * z612
            z614 = R_yy * z556
            s106 = z362 * z395 - z111 * z551 + k48 * z561 - k43 * z566
            z615 = s106 - z73 * z556
            z616 = z140 * z532 + z98 * z551
            z617 = z149 * z532 + z107 * z551
            s107 = z376 * z395 - z118 * z551 + k28 * z616 - k26 * z617
            z618 = z615 + (s107 - z79 * z556)
            s108 = z337 * z416 - z141 * z597 - 2.0 * (z99 * (R_yy * z551))
            z619 = s108 - z61 * z614 + z13 * z618
            z620 = z142 * z532 + z100 * z551
            s109 = z378 * z395 + z117 * z551 + k27 * z616 + k26 * z620
            z621 = s109 + z80 * z556 + s_steer * z560
            z622 = z621 - c_steer * z563
            z623 = z619 - z17 * z622
            z624 = z39 * z623
            s110 = z372 * z395 + z115 * z551 + k37 * z616 - k28 * z617
            z625 = s110 + k27 * z620 + z77 * z556
            z626 = z625 + c_steer * z568 + s_steer * z570 + k10 * z615 + z623
            z627 = z39 * z626
            z628 = z362 * z396 - z73 * z573 + k48 * z584 - k43 * z590
            z629 = z140 * z533 + z98 * z556 + z60 * z573
            z630 = z149 * z533 + z107 * z556 + z69 * z573
            z631 = z628 + (z376 * z396 - z79 * z573 + k28 * z629 - k26 * z630)
            s111 = z337 * z417 - z141 * z598 - z99 * z614
            z632 = s111 - 2.0 * (z61 * (R_yy * z573)) + z13 * z631
            z633 = z142 * z533 + z100 * z556 + z62 * z573
            s112 = z378 * z396 + z80 * z573 + k27 * z629 + k26 * z633
            z634 = s112 + s_steer * z583 - c_steer * z586
            z635 = z632 - z17 * z634
            z636 = z39 * z635
            s113 = z372 * z396 + z77 * z573 + k37 * z629 - k28 * z630
            z637 = s113 + k27 * z633 + c_steer * z591
            z638 = z637 + s_steer * z593 + k10 * z628 + z635
            z639 = z39 * z638
            s114 = z336 * z423 + z326 * z424 - z328 * z435 - z205 * z470
            z640 = s114 + z204 * z497 + z202 * z513
            z641 = c_roll * z550 - e2z * z611
            z642 = c_roll * z572 + e2z * z626
            s115 = z640 + z136 * z608 - z138 * z611 + z130 * z641 + z94 * z623
            z643 = s115 - z96 * z626 + z87 * z642
            z644 = c_roll * z595 - e2z * z638
            z645 = z189 * (z643 + z56 * z635 - z58 * z638 - z50 * z644)
            s116 = z613 + z86 * z624 - z85 * z627 + z49 * z636 - z48 * z639
            z646 = s116 - z26 * z645
            z647 = z14 * z609 - z13 * z612
            z648 = z14 * z636 - z13 * z639
            s117 = z324 * z425 - z197 * z471 - z7 * z609 + z41 * z636
            z649 = s117 - z13 * z645
            s118 = z324 * z426 + z197 * z498 + z7 * z612 - z41 * z639
            z650 = s118 + z14 * z645
            s119 = z316 * z439 - z199 * z499 + z20 * z647 - z47 * z648
            z651 = s119 - z24 * z649 - z18 * z650
            z652 = z14 * z624 - z13 * z627
            s120 = z308 * z439 - z198 * z499 + z8 * z652 + z46 * z648
            z653 = s120 + z23 * z649 + z25 * z650
            z654 = z332 * z418 + z338 * z422
            s121 = z379 * z396 + z81 * z573 - k28 * z580 - k27 * z581
            z655 = roll_dot * z654 - (s121 + k26 * z582)
            z656 = z39 * z644
            z657 = z15 * z636 + z13 * z656
            z658 = z15 * z639 + z14 * z656
            z659 = z30 * z648 - z23 * z657 + z25 * z658
            z660 = z34 * z648 + z24 * z657 - z18 * z658
            z661 = s_steer * z659 - c_steer * z660
            z662 = z655 - z587 - z661
            s122 = z318 * z481 - z299 * z477 + z343 * z521 + z296 * z464
            z663 = s122 - z293 * z523 + z43 * z662
            s123 = z337 * z418 + z325 * z426 - z327 * z436 + z210 * z467
            z664 = s123 + z203 * z498 + z201 * z514
            z665 = z39 * z641
            z666 = z39 * z642
            s124 = z664 - z141 * z603 - z135 * z612 - z129 * z665 - z99 * z618
            z667 = s124 + z93 * z627 + z86 * z666
            s125 = z325 * z425 + z317 * z436 + z278 * z438 - z203 * z471
            z668 = s125 - z200 * z514 + z135 * z609
            s126 = z668 + z128 * z665 - z93 * z624 - z85 * z666 - z55 * z636
            z669 = s126 + z48 * z656 - z35 * z645
            z670 = z669 - e2z * z646
            s127 = z667 - z61 * z631 + z55 * z639 - z49 * z656 + z36 * z645
            z671 = s127 + z670
            s128 = z337 * z422 - z210 * z468 + z279 * z475 - z274 * z476
            z672 = s128 - z141 * z607 - z99 * z622
            z673 = z15 * z612 + z14 * z665
            s129 = z324 * z436 - z197 * z514 - z7 * z665 + z41 * z656
            z674 = s129 + z15 * z645
            s130 = z316 * z441 + z199 * z516 - z20 * z673 + z47 * z658
            z675 = s130 + z34 * z650 + z24 * z674
            z676 = z15 * z609 + z13 * z665
            s131 = z316 * z440 + z278 * z443 - z199 * z515 + z20 * z676
            z677 = s131 - z47 * z657 + z34 * z649
            z678 = z677 - z18 * z674 - e2z * z651
            z679 = z15 * z624 - z13 * z666
            s132 = z308 * z440 + z278 * z445 - z198 * z515 + z8 * z679
            z680 = s132 + z46 * z657 + z30 * z649
            z681 = z680 + z25 * z674 - e2z * z653
            z682 = z279 * z452 - z274 * z453 - s_steer * z678 - c_steer * z681
            z683 = z15 * z627 - z14 * z666
            s133 = z308 * z441 + z198 * z516 - z8 * z683 - z46 * z658
            z684 = s133 + z30 * z650 - z23 * z674
            z685 = z672 - z61 * z634 + s_steer * z675 - z682 + c_steer * z684
            s134 = z275 * z524 - z596 - z10 * z646 + z29 * z651 - z33 * z653
            s135 = z11 * (z184 * (z186 * z519 - z663 + z12 * z671 - z16 * z685))
            z686 = z185 * z520 + s134 - c_roll * s135
            z687 = k76 * z410 + k75 * z411 - k72 * z412
            s136 = k69 * z397 + k67 * z399 + r_R * (z295 * z481 + z11 * z671)
            z688 = z274 * z462 - (s_steer * z687 + s136)
            z689 = z36 * z471 - z35 * z498 - z26 * z514
            s137 = z288 * z442 - z309 * z437 + z194 * z518 - z192 * z689
            z690 = s137 + z36 * z609 - z35 * z612
            z691 = z36 * z636 - z35 * z639 - z26 * z656
            s138 = z274 * z446 + z279 * z448 - z34 * z652 - z24 * z679
            z692 = s138 + z18 * z683 - z40 * z691
            z693 = z275 * z438 + c_roll * z646
            z694 = z280 * z447 + s1 * z693
            z695 = z275 * z443 + c_roll * z651
            z696 = z276 * z449 - c1 * z695
            s139 = z692 + c_steer * z670 - s_steer * z694 - z696
            z697 = z690 - z26 * z665 - s1 * z660 + s139
            s140 = z282 * z461 - k74 * z400 - k72 * z406 - k71 * z400
            z698 = s140 - r_F * (z285 * z451 - z5 * z697)
            s141 = z309 * z444 + z292 * z442 + z192 * z517 + z195 * z518
            z699 = s141 - z30 * z647 + z23 * z676
            z700 = z280 * z449 + s1 * z695
            z701 = z275 * z445 + c_roll * z653
            z702 = z280 * z456 + s1 * z701
            s142 = z274 * z455 + z279 * z457 + c_steer * z700 - s_steer * z702
            z703 = z699 - z25 * z673 + z40 * z659 - z42 * z660 + (z682 - s142)
            s143 = z286 * z451 - z289 * z458 + z283 * z460 - z6 * z697
            z704 = z5 * (z187 * (s143 + z19 * z703))
            z705 = z284 * z459 * z380 + 0.5 * z704
            z706 = z698 + 2.0 * (z4 * z705)
            z707 = z688 + c_steer * z706
            s144 = z277 * z461 - k73 * z400 + k72 * z401 + k70 * z400
            z708 = s144 - k68 * z397 + k67 * z398
            s145 = z708 + r_F * (z285 * z458 + z5 * z703)
            z709 = s145 + r_R * (z295 * z477 + z11 * z685) - 2.0 * (z2 * z705)
            s146 = z686 + r_R * (z295 * z521 - z11 * z662) - s1 * z707
            z710 = roll_dot * z463 + (s146 - c1 * z709)
            z711 = z11 * z464
            s147 = z206 * z434 + r_R * (z11 * z521) + z10 * z438 - z29 * z443
            z712 = s147 + z33 * z445 + z185 * z711
            z713 = z712 - c_roll * z524 + s1 * z482 - c1 * z478
            s148 = z329 * z424 + z322 * z438 - z306 * z443 + z314 * z445
            z714 = s148 + z206 * z496 - k68 * z427
            s149 = z714 - k69 * z428 + k67 * z429 + z131 * z611 - z88 * z626
            z715 = s149 - z51 * z638 - z14 * z646
            s150 = z279 * z462 - (z715 + z23 * z651 + z24 * z653)
            z716 = c_steer * z687 - (roll_dot * z713 + s150) + s_steer * z706
            J[offset2 + 4] = c_roll * z716 - e2z * z710
            z717 = z290 * z442 - z20 * z518 - k16 * z518
            z718 = z290 * z444 + z287 * z437 - z20 * z517 - z7 * z689
            z719 = z718 - (k16 * z517 + k4 * z689)
            s151 = z505 + z274 * z472 + z279 * z473 - c_steer * z717
            z720 = s151 + s_steer * z719
            s152 = z333 * z433 - z303 * z449 + z208 * z483 + z331 * z510
            z721 = s152 + z132 * z540 + z89 * z564
            z722 = z21 * z660
            z723 = z8 * z691 + z20 * z659 + k16 * z659
            s153 = z312 * z456 - (z594 + (z721 - z52 * z588)) + c_steer * z722
            z724 = s153 - s_steer * z723 + z28 * z695
            z725 = z287 * z442 - z7 * z518 - k4 * z518
            z726 = z725 + (z510 - k10 * z519)
            s154 = z333 * z430 - z320 * z447 - z302 * z449 - z311 * z456
            z727 = s154 - z208 * z479 - z331 * z505
            s155 = z727 + z132 * z549 - z89 * z571 - z588 - z52 * z594
            z728 = s155 + z7 * z660 + k4 * z660
            s156 = roll_dot * z726 + (z728 + z9 * z693 - z27 * z695 + z31 * z701)
            z729 = z275 * z482 + (s156 - k10 * z661)
            s157 = z275 * z478 - (roll_dot * z720 - (z724 - z32 * z701))
            z730 = s1 * (s157 - c_roll * z709) + c1 * (z729 + c_roll * z707)
            J[offset2 + 5] = -z730
            s158 = z332 * z413 - z209 * z407 + z196 * z442 - z190 * z472
            z731 = s158 + z8 * z446 + k10 * z450
            z732 = z731 - z22 * z453 + z21 * z455 + z17 * z476 - z3 * z462
            s159 = z342 * z419 - z347 * z420 + z334 * z407 + z330 * z413
            z733 = s159 - z332 * z489 + z297 * z444
            s160 = z733 - z291 * z473 + z287 * z448 + z305 * z452 - z300 * z475
            z734 = s160 + z290 * z457 - z209 * z495
            s161 = z734 + z144 * z546 + z140 * z548 + z142 * z536 - z134 * z539
            z735 = s161 - z102 * z568 + z98 * z570
            s162 = z735 + z100 * z560 + z92 * z563 + z64 * z591 + z60 * z593
            z736 = s162 + z62 * z583 + z54 * z586
            s163 = z190 * z719 + (z196 * z517 - z736) - z45 * z659 + c1 * z723
            z737 = s163 + z8 * z694 + z22 * z678
            s164 = k10 * (z276 * z456 - c1 * z701)
            z738 = z3 * z687 - (z737 + z17 * z675 + z21 * z702 - s164)
            s165 = z332 * z407 + z209 * z413 + z196 * z444 - z190 * z473
            z739 = s165 + z8 * z448 + z22 * z452
            s166 = z739 - z17 * z475 + z21 * z457 + k10 * (c1 * z456)
            z740 = s166 - e2z * z462
            s167 = z347 * z419 + z342 * z420 + z334 * z413 - z330 * z407
            z741 = s167 - z332 * z495 + z297 * z442
            s168 = z741 - z291 * z472 + z287 * z446 - z305 * z453 + z290 * z455
            z742 = s168 + z300 * z476 + z281 * z462
            s169 = z742 + z209 * z489 - z140 * z546 + z144 * z548 + z134 * z536
            z743 = s169 + z142 * z539 - z98 * z568
            s170 = z743 - z102 * z570 - z92 * z560 + z100 * z563 - z60 * z591
            z744 = s170 + z64 * z593 - z54 * z583
            s171 = z190 * z717 + (z196 * z518 - (z744 + z62 * z586))
            z745 = s171 - z45 * z660 + c1 * z722 + z8 * z670
            s172 = z745 - k10 * z696 - z22 * z681 + z21 * z700 - z17 * z684
            z746 = steer_dot * z740 + (s172 - z3 * z706)
            s173 = steer_dot * z732 - (z278 * z462 - z738) + e2z * z706
            z747 = c_steer * s173 - s_steer * (e2z * z687 + z746)
            J[offset2 + 6] = z747
            s174 = z276 * z474 + z280 * z480 + z344 * z466 + z44 * z654
            z748 = s174 + r_R * (z275 * z711 - c_roll * z520)
            s175 = z748 + c1 * z720 + s1 * z726 + e2z * z713
            J[offset2 + 9] = c_roll * z463 - s175
            J[offset2 + 10] = s_steer * z732 - (z507 + z725 - c_steer * z740)
            J[offset2 + 11] = z718 - z488
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
