/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:b27bf043548e5f5a)
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
    const double z5 = z2 * z2 + z4 * z4;
    const double z6 = 1.0 / sqrt(z5);
    const double z7 = r_F * z4;
    const double z8 = z6 * z7;
    const double z9 = k4 + z8;
    const double z10 = s_steer * z9;
    const double z11 = s1 * z10;
    const double z12 = 1.0 / fabs(c_roll);
    const double z13 = r_R * z3;
    const double z14 = z12 * z13;
    const double z15 = k10 + z14 + c_steer * z9;
    const double z16 = c_roll * z11 + e2z * z15;
    const double z17 = r_R * z2;
    const double z18 = z12 * z17;
    const double z19 = c_steer * z18;
    const double z20 = r_F * z2;
    const double z21 = z6 * z20;
    const double z22 = k16 + z21;
    const double z23 = z18 - z22;
    const double z24 = s_steer * z23;
    const double z25 = c_steer * z23;
    const double z26 = s_steer * z18;
    const double z27 = z19 * z24 - z25 * z26;
    const double z28 = c_steer * z22;
    const double z29 = c_steer * k10 + z9;
    const double z30 = s1 * z28 + c1 * z29;
    const double z31 = c_roll * z30 + e2z * z24;
    const double z32 = s_steer * z22;
    const double z33 = s_steer * k10;
    const double z34 = s1 * z32 + c1 * z33;
    const double z35 = c_roll * z34 - e2z * z25;
    const double z36 = z19 * z31 + z35 * z26;
    const double z37 = z25 * z31 + z35 * z24;
    const double z38 = z16 * z27 - z15 * z36 + z14 * z37;
    const double z39 = k17 * (9.0 + fabs(z12));
    const double z40 = r_R * c_roll;
    const double z41 = z40 * z12;
    const double z42 = 1.0 / z38;
    const double z43 = s_steer * c1;
    const double z44 = z9 * z43;
    const double z45 = k10 * s1 + z41;
    const double z46 = s_steer * z45 - z22 * z43;
    const double z47 = s1 * z9 + (c_steer * z45 - c1 * z28);
    const double z48 = z26 * z46 + z19 * z47;
    const double z49 = z24 * z46 + z25 * z47;
    const double z50 = z42 * (z27 * z44 + z15 * z48 - z14 * z49);
    const double z51 = c_roll * z50;
    const double z52 = s1 + c1 * z51;
    const double z53 = c1 - s1 * z51;
    const double z54 = z31 * z46 - z35 * z47;
    const double z55 = z42 * (z36 * z44 + z16 * z48 - z14 * z54) - e2z * z50;
    const double z56 = c_steer * z55 + s_steer * z53;
    const double z57 = z42 * (z37 * z44 + (z16 * z49 - z15 * z54)) - z55;
    const double z58 = z18 * z57;
    const double z59 = z41 + k10 * z52;
    const double z60 = c_steer * z58 - s_steer * z59;
    const double z61 = z14 * z57;
    const double z62 = z61 - k10 * z55;
    const double z63 = k59 * z56 + (k45 * z60 - k48 * z62);
    const double z64 = z63 + F_yy * z56;
    const double z65 = k41 * z52 + (z41 * k28 - k40 * z53);
    const double z66 = c_steer * z59 + s_steer * z58;
    const double z67 = s_steer * z55 - c_steer * z53;
    const double z68 = k63 * z52 + (k48 * z66 + k62 * z67);
    const double z69 = z65 + z68;
    const double z70 = k56 * z52 + (k45 * z66 + k55 * z67);
    const double z71 = k43 * z62 - k48 * z56;
    const double z72 = k48 * z52 + (k43 * z66 + k45 * z67);
    const double z73 = k43 * z60 + k45 * z56;
    const double z74 = k37 * z55 + (k27 * z58 - k28 * z61);
    const double z75 = k26 * z61 - k28 * z55;
    const double z76 = k26 * z58 + k27 * z55;
    const double z77 = k35 * z52 + (z41 * k27 - k34 * z53);
    const double z78 = z60 * z73 + (z55 * z74 + (z61 * z75 + (z58 * z76 - (z53 * z77 - R_yy * (z57 * z57)))));
    const double z79 = z41 * (k28 * z52 + (z41 * k26 - k27 * z53)) + (z56 * z64 + (z52 * z69 + (z67 * z70 +
        (z62 * z71 + (z66 * z72 + z78)))));
    const double z80 = z19 * z9;
    const double z81 = z35 * z9;
    const double z82 = z25 * z9;
    const double z83 = z42 * (z15 * z80 - z14 * z82);
    const double z84 = z42 * (z16 * z80 + z14 * z81) - e2z * z83;
    const double z85 = c_roll * z83;
    const double z86 = s1 * z85;
    const double z87 = c_steer * z84 - s_steer * z86;
    const double z88 = z42 * (z16 * z82 + z15 * z81) - z84;
    const double z89 = z18 * z88;
    const double z90 = c1 * z85;
    const double z91 = k10 * z90;
    const double z92 = c_steer * z89 - s_steer * z91;
    const double z93 = z14 * z88;
    const double z94 = z93 - k10 * z84;
    const double z95 = k59 * z87 + (k45 * z92 - k48 * z94);
    const double z96 = 1.0 + z90;
    const double z97 = c_steer * z91 + s_steer * z89;
    const double z98 = s_steer * z84 + c_steer * z86;
    const double z99 = k63 * z96 + (k48 * z97 + k62 * z98);
    const double z100 = k56 * z96 + (k45 * z97 + k55 * z98);
    const double z101 = k43 * z94 - k48 * z87;
    const double z102 = k48 * z96 + (k43 * z97 + k45 * z98);
    const double z103 = k43 * z92 + k45 * z87;
    const double z104 = k40 * z86 + k41 * z90;
    const double z105 = z84 * k37 + (z89 * k27 - z93 * k28);
    const double z106 = k34 * z86 + k35 * z90;
    const double z107 = z89 * k26 + z84 * k27;
    const double z108 = z93 * k26 - z84 * k28;
    const double z109 = z90 * z104 + (z84 * z105 + (z86 * z106 + (z89 * z107 + (z93 * z108 + R_yy * (z88 *
        z88)))));
    const double z110 = z87 * (z95 + F_yy * z87) + (z96 * z99 + (z98 * z100 + (z94 * z101 + (z97 * z102 +
        (z92 * z103 + z109)))));
    const double z111 = z90 * z65 + (z84 * z74 + (z86 * z77 + (z89 * z76 + (z93 * z75 + R_yy * (z88 *
        z57)))));
    const double z112 = z87 * z64 + (z96 * z68 + (z98 * z70 + (z94 * z71 + (z97 * z72 + (z92 * z73 +
        z111)))));
    const double z113 = 1.0 / z79;
    const double z114 = z112 * z113;
    const double z115 = z110 - z112 * z114;
    const double z116 = z21 * z26;
    const double z117 = z21 * z24;
    const double z118 = z42 * (z8 * z27 - z15 * z116 + z14 * z117);
    const double z119 = c_roll * z118;
    const double z120 = c1 * z119;
    const double z121 = k10 * z120;
    const double z122 = z21 * z31;
    const double z123 = z42 * (z16 * z116 - z8 * z36 - z14 * z122) + e2z * z118;
    const double z124 = z42 * (z16 * z117 - z15 * z122 - z8 * z37) - z123;
    const double z125 = z18 * z124;
    const double z126 = c_steer * z121 - s_steer * z125;
    const double z127 = s1 * z119;
    const double z128 = s_steer * z123 - c_steer * z127;
    const double z129 = c_steer * z123 + s_steer * z127;
    const double z130 = c_steer * z125 + s_steer * z121;
    const double z131 = z14 * z124;
    const double z132 = z131 - k10 * z123;
    const double z133 = z127 * (k34 * z127 + k35 * z120) + (z125 * (z125 * k26 + z123 * k27) + z131 * (z131 *
        k26 - z123 * k28));
    const double z134 = z120 * (k40 * z127 + k41 * z120) + (z123 * (z123 * k37 + (z125 * k27 - z131 * k28)) +
        z133);
    const double z135 = z126 * (k48 * z120 + (k43 * z126 - k45 * z128)) + (z130 * (k43 * z130 + k45 * z129) +
        z134);
    const double z136 = z128 * (k56 * z120 + (k45 * z126 - k55 * z128)) - (z132 * (k43 * z132 - k48 * z129) +
        z135);
    const double z137 = z120 * (k63 * z120 + (k48 * z126 - k62 * z128)) + (z129 * (k59 * z129 + (k45 * z130 -
        k48 * z132)) - z136);
    const double z138 = 1.0 - z129;
    const double z139 = z137 + R_yy * (z124 * z124) + F_yy * (z138 * z138);
    const double z140 = R_yy * z124;
    const double z141 = F_yy * z138;
    const double z142 = z123 * z74 - (z127 * z77 - (z125 * z76 + (z131 * z75 + (z140 * z57 - z141 * z56))));
    const double z143 = z120 * z69 - (z129 * z63 + (z128 * z70 + (z132 * z71 - (z126 * z72 - (z130 * z73 +
        z142)))));
    const double z144 = z143 * z113;
    const double z145 = z127 * z106 - (z125 * z107 + (z131 * z108 + (z88 * z140 - z87 * z141 + z112 * z144)));
    const double z146 = z129 * z95 + (z128 * z100 + (z132 * z101 - (z126 * z102 - (z130 * z103 + (z123 * z105
        - z145)))));
    const double z147 = z120 * (z104 + z99) - z146;
    const double z148 = 1.0 / z115;
    const double z149 = z147 * z148;
    const double z150 = z139 - z143 * z144 - z147 * z149;
    const double z151 = roll_dot * c1;
    const double z152 = s_steer * z151;
    const double z153 = thF_dot - z152;
    const double z154 = k4 * z152 - z8 * z153;
    const double z155 = roll_dot * r_R;
    const double z156 = c_roll * z155;
    const double z157 = z12 * z156;
    const double z158 = roll_dot * s1;
    const double z159 = z157 + k10 * z158;
    const double z160 = z21 * z153 - (k16 * z152 - s_steer * z159);
    const double z161 = steer_dot + z158;
    const double z162 = c_steer * z151;
    const double z163 = z161 * z9 + (c_steer * z159 - z22 * z162);
    const double z164 = z24 * z160 + z25 * z163;
    const double z165 = z31 * z160 - z35 * z163;
    const double z166 = z42 * (z37 * z154 + (z16 * z164 - z15 * z165));
    const double z167 = z26 * z160 + z19 * z163;
    const double z168 = z42 * (z36 * z154 + z16 * z167 - z14 * z165);
    const double z169 = z42 * (z27 * z154 + z15 * z167 - z14 * z164);
    const double z170 = z168 - e2z * z169;
    const double z171 = z166 - z170;
    const double z172 = z14 * z171;
    const double z173 = z18 * z171;
    const double z174 = s1 * z172 + c1 * z173;
    const double z175 = s1 * z173 - c1 * z172;
    const double z176 = c_roll * z157 - e2z * z175;
    const double z177 = c1 * z168;
    const double z178 = roll_dot * z177;
    const double z179 = c_roll * z169;
    const double z180 = s1 * z168;
    const double z181 = roll_dot * e2z;
    const double z182 = steer_dot * c_steer;
    const double z183 = z181 * c1 - c_roll * z180;
    const double z184 = roll_dot * c_roll;
    const double z185 = steer_dot * s_steer;
    const double z186 = z181 * s1 + c_roll * z177;
    const double z187 = s_steer * z184 + e2z * z182 + (z185 * z3 + c_steer * z186);
    const double z188 = (z2 * z183 - z4 * z187) * (z6 * (z6 * z6));
    const double z189 = r_F * z6;
    const double z190 = z7 * z188 + z189 * z187;
    const double z191 = z181 * z12;
    const double z192 = z191 / c_roll;
    const double z193 = r_R * z12;
    const double z194 = z13 * z192 - z186 * z193;
    const double z195 = z194 - (z185 * z9 - c_steer * z190);
    const double z196 = c_roll * (z10 * z177 - s1 * (z182 * z9 + s_steer * z190)) + (z181 * z11 - (z184 * z15
        + e2z * z195));
    const double z197 = roll_dot * z180;
    const double z198 = z182 * z151 + s_steer * z197;
    const double z199 = z169 * z196 + (z9 * z198 - (z166 * z194 + (z153 * z190 - z168 * z195)));
    const double z200 = z20 * z188 - z189 * z183;
    const double z201 = s1 * (z185 * z22 - c_steer * z200) + (z28 * z177 - z29 * z180 + c1 * (z185 * k10 -
        z190));
    const double z202 = z17 * z192 - z183 * z193;
    const double z203 = z202 - z200;
    const double z204 = z182 * z23 + s_steer * z203;
    const double z205 = k10 * z178 - (z156 * z192 - z155 * z191);
    const double z206 = z22 * (z185 * z151 - c_steer * z197) - (z162 * z200 + (z185 * z159 - (z161 * z190 -
        (c_steer * z205 + z168 * z204))));
    const double z207 = z169 * (c_roll * z201 + (z181 * z30 - (z184 * z24 + e2z * z204))) - (z166 * (z182 *
        z18 + s_steer * z202) - (z9 * z178 - z206));
    const double z208 = s1 * (z182 * z22 + s_steer * z200) - (z32 * z177 - (z33 * z180 + k10 * (z182 * c1)));
    const double z209 = z185 * z23 - c_steer * z203;
    const double z210 = z166 * (z185 * z18 - c_steer * z202) - (z22 * z198 - (z153 * z200 + (z182 * z159 -
        (s_steer * z205 + z168 * z209))));
    const double z211 = z169 * (c_roll * z208 - (z181 * z34 + (z184 * z25 - e2z * z209))) + z210;
    const double z212 = z19 * z207 - z26 * z211;
    const double z213 = z25 * z207 - z24 * z211;
    const double z214 = z42 * (z27 * z199 - z15 * z212 + z14 * z213);
    const double z215 = z181 * z169 - c_roll * z214;
    const double z216 = z178 - (z179 * z180 - c1 * z215);
    const double z217 = z158 + c1 * z179;
    const double z218 = z151 - s1 * z179;
    const double z219 = z173 * z217 - z172 * z218 + roll_dot * (z181 * z193 - z40 * z192);
    const double z220 = k27 * z170;
    const double z221 = k28 * z170;
    const double z222 = z197 + (z179 * z177 + s1 * z215);
    const double z223 = k28 * z216 + (k26 * z219 + (z217 * z220 + (e2z * k67 + z218 * z221) + k27 * z222));
    const double z224 = z31 * z211 + z35 * z207;
    const double z225 = z42 * (z16 * z212 - z36 * z199 + z14 * z224) + (z184 * z169 + e2z * z214);
    const double z226 = z185 * z170 + c_steer * z225 - (z182 * z218 + s_steer * z222);
    const double z227 = k10 * z170;
    const double z228 = k10 * z217;
    const double v2_x = roll_dot * z41;
    const double z229 = z42 * (z16 * z213 + z15 * z224 - z37 * z199) - z225;
    const double z230 = z170 * z172 - v2_x * z217 - (z171 * z202 - z18 * z229);
    const double z231 = z170 * z227 + z217 * z228 - z230;
    const double z232 = z219 + (z227 * z218 + k10 * z216);
    const double z233 = c_steer * z231 + s_steer * z232;
    const double w3_steer = steer_dot + z217;
    const double z234 = s_steer * z170 - c_steer * z218;
    const double z235 = k55 * z234 + k56 * w3_steer;
    const double z236 = k62 * z234 + k63 * w3_steer;
    const double z237 = v2_x * z218 - z170 * z173 - (z171 * z194 - z14 * z229);
    const double z238 = z237 + (z218 * z228 - k10 * z225);
    const double z239 = z4 * k71 - (k59 * z226 - (k45 * z233 + (w3_steer * z235 - z234 * z236 + k48 * z238)));
    const double z240 = z2 * k72 + z239;
    const double z241 = F_yy * z226;
    const double z242 = z240 - z241;
    const double z243 = R_yy * z171 - k37 * z170;
    const double z244 = k34 * z218 - k35 * z217;
    const double z245 = e2z * k68 - (z218 * z243 + z170 * z244 - (k41 * z216 + (k28 * z219 + k40 * z222)));
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z246 = c_steer * z170 + s_steer * z218;
    const double z247 = F_yy * (thF_dot - z246) - k59 * z246;
    const double z248 = c_steer * z232 - s_steer * z231;
    const double z249 = z182 * z170 - s_steer * z225 + (z185 * z218 - c_steer * z222);
    const double z250 = h2z * k72 - (z234 * z247 + z246 * z235 + (k63 * z216 + (k48 * z248 - k62 * z249)));
    const double z251 = z245 - z250;
    const double z252 = h2z * k71 - (z246 * z236 + w3_steer * z247 - (k56 * z216 + (k45 * z248 - k55 *
        z249)));
    const double z253 = k45 * z234 + k48 * w3_steer;
    const double z254 = k45 * z246;
    const double z255 = z2 * k70 + (z234 * z253 + z246 * z254 - (k43 * z238 - k48 * z226));
    const double z256 = k48 * z246;
    const double z257 = h2z * k70 + (w3_steer * z254 - z234 * z256 + (k48 * z216 + (k43 * z248 - k45 *
        z249)));
    const double z258 = z4 * k70 + (z246 * z256 + w3_steer * z253 + (k43 * z233 - k45 * z226));
    const double z259 = k40 * z218 - k41 * z217;
    const double z260 = z3 * k69 + z2 * k68 + (z217 * z244 + z218 * z259 + (k37 * z225 + (k27 * z230 - k28 *
        z237)));
    const double z261 = e2z * k69 + (z170 * z259 - z217 * z243 + (k35 * z216 + (k27 * z219 + k34 * z222)));
    const double z262 = k27 * z218 - k28 * z217;
    const double z263 = z2 * k67 + (z218 * z262 + z170 * z220 - (k26 * z237 - k28 * z225));
    const double z264 = z3 * k67 - (z170 * z221 - z217 * z262 - (k26 * z230 + k27 * z225));
    const double z265 = R_yy * z229;
    const double z266 = z60 * z258 - (z55 * z260 - (z53 * z261 + (z61 * z263 - (z58 * z264 + z57 * z265))));
    const double z267 = z41 * z223 - (z56 * z242 - (z52 * z251 + (z67 * z252 - (z62 * z255 - (z66 * z257 -
        z266)))));
    const double z268 = z84 * z260 + (z86 * z261 + (z89 * z264 - (z93 * z263 + (z267 * z114 - z88 * z265))));
    const double z269 = z96 * z250 - (z98 * z252 - (z94 * z255 - (z97 * z257 - (z92 * z258 - (z90 * z245 +
        z268)))));
    const double z270 = z87 * z242 + z269;
    const double z271 = z125 * z264 - (z131 * z263 - (z267 * z144 - (z149 * z270 - (z124 * z265 - z138 *
        z241))));
    const double z272 = z128 * z252 - (z132 * z255 + (z126 * z257 + (z130 * z258 - (z123 * z260 - (z127 *
        z261 - z271)))));
    const double z273 = (z120 * z251 + (z129 * z240 - z272)) / z150;
    const double z274 = z148 * z270 + z149 * z273;
    /* (I.2.15) */
    dydt[0] = -(c_yaw * z174 + s_yaw * z176); /* x' */
    dydt[1] = c_yaw * z176 - s_yaw * z174; /* y' */
    dydt[2] = e2z * z157 + c_roll * z175; /* z' */
    dydt[3] = z169; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = -z168; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = z166; /* thR' */
    dydt[8] = thF_dot; /* thF' */
    /* (I.2.15) 112:4 */
    dydt[9] = z267 * z113 + z114 * z274 - z144 * z273; /* roll'' */
    dydt[10] = -z274; /* steer'' */
    dydt[11] = -z273; /* thF'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[9] + dydt[10] + dydt[11]) <= DBL_MAX
        && fabs(z38) > 1e-12 * (k22 * ((z39 + k24) * (z39 + k25)))
        && fabs(z115) > 1e-14 * z110
        && fabs(z150) > 1e-14 * z139)) {
        /* the coframe is singular */
        if (!(fabs(z38) > 1e-12 * (k22 * ((z39 + k24) * (z39 + k25))))) {
            return BICYCLE_SINGULAR_1;
        }
        /* the mass matrix is singular */
        if (!(fabs(z79) > 0.0)) {
            return BICYCLE_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z115) > 1e-14 * z110)) {
            return BICYCLE_SINGULAR_2;
        }
        /* the mass matrix is singular */
        if (!(fabs(z150) > 1e-14 * z139)) {
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
    const double z8 = z6 * z6 + z7 * z7;
    const double z9 = 1.0 / sqrt(z8);
    const double z10 = r_F * z7;
    const double z11 = z9 * z10;
    const double z12 = k2 + z11;
    const double z13 = s_steer * z12;
    const double z14 = s1 * z13;
    const double z15 = k3 + z5 + c_steer * z12;
    const double z16 = c_roll * z14 + e2z * z15;
    const double z17 = r_R * z6;
    const double z18 = z2 * z17;
    const double z19 = c_steer * z18;
    const double z20 = r_F * z6;
    const double z21 = z9 * z20;
    const double z22 = k4 + z21;
    const double z23 = z18 - z22;
    const double z24 = s_steer * z23;
    const double z25 = c_steer * z23;
    const double z26 = s_steer * z18;
    const double z27 = z19 * z24 - z25 * z26;
    const double z28 = c_steer * z22;
    const double z29 = c_steer * k3 + z12;
    const double z30 = s1 * z28 + c1 * z29;
    const double z31 = c_roll * z30 + e2z * z24;
    const double z32 = s_steer * z22;
    const double z33 = s_steer * k3;
    const double z34 = s1 * z32 + c1 * z33;
    const double z35 = c_roll * z34 - e2z * z25;
    const double z36 = z19 * z31 + z35 * z26;
    const double z37 = z25 * z31 + z35 * z24;
    const double z38 = z16 * z27 - z15 * z36 + z5 * z37;
    const double z39 = 1.0 / z38;
    const double z40 = roll_dot * s1;
    const double z41 = steer_dot + z40;
    const double z42 = roll_dot * c1;
    const double z43 = c_steer * z42;
    const double z44 = roll_dot * r_R;
    const double z45 = c_roll * z44;
    const double z46 = z2 * z45;
    const double z47 = z46 + k3 * z40;
    const double z48 = z11 * z41 - z21 * z43 - (k4 * z43 - k2 * z41 - c_steer * z47);
    const double z49 = s_steer * z42;
    const double z50 = thF_dot - z49;
    const double z51 = z21 * z50 - (k4 * z49 - s_steer * z47);
    const double z52 = z25 * z48 + z24 * z51;
    const double z53 = z31 * z51 - z35 * z48;
    const double z54 = k2 * z49 - z11 * z50;
    const double z55 = z16 * z52 - z15 * z53 + z37 * z54;
    const double z56 = z19 * z48 + z26 * z51;
    const double z57 = z16 * z56 + z36 * z54 - z5 * z53;
    const double z58 = z39 * z57;
    const double z59 = z27 * z54 + z15 * z56 - z5 * z52;
    const double z60 = z39 * z59;
    const double z61 = z39 * z55 - (z58 - e2z * z60);
    const double z62 = z5 * z61;
    const double z63 = z18 * z61;
    const double z64 = s1 * z62 + c1 * z63;
    const double z65 = s_yaw * z60;
    const double z66 = c1 * z58;
    const double z67 = roll_dot * e2z;
    const double z68 = z2 * (c_roll * z67) / (c_roll * c_roll);
    const double z69 = z67 * s1 + c_roll * z66;
    const double z70 = r_R * z2;
    const double z71 = z4 * z68 - z69 * z70;
    const double z72 = steer_dot * c_steer;
    const double z73 = s1 * z58;
    const double z74 = z67 * c1 - c_roll * z73;
    const double z75 = roll_dot * c_roll;
    const double z76 = steer_dot * s_steer;
    const double z77 = s_steer * z75 + e2z * z72 + (z76 * z3 + c_steer * z69);
    const double z78 = (z6 * z74 - z7 * z77) * (z9 * (z9 * z9));
    const double z79 = r_F * z9;
    const double z80 = z10 * z78 + z79 * z77;
    const double z81 = z71 - (z76 * z12 - c_steer * z80);
    const double z82 = z67 * z14 + c_roll * (z13 * z66 - s1 * (z72 * z12 + s_steer * z80)) - (z75 * z15 + e2z
        * z81);
    const double z83 = z17 * z68 - z74 * z70;
    const double z84 = z76 * z18 - c_steer * z83;
    const double z85 = z20 * z78 - z79 * z74;
    const double z86 = z83 - z85;
    const double z87 = z72 * z23 + s_steer * z86;
    const double z88 = z76 * z23 - c_steer * z86;
    const double z89 = z72 * z18 + s_steer * z83;
    const double z90 = z24 * z84 - z19 * z87 - (z26 * z88 - z25 * z89);
    const double z91 = z28 * z66 + s1 * (z76 * z22 - c_steer * z85) - (z29 * z73 - c1 * (z76 * k3 - z80));
    const double z92 = z67 * z30 + c_roll * z91 - (z75 * z24 + e2z * z87);
    const double z93 = z32 * z66 - s1 * (z72 * z22 + s_steer * z85) - (z33 * z73 + k3 * (z72 * c1));
    const double z94 = z67 * z34 + c_roll * z93 + (z75 * z25 - e2z * z88);
    const double z95 = z31 * z84 + z19 * z92 + (z26 * z94 - z35 * z89);
    const double z96 = z31 * z88 + z25 * z92 + (z24 * z94 - z35 * z87);
    const double z97 = z27 * z82 + z16 * z90 + (z36 * z81 - z15 * z95) - (z37 * z71 - z5 * z96);
    const double z98 = z97 / (z38 * z38);
    const double z99 = roll_dot * z66 - s1 * roll_ddot;
    const double z100 = steer_ddot - z99;
    const double z101 = roll_dot * z73 + c1 * roll_ddot;
    const double z102 = z76 * z42 - c_steer * z101;
    const double z103 = z45 * z68 - z2 * (z67 * z44 - r_R * (c_roll * roll_ddot));
    const double z104 = k3 * z99 - z103;
    const double z105 = z11 * z100 + z41 * z80 + (z21 * z102 - z43 * z85) + (k4 * z102 + k2 * z100 - (z76 *
        z47 + c_steer * z104));
    const double z106 = z72 * z42 + s_steer * z101;
    const double z107 = thF_ddot - z106;
    const double z108 = z21 * z107 + z50 * z85 - (k4 * z106 - (z72 * z47 - s_steer * z104));
    const double z109 = z48 * z88 - z25 * z105 - (z51 * z87 + z24 * z108);
    const double z110 = z51 * z92 - z31 * z108 - (z48 * z94 - z35 * z105);
    const double z111 = k2 * z106 - (z11 * z107 + z50 * z80);
    const double z112 = z52 * z82 + z16 * z109 + (z53 * z81 - z15 * z110) + (z54 * z96 - z37 * z111);
    const double z113 = z55 * z98 - z39 * z112;
    const double z114 = z48 * z84 - z19 * z105 - (z51 * z89 + z26 * z108);
    const double z115 = z56 * z82 + z16 * z114 + (z54 * z95 - z36 * z111) + (z53 * z71 - z5 * z110);
    const double z116 = z57 * z98 - z39 * z115;
    const double z117 = z54 * z90 - z27 * z111 - (z56 * z81 - z15 * z114) + (z52 * z71 - z5 * z109);
    const double z118 = z59 * z98 - z39 * z117;
    const double z119 = z113 - (z116 - (z75 * z60 + e2z * z118));
    const double z120 = z61 * z71 + z5 * z119;
    const double z121 = z61 * z83 + z18 * z119;
    const double z122 = z62 * z66 - s1 * z120 - (z63 * z73 + c1 * z121);
    const double z123 = s1 * z63 - c1 * z62;
    const double z124 = c_roll * z46 - e2z * z123;
    const double z125 = c_yaw * z60;
    const double z126 = z63 * z66 - s1 * z121 + (z62 * z73 + c1 * z120);
    const double z127 = z67 * z46 - c_roll * z103 + (z75 * z123 - e2z * z126);
    /* (I.2.15) */
    qddot[0] = z64 * z65 + c_yaw * z122 - (z124 * z125 - s_yaw * z127); /* x'' */
    qddot[1] = -(z64 * z125 - s_yaw * z122 + (z124 * z65 + c_yaw * z127)); /* y'' */
    qddot[2] = z75 * z46 + e2z * z103 - (z67 * z123 + c_roll * z126); /* z'' */
    qddot[3] = z118; /* yaw'' */
    qddot[4] = roll_ddot; /* roll'' */
    qddot[5] = -z116; /* pitch'' */
    qddot[6] = steer_ddot; /* steer'' */
    qddot[7] = z113; /* thR'' */
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
    const double z8 = z3 * z3 + z7 * z7;
    const double z9 = 1.0 / sqrt(z8);
    kept[43] = z9;
    const double z10 = r_F * z7;
    kept[44] = z10;
    const double z11 = z9 * z10;
    kept[45] = z11;
    const double z12 = k4 + z11;
    kept[46] = z12;
    const double z13 = s_steer * z12;
    kept[47] = z13;
    const double z14 = s1 * z13;
    kept[48] = z14;
    const double z15 = r_R * z6;
    kept[49] = z15;
    const double z16 = z2 * z15;
    kept[50] = z16;
    const double z17 = k10 + z16 + c_steer * z12;
    kept[51] = z17;
    const double z18 = c_roll * z14 + e2z * z17;
    kept[52] = z18;
    const double z19 = c_steer * z5;
    kept[53] = z19;
    const double z20 = r_F * z3;
    kept[54] = z20;
    const double z21 = z9 * z20;
    kept[55] = z21;
    const double z22 = k16 + z21;
    kept[56] = z22;
    const double z23 = z5 - z22;
    kept[57] = z23;
    const double z24 = s_steer * z23;
    kept[58] = z24;
    const double z25 = c_steer * z23;
    kept[59] = z25;
    const double z26 = s_steer * z5;
    kept[60] = z26;
    const double z27 = z19 * z24 - z25 * z26;
    kept[61] = z27;
    const double z28 = c_steer * z22;
    kept[62] = z28;
    const double z29 = c_steer * k10 + z12;
    kept[63] = z29;
    const double z30 = s1 * z28 + c1 * z29;
    kept[64] = z30;
    const double z31 = c_roll * z30 + e2z * z24;
    kept[65] = z31;
    const double z32 = s_steer * z22;
    kept[66] = z32;
    const double z33 = s_steer * k10;
    kept[67] = z33;
    const double z34 = s1 * z32 + c1 * z33;
    kept[68] = z34;
    const double z35 = c_roll * z34 - e2z * z25;
    kept[69] = z35;
    const double z36 = z19 * z31 + z35 * z26;
    kept[70] = z36;
    const double z37 = z25 * z31 + z35 * z24;
    kept[71] = z37;
    const double z38 = 1.0 / (z18 * z27 - z17 * z36 + z16 * z37);
    kept[72] = z38;
    const double z39 = z21 * z24;
    const double z40 = z21 * z31;
    const double z41 = z21 * z26;
    const double z42 = z38 * (z11 * z27 - z17 * z41 + z16 * z39);
    kept[73] = z42;
    const double z43 = z38 * (z18 * z41 - z11 * z36 - z16 * z40) + e2z * z42;
    kept[74] = z43;
    const double z44 = z38 * (z18 * z39 - z17 * z40 - z11 * z37) - z43;
    kept[75] = z44;
    const double z45 = z5 * z44;
    kept[76] = z45;
    const double z46 = c_steer * c1;
    const double z47 = r_R * c_roll;
    kept[77] = z47;
    const double z48 = z47 * z2;
    kept[78] = z48;
    const double z49 = k10 * s1 + z48;
    const double z50 = s1 * z11 - z21 * z46 - (k16 * z46 - k4 * s1 - c_steer * z49);
    const double z51 = s_steer * c1;
    const double z52 = z21 * z51 + (k16 * z51 - s_steer * z49);
    const double z53 = z25 * z50 - z24 * z52;
    const double z54 = z31 * z52 + z35 * z50;
    const double z55 = z12 * z51;
    const double z56 = z19 * z50 - z26 * z52;
    const double z57 = z38 * (z27 * z55 + z17 * z56 - z16 * z53);
    kept[79] = z57;
    const double z58 = z38 * (z18 * z56 + z36 * z55 + z16 * z54) - e2z * z57;
    kept[80] = z58;
    const double z59 = z38 * (z18 * z53 + z17 * z54 + z37 * z55) - z58;
    kept[81] = z59;
    const double z60 = z5 * z59;
    kept[82] = z60;
    const double z61 = z25 * z12;
    const double z62 = z35 * z12;
    const double z63 = z19 * z12;
    const double z64 = z38 * (z17 * z63 - z16 * z61);
    kept[83] = z64;
    const double z65 = z38 * (z18 * z63 + z16 * z62) - e2z * z64;
    kept[84] = z65;
    const double z66 = z38 * (z18 * z61 + z17 * z62) - z65;
    kept[85] = z66;
    const double z67 = z5 * z66;
    kept[86] = z67;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */
    const double z68 = z45 * thF_ddot + (z60 * roll_ddot + z67 * steer_ddot);
    kept[87] = z68;
    const double z69 = z43 * thF_ddot + (z58 * roll_ddot + z65 * steer_ddot);
    kept[88] = z69;
    const double roll_dot = y[9];
    const double z70 = roll_dot * s1;
    kept[89] = z70;
    const double steer_dot = y[10];
    const double z71 = steer_dot + z70;
    kept[90] = z71;
    const double z72 = roll_dot * c1;
    kept[91] = z72;
    const double z73 = c_steer * z72;
    kept[92] = z73;
    const double z74 = roll_dot * r_R;
    kept[93] = z74;
    const double z75 = c_roll * z74;
    kept[94] = z75;
    const double z76 = z2 * z75 + k10 * z70;
    kept[95] = z76;
    const double z77 = z11 * z71 - z21 * z73 - (k16 * z73 - k4 * z71 - c_steer * z76);
    kept[96] = z77;
    const double z78 = s_steer * z72;
    const double thF_dot = y[11];
    const double z79 = thF_dot - z78;
    kept[97] = z79;
    const double z80 = z21 * z79 - (k16 * z78 - s_steer * z76);
    kept[98] = z80;
    const double z81 = z19 * z77 + z26 * z80;
    kept[99] = z81;
    const double z82 = k4 * z78 - z11 * z79;
    kept[100] = z82;
    const double z83 = z31 * z80 - z35 * z77;
    kept[101] = z83;
    const double z84 = z38 * (z18 * z81 + z36 * z82 - z16 * z83);
    kept[102] = z84;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_reactions_part2(double t, const double *y, const double *p, const double
    *dydt, double *kept, double *lambda)
{
    (void)t;
    const double z24 = kept[58];
    const double z25 = kept[59];
    const double z77 = kept[96];
    const double z80 = kept[98];
    const double z85 = z25 * z77 + z24 * z80;
    const double z16 = kept[50];
    const double z17 = kept[51];
    const double z27 = kept[61];
    const double z38 = kept[72];
    const double z81 = kept[99];
    const double z82 = kept[100];
    const double z86 = z38 * (z27 * z82 + z17 * z81 - z16 * z85);
    const double e2z = kept[2];
    const double z84 = kept[102];
    const double z87 = z84 - e2z * z86;
    const double k19 = kept[13];
    const double z88 = k19 * z87;
    const double c_roll = kept[3];
    const double z89 = c_roll * z86;
    const double c1 = kept[5];
    const double z70 = kept[89];
    const double z90 = z70 + c1 * z89;
    const double s1 = kept[4];
    const double z72 = kept[91];
    const double z91 = z72 - s1 * z89;
    const double k18 = kept[12];
    const double z92 = k18 * z91 - k19 * z90;
    const double z18 = kept[52];
    const double z37 = kept[71];
    const double z83 = kept[101];
    const double z93 = z38 * (z18 * z85 - z17 * z83 + z37 * z82);
    const double z94 = z93 - z87;
    const double z95 = z16 * z94;
    const double roll_dot = y[9];
    const double z48 = kept[78];
    const double v2_x = roll_dot * z48;
    const double z96 = roll_dot * e2z;
    const double z2 = kept[37];
    const double z97 = z96 * z2;
    const double z98 = z97 / c_roll;
    const double z99 = s1 * z84;
    const double z100 = z96 * c1 - c_roll * z99;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z101 = r_R * z2;
    const double z4 = kept[39];
    const double z102 = z4 * z98 - z100 * z101;
    const double z103 = c1 * z84;
    const double z104 = roll_dot * z103;
    const double z105 = roll_dot * c_roll;
    const double steer_dot = y[10];
    const double c_steer = kept[7];
    const double z106 = steer_dot * c_steer;
    const double s_steer = kept[6];
    const double z107 = steer_dot * s_steer;
    const double z108 = z96 * s1 + c_roll * z103;
    const double z6 = kept[41];
    const double z109 = s_steer * z105 + e2z * z106 + (z107 * z6 + c_steer * z108);
    const double z3 = kept[38];
    const double z7 = kept[42];
    const double z9 = kept[43];
    const double z110 = (z3 * z100 - z7 * z109) * (z9 * (z9 * z9));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z111 = r_F * z9;
    const double z10 = kept[44];
    const double z112 = z10 * z110 + z111 * z109;
    const double z113 = roll_dot * z99;
    const double z114 = z107 * z72 - c_steer * z113;
    const double z20 = kept[54];
    const double z115 = z20 * z110 - z111 * z100;
    const double k10 = kept[9];
    const double z74 = kept[93];
    const double z75 = kept[94];
    const double z116 = k10 * z104 - (z75 * z98 - z74 * z97);
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z11 = kept[45];
    const double z21 = kept[55];
    const double z71 = kept[90];
    const double z73 = kept[92];
    const double z76 = kept[95];
    const double z117 = z11 * z104 - z71 * z112 - (z21 * z114 - z73 * z115) - (k16 * z114 - k4 * z104 - (z107
        * z76 + c_steer * z116));
    const double z22 = kept[56];
    const double z28 = kept[62];
    const double z29 = kept[63];
    const double z118 = z28 * z103 + s1 * (z107 * z22 - c_steer * z115) - (z29 * z99 - c1 * (z107 * k10 -
        z112));
    const double z119 = z115 - z102;
    const double z23 = kept[57];
    const double z120 = z106 * z23 - s_steer * z119;
    const double z5 = kept[40];
    const double z30 = kept[64];
    const double z121 = z93 * (z106 * z5 + s_steer * z102) - (z86 * (z96 * z30 + c_roll * z118 - (z105 * z24
        + e2z * z120)) + z84 * z120);
    const double z122 = z117 - z121;
    const double z123 = z106 * z72 + s_steer * z113;
    const double z32 = kept[66];
    const double z33 = kept[67];
    const double z124 = z32 * z103 - s1 * (z106 * z22 + s_steer * z115) - (z33 * z99 + k10 * (z106 * c1));
    const double z125 = z107 * z23 + c_steer * z119;
    const double z34 = kept[68];
    const double z126 = z93 * (z107 * z5 - c_steer * z102) - (z86 * (z96 * z34 + c_roll * z124 + (z105 * z25
        - e2z * z125)) + z84 * z125);
    const double z79 = kept[97];
    const double z127 = z21 * z123 - z79 * z115 + (k16 * z123 - (z106 * z76 - s_steer * z116)) - z126;
    const double z128 = z25 * z122 + z24 * z127;
    const double z31 = kept[65];
    const double z35 = kept[69];
    const double z129 = z31 * z127 - z35 * z122;
    const double z15 = kept[49];
    const double z130 = z15 * z98 - z108 * z101;
    const double z12 = kept[46];
    const double z131 = z107 * z12 - c_steer * z112 - z130;
    const double z13 = kept[47];
    const double z14 = kept[48];
    const double z132 = z96 * z14 + c_roll * (z13 * z103 - s1 * (z106 * z12 + s_steer * z112)) - (z105 * z17
        - e2z * z131);
    const double z133 = k4 * z123 + (z11 * z123 - z79 * z112) - (z93 * z130 - (z86 * z132 - z84 * z131));
    const double z19 = kept[53];
    const double z26 = kept[60];
    const double z134 = z19 * z122 + z26 * z127;
    const double z135 = z38 * (z27 * z133 - z17 * z134 + z16 * z128);
    const double z36 = kept[70];
    const double z136 = z38 * (z18 * z134 - z36 * z133 - z16 * z129) + (z105 * z86 + e2z * z135);
    const double z137 = z38 * (z18 * z128 - z17 * z129 - z37 * z133) - z136;
    const double z138 = z87 * z95 - v2_x * z90 - (z94 * z102 - z5 * z137);
    const double k17 = kept[11];
    const double k58 = kept[27];
    const double z68 = kept[87];
    const double z69 = kept[88];
    const double z139 = k17 * z68 + k18 * z69 - (z6 * k58 - (z87 * z88 - z90 * z92 - (k17 * z138 + k18 *
        z136)));
    const double z42 = kept[73];
    const double z140 = c_roll * z42;
    const double z141 = c1 * z140;
    const double thF_ddot = dydt[11]; /* thF'' */
    const double z142 = z141 * thF_ddot;
    const double z57 = kept[79];
    const double z143 = c_roll * z57;
    const double z144 = s1 + c1 * z143;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double z145 = z144 * roll_ddot;
    const double z64 = kept[83];
    const double z146 = c_roll * z64;
    const double z147 = c1 * z146;
    const double steer_ddot = dydt[10]; /* steer'' */
    const double z148 = z142 - (z145 + (1.0 + z147) * steer_ddot);
    const double z149 = k10 * z141;
    const double z150 = z48 + k10 * z144;
    const double z151 = k10 * z147;
    const double z45 = kept[76];
    const double z60 = kept[82];
    const double z67 = kept[86];
    const double z152 = (c_steer * z149 - s_steer * z45) * thF_ddot - ((c_steer * z150 + s_steer * z60) *
        roll_ddot + (c_steer * z151 + s_steer * z67) * steer_ddot);
    const double z153 = s1 * z140;
    const double z154 = c1 - s1 * z143;
    const double z155 = s1 * z146;
    const double z43 = kept[74];
    const double z58 = kept[80];
    const double z65 = kept[84];
    const double z156 = (s_steer * z43 - c_steer * z153) * thF_ddot + ((s_steer * z58 - c_steer * z154) *
        roll_ddot + (s_steer * z65 + c_steer * z155) * steer_ddot);
    const double h2z = e2z * c_steer + s_steer * z6;
    const double w3_steer = steer_dot + z90;
    const double z157 = c_steer * z87 + s_steer * z91;
    const double k36 = kept[20];
    const double z158 = k36 * z157;
    const double z159 = s_steer * z87 - c_steer * z91;
    const double k39 = kept[21];
    const double z160 = k39 * z157;
    const double z161 = z96 * z86 - c_roll * z135;
    const double z162 = z104 - (z89 * z99 - c1 * z161);
    const double z163 = z5 * z94;
    const double z47 = kept[77];
    const double z164 = z163 * z90 - z95 * z91 + roll_dot * (z96 * z101 - z47 * z98);
    const double z165 = k10 * z87;
    const double z166 = z164 + (z165 * z91 + k10 * z162);
    const double z167 = k10 * z90;
    const double z168 = z87 * z165 + z90 * z167 - z138;
    const double z169 = c_steer * z166 - s_steer * z168;
    const double z170 = z113 + (z89 * z103 + s1 * z161);
    const double z171 = z106 * z87 - s_steer * z136 + (z107 * z91 - c_steer * z170);
    const double k34 = kept[19];
    const double k63 = kept[32];
    const double z172 = h2z * k63 + (w3_steer * z158 - z159 * z160 + (k39 * z162 + (k34 * z169 - k36 *
        z171)));
    const double z173 = k39 * z148 + (k34 * z152 - k36 * z156) + z172;
    const double z174 = (c_steer * z45 + s_steer * z149) * thF_ddot + ((c_steer * z60 - s_steer * z150) *
        roll_ddot + (c_steer * z67 - s_steer * z151) * steer_ddot);
    const double z175 = c_steer * z43 + s_steer * z153;
    const double z176 = (c_steer * z58 + s_steer * z154) * roll_ddot + (c_steer * z65 - s_steer * z155) *
        steer_ddot;
    const double z177 = z175 * thF_ddot + z176;
    const double z178 = k36 * z159 + k39 * w3_steer;
    const double z179 = c_steer * z168 + s_steer * z166;
    const double z180 = z107 * z87 + c_steer * z136 - (z106 * z91 + s_steer * z170);
    const double z181 = k34 * z174 + k36 * z177 + (z7 * k63 + (z157 * z160 + w3_steer * z178 + (k34 * z179 -
        k36 * z180)));
    const double z182 = z139 - s_steer * z173 + c_steer * z181;
    const double z44 = kept[75];
    const double z183 = z16 * z44;
    const double z59 = kept[81];
    const double z184 = z16 * z59;
    const double z66 = kept[85];
    const double z185 = z16 * z66;
    const double z186 = z183 * thF_ddot + (z184 * roll_ddot + z185 * steer_ddot);
    const double z187 = k18 * z87;
    const double z188 = v2_x * z91 - z87 * z163 - (z94 * z130 - z16 * z137);
    const double z189 = k17 * z186 - k19 * z69 + (z3 * k58 + (z91 * z92 + z87 * z187 - (k17 * z188 - k19 *
        z136)));
    const double z190 = (z183 - k10 * z43) * thF_ddot + ((z184 - k10 * z58) * roll_ddot + (z185 - k10 * z65)
        * steer_ddot);
    const double z191 = z188 + (z91 * z167 - k10 * z136);
    const double z192 = k34 * z190 - k39 * z177 + (z3 * k63 + (z159 * z178 + z157 * z158 - (k34 * z191 - k39
        * z180)));
    const double z193 = z189 + z192;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double z194 = R_yy * (z44 * thF_ddot + (z59 * roll_ddot + z66 * steer_ddot) - z137) + z16 * z193 +
        z5 * z182;
    const double z195 = z38 * z194;
    const double k25 = kept[14];
    const double k26 = kept[15];
    const double z196 = k25 * z91 - k26 * z90;
    const double k31 = kept[17];
    const double k32 = kept[18];
    const double z197 = k31 * z91 - k32 * z90;
    const double k28 = kept[16];
    const double k59 = kept[28];
    const double k60 = kept[29];
    const double z198 = z6 * k60 + z3 * k59 + (z90 * z196 + z91 * z197 + (k28 * z136 + (k18 * z138 - k19 *
        z188)));
    const double k46 = kept[22];
    const double k47 = kept[23];
    const double z199 = k46 * z159 + k47 * w3_steer;
    const double k53 = kept[25];
    const double k54 = kept[26];
    const double z200 = k53 * z159 + k54 * w3_steer;
    const double k50 = kept[24];
    const double k61 = kept[30];
    const double k62 = kept[31];
    const double k64 = kept[33];
    const double k65 = kept[34];
    const double z201 = z7 * k62 + z3 * k61 + (z7 * k65 - z3 * k64) + (w3_steer * z199 - z159 * z200 - (k50 *
        z180 - (k36 * z179 + k39 * z191)));
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z202 = k50 * z177 + (k36 * z174 - k39 * z190) + z201 + F_yy * (z176 - (1.0 - z175) *
        thF_ddot - z180);
    const double thF_dot = y[11];
    const double z203 = F_yy * (thF_dot - z157) - k50 * z157;
    const double k66 = kept[35];
    const double z204 = h2z * k66 - (z157 * z200 + w3_steer * z203 - (k47 * z162 + (k36 * z169 - k46 *
        z171)));
    const double z205 = k47 * z148 + (k36 * z152 - k46 * z156) + z204;
    const double z206 = k28 * z69 + (k18 * z68 - k19 * z186) - z198 - k10 * z192 + c_steer * z202 - s_steer *
        z205;
    const double z207 = z206 - z194;
    const double z208 = z38 * z207;
    const double z209 = z17 * z195 + z16 * z208;
    const double z210 = z142 - (z145 + z147 * steer_ddot);
    const double z211 = z48 * roll_ddot;
    const double z212 = z153 * thF_ddot + (z154 * roll_ddot - z155 * steer_ddot);
    const double z213 = R_yy * z94 - k28 * z87;
    const double z214 = e2z * k60 + (z87 * z197 - z90 * z213 + (k26 * z162 + (k18 * z164 + k25 * z170)));
    const double z215 = s1 * (k26 * z210 - (k18 * z211 - k25 * z212) + z214 + s_steer * z202 + c_steer *
        z205);
    const double k67 = kept[36];
    const double z216 = h2z * k67 - (z159 * z203 + z157 * z199 + (k54 * z162 + (k39 * z169 - k53 * z171)));
    const double z217 = e2z * k59 - (z91 * z213 + z87 * z196 - (k32 * z162 + (k19 * z164 + k31 * z170)));
    const double z218 = c_steer * z173 + s_steer * z181;
    const double z219 = k54 * z148 + (k39 * z152 - k53 * z156) - z216 + (k32 * z210 - (k19 * z211 - k31 *
        z212) + z217 + k10 * z218);
    const double z220 = z38 * (c_roll * (z215 + c1 * z219) + e2z * z207);
    const double z221 = z18 * z195 + z16 * z220;
    const double z222 = z18 * z208 - z17 * z220;
    const double z223 = z31 * z209 - z24 * z221 - z26 * z222;
    const double z224 = c_steer * z223;
    const double z225 = z35 * z209 + z25 * z221 + z19 * z222;
    const double z226 = s_steer * z225;
    const double z227 = z182 + z224 + z226;
    const double z228 = z37 * z195 + z36 * z208 - z27 * z220;
    const double z229 = z193 - z228;
    const double z230 = s1 * z227 - c1 * z229;
    const double z231 = e2z * k58 + (z90 * z187 + z91 * z88 + (k19 * z162 + (k17 * z164 + k18 * z170)));
    const double z232 = s_steer * z223 - c_steer * z225;
    const double z233 = k19 * z210 - (k17 * z211 - k18 * z212) + z231 + z218 + z232;
    const double z234 = e2z * z230 + c_roll * z233;
    const double z235 = c1 * z227 + s1 * z229;
    const double s_yaw = kept[0];
    const double c_yaw = kept[1];
    /* (I.4.1) 115:5 */
    lambda[0] = s_yaw * z234 - c_yaw * z235; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 116:5 */
    lambda[1] = -(c_yaw * z234 + s_yaw * z235); /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 117:5 */
    lambda[2] = c_roll * z230 - e2z * z233; /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z236 = z224 + z226;
    const double z237 = s1 * z236 + c1 * z228;
    const double z238 = e2z * z237 + c_roll * z232;
    const double z239 = c1 * z236 - s1 * z228;
    /* (I.4.1) 118:5 */
    lambda[3] = c_yaw * z239 - s_yaw * z238; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    /* (I.4.1) 119:5 */
    lambda[4] = c_yaw * z238 + s_yaw * z239; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    /* (I.4.1) 120:5 */
    lambda[5] = e2z * z232 - c_roll * z237; /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return BICYCLE_OK;
}

BICYCLE_SLOW
int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[103]; /* what parts of this function leave for others */
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
    const double z5 = z2 * z2 + z4 * z4;
    kept[43] = z5;
    const double z6 = 1.0 / sqrt(z5);
    kept[44] = z6;
    const double z7 = r_F * z4;
    kept[45] = z7;
    const double z8 = z6 * z7;
    kept[46] = z8;
    const double z9 = k4 + z8;
    kept[47] = z9;
    const double z10 = s_steer * z9;
    kept[48] = z10;
    const double z11 = s1 * z10;
    kept[49] = z11;
    const double z12 = 1.0 / fabs(c_roll);
    kept[50] = z12;
    const double z13 = r_R * z3;
    kept[51] = z13;
    const double z14 = z12 * z13;
    kept[52] = z14;
    const double z15 = k10 + z14 + c_steer * z9;
    kept[53] = z15;
    const double z16 = c_roll * z11 + e2z * z15;
    kept[54] = z16;
    const double z17 = r_R * z2;
    kept[55] = z17;
    const double z18 = z12 * z17;
    kept[56] = z18;
    const double z19 = c_steer * z18;
    kept[57] = z19;
    const double z20 = r_F * z2;
    kept[58] = z20;
    const double z21 = z6 * z20;
    kept[59] = z21;
    const double z22 = k16 + z21;
    kept[60] = z22;
    const double z23 = z18 - z22;
    kept[61] = z23;
    const double z24 = s_steer * z23;
    kept[62] = z24;
    const double z25 = c_steer * z23;
    kept[63] = z25;
    const double z26 = s_steer * z18;
    kept[64] = z26;
    const double z27 = z19 * z24 - z25 * z26;
    kept[65] = z27;
    const double z28 = c_steer * z22;
    kept[66] = z28;
    const double z29 = c_steer * k10 + z9;
    kept[67] = z29;
    const double z30 = s1 * z28 + c1 * z29;
    kept[68] = z30;
    const double z31 = c_roll * z30 + e2z * z24;
    kept[69] = z31;
    const double z32 = s_steer * z22;
    kept[70] = z32;
    const double z33 = s_steer * k10;
    kept[71] = z33;
    const double z34 = s1 * z32 + c1 * z33;
    kept[72] = z34;
    const double z35 = c_roll * z34 - e2z * z25;
    kept[73] = z35;
    const double z36 = z19 * z31 + z35 * z26;
    kept[74] = z36;
    const double z37 = z25 * z31 + z35 * z24;
    kept[75] = z37;
    const double z38 = z16 * z27 - z15 * z36 + z14 * z37;
    kept[76] = z38;
    const double z39 = k17 * (9.0 + fabs(z12));
    kept[77] = z39;
    const double z40 = 1.0 / z38;
    kept[78] = z40;
    const double z41 = s_steer * c1;
    kept[79] = z41;
    const double z42 = z9 * z41;
    kept[80] = z42;
    const double z43 = c_steer * c1;
    kept[81] = z43;
    const double z44 = r_R * c_roll;
    kept[82] = z44;
    const double z45 = z44 * z12;
    kept[83] = z45;
    const double z46 = k10 * s1 + z45;
    kept[84] = z46;
    const double z47 = s1 * z8 - z21 * z43 - (k16 * z43 - k4 * s1 - c_steer * z46);
    kept[85] = z47;
    const double z48 = z21 * z41 + (k16 * z41 - s_steer * z46);
    kept[86] = z48;
    const double z49 = z19 * z47 - z26 * z48;
    kept[87] = z49;
    const double z50 = z25 * z47 - z24 * z48;
    kept[88] = z50;
    const double z51 = z27 * z42 + z15 * z49 - z14 * z50;
    kept[89] = z51;
    const double z52 = z40 * z51;
    kept[90] = z52;
    const double z53 = c_roll * z52;
    kept[91] = z53;
    const double z54 = s1 + c1 * z53;
    kept[92] = z54;
    const double z55 = z45 + k10 * z54;
    kept[93] = z55;
    const double z56 = z31 * z48 + z35 * z47;
    kept[94] = z56;
    const double z57 = z16 * z50 + z15 * z56 + z37 * z42;
    kept[95] = z57;
    const double z58 = z40 * z57;
    kept[96] = z58;
    const double z59 = z16 * z49 + z36 * z42 + z14 * z56;
    kept[97] = z59;
    const double z60 = z40 * z59;
    kept[98] = z60;
    const double z61 = z60 - e2z * z52;
    kept[99] = z61;
    const double z62 = z58 - z61;
    kept[100] = z62;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part2(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)t;
    const double z18 = kept[56];
    const double z62 = kept[100];
    const double z63 = z18 * z62;
    kept[101] = z63;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double z55 = kept[93];
    const double z64 = c_steer * z55 + s_steer * z63;
    kept[102] = z64;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const double z53 = kept[91];
    const double z65 = c1 - s1 * z53;
    kept[103] = z65;
    const double z61 = kept[99];
    const double z66 = s_steer * z61 - c_steer * z65;
    kept[104] = z66;
    const double k48 = kept[24];
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z54 = kept[92];
    const double z67 = k63 * z54 + (k48 * z64 + k62 * z66);
    kept[105] = z67;
    const double z68 = c_steer * z61 + s_steer * z65;
    kept[106] = z68;
    const double z69 = c_steer * z63 - s_steer * z55;
    kept[107] = z69;
    const double z14 = kept[52];
    const double z70 = z14 * z62;
    kept[108] = z70;
    const double k10 = kept[9];
    const double z71 = z70 - k10 * z61;
    kept[109] = z71;
    const double k45 = kept[23];
    const double k59 = kept[27];
    const double z72 = k59 * z68 + (k45 * z69 - k48 * z71);
    kept[110] = z72;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z73 = k56 * z54 + (k45 * z64 + k55 * z66);
    kept[111] = z73;
    const double k43 = kept[22];
    const double z74 = k43 * z71 - k48 * z68;
    kept[112] = z74;
    const double z75 = k48 * z54 + (k43 * z64 + k45 * z66);
    kept[113] = z75;
    const double z76 = k43 * z69 + k45 * z68;
    kept[114] = z76;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double z45 = kept[83];
    const double z77 = k41 * z54 + (z45 * k28 - k40 * z65);
    kept[115] = z77;
    const double k27 = kept[15];
    const double k37 = kept[19];
    const double z78 = z61 * k37 + (z63 * k27 - z70 * k28);
    kept[116] = z78;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z79 = k35 * z54 + (z45 * k27 - k34 * z65);
    kept[117] = z79;
    const double k26 = kept[14];
    const double z80 = z70 * k26 - z61 * k28;
    kept[118] = z80;
    const double z81 = z63 * k26 + z61 * k27;
    kept[119] = z81;
    const double z82 = k28 * z54 + (z45 * k26 - k27 * z65);
    kept[120] = z82;
    const double z83 = z54 * z77 + (z61 * z78 - (z65 * z79 - (z70 * z80 + (z63 * z81 + z45 * z82))));
    const double z84 = z54 * z67 + (z68 * z72 + (z66 * z73 + (z71 * z74 + (z64 * z75 + (z69 * z76 + z83)))));
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z85 = z84 + R_yy * (z62 * z62) + F_yy * (z68 * z68);
    kept[121] = z85;
    const double z9 = kept[47];
    const double z19 = kept[57];
    const double z86 = z19 * z9;
    kept[122] = z86;
    const double z25 = kept[63];
    const double z87 = z25 * z9;
    kept[123] = z87;
    const double z15 = kept[53];
    const double z88 = z15 * z86 - z14 * z87;
    kept[124] = z88;
    const double z40 = kept[78];
    const double z89 = z40 * z88;
    kept[125] = z89;
    const double c_roll = kept[0];
    const double z90 = c_roll * z89;
    kept[126] = z90;
    const double z91 = c1 * z90;
    kept[127] = z91;
    const double z92 = 1.0 + z91;
    kept[128] = z92;
    const double z93 = k10 * z91;
    kept[129] = z93;
    const double z35 = kept[73];
    const double z94 = z35 * z9;
    kept[130] = z94;
    const double z16 = kept[54];
    const double z95 = z16 * z87 + z15 * z94;
    kept[131] = z95;
    const double z96 = z40 * z95;
    const double z97 = z16 * z86 + z14 * z94;
    kept[132] = z97;
    const double z98 = z40 * z97;
    const double e2z = kept[1];
    const double z99 = z98 - e2z * z89;
    kept[133] = z99;
    const double z100 = z96 - z99;
    kept[134] = z100;
    const double z101 = z18 * z100;
    kept[135] = z101;
    const double z102 = c_steer * z93 + s_steer * z101;
    kept[136] = z102;
    const double z103 = s1 * z90;
    kept[137] = z103;
    const double z104 = s_steer * z99 + c_steer * z103;
    kept[138] = z104;
    const double z105 = k63 * z92 + (k48 * z102 + k62 * z104);
    kept[139] = z105;
    const double z106 = c_steer * z99 - s_steer * z103;
    kept[140] = z106;
    const double z107 = c_steer * z101 - s_steer * z93;
    kept[141] = z107;
    const double z108 = z14 * z100;
    kept[142] = z108;
    const double z109 = z108 - k10 * z99;
    kept[143] = z109;
    const double z110 = k59 * z106 + (k45 * z107 - k48 * z109);
    kept[144] = z110;
    const double z111 = k56 * z92 + (k45 * z102 + k55 * z104);
    kept[145] = z111;
    const double z112 = k43 * z109 - k48 * z106;
    kept[146] = z112;
    const double z113 = k48 * z92 + (k43 * z102 + k45 * z104);
    kept[147] = z113;
    const double z114 = k43 * z107 + k45 * z106;
    kept[148] = z114;
    const double z115 = k40 * z103 + k41 * z91;
    kept[149] = z115;
    const double z116 = z99 * k37 + (z101 * k27 - z108 * k28);
    kept[150] = z116;
    const double z117 = k34 * z103 + k35 * z91;
    kept[151] = z117;
    const double z118 = z101 * k26 + z99 * k27;
    kept[152] = z118;
    const double z119 = z108 * k26 - z99 * k28;
    kept[153] = z119;
    const double z120 = z107 * z114 + (z91 * z115 + (z99 * z116 + (z103 * z117 + (z101 * z118 + z108 *
        z119))));
    const double z121 = z92 * z105 + (z106 * z110 + (z104 * z111 + (z109 * z112 + (z102 * z113 + z120)))) +
        R_yy * (z100 * z100);
    const double z122 = z121 + F_yy * (z106 * z106);
    kept[154] = z122;
    const double z123 = z107 * z76 + (z91 * z77 + (z99 * z78 + (z103 * z79 + (z101 * z81 + z108 * z80))));
    const double z124 = z92 * z67 + (z106 * z72 + (z104 * z73 + (z109 * z74 + (z102 * z75 + z123)))) + R_yy *
        (z62 * z100);
    const double z125 = z124 + F_yy * (z68 * z106);
    const double z126 = 1.0 / z85;
    kept[155] = z126;
    const double z127 = z125 * z126;
    kept[156] = z127;
    const double z128 = z122 - z125 * z127;
    kept[157] = z128;
    const double z21 = kept[59];
    const double z26 = kept[64];
    const double z129 = z21 * z26;
    kept[158] = z129;
    const double z24 = kept[62];
    const double z130 = z21 * z24;
    kept[159] = z130;
    const double z8 = kept[46];
    const double z27 = kept[65];
    const double z131 = z8 * z27 - z15 * z129 + z14 * z130;
    kept[160] = z131;
    const double z132 = z40 * z131;
    kept[161] = z132;
    const double z133 = c_roll * z132;
    kept[162] = z133;
    const double z134 = c1 * z133;
    kept[163] = z134;
    const double z135 = k10 * z134;
    kept[164] = z135;
    const double z31 = kept[69];
    const double z136 = z21 * z31;
    kept[165] = z136;
    const double z37 = kept[75];
    const double z137 = z16 * z130 - z15 * z136 - z8 * z37;
    kept[166] = z137;
    const double z138 = z40 * z137;
    const double z36 = kept[74];
    const double z139 = z16 * z129 - z8 * z36 - z14 * z136;
    kept[167] = z139;
    const double z140 = z40 * z139;
    const double z141 = z140 + e2z * z132;
    kept[168] = z141;
    const double z142 = z138 - z141;
    kept[169] = z142;
    const double z143 = z18 * z142;
    kept[170] = z143;
    const double z144 = c_steer * z135 - s_steer * z143;
    kept[171] = z144;
    const double z145 = s1 * z133;
    kept[172] = z145;
    const double z146 = s_steer * z141 - c_steer * z145;
    kept[173] = z146;
    const double z147 = k63 * z134 + (k48 * z144 - k62 * z146);
    kept[174] = z147;
    const double z148 = c_steer * z141 + s_steer * z145;
    kept[175] = z148;
    const double z149 = c_steer * z143 + s_steer * z135;
    kept[176] = z149;
    const double z150 = z14 * z142;
    kept[177] = z150;
    const double z151 = z150 - k10 * z141;
    kept[178] = z151;
    const double z152 = k59 * z148 + (k45 * z149 - k48 * z151);
    kept[179] = z152;
    const double z153 = k56 * z134 + (k45 * z144 - k55 * z146);
    kept[180] = z153;
    const double z154 = k43 * z151 - k48 * z148;
    kept[181] = z154;
    const double z155 = k48 * z134 + (k43 * z144 - k45 * z146);
    kept[182] = z155;
    const double z156 = k43 * z149 + k45 * z148;
    kept[183] = z156;
    const double z157 = k40 * z145 + k41 * z134;
    kept[184] = z157;
    const double z158 = z141 * k37 + (z143 * k27 - z150 * k28);
    kept[185] = z158;
    const double z159 = k34 * z145 + k35 * z134;
    kept[186] = z159;
    const double z160 = z143 * k26 + z141 * k27;
    kept[187] = z160;
    const double z161 = z150 * k26 - z141 * k28;
    kept[188] = z161;
    const double z162 = z149 * z156 + (z134 * z157 + (z141 * z158 + (z145 * z159 + (z143 * z160 + z150 *
        z161))));
    const double z163 = z134 * z147 + (z148 * z152 - (z146 * z153 - (z151 * z154 + (z144 * z155 + z162)))) +
        R_yy * (z142 * z142);
    const double z164 = 1.0 - z148;
    kept[189] = z164;
    const double z165 = z163 + F_yy * (z164 * z164);
    kept[190] = z165;
    const double z166 = z149 * z76 - (z134 * z77 - (z141 * z78 - (z145 * z79 - (z143 * z81 + z150 * z80))));
    const double z167 = z134 * z67 - (z148 * z72 + (z146 * z73 + (z151 * z74 - (z144 * z75 - z166)))) - R_yy
        * (z62 * z142);
    const double z168 = z167 + F_yy * (z68 * z164);
    const double z169 = z168 * z126;
    kept[191] = z169;
    const double z170 = z149 * z114 - (z134 * z115 - (z141 * z116 - (z145 * z117 - (z143 * z118 + z150 *
        z119))));
    const double z171 = z134 * z105 - (z148 * z110 + (z146 * z111 + (z151 * z112 - (z144 * z113 - z170)))) -
        R_yy * (z100 * z142);
    const double z172 = z171 + F_yy * (z106 * z164) - z125 * z169;
    const double z173 = 1.0 / z128;
    kept[192] = z173;
    const double z174 = z172 * z173;
    kept[193] = z174;
    const double z175 = z165 - z168 * z169 - z172 * z174;
    kept[194] = z175;
    const double z176 = s1 * z63 - c1 * z70;
    const double z177 = e2z * z176 - c_roll * z45;
    const double z178 = s1 * z70 + c1 * z63;
    const double s_yaw = kept[6];
    const double c_yaw = kept[7];
    /* (I.2.15) */
    J[9] = s_yaw * z177 - c_yaw * z178;
    const double z179 = s1 * z101 - c1 * z108;
    const double z180 = e2z * z179;
    const double z181 = s1 * z108 + c1 * z101;
    J[10] = s_yaw * z180 - c_yaw * z181;
    const double z182 = s1 * z143 - c1 * z150;
    const double z183 = e2z * z182;
    const double z184 = s1 * z150 + c1 * z143;
    J[11] = s_yaw * z183 - c_yaw * z184;
    J[21] = -(s_yaw * z178 + c_yaw * z177);
    J[22] = -(s_yaw * z181 + c_yaw * z180);
    J[23] = -(s_yaw * z184 + c_yaw * z183);
    J[33] = e2z * z45 + c_roll * z176;
    J[34] = c_roll * z179;
    J[35] = c_roll * z182;
    const double z52 = kept[90];
    J[45] = z52;
    J[46] = z89;
    J[47] = -z132;
    J[57] = 1.0;
    const double z60 = kept[98];
    J[69] = -z60;
    J[70] = -z98;
    J[71] = -z140;
    J[82] = 1.0;
    const double z58 = kept[96];
    J[93] = z58;
    J[94] = z96;
    J[95] = z138;
    J[107] = 1.0;
    const double z185 = 1.0 / (c_roll * c_roll);
    kept[195] = z185;
    const double roll_dot = y[9];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z186 = roll_dot * r_R;
    kept[196] = z186;
    const double z187 = c_roll * z186;
    kept[197] = z187;
    const double z6 = kept[44];
    const double z188 = z6 * z6;
    kept[198] = z188;
    const double z12 = kept[50];
    const double z189 = z12 * z187;
    kept[199] = z189;
    const double z38 = kept[76];
    const double z190 = 1.0 / (z38 * z38);
    kept[200] = z190;
    const double z191 = roll_dot * c1;
    kept[201] = z191;
    const double z192 = s_steer * z191;
    kept[202] = z192;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part3(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)J;
    (void)t;
    const double thF_dot = y[11];
    const double z192 = kept[202];
    const double z193 = thF_dot - z192;
    kept[203] = z193;
    const double roll_dot = y[9];
    const double s1 = kept[2];
    const double z194 = roll_dot * s1;
    const double steer_dot = y[10];
    const double z195 = steer_dot + z194;
    kept[204] = z195;
    const double c_steer = kept[5];
    const double z191 = kept[201];
    const double z196 = c_steer * z191;
    kept[205] = z196;
    const double k10 = kept[9];
    const double z189 = kept[199];
    const double z197 = z189 + k10 * z194;
    kept[206] = z197;
    const double k4 = kept[8];
    const double z8 = kept[46];
    const double z198 = k4 * z192 - z8 * z193;
    kept[207] = z198;
    const double k16 = kept[10];
    const double z21 = kept[59];
    const double z199 = z8 * z195 - z21 * z196 - (k16 * z196 - k4 * z195 - c_steer * z197);
    kept[208] = z199;
    const double s_steer = kept[4];
    const double z200 = z21 * z193 - (k16 * z192 - s_steer * z197);
    kept[209] = z200;
    const double z19 = kept[57];
    const double z26 = kept[64];
    const double z201 = z19 * z199 + z26 * z200;
    kept[210] = z201;
    const double z24 = kept[62];
    const double z25 = kept[63];
    const double z202 = z25 * z199 + z24 * z200;
    kept[211] = z202;
    const double z14 = kept[52];
    const double z15 = kept[53];
    const double z27 = kept[65];
    const double z203 = z27 * z198 + z15 * z201 - z14 * z202;
    kept[212] = z203;
    const double z31 = kept[69];
    const double z35 = kept[73];
    const double z204 = z31 * z200 - z35 * z199;
    kept[213] = z204;
    const double z16 = kept[54];
    const double z36 = kept[74];
    const double z205 = z16 * z201 + z36 * z198 - z14 * z204;
    kept[214] = z205;
    const double z37 = kept[75];
    const double z206 = z16 * z202 - z15 * z204 + z37 * z198;
    kept[215] = z206;
    const double z40 = kept[78];
    const double z207 = z40 * z203;
    kept[216] = z207;
    const double z208 = z40 * z206;
    kept[217] = z208;
    const double z209 = z40 * z205;
    kept[218] = z209;
    const double e2z = kept[1];
    const double z210 = z209 - e2z * z207;
    kept[219] = z210;
    const double z211 = z208 - z210;
    kept[220] = z211;
    const double z18 = kept[56];
    const double z212 = z18 * z211;
    kept[221] = z212;
    const double z213 = z14 * z211;
    kept[222] = z213;
    const double c1 = kept[3];
    const double z214 = s1 * z212 - c1 * z213;
    kept[223] = z214;
    const double z215 = s1 * z213 + c1 * z212;
    kept[224] = z215;
    const double c_roll = kept[0];
    const double z216 = c_roll * z189 - e2z * z214;
    kept[225] = z216;
    const double z175 = kept[194];
    const double z274 = 1.0 / z175;
    kept[226] = z274;
    const double z275 = steer_dot * s_steer;
    kept[227] = z275;
    const double z276 = roll_dot * e2z;
    kept[228] = z276;
    const double z277 = s1 * z209;
    kept[229] = z277;
    const double z278 = z276 * c1 - c_roll * z277;
    kept[230] = z278;
    const double z279 = roll_dot * c_roll;
    kept[231] = z279;
    const double z280 = steer_dot * c_steer;
    kept[232] = z280;
    const double z281 = c1 * z209;
    kept[233] = z281;
    const double z282 = z276 * s1 + c_roll * z281;
    kept[234] = z282;
    const double z3 = kept[41];
    const double z283 = s_steer * z279 + e2z * z280 + (z275 * z3 + c_steer * z282);
    kept[235] = z283;
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z284 = z2 * z278 - z4 * z283;
    kept[236] = z284;
    const double z6 = kept[44];
    const double z285 = z6 * z284;
    kept[237] = z285;
    const double z188 = kept[198];
    const double z286 = z188 * z285;
    kept[238] = z286;
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z287 = r_F * z283;
    kept[239] = z287;
    const double z7 = kept[45];
    const double z288 = z7 * z286 + z6 * z287;
    kept[240] = z288;
    const double z289 = roll_dot * z281;
    kept[241] = z289;
    const double z290 = r_F * z278;
    kept[242] = z290;
    const double z20 = kept[58];
    const double z291 = z20 * z286 - z6 * z290;
    kept[243] = z291;
    const double z292 = roll_dot * z277;
    kept[244] = z292;
    const double z293 = z275 * z191 - c_steer * z292;
    kept[245] = z293;
    const double z294 = c_roll * z276;
    kept[246] = z294;
    const double z12 = kept[50];
    const double z295 = z12 * z294;
    kept[247] = z295;
    const double z185 = kept[195];
    const double z296 = z295 * z185;
    kept[248] = z296;
    const double z186 = kept[196];
    const double z297 = z276 * z186;
    kept[249] = z297;
    const double z187 = kept[197];
    const double z298 = z187 * z296 - z12 * z297 - k10 * z289;
    kept[250] = z298;
    const double z299 = z195 * z288 - z8 * z289 - (z196 * z291 - z21 * z293) + (k16 * z293 - k4 * z289 -
        (z275 * z197 - c_steer * z298));
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z300 = r_R * z278;
    kept[251] = z300;
    const double z17 = kept[55];
    const double z301 = z17 * z296 - z12 * z300;
    kept[252] = z301;
    const double z302 = z280 * z18 + s_steer * z301;
    kept[253] = z302;
    const double z22 = kept[60];
    const double z303 = z275 * z22 - c_steer * z291;
    kept[254] = z303;
    const double z304 = z275 * k10 - z288;
    kept[255] = z304;
    const double z28 = kept[66];
    const double z29 = kept[67];
    const double z305 = z28 * z281 + s1 * z303 - (z29 * z277 - c1 * z304);
    kept[256] = z305;
    const double z306 = z301 - z291;
    kept[257] = z306;
    const double z23 = kept[61];
    const double z307 = z280 * z23 + s_steer * z306;
    kept[258] = z307;
    const double z30 = kept[68];
    const double z308 = z276 * z30 + c_roll * z305 - (z279 * z24 + e2z * z307);
    kept[259] = z308;
    const double z309 = z299 + (z208 * z302 - (z207 * z308 + z209 * z307));
    kept[260] = z309;
    const double z310 = z280 * z191 + s_steer * z292;
    kept[261] = z310;
    const double z311 = z275 * z18 - c_steer * z301;
    kept[262] = z311;
    const double z312 = z280 * z22 + s_steer * z291;
    kept[263] = z312;
    const double z313 = z280 * k10;
    kept[264] = z313;
    const double z32 = kept[70];
    const double z33 = kept[71];
    const double z314 = z32 * z281 - s1 * z312 - (c1 * z313 + z33 * z277);
    kept[265] = z314;
    const double z315 = z275 * z23 - c_steer * z306;
    kept[266] = z315;
    const double z34 = kept[72];
    const double z316 = z276 * z34 + c_roll * z314 + (z279 * z25 - e2z * z315);
    kept[267] = z316;
    const double z317 = z193 * z291 - z21 * z310 - (k16 * z310 - (z280 * z197 + s_steer * z298)) + (z208 *
        z311 - (z207 * z316 + z209 * z315));
    kept[268] = z317;
    const double z318 = z19 * z309 + z26 * z317;
    kept[269] = z318;
    const double z319 = r_R * z282;
    kept[270] = z319;
    const double z13 = kept[51];
    const double z320 = z13 * z296 - z12 * z319;
    kept[271] = z320;
    const double z9 = kept[47];
    const double z321 = z280 * z9 + s_steer * z288;
    kept[272] = z321;
    const double z10 = kept[48];
    const double z322 = z10 * z281 - s1 * z321;
    kept[273] = z322;
    const double z323 = z320 - (z275 * z9 - c_steer * z288);
    kept[274] = z323;
    const double z11 = kept[49];
    const double z324 = z276 * z11 + c_roll * z322 - (z279 * z15 + e2z * z323);
    kept[275] = z324;
    const double z325 = k4 * z310 - (z193 * z288 - z8 * z310) - (z208 * z320 - (z207 * z324 + z209 * z323));
    kept[276] = z325;
    const double z326 = z31 * z317 - z35 * z309;
    kept[277] = z326;
    const double z327 = z16 * z318 + z36 * z325 - z14 * z326;
    kept[278] = z327;
    const double z328 = z25 * z309 + z24 * z317;
    kept[279] = z328;
    const double z329 = z27 * z325 + z15 * z318 - z14 * z328;
    kept[280] = z329;
    const double z330 = z40 * z329;
    kept[281] = z330;
    const double z331 = z40 * z327 - (z279 * z207 + e2z * z330);
    kept[282] = z331;
    const double z332 = c_roll * z207;
    kept[283] = z332;
    const double z333 = z191 - s1 * z332;
    kept[284] = z333;
    const double z334 = z276 * z207 - c_roll * z330;
    kept[285] = z334;
    const double z335 = z292 + (z332 * z281 + s1 * z334);
    kept[286] = z335;
    const double z336 = z275 * z210 - c_steer * z331 - (z280 * z333 + s_steer * z335);
    kept[287] = z336;
    const double z337 = z16 * z328 - z15 * z326 + z37 * z325;
    kept[288] = z337;
    const double z338 = z40 * z337 - z331;
    kept[289] = z338;
    const double z45 = kept[83];
    const double v2_x = roll_dot * z45;
    kept[290] = v2_x;
    const double z339 = z194 + c1 * z332;
    kept[291] = z339;
    const double z340 = z211 * z301 + z18 * z338 - (z210 * z213 - v2_x * z339);
    const double z341 = k10 * z210;
    kept[292] = z341;
    const double z342 = k10 * z339;
    kept[293] = z342;
    const double z343 = z340 + (z210 * z341 + z339 * z342);
    kept[294] = z343;
    const double z344 = r_R * z276;
    kept[295] = z344;
    const double z44 = kept[82];
    const double z345 = z12 * z344 - z44 * z296;
    kept[296] = z345;
    const double z346 = roll_dot * z345 + (z212 * z339 - z213 * z333);
    const double z347 = z289 - (z332 * z277 - c1 * z334);
    const double z348 = z346 + (k10 * z347 + z341 * z333);
    kept[297] = z348;
    const double z349 = c_steer * z343 + s_steer * z348;
    const double z350 = z211 * z320 + z14 * z338 - (v2_x * z333 - z210 * z212);
    const double z351 = z350 - (k10 * z331 + z333 * z342);
    const double w3_steer = steer_dot + z339;
    kept[298] = w3_steer;
    const double z352 = s_steer * z210 - c_steer * z333;
    kept[299] = z352;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z353 = k55 * z352 + k56 * w3_steer;
    kept[300] = z353;
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z354 = k62 * z352 + k63 * w3_steer;
    kept[301] = z354;
    const double k45 = kept[23];
    const double k48 = kept[24];
    const double k59 = kept[27];
    const double k70 = kept[33];
    const double k71 = kept[34];
    const double k73 = kept[36];
    const double k74 = kept[37];
    const double z355 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73) - (k59 * z336 - (k45 * z349 - k48 * z351)
        - (w3_steer * z353 - z352 * z354));
    kept[302] = z355;
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z356 = c_steer * z348 - s_steer * z343;
    const double z357 = z280 * z210 + s_steer * z331 + (z275 * z333 - c_steer * z335);
    const double z358 = c_steer * z210 + s_steer * z333;
    kept[303] = z358;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z359 = F_yy * (thF_dot - z358) - k59 * z358;
    kept[304] = z359;
    const double k75 = kept[38];
    const double z360 = h2z * k75 + (k56 * z347 + (k45 * z356 - k55 * z357) - (z358 * z354 + w3_steer *
        z359));
    kept[305] = z360;
    const double z361 = k45 * z352 + k48 * w3_steer;
    kept[306] = z361;
    const double z362 = k45 * z358;
    kept[307] = z362;
    const double k43 = kept[22];
    const double k72 = kept[35];
    const double z363 = z2 * k72 + (k43 * z351 + k48 * z336 + (z352 * z361 + z358 * z362));
    kept[308] = z363;
    const double z364 = k48 * z358;
    kept[309] = z364;
    const double z365 = h2z * k72 + (k48 * z347 + (k43 * z356 - k45 * z357) + (w3_steer * z362 - z352 *
        z364));
    kept[310] = z365;
    const double z366 = z4 * k72 + (k43 * z349 - k45 * z336 + (z358 * z364 + w3_steer * z361));
    kept[311] = z366;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double k37 = kept[19];
    const double z367 = R_yy * z211 - k37 * z210;
    kept[312] = z367;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z368 = k34 * z333 - k35 * z339;
    kept[313] = z368;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double k68 = kept[31];
    const double z369 = e2z * k68 + (k41 * z347 + (k28 * z346 + k40 * z335) - (z333 * z367 + z210 * z368));
    kept[314] = z369;
    const double k76 = kept[39];
    const double z370 = h2z * k76 - (k63 * z347 + (k48 * z356 - k62 * z357) + (z352 * z359 + z358 * z353));
    kept[315] = z370;
    const double z371 = z369 - z370;
    kept[316] = z371;
    const double z372 = k40 * z333 - k41 * z339;
    kept[317] = z372;
    const double k27 = kept[15];
    const double k69 = kept[32];
    const double z373 = z3 * k69 + z2 * k68 - (k37 * z331 + (k27 * z340 - k28 * z350) - (z339 * z368 + z333 *
        z372));
    kept[318] = z373;
    const double z374 = e2z * k69 + (k35 * z347 + (k27 * z346 + k34 * z335) + (z210 * z372 - z339 * z367));
    kept[319] = z374;
    const double z375 = k27 * z333 - k28 * z339;
    kept[320] = z375;
    const double z376 = k27 * z210;
    kept[321] = z376;
    const double k26 = kept[14];
    const double k67 = kept[30];
    const double z377 = z2 * k67 + (k26 * z350 - k28 * z331 + (z333 * z375 + z210 * z376));
    kept[322] = z377;
    const double z378 = k28 * z210;
    kept[323] = z378;
    const double z379 = z3 * k67 - (k26 * z340 + k27 * z331 + (z210 * z378 - z339 * z375));
    kept[324] = z379;
    const double z380 = e2z * k67 + (k28 * z347 + (k26 * z346 + k27 * z335) + (z339 * z376 + z333 * z378));
    kept[325] = z380;
    const double z5 = kept[43];
    const double z381 = 1.0 / (z5 * z5);
    kept[326] = z381;
    const double z382 = 1.0 / (c_roll * c_roll * c_roll);
    kept[327] = z382;
    const double z134 = kept[163];
    const double z141 = kept[168];
    const double z143 = kept[170];
    const double z145 = kept[172];
    const double z149 = kept[176];
    const double z150 = kept[177];
    const double z383 = z149 * z366 + (z134 * z369 - (z141 * z373 - (z145 * z374 - (z143 * z379 - z150 *
        z377))));
    const double z142 = kept[169];
    const double z144 = kept[171];
    const double z146 = kept[173];
    const double z148 = kept[175];
    const double z151 = kept[178];
    const double z384 = z134 * z370 - (z148 * z355 - (z146 * z360 - (z151 * z363 + (z144 * z365 + z383)))) -
        R_yy * (z142 * z338);
    const double z54 = kept[92];
    const double z61 = kept[99];
    const double z63 = kept[101];
    const double z65 = kept[103];
    const double z70 = kept[108];
    const double z385 = z54 * z369 + (z61 * z373 - (z65 * z374 + (z70 * z377 - (z63 * z379 + z45 * z380))));
    const double z64 = kept[102];
    const double z66 = kept[104];
    const double z68 = kept[106];
    const double z69 = kept[107];
    const double z71 = kept[109];
    const double z386 = z54 * z370 + (z68 * z355 - (z66 * z360 - (z71 * z363 - (z64 * z365 - (z69 * z366 -
        z385)))));
    const double z62 = kept[100];
    const double z387 = z386 + R_yy * (z62 * z338) - F_yy * (z68 * z336);
    const double z91 = kept[127];
    const double z99 = kept[133];
    const double z101 = kept[135];
    const double z103 = kept[137];
    const double z107 = kept[141];
    const double z108 = kept[142];
    const double z388 = z107 * z366 - (z91 * z369 + (z99 * z373 + (z103 * z374 + (z101 * z379 - z108 *
        z377))));
    const double z92 = kept[128];
    const double z100 = kept[134];
    const double z102 = kept[136];
    const double z104 = kept[138];
    const double z106 = kept[140];
    const double z109 = kept[143];
    const double z389 = z92 * z370 + (z106 * z355 - (z104 * z360 - (z109 * z363 - (z102 * z365 - z388)))) +
        R_yy * (z100 * z338);
    const double z127 = kept[156];
    const double z390 = z389 - F_yy * (z106 * z336) - z387 * z127;
    const double z164 = kept[189];
    const double z169 = kept[191];
    const double z174 = kept[193];
    const double z391 = z274 * (z384 - F_yy * (z164 * z336) - z387 * z169 - z174 * z390);
    kept[328] = z391;
    const double z173 = kept[192];
    const double z392 = z173 * z390 - z174 * z391;
    kept[329] = z392;
    const double z126 = kept[155];
    const double z393 = z387 * z126 - z127 * z392 - z169 * z391;
    kept[330] = z393;
    const double k22 = kept[11];
    const double k24 = kept[12];
    const double k25 = kept[13];
    const double z38 = kept[76];
    const double z39 = kept[77];
    /* the coframe is singular */
    if (!(fabs(z38) > 1e-12 * ((z39 + k25) * (k22 * (z39 + k24))))) {
        return BICYCLE_SINGULAR_1;
    }
    const double z85 = kept[121];
    /* the mass matrix is singular */
    if (!(fabs(z85) > 0.0)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z122 = kept[154];
    const double z128 = kept[157];
    /* the mass matrix is singular */
    if (!(fabs(z128) > 1e-14 * z122)) {
        return BICYCLE_SINGULAR_2;
    }
    const double z165 = kept[190];
    /* the mass matrix is singular */
    if (!(fabs(z175) > 1e-14 * z165)) {
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
    const bicycle_lanes z217 = s_yaw * turn_3;
    const double c1 = kept[3];
    const bicycle_lanes turn_5 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z218 = c1 * turn_5;
    const double e2z = kept[1];
    const bicycle_lanes turn_4 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z219 = e2z * turn_4;
    const double c_roll = kept[0];
    const double z12 = kept[50];
    const double z185 = kept[195];
    const bicycle_lanes z220 = z185 * (z12 * (c_roll * z219));
    const double s1 = kept[2];
    const bicycle_lanes z221 = s1 * z219 - c_roll * z218;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z13 = kept[51];
    const bicycle_lanes z222 = z13 * z220 - z12 * (r_R * z221);
    const double c_steer = kept[5];
    const bicycle_lanes turn_6 = bicycle_get(seed + 3 * BICYCLE_LANES);
    const bicycle_lanes z223 = c_steer * turn_6;
    const bicycle_lanes z224 = s1 * turn_5;
    const bicycle_lanes z225 = c1 * z219 + c_roll * z224;
    const bicycle_lanes z226 = c_roll * turn_4;
    const double s_steer = kept[4];
    const bicycle_lanes z227 = s_steer * turn_6;
    const double z3 = kept[41];
    const bicycle_lanes z228 = s_steer * z226 + e2z * z223 + (z3 * z227 + c_steer * z221);
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z6 = kept[44];
    const double z188 = kept[198];
    const bicycle_lanes z229 = z188 * (z6 * (z2 * z225 - z4 * z228));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z7 = kept[45];
    const bicycle_lanes z230 = z7 * z229 + z6 * (r_F * z228);
    const double z9 = kept[47];
    const bicycle_lanes z231 = z222 - (z9 * z227 - c_steer * z230);
    const double z10 = kept[48];
    const double z11 = kept[49];
    const double z15 = kept[53];
    const bicycle_lanes z232 = z11 * z219 - c_roll * (z10 * z218 + s1 * (z9 * z223 + s_steer * z230)) - (z15
        * z226 + e2z * z231);
    const double z17 = kept[55];
    const bicycle_lanes z233 = z17 * z220 - z12 * (r_R * z225);
    const double z18 = kept[56];
    const bicycle_lanes z234 = z18 * z227 - c_steer * z233;
    const double z20 = kept[58];
    const bicycle_lanes z235 = z20 * z229 - z6 * (r_F * z225);
    const bicycle_lanes z236 = z233 - z235;
    const double z23 = kept[61];
    const bicycle_lanes z237 = z23 * z223 + s_steer * z236;
    const bicycle_lanes z238 = z23 * z227 - c_steer * z236;
    const bicycle_lanes z239 = z18 * z223 + s_steer * z233;
    const double z19 = kept[57];
    const double z24 = kept[62];
    const double z25 = kept[63];
    const double z26 = kept[64];
    const bicycle_lanes z240 = z24 * z234 - z19 * z237 - (z26 * z238 - z25 * z239);
    const double k10 = kept[9];
    const double z22 = kept[60];
    const double z28 = kept[66];
    const double z29 = kept[67];
    const bicycle_lanes z241 = z28 * z218 - s1 * (z22 * z227 - c_steer * z235) - (z29 * z224 - c1 * (z230 -
        k10 * z227));
    const double z30 = kept[68];
    const bicycle_lanes z242 = z30 * z219 - c_roll * z241 - (z24 * z226 + e2z * z237);
    const double z32 = kept[70];
    const double z33 = kept[71];
    const bicycle_lanes z243 = z32 * z218 + s1 * (z22 * z223 + s_steer * z235) - (z33 * z224 - c1 * (k10 *
        z223));
    const double z34 = kept[72];
    const bicycle_lanes z244 = z34 * z219 - c_roll * z243 + (z25 * z226 - e2z * z238);
    const double z31 = kept[69];
    const double z35 = kept[73];
    const bicycle_lanes z245 = z31 * z234 + z19 * z242 + (z26 * z244 - z35 * z239);
    const bicycle_lanes z246 = z31 * z238 + z25 * z242 + (z24 * z244 - z35 * z237);
    const double z14 = kept[52];
    const double z16 = kept[54];
    const double z27 = kept[65];
    const double z36 = kept[74];
    const double z37 = kept[75];
    const bicycle_lanes z247 = z27 * z232 + z16 * z240 + (z36 * z231 - z15 * z245) - (z37 * z222 - z14 *
        z246);
    const double z190 = kept[200];
    const bicycle_lanes z248 = z190 * z247;
    const double roll_dot = y[9];
    const bicycle_lanes z249 = roll_dot * z218;
    const bicycle_lanes z250 = roll_dot * z224;
    const double z191 = kept[201];
    const bicycle_lanes z251 = z191 * z227 + c_steer * z250;
    const double z186 = kept[196];
    const double z187 = kept[197];
    const bicycle_lanes z252 = z187 * z220 - z12 * (z186 * z219);
    const bicycle_lanes z253 = z252 + k10 * z249;
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z8 = kept[46];
    const double z21 = kept[59];
    const double z195 = kept[204];
    const double z196 = kept[205];
    const double z197 = kept[206];
    const bicycle_lanes z254 = z195 * z230 + z8 * z249 - (z196 * z235 - z21 * z251) + (k16 * z251 + k4 * z249
        - (z197 * z227 - c_steer * z253));
    const bicycle_lanes z255 = z191 * z223 - s_steer * z250;
    const double z193 = kept[203];
    const bicycle_lanes z256 = z193 * z235 - z21 * z255 - (k16 * z255 - (z197 * z223 + s_steer * z253));
    const double z199 = kept[208];
    const double z200 = kept[209];
    const bicycle_lanes z257 = z199 * z238 - z25 * z254 - (z200 * z237 + z24 * z256);
    const bicycle_lanes z258 = z200 * z242 - z31 * z256 - (z199 * z244 - z35 * z254);
    const bicycle_lanes z259 = k4 * z255 - (z193 * z230 - z8 * z255);
    const double z198 = kept[207];
    const double z202 = kept[211];
    const double z204 = kept[213];
    const bicycle_lanes z260 = z202 * z232 + z16 * z257 + (z204 * z231 - z15 * z258) + (z198 * z246 - z37 *
        z259);
    const double z40 = kept[78];
    const double z206 = kept[215];
    const bicycle_lanes z261 = z206 * z248 - z40 * z260;
    const bicycle_lanes z262 = z199 * z234 - z19 * z254 - (z200 * z239 + z26 * z256);
    const double z201 = kept[210];
    const bicycle_lanes z263 = z201 * z232 + z16 * z262 + (z198 * z245 - z36 * z259) + (z204 * z222 - z14 *
        z258);
    const double z205 = kept[214];
    const bicycle_lanes z264 = z205 * z248 - z40 * z263;
    const bicycle_lanes z265 = z198 * z240 - z27 * z259 - (z201 * z231 - z15 * z262) + (z202 * z222 - z14 *
        z257);
    const double z203 = kept[212];
    const bicycle_lanes z266 = z203 * z248 - z40 * z265;
    const double z207 = kept[216];
    const bicycle_lanes z267 = z261 - (z264 - (z207 * z226 + e2z * z266));
    const double z211 = kept[220];
    const bicycle_lanes z268 = z211 * z222 + z14 * z267;
    const bicycle_lanes z269 = z211 * z233 + z18 * z267;
    const double z212 = kept[221];
    const double z213 = kept[222];
    const bicycle_lanes z270 = z213 * z218 + s1 * z268 - (z212 * z224 - c1 * z269);
    const double c_yaw = kept[7];
    const bicycle_lanes z271 = c_yaw * turn_3;
    const bicycle_lanes z272 = z212 * z218 + s1 * z269 + (z213 * z224 - c1 * z268);
    const double z189 = kept[199];
    const double z214 = kept[223];
    const bicycle_lanes z273 = z189 * z219 - c_roll * z252 + (z214 * z226 + e2z * z272);
    const double z215 = kept[224];
    const double z216 = kept[225];
    bicycle_put(slope + 0 * BICYCLE_LANES, z215 * z217 - c_yaw * z270 - (z216 * z271 - s_yaw * z273));
    bicycle_put(slope + 1 * BICYCLE_LANES, -(z215 * z271 + s_yaw * z270 + (z216 * z217 + c_yaw * z273)));
    bicycle_put(slope + 2 * BICYCLE_LANES, z189 * z226 + e2z * z252 - (z214 * z219 - c_roll * z272));
    bicycle_put(slope + 3 * BICYCLE_LANES, z266);
    bicycle_put(slope + 4 * BICYCLE_LANES, -z264);
    bicycle_put(slope + 5 * BICYCLE_LANES, z261);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part1(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)slope;
    (void)t;
    const double z127 = kept[156];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z394 = row_1 - z127 * row_0;
    const double z169 = kept[191];
    const double z174 = kept[193];
    const double z274 = kept[226];
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z395 = z274 * (row_2 + z169 * row_0 + z174 * z394);
    bicycle_put(carried + 0 * BICYCLE_LANES, z395);
    const double z173 = kept[192];
    const bicycle_lanes z396 = z173 * z394 + z174 * z395;
    bicycle_put(carried + 1 * BICYCLE_LANES, z396);
    const double z126 = kept[155];
    const bicycle_lanes z397 = z126 * row_0 - z127 * z396 + z169 * z395;
    bicycle_put(carried + 2 * BICYCLE_LANES, z397);
    const double z61 = kept[99];
    const double z99 = kept[133];
    const double z141 = kept[168];
    const bicycle_lanes z398 = z141 * z395 + z99 * z396 + z61 * z397;
    bicycle_put(carried + 3 * BICYCLE_LANES, z398);
    const double z70 = kept[108];
    const double z108 = kept[142];
    const double z150 = kept[177];
    const bicycle_lanes z399 = z150 * z395 + z108 * z396 + z70 * z397;
    bicycle_put(carried + 4 * BICYCLE_LANES, z399);
    const double z63 = kept[101];
    const double z101 = kept[135];
    const double z143 = kept[170];
    const bicycle_lanes z400 = z143 * z395 + z101 * z396 + z63 * z397;
    bicycle_put(carried + 5 * BICYCLE_LANES, z400);
    const double z68 = kept[106];
    const double z106 = kept[140];
    const double z148 = kept[175];
    const bicycle_lanes z401 = z148 * z395 + z106 * z396 + z68 * z397;
    bicycle_put(carried + 6 * BICYCLE_LANES, z401);
    const double z71 = kept[109];
    const double z109 = kept[143];
    const double z151 = kept[178];
    const bicycle_lanes z402 = z151 * z395 + z109 * z396 + z71 * z397;
    bicycle_put(carried + 7 * BICYCLE_LANES, z402);
    const double k43 = kept[22];
    const double k48 = kept[24];
    const bicycle_lanes z403 = k48 * z401 - k43 * z402;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const bicycle_lanes z404 = F_yy * z395;
    const bicycle_lanes z405 = F_yy * z396;
    const bicycle_lanes z406 = F_yy * z397;
    bicycle_put(carried + 8 * BICYCLE_LANES, z406);
    const double z69 = kept[107];
    const double z107 = kept[141];
    const double z149 = kept[176];
    const bicycle_lanes z407 = z149 * z395 + z107 * z396 + z69 * z397;
    bicycle_put(carried + 9 * BICYCLE_LANES, z407);
    const double k45 = kept[23];
    const double k59 = kept[27];
    const double z164 = kept[189];
    const bicycle_lanes z408 = z164 * z404 - z106 * z405 - z68 * z406 - k59 * z401 + k48 * z402 - k45 * z407;
    bicycle_put(carried + 10 * BICYCLE_LANES, z408);
    const double z134 = kept[163];
    const bicycle_lanes z409 = z134 * z395;
    const double z54 = kept[92];
    const bicycle_lanes z410 = z54 * z397;
    const double z92 = kept[128];
    const bicycle_lanes z411 = z409 - z92 * z396 - z410;
    bicycle_put(carried + 11 * BICYCLE_LANES, z411);
    const double z66 = kept[104];
    const double z104 = kept[138];
    const double z146 = kept[173];
    const bicycle_lanes z412 = z146 * z395 + z104 * z396 + z66 * z397;
    bicycle_put(carried + 12 * BICYCLE_LANES, z412);
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z144 = kept[171];
    const bicycle_lanes z413 = z144 * z395 - z102 * z396 - z64 * z397;
    bicycle_put(carried + 13 * BICYCLE_LANES, z413);
    const double k55 = kept[25];
    const double k62 = kept[28];
    const bicycle_lanes z414 = k62 * z411 - k55 * z412 + k45 * z413;
    bicycle_put(carried + 14 * BICYCLE_LANES, z414);
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double k10 = kept[9];
    const double k27 = kept[15];
    const double k28 = kept[16];
    const double k37 = kept[19];
    const bicycle_lanes z415 = k37 * z398 - k28 * z399 + k27 * z400 + k10 * z403 - c_steer * z408 - s_steer *
        z414;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z416 = R_yy * z395;
    bicycle_put(carried + 15 * BICYCLE_LANES, z416);
    const bicycle_lanes z417 = R_yy * z396;
    bicycle_put(carried + 16 * BICYCLE_LANES, z417);
    const bicycle_lanes z418 = R_yy * z397;
    bicycle_put(carried + 17 * BICYCLE_LANES, z418);
    const double k26 = kept[14];
    const bicycle_lanes z419 = z403 + (k28 * z398 - k26 * z399);
    bicycle_put(carried + 18 * BICYCLE_LANES, z419);
    const bicycle_lanes z420 = k48 * z411 - k45 * z412 + k43 * z413;
    bicycle_put(carried + 19 * BICYCLE_LANES, z420);
    const bicycle_lanes z421 = k45 * z401 + k43 * z407;
    bicycle_put(carried + 20 * BICYCLE_LANES, z421);
    const bicycle_lanes z422 = s_steer * z420 - c_steer * z421;
    const bicycle_lanes z423 = k27 * z398 + k26 * z400 - z422;
    bicycle_put(carried + 21 * BICYCLE_LANES, z423);
    const double z14 = kept[52];
    const double z18 = kept[56];
    const double z62 = kept[100];
    const double z100 = kept[134];
    const double z142 = kept[169];
    const bicycle_lanes z424 = z142 * z416 + z100 * z417 + z62 * z418 - z14 * z419 + z18 * z423;
    bicycle_put(carried + 22 * BICYCLE_LANES, z424);
    const bicycle_lanes z425 = z415 - z424;
    bicycle_put(carried + 23 * BICYCLE_LANES, z425);
    const double z40 = kept[78];
    const bicycle_lanes z426 = z40 * z424;
    bicycle_put(carried + 24 * BICYCLE_LANES, z426);
    const bicycle_lanes z427 = z40 * z425;
    bicycle_put(carried + 25 * BICYCLE_LANES, z427);
    const double z91 = kept[127];
    const bicycle_lanes z428 = z409 - z91 * z396 - z410;
    bicycle_put(carried + 26 * BICYCLE_LANES, z428);
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z145 = kept[172];
    const bicycle_lanes z429 = z145 * z395 - z103 * z396 + z65 * z397;
    bicycle_put(carried + 27 * BICYCLE_LANES, z429);
    const double z45 = kept[83];
    const bicycle_lanes z430 = z45 * z397;
    bicycle_put(carried + 28 * BICYCLE_LANES, z430);
    const double k34 = kept[17];
    const double k40 = kept[20];
    const bicycle_lanes z431 = k40 * z428 + k34 * z429 - k27 * z430 - s_steer * z408 + c_steer * z414;
    bicycle_put(carried + 29 * BICYCLE_LANES, z431);
    const double k35 = kept[18];
    const double k41 = kept[21];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const bicycle_lanes z432 = k63 * z411 - k56 * z412 + k48 * z413 + k41 * z428 + k35 * z429 - k28 * z430;
    const bicycle_lanes z433 = c_steer * z420 + s_steer * z421;
    const bicycle_lanes z434 = z432 + k10 * z433;
    bicycle_put(carried + 30 * BICYCLE_LANES, z434);
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z435 = s1 * z431 + c1 * z434;
    bicycle_put(carried + 31 * BICYCLE_LANES, z435);
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z436 = c_roll * z435 + e2z * z425;
    bicycle_put(carried + 32 * BICYCLE_LANES, z436);
    const bicycle_lanes z437 = z40 * z436;
    bicycle_put(carried + 33 * BICYCLE_LANES, z437);
    const double z27 = kept[65];
    const double z36 = kept[74];
    const double z37 = kept[75];
    const bicycle_lanes z438 = z37 * z426 + z36 * z427 - z27 * z437;
    bicycle_put(carried + 34 * BICYCLE_LANES, z438);
    const double z207 = kept[216];
    const bicycle_lanes z439 = z207 * z438;
    bicycle_put(carried + 35 * BICYCLE_LANES, z439);
    const double z15 = kept[53];
    const bicycle_lanes z440 = z15 * z426 + z14 * z427;
    bicycle_put(carried + 36 * BICYCLE_LANES, z440);
    const double z16 = kept[54];
    const bicycle_lanes z441 = z16 * z426 + z14 * z437;
    bicycle_put(carried + 37 * BICYCLE_LANES, z441);
    const bicycle_lanes z442 = z16 * z427 - z15 * z437;
    bicycle_put(carried + 38 * BICYCLE_LANES, z442);
    const double z19 = kept[57];
    const double z25 = kept[63];
    const double z35 = kept[73];
    const bicycle_lanes z443 = z35 * z440 + z25 * z441 + z19 * z442;
    bicycle_put(carried + 39 * BICYCLE_LANES, z443);
    const bicycle_lanes z444 = z207 * z443;
    bicycle_put(carried + 40 * BICYCLE_LANES, z444);
    const double z24 = kept[62];
    const double z26 = kept[64];
    const double z31 = kept[69];
    const bicycle_lanes z445 = z31 * z440 - z24 * z441 - z26 * z442;
    bicycle_put(carried + 41 * BICYCLE_LANES, z445);
    const bicycle_lanes z446 = z207 * z445;
    bicycle_put(carried + 42 * BICYCLE_LANES, z446);
    const double z209 = kept[218];
    const bicycle_lanes z447 = z209 * z438 - e2z * z439;
    bicycle_put(carried + 43 * BICYCLE_LANES, z447);
    const bicycle_lanes z448 = c_roll * z439;
    bicycle_put(carried + 44 * BICYCLE_LANES, z448);
    const bicycle_lanes z449 = s1 * z448;
    bicycle_put(carried + 45 * BICYCLE_LANES, z449);
    const bicycle_lanes z450 = c_roll * z444;
    bicycle_put(carried + 46 * BICYCLE_LANES, z450);
    const bicycle_lanes z451 = c1 * z450;
    bicycle_put(carried + 47 * BICYCLE_LANES, z451);
    const double z193 = kept[203];
    const double z195 = kept[204];
    const bicycle_lanes z452 = z195 * z443 - z193 * z438 + c_steer * z447 - s_steer * z449 + z451;
    bicycle_put(carried + 48 * BICYCLE_LANES, z452);
    const bicycle_lanes z453 = z209 * z443 - e2z * z444;
    bicycle_put(carried + 49 * BICYCLE_LANES, z453);
    const bicycle_lanes z454 = z209 * z445 - e2z * z446;
    bicycle_put(carried + 50 * BICYCLE_LANES, z454);
    const bicycle_lanes z455 = s_steer * z453 + c_steer * z454;
    const bicycle_lanes z456 = s1 * z450;
    bicycle_put(carried + 51 * BICYCLE_LANES, z456);
    const bicycle_lanes z457 = c_roll * z446;
    bicycle_put(carried + 52 * BICYCLE_LANES, z457);
    const bicycle_lanes z458 = s1 * z457;
    bicycle_put(carried + 53 * BICYCLE_LANES, z458);
    const double z196 = kept[205];
    const bicycle_lanes z459 = z455 - (z193 * z445 + z196 * z443 - c_steer * z456 + s_steer * z458);
    bicycle_put(carried + 54 * BICYCLE_LANES, z459);
    const double z7 = kept[45];
    const double z20 = kept[58];
    const bicycle_lanes z460 = z7 * z452 + z20 * z459;
    bicycle_put(carried + 55 * BICYCLE_LANES, z460);
    const double z188 = kept[198];
    const bicycle_lanes z461 = z188 * z460;
    bicycle_put(carried + 56 * BICYCLE_LANES, z461);
    const double z6 = kept[44];
    const bicycle_lanes z462 = z6 * z461;
    bicycle_put(carried + 57 * BICYCLE_LANES, z462);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z4 = kept[42];
    const bicycle_lanes z463 = r_F * (z6 * z452) - z4 * z462;
    bicycle_put(carried + 58 * BICYCLE_LANES, z463);
    const bicycle_lanes z464 = z207 * z425 + z15 * z439 - z24 * z444 - z25 * z446 - s_steer * z463;
    bicycle_put(carried + 59 * BICYCLE_LANES, z464);
    const bicycle_lanes z465 = s_steer * z445 - c_steer * z443;
    bicycle_put(carried + 60 * BICYCLE_LANES, z465);
    const double z333 = kept[284];
    const double z339 = kept[291];
    const bicycle_lanes z466 = z333 * z428 + z339 * z429;
    const bicycle_lanes z467 = k28 * z428 + k27 * z429 - k26 * z430 + z433;
    bicycle_put(carried + 61 * BICYCLE_LANES, z467);
    const double z210 = kept[219];
    const bicycle_lanes z468 = z333 * z467 + z210 * z423;
    bicycle_put(carried + 62 * BICYCLE_LANES, z468);
    const bicycle_lanes z469 = z210 * z419 - z339 * z467;
    bicycle_put(carried + 63 * BICYCLE_LANES, z469);
    const double z301 = kept[252];
    const double z320 = kept[271];
    const bicycle_lanes z470 = R_yy * z466 + z320 * z419 - z301 * z423 + z14 * z468 + z18 * z469;
    const double z302 = kept[253];
    const double z311 = kept[262];
    const bicycle_lanes z471 = z311 * z445 - z302 * z443 + z320 * z438 + z470;
    bicycle_put(carried + 64 * BICYCLE_LANES, z471);
    const bicycle_lanes z472 = z40 * z471;
    bicycle_put(carried + 65 * BICYCLE_LANES, z472);
    const double z22 = kept[60];
    const bicycle_lanes z473 = z22 * z443;
    bicycle_put(carried + 66 * BICYCLE_LANES, z473);
    const double k4 = kept[8];
    const double z8 = kept[46];
    const bicycle_lanes z474 = z22 * z445 + z8 * z438 + k4 * z438;
    bicycle_put(carried + 67 * BICYCLE_LANES, z474);
    const bicycle_lanes z475 = z431 - c_steer * z473 + s_steer * z474;
    bicycle_put(carried + 68 * BICYCLE_LANES, z475);
    const double z208 = kept[217];
    const bicycle_lanes z476 = z208 * z443;
    bicycle_put(carried + 69 * BICYCLE_LANES, z476);
    const bicycle_lanes z477 = z208 * z445;
    bicycle_put(carried + 70 * BICYCLE_LANES, z477);
    const double z211 = kept[220];
    const bicycle_lanes z478 = z211 * z423 + s_steer * z476 - z455 + c_steer * z477;
    bicycle_put(carried + 71 * BICYCLE_LANES, z478);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z2 = kept[40];
    const double z12 = kept[50];
    const bicycle_lanes z479 = r_F * (z6 * z459) + r_R * (z12 * z478) - z2 * z462;
    bicycle_put(carried + 72 * BICYCLE_LANES, z479);
    const double roll_dot = y[9];
    const double z29 = kept[67];
    const double z33 = kept[71];
    const double z332 = kept[283];
    const bicycle_lanes z480 = z332 * z434 - z29 * z450 + z33 * z457 - roll_dot * z475 - c_roll * z479;
    bicycle_put(carried + 73 * BICYCLE_LANES, z480);
    const bicycle_lanes z481 = z434 - z8 * z443 - k4 * z443 + k10 * z465;
    bicycle_put(carried + 74 * BICYCLE_LANES, z481);
    const bicycle_lanes z482 = z211 * z419 + z208 * z438 - z447;
    bicycle_put(carried + 75 * BICYCLE_LANES, z482);
    const bicycle_lanes z483 = r_R * (z12 * z482) + c_steer * z463;
    bicycle_put(carried + 76 * BICYCLE_LANES, z483);
    const double z10 = kept[48];
    const double z28 = kept[66];
    const double z32 = kept[70];
    const bicycle_lanes z484 = z332 * z431 + z10 * z448 - z28 * z450 + z32 * z457 + roll_dot * z481 + c_roll
        * z483;
    bicycle_put(carried + 77 * BICYCLE_LANES, z484);
    const double z368 = kept[313];
    const double z372 = kept[317];
    const double z376 = kept[321];
    const double z378 = kept[323];
    const bicycle_lanes z485 = z376 * z399 + z378 * z400 - z368 * z428 + z372 * z429 + k37 * z466 - k28 *
        (z333 * z430 - z210 * z400);
    const double z212 = kept[221];
    const double z213 = kept[222];
    const double z341 = kept[292];
    const bicycle_lanes z486 = z485 + k27 * (z210 * z399 - z339 * z430) - z341 * z422 - z212 * z419 - z213 *
        z423;
    const double w3_steer = kept[298];
    const double z352 = kept[299];
    const bicycle_lanes z487 = z352 * z411 + w3_steer * z412;
    const double z353 = kept[300];
    const double z354 = kept[301];
    const double z358 = kept[303];
    const double z362 = kept[307];
    const double z364 = kept[309];
    const bicycle_lanes z488 = z362 * z402 + z364 * z407 + z353 * z411 + z354 * z412 - k59 * z487 - k48 *
        (z352 * z413 - z358 * z407);
    const bicycle_lanes z489 = F_yy * z487;
    bicycle_put(carried + 78 * BICYCLE_LANES, z489);
    const bicycle_lanes z490 = z488 + k45 * (z358 * z402 + w3_steer * z413) - z489;
    bicycle_put(carried + 79 * BICYCLE_LANES, z490);
    const double z275 = kept[227];
    const double z280 = kept[232];
    const bicycle_lanes z491 = z486 + z275 * z408 - z280 * z414 + k10 * (z333 * z433 - z210 * z422) + c_steer
        * z490;
    const bicycle_lanes z492 = z352 * z401 - z358 * z412;
    const bicycle_lanes z493 = z358 * z411 + w3_steer * z401;
    const double z359 = kept[304];
    const double z361 = kept[306];
    const bicycle_lanes z494 = z361 * z402 - z364 * z413 + z359 * z411 - z354 * z401 - k62 * z492 + k55 *
        z493;
    const bicycle_lanes z495 = z352 * z402 + w3_steer * z407;
    const bicycle_lanes z496 = z494 + k45 * z495;
    bicycle_put(carried + 80 * BICYCLE_LANES, z496);
    const bicycle_lanes z497 = z491 + s_steer * z496 + z470;
    bicycle_put(carried + 81 * BICYCLE_LANES, z497);
    const double z307 = kept[258];
    const double z315 = kept[266];
    const double z323 = kept[274];
    const bicycle_lanes z498 = z315 * z445 - z307 * z443 + z323 * z438 - s1 * z480 + c1 * z484 + z497;
    bicycle_put(carried + 82 * BICYCLE_LANES, z498);
    const bicycle_lanes z499 = z40 * z498;
    bicycle_put(carried + 83 * BICYCLE_LANES, z499);
    const bicycle_lanes z500 = z15 * z472 - z14 * z499;
    bicycle_put(carried + 84 * BICYCLE_LANES, z500);
    const bicycle_lanes z501 = z333 * z398 - z210 * z429;
    const bicycle_lanes z502 = z210 * z428 + z339 * z398;
    const double z367 = kept[312];
    const double z375 = kept[320];
    const bicycle_lanes z503 = z375 * z399 - z378 * z430 - z367 * z428 - z372 * z398 - k40 * z501 - k34 *
        z502;
    const bicycle_lanes z504 = z333 * z399 - z339 * z400;
    const double v2_x = kept[290];
    const double z342 = kept[293];
    const bicycle_lanes z505 = z503 + k27 * z504 + z342 * z403 + z341 * z433 + v2_x * z419 - z213 * z467 -
        z280 * z408;
    const bicycle_lanes z506 = z505 - z275 * z414 + s_steer * z490 - c_steer * z496;
    bicycle_put(carried + 85 * BICYCLE_LANES, z506);
    const bicycle_lanes z507 = z362 * z413 + z361 * z407 + z353 * z401 + z359 * z412 - k63 * z492 + k56 *
        z493;
    const bicycle_lanes z508 = z507 + k48 * z495;
    bicycle_put(carried + 86 * BICYCLE_LANES, z508);
    const bicycle_lanes z509 = z376 * z430 + z375 * z400 + z368 * z398 + z367 * z429 - k41 * z501 - k35 *
        z502;
    const bicycle_lanes z510 = z509 + k28 * z504 + z342 * z422 - z212 * z467 - v2_x * z423 - k10 * (z333 *
        z403 - z339 * z422);
    const bicycle_lanes z511 = z508 - z510;
    bicycle_put(carried + 87 * BICYCLE_LANES, z511);
    const double z277 = kept[229];
    const double z281 = kept[233];
    const bicycle_lanes z512 = z281 * z431 - z277 * z434 - s1 * z506 + c1 * z511;
    bicycle_put(carried + 88 * BICYCLE_LANES, z512);
    const double z276 = kept[228];
    const double z279 = kept[231];
    const double z308 = kept[259];
    const double z316 = kept[267];
    const double z324 = kept[275];
    const bicycle_lanes z513 = z276 * z435 - z279 * z425 + z316 * z445 - z308 * z443 + z324 * z438 + c_roll *
        z512;
    const bicycle_lanes z514 = z513 - e2z * z497;
    bicycle_put(carried + 89 * BICYCLE_LANES, z514);
    const bicycle_lanes z515 = z40 * z514;
    bicycle_put(carried + 90 * BICYCLE_LANES, z515);
    const bicycle_lanes z516 = z16 * z472 + z14 * z515;
    bicycle_put(carried + 91 * BICYCLE_LANES, z516);
    const bicycle_lanes z517 = z16 * z499 + z15 * z515;
    bicycle_put(carried + 92 * BICYCLE_LANES, z517);
    const bicycle_lanes z518 = z31 * z500 - z24 * z516 + z26 * z517;
    bicycle_put(carried + 93 * BICYCLE_LANES, z518);
    const bicycle_lanes z519 = z35 * z500 + z25 * z516 - z19 * z517;
    bicycle_put(carried + 94 * BICYCLE_LANES, z519);
    const bicycle_lanes z520 = z280 * z445 + z275 * z443 - s_steer * z518 + c_steer * z519;
    bicycle_put(carried + 95 * BICYCLE_LANES, z520);
    const double z296 = kept[248];
    const bicycle_lanes z521 = z296 * z465 + z12 * z520;
    bicycle_put(carried + 96 * BICYCLE_LANES, z521);
    const bicycle_lanes z522 = roll_dot * z467;
    bicycle_put(carried + 97 * BICYCLE_LANES, z522);
    const double z13 = kept[51];
    const double z17 = kept[55];
    const double z44 = kept[82];
    const double z187 = kept[197];
    const bicycle_lanes z523 = z44 * z522 + z187 * z465 + z13 * z482 - z17 * z478;
    bicycle_put(carried + 98 * BICYCLE_LANES, z523);
    const double z185 = kept[195];
    const bicycle_lanes z524 = z185 * z523;
    bicycle_put(carried + 99 * BICYCLE_LANES, z524);
    const bicycle_lanes z525 = z12 * z524;
    bicycle_put(carried + 100 * BICYCLE_LANES, z525);
    const double z305 = kept[256];
    const double z314 = kept[265];
    const double z322 = kept[273];
    const double z330 = kept[281];
    const bicycle_lanes z526 = z330 * z435 - z322 * z439 + z305 * z444 - z314 * z446 - z281 * z483 - z277 *
        z479;
    bicycle_put(carried + 101 * BICYCLE_LANES, z526);
    const double z391 = kept[328];
    const bicycle_lanes z527 = z391 * z395;
    bicycle_put(carried + 102 * BICYCLE_LANES, z527);
    const bicycle_lanes z528 = z134 * z527;
    const bicycle_lanes z529 = z146 * z527;
    const bicycle_lanes z530 = z144 * z527;
    const double z147 = kept[174];
    const double z157 = kept[184];
    const double z371 = kept[316];
    const bicycle_lanes z531 = z395 * z371 + z147 * z527 + z157 * z527 + k63 * z528 - k56 * z529 + k48 * z530;
    const bicycle_lanes z532 = z145 * z527;
    const double z392 = kept[329];
    const bicycle_lanes z533 = z392 * z395 - z391 * z396;
    bicycle_put(carried + 103 * BICYCLE_LANES, z533);
    const double z393 = kept[330];
    const bicycle_lanes z534 = z393 * z395 - z391 * z397;
    bicycle_put(carried + 104 * BICYCLE_LANES, z534);
    const double z67 = kept[105];
    const double z77 = kept[115];
    const double z105 = kept[139];
    const double z115 = kept[149];
    const bicycle_lanes z535 = z531 + k41 * z528 + k35 * z532 + z105 * z533 + z115 * z533 + z67 * z534 + z77
        * z534;
    const double z113 = kept[147];
    const double z155 = kept[182];
    const double z365 = kept[310];
    const bicycle_lanes z536 = z365 * z395 + z155 * z527 + k48 * z528 - k45 * z529 + k43 * z530 + z113 * z533;
    const double z75 = kept[113];
    const bicycle_lanes z537 = z536 + z75 * z534;
    bicycle_put(carried + 105 * BICYCLE_LANES, z537);
    const bicycle_lanes z538 = z148 * z527;
    bicycle_put(carried + 106 * BICYCLE_LANES, z538);
    const bicycle_lanes z539 = z149 * z527;
    const double z76 = kept[114];
    const double z114 = kept[148];
    const double z156 = kept[183];
    const double z366 = kept[311];
    const bicycle_lanes z540 = z366 * z395 + z156 * z527 + k45 * z538 + k43 * z539 - z114 * z533 - z76 * z534;
    bicycle_put(carried + 107 * BICYCLE_LANES, z540);
    const bicycle_lanes z541 = z535 + k10 * (c_steer * z537 + s_steer * z540);
    bicycle_put(carried + 108 * BICYCLE_LANES, z541);
    const double z79 = kept[117];
    const double z117 = kept[151];
    const double z159 = kept[186];
    const double z374 = kept[319];
    const bicycle_lanes z542 = z374 * z395 + z159 * z527 + k40 * z528 + k34 * z532 + z117 * z533 + z79 * z534;
    const bicycle_lanes z543 = F_yy * z533;
    const bicycle_lanes z544 = F_yy * z534;
    bicycle_put(carried + 109 * BICYCLE_LANES, z544);
    const bicycle_lanes z545 = z151 * z527;
    bicycle_put(carried + 110 * BICYCLE_LANES, z545);
    const double z110 = kept[144];
    const double z152 = kept[179];
    const double z355 = kept[302];
    const bicycle_lanes z546 = z355 * z395 + z152 * z527 + k59 * z538 - k48 * z545 + k45 * z539 - z110 * z533;
    const double z72 = kept[110];
    const double z336 = kept[287];
    const bicycle_lanes z547 = z336 * z404 + 2.0 * (z164 * (F_yy * z527)) + z106 * z543 + z68 * z544 - (z546
        - z72 * z534);
    bicycle_put(carried + 111 * BICYCLE_LANES, z547);
    const double z111 = kept[145];
    const double z153 = kept[180];
    const double z360 = kept[305];
    const bicycle_lanes z548 = z360 * z395 + z153 * z527 + k62 * z528 - k55 * z529 + k45 * z530 + z111 * z533;
    const double z73 = kept[111];
    const bicycle_lanes z549 = z548 + z73 * z534;
    bicycle_put(carried + 112 * BICYCLE_LANES, z549);
    const bicycle_lanes z550 = z542 - s_steer * z547 + c_steer * z549;
    bicycle_put(carried + 113 * BICYCLE_LANES, z550);
    const bicycle_lanes z551 = c1 * z541 + s1 * z550;
    bicycle_put(carried + 114 * BICYCLE_LANES, z551);
    const bicycle_lanes z552 = z392 * z396;
    bicycle_put(carried + 115 * BICYCLE_LANES, z552);
    const bicycle_lanes z553 = z134 * z533;
    const bicycle_lanes z554 = z553 - z92 * z552;
    const bicycle_lanes z555 = z146 * z533 + z104 * z552;
    const bicycle_lanes z556 = z144 * z533 - z102 * z552;
    const bicycle_lanes z557 = z393 * z396 + z392 * z397;
    bicycle_put(carried + 116 * BICYCLE_LANES, z557);
    const double z370 = kept[315];
    const bicycle_lanes z558 = z370 * z396 - z105 * z552 + k63 * z554 - k56 * z555 + k48 * z556 - z67 * z557;
    const bicycle_lanes z559 = z553 - z91 * z552;
    const bicycle_lanes z560 = z145 * z533 - z103 * z552;
    const bicycle_lanes z561 = z365 * z396 + z113 * z552 - k48 * z554 + k45 * z555 - k43 * z556 + z75 * z557;
    bicycle_put(carried + 117 * BICYCLE_LANES, z561);
    const bicycle_lanes z562 = z148 * z533 + z106 * z552;
    bicycle_put(carried + 118 * BICYCLE_LANES, z562);
    const bicycle_lanes z563 = z149 * z533 + z107 * z552;
    const bicycle_lanes z564 = z366 * z396 - z114 * z552 - k45 * z562 - k43 * z563 - z76 * z557;
    bicycle_put(carried + 119 * BICYCLE_LANES, z564);
    const double z369 = kept[314];
    const bicycle_lanes z565 = z558 - (z369 * z396 + z115 * z552 - k41 * z559 - k35 * z560 + z77 * z557) -
        k10 * (c_steer * z561 + s_steer * z564);
    bicycle_put(carried + 120 * BICYCLE_LANES, z565);
    const bicycle_lanes z566 = z336 * z405 - z355 * z396 - z164 * z543 + 2.0 * (z106 * (F_yy * z552)) + z110
        * z552;
    const bicycle_lanes z567 = z151 * z533 + z109 * z552;
    bicycle_put(carried + 121 * BICYCLE_LANES, z567);
    const bicycle_lanes z568 = F_yy * z557;
    bicycle_put(carried + 122 * BICYCLE_LANES, z568);
    const bicycle_lanes z569 = z566 + k59 * z562 - k48 * z567 + k45 * z563 + z68 * z568 + z72 * z557;
    bicycle_put(carried + 123 * BICYCLE_LANES, z569);
    const bicycle_lanes z570 = z374 * z396 + z117 * z552 - k40 * z559 - k34 * z560 + z79 * z557 - s_steer *
        z569;
    const bicycle_lanes z571 = z360 * z396 + z111 * z552 - k62 * z554 + k55 * z555 - k45 * z556 + z73 * z557;
    bicycle_put(carried + 124 * BICYCLE_LANES, z571);
    const bicycle_lanes z572 = z570 + c_steer * z571;
    bicycle_put(carried + 125 * BICYCLE_LANES, z572);
    const bicycle_lanes z573 = c1 * z565 - s1 * z572;
    bicycle_put(carried + 126 * BICYCLE_LANES, z573);
    const bicycle_lanes z574 = z393 * z397;
    bicycle_put(carried + 127 * BICYCLE_LANES, z574);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part2(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)seed;
    (void)t;
    const double z134 = kept[163];
    const bicycle_lanes z534 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z575 = z134 * z534;
    const double z54 = kept[92];
    const bicycle_lanes z574 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z576 = z54 * z574;
    const double z92 = kept[128];
    const bicycle_lanes z557 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z577 = z575 - z92 * z557 - z576;
    const double z66 = kept[104];
    const double z104 = kept[138];
    const double z146 = kept[173];
    const bicycle_lanes z578 = z146 * z534 + z104 * z557 + z66 * z574;
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z144 = kept[171];
    const bicycle_lanes z579 = z144 * z534 - z102 * z557 - z64 * z574;
    const double k48 = kept[24];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const double z67 = kept[105];
    const double z77 = kept[115];
    const double z371 = kept[316];
    const bicycle_lanes z397 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z580 = z397 * z371 + z67 * z574 + z77 * z574 - k63 * z577 + k56 * z578 - k48 * z579;
    const double z91 = kept[127];
    const bicycle_lanes z581 = z575 - z91 * z557 - z576;
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z145 = kept[172];
    const bicycle_lanes z582 = z145 * z534 - z103 * z557 + z65 * z574;
    const double z45 = kept[83];
    const bicycle_lanes z583 = z45 * z574;
    const double k43 = kept[22];
    const double k45 = kept[23];
    const double z75 = kept[113];
    const double z365 = kept[310];
    const bicycle_lanes z584 = z365 * z397 + z75 * z574 - k48 * z577 + k45 * z578 - k43 * z579;
    const double z68 = kept[106];
    const double z106 = kept[140];
    const double z148 = kept[175];
    const bicycle_lanes z585 = z148 * z534 + z106 * z557 + z68 * z574;
    const double z69 = kept[107];
    const double z107 = kept[141];
    const double z149 = kept[176];
    const bicycle_lanes z586 = z149 * z534 + z107 * z557 + z69 * z574;
    const double z76 = kept[114];
    const double z366 = kept[311];
    const bicycle_lanes z587 = z366 * z397 - z76 * z574 - k45 * z585 - k43 * z586;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const bicycle_lanes z588 = c_steer * z584 + s_steer * z587;
    const double k10 = kept[9];
    const double k28 = kept[16];
    const double k35 = kept[18];
    const double k41 = kept[21];
    const bicycle_lanes z589 = z580 - k41 * z581 - k35 * z582 + k28 * z583 + k10 * z588;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z164 = kept[189];
    const double z336 = kept[287];
    const double z355 = kept[302];
    const bicycle_lanes z406 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z544 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z568 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z590 = z336 * z406 - z355 * z397 - z164 * z544 + z106 * z568 + 2.0 * (z68 * (F_yy *
        z574));
    const double z71 = kept[109];
    const double z109 = kept[143];
    const double z151 = kept[178];
    const bicycle_lanes z591 = z151 * z534 + z109 * z557 + z71 * z574;
    const double k59 = kept[27];
    const double z72 = kept[110];
    const bicycle_lanes z592 = z590 + z72 * z574 + k59 * z585 - k48 * z591 + k45 * z586;
    const double k27 = kept[15];
    const double k34 = kept[17];
    const double k40 = kept[20];
    const double z79 = kept[117];
    const double z374 = kept[319];
    const bicycle_lanes z593 = z374 * z397 + z79 * z574 - k40 * z581 - k34 * z582 + k27 * z583 - s_steer *
        z592;
    const double k55 = kept[25];
    const double k62 = kept[28];
    const double z73 = kept[111];
    const double z360 = kept[305];
    const bicycle_lanes z594 = z360 * z397 + z73 * z574 - k62 * z577 + k55 * z578 - k45 * z579;
    const bicycle_lanes z595 = z593 + c_steer * z594;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z596 = c1 * z589 + s1 * z595;
    const double z52 = kept[90];
    const double z89 = kept[125];
    const double z132 = kept[161];
    const double z207 = kept[216];
    const double z295 = kept[247];
    const double z382 = kept[327];
    const bicycle_lanes z512 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z523 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z526 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z551 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z573 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z597 = 2.0 * (z295 * z523 * z382) - (z526 - z207 * z512 - z132 * z551 - z89 * z573 +
        z52 * z596);
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z533 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z598 = R_yy * z533;
    const bicycle_lanes z599 = R_yy * z534;
    const double z74 = kept[112];
    const double z112 = kept[146];
    const double z154 = kept[181];
    const double z363 = kept[308];
    const bicycle_lanes z395 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z527 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z538 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z545 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z600 = z363 * z395 + z154 * z527 - k48 * z538 + k43 * z545 - z112 * z533 - z74 * z534;
    const double z141 = kept[168];
    const bicycle_lanes z601 = z141 * z527;
    const double z150 = kept[177];
    const bicycle_lanes z602 = z150 * z527;
    const double k26 = kept[14];
    const double z80 = kept[118];
    const double z119 = kept[153];
    const double z161 = kept[188];
    const double z377 = kept[322];
    const bicycle_lanes z603 = z377 * z395 + z161 * z527 - k28 * z601 + k26 * z602 - z119 * z533 - z80 * z534;
    const bicycle_lanes z604 = z600 + z603;
    const double z14 = kept[52];
    const double z62 = kept[100];
    const double z100 = kept[134];
    const double z142 = kept[169];
    const double z338 = kept[289];
    const bicycle_lanes z416 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z605 = z338 * z416 + 2.0 * (z142 * (R_yy * z527)) - z100 * z598 - z62 * z599 + z14 *
        z604;
    const double z143 = kept[170];
    const bicycle_lanes z606 = z143 * z527;
    const double z81 = kept[119];
    const double z118 = kept[152];
    const double z160 = kept[187];
    const double z379 = kept[324];
    const bicycle_lanes z607 = z379 * z395 - z160 * z527 - k27 * z601 - k26 * z606 + z118 * z533 + z81 * z534;
    const bicycle_lanes z537 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z540 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z608 = z607 + s_steer * z537 - c_steer * z540;
    const double z18 = kept[56];
    const bicycle_lanes z609 = z605 - z18 * z608;
    const double z40 = kept[78];
    const bicycle_lanes z610 = z40 * z609;
    const double k37 = kept[19];
    const double z116 = kept[150];
    const double z158 = kept[185];
    const double z373 = kept[318];
    const bicycle_lanes z611 = z373 * z395 - z158 * z527 - k37 * z601 + k28 * z602 - k27 * z606 + z116 * z533;
    const double z78 = kept[116];
    const bicycle_lanes z547 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z549 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z612 = z611 + z78 * z534 + c_steer * z547 + s_steer * z549 + k10 * z600 + z609;
    const bicycle_lanes z613 = z40 * z612;
    const double z129 = kept[158];
    const double z130 = kept[159];
    const double z201 = kept[210];
    const double z202 = kept[211];
    const double z318 = kept[269];
    const double z328 = kept[279];
    const bicycle_lanes z426 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z427 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z472 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z499 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z614 = z328 * z426 + z318 * z427 - z202 * z472 + z201 * z499 + z130 * z610 - z129 *
        z613;
    const bicycle_lanes z615 = R_yy * z557;
    const bicycle_lanes z396 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z552 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z562 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z567 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z616 = z363 * z396 - z112 * z552 + k48 * z562 - k43 * z567 - z74 * z557;
    const double z99 = kept[133];
    const bicycle_lanes z617 = z141 * z533 + z99 * z552;
    const double z108 = kept[142];
    const bicycle_lanes z618 = z150 * z533 + z108 * z552;
    const bicycle_lanes z619 = z616 + (z377 * z396 - z119 * z552 + k28 * z617 - k26 * z618 - z80 * z557);
    const bicycle_lanes z417 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z620 = z338 * z417 - z142 * z598 - 2.0 * (z100 * (R_yy * z552)) - z62 * z615 + z14 *
        z619;
    const double z101 = kept[135];
    const bicycle_lanes z621 = z143 * z533 + z101 * z552;
    const bicycle_lanes z561 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z622 = z379 * z396 + z118 * z552 + k27 * z617 + k26 * z621 + z81 * z557 + s_steer *
        z561;
    const bicycle_lanes z564 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z623 = z622 - c_steer * z564;
    const bicycle_lanes z624 = z620 - z18 * z623;
    const bicycle_lanes z625 = z40 * z624;
    const bicycle_lanes z626 = z373 * z396 + z116 * z552 + k37 * z617 - k28 * z618 + k27 * z621 + z78 * z557;
    const bicycle_lanes z569 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z571 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z627 = z626 + c_steer * z569 + s_steer * z571 + k10 * z616 + z624;
    const bicycle_lanes z628 = z40 * z627;
    const bicycle_lanes z629 = z363 * z397 - z74 * z574 + k48 * z585 - k43 * z591;
    const double z61 = kept[99];
    const bicycle_lanes z630 = z141 * z534 + z99 * z557 + z61 * z574;
    const double z70 = kept[108];
    const bicycle_lanes z631 = z150 * z534 + z108 * z557 + z70 * z574;
    const bicycle_lanes z632 = z629 + (z377 * z397 - z80 * z574 + k28 * z630 - k26 * z631);
    const bicycle_lanes z418 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z633 = z338 * z418 - z142 * z599 - z100 * z615 - 2.0 * (z62 * (R_yy * z574)) + z14 *
        z632;
    const double z63 = kept[101];
    const bicycle_lanes z634 = z143 * z534 + z101 * z557 + z63 * z574;
    const bicycle_lanes z635 = z379 * z397 + z81 * z574 + k27 * z630 + k26 * z634 + s_steer * z584 - c_steer
        * z587;
    const bicycle_lanes z636 = z633 - z18 * z635;
    const bicycle_lanes z637 = z40 * z636;
    const bicycle_lanes z638 = z373 * z397 + z78 * z574 + k37 * z630 - k28 * z631 + k27 * z634 + c_steer *
        z592;
    const bicycle_lanes z639 = z638 + s_steer * z594 + k10 * z629 + z636;
    const bicycle_lanes z640 = z40 * z639;
    const double z203 = kept[212];
    const double z205 = kept[214];
    const double z206 = kept[215];
    const double z327 = kept[278];
    const double z329 = kept[280];
    const double z337 = kept[288];
    const bicycle_lanes z424 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z425 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z436 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z471 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z498 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z514 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z641 = z337 * z424 + z327 * z425 - z329 * z436 - z206 * z471 + z205 * z498 + z203 *
        z514;
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z642 = c_roll * z551 - e2z * z612;
    const bicycle_lanes z643 = c_roll * z573 + e2z * z627;
    const double z88 = kept[124];
    const double z95 = kept[131];
    const double z97 = kept[132];
    const double z131 = kept[160];
    const double z137 = kept[166];
    const double z139 = kept[167];
    const bicycle_lanes z644 = z641 + z137 * z609 - z139 * z612 + z131 * z642 + z95 * z624 - z97 * z627 + z88
        * z643;
    const bicycle_lanes z645 = c_roll * z596 - e2z * z639;
    const double z51 = kept[89];
    const double z57 = kept[95];
    const double z59 = kept[97];
    const double z190 = kept[200];
    const bicycle_lanes z646 = z190 * (z644 + z57 * z636 - z59 * z639 - z51 * z645);
    const double z27 = kept[65];
    const double z49 = kept[87];
    const double z50 = kept[88];
    const double z86 = kept[122];
    const double z87 = kept[123];
    const bicycle_lanes z647 = z614 + z87 * z625 - z86 * z628 + z50 * z637 - z49 * z640 - z27 * z646;
    const double z15 = kept[53];
    const bicycle_lanes z648 = z15 * z610 - z14 * z613;
    const bicycle_lanes z649 = z15 * z637 - z14 * z640;
    const double z8 = kept[46];
    const double z42 = kept[80];
    const double z198 = kept[207];
    const double z325 = kept[276];
    const bicycle_lanes z650 = z325 * z426 - z198 * z472 - z8 * z610 + z42 * z637 - z14 * z646;
    const bicycle_lanes z651 = z325 * z427 + z198 * z499 + z8 * z613 - z42 * z640 + z15 * z646;
    const double z19 = kept[57];
    const double z21 = kept[59];
    const double z25 = kept[63];
    const double z48 = kept[86];
    const double z200 = kept[209];
    const double z317 = kept[268];
    const bicycle_lanes z440 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z500 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z652 = z317 * z440 - z200 * z500 + z21 * z648 - z48 * z649 - z25 * z650 - z19 * z651;
    const bicycle_lanes z653 = z15 * z625 - z14 * z628;
    const double z9 = kept[47];
    const double z24 = kept[62];
    const double z26 = kept[64];
    const double z47 = kept[85];
    const double z199 = kept[208];
    const double z309 = kept[260];
    const bicycle_lanes z654 = z309 * z440 - z199 * z500 + z9 * z653 + z47 * z649 + z24 * z650 + z26 * z651;
    const double z333 = kept[284];
    const double z339 = kept[291];
    const bicycle_lanes z419 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z423 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z655 = z333 * z419 + z339 * z423;
    const double roll_dot = y[9];
    const double z82 = kept[120];
    const double z380 = kept[325];
    const bicycle_lanes z656 = roll_dot * z655 - (z380 * z397 + z82 * z574 - k28 * z581 - k27 * z582 + k26 *
        z583);
    const bicycle_lanes z657 = z40 * z645;
    const double z16 = kept[54];
    const bicycle_lanes z658 = z16 * z637 + z14 * z657;
    const bicycle_lanes z659 = z16 * z640 + z15 * z657;
    const double z31 = kept[69];
    const bicycle_lanes z660 = z31 * z649 - z24 * z658 + z26 * z659;
    const double z35 = kept[73];
    const bicycle_lanes z661 = z35 * z649 + z25 * z658 - z19 * z659;
    const bicycle_lanes z662 = s_steer * z660 - c_steer * z661;
    const bicycle_lanes z663 = z656 - z588 - z662;
    const double z44 = kept[82];
    const double z294 = kept[246];
    const double z297 = kept[249];
    const double z300 = kept[251];
    const double z319 = kept[270];
    const double z344 = kept[295];
    const bicycle_lanes z465 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z478 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z482 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z522 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z524 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z664 = z319 * z482 - z300 * z478 + z344 * z522 + z297 * z465 - z294 * z524 + z44 *
        z663;
    const double z204 = kept[213];
    const double z211 = kept[220];
    const double z326 = kept[277];
    const bicycle_lanes z437 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z468 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z515 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z665 = z338 * z419 + z326 * z427 - z328 * z437 + z211 * z468 + z204 * z499 + z202 *
        z515;
    const bicycle_lanes z666 = z40 * z642;
    const bicycle_lanes z667 = z40 * z643;
    const double z94 = kept[130];
    const double z136 = kept[165];
    const bicycle_lanes z668 = z665 - z142 * z604 - z136 * z613 - z130 * z666 - z100 * z619 + z94 * z628 +
        z87 * z667;
    const double z279 = kept[231];
    const bicycle_lanes z439 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z669 = z326 * z426 + z318 * z437 + z279 * z439 - z204 * z472 - z201 * z515 + z136 *
        z610;
    const double z36 = kept[74];
    const double z56 = kept[94];
    const bicycle_lanes z670 = z669 + z129 * z666 - z94 * z625 - z86 * z667 - z56 * z637 + z49 * z657 - z36 *
        z646;
    const bicycle_lanes z671 = z670 - e2z * z647;
    const double z37 = kept[75];
    const bicycle_lanes z672 = z668 - z62 * z632 + z56 * z640 - z50 * z657 + z37 * z646 + z671;
    const double z275 = kept[227];
    const double z280 = kept[232];
    const bicycle_lanes z469 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z476 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z477 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z673 = z338 * z423 - z211 * z469 + z280 * z476 - z275 * z477 - z142 * z608 - z100 *
        z623;
    const bicycle_lanes z674 = z16 * z613 + z15 * z666;
    const bicycle_lanes z675 = z325 * z437 - z198 * z515 - z8 * z666 + z42 * z657 + z16 * z646;
    const bicycle_lanes z442 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z517 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z676 = z317 * z442 + z200 * z517 - z21 * z674 + z48 * z659 + z35 * z651 + z25 * z675;
    const bicycle_lanes z677 = z16 * z610 + z14 * z666;
    const bicycle_lanes z441 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z444 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z516 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z678 = z317 * z441 + z279 * z444 - z200 * z516 + z21 * z677 - z48 * z658 + z35 * z650;
    const bicycle_lanes z679 = z678 - z19 * z675 - e2z * z652;
    const bicycle_lanes z680 = z16 * z625 - z14 * z667;
    const bicycle_lanes z446 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z681 = z309 * z441 + z279 * z446 - z199 * z516 + z9 * z680 + z47 * z658 + z31 * z650;
    const bicycle_lanes z682 = z681 + z26 * z675 - e2z * z654;
    const bicycle_lanes z453 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z454 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z683 = z280 * z453 - z275 * z454 - s_steer * z679 - c_steer * z682;
    const bicycle_lanes z684 = z16 * z628 - z15 * z667;
    const bicycle_lanes z685 = z309 * z442 + z199 * z517 - z9 * z684 - z47 * z659 + z31 * z651 - z24 * z675;
    const bicycle_lanes z686 = z673 - z62 * z635 + s_steer * z676 - z683 + c_steer * z685;
    const double z11 = kept[49];
    const double z12 = kept[50];
    const double z13 = kept[51];
    const double z17 = kept[55];
    const double z30 = kept[68];
    const double z34 = kept[72];
    const double z185 = kept[195];
    const double z186 = kept[196];
    const double z187 = kept[197];
    const double z276 = kept[228];
    const bicycle_lanes z520 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z521 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z525 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z687 = z186 * z521 + (z276 * z525 - z597 - z11 * z647 + z30 * z652 - z34 * z654) -
        c_roll * (z12 * (z185 * (z187 * z520 - z664 + z13 * z672 - z17 * z686)));
    const double k72 = kept[35];
    const double k75 = kept[38];
    const double k76 = kept[39];
    const bicycle_lanes z411 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z412 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z413 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z688 = k76 * z411 + k75 * z412 - k72 * z413;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double k67 = kept[30];
    const double k69 = kept[32];
    const double z296 = kept[248];
    const bicycle_lanes z398 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z400 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z463 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z689 = z275 * z463 - (s_steer * z688 + (k69 * z398 + k67 * z400 + r_R * (z296 * z482
        + z12 * z672)));
    const bicycle_lanes z690 = z37 * z472 - z36 * z499 - z27 * z515;
    const double z193 = kept[203];
    const double z195 = kept[204];
    const double z289 = kept[241];
    const double z310 = kept[261];
    const bicycle_lanes z438 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z443 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z519 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z691 = z289 * z443 - z310 * z438 + z195 * z519 - z193 * z690 + z37 * z610 - z36 *
        z613;
    const bicycle_lanes z692 = z37 * z637 - z36 * z640 - z27 * z657;
    const double z41 = kept[79];
    const bicycle_lanes z447 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z449 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z693 = z275 * z447 + z280 * z449 - z35 * z653 - z25 * z680 + z19 * z684 - z41 * z692;
    const bicycle_lanes z694 = z276 * z439 + c_roll * z647;
    const double z281 = kept[233];
    const bicycle_lanes z448 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z695 = z281 * z448 + s1 * z694;
    const bicycle_lanes z696 = z276 * z444 + c_roll * z652;
    const double z277 = kept[229];
    const bicycle_lanes z450 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z697 = z277 * z450 - c1 * z696;
    const bicycle_lanes z698 = z691 - z27 * z666 - s1 * z661 + (z693 + c_steer * z671 - s_steer * z695 -
        z697);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k71 = kept[34];
    const double k74 = kept[37];
    const double z6 = kept[44];
    const double z283 = kept[235];
    const double z286 = kept[238];
    const bicycle_lanes z401 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z407 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z452 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z462 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z699 = z283 * z462 - k74 * z401 - k72 * z407 - k71 * z401 - r_F * (z286 * z452 - z6 *
        z698);
    const double z196 = kept[205];
    const double z293 = kept[245];
    const bicycle_lanes z445 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z518 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z700 = z310 * z445 + z293 * z443 + z193 * z518 + z196 * z519 - z31 * z648 + z24 *
        z677;
    const bicycle_lanes z701 = z281 * z450 + s1 * z696;
    const bicycle_lanes z702 = z276 * z446 + c_roll * z654;
    const bicycle_lanes z457 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z703 = z281 * z457 + s1 * z702;
    const double z43 = kept[81];
    const bicycle_lanes z456 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z458 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z704 = z700 - z26 * z674 + z41 * z660 - z43 * z661 + (z683 - (z275 * z456 + z280 *
        z458 + c_steer * z701 - s_steer * z703));
    const double z7 = kept[45];
    const double z20 = kept[58];
    const double z188 = kept[198];
    const double z284 = kept[236];
    const double z287 = kept[239];
    const double z290 = kept[242];
    const bicycle_lanes z459 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z461 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z705 = z6 * (z188 * (z287 * z452 - z290 * z459 + z284 * z461 - z7 * z698 + z20 *
        z704));
    const double z285 = kept[237];
    const double z381 = kept[326];
    const bicycle_lanes z460 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z706 = z285 * z460 * z381 + 0.5 * z705;
    const double z4 = kept[42];
    const bicycle_lanes z707 = z699 + 2.0 * (z4 * z706);
    const bicycle_lanes z708 = z689 + c_steer * z707;
    const double k68 = kept[31];
    const double k70 = kept[33];
    const double k73 = kept[36];
    const double z278 = kept[230];
    const bicycle_lanes z399 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z402 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z709 = z278 * z462 - k73 * z401 + k72 * z402 + k70 * z401 - k68 * z398 + k67 * z399;
    const double z2 = kept[40];
    const bicycle_lanes z710 = z709 + r_F * (z286 * z459 + z6 * z704) + r_R * (z296 * z478 + z12 * z686) -
        2.0 * (z2 * z706);
    const bicycle_lanes z464 = bicycle_get(carried + 59 * BICYCLE_LANES);
    const bicycle_lanes z711 = roll_dot * z464 + (z687 + r_R * (z296 * z522 - z12 * z663) - s1 * z708 - c1 *
        z710);
    const bicycle_lanes z712 = z12 * z465;
    const bicycle_lanes z435 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z713 = z207 * z435 + r_R * (z12 * z522) + z11 * z439 - z30 * z444 + z34 * z446 + z186
        * z712;
    const bicycle_lanes z479 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z483 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z714 = z713 - c_roll * z525 + s1 * z483 - c1 * z479;
    const double z307 = kept[258];
    const double z315 = kept[266];
    const double z323 = kept[274];
    const double z330 = kept[281];
    const bicycle_lanes z428 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z497 = bicycle_get(carried + 81 * BICYCLE_LANES);
    const bicycle_lanes z715 = z330 * z425 + z323 * z439 - z307 * z444 + z315 * z446 + z207 * z497 - k68 *
        z428;
    const bicycle_lanes z429 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z430 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z716 = z715 - k69 * z429 + k67 * z430 + z132 * z612 - z89 * z627 - z52 * z639 - z15 *
        z647;
    const bicycle_lanes z717 = c_steer * z688 - (roll_dot * z714 + (z280 * z463 - (z716 + z24 * z652 + z25 *
        z654))) + s_steer * z707;
    bicycle_put(slope + 0 * BICYCLE_LANES, c_roll * z717 - e2z * z711);
    const double k16 = kept[10];
    const double z291 = kept[243];
    const bicycle_lanes z718 = z291 * z443 - z21 * z519 - k16 * z519;
    const double z288 = kept[240];
    const bicycle_lanes z719 = z291 * z445 + z288 * z438 - z21 * z518 - z8 * z690;
    const double k4 = kept[8];
    const bicycle_lanes z720 = z719 - (k16 * z518 + k4 * z690);
    const bicycle_lanes z473 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z474 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z506 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z721 = z506 + z275 * z473 + z280 * z474 - c_steer * z718 + s_steer * z720;
    const double z90 = kept[126];
    const double z133 = kept[162];
    const double z209 = kept[218];
    const double z304 = kept[255];
    const double z332 = kept[283];
    const double z334 = kept[285];
    const bicycle_lanes z434 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z484 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z511 = bicycle_get(carried + 87 * BICYCLE_LANES);
    const bicycle_lanes z541 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z565 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z722 = z334 * z434 - z304 * z450 + z209 * z484 + z332 * z511 + z133 * z541 + z90 *
        z565;
    const double z22 = kept[60];
    const bicycle_lanes z723 = z22 * z661;
    const bicycle_lanes z724 = z9 * z692 + z21 * z660 + k16 * z660;
    const double z29 = kept[67];
    const double z53 = kept[91];
    const double z313 = kept[264];
    const bicycle_lanes z725 = z313 * z457 - (z595 + (z722 - z53 * z589)) + c_steer * z723 - s_steer * z724 +
        z29 * z696;
    const bicycle_lanes z726 = z288 * z443 - z8 * z519 - k4 * z519;
    const bicycle_lanes z727 = z726 + (z511 - k10 * z520);
    const double z303 = kept[254];
    const double z312 = kept[263];
    const double z321 = kept[272];
    const bicycle_lanes z431 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z480 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z728 = z334 * z431 - z321 * z448 - z303 * z450 - z312 * z457 - z209 * z480 - z332 *
        z506;
    const bicycle_lanes z550 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z572 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z729 = z728 + z133 * z550 - z90 * z572 - z589 - z53 * z595 + z8 * z661 + k4 * z661;
    const double z10 = kept[48];
    const double z28 = kept[66];
    const double z32 = kept[70];
    const bicycle_lanes z730 = z276 * z483 + (roll_dot * z727 + (z729 + z10 * z694 - z28 * z696 + z32 * z702)
        - k10 * z662);
    const double z33 = kept[71];
    const bicycle_lanes z731 = s1 * (z276 * z479 - (roll_dot * z721 - (z725 - z33 * z702)) - c_roll * z710) +
        c1 * (z730 + c_roll * z708);
    bicycle_put(slope + 1 * BICYCLE_LANES, -z731);
    const double z191 = kept[201];
    const double z197 = kept[206];
    const double z210 = kept[219];
    const bicycle_lanes z408 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z414 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z451 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z732 = z333 * z414 - z210 * z408 + z197 * z443 - z191 * z473 + z9 * z447 + k10 * z451;
    const double z3 = kept[41];
    const double z23 = kept[61];
    const bicycle_lanes z733 = z732 - z23 * z454 + z22 * z456 + z18 * z477 - z3 * z463;
    const double z298 = kept[250];
    const double z331 = kept[282];
    const double z335 = kept[286];
    const double z343 = kept[294];
    const double z348 = kept[297];
    const bicycle_lanes z420 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z421 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z490 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z734 = z343 * z420 - z348 * z421 + z335 * z408 + z331 * z414 - z333 * z490 + z298 *
        z445;
    const double z292 = kept[244];
    const double z301 = kept[252];
    const double z306 = kept[257];
    const bicycle_lanes z496 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z735 = z734 - z292 * z474 + z288 * z449 + z306 * z453 - z301 * z476 + z291 * z458 -
        z210 * z496;
    const double z135 = kept[164];
    const bicycle_lanes z736 = z735 + z145 * z547 + z141 * z549 + z143 * z537 - z135 * z540 - z103 * z569 +
        z99 * z571;
    const double z55 = kept[93];
    const double z93 = kept[129];
    const bicycle_lanes z737 = z736 + z101 * z561 + z93 * z564 + z65 * z592 + z61 * z594 + z63 * z584 + z55 *
        z587;
    const double z46 = kept[84];
    const bicycle_lanes z738 = z191 * z720 + (z197 * z518 - z737) - z46 * z660 + c1 * z724 + z9 * z695 + z23
        * z679;
    const bicycle_lanes z739 = z3 * z688 - (z738 + z18 * z676 + z22 * z703 - k10 * (z277 * z457 - c1 * z702));
    const bicycle_lanes z740 = z333 * z408 + z210 * z414 + z197 * z445 - z191 * z474 + z9 * z449 + z23 * z453;
    const bicycle_lanes z741 = z740 - z18 * z476 + z22 * z458 + k10 * (c1 * z457) - e2z * z463;
    const bicycle_lanes z742 = z348 * z420 + z343 * z421 + z335 * z414 - z331 * z408 - z333 * z496 + z298 *
        z443;
    const double z282 = kept[234];
    const bicycle_lanes z743 = z742 - z292 * z473 + z288 * z447 - z306 * z454 + z291 * z456 + z301 * z477 +
        z282 * z463;
    const bicycle_lanes z744 = z743 + z210 * z490 - z141 * z547 + z145 * z549 + z135 * z537 + z143 * z540 -
        z99 * z569;
    const bicycle_lanes z745 = z744 - z103 * z571 - z93 * z561 + z101 * z564 - z61 * z592 + z65 * z594 - z55
        * z584;
    const bicycle_lanes z746 = z191 * z718 + (z197 * z519 - (z745 + z63 * z587)) - z46 * z661 + c1 * z723 +
        z9 * z671;
    const double steer_dot = y[10];
    const bicycle_lanes z747 = steer_dot * z741 + (z746 - k10 * z697 - z23 * z682 + z22 * z701 - z18 * z685 -
        z3 * z707);
    const bicycle_lanes z748 = c_steer * (steer_dot * z733 - (z279 * z463 - z739) + e2z * z707) - s_steer *
        (e2z * z688 + z747);
    bicycle_put(slope + 2 * BICYCLE_LANES, z748);
    const double z345 = kept[296];
    const bicycle_lanes z467 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z475 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z481 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z749 = z277 * z475 + z281 * z481 + z345 * z467 + z45 * z655 + r_R * (z276 * z712 -
        c_roll * z521);
    bicycle_put(slope + 3 * BICYCLE_LANES, c_roll * z464 - (z749 + c1 * z721 + s1 * z727 + e2z * z714));
    const bicycle_lanes z508 = bicycle_get(carried + 86 * BICYCLE_LANES);
    bicycle_put(slope + 4 * BICYCLE_LANES, s_steer * z733 - (z508 + z726 - c_steer * z741));
    const bicycle_lanes z489 = bicycle_get(carried + 78 * BICYCLE_LANES);
    bicycle_put(slope + 5 * BICYCLE_LANES, z719 - z489);
}

BICYCLE_SLOW
int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[331]; /* what parts of this function leave for others */
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
    const bicycle_lanes z5 = z2 * z2 + z4 * z4;
    const bicycle_lanes z6 = 1.0 / bicycle_each_sqrt(BICYCLE_SPREAD(z5));
    const bicycle_lanes z7 = r_F * z4;
    const bicycle_lanes z8 = z6 * z7;
    const bicycle_lanes z9 = k4 + z8;
    const bicycle_lanes z10 = s_steer * z9;
    const bicycle_lanes z11 = s1 * z10;
    const bicycle_lanes z12 = 1.0 / bicycle_size(BICYCLE_SPREAD(c_roll));
    const bicycle_lanes z13 = r_R * z3;
    const bicycle_lanes z14 = z12 * z13;
    const bicycle_lanes z15 = k10 + z14 + c_steer * z9;
    const bicycle_lanes z16 = c_roll * z11 + e2z * z15;
    const bicycle_lanes z17 = r_R * z2;
    const bicycle_lanes z18 = z12 * z17;
    const bicycle_lanes z19 = c_steer * z18;
    const bicycle_lanes z20 = r_F * z2;
    const bicycle_lanes z21 = z6 * z20;
    const bicycle_lanes z22 = k16 + z21;
    const bicycle_lanes z23 = z18 - z22;
    const bicycle_lanes z24 = s_steer * z23;
    const bicycle_lanes z25 = c_steer * z23;
    const bicycle_lanes z26 = s_steer * z18;
    const bicycle_lanes z27 = z19 * z24 - z25 * z26;
    const bicycle_lanes z28 = c_steer * z22;
    const bicycle_lanes z29 = c_steer * k10 + z9;
    const bicycle_lanes z30 = s1 * z28 + c1 * z29;
    const bicycle_lanes z31 = c_roll * z30 + e2z * z24;
    const bicycle_lanes z32 = s_steer * z22;
    const bicycle_lanes z33 = s_steer * k10;
    const bicycle_lanes z34 = s1 * z32 + c1 * z33;
    const bicycle_lanes z35 = c_roll * z34 - e2z * z25;
    const bicycle_lanes z36 = z19 * z31 + z35 * z26;
    const bicycle_lanes z37 = z25 * z31 + z35 * z24;
    const bicycle_lanes z38 = z16 * z27 - z15 * z36 + z14 * z37;
    const bicycle_lanes z39 = k17 * (9.0 + bicycle_size(BICYCLE_SPREAD(z12)));
    /* the coframe is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z38)), 1e-12 * (k22 * ((z39 + k24) * (z39 + k25))));
    const bicycle_lanes z40 = r_R * c_roll;
    const bicycle_lanes z41 = z40 * z12;
    const bicycle_lanes z42 = 1.0 / z38;
    const bicycle_lanes z43 = s_steer * c1;
    const bicycle_lanes z44 = z9 * z43;
    const bicycle_lanes z45 = k10 * s1 + z41;
    const bicycle_lanes z46 = s_steer * z45 - z22 * z43;
    const bicycle_lanes z47 = s1 * z9 + (c_steer * z45 - c1 * z28);
    const bicycle_lanes z48 = z26 * z46 + z19 * z47;
    const bicycle_lanes z49 = z24 * z46 + z25 * z47;
    const bicycle_lanes z50 = z42 * (z27 * z44 + z15 * z48 - z14 * z49);
    const bicycle_lanes z51 = c_roll * z50;
    const bicycle_lanes z52 = s1 + c1 * z51;
    const bicycle_lanes z53 = c1 - s1 * z51;
    const bicycle_lanes z54 = z31 * z46 - z35 * z47;
    const bicycle_lanes z55 = z42 * (z36 * z44 + z16 * z48 - z14 * z54) - e2z * z50;
    const bicycle_lanes z56 = c_steer * z55 + s_steer * z53;
    const bicycle_lanes z57 = z42 * (z37 * z44 + (z16 * z49 - z15 * z54)) - z55;
    const bicycle_lanes z58 = z18 * z57;
    const bicycle_lanes z59 = z41 + k10 * z52;
    const bicycle_lanes z60 = c_steer * z58 - s_steer * z59;
    const bicycle_lanes z61 = z14 * z57;
    const bicycle_lanes z62 = z61 - k10 * z55;
    const bicycle_lanes z63 = k59 * z56 + (k45 * z60 - k48 * z62);
    const bicycle_lanes z64 = z63 + F_yy * z56;
    const bicycle_lanes z65 = k41 * z52 + (z41 * k28 - k40 * z53);
    const bicycle_lanes z66 = c_steer * z59 + s_steer * z58;
    const bicycle_lanes z67 = s_steer * z55 - c_steer * z53;
    const bicycle_lanes z68 = k63 * z52 + (k48 * z66 + k62 * z67);
    const bicycle_lanes z69 = z65 + z68;
    const bicycle_lanes z70 = k56 * z52 + (k45 * z66 + k55 * z67);
    const bicycle_lanes z71 = k43 * z62 - k48 * z56;
    const bicycle_lanes z72 = k48 * z52 + (k43 * z66 + k45 * z67);
    const bicycle_lanes z73 = k43 * z60 + k45 * z56;
    const bicycle_lanes z74 = k37 * z55 + (k27 * z58 - k28 * z61);
    const bicycle_lanes z75 = k26 * z61 - k28 * z55;
    const bicycle_lanes z76 = k26 * z58 + k27 * z55;
    const bicycle_lanes z77 = k35 * z52 + (z41 * k27 - k34 * z53);
    const bicycle_lanes z78 = z60 * z73 + (z55 * z74 + (z61 * z75 + (z58 * z76 - (z53 * z77 - R_yy * (z57 *
        z57)))));
    const bicycle_lanes z79 = z41 * (k28 * z52 + (z41 * k26 - k27 * z53)) + (z56 * z64 + (z52 * z69 + (z67 *
        z70 + (z62 * z71 + (z66 * z72 + z78)))));
    const bicycle_lanes z80 = z19 * z9;
    const bicycle_lanes z81 = z35 * z9;
    const bicycle_lanes z82 = z25 * z9;
    const bicycle_lanes z83 = z42 * (z15 * z80 - z14 * z82);
    const bicycle_lanes z84 = z42 * (z16 * z80 + z14 * z81) - e2z * z83;
    const bicycle_lanes z85 = c_roll * z83;
    const bicycle_lanes z86 = s1 * z85;
    const bicycle_lanes z87 = c_steer * z84 - s_steer * z86;
    const bicycle_lanes z88 = z42 * (z16 * z82 + z15 * z81) - z84;
    const bicycle_lanes z89 = z18 * z88;
    const bicycle_lanes z90 = c1 * z85;
    const bicycle_lanes z91 = k10 * z90;
    const bicycle_lanes z92 = c_steer * z89 - s_steer * z91;
    const bicycle_lanes z93 = z14 * z88;
    const bicycle_lanes z94 = z93 - k10 * z84;
    const bicycle_lanes z95 = k59 * z87 + (k45 * z92 - k48 * z94);
    const bicycle_lanes z96 = 1.0 + z90;
    const bicycle_lanes z97 = c_steer * z91 + s_steer * z89;
    const bicycle_lanes z98 = s_steer * z84 + c_steer * z86;
    const bicycle_lanes z99 = k63 * z96 + (k48 * z97 + k62 * z98);
    const bicycle_lanes z100 = k56 * z96 + (k45 * z97 + k55 * z98);
    const bicycle_lanes z101 = k43 * z94 - k48 * z87;
    const bicycle_lanes z102 = k48 * z96 + (k43 * z97 + k45 * z98);
    const bicycle_lanes z103 = k43 * z92 + k45 * z87;
    const bicycle_lanes z104 = k40 * z86 + k41 * z90;
    const bicycle_lanes z105 = z84 * k37 + (z89 * k27 - z93 * k28);
    const bicycle_lanes z106 = k34 * z86 + k35 * z90;
    const bicycle_lanes z107 = z89 * k26 + z84 * k27;
    const bicycle_lanes z108 = z93 * k26 - z84 * k28;
    const bicycle_lanes z109 = z90 * z104 + (z84 * z105 + (z86 * z106 + (z89 * z107 + (z93 * z108 + R_yy *
        (z88 * z88)))));
    const bicycle_lanes z110 = z87 * (z95 + F_yy * z87) + (z96 * z99 + (z98 * z100 + (z94 * z101 + (z97 *
        z102 + (z92 * z103 + z109)))));
    const bicycle_lanes z111 = z90 * z65 + (z84 * z74 + (z86 * z77 + (z89 * z76 + (z93 * z75 + R_yy * (z88 *
        z57)))));
    const bicycle_lanes z112 = z87 * z64 + (z96 * z68 + (z98 * z70 + (z94 * z71 + (z97 * z72 + (z92 * z73 +
        z111)))));
    const bicycle_lanes z113 = 1.0 / z79;
    const bicycle_lanes z114 = z112 * z113;
    const bicycle_lanes z115 = z110 - z112 * z114;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z115)), 1e-14 * z110);
    const bicycle_lanes z116 = z21 * z26;
    const bicycle_lanes z117 = z21 * z24;
    const bicycle_lanes z118 = z42 * (z8 * z27 - z15 * z116 + z14 * z117);
    const bicycle_lanes z119 = c_roll * z118;
    const bicycle_lanes z120 = c1 * z119;
    const bicycle_lanes z121 = k10 * z120;
    const bicycle_lanes z122 = z21 * z31;
    const bicycle_lanes z123 = z42 * (z16 * z116 - z8 * z36 - z14 * z122) + e2z * z118;
    const bicycle_lanes z124 = z42 * (z16 * z117 - z15 * z122 - z8 * z37) - z123;
    const bicycle_lanes z125 = z18 * z124;
    const bicycle_lanes z126 = c_steer * z121 - s_steer * z125;
    const bicycle_lanes z127 = s1 * z119;
    const bicycle_lanes z128 = s_steer * z123 - c_steer * z127;
    const bicycle_lanes z129 = c_steer * z123 + s_steer * z127;
    const bicycle_lanes z130 = c_steer * z125 + s_steer * z121;
    const bicycle_lanes z131 = z14 * z124;
    const bicycle_lanes z132 = z131 - k10 * z123;
    const bicycle_lanes z133 = z127 * (k34 * z127 + k35 * z120) + (z125 * (z125 * k26 + z123 * k27) + z131 *
        (z131 * k26 - z123 * k28));
    const bicycle_lanes z134 = z120 * (k40 * z127 + k41 * z120) + (z123 * (z123 * k37 + (z125 * k27 - z131 *
        k28)) + z133);
    const bicycle_lanes z135 = z126 * (k48 * z120 + (k43 * z126 - k45 * z128)) + (z130 * (k43 * z130 + k45 *
        z129) + z134);
    const bicycle_lanes z136 = z128 * (k56 * z120 + (k45 * z126 - k55 * z128)) - (z132 * (k43 * z132 - k48 *
        z129) + z135);
    const bicycle_lanes z137 = z120 * (k63 * z120 + (k48 * z126 - k62 * z128)) + (z129 * (k59 * z129 + (k45 *
        z130 - k48 * z132)) - z136);
    const bicycle_lanes z138 = 1.0 - z129;
    const bicycle_lanes z139 = z137 + R_yy * (z124 * z124) + F_yy * (z138 * z138);
    const bicycle_lanes z140 = R_yy * z124;
    const bicycle_lanes z141 = F_yy * z138;
    const bicycle_lanes z142 = z123 * z74 - (z127 * z77 - (z125 * z76 + (z131 * z75 + (z140 * z57 - z141 *
        z56))));
    const bicycle_lanes z143 = z120 * z69 - (z129 * z63 + (z128 * z70 + (z132 * z71 - (z126 * z72 - (z130 *
        z73 + z142)))));
    const bicycle_lanes z144 = z143 * z113;
    const bicycle_lanes z145 = z127 * z106 - (z125 * z107 + (z131 * z108 + (z88 * z140 - z87 * z141 + z112 *
        z144)));
    const bicycle_lanes z146 = z129 * z95 + (z128 * z100 + (z132 * z101 - (z126 * z102 - (z130 * z103 + (z123
        * z105 - z145)))));
    const bicycle_lanes z147 = z120 * (z104 + z99) - z146;
    const bicycle_lanes z148 = 1.0 / z115;
    const bicycle_lanes z149 = z147 * z148;
    const bicycle_lanes z150 = z139 - z143 * z144 - z147 * z149;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z150)), 1e-14 * z139);
    bicycle_lanes sine4, cosine4;
    bicycle_turn_lanes(BICYCLE_SPREAD(yaw), &far, &sine4, &cosine4);
    const bicycle_lanes c_yaw = cosine4;
    const bicycle_lanes z151 = roll_dot * c1;
    const bicycle_lanes z152 = s_steer * z151;
    const bicycle_lanes z153 = thF_dot - z152;
    const bicycle_lanes z154 = k4 * z152 - z8 * z153;
    const bicycle_lanes z155 = roll_dot * r_R;
    const bicycle_lanes z156 = c_roll * z155;
    const bicycle_lanes z157 = z12 * z156;
    const bicycle_lanes z158 = roll_dot * s1;
    const bicycle_lanes z159 = z157 + k10 * z158;
    const bicycle_lanes z160 = z21 * z153 - (k16 * z152 - s_steer * z159);
    const bicycle_lanes z161 = steer_dot + z158;
    const bicycle_lanes z162 = c_steer * z151;
    const bicycle_lanes z163 = z161 * z9 + (c_steer * z159 - z22 * z162);
    const bicycle_lanes z164 = z24 * z160 + z25 * z163;
    const bicycle_lanes z165 = z31 * z160 - z35 * z163;
    const bicycle_lanes z166 = z42 * (z37 * z154 + (z16 * z164 - z15 * z165));
    const bicycle_lanes z167 = z26 * z160 + z19 * z163;
    const bicycle_lanes z168 = z42 * (z36 * z154 + z16 * z167 - z14 * z165);
    const bicycle_lanes z169 = z42 * (z27 * z154 + z15 * z167 - z14 * z164);
    const bicycle_lanes z170 = z168 - e2z * z169;
    const bicycle_lanes z171 = z166 - z170;
    const bicycle_lanes z172 = z14 * z171;
    const bicycle_lanes z173 = z18 * z171;
    const bicycle_lanes z174 = s1 * z172 + c1 * z173;
    const bicycle_lanes s_yaw = sine4;
    const bicycle_lanes z175 = s1 * z173 - c1 * z172;
    const bicycle_lanes z176 = c_roll * z157 - e2z * z175;
    const bicycle_lanes z177 = c1 * z168;
    const bicycle_lanes z178 = roll_dot * z177;
    const bicycle_lanes z179 = c_roll * z169;
    const bicycle_lanes z180 = s1 * z168;
    const bicycle_lanes z181 = roll_dot * e2z;
    const bicycle_lanes z182 = steer_dot * c_steer;
    const bicycle_lanes z183 = z181 * c1 - c_roll * z180;
    const bicycle_lanes z184 = roll_dot * c_roll;
    const bicycle_lanes z185 = steer_dot * s_steer;
    const bicycle_lanes z186 = z181 * s1 + c_roll * z177;
    const bicycle_lanes z187 = s_steer * z184 + e2z * z182 + (z185 * z3 + c_steer * z186);
    const bicycle_lanes z188 = (z2 * z183 - z4 * z187) * (z6 * (z6 * z6));
    const bicycle_lanes z189 = r_F * z6;
    const bicycle_lanes z190 = z7 * z188 + z189 * z187;
    const bicycle_lanes z191 = z181 * z12;
    const bicycle_lanes z192 = z191 / c_roll;
    const bicycle_lanes z193 = r_R * z12;
    const bicycle_lanes z194 = z13 * z192 - z186 * z193;
    const bicycle_lanes z195 = z194 - (z185 * z9 - c_steer * z190);
    const bicycle_lanes z196 = c_roll * (z10 * z177 - s1 * (z182 * z9 + s_steer * z190)) + (z181 * z11 -
        (z184 * z15 + e2z * z195));
    const bicycle_lanes z197 = roll_dot * z180;
    const bicycle_lanes z198 = z182 * z151 + s_steer * z197;
    const bicycle_lanes z199 = z169 * z196 + (z9 * z198 - (z166 * z194 + (z153 * z190 - z168 * z195)));
    const bicycle_lanes z200 = z20 * z188 - z189 * z183;
    const bicycle_lanes z201 = s1 * (z185 * z22 - c_steer * z200) + (z28 * z177 - z29 * z180 + c1 * (z185 *
        k10 - z190));
    const bicycle_lanes z202 = z17 * z192 - z183 * z193;
    const bicycle_lanes z203 = z202 - z200;
    const bicycle_lanes z204 = z182 * z23 + s_steer * z203;
    const bicycle_lanes z205 = k10 * z178 - (z156 * z192 - z155 * z191);
    const bicycle_lanes z206 = z22 * (z185 * z151 - c_steer * z197) - (z162 * z200 + (z185 * z159 - (z161 *
        z190 - (c_steer * z205 + z168 * z204))));
    const bicycle_lanes z207 = z169 * (c_roll * z201 + (z181 * z30 - (z184 * z24 + e2z * z204))) - (z166 *
        (z182 * z18 + s_steer * z202) - (z9 * z178 - z206));
    const bicycle_lanes z208 = s1 * (z182 * z22 + s_steer * z200) - (z32 * z177 - (z33 * z180 + k10 * (z182 *
        c1)));
    const bicycle_lanes z209 = z185 * z23 - c_steer * z203;
    const bicycle_lanes z210 = z166 * (z185 * z18 - c_steer * z202) - (z22 * z198 - (z153 * z200 + (z182 *
        z159 - (s_steer * z205 + z168 * z209))));
    const bicycle_lanes z211 = z169 * (c_roll * z208 - (z181 * z34 + (z184 * z25 - e2z * z209))) + z210;
    const bicycle_lanes z212 = z19 * z207 - z26 * z211;
    const bicycle_lanes z213 = z25 * z207 - z24 * z211;
    const bicycle_lanes z214 = z42 * (z27 * z199 - z15 * z212 + z14 * z213);
    const bicycle_lanes z215 = z181 * z169 - c_roll * z214;
    const bicycle_lanes z216 = z178 - (z179 * z180 - c1 * z215);
    const bicycle_lanes z217 = z158 + c1 * z179;
    const bicycle_lanes z218 = z151 - s1 * z179;
    const bicycle_lanes z219 = z173 * z217 - z172 * z218 + roll_dot * (z181 * z193 - z40 * z192);
    const bicycle_lanes z220 = k27 * z170;
    const bicycle_lanes z221 = k28 * z170;
    const bicycle_lanes z222 = z197 + (z179 * z177 + s1 * z215);
    const bicycle_lanes z223 = k28 * z216 + (k26 * z219 + (z217 * z220 + (e2z * k67 + z218 * z221) + k27 *
        z222));
    const bicycle_lanes z224 = z31 * z211 + z35 * z207;
    const bicycle_lanes z225 = z42 * (z16 * z212 - z36 * z199 + z14 * z224) + (z184 * z169 + e2z * z214);
    const bicycle_lanes z226 = z185 * z170 + c_steer * z225 - (z182 * z218 + s_steer * z222);
    const bicycle_lanes z227 = k10 * z170;
    const bicycle_lanes z228 = k10 * z217;
    const bicycle_lanes v2_x = roll_dot * z41;
    const bicycle_lanes z229 = z42 * (z16 * z213 + z15 * z224 - z37 * z199) - z225;
    const bicycle_lanes z230 = z170 * z172 - v2_x * z217 - (z171 * z202 - z18 * z229);
    const bicycle_lanes z231 = z170 * z227 + z217 * z228 - z230;
    const bicycle_lanes z232 = z219 + (z227 * z218 + k10 * z216);
    const bicycle_lanes z233 = c_steer * z231 + s_steer * z232;
    const bicycle_lanes w3_steer = steer_dot + z217;
    const bicycle_lanes z234 = s_steer * z170 - c_steer * z218;
    const bicycle_lanes z235 = k55 * z234 + k56 * w3_steer;
    const bicycle_lanes z236 = k62 * z234 + k63 * w3_steer;
    const bicycle_lanes z237 = v2_x * z218 - z170 * z173 - (z171 * z194 - z14 * z229);
    const bicycle_lanes z238 = z237 + (z218 * z228 - k10 * z225);
    const bicycle_lanes z239 = z4 * k71 - (k59 * z226 - (k45 * z233 + (w3_steer * z235 - z234 * z236 + k48 *
        z238)));
    const bicycle_lanes z240 = z2 * k72 + z239;
    const bicycle_lanes z241 = F_yy * z226;
    const bicycle_lanes z242 = z240 - z241;
    const bicycle_lanes z243 = R_yy * z171 - k37 * z170;
    const bicycle_lanes z244 = k34 * z218 - k35 * z217;
    const bicycle_lanes z245 = e2z * k68 - (z218 * z243 + z170 * z244 - (k41 * z216 + (k28 * z219 + k40 *
        z222)));
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z3;
    const bicycle_lanes z246 = c_steer * z170 + s_steer * z218;
    const bicycle_lanes z247 = F_yy * (thF_dot - z246) - k59 * z246;
    const bicycle_lanes z248 = c_steer * z232 - s_steer * z231;
    const bicycle_lanes z249 = z182 * z170 - s_steer * z225 + (z185 * z218 - c_steer * z222);
    const bicycle_lanes z250 = h2z * k72 - (z234 * z247 + z246 * z235 + (k63 * z216 + (k48 * z248 - k62 *
        z249)));
    const bicycle_lanes z251 = z245 - z250;
    const bicycle_lanes z252 = h2z * k71 - (z246 * z236 + w3_steer * z247 - (k56 * z216 + (k45 * z248 - k55 *
        z249)));
    const bicycle_lanes z253 = k45 * z234 + k48 * w3_steer;
    const bicycle_lanes z254 = k45 * z246;
    const bicycle_lanes z255 = z2 * k70 + (z234 * z253 + z246 * z254 - (k43 * z238 - k48 * z226));
    const bicycle_lanes z256 = k48 * z246;
    const bicycle_lanes z257 = h2z * k70 + (w3_steer * z254 - z234 * z256 + (k48 * z216 + (k43 * z248 - k45 *
        z249)));
    const bicycle_lanes z258 = z4 * k70 + (z246 * z256 + w3_steer * z253 + (k43 * z233 - k45 * z226));
    const bicycle_lanes z259 = k40 * z218 - k41 * z217;
    const bicycle_lanes z260 = z3 * k69 + z2 * k68 + (z217 * z244 + z218 * z259 + (k37 * z225 + (k27 * z230 -
        k28 * z237)));
    const bicycle_lanes z261 = e2z * k69 + (z170 * z259 - z217 * z243 + (k35 * z216 + (k27 * z219 + k34 *
        z222)));
    const bicycle_lanes z262 = k27 * z218 - k28 * z217;
    const bicycle_lanes z263 = z2 * k67 + (z218 * z262 + z170 * z220 - (k26 * z237 - k28 * z225));
    const bicycle_lanes z264 = z3 * k67 - (z170 * z221 - z217 * z262 - (k26 * z230 + k27 * z225));
    const bicycle_lanes z265 = R_yy * z229;
    const bicycle_lanes z266 = z60 * z258 - (z55 * z260 - (z53 * z261 + (z61 * z263 - (z58 * z264 + z57 *
        z265))));
    const bicycle_lanes z267 = z41 * z223 - (z56 * z242 - (z52 * z251 + (z67 * z252 - (z62 * z255 - (z66 *
        z257 - z266)))));
    const bicycle_lanes z268 = z84 * z260 + (z86 * z261 + (z89 * z264 - (z93 * z263 + (z267 * z114 - z88 *
        z265))));
    const bicycle_lanes z269 = z96 * z250 - (z98 * z252 - (z94 * z255 - (z97 * z257 - (z92 * z258 - (z90 *
        z245 + z268)))));
    const bicycle_lanes z270 = z87 * z242 + z269;
    const bicycle_lanes z271 = z125 * z264 - (z131 * z263 - (z267 * z144 - (z149 * z270 - (z124 * z265 - z138
        * z241))));
    const bicycle_lanes z272 = z128 * z252 - (z132 * z255 + (z126 * z257 + (z130 * z258 - (z123 * z260 -
        (z127 * z261 - z271)))));
    const bicycle_lanes z273 = (z120 * z251 + (z129 * z240 - z272)) / z150;
    const bicycle_lanes z274 = z148 * z270 + z149 * z273;
    /* (I.2.15) */
    const bicycle_lanes slope1 = -(c_yaw * z174 + s_yaw * z176);
    sum += slope1;
    bicycle_put(dydt, slope1);
    const bicycle_lanes slope2 = c_yaw * z176 - s_yaw * z174;
    sum += slope2;
    bicycle_put(dydt + 1 * stride, slope2);
    const bicycle_lanes slope3 = e2z * z157 + c_roll * z175;
    sum += slope3;
    bicycle_put(dydt + 2 * stride, slope3);
    const bicycle_lanes slope4 = z169;
    bicycle_put(dydt + 3 * stride, slope4);
    const bicycle_lanes slope5 = roll_dot;
    bicycle_put(dydt + 4 * stride, slope5);
    const bicycle_lanes slope6 = -z168;
    bicycle_put(dydt + 5 * stride, slope6);
    const bicycle_lanes slope7 = steer_dot;
    bicycle_put(dydt + 6 * stride, slope7);
    const bicycle_lanes slope8 = z166;
    bicycle_put(dydt + 7 * stride, slope8);
    const bicycle_lanes slope9 = thF_dot;
    bicycle_put(dydt + 8 * stride, slope9);
    /* (I.2.15) 112:4 */
    const bicycle_lanes slope10 = z267 * z113 + z114 * z274 - z144 * z273;
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = -z274;
    sum += slope11;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = -z273;
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
