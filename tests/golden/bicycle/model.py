"""bicycle, emitted by nhc 0.1.0 (nhc:81bd3b5bd817e83d).

Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x
    ahead, y right, z down.
Source: bicycle.yaml
Equations of motion: euler-lagrange (I.2.15)
Why: coframe completed by nhc with roll', steer', thR': the dependent velocities of
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
y[11] = thR'

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
rhs: 476 +-, 729 *, 6 /, 17 calls
velocities: 58 +-, 102 *, 3 /, 17 calls
accelerations: 160 +-, 272 *, 3 /, 12 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 108 +-, 183 *, 2 /, 12 calls
reactions: 409 +-, 629 *, 3 /, 12 calls
energy: 170 +-, 281 *, 3 /, 12 calls
jacobian: 3678 +-, 5099 *, 7 /, 17 calls
outputs: 43 +-, 76 *, 2 /, 15 calls

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
    "thR'",
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

    Arguments: t (scalar), y (12,), p (26,).
    Returns dydt (12,).
    """
    yaw = float(y[3])  # first turn of the rear frame, about z [rad]
    roll = float(y[4])  # second turn, about x [rad]
    pitch = float(y[5])  # third turn, about y [rad]
    steer = float(y[6])  # front frame against rear frame [rad]
    roll_dot = float(y[9])
    steer_dot = float(y[10])
    thR_dot = float(y[11])
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
        k62 = k12 * k60
        k63 = k11 * k60
        k64 = g * k40
        k65 = k15 * k59 + k16 * k58
        k66 = k9 * k59 - k4 * k58
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
        z14 = k10 + z13
        z15 = z14 + c_steer * z8
        z16 = c_roll * z10 + e2z * z15
        z17 = r_F * z2
        z18 = z5 * z17
        z19 = r_R * z2
        z20 = z11 * z19
        z21 = k16 + z18
        z22 = z20 - z21
        z23 = s_steer * z22
        z24 = z18 * z23
        z25 = c_steer * z21
        z26 = c_steer * k10 + z8
        z27 = s1 * z25 + c1 * z26
        z28 = c_roll * z27 + e2z * z23
        z29 = z18 * z28
        z30 = c_steer * z22
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z30
        z35 = z30 * z28 + z34 * z23
        z36 = z16 * z24 - z15 * z29 - z7 * z35
        z37 = k17 * (9.0 + abs(z11))
        s4 = (z37 + k24) * (z37 + k25)
        # the coframe is singular
        if not abs(z36) > 1e-15 * (k22 * s4):
            raise _refuse(abs(z36), 1e-15 * (k22 * s4), 1, "rhs")
        z38 = r_R * z11
        z39 = c_roll * z38
        z40 = 1.0 / z36
        z41 = s_steer * c1
        z42 = z8 * z41
        z43 = k10 * s1 + z39
        z44 = s1 * z8 + (c_steer * z43 - c1 * z25)
        z45 = z18 * z44
        z46 = z21 * z41 - s_steer * z43
        z47 = z40 * (z24 * z42 + z15 * z45 + z7 * (z30 * z44 - z23 * z46))
        z48 = c_roll * z47
        z49 = s1 + c1 * z48
        z50 = c1 - s1 * z48
        s5 = z40 * (z29 * z42 + z16 * z45 - z7 * (z28 * z46 + z34 * z44))
        z51 = s5 - e2z * z47
        z52 = z20 * z51
        z53 = z13 * z51
        z54 = k37 * z51 - (k27 * z52 - k28 * z53)
        z55 = z54 + R_yy * z51
        z56 = k38 * z49 + (k28 * z39 - k35 * z50)
        z57 = z39 + k10 * z49
        z58 = c_steer * z57 - s_steer * z52
        z59 = s_steer * z51 - c_steer * z50
        z60 = k57 * z49 + (k45 * z58 + k53 * z59)
        z61 = z56 + z60
        z62 = c_steer * z51 + s_steer * z50
        z63 = c_steer * z52 + s_steer * z57
        z64 = z14 * z51
        z65 = k56 * z62 - (k42 * z63 - k45 * z64)
        z66 = k53 * z49 + (k42 * z58 + k52 * z59)
        z67 = k40 * z64 + k45 * z62
        z68 = k45 * z49 + (k40 * z58 + k42 * z59)
        z69 = k40 * z63 - k42 * z62
        z70 = k26 * z53 + k28 * z51
        z71 = k26 * z52 - k27 * z51
        z72 = k35 * z49 + (k27 * z39 - k34 * z50)
        s6 = z53 * z70 + (z52 * z71 - (z50 * z72 - F_yy * (z62 * z62)))
        z73 = z58 * z68 + (z63 * z69 + s6)
        s7 = z49 * z61 + (z62 * z65 + (z59 * z66 + (z64 * z67 + z73)))
        z74 = z39 * (k28 * z49 + (k26 * z39 - k27 * z50)) + (z51 * z55 + s7)
        # the mass matrix is singular
        if not abs(z74) > 0.0:
            raise _refuse(abs(z74), 0.0, 2, "rhs")
        z75 = z18 * z8
        z76 = z34 * z8
        z77 = z30 * z8
        z78 = z40 * (z15 * z75 + z7 * z77)
        z79 = z40 * (z16 * z75 - z7 * z76) - e2z * z78
        z80 = z20 * z79
        z81 = z13 * z79
        z82 = z79 * k37 - (z80 * k27 - z81 * k28)
        z83 = c_roll * z78
        z84 = c1 * z83
        z85 = 1.0 + z84
        z86 = k10 * z84
        z87 = c_steer * z86 - s_steer * z80
        z88 = s1 * z83
        z89 = s_steer * z79 + c_steer * z88
        z90 = k57 * z85 + (k45 * z87 + k53 * z89)
        z91 = c_steer * z79 - s_steer * z88
        z92 = c_steer * z80 + s_steer * z86
        z93 = z14 * z79
        z94 = k56 * z91 - (k42 * z92 - k45 * z93)
        z95 = k53 * z85 + (k42 * z87 + k52 * z89)
        z96 = k40 * z93 + k45 * z91
        z97 = k45 * z85 + (k40 * z87 + k42 * z89)
        z98 = k40 * z92 - k42 * z91
        z99 = k34 * z88 + k35 * z84
        z100 = z80 * k26 - z79 * k27
        z101 = z81 * k26 + z79 * k28
        z102 = z40 * (z16 * z77 + z15 * z76) + z91
        z103 = k38 * z84 + k35 * z88
        s8 = z88 * z99 + (z80 * z100 + (z81 * z101 + F_yy * (z102 * z102)))
        z104 = z92 * z98 + (s8 + z84 * z103)
        s9 = z91 * z94 + (z89 * z95 + (z93 * z96 + (z87 * z97 + z104)))
        z105 = z79 * (z82 + R_yy * z79) + (z85 * z90 + s9)
        s10 = z88 * z72 + (z80 * z71 + (z81 * z70 + F_yy * (z102 * z62)))
        z106 = z92 * z69 + (z84 * z56 + s10)
        s11 = z91 * z65 + (z89 * z66 + (z93 * z67 + (z87 * z68 + z106)))
        z107 = z79 * z55 + (z85 * z60 + s11)
        z108 = 1.0 / z74
        z109 = z107 * z108
        z110 = z105 - z107 * z109
        # the mass matrix is singular
        if not abs(z110) > 1e-14 * z105:
            raise _refuse(abs(z110), 1e-14 * z105, 2, "rhs")
        z111 = s_steer * z20
        z112 = z40 * (z13 * z24 - z15 * (z18 * z111))
        z113 = c_roll * z112
        z114 = c1 * z113
        z115 = k10 * z114
        z116 = e2z * z112
        z117 = 1.0 - z116
        z118 = z20 * z117
        z119 = c_steer * z115 - s_steer * z118
        z120 = s1 * z113
        z121 = s_steer * z116 - c_steer * z120
        z122 = c_steer * z116 + s_steer * z120
        z123 = c_steer * z118 + s_steer * z115
        z124 = z13 * z117
        z125 = z124 - k10 * z116
        s12 = z118 * (k26 * z118 + k27 * z116)
        s13 = s12 + z124 * (k26 * z124 - k28 * z116)
        z126 = z120 * (k34 * z120 + k35 * z114) + s13
        s14 = z116 * (k37 * z116 + (k27 * z118 - k28 * z124)) + z126
        z127 = z114 * (k35 * z120 + k38 * z114) + s14
        s15 = z119 * (k45 * z114 + (k40 * z119 - k42 * z121))
        z128 = s15 + (z123 * (k40 * z123 + k42 * z122) + z127)
        s16 = z121 * (k53 * z114 + (k42 * z119 - k52 * z121))
        z129 = s16 - (z125 * (k40 * z125 - k45 * z122) + z128)
        s17 = z122 * (k56 * z122 + (k42 * z123 - k45 * z125)) - z129
        z130 = z114 * (k57 * z114 + (k45 * z119 - k53 * z121)) + s17
        s18 = z40 * (z15 * (c_steer * z20 * z28 + z34 * z111) - z13 * z35)
        z131 = s18 + z122
        z132 = z130 + R_yy * (z117 * z117) + F_yy * (z131 * z131)
        z133 = F_yy * z131
        z134 = R_yy * z117
        s19 = z118 * z71 + (z124 * z70 - (z133 * z62 - z134 * z51))
        z135 = z116 * z54 - (z120 * z72 + s19)
        s20 = z121 * z66 - (z125 * z67 + (z119 * z68 + (z123 * z69 - z135)))
        z136 = z114 * z61 - (z122 * z65 + s20)
        z137 = z136 * z108
        s21 = z101 * z124 + (z79 * z134 - z102 * z133 - z107 * z137)
        z138 = z99 * z120 + (z100 * z118 + s21)
        s22 = z96 * z125 + (z97 * z119 + (z98 * z123 - (z82 * z116 - z138)))
        z139 = z94 * z122 + (z95 * z121 - s22)
        z140 = z114 * (z103 + z90) - z139
        z141 = 1.0 / z110
        z142 = z140 * z141
        z143 = z132 - z136 * z137 - z140 * z142
        # the mass matrix is singular
        if not abs(z143) > 1e-14 * z132:
            raise _refuse(abs(z143), 1e-14 * z132, 2, "rhs")
        c_yaw = math.cos(yaw)
        z144 = roll_dot * c1
        z145 = s_steer * z144
        z146 = thR_dot * z13 - z8 * z145
        z147 = roll_dot * s1
        z148 = steer_dot + z147
        z149 = c_steer * z144
        z150 = thR_dot * z20
        v2_x = roll_dot * z39
        z151 = k10 * z147 + v2_x
        z152 = z148 * z8 - (z21 * z149 - (s_steer * z150 + c_steer * z151))
        z153 = z18 * z152
        z154 = z21 * z145 + (c_steer * z150 - s_steer * z151)
        z155 = z28 * z154 + z34 * z152
        z156 = z40 * (z29 * z146 - z16 * z153 + z7 * z155)
        z157 = z30 * z152 - z23 * z154
        z158 = z40 * (z24 * z146 - z15 * z153 - z7 * z157)
        w2 = z156 - e2z * z158
        z159 = thR_dot + w2
        z160 = z13 * z159
        z161 = z20 * z159
        z162 = s1 * z160 + c1 * z161
        s_yaw = math.sin(yaw)
        z163 = c_roll * v2_x
        z164 = z40 * (z35 * z146 - (z16 * z157 + z15 * z155))
        z165 = c1 * z156
        z166 = roll_dot * z165
        z167 = c_roll * z158
        z168 = s1 * z156
        z169 = roll_dot * e2z
        z170 = steer_dot * c_steer
        z171 = z169 * c1 + c_roll * z168
        z172 = roll_dot * c_roll
        z173 = steer_dot * s_steer
        z174 = z169 * s1 - c_roll * z165
        z175 = s_steer * z172 + e2z * z170 + (z173 * z3 + c_steer * z174)
        z176 = (z2 * z171 - z4 * z175) * (z5 * (z5 * z5))
        z177 = r_F * z5
        z178 = z6 * z176 + z177 * z175
        z179 = z11 * (c_roll * z169) * (z11 * z11)
        z180 = z12 * z179 - z38 * z174
        z181 = z180 - (z173 * z8 - c_steer * z178)
        s23 = c_roll * (z9 * z165 + s1 * (z170 * z8 + s_steer * z178))
        z182 = s23 - (z169 * z10 - (z172 * z15 + e2z * z181))
        z183 = z145 - z164
        z184 = roll_dot * z168
        z185 = z170 * z144 - s_steer * z184
        s24 = z178 * z183 + (z8 * z185 - (thR_dot * z180 + z156 * z181))
        z186 = z158 * z182 + s24
        z187 = z17 * z176 - z177 * z171
        s25 = c1 * (z173 * k10 - z178) - (z25 * z165 - z26 * z168)
        z188 = s1 * (z173 * z21 - c_steer * z187) + s25
        z189 = z19 * z179 - z38 * z171
        z190 = z189 - z187
        z191 = z170 * z22 + s_steer * z190
        z192 = thR_dot * z189
        z193 = k10 * z166
        s26 = z156 * z191 + (s_steer * z192 + c_steer * z193)
        z194 = z149 * z187 + (z173 * z151 - (z148 * z178 + s26))
        s27 = c_roll * z188 + (z169 * z27 - (z172 * z23 + e2z * z191))
        s28 = z21 * (z173 * z144 + c_steer * z184) + (z170 * z150 - z194)
        z195 = z158 * s27 + (z8 * z166 + s28)
        z196 = z18 * z195
        s29 = z31 * z165 - (z32 * z168 - k10 * (z170 * c1))
        z197 = s1 * (z170 * z21 + s_steer * z187) + s29
        z198 = z173 * z22 - c_steer * z190
        s30 = z156 * z198 - (c_steer * z192 - s_steer * z193)
        z199 = z21 * z185 - (z173 * z150 + (z170 * z151 + s30))
        s31 = c_roll * z197 - (z169 * z33 + (z172 * z30 - e2z * z198))
        z200 = z158 * s31 + (z187 * z183 + z199)
        z201 = z30 * z195 - z23 * z200
        z202 = z40 * (z24 * z186 + z15 * z196 + z7 * z201)
        z203 = z169 * z158 + c_roll * z202
        z204 = z166 + (z167 * z168 + c1 * z203)
        z205 = z147 - c1 * z167
        z206 = z144 + s1 * z167
        z207 = z161 * z205 - z160 * z206
        z208 = k27 * w2
        z209 = k28 * w2
        z210 = z184 - (z167 * z165 - s1 * z203)
        s32 = z205 * z208 - (e2z * k61 - z206 * z209) + k27 * z210
        z211 = k28 * z204 - (k26 * z207 - s32)
        z212 = z28 * z200 + z34 * z195
        s33 = z40 * (z29 * z186 + z16 * z196 - z7 * z212)
        z213 = s33 + (z172 * z158 - e2z * z202)
        z214 = z159 * z189 - z20 * z213 + (w2 * z160 + v2_x * z205)
        z215 = z159 * z180 - z13 * z213 - (w2 * z161 + v2_x * z206)
        z216 = k34 * z206 - k35 * z205
        z217 = k38 * z205 - k35 * z206
        s34 = k37 * z213 + (k27 * z214 - k28 * z215)
        z218 = z3 * k63 + z2 * k62 - (s34 - (z205 * z216 - z206 * z217))
        z219 = R_yy * z213
        z220 = z218 - z219
        z221 = R_yy * z159 + k37 * w2
        s35 = k38 * z204 - (k28 * z207 - k35 * z210)
        z222 = e2z * k62 - (z206 * z221 - w2 * z216 + s35)
        h2z = e2z * c_steer + s_steer * z3
        z223 = s_steer * w2 + c_steer * z206
        z224 = c_steer * w2 - s_steer * z206
        z225 = F_yy * (z164 + z224) + k56 * z224
        w3_steer = steer_dot + z205
        z226 = k52 * z223 - k53 * w3_steer
        z227 = k10 * w2
        z228 = z207 - (z227 * z206 + k10 * z204)
        z229 = k10 * z205
        z230 = w2 * z227 + z205 * z229 + z214
        z231 = c_steer * z228 - s_steer * z230
        z232 = z170 * w2 - s_steer * z213 - (z173 * z206 + c_steer * z210)
        s36 = k57 * z204 - (k45 * z231 + k53 * z232)
        z233 = h2z * k66 + (z223 * z225 - z224 * z226 + s36)
        z234 = z222 - z233
        z235 = z173 * w2 + c_steer * z213 + (z170 * z206 - s_steer * z210)
        z236 = c_steer * z230 + s_steer * z228
        z237 = z215 - (z206 * z229 + k10 * z213)
        z238 = k57 * w3_steer - k53 * z223
        s37 = k42 * z236 - (k45 * z237 + (w3_steer * z226 - z223 * z238))
        z239 = z4 * k65 + (k56 * z235 + s37)
        z240 = z2 * k66 + z239
        s38 = k53 * z204 - (k42 * z231 + k52 * z232)
        z241 = h2z * k65 - (s38 + (w3_steer * z225 - z224 * z238))
        z242 = k42 * z223 - k45 * w3_steer
        z243 = k42 * z224
        s39 = z223 * z242 + z224 * z243 + (k40 * z237 - k45 * z235)
        z244 = z2 * k64 + s39
        z245 = k45 * z224
        s40 = k45 * z204 - (k40 * z231 + k42 * z232)
        z246 = h2z * k64 - (w3_steer * z243 + z223 * z245 + s40)
        s41 = z224 * z245 - w3_steer * z242 + (k40 * z236 + k42 * z235)
        z247 = z4 * k64 + s41
        s42 = k35 * z204 - (k27 * z207 - k34 * z210)
        z248 = e2z * k63 - (s42 + (z205 * z221 - w2 * z217))
        z249 = k27 * z206 - k28 * z205
        s43 = z206 * z249 + w2 * z208 + (k26 * z215 - k28 * z213)
        z250 = z2 * k61 + s43
        s44 = w2 * z209 - z205 * z249 + (k26 * z214 + k27 * z213)
        z251 = z3 * k61 - s44
        z252 = F_yy * (z40 * (z35 * z186 + (z16 * z201 + z15 * z212)) + z235)
        s45 = z50 * z248 - (z53 * z250 - (z52 * z251 + z62 * z252))
        z253 = z58 * z246 + (z63 * z247 - s45)
        s46 = z49 * z234 - (z62 * z240 - (z59 * z241 + (z64 * z244 + z253)))
        z254 = z39 * z211 - (z51 * z220 + s46)
        s47 = z80 * z251 - (z81 * z250 + (z254 * z109 - z102 * z252))
        z255 = z84 * z222 + (z88 * z248 - s47)
        s48 = z89 * z241 + (z93 * z244 + (z87 * z246 + (z92 * z247 + z255)))
        z256 = z85 * z233 + (z91 * z240 - s48)
        z257 = z79 * z220 - z256
        s49 = z254 * z137 - (z142 * z257 + (z117 * z219 - z131 * z252))
        z258 = z118 * z251 - (z124 * z250 + s49)
        s50 = z123 * z247 - (z116 * z218 - (z120 * z248 - z258))
        z259 = z121 * z241 - (z125 * z244 + (z119 * z246 + s50))
        z260 = (z114 * z234 + (z122 * z240 - z259)) / z143
        z261 = z141 * z257 - z142 * z260
        dydt: list[float] = [
            # x' (I.2.15)
            -(c_yaw * z162 + s_yaw * z163),
            # y' (I.2.15)
            c_yaw * z163 - s_yaw * z162,
            # z' (I.2.15)
            e2z * v2_x,
            # yaw' (I.2.15)
            -z158,
            # roll' (I.2.15)
            roll_dot,
            # pitch' (I.2.15)
            z156,
            # steer' (I.2.15)
            steer_dot,
            # thR' (I.2.15)
            thR_dot,
            # thF' (I.2.15)
            z164,
            # roll'' (I.2.15) 112:4
            -(z254 * z108 + z109 * z261 + z137 * z260),
            # steer'' (I.2.15) 112:4
            z261,
            # thR'' (I.2.15) 112:4
            -z260,
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
    thR_dot = float(y[11])
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
        z13 = z4 * z5
        z14 = z4 * z9
        z15 = k4 + z13
        z16 = z14 - z15
        z17 = s_steer * z16
        z18 = z13 * z17
        z19 = s1 * z15
        s2 = c_roll * (c_steer * z19 + c1 * (c_steer * k3 + z7))
        z20 = s2 + e2z * z17
        z21 = z13 * z20
        z22 = c_steer * z16
        z23 = c_roll * (s_steer * z19 + k3 * (s_steer * c1)) - e2z * z22
        z24 = z22 * z20 + z23 * z17
        z25 = z12 * z18 - z11 * z21 - z6 * z24
        z26 = k5 * (9.0 + abs(z8))
        s3 = (z26 + k12) * (z26 + k13)
        # the coframe is singular
        if not abs(z25) > 1e-15 * (k10 * s3):
            raise _refuse(abs(z25), 1e-15 * (k10 * s3), 1, "velocities")
        c_yaw = math.cos(yaw)
        z27 = 1.0 / z25
        z28 = roll_dot * s1
        z29 = steer_dot + z28
        z30 = roll_dot * c1
        z31 = c_steer * z30
        z32 = thR_dot * z14
        v2_x = c_roll * (roll_dot * z9)
        z33 = k3 * z28 + v2_x
        s4 = k4 * z31 - k2 * z29 - (s_steer * z32 + c_steer * z33)
        z34 = z29 * z6 - z31 * z13 - s4
        z35 = z13 * z34
        z36 = s_steer * z30
        z37 = z36 * z6 + (k2 * z36 - thR_dot * z10)
        z38 = z36 * z13 + (k4 * z36 - (s_steer * z33 - c_steer * z32))
        z39 = z20 * z38 + z23 * z34
        z40 = z27 * (z12 * z35 + z21 * z37 - z6 * z39)
        z41 = z22 * z34 - z17 * z38
        z42 = z27 * (z18 * z37 + z11 * z35 + z6 * z41)
        z43 = (thR_dot - (z40 - e2z * z42)) * (s1 * z10 + c1 * z14)
        s_yaw = math.sin(yaw)
        z44 = c_roll * v2_x
        qdot: list[float] = [
            # x' (I.2.4)
            -(c_yaw * z43 + s_yaw * z44),
            # y' (I.2.4)
            c_yaw * z44 - s_yaw * z43,
            # z' (I.2.4)
            e2z * v2_x,
            # yaw' (I.2.4)
            z42,
            # roll' (I.2.4)
            roll_dot,
            # pitch' (I.2.4)
            -z40,
            # steer' (I.2.4)
            steer_dot,
            # thR' (I.2.4)
            thR_dot,
            # thF' (I.2.4)
            -z27 * (z12 * z41 + z11 * z39 + z24 * z37),
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
    thR_dot = float(y[11])
    w = float(p[0])  # wheelbase [m]
    c = float(p[1])  # trail [m]
    lam = float(p[2])  # tilt of the steering axis, 18 degrees [rad]
    r_R = float(p[4])  # radius of the rear wheel [m]
    r_F = float(p[22])  # radius of the front wheel [m]
    roll_ddot = float(dydt[9])  # roll''
    steer_ddot = float(dydt[10])  # steer''
    thR_ddot = float(dydt[11])  # thR''
    try:
        # parameters only
        s_lam = math.sin(lam)
        c_lam = math.cos(lam)
        k1 = w + c
        k2 = r_F * s_lam - c * c_lam
        k3 = c_lam * k1 - r_R * s_lam
        k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam)
        # state
        c_roll = math.cos(roll)
        z1 = 1.0 / abs(c_roll)
        z2 = roll_dot * r_R
        z3 = c_roll * z2
        v2_x = z1 * z3
        z4 = c_roll * v2_x
        c_yaw = math.cos(yaw)
        z5 = pitch + lam
        s1 = math.sin(z5)
        s_steer = math.sin(steer)
        c1 = math.cos(z5)
        z6 = c_roll * c1
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        z7 = c_roll * s1
        z8 = e2z * s_steer - c_steer * z7
        z9 = 1.0 / math.sqrt(z6 * z6 + z8 * z8)
        z10 = r_F * z8
        z11 = z9 * z10
        z12 = k2 + z11
        z13 = s_steer * z12
        z14 = s1 * z13
        z15 = r_R * z7
        z16 = z1 * z15
        z17 = k3 + z16 + c_steer * z12
        z18 = c_roll * z14 + e2z * z17
        z19 = r_F * z6
        z20 = z9 * z19
        z21 = r_R * z6
        z22 = z1 * z21
        z23 = k4 + z20
        z24 = z22 - z23
        z25 = s_steer * z24
        z26 = z20 * z25
        z27 = c_steer * z23
        z28 = c_steer * k3 + z12
        z29 = s1 * z27 + c1 * z28
        z30 = c_roll * z29 + e2z * z25
        z31 = z20 * z30
        z32 = c_steer * z24
        z33 = s_steer * z23
        z34 = s_steer * k3
        z35 = s1 * z33 + c1 * z34
        z36 = c_roll * z35 - e2z * z32
        z37 = z32 * z30 + z36 * z25
        z38 = 1.0 / (z18 * z26 - z17 * z31 - z11 * z37)
        z39 = roll_dot * c1
        z40 = s_steer * z39
        z41 = z11 * z40 + (k2 * z40 - thR_dot * z16)
        z42 = roll_dot * s1
        z43 = steer_dot + z42
        z44 = c_steer * z39
        z45 = thR_dot * z22
        z46 = v2_x + k3 * z42
        s2 = k4 * z44 - k2 * z43 - (s_steer * z45 + c_steer * z46)
        z47 = z11 * z43 - z20 * z44 - s2
        z48 = z20 * z47
        z49 = z20 * z40 + (k4 * z40 - (s_steer * z46 - c_steer * z45))
        z50 = z32 * z47 - z25 * z49
        z51 = z26 * z41 + z17 * z48 + z11 * z50
        z52 = z38 * z51
        z53 = c_yaw * z52
        s_yaw = math.sin(yaw)
        z54 = roll_dot * e2z
        z55 = z1 * (c_roll * z54) * (z1 * z1)
        z56 = z3 * z55 - z1 * (z54 * z2 - r_R * (c_roll * roll_ddot))
        z57 = z54 * v2_x - c_roll * z56
        z58 = s_yaw * z52
        z59 = z30 * z49 + z36 * z47
        z60 = z18 * z48 + z31 * z41 - z11 * z59
        z61 = z38 * z60
        z62 = thR_dot - (z61 - e2z * z52)
        z63 = z16 * z62
        z64 = s1 * z63 + z62 * (c1 * z22)
        z65 = c1 * z61
        z66 = z63 * z65
        z67 = z54 * s1 + c_roll * z65
        z68 = r_R * z1
        z69 = z15 * z55 - z67 * z68
        z70 = steer_dot * c_steer
        z71 = s1 * z61
        z72 = z54 * c1 - c_roll * z71
        z73 = roll_dot * c_roll
        z74 = steer_dot * s_steer
        z75 = s_steer * z73 + e2z * z70 + (z74 * z7 + c_steer * z67)
        z76 = (z6 * z72 - z8 * z75) * (z9 * (z9 * z9))
        z77 = r_F * z9
        z78 = z10 * z76 + z77 * z75
        z79 = z69 - (z74 * z12 - c_steer * z78)
        s3 = c_roll * (z13 * z65 - s1 * (z70 * z12 + s_steer * z78))
        z80 = z54 * z14 + s3 - (z73 * z17 + e2z * z79)
        z81 = z19 * z76 - z77 * z72
        z82 = z21 * z55 - z72 * z68
        z83 = z82 - z81
        z84 = z70 * z24 + s_steer * z83
        z85 = z25 * z81 + z20 * z84
        s4 = z27 * z65 + s1 * (z74 * z23 - c_steer * z81)
        z86 = s4 - (z28 * z71 - c1 * (z74 * k3 - z78))
        z87 = z54 * z29 + c_roll * z86 - (z73 * z25 + e2z * z84)
        z88 = z30 * z81 - z20 * z87
        z89 = z74 * z24 - c_steer * z83
        s5 = z33 * z65 - s1 * (z70 * z23 + s_steer * z81)
        z90 = s5 - (z34 * z71 + k3 * (z70 * c1))
        z91 = z54 * z35 + c_roll * z90 + (z73 * z32 - e2z * z89)
        z92 = z30 * z89 + z32 * z87 + (z25 * z91 - z36 * z84)
        s6 = z26 * z80 - z18 * z85 + (z31 * z79 + z17 * z88)
        z93 = s6 + (z37 * z78 - z11 * z92)
        z94 = z38 * z38 * z93
        z95 = roll_dot * z65 - s1 * roll_ddot
        z96 = steer_ddot - z95
        z97 = roll_dot * z71 + c1 * roll_ddot
        z98 = z74 * z39 - c_steer * z97
        z99 = z22 * thR_ddot + thR_dot * z82
        z100 = k3 * z95 - z56
        s7 = z70 * z45 + s_steer * z99 - (z74 * z46 + c_steer * z100)
        z101 = k4 * z98 + k2 * z96 + s7
        z102 = z11 * z96 + z43 * z78 + (z20 * z98 - z44 * z81) + z101
        z103 = z47 * z81 + z20 * z102
        z104 = z70 * z39 + s_steer * z97
        s8 = k2 * z104 - (z16 * thR_ddot + thR_dot * z69)
        z105 = z11 * z104 + z40 * z78 + s8
        s9 = z70 * z46 - s_steer * z100 + (z74 * z45 - c_steer * z99)
        z106 = z20 * z104 + z40 * z81 + (k4 * z104 - s9)
        z107 = z49 * z87 - z30 * z106 + (z47 * z91 - z36 * z102)
        s10 = z48 * z80 - z18 * z103 - (z41 * z88 + z31 * z105)
        z108 = s10 + (z59 * z78 - z11 * z107)
        z109 = z60 * z94 - z38 * z108
        z110 = z47 * z89 - z32 * z102 + (z49 * z84 + z25 * z106)
        s11 = z41 * z85 + z26 * z105 + (z48 * z79 + z17 * z103)
        z111 = s11 + (z50 * z78 - z11 * z110)
        z112 = z51 * z94 + z38 * z111
        z113 = thR_ddot - (z109 - (z73 * z52 + e2z * z112))
        s12 = z66 - s1 * (z62 * z69 + z16 * z113)
        z114 = s12 - (z66 + c1 * (z62 * z82 + z22 * z113))
        s13 = z50 * z80 + z18 * z110 - (z59 * z79 - z17 * z107)
        z115 = s13 + (z41 * z92 - z37 * z105)
        qddot: list[float] = [
            # x'' (I.2.15)
            z58 * z64 + c_yaw * z114 - (z4 * z53 - s_yaw * z57),
            # y'' (I.2.15)
            -(z53 * z64 - s_yaw * z114 + (z4 * z58 + c_yaw * z57)),
            # z'' (I.2.15)
            z73 * v2_x + e2z * z56,
            # yaw'' (I.2.15)
            z112,
            # roll'' (I.2.15)
            roll_ddot,
            # pitch'' (I.2.15)
            -z109,
            # steer'' (I.2.15)
            steer_ddot,
            # thR'' (I.2.15)
            thR_ddot,
            # thF'' (I.2.15)
            z38 * z115 - (z18 * z50 + z17 * z59 + z37 * z41) * z94,
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
    thR_dot = float(qdot[7])
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
            thR_dot,
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
    thR_dot = float(y[11])
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
    thR_ddot = float(dydt[11])  # thR''
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
        s2 = c_lam * (k22 + c_lam * k8) + s_lam * (k20 + s_lam * k7)
        k29 = k27 + s2
        k30 = m_F * k16
        k31 = m_H + m_F
        k32 = m_H * k15
        k33 = k30 + k32
        k34 = m_F * k4
        k35 = m_H * k9
        k36 = k34 - k35
        k37 = H_xz * c_lam
        k38 = s_lam * k5 - k37
        k39 = H_xz * s_lam
        k40 = c_lam * k6 - k39
        k41 = k16 * k30
        k42 = k15 * k32
        k43 = s_lam * k38 + c_lam * k40 + k41 + k42
        k44 = c_lam * k38 - s_lam * k40 + k4 * k30 - k9 * k32
        k45 = k4 * k34
        k46 = k9 * k35
        k47 = k42 + (k41 + (H_yy + k45) + k46)
        s3 = c_lam * (k39 + c_lam * k5) + s_lam * (k37 + s_lam * k6)
        k48 = k46 + (k45 + s3)
        k49 = g * m_F
        k50 = g * m_H
        k51 = g * m_B
        k52 = g * k17
        k53 = k12 * k51
        k54 = k11 * k51
        k55 = k9 * k50
        k56 = k15 * k50
        k57 = g * k31
        k58 = k4 * k49
        k59 = k16 * k49
        k60 = k56 + k59
        k61 = k55 - k58
        # state
        s_yaw = math.sin(yaw)
        e2z = math.sin(roll)
        z1 = pitch + lam
        s1 = math.sin(z1)
        c_roll = math.cos(roll)
        z2 = c_roll * s1
        s_steer = math.sin(steer)
        c1 = math.cos(z1)
        z3 = c_roll * c1
        c_steer = math.cos(steer)
        z4 = e2z * s_steer - c_steer * z2
        z5 = 1.0 / math.sqrt(z3 * z3 + z4 * z4)
        z6 = r_F * z4
        z7 = z5 * z6
        z8 = k4 + z7
        z9 = s_steer * z8
        z10 = s1 * z9
        z11 = 1.0 / abs(c_roll)
        z12 = r_R * z2
        z13 = z11 * z12
        z14 = k10 + z13
        z15 = z14 + c_steer * z8
        z16 = c_roll * z10 + e2z * z15
        z17 = r_F * z3
        z18 = z5 * z17
        z19 = r_R * z3
        z20 = z11 * z19
        z21 = k16 + z18
        z22 = z20 - z21
        z23 = s_steer * z22
        z24 = z18 * z23
        z25 = c_steer * z21
        z26 = c_steer * k10 + z8
        z27 = s1 * z25 + c1 * z26
        z28 = c_roll * z27 + e2z * z23
        z29 = z18 * z28
        z30 = c_steer * z22
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z30
        z35 = z30 * z28 + z34 * z23
        z36 = 1.0 / (z16 * z24 - z15 * z29 - z7 * z35)
        z37 = roll_dot * c1
        z38 = s_steer * z37
        z39 = z7 * z38 + (k4 * z38 - thR_dot * z13)
        z40 = roll_dot * s1
        z41 = steer_dot + z40
        z42 = c_steer * z37
        z43 = thR_dot * z20
        z44 = r_R * z11
        z45 = c_roll * z44
        v2_x = roll_dot * z45
        z46 = k10 * z40 + v2_x
        s4 = k16 * z42 - k4 * z41 - (s_steer * z43 + c_steer * z46)
        z47 = z7 * z41 - z18 * z42 - s4
        z48 = z18 * z47
        z49 = z18 * z38 + (k16 * z38 + (c_steer * z43 - s_steer * z46))
        z50 = z28 * z49 + z34 * z47
        z51 = z36 * (z29 * z39 + z16 * z48 - z7 * z50)
        z52 = z30 * z47 - z23 * z49
        z53 = z36 * (z24 * z39 + z15 * z48 + z7 * z52)
        z54 = z51 - e2z * z53
        z55 = k19 * z54
        z56 = c_roll * z53
        z57 = z40 + c1 * z56
        z58 = z37 - s1 * z56
        z59 = k18 * z58 - k19 * z57
        z60 = thR_dot - z54
        z61 = roll_dot * e2z
        z62 = z11 * (c_roll * z61) * (z11 * z11)
        z63 = s1 * z51
        z64 = z61 * c1 - c_roll * z63
        z65 = z19 * z62 - z44 * z64
        z66 = roll_dot * c_roll
        z67 = steer_dot * c_steer
        z68 = steer_dot * s_steer
        z69 = c1 * z51
        z70 = z61 * s1 + c_roll * z69
        z71 = s_steer * z66 + e2z * z67 + (z68 * z2 + c_steer * z70)
        z72 = z5 * (z5 * z5) * (z3 * z64 - z4 * z71)
        z73 = r_F * z5
        z74 = z6 * z72 + z73 * z71
        z75 = roll_dot * z63
        z76 = z67 * z37 + s_steer * z75
        z77 = z12 * z62 - z44 * z70
        z78 = z36 * (z35 * z39 + (z16 * z52 + z15 * z50))
        z79 = z77 - (z68 * z8 - c_steer * z74)
        s5 = c_roll * (z9 * z69 - s1 * (z67 * z8 + s_steer * z74))
        z80 = z61 * z10 + s5 - (z66 * z15 + e2z * z79)
        s6 = z38 * z74 + z7 * z76 + (k4 * z76 - thR_dot * z77)
        z81 = s6 + (z78 * z74 + (z53 * z80 + z51 * z79))
        z82 = z17 * z72 - z73 * z64
        s7 = z25 * z69 + s1 * (z68 * z21 - c_steer * z82)
        z83 = s7 - (z26 * z63 - c1 * (z68 * k10 - z74))
        z84 = z65 - z82
        z85 = z67 * z22 + s_steer * z84
        z86 = roll_dot * z69
        z87 = z68 * z37 - c_steer * z75
        z88 = thR_dot * z65
        z89 = k10 * z86
        s8 = z67 * z43 + s_steer * z88 - (z68 * z46 + c_steer * z89)
        z90 = k16 * z87 - k4 * z86 + s8
        s9 = z53 * (z61 * z27 + c_roll * z83 - (z66 * z23 + e2z * z85))
        s10 = z41 * z74 - z7 * z86 - (z42 * z82 - z18 * z87) + z90
        z91 = s9 + z51 * z85 - s10
        z92 = z18 * z91
        s11 = z31 * z69 - s1 * (z67 * z21 + s_steer * z82)
        z93 = s11 - (k10 * (z67 * c1) + z32 * z63)
        z94 = z68 * z22 - c_steer * z84
        s12 = z53 * (z61 * z33 + c_roll * z93 + (z66 * z30 - e2z * z94))
        z95 = z78 * z82 + (s12 + z51 * z94)
        s13 = z68 * z43 - c_steer * z88 + (z67 * z46 - s_steer * z89)
        z96 = z38 * z82 + z18 * z76 + (k16 * z76 - s13)
        z97 = z95 + z96
        z98 = z28 * z97 - z34 * z91
        z99 = z30 * z91 + z23 * z97
        z100 = z36 * (z24 * z81 - z15 * z92 - z7 * z99)
        s14 = z36 * (z29 * z81 - z16 * z92 - z7 * z98)
        z101 = s14 - (z66 * z53 + e2z * z100)
        z102 = z13 * z60
        z103 = z60 * z65 - z20 * z101 - (z54 * z102 - v2_x * z57)
        z104 = s_steer * z20
        z105 = z36 * (z13 * z24 - z15 * (z18 * z104))
        z106 = e2z * z105
        z107 = 1.0 - z106
        z108 = z20 * z107
        z109 = z18 * z8
        z110 = z34 * z8
        z111 = z30 * z8
        z112 = z36 * (z15 * z109 + z7 * z111)
        z113 = z36 * (z16 * z109 - z7 * z110) - e2z * z112
        z114 = z20 * z113
        z115 = s_steer * c1
        z116 = z8 * z115
        z117 = c_steer * c1
        z118 = k10 * s1 + z45
        z119 = s1 * z7 - z18 * z117 - (k16 * z117 - k4 * s1 - c_steer * z118)
        z120 = z18 * z119
        z121 = z18 * z115 + (k16 * z115 - s_steer * z118)
        s15 = z24 * z116 + z15 * z120 + z7 * (z30 * z119 - z23 * z121)
        z122 = z36 * s15
        s16 = z29 * z116 + z16 * z120 - z7 * (z28 * z121 + z34 * z119)
        z123 = z36 * s16 - e2z * z122
        z124 = z20 * z123
        z125 = thR_ddot * z108 - (z114 * steer_ddot + roll_ddot * z124)
        z126 = z113 * steer_ddot + roll_ddot * z123
        z127 = thR_ddot * z106 + z126
        s17 = z2 * k52 - (z54 * z55 - z57 * z59 + (k17 * z103 + k18 * z101))
        z128 = s17 - (k17 * z125 + k18 * z127)
        h2z = e2z * c_steer + s_steer * z2
        w3_steer = steer_dot + z57
        z129 = c_steer * z54 + s_steer * z58
        z130 = k33 * z129
        z131 = s_steer * z54 - c_steer * z58
        z132 = k36 * z129
        z133 = z61 * z53 - c_roll * z100
        z134 = z86 - (z56 * z63 - c1 * z133)
        z135 = z20 * z60
        z136 = z135 * z57 - z102 * z58
        z137 = k10 * z54
        z138 = z136 + (z137 * z58 + k10 * z134)
        z139 = k10 * z57
        z140 = z54 * z137 + z57 * z139 + z103
        z141 = c_steer * z138 - s_steer * z140
        z142 = z75 + (z56 * z69 + s1 * z133)
        z143 = z67 * z54 + s_steer * z101 + (z68 * z58 - c_steer * z142)
        s18 = k36 * z134 + (k31 * z141 - k33 * z143)
        z144 = h2z * k57 + (w3_steer * z130 - z131 * z132 + s18)
        z145 = c_roll * z105
        z146 = c1 * z145
        z147 = thR_ddot * z146
        z148 = c_roll * z112
        z149 = c1 * z148
        z150 = c_roll * z122
        z151 = s1 + c1 * z150
        z152 = roll_ddot * z151
        z153 = z147 - ((1.0 + z149) * steer_ddot + z152)
        z154 = k10 * z146
        z155 = k10 * z149
        z156 = z45 + k10 * z151
        s19 = (c_steer * z155 - s_steer * z114) * steer_ddot
        s20 = s19 + roll_ddot * (c_steer * z156 - s_steer * z124)
        z157 = thR_ddot * (c_steer * z154 - s_steer * z108) - s20
        z158 = s1 * z145
        z159 = s1 * z148
        z160 = c1 - s1 * z150
        s21 = (s_steer * z113 + c_steer * z159) * steer_ddot
        s22 = s21 + roll_ddot * (s_steer * z123 - c_steer * z160)
        z161 = thR_ddot * (s_steer * z106 - c_steer * z158) + s22
        z162 = z144 + (k36 * z153 + (k31 * z157 - k33 * z161))
        z163 = k33 * z131 + k36 * w3_steer
        z164 = c_steer * z140 + s_steer * z138
        z165 = z68 * z54 - c_steer * z101 - (z67 * z58 + s_steer * z142)
        s23 = (c_steer * z114 + s_steer * z155) * steer_ddot
        s24 = s23 + roll_ddot * (c_steer * z124 + s_steer * z156)
        z166 = thR_ddot * (c_steer * z108 + s_steer * z154) - s24
        z167 = c_steer * z106 + s_steer * z158
        z168 = c_steer * z113 - s_steer * z159
        z169 = roll_ddot * (c_steer * z123 + s_steer * z160)
        z170 = thR_ddot * z167 + (z168 * steer_ddot + z169)
        s25 = z129 * z132 + w3_steer * z163 + (k31 * z164 - k33 * z165)
        z171 = z4 * k57 + s25 + (k31 * z166 + k33 * z170)
        z172 = z128 + s_steer * z162 - c_steer * z171
        s26 = z36 * (z15 * (c_steer * z20 * z28 + z34 * z104) - z13 * z35)
        s27 = (z36 * (z16 * z111 + z15 * z110) + z168) * steer_ddot + z169
        z173 = thR_ddot * (s26 + z167) + s27
        s28 = z36 * (z35 * z81 - (z16 * z99 - z15 * z98)) - z165 + z173
        z174 = F_yy * s28
        z175 = z36 * z174
        z176 = z60 * z77 - z13 * z101 + (z54 * z135 - v2_x * z58)
        z177 = k25 * z58 - k26 * z57
        z178 = k29 * z57 - k26 * z58
        s29 = k28 * z101 + (k18 * z103 - k19 * z176)
        z179 = z2 * k54 + z3 * k53 - (s29 - (z57 * z177 - z58 * z178))
        z180 = z13 * z107
        z181 = thR_ddot * z180 - z13 * z126
        z182 = z176 - (z58 * z139 + k10 * z101)
        z183 = thR_ddot * (z180 - k10 * z106) - z14 * z126
        s30 = z131 * z163 + z129 * z130 + (k31 * z182 + k36 * z165)
        z184 = z3 * k57 + s30 + (k31 * z183 - k36 * z170)
        z185 = k43 * z131 + k44 * w3_steer
        z186 = k48 * w3_steer + k44 * z131
        s31 = k47 * z165 - (k33 * z164 - k36 * z182)
        s32 = z4 * k56 + z3 * k55 + (z4 * k59 - z3 * k58)
        z187 = s32 - (s31 - (w3_steer * z185 - z131 * z186))
        z188 = z187 + (k47 * z170 + (k33 * z166 - k36 * z183)) + z174
        z189 = F_yy * (z78 + z129) + k47 * z129
        s33 = k44 * z134 + (k33 * z141 - k43 * z143)
        z190 = h2z * k60 + (s33 + (w3_steer * z189 - z129 * z186))
        z191 = z190 + (k44 * z153 + (k33 * z157 - k43 * z161))
        s34 = z179 - (k28 * z127 + (k18 * z125 - k19 * z181)) + k10 * z184
        z192 = s34 - c_steer * z188 + s_steer * z191
        z193 = k18 * z54
        s35 = z58 * z59 + z54 * z193 + (k17 * z176 - k19 * z101)
        z194 = z3 * k52 + s35 + (k17 * z181 - k19 * z127)
        z195 = z194 + z184
        s36 = R_yy * (z101 - (thR_ddot * z107 - z126)) - z13 * z195
        z196 = z192 - (s36 + z20 * z172)
        z197 = z36 * z196
        z198 = z15 * z175 + z7 * z197
        z199 = R_yy * z60 - k28 * z54
        s37 = k26 * z134 + (k18 * z136 + k25 * z142)
        z200 = e2z * k54 + (s37 - (z57 * z199 + z54 * z178))
        z201 = z147 - (z149 * steer_ddot + z152)
        z202 = roll_ddot * z45
        z203 = thR_ddot * z158 - (z159 * steer_ddot - roll_ddot * z160)
        s38 = z200 + (k26 * z201 - (k18 * z202 - k25 * z203))
        z204 = s1 * (s38 + s_steer * z188 + c_steer * z191)
        s39 = k48 * z134 + (k36 * z141 - k44 * z143)
        z205 = h2z * k61 + (z131 * z189 - z129 * z185 - s39)
        s40 = k29 * z134 + (k19 * z136 + k26 * z142)
        z206 = e2z * k53 - (z58 * z199 + z54 * z177 - s40)
        z207 = c_steer * z162 + s_steer * z171
        s41 = z206 + (k29 * z201 - (k19 * z202 - k26 * z203)) + k10 * z207
        z208 = z205 - (k48 * z153 + (k36 * z157 - k44 * z161)) - s41
        z209 = z36 * (c_roll * (z204 - c1 * z208) - e2z * z196)
        z210 = z16 * z175 - z7 * z209
        z211 = z28 * z198 - z23 * z210
        z212 = z34 * z198 + z30 * z210 - z18 * (z16 * z197 + z15 * z209)
        z213 = c_steer * z211 + s_steer * z212
        z214 = z172 - z213
        z215 = z35 * z175 - z29 * z197 - z24 * z209
        z216 = z195 - z215
        z217 = s1 * z214 + c1 * z216
        s42 = k19 * z134 + (k17 * z136 + k18 * z142)
        z218 = e2z * k52 + (z57 * z193 + z58 * z55 + s42)
        z219 = s_steer * z211 - c_steer * z212
        s43 = z218 + (k19 * z201 - (k17 * z202 - k18 * z203)) + z207
        z220 = s43 + z219
        z221 = e2z * z217 - c_roll * z220
        c_yaw = math.cos(yaw)
        z222 = c1 * z214 - s1 * z216
        z223 = s1 * z213 + c1 * z215
        z224 = e2z * z223 + c_roll * z219
        z225 = c1 * z213 - s1 * z215
        lambda_: list[float] = [
            # reaction of rear_x: Q_i gains lambda_1 a_1i (I.4.1) 115:5
            c_yaw * z222 - s_yaw * z221,
            # reaction of rear_y: Q_i gains lambda_2 a_2i (I.4.1) 116:5
            c_yaw * z221 + s_yaw * z222,
            # reaction of rear_z: Q_i gains lambda_3 a_3i (I.4.1) 117:5
            -(c_roll * z217 + e2z * z220),
            # reaction of front_x: Q_i gains lambda_4 a_4i (I.4.1) 118:5
            c_yaw * z225 - s_yaw * z224,
            # reaction of front_y: Q_i gains lambda_5 a_5i (I.4.1) 119:5
            c_yaw * z224 + s_yaw * z225,
            # reaction of front_z: Q_i gains lambda_6 a_6i (I.4.1) 120:5
            e2z * z219 - c_roll * z223,
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
    thR_dot = float(y[11])
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
        e2z = math.sin(roll)
        s_steer = math.sin(steer)
        c_steer = math.cos(steer)
        z2 = s_pitch * c_lam + c_pitch * s_lam
        z3 = c_roll * z2
        z4 = e2z * s_steer - c_steer * z3
        z5 = c_pitch * c_lam - s_pitch * s_lam
        z6 = c_roll * z5
        z7 = c_lam * z4 + s_lam * z6
        z8 = c_lam * z6 - s_lam * z4
        s1 = z * m_R + m_B * (z - x_B * z1 + e3z * k1)
        z9 = s1 + m_H * (Sz - k3 * z7 + z_H * z8)
        z10 = r_F / math.sqrt(z6 * z6 + z4 * z4)
        z11 = z4 * z10
        z12 = k4 + z11
        z13 = r_R / abs(c_roll)
        z14 = z3 * z13
        z15 = k5 + z14 + c_steer * z12
        z16 = z12 * (s_steer * z3) + e2z * z15
        z17 = z6 * z10
        z18 = z6 * z13
        z19 = k6 + z17
        z20 = z18 - z19
        z21 = s_steer * z20
        z22 = z17 * z21
        z23 = z2 * z19
        s2 = c_roll * (c_steer * z23 + z5 * (c_steer * k5 + z12))
        z24 = s2 + e2z * z21
        z25 = z17 * z24
        z26 = c_steer * z20
        z27 = c_roll * (s_steer * z23 + k5 * (s_steer * z5)) - e2z * z26
        z28 = z26 * z24 + z27 * z21
        z29 = 1.0 / (z16 * z22 - z15 * z25 - z11 * z28)
        z30 = roll_dot * z2
        z31 = steer_dot + z30
        z32 = roll_dot * z5
        z33 = c_steer * z32
        z34 = thR_dot * z18
        z35 = roll_dot * c_roll
        v2_x = z35 * z13
        z36 = k5 * z30 + v2_x
        s3 = k6 * z33 - k4 * z31 - (s_steer * z34 + c_steer * z36)
        z37 = z31 * z11 - z33 * z17 - s3
        z38 = s_steer * z32
        z39 = z38 * z17 + (k6 * z38 - (s_steer * z36 - c_steer * z34))
        z40 = z26 * z37 - z21 * z39
        z41 = z24 * z39 + z27 * z37
        z42 = z38 * z11 + (k4 * z38 - thR_dot * z14)
        z43 = z17 * z37
        z44 = z29 * (z16 * z43 + z25 * z42 - z11 * z41)
        z45 = z29 * (z22 * z42 + z15 * z43 + z11 * z40)
        z46 = z44 - e2z * z45
        w1 = roll_dot * c_pitch - z1 * z45
        w3 = roll_dot * s_pitch + e3z * z45
        z47 = c_lam * w1 - s_lam * w3
        z48 = c_steer * z46 + s_steer * z47
        z49 = z29 * (z16 * z40 + z15 * z41 + z28 * z42) + z48
        z50 = s_steer * z46 - c_steer * z47
        ws = steer_dot + (s_lam * w1 + c_lam * w3)
        z51 = c_lam * z50 - s_lam * ws
        z52 = z51 * z51
        o3 = c_lam * ws + s_lam * z50
        z53 = o3 * o3
        s_yaw = math.sin(yaw)
        z54 = s_yaw * z45
        c_yaw = math.cos(yaw)
        z55 = s_pitch * z44
        z56 = c_yaw * z45
        z57 = s_yaw * z35 + e2z * z56
        z58 = s_yaw * e2z
        z59 = c_pitch * z44
        z60 = c_pitch * z54 - c_yaw * z55 + (s_pitch * z57 - z58 * z59)
        z61 = s_pitch * z54 + c_yaw * z59 - (z58 * z55 + c_pitch * z57)
        z62 = s_lam * z60 + c_lam * z61
        z63 = steer_dot * s_steer
        s4 = (c_yaw * c_pitch - z58 * s_pitch) * c_lam
        s5 = (s4 - (c_yaw * s_pitch + c_pitch * z58) * s_lam) * z63
        z64 = s5 + c_steer * (c_lam * z60 - s_lam * z61)
        z65 = steer_dot * c_steer
        z66 = c_roll * z65
        z67 = roll_dot * e2z
        z68 = z64 + (s_yaw * z66 - s_steer * (s_yaw * z67 - c_roll * z56))
        z69 = c_lam * z62 - s_lam * z68
        z70 = c_lam * z68 + s_lam * z62
        z71 = c_roll * v2_x
        z72 = thR_dot - z46
        z73 = z72 * (z2 * z14 + z5 * z18)
        z74 = s_yaw * z71 + c_yaw * z73
        z75 = r_R * z61 + (k2 * z60 + z74)
        z76 = r_F * z69 + (c * z70 - z75)
        z77 = c_yaw * e2z
        z78 = c_yaw * z35 - e2z * z54
        z79 = s_yaw * z55 + c_pitch * z56 - (z77 * z59 - s_pitch * z78)
        z80 = s_pitch * z56 - s_yaw * z59 - (z77 * z55 + c_pitch * z78)
        z81 = s_lam * z79 + c_lam * z80
        s6 = (c_pitch * s_yaw + s_pitch * z77) * c_lam
        s7 = (s6 - (s_yaw * s_pitch - c_pitch * z77) * s_lam) * z63
        z82 = s7 - c_steer * (c_lam * z79 - s_lam * z80)
        z83 = z82 - (c_yaw * z66 - s_steer * (c_yaw * z67 + c_roll * z54))
        z84 = c_lam * z81 + s_lam * z83
        z85 = c_lam * z83 - s_lam * z81
        z86 = c_yaw * z71 - s_yaw * z73
        z87 = r_R * z80 + (k2 * z79 + z86)
        z88 = r_F * z84 - (c * z85 + z87)
        z89 = c_pitch * z67 - c_roll * z55
        z90 = e2z * v2_x
        z91 = s_pitch * z67 + c_roll * z59
        z92 = r_R * z89 - (z90 + k2 * z91)
        z93 = s_lam * z91 - c_lam * z89
        s8 = z63 * z3 + c_steer * (c_lam * z91 + s_lam * z89)
        z94 = s_steer * z35 + e2z * z65 + s8
        z95 = s_lam * z93 + c_lam * z94
        z96 = c_lam * z93 - s_lam * z94
        z97 = z92 + c * z95 + r_F * z96
        s9 = m_F * (z76 * z76 + z88 * z88 + z97 * z97)
        z98 = F_yy * (z49 * z49) + (F_xx * (z52 + z53) + s9)
        z99 = z_H * z69 - (k3 * z70 - z75)
        z100 = z_H * z84 + (k3 * z85 + z87)
        z101 = z92 + k3 * z95 - z_H * z96
        s10 = m_H * (z99 * z99 + z100 * z100 + z101 * z101)
        z102 = H_xx * z52 + H_yy * (z48 * z48) + H_zz * z53 + s10
        z103 = w1 * w1
        z104 = w3 * w3
        s11 = m_R * (z74 * z74 + z86 * z86 + z90 * z90)
        z105 = R_yy * (z72 * z72) + (R_xx * (z103 + z104) + s11)
        z106 = k1 * z61 + (x_B * z60 + z74)
        z107 = k1 * z80 + (x_B * z79 + z86)
        z108 = k1 * z89 - (z90 + x_B * z91)
        s12 = m_B * (z106 * z106 + z107 * z107 + z108 * z108)
        z109 = B_xx * z103 + B_yy * (z46 * z46) + B_zz * z104 + s12
        s13 = 0.5 * z105 + (B_xz * (w1 * w3) + 0.5 * z109)
        z110 = H_xz * (z51 * o3) - 0.5 * z102 - s13
        value1 = 0.5 * z98 - z110 - g * (z9 + m_F * (Sz - c * z7 - r_F * z8))
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
    thR_dot = float(y[11])
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
        z14 = k10 + z13
        z15 = z14 + c_steer * z8
        z16 = c_roll * z10 + e2z * z15
        z17 = r_F * z2
        z18 = z5 * z17
        z19 = r_R * z2
        z20 = z11 * z19
        z21 = k16 + z18
        z22 = z20 - z21
        z23 = s_steer * z22
        z24 = z18 * z23
        z25 = c_steer * z21
        z26 = c_steer * k10 + z8
        z27 = s1 * z25 + c1 * z26
        z28 = c_roll * z27 + e2z * z23
        z29 = z18 * z28
        z30 = c_steer * z22
        z31 = s_steer * z21
        z32 = s_steer * k10
        z33 = s1 * z31 + c1 * z32
        z34 = c_roll * z33 - e2z * z30
        z35 = z30 * z28 + z34 * z23
        z36 = z16 * z24 - z15 * z29 - z7 * z35
        z37 = k17 * (9.0 + abs(z11))
        s2 = k22 * (z37 + k24)
        s3 = (z37 + k25) * s2
        # the coframe is singular
        if not abs(z36) > 1e-15 * s3:
            raise _refuse(abs(z36), 1e-15 * s3, 1, "jacobian")
        z38 = 1.0 / z36
        z39 = s_steer * c1
        z40 = z8 * z39
        z41 = c_steer * c1
        z42 = r_R * c_roll
        z43 = z42 * z11
        z44 = k10 * s1 + z43
        z45 = s1 * z7 - z18 * z41 - (k16 * z41 - k4 * s1 - c_steer * z44)
        z46 = z18 * z45
        z47 = z18 * z39 + (k16 * z39 - s_steer * z44)
        z48 = z30 * z45 - z23 * z47
        z49 = z24 * z40 + z15 * z46 + z7 * z48
        z50 = z38 * z49
        z51 = c_roll * z50
        z52 = s1 + c1 * z51
        z53 = z43 + k10 * z52
        z54 = z28 * z47 + z34 * z45
        z55 = z16 * z46 + z29 * z40 - z7 * z54
        z56 = z38 * z55
        z57 = z56 - e2z * z50
        z58 = z20 * z57
        z59 = c_steer * z53 - s_steer * z58
        z60 = c1 - s1 * z51
        z61 = s_steer * z57 - c_steer * z60
        z62 = k63 * z52 + (k48 * z59 + k62 * z61)
        z63 = c_steer * z57 + s_steer * z60
        z64 = c_steer * z58 + s_steer * z53
        z65 = z14 * z57
        z66 = k59 * z63 - (k45 * z64 - k48 * z65)
        z67 = k56 * z52 + (k45 * z59 + k55 * z61)
        z68 = k43 * z65 + k48 * z63
        z69 = k48 * z52 + (k43 * z59 + k45 * z61)
        z70 = k43 * z64 - k45 * z63
        z71 = k41 * z52 + (z43 * k28 - k40 * z60)
        z72 = z13 * z57
        z73 = z57 * k37 - (z58 * k27 - z72 * k28)
        z74 = k35 * z52 + (z43 * k27 - k34 * z60)
        z75 = z72 * k26 + z57 * k28
        z76 = z58 * k26 - z57 * k27
        z77 = k28 * z52 + (z43 * k26 - k27 * z60)
        s4 = z60 * z74 - (z72 * z75 + (z58 * z76 + z43 * z77))
        z78 = z52 * z71 + (z57 * z73 - s4)
        s5 = z61 * z67 + (z65 * z68 + (z59 * z69 + (z64 * z70 + z78)))
        z79 = z52 * z62 + (z63 * z66 + s5)
        z80 = z16 * z48 + z15 * z54 + z35 * z40
        z81 = z38 * z80
        z82 = z81 + z63
        z83 = z79 + R_yy * (z57 * z57) + F_yy * (z82 * z82)
        # the mass matrix is singular
        if not abs(z83) > 0.0:
            raise _refuse(abs(z83), 0.0, 2, "jacobian")
        z84 = z18 * z8
        z85 = z30 * z8
        z86 = z15 * z84 + z7 * z85
        z87 = z38 * z86
        z88 = c_roll * z87
        z89 = c1 * z88
        z90 = 1.0 + z89
        z91 = k10 * z89
        z92 = z34 * z8
        z93 = z16 * z84 - z7 * z92
        z94 = z38 * z93
        z95 = z94 - e2z * z87
        z96 = z20 * z95
        z97 = c_steer * z91 - s_steer * z96
        z98 = s1 * z88
        z99 = s_steer * z95 + c_steer * z98
        z100 = k63 * z90 + (k48 * z97 + k62 * z99)
        z101 = c_steer * z95 - s_steer * z98
        z102 = c_steer * z96 + s_steer * z91
        z103 = z14 * z95
        z104 = k59 * z101 - (k45 * z102 - k48 * z103)
        z105 = k56 * z90 + (k45 * z97 + k55 * z99)
        z106 = k43 * z103 + k48 * z101
        z107 = k48 * z90 + (k43 * z97 + k45 * z99)
        z108 = k43 * z102 - k45 * z101
        z109 = k40 * z98 + k41 * z89
        z110 = z13 * z95
        z111 = z95 * k37 - (z96 * k27 - z110 * k28)
        z112 = k34 * z98 + k35 * z89
        z113 = z96 * k26 - z95 * k27
        z114 = z110 * k26 + z95 * k28
        s6 = z95 * z111 + (z98 * z112 + (z96 * z113 + z110 * z114))
        z115 = z102 * z108 + (z89 * z109 + s6)
        s7 = z99 * z105 + (z103 * z106 + (z97 * z107 + z115))
        z116 = z90 * z100 + (z101 * z104 + s7) + R_yy * (z95 * z95)
        z117 = z16 * z85 + z15 * z92
        z118 = z38 * z117
        z119 = z118 + z101
        z120 = z116 + F_yy * (z119 * z119)
        s8 = z95 * z73 + (z98 * z74 + (z96 * z76 + z110 * z75))
        z121 = z102 * z70 + (z89 * z71 + s8)
        s9 = z101 * z66 + (z99 * z67 + (z103 * z68 + (z97 * z69 + z121)))
        z122 = z90 * z62 + s9 + R_yy * (z57 * z95)
        z123 = z122 + F_yy * (z82 * z119)
        z124 = 1.0 / z83
        z125 = z123 * z124
        z126 = z120 - z123 * z125
        # the mass matrix is singular
        if not abs(z126) > 1e-14 * z120:
            raise _refuse(abs(z126), 1e-14 * z120, 2, "jacobian")
        z127 = s_steer * z20
        z128 = z18 * z127
        z129 = c_steer * z20
        z130 = z30 * z127 - z129 * z23
        z131 = z13 * z24 - z15 * z128 - z7 * z130
        z132 = z38 * z131
        z133 = c_roll * z132
        z134 = c1 * z133
        z135 = k10 * z134
        z136 = z129 * z28 + z34 * z127
        z137 = z16 * z128 - z13 * z29 - z7 * z136
        z138 = z38 * z137
        z139 = z138 + e2z * z132
        z140 = 1.0 - z139
        z141 = z20 * z140
        z142 = c_steer * z135 - s_steer * z141
        z143 = s1 * z133
        z144 = s_steer * z139 - c_steer * z143
        z145 = k63 * z134 + (k48 * z142 - k62 * z144)
        z146 = c_steer * z139 + s_steer * z143
        z147 = c_steer * z141 + s_steer * z135
        z148 = z13 * z140
        z149 = z148 - k10 * z139
        z150 = k59 * z146 + (k45 * z147 - k48 * z149)
        z151 = k56 * z134 + (k45 * z142 - k55 * z144)
        z152 = k43 * z149 - k48 * z146
        z153 = k48 * z134 + (k43 * z142 - k45 * z144)
        z154 = k43 * z147 + k45 * z146
        z155 = k40 * z143 + k41 * z134
        z156 = z139 * k37 + (z141 * k27 - z148 * k28)
        z157 = k34 * z143 + k35 * z134
        z158 = z141 * k26 + z139 * k27
        z159 = z148 * k26 - z139 * k28
        s10 = z139 * z156 + (z143 * z157 + (z141 * z158 + z148 * z159))
        z160 = z147 * z154 + (z134 * z155 + s10)
        s11 = z144 * z151 - (z149 * z152 + (z142 * z153 + z160))
        z161 = z134 * z145 + (z146 * z150 - s11) + R_yy * (z140 * z140)
        z162 = z16 * z130 + z15 * z136 - z13 * z35
        z163 = z38 * z162
        z164 = z163 + z146
        z165 = z161 + F_yy * (z164 * z164)
        s12 = z139 * z73 - (z143 * z74 + (z141 * z76 + z148 * z75))
        z166 = z147 * z70 + (z134 * z71 - s12)
        s13 = z146 * z66 + (z144 * z67 - (z149 * z68 + (z142 * z69 + z166)))
        z167 = z134 * z62 - s13 + R_yy * (z57 * z140)
        z168 = z167 - F_yy * (z82 * z164)
        z169 = z168 * z124
        s14 = z139 * z111 - (z143 * z112 + (z141 * z113 + z148 * z114))
        z170 = z147 * z108 + (z134 * z109 - s14)
        s15 = z144 * z105 - (z149 * z106 + (z142 * z107 + z170))
        z171 = z134 * z100 - (z146 * z104 + s15) + R_yy * (z95 * z140)
        z172 = z171 - F_yy * (z119 * z164) - z123 * z169
        z173 = 1.0 / z126
        z174 = z172 * z173
        z175 = z165 - z168 * z169 - z172 * z174
        # the mass matrix is singular
        if not abs(z175) > 1e-14 * z165:
            raise _refuse(abs(z175), 1e-14 * z165, 2, "jacobian")
        s_yaw = math.sin(yaw)
        z176 = s1 * z58 - c1 * z72
        z177 = e2z * z176 + c_roll * z43
        c_yaw = math.cos(yaw)
        z178 = s1 * z72 + c1 * z58
        z179 = s1 * z96 - c1 * z110
        z180 = e2z * z179
        z181 = s1 * z110 + c1 * z96
        z182 = s1 * z141 - c1 * z148
        z183 = e2z * z182
        z184 = s1 * z148 + c1 * z141
        z185 = z11 * z11
        z186 = roll_dot * r_R
        z187 = c_roll * z186
        z188 = z5 * z5
        v2_x = z11 * z187
        z189 = z38 * z38
        z190 = roll_dot * c1
        z191 = s_steer * z190
        z192 = roll_dot * s1
        z193 = steer_dot + z192
        z194 = c_steer * z190
        z195 = thR_dot * z20
        z196 = v2_x + k10 * z192
        z197 = z7 * z191 + (k4 * z191 - thR_dot * z13)
        s16 = k16 * z194 - k4 * z193 - (s_steer * z195 + c_steer * z196)
        z198 = z7 * z193 - z18 * z194 - s16
        z199 = z18 * z198
        z200 = z18 * z191 + (k16 * z191 - (s_steer * z196 - c_steer * z195))
        z201 = z30 * z198 - z23 * z200
        z202 = z24 * z197 + z15 * z199 + z7 * z201
        z203 = z28 * z200 + z34 * z198
        z204 = z16 * z199 + z29 * z197 - z7 * z203
        z205 = z16 * z201 + z15 * z203 + z35 * z197
        z206 = z38 * z202
        z207 = z38 * z204
        z208 = z207 - e2z * z206
        z209 = thR_dot - z208
        z210 = z20 * z209
        z211 = z13 * z209
        z212 = s1 * z210 - c1 * z211
        z213 = c_roll * v2_x - e2z * z212
        z214 = s1 * z211 + c1 * z210
        z271 = 1.0 / z175
        z272 = roll_dot * e2z
        z273 = s1 * z207
        z274 = z272 * c1 - c_roll * z273
        z275 = roll_dot * c_roll
        z276 = steer_dot * c_steer
        z277 = steer_dot * s_steer
        z278 = c1 * z207
        z279 = z272 * s1 + c_roll * z278
        z280 = s_steer * z275 + e2z * z276 + (z277 * z3 + c_steer * z279)
        z281 = z2 * z274 - z4 * z280
        z282 = z5 * z281
        z283 = z188 * z282
        z284 = r_F * z280
        z285 = z6 * z283 + z5 * z284
        z286 = roll_dot * z278
        z287 = r_F * z274
        z288 = z17 * z283 - z5 * z287
        z289 = roll_dot * z273
        z290 = z277 * z190 - c_steer * z289
        z291 = c_roll * z272
        z292 = z11 * z291
        z293 = z292 * z185
        z294 = r_R * z274
        z295 = z19 * z293 - z11 * z294
        z296 = thR_dot * z295
        z297 = z272 * z186
        z298 = z187 * z293 - z11 * z297 - k10 * z286
        s17 = z276 * z195 + s_steer * z296 - (z277 * z196 - c_steer * z298)
        z299 = k16 * z290 - k4 * z286 + s17
        z300 = z277 * z21 - c_steer * z288
        z301 = z277 * k10 - z285
        z302 = z25 * z278 + s1 * z300 - (z26 * z273 - c1 * z301)
        z303 = z295 - z288
        z304 = z276 * z22 + s_steer * z303
        z305 = z272 * z27 + c_roll * z302 - (z275 * z23 + e2z * z304)
        s18 = z193 * z285 - z7 * z286 - (z194 * z288 - z18 * z290) + z299
        z306 = s18 - (z206 * z305 + z207 * z304)
        z307 = z276 * z190 + s_steer * z289
        s19 = z276 * z196 + s_steer * z298 + (z277 * z195 - c_steer * z296)
        z308 = z191 * z288 + z18 * z307 + (k16 * z307 - s19)
        z309 = z38 * z205
        z310 = z276 * z21 + s_steer * z288
        z311 = z276 * k10
        z312 = z31 * z278 - s1 * z310 - (c1 * z311 + z32 * z273)
        z313 = z277 * z22 - c_steer * z303
        z314 = z272 * z33 + c_roll * z312 + (z275 * z30 - e2z * z313)
        z315 = z308 + (z309 * z288 + (z206 * z314 + z207 * z313))
        z316 = z30 * z306 - z23 * z315
        z317 = z28 * z315 + z34 * z306
        z318 = r_R * z279
        z319 = z12 * z293 - z11 * z318
        z320 = z276 * z8 + s_steer * z285
        z321 = z9 * z278 - s1 * z320
        z322 = z319 - (z277 * z8 - c_steer * z285)
        z323 = z272 * z10 + c_roll * z321 - (z275 * z15 + e2z * z322)
        s20 = z191 * z285 + z7 * z307 + (k4 * z307 - thR_dot * z319)
        z324 = s20 + (z309 * z285 + (z206 * z323 + z207 * z322))
        z325 = z16 * z316 + z15 * z317 + z35 * z324
        z326 = z18 * z306
        z327 = z16 * z326 + z29 * z324 - z7 * z317
        z328 = z24 * z324 + z15 * z326 + z7 * z316
        z329 = z38 * z328
        z330 = z38 * z327 - (z275 * z206 + e2z * z329)
        z331 = c_roll * z206
        z332 = z190 - s1 * z331
        z333 = z272 * z206 - c_roll * z329
        z334 = z289 + (z331 * z278 + s1 * z333)
        z335 = z277 * z208 - c_steer * z330 - (z276 * z332 + s_steer * z334)
        z336 = z38 * z325 - z335
        v2_x_2 = roll_dot * z43
        z337 = z192 + c1 * z331
        z338 = z209 * z295 - z20 * z330 - (z208 * z211 - v2_x_2 * z337)
        z339 = k10 * z208
        z340 = k10 * z337
        z341 = z338 + (z208 * z339 + z337 * z340)
        z342 = r_R * z272
        z343 = z11 * z342 - z42 * z293
        z344 = roll_dot * z343 + (z210 * z337 - z211 * z332)
        z345 = z286 - (z331 * z273 - c1 * z333)
        z346 = z344 + (k10 * z345 + z339 * z332)
        z347 = c_steer * z341 + s_steer * z346
        z348 = z209 * z319 - z13 * z330 - (v2_x_2 * z332 - z208 * z210)
        z349 = z348 - (k10 * z330 + z332 * z340)
        w3_steer = steer_dot + z337
        z350 = s_steer * z208 - c_steer * z332
        z351 = k55 * z350 + k56 * w3_steer
        z352 = k62 * z350 + k63 * w3_steer
        s21 = k59 * z335 - (k45 * z347 - k48 * z349)
        s22 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73)
        z353 = s22 - (s21 - (w3_steer * z351 - z350 * z352))
        h2z = e2z * c_steer + s_steer * z3
        z354 = c_steer * z346 - s_steer * z341
        z355 = z276 * z208 + s_steer * z330 + (z277 * z332 - c_steer * z334)
        z356 = c_steer * z208 + s_steer * z332
        z357 = F_yy * (z309 + z356) + k59 * z356
        s23 = k56 * z345 + (k45 * z354 - k55 * z355)
        z358 = h2z * k75 + (s23 - (z356 * z352 - w3_steer * z357))
        z359 = k45 * z350 + k48 * w3_steer
        z360 = k45 * z356
        s24 = k43 * z349 + k48 * z335 + (z350 * z359 + z356 * z360)
        z361 = z2 * k72 + s24
        z362 = k48 * z356
        s25 = k48 * z345 + (k43 * z354 - k45 * z355)
        z363 = h2z * k72 + (s25 + (w3_steer * z360 - z350 * z362))
        s26 = k43 * z347 - k45 * z335 + (z356 * z362 + w3_steer * z359)
        z364 = z4 * k72 + s26
        z365 = R_yy * z209 - k37 * z208
        z366 = k34 * z332 - k35 * z337
        s27 = k41 * z345 + (k28 * z344 + k40 * z334)
        z367 = e2z * k68 + (s27 - (z332 * z365 + z208 * z366))
        s28 = k63 * z345 + (k48 * z354 - k62 * z355)
        z368 = h2z * k76 - (s28 - (z350 * z357 - z356 * z351))
        z369 = z367 - z368
        z370 = k40 * z332 - k41 * z337
        s29 = k37 * z330 + (k27 * z338 - k28 * z348)
        z371 = z3 * k69 + z2 * k68 - (s29 - (z337 * z366 + z332 * z370))
        s30 = k35 * z345 + (k27 * z344 + k34 * z334)
        z372 = e2z * k69 + (s30 + (z208 * z370 - z337 * z365))
        z373 = k27 * z332 - k28 * z337
        z374 = k27 * z208
        s31 = k26 * z348 - k28 * z330 + (z332 * z373 + z208 * z374)
        z375 = z2 * k67 + s31
        z376 = k28 * z208
        s32 = k26 * z338 + k27 * z330 + (z208 * z376 - z337 * z373)
        z377 = z3 * k67 - s32
        s33 = k28 * z345 + (k26 * z344 + k27 * z334)
        z378 = e2z * k67 + (s33 + (z337 * z374 + z332 * z376))
        z379 = z191 + z309
        z380 = z188 * z188
        z381 = z185 * (1.0 / c_roll)
        s34 = z139 * z371 - (z143 * z372 - (z141 * z377 - z148 * z375))
        z382 = z147 * z364 + (z134 * z367 - s34)
        s35 = z144 * z358 - (z149 * z361 + (z142 * z363 + z382))
        z383 = z134 * z368 - (z146 * z353 - s35) + R_yy * (z140 * z330)
        s36 = z60 * z372 - (z72 * z375 - (z58 * z377 - z43 * z378))
        z384 = z52 * z367 + (z57 * z371 - s36)
        s37 = z61 * z358 + (z65 * z361 + (z59 * z363 + (z64 * z364 + z384)))
        z385 = z52 * z368 + (z63 * z353 - s37)
        z386 = z385 + R_yy * (z57 * z330) + F_yy * (z82 * z336)
        s38 = z95 * z371 + (z98 * z372 - (z96 * z377 - z110 * z375))
        z387 = z102 * z364 + (z89 * z367 + s38)
        s39 = z99 * z358 + (z103 * z361 + (z97 * z363 + z387))
        z388 = z90 * z368 + (z101 * z353 - s39) + R_yy * (z95 * z330)
        z389 = z388 + F_yy * (z119 * z336) - z386 * z125
        s40 = z383 - F_yy * (z164 * z336) - z386 * z169 - z174 * z389
        z390 = z271 * s40
        z391 = z173 * z389 - z174 * z390
        z392 = z386 * z124 - z125 * z391 - z169 * z390
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
            c_yaw * z178 - s_yaw * z177,
            # (I.2.15)
            c_yaw * z181 - s_yaw * z180,
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
            s_yaw * z178 + c_yaw * z177,
            # (I.2.15)
            s_yaw * z181 + c_yaw * z180,
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
            e2z * z43 - c_roll * z176,
            # (I.2.15)
            -c_roll * z179,
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
            z50,
            # (I.2.15)
            z87,
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
            -z56,
            # (I.2.15)
            -z94,
            # (I.2.15)
            -z138,
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
            # (I.2.15)
            -z81,
            # (I.2.15)
            -z118,
            # (I.2.15)
            -z163,
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
            z215 = c_yaw * turn_3
            z216 = e2z * turn_4
            z217 = z185 * (z11 * (c_roll * z216))
            z218 = z187 * z217 - z11 * (z186 * z216)
            z219 = c_roll * turn_4
            z220 = c1 * turn_5
            z221 = s1 * turn_5
            z222 = c1 * z216 + c_roll * z221
            z223 = z19 * z217 - z11 * (r_R * z222)
            z224 = c_steer * turn_6
            z225 = s_steer * turn_6
            z226 = s1 * z216 - c_roll * z220
            z227 = s_steer * z219 + e2z * z224 + (z3 * z225 + c_steer * z226)
            z228 = z188 * (z5 * (z2 * z222 - z4 * z227))
            z229 = z6 * z228 + z5 * (r_F * z227)
            z230 = z12 * z217 - z11 * (r_R * z226)
            z231 = z230 - (z8 * z225 - c_steer * z229)
            s41 = c_roll * (z9 * z220 + s1 * (z8 * z224 + s_steer * z229))
            z232 = z10 * z216 - s41 - (z15 * z219 + e2z * z231)
            z233 = z17 * z228 - z5 * (r_F * z222)
            z234 = z223 - z233
            z235 = z22 * z224 + s_steer * z234
            z236 = z23 * z233 + z18 * z235
            s42 = z25 * z220 - s1 * (z21 * z225 - c_steer * z233)
            z237 = s42 - (z26 * z221 - c1 * (z229 - k10 * z225))
            z238 = z27 * z216 - c_roll * z237 - (z23 * z219 + e2z * z235)
            z239 = z28 * z233 - z18 * z238
            z240 = z22 * z225 - c_steer * z234
            s43 = z31 * z220 + s1 * (z21 * z224 + s_steer * z233)
            z241 = s43 - (z32 * z221 - c1 * (k10 * z224))
            z242 = z33 * z216 - c_roll * z241 + (z30 * z219 - e2z * z240)
            z243 = z28 * z240 + z30 * z238 + (z23 * z242 - z34 * z235)
            s44 = z24 * z232 - z16 * z236 + (z29 * z231 + z15 * z239)
            z244 = s44 + (z35 * z229 - z7 * z243)
            z245 = z189 * z244
            z246 = roll_dot * z220
            z247 = roll_dot * z221
            z248 = z190 * z225 + c_steer * z247
            z249 = thR_dot * z223
            z250 = z218 + k10 * z246
            s45 = z195 * z224 + s_steer * z249 - (z196 * z225 - c_steer * z250)
            z251 = k16 * z248 + k4 * z246 + s45
            z252 = z193 * z229 + z7 * z246 - (z194 * z233 - z18 * z248) + z251
            z253 = z198 * z233 + z18 * z252
            z254 = z190 * z224 - s_steer * z247
            z255 = z191 * z229 + z7 * z254 + (k4 * z254 - thR_dot * z230)
            s46 = z196 * z224 + s_steer * z250 + (z195 * z225 - c_steer * z249)
            z256 = z191 * z233 + z18 * z254 + (k16 * z254 - s46)
            z257 = z200 * z238 - z28 * z256 + (z198 * z242 - z34 * z252)
            s47 = z199 * z232 - z16 * z253 - (z197 * z239 + z29 * z255)
            z258 = s47 + (z203 * z229 - z7 * z257)
            z259 = z204 * z245 - z38 * z258
            z260 = z198 * z240 - z30 * z252 + (z200 * z235 + z23 * z256)
            s48 = z197 * z236 + z24 * z255 + (z199 * z231 + z15 * z253)
            z261 = s48 + (z201 * z229 - z7 * z260)
            z262 = z202 * z245 + z38 * z261
            z263 = z259 - (z206 * z219 + e2z * z262)
            z264 = z209 * z223 - z20 * z263
            z265 = z209 * z230 - z13 * z263
            z266 = z210 * z220 + s1 * z264 + (z211 * z221 - c1 * z265)
            z267 = v2_x * z216 - c_roll * z218 + (z212 * z219 + e2z * z266)
            z268 = s_yaw * turn_3
            z269 = z211 * z220 + s1 * z265 - (z210 * z221 - c1 * z264)
            J[offset1] = z214 * z268 - c_yaw * z269 - (z213 * z215 - s_yaw * z267)
            s49 = z214 * z215 + s_yaw * z269
            J[offset1 + 12] = -(s49 + (z213 * z268 + c_yaw * z267))
            s50 = z212 * z216 - c_roll * z266
            J[offset1 + 24] = v2_x * z219 + e2z * z218 - s50
            J[offset1 + 36] = z262
            J[offset1 + 60] = -z259
            s51 = z201 * z232 + z16 * z260 - (z203 * z231 - z15 * z257)
            z270 = s51 + (z197 * z243 - z35 * z255)
            J[offset1 + 96] = z38 * z270 - z205 * z245
        # one rate in each pass: its row of the matrix
        offsets2 = (108, 120, 132)
        for k78, offset2 in enumerate(offsets2):
            row_0 = 1.0 if k78 == 0 else 0.0
            row_1 = 1.0 if k78 == 1 else 0.0
            row_2 = 1.0 if k78 == 2 else 0.0
            z393 = row_1 - z125 * row_0
            z394 = z271 * (row_2 + z169 * row_0 + z174 * z393)
            z395 = R_yy * z394
            z396 = z173 * z393 + z174 * z394
            z397 = R_yy * z396
            z398 = z124 * row_0 - z125 * z396 + z169 * z394
            z399 = R_yy * z398
            z400 = z139 * z394 + z95 * z396 + z57 * z398
            z401 = z148 * z394 - z110 * z396 - z72 * z398
            z402 = z141 * z394 - z96 * z396 - z58 * z398
            s52 = z140 * z395 - z95 * z397 - z57 * z399 - k37 * z400
            z403 = s52 + k28 * z401 - k27 * z402
            z404 = z146 * z394 + z101 * z396 + z63 * z398
            z405 = z149 * z394 - z103 * z396 - z65 * z398
            z406 = k48 * z404 - k43 * z405
            z407 = F_yy * z394
            z408 = F_yy * z396
            z409 = F_yy * z398
            z410 = z164 * z407 + z119 * z408 + z82 * z409
            z411 = z147 * z394 - z102 * z396 - z64 * z398
            z412 = z410 + (k59 * z404 - k48 * z405 + k45 * z411)
            z413 = z134 * z394
            z414 = z52 * z398
            z415 = z413 - z90 * z396 - z414
            z416 = z144 * z394 + z99 * z396 + z61 * z398
            z417 = z142 * z394 - z97 * z396 - z59 * z398
            z418 = k62 * z415 - k55 * z416 + k45 * z417
            z419 = z406 + (k28 * z400 - k26 * z401)
            z420 = k48 * z415 - k45 * z416 + k43 * z417
            z421 = k45 * z404 + k43 * z411
            z422 = s_steer * z420 - c_steer * z421
            z423 = k27 * z400 + k26 * z402 - z422
            s53 = z403 - k10 * z406 - c_steer * z412 + s_steer * z418
            z424 = s53 - z13 * z419 + z20 * z423
            z425 = z38 * z410
            z426 = z38 * z424
            z427 = z413 - z89 * z396 - z414
            z428 = z143 * z394 - z98 * z396 + z60 * z398
            z429 = z43 * z398
            s54 = k40 * z427 + k34 * z428 - k27 * z429 + s_steer * z412
            z430 = s54 + c_steer * z418
            s55 = k63 * z415 - k56 * z416 + k48 * z417 + k41 * z427
            z431 = s55 + k35 * z428 - k28 * z429
            z432 = c_steer * z420 + s_steer * z421
            z433 = z431 + k10 * z432
            z434 = s1 * z430 + c1 * z433
            z435 = c_roll * z434 - e2z * z424
            z436 = z38 * z435
            z437 = z35 * z425 - z29 * z426 - z24 * z436
            z438 = z206 * z437
            z439 = z15 * z425 + z7 * z426
            z440 = z16 * z425 - z7 * z436
            z441 = z16 * z426 + z15 * z436
            z442 = z34 * z439 + z30 * z440 - z18 * z441
            z443 = z206 * z442
            z444 = z28 * z439 - z23 * z440
            z445 = z206 * z444
            z446 = z207 * z437 - e2z * z438
            z447 = c_roll * z438
            z448 = s1 * z447
            z449 = c_roll * z443
            z450 = c1 * z449
            s56 = z309 * z437 + z193 * z442 + z191 * z437 + c_steer * z446
            z451 = s56 - s_steer * z448 + z450
            z452 = z207 * z442 - e2z * z443
            z453 = z207 * z444 - e2z * z445
            z454 = s_steer * z452 + c_steer * z453
            z455 = s1 * z449
            z456 = c_roll * z445
            z457 = s1 * z456
            s57 = z444 * z379 - z194 * z442 + c_steer * z455 - s_steer * z457
            z458 = z454 + s57
            z459 = z6 * z451 + z17 * z458
            z460 = z188 * z459
            z461 = z5 * z460
            z462 = r_F * (z5 * z451) - z4 * z461
            s58 = z206 * z424 - z15 * z438 + z23 * z443 + z30 * z445
            z463 = s58 + s_steer * z462
            z464 = s_steer * z444 - c_steer * z442
            z465 = z350 * z415 + w3_steer * z416
            z466 = F_yy * z465
            z467 = z288 * z444
            z468 = z285 * z437
            z469 = z466 - z467 - z468
            z470 = z38 * z469
            z471 = z21 * z442
            z472 = z21 * z444 + z7 * z437 + k4 * z437
            z473 = z430 - c_steer * z471 + s_steer * z472
            z474 = c_steer * z444 + s_steer * z442
            z475 = z209 * z423 + thR_dot * z474 - z454
            z476 = r_F * (z5 * z458) + r_R * (z11 * z475) - z2 * z461
            s59 = z331 * z433 - z26 * z449 + z32 * z456 - roll_dot * z473
            z477 = s59 - c_roll * z476
            z478 = z433 - z7 * z442 - k4 * z442 + k10 * z464
            z479 = z209 * z419 + thR_dot * z437 - z446
            z480 = r_R * (z11 * z479) + c_steer * z462
            s60 = z331 * z430 + z9 * z447 - z25 * z449 + z31 * z456
            z481 = s60 + roll_dot * z478 + c_roll * z480
            z482 = z332 * z427 + z337 * z428
            s61 = z374 * z401 + z376 * z402 - z366 * z427 + z370 * z428
            z483 = s61 + k37 * z482 - k28 * (z332 * z429 - z208 * z402)
            s62 = z483 + k27 * (z208 * z401 - z337 * z429) - z339 * z422
            z484 = s62 - z210 * z419 - z211 * z423
            s63 = z360 * z405 + z362 * z411 + z351 * z415 + z352 * z416
            z485 = s63 - k59 * z465 - k48 * (z350 * z417 - z356 * z411)
            z486 = z485 + k45 * (z356 * z405 + w3_steer * z417) - z466
            s64 = k10 * (z332 * z432 - z208 * z422)
            z487 = z484 - z277 * z412 - z276 * z418 + s64 + c_steer * z486
            z488 = z350 * z404 - z356 * z416
            z489 = z356 * z415 + w3_steer * z404
            s65 = z359 * z405 - z362 * z417 - z357 * z415 - z352 * z404
            z490 = s65 - k62 * z488 + k55 * z489
            z491 = z350 * z405 + w3_steer * z411
            z492 = z490 + k45 * z491
            z493 = k28 * z427 + k27 * z428 - k26 * z429 + z432
            z494 = z332 * z493 + z208 * z423
            z495 = z208 * z419 - z337 * z493
            s66 = R_yy * z482 + z319 * z419 - z295 * z423 + z13 * z494
            z496 = s66 + z20 * z495
            z497 = z487 + s_steer * z492 + z496
            s67 = z313 * z444 - z304 * z442 + z322 * z437 - s1 * z477
            z498 = s67 + c1 * z481 + z497
            z499 = z38 * z498
            z500 = z15 * z470 + z7 * z499
            z501 = z332 * z400 - z208 * z428
            z502 = z208 * z427 + z337 * z400
            s68 = z373 * z401 - z376 * z429 - z365 * z427 - z370 * z400
            z503 = s68 - k40 * z501 - k34 * z502
            z504 = z332 * z401 - z337 * z402
            s69 = z503 + k27 * z504 + z340 * z406 + z339 * z432
            z505 = s69 + v2_x_2 * z419 - z211 * z493 + z276 * z412
            z506 = z505 - z277 * z418 + s_steer * z486 - c_steer * z492
            s70 = z360 * z417 + z359 * z411 + z351 * z404 - z357 * z416
            z507 = s70 - k63 * z488 + k56 * z489
            z508 = z507 + k48 * z491
            s71 = z374 * z429 + z373 * z402 + z366 * z400 + z365 * z428
            z509 = s71 - k41 * z501 - k35 * z502
            s72 = z509 + k28 * z504 + z340 * z422 - z210 * z493
            z510 = s72 - v2_x_2 * z423 - k10 * (z332 * z406 - z337 * z422)
            z511 = z508 - z510
            z512 = z278 * z430 - z273 * z433 - s1 * z506 + c1 * z511
            s73 = z272 * z434 + z275 * z424 + z314 * z444 - z305 * z442
            z513 = s73 + z323 * z437 + c_roll * z512
            z514 = z513 - e2z * z497
            z515 = z38 * z514
            z516 = z16 * z470 - z7 * z515
            z517 = z28 * z500 - z23 * z516
            z518 = z16 * z499 + z15 * z515
            z519 = z34 * z500 + z30 * z516 - z18 * z518
            z520 = z276 * z444 + z277 * z442 - s_steer * z517 + c_steer * z519
            z521 = z293 * z464 + z11 * z520
            z522 = roll_dot * z493
            z523 = z42 * z522 + z187 * z464 + z12 * z479 - z19 * z475
            z524 = z185 * z523
            z525 = z11 * z524
            s74 = z329 * z434 - z321 * z438 + z302 * z443 - z312 * z445
            z526 = s74 - z278 * z480 - z273 * z476
            z527 = z390 * z394
            z528 = z134 * z527
            z529 = z144 * z527
            z530 = z142 * z527
            s75 = z394 * z369 + z145 * z527 + z155 * z527 + k63 * z528
            z531 = s75 - k56 * z529 + k48 * z530
            z532 = z143 * z527
            z533 = z391 * z394 - z390 * z396
            z534 = z392 * z394 - z390 * z398
            s76 = z531 + k41 * z528 + k35 * z532 + z100 * z533 + z109 * z533
            z535 = s76 + z62 * z534 + z71 * z534
            s77 = z363 * z394 + z153 * z527 + k48 * z528 - k45 * z529
            z536 = s77 + k43 * z530 + z107 * z533
            z537 = z536 + z69 * z534
            z538 = z146 * z527
            z539 = z147 * z527
            s78 = z364 * z394 + z154 * z527 + k45 * z538 + k43 * z539
            z540 = s78 + z108 * z533 + z70 * z534
            z541 = z535 + k10 * (c_steer * z537 + s_steer * z540)
            s79 = z372 * z394 + z157 * z527 + k40 * z528 + k34 * z532
            z542 = s79 + z112 * z533 + z74 * z534
            z543 = F_yy * z533
            z544 = F_yy * z534
            s80 = z336 * z407 + 2.0 * (z164 * (F_yy * z527)) - z119 * z543
            z545 = s80 - z82 * z544
            z546 = z149 * z527
            s81 = z353 * z394 + z150 * z527 + k59 * z538 - k48 * z546
            z547 = s81 + k45 * z539 - z104 * z533
            z548 = z545 + (z547 - z66 * z534)
            s82 = z358 * z394 + z151 * z527 + k62 * z528 - k55 * z529
            z549 = s82 + k45 * z530 + z105 * z533
            z550 = z549 + z67 * z534
            z551 = z542 + s_steer * z548 + c_steer * z550
            z552 = c1 * z541 + s1 * z551
            z553 = z391 * z396
            z554 = z134 * z533
            z555 = z554 - z90 * z553
            z556 = z144 * z533 + z99 * z553
            z557 = z142 * z533 - z97 * z553
            z558 = z392 * z396 + z391 * z398
            s83 = z368 * z396 - z100 * z553 + k63 * z555 - k56 * z556
            z559 = s83 + k48 * z557 - z62 * z558
            z560 = z554 - z89 * z553
            z561 = z143 * z533 - z98 * z553
            s84 = z363 * z396 + z107 * z553 - k48 * z555 + k45 * z556
            z562 = s84 - k43 * z557 + z69 * z558
            z563 = z146 * z533 + z101 * z553
            z564 = z147 * z533 - z102 * z553
            s85 = z364 * z396 + z108 * z553 - k45 * z563 - k43 * z564
            z565 = s85 + z70 * z558
            s86 = z367 * z396 + z109 * z553 - k41 * z560 - k35 * z561
            s87 = k10 * (c_steer * z562 + s_steer * z565)
            z566 = z559 - (s86 + z71 * z558) - s87
            z567 = F_yy * z558
            s88 = z336 * z408 - z164 * z543 - 2.0 * (z119 * (F_yy * z553))
            z568 = s88 - z82 * z567
            z569 = z149 * z533 - z103 * z553
            s89 = z353 * z396 - z104 * z553 - k59 * z563 + k48 * z569
            z570 = s89 - k45 * z564 - z66 * z558
            z571 = z568 + z570
            s90 = z372 * z396 + z112 * z553 - k40 * z560 - k34 * z561
            z572 = s90 + z74 * z558 + s_steer * z571
            s91 = z358 * z396 + z105 * z553 - k62 * z555 + k55 * z556
            z573 = s91 - k45 * z557 + z67 * z558
            z574 = z572 + c_steer * z573
            z575 = c1 * z566 - s1 * z574
            z576 = z392 * z398
            z577 = z134 * z534
            z578 = z52 * z576
            z579 = z577 - z90 * z558 - z578
            z580 = z144 * z534 + z99 * z558 + z61 * z576
            z581 = z142 * z534 - z97 * z558 - z59 * z576
            s92 = z398 * z369 + z62 * z576 + z71 * z576 - k63 * z579
            z582 = s92 + k56 * z580 - k48 * z581
            z583 = z577 - z89 * z558 - z578
            z584 = z143 * z534 - z98 * z558 + z60 * z576
            z585 = z43 * z576
            s93 = z363 * z398 + z69 * z576 - k48 * z579 + k45 * z580
            z586 = s93 - k43 * z581
            z587 = z146 * z534 + z101 * z558 + z63 * z576
            z588 = z147 * z534 - z102 * z558 - z64 * z576
            z589 = z364 * z398 + z70 * z576 - k45 * z587 - k43 * z588
            z590 = c_steer * z586 + s_steer * z589
            z591 = z582 - k41 * z583 - k35 * z584 + k28 * z585 + k10 * z590
            s94 = z336 * z409 - z164 * z544 - z119 * z567
            z592 = s94 - 2.0 * (z82 * (F_yy * z576))
            z593 = z149 * z534 - z103 * z558 - z65 * z576
            s95 = z353 * z398 - z66 * z576 - k59 * z587 + k48 * z593
            z594 = z592 + (s95 - k45 * z588)
            s96 = z372 * z398 + z74 * z576 - k40 * z583 - k34 * z584
            z595 = s96 + k27 * z585 + s_steer * z594
            s97 = z358 * z398 + z67 * z576 - k62 * z579 + k55 * z580
            z596 = s97 - k45 * z581
            z597 = z595 + c_steer * z596
            z598 = c1 * z591 + s1 * z597
            s98 = z526 - z206 * z512 - z132 * z552 - z87 * z575 + z50 * z598
            z599 = 2.0 * (z292 * z523 * z381) - s98
            z600 = z38 * z545
            z601 = z139 * z527
            z602 = z148 * z527
            z603 = z141 * z527
            s99 = z371 * z394 - z156 * z527 - k37 * z601 + k28 * z602
            z604 = s99 - k27 * z603 + z111 * z533
            s100 = z361 * z394 + z152 * z527 - k48 * z538 + k43 * z546
            z605 = s100 + z106 * z533 + z68 * z534
            z606 = R_yy * z533
            z607 = R_yy * z534
            s101 = z375 * z394 + z159 * z527 - k28 * z601 + k26 * z602
            z608 = s101 + z114 * z533 + z75 * z534
            z609 = z605 + z608
            s102 = z330 * z395 - 2.0 * (z140 * (R_yy * z527)) - z95 * z606
            z610 = s102 - z57 * z607 - z13 * z609
            s103 = z377 * z394 - z158 * z527 - k27 * z601 - k26 * z603
            z611 = s103 - z113 * z533 - z76 * z534
            z612 = z611 + s_steer * z537 - c_steer * z540
            s104 = z604 + z73 * z534 - c_steer * z548 + s_steer * z550
            z613 = s104 + k10 * z605 - (z610 + z20 * z612)
            z614 = z38 * z613
            s105 = z316 * z425 - z326 * z426 - z201 * z470 + z199 * z499
            z615 = s105 + z130 * z600 - z128 * z614
            z616 = z38 * z568
            s106 = z330 * z397 - z371 * z396 + z140 * z606
            z617 = s106 - 2.0 * (z95 * (R_yy * z553)) - z111 * z553
            z618 = z139 * z533 + z95 * z553
            z619 = z148 * z533 - z110 * z553
            z620 = z141 * z533 - z96 * z553
            z621 = R_yy * z558
            s107 = z617 - k37 * z618 + k28 * z619 - k27 * z620 - z57 * z621
            z622 = s107 - z73 * z558 + c_steer * z571
            s108 = z361 * z396 + z106 * z553 + k48 * z563 - k43 * z569
            z623 = s108 + z68 * z558
            s109 = z375 * z396 + z114 * z553 + k28 * z618 - k26 * z619
            z624 = s109 + z75 * z558
            s110 = z377 * z396 - z113 * z553 + k27 * z618 + k26 * z620
            z625 = s110 - z76 * z558 + s_steer * z562
            z626 = z625 - c_steer * z565
            z627 = z622 - s_steer * z573 - z14 * z623 - z13 * z624 + z20 * z626
            z628 = z38 * z627
            z629 = z38 * z592
            s111 = z330 * z399 - z371 * z398 + z140 * z607 - z95 * z621
            z630 = s111 - 2.0 * (z57 * (R_yy * z576))
            z631 = z139 * z534 + z95 * z558 + z57 * z576
            z632 = z148 * z534 - z110 * z558 - z72 * z576
            z633 = z141 * z534 - z96 * z558 - z58 * z576
            s112 = z630 - z73 * z576 - k37 * z631 + k28 * z632 - k27 * z633
            z634 = s112 + c_steer * z594 - s_steer * z596
            z635 = z361 * z398 + z68 * z576 + k48 * z587 - k43 * z593
            z636 = z375 * z398 + z75 * z576 + k28 * z631 - k26 * z632
            s113 = z377 * z398 - z76 * z576 + k27 * z631 + k26 * z633
            z637 = s113 + s_steer * z586 - c_steer * z589
            z638 = z634 - z14 * z635 - z13 * z636 + z20 * z637
            z639 = z38 * z638
            s114 = z325 * z410 - z327 * z424 - z328 * z435 - z205 * z469
            z640 = s114 + z204 * z498 + z202 * z514
            z641 = c_roll * z552 - e2z * z613
            z642 = c_roll * z575 - e2z * z627
            s115 = z640 + z162 * z545 - z137 * z613 + z131 * z641 + z117 * z568
            z643 = s115 + z93 * z627 + z86 * z642
            z644 = c_roll * z598 + e2z * z638
            z645 = z189 * (z643 + z80 * z592 + z55 * z638 - z49 * z644)
            s116 = z615 + z85 * z616 + z84 * z628 + z48 * z629 + z46 * z639
            z646 = s116 - z24 * z645
            z647 = z15 * z600 + z7 * z614
            z648 = z15 * z629 - z7 * z639
            s117 = z324 * z425 - z197 * z470 - z13 * z600 + z40 * z629
            z649 = s117 + z7 * z645
            s118 = z324 * z426 - z197 * z499 - z13 * z614 - z40 * z639
            z650 = s118 - z15 * z645
            s119 = z315 * z439 - z200 * z500 + z129 * z647 + z47 * z648
            z651 = s119 + z30 * z649 - z18 * z650
            z652 = z15 * z616 - z7 * z628
            s120 = z306 * z439 - z198 * z500 + z127 * z647 + z8 * z652
            z653 = s120 + z45 * z648 + z23 * z649
            z654 = z332 * z419 + z337 * z423
            s121 = z378 * z398 + z77 * z576 - k28 * z583 - k27 * z584
            z655 = roll_dot * z654 - (s121 + k26 * z585)
            z656 = z38 * z644
            z657 = z16 * z629 - z7 * z656
            z658 = z28 * z648 - z23 * z657
            z659 = z16 * z639 - z15 * z656
            z660 = z34 * z648 + z30 * z657 + z18 * z659
            z661 = s_steer * z658 - c_steer * z660
            z662 = z655 - z590 - z661
            s122 = z318 * z479 - z294 * z475 + z342 * z522 + z297 * z464
            z663 = s122 - z291 * z524 + z42 * z662
            z664 = z35 * z470 - z29 * z499 - z24 * z515
            s123 = z330 * z419 - z209 * z494 + thR_dot * z664 + z140 * z609
            z665 = s123 - z35 * z600 + z29 * z614
            z666 = z38 * z641
            s124 = z317 * z425 - z326 * z436 - z275 * z438 - z203 * z470
            z667 = s124 + z199 * z515 + z136 * z600
            z668 = z38 * z642
            s125 = z667 - z128 * z666 + z92 * z616 + z84 * z668 + z54 * z629
            z669 = s125 - z46 * z656 + z29 * z645
            z670 = z669 + e2z * z646
            s126 = z665 + z24 * z666 - z95 * z624 - z57 * z636
            z671 = s126 - (z95 * z623 + z57 * z635 - z670)
            z672 = z277 * z444 - z276 * z442 + c_steer * z517 + s_steer * z519
            s127 = z330 * z423 + z209 * z495 + thR_dot * z672 + z140 * z612
            z673 = s127 - z95 * z626 - z57 * z637
            z674 = z16 * z600 - z7 * z666
            z675 = z16 * z614 + z15 * z666
            z676 = z34 * z647 + z30 * z674 - z18 * z675
            s128 = z315 * z440 - z275 * z443 - z200 * z516 + z129 * z674
            z677 = s128 + z47 * z657 - z34 * z649
            s129 = z324 * z436 - z197 * z515 - z13 * z666 + z40 * z656
            z678 = s129 + z16 * z645
            z679 = z677 + z18 * z678 - e2z * z651
            z680 = z16 * z616 + z7 * z668
            s130 = z306 * z440 + z275 * z445 - z198 * z516 + z127 * z674
            z681 = s130 + z8 * z680 + z45 * z657
            z682 = z681 + z28 * z649 - e2z * z653
            z683 = z276 * z452 - z277 * z453 + s_steer * z679 - c_steer * z682
            z684 = z28 * z647 - z23 * z674
            z685 = z673 - s_steer * z676 + z683 - c_steer * z684
            s131 = z272 * z525 - z599 - z10 * z646 - z27 * z651 - z33 * z653
            s132 = z11 * (z185 * (z187 * z520 - z663 - z12 * z671 + z19 * z685))
            z686 = z186 * z521 + s131 - c_roll * s132
            z687 = k76 * z415 + k75 * z416 - k72 * z417
            s133 = k69 * z400 + k67 * z402 + r_R * (z293 * z479 - z11 * z671)
            z688 = z277 * z462 - (s_steer * z687 + s133)
            s134 = z317 * z426 - z316 * z436 - z286 * z442 + z307 * z437
            z689 = s134 - z203 * z499 + z201 * z515
            s135 = z689 - z193 * z519 - z191 * z664 + z136 * z614 - z130 * z666
            z690 = s135 - z92 * z628 + z85 * z668
            z691 = z16 * z628 + z15 * z668
            z692 = z35 * z629 + z29 * z639 - z24 * z656
            s136 = z277 * z446 + z276 * z448 - z34 * z652 - z30 * z680
            z693 = s136 - z18 * z691 - z39 * z692
            z694 = z272 * z438 + c_roll * z646
            z695 = z278 * z447 + s1 * z694
            z696 = z272 * z443 - c_roll * z651
            z697 = z273 * z449 - c1 * z696
            s137 = z690 - z54 * z639 - z48 * z656 + s1 * z660 + z35 * z645
            z698 = s137 - (z693 - c_steer * z670 - s_steer * z695 - z697)
            s138 = z280 * z461 - k74 * z404 - k72 * z411 - k71 * z404
            z699 = s138 - r_F * (z283 * z451 + z5 * z698)
            s139 = z306 * z441 - z307 * z444 - z290 * z442 - z198 * z518
            z700 = s139 + z191 * z517 - z194 * z519
            s140 = z700 + z127 * z675 - z8 * z691 - z45 * z659 - z39 * z658
            z701 = s140 + z41 * z660 + z28 * z650
            z702 = z278 * z449 + s1 * z696
            z703 = z272 * z445 + c_roll * z653
            z704 = z278 * z456 + s1 * z703
            s141 = z277 * z455 + z276 * z457 + c_steer * z702 - s_steer * z704
            z705 = z701 + z23 * z678 - (z683 - s141)
            s142 = z284 * z451 - z287 * z458 + z281 * z460 + z6 * z698
            z706 = z5 * (z188 * (s142 - z17 * z705))
            z707 = z282 * z459 * z380 + 0.5 * z706
            z708 = z699 + 2.0 * (z4 * z707)
            z709 = z688 + c_steer * z708
            s143 = z274 * z461 - k73 * z404 + k72 * z405 + k70 * z404
            z710 = s143 - k68 * z400 + k67 * z401
            s144 = z710 + r_F * (z283 * z458 - z5 * z705)
            z711 = s144 + r_R * (z293 * z475 - z11 * z685) - 2.0 * (z2 * z707)
            s145 = z686 + r_R * (z293 * z522 - z11 * z662) - s1 * z709
            z712 = roll_dot * z463 - (s145 - c1 * z711)
            z713 = z11 * z464
            s146 = z206 * z434 + r_R * (z11 * z522) + z10 * z438 - z27 * z443
            z714 = s146 + z33 * z445 + z186 * z713
            z715 = z714 - c_roll * z525 + s1 * z480 - c1 * z476
            s147 = z329 * z424 - z322 * z438 + z304 * z443 - z313 * z445
            z716 = s147 - z206 * z497 + k68 * z427
            s148 = z716 + k69 * z428 - k67 * z429 - z132 * z613 - z87 * z627
            z717 = s148 - z50 * z638 + z15 * z646
            s149 = z276 * z462 + (z717 + z23 * z651 - z30 * z653)
            z718 = c_steer * z687 - (roll_dot * z715 + s149) + s_steer * z708
            J[offset2 + 4] = e2z * z712 + c_roll * z718
            z719 = z288 * z442 - z18 * z519 - k16 * z519
            s150 = z467 + z468 - z18 * z517 - k16 * z517 - z7 * z664
            z720 = s150 - k4 * z664
            s151 = z506 + z277 * z471 + z276 * z472 - c_steer * z719
            z721 = s151 + s_steer * z720
            s152 = z333 * z433 - z301 * z449 + z207 * z481 + z331 * z511
            z722 = s152 + z133 * z541 + z88 * z566
            z723 = z21 * z660
            z724 = z8 * z692 + z18 * z658 + k16 * z658
            s153 = z311 * z456 - (z597 + (z722 - z51 * z591)) + c_steer * z723
            z725 = s153 - s_steer * z724 + z26 * z696
            z726 = z285 * z442 - z7 * z519 - k4 * z519
            z727 = z726 + (z511 - k10 * z520)
            s154 = z333 * z430 - z320 * z447 - z300 * z449 - z310 * z456
            z728 = s154 - z207 * z477 - z331 * z506
            s155 = z728 + z133 * z551 - z88 * z574 - z591 - z51 * z597
            z729 = s155 + z7 * z660 + k4 * z660
            s156 = roll_dot * z727 + (z729 + z9 * z694 - z25 * z696 + z31 * z703)
            z730 = z272 * z480 + (s156 - k10 * z661)
            s157 = z272 * z476 - (roll_dot * z721 - (z725 - z32 * z703))
            z731 = s1 * (s157 - c_roll * z711) + c1 * (z730 + c_roll * z709)
            J[offset2 + 5] = -z731
            s158 = z332 * z418 + z208 * z412 + z195 * z444 + z196 * z442
            z732 = s158 - z190 * z471 + z8 * z446
            z733 = z732 + k10 * z450 - z22 * z453 + z21 * z455 - z3 * z462
            s159 = z341 * z420 - z346 * z421 - z334 * z412 + z330 * z418
            z734 = s159 - z332 * z486 + z298 * z444
            s160 = z734 - z296 * z442 - z289 * z472 + z285 * z448 + z303 * z452
            z735 = s160 + z288 * z457 - z208 * z492
            s161 = z735 - z143 * z548 + z139 * z550 + z141 * z537 - z135 * z540
            z736 = s161 + z98 * z571 + z95 * z573
            s162 = z736 - z96 * z562 + z91 * z565 - z60 * z594 + z57 * z596
            z737 = s162 - z58 * z586 + z53 * z589
            s163 = z190 * z720 - (z195 * z519 - (z196 * z517 - z737))
            z738 = s163 - z44 * z658 + c1 * z724 + z8 * z695
            s164 = z738 - z22 * z679 + z20 * z676 + z21 * z704
            z739 = s164 - k10 * (z273 * z456 - c1 * z703)
            s165 = z332 * z412 - z208 * z418 - z196 * z444 + z195 * z442
            z740 = s165 + z190 * z472 - z8 * z448
            s166 = z740 - z22 * z452 - z21 * z457 - k10 * (c1 * z456)
            z741 = s166 + e2z * z462
            s167 = z346 * z420 + z341 * z421 + z334 * z418 + z330 * z412
            z742 = s167 - z332 * z492 + z296 * z444
            s168 = z742 + z298 * z442 - z289 * z471 + z285 * z446 - z303 * z453
            z743 = s168 + z288 * z455 + z279 * z462
            s169 = z743 + z208 * z486 + z139 * z548 + z143 * z550 + z135 * z537
            z744 = s169 + z141 * z540 + z95 * z571
            s170 = z744 - z98 * z573 - z91 * z562 - z96 * z565 + z57 * z594
            z745 = s170 + z60 * z596 - z53 * z586
            s171 = z196 * z519 + (z195 * z517 - (z745 - z58 * z589))
            z746 = z190 * z719 + s171 - z44 * z660 + c1 * z723
            s172 = z746 - z8 * z670 - k10 * z697 - z22 * z682 + z21 * z702
            z747 = s172 - z20 * z684 - z3 * z708
            s173 = steer_dot * z733 - (z275 * z462 - (z3 * z687 - z739))
            s174 = s_steer * (e2z * z687 - (steer_dot * z741 - z747))
            z748 = c_steer * (s173 + e2z * z708) - s174
            J[offset2 + 6] = z748
            s175 = z273 * z473 + z278 * z478 + z343 * z493 + z43 * z654
            z749 = s175 + r_R * (z272 * z713 - c_roll * z521)
            s176 = z749 + c1 * z721 + s1 * z727 + e2z * z715
            J[offset2 + 9] = -(s176 + c_roll * z463)
            J[offset2 + 10] = s_steer * z733 - (z508 + z726 + c_steer * z741)
            s177 = z295 * z474 - z319 * z437 - z496 - z20 * z672
            J[offset2 + 11] = -(s177 + z13 * z664)
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
    thR_dot = float(y[11])
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
        s_pitch = math.sin(pitch)
        c_pitch = math.cos(pitch)
        z1 = s_pitch * c_lam + c_pitch * s_lam
        z2 = c_roll * z1
        e2z = math.sin(roll)
        c_steer = math.cos(steer)
        z3 = e2z * s_steer - c_steer * z2
        z4 = c_pitch * c_lam - s_pitch * s_lam
        z5 = c_roll * z4
        z6 = c_lam * z3 + s_lam * z5
        z7 = c_lam * z5 - s_lam * z3
        z8 = 1.0 / math.sqrt(z6 * z6 + z7 * z7)
        z9 = r_F * z8
        z10 = z3 * z9
        z11 = k2 + z10
        z12 = c_roll * c_roll
        z13 = 1.0 / math.sqrt(z12)
        z14 = r_R * z13
        z15 = k3 + z2 * z14 + c_steer * z11
        z16 = z5 * z9
        z17 = k4 + z16
        z18 = z5 * z14 - z17
        z19 = s_steer * z18
        z20 = z1 * z17
        s1 = c_roll * (c_steer * z20 + z4 * (c_steer * k3 + z11))
        z21 = s1 + e2z * z19
        z22 = c_steer * z18
        s2 = c_roll * (k3 * (s_steer * z4) + s_steer * z20) - e2z * z22
        z23 = z10 * (z22 * z21 + s2 * z19)
        z24 = k5 * (9.0 + abs(z13))
        s3 = s_steer * z2 * z11
        s4 = s3 + e2z * z15
        s5 = z15 * (z16 * z21)
        s6 = s4 * (z16 * z19)
        s7 = s6 - s5 - z23
        s8 = (z24 + k12) * (z24 + k13)
        # the coframe is singular
        if not abs(s7) > 1e-15 * (k10 * s8):
            raise _refuse(abs(s7), 1e-15 * (k10 * s8), 1, "outputs")
        z25 = r_F * z7
        s9 = z - s_pitch * c_roll * k1 + r_R * (c_pitch * c_roll)
        z26 = s9 - c * z6 - z25 + z6 * (z6 * z9)
        out: list[float] = [
            # speed 123:10
            -thR_dot * r_R,
            # rear_height 124:16
            z + z12 * z14,
            # front_height 125:17
            z26 + z8 * (z7 * z25),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
