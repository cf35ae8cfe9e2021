/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:27fecc40f6220233)
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
    const double k13 = s_lam * s_lam;
    const double k14 = s_lam * k3 - c_lam * k12;
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
    const double z32 = c_lam * z30 + k13;
    const double z33 = z20 * z31 + R3 * z32;
    const double z34 = c_lam * s_steer;
    const double z35 = R3 * z34 - z20 * z1;
    const double z36 = r_F * z12;
    const double z37 = z36 * z14;
    const double z38 = k12 - c_lam * z37 - s_lam * z15;
    const double z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38;
    const double z40 = z37 + k14;
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
    const double h2z = e2z * c_steer + s_steer * z7;
    const double z225 = c_lam * w1_pitch - s_lam * w3_pitch;
    const double z226 = s_steer * z219 - c_steer * z225;
    const double z227 = c_steer * z219 + s_steer * z225;
    const double z228 = F_yy * (thF_dot - z227) - k47 * z227;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    const double z229 = k43 * z226 - k44 * w3_steer;
    const double z230 = c_pitch * z217;
    const double z231 = roll_dot * z230;
    const double z232 = s_pitch * z217;
    const double z233 = roll_dot * e2z;
    const double z234 = steer_dot * c_steer;
    const double z235 = roll_dot * z232;
    const double z236 = s_lam * z231 + c_lam * z235;
    const double z237 = z234 * z201 - s_steer * z236;
    const double z238 = roll_dot * c_roll;
    const double z239 = steer_dot * s_steer;
    const double z240 = s_pitch * z233 + c_roll * z230;
    const double z241 = c_pitch * z233 - c_roll * z232;
    const double z242 = s_steer * z238 + e2z * z234 + (z7 * z239 + c_steer * (c_lam * z240 + s_lam * z241));
    const double z243 = s_lam * z240 - c_lam * z241;
    const double z244 = c_lam * z242 + s_lam * z243;
    const double z245 = r_F * z14;
    const double z246 = c_lam * z243 - s_lam * z242;
    const double z247 = (z10 * z244 + z12 * z246) * (z14 / z13);
    const double z248 = z244 * z245 - z11 * z247;
    const double z249 = k3 * z237;
    const double z250 = r_R * z5;
    const double z251 = (z3 * z240 + e3z * z241) * (z5 / z4);
    const double z252 = z250 * z241 - z2 * z251;
    const double z253 = z250 * z240 - z19 * z251;
    const double z254 = k9 * z235 - k10 * z231 + (R3 * z235 - z198 * z252 - (z20 * z231 + z199 * z253));
    const double z255 = k12 * z237 + (z234 * z205 + s_steer * z254);
    const double z256 = s_lam * z239;
    const double z257 = s_lam * z256;
    const double z258 = c_lam * z256;
    const double z259 = z20 * z257 + z25 * z253 - (R3 * z258 - z26 * z252);
    const double z260 = s_lam * z234;
    const double z261 = z234 * z16 - s_steer * z248;
    const double z262 = z1 * z253;
    const double z263 = z18 * z230 - s_pitch * (z6 * z260 - z1 * z252 + c_lam * z261) + (z22 * z232 + c_pitch
        * (z21 * z260 - z262 - s_lam * z261));
    const double z264 = k10 * z257 - k9 * z258 + z259 - (z239 * z16 + c_steer * z248);
    const double z265 = z215 * z259 + (z218 * (z233 * z23 + c_roll * z263 + (z238 * z28 - e2z * z264)) - z217
        * z264);
    const double z266 = z15 * z237 - z208 * z248 - (c_lam * z249 + s_lam * z255) + z265;
    const double z267 = s_lam * z235 - c_lam * z231;
    const double z268 = z239 * z201 + c_steer * z236;
    const double z269 = z246 * z245 - z36 * z247;
    const double z270 = z37 * (s_lam * z267 + c_lam * z268) - z203 * z269 + (z15 * (s_lam * z268 - c_lam *
        z267) + z204 * z248);
    const double z271 = c_lam * z234;
    const double z272 = z34 * z252;
    const double z273 = R3 * z271 - z272 - (z20 * z260 - z262);
    const double z274 = c_lam * z269 + s_lam * z248;
    const double z275 = z239 * z38 - c_steer * z274;
    const double z276 = s_lam * z269 - c_lam * z248;
    const double z277 = z47 * z230 + s_pitch * (z239 * z6 + c_steer * z252 - c_lam * z275 + s_lam * z276) +
        (z48 * z232 - c_pitch * (z239 * z21 + c_steer * z253 + s_lam * z275 + c_lam * z276));
    const double z278 = k9 * z271 - k10 * z260 + z273 - (z234 * z38 + s_steer * z274);
    const double z279 = z215 * z273 - (z218 * (z233 * z49 + c_roll * z277 + (z238 * z39 + e2z * z278)) + z217
        * z278);
    const double z280 = z270 - (k12 * z268 - k3 * z267 + (z239 * z205 - c_steer * z254)) + z279;
    const double z281 = c_lam * z239;
    const double z282 = s_lam * z281;
    const double z283 = c_lam * z281;
    const double z284 = z20 * z282 - z31 * z253 - (R3 * z283 + z32 * z252);
    const double z285 = z234 * z40 - s_steer * z269;
    const double z286 = z52 * z230 - s_pitch * (z6 * z271 - z272 + c_lam * z285) + (z53 * z232 + c_pitch *
        (z21 * z271 - z34 * z253 - s_lam * z285));
    const double z287 = k10 * z282 - k9 * z283 + z284 - (z239 * z40 + c_steer * z269);
    const double z288 = z215 * z284 + (z218 * (z233 * z54 + c_roll * z286 - (z238 * z41 + e2z * z287)) - z217
        * z287);
    const double z289 = z37 * z237 - z208 * z269 + (s_lam * z249 - c_lam * z255) + z288;
    const double z290 = z33 * z280 - z35 * z289;
    const double z291 = z41 * z280 - z39 * z289;
    const double z292 = z59 * (z42 * z266 + z28 * z290 - z27 * z291);
    const double z293 = z233 * z218 - c_roll * z292;
    const double z294 = z231 + (z223 * z232 - c_pitch * z293);
    const double z295 = z235 - (z223 * z230 + s_pitch * z293);
    const double z296 = c_lam * z294 - s_lam * z295;
    const double z297 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z252 - R3 * z295 + (w3_pitch * z253 + z20
        * z294));
    const double z298 = k9 * z219;
    const double z299 = k10 * z219;
    const double z300 = z297 - (w3_pitch * z298 - w1_pitch * z299 - (k10 * z294 - k9 * z295));
    const double z301 = z50 * z289 + z55 * z280;
    const double z302 = z59 * (z29 * z290 + z56 * z266 + z27 * z301) + (z238 * z218 + e2z * z292);
    const double z303 = z59 * (z29 * z291 + z28 * z301 + z57 * z266) - z302;
    const double z304 = z219 * a3 - w3_pitch * v2_x + (z220 * z252 - R3 * z303);
    const double z305 = k10 * w3_pitch + k9 * w1_pitch;
    const double z306 = z304 - (z219 * z299 + w3_pitch * z305 - k9 * z302);
    const double z307 = w1_pitch * v2_x - z219 * a1 + (z220 * z253 - z20 * z303);
    const double z308 = z307 + (w1_pitch * z305 + z219 * z298 + k10 * z302);
    const double z309 = c_lam * z306 - s_lam * z308;
    const double z310 = c_steer * z300 + s_steer * z309;
    const double z311 = c_lam * z295 + s_lam * z294;
    const double z312 = z234 * z219 + s_steer * z302 + (z239 * z225 - c_steer * z311);
    const double z313 = h2z * k64 - (z226 * z228 + z227 * z229 + (k51 * z296 + (k36 * z310 + k50 * z312)));
    const double z314 = k50 * z226 - k51 * w3_steer;
    const double z315 = z239 * z219 - c_steer * z302 - (z234 * z225 + s_steer * z311);
    const double z316 = c_steer * z309 - s_steer * z300;
    const double z317 = c_lam * z308 + s_lam * z306;
    const double z318 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) - (w3_steer * z229 + z226 * z314 - (k47 *
        z315 + (k33 * z316 - k36 * z317)));
    const double z319 = h2z * k63 + (z227 * z314 - w3_steer * z228 - (k44 * z296 - (k33 * z310 - k43 *
        z312)));
    const double z320 = k33 * z226 + k36 * w3_steer;
    const double z321 = k33 * z227;
    const double z322 = z9 * k60 - (z226 * z320 + z227 * z321 - (k31 * z317 - k36 * z315));
    const double z323 = k36 * z227;
    const double z324 = h2z * k60 + (w3_steer * z321 - z226 * z323 + (k36 * z296 + (k31 * z310 - k33 *
        z312)));
    const double z325 = z8 * k60 - (z227 * z323 + w3_steer * z320 - (k31 * z316 + k33 * z315));
    const double z326 = R_yy * z220 - k27 * z219;
    const double z327 = k25 * w1_pitch + k28 * w3_pitch;
    const double z328 = e2z * k56 - (w1_pitch * z326 + z219 * z327 - (k29 * z294 + (k23 * z297 - k28 *
        z295)));
    const double z329 = k28 * w1_pitch + k29 * w3_pitch;
    const double z330 = z3 * k57 + e3z * k56 + (w3_pitch * z327 - w1_pitch * z329 - (k27 * z302 - (k22 * z304
        - k23 * z307)));
    const double z331 = e2z * k57 - (z219 * z329 + w3_pitch * z326 + (k28 * z294 - (k22 * z297 + k25 *
        z295)));
    const double z332 = k22 * w1_pitch - k23 * w3_pitch;
    const double z333 = k22 * z219;
    const double z334 = e3z * k55 + (w1_pitch * z332 + z219 * z333 - (k21 * z307 + k23 * z302));
    const double z335 = k23 * z219;
    const double z336 = z3 * k55 - (z219 * z335 - w3_pitch * z332 - (k21 * z304 - k22 * z302));
    const double z337 = e2z * k55 + (w3_pitch * z333 + w1_pitch * z335 + (k23 * z294 + (k21 * z297 + k22 *
        z295)));
    const double z338 = z74 * z328 + (z80 * z330 - (z75 * z331 + (z84 * z334 - (z82 * z336 + z77 * z337))));
    const double z339 = z76 * z313 - (z91 * z318 + (z89 * z319 + (z93 * z322 + (z87 * z324 + (z92 * z325 +
        z338)))));
    const double z340 = z339 + z149 * z303 - z150 * z315;
    const double z341 = z113 * z328 - (z119 * z330 - (z114 * z331 + (z123 * z334 - (z121 * z336 + z116 *
        z337))));
    const double z342 = z115 * z313 - (z130 * z318 + (z128 * z319 + (z132 * z322 + (z126 * z324 + (z131 *
        z325 - z341)))));
    const double z343 = z342 + z192 * z303 - z193 * z315 - z340 * z153;
    const double z344 = z159 * z328 + (z165 * z330 + (z160 * z331 - (z169 * z334 - (z167 * z336 - z162 *
        z337))));
    const double z345 = z161 * z313 - (z175 * z318 + (z174 * z319 + (z177 * z322 - (z172 * z324 - (z176 *
        z325 + z344)))));
    const double z346 = (z345 + R_yy * (z166 * z303) - F_yy * (z184 * z315) - z340 * z189 - z196 * z343) /
        z197;
    const double z347 = z195 * z343 - z196 * z346;
    /* (I.2.15) 112:4 */
    dydt[9] = z189 * z346 - (z152 * z340 - z153 * z347); /* roll'' */
    dydt[10] = -z347; /* steer'' */
    dydt[11] = z346; /* thF'' */
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
    const double k7 = s_lam * s_lam;
    const double k8 = s_lam * k1 - c_lam * k6;
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
    const double z23 = c_lam * z21 + k7;
    const double z24 = z22 * z13 + z23 * R3;
    const double z25 = c_lam * s_steer;
    const double z26 = z25 * R3 - z1 * z13;
    const double z27 = z8 * z9;
    const double z28 = k6 - c_lam * z27 - s_lam * z10;
    const double z29 = z25 * k3 - z1 * k4 + z26 - s_steer * z28;
    const double z30 = k8 + z27;
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
    const double k7 = s_lam * s_lam;
    const double k8 = s_lam * k1 - c_lam * k6;
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
    const double z32 = c_lam * z30 + k7;
    const double z33 = z5 * z31 + R3 * z32;
    const double z34 = c_lam * s_steer;
    const double z35 = R3 * z34 - z5 * z6;
    const double z36 = r_F * z14;
    const double z37 = z36 * z16;
    const double z38 = k6 - c_lam * z37 - s_lam * z17;
    const double z39 = z34 * k3 - z6 * k4 + z35 - s_steer * z38;
    const double z40 = z37 + k8;
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

    /* sines and cosines */
    const double s_yaw = sin(yaw);
    kept[0] = s_yaw;
    const double c_yaw = cos(yaw);
    kept[1] = c_yaw;
    const double e2z = sin(roll);
    kept[2] = e2z;
    const double c_roll = cos(roll);
    kept[3] = c_roll;
    const double s_pitch = sin(pitch);
    kept[4] = s_pitch;
    const double c_pitch = cos(pitch);
    kept[5] = c_pitch;
    const double s_steer = sin(steer);
    kept[6] = s_steer;
    const double c_steer = cos(steer);
    kept[7] = c_steer;

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
    const double k13 = s_lam * s_lam;
    const double k14 = s_lam * k3 - c_lam * k12;
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
    const double z2 = s_lam * s_steer;
    kept[40] = z2;
    const double e3z = c_pitch * c_roll;
    kept[41] = e3z;
    const double z3 = r_R * e3z;
    const double z4 = z1 * z1 + e3z * e3z;
    const double z5 = 1.0 / sqrt(z4);
    const double R3 = z3 * z5;
    kept[42] = R3;
    const double z6 = R3 + k9;
    kept[43] = z6;
    const double z7 = z1 * c_lam + e3z * s_lam;
    kept[44] = z7;
    const double z8 = c_steer * z7 - e2z * s_steer;
    kept[45] = z8;
    const double z9 = z1 * s_lam - e3z * c_lam;
    kept[46] = z9;
    const double z10 = c_lam * z8 + s_lam * z9;
    const double z11 = r_F * z10;
    const double z12 = c_lam * z9 - s_lam * z8;
    const double z13 = z10 * z10 + z12 * z12;
    const double z14 = 1.0 / sqrt(z13);
    const double z15 = z11 * z14;
    kept[47] = z15;
    const double z16 = z15 - k15;
    kept[48] = z16;
    const double z17 = s_steer * z16;
    const double z18 = z2 * z6 + c_lam * z17;
    kept[49] = z18;
    const double z19 = r_R * z1;
    const double z20 = z19 * z5;
    kept[50] = z20;
    const double z21 = z20 + k10;
    kept[51] = z21;
    const double z22 = z2 * z21 - s_lam * z17;
    kept[52] = z22;
    const double z23 = s_pitch * z18 - c_pitch * z22;
    kept[53] = z23;
    const double z24 = s_lam * c_steer;
    const double z25 = k11 + s_lam * z24;
    kept[54] = z25;
    const double z26 = c_lam * (s_lam - z24);
    kept[55] = z26;
    const double z27 = z20 * z25 + R3 * z26;
    kept[56] = z27;
    const double z28 = k10 * z25 + k9 * z26 + z27 - c_steer * z16;
    kept[57] = z28;
    const double z29 = c_roll * z23 - e2z * z28;
    kept[58] = z29;
    const double z30 = c_lam * c_steer;
    const double z31 = s_lam * (c_lam - z30);
    kept[59] = z31;
    const double z32 = c_lam * z30 + k13;
    kept[60] = z32;
    const double z33 = z20 * z31 + R3 * z32;
    kept[61] = z33;
    const double z34 = c_lam * s_steer;
    kept[62] = z34;
    const double z35 = R3 * z34 - z20 * z2;
    kept[63] = z35;
    const double z36 = r_F * z12;
    const double z37 = z36 * z14;
    kept[64] = z37;
    const double z38 = k12 - c_lam * z37 - s_lam * z15;
    const double z39 = z34 * k9 - z2 * k10 + z35 - s_steer * z38;
    kept[65] = z39;
    const double z40 = z37 + k14;
    kept[66] = z40;
    const double z41 = k10 * z31 + k9 * z32 + z33 + c_steer * z40;
    kept[67] = z41;
    const double z42 = z33 * z39 - z41 * z35;
    kept[68] = z42;
    const double z43 = c_steer * z38;
    const double z44 = s_lam * z37;
    kept[69] = z44;
    const double z45 = c_lam * z15;
    kept[70] = z45;
    const double z46 = k3 + z44 - z45;
    const double z47 = c_steer * z6 - c_lam * z43 + s_lam * z46;
    const double z48 = c_steer * z21 + s_lam * z43 + c_lam * z46;
    const double z49 = s_pitch * z47 - c_pitch * z48;
    const double z50 = c_roll * z49 - e2z * z39;
    kept[71] = z50;
    const double z51 = s_steer * z40;
    const double z52 = z34 * z6 + c_lam * z51;
    kept[72] = z52;
    const double z53 = z34 * z21 - s_lam * z51;
    kept[73] = z53;
    const double z54 = s_pitch * z52 - c_pitch * z53;
    kept[74] = z54;
    const double z55 = c_roll * z54 + e2z * z41;
    kept[75] = z55;
    const double z56 = z33 * z50 + z55 * z35;
    kept[76] = z56;
    const double z57 = z41 * z50 + z55 * z39;
    kept[77] = z57;
    const double z58 = 1.0 / (z29 * z42 - z28 * z56 + z27 * z57);
    kept[78] = z58;
    const double z59 = roll_dot * c_pitch;
    const double z60 = roll_dot * s_pitch;
    const double z61 = steer_dot + (s_lam * z59 + c_lam * z60);
    const double z62 = s_lam * z60 - c_lam * z59;
    const double z63 = c_steer * z62;
    const double z64 = s_lam * z61 - c_lam * z63;
    const double z65 = s_lam * z63 + c_lam * z61;
    const double z66 = z59 * k9 + z60 * k10 + (z59 * R3 + z60 * z20);
    kept[79] = z66;
    const double z67 = z37 * z64 - z15 * z65 + (k12 * z63 + k3 * z61 + c_steer * z66);
    const double z68 = s_steer * z62;
    const double z69 = thF_dot + z68;
    kept[80] = z69;
    const double z70 = k3 * z68;
    const double z71 = k12 * z68 + s_steer * z66;
    const double z72 = z37 * z69 + (s_lam * z70 - c_lam * z71);
    const double z73 = z33 * z67 - z35 * z72;
    const double z74 = z15 * z69 - (s_lam * z71 + c_lam * z70);
    const double z75 = z50 * z72 + z55 * z67;
    const double z76 = z58 * (z29 * z73 + z56 * z74 + z27 * z75);
    kept[81] = z76;
    const double z77 = z41 * z67 - z39 * z72;
    const double z78 = z58 * (z42 * z74 + z28 * z73 - z27 * z77);
    kept[82] = z78;
    const double z79 = z76 + e2z * z78;
    kept[83] = z79;
    const double z80 = k18 * z79;
    kept[84] = z80;
    const double z81 = c_roll * z78;
    kept[85] = z81;
    const double w3_pitch = z60 - c_pitch * z81;
    kept[86] = w3_pitch;
    const double w1_pitch = z59 + s_pitch * z81;
    kept[87] = w1_pitch;
    const double z82 = k17 * w1_pitch - k18 * w3_pitch;
    kept[88] = z82;
    const double z83 = z58 * (z29 * z77 + z28 * z75 + z57 * z74);
    kept[89] = z83;
    const double z84 = z83 - z79;
    kept[90] = z84;
    const double a3 = z20 * z84;
    kept[91] = a3;
    const double v2_x = R3 * w1_pitch + z20 * w3_pitch;
    kept[92] = v2_x;
    const double z85 = r_R * z5;
    const double z86 = roll_dot * e2z;
    kept[93] = z86;
    const double z87 = s_pitch * z76;
    kept[94] = z87;
    const double z88 = c_pitch * z86 - c_roll * z87;
    const double z89 = c_pitch * z76;
    kept[95] = z89;
    const double z90 = s_pitch * z86 + c_roll * z89;
    const double z91 = (z1 * z90 + e3z * z88) * (z5 / z4);
    const double z92 = z85 * z88 - z3 * z91;
    kept[96] = z92;
    const double z93 = roll_dot * z87;
    kept[97] = z93;
    const double z94 = roll_dot * z89;
    kept[98] = z94;
    const double z95 = s_lam * z93 - c_lam * z94;
    const double z96 = steer_dot * s_steer;
    kept[99] = z96;
    const double z97 = s_lam * z94 + c_lam * z93;
    const double z98 = z96 * z62 + c_steer * z97;
    const double z99 = s_lam * z90 - c_lam * z88;
    const double z100 = roll_dot * c_roll;
    kept[100] = z100;
    const double z101 = steer_dot * c_steer;
    kept[101] = z101;
    const double z102 = s_steer * z100 + e2z * z101 + (z7 * z96 + c_steer * (c_lam * z90 + s_lam * z88));
    const double z103 = c_lam * z99 - s_lam * z102;
    const double z104 = r_F * z14;
    const double z105 = c_lam * z102 + s_lam * z99;
    const double z106 = (z10 * z105 + z12 * z103) * (z14 / z13);
    const double z107 = z103 * z104 - z36 * z106;
    kept[102] = z107;
    const double z108 = z105 * z104 - z11 * z106;
    kept[103] = z108;
    const double z109 = z37 * (s_lam * z95 + c_lam * z98) - z64 * z107 + (z15 * (s_lam * z98 - c_lam * z95) +
        z65 * z108);
    const double z110 = z85 * z90 - z19 * z91;
    kept[104] = z110;
    const double z111 = k9 * z93 - k10 * z94 + (R3 * z93 - z59 * z92 - (z20 * z94 + z60 * z110));
    kept[105] = z111;
    const double z112 = c_lam * z101;
    kept[106] = z112;
    const double z113 = z34 * z92;
    kept[107] = z113;
    const double z114 = s_lam * z101;
    kept[108] = z114;
    const double z115 = z2 * z110;
    kept[109] = z115;
    const double z116 = R3 * z112 - z113 - (z20 * z114 - z115);
    const double z117 = c_lam * z107 + s_lam * z108;
    const double z118 = z96 * z38 - c_steer * z117;
    const double z119 = s_lam * z107 - c_lam * z108;
    const double z120 = z47 * z89 + s_pitch * (z96 * z6 + c_steer * z92 - c_lam * z118 + s_lam * z119) + (z48
        * z87 - c_pitch * (z96 * z21 + c_steer * z110 + s_lam * z118 + c_lam * z119));
    const double z121 = k9 * z112 - k10 * z114 + z116 - (z101 * z38 + s_steer * z117);
    const double z122 = z83 * z116 - (z78 * (z86 * z49 + c_roll * z120 + (z100 * z39 + e2z * z121)) + z76 *
        z121);
    const double z123 = z109 - (k12 * z98 - k3 * z95 + (z96 * z66 - c_steer * z111)) + z122;
    kept[110] = z123;
    const double z124 = z101 * z62 - s_steer * z97;
    kept[111] = z124;
    return BICYCLE_OK;
}

static int bicycle_reactions_part2(double t, const double *y, const double *p, const double *dydt, double
    *kept, double *lambda)
{
    (void)t;
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */
    const double s_yaw = kept[0];
    const double c_yaw = kept[1];
    const double e2z = kept[2];
    const double c_roll = kept[3];
    const double s_pitch = kept[4];
    const double c_pitch = kept[5];
    const double s_steer = kept[6];
    const double c_steer = kept[7];
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
    const double z2 = kept[40];
    const double e3z = kept[41];
    const double R3 = kept[42];
    const double z6 = kept[43];
    const double z7 = kept[44];
    const double z8 = kept[45];
    const double z9 = kept[46];
    const double z15 = kept[47];
    const double z16 = kept[48];
    const double z18 = kept[49];
    const double z20 = kept[50];
    const double z21 = kept[51];
    const double z22 = kept[52];
    const double z23 = kept[53];
    const double z25 = kept[54];
    const double z26 = kept[55];
    const double z27 = kept[56];
    const double z28 = kept[57];
    const double z29 = kept[58];
    const double z31 = kept[59];
    const double z32 = kept[60];
    const double z33 = kept[61];
    const double z34 = kept[62];
    const double z35 = kept[63];
    const double z37 = kept[64];
    const double z39 = kept[65];
    const double z40 = kept[66];
    const double z41 = kept[67];
    const double z42 = kept[68];
    const double z44 = kept[69];
    const double z45 = kept[70];
    const double z50 = kept[71];
    const double z52 = kept[72];
    const double z53 = kept[73];
    const double z54 = kept[74];
    const double z55 = kept[75];
    const double z56 = kept[76];
    const double z57 = kept[77];
    const double z58 = kept[78];
    const double z66 = kept[79];
    const double z69 = kept[80];
    const double z76 = kept[81];
    const double z78 = kept[82];
    const double z79 = kept[83];
    const double z80 = kept[84];
    const double z81 = kept[85];
    const double w3_pitch = kept[86];
    const double w1_pitch = kept[87];
    const double z82 = kept[88];
    const double z83 = kept[89];
    const double z84 = kept[90];
    const double a3 = kept[91];
    const double v2_x = kept[92];
    const double z86 = kept[93];
    const double z87 = kept[94];
    const double z89 = kept[95];
    const double z92 = kept[96];
    const double z93 = kept[97];
    const double z94 = kept[98];
    const double z96 = kept[99];
    const double z100 = kept[100];
    const double z101 = kept[101];
    const double z107 = kept[102];
    const double z108 = kept[103];
    const double z110 = kept[104];
    const double z111 = kept[105];
    const double z112 = kept[106];
    const double z113 = kept[107];
    const double z114 = kept[108];
    const double z115 = kept[109];
    const double z123 = kept[110];
    const double z124 = kept[111];
    const double z125 = k3 * z124;
    const double z126 = k12 * z124 + (z101 * z66 + s_steer * z111);
    const double z127 = c_lam * z96;
    const double z128 = s_lam * z127;
    const double z129 = c_lam * z127;
    const double z130 = z20 * z128 - z31 * z110 - (R3 * z129 + z32 * z92);
    const double z131 = z101 * z40 - s_steer * z107;
    const double z132 = z52 * z89 - s_pitch * (z6 * z112 - z113 + c_lam * z131) + (z53 * z87 + c_pitch * (z21
        * z112 - z34 * z110 - s_lam * z131));
    const double z133 = k10 * z128 - k9 * z129 + z130 - (z96 * z40 + c_steer * z107);
    const double z134 = z83 * z130 + (z78 * (z86 * z54 + c_roll * z132 - (z100 * z41 + e2z * z133)) - z76 *
        z133);
    const double z135 = z37 * z124 - z69 * z107 + (s_lam * z125 - c_lam * z126) + z134;
    const double z136 = z41 * z123 - z39 * z135;
    const double z137 = z50 * z135 + z55 * z123;
    const double z138 = s_lam * z96;
    const double z139 = s_lam * z138;
    const double z140 = c_lam * z138;
    const double z141 = z20 * z139 + z25 * z110 - (R3 * z140 - z26 * z92);
    const double z142 = z101 * z16 - s_steer * z108;
    const double z143 = z18 * z89 - s_pitch * (z6 * z114 - z2 * z92 + c_lam * z142) + (z22 * z87 + c_pitch *
        (z21 * z114 - z115 - s_lam * z142));
    const double z144 = k10 * z139 - k9 * z140 + z141 - (z96 * z16 + c_steer * z108);
    const double z145 = z83 * z141 + (z78 * (z86 * z23 + c_roll * z143 + (z100 * z28 - e2z * z144)) - z76 *
        z144);
    const double z146 = z15 * z124 - z69 * z108 - (c_lam * z125 + s_lam * z126) + z145;
    const double z147 = z33 * z123 - z35 * z135;
    const double z148 = z58 * (z42 * z146 + z28 * z147 - z27 * z136);
    const double z149 = z58 * (z29 * z147 + z56 * z146 + z27 * z137) + (z100 * z78 + e2z * z148);
    const double z150 = z58 * (z29 * z136 + z28 * z137 + z57 * z146) - z149;
    const double z151 = z79 * a3 - w3_pitch * v2_x + (z84 * z92 - R3 * z150);
    const double z152 = z37 * z39;
    const double z153 = z37 * z50;
    const double z154 = z37 * z35;
    const double z155 = z58 * (z15 * z42 - z28 * z154 + z27 * z152);
    const double z156 = z58 * (z29 * z154 - z15 * z56 - z27 * z153) - e2z * z155;
    const double z157 = z58 * (z29 * z152 - z28 * z153 - z15 * z57) - z156;
    const double z158 = R3 * z157;
    const double z159 = c_pitch * s_lam + s_pitch * c_lam;
    const double z160 = s_pitch * s_lam - c_pitch * c_lam;
    const double z161 = c_steer * z160;
    const double z162 = c_pitch * k9 + s_pitch * k10 + (c_pitch * R3 + s_pitch * z20);
    const double z163 = z37 * (s_lam * z159 - c_lam * z161) - z15 * (s_lam * z161 + c_lam * z159) + (k12 *
        z161 + k3 * z159 + c_steer * z162);
    const double z164 = s_steer * z160;
    const double z165 = k3 * z164;
    const double z166 = k12 * z164 + s_steer * z162;
    const double z167 = z37 * z164 + (s_lam * z165 - c_lam * z166);
    const double z168 = z41 * z163 - z39 * z167;
    const double z169 = z50 * z167 + z55 * z163;
    const double z170 = z15 * z164 - (s_lam * z166 + c_lam * z165);
    const double z171 = z33 * z163 - z35 * z167;
    const double z172 = z58 * (z42 * z170 + z28 * z171 - z27 * z168);
    const double z173 = z58 * (z29 * z171 + z56 * z170 + z27 * z169) + e2z * z172;
    const double z174 = z58 * (z29 * z168 + z28 * z169 + z57 * z170) - z173;
    const double z175 = R3 * z174;
    const double z176 = k3 + (z44 - z45);
    const double z177 = z41 * z176;
    const double z178 = z55 * z176;
    const double z179 = z33 * z176;
    const double z180 = z58 * (z28 * z179 - z27 * z177);
    const double z181 = z58 * (z29 * z179 + z27 * z178) + e2z * z180;
    const double z182 = z58 * (z29 * z177 + z28 * z178) - z181;
    const double z183 = R3 * z182;
    const double z184 = z158 * thF_ddot - (z175 * roll_ddot + z183 * steer_ddot);
    const double z185 = z156 * thF_ddot - (z173 * roll_ddot + z181 * steer_ddot);
    const double z186 = z1 * k50 - (z79 * z80 - w3_pitch * z82 - (k16 * z151 - k17 * z149)) + (k16 * z184 +
        k17 * z185);
    const double h2z = e2z * c_steer + s_steer * z7;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    const double z187 = c_lam * w1_pitch - s_lam * w3_pitch;
    const double z188 = c_steer * z79 + s_steer * z187;
    const double z189 = k28 * z188;
    const double z190 = s_steer * z79 - c_steer * z187;
    const double z191 = k31 * z188;
    const double z192 = z86 * z78 - c_roll * z148;
    const double z193 = z94 + (z81 * z87 - c_pitch * z192);
    const double z194 = z93 - (z81 * z89 + s_pitch * z192);
    const double z195 = c_lam * z193 - s_lam * z194;
    const double a1 = R3 * z84;
    const double z196 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z92 - R3 * z194 + (w3_pitch * z110 + z20
        * z193));
    const double z197 = k9 * z79;
    const double z198 = k10 * z79;
    const double z199 = z196 - (w3_pitch * z197 - w1_pitch * z198 - (k10 * z193 - k9 * z194));
    const double z200 = k10 * w3_pitch + k9 * w1_pitch;
    const double z201 = z151 - (z79 * z198 + w3_pitch * z200 - k9 * z149);
    const double z202 = w1_pitch * v2_x - z79 * a1 + (z84 * z110 - z20 * z150);
    const double z203 = z202 + (w1_pitch * z200 + z79 * z197 + k10 * z149);
    const double z204 = c_lam * z201 - s_lam * z203;
    const double z205 = c_steer * z199 + s_steer * z204;
    const double z206 = c_lam * z194 + s_lam * z193;
    const double z207 = z101 * z79 + s_steer * z149 + (z96 * z187 - c_steer * z206);
    const double z208 = h2z * k55 + (w3_steer * z189 - z190 * z191 + (k31 * z195 + (k26 * z205 - k28 *
        z207)));
    const double z209 = c_roll * z155;
    const double z210 = c_pitch * z209;
    const double z211 = s_pitch * z209;
    const double z212 = c_roll * z172;
    const double z213 = s_pitch - c_pitch * z212;
    const double z214 = c_pitch + s_pitch * z212;
    const double z215 = c_roll * z180;
    const double z216 = c_pitch * z215;
    const double z217 = s_pitch * z215;
    const double z218 = (c_lam * z210 - s_lam * z211) * thF_ddot - ((c_lam * z213 + s_lam * z214) * roll_ddot
        + (1.0 - (c_lam * z216 - s_lam * z217)) * steer_ddot);
    const double z219 = R3 * z211 - z20 * z210;
    const double z220 = z219 - (k10 * z210 - k9 * z211);
    const double z221 = z158 - k9 * z156;
    const double z222 = z20 * z157;
    const double z223 = z222 - k10 * z156;
    const double z224 = c_lam * z221 - s_lam * z223;
    const double z225 = R3 * z214 + z20 * z213;
    const double z226 = z225 + (k10 * z213 + k9 * z214);
    const double z227 = z175 - k9 * z173;
    const double z228 = z20 * z174;
    const double z229 = z228 - k10 * z173;
    const double z230 = c_lam * z227 - s_lam * z229;
    const double z231 = R3 * z217 - z20 * z216;
    const double z232 = z231 - (k10 * z216 - k9 * z217);
    const double z233 = z183 - k9 * z181;
    const double z234 = z20 * z182;
    const double z235 = z234 - k10 * z181;
    const double z236 = c_lam * z233 - s_lam * z235;
    const double z237 = (c_steer * z220 - s_steer * z224) * thF_ddot + ((c_steer * z226 + s_steer * z230) *
        roll_ddot + (c_steer * z232 + s_steer * z236) * steer_ddot);
    const double z238 = c_lam * z211 + s_lam * z210;
    const double z239 = c_lam * z214 - s_lam * z213;
    const double z240 = c_lam * z217 + s_lam * z216;
    const double z241 = (s_steer * z156 + c_steer * z238) * thF_ddot - ((s_steer * z173 - c_steer * z239) *
        roll_ddot + (s_steer * z181 - c_steer * z240) * steer_ddot);
    const double z242 = z208 + (k31 * z218 - (k26 * z237 - k28 * z241));
    const double z243 = k28 * z190 + k31 * w3_steer;
    const double z244 = c_steer * z204 - s_steer * z199;
    const double z245 = z96 * z79 - c_steer * z149 - (z101 * z187 + s_steer * z206);
    const double z246 = (c_steer * z224 + s_steer * z220) * thF_ddot - ((c_steer * z230 - s_steer * z226) *
        roll_ddot + (c_steer * z236 - s_steer * z232) * steer_ddot);
    const double z247 = c_steer * z156 - s_steer * z238;
    const double z248 = (c_steer * z173 + s_steer * z239) * roll_ddot + (c_steer * z181 + s_steer * z240) *
        steer_ddot;
    const double z249 = z247 * thF_ddot - z248;
    const double z250 = z8 * k55 - (z188 * z191 + w3_steer * z243 - (k26 * z244 + k28 * z245)) + (k26 * z246
        + k28 * z249);
    const double z251 = s_steer * z242 + c_steer * z250;
    const double z252 = c_lam * z203 + s_lam * z201;
    const double z253 = (c_lam * z223 + s_lam * z221) * thF_ddot - ((c_lam * z229 + s_lam * z227) * roll_ddot
        + (c_lam * z235 + s_lam * z233) * steer_ddot);
    const double z254 = z9 * k55 - (z190 * z243 + z188 * z189 - (k26 * z252 - k31 * z245)) + (k26 * z253 -
        k31 * z249);
    const double z255 = c_lam * z251 + s_lam * z254;
    const double z256 = z186 + z255;
    const double z257 = k17 * z79;
    const double z258 = z222 * thF_ddot - (z228 * roll_ddot + z234 * steer_ddot);
    const double z259 = e3z * k50 + (w1_pitch * z82 + z79 * z257 - (k16 * z202 + k18 * z149)) - (k16 * z258 -
        k18 * z185);
    const double z260 = s_lam * z251 - c_lam * z254;
    const double z261 = z259 + z260;
    const double z262 = R_yy * (z150 - (z157 * thF_ddot - (z174 * roll_ddot + z182 * steer_ddot))) + z20 *
        z261 - R3 * z256;
    const double z263 = z58 * z262;
    const double z264 = k20 * w1_pitch + k23 * w3_pitch;
    const double z265 = k23 * w1_pitch + k24 * w3_pitch;
    const double z266 = z1 * k52 + e3z * k51 + (w3_pitch * z264 - w1_pitch * z265 - (k22 * z149 - (k17 * z151
        - k18 * z202)));
    const double z267 = k38 * z190 - k39 * w3_steer;
    const double z268 = k45 * z190 - k46 * w3_steer;
    const double z269 = z8 * k54 + z9 * k53 + (z8 * k57 - z9 * k56) - (w3_steer * z267 + z190 * z268 - (k42 *
        z245 + (k28 * z244 - k31 * z252)));
    const double z270 = z269 + (k42 * z249 + (k28 * z246 - k31 * z253)) + F_yy * (z245 - (z248 - (1.0 + z247)
        * thF_ddot));
    const double z271 = z266 + (k22 * z185 + (k17 * z184 - k18 * z258)) + k10 * z260 - k9 * z255 + c_steer *
        z270;
    const double z272 = F_yy * (thF_dot - z188) - k42 * z188;
    const double z273 = h2z * k58 + (z188 * z268 - w3_steer * z272 - (k39 * z195 - (k28 * z205 - k38 *
        z207)));
    const double z274 = z273 - (k39 * z218 + (k28 * z237 - k38 * z241));
    const double z275 = z271 + s_steer * z274 + z262;
    const double z276 = z58 * z275;
    const double z277 = z28 * z263 - z27 * z276;
    const double z278 = R_yy * z84 - k22 * z79;
    const double z279 = e2z * k51 - (w1_pitch * z278 + z79 * z264 - (k24 * z193 + (k18 * z196 - k23 * z194)));
    const double z280 = z210 * thF_ddot - (z213 * roll_ddot - z216 * steer_ddot);
    const double z281 = z219 * thF_ddot + (z225 * roll_ddot + z231 * steer_ddot);
    const double z282 = z211 * thF_ddot + (z214 * roll_ddot + z217 * steer_ddot);
    const double z283 = c_steer * z242 - s_steer * z250;
    const double z284 = s_steer * z270 - c_steer * z274;
    const double z285 = h2z * k59 - (z190 * z272 + z188 * z267 + (k46 * z195 + (k31 * z205 + k45 * z207)));
    const double z286 = z285 - (k46 * z218 - (k31 * z237 + k45 * z241));
    const double z287 = z279 + (k24 * z280 - (k18 * z281 + k23 * z282)) + k10 * z283 - s_lam * z284 - c_lam *
        z286;
    const double z288 = e2z * k50 + (w3_pitch * z257 + w1_pitch * z80 + (k18 * z193 + (k16 * z196 + k17 *
        z194)));
    const double z289 = z288 + (k18 * z280 - (k16 * z281 - k17 * z282)) + z283;
    const double z290 = e2z * k52 - (z79 * z265 + w3_pitch * z278 + (k23 * z193 - (k17 * z196 + k20 * z194)));
    const double z291 = z290 - (k23 * z280 + (k17 * z281 - k20 * z282)) - k9 * z283 - c_lam * z284 + s_lam *
        z286;
    const double z292 = z58 * (c_roll * (c_pitch * (z287 + z20 * z289) + s_pitch * (z291 - R3 * z289)) - e2z
        * z275);
    const double z293 = z29 * z263 - z27 * z292;
    const double z294 = z29 * z276 - z28 * z292;
    const double z295 = z50 * z277 - z39 * z293 + z35 * z294;
    const double z296 = z57 * z263 - z56 * z276 + z42 * z292;
    const double z297 = s_lam * z295 - c_lam * z296;
    const double z298 = s_lam * z297;
    const double z299 = z55 * z277 + z41 * z293 - z33 * z294;
    const double z300 = c_lam * z295 + s_lam * z296;
    const double z301 = s_steer * z299 + c_steer * z300;
    const double z302 = c_lam * z301;
    const double z303 = z256 - z298 - z302;
    const double z304 = c_lam * z297;
    const double z305 = s_lam * z301;
    const double z306 = z261 + z304 - z305;
    const double z307 = s_pitch * z303 + c_pitch * z306;
    const double z308 = c_steer * z299 - s_steer * z300;
    const double z309 = z289 - z308;
    const double z310 = e2z * z307 - c_roll * z309;
    const double z311 = c_pitch * z303 - s_pitch * z306;
    /* (I.4.1) 115:5 */
    lambda[0] = c_yaw * z311 - s_yaw * z310; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 116:5 */
    lambda[1] = c_yaw * z310 + s_yaw * z311; /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 117:5 */
    lambda[2] = -(c_roll * z307 + e2z * z309); /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z312 = z298 + z302;
    const double z313 = z304 - z305;
    const double z314 = s_pitch * z312 - c_pitch * z313;
    const double z315 = e2z * z314 - c_roll * z308;
    const double z316 = c_pitch * z312 + s_pitch * z313;
    /* (I.4.1) 118:5 */
    lambda[3] = c_yaw * z316 - s_yaw * z315; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    /* (I.4.1) 119:5 */
    lambda[4] = c_yaw * z315 + s_yaw * z316; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    /* (I.4.1) 120:5 */
    lambda[5] = -(c_roll * z314 + e2z * z308); /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return BICYCLE_OK;
}

int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[112]; /* what parts of this function leave for others */
    double dydt[12];
    const int status1 = bicycle_rhs(t, y, p, dydt);
    if (status1 != BICYCLE_OK) {
        return status1;
    }
    int status = bicycle_reactions_part1(t, y, p, dydt, kept, lambda);
    if (status == BICYCLE_OK) {
        status = bicycle_reactions_part2(t, y, p, dydt, kept, lambda);
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
    const double k10 = s_lam * s_lam;
    const double k11 = s_lam * k4 - c_lam * k9;
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
    const double z26 = c_lam * z25 + k10;
    const double z27 = s_lam * (c_lam - z25);
    const double z28 = R3 * z26 + z27 * z11;
    const double z29 = c_lam * s_steer;
    const double z30 = R3 * z29 - z12 * z11;
    const double z31 = z9 * z14;
    const double z32 = k9 - c_lam * z31 - s_lam * z15;
    const double z33 = z29 * k6 - z12 * k7 + z30 - s_steer * z32;
    const double z34 = z31 + k11;
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
    const double k13 = s_lam * s_lam;
    const double k14 = s_lam * k3 - c_lam * k12;
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
    const double z33 = c_lam * z31 + k13;
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
    const double z44 = z40 + k14;
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
    kept[193] = z161;
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
    const double z161 = kept[193];
    const double z162 = z128 * z146 + (z147 * z150 - (z145 * z151 - (z149 * z152 + (z143 * z153 + (z148 *
        z154 + z161)))));
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
    const double z393 = s_lam * z35;
    const double z394 = c_lam * z35;
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
    kept[302] = z443;
    const double z444 = steer_dot * s_steer;
    kept[303] = z444;
    const double z445 = roll_dot * e2z;
    kept[304] = z445;
    const double z446 = c_pitch * z248;
    kept[305] = z446;
    const double z447 = s_pitch * z445 + c_roll * z446;
    kept[306] = z447;
    const double z448 = s_pitch * z248;
    kept[307] = z448;
    const double z449 = c_pitch * z445 - c_roll * z448;
    kept[308] = z449;
    const double z450 = s_lam * z447 - c_lam * z449;
    const double z451 = roll_dot * c_roll;
    kept[309] = z451;
    const double z452 = steer_dot * c_steer;
    kept[310] = z452;
    const double z453 = c_lam * z447 + s_lam * z449;
    kept[311] = z453;
    const double z454 = s_steer * z451 + e2z * z452 + (z7 * z444 + c_steer * z453);
    const double z455 = c_lam * z450 - s_lam * z454;
    kept[312] = z455;
    const double z456 = r_F * z455;
    kept[313] = z456;
    const double z457 = c_lam * z454 + s_lam * z450;
    kept[314] = z457;
    const double z458 = z10 * z457 + z12 * z455;
    kept[315] = z458;
    const double z459 = z14 * z458;
    kept[316] = z459;
    const double z460 = z276 * z459;
    kept[317] = z460;
    const double z461 = z14 * z456 - z39 * z460;
    kept[318] = z461;
    const double z462 = roll_dot * z448;
    kept[319] = z462;
    const double z463 = roll_dot * z446;
    kept[320] = z463;
    const double z464 = s_lam * z462 - c_lam * z463;
    const double z465 = s_lam * z463 + c_lam * z462;
    kept[321] = z465;
    const double z466 = z444 * z228 + c_steer * z465;
    const double z467 = s_lam * z464 + c_lam * z466;
    kept[322] = z467;
    const double z468 = r_F * z457;
    kept[323] = z468;
    const double z469 = z14 * z468 - z11 * z460;
    kept[324] = z469;
    const double z470 = s_lam * z466 - c_lam * z464;
    kept[325] = z470;
    const double z471 = r_R * z449;
    kept[326] = z471;
    const double z472 = z3 * z447 + e3z * z449;
    kept[327] = z472;
    const double z473 = z5 * z472;
    kept[328] = z473;
    const double z474 = z267 * z473;
    kept[329] = z474;
    const double z475 = z5 * z471 - z2 * z474;
    kept[330] = z475;
    const double z476 = r_R * z447;
    kept[331] = z476;
    const double z477 = z5 * z476 - z19 * z474;
    kept[332] = z477;
    const double z478 = k9 * z462 - k10 * z463 + (R3 * z462 - z224 * z475 - (z20 * z463 + z225 * z477));
    kept[333] = z478;
    const double z479 = z230 * z461 - z40 * z467 - (z231 * z469 + z15 * z470) + (k12 * z466 - k3 * z464 +
        (z444 * z233 - c_steer * z478));
    const double z480 = c_lam * z452;
    kept[334] = z480;
    const double z481 = z35 * z475;
    const double z482 = s_lam * z452;
    kept[335] = z482;
    const double z483 = z1 * z477;
    const double z484 = R3 * z480 - z481 - (z20 * z482 - z483);
    kept[336] = z484;
    const double z485 = c_lam * z461 + s_lam * z469;
    kept[337] = z485;
    const double z486 = z444 * z41 - c_steer * z485;
    const double z487 = s_lam * z461 - c_lam * z469;
    const double z488 = z444 * z6 + c_steer * z475 - c_lam * z486 + s_lam * z487;
    kept[338] = z488;
    const double z489 = z444 * z21 + c_steer * z477 + s_lam * z486 + c_lam * z487;
    kept[339] = z489;
    const double z490 = z52 * z446 + s_pitch * z488 + (z53 * z448 - c_pitch * z489);
    kept[340] = z490;
    const double z491 = k9 * z480 - k10 * z482 + z484 - (z452 * z41 + s_steer * z485);
    kept[341] = z491;
    const double z492 = z445 * z54 + c_roll * z490 + (z451 * z43 + e2z * z491);
    kept[342] = z492;
    const double z493 = z479 - (z245 * z484 - (z250 * z492 + z248 * z491));
    kept[343] = z493;
    const double z494 = z452 * z228 - s_steer * z465;
    kept[344] = z494;
    const double z495 = k3 * z494;
    const double z496 = k12 * z494 + (z452 * z233 + s_steer * z478);
    const double z497 = c_lam * z444;
    const double z498 = s_lam * z497;
    kept[345] = z498;
    const double z499 = c_lam * z497;
    kept[346] = z499;
    const double z500 = z20 * z498 - z32 * z477 - (R3 * z499 + z33 * z475);
    kept[347] = z500;
    const double z501 = z452 * z44 - s_steer * z461;
    const double z502 = z6 * z480 - z481 + c_lam * z501;
    kept[348] = z502;
    const double z503 = z21 * z480 - z35 * z477 - s_lam * z501;
    kept[349] = z503;
    const double z504 = z57 * z446 - s_pitch * z502 + (z58 * z448 + c_pitch * z503);
    kept[350] = z504;
    const double z505 = k10 * z498 - k9 * z499 + z500 - (z444 * z44 + c_steer * z461);
    kept[351] = z505;
    const double z506 = z445 * z59 + c_roll * z504 - (z451 * z46 + e2z * z505);
    kept[352] = z506;
    const double z507 = z237 * z461 - z40 * z494 - (s_lam * z495 - c_lam * z496) - (z245 * z500 + (z250 *
        z506 - z248 * z505));
    kept[353] = z507;
    const double z508 = z34 * z493 - z38 * z507;
    kept[354] = z508;
    const double z509 = s_lam * z444;
    const double z510 = s_lam * z509;
    kept[355] = z510;
    const double z511 = c_lam * z509;
    kept[356] = z511;
    const double z512 = z20 * z510 + z25 * z477 - (R3 * z511 - z26 * z475);
    kept[357] = z512;
    const double z513 = z452 * z16 - s_steer * z469;
    const double z514 = z6 * z482 - z1 * z475 + c_lam * z513;
    kept[358] = z514;
    const double z515 = z21 * z482 - z483 - s_lam * z513;
    kept[359] = z515;
    const double z516 = z18 * z446 - s_pitch * z514 + (z22 * z448 + c_pitch * z515);
    kept[360] = z516;
    const double z517 = k10 * z510 - k9 * z511 + z512 - (z444 * z16 + c_steer * z469);
    kept[361] = z517;
    const double z518 = z445 * z23 + c_roll * z516 + (z451 * z29 - e2z * z517);
    kept[362] = z518;
    const double z519 = z237 * z469 - z15 * z494 + (s_lam * z496 + c_lam * z495) - (z245 * z512 + (z250 *
        z518 - z248 * z517));
    kept[363] = z519;
    const double z520 = z55 * z507 + z60 * z493;
    kept[364] = z520;
    const double z521 = z30 * z508 + z61 * z519 + z27 * z520;
    kept[365] = z521;
    const double z522 = z46 * z493 - z43 * z507;
    kept[366] = z522;
    const double z523 = z47 * z519 + z29 * z508 - z27 * z522;
    kept[367] = z523;
    const double z524 = z64 * z523;
    kept[368] = z524;
    const double z525 = z64 * z521 - (z451 * z250 - e2z * z524);
    kept[369] = z525;
    const double z526 = c_lam * w1_pitch - s_lam * w3_pitch;
    kept[370] = z526;
    const double z527 = z445 * z250 + c_roll * z524;
    kept[371] = z527;
    const double z528 = z462 - (z261 * z446 + s_pitch * z527);
    kept[372] = z528;
    const double z529 = z463 + (z261 * z448 - c_pitch * z527);
    kept[373] = z529;
    const double z530 = c_lam * z528 + s_lam * z529;
    kept[374] = z530;
    const double z531 = z444 * z252 + c_steer * z525 - (z452 * z526 + s_steer * z530);
    kept[375] = z531;
    const double z532 = z30 * z522 + z29 * z520 + z62 * z519;
    kept[376] = z532;
    const double z533 = z64 * z532 - z525;
    kept[377] = z533;
    const double z534 = c_lam * z529 - s_lam * z528;
    const double z535 = w1_pitch * z475 - R3 * z528 + (w3_pitch * z477 + z20 * z529) + (a1 * w3_pitch - a3 *
        w1_pitch);
    const double z536 = k9 * z252;
    kept[378] = z536;
    const double z537 = k10 * z252;
    kept[379] = z537;
    const double z538 = z535 + (k10 * z529 - k9 * z528 - (w3_pitch * z536 - w1_pitch * z537));
    kept[380] = z538;
    const double z539 = z253 * z475 + R3 * z533 + (z252 * a3 - w3_pitch * v2_x);
    const double z540 = k10 * w3_pitch + k9 * w1_pitch;
    kept[381] = z540;
    const double z541 = z539 - (k9 * z525 + (z252 * z537 + w3_pitch * z540));
    const double z542 = z253 * z477 + z20 * z533 + (w1_pitch * v2_x - z252 * a1);
    const double z543 = z542 - (k10 * z525 - (w1_pitch * z540 + z252 * z536));
    const double z544 = c_lam * z541 - s_lam * z543;
    kept[382] = z544;
    const double z545 = c_steer * z538 + s_steer * z544;
    const double z546 = z452 * z252 - s_steer * z525 + (z444 * z526 - c_steer * z530);
    const double z547 = s_steer * z252 - c_steer * z526;
    kept[383] = z547;
    const double z548 = c_steer * z252 + s_steer * z526;
    kept[384] = z548;
    const double z549 = F_yy * (thF_dot - z548) - k47 * z548;
    kept[385] = z549;
    const double w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    kept[386] = w3_steer;
    const double z550 = k43 * z547 - k44 * w3_steer;
    kept[387] = z550;
    const double z551 = h2z * k64 - (k51 * z534 + (k36 * z545 + k50 * z546) + (z547 * z549 + z548 * z550));
    kept[388] = z551;
    const double z552 = c_steer * z544 - s_steer * z538;
    const double z553 = c_lam * z543 + s_lam * z541;
    const double z554 = k50 * z547 - k51 * w3_steer;
    kept[389] = z554;
    const double z555 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) + (k47 * z531 + (k33 * z552 - k36 * z553)
        - (w3_steer * z550 + z547 * z554));
    kept[390] = z555;
    const double z556 = h2z * k63 - (k44 * z534 - (k33 * z545 - k43 * z546) - (z548 * z554 - w3_steer *
        z549));
    kept[391] = z556;
    const double z557 = k33 * z547 + k36 * w3_steer;
    kept[392] = z557;
    const double z558 = k33 * z548;
    kept[393] = z558;
    const double z559 = z9 * k60 + (k31 * z553 - k36 * z531 - (z547 * z557 + z548 * z558));
    kept[394] = z559;
    const double z560 = k36 * z548;
    kept[395] = z560;
    const double z561 = h2z * k60 + (k36 * z534 + (k31 * z545 - k33 * z546) + (w3_steer * z558 - z547 *
        z560));
    kept[396] = z561;
    const double z562 = z8 * k60 + (k31 * z552 + k33 * z531 - (z548 * z560 + w3_steer * z557));
    kept[397] = z562;
    const double z563 = R_yy * z253 - k27 * z252;
    kept[398] = z563;
    const double z564 = k25 * w1_pitch + k28 * w3_pitch;
    kept[399] = z564;
    const double z565 = e2z * k56 + (k29 * z529 + (k23 * z535 - k28 * z528) - (w1_pitch * z563 + z252 *
        z564));
    kept[400] = z565;
    const double z566 = k28 * w1_pitch + k29 * w3_pitch;
    kept[401] = z566;
    const double z567 = z3 * k57 + e3z * k56 + (k27 * z525 + (k22 * z539 - k23 * z542) + (w3_pitch * z564 -
        w1_pitch * z566));
    kept[402] = z567;
    const double z568 = e2z * k57 - (k28 * z529 - (k22 * z535 + k25 * z528) + (z252 * z566 + w3_pitch *
        z563));
    kept[403] = z568;
    const double z569 = k22 * w1_pitch - k23 * w3_pitch;
    kept[404] = z569;
    const double z570 = k22 * z252;
    kept[405] = z570;
    const double z571 = e3z * k55 - (k21 * z542 - k23 * z525 - (w1_pitch * z569 + z252 * z570));
    kept[406] = z571;
    const double z572 = k23 * z252;
    kept[407] = z572;
    const double z573 = e2z * k55 + (k23 * z529 + (k21 * z535 + k22 * z528) + (w3_pitch * z570 + w1_pitch *
        z572));
    kept[408] = z573;
    const double z574 = z3 * k55 + (k21 * z539 + k22 * z525 - (z252 * z572 - w3_pitch * z569));
    kept[409] = z574;
    const double z575 = 1.0 / (z13 * z13);
    kept[410] = z575;
    const double z576 = 1.0 / (z4 * z4);
    kept[411] = z576;
    const double z577 = z175 * z565 + (z185 * z567 + (z176 * z568 - (z189 * z571 - (z187 * z574 - z178 *
        z573))));
    const double z578 = z177 * z551 - (z196 * z555 + (z194 * z556 + (z198 * z559 - (z192 * z561 - (z197 *
        z562 + z577)))));
    const double z579 = z82 * z565 + (z92 * z567 - (z83 * z568 + (z96 * z571 - (z94 * z574 + z85 * z573))));
    const double z580 = z84 * z551 - (z103 * z555 + (z101 * z556 + (z105 * z559 + (z99 * z561 + (z104 * z562
        + z579)))));
    const double z581 = z580 - R_yy * (z93 * z533) - F_yy * (z103 * z531);
    const double z582 = z126 * z565 - (z136 * z567 - (z127 * z568 + (z140 * z571 - (z138 * z574 + z129 *
        z573))));
    const double z583 = z128 * z551 - (z147 * z555 + (z145 * z556 + (z149 * z559 + (z143 * z561 + (z148 *
        z562 - z582)))));
    const double z584 = z583 - R_yy * (z137 * z533) - F_yy * (z147 * z531) - z581 * z168;
    const double z585 = z443 * (z578 - R_yy * (z186 * z533) - F_yy * (z212 * z531) - z581 * z217 - z222 *
        z584);
    kept[412] = z585;
    const double z586 = z221 * z584 - z222 * z585;
    kept[413] = z586;
    const double z587 = z581 * z167 - z168 * z586 - z217 * z585;
    kept[414] = z587;
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
    (void)y;
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
    const double z40 = kept[85];
    const double z43 = kept[88];
    const double z46 = kept[91];
    const double z47 = kept[92];
    const double z55 = kept[97];
    const double z60 = kept[102];
    const double z61 = kept[103];
    const double z62 = kept[104];
    const double z64 = kept[106];
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
    const double w1_pitch = kept[273];
    const double w3_pitch = kept[274];
    const double v2_x = kept[275];
    const double z267 = kept[278];
    const double z276 = kept[280];
    const double z443 = kept[302];
    const double z444 = kept[303];
    const double z446 = kept[305];
    const double z448 = kept[307];
    const double z452 = kept[310];
    const double z475 = kept[330];
    const double z477 = kept[332];
    const double z484 = kept[336];
    const double z490 = kept[340];
    const double z500 = kept[347];
    const double z504 = kept[350];
    const double z512 = kept[357];
    const double z516 = kept[360];
    const double z524 = kept[368];
    const double z531 = kept[375];
    const double z536 = kept[378];
    const double z537 = kept[379];
    const double z540 = kept[381];
    const double z547 = kept[383];
    const double z548 = kept[384];
    const double z549 = kept[385];
    const double w3_steer = kept[386];
    const double z550 = kept[387];
    const double z551 = kept[388];
    const double z554 = kept[389];
    const double z555 = kept[390];
    const double z556 = kept[391];
    const double z557 = kept[392];
    const double z558 = kept[393];
    const double z560 = kept[395];
    const double z561 = kept[396];
    const double z562 = kept[397];
    const double z563 = kept[398];
    const double z564 = kept[399];
    const double z565 = kept[400];
    const double z566 = kept[401];
    const double z568 = kept[403];
    const double z569 = kept[404];
    const double z570 = kept[405];
    const double z572 = kept[407];
    const double z573 = kept[408];
    const double z585 = kept[412];
    const double z586 = kept[413];
    const double z587 = kept[414];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z588 = row_1 - z168 * row_0;
    const bicycle_lanes z589 = z443 * (row_2 + z217 * row_0 + z222 * z588);
    bicycle_put(carried + 0 * BICYCLE_LANES, z589);
    const bicycle_lanes z590 = z221 * z588 + z222 * z589;
    bicycle_put(carried + 1 * BICYCLE_LANES, z590);
    const bicycle_lanes z591 = z167 * row_0 - z168 * z590 + z217 * z589;
    bicycle_put(carried + 2 * BICYCLE_LANES, z591);
    const bicycle_lanes z592 = z185 * z589 - z136 * z590 - z92 * z591;
    bicycle_put(carried + 3 * BICYCLE_LANES, z592);
    const bicycle_lanes z593 = z189 * z589 - z140 * z590 - z96 * z591;
    bicycle_put(carried + 4 * BICYCLE_LANES, z593);
    const bicycle_lanes z594 = z187 * z589 - z138 * z590 - z94 * z591;
    bicycle_put(carried + 5 * BICYCLE_LANES, z594);
    const bicycle_lanes z595 = z177 * z589 - z128 * z590 - z84 * z591;
    bicycle_put(carried + 6 * BICYCLE_LANES, z595);
    const bicycle_lanes z596 = z194 * z589 - z145 * z590 - z101 * z591;
    bicycle_put(carried + 7 * BICYCLE_LANES, z596);
    const bicycle_lanes z597 = z192 * z589 + z143 * z590 + z99 * z591;
    bicycle_put(carried + 8 * BICYCLE_LANES, z597);
    const bicycle_lanes z598 = k36 * z595 + k33 * z596 - k31 * z597;
    bicycle_put(carried + 9 * BICYCLE_LANES, z598);
    const bicycle_lanes z599 = z196 * z589 - z147 * z590 - z103 * z591;
    bicycle_put(carried + 10 * BICYCLE_LANES, z599);
    const bicycle_lanes z600 = z197 * z589 - z148 * z590 - z104 * z591;
    bicycle_put(carried + 11 * BICYCLE_LANES, z600);
    const bicycle_lanes z601 = k33 * z599 + k31 * z600;
    bicycle_put(carried + 12 * BICYCLE_LANES, z601);
    const bicycle_lanes z602 = s_steer * z598 + c_steer * z601;
    const bicycle_lanes z603 = z198 * z589 - z149 * z590 - z105 * z591;
    bicycle_put(carried + 13 * BICYCLE_LANES, z603);
    const bicycle_lanes z604 = k36 * z599 - k31 * z603;
    const bicycle_lanes z605 = s_lam * z602 + c_lam * z604;
    bicycle_put(carried + 14 * BICYCLE_LANES, z605);
    const bicycle_lanes z606 = c_lam * z602 - s_lam * z604;
    bicycle_put(carried + 15 * BICYCLE_LANES, z606);
    const bicycle_lanes z607 = F_yy * z589;
    const bicycle_lanes z608 = F_yy * z590;
    const bicycle_lanes z609 = F_yy * z591;
    const bicycle_lanes z610 = z212 * z607 - z147 * z608 - z103 * z609 + k47 * z599 - k36 * z603 + k33 * z600;
    bicycle_put(carried + 16 * BICYCLE_LANES, z610);
    const bicycle_lanes z611 = k27 * z592 - k23 * z593 + k22 * z594 + k10 * z605 - k9 * z606 + c_steer * z610;
    const bicycle_lanes z612 = k50 * z595 - k43 * z596 + k33 * z597;
    bicycle_put(carried + 17 * BICYCLE_LANES, z612);
    const bicycle_lanes z613 = R_yy * z589;
    bicycle_put(carried + 18 * BICYCLE_LANES, z613);
    const bicycle_lanes z614 = R_yy * z590;
    bicycle_put(carried + 19 * BICYCLE_LANES, z614);
    const bicycle_lanes z615 = R_yy * z591;
    bicycle_put(carried + 20 * BICYCLE_LANES, z615);
    const bicycle_lanes z616 = k23 * z592 - k21 * z593 + z605;
    bicycle_put(carried + 21 * BICYCLE_LANES, z616);
    const bicycle_lanes z617 = k22 * z592 + k21 * z594 + z606;
    bicycle_put(carried + 22 * BICYCLE_LANES, z617);
    const bicycle_lanes z618 = z186 * z613 - z137 * z614 - z93 * z615 - z20 * z616 + R3 * z617;
    bicycle_put(carried + 23 * BICYCLE_LANES, z618);
    const bicycle_lanes z619 = z611 - s_steer * z612 - z618;
    bicycle_put(carried + 24 * BICYCLE_LANES, z619);
    const bicycle_lanes z620 = z64 * z618;
    bicycle_put(carried + 25 * BICYCLE_LANES, z620);
    const bicycle_lanes z621 = z64 * z619;
    bicycle_put(carried + 26 * BICYCLE_LANES, z621);
    const bicycle_lanes z622 = z175 * z589 + z126 * z590 - z82 * z591;
    bicycle_put(carried + 27 * BICYCLE_LANES, z622);
    const bicycle_lanes z623 = z176 * z589 + z127 * z590 + z83 * z591;
    bicycle_put(carried + 28 * BICYCLE_LANES, z623);
    const bicycle_lanes z624 = z178 * z589 + z129 * z590 + z85 * z591;
    bicycle_put(carried + 29 * BICYCLE_LANES, z624);
    const bicycle_lanes z625 = c_steer * z598 - s_steer * z601;
    bicycle_put(carried + 30 * BICYCLE_LANES, z625);
    const bicycle_lanes z626 = s_steer * z610 + c_steer * z612;
    const bicycle_lanes z627 = k51 * z595 - k44 * z596 - k36 * z597;
    const bicycle_lanes z628 = k29 * z622 - k28 * z623 - k23 * z624 + k10 * z625 - s_lam * z626 + c_lam *
        z627;
    const bicycle_lanes z629 = k23 * z622 + k22 * z623 - k21 * z624 + z625;
    bicycle_put(carried + 31 * BICYCLE_LANES, z629);
    const bicycle_lanes z630 = z628 + z20 * z629;
    bicycle_put(carried + 32 * BICYCLE_LANES, z630);
    const bicycle_lanes z631 = k28 * z622 - k25 * z623 + k22 * z624 + k9 * z625 + c_lam * z626 + s_lam * z627;
    const bicycle_lanes z632 = z631 + R3 * z629;
    bicycle_put(carried + 33 * BICYCLE_LANES, z632);
    const bicycle_lanes z633 = c_pitch * z630 - s_pitch * z632;
    bicycle_put(carried + 34 * BICYCLE_LANES, z633);
    const bicycle_lanes z634 = c_roll * z633 - e2z * z619;
    bicycle_put(carried + 35 * BICYCLE_LANES, z634);
    const bicycle_lanes z635 = z64 * z634;
    bicycle_put(carried + 36 * BICYCLE_LANES, z635);
    const bicycle_lanes z636 = z62 * z620 + z61 * z621 - z47 * z635;
    bicycle_put(carried + 37 * BICYCLE_LANES, z636);
    const bicycle_lanes z637 = z250 * z636;
    bicycle_put(carried + 38 * BICYCLE_LANES, z637);
    const bicycle_lanes z638 = z29 * z620 + z27 * z621;
    bicycle_put(carried + 39 * BICYCLE_LANES, z638);
    const bicycle_lanes z639 = z30 * z620 + z27 * z635;
    bicycle_put(carried + 40 * BICYCLE_LANES, z639);
    const bicycle_lanes z640 = z30 * z621 - z29 * z635;
    bicycle_put(carried + 41 * BICYCLE_LANES, z640);
    const bicycle_lanes z641 = z60 * z638 + z46 * z639 + z34 * z640;
    bicycle_put(carried + 42 * BICYCLE_LANES, z641);
    const bicycle_lanes z642 = z250 * z641;
    bicycle_put(carried + 43 * BICYCLE_LANES, z642);
    const bicycle_lanes z643 = z55 * z638 - z43 * z639 - z38 * z640;
    bicycle_put(carried + 44 * BICYCLE_LANES, z643);
    const bicycle_lanes z644 = z250 * z643;
    bicycle_put(carried + 45 * BICYCLE_LANES, z644);
    const bicycle_lanes z645 = z248 * z641 + e2z * z642;
    bicycle_put(carried + 46 * BICYCLE_LANES, z645);
    const bicycle_lanes z646 = c_roll * z642;
    bicycle_put(carried + 47 * BICYCLE_LANES, z646);
    const bicycle_lanes z647 = s_pitch * z646;
    bicycle_put(carried + 48 * BICYCLE_LANES, z647);
    const bicycle_lanes z648 = c_pitch * z646;
    bicycle_put(carried + 49 * BICYCLE_LANES, z648);
    const bicycle_lanes z649 = c_lam * z647 + s_lam * z648;
    bicycle_put(carried + 50 * BICYCLE_LANES, z649);
    const bicycle_lanes z650 = s_steer * z645 - c_steer * z649;
    const bicycle_lanes z651 = c_lam * z648 - s_lam * z647;
    const bicycle_lanes z652 = z248 * z643 + e2z * z644;
    bicycle_put(carried + 51 * BICYCLE_LANES, z652);
    const bicycle_lanes z653 = c_roll * z644;
    bicycle_put(carried + 52 * BICYCLE_LANES, z653);
    const bicycle_lanes z654 = s_pitch * z653;
    bicycle_put(carried + 53 * BICYCLE_LANES, z654);
    const bicycle_lanes z655 = c_pitch * z653;
    bicycle_put(carried + 54 * BICYCLE_LANES, z655);
    const bicycle_lanes z656 = c_lam * z654 + s_lam * z655;
    bicycle_put(carried + 55 * BICYCLE_LANES, z656);
    const bicycle_lanes z657 = z237 * z643 + z230 * z641 - c_lam * z650 - s_lam * z651 - c_steer * z652 -
        s_steer * z656;
    bicycle_put(carried + 56 * BICYCLE_LANES, z657);
    const bicycle_lanes z658 = z248 * z636 + e2z * z637;
    bicycle_put(carried + 57 * BICYCLE_LANES, z658);
    const bicycle_lanes z659 = c_roll * z637;
    bicycle_put(carried + 58 * BICYCLE_LANES, z659);
    const bicycle_lanes z660 = s_pitch * z659;
    bicycle_put(carried + 59 * BICYCLE_LANES, z660);
    const bicycle_lanes z661 = c_pitch * z659;
    bicycle_put(carried + 60 * BICYCLE_LANES, z661);
    const bicycle_lanes z662 = c_lam * z660 + s_lam * z661;
    bicycle_put(carried + 61 * BICYCLE_LANES, z662);
    const bicycle_lanes z663 = z231 * z641 - z237 * z636 + c_steer * z658 + s_steer * z662 - c_lam * z651 +
        s_lam * z650;
    bicycle_put(carried + 62 * BICYCLE_LANES, z663);
    const bicycle_lanes z664 = z39 * z657 - z11 * z663;
    bicycle_put(carried + 63 * BICYCLE_LANES, z664);
    const bicycle_lanes z665 = z276 * z664;
    bicycle_put(carried + 64 * BICYCLE_LANES, z665);
    const bicycle_lanes z666 = z14 * z665;
    bicycle_put(carried + 65 * BICYCLE_LANES, z666);
    const bicycle_lanes z667 = z12 * z666 - r_F * (z14 * z657);
    const bicycle_lanes z668 = z10 * z666 + r_F * (z14 * z663);
    const bicycle_lanes z669 = s_lam * z667 - c_lam * z668;
    bicycle_put(carried + 66 * BICYCLE_LANES, z669);
    const bicycle_lanes z670 = z250 * z619 + z29 * z637 - z43 * z642 - z46 * z644 - s_steer * z669;
    bicycle_put(carried + 67 * BICYCLE_LANES, z670);
    const bicycle_lanes z671 = w1_pitch * z629;
    const bicycle_lanes z672 = c_lam * z643 + s_lam * z636;
    bicycle_put(carried + 68 * BICYCLE_LANES, z672);
    const bicycle_lanes z673 = c_steer * z641 - s_steer * z672;
    bicycle_put(carried + 69 * BICYCLE_LANES, z673);
    const bicycle_lanes z674 = z245 * z636 - z658;
    bicycle_put(carried + 70 * BICYCLE_LANES, z674);
    const bicycle_lanes z675 = z245 * z643 - z652;
    bicycle_put(carried + 71 * BICYCLE_LANES, z675);
    const bicycle_lanes z676 = z671 + z253 * z617 + z224 * z673 - z26 * z674 - z1 * z660 + c_steer * z647 +
        z33 * z675;
    const bicycle_lanes z677 = z245 * z641 - z645;
    bicycle_put(carried + 72 * BICYCLE_LANES, z677);
    const bicycle_lanes z678 = z677 - z654;
    bicycle_put(carried + 73 * BICYCLE_LANES, z678);
    const bicycle_lanes z679 = z676 + z35 * z678;
    bicycle_put(carried + 74 * BICYCLE_LANES, z679);
    const bicycle_lanes z680 = w3_pitch * z629;
    const bicycle_lanes z681 = z661 - z677;
    bicycle_put(carried + 75 * BICYCLE_LANES, z681);
    const bicycle_lanes z682 = z680 - z253 * z616 + z225 * z673 - z25 * z674 + z1 * z681 - c_steer * z648 +
        z32 * z675;
    const bicycle_lanes z683 = z682 + z35 * z655;
    bicycle_put(carried + 76 * BICYCLE_LANES, z683);
    const bicycle_lanes z684 = z2 * z679 + z19 * z683;
    bicycle_put(carried + 77 * BICYCLE_LANES, z684);
    const bicycle_lanes z685 = z267 * z684;
    bicycle_put(carried + 78 * BICYCLE_LANES, z685);
    const bicycle_lanes z686 = z5 * z685;
    bicycle_put(carried + 79 * BICYCLE_LANES, z686);
    const bicycle_lanes z687 = c_steer * z669;
    const bicycle_lanes z688 = c_lam * z667 + s_lam * z668;
    const bicycle_lanes z689 = e3z * z686 - r_R * (z5 * z679) - s_lam * z687 - c_lam * z688;
    bicycle_put(carried + 80 * BICYCLE_LANES, z689);
    const bicycle_lanes z690 = z3 * z686 - r_R * (z5 * z683) - c_lam * z687 + s_lam * z688;
    bicycle_put(carried + 81 * BICYCLE_LANES, z690);
    const bicycle_lanes z691 = z524 * z633 + z516 * z637 - z490 * z642 + z504 * z644 - z448 * z689 + z446 *
        z690;
    bicycle_put(carried + 82 * BICYCLE_LANES, z691);
    const bicycle_lanes z692 = w1_pitch * z592 + z252 * z623;
    const bicycle_lanes z693 = z252 * z622 - w3_pitch * z592;
    const bicycle_lanes z694 = z570 * z624 - z569 * z594 - z564 * z592 + z563 * z623 + k29 * z692 + k28 *
        z693;
    const bicycle_lanes z695 = w1_pitch * z593 - w3_pitch * z594;
    const bicycle_lanes z696 = z694 - k23 * z695 + z536 * z625 + z540 * z606 - a1 * z629 + v2_x * z617 - z477
        * z629;
    const bicycle_lanes z697 = w1_pitch * z605 + w3_pitch * z606;
    const bicycle_lanes z698 = z547 * z595 - w3_steer * z596;
    const bicycle_lanes z699 = z558 * z603 + z560 * z600 - z550 * z595 - z554 * z596 + k47 * z698 - k36 *
        (z547 * z597 - z548 * z600);
    const bicycle_lanes z700 = F_yy * z698;
    bicycle_put(carried + 83 * BICYCLE_LANES, z700);
    const bicycle_lanes z701 = z699 + k33 * (z548 * z603 + w3_steer * z597) + z700;
    bicycle_put(carried + 84 * BICYCLE_LANES, z701);
    const bicycle_lanes z702 = z547 * z599 - z548 * z596;
    const bicycle_lanes z703 = z548 * z595 - w3_steer * z599;
    const bicycle_lanes z704 = z557 * z603 - z560 * z597 - z549 * z595 + z554 * z599 + k50 * z702 - k43 *
        z703;
    const bicycle_lanes z705 = z547 * z603 + w3_steer * z600;
    const bicycle_lanes z706 = z704 + k33 * z705;
    bicycle_put(carried + 85 * BICYCLE_LANES, z706);
    const bicycle_lanes z707 = z452 * z610 - z444 * z612 + s_steer * z701 - c_steer * z706;
    const bicycle_lanes z708 = z558 * z597 + z557 * z600 + z550 * z599 + z549 * z596 - k51 * z702 + k44 *
        z703;
    const bicycle_lanes z709 = z708 + k36 * z705;
    bicycle_put(carried + 86 * BICYCLE_LANES, z709);
    const bicycle_lanes z710 = w1_pitch * z616 + w3_pitch * z617;
    bicycle_put(carried + 87 * BICYCLE_LANES, z710);
    const bicycle_lanes z711 = z696 + k10 * z697 - s_lam * z707 + c_lam * z709 + z20 * z710;
    bicycle_put(carried + 88 * BICYCLE_LANES, z711);
    const bicycle_lanes z712 = z569 * z593 + z572 * z624 + z563 * z622 + z566 * z592 + k28 * z692 + k25 *
        z693;
    const bicycle_lanes z713 = z712 + k22 * z695 + z540 * z605 - z537 * z625 + v2_x * z616 + a3 * z629 - z475
        * z629;
    const bicycle_lanes z714 = z713 + k9 * z697 + c_lam * z707 + s_lam * z709 + R3 * z710;
    bicycle_put(carried + 89 * BICYCLE_LANES, z714);
    const bicycle_lanes z715 = z448 * z630 + z446 * z632 + c_pitch * z711 - s_pitch * z714;
    bicycle_put(carried + 90 * BICYCLE_LANES, z715);
    const bicycle_lanes z716 = z585 * z589;
    bicycle_put(carried + 91 * BICYCLE_LANES, z716);
    const bicycle_lanes z717 = z175 * z716;
    const bicycle_lanes z718 = z176 * z716;
    const bicycle_lanes z719 = z178 * z716;
    const bicycle_lanes z720 = z586 * z589 - z585 * z590;
    bicycle_put(carried + 92 * BICYCLE_LANES, z720);
    const bicycle_lanes z721 = z565 * z589 + z204 * z716 + k29 * z717 - k28 * z718 - k23 * z719 - z155 * z720;
    const bicycle_lanes z722 = z587 * z589 - z585 * z591;
    bicycle_put(carried + 93 * BICYCLE_LANES, z722);
    const bicycle_lanes z723 = z177 * z716;
    const bicycle_lanes z724 = z194 * z716;
    const bicycle_lanes z725 = z192 * z716;
    const bicycle_lanes z726 = z551 * z589 - z195 * z716 - k51 * z723 + k44 * z724 + k36 * z725 - z146 * z720;
    const bicycle_lanes z727 = z726 - z102 * z722;
    const bicycle_lanes z728 = F_yy * z720;
    const bicycle_lanes z729 = F_yy * z722;
    const bicycle_lanes z730 = z196 * z716;
    bicycle_put(carried + 94 * BICYCLE_LANES, z730);
    const bicycle_lanes z731 = z198 * z716;
    bicycle_put(carried + 95 * BICYCLE_LANES, z731);
    const bicycle_lanes z732 = z197 * z716;
    const bicycle_lanes z733 = z555 * z589 + z199 * z716 + k47 * z730 - k36 * z731 + k33 * z732 + z150 * z720;
    const bicycle_lanes z734 = z531 * z607 + 2.0 * (z212 * (F_yy * z716)) + z147 * z728 + z103 * z729 + (z733
        + z106 * z722);
    bicycle_put(carried + 96 * BICYCLE_LANES, z734);
    const bicycle_lanes z735 = z556 * z589 - z200 * z716 - k50 * z723 + k43 * z724 - k33 * z725 - z151 * z720;
    const bicycle_lanes z736 = z735 - z107 * z722;
    bicycle_put(carried + 97 * BICYCLE_LANES, z736);
    const bicycle_lanes z737 = s_steer * z734 - c_steer * z736;
    const bicycle_lanes z738 = z561 * z589 + z202 * z716 + k36 * z723 + k33 * z724 - k31 * z725 + z153 * z720;
    const bicycle_lanes z739 = z738 + z109 * z722;
    bicycle_put(carried + 98 * BICYCLE_LANES, z739);
    const bicycle_lanes z740 = z562 * z589 + z203 * z716 + k33 * z730 + k31 * z732 + z154 * z720 + z110 *
        z722;
    bicycle_put(carried + 99 * BICYCLE_LANES, z740);
    const bicycle_lanes z741 = c_steer * z739 - s_steer * z740;
    const bicycle_lanes z742 = z573 * z589 + z209 * z716 + k23 * z717 + k22 * z718 - k21 * z719 - z160 * z720;
    const bicycle_lanes z743 = z742 + z116 * z722 + z741;
    bicycle_put(carried + 100 * BICYCLE_LANES, z743);
    const bicycle_lanes z744 = z721 + z111 * z722 - c_lam * z727 - s_lam * z737 + k10 * z741 + z20 * z743;
    bicycle_put(carried + 101 * BICYCLE_LANES, z744);
    const bicycle_lanes z745 = z568 * z589 - z206 * z716 - k28 * z717 + k25 * z718 - k22 * z719 + z157 * z720;
    const bicycle_lanes z746 = z745 - z113 * z722 + s_lam * z727 - c_lam * z737 - k9 * z741 - R3 * z743;
    bicycle_put(carried + 102 * BICYCLE_LANES, z746);
    const bicycle_lanes z747 = c_pitch * z744 + s_pitch * z746;
    bicycle_put(carried + 103 * BICYCLE_LANES, z747);
    const bicycle_lanes z748 = z586 * z590;
    bicycle_put(carried + 104 * BICYCLE_LANES, z748);
    const bicycle_lanes z749 = z175 * z720 + z126 * z748;
    const bicycle_lanes z750 = z176 * z720 + z127 * z748;
    const bicycle_lanes z751 = z178 * z720 + z129 * z748;
    const bicycle_lanes z752 = z587 * z590 + z586 * z591;
    bicycle_put(carried + 105 * BICYCLE_LANES, z752);
    const bicycle_lanes z753 = z565 * z590 - z155 * z748 - k29 * z749 + k28 * z750 + k23 * z751 + z111 * z752;
    const bicycle_lanes z754 = z177 * z720 - z128 * z748;
    const bicycle_lanes z755 = z194 * z720 - z145 * z748;
    const bicycle_lanes z756 = z192 * z720 + z143 * z748;
    const bicycle_lanes z757 = z551 * z590 - z146 * z748 + k51 * z754 - k44 * z755 - k36 * z756 - z102 * z752;
    const bicycle_lanes z758 = z531 * z608 + z555 * z590 - z212 * z728 + 2.0 * (z147 * (F_yy * z748)) + z150
        * z748;
    const bicycle_lanes z759 = z196 * z720 - z147 * z748;
    bicycle_put(carried + 106 * BICYCLE_LANES, z759);
    const bicycle_lanes z760 = z198 * z720 - z149 * z748;
    bicycle_put(carried + 107 * BICYCLE_LANES, z760);
    const bicycle_lanes z761 = z197 * z720 - z148 * z748;
    const bicycle_lanes z762 = F_yy * z752;
    const bicycle_lanes z763 = z758 - k47 * z759 + k36 * z760 - k33 * z761 + z103 * z762 + z106 * z752;
    bicycle_put(carried + 108 * BICYCLE_LANES, z763);
    const bicycle_lanes z764 = z556 * z590 - z151 * z748 + k50 * z754 - k43 * z755 + k33 * z756 - z107 * z752;
    bicycle_put(carried + 109 * BICYCLE_LANES, z764);
    const bicycle_lanes z765 = s_steer * z763 - c_steer * z764;
    const bicycle_lanes z766 = z561 * z590 + z153 * z748 - k36 * z754 - k33 * z755 + k31 * z756 + z109 * z752;
    bicycle_put(carried + 110 * BICYCLE_LANES, z766);
    const bicycle_lanes z767 = z562 * z590 + z154 * z748 - k33 * z759 - k31 * z761 + z110 * z752;
    bicycle_put(carried + 111 * BICYCLE_LANES, z767);
    const bicycle_lanes z768 = c_steer * z766 - s_steer * z767;
    const bicycle_lanes z769 = z573 * z590 - z160 * z748 - k23 * z749 - k22 * z750 + k21 * z751 + z116 * z752;
    const bicycle_lanes z770 = z769 + z768;
    bicycle_put(carried + 112 * BICYCLE_LANES, z770);
    const bicycle_lanes z771 = z753 - c_lam * z757 - s_lam * z765 + k10 * z768 + z20 * z770;
    bicycle_put(carried + 113 * BICYCLE_LANES, z771);
    const bicycle_lanes z772 = z568 * z590 + z157 * z748 + k28 * z749 - k25 * z750 + k22 * z751 - z113 * z752;
    const bicycle_lanes z773 = z772 + s_lam * z757 - c_lam * z765 - k9 * z768 - R3 * z770;
    bicycle_put(carried + 114 * BICYCLE_LANES, z773);
    const bicycle_lanes z774 = c_pitch * z771 + s_pitch * z773;
    bicycle_put(carried + 115 * BICYCLE_LANES, z774);
    const bicycle_lanes z775 = z587 * z591;
    bicycle_put(carried + 116 * BICYCLE_LANES, z775);
    const bicycle_lanes z776 = z175 * z722 + z126 * z752 - z82 * z775;
    const bicycle_lanes z777 = z176 * z722 + z127 * z752 + z83 * z775;
    const bicycle_lanes z778 = z178 * z722 + z129 * z752 + z85 * z775;
    const bicycle_lanes z779 = z177 * z722 - z128 * z752 - z84 * z775;
    const bicycle_lanes z780 = z194 * z722 - z145 * z752 - z101 * z775;
    const bicycle_lanes z781 = z192 * z722 + z143 * z752 + z99 * z775;
    const bicycle_lanes z782 = z551 * z591 - z102 * z775 + k51 * z779 - k44 * z780 - k36 * z781;
    const bicycle_lanes z783 = z565 * z591 + z111 * z775 - k29 * z776 + k28 * z777 + k23 * z778 - c_lam *
        z782;
    const bicycle_lanes z784 = z531 * z609 + z555 * z591 - z212 * z729 + z147 * z762 + 2.0 * (z103 * (F_yy *
        z775));
    const bicycle_lanes z785 = z196 * z722 - z147 * z752 - z103 * z775;
    bicycle_put(carried + 117 * BICYCLE_LANES, z785);
    const bicycle_lanes z786 = z198 * z722 - z149 * z752 - z105 * z775;
    bicycle_put(carried + 118 * BICYCLE_LANES, z786);
    const bicycle_lanes z787 = z197 * z722 - z148 * z752 - z104 * z775;
    const bicycle_lanes z788 = z784 + z106 * z775 - k47 * z785 + k36 * z786 - k33 * z787;
    bicycle_put(carried + 119 * BICYCLE_LANES, z788);
    const bicycle_lanes z789 = z556 * z591 - z107 * z775 + k50 * z779 - k43 * z780 + k33 * z781;
    bicycle_put(carried + 120 * BICYCLE_LANES, z789);
    const bicycle_lanes z790 = s_steer * z788 - c_steer * z789;
    const bicycle_lanes z791 = z561 * z591 + z109 * z775 - k36 * z779 - k33 * z780 + k31 * z781;
    bicycle_put(carried + 121 * BICYCLE_LANES, z791);
    const bicycle_lanes z792 = z562 * z591 + z110 * z775 - k33 * z785 - k31 * z787;
    bicycle_put(carried + 122 * BICYCLE_LANES, z792);
    const bicycle_lanes z793 = c_steer * z791 - s_steer * z792;
    const bicycle_lanes z794 = z573 * z591 + z116 * z775 - k23 * z776 - k22 * z777 + k21 * z778 + z793;
    bicycle_put(carried + 123 * BICYCLE_LANES, z794);
    const bicycle_lanes z795 = z783 - s_lam * z790 + k10 * z793 + z20 * z794;
    bicycle_put(carried + 124 * BICYCLE_LANES, z795);
    const bicycle_lanes z796 = z568 * z591 - z113 * z775 + k28 * z776 - k25 * z777 + k22 * z778 + s_lam *
        z782;
    const bicycle_lanes z797 = z796 - c_lam * z790 - k9 * z793 - R3 * z794;
    bicycle_put(carried + 125 * BICYCLE_LANES, z797);
    const bicycle_lanes z798 = c_pitch * z795 + s_pitch * z797;
    bicycle_put(carried + 126 * BICYCLE_LANES, z798);
    const bicycle_lanes z799 = w1_pitch * z622 + w3_pitch * z623;
    bicycle_put(carried + 127 * BICYCLE_LANES, z799);
    const bicycle_lanes z800 = z671 - z252 * z617;
    bicycle_put(carried + 128 * BICYCLE_LANES, z800);
    const bicycle_lanes z801 = z252 * z616 + z680;
    bicycle_put(carried + 129 * BICYCLE_LANES, z801);
    const bicycle_lanes z802 = R_yy * z799 + z477 * z616 - z475 * z617 + z20 * z800 - R3 * z801;
    bicycle_put(carried + 130 * BICYCLE_LANES, z802);
    const bicycle_lanes z803 = z500 * z643 + z484 * z641 + z512 * z636 + z802;
    bicycle_put(carried + 131 * BICYCLE_LANES, z803);
    const bicycle_lanes z804 = z64 * z803;
    bicycle_put(carried + 132 * BICYCLE_LANES, z804);
    const bicycle_lanes z805 = z15 * z641;
    bicycle_put(carried + 133 * BICYCLE_LANES, z805);
    const bicycle_lanes z806 = z40 * z641;
    bicycle_put(carried + 134 * BICYCLE_LANES, z806);
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
    const double z444 = kept[303];
    const double z445 = kept[304];
    const double z446 = kept[305];
    const double z447 = kept[306];
    const double z448 = kept[307];
    const double z449 = kept[308];
    const double z451 = kept[309];
    const double z452 = kept[310];
    const double z453 = kept[311];
    const double z455 = kept[312];
    const double z456 = kept[313];
    const double z457 = kept[314];
    const double z458 = kept[315];
    const double z459 = kept[316];
    const double z460 = kept[317];
    const double z461 = kept[318];
    const double z462 = kept[319];
    const double z463 = kept[320];
    const double z465 = kept[321];
    const double z467 = kept[322];
    const double z468 = kept[323];
    const double z469 = kept[324];
    const double z470 = kept[325];
    const double z471 = kept[326];
    const double z472 = kept[327];
    const double z473 = kept[328];
    const double z474 = kept[329];
    const double z475 = kept[330];
    const double z476 = kept[331];
    const double z477 = kept[332];
    const double z478 = kept[333];
    const double z480 = kept[334];
    const double z482 = kept[335];
    const double z485 = kept[337];
    const double z488 = kept[338];
    const double z489 = kept[339];
    const double z491 = kept[341];
    const double z492 = kept[342];
    const double z493 = kept[343];
    const double z494 = kept[344];
    const double z498 = kept[345];
    const double z499 = kept[346];
    const double z502 = kept[348];
    const double z503 = kept[349];
    const double z505 = kept[351];
    const double z506 = kept[352];
    const double z507 = kept[353];
    const double z508 = kept[354];
    const double z510 = kept[355];
    const double z511 = kept[356];
    const double z514 = kept[358];
    const double z515 = kept[359];
    const double z517 = kept[361];
    const double z518 = kept[362];
    const double z519 = kept[363];
    const double z520 = kept[364];
    const double z521 = kept[365];
    const double z522 = kept[366];
    const double z523 = kept[367];
    const double z524 = kept[368];
    const double z525 = kept[369];
    const double z526 = kept[370];
    const double z527 = kept[371];
    const double z528 = kept[372];
    const double z529 = kept[373];
    const double z530 = kept[374];
    const double z532 = kept[376];
    const double z533 = kept[377];
    const double z536 = kept[378];
    const double z537 = kept[379];
    const double z538 = kept[380];
    const double z544 = kept[382];
    const double z559 = kept[394];
    const double z564 = kept[399];
    const double z566 = kept[401];
    const double z567 = kept[402];
    const double z570 = kept[405];
    const double z571 = kept[406];
    const double z572 = kept[407];
    const double z574 = kept[409];
    const double z575 = kept[410];
    const double z576 = kept[411];
    const bicycle_lanes z589 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z590 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z591 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z592 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z593 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z594 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z595 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z596 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z597 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z598 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z599 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z600 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z601 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z603 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z605 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z606 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z610 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z612 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z613 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z614 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z615 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z616 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z617 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z618 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z619 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z620 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z621 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z622 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z623 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z624 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z625 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z629 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z630 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z632 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z633 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z634 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z635 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z636 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z637 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z638 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z639 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z640 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z641 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z642 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z643 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z644 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z645 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z646 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z647 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z648 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z649 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z652 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z653 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z654 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z655 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z656 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z657 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z658 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z659 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z660 = bicycle_get(carried + 59 * BICYCLE_LANES);
    const bicycle_lanes z661 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z662 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z663 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z664 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z665 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z666 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z669 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z670 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z672 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z673 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z674 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z675 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z677 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z678 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z679 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z681 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z683 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z684 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z685 = bicycle_get(carried + 78 * BICYCLE_LANES);
    const bicycle_lanes z686 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z689 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z690 = bicycle_get(carried + 81 * BICYCLE_LANES);
    const bicycle_lanes z691 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z700 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z701 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z706 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z709 = bicycle_get(carried + 86 * BICYCLE_LANES);
    const bicycle_lanes z710 = bicycle_get(carried + 87 * BICYCLE_LANES);
    const bicycle_lanes z711 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z714 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z715 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z716 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z720 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z722 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z730 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z731 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z734 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z736 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z739 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z740 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z743 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z744 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z746 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z747 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z748 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z752 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z759 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z760 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z763 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z764 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z766 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z767 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z770 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z771 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z773 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z774 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z775 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z785 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z786 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z788 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z789 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z791 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z792 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z794 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z795 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z797 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z798 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z799 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z800 = bicycle_get(carried + 128 * BICYCLE_LANES);
    const bicycle_lanes z801 = bicycle_get(carried + 129 * BICYCLE_LANES);
    const bicycle_lanes z802 = bicycle_get(carried + 130 * BICYCLE_LANES);
    const bicycle_lanes z803 = bicycle_get(carried + 131 * BICYCLE_LANES);
    const bicycle_lanes z804 = bicycle_get(carried + 132 * BICYCLE_LANES);
    const bicycle_lanes z805 = bicycle_get(carried + 133 * BICYCLE_LANES);
    const bicycle_lanes z806 = bicycle_get(carried + 134 * BICYCLE_LANES);
    const bicycle_lanes z807 = c_lam * z805 - s_lam * z806 - k3 * z641;
    const bicycle_lanes z808 = s_lam * z805 + c_lam * z806 - k12 * z641;
    const bicycle_lanes z809 = z40 * z643 + z15 * z636 + k3 * (s_lam * z643 - c_lam * z636) - k12 * z672;
    const bicycle_lanes z810 = c_steer * z808 - s_steer * z809;
    const bicycle_lanes z811 = z630 - c_lam * z807 - s_lam * z810 + z20 * z673 + k10 * z673;
    const bicycle_lanes z812 = z261 * z632 - z18 * z659 + z52 * z646 - z57 * z653 + roll_dot * z811 - c_roll
        * z690;
    const bicycle_lanes z813 = z632 - s_lam * z807 + c_lam * z810 + R3 * z673 + k9 * z673;
    const bicycle_lanes z814 = z261 * z630 - z22 * z659 + z53 * z646 - z58 * z653 - roll_dot * z813 + c_roll
        * z689;
    const bicycle_lanes z815 = z570 * z593 + z572 * z594 + z564 * z622 + z566 * z623 - k27 * z799 + k23 *
        (w1_pitch * z624 + z252 * z594);
    const bicycle_lanes z816 = z815 + k22 * (z252 * z593 + w3_pitch * z624) + z536 * z605 + z537 * z606 - a1
        * z616;
    const bicycle_lanes z817 = z816 - a3 * z617 - z444 * z610 - z452 * z612 - k10 * (w1_pitch * z625 - z252 *
        z606);
    const bicycle_lanes z818 = z817 + k9 * (z252 * z605 + w3_pitch * z625) + c_steer * z701 + s_steer * z706
        - z802;
    const bicycle_lanes z819 = z505 * z643 + z491 * z641 + z517 * z636 + c_pitch * z812 + s_pitch * z814 -
        z818;
    const bicycle_lanes z820 = z64 * z819;
    const bicycle_lanes z821 = R_yy * z720;
    const bicycle_lanes z822 = R_yy * z722;
    const bicycle_lanes z823 = z185 * z716;
    const bicycle_lanes z824 = z189 * z716;
    const bicycle_lanes z825 = z571 * z589 - z207 * z716 + k23 * z823 - k21 * z824 - z158 * z720 - z114 *
        z722;
    const bicycle_lanes z826 = z559 * z589 + z201 * z716 - k36 * z730 + k31 * z731 + z152 * z720 + z108 *
        z722;
    const bicycle_lanes z827 = s_steer * z739 + c_steer * z740;
    const bicycle_lanes z828 = c_lam * z826 - s_lam * z827;
    const bicycle_lanes z829 = z825 - z828;
    const bicycle_lanes z830 = z533 * z613 + 2.0 * (z186 * (R_yy * z716)) + z137 * z821 + z93 * z822 - z20 *
        z829;
    const bicycle_lanes z831 = z187 * z716;
    const bicycle_lanes z832 = z574 * z589 + z208 * z716 + k22 * z823 + k21 * z831 + z159 * z720 + z115 *
        z722;
    const bicycle_lanes z833 = s_lam * z826 + c_lam * z827;
    const bicycle_lanes z834 = z832 + z833;
    const bicycle_lanes z835 = z830 + R3 * z834;
    const bicycle_lanes z836 = z64 * z835;
    const bicycle_lanes z837 = z567 * z589 + z205 * z716 + k27 * z823 - k23 * z824 + k22 * z831 + z156 * z720;
    const bicycle_lanes z838 = z837 + z112 * z722 + c_steer * z734 + s_steer * z736 - k10 * z828 - k9 * z833
        - z835;
    const bicycle_lanes z839 = z64 * z838;
    const bicycle_lanes z840 = z522 * z620 + z508 * z621 - z241 * z804 + z246 * z820 + z171 * z836 + z170 *
        z839;
    const bicycle_lanes z841 = R_yy * z752;
    const bicycle_lanes z842 = z185 * z720 - z136 * z748;
    const bicycle_lanes z843 = z189 * z720 - z140 * z748;
    const bicycle_lanes z844 = z559 * z590 + z152 * z748 + k36 * z759 - k31 * z760 + z108 * z752;
    const bicycle_lanes z845 = s_steer * z766 + c_steer * z767;
    const bicycle_lanes z846 = c_lam * z844 - s_lam * z845;
    const bicycle_lanes z847 = z571 * z590 - z158 * z748 - k23 * z842 + k21 * z843 - z114 * z752 - z846;
    const bicycle_lanes z848 = z533 * z614 - z186 * z821 + 2.0 * (z137 * (R_yy * z748)) + z93 * z841 - z20 *
        z847;
    const bicycle_lanes z849 = z187 * z720 - z138 * z748;
    const bicycle_lanes z850 = s_lam * z844 + c_lam * z845;
    const bicycle_lanes z851 = z574 * z590 + z159 * z748 - k22 * z842 - k21 * z849 + z115 * z752 + z850;
    const bicycle_lanes z852 = z848 + R3 * z851;
    const bicycle_lanes z853 = z64 * z852;
    const bicycle_lanes z854 = z567 * z590 + z156 * z748 - k27 * z842 + k23 * z843 - k22 * z849 + z112 * z752;
    const bicycle_lanes z855 = z854 + c_steer * z763 + s_steer * z764 - k10 * z846 - k9 * z850 - z852;
    const bicycle_lanes z856 = z64 * z855;
    const bicycle_lanes z857 = z185 * z722 - z136 * z752 - z92 * z775;
    const bicycle_lanes z858 = z189 * z722 - z140 * z752 - z96 * z775;
    const bicycle_lanes z859 = z559 * z591 + z108 * z775 + k36 * z785 - k31 * z786;
    const bicycle_lanes z860 = s_steer * z791 + c_steer * z792;
    const bicycle_lanes z861 = c_lam * z859 - s_lam * z860;
    const bicycle_lanes z862 = z571 * z591 - z114 * z775 - k23 * z857 + k21 * z858 - z861;
    const bicycle_lanes z863 = z533 * z615 - z186 * z822 + z137 * z841 + 2.0 * (z93 * (R_yy * z775)) - z20 *
        z862;
    const bicycle_lanes z864 = z187 * z722 - z138 * z752 - z94 * z775;
    const bicycle_lanes z865 = s_lam * z859 + c_lam * z860;
    const bicycle_lanes z866 = z574 * z591 + z115 * z775 - k22 * z857 - k21 * z864 + z865;
    const bicycle_lanes z867 = z863 + R3 * z866;
    const bicycle_lanes z868 = z64 * z867;
    const bicycle_lanes z869 = z567 * z591 + z112 * z775 - k27 * z857 + k23 * z858 - k22 * z864 + c_steer *
        z788;
    const bicycle_lanes z870 = z869 + s_steer * z789 - k10 * z861 - k9 * z865 - z867;
    const bicycle_lanes z871 = z64 * z870;
    const bicycle_lanes z872 = z445 * z633 + z451 * z619 + z506 * z643 - z492 * z641 + z518 * z636 - c_roll *
        z715;
    const bicycle_lanes z873 = z872 + e2z * z818;
    const bicycle_lanes z874 = z532 * z618 + z521 * z619 - z523 * z634 - z244 * z803 + z247 * z819 - z249 *
        z873;
    const bicycle_lanes z875 = c_roll * z747 - e2z * z838;
    const bicycle_lanes z876 = c_roll * z774 - e2z * z855;
    const bicycle_lanes z877 = z874 + z181 * z835 + z183 * z838 + z172 * z875 - z132 * z852 - z134 * z855 +
        z123 * z876;
    const bicycle_lanes z878 = c_roll * z798 - e2z * z870;
    const bicycle_lanes z879 = z271 * (z877 - z88 * z867 - z90 * z870 + z79 * z878);
    const bicycle_lanes z880 = z840 - z122 * z853 - z121 * z856 - z78 * z868 - z77 * z871 - z47 * z879;
    const bicycle_lanes z881 = z29 * z804 - z27 * z820;
    const bicycle_lanes z882 = z29 * z836 + z27 * z839;
    const bicycle_lanes z883 = z29 * z868 + z27 * z871;
    const bicycle_lanes z884 = z519 * z620 - z243 * z804 - z15 * z836 - z70 * z868 - z27 * z879;
    const bicycle_lanes z885 = z519 * z621 + z243 * z820 - z15 * z839 - z70 * z871 + z29 * z879;
    const bicycle_lanes z886 = z507 * z638 - z240 * z881 - z40 * z882 - z76 * z883 + z46 * z884 + z34 * z885;
    const bicycle_lanes z887 = z691 - z250 * z715 - z173 * z747 - z124 * z774 - z80 * z798 - z23 * z880 - z54
        * z886;
    const bicycle_lanes z888 = z29 * z853 + z27 * z856;
    const bicycle_lanes z889 = z493 * z638 - z235 * z881 - z120 * z888 - z75 * z883 + z43 * z884 + z38 * z885;
    const bicycle_lanes z890 = z528 * z629 - z533 * z617 + z462 * z673 + w1_pitch * z710 - z253 * z801 - z511
        * z674;
    const bicycle_lanes z891 = z64 * z873;
    const bicycle_lanes z892 = z30 * z804 - z27 * z891;
    const bicycle_lanes z893 = z30 * z820 - z29 * z891;
    const bicycle_lanes z894 = z60 * z881 + z46 * z892 - z34 * z893;
    const bicycle_lanes z895 = z55 * z881 - z43 * z892 + z38 * z893;
    const bicycle_lanes z896 = z62 * z804 - z61 * z820 + z47 * z891;
    const bicycle_lanes z897 = c_lam * z895 + s_lam * z896;
    const bicycle_lanes z898 = z444 * z641 + z452 * z672 - c_steer * z894 + s_steer * z897;
    const bicycle_lanes z899 = z890 - z499 * z675 + z480 * z677 - z224 * z898 + z176 * z743 - z186 * z834 +
        z127 * z770;
    const bicycle_lanes z900 = z64 * z878;
    const bicycle_lanes z901 = z30 * z868 + z27 * z900;
    const bicycle_lanes z902 = z30 * z871 - z29 * z900;
    const bicycle_lanes z903 = z60 * z883 + z46 * z901 + z34 * z902;
    const bicycle_lanes z904 = z55 * z883 - z43 * z901 - z38 * z902;
    const bicycle_lanes z905 = z62 * z868 + z61 * z871 - z47 * z900;
    const bicycle_lanes z906 = c_lam * z904 + s_lam * z905;
    const bicycle_lanes z907 = c_steer * z903 - s_steer * z906;
    const bicycle_lanes z908 = z64 * z875;
    const bicycle_lanes z909 = z520 * z621 + z522 * z635 + z242 * z820 + z241 * z891 - z180 * z839 + z171 *
        z908;
    const bicycle_lanes z910 = z64 * z876;
    const bicycle_lanes z911 = z520 * z620 - z508 * z635 - z451 * z637 - z242 * z804 - z246 * z891 - z180 *
        z836;
    const bicycle_lanes z912 = z911 - z170 * z908 - z131 * z853 + z121 * z910 - z87 * z868 + z77 * z900 + z61
        * z879;
    const bicycle_lanes z913 = z912 - e2z * z880;
    const bicycle_lanes z914 = z909 - z131 * z856 - z122 * z910 - z87 * z871 - z78 * z900 - z62 * z879 + z913;
    const bicycle_lanes z915 = z30 * z856 - z29 * z910;
    const bicycle_lanes z916 = z519 * z635 + z243 * z891 - z15 * z908 - z70 * z900 + z30 * z879;
    const bicycle_lanes z917 = z493 * z640 + z235 * z893 - z120 * z915 - z75 * z902 + z55 * z885 - z43 * z916;
    const bicycle_lanes z918 = z30 * z853 + z27 * z910;
    const bicycle_lanes z919 = z493 * z639 + z451 * z644 - z235 * z892 - z120 * z918 - z75 * z901 + z55 *
        z884;
    const bicycle_lanes z920 = z919 + z38 * z916 + e2z * z889;
    const bicycle_lanes z921 = z917 + z920;
    const bicycle_lanes z922 = z899 + z137 * z851 + z83 * z794 + z93 * z866 + c_pitch * z907 - z26 * z914 -
        z33 * z921;
    const bicycle_lanes z923 = z445 * z637 - c_roll * z880;
    const bicycle_lanes z924 = z446 * z659 + s_pitch * z923;
    const bicycle_lanes z925 = z445 * z642 + c_roll * z886;
    const bicycle_lanes z926 = z446 * z646 + s_pitch * z925;
    const bicycle_lanes z927 = z445 * z644 - c_roll * z889;
    const bicycle_lanes z928 = z446 * z653 + s_pitch * z927;
    const bicycle_lanes z929 = z482 * z660 + z444 * z647 + z480 * z654 - z1 * z924 + c_steer * z926 - z35 *
        z928;
    const bicycle_lanes z930 = z30 * z839 - z29 * z908;
    const bicycle_lanes z931 = z507 * z640 + z240 * z893 - z40 * z930 - z76 * z902 - z60 * z885 - z46 * z916;
    const bicycle_lanes z932 = z30 * z836 + z27 * z908;
    const bicycle_lanes z933 = z507 * z639 - z451 * z642 - z240 * z892 - z40 * z932 - z76 * z901 - z60 * z884;
    const bicycle_lanes z934 = z933 + z34 * z916 + e2z * z886;
    const bicycle_lanes z935 = z931 + z934;
    const bicycle_lanes z936 = z922 - z929 + z35 * z935;
    const bicycle_lanes z937 = z529 * z629 - z533 * z616 + z463 * z673 - w3_pitch * z710 - z253 * z800 - z510
        * z674;
    const bicycle_lanes z938 = z937 + z482 * z677 - z498 * z675 + z225 * z898 + z175 * z743 - z186 * z829 +
        z126 * z770;
    const bicycle_lanes z939 = z938 + z137 * z847 - z82 * z794 + z93 * z862 - s_pitch * z907 + z25 * z914 +
        z1 * z935;
    const bicycle_lanes z940 = z448 * z659 - c_pitch * z923;
    const bicycle_lanes z941 = z448 * z646 - c_pitch * z925;
    const bicycle_lanes z942 = z448 * z653 - c_pitch * z927;
    const bicycle_lanes z943 = z482 * z661 + z444 * z648 + z480 * z655 + z1 * z940 - c_steer * z941 + z35 *
        z942;
    const bicycle_lanes z944 = z939 + z32 * z921 - z943;
    const bicycle_lanes z945 = z5 * (z267 * (z471 * z679 + z476 * z683 - z472 * z685 - z2 * z936 + z19 *
        z944));
    const bicycle_lanes z946 = z473 * z684 * z576 - 0.5 * z945;
    const bicycle_lanes z947 = z449 * z686 - k56 * z592 + k55 * z593 - 2.0 * (e3z * z946) + r_R * (z474 *
        z679 + z5 * z936);
    const bicycle_lanes z948 = k64 * z595 - k63 * z596 + k60 * z597;
    const bicycle_lanes z949 = z494 * z643 + z467 * z641 + z237 * z895 + z230 * z894 + z55 * z882 - z43 *
        z932;
    const bicycle_lanes z950 = c_lam * z926 - s_lam * z941;
    const bicycle_lanes z951 = z452 * z645 + z444 * z649 - s_steer * z934 + c_steer * z950;
    const bicycle_lanes z952 = z60 * z888 + z46 * z918 + z34 * z915 - (c_lam * z941 + s_lam * z926);
    const bicycle_lanes z953 = c_lam * z928 - s_lam * z942;
    const bicycle_lanes z954 = z949 - z38 * z930 + z66 * z904 + z73 * z903 - c_lam * z951 + s_lam * z952 +
        (z444 * z652 - z452 * z656 - c_steer * z920 + s_steer * z953);
    const bicycle_lanes z955 = z470 * z641 + z494 * z636 - z231 * z894 + z237 * z896 + z62 * z836 + z61 *
        z839;
    const bicycle_lanes z956 = c_lam * z924 - s_lam * z940;
    const bicycle_lanes z957 = z955 - z47 * z908 - z74 * z903 + z66 * z905 + (z444 * z658 - z452 * z662 +
        c_steer * z913 + s_steer * z956);
    const bicycle_lanes z958 = z957 - c_lam * z952 - s_lam * z951;
    const bicycle_lanes z959 = z14 * (z276 * (z456 * z657 - z468 * z663 - z458 * z665 - z39 * z954 - z11 *
        z958));
    const bicycle_lanes z960 = z459 * z664 * z575 - 0.5 * z959;
    const bicycle_lanes z961 = z455 * z666 - 2.0 * (z12 * z960) + r_F * (z460 * z657 + z14 * z954);
    const bicycle_lanes z962 = z457 * z666 - 2.0 * (z10 * z960) - r_F * (z460 * z663 - z14 * z958);
    const bicycle_lanes z963 = k62 * z599 + k60 * z600 + k59 * z599 + s_lam * z961 - c_lam * z962;
    const bicycle_lanes z964 = z444 * z669 - s_steer * z948 + c_steer * z963;
    const bicycle_lanes z965 = k61 * z599 - k60 * z603 - k58 * z599 + c_lam * z961 + s_lam * z962;
    const bicycle_lanes z966 = z947 - s_lam * z964 - c_lam * z965;
    const bicycle_lanes z967 = z447 * z686 - k57 * z592 - k55 * z594 - 2.0 * (z3 * z946) + r_R * (z474 * z683
        - z5 * z944);
    const bicycle_lanes z968 = z967 - c_lam * z964 + s_lam * z965;
    const bicycle_lanes z969 = z250 * z633 + z23 * z637 - z54 * z642 + z59 * z644 + c_pitch * z689 + s_pitch
        * z690;
    const bicycle_lanes z970 = z524 * z619 + z517 * z637 + z491 * z642 + z505 * z644 - z250 * z818 + k56 *
        z622;
    const bicycle_lanes z971 = z970 + k57 * z623 - k55 * z624 - z173 * z838 - z124 * z855 - z80 * z870 - z29
        * z880;
    const bicycle_lanes z972 = c_steer * z948 + (roll_dot * z969 - (z452 * z669 + (z971 - z43 * z886 + z46 *
        z889))) + s_steer * z963;
    const bicycle_lanes z973 = e2z * (roll_dot * z670 + (z887 - z59 * z889) + c_pitch * z966 + s_pitch *
        z968) - c_roll * z972;
    bicycle_put(slope + 0 * BICYCLE_LANES, -z973);
    const bicycle_lanes z974 = z469 * z641 - z15 * z894;
    const bicycle_lanes z975 = z461 * z641 - z40 * z894;
    const bicycle_lanes z976 = c_lam * z974 - s_lam * z975 + k3 * z894;
    const bicycle_lanes z977 = s_lam * z974 + c_lam * z975 + k12 * z894;
    const bicycle_lanes z978 = z461 * z643 + z469 * z636 - z40 * z895 - z15 * z896;
    const bicycle_lanes z979 = z978 - k3 * (s_lam * z895 - c_lam * z896) + k12 * z897;
    const bicycle_lanes z980 = z444 * z808 + z452 * z809 + c_steer * z977 - s_steer * z979;
    const bicycle_lanes z981 = z477 * z673 - z711 - c_lam * z976 - s_lam * z980 + z20 * z898 + k10 * z898;
    const bicycle_lanes z982 = z527 * z632 + z514 * z659 + z488 * z646 + z502 * z653 + z248 * z814 - z261 *
        z714;
    const bicycle_lanes z983 = z15 * z903;
    const bicycle_lanes z984 = z40 * z903;
    const bicycle_lanes z985 = c_lam * z983 - s_lam * z984 - k3 * z903;
    const bicycle_lanes z986 = s_lam * z983 + c_lam * z984 - k12 * z903;
    const bicycle_lanes z987 = z40 * z904 + z15 * z905 + k3 * (s_lam * z904 - c_lam * z905) - k12 * z906;
    const bicycle_lanes z988 = c_steer * z986 - s_steer * z987;
    const bicycle_lanes z989 = z982 + z174 * z746 + z125 * z773 - z795 + z81 * z797 + c_lam * z985 + s_lam *
        z988;
    const bicycle_lanes z990 = z445 * z690 - (z989 - z20 * z907 - z18 * z923 + z52 * z925 - z57 * z927 - k10
        * z907);
    const bicycle_lanes z991 = z475 * z673 - z714 - s_lam * z976 + c_lam * z980 + R3 * z898 + k9 * z898;
    const bicycle_lanes z992 = z527 * z630 + z515 * z659 + z489 * z646 + z503 * z653 - z248 * z812 - z261 *
        z711;
    const bicycle_lanes z993 = z992 - z174 * z744 - z125 * z771 - z81 * z795 - z797 - s_lam * z985 + c_lam *
        z988;
    const bicycle_lanes z994 = z445 * z689 + (z993 + R3 * z907 - z22 * z923 + z53 * z925 - z58 * z927 + k9 *
        z907);
    const bicycle_lanes z995 = c_pitch * (roll_dot * z981 - z990 - c_roll * z968) - s_pitch * (roll_dot *
        z991 - z994 - c_roll * z966);
    bicycle_put(slope + 1 * BICYCLE_LANES, -z995);
    const bicycle_lanes z996 = z526 * z612 + z252 * z610 + z233 * z641 - z228 * z808 - z16 * z658 + s_lam *
        (c_lam * (R3 * z674 - k9 * z658) - s_lam * (z20 * z674 - k10 * z658));
    const bicycle_lanes z997 = z996 - z41 * z649 - z21 * z648 + z6 * z647 - z44 * z652 - c_lam * (s_lam *
        (z20 * z675 - k10 * z652) - c_lam * (R3 * z675 - k9 * z652));
    const bicycle_lanes z998 = z997 + z7 * z669;
    const bicycle_lanes z999 = z544 * z598 - z538 * z601 - z530 * z610 - z525 * z612 - z526 * z701 + z478 *
        z672;
    const bicycle_lanes z1000 = z999 + z465 * z809 - z469 * z662 - z485 * z645 - z461 * z656 - z252 * z706 -
        z193 * z734;
    const bicycle_lanes z1001 = z1000 + z185 * z736 + z191 * z739 + z179 * z740 - z144 * z763 - z136 * z764 -
        z142 * z766;
    const bicycle_lanes z1002 = z233 * z897 + (z1001 + z130 * z767 - z100 * z788 - z92 * z789 - z98 * z791 +
        z86 * z792);
    const bicycle_lanes z1003 = z228 * z979 + z1002 + z67 * z906 - z65 * z987 - z16 * z956 + z41 * z934 - z44
        * z953;
    const bicycle_lanes z1004 = z477 * z655 + z475 * z678 - z21 * z942 - z6 * z928 - R3 * z935 - k9 * z934;
    const bicycle_lanes z1005 = z475 * z660 - z477 * z681 + z21 * z940 + z6 * z924 - z20 * z935 - k10 * z934;
    const bicycle_lanes z1006 = z7 * z948 - (steer_dot * z998 + (z451 * z669 + (z1003 + c_lam * z1004 - s_lam
        * z1005))) + e2z * z963;
    const bicycle_lanes z1007 = z526 * z610 - z252 * z612 - z233 * z672 + z228 * z809 - z16 * z662 + z41 *
        z645;
    const bicycle_lanes z1008 = z1007 - z44 * z656 + c_lam * (z21 * z655 - z6 * z654 + R3 * z677 - k9 * z645);
    const bicycle_lanes z1009 = z1008 + s_lam * (z21 * z661 - z6 * z660 - z20 * z677 + k10 * z645) - e2z *
        z669;
    const bicycle_lanes z1010 = z538 * z598 + z544 * z601 - z530 * z612 + z525 * z610 + z526 * z706 - z478 *
        z641;
    const bicycle_lanes z1011 = z1010 - z465 * z808 - z469 * z658 + z485 * z649 - z477 * z648 + z475 * z647 -
        z461 * z652;
    const bicycle_lanes z1012 = z1011 + z453 * z669 - z252 * z701 + z185 * z734 + z193 * z736 - z179 * z739 +
        z191 * z740;
    const bicycle_lanes z1013 = z1012 - z136 * z763 + z144 * z764 - z130 * z766 - z142 * z767 - z92 * z788 +
        z100 * z789;
    const bicycle_lanes z1014 = z228 * z977 + (z233 * z894 - (z1013 - z86 * z791 - z98 * z792)) + z67 * z903
        - z65 * z986;
    const bicycle_lanes z1015 = c_lam * (z475 * z674 - R3 * z914 - k9 * z913) - s_lam * (z477 * z674 - z20 *
        z914 - k10 * z913);
    const bicycle_lanes z1016 = z1014 + z16 * z913 - s_lam * z1015 + z41 * z950 - z21 * z941 - z6 * z926 -
        z44 * z920;
    const bicycle_lanes z1017 = s_lam * (z477 * z675 + z20 * z921 + k10 * z920) - c_lam * (z475 * z675 + R3 *
        z921 + k9 * z920);
    const bicycle_lanes z1018 = c_steer * z1006 - s_steer * (e2z * z948 + (steer_dot * z1009 + (z1016 + c_lam
        * z1017)) - z7 * z963);
    bicycle_put(slope + 2 * BICYCLE_LANES, z1018);
    const bicycle_lanes z1019 = z446 * z811 - z448 * z813 - e2z * z969 - c_roll * z670 + s_pitch * z981 +
        c_pitch * z991;
    bicycle_put(slope + 3 * BICYCLE_LANES, -z1019);
    bicycle_put(slope + 4 * BICYCLE_LANES, z709 + z976 + c_steer * z1009 - s_steer * z998);
    bicycle_put(slope + 5 * BICYCLE_LANES, -(z700 + z978));
}

int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[415]; /* what parts of this function leave for others */
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
        double carried[135 * BICYCLE_LANES];
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
    const double k8 = s_lam * s_lam;
    const double k9 = s_lam * k2 - c_lam * k7;
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
    const double z24 = c_lam * z22 + k8;
    const double z25 = z14 * z23 + R3 * z24;
    const double z26 = c_lam * s_steer;
    const double z27 = R3 * z26 - z14 * z1;
    const double z28 = r_F * z9;
    const double z29 = z28 * z10;
    const double z30 = k7 - c_lam * z29 - s_lam * z11;
    const double z31 = z26 * k4 - z1 * k5 + z27 - s_steer * z30;
    const double z32 = z29 + k9;
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
    const bicycle_lanes z32 = c_lam * z30 + k13;
    const bicycle_lanes z33 = z20 * z31 + R3 * z32;
    const bicycle_lanes z34 = c_lam * s_steer;
    const bicycle_lanes z35 = R3 * z34 - z20 * z1;
    const bicycle_lanes z36 = r_F * z12;
    const bicycle_lanes z37 = z36 * z14;
    const bicycle_lanes z38 = k12 - c_lam * z37 - s_lam * z15;
    const bicycle_lanes z39 = z34 * k9 - z1 * k10 + z35 - s_steer * z38;
    const bicycle_lanes z40 = z37 + k14;
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
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z7;
    const bicycle_lanes z225 = c_lam * w1_pitch - s_lam * w3_pitch;
    const bicycle_lanes z226 = s_steer * z219 - c_steer * z225;
    const bicycle_lanes z227 = c_steer * z219 + s_steer * z225;
    const bicycle_lanes z228 = F_yy * (thF_dot - z227) - k47 * z227;
    const bicycle_lanes w3_steer = steer_dot + (c_lam * w3_pitch + s_lam * w1_pitch);
    const bicycle_lanes z229 = k43 * z226 - k44 * w3_steer;
    const bicycle_lanes z230 = c_pitch * z217;
    const bicycle_lanes z231 = roll_dot * z230;
    const bicycle_lanes z232 = s_pitch * z217;
    const bicycle_lanes z233 = roll_dot * e2z;
    const bicycle_lanes z234 = steer_dot * c_steer;
    const bicycle_lanes z235 = roll_dot * z232;
    const bicycle_lanes z236 = s_lam * z231 + c_lam * z235;
    const bicycle_lanes z237 = z234 * z201 - s_steer * z236;
    const bicycle_lanes z238 = roll_dot * c_roll;
    const bicycle_lanes z239 = steer_dot * s_steer;
    const bicycle_lanes z240 = s_pitch * z233 + c_roll * z230;
    const bicycle_lanes z241 = c_pitch * z233 - c_roll * z232;
    const bicycle_lanes z242 = s_steer * z238 + e2z * z234 + (z7 * z239 + c_steer * (c_lam * z240 + s_lam *
        z241));
    const bicycle_lanes z243 = s_lam * z240 - c_lam * z241;
    const bicycle_lanes z244 = c_lam * z242 + s_lam * z243;
    const bicycle_lanes z245 = r_F * z14;
    const bicycle_lanes z246 = c_lam * z243 - s_lam * z242;
    const bicycle_lanes z247 = (z10 * z244 + z12 * z246) * (z14 / z13);
    const bicycle_lanes z248 = z244 * z245 - z11 * z247;
    const bicycle_lanes z249 = k3 * z237;
    const bicycle_lanes z250 = r_R * z5;
    const bicycle_lanes z251 = (z3 * z240 + e3z * z241) * (z5 / z4);
    const bicycle_lanes z252 = z250 * z241 - z2 * z251;
    const bicycle_lanes z253 = z250 * z240 - z19 * z251;
    const bicycle_lanes z254 = k9 * z235 - k10 * z231 + (R3 * z235 - z198 * z252 - (z20 * z231 + z199 *
        z253));
    const bicycle_lanes z255 = k12 * z237 + (z234 * z205 + s_steer * z254);
    const bicycle_lanes z256 = s_lam * z239;
    const bicycle_lanes z257 = s_lam * z256;
    const bicycle_lanes z258 = c_lam * z256;
    const bicycle_lanes z259 = z20 * z257 + z25 * z253 - (R3 * z258 - z26 * z252);
    const bicycle_lanes z260 = s_lam * z234;
    const bicycle_lanes z261 = z234 * z16 - s_steer * z248;
    const bicycle_lanes z262 = z1 * z253;
    const bicycle_lanes z263 = z18 * z230 - s_pitch * (z6 * z260 - z1 * z252 + c_lam * z261) + (z22 * z232 +
        c_pitch * (z21 * z260 - z262 - s_lam * z261));
    const bicycle_lanes z264 = k10 * z257 - k9 * z258 + z259 - (z239 * z16 + c_steer * z248);
    const bicycle_lanes z265 = z215 * z259 + (z218 * (z233 * z23 + c_roll * z263 + (z238 * z28 - e2z * z264))
        - z217 * z264);
    const bicycle_lanes z266 = z15 * z237 - z208 * z248 - (c_lam * z249 + s_lam * z255) + z265;
    const bicycle_lanes z267 = s_lam * z235 - c_lam * z231;
    const bicycle_lanes z268 = z239 * z201 + c_steer * z236;
    const bicycle_lanes z269 = z246 * z245 - z36 * z247;
    const bicycle_lanes z270 = z37 * (s_lam * z267 + c_lam * z268) - z203 * z269 + (z15 * (s_lam * z268 -
        c_lam * z267) + z204 * z248);
    const bicycle_lanes z271 = c_lam * z234;
    const bicycle_lanes z272 = z34 * z252;
    const bicycle_lanes z273 = R3 * z271 - z272 - (z20 * z260 - z262);
    const bicycle_lanes z274 = c_lam * z269 + s_lam * z248;
    const bicycle_lanes z275 = z239 * z38 - c_steer * z274;
    const bicycle_lanes z276 = s_lam * z269 - c_lam * z248;
    const bicycle_lanes z277 = z47 * z230 + s_pitch * (z239 * z6 + c_steer * z252 - c_lam * z275 + s_lam *
        z276) + (z48 * z232 - c_pitch * (z239 * z21 + c_steer * z253 + s_lam * z275 + c_lam * z276));
    const bicycle_lanes z278 = k9 * z271 - k10 * z260 + z273 - (z234 * z38 + s_steer * z274);
    const bicycle_lanes z279 = z215 * z273 - (z218 * (z233 * z49 + c_roll * z277 + (z238 * z39 + e2z * z278))
        + z217 * z278);
    const bicycle_lanes z280 = z270 - (k12 * z268 - k3 * z267 + (z239 * z205 - c_steer * z254)) + z279;
    const bicycle_lanes z281 = c_lam * z239;
    const bicycle_lanes z282 = s_lam * z281;
    const bicycle_lanes z283 = c_lam * z281;
    const bicycle_lanes z284 = z20 * z282 - z31 * z253 - (R3 * z283 + z32 * z252);
    const bicycle_lanes z285 = z234 * z40 - s_steer * z269;
    const bicycle_lanes z286 = z52 * z230 - s_pitch * (z6 * z271 - z272 + c_lam * z285) + (z53 * z232 +
        c_pitch * (z21 * z271 - z34 * z253 - s_lam * z285));
    const bicycle_lanes z287 = k10 * z282 - k9 * z283 + z284 - (z239 * z40 + c_steer * z269);
    const bicycle_lanes z288 = z215 * z284 + (z218 * (z233 * z54 + c_roll * z286 - (z238 * z41 + e2z * z287))
        - z217 * z287);
    const bicycle_lanes z289 = z37 * z237 - z208 * z269 + (s_lam * z249 - c_lam * z255) + z288;
    const bicycle_lanes z290 = z33 * z280 - z35 * z289;
    const bicycle_lanes z291 = z41 * z280 - z39 * z289;
    const bicycle_lanes z292 = z59 * (z42 * z266 + z28 * z290 - z27 * z291);
    const bicycle_lanes z293 = z233 * z218 - c_roll * z292;
    const bicycle_lanes z294 = z231 + (z223 * z232 - c_pitch * z293);
    const bicycle_lanes z295 = z235 - (z223 * z230 + s_pitch * z293);
    const bicycle_lanes z296 = c_lam * z294 - s_lam * z295;
    const bicycle_lanes z297 = a1 * w3_pitch - a3 * w1_pitch + (w1_pitch * z252 - R3 * z295 + (w3_pitch *
        z253 + z20 * z294));
    const bicycle_lanes z298 = k9 * z219;
    const bicycle_lanes z299 = k10 * z219;
    const bicycle_lanes z300 = z297 - (w3_pitch * z298 - w1_pitch * z299 - (k10 * z294 - k9 * z295));
    const bicycle_lanes z301 = z50 * z289 + z55 * z280;
    const bicycle_lanes z302 = z59 * (z29 * z290 + z56 * z266 + z27 * z301) + (z238 * z218 + e2z * z292);
    const bicycle_lanes z303 = z59 * (z29 * z291 + z28 * z301 + z57 * z266) - z302;
    const bicycle_lanes z304 = z219 * a3 - w3_pitch * v2_x + (z220 * z252 - R3 * z303);
    const bicycle_lanes z305 = k10 * w3_pitch + k9 * w1_pitch;
    const bicycle_lanes z306 = z304 - (z219 * z299 + w3_pitch * z305 - k9 * z302);
    const bicycle_lanes z307 = w1_pitch * v2_x - z219 * a1 + (z220 * z253 - z20 * z303);
    const bicycle_lanes z308 = z307 + (w1_pitch * z305 + z219 * z298 + k10 * z302);
    const bicycle_lanes z309 = c_lam * z306 - s_lam * z308;
    const bicycle_lanes z310 = c_steer * z300 + s_steer * z309;
    const bicycle_lanes z311 = c_lam * z295 + s_lam * z294;
    const bicycle_lanes z312 = z234 * z219 + s_steer * z302 + (z239 * z225 - c_steer * z311);
    const bicycle_lanes z313 = h2z * k64 - (z226 * z228 + z227 * z229 + (k51 * z296 + (k36 * z310 + k50 *
        z312)));
    const bicycle_lanes z314 = k50 * z226 - k51 * w3_steer;
    const bicycle_lanes z315 = z239 * z219 - c_steer * z302 - (z234 * z225 + s_steer * z311);
    const bicycle_lanes z316 = c_steer * z309 - s_steer * z300;
    const bicycle_lanes z317 = c_lam * z308 + s_lam * z306;
    const bicycle_lanes z318 = z8 * k59 + z9 * k58 + (z8 * k62 - z9 * k61) - (w3_steer * z229 + z226 * z314 -
        (k47 * z315 + (k33 * z316 - k36 * z317)));
    const bicycle_lanes z319 = h2z * k63 + (z227 * z314 - w3_steer * z228 - (k44 * z296 - (k33 * z310 - k43 *
        z312)));
    const bicycle_lanes z320 = k33 * z226 + k36 * w3_steer;
    const bicycle_lanes z321 = k33 * z227;
    const bicycle_lanes z322 = z9 * k60 - (z226 * z320 + z227 * z321 - (k31 * z317 - k36 * z315));
    const bicycle_lanes z323 = k36 * z227;
    const bicycle_lanes z324 = h2z * k60 + (w3_steer * z321 - z226 * z323 + (k36 * z296 + (k31 * z310 - k33 *
        z312)));
    const bicycle_lanes z325 = z8 * k60 - (z227 * z323 + w3_steer * z320 - (k31 * z316 + k33 * z315));
    const bicycle_lanes z326 = R_yy * z220 - k27 * z219;
    const bicycle_lanes z327 = k25 * w1_pitch + k28 * w3_pitch;
    const bicycle_lanes z328 = e2z * k56 - (w1_pitch * z326 + z219 * z327 - (k29 * z294 + (k23 * z297 - k28 *
        z295)));
    const bicycle_lanes z329 = k28 * w1_pitch + k29 * w3_pitch;
    const bicycle_lanes z330 = z3 * k57 + e3z * k56 + (w3_pitch * z327 - w1_pitch * z329 - (k27 * z302 - (k22
        * z304 - k23 * z307)));
    const bicycle_lanes z331 = e2z * k57 - (z219 * z329 + w3_pitch * z326 + (k28 * z294 - (k22 * z297 + k25 *
        z295)));
    const bicycle_lanes z332 = k22 * w1_pitch - k23 * w3_pitch;
    const bicycle_lanes z333 = k22 * z219;
    const bicycle_lanes z334 = e3z * k55 + (w1_pitch * z332 + z219 * z333 - (k21 * z307 + k23 * z302));
    const bicycle_lanes z335 = k23 * z219;
    const bicycle_lanes z336 = z3 * k55 - (z219 * z335 - w3_pitch * z332 - (k21 * z304 - k22 * z302));
    const bicycle_lanes z337 = e2z * k55 + (w3_pitch * z333 + w1_pitch * z335 + (k23 * z294 + (k21 * z297 +
        k22 * z295)));
    const bicycle_lanes z338 = z74 * z328 + (z80 * z330 - (z75 * z331 + (z84 * z334 - (z82 * z336 + z77 *
        z337))));
    const bicycle_lanes z339 = z76 * z313 - (z91 * z318 + (z89 * z319 + (z93 * z322 + (z87 * z324 + (z92 *
        z325 + z338)))));
    const bicycle_lanes z340 = z339 + z149 * z303 - z150 * z315;
    const bicycle_lanes z341 = z113 * z328 - (z119 * z330 - (z114 * z331 + (z123 * z334 - (z121 * z336 + z116
        * z337))));
    const bicycle_lanes z342 = z115 * z313 - (z130 * z318 + (z128 * z319 + (z132 * z322 + (z126 * z324 +
        (z131 * z325 - z341)))));
    const bicycle_lanes z343 = z342 + z192 * z303 - z193 * z315 - z340 * z153;
    const bicycle_lanes z344 = z159 * z328 + (z165 * z330 + (z160 * z331 - (z169 * z334 - (z167 * z336 - z162
        * z337))));
    const bicycle_lanes z345 = z161 * z313 - (z175 * z318 + (z174 * z319 + (z177 * z322 - (z172 * z324 -
        (z176 * z325 + z344)))));
    const bicycle_lanes z346 = (z345 + R_yy * (z166 * z303) - F_yy * (z184 * z315) - z340 * z189 - z196 *
        z343) / z197;
    const bicycle_lanes z347 = z195 * z343 - z196 * z346;
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
    const bicycle_lanes slope10 = z189 * z346 - (z152 * z340 - z153 * z347);
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = -z347;
    sum += slope11;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = z346;
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
    const double k13 = s_lam * s_lam;
    const double k14 = s_lam * k3 - c_lam * k12;
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
