/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:0bb95d07c59f119f)
 * Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x ahead, y right, z down.
 * Source: bicycle.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with roll', steer', thF': the dependent velocities of the spec (x', y', z',
 *     yaw', pitch', thF') are singular somewhere
 * bicycle.h says what each function does.
 */
#include "bicycle.h"

#include <float.h>
#include <math.h>

const char *const bicycle_coordinate_names[] = {
    "x",
    "y",
    "z",
    "yaw",
    "roll",
    "pitch",
    "steer",
    "thR",
    "thF"
};
const char *const bicycle_state_names[] = {
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
    "thF'"
};
const char *const bicycle_parameter_names[] = {
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
    "F_yy"
};
const double bicycle_parameter_defaults[] = {
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
    0.28
};

static int bicycle_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return fabs(sum) <= DBL_MAX ? BICYCLE_OK : BICYCLE_NOT_FINITE;
}

int bicycle_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = 0.5 * R_xx;
    const double k5 = 0.5 * F_xx;
    const double k6 = r_F * c_lam + c * s_lam;
    const double k7 = r_F * s_lam - c * c_lam;
    const double k8 = c_lam * k6;
    const double k9 = s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(c);
    const double k13 = k11 + k12;
    const double k14 = k13 + (k10 + k13) + (k13 + (fabs(w) + k12 + k13));
    const double k15 = k13 + k14;
    const double k16 = 3.0 * k13;
    const double k17 = k14 + k15;
    const double k18 = s_lam * s_lam;
    const double k19 = c_lam * c_lam;
    const double k20 = 0.5 * H_zz + k5;
    const double k21 = 0.5 * H_xx + k5;
    const double k22 = k4 + 0.5 * B_xx;
    const double k23 = k4 + 0.5 * B_zz;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = e2z * s_steer;
    const double z6 = c_steer * z4 - z5;
    const double z7 = z2 * s_lam;
    const double z8 = z7 - e3z * c_lam;
    const double z9 = c_lam * z6 + s_lam * z8;
    const double z10 = c_lam * z8 - s_lam * z6;
    const double z11 = z9 * z9 + z10 * z10;
    const double z12 = 1.0 / sqrt(z11);
    const double z13 = s_steer * z12;
    const double z14 = e2z * c_steer;
    const double z15 = z14 + 2.0 * (s_steer * z3);
    const double z16 = s_lam * z1 - z13 * z15;
    const double z17 = s_steer * s_steer;
    const double z18 = z7 * z17;
    const double z19 = c_lam * z1 + 2.0 * (z12 * z18);
    const double z20 = c_roll * s_lam;
    const double z21 = z17 * z20;
    const double z22 = c_pitch * c_lam - s_pitch * s_lam;
    const double z23 = e2z * s_lam;
    const double z24 = s_steer * z23;
    const double z25 = 1.0 + z12 * z24;
    const double z26 = e3z * z17;
    const double z27 = r_R - r_F * (c_steer * z25 + z12 * z26);
    const double z28 = c_lam * (r_F * (c_pitch * z16 + (s_pitch * z19 - z12 * z21)) - c * (z1 * z22)) -
        (s_pitch * z27 + w * c_pitch);
    const double z29 = c_roll * z28;
    const double z30 = k11 * fabs(z12);
    const double z31 = 110.0 * z30;
    const double z32 = 30.0 * z30 + k16 + (80.0 * z30 + k14 + (z31 + (z31 + k15) + (1.0 + 300.0 * z30)));
    /* the coframe is singular */
    if (!(fabs(z29) > 1e-12 * (50.0 * z30 + z32))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z33 = r_R * z2;
    const double z34 = z2 * z2 + e3z * e3z;
    const double z35 = 1.0 / sqrt(z34);
    const double z36 = z33 * z35;
    const double z37 = e2y * z36;
    const double s_yaw = sin(yaw);
    const double z38 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z38;
    const double e1y = c_pitch * s_yaw + s_pitch * z38;
    const double z39 = r_R * e3z;
    const double R3 = z39 * z35;
    const double z40 = e3y * z36 + e1y * R3;
    const double z41 = e2y * R3;
    const double z42 = c_steer * k7;
    const double z43 = r_R - s_lam * z42 - k8;
    const double z44 = k2 + c_lam * z42 - k9;
    const double z45 = s_pitch * z43 + c_pitch * z44;
    const double z46 = s_steer * k7;
    const double z47 = c_pitch * z43 - s_pitch * z44;
    const double z48 = c_roll * z46 - e2z * z47;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z49 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z49 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z50 = r_F * z9;
    const double z51 = z50 * z12;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z52 = r_F * z10;
    const double z53 = z52 * z12;
    const double z54 = h3y * z51 - h1y * z53;
    const double z55 = e2y * c_steer;
    const double z56 = s_steer * z49;
    const double h2y = z55 - z56;
    const double z57 = h2y * z51;
    const double z58 = h2y * z53;
    const double z59 = s_lam * z57 + c_lam * z58;
    const double z60 = s_steer * z54 - c_steer * z59;
    const double z61 = c_lam * z57 - s_lam * z58;
    const double z62 = s_lam * z60 - c_lam * z61;
    const double z63 = c_steer * z54 + s_steer * z59;
    const double z64 = c_lam * z60 + s_lam * z61;
    const double z65 = c_yaw * z45 - s_yaw * z48 + e3z * z62 + e2z * z63 + z2 * z64;
    const double z66 = e3z * z37 - e2z * z40 - z2 * z41 + z65;
    const double z67 = k10 * fabs(z35);
    const double z68 = 4.0 * z67;
    const double z69 = 190.0 * z30;
    const double z70 = 6.0 * z67 + (z69 + (140.0 * z30 + (z69 + k17)));
    /* the coframe is singular */
    if (!(fabs(-z66) > 1e-12 * (z68 + z70))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z71 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z71;
    const double e1x = c_yaw * c_pitch - z71 * s_pitch;
    const double z72 = e3x * z36 + e1x * R3;
    const double z73 = s_yaw * c_roll;
    const double z74 = z73 * z36;
    const double z75 = z73 * R3;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z76 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z76 - z73 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z77 = h3x * z51 - h1x * z53;
    const double z78 = z73 * c_steer;
    const double z79 = z76 * s_steer;
    const double z80 = z78 + z79;
    const double z81 = z80 * z51;
    const double z82 = z80 * z53;
    const double z83 = s_lam * z81 + c_lam * z82;
    const double z84 = s_steer * z77 + c_steer * z83;
    const double z85 = c_lam * z81 - s_lam * z82;
    const double z86 = s_lam * z84 + c_lam * z85;
    const double z87 = c_steer * z77 - s_steer * z83;
    const double z88 = c_lam * z84 - s_lam * z85;
    const double z89 = c_yaw * z48 + s_yaw * z45 - e3z * z86 - e2z * z87 - z2 * z88;
    const double z90 = e3z * z74 + e2z * z72 - z2 * z75 + z89;
    const double z91 = 1.0 / z66;
    const double z92 = z40 * z91;
    const double z93 = z72 + z90 * z92;
    /* the coframe is singular */
    if (!(fabs(z93) > 1e-12 * (z68 + 4.0 * (z70 * (z67 * fabs(z91)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z94 = s_steer * z22;
    const double z95 = 1.0 / z29;
    const double z96 = s_steer * z4;
    const double h2z = z14 + z96;
    const double z97 = s_pitch * c_lam + c_pitch * s_lam;
    const double z98 = s_lam * z97;
    const double z99 = c_steer * z22;
    const double z100 = c_lam * z97;
    const double z101 = c_roll * s_steer;
    const double z102 = c_pitch * e2z;
    const double z103 = e2z * s_pitch;
    const double z104 = z101 + c_steer * (s_lam * z102 + c_lam * z103);
    const double z105 = c_lam * z102 - s_lam * z103;
    const double z106 = c_pitch * R3 + s_pitch * z36;
    const double z107 = e2z * z106;
    const double z108 = r_F * (s_lam * z104 + c_lam * z105) + (c * (s_lam * z105 - c_lam * z104) - (r_R *
        z102 - (z107 + k2 * z103)));
    const double z109 = h2z * (z53 * (z98 + c_lam * z99) + z51 * (s_lam * z99 - z100)) - (z9 * (z53 * z94) -
        z108);
    const double z110 = z95 * (z10 * (z51 * z94) + z109);
    const double z111 = z94 + c_steer * z110;
    const double z112 = z51 * z111;
    const double z113 = z99 - s_steer * z110;
    const double z114 = z53 * (z98 + c_lam * z113) - z51 * (z100 - s_lam * z113);
    const double z115 = z53 * z111;
    const double z116 = s_pitch * z110;
    const double z117 = z71 * z116;
    const double z118 = c_pitch * z110;
    const double z119 = c_yaw * z118;
    const double z120 = c_pitch * z73 + z117 - z119;
    const double z121 = z71 * z118;
    const double z122 = c_yaw * z116;
    const double z123 = z121 - s_pitch * z73 + z122;
    const double z124 = z71 * s_steer - c_steer * (s_lam * z120 - c_lam * z123);
    const double z125 = c_lam * z120 + s_lam * z123;
    const double z126 = r_F * (s_lam * z124 - c_lam * z125) - (c * (s_lam * z125 + c_lam * z124) - (r_R *
        z120 + k2 * z123));
    const double z127 = h3x * z112 + (z80 * z114 - (h1x * z115 + z126));
    const double z128 = z38 * z116;
    const double z129 = s_yaw * z118;
    const double z130 = c_pitch * e2y + z128 + z129;
    const double z131 = z38 * z118;
    const double z132 = s_yaw * z116;
    const double z133 = s_pitch * e2y - z131 + z132;
    const double z134 = z38 * s_steer - c_steer * (s_lam * z130 + c_lam * z133);
    const double z135 = c_lam * z130 - s_lam * z133;
    const double z136 = r_F * (s_lam * z134 - c_lam * z135) - (c * (s_lam * z135 + c_lam * z134) - (r_R *
        z130 - k2 * z133));
    const double z137 = h3y * z112 - (h2y * z114 + (h1y * z115 - z136));
    const double z138 = z36 * z110;
    const double z139 = R3 * z110;
    const double z140 = z91 * (z137 - (e3y * z138 + (e2y * z106 + e1y * z139)));
    const double z141 = z89 * z92;
    const double z142 = 1.0 / z93;
    const double z143 = z142 * (z127 - (e3x * z138 - (z73 * z106 - e1x * z139)) + z90 * z140);
    const double z144 = z127 + z89 * z140 - z141 * z143;
    const double z145 = z65 * z92;
    const double z146 = z137 - z65 * z140 + z145 * z143;
    const double z147 = m_R * z107;
    const double z148 = z140 - z92 * z143;
    const double z149 = c_pitch - z2 * z148;
    const double z150 = s_pitch + e3z * z148;
    const double z151 = z144 * (m_R * z144) + z146 * (m_R * z146) + z107 * z147 + z149 * (2.0 * (k22 * z149)
        + B_xz * z150);
    const double z152 = z110 - e2z * z148;
    const double z153 = c_lam * z149 - s_lam * z150;
    const double z154 = c_steer * z153 - s_steer * z152;
    const double z155 = s_lam * z149 + c_lam * z150;
    const double z156 = c_lam * z154 + s_lam * z155;
    const double z157 = c_lam * z155 - s_lam * z154;
    const double z158 = z151 + z152 * (B_yy * z152) + z150 * (B_xz * z149 + 2.0 * (k23 * z150)) + z156 * (2.0
        * (k21 * z156) + H_xz * z157);
    const double z159 = c_steer * z152 + s_steer * z153;
    const double z160 = z143 + z152;
    const double z161 = z158 + z159 * (H_yy * z159) + z157 * (H_xz * z156 + 2.0 * (k20 * z157)) + z160 *
        (R_yy * z160);
    const double z162 = s_yaw * z148;
    const double z163 = c_yaw * z148;
    const double z164 = z73 + e2z * z163;
    const double z165 = z122 - c_pitch * z162 + (z121 - s_pitch * z164);
    const double z166 = z119 + s_pitch * z162 - (z117 + c_pitch * z164);
    const double z167 = z144 + x_B * z165 - k1 * z166;
    const double z168 = e2y - e2z * z162;
    const double z169 = z132 + c_pitch * z163 - (z131 - s_pitch * z168);
    const double z170 = z129 - s_pitch * z163 + (z128 + c_pitch * z168);
    const double z171 = z146 + x_B * z169 - k1 * z170;
    const double z172 = z103 + c_roll * z118;
    const double z173 = z102 - c_roll * z116;
    const double z174 = z107 + x_B * z172 - k1 * z173;
    const double z175 = m_B * z174;
    const double z176 = z144 + k2 * z165 - r_R * z166;
    const double z177 = c_steer * (c_lam * z165 + s_lam * z166) + s_steer * (z71 - c_roll * z163);
    const double z178 = s_lam * z165 - c_lam * z166;
    const double z179 = c_lam * z177 + s_lam * z178;
    const double z180 = c_lam * z178 - s_lam * z177;
    const double z181 = z176 - k3 * z179 + z_H * z180;
    const double z182 = z161 + z167 * (m_B * z167) + z171 * (m_B * z171) + z174 * z175 + z181 * (m_H * z181);
    const double z183 = z146 + k2 * z169 - r_R * z170;
    const double z184 = c_steer * (c_lam * z169 + s_lam * z170) - s_steer * (z38 + c_roll * z162);
    const double z185 = s_lam * z169 - c_lam * z170;
    const double z186 = c_lam * z184 + s_lam * z185;
    const double z187 = c_lam * z185 - s_lam * z184;
    const double z188 = z183 - k3 * z186 + z_H * z187;
    const double z189 = z107 + k2 * z172 - r_R * z173;
    const double z190 = z101 + c_steer * (c_lam * z172 + s_lam * z173);
    const double z191 = s_lam * z172 - c_lam * z173;
    const double z192 = c_lam * z190 + s_lam * z191;
    const double z193 = c_lam * z191 - s_lam * z190;
    const double z194 = z189 - k3 * z192 + z_H * z193;
    const double z195 = m_H * z194;
    const double z196 = z176 - c * z179 - r_F * z180;
    const double z197 = z183 - c * z186 - r_F * z187;
    const double z198 = z182 + z188 * (m_H * z188) + z194 * z195 + z196 * (m_F * z196) + z197 * (m_F * z197);
    const double z199 = z189 - c * z192 - r_F * z193;
    const double z200 = m_F * z199;
    const double z201 = z198 + z199 * z200 + z159 * (F_yy * z159);
    /* the mass matrix is singular */
    if (!(fabs(z201) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z202 = z95 * (h2z * (s_lam * z53 - c_lam * z51) + (r_F * (s_lam * h2z) - c * (c_lam * h2z)));
    const double z203 = c_steer * z202;
    const double z204 = z51 * z203;
    const double z205 = s_steer * z202;
    const double z206 = z53 * (s_lam - c_lam * z205) - z51 * (c_lam + s_lam * z205);
    const double z207 = z53 * z203;
    const double z208 = s_pitch * z202;
    const double z209 = z71 * z208;
    const double z210 = c_pitch * z202;
    const double z211 = c_yaw * z210;
    const double z212 = z209 - z211;
    const double z213 = z71 * z210;
    const double z214 = c_yaw * z208;
    const double z215 = z213 + z214;
    const double z216 = z78 + (z79 + c_steer * (s_lam * z212 - c_lam * z215));
    const double z217 = c_lam * z212 + s_lam * z215;
    const double z218 = r_F * (s_lam * z216 + c_lam * z217) + (c * (s_lam * z217 - c_lam * z216) - (r_R *
        z212 + k2 * z215));
    const double z219 = h3x * z204 + (z80 * z206 - (h1x * z207 - z218));
    const double z220 = z38 * z208;
    const double z221 = s_yaw * z210;
    const double z222 = z220 + z221;
    const double z223 = z38 * z210;
    const double z224 = s_yaw * z208;
    const double z225 = z223 - z224;
    const double z226 = z55 - (z56 - c_steer * (s_lam * z222 - c_lam * z225));
    const double z227 = c_lam * z222 + s_lam * z225;
    const double z228 = r_F * (s_lam * z226 + c_lam * z227) + (c * (s_lam * z227 - c_lam * z226) - (r_R *
        z222 + k2 * z225));
    const double z229 = h3y * z204 - (h2y * z206 + (h1y * z207 + z228));
    const double z230 = z36 * z202;
    const double z231 = R3 * z202;
    const double z232 = z91 * (z229 - (e3y * z230 + e1y * z231));
    const double z233 = z142 * (z219 - (e3x * z230 + e1x * z231) + z90 * z232);
    const double z234 = z219 + z89 * z232 - z141 * z233;
    const double z235 = m_R * z234;
    const double z236 = z229 - z65 * z232 + z145 * z233;
    const double z237 = m_R * z236;
    const double z238 = z232 - z92 * z233;
    const double z239 = z2 * z238;
    const double z240 = e3z * z238;
    const double z241 = 2.0 * (k22 * z239) - B_xz * z240;
    const double z242 = z202 - e2z * z238;
    const double z243 = B_yy * z242;
    const double z244 = B_xz * z239 - 2.0 * (k23 * z240);
    const double z245 = c_lam * z239 + s_lam * z240;
    const double z246 = c_steer * z245 + s_steer * z242;
    const double z247 = 1.0 - (s_lam * z239 - c_lam * z240);
    const double z248 = c_lam * z246 - s_lam * z247;
    const double z249 = c_lam * z247 + s_lam * z246;
    const double z250 = 2.0 * (k21 * z248) - H_xz * z249;
    const double z251 = z234 * z235 + z236 * z237 + z239 * z241 + z242 * z243 - z240 * z244 + z248 * z250;
    const double z252 = c_steer * z242 - s_steer * z245;
    const double z253 = H_yy * z252;
    const double z254 = H_xz * z248 - 2.0 * (k20 * z249);
    const double z255 = z233 + z242;
    const double z256 = R_yy * z255;
    const double z257 = s_yaw * z238;
    const double z258 = c_yaw * z238;
    const double z259 = e2z * z258;
    const double z260 = z214 - c_pitch * z257 + (z213 - s_pitch * z259);
    const double z261 = z211 + s_pitch * z257 - (z209 + c_pitch * z259);
    const double z262 = z234 + x_B * z260 - k1 * z261;
    const double z263 = m_B * z262;
    const double z264 = e2z * z257;
    const double z265 = z224 + c_pitch * z258 - (z223 + s_pitch * z264);
    const double z266 = z221 - s_pitch * z258 + (z220 - c_pitch * z264);
    const double z267 = z236 + x_B * z265 - k1 * z266;
    const double z268 = m_B * z267;
    const double z269 = c_roll * z210;
    const double z270 = c_roll * z208;
    const double z271 = x_B * z269 + k1 * z270;
    const double z272 = m_B * z271;
    const double z273 = z251 + z252 * z253 - z249 * z254 + z255 * z256 + z262 * z263 + z267 * z268 + z271 *
        z272;
    const double z274 = z234 + k2 * z260 - r_R * z261;
    const double z275 = z79 - c_steer * (c_lam * z260 + s_lam * z261) + (z78 + s_steer * (c_roll * z258));
    const double z276 = s_lam * z260 - c_lam * z261;
    const double z277 = c_lam * z275 - s_lam * z276;
    const double z278 = c_lam * z276 + s_lam * z275;
    const double z279 = z274 + k3 * z277 + z_H * z278;
    const double z280 = m_H * z279;
    const double z281 = z236 + k2 * z265 - r_R * z266;
    const double z282 = z56 - c_steer * (c_lam * z265 + s_lam * z266) - (z55 - s_steer * (c_roll * z257));
    const double z283 = s_lam * z265 - c_lam * z266;
    const double z284 = c_lam * z282 - s_lam * z283;
    const double z285 = c_lam * z283 + s_lam * z282;
    const double z286 = z281 + k3 * z284 + z_H * z285;
    const double z287 = m_H * z286;
    const double z288 = k2 * z269 + r_R * z270;
    const double z289 = z14 + (z96 + c_steer * (c_lam * z269 - s_lam * z270));
    const double z290 = s_lam * z269 + c_lam * z270;
    const double z291 = c_lam * z289 + s_lam * z290;
    const double z292 = c_lam * z290 - s_lam * z289;
    const double z293 = z288 - k3 * z291 + z_H * z292;
    const double z294 = m_H * z293;
    const double z295 = z274 + c * z277 - r_F * z278;
    const double z296 = m_F * z295;
    const double z297 = z281 + c * z284 - r_F * z285;
    const double z298 = m_F * z297;
    const double z299 = z288 - c * z291 - r_F * z292;
    const double z300 = m_F * z299;
    const double z301 = z273 + z279 * z280 + z286 * z287 + z293 * z294 + z295 * z296 + z297 * z298 + z299 *
        z300;
    const double z302 = F_yy * z252;
    const double z303 = z301 + z252 * z302;
    const double z304 = z144 * z235 + z146 * z237 - z149 * z241 + z152 * z243 - z150 * z244 - z156 * z250;
    const double z305 = z304 + z159 * z253 - z157 * z254 + z160 * z256 + z167 * z263 + z171 * z268 + z174 *
        z272;
    const double z306 = z305 + z181 * z280 + z188 * z287 + z194 * z294 + z196 * z296 + z197 * z298 + z199 *
        z300;
    const double z307 = z306 + z159 * z302;
    const double z308 = 1.0 / z201;
    const double z309 = z307 * z308;
    const double z310 = z303 - z307 * z309;
    /* the mass matrix is singular */
    if (!(fabs(z310) > 1e-14 * z303)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z311 = z54 * z91;
    const double z312 = z142 * (z77 + z90 * z311);
    const double z313 = z77 + z89 * z311 - z141 * z312;
    const double z314 = m_R * z313;
    const double z315 = z54 - z65 * z311 + z145 * z312;
    const double z316 = m_R * z315;
    const double z317 = z311 - z92 * z312;
    const double z318 = z2 * z317;
    const double z319 = e3z * z317;
    const double z320 = 2.0 * (k22 * z318) - B_xz * z319;
    const double z321 = e2z * z317;
    const double z322 = B_yy * z321;
    const double z323 = B_xz * z318 - 2.0 * (k23 * z319);
    const double z324 = c_lam * z318 + s_lam * z319;
    const double z325 = c_steer * z324 - s_steer * z321;
    const double z326 = s_lam * z318 - c_lam * z319;
    const double z327 = c_lam * z325 + s_lam * z326;
    const double z328 = c_lam * z326 - s_lam * z325;
    const double z329 = 2.0 * (k21 * z327) + H_xz * z328;
    const double z330 = z313 * z314 + z315 * z316 + z318 * z320 + z321 * z322 - z319 * z323 + z327 * z329;
    const double z331 = c_steer * z321 + s_steer * z324;
    const double z332 = H_yy * z331;
    const double z333 = H_xz * z327 + 2.0 * (k20 * z328);
    const double z334 = z312 - z321;
    const double z335 = R_yy * z334;
    const double z336 = s_yaw * z317;
    const double z337 = c_yaw * z317;
    const double z338 = e2z * z337;
    const double z339 = c_pitch * z336 + s_pitch * z338;
    const double z340 = s_pitch * z336 - c_pitch * z338;
    const double z341 = z313 - x_B * z339 - k1 * z340;
    const double z342 = m_B * z341;
    const double z343 = e2z * z336;
    const double z344 = c_pitch * z337 - s_pitch * z343;
    const double z345 = s_pitch * z337 + c_pitch * z343;
    const double z346 = z315 + x_B * z344 + k1 * z345;
    const double z347 = m_B * z346;
    const double z348 = z313 - k2 * z339 - r_R * z340;
    const double z349 = c_steer * (c_lam * z339 - s_lam * z340) + s_steer * (c_roll * z337);
    const double z350 = s_lam * z339 + c_lam * z340;
    const double z351 = c_lam * z349 + s_lam * z350;
    const double z352 = c_lam * z350 - s_lam * z349;
    const double z353 = z348 + k3 * z351 - z_H * z352;
    const double z354 = m_H * z353;
    const double z355 = z330 + z331 * z332 + z328 * z333 + z334 * z335 + z341 * z342 + z346 * z347 + z353 *
        z354;
    const double z356 = z315 + k2 * z344 + r_R * z345;
    const double z357 = c_steer * (c_lam * z344 - s_lam * z345) - s_steer * (c_roll * z336);
    const double z358 = s_lam * z344 + c_lam * z345;
    const double z359 = c_lam * z357 + s_lam * z358;
    const double z360 = c_lam * z358 - s_lam * z357;
    const double z361 = z356 - k3 * z359 + z_H * z360;
    const double z362 = m_H * z361;
    const double z363 = z348 + c * z351 + r_F * z352;
    const double z364 = m_F * z363;
    const double z365 = z356 - c * z359 - r_F * z360;
    const double z366 = m_F * z365;
    const double z367 = 1.0 - z331;
    const double z368 = F_yy * z367;
    const double z369 = z355 + z361 * z362 + z363 * z364 + z365 * z366 + z367 * z368;
    const double z370 = z144 * z314 + z146 * z316 - z149 * z320 - z152 * z322 - z150 * z323 - z156 * z329;
    const double z371 = z370 - z159 * z332 - z157 * z333 + z160 * z335 + z167 * z342 + z171 * z347 + z181 *
        z354;
    const double z372 = z371 + z188 * z362 + z196 * z364 + z197 * z366 + z159 * z368;
    const double z373 = z372 * z308;
    const double z374 = z234 * z314 + z236 * z316 + z239 * z320 - z242 * z322 - z240 * z323 + z248 * z329;
    const double z375 = z374 - z252 * z332 - z249 * z333 + z255 * z335 + z262 * z342 + z267 * z347 + z279 *
        z354;
    const double z376 = z375 + z286 * z362 + z295 * z364 + z297 * z366 + z252 * z368 - z307 * z373;
    const double z377 = 1.0 / z310;
    const double z378 = z376 * z377;
    const double z379 = z369 - z372 * z373 - z376 * z378;
    /* the mass matrix is singular */
    if (!(fabs(z379) > 1e-14 * z369)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z380 = roll_dot * s_pitch;
    const double z381 = roll_dot * c_pitch;
    const double z382 = s_lam * z380 - c_lam * z381;
    const double z383 = s_steer * z382;
    const double z384 = z51 * z383;
    const double z385 = steer_dot + (c_lam * z380 + s_lam * z381);
    const double z386 = s_lam * z385;
    const double z387 = c_steer * z382;
    const double z388 = z386 - c_lam * z387;
    const double z389 = c_lam * z385;
    const double z390 = s_lam * z387 + z389;
    const double z391 = z53 * z388 - z51 * z390;
    const double z392 = z53 * z383;
    const double z393 = roll_dot * c_roll;
    const double z394 = steer_dot * c_steer;
    const double z395 = s_steer * z393 + e2z * z394;
    const double z396 = steer_dot * s_steer;
    const double z397 = z4 * z396;
    const double z398 = roll_dot * e2z;
    const double z399 = c_pitch * z398;
    const double z400 = s_pitch * z398;
    const double z401 = s_lam * z399 + c_lam * z400;
    const double z402 = z395 + (z397 + c_steer * z401);
    const double z403 = c_lam * z399 - s_lam * z400;
    const double z404 = z381 * R3 + z380 * z36;
    const double z405 = e2z * z404;
    const double z406 = r_F * (s_lam * z402 + c_lam * z403) + (c * (s_lam * z403 - c_lam * z402) - (r_R *
        z399 - (z405 + k2 * z400)));
    const double z407 = z10 * z384 - (h2z * z391 + (z9 * z392 + z406));
    const double z408 = z95 * z407;
    const double z409 = thF_dot + (z383 + c_steer * z408);
    const double z410 = z51 * z409;
    const double z411 = s_steer * z408;
    const double z412 = z387 - z411;
    const double z413 = z386 - c_lam * z412;
    const double z414 = z389 + s_lam * z412;
    const double z415 = z53 * z413 - z51 * z414;
    const double z416 = z53 * z409;
    const double z417 = z73 * z394;
    const double z418 = s_yaw * z398;
    const double z419 = z76 * z396;
    const double z420 = s_yaw * z393;
    const double z421 = s_pitch * z408;
    const double z422 = z71 * z421;
    const double z423 = c_pitch * z408;
    const double z424 = c_yaw * z423;
    const double z425 = c_pitch * z420 - z422 + z424;
    const double z426 = z71 * z423;
    const double z427 = c_yaw * z421;
    const double z428 = s_pitch * z420 + z426 + z427;
    const double z429 = s_lam * z425 + c_lam * z428;
    const double z430 = z417 - s_steer * z418 + (z419 + c_steer * z429);
    const double z431 = c_lam * z425 - s_lam * z428;
    const double z432 = r_F * (s_lam * z430 + c_lam * z431) + (c * (s_lam * z431 - c_lam * z430) - (r_R *
        z425 - k2 * z428));
    const double z433 = h3x * z410 - (z80 * z415 + (h1x * z416 + z432));
    const double z434 = e2y * z394;
    const double z435 = c_yaw * z398;
    const double z436 = z49 * z396;
    const double z437 = c_yaw * z393;
    const double z438 = z38 * z421;
    const double z439 = s_yaw * z423;
    const double z440 = c_pitch * z437 - z438 - z439;
    const double z441 = z38 * z423;
    const double z442 = s_yaw * z421;
    const double z443 = s_pitch * z437 + z441 - z442;
    const double z444 = s_lam * z440 + c_lam * z443;
    const double z445 = z434 - s_steer * z435 - (z436 - c_steer * z444);
    const double z446 = c_lam * z440 - s_lam * z443;
    const double z447 = r_F * (s_lam * z445 + c_lam * z446) + (c * (s_lam * z446 - c_lam * z445) - (r_R *
        z440 - k2 * z443));
    const double z448 = h3y * z410 + (h2y * z415 - (h1y * z416 - z447));
    const double z449 = z36 * z408;
    const double z450 = R3 * z408;
    const double z451 = z448 - (e3y * z449 - (e2y * z404 - e1y * z450));
    const double z452 = z91 * z451;
    const double z453 = z433 - (e3x * z449 + (z73 * z404 + e1x * z450)) + z90 * z452;
    const double z454 = z142 * z453;
    /* (I.2.15) */
    dydt[0] = z141 * z454 - (z433 + z89 * z452); /* x' */
    dydt[1] = -(z448 - z65 * z452 + z145 * z454); /* y' */
    dydt[2] = z405; /* z' */
    const double z455 = z452 - z92 * z454;
    dydt[3] = -z455; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = z408; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = z454; /* thR' */
    dydt[8] = thF_dot; /* thF' */
    const double w2 = z408 - e2z * z455;
    const double w1 = z381 + z2 * z455;
    const double w3 = z380 - e3z * z455;
    const double z456 = c_lam * w1 - s_lam * w3;
    const double o2 = c_steer * w2 - s_steer * z456;
    const double z457 = F_yy * (thF_dot + o2);
    const double z458 = s_lam * s_steer;
    const double z459 = s_lam * z394;
    const double z460 = c_lam * s_steer;
    const double z461 = c_lam * z394;
    const double z462 = c_steer * z393 - e2z * z396;
    const double z463 = z399 + c_roll * z421;
    const double z464 = z400 - c_roll * z423;
    const double z465 = z462 - (z458 * z463 - e3z * z459) - (z460 * z464 - z2 * z461);
    const double z466 = z396 * z110 + (z423 * z458 + s_pitch * z459 + (z421 * z460 - c_pitch * z461) + z148 *
        z465);
    const double z467 = z455 * (c_roll * c_steer - z458 * z173 - z460 * z172) + roll_dot * (z118 * z458 +
        z116 * z460);
    const double z468 = z466 + z467;
    const double z469 = s_lam * z396;
    const double z470 = c_lam * z464;
    const double z471 = z470 + s_lam * z463;
    const double z472 = z395 + (z397 + c_steer * z471);
    const double z473 = s_lam * z464;
    const double z474 = z473 - c_lam * z463;
    const double z475 = c_lam * z472 + s_lam * z474;
    const double z476 = c_lam * z474 - s_lam * z472;
    const double z477 = z12 * (2.0 * (z9 * z475) + 2.0 * (z10 * z476)) / z11;
    const double z478 = z15 * (z394 * z12 + 0.5 * (s_steer * z477)) + z13 * (z462 + 2.0 * (z3 * z394 -
        s_steer * z470));
    const double z479 = c_lam * z396;
    const double z480 = s_steer * z394;
    const double z481 = s_pitch * (z479 + 2.0 * (0.5 * (z18 * z477) - z12 * (z17 * z473 - 2.0 * (z7 *
        z480))));
    const double z482 = z19 * z423 + z481 - (0.5 * (z21 * z477) + z12 * (2.0 * (z20 * z480) - z17 * (s_lam *
        z398)));
    const double z483 = r_F * (z16 * z421 - c_pitch * (z469 - z478) - z482) + c * (z396 * z22 - z1 * (c_lam *
        z421 + s_lam * z423));
    const double z484 = z396 * z25 - c_steer * (0.5 * (z24 * z477) + z12 * (z394 * z23 + s_steer * (s_lam *
        z393)));
    const double z485 = s_pitch * (r_F * (z484 - (0.5 * (z26 * z477) - z12 * (z17 * z463 - 2.0 * (e3z *
        z480)))));
    const double z486 = (z398 * z28 + c_roll * (c_lam * z483 + (z27 * z423 + z485 - w * z421))) / (z29 * z29);
    const double z487 = z12 * (r_F * z475) - 0.5 * (z50 * z477);
    const double z488 = roll_dot * z423;
    const double z489 = roll_dot * z421;
    const double z490 = s_lam * z488 + c_lam * z489;
    const double z491 = z394 * z382 + s_steer * z490;
    const double z492 = z12 * (r_F * z476) - 0.5 * (z52 * z477);
    const double z493 = c_lam * z488 - s_lam * z489;
    const double z494 = s_lam * z493;
    const double z495 = z396 * z382 - c_steer * z490;
    const double z496 = c_lam * z493;
    const double z497 = z388 * z492 - z53 * (z494 + c_lam * z495) - (z390 * z487 + z51 * (s_lam * z495 -
        z496));
    const double z498 = z393 * z394;
    const double z499 = roll_dot * z398;
    const double z500 = steer_dot * z396;
    const double z501 = z498 - s_steer * z499 + (z498 - e2z * z500);
    const double z502 = z396 * z471;
    const double z503 = steer_dot * z394;
    const double z504 = z502 - z4 * z503;
    const double z505 = z398 * z421;
    const double z506 = roll_dot * z393;
    const double z507 = z505 - c_pitch * z506;
    const double z508 = z398 * z423;
    const double z509 = z508 + s_pitch * z506;
    const double z510 = z501 - (z504 + (z396 * z401 + c_steer * (s_lam * z507 - c_lam * z509)));
    const double z511 = c_lam * z507 + s_lam * z509;
    const double z512 = z35 * (2.0 * (z2 * z464) + 2.0 * (e3z * z463)) / z34;
    const double z513 = z35 * (r_R * z463) - 0.5 * (z39 * z512);
    const double z514 = z35 * (r_R * z464) - 0.5 * (z33 * z512);
    const double z515 = R3 * z489 + z381 * z513 - (z36 * z488 - z380 * z514);
    const double z516 = z393 * z404 - e2z * z515;
    const double z517 = r_F * (s_lam * z510 - c_lam * z511) - (c * (s_lam * z511 + c_lam * z510) - (r_R *
        z507 + (z516 + k2 * z509)));
    const double z518 = z391 * (z462 + (z4 * z394 - s_steer * z471)) - h2z * z497 - (z392 * z475 + z9 * (z383
        * z492 - z53 * z491) - z517);
    const double z519 = z407 * z486 - z95 * (z384 * z476 + z10 * (z383 * z487 - z51 * z491) + z518);
    const double z520 = s_yaw * z455;
    const double z521 = z435 - c_roll * z520;
    const double z522 = c_yaw * z455;
    const double z523 = z437 + e2z * z520;
    const double z524 = z439 - s_pitch * z522 + (z438 - c_pitch * z523);
    const double z525 = z442 + c_pitch * z522 - (z441 + s_pitch * z523);
    const double z526 = z36 * z524 - e3y * z514 - (R3 * z525 + e1y * z513);
    const double z527 = z37 * z463 + e3z * (z36 * z521 + e2y * z514) + (z393 * z40 + e2z * z526) - (z41 *
        z464 + z2 * (R3 * z521 + e2y * z513));
    const double z528 = z396 * k7;
    const double z529 = s_lam * z528;
    const double z530 = c_lam * z528;
    const double z531 = z43 * z423 + s_pitch * z529 - (z44 * z421 + c_pitch * z530);
    const double z532 = z398 * z46 - c_roll * (z394 * k7) + (z393 * z47 - e2z * (z43 * z421 - c_pitch * z529
        + (z44 * z423 - s_pitch * z530)));
    const double z533 = s_lam * z525 - c_lam * z524;
    const double z534 = c_lam * z525 + s_lam * z524;
    const double z535 = z436 + c_steer * z534 - (z434 - s_steer * z521);
    const double z536 = c_lam * z533 - s_lam * z535;
    const double z537 = c_lam * z535 + s_lam * z533;
    const double z538 = z51 * z536 + h3y * z487 - (z53 * z537 + h1y * z492);
    const double z539 = c_steer * z521 + e2y * z396 + (z49 * z394 - s_steer * z534);
    const double z540 = z51 * z539 + h2y * z487;
    const double z541 = z53 * z539 + h2y * z492;
    const double z542 = s_lam * z540 + c_lam * z541;
    const double z543 = z394 * z54 - s_steer * z538 + (z396 * z59 + c_steer * z542);
    const double z544 = c_lam * z540 - s_lam * z541;
    const double z545 = z45 * z520 + c_yaw * z531 + (z48 * z522 + s_yaw * z532) - (z62 * z463 - e3z * (s_lam
        * z543 + c_lam * z544));
    const double z546 = z545 + (z393 * z63 - e2z * (z396 * z54 + c_steer * z538 - (z394 * z59 - s_steer *
        z542)));
    const double z547 = z546 - (z64 * z464 - z2 * (c_lam * z543 - s_lam * z544));
    const double z548 = (z527 - z547) / (z66 * z66);
    const double z549 = z491 - (z396 * z408 - c_steer * z519);
    const double z550 = z409 * z487 - z51 * z549;
    const double z551 = z495 + (z394 * z408 + s_steer * z519);
    const double z552 = z413 * z492 - z53 * (z494 + c_lam * z551) - (z414 * z487 - z51 * (z496 - s_lam *
        z551));
    const double z553 = z409 * z492 - z53 * z549;
    const double z554 = z394 * z521;
    const double z555 = z554 + e2y * z500;
    const double z556 = z398 * z520;
    const double z557 = z556 + c_yaw * z506;
    const double z558 = z396 * z534;
    const double z559 = z558 - z49 * z503;
    const double z560 = z393 * z520;
    const double z561 = z560 - c_yaw * z499;
    const double z562 = z421 * z523;
    const double z563 = z408 * z423 + s_pitch * z519;
    const double z564 = z562 + z38 * z563;
    const double z565 = z423 * z522;
    const double z566 = z408 * z421 - c_pitch * z519;
    const double z567 = z565 + s_yaw * z566;
    const double z568 = z437 * z421 - c_pitch * z561 + z564 - z567;
    const double z569 = z423 * z523;
    const double z570 = z569 - z38 * z566;
    const double z571 = z421 * z522;
    const double z572 = z571 - s_yaw * z563;
    const double z573 = z437 * z423 + s_pitch * z561 + z570 + z572;
    const double z574 = z555 + (z394 * z435 + s_steer * z557) - (z559 - (z396 * z444 + c_steer * (s_lam *
        z568 - c_lam * z573)));
    const double z575 = c_lam * z568 + s_lam * z573;
    const double z576 = r_F * (s_lam * z574 + c_lam * z575) + (c * (s_lam * z575 - c_lam * z574) - (r_R *
        z568 + k2 * z573));
    const double z577 = z410 * z536 + h3y * z550 + (z415 * z539 + h2y * z552 - (z416 * z537 + h1y * z553 -
        z576));
    const double z578 = z408 * z514 - z36 * z519;
    const double z579 = z408 * z513 - R3 * z519;
    const double z580 = z449 * z524 - e3y * z578 + (z404 * z521 + e2y * z515 - (z450 * z525 + e1y * z579));
    const double z581 = z451 * z548 - z91 * (z577 + z580);
    const double z582 = z91 * z526 + z40 * z548;
    const double z583 = z420 - e2z * z522;
    const double z584 = z424 + s_pitch * z520 - (z422 - c_pitch * z583);
    const double z585 = z427 - c_pitch * z520 + (z426 + s_pitch * z583);
    const double z586 = z36 * z584 - e3x * z514 - (R3 * z585 + e1x * z513);
    const double z587 = z418 + c_roll * z522;
    const double z588 = z74 * z463 + e3z * (z36 * z587 + z73 * z514) - (z393 * z72 + e2z * z586) - (z75 *
        z464 + z2 * (R3 * z587 + z73 * z513));
    const double z589 = s_lam * z585 - c_lam * z584;
    const double z590 = c_lam * z585 + s_lam * z584;
    const double z591 = z419 + c_steer * z590 + (z417 - s_steer * z587);
    const double z592 = c_lam * z589 - s_lam * z591;
    const double z593 = c_lam * z591 + s_lam * z589;
    const double z594 = z51 * z592 + h3x * z487 - (z53 * z593 + h1x * z492);
    const double z595 = c_steer * z587 + z73 * z396 + (s_steer * z590 - z76 * z394);
    const double z596 = z51 * z595 + z80 * z487;
    const double z597 = z53 * z595 + z80 * z492;
    const double z598 = s_lam * z596 + c_lam * z597;
    const double z599 = z394 * z77 - s_steer * z594 - (z396 * z83 + c_steer * z598);
    const double z600 = c_lam * z596 - s_lam * z597;
    const double z601 = z48 * z520 - c_yaw * z532 - (z45 * z522 - s_yaw * z531) + (z86 * z463 - e3z * (s_lam
        * z599 - c_lam * z600));
    const double z602 = z601 - (z393 * z87 - e2z * (z396 * z77 + c_steer * z594 + (z394 * z83 - s_steer *
        z598)));
    const double z603 = z602 + (z88 * z464 - z2 * (c_lam * z599 + s_lam * z600));
    const double z604 = z588 - z603;
    const double z605 = z394 * z587;
    const double z606 = z605 + z73 * z500;
    const double z607 = z398 * z522;
    const double z608 = z607 - s_yaw * z506;
    const double z609 = z396 * z590;
    const double z610 = z609 - z76 * z503;
    const double z611 = z393 * z522;
    const double z612 = z611 + s_yaw * z499;
    const double z613 = z421 * z583;
    const double z614 = z613 + z71 * z563;
    const double z615 = z423 * z520;
    const double z616 = z615 - c_yaw * z566;
    const double z617 = z420 * z421 + c_pitch * z612 + z614 - z616;
    const double z618 = z423 * z583;
    const double z619 = z618 - z71 * z566;
    const double z620 = z421 * z520;
    const double z621 = z620 + c_yaw * z563;
    const double z622 = z420 * z423 - s_pitch * z612 + z619 + z621;
    const double z623 = z606 + (z418 * z394 - s_steer * z608) + (z610 + (z396 * z429 + c_steer * (s_lam *
        z617 - c_lam * z622)));
    const double z624 = c_lam * z617 + s_lam * z622;
    const double z625 = r_F * (s_lam * z623 + c_lam * z624) + (c * (s_lam * z624 - c_lam * z623) - (r_R *
        z617 + k2 * z622));
    const double z626 = z410 * z592 + h3x * z550 - (z415 * z595 + z80 * z552 + (z416 * z593 + h1x * z553 +
        z625));
    const double z627 = z449 * z584 - e3x * z578 - (z404 * z587 + z73 * z515 + (z450 * z585 + e1x * z579));
    const double z628 = z453 * ((z586 - (z92 * z604 - z90 * z582)) / (z93 * z93)) + z142 * (z626 + z627 +
        (z452 * z604 - z90 * z581));
    const double z629 = z581 - (z454 * z582 - z92 * z628);
    const double z630 = z519 - (z393 * z455 + e2z * z629);
    const double z631 = z489 + (z455 * z464 - z2 * z629);
    const double z632 = z488 + (z455 * z463 - e3z * z629);
    const double z633 = c_lam * z631 + s_lam * z632;
    const double z634 = z396 * w2 - c_steer * z630 + (z394 * z456 - s_steer * z633);
    const double z635 = F_yy * z634;
    const double z636 = z509 + (z508 + c_roll * z566);
    const double z637 = z507 + (z505 - c_roll * z563);
    const double z638 = z516 + k2 * z636 + r_R * z637;
    const double z639 = z501 - (z504 + (z502 - c_steer * (c_lam * z636 - s_lam * z637)));
    const double z640 = s_lam * z636 + c_lam * z637;
    const double z641 = c_lam * z639 + s_lam * z640;
    const double z642 = c_lam * z640 - s_lam * z639;
    const double z643 = m_F * (z638 - c * z641 - r_F * z642);
    const double z644 = z577 + (z452 * z547 + z65 * z581) - (z454 * (z92 * z547 + z65 * z582) - z145 * z628);
    const double z645 = z455 * z520 + c_yaw * z629;
    const double z646 = z455 * z522 - s_yaw * z629;
    const double z647 = z561 + (z560 - e2z * z646);
    const double z648 = z572 + (z571 - c_pitch * z645) + (z570 + (z569 + s_pitch * z647));
    const double z649 = z567 + (z565 + s_pitch * z645) - (z564 + (z562 - c_pitch * z647));
    const double z650 = z644 + k2 * z648 - r_R * z649;
    const double z651 = z559 + (z558 + c_steer * (c_lam * z648 + s_lam * z649)) - (z555 + (z554 + s_steer *
        (z557 + (z556 + c_roll * z646))));
    const double z652 = s_lam * z648 - c_lam * z649;
    const double z653 = c_lam * z651 + s_lam * z652;
    const double z654 = c_lam * z652 - s_lam * z651;
    const double z655 = m_F * (z650 - c * z653 - r_F * z654);
    const double z656 = z626 - (z452 * z603 + z89 * z581) + (z454 * (z92 * z603 + z89 * z582) - z141 * z628);
    const double z657 = z612 + (z611 + e2z * z645);
    const double z658 = z621 + (z620 + c_pitch * z646) + (z619 + (z618 - s_pitch * z657));
    const double z659 = z616 + (z615 - s_pitch * z646) - (z614 + (z613 + c_pitch * z657));
    const double z660 = z656 - k2 * z658 + r_R * z659;
    const double z661 = z610 + (z609 - c_steer * (c_lam * z658 + s_lam * z659)) + (z606 + (z605 - s_steer *
        (z608 + (z607 - c_roll * z645))));
    const double z662 = s_lam * z658 - c_lam * z659;
    const double z663 = c_lam * z661 - s_lam * z662;
    const double z664 = c_lam * z662 + s_lam * z661;
    const double z665 = m_F * (z660 - c * z663 + r_F * z664);
    const double z666 = m_H * (z638 - k3 * z641 + z_H * z642);
    const double z667 = m_H * (z650 - k3 * z653 + z_H * z654);
    const double z668 = m_H * (z660 - k3 * z663 - z_H * z664);
    const double z669 = m_B * (z516 + x_B * z636 + k1 * z637);
    const double z670 = m_B * (z644 + x_B * z648 - k1 * z649);
    const double z671 = m_B * (z656 - x_B * z658 + k1 * z659);
    const double z672 = R_yy * (z454 + w2);
    const double z673 = z393 * z148 + c_roll * z455;
    const double z674 = R_yy * (z628 - z630);
    const double wf = c_steer * z456 + s_steer * w2;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double o1 = c_lam * wf + s_lam * ws;
    const double o3 = c_lam * ws - s_lam * wf;
    const double z675 = H_xz * o1 + 2.0 * (k20 * o3);
    const double z676 = s_lam * c_steer;
    const double z677 = s_lam * z676 + k19;
    const double z678 = s_lam * z469;
    const double z679 = c_lam * (s_lam - z676);
    const double z680 = c_lam * z469;
    const double z681 = z677 * z463 + e3z * z678 + (z393 * z458 + e2z * z459) - (z679 * z464 - z2 * z680);
    const double z682 = z110 * z459 + (z423 * z677 - s_pitch * z678 - (z421 * z679 - c_pitch * z680) - z148 *
        z681);
    const double z683 = z455 * (z677 * z173 + c_roll * z458 - z679 * z172) - roll_dot * (z118 * z677 - z116 *
        z679);
    const double z684 = z396 * z456 + c_steer * z633 - (z394 * w2 + s_steer * z630);
    const double z685 = s_lam * z631 - c_lam * z632;
    const double z686 = c_lam * z684 + s_lam * z685;
    const double z687 = c_lam * z685 - s_lam * z684;
    const double z688 = H_xz * z686 + 2.0 * (k20 * z687);
    const double z689 = H_yy * o2;
    const double z690 = H_yy * z634;
    const double z691 = H_xz * o3 + 2.0 * (k21 * o1);
    const double z692 = c_lam * c_steer;
    const double z693 = s_lam * (c_lam - z692);
    const double z694 = s_lam * z479;
    const double z695 = c_lam * z692 + k18;
    const double z696 = c_lam * z479;
    const double z697 = z693 * z463 - e3z * z694 - (z393 * z460 + e2z * z461) - (z695 * z464 + z2 * z696);
    const double z698 = z110 * z461 - (z423 * z693 + s_pitch * z694 - (z421 * z695 + c_pitch * z696) - z148 *
        z697);
    const double z699 = z455 * (z693 * z173 - c_roll * z460 - z695 * z172) - roll_dot * (z118 * z693 - z116 *
        z695);
    const double z700 = 2.0 * (k21 * z686) + H_xz * z687;
    const double z701 = B_xz * w1 + 2.0 * (k23 * w3);
    const double z702 = B_xz * z631 - 2.0 * (k23 * z632);
    const double z703 = B_yy * w2;
    const double z704 = B_yy * z630;
    const double z705 = B_xz * w3 + 2.0 * (k22 * w1);
    const double z706 = 2.0 * (k22 * z631) - B_xz * z632;
    const double z707 = m_R * z656;
    const double z708 = m_R * z644;
    const double z709 = z705 * (z421 - z148 * z464 - (z455 * z172 - roll_dot * z116)) + (z149 * z706 - (z107
        * (m_R * z516) + (z144 * z707 + z146 * z708)));
    const double z710 = z701 * (z423 - z148 * z463 - (z455 * z173 - roll_dot * z118)) - (z150 * z702 - (z703
        * z673 - (z152 * z704 + z709)));
    const double z711 = z157 * z688 - (z689 * z468 + (z159 * z690 - (z691 * (z698 + z699) + (z156 * z700 -
        z710))));
    const double z712 = z171 * z670 + (z167 * z671 + (z672 * z673 + (z160 * z674 + (z675 * (z682 - z683) -
        z711))));
    const double z713 = z197 * z655 + (z196 * z665 + (z194 * z666 + (z188 * z667 + (z181 * z668 + (z174 *
        z669 + z712)))));
    const double z714 = z457 * z468 + (z159 * z635 + (z199 * z643 + z713)) - g * (z200 + (z195 + (z147 +
        z175)));
    const double z715 = z455 * (z5 - (z458 * z270 + e3z * z676) + (z460 * z269 - z2 * z692)) - roll_dot *
        (z210 * z458 - s_pitch * z676 + (z208 * z460 + c_pitch * z692));
    const double z716 = z238 * z465 + z396 * z202 + (z411 - z715);
    const double z717 = z393 * z238;
    const double z718 = s_lam * z458;
    const double z719 = c_lam * z458;
    const double z720 = z455 * (z677 * z270 - e3z * z718 - e2z * z676 + (z679 * z269 - z2 * z719)) + roll_dot
        * (z210 * z677 + s_pitch * z718 - (z208 * z679 + c_pitch * z719));
    const double z721 = s_lam * z460;
    const double z722 = c_lam * z460;
    const double z723 = z455 * (z693 * z270 + e3z * z721 + e2z * z692 + (z695 * z269 + z2 * z722)) + roll_dot
        * (z210 * z693 - s_pitch * z721 - (z208 * z695 - c_pitch * z722));
    const double z724 = z705 * (z238 * z464 + (z455 * z269 - roll_dot * z208)) + (z239 * z706 + (z234 * z707
        + z236 * z708));
    const double z725 = z701 * (z238 * z463 - (z455 * z270 + roll_dot * z210)) + (z240 * z702 - (z703 * z717
        - (z242 * z704 - z724)));
    const double z726 = z252 * z690 - (z691 * (z238 * z697 + z202 * z461 + (z408 * z692 - z723)) - (z248 *
        z700 - z725));
    const double z727 = z675 * (z238 * z681 - z202 * z459 - (z408 * z676 + z720)) + (z249 * z688 - (z689 *
        z716 + z726));
    const double z728 = z279 * z668 + (z271 * z669 + (z267 * z670 + (z262 * z671 + (z672 * z717 + (z255 *
        z674 - z727)))));
    const double z729 = z252 * z635 + (z299 * z643 + (z297 * z655 + (z295 * z665 + (z293 * z666 + (z286 *
        z667 + z728)))));
    const double z730 = z457 * z716 + z729 - g * (z300 + (z272 + z294)) - z714 * z309;
    const double z731 = z317 * z465;
    const double z732 = z393 * z317;
    const double z733 = z703 * z732 + (z321 * z704 + (z705 * (z317 * z464) + (z318 * z706 + (z313 * z707 +
        z315 * z708))));
    const double z734 = z331 * z690 + (z691 * (z317 * z697) - (z327 * z700 - (z701 * (z317 * z463) + (z319 *
        z702 - z733))));
    const double z735 = z672 * z732 + (z334 * z674 - (z675 * (z317 * z681) - (z328 * z688 + (z689 * z731 -
        z734))));
    const double z736 = z365 * z655 + (z363 * z665 + (z361 * z667 + (z353 * z668 + (z346 * z670 + (z341 *
        z671 + z735)))));
    const double z737 = (z457 * z731 + (z367 * z635 + z736) - z714 * z373 - z378 * z730) / z379;
    const double z738 = z377 * z730 - z378 * z737;
    /* (I.2.15) 112:4 */
    dydt[9] = z373 * z737 - (z714 * z308 - z309 * z738); /* roll'' */
    dydt[10] = -z738; /* steer'' */
    dydt[11] = z737; /* thF'' */
    return bicycle_finish(12, dydt);
}

int bicycle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;
    const double k2 = r_F * c_lam + c * s_lam;
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = c_lam * k2;
    const double k5 = s_lam * k2;
    const double k6 = fabs(r_R);
    const double k7 = fabs(r_F);
    const double k8 = fabs(c);
    const double k9 = k7 + k8;
    const double k10 = k9 + (k6 + k9) + (k9 + (fabs(w) + k8 + k9));
    const double k11 = k9 + k10;
    const double k12 = 3.0 * k9;
    const double k13 = k10 + k11;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = c_steer * z4 - e2z * s_steer;
    const double z6 = z2 * s_lam;
    const double z7 = z6 - e3z * c_lam;
    const double z8 = c_lam * z5 + s_lam * z7;
    const double z9 = c_lam * z7 - s_lam * z5;
    const double z10 = 1.0 / sqrt(z8 * z8 + z9 * z9);
    const double z11 = e2z * c_steer;
    const double z12 = s_steer * s_steer;
    const double z13 = c_pitch * (s_lam * z1 - s_steer * z10 * (z11 + 2.0 * (s_steer * z3))) + (s_pitch *
        (c_lam * z1 + 2.0 * (z10 * (z6 * z12))) - z10 * (z12 * (c_roll * s_lam)));
    const double z14 = s_pitch * (r_R - r_F * (c_steer * (1.0 + z10 * (s_steer * (e2z * s_lam))) + z10 * (e3z
        * z12)));
    const double z15 = c_lam * (r_F * z13 - c * (z1 * (c_pitch * c_lam - s_pitch * s_lam))) - (z14 + w *
        c_pitch);
    const double z16 = c_roll * z15;
    const double z17 = k7 * fabs(z10);
    const double z18 = 110.0 * z17;
    const double z19 = 30.0 * z17 + k12 + (80.0 * z17 + k10 + (z18 + (z18 + k11) + (1.0 + 300.0 * z17)));
    /* the coframe is singular */
    if (!(fabs(z16) > 1e-12 * (50.0 * z17 + z19))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z20 = 1.0 / sqrt(z2 * z2 + e3z * e3z);
    const double z21 = r_R * z2 * z20;
    const double s_yaw = sin(yaw);
    const double z22 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z22;
    const double e1y = c_pitch * s_yaw + s_pitch * z22;
    const double R3 = r_R * e3z * z20;
    const double z23 = e3y * z21 + e1y * R3;
    const double z24 = c_steer * k3;
    const double z25 = r_R - s_lam * z24 - k4;
    const double z26 = k1 + c_lam * z24 - k5;
    const double z27 = s_pitch * z25 + c_pitch * z26;
    const double z28 = c_roll * (s_steer * k3) - e2z * (c_pitch * z25 - s_pitch * z26);
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z29 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z29 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z30 = r_F * z8 * z10;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z31 = r_F * z9 * z10;
    const double z32 = h3y * z30 - h1y * z31;
    const double h2y = e2y * c_steer - s_steer * z29;
    const double z33 = h2y * z30;
    const double z34 = h2y * z31;
    const double z35 = s_lam * z33 + c_lam * z34;
    const double z36 = s_steer * z32 - c_steer * z35;
    const double z37 = c_lam * z33 - s_lam * z34;
    const double z38 = c_yaw * z27 - s_yaw * z28 + e3z * (s_lam * z36 - c_lam * z37) + e2z * (c_steer * z32 +
        s_steer * z35);
    const double z39 = z38 + z2 * (c_lam * z36 + s_lam * z37);
    const double z40 = e3z * (e2y * z21) - e2z * z23 - z2 * (e2y * R3) + z39;
    const double z41 = k6 * fabs(z20);
    const double z42 = 4.0 * z41;
    const double z43 = 190.0 * z17;
    const double z44 = 6.0 * z41 + (z43 + (140.0 * z17 + (z43 + k13)));
    /* the coframe is singular */
    if (!(fabs(-z40) > 1e-12 * (z42 + z44))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z45 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z45;
    const double e1x = c_yaw * c_pitch - z45 * s_pitch;
    const double z46 = e3x * z21 + e1x * R3;
    const double z47 = s_yaw * c_roll;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z48 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z48 - z47 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z49 = h3x * z30 - h1x * z31;
    const double z50 = z47 * c_steer + z48 * s_steer;
    const double z51 = z50 * z30;
    const double z52 = z50 * z31;
    const double z53 = s_lam * z51 + c_lam * z52;
    const double z54 = s_steer * z49 + c_steer * z53;
    const double z55 = c_lam * z51 - s_lam * z52;
    const double z56 = c_yaw * z28 + s_yaw * z27 - e3z * (s_lam * z54 + c_lam * z55) - e2z * (c_steer * z49 -
        s_steer * z53);
    const double z57 = z56 - z2 * (c_lam * z54 - s_lam * z55);
    const double z58 = e3z * (z47 * z21) + e2z * z46 - z2 * (z47 * R3) + z57;
    const double z59 = 1.0 / z40;
    const double z60 = z23 * z59;
    const double z61 = z46 + z58 * z60;
    /* the coframe is singular */
    if (!(fabs(z61) > 1e-12 * (z42 + 4.0 * (z44 * (z41 * fabs(z59)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z62 = roll_dot * s_pitch;
    const double z63 = roll_dot * c_pitch;
    const double z64 = s_lam * z62 - c_lam * z63;
    const double z65 = s_steer * z64;
    const double z66 = steer_dot + (c_lam * z62 + s_lam * z63);
    const double z67 = s_lam * z66;
    const double z68 = c_steer * z64;
    const double z69 = c_lam * z66;
    const double z70 = roll_dot * c_roll;
    const double z71 = steer_dot * c_steer;
    const double z72 = steer_dot * s_steer;
    const double z73 = roll_dot * e2z;
    const double z74 = c_pitch * z73;
    const double z75 = s_pitch * z73;
    const double z76 = s_steer * z70 + e2z * z71 + (z4 * z72 + c_steer * (s_lam * z74 + c_lam * z75));
    const double z77 = c_lam * z74 - s_lam * z75;
    const double z78 = z63 * R3 + z62 * z21;
    const double z79 = e2z * z78;
    const double z80 = r_F * (s_lam * z76 + c_lam * z77) + (c * (s_lam * z77 - c_lam * z76) - (r_R * z74 -
        (z79 + k1 * z75)));
    const double z81 = (z11 + s_steer * z4) * (z31 * (z67 - c_lam * z68) - z30 * (s_lam * z68 + z69)) + (z8 *
        (z31 * z65) + z80);
    const double z82 = (z9 * (z30 * z65) - z81) / z16;
    const double z83 = thF_dot + (z65 + c_steer * z82);
    const double z84 = z30 * z83;
    const double z85 = z68 - s_steer * z82;
    const double z86 = z31 * (z67 - c_lam * z85) - z30 * (z69 + s_lam * z85);
    const double z87 = z31 * z83;
    const double z88 = s_yaw * z70;
    const double z89 = s_pitch * z82;
    const double z90 = c_pitch * z82;
    const double z91 = c_pitch * z88 - z45 * z89 + c_yaw * z90;
    const double z92 = s_pitch * z88 + z45 * z90 + c_yaw * z89;
    const double z93 = z47 * z71 - s_steer * (s_yaw * z73) + (z48 * z72 + c_steer * (s_lam * z91 + c_lam *
        z92));
    const double z94 = c_lam * z91 - s_lam * z92;
    const double z95 = r_F * (s_lam * z93 + c_lam * z94) + (c * (s_lam * z94 - c_lam * z93) - (r_R * z91 - k1
        * z92));
    const double z96 = h3x * z84 - (z50 * z86 + (h1x * z87 + z95));
    const double z97 = c_yaw * z70;
    const double z98 = c_pitch * z97 - z22 * z89 - s_yaw * z90;
    const double z99 = s_pitch * z97 + z22 * z90 - s_yaw * z89;
    const double z100 = e2y * z71 - s_steer * (c_yaw * z73) - (z29 * z72 - c_steer * (s_lam * z98 + c_lam *
        z99));
    const double z101 = c_lam * z98 - s_lam * z99;
    const double z102 = r_F * (s_lam * z100 + c_lam * z101) + (c * (s_lam * z101 - c_lam * z100) - (r_R * z98
        - k1 * z99));
    const double z103 = h3y * z84 + (h2y * z86 - (h1y * z87 - z102));
    const double z104 = z21 * z82;
    const double z105 = R3 * z82;
    const double z106 = z59 * (z103 - (e3y * z104 - (e2y * z78 - e1y * z105)));
    const double z107 = (z96 - (e3x * z104 + (z47 * z78 + e1x * z105)) + z58 * z106) / z61;
    /* (I.2.4) */
    qdot[0] = z57 * z60 * z107 - (z96 + z57 * z106); /* x' */
    qdot[1] = -(z103 - z39 * z106 + z39 * z60 * z107); /* y' */
    qdot[2] = z79; /* z' */
    qdot[3] = z60 * z107 - z106; /* yaw' */
    qdot[4] = roll_dot; /* roll' */
    qdot[5] = z82; /* pitch' */
    qdot[6] = steer_dot; /* steer' */
    qdot[7] = z107; /* thR' */
    qdot[8] = thF_dot; /* thF' */
    return bicycle_finish(9, qdot);
}

int bicycle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = 0.5 * R_xx;
    const double k5 = 0.5 * F_xx;
    const double k6 = r_F * c_lam + c * s_lam;
    const double k7 = r_F * s_lam - c * c_lam;
    const double k8 = c_lam * k6;
    const double k9 = s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(c);
    const double k13 = k11 + k12;
    const double k14 = k13 + (k10 + k13) + (k13 + (fabs(w) + k12 + k13));
    const double k15 = k13 + k14;
    const double k16 = 3.0 * k13;
    const double k17 = k14 + k15;
    const double k18 = s_lam * s_lam;
    const double k19 = c_lam * c_lam;
    const double k20 = 0.5 * H_zz + k5;
    const double k21 = 0.5 * H_xx + k5;
    const double k22 = k4 + 0.5 * B_xx;
    const double k23 = k4 + 0.5 * B_zz;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = e2z * s_steer;
    const double z6 = c_steer * z4 - z5;
    const double z7 = z2 * s_lam;
    const double z8 = z7 - e3z * c_lam;
    const double z9 = c_lam * z6 + s_lam * z8;
    const double z10 = c_lam * z8 - s_lam * z6;
    const double z11 = z9 * z9 + z10 * z10;
    const double z12 = 1.0 / sqrt(z11);
    const double z13 = s_steer * z12;
    const double z14 = e2z * c_steer;
    const double z15 = z14 + 2.0 * (s_steer * z3);
    const double z16 = s_lam * z1 - z13 * z15;
    const double z17 = s_steer * s_steer;
    const double z18 = z7 * z17;
    const double z19 = c_lam * z1 + 2.0 * (z12 * z18);
    const double z20 = c_roll * s_lam;
    const double z21 = z17 * z20;
    const double z22 = c_pitch * c_lam - s_pitch * s_lam;
    const double z23 = e2z * s_lam;
    const double z24 = s_steer * z23;
    const double z25 = 1.0 + z12 * z24;
    const double z26 = e3z * z17;
    const double z27 = r_R - r_F * (c_steer * z25 + z12 * z26);
    const double z28 = c_lam * (r_F * (c_pitch * z16 + (s_pitch * z19 - z12 * z21)) - c * (z1 * z22)) -
        (s_pitch * z27 + w * c_pitch);
    const double z29 = c_roll * z28;
    const double z30 = k11 * fabs(z12);
    const double z31 = 110.0 * z30;
    const double z32 = 30.0 * z30 + k16 + (80.0 * z30 + k14 + (z31 + (z31 + k15) + (1.0 + 300.0 * z30)));
    /* the coframe is singular */
    if (!(fabs(z29) > 1e-12 * (50.0 * z30 + z32))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z33 = r_R * z2;
    const double z34 = z2 * z2 + e3z * e3z;
    const double z35 = 1.0 / sqrt(z34);
    const double z36 = z33 * z35;
    const double z37 = e2y * z36;
    const double s_yaw = sin(yaw);
    const double z38 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z38;
    const double e1y = c_pitch * s_yaw + s_pitch * z38;
    const double z39 = r_R * e3z;
    const double R3 = z39 * z35;
    const double z40 = e3y * z36 + e1y * R3;
    const double z41 = e2y * R3;
    const double z42 = c_steer * k7;
    const double z43 = r_R - s_lam * z42 - k8;
    const double z44 = k2 + c_lam * z42 - k9;
    const double z45 = s_pitch * z43 + c_pitch * z44;
    const double z46 = s_steer * k7;
    const double z47 = c_pitch * z43 - s_pitch * z44;
    const double z48 = c_roll * z46 - e2z * z47;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z49 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z49 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z50 = r_F * z9;
    const double z51 = z50 * z12;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z52 = r_F * z10;
    const double z53 = z52 * z12;
    const double z54 = h3y * z51 - h1y * z53;
    const double z55 = e2y * c_steer;
    const double z56 = s_steer * z49;
    const double h2y = z55 - z56;
    const double z57 = h2y * z51;
    const double z58 = h2y * z53;
    const double z59 = s_lam * z57 + c_lam * z58;
    const double z60 = s_steer * z54 - c_steer * z59;
    const double z61 = c_lam * z57 - s_lam * z58;
    const double z62 = s_lam * z60 - c_lam * z61;
    const double z63 = c_steer * z54 + s_steer * z59;
    const double z64 = c_lam * z60 + s_lam * z61;
    const double z65 = c_yaw * z45 - s_yaw * z48 + e3z * z62 + e2z * z63 + z2 * z64;
    const double z66 = e3z * z37 - e2z * z40 - z2 * z41 + z65;
    const double z67 = k10 * fabs(z35);
    const double z68 = 4.0 * z67;
    const double z69 = 190.0 * z30;
    const double z70 = 6.0 * z67 + (z69 + (140.0 * z30 + (z69 + k17)));
    /* the coframe is singular */
    if (!(fabs(-z66) > 1e-12 * (z68 + z70))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z71 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z71;
    const double e1x = c_yaw * c_pitch - z71 * s_pitch;
    const double z72 = e3x * z36 + e1x * R3;
    const double z73 = s_yaw * c_roll;
    const double z74 = z73 * z36;
    const double z75 = z73 * R3;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z76 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z76 - z73 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z77 = h3x * z51 - h1x * z53;
    const double z78 = z73 * c_steer;
    const double z79 = z76 * s_steer;
    const double z80 = z78 + z79;
    const double z81 = z80 * z51;
    const double z82 = z80 * z53;
    const double z83 = s_lam * z81 + c_lam * z82;
    const double z84 = s_steer * z77 + c_steer * z83;
    const double z85 = c_lam * z81 - s_lam * z82;
    const double z86 = s_lam * z84 + c_lam * z85;
    const double z87 = c_steer * z77 - s_steer * z83;
    const double z88 = c_lam * z84 - s_lam * z85;
    const double z89 = c_yaw * z48 + s_yaw * z45 - e3z * z86 - e2z * z87 - z2 * z88;
    const double z90 = e3z * z74 + e2z * z72 - z2 * z75 + z89;
    const double z91 = 1.0 / z66;
    const double z92 = z40 * z91;
    const double z93 = z72 + z90 * z92;
    /* the coframe is singular */
    if (!(fabs(z93) > 1e-12 * (z68 + 4.0 * (z70 * (z67 * fabs(z91)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z94 = s_steer * z22;
    const double z95 = 1.0 / z29;
    const double z96 = s_steer * z4;
    const double h2z = z14 + z96;
    const double z97 = s_pitch * c_lam + c_pitch * s_lam;
    const double z98 = s_lam * z97;
    const double z99 = c_steer * z22;
    const double z100 = c_lam * z97;
    const double z101 = c_roll * s_steer;
    const double z102 = c_pitch * e2z;
    const double z103 = e2z * s_pitch;
    const double z104 = z101 + c_steer * (s_lam * z102 + c_lam * z103);
    const double z105 = c_lam * z102 - s_lam * z103;
    const double z106 = c_pitch * R3 + s_pitch * z36;
    const double z107 = e2z * z106;
    const double z108 = r_F * (s_lam * z104 + c_lam * z105) + (c * (s_lam * z105 - c_lam * z104) - (r_R *
        z102 - (z107 + k2 * z103)));
    const double z109 = h2z * (z53 * (z98 + c_lam * z99) + z51 * (s_lam * z99 - z100)) - (z9 * (z53 * z94) -
        z108);
    const double z110 = z95 * (z10 * (z51 * z94) + z109);
    const double z111 = z94 + c_steer * z110;
    const double z112 = z51 * z111;
    const double z113 = z99 - s_steer * z110;
    const double z114 = z53 * (z98 + c_lam * z113) - z51 * (z100 - s_lam * z113);
    const double z115 = z53 * z111;
    const double z116 = s_pitch * z110;
    const double z117 = z71 * z116;
    const double z118 = c_pitch * z110;
    const double z119 = c_yaw * z118;
    const double z120 = c_pitch * z73 + z117 - z119;
    const double z121 = z71 * z118;
    const double z122 = c_yaw * z116;
    const double z123 = z121 - s_pitch * z73 + z122;
    const double z124 = z71 * s_steer - c_steer * (s_lam * z120 - c_lam * z123);
    const double z125 = c_lam * z120 + s_lam * z123;
    const double z126 = r_F * (s_lam * z124 - c_lam * z125) - (c * (s_lam * z125 + c_lam * z124) - (r_R *
        z120 + k2 * z123));
    const double z127 = h3x * z112 + (z80 * z114 - (h1x * z115 + z126));
    const double z128 = z38 * z116;
    const double z129 = s_yaw * z118;
    const double z130 = c_pitch * e2y + z128 + z129;
    const double z131 = z38 * z118;
    const double z132 = s_yaw * z116;
    const double z133 = s_pitch * e2y - z131 + z132;
    const double z134 = z38 * s_steer - c_steer * (s_lam * z130 + c_lam * z133);
    const double z135 = c_lam * z130 - s_lam * z133;
    const double z136 = r_F * (s_lam * z134 - c_lam * z135) - (c * (s_lam * z135 + c_lam * z134) - (r_R *
        z130 - k2 * z133));
    const double z137 = h3y * z112 - (h2y * z114 + (h1y * z115 - z136));
    const double z138 = z36 * z110;
    const double z139 = R3 * z110;
    const double z140 = z91 * (z137 - (e3y * z138 + (e2y * z106 + e1y * z139)));
    const double z141 = z89 * z92;
    const double z142 = 1.0 / z93;
    const double z143 = z142 * (z127 - (e3x * z138 - (z73 * z106 - e1x * z139)) + z90 * z140);
    const double z144 = z127 + z89 * z140 - z141 * z143;
    const double z145 = z65 * z92;
    const double z146 = z137 - z65 * z140 + z145 * z143;
    const double z147 = m_R * z107;
    const double z148 = z140 - z92 * z143;
    const double z149 = c_pitch - z2 * z148;
    const double z150 = s_pitch + e3z * z148;
    const double z151 = z144 * (m_R * z144) + z146 * (m_R * z146) + z107 * z147 + z149 * (2.0 * (k22 * z149)
        + B_xz * z150);
    const double z152 = z110 - e2z * z148;
    const double z153 = c_lam * z149 - s_lam * z150;
    const double z154 = c_steer * z153 - s_steer * z152;
    const double z155 = s_lam * z149 + c_lam * z150;
    const double z156 = c_lam * z154 + s_lam * z155;
    const double z157 = c_lam * z155 - s_lam * z154;
    const double z158 = z151 + z152 * (B_yy * z152) + z150 * (B_xz * z149 + 2.0 * (k23 * z150)) + z156 * (2.0
        * (k21 * z156) + H_xz * z157);
    const double z159 = c_steer * z152 + s_steer * z153;
    const double z160 = z143 + z152;
    const double z161 = z158 + z159 * (H_yy * z159) + z157 * (H_xz * z156 + 2.0 * (k20 * z157)) + z160 *
        (R_yy * z160);
    const double z162 = s_yaw * z148;
    const double z163 = c_yaw * z148;
    const double z164 = z73 + e2z * z163;
    const double z165 = z122 - c_pitch * z162 + (z121 - s_pitch * z164);
    const double z166 = z119 + s_pitch * z162 - (z117 + c_pitch * z164);
    const double z167 = z144 + x_B * z165 - k1 * z166;
    const double z168 = e2y - e2z * z162;
    const double z169 = z132 + c_pitch * z163 - (z131 - s_pitch * z168);
    const double z170 = z129 - s_pitch * z163 + (z128 + c_pitch * z168);
    const double z171 = z146 + x_B * z169 - k1 * z170;
    const double z172 = z103 + c_roll * z118;
    const double z173 = z102 - c_roll * z116;
    const double z174 = z107 + x_B * z172 - k1 * z173;
    const double z175 = m_B * z174;
    const double z176 = z144 + k2 * z165 - r_R * z166;
    const double z177 = c_steer * (c_lam * z165 + s_lam * z166) + s_steer * (z71 - c_roll * z163);
    const double z178 = s_lam * z165 - c_lam * z166;
    const double z179 = c_lam * z177 + s_lam * z178;
    const double z180 = c_lam * z178 - s_lam * z177;
    const double z181 = z176 - k3 * z179 + z_H * z180;
    const double z182 = z161 + z167 * (m_B * z167) + z171 * (m_B * z171) + z174 * z175 + z181 * (m_H * z181);
    const double z183 = z146 + k2 * z169 - r_R * z170;
    const double z184 = c_steer * (c_lam * z169 + s_lam * z170) - s_steer * (z38 + c_roll * z162);
    const double z185 = s_lam * z169 - c_lam * z170;
    const double z186 = c_lam * z184 + s_lam * z185;
    const double z187 = c_lam * z185 - s_lam * z184;
    const double z188 = z183 - k3 * z186 + z_H * z187;
    const double z189 = z107 + k2 * z172 - r_R * z173;
    const double z190 = z101 + c_steer * (c_lam * z172 + s_lam * z173);
    const double z191 = s_lam * z172 - c_lam * z173;
    const double z192 = c_lam * z190 + s_lam * z191;
    const double z193 = c_lam * z191 - s_lam * z190;
    const double z194 = z189 - k3 * z192 + z_H * z193;
    const double z195 = m_H * z194;
    const double z196 = z176 - c * z179 - r_F * z180;
    const double z197 = z183 - c * z186 - r_F * z187;
    const double z198 = z182 + z188 * (m_H * z188) + z194 * z195 + z196 * (m_F * z196) + z197 * (m_F * z197);
    const double z199 = z189 - c * z192 - r_F * z193;
    const double z200 = m_F * z199;
    const double z201 = z198 + z199 * z200 + z159 * (F_yy * z159);
    /* the mass matrix is singular */
    if (!(fabs(z201) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z202 = z95 * (h2z * (s_lam * z53 - c_lam * z51) + (r_F * (s_lam * h2z) - c * (c_lam * h2z)));
    const double z203 = c_steer * z202;
    const double z204 = z51 * z203;
    const double z205 = s_steer * z202;
    const double z206 = z53 * (s_lam - c_lam * z205) - z51 * (c_lam + s_lam * z205);
    const double z207 = z53 * z203;
    const double z208 = s_pitch * z202;
    const double z209 = z71 * z208;
    const double z210 = c_pitch * z202;
    const double z211 = c_yaw * z210;
    const double z212 = z209 - z211;
    const double z213 = z71 * z210;
    const double z214 = c_yaw * z208;
    const double z215 = z213 + z214;
    const double z216 = z78 + (z79 + c_steer * (s_lam * z212 - c_lam * z215));
    const double z217 = c_lam * z212 + s_lam * z215;
    const double z218 = r_F * (s_lam * z216 + c_lam * z217) + (c * (s_lam * z217 - c_lam * z216) - (r_R *
        z212 + k2 * z215));
    const double z219 = h3x * z204 + (z80 * z206 - (h1x * z207 - z218));
    const double z220 = z38 * z208;
    const double z221 = s_yaw * z210;
    const double z222 = z220 + z221;
    const double z223 = z38 * z210;
    const double z224 = s_yaw * z208;
    const double z225 = z223 - z224;
    const double z226 = z55 - (z56 - c_steer * (s_lam * z222 - c_lam * z225));
    const double z227 = c_lam * z222 + s_lam * z225;
    const double z228 = r_F * (s_lam * z226 + c_lam * z227) + (c * (s_lam * z227 - c_lam * z226) - (r_R *
        z222 + k2 * z225));
    const double z229 = h3y * z204 - (h2y * z206 + (h1y * z207 + z228));
    const double z230 = z36 * z202;
    const double z231 = R3 * z202;
    const double z232 = z91 * (z229 - (e3y * z230 + e1y * z231));
    const double z233 = z142 * (z219 - (e3x * z230 + e1x * z231) + z90 * z232);
    const double z234 = z219 + z89 * z232 - z141 * z233;
    const double z235 = m_R * z234;
    const double z236 = z229 - z65 * z232 + z145 * z233;
    const double z237 = m_R * z236;
    const double z238 = z232 - z92 * z233;
    const double z239 = z2 * z238;
    const double z240 = e3z * z238;
    const double z241 = 2.0 * (k22 * z239) - B_xz * z240;
    const double z242 = z202 - e2z * z238;
    const double z243 = B_yy * z242;
    const double z244 = B_xz * z239 - 2.0 * (k23 * z240);
    const double z245 = c_lam * z239 + s_lam * z240;
    const double z246 = c_steer * z245 + s_steer * z242;
    const double z247 = 1.0 - (s_lam * z239 - c_lam * z240);
    const double z248 = c_lam * z246 - s_lam * z247;
    const double z249 = c_lam * z247 + s_lam * z246;
    const double z250 = 2.0 * (k21 * z248) - H_xz * z249;
    const double z251 = z234 * z235 + z236 * z237 + z239 * z241 + z242 * z243 - z240 * z244 + z248 * z250;
    const double z252 = c_steer * z242 - s_steer * z245;
    const double z253 = H_yy * z252;
    const double z254 = H_xz * z248 - 2.0 * (k20 * z249);
    const double z255 = z233 + z242;
    const double z256 = R_yy * z255;
    const double z257 = s_yaw * z238;
    const double z258 = c_yaw * z238;
    const double z259 = e2z * z258;
    const double z260 = z214 - c_pitch * z257 + (z213 - s_pitch * z259);
    const double z261 = z211 + s_pitch * z257 - (z209 + c_pitch * z259);
    const double z262 = z234 + x_B * z260 - k1 * z261;
    const double z263 = m_B * z262;
    const double z264 = e2z * z257;
    const double z265 = z224 + c_pitch * z258 - (z223 + s_pitch * z264);
    const double z266 = z221 - s_pitch * z258 + (z220 - c_pitch * z264);
    const double z267 = z236 + x_B * z265 - k1 * z266;
    const double z268 = m_B * z267;
    const double z269 = c_roll * z210;
    const double z270 = c_roll * z208;
    const double z271 = x_B * z269 + k1 * z270;
    const double z272 = m_B * z271;
    const double z273 = z251 + z252 * z253 - z249 * z254 + z255 * z256 + z262 * z263 + z267 * z268 + z271 *
        z272;
    const double z274 = z234 + k2 * z260 - r_R * z261;
    const double z275 = z79 - c_steer * (c_lam * z260 + s_lam * z261) + (z78 + s_steer * (c_roll * z258));
    const double z276 = s_lam * z260 - c_lam * z261;
    const double z277 = c_lam * z275 - s_lam * z276;
    const double z278 = c_lam * z276 + s_lam * z275;
    const double z279 = z274 + k3 * z277 + z_H * z278;
    const double z280 = m_H * z279;
    const double z281 = z236 + k2 * z265 - r_R * z266;
    const double z282 = z56 - c_steer * (c_lam * z265 + s_lam * z266) - (z55 - s_steer * (c_roll * z257));
    const double z283 = s_lam * z265 - c_lam * z266;
    const double z284 = c_lam * z282 - s_lam * z283;
    const double z285 = c_lam * z283 + s_lam * z282;
    const double z286 = z281 + k3 * z284 + z_H * z285;
    const double z287 = m_H * z286;
    const double z288 = k2 * z269 + r_R * z270;
    const double z289 = z14 + (z96 + c_steer * (c_lam * z269 - s_lam * z270));
    const double z290 = s_lam * z269 + c_lam * z270;
    const double z291 = c_lam * z289 + s_lam * z290;
    const double z292 = c_lam * z290 - s_lam * z289;
    const double z293 = z288 - k3 * z291 + z_H * z292;
    const double z294 = m_H * z293;
    const double z295 = z274 + c * z277 - r_F * z278;
    const double z296 = m_F * z295;
    const double z297 = z281 + c * z284 - r_F * z285;
    const double z298 = m_F * z297;
    const double z299 = z288 - c * z291 - r_F * z292;
    const double z300 = m_F * z299;
    const double z301 = z273 + z279 * z280 + z286 * z287 + z293 * z294 + z295 * z296 + z297 * z298 + z299 *
        z300;
    const double z302 = F_yy * z252;
    const double z303 = z301 + z252 * z302;
    const double z304 = z144 * z235 + z146 * z237 - z149 * z241 + z152 * z243 - z150 * z244 - z156 * z250;
    const double z305 = z304 + z159 * z253 - z157 * z254 + z160 * z256 + z167 * z263 + z171 * z268 + z174 *
        z272;
    const double z306 = z305 + z181 * z280 + z188 * z287 + z194 * z294 + z196 * z296 + z197 * z298 + z199 *
        z300;
    const double z307 = z306 + z159 * z302;
    const double z308 = 1.0 / z201;
    const double z309 = z307 * z308;
    const double z310 = z303 - z307 * z309;
    /* the mass matrix is singular */
    if (!(fabs(z310) > 1e-14 * z303)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z311 = z54 * z91;
    const double z312 = z142 * (z77 + z90 * z311);
    const double z313 = z77 + z89 * z311 - z141 * z312;
    const double z314 = m_R * z313;
    const double z315 = z54 - z65 * z311 + z145 * z312;
    const double z316 = m_R * z315;
    const double z317 = z311 - z92 * z312;
    const double z318 = z2 * z317;
    const double z319 = e3z * z317;
    const double z320 = 2.0 * (k22 * z318) - B_xz * z319;
    const double z321 = e2z * z317;
    const double z322 = B_yy * z321;
    const double z323 = B_xz * z318 - 2.0 * (k23 * z319);
    const double z324 = c_lam * z318 + s_lam * z319;
    const double z325 = c_steer * z324 - s_steer * z321;
    const double z326 = s_lam * z318 - c_lam * z319;
    const double z327 = c_lam * z325 + s_lam * z326;
    const double z328 = c_lam * z326 - s_lam * z325;
    const double z329 = 2.0 * (k21 * z327) + H_xz * z328;
    const double z330 = z313 * z314 + z315 * z316 + z318 * z320 + z321 * z322 - z319 * z323 + z327 * z329;
    const double z331 = c_steer * z321 + s_steer * z324;
    const double z332 = H_yy * z331;
    const double z333 = H_xz * z327 + 2.0 * (k20 * z328);
    const double z334 = z312 - z321;
    const double z335 = R_yy * z334;
    const double z336 = s_yaw * z317;
    const double z337 = c_yaw * z317;
    const double z338 = e2z * z337;
    const double z339 = c_pitch * z336 + s_pitch * z338;
    const double z340 = s_pitch * z336 - c_pitch * z338;
    const double z341 = z313 - x_B * z339 - k1 * z340;
    const double z342 = m_B * z341;
    const double z343 = e2z * z336;
    const double z344 = c_pitch * z337 - s_pitch * z343;
    const double z345 = s_pitch * z337 + c_pitch * z343;
    const double z346 = z315 + x_B * z344 + k1 * z345;
    const double z347 = m_B * z346;
    const double z348 = z313 - k2 * z339 - r_R * z340;
    const double z349 = c_steer * (c_lam * z339 - s_lam * z340) + s_steer * (c_roll * z337);
    const double z350 = s_lam * z339 + c_lam * z340;
    const double z351 = c_lam * z349 + s_lam * z350;
    const double z352 = c_lam * z350 - s_lam * z349;
    const double z353 = z348 + k3 * z351 - z_H * z352;
    const double z354 = m_H * z353;
    const double z355 = z330 + z331 * z332 + z328 * z333 + z334 * z335 + z341 * z342 + z346 * z347 + z353 *
        z354;
    const double z356 = z315 + k2 * z344 + r_R * z345;
    const double z357 = c_steer * (c_lam * z344 - s_lam * z345) - s_steer * (c_roll * z336);
    const double z358 = s_lam * z344 + c_lam * z345;
    const double z359 = c_lam * z357 + s_lam * z358;
    const double z360 = c_lam * z358 - s_lam * z357;
    const double z361 = z356 - k3 * z359 + z_H * z360;
    const double z362 = m_H * z361;
    const double z363 = z348 + c * z351 + r_F * z352;
    const double z364 = m_F * z363;
    const double z365 = z356 - c * z359 - r_F * z360;
    const double z366 = m_F * z365;
    const double z367 = 1.0 - z331;
    const double z368 = F_yy * z367;
    const double z369 = z355 + z361 * z362 + z363 * z364 + z365 * z366 + z367 * z368;
    const double z370 = z144 * z314 + z146 * z316 - z149 * z320 - z152 * z322 - z150 * z323 - z156 * z329;
    const double z371 = z370 - z159 * z332 - z157 * z333 + z160 * z335 + z167 * z342 + z171 * z347 + z181 *
        z354;
    const double z372 = z371 + z188 * z362 + z196 * z364 + z197 * z366 + z159 * z368;
    const double z373 = z372 * z308;
    const double z374 = z234 * z314 + z236 * z316 + z239 * z320 - z242 * z322 - z240 * z323 + z248 * z329;
    const double z375 = z374 - z252 * z332 - z249 * z333 + z255 * z335 + z262 * z342 + z267 * z347 + z279 *
        z354;
    const double z376 = z375 + z286 * z362 + z295 * z364 + z297 * z366 + z252 * z368 - z307 * z373;
    const double z377 = 1.0 / z310;
    const double z378 = z376 * z377;
    const double z379 = z369 - z372 * z373 - z376 * z378;
    /* the mass matrix is singular */
    if (!(fabs(z379) > 1e-14 * z369)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z380 = roll_dot * s_pitch;
    const double z381 = roll_dot * c_pitch;
    const double z382 = s_lam * z380 - c_lam * z381;
    const double z383 = s_steer * z382;
    const double z384 = z51 * z383;
    const double z385 = steer_dot + (c_lam * z380 + s_lam * z381);
    const double z386 = s_lam * z385;
    const double z387 = c_steer * z382;
    const double z388 = z386 - c_lam * z387;
    const double z389 = c_lam * z385;
    const double z390 = s_lam * z387 + z389;
    const double z391 = z53 * z388 - z51 * z390;
    const double z392 = z53 * z383;
    const double z393 = roll_dot * c_roll;
    const double z394 = steer_dot * c_steer;
    const double z395 = s_steer * z393 + e2z * z394;
    const double z396 = steer_dot * s_steer;
    const double z397 = z4 * z396;
    const double z398 = roll_dot * e2z;
    const double z399 = c_pitch * z398;
    const double z400 = s_pitch * z398;
    const double z401 = s_lam * z399 + c_lam * z400;
    const double z402 = z395 + (z397 + c_steer * z401);
    const double z403 = c_lam * z399 - s_lam * z400;
    const double z404 = z381 * R3 + z380 * z36;
    const double z405 = r_F * (s_lam * z402 + c_lam * z403) + (c * (s_lam * z403 - c_lam * z402) - (r_R *
        z399 - (e2z * z404 + k2 * z400)));
    const double z406 = z10 * z384 - (h2z * z391 + (z9 * z392 + z405));
    const double z407 = z95 * z406;
    const double z408 = thF_dot + (z383 + c_steer * z407);
    const double z409 = z51 * z408;
    const double z410 = s_pitch * z407;
    const double z411 = c_yaw * z410;
    const double z412 = s_steer * z407;
    const double z413 = z387 - z412;
    const double z414 = z386 - c_lam * z413;
    const double z415 = z389 + s_lam * z413;
    const double z416 = z53 * z414 - z51 * z415;
    const double z417 = z53 * z408;
    const double z418 = e2y * z394;
    const double z419 = c_yaw * z398;
    const double z420 = z49 * z396;
    const double z421 = c_yaw * z393;
    const double z422 = z38 * z410;
    const double z423 = c_pitch * z407;
    const double z424 = s_yaw * z423;
    const double z425 = c_pitch * z421 - z422 - z424;
    const double z426 = z38 * z423;
    const double z427 = s_yaw * z410;
    const double z428 = s_pitch * z421 + z426 - z427;
    const double z429 = s_lam * z425 + c_lam * z428;
    const double z430 = z418 - s_steer * z419 - (z420 - c_steer * z429);
    const double z431 = c_lam * z425 - s_lam * z428;
    const double z432 = r_F * (s_lam * z430 + c_lam * z431) + (c * (s_lam * z431 - c_lam * z430) - (r_R *
        z425 - k2 * z428));
    const double z433 = z36 * z407;
    const double z434 = R3 * z407;
    const double z435 = h3y * z409 + (h2y * z416 - (h1y * z417 - z432)) - (e3y * z433 - (e2y * z404 - e1y *
        z434));
    const double z436 = z91 * z435;
    const double z437 = z73 * z394;
    const double z438 = s_yaw * z398;
    const double z439 = z76 * z396;
    const double z440 = s_yaw * z393;
    const double z441 = z71 * z410;
    const double z442 = c_yaw * z423;
    const double z443 = c_pitch * z440 - z441 + z442;
    const double z444 = z71 * z423;
    const double z445 = s_pitch * z440 + z444 + z411;
    const double z446 = s_lam * z443 + c_lam * z445;
    const double z447 = z437 - s_steer * z438 + (z439 + c_steer * z446);
    const double z448 = c_lam * z443 - s_lam * z445;
    const double z449 = r_F * (s_lam * z447 + c_lam * z448) + (c * (s_lam * z448 - c_lam * z447) - (r_R *
        z443 - k2 * z445));
    const double z450 = h3x * z409 - (z80 * z416 + (h1x * z417 + z449)) - (e3x * z433 + (z73 * z404 + e1x *
        z434));
    const double z451 = z450 + z90 * z436;
    const double z452 = z142 * z451;
    const double z453 = z436 - z92 * z452;
    const double z454 = s_yaw * z453;
    const double z455 = c_yaw * z453;
    const double z456 = z440 - e2z * z455;
    const double z457 = z411 - c_pitch * z454 + (z444 + s_pitch * z456);
    const double z458 = z442 + s_pitch * z454 - (z441 - c_pitch * z456);
    const double z459 = s_lam * z457 - c_lam * z458;
    const double z460 = c_lam * z457 + s_lam * z458;
    const double z461 = z438 + c_roll * z455;
    const double z462 = z439 + c_steer * z460 + (z437 - s_steer * z461);
    const double z463 = c_lam * z459 - s_lam * z462;
    const double z464 = z409 * z463;
    const double z465 = z400 - c_roll * z423;
    const double z466 = c_lam * z465;
    const double z467 = z399 + c_roll * z410;
    const double z468 = z466 + s_lam * z467;
    const double z469 = z395 + (z397 + c_steer * z468);
    const double z470 = s_lam * z465;
    const double z471 = z470 - c_lam * z467;
    const double z472 = c_lam * z469 + s_lam * z471;
    const double z473 = c_lam * z471 - s_lam * z469;
    const double z474 = z12 * (2.0 * (z9 * z472) + 2.0 * (z10 * z473)) / z11;
    const double z475 = z12 * (r_F * z472) - 0.5 * (z50 * z474);
    const double z476 = z408 * z475;
    const double w2 = z407 - e2z * z453;
    const double w1 = z381 + z2 * z453;
    const double w3 = z380 - e3z * z453;
    const double z477 = c_lam * w1 - s_lam * w3;
    const double o2 = c_steer * w2 - s_steer * z477;
    const double z478 = F_yy * (thF_dot + o2);
    const double z479 = c_steer * z393 - e2z * z396;
    const double z480 = s_lam * s_steer;
    const double z481 = s_lam * z394;
    const double z482 = c_lam * s_steer;
    const double z483 = c_lam * z394;
    const double z484 = z479 - (z480 * z467 - e3z * z481) - (z482 * z465 - z2 * z483);
    const double z485 = z317 * z484;
    const double z486 = s_lam * z396;
    const double z487 = z15 * (z394 * z12 + 0.5 * (s_steer * z474)) + z13 * (z479 + 2.0 * (z3 * z394 -
        s_steer * z466));
    const double z488 = c_lam * z396;
    const double z489 = s_steer * z394;
    const double z490 = s_pitch * (z488 + 2.0 * (0.5 * (z18 * z474) - z12 * (z17 * z470 - 2.0 * (z7 *
        z489))));
    const double z491 = z19 * z423 + z490 - (0.5 * (z21 * z474) + z12 * (2.0 * (z20 * z489) - z17 * (s_lam *
        z398)));
    const double z492 = r_F * (z16 * z410 - c_pitch * (z486 - z487) - z491) + c * (z396 * z22 - z1 * (c_lam *
        z410 + s_lam * z423));
    const double z493 = z396 * z25 - c_steer * (0.5 * (z24 * z474) + z12 * (z394 * z23 + s_steer * (s_lam *
        z393)));
    const double z494 = s_pitch * (r_F * (z493 - (0.5 * (z26 * z474) - z12 * (z17 * z467 - 2.0 * (e3z *
        z489)))));
    const double z495 = (z398 * z28 + c_roll * (c_lam * z492 + (z27 * z423 + z494 - w * z410))) / (z29 * z29);
    const double z496 = z406 * z495;
    const double z497 = z384 * z473;
    const double z498 = z383 * z475;
    const double z499 = z394 * z382;
    const double z500 = roll_dot * z423;
    const double z501 = roll_dot * z410;
    const double z502 = s_lam * z500 + c_lam * z501;
    const double z503 = z499 + s_steer * z502;
    const double z504 = z391 * (z479 + (z4 * z394 - s_steer * z468));
    const double z505 = z12 * (r_F * z473) - 0.5 * (z52 * z474);
    const double z506 = z388 * z505;
    const double z507 = c_lam * z500 - s_lam * z501;
    const double z508 = s_lam * z507;
    const double z509 = z396 * z382;
    const double z510 = z509 - c_steer * z502;
    const double z511 = z390 * z475;
    const double z512 = c_lam * z507;
    const double z513 = z504 - h2z * (z506 - z53 * (z508 + c_lam * z510) - (z511 + z51 * (s_lam * z510 -
        z512)));
    const double z514 = z392 * z472;
    const double z515 = z383 * z505;
    const double z516 = z393 * z394;
    const double z517 = roll_dot * z398;
    const double z518 = steer_dot * z396;
    const double z519 = z516 - s_steer * z517 + (z516 - e2z * z518);
    const double z520 = z396 * z468;
    const double z521 = steer_dot * z394;
    const double z522 = z520 - z4 * z521;
    const double z523 = z396 * z401;
    const double z524 = z398 * z410;
    const double z525 = roll_dot * z393;
    const double z526 = z524 - c_pitch * z525;
    const double z527 = z398 * z423;
    const double z528 = z527 + s_pitch * z525;
    const double z529 = z519 - (z522 + (z523 + c_steer * (s_lam * z526 - c_lam * z528)));
    const double z530 = c_lam * z526 + s_lam * z528;
    const double z531 = z393 * z404;
    const double z532 = z35 * (2.0 * (z2 * z465) + 2.0 * (e3z * z467)) / z34;
    const double z533 = z35 * (r_R * z467) - 0.5 * (z39 * z532);
    const double z534 = z381 * z533;
    const double z535 = z35 * (r_R * z465) - 0.5 * (z33 * z532);
    const double z536 = z380 * z535;
    const double z537 = R3 * z501 + z534 - (z36 * z500 - z536);
    const double z538 = z531 - e2z * z537;
    const double z539 = r_F * (s_lam * z529 - c_lam * z530) - (c * (s_lam * z530 + c_lam * z529) - (r_R *
        z526 + (z538 + k2 * z528)));
    const double z540 = z497 + z10 * (z498 - z51 * z503) + (z513 - (z514 + z9 * (z515 - z53 * z503) - z539));
    const double z541 = z496 - z95 * z540;
    const double z542 = z419 - c_roll * z454;
    const double z543 = z421 + e2z * z454;
    const double z544 = z424 - s_pitch * z455 + (z422 - c_pitch * z543);
    const double z545 = z427 + c_pitch * z455 - (z426 + s_pitch * z543);
    const double z546 = z36 * z544 - e3y * z535 - (R3 * z545 + e1y * z533);
    const double z547 = z37 * z467 + e3z * (z36 * z542 + e2y * z535) + (z393 * z40 + e2z * z546) - (z41 *
        z465 + z2 * (R3 * z542 + e2y * z533));
    const double z548 = z396 * k7;
    const double z549 = s_lam * z548;
    const double z550 = c_lam * z548;
    const double z551 = z43 * z423 + s_pitch * z549 - (z44 * z410 + c_pitch * z550);
    const double z552 = z398 * z46 - c_roll * (z394 * k7) + (z393 * z47 - e2z * (z43 * z410 - c_pitch * z549
        + (z44 * z423 - s_pitch * z550)));
    const double z553 = s_lam * z545 - c_lam * z544;
    const double z554 = c_lam * z545 + s_lam * z544;
    const double z555 = z420 + c_steer * z554 - (z418 - s_steer * z542);
    const double z556 = c_lam * z553 - s_lam * z555;
    const double z557 = c_lam * z555 + s_lam * z553;
    const double z558 = z51 * z556 + h3y * z475 - (z53 * z557 + h1y * z505);
    const double z559 = c_steer * z542 + e2y * z396 + (z49 * z394 - s_steer * z554);
    const double z560 = z51 * z559 + h2y * z475;
    const double z561 = z53 * z559 + h2y * z505;
    const double z562 = s_lam * z560 + c_lam * z561;
    const double z563 = z394 * z54 - s_steer * z558 + (z396 * z59 + c_steer * z562);
    const double z564 = c_lam * z560 - s_lam * z561;
    const double z565 = z45 * z454 + c_yaw * z551 + (z48 * z455 + s_yaw * z552) - (z62 * z467 - e3z * (s_lam
        * z563 + c_lam * z564));
    const double z566 = z565 + (z393 * z63 - e2z * (z396 * z54 + c_steer * z558 - (z394 * z59 - s_steer *
        z562)));
    const double z567 = z566 - (z64 * z465 - z2 * (c_lam * z563 - s_lam * z564));
    const double z568 = (z547 - z567) / (z66 * z66);
    const double z569 = z435 * z568;
    const double z570 = z409 * z556;
    const double z571 = z396 * z407;
    const double z572 = z503 - (z571 - c_steer * z541);
    const double z573 = z476 - z51 * z572;
    const double z574 = z416 * z559;
    const double z575 = z414 * z505;
    const double z576 = z394 * z407;
    const double z577 = z510 + (z576 + s_steer * z541);
    const double z578 = z415 * z475;
    const double z579 = z575 - z53 * (z508 + c_lam * z577) - (z578 - z51 * (z512 - s_lam * z577));
    const double z580 = z417 * z557;
    const double z581 = z408 * z505;
    const double z582 = z581 - z53 * z572;
    const double z583 = z394 * z542;
    const double z584 = z583 + e2y * z518;
    const double z585 = z394 * z419;
    const double z586 = z398 * z454;
    const double z587 = z586 + c_yaw * z525;
    const double z588 = z396 * z554;
    const double z589 = z588 - z49 * z521;
    const double z590 = z396 * z429;
    const double z591 = z421 * z410;
    const double z592 = z393 * z454;
    const double z593 = z592 - c_yaw * z517;
    const double z594 = z410 * z543;
    const double z595 = z407 * z423;
    const double z596 = z595 + s_pitch * z541;
    const double z597 = z594 + z38 * z596;
    const double z598 = z423 * z455;
    const double z599 = z407 * z410;
    const double z600 = z599 - c_pitch * z541;
    const double z601 = z598 + s_yaw * z600;
    const double z602 = z591 - c_pitch * z593 + z597 - z601;
    const double z603 = z421 * z423;
    const double z604 = z423 * z543;
    const double z605 = z604 - z38 * z600;
    const double z606 = z410 * z455;
    const double z607 = z606 - s_yaw * z596;
    const double z608 = z603 + s_pitch * z593 + z605 + z607;
    const double z609 = z584 + (z585 + s_steer * z587) - (z589 - (z590 + c_steer * (s_lam * z602 - c_lam *
        z608)));
    const double z610 = c_lam * z602 + s_lam * z608;
    const double z611 = r_F * (s_lam * z609 + c_lam * z610) + (c * (s_lam * z610 - c_lam * z609) - (r_R *
        z602 + k2 * z608));
    const double z612 = z570 + h3y * z573 + (z574 + h2y * z579 - (z580 + h1y * z582 - z611));
    const double z613 = z433 * z544;
    const double z614 = z407 * z535;
    const double z615 = z614 - z36 * z541;
    const double z616 = z404 * z542;
    const double z617 = z434 * z545;
    const double z618 = z407 * z533;
    const double z619 = z618 - R3 * z541;
    const double z620 = z569 - z91 * (z612 + (z613 - e3y * z615 + (z616 + e2y * z537 - (z617 + e1y * z619))));
    const double z621 = z91 * z546 + z40 * z568;
    const double z622 = z452 * z621;
    const double z623 = z36 * z458 - e3x * z535 - (R3 * z457 + e1x * z533);
    const double z624 = z74 * z467 + e3z * (z36 * z461 + z73 * z535) - (z393 * z72 + e2z * z623) - (z75 *
        z465 + z2 * (R3 * z461 + z73 * z533));
    const double z625 = c_lam * z462 + s_lam * z459;
    const double z626 = z51 * z463 + h3x * z475 - (z53 * z625 + h1x * z505);
    const double z627 = c_steer * z461 + z73 * z396 + (s_steer * z460 - z76 * z394);
    const double z628 = z51 * z627 + z80 * z475;
    const double z629 = z53 * z627 + z80 * z505;
    const double z630 = s_lam * z628 + c_lam * z629;
    const double z631 = z394 * z77 - s_steer * z626 - (z396 * z83 + c_steer * z630);
    const double z632 = c_lam * z628 - s_lam * z629;
    const double z633 = z48 * z454 - c_yaw * z552 - (z45 * z455 - s_yaw * z551) + (z86 * z467 - e3z * (s_lam
        * z631 - c_lam * z632));
    const double z634 = z633 - (z393 * z87 - e2z * (z396 * z77 + c_steer * z626 + (z394 * z83 - s_steer *
        z630)));
    const double z635 = z634 + (z88 * z465 - z2 * (c_lam * z631 + s_lam * z632));
    const double z636 = z624 - z635;
    const double z637 = z451 * ((z623 - (z92 * z636 - z90 * z621)) / (z93 * z93));
    const double z638 = z416 * z627;
    const double z639 = z417 * z625;
    const double z640 = z394 * z461;
    const double z641 = z640 + z73 * z518;
    const double z642 = z438 * z394;
    const double z643 = z398 * z455;
    const double z644 = z643 - s_yaw * z525;
    const double z645 = z396 * z460;
    const double z646 = z645 - z76 * z521;
    const double z647 = z396 * z446;
    const double z648 = z440 * z410;
    const double z649 = z393 * z455;
    const double z650 = z649 + s_yaw * z517;
    const double z651 = z410 * z456;
    const double z652 = z651 + z71 * z596;
    const double z653 = z423 * z454;
    const double z654 = z653 - c_yaw * z600;
    const double z655 = z648 + c_pitch * z650 + z652 - z654;
    const double z656 = z440 * z423;
    const double z657 = z423 * z456;
    const double z658 = z657 - z71 * z600;
    const double z659 = z410 * z454;
    const double z660 = z659 + c_yaw * z596;
    const double z661 = z656 - s_pitch * z650 + z658 + z660;
    const double z662 = z641 + (z642 - s_steer * z644) + (z646 + (z647 + c_steer * (s_lam * z655 - c_lam *
        z661)));
    const double z663 = c_lam * z655 + s_lam * z661;
    const double z664 = r_F * (s_lam * z662 + c_lam * z663) + (c * (s_lam * z663 - c_lam * z662) - (r_R *
        z655 + k2 * z661));
    const double z665 = z464 + h3x * z573 - (z638 + z80 * z579 + (z639 + h1x * z582 + z664));
    const double z666 = z433 * z458;
    const double z667 = z404 * z461;
    const double z668 = z434 * z457;
    const double z669 = z436 * z636;
    const double z670 = z665 + (z666 - e3x * z615 - (z667 + z73 * z537 + (z668 + e1x * z619))) + (z669 - z90
        * z620);
    const double z671 = z637 + z142 * z670;
    const double z672 = z620 - (z622 - z92 * z671);
    const double z673 = z541 - (z393 * z453 + e2z * z672);
    const double z674 = z501 + (z453 * z465 - z2 * z672);
    const double z675 = z500 + (z453 * z467 - e3z * z672);
    const double z676 = c_lam * z674 + s_lam * z675;
    const double z677 = z396 * w2 - c_steer * z673 + (z394 * z477 - s_steer * z676);
    const double z678 = F_yy * z677;
    const double z679 = z436 * z567;
    const double z680 = z452 * (z92 * z567 + z65 * z621);
    const double z681 = z612 + (z679 + z65 * z620) - (z680 - z145 * z671);
    const double z682 = z453 * z454 + c_yaw * z672;
    const double z683 = z453 * z455 - s_yaw * z672;
    const double z684 = z593 + (z592 - e2z * z683);
    const double z685 = z607 + (z606 - c_pitch * z682) + (z605 + (z604 + s_pitch * z684));
    const double z686 = z601 + (z598 + s_pitch * z682) - (z597 + (z594 - c_pitch * z684));
    const double z687 = z681 + k2 * z685 - r_R * z686;
    const double z688 = z589 + (z588 + c_steer * (c_lam * z685 + s_lam * z686)) - (z584 + (z583 + s_steer *
        (z587 + (z586 + c_roll * z683))));
    const double z689 = s_lam * z685 - c_lam * z686;
    const double z690 = c_lam * z688 + s_lam * z689;
    const double z691 = c_lam * z689 - s_lam * z688;
    const double z692 = m_F * (z687 - c * z690 - r_F * z691);
    const double z693 = z436 * z635;
    const double z694 = z452 * (z92 * z635 + z89 * z621);
    const double z695 = z665 - (z693 + z89 * z620) + (z694 - z141 * z671);
    const double z696 = z650 + (z649 + e2z * z682);
    const double z697 = z660 + (z659 + c_pitch * z683) + (z658 + (z657 - s_pitch * z696));
    const double z698 = z654 + (z653 - s_pitch * z683) - (z652 + (z651 + c_pitch * z696));
    const double z699 = z695 - k2 * z697 + r_R * z698;
    const double z700 = z646 + (z645 - c_steer * (c_lam * z697 + s_lam * z698)) + (z641 + (z640 - s_steer *
        (z644 + (z643 - c_roll * z682))));
    const double z701 = s_lam * z697 - c_lam * z698;
    const double z702 = c_lam * z700 - s_lam * z701;
    const double z703 = c_lam * z701 + s_lam * z700;
    const double z704 = m_F * (z699 - c * z702 + r_F * z703);
    const double z705 = m_H * (z687 - k3 * z690 + z_H * z691);
    const double z706 = m_H * (z699 - k3 * z702 - z_H * z703);
    const double z707 = m_B * (z681 + x_B * z685 - k1 * z686);
    const double z708 = m_B * (z695 - x_B * z697 + k1 * z698);
    const double z709 = R_yy * (z452 + w2);
    const double z710 = z393 * z317;
    const double z711 = R_yy * (z671 - z673);
    const double wf = c_steer * z477 + s_steer * w2;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double o1 = c_lam * wf + s_lam * ws;
    const double o3 = c_lam * ws - s_lam * wf;
    const double z712 = H_xz * o1 + 2.0 * (k20 * o3);
    const double z713 = s_lam * c_steer;
    const double z714 = s_lam * z713 + k19;
    const double z715 = s_lam * z486;
    const double z716 = c_lam * (s_lam - z713);
    const double z717 = c_lam * z486;
    const double z718 = z714 * z467 + e3z * z715 + (z393 * z480 + e2z * z481) - (z716 * z465 - z2 * z717);
    const double z719 = z396 * z477 + c_steer * z676 - (z394 * w2 + s_steer * z673);
    const double z720 = s_lam * z674 - c_lam * z675;
    const double z721 = c_lam * z719 + s_lam * z720;
    const double z722 = c_lam * z720 - s_lam * z719;
    const double z723 = H_xz * z721 + 2.0 * (k20 * z722);
    const double z724 = H_yy * o2;
    const double z725 = H_yy * z677;
    const double z726 = H_xz * o3 + 2.0 * (k21 * o1);
    const double z727 = c_lam * c_steer;
    const double z728 = s_lam * (c_lam - z727);
    const double z729 = s_lam * z488;
    const double z730 = c_lam * z727 + k18;
    const double z731 = c_lam * z488;
    const double z732 = z728 * z467 - e3z * z729 - (z393 * z482 + e2z * z483) - (z730 * z465 + z2 * z731);
    const double z733 = 2.0 * (k21 * z721) + H_xz * z722;
    const double z734 = B_xz * w1 + 2.0 * (k23 * w3);
    const double z735 = B_xz * z674 - 2.0 * (k23 * z675);
    const double z736 = B_yy * w2;
    const double z737 = B_yy * z673;
    const double z738 = B_xz * w3 + 2.0 * (k22 * w1);
    const double z739 = 2.0 * (k22 * z674) - B_xz * z675;
    const double z740 = m_R * z695;
    const double z741 = m_R * z681;
    const double z742 = z736 * z710 + (z321 * z737 + (z738 * (z317 * z465) + (z318 * z739 + (z313 * z740 +
        z315 * z741))));
    const double z743 = z331 * z725 + (z726 * (z317 * z732) - (z327 * z733 - (z734 * (z317 * z467) + (z319 *
        z735 - z742))));
    const double z744 = z709 * z710 + (z334 * z711 - (z712 * (z317 * z718) - (z328 * z723 + (z724 * z485 -
        z743))));
    const double z745 = z365 * z692 + (z363 * z704 + (z361 * z705 + (z353 * z706 + (z346 * z707 + (z341 *
        z708 + z744)))));
    const double z746 = z396 * z110 + (z423 * z480 + s_pitch * z481 + (z410 * z482 - c_pitch * z483) + z148 *
        z484);
    const double z747 = z453 * (c_roll * c_steer - z480 * z173 - z482 * z172) + roll_dot * (z118 * z480 +
        z116 * z482);
    const double z748 = z746 + z747;
    const double z749 = z528 + (z527 + c_roll * z600);
    const double z750 = z526 + (z524 - c_roll * z596);
    const double z751 = z538 + k2 * z749 + r_R * z750;
    const double z752 = z519 - (z522 + (z520 - c_steer * (c_lam * z749 - s_lam * z750)));
    const double z753 = s_lam * z749 + c_lam * z750;
    const double z754 = c_lam * z752 + s_lam * z753;
    const double z755 = c_lam * z753 - s_lam * z752;
    const double z756 = m_F * (z751 - c * z754 - r_F * z755);
    const double z757 = m_H * (z751 - k3 * z754 + z_H * z755);
    const double z758 = m_B * (z538 + x_B * z749 + k1 * z750);
    const double z759 = z393 * z148 + c_roll * z453;
    const double z760 = z110 * z481 + (z423 * z714 - s_pitch * z715 - (z410 * z716 - c_pitch * z717) - z148 *
        z718);
    const double z761 = z453 * (z714 * z173 + c_roll * z480 - z716 * z172) - roll_dot * (z118 * z714 - z116 *
        z716);
    const double z762 = z110 * z483 - (z423 * z728 + s_pitch * z729 - (z410 * z730 + c_pitch * z731) - z148 *
        z732);
    const double z763 = z453 * (z728 * z173 - c_roll * z482 - z730 * z172) - roll_dot * (z118 * z728 - z116 *
        z730);
    const double z764 = z738 * (z410 - z148 * z465 - (z453 * z172 - roll_dot * z116)) + (z149 * z739 - (z107
        * (m_R * z538) + (z144 * z740 + z146 * z741)));
    const double z765 = z734 * (z423 - z148 * z467 - (z453 * z173 - roll_dot * z118)) - (z150 * z735 - (z736
        * z759 - (z152 * z737 + z764)));
    const double z766 = z157 * z723 - (z724 * z748 + (z159 * z725 - (z726 * (z762 + z763) + (z156 * z733 -
        z765))));
    const double z767 = z171 * z707 + (z167 * z708 + (z709 * z759 + (z160 * z711 + (z712 * (z760 - z761) -
        z766))));
    const double z768 = z197 * z692 + (z196 * z704 + (z194 * z757 + (z188 * z705 + (z181 * z706 + (z174 *
        z758 + z767)))));
    const double z769 = z478 * z748 + (z159 * z678 + (z199 * z756 + z768)) - g * (z200 + (z195 + (z147 +
        z175)));
    const double z770 = z453 * (z5 - (z480 * z270 + e3z * z713) + (z482 * z269 - z2 * z727)) - roll_dot *
        (z210 * z480 - s_pitch * z713 + (z208 * z482 + c_pitch * z727));
    const double z771 = z238 * z484 + z396 * z202 + (z412 - z770);
    const double z772 = z393 * z238;
    const double z773 = s_lam * z480;
    const double z774 = c_lam * z480;
    const double z775 = z453 * (z714 * z270 - e3z * z773 - e2z * z713 + (z716 * z269 - z2 * z774)) + roll_dot
        * (z210 * z714 + s_pitch * z773 - (z208 * z716 + c_pitch * z774));
    const double z776 = s_lam * z482;
    const double z777 = c_lam * z482;
    const double z778 = z453 * (z728 * z270 + e3z * z776 + e2z * z727 + (z730 * z269 + z2 * z777)) + roll_dot
        * (z210 * z728 - s_pitch * z776 - (z208 * z730 - c_pitch * z777));
    const double z779 = z738 * (z238 * z465 + (z453 * z269 - roll_dot * z208)) + (z239 * z739 + (z234 * z740
        + z236 * z741));
    const double z780 = z734 * (z238 * z467 - (z453 * z270 + roll_dot * z210)) + (z240 * z735 - (z736 * z772
        - (z242 * z737 - z779)));
    const double z781 = z252 * z725 - (z726 * (z238 * z732 + z202 * z483 + (z407 * z727 - z778)) - (z248 *
        z733 - z780));
    const double z782 = z712 * (z238 * z718 - z202 * z481 - (z407 * z713 + z775)) + (z249 * z723 - (z724 *
        z771 + z781));
    const double z783 = z279 * z706 + (z271 * z758 + (z267 * z707 + (z262 * z708 + (z709 * z772 + (z255 *
        z711 - z782)))));
    const double z784 = z252 * z678 + (z299 * z756 + (z297 * z692 + (z295 * z704 + (z293 * z757 + (z286 *
        z705 + z783)))));
    const double z785 = z478 * z771 + z784 - g * (z300 + (z272 + z294)) - z769 * z309;
    const double z786 = (z478 * z485 + (z367 * z678 + z745) - z769 * z373 - z378 * z785) / z379;
    const double z787 = z377 * z785 - z378 * z786;
    const double z788 = z769 * z308 - z309 * z787 - z373 * z786;
    const double z789 = z500 - s_pitch * z788;
    const double z790 = z501 + c_pitch * z788;
    const double z791 = s_lam * z789 + c_lam * z790;
    const double z792 = z499 + s_steer * z791;
    const double z793 = z787 - (c_lam * z789 - s_lam * z790);
    const double z794 = s_lam * z793;
    const double z795 = z509 - c_steer * z791;
    const double z796 = c_lam * z793;
    const double z797 = z504 - h2z * (z506 + z53 * (z794 - c_lam * z795) - (z511 + z51 * (s_lam * z795 +
        z796)));
    const double z798 = z517 + c_roll * z788;
    const double z799 = z518 + c_steer * z787;
    const double z800 = z521 - s_steer * z787;
    const double z801 = z525 - e2z * z788;
    const double z802 = z524 - c_pitch * z801;
    const double z803 = z527 + s_pitch * z801;
    const double z804 = z516 - s_steer * z798 + (z516 - e2z * z799) - (z520 - z4 * z800 + (z523 + c_steer *
        (s_lam * z802 - c_lam * z803)));
    const double z805 = c_lam * z802 + s_lam * z803;
    const double z806 = z534 + R3 * z790 + (z536 - z36 * z789);
    const double z807 = z531 - e2z * z806;
    const double z808 = r_F * (s_lam * z804 - c_lam * z805) - (c * (s_lam * z805 + c_lam * z804) - (r_R *
        z802 + (z807 + k2 * z803)));
    const double z809 = z497 + z10 * (z498 - z51 * z792) + (z797 - (z514 + z9 * (z515 - z53 * z792) - z808));
    const double z810 = z496 - z95 * z809;
    const double z811 = z786 + (z792 - (z571 - c_steer * z810));
    const double z812 = z476 - z51 * z811;
    const double z813 = z795 + (z576 + s_steer * z810);
    const double z814 = z575 + z53 * (z794 - c_lam * z813) - (z578 + z51 * (z796 + s_lam * z813));
    const double z815 = z581 - z53 * z811;
    const double z816 = z649 + s_yaw * z798;
    const double z817 = z595 + s_pitch * z810;
    const double z818 = z599 - c_pitch * z810;
    const double z819 = z648 + c_pitch * z816 + (z651 + z71 * z817) - (z653 - c_yaw * z818);
    const double z820 = z656 - s_pitch * z816 + (z657 - z71 * z818) + (z659 + c_yaw * z817);
    const double z821 = z640 + z73 * z799 + (z642 - s_steer * (z643 - s_yaw * z801)) + (z645 - z76 * z800 +
        (z647 + c_steer * (s_lam * z819 - c_lam * z820)));
    const double z822 = c_lam * z819 + s_lam * z820;
    const double z823 = r_F * (s_lam * z821 + c_lam * z822) + (c * (s_lam * z822 - c_lam * z821) - (r_R *
        z819 + k2 * z820));
    const double z824 = z464 + h3x * z812 - (z638 + z80 * z814 + (z639 + h1x * z815 + z823));
    const double z825 = z592 - c_yaw * z798;
    const double z826 = z591 - c_pitch * z825 + (z594 + z38 * z817) - (z598 + s_yaw * z818);
    const double z827 = z603 + s_pitch * z825 + (z604 - z38 * z818) + (z606 - s_yaw * z817);
    const double z828 = z583 + e2y * z799 + (z585 + s_steer * (z586 + c_yaw * z801)) - (z588 - z49 * z800 -
        (z590 + c_steer * (s_lam * z826 - c_lam * z827)));
    const double z829 = c_lam * z826 + s_lam * z827;
    const double z830 = r_F * (s_lam * z828 + c_lam * z829) + (c * (s_lam * z829 - c_lam * z828) - (r_R *
        z826 + k2 * z827));
    const double z831 = z570 + h3y * z812 + (z574 + h2y * z814 - (z580 + h1y * z815 - z830));
    const double z832 = z614 - z36 * z810;
    const double z833 = z618 - R3 * z810;
    const double z834 = z569 - z91 * (z831 + (z613 - e3y * z832 + (z616 + e2y * z806 - (z617 + e1y * z833))));
    const double z835 = z824 + (z666 - e3x * z832 - (z667 + z73 * z806 + (z668 + e1x * z833))) + (z669 - z90
        * z834);
    const double z836 = z637 + z142 * z835;
    /* (I.2.15) */
    qddot[0] = z824 - (z693 + z89 * z834) + (z694 - z141 * z836); /* x'' */
    qddot[1] = z831 + (z679 + z65 * z834) - (z680 - z145 * z836); /* y'' */
    qddot[2] = z807; /* z'' */
    qddot[3] = z622 - z92 * z836 - z834; /* yaw'' */
    qddot[4] = -z788; /* roll'' */
    qddot[5] = z810; /* pitch'' */
    qddot[6] = -z787; /* steer'' */
    qddot[7] = -z836; /* thR'' */
    qddot[8] = z786; /* thF'' */
    return bicycle_finish(9, qddot);
}

int bicycle_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double x = q[0]; /* centre of the rear wheel [m] */
    const double y_2 = q[1]; /* centre of the rear wheel [m] */
    const double z = q[2]; /* centre of the rear wheel, downwards [m] */
    const double yaw = q[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = q[4]; /* second turn, about x [rad] */
    const double pitch = q[5]; /* third turn, about y [rad] */
    const double steer = q[6]; /* front frame against rear frame [rad] */
    const double thR = q[7]; /* rear wheel against rear frame [rad] */
    const double thF = q[8]; /* front wheel against front frame [rad] */
    const double roll_dot = qdot[4];
    const double steer_dot = qdot[6];
    const double thF_dot = qdot[8];

    /* state */
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = yaw;
    y[4] = roll;
    y[5] = pitch;
    y[6] = steer;
    y[7] = thR;
    y[8] = thF;
    y[9] = roll_dot;
    y[10] = steer_dot;
    y[11] = thF_dot;
    return bicycle_finish(12, y);
}

int bicycle_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double yaw = q[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = q[4]; /* second turn, about x [rad] */
    const double pitch = q[5]; /* third turn, about y [rad] */
    const double steer = q[6]; /* front frame against rear frame [rad] */
    const double x_dot = qdot[0];
    const double y_dot = qdot[1];
    const double z_dot = qdot[2];
    const double yaw_dot = qdot[3];
    const double roll_dot = qdot[4];
    const double pitch_dot = qdot[5];
    const double steer_dot = qdot[6];
    const double thR_dot = qdot[7];
    const double thF_dot = qdot[8];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;

    /* state */
    const double c_yaw = cos(yaw);
    const double c_pitch = cos(pitch);
    const double s_yaw = sin(yaw);
    const double e2z = sin(roll);
    const double z1 = s_yaw * e2z;
    const double s_pitch = sin(pitch);
    const double e1x = c_yaw * c_pitch - z1 * s_pitch;
    const double w2 = pitch_dot + yaw_dot * e2z;
    const double z2 = thR_dot + w2;
    const double c_roll = cos(roll);
    const double e3z = c_pitch * c_roll;
    const double z3 = s_pitch * c_roll;
    const double z4 = 1.0 / sqrt(z3 * z3 + e3z * e3z);
    const double R3 = r_R * e3z * z4;
    const double a1 = z2 * R3;
    const double z5 = s_yaw * c_roll;
    const double w3 = roll_dot * s_pitch + yaw_dot * e3z;
    const double z6 = r_R * z3 * z4;
    const double w1 = roll_dot * c_pitch - yaw_dot * z3;
    const double z7 = w3 * z6 + w1 * R3;
    const double e3x = c_yaw * s_pitch + c_pitch * z1;
    const double a3 = z2 * z6;
    const double z8 = c_yaw * e2z;
    const double e1y = c_pitch * s_yaw + s_pitch * z8;
    const double e2y = c_yaw * c_roll;
    const double e3y = s_yaw * s_pitch - c_pitch * z8;
    const double z9 = yaw_dot * s_yaw;
    const double z10 = pitch_dot * s_pitch;
    const double z11 = yaw_dot * c_yaw;
    const double z12 = roll_dot * c_roll;
    const double z13 = e2z * z11 + s_yaw * z12;
    const double z14 = pitch_dot * c_pitch;
    const double z15 = c_pitch * z9 + c_yaw * z10 + (s_pitch * z13 + z1 * z14);
    const double z16 = s_pitch * z9 - c_yaw * z14 + (z1 * z10 - c_pitch * z13);
    const double z17 = e1x * c_lam - e3x * s_lam;
    const double s_steer = sin(steer);
    const double z18 = steer_dot * s_steer;
    const double c_steer = cos(steer);
    const double z19 = roll_dot * e2z;
    const double z20 = steer_dot * c_steer;
    const double z21 = z17 * z18 + c_steer * (c_lam * z15 - s_lam * z16) + (s_steer * (c_roll * z11 - s_yaw *
        z19) + z5 * z20);
    const double z22 = s_lam * z15 + c_lam * z16;
    const double Fx_dot = x_dot - k1 * z15 - r_R * z16 + c * (c_lam * z21 + s_lam * z22) + r_F * (c_lam * z22
        - s_lam * z21);
    const double f1x = c_steer * z17 - z5 * s_steer;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z23 = c_lam * w1 - s_lam * w3;
    const double z24 = thF_dot + (c_steer * w2 - s_steer * z23);
    const double z25 = z3 * s_lam - e3z * c_lam;
    const double z26 = z3 * c_lam + e3z * s_lam;
    const double z27 = c_steer * z26 - e2z * s_steer;
    const double z28 = c_lam * z25 - s_lam * z27;
    const double z29 = c_lam * z27 + s_lam * z25;
    const double z30 = 1.0 / sqrt(z29 * z29 + z28 * z28);
    const double z31 = r_F * z28 * z30;
    const double z32 = z24 * z31;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double wf = c_steer * z23 + s_steer * w2;
    const double z33 = r_F * z29 * z30;
    const double z34 = (c_lam * ws - s_lam * wf) * z33 - (c_lam * wf + s_lam * ws) * z31;
    const double b3 = z24 * z33;
    const double z35 = Fx_dot - (c_lam * f1x + s_lam * sx) * z32 + (z5 * c_steer + z17 * s_steer) * z34 +
        (c_lam * sx - s_lam * f1x) * b3;
    const double z36 = e2z * z9 - c_yaw * z12;
    const double z37 = s_yaw * z10 - c_pitch * z11 - (z8 * z14 - s_pitch * z36);
    const double z38 = s_pitch * z11 + s_yaw * z14 + (z8 * z10 + c_pitch * z36);
    const double z39 = e1y * c_lam - e3y * s_lam;
    const double z40 = z39 * z18 + c_steer * (c_lam * z37 + s_lam * z38) + (s_steer * (c_roll * z9 + c_yaw *
        z19) - e2y * z20);
    const double z41 = s_lam * z37 - c_lam * z38;
    const double Fy_dot = y_dot - k1 * z37 + r_R * z38 + c * (c_lam * z40 + s_lam * z41) + r_F * (c_lam * z41
        - s_lam * z40);
    const double f1y = c_steer * z39 + e2y * s_steer;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z42 = Fy_dot - (c_lam * f1y + s_lam * sy) * z32 - (e2y * c_steer - s_steer * z39) * z34 +
        (c_lam * sy - s_lam * f1y) * b3;
    const double z43 = c_roll * z14 - s_pitch * z19;
    const double z44 = c_roll * z10 + c_pitch * z19;
    const double z45 = z26 * z18 - c_steer * (c_lam * z43 - s_lam * z44) + (s_steer * z12 + e2z * z20);
    const double z46 = s_lam * z43 + c_lam * z44;
    const double Fz_dot = z_dot - k1 * z43 - r_R * z44 - c * (c_lam * z45 - s_lam * z46) + r_F * (c_lam * z46
        + s_lam * z45);
    /* (I.1.1) 115:5 */
    r[0] = x_dot + e1x * a1 + z5 * z7 + e3x * a3; /* rear_x = 0 */
    /* (I.1.1) 116:5 */
    r[1] = y_dot + e1y * a1 - e2y * z7 + e3y * a3; /* rear_y = 0 */
    /* (I.1.1) 117:5 */
    r[2] = z_dot - z3 * a1 - e2z * z7 + e3z * a3; /* rear_z = 0 */
    /* (I.1.1) 118:5 */
    r[3] = z35; /* front_x = 0 */
    /* (I.1.1) 119:5 */
    r[4] = z42; /* front_y = 0 */
    /* (I.1.1) 120:5 */
    r[5] = Fz_dot + z29 * z32 - (e2z * c_steer + s_steer * z26) * z34 - z28 * b3; /* front_z = 0 */
    return bicycle_finish(6, r);
}

int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = 0.5 * R_xx;
    const double k5 = 0.5 * F_xx;
    const double k6 = r_F * c_lam + c * s_lam;
    const double k7 = r_F * s_lam - c * c_lam;
    const double k8 = c_lam * k6;
    const double k9 = s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(c);
    const double k13 = k11 + k12;
    const double k14 = k13 + (k10 + k13) + (k13 + (fabs(w) + k12 + k13));
    const double k15 = k13 + k14;
    const double k16 = 3.0 * k13;
    const double k17 = k14 + k15;
    const double k18 = s_lam * s_lam;
    const double k19 = c_lam * c_lam;
    const double k20 = 0.5 * H_zz + k5;
    const double k21 = 0.5 * H_xx + k5;
    const double k22 = k4 + 0.5 * B_xx;
    const double k23 = k4 + 0.5 * B_zz;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = e2z * s_steer;
    const double z6 = c_steer * z4 - z5;
    const double z7 = z2 * s_lam;
    const double z8 = z7 - e3z * c_lam;
    const double z9 = c_lam * z6 + s_lam * z8;
    const double z10 = c_lam * z8 - s_lam * z6;
    const double z11 = z9 * z9 + z10 * z10;
    const double z12 = 1.0 / sqrt(z11);
    const double z13 = s_steer * z12;
    const double z14 = e2z * c_steer;
    const double z15 = z14 + 2.0 * (s_steer * z3);
    const double z16 = s_lam * z1 - z13 * z15;
    const double z17 = s_steer * s_steer;
    const double z18 = z7 * z17;
    const double z19 = c_lam * z1 + 2.0 * (z12 * z18);
    const double z20 = c_roll * s_lam;
    const double z21 = z17 * z20;
    const double z22 = c_pitch * c_lam - s_pitch * s_lam;
    const double z23 = e2z * s_lam;
    const double z24 = s_steer * z23;
    const double z25 = 1.0 + z12 * z24;
    const double z26 = e3z * z17;
    const double z27 = r_R - r_F * (c_steer * z25 + z12 * z26);
    const double z28 = c_lam * (r_F * (c_pitch * z16 + (s_pitch * z19 - z12 * z21)) - c * (z1 * z22)) -
        (s_pitch * z27 + w * c_pitch);
    const double z29 = c_roll * z28;
    const double z30 = k11 * fabs(z12);
    const double z31 = 110.0 * z30;
    const double z32 = 30.0 * z30 + k16 + (80.0 * z30 + k14 + (z31 + (z31 + k15) + (1.0 + 300.0 * z30)));
    /* the coframe is singular */
    if (!(fabs(z29) > 1e-12 * (50.0 * z30 + z32))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z33 = r_R * z2;
    const double z34 = z2 * z2 + e3z * e3z;
    const double z35 = 1.0 / sqrt(z34);
    const double z36 = z33 * z35;
    const double z37 = e2y * z36;
    const double s_yaw = sin(yaw);
    const double z38 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z38;
    const double e1y = c_pitch * s_yaw + s_pitch * z38;
    const double z39 = r_R * e3z;
    const double R3 = z39 * z35;
    const double z40 = e3y * z36 + e1y * R3;
    const double z41 = e2y * R3;
    const double z42 = c_steer * k7;
    const double z43 = r_R - s_lam * z42 - k8;
    const double z44 = k2 + c_lam * z42 - k9;
    const double z45 = s_pitch * z43 + c_pitch * z44;
    const double z46 = s_steer * k7;
    const double z47 = c_pitch * z43 - s_pitch * z44;
    const double z48 = c_roll * z46 - e2z * z47;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z49 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z49 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z50 = r_F * z9;
    const double z51 = z50 * z12;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z52 = r_F * z10;
    const double z53 = z52 * z12;
    const double z54 = h3y * z51 - h1y * z53;
    const double z55 = e2y * c_steer;
    const double z56 = s_steer * z49;
    const double h2y = z55 - z56;
    const double z57 = h2y * z51;
    const double z58 = h2y * z53;
    const double z59 = s_lam * z57 + c_lam * z58;
    const double z60 = s_steer * z54 - c_steer * z59;
    const double z61 = c_lam * z57 - s_lam * z58;
    const double z62 = s_lam * z60 - c_lam * z61;
    const double z63 = c_steer * z54 + s_steer * z59;
    const double z64 = c_lam * z60 + s_lam * z61;
    const double z65 = c_yaw * z45 - s_yaw * z48 + e3z * z62 + e2z * z63 + z2 * z64;
    const double z66 = e3z * z37 - e2z * z40 - z2 * z41 + z65;
    const double z67 = k10 * fabs(z35);
    const double z68 = 4.0 * z67;
    const double z69 = 190.0 * z30;
    const double z70 = 6.0 * z67 + (z69 + (140.0 * z30 + (z69 + k17)));
    /* the coframe is singular */
    if (!(fabs(-z66) > 1e-12 * (z68 + z70))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z71 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z71;
    const double e1x = c_yaw * c_pitch - z71 * s_pitch;
    const double z72 = e3x * z36 + e1x * R3;
    const double z73 = s_yaw * c_roll;
    const double z74 = z73 * z36;
    const double z75 = z73 * R3;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z76 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z76 - z73 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z77 = h3x * z51 - h1x * z53;
    const double z78 = z73 * c_steer;
    const double z79 = z76 * s_steer;
    const double z80 = z78 + z79;
    const double z81 = z80 * z51;
    const double z82 = z80 * z53;
    const double z83 = s_lam * z81 + c_lam * z82;
    const double z84 = s_steer * z77 + c_steer * z83;
    const double z85 = c_lam * z81 - s_lam * z82;
    const double z86 = s_lam * z84 + c_lam * z85;
    const double z87 = c_steer * z77 - s_steer * z83;
    const double z88 = c_lam * z84 - s_lam * z85;
    const double z89 = c_yaw * z48 + s_yaw * z45 - e3z * z86 - e2z * z87 - z2 * z88;
    const double z90 = e3z * z74 + e2z * z72 - z2 * z75 + z89;
    const double z91 = 1.0 / z66;
    const double z92 = z40 * z91;
    const double z93 = z72 + z90 * z92;
    /* the coframe is singular */
    if (!(fabs(z93) > 1e-12 * (z68 + 4.0 * (z70 * (z67 * fabs(z91)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z94 = s_steer * z22;
    const double z95 = 1.0 / z29;
    const double z96 = s_steer * z4;
    const double h2z = z14 + z96;
    const double z97 = s_pitch * c_lam + c_pitch * s_lam;
    const double z98 = s_lam * z97;
    const double z99 = c_steer * z22;
    const double z100 = c_lam * z97;
    const double z101 = c_roll * s_steer;
    const double z102 = c_pitch * e2z;
    const double z103 = e2z * s_pitch;
    const double z104 = z101 + c_steer * (s_lam * z102 + c_lam * z103);
    const double z105 = c_lam * z102 - s_lam * z103;
    const double z106 = c_pitch * R3 + s_pitch * z36;
    const double z107 = e2z * z106;
    const double z108 = r_F * (s_lam * z104 + c_lam * z105) + (c * (s_lam * z105 - c_lam * z104) - (r_R *
        z102 - (z107 + k2 * z103)));
    const double z109 = h2z * (z53 * (z98 + c_lam * z99) + z51 * (s_lam * z99 - z100)) - (z9 * (z53 * z94) -
        z108);
    const double z110 = z95 * (z10 * (z51 * z94) + z109);
    const double z111 = z94 + c_steer * z110;
    const double z112 = z51 * z111;
    const double z113 = z99 - s_steer * z110;
    const double z114 = z53 * (z98 + c_lam * z113) - z51 * (z100 - s_lam * z113);
    const double z115 = z53 * z111;
    const double z116 = s_pitch * z110;
    const double z117 = z71 * z116;
    const double z118 = c_pitch * z110;
    const double z119 = c_yaw * z118;
    const double z120 = c_pitch * z73 + z117 - z119;
    const double z121 = z71 * z118;
    const double z122 = c_yaw * z116;
    const double z123 = z121 - s_pitch * z73 + z122;
    const double z124 = z71 * s_steer - c_steer * (s_lam * z120 - c_lam * z123);
    const double z125 = c_lam * z120 + s_lam * z123;
    const double z126 = r_F * (s_lam * z124 - c_lam * z125) - (c * (s_lam * z125 + c_lam * z124) - (r_R *
        z120 + k2 * z123));
    const double z127 = h3x * z112 + (z80 * z114 - (h1x * z115 + z126));
    const double z128 = z38 * z116;
    const double z129 = s_yaw * z118;
    const double z130 = c_pitch * e2y + z128 + z129;
    const double z131 = z38 * z118;
    const double z132 = s_yaw * z116;
    const double z133 = s_pitch * e2y - z131 + z132;
    const double z134 = z38 * s_steer - c_steer * (s_lam * z130 + c_lam * z133);
    const double z135 = c_lam * z130 - s_lam * z133;
    const double z136 = r_F * (s_lam * z134 - c_lam * z135) - (c * (s_lam * z135 + c_lam * z134) - (r_R *
        z130 - k2 * z133));
    const double z137 = h3y * z112 - (h2y * z114 + (h1y * z115 - z136));
    const double z138 = z36 * z110;
    const double z139 = R3 * z110;
    const double z140 = z91 * (z137 - (e3y * z138 + (e2y * z106 + e1y * z139)));
    const double z141 = z89 * z92;
    const double z142 = 1.0 / z93;
    const double z143 = z142 * (z127 - (e3x * z138 - (z73 * z106 - e1x * z139)) + z90 * z140);
    const double z144 = z127 + z89 * z140 - z141 * z143;
    const double z145 = m_R * z144;
    const double z146 = z65 * z92;
    const double z147 = z137 - z65 * z140 + z146 * z143;
    const double z148 = m_R * z147;
    const double z149 = m_R * z107;
    const double z150 = z140 - z92 * z143;
    const double z151 = c_pitch - z2 * z150;
    const double z152 = s_pitch + e3z * z150;
    const double z153 = 2.0 * (k22 * z151) + B_xz * z152;
    const double z154 = z110 - e2z * z150;
    const double z155 = B_yy * z154;
    const double z156 = B_xz * z151 + 2.0 * (k23 * z152);
    const double z157 = z144 * z145 + z147 * z148 + z107 * z149 + z151 * z153 + z154 * z155 + z152 * z156;
    const double z158 = c_lam * z151 - s_lam * z152;
    const double z159 = c_steer * z158 - s_steer * z154;
    const double z160 = s_lam * z151 + c_lam * z152;
    const double z161 = c_lam * z159 + s_lam * z160;
    const double z162 = c_lam * z160 - s_lam * z159;
    const double z163 = 2.0 * (k21 * z161) + H_xz * z162;
    const double z164 = c_steer * z154 + s_steer * z158;
    const double z165 = H_yy * z164;
    const double z166 = H_xz * z161 + 2.0 * (k20 * z162);
    const double z167 = z143 + z154;
    const double z168 = R_yy * z167;
    const double z169 = s_yaw * z150;
    const double z170 = c_yaw * z150;
    const double z171 = z73 + e2z * z170;
    const double z172 = z122 - c_pitch * z169 + (z121 - s_pitch * z171);
    const double z173 = z119 + s_pitch * z169 - (z117 + c_pitch * z171);
    const double z174 = z144 + x_B * z172 - k1 * z173;
    const double z175 = m_B * z174;
    const double z176 = e2y - e2z * z169;
    const double z177 = z132 + c_pitch * z170 - (z131 - s_pitch * z176);
    const double z178 = z129 - s_pitch * z170 + (z128 + c_pitch * z176);
    const double z179 = z147 + x_B * z177 - k1 * z178;
    const double z180 = m_B * z179;
    const double z181 = z157 + z161 * z163 + z164 * z165 + z162 * z166 + z167 * z168 + z174 * z175 + z179 *
        z180;
    const double z182 = z103 + c_roll * z118;
    const double z183 = z102 - c_roll * z116;
    const double z184 = z107 + x_B * z182 - k1 * z183;
    const double z185 = m_B * z184;
    const double z186 = z144 + k2 * z172 - r_R * z173;
    const double z187 = c_steer * (c_lam * z172 + s_lam * z173) + s_steer * (z71 - c_roll * z170);
    const double z188 = s_lam * z172 - c_lam * z173;
    const double z189 = c_lam * z187 + s_lam * z188;
    const double z190 = c_lam * z188 - s_lam * z187;
    const double z191 = z186 - k3 * z189 + z_H * z190;
    const double z192 = m_H * z191;
    const double z193 = z147 + k2 * z177 - r_R * z178;
    const double z194 = c_steer * (c_lam * z177 + s_lam * z178) - s_steer * (z38 + c_roll * z169);
    const double z195 = s_lam * z177 - c_lam * z178;
    const double z196 = c_lam * z194 + s_lam * z195;
    const double z197 = c_lam * z195 - s_lam * z194;
    const double z198 = z193 - k3 * z196 + z_H * z197;
    const double z199 = m_H * z198;
    const double z200 = z107 + k2 * z182 - r_R * z183;
    const double z201 = z101 + c_steer * (c_lam * z182 + s_lam * z183);
    const double z202 = s_lam * z182 - c_lam * z183;
    const double z203 = c_lam * z201 + s_lam * z202;
    const double z204 = c_lam * z202 - s_lam * z201;
    const double z205 = z200 - k3 * z203 + z_H * z204;
    const double z206 = m_H * z205;
    const double z207 = z186 - c * z189 - r_F * z190;
    const double z208 = m_F * z207;
    const double z209 = z193 - c * z196 - r_F * z197;
    const double z210 = m_F * z209;
    const double z211 = z181 + z184 * z185 + z191 * z192 + z198 * z199 + z205 * z206 + z207 * z208 + z209 *
        z210;
    const double z212 = z200 - c * z203 - r_F * z204;
    const double z213 = m_F * z212;
    const double z214 = F_yy * z164;
    const double z215 = z211 + z212 * z213 + z164 * z214;
    /* the mass matrix is singular */
    if (!(fabs(z215) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z216 = z95 * (h2z * (s_lam * z53 - c_lam * z51) + (r_F * (s_lam * h2z) - c * (c_lam * h2z)));
    const double z217 = c_steer * z216;
    const double z218 = z51 * z217;
    const double z219 = s_steer * z216;
    const double z220 = z53 * (s_lam - c_lam * z219) - z51 * (c_lam + s_lam * z219);
    const double z221 = z53 * z217;
    const double z222 = s_pitch * z216;
    const double z223 = z71 * z222;
    const double z224 = c_pitch * z216;
    const double z225 = c_yaw * z224;
    const double z226 = z223 - z225;
    const double z227 = z71 * z224;
    const double z228 = c_yaw * z222;
    const double z229 = z227 + z228;
    const double z230 = z78 + (z79 + c_steer * (s_lam * z226 - c_lam * z229));
    const double z231 = c_lam * z226 + s_lam * z229;
    const double z232 = r_F * (s_lam * z230 + c_lam * z231) + (c * (s_lam * z231 - c_lam * z230) - (r_R *
        z226 + k2 * z229));
    const double z233 = h3x * z218 + (z80 * z220 - (h1x * z221 - z232));
    const double z234 = z38 * z222;
    const double z235 = s_yaw * z224;
    const double z236 = z234 + z235;
    const double z237 = z38 * z224;
    const double z238 = s_yaw * z222;
    const double z239 = z237 - z238;
    const double z240 = z55 - (z56 - c_steer * (s_lam * z236 - c_lam * z239));
    const double z241 = c_lam * z236 + s_lam * z239;
    const double z242 = r_F * (s_lam * z240 + c_lam * z241) + (c * (s_lam * z241 - c_lam * z240) - (r_R *
        z236 + k2 * z239));
    const double z243 = h3y * z218 - (h2y * z220 + (h1y * z221 + z242));
    const double z244 = z36 * z216;
    const double z245 = R3 * z216;
    const double z246 = z91 * (z243 - (e3y * z244 + e1y * z245));
    const double z247 = z142 * (z233 - (e3x * z244 + e1x * z245) + z90 * z246);
    const double z248 = z233 + z89 * z246 - z141 * z247;
    const double z249 = m_R * z248;
    const double z250 = z243 - z65 * z246 + z146 * z247;
    const double z251 = m_R * z250;
    const double z252 = z246 - z92 * z247;
    const double z253 = z2 * z252;
    const double z254 = e3z * z252;
    const double z255 = 2.0 * (k22 * z253) - B_xz * z254;
    const double z256 = z216 - e2z * z252;
    const double z257 = B_yy * z256;
    const double z258 = B_xz * z253 - 2.0 * (k23 * z254);
    const double z259 = c_lam * z253 + s_lam * z254;
    const double z260 = c_steer * z259 + s_steer * z256;
    const double z261 = 1.0 - (s_lam * z253 - c_lam * z254);
    const double z262 = c_lam * z260 - s_lam * z261;
    const double z263 = c_lam * z261 + s_lam * z260;
    const double z264 = 2.0 * (k21 * z262) - H_xz * z263;
    const double z265 = z248 * z249 + z250 * z251 + z253 * z255 + z256 * z257 - z254 * z258 + z262 * z264;
    const double z266 = c_steer * z256 - s_steer * z259;
    const double z267 = H_yy * z266;
    const double z268 = H_xz * z262 - 2.0 * (k20 * z263);
    const double z269 = z247 + z256;
    const double z270 = R_yy * z269;
    const double z271 = s_yaw * z252;
    const double z272 = c_yaw * z252;
    const double z273 = e2z * z272;
    const double z274 = z228 - c_pitch * z271 + (z227 - s_pitch * z273);
    const double z275 = z225 + s_pitch * z271 - (z223 + c_pitch * z273);
    const double z276 = z248 + x_B * z274 - k1 * z275;
    const double z277 = m_B * z276;
    const double z278 = e2z * z271;
    const double z279 = z238 + c_pitch * z272 - (z237 + s_pitch * z278);
    const double z280 = z235 - s_pitch * z272 + (z234 - c_pitch * z278);
    const double z281 = z250 + x_B * z279 - k1 * z280;
    const double z282 = m_B * z281;
    const double z283 = c_roll * z224;
    const double z284 = c_roll * z222;
    const double z285 = x_B * z283 + k1 * z284;
    const double z286 = m_B * z285;
    const double z287 = z265 + z266 * z267 - z263 * z268 + z269 * z270 + z276 * z277 + z281 * z282 + z285 *
        z286;
    const double z288 = z248 + k2 * z274 - r_R * z275;
    const double z289 = z79 - c_steer * (c_lam * z274 + s_lam * z275) + (z78 + s_steer * (c_roll * z272));
    const double z290 = s_lam * z274 - c_lam * z275;
    const double z291 = c_lam * z289 - s_lam * z290;
    const double z292 = c_lam * z290 + s_lam * z289;
    const double z293 = z288 + k3 * z291 + z_H * z292;
    const double z294 = m_H * z293;
    const double z295 = z250 + k2 * z279 - r_R * z280;
    const double z296 = z56 - c_steer * (c_lam * z279 + s_lam * z280) - (z55 - s_steer * (c_roll * z271));
    const double z297 = s_lam * z279 - c_lam * z280;
    const double z298 = c_lam * z296 - s_lam * z297;
    const double z299 = c_lam * z297 + s_lam * z296;
    const double z300 = z295 + k3 * z298 + z_H * z299;
    const double z301 = m_H * z300;
    const double z302 = k2 * z283 + r_R * z284;
    const double z303 = z14 + (z96 + c_steer * (c_lam * z283 - s_lam * z284));
    const double z304 = s_lam * z283 + c_lam * z284;
    const double z305 = c_lam * z303 + s_lam * z304;
    const double z306 = c_lam * z304 - s_lam * z303;
    const double z307 = z302 - k3 * z305 + z_H * z306;
    const double z308 = m_H * z307;
    const double z309 = z288 + c * z291 - r_F * z292;
    const double z310 = m_F * z309;
    const double z311 = z295 + c * z298 - r_F * z299;
    const double z312 = m_F * z311;
    const double z313 = z302 - c * z305 - r_F * z306;
    const double z314 = m_F * z313;
    const double z315 = z287 + z293 * z294 + z300 * z301 + z307 * z308 + z309 * z310 + z311 * z312 + z313 *
        z314;
    const double z316 = F_yy * z266;
    const double z317 = z315 + z266 * z316;
    const double z318 = z144 * z249 + z147 * z251 - z151 * z255 + z154 * z257 - z152 * z258 - z161 * z264;
    const double z319 = z318 + z164 * z267 - z162 * z268 + z167 * z270 + z174 * z277 + z179 * z282 + z184 *
        z286;
    const double z320 = z319 + z191 * z294 + z198 * z301 + z205 * z308 + z207 * z310 + z209 * z312 + z212 *
        z314;
    const double z321 = z320 + z164 * z316;
    const double z322 = 1.0 / z215;
    const double z323 = z321 * z322;
    const double z324 = z317 - z321 * z323;
    /* the mass matrix is singular */
    if (!(fabs(z324) > 1e-14 * z317)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z325 = z54 * z91;
    const double z326 = z142 * (z77 + z90 * z325);
    const double z327 = z77 + z89 * z325 - z141 * z326;
    const double z328 = m_R * z327;
    const double z329 = z54 - z65 * z325 + z146 * z326;
    const double z330 = m_R * z329;
    const double z331 = z325 - z92 * z326;
    const double z332 = z2 * z331;
    const double z333 = e3z * z331;
    const double z334 = 2.0 * (k22 * z332) - B_xz * z333;
    const double z335 = e2z * z331;
    const double z336 = B_yy * z335;
    const double z337 = B_xz * z332 - 2.0 * (k23 * z333);
    const double z338 = c_lam * z332 + s_lam * z333;
    const double z339 = c_steer * z338 - s_steer * z335;
    const double z340 = s_lam * z332 - c_lam * z333;
    const double z341 = c_lam * z339 + s_lam * z340;
    const double z342 = c_lam * z340 - s_lam * z339;
    const double z343 = 2.0 * (k21 * z341) + H_xz * z342;
    const double z344 = z327 * z328 + z329 * z330 + z332 * z334 + z335 * z336 - z333 * z337 + z341 * z343;
    const double z345 = c_steer * z335 + s_steer * z338;
    const double z346 = H_yy * z345;
    const double z347 = H_xz * z341 + 2.0 * (k20 * z342);
    const double z348 = z326 - z335;
    const double z349 = R_yy * z348;
    const double z350 = s_yaw * z331;
    const double z351 = c_yaw * z331;
    const double z352 = e2z * z351;
    const double z353 = c_pitch * z350 + s_pitch * z352;
    const double z354 = s_pitch * z350 - c_pitch * z352;
    const double z355 = z327 - x_B * z353 - k1 * z354;
    const double z356 = m_B * z355;
    const double z357 = e2z * z350;
    const double z358 = c_pitch * z351 - s_pitch * z357;
    const double z359 = s_pitch * z351 + c_pitch * z357;
    const double z360 = z329 + x_B * z358 + k1 * z359;
    const double z361 = m_B * z360;
    const double z362 = z327 - k2 * z353 - r_R * z354;
    const double z363 = c_steer * (c_lam * z353 - s_lam * z354) + s_steer * (c_roll * z351);
    const double z364 = s_lam * z353 + c_lam * z354;
    const double z365 = c_lam * z363 + s_lam * z364;
    const double z366 = c_lam * z364 - s_lam * z363;
    const double z367 = z362 + k3 * z365 - z_H * z366;
    const double z368 = m_H * z367;
    const double z369 = z344 + z345 * z346 + z342 * z347 + z348 * z349 + z355 * z356 + z360 * z361 + z367 *
        z368;
    const double z370 = z329 + k2 * z358 + r_R * z359;
    const double z371 = c_steer * (c_lam * z358 - s_lam * z359) - s_steer * (c_roll * z350);
    const double z372 = s_lam * z358 + c_lam * z359;
    const double z373 = c_lam * z371 + s_lam * z372;
    const double z374 = c_lam * z372 - s_lam * z371;
    const double z375 = z370 - k3 * z373 + z_H * z374;
    const double z376 = m_H * z375;
    const double z377 = z362 + c * z365 + r_F * z366;
    const double z378 = m_F * z377;
    const double z379 = z370 - c * z373 - r_F * z374;
    const double z380 = m_F * z379;
    const double z381 = 1.0 - z345;
    const double z382 = F_yy * z381;
    const double z383 = z369 + z375 * z376 + z377 * z378 + z379 * z380 + z381 * z382;
    const double z384 = z144 * z328 + z147 * z330 - z151 * z334 - z154 * z336 - z152 * z337 - z161 * z343;
    const double z385 = z384 - z164 * z346 - z162 * z347 + z167 * z349 + z174 * z356 + z179 * z361 + z191 *
        z368;
    const double z386 = z385 + z198 * z376 + z207 * z378 + z209 * z380 + z164 * z382;
    const double z387 = z386 * z322;
    const double z388 = z248 * z328 + z250 * z330 + z253 * z334 - z256 * z336 - z254 * z337 + z262 * z343;
    const double z389 = z388 - z266 * z346 - z263 * z347 + z269 * z349 + z276 * z356 + z281 * z361 + z293 *
        z368;
    const double z390 = z389 + z300 * z376 + z309 * z378 + z311 * z380 + z266 * z382 - z321 * z387;
    const double z391 = 1.0 / z324;
    const double z392 = z390 * z391;
    const double z393 = z383 - z386 * z387 - z390 * z392;
    /* the mass matrix is singular */
    if (!(fabs(z393) > 1e-14 * z383)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z394 = roll_dot * s_pitch;
    const double z395 = roll_dot * c_pitch;
    const double z396 = s_lam * z394 - c_lam * z395;
    const double z397 = s_steer * z396;
    const double z398 = z51 * z397;
    const double z399 = steer_dot + (c_lam * z394 + s_lam * z395);
    const double z400 = s_lam * z399;
    const double z401 = c_steer * z396;
    const double z402 = z400 - c_lam * z401;
    const double z403 = c_lam * z399;
    const double z404 = s_lam * z401 + z403;
    const double z405 = z53 * z402 - z51 * z404;
    const double z406 = z53 * z397;
    const double z407 = roll_dot * c_roll;
    const double z408 = steer_dot * c_steer;
    const double z409 = s_steer * z407 + e2z * z408;
    const double z410 = steer_dot * s_steer;
    const double z411 = z4 * z410;
    const double z412 = roll_dot * e2z;
    const double z413 = c_pitch * z412;
    const double z414 = s_pitch * z412;
    const double z415 = s_lam * z413 + c_lam * z414;
    const double z416 = z409 + (z411 + c_steer * z415);
    const double z417 = c_lam * z413 - s_lam * z414;
    const double z418 = z395 * R3 + z394 * z36;
    const double z419 = r_F * (s_lam * z416 + c_lam * z417) + (c * (s_lam * z417 - c_lam * z416) - (r_R *
        z413 - (e2z * z418 + k2 * z414)));
    const double z420 = z10 * z398 - (h2z * z405 + (z9 * z406 + z419));
    const double z421 = z95 * z420;
    const double z422 = thF_dot + (z397 + c_steer * z421);
    const double z423 = z51 * z422;
    const double z424 = s_steer * z421;
    const double z425 = z401 - z424;
    const double z426 = z400 - c_lam * z425;
    const double z427 = z403 + s_lam * z425;
    const double z428 = z53 * z426 - z51 * z427;
    const double z429 = z53 * z422;
    const double z430 = e2y * z408;
    const double z431 = c_yaw * z412;
    const double z432 = z49 * z410;
    const double z433 = c_yaw * z407;
    const double z434 = s_pitch * z421;
    const double z435 = z38 * z434;
    const double z436 = c_pitch * z421;
    const double z437 = s_yaw * z436;
    const double z438 = c_pitch * z433 - z435 - z437;
    const double z439 = z38 * z436;
    const double z440 = s_yaw * z434;
    const double z441 = s_pitch * z433 + z439 - z440;
    const double z442 = s_lam * z438 + c_lam * z441;
    const double z443 = z430 - s_steer * z431 - (z432 - c_steer * z442);
    const double z444 = c_lam * z438 - s_lam * z441;
    const double z445 = r_F * (s_lam * z443 + c_lam * z444) + (c * (s_lam * z444 - c_lam * z443) - (r_R *
        z438 - k2 * z441));
    const double z446 = z36 * z421;
    const double z447 = R3 * z421;
    const double z448 = h3y * z423 + (h2y * z428 - (h1y * z429 - z445)) - (e3y * z446 - (e2y * z418 - e1y *
        z447));
    const double z449 = z91 * z448;
    const double z450 = z73 * z408;
    const double z451 = s_yaw * z412;
    const double z452 = z76 * z410;
    const double z453 = s_yaw * z407;
    const double z454 = z71 * z434;
    const double z455 = c_yaw * z436;
    const double z456 = c_pitch * z453 - z454 + z455;
    const double z457 = z71 * z436;
    const double z458 = c_yaw * z434;
    const double z459 = s_pitch * z453 + z457 + z458;
    const double z460 = s_lam * z456 + c_lam * z459;
    const double z461 = z450 - s_steer * z451 + (z452 + c_steer * z460);
    const double z462 = c_lam * z456 - s_lam * z459;
    const double z463 = r_F * (s_lam * z461 + c_lam * z462) + (c * (s_lam * z462 - c_lam * z461) - (r_R *
        z456 - k2 * z459));
    const double z464 = h3x * z423 - (z80 * z428 + (h1x * z429 + z463)) - (e3x * z446 + (z73 * z418 + e1x *
        z447));
    const double z465 = z464 + z90 * z449;
    const double z466 = z142 * z465;
    const double z467 = z449 - z92 * z466;
    const double w2 = z421 - e2z * z467;
    const double w1 = z395 + z2 * z467;
    const double w3 = z394 - e3z * z467;
    const double z468 = c_lam * w1 - s_lam * w3;
    const double o2 = c_steer * w2 - s_steer * z468;
    const double z469 = F_yy * (thF_dot + o2);
    const double z470 = z92 * z142;
    const double z471 = c_steer * z407 - e2z * z410;
    const double z472 = s_lam * s_steer;
    const double z473 = z413 + c_roll * z434;
    const double z474 = s_lam * z408;
    const double z475 = c_lam * s_steer;
    const double z476 = z414 - c_roll * z436;
    const double z477 = c_lam * z408;
    const double z478 = z471 - (z472 * z473 - e3z * z474) - (z475 * z476 - z2 * z477);
    const double z479 = z470 * z478;
    const double z480 = z469 * z479;
    const double z481 = s_lam * z410;
    const double z482 = c_lam * z476;
    const double z483 = z482 + s_lam * z473;
    const double z484 = z409 + (z411 + c_steer * z483);
    const double z485 = s_lam * z476;
    const double z486 = z485 - c_lam * z473;
    const double z487 = c_lam * z484 + s_lam * z486;
    const double z488 = c_lam * z486 - s_lam * z484;
    const double z489 = z12 * (2.0 * (z9 * z487) + 2.0 * (z10 * z488)) / z11;
    const double z490 = z15 * (z408 * z12 + 0.5 * (s_steer * z489)) + z13 * (z471 + 2.0 * (z3 * z408 -
        s_steer * z482));
    const double z491 = c_lam * z410;
    const double z492 = s_steer * z408;
    const double z493 = s_pitch * (z491 + 2.0 * (0.5 * (z18 * z489) - z12 * (z17 * z485 - 2.0 * (z7 *
        z492))));
    const double z494 = z19 * z436 + z493 - (0.5 * (z21 * z489) + z12 * (2.0 * (z20 * z492) - z17 * (s_lam *
        z412)));
    const double z495 = r_F * (z16 * z434 - c_pitch * (z481 - z490) - z494) + c * (z410 * z22 - z1 * (c_lam *
        z434 + s_lam * z436));
    const double z496 = z410 * z25 - c_steer * (0.5 * (z24 * z489) + z12 * (z408 * z23 + s_steer * (s_lam *
        z407)));
    const double z497 = s_pitch * (r_F * (z496 - (0.5 * (z26 * z489) - z12 * (z17 * z473 - 2.0 * (e3z *
        z492)))));
    const double z498 = (z412 * z28 + c_roll * (c_lam * z495 + (z27 * z436 + z497 - w * z434))) / (z29 * z29);
    const double z499 = z12 * (r_F * z487) - 0.5 * (z50 * z489);
    const double z500 = roll_dot * z436;
    const double z501 = roll_dot * z434;
    const double z502 = s_lam * z500 + c_lam * z501;
    const double z503 = z408 * z396 + s_steer * z502;
    const double z504 = z12 * (r_F * z488) - 0.5 * (z52 * z489);
    const double z505 = c_lam * z500 - s_lam * z501;
    const double z506 = s_lam * z505;
    const double z507 = z410 * z396 - c_steer * z502;
    const double z508 = c_lam * z505;
    const double z509 = z402 * z504 - z53 * (z506 + c_lam * z507) - (z404 * z499 + z51 * (s_lam * z507 -
        z508));
    const double z510 = z407 * z408;
    const double z511 = roll_dot * z412;
    const double z512 = steer_dot * z410;
    const double z513 = z510 - s_steer * z511 + (z510 - e2z * z512);
    const double z514 = z410 * z483;
    const double z515 = steer_dot * z408;
    const double z516 = z514 - z4 * z515;
    const double z517 = z412 * z434;
    const double z518 = roll_dot * z407;
    const double z519 = z517 - c_pitch * z518;
    const double z520 = z412 * z436;
    const double z521 = z520 + s_pitch * z518;
    const double z522 = z513 - (z516 + (z410 * z415 + c_steer * (s_lam * z519 - c_lam * z521)));
    const double z523 = c_lam * z519 + s_lam * z521;
    const double z524 = z35 * (2.0 * (z2 * z476) + 2.0 * (e3z * z473)) / z34;
    const double z525 = z35 * (r_R * z473) - 0.5 * (z39 * z524);
    const double z526 = z35 * (r_R * z476) - 0.5 * (z33 * z524);
    const double z527 = R3 * z501 + z395 * z525 - (z36 * z500 - z394 * z526);
    const double z528 = z407 * z418 - e2z * z527;
    const double z529 = r_F * (s_lam * z522 - c_lam * z523) - (c * (s_lam * z523 + c_lam * z522) - (r_R *
        z519 + (z528 + k2 * z521)));
    const double z530 = z405 * (z471 + (z4 * z408 - s_steer * z483)) - h2z * z509 - (z406 * z487 + z9 * (z397
        * z504 - z53 * z503) - z529);
    const double z531 = z420 * z498 - z95 * (z398 * z488 + z10 * (z397 * z499 - z51 * z503) + z530);
    const double z532 = s_yaw * z467;
    const double z533 = z431 - c_roll * z532;
    const double z534 = c_yaw * z467;
    const double z535 = z433 + e2z * z532;
    const double z536 = z437 - s_pitch * z534 + (z435 - c_pitch * z535);
    const double z537 = z440 + c_pitch * z534 - (z439 + s_pitch * z535);
    const double z538 = z36 * z536 - e3y * z526 - (R3 * z537 + e1y * z525);
    const double z539 = z37 * z473 + e3z * (z36 * z533 + e2y * z526) + (z407 * z40 + e2z * z538) - (z41 *
        z476 + z2 * (R3 * z533 + e2y * z525));
    const double z540 = z410 * k7;
    const double z541 = s_lam * z540;
    const double z542 = c_lam * z540;
    const double z543 = z43 * z436 + s_pitch * z541 - (z44 * z434 + c_pitch * z542);
    const double z544 = z412 * z46 - c_roll * (z408 * k7) + (z407 * z47 - e2z * (z43 * z434 - c_pitch * z541
        + (z44 * z436 - s_pitch * z542)));
    const double z545 = s_lam * z537 - c_lam * z536;
    const double z546 = c_lam * z537 + s_lam * z536;
    const double z547 = z432 + c_steer * z546 - (z430 - s_steer * z533);
    const double z548 = c_lam * z545 - s_lam * z547;
    const double z549 = c_lam * z547 + s_lam * z545;
    const double z550 = z51 * z548 + h3y * z499 - (z53 * z549 + h1y * z504);
    const double z551 = c_steer * z533 + e2y * z410 + (z49 * z408 - s_steer * z546);
    const double z552 = z51 * z551 + h2y * z499;
    const double z553 = z53 * z551 + h2y * z504;
    const double z554 = s_lam * z552 + c_lam * z553;
    const double z555 = z408 * z54 - s_steer * z550 + (z410 * z59 + c_steer * z554);
    const double z556 = c_lam * z552 - s_lam * z553;
    const double z557 = z45 * z532 + c_yaw * z543 + (z48 * z534 + s_yaw * z544) - (z62 * z473 - e3z * (s_lam
        * z555 + c_lam * z556));
    const double z558 = z557 + (z407 * z63 - e2z * (z410 * z54 + c_steer * z550 - (z408 * z59 - s_steer *
        z554)));
    const double z559 = z558 - (z64 * z476 - z2 * (c_lam * z555 - s_lam * z556));
    const double z560 = (z539 - z559) / (z66 * z66);
    const double z561 = z503 - (z410 * z421 - c_steer * z531);
    const double z562 = z422 * z499 - z51 * z561;
    const double z563 = z507 + (z408 * z421 + s_steer * z531);
    const double z564 = z426 * z504 - z53 * (z506 + c_lam * z563) - (z427 * z499 - z51 * (z508 - s_lam *
        z563));
    const double z565 = z422 * z504 - z53 * z561;
    const double z566 = z408 * z533;
    const double z567 = z566 + e2y * z512;
    const double z568 = z412 * z532;
    const double z569 = z568 + c_yaw * z518;
    const double z570 = z410 * z546;
    const double z571 = z570 - z49 * z515;
    const double z572 = z407 * z532;
    const double z573 = z572 - c_yaw * z511;
    const double z574 = z434 * z535;
    const double z575 = z421 * z436 + s_pitch * z531;
    const double z576 = z574 + z38 * z575;
    const double z577 = z436 * z534;
    const double z578 = z421 * z434 - c_pitch * z531;
    const double z579 = z577 + s_yaw * z578;
    const double z580 = z433 * z434 - c_pitch * z573 + z576 - z579;
    const double z581 = z436 * z535;
    const double z582 = z581 - z38 * z578;
    const double z583 = z434 * z534;
    const double z584 = z583 - s_yaw * z575;
    const double z585 = z433 * z436 + s_pitch * z573 + z582 + z584;
    const double z586 = z567 + (z408 * z431 + s_steer * z569) - (z571 - (z410 * z442 + c_steer * (s_lam *
        z580 - c_lam * z585)));
    const double z587 = c_lam * z580 + s_lam * z585;
    const double z588 = r_F * (s_lam * z586 + c_lam * z587) + (c * (s_lam * z587 - c_lam * z586) - (r_R *
        z580 + k2 * z585));
    const double z589 = z423 * z548 + h3y * z562 + (z428 * z551 + h2y * z564 - (z429 * z549 + h1y * z565 -
        z588));
    const double z590 = z421 * z526 - z36 * z531;
    const double z591 = z421 * z525 - R3 * z531;
    const double z592 = z446 * z536 - e3y * z590 + (z418 * z533 + e2y * z527 - (z447 * z537 + e1y * z591));
    const double z593 = z448 * z560 - z91 * (z589 + z592);
    const double z594 = z91 * z538 + z40 * z560;
    const double z595 = z453 - e2z * z534;
    const double z596 = z455 + s_pitch * z532 - (z454 - c_pitch * z595);
    const double z597 = z458 - c_pitch * z532 + (z457 + s_pitch * z595);
    const double z598 = z36 * z596 - e3x * z526 - (R3 * z597 + e1x * z525);
    const double z599 = z451 + c_roll * z534;
    const double z600 = z74 * z473 + e3z * (z36 * z599 + z73 * z526) - (z407 * z72 + e2z * z598) - (z75 *
        z476 + z2 * (R3 * z599 + z73 * z525));
    const double z601 = s_lam * z597 - c_lam * z596;
    const double z602 = c_lam * z597 + s_lam * z596;
    const double z603 = z452 + c_steer * z602 + (z450 - s_steer * z599);
    const double z604 = c_lam * z601 - s_lam * z603;
    const double z605 = c_lam * z603 + s_lam * z601;
    const double z606 = z51 * z604 + h3x * z499 - (z53 * z605 + h1x * z504);
    const double z607 = c_steer * z599 + z73 * z410 + (s_steer * z602 - z76 * z408);
    const double z608 = z51 * z607 + z80 * z499;
    const double z609 = z53 * z607 + z80 * z504;
    const double z610 = s_lam * z608 + c_lam * z609;
    const double z611 = z408 * z77 - s_steer * z606 - (z410 * z83 + c_steer * z610);
    const double z612 = c_lam * z608 - s_lam * z609;
    const double z613 = z48 * z532 - c_yaw * z544 - (z45 * z534 - s_yaw * z543) + (z86 * z473 - e3z * (s_lam
        * z611 - c_lam * z612));
    const double z614 = z613 - (z407 * z87 - e2z * (z410 * z77 + c_steer * z606 + (z408 * z83 - s_steer *
        z610)));
    const double z615 = z614 + (z88 * z476 - z2 * (c_lam * z611 + s_lam * z612));
    const double z616 = z600 - z615;
    const double z617 = z408 * z599;
    const double z618 = z617 + z73 * z512;
    const double z619 = z412 * z534;
    const double z620 = z619 - s_yaw * z518;
    const double z621 = z410 * z602;
    const double z622 = z621 - z76 * z515;
    const double z623 = z407 * z534;
    const double z624 = z623 + s_yaw * z511;
    const double z625 = z434 * z595;
    const double z626 = z625 + z71 * z575;
    const double z627 = z436 * z532;
    const double z628 = z627 - c_yaw * z578;
    const double z629 = z453 * z434 + c_pitch * z624 + z626 - z628;
    const double z630 = z436 * z595;
    const double z631 = z630 - z71 * z578;
    const double z632 = z434 * z532;
    const double z633 = z632 + c_yaw * z575;
    const double z634 = z453 * z436 - s_pitch * z624 + z631 + z633;
    const double z635 = z618 + (z451 * z408 - s_steer * z620) + (z622 + (z410 * z460 + c_steer * (s_lam *
        z629 - c_lam * z634)));
    const double z636 = c_lam * z629 + s_lam * z634;
    const double z637 = r_F * (s_lam * z635 + c_lam * z636) + (c * (s_lam * z636 - c_lam * z635) - (r_R *
        z629 + k2 * z634));
    const double z638 = z423 * z604 + h3x * z562 - (z428 * z607 + z80 * z564 + (z429 * z605 + h1x * z565 +
        z637));
    const double z639 = z446 * z596 - e3x * z590 - (z418 * z599 + z73 * z527 + (z447 * z597 + e1x * z591));
    const double z640 = z465 * ((z598 - (z92 * z616 - z90 * z594)) / (z93 * z93)) + z142 * (z638 + z639 +
        (z449 * z616 - z90 * z593));
    const double z641 = z593 - (z466 * z594 - z92 * z640);
    const double z642 = z531 - (z407 * z467 + e2z * z641);
    const double z643 = z501 + (z467 * z476 - z2 * z641);
    const double z644 = z500 + (z467 * z473 - e3z * z641);
    const double z645 = c_lam * z643 + s_lam * z644;
    const double z646 = z410 * w2 - c_steer * z642 + (z408 * z468 - s_steer * z645);
    const double z647 = F_yy * z646;
    const double z648 = e2z * z470;
    const double z649 = z2 * z470;
    const double z650 = e3z * z470;
    const double z651 = c_lam * z649 + s_lam * z650;
    const double z652 = c_steer * z648 + s_steer * z651;
    const double z653 = z647 * z652;
    const double z654 = z589 + (z449 * z559 + z65 * z593) - (z466 * (z92 * z559 + z65 * z594) - z146 * z640);
    const double z655 = z467 * z532 + c_yaw * z641;
    const double z656 = z467 * z534 - s_yaw * z641;
    const double z657 = z573 + (z572 - e2z * z656);
    const double z658 = z584 + (z583 - c_pitch * z655) + (z582 + (z581 + s_pitch * z657));
    const double z659 = z579 + (z577 + s_pitch * z655) - (z576 + (z574 - c_pitch * z657));
    const double z660 = z654 + k2 * z658 - r_R * z659;
    const double z661 = z571 + (z570 + c_steer * (c_lam * z658 + s_lam * z659)) - (z567 + (z566 + s_steer *
        (z569 + (z568 + c_roll * z656))));
    const double z662 = s_lam * z658 - c_lam * z659;
    const double z663 = c_lam * z661 + s_lam * z662;
    const double z664 = c_lam * z662 - s_lam * z661;
    const double z665 = m_F * (z660 - c * z663 - r_F * z664);
    const double z666 = z146 * z142;
    const double z667 = c_yaw * z470;
    const double z668 = s_yaw * z470;
    const double z669 = e2z * z668;
    const double z670 = c_pitch * z667 - s_pitch * z669;
    const double z671 = s_pitch * z667 + c_pitch * z669;
    const double z672 = z666 - k2 * z670 - r_R * z671;
    const double z673 = c_steer * (c_lam * z670 - s_lam * z671) - s_steer * (c_roll * z668);
    const double z674 = s_lam * z670 + c_lam * z671;
    const double z675 = c_lam * z673 + s_lam * z674;
    const double z676 = c_lam * z674 - s_lam * z673;
    const double z677 = z672 + c * z675 + r_F * z676;
    const double z678 = z665 * z677;
    const double z679 = z638 - (z449 * z615 + z89 * z593) + (z466 * (z92 * z615 + z89 * z594) - z141 * z640);
    const double z680 = z624 + (z623 + e2z * z655);
    const double z681 = z633 + (z632 + c_pitch * z656) + (z631 + (z630 - s_pitch * z680));
    const double z682 = z628 + (z627 - s_pitch * z656) - (z626 + (z625 + c_pitch * z680));
    const double z683 = z679 - k2 * z681 + r_R * z682;
    const double z684 = z622 + (z621 - c_steer * (c_lam * z681 + s_lam * z682)) + (z618 + (z617 - s_steer *
        (z620 + (z619 - c_roll * z655))));
    const double z685 = s_lam * z681 - c_lam * z682;
    const double z686 = c_lam * z684 - s_lam * z685;
    const double z687 = c_lam * z685 + s_lam * z684;
    const double z688 = m_F * (z683 - c * z686 + r_F * z687);
    const double z689 = z141 * z142;
    const double z690 = e2z * z667;
    const double z691 = c_pitch * z668 + s_pitch * z690;
    const double z692 = k2 * z691;
    const double z693 = s_pitch * z668 - c_pitch * z690;
    const double z694 = r_R * z693;
    const double z695 = z689 - z692 - z694;
    const double z696 = c_steer * (c_lam * z691 - s_lam * z693) + s_steer * (c_roll * z667);
    const double z697 = s_lam * z691 + c_lam * z693;
    const double z698 = c_lam * z696 + s_lam * z697;
    const double z699 = c * z698;
    const double z700 = c_lam * z697 - s_lam * z696;
    const double z701 = r_F * z700;
    const double z702 = z695 + z699 + z701;
    const double z703 = m_H * (z660 - k3 * z663 + z_H * z664);
    const double z704 = z672 + k3 * z675 - z_H * z676;
    const double z705 = z703 * z704;
    const double z706 = m_H * (z683 - k3 * z686 - z_H * z687);
    const double z707 = k3 * z698;
    const double z708 = z_H * z700;
    const double z709 = z695 + z707 - z708;
    const double z710 = m_B * (z654 + x_B * z658 - k1 * z659);
    const double z711 = z666 - x_B * z670 - k1 * z671;
    const double z712 = z710 * z711;
    const double z713 = m_B * (z679 - x_B * z681 + k1 * z682);
    const double z714 = x_B * z691;
    const double z715 = k1 * z693;
    const double z716 = z689 - z714 - z715;
    const double z717 = R_yy * (z466 + w2);
    const double z718 = z407 * z470;
    const double z719 = z717 * z718;
    const double z720 = R_yy * (z640 - z642);
    const double z721 = z142 + z648;
    const double z722 = z720 * z721;
    const double wf = c_steer * z468 + s_steer * w2;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double o1 = c_lam * wf + s_lam * ws;
    const double o3 = c_lam * ws - s_lam * wf;
    const double z723 = H_xz * o1 + 2.0 * (k20 * o3);
    const double z724 = s_lam * c_steer;
    const double z725 = s_lam * z724 + k19;
    const double z726 = s_lam * z481;
    const double z727 = c_lam * (s_lam - z724);
    const double z728 = c_lam * z481;
    const double z729 = z725 * z473 + e3z * z726 + (z407 * z472 + e2z * z474) - (z727 * z476 - z2 * z728);
    const double z730 = z723 * (z470 * z729);
    const double z731 = z410 * z468 + c_steer * z645 - (z408 * w2 + s_steer * z642);
    const double z732 = s_lam * z643 - c_lam * z644;
    const double z733 = c_lam * z731 + s_lam * z732;
    const double z734 = c_lam * z732 - s_lam * z731;
    const double z735 = H_xz * z733 + 2.0 * (k20 * z734);
    const double z736 = s_lam * z649 - c_lam * z650;
    const double z737 = c_steer * z651 - s_steer * z648;
    const double z738 = c_lam * z736 - s_lam * z737;
    const double z739 = z735 * z738;
    const double z740 = H_yy * o2;
    const double z741 = z740 * z479;
    const double z742 = H_yy * z646;
    const double z743 = z742 * z652;
    const double z744 = H_xz * o3 + 2.0 * (k21 * o1);
    const double z745 = c_lam * c_steer;
    const double z746 = s_lam * (c_lam - z745);
    const double z747 = s_lam * z491;
    const double z748 = c_lam * z745 + k18;
    const double z749 = c_lam * z491;
    const double z750 = z746 * z473 - e3z * z747 - (z407 * z475 + e2z * z477) - (z748 * z476 + z2 * z749);
    const double z751 = z744 * (z470 * z750);
    const double z752 = 2.0 * (k21 * z733) + H_xz * z734;
    const double z753 = c_lam * z737 + s_lam * z736;
    const double z754 = z752 * z753;
    const double z755 = B_xz * w1 + 2.0 * (k23 * w3);
    const double z756 = z755 * (z470 * z473);
    const double z757 = B_xz * z643 - 2.0 * (k23 * z644);
    const double z758 = z757 * z650;
    const double z759 = B_yy * w2;
    const double z760 = z759 * z718;
    const double z761 = B_yy * z642;
    const double z762 = z761 * z648;
    const double z763 = B_xz * w3 + 2.0 * (k22 * w1);
    const double z764 = z763 * (z470 * z476);
    const double z765 = 2.0 * (k22 * z643) - B_xz * z644;
    const double z766 = z765 * z649;
    const double z767 = m_R * z679;
    const double z768 = m_R * z654;
    const double z769 = z666 * z768;
    const double z770 = z743 + (z751 - (z754 - (z756 + (z758 - (z760 + (z762 + (z764 + (z766 + (z689 * z767 -
        z769)))))))));
    const double z771 = z705 - (z706 * z709 - (z712 - (z713 * z716 + (z719 - (z722 + (z730 - (z739 + (z741 -
        z770))))))));
    const double z772 = z666 * z330;
    const double z773 = z334 * z649;
    const double z774 = z336 * z648;
    const double z775 = z337 * z650;
    const double z776 = z343 * z753;
    const double z777 = z346 * z652;
    const double z778 = z347 * z738;
    const double z779 = z349 * z721;
    const double z780 = z689 * z328 - z772 + z773 + z774 - z775 + z776 + z777 + z778 - z779 + z356 * z716;
    const double z781 = z361 * z711;
    const double z782 = z376 * z704;
    const double z783 = z380 * z677;
    const double z784 = z382 * z652;
    const double z785 = z331 * z478;
    const double z786 = z407 * z331;
    const double z787 = z759 * z786 + (z335 * z761 + (z763 * (z331 * z476) + (z332 * z765 + (z327 * z767 +
        z329 * z768))));
    const double z788 = z345 * z742 + (z744 * (z331 * z750) - (z341 * z752 - (z755 * (z331 * z473) + (z333 *
        z757 - z787))));
    const double z789 = z717 * z786 + (z348 * z720 - (z723 * (z331 * z729) - (z342 * z735 + (z740 * z785 -
        z788))));
    const double z790 = z379 * z665 + (z377 * z688 + (z375 * z703 + (z367 * z706 + (z360 * z710 + (z355 *
        z713 + z789)))));
    const double z791 = z410 * z110 + (z436 * z472 + s_pitch * z474 + (z434 * z475 - c_pitch * z477) + z150 *
        z478);
    const double z792 = z467 * (c_roll * c_steer - z472 * z183 - z475 * z182) + roll_dot * (z118 * z472 +
        z116 * z475);
    const double z793 = z791 + z792;
    const double z794 = z521 + (z520 + c_roll * z578);
    const double z795 = z519 + (z517 - c_roll * z575);
    const double z796 = z528 + k2 * z794 + r_R * z795;
    const double z797 = z513 - (z516 + (z514 - c_steer * (c_lam * z794 - s_lam * z795)));
    const double z798 = s_lam * z794 + c_lam * z795;
    const double z799 = c_lam * z797 + s_lam * z798;
    const double z800 = c_lam * z798 - s_lam * z797;
    const double z801 = m_F * (z796 - c * z799 - r_F * z800);
    const double z802 = m_H * (z796 - k3 * z799 + z_H * z800);
    const double z803 = m_B * (z528 + x_B * z794 + k1 * z795);
    const double z804 = z407 * z150 + c_roll * z467;
    const double z805 = z110 * z474 + (z436 * z725 - s_pitch * z726 - (z434 * z727 - c_pitch * z728) - z150 *
        z729);
    const double z806 = z467 * (z725 * z183 + c_roll * z472 - z727 * z182) - roll_dot * (z118 * z725 - z116 *
        z727);
    const double z807 = z110 * z477 - (z436 * z746 + s_pitch * z747 - (z434 * z748 + c_pitch * z749) - z150 *
        z750);
    const double z808 = z467 * (z746 * z183 - c_roll * z475 - z748 * z182) - roll_dot * (z118 * z746 - z116 *
        z748);
    const double z809 = m_R * z528;
    const double z810 = z763 * (z434 - z150 * z476 - (z467 * z182 - roll_dot * z116)) + (z151 * z765 - (z107
        * z809 + (z144 * z767 + z147 * z768)));
    const double z811 = z755 * (z436 - z150 * z473 - (z467 * z183 - roll_dot * z118)) - (z152 * z757 - (z759
        * z804 - (z154 * z761 + z810)));
    const double z812 = z162 * z735 - (z740 * z793 + (z164 * z742 - (z744 * (z807 + z808) + (z161 * z752 -
        z811))));
    const double z813 = z179 * z710 + (z174 * z713 + (z717 * z804 + (z167 * z720 + (z723 * (z805 - z806) -
        z812))));
    const double z814 = z209 * z665 + (z207 * z688 + (z205 * z802 + (z198 * z703 + (z191 * z706 + (z184 *
        z803 + z813)))));
    const double z815 = z469 * z793 + (z164 * z647 + (z212 * z801 + z814)) - g * (z213 + (z206 + (z149 +
        z185)));
    const double z816 = z467 * (z5 - (z472 * z284 + e3z * z724) + (z475 * z283 - z2 * z745)) - roll_dot *
        (z224 * z472 - s_pitch * z724 + (z222 * z475 + c_pitch * z745));
    const double z817 = z252 * z478 + z410 * z216 + (z424 - z816);
    const double z818 = z407 * z252;
    const double z819 = s_lam * z472;
    const double z820 = c_lam * z472;
    const double z821 = z467 * (z725 * z284 - e3z * z819 - e2z * z724 + (z727 * z283 - z2 * z820)) + roll_dot
        * (z224 * z725 + s_pitch * z819 - (z222 * z727 + c_pitch * z820));
    const double z822 = s_lam * z475;
    const double z823 = c_lam * z475;
    const double z824 = z467 * (z746 * z284 + e3z * z822 + e2z * z745 + (z748 * z283 + z2 * z823)) + roll_dot
        * (z224 * z746 - s_pitch * z822 - (z222 * z748 - c_pitch * z823));
    const double z825 = z763 * (z252 * z476 + (z467 * z283 - roll_dot * z222)) + (z253 * z765 + (z248 * z767
        + z250 * z768));
    const double z826 = z755 * (z252 * z473 - (z467 * z284 + roll_dot * z224)) + (z254 * z757 - (z759 * z818
        - (z256 * z761 - z825)));
    const double z827 = z266 * z742 - (z744 * (z252 * z750 + z216 * z477 + (z421 * z745 - z824)) - (z262 *
        z752 - z826));
    const double z828 = z723 * (z252 * z729 - z216 * z474 - (z421 * z724 + z821)) + (z263 * z735 - (z740 *
        z817 + z827));
    const double z829 = z293 * z706 + (z285 * z803 + (z281 * z710 + (z276 * z713 + (z717 * z818 + (z269 *
        z720 - z828)))));
    const double z830 = z266 * z647 + (z313 * z801 + (z311 * z665 + (z309 * z688 + (z307 * z802 + (z300 *
        z703 + z829)))));
    const double z831 = z469 * z817 + z830 - g * (z314 + (z286 + z308)) - z815 * z323;
    const double z832 = (z469 * z785 + (z381 * z647 + z790) - z815 * z387 - z392 * z831) / z393;
    const double z833 = z666 * z148;
    const double z834 = z153 * z649;
    const double z835 = z155 * z648;
    const double z836 = z156 * z650;
    const double z837 = z163 * z753;
    const double z838 = z165 * z652;
    const double z839 = z166 * z738;
    const double z840 = z168 * z721;
    const double z841 = z689 * z145 - z833 - z834 - z835 + z836 - z837 - z838 - z839 - z840 + z175 * z716;
    const double z842 = z180 * z711;
    const double z843 = z199 * z704;
    const double z844 = z210 * z677;
    const double z845 = z214 * z652;
    const double z846 = z391 * z831 - z392 * z832;
    const double z847 = z815 * z322 - z323 * z846 - z387 * z832;
    const double z848 = z666 * z251;
    const double z849 = z255 * z649;
    const double z850 = z257 * z648;
    const double z851 = z258 * z650;
    const double z852 = z264 * z753;
    const double z853 = z267 * z652;
    const double z854 = z268 * z738;
    const double z855 = z270 * z721;
    const double z856 = z689 * z249 - z848 + z849 - z850 - z851 + z852 - z853 + z854 - z855 + z277 * z716;
    const double z857 = z282 * z711;
    const double z858 = z301 * z704;
    const double z859 = z312 * z677;
    const double z860 = z316 * z652;
    const double z861 = (z841 - z842 + z192 * z709 - z843 + z208 * z702 - z844 - z845) * z847 + (z856 - z857
        + z294 * z709 - z858 + z310 * z702 - z859 - z860) * z846;
    const double z862 = z480 - (z653 + (z678 - (z688 * z702 - z771))) - ((z780 - z781 + z368 * z709 - z782 +
        z378 * z702 - z783 - z784) * z832 + z861);
    /* (I.4.1) 115:5 */
    lambda[0] = z862; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    const double z863 = z142 * (z90 * z91);
    const double z864 = z91 - z92 * z863;
    const double z865 = z864 * z478;
    const double z866 = z469 * z865;
    const double z867 = e2z * z864;
    const double z868 = z2 * z864;
    const double z869 = e3z * z864;
    const double z870 = c_lam * z868 + s_lam * z869;
    const double z871 = c_steer * z867 + s_steer * z870;
    const double z872 = z647 * z871;
    const double z873 = z65 * z91;
    const double z874 = z146 * z863;
    const double z875 = z873 - z874;
    const double z876 = c_yaw * z864;
    const double z877 = s_yaw * z864;
    const double z878 = e2z * z877;
    const double z879 = c_pitch * z876 - s_pitch * z878;
    const double z880 = k2 * z879;
    const double z881 = s_pitch * z876 + c_pitch * z878;
    const double z882 = r_R * z881;
    const double z883 = z875 - z880 - z882;
    const double z884 = c_steer * (c_lam * z879 - s_lam * z881) - s_steer * (c_roll * z877);
    const double z885 = s_lam * z879 + c_lam * z881;
    const double z886 = c_lam * z884 + s_lam * z885;
    const double z887 = c * z886;
    const double z888 = c_lam * z885 - s_lam * z884;
    const double z889 = r_F * z888;
    const double z890 = z883 + z887 + z889;
    const double z891 = z89 * z91 - z141 * z863;
    const double z892 = e2z * z876;
    const double z893 = c_pitch * z877 + s_pitch * z892;
    const double z894 = s_pitch * z877 - c_pitch * z892;
    const double z895 = z891 - k2 * z893 - r_R * z894;
    const double z896 = c_steer * (c_lam * z893 - s_lam * z894) + s_steer * (c_roll * z876);
    const double z897 = s_lam * z893 + c_lam * z894;
    const double z898 = c_lam * z896 + s_lam * z897;
    const double z899 = c_lam * z897 - s_lam * z896;
    const double z900 = z895 + c * z898 + r_F * z899;
    const double z901 = z688 * z900;
    const double z902 = k3 * z886;
    const double z903 = z_H * z888;
    const double z904 = z883 + z902 - z903;
    const double z905 = z895 + k3 * z898 - z_H * z899;
    const double z906 = z706 * z905;
    const double z907 = x_B * z879;
    const double z908 = k1 * z881;
    const double z909 = z875 - z907 - z908;
    const double z910 = z891 - x_B * z893 - k1 * z894;
    const double z911 = z713 * z910;
    const double z912 = z407 * z864;
    const double z913 = z717 * z912;
    const double z914 = z863 - z867;
    const double z915 = z720 * z914;
    const double z916 = z723 * (z864 * z729);
    const double z917 = s_lam * z868 - c_lam * z869;
    const double z918 = c_steer * z870 - s_steer * z867;
    const double z919 = c_lam * z917 - s_lam * z918;
    const double z920 = z735 * z919;
    const double z921 = z740 * z865;
    const double z922 = z742 * z871;
    const double z923 = z744 * (z864 * z750);
    const double z924 = c_lam * z918 + s_lam * z917;
    const double z925 = z752 * z924;
    const double z926 = z755 * (z864 * z473);
    const double z927 = z757 * z869;
    const double z928 = z759 * z912;
    const double z929 = z761 * z867;
    const double z930 = z763 * (z864 * z476);
    const double z931 = z765 * z868;
    const double z932 = z891 * z767;
    const double z933 = z922 + (z923 - (z925 - (z926 + (z927 - (z928 + (z929 + (z930 + (z931 + (z932 - z875 *
        z768)))))))));
    const double z934 = z703 * z904 - (z906 - (z710 * z909 - (z911 + (z913 + (z915 - (z916 - (z920 + (z921 -
        z933))))))));
    const double z935 = z891 * z328;
    const double z936 = z334 * z868;
    const double z937 = z336 * z867;
    const double z938 = z337 * z869;
    const double z939 = z343 * z924;
    const double z940 = z346 * z871;
    const double z941 = z347 * z919;
    const double z942 = z349 * z914;
    const double z943 = z356 * z910;
    const double z944 = z935 - z875 * z330 + z936 + z937 - z938 + z939 + z940 + z941 + z942 + z943 - z361 *
        z909;
    const double z945 = z368 * z905;
    const double z946 = z378 * z900;
    const double z947 = z382 * z871;
    const double z948 = z891 * z145;
    const double z949 = z153 * z868;
    const double z950 = z155 * z867;
    const double z951 = z156 * z869;
    const double z952 = z163 * z924;
    const double z953 = z165 * z871;
    const double z954 = z166 * z919;
    const double z955 = z168 * z914;
    const double z956 = z175 * z910;
    const double z957 = z948 - z875 * z148 - z949 - z950 + z951 - z952 - z953 - z954 + z955 + z956 - z180 *
        z909;
    const double z958 = z192 * z905;
    const double z959 = z208 * z900;
    const double z960 = z214 * z871;
    const double z961 = z891 * z249;
    const double z962 = z255 * z868;
    const double z963 = z257 * z867;
    const double z964 = z258 * z869;
    const double z965 = z264 * z924;
    const double z966 = z267 * z871;
    const double z967 = z268 * z919;
    const double z968 = z270 * z914;
    const double z969 = z277 * z910;
    const double z970 = z961 - z875 * z251 + z962 - z963 - z964 + z965 - z966 + z967 + z968 + z969 - z282 *
        z909;
    const double z971 = z294 * z905;
    const double z972 = z310 * z900;
    const double z973 = z316 * z871;
    const double z974 = (z957 + z958 - z199 * z904 + z959 - z210 * z890 - z960) * z847 + (z970 + z971 - z301
        * z904 + z972 - z312 * z890 - z973) * z846;
    const double z975 = z866 - (z872 + (z665 * z890 - (z901 - z934))) - ((z944 + z945 - z376 * z904 + z946 -
        z380 * z890 - z947) * z832 + z974);
    /* (I.4.1) 116:5 */
    lambda[1] = -z975; /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    const double z976 = c_steer * z95;
    const double z977 = z51 * z976;
    const double z978 = s_steer * z95;
    const double z979 = z53 * (c_lam * z978) + z51 * (s_lam * z978);
    const double z980 = z53 * z976;
    const double z981 = s_pitch * z95;
    const double z982 = z38 * z981;
    const double z983 = c_pitch * z95;
    const double z984 = s_yaw * z983;
    const double z985 = z982 + z984;
    const double z986 = z38 * z983;
    const double z987 = s_yaw * z981;
    const double z988 = z986 - z987;
    const double z989 = c_steer * (s_lam * z985 - c_lam * z988);
    const double z990 = c_lam * z985 + s_lam * z988;
    const double z991 = r_F * (s_lam * z989 + c_lam * z990) + (c * (s_lam * z990 - c_lam * z989) - (r_R *
        z985 + k2 * z988));
    const double z992 = h3y * z977 + (h2y * z979 - (h1y * z980 + z991));
    const double z993 = z36 * z95;
    const double z994 = R3 * z95;
    const double z995 = z91 * (z992 - (e3y * z993 + e1y * z994));
    const double z996 = z71 * z981;
    const double z997 = c_yaw * z983;
    const double z998 = z996 - z997;
    const double z999 = z71 * z983;
    const double z1000 = c_yaw * z981;
    const double z1001 = z999 + z1000;
    const double z1002 = c_steer * (s_lam * z998 - c_lam * z1001);
    const double z1003 = c_lam * z998 + s_lam * z1001;
    const double z1004 = r_F * (s_lam * z1002 + c_lam * z1003) + (c * (s_lam * z1003 - c_lam * z1002) - (r_R
        * z998 + k2 * z1001));
    const double z1005 = h3x * z977 - (z80 * z979 + (h1x * z980 - z1004));
    const double z1006 = z142 * (z1005 - (e3x * z993 + e1x * z994) + z90 * z995);
    const double z1007 = z995 - z92 * z1006;
    const double z1008 = c_roll * z981;
    const double z1009 = c_roll * z983;
    const double z1010 = z1007 * z478 + z410 * z95 + (z467 * (z472 * z1008 - z475 * z1009) + roll_dot * (z983
        * z472 + z981 * z475));
    const double z1011 = z469 * z1010;
    const double z1012 = z95 - e2z * z1007;
    const double z1013 = z2 * z1007;
    const double z1014 = e3z * z1007;
    const double z1015 = c_lam * z1013 + s_lam * z1014;
    const double z1016 = c_steer * z1012 - s_steer * z1015;
    const double z1017 = z647 * z1016;
    const double z1018 = k2 * z1009;
    const double z1019 = r_R * z1008;
    const double z1020 = 1.0 + z1018 + z1019;
    const double z1021 = c_steer * (c_lam * z1009 - s_lam * z1008);
    const double z1022 = s_lam * z1009 + c_lam * z1008;
    const double z1023 = c_lam * z1021 + s_lam * z1022;
    const double z1024 = c * z1023;
    const double z1025 = c_lam * z1022 - s_lam * z1021;
    const double z1026 = r_F * z1025;
    const double z1027 = z1020 - z1024 - z1026;
    const double z1028 = z992 - z65 * z995 + z146 * z1006;
    const double z1029 = c_yaw * z1007;
    const double z1030 = s_yaw * z1007;
    const double z1031 = e2z * z1030;
    const double z1032 = z987 + c_pitch * z1029 - (z986 + s_pitch * z1031);
    const double z1033 = z984 - s_pitch * z1029 + (z982 - c_pitch * z1031);
    const double z1034 = z1028 + k2 * z1032 - r_R * z1033;
    const double z1035 = c_steer * (c_lam * z1032 + s_lam * z1033) - s_steer * (c_roll * z1030);
    const double z1036 = s_lam * z1032 - c_lam * z1033;
    const double z1037 = c_lam * z1035 + s_lam * z1036;
    const double z1038 = c_lam * z1036 - s_lam * z1035;
    const double z1039 = z1034 - c * z1037 - r_F * z1038;
    const double z1040 = z665 * z1039;
    const double z1041 = z1005 + z89 * z995 - z141 * z1006;
    const double z1042 = e2z * z1029;
    const double z1043 = z1000 - c_pitch * z1030 + (z999 - s_pitch * z1042);
    const double z1044 = z997 + s_pitch * z1030 - (z996 + c_pitch * z1042);
    const double z1045 = z1041 + k2 * z1043 - r_R * z1044;
    const double z1046 = c_steer * (c_lam * z1043 + s_lam * z1044) - s_steer * (c_roll * z1029);
    const double z1047 = s_lam * z1043 - c_lam * z1044;
    const double z1048 = c_lam * z1046 + s_lam * z1047;
    const double z1049 = c_lam * z1047 - s_lam * z1046;
    const double z1050 = z1045 - c * z1048 - r_F * z1049;
    const double z1051 = z688 * z1050;
    const double z1052 = k3 * z1023;
    const double z1053 = z_H * z1025;
    const double z1054 = z1020 - z1052 + z1053;
    const double z1055 = z1034 - k3 * z1037 + z_H * z1038;
    const double z1056 = z703 * z1055;
    const double z1057 = z1045 - k3 * z1048 + z_H * z1049;
    const double z1058 = z706 * z1057;
    const double z1059 = x_B * z1009;
    const double z1060 = k1 * z1008;
    const double z1061 = 1.0 + z1059 + z1060;
    const double z1062 = z1028 + x_B * z1032 - k1 * z1033;
    const double z1063 = z710 * z1062;
    const double z1064 = z1041 + x_B * z1043 - k1 * z1044;
    const double z1065 = z713 * z1064;
    const double z1066 = z407 * z1007;
    const double z1067 = z717 * z1066;
    const double z1068 = z1006 + z1012;
    const double z1069 = z720 * z1068;
    const double z1070 = z1007 * z729 - z95 * z474 - (z467 * (z725 * z1008 + z727 * z1009) + roll_dot * (z983
        * z725 - z981 * z727));
    const double z1071 = z723 * z1070;
    const double z1072 = s_lam * z1013 - c_lam * z1014;
    const double z1073 = c_steer * z1015 + s_steer * z1012;
    const double z1074 = c_lam * z1072 - s_lam * z1073;
    const double z1075 = z735 * z1074;
    const double z1076 = z740 * z1010;
    const double z1077 = z742 * z1016;
    const double z1078 = z1007 * z750 + z95 * z477 - (z467 * (z746 * z1008 + z748 * z1009) + roll_dot * (z983
        * z746 - z981 * z748));
    const double z1079 = z744 * z1078;
    const double z1080 = c_lam * z1073 + s_lam * z1072;
    const double z1081 = z752 * z1080;
    const double z1082 = z755 * (z1007 * z473 - (z467 * z1008 + roll_dot * z983));
    const double z1083 = z757 * z1014;
    const double z1084 = z759 * z1066;
    const double z1085 = z761 * z1012;
    const double z1086 = z763 * (z1007 * z476 + (z467 * z1009 - roll_dot * z981));
    const double z1087 = z765 * z1013;
    const double z1088 = z1041 * z767 + z1028 * z768;
    const double z1089 = z1076 + (z1077 - (z1079 - (z1081 - (z1082 + (z1083 - (z1084 - (z1085 - (z1086 +
        (z1087 + (z809 + z1088))))))))));
    const double z1090 = z802 * z1054 + (z1056 + (z1058 + (z803 * z1061 + (z1063 + (z1065 + (z1067 + (z1069 -
        (z1071 - (z1075 + z1089)))))))));
    const double z1091 = z1011 + (z1017 + (z801 * z1027 + (z1040 + (z1051 + z1090)))) - g * (m_R + m_B *
        z1061 + m_H * z1054 + m_F * z1027);
    const double z1092 = z1041 * z328 + z1028 * z330 + z334 * z1013 - z336 * z1012 - z337 * z1014 + z343 *
        z1080;
    const double z1093 = z1092 - z346 * z1016 + z347 * z1074 + z349 * z1068 + z356 * z1064 + z361 * z1062 +
        z368 * z1057;
    const double z1094 = (z1093 + z376 * z1055 + z378 * z1050 + z380 * z1039 + z382 * z1016) * z832;
    const double z1095 = z1041 * z145 + z1028 * z148;
    const double z1096 = z153 * z1013;
    const double z1097 = z155 * z1012;
    const double z1098 = z156 * z1014;
    const double z1099 = z163 * z1080;
    const double z1100 = z165 * z1016;
    const double z1101 = z166 * z1074;
    const double z1102 = z168 * z1068;
    const double z1103 = z175 * z1064;
    const double z1104 = z180 * z1062;
    const double z1105 = z149 + z1095 - z1096 + z1097 + z1098 - z1099 + z1100 - z1101 + z1102 + z1103 + z1104
        + z185 * z1061;
    const double z1106 = z192 * z1057;
    const double z1107 = z199 * z1055;
    const double z1108 = z208 * z1050;
    const double z1109 = z210 * z1039;
    const double z1110 = z214 * z1016;
    const double z1111 = z1041 * z249 + z1028 * z251 + z255 * z1013 + z257 * z1012 - z258 * z1014 + z264 *
        z1080;
    const double z1112 = z1111 + z267 * z1016 + z268 * z1074 + z270 * z1068 + z277 * z1064 + z282 * z1062;
    const double z1113 = z294 * z1057;
    const double z1114 = z301 * z1055;
    const double z1115 = z310 * z1050;
    const double z1116 = z312 * z1039;
    const double z1117 = z316 * z1016;
    const double z1118 = z1112 + z286 * z1061 + z1113 + z1114 + z308 * z1054 + z1115 + z1116 + z314 * z1027 +
        z1117;
    const double z1119 = (z1105 + z1106 + z1107 + z206 * z1054 + z1108 + z1109 + z213 * z1027 + z1110) * z847
        + z1118 * z846;
    /* (I.4.1) 117:5 */
    lambda[2] = z1091 - (z1094 + z1119); /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z1120 = 1.0 - z689;
    const double z1121 = z694 + (z1120 + z692);
    const double z1122 = z701 + (z699 - z1121);
    const double z1123 = z708 - (z707 - z1121);
    const double z1124 = z715 + (z1120 + z714);
    const double z1125 = z743 + (z751 - (z754 - (z756 + (z758 - (z760 + (z762 + (z764 + (z766 - (z769 + z1120
        * z767)))))))));
    const double z1126 = z705 + (z706 * z1123 + (z712 + (z713 * z1124 - (z719 - (z722 + (z730 - (z739 + (z741
        - z1125))))))));
    const double z1127 = z779 - (z778 + (z777 + (z776 - (z775 - (z774 + (z773 - (z772 + z1120 * z328))))))) +
        z356 * z1124;
    const double z1128 = z840 + (z839 + (z838 + (z837 - (z836 - (z835 + (z834 + (z833 + z1120 * z145))))))) +
        z175 * z1124;
    const double z1129 = z855 - (z854 - (z853 - (z852 - (z851 + (z850 - (z849 - (z848 + z1120 * z249))))))) +
        z277 * z1124;
    const double z1130 = (z845 + (z844 + (z843 + (z842 + z1128 + z192 * z1123) - z208 * z1122))) * z847 +
        (z860 + (z859 + (z858 + (z857 + z1129 + z294 * z1123) - z310 * z1122))) * z846;
    const double z1131 = z480 - (z653 + (z678 - (z688 * z1122 - z1126))) + ((z784 + (z783 + (z782 + (z781 +
        z1127 + z368 * z1123) - z378 * z1122))) * z832 + z1130);
    /* (I.4.1) 118:5 */
    lambda[3] = -z1131; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    const double z1132 = z874 + (1.0 - z873);
    const double z1133 = z882 + (z1132 + z880);
    const double z1134 = z889 + (z887 - z1133);
    const double z1135 = z903 - (z902 - z1133);
    const double z1136 = z908 + (z1132 + z907);
    const double z1137 = z922 + (z923 - (z925 - (z926 + (z927 - (z928 + (z929 + (z930 + (z931 + (z932 + z1132
        * z768)))))))));
    const double z1138 = z703 * z1135 + (z906 + (z710 * z1136 + (z911 + (z913 + (z915 - (z916 - (z920 + (z921
        - z1137))))))));
    const double z1139 = z943 + (z942 + (z941 + (z940 + (z939 - (z938 - (z937 + (z936 + (z935 + z1132 *
        z330)))))))) + z361 * z1136;
    const double z1140 = z956 + (z955 - (z954 + (z953 + (z952 - (z951 - (z950 + (z949 - (z948 + z1132 *
        z148)))))))) + z180 * z1136;
    const double z1141 = z969 + (z968 + (z967 - (z966 - (z965 - (z964 + (z963 - (z962 + (z961 + z1132 *
        z251)))))))) + z282 * z1136;
    const double z1142 = (z960 - (z959 + (z958 + z1140 + z199 * z1135) - z210 * z1134)) * z847 + (z973 -
        (z972 + (z971 + z1141 + z301 * z1135) - z312 * z1134)) * z846;
    const double z1143 = z866 - (z872 + (z665 * z1134 - (z901 + z1138))) + ((z947 - (z946 + (z945 + z1139 +
        z376 * z1135) - z380 * z1134)) * z832 + z1142);
    /* (I.4.1) 119:5 */
    lambda[4] = z1143; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    const double z1144 = z1018 + z1019;
    const double z1145 = z1026 + (z1024 - z1144);
    const double z1146 = z1053 - (z1052 - z1144);
    const double z1147 = z1059 + z1060;
    const double z1148 = z1075 + (z1076 + (z1077 - (z1079 - (z1081 - (z1082 + (z1083 - (z1084 - (z1085 -
        (z1086 + (z1087 + z1088))))))))));
    const double z1149 = z802 * z1146 + (z1056 + (z1058 + (z803 * z1147 + (z1063 + (z1065 + (z1067 + (z1069 -
        (z1071 - z1148))))))));
    const double z1150 = z1011 + (z1017 - (z801 * z1145 - (z1040 + (z1051 + z1149)))) - g * (m_B * z1147 +
        m_H * z1146 - m_F * z1145);
    const double z1151 = z1104 + (z1103 + (z1102 - (z1101 - (z1100 - (z1099 - (z1098 + (z1097 + (z1095 -
        z1096)))))))) + z185 * z1147;
    const double z1152 = z1117 + (z1116 + (z1115 + (z1114 + (z1113 + (z1112 + z286 * z1147)) + z308 * z1146))
        - z314 * z1145);
    const double z1153 = (z1110 + (z1109 + (z1108 + (z1107 + (z1106 + z1151) + z206 * z1146)) - z213 *
        z1145)) * z847 + z1152 * z846;
    /* (I.4.1) 120:5 */
    lambda[5] = z1094 + z1153 - z1150; /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return bicycle_finish(6, lambda);
}

double bicycle_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = r_F * c_lam + c * s_lam;
    const double k5 = r_F * s_lam - c * c_lam;
    const double k6 = c_lam * k4;
    const double k7 = s_lam * k4;

    /* state */
    const double s_pitch = sin(pitch);
    const double c_roll = cos(roll);
    const double z1 = s_pitch * c_roll;
    const double c_pitch = cos(pitch);
    const double e3z = c_pitch * c_roll;
    const double z2 = r_R * e3z;
    const double Sz = z - z1 * k2 + z2;
    const double c_steer = cos(steer);
    const double z3 = z1 * c_lam;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double s_steer = sin(steer);
    const double z5 = c_steer * z4 - e2z * s_steer;
    const double z6 = z1 * s_lam;
    const double z7 = z6 - e3z * c_lam;
    const double z8 = c_lam * z5 + s_lam * z7;
    const double z9 = c_lam * z7 - s_lam * z5;
    const double z10 = z * m_R + m_B * (z - x_B * z1 + e3z * k1) + m_H * (Sz + z8 * k3 - z_H * z9);
    const double z11 = r_F * z9;
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double z12 = s_yaw * e2z;
    const double e1x = c_yaw * c_pitch - z12 * s_pitch;
    const double e3x = c_yaw * s_pitch + c_pitch * z12;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z13 = e1x * c_lam - e3x * s_lam;
    const double z14 = s_yaw * c_roll;
    const double f1x = c_steer * z13 - z14 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double z15 = 1.0 / sqrt(z8 * z8 + z9 * z9);
    const double z16 = r_F * z8 * z15;
    const double z17 = roll_dot * s_pitch;
    const double z18 = roll_dot * c_pitch;
    const double z19 = s_lam * z17 - c_lam * z18;
    const double z20 = s_steer * z19;
    const double z21 = 1.0 - c_steer;
    const double z22 = e2z * c_steer;
    const double z23 = s_steer * s_steer;
    const double z24 = c_pitch * (s_lam * z21 - s_steer * z15 * (z22 + 2.0 * (s_steer * z3))) + (s_pitch *
        (c_lam * z21 + 2.0 * (z15 * (z6 * z23))) - z15 * (z23 * (c_roll * s_lam)));
    const double z25 = s_pitch * (r_R - r_F * (c_steer * (1.0 + z15 * (s_steer * (e2z * s_lam))) + z15 * (e3z
        * z23)));
    const double z26 = c_lam * (r_F * z24 - c * (z21 * (c_pitch * c_lam - s_pitch * s_lam))) - (z25 + w *
        c_pitch);
    const double z27 = z11 * z15;
    const double z28 = steer_dot + (c_lam * z17 + s_lam * z18);
    const double z29 = s_lam * z28;
    const double z30 = c_steer * z19;
    const double z31 = c_lam * z28;
    const double z32 = roll_dot * c_roll;
    const double z33 = steer_dot * c_steer;
    const double z34 = s_steer * z32 + e2z * z33;
    const double z35 = steer_dot * s_steer;
    const double z36 = z4 * z35;
    const double z37 = roll_dot * e2z;
    const double z38 = c_pitch * z37;
    const double z39 = s_pitch * z37;
    const double z40 = z34 + (z36 + c_steer * (s_lam * z38 + c_lam * z39));
    const double z41 = c_lam * z38 - s_lam * z39;
    const double z42 = 1.0 / sqrt(z1 * z1 + e3z * e3z);
    const double R3 = z2 * z42;
    const double z43 = r_R * z1 * z42;
    const double z44 = z18 * R3 + z17 * z43;
    const double z45 = e2z * z44;
    const double z46 = r_F * (s_lam * z40 + c_lam * z41) + (c * (s_lam * z41 - c_lam * z40) - (r_R * z38 -
        (z45 + k2 * z39)));
    const double z47 = (z22 + s_steer * z4) * (z27 * (z29 - c_lam * z30) - z16 * (s_lam * z30 + z31)) + (z8 *
        (z27 * z20) + z46);
    const double z48 = (z9 * (z16 * z20) - z47) / (c_roll * z26);
    const double z49 = thF_dot + (z20 + c_steer * z48);
    const double z50 = z16 * z49;
    const double z51 = z14 * c_steer + z13 * s_steer;
    const double z52 = z30 - s_steer * z48;
    const double z53 = z27 * (z29 - c_lam * z52) - z16 * (z31 + s_lam * z52);
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z54 = z27 * z49;
    const double z55 = z14 * z33;
    const double z56 = s_yaw * z37;
    const double z57 = z13 * z35;
    const double z58 = s_yaw * z32;
    const double z59 = s_pitch * z48;
    const double z60 = z12 * z59;
    const double z61 = c_pitch * z48;
    const double z62 = c_yaw * z61;
    const double z63 = c_pitch * z58 - z60 + z62;
    const double z64 = z12 * z61;
    const double z65 = c_yaw * z59;
    const double z66 = s_pitch * z58 + z64 + z65;
    const double z67 = z55 - s_steer * z56 + (z57 + c_steer * (s_lam * z63 + c_lam * z66));
    const double z68 = c_lam * z63 - s_lam * z66;
    const double z69 = r_F * (s_lam * z67 + c_lam * z68) + (c * (s_lam * z68 - c_lam * z67) - (r_R * z63 - k2
        * z66));
    const double z70 = h3x * z50 - (z51 * z53 + (h1x * z54 + z69));
    const double z71 = c_steer * k5;
    const double z72 = r_R - s_lam * z71 - k6;
    const double z73 = k2 + c_lam * z71 - k7;
    const double z74 = c_roll * (s_steer * k5) - e2z * (c_pitch * z72 - s_pitch * z73);
    const double z75 = s_pitch * z72 + c_pitch * z73;
    const double z76 = h3x * z16 - h1x * z27;
    const double z77 = z51 * z16;
    const double z78 = z51 * z27;
    const double z79 = s_lam * z77 + c_lam * z78;
    const double z80 = s_steer * z76 + c_steer * z79;
    const double z81 = c_lam * z77 - s_lam * z78;
    const double z82 = c_yaw * z74 + s_yaw * z75 - e3z * (s_lam * z80 + c_lam * z81) - e2z * (c_steer * z76 -
        s_steer * z79);
    const double z83 = z82 - z1 * (c_lam * z80 - s_lam * z81);
    const double e2y = c_yaw * c_roll;
    const double z84 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z84;
    const double e1y = c_pitch * s_yaw + s_pitch * z84;
    const double z85 = e3y * z43 + e1y * R3;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z86 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z86 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z87 = h3y * z16 - h1y * z27;
    const double h2y = e2y * c_steer - s_steer * z86;
    const double z88 = h2y * z16;
    const double z89 = h2y * z27;
    const double z90 = s_lam * z88 + c_lam * z89;
    const double z91 = s_steer * z87 - c_steer * z90;
    const double z92 = c_lam * z88 - s_lam * z89;
    const double z93 = c_yaw * z75 - s_yaw * z74 + e3z * (s_lam * z91 - c_lam * z92) + e2z * (c_steer * z87 +
        s_steer * z90);
    const double z94 = z93 + z1 * (c_lam * z91 + s_lam * z92);
    const double z95 = 1.0 / (e3z * (e2y * z43) - e2z * z85 - z1 * (e2y * R3) + z94);
    const double z96 = e2y * z33;
    const double z97 = c_yaw * z37;
    const double z98 = z86 * z35;
    const double z99 = c_yaw * z32;
    const double z100 = z84 * z59;
    const double z101 = s_yaw * z61;
    const double z102 = c_pitch * z99 - z100 - z101;
    const double z103 = z84 * z61;
    const double z104 = s_yaw * z59;
    const double z105 = s_pitch * z99 + z103 - z104;
    const double z106 = z96 - s_steer * z97 - (z98 - c_steer * (s_lam * z102 + c_lam * z105));
    const double z107 = c_lam * z102 - s_lam * z105;
    const double z108 = r_F * (s_lam * z106 + c_lam * z107) + (c * (s_lam * z107 - c_lam * z106) - (r_R *
        z102 - k2 * z105));
    const double z109 = h3y * z50 + (h2y * z53 - (h1y * z54 - z108));
    const double z110 = z43 * z48;
    const double z111 = R3 * z48;
    const double z112 = z95 * (z109 - (e3y * z110 - (e2y * z44 - e1y * z111)));
    const double z113 = z85 * z95;
    const double z114 = e3x * z43 + e1x * R3;
    const double z115 = e3z * (z14 * z43) + e2z * z114 - z1 * (z14 * R3) + z83;
    const double z116 = (z70 - (e3x * z110 + (z14 * z44 + e1x * z111)) + z115 * z112) / (z114 + z115 * z113);
    const double z117 = z70 + z83 * z112 - z83 * z113 * z116;
    const double z118 = z112 - z113 * z116;
    const double z119 = s_yaw * z118;
    const double z120 = c_yaw * z118;
    const double z121 = z58 - e2z * z120;
    const double z122 = z65 - c_pitch * z119 + (z64 + s_pitch * z121);
    const double z123 = z62 + s_pitch * z119 - (z60 - c_pitch * z121);
    const double z124 = z117 + k2 * z122 - r_R * z123;
    const double z125 = z57 + c_steer * (c_lam * z122 + s_lam * z123) + (z55 - s_steer * (z56 + c_roll *
        z120));
    const double z126 = s_lam * z122 - c_lam * z123;
    const double z127 = c_lam * z125 + s_lam * z126;
    const double z128 = c_lam * z126 - s_lam * z125;
    const double z129 = z124 - c * z127 - r_F * z128;
    const double z130 = z109 - z94 * z112 + z94 * z113 * z116;
    const double z131 = z99 + e2z * z119;
    const double z132 = z104 + c_pitch * z120 - (z103 + s_pitch * z131);
    const double z133 = z101 - s_pitch * z120 + (z100 - c_pitch * z131);
    const double z134 = z130 + k2 * z132 - r_R * z133;
    const double z135 = z98 + c_steer * (c_lam * z132 + s_lam * z133) - (z96 - s_steer * (z97 - c_roll *
        z119));
    const double z136 = s_lam * z132 - c_lam * z133;
    const double z137 = c_lam * z135 + s_lam * z136;
    const double z138 = c_lam * z136 - s_lam * z135;
    const double z139 = z134 - c * z137 - r_F * z138;
    const double z140 = z39 - c_roll * z61;
    const double z141 = z38 + c_roll * z59;
    const double z142 = z45 + k2 * z140 - r_R * z141;
    const double z143 = z34 + (z36 + c_steer * (c_lam * z140 + s_lam * z141));
    const double z144 = s_lam * z140 - c_lam * z141;
    const double z145 = c_lam * z143 + s_lam * z144;
    const double z146 = c_lam * z144 - s_lam * z143;
    const double Fz_dot = z142 - c * z145 - r_F * z146;
    const double w1 = z18 + z1 * z118;
    const double w3 = z17 - e3z * z118;
    const double z147 = c_lam * w1 - s_lam * w3;
    const double w2 = z48 - e2z * z118;
    const double wf = c_steer * z147 + s_steer * w2;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double o1 = c_lam * wf + s_lam * ws;
    const double z148 = o1 * o1;
    const double o3 = c_lam * ws - s_lam * wf;
    const double z149 = o3 * o3;
    const double z150 = 0.5 * (m_F * (z129 * z129 + z139 * z139 + Fz_dot * Fz_dot)) + 0.5 * (F_xx * (z148 +
        z149));
    const double o2 = c_steer * w2 - s_steer * z147;
    const double z151 = thF_dot + o2;
    const double z152 = z124 - k3 * z127 + z_H * z128;
    const double z153 = z134 - k3 * z137 + z_H * z138;
    const double Hz_dot = z142 - k3 * z145 + z_H * z146;
    const double z154 = 0.5 * (m_H * (z152 * z152 + z153 * z153 + Hz_dot * Hz_dot)) + 0.5 * (H_xx * z148 +
        H_yy * (o2 * o2) + H_zz * z149);
    const double z155 = w1 * w1;
    const double z156 = w3 * w3;
    const double z157 = 0.5 * (m_R * (z117 * z117 + z130 * z130 + z45 * z45)) + 0.5 * (R_xx * (z155 + z156));
    const double z158 = z116 + w2;
    const double z159 = z117 + x_B * z122 - k1 * z123;
    const double z160 = z130 + x_B * z132 - k1 * z133;
    const double Bz_dot = z45 + x_B * z140 - k1 * z141;
    const double z161 = 0.5 * (m_B * (z159 * z159 + z160 * z160 + Bz_dot * Bz_dot)) + 0.5 * (B_xx * z155 +
        B_yy * (w2 * w2) + B_zz * z156);
    const double z162 = z154 + o3 * (H_xz * o1) + (z157 + 0.5 * (R_yy * (z158 * z158)) + (z161 + w3 * (B_xz *
        w1)));
    const double z163 = g * (z10 + m_F * (Sz + c * z8 + z11)) - (z150 + 0.5 * (F_yy * (z151 * z151)) + z162);
    return -z163;
}

int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = 0.5 * R_xx;
    const double k5 = 0.5 * F_xx;
    const double k6 = r_F * c_lam + c * s_lam;
    const double k7 = r_F * s_lam - c * c_lam;
    const double k8 = c_lam * k6;
    const double k9 = s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(c);
    const double k13 = k11 + k12;
    const double k14 = k13 + (k10 + k13) + (k13 + (fabs(w) + k12 + k13));
    const double k15 = k13 + k14;
    const double k16 = 3.0 * k13;
    const double k17 = k14 + k15;
    const double k18 = s_lam * s_lam;
    const double k19 = c_lam * c_lam;
    const double k20 = 0.5 * H_zz + k5;
    const double k21 = 0.5 * H_xx + k5;
    const double k22 = k4 + 0.5 * B_xx;
    const double k23 = k4 + 0.5 * B_zz;
    const double k24 = H_yy + F_yy;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = e2z * s_steer;
    const double z6 = c_steer * z4 - z5;
    const double z7 = z2 * s_lam;
    const double z8 = z7 - e3z * c_lam;
    const double z9 = c_lam * z6 + s_lam * z8;
    const double z10 = c_lam * z8 - s_lam * z6;
    const double z11 = z9 * z9 + z10 * z10;
    const double z12 = 1.0 / sqrt(z11);
    const double z13 = s_steer * z12;
    const double z14 = e2z * c_steer;
    const double z15 = z14 + 2.0 * (s_steer * z3);
    const double z16 = s_lam * z1 - z13 * z15;
    const double z17 = s_steer * s_steer;
    const double z18 = z7 * z17;
    const double z19 = c_lam * z1 + 2.0 * (z12 * z18);
    const double z20 = c_roll * s_lam;
    const double z21 = z17 * z20;
    const double z22 = c_pitch * c_lam - s_pitch * s_lam;
    const double z23 = e2z * s_lam;
    const double z24 = s_steer * z23;
    const double z25 = 1.0 + z12 * z24;
    const double z26 = e3z * z17;
    const double z27 = r_R - r_F * (c_steer * z25 + z12 * z26);
    const double z28 = c_lam * (r_F * (c_pitch * z16 + (s_pitch * z19 - z12 * z21)) - c * (z1 * z22)) -
        (s_pitch * z27 + w * c_pitch);
    const double z29 = c_roll * z28;
    const double z30 = k11 * fabs(z12);
    const double z31 = 110.0 * z30;
    const double z32 = 30.0 * z30 + k16 + (80.0 * z30 + k14 + (z31 + (z31 + k15) + (1.0 + 300.0 * z30)));
    /* the coframe is singular */
    if (!(fabs(z29) > 1e-12 * (50.0 * z30 + z32))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z33 = r_R * z2;
    const double z34 = z2 * z2 + e3z * e3z;
    const double z35 = 1.0 / sqrt(z34);
    const double z36 = z33 * z35;
    const double z37 = e2y * z36;
    const double s_yaw = sin(yaw);
    const double z38 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z38;
    const double e1y = c_pitch * s_yaw + s_pitch * z38;
    const double z39 = r_R * e3z;
    const double R3 = z39 * z35;
    const double z40 = e3y * z36 + e1y * R3;
    const double z41 = e2y * R3;
    const double z42 = c_steer * k7;
    const double z43 = r_R - s_lam * z42 - k8;
    const double z44 = k2 + c_lam * z42 - k9;
    const double z45 = s_pitch * z43 + c_pitch * z44;
    const double z46 = s_steer * k7;
    const double z47 = c_pitch * z43 - s_pitch * z44;
    const double z48 = c_roll * z46 - e2z * z47;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z49 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z49 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z50 = r_F * z9;
    const double z51 = z50 * z12;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z52 = r_F * z10;
    const double z53 = z52 * z12;
    const double z54 = h3y * z51 - h1y * z53;
    const double z55 = e2y * c_steer;
    const double z56 = s_steer * z49;
    const double h2y = z55 - z56;
    const double z57 = h2y * z51;
    const double z58 = h2y * z53;
    const double z59 = s_lam * z57 + c_lam * z58;
    const double z60 = s_steer * z54 - c_steer * z59;
    const double z61 = c_lam * z57 - s_lam * z58;
    const double z62 = s_lam * z60 - c_lam * z61;
    const double z63 = c_steer * z54 + s_steer * z59;
    const double z64 = c_lam * z60 + s_lam * z61;
    const double z65 = c_yaw * z45 - s_yaw * z48 + e3z * z62 + e2z * z63 + z2 * z64;
    const double z66 = e3z * z37 - e2z * z40 - z2 * z41 + z65;
    const double z67 = k10 * fabs(z35);
    const double z68 = 4.0 * z67;
    const double z69 = 190.0 * z30;
    const double z70 = 6.0 * z67 + (z69 + (140.0 * z30 + (z69 + k17)));
    /* the coframe is singular */
    if (!(fabs(-z66) > 1e-12 * (z68 + z70))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z71 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z71;
    const double e1x = c_yaw * c_pitch - z71 * s_pitch;
    const double z72 = e3x * z36 + e1x * R3;
    const double z73 = s_yaw * c_roll;
    const double z74 = z73 * z36;
    const double z75 = z73 * R3;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z76 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z76 - z73 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z77 = h3x * z51 - h1x * z53;
    const double z78 = z73 * c_steer;
    const double z79 = z76 * s_steer;
    const double z80 = z78 + z79;
    const double z81 = z80 * z51;
    const double z82 = z80 * z53;
    const double z83 = s_lam * z81 + c_lam * z82;
    const double z84 = s_steer * z77 + c_steer * z83;
    const double z85 = c_lam * z81 - s_lam * z82;
    const double z86 = s_lam * z84 + c_lam * z85;
    const double z87 = c_steer * z77 - s_steer * z83;
    const double z88 = c_lam * z84 - s_lam * z85;
    const double z89 = c_yaw * z48 + s_yaw * z45 - e3z * z86 - e2z * z87 - z2 * z88;
    const double z90 = e3z * z74 + e2z * z72 - z2 * z75 + z89;
    const double z91 = 1.0 / z66;
    const double z92 = z40 * z91;
    const double z93 = z72 + z90 * z92;
    /* the coframe is singular */
    if (!(fabs(z93) > 1e-12 * (z68 + 4.0 * (z70 * (z67 * fabs(z91)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z94 = s_steer * z22;
    const double z95 = 1.0 / z29;
    const double z96 = z51 * z94;
    const double z97 = s_steer * z4;
    const double h2z = z14 + z97;
    const double z98 = s_pitch * c_lam + c_pitch * s_lam;
    const double z99 = s_lam * z98;
    const double z100 = c_steer * z22;
    const double z101 = z99 + c_lam * z100;
    const double z102 = c_lam * z98;
    const double z103 = s_lam * z100 - z102;
    const double z104 = z53 * z101 + z51 * z103;
    const double z105 = z53 * z94;
    const double z106 = c_roll * s_steer;
    const double z107 = c_pitch * e2z;
    const double z108 = e2z * s_pitch;
    const double z109 = s_lam * z107 + c_lam * z108;
    const double z110 = z106 + c_steer * z109;
    const double z111 = c_lam * z107 - s_lam * z108;
    const double z112 = c_pitch * R3 + s_pitch * z36;
    const double z113 = e2z * z112;
    const double z114 = r_F * (s_lam * z110 + c_lam * z111) + (c * (s_lam * z111 - c_lam * z110) - (r_R *
        z107 - (z113 + k2 * z108)));
    const double z115 = z10 * z96 + (h2z * z104 - (z9 * z105 - z114));
    const double z116 = z95 * z115;
    const double z117 = z94 + c_steer * z116;
    const double z118 = z51 * z117;
    const double z119 = z100 - s_steer * z116;
    const double z120 = z99 + c_lam * z119;
    const double z121 = z102 - s_lam * z119;
    const double z122 = z53 * z120 - z51 * z121;
    const double z123 = z53 * z117;
    const double z124 = s_pitch * z116;
    const double z125 = z71 * z124;
    const double z126 = c_pitch * z116;
    const double z127 = c_yaw * z126;
    const double z128 = c_pitch * z73 + z125 - z127;
    const double z129 = z71 * z126;
    const double z130 = c_yaw * z124;
    const double z131 = z129 - s_pitch * z73 + z130;
    const double z132 = s_lam * z128 - c_lam * z131;
    const double z133 = z71 * s_steer - c_steer * z132;
    const double z134 = c_lam * z128 + s_lam * z131;
    const double z135 = r_F * (s_lam * z133 - c_lam * z134) - (c * (s_lam * z134 + c_lam * z133) - (r_R *
        z128 + k2 * z131));
    const double z136 = h3x * z118 + (z80 * z122 - (h1x * z123 + z135));
    const double z137 = z38 * z124;
    const double z138 = s_yaw * z126;
    const double z139 = c_pitch * e2y + z137 + z138;
    const double z140 = z38 * z126;
    const double z141 = s_yaw * z124;
    const double z142 = s_pitch * e2y - z140 + z141;
    const double z143 = s_lam * z139 + c_lam * z142;
    const double z144 = z38 * s_steer - c_steer * z143;
    const double z145 = c_lam * z139 - s_lam * z142;
    const double z146 = r_F * (s_lam * z144 - c_lam * z145) - (c * (s_lam * z145 + c_lam * z144) - (r_R *
        z139 - k2 * z142));
    const double z147 = h3y * z118 - (h2y * z122 + (h1y * z123 - z146));
    const double z148 = z36 * z116;
    const double z149 = R3 * z116;
    const double z150 = z147 - (e3y * z148 + (e2y * z112 + e1y * z149));
    const double z151 = z91 * z150;
    const double z152 = z89 * z92;
    const double z153 = 1.0 / z93;
    const double z154 = z136 - (e3x * z148 - (z73 * z112 - e1x * z149)) + z90 * z151;
    const double z155 = z153 * z154;
    const double z156 = z136 + z89 * z151 - z152 * z155;
    const double z157 = m_R * z156;
    const double z158 = z65 * z92;
    const double z159 = z147 - z65 * z151 + z158 * z155;
    const double z160 = m_R * z159;
    const double z161 = m_R * z113;
    const double z162 = z151 - z92 * z155;
    const double z163 = c_pitch - z2 * z162;
    const double z164 = s_pitch + e3z * z162;
    const double z165 = 2.0 * (k22 * z163) + B_xz * z164;
    const double z166 = z116 - e2z * z162;
    const double z167 = B_yy * z166;
    const double z168 = B_xz * z163 + 2.0 * (k23 * z164);
    const double z169 = z156 * z157 + z159 * z160 + z113 * z161 + z163 * z165 + z166 * z167 + z164 * z168;
    const double z170 = c_lam * z163 - s_lam * z164;
    const double z171 = c_steer * z170 - s_steer * z166;
    const double z172 = s_lam * z163 + c_lam * z164;
    const double z173 = c_lam * z171 + s_lam * z172;
    const double z174 = c_lam * z172 - s_lam * z171;
    const double z175 = 2.0 * (k21 * z173) + H_xz * z174;
    const double z176 = c_steer * z166 + s_steer * z170;
    const double z177 = H_yy * z176;
    const double z178 = H_xz * z173 + 2.0 * (k20 * z174);
    const double z179 = z155 + z166;
    const double z180 = R_yy * z179;
    const double z181 = s_yaw * z162;
    const double z182 = c_yaw * z162;
    const double z183 = z73 + e2z * z182;
    const double z184 = z130 - c_pitch * z181 + (z129 - s_pitch * z183);
    const double z185 = z127 + s_pitch * z181 - (z125 + c_pitch * z183);
    const double z186 = z156 + x_B * z184 - k1 * z185;
    const double z187 = m_B * z186;
    const double z188 = e2y - e2z * z181;
    const double z189 = z141 + c_pitch * z182 - (z140 - s_pitch * z188);
    const double z190 = z138 - s_pitch * z182 + (z137 + c_pitch * z188);
    const double z191 = z159 + x_B * z189 - k1 * z190;
    const double z192 = m_B * z191;
    const double z193 = z169 + z173 * z175 + z176 * z177 + z174 * z178 + z179 * z180 + z186 * z187 + z191 *
        z192;
    const double z194 = z108 + c_roll * z126;
    const double z195 = z107 - c_roll * z124;
    const double z196 = z113 + x_B * z194 - k1 * z195;
    const double z197 = m_B * z196;
    const double z198 = z156 + k2 * z184 - r_R * z185;
    const double z199 = c_lam * z184 + s_lam * z185;
    const double z200 = z71 - c_roll * z182;
    const double z201 = c_steer * z199 + s_steer * z200;
    const double z202 = s_lam * z184 - c_lam * z185;
    const double z203 = c_lam * z201 + s_lam * z202;
    const double z204 = c_lam * z202 - s_lam * z201;
    const double z205 = z198 - k3 * z203 + z_H * z204;
    const double z206 = m_H * z205;
    const double z207 = z159 + k2 * z189 - r_R * z190;
    const double z208 = c_lam * z189 + s_lam * z190;
    const double z209 = z38 + c_roll * z181;
    const double z210 = c_steer * z208 - s_steer * z209;
    const double z211 = s_lam * z189 - c_lam * z190;
    const double z212 = c_lam * z210 + s_lam * z211;
    const double z213 = c_lam * z211 - s_lam * z210;
    const double z214 = z207 - k3 * z212 + z_H * z213;
    const double z215 = m_H * z214;
    const double z216 = z113 + k2 * z194 - r_R * z195;
    const double z217 = c_lam * z194 + s_lam * z195;
    const double z218 = z106 + c_steer * z217;
    const double z219 = s_lam * z194 - c_lam * z195;
    const double z220 = c_lam * z218 + s_lam * z219;
    const double z221 = c_lam * z219 - s_lam * z218;
    const double z222 = z216 - k3 * z220 + z_H * z221;
    const double z223 = m_H * z222;
    const double z224 = z198 - c * z203 - r_F * z204;
    const double z225 = m_F * z224;
    const double z226 = z207 - c * z212 - r_F * z213;
    const double z227 = m_F * z226;
    const double z228 = z193 + z196 * z197 + z205 * z206 + z214 * z215 + z222 * z223 + z224 * z225 + z226 *
        z227;
    const double z229 = z216 - c * z220 - r_F * z221;
    const double z230 = m_F * z229;
    const double z231 = F_yy * z176;
    const double z232 = z228 + z229 * z230 + z176 * z231;
    /* the mass matrix is singular */
    if (!(fabs(z232) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z233 = s_lam * z53 - c_lam * z51;
    const double z234 = h2z * z233 + (r_F * (s_lam * h2z) - c * (c_lam * h2z));
    const double z235 = z95 * z234;
    const double z236 = c_steer * z235;
    const double z237 = z51 * z236;
    const double z238 = s_steer * z235;
    const double z239 = s_lam - c_lam * z238;
    const double z240 = c_lam + s_lam * z238;
    const double z241 = z53 * z239 - z51 * z240;
    const double z242 = z53 * z236;
    const double z243 = s_pitch * z235;
    const double z244 = z71 * z243;
    const double z245 = c_pitch * z235;
    const double z246 = c_yaw * z245;
    const double z247 = z244 - z246;
    const double z248 = z71 * z245;
    const double z249 = c_yaw * z243;
    const double z250 = z248 + z249;
    const double z251 = s_lam * z247 - c_lam * z250;
    const double z252 = z78 + (z79 + c_steer * z251);
    const double z253 = c_lam * z247 + s_lam * z250;
    const double z254 = r_F * (s_lam * z252 + c_lam * z253) + (c * (s_lam * z253 - c_lam * z252) - (r_R *
        z247 + k2 * z250));
    const double z255 = h3x * z237 + (z80 * z241 - (h1x * z242 - z254));
    const double z256 = z38 * z243;
    const double z257 = s_yaw * z245;
    const double z258 = z256 + z257;
    const double z259 = z38 * z245;
    const double z260 = s_yaw * z243;
    const double z261 = z259 - z260;
    const double z262 = s_lam * z258 - c_lam * z261;
    const double z263 = z55 - (z56 - c_steer * z262);
    const double z264 = c_lam * z258 + s_lam * z261;
    const double z265 = r_F * (s_lam * z263 + c_lam * z264) + (c * (s_lam * z264 - c_lam * z263) - (r_R *
        z258 + k2 * z261));
    const double z266 = h3y * z237 - (h2y * z241 + (h1y * z242 + z265));
    const double z267 = z36 * z235;
    const double z268 = R3 * z235;
    const double z269 = z266 - (e3y * z267 + e1y * z268);
    const double z270 = z91 * z269;
    const double z271 = z255 - (e3x * z267 + e1x * z268) + z90 * z270;
    const double z272 = z153 * z271;
    const double z273 = z255 + z89 * z270 - z152 * z272;
    const double z274 = m_R * z273;
    const double z275 = z266 - z65 * z270 + z158 * z272;
    const double z276 = m_R * z275;
    const double z277 = z270 - z92 * z272;
    const double z278 = z2 * z277;
    const double z279 = e3z * z277;
    const double z280 = 2.0 * (k22 * z278) - B_xz * z279;
    const double z281 = z235 - e2z * z277;
    const double z282 = B_yy * z281;
    const double z283 = B_xz * z278 - 2.0 * (k23 * z279);
    const double z284 = c_lam * z278 + s_lam * z279;
    const double z285 = c_steer * z284 + s_steer * z281;
    const double z286 = 1.0 - (s_lam * z278 - c_lam * z279);
    const double z287 = c_lam * z285 - s_lam * z286;
    const double z288 = c_lam * z286 + s_lam * z285;
    const double z289 = 2.0 * (k21 * z287) - H_xz * z288;
    const double z290 = z273 * z274 + z275 * z276 + z278 * z280 + z281 * z282 - z279 * z283 + z287 * z289;
    const double z291 = c_steer * z281 - s_steer * z284;
    const double z292 = H_yy * z291;
    const double z293 = H_xz * z287 - 2.0 * (k20 * z288);
    const double z294 = z272 + z281;
    const double z295 = R_yy * z294;
    const double z296 = s_yaw * z277;
    const double z297 = c_yaw * z277;
    const double z298 = e2z * z297;
    const double z299 = z249 - c_pitch * z296 + (z248 - s_pitch * z298);
    const double z300 = z246 + s_pitch * z296 - (z244 + c_pitch * z298);
    const double z301 = z273 + x_B * z299 - k1 * z300;
    const double z302 = m_B * z301;
    const double z303 = e2z * z296;
    const double z304 = z260 + c_pitch * z297 - (z259 + s_pitch * z303);
    const double z305 = z257 - s_pitch * z297 + (z256 - c_pitch * z303);
    const double z306 = z275 + x_B * z304 - k1 * z305;
    const double z307 = m_B * z306;
    const double z308 = c_roll * z245;
    const double z309 = c_roll * z243;
    const double z310 = x_B * z308 + k1 * z309;
    const double z311 = m_B * z310;
    const double z312 = z290 + z291 * z292 - z288 * z293 + z294 * z295 + z301 * z302 + z306 * z307 + z310 *
        z311;
    const double z313 = z273 + k2 * z299 - r_R * z300;
    const double z314 = c_lam * z299 + s_lam * z300;
    const double z315 = c_roll * z297;
    const double z316 = z79 - c_steer * z314 + (z78 + s_steer * z315);
    const double z317 = s_lam * z299 - c_lam * z300;
    const double z318 = c_lam * z316 - s_lam * z317;
    const double z319 = c_lam * z317 + s_lam * z316;
    const double z320 = z313 + k3 * z318 + z_H * z319;
    const double z321 = m_H * z320;
    const double z322 = z275 + k2 * z304 - r_R * z305;
    const double z323 = c_lam * z304 + s_lam * z305;
    const double z324 = c_roll * z296;
    const double z325 = z56 - c_steer * z323 - (z55 - s_steer * z324);
    const double z326 = s_lam * z304 - c_lam * z305;
    const double z327 = c_lam * z325 - s_lam * z326;
    const double z328 = c_lam * z326 + s_lam * z325;
    const double z329 = z322 + k3 * z327 + z_H * z328;
    const double z330 = m_H * z329;
    const double z331 = k2 * z308 + r_R * z309;
    const double z332 = c_lam * z308 - s_lam * z309;
    const double z333 = z14 + (z97 + c_steer * z332);
    const double z334 = s_lam * z308 + c_lam * z309;
    const double z335 = c_lam * z333 + s_lam * z334;
    const double z336 = c_lam * z334 - s_lam * z333;
    const double z337 = z331 - k3 * z335 + z_H * z336;
    const double z338 = m_H * z337;
    const double z339 = z313 + c * z318 - r_F * z319;
    const double z340 = m_F * z339;
    const double z341 = z322 + c * z327 - r_F * z328;
    const double z342 = m_F * z341;
    const double z343 = z331 - c * z335 - r_F * z336;
    const double z344 = m_F * z343;
    const double z345 = z312 + z320 * z321 + z329 * z330 + z337 * z338 + z339 * z340 + z341 * z342 + z343 *
        z344;
    const double z346 = F_yy * z291;
    const double z347 = z345 + z291 * z346;
    const double z348 = z156 * z274 + z159 * z276 - z163 * z280 + z166 * z282 - z164 * z283 - z173 * z289;
    const double z349 = z348 + z176 * z292 - z174 * z293 + z179 * z295 + z186 * z302 + z191 * z307 + z196 *
        z311;
    const double z350 = z349 + z205 * z321 + z214 * z330 + z222 * z338 + z224 * z340 + z226 * z342 + z229 *
        z344;
    const double z351 = z350 + z176 * z346;
    const double z352 = 1.0 / z232;
    const double z353 = z351 * z352;
    const double z354 = z347 - z351 * z353;
    /* the mass matrix is singular */
    if (!(fabs(z354) > 1e-14 * z347)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z355 = z54 * z91;
    const double z356 = z77 + z90 * z355;
    const double z357 = z153 * z356;
    const double z358 = z77 + z89 * z355 - z152 * z357;
    const double z359 = m_R * z358;
    const double z360 = z54 - z65 * z355 + z158 * z357;
    const double z361 = m_R * z360;
    const double z362 = z355 - z92 * z357;
    const double z363 = z2 * z362;
    const double z364 = e3z * z362;
    const double z365 = 2.0 * (k22 * z363) - B_xz * z364;
    const double z366 = e2z * z362;
    const double z367 = B_yy * z366;
    const double z368 = B_xz * z363 - 2.0 * (k23 * z364);
    const double z369 = c_lam * z363 + s_lam * z364;
    const double z370 = c_steer * z369 - s_steer * z366;
    const double z371 = s_lam * z363 - c_lam * z364;
    const double z372 = c_lam * z370 + s_lam * z371;
    const double z373 = c_lam * z371 - s_lam * z370;
    const double z374 = 2.0 * (k21 * z372) + H_xz * z373;
    const double z375 = z358 * z359 + z360 * z361 + z363 * z365 + z366 * z367 - z364 * z368 + z372 * z374;
    const double z376 = c_steer * z366 + s_steer * z369;
    const double z377 = H_yy * z376;
    const double z378 = H_xz * z372 + 2.0 * (k20 * z373);
    const double z379 = z357 - z366;
    const double z380 = R_yy * z379;
    const double z381 = s_yaw * z362;
    const double z382 = c_yaw * z362;
    const double z383 = e2z * z382;
    const double z384 = c_pitch * z381 + s_pitch * z383;
    const double z385 = s_pitch * z381 - c_pitch * z383;
    const double z386 = z358 - x_B * z384 - k1 * z385;
    const double z387 = m_B * z386;
    const double z388 = e2z * z381;
    const double z389 = c_pitch * z382 - s_pitch * z388;
    const double z390 = s_pitch * z382 + c_pitch * z388;
    const double z391 = z360 + x_B * z389 + k1 * z390;
    const double z392 = m_B * z391;
    const double z393 = z358 - k2 * z384 - r_R * z385;
    const double z394 = c_lam * z384 - s_lam * z385;
    const double z395 = c_roll * z382;
    const double z396 = c_steer * z394 + s_steer * z395;
    const double z397 = s_lam * z384 + c_lam * z385;
    const double z398 = c_lam * z396 + s_lam * z397;
    const double z399 = c_lam * z397 - s_lam * z396;
    const double z400 = z393 + k3 * z398 - z_H * z399;
    const double z401 = m_H * z400;
    const double z402 = z375 + z376 * z377 + z373 * z378 + z379 * z380 + z386 * z387 + z391 * z392 + z400 *
        z401;
    const double z403 = z360 + k2 * z389 + r_R * z390;
    const double z404 = c_lam * z389 - s_lam * z390;
    const double z405 = c_roll * z381;
    const double z406 = c_steer * z404 - s_steer * z405;
    const double z407 = s_lam * z389 + c_lam * z390;
    const double z408 = c_lam * z406 + s_lam * z407;
    const double z409 = c_lam * z407 - s_lam * z406;
    const double z410 = z403 - k3 * z408 + z_H * z409;
    const double z411 = m_H * z410;
    const double z412 = z393 + c * z398 + r_F * z399;
    const double z413 = m_F * z412;
    const double z414 = z403 - c * z408 - r_F * z409;
    const double z415 = m_F * z414;
    const double z416 = 1.0 - z376;
    const double z417 = F_yy * z416;
    const double z418 = z402 + z410 * z411 + z412 * z413 + z414 * z415 + z416 * z417;
    const double z419 = z156 * z359 + z159 * z361 - z163 * z365 - z166 * z367 - z164 * z368 - z173 * z374;
    const double z420 = z419 - z176 * z377 - z174 * z378 + z179 * z380 + z186 * z387 + z191 * z392 + z205 *
        z401;
    const double z421 = z420 + z214 * z411 + z224 * z413 + z226 * z415 + z176 * z417;
    const double z422 = z421 * z352;
    const double z423 = z273 * z359 + z275 * z361 + z278 * z365 - z281 * z367 - z279 * z368 + z287 * z374;
    const double z424 = z423 - z291 * z377 - z288 * z378 + z294 * z380 + z301 * z387 + z306 * z392 + z320 *
        z401;
    const double z425 = z424 + z329 * z411 + z339 * z413 + z341 * z415 + z291 * z417 - z351 * z422;
    const double z426 = 1.0 / z354;
    const double z427 = z425 * z426;
    const double z428 = z418 - z421 * z422 - z425 * z427;
    /* the mass matrix is singular */
    if (!(fabs(z428) > 1e-14 * z418)) {
        return BICYCLE_SINGULAR_2;
    }
    /* (I.2.15) */
    J[0] = 0.0;
    J[1] = 0.0;
    J[2] = 0.0;
    const double z429 = roll_dot * s_pitch;
    const double z430 = roll_dot * c_pitch;
    const double z431 = s_lam * z429 - c_lam * z430;
    const double z432 = s_steer * z431;
    const double z433 = z51 * z432;
    const double z434 = steer_dot + (c_lam * z429 + s_lam * z430);
    const double z435 = s_lam * z434;
    const double z436 = c_steer * z431;
    const double z437 = z435 - c_lam * z436;
    const double z438 = c_lam * z434;
    const double z439 = s_lam * z436 + z438;
    const double z440 = z53 * z437 - z51 * z439;
    const double z441 = z53 * z432;
    const double z442 = roll_dot * c_roll;
    const double z443 = steer_dot * c_steer;
    const double z444 = s_steer * z442 + e2z * z443;
    const double z445 = steer_dot * s_steer;
    const double z446 = z4 * z445;
    const double z447 = roll_dot * e2z;
    const double z448 = c_pitch * z447;
    const double z449 = s_pitch * z447;
    const double z450 = s_lam * z448 + c_lam * z449;
    const double z451 = z444 + (z446 + c_steer * z450);
    const double z452 = c_lam * z448 - s_lam * z449;
    const double z453 = z430 * R3 + z429 * z36;
    const double z454 = r_F * (s_lam * z451 + c_lam * z452) + (c * (s_lam * z452 - c_lam * z451) - (r_R *
        z448 - (e2z * z453 + k2 * z449)));
    const double z455 = z10 * z433 - (h2z * z440 + (z9 * z441 + z454));
    const double z456 = z95 * z455;
    const double z457 = s_pitch * z456;
    const double z458 = z152 * z153;
    const double z459 = z89 - z90 * z458;
    const double z460 = z91 * z459;
    const double z461 = c * z460;
    const double z462 = r_F * z460;
    const double z463 = s_lam * z461 + c_lam * z462;
    const double z464 = c_lam * z461 - s_lam * z462;
    const double z465 = c_steer * z464;
    const double z466 = k2 * z460 - s_lam * z463 - c_lam * z465;
    const double z467 = c_pitch * z456;
    const double z468 = r_R * z460 - c_lam * z463 + s_lam * z465;
    const double z469 = 1.0 / (z66 * z66);
    const double z470 = thF_dot + (z432 + c_steer * z456);
    const double z471 = z51 * z470;
    const double z472 = s_steer * z456;
    const double z473 = z436 - z472;
    const double z474 = z435 - c_lam * z473;
    const double z475 = z438 + s_lam * z473;
    const double z476 = z53 * z474 - z51 * z475;
    const double z477 = z53 * z470;
    const double z478 = e2y * z443;
    const double z479 = c_yaw * z447;
    const double z480 = z49 * z445;
    const double z481 = c_yaw * z442;
    const double z482 = z38 * z457;
    const double z483 = s_yaw * z467;
    const double z484 = c_pitch * z481 - z482 - z483;
    const double z485 = z38 * z467;
    const double z486 = s_yaw * z457;
    const double z487 = s_pitch * z481 + z485 - z486;
    const double z488 = s_lam * z484 + c_lam * z487;
    const double z489 = z478 - s_steer * z479 - (z480 - c_steer * z488);
    const double z490 = c_lam * z484 - s_lam * z487;
    const double z491 = r_F * (s_lam * z489 + c_lam * z490) + (c * (s_lam * z490 - c_lam * z489) - (r_R *
        z484 - k2 * z487));
    const double z492 = z36 * z456;
    const double z493 = R3 * z456;
    const double z494 = h3y * z471 + (h2y * z476 - (h1y * z477 - z491)) - (e3y * z492 - (e2y * z453 - e1y *
        z493));
    const double z495 = 1.0 / (z93 * z93);
    const double z496 = z73 * z443;
    const double z497 = s_yaw * z447;
    const double z498 = z76 * z445;
    const double z499 = s_yaw * z442;
    const double z500 = z71 * z457;
    const double z501 = c_yaw * z467;
    const double z502 = c_pitch * z499 - z500 + z501;
    const double z503 = z71 * z467;
    const double z504 = c_yaw * z457;
    const double z505 = s_pitch * z499 + z503 + z504;
    const double z506 = s_lam * z502 + c_lam * z505;
    const double z507 = z496 - s_steer * z497 + (z498 + c_steer * z506);
    const double z508 = c_lam * z502 - s_lam * z505;
    const double z509 = r_F * (s_lam * z507 + c_lam * z508) + (c * (s_lam * z508 - c_lam * z507) - (r_R *
        z502 - k2 * z505));
    const double z510 = h3x * z471 - (z80 * z476 + (h1x * z477 + z509)) - (e3x * z492 + (z73 * z453 + e1x *
        z493));
    const double z511 = z91 * z494;
    const double z512 = z510 + z90 * z511;
    const double z513 = z495 * (z152 * z512);
    const double z514 = z153 * z512;
    const double z515 = z90 * z513 - z89 * z514;
    const double z516 = z469 * (z494 * z459 + z40 * z515);
    const double z517 = z511 - z92 * z514;
    const double z518 = z458 * z511 - z92 * z513;
    const double z519 = z517 - z518;
    const double z520 = 1.0 - z458;
    const double z521 = c * z520;
    const double z522 = r_F * z520;
    const double z523 = c_lam * z521 - s_lam * z522;
    const double z524 = s_steer * z523;
    const double z525 = s_lam * z521 + c_lam * z522;
    const double z526 = c_steer * z523;
    const double z527 = k2 * z520 - s_lam * z525 - c_lam * z526;
    const double z528 = r_R * z520 - c_lam * z525 + s_lam * z526;
    const double z529 = s_pitch * z527 - c_pitch * z528;
    const double z530 = z457 * z466 - z467 * z468 - z48 * z516 - z45 * z519 + z447 * z524 + z442 * z529;
    const double z531 = e2z * z516;
    const double z532 = z91 * z515 + z531;
    const double z533 = z2 * z516;
    const double z534 = e3z * z516;
    const double z535 = s_lam * z533 - c_lam * z534;
    const double z536 = c_lam * z533 + s_lam * z534;
    const double z537 = c_steer * z536 - s_steer * z531;
    const double z538 = c_lam * z535 - s_lam * z537;
    const double z539 = c_lam * z537 + s_lam * z535;
    const double z540 = z476 * z460 - z51 * z538 + z53 * z539;
    const double z541 = c_steer * z531 + s_steer * z536;
    const double z542 = z471 * z460 - z51 * z541;
    const double z543 = z477 * z460 - z53 * z541;
    const double z544 = s_lam * z542 + c_lam * z543;
    const double z545 = z445 * z464 - s_steer * z540 - c_steer * z544;
    const double z546 = c_lam * z542 - s_lam * z543;
    const double z547 = z492 * z460 - z36 * z532 + s_lam * z545 - c_lam * z546;
    const double z548 = e3z * z518;
    const double z549 = z2 * z518;
    const double z550 = z2 * z519;
    const double z551 = e3z * z519;
    const double z552 = s_lam * z550 - c_lam * z551;
    const double z553 = c_lam * z550 + s_lam * z551;
    const double z554 = e2z * z519;
    const double z555 = c_steer * z553 - s_steer * z554;
    const double z556 = c_lam * z552 - s_lam * z555;
    const double z557 = c_lam * z555 + s_lam * z552;
    const double z558 = z520 * z476 - z51 * z556 + z53 * z557;
    const double z559 = c_steer * z554 + s_steer * z553;
    const double z560 = z520 * z471 - z51 * z559;
    const double z561 = z520 * z477 - z53 * z559;
    const double z562 = s_lam * z560 + c_lam * z561;
    const double z563 = z453 * z458 - z36 * z548 + R3 * z549 + z443 * z523 - c_steer * z558 + s_steer * z562;
    const double z564 = z493 * z460 - R3 * z532 - c_lam * z545 - s_lam * z546;
    const double z565 = z513 - e2z * z518;
    const double z566 = z445 * z523 - s_steer * z558 - c_steer * z562;
    const double z567 = c_lam * z560 - s_lam * z561;
    const double z568 = z458 * z492 + z36 * z565 - s_lam * z566 + c_lam * z567;
    const double z569 = z458 * z493 + R3 * z565 + c_lam * z566 + s_lam * z567;
    const double z570 = z467 * z527 + z457 * z528 - c_pitch * z568 + s_pitch * z569;
    const double z571 = s_steer * z464;
    const double z572 = s_pitch * z466 - c_pitch * z468;
    const double z573 = z457 * z527 - z467 * z528 + z45 * z516 - z48 * z519 - z447 * z571 - z442 * z572;
    const double z574 = z453 * z460 - z36 * z534 + R3 * z533 - z443 * z464 + c_steer * z540 - s_steer * z544;
    const double z575 = z467 * z466 + z457 * z468 + c_pitch * z547 - s_pitch * z564;
    const double z576 = c_yaw * (z530 + s_pitch * z547 - c_roll * z563 + c_pitch * z564 + e2z * z570) - s_yaw
        * (z573 - s_pitch * z568 - c_roll * z574 - e2z * z575 - c_pitch * z569);
    J[3] = z576;
    const double z577 = 1.0 / (z29 * z29);
    const double z578 = e1x * z458 - e1y * z460;
    const double z579 = e3x * z458 - e3y * z460;
    const double z580 = z38 * z466 + s_yaw * z468 - z71 * z527 + c_yaw * z528;
    const double z581 = s_yaw * z466 - z38 * z468 + c_yaw * z527 + z71 * z528;
    const double z582 = h2y * z460 - z80 * z520;
    const double z583 = s_lam * (z51 * z582) + c_lam * (z53 * z582);
    const double z584 = h1y * z460 + h1x * z520;
    const double z585 = h3y * z460 + h3x * z520;
    const double z586 = z53 * z584 - z51 * z585;
    const double z587 = R3 * z578 + z36 * z579 + c_pitch * z580 - s_pitch * z581 + s_steer * z583 - c_steer *
        z586;
    const double z588 = z577 * (z455 * z587);
    const double z589 = c_roll * z588;
    const double z590 = c_lam * z589;
    const double z591 = r_F * z590;
    const double z592 = z12 * z591;
    const double z593 = s_yaw * z516 + c_yaw * z519;
    const double z594 = z95 * z587;
    const double z595 = c * z594;
    const double z596 = r_F * z594;
    const double z597 = c_lam * z595 - s_lam * z596;
    const double z598 = s_steer * z597 + c_yaw * z572 - s_yaw * z529;
    const double z599 = r_F * (s_pitch * z589);
    const double z600 = z12 * z599;
    const double z601 = 1.0 / z34;
    const double z602 = z73 * z458 + e2y * z460 - e2z * z594;
    const double z603 = z456 * z578 + z430 * z602 + e1y * z532 + e2y * z533 + e1x * z565 + z73 * z549;
    const double z604 = z456 * z579 + z429 * z602 - e2y * z534 + e3y * z532 - z73 * z548 + e3x * z565;
    const double z605 = z35 * (z601 * (z39 * z603 + z33 * z604));
    const double z606 = z17 * z600 + z62 * z516 + z86 * z519 + z37 * z516 + z74 * z518 + e3z * z605;
    const double z607 = z440 * z594;
    const double z608 = 1.0 / z11;
    const double z609 = c_steer * z599;
    const double z610 = s_pitch * z591;
    const double z611 = c_pitch * z591;
    const double z612 = z15 * z611;
    const double z613 = z9 * z594;
    const double z614 = h2z * z594;
    const double z615 = z470 * z584 - z474 * z582 + z432 * z613 + z437 * z614 - h1y * z541 - h2y * z539;
    const double z616 = z615 - h1x * z559 + z80 * z557;
    const double z617 = z26 * z599 + z24 * z609 - z21 * z591 + 2.0 * (z18 * z610) - s_steer * z612 + z52 *
        z616;
    const double z618 = z10 * z594;
    const double z619 = z475 * z582 - z470 * z585 - z439 * z614 - z432 * z618 + h2y * z538 + h3y * z541;
    const double z620 = z619 - z80 * z556 + h3x * z559;
    const double z621 = z12 * (z608 * (z617 + z50 * z620));
    const double z622 = z433 * z594 + z10 * z621 - r_F * (z12 * z616);
    const double z623 = z441 * z594 - z9 * z621 + r_F * (z12 * z620);
    const double z624 = s_lam * z622 + c_lam * z623;
    const double z625 = z445 * z597 - s_steer * z607 - c_steer * z624;
    const double z626 = c_lam * z622 - s_lam * z623;
    const double z627 = z606 - r_R * (z35 * z603) - s_lam * z625 + c_lam * z626;
    const double z628 = z28 * z588 - s_lam * (z17 * z592) - z46 * z593 - roll_dot * z598 + c_pitch * z627 -
        c_yaw * z574;
    const double z629 = z64 * z516 + z88 * z519 - z41 * z516 - z75 * z518 + z2 * z605 - r_R * (z35 * z604);
    const double z630 = z13 * z611;
    const double z631 = z12 * z610;
    const double z632 = z629 - c_lam * (2.0 * (s_steer * z630) + z625) + s_lam * (2.0 * (z17 * z631) - z626);
    const double z633 = z12 * z609;
    const double z634 = s_lam * (s_steer * z633) + z453 * z594 + z63 * z516 + z87 * z519 + z47 * z593 - z40 *
        z516;
    const double z635 = s_lam * z595 + c_lam * z596;
    const double z636 = c_steer * z597;
    const double z637 = r_R * z594 - c_lam * z635 + s_lam * z636;
    const double z638 = k2 * z594 - s_lam * z635 - c_lam * z636;
    const double z639 = c_yaw * z571 - s_yaw * z524 + c_pitch * z637 - s_pitch * z638;
    const double z640 = z630 - z607;
    const double z641 = z634 + z72 * z518 - z443 * z597 - roll_dot * z639 - c_steer * z640 - s_steer * z624 -
        c_yaw * z575;
    J[4] = c_roll * (z641 + s_yaw * z570) - e2z * (z628 - s_yaw * z563 + s_pitch * z632);
    const double z642 = c * z590;
    const double z643 = z1 * z642;
    const double z644 = z456 * z581 - z481 * z466 + z499 * z527 - z27 * z589 + s_lam * z643 + z19 * z591;
    const double z645 = e2z * z593;
    const double z646 = c_yaw * z516 - s_yaw * z519;
    const double z647 = z582 - z614;
    const double z648 = c_lam * (z51 * z647) - s_lam * (z53 * z647);
    const double z649 = z583 - s_lam * (z51 * z614) - c_lam * (z53 * z614);
    const double z650 = z586 + z53 * z613 - z51 * z618;
    const double z651 = c_steer * z649 + s_steer * z650;
    const double z652 = c_lam * z648 + s_lam * z651 - z36 * z602;
    const double z653 = z644 - z44 * z645 + z43 * z646 + z447 * z638 + roll_dot * z652 + s_yaw * z547 - c_yaw
        * z568;
    const double z654 = z456 * z580 - z481 * z468 + z499 * z528 + w * z589 + c_lam * z643 - z16 * z591;
    const double z655 = s_lam * z648 - c_lam * z651 - R3 * z602;
    const double z656 = z654 - z44 * z646 - z43 * z645 + z447 * z637 - roll_dot * z655 - c_roll * z627 + z38
        * z547;
    const double z657 = c_pitch * (z653 + c_roll * z632 + z38 * z564 + z71 * z569) + s_pitch * (z656 + z71 *
        z568 - s_yaw * z564 + c_yaw * z569);
    J[5] = z657;
    const double z658 = z456 * z583 + z479 * z464 - z497 * z523 - z23 * z633 - 2.0 * (s_steer * (e3z * z600 -
        z20 * z592 + 2.0 * (z7 * z631)));
    const double z659 = z658 + 2.0 * (z3 * z630) + z12 * z612 - z431 * z650 - z59 * z531 - z54 * z536;
    const double z660 = z4 * z597 + z49 * z464 + z76 * z523;
    const double z661 = z659 + z83 * z554 - z77 * z553 + k7 * (c_roll * z593) + z442 * z597 + steer_dot *
        z660;
    const double z662 = z661 - z4 * z607 - z49 * z540 - z76 * z558 + e2z * z624 - e2y * z544 + z73 * z562;
    const double z663 = z488 * z464 - z506 * z523 + z456 * z586 + z25 * z599 + (z22 * z642 - c_lam * z610 -
        s_lam * z611);
    const double z664 = z663 - z450 * z597 + z431 * z649 - z59 * z536 + z54 * z531 + z83 * z553 + z77 * z554;
    const double z665 = z664 + k7 * (c_lam * (c_pitch * z646 - s_pitch * z645) - s_lam * (s_pitch * z646 +
        c_pitch * z645));
    const double z666 = e2z * z597 - e2y * z464 + z73 * z523;
    const double z667 = z665 - steer_dot * z666 - e2z * z640 - e2y * z540 + z73 * z558 + z4 * z624 + z49 *
        z544;
    J[6] = -(c_steer * z662 + s_steer * (z667 + z76 * z562));
    J[7] = 0.0;
    J[8] = 0.0;
    J[9] = c_pitch * z655 - (e2z * z639 + c_roll * z598 - s_pitch * z652);
    J[10] = z648 - c_steer * z666 - s_steer * z660;
    J[11] = z586;
    J[12] = 0.0;
    J[13] = 0.0;
    J[14] = 0.0;
    const double z668 = z158 * z153;
    const double z669 = z65 - z90 * z668;
    const double z670 = z91 * z669;
    const double z671 = 1.0 - z670;
    const double z672 = c * z671;
    const double z673 = r_F * z671;
    const double z674 = s_lam * z672 + c_lam * z673;
    const double z675 = c_lam * z672 - s_lam * z673;
    const double z676 = c_steer * z675;
    const double z677 = k2 * z671 - s_lam * z674 - c_lam * z676;
    const double z678 = r_R * z671 - c_lam * z674 + s_lam * z676;
    const double z679 = z495 * (z158 * z512);
    const double z680 = z90 * z679 - z65 * z514;
    const double z681 = z469 * (z494 * z669 + z40 * z680);
    const double z682 = z517 - z681;
    const double z683 = z668 * z511 - z92 * z679;
    const double z684 = c * z668;
    const double z685 = r_F * z668;
    const double z686 = c_lam * z684 - s_lam * z685;
    const double z687 = s_steer * z686;
    const double z688 = s_lam * z684 + c_lam * z685;
    const double z689 = c_steer * z686;
    const double z690 = k2 * z668 - s_lam * z688 - c_lam * z689;
    const double z691 = r_R * z668 - c_lam * z688 + s_lam * z689;
    const double z692 = s_pitch * z690 - c_pitch * z691;
    const double z693 = z457 * z677 - z467 * z678 - z48 * z682 - z45 * z683 + z447 * z687 + z442 * z692;
    const double z694 = z91 * z680 + e2z * z681;
    const double z695 = z2 * z682;
    const double z696 = e3z * z682;
    const double z697 = s_lam * z695 - c_lam * z696;
    const double z698 = c_lam * z695 + s_lam * z696;
    const double z699 = e2z * z682;
    const double z700 = c_steer * z698 - s_steer * z699;
    const double z701 = c_lam * z697 - s_lam * z700;
    const double z702 = c_lam * z700 + s_lam * z697;
    const double z703 = z476 * z671 - z51 * z701 + z53 * z702;
    const double z704 = c_steer * z699 + s_steer * z698;
    const double z705 = z471 * z671 - z51 * z704;
    const double z706 = z477 * z671 - z53 * z704;
    const double z707 = s_lam * z705 + c_lam * z706;
    const double z708 = z445 * z675 - s_steer * z703 - c_steer * z707;
    const double z709 = c_lam * z705 - s_lam * z706;
    const double z710 = z492 * z670 - z36 * z694 - s_lam * z708 + c_lam * z709;
    const double z711 = e3z * z683;
    const double z712 = z2 * z683;
    const double z713 = s_lam * z712 - c_lam * z711;
    const double z714 = c_lam * z712 + s_lam * z711;
    const double z715 = e2z * z683;
    const double z716 = c_steer * z714 - s_steer * z715;
    const double z717 = c_lam * z713 - s_lam * z716;
    const double z718 = c_lam * z716 + s_lam * z713;
    const double z719 = z668 * z476 - z51 * z717 + z53 * z718;
    const double z720 = c_steer * z715 + s_steer * z714;
    const double z721 = z668 * z471 - z51 * z720;
    const double z722 = z668 * z477 - z53 * z720;
    const double z723 = s_lam * z721 + c_lam * z722;
    const double z724 = z453 * z668 - z36 * z711 + R3 * z712 - z443 * z686 + c_steer * z719 - s_steer * z723;
    const double z725 = z493 * z670 - R3 * z694 + c_lam * z708 + s_lam * z709;
    const double z726 = z679 - z715;
    const double z727 = z445 * z686 - s_steer * z719 - c_steer * z723;
    const double z728 = c_lam * z721 - s_lam * z722;
    const double z729 = z668 * z492 + z36 * z726 + s_lam * z727 - c_lam * z728;
    const double z730 = z668 * z493 + R3 * z726 - c_lam * z727 - s_lam * z728;
    const double z731 = z467 * z690 + z457 * z691 + c_pitch * z729 - s_pitch * z730;
    const double z732 = s_steer * z675;
    const double z733 = s_pitch * z677 - c_pitch * z678;
    const double z734 = z457 * z690 - z467 * z691 + z45 * z682 - z48 * z683 - z447 * z732 - z442 * z733;
    const double z735 = e3z * z681;
    const double z736 = z2 * z681;
    const double z737 = z453 * z670 - z36 * z735 + R3 * z736 + z443 * z675 - c_steer * z703 + s_steer * z707;
    const double z738 = z467 * z677 + z457 * z678 - c_pitch * z710 + s_pitch * z725;
    const double z739 = c_yaw * (z693 - s_pitch * z710 + c_roll * z724 - c_pitch * z725 + e2z * z731) - s_yaw
        * (z734 + s_pitch * z729 + c_roll * z737 - e2z * z738 + c_pitch * z730);
    J[15] = z739;
    const double z740 = e1x * z668 - e1y * z670;
    const double z741 = e3x * z668 - e3y * z670;
    const double z742 = z38 * z677 + s_yaw * z678 - z71 * z690 + c_yaw * z691;
    const double z743 = s_yaw * z677 - z38 * z678 + c_yaw * z690 + z71 * z691;
    const double z744 = h2y * z671 - z80 * z668;
    const double z745 = s_lam * (z51 * z744) + c_lam * (z53 * z744);
    const double z746 = h1y * z671 + h1x * z668;
    const double z747 = h3y * z671 + h3x * z668;
    const double z748 = z53 * z746 - z51 * z747;
    const double z749 = R3 * z740 + z36 * z741 - c_pitch * z742 + s_pitch * z743 - s_steer * z745 + c_steer *
        z748;
    const double z750 = z577 * (z455 * z749);
    const double z751 = c_roll * z750;
    const double z752 = c_lam * z751;
    const double z753 = r_F * z752;
    const double z754 = z12 * z753;
    const double z755 = s_yaw * z682 + c_yaw * z683;
    const double z756 = z95 * z749;
    const double z757 = c * z756;
    const double z758 = r_F * z756;
    const double z759 = c_lam * z757 - s_lam * z758;
    const double z760 = s_steer * z759 - c_yaw * z733 + s_yaw * z692;
    const double z761 = r_F * (s_pitch * z751);
    const double z762 = z12 * z761;
    const double z763 = z73 * z668 + e2y * z670 - e2z * z756;
    const double z764 = z456 * z740 + z430 * z763 + e1y * z694 + e2y * z736 + e1x * z726 + z73 * z712;
    const double z765 = z456 * z741 + z429 * z763 - e2y * z735 + e3y * z694 - z73 * z711 + e3x * z726;
    const double z766 = z35 * (z601 * (z39 * z764 + z33 * z765));
    const double z767 = z17 * z762 - z62 * z682 - z86 * z683 + z37 * z681 + z74 * z683 + e3z * z766;
    const double z768 = z440 * z756;
    const double z769 = c_steer * z761;
    const double z770 = s_pitch * z753;
    const double z771 = c_pitch * z753;
    const double z772 = z15 * z771;
    const double z773 = z9 * z756;
    const double z774 = h2z * z756;
    const double z775 = z470 * z746 - z474 * z744 - z432 * z773 - z437 * z774 - h1y * z704 - h2y * z702;
    const double z776 = z775 - h1x * z720 + z80 * z718;
    const double z777 = z26 * z761 + z24 * z769 - z21 * z753 + 2.0 * (z18 * z770) - s_steer * z772 - z52 *
        z776;
    const double z778 = z10 * z756;
    const double z779 = z475 * z744 - z470 * z747 + z439 * z774 + z432 * z778 + h2y * z701 + h3y * z704;
    const double z780 = z779 - z80 * z717 + h3x * z720;
    const double z781 = z12 * (z608 * (z777 - z50 * z780));
    const double z782 = z433 * z756 + z10 * z781 + r_F * (z12 * z776);
    const double z783 = z441 * z756 - z9 * z781 - r_F * (z12 * z780);
    const double z784 = s_lam * z782 + c_lam * z783;
    const double z785 = z445 * z759 - s_steer * z768 - c_steer * z784;
    const double z786 = c_lam * z782 - s_lam * z783;
    const double z787 = z767 - r_R * (z35 * z764) - s_lam * z785 + c_lam * z786;
    const double z788 = z28 * z750 - s_lam * (z17 * z754) + z46 * z755 - roll_dot * z760 + c_pitch * z787 -
        c_yaw * z737;
    const double z789 = z64 * z682 + z88 * z683 + z41 * z681 + z75 * z683 - z2 * z766 + r_R * (z35 * z765);
    const double z790 = z13 * z771;
    const double z791 = z12 * z770;
    const double z792 = z789 + c_lam * (2.0 * (s_steer * z790) + z785) - s_lam * (2.0 * (z17 * z791) - z786);
    const double z793 = z12 * z769;
    const double z794 = s_lam * (s_steer * z793) + z453 * z756 - z63 * z682 - z87 * z683 - z47 * z755 - z40 *
        z681;
    const double z795 = s_lam * z757 + c_lam * z758;
    const double z796 = c_steer * z759;
    const double z797 = r_R * z756 - c_lam * z795 + s_lam * z796;
    const double z798 = k2 * z756 - s_lam * z795 - c_lam * z796;
    const double z799 = c_yaw * z732 - s_yaw * z687 - c_pitch * z797 + s_pitch * z798;
    const double z800 = z790 - z768;
    const double z801 = z794 + z72 * z683 - z443 * z759 + roll_dot * z799 - c_steer * z800 - s_steer * z784 +
        c_yaw * z738;
    J[16] = e2z * (z788 - s_yaw * z724 - s_pitch * z792) - c_roll * (z801 - s_yaw * z731);
    const double z802 = c * z752;
    const double z803 = z1 * z802;
    const double z804 = z456 * z743 - z481 * z677 + z499 * z690 + z27 * z751 - s_lam * z803 - z19 * z753;
    const double z805 = e2z * z755;
    const double z806 = c_yaw * z682 - s_yaw * z683;
    const double z807 = z744 + z774;
    const double z808 = c_lam * (z51 * z807) - s_lam * (z53 * z807);
    const double z809 = z745 + s_lam * (z51 * z774) + c_lam * (z53 * z774);
    const double z810 = z748 - z53 * z773 + z51 * z778;
    const double z811 = c_steer * z809 + s_steer * z810;
    const double z812 = c_lam * z808 + s_lam * z811 + z36 * z763;
    const double z813 = z804 - z44 * z805 + z43 * z806 - z447 * z798 + roll_dot * z812 - s_yaw * z710 + c_yaw
        * z729;
    const double z814 = z456 * z742 - z481 * z678 + z499 * z691 - w * z751 - c_lam * z803 + z16 * z753;
    const double z815 = s_lam * z808 - c_lam * z811 + R3 * z763;
    const double z816 = z814 - z44 * z806 - z43 * z805 - z447 * z797 - roll_dot * z815 + c_roll * z787 - z38
        * z710;
    const double z817 = c_pitch * (z813 + c_roll * z792 - z38 * z725 - z71 * z730) + s_pitch * (z816 - z71 *
        z729 + s_yaw * z725 - c_yaw * z730);
    J[17] = z817;
    const double z818 = z456 * z745 + z479 * z675 - z497 * z686 + z23 * z793 + 2.0 * (s_steer * (e3z * z762 -
        z20 * z754 + 2.0 * (z7 * z791)));
    const double z819 = z818 - 2.0 * (z3 * z790) - z12 * z772 - z431 * z810 - z59 * z699 - z54 * z698;
    const double z820 = z4 * z759 - z49 * z675 - z76 * z686;
    const double z821 = z819 + z83 * z715 - z77 * z714 + k7 * (c_roll * z755) - z442 * z759 - steer_dot *
        z820;
    const double z822 = z821 + z4 * z768 - z49 * z703 - z76 * z719 - e2z * z784 - e2y * z707 + z73 * z723;
    const double z823 = z488 * z675 - z506 * z686 + z456 * z748 - z25 * z761 - (z22 * z802 - c_lam * z770 -
        s_lam * z771);
    const double z824 = z823 + z450 * z759 + z431 * z809 - z59 * z698 + z54 * z699 + z83 * z714 + z77 * z715;
    const double z825 = z824 + k7 * (c_lam * (c_pitch * z806 - s_pitch * z805) - s_lam * (s_pitch * z806 +
        c_pitch * z805));
    const double z826 = e2z * z759 + e2y * z675 - z73 * z686;
    const double z827 = z825 + steer_dot * z826 + e2z * z800 - e2y * z703 + z73 * z719 - z4 * z784 + z49 *
        z707;
    J[18] = -(c_steer * z822 + s_steer * (z827 + z76 * z723));
    J[19] = 0.0;
    J[20] = 0.0;
    J[21] = c_pitch * z815 - (e2z * z799 - c_roll * z760 - s_pitch * z812);
    J[22] = z808 + c_steer * z826 + s_steer * z820;
    J[23] = z748;
    J[24] = 0.0;
    J[25] = 0.0;
    J[26] = 0.0;
    J[27] = 0.0;
    const double z828 = e2z * z430;
    const double z829 = e2z * z429;
    const double z830 = z35 * (z601 * (z39 * z828 + z33 * z829));
    const double z831 = e3z * z830 - r_R * (z35 * z828);
    const double z832 = z2 * z830 - r_R * (z35 * z829);
    J[28] = e2z * (c_pitch * z831 + s_pitch * z832) + c_roll * z453;
    const double z833 = e2z * z36;
    const double z834 = e2z * R3;
    J[29] = c_pitch * (roll_dot * z833 - c_roll * z832) - s_pitch * (roll_dot * z834 - c_roll * z831);
    J[30] = 0.0;
    J[31] = 0.0;
    J[32] = 0.0;
    J[33] = s_pitch * z833 + c_pitch * z834;
    J[34] = 0.0;
    J[35] = 0.0;
    J[36] = 0.0;
    J[37] = 0.0;
    J[38] = 0.0;
    const double z835 = z92 * z153;
    const double z836 = 1.0 - z90 * z835;
    const double z837 = z91 * z836;
    const double z838 = c * z837;
    const double z839 = r_F * z837;
    const double z840 = s_lam * z838 + c_lam * z839;
    const double z841 = c_lam * z838 - s_lam * z839;
    const double z842 = c_steer * z841;
    const double z843 = k2 * z837 - s_lam * z840 - c_lam * z842;
    const double z844 = r_R * z837 - c_lam * z840 + s_lam * z842;
    const double z845 = z495 * (z92 * z512);
    const double z846 = z514 - z90 * z845;
    const double z847 = z469 * (z494 * z836 - z40 * z846);
    const double z848 = z835 * z511 - z92 * z845;
    const double z849 = c * z835;
    const double z850 = r_F * z835;
    const double z851 = c_lam * z849 - s_lam * z850;
    const double z852 = s_steer * z851;
    const double z853 = s_lam * z849 + c_lam * z850;
    const double z854 = c_steer * z851;
    const double z855 = k2 * z835 - s_lam * z853 - c_lam * z854;
    const double z856 = r_R * z835 - c_lam * z853 + s_lam * z854;
    const double z857 = s_pitch * z855 - c_pitch * z856;
    const double z858 = z457 * z843 - z467 * z844 - z48 * z847 + z45 * z848 - z447 * z852 - z442 * z857;
    const double z859 = e2z * z847;
    const double z860 = z91 * z846 - z859;
    const double z861 = z2 * z847;
    const double z862 = e3z * z847;
    const double z863 = s_lam * z861 - c_lam * z862;
    const double z864 = c_lam * z861 + s_lam * z862;
    const double z865 = c_steer * z864 - s_steer * z859;
    const double z866 = c_lam * z863 - s_lam * z865;
    const double z867 = c_lam * z865 + s_lam * z863;
    const double z868 = z476 * z837 - z51 * z866 + z53 * z867;
    const double z869 = c_steer * z859 + s_steer * z864;
    const double z870 = z471 * z837 - z51 * z869;
    const double z871 = z477 * z837 - z53 * z869;
    const double z872 = s_lam * z870 + c_lam * z871;
    const double z873 = z445 * z841 - s_steer * z868 - c_steer * z872;
    const double z874 = c_lam * z870 - s_lam * z871;
    const double z875 = z492 * z837 + z36 * z860 + s_lam * z873 - c_lam * z874;
    const double z876 = e3z * z848;
    const double z877 = z2 * z848;
    const double z878 = s_lam * z877 - c_lam * z876;
    const double z879 = c_lam * z877 + s_lam * z876;
    const double z880 = e2z * z848;
    const double z881 = c_steer * z879 - s_steer * z880;
    const double z882 = c_lam * z878 - s_lam * z881;
    const double z883 = c_lam * z881 + s_lam * z878;
    const double z884 = z835 * z476 - z51 * z882 + z53 * z883;
    const double z885 = c_steer * z880 + s_steer * z879;
    const double z886 = z835 * z471 - z51 * z885;
    const double z887 = z835 * z477 - z53 * z885;
    const double z888 = s_lam * z886 + c_lam * z887;
    const double z889 = z453 * z835 - z36 * z876 + R3 * z877 - z443 * z851 + c_steer * z884 - s_steer * z888;
    const double z890 = z493 * z837 + R3 * z860 - c_lam * z873 - s_lam * z874;
    const double z891 = z845 - z880;
    const double z892 = z445 * z851 - s_steer * z884 - c_steer * z888;
    const double z893 = c_lam * z886 - s_lam * z887;
    const double z894 = z835 * z492 + z36 * z891 + s_lam * z892 - c_lam * z893;
    const double z895 = z835 * z493 + R3 * z891 - c_lam * z892 - s_lam * z893;
    const double z896 = z467 * z855 + z457 * z856 + c_pitch * z894 - s_pitch * z895;
    const double z897 = s_steer * z841;
    const double z898 = s_pitch * z843 - c_pitch * z844;
    const double z899 = z457 * z855 - z467 * z856 - z45 * z847 - z48 * z848 + z447 * z897 + z442 * z898;
    const double z900 = z453 * z837 - z36 * z862 + R3 * z861 - z443 * z841 + c_steer * z868 - s_steer * z872;
    const double z901 = z467 * z843 + z457 * z844 + c_pitch * z875 - s_pitch * z890;
    const double z902 = c_yaw * (z858 + s_pitch * z875 - c_roll * z889 + c_pitch * z890 - e2z * z896) + s_yaw
        * (z899 + s_pitch * z894 + c_roll * z900 + e2z * z901 + c_pitch * z895);
    J[39] = z902;
    const double z903 = e1x * z835 - e1y * z837;
    const double z904 = e3x * z835 - e3y * z837;
    const double z905 = z38 * z843 + s_yaw * z844 + z71 * z855 - c_yaw * z856;
    const double z906 = s_yaw * z843 - z38 * z844 - c_yaw * z855 - z71 * z856;
    const double z907 = h2y * z837 + z80 * z835;
    const double z908 = s_lam * (z51 * z907) + c_lam * (z53 * z907);
    const double z909 = h1y * z837 - h1x * z835;
    const double z910 = h3y * z837 - h3x * z835;
    const double z911 = z53 * z909 - z51 * z910;
    const double z912 = R3 * z903 + z36 * z904 + c_pitch * z905 - s_pitch * z906 + s_steer * z908 - c_steer *
        z911;
    const double z913 = z577 * (z455 * z912);
    const double z914 = c_roll * z913;
    const double z915 = c_lam * z914;
    const double z916 = r_F * z915;
    const double z917 = z12 * z916;
    const double z918 = s_yaw * z847 - c_yaw * z848;
    const double z919 = z95 * z912;
    const double z920 = c * z919;
    const double z921 = r_F * z919;
    const double z922 = c_lam * z920 - s_lam * z921;
    const double z923 = s_steer * z922 + c_yaw * z898 + s_yaw * z857;
    const double z924 = r_F * (s_pitch * z914);
    const double z925 = z12 * z924;
    const double z926 = z73 * z835 + e2y * z837 - e2z * z919;
    const double z927 = z456 * z903 + z430 * z926 - e1y * z860 + e2y * z861 + e1x * z891 + z73 * z877;
    const double z928 = z456 * z904 + z429 * z926 - e2y * z862 - e3y * z860 - z73 * z876 + e3x * z891;
    const double z929 = z35 * (z601 * (z39 * z927 + z33 * z928));
    const double z930 = z17 * z925 + z62 * z847 - z86 * z848 + z37 * z847 + z74 * z848 + e3z * z929;
    const double z931 = z440 * z919;
    const double z932 = c_steer * z924;
    const double z933 = s_pitch * z916;
    const double z934 = c_pitch * z916;
    const double z935 = z15 * z934;
    const double z936 = z9 * z919;
    const double z937 = h2z * z919;
    const double z938 = z470 * z909 - z474 * z907 + z432 * z936 + z437 * z937 - h1y * z869 - h2y * z867;
    const double z939 = z938 + h1x * z885 - z80 * z883;
    const double z940 = z26 * z924 + z24 * z932 - z21 * z916 + 2.0 * (z18 * z933) - s_steer * z935 + z52 *
        z939;
    const double z941 = z10 * z919;
    const double z942 = z475 * z907 - z470 * z910 - z439 * z937 - z432 * z941 + h2y * z866 + h3y * z869;
    const double z943 = z942 + z80 * z882 - h3x * z885;
    const double z944 = z12 * (z608 * (z940 + z50 * z943));
    const double z945 = z433 * z919 + z10 * z944 - r_F * (z12 * z939);
    const double z946 = z441 * z919 - z9 * z944 + r_F * (z12 * z943);
    const double z947 = s_lam * z945 + c_lam * z946;
    const double z948 = z445 * z922 - s_steer * z931 - c_steer * z947;
    const double z949 = c_lam * z945 - s_lam * z946;
    const double z950 = z930 - r_R * (z35 * z927) - s_lam * z948 + c_lam * z949;
    const double z951 = z28 * z913 - s_lam * (z17 * z917) - z46 * z918 - roll_dot * z923 + c_pitch * z950 -
        c_yaw * z900;
    const double z952 = z64 * z847 - z88 * z848 - z41 * z847 - z75 * z848 + z2 * z929 - r_R * (z35 * z928);
    const double z953 = z13 * z934;
    const double z954 = z12 * z933;
    const double z955 = z952 - c_lam * (2.0 * (s_steer * z953) + z948) + s_lam * (2.0 * (z17 * z954) - z949);
    const double z956 = z12 * z932;
    const double z957 = s_lam * (s_steer * z956) + z453 * z919 + z63 * z847 - z87 * z848 + z47 * z918 - z40 *
        z847;
    const double z958 = s_lam * z920 + c_lam * z921;
    const double z959 = c_steer * z922;
    const double z960 = r_R * z919 - c_lam * z958 + s_lam * z959;
    const double z961 = k2 * z919 - s_lam * z958 - c_lam * z959;
    const double z962 = c_yaw * z897 + s_yaw * z852 + c_pitch * z960 - s_pitch * z961;
    const double z963 = z953 - z931;
    const double z964 = z957 + z72 * z848 - z443 * z922 - roll_dot * z962 - c_steer * z963 - s_steer * z947 -
        c_yaw * z901;
    J[40] = c_roll * (z964 - s_yaw * z896) - e2z * (z951 - s_yaw * z889 + s_pitch * z955);
    const double z965 = c * z915;
    const double z966 = z1 * z965;
    const double z967 = z456 * z906 - z481 * z843 - z499 * z855 - z27 * z914 + s_lam * z966 + z19 * z916;
    const double z968 = e2z * z918;
    const double z969 = c_yaw * z847 + s_yaw * z848;
    const double z970 = z907 - z937;
    const double z971 = c_lam * (z51 * z970) - s_lam * (z53 * z970);
    const double z972 = z908 - s_lam * (z51 * z937) - c_lam * (z53 * z937);
    const double z973 = z911 + z53 * z936 - z51 * z941;
    const double z974 = c_steer * z972 + s_steer * z973;
    const double z975 = c_lam * z971 + s_lam * z974 - z36 * z926;
    const double z976 = z967 - z44 * z968 + z43 * z969 + z447 * z961 + roll_dot * z975 + s_yaw * z875 - c_yaw
        * z894;
    const double z977 = z456 * z905 - z481 * z844 - z499 * z856 + w * z914 + c_lam * z966 - z16 * z916;
    const double z978 = s_lam * z971 - c_lam * z974 - R3 * z926;
    const double z979 = z977 - z44 * z969 - z43 * z968 + z447 * z960 - roll_dot * z978 - c_roll * z950 + z38
        * z875;
    const double z980 = c_pitch * (z976 + c_roll * z955 + z38 * z890 + z71 * z895) + s_pitch * (z979 + z71 *
        z894 - s_yaw * z890 + c_yaw * z895);
    J[41] = z980;
    const double z981 = z456 * z908 + z479 * z841 + z497 * z851 - z23 * z956 - 2.0 * (s_steer * (e3z * z925 -
        z20 * z917 + 2.0 * (z7 * z954)));
    const double z982 = z981 + 2.0 * (z3 * z953) + z12 * z935 - z431 * z973 - z59 * z859 - z54 * z864;
    const double z983 = z4 * z922 + z49 * z841 - z76 * z851;
    const double z984 = z982 - z83 * z880 + z77 * z879 + k7 * (c_roll * z918) + z442 * z922 + steer_dot *
        z983;
    const double z985 = z984 - z4 * z931 - z49 * z868 + z76 * z884 + e2z * z947 - e2y * z872 - z73 * z888;
    const double z986 = z488 * z841 + z506 * z851 + z456 * z911 + z25 * z924 + (z22 * z965 - c_lam * z933 -
        s_lam * z934);
    const double z987 = z986 - z450 * z922 + z431 * z972 - z59 * z864 + z54 * z859 - z83 * z879 - z77 * z880;
    const double z988 = z987 + k7 * (c_lam * (c_pitch * z969 - s_pitch * z968) - s_lam * (s_pitch * z969 +
        c_pitch * z968));
    const double z989 = e2z * z922 - e2y * z841 - z73 * z851;
    const double z990 = z988 - steer_dot * z989 - e2z * z963 - e2y * z868 - z73 * z884 + z4 * z947 + z49 *
        z872;
    J[42] = -(c_steer * z985 + s_steer * (z990 - z76 * z888));
    J[43] = 0.0;
    J[44] = 0.0;
    J[45] = c_pitch * z978 - (e2z * z962 + c_roll * z923 - s_pitch * z975);
    J[46] = z971 - c_steer * z989 - s_steer * z983;
    J[47] = z911;
    J[48] = 0.0;
    J[49] = 0.0;
    J[50] = 0.0;
    J[51] = 0.0;
    J[52] = 0.0;
    J[53] = 0.0;
    J[54] = 0.0;
    J[55] = 0.0;
    J[56] = 0.0;
    J[57] = 1.0;
    J[58] = 0.0;
    J[59] = 0.0;
    J[60] = 0.0;
    J[61] = 0.0;
    J[62] = 0.0;
    J[63] = 0.0;
    const double z991 = z455 * z577;
    const double z992 = c_roll * z991;
    const double z993 = c_lam * z992;
    const double z994 = r_F * z993;
    const double z995 = z12 * z994;
    const double z996 = c * z95;
    const double z997 = r_F * z95;
    const double z998 = c_lam * z996 - s_lam * z997;
    const double z999 = s_steer * z998;
    const double z1000 = r_F * (s_pitch * z992);
    const double z1001 = z12 * z1000;
    const double z1002 = e2z * z95;
    const double z1003 = z430 * z1002;
    const double z1004 = z429 * z1002;
    const double z1005 = z35 * (z601 * (z39 * z1003 + z33 * z1004));
    const double z1006 = z440 * z95;
    const double z1007 = c_steer * z1000;
    const double z1008 = s_pitch * z994;
    const double z1009 = c_pitch * z994;
    const double z1010 = z15 * z1009;
    const double z1011 = z9 * z95;
    const double z1012 = h2z * z95;
    const double z1013 = z432 * z1011 + z437 * z1012;
    const double z1014 = z26 * z1000 + z24 * z1007 - z21 * z994 + 2.0 * (z18 * z1008) - s_steer * z1010 + z52
        * z1013;
    const double z1015 = z10 * z95;
    const double z1016 = z439 * z1012 + z432 * z1015;
    const double z1017 = z12 * (z608 * (z1014 - z50 * z1016));
    const double z1018 = z433 * z95 + z10 * z1017 - r_F * (z12 * z1013);
    const double z1019 = z441 * z95 - z9 * z1017 - r_F * (z12 * z1016);
    const double z1020 = s_lam * z1018 + c_lam * z1019;
    const double z1021 = z445 * z998 - s_steer * z1006 - c_steer * z1020;
    const double z1022 = c_lam * z1018 - s_lam * z1019;
    const double z1023 = z17 * z1001 - e3z * z1005 + r_R * (z35 * z1003) - s_lam * z1021 + c_lam * z1022;
    const double z1024 = z13 * z1009;
    const double z1025 = z12 * z1008;
    const double z1026 = z2 * z1005 - r_R * (z35 * z1004) + c_lam * (2.0 * (s_steer * z1024) + z1021) - s_lam
        * (2.0 * (z17 * z1025) - z1022);
    const double z1027 = e2z * (z28 * z991 - s_lam * (z17 * z995) - roll_dot * z999 + c_pitch * z1023 -
        s_pitch * z1026);
    const double z1028 = z12 * z1007;
    const double z1029 = s_lam * z996 + c_lam * z997;
    const double z1030 = c_steer * z998;
    const double z1031 = r_R * z95 - c_lam * z1029 + s_lam * z1030;
    const double z1032 = k2 * z95 - s_lam * z1029 - c_lam * z1030;
    const double z1033 = c_pitch * z1031 - s_pitch * z1032;
    const double z1034 = z1024 - z1006;
    const double z1035 = s_lam * (s_steer * z1028) + z453 * z95 - z443 * z998 - roll_dot * z1033 - c_steer *
        z1034 - s_steer * z1020;
    J[64] = z1027 - c_roll * z1035;
    const double z1036 = c * z993;
    const double z1037 = z1 * z1036;
    const double z1038 = z51 * z1012;
    const double z1039 = z53 * z1012;
    const double z1040 = c_lam * z1038 - s_lam * z1039;
    const double z1041 = s_lam * z1038 + c_lam * z1039;
    const double z1042 = z53 * z1011 - z51 * z1015;
    const double z1043 = c_steer * z1041 - s_steer * z1042;
    const double z1044 = c_lam * z1040 + s_lam * z1043 - z36 * z1002;
    const double z1045 = z27 * z992 - s_lam * z1037 - z19 * z994 - z447 * z1032 + roll_dot * z1044 + c_roll *
        z1026;
    const double z1046 = s_lam * z1040 - c_lam * z1043 - R3 * z1002;
    const double z1047 = w * z992 + c_lam * z1037 - z16 * z994 + z447 * z1031 + roll_dot * z1046 - c_roll *
        z1023;
    J[65] = c_pitch * z1045 - s_pitch * z1047;
    const double z1048 = z23 * z1028 + 2.0 * (s_steer * (e3z * z1001 - z20 * z995 + 2.0 * (z7 * z1025))) -
        2.0 * (z3 * z1024);
    const double z1049 = z4 * z998;
    const double z1050 = z1048 - z12 * z1010 + z431 * z1042 - z442 * z998 - steer_dot * z1049 + z4 * z1006 -
        e2z * z1020;
    const double z1051 = z25 * z1000 + (z22 * z1036 - c_lam * z1008 - s_lam * z1009) - z450 * z998 - z431 *
        z1041;
    const double z1052 = e2z * z998;
    J[66] = s_steer * (z1051 - steer_dot * z1052 - e2z * z1034 + z4 * z1020) - c_steer * z1050;
    J[67] = 0.0;
    J[68] = 0.0;
    J[69] = e2z * z1033 + c_roll * z999 + s_pitch * z1044 + c_pitch * z1046;
    J[70] = z1040 + c_steer * z1052 + s_steer * z1049;
    J[71] = 0.0;
    J[72] = 0.0;
    J[73] = 0.0;
    J[74] = 0.0;
    J[75] = 0.0;
    J[76] = 0.0;
    J[77] = 0.0;
    J[78] = 0.0;
    J[79] = 0.0;
    J[80] = 0.0;
    J[81] = 0.0;
    J[82] = 1.0;
    J[83] = 0.0;
    J[84] = 0.0;
    J[85] = 0.0;
    J[86] = 0.0;
    const double z1053 = z90 * z153;
    const double z1054 = z91 * z1053;
    const double z1055 = c * z1054;
    const double z1056 = r_F * z1054;
    const double z1057 = s_lam * z1055 + c_lam * z1056;
    const double z1058 = c_lam * z1055 - s_lam * z1056;
    const double z1059 = c_steer * z1058;
    const double z1060 = k2 * z1054 - s_lam * z1057 - c_lam * z1059;
    const double z1061 = r_R * z1054 - c_lam * z1057 + s_lam * z1059;
    const double z1062 = z512 * z495;
    const double z1063 = z90 * z1062;
    const double z1064 = z469 * (z494 * z1053 - z40 * z1063);
    const double z1065 = z153 * z511 - z92 * z1062;
    const double z1066 = c * z153;
    const double z1067 = r_F * z153;
    const double z1068 = c_lam * z1066 - s_lam * z1067;
    const double z1069 = s_steer * z1068;
    const double z1070 = s_lam * z1066 + c_lam * z1067;
    const double z1071 = c_steer * z1068;
    const double z1072 = k2 * z153 - s_lam * z1070 - c_lam * z1071;
    const double z1073 = r_R * z153 - c_lam * z1070 + s_lam * z1071;
    const double z1074 = s_pitch * z1072 - c_pitch * z1073;
    const double z1075 = z457 * z1060 - z467 * z1061 - z48 * z1064 - z45 * z1065 + z447 * z1069 + z442 *
        z1074;
    const double z1076 = e2z * z1064;
    const double z1077 = z91 * z1063 - z1076;
    const double z1078 = z2 * z1064;
    const double z1079 = e3z * z1064;
    const double z1080 = s_lam * z1078 - c_lam * z1079;
    const double z1081 = c_lam * z1078 + s_lam * z1079;
    const double z1082 = c_steer * z1081 - s_steer * z1076;
    const double z1083 = c_lam * z1080 - s_lam * z1082;
    const double z1084 = c_lam * z1082 + s_lam * z1080;
    const double z1085 = z476 * z1054 - z51 * z1083 + z53 * z1084;
    const double z1086 = c_steer * z1076 + s_steer * z1081;
    const double z1087 = z471 * z1054 - z51 * z1086;
    const double z1088 = z477 * z1054 - z53 * z1086;
    const double z1089 = s_lam * z1087 + c_lam * z1088;
    const double z1090 = z445 * z1058 - s_steer * z1085 - c_steer * z1089;
    const double z1091 = c_lam * z1087 - s_lam * z1088;
    const double z1092 = z492 * z1054 + z36 * z1077 + s_lam * z1090 - c_lam * z1091;
    const double z1093 = e3z * z1065;
    const double z1094 = z2 * z1065;
    const double z1095 = s_lam * z1094 - c_lam * z1093;
    const double z1096 = c_lam * z1094 + s_lam * z1093;
    const double z1097 = e2z * z1065;
    const double z1098 = c_steer * z1096 - s_steer * z1097;
    const double z1099 = c_lam * z1095 - s_lam * z1098;
    const double z1100 = c_lam * z1098 + s_lam * z1095;
    const double z1101 = z153 * z476 - z51 * z1099 + z53 * z1100;
    const double z1102 = c_steer * z1097 + s_steer * z1096;
    const double z1103 = z153 * z471 - z51 * z1102;
    const double z1104 = z153 * z477 - z53 * z1102;
    const double z1105 = s_lam * z1103 + c_lam * z1104;
    const double z1106 = z453 * z153 - z36 * z1093 + R3 * z1094 - z443 * z1068 + c_steer * z1101 - s_steer *
        z1105;
    const double z1107 = z493 * z1054 + R3 * z1077 - c_lam * z1090 - s_lam * z1091;
    const double z1108 = z1062 - z1097;
    const double z1109 = z445 * z1068 - s_steer * z1101 - c_steer * z1105;
    const double z1110 = c_lam * z1103 - s_lam * z1104;
    const double z1111 = z153 * z492 + z36 * z1108 + s_lam * z1109 - c_lam * z1110;
    const double z1112 = z153 * z493 + R3 * z1108 - c_lam * z1109 - s_lam * z1110;
    const double z1113 = z467 * z1072 + z457 * z1073 + c_pitch * z1111 - s_pitch * z1112;
    const double z1114 = s_steer * z1058;
    const double z1115 = s_pitch * z1060 - c_pitch * z1061;
    const double z1116 = z457 * z1072 - z467 * z1073 + z45 * z1064 - z48 * z1065 - z447 * z1114 - z442 *
        z1115;
    const double z1117 = z453 * z1054 - z36 * z1079 + R3 * z1078 - z443 * z1058 + c_steer * z1085 - s_steer *
        z1089;
    const double z1118 = z467 * z1060 + z457 * z1061 + c_pitch * z1092 - s_pitch * z1107;
    const double z1119 = c_yaw * (z1075 + s_pitch * z1092 + c_roll * z1106 + c_pitch * z1107 + e2z * z1113) -
        s_yaw * (z1116 + s_pitch * z1111 - c_roll * z1117 - e2z * z1118 + c_pitch * z1112);
    J[87] = -z1119;
    const double z1120 = e1x * z153 + e1y * z1054;
    const double z1121 = e3x * z153 + e3y * z1054;
    const double z1122 = z38 * z1060 + s_yaw * z1061 - z71 * z1072 + c_yaw * z1073;
    const double z1123 = s_yaw * z1060 - z38 * z1061 + c_yaw * z1072 + z71 * z1073;
    const double z1124 = h2y * z1054 - z80 * z153;
    const double z1125 = s_lam * (z51 * z1124) + c_lam * (z53 * z1124);
    const double z1126 = h1y * z1054 + h1x * z153;
    const double z1127 = h3y * z1054 + h3x * z153;
    const double z1128 = z53 * z1126 - z51 * z1127;
    const double z1129 = R3 * z1120 + z36 * z1121 - c_pitch * z1122 + s_pitch * z1123 - s_steer * z1125 +
        c_steer * z1128;
    const double z1130 = z577 * (z455 * z1129);
    const double z1131 = c_roll * z1130;
    const double z1132 = c_lam * z1131;
    const double z1133 = r_F * z1132;
    const double z1134 = z12 * z1133;
    const double z1135 = s_yaw * z1064 + c_yaw * z1065;
    const double z1136 = z95 * z1129;
    const double z1137 = c * z1136;
    const double z1138 = r_F * z1136;
    const double z1139 = c_lam * z1137 - s_lam * z1138;
    const double z1140 = s_steer * z1139 - c_yaw * z1115 + s_yaw * z1074;
    const double z1141 = r_F * (s_pitch * z1131);
    const double z1142 = z12 * z1141;
    const double z1143 = z73 * z153 - e2y * z1054 - e2z * z1136;
    const double z1144 = z456 * z1120 + z430 * z1143 + e1y * z1077 - e2y * z1078 + e1x * z1108 + z73 * z1094;
    const double z1145 = z456 * z1121 + z429 * z1143 + e2y * z1079 + e3y * z1077 - z73 * z1093 + e3x * z1108;
    const double z1146 = z35 * (z601 * (z39 * z1144 + z33 * z1145));
    const double z1147 = z17 * z1142 - z62 * z1064 - z86 * z1065 - z37 * z1064 + z74 * z1065 + e3z * z1146;
    const double z1148 = z440 * z1136;
    const double z1149 = c_steer * z1141;
    const double z1150 = s_pitch * z1133;
    const double z1151 = c_pitch * z1133;
    const double z1152 = z15 * z1151;
    const double z1153 = z9 * z1136;
    const double z1154 = h2z * z1136;
    const double z1155 = z470 * z1126 - z474 * z1124 - z432 * z1153 - z437 * z1154 - h1y * z1086 - h2y *
        z1084;
    const double z1156 = z1155 - h1x * z1102 + z80 * z1100;
    const double z1157 = z26 * z1141 + z24 * z1149 - z21 * z1133 + 2.0 * (z18 * z1150) - s_steer * z1152 -
        z52 * z1156;
    const double z1158 = z10 * z1136;
    const double z1159 = z475 * z1124 - z470 * z1127 + z439 * z1154 + z432 * z1158 + h2y * z1083 + h3y *
        z1086;
    const double z1160 = z1159 - z80 * z1099 + h3x * z1102;
    const double z1161 = z12 * (z608 * (z1157 - z50 * z1160));
    const double z1162 = z433 * z1136 + z10 * z1161 + r_F * (z12 * z1156);
    const double z1163 = z441 * z1136 - z9 * z1161 - r_F * (z12 * z1160);
    const double z1164 = s_lam * z1162 + c_lam * z1163;
    const double z1165 = z445 * z1139 - s_steer * z1148 - c_steer * z1164;
    const double z1166 = c_lam * z1162 - s_lam * z1163;
    const double z1167 = z1147 - r_R * (z35 * z1144) - s_lam * z1165 + c_lam * z1166;
    const double z1168 = z28 * z1130 - s_lam * (z17 * z1134) + z46 * z1135 - roll_dot * z1140 + c_pitch *
        z1167 + c_yaw * z1117;
    const double z1169 = z64 * z1064 + z88 * z1065 - z41 * z1064 + z75 * z1065 - z2 * z1146 + r_R * (z35 *
        z1145);
    const double z1170 = z13 * z1151;
    const double z1171 = z12 * z1150;
    const double z1172 = z1169 + c_lam * (2.0 * (s_steer * z1170) + z1165) - s_lam * (2.0 * (z17 * z1171) -
        z1166);
    const double z1173 = z12 * z1149;
    const double z1174 = s_lam * (s_steer * z1173) + z453 * z1136 - z63 * z1064 - z87 * z1065 - z47 * z1135 +
        z40 * z1064;
    const double z1175 = s_lam * z1137 + c_lam * z1138;
    const double z1176 = c_steer * z1139;
    const double z1177 = r_R * z1136 - c_lam * z1175 + s_lam * z1176;
    const double z1178 = k2 * z1136 - s_lam * z1175 - c_lam * z1176;
    const double z1179 = c_yaw * z1114 - s_yaw * z1069 - c_pitch * z1177 + s_pitch * z1178;
    const double z1180 = z1170 - z1148;
    const double z1181 = z1174 + z72 * z1065 - z443 * z1139 + roll_dot * z1179 - c_steer * z1180 - s_steer *
        z1164 + c_yaw * z1118;
    J[88] = c_roll * (z1181 - s_yaw * z1113) - e2z * (z1168 - s_yaw * z1106 - s_pitch * z1172);
    const double z1182 = c * z1132;
    const double z1183 = z1 * z1182;
    const double z1184 = z456 * z1123 - z481 * z1060 + z499 * z1072 + z27 * z1131 - s_lam * z1183 - z19 *
        z1133;
    const double z1185 = e2z * z1135;
    const double z1186 = c_yaw * z1064 - s_yaw * z1065;
    const double z1187 = z1124 + z1154;
    const double z1188 = c_lam * (z51 * z1187) - s_lam * (z53 * z1187);
    const double z1189 = z1125 + s_lam * (z51 * z1154) + c_lam * (z53 * z1154);
    const double z1190 = z1128 - z53 * z1153 + z51 * z1158;
    const double z1191 = c_steer * z1189 + s_steer * z1190;
    const double z1192 = c_lam * z1188 + s_lam * z1191 + z36 * z1143;
    const double z1193 = z1184 - z44 * z1185 + z43 * z1186 - z447 * z1178 + roll_dot * z1192 + s_yaw * z1092
        + c_yaw * z1111;
    const double z1194 = z456 * z1122 - z481 * z1061 + z499 * z1073 - w * z1131 - c_lam * z1183 + z16 * z1133;
    const double z1195 = s_lam * z1188 - c_lam * z1191 + R3 * z1143;
    const double z1196 = z1194 - z44 * z1186 - z43 * z1185 - z447 * z1177 - roll_dot * z1195 + c_roll * z1167
        + z38 * z1092;
    const double z1197 = c_pitch * (z1193 + c_roll * z1172 + z38 * z1107 - z71 * z1112) + s_pitch * (z1196 -
        z71 * z1111 - s_yaw * z1107 - c_yaw * z1112);
    J[89] = -z1197;
    const double z1198 = z456 * z1125 + z479 * z1058 - z497 * z1068 + z23 * z1173 + 2.0 * (s_steer * (e3z *
        z1142 - z20 * z1134 + 2.0 * (z7 * z1171)));
    const double z1199 = z1198 - 2.0 * (z3 * z1170) - z12 * z1152 - z431 * z1190 - z59 * z1076 - z54 * z1081;
    const double z1200 = z4 * z1139 - z49 * z1058 - z76 * z1068;
    const double z1201 = z1199 + z83 * z1097 - z77 * z1096 + k7 * (c_roll * z1135) - z442 * z1139 - steer_dot
        * z1200;
    const double z1202 = z1201 + z4 * z1148 - z49 * z1085 - z76 * z1101 - e2z * z1164 - e2y * z1089 + z73 *
        z1105;
    const double z1203 = z488 * z1058 - z506 * z1068 + z456 * z1128 - z25 * z1141 - (z22 * z1182 - c_lam *
        z1150 - s_lam * z1151);
    const double z1204 = z1203 + z450 * z1139 + z431 * z1189 - z59 * z1081 + z54 * z1076 + z83 * z1096 + z77
        * z1097;
    const double z1205 = z1204 + k7 * (c_lam * (c_pitch * z1186 - s_pitch * z1185) - s_lam * (s_pitch * z1186
        + c_pitch * z1185));
    const double z1206 = e2z * z1139 + e2y * z1058 - z73 * z1068;
    const double z1207 = z1205 + steer_dot * z1206 + e2z * z1180 - e2y * z1085 + z73 * z1101 - z4 * z1164 +
        z49 * z1089;
    J[90] = c_steer * z1202 + s_steer * (z1207 + z76 * z1105);
    J[91] = 0.0;
    J[92] = 0.0;
    J[93] = e2z * z1179 - c_roll * z1140 - s_pitch * z1192 - c_pitch * z1195;
    J[94] = -(z1188 + c_steer * z1206 + s_steer * z1200);
    J[95] = -z1128;
    J[96] = 0.0;
    J[97] = 0.0;
    J[98] = 0.0;
    J[99] = 0.0;
    J[100] = 0.0;
    J[101] = 0.0;
    J[102] = 0.0;
    J[103] = 0.0;
    J[104] = 0.0;
    J[105] = 0.0;
    J[106] = 0.0;
    J[107] = 1.0;
    J[108] = 0.0;
    J[109] = 0.0;
    J[110] = 0.0;
    const double z1208 = z206 + z225;
    const double z1209 = z187 + (z157 + z1208);
    const double z1210 = r_F * z225 - z_H * z206;
    const double z1211 = c * z225 + k3 * z206;
    const double z1212 = s_lam * z1210 - c_lam * z1211;
    const double z1213 = s_steer * z1212;
    const double z1214 = z215 + z227;
    const double z1215 = r_F * z227 - z_H * z215;
    const double z1216 = c * z227 + k3 * z215;
    const double z1217 = s_lam * z1215 - c_lam * z1216;
    const double z1218 = c_steer * z1217;
    const double z1219 = c_lam * z1215 + s_lam * z1216;
    const double z1220 = r_R * z1214 - s_lam * z1218 - c_lam * z1219 + k1 * z192;
    const double z1221 = k2 * z1214 + c_lam * z1218 - s_lam * z1219 + x_B * z192;
    const double z1222 = c_steer * z1212;
    const double z1223 = c_lam * z1210 + s_lam * z1211;
    const double z1224 = r_R * z1208 - s_lam * z1222 - c_lam * z1223 + k1 * z187;
    const double z1225 = k2 * z1208 + c_lam * z1222 - s_lam * z1223 + x_B * z187;
    const double z1226 = c_pitch * z1224 - s_pitch * z1225;
    const double z1227 = c_roll * z1213 - s_pitch * z1220 - c_pitch * z1221 - e2z * z1226;
    const double z1228 = s_steer * z1217;
    const double z1229 = c_pitch * z1220 - s_pitch * z1221;
    const double z1230 = c_roll * z1228 - e2z * z1229 + s_pitch * z1224 + c_pitch * z1225;
    const double z1231 = z176 * k24;
    const double z1232 = s_lam * z178 - c_lam * z175;
    const double z1233 = s_steer * z1231 - c_steer * z1232;
    const double z1234 = c_lam * z178 + s_lam * z175;
    const double z1235 = z168 - s_lam * z1233 + c_lam * z1234;
    const double z1236 = z167 + z180 + c_steer * z1231 + s_steer * z1232;
    const double z1237 = z165 + c_lam * z1233 + s_lam * z1234;
    const double z1238 = c_yaw * z1227 + s_yaw * z1230 - e3z * z1235 + e2z * z1236 + z2 * z1237;
    const double z1239 = z192 + (z160 + z1214);
    const double z1240 = z180 + z92 * z1238 + z158 * z1239 - z152 * z1209;
    const double z1241 = z153 * z1240;
    const double z1242 = z1209 + z1241;
    const double z1243 = c * z1242;
    const double z1244 = r_F * z1242;
    const double z1245 = s_lam * z1243 + c_lam * z1244;
    const double z1246 = c_lam * z1243 - s_lam * z1244;
    const double z1247 = c_steer * z1246;
    const double z1248 = k2 * z1242 - s_lam * z1245 - c_lam * z1247;
    const double z1249 = r_R * z1242 - c_lam * z1245 + s_lam * z1247;
    const double z1250 = z1225 - z1248;
    const double z1251 = z1225 + z1250;
    const double z1252 = z1224 - z1249;
    const double z1253 = z1224 + z1252;
    const double z1254 = z512 * z1240;
    const double z1255 = z495 * z1254;
    const double z1256 = z511 * z1241 - z92 * z1255;
    const double z1257 = z1255 - e2z * z1256;
    const double z1258 = z1212 + z1246;
    const double z1259 = z1212 + z1258;
    const double z1260 = z514 * z1209;
    const double z1261 = z1256 + (z511 * z1209 - z92 * z1260);
    const double z1262 = z2 * z1261;
    const double z1263 = e3z * z1261;
    const double z1264 = s_lam * z1262 - c_lam * z1263;
    const double z1265 = c_lam * z1262 + s_lam * z1263;
    const double z1266 = e2z * z1261;
    const double z1267 = c_steer * z1265 - s_steer * z1266;
    const double z1268 = c_lam * z1264 - s_lam * z1267;
    const double z1269 = c_lam * z1267 + s_lam * z1264;
    const double z1270 = z476 * z1242 - z51 * z1268 + z53 * z1269;
    const double z1271 = c_steer * z1266 + s_steer * z1265;
    const double z1272 = z471 * z1242 - z51 * z1271;
    const double z1273 = z477 * z1242 - z53 * z1271;
    const double z1274 = s_lam * z1272 + c_lam * z1273;
    const double z1275 = z445 * z1259 - s_steer * z1270 - c_steer * z1274;
    const double z1276 = c_lam * z1272 - s_lam * z1273;
    const double z1277 = z492 * z1241 + z36 * z1257 + s_lam * z1275 - c_lam * z1276;
    const double z1278 = z493 * z1241 + R3 * z1257 - c_lam * z1275 - s_lam * z1276;
    const double z1279 = z467 * z1251 + z457 * z1253 - c_pitch * z1277 + s_pitch * z1278;
    const double z1280 = s_yaw * z517;
    const double z1281 = c_yaw * z517;
    const double z1282 = z499 - e2z * z1281;
    const double z1283 = z501 + s_pitch * z1280 - (z500 - c_pitch * z1282);
    const double z1284 = z449 - c_roll * z467;
    const double z1285 = r_R * z1284;
    const double z1286 = z448 + c_roll * z457;
    const double z1287 = 2.0 * (z2 * z1284) + 2.0 * (e3z * z1286);
    const double z1288 = z35 * z1287;
    const double z1289 = z1288 * z601;
    const double z1290 = z35 * z1285 - 0.5 * (z33 * z1289);
    const double z1291 = z504 - c_pitch * z1280 + (z503 + s_pitch * z1282);
    const double z1292 = r_R * z1286;
    const double z1293 = z35 * z1292 - 0.5 * (z39 * z1289);
    const double z1294 = z36 * z1283 - e3x * z1290 - (R3 * z1291 + e1x * z1293);
    const double z1295 = z497 + c_roll * z1281;
    const double z1296 = z36 * z1295 + z73 * z1290;
    const double z1297 = R3 * z1295 + z73 * z1293;
    const double z1298 = z74 * z1286 + e3z * z1296 - (z442 * z72 + e2z * z1294) - (z75 * z1284 + z2 * z1297);
    const double z1299 = z443 * k7;
    const double z1300 = z445 * k7;
    const double z1301 = s_lam * z1300;
    const double z1302 = c_lam * z1300;
    const double z1303 = z43 * z457 - c_pitch * z1301 + (z44 * z467 - s_pitch * z1302);
    const double z1304 = z447 * z46 - c_roll * z1299 + (z442 * z47 - e2z * z1303);
    const double z1305 = z43 * z467 + s_pitch * z1301 - (z44 * z457 + c_pitch * z1302);
    const double z1306 = s_lam * z1291 - c_lam * z1283;
    const double z1307 = c_lam * z1291 + s_lam * z1283;
    const double z1308 = z498 + c_steer * z1307 + (z496 - s_steer * z1295);
    const double z1309 = c_lam * z1306 - s_lam * z1308;
    const double z1310 = c_lam * z1284;
    const double z1311 = z1310 + s_lam * z1286;
    const double z1312 = z444 + (z446 + c_steer * z1311);
    const double z1313 = s_lam * z1284;
    const double z1314 = z1313 - c_lam * z1286;
    const double z1315 = c_lam * z1312 + s_lam * z1314;
    const double z1316 = r_F * z1315;
    const double z1317 = c_lam * z1314 - s_lam * z1312;
    const double z1318 = 2.0 * (z9 * z1315) + 2.0 * (z10 * z1317);
    const double z1319 = z12 * z1318;
    const double z1320 = z1319 * z608;
    const double z1321 = z12 * z1316 - 0.5 * (z50 * z1320);
    const double z1322 = c_lam * z1308 + s_lam * z1306;
    const double z1323 = r_F * z1317;
    const double z1324 = z12 * z1323 - 0.5 * (z52 * z1320);
    const double z1325 = z51 * z1309 + h3x * z1321 - (z53 * z1322 + h1x * z1324);
    const double z1326 = c_steer * z1295 + z73 * z445 + (s_steer * z1307 - z76 * z443);
    const double z1327 = z51 * z1326 + z80 * z1321;
    const double z1328 = z53 * z1326 + z80 * z1324;
    const double z1329 = s_lam * z1327 + c_lam * z1328;
    const double z1330 = z443 * z77 - s_steer * z1325 - (z445 * z83 + c_steer * z1329);
    const double z1331 = c_lam * z1327 - s_lam * z1328;
    const double z1332 = s_lam * z1330 - c_lam * z1331;
    const double z1333 = z48 * z1280 - c_yaw * z1304 - (z45 * z1281 - s_yaw * z1305) + (z86 * z1286 - e3z *
        z1332);
    const double z1334 = z445 * z77 + c_steer * z1325 + (z443 * z83 - s_steer * z1329);
    const double z1335 = c_lam * z1330 + s_lam * z1331;
    const double z1336 = z1333 - (z442 * z87 - e2z * z1334) + (z88 * z1284 - z2 * z1335);
    const double z1337 = z1298 - z1336;
    const double z1338 = z481 + e2z * z1280;
    const double z1339 = z483 - s_pitch * z1281 + (z482 - c_pitch * z1338);
    const double z1340 = z486 + c_pitch * z1281 - (z485 + s_pitch * z1338);
    const double z1341 = z36 * z1339 - e3y * z1290 - (R3 * z1340 + e1y * z1293);
    const double z1342 = z479 - c_roll * z1280;
    const double z1343 = z36 * z1342 + e2y * z1290;
    const double z1344 = R3 * z1342 + e2y * z1293;
    const double z1345 = z37 * z1286 + e3z * z1343 + (z442 * z40 + e2z * z1341) - (z41 * z1284 + z2 * z1344);
    const double z1346 = s_lam * z1340 - c_lam * z1339;
    const double z1347 = c_lam * z1340 + s_lam * z1339;
    const double z1348 = z480 + c_steer * z1347 - (z478 - s_steer * z1342);
    const double z1349 = c_lam * z1346 - s_lam * z1348;
    const double z1350 = c_lam * z1348 + s_lam * z1346;
    const double z1351 = z51 * z1349 + h3y * z1321 - (z53 * z1350 + h1y * z1324);
    const double z1352 = c_steer * z1342 + e2y * z445 + (z49 * z443 - s_steer * z1347);
    const double z1353 = z51 * z1352 + h2y * z1321;
    const double z1354 = z53 * z1352 + h2y * z1324;
    const double z1355 = s_lam * z1353 + c_lam * z1354;
    const double z1356 = z443 * z54 - s_steer * z1351 + (z445 * z59 + c_steer * z1355);
    const double z1357 = c_lam * z1353 - s_lam * z1354;
    const double z1358 = s_lam * z1356 + c_lam * z1357;
    const double z1359 = z45 * z1280 + c_yaw * z1305 + (z48 * z1281 + s_yaw * z1304) - (z62 * z1286 - e3z *
        z1358);
    const double z1360 = z445 * z54 + c_steer * z1351 - (z443 * z59 - s_steer * z1355);
    const double z1361 = c_lam * z1356 - s_lam * z1357;
    const double z1362 = z1359 + (z442 * z63 - e2z * z1360) - (z64 * z1284 - z2 * z1361);
    const double z1363 = z1345 - z1362;
    const double z1364 = z1363 * z469;
    const double z1365 = z91 * z1341 + z40 * z1364;
    const double z1366 = z1294 - (z92 * z1337 - z90 * z1365);
    const double z1367 = z1366 * z495;
    const double z1368 = z92 * z1362 + z65 * z1365;
    const double z1369 = z92 * z1336 + z89 * z1365;
    const double z1370 = z442 * z162 + c_roll * z517;
    const double z1371 = R_yy * z1370;
    const double w1 = z430 + z2 * z517;
    const double w3 = z429 - e3z * z517;
    const double z1372 = c_lam * w1 - s_lam * w3;
    const double w2 = z456 - e2z * z517;
    const double wf = c_steer * z1372 + s_steer * w2;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double o1 = c_lam * wf + s_lam * ws;
    const double o3 = c_lam * ws - s_lam * wf;
    const double z1373 = H_xz * o1 + 2.0 * (k20 * o3);
    const double z1374 = s_lam * c_steer;
    const double z1375 = s_lam * z1374 + k19;
    const double z1376 = s_lam * s_steer;
    const double z1377 = c_lam * (s_lam - z1374);
    const double z1378 = z1375 * z195 + c_roll * z1376 - z1377 * z194;
    const double z1379 = c_lam * s_steer;
    const double z1380 = c_roll * c_steer - z1376 * z195 - z1379 * z194;
    const double o2 = c_steer * w2 - s_steer * z1372;
    const double z1381 = F_yy * (thF_dot + o2);
    const double z1382 = H_yy * o2;
    const double z1383 = z1381 + z1382;
    const double z1384 = H_xz * o3 + 2.0 * (k21 * o1);
    const double z1385 = c_lam * c_steer;
    const double z1386 = s_lam * (c_lam - z1385);
    const double z1387 = c_lam * z1385 + k18;
    const double z1388 = z1386 * z195 - c_roll * z1379 - z1387 * z194;
    const double z1389 = B_xz * w1 + 2.0 * (k23 * w3);
    const double z1390 = B_yy * w2;
    const double z1391 = R_yy * (z514 + w2);
    const double z1392 = z1390 + z1391;
    const double z1393 = B_xz * w3 + 2.0 * (k22 * w1);
    const double z1394 = z1373 * z1378 - z1380 * z1383 + z1384 * z1388 + z1389 * z195 - c_roll * z1392 -
        z1393 * z194;
    const double z1395 = z1238 - z90 * z1241 + z65 * z1239 - z89 * z1209;
    const double z1396 = z91 * z1395;
    const double z1397 = z1239 - z1396;
    const double z1398 = c * z1397;
    const double z1399 = r_F * z1397;
    const double z1400 = s_lam * z1398 + c_lam * z1399;
    const double z1401 = c_lam * z1398 - s_lam * z1399;
    const double z1402 = c_steer * z1401;
    const double z1403 = k2 * z1397 - s_lam * z1400 - c_lam * z1402;
    const double z1404 = z1221 - z1403;
    const double z1405 = z1221 + z1404;
    const double z1406 = r_R * z1397 - c_lam * z1400 + s_lam * z1402;
    const double z1407 = z1220 - z1406;
    const double z1408 = z1220 + z1407;
    const double z1409 = z514 * z1239;
    const double z1410 = z514 * z1238 - z90 * z1255 + z65 * z1409 - z89 * z1260;
    const double z1411 = z494 * z1395 - z40 * z1410;
    const double z1412 = z469 * z1411;
    const double z1413 = z511 * z1239 - z92 * z1409 - z1412;
    const double z1414 = s_steer * z1259;
    const double z1415 = z517 * z1230 - z457 * z1405 + z467 * z1408 - z48 * z1413 - z45 * z1261 + z447 *
        z1414;
    const double z1416 = z1226 + s_pitch * z1248 - c_pitch * z1249;
    const double z1417 = z1226 + z1416;
    const double z1418 = e3z * z1256;
    const double z1419 = z2 * z1256;
    const double z1420 = z453 * z1241 - z36 * z1418 + R3 * z1419 - z443 * z1259 + c_steer * z1270 - s_steer *
        z1274;
    const double z1421 = z91 * z1410 - e2z * z1412;
    const double z1422 = z1217 + z1401;
    const double z1423 = z1217 + z1422;
    const double z1424 = z2 * z1413;
    const double z1425 = e3z * z1413;
    const double z1426 = s_lam * z1424 - c_lam * z1425;
    const double z1427 = c_lam * z1424 + s_lam * z1425;
    const double z1428 = e2z * z1413;
    const double z1429 = c_steer * z1427 - s_steer * z1428;
    const double z1430 = c_lam * z1426 - s_lam * z1429;
    const double z1431 = c_lam * z1429 + s_lam * z1426;
    const double z1432 = z476 * z1397 - z51 * z1430 + z53 * z1431;
    const double z1433 = c_steer * z1428 + s_steer * z1427;
    const double z1434 = z471 * z1397 - z51 * z1433;
    const double z1435 = z477 * z1397 - z53 * z1433;
    const double z1436 = s_lam * z1434 + c_lam * z1435;
    const double z1437 = z445 * z1423 - s_steer * z1432 - c_steer * z1436;
    const double z1438 = c_lam * z1434 - s_lam * z1435;
    const double z1439 = z492 * z1396 + z36 * z1421 - s_lam * z1437 + c_lam * z1438;
    const double z1440 = z493 * z1396 + R3 * z1421 + c_lam * z1437 + s_lam * z1438;
    const double z1441 = z1415 + z442 * z1417 + c_roll * z1420 - s_pitch * z1439 - c_pitch * z1440 - e2z *
        z1279;
    const double z1442 = z1394 - z1280 * z1227 + z1281 * z1230 - z1286 * z1235 - z442 * z1236 + z1284 * z1237
        + c_yaw * z1441;
    const double z1443 = s_steer * z1423;
    const double z1444 = z517 * z1227 - z457 * z1251 + z467 * z1253 + z45 * z1413 - z48 * z1261 - z447 *
        z1443;
    const double z1445 = z1229 + s_pitch * z1403 - c_pitch * z1406;
    const double z1446 = z1229 + z1445;
    const double z1447 = e3z * z1412;
    const double z1448 = z2 * z1412;
    const double z1449 = z453 * z1396 - z36 * z1447 + R3 * z1448 + z443 * z1423 - c_steer * z1432 + s_steer *
        z1436;
    const double z1450 = z467 * z1405 + z457 * z1408 + c_pitch * z1439 - s_pitch * z1440;
    const double z1451 = z1444 - z442 * z1446 + c_roll * z1449 + e2z * z1450 + s_pitch * z1277 + c_pitch *
        z1278;
    const double z1452 = z467 - z162 * z1286 - (z517 * z195 - roll_dot * z126);
    const double z1453 = z457 - z162 * z1284 - (z517 * z194 - roll_dot * z124);
    const double z1454 = s_lam * z443;
    const double z1455 = c_lam * z443;
    const double z1456 = c_steer * z442 - e2z * z445;
    const double z1457 = z1456 - (z1376 * z1286 - e3z * z1454) - (z1379 * z1284 - z2 * z1455);
    const double z1458 = z445 * z116 + (z467 * z1376 + s_pitch * z1454 + (z457 * z1379 - c_pitch * z1455) +
        z162 * z1457);
    const double z1459 = z126 * z1376 + z124 * z1379;
    const double z1460 = z1458 + (z517 * z1380 + roll_dot * z1459);
    const double z1461 = z1460 * k24;
    const double z1462 = s_lam * z445;
    const double z1463 = s_lam * z1462;
    const double z1464 = c_lam * z1462;
    const double z1465 = z1375 * z1286 + e3z * z1463 + (z442 * z1376 + e2z * z1454) - (z1377 * z1284 - z2 *
        z1464);
    const double z1466 = z116 * z1454 + (z467 * z1375 - s_pitch * z1463 - (z457 * z1377 - c_pitch * z1464) -
        z162 * z1465);
    const double z1467 = z126 * z1375 - z124 * z1377;
    const double z1468 = z1466 - (z517 * z1378 - roll_dot * z1467);
    const double z1469 = c_lam * z445;
    const double z1470 = s_lam * z1469;
    const double z1471 = c_lam * z1469;
    const double z1472 = z1386 * z1286 - e3z * z1470 - (z442 * z1379 + e2z * z1455) - (z1387 * z1284 + z2 *
        z1471);
    const double z1473 = z116 * z1455 - (z467 * z1386 + s_pitch * z1470 - (z457 * z1387 + c_pitch * z1471) -
        z162 * z1472);
    const double z1474 = z126 * z1386 - z124 * z1387;
    const double z1475 = z1473 + (z517 * z1388 - roll_dot * z1474);
    const double z1476 = 2.0 * (k20 * z1468) - H_xz * z1475;
    const double z1477 = 2.0 * (k21 * z1475) - H_xz * z1468;
    const double z1478 = s_lam * z1476 + c_lam * z1477;
    const double z1479 = z443 * z1231 + z445 * z1232 - s_steer * z1461 - c_steer * z1478;
    const double z1480 = c_lam * z1476 - s_lam * z1477;
    const double z1481 = 2.0 * (k23 * z1452) - B_xz * z1453 - s_lam * z1479 + c_lam * z1480;
    const double z1482 = z1371 + (z445 * z1231 - z443 * z1232 + B_yy * z1370) + c_steer * z1461 - s_steer *
        z1478;
    const double z1483 = 2.0 * (k22 * z1453) - B_xz * z1452 - c_lam * z1479 - s_lam * z1480;
    const double z1484 = z1442 - s_yaw * z1451 + e3z * z1481 + e2z * z1482 + z2 * z1483;
    const double z1485 = z1365 * z1238 + z1368 * z1239 - z1369 * z1209 - z1371 - z92 * z1484;
    const double z1486 = z1367 * z1240 - z153 * z1485;
    const double z1487 = c * z1486;
    const double z1488 = r_F * z1486;
    const double z1489 = s_lam * z1487 + c_lam * z1488;
    const double z1490 = c_lam * z1487 - s_lam * z1488;
    const double z1491 = z445 * z1246 + c_steer * z1490;
    const double z1492 = k2 * z1486 - s_lam * z1489 - c_lam * z1491;
    const double z1493 = r_R * z1486 - c_lam * z1489 + s_lam * z1491;
    const double z1494 = z467 * z1248 + z457 * z1249 - z1279 - s_pitch * z1492 + c_pitch * z1493;
    const double z1495 = z443 * z1246 - z1420 - s_steer * z1490;
    const double z1496 = z1337 * z1241 + z1362 * z1239 - z1336 * z1209 - z1484 + z90 * z1486;
    const double z1497 = z1364 * z1395 + z91 * z1496;
    const double z1498 = c * z1497;
    const double z1499 = r_F * z1497;
    const double z1500 = s_lam * z1498 + c_lam * z1499;
    const double z1501 = c_lam * z1498 - s_lam * z1499;
    const double z1502 = z445 * z1401 + c_steer * z1501;
    const double z1503 = r_R * z1497 - c_lam * z1500 + s_lam * z1502;
    const double z1504 = z1439 - z1503;
    const double z1505 = k2 * z1497 - s_lam * z1500 - c_lam * z1502;
    const double z1506 = z1440 - z1505;
    const double z1507 = roll_dot * z467;
    const double z1508 = roll_dot * z457;
    const double z1509 = s_lam * z1507 + c_lam * z1508;
    const double z1510 = z443 * z431 + s_steer * z1509;
    const double z1511 = z443 * z12 + 0.5 * (s_steer * z1320);
    const double z1512 = z1456 + 2.0 * (z3 * z443 - s_steer * z1310);
    const double z1513 = z1462 - (z15 * z1511 + z13 * z1512);
    const double z1514 = s_steer * z443;
    const double z1515 = z17 * z1313 - 2.0 * (z7 * z1514);
    const double z1516 = z1469 + 2.0 * (0.5 * (z18 * z1320) - z12 * z1515);
    const double z1517 = s_lam * z447;
    const double z1518 = 2.0 * (z20 * z1514) - z17 * z1517;
    const double z1519 = z16 * z457 - c_pitch * z1513 - (z19 * z467 + s_pitch * z1516 - (0.5 * (z21 * z1320)
        + z12 * z1518));
    const double z1520 = c_lam * z457 + s_lam * z467;
    const double z1521 = s_lam * z442;
    const double z1522 = z443 * z23 + s_steer * z1521;
    const double z1523 = 0.5 * (z24 * z1320) + z12 * z1522;
    const double z1524 = z17 * z1286 - 2.0 * (e3z * z1514);
    const double z1525 = r_F * (z445 * z25 - c_steer * z1523 - (0.5 * (z26 * z1320) - z12 * z1524));
    const double z1526 = c_lam * (r_F * z1519 + c * (z445 * z22 - z1 * z1520)) + (z27 * z467 + s_pitch *
        z1525 - w * z457);
    const double z1527 = z447 * z28 + c_roll * z1526;
    const double z1528 = z1527 * z577;
    const double z1529 = z432 * z1321 - z51 * z1510;
    const double z1530 = z1456 + (z4 * z443 - s_steer * z1311);
    const double z1531 = c_lam * z1507 - s_lam * z1508;
    const double z1532 = s_lam * z1531;
    const double z1533 = z445 * z431 - c_steer * z1509;
    const double z1534 = z1532 + c_lam * z1533;
    const double z1535 = c_lam * z1531;
    const double z1536 = s_lam * z1533 - z1535;
    const double z1537 = z437 * z1324 - z53 * z1534 - (z439 * z1321 + z51 * z1536);
    const double z1538 = z432 * z1324 - z53 * z1510;
    const double z1539 = z442 * z443;
    const double z1540 = roll_dot * z447;
    const double z1541 = steer_dot * z445;
    const double z1542 = z1539 - s_steer * z1540 + (z1539 - e2z * z1541);
    const double z1543 = z445 * z1311;
    const double z1544 = steer_dot * z443;
    const double z1545 = z1543 - z4 * z1544;
    const double z1546 = z447 * z457;
    const double z1547 = roll_dot * z442;
    const double z1548 = z1546 - c_pitch * z1547;
    const double z1549 = z447 * z467;
    const double z1550 = z1549 + s_pitch * z1547;
    const double z1551 = s_lam * z1548 - c_lam * z1550;
    const double z1552 = z1542 - (z1545 + (z445 * z450 + c_steer * z1551));
    const double z1553 = c_lam * z1548 + s_lam * z1550;
    const double z1554 = R3 * z1508 + z430 * z1293 - (z36 * z1507 - z429 * z1290);
    const double z1555 = z442 * z453 - e2z * z1554;
    const double z1556 = r_F * (s_lam * z1552 - c_lam * z1553) - (c * (s_lam * z1553 + c_lam * z1552) - (r_R
        * z1548 + (z1555 + k2 * z1550)));
    const double z1557 = z433 * z1317 + z10 * z1529 + (z440 * z1530 - h2z * z1537 - (z441 * z1315 + z9 *
        z1538 - z1556));
    const double z1558 = z455 * z1528 - z95 * z1557;
    const double z1559 = z1510 - (z445 * z456 - c_steer * z1558);
    const double z1560 = z470 * z1321 - z51 * z1559;
    const double z1561 = z1533 + (z443 * z456 + s_steer * z1558);
    const double z1562 = z1532 + c_lam * z1561;
    const double z1563 = z1535 - s_lam * z1561;
    const double z1564 = z474 * z1324 - z53 * z1562 - (z475 * z1321 - z51 * z1563);
    const double z1565 = z470 * z1324 - z53 * z1559;
    const double z1566 = z443 * z1342;
    const double z1567 = z1566 + e2y * z1541;
    const double z1568 = z447 * z1280;
    const double z1569 = z1568 + c_yaw * z1547;
    const double z1570 = z445 * z1347;
    const double z1571 = z1570 - z49 * z1544;
    const double z1572 = z442 * z1280;
    const double z1573 = z1572 - c_yaw * z1540;
    const double z1574 = z457 * z1338;
    const double z1575 = z456 * z467 + s_pitch * z1558;
    const double z1576 = z1574 + z38 * z1575;
    const double z1577 = z467 * z1281;
    const double z1578 = z456 * z457 - c_pitch * z1558;
    const double z1579 = z1577 + s_yaw * z1578;
    const double z1580 = z481 * z457 - c_pitch * z1573 + z1576 - z1579;
    const double z1581 = z467 * z1338;
    const double z1582 = z1581 - z38 * z1578;
    const double z1583 = z457 * z1281;
    const double z1584 = z1583 - s_yaw * z1575;
    const double z1585 = z481 * z467 + s_pitch * z1573 + z1582 + z1584;
    const double z1586 = s_lam * z1580 - c_lam * z1585;
    const double z1587 = z1567 + (z443 * z479 + s_steer * z1569) - (z1571 - (z445 * z488 + c_steer * z1586));
    const double z1588 = c_lam * z1580 + s_lam * z1585;
    const double z1589 = r_F * (s_lam * z1587 + c_lam * z1588) + (c * (s_lam * z1588 - c_lam * z1587) - (r_R
        * z1580 + k2 * z1585));
    const double z1590 = z471 * z1349 + h3y * z1560 + (z476 * z1352 + h2y * z1564 - (z477 * z1350 + h1y *
        z1565 - z1589));
    const double z1591 = z456 * z1290 - z36 * z1558;
    const double z1592 = z456 * z1293 - R3 * z1558;
    const double z1593 = z492 * z1339 - e3y * z1591 + (z453 * z1342 + e2y * z1554 - (z493 * z1340 + e1y *
        z1592));
    const double z1594 = z1590 + z1593;
    const double z1595 = z494 * z1364 - z91 * z1594;
    const double z1596 = z443 * z1295;
    const double z1597 = z1596 + z73 * z1541;
    const double z1598 = z447 * z1281;
    const double z1599 = z1598 - s_yaw * z1547;
    const double z1600 = z445 * z1307;
    const double z1601 = z1600 - z76 * z1544;
    const double z1602 = z442 * z1281;
    const double z1603 = z1602 + s_yaw * z1540;
    const double z1604 = z457 * z1282;
    const double z1605 = z1604 + z71 * z1575;
    const double z1606 = z467 * z1280;
    const double z1607 = z1606 - c_yaw * z1578;
    const double z1608 = z499 * z457 + c_pitch * z1603 + z1605 - z1607;
    const double z1609 = z467 * z1282;
    const double z1610 = z1609 - z71 * z1578;
    const double z1611 = z457 * z1280;
    const double z1612 = z1611 + c_yaw * z1575;
    const double z1613 = z499 * z467 - s_pitch * z1603 + z1610 + z1612;
    const double z1614 = s_lam * z1608 - c_lam * z1613;
    const double z1615 = z1597 + (z497 * z443 - s_steer * z1599) + (z1601 + (z445 * z506 + c_steer * z1614));
    const double z1616 = c_lam * z1608 + s_lam * z1613;
    const double z1617 = r_F * (s_lam * z1615 + c_lam * z1616) + (c * (s_lam * z1616 - c_lam * z1615) - (r_R
        * z1608 + k2 * z1613));
    const double z1618 = z471 * z1309 + h3x * z1560 - (z476 * z1326 + z80 * z1564 + (z477 * z1322 + h1x *
        z1565 + z1617));
    const double z1619 = z492 * z1283 - e3x * z1591 - (z453 * z1295 + z73 * z1554 + (z493 * z1291 + e1x *
        z1592));
    const double z1620 = z1618 + z1619 + (z511 * z1337 - z90 * z1595);
    const double z1621 = z512 * z1367 + z153 * z1620;
    const double z1622 = z1595 - (z514 * z1365 - z92 * z1621);
    const double z1623 = s_steer * z1258;
    const double z1624 = z1622 * z1230 - z1575 * z1404 - z1578 * z1407 + z1304 * z1413 - z1305 * z1261 +
        z1547 * z1623;
    const double z1625 = 1.0 / z428;
    const double z1626 = z362 * z1457;
    const double z1627 = z1558 - (z442 * z517 + e2z * z1622);
    const double z1628 = z1508 + (z517 * z1284 - z2 * z1622);
    const double z1629 = z1507 + (z517 * z1286 - e3z * z1622);
    const double z1630 = c_lam * z1628 + s_lam * z1629;
    const double z1631 = z445 * w2 - c_steer * z1627 + (z443 * z1372 - s_steer * z1630);
    const double z1632 = F_yy * z1631;
    const double z1633 = z1590 + (z511 * z1362 + z65 * z1595) - (z514 * z1368 - z158 * z1621);
    const double z1634 = z517 * z1280 + c_yaw * z1622;
    const double z1635 = z517 * z1281 - s_yaw * z1622;
    const double z1636 = z1573 + (z1572 - e2z * z1635);
    const double z1637 = z1584 + (z1583 - c_pitch * z1634) + (z1582 + (z1581 + s_pitch * z1636));
    const double z1638 = z1579 + (z1577 + s_pitch * z1634) - (z1576 + (z1574 - c_pitch * z1636));
    const double z1639 = z1633 + k2 * z1637 - r_R * z1638;
    const double z1640 = c_lam * z1637 + s_lam * z1638;
    const double z1641 = z1569 + (z1568 + c_roll * z1635);
    const double z1642 = z1571 + (z1570 + c_steer * z1640) - (z1567 + (z1566 + s_steer * z1641));
    const double z1643 = s_lam * z1637 - c_lam * z1638;
    const double z1644 = c_lam * z1642 + s_lam * z1643;
    const double z1645 = c_lam * z1643 - s_lam * z1642;
    const double z1646 = m_F * (z1639 - c * z1644 - r_F * z1645);
    const double z1647 = z1618 - (z511 * z1336 + z89 * z1595) + (z514 * z1369 - z152 * z1621);
    const double z1648 = z1603 + (z1602 + e2z * z1634);
    const double z1649 = z1612 + (z1611 + c_pitch * z1635) + (z1610 + (z1609 - s_pitch * z1648));
    const double z1650 = z1607 + (z1606 - s_pitch * z1635) - (z1605 + (z1604 + c_pitch * z1648));
    const double z1651 = z1647 - k2 * z1649 + r_R * z1650;
    const double z1652 = c_lam * z1649 + s_lam * z1650;
    const double z1653 = z1599 + (z1598 - c_roll * z1634);
    const double z1654 = z1601 + (z1600 - c_steer * z1652) + (z1597 + (z1596 - s_steer * z1653));
    const double z1655 = s_lam * z1649 - c_lam * z1650;
    const double z1656 = c_lam * z1654 - s_lam * z1655;
    const double z1657 = c_lam * z1655 + s_lam * z1654;
    const double z1658 = m_F * (z1651 - c * z1656 + r_F * z1657);
    const double z1659 = m_H * (z1639 - k3 * z1644 + z_H * z1645);
    const double z1660 = m_H * (z1651 - k3 * z1656 - z_H * z1657);
    const double z1661 = m_B * (z1633 + x_B * z1637 - k1 * z1638);
    const double z1662 = m_B * (z1647 - x_B * z1649 + k1 * z1650);
    const double z1663 = z442 * z362;
    const double z1664 = R_yy * (z1621 - z1627);
    const double z1665 = z362 * z1465;
    const double z1666 = z445 * z1372 + c_steer * z1630 - (z443 * w2 + s_steer * z1627);
    const double z1667 = s_lam * z1628 - c_lam * z1629;
    const double z1668 = c_lam * z1666 + s_lam * z1667;
    const double z1669 = c_lam * z1667 - s_lam * z1666;
    const double z1670 = H_xz * z1668 + 2.0 * (k20 * z1669);
    const double z1671 = H_yy * z1631;
    const double z1672 = z362 * z1472;
    const double z1673 = 2.0 * (k21 * z1668) + H_xz * z1669;
    const double z1674 = z362 * z1286;
    const double z1675 = B_xz * z1628 - 2.0 * (k23 * z1629);
    const double z1676 = B_yy * z1627;
    const double z1677 = z362 * z1284;
    const double z1678 = 2.0 * (k22 * z1628) - B_xz * z1629;
    const double z1679 = m_R * z1647;
    const double z1680 = m_R * z1633;
    const double z1681 = z1390 * z1663 + (z366 * z1676 + (z1393 * z1677 + (z363 * z1678 + (z358 * z1679 +
        z360 * z1680))));
    const double z1682 = z1382 * z1626 - (z376 * z1671 + (z1384 * z1672 - (z372 * z1673 - (z1389 * z1674 +
        (z364 * z1675 - z1681)))));
    const double z1683 = z391 * z1661 + (z386 * z1662 + (z1391 * z1663 + (z379 * z1664 - (z1373 * z1665 -
        (z373 * z1670 + z1682)))));
    const double z1684 = z1381 * z1626 + (z416 * z1632 + (z414 * z1646 + (z412 * z1658 + (z410 * z1659 +
        (z400 * z1660 + z1683)))));
    const double z1685 = z1550 + (z1549 + c_roll * z1578);
    const double z1686 = z1548 + (z1546 - c_roll * z1575);
    const double z1687 = z1555 + k2 * z1685 + r_R * z1686;
    const double z1688 = c_lam * z1685 - s_lam * z1686;
    const double z1689 = z1542 - (z1545 + (z1543 - c_steer * z1688));
    const double z1690 = s_lam * z1685 + c_lam * z1686;
    const double z1691 = c_lam * z1689 + s_lam * z1690;
    const double z1692 = c_lam * z1690 - s_lam * z1689;
    const double z1693 = m_F * (z1687 - c * z1691 - r_F * z1692);
    const double z1694 = m_H * (z1687 - k3 * z1691 + z_H * z1692);
    const double z1695 = m_B * (z1555 + x_B * z1685 + k1 * z1686);
    const double z1696 = m_R * z1555;
    const double z1697 = z166 * z1676 + (z1393 * z1453 + (z163 * z1678 - (z113 * z1696 + (z156 * z1679 + z159
        * z1680))));
    const double z1698 = z176 * z1671 - (z1384 * z1475 + (z173 * z1673 - (z1389 * z1452 - (z164 * z1675 -
        (z1390 * z1370 - z1697)))));
    const double z1699 = z186 * z1662 + (z1391 * z1370 + (z179 * z1664 + (z1373 * z1468 - (z174 * z1670 -
        (z1382 * z1460 + z1698)))));
    const double z1700 = z224 * z1658 + (z222 * z1694 + (z214 * z1659 + (z205 * z1660 + (z196 * z1695 + (z191
        * z1661 + z1699)))));
    const double z1701 = z1381 * z1460 + (z176 * z1632 + (z229 * z1693 + (z226 * z1646 + z1700))) - g * (z230
        + (z223 + (z161 + z197)));
    const double z1702 = z5 - (z1376 * z309 + e3z * z1374) + (z1379 * z308 - z2 * z1385);
    const double z1703 = z245 * z1376 - s_pitch * z1374 + (z243 * z1379 + c_pitch * z1385);
    const double z1704 = z277 * z1457 + z445 * z235 + (z472 - (z517 * z1702 - roll_dot * z1703));
    const double z1705 = z442 * z277;
    const double z1706 = s_lam * z1376;
    const double z1707 = c_lam * z1376;
    const double z1708 = z1375 * z309 - e3z * z1706 - e2z * z1374 + (z1377 * z308 - z2 * z1707);
    const double z1709 = z245 * z1375 + s_pitch * z1706 - (z243 * z1377 + c_pitch * z1707);
    const double z1710 = z277 * z1465 - z235 * z1454 - (z456 * z1374 + (z517 * z1708 + roll_dot * z1709));
    const double z1711 = s_lam * z1379;
    const double z1712 = c_lam * z1379;
    const double z1713 = z1386 * z309 + e3z * z1711 + e2z * z1385 + (z1387 * z308 + z2 * z1712);
    const double z1714 = z245 * z1386 - s_pitch * z1711 - (z243 * z1387 - c_pitch * z1712);
    const double z1715 = z277 * z1472 + z235 * z1455 + (z456 * z1385 - (z517 * z1713 + roll_dot * z1714));
    const double z1716 = z277 * z1286 - (z517 * z309 + roll_dot * z245);
    const double z1717 = z277 * z1284 + (z517 * z308 - roll_dot * z243);
    const double z1718 = z1390 * z1705 - (z281 * z1676 - (z1393 * z1717 + (z278 * z1678 + (z273 * z1679 +
        z275 * z1680))));
    const double z1719 = z1382 * z1704 + (z291 * z1671 - (z1384 * z1715 - (z287 * z1673 - (z1389 * z1716 +
        (z279 * z1675 - z1718)))));
    const double z1720 = z306 * z1661 + (z301 * z1662 + (z1391 * z1705 + (z294 * z1664 - (z1373 * z1710 +
        (z288 * z1670 - z1719)))));
    const double z1721 = z341 * z1646 + (z339 * z1658 + (z337 * z1694 + (z329 * z1659 + (z320 * z1660 + (z310
        * z1695 + z1720)))));
    const double z1722 = z1381 * z1704 + (z291 * z1632 + (z343 * z1693 + z1721)) - g * (z344 + (z311 + z338))
        - z1701 * z353;
    const double z1723 = z1625 * (z1684 - z1701 * z422 - z427 * z1722);
    const double z1724 = m_F * (z226 * z1723);
    const double z1725 = m_H * (z214 * z1723);
    const double z1726 = r_F * z1724 - z_H * z1725;
    const double z1727 = c * z1724 + k3 * z1725;
    const double z1728 = s_lam * z1726 - c_lam * z1727;
    const double z1729 = s_steer * z1728;
    const double z1730 = z1724 + z1725;
    const double z1731 = c_steer * z1728;
    const double z1732 = c_lam * z1726 + s_lam * z1727;
    const double z1733 = m_B * (z191 * z1723);
    const double z1734 = r_R * z1730 - s_lam * z1731 - c_lam * z1732 + k1 * z1733;
    const double z1735 = k2 * z1730 + c_lam * z1731 - s_lam * z1732 + x_B * z1733;
    const double z1736 = c_pitch * z1734 - s_pitch * z1735;
    const double z1737 = m_F * (z224 * z1723);
    const double z1738 = m_H * (z205 * z1723);
    const double z1739 = z1737 + z1738;
    const double z1740 = r_F * z1737 - z_H * z1738;
    const double z1741 = c * z1737 + k3 * z1738;
    const double z1742 = s_lam * z1740 - c_lam * z1741;
    const double z1743 = c_steer * z1742;
    const double z1744 = c_lam * z1740 + s_lam * z1741;
    const double z1745 = m_B * (z186 * z1723);
    const double z1746 = r_R * z1739 - s_lam * z1743 - c_lam * z1744 + k1 * z1745;
    const double z1747 = k2 * z1739 + c_lam * z1743 - s_lam * z1744 + x_B * z1745;
    const double z1748 = c_roll * z1729 - e2z * z1736 + s_pitch * z1746 + c_pitch * z1747;
    const double z1749 = z426 * z1722 - z427 * z1723;
    const double z1750 = m_F * (z226 * z1749);
    const double z1751 = m_H * (z214 * z1749);
    const double z1752 = r_F * z1750 - z_H * z1751;
    const double z1753 = c * z1750 + k3 * z1751;
    const double z1754 = s_lam * z1752 - c_lam * z1753;
    const double z1755 = s_steer * z1754;
    const double z1756 = z1750 + z1751;
    const double z1757 = c_steer * z1754;
    const double z1758 = c_lam * z1752 + s_lam * z1753;
    const double z1759 = m_B * (z191 * z1749);
    const double z1760 = r_R * z1756 - s_lam * z1757 - c_lam * z1758 + k1 * z1759;
    const double z1761 = k2 * z1756 + c_lam * z1757 - s_lam * z1758 + x_B * z1759;
    const double z1762 = c_pitch * z1760 - s_pitch * z1761;
    const double z1763 = m_F * (z224 * z1749);
    const double z1764 = m_H * (z205 * z1749);
    const double z1765 = z1763 + z1764;
    const double z1766 = r_F * z1763 - z_H * z1764;
    const double z1767 = c * z1763 + k3 * z1764;
    const double z1768 = s_lam * z1766 - c_lam * z1767;
    const double z1769 = c_steer * z1768;
    const double z1770 = c_lam * z1766 + s_lam * z1767;
    const double z1771 = m_B * (z186 * z1749);
    const double z1772 = r_R * z1765 - s_lam * z1769 - c_lam * z1770 + k1 * z1771;
    const double z1773 = k2 * z1765 + c_lam * z1769 - s_lam * z1770 + x_B * z1771;
    const double z1774 = c_roll * z1755 - e2z * z1762 + s_pitch * z1772 + c_pitch * z1773;
    const double z1775 = z1646 - z415 * z1723;
    const double z1776 = z1775 - z342 * z1749;
    const double z1777 = z1701 * z352 - z353 * z1749 - z422 * z1723;
    const double z1778 = z226 * z1777;
    const double z1779 = z1776 - z227 * z1777 - m_F * z1778;
    const double z1780 = z1659 - z411 * z1723;
    const double z1781 = z1780 - z330 * z1749;
    const double z1782 = z214 * z1777;
    const double z1783 = z1781 - z215 * z1777 - m_H * z1782;
    const double z1784 = r_F * z1779 - z_H * z1783;
    const double z1785 = c * z1779 + k3 * z1783;
    const double z1786 = s_lam * z1784 - c_lam * z1785;
    const double z1787 = s_steer * z1786;
    const double z1788 = z1779 + z1783;
    const double z1789 = c_steer * z1786;
    const double z1790 = c_lam * z1784 + s_lam * z1785;
    const double z1791 = z1661 - z392 * z1723;
    const double z1792 = z1791 - z307 * z1749;
    const double z1793 = z191 * z1777;
    const double z1794 = z1792 - z192 * z1777 - m_B * z1793;
    const double z1795 = r_R * z1788 - s_lam * z1789 - c_lam * z1790 + k1 * z1794;
    const double z1796 = k2 * z1788 + c_lam * z1789 - s_lam * z1790 + x_B * z1794;
    const double z1797 = c_pitch * z1795 - s_pitch * z1796;
    const double z1798 = z1658 - z413 * z1723;
    const double z1799 = z1798 - z340 * z1749;
    const double z1800 = z224 * z1777;
    const double z1801 = z1799 - z225 * z1777 - m_F * z1800;
    const double z1802 = z1660 - z401 * z1723;
    const double z1803 = z1802 - z321 * z1749;
    const double z1804 = z205 * z1777;
    const double z1805 = z1803 - z206 * z1777 - m_H * z1804;
    const double z1806 = z1801 + z1805;
    const double z1807 = r_F * z1801 - z_H * z1805;
    const double z1808 = c * z1801 + k3 * z1805;
    const double z1809 = s_lam * z1807 - c_lam * z1808;
    const double z1810 = c_steer * z1809;
    const double z1811 = c_lam * z1807 + s_lam * z1808;
    const double z1812 = z1662 - z387 * z1723;
    const double z1813 = z1812 - z302 * z1749;
    const double z1814 = z186 * z1777;
    const double z1815 = z1813 - z187 * z1777 - m_B * z1814;
    const double z1816 = r_R * z1806 - s_lam * z1810 - c_lam * z1811 + k1 * z1815;
    const double z1817 = k2 * z1806 + c_lam * z1810 - s_lam * z1811 + x_B * z1815;
    const double z1818 = c_roll * z1787 - e2z * z1797 + s_pitch * z1816 + c_pitch * z1817;
    const double z1819 = z457 * z1506 + (z517 * z1451 + (z1624 - z1540 * z1416 + z362 * z1748 + z277 * z1774
        - z162 * z1818));
    const double z1820 = z1759 + (m_R * (z159 * z1749) + z1756);
    const double z1821 = s_steer * z1768;
    const double z1822 = c_pitch * z1772 - s_pitch * z1773;
    const double z1823 = c_roll * z1821 - s_pitch * z1760 - c_pitch * z1761 - e2z * z1822;
    const double z1824 = z164 * z1749;
    const double z1825 = z163 * z1749;
    const double z1826 = k24 * (z176 * z1749);
    const double z1827 = z174 * z1749;
    const double z1828 = z173 * z1749;
    const double z1829 = 2.0 * (k20 * z1827) + H_xz * z1828;
    const double z1830 = H_xz * z1827 + 2.0 * (k21 * z1828);
    const double z1831 = s_lam * z1829 - c_lam * z1830;
    const double z1832 = s_steer * z1826 - c_steer * z1831;
    const double z1833 = c_lam * z1829 + s_lam * z1830;
    const double z1834 = 2.0 * (k23 * z1824) + B_xz * z1825 - s_lam * z1832 + c_lam * z1833;
    const double z1835 = R_yy * (z179 * z1749);
    const double z1836 = z1835 + B_yy * (z166 * z1749) + c_steer * z1826 + s_steer * z1831;
    const double z1837 = B_xz * z1824 + 2.0 * (k22 * z1825) + c_lam * z1832 + s_lam * z1833;
    const double z1838 = c_yaw * z1823 + s_yaw * z1774 - e3z * z1834 + e2z * z1836 + z2 * z1837;
    const double z1839 = z1771 + (m_R * (z156 * z1749) + z1765);
    const double z1840 = z1835 + z92 * z1838 + z158 * z1820 - z152 * z1839;
    const double z1841 = z153 * z1840;
    const double z1842 = z1838 - z90 * z1841 + z65 * z1820 - z89 * z1839;
    const double z1843 = z91 * z1842;
    const double z1844 = z1820 - z1843;
    const double z1845 = c * z1844;
    const double z1846 = r_F * z1844;
    const double z1847 = s_lam * z1845 + c_lam * z1846;
    const double z1848 = c_lam * z1845 - s_lam * z1846;
    const double z1849 = c_steer * z1848;
    const double z1850 = z1761 - (k2 * z1844 - s_lam * z1847 - c_lam * z1849);
    const double z1851 = z1760 - (r_R * z1844 - c_lam * z1847 + s_lam * z1849);
    const double z1852 = z1680 - z361 * z1723;
    const double z1853 = z1852 - z276 * z1749;
    const double z1854 = z159 * z1777;
    const double z1855 = z1794 + (z1853 - z160 * z1777 - m_R * z1854 + z1788);
    const double z1856 = z1373 * z1465 - z1457 * z1383 + z1384 * z1472 + z1286 * z1389 - z442 * z1392 - z1284
        * z1393;
    const double z1857 = s_steer * z1809;
    const double z1858 = c_pitch * z1816 - s_pitch * z1817;
    const double z1859 = c_roll * z1857 - s_pitch * z1795 - c_pitch * z1796 - e2z * z1858;
    const double z1860 = z1675 - z368 * z1723;
    const double z1861 = z1860 - z283 * z1749;
    const double z1862 = z164 * z1777;
    const double z1863 = z163 * z1777;
    const double z1864 = z417 * z1723;
    const double z1865 = z377 * z1723;
    const double z1866 = z1631 * k24 - z1864 + z1865 - z346 * z1749 - z292 * z1749;
    const double z1867 = z176 * z1777;
    const double z1868 = z1866 - z231 * z1777 - F_yy * z1867 - z177 * z1777 - H_yy * z1867;
    const double z1869 = z1670 - z378 * z1723;
    const double z1870 = z1869 - z293 * z1749;
    const double z1871 = z174 * z1777;
    const double z1872 = z173 * z1777;
    const double z1873 = z1870 + z178 * z1777 + 2.0 * (k20 * z1871) + H_xz * z1872;
    const double z1874 = z1673 - z374 * z1723;
    const double z1875 = z1874 - z289 * z1749;
    const double z1876 = z1875 + H_xz * z1871 + z175 * z1777 + 2.0 * (k21 * z1872);
    const double z1877 = s_lam * z1873 - c_lam * z1876;
    const double z1878 = s_steer * z1868 + c_steer * z1877;
    const double z1879 = c_lam * z1873 + s_lam * z1876;
    const double z1880 = z1861 + z168 * z1777 + 2.0 * (k23 * z1862) + B_xz * z1863 + s_lam * z1878 + c_lam *
        z1879;
    const double z1881 = z1664 - z380 * z1723;
    const double z1882 = z1881 - z295 * z1749;
    const double z1883 = z179 * z1777;
    const double z1884 = z1882 - z180 * z1777 - R_yy * z1883;
    const double z1885 = z1676 - z367 * z1723;
    const double z1886 = z1885 + z282 * z1749;
    const double z1887 = z166 * z1777;
    const double z1888 = z1884 - (z1886 + z167 * z1777 + B_yy * z1887) + c_steer * z1868 - s_steer * z1877;
    const double z1889 = z1678 - z365 * z1723;
    const double z1890 = z1889 - z280 * z1749;
    const double z1891 = z1890 + B_xz * z1862 + z165 * z1777 + 2.0 * (k22 * z1863) - c_lam * z1878 + s_lam *
        z1879;
    const double z1892 = z1856 + c_yaw * z1859 + s_yaw * z1818 + e3z * z1880 + e2z * z1888 - z2 * z1891;
    const double z1893 = z1679 - z359 * z1723;
    const double z1894 = z1893 - z274 * z1749;
    const double z1895 = z156 * z1777;
    const double z1896 = z1815 + (z1894 - z157 * z1777 - m_R * z1895 + z1806);
    const double z1897 = z1884 + z92 * z1892 + z158 * z1855 - z152 * z1896;
    const double z1898 = z153 * z1897;
    const double z1899 = z1892 - z90 * z1898 + z65 * z1855 - z89 * z1896;
    const double z1900 = z91 * z1899;
    const double z1901 = z1855 - z1900;
    const double z1902 = c * z1901;
    const double z1903 = r_F * z1901;
    const double z1904 = s_lam * z1902 + c_lam * z1903;
    const double z1905 = c_lam * z1902 - s_lam * z1903;
    const double z1906 = c_steer * z1905;
    const double z1907 = k2 * z1901 - s_lam * z1904 - c_lam * z1906;
    const double z1908 = z1796 - z1907;
    const double z1909 = r_R * z1901 - c_lam * z1904 + s_lam * z1906;
    const double z1910 = z1795 - z1909;
    const double z1911 = z1733 + (m_R * (z159 * z1723) + z1730);
    const double z1912 = z1621 * z1239 - z357 * z1911 - z272 * z1820 + z155 * z1855;
    const double z1913 = z1595 * z1239 - z1365 * z1409 + z355 * z1911 + z270 * z1820 - z151 * z1855 + z92 *
        z1912;
    const double z1914 = 1.0 / (z66 * z66 * z66);
    const double z1915 = s_steer * z1742;
    const double z1916 = c_pitch * z1746 - s_pitch * z1747;
    const double z1917 = c_roll * z1915 - s_pitch * z1734 - c_pitch * z1735 - e2z * z1916;
    const double z1918 = z164 * z1723;
    const double z1919 = z163 * z1723;
    const double z1920 = k24 * (z176 * z1723);
    const double z1921 = z174 * z1723;
    const double z1922 = z173 * z1723;
    const double z1923 = 2.0 * (k20 * z1921) + H_xz * z1922;
    const double z1924 = H_xz * z1921 + 2.0 * (k21 * z1922);
    const double z1925 = s_lam * z1923 - c_lam * z1924;
    const double z1926 = s_steer * z1920 - c_steer * z1925;
    const double z1927 = c_lam * z1923 + s_lam * z1924;
    const double z1928 = 2.0 * (k23 * z1918) + B_xz * z1919 - s_lam * z1926 + c_lam * z1927;
    const double z1929 = R_yy * (z179 * z1723);
    const double z1930 = z1929 + (B_yy * (z166 * z1723) + c_steer * z1920 + s_steer * z1925);
    const double z1931 = B_xz * z1918 + 2.0 * (k22 * z1919) + c_lam * z1926 + s_lam * z1927;
    const double z1932 = c_yaw * z1917 + s_yaw * z1748 - e3z * z1928 + e2z * z1930 + z2 * z1931;
    const double z1933 = z1745 + (m_R * (z156 * z1723) + z1739);
    const double z1934 = z1929 + z92 * z1932 + z158 * z1911 - z152 * z1933;
    const double z1935 = z153 * z1934;
    const double z1936 = z1932 - z90 * z1935 + z65 * z1911 - z89 * z1933;
    const double z1937 = z1594 * z1395 + z1341 * z1410 - z494 * z1496 - z54 * z1936 - z269 * z1842 + z150 *
        z1899;
    const double z1938 = z1621 * z1238 - z1337 * z1255 - z1362 * z1409 + z1336 * z1260 + z514 * z1484 - z357
        * z1932;
    const double z1939 = 1.0 / (z93 * z93 * z93);
    const double z1940 = 2.0 * (z1366 * z1254 * z1939) + z495 * (z1620 * z1240 - z512 * z1485 - z356 * z1934
        - z271 * z1840 + z154 * z1897);
    const double z1941 = z1621 * z1209 - z357 * z1933 - z272 * z1839 + z155 * z1896;
    const double z1942 = z1938 - z272 * z1838 + z155 * z1892 - z90 * z1940 + z65 * z1912 - z89 * z1941;
    const double z1943 = 2.0 * (z1363 * z1411 * z1914) - z469 * (z1937 - z40 * z1942);
    const double z1944 = z1913 - z1943;
    const double z1945 = z467 * z1504 - z1819 + z243 * z1850 - z245 * z1851 - z124 * z1908 + z126 * z1910 +
        z48 * z1944;
    const double z1946 = z1595 * z1241 - z1365 * z1255 - z511 * z1486 + z355 * z1935 + z270 * z1841 - z151 *
        z1898;
    const double z1947 = z1946 + z92 * z1940;
    const double z1948 = z1595 * z1209 - z1365 * z1260 + z355 * z1933 + z270 * z1839 - z151 * z1896 + z92 *
        z1941;
    const double z1949 = z1947 + z1948;
    const double z1950 = z1364 * z1410 - z442 * z1412 - z91 * z1942 - e2z * z1943;
    const double z1951 = z1591 * z1396 + z1290 * z1421 - z492 * z1497 - z267 * z1843 + z148 * z1900 - z36 *
        z1950;
    const double z1952 = z1436 - z1501;
    const double z1953 = z1564 * z1397 - z1321 * z1430 + z1324 * z1431 + z476 * z1497 + z241 * z1844 - z122 *
        z1901;
    const double z1954 = z1284 * z1413 - z2 * z1944;
    const double z1955 = z1286 * z1413 - e3z * z1944;
    const double z1956 = s_lam * z1954 - c_lam * z1955;
    const double z1957 = c_lam * z1954 + s_lam * z1955;
    const double z1958 = z442 * z1413 + e2z * z1944;
    const double z1959 = z445 * z1427 + z443 * z1428 + c_steer * z1957 + s_steer * z1958;
    const double z1960 = c_lam * z1956 - s_lam * z1959;
    const double z1961 = c_lam * z1959 + s_lam * z1956;
    const double z1962 = z1754 + z1848 - (z1953 - z51 * z1960 + z53 * z1961);
    const double z1963 = z445 * z1428 - z443 * z1427 + z1911 - z91 * z1936 - c_steer * z1958 + s_steer *
        z1957;
    const double z1964 = z1560 * z1397 - z1321 * z1433 + z471 * z1497 - z237 * z1844 + z118 * z1901 - z51 *
        z1963;
    const double z1965 = z1565 * z1397 - z1324 * z1433 + z477 * z1497 - z242 * z1844 + z123 * z1901 - z53 *
        z1963;
    const double z1966 = s_lam * z1964 + c_lam * z1965;
    const double z1967 = z1544 * z1422 - z443 * z1432 + z445 * z1952 - s_steer * z1962 + c_steer * z1966;
    const double z1968 = c_lam * z1964 - s_lam * z1965;
    const double z1969 = z1951 + s_lam * z1967 + c_lam * z1968;
    const double z1970 = z1274 - z1490;
    const double z1971 = z1554 * z1241 - z1290 * z1418 + z1293 * z1419 - z1541 * z1258 + z445 * z1270 - z1858
        - z112 * z1898;
    const double z1972 = z1896 + z1898;
    const double z1973 = c * z1972;
    const double z1974 = r_F * z1972;
    const double z1975 = s_lam * z1973 + c_lam * z1974;
    const double z1976 = c_lam * z1973 - s_lam * z1974;
    const double z1977 = c_steer * z1976;
    const double z1978 = k2 * z1972 - s_lam * z1975 - c_lam * z1977;
    const double z1979 = r_R * z1972 - c_lam * z1975 + s_lam * z1977;
    const double z1980 = z1286 * z1256 - e3z * z1947;
    const double z1981 = z1284 * z1256 - z2 * z1947;
    const double z1982 = z443 * z1970 + (z453 * z1486 + (z1971 - s_pitch * z1978 + c_pitch * z1979) - z36 *
        z1980 + R3 * z1981);
    const double z1983 = z1839 + z1841;
    const double z1984 = c * z1983;
    const double z1985 = r_F * z1983;
    const double z1986 = c_lam * z1984 - s_lam * z1985;
    const double z1987 = z1564 * z1242 - z1321 * z1268 + z1324 * z1269 + z476 * z1486 + z241 * z1983 - z122 *
        z1972;
    const double z1988 = z1284 * z1261 - z2 * z1949;
    const double z1989 = z1286 * z1261 - e3z * z1949;
    const double z1990 = s_lam * z1988 - c_lam * z1989;
    const double z1991 = c_lam * z1988 + s_lam * z1989;
    const double z1992 = z442 * z1261 + e2z * z1949;
    const double z1993 = z445 * z1265 + z443 * z1266 + c_steer * z1991 + s_steer * z1992;
    const double z1994 = c_lam * z1990 - s_lam * z1993;
    const double z1995 = c_lam * z1993 + s_lam * z1990;
    const double z1996 = z1768 + z1986 - (z1987 - z51 * z1994 + z53 * z1995);
    const double z1997 = z1933 + (z445 * z1266 - z443 * z1265 + z1935) - c_steer * z1992 + s_steer * z1991;
    const double z1998 = z1560 * z1242 - z1321 * z1271 + z471 * z1486 - z237 * z1983 + z118 * z1972 - z51 *
        z1997;
    const double z1999 = z1565 * z1242 - z1324 * z1271 + z477 * z1486 - z242 * z1983 + z123 * z1972 - z53 *
        z1997;
    const double z2000 = s_lam * z1998 + c_lam * z1999;
    const double z2001 = z1982 - c_steer * z1996 - s_steer * z2000;
    const double z2002 = z1592 * z1396 + z1293 * z1421 - z493 * z1497 - z268 * z1843 + z149 * z1900 - R3 *
        z1950;
    const double z2003 = z2002 - c_lam * z1967 + s_lam * z1968;
    const double z2004 = z442 * z1494 + (z447 * z1495 - (z1945 + z45 * z1949)) + s_pitch * z1969 - c_roll *
        z2001 + c_pitch * z2003;
    const double z2005 = z1277 + z1493;
    const double z2006 = z1278 + z1492;
    const double z2007 = s_lam * z1984 + c_lam * z1985;
    const double z2008 = c_steer * z1986;
    const double z2009 = z1773 - (k2 * z1983 - s_lam * z2007 - c_lam * z2008);
    const double z2010 = z1772 - (r_R * z1983 - c_lam * z2007 + s_lam * z2008);
    const double z2011 = z457 * z2005 + (z467 * z2006 - (z1578 * z1250 - z1575 * z1252 + z1857)) + z245 *
        z2009 + z243 * z2010;
    const double z2012 = z1817 - z1978;
    const double z2013 = z1816 - z1979;
    const double z2014 = z442 * z1256 + z1940 + e2z * z1947;
    const double z2015 = z1591 * z1241 + z1290 * z1257 + z492 * z1486 - z267 * z1841 + z148 * z1898 + z36 *
        z2014;
    const double z2016 = z1544 * z1258 - z443 * z1270 + z445 * z1970 - s_steer * z1996 + c_steer * z2000;
    const double z2017 = c_lam * z1998 - s_lam * z1999;
    const double z2018 = z2015 - s_lam * z2016 - c_lam * z2017;
    const double z2019 = z1592 * z1241 + z1293 * z1257 + z493 * z1486 - z268 * z1841 + z149 * z1898 + R3 *
        z2014;
    const double z2020 = z2019 + c_lam * z2016 - s_lam * z2017;
    const double z2021 = z2011 - z126 * z2012 - z124 * z2013 - s_steer * z1976 + c_pitch * z2018 - s_pitch *
        z2020;
    const double z2022 = z467 * z1403 + z457 * z1406 - z1450 - s_pitch * z1505 + c_pitch * z1503;
    const double z2023 = z443 * z1401 + z1449 - s_steer * z1501;
    const double z2024 = s_steer * z1422;
    const double z2025 = z1622 * z1227 - z1575 * z1250 - z1578 * z1252 + z1305 * z1413 + z1304 * z1261 -
        z1547 * z2024;
    const double z2026 = z457 * z2006 + (z517 * z1441 - (z2025 + z1540 * z1445 + z362 * z1917 + z277 * z1823
        - z162 * z1859));
    const double z2027 = z467 * z2005 - z2026 - z243 * z2009 + z245 * z2010 + z124 * z2012 - z126 * z2013 +
        z45 * z1944;
    const double z2028 = z1554 * z1396 - z1290 * z1447 + z1293 * z1448 + z1541 * z1422 - z445 * z1432 + z1797
        - z112 * z1900;
    const double z2029 = z1286 * z1412 - e3z * z1943;
    const double z2030 = z1284 * z1412 - z2 * z1943;
    const double z2031 = z443 * z1952 + (z453 * z1497 - (z2028 + s_pitch * z1907 - c_pitch * z1909) + z36 *
        z2029 - R3 * z2030);
    const double z2032 = z2031 - c_steer * z1962 - s_steer * z1966;
    const double z2033 = z457 * z1504 + (z467 * z1506 + (z1578 * z1404 - z1575 * z1407 + z1787)) - z245 *
        z1850 - z243 * z1851;
    const double z2034 = z2033 + z126 * z1908 + z124 * z1910 + s_steer * z1905 + c_pitch * z1969 - s_pitch *
        z2003;
    const double z2035 = z442 * z2022 + (z447 * z2023 - (z2027 - z48 * z1949)) + s_pitch * z2018 - c_roll *
        z2032 + e2z * z2034;
    const double z2036 = c_yaw * (z2004 - e2z * z2021) + s_yaw * (z2035 + c_pitch * z2020);
    const double z2037 = z321 + z340;
    const double z2038 = z302 + (z274 + z2037);
    const double z2039 = r_F * z340 - z_H * z321;
    const double z2040 = c * z340 + k3 * z321;
    const double z2041 = s_lam * z2039 - c_lam * z2040;
    const double z2042 = s_steer * z2041;
    const double z2043 = z330 + z342;
    const double z2044 = r_F * z342 - z_H * z330;
    const double z2045 = c * z342 + k3 * z330;
    const double z2046 = s_lam * z2044 - c_lam * z2045;
    const double z2047 = c_steer * z2046;
    const double z2048 = c_lam * z2044 + s_lam * z2045;
    const double z2049 = r_R * z2043 - s_lam * z2047 - c_lam * z2048 + k1 * z307;
    const double z2050 = k2 * z2043 + c_lam * z2047 - s_lam * z2048 + x_B * z307;
    const double z2051 = c_steer * z2041;
    const double z2052 = c_lam * z2039 + s_lam * z2040;
    const double z2053 = r_R * z2037 - s_lam * z2051 - c_lam * z2052 + k1 * z302;
    const double z2054 = k2 * z2037 + c_lam * z2051 - s_lam * z2052 + x_B * z302;
    const double z2055 = c_pitch * z2053 - s_pitch * z2054;
    const double z2056 = c_roll * z2042 - s_pitch * z2049 - c_pitch * z2050 - e2z * z2055;
    const double z2057 = s_steer * z2046;
    const double z2058 = c_pitch * z2049 - s_pitch * z2050;
    const double z2059 = c_roll * z2057 - e2z * z2058 + s_pitch * z2053 + c_pitch * z2054;
    const double z2060 = z291 * k24;
    const double z2061 = s_lam * z293 - c_lam * z289;
    const double z2062 = s_steer * z2060 + c_steer * z2061;
    const double z2063 = c_lam * z293 + s_lam * z289;
    const double z2064 = z283 + s_lam * z2062 + c_lam * z2063;
    const double z2065 = z282 + z295;
    const double z2066 = z2065 + c_steer * z2060 - s_steer * z2061;
    const double z2067 = z280 - c_lam * z2062 + s_lam * z2063;
    const double z2068 = c_yaw * z2056 + s_yaw * z2059 + e3z * z2064 + e2z * z2066 - z2 * z2067;
    const double z2069 = z307 + (z276 + z2043);
    const double z2070 = z295 + z92 * z2068 + z158 * z2069 - z152 * z2038;
    const double z2071 = z153 * z2070;
    const double z2072 = z2038 + z2071;
    const double z2073 = c * z2072;
    const double z2074 = r_F * z2072;
    const double z2075 = s_lam * z2073 + c_lam * z2074;
    const double z2076 = c_lam * z2073 - s_lam * z2074;
    const double z2077 = c_steer * z2076;
    const double z2078 = k2 * z2072 - s_lam * z2075 - c_lam * z2077;
    const double z2079 = r_R * z2072 - c_lam * z2075 + s_lam * z2077;
    const double z2080 = z2054 - z2078;
    const double z2081 = z2054 + z2080;
    const double z2082 = z2053 - z2079;
    const double z2083 = z2053 + z2082;
    const double z2084 = z512 * z2070;
    const double z2085 = z495 * z2084;
    const double z2086 = z511 * z2071 - z92 * z2085;
    const double z2087 = z2085 - e2z * z2086;
    const double z2088 = z2041 + z2076;
    const double z2089 = z2041 + z2088;
    const double z2090 = z514 * z2038;
    const double z2091 = z2086 + (z511 * z2038 - z92 * z2090);
    const double z2092 = z2 * z2091;
    const double z2093 = e3z * z2091;
    const double z2094 = s_lam * z2092 - c_lam * z2093;
    const double z2095 = c_lam * z2092 + s_lam * z2093;
    const double z2096 = e2z * z2091;
    const double z2097 = c_steer * z2095 - s_steer * z2096;
    const double z2098 = c_lam * z2094 - s_lam * z2097;
    const double z2099 = c_lam * z2097 + s_lam * z2094;
    const double z2100 = z476 * z2072 - z51 * z2098 + z53 * z2099;
    const double z2101 = c_steer * z2096 + s_steer * z2095;
    const double z2102 = z471 * z2072 - z51 * z2101;
    const double z2103 = z477 * z2072 - z53 * z2101;
    const double z2104 = s_lam * z2102 + c_lam * z2103;
    const double z2105 = z445 * z2089 - s_steer * z2100 - c_steer * z2104;
    const double z2106 = c_lam * z2102 - s_lam * z2103;
    const double z2107 = z492 * z2071 + z36 * z2087 + s_lam * z2105 - c_lam * z2106;
    const double z2108 = z493 * z2071 + R3 * z2087 - c_lam * z2105 - s_lam * z2106;
    const double z2109 = z467 * z2081 + z457 * z2083 - c_pitch * z2107 + s_pitch * z2108;
    const double z2110 = R_yy * z1705;
    const double z2111 = z1373 * z1708 - z1702 * z1383 + z1384 * z1713 + z1389 * z309 + z1393 * z308 + z1280
        * z2056;
    const double z2112 = z2068 - z90 * z2071 + z65 * z2069 - z89 * z2038;
    const double z2113 = z91 * z2112;
    const double z2114 = z2069 - z2113;
    const double z2115 = c * z2114;
    const double z2116 = r_F * z2114;
    const double z2117 = s_lam * z2115 + c_lam * z2116;
    const double z2118 = c_lam * z2115 - s_lam * z2116;
    const double z2119 = c_steer * z2118;
    const double z2120 = k2 * z2114 - s_lam * z2117 - c_lam * z2119;
    const double z2121 = z2050 - z2120;
    const double z2122 = z2050 + z2121;
    const double z2123 = r_R * z2114 - c_lam * z2117 + s_lam * z2119;
    const double z2124 = z2049 - z2123;
    const double z2125 = z2049 + z2124;
    const double z2126 = z514 * z2069;
    const double z2127 = z514 * z2068 - z90 * z2085 + z65 * z2126 - z89 * z2090;
    const double z2128 = z494 * z2112 - z40 * z2127;
    const double z2129 = z469 * z2128;
    const double z2130 = z511 * z2069 - z92 * z2126 - z2129;
    const double z2131 = s_steer * z2089;
    const double z2132 = z517 * z2059 - z457 * z2122 + z467 * z2125 - z48 * z2130 - z45 * z2091 + z447 *
        z2131;
    const double z2133 = z2055 + s_pitch * z2078 - c_pitch * z2079;
    const double z2134 = z2055 + z2133;
    const double z2135 = e3z * z2086;
    const double z2136 = z2 * z2086;
    const double z2137 = z453 * z2071 - z36 * z2135 + R3 * z2136 - z443 * z2089 + c_steer * z2100 - s_steer *
        z2104;
    const double z2138 = z91 * z2127 - e2z * z2129;
    const double z2139 = z2046 + z2118;
    const double z2140 = z2046 + z2139;
    const double z2141 = z2 * z2130;
    const double z2142 = e3z * z2130;
    const double z2143 = s_lam * z2141 - c_lam * z2142;
    const double z2144 = c_lam * z2141 + s_lam * z2142;
    const double z2145 = e2z * z2130;
    const double z2146 = c_steer * z2144 - s_steer * z2145;
    const double z2147 = c_lam * z2143 - s_lam * z2146;
    const double z2148 = c_lam * z2146 + s_lam * z2143;
    const double z2149 = z476 * z2114 - z51 * z2147 + z53 * z2148;
    const double z2150 = c_steer * z2145 + s_steer * z2144;
    const double z2151 = z471 * z2114 - z51 * z2150;
    const double z2152 = z477 * z2114 - z53 * z2150;
    const double z2153 = s_lam * z2151 + c_lam * z2152;
    const double z2154 = z445 * z2140 - s_steer * z2149 - c_steer * z2153;
    const double z2155 = c_lam * z2151 - s_lam * z2152;
    const double z2156 = z492 * z2113 + z36 * z2138 - s_lam * z2154 + c_lam * z2155;
    const double z2157 = z493 * z2113 + R3 * z2138 + c_lam * z2154 + s_lam * z2155;
    const double z2158 = z2132 + z442 * z2134 + c_roll * z2137 - s_pitch * z2156 - c_pitch * z2157 - e2z *
        z2109;
    const double z2159 = s_steer * z2140;
    const double z2160 = z517 * z2056 - z457 * z2081 + z467 * z2083 + z45 * z2130 - z48 * z2091 - z447 *
        z2159;
    const double z2161 = z2058 + s_pitch * z2120 - c_pitch * z2123;
    const double z2162 = z2058 + z2161;
    const double z2163 = e3z * z2129;
    const double z2164 = z2 * z2129;
    const double z2165 = z453 * z2113 - z36 * z2163 + R3 * z2164 + z443 * z2140 - c_steer * z2149 + s_steer *
        z2153;
    const double z2166 = z467 * z2122 + z457 * z2125 + c_pitch * z2156 - s_pitch * z2157;
    const double z2167 = z2160 - z442 * z2162 + c_roll * z2165 + e2z * z2166 + s_pitch * z2107 + c_pitch *
        z2108;
    const double z2168 = z2111 - z1281 * z2059 - z1286 * z2064 + z442 * z2066 + z1284 * z2067 - c_yaw * z2158
        + s_yaw * z2167;
    const double z2169 = z1704 * k24;
    const double z2170 = 2.0 * (k20 * z1710) + H_xz * z1715;
    const double z2171 = 2.0 * (k21 * z1715) + H_xz * z1710;
    const double z2172 = s_lam * z2170 - c_lam * z2171;
    const double z2173 = z443 * z2060 - z445 * z2061 - s_steer * z2169 + c_steer * z2172;
    const double z2174 = c_lam * z2170 + s_lam * z2171;
    const double z2175 = 2.0 * (k23 * z1716) - B_xz * z1717 + s_lam * z2173 + c_lam * z2174;
    const double z2176 = z2110 + (z445 * z2060 + z443 * z2061 + B_yy * z1705) + c_steer * z2169 + s_steer *
        z2172;
    const double z2177 = 2.0 * (k22 * z1717) - B_xz * z1716 + c_lam * z2173 - s_lam * z2174;
    const double z2178 = z2168 + e3z * z2175 - e2z * z2176 + z2 * z2177;
    const double z2179 = z1365 * z2068 + z1368 * z2069 - z1369 * z2038 - z2110 + z92 * z2178;
    const double z2180 = z1367 * z2070 - z153 * z2179;
    const double z2181 = c * z2180;
    const double z2182 = r_F * z2180;
    const double z2183 = s_lam * z2181 + c_lam * z2182;
    const double z2184 = c_lam * z2181 - s_lam * z2182;
    const double z2185 = z445 * z2076 + c_steer * z2184;
    const double z2186 = k2 * z2180 - s_lam * z2183 - c_lam * z2185;
    const double z2187 = r_R * z2180 - c_lam * z2183 + s_lam * z2185;
    const double z2188 = z467 * z2078 + z457 * z2079 - z2109 - s_pitch * z2186 + c_pitch * z2187;
    const double z2189 = z443 * z2076 - z2137 - s_steer * z2184;
    const double z2190 = z1337 * z2071 + z1362 * z2069 - z1336 * z2038 + z2178 + z90 * z2180;
    const double z2191 = z1364 * z2112 + z91 * z2190;
    const double z2192 = c * z2191;
    const double z2193 = r_F * z2191;
    const double z2194 = s_lam * z2192 + c_lam * z2193;
    const double z2195 = c_lam * z2192 - s_lam * z2193;
    const double z2196 = z445 * z2118 + c_steer * z2195;
    const double z2197 = r_R * z2191 - c_lam * z2194 + s_lam * z2196;
    const double z2198 = z2156 - z2197;
    const double z2199 = k2 * z2191 - s_lam * z2194 - c_lam * z2196;
    const double z2200 = z2157 - z2199;
    const double z2201 = s_steer * z2088;
    const double z2202 = z1622 * z2059 - z1575 * z2121 - z1578 * z2124 + z1304 * z2130 - z1305 * z2091 +
        z1547 * z2201;
    const double z2203 = m_F * (z341 * z1723);
    const double z2204 = m_H * (z329 * z1723);
    const double z2205 = r_F * z2203 - z_H * z2204;
    const double z2206 = c * z2203 + k3 * z2204;
    const double z2207 = s_lam * z2205 - c_lam * z2206;
    const double z2208 = s_steer * z2207;
    const double z2209 = z2203 + z2204;
    const double z2210 = c_steer * z2207;
    const double z2211 = c_lam * z2205 + s_lam * z2206;
    const double z2212 = m_B * (z306 * z1723);
    const double z2213 = r_R * z2209 - s_lam * z2210 - c_lam * z2211 + k1 * z2212;
    const double z2214 = k2 * z2209 + c_lam * z2210 - s_lam * z2211 + x_B * z2212;
    const double z2215 = c_pitch * z2213 - s_pitch * z2214;
    const double z2216 = m_F * (z339 * z1723);
    const double z2217 = m_H * (z320 * z1723);
    const double z2218 = z2216 + z2217;
    const double z2219 = r_F * z2216 - z_H * z2217;
    const double z2220 = c * z2216 + k3 * z2217;
    const double z2221 = s_lam * z2219 - c_lam * z2220;
    const double z2222 = c_steer * z2221;
    const double z2223 = c_lam * z2219 + s_lam * z2220;
    const double z2224 = m_B * (z301 * z1723);
    const double z2225 = r_R * z2218 - s_lam * z2222 - c_lam * z2223 + k1 * z2224;
    const double z2226 = k2 * z2218 + c_lam * z2222 - s_lam * z2223 + x_B * z2224;
    const double z2227 = c_roll * z2208 - e2z * z2215 + s_pitch * z2225 + c_pitch * z2226;
    const double z2228 = z341 * z1749;
    const double z2229 = z1776 - m_F * (z1778 + z2228);
    const double z2230 = z329 * z1749;
    const double z2231 = z1781 - m_H * (z1782 + z2230);
    const double z2232 = r_F * z2229 - z_H * z2231;
    const double z2233 = c * z2229 + k3 * z2231;
    const double z2234 = s_lam * z2232 - c_lam * z2233;
    const double z2235 = s_steer * z2234;
    const double z2236 = z2229 + z2231;
    const double z2237 = c_steer * z2234;
    const double z2238 = c_lam * z2232 + s_lam * z2233;
    const double z2239 = z306 * z1749;
    const double z2240 = z1792 - m_B * (z1793 + z2239);
    const double z2241 = r_R * z2236 - s_lam * z2237 - c_lam * z2238 + k1 * z2240;
    const double z2242 = k2 * z2236 + c_lam * z2237 - s_lam * z2238 + x_B * z2240;
    const double z2243 = c_pitch * z2241 - s_pitch * z2242;
    const double z2244 = z339 * z1749;
    const double z2245 = z1799 - m_F * (z1800 + z2244);
    const double z2246 = z320 * z1749;
    const double z2247 = z1803 - m_H * (z1804 + z2246);
    const double z2248 = z2245 + z2247;
    const double z2249 = r_F * z2245 - z_H * z2247;
    const double z2250 = c * z2245 + k3 * z2247;
    const double z2251 = s_lam * z2249 - c_lam * z2250;
    const double z2252 = c_steer * z2251;
    const double z2253 = c_lam * z2249 + s_lam * z2250;
    const double z2254 = z301 * z1749;
    const double z2255 = z1813 - m_B * (z1814 + z2254);
    const double z2256 = r_R * z2248 - s_lam * z2252 - c_lam * z2253 + k1 * z2255;
    const double z2257 = k2 * z2248 + c_lam * z2252 - s_lam * z2253 + x_B * z2255;
    const double z2258 = c_roll * z2235 - e2z * z2243 + s_pitch * z2256 + c_pitch * z2257;
    const double z2259 = z342 * z1777;
    const double z2260 = z330 * z1777;
    const double z2261 = r_F * z2259 - z_H * z2260;
    const double z2262 = c * z2259 + k3 * z2260;
    const double z2263 = s_lam * z2261 - c_lam * z2262;
    const double z2264 = s_steer * z2263;
    const double z2265 = z1777 * z2043;
    const double z2266 = c_steer * z2263;
    const double z2267 = c_lam * z2261 + s_lam * z2262;
    const double z2268 = z307 * z1777;
    const double z2269 = r_R * z2265 - s_lam * z2266 - c_lam * z2267 + k1 * z2268;
    const double z2270 = k2 * z2265 + c_lam * z2266 - s_lam * z2267 + x_B * z2268;
    const double z2271 = c_pitch * z2269 - s_pitch * z2270;
    const double z2272 = z1777 * z2037;
    const double z2273 = z340 * z1777;
    const double z2274 = z321 * z1777;
    const double z2275 = r_F * z2273 - z_H * z2274;
    const double z2276 = c * z2273 + k3 * z2274;
    const double z2277 = s_lam * z2275 - c_lam * z2276;
    const double z2278 = c_steer * z2277;
    const double z2279 = c_lam * z2275 + s_lam * z2276;
    const double z2280 = z302 * z1777;
    const double z2281 = r_R * z2272 - s_lam * z2278 - c_lam * z2279 + k1 * z2280;
    const double z2282 = k2 * z2272 + c_lam * z2278 - s_lam * z2279 + x_B * z2280;
    const double z2283 = c_roll * z2264 - e2z * z2271 + s_pitch * z2281 + c_pitch * z2282;
    const double z2284 = z457 * z2200 + (z517 * z2167 + (z2202 - z1540 * z2133 + z362 * z2227 - z277 * z2258
        + z162 * z2283));
    const double z2285 = z275 * z1749;
    const double z2286 = z2240 + (z1853 - m_R * (z1854 + z2285) + z2236);
    const double z2287 = s_steer * z2251;
    const double z2288 = c_pitch * z2256 - s_pitch * z2257;
    const double z2289 = c_roll * z2287 - s_pitch * z2241 - c_pitch * z2242 - e2z * z2288;
    const double z2290 = z279 * z1749;
    const double z2291 = z1862 + z2290;
    const double z2292 = z278 * z1749;
    const double z2293 = z1863 - z2292;
    const double z2294 = z291 * z1749;
    const double z2295 = z1867 + z2294;
    const double z2296 = z1866 - F_yy * z2295 - H_yy * z2295;
    const double z2297 = z288 * z1749;
    const double z2298 = z1871 + z2297;
    const double z2299 = z287 * z1749;
    const double z2300 = z1872 - z2299;
    const double z2301 = z1870 + 2.0 * (k20 * z2298) + H_xz * z2300;
    const double z2302 = z1875 + H_xz * z2298 + 2.0 * (k21 * z2300);
    const double z2303 = s_lam * z2301 - c_lam * z2302;
    const double z2304 = s_steer * z2296 + c_steer * z2303;
    const double z2305 = c_lam * z2301 + s_lam * z2302;
    const double z2306 = z1861 + 2.0 * (k23 * z2291) + B_xz * z2293 + s_lam * z2304 + c_lam * z2305;
    const double z2307 = z294 * z1749;
    const double z2308 = z1882 - R_yy * (z1883 + z2307);
    const double z2309 = z281 * z1749;
    const double z2310 = z2308 - (z1886 + B_yy * (z1887 + z2309)) + c_steer * z2296 - s_steer * z2303;
    const double z2311 = z1890 + B_xz * z2291 + 2.0 * (k22 * z2293) - c_lam * z2304 + s_lam * z2305;
    const double z2312 = z1856 + c_yaw * z2289 + s_yaw * z2258 + e3z * z2306 + e2z * z2310 - z2 * z2311;
    const double z2313 = z273 * z1749;
    const double z2314 = z2255 + (z1894 - m_R * (z1895 + z2313) + z2248);
    const double z2315 = z2308 + z92 * z2312 + z158 * z2286 - z152 * z2314;
    const double z2316 = z153 * z2315;
    const double z2317 = z2312 - z90 * z2316 + z65 * z2286 - z89 * z2314;
    const double z2318 = z91 * z2317;
    const double z2319 = z2286 - z2318;
    const double z2320 = c * z2319;
    const double z2321 = r_F * z2319;
    const double z2322 = s_lam * z2320 + c_lam * z2321;
    const double z2323 = c_lam * z2320 - s_lam * z2321;
    const double z2324 = c_steer * z2323;
    const double z2325 = z2242 - (k2 * z2319 - s_lam * z2322 - c_lam * z2324);
    const double z2326 = z2241 - (r_R * z2319 - c_lam * z2322 + s_lam * z2324);
    const double z2327 = z1777 * z2069;
    const double z2328 = s_steer * z2277;
    const double z2329 = c_pitch * z2281 - s_pitch * z2282;
    const double z2330 = c_roll * z2328 - s_pitch * z2269 - c_pitch * z2270 - e2z * z2329;
    const double z2331 = z1777 * z2060;
    const double z2332 = z293 * z1777;
    const double z2333 = z289 * z1777;
    const double z2334 = s_lam * z2332 - c_lam * z2333;
    const double z2335 = s_steer * z2331 + c_steer * z2334;
    const double z2336 = c_lam * z2332 + s_lam * z2333;
    const double z2337 = z283 * z1777 + s_lam * z2335 + c_lam * z2336;
    const double z2338 = z1777 * z2065 + c_steer * z2331 - s_steer * z2334;
    const double z2339 = z280 * z1777 - c_lam * z2335 + s_lam * z2336;
    const double z2340 = c_yaw * z2330 + s_yaw * z2283 + e3z * z2337 + e2z * z2338 - z2 * z2339;
    const double z2341 = z1777 * z2038;
    const double z2342 = z295 * z1777 + z92 * z2340 + z158 * z2327 - z152 * z2341;
    const double z2343 = z153 * z2342;
    const double z2344 = z2340 - z90 * z2343 + z65 * z2327 - z89 * z2341;
    const double z2345 = z91 * z2344;
    const double z2346 = z2327 - z2345;
    const double z2347 = c * z2346;
    const double z2348 = r_F * z2346;
    const double z2349 = s_lam * z2347 + c_lam * z2348;
    const double z2350 = c_lam * z2347 - s_lam * z2348;
    const double z2351 = c_steer * z2350;
    const double z2352 = k2 * z2346 - s_lam * z2349 - c_lam * z2351;
    const double z2353 = z2270 - z2352;
    const double z2354 = r_R * z2346 - c_lam * z2349 + s_lam * z2351;
    const double z2355 = z2269 - z2354;
    const double z2356 = z2212 + (m_R * (z275 * z1723) + z2209);
    const double z2357 = z1621 * z2069 - z357 * z2356 + z272 * z2286 - z155 * z2327;
    const double z2358 = z1595 * z2069 - z1365 * z2126 + z355 * z2356 - z270 * z2286 + z151 * z2327 + z92 *
        z2357;
    const double z2359 = s_steer * z2221;
    const double z2360 = c_pitch * z2225 - s_pitch * z2226;
    const double z2361 = c_roll * z2359 - s_pitch * z2213 - c_pitch * z2214 - e2z * z2360;
    const double z2362 = z279 * z1723;
    const double z2363 = z278 * z1723;
    const double z2364 = k24 * (z291 * z1723);
    const double z2365 = z288 * z1723;
    const double z2366 = z287 * z1723;
    const double z2367 = 2.0 * (k20 * z2365) - H_xz * z2366;
    const double z2368 = H_xz * z2365 - 2.0 * (k21 * z2366);
    const double z2369 = s_lam * z2367 - c_lam * z2368;
    const double z2370 = s_steer * z2364 - c_steer * z2369;
    const double z2371 = c_lam * z2367 + s_lam * z2368;
    const double z2372 = 2.0 * (k23 * z2362) - B_xz * z2363 - s_lam * z2370 + c_lam * z2371;
    const double z2373 = R_yy * (z294 * z1723);
    const double z2374 = z2373 + (B_yy * (z281 * z1723) + c_steer * z2364 + s_steer * z2369);
    const double z2375 = B_xz * z2362 - 2.0 * (k22 * z2363) + c_lam * z2370 + s_lam * z2371;
    const double z2376 = c_yaw * z2361 + s_yaw * z2227 - e3z * z2372 + e2z * z2374 + z2 * z2375;
    const double z2377 = z2224 + (m_R * (z273 * z1723) + z2218);
    const double z2378 = z2373 + z92 * z2376 + z158 * z2356 - z152 * z2377;
    const double z2379 = z153 * z2378;
    const double z2380 = z2376 - z90 * z2379 + z65 * z2356 - z89 * z2377;
    const double z2381 = z1594 * z2112 + z1341 * z2127 - z494 * z2190 - z54 * z2380 + z269 * z2317 - z150 *
        z2344;
    const double z2382 = z1621 * z2068 - z1337 * z2085 - z1362 * z2126 + z1336 * z2090 - z514 * z2178 - z357
        * z2376;
    const double z2383 = 2.0 * (z1939 * (z1366 * z2084)) + z495 * (z1620 * z2070 - z512 * z2179 - z356 *
        z2378 + z271 * z2315 - z154 * z2342);
    const double z2384 = z1621 * z2038 - z357 * z2377 + z272 * z2314 - z155 * z2341;
    const double z2385 = z2382 + z272 * z2312 - z155 * z2340 - z90 * z2383 + z65 * z2357 - z89 * z2384;
    const double z2386 = 2.0 * (z1914 * (z1363 * z2128)) - z469 * (z2381 - z40 * z2385);
    const double z2387 = z2358 - z2386;
    const double z2388 = z467 * z2198 - z2284 - z243 * z2325 + z245 * z2326 + z124 * z2353 - z126 * z2355 +
        z48 * z2387;
    const double z2389 = z1595 * z2071 - z1365 * z2085 - z511 * z2180 + z355 * z2379 - z270 * z2316 + z151 *
        z2343;
    const double z2390 = z2389 + z92 * z2383;
    const double z2391 = z1595 * z2038 - z1365 * z2090 + z355 * z2377 - z270 * z2314 + z151 * z2341 + z92 *
        z2384;
    const double z2392 = z2390 + z2391;
    const double z2393 = z1364 * z2127 - z442 * z2129 - z91 * z2385 - e2z * z2386;
    const double z2394 = z1591 * z2113 + z1290 * z2138 - z492 * z2191 + z267 * z2318 - z148 * z2345 - z36 *
        z2393;
    const double z2395 = z2153 - z2195;
    const double z2396 = z1564 * z2114 - z1321 * z2147 + z1324 * z2148 + z476 * z2191 - z241 * z2319 + z122 *
        z2346;
    const double z2397 = z1284 * z2130 - z2 * z2387;
    const double z2398 = z1286 * z2130 - e3z * z2387;
    const double z2399 = s_lam * z2397 - c_lam * z2398;
    const double z2400 = c_lam * z2397 + s_lam * z2398;
    const double z2401 = z442 * z2130 + e2z * z2387;
    const double z2402 = z445 * z2144 + z443 * z2145 + c_steer * z2400 + s_steer * z2401;
    const double z2403 = c_lam * z2399 - s_lam * z2402;
    const double z2404 = c_lam * z2402 + s_lam * z2399;
    const double z2405 = z2234 + z2323 + (z2396 - z51 * z2403 + z53 * z2404);
    const double z2406 = z445 * z2145 - z443 * z2144 + z2356 - z91 * z2380 - c_steer * z2401 + s_steer *
        z2400;
    const double z2407 = z1560 * z2114 - z1321 * z2150 + z471 * z2191 + z237 * z2319 - z118 * z2346 - z51 *
        z2406;
    const double z2408 = z1565 * z2114 - z1324 * z2150 + z477 * z2191 + z242 * z2319 - z123 * z2346 - z53 *
        z2406;
    const double z2409 = s_lam * z2407 + c_lam * z2408;
    const double z2410 = z1544 * z2139 - z443 * z2149 + z445 * z2395 + s_steer * z2405 + c_steer * z2409;
    const double z2411 = c_lam * z2407 - s_lam * z2408;
    const double z2412 = z2394 + s_lam * z2410 + c_lam * z2411;
    const double z2413 = z2104 - z2184;
    const double z2414 = z1554 * z2071 - z1290 * z2135 + z1293 * z2136 - z1541 * z2088 + z445 * z2100 + z2329
        + z112 * z2343;
    const double z2415 = z2341 + z2343;
    const double z2416 = c * z2415;
    const double z2417 = r_F * z2415;
    const double z2418 = s_lam * z2416 + c_lam * z2417;
    const double z2419 = c_lam * z2416 - s_lam * z2417;
    const double z2420 = c_steer * z2419;
    const double z2421 = k2 * z2415 - s_lam * z2418 - c_lam * z2420;
    const double z2422 = r_R * z2415 - c_lam * z2418 + s_lam * z2420;
    const double z2423 = z1286 * z2086 - e3z * z2390;
    const double z2424 = z1284 * z2086 - z2 * z2390;
    const double z2425 = z443 * z2413 + (z453 * z2180 + (z2414 + s_pitch * z2421 - c_pitch * z2422) - z36 *
        z2423 + R3 * z2424);
    const double z2426 = z2314 + z2316;
    const double z2427 = c * z2426;
    const double z2428 = r_F * z2426;
    const double z2429 = c_lam * z2427 - s_lam * z2428;
    const double z2430 = z1564 * z2072 - z1321 * z2098 + z1324 * z2099 + z476 * z2180 - z241 * z2426 + z122 *
        z2415;
    const double z2431 = z1284 * z2091 - z2 * z2392;
    const double z2432 = z1286 * z2091 - e3z * z2392;
    const double z2433 = s_lam * z2431 - c_lam * z2432;
    const double z2434 = c_lam * z2431 + s_lam * z2432;
    const double z2435 = z442 * z2091 + e2z * z2392;
    const double z2436 = z445 * z2095 + z443 * z2096 + c_steer * z2434 + s_steer * z2435;
    const double z2437 = c_lam * z2433 - s_lam * z2436;
    const double z2438 = c_lam * z2436 + s_lam * z2433;
    const double z2439 = z2251 + z2429 + (z2430 - z51 * z2437 + z53 * z2438);
    const double z2440 = z2377 + (z445 * z2096 - z443 * z2095 + z2379) - c_steer * z2435 + s_steer * z2434;
    const double z2441 = z1560 * z2072 - z1321 * z2101 + z471 * z2180 + z237 * z2426 - z118 * z2415 - z51 *
        z2440;
    const double z2442 = z1565 * z2072 - z1324 * z2101 + z477 * z2180 + z242 * z2426 - z123 * z2415 - z53 *
        z2440;
    const double z2443 = s_lam * z2441 + c_lam * z2442;
    const double z2444 = z2425 + c_steer * z2439 - s_steer * z2443;
    const double z2445 = z1592 * z2113 + z1293 * z2138 - z493 * z2191 + z268 * z2318 - z149 * z2345 - R3 *
        z2393;
    const double z2446 = z2445 - c_lam * z2410 + s_lam * z2411;
    const double z2447 = z442 * z2188 + (z447 * z2189 - (z2388 + z45 * z2392)) + s_pitch * z2412 - c_roll *
        z2444 + c_pitch * z2446;
    const double z2448 = z2107 + z2187;
    const double z2449 = z2108 + z2186;
    const double z2450 = s_lam * z2427 + c_lam * z2428;
    const double z2451 = c_steer * z2429;
    const double z2452 = z2257 - (k2 * z2426 - s_lam * z2450 - c_lam * z2451);
    const double z2453 = z2256 - (r_R * z2426 - c_lam * z2450 + s_lam * z2451);
    const double z2454 = z457 * z2448 + (z467 * z2449 - (z1578 * z2080 - z1575 * z2082 - z2328)) - z245 *
        z2452 - z243 * z2453;
    const double z2455 = z2282 - z2421;
    const double z2456 = z2281 - z2422;
    const double z2457 = z442 * z2086 + z2383 + e2z * z2390;
    const double z2458 = z1591 * z2071 + z1290 * z2087 + z492 * z2180 + z267 * z2316 - z148 * z2343 + z36 *
        z2457;
    const double z2459 = z1544 * z2088 - z443 * z2100 + z445 * z2413 + s_steer * z2439 + c_steer * z2443;
    const double z2460 = c_lam * z2441 - s_lam * z2442;
    const double z2461 = z2458 - s_lam * z2459 - c_lam * z2460;
    const double z2462 = z1592 * z2071 + z1293 * z2087 + z493 * z2180 + z268 * z2316 - z149 * z2343 + R3 *
        z2457;
    const double z2463 = z2462 + c_lam * z2459 - s_lam * z2460;
    const double z2464 = z2454 + z126 * z2455 + z124 * z2456 + s_steer * z2419 + c_pitch * z2461 - s_pitch *
        z2463;
    const double z2465 = z467 * z2120 + z457 * z2123 - z2166 - s_pitch * z2199 + c_pitch * z2197;
    const double z2466 = z443 * z2118 + z2165 - s_steer * z2195;
    const double z2467 = s_steer * z2139;
    const double z2468 = z1622 * z2056 - z1575 * z2080 - z1578 * z2082 + z1305 * z2130 + z1304 * z2091 -
        z1547 * z2467;
    const double z2469 = z457 * z2449 + (z517 * z2158 - (z2468 + z1540 * z2161 + z362 * z2361 - z277 * z2289
        + z162 * z2330));
    const double z2470 = z467 * z2448 - z2469 + z243 * z2452 - z245 * z2453 - z124 * z2455 + z126 * z2456 +
        z45 * z2387;
    const double z2471 = z1554 * z2113 - z1290 * z2163 + z1293 * z2164 + z1541 * z2139 - z445 * z2149 - z2271
        + z112 * z2345;
    const double z2472 = z1286 * z2129 - e3z * z2386;
    const double z2473 = z1284 * z2129 - z2 * z2386;
    const double z2474 = z443 * z2395 + (z453 * z2191 - (z2471 - s_pitch * z2352 + c_pitch * z2354) + z36 *
        z2472 - R3 * z2473);
    const double z2475 = z2474 + c_steer * z2405 - s_steer * z2409;
    const double z2476 = z457 * z2198 + (z467 * z2200 + (z1578 * z2121 - z1575 * z2124 - z2264)) + z245 *
        z2325 + z243 * z2326;
    const double z2477 = z2476 - z126 * z2353 - z124 * z2355 - s_steer * z2350 + c_pitch * z2412 - s_pitch *
        z2446;
    const double z2478 = z442 * z2465 + (z447 * z2466 - (z2470 - z48 * z2392)) + s_pitch * z2461 - c_roll *
        z2475 + e2z * z2477;
    const double z2479 = c_yaw * (z2447 - e2z * z2464) + s_yaw * (z2478 + c_pitch * z2463) - z353 * z2036;
    const double z2480 = z401 + z413;
    const double z2481 = z387 + (z359 + z2480);
    const double z2482 = r_F * z413 - z_H * z401;
    const double z2483 = c * z413 + k3 * z401;
    const double z2484 = s_lam * z2482 - c_lam * z2483;
    const double z2485 = s_steer * z2484;
    const double z2486 = z411 + z415;
    const double z2487 = r_F * z415 - z_H * z411;
    const double z2488 = c * z415 + k3 * z411;
    const double z2489 = s_lam * z2487 - c_lam * z2488;
    const double z2490 = c_steer * z2489;
    const double z2491 = c_lam * z2487 + s_lam * z2488;
    const double z2492 = r_R * z2486 - s_lam * z2490 - c_lam * z2491 + k1 * z392;
    const double z2493 = k2 * z2486 + c_lam * z2490 - s_lam * z2491 + x_B * z392;
    const double z2494 = c_steer * z2484;
    const double z2495 = c_lam * z2482 + s_lam * z2483;
    const double z2496 = r_R * z2480 - s_lam * z2494 - c_lam * z2495 + k1 * z387;
    const double z2497 = k2 * z2480 + c_lam * z2494 - s_lam * z2495 + x_B * z387;
    const double z2498 = c_pitch * z2496 - s_pitch * z2497;
    const double z2499 = c_roll * z2485 - s_pitch * z2492 - c_pitch * z2493 - e2z * z2498;
    const double z2500 = s_steer * z2489;
    const double z2501 = c_pitch * z2492 - s_pitch * z2493;
    const double z2502 = c_roll * z2500 - e2z * z2501 + s_pitch * z2496 + c_pitch * z2497;
    const double z2503 = z377 - z417;
    const double z2504 = s_lam * z378 - c_lam * z374;
    const double z2505 = s_steer * z2503 - c_steer * z2504;
    const double z2506 = c_lam * z378 + s_lam * z374;
    const double z2507 = z368 - s_lam * z2505 + c_lam * z2506;
    const double z2508 = z367 - z380;
    const double z2509 = z2508 + c_steer * z2503 + s_steer * z2504;
    const double z2510 = z365 + c_lam * z2505 + s_lam * z2506;
    const double z2511 = c_yaw * z2499 + s_yaw * z2502 + e3z * z2507 - e2z * z2509 - z2 * z2510;
    const double z2512 = z392 + (z361 + z2486);
    const double z2513 = z380 + z92 * z2511 + z158 * z2512 - z152 * z2481;
    const double z2514 = z153 * z2513;
    const double z2515 = z2481 + z2514;
    const double z2516 = c * z2515;
    const double z2517 = r_F * z2515;
    const double z2518 = s_lam * z2516 + c_lam * z2517;
    const double z2519 = c_lam * z2516 - s_lam * z2517;
    const double z2520 = c_steer * z2519;
    const double z2521 = k2 * z2515 - s_lam * z2518 - c_lam * z2520;
    const double z2522 = r_R * z2515 - c_lam * z2518 + s_lam * z2520;
    const double z2523 = z2497 - z2521;
    const double z2524 = z2497 + z2523;
    const double z2525 = z2496 - z2522;
    const double z2526 = z2496 + z2525;
    const double z2527 = z512 * z2513;
    const double z2528 = z495 * z2527;
    const double z2529 = z511 * z2514 - z92 * z2528;
    const double z2530 = z2528 - e2z * z2529;
    const double z2531 = z2484 + z2519;
    const double z2532 = z2484 + z2531;
    const double z2533 = z514 * z2481;
    const double z2534 = z2529 + (z511 * z2481 - z92 * z2533);
    const double z2535 = z2 * z2534;
    const double z2536 = e3z * z2534;
    const double z2537 = s_lam * z2535 - c_lam * z2536;
    const double z2538 = c_lam * z2535 + s_lam * z2536;
    const double z2539 = e2z * z2534;
    const double z2540 = c_steer * z2538 - s_steer * z2539;
    const double z2541 = c_lam * z2537 - s_lam * z2540;
    const double z2542 = c_lam * z2540 + s_lam * z2537;
    const double z2543 = z476 * z2515 - z51 * z2541 + z53 * z2542;
    const double z2544 = c_steer * z2539 + s_steer * z2538;
    const double z2545 = z471 * z2515 - z51 * z2544;
    const double z2546 = z477 * z2515 - z53 * z2544;
    const double z2547 = s_lam * z2545 + c_lam * z2546;
    const double z2548 = z445 * z2532 - s_steer * z2543 - c_steer * z2547;
    const double z2549 = c_lam * z2545 - s_lam * z2546;
    const double z2550 = z492 * z2514 + z36 * z2530 + s_lam * z2548 - c_lam * z2549;
    const double z2551 = z493 * z2514 + R3 * z2530 - c_lam * z2548 - s_lam * z2549;
    const double z2552 = z467 * z2524 + z457 * z2526 - c_pitch * z2550 + s_pitch * z2551;
    const double z2553 = R_yy * z1663;
    const double z2554 = z2511 - z90 * z2514 + z65 * z2512 - z89 * z2481;
    const double z2555 = z91 * z2554;
    const double z2556 = z2512 - z2555;
    const double z2557 = c * z2556;
    const double z2558 = r_F * z2556;
    const double z2559 = s_lam * z2557 + c_lam * z2558;
    const double z2560 = c_lam * z2557 - s_lam * z2558;
    const double z2561 = c_steer * z2560;
    const double z2562 = k2 * z2556 - s_lam * z2559 - c_lam * z2561;
    const double z2563 = z2493 - z2562;
    const double z2564 = z2493 + z2563;
    const double z2565 = r_R * z2556 - c_lam * z2559 + s_lam * z2561;
    const double z2566 = z2492 - z2565;
    const double z2567 = z2492 + z2566;
    const double z2568 = z514 * z2512;
    const double z2569 = z514 * z2511 - z90 * z2528 + z65 * z2568 - z89 * z2533;
    const double z2570 = z494 * z2554 - z40 * z2569;
    const double z2571 = z469 * z2570;
    const double z2572 = z511 * z2512 - z92 * z2568 - z2571;
    const double z2573 = s_steer * z2532;
    const double z2574 = z517 * z2502 - z457 * z2564 + z467 * z2567 - z48 * z2572 - z45 * z2534 + z447 *
        z2573;
    const double z2575 = z2498 + s_pitch * z2521 - c_pitch * z2522;
    const double z2576 = z2498 + z2575;
    const double z2577 = e3z * z2529;
    const double z2578 = z2 * z2529;
    const double z2579 = z453 * z2514 - z36 * z2577 + R3 * z2578 - z443 * z2532 + c_steer * z2543 - s_steer *
        z2547;
    const double z2580 = z91 * z2569 - e2z * z2571;
    const double z2581 = z2489 + z2560;
    const double z2582 = z2489 + z2581;
    const double z2583 = z2 * z2572;
    const double z2584 = e3z * z2572;
    const double z2585 = s_lam * z2583 - c_lam * z2584;
    const double z2586 = c_lam * z2583 + s_lam * z2584;
    const double z2587 = e2z * z2572;
    const double z2588 = c_steer * z2586 - s_steer * z2587;
    const double z2589 = c_lam * z2585 - s_lam * z2588;
    const double z2590 = c_lam * z2588 + s_lam * z2585;
    const double z2591 = z476 * z2556 - z51 * z2589 + z53 * z2590;
    const double z2592 = c_steer * z2587 + s_steer * z2586;
    const double z2593 = z471 * z2556 - z51 * z2592;
    const double z2594 = z477 * z2556 - z53 * z2592;
    const double z2595 = s_lam * z2593 + c_lam * z2594;
    const double z2596 = z445 * z2582 - s_steer * z2591 - c_steer * z2595;
    const double z2597 = c_lam * z2593 - s_lam * z2594;
    const double z2598 = z492 * z2555 + z36 * z2580 - s_lam * z2596 + c_lam * z2597;
    const double z2599 = z493 * z2555 + R3 * z2580 + c_lam * z2596 + s_lam * z2597;
    const double z2600 = z2574 + z442 * z2576 + c_roll * z2579 - s_pitch * z2598 - c_pitch * z2599 - e2z *
        z2552;
    const double z2601 = z1280 * z2499 - z1281 * z2502 - z1286 * z2507 - z442 * z2509 + z1284 * z2510 - c_yaw
        * z2600;
    const double z2602 = s_steer * z2582;
    const double z2603 = z517 * z2499 - z457 * z2524 + z467 * z2526 + z45 * z2572 - z48 * z2534 - z447 *
        z2602;
    const double z2604 = z2501 + s_pitch * z2562 - c_pitch * z2565;
    const double z2605 = z2501 + z2604;
    const double z2606 = e3z * z2571;
    const double z2607 = z2 * z2571;
    const double z2608 = z453 * z2555 - z36 * z2606 + R3 * z2607 + z443 * z2582 - c_steer * z2591 + s_steer *
        z2595;
    const double z2609 = z467 * z2564 + z457 * z2567 + c_pitch * z2598 - s_pitch * z2599;
    const double z2610 = z2603 - z442 * z2605 + c_roll * z2608 + e2z * z2609 + s_pitch * z2550 + c_pitch *
        z2551;
    const double z2611 = z1626 * k24;
    const double z2612 = 2.0 * (k20 * z1665) + H_xz * z1672;
    const double z2613 = 2.0 * (k21 * z1672) + H_xz * z1665;
    const double z2614 = s_lam * z2612 - c_lam * z2613;
    const double z2615 = z443 * z2503 + z445 * z2504 + s_steer * z2611 - c_steer * z2614;
    const double z2616 = c_lam * z2612 + s_lam * z2613;
    const double z2617 = 2.0 * (k23 * z1674) - B_xz * z1677 - s_lam * z2615 + c_lam * z2616;
    const double z2618 = z2553 - (z445 * z2503 - z443 * z2504 - B_yy * z1663) + c_steer * z2611 + s_steer *
        z2614;
    const double z2619 = 2.0 * (k22 * z1677) - B_xz * z1674 - c_lam * z2615 - s_lam * z2616;
    const double z2620 = z2601 + s_yaw * z2610 + e3z * z2617 - e2z * z2618 + z2 * z2619;
    const double z2621 = z1365 * z2511 + z1368 * z2512 - z1369 * z2481 - z2553 + z92 * z2620;
    const double z2622 = z1367 * z2513 - z153 * z2621;
    const double z2623 = c * z2622;
    const double z2624 = r_F * z2622;
    const double z2625 = s_lam * z2623 + c_lam * z2624;
    const double z2626 = c_lam * z2623 - s_lam * z2624;
    const double z2627 = z445 * z2519 + c_steer * z2626;
    const double z2628 = k2 * z2622 - s_lam * z2625 - c_lam * z2627;
    const double z2629 = r_R * z2622 - c_lam * z2625 + s_lam * z2627;
    const double z2630 = z467 * z2521 + z457 * z2522 - z2552 - s_pitch * z2628 + c_pitch * z2629;
    const double z2631 = z443 * z2519 - z2579 - s_steer * z2626;
    const double z2632 = z1337 * z2514 + z1362 * z2512 - z1336 * z2481 + z2620 + z90 * z2622;
    const double z2633 = z1364 * z2554 + z91 * z2632;
    const double z2634 = c * z2633;
    const double z2635 = r_F * z2633;
    const double z2636 = s_lam * z2634 + c_lam * z2635;
    const double z2637 = c_lam * z2634 - s_lam * z2635;
    const double z2638 = z445 * z2560 + c_steer * z2637;
    const double z2639 = r_R * z2633 - c_lam * z2636 + s_lam * z2638;
    const double z2640 = z2598 - z2639;
    const double z2641 = k2 * z2633 - s_lam * z2636 - c_lam * z2638;
    const double z2642 = z2599 - z2641;
    const double z2643 = s_steer * z2531;
    const double z2644 = z1622 * z2502 - z1575 * z2563 - z1578 * z2566 + z1304 * z2572 - z1305 * z2534 +
        z1547 * z2643;
    const double z2645 = z1775 - m_F * (z1778 + (z2228 + z414 * z1723));
    const double z2646 = z1780 - m_H * (z1782 + (z2230 + z410 * z1723));
    const double z2647 = r_F * z2645 - z_H * z2646;
    const double z2648 = c * z2645 + k3 * z2646;
    const double z2649 = s_lam * z2647 - c_lam * z2648;
    const double z2650 = s_steer * z2649;
    const double z2651 = z2645 + z2646;
    const double z2652 = c_steer * z2649;
    const double z2653 = c_lam * z2647 + s_lam * z2648;
    const double z2654 = z1791 - m_B * (z1793 + (z2239 + z391 * z1723));
    const double z2655 = r_R * z2651 - s_lam * z2652 - c_lam * z2653 + k1 * z2654;
    const double z2656 = k2 * z2651 + c_lam * z2652 - s_lam * z2653 + x_B * z2654;
    const double z2657 = c_pitch * z2655 - s_pitch * z2656;
    const double z2658 = z1798 - m_F * (z1800 + (z2244 + z412 * z1723));
    const double z2659 = z1802 - m_H * (z1804 + (z2246 + z400 * z1723));
    const double z2660 = z2658 + z2659;
    const double z2661 = r_F * z2658 - z_H * z2659;
    const double z2662 = c * z2658 + k3 * z2659;
    const double z2663 = s_lam * z2661 - c_lam * z2662;
    const double z2664 = c_steer * z2663;
    const double z2665 = c_lam * z2661 + s_lam * z2662;
    const double z2666 = z1812 - m_B * (z1814 + (z2254 + z386 * z1723));
    const double z2667 = r_R * z2660 - s_lam * z2664 - c_lam * z2665 + k1 * z2666;
    const double z2668 = k2 * z2660 + c_lam * z2664 - s_lam * z2665 + x_B * z2666;
    const double z2669 = c_roll * z2650 - e2z * z2657 + s_pitch * z2667 + c_pitch * z2668;
    const double z2670 = z415 * z1749;
    const double z2671 = z411 * z1749;
    const double z2672 = r_F * z2670 - z_H * z2671;
    const double z2673 = c * z2670 + k3 * z2671;
    const double z2674 = s_lam * z2672 - c_lam * z2673;
    const double z2675 = s_steer * z2674;
    const double z2676 = z1749 * z2486;
    const double z2677 = c_steer * z2674;
    const double z2678 = c_lam * z2672 + s_lam * z2673;
    const double z2679 = z392 * z1749;
    const double z2680 = r_R * z2676 - s_lam * z2677 - c_lam * z2678 + k1 * z2679;
    const double z2681 = k2 * z2676 + c_lam * z2677 - s_lam * z2678 + x_B * z2679;
    const double z2682 = c_pitch * z2680 - s_pitch * z2681;
    const double z2683 = z1749 * z2480;
    const double z2684 = z413 * z1749;
    const double z2685 = z401 * z1749;
    const double z2686 = r_F * z2684 - z_H * z2685;
    const double z2687 = c * z2684 + k3 * z2685;
    const double z2688 = s_lam * z2686 - c_lam * z2687;
    const double z2689 = c_steer * z2688;
    const double z2690 = c_lam * z2686 + s_lam * z2687;
    const double z2691 = z387 * z1749;
    const double z2692 = r_R * z2683 - s_lam * z2689 - c_lam * z2690 + k1 * z2691;
    const double z2693 = k2 * z2683 + c_lam * z2689 - s_lam * z2690 + x_B * z2691;
    const double z2694 = c_roll * z2675 - e2z * z2682 + s_pitch * z2692 + c_pitch * z2693;
    const double z2695 = z415 * z1777;
    const double z2696 = z411 * z1777;
    const double z2697 = r_F * z2695 - z_H * z2696;
    const double z2698 = c * z2695 + k3 * z2696;
    const double z2699 = s_lam * z2697 - c_lam * z2698;
    const double z2700 = s_steer * z2699;
    const double z2701 = z1777 * z2486;
    const double z2702 = c_steer * z2699;
    const double z2703 = c_lam * z2697 + s_lam * z2698;
    const double z2704 = z392 * z1777;
    const double z2705 = r_R * z2701 - s_lam * z2702 - c_lam * z2703 + k1 * z2704;
    const double z2706 = k2 * z2701 + c_lam * z2702 - s_lam * z2703 + x_B * z2704;
    const double z2707 = c_pitch * z2705 - s_pitch * z2706;
    const double z2708 = z1777 * z2480;
    const double z2709 = z413 * z1777;
    const double z2710 = z401 * z1777;
    const double z2711 = r_F * z2709 - z_H * z2710;
    const double z2712 = c * z2709 + k3 * z2710;
    const double z2713 = s_lam * z2711 - c_lam * z2712;
    const double z2714 = c_steer * z2713;
    const double z2715 = c_lam * z2711 + s_lam * z2712;
    const double z2716 = z387 * z1777;
    const double z2717 = r_R * z2708 - s_lam * z2714 - c_lam * z2715 + k1 * z2716;
    const double z2718 = k2 * z2708 + c_lam * z2714 - s_lam * z2715 + x_B * z2716;
    const double z2719 = c_roll * z2700 - e2z * z2707 + s_pitch * z2717 + c_pitch * z2718;
    const double z2720 = z457 * z2642 + (z517 * z2610 + (z2644 - z1540 * z2575 - z362 * z2669 + z277 * z2694
        + z162 * z2719));
    const double z2721 = z1749 * z2512;
    const double z2722 = s_steer * z2688;
    const double z2723 = c_pitch * z2692 - s_pitch * z2693;
    const double z2724 = c_roll * z2722 - s_pitch * z2680 - c_pitch * z2681 - e2z * z2723;
    const double z2725 = z1749 * z2503;
    const double z2726 = z378 * z1749;
    const double z2727 = z374 * z1749;
    const double z2728 = s_lam * z2726 - c_lam * z2727;
    const double z2729 = s_steer * z2725 - c_steer * z2728;
    const double z2730 = c_lam * z2726 + s_lam * z2727;
    const double z2731 = z368 * z1749 - s_lam * z2729 + c_lam * z2730;
    const double z2732 = z1749 * z2508 + c_steer * z2725 + s_steer * z2728;
    const double z2733 = z365 * z1749 + c_lam * z2729 + s_lam * z2730;
    const double z2734 = c_yaw * z2724 + s_yaw * z2694 + e3z * z2731 - e2z * z2732 - z2 * z2733;
    const double z2735 = z1749 * z2481;
    const double z2736 = z380 * z1749 + z92 * z2734 + z158 * z2721 - z152 * z2735;
    const double z2737 = z153 * z2736;
    const double z2738 = z2734 - z90 * z2737 + z65 * z2721 - z89 * z2735;
    const double z2739 = z91 * z2738;
    const double z2740 = z2721 - z2739;
    const double z2741 = c * z2740;
    const double z2742 = r_F * z2740;
    const double z2743 = s_lam * z2741 + c_lam * z2742;
    const double z2744 = c_lam * z2741 - s_lam * z2742;
    const double z2745 = c_steer * z2744;
    const double z2746 = z2681 - (k2 * z2740 - s_lam * z2743 - c_lam * z2745);
    const double z2747 = z2680 - (r_R * z2740 - c_lam * z2743 + s_lam * z2745);
    const double z2748 = z1777 * z2512;
    const double z2749 = s_steer * z2713;
    const double z2750 = c_pitch * z2717 - s_pitch * z2718;
    const double z2751 = c_roll * z2749 - s_pitch * z2705 - c_pitch * z2706 - e2z * z2750;
    const double z2752 = z1777 * z2503;
    const double z2753 = z378 * z1777;
    const double z2754 = z374 * z1777;
    const double z2755 = s_lam * z2753 - c_lam * z2754;
    const double z2756 = s_steer * z2752 - c_steer * z2755;
    const double z2757 = c_lam * z2753 + s_lam * z2754;
    const double z2758 = z368 * z1777 - s_lam * z2756 + c_lam * z2757;
    const double z2759 = z1777 * z2508 + c_steer * z2752 + s_steer * z2755;
    const double z2760 = z365 * z1777 + c_lam * z2756 + s_lam * z2757;
    const double z2761 = c_yaw * z2751 + s_yaw * z2719 + e3z * z2758 - e2z * z2759 - z2 * z2760;
    const double z2762 = z1777 * z2481;
    const double z2763 = z380 * z1777 + z92 * z2761 + z158 * z2748 - z152 * z2762;
    const double z2764 = z153 * z2763;
    const double z2765 = z2761 - z90 * z2764 + z65 * z2748 - z89 * z2762;
    const double z2766 = z91 * z2765;
    const double z2767 = z2748 - z2766;
    const double z2768 = c * z2767;
    const double z2769 = r_F * z2767;
    const double z2770 = s_lam * z2768 + c_lam * z2769;
    const double z2771 = c_lam * z2768 - s_lam * z2769;
    const double z2772 = c_steer * z2771;
    const double z2773 = k2 * z2767 - s_lam * z2770 - c_lam * z2772;
    const double z2774 = z2706 - z2773;
    const double z2775 = r_R * z2767 - c_lam * z2770 + s_lam * z2772;
    const double z2776 = z2705 - z2775;
    const double z2777 = z2654 + (z1852 - m_R * (z1854 + (z2285 + z360 * z1723)) + z2651);
    const double z2778 = z1621 * z2512 + z357 * z2777 - z272 * z2721 - z155 * z2748;
    const double z2779 = z1595 * z2512 - z1365 * z2568 - z355 * z2777 + z270 * z2721 + z151 * z2748 + z92 *
        z2778;
    const double z2780 = s_steer * z2663;
    const double z2781 = c_pitch * z2667 - s_pitch * z2668;
    const double z2782 = c_roll * z2780 - s_pitch * z2655 - c_pitch * z2656 - e2z * z2781;
    const double z2783 = z1862 + (z2290 + z364 * z1723);
    const double z2784 = z1863 - (z2292 + z363 * z1723);
    const double z2785 = z1632 - z1864 - F_yy * (z1867 + (z2294 + z416 * z1723)) + (z1671 + z1865 - H_yy *
        (z1867 + (z2294 - z376 * z1723)));
    const double z2786 = z1871 + (z2297 - z373 * z1723);
    const double z2787 = z1872 - (z2299 + z372 * z1723);
    const double z2788 = z1869 + 2.0 * (k20 * z2786) + H_xz * z2787;
    const double z2789 = z1874 + H_xz * z2786 + 2.0 * (k21 * z2787);
    const double z2790 = s_lam * z2788 - c_lam * z2789;
    const double z2791 = s_steer * z2785 + c_steer * z2790;
    const double z2792 = c_lam * z2788 + s_lam * z2789;
    const double z2793 = z1860 + 2.0 * (k23 * z2783) + B_xz * z2784 + s_lam * z2791 + c_lam * z2792;
    const double z2794 = z1881 - R_yy * (z1883 + (z2307 + z379 * z1723));
    const double z2795 = z2794 - (z1885 + B_yy * (z1887 + (z2309 - z366 * z1723)) - c_steer * z2785 + s_steer
        * z2790);
    const double z2796 = z1889 + B_xz * z2783 + 2.0 * (k22 * z2784) - c_lam * z2791 + s_lam * z2792;
    const double z2797 = z1856 + c_yaw * z2782 + s_yaw * z2669 + e3z * z2793 + e2z * z2795 - z2 * z2796;
    const double z2798 = z2666 + (z1893 - m_R * (z1895 + (z2313 + z358 * z1723)) + z2660);
    const double z2799 = z2794 + z92 * z2797 + z158 * z2777 - z152 * z2798;
    const double z2800 = z153 * z2799;
    const double z2801 = z2797 - z90 * z2800 + z65 * z2777 - z89 * z2798;
    const double z2802 = z1594 * z2554 + z1341 * z2569 - z494 * z2632 + z54 * z2801 - z269 * z2738 - z150 *
        z2765;
    const double z2803 = z1621 * z2511 - z1337 * z2528 - z1362 * z2568 + z1336 * z2533 - z514 * z2620 + z357
        * z2797;
    const double z2804 = 2.0 * (z1939 * (z1366 * z2527)) + z495 * (z1620 * z2513 - z512 * z2621 + z356 *
        z2799 - z271 * z2736 - z154 * z2763);
    const double z2805 = z1621 * z2481 + z357 * z2798 - z272 * z2735 - z155 * z2762;
    const double z2806 = z2803 - z272 * z2734 - z155 * z2761 - z90 * z2804 + z65 * z2778 - z89 * z2805;
    const double z2807 = 2.0 * (z1914 * (z1363 * z2570)) - z469 * (z2802 - z40 * z2806);
    const double z2808 = z2779 - z2807;
    const double z2809 = z467 * z2640 - z2720 + z243 * z2746 - z245 * z2747 + z124 * z2774 - z126 * z2776 +
        z48 * z2808;
    const double z2810 = z1595 * z2514 - z1365 * z2528 - z511 * z2622 - z355 * z2800 + z270 * z2737 + z151 *
        z2764;
    const double z2811 = z2810 + z92 * z2804;
    const double z2812 = z1595 * z2481 - z1365 * z2533 - z355 * z2798 + z270 * z2735 + z151 * z2762 + z92 *
        z2805;
    const double z2813 = z2811 + z2812;
    const double z2814 = z1364 * z2569 - z442 * z2571 - z91 * z2806 - e2z * z2807;
    const double z2815 = z1591 * z2555 + z1290 * z2580 - z492 * z2633 - z267 * z2739 - z148 * z2766 - z36 *
        z2814;
    const double z2816 = z2595 - z2637;
    const double z2817 = z1564 * z2556 - z1321 * z2589 + z1324 * z2590 + z476 * z2633 + z241 * z2740 + z122 *
        z2767;
    const double z2818 = z1284 * z2572 - z2 * z2808;
    const double z2819 = z1286 * z2572 - e3z * z2808;
    const double z2820 = s_lam * z2818 - c_lam * z2819;
    const double z2821 = c_lam * z2818 + s_lam * z2819;
    const double z2822 = z442 * z2572 + e2z * z2808;
    const double z2823 = z445 * z2586 + z443 * z2587 + c_steer * z2821 + s_steer * z2822;
    const double z2824 = c_lam * z2820 - s_lam * z2823;
    const double z2825 = c_lam * z2823 + s_lam * z2820;
    const double z2826 = z2674 + z2744 - (z2817 - z51 * z2824 + z53 * z2825);
    const double z2827 = z445 * z2587 - z443 * z2586 - z2777 + z91 * z2801 - c_steer * z2822 + s_steer *
        z2821;
    const double z2828 = z1560 * z2556 - z1321 * z2592 + z471 * z2633 - z237 * z2740 - z118 * z2767 - z51 *
        z2827;
    const double z2829 = z1565 * z2556 - z1324 * z2592 + z477 * z2633 - z242 * z2740 - z123 * z2767 - z53 *
        z2827;
    const double z2830 = s_lam * z2828 + c_lam * z2829;
    const double z2831 = z1544 * z2581 - z443 * z2591 + z445 * z2816 - s_steer * z2826 + c_steer * z2830;
    const double z2832 = c_lam * z2828 - s_lam * z2829;
    const double z2833 = z2815 + s_lam * z2831 + c_lam * z2832;
    const double z2834 = z2547 - z2626;
    const double z2835 = z1554 * z2514 - z1290 * z2577 + z1293 * z2578 - z1541 * z2531 + z445 * z2543 + z2750
        + z112 * z2764;
    const double z2836 = z2762 + z2764;
    const double z2837 = c * z2836;
    const double z2838 = r_F * z2836;
    const double z2839 = s_lam * z2837 + c_lam * z2838;
    const double z2840 = c_lam * z2837 - s_lam * z2838;
    const double z2841 = c_steer * z2840;
    const double z2842 = k2 * z2836 - s_lam * z2839 - c_lam * z2841;
    const double z2843 = r_R * z2836 - c_lam * z2839 + s_lam * z2841;
    const double z2844 = z1286 * z2529 - e3z * z2811;
    const double z2845 = z1284 * z2529 - z2 * z2811;
    const double z2846 = z443 * z2834 + (z453 * z2622 + (z2835 + s_pitch * z2842 - c_pitch * z2843) - z36 *
        z2844 + R3 * z2845);
    const double z2847 = z2735 + z2737;
    const double z2848 = c * z2847;
    const double z2849 = r_F * z2847;
    const double z2850 = c_lam * z2848 - s_lam * z2849;
    const double z2851 = z1564 * z2515 - z1321 * z2541 + z1324 * z2542 + z476 * z2622 + z241 * z2847 + z122 *
        z2836;
    const double z2852 = z1284 * z2534 - z2 * z2813;
    const double z2853 = z1286 * z2534 - e3z * z2813;
    const double z2854 = s_lam * z2852 - c_lam * z2853;
    const double z2855 = c_lam * z2852 + s_lam * z2853;
    const double z2856 = z442 * z2534 + e2z * z2813;
    const double z2857 = z445 * z2538 + z443 * z2539 + c_steer * z2855 + s_steer * z2856;
    const double z2858 = c_lam * z2854 - s_lam * z2857;
    const double z2859 = c_lam * z2857 + s_lam * z2854;
    const double z2860 = z2688 + z2850 - (z2851 - z51 * z2858 + z53 * z2859);
    const double z2861 = z2798 - (z445 * z2539 - z443 * z2538 - z2800) + c_steer * z2856 - s_steer * z2855;
    const double z2862 = z1560 * z2515 - z1321 * z2544 + z471 * z2622 - z237 * z2847 - z118 * z2836 + z51 *
        z2861;
    const double z2863 = z1565 * z2515 - z1324 * z2544 + z477 * z2622 - z242 * z2847 - z123 * z2836 + z53 *
        z2861;
    const double z2864 = s_lam * z2862 + c_lam * z2863;
    const double z2865 = z2846 - c_steer * z2860 - s_steer * z2864;
    const double z2866 = z1592 * z2555 + z1293 * z2580 - z493 * z2633 - z268 * z2739 - z149 * z2766 - R3 *
        z2814;
    const double z2867 = z2866 - c_lam * z2831 + s_lam * z2832;
    const double z2868 = z442 * z2630 + (z447 * z2631 - (z2809 + z45 * z2813)) + s_pitch * z2833 - c_roll *
        z2865 + c_pitch * z2867;
    const double z2869 = z2550 + z2629;
    const double z2870 = z2551 + z2628;
    const double z2871 = s_lam * z2848 + c_lam * z2849;
    const double z2872 = c_steer * z2850;
    const double z2873 = z2693 - (k2 * z2847 - s_lam * z2871 - c_lam * z2872);
    const double z2874 = z2692 - (r_R * z2847 - c_lam * z2871 + s_lam * z2872);
    const double z2875 = z457 * z2869 + (z467 * z2870 - (z1578 * z2523 - z1575 * z2525 - z2749)) + z245 *
        z2873 + z243 * z2874;
    const double z2876 = z2718 - z2842;
    const double z2877 = z2717 - z2843;
    const double z2878 = z442 * z2529 + z2804 + e2z * z2811;
    const double z2879 = z1591 * z2514 + z1290 * z2530 + z492 * z2622 - z267 * z2737 - z148 * z2764 + z36 *
        z2878;
    const double z2880 = z1544 * z2531 - z443 * z2543 + z445 * z2834 - s_steer * z2860 + c_steer * z2864;
    const double z2881 = c_lam * z2862 - s_lam * z2863;
    const double z2882 = z2879 - s_lam * z2880 - c_lam * z2881;
    const double z2883 = z1592 * z2514 + z1293 * z2530 + z493 * z2622 - z268 * z2737 - z149 * z2764 + R3 *
        z2878;
    const double z2884 = z2883 + c_lam * z2880 - s_lam * z2881;
    const double z2885 = z2875 + z126 * z2876 + z124 * z2877 + s_steer * z2840 + c_pitch * z2882 - s_pitch *
        z2884;
    const double z2886 = z467 * z2562 + z457 * z2565 - z2609 - s_pitch * z2641 + c_pitch * z2639;
    const double z2887 = z443 * z2560 + z2608 - s_steer * z2637;
    const double z2888 = s_steer * z2581;
    const double z2889 = z1622 * z2499 - z1575 * z2523 - z1578 * z2525 + z1305 * z2572 + z1304 * z2534 -
        z1547 * z2888;
    const double z2890 = z457 * z2870 + (z517 * z2600 - (z2889 + z1540 * z2604 - z362 * z2782 + z277 * z2724
        + z162 * z2751));
    const double z2891 = z467 * z2869 - z2890 - z243 * z2873 + z245 * z2874 - z124 * z2876 + z126 * z2877 +
        z45 * z2808;
    const double z2892 = z1554 * z2555 - z1290 * z2606 + z1293 * z2607 + z1541 * z2581 - z445 * z2591 - z2707
        + z112 * z2766;
    const double z2893 = z1286 * z2571 - e3z * z2807;
    const double z2894 = z1284 * z2571 - z2 * z2807;
    const double z2895 = z443 * z2816 + (z453 * z2633 - (z2892 - s_pitch * z2773 + c_pitch * z2775) + z36 *
        z2893 - R3 * z2894);
    const double z2896 = z2895 - c_steer * z2826 - s_steer * z2830;
    const double z2897 = z457 * z2640 + (z467 * z2642 + (z1578 * z2563 - z1575 * z2566 - z2700)) - z245 *
        z2746 - z243 * z2747;
    const double z2898 = z2897 - z126 * z2774 - z124 * z2776 - s_steer * z2771 + c_pitch * z2833 - s_pitch *
        z2867;
    const double z2899 = z442 * z2886 + (z447 * z2887 - (z2891 - z48 * z2813)) + s_pitch * z2882 - c_roll *
        z2896 + e2z * z2898;
    const double z2900 = c_yaw * (z2868 - e2z * z2885) + s_yaw * (z2899 + c_pitch * z2884) - z422 * z2036 -
        z427 * z2479;
    const double z2901 = z1625 * z2900;
    const double z2902 = z426 * z2479 - z427 * z2901;
    J[111] = z422 * z2901 - (z352 * z2036 - z353 * z2902);
    const double z2903 = z162 * z1373;
    const double z2904 = z162 * z1384;
    const double z2905 = e1x * z1241 - e1y * z1396;
    const double z2906 = e3x * z1241 - e3y * z1396;
    const double z2907 = z223 + z230;
    const double z2908 = r_F * z230 - z_H * z223;
    const double z2909 = c * z230 + k3 * z223;
    const double z2910 = s_lam * z2908 - c_lam * z2909;
    const double z2911 = c_steer * z2910;
    const double z2912 = c_lam * z2908 + s_lam * z2909;
    const double z2913 = k2 * z2907 + c_lam * z2911 - s_lam * z2912 + x_B * z197;
    const double z2914 = c_roll * z2913 - z38 * z1404 - s_yaw * z1407 + z71 * z1250 - c_yaw * z1252;
    const double z2915 = r_R * z2907 - s_lam * z2911 - c_lam * z2912 + k1 * z197;
    const double z2916 = c_roll * z2915 + s_yaw * z1404 - z38 * z1407 + c_yaw * z1250 + z71 * z1252;
    const double z2917 = h2y * z1397 - z80 * z1242;
    const double z2918 = s_lam * (z51 * z2917) + c_lam * (z53 * z2917);
    const double z2919 = h1y * z1397 + h1x * z1242;
    const double z2920 = h3y * z1397 + h3x * z1242;
    const double z2921 = z53 * z2919 - z51 * z2920;
    const double z2922 = z1236 - R3 * z2905 - z36 * z2906 + c_pitch * z2914 + s_pitch * z2916 + s_steer *
        z2918 - c_steer * z2921;
    const double z2923 = z455 * z2922;
    const double z2924 = z577 * z2923;
    const double z2925 = c_roll * z2924;
    const double z2926 = r_F * (s_pitch * z2925);
    const double z2927 = c_steer * z2926;
    const double z2928 = z12 * z2927;
    const double z2929 = z95 * z2922;
    const double z2930 = z197 + (z161 + z2907) + z2929;
    const double z2931 = z1376 * z2903 - z1379 * z2904 - z162 * z1392 - z517 * z1236 - s_lam * (s_steer *
        z2928) - z453 * z2930;
    const double z2932 = s_yaw * z1413 + c_yaw * z1261;
    const double z2933 = c * z2929;
    const double z2934 = r_F * z2929;
    const double z2935 = c_lam * z2933 - s_lam * z2934;
    const double z2936 = z2910 - z2935;
    const double z2937 = z2931 - z63 * z1413 - z87 * z1261 - z47 * z2932 - z40 * z1412 + z72 * z1256 - 2.0 *
        (z443 * z2936);
    const double z2938 = s_lam * z2933 + c_lam * z2934;
    const double z2939 = c_steer * z2935;
    const double z2940 = z2915 + r_R * z2929 - c_lam * z2938 + s_lam * z2939;
    const double z2941 = z2913 + k2 * z2929 - s_lam * z2938 - c_lam * z2939;
    const double z2942 = c_yaw * z2024 - s_yaw * z1623 + c_pitch * z2940 - s_pitch * z2941;
    const double z2943 = z162 * z1383;
    const double z2944 = c_lam * z2925;
    const double z2945 = r_F * z2944;
    const double z2946 = c_pitch * z2945;
    const double z2947 = z13 * z2946;
    const double z2948 = z440 * z2929;
    const double z2949 = z2943 - z2947 + z2948;
    const double z2950 = s_pitch * z2945;
    const double z2951 = z15 * z2946;
    const double z2952 = 0.5 * (z26 * z2926) + 0.5 * (z24 * z2927) - 0.5 * (z21 * z2945) + z18 * z2950 - 0.5
        * (s_steer * z2951);
    const double z2953 = z9 * z2929;
    const double z2954 = h2z * z2929;
    const double z2955 = z470 * z2919 - z474 * z2917 + z432 * z2953 + z437 * z2954 - h1y * z1433 - h2y *
        z1431;
    const double z2956 = z2955 - h1x * z1271 + z80 * z1269;
    const double z2957 = z10 * z2929;
    const double z2958 = z475 * z2917 - z470 * z2920 - z439 * z2954 - z432 * z2957 + h2y * z1430 + h3y *
        z1433;
    const double z2959 = z2958 - z80 * z1268 + h3x * z1271;
    const double z2960 = z2952 + 0.5 * (z52 * z2956) + 0.5 * (z50 * z2959);
    const double z2961 = z608 * z2960;
    const double z2962 = z12 * z2961;
    const double z2963 = z433 * z2929 + 2.0 * (z10 * z2962) - r_F * (z12 * z2956);
    const double z2964 = z441 * z2929 - 2.0 * (z9 * z2962) + r_F * (z12 * z2959);
    const double z2965 = s_lam * z2963 + c_lam * z2964;
    const double z2966 = z1293 * z2905 + z1290 * z2906 - z457 * z2914 + z467 * z2916 + z443 * z2918 + z445 *
        z2921;
    const double z2967 = z1291 * z1241 - z1340 * z1396 + e1x * z1486 + e1y * z1497;
    const double z2968 = z1283 * z1241 - z1339 * z1396 - e3x * z1486 - e3y * z1497;
    const double z2969 = z1389 + (z1375 * z1373 + z1376 * z1383 + z1386 * z1384) + z1338 * z1405 - z1281 *
        z1408 - z1282 * z1251;
    const double z2970 = c * z2944;
    const double z2971 = z1 * z2970;
    const double z2972 = z2969 + z1280 * z1253 - z456 * z2916 - z481 * z1403 + z499 * z1248 - z27 * z2925 +
        s_lam * z2971;
    const double z2973 = e2z * z2932;
    const double z2974 = c_yaw * z1413 - s_yaw * z1261;
    const double z2975 = z2913 + z2941;
    const double z2976 = z2917 - z2954;
    const double z2977 = c_lam * (z51 * z2976) - s_lam * (z53 * z2976);
    const double z2978 = z2918 - s_lam * (z51 * z2954) - c_lam * (z53 * z2954);
    const double z2979 = z2921 + z53 * z2953 - z51 * z2957;
    const double z2980 = c_steer * z2978 + s_steer * z2979;
    const double z2981 = z73 * z1241 + e2y * z1396 + e2z * z2930;
    const double z2982 = z1235 + c_lam * z2977 + s_lam * z2980 + z36 * z2981;
    const double z2983 = z1377 * z2903 - z1379 * z2943 + z1387 * z2904 + z162 * z1393 - z517 * z1237 - z64 *
        z1413;
    const double z2984 = z456 * z2905 + z430 * z2981 - e1y * z1421 + e2y * z1448 + e1x * z1257 + z73 * z1419;
    const double z2985 = z456 * z2906 + z429 * z2981 - e2y * z1447 - e3y * z1421 - z73 * z1418 + e3x * z1257;
    const double z2986 = 0.5 * (z39 * z2984) + 0.5 * (z33 * z2985);
    const double z2987 = z601 * z2986;
    const double z2988 = z35 * z2987;
    const double z2989 = z2983 - z88 * z1261 - z41 * z1412 - z75 * z1256 + 2.0 * (z2 * z2988) - r_R * (z35 *
        z2985);
    const double z2990 = z2910 + z2936;
    const double z2991 = z445 * z2990 + s_steer * z2948 + c_steer * z2965;
    const double z2992 = z12 * z2950;
    const double z2993 = c_lam * z2963 - s_lam * z2964;
    const double z2994 = z2989 + c_lam * (2.0 * (s_steer * z2947) - z2991) - s_lam * (2.0 * (z17 * z2992) -
        z2993);
    const double z2995 = z2972 + z19 * z2945 - z44 * z2973 + z43 * z2974 + z447 * z2975 + roll_dot * z2982 -
        c_roll * z2994;
    const double z2996 = z2995 - z38 * z1506 - s_yaw * z1504 - z71 * z2006 + c_yaw * z2005;
    const double z2997 = z1393 + (z1377 * z1373 - z1379 * z1383 + z1387 * z1384) - z1281 * z1405 - z1338 *
        z1408 + z1280 * z1251;
    const double z2998 = z2997 - z456 * z2914 + z1282 * z1253 + z481 * z1406 - z499 * z1249 - w * z2925 -
        c_lam * z2971;
    const double z2999 = z2915 + z2940;
    const double z3000 = z1237 + s_lam * z2977 - c_lam * z2980 + R3 * z2981;
    const double z3001 = z12 * z2926;
    const double z3002 = z1375 * z2903 + z1376 * z2943 + z1386 * z2904 + z162 * z1389 - z517 * z1235 + z17 *
        z3001;
    const double z3003 = z3002 + z62 * z1413 + z86 * z1261 - z37 * z1412 - z74 * z1256 - 2.0 * (e3z * z2988);
    const double z3004 = z3003 + r_R * (z35 * z2984) + s_lam * z2991 + c_lam * z2993;
    const double z3005 = z2998 + z16 * z2945 + z44 * z2974 + z43 * z2973 - z447 * z2999 + roll_dot * z3000 +
        c_roll * z3004;
    const double z3006 = z3005 - s_yaw * z1506 + z38 * z1504 + c_yaw * z2006 + z71 * z2005;
    const double z3007 = z1352 * z1397 - z1326 * z1242 + h2y * z1497 - z80 * z1486;
    const double z3008 = z1321 * z2917 + z51 * z3007;
    const double z3009 = z1324 * z2917 + z53 * z3007;
    const double z3010 = s_lam * z3008 + c_lam * z3009;
    const double z3011 = z2966 - z1482 + R3 * z2967 - z36 * z2968 - c_pitch * z2996 + s_pitch * z3006 -
        s_steer * z3010;
    const double z3012 = z1350 * z1397 + z1322 * z1242 + h1y * z1497 + h1x * z1486;
    const double z3013 = z1349 * z1397 + z1309 * z1242 + h3y * z1497 + h3x * z1486;
    const double z3014 = z1324 * z2919 - z1321 * z2920 + z53 * z3012 - z51 * z3013;
    const double z3015 = z3011 + c_steer * z3014;
    const double z3016 = z1528 * z2922 + z95 * z3015;
    const double z3017 = c * z3016;
    const double z3018 = r_F * z3016;
    const double z3019 = c_lam * z3017 - s_lam * z3018;
    const double z3020 = z2965 + z3019;
    const double z3021 = z2937 + roll_dot * z2942 + z1280 * z1446 + z1281 * z1417 - c_steer * z2949 + s_steer
        * z3020 + c_yaw * z2022;
    const double z3022 = z3021 - s_yaw * z1494;
    const double z3023 = z517 * z1373;
    const double z3024 = z517 * z1383;
    const double z3025 = z517 * z1384;
    const double z3026 = z1376 * z3023 - c_steer * z3024 - z1379 * z3025 - z517 * z1392 + z1635 * z1228 -
        z1634 * z1213;
    const double z3027 = z3026 + z1575 * z2915 - z1578 * z2913 + z1526 * z2924 + z1299 * z2932 - z381 * z1729
        - z382 * z1915;
    const double z3028 = m_F * (z229 * z1749);
    const double z3029 = m_H * (z222 * z1749);
    const double z3030 = z3028 + z3029;
    const double z3031 = r_F * z3028 - z_H * z3029;
    const double z3032 = c * z3028 + k3 * z3029;
    const double z3033 = s_lam * z3031 - c_lam * z3032;
    const double z3034 = c_steer * z3033;
    const double z3035 = c_lam * z3031 + s_lam * z3032;
    const double z3036 = m_B * (z196 * z1749);
    const double z3037 = r_R * z3030 - s_lam * z3034 - c_lam * z3035 + k1 * z3036;
    const double z3038 = k2 * z3030 + c_lam * z3034 - s_lam * z3035 + x_B * z3036;
    const double z3039 = z3027 - z296 * z1755 - z297 * z1821 + z243 * z3037 + z245 * z3038 + z181 * z1787 +
        z182 * z1857;
    const double z3040 = z1375 * z3023 + z1376 * z3024 + z1386 * z3025 + z517 * z1389;
    const double z3041 = z1693 - z344 * z1749;
    const double z3042 = z229 * z1777;
    const double z3043 = z3041 - z230 * z1777 - m_F * (g + z3042);
    const double z3044 = z1694 - z338 * z1749;
    const double z3045 = z222 * z1777;
    const double z3046 = z3044 - z223 * z1777 - m_H * (g + z3045);
    const double z3047 = z3043 + z3046;
    const double z3048 = r_F * z3043 - z_H * z3046;
    const double z3049 = c * z3043 + k3 * z3046;
    const double z3050 = s_lam * z3048 - c_lam * z3049;
    const double z3051 = c_steer * z3050;
    const double z3052 = c_lam * z3048 + s_lam * z3049;
    const double z3053 = z1695 - z311 * z1749;
    const double z3054 = z196 * z1777;
    const double z3055 = z3053 - z197 * z1777 - m_B * (g + z3054);
    const double z3056 = z3040 + r_R * z3047 - s_lam * z3051 - c_lam * z3052 + k1 * z3055;
    const double z3057 = z1377 * z3023 - z1379 * z3024 + z1387 * z3025 + z517 * z1393;
    const double z3058 = z3057 + k2 * z3047 + c_lam * z3051 - s_lam * z3052 + x_B * z3055;
    const double z3059 = z467 * z2994 + (z457 * z3004 + (z1281 * z1420 - (z1280 * z1449 - (z3039 - z124 *
        z3056 - z126 * z3058))));
    const double z3060 = z1373 * z1454 + z445 * z1383 - z1384 * z1455;
    const double z3061 = e1x * z1898 - e1y * z1900;
    const double z3062 = e3x * z1898 - e3y * z1900;
    const double z3063 = roll_dot * z1373;
    const double z3064 = roll_dot * z1383;
    const double z3065 = roll_dot * z1384;
    const double z3066 = z1375 * z3063 + z1376 * z3064 + z1386 * z3065 + roll_dot * z1389;
    const double z3067 = z3066 + c_roll * z3058 - z38 * z1908 - s_yaw * z1910 + z71 * z2012 - c_yaw * z2013;
    const double z3068 = z1377 * z3063 - z1379 * z3064 + z1387 * z3065 + roll_dot * z1393;
    const double z3069 = z3068 - c_roll * z3056 - s_yaw * z1908 + z38 * z1910 - c_yaw * z2012 - z71 * z2013;
    const double z3070 = h2y * z1901 - z80 * z1972;
    const double z3071 = s_lam * (z51 * z3070) + c_lam * (z53 * z3070);
    const double z3072 = z3060 + z1888 - R3 * z3061 - z36 * z3062 + c_pitch * z3067 - s_pitch * z3069 +
        s_steer * z3071;
    const double z3073 = h1y * z1901 + h1x * z1972;
    const double z3074 = h3y * z1901 + h3x * z1972;
    const double z3075 = z53 * z3073 - z51 * z3074;
    const double z3076 = z3072 - c_steer * z3075;
    const double z3077 = z95 * z3076;
    const double z3078 = c * z3077;
    const double z3079 = r_F * z3077;
    const double z3080 = c_lam * z3078 - s_lam * z3079;
    const double z3081 = z3050 - z3080;
    const double z3082 = 1.0 / (z29 * z29 * z29);
    const double z3083 = e1x * z1841 - e1y * z1843;
    const double z3084 = e3x * z1841 - e3y * z1843;
    const double z3085 = c_roll * z3038 - z38 * z1850 - s_yaw * z1851 + z71 * z2009 - c_yaw * z2010;
    const double z3086 = c_roll * z3037 + s_yaw * z1850 - z38 * z1851 + c_yaw * z2009 + z71 * z2010;
    const double z3087 = h2y * z1844 - z80 * z1983;
    const double z3088 = s_lam * (z51 * z3087) + c_lam * (z53 * z3087);
    const double z3089 = h1y * z1844 + h1x * z1983;
    const double z3090 = h3y * z1844 + h3x * z1983;
    const double z3091 = z53 * z3089 - z51 * z3090;
    const double z3092 = z1836 - R3 * z3083 - z36 * z3084 + c_pitch * z3085 + s_pitch * z3086 + s_steer *
        z3088 - c_steer * z3091;
    const double z3093 = 2.0 * (z1527 * z2923 * z3082) - z577 * (z1557 * z2922 - z455 * z3015 - z234 * z3092
        + z115 * z3076);
    const double z3094 = z12 * z2945;
    const double z3095 = z447 * z2924 - c_roll * z3093;
    const double z3096 = c_lam * z3095;
    const double z3097 = r_F * z3096;
    const double z3098 = 0.5 * (z1320 * z2945) - z12 * z3097;
    const double z3099 = z1281 * z1413 - z1280 * z1261 - s_yaw * z1944 - c_yaw * z1949;
    const double z3100 = z3059 - s_steer * z3081 - z28 * z3093 + s_lam * (2.0 * (z1514 * z3094) + z17 *
        z3098) - z46 * z3099;
    const double z3101 = z1463 * z2903 - z1454 * z2943 - z1470 * z2904 + z1622 * z1235 - 2.0 * (z1514 *
        z3001) - z1358 * z1413;
    const double z3102 = z3101 - z1332 * z1261 - z1343 * z1412 - z1296 * z1256 - 2.0 * (z1286 * z2988) + z362
        * z1928;
    const double z3103 = r_F * (z467 * z2925 - s_pitch * z3095);
    const double z3104 = 0.5 * (z1320 * z2926) + z12 * z3103;
    const double z3105 = z517 * z1481 + (z3102 + z277 * z1834 + z162 * z1880) - z17 * z3104 - z62 * z1944 -
        z86 * z1949;
    const double z3106 = 1.0 / (z34 * z34);
    const double z3107 = z1295 * z1241 + z1342 * z1396 - z442 * z2930 + z73 * z1486 - e2y * z1497 - e2z *
        z3016;
    const double z3108 = z1558 * z2905 - z1508 * z2981 + z1340 * z1421 - z1342 * z1448 - z1291 * z1257 -
        z1295 * z1419;
    const double z3109 = z3055 + (z1696 - z161 * z1777 - m_R * (g + z113 * z1777) + z3047) + z3077;
    const double z3110 = z73 * z1898 + e2y * z1900 + e2z * z3109;
    const double z3111 = z430 * z3107 - (z3108 - z456 * z2967 + z235 * z3083 - z116 * z3061 + c_pitch *
        z3110) + e1y * z1950;
    const double z3112 = z3111 + e2y * z2030 + e1x * z2014 + z73 * z1981;
    const double z3113 = z1558 * z2906 + z1507 * z2981 + z1342 * z1447 - z1339 * z1421 + z1295 * z1418 +
        z1283 * z1257;
    const double z3114 = z429 * z3107 - (z3113 + z456 * z2968 + z235 * z3084 - z116 * z3062 + s_pitch *
        z3110) - e2y * z2029;
    const double z3115 = z3114 + e3y * z1950 - z73 * z1980 + e3x * z2014;
    const double z3116 = z35 * (z601 * (z1292 * z2984 + z1285 * z2985 - z1287 * z2987 + z39 * z3112 + z33 *
        z3115));
    const double z3117 = z1288 * z2986 * z3106 - 0.5 * z3116;
    const double z3118 = z3105 + z37 * z1943 + z74 * z1947 + 2.0 * (e3z * z3117) - r_R * (0.5 * (z1289 *
        z2984) - z35 * z3112);
    const double z3119 = z95 * z3092;
    const double z3120 = z1537 * z2929 - c_lam * (c * z3119) + s_lam * (r_F * z3119) + z233 * z3119 - z104 *
        z3077;
    const double z3121 = z440 * z3016 - z3120;
    const double z3122 = z3033 - z3121;
    const double z3123 = 1.0 / (z11 * z11);
    const double z3124 = z1524 * z2926 - z1522 * z2927 + z1518 * z2945 + 2.0 * (z1515 * z2950) + z443 * z2951
        + z1323 * z2956;
    const double z3125 = z445 * z2926 - c_steer * z3103;
    const double z3126 = z467 * z2945 - s_pitch * z3097;
    const double z3127 = z3124 + z1316 * z2959 - z1318 * z2961 - z26 * z3103 + z24 * z3125 - z21 * z3097 -
        2.0 * (z18 * z3126);
    const double z3128 = z457 * z2945 + c_pitch * z3097;
    const double z3129 = z1512 * z2946 - z15 * z3128;
    const double z3130 = z1530 * z2929 + h2z * z3016;
    const double z3131 = z1315 * z2929 - z9 * z3016;
    const double z3132 = z1559 * z2919 - z1562 * z2917 + z1510 * z2953 + z1534 * z2954 + z1350 * z1433 +
        z1352 * z1431;
    const double z3133 = z3132 + z1322 * z1271 - z1326 * z1269 - z470 * z3012 + z474 * z3007 + z236 * z3089 +
        z239 * z3087;
    const double z3134 = h2z * z3119;
    const double z3135 = z9 * z3077;
    const double z3136 = h2z * z3077;
    const double z3137 = z432 * z3131 - (z3133 - s_lam * z3134 - z117 * z3073 - z120 * z3070 - z94 * z3135 +
        z101 * z3136);
    const double z3138 = z437 * z3130 - z3137 + h1y * z1963 + h2y * z1961 + h1x * z1997 - z80 * z1995;
    const double z3139 = z1317 * z2929 - z10 * z3016;
    const double z3140 = z1563 * z2917 - z1559 * z2920 + z1536 * z2954 - z1510 * z2957 - z1352 * z1430 -
        z1349 * z1433;
    const double z3141 = z3140 + z1326 * z1268 - z1309 * z1271 - z475 * z3007 + z470 * z3013 - z240 * z3087 -
        z236 * z3090;
    const double z3142 = z10 * z3077;
    const double z3143 = z439 * z3130 - (z3141 + c_lam * z3134 + z121 * z3070 + z117 * z3074 + z103 * z3136 +
        z94 * z3142);
    const double z3144 = z432 * z3139 - z3143 - h2y * z1960 - h3y * z1963 + z80 * z1994 - h3x * z1997;
    const double z3145 = z1319 * z2960 * z3123 - 0.5 * (z12 * (z608 * (z3127 + s_steer * z3129 - z52 * z3138
        - z50 * z3144)));
    const double z3146 = z433 * z3016 - (z1529 * z2929 + 2.0 * (z1317 * z2962) + z96 * z3077) + 2.0 * (z10 *
        z3145);
    const double z3147 = z3146 - r_F * (0.5 * (z1320 * z2956) + z12 * z3138);
    const double z3148 = z441 * z3016 - (z1538 * z2929 - 2.0 * (z1315 * z2962) + z105 * z3077) - 2.0 * (z9 *
        z3145);
    const double z3149 = z3148 + r_F * (0.5 * (z1320 * z2959) + z12 * z3144);
    const double z3150 = s_lam * z3147 + c_lam * z3149;
    const double z3151 = z1544 * z2936 + z443 * z2948 - z445 * z3020 - s_steer * z3122 + c_steer * z3150;
    const double z3152 = c_lam * z3147 - s_lam * z3149;
    const double z3153 = z3118 - s_lam * z3151 - c_lam * z3152;
    const double z3154 = z1464 * z2903 - z1455 * z2943 - z1471 * z2904 - z1622 * z1237 - z1361 * z1413 -
        z1335 * z1261;
    const double z3155 = z3154 + z1344 * z1412 + z1297 * z1256 - 2.0 * (z1284 * z2988) - z362 * z1931 - z277
        * z1837;
    const double z3156 = z517 * z1483 + (z3155 - z162 * z1891) - z64 * z1944 - z88 * z1949 - z41 * z1943 -
        z75 * z1947;
    const double z3157 = z1511 * z2946 - z13 * z3128;
    const double z3158 = z3156 + 2.0 * (z2 * z3117) - r_R * (0.5 * (z1289 * z2985) - z35 * z3115) + c_lam *
        (2.0 * (z443 * z2947) + 2.0 * (s_steer * z3157) - z3151);
    const double z3159 = z1320 * z2950 + 2.0 * (z12 * z3126);
    const double z3160 = z3158 - s_lam * (4.0 * (z1514 * z2992) + z17 * z3159 - z3152);
    const double z3161 = e2z * (roll_dot * z3022 + z3100 + c_pitch * z3153 - c_yaw * z2032 + s_yaw * z2001 +
        s_pitch * z3160);
    const double z3162 = z28 * z2924 - s_lam * (z17 * z3094) - z46 * z2932 + z1280 * z1443 + z1281 * z1414 -
        z457 * z2999;
    const double z3163 = s_steer * z2936 - c_yaw * z1445 + s_yaw * z1416;
    const double z3164 = s_lam * z3017 + c_lam * z3018;
    const double z3165 = z445 * z2935 - c_steer * z3019;
    const double z3166 = z3004 + r_R * z3016 - c_lam * z3164 - s_lam * z3165;
    const double z3167 = z2994 + k2 * z3016 - s_lam * z3164 + c_lam * z3165;
    const double z3168 = z3162 - z467 * z2975 + roll_dot * z3163 + c_yaw * z2023 - s_yaw * z1495 + c_pitch *
        z3166 - s_pitch * z3167;
    const double z3169 = z1454 * z2903 - z1455 * z2904 - z1635 * z1229 + z1634 * z1226 - z1622 * z1236 +
        z1554 * z2930;
    const double z3170 = z3169 + z1360 * z1413 + z1334 * z1261 + z1303 * z2932 - z1341 * z1412 + z1294 *
        z1256 + z1541 * z2936;
    const double z3171 = z3170 + z445 * z2949 + z381 * z1736 + z382 * z1916 - z362 * z1930 + z296 * z1762 +
        z297 * z1822;
    const double z3172 = z1281 * z1279 + (z1280 * z1450 - (z3171 - z277 * z1836 - z181 * z1797 - z182 * z1858
        + z162 * z1888));
    const double z3173 = s_lam * z3078 + c_lam * z3079;
    const double z3174 = c_steer * z3080;
    const double z3175 = z3056 + r_R * z3077 - c_lam * z3173 + s_lam * z3174;
    const double z3176 = z3058 + k2 * z3077 - s_lam * z3173 - c_lam * z3174;
    const double z3177 = 0.5 * (z1320 * z2927) - z12 * z3125;
    const double z3178 = z517 * z1482 - z3172 - z112 * z3109 + c_pitch * z3175 - s_pitch * z3176 - s_lam *
        (z443 * z2928 + s_steer * z3177);
    const double z3179 = z453 * z3016 - z3178 + z63 * z1944 + z87 * z1949 - z47 * z3099 + z40 * z1943 - z72 *
        z1947;
    const double z3180 = z3033 + z3157 - z3121;
    const double z3181 = roll_dot * z3168 + (z443 * z3020 - z3179) + c_steer * z3180 + s_steer * z3150 +
        c_yaw * z2034 + s_yaw * z2021;
    const double z3182 = z3161 - c_roll * z3181;
    const double z3183 = z277 * z1373;
    const double z3184 = z277 * z1384;
    const double z3185 = e1x * z2071 - e1y * z2113;
    const double z3186 = e3x * z2071 - e3y * z2113;
    const double z3187 = z338 + z344;
    const double z3188 = r_F * z344 - z_H * z338;
    const double z3189 = c * z344 + k3 * z338;
    const double z3190 = s_lam * z3188 - c_lam * z3189;
    const double z3191 = c_steer * z3190;
    const double z3192 = c_lam * z3188 + s_lam * z3189;
    const double z3193 = k2 * z3187 + c_lam * z3191 - s_lam * z3192 + x_B * z311;
    const double z3194 = c_roll * z3193 - z38 * z2121 - s_yaw * z2124 + z71 * z2080 - c_yaw * z2082;
    const double z3195 = r_R * z3187 - s_lam * z3191 - c_lam * z3192 + k1 * z311;
    const double z3196 = c_roll * z3195 + s_yaw * z2121 - z38 * z2124 + c_yaw * z2080 + z71 * z2082;
    const double z3197 = h2y * z2114 - z80 * z2072;
    const double z3198 = s_lam * (z51 * z3197) + c_lam * (z53 * z3197);
    const double z3199 = h1y * z2114 + h1x * z2072;
    const double z3200 = h3y * z2114 + h3x * z2072;
    const double z3201 = z53 * z3199 - z51 * z3200;
    const double z3202 = z2066 - R3 * z3185 - z36 * z3186 + c_pitch * z3194 + s_pitch * z3196 + s_steer *
        z3198 - c_steer * z3201;
    const double z3203 = z455 * z3202;
    const double z3204 = z577 * z3203;
    const double z3205 = c_roll * z3204;
    const double z3206 = r_F * (s_pitch * z3205);
    const double z3207 = c_steer * z3206;
    const double z3208 = z12 * z3207;
    const double z3209 = z311 + z3187;
    const double z3210 = z95 * z3202;
    const double z3211 = z3209 + z3210;
    const double z3212 = z277 * z1392 - z1376 * z3183 + z1379 * z3184 + z517 * z2066 + s_lam * (s_steer *
        z3208) + z453 * z3211;
    const double z3213 = s_yaw * z2130 + c_yaw * z2091;
    const double z3214 = c * z3210;
    const double z3215 = r_F * z3210;
    const double z3216 = c_lam * z3214 - s_lam * z3215;
    const double z3217 = z3190 - z3216;
    const double z3218 = z3212 + z63 * z2130 + z87 * z2091 + z47 * z3213 + z40 * z2129 - z72 * z2086 + 2.0 *
        (z443 * z3217);
    const double z3219 = s_lam * z3214 + c_lam * z3215;
    const double z3220 = c_steer * z3216;
    const double z3221 = z3195 + r_R * z3210 - c_lam * z3219 + s_lam * z3220;
    const double z3222 = z3193 + k2 * z3210 - s_lam * z3219 - c_lam * z3220;
    const double z3223 = c_yaw * z2467 - s_yaw * z2201 + c_pitch * z3221 - s_pitch * z3222;
    const double z3224 = z277 * z1383;
    const double z3225 = c_lam * z3205;
    const double z3226 = r_F * z3225;
    const double z3227 = c_pitch * z3226;
    const double z3228 = z13 * z3227;
    const double z3229 = z440 * z3210;
    const double z3230 = z3224 - z3228 + z3229;
    const double z3231 = s_pitch * z3226;
    const double z3232 = z15 * z3227;
    const double z3233 = 0.5 * (z26 * z3206) + 0.5 * (z24 * z3207) - 0.5 * (z21 * z3226) + z18 * z3231 - 0.5
        * (s_steer * z3232);
    const double z3234 = z9 * z3210;
    const double z3235 = h2z * z3210;
    const double z3236 = z470 * z3199 - z474 * z3197 + z432 * z3234 + z437 * z3235 - h1y * z2150 - h2y *
        z2148;
    const double z3237 = z3236 - h1x * z2101 + z80 * z2099;
    const double z3238 = z10 * z3210;
    const double z3239 = z475 * z3197 - z470 * z3200 - z439 * z3235 - z432 * z3238 + h2y * z2147 + h3y *
        z2150;
    const double z3240 = z3239 - z80 * z2098 + h3x * z2101;
    const double z3241 = z3233 + 0.5 * (z52 * z3237) + 0.5 * (z50 * z3240);
    const double z3242 = z608 * z3241;
    const double z3243 = z12 * z3242;
    const double z3244 = z433 * z3210 + 2.0 * (z10 * z3243) - r_F * (z12 * z3237);
    const double z3245 = z441 * z3210 - 2.0 * (z9 * z3243) + r_F * (z12 * z3240);
    const double z3246 = s_lam * z3244 + c_lam * z3245;
    const double z3247 = z1374 * z1373 - z1385 * z1384 - z1293 * z3185 - z1290 * z3186 + z457 * z3194 - z467
        * z3196;
    const double z3248 = z1291 * z2071 - z1340 * z2113 + e1x * z2180 + e1y * z2191;
    const double z3249 = z1283 * z2071 - z1339 * z2113 - e3x * z2180 - e3y * z2191;
    const double z3250 = z1338 * z2122 - z1281 * z2125 - z1282 * z2081 + z1280 * z2083 - z456 * z3196 - z481
        * z2120;
    const double z3251 = c * z3225;
    const double z3252 = z1 * z3251;
    const double z3253 = e2z * z3213;
    const double z3254 = c_yaw * z2130 - s_yaw * z2091;
    const double z3255 = z3250 + z499 * z2078 - z27 * z3205 + s_lam * z3252 + z19 * z3226 - z44 * z3253 + z43
        * z3254;
    const double z3256 = z3193 + z3222;
    const double z3257 = z3197 - z3235;
    const double z3258 = c_lam * (z51 * z3257) - s_lam * (z53 * z3257);
    const double z3259 = z3198 - s_lam * (z51 * z3235) - c_lam * (z53 * z3235);
    const double z3260 = z3201 + z53 * z3234 - z51 * z3238;
    const double z3261 = c_steer * z3259 + s_steer * z3260;
    const double z3262 = z73 * z2071 + e2y * z2113 + e2z * z3211;
    const double z3263 = z2064 - c_lam * z3258 - s_lam * z3261 - z36 * z3262;
    const double z3264 = z277 * z1393 + z1377 * z3183 - z1379 * z3224 + z1387 * z3184 + z517 * z2067 - z64 *
        z2130;
    const double z3265 = z456 * z3185 + z430 * z3262 - e1y * z2138 + e2y * z2164 + e1x * z2087 + z73 * z2136;
    const double z3266 = z456 * z3186 + z429 * z3262 - e2y * z2163 - e3y * z2138 - z73 * z2135 + e3x * z2087;
    const double z3267 = 0.5 * (z39 * z3265) + 0.5 * (z33 * z3266);
    const double z3268 = z601 * z3267;
    const double z3269 = z35 * z3268;
    const double z3270 = z3264 - z88 * z2091 - z41 * z2129 - z75 * z2086 + 2.0 * (z2 * z3269) - r_R * (z35 *
        z3266);
    const double z3271 = z3190 + z3217;
    const double z3272 = z445 * z3271 + s_steer * z3229 + c_steer * z3246;
    const double z3273 = z12 * z3231;
    const double z3274 = c_lam * z3244 - s_lam * z3245;
    const double z3275 = z3270 + c_lam * (2.0 * (s_steer * z3228) - z3272) - s_lam * (2.0 * (z17 * z3273) -
        z3274);
    const double z3276 = z3255 + z447 * z3256 - roll_dot * z3263 - c_roll * z3275 - z38 * z2200 - s_yaw *
        z2198 - z71 * z2449;
    const double z3277 = z3276 + c_yaw * z2448;
    const double z3278 = z3247 - z443 * z3198 - z445 * z3201 + z2176 - R3 * z3248 + z36 * z3249 + c_pitch *
        z3277;
    const double z3279 = z1281 * z2122 + z1338 * z2125 - z1280 * z2081 + z456 * z3194 - z1282 * z2083 - z481
        * z2123;
    const double z3280 = z3279 + z499 * z2079 + w * z3205 + c_lam * z3252 - z16 * z3226 - z44 * z3254 - z43 *
        z3253;
    const double z3281 = z3195 + z3221;
    const double z3282 = z2067 - s_lam * z3258 + c_lam * z3261 - R3 * z3262;
    const double z3283 = z12 * z3206;
    const double z3284 = z277 * z1389 + z1375 * z3183 + z1376 * z3224 + z1386 * z3184 + z517 * z2064 + z17 *
        z3283;
    const double z3285 = z3284 + z62 * z2130 + z86 * z2091 - z37 * z2129 - z74 * z2086 - 2.0 * (e3z * z3269);
    const double z3286 = z3285 + r_R * (z35 * z3265) + s_lam * z3272 + c_lam * z3274;
    const double z3287 = z3280 + z447 * z3281 + roll_dot * z3282 - c_roll * z3286 + s_yaw * z2200 - z38 *
        z2198 - c_yaw * z2449;
    const double z3288 = z3287 - z71 * z2448;
    const double z3289 = z1352 * z2114 - z1326 * z2072 + h2y * z2191 - z80 * z2180;
    const double z3290 = z1321 * z3197 + z51 * z3289;
    const double z3291 = z1324 * z3197 + z53 * z3289;
    const double z3292 = s_lam * z3290 + c_lam * z3291;
    const double z3293 = z1383 + z3292;
    const double z3294 = z1350 * z2114 + z1322 * z2072 + h1y * z2191 + h1x * z2180;
    const double z3295 = z1349 * z2114 + z1309 * z2072 + h3y * z2191 + h3x * z2180;
    const double z3296 = z1324 * z3199 - z1321 * z3200 + z53 * z3294 - z51 * z3295;
    const double z3297 = z3278 + s_pitch * z3288 + s_steer * z3293 - c_steer * z3296;
    const double z3298 = z1528 * z3202 - z95 * z3297;
    const double z3299 = c * z3298;
    const double z3300 = r_F * z3298;
    const double z3301 = c_lam * z3299 - s_lam * z3300;
    const double z3302 = z3246 + z3301;
    const double z3303 = z3218 - roll_dot * z3223 - z1280 * z2162 - z1281 * z2134 + c_steer * z3230 - s_steer
        * z3302 - c_yaw * z2465;
    const double z3304 = z3303 + s_yaw * z2188;
    const double z3305 = z1635 * z2057 - z1634 * z2042 + z1575 * z3195 - z1578 * z3193 + z1526 * z3204 +
        z1299 * z3213;
    const double z3306 = z3041 - m_F * (z3042 + (g + z343 * z1749));
    const double z3307 = z3044 - m_H * (z3045 + (g + z337 * z1749));
    const double z3308 = z3306 + z3307;
    const double z3309 = r_F * z3306 - z_H * z3307;
    const double z3310 = c * z3306 + k3 * z3307;
    const double z3311 = s_lam * z3309 - c_lam * z3310;
    const double z3312 = c_steer * z3311;
    const double z3313 = c_lam * z3309 + s_lam * z3310;
    const double z3314 = z3053 - m_B * (z3054 + (g + z310 * z1749));
    const double z3315 = z3040 + r_R * z3308 - s_lam * z3312 - c_lam * z3313 + k1 * z3314;
    const double z3316 = z3057 + k2 * z3308 + c_lam * z3312 - s_lam * z3313 + x_B * z3314;
    const double z3317 = z3305 - z381 * z2208 - z382 * z2359 + z296 * z2235 + z297 * z2287 - z243 * z3315 -
        z245 * z3316;
    const double z3318 = z1777 * z3187;
    const double z3319 = z344 * z1777;
    const double z3320 = z338 * z1777;
    const double z3321 = r_F * z3319 - z_H * z3320;
    const double z3322 = c * z3319 + k3 * z3320;
    const double z3323 = s_lam * z3321 - c_lam * z3322;
    const double z3324 = c_steer * z3323;
    const double z3325 = c_lam * z3321 + s_lam * z3322;
    const double z3326 = z311 * z1777;
    const double z3327 = r_R * z3318 - s_lam * z3324 - c_lam * z3325 + k1 * z3326;
    const double z3328 = k2 * z3318 + c_lam * z3324 - s_lam * z3325 + x_B * z3326;
    const double z3329 = z1281 * z2137 - (z1280 * z2165 - (z3317 - z181 * z2264 - z182 * z2328 + z124 * z3327
        + z126 * z3328));
    const double z3330 = e1x * z2343 - e1y * z2345;
    const double z3331 = e3x * z2343 - e3y * z2345;
    const double z3332 = c_roll * z3328 - z38 * z2353 - s_yaw * z2355 + z71 * z2455 - c_yaw * z2456;
    const double z3333 = c_roll * z3327 + s_yaw * z2353 - z38 * z2355 + c_yaw * z2455 + z71 * z2456;
    const double z3334 = h2y * z2346 - z80 * z2415;
    const double z3335 = s_lam * (z51 * z3334) + c_lam * (z53 * z3334);
    const double z3336 = h1y * z2346 + h1x * z2415;
    const double z3337 = h3y * z2346 + h3x * z2415;
    const double z3338 = z53 * z3336 - z51 * z3337;
    const double z3339 = z2338 - R3 * z3330 - z36 * z3331 + c_pitch * z3332 + s_pitch * z3333 + s_steer *
        z3335 - c_steer * z3338;
    const double z3340 = z95 * z3339;
    const double z3341 = c * z3340;
    const double z3342 = r_F * z3340;
    const double z3343 = c_lam * z3341 - s_lam * z3342;
    const double z3344 = z3323 - z3343;
    const double z3345 = e1x * z2316 - e1y * z2318;
    const double z3346 = e3x * z2316 - e3y * z2318;
    const double z3347 = z3066 + c_roll * z3316 - z38 * z2325 - s_yaw * z2326 + z71 * z2452 - c_yaw * z2453;
    const double z3348 = z3068 - c_roll * z3315 - s_yaw * z2325 + z38 * z2326 - c_yaw * z2452 - z71 * z2453;
    const double z3349 = h2y * z2319 - z80 * z2426;
    const double z3350 = s_lam * (z51 * z3349) + c_lam * (z53 * z3349);
    const double z3351 = z3060 + z2310 - R3 * z3345 - z36 * z3346 + c_pitch * z3347 - s_pitch * z3348 +
        s_steer * z3350;
    const double z3352 = h1y * z2319 + h1x * z2426;
    const double z3353 = h3y * z2319 + h3x * z2426;
    const double z3354 = z53 * z3352 - z51 * z3353;
    const double z3355 = z3351 - c_steer * z3354;
    const double z3356 = 2.0 * (z3082 * (z1527 * z3203)) - z577 * (z1557 * z3202 + z455 * z3297 + z234 *
        z3355 - z115 * z3339);
    const double z3357 = z12 * z3226;
    const double z3358 = z447 * z3204 - c_roll * z3356;
    const double z3359 = c_lam * z3358;
    const double z3360 = r_F * z3359;
    const double z3361 = 0.5 * (z1320 * z3226) - z12 * z3360;
    const double z3362 = z467 * z3275 + (z457 * z3286 + z3329) + s_steer * z3344 - z28 * z3356 + s_lam * (2.0
        * (z1514 * z3357) + z17 * z3361);
    const double z3363 = z1281 * z2130 - z1280 * z2091 - s_yaw * z2387 - c_yaw * z2392;
    const double z3364 = z1706 * z3023 - z1374 * z3024 - z1711 * z3025 + z1463 * z3183 - z1454 * z3224 -
        z1470 * z3184;
    const double z3365 = z3364 - z1622 * z2064 - 2.0 * (z1514 * z3283) - z1358 * z2130 - z1332 * z2091 -
        z1343 * z2129;
    const double z3366 = z3365 - z1296 * z2086 - 2.0 * (z1286 * z3269) + z362 * z2372 + z277 * z2306 - z162 *
        z2337;
    const double z3367 = r_F * (z467 * z3205 - s_pitch * z3358);
    const double z3368 = 0.5 * (z1320 * z3206) + z12 * z3367;
    const double z3369 = z517 * z2175 - z3366 + z17 * z3368 + z62 * z2387 + z86 * z2392 - z37 * z2386 - z74 *
        z2390;
    const double z3370 = z1295 * z2071 + z1342 * z2113 - z442 * z3211 + z73 * z2180 - e2y * z2191 - e2z *
        z3298;
    const double z3371 = z1558 * z3185 - z1508 * z3262 + z1340 * z2138 - z1342 * z2164 - z1291 * z2087 -
        z1295 * z2136;
    const double z3372 = z1777 * z3209 + z3340;
    const double z3373 = z73 * z2343 + e2y * z2345 + e2z * z3372;
    const double z3374 = z430 * z3370 - (z3371 - z456 * z3248 - z235 * z3345 + z116 * z3330 - c_pitch *
        z3373) + e1y * z2393;
    const double z3375 = z3374 + e2y * z2473 + e1x * z2457 + z73 * z2424;
    const double z3376 = z1558 * z3186 + z1507 * z3262 + z1342 * z2163 - z1339 * z2138 + z1295 * z2135 +
        z1283 * z2087;
    const double z3377 = z429 * z3370 - (z3376 + z456 * z3249 - z235 * z3346 + z116 * z3331 - s_pitch *
        z3373) - e2y * z2472;
    const double z3378 = z3377 + e3y * z2393 - z73 * z2423 + e3x * z2457;
    const double z3379 = z35 * (z601 * (z1292 * z3265 + z1285 * z3266 - z1287 * z3268 + z39 * z3375 + z33 *
        z3378));
    const double z3380 = z3106 * (z1288 * z3267) - 0.5 * z3379;
    const double z3381 = z95 * z3355;
    const double z3382 = z1537 * z3210 + c_lam * (c * z3381) - s_lam * (r_F * z3381) - z233 * z3381 + z104 *
        z3340;
    const double z3383 = z440 * z3298 - z3382;
    const double z3384 = z3311 + z3383;
    const double z3385 = z1524 * z3206 - z1522 * z3207 + z1518 * z3226 + 2.0 * (z1515 * z3231) + z443 * z3232
        + z1323 * z3237;
    const double z3386 = z445 * z3206 - c_steer * z3367;
    const double z3387 = z467 * z3226 - s_pitch * z3360;
    const double z3388 = z3385 + z1316 * z3240 - z1318 * z3242 - z26 * z3367 + z24 * z3386 - z21 * z3360 -
        2.0 * (z18 * z3387);
    const double z3389 = z457 * z3226 + c_pitch * z3360;
    const double z3390 = z1512 * z3227 - z15 * z3389;
    const double z3391 = z1530 * z3210 + h2z * z3298;
    const double z3392 = z1315 * z3210 - z9 * z3298;
    const double z3393 = z1559 * z3199 - z1562 * z3197 + z1510 * z3234 + z1534 * z3235 + z1350 * z2150 +
        z1352 * z2148;
    const double z3394 = z3393 + z1322 * z2101 - z1326 * z2099 - z470 * z3294 + z474 * z3289 - z236 * z3352 -
        z239 * z3349;
    const double z3395 = h2z * z3381;
    const double z3396 = z9 * z3340;
    const double z3397 = h2z * z3340;
    const double z3398 = z432 * z3392 - (z3394 + s_lam * z3395 + z117 * z3336 + z120 * z3334 + z94 * z3396 -
        z101 * z3397);
    const double z3399 = z437 * z3391 - z3398 + h1y * z2406 + h2y * z2404 + h1x * z2440 - z80 * z2438;
    const double z3400 = z1317 * z3210 - z10 * z3298;
    const double z3401 = z1563 * z3197 - z1559 * z3200 + z1536 * z3235 - z1510 * z3238 - z1352 * z2147 -
        z1349 * z2150;
    const double z3402 = z3401 + z1326 * z2098 - z1309 * z2101 - z475 * z3289 + z470 * z3295 + z240 * z3349 +
        z236 * z3353;
    const double z3403 = z10 * z3340;
    const double z3404 = z439 * z3391 - (z3402 - c_lam * z3395 - z121 * z3334 - z117 * z3337 - z103 * z3397 -
        z94 * z3403);
    const double z3405 = z432 * z3400 - z3404 - h2y * z2403 - h3y * z2406 + z80 * z2437 - h3x * z2440;
    const double z3406 = z3123 * (z1319 * z3241) - 0.5 * (z12 * (z608 * (z3388 + s_steer * z3390 - z52 *
        z3399 - z50 * z3405)));
    const double z3407 = z433 * z3298 - (z1529 * z3210 + 2.0 * (z1317 * z3243) - z96 * z3340) + 2.0 * (z10 *
        z3406);
    const double z3408 = z3407 - r_F * (0.5 * (z1320 * z3237) + z12 * z3399);
    const double z3409 = z441 * z3298 - (z1538 * z3210 - 2.0 * (z1315 * z3243) - z105 * z3340) - 2.0 * (z9 *
        z3406);
    const double z3410 = z3409 + r_F * (0.5 * (z1320 * z3240) + z12 * z3405);
    const double z3411 = s_lam * z3408 + c_lam * z3410;
    const double z3412 = z1544 * z3217 + z443 * z3229 - z445 * z3302 + s_steer * z3384 + c_steer * z3411;
    const double z3413 = z3369 - 2.0 * (e3z * z3380) + r_R * (0.5 * (z1289 * z3265) - z35 * z3375) + s_lam *
        z3412;
    const double z3414 = c_lam * z3408 - s_lam * z3410;
    const double z3415 = z3413 + c_lam * z3414;
    const double z3416 = z1707 * z3023 - z1385 * z3024 - z1712 * z3025 + z1464 * z3183 - z1455 * z3224 -
        z1471 * z3184;
    const double z3417 = z3416 + z1622 * z2067 - z1361 * z2130 - z1335 * z2091 + z1344 * z2129 + z1297 *
        z2086 - 2.0 * (z1284 * z3269);
    const double z3418 = z517 * z2177 - (z3417 - z362 * z2375 - z277 * z2311 + z162 * z2339) + z64 * z2387 +
        z88 * z2392;
    const double z3419 = z3418 + z41 * z2386 + z75 * z2390 - 2.0 * (z2 * z3380) + r_R * (0.5 * (z1289 *
        z3266) - z35 * z3378);
    const double z3420 = z1511 * z3227 - z13 * z3389;
    const double z3421 = z1320 * z3231 + 2.0 * (z12 * z3387);
    const double z3422 = z3419 - c_lam * (2.0 * (z443 * z3228) + 2.0 * (s_steer * z3420) - z3412) + s_lam *
        (4.0 * (z1514 * z3273) + z17 * z3421 - z3414);
    const double z3423 = roll_dot * z3304 - (z3362 - z46 * z3363) + c_pitch * z3415 + c_yaw * z2475 - s_yaw *
        z2444 + s_pitch * z3422;
    const double z3424 = z28 * z3204 - s_lam * (z17 * z3357) - z46 * z3213 + z1280 * z2159 + z1281 * z2131 -
        z457 * z3281;
    const double z3425 = s_steer * z3217 - c_yaw * z2161 + s_yaw * z2133;
    const double z3426 = s_lam * z3299 + c_lam * z3300;
    const double z3427 = z445 * z3216 - c_steer * z3301;
    const double z3428 = z3286 + r_R * z3298 - c_lam * z3426 - s_lam * z3427;
    const double z3429 = z3275 + k2 * z3298 - s_lam * z3426 + c_lam * z3427;
    const double z3430 = z3424 - z467 * z3256 + roll_dot * z3425 + c_yaw * z2466 - s_yaw * z2189 + c_pitch *
        z3428 - s_pitch * z3429;
    const double z3431 = z1374 * z3023 - z1385 * z3025 + z1454 * z3183 - z1455 * z3184 - z1635 * z2058 +
        z1634 * z2055;
    const double z3432 = z3431 - z1622 * z2066 + z1554 * z3211 + z1360 * z2130 + z1334 * z2091 + z1303 *
        z3213 - z1341 * z2129;
    const double z3433 = z3432 + z1294 * z2086 + z1541 * z3217 + z445 * z3230 + z381 * z2215 + z382 * z2360 -
        z362 * z2374;
    const double z3434 = z3433 - z296 * z2243 - z297 * z2288 + z277 * z2310 + z181 * z2271 + z182 * z2329 -
        z162 * z2338;
    const double z3435 = s_lam * z3341 + c_lam * z3342;
    const double z3436 = c_steer * z3343;
    const double z3437 = z3327 + r_R * z3340 - c_lam * z3435 + s_lam * z3436;
    const double z3438 = z3328 + k2 * z3340 - s_lam * z3435 - c_lam * z3436;
    const double z3439 = z517 * z2176 - (z1281 * z2109 + (z1280 * z2166 - z3434)) + z112 * z3372 - c_pitch *
        z3437 + s_pitch * z3438;
    const double z3440 = 0.5 * (z1320 * z3207) - z12 * z3386;
    const double z3441 = z453 * z3298 - (z3439 - s_lam * (z443 * z3208 + s_steer * z3440)) + z63 * z2387 +
        z87 * z2392;
    const double z3442 = z3311 - z3420 + z3383;
    const double z3443 = roll_dot * z3430 + (z443 * z3302 - (z3441 - z47 * z3363 + z40 * z2386 - z72 *
        z2390)) - c_steer * z3442;
    const double z3444 = z3024 + z3411;
    const double z3445 = e2z * z3423 + c_roll * (z3443 + s_steer * z3444 + c_yaw * z2477 + s_yaw * z2464) +
        z353 * z3182;
    const double z3446 = z362 * z1373;
    const double z3447 = z362 * z1384;
    const double z3448 = e1x * z2514 - e1y * z2555;
    const double z3449 = e3x * z2514 - e3y * z2555;
    const double z3450 = z38 * z2563 + s_yaw * z2566 - z71 * z2523 + c_yaw * z2525;
    const double z3451 = s_yaw * z2563 - z38 * z2566 + c_yaw * z2523 + z71 * z2525;
    const double z3452 = h2y * z2556 - z80 * z2515;
    const double z3453 = s_lam * (z51 * z3452) + c_lam * (z53 * z3452);
    const double z3454 = h1y * z2556 + h1x * z2515;
    const double z3455 = h3y * z2556 + h3x * z2515;
    const double z3456 = z53 * z3454 - z51 * z3455;
    const double z3457 = z2509 + R3 * z3448 + z36 * z3449 + c_pitch * z3450 - s_pitch * z3451 - s_steer *
        z3453 + c_steer * z3456;
    const double z3458 = z455 * z3457;
    const double z3459 = z577 * z3458;
    const double z3460 = c_roll * z3459;
    const double z3461 = r_F * (s_pitch * z3460);
    const double z3462 = c_steer * z3461;
    const double z3463 = z12 * z3462;
    const double z3464 = z95 * z3457;
    const double z3465 = z362 * z1392 - z1376 * z3446 + z1379 * z3447 - z517 * z2509 - s_lam * (s_steer *
        z3463) - z453 * z3464;
    const double z3466 = s_yaw * z2572 + c_yaw * z2534;
    const double z3467 = c * z3464;
    const double z3468 = r_F * z3464;
    const double z3469 = c_lam * z3467 - s_lam * z3468;
    const double z3470 = z3465 + z63 * z2572 + z87 * z2534 + z47 * z3466 + z40 * z2571 - z72 * z2529 + 2.0 *
        (z443 * z3469);
    const double z3471 = s_lam * z3467 + c_lam * z3468;
    const double z3472 = c_steer * z3469;
    const double z3473 = r_R * z3464 - c_lam * z3471 + s_lam * z3472;
    const double z3474 = k2 * z3464 - s_lam * z3471 - c_lam * z3472;
    const double z3475 = c_yaw * z2888 - s_yaw * z2643 - c_pitch * z3473 + s_pitch * z3474;
    const double z3476 = z362 * z1383;
    const double z3477 = c_lam * z3460;
    const double z3478 = r_F * z3477;
    const double z3479 = c_pitch * z3478;
    const double z3480 = z13 * z3479;
    const double z3481 = z440 * z3464;
    const double z3482 = z3476 + z3480 - z3481;
    const double z3483 = s_pitch * z3478;
    const double z3484 = z15 * z3479;
    const double z3485 = 0.5 * (z26 * z3461) + 0.5 * (z24 * z3462) - 0.5 * (z21 * z3478) + z18 * z3483 - 0.5
        * (s_steer * z3484);
    const double z3486 = z9 * z3464;
    const double z3487 = h2z * z3464;
    const double z3488 = z470 * z3454 - z474 * z3452 - z432 * z3486 - z437 * z3487 - h1y * z2592 - h2y *
        z2590;
    const double z3489 = z3488 - h1x * z2544 + z80 * z2542;
    const double z3490 = z10 * z3464;
    const double z3491 = z475 * z3452 - z470 * z3455 + z439 * z3487 + z432 * z3490 + h2y * z2589 + h3y *
        z2592;
    const double z3492 = z3491 - z80 * z2541 + h3x * z2544;
    const double z3493 = z3485 - 0.5 * (z52 * z3489) - 0.5 * (z50 * z3492);
    const double z3494 = z608 * z3493;
    const double z3495 = z12 * z3494;
    const double z3496 = z433 * z3464 + 2.0 * (z10 * z3495) + r_F * (z12 * z3489);
    const double z3497 = z441 * z3464 - 2.0 * (z9 * z3495) - r_F * (z12 * z3492);
    const double z3498 = s_lam * z3496 + c_lam * z3497;
    const double z3499 = z1293 * z3448 + z1290 * z3449 + z457 * z3450 + z467 * z3451 + z443 * z3453 + z445 *
        z3456;
    const double z3500 = z1291 * z2514 - z1340 * z2555 + e1x * z2622 + e1y * z2633;
    const double z3501 = z1283 * z2514 - z1339 * z2555 - e3x * z2622 - e3y * z2633;
    const double z3502 = z1338 * z2564 - z1281 * z2567 - z1282 * z2524 + z1280 * z2526 - z456 * z3451 - z481
        * z2562;
    const double z3503 = c * z3477;
    const double z3504 = z1 * z3503;
    const double z3505 = e2z * z3466;
    const double z3506 = c_yaw * z2572 - s_yaw * z2534;
    const double z3507 = z3502 + z499 * z2521 + z27 * z3460 - s_lam * z3504 - z19 * z3478 - z44 * z3505 + z43
        * z3506;
    const double z3508 = z3452 + z3487;
    const double z3509 = c_lam * (z51 * z3508) - s_lam * (z53 * z3508);
    const double z3510 = z3453 + s_lam * (z51 * z3487) + c_lam * (z53 * z3487);
    const double z3511 = z3456 - z53 * z3486 + z51 * z3490;
    const double z3512 = c_steer * z3510 + s_steer * z3511;
    const double z3513 = z73 * z2514 + e2y * z2555 - e2z * z3464;
    const double z3514 = z2507 - c_lam * z3509 - s_lam * z3512 - z36 * z3513;
    const double z3515 = z362 * z1393 + z1377 * z3446 - z1379 * z3476 + z1387 * z3447 + z517 * z2510 - z64 *
        z2572;
    const double z3516 = z456 * z3448 + z430 * z3513 - e1y * z2580 + e2y * z2607 + e1x * z2530 + z73 * z2578;
    const double z3517 = z456 * z3449 + z429 * z3513 - e2y * z2606 - e3y * z2580 - z73 * z2577 + e3x * z2530;
    const double z3518 = 0.5 * (z39 * z3516) + 0.5 * (z33 * z3517);
    const double z3519 = z601 * z3518;
    const double z3520 = z35 * z3519;
    const double z3521 = z3515 - z88 * z2534 - z41 * z2571 - z75 * z2529 + 2.0 * (z2 * z3520) - r_R * (z35 *
        z3517);
    const double z3522 = z445 * z3469;
    const double z3523 = z3522 - s_steer * z3481 - c_steer * z3498;
    const double z3524 = z12 * z3483;
    const double z3525 = c_lam * z3496 - s_lam * z3497;
    const double z3526 = z3521 - c_lam * (2.0 * (s_steer * z3480) + z3523) + s_lam * (2.0 * (z17 * z3524) -
        z3525);
    const double z3527 = z3507 - z447 * z3474 - roll_dot * z3514 - c_roll * z3526 - z38 * z2642 - s_yaw *
        z2640 - z71 * z2870;
    const double z3528 = z3527 + c_yaw * z2869;
    const double z3529 = z1281 * z2564 + z1338 * z2567 - z1280 * z2524 - z456 * z3450 - z1282 * z2526 - z481
        * z2565;
    const double z3530 = z3529 + z499 * z2522 - w * z3460 - c_lam * z3504 + z16 * z3478 - z44 * z3506 - z43 *
        z3505;
    const double z3531 = z2510 - s_lam * z3509 + c_lam * z3512 - R3 * z3513;
    const double z3532 = z12 * z3461;
    const double z3533 = z362 * z1389 + z1375 * z3446 + z1376 * z3476 + z1386 * z3447 + z517 * z2507 - z17 *
        z3532;
    const double z3534 = z3533 + z62 * z2572 + z86 * z2534 - z37 * z2571 - z74 * z2529 - 2.0 * (e3z * z3520);
    const double z3535 = z3534 + r_R * (z35 * z3516) + s_lam * z3523 - c_lam * z3525;
    const double z3536 = z3530 - z447 * z3473 + roll_dot * z3531 - c_roll * z3535 + s_yaw * z2642 - z38 *
        z2640 - c_yaw * z2870;
    const double z3537 = z3536 - z71 * z2869;
    const double z3538 = z1352 * z2556 - z1326 * z2515 + h2y * z2633 - z80 * z2622;
    const double z3539 = z1321 * z3452 + z51 * z3538;
    const double z3540 = z1324 * z3452 + z53 * z3538;
    const double z3541 = s_lam * z3539 + c_lam * z3540;
    const double z3542 = z3499 - z2618 + R3 * z3500 - z36 * z3501 - c_pitch * z3528 - s_pitch * z3537 -
        s_steer * z3541;
    const double z3543 = z1350 * z2556 + z1322 * z2515 + h1y * z2633 + h1x * z2622;
    const double z3544 = z1349 * z2556 + z1309 * z2515 + h3y * z2633 + h3x * z2622;
    const double z3545 = z1324 * z3454 - z1321 * z3455 + z53 * z3543 - z51 * z3544;
    const double z3546 = z3542 + c_steer * z3545;
    const double z3547 = z1528 * z3457 - z95 * z3546;
    const double z3548 = c * z3547;
    const double z3549 = r_F * z3547;
    const double z3550 = c_lam * z3548 - s_lam * z3549;
    const double z3551 = z3498 + z3550;
    const double z3552 = z3470 - roll_dot * z3475 - z1280 * z2605 - z1281 * z2576 + c_steer * z3482 + s_steer
        * z3551 - c_yaw * z2886;
    const double z3553 = z3552 + s_yaw * z2630;
    const double z3554 = z1635 * z2500 - z1634 * z2485 - z1526 * z3459 + z1299 * z3466 + z381 * z2650 + z382
        * z2780;
    const double z3555 = z1281 * z2579 - (z1280 * z2608 - (z3554 - z296 * z2675 - z297 * z2722 - z181 * z2700
        - z182 * z2749));
    const double z3556 = e1x * z2764 - e1y * z2766;
    const double z3557 = e3x * z2764 - e3y * z2766;
    const double z3558 = z38 * z2774 + s_yaw * z2776 - z71 * z2876 + c_yaw * z2877;
    const double z3559 = s_yaw * z2774 - z38 * z2776 + c_yaw * z2876 + z71 * z2877;
    const double z3560 = h2y * z2767 - z80 * z2836;
    const double z3561 = s_lam * (z51 * z3560) + c_lam * (z53 * z3560);
    const double z3562 = h1y * z2767 + h1x * z2836;
    const double z3563 = h3y * z2767 + h3x * z2836;
    const double z3564 = z53 * z3562 - z51 * z3563;
    const double z3565 = z2759 + R3 * z3556 + z36 * z3557 + c_pitch * z3558 - s_pitch * z3559 - s_steer *
        z3561 + c_steer * z3564;
    const double z3566 = z95 * z3565;
    const double z3567 = c * z3566;
    const double z3568 = r_F * z3566;
    const double z3569 = c_lam * z3567 - s_lam * z3568;
    const double z3570 = e1x * z2737 - e1y * z2739;
    const double z3571 = e3x * z2737 - e3y * z2739;
    const double z3572 = z38 * z2746 + s_yaw * z2747 - z71 * z2873 + c_yaw * z2874;
    const double z3573 = s_yaw * z2746 - z38 * z2747 + c_yaw * z2873 + z71 * z2874;
    const double z3574 = h2y * z2740 - z80 * z2847;
    const double z3575 = s_lam * (z51 * z3574) + c_lam * (z53 * z3574);
    const double z3576 = h1y * z2740 + h1x * z2847;
    const double z3577 = h3y * z2740 + h3x * z2847;
    const double z3578 = z53 * z3576 - z51 * z3577;
    const double z3579 = z2732 + R3 * z3570 + z36 * z3571 + c_pitch * z3572 - s_pitch * z3573 - s_steer *
        z3575 + c_steer * z3578;
    const double z3580 = 2.0 * (z3082 * (z1527 * z3458)) - z577 * (z1557 * z3457 + z455 * z3546 - z234 *
        z3579 - z115 * z3565);
    const double z3581 = z12 * z3478;
    const double z3582 = z447 * z3459 - c_roll * z3580;
    const double z3583 = c_lam * z3582;
    const double z3584 = r_F * z3583;
    const double z3585 = 0.5 * (z1320 * z3478) - z12 * z3584;
    const double z3586 = z467 * z3526 + (z457 * z3535 + z3555) + s_steer * z3569 + z28 * z3580 - s_lam * (2.0
        * (z1514 * z3581) + z17 * z3585);
    const double z3587 = z1281 * z2572 - z1280 * z2534 - s_yaw * z2808 - c_yaw * z2813;
    const double z3588 = z1463 * z3446 - z1454 * z3476 - z1470 * z3447 - z1622 * z2507 + 2.0 * (z1514 *
        z3532) - z1358 * z2572;
    const double z3589 = z3588 - z1332 * z2534 - z1343 * z2571 - z1296 * z2529 - 2.0 * (z1286 * z3520) + z362
        * z2793;
    const double z3590 = r_F * (z467 * z3460 - s_pitch * z3582);
    const double z3591 = 0.5 * (z1320 * z3461) + z12 * z3590;
    const double z3592 = z517 * z2617 - (z3589 - z277 * z2731 - z162 * z2758) - z17 * z3591 + z62 * z2808 +
        z86 * z2813;
    const double z3593 = z1295 * z2514 + z1342 * z2555 + z442 * z3464 + z73 * z2622 - e2y * z2633 + e2z *
        z3547;
    const double z3594 = z1558 * z3448 - z1508 * z3513 + z1340 * z2580 - z1342 * z2607 - z1291 * z2530 -
        z1295 * z2578;
    const double z3595 = z73 * z2764 + e2y * z2766 - e2z * z3566;
    const double z3596 = z430 * z3593 - (z3594 - z456 * z3500 + z235 * z3570 + z116 * z3556 - c_pitch *
        z3595) + e1y * z2814;
    const double z3597 = z3596 + e2y * z2894 + e1x * z2878 + z73 * z2845;
    const double z3598 = z1558 * z3449 + z1507 * z3513 + z1342 * z2606 - z1339 * z2580 + z1295 * z2577 +
        z1283 * z2530;
    const double z3599 = z429 * z3593 - (z3598 + z456 * z3501 + z235 * z3571 + z116 * z3557 - s_pitch *
        z3595) - e2y * z2893;
    const double z3600 = z3599 + e3y * z2814 - z73 * z2844 + e3x * z2878;
    const double z3601 = z35 * (z601 * (z1292 * z3516 + z1285 * z3517 - z1287 * z3519 + z39 * z3597 + z33 *
        z3600));
    const double z3602 = z3106 * (z1288 * z3518) - 0.5 * z3601;
    const double z3603 = z3592 - z37 * z2807 - z74 * z2811 - 2.0 * (e3z * z3602) + r_R * (0.5 * (z1289 *
        z3516) - z35 * z3597);
    const double z3604 = z95 * z3579;
    const double z3605 = z1537 * z3464 - c_lam * (c * z3604) + s_lam * (r_F * z3604) + z233 * z3604 + z104 *
        z3566;
    const double z3606 = z440 * z3547 - z3605;
    const double z3607 = z1524 * z3461 - z1522 * z3462 + z1518 * z3478 + 2.0 * (z1515 * z3483) + z443 * z3484
        - z1323 * z3489;
    const double z3608 = z445 * z3461 - c_steer * z3590;
    const double z3609 = z467 * z3478 - s_pitch * z3584;
    const double z3610 = z3607 - z1316 * z3492 - z1318 * z3494 - z26 * z3590 + z24 * z3608 - z21 * z3584 -
        2.0 * (z18 * z3609);
    const double z3611 = z457 * z3478 + c_pitch * z3584;
    const double z3612 = z1512 * z3479 - z15 * z3611;
    const double z3613 = z1530 * z3464 + h2z * z3547;
    const double z3614 = z1315 * z3464 - z9 * z3547;
    const double z3615 = z1559 * z3454 - z1562 * z3452 - z1510 * z3486 - z1534 * z3487 + z1350 * z2592 +
        z1352 * z2590;
    const double z3616 = z3615 + z1322 * z2544 - z1326 * z2542 - z470 * z3543 + z474 * z3538 + z236 * z3576 +
        z239 * z3574;
    const double z3617 = h2z * z3604;
    const double z3618 = z9 * z3566;
    const double z3619 = h2z * z3566;
    const double z3620 = z432 * z3614 + (z3616 + s_lam * z3617 + z117 * z3562 + z120 * z3560 - z94 * z3618 +
        z101 * z3619);
    const double z3621 = z437 * z3613 - z3620 - h1y * z2827 - h2y * z2825 + h1x * z2861 + z80 * z2859;
    const double z3622 = z1317 * z3464 - z10 * z3547;
    const double z3623 = z1563 * z3452 - z1559 * z3455 - z1536 * z3487 + z1510 * z3490 - z1352 * z2589 -
        z1349 * z2592;
    const double z3624 = z3623 + z1326 * z2541 - z1309 * z2544 - z475 * z3538 + z470 * z3544 - z240 * z3574 -
        z236 * z3577;
    const double z3625 = z10 * z3566;
    const double z3626 = z439 * z3613 + (z3624 - c_lam * z3617 - z121 * z3560 - z117 * z3563 + z103 * z3619 +
        z94 * z3625);
    const double z3627 = z432 * z3622 - z3626 + h2y * z2824 + h3y * z2827 - z80 * z2858 - h3x * z2861;
    const double z3628 = z3123 * (z1319 * z3493) - 0.5 * (z12 * (z608 * (z3610 + s_steer * z3612 - z52 *
        z3621 - z50 * z3627)));
    const double z3629 = z433 * z3547 - (z1529 * z3464 + 2.0 * (z1317 * z3495) - z96 * z3566) + 2.0 * (z10 *
        z3628);
    const double z3630 = z3629 + r_F * (0.5 * (z1320 * z3489) - z12 * z3621);
    const double z3631 = z441 * z3547 - (z1538 * z3464 - 2.0 * (z1315 * z3495) - z105 * z3566) - 2.0 * (z9 *
        z3628);
    const double z3632 = z3631 - r_F * (0.5 * (z1320 * z3492) - z12 * z3627);
    const double z3633 = s_lam * z3630 + c_lam * z3632;
    const double z3634 = z1544 * z3469 - z443 * z3481 + z445 * z3551 - s_steer * z3606 - c_steer * z3633;
    const double z3635 = c_lam * z3630 - s_lam * z3632;
    const double z3636 = z3603 + s_lam * z3634 - c_lam * z3635;
    const double z3637 = z1464 * z3446 - z1455 * z3476 - z1471 * z3447 + z1622 * z2510 - z1361 * z2572 -
        z1335 * z2534;
    const double z3638 = z3637 + z1344 * z2571 + z1297 * z2529 - 2.0 * (z1284 * z3520) - z362 * z2796 + z277
        * z2733;
    const double z3639 = z517 * z2619 - (z3638 + z162 * z2760) + z64 * z2808 + z88 * z2813 + z41 * z2807 +
        z75 * z2811;
    const double z3640 = z1511 * z3479 - z13 * z3611;
    const double z3641 = z3639 - 2.0 * (z2 * z3602) + r_R * (0.5 * (z1289 * z3517) - z35 * z3600) + c_lam *
        (2.0 * (z443 * z3480) + 2.0 * (s_steer * z3640) + z3634);
    const double z3642 = z1320 * z3483 + 2.0 * (z12 * z3609);
    const double z3643 = z3641 - s_lam * (4.0 * (z1514 * z3524) + z17 * z3642 - z3635);
    const double z3644 = roll_dot * z3553 - (z3586 - z46 * z3587) + c_pitch * z3636 + c_yaw * z2896 - s_yaw *
        z2865 + s_pitch * z3643;
    const double z3645 = z28 * z3459 - s_lam * (z17 * z3581) + z46 * z3466 - z1280 * z2602 - z1281 * z2573 -
        z457 * z3473;
    const double z3646 = s_steer * z3469 - c_yaw * z2604 + s_yaw * z2575;
    const double z3647 = s_lam * z3548 + c_lam * z3549;
    const double z3648 = z3522 - c_steer * z3550;
    const double z3649 = z3535 - r_R * z3547 + c_lam * z3647 + s_lam * z3648;
    const double z3650 = z3526 - k2 * z3547 + s_lam * z3647 - c_lam * z3648;
    const double z3651 = z3645 - z467 * z3474 - roll_dot * z3646 - c_yaw * z2887 + s_yaw * z2631 - c_pitch *
        z3649 + s_pitch * z3650;
    const double z3652 = z1454 * z3446 - z1455 * z3447 - z1635 * z2501 + z1634 * z2498 + z1622 * z2509 -
        z1554 * z3464;
    const double z3653 = z3652 + z1360 * z2572 + z1334 * z2534 + z1303 * z3466 - z1341 * z2571 + z1294 *
        z2529 + z1541 * z3469;
    const double z3654 = z3653 + z445 * z3482 - z381 * z2657 - z382 * z2781 + z362 * z2795 + z296 * z2682 +
        z297 * z2723;
    const double z3655 = z1281 * z2552 + (z1280 * z2609 - (z3654 + z277 * z2732 + z181 * z2707 + z182 * z2750
        + z162 * z2759));
    const double z3656 = s_lam * z3567 + c_lam * z3568;
    const double z3657 = c_steer * z3569;
    const double z3658 = r_R * z3566 - c_lam * z3656 + s_lam * z3657;
    const double z3659 = k2 * z3566 - s_lam * z3656 - c_lam * z3657;
    const double z3660 = 0.5 * (z1320 * z3462) - z12 * z3608;
    const double z3661 = z517 * z2618 - z3655 - z112 * z3566 + c_pitch * z3658 - s_pitch * z3659 + s_lam *
        (z443 * z3463 + s_steer * z3660);
    const double z3662 = z453 * z3547 + z3661 - z63 * z2808 - z87 * z2813 + z47 * z3587 - z40 * z2807 + z72 *
        z2811;
    const double z3663 = z3640 - z3606;
    const double z3664 = roll_dot * z3651 + (z443 * z3551 - z3662) + c_steer * z3663 + s_steer * z3633 -
        c_yaw * z2898 - s_yaw * z2885;
    const double z3665 = z1625 * (e2z * z3644 - c_roll * z3664 + z422 * z3182 - z427 * z3445);
    const double z3666 = z426 * z3445 - z427 * z3665;
    J[112] = -(z352 * z3182 + z353 * z3666 + z422 * z3665);
    const double z3667 = z1321 * z2954 - z51 * z3130;
    const double z3668 = z1324 * z2954 - z53 * z3130;
    const double z3669 = c_lam * (z3008 - z3667) - s_lam * (z3009 - z3668);
    const double z3670 = z3010 - s_lam * z3667 - c_lam * z3668;
    const double z3671 = z1324 * z2953 - z1321 * z2957 + z3014 + z53 * z3131 - z51 * z3139;
    const double z3672 = z445 * z2978 - z443 * z2979 + c_steer * z3670 + s_steer * z3671;
    const double z3673 = z1290 * z2981 - z1481 + c_lam * z3669 + s_lam * z3672 + z36 * z3107;
    const double z3674 = z1373 * z1463 - z1454 * z1383 - z1384 * z1470 + z1634 * z1220 - z1636 * z1221 +
        z1635 * z1224;
    const double z3675 = z3674 - z1648 * z1225 + z1558 * z2916 + z1573 * z1403 + z1603 * z1248 + z1525 *
        z2925 - z1516 * z2945;
    const double z3676 = z3675 - z1302 * z2973 - z1301 * z2974 - z1547 * z2941 + z382 * z1734 - z388 * z1735
        - z381 * z1746;
    const double z3677 = z3676 - z383 * z1747 + z297 * z1760 - z303 * z1761 - z296 * z1772 - z298 * z1773 -
        z182 * z1795;
    const double z3678 = z1338 * z1440 - (z1281 * z1439 - (z1880 + (z3677 - z188 * z1796 + z181 * z1816 +
        z183 * z1817)));
    const double z3679 = z456 * z3006 + (z1282 * z1278 - (z1280 * z1277 - z3678)) + z235 * z3086 + e2y *
        z1907 - z73 * z1978;
    const double z3680 = z3070 - z3136;
    const double z3681 = c_lam * (z51 * z3680) - s_lam * (z53 * z3680);
    const double z3682 = z499 * z1492 - (z481 * z1505 - (z3679 + z116 * z3069 - c_lam * z3681 - z36 * z3110 -
        e2z * z3176));
    const double z3683 = z3071 - s_lam * (z51 * z3136) - c_lam * (z53 * z3136);
    const double z3684 = z3075 + z53 * z3135 - z51 * z3142;
    const double z3685 = c * z3096;
    const double z3686 = z445 * z2970 + c_steer * z3683 + s_steer * z3684 - z1 * z3685;
    const double z3687 = z442 * z2932 - e2z * z3099;
    const double z3688 = z1280 * z1413 + z1281 * z1261 + c_yaw * z1944 - s_yaw * z1949;
    const double z3689 = z447 * z3167 - (z3682 - z27 * z3095 - s_lam * z3686 + z19 * z3097 + z44 * z3687 -
        z43 * z3688);
    const double z3690 = roll_dot * z3673 - z3689 - s_yaw * z1969 + c_yaw * z2018 + c_roll * z3160 - z38 *
        z2003 - z71 * z2020;
    const double z3691 = z1293 * z2981 + z1483 + s_lam * z3669 - c_lam * z3672 + R3 * z3107;
    const double z3692 = z1373 * z1464 - z1455 * z1383 - z1384 * z1471 - z1636 * z1220 - z1634 * z1221 -
        z1648 * z1224;
    const double z3693 = z3692 - z1635 * z1225 - z1558 * z2914 + z1573 * z1406 + z1603 * z1249 + z1513 *
        z2945 - z1302 * z2974;
    const double z3694 = z3693 + z1301 * z2973 - z1547 * z2940 - z388 * z1734 - z382 * z1735 - z383 * z1746 +
        z381 * z1747;
    const double z3695 = z3694 - z303 * z1760 - z297 * z1761 - z298 * z1772 + z296 * z1773 - z188 * z1795 +
        z182 * z1796;
    const double z3696 = z1282 * z1277 + (z1281 * z1440 + (z1338 * z1439 - (z1891 - (z3695 + z183 * z1816 -
        z181 * z1817))));
    const double z3697 = z456 * z2996 + (z1280 * z1278 + z3696) - z235 * z3085 + e2y * z1909 + z116 * z3067 -
        z73 * z1979;
    const double z3698 = z499 * z1493 - (z481 * z1503 - (z3697 + s_lam * z3681 + R3 * z3110 - e2z * z3175)) +
        w * z3095;
    const double z3699 = roll_dot * z3691 + (z447 * z3166 - (z3698 - c_lam * z3686 - z16 * z3097 + z44 *
        z3688 + z43 * z3687));
    const double z3700 = s_pitch * (z3699 + c_roll * z3153 + z38 * z1969 + z71 * z2018 - s_yaw * z2003 +
        c_yaw * z2020);
    const double z3701 = c_pitch * z3690 - z3700;
    const double z3702 = z1321 * z3235 - z51 * z3391;
    const double z3703 = z1324 * z3235 - z53 * z3391;
    const double z3704 = c_lam * (z3290 - z3702) - s_lam * (z3291 - z3703);
    const double z3705 = z3292 - s_lam * z3702 - c_lam * z3703;
    const double z3706 = z1324 * z3234 - z1321 * z3238 + z3296 + z53 * z3392 - z51 * z3400;
    const double z3707 = z445 * z3259 - z443 * z3260 + c_steer * z3705 + s_steer * z3706;
    const double z3708 = z1290 * z3262 + z2175 + c_lam * z3704 + s_lam * z3707 + z36 * z3370;
    const double z3709 = z1706 * z3063 - z1374 * z3064 - z1711 * z3065 - z1634 * z2049 + z1636 * z2050 -
        z1635 * z2053;
    const double z3710 = z3709 + z1648 * z2054 - z1558 * z3196 - z1573 * z2120 - z1603 * z2078 - z1525 *
        z3205 + z1516 * z3226;
    const double z3711 = z3710 + z1302 * z3253 + z1301 * z3254 + z1547 * z3222 - z382 * z2213 + z388 * z2214
        + z381 * z2225;
    const double z3712 = z3711 + z383 * z2226 + z297 * z2241 - z303 * z2242 - z296 * z2256 - z298 * z2257 -
        z182 * z2269;
    const double z3713 = z1338 * z2157 - (z1281 * z2156 + (z2337 + (z3712 - z188 * z2270 + z181 * z2281 +
        z183 * z2282)));
    const double z3714 = z456 * z3288 - (z1282 * z2108 - (z1280 * z2107 - z3713)) - z235 * z3348 + e2y *
        z2352 - z73 * z2421;
    const double z3715 = z3334 - z3397;
    const double z3716 = c_lam * (z51 * z3715) - s_lam * (z53 * z3715);
    const double z3717 = z499 * z2186 - (z481 * z2199 + (z3714 - z116 * z3333 - c_lam * z3716 - z36 * z3373 -
        e2z * z3438));
    const double z3718 = z3335 - s_lam * (z51 * z3397) - c_lam * (z53 * z3397);
    const double z3719 = z3338 + z53 * z3396 - z51 * z3403;
    const double z3720 = c * z3359;
    const double z3721 = z445 * z3251 - c_steer * z3718 - s_steer * z3719 - z1 * z3720;
    const double z3722 = z442 * z3213 - e2z * z3363;
    const double z3723 = z1280 * z2130 + z1281 * z2091 + c_yaw * z2387 - s_yaw * z2392;
    const double z3724 = z447 * z3429 - (z3717 - z27 * z3358 - s_lam * z3721 + z19 * z3360 + z44 * z3722 -
        z43 * z3723);
    const double z3725 = roll_dot * z3708 - z3724 - s_yaw * z2412 + c_yaw * z2461 - c_roll * z3422 - z38 *
        z2446 - z71 * z2463;
    const double z3726 = z1293 * z3262 - z2177 + s_lam * z3704 - c_lam * z3707 + R3 * z3370;
    const double z3727 = z1707 * z3063 - z1385 * z3064 - z1712 * z3065 + z1636 * z2049 + z1634 * z2050 +
        z1648 * z2053;
    const double z3728 = z3727 + z1635 * z2054 + z1558 * z3194 - z1573 * z2123 - z1603 * z2079 - z1513 *
        z3226 + z1302 * z3254;
    const double z3729 = z3728 - z1301 * z3253 + z1547 * z3221 + z388 * z2213 + z382 * z2214 + z383 * z2225 -
        z381 * z2226;
    const double z3730 = z3729 - z303 * z2241 - z297 * z2242 - z298 * z2256 + z296 * z2257 - z188 * z2269 +
        z182 * z2270;
    const double z3731 = z1282 * z2107 + (z1281 * z2157 + (z1338 * z2156 + (z2339 - (z3730 + z183 * z2281 -
        z181 * z2282))));
    const double z3732 = z456 * z3277 + (z1280 * z2108 + z3731) + z235 * z3347 - e2y * z2354 - z116 * z3332 +
        z73 * z2422;
    const double z3733 = z499 * z2187 - (z481 * z2197 - (z3732 - s_lam * z3716 - R3 * z3373 + e2z * z3437)) +
        w * z3358;
    const double z3734 = roll_dot * z3726 + (z447 * z3428 - (z3733 - c_lam * z3721 - z16 * z3360 + z44 *
        z3723 + z43 * z3722));
    const double z3735 = s_pitch * (z3734 - c_roll * z3415 + z38 * z2412 + z71 * z2461 - s_yaw * z2446 +
        c_yaw * z2463);
    const double z3736 = c_pitch * z3725 - z3735 - z353 * z3701;
    const double z3737 = z1321 * z3487 - z51 * z3613;
    const double z3738 = z1324 * z3487 - z53 * z3613;
    const double z3739 = c_lam * (z3539 + z3737) - s_lam * (z3540 + z3738);
    const double z3740 = z3541 + s_lam * z3737 + c_lam * z3738;
    const double z3741 = z1324 * z3486 - z1321 * z3490 - z3545 + z53 * z3614 - z51 * z3622;
    const double z3742 = z445 * z3510 - z443 * z3511 + c_steer * z3740 - s_steer * z3741;
    const double z3743 = z1290 * z3513 + z2617 + c_lam * z3739 + s_lam * z3742 + z36 * z3593;
    const double z3744 = z1634 * z2492 - z1636 * z2493 + z1635 * z2496 - z1648 * z2497 + z1558 * z3451 +
        z1573 * z2562;
    const double z3745 = z3744 + z1603 * z2521 - z1525 * z3460 + z1516 * z3478 - z1302 * z3505 - z1301 *
        z3506 + z1547 * z3474;
    const double z3746 = z3745 - z382 * z2655 + z388 * z2656 + z381 * z2667 + z383 * z2668 + z297 * z2680 -
        z303 * z2681;
    const double z3747 = z3746 - z296 * z2692 - z298 * z2693 + z182 * z2705 + z188 * z2706 - z181 * z2717 -
        z183 * z2718;
    const double z3748 = z456 * z3537 - (z1282 * z2551 - (z1280 * z2550 - (z1338 * z2599 - (z1281 * z2598 +
        (z2758 - z3747)))));
    const double z3749 = z3560 + z3619;
    const double z3750 = c_lam * (z51 * z3749) - s_lam * (z53 * z3749);
    const double z3751 = z3748 - z235 * z3573 + e2y * z2773 - z73 * z2842 - z116 * z3559 - c_lam * z3750 -
        z36 * z3595;
    const double z3752 = z3561 + s_lam * (z51 * z3619) + c_lam * (z53 * z3619);
    const double z3753 = z3564 - z53 * z3618 + z51 * z3625;
    const double z3754 = c * z3583;
    const double z3755 = z445 * z3503 + c_steer * z3752 + s_steer * z3753 - z1 * z3754;
    const double z3756 = z499 * z2628 - (z481 * z2641 + (z3751 + e2z * z3659)) + z27 * z3582 + s_lam * z3755
        - z19 * z3584;
    const double z3757 = z442 * z3466 - e2z * z3587;
    const double z3758 = z1280 * z2572 + z1281 * z2534 + c_yaw * z2808 - s_yaw * z2813;
    const double z3759 = roll_dot * z3743 - (z447 * z3650 - (z3756 + z44 * z3757 - z43 * z3758)) - s_yaw *
        z2833 + c_yaw * z2882;
    const double z3760 = z1293 * z3513 - z2619 + s_lam * z3739 - c_lam * z3742 + R3 * z3593;
    const double z3761 = z1636 * z2492 + z1634 * z2493 + z1648 * z2496 + z1635 * z2497 - z1558 * z3450 -
        z1573 * z2565;
    const double z3762 = z3761 - z1603 * z2522 + z1513 * z3478 + z1302 * z3506 - z1301 * z3505 - z1547 *
        z3473 - z388 * z2655;
    const double z3763 = z3762 - z382 * z2656 - z383 * z2667 + z381 * z2668 + z303 * z2680 + z297 * z2681 +
        z298 * z2692;
    const double z3764 = z2760 - (z3763 - z296 * z2693 - z188 * z2705 + z182 * z2706 + z183 * z2717 - z181 *
        z2718);
    const double z3765 = z456 * z3528 + (z1280 * z2551 + (z1282 * z2550 + (z1281 * z2599 + (z1338 * z2598 +
        z3764)))) + z235 * z3572;
    const double z3766 = z3765 - e2y * z2775 + z116 * z3558 + z73 * z2843 - s_lam * z3750 - R3 * z3595 - e2z
        * z3658;
    const double z3767 = z499 * z2629 - (z481 * z2639 - z3766) - w * z3582 + c_lam * z3755 + z16 * z3584 +
        z44 * z3758;
    const double z3768 = roll_dot * z3760 + (z447 * z3649 - (z3767 + z43 * z3757)) - c_roll * z3636 + z38 *
        z2833 + z71 * z2882;
    const double z3769 = c_pitch * (z3759 - c_roll * z3643 - z38 * z2867 - z71 * z2884) - s_pitch * (z3768 -
        s_yaw * z2867 + c_yaw * z2884);
    const double z3770 = z1625 * (z3769 - z422 * z3701 - z427 * z3736);
    const double z3771 = z426 * z3736 - z427 * z3770;
    J[113] = z352 * z3701 - z353 * z3771 - z422 * z3770;
    const double z3772 = z116 * z1383 + w2 * z1231 + z1372 * z1232 - z488 * z1401 + z506 * z1246 - z456 *
        z2921;
    const double z3773 = c_lam * (s_lam * (s_pitch * z1384 + e3z * z2904) - c_lam * (c_pitch * z1384 - z2 *
        z2904) + z2950);
    const double z3774 = s_lam * (c_lam * (c_pitch * z1373 - z2 * z2903) - s_lam * (s_pitch * z1373 + e3z *
        z2903) + z2946);
    const double z3775 = z3772 - z25 * z2926 - z22 * z2970 + z3773 + z3774 + z450 * z2935 - z431 * z2978 +
        z59 * z1427;
    const double z3776 = z3775 - z54 * z1428 - z83 * z1265 - z77 * z1266 - k7 * (c_lam * (c_pitch * z2974 -
        s_pitch * z2973) - s_lam * (s_pitch * z2974 + c_pitch * z2973));
    const double z3777 = e2z * z2936 + e2y * z1422 - z73 * z1258;
    const double z3778 = z3776 - z1311 * z2990 + z1347 * z1423 - steer_dot * z3777 + z1307 * z1259 - e2z *
        z2949 + e2y * z1432;
    const double z3779 = z3778 - z73 * z1270 - z4 * z3020 - z49 * z1952 - z76 * z1970;
    const double z3780 = z124 * z3064 - z194 * z3024 + z457 * z1383 - z1284 * z2943 + c_roll * z3025 + z442 *
        z2904;
    const double z3781 = c_roll * z3023 + z442 * z2903 - z126 * z3064 + z195 * z3024 - z467 * z1383 + z1286 *
        z2943;
    const double z3782 = z1641 * z1217 + z1653 * z1212 + z1630 * z1231 + z1627 * z1232 + z1558 * z2918 +
        z1569 * z1401;
    const double z3783 = 2.0 * (e3z * z3001) - 2.0 * (z20 * z3094) + 4.0 * (z7 * z2992);
    const double z3784 = z3782 + z1599 * z1246 - z1521 * z2928 - z443 * z3783 - 2.0 * (z1310 * z2947) + 0.5 *
        (z1320 * z2951);
    const double z3785 = z3784 - z1509 * z2979 + z1355 * z1428 + z1351 * z1427 - z1329 * z1266 + z1325 *
        z1265 + z1540 * z2936;
    const double z3786 = z3785 + z1311 * z2948 + z1347 * z1432 + z1307 * z1270 - z405 * z1728 - z395 * z1742
        - z369 * z1920;
    const double z3787 = z3786 - z366 * z1925 - z324 * z1754 - z315 * z1768 - z284 * z1826 + z281 * z1831 +
        z209 * z1786;
    const double z3788 = z1372 * z1461 - (z1295 * z1274 - (z1342 * z1436 + (z3787 - z200 * z1809 - z170 *
        z1868 + z166 * z1877)));
    const double z3789 = z456 * z3010 + (c_lam * z3780 - (s_lam * z3781 + (w2 * z1478 + z3788))) - z235 *
        z3088 - z38 * z1905;
    const double z3790 = z497 * z1490 - (z479 * z1501 + (z3789 + z71 * z1976 + z116 * z3071 - z22 * z3684 +
        c_roll * z3081));
    const double z3791 = z1286 * z3001 - z1517 * z3094 + 2.0 * (z1313 * z2992) - e3z * z3104 + z20 * z3098 -
        z7 * z3159;
    const double z3792 = z431 * z3671 + (z3790 - z23 * z3177 + 2.0 * (s_steer * z3791) + 2.0 * (z3 * z3157) +
        z12 * z3129);
    const double z3793 = z3792 - z59 * z1958 + z54 * z1957 + z83 * z1992 + z77 * z1991 - k7 * (z447 * z2932 +
        c_roll * z3099);
    const double z3794 = steer_dot * z3779 - (z442 * z3020 + z3793) - z4 * z3122 + z49 * z1962 + z76 * z1996
        - e2z * z3150;
    const double z3795 = s_lam * (z116 * z1373 - e2z * z2903 + s_pitch * z1383 + e3z * z2943) - c_lam *
        (c_pitch * z1383 - z2 * z2943 + z116 * z1384 - e2z * z2904);
    const double z3796 = z3795 + z1372 * z1231 - w2 * z1232 - z456 * z2918 - z479 * z1401 + z497 * z1246 +
        z23 * z2928;
    const double z3797 = z3796 + s_steer * z3783 - 2.0 * (z3 * z2947) - z12 * z2951 + z431 * z2979 + z59 *
        z1428;
    const double z3798 = z3797 + z54 * z1427 - z83 * z1266 + z77 * z1265 - k7 * (c_roll * z2932) + 2.0 *
        (z442 * z2936);
    const double z3799 = z4 * z2936 - z49 * z1422 - z76 * z1258;
    const double z3800 = z3798 - z1342 * z1423 + z1295 * z1259 + steer_dot * z3799 + z4 * z2948 + z49 * z1432
        + z76 * z1270;
    const double z3801 = z3800 - e2z * z3020 + e2y * z1952 - z73 * z1970;
    const double z3802 = s_lam * (z126 * z3065 - z195 * z3025 + z467 * z1384 - z1286 * z2904) + c_lam * (z124
        * z3065 - z194 * z3025 + z457 * z1384 - z1284 * z2904);
    const double z3803 = c_lam * (z124 * z3063 - z194 * z3023 + z457 * z1373 - z1284 * z2903) + s_lam * (z126
        * z3063 - z195 * z3023 + z467 * z1373 - z1286 * z2903);
    const double z3804 = c_roll * z3024 + z1688 * z2910 + z1640 * z1217 - z1652 * z1212 - z1627 * z1231 +
        z1630 * z1232;
    const double z3805 = z3804 - z1586 * z1401 + z1614 * z1246 + z1558 * z2921 + z1523 * z2926 + z1551 *
        z2935 + z1509 * z2978;
    const double z3806 = z3805 + z1355 * z1427 - z1351 * z1428 - z1329 * z1265 - z1325 * z1266 + z442 * z2949
        + z1342 * z1432;
    const double z3807 = z3806 - z1295 * z1270 - z404 * z1728 + z394 * z1742 + z366 * z1920 - z369 * z1925 -
        z332 * z3033;
    const double z3808 = z3807 - z323 * z1754 - z314 * z1768 - z281 * z1826 - z284 * z1831 + z217 * z3050 +
        z208 * z1786;
    const double z3809 = z1307 * z1274 + (z1347 * z1436 + (z1311 * z2965 - (z3808 + z199 * z1809 + z166 *
        z1868 + z170 * z1877)));
    const double z3810 = z506 * z1490 - (z488 * z1501 + (c_lam * z3802 - (s_lam * z3803 - (z1372 * z1478 -
        (w2 * z1461 - z3809)))));
    const double z3811 = z456 * z3014 - z3810 + z262 * z1848 - z251 * z1986 - z235 * z3091 - z143 * z1905 +
        z132 * z1976;
    const double z3812 = z3811 + z116 * z3075 + z109 * z3080 + z22 * z3683 - z25 * z3103 + (z1520 * z2970 +
        z22 * z3685 + c_lam * z3126 - s_lam * z3128);
    const double z3813 = z431 * z3670 + (z450 * z3019 + z3812) - z59 * z1957 - z54 * z1958 + z83 * z1991 -
        z77 * z1992;
    const double z3814 = c_lam * (z457 * z2974 + z467 * z2973 - c_pitch * z3688 + s_pitch * z3687) + s_lam *
        (z467 * z2974 - z457 * z2973 + s_pitch * z3688 + c_pitch * z3687);
    const double z3815 = steer_dot * z3801 - (z3813 + k7 * z3814) - e2z * z3180 - e2y * z1962 + z73 * z1996 +
        z4 * z3150;
    const double z3816 = c_steer * (z3794 - e2y * z1966 + z73 * z2000) - s_steer * (z3815 - z49 * z1966 - z76
        * z2000);
    const double z3817 = z235 * z1383 + w2 * z2060 - z1372 * z2061 - z488 * z2118 + z506 * z2076 - z456 *
        z3201;
    const double z3818 = z3817 - z25 * z3206 - z22 * z3251 + c_lam * (s_lam * (e3z * z3184) + c_lam * (z2 *
        z3184) + z3231);
    const double z3819 = z3818 - s_lam * (c_lam * (z2 * z3183) + s_lam * (e3z * z3183) - z3227) + z450 *
        z3216 - z431 * z3259;
    const double z3820 = z3819 + z59 * z2144 - z54 * z2145 - z83 * z2095 - z77 * z2096 - k7 * (c_lam *
        (c_pitch * z3254 - s_pitch * z3253) - s_lam * (s_pitch * z3254 + c_pitch * z3253));
    const double z3821 = e2z * z3217 + e2y * z2139 - z73 * z2088;
    const double z3822 = z3820 - z1311 * z3271 + z1347 * z2140 - steer_dot * z3821 + z1307 * z2089 - e2z *
        z3230 + e2y * z2149;
    const double z3823 = z3822 - z73 * z2100 - z4 * z3302 - z49 * z2395 - z76 * z2413;
    const double z3824 = z243 * z3064 - z308 * z3024 - s_lam * (s_pitch * z3065 - e3z * z3025) + c_lam *
        (c_pitch * z3065 + z2 * z3025);
    const double z3825 = c_lam * (c_pitch * z3063 + z2 * z3023) - s_lam * (s_pitch * z3063 - e3z * z3023) -
        z245 * z3064;
    const double z3826 = z1641 * z2046 + z1653 * z2041 + z1630 * z2060 - z1627 * z2061 + z1558 * z3198 +
        z1569 * z2118;
    const double z3827 = 2.0 * (e3z * z3283) - 2.0 * (z20 * z3357) + 4.0 * (z7 * z3273);
    const double z3828 = z3826 + z1599 * z2076 - z1521 * z3208 - z443 * z3827 - 2.0 * (z1310 * z3228) + 0.5 *
        (z1320 * z3232);
    const double z3829 = z3828 - z1509 * z3260 + z1355 * z2145 + z1351 * z2144 - z1329 * z2096 + z1325 *
        z2095 + z1540 * z3217;
    const double z3830 = z3829 + z1311 * z3229 + z1347 * z2149 + z1307 * z2100 - z405 * z2207 - z395 * z2221
        - z369 * z2364;
    const double z3831 = z3830 - z366 * z2369 + z324 * z2234 + z315 * z2251 + z284 * z2296 + z281 * z2303 -
        z209 * z2263;
    const double z3832 = z1372 * z2169 - (z1295 * z2104 - (z1342 * z2153 + (z3831 + z200 * z2277 + z170 *
        z2331 - z166 * z2334)));
    const double z3833 = c_lam * (z3824 - z1284 * z3224 + z442 * z3184) - (s_lam * (z3825 - z309 * z3024 +
        z442 * z3183 + z1286 * z3224) - (w2 * z2172 - z3832));
    const double z3834 = z456 * z3293 + z3833 + z235 * z3350 + z38 * z2350 - z71 * z2419 - z116 * z3335 + z22
        * z3719;
    const double z3835 = z1286 * z3283 - z1517 * z3357 + 2.0 * (z1313 * z3273) - e3z * z3368 + z20 * z3361 -
        z7 * z3421;
    const double z3836 = z497 * z2184 - (z479 * z2195 + (z3834 - c_roll * z3344)) - z23 * z3440 + 2.0 *
        (s_steer * z3835);
    const double z3837 = z431 * z3706 + (z3836 + 2.0 * (z3 * z3420) + z12 * z3390) - z59 * z2401 + z54 *
        z2400;
    const double z3838 = z442 * z3302 + (z3837 + z83 * z2435 + z77 * z2434 - k7 * (z447 * z3213 + c_roll *
        z3363));
    const double z3839 = steer_dot * z3823 - z3838 + z4 * z3384 - z49 * z2405 - z76 * z2439 - e2z * z3444 -
        e2y * z2409;
    const double z3840 = s_lam * (z235 * z1373 - e2z * z3183 + e3z * z3224) - c_lam * (z235 * z1384 - z2 *
        z3224 - e2z * z3184);
    const double z3841 = z3840 + z1372 * z2060 + w2 * z2061 - z456 * z3198 - z479 * z2118 + z497 * z2076 +
        z23 * z3208;
    const double z3842 = z3841 + s_steer * z3827 - 2.0 * (z3 * z3228) - z12 * z3232 + z431 * z3260 + z59 *
        z2145;
    const double z3843 = z3842 + z54 * z2144 - z83 * z2096 + z77 * z2095 - k7 * (c_roll * z3213) + 2.0 *
        (z442 * z3217);
    const double z3844 = z4 * z3217 - z49 * z2139 - z76 * z2088;
    const double z3845 = z3843 - z1342 * z2140 + z1295 * z2089 + steer_dot * z3844 + z4 * z3229 + z49 * z2149
        + z76 * z2100;
    const double z3846 = z3845 - e2z * z3302 + e2y * z2395 - z73 * z2413;
    const double z3847 = c_pitch * z3064 + z2 * z3024 - z456 * z1384 + e2z * z3025 - c_lam * (z243 * z3065 -
        z308 * z3025 - z1284 * z3184);
    const double z3848 = z456 * z1373 - e2z * z3023 - s_pitch * z3064 + e3z * z3024 + s_lam * (z245 * z3063 +
        z309 * z3023 - z1286 * z3183);
    const double z3849 = z1688 * z3190 + z1640 * z2046 - z1652 * z2041 - z1627 * z2060 - z1630 * z2061 -
        z1586 * z2118;
    const double z3850 = z3849 + z1614 * z2076 + z1558 * z3201 + z1523 * z3206 + z1551 * z3216 + z1509 *
        z3259 + z1355 * z2144;
    const double z3851 = z3850 - z1351 * z2145 - z1329 * z2095 - z1325 * z2096 + z442 * z3230 + z1342 * z2149
        - z1295 * z2100;
    const double z3852 = z3851 - z404 * z2207 + z394 * z2221 + z366 * z2364 - z369 * z2369 + z332 * z3311 +
        z323 * z2234;
    const double z3853 = z3852 + z314 * z2251 + z281 * z2296 - z284 * z2303 - z217 * z3323 - z208 * z2263 -
        z199 * z2277;
    const double z3854 = w2 * z2169 - (z1307 * z2104 + (z1347 * z2153 + (z1311 * z3246 - (z3853 - z166 *
        z2331 - z170 * z2334))));
    const double z3855 = s_lam * (c_lam * (z243 * z3063 - z308 * z3023 - z1284 * z3183) + z3848) + (z1372 *
        z2172 + z3854);
    const double z3856 = z488 * z2195 + (c_lam * (s_lam * (z245 * z3065 + z309 * z3025 - z1286 * z3184) -
        z3847) - z3855);
    const double z3857 = z456 * z3296 - (z506 * z2184 - z3856) - z262 * z2323 + z251 * z2429 + z235 * z3354 +
        z143 * z2350;
    const double z3858 = z3857 - z132 * z2419 - z116 * z3338 - z109 * z3343 - z22 * z3718 - z25 * z3367 +
        (z1520 * z3251 + z22 * z3720 + c_lam * z3387 - s_lam * z3389);
    const double z3859 = z431 * z3705 + (z450 * z3301 + z3858) - z59 * z2400 - z54 * z2401 + z83 * z2434 -
        z77 * z2435;
    const double z3860 = c_lam * (z457 * z3254 + z467 * z3253 - c_pitch * z3723 + s_pitch * z3722) + s_lam *
        (z467 * z3254 - z457 * z3253 + s_pitch * z3723 + c_pitch * z3722);
    const double z3861 = steer_dot * z3846 - (z3859 + k7 * z3860) + e2z * z3442 + e2y * z2405 - z73 * z2439 +
        z4 * z3411;
    const double z3862 = c_steer * (z3839 + z73 * z2443) - s_steer * (z3861 - z49 * z2409 - z76 * z2443) -
        z353 * z3816;
    const double z3863 = w2 * z2503 + z1372 * z2504 + z488 * z2560 - z506 * z2519 + z456 * z3456 - z25 *
        z3461;
    const double z3864 = z3863 - z22 * z3503 - c_lam * (s_lam * (e3z * z3447) + c_lam * (z2 * z3447) - z3483)
        + s_lam * (c_lam * (z2 * z3446) + s_lam * (e3z * z3446) + z3479);
    const double z3865 = z3864 + z450 * z3469 + z431 * z3510 - z59 * z2586 + z54 * z2587 + z83 * z2538 + z77
        * z2539;
    const double z3866 = z3865 + k7 * (c_lam * (c_pitch * z3506 - s_pitch * z3505) - s_lam * (s_pitch * z3506
        + c_pitch * z3505));
    const double z3867 = e2z * z3469 + e2y * z2581 - z73 * z2531;
    const double z3868 = z3866 + z1311 * z3469 - z1347 * z2582 + steer_dot * z3867 - z1307 * z2532 + e2z *
        z3482 - e2y * z2591;
    const double z3869 = z3868 + z73 * z2543 - z4 * z3551 + z49 * z2816 + z76 * z2834;
    const double z3870 = z1641 * z2489 + z1653 * z2484 - z1630 * z2503 - z1627 * z2504 + z1558 * z3453 +
        z1569 * z2560;
    const double z3871 = 2.0 * (e3z * z3532) - 2.0 * (z20 * z3581) + 4.0 * (z7 * z3524);
    const double z3872 = z3870 + z1599 * z2519 + z1521 * z3463 + z443 * z3871 + 2.0 * (z1310 * z3480) - 0.5 *
        (z1320 * z3484);
    const double z3873 = z3872 - z1509 * z3511 + z1355 * z2587 + z1351 * z2586 - z1329 * z2539 + z1325 *
        z2538 + z1540 * z3469;
    const double z3874 = z3873 - z1311 * z3481 + z1347 * z2591 + z1307 * z2543 + z405 * z2649 + z395 * z2663
        + z369 * z2785;
    const double z3875 = z3874 - z366 * z2790 - z324 * z2674 - z315 * z2688 + z284 * z2725 - z281 * z2728 -
        z209 * z2699;
    const double z3876 = z1372 * z2611 - (z1295 * z2547 - (z1342 * z2595 + (z3875 + z200 * z2713 - z170 *
        z2752 - z166 * z2755)));
    const double z3877 = c_lam * (z1284 * z3476 - z442 * z3447) + (s_lam * (z442 * z3446 + z1286 * z3476) -
        (w2 * z2614 - z3876));
    const double z3878 = z456 * z3541 - z3877 - z235 * z3575 + z38 * z2771 - z71 * z2840 - z116 * z3561 + z22
        * z3753;
    const double z3879 = z1286 * z3532 - z1517 * z3581 + 2.0 * (z1313 * z3524) - e3z * z3591 + z20 * z3585 -
        z7 * z3642;
    const double z3880 = z497 * z2626 - (z479 * z2637 + (z3878 - c_roll * z3569)) + z23 * z3660 - 2.0 *
        (s_steer * z3879);
    const double z3881 = z431 * z3741 - (z3880 - 2.0 * (z3 * z3640) - z12 * z3612) + z59 * z2822 - z54 *
        z2821;
    const double z3882 = z442 * z3551 + (z3881 - z83 * z2856 - z77 * z2855 + k7 * (z447 * z3466 + c_roll *
        z3587));
    const double z3883 = steer_dot * z3869 - z3882 + z4 * z3606 - z49 * z2826 - z76 * z2860 - e2z * z3633 +
        e2y * z2830;
    const double z3884 = s_lam * (e2z * z3446 - e3z * z3476) - c_lam * (z2 * z3476 + e2z * z3447) + z1372 *
        z2503;
    const double z3885 = z3884 - w2 * z2504 + z456 * z3453 + z479 * z2560 - z497 * z2519 + z23 * z3463 +
        s_steer * z3871;
    const double z3886 = z3885 - 2.0 * (z3 * z3480) - z12 * z3484 - z431 * z3511 - z59 * z2587 - z54 * z2586;
    const double z3887 = z3886 + z83 * z2539 - z77 * z2538 + k7 * (c_roll * z3466) - 2.0 * (z442 * z3469) +
        z1342 * z2582;
    const double z3888 = z4 * z3469 - z49 * z2581 - z76 * z2531;
    const double z3889 = z3887 - z1295 * z2532 - steer_dot * z3888 + z4 * z3481 - z49 * z2591 - z76 * z2543 -
        e2z * z3551;
    const double z3890 = z3889 - e2y * z2816 + z73 * z2834;
    const double z3891 = z1640 * z2489 - z1652 * z2484 + z1627 * z2503 - z1630 * z2504 - z1586 * z2560 +
        z1614 * z2519;
    const double z3892 = z3891 + z1558 * z3456 - z1523 * z3461 - z1551 * z3469 + z1509 * z3510 + z1355 *
        z2586 - z1351 * z2587;
    const double z3893 = z3892 - z1329 * z2538 - z1325 * z2539 + z442 * z3482 + z1342 * z2591 - z1295 * z2543
        + z404 * z2649;
    const double z3894 = z3893 - z394 * z2663 - z366 * z2785 - z369 * z2790 - z323 * z2674 - z314 * z2688 +
        z281 * z2725;
    const double z3895 = z1311 * z3498 + (z3894 + z284 * z2728 - z208 * z2699 - z199 * z2713 + z166 * z2752 -
        z170 * z2755);
    const double z3896 = s_lam * (c_lam * (z1284 * z3446) + s_lam * (z1286 * z3446)) - (z1372 * z2614 + (w2 *
        z2611 - (z1307 * z2547 + (z1347 * z2595 - z3895))));
    const double z3897 = z506 * z2626 - (z488 * z2637 - (c_lam * (s_lam * (z1286 * z3447) + c_lam * (z1284 *
        z3447)) - z3896));
    const double z3898 = z456 * z3545 - z3897 + z262 * z2744 - z251 * z2850 - z235 * z3578 + z143 * z2771 -
        z132 * z2840;
    const double z3899 = z3898 - z116 * z3564 + z109 * z3569 - z22 * z3752 + z25 * z3590 - (z1520 * z3503 +
        z22 * z3754 + c_lam * z3609 - s_lam * z3611);
    const double z3900 = z431 * z3740 - (z450 * z3550 - z3899) - z59 * z2821 - z54 * z2822 + z83 * z2855 -
        z77 * z2856;
    const double z3901 = c_lam * (z457 * z3506 + z467 * z3505 - c_pitch * z3758 + s_pitch * z3757) + s_lam *
        (z467 * z3506 - z457 * z3505 + s_pitch * z3758 + c_pitch * z3757);
    const double z3902 = steer_dot * z3890 + (z3900 + k7 * z3901) - e2z * z3663 + e2y * z2826 - z73 * z2860 +
        z4 * z3633;
    const double z3903 = c_steer * (z3883 - z73 * z2864) - s_steer * (z3902 + z49 * z2830 + z76 * z2864) +
        z422 * z3816;
    const double z3904 = z1625 * (z3903 + z427 * z3862);
    const double z3905 = z426 * z3862 + z427 * z3904;
    J[114] = -(z352 * z3816 - z353 * z3905 + z422 * z3904);
    J[115] = 0.0;
    J[116] = 0.0;
    const double z3906 = z1373 * z1467 + z1459 * z1383 + z1384 * z1474 + z126 * z1389 - z124 * z1393 - z442 *
        z2942;
    const double z3907 = z3906 - z447 * z3163 + z467 * z2982 - z457 * z3000 - e2z * z3168 - c_roll * z3022 -
        s_pitch * z3673;
    const double z3908 = z3907 - c_pitch * z3691;
    const double z3909 = z1373 * z1709 + z1703 * z1383 + z1384 * z1714 + z245 * z1389 - z243 * z1393 - z442 *
        z3223;
    const double z3910 = z3909 - z447 * z3425 - z467 * z3263 + z457 * z3282 - e2z * z3430 + c_roll * z3304 -
        s_pitch * z3708;
    const double z3911 = z3910 - c_pitch * z3726 - z353 * z3908;
    const double z3912 = z442 * z3475 + z447 * z3646 + z467 * z3514 - z457 * z3531 - e2z * z3651 - c_roll *
        z3553;
    const double z3913 = z1625 * (z3912 + s_pitch * z3743 + c_pitch * z3760 + z422 * z3908 + z427 * z3911);
    const double z3914 = z426 * z3911 + z427 * z3913;
    J[117] = -(z352 * z3908 - z353 * z3914 + z422 * z3913);
    const double z3915 = z445 * z3777 - z443 * z3799 - z1480 + z3669 - c_steer * z3801 - s_steer * z3779;
    const double z3916 = z445 * z3821 - z443 * z3844 + z2174 + z3704 - c_steer * z3846 - s_steer * z3823 -
        z353 * z3915;
    const double z3917 = z445 * z3867 - z443 * z3888 + z2616 + z3739 + c_steer * z3890 + s_steer * z3869 -
        z422 * z3915;
    const double z3918 = z1625 * (z3917 - z427 * z3916);
    const double z3919 = z426 * z3916 - z427 * z3918;
    J[118] = z352 * z3915 - z353 * z3919 - z422 * z3918;
    const double z3920 = F_yy * z1460 - z3014;
    const double z3921 = F_yy * z1704 - z3296 - z353 * z3920;
    const double z3922 = z1625 * (F_yy * z1626 - z3545 - z422 * z3920 - z427 * z3921);
    const double z3923 = z426 * z3921 - z427 * z3922;
    J[119] = z422 * z3922 - (z352 * z3920 - z353 * z3923);
    J[120] = 0.0;
    J[121] = 0.0;
    J[122] = 0.0;
    J[123] = -z2902;
    J[124] = z3666;
    J[125] = z3771;
    J[126] = -z3905;
    J[127] = 0.0;
    J[128] = 0.0;
    J[129] = -z3914;
    J[130] = z3919;
    J[131] = -z3923;
    J[132] = 0.0;
    J[133] = 0.0;
    J[134] = 0.0;
    J[135] = z2901;
    J[136] = -z3665;
    J[137] = -z3770;
    J[138] = -z3904;
    J[139] = 0.0;
    J[140] = 0.0;
    J[141] = -z3913;
    J[142] = -z3918;
    J[143] = z3922;
    return bicycle_finish(144, J);
}

int bicycle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;
    const double k2 = r_F * c_lam + c * s_lam;
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = c_lam * k2;
    const double k5 = s_lam * k2;
    const double k6 = fabs(r_R);
    const double k7 = fabs(r_F);
    const double k8 = fabs(c);
    const double k9 = k7 + k8;
    const double k10 = k9 + (k6 + k9) + (k9 + (fabs(w) + k8 + k9));
    const double k11 = k9 + k10;
    const double k12 = 3.0 * k9;
    const double k13 = k10 + k11;

    /* state */
    const double c_roll = cos(roll);
    const double c_pitch = cos(pitch);
    const double c_steer = cos(steer);
    const double z1 = 1.0 - c_steer;
    const double s_steer = sin(steer);
    const double s_pitch = sin(pitch);
    const double z2 = s_pitch * c_roll;
    const double z3 = z2 * c_lam;
    const double e3z = c_pitch * c_roll;
    const double z4 = z3 + e3z * s_lam;
    const double e2z = sin(roll);
    const double z5 = c_steer * z4 - e2z * s_steer;
    const double z6 = z2 * s_lam;
    const double z7 = z6 - e3z * c_lam;
    const double z8 = c_lam * z5 + s_lam * z7;
    const double z9 = c_lam * z7 - s_lam * z5;
    const double z10 = 1.0 / sqrt(z8 * z8 + z9 * z9);
    const double z11 = e2z * c_steer;
    const double z12 = s_steer * s_steer;
    const double z13 = c_pitch * (s_lam * z1 - s_steer * z10 * (z11 + 2.0 * (s_steer * z3))) + (s_pitch *
        (c_lam * z1 + 2.0 * (z10 * (z6 * z12))) - z10 * (z12 * (c_roll * s_lam)));
    const double z14 = s_pitch * (r_R - r_F * (c_steer * (1.0 + z10 * (s_steer * (e2z * s_lam))) + z10 * (e3z
        * z12)));
    const double z15 = c_lam * (r_F * z13 - c * (z1 * (c_pitch * c_lam - s_pitch * s_lam))) - (z14 + w *
        c_pitch);
    const double z16 = c_roll * z15;
    const double z17 = k7 * fabs(z10);
    const double z18 = 110.0 * z17;
    const double z19 = 30.0 * z17 + k12 + (80.0 * z17 + k10 + (z18 + (z18 + k11) + (1.0 + 300.0 * z17)));
    /* the coframe is singular */
    if (!(fabs(z16) > 1e-12 * (50.0 * z17 + z19))) {
        return BICYCLE_SINGULAR_1;
    }
    const double c_yaw = cos(yaw);
    const double e2y = c_yaw * c_roll;
    const double z20 = 1.0 / sqrt(z2 * z2 + e3z * e3z);
    const double z21 = r_R * z2 * z20;
    const double s_yaw = sin(yaw);
    const double z22 = c_yaw * e2z;
    const double e3y = s_yaw * s_pitch - c_pitch * z22;
    const double e1y = c_pitch * s_yaw + s_pitch * z22;
    const double z23 = r_R * e3z;
    const double R3 = z23 * z20;
    const double z24 = e3y * z21 + e1y * R3;
    const double z25 = c_steer * k3;
    const double z26 = r_R - s_lam * z25 - k4;
    const double z27 = k1 + c_lam * z25 - k5;
    const double z28 = s_pitch * z26 + c_pitch * z27;
    const double z29 = c_roll * (s_steer * k3) - e2z * (c_pitch * z26 - s_pitch * z27);
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z30 = e1y * c_lam - e3y * s_lam;
    const double f1y = c_steer * z30 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    const double z31 = r_F * z8 * z10;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z32 = r_F * z9;
    const double z33 = z32 * z10;
    const double z34 = h3y * z31 - h1y * z33;
    const double h2y = e2y * c_steer - s_steer * z30;
    const double z35 = h2y * z31;
    const double z36 = h2y * z33;
    const double z37 = s_lam * z35 + c_lam * z36;
    const double z38 = s_steer * z34 - c_steer * z37;
    const double z39 = c_lam * z35 - s_lam * z36;
    const double z40 = c_yaw * z28 - s_yaw * z29 + e3z * (s_lam * z38 - c_lam * z39) + e2z * (c_steer * z34 +
        s_steer * z37);
    const double z41 = e3z * (e2y * z21) - e2z * z24 - z2 * (e2y * R3) + (z40 + z2 * (c_lam * z38 + s_lam *
        z39));
    const double z42 = k6 * fabs(z20);
    const double z43 = 4.0 * z42;
    const double z44 = 190.0 * z17;
    const double z45 = 6.0 * z42 + (z44 + (140.0 * z17 + (z44 + k13)));
    /* the coframe is singular */
    if (!(fabs(-z41) > 1e-12 * (z43 + z45))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z46 = s_yaw * e2z;
    const double e3x = c_yaw * s_pitch + c_pitch * z46;
    const double e1x = c_yaw * c_pitch - z46 * s_pitch;
    const double z47 = e3x * z21 + e1x * R3;
    const double z48 = s_yaw * c_roll;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z49 = e1x * c_lam - e3x * s_lam;
    const double f1x = c_steer * z49 - z48 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z50 = h3x * z31 - h1x * z33;
    const double z51 = z48 * c_steer + z49 * s_steer;
    const double z52 = z51 * z31;
    const double z53 = z51 * z33;
    const double z54 = s_lam * z52 + c_lam * z53;
    const double z55 = s_steer * z50 + c_steer * z54;
    const double z56 = c_lam * z52 - s_lam * z53;
    const double z57 = c_yaw * z29 + s_yaw * z28 - e3z * (s_lam * z55 + c_lam * z56) - e2z * (c_steer * z50 -
        s_steer * z54);
    const double z58 = e3z * (z48 * z21) + e2z * z47 - z2 * (z48 * R3) + (z57 - z2 * (c_lam * z55 - s_lam *
        z56));
    const double z59 = 1.0 / z41;
    const double z60 = z47 + z58 * (z24 * z59);
    /* the coframe is singular */
    if (!(fabs(z60) > 1e-12 * (z43 + 4.0 * (z45 * (z42 * fabs(z59)))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z61 = roll_dot * s_pitch;
    const double z62 = roll_dot * c_pitch;
    const double z63 = s_lam * z61 - c_lam * z62;
    const double z64 = s_steer * z63;
    const double z65 = steer_dot + (c_lam * z61 + s_lam * z62);
    const double z66 = s_lam * z65;
    const double z67 = c_steer * z63;
    const double z68 = c_lam * z65;
    const double z69 = roll_dot * c_roll;
    const double z70 = steer_dot * c_steer;
    const double z71 = steer_dot * s_steer;
    const double z72 = roll_dot * e2z;
    const double z73 = c_pitch * z72;
    const double z74 = s_pitch * z72;
    const double z75 = s_steer * z69 + e2z * z70 + (z4 * z71 + c_steer * (s_lam * z73 + c_lam * z74));
    const double z76 = c_lam * z73 - s_lam * z74;
    const double z77 = z62 * R3 + z61 * z21;
    const double z78 = r_F * (s_lam * z75 + c_lam * z76) + (c * (s_lam * z76 - c_lam * z75) - (r_R * z73 -
        (e2z * z77 + k1 * z74)));
    const double z79 = (z11 + s_steer * z4) * (z33 * (z66 - c_lam * z67) - z31 * (s_lam * z67 + z68)) + (z8 *
        (z33 * z64) + z78);
    const double z80 = (z9 * (z31 * z64) - z79) / z16;
    const double z81 = thF_dot + (z64 + c_steer * z80);
    const double z82 = z31 * z81;
    const double z83 = z67 - s_steer * z80;
    const double z84 = z33 * (z66 - c_lam * z83) - z31 * (z68 + s_lam * z83);
    const double z85 = z33 * z81;
    const double z86 = s_yaw * z69;
    const double z87 = s_pitch * z80;
    const double z88 = c_pitch * z80;
    const double z89 = c_pitch * z86 - z46 * z87 + c_yaw * z88;
    const double z90 = s_pitch * z86 + z46 * z88 + c_yaw * z87;
    const double z91 = z48 * z70 - s_steer * (s_yaw * z72) + (z49 * z71 + c_steer * (s_lam * z89 + c_lam *
        z90));
    const double z92 = c_lam * z89 - s_lam * z90;
    const double z93 = r_F * (s_lam * z91 + c_lam * z92) + (c * (s_lam * z92 - c_lam * z91) - (r_R * z89 - k1
        * z90));
    const double z94 = z21 * z80;
    const double z95 = R3 * z80;
    const double z96 = h3x * z82 - (z51 * z84 + (h1x * z85 + z93)) - (e3x * z94 + (z48 * z77 + e1x * z95));
    const double z97 = c_yaw * z69;
    const double z98 = c_pitch * z97 - z22 * z87 - s_yaw * z88;
    const double z99 = s_pitch * z97 + z22 * z88 - s_yaw * z87;
    const double z100 = e2y * z70 - s_steer * (c_yaw * z72) - (z30 * z71 - c_steer * (s_lam * z98 + c_lam *
        z99));
    const double z101 = c_lam * z98 - s_lam * z99;
    const double z102 = r_F * (s_lam * z100 + c_lam * z101) + (c * (s_lam * z101 - c_lam * z100) - (r_R * z98
        - k1 * z99));
    const double z103 = h3y * z82 + (h2y * z84 - (h1y * z85 - z102)) - (e3y * z94 - (e2y * z77 - e1y * z95));
    /* 123:10 */
    out[0] = -r_R * ((z96 + z58 * (z59 * z103)) / z60); /* speed */
    /* 124:16 */
    out[1] = z + z2 * z21 + e3z * R3; /* rear_height */
    /* 125:17 */
    out[2] = z - z2 * k1 + z23 + c * z8 + z32 + z8 * z31 + z9 * z33; /* front_height */
    return bicycle_finish(3, out);
}

int bicycle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double z_B = p[9]; /* [m] */
    const double m_B = p[10]; /* [kg] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double B_xz = p[12]; /* [kg*m^2] */
    const double B_yy = p[13]; /* [kg*m^2] */
    const double B_zz = p[14]; /* [kg*m^2] */
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double z_H = p[16]; /* [m] */
    const double m_H = p[17]; /* [kg] */
    const double H_xx = p[18]; /* [kg*m^2] */
    const double H_xz = p[19]; /* [kg*m^2] */
    const double H_yy = p[20]; /* [kg*m^2] */
    const double H_zz = p[21]; /* [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = c + (w - x_H);
    const double k4 = 0.5 * R_xx;
    const double k5 = 0.5 * F_xx;
    const double k6 = r_F * c_lam + c * s_lam;
    const double k7 = r_F * s_lam - c * c_lam;
    const double k8 = c_lam * k6;
    const double k9 = s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(c);
    const double k13 = k11 + k12;
    const double k14 = k13 + (k10 + k13) + (k13 + (fabs(w) + k12 + k13));
    const double k15 = k13 + k14;
    const double k16 = 3.0 * k13;
    const double k17 = k14 + k15;
    const double k18 = s_lam * s_lam;
    const double k19 = c_lam * c_lam;
    const double k20 = 0.5 * H_zz + k5;
    const double k21 = 0.5 * H_xx + k5;
    const double k22 = k4 + 0.5 * B_xx;
    const double k23 = k4 + 0.5 * B_zz;
    int singular1 = 0;
    int singular2 = 0;
    int bad = 0;
    (void)t;
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC ivdep
#endif
    for (size_t i = 0; i < count; ++i) {
        const double yaw = y[3 * count + i]; /* first turn of the rear frame, about z [rad] */
        const double roll = y[4 * count + i]; /* second turn, about x [rad] */
        const double pitch = y[5 * count + i]; /* third turn, about y [rad] */
        const double steer = y[6 * count + i]; /* front frame against rear frame [rad] */
        const double roll_dot = y[9 * count + i];
        const double steer_dot = y[10 * count + i];
        const double thF_dot = y[11 * count + i];
        const double c_roll = cos(roll);
        const double c_pitch = cos(pitch);
        const double c_steer = cos(steer);
        const double z1 = 1.0 - c_steer;
        const double s_steer = sin(steer);
        const double s_pitch = sin(pitch);
        const double z2 = s_pitch * c_roll;
        const double z3 = z2 * c_lam;
        const double e3z = c_pitch * c_roll;
        const double z4 = z3 + e3z * s_lam;
        const double e2z = sin(roll);
        const double z5 = e2z * s_steer;
        const double z6 = c_steer * z4 - z5;
        const double z7 = z2 * s_lam;
        const double z8 = z7 - e3z * c_lam;
        const double z9 = c_lam * z6 + s_lam * z8;
        const double z10 = c_lam * z8 - s_lam * z6;
        const double z11 = z9 * z9 + z10 * z10;
        const double z12 = 1.0 / sqrt(z11);
        const double z13 = s_steer * z12;
        const double z14 = e2z * c_steer;
        const double z15 = z14 + 2.0 * (s_steer * z3);
        const double z16 = s_lam * z1 - z13 * z15;
        const double z17 = s_steer * s_steer;
        const double z18 = z7 * z17;
        const double z19 = c_lam * z1 + 2.0 * (z12 * z18);
        const double z20 = c_roll * s_lam;
        const double z21 = z17 * z20;
        const double z22 = c_pitch * c_lam - s_pitch * s_lam;
        const double z23 = e2z * s_lam;
        const double z24 = s_steer * z23;
        const double z25 = 1.0 + z12 * z24;
        const double z26 = e3z * z17;
        const double z27 = r_R - r_F * (c_steer * z25 + z12 * z26);
        const double z28 = c_lam * (r_F * (c_pitch * z16 + (s_pitch * z19 - z12 * z21)) - c * (z1 * z22)) -
            (s_pitch * z27 + w * c_pitch);
        const double z29 = c_roll * z28;
        const double z30 = k11 * fabs(z12);
        const double z31 = 110.0 * z30;
        const double z32 = 30.0 * z30 + k16 + (80.0 * z30 + k14 + (z31 + (z31 + k15) + (1.0 + 300.0 * z30)));
        /* the coframe is singular */
        singular1 |= !(fabs(z29) > 1e-12 * (50.0 * z30 + z32));
        const double c_yaw = cos(yaw);
        const double e2y = c_yaw * c_roll;
        const double z33 = r_R * z2;
        const double z34 = z2 * z2 + e3z * e3z;
        const double z35 = 1.0 / sqrt(z34);
        const double z36 = z33 * z35;
        const double z37 = e2y * z36;
        const double s_yaw = sin(yaw);
        const double z38 = c_yaw * e2z;
        const double e3y = s_yaw * s_pitch - c_pitch * z38;
        const double e1y = c_pitch * s_yaw + s_pitch * z38;
        const double z39 = r_R * e3z;
        const double R3 = z39 * z35;
        const double z40 = e3y * z36 + e1y * R3;
        const double z41 = e2y * R3;
        const double z42 = c_steer * k7;
        const double z43 = r_R - s_lam * z42 - k8;
        const double z44 = k2 + c_lam * z42 - k9;
        const double z45 = s_pitch * z43 + c_pitch * z44;
        const double z46 = s_steer * k7;
        const double z47 = c_pitch * z43 - s_pitch * z44;
        const double z48 = c_roll * z46 - e2z * z47;
        const double sy = e1y * s_lam + e3y * c_lam;
        const double z49 = e1y * c_lam - e3y * s_lam;
        const double f1y = c_steer * z49 + e2y * s_steer;
        const double h3y = c_lam * sy - s_lam * f1y;
        const double z50 = r_F * z9;
        const double z51 = z50 * z12;
        const double h1y = c_lam * f1y + s_lam * sy;
        const double z52 = r_F * z10;
        const double z53 = z52 * z12;
        const double z54 = h3y * z51 - h1y * z53;
        const double z55 = e2y * c_steer;
        const double z56 = s_steer * z49;
        const double h2y = z55 - z56;
        const double z57 = h2y * z51;
        const double z58 = h2y * z53;
        const double z59 = s_lam * z57 + c_lam * z58;
        const double z60 = s_steer * z54 - c_steer * z59;
        const double z61 = c_lam * z57 - s_lam * z58;
        const double z62 = s_lam * z60 - c_lam * z61;
        const double z63 = c_steer * z54 + s_steer * z59;
        const double z64 = c_lam * z60 + s_lam * z61;
        const double z65 = c_yaw * z45 - s_yaw * z48 + e3z * z62 + e2z * z63 + z2 * z64;
        const double z66 = e3z * z37 - e2z * z40 - z2 * z41 + z65;
        const double z67 = k10 * fabs(z35);
        const double z68 = 4.0 * z67;
        const double z69 = 190.0 * z30;
        const double z70 = 6.0 * z67 + (z69 + (140.0 * z30 + (z69 + k17)));
        /* the coframe is singular */
        singular1 |= !(fabs(-z66) > 1e-12 * (z68 + z70));
        const double z71 = s_yaw * e2z;
        const double e3x = c_yaw * s_pitch + c_pitch * z71;
        const double e1x = c_yaw * c_pitch - z71 * s_pitch;
        const double z72 = e3x * z36 + e1x * R3;
        const double z73 = s_yaw * c_roll;
        const double z74 = z73 * z36;
        const double z75 = z73 * R3;
        const double sx = e1x * s_lam + e3x * c_lam;
        const double z76 = e1x * c_lam - e3x * s_lam;
        const double f1x = c_steer * z76 - z73 * s_steer;
        const double h3x = c_lam * sx - s_lam * f1x;
        const double h1x = c_lam * f1x + s_lam * sx;
        const double z77 = h3x * z51 - h1x * z53;
        const double z78 = z73 * c_steer;
        const double z79 = z76 * s_steer;
        const double z80 = z78 + z79;
        const double z81 = z80 * z51;
        const double z82 = z80 * z53;
        const double z83 = s_lam * z81 + c_lam * z82;
        const double z84 = s_steer * z77 + c_steer * z83;
        const double z85 = c_lam * z81 - s_lam * z82;
        const double z86 = s_lam * z84 + c_lam * z85;
        const double z87 = c_steer * z77 - s_steer * z83;
        const double z88 = c_lam * z84 - s_lam * z85;
        const double z89 = c_yaw * z48 + s_yaw * z45 - e3z * z86 - e2z * z87 - z2 * z88;
        const double z90 = e3z * z74 + e2z * z72 - z2 * z75 + z89;
        const double z91 = 1.0 / z66;
        const double z92 = z40 * z91;
        const double z93 = z72 + z90 * z92;
        /* the coframe is singular */
        singular1 |= !(fabs(z93) > 1e-12 * (z68 + 4.0 * (z70 * (z67 * fabs(z91)))));
        const double z94 = s_steer * z22;
        const double z95 = 1.0 / z29;
        const double z96 = s_steer * z4;
        const double h2z = z14 + z96;
        const double z97 = s_pitch * c_lam + c_pitch * s_lam;
        const double z98 = s_lam * z97;
        const double z99 = c_steer * z22;
        const double z100 = c_lam * z97;
        const double z101 = c_roll * s_steer;
        const double z102 = c_pitch * e2z;
        const double z103 = e2z * s_pitch;
        const double z104 = z101 + c_steer * (s_lam * z102 + c_lam * z103);
        const double z105 = c_lam * z102 - s_lam * z103;
        const double z106 = c_pitch * R3 + s_pitch * z36;
        const double z107 = e2z * z106;
        const double z108 = r_F * (s_lam * z104 + c_lam * z105) + (c * (s_lam * z105 - c_lam * z104) - (r_R *
            z102 - (z107 + k2 * z103)));
        const double z109 = h2z * (z53 * (z98 + c_lam * z99) + z51 * (s_lam * z99 - z100)) - (z9 * (z53 *
            z94) - z108);
        const double z110 = z95 * (z10 * (z51 * z94) + z109);
        const double z111 = z94 + c_steer * z110;
        const double z112 = z51 * z111;
        const double z113 = z99 - s_steer * z110;
        const double z114 = z53 * (z98 + c_lam * z113) - z51 * (z100 - s_lam * z113);
        const double z115 = z53 * z111;
        const double z116 = s_pitch * z110;
        const double z117 = z71 * z116;
        const double z118 = c_pitch * z110;
        const double z119 = c_yaw * z118;
        const double z120 = c_pitch * z73 + z117 - z119;
        const double z121 = z71 * z118;
        const double z122 = c_yaw * z116;
        const double z123 = z121 - s_pitch * z73 + z122;
        const double z124 = z71 * s_steer - c_steer * (s_lam * z120 - c_lam * z123);
        const double z125 = c_lam * z120 + s_lam * z123;
        const double z126 = r_F * (s_lam * z124 - c_lam * z125) - (c * (s_lam * z125 + c_lam * z124) - (r_R *
            z120 + k2 * z123));
        const double z127 = h3x * z112 + (z80 * z114 - (h1x * z115 + z126));
        const double z128 = z38 * z116;
        const double z129 = s_yaw * z118;
        const double z130 = c_pitch * e2y + z128 + z129;
        const double z131 = z38 * z118;
        const double z132 = s_yaw * z116;
        const double z133 = s_pitch * e2y - z131 + z132;
        const double z134 = z38 * s_steer - c_steer * (s_lam * z130 + c_lam * z133);
        const double z135 = c_lam * z130 - s_lam * z133;
        const double z136 = r_F * (s_lam * z134 - c_lam * z135) - (c * (s_lam * z135 + c_lam * z134) - (r_R *
            z130 - k2 * z133));
        const double z137 = h3y * z112 - (h2y * z114 + (h1y * z115 - z136));
        const double z138 = z36 * z110;
        const double z139 = R3 * z110;
        const double z140 = z91 * (z137 - (e3y * z138 + (e2y * z106 + e1y * z139)));
        const double z141 = z89 * z92;
        const double z142 = 1.0 / z93;
        const double z143 = z142 * (z127 - (e3x * z138 - (z73 * z106 - e1x * z139)) + z90 * z140);
        const double z144 = z127 + z89 * z140 - z141 * z143;
        const double z145 = z65 * z92;
        const double z146 = z137 - z65 * z140 + z145 * z143;
        const double z147 = m_R * z107;
        const double z148 = z140 - z92 * z143;
        const double z149 = c_pitch - z2 * z148;
        const double z150 = s_pitch + e3z * z148;
        const double z151 = z144 * (m_R * z144) + z146 * (m_R * z146) + z107 * z147 + z149 * (2.0 * (k22 *
            z149) + B_xz * z150);
        const double z152 = z110 - e2z * z148;
        const double z153 = c_lam * z149 - s_lam * z150;
        const double z154 = c_steer * z153 - s_steer * z152;
        const double z155 = s_lam * z149 + c_lam * z150;
        const double z156 = c_lam * z154 + s_lam * z155;
        const double z157 = c_lam * z155 - s_lam * z154;
        const double z158 = z151 + z152 * (B_yy * z152) + z150 * (B_xz * z149 + 2.0 * (k23 * z150)) + z156 *
            (2.0 * (k21 * z156) + H_xz * z157);
        const double z159 = c_steer * z152 + s_steer * z153;
        const double z160 = z143 + z152;
        const double z161 = z158 + z159 * (H_yy * z159) + z157 * (H_xz * z156 + 2.0 * (k20 * z157)) + z160 *
            (R_yy * z160);
        const double z162 = s_yaw * z148;
        const double z163 = c_yaw * z148;
        const double z164 = z73 + e2z * z163;
        const double z165 = z122 - c_pitch * z162 + (z121 - s_pitch * z164);
        const double z166 = z119 + s_pitch * z162 - (z117 + c_pitch * z164);
        const double z167 = z144 + x_B * z165 - k1 * z166;
        const double z168 = e2y - e2z * z162;
        const double z169 = z132 + c_pitch * z163 - (z131 - s_pitch * z168);
        const double z170 = z129 - s_pitch * z163 + (z128 + c_pitch * z168);
        const double z171 = z146 + x_B * z169 - k1 * z170;
        const double z172 = z103 + c_roll * z118;
        const double z173 = z102 - c_roll * z116;
        const double z174 = z107 + x_B * z172 - k1 * z173;
        const double z175 = m_B * z174;
        const double z176 = z144 + k2 * z165 - r_R * z166;
        const double z177 = c_steer * (c_lam * z165 + s_lam * z166) + s_steer * (z71 - c_roll * z163);
        const double z178 = s_lam * z165 - c_lam * z166;
        const double z179 = c_lam * z177 + s_lam * z178;
        const double z180 = c_lam * z178 - s_lam * z177;
        const double z181 = z176 - k3 * z179 + z_H * z180;
        const double z182 = z161 + z167 * (m_B * z167) + z171 * (m_B * z171) + z174 * z175 + z181 * (m_H *
            z181);
        const double z183 = z146 + k2 * z169 - r_R * z170;
        const double z184 = c_steer * (c_lam * z169 + s_lam * z170) - s_steer * (z38 + c_roll * z162);
        const double z185 = s_lam * z169 - c_lam * z170;
        const double z186 = c_lam * z184 + s_lam * z185;
        const double z187 = c_lam * z185 - s_lam * z184;
        const double z188 = z183 - k3 * z186 + z_H * z187;
        const double z189 = z107 + k2 * z172 - r_R * z173;
        const double z190 = z101 + c_steer * (c_lam * z172 + s_lam * z173);
        const double z191 = s_lam * z172 - c_lam * z173;
        const double z192 = c_lam * z190 + s_lam * z191;
        const double z193 = c_lam * z191 - s_lam * z190;
        const double z194 = z189 - k3 * z192 + z_H * z193;
        const double z195 = m_H * z194;
        const double z196 = z176 - c * z179 - r_F * z180;
        const double z197 = z183 - c * z186 - r_F * z187;
        const double z198 = z182 + z188 * (m_H * z188) + z194 * z195 + z196 * (m_F * z196) + z197 * (m_F *
            z197);
        const double z199 = z189 - c * z192 - r_F * z193;
        const double z200 = m_F * z199;
        const double z201 = z198 + z199 * z200 + z159 * (F_yy * z159);
        /* the mass matrix is singular */
        singular2 |= !(fabs(z201) > 0.0);
        const double z202 = z95 * (h2z * (s_lam * z53 - c_lam * z51) + (r_F * (s_lam * h2z) - c * (c_lam *
            h2z)));
        const double z203 = c_steer * z202;
        const double z204 = z51 * z203;
        const double z205 = s_steer * z202;
        const double z206 = z53 * (s_lam - c_lam * z205) - z51 * (c_lam + s_lam * z205);
        const double z207 = z53 * z203;
        const double z208 = s_pitch * z202;
        const double z209 = z71 * z208;
        const double z210 = c_pitch * z202;
        const double z211 = c_yaw * z210;
        const double z212 = z209 - z211;
        const double z213 = z71 * z210;
        const double z214 = c_yaw * z208;
        const double z215 = z213 + z214;
        const double z216 = z78 + (z79 + c_steer * (s_lam * z212 - c_lam * z215));
        const double z217 = c_lam * z212 + s_lam * z215;
        const double z218 = r_F * (s_lam * z216 + c_lam * z217) + (c * (s_lam * z217 - c_lam * z216) - (r_R *
            z212 + k2 * z215));
        const double z219 = h3x * z204 + (z80 * z206 - (h1x * z207 - z218));
        const double z220 = z38 * z208;
        const double z221 = s_yaw * z210;
        const double z222 = z220 + z221;
        const double z223 = z38 * z210;
        const double z224 = s_yaw * z208;
        const double z225 = z223 - z224;
        const double z226 = z55 - (z56 - c_steer * (s_lam * z222 - c_lam * z225));
        const double z227 = c_lam * z222 + s_lam * z225;
        const double z228 = r_F * (s_lam * z226 + c_lam * z227) + (c * (s_lam * z227 - c_lam * z226) - (r_R *
            z222 + k2 * z225));
        const double z229 = h3y * z204 - (h2y * z206 + (h1y * z207 + z228));
        const double z230 = z36 * z202;
        const double z231 = R3 * z202;
        const double z232 = z91 * (z229 - (e3y * z230 + e1y * z231));
        const double z233 = z142 * (z219 - (e3x * z230 + e1x * z231) + z90 * z232);
        const double z234 = z219 + z89 * z232 - z141 * z233;
        const double z235 = m_R * z234;
        const double z236 = z229 - z65 * z232 + z145 * z233;
        const double z237 = m_R * z236;
        const double z238 = z232 - z92 * z233;
        const double z239 = z2 * z238;
        const double z240 = e3z * z238;
        const double z241 = 2.0 * (k22 * z239) - B_xz * z240;
        const double z242 = z202 - e2z * z238;
        const double z243 = B_yy * z242;
        const double z244 = B_xz * z239 - 2.0 * (k23 * z240);
        const double z245 = c_lam * z239 + s_lam * z240;
        const double z246 = c_steer * z245 + s_steer * z242;
        const double z247 = 1.0 - (s_lam * z239 - c_lam * z240);
        const double z248 = c_lam * z246 - s_lam * z247;
        const double z249 = c_lam * z247 + s_lam * z246;
        const double z250 = 2.0 * (k21 * z248) - H_xz * z249;
        const double z251 = z234 * z235 + z236 * z237 + z239 * z241 + z242 * z243 - z240 * z244 + z248 * z250;
        const double z252 = c_steer * z242 - s_steer * z245;
        const double z253 = H_yy * z252;
        const double z254 = H_xz * z248 - 2.0 * (k20 * z249);
        const double z255 = z233 + z242;
        const double z256 = R_yy * z255;
        const double z257 = s_yaw * z238;
        const double z258 = c_yaw * z238;
        const double z259 = e2z * z258;
        const double z260 = z214 - c_pitch * z257 + (z213 - s_pitch * z259);
        const double z261 = z211 + s_pitch * z257 - (z209 + c_pitch * z259);
        const double z262 = z234 + x_B * z260 - k1 * z261;
        const double z263 = m_B * z262;
        const double z264 = e2z * z257;
        const double z265 = z224 + c_pitch * z258 - (z223 + s_pitch * z264);
        const double z266 = z221 - s_pitch * z258 + (z220 - c_pitch * z264);
        const double z267 = z236 + x_B * z265 - k1 * z266;
        const double z268 = m_B * z267;
        const double z269 = c_roll * z210;
        const double z270 = c_roll * z208;
        const double z271 = x_B * z269 + k1 * z270;
        const double z272 = m_B * z271;
        const double z273 = z251 + z252 * z253 - z249 * z254 + z255 * z256 + z262 * z263 + z267 * z268 + z271
            * z272;
        const double z274 = z234 + k2 * z260 - r_R * z261;
        const double z275 = z79 - c_steer * (c_lam * z260 + s_lam * z261) + (z78 + s_steer * (c_roll * z258));
        const double z276 = s_lam * z260 - c_lam * z261;
        const double z277 = c_lam * z275 - s_lam * z276;
        const double z278 = c_lam * z276 + s_lam * z275;
        const double z279 = z274 + k3 * z277 + z_H * z278;
        const double z280 = m_H * z279;
        const double z281 = z236 + k2 * z265 - r_R * z266;
        const double z282 = z56 - c_steer * (c_lam * z265 + s_lam * z266) - (z55 - s_steer * (c_roll * z257));
        const double z283 = s_lam * z265 - c_lam * z266;
        const double z284 = c_lam * z282 - s_lam * z283;
        const double z285 = c_lam * z283 + s_lam * z282;
        const double z286 = z281 + k3 * z284 + z_H * z285;
        const double z287 = m_H * z286;
        const double z288 = k2 * z269 + r_R * z270;
        const double z289 = z14 + (z96 + c_steer * (c_lam * z269 - s_lam * z270));
        const double z290 = s_lam * z269 + c_lam * z270;
        const double z291 = c_lam * z289 + s_lam * z290;
        const double z292 = c_lam * z290 - s_lam * z289;
        const double z293 = z288 - k3 * z291 + z_H * z292;
        const double z294 = m_H * z293;
        const double z295 = z274 + c * z277 - r_F * z278;
        const double z296 = m_F * z295;
        const double z297 = z281 + c * z284 - r_F * z285;
        const double z298 = m_F * z297;
        const double z299 = z288 - c * z291 - r_F * z292;
        const double z300 = m_F * z299;
        const double z301 = z273 + z279 * z280 + z286 * z287 + z293 * z294 + z295 * z296 + z297 * z298 + z299
            * z300;
        const double z302 = F_yy * z252;
        const double z303 = z301 + z252 * z302;
        const double z304 = z144 * z235 + z146 * z237 - z149 * z241 + z152 * z243 - z150 * z244 - z156 * z250;
        const double z305 = z304 + z159 * z253 - z157 * z254 + z160 * z256 + z167 * z263 + z171 * z268 + z174
            * z272;
        const double z306 = z305 + z181 * z280 + z188 * z287 + z194 * z294 + z196 * z296 + z197 * z298 + z199
            * z300;
        const double z307 = z306 + z159 * z302;
        const double z308 = 1.0 / z201;
        const double z309 = z307 * z308;
        const double z310 = z303 - z307 * z309;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z310) > 1e-14 * z303);
        const double z311 = z54 * z91;
        const double z312 = z142 * (z77 + z90 * z311);
        const double z313 = z77 + z89 * z311 - z141 * z312;
        const double z314 = m_R * z313;
        const double z315 = z54 - z65 * z311 + z145 * z312;
        const double z316 = m_R * z315;
        const double z317 = z311 - z92 * z312;
        const double z318 = z2 * z317;
        const double z319 = e3z * z317;
        const double z320 = 2.0 * (k22 * z318) - B_xz * z319;
        const double z321 = e2z * z317;
        const double z322 = B_yy * z321;
        const double z323 = B_xz * z318 - 2.0 * (k23 * z319);
        const double z324 = c_lam * z318 + s_lam * z319;
        const double z325 = c_steer * z324 - s_steer * z321;
        const double z326 = s_lam * z318 - c_lam * z319;
        const double z327 = c_lam * z325 + s_lam * z326;
        const double z328 = c_lam * z326 - s_lam * z325;
        const double z329 = 2.0 * (k21 * z327) + H_xz * z328;
        const double z330 = z313 * z314 + z315 * z316 + z318 * z320 + z321 * z322 - z319 * z323 + z327 * z329;
        const double z331 = c_steer * z321 + s_steer * z324;
        const double z332 = H_yy * z331;
        const double z333 = H_xz * z327 + 2.0 * (k20 * z328);
        const double z334 = z312 - z321;
        const double z335 = R_yy * z334;
        const double z336 = s_yaw * z317;
        const double z337 = c_yaw * z317;
        const double z338 = e2z * z337;
        const double z339 = c_pitch * z336 + s_pitch * z338;
        const double z340 = s_pitch * z336 - c_pitch * z338;
        const double z341 = z313 - x_B * z339 - k1 * z340;
        const double z342 = m_B * z341;
        const double z343 = e2z * z336;
        const double z344 = c_pitch * z337 - s_pitch * z343;
        const double z345 = s_pitch * z337 + c_pitch * z343;
        const double z346 = z315 + x_B * z344 + k1 * z345;
        const double z347 = m_B * z346;
        const double z348 = z313 - k2 * z339 - r_R * z340;
        const double z349 = c_steer * (c_lam * z339 - s_lam * z340) + s_steer * (c_roll * z337);
        const double z350 = s_lam * z339 + c_lam * z340;
        const double z351 = c_lam * z349 + s_lam * z350;
        const double z352 = c_lam * z350 - s_lam * z349;
        const double z353 = z348 + k3 * z351 - z_H * z352;
        const double z354 = m_H * z353;
        const double z355 = z330 + z331 * z332 + z328 * z333 + z334 * z335 + z341 * z342 + z346 * z347 + z353
            * z354;
        const double z356 = z315 + k2 * z344 + r_R * z345;
        const double z357 = c_steer * (c_lam * z344 - s_lam * z345) - s_steer * (c_roll * z336);
        const double z358 = s_lam * z344 + c_lam * z345;
        const double z359 = c_lam * z357 + s_lam * z358;
        const double z360 = c_lam * z358 - s_lam * z357;
        const double z361 = z356 - k3 * z359 + z_H * z360;
        const double z362 = m_H * z361;
        const double z363 = z348 + c * z351 + r_F * z352;
        const double z364 = m_F * z363;
        const double z365 = z356 - c * z359 - r_F * z360;
        const double z366 = m_F * z365;
        const double z367 = 1.0 - z331;
        const double z368 = F_yy * z367;
        const double z369 = z355 + z361 * z362 + z363 * z364 + z365 * z366 + z367 * z368;
        const double z370 = z144 * z314 + z146 * z316 - z149 * z320 - z152 * z322 - z150 * z323 - z156 * z329;
        const double z371 = z370 - z159 * z332 - z157 * z333 + z160 * z335 + z167 * z342 + z171 * z347 + z181
            * z354;
        const double z372 = z371 + z188 * z362 + z196 * z364 + z197 * z366 + z159 * z368;
        const double z373 = z372 * z308;
        const double z374 = z234 * z314 + z236 * z316 + z239 * z320 - z242 * z322 - z240 * z323 + z248 * z329;
        const double z375 = z374 - z252 * z332 - z249 * z333 + z255 * z335 + z262 * z342 + z267 * z347 + z279
            * z354;
        const double z376 = z375 + z286 * z362 + z295 * z364 + z297 * z366 + z252 * z368 - z307 * z373;
        const double z377 = 1.0 / z310;
        const double z378 = z376 * z377;
        const double z379 = z369 - z372 * z373 - z376 * z378;
        /* the mass matrix is singular */
        singular2 |= !(fabs(z379) > 1e-14 * z369);
        const double z380 = roll_dot * s_pitch;
        const double z381 = roll_dot * c_pitch;
        const double z382 = s_lam * z380 - c_lam * z381;
        const double z383 = s_steer * z382;
        const double z384 = z51 * z383;
        const double z385 = steer_dot + (c_lam * z380 + s_lam * z381);
        const double z386 = s_lam * z385;
        const double z387 = c_steer * z382;
        const double z388 = z386 - c_lam * z387;
        const double z389 = c_lam * z385;
        const double z390 = s_lam * z387 + z389;
        const double z391 = z53 * z388 - z51 * z390;
        const double z392 = z53 * z383;
        const double z393 = roll_dot * c_roll;
        const double z394 = steer_dot * c_steer;
        const double z395 = s_steer * z393 + e2z * z394;
        const double z396 = steer_dot * s_steer;
        const double z397 = z4 * z396;
        const double z398 = roll_dot * e2z;
        const double z399 = c_pitch * z398;
        const double z400 = s_pitch * z398;
        const double z401 = s_lam * z399 + c_lam * z400;
        const double z402 = z395 + (z397 + c_steer * z401);
        const double z403 = c_lam * z399 - s_lam * z400;
        const double z404 = z381 * R3 + z380 * z36;
        const double z405 = e2z * z404;
        const double z406 = r_F * (s_lam * z402 + c_lam * z403) + (c * (s_lam * z403 - c_lam * z402) - (r_R *
            z399 - (z405 + k2 * z400)));
        const double z407 = z10 * z384 - (h2z * z391 + (z9 * z392 + z406));
        const double z408 = z95 * z407;
        const double z409 = thF_dot + (z383 + c_steer * z408);
        const double z410 = z51 * z409;
        const double z411 = s_steer * z408;
        const double z412 = z387 - z411;
        const double z413 = z386 - c_lam * z412;
        const double z414 = z389 + s_lam * z412;
        const double z415 = z53 * z413 - z51 * z414;
        const double z416 = z53 * z409;
        const double z417 = z73 * z394;
        const double z418 = s_yaw * z398;
        const double z419 = z76 * z396;
        const double z420 = s_yaw * z393;
        const double z421 = s_pitch * z408;
        const double z422 = z71 * z421;
        const double z423 = c_pitch * z408;
        const double z424 = c_yaw * z423;
        const double z425 = c_pitch * z420 - z422 + z424;
        const double z426 = z71 * z423;
        const double z427 = c_yaw * z421;
        const double z428 = s_pitch * z420 + z426 + z427;
        const double z429 = s_lam * z425 + c_lam * z428;
        const double z430 = z417 - s_steer * z418 + (z419 + c_steer * z429);
        const double z431 = c_lam * z425 - s_lam * z428;
        const double z432 = r_F * (s_lam * z430 + c_lam * z431) + (c * (s_lam * z431 - c_lam * z430) - (r_R *
            z425 - k2 * z428));
        const double z433 = h3x * z410 - (z80 * z415 + (h1x * z416 + z432));
        const double z434 = e2y * z394;
        const double z435 = c_yaw * z398;
        const double z436 = z49 * z396;
        const double z437 = c_yaw * z393;
        const double z438 = z38 * z421;
        const double z439 = s_yaw * z423;
        const double z440 = c_pitch * z437 - z438 - z439;
        const double z441 = z38 * z423;
        const double z442 = s_yaw * z421;
        const double z443 = s_pitch * z437 + z441 - z442;
        const double z444 = s_lam * z440 + c_lam * z443;
        const double z445 = z434 - s_steer * z435 - (z436 - c_steer * z444);
        const double z446 = c_lam * z440 - s_lam * z443;
        const double z447 = r_F * (s_lam * z445 + c_lam * z446) + (c * (s_lam * z446 - c_lam * z445) - (r_R *
            z440 - k2 * z443));
        const double z448 = h3y * z410 + (h2y * z415 - (h1y * z416 - z447));
        const double z449 = z36 * z408;
        const double z450 = R3 * z408;
        const double z451 = z448 - (e3y * z449 - (e2y * z404 - e1y * z450));
        const double z452 = z91 * z451;
        const double z453 = z433 - (e3x * z449 + (z73 * z404 + e1x * z450)) + z90 * z452;
        const double z454 = z142 * z453;
        const double z455 = z452 - z92 * z454;
        const double w2 = z408 - e2z * z455;
        const double w1 = z381 + z2 * z455;
        const double w3 = z380 - e3z * z455;
        const double z456 = c_lam * w1 - s_lam * w3;
        const double o2 = c_steer * w2 - s_steer * z456;
        const double z457 = F_yy * (thF_dot + o2);
        const double z458 = s_lam * s_steer;
        const double z459 = s_lam * z394;
        const double z460 = c_lam * s_steer;
        const double z461 = c_lam * z394;
        const double z462 = c_steer * z393 - e2z * z396;
        const double z463 = z399 + c_roll * z421;
        const double z464 = z400 - c_roll * z423;
        const double z465 = z462 - (z458 * z463 - e3z * z459) - (z460 * z464 - z2 * z461);
        const double z466 = z396 * z110 + (z423 * z458 + s_pitch * z459 + (z421 * z460 - c_pitch * z461) +
            z148 * z465);
        const double z467 = z455 * (c_roll * c_steer - z458 * z173 - z460 * z172) + roll_dot * (z118 * z458 +
            z116 * z460);
        const double z468 = z466 + z467;
        const double z469 = s_lam * z396;
        const double z470 = c_lam * z464;
        const double z471 = z470 + s_lam * z463;
        const double z472 = z395 + (z397 + c_steer * z471);
        const double z473 = s_lam * z464;
        const double z474 = z473 - c_lam * z463;
        const double z475 = c_lam * z472 + s_lam * z474;
        const double z476 = c_lam * z474 - s_lam * z472;
        const double z477 = z12 * (2.0 * (z9 * z475) + 2.0 * (z10 * z476)) / z11;
        const double z478 = z15 * (z394 * z12 + 0.5 * (s_steer * z477)) + z13 * (z462 + 2.0 * (z3 * z394 -
            s_steer * z470));
        const double z479 = c_lam * z396;
        const double z480 = s_steer * z394;
        const double z481 = s_pitch * (z479 + 2.0 * (0.5 * (z18 * z477) - z12 * (z17 * z473 - 2.0 * (z7 *
            z480))));
        const double z482 = z19 * z423 + z481 - (0.5 * (z21 * z477) + z12 * (2.0 * (z20 * z480) - z17 *
            (s_lam * z398)));
        const double z483 = r_F * (z16 * z421 - c_pitch * (z469 - z478) - z482) + c * (z396 * z22 - z1 *
            (c_lam * z421 + s_lam * z423));
        const double z484 = z396 * z25 - c_steer * (0.5 * (z24 * z477) + z12 * (z394 * z23 + s_steer * (s_lam
            * z393)));
        const double z485 = s_pitch * (r_F * (z484 - (0.5 * (z26 * z477) - z12 * (z17 * z463 - 2.0 * (e3z *
            z480)))));
        const double z486 = (z398 * z28 + c_roll * (c_lam * z483 + (z27 * z423 + z485 - w * z421))) / (z29 *
            z29);
        const double z487 = z12 * (r_F * z475) - 0.5 * (z50 * z477);
        const double z488 = roll_dot * z423;
        const double z489 = roll_dot * z421;
        const double z490 = s_lam * z488 + c_lam * z489;
        const double z491 = z394 * z382 + s_steer * z490;
        const double z492 = z12 * (r_F * z476) - 0.5 * (z52 * z477);
        const double z493 = c_lam * z488 - s_lam * z489;
        const double z494 = s_lam * z493;
        const double z495 = z396 * z382 - c_steer * z490;
        const double z496 = c_lam * z493;
        const double z497 = z388 * z492 - z53 * (z494 + c_lam * z495) - (z390 * z487 + z51 * (s_lam * z495 -
            z496));
        const double z498 = z393 * z394;
        const double z499 = roll_dot * z398;
        const double z500 = steer_dot * z396;
        const double z501 = z498 - s_steer * z499 + (z498 - e2z * z500);
        const double z502 = z396 * z471;
        const double z503 = steer_dot * z394;
        const double z504 = z502 - z4 * z503;
        const double z505 = z398 * z421;
        const double z506 = roll_dot * z393;
        const double z507 = z505 - c_pitch * z506;
        const double z508 = z398 * z423;
        const double z509 = z508 + s_pitch * z506;
        const double z510 = z501 - (z504 + (z396 * z401 + c_steer * (s_lam * z507 - c_lam * z509)));
        const double z511 = c_lam * z507 + s_lam * z509;
        const double z512 = z35 * (2.0 * (z2 * z464) + 2.0 * (e3z * z463)) / z34;
        const double z513 = z35 * (r_R * z463) - 0.5 * (z39 * z512);
        const double z514 = z35 * (r_R * z464) - 0.5 * (z33 * z512);
        const double z515 = R3 * z489 + z381 * z513 - (z36 * z488 - z380 * z514);
        const double z516 = z393 * z404 - e2z * z515;
        const double z517 = r_F * (s_lam * z510 - c_lam * z511) - (c * (s_lam * z511 + c_lam * z510) - (r_R *
            z507 + (z516 + k2 * z509)));
        const double z518 = z391 * (z462 + (z4 * z394 - s_steer * z471)) - h2z * z497 - (z392 * z475 + z9 *
            (z383 * z492 - z53 * z491) - z517);
        const double z519 = z407 * z486 - z95 * (z384 * z476 + z10 * (z383 * z487 - z51 * z491) + z518);
        const double z520 = s_yaw * z455;
        const double z521 = z435 - c_roll * z520;
        const double z522 = c_yaw * z455;
        const double z523 = z437 + e2z * z520;
        const double z524 = z439 - s_pitch * z522 + (z438 - c_pitch * z523);
        const double z525 = z442 + c_pitch * z522 - (z441 + s_pitch * z523);
        const double z526 = z36 * z524 - e3y * z514 - (R3 * z525 + e1y * z513);
        const double z527 = z37 * z463 + e3z * (z36 * z521 + e2y * z514) + (z393 * z40 + e2z * z526) - (z41 *
            z464 + z2 * (R3 * z521 + e2y * z513));
        const double z528 = z396 * k7;
        const double z529 = s_lam * z528;
        const double z530 = c_lam * z528;
        const double z531 = z43 * z423 + s_pitch * z529 - (z44 * z421 + c_pitch * z530);
        const double z532 = z398 * z46 - c_roll * (z394 * k7) + (z393 * z47 - e2z * (z43 * z421 - c_pitch *
            z529 + (z44 * z423 - s_pitch * z530)));
        const double z533 = s_lam * z525 - c_lam * z524;
        const double z534 = c_lam * z525 + s_lam * z524;
        const double z535 = z436 + c_steer * z534 - (z434 - s_steer * z521);
        const double z536 = c_lam * z533 - s_lam * z535;
        const double z537 = c_lam * z535 + s_lam * z533;
        const double z538 = z51 * z536 + h3y * z487 - (z53 * z537 + h1y * z492);
        const double z539 = c_steer * z521 + e2y * z396 + (z49 * z394 - s_steer * z534);
        const double z540 = z51 * z539 + h2y * z487;
        const double z541 = z53 * z539 + h2y * z492;
        const double z542 = s_lam * z540 + c_lam * z541;
        const double z543 = z394 * z54 - s_steer * z538 + (z396 * z59 + c_steer * z542);
        const double z544 = c_lam * z540 - s_lam * z541;
        const double z545 = z45 * z520 + c_yaw * z531 + (z48 * z522 + s_yaw * z532) - (z62 * z463 - e3z *
            (s_lam * z543 + c_lam * z544));
        const double z546 = z545 + (z393 * z63 - e2z * (z396 * z54 + c_steer * z538 - (z394 * z59 - s_steer *
            z542)));
        const double z547 = z546 - (z64 * z464 - z2 * (c_lam * z543 - s_lam * z544));
        const double z548 = (z527 - z547) / (z66 * z66);
        const double z549 = z491 - (z396 * z408 - c_steer * z519);
        const double z550 = z409 * z487 - z51 * z549;
        const double z551 = z495 + (z394 * z408 + s_steer * z519);
        const double z552 = z413 * z492 - z53 * (z494 + c_lam * z551) - (z414 * z487 - z51 * (z496 - s_lam *
            z551));
        const double z553 = z409 * z492 - z53 * z549;
        const double z554 = z394 * z521;
        const double z555 = z554 + e2y * z500;
        const double z556 = z398 * z520;
        const double z557 = z556 + c_yaw * z506;
        const double z558 = z396 * z534;
        const double z559 = z558 - z49 * z503;
        const double z560 = z393 * z520;
        const double z561 = z560 - c_yaw * z499;
        const double z562 = z421 * z523;
        const double z563 = z408 * z423 + s_pitch * z519;
        const double z564 = z562 + z38 * z563;
        const double z565 = z423 * z522;
        const double z566 = z408 * z421 - c_pitch * z519;
        const double z567 = z565 + s_yaw * z566;
        const double z568 = z437 * z421 - c_pitch * z561 + z564 - z567;
        const double z569 = z423 * z523;
        const double z570 = z569 - z38 * z566;
        const double z571 = z421 * z522;
        const double z572 = z571 - s_yaw * z563;
        const double z573 = z437 * z423 + s_pitch * z561 + z570 + z572;
        const double z574 = z555 + (z394 * z435 + s_steer * z557) - (z559 - (z396 * z444 + c_steer * (s_lam *
            z568 - c_lam * z573)));
        const double z575 = c_lam * z568 + s_lam * z573;
        const double z576 = r_F * (s_lam * z574 + c_lam * z575) + (c * (s_lam * z575 - c_lam * z574) - (r_R *
            z568 + k2 * z573));
        const double z577 = z410 * z536 + h3y * z550 + (z415 * z539 + h2y * z552 - (z416 * z537 + h1y * z553
            - z576));
        const double z578 = z408 * z514 - z36 * z519;
        const double z579 = z408 * z513 - R3 * z519;
        const double z580 = z449 * z524 - e3y * z578 + (z404 * z521 + e2y * z515 - (z450 * z525 + e1y *
            z579));
        const double z581 = z451 * z548 - z91 * (z577 + z580);
        const double z582 = z91 * z526 + z40 * z548;
        const double z583 = z420 - e2z * z522;
        const double z584 = z424 + s_pitch * z520 - (z422 - c_pitch * z583);
        const double z585 = z427 - c_pitch * z520 + (z426 + s_pitch * z583);
        const double z586 = z36 * z584 - e3x * z514 - (R3 * z585 + e1x * z513);
        const double z587 = z418 + c_roll * z522;
        const double z588 = z74 * z463 + e3z * (z36 * z587 + z73 * z514) - (z393 * z72 + e2z * z586) - (z75 *
            z464 + z2 * (R3 * z587 + z73 * z513));
        const double z589 = s_lam * z585 - c_lam * z584;
        const double z590 = c_lam * z585 + s_lam * z584;
        const double z591 = z419 + c_steer * z590 + (z417 - s_steer * z587);
        const double z592 = c_lam * z589 - s_lam * z591;
        const double z593 = c_lam * z591 + s_lam * z589;
        const double z594 = z51 * z592 + h3x * z487 - (z53 * z593 + h1x * z492);
        const double z595 = c_steer * z587 + z73 * z396 + (s_steer * z590 - z76 * z394);
        const double z596 = z51 * z595 + z80 * z487;
        const double z597 = z53 * z595 + z80 * z492;
        const double z598 = s_lam * z596 + c_lam * z597;
        const double z599 = z394 * z77 - s_steer * z594 - (z396 * z83 + c_steer * z598);
        const double z600 = c_lam * z596 - s_lam * z597;
        const double z601 = z48 * z520 - c_yaw * z532 - (z45 * z522 - s_yaw * z531) + (z86 * z463 - e3z *
            (s_lam * z599 - c_lam * z600));
        const double z602 = z601 - (z393 * z87 - e2z * (z396 * z77 + c_steer * z594 + (z394 * z83 - s_steer *
            z598)));
        const double z603 = z602 + (z88 * z464 - z2 * (c_lam * z599 + s_lam * z600));
        const double z604 = z588 - z603;
        const double z605 = z394 * z587;
        const double z606 = z605 + z73 * z500;
        const double z607 = z398 * z522;
        const double z608 = z607 - s_yaw * z506;
        const double z609 = z396 * z590;
        const double z610 = z609 - z76 * z503;
        const double z611 = z393 * z522;
        const double z612 = z611 + s_yaw * z499;
        const double z613 = z421 * z583;
        const double z614 = z613 + z71 * z563;
        const double z615 = z423 * z520;
        const double z616 = z615 - c_yaw * z566;
        const double z617 = z420 * z421 + c_pitch * z612 + z614 - z616;
        const double z618 = z423 * z583;
        const double z619 = z618 - z71 * z566;
        const double z620 = z421 * z520;
        const double z621 = z620 + c_yaw * z563;
        const double z622 = z420 * z423 - s_pitch * z612 + z619 + z621;
        const double z623 = z606 + (z418 * z394 - s_steer * z608) + (z610 + (z396 * z429 + c_steer * (s_lam *
            z617 - c_lam * z622)));
        const double z624 = c_lam * z617 + s_lam * z622;
        const double z625 = r_F * (s_lam * z623 + c_lam * z624) + (c * (s_lam * z624 - c_lam * z623) - (r_R *
            z617 + k2 * z622));
        const double z626 = z410 * z592 + h3x * z550 - (z415 * z595 + z80 * z552 + (z416 * z593 + h1x * z553
            + z625));
        const double z627 = z449 * z584 - e3x * z578 - (z404 * z587 + z73 * z515 + (z450 * z585 + e1x *
            z579));
        const double z628 = z453 * ((z586 - (z92 * z604 - z90 * z582)) / (z93 * z93)) + z142 * (z626 + z627 +
            (z452 * z604 - z90 * z581));
        const double z629 = z581 - (z454 * z582 - z92 * z628);
        const double z630 = z519 - (z393 * z455 + e2z * z629);
        const double z631 = z489 + (z455 * z464 - z2 * z629);
        const double z632 = z488 + (z455 * z463 - e3z * z629);
        const double z633 = c_lam * z631 + s_lam * z632;
        const double z634 = z396 * w2 - c_steer * z630 + (z394 * z456 - s_steer * z633);
        const double z635 = F_yy * z634;
        const double z636 = z509 + (z508 + c_roll * z566);
        const double z637 = z507 + (z505 - c_roll * z563);
        const double z638 = z516 + k2 * z636 + r_R * z637;
        const double z639 = z501 - (z504 + (z502 - c_steer * (c_lam * z636 - s_lam * z637)));
        const double z640 = s_lam * z636 + c_lam * z637;
        const double z641 = c_lam * z639 + s_lam * z640;
        const double z642 = c_lam * z640 - s_lam * z639;
        const double z643 = m_F * (z638 - c * z641 - r_F * z642);
        const double z644 = z577 + (z452 * z547 + z65 * z581) - (z454 * (z92 * z547 + z65 * z582) - z145 *
            z628);
        const double z645 = z455 * z520 + c_yaw * z629;
        const double z646 = z455 * z522 - s_yaw * z629;
        const double z647 = z561 + (z560 - e2z * z646);
        const double z648 = z572 + (z571 - c_pitch * z645) + (z570 + (z569 + s_pitch * z647));
        const double z649 = z567 + (z565 + s_pitch * z645) - (z564 + (z562 - c_pitch * z647));
        const double z650 = z644 + k2 * z648 - r_R * z649;
        const double z651 = z559 + (z558 + c_steer * (c_lam * z648 + s_lam * z649)) - (z555 + (z554 + s_steer
            * (z557 + (z556 + c_roll * z646))));
        const double z652 = s_lam * z648 - c_lam * z649;
        const double z653 = c_lam * z651 + s_lam * z652;
        const double z654 = c_lam * z652 - s_lam * z651;
        const double z655 = m_F * (z650 - c * z653 - r_F * z654);
        const double z656 = z626 - (z452 * z603 + z89 * z581) + (z454 * (z92 * z603 + z89 * z582) - z141 *
            z628);
        const double z657 = z612 + (z611 + e2z * z645);
        const double z658 = z621 + (z620 + c_pitch * z646) + (z619 + (z618 - s_pitch * z657));
        const double z659 = z616 + (z615 - s_pitch * z646) - (z614 + (z613 + c_pitch * z657));
        const double z660 = z656 - k2 * z658 + r_R * z659;
        const double z661 = z610 + (z609 - c_steer * (c_lam * z658 + s_lam * z659)) + (z606 + (z605 - s_steer
            * (z608 + (z607 - c_roll * z645))));
        const double z662 = s_lam * z658 - c_lam * z659;
        const double z663 = c_lam * z661 - s_lam * z662;
        const double z664 = c_lam * z662 + s_lam * z661;
        const double z665 = m_F * (z660 - c * z663 + r_F * z664);
        const double z666 = m_H * (z638 - k3 * z641 + z_H * z642);
        const double z667 = m_H * (z650 - k3 * z653 + z_H * z654);
        const double z668 = m_H * (z660 - k3 * z663 - z_H * z664);
        const double z669 = m_B * (z516 + x_B * z636 + k1 * z637);
        const double z670 = m_B * (z644 + x_B * z648 - k1 * z649);
        const double z671 = m_B * (z656 - x_B * z658 + k1 * z659);
        const double z672 = R_yy * (z454 + w2);
        const double z673 = z393 * z148 + c_roll * z455;
        const double z674 = R_yy * (z628 - z630);
        const double wf = c_steer * z456 + s_steer * w2;
        const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
        const double o1 = c_lam * wf + s_lam * ws;
        const double o3 = c_lam * ws - s_lam * wf;
        const double z675 = H_xz * o1 + 2.0 * (k20 * o3);
        const double z676 = s_lam * c_steer;
        const double z677 = s_lam * z676 + k19;
        const double z678 = s_lam * z469;
        const double z679 = c_lam * (s_lam - z676);
        const double z680 = c_lam * z469;
        const double z681 = z677 * z463 + e3z * z678 + (z393 * z458 + e2z * z459) - (z679 * z464 - z2 * z680);
        const double z682 = z110 * z459 + (z423 * z677 - s_pitch * z678 - (z421 * z679 - c_pitch * z680) -
            z148 * z681);
        const double z683 = z455 * (z677 * z173 + c_roll * z458 - z679 * z172) - roll_dot * (z118 * z677 -
            z116 * z679);
        const double z684 = z396 * z456 + c_steer * z633 - (z394 * w2 + s_steer * z630);
        const double z685 = s_lam * z631 - c_lam * z632;
        const double z686 = c_lam * z684 + s_lam * z685;
        const double z687 = c_lam * z685 - s_lam * z684;
        const double z688 = H_xz * z686 + 2.0 * (k20 * z687);
        const double z689 = H_yy * o2;
        const double z690 = H_yy * z634;
        const double z691 = H_xz * o3 + 2.0 * (k21 * o1);
        const double z692 = c_lam * c_steer;
        const double z693 = s_lam * (c_lam - z692);
        const double z694 = s_lam * z479;
        const double z695 = c_lam * z692 + k18;
        const double z696 = c_lam * z479;
        const double z697 = z693 * z463 - e3z * z694 - (z393 * z460 + e2z * z461) - (z695 * z464 + z2 * z696);
        const double z698 = z110 * z461 - (z423 * z693 + s_pitch * z694 - (z421 * z695 + c_pitch * z696) -
            z148 * z697);
        const double z699 = z455 * (z693 * z173 - c_roll * z460 - z695 * z172) - roll_dot * (z118 * z693 -
            z116 * z695);
        const double z700 = 2.0 * (k21 * z686) + H_xz * z687;
        const double z701 = B_xz * w1 + 2.0 * (k23 * w3);
        const double z702 = B_xz * z631 - 2.0 * (k23 * z632);
        const double z703 = B_yy * w2;
        const double z704 = B_yy * z630;
        const double z705 = B_xz * w3 + 2.0 * (k22 * w1);
        const double z706 = 2.0 * (k22 * z631) - B_xz * z632;
        const double z707 = m_R * z656;
        const double z708 = m_R * z644;
        const double z709 = z705 * (z421 - z148 * z464 - (z455 * z172 - roll_dot * z116)) + (z149 * z706 -
            (z107 * (m_R * z516) + (z144 * z707 + z146 * z708)));
        const double z710 = z701 * (z423 - z148 * z463 - (z455 * z173 - roll_dot * z118)) - (z150 * z702 -
            (z703 * z673 - (z152 * z704 + z709)));
        const double z711 = z157 * z688 - (z689 * z468 + (z159 * z690 - (z691 * (z698 + z699) + (z156 * z700
            - z710))));
        const double z712 = z171 * z670 + (z167 * z671 + (z672 * z673 + (z160 * z674 + (z675 * (z682 - z683)
            - z711))));
        const double z713 = z197 * z655 + (z196 * z665 + (z194 * z666 + (z188 * z667 + (z181 * z668 + (z174 *
            z669 + z712)))));
        const double z714 = z457 * z468 + (z159 * z635 + (z199 * z643 + z713)) - g * (z200 + (z195 + (z147 +
            z175)));
        const double z715 = z455 * (z5 - (z458 * z270 + e3z * z676) + (z460 * z269 - z2 * z692)) - roll_dot *
            (z210 * z458 - s_pitch * z676 + (z208 * z460 + c_pitch * z692));
        const double z716 = z238 * z465 + z396 * z202 + (z411 - z715);
        const double z717 = z393 * z238;
        const double z718 = s_lam * z458;
        const double z719 = c_lam * z458;
        const double z720 = z455 * (z677 * z270 - e3z * z718 - e2z * z676 + (z679 * z269 - z2 * z719)) +
            roll_dot * (z210 * z677 + s_pitch * z718 - (z208 * z679 + c_pitch * z719));
        const double z721 = s_lam * z460;
        const double z722 = c_lam * z460;
        const double z723 = z455 * (z693 * z270 + e3z * z721 + e2z * z692 + (z695 * z269 + z2 * z722)) +
            roll_dot * (z210 * z693 - s_pitch * z721 - (z208 * z695 - c_pitch * z722));
        const double z724 = z705 * (z238 * z464 + (z455 * z269 - roll_dot * z208)) + (z239 * z706 + (z234 *
            z707 + z236 * z708));
        const double z725 = z701 * (z238 * z463 - (z455 * z270 + roll_dot * z210)) + (z240 * z702 - (z703 *
            z717 - (z242 * z704 - z724)));
        const double z726 = z252 * z690 - (z691 * (z238 * z697 + z202 * z461 + (z408 * z692 - z723)) - (z248
            * z700 - z725));
        const double z727 = z675 * (z238 * z681 - z202 * z459 - (z408 * z676 + z720)) + (z249 * z688 - (z689
            * z716 + z726));
        const double z728 = z279 * z668 + (z271 * z669 + (z267 * z670 + (z262 * z671 + (z672 * z717 + (z255 *
            z674 - z727)))));
        const double z729 = z252 * z635 + (z299 * z643 + (z297 * z655 + (z295 * z665 + (z293 * z666 + (z286 *
            z667 + z728)))));
        const double z730 = z457 * z716 + z729 - g * (z300 + (z272 + z294)) - z714 * z309;
        const double z731 = z317 * z465;
        const double z732 = z393 * z317;
        const double z733 = z703 * z732 + (z321 * z704 + (z705 * (z317 * z464) + (z318 * z706 + (z313 * z707
            + z315 * z708))));
        const double z734 = z331 * z690 + (z691 * (z317 * z697) - (z327 * z700 - (z701 * (z317 * z463) +
            (z319 * z702 - z733))));
        const double z735 = z672 * z732 + (z334 * z674 - (z675 * (z317 * z681) - (z328 * z688 + (z689 * z731
            - z734))));
        const double z736 = z365 * z655 + (z363 * z665 + (z361 * z667 + (z353 * z668 + (z346 * z670 + (z341 *
            z671 + z735)))));
        const double z737 = (z457 * z731 + (z367 * z635 + z736) - z714 * z373 - z378 * z730) / z379;
        const double z738 = z377 * z730 - z378 * z737;
        /* (I.2.15) */
        const double slope1 = z141 * z454 - (z433 + z89 * z452); /* x' */
        dydt[i] = slope1;
        bad |= !(fabs(slope1) <= DBL_MAX);
        const double slope2 = -(z448 - z65 * z452 + z145 * z454); /* y' */
        dydt[count + i] = slope2;
        bad |= !(fabs(slope2) <= DBL_MAX);
        const double slope3 = z405; /* z' */
        dydt[2 * count + i] = slope3;
        bad |= !(fabs(slope3) <= DBL_MAX);
        const double slope4 = -z455; /* yaw' */
        dydt[3 * count + i] = slope4;
        bad |= !(fabs(slope4) <= DBL_MAX);
        const double slope5 = roll_dot; /* roll' */
        dydt[4 * count + i] = slope5;
        bad |= !(fabs(slope5) <= DBL_MAX);
        const double slope6 = z408; /* pitch' */
        dydt[5 * count + i] = slope6;
        bad |= !(fabs(slope6) <= DBL_MAX);
        const double slope7 = steer_dot; /* steer' */
        dydt[6 * count + i] = slope7;
        bad |= !(fabs(slope7) <= DBL_MAX);
        const double slope8 = z454; /* thR' */
        dydt[7 * count + i] = slope8;
        bad |= !(fabs(slope8) <= DBL_MAX);
        const double slope9 = thF_dot; /* thF' */
        dydt[8 * count + i] = slope9;
        bad |= !(fabs(slope9) <= DBL_MAX);
        /* (I.2.15) 112:4 */
        const double slope10 = z373 * z737 - (z714 * z308 - z309 * z738); /* roll'' */
        dydt[9 * count + i] = slope10;
        bad |= !(fabs(slope10) <= DBL_MAX);
        const double slope11 = -z738; /* steer'' */
        dydt[10 * count + i] = slope11;
        bad |= !(fabs(slope11) <= DBL_MAX);
        const double slope12 = z737; /* thF'' */
        dydt[11 * count + i] = slope12;
        bad |= !(fabs(slope12) <= DBL_MAX);
    }
    if (singular1) {
        return BICYCLE_SINGULAR_1;
    }
    if (singular2) {
        return BICYCLE_SINGULAR_2;
    }
    return bad ? BICYCLE_NOT_FINITE : BICYCLE_OK;
}
