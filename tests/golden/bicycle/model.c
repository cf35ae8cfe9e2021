/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:25d595404c02eb4c)
 * Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x ahead, y right, z down.
 * Source: bicycle.yaml
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with roll', steer', thR': the dependent velocities of the spec (x', y', z',
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
    "thR'"
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

/* the status of a block that does not exceed its bound: it is singular, or no number */
static int bicycle_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : BICYCLE_NOT_FINITE;
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
    const double thR_dot = y[11];
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
    const double k38 = k36 + (c_lam * (k31 + c_lam * k8) + s_lam * (k29 + s_lam * k7));
    const double k39 = m_F * k16;
    const double k40 = m_H + m_F;
    const double k41 = m_H * k15;
    const double k42 = k39 + k41;
    const double k43 = m_F * k4;
    const double k44 = m_H * k9;
    const double k45 = k43 - k44;
    const double k46 = H_xz * c_lam;
    const double k47 = s_lam * k5 - k46;
    const double k48 = H_xz * s_lam;
    const double k49 = c_lam * k6 - k48;
    const double k50 = k16 * k39;
    const double k51 = k15 * k41;
    const double k52 = s_lam * k47 + c_lam * k49 + k50 + k51;
    const double k53 = c_lam * k47 - s_lam * k49 + k4 * k39 - k9 * k41;
    const double k54 = k4 * k43;
    const double k55 = k9 * k44;
    const double k56 = k51 + (k50 + (H_yy + k54) + k55);
    const double k57 = k55 + (k54 + (c_lam * (k48 + c_lam * k5) + s_lam * (k46 + s_lam * k6)));
    const double k58 = g * m_F;
    const double k59 = g * m_H;
    const double k60 = g * m_B;
    const double k61 = g * k26;
    const double k62 = k12 * k60;
    const double k63 = k11 * k60;
    const double k64 = g * k40;
    const double k65 = k15 * k59 + k16 * k58;
    const double k66 = k9 * k59 - k4 * k58;

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
    const double z14 = k10 + z13;
    const double z15 = z14 + c_steer * z8;
    const double z16 = c_roll * z10 + e2z * z15;
    const double z17 = r_F * z2;
    const double z18 = z5 * z17;
    const double z19 = r_R * z2;
    const double z20 = z11 * z19;
    const double z21 = k16 + z18;
    const double z22 = z20 - z21;
    const double z23 = s_steer * z22;
    const double z24 = z18 * z23;
    const double z25 = c_steer * z21;
    const double z26 = c_steer * k10 + z8;
    const double z27 = s1 * z25 + c1 * z26;
    const double z28 = c_roll * z27 + e2z * z23;
    const double z29 = z18 * z28;
    const double z30 = c_steer * z22;
    const double z31 = s_steer * z21;
    const double z32 = s_steer * k10;
    const double z33 = s1 * z31 + c1 * z32;
    const double z34 = c_roll * z33 - e2z * z30;
    const double z35 = z30 * z28 + z34 * z23;
    const double z36 = z16 * z24 - z15 * z29 - z7 * z35;
    const double z37 = k17 * (9.0 + fabs(z11));
    const double z38 = r_R * z11;
    const double z39 = c_roll * z38;
    const double z40 = 1.0 / z36;
    const double z41 = s_steer * c1;
    const double z42 = z8 * z41;
    const double z43 = k10 * s1 + z39;
    const double z44 = s1 * z8 + (c_steer * z43 - c1 * z25);
    const double z45 = z18 * z44;
    const double z46 = z21 * z41 - s_steer * z43;
    const double z47 = z40 * (z24 * z42 + z15 * z45 + z7 * (z30 * z44 - z23 * z46));
    const double z48 = c_roll * z47;
    const double z49 = s1 + c1 * z48;
    const double z50 = c1 - s1 * z48;
    const double z51 = z40 * (z29 * z42 + z16 * z45 - z7 * (z28 * z46 + z34 * z44)) - e2z * z47;
    const double z52 = z20 * z51;
    const double z53 = z13 * z51;
    const double z54 = k37 * z51 - (k27 * z52 - k28 * z53);
    const double z55 = z54 + R_yy * z51;
    const double z56 = k38 * z49 + (k28 * z39 - k35 * z50);
    const double z57 = z39 + k10 * z49;
    const double z58 = c_steer * z57 - s_steer * z52;
    const double z59 = s_steer * z51 - c_steer * z50;
    const double z60 = k57 * z49 + (k45 * z58 + k53 * z59);
    const double z61 = z56 + z60;
    const double z62 = c_steer * z51 + s_steer * z50;
    const double z63 = c_steer * z52 + s_steer * z57;
    const double z64 = z14 * z51;
    const double z65 = k56 * z62 - (k42 * z63 - k45 * z64);
    const double z66 = k53 * z49 + (k42 * z58 + k52 * z59);
    const double z67 = k40 * z64 + k45 * z62;
    const double z68 = k45 * z49 + (k40 * z58 + k42 * z59);
    const double z69 = k40 * z63 - k42 * z62;
    const double z70 = k26 * z53 + k28 * z51;
    const double z71 = k26 * z52 - k27 * z51;
    const double z72 = k35 * z49 + (k27 * z39 - k34 * z50);
    const double z73 = z58 * z68 + (z63 * z69 + (z53 * z70 + (z52 * z71 - (z50 * z72 - F_yy * (z62 * z62)))));
    const double z74 = z39 * (k28 * z49 + (k26 * z39 - k27 * z50)) + (z51 * z55 + (z49 * z61 + (z62 * z65 +
        (z59 * z66 + (z64 * z67 + z73)))));
    const double z75 = z18 * z8;
    const double z76 = z34 * z8;
    const double z77 = z30 * z8;
    const double z78 = z40 * (z15 * z75 + z7 * z77);
    const double z79 = z40 * (z16 * z75 - z7 * z76) - e2z * z78;
    const double z80 = z20 * z79;
    const double z81 = z13 * z79;
    const double z82 = z79 * k37 - (z80 * k27 - z81 * k28);
    const double z83 = c_roll * z78;
    const double z84 = c1 * z83;
    const double z85 = 1.0 + z84;
    const double z86 = k10 * z84;
    const double z87 = c_steer * z86 - s_steer * z80;
    const double z88 = s1 * z83;
    const double z89 = s_steer * z79 + c_steer * z88;
    const double z90 = k57 * z85 + (k45 * z87 + k53 * z89);
    const double z91 = c_steer * z79 - s_steer * z88;
    const double z92 = c_steer * z80 + s_steer * z86;
    const double z93 = z14 * z79;
    const double z94 = k56 * z91 - (k42 * z92 - k45 * z93);
    const double z95 = k53 * z85 + (k42 * z87 + k52 * z89);
    const double z96 = k40 * z93 + k45 * z91;
    const double z97 = k45 * z85 + (k40 * z87 + k42 * z89);
    const double z98 = k40 * z92 - k42 * z91;
    const double z99 = k34 * z88 + k35 * z84;
    const double z100 = z80 * k26 - z79 * k27;
    const double z101 = z81 * k26 + z79 * k28;
    const double z102 = z40 * (z16 * z77 + z15 * z76) + z91;
    const double z103 = k38 * z84 + k35 * z88;
    const double z104 = z92 * z98 + (z88 * z99 + (z80 * z100 + (z81 * z101 + F_yy * (z102 * z102))) + z84 *
        z103);
    const double z105 = z79 * (z82 + R_yy * z79) + (z85 * z90 + (z91 * z94 + (z89 * z95 + (z93 * z96 + (z87 *
        z97 + z104)))));
    const double z106 = z92 * z69 + (z84 * z56 + (z88 * z72 + (z80 * z71 + (z81 * z70 + F_yy * (z102 *
        z62)))));
    const double z107 = z79 * z55 + (z85 * z60 + (z91 * z65 + (z89 * z66 + (z93 * z67 + (z87 * z68 +
        z106)))));
    const double z108 = 1.0 / z74;
    const double z109 = z107 * z108;
    const double z110 = z105 - z107 * z109;
    const double z111 = s_steer * z20;
    const double z112 = z40 * (z13 * z24 - z15 * (z18 * z111));
    const double z113 = c_roll * z112;
    const double z114 = c1 * z113;
    const double z115 = k10 * z114;
    const double z116 = e2z * z112;
    const double z117 = 1.0 - z116;
    const double z118 = z20 * z117;
    const double z119 = c_steer * z115 - s_steer * z118;
    const double z120 = s1 * z113;
    const double z121 = s_steer * z116 - c_steer * z120;
    const double z122 = c_steer * z116 + s_steer * z120;
    const double z123 = c_steer * z118 + s_steer * z115;
    const double z124 = z13 * z117;
    const double z125 = z124 - k10 * z116;
    const double z126 = z120 * (k34 * z120 + k35 * z114) + (z118 * (k26 * z118 + k27 * z116) + z124 * (k26 *
        z124 - k28 * z116));
    const double z127 = z114 * (k35 * z120 + k38 * z114) + (z116 * (k37 * z116 + (k27 * z118 - k28 * z124)) +
        z126);
    const double z128 = z119 * (k45 * z114 + (k40 * z119 - k42 * z121)) + (z123 * (k40 * z123 + k42 * z122) +
        z127);
    const double z129 = z121 * (k53 * z114 + (k42 * z119 - k52 * z121)) - (z125 * (k40 * z125 - k45 * z122) +
        z128);
    const double z130 = z114 * (k57 * z114 + (k45 * z119 - k53 * z121)) + (z122 * (k56 * z122 + (k42 * z123 -
        k45 * z125)) - z129);
    const double z131 = z40 * (z15 * (c_steer * z20 * z28 + z34 * z111) - z13 * z35) + z122;
    const double z132 = z130 + R_yy * (z117 * z117) + F_yy * (z131 * z131);
    const double z133 = F_yy * z131;
    const double z134 = R_yy * z117;
    const double z135 = z116 * z54 - (z120 * z72 + (z118 * z71 + (z124 * z70 - (z133 * z62 - z134 * z51))));
    const double z136 = z114 * z61 - (z122 * z65 + (z121 * z66 - (z125 * z67 + (z119 * z68 + (z123 * z69 -
        z135)))));
    const double z137 = z136 * z108;
    const double z138 = z99 * z120 + (z100 * z118 + (z101 * z124 + (z79 * z134 - z102 * z133 - z107 * z137)));
    const double z139 = z94 * z122 + (z95 * z121 - (z96 * z125 + (z97 * z119 + (z98 * z123 - (z82 * z116 -
        z138)))));
    const double z140 = z114 * (z103 + z90) - z139;
    const double z141 = 1.0 / z110;
    const double z142 = z140 * z141;
    const double z143 = z132 - z136 * z137 - z140 * z142;
    const double z144 = roll_dot * c1;
    const double z145 = s_steer * z144;
    const double z146 = thR_dot * z13 - z8 * z145;
    const double z147 = roll_dot * s1;
    const double z148 = steer_dot + z147;
    const double z149 = c_steer * z144;
    const double z150 = thR_dot * z20;
    const double v2_x = roll_dot * z39;
    const double z151 = k10 * z147 + v2_x;
    const double z152 = z148 * z8 - (z21 * z149 - (s_steer * z150 + c_steer * z151));
    const double z153 = z18 * z152;
    const double z154 = z21 * z145 + (c_steer * z150 - s_steer * z151);
    const double z155 = z28 * z154 + z34 * z152;
    const double z156 = z40 * (z29 * z146 - z16 * z153 + z7 * z155);
    const double z157 = z30 * z152 - z23 * z154;
    const double z158 = z40 * (z24 * z146 - z15 * z153 - z7 * z157);
    const double w2 = z156 - e2z * z158;
    const double z159 = thR_dot + w2;
    const double z160 = z13 * z159;
    const double z161 = z20 * z159;
    const double z162 = s1 * z160 + c1 * z161;
    const double z163 = c_roll * v2_x;
    const double z164 = z40 * (z35 * z146 - (z16 * z157 + z15 * z155));
    const double z165 = c1 * z156;
    const double z166 = roll_dot * z165;
    const double z167 = c_roll * z158;
    const double z168 = s1 * z156;
    const double z169 = roll_dot * e2z;
    const double z170 = steer_dot * c_steer;
    const double z171 = z169 * c1 + c_roll * z168;
    const double z172 = roll_dot * c_roll;
    const double z173 = steer_dot * s_steer;
    const double z174 = z169 * s1 - c_roll * z165;
    const double z175 = s_steer * z172 + e2z * z170 + (z173 * z3 + c_steer * z174);
    const double z176 = (z2 * z171 - z4 * z175) * (z5 * (z5 * z5));
    const double z177 = r_F * z5;
    const double z178 = z6 * z176 + z177 * z175;
    const double z179 = z11 * (c_roll * z169) * (z11 * z11);
    const double z180 = z12 * z179 - z38 * z174;
    const double z181 = z180 - (z173 * z8 - c_steer * z178);
    const double z182 = c_roll * (z9 * z165 + s1 * (z170 * z8 + s_steer * z178)) - (z169 * z10 - (z172 * z15
        + e2z * z181));
    const double z183 = z145 - z164;
    const double z184 = roll_dot * z168;
    const double z185 = z170 * z144 - s_steer * z184;
    const double z186 = z158 * z182 + (z178 * z183 + (z8 * z185 - (thR_dot * z180 + z156 * z181)));
    const double z187 = z17 * z176 - z177 * z171;
    const double z188 = s1 * (z173 * z21 - c_steer * z187) + (c1 * (z173 * k10 - z178) - (z25 * z165 - z26 *
        z168));
    const double z189 = z19 * z179 - z38 * z171;
    const double z190 = z189 - z187;
    const double z191 = z170 * z22 + s_steer * z190;
    const double z192 = thR_dot * z189;
    const double z193 = k10 * z166;
    const double z194 = z149 * z187 + (z173 * z151 - (z148 * z178 + (z156 * z191 + (s_steer * z192 + c_steer
        * z193))));
    const double z195 = z158 * (c_roll * z188 + (z169 * z27 - (z172 * z23 + e2z * z191))) + (z8 * z166 + (z21
        * (z173 * z144 + c_steer * z184) + (z170 * z150 - z194)));
    const double z196 = z18 * z195;
    const double z197 = s1 * (z170 * z21 + s_steer * z187) + (z31 * z165 - (z32 * z168 - k10 * (z170 * c1)));
    const double z198 = z173 * z22 - c_steer * z190;
    const double z199 = z21 * z185 - (z173 * z150 + (z170 * z151 + (z156 * z198 - (c_steer * z192 - s_steer *
        z193))));
    const double z200 = z158 * (c_roll * z197 - (z169 * z33 + (z172 * z30 - e2z * z198))) + (z187 * z183 +
        z199);
    const double z201 = z30 * z195 - z23 * z200;
    const double z202 = z40 * (z24 * z186 + z15 * z196 + z7 * z201);
    const double z203 = z169 * z158 + c_roll * z202;
    const double z204 = z166 + (z167 * z168 + c1 * z203);
    const double z205 = z147 - c1 * z167;
    const double z206 = z144 + s1 * z167;
    const double z207 = z161 * z205 - z160 * z206;
    const double z208 = k27 * w2;
    const double z209 = k28 * w2;
    const double z210 = z184 - (z167 * z165 - s1 * z203);
    const double z211 = k28 * z204 - (k26 * z207 - (z205 * z208 - (e2z * k61 - z206 * z209) + k27 * z210));
    const double z212 = z28 * z200 + z34 * z195;
    const double z213 = z40 * (z29 * z186 + z16 * z196 - z7 * z212) + (z172 * z158 - e2z * z202);
    const double z214 = z159 * z189 - z20 * z213 + (w2 * z160 + v2_x * z205);
    const double z215 = z159 * z180 - z13 * z213 - (w2 * z161 + v2_x * z206);
    const double z216 = k34 * z206 - k35 * z205;
    const double z217 = k38 * z205 - k35 * z206;
    const double z218 = z3 * k63 + z2 * k62 - (k37 * z213 + (k27 * z214 - k28 * z215) - (z205 * z216 - z206 *
        z217));
    const double z219 = R_yy * z213;
    const double z220 = z218 - z219;
    const double z221 = R_yy * z159 + k37 * w2;
    const double z222 = e2z * k62 - (z206 * z221 - w2 * z216 + (k38 * z204 - (k28 * z207 - k35 * z210)));
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z223 = s_steer * w2 + c_steer * z206;
    const double z224 = c_steer * w2 - s_steer * z206;
    const double z225 = F_yy * (z164 + z224) + k56 * z224;
    const double w3_steer = steer_dot + z205;
    const double z226 = k52 * z223 - k53 * w3_steer;
    const double z227 = k10 * w2;
    const double z228 = z207 - (z227 * z206 + k10 * z204);
    const double z229 = k10 * z205;
    const double z230 = w2 * z227 + z205 * z229 + z214;
    const double z231 = c_steer * z228 - s_steer * z230;
    const double z232 = z170 * w2 - s_steer * z213 - (z173 * z206 + c_steer * z210);
    const double z233 = h2z * k66 + (z223 * z225 - z224 * z226 + (k57 * z204 - (k45 * z231 + k53 * z232)));
    const double z234 = z222 - z233;
    const double z235 = z173 * w2 + c_steer * z213 + (z170 * z206 - s_steer * z210);
    const double z236 = c_steer * z230 + s_steer * z228;
    const double z237 = z215 - (z206 * z229 + k10 * z213);
    const double z238 = k57 * w3_steer - k53 * z223;
    const double z239 = z4 * k65 + (k56 * z235 + (k42 * z236 - (k45 * z237 + (w3_steer * z226 - z223 *
        z238))));
    const double z240 = z2 * k66 + z239;
    const double z241 = h2z * k65 - (k53 * z204 - (k42 * z231 + k52 * z232) + (w3_steer * z225 - z224 *
        z238));
    const double z242 = k42 * z223 - k45 * w3_steer;
    const double z243 = k42 * z224;
    const double z244 = z2 * k64 + (z223 * z242 + z224 * z243 + (k40 * z237 - k45 * z235));
    const double z245 = k45 * z224;
    const double z246 = h2z * k64 - (w3_steer * z243 + z223 * z245 + (k45 * z204 - (k40 * z231 + k42 *
        z232)));
    const double z247 = z4 * k64 + (z224 * z245 - w3_steer * z242 + (k40 * z236 + k42 * z235));
    const double z248 = e2z * k63 - (k35 * z204 - (k27 * z207 - k34 * z210) + (z205 * z221 - w2 * z217));
    const double z249 = k27 * z206 - k28 * z205;
    const double z250 = z2 * k61 + (z206 * z249 + w2 * z208 + (k26 * z215 - k28 * z213));
    const double z251 = z3 * k61 - (w2 * z209 - z205 * z249 + (k26 * z214 + k27 * z213));
    const double z252 = F_yy * (z40 * (z35 * z186 + (z16 * z201 + z15 * z212)) + z235);
    const double z253 = z58 * z246 + (z63 * z247 - (z50 * z248 - (z53 * z250 - (z52 * z251 + z62 * z252))));
    const double z254 = z39 * z211 - (z51 * z220 + (z49 * z234 - (z62 * z240 - (z59 * z241 + (z64 * z244 +
        z253)))));
    const double z255 = z84 * z222 + (z88 * z248 - (z80 * z251 - (z81 * z250 + (z254 * z109 - z102 * z252))));
    const double z256 = z85 * z233 + (z91 * z240 - (z89 * z241 + (z93 * z244 + (z87 * z246 + (z92 * z247 +
        z255)))));
    const double z257 = z79 * z220 - z256;
    const double z258 = z118 * z251 - (z124 * z250 + (z254 * z137 - (z142 * z257 + (z117 * z219 - z131 *
        z252))));
    const double z259 = z121 * z241 - (z125 * z244 + (z119 * z246 + (z123 * z247 - (z116 * z218 - (z120 *
        z248 - z258)))));
    const double z260 = (z114 * z234 + (z122 * z240 - z259)) / z143;
    const double z261 = z141 * z257 - z142 * z260;
    /* (I.2.15) */
    dydt[0] = -(c_yaw * z162 + s_yaw * z163); /* x' */
    dydt[1] = c_yaw * z163 - s_yaw * z162; /* y' */
    dydt[2] = e2z * v2_x; /* z' */
    dydt[3] = -z158; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = z156; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = thR_dot; /* thR' */
    dydt[8] = z164; /* thF' */
    /* (I.2.15) 112:4 */
    dydt[9] = -(z254 * z108 + z109 * z261 + z137 * z260); /* roll'' */
    dydt[10] = z261; /* steer'' */
    dydt[11] = -z260; /* thR'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[9] + dydt[11]) <= DBL_MAX
        && fabs(z36) > 1e-15 * (k22 * ((z37 + k24) * (z37 + k25)))
        && fabs(z110) > 1e-14 * z105
        && fabs(z143) > 1e-14 * z132)) {
        /* the coframe is singular */
        if (!(fabs(z36) > 1e-15 * (k22 * ((z37 + k24) * (z37 + k25))))) {
            return bicycle_refuse(fabs(z36), 1e-15 * (k22 * ((z37 + k24) * (z37 + k25))), BICYCLE_SINGULAR_1);
        }
        /* the mass matrix is singular */
        if (!(fabs(z74) > 0.0)) {
            return bicycle_refuse(fabs(z74), 0.0, BICYCLE_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z110) > 1e-14 * z105)) {
            return bicycle_refuse(fabs(z110), 1e-14 * z105, BICYCLE_SINGULAR_2);
        }
        /* the mass matrix is singular */
        if (!(fabs(z143) > 1e-14 * z132)) {
            return bicycle_refuse(fabs(z143), 1e-14 * z132, BICYCLE_SINGULAR_2);
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
    const double thR_dot = y[11];
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
    const double z13 = z4 * z5;
    const double z14 = z4 * z9;
    const double z15 = k4 + z13;
    const double z16 = z14 - z15;
    const double z17 = s_steer * z16;
    const double z18 = z13 * z17;
    const double z19 = s1 * z15;
    const double z20 = c_roll * (c_steer * z19 + c1 * (c_steer * k3 + z7)) + e2z * z17;
    const double z21 = z13 * z20;
    const double z22 = c_steer * z16;
    const double z23 = c_roll * (s_steer * z19 + k3 * (s_steer * c1)) - e2z * z22;
    const double z24 = z22 * z20 + z23 * z17;
    const double z25 = z12 * z18 - z11 * z21 - z6 * z24;
    const double z26 = k5 * (9.0 + fabs(z8));
    const double z27 = 1.0 / z25;
    const double z28 = roll_dot * s1;
    const double z29 = steer_dot + z28;
    const double z30 = roll_dot * c1;
    const double z31 = c_steer * z30;
    const double z32 = thR_dot * z14;
    const double v2_x = c_roll * (roll_dot * z9);
    const double z33 = k3 * z28 + v2_x;
    const double z34 = z29 * z6 - z31 * z13 - (k4 * z31 - k2 * z29 - (s_steer * z32 + c_steer * z33));
    const double z35 = z13 * z34;
    const double z36 = s_steer * z30;
    const double z37 = z36 * z6 + (k2 * z36 - thR_dot * z10);
    const double z38 = z36 * z13 + (k4 * z36 - (s_steer * z33 - c_steer * z32));
    const double z39 = z20 * z38 + z23 * z34;
    const double z40 = z27 * (z12 * z35 + z21 * z37 - z6 * z39);
    const double z41 = z22 * z34 - z17 * z38;
    const double z42 = z27 * (z18 * z37 + z11 * z35 + z6 * z41);
    const double z43 = (thR_dot - (z40 - e2z * z42)) * (s1 * z10 + c1 * z14);
    const double z44 = c_roll * v2_x;
    /* (I.2.4) */
    qdot[0] = -(c_yaw * z43 + s_yaw * z44); /* x' */
    qdot[1] = c_yaw * z44 - s_yaw * z43; /* y' */
    qdot[2] = e2z * v2_x; /* z' */
    qdot[3] = z42; /* yaw' */
    qdot[4] = roll_dot; /* roll' */
    qdot[5] = -z40; /* pitch' */
    qdot[6] = steer_dot; /* steer' */
    qdot[7] = thR_dot; /* thR' */
    qdot[8] = -z27 * (z12 * z41 + z11 * z39 + z24 * z37); /* thF' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[5] + qdot[8]) <= DBL_MAX
        && fabs(z25) > 1e-15 * (k10 * ((z26 + k12) * (z26 + k13))))) {
        /* the coframe is singular */
        if (!(fabs(z25) > 1e-15 * (k10 * ((z26 + k12) * (z26 + k13))))) {
            return bicycle_refuse(fabs(z25), 1e-15 * (k10 * ((z26 + k12) * (z26 + k13))), BICYCLE_SINGULAR_1);
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
    const double z5 = pitch + lam;
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double s1 = sin(z5);
    const double c1 = cos(z5);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thR_dot = y[11];
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thR_ddot = dydt[11]; /* thR'' */

    /* parameters only */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = c_lam * k1 - r_R * s_lam;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);

    /* state */
    const double z1 = 1.0 / fabs(c_roll);
    const double z2 = roll_dot * r_R;
    const double z3 = c_roll * z2;
    const double v2_x = z1 * z3;
    const double z4 = c_roll * v2_x;
    const double z6 = c_roll * c1;
    const double z7 = c_roll * s1;
    const double z8 = e2z * s_steer - c_steer * z7;
    const double z9 = 1.0 / sqrt(z6 * z6 + z8 * z8);
    const double z10 = r_F * z8;
    const double z11 = z9 * z10;
    const double z12 = k2 + z11;
    const double z13 = s_steer * z12;
    const double z14 = s1 * z13;
    const double z15 = r_R * z7;
    const double z16 = z1 * z15;
    const double z17 = k3 + z16 + c_steer * z12;
    const double z18 = c_roll * z14 + e2z * z17;
    const double z19 = r_F * z6;
    const double z20 = z9 * z19;
    const double z21 = r_R * z6;
    const double z22 = z1 * z21;
    const double z23 = k4 + z20;
    const double z24 = z22 - z23;
    const double z25 = s_steer * z24;
    const double z26 = z20 * z25;
    const double z27 = c_steer * z23;
    const double z28 = c_steer * k3 + z12;
    const double z29 = s1 * z27 + c1 * z28;
    const double z30 = c_roll * z29 + e2z * z25;
    const double z31 = z20 * z30;
    const double z32 = c_steer * z24;
    const double z33 = s_steer * z23;
    const double z34 = s_steer * k3;
    const double z35 = s1 * z33 + c1 * z34;
    const double z36 = c_roll * z35 - e2z * z32;
    const double z37 = z32 * z30 + z36 * z25;
    const double z38 = 1.0 / (z18 * z26 - z17 * z31 - z11 * z37);
    const double z39 = roll_dot * c1;
    const double z40 = s_steer * z39;
    const double z41 = z11 * z40 + (k2 * z40 - thR_dot * z16);
    const double z42 = roll_dot * s1;
    const double z43 = steer_dot + z42;
    const double z44 = c_steer * z39;
    const double z45 = thR_dot * z22;
    const double z46 = v2_x + k3 * z42;
    const double z47 = z11 * z43 - z20 * z44 - (k4 * z44 - k2 * z43 - (s_steer * z45 + c_steer * z46));
    const double z48 = z20 * z47;
    const double z49 = z20 * z40 + (k4 * z40 - (s_steer * z46 - c_steer * z45));
    const double z50 = z32 * z47 - z25 * z49;
    const double z51 = z26 * z41 + z17 * z48 + z11 * z50;
    const double z52 = z38 * z51;
    const double z53 = c_yaw * z52;
    const double z54 = roll_dot * e2z;
    const double z55 = z1 * (c_roll * z54) * (z1 * z1);
    const double z56 = z3 * z55 - z1 * (z54 * z2 - r_R * (c_roll * roll_ddot));
    const double z57 = z54 * v2_x - c_roll * z56;
    const double z58 = s_yaw * z52;
    const double z59 = z30 * z49 + z36 * z47;
    const double z60 = z18 * z48 + z31 * z41 - z11 * z59;
    const double z61 = z38 * z60;
    const double z62 = thR_dot - (z61 - e2z * z52);
    const double z63 = z16 * z62;
    const double z64 = s1 * z63 + z62 * (c1 * z22);
    const double z65 = c1 * z61;
    const double z66 = z63 * z65;
    const double z67 = z54 * s1 + c_roll * z65;
    const double z68 = r_R * z1;
    const double z69 = z15 * z55 - z67 * z68;
    const double z70 = steer_dot * c_steer;
    const double z71 = s1 * z61;
    const double z72 = z54 * c1 - c_roll * z71;
    const double z73 = roll_dot * c_roll;
    const double z74 = steer_dot * s_steer;
    const double z75 = s_steer * z73 + e2z * z70 + (z74 * z7 + c_steer * z67);
    const double z76 = (z6 * z72 - z8 * z75) * (z9 * (z9 * z9));
    const double z77 = r_F * z9;
    const double z78 = z10 * z76 + z77 * z75;
    const double z79 = z69 - (z74 * z12 - c_steer * z78);
    const double z80 = z54 * z14 + c_roll * (z13 * z65 - s1 * (z70 * z12 + s_steer * z78)) - (z73 * z17 + e2z
        * z79);
    const double z81 = z19 * z76 - z77 * z72;
    const double z82 = z21 * z55 - z72 * z68;
    const double z83 = z82 - z81;
    const double z84 = z70 * z24 + s_steer * z83;
    const double z85 = z25 * z81 + z20 * z84;
    const double z86 = z27 * z65 + s1 * (z74 * z23 - c_steer * z81) - (z28 * z71 - c1 * (z74 * k3 - z78));
    const double z87 = z54 * z29 + c_roll * z86 - (z73 * z25 + e2z * z84);
    const double z88 = z30 * z81 - z20 * z87;
    const double z89 = z74 * z24 - c_steer * z83;
    const double z90 = z33 * z65 - s1 * (z70 * z23 + s_steer * z81) - (z34 * z71 + k3 * (z70 * c1));
    const double z91 = z54 * z35 + c_roll * z90 + (z73 * z32 - e2z * z89);
    const double z92 = z30 * z89 + z32 * z87 + (z25 * z91 - z36 * z84);
    const double z93 = z26 * z80 - z18 * z85 + (z31 * z79 + z17 * z88) + (z37 * z78 - z11 * z92);
    const double z94 = z38 * z38 * z93;
    const double z95 = roll_dot * z65 - s1 * roll_ddot;
    const double z96 = steer_ddot - z95;
    const double z97 = roll_dot * z71 + c1 * roll_ddot;
    const double z98 = z74 * z39 - c_steer * z97;
    const double z99 = z22 * thR_ddot + thR_dot * z82;
    const double z100 = k3 * z95 - z56;
    const double z101 = k4 * z98 + k2 * z96 + (z70 * z45 + s_steer * z99 - (z74 * z46 + c_steer * z100));
    const double z102 = z11 * z96 + z43 * z78 + (z20 * z98 - z44 * z81) + z101;
    const double z103 = z47 * z81 + z20 * z102;
    const double z104 = z70 * z39 + s_steer * z97;
    const double z105 = z11 * z104 + z40 * z78 + (k2 * z104 - (z16 * thR_ddot + thR_dot * z69));
    const double z106 = z20 * z104 + z40 * z81 + (k4 * z104 - (z70 * z46 - s_steer * z100 + (z74 * z45 -
        c_steer * z99)));
    const double z107 = z49 * z87 - z30 * z106 + (z47 * z91 - z36 * z102);
    const double z108 = z48 * z80 - z18 * z103 - (z41 * z88 + z31 * z105) + (z59 * z78 - z11 * z107);
    const double z109 = z60 * z94 - z38 * z108;
    const double z110 = z47 * z89 - z32 * z102 + (z49 * z84 + z25 * z106);
    const double z111 = z41 * z85 + z26 * z105 + (z48 * z79 + z17 * z103) + (z50 * z78 - z11 * z110);
    const double z112 = z51 * z94 + z38 * z111;
    const double z113 = thR_ddot - (z109 - (z73 * z52 + e2z * z112));
    const double z114 = z66 - s1 * (z62 * z69 + z16 * z113) - (z66 + c1 * (z62 * z82 + z22 * z113));
    const double z115 = z50 * z80 + z18 * z110 - (z59 * z79 - z17 * z107) + (z41 * z92 - z37 * z105);
    /* (I.2.15) */
    qddot[0] = z58 * z64 + c_yaw * z114 - (z4 * z53 - s_yaw * z57); /* x'' */
    qddot[1] = -(z53 * z64 - s_yaw * z114 + (z4 * z58 + c_yaw * z57)); /* y'' */
    qddot[2] = z73 * v2_x + e2z * z56; /* z'' */
    qddot[3] = z112; /* yaw'' */
    qddot[4] = roll_ddot; /* roll'' */
    qddot[5] = -z109; /* pitch'' */
    qddot[6] = steer_ddot; /* steer'' */
    qddot[7] = thR_ddot; /* thR'' */
    qddot[8] = z38 * z115 - (z18 * z50 + z17 * z59 + z37 * z41) * z94; /* thF'' */
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
    const double thR_dot = qdot[7];

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
    y[11] = thR_dot;
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
    const double z9 = z3 * a1;
    const double z10 = yaw_dot * s_yaw;
    const double z11 = pitch_dot * s_pitch;
    const double z12 = yaw_dot * c_yaw;
    const double z13 = roll_dot * c_roll;
    const double z14 = e2z * z12 + s_yaw * z13;
    const double z15 = pitch_dot * c_pitch;
    const double z16 = c_pitch * z10 + c_yaw * z11 + (s_pitch * z14 + z1 * z15);
    const double z17 = s_pitch * z10 - c_yaw * z15 + (z1 * z11 - c_pitch * z14);
    const double z18 = e1x * c_lam - e3x * s_lam;
    const double z19 = steer_dot * s_steer;
    const double z20 = roll_dot * e2z;
    const double z21 = steer_dot * c_steer;
    const double z22 = z18 * z19 + c_steer * (c_lam * z16 - s_lam * z17) + (s_steer * (c_roll * z12 - s_yaw *
        z20) + z5 * z21);
    const double z23 = s_lam * z16 + c_lam * z17;
    const double Fx_dot = x_dot - k1 * z16 - r_R * z17 + c * (c_lam * z22 + s_lam * z23) + r_F * (c_lam * z23
        - s_lam * z22);
    const double f1x = c_steer * z18 - z5 * s_steer;
    const double sx = e1x * s_lam + e3x * c_lam;
    const double z24 = c_lam * w1 - s_lam * w3;
    const double z25 = thF_dot + (c_steer * w2 - s_steer * z24);
    const double z26 = z3 * s_lam - e3z * c_lam;
    const double z27 = z3 * c_lam + e3z * s_lam;
    const double z28 = c_steer * z27 - e2z * s_steer;
    const double z29 = c_lam * z26 - s_lam * z28;
    const double z30 = c_lam * z28 + s_lam * z26;
    const double z31 = r_F / sqrt(z30 * z30 + z29 * z29);
    const double z32 = z29 * z31;
    const double z33 = z25 * z32;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double wf = c_steer * z24 + s_steer * w2;
    const double z34 = z30 * z31;
    const double z35 = (c_lam * ws - s_lam * wf) * z34 - (c_lam * wf + s_lam * ws) * z32;
    const double b3 = z25 * z34;
    const double z36 = Fx_dot - (c_lam * f1x + s_lam * sx) * z33 + (z5 * c_steer + z18 * s_steer) * z35 +
        (c_lam * sx - s_lam * f1x) * b3;
    const double z37 = e2z * z10 - c_yaw * z13;
    const double z38 = s_yaw * z11 - c_pitch * z12 - (z8 * z15 - s_pitch * z37);
    const double z39 = s_pitch * z12 + s_yaw * z15 + (z8 * z11 + c_pitch * z37);
    const double z40 = e1y * c_lam - e3y * s_lam;
    const double z41 = z40 * z19 + c_steer * (c_lam * z38 + s_lam * z39) + (s_steer * (c_roll * z10 + c_yaw *
        z20) - e2y * z21);
    const double z42 = s_lam * z38 - c_lam * z39;
    const double Fy_dot = y_dot - k1 * z38 + r_R * z39 + c * (c_lam * z41 + s_lam * z42) + r_F * (c_lam * z42
        - s_lam * z41);
    const double f1y = c_steer * z40 + e2y * s_steer;
    const double sy = e1y * s_lam + e3y * c_lam;
    const double z43 = Fy_dot - (c_lam * f1y + s_lam * sy) * z33 - (e2y * c_steer - s_steer * z40) * z35 +
        (c_lam * sy - s_lam * f1y) * b3;
    const double z44 = z30 * z33;
    const double z45 = c_roll * z15 - s_pitch * z20;
    const double z46 = c_roll * z11 + c_pitch * z20;
    const double z47 = z27 * z19 - c_steer * (c_lam * z45 - s_lam * z46) + (s_steer * z13 + e2z * z21);
    const double z48 = s_lam * z45 + c_lam * z46;
    const double Fz_dot = z_dot - k1 * z45 - r_R * z46 - c * (c_lam * z47 - s_lam * z48) + r_F * (c_lam * z48
        + s_lam * z47);
    /* (I.1.1) 115:5 */
    r[0] = x_dot + e1x * a1 + z5 * z7 + e3x * a3; /* rear_x = 0 */
    /* (I.1.1) 116:5 */
    r[1] = y_dot + e1y * a1 - e2y * z7 + e3y * a3; /* rear_y = 0 */
    /* (I.1.1) 117:5 */
    r[2] = z9 + (z_dot - z9 - e2z * z7); /* rear_z = 0 */
    /* (I.1.1) 118:5 */
    r[3] = z36; /* front_x = 0 */
    /* (I.1.1) 119:5 */
    r[4] = z43; /* front_y = 0 */
    /* (I.1.1) 120:5 */
    r[5] = Fz_dot + z44 - (e2z * c_steer + s_steer * z27) * z35 - z44; /* front_z = 0 */
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
    (void)dydt;

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
    const double k29 = k27 + (c_lam * (k22 + c_lam * k8) + s_lam * (k20 + s_lam * k7));
    kept[17] = k29;
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double k30 = m_F * k16;
    const double m_H = p[17]; /* [kg] */
    const double k31 = m_H + m_F;
    kept[18] = k31;
    const double k32 = m_H * k15;
    const double k33 = k30 + k32;
    kept[19] = k33;
    const double k34 = m_F * k4;
    const double k35 = m_H * k9;
    const double k36 = k34 - k35;
    kept[20] = k36;
    const double H_xz = p[19]; /* [kg*m^2] */
    const double k37 = H_xz * c_lam;
    const double k38 = s_lam * k5 - k37;
    const double k39 = H_xz * s_lam;
    const double k40 = c_lam * k6 - k39;
    const double k41 = k16 * k30;
    const double k42 = k15 * k32;
    const double k43 = s_lam * k38 + c_lam * k40 + k41 + k42;
    kept[21] = k43;
    const double k44 = c_lam * k38 - s_lam * k40 + k4 * k30 - k9 * k32;
    kept[22] = k44;
    const double k45 = k4 * k34;
    const double k46 = k9 * k35;
    const double H_yy = p[20]; /* [kg*m^2] */
    const double k47 = k42 + (k41 + (H_yy + k45) + k46);
    kept[23] = k47;
    const double k48 = k46 + (k45 + (c_lam * (k39 + c_lam * k5) + s_lam * (k37 + s_lam * k6)));
    kept[24] = k48;
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double k49 = g * m_F;
    const double k50 = g * m_H;
    const double k51 = g * m_B;
    const double k52 = g * k17;
    kept[25] = k52;
    const double k53 = k12 * k51;
    kept[26] = k53;
    const double k54 = k11 * k51;
    kept[27] = k54;
    const double k55 = k9 * k50;
    kept[28] = k55;
    const double k56 = k15 * k50;
    kept[29] = k56;
    const double k57 = g * k31;
    kept[30] = k57;
    const double k58 = k4 * k49;
    kept[31] = k58;
    const double k59 = k16 * k49;
    kept[32] = k59;
    const double k60 = k56 + k59;
    kept[33] = k60;
    const double k61 = k55 - k58;
    kept[34] = k61;

    /* state */
    const double z2 = c_roll * s1;
    kept[35] = z2;
    const double z3 = c_roll * c1;
    kept[36] = z3;
    const double z4 = e2z * s_steer - c_steer * z2;
    kept[37] = z4;
    const double z5 = 1.0 / sqrt(z3 * z3 + z4 * z4);
    const double z6 = r_F * z4;
    const double z7 = z5 * z6;
    kept[38] = z7;
    const double z8 = k4 + z7;
    kept[39] = z8;
    const double z9 = s_steer * z8;
    kept[40] = z9;
    const double z10 = s1 * z9;
    kept[41] = z10;
    const double z11 = 1.0 / fabs(c_roll);
    const double z12 = r_R * z2;
    const double z13 = z11 * z12;
    kept[42] = z13;
    const double z14 = k10 + z13;
    kept[43] = z14;
    const double z15 = z14 + c_steer * z8;
    kept[44] = z15;
    const double z16 = c_roll * z10 + e2z * z15;
    kept[45] = z16;
    const double z17 = r_F * z3;
    kept[46] = z17;
    const double z18 = z5 * z17;
    kept[47] = z18;
    const double z19 = r_R * z3;
    const double z20 = z11 * z19;
    kept[48] = z20;
    const double z21 = k16 + z18;
    kept[49] = z21;
    const double z22 = z20 - z21;
    kept[50] = z22;
    const double z23 = s_steer * z22;
    kept[51] = z23;
    const double z24 = z18 * z23;
    kept[52] = z24;
    const double z25 = c_steer * z21;
    kept[53] = z25;
    const double z26 = c_steer * k10 + z8;
    kept[54] = z26;
    const double z27 = s1 * z25 + c1 * z26;
    kept[55] = z27;
    const double z28 = c_roll * z27 + e2z * z23;
    kept[56] = z28;
    const double z29 = z18 * z28;
    kept[57] = z29;
    const double z30 = c_steer * z22;
    kept[58] = z30;
    const double z31 = s_steer * z21;
    kept[59] = z31;
    const double z32 = s_steer * k10;
    kept[60] = z32;
    const double z33 = s1 * z31 + c1 * z32;
    kept[61] = z33;
    const double z34 = c_roll * z33 - e2z * z30;
    kept[62] = z34;
    const double z35 = z30 * z28 + z34 * z23;
    kept[63] = z35;
    const double z36 = 1.0 / (z16 * z24 - z15 * z29 - z7 * z35);
    kept[64] = z36;
    const double roll_dot = y[9];
    const double z37 = roll_dot * c1;
    kept[65] = z37;
    const double z38 = s_steer * z37;
    kept[66] = z38;
    const double thR_dot = y[11];
    const double z39 = z7 * z38 + (k4 * z38 - thR_dot * z13);
    const double z40 = roll_dot * s1;
    const double steer_dot = y[10];
    const double z41 = steer_dot + z40;
    kept[67] = z41;
    const double z42 = c_steer * z37;
    kept[68] = z42;
    const double z43 = thR_dot * z20;
    kept[69] = z43;
    const double z44 = r_R * z11;
    const double z45 = c_roll * z44;
    kept[70] = z45;
    const double v2_x = roll_dot * z45;
    kept[71] = v2_x;
    const double z46 = k10 * z40 + v2_x;
    kept[72] = z46;
    const double z47 = z7 * z41 - z18 * z42 - (k16 * z42 - k4 * z41 - (s_steer * z43 + c_steer * z46));
    const double z48 = z18 * z47;
    const double z49 = z18 * z38 + (k16 * z38 + (c_steer * z43 - s_steer * z46));
    const double z50 = z28 * z49 + z34 * z47;
    const double z51 = z36 * (z29 * z39 + z16 * z48 - z7 * z50);
    kept[73] = z51;
    const double z52 = z30 * z47 - z23 * z49;
    const double z53 = z36 * (z24 * z39 + z15 * z48 + z7 * z52);
    kept[74] = z53;
    const double z54 = z51 - e2z * z53;
    kept[75] = z54;
    const double z55 = k19 * z54;
    kept[76] = z55;
    const double z56 = c_roll * z53;
    kept[77] = z56;
    const double z57 = z40 + c1 * z56;
    kept[78] = z57;
    const double z58 = z37 - s1 * z56;
    kept[79] = z58;
    const double z59 = k18 * z58 - k19 * z57;
    kept[80] = z59;
    const double z60 = thR_dot - z54;
    kept[81] = z60;
    const double z61 = roll_dot * e2z;
    kept[82] = z61;
    const double z62 = z11 * (c_roll * z61) * (z11 * z11);
    const double z63 = s1 * z51;
    kept[83] = z63;
    const double z64 = z61 * c1 - c_roll * z63;
    kept[84] = z64;
    const double z65 = z19 * z62 - z44 * z64;
    kept[85] = z65;
    const double z66 = roll_dot * c_roll;
    kept[86] = z66;
    const double z67 = steer_dot * c_steer;
    kept[87] = z67;
    const double z68 = steer_dot * s_steer;
    kept[88] = z68;
    const double z69 = c1 * z51;
    kept[89] = z69;
    const double z70 = z61 * s1 + c_roll * z69;
    const double z71 = s_steer * z66 + e2z * z67 + (z68 * z2 + c_steer * z70);
    const double z72 = z5 * (z5 * z5) * (z3 * z64 - z4 * z71);
    kept[90] = z72;
    const double z73 = r_F * z5;
    kept[91] = z73;
    const double z74 = z6 * z72 + z73 * z71;
    kept[92] = z74;
    const double z75 = roll_dot * z63;
    kept[93] = z75;
    const double z76 = z67 * z37 + s_steer * z75;
    kept[94] = z76;
    const double z77 = z12 * z62 - z44 * z70;
    kept[95] = z77;
    const double z78 = z36 * (z35 * z39 + (z16 * z52 + z15 * z50));
    kept[96] = z78;
    const double z79 = z77 - (z68 * z8 - c_steer * z74);
    kept[97] = z79;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_reactions_part2(double t, const double *y, const double *p, const double
    *dydt, double *kept, double *lambda)
{
    (void)t;
    const double e2z = kept[2];
    const double c_roll = kept[3];
    const double s1 = kept[4];
    const double s_steer = kept[6];
    const double z8 = kept[39];
    const double z9 = kept[40];
    const double z10 = kept[41];
    const double z15 = kept[44];
    const double z61 = kept[82];
    const double z66 = kept[86];
    const double z67 = kept[87];
    const double z69 = kept[89];
    const double z74 = kept[92];
    const double z79 = kept[97];
    const double z80 = z61 * z10 + c_roll * (z9 * z69 - s1 * (z67 * z8 + s_steer * z74)) - (z66 * z15 + e2z *
        z79);
    const double thR_dot = y[11];
    const double k4 = kept[8];
    const double z7 = kept[38];
    const double z38 = kept[66];
    const double z51 = kept[73];
    const double z53 = kept[74];
    const double z76 = kept[94];
    const double z77 = kept[95];
    const double z78 = kept[96];
    const double z81 = z38 * z74 + z7 * z76 + (k4 * z76 - thR_dot * z77) + (z78 * z74 + (z53 * z80 + z51 *
        z79));
    const double z17 = kept[46];
    const double z64 = kept[84];
    const double z72 = kept[90];
    const double z73 = kept[91];
    const double z82 = z17 * z72 - z73 * z64;
    const double c1 = kept[5];
    const double c_steer = kept[7];
    const double k10 = kept[9];
    const double z21 = kept[49];
    const double z25 = kept[53];
    const double z26 = kept[54];
    const double z63 = kept[83];
    const double z68 = kept[88];
    const double z83 = z25 * z69 + s1 * (z68 * z21 - c_steer * z82) - (z26 * z63 - c1 * (z68 * k10 - z74));
    const double z65 = kept[85];
    const double z84 = z65 - z82;
    const double z22 = kept[50];
    const double z85 = z67 * z22 + s_steer * z84;
    const double roll_dot = y[9];
    const double z86 = roll_dot * z69;
    const double z37 = kept[65];
    const double z75 = kept[93];
    const double z87 = z68 * z37 - c_steer * z75;
    const double z88 = thR_dot * z65;
    const double z89 = k10 * z86;
    const double k16 = kept[10];
    const double z43 = kept[69];
    const double z46 = kept[72];
    const double z90 = k16 * z87 - k4 * z86 + (z67 * z43 + s_steer * z88 - (z68 * z46 + c_steer * z89));
    const double z18 = kept[47];
    const double z23 = kept[51];
    const double z27 = kept[55];
    const double z41 = kept[67];
    const double z42 = kept[68];
    const double z91 = z53 * (z61 * z27 + c_roll * z83 - (z66 * z23 + e2z * z85)) + z51 * z85 - (z41 * z74 -
        z7 * z86 - (z42 * z82 - z18 * z87) + z90);
    const double z92 = z18 * z91;
    const double z31 = kept[59];
    const double z32 = kept[60];
    const double z93 = z31 * z69 - s1 * (z67 * z21 + s_steer * z82) - (k10 * (z67 * c1) + z32 * z63);
    const double z94 = z68 * z22 - c_steer * z84;
    const double z30 = kept[58];
    const double z33 = kept[61];
    const double z95 = z78 * z82 + (z53 * (z61 * z33 + c_roll * z93 + (z66 * z30 - e2z * z94)) + z51 * z94);
    const double z96 = z38 * z82 + z18 * z76 + (k16 * z76 - (z68 * z43 - c_steer * z88 + (z67 * z46 - s_steer
        * z89)));
    const double z97 = z95 + z96;
    const double z28 = kept[56];
    const double z34 = kept[62];
    const double z98 = z28 * z97 - z34 * z91;
    const double z99 = z30 * z91 + z23 * z97;
    const double z24 = kept[52];
    const double z36 = kept[64];
    const double z100 = z36 * (z24 * z81 - z15 * z92 - z7 * z99);
    const double z16 = kept[45];
    const double z29 = kept[57];
    const double z101 = z36 * (z29 * z81 - z16 * z92 - z7 * z98) - (z66 * z53 + e2z * z100);
    const double z13 = kept[42];
    const double z60 = kept[81];
    const double z102 = z13 * z60;
    const double z20 = kept[48];
    const double v2_x = kept[71];
    const double z54 = kept[75];
    const double z57 = kept[78];
    const double z103 = z60 * z65 - z20 * z101 - (z54 * z102 - v2_x * z57);
    const double z104 = s_steer * z20;
    const double z105 = z36 * (z13 * z24 - z15 * (z18 * z104));
    const double z106 = e2z * z105;
    const double z107 = 1.0 - z106;
    const double z108 = z20 * z107;
    const double z109 = z18 * z8;
    const double z110 = z34 * z8;
    const double z111 = z30 * z8;
    const double z112 = z36 * (z15 * z109 + z7 * z111);
    const double z113 = z36 * (z16 * z109 - z7 * z110) - e2z * z112;
    const double z114 = z20 * z113;
    const double z115 = s_steer * c1;
    const double z116 = z8 * z115;
    const double z117 = c_steer * c1;
    const double z45 = kept[70];
    const double z118 = k10 * s1 + z45;
    const double z119 = s1 * z7 - z18 * z117 - (k16 * z117 - k4 * s1 - c_steer * z118);
    const double z120 = z18 * z119;
    const double z121 = z18 * z115 + (k16 * z115 - s_steer * z118);
    const double z122 = z36 * (z24 * z116 + z15 * z120 + z7 * (z30 * z119 - z23 * z121));
    const double z123 = z36 * (z29 * z116 + z16 * z120 - z7 * (z28 * z121 + z34 * z119)) - e2z * z122;
    const double z124 = z20 * z123;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thR_ddot = dydt[11]; /* thR'' */
    const double z125 = thR_ddot * z108 - (z114 * steer_ddot + roll_ddot * z124);
    const double z126 = z113 * steer_ddot + roll_ddot * z123;
    const double z127 = thR_ddot * z106 + z126;
    const double k17 = kept[11];
    const double k18 = kept[12];
    const double k52 = kept[25];
    const double z2 = kept[35];
    const double z55 = kept[76];
    const double z59 = kept[80];
    const double z128 = z2 * k52 - (z54 * z55 - z57 * z59 + (k17 * z103 + k18 * z101)) - (k17 * z125 + k18 *
        z127);
    const double h2z = e2z * c_steer + s_steer * z2;
    const double steer_dot = y[10];
    const double w3_steer = steer_dot + z57;
    const double z58 = kept[79];
    const double z129 = c_steer * z54 + s_steer * z58;
    const double k33 = kept[19];
    const double z130 = k33 * z129;
    const double z131 = s_steer * z54 - c_steer * z58;
    const double k36 = kept[20];
    const double z132 = k36 * z129;
    const double z133 = z61 * z53 - c_roll * z100;
    const double z56 = kept[77];
    const double z134 = z86 - (z56 * z63 - c1 * z133);
    const double z135 = z20 * z60;
    const double z136 = z135 * z57 - z102 * z58;
    const double z137 = k10 * z54;
    const double z138 = z136 + (z137 * z58 + k10 * z134);
    const double z139 = k10 * z57;
    const double z140 = z54 * z137 + z57 * z139 + z103;
    const double z141 = c_steer * z138 - s_steer * z140;
    const double z142 = z75 + (z56 * z69 + s1 * z133);
    const double z143 = z67 * z54 + s_steer * z101 + (z68 * z58 - c_steer * z142);
    const double k31 = kept[18];
    const double k57 = kept[30];
    const double z144 = h2z * k57 + (w3_steer * z130 - z131 * z132 + (k36 * z134 + (k31 * z141 - k33 *
        z143)));
    const double z145 = c_roll * z105;
    const double z146 = c1 * z145;
    const double z147 = thR_ddot * z146;
    const double z148 = c_roll * z112;
    const double z149 = c1 * z148;
    const double z150 = c_roll * z122;
    const double z151 = s1 + c1 * z150;
    const double z152 = roll_ddot * z151;
    const double z153 = z147 - ((1.0 + z149) * steer_ddot + z152);
    const double z154 = k10 * z146;
    const double z155 = k10 * z149;
    const double z156 = z45 + k10 * z151;
    const double z157 = thR_ddot * (c_steer * z154 - s_steer * z108) - ((c_steer * z155 - s_steer * z114) *
        steer_ddot + roll_ddot * (c_steer * z156 - s_steer * z124));
    const double z158 = s1 * z145;
    const double z159 = s1 * z148;
    const double z160 = c1 - s1 * z150;
    const double z161 = thR_ddot * (s_steer * z106 - c_steer * z158) + ((s_steer * z113 + c_steer * z159) *
        steer_ddot + roll_ddot * (s_steer * z123 - c_steer * z160));
    const double z162 = z144 + (k36 * z153 + (k31 * z157 - k33 * z161));
    const double z163 = k33 * z131 + k36 * w3_steer;
    const double z164 = c_steer * z140 + s_steer * z138;
    const double z165 = z68 * z54 - c_steer * z101 - (z67 * z58 + s_steer * z142);
    const double z166 = thR_ddot * (c_steer * z108 + s_steer * z154) - ((c_steer * z114 + s_steer * z155) *
        steer_ddot + roll_ddot * (c_steer * z124 + s_steer * z156));
    const double z167 = c_steer * z106 + s_steer * z158;
    const double z168 = c_steer * z113 - s_steer * z159;
    const double z169 = roll_ddot * (c_steer * z123 + s_steer * z160);
    const double z170 = thR_ddot * z167 + (z168 * steer_ddot + z169);
    const double z4 = kept[37];
    const double z171 = z4 * k57 + (z129 * z132 + w3_steer * z163 + (k31 * z164 - k33 * z165)) + (k31 * z166
        + k33 * z170);
    const double z172 = z128 + s_steer * z162 - c_steer * z171;
    const double z35 = kept[63];
    const double z173 = thR_ddot * (z36 * (z15 * (c_steer * z20 * z28 + z34 * z104) - z13 * z35) + z167) +
        ((z36 * (z16 * z111 + z15 * z110) + z168) * steer_ddot + z169);
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z174 = F_yy * (z36 * (z35 * z81 - (z16 * z99 - z15 * z98)) - z165 + z173);
    const double z175 = z36 * z174;
    const double z176 = z60 * z77 - z13 * z101 + (z54 * z135 - v2_x * z58);
    const double k25 = kept[14];
    const double k26 = kept[15];
    const double z177 = k25 * z58 - k26 * z57;
    const double k29 = kept[17];
    const double z178 = k29 * z57 - k26 * z58;
    const double k19 = kept[13];
    const double k28 = kept[16];
    const double k53 = kept[26];
    const double k54 = kept[27];
    const double z3 = kept[36];
    const double z179 = z2 * k54 + z3 * k53 - (k28 * z101 + (k18 * z103 - k19 * z176) - (z57 * z177 - z58 *
        z178));
    const double z180 = z13 * z107;
    const double z181 = thR_ddot * z180 - z13 * z126;
    const double z182 = z176 - (z58 * z139 + k10 * z101);
    const double z14 = kept[43];
    const double z183 = thR_ddot * (z180 - k10 * z106) - z14 * z126;
    const double z184 = z3 * k57 + (z131 * z163 + z129 * z130 + (k31 * z182 + k36 * z165)) + (k31 * z183 -
        k36 * z170);
    const double k43 = kept[21];
    const double k44 = kept[22];
    const double z185 = k43 * z131 + k44 * w3_steer;
    const double k48 = kept[24];
    const double z186 = k48 * w3_steer + k44 * z131;
    const double k47 = kept[23];
    const double k55 = kept[28];
    const double k56 = kept[29];
    const double k58 = kept[31];
    const double k59 = kept[32];
    const double z187 = z4 * k56 + z3 * k55 + (z4 * k59 - z3 * k58) - (k47 * z165 - (k33 * z164 - k36 * z182)
        - (w3_steer * z185 - z131 * z186));
    const double z188 = z187 + (k47 * z170 + (k33 * z166 - k36 * z183)) + z174;
    const double z189 = F_yy * (z78 + z129) + k47 * z129;
    const double k60 = kept[33];
    const double z190 = h2z * k60 + (k44 * z134 + (k33 * z141 - k43 * z143) + (w3_steer * z189 - z129 *
        z186));
    const double z191 = z190 + (k44 * z153 + (k33 * z157 - k43 * z161));
    const double z192 = z179 - (k28 * z127 + (k18 * z125 - k19 * z181)) + k10 * z184 - c_steer * z188 +
        s_steer * z191;
    const double z193 = k18 * z54;
    const double z194 = z3 * k52 + (z58 * z59 + z54 * z193 + (k17 * z176 - k19 * z101)) + (k17 * z181 - k19 *
        z127);
    const double z195 = z194 + z184;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double z196 = z192 - (R_yy * (z101 - (thR_ddot * z107 - z126)) - z13 * z195 + z20 * z172);
    const double z197 = z36 * z196;
    const double z198 = z15 * z175 + z7 * z197;
    const double z199 = R_yy * z60 - k28 * z54;
    const double z200 = e2z * k54 + (k26 * z134 + (k18 * z136 + k25 * z142) - (z57 * z199 + z54 * z178));
    const double z201 = z147 - (z149 * steer_ddot + z152);
    const double z202 = roll_ddot * z45;
    const double z203 = thR_ddot * z158 - (z159 * steer_ddot - roll_ddot * z160);
    const double z204 = s1 * (z200 + (k26 * z201 - (k18 * z202 - k25 * z203)) + s_steer * z188 + c_steer *
        z191);
    const double k61 = kept[34];
    const double z205 = h2z * k61 + (z131 * z189 - z129 * z185 - (k48 * z134 + (k36 * z141 - k44 * z143)));
    const double z206 = e2z * k53 - (z58 * z199 + z54 * z177 - (k29 * z134 + (k19 * z136 + k26 * z142)));
    const double z207 = c_steer * z162 + s_steer * z171;
    const double z208 = z205 - (k48 * z153 + (k36 * z157 - k44 * z161)) - (z206 + (k29 * z201 - (k19 * z202 -
        k26 * z203)) + k10 * z207);
    const double z209 = z36 * (c_roll * (z204 - c1 * z208) - e2z * z196);
    const double z210 = z16 * z175 - z7 * z209;
    const double z211 = z28 * z198 - z23 * z210;
    const double z212 = z34 * z198 + z30 * z210 - z18 * (z16 * z197 + z15 * z209);
    const double z213 = c_steer * z211 + s_steer * z212;
    const double z214 = z172 - z213;
    const double z215 = z35 * z175 - z29 * z197 - z24 * z209;
    const double z216 = z195 - z215;
    const double z217 = s1 * z214 + c1 * z216;
    const double z218 = e2z * k52 + (z57 * z193 + z58 * z55 + (k19 * z134 + (k17 * z136 + k18 * z142)));
    const double z219 = s_steer * z211 - c_steer * z212;
    const double z220 = z218 + (k19 * z201 - (k17 * z202 - k18 * z203)) + z207 + z219;
    const double z221 = e2z * z217 - c_roll * z220;
    const double z222 = c1 * z214 - s1 * z216;
    const double s_yaw = kept[0];
    const double c_yaw = kept[1];
    /* (I.4.1) 115:5 */
    lambda[0] = c_yaw * z222 - s_yaw * z221; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 116:5 */
    lambda[1] = c_yaw * z221 + s_yaw * z222; /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 117:5 */
    lambda[2] = -(c_roll * z217 + e2z * z220); /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z223 = s1 * z213 + c1 * z215;
    const double z224 = e2z * z223 + c_roll * z219;
    const double z225 = c1 * z213 - s1 * z215;
    /* (I.4.1) 118:5 */
    lambda[3] = c_yaw * z225 - s_yaw * z224; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    /* (I.4.1) 119:5 */
    lambda[4] = c_yaw * z224 + s_yaw * z225; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    /* (I.4.1) 120:5 */
    lambda[5] = e2z * z219 - c_roll * z223; /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return BICYCLE_OK;
}

BICYCLE_SLOW
int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[98]; /* what parts of this function leave for others */
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
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double s_yaw = sin(yaw);
    const double c_yaw = cos(yaw);
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double roll_dot = y[9];
    const double steer_dot = y[10];
    const double thR_dot = y[11];
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
    const double z2 = s_pitch * c_lam + c_pitch * s_lam;
    const double z3 = c_roll * z2;
    const double z4 = e2z * s_steer - c_steer * z3;
    const double z5 = c_pitch * c_lam - s_pitch * s_lam;
    const double z6 = c_roll * z5;
    const double z7 = c_lam * z4 + s_lam * z6;
    const double z8 = c_lam * z6 - s_lam * z4;
    const double z9 = z * m_R + m_B * (z - x_B * z1 + e3z * k1) + m_H * (Sz - k3 * z7 + z_H * z8);
    const double z10 = r_F / sqrt(z6 * z6 + z4 * z4);
    const double z11 = z4 * z10;
    const double z12 = k4 + z11;
    const double z13 = r_R / fabs(c_roll);
    const double z14 = z3 * z13;
    const double z15 = k5 + z14 + c_steer * z12;
    const double z16 = z12 * (s_steer * z3) + e2z * z15;
    const double z17 = z6 * z10;
    const double z18 = z6 * z13;
    const double z19 = k6 + z17;
    const double z20 = z18 - z19;
    const double z21 = s_steer * z20;
    const double z22 = z17 * z21;
    const double z23 = z2 * z19;
    const double z24 = c_roll * (c_steer * z23 + z5 * (c_steer * k5 + z12)) + e2z * z21;
    const double z25 = z17 * z24;
    const double z26 = c_steer * z20;
    const double z27 = c_roll * (s_steer * z23 + k5 * (s_steer * z5)) - e2z * z26;
    const double z28 = z26 * z24 + z27 * z21;
    const double z29 = 1.0 / (z16 * z22 - z15 * z25 - z11 * z28);
    const double z30 = roll_dot * z2;
    const double z31 = steer_dot + z30;
    const double z32 = roll_dot * z5;
    const double z33 = c_steer * z32;
    const double z34 = thR_dot * z18;
    const double z35 = roll_dot * c_roll;
    const double v2_x = z35 * z13;
    const double z36 = k5 * z30 + v2_x;
    const double z37 = z31 * z11 - z33 * z17 - (k6 * z33 - k4 * z31 - (s_steer * z34 + c_steer * z36));
    const double z38 = s_steer * z32;
    const double z39 = z38 * z17 + (k6 * z38 - (s_steer * z36 - c_steer * z34));
    const double z40 = z26 * z37 - z21 * z39;
    const double z41 = z24 * z39 + z27 * z37;
    const double z42 = z38 * z11 + (k4 * z38 - thR_dot * z14);
    const double z43 = z17 * z37;
    const double z44 = z29 * (z16 * z43 + z25 * z42 - z11 * z41);
    const double z45 = z29 * (z22 * z42 + z15 * z43 + z11 * z40);
    const double z46 = z44 - e2z * z45;
    const double w1 = roll_dot * c_pitch - z1 * z45;
    const double w3 = roll_dot * s_pitch + e3z * z45;
    const double z47 = c_lam * w1 - s_lam * w3;
    const double z48 = c_steer * z46 + s_steer * z47;
    const double z49 = z29 * (z16 * z40 + z15 * z41 + z28 * z42) + z48;
    const double z50 = s_steer * z46 - c_steer * z47;
    const double ws = steer_dot + (s_lam * w1 + c_lam * w3);
    const double z51 = c_lam * z50 - s_lam * ws;
    const double z52 = z51 * z51;
    const double o3 = c_lam * ws + s_lam * z50;
    const double z53 = o3 * o3;
    const double z54 = s_yaw * z45;
    const double z55 = s_pitch * z44;
    const double z56 = c_yaw * z45;
    const double z57 = s_yaw * z35 + e2z * z56;
    const double z58 = s_yaw * e2z;
    const double z59 = c_pitch * z44;
    const double z60 = c_pitch * z54 - c_yaw * z55 + (s_pitch * z57 - z58 * z59);
    const double z61 = s_pitch * z54 + c_yaw * z59 - (z58 * z55 + c_pitch * z57);
    const double z62 = s_lam * z60 + c_lam * z61;
    const double z63 = steer_dot * s_steer;
    const double z64 = ((c_yaw * c_pitch - z58 * s_pitch) * c_lam - (c_yaw * s_pitch + c_pitch * z58) *
        s_lam) * z63 + c_steer * (c_lam * z60 - s_lam * z61);
    const double z65 = steer_dot * c_steer;
    const double z66 = c_roll * z65;
    const double z67 = roll_dot * e2z;
    const double z68 = z64 + (s_yaw * z66 - s_steer * (s_yaw * z67 - c_roll * z56));
    const double z69 = c_lam * z62 - s_lam * z68;
    const double z70 = c_lam * z68 + s_lam * z62;
    const double z71 = c_roll * v2_x;
    const double z72 = thR_dot - z46;
    const double z73 = z72 * (z2 * z14 + z5 * z18);
    const double z74 = s_yaw * z71 + c_yaw * z73;
    const double z75 = r_R * z61 + (k2 * z60 + z74);
    const double z76 = r_F * z69 + (c * z70 - z75);
    const double z77 = c_yaw * e2z;
    const double z78 = c_yaw * z35 - e2z * z54;
    const double z79 = s_yaw * z55 + c_pitch * z56 - (z77 * z59 - s_pitch * z78);
    const double z80 = s_pitch * z56 - s_yaw * z59 - (z77 * z55 + c_pitch * z78);
    const double z81 = s_lam * z79 + c_lam * z80;
    const double z82 = ((c_pitch * s_yaw + s_pitch * z77) * c_lam - (s_yaw * s_pitch - c_pitch * z77) *
        s_lam) * z63 - c_steer * (c_lam * z79 - s_lam * z80);
    const double z83 = z82 - (c_yaw * z66 - s_steer * (c_yaw * z67 + c_roll * z54));
    const double z84 = c_lam * z81 + s_lam * z83;
    const double z85 = c_lam * z83 - s_lam * z81;
    const double z86 = c_yaw * z71 - s_yaw * z73;
    const double z87 = r_R * z80 + (k2 * z79 + z86);
    const double z88 = r_F * z84 - (c * z85 + z87);
    const double z89 = c_pitch * z67 - c_roll * z55;
    const double z90 = e2z * v2_x;
    const double z91 = s_pitch * z67 + c_roll * z59;
    const double z92 = r_R * z89 - (z90 + k2 * z91);
    const double z93 = s_lam * z91 - c_lam * z89;
    const double z94 = s_steer * z35 + e2z * z65 + (z63 * z3 + c_steer * (c_lam * z91 + s_lam * z89));
    const double z95 = s_lam * z93 + c_lam * z94;
    const double z96 = c_lam * z93 - s_lam * z94;
    const double z97 = z92 + c * z95 + r_F * z96;
    const double z98 = F_yy * (z49 * z49) + (F_xx * (z52 + z53) + m_F * (z76 * z76 + z88 * z88 + z97 * z97));
    const double z99 = z_H * z69 - (k3 * z70 - z75);
    const double z100 = z_H * z84 + (k3 * z85 + z87);
    const double z101 = z92 + k3 * z95 - z_H * z96;
    const double z102 = H_xx * z52 + H_yy * (z48 * z48) + H_zz * z53 + m_H * (z99 * z99 + z100 * z100 + z101
        * z101);
    const double z103 = w1 * w1;
    const double z104 = w3 * w3;
    const double z105 = R_yy * (z72 * z72) + (R_xx * (z103 + z104) + m_R * (z74 * z74 + z86 * z86 + z90 *
        z90));
    const double z106 = k1 * z61 + (x_B * z60 + z74);
    const double z107 = k1 * z80 + (x_B * z79 + z86);
    const double z108 = k1 * z89 - (z90 + x_B * z91);
    const double z109 = B_xx * z103 + B_yy * (z46 * z46) + B_zz * z104 + m_B * (z106 * z106 + z107 * z107 +
        z108 * z108);
    const double z110 = H_xz * (z51 * o3) - 0.5 * z102 - (0.5 * z105 + (B_xz * (w1 * w3) + 0.5 * z109));
    return 0.5 * z98 - z110 - g * (z9 + m_F * (Sz - c * z7 - r_F * z8));
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
    const double z14 = k10 + z13;
    kept[52] = z14;
    const double z15 = z14 + c_steer * z8;
    kept[53] = z15;
    const double z16 = c_roll * z10 + e2z * z15;
    kept[54] = z16;
    const double z17 = r_F * z2;
    kept[55] = z17;
    const double z18 = z5 * z17;
    kept[56] = z18;
    const double z19 = r_R * z2;
    kept[57] = z19;
    const double z20 = z11 * z19;
    kept[58] = z20;
    const double z21 = k16 + z18;
    kept[59] = z21;
    const double z22 = z20 - z21;
    kept[60] = z22;
    const double z23 = s_steer * z22;
    kept[61] = z23;
    const double z24 = z18 * z23;
    kept[62] = z24;
    const double z25 = c_steer * z21;
    kept[63] = z25;
    const double z26 = c_steer * k10 + z8;
    kept[64] = z26;
    const double z27 = s1 * z25 + c1 * z26;
    kept[65] = z27;
    const double z28 = c_roll * z27 + e2z * z23;
    kept[66] = z28;
    const double z29 = z18 * z28;
    kept[67] = z29;
    const double z30 = c_steer * z22;
    kept[68] = z30;
    const double z31 = s_steer * z21;
    kept[69] = z31;
    const double z32 = s_steer * k10;
    kept[70] = z32;
    const double z33 = s1 * z31 + c1 * z32;
    kept[71] = z33;
    const double z34 = c_roll * z33 - e2z * z30;
    kept[72] = z34;
    const double z35 = z30 * z28 + z34 * z23;
    kept[73] = z35;
    const double z36 = z16 * z24 - z15 * z29 - z7 * z35;
    kept[74] = z36;
    const double z37 = k17 * (9.0 + fabs(z11));
    kept[75] = z37;
    const double z38 = 1.0 / z36;
    kept[76] = z38;
    const double z39 = s_steer * c1;
    kept[77] = z39;
    const double z40 = z8 * z39;
    kept[78] = z40;
    const double z41 = c_steer * c1;
    kept[79] = z41;
    const double z42 = r_R * c_roll;
    kept[80] = z42;
    const double z43 = z42 * z11;
    kept[81] = z43;
    const double z44 = k10 * s1 + z43;
    kept[82] = z44;
    const double z45 = s1 * z7 - z18 * z41 - (k16 * z41 - k4 * s1 - c_steer * z44);
    kept[83] = z45;
    const double z46 = z18 * z45;
    kept[84] = z46;
    const double z47 = z18 * z39 + (k16 * z39 - s_steer * z44);
    kept[85] = z47;
    const double z48 = z30 * z45 - z23 * z47;
    kept[86] = z48;
    const double z49 = z24 * z40 + z15 * z46 + z7 * z48;
    kept[87] = z49;
    const double z50 = z38 * z49;
    kept[88] = z50;
    const double z51 = c_roll * z50;
    kept[89] = z51;
    const double z52 = s1 + c1 * z51;
    kept[90] = z52;
    const double z53 = z43 + k10 * z52;
    kept[91] = z53;
    const double z54 = z28 * z47 + z34 * z45;
    kept[92] = z54;
    const double z55 = z16 * z46 + z29 * z40 - z7 * z54;
    kept[93] = z55;
    const double z56 = z38 * z55;
    kept[94] = z56;
    const double z57 = z56 - e2z * z50;
    kept[95] = z57;
    const double z58 = z20 * z57;
    kept[96] = z58;
    const double z59 = c_steer * z53 - s_steer * z58;
    kept[97] = z59;
    const double z60 = c1 - s1 * z51;
    kept[98] = z60;
    const double z61 = s_steer * z57 - c_steer * z60;
    kept[99] = z61;
    const double z62 = k63 * z52 + (k48 * z59 + k62 * z61);
    kept[100] = z62;
    const double z63 = c_steer * z57 + s_steer * z60;
    kept[101] = z63;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part2(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)t;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double z53 = kept[91];
    const double z58 = kept[96];
    const double z64 = c_steer * z58 + s_steer * z53;
    kept[102] = z64;
    const double z14 = kept[52];
    const double z57 = kept[95];
    const double z65 = z14 * z57;
    kept[103] = z65;
    const double k45 = kept[23];
    const double k48 = kept[24];
    const double k59 = kept[27];
    const double z63 = kept[101];
    const double z66 = k59 * z63 - (k45 * z64 - k48 * z65);
    kept[104] = z66;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z52 = kept[90];
    const double z59 = kept[97];
    const double z61 = kept[99];
    const double z67 = k56 * z52 + (k45 * z59 + k55 * z61);
    kept[105] = z67;
    const double k43 = kept[22];
    const double z68 = k43 * z65 + k48 * z63;
    kept[106] = z68;
    const double z69 = k48 * z52 + (k43 * z59 + k45 * z61);
    kept[107] = z69;
    const double z70 = k43 * z64 - k45 * z63;
    kept[108] = z70;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double z43 = kept[81];
    const double z60 = kept[98];
    const double z71 = k41 * z52 + (z43 * k28 - k40 * z60);
    kept[109] = z71;
    const double z13 = kept[51];
    const double z72 = z13 * z57;
    kept[110] = z72;
    const double k27 = kept[15];
    const double k37 = kept[19];
    const double z73 = z57 * k37 - (z58 * k27 - z72 * k28);
    kept[111] = z73;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z74 = k35 * z52 + (z43 * k27 - k34 * z60);
    kept[112] = z74;
    const double k26 = kept[14];
    const double z75 = z72 * k26 + z57 * k28;
    kept[113] = z75;
    const double z76 = z58 * k26 - z57 * k27;
    kept[114] = z76;
    const double z77 = k28 * z52 + (z43 * k26 - k27 * z60);
    kept[115] = z77;
    const double z78 = z52 * z71 + (z57 * z73 - (z60 * z74 - (z72 * z75 + (z58 * z76 + z43 * z77))));
    const double z62 = kept[100];
    const double z79 = z52 * z62 + (z63 * z66 + (z61 * z67 + (z65 * z68 + (z59 * z69 + (z64 * z70 + z78)))));
    const double z15 = kept[53];
    const double z16 = kept[54];
    const double z35 = kept[73];
    const double z40 = kept[78];
    const double z48 = kept[86];
    const double z54 = kept[92];
    const double z80 = z16 * z48 + z15 * z54 + z35 * z40;
    kept[116] = z80;
    const double z38 = kept[76];
    const double z81 = z38 * z80;
    const double z82 = z81 + z63;
    kept[117] = z82;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z83 = z79 + R_yy * (z57 * z57) + F_yy * (z82 * z82);
    kept[118] = z83;
    const double z8 = kept[46];
    const double z18 = kept[56];
    const double z84 = z18 * z8;
    kept[119] = z84;
    const double z30 = kept[68];
    const double z85 = z30 * z8;
    kept[120] = z85;
    const double z7 = kept[45];
    const double z86 = z15 * z84 + z7 * z85;
    kept[121] = z86;
    const double z87 = z38 * z86;
    kept[122] = z87;
    const double c_roll = kept[0];
    const double z88 = c_roll * z87;
    kept[123] = z88;
    const double c1 = kept[3];
    const double z89 = c1 * z88;
    kept[124] = z89;
    const double z90 = 1.0 + z89;
    kept[125] = z90;
    const double k10 = kept[9];
    const double z91 = k10 * z89;
    kept[126] = z91;
    const double z34 = kept[72];
    const double z92 = z34 * z8;
    kept[127] = z92;
    const double z93 = z16 * z84 - z7 * z92;
    kept[128] = z93;
    const double z94 = z38 * z93;
    const double e2z = kept[1];
    const double z95 = z94 - e2z * z87;
    kept[129] = z95;
    const double z20 = kept[58];
    const double z96 = z20 * z95;
    kept[130] = z96;
    const double z97 = c_steer * z91 - s_steer * z96;
    kept[131] = z97;
    const double s1 = kept[2];
    const double z98 = s1 * z88;
    kept[132] = z98;
    const double z99 = s_steer * z95 + c_steer * z98;
    kept[133] = z99;
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z100 = k63 * z90 + (k48 * z97 + k62 * z99);
    kept[134] = z100;
    const double z101 = c_steer * z95 - s_steer * z98;
    kept[135] = z101;
    const double z102 = c_steer * z96 + s_steer * z91;
    kept[136] = z102;
    const double z103 = z14 * z95;
    kept[137] = z103;
    const double z104 = k59 * z101 - (k45 * z102 - k48 * z103);
    kept[138] = z104;
    const double z105 = k56 * z90 + (k45 * z97 + k55 * z99);
    kept[139] = z105;
    const double z106 = k43 * z103 + k48 * z101;
    kept[140] = z106;
    const double z107 = k48 * z90 + (k43 * z97 + k45 * z99);
    kept[141] = z107;
    const double z108 = k43 * z102 - k45 * z101;
    kept[142] = z108;
    const double z109 = k40 * z98 + k41 * z89;
    kept[143] = z109;
    const double z110 = z13 * z95;
    kept[144] = z110;
    const double z111 = z95 * k37 - (z96 * k27 - z110 * k28);
    kept[145] = z111;
    const double z112 = k34 * z98 + k35 * z89;
    kept[146] = z112;
    const double z113 = z96 * k26 - z95 * k27;
    kept[147] = z113;
    const double z114 = z110 * k26 + z95 * k28;
    kept[148] = z114;
    const double z115 = z102 * z108 + (z89 * z109 + (z95 * z111 + (z98 * z112 + (z96 * z113 + z110 * z114))));
    const double z116 = z90 * z100 + (z101 * z104 + (z99 * z105 + (z103 * z106 + (z97 * z107 + z115)))) +
        R_yy * (z95 * z95);
    const double z117 = z16 * z85 + z15 * z92;
    kept[149] = z117;
    const double z118 = z38 * z117;
    const double z119 = z118 + z101;
    kept[150] = z119;
    const double z120 = z116 + F_yy * (z119 * z119);
    kept[151] = z120;
    const double z121 = z102 * z70 + (z89 * z71 + (z95 * z73 + (z98 * z74 + (z96 * z76 + z110 * z75))));
    const double z122 = z90 * z62 + (z101 * z66 + (z99 * z67 + (z103 * z68 + (z97 * z69 + z121)))) + R_yy *
        (z57 * z95);
    const double z123 = z122 + F_yy * (z82 * z119);
    const double z124 = 1.0 / z83;
    kept[152] = z124;
    const double z125 = z123 * z124;
    kept[153] = z125;
    const double z126 = z120 - z123 * z125;
    kept[154] = z126;
    const double z127 = s_steer * z20;
    kept[155] = z127;
    const double z128 = z18 * z127;
    kept[156] = z128;
    const double z129 = c_steer * z20;
    kept[157] = z129;
    const double z23 = kept[61];
    const double z130 = z30 * z127 - z129 * z23;
    kept[158] = z130;
    const double z24 = kept[62];
    const double z131 = z13 * z24 - z15 * z128 - z7 * z130;
    kept[159] = z131;
    const double z132 = z38 * z131;
    kept[160] = z132;
    const double z133 = c_roll * z132;
    kept[161] = z133;
    const double z134 = c1 * z133;
    kept[162] = z134;
    const double z135 = k10 * z134;
    kept[163] = z135;
    const double z28 = kept[66];
    const double z136 = z129 * z28 + z34 * z127;
    kept[164] = z136;
    const double z29 = kept[67];
    const double z137 = z16 * z128 - z13 * z29 - z7 * z136;
    kept[165] = z137;
    const double z138 = z38 * z137;
    const double z139 = z138 + e2z * z132;
    kept[166] = z139;
    const double z140 = 1.0 - z139;
    kept[167] = z140;
    const double z141 = z20 * z140;
    kept[168] = z141;
    const double z142 = c_steer * z135 - s_steer * z141;
    kept[169] = z142;
    const double z143 = s1 * z133;
    kept[170] = z143;
    const double z144 = s_steer * z139 - c_steer * z143;
    kept[171] = z144;
    const double z145 = k63 * z134 + (k48 * z142 - k62 * z144);
    kept[172] = z145;
    const double z146 = c_steer * z139 + s_steer * z143;
    kept[173] = z146;
    const double z147 = c_steer * z141 + s_steer * z135;
    kept[174] = z147;
    const double z148 = z13 * z140;
    kept[175] = z148;
    const double z149 = z148 - k10 * z139;
    kept[176] = z149;
    const double z150 = k59 * z146 + (k45 * z147 - k48 * z149);
    kept[177] = z150;
    const double z151 = k56 * z134 + (k45 * z142 - k55 * z144);
    kept[178] = z151;
    const double z152 = k43 * z149 - k48 * z146;
    kept[179] = z152;
    const double z153 = k48 * z134 + (k43 * z142 - k45 * z144);
    kept[180] = z153;
    const double z154 = k43 * z147 + k45 * z146;
    kept[181] = z154;
    const double z155 = k40 * z143 + k41 * z134;
    kept[182] = z155;
    const double z156 = z139 * k37 + (z141 * k27 - z148 * k28);
    kept[183] = z156;
    const double z157 = k34 * z143 + k35 * z134;
    kept[184] = z157;
    const double z158 = z141 * k26 + z139 * k27;
    kept[185] = z158;
    const double z159 = z148 * k26 - z139 * k28;
    kept[186] = z159;
    const double z160 = z147 * z154 + (z134 * z155 + (z139 * z156 + (z143 * z157 + (z141 * z158 + z148 *
        z159))));
    const double z161 = z134 * z145 + (z146 * z150 - (z144 * z151 - (z149 * z152 + (z142 * z153 + z160)))) +
        R_yy * (z140 * z140);
    const double z162 = z16 * z130 + z15 * z136 - z13 * z35;
    kept[187] = z162;
    const double z163 = z38 * z162;
    const double z164 = z163 + z146;
    kept[188] = z164;
    const double z165 = z161 + F_yy * (z164 * z164);
    kept[189] = z165;
    const double z166 = z147 * z70 + (z134 * z71 - (z139 * z73 - (z143 * z74 + (z141 * z76 + z148 * z75))));
    const double z167 = z134 * z62 - (z146 * z66 + (z144 * z67 - (z149 * z68 + (z142 * z69 + z166)))) + R_yy
        * (z57 * z140);
    const double z168 = z167 - F_yy * (z82 * z164);
    const double z169 = z168 * z124;
    kept[190] = z169;
    const double z170 = z147 * z108 + (z134 * z109 - (z139 * z111 - (z143 * z112 + (z141 * z113 + z148 *
        z114))));
    const double z171 = z134 * z100 - (z146 * z104 + (z144 * z105 - (z149 * z106 + (z142 * z107 + z170)))) +
        R_yy * (z95 * z140);
    const double z172 = z171 - F_yy * (z119 * z164) - z123 * z169;
    const double z173 = 1.0 / z126;
    kept[191] = z173;
    const double z174 = z172 * z173;
    kept[192] = z174;
    const double z175 = z165 - z168 * z169 - z172 * z174;
    kept[193] = z175;
    const double z176 = s1 * z58 - c1 * z72;
    const double z177 = e2z * z176 + c_roll * z43;
    const double z178 = s1 * z72 + c1 * z58;
    const double s_yaw = kept[6];
    const double c_yaw = kept[7];
    /* (I.2.15) */
    J[9] = c_yaw * z178 - s_yaw * z177;
    const double z179 = s1 * z96 - c1 * z110;
    const double z180 = e2z * z179;
    const double z181 = s1 * z110 + c1 * z96;
    J[10] = c_yaw * z181 - s_yaw * z180;
    const double z182 = s1 * z141 - c1 * z148;
    const double z183 = e2z * z182;
    const double z184 = s1 * z148 + c1 * z141;
    J[11] = s_yaw * z183 - c_yaw * z184;
    J[21] = s_yaw * z178 + c_yaw * z177;
    J[22] = s_yaw * z181 + c_yaw * z180;
    J[23] = -(s_yaw * z184 + c_yaw * z183);
    J[33] = e2z * z43 - c_roll * z176;
    J[34] = -c_roll * z179;
    J[35] = c_roll * z182;
    const double z50 = kept[88];
    J[45] = z50;
    J[46] = z87;
    J[47] = -z132;
    J[57] = 1.0;
    const double z56 = kept[94];
    J[69] = -z56;
    J[70] = -z94;
    J[71] = -z138;
    J[82] = 1.0;
    J[95] = 1.0;
    J[105] = -z81;
    J[106] = -z118;
    J[107] = -z163;
    const double z11 = kept[49];
    const double z185 = z11 * z11;
    kept[194] = z185;
    const double roll_dot = y[9];
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z186 = roll_dot * r_R;
    kept[195] = z186;
    const double z187 = c_roll * z186;
    kept[196] = z187;
    const double z5 = kept[43];
    const double z188 = z5 * z5;
    kept[197] = z188;
    const double v2_x = z11 * z187;
    kept[198] = v2_x;
    const double z189 = z38 * z38;
    kept[199] = z189;
    const double z190 = roll_dot * c1;
    kept[200] = z190;
    const double z191 = s_steer * z190;
    kept[201] = z191;
    const double z192 = roll_dot * s1;
    kept[202] = z192;
    const double steer_dot = y[10];
    const double z193 = steer_dot + z192;
    kept[203] = z193;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part3(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)J;
    (void)t;
    const double c_steer = kept[5];
    const double z190 = kept[200];
    const double z194 = c_steer * z190;
    kept[204] = z194;
    const double thR_dot = y[11];
    const double z20 = kept[58];
    const double z195 = thR_dot * z20;
    kept[205] = z195;
    const double k10 = kept[9];
    const double v2_x = kept[198];
    const double z192 = kept[202];
    const double z196 = v2_x + k10 * z192;
    kept[206] = z196;
    const double k4 = kept[8];
    const double z7 = kept[45];
    const double z13 = kept[51];
    const double z191 = kept[201];
    const double z197 = z7 * z191 + (k4 * z191 - thR_dot * z13);
    kept[207] = z197;
    const double s_steer = kept[4];
    const double k16 = kept[10];
    const double z18 = kept[56];
    const double z193 = kept[203];
    const double z198 = z7 * z193 - z18 * z194 - (k16 * z194 - k4 * z193 - (s_steer * z195 + c_steer * z196));
    kept[208] = z198;
    const double z199 = z18 * z198;
    kept[209] = z199;
    const double z200 = z18 * z191 + (k16 * z191 - (s_steer * z196 - c_steer * z195));
    kept[210] = z200;
    const double z23 = kept[61];
    const double z30 = kept[68];
    const double z201 = z30 * z198 - z23 * z200;
    kept[211] = z201;
    const double z15 = kept[53];
    const double z24 = kept[62];
    const double z202 = z24 * z197 + z15 * z199 + z7 * z201;
    kept[212] = z202;
    const double z28 = kept[66];
    const double z34 = kept[72];
    const double z203 = z28 * z200 + z34 * z198;
    kept[213] = z203;
    const double z16 = kept[54];
    const double z29 = kept[67];
    const double z204 = z16 * z199 + z29 * z197 - z7 * z203;
    kept[214] = z204;
    const double z35 = kept[73];
    const double z205 = z16 * z201 + z15 * z203 + z35 * z197;
    kept[215] = z205;
    const double z38 = kept[76];
    const double z206 = z38 * z202;
    kept[216] = z206;
    const double z207 = z38 * z204;
    kept[217] = z207;
    const double e2z = kept[1];
    const double z208 = z207 - e2z * z206;
    kept[218] = z208;
    const double z209 = thR_dot - z208;
    kept[219] = z209;
    const double z210 = z20 * z209;
    kept[220] = z210;
    const double z211 = z13 * z209;
    kept[221] = z211;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const double z212 = s1 * z210 - c1 * z211;
    kept[222] = z212;
    const double c_roll = kept[0];
    const double z213 = c_roll * v2_x - e2z * z212;
    kept[223] = z213;
    const double z214 = s1 * z211 + c1 * z210;
    kept[224] = z214;
    const double z175 = kept[193];
    const double z271 = 1.0 / z175;
    kept[225] = z271;
    const double roll_dot = y[9];
    const double z272 = roll_dot * e2z;
    kept[226] = z272;
    const double z273 = s1 * z207;
    kept[227] = z273;
    const double z274 = z272 * c1 - c_roll * z273;
    kept[228] = z274;
    const double z275 = roll_dot * c_roll;
    kept[229] = z275;
    const double steer_dot = y[10];
    const double z276 = steer_dot * c_steer;
    kept[230] = z276;
    const double z277 = steer_dot * s_steer;
    kept[231] = z277;
    const double z278 = c1 * z207;
    kept[232] = z278;
    const double z279 = z272 * s1 + c_roll * z278;
    kept[233] = z279;
    const double z3 = kept[41];
    const double z280 = s_steer * z275 + e2z * z276 + (z277 * z3 + c_steer * z279);
    kept[234] = z280;
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z281 = z2 * z274 - z4 * z280;
    kept[235] = z281;
    const double z5 = kept[43];
    const double z282 = z5 * z281;
    kept[236] = z282;
    const double z188 = kept[197];
    const double z283 = z188 * z282;
    kept[237] = z283;
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z284 = r_F * z280;
    kept[238] = z284;
    const double z6 = kept[44];
    const double z285 = z6 * z283 + z5 * z284;
    kept[239] = z285;
    const double z286 = roll_dot * z278;
    kept[240] = z286;
    const double z287 = r_F * z274;
    kept[241] = z287;
    const double z17 = kept[55];
    const double z288 = z17 * z283 - z5 * z287;
    kept[242] = z288;
    const double z289 = roll_dot * z273;
    kept[243] = z289;
    const double z290 = z277 * z190 - c_steer * z289;
    kept[244] = z290;
    const double z291 = c_roll * z272;
    kept[245] = z291;
    const double z11 = kept[49];
    const double z292 = z11 * z291;
    kept[246] = z292;
    const double z185 = kept[194];
    const double z293 = z292 * z185;
    kept[247] = z293;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z294 = r_R * z274;
    kept[248] = z294;
    const double z19 = kept[57];
    const double z295 = z19 * z293 - z11 * z294;
    kept[249] = z295;
    const double z296 = thR_dot * z295;
    kept[250] = z296;
    const double z186 = kept[195];
    const double z297 = z272 * z186;
    kept[251] = z297;
    const double z187 = kept[196];
    const double z298 = z187 * z293 - z11 * z297 - k10 * z286;
    kept[252] = z298;
    const double z299 = k16 * z290 - k4 * z286 + (z276 * z195 + s_steer * z296 - (z277 * z196 - c_steer *
        z298));
    const double z21 = kept[59];
    const double z300 = z277 * z21 - c_steer * z288;
    kept[253] = z300;
    const double z301 = z277 * k10 - z285;
    kept[254] = z301;
    const double z25 = kept[63];
    const double z26 = kept[64];
    const double z302 = z25 * z278 + s1 * z300 - (z26 * z273 - c1 * z301);
    kept[255] = z302;
    const double z303 = z295 - z288;
    kept[256] = z303;
    const double z22 = kept[60];
    const double z304 = z276 * z22 + s_steer * z303;
    kept[257] = z304;
    const double z27 = kept[65];
    const double z305 = z272 * z27 + c_roll * z302 - (z275 * z23 + e2z * z304);
    kept[258] = z305;
    const double z306 = z193 * z285 - z7 * z286 - (z194 * z288 - z18 * z290) + z299 - (z206 * z305 + z207 *
        z304);
    kept[259] = z306;
    const double z307 = z276 * z190 + s_steer * z289;
    kept[260] = z307;
    const double z308 = z191 * z288 + z18 * z307 + (k16 * z307 - (z276 * z196 + s_steer * z298 + (z277 * z195
        - c_steer * z296)));
    const double z309 = z38 * z205;
    kept[261] = z309;
    const double z310 = z276 * z21 + s_steer * z288;
    kept[262] = z310;
    const double z311 = z276 * k10;
    kept[263] = z311;
    const double z31 = kept[69];
    const double z32 = kept[70];
    const double z312 = z31 * z278 - s1 * z310 - (c1 * z311 + z32 * z273);
    kept[264] = z312;
    const double z313 = z277 * z22 - c_steer * z303;
    kept[265] = z313;
    const double z33 = kept[71];
    const double z314 = z272 * z33 + c_roll * z312 + (z275 * z30 - e2z * z313);
    kept[266] = z314;
    const double z315 = z308 + (z309 * z288 + (z206 * z314 + z207 * z313));
    kept[267] = z315;
    const double z316 = z30 * z306 - z23 * z315;
    kept[268] = z316;
    const double z317 = z28 * z315 + z34 * z306;
    kept[269] = z317;
    const double z318 = r_R * z279;
    kept[270] = z318;
    const double z12 = kept[50];
    const double z319 = z12 * z293 - z11 * z318;
    kept[271] = z319;
    const double z8 = kept[46];
    const double z320 = z276 * z8 + s_steer * z285;
    kept[272] = z320;
    const double z9 = kept[47];
    const double z321 = z9 * z278 - s1 * z320;
    kept[273] = z321;
    const double z322 = z319 - (z277 * z8 - c_steer * z285);
    kept[274] = z322;
    const double z10 = kept[48];
    const double z323 = z272 * z10 + c_roll * z321 - (z275 * z15 + e2z * z322);
    kept[275] = z323;
    const double z324 = z191 * z285 + z7 * z307 + (k4 * z307 - thR_dot * z319) + (z309 * z285 + (z206 * z323
        + z207 * z322));
    kept[276] = z324;
    const double z325 = z16 * z316 + z15 * z317 + z35 * z324;
    kept[277] = z325;
    const double z326 = z18 * z306;
    kept[278] = z326;
    const double z327 = z16 * z326 + z29 * z324 - z7 * z317;
    kept[279] = z327;
    const double z328 = z24 * z324 + z15 * z326 + z7 * z316;
    kept[280] = z328;
    const double z329 = z38 * z328;
    kept[281] = z329;
    const double z330 = z38 * z327 - (z275 * z206 + e2z * z329);
    kept[282] = z330;
    const double z331 = c_roll * z206;
    kept[283] = z331;
    const double z332 = z190 - s1 * z331;
    kept[284] = z332;
    const double z333 = z272 * z206 - c_roll * z329;
    kept[285] = z333;
    const double z334 = z289 + (z331 * z278 + s1 * z333);
    kept[286] = z334;
    const double z335 = z277 * z208 - c_steer * z330 - (z276 * z332 + s_steer * z334);
    const double z336 = z38 * z325 - z335;
    kept[287] = z336;
    const double z43 = kept[81];
    const double v2_x_2 = roll_dot * z43;
    kept[288] = v2_x_2;
    const double z337 = z192 + c1 * z331;
    kept[289] = z337;
    const double z338 = z209 * z295 - z20 * z330 - (z208 * z211 - v2_x_2 * z337);
    const double z339 = k10 * z208;
    kept[290] = z339;
    const double z340 = k10 * z337;
    kept[291] = z340;
    const double z341 = z338 + (z208 * z339 + z337 * z340);
    kept[292] = z341;
    const double z342 = r_R * z272;
    kept[293] = z342;
    const double z42 = kept[80];
    const double z343 = z11 * z342 - z42 * z293;
    kept[294] = z343;
    const double z344 = roll_dot * z343 + (z210 * z337 - z211 * z332);
    const double z345 = z286 - (z331 * z273 - c1 * z333);
    const double z346 = z344 + (k10 * z345 + z339 * z332);
    kept[295] = z346;
    const double z347 = c_steer * z341 + s_steer * z346;
    const double z348 = z209 * z319 - z13 * z330 - (v2_x_2 * z332 - z208 * z210);
    const double z349 = z348 - (k10 * z330 + z332 * z340);
    const double w3_steer = steer_dot + z337;
    kept[296] = w3_steer;
    const double z350 = s_steer * z208 - c_steer * z332;
    kept[297] = z350;
    const double k55 = kept[25];
    const double k56 = kept[26];
    const double z351 = k55 * z350 + k56 * w3_steer;
    kept[298] = z351;
    const double k62 = kept[28];
    const double k63 = kept[29];
    const double z352 = k62 * z350 + k63 * w3_steer;
    kept[299] = z352;
    const double k45 = kept[23];
    const double k48 = kept[24];
    const double k59 = kept[27];
    const double k70 = kept[33];
    const double k71 = kept[34];
    const double k73 = kept[36];
    const double k74 = kept[37];
    const double z353 = z4 * k71 + z2 * k70 + (z4 * k74 - z2 * k73) - (k59 * z335 - (k45 * z347 - k48 * z349)
        - (w3_steer * z351 - z350 * z352));
    kept[300] = z353;
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z354 = c_steer * z346 - s_steer * z341;
    const double z355 = z276 * z208 + s_steer * z330 + (z277 * z332 - c_steer * z334);
    const double z356 = c_steer * z208 + s_steer * z332;
    kept[301] = z356;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z357 = F_yy * (z309 + z356) + k59 * z356;
    kept[302] = z357;
    const double k75 = kept[38];
    const double z358 = h2z * k75 + (k56 * z345 + (k45 * z354 - k55 * z355) - (z356 * z352 - w3_steer *
        z357));
    kept[303] = z358;
    const double z359 = k45 * z350 + k48 * w3_steer;
    kept[304] = z359;
    const double z360 = k45 * z356;
    kept[305] = z360;
    const double k43 = kept[22];
    const double k72 = kept[35];
    const double z361 = z2 * k72 + (k43 * z349 + k48 * z335 + (z350 * z359 + z356 * z360));
    kept[306] = z361;
    const double z362 = k48 * z356;
    kept[307] = z362;
    const double z363 = h2z * k72 + (k48 * z345 + (k43 * z354 - k45 * z355) + (w3_steer * z360 - z350 *
        z362));
    kept[308] = z363;
    const double z364 = z4 * k72 + (k43 * z347 - k45 * z335 + (z356 * z362 + w3_steer * z359));
    kept[309] = z364;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double k37 = kept[19];
    const double z365 = R_yy * z209 - k37 * z208;
    kept[310] = z365;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z366 = k34 * z332 - k35 * z337;
    kept[311] = z366;
    const double k28 = kept[16];
    const double k40 = kept[20];
    const double k41 = kept[21];
    const double k68 = kept[31];
    const double z367 = e2z * k68 + (k41 * z345 + (k28 * z344 + k40 * z334) - (z332 * z365 + z208 * z366));
    kept[312] = z367;
    const double k76 = kept[39];
    const double z368 = h2z * k76 - (k63 * z345 + (k48 * z354 - k62 * z355) - (z350 * z357 - z356 * z351));
    kept[313] = z368;
    const double z369 = z367 - z368;
    kept[314] = z369;
    const double z370 = k40 * z332 - k41 * z337;
    kept[315] = z370;
    const double k27 = kept[15];
    const double k69 = kept[32];
    const double z371 = z3 * k69 + z2 * k68 - (k37 * z330 + (k27 * z338 - k28 * z348) - (z337 * z366 + z332 *
        z370));
    kept[316] = z371;
    const double z372 = e2z * k69 + (k35 * z345 + (k27 * z344 + k34 * z334) + (z208 * z370 - z337 * z365));
    kept[317] = z372;
    const double z373 = k27 * z332 - k28 * z337;
    kept[318] = z373;
    const double z374 = k27 * z208;
    kept[319] = z374;
    const double k26 = kept[14];
    const double k67 = kept[30];
    const double z375 = z2 * k67 + (k26 * z348 - k28 * z330 + (z332 * z373 + z208 * z374));
    kept[320] = z375;
    const double z376 = k28 * z208;
    kept[321] = z376;
    const double z377 = z3 * k67 - (k26 * z338 + k27 * z330 + (z208 * z376 - z337 * z373));
    kept[322] = z377;
    const double z378 = e2z * k67 + (k28 * z345 + (k26 * z344 + k27 * z334) + (z337 * z374 + z332 * z376));
    kept[323] = z378;
    const double z379 = z191 + z309;
    kept[324] = z379;
    const double z380 = z188 * z188;
    kept[325] = z380;
    const double z381 = z185 * (1.0 / c_roll);
    kept[326] = z381;
    const double z134 = kept[162];
    const double z139 = kept[166];
    const double z141 = kept[168];
    const double z143 = kept[170];
    const double z147 = kept[174];
    const double z148 = kept[175];
    const double z382 = z147 * z364 + (z134 * z367 - (z139 * z371 - (z143 * z372 - (z141 * z377 - z148 *
        z375))));
    const double z140 = kept[167];
    const double z142 = kept[169];
    const double z144 = kept[171];
    const double z146 = kept[173];
    const double z149 = kept[176];
    const double z383 = z134 * z368 - (z146 * z353 - (z144 * z358 - (z149 * z361 + (z142 * z363 + z382)))) +
        R_yy * (z140 * z330);
    const double z52 = kept[90];
    const double z57 = kept[95];
    const double z58 = kept[96];
    const double z60 = kept[98];
    const double z72 = kept[110];
    const double z384 = z52 * z367 + (z57 * z371 - (z60 * z372 - (z72 * z375 - (z58 * z377 - z43 * z378))));
    const double z59 = kept[97];
    const double z61 = kept[99];
    const double z63 = kept[101];
    const double z64 = kept[102];
    const double z65 = kept[103];
    const double z385 = z52 * z368 + (z63 * z353 - (z61 * z358 + (z65 * z361 + (z59 * z363 + (z64 * z364 +
        z384)))));
    const double z82 = kept[117];
    const double z386 = z385 + R_yy * (z57 * z330) + F_yy * (z82 * z336);
    const double z89 = kept[124];
    const double z95 = kept[129];
    const double z96 = kept[130];
    const double z98 = kept[132];
    const double z102 = kept[136];
    const double z110 = kept[144];
    const double z387 = z102 * z364 + (z89 * z367 + (z95 * z371 + (z98 * z372 - (z96 * z377 - z110 * z375))));
    const double z90 = kept[125];
    const double z97 = kept[131];
    const double z99 = kept[133];
    const double z101 = kept[135];
    const double z103 = kept[137];
    const double z388 = z90 * z368 + (z101 * z353 - (z99 * z358 + (z103 * z361 + (z97 * z363 + z387)))) +
        R_yy * (z95 * z330);
    const double z119 = kept[150];
    const double z125 = kept[153];
    const double z389 = z388 + F_yy * (z119 * z336) - z386 * z125;
    const double z164 = kept[188];
    const double z169 = kept[190];
    const double z174 = kept[192];
    const double z390 = z271 * (z383 - F_yy * (z164 * z336) - z386 * z169 - z174 * z389);
    kept[327] = z390;
    const double z173 = kept[191];
    const double z391 = z173 * z389 - z174 * z390;
    kept[328] = z391;
    const double z124 = kept[152];
    const double z392 = z386 * z124 - z125 * z391 - z169 * z390;
    kept[329] = z392;
    const double k22 = kept[11];
    const double k24 = kept[12];
    const double k25 = kept[13];
    const double z36 = kept[74];
    const double z37 = kept[75];
    /* the coframe is singular */
    if (!(fabs(z36) > 1e-15 * ((z37 + k25) * (k22 * (z37 + k24))))) {
        return bicycle_refuse(fabs(z36), 1e-15 * ((z37 + k25) * (k22 * (z37 + k24))), BICYCLE_SINGULAR_1);
    }
    const double z83 = kept[118];
    /* the mass matrix is singular */
    if (!(fabs(z83) > 0.0)) {
        return bicycle_refuse(fabs(z83), 0.0, BICYCLE_SINGULAR_2);
    }
    const double z120 = kept[151];
    const double z126 = kept[154];
    /* the mass matrix is singular */
    if (!(fabs(z126) > 1e-14 * z120)) {
        return bicycle_refuse(fabs(z126), 1e-14 * z120, BICYCLE_SINGULAR_2);
    }
    const double z165 = kept[189];
    /* the mass matrix is singular */
    if (!(fabs(z175) > 1e-14 * z165)) {
        return bicycle_refuse(fabs(z175), 1e-14 * z165, BICYCLE_SINGULAR_2);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW static void bicycle_jacobian_sweep1(double t, const double *y, const double *p, const double
    *kept, const double *seed, double *slope)
{
    (void)t;
    const double c_yaw = kept[7];
    const bicycle_lanes turn_3 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes z215 = c_yaw * turn_3;
    const double e2z = kept[1];
    const bicycle_lanes turn_4 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z216 = e2z * turn_4;
    const double c_roll = kept[0];
    const double z11 = kept[49];
    const double z185 = kept[194];
    const bicycle_lanes z217 = z185 * (z11 * (c_roll * z216));
    const double z186 = kept[195];
    const double z187 = kept[196];
    const bicycle_lanes z218 = z187 * z217 - z11 * (z186 * z216);
    const bicycle_lanes z219 = c_roll * turn_4;
    const double c1 = kept[3];
    const bicycle_lanes turn_5 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z220 = c1 * turn_5;
    const double s1 = kept[2];
    const bicycle_lanes z221 = s1 * turn_5;
    const bicycle_lanes z222 = c1 * z216 + c_roll * z221;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z19 = kept[57];
    const bicycle_lanes z223 = z19 * z217 - z11 * (r_R * z222);
    const double c_steer = kept[5];
    const bicycle_lanes turn_6 = bicycle_get(seed + 3 * BICYCLE_LANES);
    const bicycle_lanes z224 = c_steer * turn_6;
    const double s_steer = kept[4];
    const bicycle_lanes z225 = s_steer * turn_6;
    const bicycle_lanes z226 = s1 * z216 - c_roll * z220;
    const double z3 = kept[41];
    const bicycle_lanes z227 = s_steer * z219 + e2z * z224 + (z3 * z225 + c_steer * z226);
    const double z2 = kept[40];
    const double z4 = kept[42];
    const double z5 = kept[43];
    const double z188 = kept[197];
    const bicycle_lanes z228 = z188 * (z5 * (z2 * z222 - z4 * z227));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z6 = kept[44];
    const bicycle_lanes z229 = z6 * z228 + z5 * (r_F * z227);
    const double z12 = kept[50];
    const bicycle_lanes z230 = z12 * z217 - z11 * (r_R * z226);
    const double z8 = kept[46];
    const bicycle_lanes z231 = z230 - (z8 * z225 - c_steer * z229);
    const double z9 = kept[47];
    const double z10 = kept[48];
    const double z15 = kept[53];
    const bicycle_lanes z232 = z10 * z216 - c_roll * (z9 * z220 + s1 * (z8 * z224 + s_steer * z229)) - (z15 *
        z219 + e2z * z231);
    const double z17 = kept[55];
    const bicycle_lanes z233 = z17 * z228 - z5 * (r_F * z222);
    const bicycle_lanes z234 = z223 - z233;
    const double z22 = kept[60];
    const bicycle_lanes z235 = z22 * z224 + s_steer * z234;
    const double z18 = kept[56];
    const double z23 = kept[61];
    const bicycle_lanes z236 = z23 * z233 + z18 * z235;
    const double k10 = kept[9];
    const double z21 = kept[59];
    const double z25 = kept[63];
    const double z26 = kept[64];
    const bicycle_lanes z237 = z25 * z220 - s1 * (z21 * z225 - c_steer * z233) - (z26 * z221 - c1 * (z229 -
        k10 * z225));
    const double z27 = kept[65];
    const bicycle_lanes z238 = z27 * z216 - c_roll * z237 - (z23 * z219 + e2z * z235);
    const double z28 = kept[66];
    const bicycle_lanes z239 = z28 * z233 - z18 * z238;
    const bicycle_lanes z240 = z22 * z225 - c_steer * z234;
    const double z31 = kept[69];
    const double z32 = kept[70];
    const bicycle_lanes z241 = z31 * z220 + s1 * (z21 * z224 + s_steer * z233) - (z32 * z221 - c1 * (k10 *
        z224));
    const double z30 = kept[68];
    const double z33 = kept[71];
    const bicycle_lanes z242 = z33 * z216 - c_roll * z241 + (z30 * z219 - e2z * z240);
    const double z34 = kept[72];
    const bicycle_lanes z243 = z28 * z240 + z30 * z238 + (z23 * z242 - z34 * z235);
    const double z7 = kept[45];
    const double z16 = kept[54];
    const double z24 = kept[62];
    const double z29 = kept[67];
    const double z35 = kept[73];
    const bicycle_lanes z244 = z24 * z232 - z16 * z236 + (z29 * z231 + z15 * z239) + (z35 * z229 - z7 * z243);
    const double z189 = kept[199];
    const bicycle_lanes z245 = z189 * z244;
    const double roll_dot = y[9];
    const bicycle_lanes z246 = roll_dot * z220;
    const bicycle_lanes z247 = roll_dot * z221;
    const double z190 = kept[200];
    const bicycle_lanes z248 = z190 * z225 + c_steer * z247;
    const double thR_dot = y[11];
    const bicycle_lanes z249 = thR_dot * z223;
    const bicycle_lanes z250 = z218 + k10 * z246;
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z195 = kept[205];
    const double z196 = kept[206];
    const bicycle_lanes z251 = k16 * z248 + k4 * z246 + (z195 * z224 + s_steer * z249 - (z196 * z225 -
        c_steer * z250));
    const double z193 = kept[203];
    const double z194 = kept[204];
    const bicycle_lanes z252 = z193 * z229 + z7 * z246 - (z194 * z233 - z18 * z248) + z251;
    const double z198 = kept[208];
    const bicycle_lanes z253 = z198 * z233 + z18 * z252;
    const bicycle_lanes z254 = z190 * z224 - s_steer * z247;
    const double z191 = kept[201];
    const bicycle_lanes z255 = z191 * z229 + z7 * z254 + (k4 * z254 - thR_dot * z230);
    const bicycle_lanes z256 = z191 * z233 + z18 * z254 + (k16 * z254 - (z196 * z224 + s_steer * z250 + (z195
        * z225 - c_steer * z249)));
    const double z200 = kept[210];
    const bicycle_lanes z257 = z200 * z238 - z28 * z256 + (z198 * z242 - z34 * z252);
    const double z197 = kept[207];
    const double z199 = kept[209];
    const double z203 = kept[213];
    const bicycle_lanes z258 = z199 * z232 - z16 * z253 - (z197 * z239 + z29 * z255) + (z203 * z229 - z7 *
        z257);
    const double z38 = kept[76];
    const double z204 = kept[214];
    const bicycle_lanes z259 = z204 * z245 - z38 * z258;
    const bicycle_lanes z260 = z198 * z240 - z30 * z252 + (z200 * z235 + z23 * z256);
    const double z201 = kept[211];
    const bicycle_lanes z261 = z197 * z236 + z24 * z255 + (z199 * z231 + z15 * z253) + (z201 * z229 - z7 *
        z260);
    const double z202 = kept[212];
    const bicycle_lanes z262 = z202 * z245 + z38 * z261;
    const double z206 = kept[216];
    const bicycle_lanes z263 = z259 - (z206 * z219 + e2z * z262);
    const double z20 = kept[58];
    const double z209 = kept[219];
    const bicycle_lanes z264 = z209 * z223 - z20 * z263;
    const double z13 = kept[51];
    const bicycle_lanes z265 = z209 * z230 - z13 * z263;
    const double z210 = kept[220];
    const double z211 = kept[221];
    const bicycle_lanes z266 = z210 * z220 + s1 * z264 + (z211 * z221 - c1 * z265);
    const double v2_x = kept[198];
    const double z212 = kept[222];
    const bicycle_lanes z267 = v2_x * z216 - c_roll * z218 + (z212 * z219 + e2z * z266);
    const double s_yaw = kept[6];
    const bicycle_lanes z268 = s_yaw * turn_3;
    const bicycle_lanes z269 = z211 * z220 + s1 * z265 - (z210 * z221 - c1 * z264);
    const double z213 = kept[223];
    const double z214 = kept[224];
    bicycle_put(slope + 0 * BICYCLE_LANES, z214 * z268 - c_yaw * z269 - (z213 * z215 - s_yaw * z267));
    bicycle_put(slope + 1 * BICYCLE_LANES, -(z214 * z215 + s_yaw * z269 + (z213 * z268 + c_yaw * z267)));
    bicycle_put(slope + 2 * BICYCLE_LANES, v2_x * z219 + e2z * z218 - (z212 * z216 - c_roll * z266));
    bicycle_put(slope + 3 * BICYCLE_LANES, z262);
    bicycle_put(slope + 4 * BICYCLE_LANES, -z259);
    const bicycle_lanes z270 = z201 * z232 + z16 * z260 - (z203 * z231 - z15 * z257) + (z197 * z243 - z35 *
        z255);
    const double z205 = kept[215];
    bicycle_put(slope + 5 * BICYCLE_LANES, z38 * z270 - z205 * z245);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part1(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)slope;
    (void)t;
    const double z125 = kept[153];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z393 = row_1 - z125 * row_0;
    const double z169 = kept[190];
    const double z174 = kept[192];
    const double z271 = kept[225];
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z394 = z271 * (row_2 + z169 * row_0 + z174 * z393);
    bicycle_put(carried + 0 * BICYCLE_LANES, z394);
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z395 = R_yy * z394;
    bicycle_put(carried + 1 * BICYCLE_LANES, z395);
    const double z173 = kept[191];
    const bicycle_lanes z396 = z173 * z393 + z174 * z394;
    bicycle_put(carried + 2 * BICYCLE_LANES, z396);
    const bicycle_lanes z397 = R_yy * z396;
    bicycle_put(carried + 3 * BICYCLE_LANES, z397);
    const double z124 = kept[152];
    const bicycle_lanes z398 = z124 * row_0 - z125 * z396 + z169 * z394;
    bicycle_put(carried + 4 * BICYCLE_LANES, z398);
    const bicycle_lanes z399 = R_yy * z398;
    bicycle_put(carried + 5 * BICYCLE_LANES, z399);
    const double z57 = kept[95];
    const double z95 = kept[129];
    const double z139 = kept[166];
    const bicycle_lanes z400 = z139 * z394 + z95 * z396 + z57 * z398;
    bicycle_put(carried + 6 * BICYCLE_LANES, z400);
    const double z72 = kept[110];
    const double z110 = kept[144];
    const double z148 = kept[175];
    const bicycle_lanes z401 = z148 * z394 - z110 * z396 - z72 * z398;
    bicycle_put(carried + 7 * BICYCLE_LANES, z401);
    const double z58 = kept[96];
    const double z96 = kept[130];
    const double z141 = kept[168];
    const bicycle_lanes z402 = z141 * z394 - z96 * z396 - z58 * z398;
    bicycle_put(carried + 8 * BICYCLE_LANES, z402);
    const double k27 = kept[15];
    const double k28 = kept[16];
    const double k37 = kept[19];
    const double z140 = kept[167];
    const bicycle_lanes z403 = z140 * z395 - z95 * z397 - z57 * z399 - k37 * z400 + k28 * z401 - k27 * z402;
    const double z63 = kept[101];
    const double z101 = kept[135];
    const double z146 = kept[173];
    const bicycle_lanes z404 = z146 * z394 + z101 * z396 + z63 * z398;
    bicycle_put(carried + 9 * BICYCLE_LANES, z404);
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z149 = kept[176];
    const bicycle_lanes z405 = z149 * z394 - z103 * z396 - z65 * z398;
    bicycle_put(carried + 10 * BICYCLE_LANES, z405);
    const double k43 = kept[22];
    const double k48 = kept[24];
    const bicycle_lanes z406 = k48 * z404 - k43 * z405;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const bicycle_lanes z407 = F_yy * z394;
    const bicycle_lanes z408 = F_yy * z396;
    const bicycle_lanes z409 = F_yy * z398;
    bicycle_put(carried + 11 * BICYCLE_LANES, z409);
    const double z82 = kept[117];
    const double z119 = kept[150];
    const double z164 = kept[188];
    const bicycle_lanes z410 = z164 * z407 + z119 * z408 + z82 * z409;
    bicycle_put(carried + 12 * BICYCLE_LANES, z410);
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z147 = kept[174];
    const bicycle_lanes z411 = z147 * z394 - z102 * z396 - z64 * z398;
    bicycle_put(carried + 13 * BICYCLE_LANES, z411);
    const double k45 = kept[23];
    const double k59 = kept[27];
    const bicycle_lanes z412 = z410 + (k59 * z404 - k48 * z405 + k45 * z411);
    bicycle_put(carried + 14 * BICYCLE_LANES, z412);
    const double z134 = kept[162];
    const bicycle_lanes z413 = z134 * z394;
    const double z52 = kept[90];
    const bicycle_lanes z414 = z52 * z398;
    const double z90 = kept[125];
    const bicycle_lanes z415 = z413 - z90 * z396 - z414;
    bicycle_put(carried + 15 * BICYCLE_LANES, z415);
    const double z61 = kept[99];
    const double z99 = kept[133];
    const double z144 = kept[171];
    const bicycle_lanes z416 = z144 * z394 + z99 * z396 + z61 * z398;
    bicycle_put(carried + 16 * BICYCLE_LANES, z416);
    const double z59 = kept[97];
    const double z97 = kept[131];
    const double z142 = kept[169];
    const bicycle_lanes z417 = z142 * z394 - z97 * z396 - z59 * z398;
    bicycle_put(carried + 17 * BICYCLE_LANES, z417);
    const double k55 = kept[25];
    const double k62 = kept[28];
    const bicycle_lanes z418 = k62 * z415 - k55 * z416 + k45 * z417;
    bicycle_put(carried + 18 * BICYCLE_LANES, z418);
    const double k26 = kept[14];
    const bicycle_lanes z419 = z406 + (k28 * z400 - k26 * z401);
    bicycle_put(carried + 19 * BICYCLE_LANES, z419);
    const bicycle_lanes z420 = k48 * z415 - k45 * z416 + k43 * z417;
    bicycle_put(carried + 20 * BICYCLE_LANES, z420);
    const bicycle_lanes z421 = k45 * z404 + k43 * z411;
    bicycle_put(carried + 21 * BICYCLE_LANES, z421);
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const bicycle_lanes z422 = s_steer * z420 - c_steer * z421;
    const bicycle_lanes z423 = k27 * z400 + k26 * z402 - z422;
    bicycle_put(carried + 22 * BICYCLE_LANES, z423);
    const double k10 = kept[9];
    const double z13 = kept[51];
    const double z20 = kept[58];
    const bicycle_lanes z424 = z403 - k10 * z406 - c_steer * z412 + s_steer * z418 - z13 * z419 + z20 * z423;
    bicycle_put(carried + 23 * BICYCLE_LANES, z424);
    const double z38 = kept[76];
    const bicycle_lanes z425 = z38 * z410;
    bicycle_put(carried + 24 * BICYCLE_LANES, z425);
    const bicycle_lanes z426 = z38 * z424;
    bicycle_put(carried + 25 * BICYCLE_LANES, z426);
    const double z89 = kept[124];
    const bicycle_lanes z427 = z413 - z89 * z396 - z414;
    bicycle_put(carried + 26 * BICYCLE_LANES, z427);
    const double z60 = kept[98];
    const double z98 = kept[132];
    const double z143 = kept[170];
    const bicycle_lanes z428 = z143 * z394 - z98 * z396 + z60 * z398;
    bicycle_put(carried + 27 * BICYCLE_LANES, z428);
    const double z43 = kept[81];
    const bicycle_lanes z429 = z43 * z398;
    bicycle_put(carried + 28 * BICYCLE_LANES, z429);
    const double k34 = kept[17];
    const double k40 = kept[20];
    const bicycle_lanes z430 = k40 * z427 + k34 * z428 - k27 * z429 + s_steer * z412 + c_steer * z418;
    bicycle_put(carried + 29 * BICYCLE_LANES, z430);
    const double k35 = kept[18];
    const double k41 = kept[21];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const bicycle_lanes z431 = k63 * z415 - k56 * z416 + k48 * z417 + k41 * z427 + k35 * z428 - k28 * z429;
    const bicycle_lanes z432 = c_steer * z420 + s_steer * z421;
    const bicycle_lanes z433 = z431 + k10 * z432;
    bicycle_put(carried + 30 * BICYCLE_LANES, z433);
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z434 = s1 * z430 + c1 * z433;
    bicycle_put(carried + 31 * BICYCLE_LANES, z434);
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z435 = c_roll * z434 - e2z * z424;
    bicycle_put(carried + 32 * BICYCLE_LANES, z435);
    const bicycle_lanes z436 = z38 * z435;
    bicycle_put(carried + 33 * BICYCLE_LANES, z436);
    const double z24 = kept[62];
    const double z29 = kept[67];
    const double z35 = kept[73];
    const bicycle_lanes z437 = z35 * z425 - z29 * z426 - z24 * z436;
    bicycle_put(carried + 34 * BICYCLE_LANES, z437);
    const double z206 = kept[216];
    const bicycle_lanes z438 = z206 * z437;
    bicycle_put(carried + 35 * BICYCLE_LANES, z438);
    const double z7 = kept[45];
    const double z15 = kept[53];
    const bicycle_lanes z439 = z15 * z425 + z7 * z426;
    bicycle_put(carried + 36 * BICYCLE_LANES, z439);
    const double z16 = kept[54];
    const bicycle_lanes z440 = z16 * z425 - z7 * z436;
    bicycle_put(carried + 37 * BICYCLE_LANES, z440);
    const bicycle_lanes z441 = z16 * z426 + z15 * z436;
    bicycle_put(carried + 38 * BICYCLE_LANES, z441);
    const double z18 = kept[56];
    const double z30 = kept[68];
    const double z34 = kept[72];
    const bicycle_lanes z442 = z34 * z439 + z30 * z440 - z18 * z441;
    bicycle_put(carried + 39 * BICYCLE_LANES, z442);
    const bicycle_lanes z443 = z206 * z442;
    bicycle_put(carried + 40 * BICYCLE_LANES, z443);
    const double z23 = kept[61];
    const double z28 = kept[66];
    const bicycle_lanes z444 = z28 * z439 - z23 * z440;
    bicycle_put(carried + 41 * BICYCLE_LANES, z444);
    const bicycle_lanes z445 = z206 * z444;
    bicycle_put(carried + 42 * BICYCLE_LANES, z445);
    const double z207 = kept[217];
    const bicycle_lanes z446 = z207 * z437 - e2z * z438;
    bicycle_put(carried + 43 * BICYCLE_LANES, z446);
    const bicycle_lanes z447 = c_roll * z438;
    bicycle_put(carried + 44 * BICYCLE_LANES, z447);
    const bicycle_lanes z448 = s1 * z447;
    bicycle_put(carried + 45 * BICYCLE_LANES, z448);
    const bicycle_lanes z449 = c_roll * z443;
    bicycle_put(carried + 46 * BICYCLE_LANES, z449);
    const bicycle_lanes z450 = c1 * z449;
    bicycle_put(carried + 47 * BICYCLE_LANES, z450);
    const double z191 = kept[201];
    const double z193 = kept[203];
    const double z309 = kept[261];
    const bicycle_lanes z451 = z309 * z437 + z193 * z442 + z191 * z437 + c_steer * z446 - s_steer * z448 +
        z450;
    bicycle_put(carried + 48 * BICYCLE_LANES, z451);
    const bicycle_lanes z452 = z207 * z442 - e2z * z443;
    bicycle_put(carried + 49 * BICYCLE_LANES, z452);
    const bicycle_lanes z453 = z207 * z444 - e2z * z445;
    bicycle_put(carried + 50 * BICYCLE_LANES, z453);
    const bicycle_lanes z454 = s_steer * z452 + c_steer * z453;
    const bicycle_lanes z455 = s1 * z449;
    bicycle_put(carried + 51 * BICYCLE_LANES, z455);
    const bicycle_lanes z456 = c_roll * z445;
    bicycle_put(carried + 52 * BICYCLE_LANES, z456);
    const bicycle_lanes z457 = s1 * z456;
    bicycle_put(carried + 53 * BICYCLE_LANES, z457);
    const double z194 = kept[204];
    const double z379 = kept[324];
    const bicycle_lanes z458 = z454 + (z444 * z379 - z194 * z442 + c_steer * z455 - s_steer * z457);
    bicycle_put(carried + 54 * BICYCLE_LANES, z458);
    const double z6 = kept[44];
    const double z17 = kept[55];
    const bicycle_lanes z459 = z6 * z451 + z17 * z458;
    bicycle_put(carried + 55 * BICYCLE_LANES, z459);
    const double z188 = kept[197];
    const bicycle_lanes z460 = z188 * z459;
    bicycle_put(carried + 56 * BICYCLE_LANES, z460);
    const double z5 = kept[43];
    const bicycle_lanes z461 = z5 * z460;
    bicycle_put(carried + 57 * BICYCLE_LANES, z461);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z4 = kept[42];
    const bicycle_lanes z462 = r_F * (z5 * z451) - z4 * z461;
    bicycle_put(carried + 58 * BICYCLE_LANES, z462);
    const bicycle_lanes z463 = z206 * z424 - z15 * z438 + z23 * z443 + z30 * z445 + s_steer * z462;
    bicycle_put(carried + 59 * BICYCLE_LANES, z463);
    const bicycle_lanes z464 = s_steer * z444 - c_steer * z442;
    bicycle_put(carried + 60 * BICYCLE_LANES, z464);
    const double w3_steer = kept[296];
    const double z350 = kept[297];
    const bicycle_lanes z465 = z350 * z415 + w3_steer * z416;
    const bicycle_lanes z466 = F_yy * z465;
    const double z288 = kept[242];
    const bicycle_lanes z467 = z288 * z444;
    bicycle_put(carried + 61 * BICYCLE_LANES, z467);
    const double z285 = kept[239];
    const bicycle_lanes z468 = z285 * z437;
    bicycle_put(carried + 62 * BICYCLE_LANES, z468);
    const bicycle_lanes z469 = z466 - z467 - z468;
    bicycle_put(carried + 63 * BICYCLE_LANES, z469);
    const bicycle_lanes z470 = z38 * z469;
    bicycle_put(carried + 64 * BICYCLE_LANES, z470);
    const double z21 = kept[59];
    const bicycle_lanes z471 = z21 * z442;
    bicycle_put(carried + 65 * BICYCLE_LANES, z471);
    const double k4 = kept[8];
    const bicycle_lanes z472 = z21 * z444 + z7 * z437 + k4 * z437;
    bicycle_put(carried + 66 * BICYCLE_LANES, z472);
    const bicycle_lanes z473 = z430 - c_steer * z471 + s_steer * z472;
    bicycle_put(carried + 67 * BICYCLE_LANES, z473);
    const bicycle_lanes z474 = c_steer * z444 + s_steer * z442;
    bicycle_put(carried + 68 * BICYCLE_LANES, z474);
    const double thR_dot = y[11];
    const double z209 = kept[219];
    const bicycle_lanes z475 = z209 * z423 + thR_dot * z474 - z454;
    bicycle_put(carried + 69 * BICYCLE_LANES, z475);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z2 = kept[40];
    const double z11 = kept[49];
    const bicycle_lanes z476 = r_F * (z5 * z458) + r_R * (z11 * z475) - z2 * z461;
    bicycle_put(carried + 70 * BICYCLE_LANES, z476);
    const double roll_dot = y[9];
    const double z26 = kept[64];
    const double z32 = kept[70];
    const double z331 = kept[283];
    const bicycle_lanes z477 = z331 * z433 - z26 * z449 + z32 * z456 - roll_dot * z473 - c_roll * z476;
    bicycle_put(carried + 71 * BICYCLE_LANES, z477);
    const bicycle_lanes z478 = z433 - z7 * z442 - k4 * z442 + k10 * z464;
    bicycle_put(carried + 72 * BICYCLE_LANES, z478);
    const bicycle_lanes z479 = z209 * z419 + thR_dot * z437 - z446;
    bicycle_put(carried + 73 * BICYCLE_LANES, z479);
    const bicycle_lanes z480 = r_R * (z11 * z479) + c_steer * z462;
    bicycle_put(carried + 74 * BICYCLE_LANES, z480);
    const double z9 = kept[47];
    const double z25 = kept[63];
    const double z31 = kept[69];
    const bicycle_lanes z481 = z331 * z430 + z9 * z447 - z25 * z449 + z31 * z456 + roll_dot * z478 + c_roll *
        z480;
    bicycle_put(carried + 75 * BICYCLE_LANES, z481);
    const double z332 = kept[284];
    const double z337 = kept[289];
    const bicycle_lanes z482 = z332 * z427 + z337 * z428;
    const double z208 = kept[218];
    const double z366 = kept[311];
    const double z370 = kept[315];
    const double z374 = kept[319];
    const double z376 = kept[321];
    const bicycle_lanes z483 = z374 * z401 + z376 * z402 - z366 * z427 + z370 * z428 + k37 * z482 - k28 *
        (z332 * z429 - z208 * z402);
    const double z210 = kept[220];
    const double z211 = kept[221];
    const double z339 = kept[290];
    const bicycle_lanes z484 = z483 + k27 * (z208 * z401 - z337 * z429) - z339 * z422 - z210 * z419 - z211 *
        z423;
    const double z351 = kept[298];
    const double z352 = kept[299];
    const double z356 = kept[301];
    const double z360 = kept[305];
    const double z362 = kept[307];
    const bicycle_lanes z485 = z360 * z405 + z362 * z411 + z351 * z415 + z352 * z416 - k59 * z465 - k48 *
        (z350 * z417 - z356 * z411);
    const bicycle_lanes z486 = z485 + k45 * (z356 * z405 + w3_steer * z417) - z466;
    bicycle_put(carried + 76 * BICYCLE_LANES, z486);
    const double z276 = kept[230];
    const double z277 = kept[231];
    const bicycle_lanes z487 = z484 - z277 * z412 - z276 * z418 + k10 * (z332 * z432 - z208 * z422) + c_steer
        * z486;
    const bicycle_lanes z488 = z350 * z404 - z356 * z416;
    const bicycle_lanes z489 = z356 * z415 + w3_steer * z404;
    const double z357 = kept[302];
    const double z359 = kept[304];
    const bicycle_lanes z490 = z359 * z405 - z362 * z417 - z357 * z415 - z352 * z404 - k62 * z488 + k55 *
        z489;
    const bicycle_lanes z491 = z350 * z405 + w3_steer * z411;
    const bicycle_lanes z492 = z490 + k45 * z491;
    bicycle_put(carried + 77 * BICYCLE_LANES, z492);
    const bicycle_lanes z493 = k28 * z427 + k27 * z428 - k26 * z429 + z432;
    bicycle_put(carried + 78 * BICYCLE_LANES, z493);
    const bicycle_lanes z494 = z332 * z493 + z208 * z423;
    bicycle_put(carried + 79 * BICYCLE_LANES, z494);
    const bicycle_lanes z495 = z208 * z419 - z337 * z493;
    bicycle_put(carried + 80 * BICYCLE_LANES, z495);
    const double z295 = kept[249];
    const double z319 = kept[271];
    const bicycle_lanes z496 = R_yy * z482 + z319 * z419 - z295 * z423 + z13 * z494 + z20 * z495;
    bicycle_put(carried + 81 * BICYCLE_LANES, z496);
    const bicycle_lanes z497 = z487 + s_steer * z492 + z496;
    bicycle_put(carried + 82 * BICYCLE_LANES, z497);
    const double z304 = kept[257];
    const double z313 = kept[265];
    const double z322 = kept[274];
    const bicycle_lanes z498 = z313 * z444 - z304 * z442 + z322 * z437 - s1 * z477 + c1 * z481 + z497;
    bicycle_put(carried + 83 * BICYCLE_LANES, z498);
    const bicycle_lanes z499 = z38 * z498;
    bicycle_put(carried + 84 * BICYCLE_LANES, z499);
    const bicycle_lanes z500 = z15 * z470 + z7 * z499;
    bicycle_put(carried + 85 * BICYCLE_LANES, z500);
    const bicycle_lanes z501 = z332 * z400 - z208 * z428;
    const bicycle_lanes z502 = z208 * z427 + z337 * z400;
    const double z365 = kept[310];
    const double z373 = kept[318];
    const bicycle_lanes z503 = z373 * z401 - z376 * z429 - z365 * z427 - z370 * z400 - k40 * z501 - k34 *
        z502;
    const bicycle_lanes z504 = z332 * z401 - z337 * z402;
    const double v2_x_2 = kept[288];
    const double z340 = kept[291];
    const bicycle_lanes z505 = z503 + k27 * z504 + z340 * z406 + z339 * z432 + v2_x_2 * z419 - z211 * z493 +
        z276 * z412;
    const bicycle_lanes z506 = z505 - z277 * z418 + s_steer * z486 - c_steer * z492;
    bicycle_put(carried + 86 * BICYCLE_LANES, z506);
    const bicycle_lanes z507 = z360 * z417 + z359 * z411 + z351 * z404 - z357 * z416 - k63 * z488 + k56 *
        z489;
    const bicycle_lanes z508 = z507 + k48 * z491;
    bicycle_put(carried + 87 * BICYCLE_LANES, z508);
    const bicycle_lanes z509 = z374 * z429 + z373 * z402 + z366 * z400 + z365 * z428 - k41 * z501 - k35 *
        z502;
    const bicycle_lanes z510 = z509 + k28 * z504 + z340 * z422 - z210 * z493 - v2_x_2 * z423 - k10 * (z332 *
        z406 - z337 * z422);
    const bicycle_lanes z511 = z508 - z510;
    bicycle_put(carried + 88 * BICYCLE_LANES, z511);
    const double z273 = kept[227];
    const double z278 = kept[232];
    const bicycle_lanes z512 = z278 * z430 - z273 * z433 - s1 * z506 + c1 * z511;
    bicycle_put(carried + 89 * BICYCLE_LANES, z512);
    const double z272 = kept[226];
    const double z275 = kept[229];
    const double z305 = kept[258];
    const double z314 = kept[266];
    const double z323 = kept[275];
    const bicycle_lanes z513 = z272 * z434 + z275 * z424 + z314 * z444 - z305 * z442 + z323 * z437 + c_roll *
        z512;
    const bicycle_lanes z514 = z513 - e2z * z497;
    bicycle_put(carried + 90 * BICYCLE_LANES, z514);
    const bicycle_lanes z515 = z38 * z514;
    bicycle_put(carried + 91 * BICYCLE_LANES, z515);
    const bicycle_lanes z516 = z16 * z470 - z7 * z515;
    bicycle_put(carried + 92 * BICYCLE_LANES, z516);
    const bicycle_lanes z517 = z28 * z500 - z23 * z516;
    bicycle_put(carried + 93 * BICYCLE_LANES, z517);
    const bicycle_lanes z518 = z16 * z499 + z15 * z515;
    bicycle_put(carried + 94 * BICYCLE_LANES, z518);
    const bicycle_lanes z519 = z34 * z500 + z30 * z516 - z18 * z518;
    bicycle_put(carried + 95 * BICYCLE_LANES, z519);
    const bicycle_lanes z520 = z276 * z444 + z277 * z442 - s_steer * z517 + c_steer * z519;
    bicycle_put(carried + 96 * BICYCLE_LANES, z520);
    const double z293 = kept[247];
    const bicycle_lanes z521 = z293 * z464 + z11 * z520;
    bicycle_put(carried + 97 * BICYCLE_LANES, z521);
    const bicycle_lanes z522 = roll_dot * z493;
    bicycle_put(carried + 98 * BICYCLE_LANES, z522);
    const double z12 = kept[50];
    const double z19 = kept[57];
    const double z42 = kept[80];
    const double z187 = kept[196];
    const bicycle_lanes z523 = z42 * z522 + z187 * z464 + z12 * z479 - z19 * z475;
    bicycle_put(carried + 99 * BICYCLE_LANES, z523);
    const double z185 = kept[194];
    const bicycle_lanes z524 = z185 * z523;
    bicycle_put(carried + 100 * BICYCLE_LANES, z524);
    const bicycle_lanes z525 = z11 * z524;
    bicycle_put(carried + 101 * BICYCLE_LANES, z525);
    const double z302 = kept[255];
    const double z312 = kept[264];
    const double z321 = kept[273];
    const double z329 = kept[281];
    const bicycle_lanes z526 = z329 * z434 - z321 * z438 + z302 * z443 - z312 * z445 - z278 * z480 - z273 *
        z476;
    bicycle_put(carried + 102 * BICYCLE_LANES, z526);
    const double z390 = kept[327];
    const bicycle_lanes z527 = z390 * z394;
    bicycle_put(carried + 103 * BICYCLE_LANES, z527);
    const bicycle_lanes z528 = z134 * z527;
    const bicycle_lanes z529 = z144 * z527;
    const bicycle_lanes z530 = z142 * z527;
    const double z145 = kept[172];
    const double z155 = kept[182];
    const double z369 = kept[314];
    const bicycle_lanes z531 = z394 * z369 + z145 * z527 + z155 * z527 + k63 * z528 - k56 * z529 + k48 * z530;
    const bicycle_lanes z532 = z143 * z527;
    const double z391 = kept[328];
    const bicycle_lanes z533 = z391 * z394 - z390 * z396;
    bicycle_put(carried + 104 * BICYCLE_LANES, z533);
    const double z392 = kept[329];
    const bicycle_lanes z534 = z392 * z394 - z390 * z398;
    bicycle_put(carried + 105 * BICYCLE_LANES, z534);
    const double z62 = kept[100];
    const double z71 = kept[109];
    const double z100 = kept[134];
    const double z109 = kept[143];
    const bicycle_lanes z535 = z531 + k41 * z528 + k35 * z532 + z100 * z533 + z109 * z533 + z62 * z534 + z71
        * z534;
    const double z107 = kept[141];
    const double z153 = kept[180];
    const double z363 = kept[308];
    const bicycle_lanes z536 = z363 * z394 + z153 * z527 + k48 * z528 - k45 * z529 + k43 * z530 + z107 * z533;
    const double z69 = kept[107];
    const bicycle_lanes z537 = z536 + z69 * z534;
    bicycle_put(carried + 106 * BICYCLE_LANES, z537);
    const bicycle_lanes z538 = z146 * z527;
    bicycle_put(carried + 107 * BICYCLE_LANES, z538);
    const bicycle_lanes z539 = z147 * z527;
    const double z70 = kept[108];
    const double z108 = kept[142];
    const double z154 = kept[181];
    const double z364 = kept[309];
    const bicycle_lanes z540 = z364 * z394 + z154 * z527 + k45 * z538 + k43 * z539 + z108 * z533 + z70 * z534;
    bicycle_put(carried + 108 * BICYCLE_LANES, z540);
    const bicycle_lanes z541 = z535 + k10 * (c_steer * z537 + s_steer * z540);
    bicycle_put(carried + 109 * BICYCLE_LANES, z541);
    const double z74 = kept[112];
    const double z112 = kept[146];
    const double z157 = kept[184];
    const double z372 = kept[317];
    const bicycle_lanes z542 = z372 * z394 + z157 * z527 + k40 * z528 + k34 * z532 + z112 * z533 + z74 * z534;
    const bicycle_lanes z543 = F_yy * z533;
    const bicycle_lanes z544 = F_yy * z534;
    bicycle_put(carried + 110 * BICYCLE_LANES, z544);
    const double z336 = kept[287];
    const bicycle_lanes z545 = z336 * z407 + 2.0 * (z164 * (F_yy * z527)) - z119 * z543 - z82 * z544;
    bicycle_put(carried + 111 * BICYCLE_LANES, z545);
    const bicycle_lanes z546 = z149 * z527;
    bicycle_put(carried + 112 * BICYCLE_LANES, z546);
    const double z104 = kept[138];
    const double z150 = kept[177];
    const double z353 = kept[300];
    const bicycle_lanes z547 = z353 * z394 + z150 * z527 + k59 * z538 - k48 * z546 + k45 * z539 - z104 * z533;
    const double z66 = kept[104];
    const bicycle_lanes z548 = z545 + (z547 - z66 * z534);
    bicycle_put(carried + 113 * BICYCLE_LANES, z548);
    const double z105 = kept[139];
    const double z151 = kept[178];
    const double z358 = kept[303];
    const bicycle_lanes z549 = z358 * z394 + z151 * z527 + k62 * z528 - k55 * z529 + k45 * z530 + z105 * z533;
    const double z67 = kept[105];
    const bicycle_lanes z550 = z549 + z67 * z534;
    bicycle_put(carried + 114 * BICYCLE_LANES, z550);
    const bicycle_lanes z551 = z542 + s_steer * z548 + c_steer * z550;
    bicycle_put(carried + 115 * BICYCLE_LANES, z551);
    const bicycle_lanes z552 = c1 * z541 + s1 * z551;
    bicycle_put(carried + 116 * BICYCLE_LANES, z552);
    const bicycle_lanes z553 = z391 * z396;
    bicycle_put(carried + 117 * BICYCLE_LANES, z553);
    const bicycle_lanes z554 = z134 * z533;
    const bicycle_lanes z555 = z554 - z90 * z553;
    const bicycle_lanes z556 = z144 * z533 + z99 * z553;
    const bicycle_lanes z557 = z142 * z533 - z97 * z553;
    const bicycle_lanes z558 = z392 * z396 + z391 * z398;
    bicycle_put(carried + 118 * BICYCLE_LANES, z558);
    const double z368 = kept[313];
    const bicycle_lanes z559 = z368 * z396 - z100 * z553 + k63 * z555 - k56 * z556 + k48 * z557 - z62 * z558;
    const bicycle_lanes z560 = z554 - z89 * z553;
    const bicycle_lanes z561 = z143 * z533 - z98 * z553;
    const bicycle_lanes z562 = z363 * z396 + z107 * z553 - k48 * z555 + k45 * z556 - k43 * z557 + z69 * z558;
    bicycle_put(carried + 119 * BICYCLE_LANES, z562);
    const bicycle_lanes z563 = z146 * z533 + z101 * z553;
    bicycle_put(carried + 120 * BICYCLE_LANES, z563);
    const bicycle_lanes z564 = z147 * z533 - z102 * z553;
    const bicycle_lanes z565 = z364 * z396 + z108 * z553 - k45 * z563 - k43 * z564 + z70 * z558;
    bicycle_put(carried + 121 * BICYCLE_LANES, z565);
    const double z367 = kept[312];
    const bicycle_lanes z566 = z559 - (z367 * z396 + z109 * z553 - k41 * z560 - k35 * z561 + z71 * z558) -
        k10 * (c_steer * z562 + s_steer * z565);
    bicycle_put(carried + 122 * BICYCLE_LANES, z566);
    const bicycle_lanes z567 = F_yy * z558;
    bicycle_put(carried + 123 * BICYCLE_LANES, z567);
    const bicycle_lanes z568 = z336 * z408 - z164 * z543 - 2.0 * (z119 * (F_yy * z553)) - z82 * z567;
    bicycle_put(carried + 124 * BICYCLE_LANES, z568);
    const bicycle_lanes z569 = z149 * z533 - z103 * z553;
    bicycle_put(carried + 125 * BICYCLE_LANES, z569);
    const bicycle_lanes z570 = z353 * z396 - z104 * z553 - k59 * z563 + k48 * z569 - k45 * z564 - z66 * z558;
    const bicycle_lanes z571 = z568 + z570;
    bicycle_put(carried + 126 * BICYCLE_LANES, z571);
    const bicycle_lanes z572 = z372 * z396 + z112 * z553 - k40 * z560 - k34 * z561 + z74 * z558 + s_steer *
        z571;
    const bicycle_lanes z573 = z358 * z396 + z105 * z553 - k62 * z555 + k55 * z556 - k45 * z557 + z67 * z558;
    bicycle_put(carried + 127 * BICYCLE_LANES, z573);
    const bicycle_lanes z574 = z572 + c_steer * z573;
    bicycle_put(carried + 128 * BICYCLE_LANES, z574);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part2(double t, const double *y, const double *p, const
    double *kept, const double *seed, double *carried, double *slope)
{
    (void)seed;
    (void)t;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z566 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z574 = bicycle_get(carried + 128 * BICYCLE_LANES);
    const bicycle_lanes z575 = c1 * z566 - s1 * z574;
    const double z392 = kept[329];
    const bicycle_lanes z398 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z576 = z392 * z398;
    const double z134 = kept[162];
    const bicycle_lanes z534 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z577 = z134 * z534;
    const double z52 = kept[90];
    const bicycle_lanes z578 = z52 * z576;
    const double z90 = kept[125];
    const bicycle_lanes z558 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z579 = z577 - z90 * z558 - z578;
    const double z61 = kept[99];
    const double z99 = kept[133];
    const double z144 = kept[171];
    const bicycle_lanes z580 = z144 * z534 + z99 * z558 + z61 * z576;
    const double z59 = kept[97];
    const double z97 = kept[131];
    const double z142 = kept[169];
    const bicycle_lanes z581 = z142 * z534 - z97 * z558 - z59 * z576;
    const double k48 = kept[24];
    const double k56 = kept[26];
    const double k63 = kept[29];
    const double z62 = kept[100];
    const double z71 = kept[109];
    const double z369 = kept[314];
    const bicycle_lanes z582 = z398 * z369 + z62 * z576 + z71 * z576 - k63 * z579 + k56 * z580 - k48 * z581;
    const double z89 = kept[124];
    const bicycle_lanes z583 = z577 - z89 * z558 - z578;
    const double z60 = kept[98];
    const double z98 = kept[132];
    const double z143 = kept[170];
    const bicycle_lanes z584 = z143 * z534 - z98 * z558 + z60 * z576;
    const double z43 = kept[81];
    const bicycle_lanes z585 = z43 * z576;
    const double k43 = kept[22];
    const double k45 = kept[23];
    const double z69 = kept[107];
    const double z363 = kept[308];
    const bicycle_lanes z586 = z363 * z398 + z69 * z576 - k48 * z579 + k45 * z580 - k43 * z581;
    const double z63 = kept[101];
    const double z101 = kept[135];
    const double z146 = kept[173];
    const bicycle_lanes z587 = z146 * z534 + z101 * z558 + z63 * z576;
    const double z64 = kept[102];
    const double z102 = kept[136];
    const double z147 = kept[174];
    const bicycle_lanes z588 = z147 * z534 - z102 * z558 - z64 * z576;
    const double z70 = kept[108];
    const double z364 = kept[309];
    const bicycle_lanes z589 = z364 * z398 + z70 * z576 - k45 * z587 - k43 * z588;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const bicycle_lanes z590 = c_steer * z586 + s_steer * z589;
    const double k10 = kept[9];
    const double k28 = kept[16];
    const double k35 = kept[18];
    const double k41 = kept[21];
    const bicycle_lanes z591 = z582 - k41 * z583 - k35 * z584 + k28 * z585 + k10 * z590;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z82 = kept[117];
    const double z119 = kept[150];
    const double z164 = kept[188];
    const double z336 = kept[287];
    const bicycle_lanes z409 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z544 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z567 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z592 = z336 * z409 - z164 * z544 - z119 * z567 - 2.0 * (z82 * (F_yy * z576));
    const double z65 = kept[103];
    const double z103 = kept[137];
    const double z149 = kept[176];
    const bicycle_lanes z593 = z149 * z534 - z103 * z558 - z65 * z576;
    const double k59 = kept[27];
    const double z66 = kept[104];
    const double z353 = kept[300];
    const bicycle_lanes z594 = z592 + (z353 * z398 - z66 * z576 - k59 * z587 + k48 * z593 - k45 * z588);
    const double k27 = kept[15];
    const double k34 = kept[17];
    const double k40 = kept[20];
    const double z74 = kept[112];
    const double z372 = kept[317];
    const bicycle_lanes z595 = z372 * z398 + z74 * z576 - k40 * z583 - k34 * z584 + k27 * z585 + s_steer *
        z594;
    const double k55 = kept[25];
    const double k62 = kept[28];
    const double z67 = kept[105];
    const double z358 = kept[303];
    const bicycle_lanes z596 = z358 * z398 + z67 * z576 - k62 * z579 + k55 * z580 - k45 * z581;
    const bicycle_lanes z597 = z595 + c_steer * z596;
    const bicycle_lanes z598 = c1 * z591 + s1 * z597;
    const double z50 = kept[88];
    const double z87 = kept[122];
    const double z132 = kept[160];
    const double z206 = kept[216];
    const double z292 = kept[246];
    const double z381 = kept[326];
    const bicycle_lanes z512 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z523 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z526 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z552 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z599 = 2.0 * (z292 * z523 * z381) - (z526 - z206 * z512 - z132 * z552 - z87 * z575 +
        z50 * z598);
    const double z38 = kept[76];
    const bicycle_lanes z545 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z600 = z38 * z545;
    const double z139 = kept[166];
    const bicycle_lanes z527 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z601 = z139 * z527;
    const double z148 = kept[175];
    const bicycle_lanes z602 = z148 * z527;
    const double z141 = kept[168];
    const bicycle_lanes z603 = z141 * z527;
    const double k37 = kept[19];
    const double z111 = kept[145];
    const double z156 = kept[183];
    const double z371 = kept[316];
    const bicycle_lanes z394 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z533 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z604 = z371 * z394 - z156 * z527 - k37 * z601 + k28 * z602 - k27 * z603 + z111 * z533;
    const double z68 = kept[106];
    const double z106 = kept[140];
    const double z152 = kept[179];
    const double z361 = kept[306];
    const bicycle_lanes z538 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z546 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z605 = z361 * z394 + z152 * z527 - k48 * z538 + k43 * z546 + z106 * z533 + z68 * z534;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z606 = R_yy * z533;
    const bicycle_lanes z607 = R_yy * z534;
    const double k26 = kept[14];
    const double z75 = kept[113];
    const double z114 = kept[148];
    const double z159 = kept[186];
    const double z375 = kept[320];
    const bicycle_lanes z608 = z375 * z394 + z159 * z527 - k28 * z601 + k26 * z602 + z114 * z533 + z75 * z534;
    const bicycle_lanes z609 = z605 + z608;
    const double z13 = kept[51];
    const double z57 = kept[95];
    const double z95 = kept[129];
    const double z140 = kept[167];
    const double z330 = kept[282];
    const bicycle_lanes z395 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z610 = z330 * z395 - 2.0 * (z140 * (R_yy * z527)) - z95 * z606 - z57 * z607 - z13 *
        z609;
    const double z76 = kept[114];
    const double z113 = kept[147];
    const double z158 = kept[185];
    const double z377 = kept[322];
    const bicycle_lanes z611 = z377 * z394 - z158 * z527 - k27 * z601 - k26 * z603 - z113 * z533 - z76 * z534;
    const bicycle_lanes z537 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z540 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z612 = z611 + s_steer * z537 - c_steer * z540;
    const double z20 = kept[58];
    const double z73 = kept[111];
    const bicycle_lanes z548 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z550 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z613 = z604 + z73 * z534 - c_steer * z548 + s_steer * z550 + k10 * z605 - (z610 + z20
        * z612);
    const bicycle_lanes z614 = z38 * z613;
    const double z128 = kept[156];
    const double z130 = kept[158];
    const double z199 = kept[209];
    const double z201 = kept[211];
    const double z316 = kept[268];
    const double z326 = kept[278];
    const bicycle_lanes z425 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z426 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z470 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z499 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z615 = z316 * z425 - z326 * z426 - z201 * z470 + z199 * z499 + z130 * z600 - z128 *
        z614;
    const bicycle_lanes z568 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z616 = z38 * z568;
    const bicycle_lanes z396 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z397 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z553 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z617 = z330 * z397 - z371 * z396 + z140 * z606 - 2.0 * (z95 * (R_yy * z553)) - z111 *
        z553;
    const bicycle_lanes z618 = z139 * z533 + z95 * z553;
    const double z110 = kept[144];
    const bicycle_lanes z619 = z148 * z533 - z110 * z553;
    const double z96 = kept[130];
    const bicycle_lanes z620 = z141 * z533 - z96 * z553;
    const bicycle_lanes z621 = R_yy * z558;
    const bicycle_lanes z571 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z622 = z617 - k37 * z618 + k28 * z619 - k27 * z620 - z57 * z621 - z73 * z558 +
        c_steer * z571;
    const bicycle_lanes z563 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z569 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z623 = z361 * z396 + z106 * z553 + k48 * z563 - k43 * z569 + z68 * z558;
    const bicycle_lanes z624 = z375 * z396 + z114 * z553 + k28 * z618 - k26 * z619 + z75 * z558;
    const bicycle_lanes z562 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z625 = z377 * z396 - z113 * z553 + k27 * z618 + k26 * z620 - z76 * z558 + s_steer *
        z562;
    const bicycle_lanes z565 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z626 = z625 - c_steer * z565;
    const double z14 = kept[52];
    const bicycle_lanes z573 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z627 = z622 - s_steer * z573 - z14 * z623 - z13 * z624 + z20 * z626;
    const bicycle_lanes z628 = z38 * z627;
    const bicycle_lanes z629 = z38 * z592;
    const bicycle_lanes z399 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z630 = z330 * z399 - z371 * z398 + z140 * z607 - z95 * z621 - 2.0 * (z57 * (R_yy *
        z576));
    const bicycle_lanes z631 = z139 * z534 + z95 * z558 + z57 * z576;
    const double z72 = kept[110];
    const bicycle_lanes z632 = z148 * z534 - z110 * z558 - z72 * z576;
    const double z58 = kept[96];
    const bicycle_lanes z633 = z141 * z534 - z96 * z558 - z58 * z576;
    const bicycle_lanes z634 = z630 - z73 * z576 - k37 * z631 + k28 * z632 - k27 * z633 + c_steer * z594 -
        s_steer * z596;
    const bicycle_lanes z635 = z361 * z398 + z68 * z576 + k48 * z587 - k43 * z593;
    const bicycle_lanes z636 = z375 * z398 + z75 * z576 + k28 * z631 - k26 * z632;
    const bicycle_lanes z637 = z377 * z398 - z76 * z576 + k27 * z631 + k26 * z633 + s_steer * z586 - c_steer
        * z589;
    const bicycle_lanes z638 = z634 - z14 * z635 - z13 * z636 + z20 * z637;
    const bicycle_lanes z639 = z38 * z638;
    const double z202 = kept[212];
    const double z204 = kept[214];
    const double z205 = kept[215];
    const double z325 = kept[277];
    const double z327 = kept[279];
    const double z328 = kept[280];
    const bicycle_lanes z410 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z424 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z435 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z469 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z498 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z514 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z640 = z325 * z410 - z327 * z424 - z328 * z435 - z205 * z469 + z204 * z498 + z202 *
        z514;
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z641 = c_roll * z552 - e2z * z613;
    const bicycle_lanes z642 = c_roll * z575 - e2z * z627;
    const double z86 = kept[121];
    const double z93 = kept[128];
    const double z117 = kept[149];
    const double z131 = kept[159];
    const double z137 = kept[165];
    const double z162 = kept[187];
    const bicycle_lanes z643 = z640 + z162 * z545 - z137 * z613 + z131 * z641 + z117 * z568 + z93 * z627 +
        z86 * z642;
    const bicycle_lanes z644 = c_roll * z598 + e2z * z638;
    const double z49 = kept[87];
    const double z55 = kept[93];
    const double z80 = kept[116];
    const double z189 = kept[199];
    const bicycle_lanes z645 = z189 * (z643 + z80 * z592 + z55 * z638 - z49 * z644);
    const double z24 = kept[62];
    const double z46 = kept[84];
    const double z48 = kept[86];
    const double z84 = kept[119];
    const double z85 = kept[120];
    const bicycle_lanes z646 = z615 + z85 * z616 + z84 * z628 + z48 * z629 + z46 * z639 - z24 * z645;
    const double z7 = kept[45];
    const double z15 = kept[53];
    const bicycle_lanes z647 = z15 * z600 + z7 * z614;
    const bicycle_lanes z648 = z15 * z629 - z7 * z639;
    const double z40 = kept[78];
    const double z197 = kept[207];
    const double z324 = kept[276];
    const bicycle_lanes z649 = z324 * z425 - z197 * z470 - z13 * z600 + z40 * z629 + z7 * z645;
    const bicycle_lanes z650 = z324 * z426 - z197 * z499 - z13 * z614 - z40 * z639 - z15 * z645;
    const double z18 = kept[56];
    const double z30 = kept[68];
    const double z47 = kept[85];
    const double z129 = kept[157];
    const double z200 = kept[210];
    const double z315 = kept[267];
    const bicycle_lanes z439 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z500 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z651 = z315 * z439 - z200 * z500 + z129 * z647 + z47 * z648 + z30 * z649 - z18 * z650;
    const bicycle_lanes z652 = z15 * z616 - z7 * z628;
    const double z8 = kept[46];
    const double z23 = kept[61];
    const double z45 = kept[83];
    const double z127 = kept[155];
    const double z198 = kept[208];
    const double z306 = kept[259];
    const bicycle_lanes z653 = z306 * z439 - z198 * z500 + z127 * z647 + z8 * z652 + z45 * z648 + z23 * z649;
    const double z332 = kept[284];
    const double z337 = kept[289];
    const bicycle_lanes z419 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z423 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z654 = z332 * z419 + z337 * z423;
    const double roll_dot = y[9];
    const double z77 = kept[115];
    const double z378 = kept[323];
    const bicycle_lanes z655 = roll_dot * z654 - (z378 * z398 + z77 * z576 - k28 * z583 - k27 * z584 + k26 *
        z585);
    const bicycle_lanes z656 = z38 * z644;
    const double z16 = kept[54];
    const bicycle_lanes z657 = z16 * z629 - z7 * z656;
    const double z28 = kept[66];
    const bicycle_lanes z658 = z28 * z648 - z23 * z657;
    const bicycle_lanes z659 = z16 * z639 - z15 * z656;
    const double z34 = kept[72];
    const bicycle_lanes z660 = z34 * z648 + z30 * z657 + z18 * z659;
    const bicycle_lanes z661 = s_steer * z658 - c_steer * z660;
    const bicycle_lanes z662 = z655 - z590 - z661;
    const double z42 = kept[80];
    const double z291 = kept[245];
    const double z294 = kept[248];
    const double z297 = kept[251];
    const double z318 = kept[270];
    const double z342 = kept[293];
    const bicycle_lanes z464 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z475 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z479 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z522 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z524 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z663 = z318 * z479 - z294 * z475 + z342 * z522 + z297 * z464 - z291 * z524 + z42 *
        z662;
    const double z29 = kept[67];
    const double z35 = kept[73];
    const bicycle_lanes z515 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z664 = z35 * z470 - z29 * z499 - z24 * z515;
    const double thR_dot = y[11];
    const double z209 = kept[219];
    const bicycle_lanes z494 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z665 = z330 * z419 - z209 * z494 + thR_dot * z664 + z140 * z609 - z35 * z600 + z29 *
        z614;
    const bicycle_lanes z666 = z38 * z641;
    const double z136 = kept[164];
    const double z203 = kept[213];
    const double z275 = kept[229];
    const double z317 = kept[269];
    const bicycle_lanes z436 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z438 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z667 = z317 * z425 - z326 * z436 - z275 * z438 - z203 * z470 + z199 * z515 + z136 *
        z600;
    const bicycle_lanes z668 = z38 * z642;
    const double z54 = kept[92];
    const double z92 = kept[127];
    const bicycle_lanes z669 = z667 - z128 * z666 + z92 * z616 + z84 * z668 + z54 * z629 - z46 * z656 + z29 *
        z645;
    const bicycle_lanes z670 = z669 + e2z * z646;
    const bicycle_lanes z671 = z665 + z24 * z666 - z95 * z624 - z57 * z636 - (z95 * z623 + z57 * z635 - z670);
    const double z276 = kept[230];
    const double z277 = kept[231];
    const bicycle_lanes z442 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z444 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z517 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z519 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z672 = z277 * z444 - z276 * z442 + c_steer * z517 + s_steer * z519;
    const bicycle_lanes z495 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z673 = z330 * z423 + z209 * z495 + thR_dot * z672 + z140 * z612 - z95 * z626 - z57 *
        z637;
    const bicycle_lanes z674 = z16 * z600 - z7 * z666;
    const bicycle_lanes z675 = z16 * z614 + z15 * z666;
    const bicycle_lanes z676 = z34 * z647 + z30 * z674 - z18 * z675;
    const bicycle_lanes z440 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z443 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z516 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z677 = z315 * z440 - z275 * z443 - z200 * z516 + z129 * z674 + z47 * z657 - z34 *
        z649;
    const bicycle_lanes z678 = z324 * z436 - z197 * z515 - z13 * z666 + z40 * z656 + z16 * z645;
    const bicycle_lanes z679 = z677 + z18 * z678 - e2z * z651;
    const bicycle_lanes z680 = z16 * z616 + z7 * z668;
    const bicycle_lanes z445 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z681 = z306 * z440 + z275 * z445 - z198 * z516 + z127 * z674 + z8 * z680 + z45 * z657;
    const bicycle_lanes z682 = z681 + z28 * z649 - e2z * z653;
    const bicycle_lanes z452 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z453 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z683 = z276 * z452 - z277 * z453 + s_steer * z679 - c_steer * z682;
    const bicycle_lanes z684 = z28 * z647 - z23 * z674;
    const bicycle_lanes z685 = z673 - s_steer * z676 + z683 - c_steer * z684;
    const double z10 = kept[48];
    const double z11 = kept[49];
    const double z12 = kept[50];
    const double z19 = kept[57];
    const double z27 = kept[65];
    const double z33 = kept[71];
    const double z185 = kept[194];
    const double z186 = kept[195];
    const double z187 = kept[196];
    const double z272 = kept[226];
    const bicycle_lanes z520 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z521 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z525 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z686 = z186 * z521 + (z272 * z525 - z599 - z10 * z646 - z27 * z651 - z33 * z653) -
        c_roll * (z11 * (z185 * (z187 * z520 - z663 - z12 * z671 + z19 * z685)));
    const double k72 = kept[35];
    const double k75 = kept[38];
    const double k76 = kept[39];
    const bicycle_lanes z415 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z416 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z417 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z687 = k76 * z415 + k75 * z416 - k72 * z417;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double k67 = kept[30];
    const double k69 = kept[32];
    const double z293 = kept[247];
    const bicycle_lanes z400 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z402 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z462 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z688 = z277 * z462 - (s_steer * z687 + (k69 * z400 + k67 * z402 + r_R * (z293 * z479
        - z11 * z671)));
    const double z286 = kept[240];
    const double z307 = kept[260];
    const bicycle_lanes z437 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z689 = z317 * z426 - z316 * z436 - z286 * z442 + z307 * z437 - z203 * z499 + z201 *
        z515;
    const double z191 = kept[201];
    const double z193 = kept[203];
    const bicycle_lanes z690 = z689 - z193 * z519 - z191 * z664 + z136 * z614 - z130 * z666 - z92 * z628 +
        z85 * z668;
    const bicycle_lanes z691 = z16 * z628 + z15 * z668;
    const bicycle_lanes z692 = z35 * z629 + z29 * z639 - z24 * z656;
    const double z39 = kept[77];
    const bicycle_lanes z446 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z448 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z693 = z277 * z446 + z276 * z448 - z34 * z652 - z30 * z680 - z18 * z691 - z39 * z692;
    const bicycle_lanes z694 = z272 * z438 + c_roll * z646;
    const double z278 = kept[232];
    const bicycle_lanes z447 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z695 = z278 * z447 + s1 * z694;
    const bicycle_lanes z696 = z272 * z443 - c_roll * z651;
    const double z273 = kept[227];
    const bicycle_lanes z449 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z697 = z273 * z449 - c1 * z696;
    const bicycle_lanes z698 = z690 - z54 * z639 - z48 * z656 + s1 * z660 + z35 * z645 - (z693 - c_steer *
        z670 - s_steer * z695 - z697);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k71 = kept[34];
    const double k74 = kept[37];
    const double z5 = kept[43];
    const double z280 = kept[234];
    const double z283 = kept[237];
    const bicycle_lanes z404 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z411 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z451 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z461 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z699 = z280 * z461 - k74 * z404 - k72 * z411 - k71 * z404 - r_F * (z283 * z451 + z5 *
        z698);
    const double z194 = kept[204];
    const double z290 = kept[244];
    const bicycle_lanes z441 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z518 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z700 = z306 * z441 - z307 * z444 - z290 * z442 - z198 * z518 + z191 * z517 - z194 *
        z519;
    const double z41 = kept[79];
    const bicycle_lanes z701 = z700 + z127 * z675 - z8 * z691 - z45 * z659 - z39 * z658 + z41 * z660 + z28 *
        z650;
    const bicycle_lanes z702 = z278 * z449 + s1 * z696;
    const bicycle_lanes z703 = z272 * z445 + c_roll * z653;
    const bicycle_lanes z456 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z704 = z278 * z456 + s1 * z703;
    const bicycle_lanes z455 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z457 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z705 = z701 + z23 * z678 - (z683 - (z277 * z455 + z276 * z457 + c_steer * z702 -
        s_steer * z704));
    const double z6 = kept[44];
    const double z17 = kept[55];
    const double z188 = kept[197];
    const double z281 = kept[235];
    const double z284 = kept[238];
    const double z287 = kept[241];
    const bicycle_lanes z458 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z460 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z706 = z5 * (z188 * (z284 * z451 - z287 * z458 + z281 * z460 + z6 * z698 - z17 *
        z705));
    const double z282 = kept[236];
    const double z380 = kept[325];
    const bicycle_lanes z459 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z707 = z282 * z459 * z380 + 0.5 * z706;
    const double z4 = kept[42];
    const bicycle_lanes z708 = z699 + 2.0 * (z4 * z707);
    const bicycle_lanes z709 = z688 + c_steer * z708;
    const double k68 = kept[31];
    const double k70 = kept[33];
    const double k73 = kept[36];
    const double z274 = kept[228];
    const bicycle_lanes z401 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z405 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z710 = z274 * z461 - k73 * z404 + k72 * z405 + k70 * z404 - k68 * z400 + k67 * z401;
    const double z2 = kept[40];
    const bicycle_lanes z711 = z710 + r_F * (z283 * z458 - z5 * z705) + r_R * (z293 * z475 - z11 * z685) -
        2.0 * (z2 * z707);
    const bicycle_lanes z463 = bicycle_get(carried + 59 * BICYCLE_LANES);
    const bicycle_lanes z712 = roll_dot * z463 - (z686 + r_R * (z293 * z522 - z11 * z662) - s1 * z709 - c1 *
        z711);
    const bicycle_lanes z713 = z11 * z464;
    const bicycle_lanes z434 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z714 = z206 * z434 + r_R * (z11 * z522) + z10 * z438 - z27 * z443 + z33 * z445 + z186
        * z713;
    const bicycle_lanes z476 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z480 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z715 = z714 - c_roll * z525 + s1 * z480 - c1 * z476;
    const double z304 = kept[257];
    const double z313 = kept[265];
    const double z322 = kept[274];
    const double z329 = kept[281];
    const bicycle_lanes z427 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z497 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z716 = z329 * z424 - z322 * z438 + z304 * z443 - z313 * z445 - z206 * z497 + k68 *
        z427;
    const bicycle_lanes z428 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z429 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z717 = z716 + k69 * z428 - k67 * z429 - z132 * z613 - z87 * z627 - z50 * z638 + z15 *
        z646;
    const bicycle_lanes z718 = c_steer * z687 - (roll_dot * z715 + (z276 * z462 + (z717 + z23 * z651 - z30 *
        z653))) + s_steer * z708;
    bicycle_put(slope + 0 * BICYCLE_LANES, e2z * z712 + c_roll * z718);
    const double k16 = kept[10];
    const double z288 = kept[242];
    const bicycle_lanes z719 = z288 * z442 - z18 * z519 - k16 * z519;
    const double k4 = kept[8];
    const bicycle_lanes z467 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z468 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z720 = z467 + z468 - z18 * z517 - k16 * z517 - z7 * z664 - k4 * z664;
    const bicycle_lanes z471 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z472 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z506 = bicycle_get(carried + 86 * BICYCLE_LANES);
    const bicycle_lanes z721 = z506 + z277 * z471 + z276 * z472 - c_steer * z719 + s_steer * z720;
    const double z88 = kept[123];
    const double z133 = kept[161];
    const double z207 = kept[217];
    const double z301 = kept[254];
    const double z331 = kept[283];
    const double z333 = kept[285];
    const bicycle_lanes z433 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z481 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z511 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z541 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z722 = z333 * z433 - z301 * z449 + z207 * z481 + z331 * z511 + z133 * z541 + z88 *
        z566;
    const double z21 = kept[59];
    const bicycle_lanes z723 = z21 * z660;
    const bicycle_lanes z724 = z8 * z692 + z18 * z658 + k16 * z658;
    const double z26 = kept[64];
    const double z51 = kept[89];
    const double z311 = kept[263];
    const bicycle_lanes z725 = z311 * z456 - (z597 + (z722 - z51 * z591)) + c_steer * z723 - s_steer * z724 +
        z26 * z696;
    const double z285 = kept[239];
    const bicycle_lanes z726 = z285 * z442 - z7 * z519 - k4 * z519;
    const bicycle_lanes z727 = z726 + (z511 - k10 * z520);
    const double z300 = kept[253];
    const double z310 = kept[262];
    const double z320 = kept[272];
    const bicycle_lanes z430 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z477 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z728 = z333 * z430 - z320 * z447 - z300 * z449 - z310 * z456 - z207 * z477 - z331 *
        z506;
    const bicycle_lanes z551 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z729 = z728 + z133 * z551 - z88 * z574 - z591 - z51 * z597 + z7 * z660 + k4 * z660;
    const double z9 = kept[47];
    const double z25 = kept[63];
    const double z31 = kept[69];
    const bicycle_lanes z730 = z272 * z480 + (roll_dot * z727 + (z729 + z9 * z694 - z25 * z696 + z31 * z703)
        - k10 * z661);
    const double z32 = kept[70];
    const bicycle_lanes z731 = s1 * (z272 * z476 - (roll_dot * z721 - (z725 - z32 * z703)) - c_roll * z711) +
        c1 * (z730 + c_roll * z709);
    bicycle_put(slope + 1 * BICYCLE_LANES, -z731);
    const double z190 = kept[200];
    const double z195 = kept[205];
    const double z196 = kept[206];
    const double z208 = kept[218];
    const bicycle_lanes z412 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z418 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z732 = z332 * z418 + z208 * z412 + z195 * z444 + z196 * z442 - z190 * z471 + z8 *
        z446;
    const double z3 = kept[41];
    const double z22 = kept[60];
    const bicycle_lanes z450 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z733 = z732 + k10 * z450 - z22 * z453 + z21 * z455 - z3 * z462;
    const double z298 = kept[252];
    const double z334 = kept[286];
    const double z341 = kept[292];
    const double z346 = kept[295];
    const bicycle_lanes z420 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z421 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z486 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z734 = z341 * z420 - z346 * z421 - z334 * z412 + z330 * z418 - z332 * z486 + z298 *
        z444;
    const double z289 = kept[243];
    const double z296 = kept[250];
    const double z303 = kept[256];
    const bicycle_lanes z492 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z735 = z734 - z296 * z442 - z289 * z472 + z285 * z448 + z303 * z452 + z288 * z457 -
        z208 * z492;
    const double z135 = kept[163];
    const bicycle_lanes z736 = z735 - z143 * z548 + z139 * z550 + z141 * z537 - z135 * z540 + z98 * z571 +
        z95 * z573;
    const double z53 = kept[91];
    const double z91 = kept[126];
    const bicycle_lanes z737 = z736 - z96 * z562 + z91 * z565 - z60 * z594 + z57 * z596 - z58 * z586 + z53 *
        z589;
    const double z44 = kept[82];
    const bicycle_lanes z738 = z190 * z720 - (z195 * z519 - (z196 * z517 - z737)) - z44 * z658 + c1 * z724 +
        z8 * z695;
    const bicycle_lanes z739 = z738 - z22 * z679 + z20 * z676 + z21 * z704 - k10 * (z273 * z456 - c1 * z703);
    const bicycle_lanes z740 = z332 * z412 - z208 * z418 - z196 * z444 + z195 * z442 + z190 * z472 - z8 *
        z448;
    const bicycle_lanes z741 = z740 - z22 * z452 - z21 * z457 - k10 * (c1 * z456) + e2z * z462;
    const bicycle_lanes z742 = z346 * z420 + z341 * z421 + z334 * z418 + z330 * z412 - z332 * z492 + z296 *
        z444;
    const double z279 = kept[233];
    const bicycle_lanes z743 = z742 + z298 * z442 - z289 * z471 + z285 * z446 - z303 * z453 + z288 * z455 +
        z279 * z462;
    const bicycle_lanes z744 = z743 + z208 * z486 + z139 * z548 + z143 * z550 + z135 * z537 + z141 * z540 +
        z95 * z571;
    const bicycle_lanes z745 = z744 - z98 * z573 - z91 * z562 - z96 * z565 + z57 * z594 + z60 * z596 - z53 *
        z586;
    const bicycle_lanes z746 = z190 * z719 + (z196 * z519 + (z195 * z517 - (z745 - z58 * z589))) - z44 * z660
        + c1 * z723;
    const bicycle_lanes z747 = z746 - z8 * z670 - k10 * z697 - z22 * z682 + z21 * z702 - z20 * z684 - z3 *
        z708;
    const double steer_dot = y[10];
    const bicycle_lanes z748 = c_steer * (steer_dot * z733 - (z275 * z462 - (z3 * z687 - z739)) + e2z * z708)
        - s_steer * (e2z * z687 - (steer_dot * z741 - z747));
    bicycle_put(slope + 2 * BICYCLE_LANES, z748);
    const double z343 = kept[294];
    const bicycle_lanes z473 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z478 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z493 = bicycle_get(carried + 78 * BICYCLE_LANES);
    const bicycle_lanes z749 = z273 * z473 + z278 * z478 + z343 * z493 + z43 * z654 + r_R * (z272 * z713 -
        c_roll * z521);
    bicycle_put(slope + 3 * BICYCLE_LANES, -(z749 + c1 * z721 + s1 * z727 + e2z * z715 + c_roll * z463));
    const bicycle_lanes z508 = bicycle_get(carried + 87 * BICYCLE_LANES);
    bicycle_put(slope + 4 * BICYCLE_LANES, s_steer * z733 - (z508 + z726 + c_steer * z741));
    const double z295 = kept[249];
    const double z319 = kept[271];
    const bicycle_lanes z474 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z496 = bicycle_get(carried + 81 * BICYCLE_LANES);
    bicycle_put(slope + 5 * BICYCLE_LANES, -(z295 * z474 - z319 * z437 - z496 - z20 * z672 + z13 * z664));
}

BICYCLE_SLOW
int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[330]; /* what parts of this function leave for others */
    memset(J, 0, 144 * sizeof *J);
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
        static const int entry[] = {0, 12, 24, 36, 60, 96};
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
        double carried[129 * BICYCLE_LANES];
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
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s_pitch = sin(pitch);
    const double c_pitch = cos(pitch);
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double thR_dot = y[11];
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
    const double z1 = s_pitch * c_lam + c_pitch * s_lam;
    const double z2 = c_roll * z1;
    const double z3 = e2z * s_steer - c_steer * z2;
    const double z4 = c_pitch * c_lam - s_pitch * s_lam;
    const double z5 = c_roll * z4;
    const double z6 = c_lam * z3 + s_lam * z5;
    const double z7 = c_lam * z5 - s_lam * z3;
    const double z8 = 1.0 / sqrt(z6 * z6 + z7 * z7);
    const double z9 = r_F * z8;
    const double z10 = z3 * z9;
    const double z11 = k2 + z10;
    const double z12 = c_roll * c_roll;
    const double z13 = 1.0 / sqrt(z12);
    const double z14 = r_R * z13;
    const double z15 = k3 + z2 * z14 + c_steer * z11;
    const double z16 = z5 * z9;
    const double z17 = k4 + z16;
    const double z18 = z5 * z14 - z17;
    const double z19 = s_steer * z18;
    const double z20 = z1 * z17;
    const double z21 = c_roll * (c_steer * z20 + z4 * (c_steer * k3 + z11)) + e2z * z19;
    const double z22 = c_steer * z18;
    const double z23 = z10 * (z22 * z21 + (c_roll * (k3 * (s_steer * z4) + s_steer * z20) - e2z * z22) * z19);
    const double z24 = k5 * (9.0 + fabs(z13));
    const double z25 = r_F * z7;
    const double z26 = z - s_pitch * c_roll * k1 + r_R * (c_pitch * c_roll) - c * z6 - z25 + z6 * (z6 * z9);
    /* 123:10 */
    out[0] = -thR_dot * r_R; /* speed */
    /* 124:16 */
    out[1] = z + z12 * z14; /* rear_height */
    /* 125:17 */
    out[2] = z26 + z8 * (z7 * z25); /* front_height */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX
        && fabs((s_steer * z2 * z11 + e2z * z15) * (z16 * z19) - z15 * (z16 * z21) - z23) > 1e-15 * (k10 *
        ((z24 + k12) * (z24 + k13))))) {
        /* the coframe is singular */
        if (!(fabs((s_steer * z2 * z11 + e2z * z15) * (z16 * z19) - z15 * (z16 * z21) - z23) > 1e-15 * (k10 *
            ((z24 + k12) * (z24 + k13))))) {
            return bicycle_refuse(fabs((s_steer * z2 * z11 + e2z * z15) * (z16 * z19) - z15 * (z16 * z21) -
                z23), 1e-15 * (k10 * ((z24 + k12) * (z24 + k13))), BICYCLE_SINGULAR_1);
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
    const double k38 = fixed[18];
    const double k40 = fixed[19];
    const double k42 = fixed[20];
    const double k45 = fixed[21];
    const double k52 = fixed[22];
    const double k53 = fixed[23];
    const double k56 = fixed[24];
    const double k57 = fixed[25];
    const double k61 = fixed[26];
    const double k62 = fixed[27];
    const double k63 = fixed[28];
    const double k64 = fixed[29];
    const double k65 = fixed[30];
    const double k66 = fixed[31];
    const bicycle_lanes yaw = bicycle_get(y + 3 * stride);
    const bicycle_lanes roll = bicycle_get(y + 4 * stride);
    const bicycle_lanes pitch = bicycle_get(y + 5 * stride);
    const bicycle_lanes steer = bicycle_get(y + 6 * stride);
    const bicycle_lanes roll_dot = bicycle_get(y + 9 * stride);
    const bicycle_lanes steer_dot = bicycle_get(y + 10 * stride);
    const bicycle_lanes thR_dot = bicycle_get(y + 11 * stride);
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
    const bicycle_lanes z14 = k10 + z13;
    const bicycle_lanes z15 = z14 + c_steer * z8;
    const bicycle_lanes z16 = c_roll * z10 + e2z * z15;
    const bicycle_lanes z17 = r_F * z2;
    const bicycle_lanes z18 = z5 * z17;
    const bicycle_lanes z19 = r_R * z2;
    const bicycle_lanes z20 = z11 * z19;
    const bicycle_lanes z21 = k16 + z18;
    const bicycle_lanes z22 = z20 - z21;
    const bicycle_lanes z23 = s_steer * z22;
    const bicycle_lanes z24 = z18 * z23;
    const bicycle_lanes z25 = c_steer * z21;
    const bicycle_lanes z26 = c_steer * k10 + z8;
    const bicycle_lanes z27 = s1 * z25 + c1 * z26;
    const bicycle_lanes z28 = c_roll * z27 + e2z * z23;
    const bicycle_lanes z29 = z18 * z28;
    const bicycle_lanes z30 = c_steer * z22;
    const bicycle_lanes z31 = s_steer * z21;
    const bicycle_lanes z32 = s_steer * k10;
    const bicycle_lanes z33 = s1 * z31 + c1 * z32;
    const bicycle_lanes z34 = c_roll * z33 - e2z * z30;
    const bicycle_lanes z35 = z30 * z28 + z34 * z23;
    const bicycle_lanes z36 = z16 * z24 - z15 * z29 - z7 * z35;
    const bicycle_lanes z37 = k17 * (9.0 + bicycle_size(BICYCLE_SPREAD(z11)));
    /* the coframe is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z36)), 1e-15 * (k22 * ((z37 + k24) * (z37 + k25))));
    const bicycle_lanes z38 = r_R * z11;
    const bicycle_lanes z39 = c_roll * z38;
    const bicycle_lanes z40 = 1.0 / z36;
    const bicycle_lanes z41 = s_steer * c1;
    const bicycle_lanes z42 = z8 * z41;
    const bicycle_lanes z43 = k10 * s1 + z39;
    const bicycle_lanes z44 = s1 * z8 + (c_steer * z43 - c1 * z25);
    const bicycle_lanes z45 = z18 * z44;
    const bicycle_lanes z46 = z21 * z41 - s_steer * z43;
    const bicycle_lanes z47 = z40 * (z24 * z42 + z15 * z45 + z7 * (z30 * z44 - z23 * z46));
    const bicycle_lanes z48 = c_roll * z47;
    const bicycle_lanes z49 = s1 + c1 * z48;
    const bicycle_lanes z50 = c1 - s1 * z48;
    const bicycle_lanes z51 = z40 * (z29 * z42 + z16 * z45 - z7 * (z28 * z46 + z34 * z44)) - e2z * z47;
    const bicycle_lanes z52 = z20 * z51;
    const bicycle_lanes z53 = z13 * z51;
    const bicycle_lanes z54 = k37 * z51 - (k27 * z52 - k28 * z53);
    const bicycle_lanes z55 = z54 + R_yy * z51;
    const bicycle_lanes z56 = k38 * z49 + (k28 * z39 - k35 * z50);
    const bicycle_lanes z57 = z39 + k10 * z49;
    const bicycle_lanes z58 = c_steer * z57 - s_steer * z52;
    const bicycle_lanes z59 = s_steer * z51 - c_steer * z50;
    const bicycle_lanes z60 = k57 * z49 + (k45 * z58 + k53 * z59);
    const bicycle_lanes z61 = z56 + z60;
    const bicycle_lanes z62 = c_steer * z51 + s_steer * z50;
    const bicycle_lanes z63 = c_steer * z52 + s_steer * z57;
    const bicycle_lanes z64 = z14 * z51;
    const bicycle_lanes z65 = k56 * z62 - (k42 * z63 - k45 * z64);
    const bicycle_lanes z66 = k53 * z49 + (k42 * z58 + k52 * z59);
    const bicycle_lanes z67 = k40 * z64 + k45 * z62;
    const bicycle_lanes z68 = k45 * z49 + (k40 * z58 + k42 * z59);
    const bicycle_lanes z69 = k40 * z63 - k42 * z62;
    const bicycle_lanes z70 = k26 * z53 + k28 * z51;
    const bicycle_lanes z71 = k26 * z52 - k27 * z51;
    const bicycle_lanes z72 = k35 * z49 + (k27 * z39 - k34 * z50);
    const bicycle_lanes z73 = z58 * z68 + (z63 * z69 + (z53 * z70 + (z52 * z71 - (z50 * z72 - F_yy * (z62 *
        z62)))));
    const bicycle_lanes z74 = z39 * (k28 * z49 + (k26 * z39 - k27 * z50)) + (z51 * z55 + (z49 * z61 + (z62 *
        z65 + (z59 * z66 + (z64 * z67 + z73)))));
    const bicycle_lanes z75 = z18 * z8;
    const bicycle_lanes z76 = z34 * z8;
    const bicycle_lanes z77 = z30 * z8;
    const bicycle_lanes z78 = z40 * (z15 * z75 + z7 * z77);
    const bicycle_lanes z79 = z40 * (z16 * z75 - z7 * z76) - e2z * z78;
    const bicycle_lanes z80 = z20 * z79;
    const bicycle_lanes z81 = z13 * z79;
    const bicycle_lanes z82 = z79 * k37 - (z80 * k27 - z81 * k28);
    const bicycle_lanes z83 = c_roll * z78;
    const bicycle_lanes z84 = c1 * z83;
    const bicycle_lanes z85 = 1.0 + z84;
    const bicycle_lanes z86 = k10 * z84;
    const bicycle_lanes z87 = c_steer * z86 - s_steer * z80;
    const bicycle_lanes z88 = s1 * z83;
    const bicycle_lanes z89 = s_steer * z79 + c_steer * z88;
    const bicycle_lanes z90 = k57 * z85 + (k45 * z87 + k53 * z89);
    const bicycle_lanes z91 = c_steer * z79 - s_steer * z88;
    const bicycle_lanes z92 = c_steer * z80 + s_steer * z86;
    const bicycle_lanes z93 = z14 * z79;
    const bicycle_lanes z94 = k56 * z91 - (k42 * z92 - k45 * z93);
    const bicycle_lanes z95 = k53 * z85 + (k42 * z87 + k52 * z89);
    const bicycle_lanes z96 = k40 * z93 + k45 * z91;
    const bicycle_lanes z97 = k45 * z85 + (k40 * z87 + k42 * z89);
    const bicycle_lanes z98 = k40 * z92 - k42 * z91;
    const bicycle_lanes z99 = k34 * z88 + k35 * z84;
    const bicycle_lanes z100 = z80 * k26 - z79 * k27;
    const bicycle_lanes z101 = z81 * k26 + z79 * k28;
    const bicycle_lanes z102 = z40 * (z16 * z77 + z15 * z76) + z91;
    const bicycle_lanes z103 = k38 * z84 + k35 * z88;
    const bicycle_lanes z104 = z92 * z98 + (z88 * z99 + (z80 * z100 + (z81 * z101 + F_yy * (z102 * z102))) +
        z84 * z103);
    const bicycle_lanes z105 = z79 * (z82 + R_yy * z79) + (z85 * z90 + (z91 * z94 + (z89 * z95 + (z93 * z96 +
        (z87 * z97 + z104)))));
    const bicycle_lanes z106 = z92 * z69 + (z84 * z56 + (z88 * z72 + (z80 * z71 + (z81 * z70 + F_yy * (z102 *
        z62)))));
    const bicycle_lanes z107 = z79 * z55 + (z85 * z60 + (z91 * z65 + (z89 * z66 + (z93 * z67 + (z87 * z68 +
        z106)))));
    const bicycle_lanes z108 = 1.0 / z74;
    const bicycle_lanes z109 = z107 * z108;
    const bicycle_lanes z110 = z105 - z107 * z109;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z110)), 1e-14 * z105);
    const bicycle_lanes z111 = s_steer * z20;
    const bicycle_lanes z112 = z40 * (z13 * z24 - z15 * (z18 * z111));
    const bicycle_lanes z113 = c_roll * z112;
    const bicycle_lanes z114 = c1 * z113;
    const bicycle_lanes z115 = k10 * z114;
    const bicycle_lanes z116 = e2z * z112;
    const bicycle_lanes z117 = 1.0 - z116;
    const bicycle_lanes z118 = z20 * z117;
    const bicycle_lanes z119 = c_steer * z115 - s_steer * z118;
    const bicycle_lanes z120 = s1 * z113;
    const bicycle_lanes z121 = s_steer * z116 - c_steer * z120;
    const bicycle_lanes z122 = c_steer * z116 + s_steer * z120;
    const bicycle_lanes z123 = c_steer * z118 + s_steer * z115;
    const bicycle_lanes z124 = z13 * z117;
    const bicycle_lanes z125 = z124 - k10 * z116;
    const bicycle_lanes z126 = z120 * (k34 * z120 + k35 * z114) + (z118 * (k26 * z118 + k27 * z116) + z124 *
        (k26 * z124 - k28 * z116));
    const bicycle_lanes z127 = z114 * (k35 * z120 + k38 * z114) + (z116 * (k37 * z116 + (k27 * z118 - k28 *
        z124)) + z126);
    const bicycle_lanes z128 = z119 * (k45 * z114 + (k40 * z119 - k42 * z121)) + (z123 * (k40 * z123 + k42 *
        z122) + z127);
    const bicycle_lanes z129 = z121 * (k53 * z114 + (k42 * z119 - k52 * z121)) - (z125 * (k40 * z125 - k45 *
        z122) + z128);
    const bicycle_lanes z130 = z114 * (k57 * z114 + (k45 * z119 - k53 * z121)) + (z122 * (k56 * z122 + (k42 *
        z123 - k45 * z125)) - z129);
    const bicycle_lanes z131 = z40 * (z15 * (c_steer * z20 * z28 + z34 * z111) - z13 * z35) + z122;
    const bicycle_lanes z132 = z130 + R_yy * (z117 * z117) + F_yy * (z131 * z131);
    const bicycle_lanes z133 = F_yy * z131;
    const bicycle_lanes z134 = R_yy * z117;
    const bicycle_lanes z135 = z116 * z54 - (z120 * z72 + (z118 * z71 + (z124 * z70 - (z133 * z62 - z134 *
        z51))));
    const bicycle_lanes z136 = z114 * z61 - (z122 * z65 + (z121 * z66 - (z125 * z67 + (z119 * z68 + (z123 *
        z69 - z135)))));
    const bicycle_lanes z137 = z136 * z108;
    const bicycle_lanes z138 = z99 * z120 + (z100 * z118 + (z101 * z124 + (z79 * z134 - z102 * z133 - z107 *
        z137)));
    const bicycle_lanes z139 = z94 * z122 + (z95 * z121 - (z96 * z125 + (z97 * z119 + (z98 * z123 - (z82 *
        z116 - z138)))));
    const bicycle_lanes z140 = z114 * (z103 + z90) - z139;
    const bicycle_lanes z141 = 1.0 / z110;
    const bicycle_lanes z142 = z140 * z141;
    const bicycle_lanes z143 = z132 - z136 * z137 - z140 * z142;
    /* the mass matrix is singular */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z143)), 1e-14 * z132);
    bicycle_lanes sine4, cosine4;
    bicycle_turn_lanes(BICYCLE_SPREAD(yaw), &far, &sine4, &cosine4);
    const bicycle_lanes c_yaw = cosine4;
    const bicycle_lanes z144 = roll_dot * c1;
    const bicycle_lanes z145 = s_steer * z144;
    const bicycle_lanes z146 = thR_dot * z13 - z8 * z145;
    const bicycle_lanes z147 = roll_dot * s1;
    const bicycle_lanes z148 = steer_dot + z147;
    const bicycle_lanes z149 = c_steer * z144;
    const bicycle_lanes z150 = thR_dot * z20;
    const bicycle_lanes v2_x = roll_dot * z39;
    const bicycle_lanes z151 = k10 * z147 + v2_x;
    const bicycle_lanes z152 = z148 * z8 - (z21 * z149 - (s_steer * z150 + c_steer * z151));
    const bicycle_lanes z153 = z18 * z152;
    const bicycle_lanes z154 = z21 * z145 + (c_steer * z150 - s_steer * z151);
    const bicycle_lanes z155 = z28 * z154 + z34 * z152;
    const bicycle_lanes z156 = z40 * (z29 * z146 - z16 * z153 + z7 * z155);
    const bicycle_lanes z157 = z30 * z152 - z23 * z154;
    const bicycle_lanes z158 = z40 * (z24 * z146 - z15 * z153 - z7 * z157);
    const bicycle_lanes w2 = z156 - e2z * z158;
    const bicycle_lanes z159 = thR_dot + w2;
    const bicycle_lanes z160 = z13 * z159;
    const bicycle_lanes z161 = z20 * z159;
    const bicycle_lanes z162 = s1 * z160 + c1 * z161;
    const bicycle_lanes s_yaw = sine4;
    const bicycle_lanes z163 = c_roll * v2_x;
    const bicycle_lanes z164 = z40 * (z35 * z146 - (z16 * z157 + z15 * z155));
    const bicycle_lanes z165 = c1 * z156;
    const bicycle_lanes z166 = roll_dot * z165;
    const bicycle_lanes z167 = c_roll * z158;
    const bicycle_lanes z168 = s1 * z156;
    const bicycle_lanes z169 = roll_dot * e2z;
    const bicycle_lanes z170 = steer_dot * c_steer;
    const bicycle_lanes z171 = z169 * c1 + c_roll * z168;
    const bicycle_lanes z172 = roll_dot * c_roll;
    const bicycle_lanes z173 = steer_dot * s_steer;
    const bicycle_lanes z174 = z169 * s1 - c_roll * z165;
    const bicycle_lanes z175 = s_steer * z172 + e2z * z170 + (z173 * z3 + c_steer * z174);
    const bicycle_lanes z176 = (z2 * z171 - z4 * z175) * (z5 * (z5 * z5));
    const bicycle_lanes z177 = r_F * z5;
    const bicycle_lanes z178 = z6 * z176 + z177 * z175;
    const bicycle_lanes z179 = z11 * (c_roll * z169) * (z11 * z11);
    const bicycle_lanes z180 = z12 * z179 - z38 * z174;
    const bicycle_lanes z181 = z180 - (z173 * z8 - c_steer * z178);
    const bicycle_lanes z182 = c_roll * (z9 * z165 + s1 * (z170 * z8 + s_steer * z178)) - (z169 * z10 - (z172
        * z15 + e2z * z181));
    const bicycle_lanes z183 = z145 - z164;
    const bicycle_lanes z184 = roll_dot * z168;
    const bicycle_lanes z185 = z170 * z144 - s_steer * z184;
    const bicycle_lanes z186 = z158 * z182 + (z178 * z183 + (z8 * z185 - (thR_dot * z180 + z156 * z181)));
    const bicycle_lanes z187 = z17 * z176 - z177 * z171;
    const bicycle_lanes z188 = s1 * (z173 * z21 - c_steer * z187) + (c1 * (z173 * k10 - z178) - (z25 * z165 -
        z26 * z168));
    const bicycle_lanes z189 = z19 * z179 - z38 * z171;
    const bicycle_lanes z190 = z189 - z187;
    const bicycle_lanes z191 = z170 * z22 + s_steer * z190;
    const bicycle_lanes z192 = thR_dot * z189;
    const bicycle_lanes z193 = k10 * z166;
    const bicycle_lanes z194 = z149 * z187 + (z173 * z151 - (z148 * z178 + (z156 * z191 + (s_steer * z192 +
        c_steer * z193))));
    const bicycle_lanes z195 = z158 * (c_roll * z188 + (z169 * z27 - (z172 * z23 + e2z * z191))) + (z8 * z166
        + (z21 * (z173 * z144 + c_steer * z184) + (z170 * z150 - z194)));
    const bicycle_lanes z196 = z18 * z195;
    const bicycle_lanes z197 = s1 * (z170 * z21 + s_steer * z187) + (z31 * z165 - (z32 * z168 - k10 * (z170 *
        c1)));
    const bicycle_lanes z198 = z173 * z22 - c_steer * z190;
    const bicycle_lanes z199 = z21 * z185 - (z173 * z150 + (z170 * z151 + (z156 * z198 - (c_steer * z192 -
        s_steer * z193))));
    const bicycle_lanes z200 = z158 * (c_roll * z197 - (z169 * z33 + (z172 * z30 - e2z * z198))) + (z187 *
        z183 + z199);
    const bicycle_lanes z201 = z30 * z195 - z23 * z200;
    const bicycle_lanes z202 = z40 * (z24 * z186 + z15 * z196 + z7 * z201);
    const bicycle_lanes z203 = z169 * z158 + c_roll * z202;
    const bicycle_lanes z204 = z166 + (z167 * z168 + c1 * z203);
    const bicycle_lanes z205 = z147 - c1 * z167;
    const bicycle_lanes z206 = z144 + s1 * z167;
    const bicycle_lanes z207 = z161 * z205 - z160 * z206;
    const bicycle_lanes z208 = k27 * w2;
    const bicycle_lanes z209 = k28 * w2;
    const bicycle_lanes z210 = z184 - (z167 * z165 - s1 * z203);
    const bicycle_lanes z211 = k28 * z204 - (k26 * z207 - (z205 * z208 - (e2z * k61 - z206 * z209) + k27 *
        z210));
    const bicycle_lanes z212 = z28 * z200 + z34 * z195;
    const bicycle_lanes z213 = z40 * (z29 * z186 + z16 * z196 - z7 * z212) + (z172 * z158 - e2z * z202);
    const bicycle_lanes z214 = z159 * z189 - z20 * z213 + (w2 * z160 + v2_x * z205);
    const bicycle_lanes z215 = z159 * z180 - z13 * z213 - (w2 * z161 + v2_x * z206);
    const bicycle_lanes z216 = k34 * z206 - k35 * z205;
    const bicycle_lanes z217 = k38 * z205 - k35 * z206;
    const bicycle_lanes z218 = z3 * k63 + z2 * k62 - (k37 * z213 + (k27 * z214 - k28 * z215) - (z205 * z216 -
        z206 * z217));
    const bicycle_lanes z219 = R_yy * z213;
    const bicycle_lanes z220 = z218 - z219;
    const bicycle_lanes z221 = R_yy * z159 + k37 * w2;
    const bicycle_lanes z222 = e2z * k62 - (z206 * z221 - w2 * z216 + (k38 * z204 - (k28 * z207 - k35 *
        z210)));
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z3;
    const bicycle_lanes z223 = s_steer * w2 + c_steer * z206;
    const bicycle_lanes z224 = c_steer * w2 - s_steer * z206;
    const bicycle_lanes z225 = F_yy * (z164 + z224) + k56 * z224;
    const bicycle_lanes w3_steer = steer_dot + z205;
    const bicycle_lanes z226 = k52 * z223 - k53 * w3_steer;
    const bicycle_lanes z227 = k10 * w2;
    const bicycle_lanes z228 = z207 - (z227 * z206 + k10 * z204);
    const bicycle_lanes z229 = k10 * z205;
    const bicycle_lanes z230 = w2 * z227 + z205 * z229 + z214;
    const bicycle_lanes z231 = c_steer * z228 - s_steer * z230;
    const bicycle_lanes z232 = z170 * w2 - s_steer * z213 - (z173 * z206 + c_steer * z210);
    const bicycle_lanes z233 = h2z * k66 + (z223 * z225 - z224 * z226 + (k57 * z204 - (k45 * z231 + k53 *
        z232)));
    const bicycle_lanes z234 = z222 - z233;
    const bicycle_lanes z235 = z173 * w2 + c_steer * z213 + (z170 * z206 - s_steer * z210);
    const bicycle_lanes z236 = c_steer * z230 + s_steer * z228;
    const bicycle_lanes z237 = z215 - (z206 * z229 + k10 * z213);
    const bicycle_lanes z238 = k57 * w3_steer - k53 * z223;
    const bicycle_lanes z239 = z4 * k65 + (k56 * z235 + (k42 * z236 - (k45 * z237 + (w3_steer * z226 - z223 *
        z238))));
    const bicycle_lanes z240 = z2 * k66 + z239;
    const bicycle_lanes z241 = h2z * k65 - (k53 * z204 - (k42 * z231 + k52 * z232) + (w3_steer * z225 - z224
        * z238));
    const bicycle_lanes z242 = k42 * z223 - k45 * w3_steer;
    const bicycle_lanes z243 = k42 * z224;
    const bicycle_lanes z244 = z2 * k64 + (z223 * z242 + z224 * z243 + (k40 * z237 - k45 * z235));
    const bicycle_lanes z245 = k45 * z224;
    const bicycle_lanes z246 = h2z * k64 - (w3_steer * z243 + z223 * z245 + (k45 * z204 - (k40 * z231 + k42 *
        z232)));
    const bicycle_lanes z247 = z4 * k64 + (z224 * z245 - w3_steer * z242 + (k40 * z236 + k42 * z235));
    const bicycle_lanes z248 = e2z * k63 - (k35 * z204 - (k27 * z207 - k34 * z210) + (z205 * z221 - w2 *
        z217));
    const bicycle_lanes z249 = k27 * z206 - k28 * z205;
    const bicycle_lanes z250 = z2 * k61 + (z206 * z249 + w2 * z208 + (k26 * z215 - k28 * z213));
    const bicycle_lanes z251 = z3 * k61 - (w2 * z209 - z205 * z249 + (k26 * z214 + k27 * z213));
    const bicycle_lanes z252 = F_yy * (z40 * (z35 * z186 + (z16 * z201 + z15 * z212)) + z235);
    const bicycle_lanes z253 = z58 * z246 + (z63 * z247 - (z50 * z248 - (z53 * z250 - (z52 * z251 + z62 *
        z252))));
    const bicycle_lanes z254 = z39 * z211 - (z51 * z220 + (z49 * z234 - (z62 * z240 - (z59 * z241 + (z64 *
        z244 + z253)))));
    const bicycle_lanes z255 = z84 * z222 + (z88 * z248 - (z80 * z251 - (z81 * z250 + (z254 * z109 - z102 *
        z252))));
    const bicycle_lanes z256 = z85 * z233 + (z91 * z240 - (z89 * z241 + (z93 * z244 + (z87 * z246 + (z92 *
        z247 + z255)))));
    const bicycle_lanes z257 = z79 * z220 - z256;
    const bicycle_lanes z258 = z118 * z251 - (z124 * z250 + (z254 * z137 - (z142 * z257 + (z117 * z219 - z131
        * z252))));
    const bicycle_lanes z259 = z121 * z241 - (z125 * z244 + (z119 * z246 + (z123 * z247 - (z116 * z218 -
        (z120 * z248 - z258)))));
    const bicycle_lanes z260 = (z114 * z234 + (z122 * z240 - z259)) / z143;
    const bicycle_lanes z261 = z141 * z257 - z142 * z260;
    /* (I.2.15) */
    const bicycle_lanes slope1 = -(c_yaw * z162 + s_yaw * z163);
    sum += slope1;
    bicycle_put(dydt, slope1);
    const bicycle_lanes slope2 = c_yaw * z163 - s_yaw * z162;
    sum += slope2;
    bicycle_put(dydt + 1 * stride, slope2);
    const bicycle_lanes slope3 = e2z * v2_x;
    bicycle_put(dydt + 2 * stride, slope3);
    const bicycle_lanes slope4 = -z158;
    bicycle_put(dydt + 3 * stride, slope4);
    const bicycle_lanes slope5 = roll_dot;
    bicycle_put(dydt + 4 * stride, slope5);
    const bicycle_lanes slope6 = z156;
    bicycle_put(dydt + 5 * stride, slope6);
    const bicycle_lanes slope7 = steer_dot;
    bicycle_put(dydt + 6 * stride, slope7);
    const bicycle_lanes slope8 = thR_dot;
    bicycle_put(dydt + 7 * stride, slope8);
    const bicycle_lanes slope9 = z164;
    bicycle_put(dydt + 8 * stride, slope9);
    /* (I.2.15) 112:4 */
    const bicycle_lanes slope10 = -(z254 * z108 + z109 * z261 + z137 * z260);
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = z261;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = -z260;
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
    const double k38 = k36 + (c_lam * (k31 + c_lam * k8) + s_lam * (k29 + s_lam * k7));
    const double k39 = m_F * k16;
    const double k40 = m_H + m_F;
    const double k41 = m_H * k15;
    const double k42 = k39 + k41;
    const double k43 = m_F * k4;
    const double k44 = m_H * k9;
    const double k45 = k43 - k44;
    const double k46 = H_xz * c_lam;
    const double k47 = s_lam * k5 - k46;
    const double k48 = H_xz * s_lam;
    const double k49 = c_lam * k6 - k48;
    const double k50 = k16 * k39;
    const double k51 = k15 * k41;
    const double k52 = s_lam * k47 + c_lam * k49 + k50 + k51;
    const double k53 = c_lam * k47 - s_lam * k49 + k4 * k39 - k9 * k41;
    const double k54 = k4 * k43;
    const double k55 = k9 * k44;
    const double k56 = k51 + (k50 + (H_yy + k54) + k55);
    const double k57 = k55 + (k54 + (c_lam * (k48 + c_lam * k5) + s_lam * (k46 + s_lam * k6)));
    const double k58 = g * m_F;
    const double k59 = g * m_H;
    const double k60 = g * m_B;
    const double k61 = g * k26;
    const double k62 = k12 * k60;
    const double k63 = k11 * k60;
    const double k64 = g * k40;
    const double k65 = k15 * k59 + k16 * k58;
    const double k66 = k9 * k59 - k4 * k58;
    const double fixed[] = {lam, r_R, R_yy, r_F, F_yy, k4, k10, k16, k17, k22, k24, k25, k26, k27, k28, k34,
        k35, k37, k38, k40, k42, k45, k52, k53, k56, k57, k61, k62, k63, k64, k65, k66};
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
