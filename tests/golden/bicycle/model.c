/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:23e8f5ded783352c)
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
#include <string.h>

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

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef BICYCLE_LANES
#if !defined(__GNUC__)
#define BICYCLE_LANES 1
#elif defined(__AVX512F__)
#define BICYCLE_LANES 8
#elif defined(__AVX__)
#define BICYCLE_LANES 4
#else
#define BICYCLE_LANES 2
#endif
#endif
#if BICYCLE_LANES > 1
typedef double bicycle_lanes __attribute__((vector_size(8 * BICYCLE_LANES)));
#else
typedef double bicycle_lanes;
#endif

static inline bicycle_lanes bicycle_get(const double *from)
{
    bicycle_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void bicycle_put(double *to, bicycle_lanes value)
{
    memcpy(to, &value, sizeof value);
}

/* the seeds of the passes from first on: in each lane the seed of its pass is 1 */
static void bicycle_unit(int size, int first, double *seed)
{
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < BICYCLE_LANES; ++k) {
            seed[i * BICYCLE_LANES + k] = i == first + k ? 1.0 : 0.0;
        }
    }
}

/* the results of the passes, each to its own entries of the output */
static void bicycle_place(int passes, const int *offset, int count, const int *entry, const double *slope, double *out)
{
    for (int k = 0; k < passes && k < BICYCLE_LANES; ++k) {
        for (int i = 0; i < count; ++i) {
            out[offset[k] + entry[i]] = slope[i * BICYCLE_LANES + k];
        }
    }
}

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int bicycle_one_by_one(size_t count, size_t first, size_t number, const double *t, const double *y, const double *p, double *dydt)
{
    int status = BICYCLE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[BICYCLE_NY];
        double slope[BICYCLE_NY];
        for (size_t k = 0; k < BICYCLE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = NAN;
        }
        const int one = bicycle_rhs(t[i], state, p, slope);
        status = status == BICYCLE_OK ? one : status;
        for (size_t k = 0; k < BICYCLE_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if BICYCLE_LANES >= 4
#define BICYCLE_SPREAD(x) ((x) - (bicycle_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long bicycle_bits __attribute__((vector_size(8 * BICYCLE_LANES)));

/* all bits where value is not above bound, or is no number */
static inline bicycle_bits bicycle_misses(bicycle_lanes value, bicycle_lanes bound)
{
    return ~(bicycle_bits)(value > bound);
}

/* no number where a bit is set */
static inline bicycle_lanes bicycle_mark(bicycle_lanes value, bicycle_bits bad)
{
    return (bicycle_lanes)((bicycle_bits)value | bad);
}

static inline bicycle_lanes bicycle_size(bicycle_lanes x)
{
    return (bicycle_lanes)((bicycle_bits)x & 0x7fffffffffffffffULL);
}
/* whether none of the states must be asked again: no singular block, no infinity, no angle anywhere near 1e5 */
static inline int bicycle_is_good(int count, const double *check)
{
    double even = 0.0;
    double odd = 0.0;
    for (int k = 0; k < count; k += 2) {
        even += check[k];
        odd += check[k + 1];
    }
    return even + odd <= 1e10;
}

/* the last states, fewer than there are lanes; the others repeat the last one */
static inline void bicycle_fill(size_t left, size_t count, const double *t, const double *y, double *time, double *state)
{
    for (size_t l = 0; l < BICYCLE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < BICYCLE_NY; ++k) {
            state[k * BICYCLE_LANES + l] = y[k * count + i];
        }
    }
}

static inline void bicycle_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < BICYCLE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * BICYCLE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void bicycle_turn_lanes(bicycle_lanes x, bicycle_lanes *far, bicycle_lanes *sine, bicycle_lanes *cosine)
{
    double angle[BICYCLE_LANES];
    double up[BICYCLE_LANES];
    double along[BICYCLE_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < BICYCLE_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}

static inline bicycle_lanes bicycle_each_sqrt(bicycle_lanes a)
{
    double value[BICYCLE_LANES];
    memcpy(value, &a, sizeof a);
    for (int l = 0; l < BICYCLE_LANES; ++l) {
        value[l] = sqrt(value[l]);
    }
    memcpy(&a, value, sizeof a);
    return a;
}
#endif

int bicycle_rhs(double t, const double *y, const double *p, double *dydt)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
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
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = H_zz + F_xx;
    const double k5 = H_xx + F_xx;
    const double k6 = z_H * s_lam - c_lam * (x_H - k2);
    const double k7 = x_H * s_lam + c_lam * (r_R + z_H);
    const double k8 = c_lam * k2 - r_R * s_lam;
    const double k9 = s_lam * k8;
    const double k10 = c_lam * k8;
    const double k11 = c_lam * c_lam;
    const double k12 = w * s_lam + c_lam * (r_R - r_F);
    const double k13 = s_lam * k3 - c_lam * k12;
    const double k14 = s_lam * s_lam;
    const double k15 = c_lam * k3 + s_lam * k12;
    const double k16 = fabs(r_R);
    const double k17 = fabs(r_F);
    const double k18 = fabs(w);
    const double k19 = fabs(c);
    const double k20 = 18.0 * k19 + (18.0 * k18 + (34.0 * k16 + 19.0 * k17));
    const double k21 = m_R + m_B;
    const double k22 = m_B * k1;
    const double k23 = x_B * m_B;
    const double k24 = k1 * k22;
    const double k25 = R_xx + B_xx + k24;
    const double k26 = x_B * k23;
    const double k27 = k24 + (B_yy + k26);
    const double k28 = B_xz - k1 * k23;
    const double k29 = R_xx + B_zz + k26;
    const double k30 = m_F * k12;
    const double k31 = m_H + m_F;
    const double k32 = m_H * k7;
    const double k33 = k30 + k32;
    const double k34 = m_F * k3;
    const double k35 = m_H * k6;
    const double k36 = k34 - k35;
    const double k37 = H_xz * c_lam;
    const double k38 = s_lam * k4 - k37;
    const double k39 = H_xz * s_lam;
    const double k40 = c_lam * k5 - k39;
    const double k41 = k12 * k30;
    const double k42 = k7 * k32;
    const double k43 = c_lam * k40 + s_lam * k38 + k41 + k42;
    const double k44 = s_lam * k40 - c_lam * k38 - k3 * k30 + k6 * k32;
    const double k45 = k3 * k34;
    const double k46 = k6 * k35;
    const double k47 = k42 + (k41 + (H_yy + k45) + k46);
    const double k48 = k39 + c_lam * k4;
    const double k49 = k37 + s_lam * k5;
    const double k50 = c_lam * k49 - s_lam * k48 - k12 * k34 + k7 * k35;
    const double k51 = k46 + (k45 + (s_lam * k49 + c_lam * k48));
    const double k52 = g * m_F;
    const double k53 = g * m_H;
    const double k54 = g * m_B;
    const double k55 = g * k21;
    const double k56 = x_B * k54;
    const double k57 = k1 * k54;
    const double k58 = k6 * k53;
    const double k59 = k7 * k53;
    const double k60 = g * k31;
    const double k61 = k3 * k52;
    const double k62 = k12 * k52;
    const double k63 = k59 + k62;
    const double k64 = k58 - k61;

    /* state */
    const double z1 = s_lam * s_steer;
    const double e3z = c_pitch * c_roll;
    const double z2 = r_R * e3z;
    const double z3 = s_pitch * c_roll;
    const double z4 = z3 * z3 + e3z * e3z;
    const double z5 = 1.0 / sqrt(z4);
    const double R3 = z2 * z5;
    const double z6 = R3 + k9;
    const double z7 = z3 * c_lam + e3z * s_lam;
    const double z8 = c_steer * z7 - e2z * s_steer;
    const double z9 = z3 * s_lam - e3z * c_lam;
    const double z10 = c_lam * z8 + s_lam * z9;
    const double z11 = r_F * z10;
    const double z12 = c_lam * z9 - s_lam * z8;
    const double z13 = z10 * z10 + z12 * z12;
    const double z14 = 1.0 / sqrt(z13);
    const double z15 = z11 * z14;
    const double z16 = z15 - k15;
    const double z17 = s_steer * z16;
    const double z18 = z1 * z6 + c_lam * z17;
    const double z19 = r_R * z3;
    const double z20 = z19 * z5;
    const double z21 = z20 + k10;
    const double z22 = z1 * z21 - s_lam * z17;
    const double z23 = s_pitch * z18 - c_pitch * z22;
    const double z24 = s_lam * c_steer;
    const double z25 = k11 + s_lam * z24;
    const double z26 = c_lam * (s_lam - z24);
    const double z27 = z20 * z25 + R3 * z26;
    const double z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16;
    const double z29 = c_roll * z23 - e2z * z28;
    const double z30 = c_lam * c_steer;
    const double z31 = s_lam * (c_lam - z30);
    const double z32 = c_lam * z30 + k14;
    const double z33 = z20 * z31 + R3 * z32;
    const double z34 = c_lam * s_steer;
    const double z35 = R3 * z34 - z20 * z1;
    const double z36 = r_F * z12;
    const double z37 = z36 * z14;
    const double z38 = k12 - c_lam * z37 - s_lam * z15;
    const double z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38;
    const double z40 = z37 + k13;
    const double z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40;
    const double z42 = z33 * z39 - z41 * z35;
    const double z43 = c_steer * z38;
    const double z44 = s_lam * z37;
    const double z45 = c_lam * z15;
    const double z46 = k3 + z44 - z45;
    const double z47 = c_steer * z6 - c_lam * z43 + s_lam * z46;
    const double z48 = c_steer * z21 + s_lam * z43 + c_lam * z46;
    const double z49 = s_pitch * z47 - c_pitch * z48;
    const double z50 = c_roll * z49 - e2z * z39;
    const double z51 = s_steer * z40;
    const double z52 = z34 * z6 + c_lam * z51;
    const double z53 = z34 * z21 - s_lam * z51;
    const double z54 = s_pitch * z52 - c_pitch * z53;
    const double z55 = c_roll * z54 + e2z * z41;
    const double z56 = z33 * z50 + z55 * z35;
    const double z57 = z41 * z50 + z55 * z39;
    const double z58 = z29 * z42 - z28 * z56 + z27 * z57;
    const double z59 = 1.0 / z58;
    const double z60 = s_pitch * s_lam - c_pitch * c_lam;
    const double z61 = s_steer * z60;
    const double z62 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20);
    const double z63 = k12 * z61 + s_steer * z62;
    const double z64 = k3 * z61;
    const double z65 = z15 * z61 - (s_lam * z63 + c_lam * z64);
    const double z66 = c_pitch * s_lam + s_pitch * c_lam;
    const double z67 = c_steer * z60;
    const double z68 = z37 * (s_lam * z66 - c_lam * z67) - z15 * (s_lam * z67 + c_lam * z66) + (k12 * z67 +
        k3 * z66 + c_steer * z62);
    const double z69 = z37 * z61 + (s_lam * z64 - c_lam * z63);
    const double z70 = z33 * z68 - z35 * z69;
    const double z71 = z41 * z68 - z39 * z69;
    const double z72 = z59 * (z42 * z65 + z28 * z70 - z27 * z71);
    const double z73 = c_roll * z72;
    const double z74 = s_pitch - c_pitch * z73;
    const double z75 = c_pitch + s_pitch * z73;
    const double z76 = c_lam * z74 + s_lam * z75;
    const double z77 = R3 * z75 + z20 * z74;
    const double z78 = z77 + (k10 * z74 + k9 * z75);
    const double z79 = z50 * z69 + z55 * z68;
    const double z80 = z59 * (z29 * z70 + z56 * z65 + z27 * z79) + e2z * z72;
    const double z81 = z59 * (z29 * z71 + z28 * z79 + z57 * z65) - z80;
    const double z82 = R3 * z81;
    const double z83 = z82 - k9 * z80;
    const double z84 = z20 * z81;
    const double z85 = z84 - k10 * z80;
    const double z86 = c_lam * z83 - s_lam * z85;
    const double z87 = c_steer * z78 + s_steer * z86;
    const double z88 = c_lam * z75 - s_lam * z74;
    const double z89 = s_steer * z80 - c_steer * z88;
    const double z90 = k51 * z76 + (k36 * z87 - k50 * z89);
    const double z91 = c_steer * z80 + s_steer * z88;
    const double z92 = c_steer * z86 - s_steer * z78;
    const double z93 = c_lam * z85 + s_lam * z83;
    const double z94 = k47 * z91 + (k33 * z92 - k36 * z93);
    const double z95 = k44 * z76 - (k33 * z87 + k43 * z89);
    const double z96 = k31 * z93 - k36 * z91;
    const double z97 = k36 * z76 + (k31 * z87 + k33 * z89);
    const double z98 = k31 * z92 + k33 * z91;
    const double z99 = z74 * k29 + (z77 * k23 + z75 * k28);
    const double z100 = z80 * k27 + (z82 * k22 - z84 * k23);
    const double z101 = z74 * k28 - (z77 * k22 - z75 * k25);
    const double z102 = z84 * k21 - z80 * k23;
    const double z103 = z82 * k21 + z80 * k22;
    const double z104 = z74 * k23 + (z77 * k21 - z75 * k22);
    const double z105 = z74 * z99 + (z80 * z100 + (z75 * z101 + (z84 * z102 + (z82 * z103 + z77 * z104))));
    const double z106 = z76 * z90 + (z91 * z94 - (z89 * z95 - (z93 * z96 + (z87 * z97 + (z92 * z98 +
        z105)))));
    const double z107 = z106 + R_yy * (z81 * z81) + F_yy * (z91 * z91);
    const double z108 = k3 + (z44 - z45);
    const double z109 = z33 * z108;
    const double z110 = z41 * z108;
    const double z111 = z59 * (z28 * z109 - z27 * z110);
    const double z112 = c_roll * z111;
    const double z113 = c_pitch * z112;
    const double z114 = s_pitch * z112;
    const double z115 = 1.0 - (c_lam * z113 - s_lam * z114);
    const double z116 = R3 * z114 - z20 * z113;
    const double z117 = z116 - (k10 * z113 - k9 * z114);
    const double z118 = z55 * z108;
    const double z119 = z59 * (z29 * z109 + z27 * z118) + e2z * z111;
    const double z120 = z59 * (z29 * z110 + z28 * z118) - z119;
    const double z121 = R3 * z120;
    const double z122 = z121 - k9 * z119;
    const double z123 = z20 * z120;
    const double z124 = z123 - k10 * z119;
    const double z125 = c_lam * z122 - s_lam * z124;
    const double z126 = c_steer * z117 + s_steer * z125;
    const double z127 = c_lam * z114 + s_lam * z113;
    const double z128 = s_steer * z119 - c_steer * z127;
    const double z129 = k51 * z115 + (k36 * z126 - k50 * z128);
    const double z130 = c_steer * z119 + s_steer * z127;
    const double z131 = c_steer * z125 - s_steer * z117;
    const double z132 = c_lam * z124 + s_lam * z122;
    const double z133 = k47 * z130 + (k33 * z131 - k36 * z132);
    const double z134 = k44 * z115 - (k33 * z126 + k43 * z128);
    const double z135 = k31 * z132 - k36 * z130;
    const double z136 = k36 * z115 + (k31 * z126 + k33 * z128);
    const double z137 = k31 * z131 + k33 * z130;
    const double z138 = z113 * k29 - (z116 * k23 + z114 * k28);
    const double z139 = z119 * k27 + (z121 * k22 - z123 * k23);
    const double z140 = z113 * k28 + (z116 * k22 - z114 * k25);
    const double z141 = z123 * k21 - z119 * k23;
    const double z142 = z121 * k21 + z119 * k22;
    const double z143 = z113 * k23 - (z116 * k21 - z114 * k22);
    const double z144 = z113 * z138 + (z119 * z139 - (z114 * z140 - (z123 * z141 + (z121 * z142 - z116 *
        z143))));
    const double z145 = z115 * z129 + (z130 * z133 - (z128 * z134 - (z132 * z135 + (z126 * z136 + (z131 *
        z137 + z144)))));
    const double z146 = z145 + R_yy * (z120 * z120) + F_yy * (z130 * z130);
    const double z147 = z113 * z99 - (z119 * z100 + (z114 * z101 + (z123 * z102 + (z121 * z103 + z116 *
        z104))));
    const double z148 = z115 * z90 + (z130 * z94 - (z128 * z95 - (z132 * z96 + (z126 * z97 + (z131 * z98 -
        z147)))));
    const double z149 = R_yy * z81;
    const double z150 = F_yy * z91;
    const double z151 = z148 + z120 * z149 + z130 * z150;
    const double z152 = 1.0 / z107;
    const double z153 = z152 * z151;
    const double z154 = z146 - z151 * z153;
    const double z155 = z37 * z35;
    const double z156 = z37 * z39;
    const double z157 = z59 * (z15 * z42 - z28 * z155 + z27 * z156);
    const double z158 = c_roll * z157;
    const double z159 = c_pitch * z158;
    const double z160 = s_pitch * z158;
    const double z161 = c_lam * z159 - s_lam * z160;
    const double z162 = R3 * z160 - z20 * z159;
    const double z163 = z162 - (k10 * z159 - k9 * z160);
    const double z164 = z37 * z50;
    const double z165 = z59 * (z29 * z155 - z15 * z56 - z27 * z164) - e2z * z157;
    const double z166 = z59 * (z29 * z156 - z28 * z164 - z15 * z57) - z165;
    const double z167 = R3 * z166;
    const double z168 = z167 - k9 * z165;
    const double z169 = z20 * z166;
    const double z170 = z169 - k10 * z165;
    const double z171 = c_lam * z168 - s_lam * z170;
    const double z172 = c_steer * z163 - s_steer * z171;
    const double z173 = c_lam * z160 + s_lam * z159;
    const double z174 = s_steer * z165 + c_steer * z173;
    const double z175 = c_steer * z165 - s_steer * z173;
    const double z176 = c_steer * z171 + s_steer * z163;
    const double z177 = c_lam * z170 + s_lam * z168;
    const double z178 = z167 * (z167 * k21 + z165 * k22) - z162 * (z159 * k23 - (z162 * k21 - z160 * k22));
    const double z179 = z160 * (z159 * k28 + (z162 * k22 - z160 * k25)) - (z169 * (z169 * k21 - z165 * k23) +
        z178);
    const double z180 = z159 * (z159 * k29 - (z162 * k23 + z160 * k28)) + (z165 * (z165 * k27 + (z167 * k22 -
        z169 * k23)) - z179);
    const double z181 = z172 * (k36 * z161 - (k31 * z172 - k33 * z174)) - (z176 * (k31 * z176 + k33 * z175) +
        z180);
    const double z182 = z174 * (k44 * z161 + (k33 * z172 - k43 * z174)) - (z177 * (k31 * z177 - k36 * z175) -
        z181);
    const double z183 = z161 * (k51 * z161 - (k36 * z172 + k50 * z174)) + (z175 * (k47 * z175 + (k33 * z176 -
        k36 * z177)) - z182);
    const double z184 = 1.0 + z175;
    const double z185 = z183 + R_yy * (z166 * z166) + F_yy * (z184 * z184);
    const double z186 = z159 * z99 + (z165 * z100 - (z160 * z101 - (z169 * z102 + (z167 * z103 - z162 *
        z104))));
    const double z187 = z161 * z90 + (z175 * z94 - (z174 * z95 - (z177 * z96 - (z172 * z97 - (z176 * z98 +
        z186)))));
    const double z188 = z187 + z166 * z149 + z184 * z150;
    const double z189 = z152 * z188;
    const double z190 = z159 * z138 - (z165 * z139 + (z160 * z140 + (z169 * z141 + (z167 * z142 + z162 *
        z143))));
    const double z191 = z161 * z129 + (z175 * z133 - (z174 * z134 - (z177 * z135 - (z172 * z136 - (z176 *
        z137 - z190)))));
    const double z192 = R_yy * z120;
    const double z193 = F_yy * z130;
    const double z194 = z191 + z166 * z192 + z184 * z193 - z151 * z189;
    const double z195 = 1.0 / z154;
    const double z196 = z194 * z195;
    const double z197 = z185 - z188 * z189 - z194 * z196;
    const double z198 = roll_dot * c_pitch;
    const double z199 = roll_dot * s_pitch;
    const double z200 = steer_dot + (s_lam * z198 + c_lam * z199);
    const double z201 = s_lam * z199 - c_lam * z198;
    const double z202 = c_steer * z201;
    const double z203 = s_lam * z200 - c_lam * z202;
    const double z204 = s_lam * z202 + c_lam * z200;
    const double z205 = z198 * k9 + z199 * k10 + (z198 * R3 + z199 * z20);
    const double z206 = z37 * z203 - z15 * z204 + (k12 * z202 + k3 * z200 + c_steer * z205);
    const double z207 = s_steer * z201;
    const double z208 = thF_dot + z207;
    const double z209 = k3 * z207;
    const double z210 = k12 * z207 + s_steer * z205;
    const double z211 = z37 * z208 + (s_lam * z209 - c_lam * z210);
    const double z212 = z41 * z206 - z39 * z211;
    const double z213 = z50 * z211 + z55 * z206;
    const double z214 = z15 * z208 - (s_lam * z210 + c_lam * z209);
    const double z215 = z59 * (z29 * z212 + z28 * z213 + z57 * z214);
    const double z216 = z33 * z206 - z35 * z211;
    const double z217 = z59 * (z29 * z216 + z56 * z214 + z27 * z213);
    const double z218 = z59 * (z42 * z214 + z28 * z216 - z27 * z212);
    const double z219 = z217 + e2z * z218;
    const double z220 = z215 - z219;
    const double a3 = z20 * z220;
    const double a1 = R3 * z220;
    const double z221 = s_pitch * a3 + c_pitch * a1;
    const double z222 = s_pitch * a1 - c_pitch * a3;
    const double z223 = c_roll * z218;
    const double w1_pitch = z198 + s_pitch * z223;
    const double w3_pitch = z199 - c_pitch * z223;
    const double v2_x = R3 * w1_pitch + z20 * w3_pitch;
    const double z224 = e2z * z222 - c_roll * v2_x;
    /* (I.2.15) */
    dydt[0] = s_yaw * z224 - c_yaw * z221; /* x' */
    dydt[1] = -(s_yaw * z221 + c_yaw * z224); /* y' */
    dydt[2] = c_roll * z222 + e2z * v2_x; /* z' */
    dydt[3] = -z218; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = -z217; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = z215; /* thR' */
    dydt[8] = thF_dot; /* thF' */
    const double z225 = R_yy * z220;
    const double h2z = e2z * c_steer + s_steer * z7;
    const double z226 = c_lam * w1_pitch - s_lam * w3_pitch;
    const double z227 = s_steer * z219 - c_steer * z226;
    const double z228 = c_steer * z219 + s_steer * z226;
    const double z229 = F_yy * (thF_dot - z228) - k47 * z228;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    const double z230 = k43 * z227 - k44 * w3_steer;
    const double z231 = c_pitch * z217;
    const double z232 = roll_dot * z231;
    const double z233 = s_pitch * z217;
    const double z234 = roll_dot * e2z;
    const double z235 = steer_dot * c_steer;
    const double z236 = roll_dot * z233;
    const double z237 = s_lam * z232 + c_lam * z236;
    const double z238 = z235 * z201 - s_steer * z237;
    const double z239 = roll_dot * c_roll;
    const double z240 = steer_dot * s_steer;
    const double z241 = s_pitch * z234 + c_roll * z231;
    const double z242 = c_pitch * z234 - c_roll * z233;
    const double z243 = s_steer * z239 + e2z * z235 + (z7 * z240 + c_steer * (c_lam * z241 + s_lam * z242));
    const double z244 = s_lam * z241 - c_lam * z242;
    const double z245 = c_lam * z243 + s_lam * z244;
    const double z246 = r_F * z14;
    const double z247 = c_lam * z244 - s_lam * z243;
    const double z248 = (z10 * z245 + z12 * z247) * (z14 / z13);
    const double z249 = z245 * z246 - z11 * z248;
    const double z250 = k3 * z238;
    const double z251 = r_R * z5;
    const double z252 = (z3 * z241 + e3z * z242) * (z5 / z4);
    const double z253 = z251 * z242 - z2 * z252;
    const double z254 = z251 * z241 - z19 * z252;
    const double z255 = k9 * z236 - k10 * z232 + (R3 * z236 - z198 * z253 - (z20 * z232 + z199 * z254));
    const double z256 = k12 * z238 + (z235 * z205 + s_steer * z255);
    const double z257 = s_lam * z240;
    const double z258 = s_lam * z257;
    const double z259 = c_lam * z257;
    const double z260 = z20 * z258 + z25 * z254 - (R3 * z259 - z26 * z253);
    const double z261 = s_lam * z235;
    const double z262 = z235 * z16 - s_steer * z249;
    const double z263 = z1 * z254;
    const double z264 = z18 * z231 - s_pitch * (z6 * z261 - z1 * z253 + c_lam * z262) + (z22 * z233 + c_pitch
        * (z21 * z261 - z263 - s_lam * z262));
    const double z265 = k10 * z258 - k9 * z259 + z260 - (z240 * z16 + c_steer * z249);
    const double z266 = z215 * z260 + (z218 * (z234 * z23 + c_roll * z264 + (z239 * z28 - e2z * z265)) - z217
        * z265);
    const double z267 = z15 * z238 - z208 * z249 - (c_lam * z250 + s_lam * z256) + z266;
    const double z268 = s_lam * z236 - c_lam * z232;
    const double z269 = z240 * z201 + c_steer * z237;
    const double z270 = z247 * z246 - z36 * z248;
    const double z271 = z37 * (s_lam * z268 + c_lam * z269) - z203 * z270 + (z15 * (s_lam * z269 - c_lam *
        z268) + z204 * z249);
    const double z272 = c_lam * z235;
    const double z273 = z34 * z253;
    const double z274 = R3 * z272 - z273 - (z20 * z261 - z263);
    const double z275 = c_lam * z270 + s_lam * z249;
    const double z276 = z240 * z38 - c_steer * z275;
    const double z277 = s_lam * z270 - c_lam * z249;
    const double z278 = z47 * z231 + s_pitch * (z240 * z6 + c_steer * z253 - c_lam * z276 + s_lam * z277) +
        (z48 * z233 - c_pitch * (z240 * z21 + c_steer * z254 + s_lam * z276 + c_lam * z277));
    const double z279 = k9 * z272 - k10 * z261 + z274 - (z235 * z38 + s_steer * z275);
    const double z280 = z215 * z274 - (z218 * (z234 * z49 + c_roll * z278 + (z239 * z39 + e2z * z279)) + z217
        * z279);
    const double z281 = z271 - (k12 * z269 - k3 * z268 + (z240 * z205 - c_steer * z255)) + z280;
    const double z282 = c_lam * z240;
    const double z283 = s_lam * z282;
    const double z284 = c_lam * z282;
    const double z285 = z20 * z283 - z31 * z254 - (R3 * z284 + z32 * z253);
    const double z286 = z235 * z40 - s_steer * z270;
    const double z287 = z52 * z231 - s_pitch * (z6 * z272 - z273 + c_lam * z286) + (z53 * z233 + c_pitch *
        (z21 * z272 - z34 * z254 - s_lam * z286));
    const double z288 = k10 * z283 - k9 * z284 + z285 - (z240 * z40 + c_steer * z270);
    const double z289 = z215 * z285 + (z218 * (z234 * z54 + c_roll * z287 - (z239 * z41 + e2z * z288)) - z217
        * z288);
    const double z290 = z37 * z238 - z208 * z270 + (s_lam * z250 - c_lam * z256) + z289;
    const double z291 = z33 * z281 - z35 * z290;
    const double z292 = z41 * z281 - z39 * z290;
    const double z293 = z59 * (z42 * z267 + z28 * z291 - z27 * z292);
    const double z294 = z234 * z218 - c_roll * z293;
    const double z295 = z232 + (z223 * z233 - c_pitch * z294);
    const double z296 = z236 - (z223 * z231 + s_pitch * z294);
    const double z297 = c_lam * z295 - s_lam * z296;
    const double z298 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z253 - R3 * z296 + (w3_pitch * z254 + z20
        * z295));
    const double z299 = k9 * z219;
    const double z300 = k10 * z219;
    const double z301 = z298 - (w3_pitch * z299 - w1_pitch * z300 - (k10 * z295 - k9 * z296));
    const double z302 = z50 * z290 + z55 * z281;
    const double z303 = z59 * (z29 * z291 + z56 * z267 + z27 * z302) + (z239 * z218 + e2z * z293);
    const double z304 = z59 * (z29 * z292 + z28 * z302 + z57 * z267) - z303;
    const double z305 = z219 * a3 - w3_pitch * v2_x + (z220 * z253 - R3 * z304);
    const double z306 = k10 * w3_pitch + k9 * w1_pitch;
    const double z307 = z305 - (z219 * z300 + w3_pitch * z306 - k9 * z303);
    const double z308 = w1_pitch * v2_x - z219 * a1 + (z220 * z254 - z20 * z304);
    const double z309 = z308 + (w1_pitch * z306 + z219 * z299 + k10 * z303);
    const double z310 = c_lam * z307 - s_lam * z309;
    const double z311 = c_steer * z301 + s_steer * z310;
    const double z312 = c_lam * z296 + s_lam * z295;
    const double z313 = z235 * z219 + s_steer * z303 + (z240 * z226 - c_steer * z312);
    const double z314 = h2z * k64 - (z227 * z229 + z228 * z230 + (k51 * z297 + (k36 * z311 + k50 * z313)));
    const double z315 = k50 * z227 - k51 * w3_steer;
    const double z316 = z240 * z219 - c_steer * z303 - (z235 * z226 + s_steer * z312);
    const double z317 = c_steer * z310 - s_steer * z301;
    const double z318 = c_lam * z309 + s_lam * z307;
    const double z319 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) - (w3_steer * z230 + z227 * z315 - (k47 *
        z316 + (k33 * z317 - k36 * z318)));
    const double z320 = h2z * k63 + (z228 * z315 - w3_steer * z229 - (k44 * z297 - (k33 * z311 - k43 *
        z313)));
    const double z321 = k33 * z227 + k36 * w3_steer;
    const double z322 = k33 * z228;
    const double z323 = z9 * k60 - (z227 * z321 + z228 * z322 - (k31 * z318 - k36 * z316));
    const double z324 = k36 * z228;
    const double z325 = h2z * k60 + (w3_steer * z322 - z227 * z324 + (k36 * z297 + (k31 * z311 - k33 *
        z313)));
    const double z326 = z8 * k60 - (z228 * z324 + w3_steer * z321 - (k31 * z317 + k33 * z316));
    const double z327 = k27 * z219;
    const double z328 = k25 * w1_pitch + k28 * w3_pitch;
    const double z329 = e2z * k56 + (w1_pitch * z327 - z219 * z328 + (k29 * z295 + (k23 * z298 - k28 *
        z296)));
    const double z330 = k28 * w1_pitch + k29 * w3_pitch;
    const double z331 = z3 * k57 + e3z * k56 + (w3_pitch * z328 - w1_pitch * z330 - (k27 * z303 - (k22 * z305
        - k23 * z308)));
    const double z332 = e2z * k57 - (z219 * z330 - w3_pitch * z327 + (k28 * z295 - (k22 * z298 + k25 *
        z296)));
    const double z333 = k22 * w1_pitch - k23 * w3_pitch;
    const double z334 = k22 * z219;
    const double z335 = e3z * k55 + (w1_pitch * z333 + z219 * z334 - (k21 * z308 + k23 * z303));
    const double z336 = k23 * z219;
    const double z337 = z3 * k55 - (z219 * z336 - w3_pitch * z333 - (k21 * z305 - k22 * z303));
    const double z338 = e2z * k55 + (w3_pitch * z334 + w1_pitch * z336 + (k23 * z295 + (k21 * z298 + k22 *
        z296)));
    const double z339 = z74 * z329 + (z80 * z331 - (z75 * z332 + (z84 * z335 - (z82 * z337 + z77 * z338))));
    const double z340 = z76 * z314 - (z91 * z319 + (z89 * z320 + (z93 * z323 + (z87 * z325 + (z92 * z326 +
        z339)))));
    const double z341 = roll_dot * z225;
    const double z342 = z223 * z225 + z340 + z149 * z304 - z150 * z316 - z73 * z341;
    const double z343 = z113 * z329 - (z119 * z331 - (z114 * z332 + (z123 * z335 - (z121 * z337 + z116 *
        z338))));
    const double z344 = z115 * z314 - (z130 * z319 + (z128 * z320 + (z132 * z323 + (z126 * z325 + (z131 *
        z326 - z343)))));
    const double z345 = z344 + z192 * z304 - z193 * z316 - z112 * z341 - z342 * z153;
    const double z346 = z159 * z329 + (z165 * z331 + (z160 * z332 - (z169 * z335 - (z167 * z337 - z162 *
        z338))));
    const double z347 = z161 * z314 - (z175 * z319 + (z174 * z320 + (z177 * z323 - (z172 * z325 - (z176 *
        z326 + z346)))));
    const double z348 = z347 + R_yy * (z166 * z304) - F_yy * (z184 * z316) + z158 * z341 - z342 * z189 - z196
        * z345;
    const double z349 = z348 / z197;
    const double z350 = z195 * z345 - z196 * z349;
    /* (I.2.15) 112:4 */
    dydt[9] = z189 * z349 - (z152 * z342 - z153 * z350); /* roll'' */
    dydt[10] = -z350; /* steer'' */
    dydt[11] = z349; /* thF'' */
    /* the coframe is singular */
    if (!(fabs(z58) > 1e-12 * (k20 * (k20 * (13.0 * k19 + (14.0 * k18 + (24.0 * k16 + 33.0 * k17))))))) {
        return BICYCLE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(z107) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z154) > 1e-14 * z146)) {
        return BICYCLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z197) > 1e-14 * z185)) {
        return BICYCLE_SINGULAR_2;
    }
    return bicycle_finish(12, dydt);
}

int bicycle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
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
    const double k1 = r_F * s_lam - c * c_lam;
    const double k2 = c_lam * (w + c) - r_R * s_lam;
    const double k3 = s_lam * k2;
    const double k4 = c_lam * k2;
    const double k5 = c_lam * c_lam;
    const double k6 = w * s_lam + c_lam * (r_R - r_F);
    const double k7 = s_lam * k1 - c_lam * k6;
    const double k8 = s_lam * s_lam;
    const double k9 = c_lam * k1 + s_lam * k6;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(w);
    const double k13 = fabs(c);
    const double k14 = 18.0 * k13 + (18.0 * k12 + (34.0 * k10 + 19.0 * k11));

    /* state */
    const double z1 = s_lam * s_steer;
    const double e3z = c_pitch * c_roll;
    const double z2 = s_pitch * c_roll;
    const double z3 = r_R / sqrt(z2 * z2 + e3z * e3z);
    const double R3 = e3z * z3;
    const double z4 = k3 + R3;
    const double z5 = c_steer * (z2 * c_lam + e3z * s_lam) - e2z * s_steer;
    const double z6 = z2 * s_lam - e3z * c_lam;
    const double z7 = c_lam * z5 + s_lam * z6;
    const double z8 = c_lam * z6 - s_lam * z5;
    const double z9 = r_F / sqrt(z7 * z7 + z8 * z8);
    const double z10 = z7 * z9;
    const double z11 = k9 - z10;
    const double z12 = s_steer * z11;
    const double z13 = z2 * z3;
    const double z14 = k4 + z13;
    const double z15 = s_lam * c_steer;
    const double z16 = k5 + s_lam * z15;
    const double z17 = c_lam * (s_lam - z15);
    const double z18 = z16 * z13 + z17 * R3;
    const double z19 = k4 * z16 + k3 * z17 + z18 + c_steer * z11;
    const double z20 = c_roll * (s_pitch * (z1 * z4 - c_lam * z12) - c_pitch * (z1 * z14 + s_lam * z12)) -
        e2z * z19;
    const double z21 = c_lam * c_steer;
    const double z22 = s_lam * (c_lam - z21);
    const double z23 = c_lam * z21 + k8;
    const double z24 = z22 * z13 + z23 * R3;
    const double z25 = c_lam * s_steer;
    const double z26 = z25 * R3 - z1 * z13;
    const double z27 = z8 * z9;
    const double z28 = k6 - c_lam * z27 - s_lam * z10;
    const double z29 = z25 * k3 - z1 * k4 + z26 - s_steer * z28;
    const double z30 = k7 + z27;
    const double z31 = k4 * z22 + k3 * z23 + z24 + c_steer * z30;
    const double z32 = z24 * z29 - z31 * z26;
    const double z33 = c_steer * z28;
    const double z34 = k1 + s_lam * z27 - c_lam * z10;
    const double z35 = s_pitch * (c_steer * z4 - c_lam * z33 + s_lam * z34) - c_pitch * (c_steer * z14 +
        s_lam * z33 + c_lam * z34);
    const double z36 = c_roll * z35 - e2z * z29;
    const double z37 = s_steer * z30;
    const double z38 = c_roll * (s_pitch * (z25 * z4 + c_lam * z37) - c_pitch * (z25 * z14 - s_lam * z37)) +
        e2z * z31;
    const double z39 = z24 * z36 + z38 * z26;
    const double z40 = z31 * z36 + z38 * z29;
    const double z41 = z20 * z32 - z19 * z39 + z18 * z40;
    const double z42 = 1.0 / z41;
    const double z43 = roll_dot * c_pitch;
    const double z44 = roll_dot * s_pitch;
    const double z45 = steer_dot + (s_lam * z43 + c_lam * z44);
    const double z46 = s_lam * z44 - c_lam * z43;
    const double z47 = c_steer * z46;
    const double z48 = z43 * k3 + z44 * k4 + (z43 * R3 + z44 * z13);
    const double z49 = (s_lam * z45 - c_lam * z47) * z27 - (s_lam * z47 + c_lam * z45) * z10 + (k6 * z47 + k1
        * z45 + c_steer * z48);
    const double z50 = s_steer * z46;
    const double z51 = thF_dot + z50;
    const double z52 = k1 * z50;
    const double z53 = k6 * z50 + s_steer * z48;
    const double z54 = z51 * z27 + (s_lam * z52 - c_lam * z53);
    const double z55 = z31 * z49 - z29 * z54;
    const double z56 = z36 * z54 + z38 * z49;
    const double z57 = z51 * z10 - (c_lam * z52 + s_lam * z53);
    const double z58 = z42 * (z20 * z55 + z19 * z56 + z40 * z57);
    const double z59 = z24 * z49 - z26 * z54;
    const double z60 = z42 * (z20 * z59 + z39 * z57 + z18 * z56);
    const double z61 = z42 * (z32 * z57 + z19 * z59 - z18 * z55);
    const double z62 = z58 - (z60 + e2z * z61);
    const double a3 = z13 * z62;
    const double a1 = R3 * z62;
    const double z63 = s_pitch * a3 + c_pitch * a1;
    const double z64 = s_pitch * a1 - c_pitch * a3;
    const double z65 = c_roll * z61;
    const double v2_x = R3 * (z43 + s_pitch * z65) + z13 * (z44 - c_pitch * z65);
    const double z66 = e2z * z64 - c_roll * v2_x;
    /* (I.2.4) */
    qdot[0] = s_yaw * z66 - c_yaw * z63; /* x' */
    qdot[1] = -(s_yaw * z63 + c_yaw * z66); /* y' */
    qdot[2] = c_roll * z64 + e2z * v2_x; /* z' */
    qdot[3] = -z61; /* yaw' */
    qdot[4] = roll_dot; /* roll' */
    qdot[5] = -z60; /* pitch' */
    qdot[6] = steer_dot; /* steer' */
    qdot[7] = z58; /* thR' */
    qdot[8] = thF_dot; /* thF' */
    /* the coframe is singular */
    if (!(fabs(z41) > 1e-12 * (k14 * (k14 * (13.0 * k13 + (14.0 * k12 + (24.0 * k10 + 33.0 * k11))))))) {
        return BICYCLE_SINGULAR_1;
    }
    return bicycle_finish(9, qdot);
}

int bicycle_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    double dydt[12];
    const int status1 = bicycle_rhs(t, y, p, dydt);
    if (status1 != BICYCLE_OK) {
        return status1;
    }
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double s_yaw = sin(yaw);
    const double c_yaw = cos(yaw);
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = r_F * s_lam - c * c_lam;
    const double k2 = c_lam * (w + c) - r_R * s_lam;
    const double k3 = s_lam * k2;
    const double k4 = c_lam * k2;
    const double k5 = c_lam * c_lam;
    const double k6 = w * s_lam + c_lam * (r_R - r_F);
    const double k7 = s_lam * k1 - c_lam * k6;
    const double k8 = s_lam * s_lam;
    const double k9 = c_lam * k1 + s_lam * k6;

    /* state */
    const double z1 = s_pitch * c_roll;
    const double z2 = r_R * z1;
    const double e3z = c_pitch * c_roll;
    const double z3 = z1 * z1 + e3z * e3z;
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = z2 * z4;
    const double z6 = s_lam * s_steer;
    const double z7 = r_R * e3z;
    const double R3 = z7 * z4;
    const double z8 = R3 + k3;
    const double z9 = z1 * c_lam + e3z * s_lam;
    const double z10 = c_steer * z9 - e2z * s_steer;
    const double z11 = z1 * s_lam - e3z * c_lam;
    const double z12 = c_lam * z10 + s_lam * z11;
    const double z13 = r_F * z12;
    const double z14 = c_lam * z11 - s_lam * z10;
    const double z15 = z12 * z12 + z14 * z14;
    const double z16 = 1.0 / sqrt(z15);
    const double z17 = z13 * z16;
    const double z18 = z17 - k9;
    const double z19 = s_steer * z18;
    const double z20 = z6 * z8 + c_lam * z19;
    const double z21 = z5 + k4;
    const double z22 = z6 * z21 - s_lam * z19;
    const double z23 = s_pitch * z20 - c_pitch * z22;
    const double z24 = s_lam * c_steer;
    const double z25 = k5 + s_lam * z24;
    const double z26 = c_lam * (s_lam - z24);
    const double z27 = z5 * z25 + R3 * z26;
    const double z28 = k4 * z25 + k3 * z26 + z27 - c_steer * z18;
    const double z29 = c_roll * z23 - e2z * z28;
    const double z30 = c_lam * c_steer;
    const double z31 = s_lam * (c_lam - z30);
    const double z32 = c_lam * z30 + k8;
    const double z33 = z5 * z31 + R3 * z32;
    const double z34 = c_lam * s_steer;
    const double z35 = R3 * z34 - z5 * z6;
    const double z36 = r_F * z14;
    const double z37 = z36 * z16;
    const double z38 = k6 - c_lam * z37 - s_lam * z17;
    const double z39 = z34 * k3 - z6 * k4 + z35 - s_steer * z38;
    const double z40 = z37 + k7;
    const double z41 = k4 * z31 + k3 * z32 + z33 + c_steer * z40;
    const double z42 = z33 * z39 - z41 * z35;
    const double z43 = c_steer * z38;
    const double z44 = k1 + s_lam * z37 - c_lam * z17;
    const double z45 = c_steer * z8 - c_lam * z43 + s_lam * z44;
    const double z46 = c_steer * z21 + s_lam * z43 + c_lam * z44;
    const double z47 = s_pitch * z45 - c_pitch * z46;
    const double z48 = c_roll * z47 - e2z * z39;
    const double z49 = s_steer * z40;
    const double z50 = z34 * z8 + c_lam * z49;
    const double z51 = z34 * z21 - s_lam * z49;
    const double z52 = s_pitch * z50 - c_pitch * z51;
    const double z53 = c_roll * z52 + e2z * z41;
    const double z54 = z33 * z48 + z53 * z35;
    const double z55 = z41 * z48 + z53 * z39;
    const double z56 = z29 * z42 - z28 * z54 + z27 * z55;
    const double z57 = 1.0 / z56;
    const double z58 = roll_dot * c_pitch;
    const double z59 = roll_dot * s_pitch;
    const double z60 = steer_dot + (s_lam * z58 + c_lam * z59);
    const double z61 = s_lam * z59 - c_lam * z58;
    const double z62 = c_steer * z61;
    const double z63 = s_lam * z60 - c_lam * z62;
    const double z64 = s_lam * z62 + c_lam * z60;
    const double z65 = z58 * k3 + z59 * k4 + (z58 * R3 + z59 * z5);
    const double z66 = z37 * z63 - z17 * z64 + (k6 * z62 + k1 * z60 + c_steer * z65);
    const double z67 = s_steer * z61;
    const double z68 = thF_dot + z67;
    const double z69 = k1 * z67;
    const double z70 = k6 * z67 + s_steer * z65;
    const double z71 = z37 * z68 + (s_lam * z69 - c_lam * z70);
    const double z72 = z41 * z66 - z39 * z71;
    const double z73 = z48 * z71 + z53 * z66;
    const double z74 = z17 * z68 - (s_lam * z70 + c_lam * z69);
    const double z75 = z29 * z72 + z28 * z73 + z55 * z74;
    const double z76 = z33 * z66 - z35 * z71;
    const double z77 = z29 * z76 + z54 * z74 + z27 * z73;
    const double z78 = z57 * z77;
    const double z79 = z42 * z74 + z28 * z76 - z27 * z72;
    const double z80 = z57 * z79;
    const double z81 = z57 * z75 - (z78 + e2z * z80);
    const double a3 = z5 * z81;
    const double a1 = R3 * z81;
    const double z82 = s_pitch * a3 + c_pitch * a1;
    const double z83 = s_yaw * z80;
    const double z84 = c_pitch * z78;
    const double z85 = r_R * z4;
    const double z86 = roll_dot * e2z;
    const double z87 = s_pitch * z86 + c_roll * z84;
    const double z88 = s_pitch * z78;
    const double z89 = c_pitch * z86 - c_roll * z88;
    const double z90 = (z1 * z87 + e3z * z89) * (z4 / z3);
    const double z91 = z85 * z87 - z2 * z90;
    const double z92 = steer_dot * c_steer;
    const double z93 = s_lam * z92;
    const double z94 = z85 * z89 - z7 * z90;
    const double z95 = roll_dot * c_roll;
    const double z96 = steer_dot * s_steer;
    const double z97 = s_steer * z95 + e2z * z92 + (z9 * z96 + c_steer * (c_lam * z87 + s_lam * z89));
    const double z98 = s_lam * z87 - c_lam * z89;
    const double z99 = c_lam * z97 + s_lam * z98;
    const double z100 = r_F * z16;
    const double z101 = c_lam * z98 - s_lam * z97;
    const double z102 = (z12 * z99 + z14 * z101) * (z16 / z15);
    const double z103 = z99 * z100 - z13 * z102;
    const double z104 = z92 * z18 - s_steer * z103;
    const double z105 = z6 * z91;
    const double z106 = z20 * z84 - s_pitch * (z8 * z93 - z6 * z94 + c_lam * z104) + (z22 * z88 + c_pitch *
        (z21 * z93 - z105 - s_lam * z104));
    const double z107 = s_lam * z96;
    const double z108 = s_lam * z107;
    const double z109 = c_lam * z107;
    const double z110 = z5 * z108 + z25 * z91 - (R3 * z109 - z26 * z94);
    const double z111 = k4 * z108 - k3 * z109 + z110 - (z96 * z18 + c_steer * z103);
    const double z112 = z86 * z23 + c_roll * z106 + (z95 * z28 - e2z * z111);
    const double z113 = c_lam * z96;
    const double z114 = s_lam * z113;
    const double z115 = c_lam * z113;
    const double z116 = z5 * z114 - z31 * z91 - (R3 * z115 + z32 * z94);
    const double z117 = c_lam * z92;
    const double z118 = z34 * z94;
    const double z119 = R3 * z117 - z118 - (z5 * z93 - z105);
    const double z120 = z101 * z100 - z36 * z102;
    const double z121 = c_lam * z120 + s_lam * z103;
    const double z122 = k3 * z117 - k4 * z93 + z119 - (z92 * z38 + s_steer * z121);
    const double z123 = k4 * z114 - k3 * z115 + z116 - (z96 * z40 + c_steer * z120);
    const double z124 = z39 * z116 + z33 * z122 - (z35 * z123 + z41 * z119);
    const double z125 = z96 * z38 - c_steer * z121;
    const double z126 = s_lam * z120 - c_lam * z103;
    const double z127 = z45 * z84 + s_pitch * (z96 * z8 + c_steer * z94 - c_lam * z125 + s_lam * z126) + (z46
        * z88 - c_pitch * (z96 * z21 + c_steer * z91 + s_lam * z125 + c_lam * z126));
    const double z128 = z86 * z47 + c_roll * z127 + (z95 * z39 + e2z * z122);
    const double z129 = z92 * z40 - s_steer * z120;
    const double z130 = z50 * z84 - s_pitch * (z8 * z117 - z118 + c_lam * z129) + (z51 * z88 + c_pitch * (z21
        * z117 - z34 * z91 - s_lam * z129));
    const double z131 = z86 * z52 + c_roll * z130 - (z95 * z41 + e2z * z123);
    const double z132 = z48 * z116 - z33 * z128 - (z35 * z131 - z53 * z119);
    const double z133 = z48 * z123 - z41 * z128 - (z39 * z131 - z53 * z122);
    const double z134 = z42 * z112 - z29 * z124 - (z54 * z111 - z28 * z132) + (z55 * z110 - z27 * z133);
    const double z135 = z134 / (z56 * z56);
    const double z136 = roll_dot * z88 + c_pitch * roll_ddot;
    const double z137 = roll_dot * z84 - s_pitch * roll_ddot;
    const double z138 = steer_ddot + (s_lam * z136 - c_lam * z137);
    const double z139 = s_lam * z137 + c_lam * z136;
    const double z140 = z96 * z61 + c_steer * z139;
    const double z141 = z63 * z120 - z37 * (s_lam * z138 + c_lam * z140) - (z64 * z103 + z17 * (s_lam * z140
        - c_lam * z138));
    const double z142 = k3 * z136 - k4 * z137 - (z58 * z94 - R3 * z136 + (z59 * z91 + z5 * z137));
    const double z143 = z141 + (k6 * z140 - k1 * z138 + (z96 * z65 - c_steer * z142));
    const double z144 = z92 * z61 - s_steer * z139;
    const double z145 = thF_ddot + z144;
    const double z146 = k1 * z144;
    const double z147 = k6 * z144 + (z92 * z65 + s_steer * z142);
    const double z148 = z68 * z120 - z37 * z145 - (s_lam * z146 - c_lam * z147);
    const double z149 = z66 * z123 - z41 * z143 - (z71 * z122 - z39 * z148);
    const double z150 = z71 * z128 + z48 * z148 + (z66 * z131 + z53 * z143);
    const double z151 = z68 * z103 - z17 * z145 + (c_lam * z146 + s_lam * z147);
    const double z152 = z72 * z112 - z29 * z149 + (z73 * z111 + z28 * z150) - (z74 * z133 - z55 * z151);
    const double z153 = z75 * z135 - z57 * z152;
    const double z154 = z66 * z116 - z33 * z143 - (z71 * z119 - z35 * z148);
    const double z155 = z76 * z112 - z29 * z154 - (z74 * z132 - z54 * z151) + (z73 * z110 + z27 * z150);
    const double z156 = z77 * z135 - z57 * z155;
    const double z157 = z74 * z124 - z42 * z151 - (z76 * z111 - z28 * z154) + (z72 * z110 - z27 * z149);
    const double z158 = z79 * z135 + z57 * z157;
    const double z159 = z153 - (z156 + (z95 * z80 + e2z * z158));
    const double z160 = z81 * z91 - z5 * z159;
    const double z161 = z81 * z94 - R3 * z159;
    const double z162 = a3 * z84 + s_pitch * z160 - (a1 * z88 - c_pitch * z161);
    const double z163 = s_pitch * a1 - c_pitch * a3;
    const double z164 = c_roll * z80;
    const double w1_pitch = z58 + s_pitch * z164;
    const double w3_pitch = z59 - c_pitch * z164;
    const double v2_x = R3 * w1_pitch + z5 * w3_pitch;
    const double z165 = e2z * z163 - c_roll * v2_x;
    const double z166 = c_yaw * z80;
    const double z167 = a1 * z84 + s_pitch * z161 + (a3 * z88 - c_pitch * z160);
    const double z168 = z86 * z80 - c_roll * z158;
    const double z169 = w1_pitch * z94 - R3 * (z136 - (z164 * z84 + s_pitch * z168)) + (w3_pitch * z91 + z5 *
        (z137 + (z164 * z88 - c_pitch * z168)));
    const double z170 = z95 * z163 - e2z * z167 + (z86 * v2_x + c_roll * z169);
    /* (I.2.15) */
    qddot[0] = -(z82 * z83 - c_yaw * z162 + (z165 * z166 - s_yaw * z170)); /* x'' */
    qddot[1] = z82 * z166 + s_yaw * z162 - (z165 * z83 + c_yaw * z170); /* y'' */
    qddot[2] = z95 * v2_x - e2z * z169 - (z86 * z163 + c_roll * z167); /* z'' */
    qddot[3] = -z158; /* yaw'' */
    qddot[4] = roll_ddot; /* roll'' */
    qddot[5] = -z156; /* pitch'' */
    qddot[6] = steer_ddot; /* steer'' */
    qddot[7] = z153; /* thR'' */
    qddot[8] = thF_ddot; /* thF'' */
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

    /* sines and cosines */
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double c_pitch = cos(pitch);
    const double s_pitch = sin(pitch);
    const double e2z = sin(roll);
    const double c_roll = cos(roll);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
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
    const double z1 = s_yaw * e2z;
    const double e1x = c_yaw * c_pitch - z1 * s_pitch;
    const double w2 = pitch_dot + yaw_dot * e2z;
    const double z2 = thR_dot + w2;
    const double e3z = c_pitch * c_roll;
    const double z3 = s_pitch * c_roll;
    const double z4 = r_R / sqrt(z3 * z3 + e3z * e3z);
    const double R3 = e3z * z4;
    const double a1 = z2 * R3;
    const double z5 = s_yaw * c_roll;
    const double w3 = roll_dot * s_pitch + yaw_dot * e3z;
    const double z6 = z3 * z4;
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
    const double z18 = steer_dot * s_steer;
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
    const double z30 = r_F / sqrt(z29 * z29 + z28 * z28);
    const double z31 = z28 * z30;
    const double z32 = z24 * z31;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double wf = c_steer * z23 + s_steer * w2;
    const double z33 = z29 * z30;
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

static int bicycle_reactions_part1(double t, const double *y, const double *p, const double *dydt, double
    *kept, double *lambda)
{
    (void)lambda;
    (void)t;
    (void)dydt;
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

    /* sines and cosines */
    const double e2z = sin(roll);
    kept[0] = e2z;
    const double c_roll = cos(roll);
    kept[1] = c_roll;
    const double c_steer = cos(steer);
    kept[2] = c_steer;
    const double s_steer = sin(steer);
    kept[3] = s_steer;
    const double s_pitch = sin(pitch);
    kept[4] = s_pitch;
    const double c_pitch = cos(pitch);
    kept[5] = c_pitch;
    const double c_yaw = cos(yaw);
    kept[6] = c_yaw;
    const double s_yaw = sin(yaw);
    kept[7] = s_yaw;

    /* parameters only */
    const double s_lam = sin(lam);
    kept[8] = s_lam;
    const double c_lam = cos(lam);
    kept[9] = c_lam;
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = r_F * s_lam - c * c_lam;
    kept[10] = k3;
    const double k4 = H_zz + F_xx;
    const double k5 = H_xx + F_xx;
    const double k6 = z_H * s_lam - c_lam * (x_H - k2);
    const double k7 = x_H * s_lam + c_lam * (r_R + z_H);
    const double k8 = c_lam * k2 - r_R * s_lam;
    const double k9 = s_lam * k8;
    kept[11] = k9;
    const double k10 = c_lam * k8;
    kept[12] = k10;
    const double k11 = c_lam * c_lam;
    const double k12 = w * s_lam + c_lam * (r_R - r_F);
    kept[13] = k12;
    const double k13 = s_lam * k3 - c_lam * k12;
    const double k14 = s_lam * s_lam;
    const double k15 = c_lam * k3 + s_lam * k12;
    const double k16 = m_R + m_B;
    kept[14] = k16;
    const double k17 = m_B * k1;
    kept[15] = k17;
    const double k18 = x_B * m_B;
    kept[16] = k18;
    const double k19 = k1 * k17;
    const double k20 = R_xx + B_xx + k19;
    kept[17] = k20;
    const double k21 = x_B * k18;
    const double k22 = k19 + (B_yy + k21);
    kept[18] = k22;
    const double k23 = B_xz - k1 * k18;
    kept[19] = k23;
    const double k24 = R_xx + B_zz + k21;
    kept[20] = k24;
    const double k25 = m_F * k12;
    const double k26 = m_H + m_F;
    kept[21] = k26;
    const double k27 = m_H * k7;
    const double k28 = k25 + k27;
    kept[22] = k28;
    const double k29 = m_F * k3;
    const double k30 = m_H * k6;
    const double k31 = k29 - k30;
    kept[23] = k31;
    const double k32 = H_xz * c_lam;
    const double k33 = s_lam * k4 - k32;
    const double k34 = H_xz * s_lam;
    const double k35 = c_lam * k5 - k34;
    const double k36 = k12 * k25;
    const double k37 = k7 * k27;
    const double k38 = c_lam * k35 + s_lam * k33 + k36 + k37;
    kept[24] = k38;
    const double k39 = s_lam * k35 - c_lam * k33 - k3 * k25 + k6 * k27;
    kept[25] = k39;
    const double k40 = k3 * k29;
    const double k41 = k6 * k30;
    const double k42 = k37 + (k36 + (H_yy + k40) + k41);
    kept[26] = k42;
    const double k43 = k34 + c_lam * k4;
    const double k44 = k32 + s_lam * k5;
    const double k45 = c_lam * k44 - s_lam * k43 - k12 * k29 + k7 * k30;
    kept[27] = k45;
    const double k46 = k41 + (k40 + (s_lam * k44 + c_lam * k43));
    kept[28] = k46;
    const double k47 = g * m_F;
    const double k48 = g * m_H;
    const double k49 = g * m_B;
    const double k50 = g * k16;
    kept[29] = k50;
    const double k51 = x_B * k49;
    kept[30] = k51;
    const double k52 = k1 * k49;
    kept[31] = k52;
    const double k53 = k6 * k48;
    kept[32] = k53;
    const double k54 = k7 * k48;
    kept[33] = k54;
    const double k55 = g * k26;
    kept[34] = k55;
    const double k56 = k3 * k47;
    kept[35] = k56;
    const double k57 = k12 * k47;
    kept[36] = k57;
    const double k58 = k54 + k57;
    kept[37] = k58;
    const double k59 = k53 - k56;
    kept[38] = k59;

    /* state */
    const double z1 = s_pitch * c_roll;
    kept[39] = z1;
    const double e3z = c_pitch * c_roll;
    kept[40] = e3z;
    const double z2 = z1 * c_lam + e3z * s_lam;
    const double h2z = e2z * c_steer + s_steer * z2;
    kept[41] = h2z;
    const double z3 = s_lam * s_steer;
    const double z4 = r_R * e3z;
    const double z5 = z1 * z1 + e3z * e3z;
    const double z6 = 1.0 / sqrt(z5);
    const double R3 = z4 * z6;
    kept[42] = R3;
    const double z7 = R3 + k9;
    const double z8 = c_steer * z2 - e2z * s_steer;
    kept[43] = z8;
    const double z9 = z1 * s_lam - e3z * c_lam;
    kept[44] = z9;
    const double z10 = c_lam * z8 + s_lam * z9;
    kept[45] = z10;
    const double z11 = r_F * z10;
    const double z12 = c_lam * z9 - s_lam * z8;
    kept[46] = z12;
    const double z13 = z10 * z10 + z12 * z12;
    const double z14 = 1.0 / sqrt(z13);
    const double z15 = z11 * z14;
    kept[47] = z15;
    const double z16 = z15 - k15;
    const double z17 = s_steer * z16;
    const double z18 = z3 * z7 + c_lam * z17;
    const double z19 = r_R * z1;
    const double z20 = z19 * z6;
    kept[48] = z20;
    const double z21 = z20 + k10;
    const double z22 = z3 * z21 - s_lam * z17;
    const double z23 = s_pitch * z18 - c_pitch * z22;
    const double z24 = s_lam * c_steer;
    const double z25 = k11 + s_lam * z24;
    const double z26 = c_lam * (s_lam - z24);
    const double z27 = z20 * z25 + R3 * z26;
    kept[49] = z27;
    const double z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16;
    kept[50] = z28;
    const double z29 = c_roll * z23 - e2z * z28;
    kept[51] = z29;
    const double z30 = c_lam * c_steer;
    const double z31 = s_lam * (c_lam - z30);
    const double z32 = c_lam * z30 + k14;
    const double z33 = z20 * z31 + R3 * z32;
    kept[52] = z33;
    const double z34 = c_lam * s_steer;
    const double z35 = R3 * z34 - z20 * z3;
    kept[53] = z35;
    const double z36 = r_F * z12;
    const double z37 = z36 * z14;
    kept[54] = z37;
    const double z38 = k12 - c_lam * z37 - s_lam * z15;
    const double z39 = z34 * k9 - z3 * k10 + z35 - s_steer * z38;
    kept[55] = z39;
    const double z40 = z37 + k13;
    const double z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40;
    kept[56] = z41;
    const double z42 = z33 * z39 - z41 * z35;
    kept[57] = z42;
    const double z43 = c_steer * z38;
    const double z44 = s_lam * z37;
    kept[58] = z44;
    const double z45 = c_lam * z15;
    kept[59] = z45;
    const double z46 = k3 + z44 - z45;
    const double z47 = c_steer * z7 - c_lam * z43 + s_lam * z46;
    const double z48 = c_steer * z21 + s_lam * z43 + c_lam * z46;
    const double z49 = s_pitch * z47 - c_pitch * z48;
    const double z50 = c_roll * z49 - e2z * z39;
    kept[60] = z50;
    const double z51 = s_steer * z40;
    const double z52 = z34 * z7 + c_lam * z51;
    const double z53 = z34 * z21 - s_lam * z51;
    const double z54 = s_pitch * z52 - c_pitch * z53;
    const double z55 = c_roll * z54 + e2z * z41;
    kept[61] = z55;
    const double z56 = z33 * z50 + z55 * z35;
    kept[62] = z56;
    const double z57 = z41 * z50 + z55 * z39;
    kept[63] = z57;
    const double z58 = 1.0 / (z29 * z42 - z28 * z56 + z27 * z57);
    kept[64] = z58;
    const double z59 = roll_dot * c_pitch;
    const double z60 = roll_dot * s_pitch;
    const double z61 = steer_dot + (s_lam * z59 + c_lam * z60);
    const double z62 = s_lam * z60 - c_lam * z59;
    const double z63 = c_steer * z62;
    const double z64 = s_lam * z61 - c_lam * z63;
    const double z65 = s_lam * z63 + c_lam * z61;
    const double z66 = z59 * k9 + z60 * k10 + (z59 * R3 + z60 * z20);
    const double z67 = z37 * z64 - z15 * z65 + (k12 * z63 + k3 * z61 + c_steer * z66);
    const double z68 = s_steer * z62;
    const double z69 = thF_dot + z68;
    const double z70 = k3 * z68;
    const double z71 = k12 * z68 + s_steer * z66;
    const double z72 = z37 * z69 + (s_lam * z70 - c_lam * z71);
    const double z73 = z33 * z67 - z35 * z72;
    const double z74 = z15 * z69 - (s_lam * z71 + c_lam * z70);
    const double z75 = z50 * z72 + z55 * z67;
    const double z76 = z58 * (z29 * z73 + z56 * z74 + z27 * z75);
    const double z77 = z41 * z67 - z39 * z72;
    const double z78 = z58 * (z42 * z74 + z28 * z73 - z27 * z77);
    kept[65] = z78;
    const double z79 = z76 + e2z * z78;
    kept[66] = z79;
    const double z80 = c_roll * z78;
    const double w1_pitch = z59 + s_pitch * z80;
    kept[67] = w1_pitch;
    const double w3_pitch = z60 - c_pitch * z80;
    kept[68] = w3_pitch;
    const double z81 = c_lam * w1_pitch - s_lam * w3_pitch;
    kept[69] = z81;
    const double z82 = s_steer * z79 - c_steer * z81;
    kept[70] = z82;
    const double z83 = c_steer * z79 + s_steer * z81;
    kept[71] = z83;
    const double z84 = F_yy * (thF_dot - z83) - k42 * z83;
    kept[72] = z84;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    kept[73] = w3_steer;
    const double z85 = k38 * z82 - k39 * w3_steer;
    kept[74] = z85;
    const double z86 = c_pitch * z76;
    const double z87 = roll_dot * z86;
    const double z88 = s_pitch * z76;
    const double z89 = roll_dot * e2z;
    const double z90 = steer_dot * c_steer;
    kept[75] = z90;
    const double z91 = roll_dot * z88;
    const double z92 = s_lam * z87 + c_lam * z91;
    const double z93 = z90 * z62 - s_steer * z92;
    const double z94 = roll_dot * c_roll;
    kept[76] = z94;
    const double z95 = steer_dot * s_steer;
    kept[77] = z95;
    const double z96 = s_pitch * z89 + c_roll * z86;
    const double z97 = c_pitch * z89 - c_roll * z88;
    const double z98 = s_steer * z94 + e2z * z90 + (z2 * z95 + c_steer * (c_lam * z96 + s_lam * z97));
    const double z99 = s_lam * z96 - c_lam * z97;
    const double z100 = c_lam * z98 + s_lam * z99;
    const double z101 = r_F * z14;
    const double z102 = c_lam * z99 - s_lam * z98;
    const double z103 = (z10 * z100 + z12 * z102) * (z14 / z13);
    const double z104 = z100 * z101 - z11 * z103;
    const double z105 = k3 * z93;
    const double z106 = r_R * z6;
    const double z107 = (z1 * z96 + e3z * z97) * (z6 / z5);
    const double z108 = z106 * z97 - z4 * z107;
    kept[78] = z108;
    const double z109 = z106 * z96 - z19 * z107;
    kept[79] = z109;
    const double z110 = k9 * z91 - k10 * z87 + (R3 * z91 - z59 * z108 - (z20 * z87 + z60 * z109));
    const double z111 = k12 * z93 + (z90 * z66 + s_steer * z110);
    const double z112 = z58 * (z29 * z77 + z28 * z75 + z57 * z74);
    const double z113 = s_lam * z95;
    const double z114 = s_lam * z113;
    const double z115 = c_lam * z113;
    const double z116 = z20 * z114 + z25 * z109 - (R3 * z115 - z26 * z108);
    const double z117 = s_lam * z90;
    const double z118 = z90 * z16 - s_steer * z104;
    const double z119 = z3 * z109;
    const double z120 = z18 * z86 - s_pitch * (z7 * z117 - z3 * z108 + c_lam * z118) + (z22 * z88 + c_pitch *
        (z21 * z117 - z119 - s_lam * z118));
    const double z121 = k10 * z114 - k9 * z115 + z116 - (z95 * z16 + c_steer * z104);
    const double z122 = z112 * z116 + (z78 * (z89 * z23 + c_roll * z120 + (z94 * z28 - e2z * z121)) - z76 *
        z121);
    const double z123 = z15 * z93 - z69 * z104 - (c_lam * z105 + s_lam * z111) + z122;
    kept[80] = z123;
    const double z124 = s_lam * z91 - c_lam * z87;
    const double z125 = z95 * z62 + c_steer * z92;
    const double z126 = z102 * z101 - z36 * z103;
    const double z127 = z37 * (s_lam * z124 + c_lam * z125) - z64 * z126 + (z15 * (s_lam * z125 - c_lam *
        z124) + z65 * z104);
    const double z128 = c_lam * z90;
    const double z129 = z34 * z108;
    const double z130 = R3 * z128 - z129 - (z20 * z117 - z119);
    const double z131 = c_lam * z126 + s_lam * z104;
    const double z132 = z95 * z38 - c_steer * z131;
    const double z133 = s_lam * z126 - c_lam * z104;
    const double z134 = z47 * z86 + s_pitch * (z95 * z7 + c_steer * z108 - c_lam * z132 + s_lam * z133) +
        (z48 * z88 - c_pitch * (z95 * z21 + c_steer * z109 + s_lam * z132 + c_lam * z133));
    const double z135 = k9 * z128 - k10 * z117 + z130 - (z90 * z38 + s_steer * z131);
    const double z136 = z112 * z130 - (z78 * (z89 * z49 + c_roll * z134 + (z94 * z39 + e2z * z135)) + z76 *
        z135);
    const double z137 = z127 - (k12 * z125 - k3 * z124 + (z95 * z66 - c_steer * z110)) + z136;
    kept[81] = z137;
    const double z138 = c_lam * z95;
    const double z139 = s_lam * z138;
    const double z140 = c_lam * z138;
    const double z141 = z20 * z139 - z31 * z109 - (R3 * z140 + z32 * z108);
    const double z142 = z90 * z40 - s_steer * z126;
    const double z143 = z52 * z86 - s_pitch * (z7 * z128 - z129 + c_lam * z142) + (z53 * z88 + c_pitch * (z21
        * z128 - z34 * z109 - s_lam * z142));
    const double z144 = k10 * z139 - k9 * z140 + z141 - (z95 * z40 + c_steer * z126);
    const double z145 = z112 * z141 + (z78 * (z89 * z54 + c_roll * z143 - (z94 * z41 + e2z * z144)) - z76 *
        z144);
    const double z146 = z37 * z93 - z69 * z126 + (s_lam * z105 - c_lam * z111) + z145;
    kept[82] = z146;
    const double z147 = z33 * z137 - z35 * z146;
    kept[83] = z147;
    const double z148 = z41 * z137 - z39 * z146;
    kept[84] = z148;
    const double z149 = z58 * (z42 * z123 + z28 * z147 - z27 * z148);
    kept[85] = z149;
    const double z150 = z89 * z78 - c_roll * z149;
    const double z151 = z87 + (z80 * z88 - c_pitch * z150);
    kept[86] = z151;
    const double z152 = z91 - (z80 * z86 + s_pitch * z150);
    kept[87] = z152;
    const double z153 = c_lam * z151 - s_lam * z152;
    kept[88] = z153;
    const double z154 = z112 - z79;
    kept[89] = z154;
    const double a1 = R3 * z154;
    kept[90] = a1;
    const double a3 = z20 * z154;
    kept[91] = a3;
    const double z155 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z108 - R3 * z152 + (w3_pitch * z109 + z20
        * z151));
    kept[92] = z155;
    const double z156 = k9 * z79;
    kept[93] = z156;
    const double z157 = k10 * z79;
    kept[94] = z157;
    const double z158 = z155 - (w3_pitch * z156 - w1_pitch * z157 - (k10 * z151 - k9 * z152));
    kept[95] = z158;
    const double v2_x = R3 * w1_pitch + z20 * w3_pitch;
    kept[96] = v2_x;
    return BICYCLE_OK;
}

static int bicycle_reactions_part2(double t, const double *y, const double *p, const double *dydt, double
    *kept, double *lambda)
{
    (void)t;
    const double roll_dot = y[9];
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */
    const double e2z = kept[0];
    const double c_roll = kept[1];
    const double c_steer = kept[2];
    const double s_steer = kept[3];
    const double s_pitch = kept[4];
    const double c_pitch = kept[5];
    const double c_yaw = kept[6];
    const double s_yaw = kept[7];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k3 = kept[10];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k12 = kept[13];
    const double k16 = kept[14];
    const double k17 = kept[15];
    const double k18 = kept[16];
    const double k20 = kept[17];
    const double k22 = kept[18];
    const double k23 = kept[19];
    const double k24 = kept[20];
    const double k26 = kept[21];
    const double k28 = kept[22];
    const double k31 = kept[23];
    const double k38 = kept[24];
    const double k39 = kept[25];
    const double k42 = kept[26];
    const double k45 = kept[27];
    const double k46 = kept[28];
    const double k50 = kept[29];
    const double k51 = kept[30];
    const double k52 = kept[31];
    const double k53 = kept[32];
    const double k54 = kept[33];
    const double k55 = kept[34];
    const double k56 = kept[35];
    const double k57 = kept[36];
    const double k58 = kept[37];
    const double k59 = kept[38];
    const double z1 = kept[39];
    const double e3z = kept[40];
    const double h2z = kept[41];
    const double R3 = kept[42];
    const double z8 = kept[43];
    const double z9 = kept[44];
    const double z15 = kept[47];
    const double z20 = kept[48];
    const double z27 = kept[49];
    const double z28 = kept[50];
    const double z29 = kept[51];
    const double z33 = kept[52];
    const double z35 = kept[53];
    const double z37 = kept[54];
    const double z39 = kept[55];
    const double z41 = kept[56];
    const double z42 = kept[57];
    const double z44 = kept[58];
    const double z45 = kept[59];
    const double z50 = kept[60];
    const double z55 = kept[61];
    const double z56 = kept[62];
    const double z57 = kept[63];
    const double z58 = kept[64];
    const double z78 = kept[65];
    const double z79 = kept[66];
    const double w1_pitch = kept[67];
    const double w3_pitch = kept[68];
    const double z81 = kept[69];
    const double z82 = kept[70];
    const double z83 = kept[71];
    const double z84 = kept[72];
    const double w3_steer = kept[73];
    const double z85 = kept[74];
    const double z90 = kept[75];
    const double z94 = kept[76];
    const double z95 = kept[77];
    const double z108 = kept[78];
    const double z109 = kept[79];
    const double z123 = kept[80];
    const double z137 = kept[81];
    const double z146 = kept[82];
    const double z147 = kept[83];
    const double z148 = kept[84];
    const double z149 = kept[85];
    const double z151 = kept[86];
    const double z152 = kept[87];
    const double z153 = kept[88];
    const double z154 = kept[89];
    const double a1 = kept[90];
    const double a3 = kept[91];
    const double z155 = kept[92];
    const double z156 = kept[93];
    const double z157 = kept[94];
    const double z158 = kept[95];
    const double v2_x = kept[96];
    const double z159 = z50 * z146 + z55 * z137;
    const double z160 = z58 * (z29 * z147 + z56 * z123 + z27 * z159) + (z94 * z78 + e2z * z149);
    const double z161 = z58 * (z29 * z148 + z28 * z159 + z57 * z123) - z160;
    kept[97] = z161;
    const double z162 = z79 * a3 - w3_pitch * v2_x + (z154 * z108 - R3 * z161);
    const double z163 = k10 * w3_pitch + k9 * w1_pitch;
    const double z164 = z162 - (z79 * z157 + w3_pitch * z163 - k9 * z160);
    const double z165 = w1_pitch * v2_x - z79 * a1 + (z154 * z109 - z20 * z161);
    const double z166 = z165 + (w1_pitch * z163 + z79 * z156 + k10 * z160);
    const double z167 = c_lam * z164 - s_lam * z166;
    const double z168 = c_steer * z158 + s_steer * z167;
    const double z169 = c_lam * z152 + s_lam * z151;
    const double z170 = z90 * z79 + s_steer * z160 + (z95 * z81 - c_steer * z169);
    const double z171 = h2z * k59 - (z82 * z84 + z83 * z85 + (k46 * z153 + (k31 * z168 + k45 * z170)));
    kept[98] = z171;
    const double z172 = s_yaw * e2z;
    const double e1x = c_yaw * c_pitch - z172 * s_pitch;
    const double e3x = c_yaw * s_pitch + c_pitch * z172;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z173 = e1x * c_lam - e3x * s_lam;
    const double z174 = s_yaw * c_roll;
    const double f1x = c_steer * z173 - z174 * s_steer;
    const double h3x = c_lam * sx - s_lam * f1x;
    const double z175 = z174 * c_steer + z173 * s_steer;
    const double h1x = c_lam * f1x + s_lam * sx;
    const double z176 = z175 * z33 - h1x * z35;
    const double z177 = z175 * z41 - h1x * z39;
    const double z178 = z58 * (h3x * z42 - z28 * z176 + z27 * z177);
    const double z179 = c_roll * z178;
    const double z180 = c_pitch * z179;
    const double z181 = s_pitch * z179;
    const double z182 = c_lam * z180 - s_lam * z181;
    const double z183 = z171 * z182;
    kept[99] = z183;
    const double z184 = k45 * z82 - k46 * w3_steer;
    const double z185 = z95 * z79 - c_steer * z160 - (z90 * z81 + s_steer * z169);
    kept[100] = z185;
    const double z186 = c_steer * z167 - s_steer * z158;
    const double z187 = c_lam * z166 + s_lam * z164;
    const double z188 = z8 * k54 + z9 * k53 + (z8 * k57 - z9 * k56) - (w3_steer * z85 + z82 * z184 - (k42 *
        z185 + (k28 * z186 - k31 * z187)));
    kept[101] = z188;
    const double z189 = h1x * z50 + z175 * z55;
    const double z190 = z58 * (z29 * z176 - h3x * z56 + z27 * z189) - e2z * z178;
    const double z191 = c_lam * z181 + s_lam * z180;
    const double z192 = c_steer * z190 - s_steer * z191;
    const double z193 = z188 * z192;
    kept[102] = z193;
    const double z194 = h2z * k58 + (z83 * z184 - w3_steer * z84 - (k39 * z153 - (k28 * z168 - k38 * z170)));
    kept[103] = z194;
    const double z195 = s_steer * z190 + c_steer * z191;
    const double z196 = z194 * z195;
    kept[104] = z196;
    const double z197 = k28 * z82 + k31 * w3_steer;
    const double z198 = k28 * z83;
    const double z199 = z9 * k55 - (z82 * z197 + z83 * z198 - (k26 * z187 - k31 * z185));
    kept[105] = z199;
    const double z200 = z58 * (z29 * z177 + z28 * z189 - h3x * z57) - z190;
    const double z201 = z20 * z200;
    kept[106] = z201;
    const double z202 = e3x + z201;
    const double z203 = k10 * z190;
    kept[107] = z203;
    const double z204 = z202 - z203;
    const double z205 = R3 * z200;
    kept[108] = z205;
    const double z206 = e1x + z205;
    const double z207 = k9 * z190;
    kept[109] = z207;
    const double z208 = z206 - z207;
    const double z209 = c_lam * z204 + s_lam * z208;
    const double z210 = k31 * z83;
    const double z211 = h2z * k55 + (w3_steer * z198 - z82 * z210 + (k31 * z153 + (k26 * z168 - k28 * z170)));
    kept[110] = z211;
    const double z212 = R3 * z181 - z20 * z180;
    kept[111] = z212;
    const double z213 = z174 - z212;
    const double z214 = k10 * z180 - k9 * z181;
    kept[112] = z214;
    const double z215 = z213 + z214;
    const double z216 = c_lam * z208 - s_lam * z204;
    const double z217 = c_steer * z215 + s_steer * z216;
    const double z218 = z8 * k55 - (z83 * z210 + w3_steer * z197 - (k26 * z186 + k28 * z185));
    kept[113] = z218;
    const double z219 = c_steer * z216 - s_steer * z215;
    const double z220 = k22 * z79;
    const double z221 = k20 * w1_pitch + k23 * w3_pitch;
    const double z222 = e2z * k51 + (w1_pitch * z220 - z79 * z221 + (k24 * z151 + (k18 * z155 - k23 * z152)));
    kept[114] = z222;
    const double z223 = z222 * z180;
    kept[115] = z223;
    const double z224 = k23 * w1_pitch + k24 * w3_pitch;
    const double z225 = z1 * k52 + e3z * k51 + (w3_pitch * z221 - w1_pitch * z224 - (k22 * z160 - (k17 * z162
        - k18 * z165)));
    kept[116] = z225;
    const double z226 = z225 * z190;
    kept[117] = z226;
    const double z227 = e2z * k52 - (z79 * z224 - w3_pitch * z220 + (k23 * z151 - (k17 * z155 + k20 * z152)));
    kept[118] = z227;
    const double z228 = z227 * z181;
    kept[119] = z228;
    const double z229 = k17 * w1_pitch - k18 * w3_pitch;
    const double z230 = k17 * z79;
    const double z231 = e3z * k50 + (w1_pitch * z229 + z79 * z230 - (k16 * z165 + k18 * z160));
    kept[120] = z231;
    const double z232 = k18 * z79;
    const double z233 = z1 * k50 - (z79 * z232 - w3_pitch * z229 - (k16 * z162 - k17 * z160));
    kept[121] = z233;
    const double z234 = e2z * k50 + (w3_pitch * z230 + w1_pitch * z232 + (k18 * z151 + (k16 * z155 + k17 *
        z152)));
    kept[122] = z234;
    const double z235 = z211 * z217 + (z218 * z219 + (z223 + (z226 + (z228 - (z231 * z202 - (z233 * z206 +
        z234 * z213))))));
    const double z236 = R_yy * z200;
    const double z237 = z161 * z236;
    kept[123] = z237;
    const double z238 = F_yy * z192;
    const double z239 = z185 * z238;
    kept[124] = z239;
    const double z240 = z154 * (roll_dot * R_yy);
    kept[125] = z240;
    const double z241 = z179 * z240;
    kept[126] = z241;
    const double z242 = z37 * z35;
    const double z243 = z37 * z39;
    const double z244 = z58 * (z15 * z42 - z28 * z242 + z27 * z243);
    const double z245 = c_roll * z244;
    const double z246 = c_pitch * z245;
    kept[127] = z246;
    const double z247 = s_pitch * z245;
    kept[128] = z247;
    const double z248 = c_lam * z246 - s_lam * z247;
    kept[129] = z248;
    const double z249 = k46 * z182;
    kept[130] = z249;
    const double z250 = k45 * z195;
    kept[131] = z250;
    const double z251 = z249 + (k31 * z217 - z250);
    const double z252 = z37 * z50;
    const double z253 = z58 * (z29 * z242 - z15 * z56 - z27 * z252) - e2z * z244;
    kept[132] = z253;
    const double z254 = c_lam * z247 + s_lam * z246;
    const double z255 = c_steer * z253 - s_steer * z254;
    kept[133] = z255;
    const double z256 = k42 * z192;
    kept[134] = z256;
    const double z257 = z256 + (k28 * z219 - k31 * z209);
    const double z258 = s_steer * z253 + c_steer * z254;
    kept[135] = z258;
    const double z259 = k39 * z182;
    kept[136] = z259;
    const double z260 = k38 * z195;
    kept[137] = z260;
    const double z261 = z259 - (k28 * z217 + z260);
    const double z262 = z58 * (z29 * z243 - z28 * z252 - z15 * z57) - z253;
    kept[138] = z262;
    const double z263 = z20 * z262;
    kept[139] = z263;
    const double z264 = z263 - k10 * z253;
    const double z265 = R3 * z262;
    kept[140] = z265;
    const double z266 = z265 - k9 * z253;
    const double z267 = c_lam * z264 + s_lam * z266;
    kept[141] = z267;
    const double z268 = k31 * z192;
    kept[142] = z268;
    const double z269 = k26 * z209 - z268;
    const double z270 = R3 * z247 - z20 * z246;
    kept[143] = z270;
    const double z271 = z270 - (k10 * z246 - k9 * z247);
    const double z272 = c_lam * z266 - s_lam * z264;
    const double z273 = c_steer * z271 - s_steer * z272;
    kept[144] = z273;
    const double z274 = k31 * z182;
    kept[145] = z274;
    const double z275 = k28 * z195;
    kept[146] = z275;
    const double z276 = z274 + (k26 * z217 + z275);
    const double z277 = c_steer * z272 + s_steer * z271;
    kept[147] = z277;
    const double z278 = k28 * z192;
    kept[148] = z278;
    const double z279 = k26 * z219 + z278;
    const double z280 = k24 * z180;
    kept[149] = z280;
    const double z281 = k23 * z181;
    kept[150] = z281;
    const double z282 = z280 + (k18 * z213 - z281);
    const double z283 = k22 * z190;
    kept[151] = z283;
    const double z284 = z283 + (k17 * z206 - k18 * z202);
    const double z285 = k23 * z180;
    kept[152] = z285;
    const double z286 = k20 * z181;
    kept[153] = z286;
    const double z287 = z285 - (k17 * z213 + z286);
    const double z288 = k18 * z190;
    kept[154] = z288;
    const double z289 = k16 * z202 - z288;
    const double z290 = k17 * z190;
    kept[155] = z290;
    const double z291 = k16 * z206 + z290;
    const double z292 = k18 * z180;
    kept[156] = z292;
    const double z293 = k17 * z181;
    kept[157] = z293;
    const double z294 = z292 + (k16 * z213 + z293);
    const double z295 = z246 * z282 + (z253 * z284 - (z247 * z287 - (z263 * z289 + (z265 * z291 - z270 *
        z294))));
    const double z296 = z248 * z251 + (z255 * z257 - (z258 * z261 - (z267 * z269 - (z273 * z276 - (z277 *
        z279 + z295)))));
    const double z297 = z262 * z236;
    kept[158] = z297;
    const double z298 = 1.0 + z255;
    kept[159] = z298;
    const double z299 = z298 * z238;
    kept[160] = z299;
    const double z300 = s_pitch * s_lam - c_pitch * c_lam;
    const double z301 = s_steer * z300;
    const double z302 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20);
    const double z303 = k12 * z301 + s_steer * z302;
    const double z304 = k3 * z301;
    const double z305 = z15 * z301 - (s_lam * z303 + c_lam * z304);
    const double z306 = c_pitch * s_lam + s_pitch * c_lam;
    const double z307 = c_steer * z300;
    const double z308 = z37 * (s_lam * z306 - c_lam * z307) - z15 * (s_lam * z307 + c_lam * z306) + (k12 *
        z307 + k3 * z306 + c_steer * z302);
    const double z309 = z37 * z301 + (s_lam * z304 - c_lam * z303);
    const double z310 = z33 * z308 - z35 * z309;
    const double z311 = z41 * z308 - z39 * z309;
    const double z312 = z58 * (z42 * z305 + z28 * z310 - z27 * z311);
    const double z313 = c_roll * z312;
    const double z314 = s_pitch - c_pitch * z313;
    kept[161] = z314;
    const double z315 = c_pitch + s_pitch * z313;
    kept[162] = z315;
    const double z316 = c_lam * z314 + s_lam * z315;
    kept[163] = z316;
    const double z317 = z50 * z309 + z55 * z308;
    const double z318 = z58 * (z29 * z310 + z56 * z305 + z27 * z317) + e2z * z312;
    kept[164] = z318;
    const double z319 = c_lam * z315 - s_lam * z314;
    const double z320 = c_steer * z318 + s_steer * z319;
    kept[165] = z320;
    const double z321 = s_steer * z318 - c_steer * z319;
    kept[166] = z321;
    const double z322 = z58 * (z29 * z311 + z28 * z317 + z57 * z305) - z318;
    kept[167] = z322;
    const double z323 = z20 * z322;
    kept[168] = z323;
    const double z324 = z323 - k10 * z318;
    const double z325 = R3 * z322;
    kept[169] = z325;
    const double z326 = z325 - k9 * z318;
    const double z327 = c_lam * z324 + s_lam * z326;
    kept[170] = z327;
    const double z328 = R3 * z315 + z20 * z314;
    kept[171] = z328;
    const double z329 = z328 + (k10 * z314 + k9 * z315);
    const double z330 = c_lam * z326 - s_lam * z324;
    const double z331 = c_steer * z329 + s_steer * z330;
    kept[172] = z331;
    const double z332 = c_steer * z330 - s_steer * z329;
    kept[173] = z332;
    const double z333 = z314 * z282 + (z318 * z284 + (z315 * z287 + (z323 * z289 + (z325 * z291 + z328 *
        z294))));
    const double z334 = z316 * z251 + (z320 * z257 - (z321 * z261 - (z327 * z269 + (z331 * z276 + (z332 *
        z279 + z333)))));
    const double z335 = z322 * z236;
    kept[174] = z335;
    const double z336 = z320 * z238;
    kept[175] = z336;
    const double z337 = k3 + (z44 - z45);
    const double z338 = z33 * z337;
    const double z339 = z41 * z337;
    const double z340 = z58 * (z28 * z338 - z27 * z339);
    const double z341 = c_roll * z340;
    const double z342 = c_pitch * z341;
    kept[176] = z342;
    const double z343 = s_pitch * z341;
    kept[177] = z343;
    const double z344 = 1.0 - (c_lam * z342 - s_lam * z343);
    kept[178] = z344;
    const double z345 = z55 * z337;
    const double z346 = z58 * (z29 * z338 + z27 * z345) + e2z * z340;
    kept[179] = z346;
    const double z347 = c_lam * z343 + s_lam * z342;
    const double z348 = c_steer * z346 + s_steer * z347;
    kept[180] = z348;
    const double z349 = s_steer * z346 - c_steer * z347;
    kept[181] = z349;
    const double z350 = z58 * (z29 * z339 + z28 * z345) - z346;
    kept[182] = z350;
    const double z351 = z20 * z350;
    kept[183] = z351;
    const double z352 = z351 - k10 * z346;
    const double z353 = R3 * z350;
    kept[184] = z353;
    const double z354 = z353 - k9 * z346;
    const double z355 = c_lam * z352 + s_lam * z354;
    kept[185] = z355;
    const double z356 = R3 * z343 - z20 * z342;
    kept[186] = z356;
    const double z357 = z356 - (k10 * z342 - k9 * z343);
    const double z358 = c_lam * z354 - s_lam * z352;
    const double z359 = c_steer * z357 + s_steer * z358;
    kept[187] = z359;
    const double z360 = c_steer * z358 - s_steer * z357;
    kept[188] = z360;
    const double z361 = z342 * z282 - (z346 * z284 + (z343 * z287 + (z351 * z289 + (z353 * z291 + z356 *
        z294))));
    const double z362 = z344 * z251 + (z348 * z257 - (z349 * z261 - (z355 * z269 + (z359 * z276 + (z360 *
        z279 - z361)))));
    const double z363 = z350 * z236;
    kept[189] = z363;
    const double z364 = z348 * z238;
    kept[190] = z364;
    const double z365 = thF_ddot * (z296 + z297 + z299) - (roll_ddot * (z334 + z335 + z336) + steer_ddot *
        (z362 + z363 + z364));
    /* (I.4.1) 115:5 */
    /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    lambda[0] = z365 - (z183 - (z193 + (z196 + (z199 * z209 + z235))) + z237 - z239 + z241);
    const double z366 = c_yaw * e2z;
    const double e1y = c_pitch * s_yaw + s_pitch * z366;
    kept[191] = e1y;
    const double e3y = s_yaw * s_pitch - c_pitch * z366;
    kept[192] = e3y;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z367 = e1y * c_lam - e3y * s_lam;
    const double e2y = c_yaw * c_roll;
    kept[193] = e2y;
    const double f1y = c_steer * z367 + e2y * s_steer;
    const double h3y = c_lam * sy - s_lam * f1y;
    kept[194] = h3y;
    const double h2y = e2y * c_steer - s_steer * z367;
    const double h1y = c_lam * f1y + s_lam * sy;
    const double z368 = h2y * z33 + h1y * z35;
    const double z369 = h2y * z41 + h1y * z39;
    kept[195] = z369;
    const double z370 = z58 * (h3y * z42 + z28 * z368 - z27 * z369);
    const double z371 = c_roll * z370;
    kept[196] = z371;
    const double z372 = c_pitch * z371;
    kept[197] = z372;
    const double z373 = s_pitch * z371;
    kept[198] = z373;
    const double z374 = c_lam * z372 - s_lam * z373;
    kept[199] = z374;
    const double z375 = z171 * z374;
    kept[200] = z375;
    const double z376 = h1y * z50 - h2y * z55;
    kept[201] = z376;
    const double z377 = z58 * (z29 * z368 + h3y * z56 - z27 * z376) + e2z * z370;
    kept[202] = z377;
    const double z378 = c_lam * z373 + s_lam * z372;
    const double z379 = c_steer * z377 + s_steer * z378;
    kept[203] = z379;
    const double z380 = z188 * z379;
    kept[204] = z380;
    const double z381 = s_steer * z377 - c_steer * z378;
    kept[205] = z381;
    const double z382 = z194 * z381;
    kept[206] = z382;
    return BICYCLE_OK;
}

static int bicycle_reactions_part3(double t, const double *y, const double *p, const double *dydt, double
    *kept, double *lambda)
{
    (void)t;
    (void)y;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */
    const double e2z = kept[0];
    const double c_roll = kept[1];
    const double c_steer = kept[2];
    const double s_steer = kept[3];
    const double s_pitch = kept[4];
    const double c_pitch = kept[5];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k16 = kept[14];
    const double k17 = kept[15];
    const double k18 = kept[16];
    const double k20 = kept[17];
    const double k22 = kept[18];
    const double k23 = kept[19];
    const double k24 = kept[20];
    const double k26 = kept[21];
    const double k28 = kept[22];
    const double k31 = kept[23];
    const double k38 = kept[24];
    const double k39 = kept[25];
    const double k42 = kept[26];
    const double k45 = kept[27];
    const double k46 = kept[28];
    const double z1 = kept[39];
    const double e3z = kept[40];
    const double h2z = kept[41];
    const double R3 = kept[42];
    const double z10 = kept[45];
    const double z12 = kept[46];
    const double z20 = kept[48];
    const double z27 = kept[49];
    const double z28 = kept[50];
    const double z29 = kept[51];
    const double z33 = kept[52];
    const double z35 = kept[53];
    const double z39 = kept[55];
    const double z41 = kept[56];
    const double z42 = kept[57];
    const double z50 = kept[60];
    const double z55 = kept[61];
    const double z56 = kept[62];
    const double z57 = kept[63];
    const double z58 = kept[64];
    const double z161 = kept[97];
    const double z171 = kept[98];
    const double z183 = kept[99];
    const double z185 = kept[100];
    const double z188 = kept[101];
    const double z193 = kept[102];
    const double z194 = kept[103];
    const double z196 = kept[104];
    const double z199 = kept[105];
    const double z201 = kept[106];
    const double z203 = kept[107];
    const double z205 = kept[108];
    const double z207 = kept[109];
    const double z211 = kept[110];
    const double z212 = kept[111];
    const double z214 = kept[112];
    const double z218 = kept[113];
    const double z222 = kept[114];
    const double z223 = kept[115];
    const double z225 = kept[116];
    const double z226 = kept[117];
    const double z227 = kept[118];
    const double z228 = kept[119];
    const double z231 = kept[120];
    const double z233 = kept[121];
    const double z234 = kept[122];
    const double z237 = kept[123];
    const double z239 = kept[124];
    const double z240 = kept[125];
    const double z241 = kept[126];
    const double z246 = kept[127];
    const double z247 = kept[128];
    const double z248 = kept[129];
    const double z249 = kept[130];
    const double z250 = kept[131];
    const double z253 = kept[132];
    const double z255 = kept[133];
    const double z256 = kept[134];
    const double z258 = kept[135];
    const double z259 = kept[136];
    const double z260 = kept[137];
    const double z262 = kept[138];
    const double z263 = kept[139];
    const double z265 = kept[140];
    const double z267 = kept[141];
    const double z268 = kept[142];
    const double z270 = kept[143];
    const double z273 = kept[144];
    const double z274 = kept[145];
    const double z275 = kept[146];
    const double z277 = kept[147];
    const double z278 = kept[148];
    const double z280 = kept[149];
    const double z281 = kept[150];
    const double z283 = kept[151];
    const double z285 = kept[152];
    const double z286 = kept[153];
    const double z288 = kept[154];
    const double z290 = kept[155];
    const double z292 = kept[156];
    const double z293 = kept[157];
    const double z297 = kept[158];
    const double z298 = kept[159];
    const double z299 = kept[160];
    const double z314 = kept[161];
    const double z315 = kept[162];
    const double z316 = kept[163];
    const double z318 = kept[164];
    const double z320 = kept[165];
    const double z321 = kept[166];
    const double z322 = kept[167];
    const double z323 = kept[168];
    const double z325 = kept[169];
    const double z327 = kept[170];
    const double z328 = kept[171];
    const double z331 = kept[172];
    const double z332 = kept[173];
    const double z335 = kept[174];
    const double z336 = kept[175];
    const double z342 = kept[176];
    const double z343 = kept[177];
    const double z344 = kept[178];
    const double z346 = kept[179];
    const double z348 = kept[180];
    const double z349 = kept[181];
    const double z350 = kept[182];
    const double z351 = kept[183];
    const double z353 = kept[184];
    const double z355 = kept[185];
    const double z356 = kept[186];
    const double z359 = kept[187];
    const double z360 = kept[188];
    const double z363 = kept[189];
    const double z364 = kept[190];
    const double e1y = kept[191];
    const double e3y = kept[192];
    const double e2y = kept[193];
    const double h3y = kept[194];
    const double z369 = kept[195];
    const double z371 = kept[196];
    const double z372 = kept[197];
    const double z373 = kept[198];
    const double z374 = kept[199];
    const double z375 = kept[200];
    const double z376 = kept[201];
    const double z377 = kept[202];
    const double z379 = kept[203];
    const double z380 = kept[204];
    const double z381 = kept[205];
    const double z382 = kept[206];
    const double z383 = z58 * (z29 * z369 - z28 * z376 + h3y * z57) - z377;
    const double z384 = z20 * z383;
    const double z385 = e3y - z384;
    const double z386 = k10 * z377;
    const double z387 = z385 + z386;
    const double z388 = R3 * z383;
    const double z389 = e1y - z388;
    const double z390 = k9 * z377;
    const double z391 = z389 + z390;
    const double z392 = c_lam * z387 + s_lam * z391;
    const double z393 = R3 * z373 - z20 * z372;
    const double z394 = e2y + z393;
    const double z395 = k10 * z372 - k9 * z373;
    const double z396 = z394 - z395;
    const double z397 = c_lam * z391 - s_lam * z387;
    const double z398 = c_steer * z396 - s_steer * z397;
    const double z399 = c_steer * z397 + s_steer * z396;
    const double z400 = z222 * z372;
    const double z401 = z225 * z377;
    const double z402 = z227 * z373;
    const double z403 = z211 * z398 - (z218 * z399 + (z400 - (z401 - (z402 - (z231 * z385 - (z233 * z389 -
        z234 * z394))))));
    const double z404 = R_yy * z383;
    const double z405 = z161 * z404;
    const double z406 = F_yy * z379;
    const double z407 = z185 * z406;
    const double z408 = z371 * z240;
    const double z409 = k46 * z374;
    const double z410 = k45 * z381;
    const double z411 = z409 - (k31 * z398 - z410);
    const double z412 = k42 * z379;
    const double z413 = z412 - (k28 * z399 - k31 * z392);
    const double z414 = k39 * z374;
    const double z415 = k38 * z381;
    const double z416 = z414 + (k28 * z398 + z415);
    const double z417 = k31 * z379;
    const double z418 = k26 * z392 + z417;
    const double z419 = k31 * z374;
    const double z420 = k28 * z381;
    const double z421 = z419 - (k26 * z398 + z420);
    const double z422 = k28 * z379;
    const double z423 = k26 * z399 - z422;
    const double z424 = k24 * z372;
    const double z425 = k23 * z373;
    const double z426 = z424 - (k18 * z394 + z425);
    const double z427 = k22 * z377;
    const double z428 = z427 - (k17 * z389 - k18 * z385);
    const double z429 = k23 * z372;
    const double z430 = k20 * z373;
    const double z431 = z429 + (k17 * z394 - z430);
    const double z432 = k18 * z377;
    const double z433 = k16 * z385 + z432;
    const double z434 = k17 * z377;
    const double z435 = k16 * z389 - z434;
    const double z436 = k18 * z372;
    const double z437 = k17 * z373;
    const double z438 = z436 - (k16 * z394 - z437);
    const double z439 = z246 * z426 - (z253 * z428 + (z247 * z431 - (z263 * z433 + (z265 * z435 - z270 *
        z438))));
    const double z440 = z248 * z411 - (z255 * z413 + (z258 * z416 - (z267 * z418 - (z273 * z421 - (z277 *
        z423 + z439)))));
    const double z441 = z262 * z404;
    const double z442 = z298 * z406;
    const double z443 = z314 * z426 - (z318 * z428 - (z315 * z431 + (z323 * z433 + (z325 * z435 + z328 *
        z438))));
    const double z444 = z316 * z411 - (z320 * z413 + (z321 * z416 - (z327 * z418 + (z331 * z421 + (z332 *
        z423 + z443)))));
    const double z445 = z322 * z404;
    const double z446 = z320 * z406;
    const double z447 = z342 * z426 + (z346 * z428 - (z343 * z431 + (z351 * z433 + (z353 * z435 + z356 *
        z438))));
    const double z448 = z344 * z411 - (z348 * z413 + (z349 * z416 - (z355 * z418 + (z359 * z421 + (z360 *
        z423 - z447)))));
    const double z449 = z350 * z404;
    const double z450 = z348 * z406;
    const double z451 = thF_ddot * (z440 - z441 - z442) - (roll_ddot * (z444 - z445 - z446) + steer_ddot *
        (z448 - z449 - z450));
    /* (I.4.1) 116:5 */
    /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    lambda[1] = z451 - (z375 + (z380 + (z382 - (z199 * z392 - z403))) - z405 + z407 + z408);
    const double z452 = h2z * z33 - z10 * z35;
    const double z453 = h2z * z41 - z10 * z39;
    const double z454 = z58 * (z12 * z42 - z28 * z452 + z27 * z453);
    const double z455 = c_roll * z454;
    const double z456 = c_pitch * z455;
    const double z457 = s_pitch * z455;
    const double z458 = c_lam * z456 - s_lam * z457;
    const double z459 = z171 * z458;
    const double z460 = z10 * z50 + h2z * z55;
    const double z461 = z58 * (z29 * z452 - z12 * z56 + z27 * z460) - e2z * z454;
    const double z462 = c_lam * z457 + s_lam * z456;
    const double z463 = c_steer * z461 - s_steer * z462;
    const double z464 = z188 * z463;
    const double z465 = s_steer * z461 + c_steer * z462;
    const double z466 = z194 * z465;
    const double z467 = z58 * (z29 * z453 + z28 * z460 - z12 * z57) - z461;
    const double z468 = z20 * z467;
    const double z469 = e3z - z468;
    const double z470 = k10 * z461;
    const double z471 = z469 + z470;
    const double z472 = R3 * z467;
    const double z473 = z1 + z472;
    const double z474 = k9 * z461;
    const double z475 = z473 - z474;
    const double z476 = c_lam * z471 - s_lam * z475;
    const double z477 = R3 * z457 - z20 * z456;
    const double z478 = e2z - z477;
    const double z479 = k10 * z456 - k9 * z457;
    const double z480 = z478 + z479;
    const double z481 = c_lam * z475 + s_lam * z471;
    const double z482 = c_steer * z480 + s_steer * z481;
    const double z483 = c_steer * z481 - s_steer * z480;
    const double z484 = z222 * z456;
    const double z485 = z225 * z461;
    const double z486 = z227 * z457;
    const double z487 = z211 * z482 + (z218 * z483 + (z484 + (z485 + (z486 + (z231 * z469 + (z233 * z473 +
        z234 * z478))))));
    const double z488 = R_yy * z467;
    const double z489 = z161 * z488;
    const double z490 = F_yy * z463;
    const double z491 = z185 * z490;
    const double z492 = z455 * z240;
    const double z493 = k46 * z458;
    const double z494 = k45 * z465;
    const double z495 = z493 + (k31 * z482 - z494);
    const double z496 = k42 * z463;
    const double z497 = z496 + (k28 * z483 + k31 * z476);
    const double z498 = k39 * z458;
    const double z499 = k38 * z465;
    const double z500 = z498 - (k28 * z482 + z499);
    const double z501 = k31 * z463;
    const double z502 = k26 * z476 + z501;
    const double z503 = k31 * z458;
    const double z504 = k28 * z465;
    const double z505 = z503 + (k26 * z482 + z504);
    const double z506 = k28 * z463;
    const double z507 = k26 * z483 + z506;
    const double z508 = k24 * z456;
    const double z509 = k23 * z457;
    const double z510 = z508 + (k18 * z478 - z509);
    const double z511 = k22 * z461;
    const double z512 = z511 + (k17 * z473 + k18 * z469);
    const double z513 = k23 * z456;
    const double z514 = k20 * z457;
    const double z515 = z513 - (k17 * z478 + z514);
    const double z516 = k18 * z461;
    const double z517 = k16 * z469 + z516;
    const double z518 = k17 * z461;
    const double z519 = k16 * z473 + z518;
    const double z520 = k18 * z456;
    const double z521 = k17 * z457;
    const double z522 = z520 + (k16 * z478 + z521);
    const double z523 = z246 * z510 + (z253 * z512 - (z247 * z515 + (z263 * z517 - (z265 * z519 - z270 *
        z522))));
    const double z524 = z248 * z495 + (z255 * z497 - (z258 * z500 + (z267 * z502 + (z273 * z505 - (z277 *
        z507 + z523)))));
    const double z525 = z262 * z488;
    const double z526 = z298 * z490;
    const double z527 = z314 * z510 + (z318 * z512 + (z315 * z515 - (z323 * z517 - (z325 * z519 + z328 *
        z522))));
    const double z528 = z316 * z495 + (z320 * z497 - (z321 * z500 + (z327 * z502 - (z331 * z505 + (z332 *
        z507 + z527)))));
    const double z529 = z322 * z488;
    const double z530 = z320 * z490;
    const double z531 = z342 * z510 - (z346 * z512 + (z343 * z515 - (z351 * z517 - (z353 * z519 + z356 *
        z522))));
    const double z532 = z344 * z495 + (z348 * z497 - (z349 * z500 + (z355 * z502 - (z359 * z505 + (z360 *
        z507 - z531)))));
    const double z533 = z350 * z488;
    const double z534 = z348 * z490;
    const double z535 = thF_ddot * (z524 + z525 + z526) - (roll_ddot * (z528 + z529 + z530) + steer_ddot *
        (z532 + z533 + z534));
    /* (I.4.1) 117:5 */
    /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    lambda[2] = z459 - (z464 + (z466 - (z199 * z476 - z487))) + z489 - z491 + z492 - z535;
    const double z536 = z201 - z203;
    const double z537 = z205 - z207;
    const double z538 = c_lam * z536 + s_lam * z537;
    const double z539 = z212 - z214;
    const double z540 = c_lam * z537 - s_lam * z536;
    const double z541 = c_steer * z539 - s_steer * z540;
    const double z542 = c_steer * z540 + s_steer * z539;
    const double z543 = z211 * z541 - (z218 * z542 + (z223 + (z226 + (z228 - (z231 * z201 - (z233 * z205 -
        z234 * z212))))));
    const double z544 = z249 - (z250 + k31 * z541);
    const double z545 = z256 + (k28 * z542 - k31 * z538);
    const double z546 = z259 - (z260 - k28 * z541);
    const double z547 = z268 - k26 * z538;
    const double z548 = z274 + (z275 - k26 * z541);
    const double z549 = z278 + k26 * z542;
    const double z550 = z280 - (z281 + k18 * z212);
    const double z551 = z283 + (k17 * z205 - k18 * z201);
    const double z552 = z285 - (z286 - k17 * z212);
    const double z553 = z288 - k16 * z201;
    const double z554 = z290 + k16 * z205;
    const double z555 = z292 + (z293 - k16 * z212);
    const double z556 = z246 * z550 + (z253 * z551 - (z247 * z552 + (z263 * z553 - (z265 * z554 - z270 *
        z555))));
    const double z557 = z248 * z544 + (z255 * z545 - (z258 * z546 + (z267 * z547 + (z273 * z548 - (z277 *
        z549 + z556)))));
    const double z558 = z314 * z550 + (z318 * z551 + (z315 * z552 - (z323 * z553 - (z325 * z554 + z328 *
        z555))));
    const double z559 = z316 * z544 + (z320 * z545 - (z321 * z546 + (z327 * z547 - (z331 * z548 + (z332 *
        z549 + z558)))));
    const double z560 = z342 * z550 - (z346 * z551 + (z343 * z552 - (z351 * z553 - (z353 * z554 + z356 *
        z555))));
    const double z561 = z344 * z544 + (z348 * z545 - (z349 * z546 + (z355 * z547 - (z359 * z548 + (z360 *
        z549 - z560)))));
    const double z562 = thF_ddot * (z299 + (z557 + z297)) - (roll_ddot * (z336 + (z559 + z335)) + steer_ddot
        * (z364 + (z561 + z363)));
    /* (I.4.1) 118:5 */
    /* reaction of front_x: Q_i gains lambda_4 a_4i */
    lambda[3] = z241 - (z239 - (z237 + (z183 - (z193 + (z196 + (z199 * z538 - z543)))))) - z562;
    const double z563 = z384 - z386;
    const double z564 = z388 - z390;
    const double z565 = c_lam * z563 + s_lam * z564;
    const double z566 = z393 - z395;
    const double z567 = c_lam * z564 - s_lam * z563;
    const double z568 = c_steer * z566 + s_steer * z567;
    const double z569 = c_steer * z567 - s_steer * z566;
    const double z570 = z211 * z568 + (z218 * z569 - (z400 - (z401 - (z402 + (z231 * z384 - (z233 * z388 +
        z234 * z393))))));
    const double z571 = z409 + (z410 - k31 * z568);
    const double z572 = z412 + (k28 * z569 - k31 * z565);
    const double z573 = z414 + (z415 + k28 * z568);
    const double z574 = z417 - k26 * z565;
    const double z575 = z419 - (z420 + k26 * z568);
    const double z576 = z422 + k26 * z569;
    const double z577 = z424 - (z425 + k18 * z393);
    const double z578 = z427 + (k17 * z388 - k18 * z384);
    const double z579 = z429 - (z430 - k17 * z393);
    const double z580 = z432 - k16 * z384;
    const double z581 = z434 + k16 * z388;
    const double z582 = z436 + (z437 - k16 * z393);
    const double z583 = z246 * z577 - (z253 * z578 + (z247 * z579 - (z263 * z580 - (z265 * z581 + z270 *
        z582))));
    const double z584 = z248 * z571 - (z255 * z572 + (z258 * z573 - (z267 * z574 - (z273 * z575 + (z277 *
        z576 - z583)))));
    const double z585 = z314 * z577 - (z318 * z578 - (z315 * z579 + (z323 * z580 - (z325 * z581 - z328 *
        z582))));
    const double z586 = z316 * z571 - (z320 * z572 + (z321 * z573 - (z327 * z574 + (z331 * z575 - (z332 *
        z576 - z585)))));
    const double z587 = z342 * z577 + (z346 * z578 - (z343 * z579 + (z351 * z580 - (z353 * z581 - z356 *
        z582))));
    const double z588 = z344 * z571 - (z348 * z572 + (z349 * z573 - (z355 * z574 + (z359 * z575 - (z360 *
        z576 + z587)))));
    const double z589 = thF_ddot * (z442 - (z584 - z441)) - (roll_ddot * (z446 - (z586 - z445)) + steer_ddot
        * (z450 - (z588 - z449)));
    /* (I.4.1) 119:5 */
    /* reaction of front_y: Q_i gains lambda_5 a_5i */
    lambda[4] = z408 + (z407 - (z405 - (z375 + (z380 + (z382 + (z199 * z565 + z570)))))) + z589;
    const double z590 = z468 - z470;
    const double z591 = z472 - z474;
    const double z592 = c_lam * z590 + s_lam * z591;
    const double z593 = z477 - z479;
    const double z594 = c_lam * z591 - s_lam * z590;
    const double z595 = c_steer * z593 - s_steer * z594;
    const double z596 = c_steer * z594 + s_steer * z593;
    const double z597 = z211 * z595 - (z218 * z596 + (z484 + (z485 + (z486 - (z231 * z468 - (z233 * z472 -
        z234 * z477))))));
    const double z598 = z493 - (z494 + k31 * z595);
    const double z599 = z496 + (k28 * z596 - k31 * z592);
    const double z600 = z498 - (z499 - k28 * z595);
    const double z601 = z501 - k26 * z592;
    const double z602 = z503 + (z504 - k26 * z595);
    const double z603 = z506 + k26 * z596;
    const double z604 = z508 - (z509 + k18 * z477);
    const double z605 = z511 + (k17 * z472 - k18 * z468);
    const double z606 = z513 - (z514 - k17 * z477);
    const double z607 = z516 - k16 * z468;
    const double z608 = z518 + k16 * z472;
    const double z609 = z520 + (z521 - k16 * z477);
    const double z610 = z246 * z604 + (z253 * z605 - (z247 * z606 + (z263 * z607 - (z265 * z608 - z270 *
        z609))));
    const double z611 = z248 * z598 + (z255 * z599 - (z258 * z600 + (z267 * z601 + (z273 * z602 - (z277 *
        z603 + z610)))));
    const double z612 = z314 * z604 + (z318 * z605 + (z315 * z606 - (z323 * z607 - (z325 * z608 + z328 *
        z609))));
    const double z613 = z316 * z598 + (z320 * z599 - (z321 * z600 + (z327 * z601 - (z331 * z602 + (z332 *
        z603 + z612)))));
    const double z614 = z342 * z604 - (z346 * z605 + (z343 * z606 - (z351 * z607 - (z353 * z608 + z356 *
        z609))));
    const double z615 = z344 * z598 + (z348 * z599 - (z349 * z600 + (z355 * z601 - (z359 * z602 + (z360 *
        z603 - z614)))));
    const double z616 = thF_ddot * (z526 + (z611 + z525)) - (roll_ddot * (z530 + (z613 + z529)) + steer_ddot
        * (z534 + (z615 + z533)));
    /* (I.4.1) 120:5 */
    /* reaction of front_z: Q_i gains lambda_6 a_6i */
    lambda[5] = z616 - (z492 - (z491 - (z489 + (z459 - (z464 + (z466 + (z199 * z592 - z597)))))));
    return BICYCLE_OK;
}

int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[207]; /* what parts of this function leave for others */
    double dydt[12];
    const int status1 = bicycle_rhs(t, y, p, dydt);
    if (status1 != BICYCLE_OK) {
        return status1;
    }
    int status = bicycle_reactions_part1(t, y, p, dydt, kept, lambda);
    if (status == BICYCLE_OK) {
        status = bicycle_reactions_part2(t, y, p, dydt, kept, lambda);
    }
    if (status == BICYCLE_OK) {
        status = bicycle_reactions_part3(t, y, p, dydt, kept, lambda);
    }
    if (status != BICYCLE_OK) {
        return status;
    }
    return bicycle_finish(6, lambda);
}

double bicycle_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
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
    const double k4 = r_F * s_lam - c * c_lam;
    const double k5 = c_lam * k2 - r_R * s_lam;
    const double k6 = s_lam * k5;
    const double k7 = c_lam * k5;
    const double k8 = c_lam * c_lam;
    const double k9 = w * s_lam + c_lam * (r_R - r_F);
    const double k10 = s_lam * k4 - c_lam * k9;
    const double k11 = s_lam * s_lam;
    const double k12 = c_lam * k4 + s_lam * k9;

    /* state */
    const double z1 = s_pitch * c_roll;
    const double e3z = c_pitch * c_roll;
    const double z2 = r_R * e3z;
    const double Sz = z - z1 * k2 + z2;
    const double z3 = z1 * c_lam + e3z * s_lam;
    const double z4 = c_steer * z3 - e2z * s_steer;
    const double z5 = z1 * s_lam - e3z * c_lam;
    const double z6 = c_lam * z4 + s_lam * z5;
    const double z7 = c_lam * z5 - s_lam * z4;
    const double z8 = z * m_R + m_B * (z - x_B * z1 + e3z * k1) + m_H * (Sz + z6 * k3 - z_H * z7);
    const double z9 = r_F * z7;
    const double z10 = 1.0 / sqrt(z1 * z1 + e3z * e3z);
    const double z11 = r_R * (z1 * z10);
    const double z12 = s_lam * s_steer;
    const double R3 = z2 * z10;
    const double z13 = R3 + k6;
    const double z14 = 1.0 / sqrt(z6 * z6 + z7 * z7);
    const double z15 = r_F * (z6 * z14);
    const double z16 = k12 - z15;
    const double z17 = s_steer * z16;
    const double z18 = k7 + z11;
    const double z19 = s_lam * c_steer;
    const double z20 = k8 + s_lam * z19;
    const double z21 = c_lam * (s_lam - z19);
    const double z22 = R3 * z21 + z20 * z11;
    const double z23 = k7 * z20 + k6 * z21 + z22 + c_steer * z16;
    const double z24 = c_roll * (s_pitch * (z12 * z13 - c_lam * z17) - c_pitch * (z12 * z18 + s_lam * z17)) -
        e2z * z23;
    const double z25 = c_lam * c_steer;
    const double z26 = c_lam * z25 + k11;
    const double z27 = s_lam * (c_lam - z25);
    const double z28 = R3 * z26 + z27 * z11;
    const double z29 = c_lam * s_steer;
    const double z30 = R3 * z29 - z12 * z11;
    const double z31 = z9 * z14;
    const double z32 = k9 - c_lam * z31 - s_lam * z15;
    const double z33 = z29 * k6 - z12 * k7 + z30 - s_steer * z32;
    const double z34 = z31 + k10;
    const double z35 = c_steer * z34 + (k7 * z27 + k6 * z26 + z28);
    const double z36 = z28 * z33 - z35 * z30;
    const double z37 = c_steer * z32;
    const double z38 = k4 + s_lam * z31 - c_lam * z15;
    const double z39 = s_pitch * (c_steer * z13 - c_lam * z37 + s_lam * z38) - c_pitch * (c_steer * z18 +
        s_lam * z37 + c_lam * z38);
    const double z40 = c_roll * z39 - e2z * z33;
    const double z41 = s_steer * z34;
    const double z42 = c_roll * (s_pitch * (z29 * z13 + c_lam * z41) + c_pitch * (s_lam * z41 - z29 * z18)) +
        e2z * z35;
    const double z43 = z28 * z40 + z42 * z30;
    const double z44 = z35 * z40 + z42 * z33;
    const double z45 = 1.0 / (z24 * z36 - z23 * z43 + z22 * z44);
    const double z46 = roll_dot * c_pitch;
    const double z47 = roll_dot * s_pitch;
    const double z48 = steer_dot + (s_lam * z46 + c_lam * z47);
    const double z49 = s_lam * z47 - c_lam * z46;
    const double z50 = c_steer * z49;
    const double z51 = z46 * k6 + z47 * k7 + (z46 * R3 + z47 * z11);
    const double z52 = z31 * (s_lam * z48 - c_lam * z50) - (s_lam * z50 + c_lam * z48) * z15 + (k9 * z50 + k4
        * z48 + c_steer * z51);
    const double z53 = s_steer * z49;
    const double z54 = thF_dot + z53;
    const double z55 = k4 * z53;
    const double z56 = k9 * z53 + s_steer * z51;
    const double z57 = z31 * z54 + (s_lam * z55 - c_lam * z56);
    const double z58 = z35 * z52 - z33 * z57;
    const double z59 = z40 * z57 + z42 * z52;
    const double z60 = z54 * z15 - (c_lam * z55 + s_lam * z56);
    const double z61 = z28 * z52 - z30 * z57;
    const double z62 = z45 * (z24 * z61 + z43 * z60 + z22 * z59);
    const double z63 = z45 * (z36 * z60 + z23 * z61 - z22 * z58);
    const double z64 = z62 + e2z * z63;
    const double z65 = z45 * (z24 * z58 + z23 * z59 + z44 * z60) - z64;
    const double a3 = z11 * z65;
    const double a1 = R3 * z65;
    const double z66 = s_pitch * a3 + c_pitch * a1;
    const double z67 = s_pitch * a1 - c_pitch * a3;
    const double z68 = c_roll * z63;
    const double v2_x = R3 * (z46 + s_pitch * z68) + z11 * (z47 - c_pitch * z68);
    const double z69 = e2z * z67 - c_roll * v2_x;
    const double z70 = c_yaw * z66 - s_yaw * z69;
    const double z71 = s_yaw * z63;
    const double z72 = s_pitch * z62;
    const double z73 = roll_dot * c_roll;
    const double z74 = c_yaw * z63;
    const double z75 = s_yaw * z73 - e2z * z74;
    const double z76 = s_yaw * e2z;
    const double z77 = c_pitch * z62;
    const double z78 = c_pitch * z71 + c_yaw * z72 - (s_pitch * z75 - z76 * z77);
    const double z79 = s_pitch * z71 - c_yaw * z77 + (z76 * z72 + c_pitch * z75);
    const double z80 = z70 - k2 * z78 - r_R * z79;
    const double z81 = steer_dot * s_steer;
    const double z82 = ((c_yaw * c_pitch - z76 * s_pitch) * c_lam - (c_yaw * s_pitch + c_pitch * z76) *
        s_lam) * z81 - c_steer * (c_lam * z78 - s_lam * z79);
    const double z83 = steer_dot * c_steer;
    const double z84 = c_roll * z83;
    const double z85 = roll_dot * e2z;
    const double z86 = z82 + (s_yaw * z84 - s_steer * (s_yaw * z85 + c_roll * z74));
    const double z87 = s_lam * z78 + c_lam * z79;
    const double z88 = c_lam * z86 - s_lam * z87;
    const double z89 = c_lam * z87 + s_lam * z86;
    const double z90 = z80 - c * z88 + r_F * z89;
    const double z91 = s_yaw * z66 + c_yaw * z69;
    const double z92 = c_yaw * e2z;
    const double z93 = c_yaw * z73 + e2z * z71;
    const double z94 = s_yaw * z72 - c_pitch * z74 - (z92 * z77 - s_pitch * z93);
    const double z95 = s_pitch * z74 + s_yaw * z77 + (z92 * z72 + c_pitch * z93);
    const double z96 = z91 - k2 * z94 + r_R * z95;
    const double z97 = ((c_pitch * s_yaw + s_pitch * z92) * c_lam - (s_yaw * s_pitch - c_pitch * z92) *
        s_lam) * z81 - c_steer * (c_lam * z94 + s_lam * z95);
    const double z98 = z97 - (c_yaw * z84 - s_steer * (c_yaw * z85 - c_roll * z71));
    const double z99 = s_lam * z94 - c_lam * z95;
    const double z100 = c_lam * z98 - s_lam * z99;
    const double z101 = c_lam * z99 + s_lam * z98;
    const double z102 = z96 - c * z100 + r_F * z101;
    const double z103 = s_pitch * z85 + c_roll * z77;
    const double z104 = c_pitch * z85 - c_roll * z72;
    const double z105 = s_lam * z103 - c_lam * z104;
    const double z106 = s_steer * z73 + e2z * z83 + (z3 * z81 + c_steer * (c_lam * z103 + s_lam * z104));
    const double z107 = c_lam * z105 - s_lam * z106;
    const double z108 = c_roll * z67 + e2z * v2_x;
    const double z109 = r_R * z104 - (z108 + k2 * z103);
    const double z110 = c_lam * z106 + s_lam * z105;
    const double z111 = r_F * z107 + (z109 + c * z110);
    const double w1 = z46 + z1 * z63;
    const double w3 = z47 - e3z * z63;
    const double z112 = c_lam * w1 - s_lam * w3;
    const double z113 = s_steer * z64 - c_steer * z112;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double z114 = c_lam * z113 - s_lam * ws;
    const double z115 = z114 * z114;
    const double o3 = c_lam * ws + s_lam * z113;
    const double z116 = o3 * o3;
    const double z117 = c_steer * z64 + s_steer * z112;
    const double z118 = thF_dot - z117;
    const double z119 = m_F * (z90 * z90 + z102 * z102 + z111 * z111) + F_xx * (z115 + z116) + F_yy * (z118 *
        z118);
    const double z120 = z80 - k3 * z88 - z_H * z89;
    const double z121 = z96 - k3 * z100 - z_H * z101;
    const double z122 = z109 + k3 * z110 - z_H * z107;
    const double z123 = m_H * (z120 * z120 + z121 * z121 + z122 * z122) + (H_xx * z115 + H_yy * (z117 * z117)
        + H_zz * z116);
    const double z124 = w1 * w1;
    const double z125 = w3 * w3;
    const double z126 = m_R * (z70 * z70 + z91 * z91 + z108 * z108) + R_xx * (z124 + z125) + R_yy * (z65 *
        z65);
    const double z127 = z70 - x_B * z78 - k1 * z79;
    const double z128 = z91 - x_B * z94 + k1 * z95;
    const double Bz_dot = z108 + x_B * z103 - k1 * z104;
    const double z129 = m_B * (z127 * z127 + z128 * z128 + Bz_dot * Bz_dot) + (B_xx * z124 + B_yy * (z64 *
        z64) + B_zz * z125);
    const double z130 = 0.5 * z123 - H_xz * (z114 * o3) + (0.5 * z126 + (0.5 * z129 + B_xz * (w1 * w3)));
    return 0.5 * z119 + z130 - g * (z8 + m_F * (Sz + c * z6 + z9));
}

static int bicycle_jacobian_part1(double t, const double *y, const double *p, double *kept, double *J)
{
    (void)J;
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
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

    /* sines and cosines */
    const double c_roll = cos(roll);
    kept[0] = c_roll;
    const double e2z = sin(roll);
    kept[1] = e2z;
    const double s_pitch = sin(pitch);
    kept[2] = s_pitch;
    const double c_pitch = cos(pitch);
    kept[3] = c_pitch;
    const double s_steer = sin(steer);
    kept[4] = s_steer;
    const double c_steer = cos(steer);
    kept[5] = c_steer;
    const double s_yaw = sin(yaw);
    kept[6] = s_yaw;
    const double c_yaw = cos(yaw);
    kept[7] = c_yaw;

    /* parameters only */
    const double s_lam = sin(lam);
    kept[8] = s_lam;
    const double c_lam = cos(lam);
    kept[9] = c_lam;
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = r_F * s_lam - c * c_lam;
    kept[10] = k3;
    const double k4 = H_zz + F_xx;
    const double k5 = H_xx + F_xx;
    const double k6 = z_H * s_lam - c_lam * (x_H - k2);
    const double k7 = x_H * s_lam + c_lam * (r_R + z_H);
    const double k8 = c_lam * k2 - r_R * s_lam;
    const double k9 = s_lam * k8;
    kept[11] = k9;
    const double k10 = c_lam * k8;
    kept[12] = k10;
    const double k11 = c_lam * c_lam;
    const double k12 = w * s_lam + c_lam * (r_R - r_F);
    kept[13] = k12;
    const double k13 = s_lam * k3 - c_lam * k12;
    const double k14 = s_lam * s_lam;
    const double k15 = c_lam * k3 + s_lam * k12;
    const double k16 = fabs(r_R);
    kept[14] = k16;
    const double k17 = fabs(r_F);
    kept[15] = k17;
    const double k18 = fabs(w);
    kept[16] = k18;
    const double k19 = fabs(c);
    kept[17] = k19;
    const double k20 = 18.0 * k19 + (18.0 * k18 + (34.0 * k16 + 19.0 * k17));
    kept[18] = k20;
    const double k21 = m_R + m_B;
    kept[19] = k21;
    const double k22 = m_B * k1;
    kept[20] = k22;
    const double k23 = x_B * m_B;
    kept[21] = k23;
    const double k24 = k1 * k22;
    const double k25 = R_xx + B_xx + k24;
    kept[22] = k25;
    const double k26 = x_B * k23;
    const double k27 = k24 + (B_yy + k26);
    kept[23] = k27;
    const double k28 = B_xz - k1 * k23;
    kept[24] = k28;
    const double k29 = R_xx + B_zz + k26;
    kept[25] = k29;
    const double k30 = m_F * k12;
    const double k31 = m_H + m_F;
    kept[26] = k31;
    const double k32 = m_H * k7;
    const double k33 = k30 + k32;
    kept[27] = k33;
    const double k34 = m_F * k3;
    const double k35 = m_H * k6;
    const double k36 = k34 - k35;
    kept[28] = k36;
    const double k37 = H_xz * c_lam;
    const double k38 = s_lam * k4 - k37;
    const double k39 = H_xz * s_lam;
    const double k40 = c_lam * k5 - k39;
    const double k41 = k12 * k30;
    const double k42 = k7 * k32;
    const double k43 = c_lam * k40 + s_lam * k38 + k41 + k42;
    kept[29] = k43;
    const double k44 = s_lam * k40 - c_lam * k38 - k3 * k30 + k6 * k32;
    kept[30] = k44;
    const double k45 = k3 * k34;
    const double k46 = k6 * k35;
    const double k47 = k42 + (k41 + (H_yy + k45) + k46);
    kept[31] = k47;
    const double k48 = k39 + c_lam * k4;
    const double k49 = k37 + s_lam * k5;
    const double k50 = c_lam * k49 - s_lam * k48 - k12 * k34 + k7 * k35;
    kept[32] = k50;
    const double k51 = k46 + (k45 + (s_lam * k49 + c_lam * k48));
    kept[33] = k51;
    const double k52 = g * m_F;
    const double k53 = g * m_H;
    const double k54 = g * m_B;
    const double k55 = g * k21;
    kept[34] = k55;
    const double k56 = x_B * k54;
    kept[35] = k56;
    const double k57 = k1 * k54;
    kept[36] = k57;
    const double k58 = k6 * k53;
    kept[37] = k58;
    const double k59 = k7 * k53;
    kept[38] = k59;
    const double k60 = g * k31;
    kept[39] = k60;
    const double k61 = k3 * k52;
    kept[40] = k61;
    const double k62 = k12 * k52;
    kept[41] = k62;
    const double k63 = k59 + k62;
    kept[42] = k63;
    const double k64 = k58 - k61;
    kept[43] = k64;

    /* state */
    const double z1 = s_lam * s_steer;
    kept[44] = z1;
    const double e3z = c_pitch * c_roll;
    kept[45] = e3z;
    const double z2 = r_R * e3z;
    kept[46] = z2;
    const double z3 = s_pitch * c_roll;
    kept[47] = z3;
    const double z4 = z3 * z3 + e3z * e3z;
    kept[48] = z4;
    const double z5 = 1.0 / sqrt(z4);
    kept[49] = z5;
    const double R3 = z2 * z5;
    kept[50] = R3;
    const double z6 = R3 + k9;
    kept[51] = z6;
    const double z7 = z3 * c_lam + e3z * s_lam;
    kept[52] = z7;
    const double z8 = c_steer * z7 - e2z * s_steer;
    kept[53] = z8;
    const double z9 = z3 * s_lam - e3z * c_lam;
    kept[54] = z9;
    const double z10 = c_lam * z8 + s_lam * z9;
    kept[55] = z10;
    const double z11 = r_F * z10;
    kept[56] = z11;
    const double z12 = c_lam * z9 - s_lam * z8;
    kept[57] = z12;
    const double z13 = z10 * z10 + z12 * z12;
    kept[58] = z13;
    const double z14 = 1.0 / sqrt(z13);
    kept[59] = z14;
    const double z15 = z11 * z14;
    kept[60] = z15;
    const double z16 = z15 - k15;
    kept[61] = z16;
    const double z17 = s_steer * z16;
    kept[62] = z17;
    const double z18 = z1 * z6 + c_lam * z17;
    kept[63] = z18;
    const double z19 = r_R * z3;
    kept[64] = z19;
    const double z20 = z19 * z5;
    kept[65] = z20;
    const double z21 = z20 + k10;
    kept[66] = z21;
    const double z22 = z1 * z21 - s_lam * z17;
    kept[67] = z22;
    const double z23 = s_pitch * z18 - c_pitch * z22;
    kept[68] = z23;
    const double z24 = s_lam * c_steer;
    kept[69] = z24;
    const double z25 = k11 + s_lam * z24;
    kept[70] = z25;
    const double z26 = c_lam * (s_lam - z24);
    kept[71] = z26;
    const double z27 = z20 * z25 + R3 * z26;
    kept[72] = z27;
    const double z28 = c_steer * z16;
    kept[73] = z28;
    const double z29 = k10 * z25 + k9 * z26 + z27 - z28;
    kept[74] = z29;
    const double z30 = c_roll * z23 - e2z * z29;
    kept[75] = z30;
    const double z31 = c_lam * c_steer;
    kept[76] = z31;
    const double z32 = s_lam * (c_lam - z31);
    kept[77] = z32;
    const double z33 = c_lam * z31 + k14;
    kept[78] = z33;
    const double z34 = z20 * z32 + R3 * z33;
    kept[79] = z34;
    const double z35 = c_lam * s_steer;
    kept[80] = z35;
    const double z36 = R3 * z35;
    kept[81] = z36;
    const double z37 = z20 * z1;
    kept[82] = z37;
    const double z38 = z36 - z37;
    kept[83] = z38;
    const double z39 = r_F * z12;
    kept[84] = z39;
    const double z40 = z39 * z14;
    kept[85] = z40;
    const double z41 = k12 - c_lam * z40 - s_lam * z15;
    kept[86] = z41;
    const double z42 = s_steer * z41;
    kept[87] = z42;
    const double z43 = z35 * k9 - z1 * k10 + z38 - z42;
    kept[88] = z43;
    const double z44 = z40 + k13;
    kept[89] = z44;
    const double z45 = c_steer * z44;
    kept[90] = z45;
    const double z46 = k10 * z32 + k9 * z33 + z34 + z45;
    kept[91] = z46;
    const double z47 = z34 * z43 - z46 * z38;
    kept[92] = z47;
    const double z48 = c_steer * z41;
    kept[93] = z48;
    const double z49 = s_lam * z40;
    const double z50 = c_lam * z15;
    const double z51 = k3 + z49 - z50;
    const double z52 = c_steer * z6 - c_lam * z48 + s_lam * z51;
    kept[94] = z52;
    const double z53 = c_steer * z21 + s_lam * z48 + c_lam * z51;
    kept[95] = z53;
    const double z54 = s_pitch * z52 - c_pitch * z53;
    kept[96] = z54;
    const double z55 = c_roll * z54 - e2z * z43;
    kept[97] = z55;
    const double z56 = s_steer * z44;
    kept[98] = z56;
    const double z57 = z35 * z6 + c_lam * z56;
    kept[99] = z57;
    const double z58 = z35 * z21 - s_lam * z56;
    kept[100] = z58;
    const double z59 = s_pitch * z57 - c_pitch * z58;
    kept[101] = z59;
    const double z60 = c_roll * z59 + e2z * z46;
    kept[102] = z60;
    const double z61 = z34 * z55 + z60 * z38;
    kept[103] = z61;
    const double z62 = z46 * z55 + z60 * z43;
    kept[104] = z62;
    const double z63 = z30 * z47 - z29 * z61 + z27 * z62;
    kept[105] = z63;
    const double z64 = 1.0 / z63;
    kept[106] = z64;
    const double z65 = s_pitch * s_lam - c_pitch * c_lam;
    kept[107] = z65;
    const double z66 = s_steer * z65;
    kept[108] = z66;
    const double z67 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20);
    kept[109] = z67;
    const double z68 = k12 * z66 + s_steer * z67;
    const double z69 = k3 * z66;
    const double z70 = z15 * z66 - (s_lam * z68 + c_lam * z69);
    kept[110] = z70;
    const double z71 = c_pitch * s_lam + s_pitch * c_lam;
    const double z72 = c_steer * z65;
    const double z73 = s_lam * z71 - c_lam * z72;
    kept[111] = z73;
    const double z74 = s_lam * z72 + c_lam * z71;
    kept[112] = z74;
    const double z75 = z40 * z73 - z15 * z74 + (k12 * z72 + k3 * z71 + c_steer * z67);
    kept[113] = z75;
    const double z76 = z40 * z66 + (s_lam * z69 - c_lam * z68);
    kept[114] = z76;
    const double z77 = z34 * z75 - z38 * z76;
    kept[115] = z77;
    const double z78 = z46 * z75 - z43 * z76;
    kept[116] = z78;
    const double z79 = z47 * z70 + z29 * z77 - z27 * z78;
    kept[117] = z79;
    const double z80 = z64 * z79;
    kept[118] = z80;
    const double z81 = c_roll * z80;
    kept[119] = z81;
    const double z82 = s_pitch - c_pitch * z81;
    kept[120] = z82;
    const double z83 = c_pitch + s_pitch * z81;
    kept[121] = z83;
    const double z84 = c_lam * z82 + s_lam * z83;
    kept[122] = z84;
    const double z85 = R3 * z83 + z20 * z82;
    kept[123] = z85;
    const double z86 = z85 + (k10 * z82 + k9 * z83);
    kept[124] = z86;
    const double z87 = z55 * z76 + z60 * z75;
    kept[125] = z87;
    const double z88 = z30 * z78 + z29 * z87 + z62 * z70;
    kept[126] = z88;
    const double z89 = z64 * z88;
    kept[127] = z89;
    const double z90 = z30 * z77 + z61 * z70 + z27 * z87;
    kept[128] = z90;
    const double z91 = z64 * z90;
    kept[129] = z91;
    const double z92 = z91 + e2z * z80;
    kept[130] = z92;
    const double z93 = z89 - z92;
    kept[131] = z93;
    const double z94 = R3 * z93;
    kept[132] = z94;
    const double z95 = z94 - k9 * z92;
    const double z96 = z20 * z93;
    kept[133] = z96;
    const double z97 = z96 - k10 * z92;
    const double z98 = c_lam * z95 - s_lam * z97;
    kept[134] = z98;
    const double z99 = c_steer * z86 + s_steer * z98;
    kept[135] = z99;
    const double z100 = c_lam * z83 - s_lam * z82;
    kept[136] = z100;
    const double z101 = s_steer * z92 - c_steer * z100;
    kept[137] = z101;
    const double z102 = k51 * z84 + (k36 * z99 - k50 * z101);
    kept[138] = z102;
    const double z103 = c_steer * z92 + s_steer * z100;
    kept[139] = z103;
    const double z104 = c_steer * z98 - s_steer * z86;
    kept[140] = z104;
    const double z105 = c_lam * z97 + s_lam * z95;
    kept[141] = z105;
    const double z106 = k47 * z103 + (k33 * z104 - k36 * z105);
    kept[142] = z106;
    const double z107 = k44 * z84 - (k33 * z99 + k43 * z101);
    kept[143] = z107;
    const double z108 = k31 * z105 - k36 * z103;
    kept[144] = z108;
    const double z109 = k36 * z84 + (k31 * z99 + k33 * z101);
    kept[145] = z109;
    const double z110 = k31 * z104 + k33 * z103;
    kept[146] = z110;
    const double z111 = z82 * k29 + (z85 * k23 + z83 * k28);
    kept[147] = z111;
    const double z112 = z92 * k27 + (z94 * k22 - z96 * k23);
    kept[148] = z112;
    const double z113 = z82 * k28 - (z85 * k22 - z83 * k25);
    kept[149] = z113;
    const double z114 = z96 * k21 - z92 * k23;
    kept[150] = z114;
    const double z115 = z94 * k21 + z92 * k22;
    kept[151] = z115;
    const double z116 = z82 * k23 + (z85 * k21 - z83 * k22);
    kept[152] = z116;
    const double z117 = z82 * z111 + (z92 * z112 + (z83 * z113 + (z96 * z114 + (z94 * z115 + z85 * z116))));
    const double z118 = z84 * z102 + (z103 * z106 - (z101 * z107 - (z105 * z108 + (z99 * z109 + (z104 * z110
        + z117)))));
    const double z119 = z118 + R_yy * (z93 * z93) + F_yy * (z103 * z103);
    kept[153] = z119;
    const double z120 = k3 + (z49 - z50);
    kept[154] = z120;
    const double z121 = z34 * z120;
    kept[155] = z121;
    const double z122 = z46 * z120;
    kept[156] = z122;
    const double z123 = z29 * z121 - z27 * z122;
    kept[157] = z123;
    const double z124 = z64 * z123;
    kept[158] = z124;
    const double z125 = c_roll * z124;
    kept[159] = z125;
    const double z126 = c_pitch * z125;
    kept[160] = z126;
    const double z127 = s_pitch * z125;
    kept[161] = z127;
    const double z128 = 1.0 - (c_lam * z126 - s_lam * z127);
    kept[162] = z128;
    const double z129 = R3 * z127 - z20 * z126;
    kept[163] = z129;
    const double z130 = z129 - (k10 * z126 - k9 * z127);
    kept[164] = z130;
    const double z131 = z60 * z120;
    kept[165] = z131;
    const double z132 = z30 * z122 + z29 * z131;
    kept[166] = z132;
    const double z133 = z64 * z132;
    kept[167] = z133;
    const double z134 = z30 * z121 + z27 * z131;
    kept[168] = z134;
    const double z135 = z64 * z134;
    kept[169] = z135;
    const double z136 = z135 + e2z * z124;
    kept[170] = z136;
    const double z137 = z133 - z136;
    kept[171] = z137;
    const double z138 = R3 * z137;
    kept[172] = z138;
    const double z139 = z138 - k9 * z136;
    const double z140 = z20 * z137;
    kept[173] = z140;
    const double z141 = z140 - k10 * z136;
    const double z142 = c_lam * z139 - s_lam * z141;
    kept[174] = z142;
    const double z143 = c_steer * z130 + s_steer * z142;
    kept[175] = z143;
    const double z144 = c_lam * z127 + s_lam * z126;
    kept[176] = z144;
    const double z145 = s_steer * z136 - c_steer * z144;
    kept[177] = z145;
    const double z146 = k51 * z128 + (k36 * z143 - k50 * z145);
    kept[178] = z146;
    const double z147 = c_steer * z136 + s_steer * z144;
    kept[179] = z147;
    const double z148 = c_steer * z142 - s_steer * z130;
    kept[180] = z148;
    const double z149 = c_lam * z141 + s_lam * z139;
    kept[181] = z149;
    const double z150 = k47 * z147 + (k33 * z148 - k36 * z149);
    kept[182] = z150;
    const double z151 = k44 * z128 - (k33 * z143 + k43 * z145);
    kept[183] = z151;
    const double z152 = k31 * z149 - k36 * z147;
    kept[184] = z152;
    const double z153 = k36 * z128 + (k31 * z143 + k33 * z145);
    kept[185] = z153;
    const double z154 = k31 * z148 + k33 * z147;
    kept[186] = z154;
    const double z155 = z126 * k29 - (z129 * k23 + z127 * k28);
    kept[187] = z155;
    const double z156 = z136 * k27 + (z138 * k22 - z140 * k23);
    kept[188] = z156;
    const double z157 = z126 * k28 + (z129 * k22 - z127 * k25);
    kept[189] = z157;
    const double z158 = z140 * k21 - z136 * k23;
    kept[190] = z158;
    const double z159 = z138 * k21 + z136 * k22;
    kept[191] = z159;
    const double z160 = z126 * k23 - (z129 * k21 - z127 * k22);
    kept[192] = z160;
    const double z161 = z126 * z155 + (z136 * z156 - (z127 * z157 - (z140 * z158 + (z138 * z159 - z129 *
        z160))));
    const double z162 = z128 * z146 + (z147 * z150 - (z145 * z151 - (z149 * z152 + (z143 * z153 + (z148 *
        z154 + z161)))));
    kept[193] = z162;
    return BICYCLE_OK;
}

static int bicycle_jacobian_part2(double t, const double *y, const double *p, double *kept, double *J)
{
    (void)t;
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const double s_pitch = kept[2];
    const double c_pitch = kept[3];
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double s_yaw = kept[6];
    const double c_yaw = kept[7];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k3 = kept[10];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k12 = kept[13];
    const double k21 = kept[19];
    const double k22 = kept[20];
    const double k23 = kept[21];
    const double k25 = kept[22];
    const double k27 = kept[23];
    const double k28 = kept[24];
    const double k29 = kept[25];
    const double k31 = kept[26];
    const double k33 = kept[27];
    const double k36 = kept[28];
    const double k43 = kept[29];
    const double k44 = kept[30];
    const double k47 = kept[31];
    const double k50 = kept[32];
    const double k51 = kept[33];
    const double z1 = kept[44];
    const double e3z = kept[45];
    const double z2 = kept[46];
    const double z3 = kept[47];
    const double z4 = kept[48];
    const double z5 = kept[49];
    const double R3 = kept[50];
    const double z6 = kept[51];
    const double z7 = kept[52];
    const double z9 = kept[54];
    const double z10 = kept[55];
    const double z11 = kept[56];
    const double z12 = kept[57];
    const double z13 = kept[58];
    const double z14 = kept[59];
    const double z15 = kept[60];
    const double z17 = kept[62];
    const double z18 = kept[63];
    const double z19 = kept[64];
    const double z20 = kept[65];
    const double z21 = kept[66];
    const double z22 = kept[67];
    const double z23 = kept[68];
    const double z24 = kept[69];
    const double z25 = kept[70];
    const double z26 = kept[71];
    const double z27 = kept[72];
    const double z28 = kept[73];
    const double z29 = kept[74];
    const double z30 = kept[75];
    const double z32 = kept[77];
    const double z33 = kept[78];
    const double z34 = kept[79];
    const double z35 = kept[80];
    const double z36 = kept[81];
    const double z37 = kept[82];
    const double z38 = kept[83];
    const double z39 = kept[84];
    const double z40 = kept[85];
    const double z43 = kept[88];
    const double z46 = kept[91];
    const double z47 = kept[92];
    const double z52 = kept[94];
    const double z53 = kept[95];
    const double z54 = kept[96];
    const double z55 = kept[97];
    const double z57 = kept[99];
    const double z58 = kept[100];
    const double z59 = kept[101];
    const double z60 = kept[102];
    const double z61 = kept[103];
    const double z62 = kept[104];
    const double z63 = kept[105];
    const double z64 = kept[106];
    const double z93 = kept[131];
    const double z102 = kept[138];
    const double z103 = kept[139];
    const double z106 = kept[142];
    const double z107 = kept[143];
    const double z108 = kept[144];
    const double z109 = kept[145];
    const double z110 = kept[146];
    const double z111 = kept[147];
    const double z112 = kept[148];
    const double z113 = kept[149];
    const double z114 = kept[150];
    const double z115 = kept[151];
    const double z116 = kept[152];
    const double z119 = kept[153];
    const double z126 = kept[160];
    const double z127 = kept[161];
    const double z128 = kept[162];
    const double z129 = kept[163];
    const double z136 = kept[170];
    const double z137 = kept[171];
    const double z138 = kept[172];
    const double z140 = kept[173];
    const double z143 = kept[175];
    const double z145 = kept[177];
    const double z146 = kept[178];
    const double z147 = kept[179];
    const double z148 = kept[180];
    const double z149 = kept[181];
    const double z150 = kept[182];
    const double z151 = kept[183];
    const double z152 = kept[184];
    const double z153 = kept[185];
    const double z154 = kept[186];
    const double z155 = kept[187];
    const double z156 = kept[188];
    const double z157 = kept[189];
    const double z158 = kept[190];
    const double z159 = kept[191];
    const double z160 = kept[192];
    const double z162 = kept[193];
    const double z163 = z162 + R_yy * (z137 * z137) + F_yy * (z147 * z147);
    kept[194] = z163;
    const double z164 = z126 * z111 - (z136 * z112 + (z127 * z113 + (z140 * z114 + (z138 * z115 + z129 *
        z116))));
    const double z165 = z128 * z102 + (z147 * z106 - (z145 * z107 - (z149 * z108 + (z143 * z109 + (z148 *
        z110 - z164)))));
    const double z166 = z165 + R_yy * (z93 * z137) + F_yy * (z103 * z147);
    const double z167 = 1.0 / z119;
    kept[195] = z167;
    const double z168 = z166 * z167;
    kept[196] = z168;
    const double z169 = z163 - z166 * z168;
    kept[197] = z169;
    const double z170 = z40 * z38;
    kept[198] = z170;
    const double z171 = z40 * z43;
    kept[199] = z171;
    const double z172 = z15 * z47 - z29 * z170 + z27 * z171;
    kept[200] = z172;
    const double z173 = z64 * z172;
    kept[201] = z173;
    const double z174 = c_roll * z173;
    kept[202] = z174;
    const double z175 = c_pitch * z174;
    kept[203] = z175;
    const double z176 = s_pitch * z174;
    kept[204] = z176;
    const double z177 = c_lam * z175 - s_lam * z176;
    kept[205] = z177;
    const double z178 = R3 * z176 - z20 * z175;
    kept[206] = z178;
    const double z179 = z178 - (k10 * z175 - k9 * z176);
    kept[207] = z179;
    const double z180 = z40 * z55;
    kept[208] = z180;
    const double z181 = z30 * z171 - z29 * z180 - z15 * z62;
    kept[209] = z181;
    const double z182 = z64 * z181;
    kept[210] = z182;
    const double z183 = z30 * z170 - z15 * z61 - z27 * z180;
    kept[211] = z183;
    const double z184 = z64 * z183;
    kept[212] = z184;
    const double z185 = z184 - e2z * z173;
    kept[213] = z185;
    const double z186 = z182 - z185;
    kept[214] = z186;
    const double z187 = R3 * z186;
    kept[215] = z187;
    const double z188 = z187 - k9 * z185;
    const double z189 = z20 * z186;
    kept[216] = z189;
    const double z190 = z189 - k10 * z185;
    const double z191 = c_lam * z188 - s_lam * z190;
    kept[217] = z191;
    const double z192 = c_steer * z179 - s_steer * z191;
    kept[218] = z192;
    const double z193 = c_lam * z176 + s_lam * z175;
    kept[219] = z193;
    const double z194 = s_steer * z185 + c_steer * z193;
    kept[220] = z194;
    const double z195 = k51 * z177 - (k36 * z192 + k50 * z194);
    kept[221] = z195;
    const double z196 = c_steer * z185 - s_steer * z193;
    kept[222] = z196;
    const double z197 = c_steer * z191 + s_steer * z179;
    kept[223] = z197;
    const double z198 = c_lam * z190 + s_lam * z188;
    kept[224] = z198;
    const double z199 = k47 * z196 + (k33 * z197 - k36 * z198);
    kept[225] = z199;
    const double z200 = k44 * z177 + (k33 * z192 - k43 * z194);
    kept[226] = z200;
    const double z201 = k31 * z198 - k36 * z196;
    kept[227] = z201;
    const double z202 = k36 * z177 - (k31 * z192 - k33 * z194);
    kept[228] = z202;
    const double z203 = k31 * z197 + k33 * z196;
    kept[229] = z203;
    const double z204 = z175 * k29 - (z178 * k23 + z176 * k28);
    kept[230] = z204;
    const double z205 = z185 * k27 + (z187 * k22 - z189 * k23);
    kept[231] = z205;
    const double z206 = z175 * k28 + (z178 * k22 - z176 * k25);
    kept[232] = z206;
    const double z207 = z189 * k21 - z185 * k23;
    kept[233] = z207;
    const double z208 = z187 * k21 + z185 * k22;
    kept[234] = z208;
    const double z209 = z175 * k23 - (z178 * k21 - z176 * k22);
    kept[235] = z209;
    const double z210 = z175 * z204 + (z185 * z205 - (z176 * z206 - (z189 * z207 + (z187 * z208 - z178 *
        z209))));
    const double z211 = z177 * z195 + (z196 * z199 - (z194 * z200 - (z198 * z201 - (z192 * z202 - (z197 *
        z203 + z210)))));
    const double z212 = 1.0 + z196;
    kept[236] = z212;
    const double z213 = z211 + R_yy * (z186 * z186) + F_yy * (z212 * z212);
    kept[237] = z213;
    const double z214 = z175 * z111 + (z185 * z112 - (z176 * z113 - (z189 * z114 + (z187 * z115 - z178 *
        z116))));
    const double z215 = z177 * z102 + (z196 * z106 - (z194 * z107 - (z198 * z108 - (z192 * z109 - (z197 *
        z110 + z214)))));
    const double z216 = z215 + R_yy * (z93 * z186) + F_yy * (z103 * z212);
    const double z217 = z216 * z167;
    kept[238] = z217;
    const double z218 = z175 * z155 - (z185 * z156 + (z176 * z157 + (z189 * z158 + (z187 * z159 + z178 *
        z160))));
    const double z219 = z177 * z146 + (z196 * z150 - (z194 * z151 - (z198 * z152 - (z192 * z153 - (z197 *
        z154 - z218)))));
    const double z220 = z219 + R_yy * (z137 * z186) + F_yy * (z147 * z212) - z166 * z217;
    const double z221 = 1.0 / z169;
    kept[239] = z221;
    const double z222 = z220 * z221;
    kept[240] = z222;
    const double z223 = z213 - z216 * z217 - z220 * z222;
    kept[241] = z223;
    const double z224 = roll_dot * c_pitch;
    kept[242] = z224;
    const double z225 = roll_dot * s_pitch;
    kept[243] = z225;
    const double z226 = s_lam * z224 + c_lam * z225;
    const double z227 = steer_dot + z226;
    const double z228 = s_lam * z225 - c_lam * z224;
    kept[244] = z228;
    const double z229 = c_steer * z228;
    kept[245] = z229;
    const double z230 = s_lam * z227 - c_lam * z229;
    kept[246] = z230;
    const double z231 = s_lam * z229 + c_lam * z227;
    kept[247] = z231;
    const double z232 = k12 * z229;
    kept[248] = z232;
    const double z233 = z224 * k9 + z225 * k10 + (z224 * R3 + z225 * z20);
    kept[249] = z233;
    const double z234 = c_steer * z233;
    kept[250] = z234;
    const double z235 = z40 * z230 - z15 * z231 + (z232 + k3 * z227 + z234);
    kept[251] = z235;
    const double z236 = s_steer * z228;
    kept[252] = z236;
    const double z237 = thF_dot + z236;
    kept[253] = z237;
    const double z238 = k3 * z236;
    const double z239 = k12 * z236 + s_steer * z233;
    kept[254] = z239;
    const double z240 = z40 * z237 + (s_lam * z238 - c_lam * z239);
    kept[255] = z240;
    const double z241 = z46 * z235 - z43 * z240;
    kept[256] = z241;
    const double z242 = z55 * z240 + z60 * z235;
    kept[257] = z242;
    const double z243 = z15 * z237 - (s_lam * z239 + c_lam * z238);
    kept[258] = z243;
    const double z244 = z30 * z241 + z29 * z242 + z62 * z243;
    kept[259] = z244;
    const double z245 = z64 * z244;
    kept[260] = z245;
    const double z246 = z34 * z235 - z38 * z240;
    kept[261] = z246;
    const double z247 = z30 * z246 + z61 * z243 + z27 * z242;
    kept[262] = z247;
    const double z248 = z64 * z247;
    kept[263] = z248;
    const double z249 = z47 * z243 + z29 * z246 - z27 * z241;
    kept[264] = z249;
    const double z250 = z64 * z249;
    kept[265] = z250;
    const double z251 = e2z * z250;
    const double z252 = z248 + z251;
    kept[266] = z252;
    const double z253 = z245 - z252;
    kept[267] = z253;
    const double a3 = z20 * z253;
    kept[268] = a3;
    const double z254 = s_pitch * a3;
    const double a1 = R3 * z253;
    kept[269] = a1;
    const double z255 = c_pitch * a1;
    const double z256 = z254 + z255;
    kept[270] = z256;
    const double z257 = s_pitch * a1;
    const double z258 = c_pitch * a3;
    const double z259 = z257 - z258;
    const double z260 = e2z * z259;
    kept[271] = z260;
    const double z261 = c_roll * z250;
    kept[272] = z261;
    const double z262 = s_pitch * z261;
    const double w1_pitch = z224 + z262;
    kept[273] = w1_pitch;
    const double z263 = c_pitch * z261;
    const double w3_pitch = z225 - z263;
    kept[274] = w3_pitch;
    const double v2_x = R3 * w1_pitch + z20 * w3_pitch;
    kept[275] = v2_x;
    const double z264 = c_roll * v2_x;
    kept[276] = z264;
    const double z265 = z260 - z264;
    kept[277] = z265;
    /* (I.2.15) */
    J[3] = s_yaw * z256 + c_yaw * z265;
    const double z266 = e2z * s_pitch;
    const double z267 = 1.0 / z4;
    kept[278] = z267;
    const double z268 = c_pitch * e2z;
    const double z269 = z267 * (z5 * (z3 * z266 + e3z * z268));
    const double z270 = z5 * (r_R * z266) - z19 * z269;
    const double z271 = 1.0 / (z63 * z63);
    kept[279] = z271;
    const double z272 = z5 * (r_R * z268) - z2 * z269;
    const double z273 = c_steer * (c_lam * z266 + s_lam * z268) + c_roll * s_steer;
    const double z274 = s_lam * z266 - c_lam * z268;
    const double z275 = c_lam * z273 + s_lam * z274;
    const double z276 = 1.0 / z13;
    kept[280] = z276;
    const double z277 = c_lam * z274 - s_lam * z273;
    const double z278 = z276 * (z14 * (z10 * z275 + z12 * z277));
    const double z279 = z14 * (r_F * z275) - z11 * z278;
    const double z280 = s_steer * z279;
    const double z281 = z1 * z270;
    const double z282 = e2z * z23 + c_roll * (s_pitch * (z1 * z272 + c_lam * z280) - c_pitch * (z281 - s_lam
        * z280));
    const double z283 = z25 * z270 + z26 * z272;
    const double z284 = z283 - c_steer * z279;
    const double z285 = z282 + (c_roll * z29 - e2z * z284);
    const double z286 = z32 * z270 + z33 * z272;
    const double z287 = z35 * z272;
    const double z288 = z287 - z281;
    const double z289 = z14 * (r_F * z277) - z39 * z278;
    const double z290 = c_lam * z289 + s_lam * z279;
    const double z291 = z288 + s_steer * z290;
    const double z292 = z286 + c_steer * z289;
    const double z293 = z43 * z286 + z34 * z291 - (z38 * z292 + z46 * z288);
    const double z294 = c_steer * z290;
    const double z295 = s_lam * z289 - c_lam * z279;
    const double z296 = s_pitch * (c_steer * z272 + c_lam * z294 + s_lam * z295) - c_pitch * (c_steer * z270
        - s_lam * z294 + c_lam * z295);
    const double z297 = e2z * z54 + c_roll * z296 + (c_roll * z43 - e2z * z291);
    const double z298 = s_steer * z289;
    const double z299 = e2z * z59 + c_roll * (s_pitch * (z287 + c_lam * z298) - c_pitch * (z35 * z270 - s_lam
        * z298));
    const double z300 = z299 - (c_roll * z46 - e2z * z292);
    const double z301 = z55 * z286 + z34 * z297 + (z38 * z300 + z60 * z288);
    const double z302 = z55 * z292 + z46 * z297 + (z43 * z300 + z60 * z291);
    const double z303 = z47 * z285 + z30 * z293 - (z61 * z284 + z29 * z301) + (z62 * z283 + z27 * z302);
    const double z304 = z271 * z303;
    const double z305 = z224 * z272 + z225 * z270;
    const double z306 = z230 * z289 - z231 * z279 + c_steer * z305;
    const double z307 = s_steer * z305;
    const double z308 = z237 * z289 - c_lam * z307;
    const double z309 = z235 * z292 + z46 * z306 - (z240 * z291 + z43 * z308);
    const double z310 = z240 * z297 + z55 * z308 + (z235 * z300 + z60 * z306);
    const double z311 = z237 * z279 - s_lam * z307;
    const double z312 = z241 * z285 + z30 * z309 + (z242 * z284 + z29 * z310) + (z243 * z302 + z62 * z311);
    const double z313 = z244 * z304 - z64 * z312;
    kept[281] = z313;
    const double z314 = z235 * z286 + z34 * z306 - (z240 * z288 + z38 * z308);
    const double z315 = z246 * z285 + z30 * z314 + (z243 * z301 + z61 * z311) + (z242 * z283 + z27 * z310);
    const double z316 = z247 * z304 - z64 * z315;
    kept[282] = z316;
    const double z317 = z243 * z293 + z47 * z311 + (z246 * z284 + z29 * z314) - (z241 * z283 + z27 * z309);
    const double z318 = z249 * z304 - z64 * z317;
    kept[283] = z318;
    const double z319 = z313 - (z316 + (z261 + e2z * z318));
    const double z320 = z253 * z270 - z20 * z319;
    const double z321 = z253 * z272 - R3 * z319;
    const double z322 = s_pitch * z320 + c_pitch * z321;
    kept[284] = z322;
    const double z323 = s_pitch * z321 - c_pitch * z320;
    kept[285] = z323;
    const double z324 = z251 - c_roll * z318;
    const double z325 = w1_pitch * z272 + R3 * (s_pitch * z324) + (w3_pitch * z270 - z20 * (c_pitch * z324));
    kept[286] = z325;
    const double z326 = c_roll * z259 - e2z * z323 + (e2z * v2_x + c_roll * z325);
    kept[287] = z326;
    J[4] = c_yaw * z322 + s_yaw * z326;
    const double z327 = z9 * c_steer;
    const double z328 = c_lam * z327 - s_lam * z7;
    const double z329 = c_lam * z7 + s_lam * z327;
    const double z330 = z276 * (z14 * (z10 * z328 - z12 * z329));
    const double z331 = z14 * (r_F * z328) - z11 * z330;
    const double z332 = s_steer * z331;
    const double z333 = R3 * z1;
    const double z334 = c_pitch * z18 - s_pitch * (z37 + c_lam * z332) + (s_pitch * z22 - c_pitch * (z333 +
        s_lam * z332));
    const double z335 = R3 * z25 - z20 * z26;
    const double z336 = z335 + c_steer * z331;
    const double z337 = c_roll * z334 - e2z * z336;
    const double z338 = R3 * z32 - z20 * z33;
    const double z339 = z20 * z35;
    const double z340 = z339 + z333;
    const double z341 = z14 * (r_F * z329) + z39 * z330;
    const double z342 = c_lam * z341 - s_lam * z331;
    const double z343 = z340 - s_steer * z342;
    const double z344 = z338 + c_steer * z341;
    const double z345 = z43 * z338 - z34 * z343 - (z38 * z344 - z46 * z340);
    const double z346 = c_steer * z342;
    const double z347 = s_lam * z341 + c_lam * z331;
    const double z348 = c_pitch * z52 - s_pitch * (c_steer * z20 - c_lam * z346 - s_lam * z347) + (s_pitch *
        z53 - c_pitch * (c_steer * R3 - s_lam * z346 + c_lam * z347));
    const double z349 = c_roll * z348 + e2z * z343;
    const double z350 = s_steer * z341;
    const double z351 = c_pitch * z57 - s_pitch * (z339 - c_lam * z350) + (s_pitch * z58 - c_pitch * (z36 -
        s_lam * z350));
    const double z352 = c_roll * z351 + e2z * z344;
    const double z353 = z55 * z338 + z34 * z349 + (z38 * z352 - z60 * z340);
    const double z354 = z55 * z344 + z46 * z349 + (z43 * z352 - z60 * z343);
    const double z355 = z47 * z337 + z30 * z345 - (z61 * z336 + z29 * z353) + (z62 * z335 + z27 * z354);
    const double z356 = z271 * z355;
    const double z357 = c_steer * z226;
    const double z358 = z230 * z341 - z40 * (s_lam * z228 + c_lam * z357) + (z231 * z331 - z15 * (s_lam *
        z357 - c_lam * z228));
    const double z359 = z225 * k9 - z224 * k10;
    const double z360 = z358 + (k12 * z357 - k3 * z228 - c_steer * z359);
    const double z361 = s_steer * z226;
    const double z362 = k3 * z361;
    const double z363 = k12 * z361 - s_steer * z359;
    const double z364 = z237 * z341 + z40 * z361 + (s_lam * z362 - c_lam * z363);
    const double z365 = z235 * z344 + z46 * z360 + (z240 * z343 - z43 * z364);
    const double z366 = z240 * z349 + z55 * z364 + (z235 * z352 + z60 * z360);
    const double z367 = z237 * z331 - z15 * z361 + (s_lam * z363 + c_lam * z362);
    const double z368 = z241 * z337 + z30 * z365 + (z242 * z336 + z29 * z366) + (z243 * z354 - z62 * z367);
    const double z369 = z244 * z356 - z64 * z368;
    kept[288] = z369;
    const double z370 = z235 * z338 + z34 * z360 + (z240 * z340 - z38 * z364);
    const double z371 = z246 * z337 + z30 * z370 + (z243 * z353 - z61 * z367) + (z242 * z335 + z27 * z366);
    const double z372 = z247 * z356 - z64 * z371;
    kept[289] = z372;
    const double z373 = z243 * z345 - z47 * z367 + (z246 * z336 + z29 * z370) - (z241 * z335 + z27 * z365);
    const double z374 = z249 * z356 - z64 * z373;
    kept[290] = z374;
    const double z375 = z369 - (z372 + e2z * z374);
    const double z376 = a1 - z20 * z375;
    const double z377 = a3 + R3 * z375;
    const double z378 = z258 + s_pitch * z376 - (z257 + c_pitch * z377);
    kept[291] = z378;
    const double z379 = z255 - s_pitch * z377 + (z254 - c_pitch * z376);
    kept[292] = z379;
    const double z380 = c_roll * z374;
    const double z381 = z20 * w1_pitch + R3 * (z225 - (z263 - s_pitch * z380)) - (R3 * w3_pitch + z20 * (z224
        + (z262 + c_pitch * z380)));
    kept[293] = z381;
    const double z382 = e2z * z379 + c_roll * z381;
    kept[294] = z382;
    J[5] = s_yaw * z382 - c_yaw * z378;
    const double h2z = e2z * c_steer + s_steer * z7;
    kept[295] = h2z;
    const double z383 = c_lam * h2z;
    const double z384 = s_lam * h2z;
    kept[296] = z384;
    const double z385 = z276 * (z14 * (z10 * z383 - z12 * z384));
    kept[297] = z385;
    const double z386 = z14 * (r_F * z383) - z11 * z385;
    kept[298] = z386;
    const double z387 = z28 - s_steer * z386;
    const double z388 = s_lam * z1;
    const double z389 = c_lam * z1;
    const double z390 = z20 * z388 - R3 * z389;
    kept[299] = z390;
    const double z391 = k10 * z388 - k9 * z389 + z390 - (z17 + c_steer * z386);
    kept[300] = z391;
    const double z392 = c_roll * (s_pitch * (z6 * z24 + c_lam * z387) - c_pitch * (z21 * z24 - s_lam * z387))
        + e2z * z391;
    kept[301] = z392;
    const double z393 = s_lam * z35;
    kept[302] = z393;
    const double z394 = c_lam * z35;
    kept[303] = z394;
    return BICYCLE_OK;
}

static int bicycle_jacobian_part3(double t, const double *y, const double *p, double *kept, double *J)
{
    (void)t;
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const double s_pitch = kept[2];
    const double c_pitch = kept[3];
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double s_yaw = kept[6];
    const double c_yaw = kept[7];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k3 = kept[10];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k12 = kept[13];
    const double k16 = kept[14];
    const double k17 = kept[15];
    const double k18 = kept[16];
    const double k19 = kept[17];
    const double k20 = kept[18];
    const double k21 = kept[19];
    const double k22 = kept[20];
    const double k23 = kept[21];
    const double k25 = kept[22];
    const double k27 = kept[23];
    const double k28 = kept[24];
    const double k29 = kept[25];
    const double k31 = kept[26];
    const double k33 = kept[27];
    const double k36 = kept[28];
    const double k43 = kept[29];
    const double k44 = kept[30];
    const double k47 = kept[31];
    const double k50 = kept[32];
    const double k51 = kept[33];
    const double k55 = kept[34];
    const double k56 = kept[35];
    const double k57 = kept[36];
    const double k58 = kept[37];
    const double k59 = kept[38];
    const double k60 = kept[39];
    const double k61 = kept[40];
    const double k62 = kept[41];
    const double k63 = kept[42];
    const double k64 = kept[43];
    const double z1 = kept[44];
    const double e3z = kept[45];
    const double z2 = kept[46];
    const double z3 = kept[47];
    const double z4 = kept[48];
    const double z5 = kept[49];
    const double R3 = kept[50];
    const double z6 = kept[51];
    const double z7 = kept[52];
    const double z8 = kept[53];
    const double z9 = kept[54];
    const double z10 = kept[55];
    const double z11 = kept[56];
    const double z12 = kept[57];
    const double z13 = kept[58];
    const double z14 = kept[59];
    const double z15 = kept[60];
    const double z16 = kept[61];
    const double z18 = kept[63];
    const double z19 = kept[64];
    const double z20 = kept[65];
    const double z21 = kept[66];
    const double z22 = kept[67];
    const double z23 = kept[68];
    const double z24 = kept[69];
    const double z25 = kept[70];
    const double z26 = kept[71];
    const double z27 = kept[72];
    const double z29 = kept[74];
    const double z30 = kept[75];
    const double z31 = kept[76];
    const double z32 = kept[77];
    const double z33 = kept[78];
    const double z34 = kept[79];
    const double z35 = kept[80];
    const double z38 = kept[83];
    const double z39 = kept[84];
    const double z40 = kept[85];
    const double z41 = kept[86];
    const double z42 = kept[87];
    const double z43 = kept[88];
    const double z44 = kept[89];
    const double z45 = kept[90];
    const double z46 = kept[91];
    const double z47 = kept[92];
    const double z48 = kept[93];
    const double z52 = kept[94];
    const double z53 = kept[95];
    const double z54 = kept[96];
    const double z55 = kept[97];
    const double z56 = kept[98];
    const double z57 = kept[99];
    const double z58 = kept[100];
    const double z59 = kept[101];
    const double z60 = kept[102];
    const double z61 = kept[103];
    const double z62 = kept[104];
    const double z63 = kept[105];
    const double z64 = kept[106];
    const double z80 = kept[118];
    const double z81 = kept[119];
    const double z82 = kept[120];
    const double z83 = kept[121];
    const double z84 = kept[122];
    const double z85 = kept[123];
    const double z89 = kept[127];
    const double z91 = kept[129];
    const double z92 = kept[130];
    const double z93 = kept[131];
    const double z94 = kept[132];
    const double z96 = kept[133];
    const double z99 = kept[135];
    const double z101 = kept[137];
    const double z103 = kept[139];
    const double z104 = kept[140];
    const double z105 = kept[141];
    const double z119 = kept[153];
    const double z124 = kept[158];
    const double z125 = kept[159];
    const double z126 = kept[160];
    const double z127 = kept[161];
    const double z128 = kept[162];
    const double z129 = kept[163];
    const double z133 = kept[167];
    const double z135 = kept[169];
    const double z136 = kept[170];
    const double z137 = kept[171];
    const double z138 = kept[172];
    const double z140 = kept[173];
    const double z143 = kept[175];
    const double z145 = kept[177];
    const double z147 = kept[179];
    const double z148 = kept[180];
    const double z149 = kept[181];
    const double z163 = kept[194];
    const double z167 = kept[195];
    const double z168 = kept[196];
    const double z169 = kept[197];
    const double z173 = kept[201];
    const double z174 = kept[202];
    const double z175 = kept[203];
    const double z176 = kept[204];
    const double z177 = kept[205];
    const double z178 = kept[206];
    const double z182 = kept[210];
    const double z184 = kept[212];
    const double z185 = kept[213];
    const double z186 = kept[214];
    const double z187 = kept[215];
    const double z189 = kept[216];
    const double z192 = kept[218];
    const double z194 = kept[220];
    const double z196 = kept[222];
    const double z197 = kept[223];
    const double z198 = kept[224];
    const double z212 = kept[236];
    const double z213 = kept[237];
    const double z217 = kept[238];
    const double z221 = kept[239];
    const double z222 = kept[240];
    const double z223 = kept[241];
    const double z224 = kept[242];
    const double z225 = kept[243];
    const double z228 = kept[244];
    const double z229 = kept[245];
    const double z230 = kept[246];
    const double z231 = kept[247];
    const double z232 = kept[248];
    const double z233 = kept[249];
    const double z234 = kept[250];
    const double z235 = kept[251];
    const double z236 = kept[252];
    const double z237 = kept[253];
    const double z239 = kept[254];
    const double z240 = kept[255];
    const double z241 = kept[256];
    const double z242 = kept[257];
    const double z243 = kept[258];
    const double z244 = kept[259];
    const double z245 = kept[260];
    const double z246 = kept[261];
    const double z247 = kept[262];
    const double z248 = kept[263];
    const double z249 = kept[264];
    const double z250 = kept[265];
    const double z252 = kept[266];
    const double z253 = kept[267];
    const double a3 = kept[268];
    const double a1 = kept[269];
    const double z256 = kept[270];
    const double z260 = kept[271];
    const double z261 = kept[272];
    const double w1_pitch = kept[273];
    const double w3_pitch = kept[274];
    const double v2_x = kept[275];
    const double z264 = kept[276];
    const double z265 = kept[277];
    const double z267 = kept[278];
    const double z271 = kept[279];
    const double z276 = kept[280];
    const double z313 = kept[281];
    const double z316 = kept[282];
    const double z318 = kept[283];
    const double z322 = kept[284];
    const double z323 = kept[285];
    const double z325 = kept[286];
    const double z326 = kept[287];
    const double z369 = kept[288];
    const double z372 = kept[289];
    const double z374 = kept[290];
    const double z378 = kept[291];
    const double z379 = kept[292];
    const double z381 = kept[293];
    const double z382 = kept[294];
    const double h2z = kept[295];
    const double z384 = kept[296];
    const double z385 = kept[297];
    const double z386 = kept[298];
    const double z390 = kept[299];
    const double z391 = kept[300];
    const double z392 = kept[301];
    const double z393 = kept[302];
    const double z394 = kept[303];
    const double z395 = z20 * z393 - R3 * z394;
    const double z396 = R3 * z31 - z20 * z24;
    const double z397 = z14 * (r_F * z384) + z39 * z385;
    const double z398 = c_lam * z397 - s_lam * z386;
    const double z399 = k9 * z31 - k10 * z24 + z396 - (z48 - s_steer * z398);
    const double z400 = k10 * z393 - k9 * z394 + z395 - (z56 - c_steer * z397);
    const double z401 = z43 * z395 + z34 * z399 - (z38 * z400 + z46 * z396);
    const double z402 = z42 + c_steer * z398;
    const double z403 = s_lam * z397 + c_lam * z386;
    const double z404 = s_pitch * (s_steer * z6 - c_lam * z402 - s_lam * z403) - c_pitch * (s_steer * z21 +
        s_lam * z402 - c_lam * z403);
    const double z405 = c_roll * z404 + e2z * z399;
    const double z406 = z45 + s_steer * z397;
    const double z407 = c_roll * (s_pitch * (z31 * z6 + c_lam * z406) - c_pitch * (z31 * z21 - s_lam * z406))
        + e2z * z400;
    const double z408 = z55 * z395 - z34 * z405 + (z38 * z407 + z60 * z396);
    const double z409 = z55 * z400 - z46 * z405 + (z43 * z407 + z60 * z399);
    const double z410 = z47 * z392 + z30 * z401 + (z61 * z391 - z29 * z408) - (z62 * z390 - z27 * z409);
    const double z411 = z271 * z410;
    const double z412 = z239 - (z230 * z397 + z40 * (c_lam * z236) + (z231 * z386 + z15 * (s_lam * z236)));
    const double z413 = k3 * z229;
    const double z414 = z232 + z234;
    const double z415 = z237 * z397 + z40 * z229 + (s_lam * z413 - c_lam * z414);
    const double z416 = z235 * z400 - z46 * z412 - (z240 * z399 + z43 * z415);
    const double z417 = z240 * z405 - z55 * z415 - (z235 * z407 - z60 * z412);
    const double z418 = z237 * z386 - z15 * z229 + (s_lam * z414 + c_lam * z413);
    const double z419 = z241 * z392 + z30 * z416 - (z242 * z391 + z29 * z417) + (z243 * z409 - z62 * z418);
    const double z420 = z244 * z411 - z64 * z419;
    const double z421 = z235 * z395 - z34 * z412 - (z240 * z396 + z38 * z415);
    const double z422 = z246 * z392 + z30 * z421 + (z243 * z408 - z61 * z418) - (z242 * z390 + z27 * z417);
    const double z423 = z247 * z411 - z64 * z422;
    const double z424 = z243 * z401 - z47 * z418 - (z246 * z391 - z29 * z421) + (z241 * z390 - z27 * z416);
    const double z425 = z249 * z411 - z64 * z424;
    const double z426 = z420 - (z423 + e2z * z425);
    const double z427 = z20 * z426;
    const double z428 = R3 * z426;
    const double z429 = s_pitch * z427 + c_pitch * z428;
    const double z430 = s_pitch * z428 - c_pitch * z427;
    const double z431 = c_roll * z425;
    const double z432 = R3 * (s_pitch * z431) - z20 * (c_pitch * z431);
    const double z433 = e2z * z430 - c_roll * z432;
    /* (I.2.15) */
    J[6] = c_yaw * z429 - s_yaw * z433;
    const double z434 = s_pitch * z94 - c_pitch * z96;
    const double z435 = e2z * z434 - c_roll * z85;
    const double z436 = s_pitch * z96 + c_pitch * z94;
    J[9] = s_yaw * z435 - c_yaw * z436;
    const double z437 = s_pitch * z138 - c_pitch * z140;
    const double z438 = e2z * z437 - c_roll * z129;
    const double z439 = s_pitch * z140 + c_pitch * z138;
    J[10] = s_yaw * z438 - c_yaw * z439;
    const double z440 = s_pitch * z187 - c_pitch * z189;
    const double z441 = e2z * z440 + c_roll * z178;
    const double z442 = s_pitch * z189 + c_pitch * z187;
    J[11] = c_yaw * z442 - s_yaw * z441;
    J[15] = s_yaw * z265 - c_yaw * z256;
    J[16] = s_yaw * z322 - c_yaw * z326;
    J[17] = -(s_yaw * z378 + c_yaw * z382);
    J[18] = s_yaw * z429 + c_yaw * z433;
    J[21] = -(s_yaw * z436 + c_yaw * z435);
    J[22] = -(s_yaw * z439 + c_yaw * z438);
    J[23] = s_yaw * z442 + c_yaw * z441;
    J[28] = z264 - e2z * z325 - (z260 + c_roll * z323);
    J[29] = c_roll * z379 - e2z * z381;
    J[30] = -(c_roll * z430 + e2z * z432);
    J[33] = e2z * z85 + c_roll * z434;
    J[34] = e2z * z129 + c_roll * z437;
    J[35] = e2z * z178 - c_roll * z440;
    J[40] = -z318;
    J[41] = z374;
    J[42] = z425;
    J[45] = -z80;
    J[46] = -z124;
    J[47] = -z173;
    J[57] = 1.0;
    J[64] = -z316;
    J[65] = z372;
    J[66] = z423;
    J[69] = -z91;
    J[70] = -z135;
    J[71] = z184;
    J[82] = 1.0;
    J[88] = z313;
    J[89] = -z369;
    J[90] = -z420;
    J[93] = z89;
    J[94] = z133;
    J[95] = -z182;
    J[107] = 1.0;
    const double z443 = 1.0 / z223;
    kept[304] = z443;
    const double z444 = R_yy * (z174 * z253);
    kept[305] = z444;
    const double z445 = steer_dot * s_steer;
    kept[306] = z445;
    const double z446 = roll_dot * e2z;
    kept[307] = z446;
    const double z447 = c_pitch * z248;
    kept[308] = z447;
    const double z448 = s_pitch * z446 + c_roll * z447;
    kept[309] = z448;
    const double z449 = s_pitch * z248;
    kept[310] = z449;
    const double z450 = c_pitch * z446 - c_roll * z449;
    kept[311] = z450;
    const double z451 = s_lam * z448 - c_lam * z450;
    const double z452 = roll_dot * c_roll;
    kept[312] = z452;
    const double z453 = steer_dot * c_steer;
    kept[313] = z453;
    const double z454 = c_lam * z448 + s_lam * z450;
    kept[314] = z454;
    const double z455 = s_steer * z452 + e2z * z453 + (z7 * z445 + c_steer * z454);
    const double z456 = c_lam * z451 - s_lam * z455;
    kept[315] = z456;
    const double z457 = r_F * z456;
    kept[316] = z457;
    const double z458 = c_lam * z455 + s_lam * z451;
    kept[317] = z458;
    const double z459 = z10 * z458 + z12 * z456;
    kept[318] = z459;
    const double z460 = z14 * z459;
    kept[319] = z460;
    const double z461 = z276 * z460;
    kept[320] = z461;
    const double z462 = z14 * z457 - z39 * z461;
    kept[321] = z462;
    const double z463 = roll_dot * z449;
    kept[322] = z463;
    const double z464 = roll_dot * z447;
    kept[323] = z464;
    const double z465 = s_lam * z463 - c_lam * z464;
    const double z466 = s_lam * z464 + c_lam * z463;
    kept[324] = z466;
    const double z467 = z445 * z228 + c_steer * z466;
    const double z468 = s_lam * z465 + c_lam * z467;
    kept[325] = z468;
    const double z469 = r_F * z458;
    kept[326] = z469;
    const double z470 = z14 * z469 - z11 * z461;
    kept[327] = z470;
    const double z471 = s_lam * z467 - c_lam * z465;
    kept[328] = z471;
    const double z472 = r_R * z450;
    kept[329] = z472;
    const double z473 = z3 * z448 + e3z * z450;
    kept[330] = z473;
    const double z474 = z5 * z473;
    kept[331] = z474;
    const double z475 = z267 * z474;
    kept[332] = z475;
    const double z476 = z5 * z472 - z2 * z475;
    kept[333] = z476;
    const double z477 = r_R * z448;
    kept[334] = z477;
    const double z478 = z5 * z477 - z19 * z475;
    kept[335] = z478;
    const double z479 = k9 * z463 - k10 * z464 + (R3 * z463 - z224 * z476 - (z20 * z464 + z225 * z478));
    kept[336] = z479;
    const double z480 = z230 * z462 - z40 * z468 - (z231 * z470 + z15 * z471) + (k12 * z467 - k3 * z465 +
        (z445 * z233 - c_steer * z479));
    const double z481 = c_lam * z453;
    kept[337] = z481;
    const double z482 = z35 * z476;
    const double z483 = s_lam * z453;
    kept[338] = z483;
    const double z484 = z1 * z478;
    const double z485 = R3 * z481 - z482 - (z20 * z483 - z484);
    kept[339] = z485;
    const double z486 = c_lam * z462 + s_lam * z470;
    kept[340] = z486;
    const double z487 = z445 * z41 - c_steer * z486;
    const double z488 = s_lam * z462 - c_lam * z470;
    const double z489 = z445 * z6 + c_steer * z476 - c_lam * z487 + s_lam * z488;
    kept[341] = z489;
    const double z490 = z445 * z21 + c_steer * z478 + s_lam * z487 + c_lam * z488;
    kept[342] = z490;
    const double z491 = z52 * z447 + s_pitch * z489 + (z53 * z449 - c_pitch * z490);
    kept[343] = z491;
    const double z492 = k9 * z481 - k10 * z483 + z485 - (z453 * z41 + s_steer * z486);
    kept[344] = z492;
    const double z493 = z446 * z54 + c_roll * z491 + (z452 * z43 + e2z * z492);
    kept[345] = z493;
    const double z494 = z480 - (z245 * z485 - (z250 * z493 + z248 * z492));
    kept[346] = z494;
    const double z495 = z453 * z228 - s_steer * z466;
    kept[347] = z495;
    const double z496 = k3 * z495;
    const double z497 = k12 * z495 + (z453 * z233 + s_steer * z479);
    const double z498 = c_lam * z445;
    const double z499 = s_lam * z498;
    kept[348] = z499;
    const double z500 = c_lam * z498;
    kept[349] = z500;
    const double z501 = z20 * z499 - z32 * z478 - (R3 * z500 + z33 * z476);
    kept[350] = z501;
    const double z502 = z453 * z44 - s_steer * z462;
    const double z503 = z6 * z481 - z482 + c_lam * z502;
    kept[351] = z503;
    const double z504 = z21 * z481 - z35 * z478 - s_lam * z502;
    kept[352] = z504;
    const double z505 = z57 * z447 - s_pitch * z503 + (z58 * z449 + c_pitch * z504);
    kept[353] = z505;
    const double z506 = k10 * z499 - k9 * z500 + z501 - (z445 * z44 + c_steer * z462);
    kept[354] = z506;
    const double z507 = z446 * z59 + c_roll * z505 - (z452 * z46 + e2z * z506);
    kept[355] = z507;
    const double z508 = z237 * z462 - z40 * z495 - (s_lam * z496 - c_lam * z497) - (z245 * z501 + (z250 *
        z507 - z248 * z506));
    kept[356] = z508;
    const double z509 = z34 * z494 - z38 * z508;
    kept[357] = z509;
    const double z510 = s_lam * z445;
    const double z511 = s_lam * z510;
    kept[358] = z511;
    const double z512 = c_lam * z510;
    kept[359] = z512;
    const double z513 = z20 * z511 + z25 * z478 - (R3 * z512 - z26 * z476);
    kept[360] = z513;
    const double z514 = z453 * z16 - s_steer * z470;
    const double z515 = z6 * z483 - z1 * z476 + c_lam * z514;
    kept[361] = z515;
    const double z516 = z21 * z483 - z484 - s_lam * z514;
    kept[362] = z516;
    const double z517 = z18 * z447 - s_pitch * z515 + (z22 * z449 + c_pitch * z516);
    kept[363] = z517;
    const double z518 = k10 * z511 - k9 * z512 + z513 - (z445 * z16 + c_steer * z470);
    kept[364] = z518;
    const double z519 = z446 * z23 + c_roll * z517 + (z452 * z29 - e2z * z518);
    kept[365] = z519;
    const double z520 = z237 * z470 - z15 * z495 + (s_lam * z497 + c_lam * z496) - (z245 * z513 + (z250 *
        z519 - z248 * z518));
    kept[366] = z520;
    const double z521 = z55 * z508 + z60 * z494;
    kept[367] = z521;
    const double z522 = z30 * z509 + z61 * z520 + z27 * z521;
    kept[368] = z522;
    const double z523 = z46 * z494 - z43 * z508;
    kept[369] = z523;
    const double z524 = z47 * z520 + z29 * z509 - z27 * z523;
    kept[370] = z524;
    const double z525 = z64 * z524;
    kept[371] = z525;
    const double z526 = z64 * z522 - (z452 * z250 - e2z * z525);
    kept[372] = z526;
    const double z527 = c_lam * w1_pitch - s_lam * w3_pitch;
    kept[373] = z527;
    const double z528 = z446 * z250 + c_roll * z525;
    kept[374] = z528;
    const double z529 = z463 - (z261 * z447 + s_pitch * z528);
    kept[375] = z529;
    const double z530 = z464 + (z261 * z449 - c_pitch * z528);
    kept[376] = z530;
    const double z531 = c_lam * z529 + s_lam * z530;
    kept[377] = z531;
    const double z532 = z445 * z252 + c_steer * z526 - (z453 * z527 + s_steer * z531);
    kept[378] = z532;
    const double z533 = z30 * z523 + z29 * z521 + z62 * z520;
    kept[379] = z533;
    const double z534 = z64 * z533 - z526;
    kept[380] = z534;
    const double z535 = c_lam * z530 - s_lam * z529;
    const double z536 = w1_pitch * z476 - R3 * z529 + (w3_pitch * z478 + z20 * z530) + (a1 * w3_pitch - a3 *
        w1_pitch);
    const double z537 = k9 * z252;
    kept[381] = z537;
    const double z538 = k10 * z252;
    kept[382] = z538;
    const double z539 = z536 + (k10 * z530 - k9 * z529 - (w3_pitch * z537 - w1_pitch * z538));
    kept[383] = z539;
    const double z540 = z253 * z476 + R3 * z534 + (z252 * a3 - w3_pitch * v2_x);
    const double z541 = k10 * w3_pitch + k9 * w1_pitch;
    kept[384] = z541;
    const double z542 = z540 - (k9 * z526 + (z252 * z538 + w3_pitch * z541));
    const double z543 = z253 * z478 + z20 * z534 + (w1_pitch * v2_x - z252 * a1);
    const double z544 = z543 - (k10 * z526 - (w1_pitch * z541 + z252 * z537));
    const double z545 = c_lam * z542 - s_lam * z544;
    kept[385] = z545;
    const double z546 = c_steer * z539 + s_steer * z545;
    const double z547 = z453 * z252 - s_steer * z526 + (z445 * z527 - c_steer * z531);
    const double z548 = s_steer * z252 - c_steer * z527;
    kept[386] = z548;
    const double z549 = c_steer * z252 + s_steer * z527;
    kept[387] = z549;
    const double z550 = F_yy * (thF_dot - z549) - k47 * z549;
    kept[388] = z550;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    kept[389] = w3_steer;
    const double z551 = k43 * z548 - k44 * w3_steer;
    kept[390] = z551;
    const double z552 = h2z * k64 - (k51 * z535 + (k36 * z546 + k50 * z547) + (z548 * z550 + z549 * z551));
    kept[391] = z552;
    const double z553 = c_steer * z545 - s_steer * z539;
    const double z554 = c_lam * z544 + s_lam * z542;
    const double z555 = k50 * z548 - k51 * w3_steer;
    kept[392] = z555;
    const double z556 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) + (k47 * z532 + (k33 * z553 - k36 * z554)
        - (w3_steer * z551 + z548 * z555));
    kept[393] = z556;
    const double z557 = h2z * k63 - (k44 * z535 - (k33 * z546 - k43 * z547) - (z549 * z555 - w3_steer *
        z550));
    kept[394] = z557;
    const double z558 = k33 * z548 + k36 * w3_steer;
    kept[395] = z558;
    const double z559 = k33 * z549;
    kept[396] = z559;
    const double z560 = z9 * k60 + (k31 * z554 - k36 * z532 - (z548 * z558 + z549 * z559));
    kept[397] = z560;
    const double z561 = k36 * z549;
    kept[398] = z561;
    const double z562 = h2z * k60 + (k36 * z535 + (k31 * z546 - k33 * z547) + (w3_steer * z559 - z548 *
        z561));
    kept[399] = z562;
    const double z563 = z8 * k60 + (k31 * z553 + k33 * z532 - (z549 * z561 + w3_steer * z558));
    kept[400] = z563;
    const double z564 = k27 * z252;
    kept[401] = z564;
    const double z565 = k25 * w1_pitch + k28 * w3_pitch;
    kept[402] = z565;
    const double z566 = e2z * k56 + (k29 * z530 + (k23 * z536 - k28 * z529) + (w1_pitch * z564 - z252 *
        z565));
    kept[403] = z566;
    const double z567 = k28 * w1_pitch + k29 * w3_pitch;
    kept[404] = z567;
    const double z568 = z3 * k57 + e3z * k56 + (k27 * z526 + (k22 * z540 - k23 * z543) + (w3_pitch * z565 -
        w1_pitch * z567));
    kept[405] = z568;
    const double z569 = e2z * k57 - (k28 * z530 - (k22 * z536 + k25 * z529) + (z252 * z567 - w3_pitch *
        z564));
    kept[406] = z569;
    const double z570 = k22 * w1_pitch - k23 * w3_pitch;
    kept[407] = z570;
    const double z571 = k22 * z252;
    kept[408] = z571;
    const double z572 = e3z * k55 - (k21 * z543 - k23 * z526 - (w1_pitch * z570 + z252 * z571));
    kept[409] = z572;
    const double z573 = k23 * z252;
    kept[410] = z573;
    const double z574 = e2z * k55 + (k23 * z530 + (k21 * z536 + k22 * z529) + (w3_pitch * z571 + w1_pitch *
        z573));
    kept[411] = z574;
    const double z575 = z3 * k55 + (k21 * z540 + k22 * z526 - (z252 * z573 - w3_pitch * z570));
    kept[412] = z575;
    const double z576 = R_yy * (z125 * z253);
    kept[413] = z576;
    const double z577 = R_yy * (z81 * z253);
    kept[414] = z577;
    const double z578 = R_yy * z253;
    kept[415] = z578;
    const double z579 = 1.0 / (z13 * z13);
    kept[416] = z579;
    const double z580 = 1.0 / (z4 * z4);
    kept[417] = z580;
    const double z581 = z175 * z566 + (z185 * z568 + (z176 * z569 - (z189 * z572 - (z187 * z575 - z178 *
        z574))));
    const double z582 = z177 * z552 - (z196 * z556 + (z194 * z557 + (z198 * z560 - (z192 * z562 - (z197 *
        z563 + z581)))));
    const double z583 = z82 * z566 + (z92 * z568 - (z83 * z569 + (z96 * z572 - (z94 * z575 + z85 * z574))));
    const double z584 = z84 * z552 - (z103 * z556 + (z101 * z557 + (z105 * z560 + (z99 * z562 + (z104 * z563
        + z583)))));
    const double z585 = z261 * z578 + z584 - R_yy * (z93 * z534) - F_yy * (z103 * z532) - roll_dot * z577;
    const double z586 = z126 * z566 - (z136 * z568 - (z127 * z569 + (z140 * z572 - (z138 * z575 + z129 *
        z574))));
    const double z587 = z128 * z552 - (z147 * z556 + (z145 * z557 + (z149 * z560 + (z143 * z562 + (z148 *
        z563 - z586)))));
    const double z588 = z587 - R_yy * (z137 * z534) - F_yy * (z147 * z532) - roll_dot * z576 - z585 * z168;
    const double z589 = z582 - R_yy * (z186 * z534) - F_yy * (z212 * z532) + roll_dot * z444 - z585 * z217 -
        z222 * z588;
    const double z590 = z443 * z589;
    kept[418] = z590;
    const double z591 = z221 * z588 - z222 * z590;
    kept[419] = z591;
    const double z592 = z585 * z167 - z168 * z591 - z217 * z590;
    kept[420] = z592;
    /* the coframe is singular */
    if (!(fabs(z63) > 1e-12 * (k20 * (k20 * (13.0 * k19 + (14.0 * k18 + (24.0 * k16 + 33.0 * k17))))))) {
        return BICYCLE_SINGULAR_1;
    }
    /* the mass matrix is singular */
    if (!(fabs(z119) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z169) > 1e-14 * z163)) {
        return BICYCLE_SINGULAR_2;
    }
    /* the mass matrix is singular */
    if (!(fabs(z223) > 1e-14 * z213)) {
        return BICYCLE_SINGULAR_2;
    }
    return BICYCLE_OK;
}

static void bicycle_jacobian_sweep1_part1(double t, const double *y, const double *p, const double *kept,
    const double *seed, double *carried, double *slope)
{
    (void)slope;
    (void)t;
    const double roll_dot = y[9];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const double s_pitch = kept[2];
    const double c_pitch = kept[3];
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k21 = kept[19];
    const double k22 = kept[20];
    const double k23 = kept[21];
    const double k25 = kept[22];
    const double k27 = kept[23];
    const double k28 = kept[24];
    const double k29 = kept[25];
    const double k31 = kept[26];
    const double k33 = kept[27];
    const double k36 = kept[28];
    const double k43 = kept[29];
    const double k44 = kept[30];
    const double k47 = kept[31];
    const double k50 = kept[32];
    const double k51 = kept[33];
    const double z1 = kept[44];
    const double e3z = kept[45];
    const double z2 = kept[46];
    const double z3 = kept[47];
    const double z5 = kept[49];
    const double R3 = kept[50];
    const double z10 = kept[55];
    const double z11 = kept[56];
    const double z12 = kept[57];
    const double z14 = kept[59];
    const double z15 = kept[60];
    const double z19 = kept[64];
    const double z20 = kept[65];
    const double z25 = kept[70];
    const double z26 = kept[71];
    const double z27 = kept[72];
    const double z29 = kept[74];
    const double z30 = kept[75];
    const double z32 = kept[77];
    const double z33 = kept[78];
    const double z34 = kept[79];
    const double z35 = kept[80];
    const double z38 = kept[83];
    const double z39 = kept[84];
    const double z43 = kept[88];
    const double z46 = kept[91];
    const double z47 = kept[92];
    const double z55 = kept[97];
    const double z60 = kept[102];
    const double z61 = kept[103];
    const double z62 = kept[104];
    const double z64 = kept[106];
    const double z81 = kept[119];
    const double z82 = kept[120];
    const double z83 = kept[121];
    const double z84 = kept[122];
    const double z85 = kept[123];
    const double z92 = kept[130];
    const double z93 = kept[131];
    const double z94 = kept[132];
    const double z96 = kept[133];
    const double z99 = kept[135];
    const double z101 = kept[137];
    const double z102 = kept[138];
    const double z103 = kept[139];
    const double z104 = kept[140];
    const double z105 = kept[141];
    const double z106 = kept[142];
    const double z107 = kept[143];
    const double z109 = kept[145];
    const double z110 = kept[146];
    const double z111 = kept[147];
    const double z113 = kept[149];
    const double z116 = kept[152];
    const double z125 = kept[159];
    const double z126 = kept[160];
    const double z127 = kept[161];
    const double z128 = kept[162];
    const double z129 = kept[163];
    const double z136 = kept[170];
    const double z137 = kept[171];
    const double z138 = kept[172];
    const double z140 = kept[173];
    const double z143 = kept[175];
    const double z145 = kept[177];
    const double z146 = kept[178];
    const double z147 = kept[179];
    const double z148 = kept[180];
    const double z149 = kept[181];
    const double z150 = kept[182];
    const double z151 = kept[183];
    const double z153 = kept[185];
    const double z154 = kept[186];
    const double z155 = kept[187];
    const double z157 = kept[189];
    const double z160 = kept[192];
    const double z167 = kept[195];
    const double z168 = kept[196];
    const double z174 = kept[202];
    const double z175 = kept[203];
    const double z176 = kept[204];
    const double z177 = kept[205];
    const double z178 = kept[206];
    const double z185 = kept[213];
    const double z186 = kept[214];
    const double z187 = kept[215];
    const double z189 = kept[216];
    const double z192 = kept[218];
    const double z194 = kept[220];
    const double z195 = kept[221];
    const double z196 = kept[222];
    const double z197 = kept[223];
    const double z198 = kept[224];
    const double z199 = kept[225];
    const double z200 = kept[226];
    const double z202 = kept[228];
    const double z203 = kept[229];
    const double z204 = kept[230];
    const double z206 = kept[232];
    const double z209 = kept[235];
    const double z212 = kept[236];
    const double z217 = kept[238];
    const double z221 = kept[239];
    const double z222 = kept[240];
    const double z224 = kept[242];
    const double z225 = kept[243];
    const double z230 = kept[246];
    const double z231 = kept[247];
    const double z237 = kept[253];
    const double z245 = kept[260];
    const double z248 = kept[263];
    const double z250 = kept[265];
    const double z252 = kept[266];
    const double z253 = kept[267];
    const double a3 = kept[268];
    const double a1 = kept[269];
    const double z261 = kept[272];
    const double w1_pitch = kept[273];
    const double w3_pitch = kept[274];
    const double v2_x = kept[275];
    const double z267 = kept[278];
    const double z276 = kept[280];
    const double z443 = kept[304];
    const double z445 = kept[306];
    const double z447 = kept[308];
    const double z449 = kept[310];
    const double z453 = kept[313];
    const double z476 = kept[333];
    const double z478 = kept[335];
    const double z485 = kept[339];
    const double z491 = kept[343];
    const double z501 = kept[350];
    const double z505 = kept[353];
    const double z513 = kept[360];
    const double z517 = kept[363];
    const double z525 = kept[371];
    const double z532 = kept[378];
    const double z537 = kept[381];
    const double z538 = kept[382];
    const double z541 = kept[384];
    const double z548 = kept[386];
    const double z549 = kept[387];
    const double z550 = kept[388];
    const double w3_steer = kept[389];
    const double z551 = kept[390];
    const double z552 = kept[391];
    const double z555 = kept[392];
    const double z556 = kept[393];
    const double z557 = kept[394];
    const double z558 = kept[395];
    const double z559 = kept[396];
    const double z561 = kept[398];
    const double z562 = kept[399];
    const double z563 = kept[400];
    const double z564 = kept[401];
    const double z565 = kept[402];
    const double z566 = kept[403];
    const double z567 = kept[404];
    const double z569 = kept[406];
    const double z570 = kept[407];
    const double z571 = kept[408];
    const double z573 = kept[410];
    const double z574 = kept[411];
    const double z578 = kept[415];
    const double z590 = kept[418];
    const double z591 = kept[419];
    const double z592 = kept[420];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z593 = row_1 - z168 * row_0;
    const bicycle_lanes z594 = z443 * (row_2 + z217 * row_0 + z222 * z593);
    bicycle_put(carried + 0 * BICYCLE_LANES, z594);
    const bicycle_lanes z595 = z221 * z593 + z222 * z594;
    bicycle_put(carried + 1 * BICYCLE_LANES, z595);
    const bicycle_lanes z596 = z167 * row_0 - z168 * z595 + z217 * z594;
    bicycle_put(carried + 2 * BICYCLE_LANES, z596);
    const bicycle_lanes z597 = z185 * z594 - z136 * z595 - z92 * z596;
    bicycle_put(carried + 3 * BICYCLE_LANES, z597);
    const bicycle_lanes z598 = z189 * z594 - z140 * z595 - z96 * z596;
    bicycle_put(carried + 4 * BICYCLE_LANES, z598);
    const bicycle_lanes z599 = z187 * z594 - z138 * z595 - z94 * z596;
    bicycle_put(carried + 5 * BICYCLE_LANES, z599);
    const bicycle_lanes z600 = z177 * z594 - z128 * z595 - z84 * z596;
    bicycle_put(carried + 6 * BICYCLE_LANES, z600);
    const bicycle_lanes z601 = z194 * z594 - z145 * z595 - z101 * z596;
    bicycle_put(carried + 7 * BICYCLE_LANES, z601);
    const bicycle_lanes z602 = z192 * z594 + z143 * z595 + z99 * z596;
    bicycle_put(carried + 8 * BICYCLE_LANES, z602);
    const bicycle_lanes z603 = k36 * z600 + k33 * z601 - k31 * z602;
    bicycle_put(carried + 9 * BICYCLE_LANES, z603);
    const bicycle_lanes z604 = z196 * z594 - z147 * z595 - z103 * z596;
    bicycle_put(carried + 10 * BICYCLE_LANES, z604);
    const bicycle_lanes z605 = z197 * z594 - z148 * z595 - z104 * z596;
    bicycle_put(carried + 11 * BICYCLE_LANES, z605);
    const bicycle_lanes z606 = k33 * z604 + k31 * z605;
    bicycle_put(carried + 12 * BICYCLE_LANES, z606);
    const bicycle_lanes z607 = s_steer * z603 + c_steer * z606;
    const bicycle_lanes z608 = z198 * z594 - z149 * z595 - z105 * z596;
    bicycle_put(carried + 13 * BICYCLE_LANES, z608);
    const bicycle_lanes z609 = k36 * z604 - k31 * z608;
    const bicycle_lanes z610 = s_lam * z607 + c_lam * z609;
    bicycle_put(carried + 14 * BICYCLE_LANES, z610);
    const bicycle_lanes z611 = c_lam * z607 - s_lam * z609;
    bicycle_put(carried + 15 * BICYCLE_LANES, z611);
    const bicycle_lanes z612 = F_yy * z594;
    const bicycle_lanes z613 = F_yy * z595;
    const bicycle_lanes z614 = F_yy * z596;
    const bicycle_lanes z615 = z212 * z612 - z147 * z613 - z103 * z614 + k47 * z604 - k36 * z608 + k33 * z605;
    bicycle_put(carried + 16 * BICYCLE_LANES, z615);
    const bicycle_lanes z616 = k27 * z597 - k23 * z598 + k22 * z599 + k10 * z610 - k9 * z611 + c_steer * z615;
    const bicycle_lanes z617 = k50 * z600 - k43 * z601 + k33 * z602;
    bicycle_put(carried + 17 * BICYCLE_LANES, z617);
    const bicycle_lanes z618 = R_yy * z594;
    bicycle_put(carried + 18 * BICYCLE_LANES, z618);
    const bicycle_lanes z619 = R_yy * z595;
    bicycle_put(carried + 19 * BICYCLE_LANES, z619);
    const bicycle_lanes z620 = R_yy * z596;
    bicycle_put(carried + 20 * BICYCLE_LANES, z620);
    const bicycle_lanes z621 = k23 * z597 - k21 * z598 + z610;
    bicycle_put(carried + 21 * BICYCLE_LANES, z621);
    const bicycle_lanes z622 = k22 * z597 + k21 * z599 + z611;
    bicycle_put(carried + 22 * BICYCLE_LANES, z622);
    const bicycle_lanes z623 = z186 * z618 - z137 * z619 - z93 * z620 - z20 * z621 + R3 * z622;
    bicycle_put(carried + 23 * BICYCLE_LANES, z623);
    const bicycle_lanes z624 = z616 - s_steer * z617 - z623;
    bicycle_put(carried + 24 * BICYCLE_LANES, z624);
    const bicycle_lanes z625 = z64 * z623;
    bicycle_put(carried + 25 * BICYCLE_LANES, z625);
    const bicycle_lanes z626 = z64 * z624;
    bicycle_put(carried + 26 * BICYCLE_LANES, z626);
    const bicycle_lanes z627 = z175 * z594 + z126 * z595 - z82 * z596;
    bicycle_put(carried + 27 * BICYCLE_LANES, z627);
    const bicycle_lanes z628 = z176 * z594 + z127 * z595 + z83 * z596;
    bicycle_put(carried + 28 * BICYCLE_LANES, z628);
    const bicycle_lanes z629 = z178 * z594 + z129 * z595 + z85 * z596;
    bicycle_put(carried + 29 * BICYCLE_LANES, z629);
    const bicycle_lanes z630 = c_steer * z603 - s_steer * z606;
    bicycle_put(carried + 30 * BICYCLE_LANES, z630);
    const bicycle_lanes z631 = s_steer * z615 + c_steer * z617;
    const bicycle_lanes z632 = k51 * z600 - k44 * z601 - k36 * z602;
    const bicycle_lanes z633 = k29 * z627 - k28 * z628 - k23 * z629 + k10 * z630 - s_lam * z631 + c_lam *
        z632;
    const bicycle_lanes z634 = k23 * z627 + k22 * z628 - k21 * z629 + z630;
    bicycle_put(carried + 31 * BICYCLE_LANES, z634);
    const bicycle_lanes z635 = z633 + z20 * z634;
    bicycle_put(carried + 32 * BICYCLE_LANES, z635);
    const bicycle_lanes z636 = k28 * z627 - k25 * z628 + k22 * z629 + k9 * z630 + c_lam * z631 + s_lam * z632;
    const bicycle_lanes z637 = z636 + R3 * z634;
    bicycle_put(carried + 33 * BICYCLE_LANES, z637);
    const bicycle_lanes z638 = c_pitch * z635 - s_pitch * z637;
    bicycle_put(carried + 34 * BICYCLE_LANES, z638);
    const bicycle_lanes z639 = c_roll * z638 - e2z * z624;
    bicycle_put(carried + 35 * BICYCLE_LANES, z639);
    const bicycle_lanes z640 = z64 * z639;
    bicycle_put(carried + 36 * BICYCLE_LANES, z640);
    const bicycle_lanes z641 = z62 * z625 + z61 * z626 - z47 * z640;
    bicycle_put(carried + 37 * BICYCLE_LANES, z641);
    const bicycle_lanes z642 = z250 * z641;
    bicycle_put(carried + 38 * BICYCLE_LANES, z642);
    const bicycle_lanes z643 = z29 * z625 + z27 * z626;
    bicycle_put(carried + 39 * BICYCLE_LANES, z643);
    const bicycle_lanes z644 = z30 * z625 + z27 * z640;
    bicycle_put(carried + 40 * BICYCLE_LANES, z644);
    const bicycle_lanes z645 = z30 * z626 - z29 * z640;
    bicycle_put(carried + 41 * BICYCLE_LANES, z645);
    const bicycle_lanes z646 = z60 * z643 + z46 * z644 + z34 * z645;
    bicycle_put(carried + 42 * BICYCLE_LANES, z646);
    const bicycle_lanes z647 = z250 * z646;
    bicycle_put(carried + 43 * BICYCLE_LANES, z647);
    const bicycle_lanes z648 = z55 * z643 - z43 * z644 - z38 * z645;
    bicycle_put(carried + 44 * BICYCLE_LANES, z648);
    const bicycle_lanes z649 = z250 * z648;
    bicycle_put(carried + 45 * BICYCLE_LANES, z649);
    const bicycle_lanes z650 = z248 * z646 + e2z * z647;
    bicycle_put(carried + 46 * BICYCLE_LANES, z650);
    const bicycle_lanes z651 = c_roll * z647;
    bicycle_put(carried + 47 * BICYCLE_LANES, z651);
    const bicycle_lanes z652 = s_pitch * z651;
    bicycle_put(carried + 48 * BICYCLE_LANES, z652);
    const bicycle_lanes z653 = c_pitch * z651;
    bicycle_put(carried + 49 * BICYCLE_LANES, z653);
    const bicycle_lanes z654 = c_lam * z652 + s_lam * z653;
    bicycle_put(carried + 50 * BICYCLE_LANES, z654);
    const bicycle_lanes z655 = s_steer * z650 - c_steer * z654;
    const bicycle_lanes z656 = c_lam * z653 - s_lam * z652;
    const bicycle_lanes z657 = z248 * z648 + e2z * z649;
    bicycle_put(carried + 51 * BICYCLE_LANES, z657);
    const bicycle_lanes z658 = c_roll * z649;
    bicycle_put(carried + 52 * BICYCLE_LANES, z658);
    const bicycle_lanes z659 = s_pitch * z658;
    bicycle_put(carried + 53 * BICYCLE_LANES, z659);
    const bicycle_lanes z660 = c_pitch * z658;
    bicycle_put(carried + 54 * BICYCLE_LANES, z660);
    const bicycle_lanes z661 = c_lam * z659 + s_lam * z660;
    bicycle_put(carried + 55 * BICYCLE_LANES, z661);
    const bicycle_lanes z662 = z237 * z648 + z230 * z646 - c_lam * z655 - s_lam * z656 - c_steer * z657 -
        s_steer * z661;
    bicycle_put(carried + 56 * BICYCLE_LANES, z662);
    const bicycle_lanes z663 = z248 * z641 + e2z * z642;
    bicycle_put(carried + 57 * BICYCLE_LANES, z663);
    const bicycle_lanes z664 = c_roll * z642;
    bicycle_put(carried + 58 * BICYCLE_LANES, z664);
    const bicycle_lanes z665 = s_pitch * z664;
    bicycle_put(carried + 59 * BICYCLE_LANES, z665);
    const bicycle_lanes z666 = c_pitch * z664;
    bicycle_put(carried + 60 * BICYCLE_LANES, z666);
    const bicycle_lanes z667 = c_lam * z665 + s_lam * z666;
    bicycle_put(carried + 61 * BICYCLE_LANES, z667);
    const bicycle_lanes z668 = z231 * z646 - z237 * z641 + c_steer * z663 + s_steer * z667 - c_lam * z656 +
        s_lam * z655;
    bicycle_put(carried + 62 * BICYCLE_LANES, z668);
    const bicycle_lanes z669 = z39 * z662 - z11 * z668;
    bicycle_put(carried + 63 * BICYCLE_LANES, z669);
    const bicycle_lanes z670 = z276 * z669;
    bicycle_put(carried + 64 * BICYCLE_LANES, z670);
    const bicycle_lanes z671 = z14 * z670;
    bicycle_put(carried + 65 * BICYCLE_LANES, z671);
    const bicycle_lanes z672 = z12 * z671 - r_F * (z14 * z662);
    const bicycle_lanes z673 = z10 * z671 + r_F * (z14 * z668);
    const bicycle_lanes z674 = s_lam * z672 - c_lam * z673;
    bicycle_put(carried + 66 * BICYCLE_LANES, z674);
    const bicycle_lanes z675 = z250 * z624 + z29 * z642 - z43 * z647 - z46 * z649 - s_steer * z674;
    bicycle_put(carried + 67 * BICYCLE_LANES, z675);
    const bicycle_lanes z676 = w1_pitch * z634;
    const bicycle_lanes z677 = c_lam * z648 + s_lam * z641;
    bicycle_put(carried + 68 * BICYCLE_LANES, z677);
    const bicycle_lanes z678 = c_steer * z646 - s_steer * z677;
    bicycle_put(carried + 69 * BICYCLE_LANES, z678);
    const bicycle_lanes z679 = z245 * z641 - z663;
    bicycle_put(carried + 70 * BICYCLE_LANES, z679);
    const bicycle_lanes z680 = z245 * z648 - z657;
    bicycle_put(carried + 71 * BICYCLE_LANES, z680);
    const bicycle_lanes z681 = z676 + z253 * z622 + z224 * z678 - z26 * z679 - z1 * z665 + c_steer * z652 +
        z33 * z680;
    const bicycle_lanes z682 = z245 * z646 - z650;
    bicycle_put(carried + 72 * BICYCLE_LANES, z682);
    const bicycle_lanes z683 = z682 - z659;
    bicycle_put(carried + 73 * BICYCLE_LANES, z683);
    const bicycle_lanes z684 = z681 + z35 * z683;
    bicycle_put(carried + 74 * BICYCLE_LANES, z684);
    const bicycle_lanes z685 = w3_pitch * z634;
    const bicycle_lanes z686 = z666 - z682;
    bicycle_put(carried + 75 * BICYCLE_LANES, z686);
    const bicycle_lanes z687 = z685 - z253 * z621 + z225 * z678 - z25 * z679 + z1 * z686 - c_steer * z653 +
        z32 * z680;
    const bicycle_lanes z688 = z687 + z35 * z660;
    bicycle_put(carried + 76 * BICYCLE_LANES, z688);
    const bicycle_lanes z689 = z2 * z684 + z19 * z688;
    bicycle_put(carried + 77 * BICYCLE_LANES, z689);
    const bicycle_lanes z690 = z267 * z689;
    bicycle_put(carried + 78 * BICYCLE_LANES, z690);
    const bicycle_lanes z691 = z5 * z690;
    bicycle_put(carried + 79 * BICYCLE_LANES, z691);
    const bicycle_lanes z692 = c_steer * z674;
    const bicycle_lanes z693 = c_lam * z672 + s_lam * z673;
    const bicycle_lanes z694 = e3z * z691 - r_R * (z5 * z684) - s_lam * z692 - c_lam * z693;
    bicycle_put(carried + 80 * BICYCLE_LANES, z694);
    const bicycle_lanes z695 = z3 * z691 - r_R * (z5 * z688) - c_lam * z692 + s_lam * z693;
    bicycle_put(carried + 81 * BICYCLE_LANES, z695);
    const bicycle_lanes z696 = z525 * z638 + z517 * z642 - z491 * z647 + z505 * z649 - z449 * z694 + z447 *
        z695;
    bicycle_put(carried + 82 * BICYCLE_LANES, z696);
    const bicycle_lanes z697 = w1_pitch * z597 + z252 * z628;
    const bicycle_lanes z698 = z252 * z627 - w3_pitch * z597;
    const bicycle_lanes z699 = z571 * z629 - z570 * z599 - z565 * z597 - z564 * z628 + k29 * z697 + k28 *
        z698;
    const bicycle_lanes z700 = w1_pitch * z598 - w3_pitch * z599;
    const bicycle_lanes z701 = z699 - k23 * z700 + z537 * z630 + z541 * z611 - a1 * z634 + v2_x * z622 - z478
        * z634;
    const bicycle_lanes z702 = w1_pitch * z610 + w3_pitch * z611;
    const bicycle_lanes z703 = z548 * z600 - w3_steer * z601;
    const bicycle_lanes z704 = z559 * z608 + z561 * z605 - z551 * z600 - z555 * z601 + k47 * z703 - k36 *
        (z548 * z602 - z549 * z605);
    const bicycle_lanes z705 = F_yy * z703;
    bicycle_put(carried + 83 * BICYCLE_LANES, z705);
    const bicycle_lanes z706 = z704 + k33 * (z549 * z608 + w3_steer * z602) + z705;
    bicycle_put(carried + 84 * BICYCLE_LANES, z706);
    const bicycle_lanes z707 = z548 * z604 - z549 * z601;
    const bicycle_lanes z708 = z549 * z600 - w3_steer * z604;
    const bicycle_lanes z709 = z558 * z608 - z561 * z602 - z550 * z600 + z555 * z604 + k50 * z707 - k43 *
        z708;
    const bicycle_lanes z710 = z548 * z608 + w3_steer * z605;
    const bicycle_lanes z711 = z709 + k33 * z710;
    bicycle_put(carried + 85 * BICYCLE_LANES, z711);
    const bicycle_lanes z712 = z453 * z615 - z445 * z617 + s_steer * z706 - c_steer * z711;
    const bicycle_lanes z713 = z559 * z602 + z558 * z605 + z551 * z604 + z550 * z601 - k51 * z707 + k44 *
        z708;
    const bicycle_lanes z714 = z713 + k36 * z710;
    bicycle_put(carried + 86 * BICYCLE_LANES, z714);
    const bicycle_lanes z715 = w1_pitch * z621 + w3_pitch * z622;
    bicycle_put(carried + 87 * BICYCLE_LANES, z715);
    const bicycle_lanes z716 = z701 + k10 * z702 - s_lam * z712 + c_lam * z714 + z20 * z715;
    bicycle_put(carried + 88 * BICYCLE_LANES, z716);
    const bicycle_lanes z717 = z570 * z598 + z573 * z629 - z564 * z627 + z567 * z597 + k28 * z697 + k25 *
        z698;
    const bicycle_lanes z718 = z717 + k22 * z700 + z541 * z610 - z538 * z630 + v2_x * z621 + a3 * z634 - z476
        * z634;
    const bicycle_lanes z719 = z718 + k9 * z702 + c_lam * z712 + s_lam * z714 + R3 * z715;
    bicycle_put(carried + 89 * BICYCLE_LANES, z719);
    const bicycle_lanes z720 = z578 * z596 + z449 * z635 + z447 * z637 + c_pitch * z716 - s_pitch * z719;
    bicycle_put(carried + 90 * BICYCLE_LANES, z720);
    const bicycle_lanes z721 = R_yy * (roll_dot * z594);
    const bicycle_lanes z722 = z590 * z594;
    bicycle_put(carried + 91 * BICYCLE_LANES, z722);
    const bicycle_lanes z723 = z175 * z722;
    const bicycle_lanes z724 = z176 * z722;
    const bicycle_lanes z725 = z178 * z722;
    const bicycle_lanes z726 = z591 * z594 - z590 * z595;
    bicycle_put(carried + 92 * BICYCLE_LANES, z726);
    const bicycle_lanes z727 = z566 * z594 + z204 * z722 + k29 * z723 - k28 * z724 - k23 * z725 - z155 * z726;
    const bicycle_lanes z728 = z592 * z594 - z590 * z596;
    bicycle_put(carried + 93 * BICYCLE_LANES, z728);
    const bicycle_lanes z729 = z177 * z722;
    const bicycle_lanes z730 = z194 * z722;
    const bicycle_lanes z731 = z192 * z722;
    const bicycle_lanes z732 = z552 * z594 - z195 * z722 - k51 * z729 + k44 * z730 + k36 * z731 - z146 * z726;
    const bicycle_lanes z733 = z732 - z102 * z728;
    const bicycle_lanes z734 = F_yy * z726;
    const bicycle_lanes z735 = F_yy * z728;
    const bicycle_lanes z736 = z196 * z722;
    bicycle_put(carried + 94 * BICYCLE_LANES, z736);
    const bicycle_lanes z737 = z198 * z722;
    bicycle_put(carried + 95 * BICYCLE_LANES, z737);
    const bicycle_lanes z738 = z197 * z722;
    const bicycle_lanes z739 = z556 * z594 + z199 * z722 + k47 * z736 - k36 * z737 + k33 * z738 + z150 * z726;
    const bicycle_lanes z740 = z532 * z612 + 2.0 * (z212 * (F_yy * z722)) + z147 * z734 + z103 * z735 + (z739
        + z106 * z728);
    bicycle_put(carried + 96 * BICYCLE_LANES, z740);
    const bicycle_lanes z741 = z557 * z594 - z200 * z722 - k50 * z729 + k43 * z730 - k33 * z731 - z151 * z726;
    const bicycle_lanes z742 = z741 - z107 * z728;
    bicycle_put(carried + 97 * BICYCLE_LANES, z742);
    const bicycle_lanes z743 = s_steer * z740 - c_steer * z742;
    const bicycle_lanes z744 = z562 * z594 + z202 * z722 + k36 * z729 + k33 * z730 - k31 * z731 + z153 * z726;
    const bicycle_lanes z745 = z744 + z109 * z728;
    bicycle_put(carried + 98 * BICYCLE_LANES, z745);
    const bicycle_lanes z746 = z563 * z594 + z203 * z722 + k33 * z736 + k31 * z738 + z154 * z726 + z110 *
        z728;
    bicycle_put(carried + 99 * BICYCLE_LANES, z746);
    const bicycle_lanes z747 = c_steer * z745 - s_steer * z746;
    const bicycle_lanes z748 = z574 * z594 + z209 * z722 + k23 * z723 + k22 * z724 - k21 * z725 - z160 * z726;
    const bicycle_lanes z749 = z748 + z116 * z728 + z747;
    bicycle_put(carried + 100 * BICYCLE_LANES, z749);
    const bicycle_lanes z750 = z727 + z111 * z728 - c_lam * z733 - s_lam * z743 + k10 * z747 + z20 * z749;
    bicycle_put(carried + 101 * BICYCLE_LANES, z750);
    const bicycle_lanes z751 = z569 * z594 - z206 * z722 - k28 * z723 + k25 * z724 - k22 * z725 + z157 * z726;
    const bicycle_lanes z752 = z751 - z113 * z728 + s_lam * z733 - c_lam * z743 - k9 * z747 - R3 * z749;
    bicycle_put(carried + 102 * BICYCLE_LANES, z752);
    const bicycle_lanes z753 = z253 * z721 - c_pitch * z750 - s_pitch * z752;
    bicycle_put(carried + 103 * BICYCLE_LANES, z753);
    const bicycle_lanes z754 = R_yy * (roll_dot * z595);
    const bicycle_lanes z755 = z591 * z595;
    bicycle_put(carried + 104 * BICYCLE_LANES, z755);
    const bicycle_lanes z756 = z175 * z726 + z126 * z755;
    const bicycle_lanes z757 = z176 * z726 + z127 * z755;
    const bicycle_lanes z758 = z178 * z726 + z129 * z755;
    const bicycle_lanes z759 = z592 * z595 + z591 * z596;
    bicycle_put(carried + 105 * BICYCLE_LANES, z759);
    const bicycle_lanes z760 = z566 * z595 - z155 * z755 - k29 * z756 + k28 * z757 + k23 * z758 + z111 * z759;
    const bicycle_lanes z761 = z177 * z726 - z128 * z755;
    const bicycle_lanes z762 = z194 * z726 - z145 * z755;
    const bicycle_lanes z763 = z192 * z726 + z143 * z755;
    const bicycle_lanes z764 = z552 * z595 - z146 * z755 + k51 * z761 - k44 * z762 - k36 * z763 - z102 * z759;
    const bicycle_lanes z765 = z532 * z613 + z556 * z595 - z212 * z734 + 2.0 * (z147 * (F_yy * z755)) + z150
        * z755;
    const bicycle_lanes z766 = z196 * z726 - z147 * z755;
    bicycle_put(carried + 106 * BICYCLE_LANES, z766);
    const bicycle_lanes z767 = z198 * z726 - z149 * z755;
    bicycle_put(carried + 107 * BICYCLE_LANES, z767);
    const bicycle_lanes z768 = z197 * z726 - z148 * z755;
    const bicycle_lanes z769 = F_yy * z759;
    const bicycle_lanes z770 = z765 - k47 * z766 + k36 * z767 - k33 * z768 + z103 * z769 + z106 * z759;
    bicycle_put(carried + 108 * BICYCLE_LANES, z770);
    const bicycle_lanes z771 = z557 * z595 - z151 * z755 + k50 * z761 - k43 * z762 + k33 * z763 - z107 * z759;
    bicycle_put(carried + 109 * BICYCLE_LANES, z771);
    const bicycle_lanes z772 = s_steer * z770 - c_steer * z771;
    const bicycle_lanes z773 = z562 * z595 + z153 * z755 - k36 * z761 - k33 * z762 + k31 * z763 + z109 * z759;
    bicycle_put(carried + 110 * BICYCLE_LANES, z773);
    const bicycle_lanes z774 = z563 * z595 + z154 * z755 - k33 * z766 - k31 * z768 + z110 * z759;
    bicycle_put(carried + 111 * BICYCLE_LANES, z774);
    const bicycle_lanes z775 = c_steer * z773 - s_steer * z774;
    const bicycle_lanes z776 = z574 * z595 - z160 * z755 - k23 * z756 - k22 * z757 + k21 * z758 + z116 * z759;
    const bicycle_lanes z777 = z776 + z775;
    bicycle_put(carried + 112 * BICYCLE_LANES, z777);
    const bicycle_lanes z778 = z760 - c_lam * z764 - s_lam * z772 + k10 * z775 + z20 * z777;
    bicycle_put(carried + 113 * BICYCLE_LANES, z778);
    const bicycle_lanes z779 = z569 * z595 + z157 * z755 + k28 * z756 - k25 * z757 + k22 * z758 - z113 * z759;
    const bicycle_lanes z780 = z779 + s_lam * z764 - c_lam * z772 - k9 * z775 - R3 * z777;
    bicycle_put(carried + 114 * BICYCLE_LANES, z780);
    const bicycle_lanes z781 = z253 * z754 - c_pitch * z778 - s_pitch * z780;
    bicycle_put(carried + 115 * BICYCLE_LANES, z781);
    const bicycle_lanes z782 = R_yy * (roll_dot * z596);
    const bicycle_lanes z783 = z592 * z596;
    bicycle_put(carried + 116 * BICYCLE_LANES, z783);
    const bicycle_lanes z784 = z175 * z728 + z126 * z759 - z82 * z783;
    const bicycle_lanes z785 = z176 * z728 + z127 * z759 + z83 * z783;
    const bicycle_lanes z786 = z178 * z728 + z129 * z759 + z85 * z783;
    const bicycle_lanes z787 = z177 * z728 - z128 * z759 - z84 * z783;
    const bicycle_lanes z788 = z194 * z728 - z145 * z759 - z101 * z783;
    const bicycle_lanes z789 = z192 * z728 + z143 * z759 + z99 * z783;
    const bicycle_lanes z790 = z552 * z596 - z102 * z783 + k51 * z787 - k44 * z788 - k36 * z789;
    const bicycle_lanes z791 = z566 * z596 + z111 * z783 - k29 * z784 + k28 * z785 + k23 * z786 - c_lam *
        z790;
    const bicycle_lanes z792 = z532 * z614 + z556 * z596 - z212 * z735 + z147 * z769 + 2.0 * (z103 * (F_yy *
        z783));
    const bicycle_lanes z793 = z196 * z728 - z147 * z759 - z103 * z783;
    bicycle_put(carried + 117 * BICYCLE_LANES, z793);
    const bicycle_lanes z794 = z198 * z728 - z149 * z759 - z105 * z783;
    bicycle_put(carried + 118 * BICYCLE_LANES, z794);
    const bicycle_lanes z795 = z197 * z728 - z148 * z759 - z104 * z783;
    const bicycle_lanes z796 = z792 + z106 * z783 - k47 * z793 + k36 * z794 - k33 * z795;
    bicycle_put(carried + 119 * BICYCLE_LANES, z796);
    const bicycle_lanes z797 = z557 * z596 - z107 * z783 + k50 * z787 - k43 * z788 + k33 * z789;
    bicycle_put(carried + 120 * BICYCLE_LANES, z797);
    const bicycle_lanes z798 = s_steer * z796 - c_steer * z797;
    const bicycle_lanes z799 = z562 * z596 + z109 * z783 - k36 * z787 - k33 * z788 + k31 * z789;
    bicycle_put(carried + 121 * BICYCLE_LANES, z799);
    const bicycle_lanes z800 = z563 * z596 + z110 * z783 - k33 * z793 - k31 * z795;
    bicycle_put(carried + 122 * BICYCLE_LANES, z800);
    const bicycle_lanes z801 = c_steer * z799 - s_steer * z800;
    const bicycle_lanes z802 = z574 * z596 + z116 * z783 - k23 * z784 - k22 * z785 + k21 * z786 + z801;
    bicycle_put(carried + 123 * BICYCLE_LANES, z802);
    const bicycle_lanes z803 = z791 - s_lam * z798 + k10 * z801 + z20 * z802;
    bicycle_put(carried + 124 * BICYCLE_LANES, z803);
    const bicycle_lanes z804 = z569 * z596 - z113 * z783 + k28 * z784 - k25 * z785 + k22 * z786 + s_lam *
        z790;
    const bicycle_lanes z805 = z804 - c_lam * z798 - k9 * z801 - R3 * z802;
    bicycle_put(carried + 125 * BICYCLE_LANES, z805);
    const bicycle_lanes z806 = z253 * z782 - c_pitch * z803 - s_pitch * z805;
    bicycle_put(carried + 126 * BICYCLE_LANES, z806);
    const bicycle_lanes z807 = z174 * z721 + z125 * z754 + z81 * z782 - R_yy * (z261 * z596) + z478 * z621 -
        z476 * z622;
    const bicycle_lanes z808 = z676 - z252 * z622;
    bicycle_put(carried + 127 * BICYCLE_LANES, z808);
    const bicycle_lanes z809 = z252 * z621 + z685;
    bicycle_put(carried + 128 * BICYCLE_LANES, z809);
    const bicycle_lanes z810 = z807 + z20 * z808 - R3 * z809;
    bicycle_put(carried + 129 * BICYCLE_LANES, z810);
    const bicycle_lanes z811 = z501 * z648 + z485 * z646 + z513 * z641 + z810;
    bicycle_put(carried + 130 * BICYCLE_LANES, z811);
    const bicycle_lanes z812 = z64 * z811;
    bicycle_put(carried + 131 * BICYCLE_LANES, z812);
    const bicycle_lanes z813 = z15 * z646;
    bicycle_put(carried + 132 * BICYCLE_LANES, z813);
}

static void bicycle_jacobian_sweep1_part2(double t, const double *y, const double *p, const double *kept,
    const double *seed, double *carried, double *slope)
{
    (void)seed;
    (void)t;
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const double s_pitch = kept[2];
    const double c_pitch = kept[3];
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double s_lam = kept[8];
    const double c_lam = kept[9];
    const double k3 = kept[10];
    const double k9 = kept[11];
    const double k10 = kept[12];
    const double k12 = kept[13];
    const double k21 = kept[19];
    const double k22 = kept[20];
    const double k23 = kept[21];
    const double k27 = kept[23];
    const double k31 = kept[26];
    const double k36 = kept[28];
    const double k55 = kept[34];
    const double k56 = kept[35];
    const double k57 = kept[36];
    const double k58 = kept[37];
    const double k59 = kept[38];
    const double k60 = kept[39];
    const double k61 = kept[40];
    const double k62 = kept[41];
    const double k63 = kept[42];
    const double k64 = kept[43];
    const double z1 = kept[44];
    const double e3z = kept[45];
    const double z2 = kept[46];
    const double z3 = kept[47];
    const double z5 = kept[49];
    const double R3 = kept[50];
    const double z6 = kept[51];
    const double z7 = kept[52];
    const double z10 = kept[55];
    const double z11 = kept[56];
    const double z12 = kept[57];
    const double z14 = kept[59];
    const double z15 = kept[60];
    const double z16 = kept[61];
    const double z18 = kept[63];
    const double z19 = kept[64];
    const double z20 = kept[65];
    const double z21 = kept[66];
    const double z22 = kept[67];
    const double z23 = kept[68];
    const double z25 = kept[70];
    const double z26 = kept[71];
    const double z27 = kept[72];
    const double z29 = kept[74];
    const double z30 = kept[75];
    const double z32 = kept[77];
    const double z33 = kept[78];
    const double z34 = kept[79];
    const double z35 = kept[80];
    const double z38 = kept[83];
    const double z39 = kept[84];
    const double z40 = kept[85];
    const double z41 = kept[86];
    const double z43 = kept[88];
    const double z44 = kept[89];
    const double z46 = kept[91];
    const double z47 = kept[92];
    const double z52 = kept[94];
    const double z53 = kept[95];
    const double z54 = kept[96];
    const double z55 = kept[97];
    const double z57 = kept[99];
    const double z58 = kept[100];
    const double z59 = kept[101];
    const double z60 = kept[102];
    const double z61 = kept[103];
    const double z62 = kept[104];
    const double z64 = kept[106];
    const double z65 = kept[107];
    const double z66 = kept[108];
    const double z67 = kept[109];
    const double z70 = kept[110];
    const double z73 = kept[111];
    const double z74 = kept[112];
    const double z75 = kept[113];
    const double z76 = kept[114];
    const double z77 = kept[115];
    const double z78 = kept[116];
    const double z79 = kept[117];
    const double z80 = kept[118];
    const double z81 = kept[119];
    const double z82 = kept[120];
    const double z83 = kept[121];
    const double z86 = kept[124];
    const double z87 = kept[125];
    const double z88 = kept[126];
    const double z90 = kept[128];
    const double z92 = kept[130];
    const double z93 = kept[131];
    const double z94 = kept[132];
    const double z96 = kept[133];
    const double z98 = kept[134];
    const double z100 = kept[136];
    const double z108 = kept[144];
    const double z112 = kept[148];
    const double z114 = kept[150];
    const double z115 = kept[151];
    const double z120 = kept[154];
    const double z121 = kept[155];
    const double z122 = kept[156];
    const double z123 = kept[157];
    const double z124 = kept[158];
    const double z125 = kept[159];
    const double z126 = kept[160];
    const double z127 = kept[161];
    const double z130 = kept[164];
    const double z131 = kept[165];
    const double z132 = kept[166];
    const double z134 = kept[168];
    const double z136 = kept[170];
    const double z137 = kept[171];
    const double z138 = kept[172];
    const double z140 = kept[173];
    const double z142 = kept[174];
    const double z144 = kept[176];
    const double z152 = kept[184];
    const double z156 = kept[188];
    const double z158 = kept[190];
    const double z159 = kept[191];
    const double z170 = kept[198];
    const double z171 = kept[199];
    const double z172 = kept[200];
    const double z173 = kept[201];
    const double z174 = kept[202];
    const double z175 = kept[203];
    const double z176 = kept[204];
    const double z179 = kept[207];
    const double z180 = kept[208];
    const double z181 = kept[209];
    const double z183 = kept[211];
    const double z185 = kept[213];
    const double z186 = kept[214];
    const double z187 = kept[215];
    const double z189 = kept[216];
    const double z191 = kept[217];
    const double z193 = kept[219];
    const double z201 = kept[227];
    const double z205 = kept[231];
    const double z207 = kept[233];
    const double z208 = kept[234];
    const double z224 = kept[242];
    const double z225 = kept[243];
    const double z228 = kept[244];
    const double z230 = kept[246];
    const double z231 = kept[247];
    const double z233 = kept[249];
    const double z235 = kept[251];
    const double z237 = kept[253];
    const double z240 = kept[255];
    const double z241 = kept[256];
    const double z242 = kept[257];
    const double z243 = kept[258];
    const double z244 = kept[259];
    const double z246 = kept[261];
    const double z247 = kept[262];
    const double z248 = kept[263];
    const double z249 = kept[264];
    const double z250 = kept[265];
    const double z252 = kept[266];
    const double z253 = kept[267];
    const double a3 = kept[268];
    const double a1 = kept[269];
    const double z261 = kept[272];
    const double w1_pitch = kept[273];
    const double w3_pitch = kept[274];
    const double z267 = kept[278];
    const double z271 = kept[279];
    const double z276 = kept[280];
    const double z444 = kept[305];
    const double z445 = kept[306];
    const double z446 = kept[307];
    const double z447 = kept[308];
    const double z448 = kept[309];
    const double z449 = kept[310];
    const double z450 = kept[311];
    const double z452 = kept[312];
    const double z453 = kept[313];
    const double z454 = kept[314];
    const double z456 = kept[315];
    const double z457 = kept[316];
    const double z458 = kept[317];
    const double z459 = kept[318];
    const double z460 = kept[319];
    const double z461 = kept[320];
    const double z462 = kept[321];
    const double z463 = kept[322];
    const double z464 = kept[323];
    const double z466 = kept[324];
    const double z468 = kept[325];
    const double z469 = kept[326];
    const double z470 = kept[327];
    const double z471 = kept[328];
    const double z472 = kept[329];
    const double z473 = kept[330];
    const double z474 = kept[331];
    const double z475 = kept[332];
    const double z476 = kept[333];
    const double z477 = kept[334];
    const double z478 = kept[335];
    const double z479 = kept[336];
    const double z481 = kept[337];
    const double z483 = kept[338];
    const double z486 = kept[340];
    const double z489 = kept[341];
    const double z490 = kept[342];
    const double z492 = kept[344];
    const double z493 = kept[345];
    const double z494 = kept[346];
    const double z495 = kept[347];
    const double z499 = kept[348];
    const double z500 = kept[349];
    const double z503 = kept[351];
    const double z504 = kept[352];
    const double z506 = kept[354];
    const double z507 = kept[355];
    const double z508 = kept[356];
    const double z509 = kept[357];
    const double z511 = kept[358];
    const double z512 = kept[359];
    const double z515 = kept[361];
    const double z516 = kept[362];
    const double z518 = kept[364];
    const double z519 = kept[365];
    const double z520 = kept[366];
    const double z521 = kept[367];
    const double z522 = kept[368];
    const double z523 = kept[369];
    const double z524 = kept[370];
    const double z525 = kept[371];
    const double z526 = kept[372];
    const double z527 = kept[373];
    const double z528 = kept[374];
    const double z529 = kept[375];
    const double z530 = kept[376];
    const double z531 = kept[377];
    const double z533 = kept[379];
    const double z534 = kept[380];
    const double z537 = kept[381];
    const double z538 = kept[382];
    const double z539 = kept[383];
    const double z545 = kept[385];
    const double z560 = kept[397];
    const double z565 = kept[402];
    const double z567 = kept[404];
    const double z568 = kept[405];
    const double z571 = kept[408];
    const double z572 = kept[409];
    const double z573 = kept[410];
    const double z575 = kept[412];
    const double z576 = kept[413];
    const double z577 = kept[414];
    const double z579 = kept[416];
    const double z580 = kept[417];
    const bicycle_lanes z594 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z595 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z596 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z597 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z598 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z599 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z600 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z601 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z602 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z603 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z604 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z605 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z606 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z608 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z610 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z611 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z615 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z617 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z618 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z619 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z620 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z621 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z622 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z623 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z624 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z625 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z626 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z627 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z628 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z629 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z630 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z634 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z635 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z637 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z638 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z639 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z640 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z641 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z642 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z643 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z644 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z645 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z646 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z647 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z648 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z649 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z650 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z651 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z652 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z653 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z654 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z657 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z658 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z659 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z660 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z661 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z662 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z663 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z664 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z665 = bicycle_get(carried + 59 * BICYCLE_LANES);
    const bicycle_lanes z666 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z667 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z668 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z669 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z670 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z671 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z674 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z675 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z677 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z678 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z679 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z680 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z682 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z683 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z684 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z686 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z688 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z689 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z690 = bicycle_get(carried + 78 * BICYCLE_LANES);
    const bicycle_lanes z691 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z694 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z695 = bicycle_get(carried + 81 * BICYCLE_LANES);
    const bicycle_lanes z696 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z705 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z706 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z711 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z714 = bicycle_get(carried + 86 * BICYCLE_LANES);
    const bicycle_lanes z715 = bicycle_get(carried + 87 * BICYCLE_LANES);
    const bicycle_lanes z716 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z719 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z720 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z722 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z726 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z728 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z736 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z737 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z740 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z742 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z745 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z746 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z749 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z750 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z752 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z753 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z755 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z759 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z766 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z767 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z770 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z771 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z773 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z774 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z777 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z778 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z780 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z781 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z783 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z793 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z794 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z796 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z797 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z799 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z800 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z802 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z803 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z805 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z806 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z808 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z809 = bicycle_get(carried + 128 * BICYCLE_LANES);
    const bicycle_lanes z810 = bicycle_get(carried + 129 * BICYCLE_LANES);
    const bicycle_lanes z811 = bicycle_get(carried + 130 * BICYCLE_LANES);
    const bicycle_lanes z812 = bicycle_get(carried + 131 * BICYCLE_LANES);
    const bicycle_lanes z813 = bicycle_get(carried + 132 * BICYCLE_LANES);
    const bicycle_lanes z814 = z40 * z646;
    const bicycle_lanes z815 = c_lam * z813 - s_lam * z814 - k3 * z646;
    const bicycle_lanes z816 = s_lam * z813 + c_lam * z814 - k12 * z646;
    const bicycle_lanes z817 = z40 * z648 + z15 * z641 + k3 * (s_lam * z648 - c_lam * z641) - k12 * z677;
    const bicycle_lanes z818 = c_steer * z816 - s_steer * z817;
    const bicycle_lanes z819 = z635 - c_lam * z815 + z20 * z678 + k10 * z678 - s_lam * z818;
    const bicycle_lanes z820 = z261 * z637 - z18 * z664 + z52 * z651 - z57 * z658 + roll_dot * z819 - c_roll
        * z695;
    const bicycle_lanes z821 = z637 - s_lam * z815 + R3 * z678 + k9 * z678 + c_lam * z818;
    const bicycle_lanes z822 = z261 * z635 - z22 * z664 + z53 * z651 - z58 * z658 - roll_dot * z821 + c_roll
        * z694;
    const bicycle_lanes z823 = z571 * z598 + z573 * z599 + z565 * z627 + z567 * z628 - k27 * (w1_pitch * z627
        + w3_pitch * z628);
    const bicycle_lanes z824 = z823 + k23 * (w1_pitch * z629 + z252 * z599) + k22 * (z252 * z598 + w3_pitch *
        z629) + z537 * z610;
    const bicycle_lanes z825 = z824 + z538 * z611 - a1 * z621 - a3 * z622 - z445 * z615 - z453 * z617 - k10 *
        (w1_pitch * z630 - z252 * z611);
    const bicycle_lanes z826 = z825 + k9 * (z252 * z610 + w3_pitch * z630) + c_steer * z706 + s_steer * z711
        - z810;
    const bicycle_lanes z827 = z506 * z648 + z492 * z646 + z518 * z641 + c_pitch * z820 + s_pitch * z822 -
        z826;
    const bicycle_lanes z828 = z64 * z827;
    const bicycle_lanes z829 = R_yy * z726;
    const bicycle_lanes z830 = R_yy * z728;
    const bicycle_lanes z831 = z185 * z722;
    const bicycle_lanes z832 = z189 * z722;
    const bicycle_lanes z833 = z572 * z594 - z207 * z722 + k23 * z831 - k21 * z832 - z158 * z726 - z114 *
        z728;
    const bicycle_lanes z834 = z560 * z594 + z201 * z722 - k36 * z736 + k31 * z737 + z152 * z726 + z108 *
        z728;
    const bicycle_lanes z835 = s_steer * z745 + c_steer * z746;
    const bicycle_lanes z836 = c_lam * z834 - s_lam * z835;
    const bicycle_lanes z837 = z833 - z836;
    const bicycle_lanes z838 = z534 * z618 + 2.0 * (z186 * (R_yy * z722)) + z137 * z829 + z93 * z830 - z20 *
        z837;
    const bicycle_lanes z839 = z187 * z722;
    const bicycle_lanes z840 = z575 * z594 + z208 * z722 + k22 * z831 + k21 * z839 + z159 * z726 + z115 *
        z728;
    const bicycle_lanes z841 = s_lam * z834 + c_lam * z835;
    const bicycle_lanes z842 = z840 + z841;
    const bicycle_lanes z843 = z838 + R3 * z842;
    const bicycle_lanes z844 = z64 * z843;
    const bicycle_lanes z845 = z568 * z594 + z205 * z722 + k27 * z831 - k23 * z832 + k22 * z839 + z156 * z726;
    const bicycle_lanes z846 = z845 + z112 * z728 + c_steer * z740 + s_steer * z742 - k10 * z836 - k9 * z841
        - z843;
    const bicycle_lanes z847 = z64 * z846;
    const bicycle_lanes z848 = z523 * z625 + z509 * z626 - z241 * z812 + z246 * z828 + z171 * z844 + z170 *
        z847;
    const bicycle_lanes z849 = R_yy * z759;
    const bicycle_lanes z850 = z185 * z726 - z136 * z755;
    const bicycle_lanes z851 = z189 * z726 - z140 * z755;
    const bicycle_lanes z852 = z560 * z595 + z152 * z755 + k36 * z766 - k31 * z767 + z108 * z759;
    const bicycle_lanes z853 = s_steer * z773 + c_steer * z774;
    const bicycle_lanes z854 = c_lam * z852 - s_lam * z853;
    const bicycle_lanes z855 = z572 * z595 - z158 * z755 - k23 * z850 + k21 * z851 - z114 * z759 - z854;
    const bicycle_lanes z856 = z534 * z619 - z186 * z829 + 2.0 * (z137 * (R_yy * z755)) + z93 * z849 - z20 *
        z855;
    const bicycle_lanes z857 = z187 * z726 - z138 * z755;
    const bicycle_lanes z858 = s_lam * z852 + c_lam * z853;
    const bicycle_lanes z859 = z575 * z595 + z159 * z755 - k22 * z850 - k21 * z857 + z115 * z759 + z858;
    const bicycle_lanes z860 = z856 + R3 * z859;
    const bicycle_lanes z861 = z64 * z860;
    const bicycle_lanes z862 = z568 * z595 + z156 * z755 - k27 * z850 + k23 * z851 - k22 * z857 + z112 * z759;
    const bicycle_lanes z863 = z862 + c_steer * z770 + s_steer * z771 - k10 * z854 - k9 * z858 - z860;
    const bicycle_lanes z864 = z64 * z863;
    const bicycle_lanes z865 = z185 * z728 - z136 * z759 - z92 * z783;
    const bicycle_lanes z866 = z189 * z728 - z140 * z759 - z96 * z783;
    const bicycle_lanes z867 = z560 * z596 + z108 * z783 + k36 * z793 - k31 * z794;
    const bicycle_lanes z868 = s_steer * z799 + c_steer * z800;
    const bicycle_lanes z869 = c_lam * z867 - s_lam * z868;
    const bicycle_lanes z870 = z572 * z596 - z114 * z783 - k23 * z865 + k21 * z866 - z869;
    const bicycle_lanes z871 = z534 * z620 - z186 * z830 + z137 * z849 + 2.0 * (z93 * (R_yy * z783)) - z20 *
        z870;
    const bicycle_lanes z872 = z187 * z728 - z138 * z759 - z94 * z783;
    const bicycle_lanes z873 = s_lam * z867 + c_lam * z868;
    const bicycle_lanes z874 = z575 * z596 + z115 * z783 - k22 * z865 - k21 * z872 + z873;
    const bicycle_lanes z875 = z871 + R3 * z874;
    const bicycle_lanes z876 = z64 * z875;
    const bicycle_lanes z877 = z568 * z596 + z112 * z783 - k27 * z865 + k23 * z866 - k22 * z872 + c_steer *
        z796;
    const bicycle_lanes z878 = z877 + s_steer * z797 - k10 * z869 - k9 * z873 - z875;
    const bicycle_lanes z879 = z64 * z878;
    const bicycle_lanes z880 = z446 * z638 + z452 * z624 + z507 * z648 - z493 * z646 + z519 * z641 - c_roll *
        z720;
    const bicycle_lanes z881 = z880 + e2z * z826;
    const bicycle_lanes z882 = z533 * z623 + z522 * z624 - z524 * z639 - z244 * z811 + z247 * z827 - z249 *
        z881;
    const bicycle_lanes z883 = c_roll * z753 + e2z * z846;
    const bicycle_lanes z884 = c_roll * z781 + e2z * z863;
    const bicycle_lanes z885 = z882 + z181 * z843 + z183 * z846 - z172 * z883 - z132 * z860 - z134 * z863 -
        z123 * z884;
    const bicycle_lanes z886 = c_roll * z806 + e2z * z878;
    const bicycle_lanes z887 = z271 * (z885 - z88 * z875 - z90 * z878 - z79 * z886);
    const bicycle_lanes z888 = z848 - z122 * z861 - z121 * z864 - z78 * z876 - z77 * z879 - z47 * z887;
    const bicycle_lanes z889 = z29 * z812 - z27 * z828;
    const bicycle_lanes z890 = z29 * z844 + z27 * z847;
    const bicycle_lanes z891 = z29 * z876 + z27 * z879;
    const bicycle_lanes z892 = z520 * z625 - z243 * z812 - z15 * z844 - z70 * z876 - z27 * z887;
    const bicycle_lanes z893 = z520 * z626 + z243 * z828 - z15 * z847 - z70 * z879 + z29 * z887;
    const bicycle_lanes z894 = z508 * z643 - z240 * z889 - z40 * z890 - z76 * z891 + z46 * z892 + z34 * z893;
    const bicycle_lanes z895 = z696 - z250 * z720 + z173 * z753 + z124 * z781 + z80 * z806 - z23 * z888 - z54
        * z894;
    const bicycle_lanes z896 = z29 * z861 + z27 * z864;
    const bicycle_lanes z897 = z494 * z643 - z235 * z889 - z120 * z896 - z75 * z891 + z43 * z892 + z38 * z893;
    const bicycle_lanes z898 = z529 * z634 - z534 * z622 + z463 * z678 + w1_pitch * z715 - z253 * z809 - z512
        * z679;
    const bicycle_lanes z899 = z64 * z881;
    const bicycle_lanes z900 = z30 * z812 - z27 * z899;
    const bicycle_lanes z901 = z30 * z828 - z29 * z899;
    const bicycle_lanes z902 = z60 * z889 + z46 * z900 - z34 * z901;
    const bicycle_lanes z903 = z55 * z889 - z43 * z900 + z38 * z901;
    const bicycle_lanes z904 = z62 * z812 - z61 * z828 + z47 * z899;
    const bicycle_lanes z905 = c_lam * z903 + s_lam * z904;
    const bicycle_lanes z906 = z445 * z646 + z453 * z677 - c_steer * z902 + s_steer * z905;
    const bicycle_lanes z907 = z898 - z500 * z680 + z481 * z682 - z224 * z906 + z176 * z749 - z186 * z842 +
        z127 * z777;
    const bicycle_lanes z908 = z64 * z886;
    const bicycle_lanes z909 = z30 * z876 - z27 * z908;
    const bicycle_lanes z910 = z30 * z879 + z29 * z908;
    const bicycle_lanes z911 = z60 * z891 + z46 * z909 + z34 * z910;
    const bicycle_lanes z912 = z55 * z891 - z43 * z909 - z38 * z910;
    const bicycle_lanes z913 = z62 * z876 + z61 * z879 + z47 * z908;
    const bicycle_lanes z914 = c_lam * z912 + s_lam * z913;
    const bicycle_lanes z915 = c_steer * z911 - s_steer * z914;
    const bicycle_lanes z916 = z64 * z883;
    const bicycle_lanes z917 = z521 * z626 + z523 * z640 + z242 * z828 + z241 * z899 - z180 * z847 - z171 *
        z916;
    const bicycle_lanes z918 = z64 * z884;
    const bicycle_lanes z919 = z521 * z625 - z509 * z640 - z452 * z642 - z242 * z812 - z246 * z899 - z180 *
        z844;
    const bicycle_lanes z920 = z919 + z170 * z916 - z131 * z861 - z121 * z918 - z87 * z876 - z77 * z908 + z61
        * z887;
    const bicycle_lanes z921 = z920 - e2z * z888;
    const bicycle_lanes z922 = z917 - z131 * z864 + z122 * z918 - z87 * z879 + z78 * z908 - z62 * z887 + z921;
    const bicycle_lanes z923 = z30 * z864 + z29 * z918;
    const bicycle_lanes z924 = z520 * z640 + z243 * z899 + z15 * z916 + z70 * z908 + z30 * z887;
    const bicycle_lanes z925 = z494 * z645 + z235 * z901 - z120 * z923 - z75 * z910 + z55 * z893 - z43 * z924;
    const bicycle_lanes z926 = z30 * z861 - z27 * z918;
    const bicycle_lanes z927 = z494 * z644 + z452 * z649 - z235 * z900 - z120 * z926 - z75 * z909 + z55 *
        z892;
    const bicycle_lanes z928 = z927 + z38 * z924 + e2z * z897;
    const bicycle_lanes z929 = z925 + z928;
    const bicycle_lanes z930 = z907 + z137 * z859 + z83 * z802 + z93 * z874 + c_pitch * z915 - z26 * z922 -
        z33 * z929;
    const bicycle_lanes z931 = z446 * z642 - c_roll * z888;
    const bicycle_lanes z932 = z447 * z664 + s_pitch * z931;
    const bicycle_lanes z933 = z446 * z647 + c_roll * z894;
    const bicycle_lanes z934 = z447 * z651 + s_pitch * z933;
    const bicycle_lanes z935 = z446 * z649 - c_roll * z897;
    const bicycle_lanes z936 = z447 * z658 + s_pitch * z935;
    const bicycle_lanes z937 = z483 * z665 + z445 * z652 + z481 * z659 - z1 * z932 + c_steer * z934 - z35 *
        z936;
    const bicycle_lanes z938 = z30 * z847 + z29 * z916;
    const bicycle_lanes z939 = z508 * z645 + z240 * z901 - z40 * z938 - z76 * z910 - z60 * z893 - z46 * z924;
    const bicycle_lanes z940 = z30 * z844 - z27 * z916;
    const bicycle_lanes z941 = z508 * z644 - z452 * z647 - z240 * z900 - z40 * z940 - z76 * z909 - z60 * z892;
    const bicycle_lanes z942 = z941 + z34 * z924 + e2z * z894;
    const bicycle_lanes z943 = z939 + z942;
    const bicycle_lanes z944 = z930 - z937 + z35 * z943;
    const bicycle_lanes z945 = z530 * z634 - z534 * z621 + z464 * z678 - w3_pitch * z715 - z253 * z808 - z511
        * z679;
    const bicycle_lanes z946 = z945 + z483 * z682 - z499 * z680 + z225 * z906 + z175 * z749 - z186 * z837 +
        z126 * z777;
    const bicycle_lanes z947 = z946 + z137 * z855 - z82 * z802 + z93 * z870 - s_pitch * z915 + z25 * z922 +
        z1 * z943;
    const bicycle_lanes z948 = z449 * z664 - c_pitch * z931;
    const bicycle_lanes z949 = z449 * z651 - c_pitch * z933;
    const bicycle_lanes z950 = z449 * z658 - c_pitch * z935;
    const bicycle_lanes z951 = z483 * z666 + z445 * z653 + z481 * z660 + z1 * z948 - c_steer * z949 + z35 *
        z950;
    const bicycle_lanes z952 = z947 + z32 * z929 - z951;
    const bicycle_lanes z953 = z5 * (z267 * (z472 * z684 + z477 * z688 - z473 * z690 - z2 * z944 + z19 *
        z952));
    const bicycle_lanes z954 = z474 * z689 * z580 - 0.5 * z953;
    const bicycle_lanes z955 = z450 * z691 - k56 * z597 + k55 * z598 - 2.0 * (e3z * z954) + r_R * (z475 *
        z684 + z5 * z944);
    const bicycle_lanes z956 = k64 * z600 - k63 * z601 + k60 * z602;
    const bicycle_lanes z957 = z495 * z648 + z468 * z646 + z237 * z903 + z230 * z902 + z55 * z890 - z43 *
        z940;
    const bicycle_lanes z958 = c_lam * z934 - s_lam * z949;
    const bicycle_lanes z959 = z453 * z650 + z445 * z654 - s_steer * z942 + c_steer * z958;
    const bicycle_lanes z960 = z60 * z896 + z46 * z926 + z34 * z923 - (c_lam * z949 + s_lam * z934);
    const bicycle_lanes z961 = c_lam * z936 - s_lam * z950;
    const bicycle_lanes z962 = z957 - z38 * z938 + z66 * z912 + z73 * z911 - c_lam * z959 + s_lam * z960 +
        (z445 * z657 - z453 * z661 - c_steer * z928 + s_steer * z961);
    const bicycle_lanes z963 = z471 * z646 + z495 * z641 - z231 * z902 + z237 * z904 + z62 * z844 + z61 *
        z847;
    const bicycle_lanes z964 = c_lam * z932 - s_lam * z948;
    const bicycle_lanes z965 = z963 + z47 * z916 - z74 * z911 + z66 * z913 + (z445 * z663 - z453 * z667 +
        c_steer * z921 + s_steer * z964);
    const bicycle_lanes z966 = z965 - c_lam * z960 - s_lam * z959;
    const bicycle_lanes z967 = z14 * (z276 * (z457 * z662 - z469 * z668 - z459 * z670 - z39 * z962 - z11 *
        z966));
    const bicycle_lanes z968 = z460 * z669 * z579 - 0.5 * z967;
    const bicycle_lanes z969 = z456 * z671 - 2.0 * (z12 * z968) + r_F * (z461 * z662 + z14 * z962);
    const bicycle_lanes z970 = z458 * z671 - 2.0 * (z10 * z968) - r_F * (z461 * z668 - z14 * z966);
    const bicycle_lanes z971 = k62 * z604 + k60 * z605 + k59 * z604 + s_lam * z969 - c_lam * z970;
    const bicycle_lanes z972 = z445 * z674 - s_steer * z956 + c_steer * z971;
    const bicycle_lanes z973 = k61 * z604 - k60 * z608 - k58 * z604 + c_lam * z969 + s_lam * z970;
    const bicycle_lanes z974 = z955 - s_lam * z972 - c_lam * z973;
    const bicycle_lanes z975 = z448 * z691 - k57 * z597 - k55 * z599 - 2.0 * (z3 * z954) + r_R * (z475 * z688
        - z5 * z952);
    const bicycle_lanes z976 = z975 - c_lam * z972 + s_lam * z973;
    const bicycle_lanes z977 = z250 * z638 + z23 * z642 - z54 * z647 + z59 * z649 + c_pitch * z694 + s_pitch
        * z695;
    const bicycle_lanes z978 = z525 * z624 + z518 * z642 + z492 * z647 + z506 * z649 - z250 * z826 + k56 *
        z627;
    const bicycle_lanes z979 = z978 + k57 * z628 - k55 * z629 - z173 * z846 - z124 * z863 - z80 * z878 - z29
        * z888;
    const bicycle_lanes z980 = c_steer * z956 + (roll_dot * z977 - (z453 * z674 + (z979 - z43 * z894 + z46 *
        z897))) + s_steer * z971;
    const bicycle_lanes z981 = e2z * (roll_dot * z675 + (z895 - z59 * z897) + c_pitch * z974 + s_pitch *
        z976) - c_roll * z980;
    bicycle_put(slope + 0 * BICYCLE_LANES, -z981);
    const bicycle_lanes z982 = z470 * z646 - z15 * z902;
    const bicycle_lanes z983 = z462 * z646 - z40 * z902;
    const bicycle_lanes z984 = c_lam * z982 - s_lam * z983 + k3 * z902;
    const bicycle_lanes z985 = s_lam * z982 + c_lam * z983 + k12 * z902;
    const bicycle_lanes z986 = z462 * z648 + z470 * z641 - z40 * z903 - z15 * z904;
    const bicycle_lanes z987 = z986 - k3 * (s_lam * z903 - c_lam * z904) + k12 * z905;
    const bicycle_lanes z988 = z445 * z816 + z453 * z817 + c_steer * z985 - s_steer * z987;
    const bicycle_lanes z989 = z478 * z678 - z716 - c_lam * z984 + z20 * z906 + k10 * z906 - s_lam * z988;
    const bicycle_lanes z990 = z528 * z637 + z515 * z664 + z489 * z651 + z503 * z658 + z248 * z822 - z261 *
        z719;
    const bicycle_lanes z991 = z15 * z911;
    const bicycle_lanes z992 = z40 * z911;
    const bicycle_lanes z993 = c_lam * z991 - s_lam * z992 - k3 * z911;
    const bicycle_lanes z994 = z990 + z174 * z752 + z125 * z780 - z803 + z81 * z805 + c_lam * z993 - z20 *
        z915;
    const bicycle_lanes z995 = s_lam * z991 + c_lam * z992 - k12 * z911;
    const bicycle_lanes z996 = z40 * z912 + z15 * z913 + k3 * (s_lam * z912 - c_lam * z913) - k12 * z914;
    const bicycle_lanes z997 = c_steer * z995 - s_steer * z996;
    const bicycle_lanes z998 = z446 * z695 - (z994 + s_lam * z997 - z18 * z931 + z52 * z933 - z57 * z935 -
        k10 * z915);
    const bicycle_lanes z999 = z476 * z678 - z719 - s_lam * z984 + R3 * z906 + k9 * z906 + c_lam * z988;
    const bicycle_lanes z1000 = z528 * z635 + z516 * z664 + z490 * z651 + z504 * z658 - z248 * z820 - z261 *
        z716;
    const bicycle_lanes z1001 = z1000 - z174 * z750 - z125 * z778 - z81 * z803 - z805 - s_lam * z993 + R3 *
        z915;
    const bicycle_lanes z1002 = z446 * z694 + (z1001 + c_lam * z997 - z22 * z931 + z53 * z933 - z58 * z935 +
        k9 * z915);
    const bicycle_lanes z1003 = c_pitch * (roll_dot * z989 - z998 - c_roll * z976) - s_pitch * (roll_dot *
        z999 - z1002 - c_roll * z974);
    bicycle_put(slope + 1 * BICYCLE_LANES, -z1003);
    const bicycle_lanes z1004 = z527 * z617 + z252 * z615 + z233 * z646 - z228 * z816 - z16 * z663 + s_lam *
        (c_lam * (R3 * z679 - k9 * z663) - s_lam * (z20 * z679 - k10 * z663));
    const bicycle_lanes z1005 = z1004 - z41 * z654 - z21 * z653 + z6 * z652 - z44 * z657 - c_lam * (s_lam *
        (z20 * z680 - k10 * z657) - c_lam * (R3 * z680 - k9 * z657));
    const bicycle_lanes z1006 = z1005 + z7 * z674;
    const bicycle_lanes z1007 = z545 * z603 - z539 * z606 - z531 * z615 - z526 * z617 - z527 * z706 + z479 *
        z677;
    const bicycle_lanes z1008 = z1007 + z466 * z817 - z470 * z667 - z486 * z650 - z462 * z661 - z252 * z711 -
        z193 * z740;
    const bicycle_lanes z1009 = z1008 + z185 * z742 + z191 * z745 + z179 * z746 - z144 * z770 - z136 * z771 -
        z142 * z773;
    const bicycle_lanes z1010 = z233 * z905 + (z1009 + z130 * z774 - z100 * z796 - z92 * z797 - z98 * z799 +
        z86 * z800);
    const bicycle_lanes z1011 = z228 * z987 + z1010 + z67 * z914 - z65 * z996 - z16 * z964 + z41 * z942 - z44
        * z961;
    const bicycle_lanes z1012 = z478 * z660 + z476 * z683 - z21 * z950 - z6 * z936 - R3 * z943 - k9 * z942;
    const bicycle_lanes z1013 = z476 * z665 - z478 * z686 + z21 * z948 + z6 * z932 - z20 * z943 - k10 * z942;
    const bicycle_lanes z1014 = z7 * z956 - (steer_dot * z1006 + (z452 * z674 + (z1011 + c_lam * z1012 -
        s_lam * z1013))) + e2z * z971;
    const bicycle_lanes z1015 = z527 * z615 - z252 * z617 - z233 * z677 + z228 * z817 - z16 * z667 + z41 *
        z650;
    const bicycle_lanes z1016 = z1015 - z44 * z661 + c_lam * (z21 * z660 - z6 * z659 + R3 * z682 - k9 * z650);
    const bicycle_lanes z1017 = z1016 + s_lam * (z21 * z666 - z6 * z665 - z20 * z682 + k10 * z650) - e2z *
        z674;
    const bicycle_lanes z1018 = z539 * z603 + z545 * z606 - z531 * z617 + z526 * z615 + z527 * z711 - z479 *
        z646;
    const bicycle_lanes z1019 = z1018 - z466 * z816 - z470 * z663 + z486 * z654 - z478 * z653 + z476 * z652 -
        z462 * z657;
    const bicycle_lanes z1020 = z1019 + z454 * z674 - z252 * z706 + z185 * z740 + z193 * z742 - z179 * z745 +
        z191 * z746;
    const bicycle_lanes z1021 = z1020 - z136 * z770 + z144 * z771 - z130 * z773 - z142 * z774 - z92 * z796 +
        z100 * z797;
    const bicycle_lanes z1022 = z228 * z985 + (z233 * z902 - (z1021 - z86 * z799 - z98 * z800)) + z67 * z911
        - z65 * z995;
    const bicycle_lanes z1023 = c_lam * (z476 * z679 - R3 * z922 - k9 * z921) - s_lam * (z478 * z679 - z20 *
        z922 - k10 * z921);
    const bicycle_lanes z1024 = z1022 + z16 * z921 - s_lam * z1023 + z41 * z958 - z21 * z949 - z6 * z934 -
        z44 * z928;
    const bicycle_lanes z1025 = s_lam * (z478 * z680 + z20 * z929 + k10 * z928) - c_lam * (z476 * z680 + R3 *
        z929 + k9 * z928);
    const bicycle_lanes z1026 = c_steer * z1014 - s_steer * (e2z * z956 + (steer_dot * z1017 + (z1024 + c_lam
        * z1025)) - z7 * z971);
    bicycle_put(slope + 2 * BICYCLE_LANES, z1026);
    const bicycle_lanes z1027 = z444 * z594 + z576 * z595 + z577 * z596 - z447 * z819 + z449 * z821 + e2z *
        z977;
    bicycle_put(slope + 3 * BICYCLE_LANES, z1027 + c_roll * z675 - s_pitch * z989 - c_pitch * z999);
    bicycle_put(slope + 4 * BICYCLE_LANES, z714 + z984 + c_steer * z1017 - s_steer * z1006);
    bicycle_put(slope + 5 * BICYCLE_LANES, -(z705 + z986));
}

int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[421]; /* what parts of this function leave for others */
    for (int entry = 0; entry < 144; ++entry) {
        J[entry] = 0.0;
    }
    int status = bicycle_jacobian_part1(t, y, p, kept, J);
    if (status == BICYCLE_OK) {
        status = bicycle_jacobian_part2(t, y, p, kept, J);
    }
    if (status == BICYCLE_OK) {
        status = bicycle_jacobian_part3(t, y, p, kept, J);
    }
    if (status != BICYCLE_OK) {
        return status;
    }

    /* one rate in each pass: its row of the matrix */
    for (int first = 0; first < 3; first += BICYCLE_LANES) {
        static const int offset[] = {108, 120, 132};
        static const int entry[] = {4, 5, 6, 9, 10, 11};
        double seed[3 * BICYCLE_LANES];
        double carried[133 * BICYCLE_LANES];
        double slope[6 * BICYCLE_LANES];
        bicycle_unit(3, first, seed);
        bicycle_jacobian_sweep1_part1(t, y, p, kept, seed, carried, slope);
        bicycle_jacobian_sweep1_part2(t, y, p, kept, seed, carried, slope);
        bicycle_place(3 - first, offset + first, 6, entry, slope, J);
    }
    return bicycle_finish(144, J);
}

int bicycle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
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
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = c_lam * k1 - r_R * s_lam;
    const double k4 = s_lam * k3;
    const double k5 = c_lam * k3;
    const double k6 = c_lam * c_lam;
    const double k7 = w * s_lam + c_lam * (r_R - r_F);
    const double k8 = s_lam * k2 - c_lam * k7;
    const double k9 = s_lam * s_lam;
    const double k10 = c_lam * k2 + s_lam * k7;
    const double k11 = fabs(r_R);
    const double k12 = fabs(r_F);
    const double k13 = fabs(w);
    const double k14 = fabs(c);
    const double k15 = 18.0 * k14 + (18.0 * k13 + (34.0 * k11 + 19.0 * k12));

    /* state */
    const double z1 = s_lam * s_steer;
    const double e3z = c_pitch * c_roll;
    const double z2 = r_R * e3z;
    const double z3 = s_pitch * c_roll;
    const double z4 = 1.0 / sqrt(z3 * z3 + e3z * e3z);
    const double R3 = z2 * z4;
    const double z5 = R3 + k4;
    const double z6 = c_steer * (z3 * c_lam + e3z * s_lam) - e2z * s_steer;
    const double z7 = z3 * s_lam - e3z * c_lam;
    const double z8 = c_lam * z6 + s_lam * z7;
    const double z9 = c_lam * z7 - s_lam * z6;
    const double z10 = 1.0 / sqrt(z8 * z8 + z9 * z9);
    const double z11 = r_F * z8 * z10;
    const double z12 = z11 - k10;
    const double z13 = s_steer * z12;
    const double z14 = r_R * z3 * z4;
    const double z15 = z14 + k5;
    const double z16 = s_lam * c_steer;
    const double z17 = k6 + s_lam * z16;
    const double z18 = c_lam * (s_lam - z16);
    const double z19 = z14 * z17 + R3 * z18;
    const double z20 = k5 * z17 + k4 * z18 + z19 - c_steer * z12;
    const double z21 = c_roll * (s_pitch * (z1 * z5 + c_lam * z13) - c_pitch * (z1 * z15 - s_lam * z13)) -
        e2z * z20;
    const double z22 = c_lam * c_steer;
    const double z23 = s_lam * (c_lam - z22);
    const double z24 = c_lam * z22 + k9;
    const double z25 = z14 * z23 + R3 * z24;
    const double z26 = c_lam * s_steer;
    const double z27 = R3 * z26 - z14 * z1;
    const double z28 = r_F * z9;
    const double z29 = z28 * z10;
    const double z30 = k7 - c_lam * z29 - s_lam * z11;
    const double z31 = z26 * k4 - z1 * k5 + z27 - s_steer * z30;
    const double z32 = z29 + k8;
    const double z33 = k5 * z23 + k4 * z24 + z25 + c_steer * z32;
    const double z34 = c_steer * z30;
    const double z35 = k2 + s_lam * z29 - c_lam * z11;
    const double z36 = s_pitch * (c_steer * z5 - c_lam * z34 + s_lam * z35) - c_pitch * (c_steer * z15 +
        s_lam * z34 + c_lam * z35);
    const double z37 = c_roll * z36 - e2z * z31;
    const double z38 = s_steer * z32;
    const double z39 = c_roll * (s_pitch * (z26 * z5 + c_lam * z38) - c_pitch * (z26 * z15 - s_lam * z38)) +
        e2z * z33;
    const double z40 = z33 * z37 + z39 * z31;
    const double z41 = z21 * (z25 * z31 - z33 * z27) - z20 * (z25 * z37 + z39 * z27) + z19 * z40;
    const double z42 = roll_dot * c_pitch;
    const double z43 = roll_dot * s_pitch;
    const double z44 = steer_dot + (s_lam * z42 + c_lam * z43);
    const double z45 = s_lam * z43 - c_lam * z42;
    const double z46 = c_steer * z45;
    const double z47 = z42 * k4 + z43 * k5 + (z42 * R3 + z43 * z14);
    const double z48 = z29 * (s_lam * z44 - c_lam * z46) - z11 * (s_lam * z46 + c_lam * z44) + (k7 * z46 + k2
        * z44 + c_steer * z47);
    const double z49 = s_steer * z45;
    const double z50 = thF_dot + z49;
    const double z51 = k2 * z49;
    const double z52 = k7 * z49 + s_steer * z47;
    const double z53 = z29 * z50 + (s_lam * z51 - c_lam * z52);
    const double z54 = z21 * (z33 * z48 - z31 * z53) + z20 * (z37 * z53 + z39 * z48) + z40 * (z11 * z50 -
        (s_lam * z52 + c_lam * z51));
    /* 123:10 */
    out[0] = -r_R * (z54 / z41); /* speed */
    /* 124:16 */
    out[1] = z + z3 * z14 + e3z * R3; /* rear_height */
    /* 125:17 */
    out[2] = z - z3 * k1 + z2 + c * z8 + z28 + z8 * z11 + z9 * z29; /* front_height */
    /* the coframe is singular */
    if (!(fabs(z41) > 1e-12 * (k15 * (k15 * (13.0 * k14 + (14.0 * k13 + (24.0 * k11 + 33.0 * k12))))))) {
        return BICYCLE_SINGULAR_1;
    }
    return bicycle_finish(3, out);
}

#if BICYCLE_LANES >= 4
static __attribute__((noinline)) void bicycle_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    bicycle_lanes far = {0}; /* the squares of the angles */
    bicycle_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    bicycle_bits bad = {0}; /* singular blocks */
    const double r_R = fixed[0];
    const double R_yy = fixed[1];
    const double r_F = fixed[2];
    const double F_yy = fixed[3];
    const double s_lam = fixed[4];
    const double c_lam = fixed[5];
    const double k3 = fixed[6];
    const double k9 = fixed[7];
    const double k10 = fixed[8];
    const double k11 = fixed[9];
    const double k12 = fixed[10];
    const double k13 = fixed[11];
    const double k14 = fixed[12];
    const double k15 = fixed[13];
    const double k16 = fixed[14];
    const double k17 = fixed[15];
    const double k18 = fixed[16];
    const double k19 = fixed[17];
    const double k20 = fixed[18];
    const double k21 = fixed[19];
    const double k22 = fixed[20];
    const double k23 = fixed[21];
    const double k25 = fixed[22];
    const double k27 = fixed[23];
    const double k28 = fixed[24];
    const double k29 = fixed[25];
    const double k31 = fixed[26];
    const double k33 = fixed[27];
    const double k36 = fixed[28];
    const double k43 = fixed[29];
    const double k44 = fixed[30];
    const double k47 = fixed[31];
    const double k50 = fixed[32];
    const double k51 = fixed[33];
    const double k55 = fixed[34];
    const double k56 = fixed[35];
    const double k57 = fixed[36];
    const double k58 = fixed[37];
    const double k59 = fixed[38];
    const double k60 = fixed[39];
    const double k61 = fixed[40];
    const double k62 = fixed[41];
    const double k63 = fixed[42];
    const double k64 = fixed[43];
    const bicycle_lanes yaw = bicycle_get(y + 3 * stride);
    const bicycle_lanes roll = bicycle_get(y + 4 * stride);
    const bicycle_lanes pitch = bicycle_get(y + 5 * stride);
    const bicycle_lanes steer = bicycle_get(y + 6 * stride);
    const bicycle_lanes roll_dot = bicycle_get(y + 9 * stride);
    const bicycle_lanes steer_dot = bicycle_get(y + 10 * stride);
    const bicycle_lanes thF_dot = bicycle_get(y + 11 * stride);
    bicycle_lanes sine1, cosine1;
    bicycle_turn_lanes(BICYCLE_SPREAD(roll), &far, &sine1, &cosine1);
    const bicycle_lanes c_roll = cosine1;
    bicycle_lanes sine2, cosine2;
    bicycle_turn_lanes(BICYCLE_SPREAD(pitch), &far, &sine2, &cosine2);
    const bicycle_lanes s_pitch = sine2;
    bicycle_lanes sine3, cosine3;
    bicycle_turn_lanes(BICYCLE_SPREAD(steer), &far, &sine3, &cosine3);
    const bicycle_lanes s_steer = sine3;
    const bicycle_lanes z1 = s_lam * s_steer;
    const bicycle_lanes c_pitch = cosine2;
    const bicycle_lanes e3z = c_pitch * c_roll;
    const bicycle_lanes z2 = r_R * e3z;
    const bicycle_lanes z3 = s_pitch * c_roll;
    const bicycle_lanes z4 = z3 * z3 + e3z * e3z;
    const bicycle_lanes z5 = 1.0 / bicycle_each_sqrt(BICYCLE_SPREAD(z4));
    const bicycle_lanes R3 = z2 * z5;
    const bicycle_lanes z6 = R3 + k9;
    const bicycle_lanes c_steer = cosine3;
    const bicycle_lanes z7 = z3 * c_lam + e3z * s_lam;
    const bicycle_lanes e2z = sine1;
    const bicycle_lanes z8 = c_steer * z7 - e2z * s_steer;
    const bicycle_lanes z9 = z3 * s_lam - e3z * c_lam;
    const bicycle_lanes z10 = c_lam * z8 + s_lam * z9;
    const bicycle_lanes z11 = r_F * z10;
    const bicycle_lanes z12 = c_lam * z9 - s_lam * z8;
    const bicycle_lanes z13 = z10 * z10 + z12 * z12;
    const bicycle_lanes z14 = 1.0 / bicycle_each_sqrt(BICYCLE_SPREAD(z13));
    const bicycle_lanes z15 = z11 * z14;
    const bicycle_lanes z16 = z15 - k15;
    const bicycle_lanes z17 = s_steer * z16;
    const bicycle_lanes z18 = z1 * z6 + c_lam * z17;
    const bicycle_lanes z19 = r_R * z3;
    const bicycle_lanes z20 = z19 * z5;
    const bicycle_lanes z21 = z20 + k10;
    const bicycle_lanes z22 = z1 * z21 - s_lam * z17;
    const bicycle_lanes z23 = s_pitch * z18 - c_pitch * z22;
    const bicycle_lanes z24 = s_lam * c_steer;
    const bicycle_lanes z25 = k11 + s_lam * z24;
    const bicycle_lanes z26 = c_lam * (s_lam - z24);
    const bicycle_lanes z27 = z20 * z25 + R3 * z26;
    const bicycle_lanes z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16;
    const bicycle_lanes z29 = c_roll * z23 - e2z * z28;
    const bicycle_lanes z30 = c_lam * c_steer;
    const bicycle_lanes z31 = s_lam * (c_lam - z30);
    const bicycle_lanes z32 = c_lam * z30 + k14;
    const bicycle_lanes z33 = z20 * z31 + R3 * z32;
    const bicycle_lanes z34 = c_lam * s_steer;
    const bicycle_lanes z35 = R3 * z34 - z20 * z1;
    const bicycle_lanes z36 = r_F * z12;
    const bicycle_lanes z37 = z36 * z14;
    const bicycle_lanes z38 = k12 - c_lam * z37 - s_lam * z15;
    const bicycle_lanes z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38;
    const bicycle_lanes z40 = z37 + k13;
    const bicycle_lanes z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40;
    const bicycle_lanes z42 = z33 * z39 - z41 * z35;
    const bicycle_lanes z43 = c_steer * z38;
    const bicycle_lanes z44 = s_lam * z37;
    const bicycle_lanes z45 = c_lam * z15;
    const bicycle_lanes z46 = k3 + z44 - z45;
    const bicycle_lanes z47 = c_steer * z6 - c_lam * z43 + s_lam * z46;
    const bicycle_lanes z48 = c_steer * z21 + s_lam * z43 + c_lam * z46;
    const bicycle_lanes z49 = s_pitch * z47 - c_pitch * z48;
    const bicycle_lanes z50 = c_roll * z49 - e2z * z39;
    const bicycle_lanes z51 = s_steer * z40;
    const bicycle_lanes z52 = z34 * z6 + c_lam * z51;
    const bicycle_lanes z53 = z34 * z21 - s_lam * z51;
    const bicycle_lanes z54 = s_pitch * z52 - c_pitch * z53;
    const bicycle_lanes z55 = c_roll * z54 + e2z * z41;
    const bicycle_lanes z56 = z33 * z50 + z55 * z35;
    const bicycle_lanes z57 = z41 * z50 + z55 * z39;
    const bicycle_lanes z58 = z29 * z42 - z28 * z56 + z27 * z57;
    /* the coframe is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z58)), BICYCLE_SPREAD(1e-12 * (k20 * (k20 * (13.0 * k19
        + (14.0 * k18 + (24.0 * k16 + 33.0 * k17)))))));
    const bicycle_lanes z59 = 1.0 / z58;
    const bicycle_lanes z60 = s_pitch * s_lam - c_pitch * c_lam;
    const bicycle_lanes z61 = s_steer * z60;
    const bicycle_lanes z62 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20);
    const bicycle_lanes z63 = k12 * z61 + s_steer * z62;
    const bicycle_lanes z64 = k3 * z61;
    const bicycle_lanes z65 = z15 * z61 - (s_lam * z63 + c_lam * z64);
    const bicycle_lanes z66 = c_pitch * s_lam + s_pitch * c_lam;
    const bicycle_lanes z67 = c_steer * z60;
    const bicycle_lanes z68 = z37 * (s_lam * z66 - c_lam * z67) - z15 * (s_lam * z67 + c_lam * z66) + (k12 *
        z67 + k3 * z66 + c_steer * z62);
    const bicycle_lanes z69 = z37 * z61 + (s_lam * z64 - c_lam * z63);
    const bicycle_lanes z70 = z33 * z68 - z35 * z69;
    const bicycle_lanes z71 = z41 * z68 - z39 * z69;
    const bicycle_lanes z72 = z59 * (z42 * z65 + z28 * z70 - z27 * z71);
    const bicycle_lanes z73 = c_roll * z72;
    const bicycle_lanes z74 = s_pitch - c_pitch * z73;
    const bicycle_lanes z75 = c_pitch + s_pitch * z73;
    const bicycle_lanes z76 = c_lam * z74 + s_lam * z75;
    const bicycle_lanes z77 = R3 * z75 + z20 * z74;
    const bicycle_lanes z78 = z77 + (k10 * z74 + k9 * z75);
    const bicycle_lanes z79 = z50 * z69 + z55 * z68;
    const bicycle_lanes z80 = z59 * (z29 * z70 + z56 * z65 + z27 * z79) + e2z * z72;
    const bicycle_lanes z81 = z59 * (z29 * z71 + z28 * z79 + z57 * z65) - z80;
    const bicycle_lanes z82 = R3 * z81;
    const bicycle_lanes z83 = z82 - k9 * z80;
    const bicycle_lanes z84 = z20 * z81;
    const bicycle_lanes z85 = z84 - k10 * z80;
    const bicycle_lanes z86 = c_lam * z83 - s_lam * z85;
    const bicycle_lanes z87 = c_steer * z78 + s_steer * z86;
    const bicycle_lanes z88 = c_lam * z75 - s_lam * z74;
    const bicycle_lanes z89 = s_steer * z80 - c_steer * z88;
    const bicycle_lanes z90 = k51 * z76 + (k36 * z87 - k50 * z89);
    const bicycle_lanes z91 = c_steer * z80 + s_steer * z88;
    const bicycle_lanes z92 = c_steer * z86 - s_steer * z78;
    const bicycle_lanes z93 = c_lam * z85 + s_lam * z83;
    const bicycle_lanes z94 = k47 * z91 + (k33 * z92 - k36 * z93);
    const bicycle_lanes z95 = k44 * z76 - (k33 * z87 + k43 * z89);
    const bicycle_lanes z96 = k31 * z93 - k36 * z91;
    const bicycle_lanes z97 = k36 * z76 + (k31 * z87 + k33 * z89);
    const bicycle_lanes z98 = k31 * z92 + k33 * z91;
    const bicycle_lanes z99 = z74 * k29 + (z77 * k23 + z75 * k28);
    const bicycle_lanes z100 = z80 * k27 + (z82 * k22 - z84 * k23);
    const bicycle_lanes z101 = z74 * k28 - (z77 * k22 - z75 * k25);
    const bicycle_lanes z102 = z84 * k21 - z80 * k23;
    const bicycle_lanes z103 = z82 * k21 + z80 * k22;
    const bicycle_lanes z104 = z74 * k23 + (z77 * k21 - z75 * k22);
    const bicycle_lanes z105 = z74 * z99 + (z80 * z100 + (z75 * z101 + (z84 * z102 + (z82 * z103 + z77 *
        z104))));
    const bicycle_lanes z106 = z76 * z90 + (z91 * z94 - (z89 * z95 - (z93 * z96 + (z87 * z97 + (z92 * z98 +
        z105)))));
    const bicycle_lanes z107 = z106 + R_yy * (z81 * z81) + F_yy * (z91 * z91);
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z107)), BICYCLE_SPREAD(0.0));
    const bicycle_lanes z108 = k3 + (z44 - z45);
    const bicycle_lanes z109 = z33 * z108;
    const bicycle_lanes z110 = z41 * z108;
    const bicycle_lanes z111 = z59 * (z28 * z109 - z27 * z110);
    const bicycle_lanes z112 = c_roll * z111;
    const bicycle_lanes z113 = c_pitch * z112;
    const bicycle_lanes z114 = s_pitch * z112;
    const bicycle_lanes z115 = 1.0 - (c_lam * z113 - s_lam * z114);
    const bicycle_lanes z116 = R3 * z114 - z20 * z113;
    const bicycle_lanes z117 = z116 - (k10 * z113 - k9 * z114);
    const bicycle_lanes z118 = z55 * z108;
    const bicycle_lanes z119 = z59 * (z29 * z109 + z27 * z118) + e2z * z111;
    const bicycle_lanes z120 = z59 * (z29 * z110 + z28 * z118) - z119;
    const bicycle_lanes z121 = R3 * z120;
    const bicycle_lanes z122 = z121 - k9 * z119;
    const bicycle_lanes z123 = z20 * z120;
    const bicycle_lanes z124 = z123 - k10 * z119;
    const bicycle_lanes z125 = c_lam * z122 - s_lam * z124;
    const bicycle_lanes z126 = c_steer * z117 + s_steer * z125;
    const bicycle_lanes z127 = c_lam * z114 + s_lam * z113;
    const bicycle_lanes z128 = s_steer * z119 - c_steer * z127;
    const bicycle_lanes z129 = k51 * z115 + (k36 * z126 - k50 * z128);
    const bicycle_lanes z130 = c_steer * z119 + s_steer * z127;
    const bicycle_lanes z131 = c_steer * z125 - s_steer * z117;
    const bicycle_lanes z132 = c_lam * z124 + s_lam * z122;
    const bicycle_lanes z133 = k47 * z130 + (k33 * z131 - k36 * z132);
    const bicycle_lanes z134 = k44 * z115 - (k33 * z126 + k43 * z128);
    const bicycle_lanes z135 = k31 * z132 - k36 * z130;
    const bicycle_lanes z136 = k36 * z115 + (k31 * z126 + k33 * z128);
    const bicycle_lanes z137 = k31 * z131 + k33 * z130;
    const bicycle_lanes z138 = z113 * k29 - (z116 * k23 + z114 * k28);
    const bicycle_lanes z139 = z119 * k27 + (z121 * k22 - z123 * k23);
    const bicycle_lanes z140 = z113 * k28 + (z116 * k22 - z114 * k25);
    const bicycle_lanes z141 = z123 * k21 - z119 * k23;
    const bicycle_lanes z142 = z121 * k21 + z119 * k22;
    const bicycle_lanes z143 = z113 * k23 - (z116 * k21 - z114 * k22);
    const bicycle_lanes z144 = z113 * z138 + (z119 * z139 - (z114 * z140 - (z123 * z141 + (z121 * z142 - z116
        * z143))));
    const bicycle_lanes z145 = z115 * z129 + (z130 * z133 - (z128 * z134 - (z132 * z135 + (z126 * z136 +
        (z131 * z137 + z144)))));
    const bicycle_lanes z146 = z145 + R_yy * (z120 * z120) + F_yy * (z130 * z130);
    const bicycle_lanes z147 = z113 * z99 - (z119 * z100 + (z114 * z101 + (z123 * z102 + (z121 * z103 + z116
        * z104))));
    const bicycle_lanes z148 = z115 * z90 + (z130 * z94 - (z128 * z95 - (z132 * z96 + (z126 * z97 + (z131 *
        z98 - z147)))));
    const bicycle_lanes z149 = R_yy * z81;
    const bicycle_lanes z150 = F_yy * z91;
    const bicycle_lanes z151 = z148 + z120 * z149 + z130 * z150;
    const bicycle_lanes z152 = 1.0 / z107;
    const bicycle_lanes z153 = z152 * z151;
    const bicycle_lanes z154 = z146 - z151 * z153;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z154)), 1e-14 * z146);
    const bicycle_lanes z155 = z37 * z35;
    const bicycle_lanes z156 = z37 * z39;
    const bicycle_lanes z157 = z59 * (z15 * z42 - z28 * z155 + z27 * z156);
    const bicycle_lanes z158 = c_roll * z157;
    const bicycle_lanes z159 = c_pitch * z158;
    const bicycle_lanes z160 = s_pitch * z158;
    const bicycle_lanes z161 = c_lam * z159 - s_lam * z160;
    const bicycle_lanes z162 = R3 * z160 - z20 * z159;
    const bicycle_lanes z163 = z162 - (k10 * z159 - k9 * z160);
    const bicycle_lanes z164 = z37 * z50;
    const bicycle_lanes z165 = z59 * (z29 * z155 - z15 * z56 - z27 * z164) - e2z * z157;
    const bicycle_lanes z166 = z59 * (z29 * z156 - z28 * z164 - z15 * z57) - z165;
    const bicycle_lanes z167 = R3 * z166;
    const bicycle_lanes z168 = z167 - k9 * z165;
    const bicycle_lanes z169 = z20 * z166;
    const bicycle_lanes z170 = z169 - k10 * z165;
    const bicycle_lanes z171 = c_lam * z168 - s_lam * z170;
    const bicycle_lanes z172 = c_steer * z163 - s_steer * z171;
    const bicycle_lanes z173 = c_lam * z160 + s_lam * z159;
    const bicycle_lanes z174 = s_steer * z165 + c_steer * z173;
    const bicycle_lanes z175 = c_steer * z165 - s_steer * z173;
    const bicycle_lanes z176 = c_steer * z171 + s_steer * z163;
    const bicycle_lanes z177 = c_lam * z170 + s_lam * z168;
    const bicycle_lanes z178 = z167 * (z167 * k21 + z165 * k22) - z162 * (z159 * k23 - (z162 * k21 - z160 *
        k22));
    const bicycle_lanes z179 = z160 * (z159 * k28 + (z162 * k22 - z160 * k25)) - (z169 * (z169 * k21 - z165 *
        k23) + z178);
    const bicycle_lanes z180 = z159 * (z159 * k29 - (z162 * k23 + z160 * k28)) + (z165 * (z165 * k27 + (z167
        * k22 - z169 * k23)) - z179);
    const bicycle_lanes z181 = z172 * (k36 * z161 - (k31 * z172 - k33 * z174)) - (z176 * (k31 * z176 + k33 *
        z175) + z180);
    const bicycle_lanes z182 = z174 * (k44 * z161 + (k33 * z172 - k43 * z174)) - (z177 * (k31 * z177 - k36 *
        z175) - z181);
    const bicycle_lanes z183 = z161 * (k51 * z161 - (k36 * z172 + k50 * z174)) + (z175 * (k47 * z175 + (k33 *
        z176 - k36 * z177)) - z182);
    const bicycle_lanes z184 = 1.0 + z175;
    const bicycle_lanes z185 = z183 + R_yy * (z166 * z166) + F_yy * (z184 * z184);
    const bicycle_lanes z186 = z159 * z99 + (z165 * z100 - (z160 * z101 - (z169 * z102 + (z167 * z103 - z162
        * z104))));
    const bicycle_lanes z187 = z161 * z90 + (z175 * z94 - (z174 * z95 - (z177 * z96 - (z172 * z97 - (z176 *
        z98 + z186)))));
    const bicycle_lanes z188 = z187 + z166 * z149 + z184 * z150;
    const bicycle_lanes z189 = z152 * z188;
    const bicycle_lanes z190 = z159 * z138 - (z165 * z139 + (z160 * z140 + (z169 * z141 + (z167 * z142 + z162
        * z143))));
    const bicycle_lanes z191 = z161 * z129 + (z175 * z133 - (z174 * z134 - (z177 * z135 - (z172 * z136 -
        (z176 * z137 - z190)))));
    const bicycle_lanes z192 = R_yy * z120;
    const bicycle_lanes z193 = F_yy * z130;
    const bicycle_lanes z194 = z191 + z166 * z192 + z184 * z193 - z151 * z189;
    const bicycle_lanes z195 = 1.0 / z154;
    const bicycle_lanes z196 = z194 * z195;
    const bicycle_lanes z197 = z185 - z188 * z189 - z194 * z196;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z197)), 1e-14 * z185);
    bicycle_lanes sine4, cosine4;
    bicycle_turn_lanes(BICYCLE_SPREAD(yaw), &far, &sine4, &cosine4);
    const bicycle_lanes c_yaw = cosine4;
    const bicycle_lanes z198 = roll_dot * c_pitch;
    const bicycle_lanes z199 = roll_dot * s_pitch;
    const bicycle_lanes z200 = steer_dot + (s_lam * z198 + c_lam * z199);
    const bicycle_lanes z201 = s_lam * z199 - c_lam * z198;
    const bicycle_lanes z202 = c_steer * z201;
    const bicycle_lanes z203 = s_lam * z200 - c_lam * z202;
    const bicycle_lanes z204 = s_lam * z202 + c_lam * z200;
    const bicycle_lanes z205 = z198 * k9 + z199 * k10 + (z198 * R3 + z199 * z20);
    const bicycle_lanes z206 = z37 * z203 - z15 * z204 + (k12 * z202 + k3 * z200 + c_steer * z205);
    const bicycle_lanes z207 = s_steer * z201;
    const bicycle_lanes z208 = thF_dot + z207;
    const bicycle_lanes z209 = k3 * z207;
    const bicycle_lanes z210 = k12 * z207 + s_steer * z205;
    const bicycle_lanes z211 = z37 * z208 + (s_lam * z209 - c_lam * z210);
    const bicycle_lanes z212 = z41 * z206 - z39 * z211;
    const bicycle_lanes z213 = z50 * z211 + z55 * z206;
    const bicycle_lanes z214 = z15 * z208 - (s_lam * z210 + c_lam * z209);
    const bicycle_lanes z215 = z59 * (z29 * z212 + z28 * z213 + z57 * z214);
    const bicycle_lanes z216 = z33 * z206 - z35 * z211;
    const bicycle_lanes z217 = z59 * (z29 * z216 + z56 * z214 + z27 * z213);
    const bicycle_lanes z218 = z59 * (z42 * z214 + z28 * z216 - z27 * z212);
    const bicycle_lanes z219 = z217 + e2z * z218;
    const bicycle_lanes z220 = z215 - z219;
    const bicycle_lanes a3 = z20 * z220;
    const bicycle_lanes a1 = R3 * z220;
    const bicycle_lanes z221 = s_pitch * a3 + c_pitch * a1;
    const bicycle_lanes s_yaw = sine4;
    const bicycle_lanes z222 = s_pitch * a1 - c_pitch * a3;
    const bicycle_lanes z223 = c_roll * z218;
    const bicycle_lanes w1_pitch = z198 + s_pitch * z223;
    const bicycle_lanes w3_pitch = z199 - c_pitch * z223;
    const bicycle_lanes v2_x = R3 * w1_pitch + z20 * w3_pitch;
    const bicycle_lanes z224 = e2z * z222 - c_roll * v2_x;
    const bicycle_lanes z225 = R_yy * z220;
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z7;
    const bicycle_lanes z226 = c_lam * w1_pitch - s_lam * w3_pitch;
    const bicycle_lanes z227 = s_steer * z219 - c_steer * z226;
    const bicycle_lanes z228 = c_steer * z219 + s_steer * z226;
    const bicycle_lanes z229 = F_yy * (thF_dot - z228) - k47 * z228;
    const bicycle_lanes w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    const bicycle_lanes z230 = k43 * z227 - k44 * w3_steer;
    const bicycle_lanes z231 = c_pitch * z217;
    const bicycle_lanes z232 = roll_dot * z231;
    const bicycle_lanes z233 = s_pitch * z217;
    const bicycle_lanes z234 = roll_dot * e2z;
    const bicycle_lanes z235 = steer_dot * c_steer;
    const bicycle_lanes z236 = roll_dot * z233;
    const bicycle_lanes z237 = s_lam * z232 + c_lam * z236;
    const bicycle_lanes z238 = z235 * z201 - s_steer * z237;
    const bicycle_lanes z239 = roll_dot * c_roll;
    const bicycle_lanes z240 = steer_dot * s_steer;
    const bicycle_lanes z241 = s_pitch * z234 + c_roll * z231;
    const bicycle_lanes z242 = c_pitch * z234 - c_roll * z233;
    const bicycle_lanes z243 = s_steer * z239 + e2z * z235 + (z7 * z240 + c_steer * (c_lam * z241 + s_lam *
        z242));
    const bicycle_lanes z244 = s_lam * z241 - c_lam * z242;
    const bicycle_lanes z245 = c_lam * z243 + s_lam * z244;
    const bicycle_lanes z246 = r_F * z14;
    const bicycle_lanes z247 = c_lam * z244 - s_lam * z243;
    const bicycle_lanes z248 = (z10 * z245 + z12 * z247) * (z14 / z13);
    const bicycle_lanes z249 = z245 * z246 - z11 * z248;
    const bicycle_lanes z250 = k3 * z238;
    const bicycle_lanes z251 = r_R * z5;
    const bicycle_lanes z252 = (z3 * z241 + e3z * z242) * (z5 / z4);
    const bicycle_lanes z253 = z251 * z242 - z2 * z252;
    const bicycle_lanes z254 = z251 * z241 - z19 * z252;
    const bicycle_lanes z255 = k9 * z236 - k10 * z232 + (R3 * z236 - z198 * z253 - (z20 * z232 + z199 *
        z254));
    const bicycle_lanes z256 = k12 * z238 + (z235 * z205 + s_steer * z255);
    const bicycle_lanes z257 = s_lam * z240;
    const bicycle_lanes z258 = s_lam * z257;
    const bicycle_lanes z259 = c_lam * z257;
    const bicycle_lanes z260 = z20 * z258 + z25 * z254 - (R3 * z259 - z26 * z253);
    const bicycle_lanes z261 = s_lam * z235;
    const bicycle_lanes z262 = z235 * z16 - s_steer * z249;
    const bicycle_lanes z263 = z1 * z254;
    const bicycle_lanes z264 = z18 * z231 - s_pitch * (z6 * z261 - z1 * z253 + c_lam * z262) + (z22 * z233 +
        c_pitch * (z21 * z261 - z263 - s_lam * z262));
    const bicycle_lanes z265 = k10 * z258 - k9 * z259 + z260 - (z240 * z16 + c_steer * z249);
    const bicycle_lanes z266 = z215 * z260 + (z218 * (z234 * z23 + c_roll * z264 + (z239 * z28 - e2z * z265))
        - z217 * z265);
    const bicycle_lanes z267 = z15 * z238 - z208 * z249 - (c_lam * z250 + s_lam * z256) + z266;
    const bicycle_lanes z268 = s_lam * z236 - c_lam * z232;
    const bicycle_lanes z269 = z240 * z201 + c_steer * z237;
    const bicycle_lanes z270 = z247 * z246 - z36 * z248;
    const bicycle_lanes z271 = z37 * (s_lam * z268 + c_lam * z269) - z203 * z270 + (z15 * (s_lam * z269 -
        c_lam * z268) + z204 * z249);
    const bicycle_lanes z272 = c_lam * z235;
    const bicycle_lanes z273 = z34 * z253;
    const bicycle_lanes z274 = R3 * z272 - z273 - (z20 * z261 - z263);
    const bicycle_lanes z275 = c_lam * z270 + s_lam * z249;
    const bicycle_lanes z276 = z240 * z38 - c_steer * z275;
    const bicycle_lanes z277 = s_lam * z270 - c_lam * z249;
    const bicycle_lanes z278 = z47 * z231 + s_pitch * (z240 * z6 + c_steer * z253 - c_lam * z276 + s_lam *
        z277) + (z48 * z233 - c_pitch * (z240 * z21 + c_steer * z254 + s_lam * z276 + c_lam * z277));
    const bicycle_lanes z279 = k9 * z272 - k10 * z261 + z274 - (z235 * z38 + s_steer * z275);
    const bicycle_lanes z280 = z215 * z274 - (z218 * (z234 * z49 + c_roll * z278 + (z239 * z39 + e2z * z279))
        + z217 * z279);
    const bicycle_lanes z281 = z271 - (k12 * z269 - k3 * z268 + (z240 * z205 - c_steer * z255)) + z280;
    const bicycle_lanes z282 = c_lam * z240;
    const bicycle_lanes z283 = s_lam * z282;
    const bicycle_lanes z284 = c_lam * z282;
    const bicycle_lanes z285 = z20 * z283 - z31 * z254 - (R3 * z284 + z32 * z253);
    const bicycle_lanes z286 = z235 * z40 - s_steer * z270;
    const bicycle_lanes z287 = z52 * z231 - s_pitch * (z6 * z272 - z273 + c_lam * z286) + (z53 * z233 +
        c_pitch * (z21 * z272 - z34 * z254 - s_lam * z286));
    const bicycle_lanes z288 = k10 * z283 - k9 * z284 + z285 - (z240 * z40 + c_steer * z270);
    const bicycle_lanes z289 = z215 * z285 + (z218 * (z234 * z54 + c_roll * z287 - (z239 * z41 + e2z * z288))
        - z217 * z288);
    const bicycle_lanes z290 = z37 * z238 - z208 * z270 + (s_lam * z250 - c_lam * z256) + z289;
    const bicycle_lanes z291 = z33 * z281 - z35 * z290;
    const bicycle_lanes z292 = z41 * z281 - z39 * z290;
    const bicycle_lanes z293 = z59 * (z42 * z267 + z28 * z291 - z27 * z292);
    const bicycle_lanes z294 = z234 * z218 - c_roll * z293;
    const bicycle_lanes z295 = z232 + (z223 * z233 - c_pitch * z294);
    const bicycle_lanes z296 = z236 - (z223 * z231 + s_pitch * z294);
    const bicycle_lanes z297 = c_lam * z295 - s_lam * z296;
    const bicycle_lanes z298 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z253 - R3 * z296 + (w3_pitch *
        z254 + z20 * z295));
    const bicycle_lanes z299 = k9 * z219;
    const bicycle_lanes z300 = k10 * z219;
    const bicycle_lanes z301 = z298 - (w3_pitch * z299 - w1_pitch * z300 - (k10 * z295 - k9 * z296));
    const bicycle_lanes z302 = z50 * z290 + z55 * z281;
    const bicycle_lanes z303 = z59 * (z29 * z291 + z56 * z267 + z27 * z302) + (z239 * z218 + e2z * z293);
    const bicycle_lanes z304 = z59 * (z29 * z292 + z28 * z302 + z57 * z267) - z303;
    const bicycle_lanes z305 = z219 * a3 - w3_pitch * v2_x + (z220 * z253 - R3 * z304);
    const bicycle_lanes z306 = k10 * w3_pitch + k9 * w1_pitch;
    const bicycle_lanes z307 = z305 - (z219 * z300 + w3_pitch * z306 - k9 * z303);
    const bicycle_lanes z308 = w1_pitch * v2_x - z219 * a1 + (z220 * z254 - z20 * z304);
    const bicycle_lanes z309 = z308 + (w1_pitch * z306 + z219 * z299 + k10 * z303);
    const bicycle_lanes z310 = c_lam * z307 - s_lam * z309;
    const bicycle_lanes z311 = c_steer * z301 + s_steer * z310;
    const bicycle_lanes z312 = c_lam * z296 + s_lam * z295;
    const bicycle_lanes z313 = z235 * z219 + s_steer * z303 + (z240 * z226 - c_steer * z312);
    const bicycle_lanes z314 = h2z * k64 - (z227 * z229 + z228 * z230 + (k51 * z297 + (k36 * z311 + k50 *
        z313)));
    const bicycle_lanes z315 = k50 * z227 - k51 * w3_steer;
    const bicycle_lanes z316 = z240 * z219 - c_steer * z303 - (z235 * z226 + s_steer * z312);
    const bicycle_lanes z317 = c_steer * z310 - s_steer * z301;
    const bicycle_lanes z318 = c_lam * z309 + s_lam * z307;
    const bicycle_lanes z319 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) - (w3_steer * z230 + z227 * z315 -
        (k47 * z316 + (k33 * z317 - k36 * z318)));
    const bicycle_lanes z320 = h2z * k63 + (z228 * z315 - w3_steer * z229 - (k44 * z297 - (k33 * z311 - k43 *
        z313)));
    const bicycle_lanes z321 = k33 * z227 + k36 * w3_steer;
    const bicycle_lanes z322 = k33 * z228;
    const bicycle_lanes z323 = z9 * k60 - (z227 * z321 + z228 * z322 - (k31 * z318 - k36 * z316));
    const bicycle_lanes z324 = k36 * z228;
    const bicycle_lanes z325 = h2z * k60 + (w3_steer * z322 - z227 * z324 + (k36 * z297 + (k31 * z311 - k33 *
        z313)));
    const bicycle_lanes z326 = z8 * k60 - (z228 * z324 + w3_steer * z321 - (k31 * z317 + k33 * z316));
    const bicycle_lanes z327 = k27 * z219;
    const bicycle_lanes z328 = k25 * w1_pitch + k28 * w3_pitch;
    const bicycle_lanes z329 = e2z * k56 + (w1_pitch * z327 - z219 * z328 + (k29 * z295 + (k23 * z298 - k28 *
        z296)));
    const bicycle_lanes z330 = k28 * w1_pitch + k29 * w3_pitch;
    const bicycle_lanes z331 = z3 * k57 + e3z * k56 + (w3_pitch * z328 - w1_pitch * z330 - (k27 * z303 - (k22
        * z305 - k23 * z308)));
    const bicycle_lanes z332 = e2z * k57 - (z219 * z330 - w3_pitch * z327 + (k28 * z295 - (k22 * z298 + k25 *
        z296)));
    const bicycle_lanes z333 = k22 * w1_pitch - k23 * w3_pitch;
    const bicycle_lanes z334 = k22 * z219;
    const bicycle_lanes z335 = e3z * k55 + (w1_pitch * z333 + z219 * z334 - (k21 * z308 + k23 * z303));
    const bicycle_lanes z336 = k23 * z219;
    const bicycle_lanes z337 = z3 * k55 - (z219 * z336 - w3_pitch * z333 - (k21 * z305 - k22 * z303));
    const bicycle_lanes z338 = e2z * k55 + (w3_pitch * z334 + w1_pitch * z336 + (k23 * z295 + (k21 * z298 +
        k22 * z296)));
    const bicycle_lanes z339 = z74 * z329 + (z80 * z331 - (z75 * z332 + (z84 * z335 - (z82 * z337 + z77 *
        z338))));
    const bicycle_lanes z340 = z76 * z314 - (z91 * z319 + (z89 * z320 + (z93 * z323 + (z87 * z325 + (z92 *
        z326 + z339)))));
    const bicycle_lanes z341 = roll_dot * z225;
    const bicycle_lanes z342 = z223 * z225 + z340 + z149 * z304 - z150 * z316 - z73 * z341;
    const bicycle_lanes z343 = z113 * z329 - (z119 * z331 - (z114 * z332 + (z123 * z335 - (z121 * z337 + z116
        * z338))));
    const bicycle_lanes z344 = z115 * z314 - (z130 * z319 + (z128 * z320 + (z132 * z323 + (z126 * z325 +
        (z131 * z326 - z343)))));
    const bicycle_lanes z345 = z344 + z192 * z304 - z193 * z316 - z112 * z341 - z342 * z153;
    const bicycle_lanes z346 = z159 * z329 + (z165 * z331 + (z160 * z332 - (z169 * z335 - (z167 * z337 - z162
        * z338))));
    const bicycle_lanes z347 = z161 * z314 - (z175 * z319 + (z174 * z320 + (z177 * z323 - (z172 * z325 -
        (z176 * z326 + z346)))));
    const bicycle_lanes z348 = z347 + R_yy * (z166 * z304) - F_yy * (z184 * z316) + z158 * z341 - z342 * z189
        - z196 * z345;
    const bicycle_lanes z349 = z348 / z197;
    const bicycle_lanes z350 = z195 * z345 - z196 * z349;
    /* (I.2.15) */
    const bicycle_lanes slope1 = s_yaw * z224 - c_yaw * z221;
    sum += slope1;
    bicycle_put(dydt, slope1);
    const bicycle_lanes slope2 = -(s_yaw * z221 + c_yaw * z224);
    sum += slope2;
    bicycle_put(dydt + 1 * stride, slope2);
    const bicycle_lanes slope3 = c_roll * z222 + e2z * v2_x;
    sum += slope3;
    bicycle_put(dydt + 2 * stride, slope3);
    const bicycle_lanes slope4 = -z218;
    sum += slope4;
    bicycle_put(dydt + 3 * stride, slope4);
    const bicycle_lanes slope5 = roll_dot;
    sum += slope5;
    bicycle_put(dydt + 4 * stride, slope5);
    const bicycle_lanes slope6 = -z217;
    sum += slope6;
    bicycle_put(dydt + 5 * stride, slope6);
    const bicycle_lanes slope7 = steer_dot;
    sum += slope7;
    bicycle_put(dydt + 6 * stride, slope7);
    const bicycle_lanes slope8 = z215;
    sum += slope8;
    bicycle_put(dydt + 7 * stride, slope8);
    const bicycle_lanes slope9 = thF_dot;
    sum += slope9;
    bicycle_put(dydt + 8 * stride, slope9);
    /* (I.2.15) 112:4 */
    const bicycle_lanes slope10 = z189 * z349 - (z152 * z342 - z153 * z350);
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = -z350;
    sum += slope11;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = z349;
    sum += slope12;
    bicycle_put(dydt + 11 * stride, slope12);
    bicycle_put(check, bicycle_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void bicycle_rhs_tail(const double *fixed, size_t left, size_t count, const
    double *t, const double *y, double *restrict dydt, double *check)
{
    double time[BICYCLE_LANES];
    double state[12 * BICYCLE_LANES];
    double slope[12 * BICYCLE_LANES];
    bicycle_fill(left, count, t, y, time, state);
    bicycle_rhs_lanes(fixed, BICYCLE_LANES, time, state, slope, check);
    bicycle_pour(left, count, slope, dydt);
}
#endif

int bicycle_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *restrict dydt)
{
#if BICYCLE_LANES >= 4
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
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = H_zz + F_xx;
    const double k5 = H_xx + F_xx;
    const double k6 = z_H * s_lam - c_lam * (x_H - k2);
    const double k7 = x_H * s_lam + c_lam * (r_R + z_H);
    const double k8 = c_lam * k2 - r_R * s_lam;
    const double k9 = s_lam * k8;
    const double k10 = c_lam * k8;
    const double k11 = c_lam * c_lam;
    const double k12 = w * s_lam + c_lam * (r_R - r_F);
    const double k13 = s_lam * k3 - c_lam * k12;
    const double k14 = s_lam * s_lam;
    const double k15 = c_lam * k3 + s_lam * k12;
    const double k16 = fabs(r_R);
    const double k17 = fabs(r_F);
    const double k18 = fabs(w);
    const double k19 = fabs(c);
    const double k20 = 18.0 * k19 + (18.0 * k18 + (34.0 * k16 + 19.0 * k17));
    const double k21 = m_R + m_B;
    const double k22 = m_B * k1;
    const double k23 = x_B * m_B;
    const double k24 = k1 * k22;
    const double k25 = R_xx + B_xx + k24;
    const double k26 = x_B * k23;
    const double k27 = k24 + (B_yy + k26);
    const double k28 = B_xz - k1 * k23;
    const double k29 = R_xx + B_zz + k26;
    const double k30 = m_F * k12;
    const double k31 = m_H + m_F;
    const double k32 = m_H * k7;
    const double k33 = k30 + k32;
    const double k34 = m_F * k3;
    const double k35 = m_H * k6;
    const double k36 = k34 - k35;
    const double k37 = H_xz * c_lam;
    const double k38 = s_lam * k4 - k37;
    const double k39 = H_xz * s_lam;
    const double k40 = c_lam * k5 - k39;
    const double k41 = k12 * k30;
    const double k42 = k7 * k32;
    const double k43 = c_lam * k40 + s_lam * k38 + k41 + k42;
    const double k44 = s_lam * k40 - c_lam * k38 - k3 * k30 + k6 * k32;
    const double k45 = k3 * k34;
    const double k46 = k6 * k35;
    const double k47 = k42 + (k41 + (H_yy + k45) + k46);
    const double k48 = k39 + c_lam * k4;
    const double k49 = k37 + s_lam * k5;
    const double k50 = c_lam * k49 - s_lam * k48 - k12 * k34 + k7 * k35;
    const double k51 = k46 + (k45 + (s_lam * k49 + c_lam * k48));
    const double k52 = g * m_F;
    const double k53 = g * m_H;
    const double k54 = g * m_B;
    const double k55 = g * k21;
    const double k56 = x_B * k54;
    const double k57 = k1 * k54;
    const double k58 = k6 * k53;
    const double k59 = k7 * k53;
    const double k60 = g * k31;
    const double k61 = k3 * k52;
    const double k62 = k12 * k52;
    const double k63 = k59 + k62;
    const double k64 = k58 - k61;
    const double fixed[] = {r_R, R_yy, r_F, F_yy, s_lam, c_lam, k3, k9, k10, k11, k12, k13, k14, k15, k16,
        k17, k18, k19, k20, k21, k22, k23, k25, k27, k28, k29, k31, k33, k36, k43, k44, k47, k50, k51, k55,
        k56, k57, k58, k59, k60, k61, k62, k63, k64};
    double check[1 * BICYCLE_LANES];
    int status = BICYCLE_OK;
    for (size_t i = 0; i < count; i += BICYCLE_LANES) {
        const size_t left = count - i < BICYCLE_LANES ? count - i : BICYCLE_LANES;
        if (left == BICYCLE_LANES) {
            bicycle_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            bicycle_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!bicycle_is_good(1 * BICYCLE_LANES, check)) {
            const int one = bicycle_one_by_one(count, i, left, t, y, p, dydt);
            status = status == BICYCLE_OK ? one : status;
        }
    }
    return status;
#else
    return bicycle_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
