/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:10da0709fdf88353)
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

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define BICYCLE_SLOW __attribute__((cold, optimize("O1")))
#else
#define BICYCLE_SLOW
#endif

#if defined(__GNUC__)
__attribute__((noinline)) /* it is seldom called, and would cost its callers registers */
#endif
static int bicycle_finish(int count, const double *values)
{
    double sum = 0.0; /* an infinity or a NaN among the values stays in it */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return BICYCLE_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return BICYCLE_NOT_FINITE;
        }
    }
    return BICYCLE_OK;
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
    double sum = check[0] + check[1];
    int k = 2;
    if (count >= 8) { /* pairs of pairs: sums that need not wait for one another */
        sum = (sum + (check[2] + check[3])) + ((check[4] + check[5]) + (check[6] + check[7]));
        k = 8;
    }
    for (; k < count; k += 2) {
        sum += check[k] + check[k + 1];
    }
    return sum <= 1e10;
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
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double z1 = pitch + lam;
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
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
    const double k5 = H_zz + F_xx;
    const double k6 = H_xx + F_xx;
    const double k7 = R_xx + B_xx;
    const double k8 = R_xx + B_zz;
    const double k9 = z_H * s_lam + c_lam * k3;
    const double k10 = c_lam * k2 - r_R * s_lam;
    const double k11 = c_lam * k1 + x_B * s_lam;
    const double k12 = x_B * c_lam - s_lam * k1;
    const double k13 = r_R * c_lam;
    const double k14 = s_lam * k2;
    const double k15 = z_H * c_lam - s_lam * k3 + k13 + k14;
    const double k16 = k14 - (r_F * c_lam + c * s_lam - k13);
    const double k17 = fabs(r_R);
    const double k18 = fabs(r_F);
    const double k19 = fabs(w);
    const double k20 = fabs(c);
    const double k21 = 9.0 * k18;
    const double k22 = 6.0 * k20 + (2.0 * k19 + (5.0 * k17 + k21));
    const double k23 = 6.0 * k19;
    const double k24 = 13.0 * k20 + (14.0 * k18 + k23);
    const double k25 = 10.0 * k20 + (k21 + k23);
    const double k26 = m_R + m_B;
    const double k27 = m_B * k11;
    const double k28 = m_B * k12;
    const double k29 = B_xz * c_lam;
    const double k30 = s_lam * k8 - k29;
    const double k31 = B_xz * s_lam;
    const double k32 = c_lam * k7 - k31;
    const double k33 = k11 * k27;
    const double k34 = s_lam * k30 + c_lam * k32 + k33;
    const double k35 = c_lam * k30 - s_lam * k32 + k12 * k27;
    const double k36 = k12 * k28;
    const double k37 = k33 + (B_yy + k36);
    const double k38 = k31 + c_lam * k8;
    const double k39 = k29 + s_lam * k7;
    const double k40 = s_lam * k38 - c_lam * k39 + k11 * k28;
    const double k41 = k36 + (c_lam * k38 + s_lam * k39);
    const double k42 = m_F * k16;
    const double k43 = m_H + m_F;
    const double k44 = m_H * k15;
    const double k45 = k42 + k44;
    const double k46 = m_F * k4;
    const double k47 = m_H * k9;
    const double k48 = k46 - k47;
    const double k49 = H_xz * c_lam;
    const double k50 = s_lam * k5 - k49;
    const double k51 = H_xz * s_lam;
    const double k52 = c_lam * k6 - k51;
    const double k53 = k16 * k42;
    const double k54 = k15 * k44;
    const double k55 = s_lam * k50 + c_lam * k52 + k53 + k54;
    const double k56 = c_lam * k50 - s_lam * k52 + k4 * k42 - k9 * k44;
    const double k57 = k4 * k46;
    const double k58 = k9 * k47;
    const double k59 = k54 + (k53 + (H_yy + k57) + k58);
    const double k60 = k51 + c_lam * k5;
    const double k61 = k49 + s_lam * k6;
    const double k62 = s_lam * k60 - c_lam * k61 + k16 * k46 - k15 * k47;
    const double k63 = k58 + (k57 + (c_lam * k60 + s_lam * k61));
    const double k64 = g * m_F;
    const double k65 = g * m_H;
    const double k66 = g * m_B;
    const double k67 = g * k26;
    const double k68 = k12 * k66;
    const double k69 = k11 * k66;
    const double k70 = g * k43;
    const double k71 = k15 * k65 + k16 * k64;
    const double k72 = k9 * k65 - k4 * k64;

    /* state */
    const double z2 = c_roll * c1;
    const double z3 = c_roll * s1;
    const double z4 = e2z * s_steer - c_steer * z3;
    const double z5 = 1.0 / sqrt(z2 * z2 + z4 * z4);
    const double z6 = r_F * z4;
    const double z7 = z5 * z6;
    const double z8 = k4 + z7;
    const double z9 = s_steer * z8;
    const double z10 = s1 * z9;
    const double z11 = 1.0 / fabs(c_roll);
    const double z12 = r_R * z3;
    const double z13 = z11 * z12;
    const double z14 = k10 + z13 + c_steer * z8;
    const double z15 = c_roll * z10 + e2z * z14;
    const double z16 = r_R * z2;
    const double z17 = z11 * z16;
    const double z18 = c_steer * z17;
    const double z19 = r_F * z2;
    const double z20 = z5 * z19;
    const double z21 = k16 + z20;
    const double z22 = z17 - z21;
    const double z23 = s_steer * z22;
    const double z24 = c_steer * z22;
    const double z25 = s_steer * z17;
    const double z26 = z18 * z23 - z24 * z25;
    const double z27 = c_steer * z21;
    const double z28 = c_steer * k10 + z8;
    const double z29 = s1 * z27 + c1 * z28;
    const double z30 = c_roll * z29 + e2z * z23;
    const double z31 = s_steer * z21;
    const double z32 = s_steer * k10;
    const double z33 = s1 * z31 + c1 * z32;
    const double z34 = c_roll * z33 - e2z * z24;
    const double z35 = z18 * z30 + z34 * z25;
    const double z36 = z24 * z30 + z34 * z23;
    const double z37 = z15 * z26 - z14 * z35 + z13 * z36;
    const double z38 = k17 * (9.0 + fabs(z11));
    const double z39 = r_R * c_roll;
    const double z40 = z39 * z11;
    const double z41 = 1.0 / z37;
    const double z42 = s_steer * c1;
    const double z43 = z8 * z42;
    const double z44 = k10 * s1 + z40;
    const double z45 = s_steer * z44 - z21 * z42;
    const double z46 = s1 * z8 + (c_steer * z44 - c1 * z27);
    const double z47 = z25 * z45 + z18 * z46;
    const double z48 = z23 * z45 + z24 * z46;
    const double z49 = z41 * (z26 * z43 + z14 * z47 - z13 * z48);
    const double z50 = c_roll * z49;
    const double z51 = s1 + c1 * z50;
    const double z52 = c1 - s1 * z50;
    const double z53 = z30 * z45 - z34 * z46;
    const double z54 = z41 * (z35 * z43 + z15 * z47 - z13 * z53) - e2z * z49;
    const double z55 = c_steer * z54 + s_steer * z52;
    const double z56 = z41 * (z36 * z43 + (z15 * z48 - z14 * z53)) - z54;
    const double z57 = z17 * z56;
    const double z58 = z40 + k10 * z51;
    const double z59 = c_steer * z57 - s_steer * z58;
    const double z60 = z13 * z56;
    const double z61 = z60 - k10 * z54;
    const double z62 = k59 * z55 + (k45 * z59 - k48 * z61);
    const double z63 = z62 + F_yy * z55;
    const double z64 = k41 * z51 + (z40 * k28 - k40 * z52);
    const double z65 = c_steer * z58 + s_steer * z57;
    const double z66 = s_steer * z54 - c_steer * z52;
    const double z67 = k63 * z51 + (k48 * z65 + k62 * z66);
    const double z68 = z64 + z67;
    const double z69 = k56 * z51 + (k45 * z65 + k55 * z66);
    const double z70 = k43 * z61 - k48 * z55;
    const double z71 = k48 * z51 + (k43 * z65 + k45 * z66);
    const double z72 = k43 * z59 + k45 * z55;
    const double z73 = k37 * z54 + (k27 * z57 - k28 * z60);
    const double z74 = k26 * z60 - k28 * z54;
    const double z75 = k26 * z57 + k27 * z54;
    const double z76 = k35 * z51 + (z40 * k27 - k34 * z52);
    const double z77 = z59 * z72 + (z54 * z73 + (z60 * z74 + (z57 * z75 - (z52 * z76 - R_yy * (z56 * z56)))));
    const double z78 = z40 * (k28 * z51 + (z40 * k26 - k27 * z52)) + (z55 * z63 + (z51 * z68 + (z66 * z69 +
        (z61 * z70 + (z65 * z71 + z77)))));
    const double z79 = z18 * z8;
    const double z80 = z34 * z8;
    const double z81 = z24 * z8;
    const double z82 = z41 * (z14 * z79 - z13 * z81);
    const double z83 = z41 * (z15 * z79 + z13 * z80) - e2z * z82;
    const double z84 = c_roll * z82;
    const double z85 = s1 * z84;
    const double z86 = c_steer * z83 - s_steer * z85;
    const double z87 = z41 * (z15 * z81 + z14 * z80) - z83;
    const double z88 = z17 * z87;
    const double z89 = c1 * z84;
    const double z90 = k10 * z89;
    const double z91 = c_steer * z88 - s_steer * z90;
    const double z92 = z13 * z87;
    const double z93 = z92 - k10 * z83;
    const double z94 = k59 * z86 + (k45 * z91 - k48 * z93);
    const double z95 = 1.0 + z89;
    const double z96 = c_steer * z90 + s_steer * z88;
    const double z97 = s_steer * z83 + c_steer * z85;
    const double z98 = k63 * z95 + (k48 * z96 + k62 * z97);
    const double z99 = k56 * z95 + (k45 * z96 + k55 * z97);
    const double z100 = k43 * z93 - k48 * z86;
    const double z101 = k48 * z95 + (k43 * z96 + k45 * z97);
    const double z102 = k43 * z91 + k45 * z86;
    const double z103 = k40 * z85 + k41 * z89;
    const double z104 = z83 * k37 + (z88 * k27 - z92 * k28);
    const double z105 = k34 * z85 + k35 * z89;
    const double z106 = z88 * k26 + z83 * k27;
    const double z107 = z92 * k26 - z83 * k28;
    const double z108 = z89 * z103 + (z83 * z104 + (z85 * z105 + (z88 * z106 + (z92 * z107 + R_yy * (z87 *
        z87)))));
    const double z109 = z86 * (z94 + F_yy * z86) + (z95 * z98 + (z97 * z99 + (z93 * z100 + (z96 * z101 + (z91
        * z102 + z108)))));
    const double z110 = z89 * z64 + (z83 * z73 + (z85 * z76 + (z88 * z75 + (z92 * z74 + R_yy * (z87 *
        z56)))));
    const double z111 = z86 * z63 + (z95 * z67 + (z97 * z69 + (z93 * z70 + (z96 * z71 + (z91 * z72 +
        z110)))));
    const double z112 = 1.0 / z78;
    const double z113 = z111 * z112;
    const double z114 = z109 - z111 * z113;
    const double z115 = z20 * z25;
    const double z116 = z20 * z23;
    const double z117 = z41 * (z7 * z26 - z14 * z115 + z13 * z116);
    const double z118 = c_roll * z117;
    const double z119 = c1 * z118;
    const double z120 = k10 * z119;
    const double z121 = z20 * z30;
    const double z122 = z41 * (z15 * z115 - z7 * z35 - z13 * z121) + e2z * z117;
    const double z123 = z41 * (z15 * z116 - z14 * z121 - z7 * z36) - z122;
    const double z124 = z17 * z123;
    const double z125 = c_steer * z120 - s_steer * z124;
    const double z126 = s1 * z118;
    const double z127 = s_steer * z122 - c_steer * z126;
    const double z128 = c_steer * z122 + s_steer * z126;
    const double z129 = c_steer * z124 + s_steer * z120;
    const double z130 = z13 * z123;
    const double z131 = z130 - k10 * z122;
    const double z132 = z126 * (k34 * z126 + k35 * z119) + (z124 * (z124 * k26 + z122 * k27) + z130 * (z130 *
        k26 - z122 * k28));
    const double z133 = z119 * (k40 * z126 + k41 * z119) + (z122 * (z122 * k37 + (z124 * k27 - z130 * k28)) +
        z132);
    const double z134 = z125 * (k48 * z119 + (k43 * z125 - k45 * z127)) + (z129 * (k43 * z129 + k45 * z128) +
        z133);
    const double z135 = z127 * (k56 * z119 + (k45 * z125 - k55 * z127)) - (z131 * (k43 * z131 - k48 * z128) +
        z134);
    const double z136 = z119 * (k63 * z119 + (k48 * z125 - k62 * z127)) + (z128 * (k59 * z128 + (k45 * z129 -
        k48 * z131)) - z135);
    const double z137 = 1.0 - z128;
    const double z138 = z136 + R_yy * (z123 * z123) + F_yy * (z137 * z137);
    const double z139 = R_yy * z123;
    const double z140 = F_yy * z137;
    const double z141 = z122 * z73 - (z126 * z76 - (z124 * z75 + (z130 * z74 + (z139 * z56 - z140 * z55))));
    const double z142 = z119 * z68 - (z128 * z62 + (z127 * z69 + (z131 * z70 - (z125 * z71 - (z129 * z72 +
        z141)))));
    const double z143 = z142 * z112;
    const double z144 = z126 * z105 - (z124 * z106 + (z130 * z107 + (z87 * z139 - z86 * z140 + z111 * z143)));
    const double z145 = z128 * z94 + (z127 * z99 + (z131 * z100 - (z125 * z101 - (z129 * z102 + (z122 * z104
        - z144)))));
    const double z146 = z119 * (z103 + z98) - z145;
    const double z147 = 1.0 / z114;
    const double z148 = z146 * z147;
    const double z149 = z138 - z142 * z143 - z146 * z148;
    const double z150 = roll_dot * c1;
    const double z151 = s_steer * z150;
    const double z152 = thF_dot - z151;
    const double z153 = k4 * z151 - z7 * z152;
    const double z154 = roll_dot * r_R;
    const double z155 = c_roll * z154;
    const double z156 = z11 * z155;
    const double z157 = roll_dot * s1;
    const double z158 = z156 + k10 * z157;
    const double z159 = z20 * z152 - (k16 * z151 - s_steer * z158);
    const double z160 = steer_dot + z157;
    const double z161 = c_steer * z150;
    const double z162 = z160 * z8 + (c_steer * z158 - z21 * z161);
    const double z163 = z23 * z159 + z24 * z162;
    const double z164 = z30 * z159 - z34 * z162;
    const double z165 = z41 * (z36 * z153 + (z15 * z163 - z14 * z164));
    const double z166 = z25 * z159 + z18 * z162;
    const double z167 = z41 * (z35 * z153 + z15 * z166 - z13 * z164);
    const double z168 = z41 * (z26 * z153 + z14 * z166 - z13 * z163);
    const double z169 = z167 - e2z * z168;
    const double z170 = z165 - z169;
    const double z171 = z13 * z170;
    const double z172 = z17 * z170;
    const double z173 = s1 * z171 + c1 * z172;
    const double z174 = s1 * z172 - c1 * z171;
    const double z175 = c_roll * z156 - e2z * z174;
    const double z176 = c1 * z167;
    const double z177 = roll_dot * z176;
    const double z178 = c_roll * z168;
    const double z179 = s1 * z167;
    const double z180 = roll_dot * e2z;
    const double z181 = steer_dot * c_steer;
    const double z182 = z180 * c1 - c_roll * z179;
    const double z183 = roll_dot * c_roll;
    const double z184 = steer_dot * s_steer;
    const double z185 = z180 * s1 + c_roll * z176;
    const double z186 = s_steer * z183 + e2z * z181 + (z184 * z3 + c_steer * z185);
    const double z187 = (z2 * z182 - z4 * z186) * (z5 * (z5 * z5));
    const double z188 = r_F * z5;
    const double z189 = z6 * z187 + z188 * z186;
    const double z190 = z180 * z11;
    const double z191 = z190 / c_roll;
    const double z192 = r_R * z11;
    const double z193 = z12 * z191 - z185 * z192;
    const double z194 = z193 - (z184 * z8 - c_steer * z189);
    const double z195 = c_roll * (z9 * z176 - s1 * (z181 * z8 + s_steer * z189)) + (z180 * z10 - (z183 * z14
        + e2z * z194));
    const double z196 = roll_dot * z179;
    const double z197 = z181 * z150 + s_steer * z196;
    const double z198 = z168 * z195 + (z8 * z197 - (z165 * z193 + (z152 * z189 - z167 * z194)));
    const double z199 = z19 * z187 - z188 * z182;
    const double z200 = s1 * (z184 * z21 - c_steer * z199) + (z27 * z176 - z28 * z179 + c1 * (z184 * k10 -
        z189));
    const double z201 = z16 * z191 - z182 * z192;
    const double z202 = z201 - z199;
    const double z203 = z181 * z22 + s_steer * z202;
    const double z204 = k10 * z177 - (z155 * z191 - z154 * z190);
    const double z205 = z21 * (z184 * z150 - c_steer * z196) - (z161 * z199 + (z184 * z158 - (z160 * z189 -
        (c_steer * z204 + z167 * z203))));
    const double z206 = z168 * (c_roll * z200 + (z180 * z29 - (z183 * z23 + e2z * z203))) - (z165 * (z181 *
        z17 + s_steer * z201) - (z8 * z177 - z205));
    const double z207 = s1 * (z181 * z21 + s_steer * z199) - (z31 * z176 - (z32 * z179 + k10 * (z181 * c1)));
    const double z208 = z184 * z22 - c_steer * z202;
    const double z209 = z165 * (z184 * z17 - c_steer * z201) - (z21 * z197 - (z152 * z199 + (z181 * z158 -
        (s_steer * z204 + z167 * z208))));
    const double z210 = z168 * (c_roll * z207 - (z180 * z33 + (z183 * z24 - e2z * z208))) + z209;
    const double z211 = z18 * z206 - z25 * z210;
    const double z212 = z24 * z206 - z23 * z210;
    const double z213 = z41 * (z26 * z198 - z14 * z211 + z13 * z212);
    const double z214 = z180 * z168 - c_roll * z213;
    const double z215 = z177 - (z178 * z179 - c1 * z214);
    const double z216 = z157 + c1 * z178;
    const double z217 = z150 - s1 * z178;
    const double z218 = z172 * z216 - z171 * z217 + roll_dot * (z180 * z192 - z39 * z191);
    const double z219 = k27 * z169;
    const double z220 = k28 * z169;
    const double z221 = z196 + (z178 * z176 + s1 * z214);
    const double z222 = k28 * z215 + (k26 * z218 + (z216 * z219 + (e2z * k67 + z217 * z220) + k27 * z221));
    const double z223 = z30 * z210 + z34 * z206;
    const double z224 = z41 * (z15 * z211 - z35 * z198 + z13 * z223) + (z183 * z168 + e2z * z213);
    const double z225 = z184 * z169 + c_steer * z224 - (z181 * z217 + s_steer * z221);
    const double z226 = k10 * z169;
    const double z227 = k10 * z216;
    const double v2_x = roll_dot * z40;
    const double z228 = z41 * (z15 * z212 + z14 * z223 - z36 * z198) - z224;
    const double z229 = z169 * z171 - v2_x * z216 - (z170 * z201 - z17 * z228);
    const double z230 = z169 * z226 + z216 * z227 - z229;
    const double z231 = z218 + (z226 * z217 + k10 * z215);
    const double z232 = c_steer * z230 + s_steer * z231;
    const double w3_steer = steer_dot + z216;
    const double z233 = s_steer * z169 - c_steer * z217;
    const double z234 = k55 * z233 + k56 * w3_steer;
    const double z235 = k62 * z233 + k63 * w3_steer;
    const double z236 = v2_x * z217 - z169 * z172 - (z170 * z193 - z13 * z228);
    const double z237 = z236 + (z217 * z227 - k10 * z224);
    const double z238 = z4 * k71 - (k59 * z225 - (k45 * z232 + (w3_steer * z234 - z233 * z235 + k48 * z237)));
    const double z239 = z2 * k72 + z238;
    const double z240 = F_yy * z225;
    const double z241 = z239 - z240;
    const double z242 = R_yy * z170 - k37 * z169;
    const double z243 = k34 * z217 - k35 * z216;
    const double z244 = e2z * k68 - (z217 * z242 + z169 * z243 - (k41 * z215 + (k28 * z218 + k40 * z221)));
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z245 = c_steer * z169 + s_steer * z217;
    const double z246 = F_yy * (thF_dot - z245) - k59 * z245;
    const double z247 = c_steer * z231 - s_steer * z230;
    const double z248 = z181 * z169 - s_steer * z224 + (z184 * z217 - c_steer * z221);
    const double z249 = h2z * k72 - (z233 * z246 + z245 * z234 + (k63 * z215 + (k48 * z247 - k62 * z248)));
    const double z250 = z244 - z249;
    const double z251 = h2z * k71 - (z245 * z235 + w3_steer * z246 - (k56 * z215 + (k45 * z247 - k55 *
        z248)));
    const double z252 = k45 * z233 + k48 * w3_steer;
    const double z253 = k45 * z245;
    const double z254 = z2 * k70 + (z233 * z252 + z245 * z253 - (k43 * z237 - k48 * z225));
    const double z255 = k48 * z245;
    const double z256 = h2z * k70 + (w3_steer * z253 - z233 * z255 + (k48 * z215 + (k43 * z247 - k45 *
        z248)));
    const double z257 = z4 * k70 + (z245 * z255 + w3_steer * z252 + (k43 * z232 - k45 * z225));
    const double z258 = k40 * z217 - k41 * z216;
    const double z259 = z3 * k69 + z2 * k68 + (z216 * z243 + z217 * z258 + (k37 * z224 + (k27 * z229 - k28 *
        z236)));
    const double z260 = e2z * k69 + (z169 * z258 - z216 * z242 + (k35 * z215 + (k27 * z218 + k34 * z221)));
    const double z261 = k27 * z217 - k28 * z216;
    const double z262 = z2 * k67 + (z217 * z261 + z169 * z219 - (k26 * z236 - k28 * z224));
    const double z263 = z3 * k67 - (z169 * z220 - z216 * z261 - (k26 * z229 + k27 * z224));
    const double z264 = R_yy * z228;
    const double z265 = z59 * z257 - (z54 * z259 - (z52 * z260 + (z60 * z262 - (z57 * z263 + z56 * z264))));
    const double z266 = z40 * z222 - (z55 * z241 - (z51 * z250 + (z66 * z251 - (z61 * z254 - (z65 * z256 -
        z265)))));
    const double z267 = z83 * z259 + (z85 * z260 + (z88 * z263 - (z92 * z262 + (z266 * z113 - z87 * z264))));
    const double z268 = z95 * z249 - (z97 * z251 - (z93 * z254 - (z96 * z256 - (z91 * z257 - (z89 * z244 +
        z267)))));
    const double z269 = z86 * z241 + z268;
    const double z270 = z124 * z263 - (z130 * z262 - (z266 * z143 - (z148 * z269 - (z123 * z264 - z137 *
        z240))));
    const double z271 = z127 * z251 - (z131 * z254 + (z125 * z256 + (z129 * z257 - (z122 * z259 - (z126 *
        z260 - z270)))));
    const double z272 = (z119 * z250 + (z128 * z239 - z271)) / z149;
    const double z273 = z147 * z269 + z148 * z272;
    /* (I.2.15) */
    dydt[0] = -(c_yaw * z173 + s_yaw * z175); /* x' */
    dydt[1] = c_yaw * z175 - s_yaw * z173; /* y' */
    dydt[2] = e2z * z156 + c_roll * z174; /* z' */
    dydt[3] = z168; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = -z167; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = z165; /* thR' */
    dydt[8] = thF_dot; /* thF' */
    /* (I.2.15) 112:4 */
    dydt[9] = z266 * z112 + z113 * z273 - z143 * z272; /* roll'' */
    dydt[10] = -z273; /* steer'' */
    dydt[11] = -z272; /* thF'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[9] + dydt[10] + dydt[11]) <= DBL_MAX
        && fabs(z37) > 1e-12 * (k22 * ((z38 + k24) * (z38 + k25)))
        && fabs(z114) > 1e-14 * z109
        && fabs(z149) > 1e-14 * z138)) {
        /* the coframe is singular */
        if (!(fabs(z37) > 1e-12 * (k22 * ((z38 + k24) * (z38 + k25))))) {
            return BICYCLE_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z78) > 0.0)) {
            return BICYCLE_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z114) > 1e-14 * z109)) {
            return BICYCLE_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z149) > 1e-14 * z138)) {
            return BICYCLE_SINGULAR_2;
        }
        return bicycle_finish(12, dydt);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW
int bicycle_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double z1 = pitch + lam;
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thF_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = c_lam * k1 - r_R * s_lam;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);
    const double k5 = fabs(r_R);
    const double k6 = fabs(r_F);
    const double k7 = fabs(w);
    const double k8 = fabs(c);
    const double k9 = 9.0 * k6;
    const double k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9));
    const double k11 = 6.0 * k7;
    const double k12 = 13.0 * k8 + (14.0 * k6 + k11);
    const double k13 = 10.0 * k8 + (k9 + k11);

    /* state */
    const double z2 = c_roll * s1;
    const double z3 = e2z * s_steer - c_steer * z2;
    const double z4 = c_roll * c1;
    const double z5 = r_F / sqrt(z4 * z4 + z3 * z3);
    const double z6 = z3 * z5;
    const double z7 = k2 + z6;
    const double z8 = 1.0 / fabs(c_roll);
    const double z9 = r_R * z8;
    const double z10 = z2 * z9;
    const double z11 = k3 + z10 + c_steer * z7;
    const double z12 = s_steer * z2 * z7 + e2z * z11;
    const double z13 = z4 * z9;
    const double z14 = c_steer * z13;
    const double z15 = z4 * z5;
    const double z16 = k4 + z15;
    const double z17 = z13 - z16;
    const double z18 = s_steer * z17;
    const double z19 = c_steer * z17;
    const double z20 = s_steer * z13;
    const double z21 = z14 * z18 - z19 * z20;
    const double z22 = s1 * z16;
    const double z23 = c_roll * (c_steer * z22 + c1 * (c_steer * k3 + z7)) + e2z * z18;
    const double z24 = c_roll * (s_steer * z22 + k3 * (s_steer * c1)) - e2z * z19;
    const double z25 = z14 * z23 + z24 * z20;
    const double z26 = z19 * z23 + z24 * z18;
    const double z27 = z12 * z21 - z11 * z25 + z10 * z26;
    const double z28 = k5 * (9.0 + fabs(z8));
    const double z29 = 1.0 / z27;
    const double z30 = roll_dot * s1;
    const double z31 = steer_dot + z30;
    const double z32 = roll_dot * c1;
    const double z33 = c_steer * z32;
    const double z34 = c_roll * (roll_dot * z9);
    const double z35 = k3 * z30 + z34;
    const double z36 = z31 * z6 - z33 * z15 - (k4 * z33 - k2 * z31 - c_steer * z35);
    const double z37 = s_steer * z32;
    const double z38 = thF_dot - z37;
    const double z39 = z38 * z15 - (k4 * z37 - s_steer * z35);
    const double z40 = z19 * z36 + z18 * z39;
    const double z41 = z23 * z39 - z24 * z36;
    const double z42 = k2 * z37 - z38 * z6;
    const double z43 = z29 * (z12 * z40 - z11 * z41 + z26 * z42);
    const double z44 = z14 * z36 + z20 * z39;
    const double z45 = z29 * (z12 * z44 + z25 * z42 - z10 * z41);
    const double z46 = z29 * (z21 * z42 + z11 * z44 - z10 * z40);
    const double z47 = z43 - (z45 - e2z * z46);
    const double z48 = z10 * z47;
    const double z49 = z13 * z47;
    const double z50 = s1 * z48 + c1 * z49;
    const double z51 = s1 * z49 - c1 * z48;
    const double z52 = c_roll * z34 - e2z * z51;
    /* (I.2.4) */
    qdot[0] = -(c_yaw * z50 + s_yaw * z52); /* x' */
    qdot[1] = c_yaw * z52 - s_yaw * z50; /* y' */
    qdot[2] = e2z * z34 + c_roll * z51; /* z' */
    qdot[3] = z46; /* yaw' */
    qdot[4] = roll_dot; /* roll' */
    qdot[5] = -z45; /* pitch' */
    qdot[6] = steer_dot; /* steer' */
    qdot[7] = z43; /* thR' */
    qdot[8] = thF_dot; /* thF' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[5]) <= DBL_MAX
        && fabs(z27) > 1e-12 * (k10 * ((z28 + k12) * (z28 + k13))))) {
        /* the coframe is singular */
        if (!(fabs(z27) > 1e-12 * (k10 * ((z28 + k12) * (z28 + k13))))) {
            return BICYCLE_SINGULAR_1;
        }
        return bicycle_finish(9, qdot);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW
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
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double z1 = pitch + lam;
    const double s1 = sin(z1);
    const double c1 = cos(z1);
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
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = c_lam * k1 - r_R * s_lam;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);

    /* state */
    const double z2 = 1.0 / fabs(c_roll);
    const double z3 = c_roll * s1;
    const double z4 = r_R * z3;
    const double z5 = z2 * z4;
    const double z6 = c_roll * c1;
    const double z7 = e2z * s_steer - c_steer * z3;
    const double z8 = 1.0 / sqrt(z6 * z6 + z7 * z7);
    const double z9 = r_F * z7;
    const double z10 = z8 * z9;
    const double z11 = k2 + z10;
    const double z12 = s_steer * z11;
    const double z13 = s1 * z12;
    const double z14 = k3 + z5 + c_steer * z11;
    const double z15 = c_roll * z13 + e2z * z14;
    const double z16 = r_R * z6;
    const double z17 = z2 * z16;
    const double z18 = c_steer * z17;
    const double z19 = r_F * z6;
    const double z20 = z8 * z19;
    const double z21 = k4 + z20;
    const double z22 = z17 - z21;
    const double z23 = s_steer * z22;
    const double z24 = c_steer * z22;
    const double z25 = s_steer * z17;
    const double z26 = z18 * z23 - z24 * z25;
    const double z27 = c_steer * z21;
    const double z28 = c_steer * k3 + z11;
    const double z29 = s1 * z27 + c1 * z28;
    const double z30 = c_roll * z29 + e2z * z23;
    const double z31 = s_steer * z21;
    const double z32 = s_steer * k3;
    const double z33 = s1 * z31 + c1 * z32;
    const double z34 = c_roll * z33 - e2z * z24;
    const double z35 = z18 * z30 + z34 * z25;
    const double z36 = z24 * z30 + z34 * z23;
    const double z37 = 1.0 / (z15 * z26 - z14 * z35 + z5 * z36);
    const double z38 = roll_dot * s1;
    const double z39 = steer_dot + z38;
    const double z40 = roll_dot * c1;
    const double z41 = c_steer * z40;
    const double z42 = roll_dot * r_R;
    const double z43 = c_roll * z42;
    const double z44 = z2 * z43;
    const double z45 = z44 + k3 * z38;
    const double z46 = z10 * z39 - z20 * z41 - (k4 * z41 - k2 * z39 - c_steer * z45);
    const double z47 = s_steer * z40;
    const double z48 = thF_dot - z47;
    const double z49 = z20 * z48 - (k4 * z47 - s_steer * z45);
    const double z50 = z24 * z46 + z23 * z49;
    const double z51 = z30 * z49 - z34 * z46;
    const double z52 = k2 * z47 - z10 * z48;
    const double z53 = z15 * z50 - z14 * z51 + z36 * z52;
    const double z54 = z18 * z46 + z25 * z49;
    const double z55 = z15 * z54 + z35 * z52 - z5 * z51;
    const double z56 = z37 * z55;
    const double z57 = z26 * z52 + z14 * z54 - z5 * z50;
    const double z58 = z37 * z57;
    const double z59 = z37 * z53 - (z56 - e2z * z58);
    const double z60 = z5 * z59;
    const double z61 = z17 * z59;
    const double z62 = s1 * z60 + c1 * z61;
    const double z63 = s_yaw * z58;
    const double z64 = c1 * z56;
    const double z65 = roll_dot * e2z;
    const double z66 = z2 * (c_roll * z65) * (z2 * z2);
    const double z67 = z65 * s1 + c_roll * z64;
    const double z68 = r_R * z2;
    const double z69 = z4 * z66 - z67 * z68;
    const double z70 = steer_dot * c_steer;
    const double z71 = s1 * z56;
    const double z72 = z65 * c1 - c_roll * z71;
    const double z73 = roll_dot * c_roll;
    const double z74 = steer_dot * s_steer;
    const double z75 = s_steer * z73 + e2z * z70 + (z74 * z3 + c_steer * z67);
    const double z76 = (z6 * z72 - z7 * z75) * (z8 * (z8 * z8));
    const double z77 = r_F * z8;
    const double z78 = z9 * z76 + z77 * z75;
    const double z79 = z69 - (z74 * z11 - c_steer * z78);
    const double z80 = z65 * z13 + c_roll * (z12 * z64 - s1 * (z70 * z11 + s_steer * z78)) - (z73 * z14 + e2z
        * z79);
    const double z81 = z16 * z66 - z72 * z68;
    const double z82 = z74 * z17 - c_steer * z81;
    const double z83 = z19 * z76 - z77 * z72;
    const double z84 = z81 - z83;
    const double z85 = z70 * z22 + s_steer * z84;
    const double z86 = z74 * z22 - c_steer * z84;
    const double z87 = z70 * z17 + s_steer * z81;
    const double z88 = z23 * z82 - z18 * z85 - (z25 * z86 - z24 * z87);
    const double z89 = z27 * z64 + s1 * (z74 * z21 - c_steer * z83) - (z28 * z71 - c1 * (z74 * k3 - z78));
    const double z90 = z65 * z29 + c_roll * z89 - (z73 * z23 + e2z * z85);
    const double z91 = z31 * z64 - s1 * (z70 * z21 + s_steer * z83) - (z32 * z71 + k3 * (z70 * c1));
    const double z92 = z65 * z33 + c_roll * z91 + (z73 * z24 - e2z * z86);
    const double z93 = z30 * z82 + z18 * z90 + (z25 * z92 - z34 * z87);
    const double z94 = z30 * z86 + z24 * z90 + (z23 * z92 - z34 * z85);
    const double z95 = z26 * z80 + z15 * z88 + (z35 * z79 - z14 * z93) - (z36 * z69 - z5 * z94);
    const double z96 = z37 * z37 * z95;
    const double z97 = roll_dot * z64 - s1 * roll_ddot;
    const double z98 = steer_ddot - z97;
    const double z99 = roll_dot * z71 + c1 * roll_ddot;
    const double z100 = z74 * z40 - c_steer * z99;
    const double z101 = z43 * z66 - z2 * (z65 * z42 - r_R * (c_roll * roll_ddot));
    const double z102 = k3 * z97 - z101;
    const double z103 = z10 * z98 + z39 * z78 + (z20 * z100 - z41 * z83) + (k4 * z100 + k2 * z98 - (z74 * z45
        + c_steer * z102));
    const double z104 = z70 * z40 + s_steer * z99;
    const double z105 = thF_ddot - z104;
    const double z106 = z20 * z105 + z48 * z83 - (k4 * z104 - (z70 * z45 - s_steer * z102));
    const double z107 = z46 * z86 - z24 * z103 - (z49 * z85 + z23 * z106);
    const double z108 = z49 * z90 - z30 * z106 - (z46 * z92 - z34 * z103);
    const double z109 = k2 * z104 - (z10 * z105 + z48 * z78);
    const double z110 = z50 * z80 + z15 * z107 + (z51 * z79 - z14 * z108) + (z52 * z94 - z36 * z109);
    const double z111 = z53 * z96 - z37 * z110;
    const double z112 = z46 * z82 - z18 * z103 - (z49 * z87 + z25 * z106);
    const double z113 = z54 * z80 + z15 * z112 + (z52 * z93 - z35 * z109) + (z51 * z69 - z5 * z108);
    const double z114 = z55 * z96 - z37 * z113;
    const double z115 = z52 * z88 - z26 * z109 - (z54 * z79 - z14 * z112) + (z50 * z69 - z5 * z107);
    const double z116 = z57 * z96 - z37 * z115;
    const double z117 = z111 - (z114 - (z73 * z58 + e2z * z116));
    const double z118 = z59 * z69 + z5 * z117;
    const double z119 = z59 * z81 + z17 * z117;
    const double z120 = z60 * z64 - s1 * z118 - (z61 * z71 + c1 * z119);
    const double z121 = s1 * z61 - c1 * z60;
    const double z122 = c_roll * z44 - e2z * z121;
    const double z123 = c_yaw * z58;
    const double z124 = z61 * z64 - s1 * z119 + (z60 * z71 + c1 * z118);
    const double z125 = z65 * z44 - c_roll * z101 + (z73 * z121 - e2z * z124);
    /* (I.2.15) */
    qddot[0] = z62 * z63 + c_yaw * z120 - (z122 * z123 - s_yaw * z125); /* x'' */
    qddot[1] = -(z62 * z123 - s_yaw * z120 + (z122 * z63 + c_yaw * z125)); /* y'' */
    qddot[2] = z73 * z44 + e2z * z101 - (z65 * z121 + c_roll * z124); /* z'' */
    qddot[3] = z116; /* yaw'' */
    qddot[4] = roll_ddot; /* roll'' */
    qddot[5] = -z114; /* pitch'' */
    qddot[6] = steer_ddot; /* steer'' */
    qddot[7] = z111; /* thR'' */
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
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[3] + y[4] + y[5] + y[6] + y[7] + y[8] + y[9] + y[10] + y[11]) <= DBL_MAX)) {
        return bicycle_finish(12, y);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW
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
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2] + r[3] + r[4] + r[5]) <= DBL_MAX)) {
        return bicycle_finish(6, r);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_reactions_part1(double t, const double *y, const double *p, const double
    *dydt, double *kept, double *lambda)
{
    (void)lambda;
    (void)t;

    /* sines and cosines */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double z1 = pitch + lam;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double s_yaw = sin(yaw);
    kept[0] = s_yaw;
    const double c_yaw = cos(yaw);
    kept[1] = c_yaw;
    const double roll = y[4]; /* second turn, about x [rad] */
    const double e2z = sin(roll);
    kept[2] = e2z;
    const double c_roll = cos(roll);
    kept[3] = c_roll;
    const double s1 = sin(z1);
    kept[4] = s1;
    const double c1 = cos(z1);
    kept[5] = c1;
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double s_steer = sin(steer);
    kept[6] = s_steer;
    const double c_steer = cos(steer);
    kept[7] = c_steer;

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z_B = p[9]; /* [m] */
    const double k1 = r_R + z_B;
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double k2 = w + c;
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double k3 = c + (w - x_H);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k4 = r_F * s_lam - c * c_lam;
    kept[8] = k4;
    const double H_zz = p[21]; /* [kg*m^2] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double k5 = H_zz + F_xx;
    const double H_xx = p[18]; /* [kg*m^2] */
    const double k6 = H_xx + F_xx;
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double k7 = R_xx + B_xx;
    const double B_zz = p[14]; /* [kg*m^2] */
    const double k8 = R_xx + B_zz;
    const double z_H = p[16]; /* [m] */
    const double k9 = z_H * s_lam + c_lam * k3;
    const double k10 = c_lam * k2 - r_R * s_lam;
    kept[9] = k10;
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double k11 = c_lam * k1 + x_B * s_lam;
    const double k12 = x_B * c_lam - s_lam * k1;
    const double k13 = r_R * c_lam;
    const double k14 = s_lam * k2;
    const double k15 = z_H * c_lam - s_lam * k3 + k13 + k14;
    const double k16 = k14 - (r_F * c_lam + c * s_lam - k13);
    kept[10] = k16;
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double m_B = p[10]; /* [kg] */
    const double k17 = m_R + m_B;
    kept[11] = k17;
    const double k18 = m_B * k11;
    kept[12] = k18;
    const double k19 = m_B * k12;
    kept[13] = k19;
    const double B_xz = p[12]; /* [kg*m^2] */
    const double k20 = B_xz * c_lam;
    const double k21 = s_lam * k8 - k20;
    const double k22 = B_xz * s_lam;
    const double k23 = c_lam * k7 - k22;
    const double k24 = k11 * k18;
    const double k25 = s_lam * k21 + c_lam * k23 + k24;
    kept[14] = k25;
    const double k26 = c_lam * k21 - s_lam * k23 + k12 * k18;
    kept[15] = k26;
    const double k27 = k12 * k19;
    const double B_yy = p[13]; /* [kg*m^2] */
    const double k28 = k24 + (B_yy + k27);
    kept[16] = k28;
    const double k29 = k22 + c_lam * k8;
    const double k30 = k20 + s_lam * k7;
    const double k31 = s_lam * k29 - c_lam * k30 + k11 * k19;
    kept[17] = k31;
    const double k32 = k27 + (c_lam * k29 + s_lam * k30);
    kept[18] = k32;
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double k33 = m_F * k16;
    const double m_H = p[17]; /* [kg] */
    const double k34 = m_H + m_F;
    kept[19] = k34;
    const double k35 = m_H * k15;
    const double k36 = k33 + k35;
    kept[20] = k36;
    const double k37 = m_F * k4;
    const double k38 = m_H * k9;
    const double k39 = k37 - k38;
    kept[21] = k39;
    const double H_xz = p[19]; /* [kg*m^2] */
    const double k40 = H_xz * c_lam;
    const double k41 = s_lam * k5 - k40;
    const double k42 = H_xz * s_lam;
    const double k43 = c_lam * k6 - k42;
    const double k44 = k16 * k33;
    const double k45 = k15 * k35;
    const double k46 = s_lam * k41 + c_lam * k43 + k44 + k45;
    kept[22] = k46;
    const double k47 = c_lam * k41 - s_lam * k43 + k4 * k33 - k9 * k35;
    kept[23] = k47;
    const double k48 = k4 * k37;
    const double k49 = k9 * k38;
    const double H_yy = p[20]; /* [kg*m^2] */
    const double k50 = k45 + (k44 + (H_yy + k48) + k49);
    kept[24] = k50;
    const double k51 = k42 + c_lam * k5;
    const double k52 = k40 + s_lam * k6;
    const double k53 = s_lam * k51 - c_lam * k52 + k16 * k37 - k15 * k38;
    kept[25] = k53;
    const double k54 = k49 + (k48 + (c_lam * k51 + s_lam * k52));
    kept[26] = k54;
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double k55 = g * m_F;
    const double k56 = g * m_H;
    const double k57 = g * m_B;
    const double k58 = g * k17;
    kept[27] = k58;
    const double k59 = k12 * k57;
    kept[28] = k59;
    const double k60 = k11 * k57;
    kept[29] = k60;
    const double k61 = k9 * k56;
    kept[30] = k61;
    const double k62 = k15 * k56;
    kept[31] = k62;
    const double k63 = g * k34;
    kept[32] = k63;
    const double k64 = k4 * k55;
    kept[33] = k64;
    const double k65 = k16 * k55;
    kept[34] = k65;
    const double k66 = k62 + k65;
    kept[35] = k66;
    const double k67 = k61 - k64;
    kept[36] = k67;

    /* state */
    const double z2 = 1.0 / fabs(c_roll);
    kept[37] = z2;
    const double z3 = c_roll * c1;
    kept[38] = z3;
    const double z4 = r_R * z3;
    kept[39] = z4;
    const double z5 = z2 * z4;
    kept[40] = z5;
    const double z6 = c_roll * s1;
    kept[41] = z6;
    const double z7 = e2z * s_steer - c_steer * z6;
    kept[42] = z7;
    const double z8 = 1.0 / sqrt(z3 * z3 + z7 * z7);
    kept[43] = z8;
    const double z9 = r_F * z7;
    kept[44] = z9;
    const double z10 = z8 * z9;
    kept[45] = z10;
    const double z11 = k4 + z10;
    kept[46] = z11;
    const double z12 = s_steer * z11;
    kept[47] = z12;
    const double z13 = s1 * z12;
    kept[48] = z13;
    const double z14 = r_R * z6;
    kept[49] = z14;
    const double z15 = z2 * z14;
    kept[50] = z15;
    const double z16 = k10 + z15 + c_steer * z11;
    kept[51] = z16;
    const double z17 = c_roll * z13 + e2z * z16;
    kept[52] = z17;
    const double z18 = c_steer * z5;
    kept[53] = z18;
    const double z19 = r_F * z3;
    kept[54] = z19;
    const double z20 = z8 * z19;
    kept[55] = z20;
    const double z21 = k16 + z20;
    kept[56] = z21;
    const double z22 = z5 - z21;
    kept[57] = z22;
    const double z23 = s_steer * z22;
    kept[58] = z23;
    const double z24 = c_steer * z22;
    kept[59] = z24;
    const double z25 = s_steer * z5;
    kept[60] = z25;
    const double z26 = z18 * z23 - z24 * z25;
    kept[61] = z26;
    const double z27 = c_steer * z21;
    kept[62] = z27;
    const double z28 = c_steer * k10 + z11;
    kept[63] = z28;
    const double z29 = s1 * z27 + c1 * z28;
    kept[64] = z29;
    const double z30 = c_roll * z29 + e2z * z23;
    kept[65] = z30;
    const double z31 = s_steer * z21;
    kept[66] = z31;
    const double z32 = s_steer * k10;
    kept[67] = z32;
    const double z33 = s1 * z31 + c1 * z32;
    kept[68] = z33;
    const double z34 = c_roll * z33 - e2z * z24;
    kept[69] = z34;
    const double z35 = z18 * z30 + z34 * z25;
    kept[70] = z35;
    const double z36 = z24 * z30 + z34 * z23;
    kept[71] = z36;
    const double z37 = 1.0 / (z17 * z26 - z16 * z35 + z15 * z36);
    kept[72] = z37;
    const double z38 = z20 * z23;
    const double z39 = z20 * z30;
    const double z40 = z20 * z25;
    const double z41 = z37 * (z10 * z26 - z16 * z40 + z15 * z38);
    kept[73] = z41;
    const double z42 = z37 * (z17 * z40 - z10 * z35 - z15 * z39) + e2z * z41;
    kept[74] = z42;
    const double z43 = z37 * (z17 * z38 - z16 * z39 - z10 * z36) - z42;
    kept[75] = z43;
    const double z44 = z5 * z43;
    kept[76] = z44;
    const double z45 = c_steer * c1;
    const double z46 = r_R * c_roll;
    kept[77] = z46;
    const double z47 = z46 * z2;
    kept[78] = z47;
    const double z48 = k10 * s1 + z47;
    const double z49 = s1 * z10 - z20 * z45 - (k16 * z45 - k4 * s1 - c_steer * z48);
    const double z50 = s_steer * c1;
    const double z51 = z20 * z50 + (k16 * z50 - s_steer * z48);
    const double z52 = z24 * z49 - z23 * z51;
    const double z53 = z30 * z51 + z34 * z49;
    const double z54 = z11 * z50;
    const double z55 = z18 * z49 - z25 * z51;
    const double z56 = z37 * (z26 * z54 + z16 * z55 - z15 * z52);
    kept[79] = z56;
    const double z57 = z37 * (z17 * z55 + z35 * z54 + z15 * z53) - e2z * z56;
    kept[80] = z57;
    const double z58 = z37 * (z17 * z52 + z16 * z53 + z36 * z54) - z57;
    kept[81] = z58;
    const double z59 = z5 * z58;
    kept[82] = z59;
    const double z60 = z24 * z11;
    const double z61 = z34 * z11;
    const double z62 = z18 * z11;
    const double z63 = z37 * (z16 * z62 - z15 * z60);
    kept[83] = z63;
    const double z64 = z37 * (z17 * z62 + z15 * z61) - e2z * z63;
    kept[84] = z64;
    const double z65 = z37 * (z17 * z60 + z16 * z61) - z64;
    kept[85] = z65;
    const double z66 = z5 * z65;
    kept[86] = z66;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */
    const double z67 = z44 * thF_ddot + (z59 * roll_ddot + z66 * steer_ddot);
    kept[87] = z67;
    const double z68 = z42 * thF_ddot + (z57 * roll_ddot + z64 * steer_ddot);
    kept[88] = z68;
    const double roll_dot = y[9];
    const double z69 = roll_dot * s1;
    kept[89] = z69;
    const double steer_dot = y[10];
    const double z70 = steer_dot + z69;
    kept[90] = z70;
    const double z71 = roll_dot * c1;
    kept[91] = z71;
    const double z72 = c_steer * z71;
    kept[92] = z72;
    const double z73 = roll_dot * r_R;
    kept[93] = z73;
    const double z74 = c_roll * z73;
    kept[94] = z74;
    const double z75 = z2 * z74 + k10 * z69;
    kept[95] = z75;
    const double z76 = z10 * z70 - z20 * z72 - (k16 * z72 - k4 * z70 - c_steer * z75);
    const double z77 = s_steer * z71;
    const double thF_dot = y[11];
    const double z78 = thF_dot - z77;
    kept[96] = z78;
    const double z79 = z20 * z78 - (k16 * z77 - s_steer * z75);
    const double z80 = z18 * z76 + z25 * z79;
    kept[97] = z80;
    const double z81 = k4 * z77 - z10 * z78;
    kept[98] = z81;
    const double z82 = z30 * z79 - z34 * z76;
    kept[99] = z82;
    const double z83 = z37 * (z17 * z80 + z35 * z81 - z15 * z82);
    kept[100] = z83;
    const double z84 = z24 * z76 + z23 * z79;
    kept[101] = z84;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_reactions_part2(double t, const double *y, const double *p, const double
    *dydt, double *kept, double *lambda)
{
    (void)t;
    const double z15 = kept[50];
    const double z16 = kept[51];
    const double z26 = kept[61];
    const double z37 = kept[72];
    const double z80 = kept[97];
    const double z81 = kept[98];
    const double z84 = kept[101];
    const double z85 = z37 * (z26 * z81 + z16 * z80 - z15 * z84);
    const double e2z = kept[2];
    const double z83 = kept[100];
    const double z86 = z83 - e2z * z85;
    const double k19 = kept[13];
    const double z87 = k19 * z86;
    const double c_roll = kept[3];
    const double z88 = c_roll * z85;
    const double c1 = kept[5];
    const double z69 = kept[89];
    const double z89 = z69 + c1 * z88;
    const double s1 = kept[4];
    const double z71 = kept[91];
    const double z90 = z71 - s1 * z88;
    const double k18 = kept[12];
    const double z91 = k18 * z90 - k19 * z89;
    const double z17 = kept[52];
    const double z36 = kept[71];
    const double z82 = kept[99];
    const double z92 = z37 * (z17 * z84 - z16 * z82 + z36 * z81);
    const double z93 = z92 - z86;
    const double z94 = z15 * z93;
    const double roll_dot = y[9];
    const double z47 = kept[78];
    const double v2_x = roll_dot * z47;
    const double z95 = roll_dot * e2z;
    const double z2 = kept[37];
    const double z96 = z95 * z2;
    const double z97 = z96 / c_roll;
    const double z98 = s1 * z83;
    const double z99 = z95 * c1 - c_roll * z98;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z100 = r_R * z2;
    const double z4 = kept[39];
    const double z101 = z4 * z97 - z99 * z100;
    const double z102 = c1 * z83;
    const double z103 = roll_dot * z102;
    const double z104 = roll_dot * c_roll;
    const double steer_dot = y[10];
    const double c_steer = kept[7];
    const double z105 = steer_dot * c_steer;
    const double s_steer = kept[6];
    const double z106 = steer_dot * s_steer;
    const double z107 = z95 * s1 + c_roll * z102;
    const double z6 = kept[41];
    const double z108 = s_steer * z104 + e2z * z105 + (z106 * z6 + c_steer * z107);
    const double z3 = kept[38];
    const double z7 = kept[42];
    const double z8 = kept[43];
    const double z109 = (z3 * z99 - z7 * z108) * (z8 * (z8 * z8));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z110 = r_F * z8;
    const double z9 = kept[44];
    const double z111 = z9 * z109 + z110 * z108;
    const double z112 = roll_dot * z98;
    const double z113 = z106 * z71 - c_steer * z112;
    const double z19 = kept[54];
    const double z114 = z19 * z109 - z110 * z99;
    const double k10 = kept[9];
    const double z73 = kept[93];
    const double z74 = kept[94];
    const double z115 = k10 * z103 - (z74 * z97 - z73 * z96);
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z10 = kept[45];
    const double z20 = kept[55];
    const double z70 = kept[90];
    const double z72 = kept[92];
    const double z75 = kept[95];
    const double z116 = z10 * z103 - z70 * z111 - (z20 * z113 - z72 * z114) - (k16 * z113 - k4 * z103 - (z106
        * z75 + c_steer * z115));
    const double z21 = kept[56];
    const double z27 = kept[62];
    const double z28 = kept[63];
    const double z117 = z27 * z102 + s1 * (z106 * z21 - c_steer * z114) - (z28 * z98 - c1 * (z106 * k10 -
        z111));
    const double z118 = z114 - z101;
    const double z22 = kept[57];
    const double z119 = z105 * z22 - s_steer * z118;
    const double z5 = kept[40];
    const double z23 = kept[58];
    const double z29 = kept[64];
    const double z120 = z92 * (z105 * z5 + s_steer * z101) - (z85 * (z95 * z29 + c_roll * z117 - (z104 * z23
        + e2z * z119)) + z83 * z119);
    const double z121 = z116 - z120;
    const double z122 = z105 * z71 + s_steer * z112;
    const double z31 = kept[66];
    const double z32 = kept[67];
    const double z123 = z31 * z102 - s1 * (z105 * z21 + s_steer * z114) - (z32 * z98 + k10 * (z105 * c1));
    const double z124 = z106 * z22 + c_steer * z118;
    const double z24 = kept[59];
    const double z33 = kept[68];
    const double z125 = z92 * (z106 * z5 - c_steer * z101) - (z85 * (z95 * z33 + c_roll * z123 + (z104 * z24
        - e2z * z124)) + z83 * z124);
    const double z78 = kept[96];
    const double z126 = z20 * z122 - z78 * z114 + (k16 * z122 - (z105 * z75 - s_steer * z115)) - z125;
    const double z127 = z24 * z121 + z23 * z126;
    const double z30 = kept[65];
    const double z34 = kept[69];
    const double z128 = z30 * z126 - z34 * z121;
    const double z14 = kept[49];
    const double z129 = z14 * z97 - z107 * z100;
    const double z11 = kept[46];
    const double z130 = z106 * z11 - c_steer * z111 - z129;
    const double z12 = kept[47];
    const double z13 = kept[48];
    const double z131 = z95 * z13 + c_roll * (z12 * z102 - s1 * (z105 * z11 + s_steer * z111)) - (z104 * z16
        - e2z * z130);
    const double z132 = k4 * z122 + (z10 * z122 - z78 * z111) - (z92 * z129 - (z85 * z131 - z83 * z130));
    const double z18 = kept[53];
    const double z25 = kept[60];
    const double z133 = z18 * z121 + z25 * z126;
    const double z134 = z37 * (z26 * z132 - z16 * z133 + z15 * z127);
    const double z35 = kept[70];
    const double z135 = z37 * (z17 * z133 - z35 * z132 - z15 * z128) + (z104 * z85 + e2z * z134);
    const double z136 = z37 * (z17 * z127 - z16 * z128 - z36 * z132) - z135;
    const double z137 = z86 * z94 - v2_x * z89 - (z93 * z101 - z5 * z136);
    const double k17 = kept[11];
    const double k58 = kept[27];
    const double z67 = kept[87];
    const double z68 = kept[88];
    const double z138 = k17 * z67 + k18 * z68 - (z6 * k58 - (z86 * z87 - z89 * z91 - (k17 * z137 + k18 *
        z135)));
    const double z41 = kept[73];
    const double z139 = c_roll * z41;
    const double z140 = c1 * z139;
    const double thF_ddot = dydt[11]; /* thF'' */
    const double z141 = z140 * thF_ddot;
    const double z56 = kept[79];
    const double z142 = c_roll * z56;
    const double z143 = s1 + c1 * z142;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double z144 = z143 * roll_ddot;
    const double z63 = kept[83];
    const double z145 = c_roll * z63;
    const double z146 = c1 * z145;
    const double steer_ddot = dydt[10]; /* steer'' */
    const double z147 = z141 - (z144 + (1.0 + z146) * steer_ddot);
    const double z148 = k10 * z140;
    const double z149 = z47 + k10 * z143;
    const double z150 = k10 * z146;
    const double z44 = kept[76];
    const double z59 = kept[82];
    const double z66 = kept[86];
    const double z151 = (c_steer * z148 - s_steer * z44) * thF_ddot - ((c_steer * z149 + s_steer * z59) *
        roll_ddot + (c_steer * z150 + s_steer * z66) * steer_ddot);
    const double z152 = s1 * z139;
    const double z153 = c1 - s1 * z142;
    const double z154 = s1 * z145;
    const double z42 = kept[74];
    const double z57 = kept[80];
    const double z64 = kept[84];
    const double z155 = (s_steer * z42 - c_steer * z152) * thF_ddot + ((s_steer * z57 - c_steer * z153) *
        roll_ddot + (s_steer * z64 + c_steer * z154) * steer_ddot);
    const double h2z = e2z * c_steer + s_steer * z6;
    const double w3_steer = steer_dot + z89;
    const double z156 = c_steer * z86 + s_steer * z90;
    const double k36 = kept[20];
    const double z157 = k36 * z156;
    const double z158 = s_steer * z86 - c_steer * z90;
    const double k39 = kept[21];
    const double z159 = k39 * z156;
    const double z160 = z95 * z85 - c_roll * z134;
    const double z161 = z103 - (z88 * z98 - c1 * z160);
    const double z162 = z5 * z93;
    const double z46 = kept[77];
    const double z163 = z162 * z89 - z94 * z90 + roll_dot * (z95 * z100 - z46 * z97);
    const double z164 = k10 * z86;
    const double z165 = z163 + (z164 * z90 + k10 * z161);
    const double z166 = k10 * z89;
    const double z167 = z86 * z164 + z89 * z166 - z137;
    const double z168 = c_steer * z165 - s_steer * z167;
    const double z169 = z112 + (z88 * z102 + s1 * z160);
    const double z170 = z105 * z86 - s_steer * z135 + (z106 * z90 - c_steer * z169);
    const double k34 = kept[19];
    const double k63 = kept[32];
    const double z171 = h2z * k63 + (w3_steer * z157 - z158 * z159 + (k39 * z161 + (k34 * z168 - k36 *
        z170)));
    const double z172 = k39 * z147 + (k34 * z151 - k36 * z155) + z171;
    const double z173 = (c_steer * z44 + s_steer * z148) * thF_ddot + ((c_steer * z59 - s_steer * z149) *
        roll_ddot + (c_steer * z66 - s_steer * z150) * steer_ddot);
    const double z174 = c_steer * z42 + s_steer * z152;
    const double z175 = (c_steer * z57 + s_steer * z153) * roll_ddot + (c_steer * z64 - s_steer * z154) *
        steer_ddot;
    const double z176 = z174 * thF_ddot + z175;
    const double z177 = k36 * z158 + k39 * w3_steer;
    const double z178 = c_steer * z167 + s_steer * z165;
    const double z179 = z106 * z86 + c_steer * z135 - (z105 * z90 + s_steer * z169);
    const double z180 = k34 * z173 + k36 * z176 + (z7 * k63 + (z156 * z159 + w3_steer * z177 + (k34 * z178 -
        k36 * z179)));
    const double z181 = z138 - s_steer * z172 + c_steer * z180;
    const double z43 = kept[75];
    const double z182 = z15 * z43;
    const double z58 = kept[81];
    const double z183 = z15 * z58;
    const double z65 = kept[85];
    const double z184 = z15 * z65;
    const double z185 = z182 * thF_ddot + (z183 * roll_ddot + z184 * steer_ddot);
    const double z186 = k18 * z86;
    const double z187 = v2_x * z90 - z86 * z162 - (z93 * z129 - z15 * z136);
    const double z188 = k17 * z185 - k19 * z68 + (z3 * k58 + (z90 * z91 + z86 * z186 - (k17 * z187 - k19 *
        z135)));
    const double z189 = (z182 - k10 * z42) * thF_ddot + ((z183 - k10 * z57) * roll_ddot + (z184 - k10 * z64)
        * steer_ddot);
    const double z190 = z187 + (z90 * z166 - k10 * z135);
    const double z191 = k34 * z189 - k39 * z176 + (z3 * k63 + (z158 * z177 + z156 * z157 - (k34 * z190 - k39
        * z179)));
    const double z192 = z188 + z191;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double z193 = R_yy * (z43 * thF_ddot + (z58 * roll_ddot + z65 * steer_ddot) - z136) + z15 * z192 +
        z5 * z181;
    const double z194 = z37 * z193;
    const double k25 = kept[14];
    const double k26 = kept[15];
    const double z195 = k25 * z90 - k26 * z89;
    const double k31 = kept[17];
    const double k32 = kept[18];
    const double z196 = k31 * z90 - k32 * z89;
    const double k28 = kept[16];
    const double k59 = kept[28];
    const double k60 = kept[29];
    const double z197 = z6 * k60 + z3 * k59 + (z89 * z195 + z90 * z196 + (k28 * z135 + (k18 * z137 - k19 *
        z187)));
    const double k46 = kept[22];
    const double k47 = kept[23];
    const double z198 = k46 * z158 + k47 * w3_steer;
    const double k53 = kept[25];
    const double k54 = kept[26];
    const double z199 = k53 * z158 + k54 * w3_steer;
    const double k50 = kept[24];
    const double k61 = kept[30];
    const double k62 = kept[31];
    const double k64 = kept[33];
    const double k65 = kept[34];
    const double z200 = z7 * k62 + z3 * k61 + (z7 * k65 - z3 * k64) + (w3_steer * z198 - z158 * z199 - (k50 *
        z179 - (k36 * z178 + k39 * z190)));
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z201 = k50 * z176 + (k36 * z173 - k39 * z189) + z200 + F_yy * (z175 - (1.0 - z174) *
        thF_ddot - z179);
    const double thF_dot = y[11];
    const double z202 = F_yy * (thF_dot - z156) - k50 * z156;
    const double k66 = kept[35];
    const double z203 = h2z * k66 - (z156 * z199 + w3_steer * z202 - (k47 * z161 + (k36 * z168 - k46 *
        z170)));
    const double z204 = k47 * z147 + (k36 * z151 - k46 * z155) + z203;
    const double z205 = k28 * z68 + (k18 * z67 - k19 * z185) - z197 - k10 * z191 + c_steer * z201 - s_steer *
        z204;
    const double z206 = z205 - z193;
    const double z207 = z37 * z206;
    const double z208 = z16 * z194 + z15 * z207;
    const double z209 = z141 - (z144 + z146 * steer_ddot);
    const double z210 = z47 * roll_ddot;
    const double z211 = z152 * thF_ddot + (z153 * roll_ddot - z154 * steer_ddot);
    const double z212 = R_yy * z93 - k28 * z86;
    const double z213 = e2z * k60 + (z86 * z196 - z89 * z212 + (k26 * z161 + (k18 * z163 + k25 * z169)));
    const double z214 = s1 * (k26 * z209 - (k18 * z210 - k25 * z211) + z213 + s_steer * z201 + c_steer *
        z204);
    const double k67 = kept[36];
    const double z215 = h2z * k67 - (z158 * z202 + z156 * z198 + (k54 * z161 + (k39 * z168 - k53 * z170)));
    const double z216 = e2z * k59 - (z90 * z212 + z86 * z195 - (k32 * z161 + (k19 * z163 + k31 * z169)));
    const double z217 = c_steer * z172 + s_steer * z180;
    const double z218 = k54 * z147 + (k39 * z151 - k53 * z155) - z215 + (k32 * z209 - (k19 * z210 - k31 *
        z211) + z216 + k10 * z217);
    const double z219 = z37 * (c_roll * (z214 + c1 * z218) + e2z * z206);
    const double z220 = z17 * z194 + z15 * z219;
    const double z221 = z17 * z207 - z16 * z219;
    const double z222 = z30 * z208 - z23 * z220 - z25 * z221;
    const double z223 = c_steer * z222;
    const double z224 = z34 * z208 + z24 * z220 + z18 * z221;
    const double z225 = s_steer * z224;
    const double z226 = z181 + z223 + z225;
    const double z227 = z36 * z194 + z35 * z207 - z26 * z219;
    const double z228 = z192 - z227;
    const double z229 = s1 * z226 - c1 * z228;
    const double z230 = e2z * k58 + (z89 * z186 + z90 * z87 + (k19 * z161 + (k17 * z163 + k18 * z169)));
    const double z231 = s_steer * z222 - c_steer * z224;
    const double z232 = k19 * z209 - (k17 * z210 - k18 * z211) + z230 + z217 + z231;
    const double z233 = e2z * z229 + c_roll * z232;
    const double z234 = c1 * z226 + s1 * z228;
    const double s_yaw = kept[0];
    const double c_yaw = kept[1];
    /* (I.4.1) 115:5 */
    lambda[0] = s_yaw * z233 - c_yaw * z234; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 116:5 */
    lambda[1] = -(c_yaw * z233 + s_yaw * z234); /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 117:5 */
    lambda[2] = c_roll * z229 - e2z * z232; /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z235 = z223 + z225;
    const double z236 = s1 * z235 + c1 * z227;
    const double z237 = e2z * z236 + c_roll * z231;
    const double z238 = c1 * z235 - s1 * z227;
    /* (I.4.1) 118:5 */
    lambda[3] = c_yaw * z238 - s_yaw * z237; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    /* (I.4.1) 119:5 */
    lambda[4] = c_yaw * z237 + s_yaw * z238; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    /* (I.4.1) 120:5 */
    lambda[5] = e2z * z231 - c_roll * z236; /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return BICYCLE_OK;
}

BICYCLE_SLOW
int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[102]; /* what parts of this function leave for others */
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

BICYCLE_SLOW
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
    const double k6 = s_lam * k2 - (r_F * c_lam + c * s_lam - r_R * c_lam);

    /* state */
    const double z1 = s_pitch * c_roll;
    const double e3z = c_pitch * c_roll;
    const double Sz = z - z1 * k2 + r_R * e3z;
    const double z2 = z1 * c_lam + e3z * s_lam;
    const double z3 = e2z * s_steer;
    const double z4 = c_steer * z2 - z3;
    const double z5 = z1 * s_lam - e3z * c_lam;
    const double z6 = c_lam * z4 + s_lam * z5;
    const double z7 = c_lam * z5 - s_lam * z4;
    const double z8 = z * m_R + m_B * (z - x_B * z1 + e3z * k1) + m_H * (Sz + z6 * k3 - z_H * z7);
    const double z9 = s_pitch * c_lam + c_pitch * s_lam;
    const double z10 = c_roll * z9;
    const double z11 = r_R / fabs(c_roll);
    const double z12 = z10 * z11;
    const double z13 = z3 - c_steer * z10;
    const double z14 = c_pitch * c_lam - s_pitch * s_lam;
    const double z15 = c_roll * z14;
    const double z16 = r_F / sqrt(z15 * z15 + z13 * z13);
    const double z17 = z13 * z16;
    const double z18 = k4 + z17;
    const double z19 = k5 + z12 + c_steer * z18;
    const double z20 = z18 * (s_steer * z10) + e2z * z19;
    const double z21 = z15 * z11;
    const double z22 = c_steer * z21;
    const double z23 = z15 * z16;
    const double z24 = k6 + z23;
    const double z25 = z21 - z24;
    const double z26 = s_steer * z25;
    const double z27 = c_steer * z25;
    const double z28 = s_steer * z21;
    const double z29 = z22 * z26 - z27 * z28;
    const double z30 = z9 * z24;
    const double z31 = c_roll * (c_steer * z30 + z14 * (c_steer * k5 + z18)) + e2z * z26;
    const double z32 = c_roll * (s_steer * z30 + k5 * (s_steer * z14)) - e2z * z27;
    const double z33 = z22 * z31 + z32 * z28;
    const double z34 = z27 * z31 + z32 * z26;
    const double z35 = 1.0 / (z20 * z29 - z19 * z33 + z12 * z34);
    const double z36 = roll_dot * z9;
    const double z37 = steer_dot + z36;
    const double z38 = roll_dot * z14;
    const double z39 = c_steer * z38;
    const double z40 = roll_dot * c_roll;
    const double z41 = z40 * z11;
    const double z42 = k5 * z36 + z41;
    const double z43 = z37 * z17 - z39 * z23 - (k6 * z39 - k4 * z37 - c_steer * z42);
    const double z44 = s_steer * z38;
    const double z45 = thF_dot - z44;
    const double z46 = z45 * z23 - (k6 * z44 - s_steer * z42);
    const double z47 = z27 * z43 + z26 * z46;
    const double z48 = z31 * z46 - z32 * z43;
    const double z49 = k4 * z44 - z45 * z17;
    const double z50 = z22 * z43 + z28 * z46;
    const double z51 = z35 * (z20 * z50 + z33 * z49 - z12 * z48);
    const double z52 = z35 * (z29 * z49 + z19 * z50 - z12 * z47);
    const double z53 = z51 - e2z * z52;
    const double z54 = z35 * (z20 * z47 - z19 * z48 + z34 * z49) - z53;
    const double z55 = z12 * z54;
    const double z56 = z21 * z54;
    const double z57 = z9 * z55 + z14 * z56;
    const double z58 = z9 * z56 - z14 * z55;
    const double z59 = c_roll * z41 - e2z * z58;
    const double z60 = c_yaw * z57 + s_yaw * z59;
    const double z61 = s_yaw * z52;
    const double z62 = s_pitch * z51;
    const double z63 = c_yaw * z52;
    const double z64 = s_yaw * z40 + e2z * z63;
    const double z65 = s_yaw * e2z;
    const double z66 = c_pitch * z51;
    const double z67 = c_pitch * z61 - c_yaw * z62 + (s_pitch * z64 - z65 * z66);
    const double z68 = s_pitch * z61 + c_yaw * z66 - (z65 * z62 + c_pitch * z64);
    const double z69 = z60 + k2 * z67 + r_R * z68;
    const double z70 = steer_dot * s_steer;
    const double z71 = ((c_yaw * c_pitch - z65 * s_pitch) * c_lam - (c_yaw * s_pitch + c_pitch * z65) *
        s_lam) * z70 + c_steer * (c_lam * z67 - s_lam * z68);
    const double z72 = steer_dot * c_steer;
    const double z73 = c_roll * z72;
    const double z74 = roll_dot * e2z;
    const double z75 = z71 + (s_yaw * z73 - s_steer * (s_yaw * z74 - c_roll * z63));
    const double z76 = s_lam * z67 + c_lam * z68;
    const double z77 = c_lam * z75 + s_lam * z76;
    const double z78 = c_lam * z76 - s_lam * z75;
    const double z79 = z69 - c * z77 - r_F * z78;
    const double z80 = s_yaw * z57 - c_yaw * z59;
    const double z81 = c_yaw * e2z;
    const double z82 = c_yaw * z40 - e2z * z61;
    const double z83 = s_yaw * z62 + c_pitch * z63 - (z81 * z66 - s_pitch * z82);
    const double z84 = s_pitch * z63 - s_yaw * z66 - (z81 * z62 + c_pitch * z82);
    const double z85 = z80 - k2 * z83 - r_R * z84;
    const double z86 = ((c_pitch * s_yaw + s_pitch * z81) * c_lam - (s_yaw * s_pitch - c_pitch * z81) *
        s_lam) * z70 - c_steer * (c_lam * z83 - s_lam * z84);
    const double z87 = z86 - (c_yaw * z73 - s_steer * (c_yaw * z74 + c_roll * z61));
    const double z88 = s_lam * z83 + c_lam * z84;
    const double z89 = c_lam * z87 - s_lam * z88;
    const double z90 = c_lam * z88 + s_lam * z87;
    const double z91 = z85 - c * z89 + r_F * z90;
    const double z92 = e2z * z41 + c_roll * z58;
    const double z93 = s_pitch * z74 + c_roll * z66;
    const double z94 = c_pitch * z74 - c_roll * z62;
    const double z95 = z92 + k2 * z93 - r_R * z94;
    const double z96 = s_steer * z40 + e2z * z72 + (z2 * z70 + c_steer * (c_lam * z93 + s_lam * z94));
    const double z97 = s_lam * z93 - c_lam * z94;
    const double z98 = c_lam * z96 + s_lam * z97;
    const double z99 = c_lam * z97 - s_lam * z96;
    const double Fz_dot = z95 - c * z98 - r_F * z99;
    const double w1 = roll_dot * c_pitch - z1 * z52;
    const double w3 = roll_dot * s_pitch + e3z * z52;
    const double z100 = c_lam * w1 - s_lam * w3;
    const double z101 = s_steer * z53 - c_steer * z100;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double z102 = c_lam * z101 - s_lam * ws;
    const double z103 = z102 * z102;
    const double o3 = c_lam * ws + s_lam * z101;
    const double z104 = o3 * o3;
    const double z105 = c_steer * z53 + s_steer * z100;
    const double z106 = thF_dot - z105;
    const double z107 = m_F * (z79 * z79 + z91 * z91 + Fz_dot * Fz_dot) + F_xx * (z103 + z104) + F_yy * (z106
        * z106);
    const double z108 = z69 - k3 * z77 + z_H * z78;
    const double z109 = z85 - k3 * z89 - z_H * z90;
    const double Hz_dot = z95 - k3 * z98 + z_H * z99;
    const double z110 = m_H * (z108 * z108 + z109 * z109 + Hz_dot * Hz_dot) + (H_xx * z103 + H_yy * (z105 *
        z105) + H_zz * z104);
    const double z111 = w1 * w1;
    const double z112 = w3 * w3;
    const double z113 = m_R * (z60 * z60 + z80 * z80 + z92 * z92) + R_xx * (z111 + z112) + R_yy * (z54 * z54);
    const double z114 = z60 + x_B * z67 + k1 * z68;
    const double z115 = z80 - x_B * z83 - k1 * z84;
    const double Bz_dot = z92 + x_B * z93 - k1 * z94;
    const double z116 = m_B * (z114 * z114 + z115 * z115 + Bz_dot * Bz_dot) + (B_xx * z111 + B_yy * (z53 *
        z53) + B_zz * z112);
    const double z117 = 0.5 * z110 - H_xz * (z102 * o3) + (0.5 * z113 + (0.5 * z116 + B_xz * (w1 * w3)));
    return 0.5 * z107 + z117 - g * (z8 + m_F * (Sz + c * z6 + r_F * z7));
}

BICYCLE_SLOW static int bicycle_jacobian_part1(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)J;
    (void)t;

    /* sines and cosines */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double z1 = pitch + lam;
    const double roll = y[4]; /* second turn, about x [rad] */
    const double c_roll = cos(roll);
    kept[0] = c_roll;
    const double e2z = sin(roll);
    kept[1] = e2z;
    const double s1 = sin(z1);
    kept[2] = s1;
    const double c1 = cos(z1);
    kept[3] = c1;
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double s_steer = sin(steer);
    kept[4] = s_steer;
    const double c_steer = cos(steer);
    kept[5] = c_steer;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double s_yaw = sin(yaw);
    kept[6] = s_yaw;
    const double c_yaw = cos(yaw);
    kept[7] = c_yaw;

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z_B = p[9]; /* [m] */
    const double k1 = r_R + z_B;
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double k2 = w + c;
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double k3 = c + (w - x_H);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k4 = r_F * s_lam - c * c_lam;
    kept[8] = k4;
    const double H_zz = p[21]; /* [kg*m^2] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double k5 = H_zz + F_xx;
    const double H_xx = p[18]; /* [kg*m^2] */
    const double k6 = H_xx + F_xx;
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double k7 = R_xx + B_xx;
    const double B_zz = p[14]; /* [kg*m^2] */
    const double k8 = R_xx + B_zz;
    const double z_H = p[16]; /* [m] */
    const double k9 = z_H * s_lam + c_lam * k3;
    const double k10 = c_lam * k2 - r_R * s_lam;
    kept[9] = k10;
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double k11 = c_lam * k1 + x_B * s_lam;
    const double k12 = x_B * c_lam - s_lam * k1;
    const double k13 = r_R * c_lam;
    const double k14 = s_lam * k2;
    const double k15 = z_H * c_lam - s_lam * k3 + k13 + k14;
    const double k16 = k14 - (r_F * c_lam + c * s_lam - k13);
    kept[10] = k16;
    const double k17 = fabs(r_R);
    const double k18 = fabs(r_F);
    const double k19 = fabs(w);
    const double k20 = fabs(c);
    const double k21 = 9.0 * k18;
    const double k22 = 6.0 * k20 + (2.0 * k19 + (5.0 * k17 + k21));
    kept[11] = k22;
    const double k23 = 6.0 * k19;
    const double k24 = 13.0 * k20 + (14.0 * k18 + k23);
    kept[12] = k24;
    const double k25 = 10.0 * k20 + (k21 + k23);
    kept[13] = k25;
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double m_B = p[10]; /* [kg] */
    const double k26 = m_R + m_B;
    kept[14] = k26;
    const double k27 = m_B * k11;
    kept[15] = k27;
    const double k28 = m_B * k12;
    kept[16] = k28;
    const double B_xz = p[12]; /* [kg*m^2] */
    const double k29 = B_xz * c_lam;
    const double k30 = s_lam * k8 - k29;
    const double k31 = B_xz * s_lam;
    const double k32 = c_lam * k7 - k31;
    const double k33 = k11 * k27;
    const double k34 = s_lam * k30 + c_lam * k32 + k33;
    kept[17] = k34;
    const double k35 = c_lam * k30 - s_lam * k32 + k12 * k27;
    kept[18] = k35;
    const double k36 = k12 * k28;
    const double B_yy = p[13]; /* [kg*m^2] */
    const double k37 = k33 + (B_yy + k36);
    kept[19] = k37;
    const double k38 = k31 + c_lam * k8;
    const double k39 = k29 + s_lam * k7;
    const double k40 = s_lam * k38 - c_lam * k39 + k11 * k28;
    kept[20] = k40;
    const double k41 = k36 + (c_lam * k38 + s_lam * k39);
    kept[21] = k41;
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double k42 = m_F * k16;
    const double m_H = p[17]; /* [kg] */
    const double k43 = m_H + m_F;
    kept[22] = k43;
    const double k44 = m_H * k15;
    const double k45 = k42 + k44;
    kept[23] = k45;
    const double k46 = m_F * k4;
    const double k47 = m_H * k9;
    const double k48 = k46 - k47;
    kept[24] = k48;
    const double H_xz = p[19]; /* [kg*m^2] */
    const double k49 = H_xz * c_lam;
    const double k50 = s_lam * k5 - k49;
    const double k51 = H_xz * s_lam;
    const double k52 = c_lam * k6 - k51;
    const double k53 = k16 * k42;
    const double k54 = k15 * k44;
    const double k55 = s_lam * k50 + c_lam * k52 + k53 + k54;
    kept[25] = k55;
    const double k56 = c_lam * k50 - s_lam * k52 + k4 * k42 - k9 * k44;
    kept[26] = k56;
    const double k57 = k4 * k46;
    const double k58 = k9 * k47;
    const double H_yy = p[20]; /* [kg*m^2] */
    const double k59 = k54 + (k53 + (H_yy + k57) + k58);
    kept[27] = k59;
    const double k60 = k51 + c_lam * k5;
    const double k61 = k49 + s_lam * k6;
    const double k62 = s_lam * k60 - c_lam * k61 + k16 * k46 - k15 * k47;
    kept[28] = k62;
    const double k63 = k58 + (k57 + (c_lam * k60 + s_lam * k61));
    kept[29] = k63;
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double k64 = g * m_F;
    const double k65 = g * m_H;
    const double k66 = g * m_B;
    const double k67 = g * k26;
    kept[30] = k67;
    const double k68 = k12 * k66;
    kept[31] = k68;
    const double k69 = k11 * k66;
    kept[32] = k69;
    const double k70 = k9 * k65;
    kept[33] = k70;
    const double k71 = k15 * k65;
    kept[34] = k71;
    const double k72 = g * k43;
    kept[35] = k72;
    const double k73 = k4 * k64;
    kept[36] = k73;
    const double k74 = k16 * k64;
    kept[37] = k74;
    const double k75 = k71 + k74;
    kept[38] = k75;
    const double k76 = k70 - k73;
    kept[39] = k76;

    /* state */
    const double z2 = c_roll * c1;
    kept[40] = z2;
    const double z3 = c_roll * s1;
    kept[41] = z3;
    const double z4 = e2z * s_steer - c_steer * z3;
    kept[42] = z4;
    const double z5 = 1.0 / sqrt(z2 * z2 + z4 * z4);
    kept[43] = z5;
    const double z6 = r_F * z4;
    kept[44] = z6;
    const double z7 = z5 * z6;
    kept[45] = z7;
    const double z8 = k4 + z7;
    kept[46] = z8;
    const double z9 = s_steer * z8;
    kept[47] = z9;
    const double z10 = s1 * z9;
    kept[48] = z10;
    const double z11 = 1.0 / fabs(c_roll);
    kept[49] = z11;
    const double z12 = r_R * z3;
    kept[50] = z12;
    const double z13 = z11 * z12;
    kept[51] = z13;
    const double z14 = k10 + z13 + c_steer * z8;
    kept[52] = z14;
    const double z15 = c_roll * z10 + e2z * z14;
    kept[53] = z15;
    const double z16 = r_R * z2;
    kept[54] = z16;
    const double z17 = z11 * z16;
    kept[55] = z17;
    const double z18 = c_steer * z17;
    kept[56] = z18;
    const double z19 = r_F * z2;
    kept[57] = z19;
    const double z20 = z5 * z19;
    kept[58] = z20;
    const double z21 = k16 + z20;
    kept[59] = z21;
    const double z22 = z17 - z21;
    kept[60] = z22;
    const double z23 = s_steer * z22;
    kept[61] = z23;
    const double z24 = c_steer * z22;
    kept[62] = z24;
    const double z25 = s_steer * z17;
    kept[63] = z25;
    const double z26 = z18 * z23 - z24 * z25;
    kept[64] = z26;
    const double z27 = c_steer * z21;
    kept[65] = z27;
    const double z28 = c_steer * k10 + z8;
    kept[66] = z28;
    const double z29 = s1 * z27 + c1 * z28;
    kept[67] = z29;
    const double z30 = c_roll * z29 + e2z * z23;
    kept[68] = z30;
    const double z31 = s_steer * z21;
    kept[69] = z31;
    const double z32 = s_steer * k10;
    kept[70] = z32;
    const double z33 = s1 * z31 + c1 * z32;
    kept[71] = z33;
    const double z34 = c_roll * z33 - e2z * z24;
    kept[72] = z34;
    const double z35 = z18 * z30 + z34 * z25;
    kept[73] = z35;
    const double z36 = z24 * z30 + z34 * z23;
    kept[74] = z36;
    const double z37 = z15 * z26 - z14 * z35 + z13 * z36;
    kept[75] = z37;
    const double z38 = k17 * (9.0 + fabs(z11));
    kept[76] = z38;
    const double z39 = 1.0 / z37;
    kept[77] = z39;
    const double z40 = s_steer * c1;
    kept[78] = z40;
    const double z41 = z8 * z40;
    kept[79] = z41;
    const double z42 = c_steer * c1;
    kept[80] = z42;
    const double z43 = r_R * c_roll;
    kept[81] = z43;
    const double z44 = z43 * z11;
    kept[82] = z44;
    const double z45 = k10 * s1 + z44;
    kept[83] = z45;
    const double z46 = s1 * z7 - z20 * z42 - (k16 * z42 - k4 * s1 - c_steer * z45);
    kept[84] = z46;
    const double z47 = z20 * z40 + (k16 * z40 - s_steer * z45);
    kept[85] = z47;
    const double z48 = z18 * z46 - z25 * z47;
    kept[86] = z48;
    const double z49 = z24 * z46 - z23 * z47;
    kept[87] = z49;
    const double z50 = z26 * z41 + z14 * z48 - z13 * z49;
    kept[88] = z50;
    const double z51 = z39 * z50;
    kept[89] = z51;
    const double z52 = c_roll * z51;
    kept[90] = z52;
    const double z53 = s1 + c1 * z52;
    kept[91] = z53;
    const double z54 = z44 + k10 * z53;
    kept[92] = z54;
    const double z55 = z30 * z47 + z34 * z46;
    kept[93] = z55;
    const double z56 = z15 * z49 + z14 * z55 + z36 * z41;
    kept[94] = z56;
    const double z57 = z39 * z56;
    kept[95] = z57;
    const double z58 = z15 * z48 + z35 * z41 + z13 * z55;
    kept[96] = z58;
    const double z59 = z39 * z58;
    kept[97] = z59;
    const double z60 = z59 - e2z * z51;
    kept[98] = z60;
    const double z61 = z57 - z60;
    kept[99] = z61;
    const double z62 = z17 * z61;
    kept[100] = z62;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part2(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)t;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double z54 = kept[92];
    const double z62 = kept[100];
    const double z63 = c_steer * z54 + s_steer * z62;
    kept[101] = z63;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const double z52 = kept[90];
    const double z64 = c1 - s1 * z52;
    kept[102] = z64;
    const double z60 = kept[98];
    const double z65 = s_steer * z60 - c_steer * z64;
    kept[103] = z65;
    const double k48 = kept[24];
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z53 = kept[91];
    const double z66 = k63 * z53 + (k48 * z63 + k62 * z65);
    kept[104] = z66;
    const double z67 = c_steer * z60 + s_steer * z64;
    kept[105] = z67;
    const double z68 = c_steer * z62 - s_steer * z54;
    kept[106] = z68;
    const double z13 = kept[51];
    const double z61 = kept[99];
    const double z69 = z13 * z61;
    kept[107] = z69;
    const double k10 = kept[9];
    const double z70 = z69 - k10 * z60;
    kept[108] = z70;
    const double k45 = kept[23];
    const double k59 = kept[27];
    const double z71 = k59 * z67 + (k45 * z68 - k48 * z70);
    kept[109] = z71;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z72 = k56 * z53 + (k45 * z63 + k55 * z65);
    kept[110] = z72;
    const double k43 = kept[22];
    const double z73 = k43 * z70 - k48 * z67;
    kept[111] = z73;
    const double z74 = k48 * z53 + (k43 * z63 + k45 * z65);
    kept[112] = z74;
    const double z75 = k43 * z68 + k45 * z67;
    kept[113] = z75;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double z44 = kept[82];
    const double z76 = k41 * z53 + (z44 * k28 - k40 * z64);
    kept[114] = z76;
    const double k27 = kept[15];
    const double k37 = kept[19];
    const double z77 = z60 * k37 + (z62 * k27 - z69 * k28);
    kept[115] = z77;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z78 = k35 * z53 + (z44 * k27 - k34 * z64);
    kept[116] = z78;
    const double k26 = kept[14];
    const double z79 = z69 * k26 - z60 * k28;
    kept[117] = z79;
    const double z80 = z62 * k26 + z60 * k27;
    kept[118] = z80;
    const double z81 = k28 * z53 + (z44 * k26 - k27 * z64);
    kept[119] = z81;
    const double z82 = z53 * z76 + (z60 * z77 - (z64 * z78 - (z69 * z79 + (z62 * z80 + z44 * z81))));
    const double z83 = z53 * z66 + (z67 * z71 + (z65 * z72 + (z70 * z73 + (z63 * z74 + (z68 * z75 + z82)))));
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z84 = z83 + R_yy * (z61 * z61) + F_yy * (z67 * z67);
    kept[120] = z84;
    const double z8 = kept[46];
    const double z18 = kept[56];
    const double z85 = z18 * z8;
    kept[121] = z85;
    const double z24 = kept[62];
    const double z86 = z24 * z8;
    kept[122] = z86;
    const double z14 = kept[52];
    const double z87 = z14 * z85 - z13 * z86;
    kept[123] = z87;
    const double z39 = kept[77];
    const double z88 = z39 * z87;
    kept[124] = z88;
    const double c_roll = kept[0];
    const double z89 = c_roll * z88;
    kept[125] = z89;
    const double z90 = c1 * z89;
    kept[126] = z90;
    const double z91 = 1.0 + z90;
    kept[127] = z91;
    const double z92 = k10 * z90;
    kept[128] = z92;
    const double z34 = kept[72];
    const double z93 = z34 * z8;
    kept[129] = z93;
    const double z15 = kept[53];
    const double z94 = z15 * z86 + z14 * z93;
    kept[130] = z94;
    const double z95 = z39 * z94;
    const double z96 = z15 * z85 + z13 * z93;
    kept[131] = z96;
    const double z97 = z39 * z96;
    const double e2z = kept[1];
    const double z98 = z97 - e2z * z88;
    kept[132] = z98;
    const double z99 = z95 - z98;
    kept[133] = z99;
    const double z17 = kept[55];
    const double z100 = z17 * z99;
    kept[134] = z100;
    const double z101 = c_steer * z92 + s_steer * z100;
    kept[135] = z101;
    const double z102 = s1 * z89;
    kept[136] = z102;
    const double z103 = s_steer * z98 + c_steer * z102;
    kept[137] = z103;
    const double z104 = k63 * z91 + (k48 * z101 + k62 * z103);
    kept[138] = z104;
    const double z105 = c_steer * z98 - s_steer * z102;
    kept[139] = z105;
    const double z106 = c_steer * z100 - s_steer * z92;
    kept[140] = z106;
    const double z107 = z13 * z99;
    kept[141] = z107;
    const double z108 = z107 - k10 * z98;
    kept[142] = z108;
    const double z109 = k59 * z105 + (k45 * z106 - k48 * z108);
    kept[143] = z109;
    const double z110 = k56 * z91 + (k45 * z101 + k55 * z103);
    kept[144] = z110;
    const double z111 = k43 * z108 - k48 * z105;
    kept[145] = z111;
    const double z112 = k48 * z91 + (k43 * z101 + k45 * z103);
    kept[146] = z112;
    const double z113 = k43 * z106 + k45 * z105;
    kept[147] = z113;
    const double z114 = k40 * z102 + k41 * z90;
    kept[148] = z114;
    const double z115 = z98 * k37 + (z100 * k27 - z107 * k28);
    kept[149] = z115;
    const double z116 = k34 * z102 + k35 * z90;
    kept[150] = z116;
    const double z117 = z100 * k26 + z98 * k27;
    kept[151] = z117;
    const double z118 = z107 * k26 - z98 * k28;
    kept[152] = z118;
    const double z119 = z106 * z113 + (z90 * z114 + (z98 * z115 + (z102 * z116 + (z100 * z117 + z107 *
        z118))));
    const double z120 = z91 * z104 + (z105 * z109 + (z103 * z110 + (z108 * z111 + (z101 * z112 + z119)))) +
        R_yy * (z99 * z99);
    const double z121 = z120 + F_yy * (z105 * z105);
    kept[153] = z121;
    const double z122 = z106 * z75 + (z90 * z76 + (z98 * z77 + (z102 * z78 + (z100 * z80 + z107 * z79))));
    const double z123 = z91 * z66 + (z105 * z71 + (z103 * z72 + (z108 * z73 + (z101 * z74 + z122)))) + R_yy *
        (z61 * z99);
    const double z124 = z123 + F_yy * (z67 * z105);
    const double z125 = 1.0 / z84;
    kept[154] = z125;
    const double z126 = z124 * z125;
    kept[155] = z126;
    const double z127 = z121 - z124 * z126;
    kept[156] = z127;
    const double z20 = kept[58];
    const double z25 = kept[63];
    const double z128 = z20 * z25;
    kept[157] = z128;
    const double z23 = kept[61];
    const double z129 = z20 * z23;
    kept[158] = z129;
    const double z7 = kept[45];
    const double z26 = kept[64];
    const double z130 = z7 * z26 - z14 * z128 + z13 * z129;
    kept[159] = z130;
    const double z131 = z39 * z130;
    kept[160] = z131;
    const double z132 = c_roll * z131;
    kept[161] = z132;
    const double z133 = c1 * z132;
    kept[162] = z133;
    const double z134 = k10 * z133;
    kept[163] = z134;
    const double z30 = kept[68];
    const double z135 = z20 * z30;
    kept[164] = z135;
    const double z36 = kept[74];
    const double z136 = z15 * z129 - z14 * z135 - z7 * z36;
    kept[165] = z136;
    const double z137 = z39 * z136;
    const double z35 = kept[73];
    const double z138 = z15 * z128 - z7 * z35 - z13 * z135;
    kept[166] = z138;
    const double z139 = z39 * z138;
    const double z140 = z139 + e2z * z131;
    kept[167] = z140;
    const double z141 = z137 - z140;
    kept[168] = z141;
    const double z142 = z17 * z141;
    kept[169] = z142;
    const double z143 = c_steer * z134 - s_steer * z142;
    kept[170] = z143;
    const double z144 = s1 * z132;
    kept[171] = z144;
    const double z145 = s_steer * z140 - c_steer * z144;
    kept[172] = z145;
    const double z146 = k63 * z133 + (k48 * z143 - k62 * z145);
    kept[173] = z146;
    const double z147 = c_steer * z140 + s_steer * z144;
    kept[174] = z147;
    const double z148 = c_steer * z142 + s_steer * z134;
    kept[175] = z148;
    const double z149 = z13 * z141;
    kept[176] = z149;
    const double z150 = z149 - k10 * z140;
    kept[177] = z150;
    const double z151 = k59 * z147 + (k45 * z148 - k48 * z150);
    kept[178] = z151;
    const double z152 = k56 * z133 + (k45 * z143 - k55 * z145);
    kept[179] = z152;
    const double z153 = k43 * z150 - k48 * z147;
    kept[180] = z153;
    const double z154 = k48 * z133 + (k43 * z143 - k45 * z145);
    kept[181] = z154;
    const double z155 = k43 * z148 + k45 * z147;
    kept[182] = z155;
    const double z156 = k40 * z144 + k41 * z133;
    kept[183] = z156;
    const double z157 = z140 * k37 + (z142 * k27 - z149 * k28);
    kept[184] = z157;
    const double z158 = k34 * z144 + k35 * z133;
    kept[185] = z158;
    const double z159 = z142 * k26 + z140 * k27;
    kept[186] = z159;
    const double z160 = z149 * k26 - z140 * k28;
    kept[187] = z160;
    const double z161 = z148 * z155 + (z133 * z156 + (z140 * z157 + (z144 * z158 + (z142 * z159 + z149 *
        z160))));
    const double z162 = z133 * z146 + (z147 * z151 - (z145 * z152 - (z150 * z153 + (z143 * z154 + z161)))) +
        R_yy * (z141 * z141);
    const double z163 = 1.0 - z147;
    kept[188] = z163;
    const double z164 = z162 + F_yy * (z163 * z163);
    kept[189] = z164;
    const double z165 = z148 * z75 - (z133 * z76 - (z140 * z77 - (z144 * z78 - (z142 * z80 + z149 * z79))));
    const double z166 = z133 * z66 - (z147 * z71 + (z145 * z72 + (z150 * z73 - (z143 * z74 - z165)))) - R_yy
        * (z61 * z141);
    const double z167 = z166 + F_yy * (z67 * z163);
    const double z168 = z167 * z125;
    kept[190] = z168;
    const double z169 = z148 * z113 - (z133 * z114 - (z140 * z115 - (z144 * z116 - (z142 * z117 + z149 *
        z118))));
    const double z170 = z133 * z104 - (z147 * z109 + (z145 * z110 + (z150 * z111 - (z143 * z112 - z169)))) -
        R_yy * (z99 * z141);
    const double z171 = z170 + F_yy * (z105 * z163) - z124 * z168;
    const double z172 = 1.0 / z127;
    kept[191] = z172;
    const double z173 = z171 * z172;
    kept[192] = z173;
    const double z174 = z164 - z167 * z168 - z171 * z173;
    kept[193] = z174;
    const double z175 = s1 * z62 - c1 * z69;
    const double z176 = e2z * z175 - c_roll * z44;
    const double z177 = s1 * z69 + c1 * z62;
    const double s_yaw = kept[6];
    const double c_yaw = kept[7];
    /* (I.2.15) */
    J[9] = s_yaw * z176 - c_yaw * z177;
    const double z178 = s1 * z100 - c1 * z107;
    const double z179 = e2z * z178;
    const double z180 = s1 * z107 + c1 * z100;
    J[10] = s_yaw * z179 - c_yaw * z180;
    const double z181 = s1 * z142 - c1 * z149;
    const double z182 = e2z * z181;
    const double z183 = s1 * z149 + c1 * z142;
    J[11] = s_yaw * z182 - c_yaw * z183;
    J[21] = -(s_yaw * z177 + c_yaw * z176);
    J[22] = -(s_yaw * z180 + c_yaw * z179);
    J[23] = -(s_yaw * z183 + c_yaw * z182);
    J[33] = e2z * z44 + c_roll * z175;
    J[34] = c_roll * z178;
    J[35] = c_roll * z181;
    const double z51 = kept[89];
    J[45] = z51;
    J[46] = z88;
    J[47] = -z131;
    J[57] = 1.0;
    const double z59 = kept[97];
    J[69] = -z59;
    J[70] = -z97;
    J[71] = -z139;
    J[82] = 1.0;
    const double z57 = kept[95];
    J[93] = z57;
    J[94] = z95;
    J[95] = z137;
    J[107] = 1.0;
    const double z11 = kept[49];
    const double z184 = z11 * z11;
    kept[194] = z184;
    const double roll_dot = y[9];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z185 = roll_dot * r_R;
    kept[195] = z185;
    const double z186 = c_roll * z185;
    kept[196] = z186;
    const double z5 = kept[43];
    const double z187 = z5 * z5;
    kept[197] = z187;
    const double z188 = z11 * z186;
    kept[198] = z188;
    const double z189 = z39 * z39;
    kept[199] = z189;
    const double z190 = roll_dot * c1;
    kept[200] = z190;
    const double z191 = s_steer * z190;
    kept[201] = z191;
    const double thF_dot = y[11];
    const double z192 = thF_dot - z191;
    kept[202] = z192;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part3(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)J;
    (void)t;
    const double roll_dot = y[9];
    const double s1 = kept[2];
    const double z193 = roll_dot * s1;
    const double steer_dot = y[10];
    const double z194 = steer_dot + z193;
    kept[203] = z194;
    const double c_steer = kept[5];
    const double z190 = kept[200];
    const double z195 = c_steer * z190;
    kept[204] = z195;
    const double k10 = kept[9];
    const double z188 = kept[198];
    const double z196 = z188 + k10 * z193;
    kept[205] = z196;
    const double k4 = kept[8];
    const double z7 = kept[45];
    const double z191 = kept[201];
    const double z192 = kept[202];
    const double z197 = k4 * z191 - z7 * z192;
    kept[206] = z197;
    const double k16 = kept[10];
    const double z20 = kept[58];
    const double z198 = z7 * z194 - z20 * z195 - (k16 * z195 - k4 * z194 - c_steer * z196);
    kept[207] = z198;
    const double s_steer = kept[4];
    const double z199 = z20 * z192 - (k16 * z191 - s_steer * z196);
    kept[208] = z199;
    const double z18 = kept[56];
    const double z25 = kept[63];
    const double z200 = z18 * z198 + z25 * z199;
    kept[209] = z200;
    const double z23 = kept[61];
    const double z24 = kept[62];
    const double z201 = z24 * z198 + z23 * z199;
    kept[210] = z201;
    const double z13 = kept[51];
    const double z14 = kept[52];
    const double z26 = kept[64];
    const double z202 = z26 * z197 + z14 * z200 - z13 * z201;
    kept[211] = z202;
    const double z30 = kept[68];
    const double z34 = kept[72];
    const double z203 = z30 * z199 - z34 * z198;
    kept[212] = z203;
    const double z15 = kept[53];
    const double z35 = kept[73];
    const double z204 = z15 * z200 + z35 * z197 - z13 * z203;
    kept[213] = z204;
    const double z36 = kept[74];
    const double z205 = z15 * z201 - z14 * z203 + z36 * z197;
    kept[214] = z205;
    const double z39 = kept[77];
    const double z206 = z39 * z202;
    kept[215] = z206;
    const double z207 = z39 * z205;
    kept[216] = z207;
    const double z208 = z39 * z204;
    kept[217] = z208;
    const double e2z = kept[1];
    const double z209 = z208 - e2z * z206;
    kept[218] = z209;
    const double z210 = z207 - z209;
    kept[219] = z210;
    const double z17 = kept[55];
    const double z211 = z17 * z210;
    kept[220] = z211;
    const double z212 = z13 * z210;
    kept[221] = z212;
    const double c1 = kept[3];
    const double z213 = s1 * z211 - c1 * z212;
    kept[222] = z213;
    const double z214 = s1 * z212 + c1 * z211;
    kept[223] = z214;
    const double c_roll = kept[0];
    const double z215 = c_roll * z188 - e2z * z213;
    kept[224] = z215;
    const double z174 = kept[193];
    const double z273 = 1.0 / z174;
    kept[225] = z273;
    const double z274 = steer_dot * s_steer;
    kept[226] = z274;
    const double z275 = roll_dot * e2z;
    kept[227] = z275;
    const double z276 = s1 * z208;
    kept[228] = z276;
    const double z277 = z275 * c1 - c_roll * z276;
    kept[229] = z277;
    const double z278 = roll_dot * c_roll;
    kept[230] = z278;
    const double z279 = steer_dot * c_steer;
    kept[231] = z279;
    const double z280 = c1 * z208;
    kept[232] = z280;
    const double z281 = z275 * s1 + c_roll * z280;
    kept[233] = z281;
    const double z3 = kept[41];
    const double z282 = s_steer * z278 + e2z * z279 + (z274 * z3 + c_steer * z281);
    kept[234] = z282;
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z283 = z2 * z277 - z4 * z282;
    kept[235] = z283;
    const double z5 = kept[43];
    const double z284 = z5 * z283;
    kept[236] = z284;
    const double z187 = kept[197];
    const double z285 = z187 * z284;
    kept[237] = z285;
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z286 = r_F * z282;
    kept[238] = z286;
    const double z6 = kept[44];
    const double z287 = z6 * z285 + z5 * z286;
    kept[239] = z287;
    const double z288 = roll_dot * z280;
    kept[240] = z288;
    const double z289 = r_F * z277;
    kept[241] = z289;
    const double z19 = kept[57];
    const double z290 = z19 * z285 - z5 * z289;
    kept[242] = z290;
    const double z291 = roll_dot * z276;
    kept[243] = z291;
    const double z292 = z274 * z190 - c_steer * z291;
    kept[244] = z292;
    const double z293 = c_roll * z275;
    kept[245] = z293;
    const double z11 = kept[49];
    const double z294 = z11 * z293;
    kept[246] = z294;
    const double z184 = kept[194];
    const double z295 = z294 * z184;
    kept[247] = z295;
    const double z185 = kept[195];
    const double z296 = z275 * z185;
    kept[248] = z296;
    const double z186 = kept[196];
    const double z297 = z186 * z295 - z11 * z296 - k10 * z288;
    kept[249] = z297;
    const double z298 = z194 * z287 - z7 * z288 - (z195 * z290 - z20 * z292) + (k16 * z292 - k4 * z288 -
        (z274 * z196 - c_steer * z297));
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z299 = r_R * z277;
    kept[250] = z299;
    const double z16 = kept[54];
    const double z300 = z16 * z295 - z11 * z299;
    kept[251] = z300;
    const double z301 = z279 * z17 + s_steer * z300;
    kept[252] = z301;
    const double z21 = kept[59];
    const double z302 = z274 * z21 - c_steer * z290;
    kept[253] = z302;
    const double z303 = z274 * k10 - z287;
    kept[254] = z303;
    const double z27 = kept[65];
    const double z28 = kept[66];
    const double z304 = z27 * z280 + s1 * z302 - (z28 * z276 - c1 * z303);
    kept[255] = z304;
    const double z305 = z300 - z290;
    kept[256] = z305;
    const double z22 = kept[60];
    const double z306 = z279 * z22 + s_steer * z305;
    kept[257] = z306;
    const double z29 = kept[67];
    const double z307 = z275 * z29 + c_roll * z304 - (z278 * z23 + e2z * z306);
    kept[258] = z307;
    const double z308 = z298 + (z207 * z301 - (z206 * z307 + z208 * z306));
    kept[259] = z308;
    const double z309 = z279 * z190 + s_steer * z291;
    kept[260] = z309;
    const double z310 = z274 * z17 - c_steer * z300;
    kept[261] = z310;
    const double z311 = z279 * z21 + s_steer * z290;
    kept[262] = z311;
    const double z312 = z279 * k10;
    kept[263] = z312;
    const double z31 = kept[69];
    const double z32 = kept[70];
    const double z313 = z31 * z280 - s1 * z311 - (c1 * z312 + z32 * z276);
    kept[264] = z313;
    const double z314 = z274 * z22 - c_steer * z305;
    kept[265] = z314;
    const double z33 = kept[71];
    const double z315 = z275 * z33 + c_roll * z313 + (z278 * z24 - e2z * z314);
    kept[266] = z315;
    const double z316 = z192 * z290 - z20 * z309 - (k16 * z309 - (z279 * z196 + s_steer * z297)) + (z207 *
        z310 - (z206 * z315 + z208 * z314));
    kept[267] = z316;
    const double z317 = z18 * z308 + z25 * z316;
    kept[268] = z317;
    const double z318 = r_R * z281;
    kept[269] = z318;
    const double z12 = kept[50];
    const double z319 = z12 * z295 - z11 * z318;
    kept[270] = z319;
    const double z8 = kept[46];
    const double z320 = z279 * z8 + s_steer * z287;
    kept[271] = z320;
    const double z9 = kept[47];
    const double z321 = z9 * z280 - s1 * z320;
    kept[272] = z321;
    const double z322 = z319 - (z274 * z8 - c_steer * z287);
    kept[273] = z322;
    const double z10 = kept[48];
    const double z323 = z275 * z10 + c_roll * z321 - (z278 * z14 + e2z * z322);
    kept[274] = z323;
    const double z324 = k4 * z309 - (z192 * z287 - z7 * z309) - (z207 * z319 - (z206 * z323 + z208 * z322));
    kept[275] = z324;
    const double z325 = z30 * z316 - z34 * z308;
    kept[276] = z325;
    const double z326 = z15 * z317 + z35 * z324 - z13 * z325;
    kept[277] = z326;
    const double z327 = z24 * z308 + z23 * z316;
    kept[278] = z327;
    const double z328 = z26 * z324 + z14 * z317 - z13 * z327;
    kept[279] = z328;
    const double z329 = z39 * z328;
    kept[280] = z329;
    const double z330 = z39 * z326 - (z278 * z206 + e2z * z329);
    kept[281] = z330;
    const double z331 = c_roll * z206;
    kept[282] = z331;
    const double z332 = z190 - s1 * z331;
    kept[283] = z332;
    const double z333 = z275 * z206 - c_roll * z329;
    kept[284] = z333;
    const double z334 = z291 + (z331 * z280 + s1 * z333);
    kept[285] = z334;
    const double z335 = z274 * z209 - c_steer * z330 - (z279 * z332 + s_steer * z334);
    kept[286] = z335;
    const double z336 = z15 * z327 - z14 * z325 + z36 * z324;
    kept[287] = z336;
    const double z337 = z39 * z336 - z330;
    kept[288] = z337;
    const double z44 = kept[82];
    const double v2_x = roll_dot * z44;
    kept[289] = v2_x;
    const double z338 = z193 + c1 * z331;
    kept[290] = z338;
    const double z339 = z210 * z300 + z17 * z337 - (z209 * z212 - v2_x * z338);
    const double z340 = k10 * z209;
    kept[291] = z340;
    const double z341 = k10 * z338;
    kept[292] = z341;
    const double z342 = z339 + (z209 * z340 + z338 * z341);
    kept[293] = z342;
    const double z343 = r_R * z275;
    kept[294] = z343;
    const double z43 = kept[81];
    const double z344 = z11 * z343 - z43 * z295;
    kept[295] = z344;
    const double z345 = roll_dot * z344 + (z211 * z338 - z212 * z332);
    const double z346 = z288 - (z331 * z276 - c1 * z333);
    const double z347 = z345 + (k10 * z346 + z340 * z332);
    kept[296] = z347;
    const double z348 = c_steer * z342 + s_steer * z347;
    const double z349 = z210 * z319 + z13 * z337 - (v2_x * z332 - z209 * z211);
    const double z350 = z349 - (k10 * z330 + z332 * z341);
    const double w3_steer = steer_dot + z338;
    kept[297] = w3_steer;
    const double z351 = s_steer * z209 - c_steer * z332;
    kept[298] = z351;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z352 = k55 * z351 + k56 * w3_steer;
    kept[299] = z352;
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z353 = k62 * z351 + k63 * w3_steer;
    kept[300] = z353;
    const double k45 = kept[23];
    const double k48 = kept[24];
    const double k59 = kept[27];
    const double k70 = kept[33];
    const double k71 = kept[34];
    const double k73 = kept[36];
    const double k74 = kept[37];
    const double z354 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73) - (k59 * z335 - (k45 * z348 - k48 * z350)
        - (w3_steer * z352 - z351 * z353));
    kept[301] = z354;
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z355 = c_steer * z347 - s_steer * z342;
    const double z356 = z279 * z209 + s_steer * z330 + (z274 * z332 - c_steer * z334);
    const double z357 = c_steer * z209 + s_steer * z332;
    kept[302] = z357;
    const double thF_dot = y[11];
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z358 = F_yy * (thF_dot - z357) - k59 * z357;
    kept[303] = z358;
    const double k75 = kept[38];
    const double z359 = h2z * k75 + (k56 * z346 + (k45 * z355 - k55 * z356) - (z357 * z353 + w3_steer *
        z358));
    kept[304] = z359;
    const double z360 = k45 * z351 + k48 * w3_steer;
    kept[305] = z360;
    const double z361 = k45 * z357;
    kept[306] = z361;
    const double k43 = kept[22];
    const double k72 = kept[35];
    const double z362 = z2 * k72 + (k43 * z350 + k48 * z335 + (z351 * z360 + z357 * z361));
    kept[307] = z362;
    const double z363 = k48 * z357;
    kept[308] = z363;
    const double z364 = h2z * k72 + (k48 * z346 + (k43 * z355 - k45 * z356) + (w3_steer * z361 - z351 *
        z363));
    kept[309] = z364;
    const double z365 = z4 * k72 + (k43 * z348 - k45 * z335 + (z357 * z363 + w3_steer * z360));
    kept[310] = z365;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double k37 = kept[19];
    const double z366 = R_yy * z210 - k37 * z209;
    kept[311] = z366;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z367 = k34 * z332 - k35 * z338;
    kept[312] = z367;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double k68 = kept[31];
    const double z368 = e2z * k68 + (k41 * z346 + (k28 * z345 + k40 * z334) - (z332 * z366 + z209 * z367));
    kept[313] = z368;
    const double k76 = kept[39];
    const double z369 = h2z * k76 - (k63 * z346 + (k48 * z355 - k62 * z356) + (z351 * z358 + z357 * z352));
    kept[314] = z369;
    const double z370 = z368 - z369;
    kept[315] = z370;
    const double z371 = k40 * z332 - k41 * z338;
    kept[316] = z371;
    const double k27 = kept[15];
    const double k69 = kept[32];
    const double z372 = z3 * k69 + z2 * k68 - (k37 * z330 + (k27 * z339 - k28 * z349) - (z338 * z367 + z332 *
        z371));
    kept[317] = z372;
    const double z373 = e2z * k69 + (k35 * z346 + (k27 * z345 + k34 * z334) + (z209 * z371 - z338 * z366));
    kept[318] = z373;
    const double z374 = k27 * z332 - k28 * z338;
    kept[319] = z374;
    const double z375 = k27 * z209;
    kept[320] = z375;
    const double k26 = kept[14];
    const double k67 = kept[30];
    const double z376 = z2 * k67 + (k26 * z349 - k28 * z330 + (z332 * z374 + z209 * z375));
    kept[321] = z376;
    const double z377 = k28 * z209;
    kept[322] = z377;
    const double z378 = z3 * k67 - (k26 * z339 + k27 * z330 + (z209 * z377 - z338 * z374));
    kept[323] = z378;
    const double z379 = e2z * k67 + (k28 * z346 + (k26 * z345 + k27 * z334) + (z338 * z375 + z332 * z377));
    kept[324] = z379;
    const double z380 = z187 * z187;
    kept[325] = z380;
    const double z381 = z184 * (1.0 / c_roll);
    kept[326] = z381;
    const double z133 = kept[162];
    const double z140 = kept[167];
    const double z142 = kept[169];
    const double z144 = kept[171];
    const double z148 = kept[175];
    const double z149 = kept[176];
    const double z382 = z148 * z365 + (z133 * z368 - (z140 * z372 - (z144 * z373 - (z142 * z378 - z149 *
        z376))));
    const double z141 = kept[168];
    const double z143 = kept[170];
    const double z145 = kept[172];
    const double z147 = kept[174];
    const double z150 = kept[177];
    const double z383 = z133 * z369 - (z147 * z354 - (z145 * z359 - (z150 * z362 + (z143 * z364 + z382)))) -
        R_yy * (z141 * z337);
    const double z53 = kept[91];
    const double z60 = kept[98];
    const double z62 = kept[100];
    const double z64 = kept[102];
    const double z69 = kept[107];
    const double z384 = z53 * z368 + (z60 * z372 - (z64 * z373 + (z69 * z376 - (z62 * z378 + z44 * z379))));
    const double z63 = kept[101];
    const double z65 = kept[103];
    const double z67 = kept[105];
    const double z68 = kept[106];
    const double z70 = kept[108];
    const double z385 = z53 * z369 + (z67 * z354 - (z65 * z359 - (z70 * z362 - (z63 * z364 - (z68 * z365 -
        z384)))));
    const double z61 = kept[99];
    const double z386 = z385 + R_yy * (z61 * z337) - F_yy * (z67 * z335);
    const double z90 = kept[126];
    const double z98 = kept[132];
    const double z100 = kept[134];
    const double z102 = kept[136];
    const double z106 = kept[140];
    const double z107 = kept[141];
    const double z387 = z106 * z365 - (z90 * z368 + (z98 * z372 + (z102 * z373 + (z100 * z378 - z107 *
        z376))));
    const double z91 = kept[127];
    const double z99 = kept[133];
    const double z101 = kept[135];
    const double z103 = kept[137];
    const double z105 = kept[139];
    const double z108 = kept[142];
    const double z388 = z91 * z369 + (z105 * z354 - (z103 * z359 - (z108 * z362 - (z101 * z364 - z387)))) +
        R_yy * (z99 * z337);
    const double z126 = kept[155];
    const double z389 = z388 - F_yy * (z105 * z335) - z386 * z126;
    const double z163 = kept[188];
    const double z168 = kept[190];
    const double z173 = kept[192];
    const double z390 = z273 * (z383 - F_yy * (z163 * z335) - z386 * z168 - z173 * z389);
    kept[327] = z390;
    const double z172 = kept[191];
    const double z391 = z172 * z389 - z173 * z390;
    kept[328] = z391;
    const double z125 = kept[154];
    const double z392 = z386 * z125 - z126 * z391 - z168 * z390;
    kept[329] = z392;
    const double k22 = kept[11];
    const double k24 = kept[12];
    const double k25 = kept[13];
    const double z37 = kept[75];
    const double z38 = kept[76];
    /* the coframe is singular */
    if (!(fabs(z37) > 1e-12 * ((z38 + k25) * (k22 * (z38 + k24))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z84 = kept[120];
    /* the mass matrix is singular */
    if (!(fabs(z84) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z121 = kept[153];
    const double z127 = kept[156];
    /* the mass matrix is singular */
    if (!(fabs(z127) > 1e-14 * z121)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z164 = kept[189];
    /* the mass matrix is singular */
    if (!(fabs(z174) > 1e-14 * z164)) {
        return BICYCLE_SINGULAR_2;
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW static void bicycle_jacobian_sweep1(double t, const double *y, const double *p, const double
    *kept, const double *seed, double *slope)
{
    (void)t;
    const double s_yaw = kept[6];
    const bicycle_lanes turn_3 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes z216 = s_yaw * turn_3;
    const double c1 = kept[3];
    const bicycle_lanes turn_5 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z217 = c1 * turn_5;
    const double e2z = kept[1];
    const bicycle_lanes turn_4 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z218 = e2z * turn_4;
    const double c_roll = kept[0];
    const double z11 = kept[49];
    const double z184 = kept[194];
    const bicycle_lanes z219 = z184 * (z11 * (c_roll * z218));
    const double s1 = kept[2];
    const bicycle_lanes z220 = s1 * z218 - c_roll * z217;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z12 = kept[50];
    const bicycle_lanes z221 = z12 * z219 - z11 * (r_R * z220);
    const double c_steer = kept[5];
    const bicycle_lanes turn_6 = bicycle_get(seed + 3 * BICYCLE_LANES);
    const bicycle_lanes z222 = c_steer * turn_6;
    const bicycle_lanes z223 = s1 * turn_5;
    const bicycle_lanes z224 = c1 * z218 + c_roll * z223;
    const bicycle_lanes z225 = c_roll * turn_4;
    const double s_steer = kept[4];
    const bicycle_lanes z226 = s_steer * turn_6;
    const double z3 = kept[41];
    const bicycle_lanes z227 = s_steer * z225 + e2z * z222 + (z3 * z226 + c_steer * z220);
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z5 = kept[43];
    const double z187 = kept[197];
    const bicycle_lanes z228 = z187 * (z5 * (z2 * z224 - z4 * z227));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z6 = kept[44];
    const bicycle_lanes z229 = z6 * z228 + z5 * (r_F * z227);
    const double z8 = kept[46];
    const bicycle_lanes z230 = z221 - (z8 * z226 - c_steer * z229);
    const double z9 = kept[47];
    const double z10 = kept[48];
    const double z14 = kept[52];
    const bicycle_lanes z231 = z10 * z218 - c_roll * (z9 * z217 + s1 * (z8 * z222 + s_steer * z229)) - (z14 *
        z225 + e2z * z230);
    const double z16 = kept[54];
    const bicycle_lanes z232 = z16 * z219 - z11 * (r_R * z224);
    const double z17 = kept[55];
    const bicycle_lanes z233 = z17 * z226 - c_steer * z232;
    const double z19 = kept[57];
    const bicycle_lanes z234 = z19 * z228 - z5 * (r_F * z224);
    const bicycle_lanes z235 = z232 - z234;
    const double z22 = kept[60];
    const bicycle_lanes z236 = z22 * z222 + s_steer * z235;
    const bicycle_lanes z237 = z22 * z226 - c_steer * z235;
    const bicycle_lanes z238 = z17 * z222 + s_steer * z232;
    const double z18 = kept[56];
    const double z23 = kept[61];
    const double z24 = kept[62];
    const double z25 = kept[63];
    const bicycle_lanes z239 = z23 * z233 - z18 * z236 - (z25 * z237 - z24 * z238);
    const double k10 = kept[9];
    const double z21 = kept[59];
    const double z27 = kept[65];
    const double z28 = kept[66];
    const bicycle_lanes z240 = z27 * z217 - s1 * (z21 * z226 - c_steer * z234) - (z28 * z223 - c1 * (z229 -
        k10 * z226));
    const double z29 = kept[67];
    const bicycle_lanes z241 = z29 * z218 - c_roll * z240 - (z23 * z225 + e2z * z236);
    const double z31 = kept[69];
    const double z32 = kept[70];
    const bicycle_lanes z242 = z31 * z217 + s1 * (z21 * z222 + s_steer * z234) - (z32 * z223 - c1 * (k10 *
        z222));
    const double z33 = kept[71];
    const bicycle_lanes z243 = z33 * z218 - c_roll * z242 + (z24 * z225 - e2z * z237);
    const double z30 = kept[68];
    const double z34 = kept[72];
    const bicycle_lanes z244 = z30 * z233 + z18 * z241 + (z25 * z243 - z34 * z238);
    const bicycle_lanes z245 = z30 * z237 + z24 * z241 + (z23 * z243 - z34 * z236);
    const double z13 = kept[51];
    const double z15 = kept[53];
    const double z26 = kept[64];
    const double z35 = kept[73];
    const double z36 = kept[74];
    const bicycle_lanes z246 = z26 * z231 + z15 * z239 + (z35 * z230 - z14 * z244) - (z36 * z221 - z13 *
        z245);
    const double z189 = kept[199];
    const bicycle_lanes z247 = z189 * z246;
    const double roll_dot = y[9];
    const bicycle_lanes z248 = roll_dot * z217;
    const bicycle_lanes z249 = roll_dot * z223;
    const double z190 = kept[200];
    const bicycle_lanes z250 = z190 * z226 + c_steer * z249;
    const double z185 = kept[195];
    const double z186 = kept[196];
    const bicycle_lanes z251 = z186 * z219 - z11 * (z185 * z218);
    const bicycle_lanes z252 = z251 + k10 * z248;
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z7 = kept[45];
    const double z20 = kept[58];
    const double z194 = kept[203];
    const double z195 = kept[204];
    const double z196 = kept[205];
    const bicycle_lanes z253 = z194 * z229 + z7 * z248 - (z195 * z234 - z20 * z250) + (k16 * z250 + k4 * z248
        - (z196 * z226 - c_steer * z252));
    const bicycle_lanes z254 = z190 * z222 - s_steer * z249;
    const double z192 = kept[202];
    const bicycle_lanes z255 = z192 * z234 - z20 * z254 - (k16 * z254 - (z196 * z222 + s_steer * z252));
    const double z198 = kept[207];
    const double z199 = kept[208];
    const bicycle_lanes z256 = z198 * z237 - z24 * z253 - (z199 * z236 + z23 * z255);
    const bicycle_lanes z257 = z199 * z241 - z30 * z255 - (z198 * z243 - z34 * z253);
    const bicycle_lanes z258 = k4 * z254 - (z192 * z229 - z7 * z254);
    const double z197 = kept[206];
    const double z201 = kept[210];
    const double z203 = kept[212];
    const bicycle_lanes z259 = z201 * z231 + z15 * z256 + (z203 * z230 - z14 * z257) + (z197 * z245 - z36 *
        z258);
    const double z39 = kept[77];
    const double z205 = kept[214];
    const bicycle_lanes z260 = z205 * z247 - z39 * z259;
    const bicycle_lanes z261 = z198 * z233 - z18 * z253 - (z199 * z238 + z25 * z255);
    const double z200 = kept[209];
    const bicycle_lanes z262 = z200 * z231 + z15 * z261 + (z197 * z244 - z35 * z258) + (z203 * z221 - z13 *
        z257);
    const double z204 = kept[213];
    const bicycle_lanes z263 = z204 * z247 - z39 * z262;
    const bicycle_lanes z264 = z197 * z239 - z26 * z258 - (z200 * z230 - z14 * z261) + (z201 * z221 - z13 *
        z256);
    const double z202 = kept[211];
    const bicycle_lanes z265 = z202 * z247 - z39 * z264;
    const double z206 = kept[215];
    const bicycle_lanes z266 = z260 - (z263 - (z206 * z225 + e2z * z265));
    const double z210 = kept[219];
    const bicycle_lanes z267 = z210 * z221 + z13 * z266;
    const bicycle_lanes z268 = z210 * z232 + z17 * z266;
    const double z211 = kept[220];
    const double z212 = kept[221];
    const bicycle_lanes z269 = z212 * z217 + s1 * z267 - (z211 * z223 - c1 * z268);
    const double c_yaw = kept[7];
    const bicycle_lanes z270 = c_yaw * turn_3;
    const bicycle_lanes z271 = z211 * z217 + s1 * z268 + (z212 * z223 - c1 * z267);
    const double z188 = kept[198];
    const double z213 = kept[222];
    const bicycle_lanes z272 = z188 * z218 - c_roll * z251 + (z213 * z225 + e2z * z271);
    const double z214 = kept[223];
    const double z215 = kept[224];
    bicycle_put(slope + 0 * BICYCLE_LANES, z214 * z216 - c_yaw * z269 - (z215 * z270 - s_yaw * z272));
    bicycle_put(slope + 1 * BICYCLE_LANES, -(z214 * z270 + s_yaw * z269 + (z215 * z216 + c_yaw * z272)));
    bicycle_put(slope + 2 * BICYCLE_LANES, z188 * z225 + e2z * z251 - (z213 * z218 - c_roll * z271));
    bicycle_put(slope + 3 * BICYCLE_LANES, z265);
    bicycle_put(slope + 4 * BICYCLE_LANES, -z263);
    bicycle_put(slope + 5 * BICYCLE_LANES, z260);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part1(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)slope;
    (void)t;
    const double z126 = kept[155];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z393 = row_1 - z126 * row_0;
    const double z168 = kept[190];
    const double z173 = kept[192];
    const double z273 = kept[225];
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z394 = z273 * (row_2 + z168 * row_0 + z173 * z393);
    bicycle_put(carried + 0 * BICYCLE_LANES, z394);
    const double z172 = kept[191];
    const bicycle_lanes z395 = z172 * z393 + z173 * z394;
    bicycle_put(carried + 1 * BICYCLE_LANES, z395);
    const double z125 = kept[154];
    const bicycle_lanes z396 = z125 * row_0 - z126 * z395 + z168 * z394;
    bicycle_put(carried + 2 * BICYCLE_LANES, z396);
    const double z60 = kept[98];
    const double z98 = kept[132];
    const double z140 = kept[167];
    const bicycle_lanes z397 = z140 * z394 + z98 * z395 + z60 * z396;
    bicycle_put(carried + 3 * BICYCLE_LANES, z397);
    const double z69 = kept[107];
    const double z107 = kept[141];
    const double z149 = kept[176];
    const bicycle_lanes z398 = z149 * z394 + z107 * z395 + z69 * z396;
    bicycle_put(carried + 4 * BICYCLE_LANES, z398);
    const double z62 = kept[100];
    const double z100 = kept[134];
    const double z142 = kept[169];
    const bicycle_lanes z399 = z142 * z394 + z100 * z395 + z62 * z396;
    bicycle_put(carried + 5 * BICYCLE_LANES, z399);
    const double z67 = kept[105];
    const double z105 = kept[139];
    const double z147 = kept[174];
    const bicycle_lanes z400 = z147 * z394 + z105 * z395 + z67 * z396;
    bicycle_put(carried + 6 * BICYCLE_LANES, z400);
    const double z70 = kept[108];
    const double z108 = kept[142];
    const double z150 = kept[177];
    const bicycle_lanes z401 = z150 * z394 + z108 * z395 + z70 * z396;
    bicycle_put(carried + 7 * BICYCLE_LANES, z401);
    const double k43 = kept[22];
    const double k48 = kept[24];
    const bicycle_lanes z402 = k48 * z400 - k43 * z401;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const bicycle_lanes z403 = F_yy * z394;
    const bicycle_lanes z404 = F_yy * z395;
    const bicycle_lanes z405 = F_yy * z396;
    bicycle_put(carried + 8 * BICYCLE_LANES, z405);
    const double z68 = kept[106];
    const double z106 = kept[140];
    const double z148 = kept[175];
    const bicycle_lanes z406 = z148 * z394 + z106 * z395 + z68 * z396;
    bicycle_put(carried + 9 * BICYCLE_LANES, z406);
    const double k45 = kept[23];
    const double k59 = kept[27];
    const double z163 = kept[188];
    const bicycle_lanes z407 = z163 * z403 - z105 * z404 - z67 * z405 - k59 * z400 + k48 * z401 - k45 * z406;
    bicycle_put(carried + 10 * BICYCLE_LANES, z407);
    const double z133 = kept[162];
    const bicycle_lanes z408 = z133 * z394;
    const double z53 = kept[91];
    const bicycle_lanes z409 = z53 * z396;
    const double z91 = kept[127];
    const bicycle_lanes z410 = z408 - z91 * z395 - z409;
    bicycle_put(carried + 11 * BICYCLE_LANES, z410);
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z145 = kept[172];
    const bicycle_lanes z411 = z145 * z394 + z103 * z395 + z65 * z396;
    bicycle_put(carried + 12 * BICYCLE_LANES, z411);
    const double z63 = kept[101];
    const double z101 = kept[135];
    const double z143 = kept[170];
    const bicycle_lanes z412 = z143 * z394 - z101 * z395 - z63 * z396;
    bicycle_put(carried + 13 * BICYCLE_LANES, z412);
    const double k55 = kept[25];
    const double k62 = kept[28];
    const bicycle_lanes z413 = k62 * z410 - k55 * z411 + k45 * z412;
    bicycle_put(carried + 14 * BICYCLE_LANES, z413);
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double k10 = kept[9];
    const double k27 = kept[15];
    const double k28 = kept[16];
    const double k37 = kept[19];
    const bicycle_lanes z414 = k37 * z397 - k28 * z398 + k27 * z399 + k10 * z402 - c_steer * z407 - s_steer *
        z413;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z415 = R_yy * z394;
    bicycle_put(carried + 15 * BICYCLE_LANES, z415);
    const bicycle_lanes z416 = R_yy * z395;
    bicycle_put(carried + 16 * BICYCLE_LANES, z416);
    const bicycle_lanes z417 = R_yy * z396;
    bicycle_put(carried + 17 * BICYCLE_LANES, z417);
    const double k26 = kept[14];
    const bicycle_lanes z418 = z402 + (k28 * z397 - k26 * z398);
    bicycle_put(carried + 18 * BICYCLE_LANES, z418);
    const bicycle_lanes z419 = k48 * z410 - k45 * z411 + k43 * z412;
    bicycle_put(carried + 19 * BICYCLE_LANES, z419);
    const bicycle_lanes z420 = k45 * z400 + k43 * z406;
    bicycle_put(carried + 20 * BICYCLE_LANES, z420);
    const bicycle_lanes z421 = s_steer * z419 - c_steer * z420;
    const bicycle_lanes z422 = k27 * z397 + k26 * z399 - z421;
    bicycle_put(carried + 21 * BICYCLE_LANES, z422);
    const double z13 = kept[51];
    const double z17 = kept[55];
    const double z61 = kept[99];
    const double z99 = kept[133];
    const double z141 = kept[168];
    const bicycle_lanes z423 = z141 * z415 + z99 * z416 + z61 * z417 - z13 * z418 + z17 * z422;
    bicycle_put(carried + 22 * BICYCLE_LANES, z423);
    const bicycle_lanes z424 = z414 - z423;
    bicycle_put(carried + 23 * BICYCLE_LANES, z424);
    const double z39 = kept[77];
    const bicycle_lanes z425 = z39 * z423;
    bicycle_put(carried + 24 * BICYCLE_LANES, z425);
    const bicycle_lanes z426 = z39 * z424;
    bicycle_put(carried + 25 * BICYCLE_LANES, z426);
    const double z90 = kept[126];
    const bicycle_lanes z427 = z408 - z90 * z395 - z409;
    bicycle_put(carried + 26 * BICYCLE_LANES, z427);
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z144 = kept[171];
    const bicycle_lanes z428 = z144 * z394 - z102 * z395 + z64 * z396;
    bicycle_put(carried + 27 * BICYCLE_LANES, z428);
    const double z44 = kept[82];
    const bicycle_lanes z429 = z44 * z396;
    bicycle_put(carried + 28 * BICYCLE_LANES, z429);
    const double k34 = kept[17];
    const double k40 = kept[20];
    const bicycle_lanes z430 = k40 * z427 + k34 * z428 - k27 * z429 - s_steer * z407 + c_steer * z413;
    bicycle_put(carried + 29 * BICYCLE_LANES, z430);
    const double k35 = kept[18];
    const double k41 = kept[21];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const bicycle_lanes z431 = k63 * z410 - k56 * z411 + k48 * z412 + k41 * z427 + k35 * z428 - k28 * z429;
    const bicycle_lanes z432 = c_steer * z419 + s_steer * z420;
    const bicycle_lanes z433 = z431 + k10 * z432;
    bicycle_put(carried + 30 * BICYCLE_LANES, z433);
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z434 = s1 * z430 + c1 * z433;
    bicycle_put(carried + 31 * BICYCLE_LANES, z434);
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z435 = c_roll * z434 + e2z * z424;
    bicycle_put(carried + 32 * BICYCLE_LANES, z435);
    const bicycle_lanes z436 = z39 * z435;
    bicycle_put(carried + 33 * BICYCLE_LANES, z436);
    const double z26 = kept[64];
    const double z35 = kept[73];
    const double z36 = kept[74];
    const bicycle_lanes z437 = z36 * z425 + z35 * z426 - z26 * z436;
    bicycle_put(carried + 34 * BICYCLE_LANES, z437);
    const double z206 = kept[215];
    const bicycle_lanes z438 = z206 * z437;
    bicycle_put(carried + 35 * BICYCLE_LANES, z438);
    const double z14 = kept[52];
    const bicycle_lanes z439 = z14 * z425 + z13 * z426;
    bicycle_put(carried + 36 * BICYCLE_LANES, z439);
    const double z15 = kept[53];
    const bicycle_lanes z440 = z15 * z425 + z13 * z436;
    bicycle_put(carried + 37 * BICYCLE_LANES, z440);
    const bicycle_lanes z441 = z15 * z426 - z14 * z436;
    bicycle_put(carried + 38 * BICYCLE_LANES, z441);
    const double z18 = kept[56];
    const double z24 = kept[62];
    const double z34 = kept[72];
    const bicycle_lanes z442 = z34 * z439 + z24 * z440 + z18 * z441;
    bicycle_put(carried + 39 * BICYCLE_LANES, z442);
    const bicycle_lanes z443 = z206 * z442;
    bicycle_put(carried + 40 * BICYCLE_LANES, z443);
    const double z23 = kept[61];
    const double z25 = kept[63];
    const double z30 = kept[68];
    const bicycle_lanes z444 = z30 * z439 - z23 * z440 - z25 * z441;
    bicycle_put(carried + 41 * BICYCLE_LANES, z444);
    const bicycle_lanes z445 = z206 * z444;
    bicycle_put(carried + 42 * BICYCLE_LANES, z445);
    const double z208 = kept[217];
    const bicycle_lanes z446 = z208 * z437 - e2z * z438;
    bicycle_put(carried + 43 * BICYCLE_LANES, z446);
    const bicycle_lanes z447 = c_roll * z438;
    bicycle_put(carried + 44 * BICYCLE_LANES, z447);
    const bicycle_lanes z448 = s1 * z447;
    bicycle_put(carried + 45 * BICYCLE_LANES, z448);
    const bicycle_lanes z449 = c_roll * z443;
    bicycle_put(carried + 46 * BICYCLE_LANES, z449);
    const bicycle_lanes z450 = c1 * z449;
    bicycle_put(carried + 47 * BICYCLE_LANES, z450);
    const double z192 = kept[202];
    const double z194 = kept[203];
    const bicycle_lanes z451 = z194 * z442 - z192 * z437 + c_steer * z446 - s_steer * z448 + z450;
    bicycle_put(carried + 48 * BICYCLE_LANES, z451);
    const bicycle_lanes z452 = z208 * z442 - e2z * z443;
    bicycle_put(carried + 49 * BICYCLE_LANES, z452);
    const bicycle_lanes z453 = z208 * z444 - e2z * z445;
    bicycle_put(carried + 50 * BICYCLE_LANES, z453);
    const bicycle_lanes z454 = s_steer * z452 + c_steer * z453;
    const bicycle_lanes z455 = s1 * z449;
    bicycle_put(carried + 51 * BICYCLE_LANES, z455);
    const bicycle_lanes z456 = c_roll * z445;
    bicycle_put(carried + 52 * BICYCLE_LANES, z456);
    const bicycle_lanes z457 = s1 * z456;
    bicycle_put(carried + 53 * BICYCLE_LANES, z457);
    const double z195 = kept[204];
    const bicycle_lanes z458 = z454 - (z192 * z444 + z195 * z442 - c_steer * z455 + s_steer * z457);
    bicycle_put(carried + 54 * BICYCLE_LANES, z458);
    const double z6 = kept[44];
    const double z19 = kept[57];
    const bicycle_lanes z459 = z6 * z451 + z19 * z458;
    bicycle_put(carried + 55 * BICYCLE_LANES, z459);
    const double z187 = kept[197];
    const bicycle_lanes z460 = z187 * z459;
    bicycle_put(carried + 56 * BICYCLE_LANES, z460);
    const double z5 = kept[43];
    const bicycle_lanes z461 = z5 * z460;
    bicycle_put(carried + 57 * BICYCLE_LANES, z461);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z4 = kept[42];
    const bicycle_lanes z462 = r_F * (z5 * z451) - z4 * z461;
    bicycle_put(carried + 58 * BICYCLE_LANES, z462);
    const bicycle_lanes z463 = z206 * z424 + z14 * z438 - z23 * z443 - z24 * z445 - s_steer * z462;
    bicycle_put(carried + 59 * BICYCLE_LANES, z463);
    const bicycle_lanes z464 = s_steer * z444 - c_steer * z442;
    bicycle_put(carried + 60 * BICYCLE_LANES, z464);
    const double z332 = kept[283];
    const double z338 = kept[290];
    const bicycle_lanes z465 = z332 * z427 + z338 * z428;
    const bicycle_lanes z466 = k28 * z427 + k27 * z428 - k26 * z429 + z432;
    bicycle_put(carried + 61 * BICYCLE_LANES, z466);
    const double z209 = kept[218];
    const bicycle_lanes z467 = z332 * z466 + z209 * z422;
    bicycle_put(carried + 62 * BICYCLE_LANES, z467);
    const bicycle_lanes z468 = z209 * z418 - z338 * z466;
    bicycle_put(carried + 63 * BICYCLE_LANES, z468);
    const double z300 = kept[251];
    const double z319 = kept[270];
    const bicycle_lanes z469 = R_yy * z465 + z319 * z418 - z300 * z422 + z13 * z467 + z17 * z468;
    const double z301 = kept[252];
    const double z310 = kept[261];
    const bicycle_lanes z470 = z310 * z444 - z301 * z442 + z319 * z437 + z469;
    bicycle_put(carried + 64 * BICYCLE_LANES, z470);
    const bicycle_lanes z471 = z39 * z470;
    bicycle_put(carried + 65 * BICYCLE_LANES, z471);
    const double z21 = kept[59];
    const bicycle_lanes z472 = z21 * z442;
    bicycle_put(carried + 66 * BICYCLE_LANES, z472);
    const double k4 = kept[8];
    const double z7 = kept[45];
    const bicycle_lanes z473 = z21 * z444 + z7 * z437 + k4 * z437;
    bicycle_put(carried + 67 * BICYCLE_LANES, z473);
    const bicycle_lanes z474 = z430 - c_steer * z472 + s_steer * z473;
    bicycle_put(carried + 68 * BICYCLE_LANES, z474);
    const double z207 = kept[216];
    const bicycle_lanes z475 = z207 * z442;
    bicycle_put(carried + 69 * BICYCLE_LANES, z475);
    const bicycle_lanes z476 = z207 * z444;
    bicycle_put(carried + 70 * BICYCLE_LANES, z476);
    const double z210 = kept[219];
    const bicycle_lanes z477 = z210 * z422 + s_steer * z475 - z454 + c_steer * z476;
    bicycle_put(carried + 71 * BICYCLE_LANES, z477);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z2 = kept[40];
    const double z11 = kept[49];
    const bicycle_lanes z478 = r_F * (z5 * z458) + r_R * (z11 * z477) - z2 * z461;
    bicycle_put(carried + 72 * BICYCLE_LANES, z478);
    const double roll_dot = y[9];
    const double z28 = kept[66];
    const double z32 = kept[70];
    const double z331 = kept[282];
    const bicycle_lanes z479 = z331 * z433 - z28 * z449 + z32 * z456 - roll_dot * z474 - c_roll * z478;
    bicycle_put(carried + 73 * BICYCLE_LANES, z479);
    const bicycle_lanes z480 = z433 - z7 * z442 - k4 * z442 + k10 * z464;
    bicycle_put(carried + 74 * BICYCLE_LANES, z480);
    const bicycle_lanes z481 = z210 * z418 + z207 * z437 - z446;
    bicycle_put(carried + 75 * BICYCLE_LANES, z481);
    const bicycle_lanes z482 = r_R * (z11 * z481) + c_steer * z462;
    bicycle_put(carried + 76 * BICYCLE_LANES, z482);
    const double z9 = kept[47];
    const double z27 = kept[65];
    const double z31 = kept[69];
    const bicycle_lanes z483 = z331 * z430 + z9 * z447 - z27 * z449 + z31 * z456 + roll_dot * z480 + c_roll *
        z482;
    bicycle_put(carried + 77 * BICYCLE_LANES, z483);
    const double z367 = kept[312];
    const double z371 = kept[316];
    const double z375 = kept[320];
    const double z377 = kept[322];
    const bicycle_lanes z484 = z375 * z398 + z377 * z399 - z367 * z427 + z371 * z428 + k37 * z465 - k28 *
        (z332 * z429 - z209 * z399);
    const double z211 = kept[220];
    const double z212 = kept[221];
    const double z340 = kept[291];
    const bicycle_lanes z485 = z484 + k27 * (z209 * z398 - z338 * z429) - z340 * z421 - z211 * z418 - z212 *
        z422;
    const double w3_steer = kept[297];
    const double z351 = kept[298];
    const bicycle_lanes z486 = z351 * z410 + w3_steer * z411;
    const double z352 = kept[299];
    const double z353 = kept[300];
    const double z357 = kept[302];
    const double z361 = kept[306];
    const double z363 = kept[308];
    const bicycle_lanes z487 = z361 * z401 + z363 * z406 + z352 * z410 + z353 * z411 - k59 * z486 - k48 *
        (z351 * z412 - z357 * z406);
    const bicycle_lanes z488 = F_yy * z486;
    bicycle_put(carried + 78 * BICYCLE_LANES, z488);
    const bicycle_lanes z489 = z487 + k45 * (z357 * z401 + w3_steer * z412) - z488;
    bicycle_put(carried + 79 * BICYCLE_LANES, z489);
    const double z274 = kept[226];
    const double z279 = kept[231];
    const bicycle_lanes z490 = z485 + z274 * z407 - z279 * z413 + k10 * (z332 * z432 - z209 * z421) + c_steer
        * z489;
    const bicycle_lanes z491 = z351 * z400 - z357 * z411;
    const bicycle_lanes z492 = z357 * z410 + w3_steer * z400;
    const double z358 = kept[303];
    const double z360 = kept[305];
    const bicycle_lanes z493 = z360 * z401 - z363 * z412 + z358 * z410 - z353 * z400 - k62 * z491 + k55 *
        z492;
    const bicycle_lanes z494 = z351 * z401 + w3_steer * z406;
    const bicycle_lanes z495 = z493 + k45 * z494;
    bicycle_put(carried + 80 * BICYCLE_LANES, z495);
    const bicycle_lanes z496 = z490 + s_steer * z495 + z469;
    bicycle_put(carried + 81 * BICYCLE_LANES, z496);
    const double z306 = kept[257];
    const double z314 = kept[265];
    const double z322 = kept[273];
    const bicycle_lanes z497 = z314 * z444 - z306 * z442 + z322 * z437 - s1 * z479 + c1 * z483 + z496;
    bicycle_put(carried + 82 * BICYCLE_LANES, z497);
    const bicycle_lanes z498 = z39 * z497;
    bicycle_put(carried + 83 * BICYCLE_LANES, z498);
    const bicycle_lanes z499 = z14 * z471 - z13 * z498;
    bicycle_put(carried + 84 * BICYCLE_LANES, z499);
    const bicycle_lanes z500 = z332 * z397 - z209 * z428;
    const bicycle_lanes z501 = z209 * z427 + z338 * z397;
    const double z366 = kept[311];
    const double z374 = kept[319];
    const bicycle_lanes z502 = z374 * z398 - z377 * z429 - z366 * z427 - z371 * z397 - k40 * z500 - k34 *
        z501;
    const bicycle_lanes z503 = z332 * z398 - z338 * z399;
    const double v2_x = kept[289];
    const double z341 = kept[292];
    const bicycle_lanes z504 = z502 + k27 * z503 + z341 * z402 + z340 * z432 + v2_x * z418 - z212 * z466 -
        z279 * z407;
    const bicycle_lanes z505 = z504 - z274 * z413 + s_steer * z489 - c_steer * z495;
    bicycle_put(carried + 85 * BICYCLE_LANES, z505);
    const bicycle_lanes z506 = z361 * z412 + z360 * z406 + z352 * z400 + z358 * z411 - k63 * z491 + k56 *
        z492;
    const bicycle_lanes z507 = z506 + k48 * z494;
    bicycle_put(carried + 86 * BICYCLE_LANES, z507);
    const bicycle_lanes z508 = z375 * z429 + z374 * z399 + z367 * z397 + z366 * z428 - k41 * z500 - k35 *
        z501;
    const bicycle_lanes z509 = z508 + k28 * z503 + z341 * z421 - z211 * z466 - v2_x * z422 - k10 * (z332 *
        z402 - z338 * z421);
    const bicycle_lanes z510 = z507 - z509;
    bicycle_put(carried + 87 * BICYCLE_LANES, z510);
    const double z276 = kept[228];
    const double z280 = kept[232];
    const bicycle_lanes z511 = z280 * z430 - z276 * z433 - s1 * z505 + c1 * z510;
    bicycle_put(carried + 88 * BICYCLE_LANES, z511);
    const double z275 = kept[227];
    const double z278 = kept[230];
    const double z307 = kept[258];
    const double z315 = kept[266];
    const double z323 = kept[274];
    const bicycle_lanes z512 = z275 * z434 - z278 * z424 + z315 * z444 - z307 * z442 + z323 * z437 + c_roll *
        z511;
    const bicycle_lanes z513 = z512 - e2z * z496;
    bicycle_put(carried + 89 * BICYCLE_LANES, z513);
    const bicycle_lanes z514 = z39 * z513;
    bicycle_put(carried + 90 * BICYCLE_LANES, z514);
    const bicycle_lanes z515 = z15 * z471 + z13 * z514;
    bicycle_put(carried + 91 * BICYCLE_LANES, z515);
    const bicycle_lanes z516 = z15 * z498 + z14 * z514;
    bicycle_put(carried + 92 * BICYCLE_LANES, z516);
    const bicycle_lanes z517 = z30 * z499 - z23 * z515 + z25 * z516;
    bicycle_put(carried + 93 * BICYCLE_LANES, z517);
    const bicycle_lanes z518 = z34 * z499 + z24 * z515 - z18 * z516;
    bicycle_put(carried + 94 * BICYCLE_LANES, z518);
    const bicycle_lanes z519 = z279 * z444 + z274 * z442 - s_steer * z517 + c_steer * z518;
    bicycle_put(carried + 95 * BICYCLE_LANES, z519);
    const double z295 = kept[247];
    const bicycle_lanes z520 = z295 * z464 + z11 * z519;
    bicycle_put(carried + 96 * BICYCLE_LANES, z520);
    const bicycle_lanes z521 = roll_dot * z466;
    bicycle_put(carried + 97 * BICYCLE_LANES, z521);
    const double z12 = kept[50];
    const double z16 = kept[54];
    const double z43 = kept[81];
    const double z186 = kept[196];
    const bicycle_lanes z522 = z43 * z521 + z186 * z464 + z12 * z481 - z16 * z477;
    bicycle_put(carried + 98 * BICYCLE_LANES, z522);
    const double z184 = kept[194];
    const bicycle_lanes z523 = z184 * z522;
    bicycle_put(carried + 99 * BICYCLE_LANES, z523);
    const bicycle_lanes z524 = z11 * z523;
    bicycle_put(carried + 100 * BICYCLE_LANES, z524);
    const double z304 = kept[255];
    const double z313 = kept[264];
    const double z321 = kept[272];
    const double z329 = kept[280];
    const bicycle_lanes z525 = z329 * z434 - z321 * z438 + z304 * z443 - z313 * z445 - z280 * z482 - z276 *
        z478;
    bicycle_put(carried + 101 * BICYCLE_LANES, z525);
    const double z390 = kept[327];
    const bicycle_lanes z526 = z390 * z394;
    bicycle_put(carried + 102 * BICYCLE_LANES, z526);
    const bicycle_lanes z527 = z133 * z526;
    const bicycle_lanes z528 = z145 * z526;
    const bicycle_lanes z529 = z143 * z526;
    const double z146 = kept[173];
    const double z156 = kept[183];
    const double z370 = kept[315];
    const bicycle_lanes z530 = z394 * z370 + z146 * z526 + z156 * z526 + k63 * z527 - k56 * z528 + k48 * z529;
    const bicycle_lanes z531 = z144 * z526;
    const double z391 = kept[328];
    const bicycle_lanes z532 = z391 * z394 - z390 * z395;
    bicycle_put(carried + 103 * BICYCLE_LANES, z532);
    const double z392 = kept[329];
    const bicycle_lanes z533 = z392 * z394 - z390 * z396;
    bicycle_put(carried + 104 * BICYCLE_LANES, z533);
    const double z66 = kept[104];
    const double z76 = kept[114];
    const double z104 = kept[138];
    const double z114 = kept[148];
    const bicycle_lanes z534 = z530 + k41 * z527 + k35 * z531 + z104 * z532 + z114 * z532 + z66 * z533 + z76
        * z533;
    const double z112 = kept[146];
    const double z154 = kept[181];
    const double z364 = kept[309];
    const bicycle_lanes z535 = z364 * z394 + z154 * z526 + k48 * z527 - k45 * z528 + k43 * z529 + z112 * z532;
    const double z74 = kept[112];
    const bicycle_lanes z536 = z535 + z74 * z533;
    bicycle_put(carried + 105 * BICYCLE_LANES, z536);
    const bicycle_lanes z537 = z147 * z526;
    bicycle_put(carried + 106 * BICYCLE_LANES, z537);
    const bicycle_lanes z538 = z148 * z526;
    const double z75 = kept[113];
    const double z113 = kept[147];
    const double z155 = kept[182];
    const double z365 = kept[310];
    const bicycle_lanes z539 = z365 * z394 + z155 * z526 + k45 * z537 + k43 * z538 - z113 * z532 - z75 * z533;
    bicycle_put(carried + 107 * BICYCLE_LANES, z539);
    const bicycle_lanes z540 = z534 + k10 * (c_steer * z536 + s_steer * z539);
    bicycle_put(carried + 108 * BICYCLE_LANES, z540);
    const double z78 = kept[116];
    const double z116 = kept[150];
    const double z158 = kept[185];
    const double z373 = kept[318];
    const bicycle_lanes z541 = z373 * z394 + z158 * z526 + k40 * z527 + k34 * z531 + z116 * z532 + z78 * z533;
    const bicycle_lanes z542 = F_yy * z532;
    const bicycle_lanes z543 = F_yy * z533;
    bicycle_put(carried + 109 * BICYCLE_LANES, z543);
    const bicycle_lanes z544 = z150 * z526;
    bicycle_put(carried + 110 * BICYCLE_LANES, z544);
    const double z109 = kept[143];
    const double z151 = kept[178];
    const double z354 = kept[301];
    const bicycle_lanes z545 = z354 * z394 + z151 * z526 + k59 * z537 - k48 * z544 + k45 * z538 - z109 * z532;
    const double z71 = kept[109];
    const double z335 = kept[286];
    const bicycle_lanes z546 = z335 * z403 + 2.0 * (z163 * (F_yy * z526)) + z105 * z542 + z67 * z543 - (z545
        - z71 * z533);
    bicycle_put(carried + 111 * BICYCLE_LANES, z546);
    const double z110 = kept[144];
    const double z152 = kept[179];
    const double z359 = kept[304];
    const bicycle_lanes z547 = z359 * z394 + z152 * z526 + k62 * z527 - k55 * z528 + k45 * z529 + z110 * z532;
    const double z72 = kept[110];
    const bicycle_lanes z548 = z547 + z72 * z533;
    bicycle_put(carried + 112 * BICYCLE_LANES, z548);
    const bicycle_lanes z549 = z541 - s_steer * z546 + c_steer * z548;
    bicycle_put(carried + 113 * BICYCLE_LANES, z549);
    const bicycle_lanes z550 = c1 * z540 + s1 * z549;
    bicycle_put(carried + 114 * BICYCLE_LANES, z550);
    const bicycle_lanes z551 = z391 * z395;
    bicycle_put(carried + 115 * BICYCLE_LANES, z551);
    const bicycle_lanes z552 = z133 * z532;
    const bicycle_lanes z553 = z552 - z91 * z551;
    const bicycle_lanes z554 = z145 * z532 + z103 * z551;
    const bicycle_lanes z555 = z143 * z532 - z101 * z551;
    const bicycle_lanes z556 = z392 * z395 + z391 * z396;
    bicycle_put(carried + 116 * BICYCLE_LANES, z556);
    const double z369 = kept[314];
    const bicycle_lanes z557 = z369 * z395 - z104 * z551 + k63 * z553 - k56 * z554 + k48 * z555 - z66 * z556;
    const bicycle_lanes z558 = z552 - z90 * z551;
    const bicycle_lanes z559 = z144 * z532 - z102 * z551;
    const bicycle_lanes z560 = z364 * z395 + z112 * z551 - k48 * z553 + k45 * z554 - k43 * z555 + z74 * z556;
    bicycle_put(carried + 117 * BICYCLE_LANES, z560);
    const bicycle_lanes z561 = z147 * z532 + z105 * z551;
    bicycle_put(carried + 118 * BICYCLE_LANES, z561);
    const bicycle_lanes z562 = z148 * z532 + z106 * z551;
    const bicycle_lanes z563 = z365 * z395 - z113 * z551 - k45 * z561 - k43 * z562 - z75 * z556;
    bicycle_put(carried + 119 * BICYCLE_LANES, z563);
    const double z368 = kept[313];
    const bicycle_lanes z564 = z557 - (z368 * z395 + z114 * z551 - k41 * z558 - k35 * z559 + z76 * z556) -
        k10 * (c_steer * z560 + s_steer * z563);
    bicycle_put(carried + 120 * BICYCLE_LANES, z564);
    const bicycle_lanes z565 = z335 * z404 - z354 * z395 - z163 * z542 + 2.0 * (z105 * (F_yy * z551)) + z109
        * z551;
    const bicycle_lanes z566 = z150 * z532 + z108 * z551;
    bicycle_put(carried + 121 * BICYCLE_LANES, z566);
    const bicycle_lanes z567 = F_yy * z556;
    bicycle_put(carried + 122 * BICYCLE_LANES, z567);
    const bicycle_lanes z568 = z565 + k59 * z561 - k48 * z566 + k45 * z562 + z67 * z567 + z71 * z556;
    bicycle_put(carried + 123 * BICYCLE_LANES, z568);
    const bicycle_lanes z569 = z373 * z395 + z116 * z551 - k40 * z558 - k34 * z559 + z78 * z556 - s_steer *
        z568;
    const bicycle_lanes z570 = z359 * z395 + z110 * z551 - k62 * z553 + k55 * z554 - k45 * z555 + z72 * z556;
    bicycle_put(carried + 124 * BICYCLE_LANES, z570);
    const bicycle_lanes z571 = z569 + c_steer * z570;
    bicycle_put(carried + 125 * BICYCLE_LANES, z571);
    const bicycle_lanes z572 = c1 * z564 - s1 * z571;
    bicycle_put(carried + 126 * BICYCLE_LANES, z572);
    const bicycle_lanes z573 = z392 * z396;
    bicycle_put(carried + 127 * BICYCLE_LANES, z573);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part2(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)seed;
    (void)t;
    const double z133 = kept[162];
    const bicycle_lanes z533 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z574 = z133 * z533;
    const double z53 = kept[91];
    const bicycle_lanes z573 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z575 = z53 * z573;
    const double z91 = kept[127];
    const bicycle_lanes z556 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z576 = z574 - z91 * z556 - z575;
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z145 = kept[172];
    const bicycle_lanes z577 = z145 * z533 + z103 * z556 + z65 * z573;
    const double z63 = kept[101];
    const double z101 = kept[135];
    const double z143 = kept[170];
    const bicycle_lanes z578 = z143 * z533 - z101 * z556 - z63 * z573;
    const double k48 = kept[24];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const double z66 = kept[104];
    const double z76 = kept[114];
    const double z370 = kept[315];
    const bicycle_lanes z396 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z579 = z396 * z370 + z66 * z573 + z76 * z573 - k63 * z576 + k56 * z577 - k48 * z578;
    const double z90 = kept[126];
    const bicycle_lanes z580 = z574 - z90 * z556 - z575;
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z144 = kept[171];
    const bicycle_lanes z581 = z144 * z533 - z102 * z556 + z64 * z573;
    const double z44 = kept[82];
    const bicycle_lanes z582 = z44 * z573;
    const double k43 = kept[22];
    const double k45 = kept[23];
    const double z74 = kept[112];
    const double z364 = kept[309];
    const bicycle_lanes z583 = z364 * z396 + z74 * z573 - k48 * z576 + k45 * z577 - k43 * z578;
    const double z67 = kept[105];
    const double z105 = kept[139];
    const double z147 = kept[174];
    const bicycle_lanes z584 = z147 * z533 + z105 * z556 + z67 * z573;
    const double z68 = kept[106];
    const double z106 = kept[140];
    const double z148 = kept[175];
    const bicycle_lanes z585 = z148 * z533 + z106 * z556 + z68 * z573;
    const double z75 = kept[113];
    const double z365 = kept[310];
    const bicycle_lanes z586 = z365 * z396 - z75 * z573 - k45 * z584 - k43 * z585;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const bicycle_lanes z587 = c_steer * z583 + s_steer * z586;
    const double k10 = kept[9];
    const double k28 = kept[16];
    const double k35 = kept[18];
    const double k41 = kept[21];
    const bicycle_lanes z588 = z579 - k41 * z580 - k35 * z581 + k28 * z582 + k10 * z587;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z163 = kept[188];
    const double z335 = kept[286];
    const double z354 = kept[301];
    const bicycle_lanes z405 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z543 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z567 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z589 = z335 * z405 - z354 * z396 - z163 * z543 + z105 * z567 + 2.0 * (z67 * (F_yy *
        z573));
    const double z70 = kept[108];
    const double z108 = kept[142];
    const double z150 = kept[177];
    const bicycle_lanes z590 = z150 * z533 + z108 * z556 + z70 * z573;
    const double k59 = kept[27];
    const double z71 = kept[109];
    const bicycle_lanes z591 = z589 + z71 * z573 + k59 * z584 - k48 * z590 + k45 * z585;
    const double k27 = kept[15];
    const double k34 = kept[17];
    const double k40 = kept[20];
    const double z78 = kept[116];
    const double z373 = kept[318];
    const bicycle_lanes z592 = z373 * z396 + z78 * z573 - k40 * z580 - k34 * z581 + k27 * z582 - s_steer *
        z591;
    const double k55 = kept[25];
    const double k62 = kept[28];
    const double z72 = kept[110];
    const double z359 = kept[304];
    const bicycle_lanes z593 = z359 * z396 + z72 * z573 - k62 * z576 + k55 * z577 - k45 * z578;
    const bicycle_lanes z594 = z592 + c_steer * z593;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z595 = c1 * z588 + s1 * z594;
    const double z51 = kept[89];
    const double z88 = kept[124];
    const double z131 = kept[160];
    const double z206 = kept[215];
    const double z294 = kept[246];
    const double z381 = kept[326];
    const bicycle_lanes z511 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z522 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z525 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z550 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z572 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z596 = 2.0 * (z294 * z522 * z381) - (z525 - z206 * z511 - z131 * z550 - z88 * z572 +
        z51 * z595);
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z532 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z597 = R_yy * z532;
    const bicycle_lanes z598 = R_yy * z533;
    const double z73 = kept[111];
    const double z111 = kept[145];
    const double z153 = kept[180];
    const double z362 = kept[307];
    const bicycle_lanes z394 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z526 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z537 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z544 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z599 = z362 * z394 + z153 * z526 - k48 * z537 + k43 * z544 - z111 * z532 - z73 * z533;
    const double z140 = kept[167];
    const bicycle_lanes z600 = z140 * z526;
    const double z149 = kept[176];
    const bicycle_lanes z601 = z149 * z526;
    const double k26 = kept[14];
    const double z79 = kept[117];
    const double z118 = kept[152];
    const double z160 = kept[187];
    const double z376 = kept[321];
    const bicycle_lanes z602 = z376 * z394 + z160 * z526 - k28 * z600 + k26 * z601 - z118 * z532 - z79 * z533;
    const bicycle_lanes z603 = z599 + z602;
    const double z13 = kept[51];
    const double z61 = kept[99];
    const double z99 = kept[133];
    const double z141 = kept[168];
    const double z337 = kept[288];
    const bicycle_lanes z415 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z604 = z337 * z415 + 2.0 * (z141 * (R_yy * z526)) - z99 * z597 - z61 * z598 + z13 *
        z603;
    const double z142 = kept[169];
    const bicycle_lanes z605 = z142 * z526;
    const double z80 = kept[118];
    const double z117 = kept[151];
    const double z159 = kept[186];
    const double z378 = kept[323];
    const bicycle_lanes z606 = z378 * z394 - z159 * z526 - k27 * z600 - k26 * z605 + z117 * z532 + z80 * z533;
    const bicycle_lanes z536 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z539 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z607 = z606 + s_steer * z536 - c_steer * z539;
    const double z17 = kept[55];
    const bicycle_lanes z608 = z604 - z17 * z607;
    const double z39 = kept[77];
    const bicycle_lanes z609 = z39 * z608;
    const double k37 = kept[19];
    const double z115 = kept[149];
    const double z157 = kept[184];
    const double z372 = kept[317];
    const bicycle_lanes z610 = z372 * z394 - z157 * z526 - k37 * z600 + k28 * z601 - k27 * z605 + z115 * z532;
    const double z77 = kept[115];
    const bicycle_lanes z546 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z548 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z611 = z610 + z77 * z533 + c_steer * z546 + s_steer * z548 + k10 * z599 + z608;
    const bicycle_lanes z612 = z39 * z611;
    const double z128 = kept[157];
    const double z129 = kept[158];
    const double z200 = kept[209];
    const double z201 = kept[210];
    const double z317 = kept[268];
    const double z327 = kept[278];
    const bicycle_lanes z425 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z426 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z471 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z498 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z613 = z327 * z425 + z317 * z426 - z201 * z471 + z200 * z498 + z129 * z609 - z128 *
        z612;
    const bicycle_lanes z614 = R_yy * z556;
    const bicycle_lanes z395 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z551 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z561 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z566 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z615 = z362 * z395 - z111 * z551 + k48 * z561 - k43 * z566 - z73 * z556;
    const double z98 = kept[132];
    const bicycle_lanes z616 = z140 * z532 + z98 * z551;
    const double z107 = kept[141];
    const bicycle_lanes z617 = z149 * z532 + z107 * z551;
    const bicycle_lanes z618 = z615 + (z376 * z395 - z118 * z551 + k28 * z616 - k26 * z617 - z79 * z556);
    const bicycle_lanes z416 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z619 = z337 * z416 - z141 * z597 - 2.0 * (z99 * (R_yy * z551)) - z61 * z614 + z13 *
        z618;
    const double z100 = kept[134];
    const bicycle_lanes z620 = z142 * z532 + z100 * z551;
    const bicycle_lanes z560 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z621 = z378 * z395 + z117 * z551 + k27 * z616 + k26 * z620 + z80 * z556 + s_steer *
        z560;
    const bicycle_lanes z563 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z622 = z621 - c_steer * z563;
    const bicycle_lanes z623 = z619 - z17 * z622;
    const bicycle_lanes z624 = z39 * z623;
    const bicycle_lanes z625 = z372 * z395 + z115 * z551 + k37 * z616 - k28 * z617 + k27 * z620 + z77 * z556;
    const bicycle_lanes z568 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z570 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z626 = z625 + c_steer * z568 + s_steer * z570 + k10 * z615 + z623;
    const bicycle_lanes z627 = z39 * z626;
    const bicycle_lanes z628 = z362 * z396 - z73 * z573 + k48 * z584 - k43 * z590;
    const double z60 = kept[98];
    const bicycle_lanes z629 = z140 * z533 + z98 * z556 + z60 * z573;
    const double z69 = kept[107];
    const bicycle_lanes z630 = z149 * z533 + z107 * z556 + z69 * z573;
    const bicycle_lanes z631 = z628 + (z376 * z396 - z79 * z573 + k28 * z629 - k26 * z630);
    const bicycle_lanes z417 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z632 = z337 * z417 - z141 * z598 - z99 * z614 - 2.0 * (z61 * (R_yy * z573)) + z13 *
        z631;
    const double z62 = kept[100];
    const bicycle_lanes z633 = z142 * z533 + z100 * z556 + z62 * z573;
    const bicycle_lanes z634 = z378 * z396 + z80 * z573 + k27 * z629 + k26 * z633 + s_steer * z583 - c_steer
        * z586;
    const bicycle_lanes z635 = z632 - z17 * z634;
    const bicycle_lanes z636 = z39 * z635;
    const bicycle_lanes z637 = z372 * z396 + z77 * z573 + k37 * z629 - k28 * z630 + k27 * z633 + c_steer *
        z591;
    const bicycle_lanes z638 = z637 + s_steer * z593 + k10 * z628 + z635;
    const bicycle_lanes z639 = z39 * z638;
    const double z202 = kept[211];
    const double z204 = kept[213];
    const double z205 = kept[214];
    const double z326 = kept[277];
    const double z328 = kept[279];
    const double z336 = kept[287];
    const bicycle_lanes z423 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z424 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z435 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z470 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z497 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z513 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z640 = z336 * z423 + z326 * z424 - z328 * z435 - z205 * z470 + z204 * z497 + z202 *
        z513;
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z641 = c_roll * z550 - e2z * z611;
    const bicycle_lanes z642 = c_roll * z572 + e2z * z626;
    const double z87 = kept[123];
    const double z94 = kept[130];
    const double z96 = kept[131];
    const double z130 = kept[159];
    const double z136 = kept[165];
    const double z138 = kept[166];
    const bicycle_lanes z643 = z640 + z136 * z608 - z138 * z611 + z130 * z641 + z94 * z623 - z96 * z626 + z87
        * z642;
    const bicycle_lanes z644 = c_roll * z595 - e2z * z638;
    const double z50 = kept[88];
    const double z56 = kept[94];
    const double z58 = kept[96];
    const double z189 = kept[199];
    const bicycle_lanes z645 = z189 * (z643 + z56 * z635 - z58 * z638 - z50 * z644);
    const double z26 = kept[64];
    const double z48 = kept[86];
    const double z49 = kept[87];
    const double z85 = kept[121];
    const double z86 = kept[122];
    const bicycle_lanes z646 = z613 + z86 * z624 - z85 * z627 + z49 * z636 - z48 * z639 - z26 * z645;
    const double z14 = kept[52];
    const bicycle_lanes z647 = z14 * z609 - z13 * z612;
    const bicycle_lanes z648 = z14 * z636 - z13 * z639;
    const double z7 = kept[45];
    const double z41 = kept[79];
    const double z197 = kept[206];
    const double z324 = kept[275];
    const bicycle_lanes z649 = z324 * z425 - z197 * z471 - z7 * z609 + z41 * z636 - z13 * z645;
    const bicycle_lanes z650 = z324 * z426 + z197 * z498 + z7 * z612 - z41 * z639 + z14 * z645;
    const double z18 = kept[56];
    const double z20 = kept[58];
    const double z24 = kept[62];
    const double z47 = kept[85];
    const double z199 = kept[208];
    const double z316 = kept[267];
    const bicycle_lanes z439 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z499 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z651 = z316 * z439 - z199 * z499 + z20 * z647 - z47 * z648 - z24 * z649 - z18 * z650;
    const bicycle_lanes z652 = z14 * z624 - z13 * z627;
    const double z8 = kept[46];
    const double z23 = kept[61];
    const double z25 = kept[63];
    const double z46 = kept[84];
    const double z198 = kept[207];
    const double z308 = kept[259];
    const bicycle_lanes z653 = z308 * z439 - z198 * z499 + z8 * z652 + z46 * z648 + z23 * z649 + z25 * z650;
    const double z332 = kept[283];
    const double z338 = kept[290];
    const bicycle_lanes z418 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z422 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z654 = z332 * z418 + z338 * z422;
    const double roll_dot = y[9];
    const double z81 = kept[119];
    const double z379 = kept[324];
    const bicycle_lanes z655 = roll_dot * z654 - (z379 * z396 + z81 * z573 - k28 * z580 - k27 * z581 + k26 *
        z582);
    const bicycle_lanes z656 = z39 * z644;
    const double z15 = kept[53];
    const bicycle_lanes z657 = z15 * z636 + z13 * z656;
    const bicycle_lanes z658 = z15 * z639 + z14 * z656;
    const double z30 = kept[68];
    const bicycle_lanes z659 = z30 * z648 - z23 * z657 + z25 * z658;
    const double z34 = kept[72];
    const bicycle_lanes z660 = z34 * z648 + z24 * z657 - z18 * z658;
    const bicycle_lanes z661 = s_steer * z659 - c_steer * z660;
    const bicycle_lanes z662 = z655 - z587 - z661;
    const double z43 = kept[81];
    const double z293 = kept[245];
    const double z296 = kept[248];
    const double z299 = kept[250];
    const double z318 = kept[269];
    const double z343 = kept[294];
    const bicycle_lanes z464 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z477 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z481 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z521 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z523 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z663 = z318 * z481 - z299 * z477 + z343 * z521 + z296 * z464 - z293 * z523 + z43 *
        z662;
    const double z203 = kept[212];
    const double z210 = kept[219];
    const double z325 = kept[276];
    const bicycle_lanes z436 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z467 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z514 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z664 = z337 * z418 + z325 * z426 - z327 * z436 + z210 * z467 + z203 * z498 + z201 *
        z514;
    const bicycle_lanes z665 = z39 * z641;
    const bicycle_lanes z666 = z39 * z642;
    const double z93 = kept[129];
    const double z135 = kept[164];
    const bicycle_lanes z667 = z664 - z141 * z603 - z135 * z612 - z129 * z665 - z99 * z618 + z93 * z627 + z86
        * z666;
    const double z278 = kept[230];
    const bicycle_lanes z438 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z668 = z325 * z425 + z317 * z436 + z278 * z438 - z203 * z471 - z200 * z514 + z135 *
        z609;
    const double z35 = kept[73];
    const double z55 = kept[93];
    const bicycle_lanes z669 = z668 + z128 * z665 - z93 * z624 - z85 * z666 - z55 * z636 + z48 * z656 - z35 *
        z645;
    const bicycle_lanes z670 = z669 - e2z * z646;
    const double z36 = kept[74];
    const bicycle_lanes z671 = z667 - z61 * z631 + z55 * z639 - z49 * z656 + z36 * z645 + z670;
    const double z274 = kept[226];
    const double z279 = kept[231];
    const bicycle_lanes z468 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z475 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z476 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z672 = z337 * z422 - z210 * z468 + z279 * z475 - z274 * z476 - z141 * z607 - z99 *
        z622;
    const bicycle_lanes z673 = z15 * z612 + z14 * z665;
    const bicycle_lanes z674 = z324 * z436 - z197 * z514 - z7 * z665 + z41 * z656 + z15 * z645;
    const bicycle_lanes z441 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z516 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z675 = z316 * z441 + z199 * z516 - z20 * z673 + z47 * z658 + z34 * z650 + z24 * z674;
    const bicycle_lanes z676 = z15 * z609 + z13 * z665;
    const bicycle_lanes z440 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z443 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z515 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z677 = z316 * z440 + z278 * z443 - z199 * z515 + z20 * z676 - z47 * z657 + z34 * z649;
    const bicycle_lanes z678 = z677 - z18 * z674 - e2z * z651;
    const bicycle_lanes z679 = z15 * z624 - z13 * z666;
    const bicycle_lanes z445 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z680 = z308 * z440 + z278 * z445 - z198 * z515 + z8 * z679 + z46 * z657 + z30 * z649;
    const bicycle_lanes z681 = z680 + z25 * z674 - e2z * z653;
    const bicycle_lanes z452 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z453 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z682 = z279 * z452 - z274 * z453 - s_steer * z678 - c_steer * z681;
    const bicycle_lanes z683 = z15 * z627 - z14 * z666;
    const bicycle_lanes z684 = z308 * z441 + z198 * z516 - z8 * z683 - z46 * z658 + z30 * z650 - z23 * z674;
    const bicycle_lanes z685 = z672 - z61 * z634 + s_steer * z675 - z682 + c_steer * z684;
    const double z10 = kept[48];
    const double z11 = kept[49];
    const double z12 = kept[50];
    const double z16 = kept[54];
    const double z29 = kept[67];
    const double z33 = kept[71];
    const double z184 = kept[194];
    const double z185 = kept[195];
    const double z186 = kept[196];
    const double z275 = kept[227];
    const bicycle_lanes z519 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z520 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z524 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z686 = z185 * z520 + (z275 * z524 - z596 - z10 * z646 + z29 * z651 - z33 * z653) -
        c_roll * (z11 * (z184 * (z186 * z519 - z663 + z12 * z671 - z16 * z685)));
    const double k72 = kept[35];
    const double k75 = kept[38];
    const double k76 = kept[39];
    const bicycle_lanes z410 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z411 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z412 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z687 = k76 * z410 + k75 * z411 - k72 * z412;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double k67 = kept[30];
    const double k69 = kept[32];
    const double z295 = kept[247];
    const bicycle_lanes z397 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z399 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z462 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z688 = z274 * z462 - (s_steer * z687 + (k69 * z397 + k67 * z399 + r_R * (z295 * z481
        + z11 * z671)));
    const bicycle_lanes z689 = z36 * z471 - z35 * z498 - z26 * z514;
    const double z192 = kept[202];
    const double z194 = kept[203];
    const double z288 = kept[240];
    const double z309 = kept[260];
    const bicycle_lanes z437 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z442 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z518 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z690 = z288 * z442 - z309 * z437 + z194 * z518 - z192 * z689 + z36 * z609 - z35 *
        z612;
    const bicycle_lanes z691 = z36 * z636 - z35 * z639 - z26 * z656;
    const double z40 = kept[78];
    const bicycle_lanes z446 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z448 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z692 = z274 * z446 + z279 * z448 - z34 * z652 - z24 * z679 + z18 * z683 - z40 * z691;
    const bicycle_lanes z693 = z275 * z438 + c_roll * z646;
    const double z280 = kept[232];
    const bicycle_lanes z447 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z694 = z280 * z447 + s1 * z693;
    const bicycle_lanes z695 = z275 * z443 + c_roll * z651;
    const double z276 = kept[228];
    const bicycle_lanes z449 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z696 = z276 * z449 - c1 * z695;
    const bicycle_lanes z697 = z690 - z26 * z665 - s1 * z660 + (z692 + c_steer * z670 - s_steer * z694 -
        z696);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k71 = kept[34];
    const double k74 = kept[37];
    const double z5 = kept[43];
    const double z282 = kept[234];
    const double z285 = kept[237];
    const bicycle_lanes z400 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z406 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z451 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z461 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z698 = z282 * z461 - k74 * z400 - k72 * z406 - k71 * z400 - r_F * (z285 * z451 - z5 *
        z697);
    const double z195 = kept[204];
    const double z292 = kept[244];
    const bicycle_lanes z444 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z517 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z699 = z309 * z444 + z292 * z442 + z192 * z517 + z195 * z518 - z30 * z647 + z23 *
        z676;
    const bicycle_lanes z700 = z280 * z449 + s1 * z695;
    const bicycle_lanes z701 = z275 * z445 + c_roll * z653;
    const bicycle_lanes z456 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z702 = z280 * z456 + s1 * z701;
    const double z42 = kept[80];
    const bicycle_lanes z455 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z457 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z703 = z699 - z25 * z673 + z40 * z659 - z42 * z660 + (z682 - (z274 * z455 + z279 *
        z457 + c_steer * z700 - s_steer * z702));
    const double z6 = kept[44];
    const double z19 = kept[57];
    const double z187 = kept[197];
    const double z283 = kept[235];
    const double z286 = kept[238];
    const double z289 = kept[241];
    const bicycle_lanes z458 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z460 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z704 = z5 * (z187 * (z286 * z451 - z289 * z458 + z283 * z460 - z6 * z697 + z19 *
        z703));
    const double z284 = kept[236];
    const double z380 = kept[325];
    const bicycle_lanes z459 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z705 = z284 * z459 * z380 + 0.5 * z704;
    const double z4 = kept[42];
    const bicycle_lanes z706 = z698 + 2.0 * (z4 * z705);
    const bicycle_lanes z707 = z688 + c_steer * z706;
    const double k68 = kept[31];
    const double k70 = kept[33];
    const double k73 = kept[36];
    const double z277 = kept[229];
    const bicycle_lanes z398 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z401 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z708 = z277 * z461 - k73 * z400 + k72 * z401 + k70 * z400 - k68 * z397 + k67 * z398;
    const double z2 = kept[40];
    const bicycle_lanes z709 = z708 + r_F * (z285 * z458 + z5 * z703) + r_R * (z295 * z477 + z11 * z685) -
        2.0 * (z2 * z705);
    const bicycle_lanes z463 = bicycle_get(carried + 59 * BICYCLE_LANES);
    const bicycle_lanes z710 = roll_dot * z463 + (z686 + r_R * (z295 * z521 - z11 * z662) - s1 * z707 - c1 *
        z709);
    const bicycle_lanes z711 = z11 * z464;
    const bicycle_lanes z434 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z712 = z206 * z434 + r_R * (z11 * z521) + z10 * z438 - z29 * z443 + z33 * z445 + z185
        * z711;
    const bicycle_lanes z478 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z482 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z713 = z712 - c_roll * z524 + s1 * z482 - c1 * z478;
    const double z306 = kept[257];
    const double z314 = kept[265];
    const double z322 = kept[273];
    const double z329 = kept[280];
    const bicycle_lanes z427 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z496 = bicycle_get(carried + 81 * BICYCLE_LANES);
    const bicycle_lanes z714 = z329 * z424 + z322 * z438 - z306 * z443 + z314 * z445 + z206 * z496 - k68 *
        z427;
    const bicycle_lanes z428 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z429 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z715 = z714 - k69 * z428 + k67 * z429 + z131 * z611 - z88 * z626 - z51 * z638 - z14 *
        z646;
    const bicycle_lanes z716 = c_steer * z687 - (roll_dot * z713 + (z279 * z462 - (z715 + z23 * z651 + z24 *
        z653))) + s_steer * z706;
    bicycle_put(slope + 0 * BICYCLE_LANES, c_roll * z716 - e2z * z710);
    const double k16 = kept[10];
    const double z290 = kept[242];
    const bicycle_lanes z717 = z290 * z442 - z20 * z518 - k16 * z518;
    const double z287 = kept[239];
    const bicycle_lanes z718 = z290 * z444 + z287 * z437 - z20 * z517 - z7 * z689;
    const double k4 = kept[8];
    const bicycle_lanes z719 = z718 - (k16 * z517 + k4 * z689);
    const bicycle_lanes z472 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z473 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z505 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z720 = z505 + z274 * z472 + z279 * z473 - c_steer * z717 + s_steer * z719;
    const double z89 = kept[125];
    const double z132 = kept[161];
    const double z208 = kept[217];
    const double z303 = kept[254];
    const double z331 = kept[282];
    const double z333 = kept[284];
    const bicycle_lanes z433 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z483 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z510 = bicycle_get(carried + 87 * BICYCLE_LANES);
    const bicycle_lanes z540 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z564 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z721 = z333 * z433 - z303 * z449 + z208 * z483 + z331 * z510 + z132 * z540 + z89 *
        z564;
    const double z21 = kept[59];
    const bicycle_lanes z722 = z21 * z660;
    const bicycle_lanes z723 = z8 * z691 + z20 * z659 + k16 * z659;
    const double z28 = kept[66];
    const double z52 = kept[90];
    const double z312 = kept[263];
    const bicycle_lanes z724 = z312 * z456 - (z594 + (z721 - z52 * z588)) + c_steer * z722 - s_steer * z723 +
        z28 * z695;
    const bicycle_lanes z725 = z287 * z442 - z7 * z518 - k4 * z518;
    const bicycle_lanes z726 = z725 + (z510 - k10 * z519);
    const double z302 = kept[253];
    const double z311 = kept[262];
    const double z320 = kept[271];
    const bicycle_lanes z430 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z479 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z727 = z333 * z430 - z320 * z447 - z302 * z449 - z311 * z456 - z208 * z479 - z331 *
        z505;
    const bicycle_lanes z549 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z571 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z728 = z727 + z132 * z549 - z89 * z571 - z588 - z52 * z594 + z7 * z660 + k4 * z660;
    const double z9 = kept[47];
    const double z27 = kept[65];
    const double z31 = kept[69];
    const bicycle_lanes z729 = z275 * z482 + (roll_dot * z726 + (z728 + z9 * z693 - z27 * z695 + z31 * z701)
        - k10 * z661);
    const double z32 = kept[70];
    const bicycle_lanes z730 = s1 * (z275 * z478 - (roll_dot * z720 - (z724 - z32 * z701)) - c_roll * z709) +
        c1 * (z729 + c_roll * z707);
    bicycle_put(slope + 1 * BICYCLE_LANES, -z730);
    const double z190 = kept[200];
    const double z196 = kept[205];
    const double z209 = kept[218];
    const bicycle_lanes z407 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z413 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z450 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z731 = z332 * z413 - z209 * z407 + z196 * z442 - z190 * z472 + z8 * z446 + k10 * z450;
    const double z3 = kept[41];
    const double z22 = kept[60];
    const bicycle_lanes z732 = z731 - z22 * z453 + z21 * z455 + z17 * z476 - z3 * z462;
    const double z297 = kept[249];
    const double z330 = kept[281];
    const double z334 = kept[285];
    const double z342 = kept[293];
    const double z347 = kept[296];
    const bicycle_lanes z419 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z420 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z489 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z733 = z342 * z419 - z347 * z420 + z334 * z407 + z330 * z413 - z332 * z489 + z297 *
        z444;
    const double z291 = kept[243];
    const double z300 = kept[251];
    const double z305 = kept[256];
    const bicycle_lanes z495 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z734 = z733 - z291 * z473 + z287 * z448 + z305 * z452 - z300 * z475 + z290 * z457 -
        z209 * z495;
    const double z134 = kept[163];
    const bicycle_lanes z735 = z734 + z144 * z546 + z140 * z548 + z142 * z536 - z134 * z539 - z102 * z568 +
        z98 * z570;
    const double z54 = kept[92];
    const double z92 = kept[128];
    const bicycle_lanes z736 = z735 + z100 * z560 + z92 * z563 + z64 * z591 + z60 * z593 + z62 * z583 + z54 *
        z586;
    const double z45 = kept[83];
    const bicycle_lanes z737 = z190 * z719 + (z196 * z517 - z736) - z45 * z659 + c1 * z723 + z8 * z694 + z22
        * z678;
    const bicycle_lanes z738 = z3 * z687 - (z737 + z17 * z675 + z21 * z702 - k10 * (z276 * z456 - c1 * z701));
    const bicycle_lanes z739 = z332 * z407 + z209 * z413 + z196 * z444 - z190 * z473 + z8 * z448 + z22 * z452;
    const bicycle_lanes z740 = z739 - z17 * z475 + z21 * z457 + k10 * (c1 * z456) - e2z * z462;
    const bicycle_lanes z741 = z347 * z419 + z342 * z420 + z334 * z413 - z330 * z407 - z332 * z495 + z297 *
        z442;
    const double z281 = kept[233];
    const bicycle_lanes z742 = z741 - z291 * z472 + z287 * z446 - z305 * z453 + z290 * z455 + z300 * z476 +
        z281 * z462;
    const bicycle_lanes z743 = z742 + z209 * z489 - z140 * z546 + z144 * z548 + z134 * z536 + z142 * z539 -
        z98 * z568;
    const bicycle_lanes z744 = z743 - z102 * z570 - z92 * z560 + z100 * z563 - z60 * z591 + z64 * z593 - z54
        * z583;
    const bicycle_lanes z745 = z190 * z717 + (z196 * z518 - (z744 + z62 * z586)) - z45 * z660 + c1 * z722 +
        z8 * z670;
    const double steer_dot = y[10];
    const bicycle_lanes z746 = steer_dot * z740 + (z745 - k10 * z696 - z22 * z681 + z21 * z700 - z17 * z684 -
        z3 * z706);
    const bicycle_lanes z747 = c_steer * (steer_dot * z732 - (z278 * z462 - z738) + e2z * z706) - s_steer *
        (e2z * z687 + z746);
    bicycle_put(slope + 2 * BICYCLE_LANES, z747);
    const double z344 = kept[295];
    const bicycle_lanes z466 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z474 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z480 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z748 = z276 * z474 + z280 * z480 + z344 * z466 + z44 * z654 + r_R * (z275 * z711 -
        c_roll * z520);
    bicycle_put(slope + 3 * BICYCLE_LANES, c_roll * z463 - (z748 + c1 * z720 + s1 * z726 + e2z * z713));
    const bicycle_lanes z507 = bicycle_get(carried + 86 * BICYCLE_LANES);
    bicycle_put(slope + 4 * BICYCLE_LANES, s_steer * z732 - (z507 + z725 - c_steer * z740));
    const bicycle_lanes z488 = bicycle_get(carried + 78 * BICYCLE_LANES);
    bicycle_put(slope + 5 * BICYCLE_LANES, z718 - z488);
}

BICYCLE_SLOW
int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[330]; /* what parts of this function leave for others */
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

    /* one coordinate in each pass: a column of the velocities' rows */
    for (int first = 0; first < 4; first += BICYCLE_LANES) {
        static const int offset[] = {3, 4, 5, 6};
        static const int entry[] = {0, 12, 24, 36, 60, 84};
        double seed[4 * BICYCLE_LANES];
        double slope[6 * BICYCLE_LANES];
        bicycle_unit(4, first, seed);
        bicycle_jacobian_sweep1(t, y, p, kept, seed, slope);
        bicycle_place(4 - first, offset + first, 6, entry, slope, J);
    }

    /* one rate in each pass: its row of the matrix */
    for (int first = 0; first < 3; first += BICYCLE_LANES) {
        static const int offset[] = {108, 120, 132};
        static const int entry[] = {4, 5, 6, 9, 10, 11};
        double seed[3 * BICYCLE_LANES];
        double carried[128 * BICYCLE_LANES];
        double slope[6 * BICYCLE_LANES];
        bicycle_unit(3, first, seed);
        bicycle_jacobian_sweep2_part1(t, y, p, kept, seed, carried, slope);
        bicycle_jacobian_sweep2_part2(t, y, p, kept, seed, carried, slope);
        bicycle_place(3 - first, offset + first, 6, entry, slope, J);
    }
    return bicycle_finish(144, J);
}

BICYCLE_SLOW
int bicycle_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */

    /* sines and cosines */
    const double e2z = sin(roll);
    const double c_roll = cos(roll);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
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
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);
    const double k5 = fabs(r_R);
    const double k6 = fabs(r_F);
    const double k7 = fabs(w);
    const double k8 = fabs(c);
    const double k9 = 9.0 * k6;
    const double k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9));
    const double k11 = 6.0 * k7;
    const double k12 = 13.0 * k8 + (14.0 * k6 + k11);
    const double k13 = 10.0 * k8 + (k9 + k11);

    /* state */
    const double z1 = e2z * s_steer;
    const double z2 = s_pitch * c_lam + c_pitch * s_lam;
    const double z3 = c_roll * z2;
    const double z4 = z1 - c_steer * z3;
    const double z5 = c_pitch * c_lam - s_pitch * s_lam;
    const double z6 = c_roll * z5;
    const double z7 = r_F / sqrt(z6 * z6 + z4 * z4);
    const double z8 = z4 * z7;
    const double z9 = k2 + z8;
    const double z10 = c_roll * c_roll;
    const double z11 = 1.0 / sqrt(z10);
    const double z12 = r_R * z11;
    const double z13 = z3 * z12;
    const double z14 = k3 + z13 + c_steer * z9;
    const double z15 = z9 * (s_steer * z3) + e2z * z14;
    const double z16 = z6 * z12;
    const double z17 = c_steer * z16;
    const double z18 = z6 * z7;
    const double z19 = k4 + z18;
    const double z20 = z16 - z19;
    const double z21 = s_steer * z20;
    const double z22 = c_steer * z20;
    const double z23 = s_steer * z16;
    const double z24 = z2 * z19;
    const double z25 = c_roll * (c_steer * z24 + z5 * (c_steer * k3 + z9)) + e2z * z21;
    const double z26 = c_roll * (s_steer * z24 + k3 * (s_steer * z5)) - e2z * z22;
    const double z27 = z22 * z25 + z26 * z21;
    const double z28 = z15 * (z17 * z21 - z22 * z23) - z14 * (z17 * z25 + z26 * z23) + z13 * z27;
    const double z29 = k5 * (9.0 + fabs(z11));
    const double z30 = roll_dot * z5;
    const double z31 = s_steer * z30;
    const double z32 = thF_dot - z31;
    const double z33 = roll_dot * z2;
    const double z34 = steer_dot + z33;
    const double z35 = c_steer * z30;
    const double z36 = c_roll * (roll_dot * z12) + k3 * z33;
    const double z37 = z34 * z8 - z35 * z18 - (k4 * z35 - k2 * z34 - c_steer * z36);
    const double z38 = z32 * z18 - (k4 * z31 - s_steer * z36);
    const double z39 = z27 * (k2 * z31 - z32 * z8) + (z15 * (z22 * z37 + z21 * z38) - z14 * (z25 * z38 - z26
        * z37));
    const double z40 = s_pitch * c_roll;
    const double e3z = c_pitch * c_roll;
    const double z41 = c_steer * (z40 * c_lam + e3z * s_lam) - z1;
    const double z42 = z40 * s_lam - e3z * c_lam;
    const double z43 = c_lam * z41 + s_lam * z42;
    const double z44 = c_lam * z42 - s_lam * z41;
    const double z45 = r_F * z44;
    const double z46 = z43 * z43;
    const double z47 = 1.0 / sqrt(z46 + z44 * z44);
    const double z48 = z - z40 * k1 + r_R * e3z + c * z43 + z45 + r_F * (z46 * z47) + z47 * (z44 * z45);
    /* 123:10 */
    out[0] = -r_R * (z39 / z28); /* speed */
    /* 124:16 */
    out[1] = z + r_R * (z10 / sqrt(z40 * z40 + e3z * e3z)); /* rear_height */
    /* 125:17 */
    out[2] = z48; /* front_height */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX
        && fabs(z28) > 1e-12 * (k10 * ((z29 + k12) * (z29 + k13))))) {
        /* the coframe is singular */
        if (!(fabs(z28) > 1e-12 * (k10 * ((z29 + k12) * (z29 + k13))))) {
            return BICYCLE_SINGULAR_1;
        }
        return bicycle_finish(3, out);
    }
    return BICYCLE_OK;
}

#if BICYCLE_LANES >= 4
static __attribute__((noinline)) void bicycle_rhs_lanes(const double *fixed, size_t stride, const double *t,
    const double *y, double *restrict dydt, double *check)
{
    (void)t;
    bicycle_lanes far = {0}; /* the squares of the angles */
    bicycle_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    bicycle_bits bad = {0}; /* singular blocks */
    const double lam = fixed[0];
    const double r_R = fixed[1];
    const double R_yy = fixed[2];
    const double r_F = fixed[3];
    const double F_yy = fixed[4];
    const double k4 = fixed[5];
    const double k10 = fixed[6];
    const double k16 = fixed[7];
    const double k17 = fixed[8];
    const double k22 = fixed[9];
    const double k24 = fixed[10];
    const double k25 = fixed[11];
    const double k26 = fixed[12];
    const double k27 = fixed[13];
    const double k28 = fixed[14];
    const double k34 = fixed[15];
    const double k35 = fixed[16];
    const double k37 = fixed[17];
    const double k40 = fixed[18];
    const double k41 = fixed[19];
    const double k43 = fixed[20];
    const double k45 = fixed[21];
    const double k48 = fixed[22];
    const double k55 = fixed[23];
    const double k56 = fixed[24];
    const double k59 = fixed[25];
    const double k62 = fixed[26];
    const double k63 = fixed[27];
    const double k67 = fixed[28];
    const double k68 = fixed[29];
    const double k69 = fixed[30];
    const double k70 = fixed[31];
    const double k71 = fixed[32];
    const double k72 = fixed[33];
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
    const bicycle_lanes z1 = pitch + lam;
    bicycle_lanes sine2, cosine2;
    bicycle_turn_lanes(BICYCLE_SPREAD(z1), &far, &sine2, &cosine2);
    const bicycle_lanes s1 = sine2;
    bicycle_lanes sine3, cosine3;
    bicycle_turn_lanes(BICYCLE_SPREAD(steer), &far, &sine3, &cosine3);
    const bicycle_lanes s_steer = sine3;
    const bicycle_lanes c1 = cosine2;
    const bicycle_lanes z2 = c_roll * c1;
    const bicycle_lanes e2z = sine1;
    const bicycle_lanes c_steer = cosine3;
    const bicycle_lanes z3 = c_roll * s1;
    const bicycle_lanes z4 = e2z * s_steer - c_steer * z3;
    const bicycle_lanes z5 = 1.0 / bicycle_each_sqrt(BICYCLE_SPREAD(z2 * z2 + z4 * z4));
    const bicycle_lanes z6 = r_F * z4;
    const bicycle_lanes z7 = z5 * z6;
    const bicycle_lanes z8 = k4 + z7;
    const bicycle_lanes z9 = s_steer * z8;
    const bicycle_lanes z10 = s1 * z9;
    const bicycle_lanes z11 = 1.0 / bicycle_size(BICYCLE_SPREAD(c_roll));
    const bicycle_lanes z12 = r_R * z3;
    const bicycle_lanes z13 = z11 * z12;
    const bicycle_lanes z14 = k10 + z13 + c_steer * z8;
    const bicycle_lanes z15 = c_roll * z10 + e2z * z14;
    const bicycle_lanes z16 = r_R * z2;
    const bicycle_lanes z17 = z11 * z16;
    const bicycle_lanes z18 = c_steer * z17;
    const bicycle_lanes z19 = r_F * z2;
    const bicycle_lanes z20 = z5 * z19;
    const bicycle_lanes z21 = k16 + z20;
    const bicycle_lanes z22 = z17 - z21;
    const bicycle_lanes z23 = s_steer * z22;
    const bicycle_lanes z24 = c_steer * z22;
    const bicycle_lanes z25 = s_steer * z17;
    const bicycle_lanes z26 = z18 * z23 - z24 * z25;
    const bicycle_lanes z27 = c_steer * z21;
    const bicycle_lanes z28 = c_steer * k10 + z8;
    const bicycle_lanes z29 = s1 * z27 + c1 * z28;
    const bicycle_lanes z30 = c_roll * z29 + e2z * z23;
    const bicycle_lanes z31 = s_steer * z21;
    const bicycle_lanes z32 = s_steer * k10;
    const bicycle_lanes z33 = s1 * z31 + c1 * z32;
    const bicycle_lanes z34 = c_roll * z33 - e2z * z24;
    const bicycle_lanes z35 = z18 * z30 + z34 * z25;
    const bicycle_lanes z36 = z24 * z30 + z34 * z23;
    const bicycle_lanes z37 = z15 * z26 - z14 * z35 + z13 * z36;
    const bicycle_lanes z38 = k17 * (9.0 + bicycle_size(BICYCLE_SPREAD(z11)));
    /* the coframe is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z37)), 1e-12 * (k22 * ((z38 + k24) * (z38 + k25))));
    const bicycle_lanes z39 = r_R * c_roll;
    const bicycle_lanes z40 = z39 * z11;
    const bicycle_lanes z41 = 1.0 / z37;
    const bicycle_lanes z42 = s_steer * c1;
    const bicycle_lanes z43 = z8 * z42;
    const bicycle_lanes z44 = k10 * s1 + z40;
    const bicycle_lanes z45 = s_steer * z44 - z21 * z42;
    const bicycle_lanes z46 = s1 * z8 + (c_steer * z44 - c1 * z27);
    const bicycle_lanes z47 = z25 * z45 + z18 * z46;
    const bicycle_lanes z48 = z23 * z45 + z24 * z46;
    const bicycle_lanes z49 = z41 * (z26 * z43 + z14 * z47 - z13 * z48);
    const bicycle_lanes z50 = c_roll * z49;
    const bicycle_lanes z51 = s1 + c1 * z50;
    const bicycle_lanes z52 = c1 - s1 * z50;
    const bicycle_lanes z53 = z30 * z45 - z34 * z46;
    const bicycle_lanes z54 = z41 * (z35 * z43 + z15 * z47 - z13 * z53) - e2z * z49;
    const bicycle_lanes z55 = c_steer * z54 + s_steer * z52;
    const bicycle_lanes z56 = z41 * (z36 * z43 + (z15 * z48 - z14 * z53)) - z54;
    const bicycle_lanes z57 = z17 * z56;
    const bicycle_lanes z58 = z40 + k10 * z51;
    const bicycle_lanes z59 = c_steer * z57 - s_steer * z58;
    const bicycle_lanes z60 = z13 * z56;
    const bicycle_lanes z61 = z60 - k10 * z54;
    const bicycle_lanes z62 = k59 * z55 + (k45 * z59 - k48 * z61);
    const bicycle_lanes z63 = z62 + F_yy * z55;
    const bicycle_lanes z64 = k41 * z51 + (z40 * k28 - k40 * z52);
    const bicycle_lanes z65 = c_steer * z58 + s_steer * z57;
    const bicycle_lanes z66 = s_steer * z54 - c_steer * z52;
    const bicycle_lanes z67 = k63 * z51 + (k48 * z65 + k62 * z66);
    const bicycle_lanes z68 = z64 + z67;
    const bicycle_lanes z69 = k56 * z51 + (k45 * z65 + k55 * z66);
    const bicycle_lanes z70 = k43 * z61 - k48 * z55;
    const bicycle_lanes z71 = k48 * z51 + (k43 * z65 + k45 * z66);
    const bicycle_lanes z72 = k43 * z59 + k45 * z55;
    const bicycle_lanes z73 = k37 * z54 + (k27 * z57 - k28 * z60);
    const bicycle_lanes z74 = k26 * z60 - k28 * z54;
    const bicycle_lanes z75 = k26 * z57 + k27 * z54;
    const bicycle_lanes z76 = k35 * z51 + (z40 * k27 - k34 * z52);
    const bicycle_lanes z77 = z59 * z72 + (z54 * z73 + (z60 * z74 + (z57 * z75 - (z52 * z76 - R_yy * (z56 *
        z56)))));
    const bicycle_lanes z78 = z40 * (k28 * z51 + (z40 * k26 - k27 * z52)) + (z55 * z63 + (z51 * z68 + (z66 *
        z69 + (z61 * z70 + (z65 * z71 + z77)))));
    const bicycle_lanes z79 = z18 * z8;
    const bicycle_lanes z80 = z34 * z8;
    const bicycle_lanes z81 = z24 * z8;
    const bicycle_lanes z82 = z41 * (z14 * z79 - z13 * z81);
    const bicycle_lanes z83 = z41 * (z15 * z79 + z13 * z80) - e2z * z82;
    const bicycle_lanes z84 = c_roll * z82;
    const bicycle_lanes z85 = s1 * z84;
    const bicycle_lanes z86 = c_steer * z83 - s_steer * z85;
    const bicycle_lanes z87 = z41 * (z15 * z81 + z14 * z80) - z83;
    const bicycle_lanes z88 = z17 * z87;
    const bicycle_lanes z89 = c1 * z84;
    const bicycle_lanes z90 = k10 * z89;
    const bicycle_lanes z91 = c_steer * z88 - s_steer * z90;
    const bicycle_lanes z92 = z13 * z87;
    const bicycle_lanes z93 = z92 - k10 * z83;
    const bicycle_lanes z94 = k59 * z86 + (k45 * z91 - k48 * z93);
    const bicycle_lanes z95 = 1.0 + z89;
    const bicycle_lanes z96 = c_steer * z90 + s_steer * z88;
    const bicycle_lanes z97 = s_steer * z83 + c_steer * z85;
    const bicycle_lanes z98 = k63 * z95 + (k48 * z96 + k62 * z97);
    const bicycle_lanes z99 = k56 * z95 + (k45 * z96 + k55 * z97);
    const bicycle_lanes z100 = k43 * z93 - k48 * z86;
    const bicycle_lanes z101 = k48 * z95 + (k43 * z96 + k45 * z97);
    const bicycle_lanes z102 = k43 * z91 + k45 * z86;
    const bicycle_lanes z103 = k40 * z85 + k41 * z89;
    const bicycle_lanes z104 = z83 * k37 + (z88 * k27 - z92 * k28);
    const bicycle_lanes z105 = k34 * z85 + k35 * z89;
    const bicycle_lanes z106 = z88 * k26 + z83 * k27;
    const bicycle_lanes z107 = z92 * k26 - z83 * k28;
    const bicycle_lanes z108 = z89 * z103 + (z83 * z104 + (z85 * z105 + (z88 * z106 + (z92 * z107 + R_yy *
        (z87 * z87)))));
    const bicycle_lanes z109 = z86 * (z94 + F_yy * z86) + (z95 * z98 + (z97 * z99 + (z93 * z100 + (z96 * z101
        + (z91 * z102 + z108)))));
    const bicycle_lanes z110 = z89 * z64 + (z83 * z73 + (z85 * z76 + (z88 * z75 + (z92 * z74 + R_yy * (z87 *
        z56)))));
    const bicycle_lanes z111 = z86 * z63 + (z95 * z67 + (z97 * z69 + (z93 * z70 + (z96 * z71 + (z91 * z72 +
        z110)))));
    const bicycle_lanes z112 = 1.0 / z78;
    const bicycle_lanes z113 = z111 * z112;
    const bicycle_lanes z114 = z109 - z111 * z113;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z114)), 1e-14 * z109);
    const bicycle_lanes z115 = z20 * z25;
    const bicycle_lanes z116 = z20 * z23;
    const bicycle_lanes z117 = z41 * (z7 * z26 - z14 * z115 + z13 * z116);
    const bicycle_lanes z118 = c_roll * z117;
    const bicycle_lanes z119 = c1 * z118;
    const bicycle_lanes z120 = k10 * z119;
    const bicycle_lanes z121 = z20 * z30;
    const bicycle_lanes z122 = z41 * (z15 * z115 - z7 * z35 - z13 * z121) + e2z * z117;
    const bicycle_lanes z123 = z41 * (z15 * z116 - z14 * z121 - z7 * z36) - z122;
    const bicycle_lanes z124 = z17 * z123;
    const bicycle_lanes z125 = c_steer * z120 - s_steer * z124;
    const bicycle_lanes z126 = s1 * z118;
    const bicycle_lanes z127 = s_steer * z122 - c_steer * z126;
    const bicycle_lanes z128 = c_steer * z122 + s_steer * z126;
    const bicycle_lanes z129 = c_steer * z124 + s_steer * z120;
    const bicycle_lanes z130 = z13 * z123;
    const bicycle_lanes z131 = z130 - k10 * z122;
    const bicycle_lanes z132 = z126 * (k34 * z126 + k35 * z119) + (z124 * (z124 * k26 + z122 * k27) + z130 *
        (z130 * k26 - z122 * k28));
    const bicycle_lanes z133 = z119 * (k40 * z126 + k41 * z119) + (z122 * (z122 * k37 + (z124 * k27 - z130 *
        k28)) + z132);
    const bicycle_lanes z134 = z125 * (k48 * z119 + (k43 * z125 - k45 * z127)) + (z129 * (k43 * z129 + k45 *
        z128) + z133);
    const bicycle_lanes z135 = z127 * (k56 * z119 + (k45 * z125 - k55 * z127)) - (z131 * (k43 * z131 - k48 *
        z128) + z134);
    const bicycle_lanes z136 = z119 * (k63 * z119 + (k48 * z125 - k62 * z127)) + (z128 * (k59 * z128 + (k45 *
        z129 - k48 * z131)) - z135);
    const bicycle_lanes z137 = 1.0 - z128;
    const bicycle_lanes z138 = z136 + R_yy * (z123 * z123) + F_yy * (z137 * z137);
    const bicycle_lanes z139 = R_yy * z123;
    const bicycle_lanes z140 = F_yy * z137;
    const bicycle_lanes z141 = z122 * z73 - (z126 * z76 - (z124 * z75 + (z130 * z74 + (z139 * z56 - z140 *
        z55))));
    const bicycle_lanes z142 = z119 * z68 - (z128 * z62 + (z127 * z69 + (z131 * z70 - (z125 * z71 - (z129 *
        z72 + z141)))));
    const bicycle_lanes z143 = z142 * z112;
    const bicycle_lanes z144 = z126 * z105 - (z124 * z106 + (z130 * z107 + (z87 * z139 - z86 * z140 + z111 *
        z143)));
    const bicycle_lanes z145 = z128 * z94 + (z127 * z99 + (z131 * z100 - (z125 * z101 - (z129 * z102 + (z122
        * z104 - z144)))));
    const bicycle_lanes z146 = z119 * (z103 + z98) - z145;
    const bicycle_lanes z147 = 1.0 / z114;
    const bicycle_lanes z148 = z146 * z147;
    const bicycle_lanes z149 = z138 - z142 * z143 - z146 * z148;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z149)), 1e-14 * z138);
    bicycle_lanes sine4, cosine4;
    bicycle_turn_lanes(BICYCLE_SPREAD(yaw), &far, &sine4, &cosine4);
    const bicycle_lanes c_yaw = cosine4;
    const bicycle_lanes z150 = roll_dot * c1;
    const bicycle_lanes z151 = s_steer * z150;
    const bicycle_lanes z152 = thF_dot - z151;
    const bicycle_lanes z153 = k4 * z151 - z7 * z152;
    const bicycle_lanes z154 = roll_dot * r_R;
    const bicycle_lanes z155 = c_roll * z154;
    const bicycle_lanes z156 = z11 * z155;
    const bicycle_lanes z157 = roll_dot * s1;
    const bicycle_lanes z158 = z156 + k10 * z157;
    const bicycle_lanes z159 = z20 * z152 - (k16 * z151 - s_steer * z158);
    const bicycle_lanes z160 = steer_dot + z157;
    const bicycle_lanes z161 = c_steer * z150;
    const bicycle_lanes z162 = z160 * z8 + (c_steer * z158 - z21 * z161);
    const bicycle_lanes z163 = z23 * z159 + z24 * z162;
    const bicycle_lanes z164 = z30 * z159 - z34 * z162;
    const bicycle_lanes z165 = z41 * (z36 * z153 + (z15 * z163 - z14 * z164));
    const bicycle_lanes z166 = z25 * z159 + z18 * z162;
    const bicycle_lanes z167 = z41 * (z35 * z153 + z15 * z166 - z13 * z164);
    const bicycle_lanes z168 = z41 * (z26 * z153 + z14 * z166 - z13 * z163);
    const bicycle_lanes z169 = z167 - e2z * z168;
    const bicycle_lanes z170 = z165 - z169;
    const bicycle_lanes z171 = z13 * z170;
    const bicycle_lanes z172 = z17 * z170;
    const bicycle_lanes z173 = s1 * z171 + c1 * z172;
    const bicycle_lanes s_yaw = sine4;
    const bicycle_lanes z174 = s1 * z172 - c1 * z171;
    const bicycle_lanes z175 = c_roll * z156 - e2z * z174;
    const bicycle_lanes z176 = c1 * z167;
    const bicycle_lanes z177 = roll_dot * z176;
    const bicycle_lanes z178 = c_roll * z168;
    const bicycle_lanes z179 = s1 * z167;
    const bicycle_lanes z180 = roll_dot * e2z;
    const bicycle_lanes z181 = steer_dot * c_steer;
    const bicycle_lanes z182 = z180 * c1 - c_roll * z179;
    const bicycle_lanes z183 = roll_dot * c_roll;
    const bicycle_lanes z184 = steer_dot * s_steer;
    const bicycle_lanes z185 = z180 * s1 + c_roll * z176;
    const bicycle_lanes z186 = s_steer * z183 + e2z * z181 + (z184 * z3 + c_steer * z185);
    const bicycle_lanes z187 = (z2 * z182 - z4 * z186) * (z5 * (z5 * z5));
    const bicycle_lanes z188 = r_F * z5;
    const bicycle_lanes z189 = z6 * z187 + z188 * z186;
    const bicycle_lanes z190 = z180 * z11;
    const bicycle_lanes z191 = z190 / c_roll;
    const bicycle_lanes z192 = r_R * z11;
    const bicycle_lanes z193 = z12 * z191 - z185 * z192;
    const bicycle_lanes z194 = z193 - (z184 * z8 - c_steer * z189);
    const bicycle_lanes z195 = c_roll * (z9 * z176 - s1 * (z181 * z8 + s_steer * z189)) + (z180 * z10 - (z183
        * z14 + e2z * z194));
    const bicycle_lanes z196 = roll_dot * z179;
    const bicycle_lanes z197 = z181 * z150 + s_steer * z196;
    const bicycle_lanes z198 = z168 * z195 + (z8 * z197 - (z165 * z193 + (z152 * z189 - z167 * z194)));
    const bicycle_lanes z199 = z19 * z187 - z188 * z182;
    const bicycle_lanes z200 = s1 * (z184 * z21 - c_steer * z199) + (z27 * z176 - z28 * z179 + c1 * (z184 *
        k10 - z189));
    const bicycle_lanes z201 = z16 * z191 - z182 * z192;
    const bicycle_lanes z202 = z201 - z199;
    const bicycle_lanes z203 = z181 * z22 + s_steer * z202;
    const bicycle_lanes z204 = k10 * z177 - (z155 * z191 - z154 * z190);
    const bicycle_lanes z205 = z21 * (z184 * z150 - c_steer * z196) - (z161 * z199 + (z184 * z158 - (z160 *
        z189 - (c_steer * z204 + z167 * z203))));
    const bicycle_lanes z206 = z168 * (c_roll * z200 + (z180 * z29 - (z183 * z23 + e2z * z203))) - (z165 *
        (z181 * z17 + s_steer * z201) - (z8 * z177 - z205));
    const bicycle_lanes z207 = s1 * (z181 * z21 + s_steer * z199) - (z31 * z176 - (z32 * z179 + k10 * (z181 *
        c1)));
    const bicycle_lanes z208 = z184 * z22 - c_steer * z202;
    const bicycle_lanes z209 = z165 * (z184 * z17 - c_steer * z201) - (z21 * z197 - (z152 * z199 + (z181 *
        z158 - (s_steer * z204 + z167 * z208))));
    const bicycle_lanes z210 = z168 * (c_roll * z207 - (z180 * z33 + (z183 * z24 - e2z * z208))) + z209;
    const bicycle_lanes z211 = z18 * z206 - z25 * z210;
    const bicycle_lanes z212 = z24 * z206 - z23 * z210;
    const bicycle_lanes z213 = z41 * (z26 * z198 - z14 * z211 + z13 * z212);
    const bicycle_lanes z214 = z180 * z168 - c_roll * z213;
    const bicycle_lanes z215 = z177 - (z178 * z179 - c1 * z214);
    const bicycle_lanes z216 = z157 + c1 * z178;
    const bicycle_lanes z217 = z150 - s1 * z178;
    const bicycle_lanes z218 = z172 * z216 - z171 * z217 + roll_dot * (z180 * z192 - z39 * z191);
    const bicycle_lanes z219 = k27 * z169;
    const bicycle_lanes z220 = k28 * z169;
    const bicycle_lanes z221 = z196 + (z178 * z176 + s1 * z214);
    const bicycle_lanes z222 = k28 * z215 + (k26 * z218 + (z216 * z219 + (e2z * k67 + z217 * z220) + k27 *
        z221));
    const bicycle_lanes z223 = z30 * z210 + z34 * z206;
    const bicycle_lanes z224 = z41 * (z15 * z211 - z35 * z198 + z13 * z223) + (z183 * z168 + e2z * z213);
    const bicycle_lanes z225 = z184 * z169 + c_steer * z224 - (z181 * z217 + s_steer * z221);
    const bicycle_lanes z226 = k10 * z169;
    const bicycle_lanes z227 = k10 * z216;
    const bicycle_lanes v2_x = roll_dot * z40;
    const bicycle_lanes z228 = z41 * (z15 * z212 + z14 * z223 - z36 * z198) - z224;
    const bicycle_lanes z229 = z169 * z171 - v2_x * z216 - (z170 * z201 - z17 * z228);
    const bicycle_lanes z230 = z169 * z226 + z216 * z227 - z229;
    const bicycle_lanes z231 = z218 + (z226 * z217 + k10 * z215);
    const bicycle_lanes z232 = c_steer * z230 + s_steer * z231;
    const bicycle_lanes w3_steer = steer_dot + z216;
    const bicycle_lanes z233 = s_steer * z169 - c_steer * z217;
    const bicycle_lanes z234 = k55 * z233 + k56 * w3_steer;
    const bicycle_lanes z235 = k62 * z233 + k63 * w3_steer;
    const bicycle_lanes z236 = v2_x * z217 - z169 * z172 - (z170 * z193 - z13 * z228);
    const bicycle_lanes z237 = z236 + (z217 * z227 - k10 * z224);
    const bicycle_lanes z238 = z4 * k71 - (k59 * z225 - (k45 * z232 + (w3_steer * z234 - z233 * z235 + k48 *
        z237)));
    const bicycle_lanes z239 = z2 * k72 + z238;
    const bicycle_lanes z240 = F_yy * z225;
    const bicycle_lanes z241 = z239 - z240;
    const bicycle_lanes z242 = R_yy * z170 - k37 * z169;
    const bicycle_lanes z243 = k34 * z217 - k35 * z216;
    const bicycle_lanes z244 = e2z * k68 - (z217 * z242 + z169 * z243 - (k41 * z215 + (k28 * z218 + k40 *
        z221)));
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z3;
    const bicycle_lanes z245 = c_steer * z169 + s_steer * z217;
    const bicycle_lanes z246 = F_yy * (thF_dot - z245) - k59 * z245;
    const bicycle_lanes z247 = c_steer * z231 - s_steer * z230;
    const bicycle_lanes z248 = z181 * z169 - s_steer * z224 + (z184 * z217 - c_steer * z221);
    const bicycle_lanes z249 = h2z * k72 - (z233 * z246 + z245 * z234 + (k63 * z215 + (k48 * z247 - k62 *
        z248)));
    const bicycle_lanes z250 = z244 - z249;
    const bicycle_lanes z251 = h2z * k71 - (z245 * z235 + w3_steer * z246 - (k56 * z215 + (k45 * z247 - k55 *
        z248)));
    const bicycle_lanes z252 = k45 * z233 + k48 * w3_steer;
    const bicycle_lanes z253 = k45 * z245;
    const bicycle_lanes z254 = z2 * k70 + (z233 * z252 + z245 * z253 - (k43 * z237 - k48 * z225));
    const bicycle_lanes z255 = k48 * z245;
    const bicycle_lanes z256 = h2z * k70 + (w3_steer * z253 - z233 * z255 + (k48 * z215 + (k43 * z247 - k45 *
        z248)));
    const bicycle_lanes z257 = z4 * k70 + (z245 * z255 + w3_steer * z252 + (k43 * z232 - k45 * z225));
    const bicycle_lanes z258 = k40 * z217 - k41 * z216;
    const bicycle_lanes z259 = z3 * k69 + z2 * k68 + (z216 * z243 + z217 * z258 + (k37 * z224 + (k27 * z229 -
        k28 * z236)));
    const bicycle_lanes z260 = e2z * k69 + (z169 * z258 - z216 * z242 + (k35 * z215 + (k27 * z218 + k34 *
        z221)));
    const bicycle_lanes z261 = k27 * z217 - k28 * z216;
    const bicycle_lanes z262 = z2 * k67 + (z217 * z261 + z169 * z219 - (k26 * z236 - k28 * z224));
    const bicycle_lanes z263 = z3 * k67 - (z169 * z220 - z216 * z261 - (k26 * z229 + k27 * z224));
    const bicycle_lanes z264 = R_yy * z228;
    const bicycle_lanes z265 = z59 * z257 - (z54 * z259 - (z52 * z260 + (z60 * z262 - (z57 * z263 + z56 *
        z264))));
    const bicycle_lanes z266 = z40 * z222 - (z55 * z241 - (z51 * z250 + (z66 * z251 - (z61 * z254 - (z65 *
        z256 - z265)))));
    const bicycle_lanes z267 = z83 * z259 + (z85 * z260 + (z88 * z263 - (z92 * z262 + (z266 * z113 - z87 *
        z264))));
    const bicycle_lanes z268 = z95 * z249 - (z97 * z251 - (z93 * z254 - (z96 * z256 - (z91 * z257 - (z89 *
        z244 + z267)))));
    const bicycle_lanes z269 = z86 * z241 + z268;
    const bicycle_lanes z270 = z124 * z263 - (z130 * z262 - (z266 * z143 - (z148 * z269 - (z123 * z264 - z137
        * z240))));
    const bicycle_lanes z271 = z127 * z251 - (z131 * z254 + (z125 * z256 + (z129 * z257 - (z122 * z259 -
        (z126 * z260 - z270)))));
    const bicycle_lanes z272 = (z119 * z250 + (z128 * z239 - z271)) / z149;
    const bicycle_lanes z273 = z147 * z269 + z148 * z272;
    /* (I.2.15) */
    const bicycle_lanes slope1 = -(c_yaw * z173 + s_yaw * z175);
    sum += slope1;
    bicycle_put(dydt, slope1);
    const bicycle_lanes slope2 = c_yaw * z175 - s_yaw * z173;
    sum += slope2;
    bicycle_put(dydt + 1 * stride, slope2);
    const bicycle_lanes slope3 = e2z * z156 + c_roll * z174;
    sum += slope3;
    bicycle_put(dydt + 2 * stride, slope3);
    const bicycle_lanes slope4 = z168;
    bicycle_put(dydt + 3 * stride, slope4);
    const bicycle_lanes slope5 = roll_dot;
    bicycle_put(dydt + 4 * stride, slope5);
    const bicycle_lanes slope6 = -z167;
    bicycle_put(dydt + 5 * stride, slope6);
    const bicycle_lanes slope7 = steer_dot;
    bicycle_put(dydt + 6 * stride, slope7);
    const bicycle_lanes slope8 = z165;
    bicycle_put(dydt + 7 * stride, slope8);
    const bicycle_lanes slope9 = thF_dot;
    bicycle_put(dydt + 8 * stride, slope9);
    /* (I.2.15) 112:4 */
    const bicycle_lanes slope10 = z266 * z112 + z113 * z273 - z143 * z272;
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = -z273;
    sum += slope11;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = -z272;
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
    const double k3 = c + (w - x_H);
    const double k4 = r_F * s_lam - c * c_lam;
    const double k5 = H_zz + F_xx;
    const double k6 = H_xx + F_xx;
    const double k7 = R_xx + B_xx;
    const double k8 = R_xx + B_zz;
    const double k9 = z_H * s_lam + c_lam * k3;
    const double k10 = c_lam * k2 - r_R * s_lam;
    const double k11 = c_lam * k1 + x_B * s_lam;
    const double k12 = x_B * c_lam - s_lam * k1;
    const double k13 = r_R * c_lam;
    const double k14 = s_lam * k2;
    const double k15 = z_H * c_lam - s_lam * k3 + k13 + k14;
    const double k16 = k14 - (r_F * c_lam + c * s_lam - k13);
    const double k17 = fabs(r_R);
    const double k18 = fabs(r_F);
    const double k19 = fabs(w);
    const double k20 = fabs(c);
    const double k21 = 9.0 * k18;
    const double k22 = 6.0 * k20 + (2.0 * k19 + (5.0 * k17 + k21));
    const double k23 = 6.0 * k19;
    const double k24 = 13.0 * k20 + (14.0 * k18 + k23);
    const double k25 = 10.0 * k20 + (k21 + k23);
    const double k26 = m_R + m_B;
    const double k27 = m_B * k11;
    const double k28 = m_B * k12;
    const double k29 = B_xz * c_lam;
    const double k30 = s_lam * k8 - k29;
    const double k31 = B_xz * s_lam;
    const double k32 = c_lam * k7 - k31;
    const double k33 = k11 * k27;
    const double k34 = s_lam * k30 + c_lam * k32 + k33;
    const double k35 = c_lam * k30 - s_lam * k32 + k12 * k27;
    const double k36 = k12 * k28;
    const double k37 = k33 + (B_yy + k36);
    const double k38 = k31 + c_lam * k8;
    const double k39 = k29 + s_lam * k7;
    const double k40 = s_lam * k38 - c_lam * k39 + k11 * k28;
    const double k41 = k36 + (c_lam * k38 + s_lam * k39);
    const double k42 = m_F * k16;
    const double k43 = m_H + m_F;
    const double k44 = m_H * k15;
    const double k45 = k42 + k44;
    const double k46 = m_F * k4;
    const double k47 = m_H * k9;
    const double k48 = k46 - k47;
    const double k49 = H_xz * c_lam;
    const double k50 = s_lam * k5 - k49;
    const double k51 = H_xz * s_lam;
    const double k52 = c_lam * k6 - k51;
    const double k53 = k16 * k42;
    const double k54 = k15 * k44;
    const double k55 = s_lam * k50 + c_lam * k52 + k53 + k54;
    const double k56 = c_lam * k50 - s_lam * k52 + k4 * k42 - k9 * k44;
    const double k57 = k4 * k46;
    const double k58 = k9 * k47;
    const double k59 = k54 + (k53 + (H_yy + k57) + k58);
    const double k60 = k51 + c_lam * k5;
    const double k61 = k49 + s_lam * k6;
    const double k62 = s_lam * k60 - c_lam * k61 + k16 * k46 - k15 * k47;
    const double k63 = k58 + (k57 + (c_lam * k60 + s_lam * k61));
    const double k64 = g * m_F;
    const double k65 = g * m_H;
    const double k66 = g * m_B;
    const double k67 = g * k26;
    const double k68 = k12 * k66;
    const double k69 = k11 * k66;
    const double k70 = g * k43;
    const double k71 = k15 * k65 + k16 * k64;
    const double k72 = k9 * k65 - k4 * k64;
    const double fixed[] = {lam, r_R, R_yy, r_F, F_yy, k4, k10, k16, k17, k22, k24, k25, k26, k27, k28, k34,
        k35, k37, k40, k41, k43, k45, k48, k55, k56, k59, k62, k63, k67, k68, k69, k70, k71, k72};
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
