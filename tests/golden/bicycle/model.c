/*
 * bicycle.c: bicycle, emitted by nhc 0.1.0 (nhc:26925fbd9751d8aa)
 * Whipple's bicycle, nonlinear; two wheels, rear frame with rider, front frame; x ahead, y right, z down.
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: coframe completed by nhc with roll', steer', thF': the dependent velocities of the spec (x', y', z',
 *     yaw', pitch', thF') are singular somewhere
 * bicycle.h says what each function does.
 */
#include "bicycle.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if defined(__SSE2__) && !defined(__NO_MATH_ERRNO__)
#include <emmintrin.h>
#define BICYCLE_SSE2
#endif

const char *const bicycle_coordinate_names[BICYCLE_NQ] = {
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
const char *const bicycle_state_names[BICYCLE_NY] = {
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
const char *const bicycle_parameter_names[BICYCLE_NP] = {
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
const char *const bicycle_constraint_names[BICYCLE_NC] = {
    "rear_x",
    "rear_y",
    "rear_z",
    "front_x",
    "front_y",
    "front_z"
};
const char *const bicycle_output_names[BICYCLE_NOUT] = {
    "speed",
    "rear_height",
    "front_height"
};
const double bicycle_parameter_defaults[BICYCLE_NP] = {
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

/* the machine's own root: it sets no errno, so that no call of libm's stands behind it, which would cost its caller registers */
static inline double bicycle_root(double x)
{
#ifdef BICYCLE_SSE2
    const __m128d v = _mm_set_sd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(v, v));
#else
    return sqrt(x);
#endif
}

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int bicycle_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
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

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
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
static void bicycle_place(int passes, const int *offset, int count, const int *entry,
    const double *slope, double *out)
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
static int bicycle_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = BICYCLE_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[BICYCLE_NY];
        double slope[BICYCLE_NY];
        for (size_t k = 0; k < BICYCLE_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
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

/* makes a NaN of each lane whose bits are set */
static inline bicycle_lanes bicycle_mark(bicycle_lanes value, bicycle_bits bad)
{
    return (bicycle_lanes)((bicycle_bits)value | bad);
}

static inline bicycle_lanes bicycle_size(bicycle_lanes x)
{
    return (bicycle_lanes)((bicycle_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
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

/* the last states, fewer than there are lanes; the other lanes repeat the last one */
static inline void bicycle_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < BICYCLE_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < BICYCLE_NY; ++k) {
            state[k * BICYCLE_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void bicycle_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < BICYCLE_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * BICYCLE_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void bicycle_turn_lanes(bicycle_lanes x, bicycle_lanes *far,
    bicycle_lanes *sine, bicycle_lanes *cosine)
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

int bicycle_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double yaw = y[3]; /* first turn of the rear frame, about z [rad] */
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double z2 = pitch + lam;
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s1 = sin(z2);
    const double c1 = cos(z2);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);

    /* what else is read */
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double thF_dot = y[11]; /* thF' [rad/s] */
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

    /* from the parameters alone */
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = H_zz + F_xx;
    const double k5 = H_xx + F_xx;
    const double k6 = R_xx + B_xx;
    const double k7 = R_xx + B_zz;
    const double k8 = x_H - k2;
    const double k9 = r_R * s_lam - c_lam * k2;
    const double k10 = z_H * s_lam - c_lam * k8;
    const double k11 = r_R * c_lam + s_lam * k2;
    const double k12 = c_lam * k1 + x_B * s_lam;
    const double k13 = s_lam * k1 - x_B * c_lam;
    const double k14 = fabs(r_R);
    const double k15 = fabs(r_F);
    const double k16 = fabs(w);
    const double k17 = fabs(c);
    const double k18 = 9.0 * k15;
    const double k19 = 6.0 * k17 + (2.0 * k16 + (5.0 * k14 + k18));
    const double k20 = 6.0 * k16;
    const double k21 = m_R + m_B;
    const double k22 = m_B * k12;
    const double k23 = m_B * k13;
    const double k24 = B_xz * c_lam;
    const double k25 = s_lam * k7 - k24;
    const double k26 = B_xz * s_lam;
    const double k27 = c_lam * k6 - k26;
    const double k28 = k12 * k22;
    const double k29 = s_lam * k25 + c_lam * k27 + k28;
    const double k30 = c_lam * k25 - s_lam * k27 - k13 * k22;
    const double k31 = k13 * k23;
    const double k32 = k28 + (B_yy + k31);
    const double k33 = k31 + (c_lam * (k26 + c_lam * k7) + s_lam * (k24 + s_lam * k6));
    const double k34 = m_H + m_F;
    const double k35 = m_F * k3;
    const double k36 = H_xz * c_lam;
    const double k37 = s_lam * k4 - k36;
    const double k38 = H_xz * s_lam;
    const double k39 = c_lam * k5 - k38;
    const double k40 = m_H * k10;
    const double k41 = k35 - k40;
    const double k42 = g * m_F;
    const double k43 = g * m_H;
    const double k44 = g * m_B;
    const double k45 = g * k21;
    const double k46 = k13 * k44;
    const double k47 = k12 * k44;
    const double k48 = g * k34;
    const double k49 = k11 + (z_H * c_lam + s_lam * k8);
    const double k50 = r_F * c_lam + c * s_lam - k11;
    const double k51 = 14.0 * k15 + 13.0 * k17;
    const double k52 = k18 + 10.0 * k17;
    const double k53 = m_F * k50;
    const double k54 = m_H * k49;
    const double k55 = k53 - k54;
    const double k56 = k50 * k53 + k49 * k54;
    const double k57 = s_lam * k37 + c_lam * k39 + k56;
    const double k58 = c_lam * k37 - s_lam * k39 - k3 * k53 - k10 * k54;
    const double k59 = k3 * k35 + k10 * k40;
    const double k60 = k59 + (H_yy + k56);
    const double k61 = c_lam * (k38 + c_lam * k4) + s_lam * (k36 + s_lam * k5) + k59;
    const double k62 = k43 * k49 - k42 * k50;
    const double k63 = k3 * k42 - k10 * k43;

    /* from the state */
    const double z1 = 1.0 / fabs(c_roll);
    const double z3 = c_roll * s1;
    const double z4 = r_R * z3;
    const double z5 = z1 * z4;
    const double z6 = k9 - z5;
    const double z7 = c_roll * c1;
    const double z8 = e2z * s_steer - c_steer * z3;
    const double z9 = 1.0 / bicycle_root(z7 * z7 + z8 * z8);
    const double z10 = r_F * z8;
    const double z11 = z9 * z10;
    const double z12 = k3 + z11;
    const double z13 = z6 - c_steer * z12;
    const double z14 = r_R * z7;
    const double z15 = z1 * z14;
    const double z16 = c_steer * z15;
    const double z17 = c_steer * k9;
    const double z18 = z17 - z12;
    const double z19 = r_F * z7;
    const double z20 = z9 * z19;
    const double z21 = z20 - k50;
    const double z22 = c_steer * z21;
    const double z23 = c1 * z18 - s1 * z22;
    const double z24 = z15 - z21;
    const double z25 = s_steer * z24;
    const double z26 = c_roll * z23 - e2z * z25;
    const double z27 = s_steer * z15;
    const double z28 = s_steer * k9;
    const double z29 = s_steer * z21;
    const double z30 = c1 * z28 - s1 * z29;
    const double z31 = c_steer * z24;
    const double z32 = c_roll * z30 + e2z * z31;
    const double z33 = z16 * z26 + z27 * z32;
    const double z34 = z31 * z26 + z32 * z25;
    const double z35 = z13 * z33 + z5 * z34;
    const double z36 = k20 + k14 * (9.0 + fabs(z1));
    const double z37 = r_R * z1;
    const double z38 = c_roll * z37;
    const double z39 = 1.0 / z35;
    const double z40 = k9 * s1 - z38;
    const double z41 = s1 * z12 - (c_steer * z40 + c1 * z22);
    const double z42 = s_steer * c1;
    const double z43 = s_steer * z40 + z42 * z21;
    const double z44 = z16 * z41 - z27 * z43;
    const double z45 = z39 * (z13 * z44 + z5 * (z31 * z41 - z25 * z43));
    const double z46 = c_roll * z45;
    const double z47 = s1 + c1 * z46;
    const double z48 = c1 - s1 * z46;
    const double z49 = s_steer * z12;
    const double z50 = s1 * z49;
    const double z51 = c_roll * z50 - e2z * z13;
    const double z52 = (z42 * (z12 * z33) - z51 * z44 + z5 * (z26 * z43 + z32 * z41)) * z39 - e2z * z45;
    const double z53 = c_steer * z52 + s_steer * z48;
    const double z54 = z15 * z52;
    const double z55 = z38 - k9 * z47;
    const double z56 = c_steer * z54 + s_steer * z55;
    const double z57 = z6 * z52;
    const double z58 = k60 * z53 + (k55 * z56 - k41 * z57);
    const double z59 = F_yy * z53;
    const double z60 = k33 * z47 - (k23 * z38 + k30 * z48);
    const double z61 = c_steer * z55 - s_steer * z54;
    const double z62 = s_steer * z52 - c_steer * z48;
    const double z63 = k61 * z47 + (k41 * z61 + k58 * z62);
    const double z64 = z60 + z63;
    const double z65 = k58 * z47 - (k55 * z61 - k57 * z62);
    const double z66 = k34 * z57 - k41 * z53;
    const double z67 = k41 * z47 + (k34 * z61 - k55 * z62);
    const double z68 = k34 * z56 + k55 * z53;
    const double z69 = z5 * z52;
    const double z70 = k32 * z52 - (k22 * z54 + k23 * z69);
    const double z71 = k21 * z69 - k23 * z52;
    const double z72 = k21 * z54 - k22 * z52;
    const double z73 = k30 * z47 + (k22 * z38 - k29 * z48);
    const double z74 = z56 * z68 + (z52 * z70 + (z69 * z71 + (z54 * z72 - (z48 * z73 - R_yy * (z52 * z52)))));
    const double z75 = z53 * (z58 + z59) + (z47 * z64 + (z62 * z65 + (z57 * z66 + (z61 * z67 + z74))));
    const double z76 = z38 * (k23 * z47 - (k21 * z38 - k22 * z48)) - z75;
    const double z77 = z16 * z12;
    const double z78 = z12 * z31;
    const double z79 = (z13 * z77 + z5 * z78) * z39;
    const double z80 = c_roll * z79;
    const double z81 = c1 * z80;
    const double z82 = 1.0 + z81;
    const double z83 = z12 * z32;
    const double z84 = (z51 * z77 - z5 * z83) * z39 + e2z * z79;
    const double z85 = (z51 * z78 + z13 * z83) * z39 - z84;
    const double z86 = z15 * z85;
    const double z87 = z17 * z81 + s_steer * z86;
    const double z88 = s1 * z80;
    const double z89 = s_steer * z84 - c_steer * z88;
    const double z90 = k61 * z82 - (k41 * z87 + k58 * z89);
    const double z91 = k58 * z82 + (k55 * z87 - k57 * z89);
    const double z92 = k41 * z82 - (k34 * z87 - k55 * z89);
    const double z93 = k30 * z88 + k33 * z81;
    const double z94 = z5 * z85;
    const double z95 = k32 * z84 + (k22 * z86 + k23 * z94);
    const double z96 = k29 * z88 + k30 * z81;
    const double z97 = k21 * z86 + k22 * z84;
    const double z98 = k21 * z94 + k23 * z84;
    const double z99 = z81 * z93 + (z84 * z95 + (z88 * z96 + (z86 * z97 + (z94 * z98 + R_yy * (z85 * z85)))));
    const double z100 = z82 * z90 - (z89 * z91 + (z87 * z92 - z99));
    const double z101 = z81 * z60 - (z84 * z70 - (z88 * z73 + (z86 * z72 + (z94 * z71 + R_yy * (z85 *
        z52)))));
    const double z102 = z82 * z63 - (z89 * z65 + (z87 * z67 - z101));
    const double z103 = 1.0 / z76;
    const double z104 = z102 * z103;
    const double z105 = z100 + z102 * z104;
    const double z106 = z20 * z13;
    const double z107 = z20 * z25;
    const double z108 = z39 * (z27 * z106 + z5 * z107);
    const double z109 = c_roll * z108;
    const double z110 = c1 * z109;
    const double z111 = k9 * z110;
    const double z112 = e2z * z108;
    const double z113 = (z51 * z107 - z26 * z106 + z11 * z34) * z39 - z112;
    const double z114 = z15 * z113;
    const double z115 = c_steer * z111 + s_steer * z114;
    const double z116 = s1 * z109;
    const double z117 = s_steer * z112 - c_steer * z116;
    const double z118 = c_steer * z112 + s_steer * z116;
    const double z119 = c_steer * z114 - s_steer * z111;
    const double z120 = z5 * z113;
    const double z121 = z120 + k9 * z112;
    const double z122 = z116 * (k29 * z116 + k30 * z110) + (z114 * (k21 * z114 + k22 * z112) + z120 * (k21 *
        z120 + k23 * z112));
    const double z123 = z110 * (k30 * z116 + k33 * z110) + (z112 * (k32 * z112 + (k22 * z114 + k23 * z120)) +
        z122);
    const double z124 = z115 * (k41 * z110 - (k34 * z115 - k55 * z117)) - (z119 * (k34 * z119 - k55 * z118) +
        z123);
    const double z125 = z117 * (k58 * z110 + (k55 * z115 - k57 * z117)) - (z121 * (k34 * z121 - k41 * z118) -
        z124);
    const double z126 = z110 * (k61 * z110 - (k41 * z115 + k58 * z117)) + (z118 * (k60 * z118 - (k55 * z119 +
        k41 * z121)) - z125);
    const double z127 = 1.0 + z118;
    const double z128 = z126 + R_yy * (z113 * z113) + F_yy * (z127 * z127);
    const double z129 = R_yy * z113;
    const double z130 = z112 * z70 - (z116 * z73 + (z114 * z72 + (z120 * z71 + (z129 * z52 - z127 * z59))));
    const double z131 = z110 * z64 - (z118 * z58 + (z117 * z65 + (z121 * z66 + (z115 * z67 - (z119 * z68 -
        z130)))));
    const double z132 = z131 * z103;
    const double z133 = z112 * z95 + (z116 * z96 + (z114 * z97 + (z120 * z98 + (z102 * z132 + z85 * z129))));
    const double z134 = z110 * (z93 + z90) - (z117 * z91 + (z115 * z92 - z133));
    const double z135 = 1.0 / z105;
    const double z136 = z134 * z135;
    const double z137 = z128 + z131 * z132 - z134 * z136;
    const double z138 = roll_dot * c1;
    const double z139 = s_steer * z138;
    const double z140 = thF_dot - z139;
    const double z141 = k3 * z139 - z11 * z140;
    const double z142 = roll_dot * s1;
    const double v2_x = roll_dot * z38;
    const double z143 = k9 * z142 - v2_x;
    const double z144 = z20 * z140 + (z139 * k50 - s_steer * z143);
    const double z145 = steer_dot + z142;
    const double z146 = c_steer * z138;
    const double z147 = z145 * z12 - (c_steer * z143 + z146 * z21);
    const double z148 = z25 * z144 + z31 * z147;
    const double z149 = z26 * z144 - z32 * z147;
    const double z150 = (z141 * z34 - (z51 * z148 - z13 * z149)) * z39;
    const double z151 = z27 * z144 + z16 * z147;
    const double z152 = (z141 * z33 - z51 * z151 - z5 * z149) * z39;
    const double z153 = z39 * (z13 * z151 + z5 * z148);
    const double z154 = z152 - e2z * z153;
    const double z155 = z150 - z154;
    const double z156 = z5 * z155;
    const double z157 = z15 * z155;
    const double z158 = s1 * z156 + c1 * z157;
    const double z159 = c_roll * v2_x;
    const double z160 = c1 * z152;
    const double z161 = roll_dot * z160;
    const double z162 = c_roll * z153;
    const double z163 = s1 * z152;
    const double z164 = roll_dot * e2z;
    const double z165 = steer_dot * s_steer;
    const double z166 = z164 * c1 - c_roll * z163;
    const double z167 = roll_dot * c_roll;
    const double z168 = steer_dot * c_steer;
    const double z169 = z164 * s1 + c_roll * z160;
    const double z170 = s_steer * z167 + e2z * z168 + (z165 * z3 + c_steer * z169);
    const double z171 = (z7 * z166 - z8 * z170) * (z9 * (z9 * z9));
    const double z172 = r_F * z9;
    const double z173 = z19 * z171 - z172 * z166;
    const double z174 = z10 * z171 + z172 * z170;
    const double z175 = s1 * (z165 * z21 - c_steer * z173) - (c1 * (z165 * k9 + z174) - (z22 * z160 + z18 *
        z163));
    const double z176 = z1 * (c_roll * z164) * (z1 * z1);
    const double z177 = z14 * z176 - z37 * z166;
    const double z178 = z177 - z173;
    const double z179 = z168 * z24 + s_steer * z178;
    const double z180 = roll_dot * z163;
    const double z181 = k9 * z161;
    const double z182 = z21 * (z165 * z138 - c_steer * z180) - (z146 * z173 - (z165 * z143 + (z145 * z174 +
        (c_steer * z181 - z152 * z179))));
    const double z183 = z153 * (c_roll * z175 - (z164 * z23 + (z167 * z25 + e2z * z179))) - (z150 * (z168 *
        z15 + s_steer * z177) - (z12 * z161 - z182));
    const double z184 = s1 * (z168 * z21 + s_steer * z173) - (z29 * z160 + (k9 * (z168 * c1) + z28 * z163));
    const double z185 = z165 * z24 - c_steer * z178;
    const double z186 = z168 * z138 + s_steer * z180;
    const double z187 = z150 * (z165 * z15 - c_steer * z177) - (z21 * z186 - (z140 * z173 - (z168 * z143 -
        (s_steer * z181 - z152 * z185))));
    const double z188 = z153 * (c_roll * z184 + (z164 * z30 - (z167 * z31 - e2z * z185))) + z187;
    const double z189 = z16 * z183 - z27 * z188;
    const double z190 = z31 * z183 - z25 * z188;
    const double z191 = z39 * (z13 * z189 + z5 * z190);
    const double z192 = z164 * z153 + c_roll * z191;
    const double z193 = z161 - (z162 * z163 - c1 * z192);
    const double z194 = z142 + c1 * z162;
    const double z195 = z138 - s1 * z162;
    const double z196 = z157 * z194 - z156 * z195;
    const double z197 = z180 + (z162 * z160 + s1 * z192);
    const double z198 = k22 * z154;
    const double z199 = k23 * z154;
    const double z200 = k23 * z193 - (k21 * z196 + (k22 * z197 + (z194 * z198 + (e2z * k45 - z195 * z199))));
    const double z201 = z4 * z176 - z37 * z169;
    const double z202 = z201 - (z165 * z12 - c_steer * z174);
    const double z203 = c_roll * (z49 * z160 - s1 * (z168 * z12 + s_steer * z174)) + (z164 * z50 + (z167 *
        z13 - e2z * z202));
    const double z204 = z153 * z203 + (z12 * z186 - (z150 * z201 + (z140 * z174 - z152 * z202)));
    const double z205 = z26 * z188 + z32 * z183;
    const double z206 = z39 * (z51 * z189 + z33 * z204 - z5 * z205) - (z167 * z153 - e2z * z191);
    const double z207 = z165 * z154 - c_steer * z206 - (z168 * z195 + s_steer * z197);
    const double z208 = z39 * (z51 * z190 + z13 * z205 + z34 * z204) - z206;
    const double z209 = z155 * z177 + z15 * z208 - (z154 * z156 - v2_x * z194);
    const double z210 = k9 * z154;
    const double z211 = k9 * z194;
    const double z212 = z209 - (z154 * z210 + z194 * z211);
    const double z213 = z196 - (k9 * z193 + z210 * z195);
    const double z214 = c_steer * z212 + s_steer * z213;
    const double z215 = z155 * z201 + z5 * z208 - (v2_x * z195 - z154 * z157);
    const double z216 = z215 + (k9 * z206 + z195 * z211);
    const double w3_steer = steer_dot + z194;
    const double z217 = s_steer * z154 - c_steer * z195;
    const double z218 = k57 * z217 + k58 * w3_steer;
    const double z219 = k58 * z217 + k61 * w3_steer;
    const double z220 = z8 * k62 - (k60 * z207 + (k55 * z214 + (k41 * z216 - (w3_steer * z218 - z217 *
        z219))));
    const double z221 = z7 * k63 - z220;
    const double z222 = F_yy * z207;
    const double z223 = R_yy * z155 - k32 * z154;
    const double z224 = k29 * z195 - k30 * z194;
    const double z225 = e2z * k46 - (k33 * z193 - (k23 * z196 - k30 * z197) - (z195 * z223 + z154 * z224));
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z226 = c_steer * z213 - s_steer * z212;
    const double z227 = z168 * z154 + s_steer * z206 + (z165 * z195 - c_steer * z197);
    const double z228 = c_steer * z154 + s_steer * z195;
    const double z229 = F_yy * (thF_dot - z228) - k60 * z228;
    const double z230 = h2z * k63 + (k61 * z193 + (k41 * z226 - k58 * z227) + (z217 * z229 + z228 * z218));
    const double z231 = z225 - z230;
    const double z232 = h2z * k62 + (k58 * z193 - (k55 * z226 + k57 * z227) - (z228 * z219 + w3_steer *
        z229));
    const double z233 = k55 * z217 - k41 * w3_steer;
    const double z234 = k55 * z228;
    const double z235 = z7 * k48 + (k34 * z216 + k41 * z207 - (z217 * z233 + z228 * z234));
    const double z236 = k41 * z228;
    const double z237 = h2z * k48 + (k41 * z193 + (k34 * z226 + k55 * z227) - (w3_steer * z234 + z217 *
        z236));
    const double z238 = z8 * k48 + (k34 * z214 + k55 * z207 + (z228 * z236 - w3_steer * z233));
    const double z239 = k30 * z195 - k33 * z194;
    const double z240 = z3 * k47 - z7 * k46 - (k32 * z206 + (k22 * z209 + k23 * z215) - (z194 * z224 + z195 *
        z239));
    const double z241 = e2z * k47 + (k30 * z193 + (k22 * z196 + k29 * z197) + (z154 * z239 - z194 * z223));
    const double z242 = k22 * z195 + k23 * z194;
    const double z243 = z7 * k45 + (k21 * z215 + k23 * z206 + (z195 * z242 + z154 * z198));
    const double z244 = z3 * k45 - (k21 * z209 + k22 * z206 - (z154 * z199 + z194 * z242));
    const double z245 = R_yy * z208;
    const double z246 = z56 * z238 + (z52 * z240 - (z48 * z241 - (z69 * z243 - (z54 * z244 - z52 * z245))));
    const double z247 = z53 * (z221 + z222) - (z47 * z231 - (z62 * z232 - (z57 * z235 - (z61 * z237 +
        z246))));
    const double z248 = z38 * z200 - z247;
    const double z249 = z84 * z240 - (z88 * z241 - (z86 * z244 - (z94 * z243 - (z248 * z104 - z85 * z245))));
    const double z250 = z82 * z230 - (z89 * z232 + (z87 * z237 + (z81 * z225 + z249)));
    const double z251 = z114 * z244 - (z120 * z243 - (z248 * z132 + (z136 * z250 - (z113 * z245 - z127 *
        z222))));
    const double z252 = z117 * z232 - (z121 * z235 - (z115 * z237 - (z119 * z238 - (z112 * z240 - (z116 *
        z241 - z251)))));
    const double z253 = (z110 * z231 + (z118 * z221 + z252)) / z137;
    const double z254 = z135 * z250 + z136 * z253;
    /* (I.2.4) */
    dydt[0] = -(c_yaw * z158 + s_yaw * z159); /* x' */
    dydt[1] = c_yaw * z159 - s_yaw * z158; /* y' */
    dydt[2] = e2z * v2_x; /* z' */
    dydt[3] = z153; /* yaw' */
    dydt[4] = roll_dot; /* roll' */
    dydt[5] = -z152; /* pitch' */
    dydt[6] = steer_dot; /* steer' */
    dydt[7] = z150; /* thR' */
    dydt[8] = thF_dot; /* thF' */
    /* (I.2.15) 112:4 */
    dydt[9] = z248 * z103 + z104 * z254 - z132 * z253; /* roll'' */
    dydt[10] = z254; /* steer'' */
    dydt[11] = -z253; /* thF'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[9] + dydt[11]) <= DBL_MAX
        && fabs(-z35) > 1e-12 * (k19 * ((z36 + k51) * (z36 + k52)))
        && fabs(z105) > 1e-13 * z100
        && fabs(z137) > 1e-13 * z128)) {
        /* the coframe is singular, if -z35 is nearly 0 */
        if (!(fabs(-z35) > 1e-12 * (k19 * ((z36 + k51) * (z36 + k52))))) {
            return bicycle_refuse(fabs(-z35), 1e-12 * (k19 * ((z36 + k51) * (z36 + k52))),
                BICYCLE_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if -z76 is 0 */
        if (!(fabs(-z76) > 0.0)) {
            return bicycle_refuse(fabs(-z76), 0.0, BICYCLE_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z105 is nearly 0 */
        if (!(fabs(z105) > 1e-13 * z100)) {
            return bicycle_refuse(fabs(z105), 1e-13 * z100, BICYCLE_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z137 is nearly 0 */
        if (!(fabs(z137) > 1e-13 * z128)) {
            return bicycle_refuse(fabs(z137), 1e-13 * z128, BICYCLE_SINGULAR_2);
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
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s1 = sin(z1);
    const double c1 = cos(z1);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);
    const double s_yaw = sin(yaw);
    const double c_yaw = cos(yaw);

    /* what else is read */
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* from the parameters alone */
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = r_R * s_lam - c_lam * k1;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);
    const double k5 = fabs(r_R);
    const double k6 = fabs(r_F);
    const double k7 = fabs(w);
    const double k8 = fabs(c);
    const double k9 = 9.0 * k6;
    const double k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9));
    const double k11 = 6.0 * k7;
    const double k12 = 14.0 * k6 + 13.0 * k8;
    const double k13 = k9 + 10.0 * k8;

    /* from the state */
    const double z2 = c_roll * s1;
    const double z3 = 1.0 / fabs(c_roll);
    const double z4 = r_R * z3;
    const double z5 = z2 * z4;
    const double z6 = e2z * s_steer - c_steer * z2;
    const double z7 = c_roll * c1;
    const double z8 = r_F / sqrt(z7 * z7 + z6 * z6);
    const double z9 = z6 * z8;
    const double z10 = k2 + z9;
    const double z11 = k3 - z5 - c_steer * z10;
    const double z12 = z7 * z4;
    const double z13 = c_steer * z12;
    const double z14 = z7 * z8;
    const double z15 = k4 + z14;
    const double z16 = s1 * z15;
    const double z17 = z12 - z15;
    const double z18 = s_steer * z17;
    const double z19 = c_roll * (c_steer * z16 - c1 * (c_steer * k3 - z10)) + e2z * z18;
    const double z20 = c_steer * z17;
    const double z21 = c_roll * (s_steer * z16 - k3 * (s_steer * c1)) - e2z * z20;
    const double z22 = s_steer * z12;
    const double z23 = z13 * z19 + z21 * z22;
    const double z24 = z20 * z19 + z21 * z18;
    const double z25 = z11 * z23 + z5 * z24;
    const double z26 = k11 + k5 * (9.0 + fabs(z3));
    const double v2_x = c_roll * (roll_dot * z4);
    const double z27 = c_roll * v2_x;
    const double z28 = s_steer * z2 * z10 - e2z * z11;
    const double z29 = roll_dot * s1;
    const double z30 = steer_dot + z29;
    const double z31 = roll_dot * c1;
    const double z32 = c_steer * z31;
    const double z33 = k3 * z29 - v2_x;
    const double z34 = z30 * z9 - z32 * z14 - (k4 * z32 - k2 * z30 + c_steer * z33);
    const double z35 = s_steer * z31;
    const double z36 = thF_dot - z35;
    const double z37 = z36 * z14 - (k4 * z35 + s_steer * z33);
    const double z38 = z20 * z34 + z18 * z37;
    const double z39 = z19 * z37 - z21 * z34;
    const double z40 = k2 * z35 - z36 * z9;
    const double z41 = 1.0 / z25;
    const double z42 = (z28 * z38 + z11 * z39 + z24 * z40) * z41;
    const double z43 = z13 * z34 + z22 * z37;
    const double z44 = (z28 * z43 + z23 * z40 - z5 * z39) * z41;
    const double z45 = z41 * (z11 * z43 + z5 * z38);
    const double z46 = (z42 - (z44 + e2z * z45)) * (s1 * z5 + c1 * z12);
    /* (I.2.4) */
    qdot[0] = -(s_yaw * z27 + c_yaw * z46); /* x' */
    qdot[1] = c_yaw * z27 - s_yaw * z46; /* y' */
    qdot[2] = e2z * v2_x; /* z' */
    qdot[3] = -z45; /* yaw' */
    qdot[4] = roll_dot; /* roll' */
    qdot[5] = -z44; /* pitch' */
    qdot[6] = steer_dot; /* steer' */
    qdot[7] = z42; /* thR' */
    qdot[8] = thF_dot; /* thF' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[3] + qdot[5]) <= DBL_MAX
        && fabs(z25) > 1e-12 * (k10 * ((z26 + k12) * (z26 + k13))))) {
        /* the coframe is singular, if z25 is nearly 0 */
        if (!(fabs(z25) > 1e-12 * (k10 * ((z26 + k12) * (z26 + k13))))) {
            return bicycle_refuse(fabs(z25), 1e-12 * (k10 * ((z26 + k12) * (z26 + k13))), BICYCLE_SINGULAR_1);
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
    const double z2 = pitch + lam;
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double s_yaw = sin(yaw);
    const double c_yaw = cos(yaw);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double s1 = sin(z2);
    const double c1 = cos(z2);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);

    /* what else is read */
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double roll_ddot = dydt[9]; /* roll'' */
    const double steer_ddot = dydt[10]; /* steer'' */
    const double thF_ddot = dydt[11]; /* thF'' */

    /* from the parameters alone */
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = r_R * s_lam - c_lam * k1;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);

    /* from the state */
    const double z1 = 1.0 / fabs(c_roll);
    const double z3 = c_roll * s1;
    const double z4 = r_R * z3;
    const double z5 = z1 * z4;
    const double z6 = c_roll * c1;
    const double z7 = e2z * s_steer - c_steer * z3;
    const double z8 = 1.0 / sqrt(z6 * z6 + z7 * z7);
    const double z9 = r_F * z7;
    const double z10 = z8 * z9;
    const double z11 = k2 + z10;
    const double z12 = k3 - z5 - c_steer * z11;
    const double z13 = r_R * z6;
    const double z14 = z1 * z13;
    const double z15 = c_steer * z14;
    const double z16 = r_F * z6;
    const double z17 = z8 * z16;
    const double z18 = k4 + z17;
    const double z19 = c_steer * z18;
    const double z20 = c_steer * k3 - z11;
    const double z21 = s1 * z19 - c1 * z20;
    const double z22 = z14 - z18;
    const double z23 = s_steer * z22;
    const double z24 = c_roll * z21 + e2z * z23;
    const double z25 = s_steer * z18;
    const double z26 = s_steer * k3;
    const double z27 = s1 * z25 - c1 * z26;
    const double z28 = c_steer * z22;
    const double z29 = c_roll * z27 - e2z * z28;
    const double z30 = s_steer * z14;
    const double z31 = z15 * z24 + z29 * z30;
    const double z32 = z28 * z24 + z29 * z23;
    const double z33 = 1.0 / (z12 * z31 + z5 * z32);
    const double z34 = roll_dot * s1;
    const double z35 = steer_dot + z34;
    const double z36 = roll_dot * c1;
    const double z37 = c_steer * z36;
    const double z38 = roll_dot * r_R;
    const double z39 = c_roll * z38;
    const double v2_x = z1 * z39;
    const double z40 = v2_x - k3 * z34;
    const double z41 = z10 * z35 - z17 * z37 - (k4 * z37 - k2 * z35 - c_steer * z40);
    const double z42 = s_steer * z36;
    const double z43 = thF_dot - z42;
    const double z44 = z17 * z43 - (k4 * z42 - s_steer * z40);
    const double z45 = z15 * z41 + z30 * z44;
    const double z46 = z28 * z41 + z23 * z44;
    const double z47 = z12 * z45 + z5 * z46;
    const double z48 = z33 * z47;
    const double z49 = s_yaw * z48;
    const double z50 = s_steer * z11;
    const double z51 = s1 * z50;
    const double z52 = c_roll * z51 - e2z * z12;
    const double z53 = z24 * z44 - z29 * z41;
    const double z54 = k2 * z42 - z10 * z43;
    const double z55 = z52 * z46 + z12 * z53 + z32 * z54;
    const double z56 = z52 * z45 + z31 * z54 - z5 * z53;
    const double z57 = z56 * z33;
    const double z58 = z55 * z33 - (z57 + e2z * z48);
    const double z59 = z5 * z58;
    const double z60 = s1 * z59 + z58 * (c1 * z14);
    const double z61 = c1 * z57;
    const double z62 = z59 * z61;
    const double z63 = roll_dot * e2z;
    const double z64 = z1 * (c_roll * z63) * (z1 * z1);
    const double z65 = r_R * z1;
    const double z66 = z63 * s1 + c_roll * z61;
    const double z67 = z4 * z64 - z65 * z66;
    const double z68 = steer_dot * s_steer;
    const double z69 = s1 * z57;
    const double z70 = z63 * c1 - c_roll * z69;
    const double z71 = roll_dot * c_roll;
    const double z72 = steer_dot * c_steer;
    const double z73 = s_steer * z71 + e2z * z72 + (z68 * z3 + c_steer * z66);
    const double z74 = z8 * (z8 * z8) * (z6 * z70 - z7 * z73);
    const double z75 = r_F * z8;
    const double z76 = z9 * z74 + z75 * z73;
    const double z77 = z67 - (z68 * z11 - c_steer * z76);
    const double z78 = z13 * z64 - z65 * z70;
    const double z79 = z68 * z14 - c_steer * z78;
    const double z80 = z16 * z74 - z75 * z70;
    const double z81 = z19 * z61 + s1 * (z68 * z18 - c_steer * z80) + (z20 * z69 - c1 * (z68 * k3 + z76));
    const double z82 = z78 - z80;
    const double z83 = z72 * z22 + s_steer * z82;
    const double z84 = z63 * z21 + c_roll * z81 - (z71 * z23 + e2z * z83);
    const double z85 = z25 * z61 - s1 * (z72 * z18 + s_steer * z80) + (k3 * (z72 * c1) + z26 * z69);
    const double z86 = z68 * z22 - c_steer * z82;
    const double z87 = z63 * z27 + c_roll * z85 + (z71 * z28 - e2z * z86);
    const double z88 = z72 * z14 + s_steer * z78;
    const double z89 = z24 * z79 + z15 * z84 + (z30 * z87 - z29 * z88);
    const double z90 = z24 * z86 + z28 * z84 + (z23 * z87 - z29 * z83);
    const double z91 = z33 * z33 * (z31 * z77 + z12 * z89 - (z32 * z67 - z5 * z90));
    const double z92 = z63 * z51 + c_roll * (z50 * z61 - s1 * (z72 * z11 + s_steer * z76)) + (z71 * z12 - e2z
        * z77);
    const double z93 = s1 * roll_ddot - roll_dot * z61;
    const double z94 = steer_ddot + z93;
    const double z95 = c1 * roll_ddot + roll_dot * z69;
    const double z96 = z68 * z36 - c_steer * z95;
    const double z97 = z39 * z64 - z1 * (z63 * z38 - r_R * (c_roll * roll_ddot));
    const double z98 = k3 * z93 - z97;
    const double z99 = z10 * z94 + z35 * z76 + (z17 * z96 - z37 * z80) + (k4 * z96 + k2 * z94 - (z68 * z40 +
        c_steer * z98));
    const double z100 = z72 * z36 + s_steer * z95;
    const double z101 = thF_ddot - z100;
    const double z102 = z17 * z101 + z43 * z80 - (k4 * z100 - (z72 * z40 - s_steer * z98));
    const double z103 = z41 * z86 - z28 * z99 - (z44 * z83 + z23 * z102);
    const double z104 = z44 * z84 - z24 * z102 - (z41 * z87 - z29 * z99);
    const double z105 = k2 * z100 - (z10 * z101 + z43 * z76);
    const double z106 = z46 * z92 + z52 * z103 + (z53 * z77 + z12 * z104) + (z54 * z90 - z32 * z105);
    const double z107 = z55 * z91 - z33 * z106;
    const double z108 = z41 * z79 - z15 * z99 - (z44 * z88 + z30 * z102);
    const double z109 = z45 * z92 + z52 * z108 + (z54 * z89 - z31 * z105) + (z53 * z67 - z5 * z104);
    const double z110 = z56 * z91 - z33 * z109;
    const double z111 = z47 * z91 - z33 * (z45 * z77 + z12 * z108 - (z46 * z67 - z5 * z103));
    const double z112 = z107 - (z110 + (z71 * z48 + e2z * z111));
    const double z113 = z62 - s1 * (z58 * z67 + z5 * z112) - (z62 + c1 * (z58 * z78 + z14 * z112));
    const double z114 = c_roll * v2_x;
    const double z115 = c_yaw * z48;
    const double z116 = z63 * v2_x - c_roll * z97;
    /* (I.2.15) */
    qddot[0] = z114 * z115 + s_yaw * z116 - (z49 * z60 - c_yaw * z113); /* x'' */
    qddot[1] = z115 * z60 + s_yaw * z113 + (z114 * z49 - c_yaw * z116); /* y'' */
    qddot[2] = z71 * v2_x + e2z * z97; /* z'' */
    qddot[3] = -z111; /* yaw'' */
    qddot[4] = roll_ddot; /* roll'' */
    qddot[5] = -z110; /* pitch'' */
    qddot[6] = steer_ddot; /* steer'' */
    qddot[7] = z107; /* thR'' */
    qddot[8] = thF_ddot; /* thF'' */
    return bicycle_finish(9, qddot);
}

int bicycle_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;

    /* from the coordinates and velocities */
    const double x = q[0]; /* centre of the rear wheel [m] */
    y[0] = x;
    const double y_2 = q[1]; /* y: centre of the rear wheel [m] */
    y[1] = y_2;
    const double z = q[2]; /* centre of the rear wheel, downwards [m] */
    y[2] = z;
    const double yaw = q[3]; /* first turn of the rear frame, about z [rad] */
    y[3] = yaw;
    const double roll = q[4]; /* second turn, about x [rad] */
    y[4] = roll;
    const double pitch = q[5]; /* third turn, about y [rad] */
    y[5] = pitch;
    const double steer = q[6]; /* front frame against rear frame [rad] */
    y[6] = steer;
    const double thR = q[7]; /* rear wheel against rear frame [rad] */
    y[7] = thR;
    const double thF = q[8]; /* front wheel against front frame [rad] */
    y[8] = thF;
    const double roll_dot = qdot[4]; /* roll' [rad/s] */
    y[9] = roll_dot;
    const double steer_dot = qdot[6]; /* steer' [rad/s] */
    y[10] = steer_dot;
    const double thF_dot = qdot[8]; /* thF' [rad/s] */
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
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double c_yaw = cos(yaw);
    const double s_yaw = sin(yaw);
    const double c_pitch = cos(pitch);
    const double s_pitch = sin(pitch);
    const double e2z = sin(roll);
    const double c_roll = cos(roll);
    const double s_steer = sin(steer);
    const double c_steer = cos(steer);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [m/s] */
    const double y_dot = qdot[1]; /* y' [m/s] */
    const double z_dot = qdot[2]; /* z' [m/s] */
    const double yaw_dot = qdot[3]; /* yaw' [rad/s] */
    const double roll_dot = qdot[4]; /* roll' [rad/s] */
    const double pitch_dot = qdot[5]; /* pitch' [rad/s] */
    const double steer_dot = qdot[6]; /* steer' [rad/s] */
    const double thR_dot = qdot[7]; /* thR' [rad/s] */
    const double thF_dot = qdot[8]; /* thF' [rad/s] */
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* from the parameters alone */
    const double k1 = w + c;

    /* from the coordinates and velocities */
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

BICYCLE_SLOW static int bicycle_reactions_part1(double t, const double *y, const double *p,
    const double *dydt, double *kept, double *lambda)
{
    (void)lambda;
    (void)t;
    (void)dydt;

    /* sines and cosines */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */
    const double z1 = pitch + lam;
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
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
    const double c_steer = cos(steer);
    kept[6] = c_steer;
    const double s_steer = sin(steer);
    kept[7] = s_steer;

    /* what else is read */

    /* from the parameters alone */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z_B = p[9]; /* [m] */
    const double k1 = r_R + z_B;
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double k2 = w + c;
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k3 = r_F * s_lam - c * c_lam;
    kept[8] = k3;
    const double H_zz = p[21]; /* [kg*m^2] */
    const double F_xx = p[24]; /* front wheel, across the axle [kg*m^2] */
    const double k4 = H_zz + F_xx;
    const double H_xx = p[18]; /* [kg*m^2] */
    const double k5 = H_xx + F_xx;
    const double R_xx = p[6]; /* rear wheel, across the axle [kg*m^2] */
    const double B_xx = p[11]; /* [kg*m^2] */
    const double k6 = R_xx + B_xx;
    const double B_zz = p[14]; /* [kg*m^2] */
    const double k7 = R_xx + B_zz;
    const double x_H = p[15]; /* front frame, ahead of the rear contact [m] */
    const double k8 = x_H - k2;
    const double k9 = r_R * s_lam - c_lam * k2;
    kept[9] = k9;
    const double z_H = p[16]; /* [m] */
    const double k10 = z_H * s_lam - c_lam * k8;
    const double k11 = r_R * c_lam + s_lam * k2;
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double k12 = c_lam * k1 + x_B * s_lam;
    const double k13 = s_lam * k1 - x_B * c_lam;
    const double m_R = p[5]; /* mass of the rear wheel [kg] */
    const double m_B = p[10]; /* [kg] */
    const double k14 = m_R + m_B;
    kept[10] = k14;
    const double k15 = m_B * k12;
    kept[11] = k15;
    const double k16 = m_B * k13;
    kept[12] = k16;
    const double B_xz = p[12]; /* [kg*m^2] */
    const double k17 = B_xz * c_lam;
    const double k18 = s_lam * k7 - k17;
    const double k19 = B_xz * s_lam;
    const double k20 = c_lam * k6 - k19;
    const double k21 = k12 * k15;
    const double k22 = s_lam * k18 + c_lam * k20 + k21;
    kept[13] = k22;
    const double k23 = c_lam * k18 - s_lam * k20 - k13 * k15;
    kept[14] = k23;
    const double k24 = k13 * k16;
    const double B_yy = p[13]; /* [kg*m^2] */
    const double k25 = k21 + (B_yy + k24);
    kept[15] = k25;
    const double k26 = k24 + (c_lam * (k19 + c_lam * k7) + s_lam * (k17 + s_lam * k6));
    kept[16] = k26;
    const double m_H = p[17]; /* [kg] */
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double k27 = m_H + m_F;
    kept[17] = k27;
    const double k28 = m_F * k3;
    const double H_xz = p[19]; /* [kg*m^2] */
    const double k29 = H_xz * c_lam;
    const double k30 = s_lam * k4 - k29;
    const double k31 = H_xz * s_lam;
    const double k32 = c_lam * k5 - k31;
    const double k33 = m_H * k10;
    const double k34 = k28 - k33;
    kept[18] = k34;
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double k35 = g * m_F;
    const double k36 = g * m_H;
    const double k37 = g * m_B;
    const double k38 = g * k14;
    kept[19] = k38;
    const double k39 = k13 * k37;
    kept[20] = k39;
    const double k40 = k12 * k37;
    kept[21] = k40;
    const double k41 = g * k27;
    kept[22] = k41;
    const double k42 = k3 * k35;
    kept[23] = k42;
    const double k43 = k11 + (z_H * c_lam + s_lam * k8);
    const double k44 = r_F * c_lam + c * s_lam - k11;
    kept[24] = k44;
    const double k45 = m_F * k44;
    const double k46 = m_H * k43;
    const double k47 = k45 - k46;
    kept[25] = k47;
    const double k48 = k44 * k45 + k43 * k46;
    const double k49 = s_lam * k30 + c_lam * k32 + k48;
    kept[26] = k49;
    const double k50 = c_lam * k30 - s_lam * k32 - k3 * k45 - k10 * k46;
    kept[27] = k50;
    const double k51 = k3 * k28 + k10 * k33;
    const double H_yy = p[20]; /* [kg*m^2] */
    const double k52 = k51 + (H_yy + k48);
    kept[28] = k52;
    const double k53 = c_lam * (k31 + c_lam * k4) + s_lam * (k29 + s_lam * k5) + k51;
    kept[29] = k53;
    const double k54 = k10 * k36;
    kept[30] = k54;
    const double k55 = k36 * k43;
    kept[31] = k55;
    const double k56 = k35 * k44;
    kept[32] = k56;
    const double k57 = k55 - k56;
    kept[33] = k57;
    const double k58 = k42 - k54;
    kept[34] = k58;

    /* from the state */
    const double z2 = c_roll * s1;
    kept[35] = z2;
    const double z3 = 1.0 / fabs(c_roll);
    const double z4 = r_R * z2;
    kept[36] = z4;
    const double z5 = z3 * z4;
    kept[37] = z5;
    const double z6 = c_roll * c1;
    kept[38] = z6;
    const double z7 = e2z * s_steer - c_steer * z2;
    kept[39] = z7;
    const double z8 = 1.0 / sqrt(z6 * z6 + z7 * z7);
    const double z9 = r_F * z7;
    kept[40] = z9;
    const double z10 = z8 * z9;
    kept[41] = z10;
    const double z11 = k3 + z10;
    kept[42] = z11;
    const double z12 = k9 - z5 - c_steer * z11;
    kept[43] = z12;
    const double z13 = r_R * z6;
    const double z14 = z3 * z13;
    kept[44] = z14;
    const double z15 = c_steer * z14;
    kept[45] = z15;
    const double z16 = c_steer * k9 - z11;
    kept[46] = z16;
    const double z17 = r_F * z6;
    kept[47] = z17;
    const double z18 = z8 * z17;
    kept[48] = z18;
    const double z19 = z18 - k44;
    kept[49] = z19;
    const double z20 = c_steer * z19;
    kept[50] = z20;
    const double z21 = c1 * z16 - s1 * z20;
    kept[51] = z21;
    const double z22 = z14 - z19;
    kept[52] = z22;
    const double z23 = s_steer * z22;
    kept[53] = z23;
    const double z24 = c_roll * z21 - e2z * z23;
    kept[54] = z24;
    const double z25 = s_steer * z14;
    kept[55] = z25;
    const double z26 = s_steer * k9;
    kept[56] = z26;
    const double z27 = s_steer * z19;
    kept[57] = z27;
    const double z28 = c1 * z26 - s1 * z27;
    kept[58] = z28;
    const double z29 = c_steer * z22;
    kept[59] = z29;
    const double z30 = c_roll * z28 + e2z * z29;
    kept[60] = z30;
    const double z31 = z15 * z24 + z25 * z30;
    kept[61] = z31;
    const double z32 = z29 * z24 + z30 * z23;
    kept[62] = z32;
    const double z33 = 1.0 / (z12 * z31 + z5 * z32);
    kept[63] = z33;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double z34 = roll_dot * c1;
    kept[64] = z34;
    const double z35 = s_steer * z34;
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double z36 = thF_dot - z35;
    kept[65] = z36;
    const double z37 = k3 * z35 - z10 * z36;
    const double z38 = s_steer * z11;
    kept[66] = z38;
    const double z39 = s1 * z38;
    kept[67] = z39;
    const double z40 = c_roll * z39 - e2z * z12;
    kept[68] = z40;
    const double z41 = roll_dot * s1;
    kept[69] = z41;
    const double z42 = r_R * z3;
    kept[70] = z42;
    const double z43 = c_roll * z42;
    kept[71] = z43;
    const double v2_x = roll_dot * z43;
    kept[72] = v2_x;
    const double z44 = k9 * z41 - v2_x;
    kept[73] = z44;
    const double z45 = z18 * z36 + (z35 * k44 - s_steer * z44);
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double z46 = steer_dot + z41;
    kept[74] = z46;
    const double z47 = c_steer * z34;
    kept[75] = z47;
    const double z48 = z10 * z46 - z18 * z47 - (c_steer * z44 - (k3 * z46 + z47 * k44));
    const double z49 = z23 * z45 + z29 * z48;
    const double z50 = z24 * z45 - z30 * z48;
    const double z51 = z33 * (z37 * z32 - (z40 * z49 - z12 * z50));
    kept[76] = z51;
    const double z52 = z25 * z45 + z15 * z48;
    const double z53 = z33 * (z37 * z31 - z40 * z52 - z5 * z50);
    kept[77] = z53;
    const double z54 = z33 * (z12 * z52 + z5 * z49);
    kept[78] = z54;
    const double z55 = z53 - e2z * z54;
    kept[79] = z55;
    const double z56 = z51 - z55;
    kept[80] = z56;
    const double z57 = roll_dot * e2z;
    kept[81] = z57;
    const double z58 = z3 * (c_roll * z57) * (z3 * z3);
    kept[82] = z58;
    const double z59 = s1 * z53;
    kept[83] = z59;
    const double z60 = z57 * c1 - c_roll * z59;
    kept[84] = z60;
    const double z61 = z13 * z58 - z42 * z60;
    kept[85] = z61;
    const double z62 = roll_dot * c_roll;
    kept[86] = z62;
    const double z63 = steer_dot * c_steer;
    kept[87] = z63;
    const double z64 = steer_dot * s_steer;
    kept[88] = z64;
    const double z65 = c1 * z53;
    kept[89] = z65;
    const double z66 = z57 * s1 + c_roll * z65;
    kept[90] = z66;
    const double z67 = s_steer * z62 + e2z * z63 + (z64 * z2 + c_steer * z66);
    kept[91] = z67;
    const double z68 = z8 * (z8 * z8) * (z6 * z60 - z7 * z67);
    kept[92] = z68;
    const double z69 = r_F * z8;
    kept[93] = z69;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_reactions_part2(double t, const double *y, const double *p,
    const double *dydt, double *kept, double *lambda)
{
    (void)t;
    const double z9 = kept[40];
    const double z67 = kept[91];
    const double z68 = kept[92];
    const double z69 = kept[93];
    const double z70 = z9 * z68 + z69 * z67;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double z65 = kept[89];
    const double z71 = roll_dot * z65;
    const double z17 = kept[47];
    const double z60 = kept[84];
    const double z72 = z17 * z68 - z69 * z60;
    const double z59 = kept[83];
    const double z73 = roll_dot * z59;
    const double c_steer = kept[6];
    const double z34 = kept[64];
    const double z64 = kept[88];
    const double z74 = z64 * z34 - c_steer * z73;
    const double k9 = kept[9];
    const double z75 = k9 * z71;
    const double k3 = kept[8];
    const double k44 = kept[24];
    const double z10 = kept[41];
    const double z18 = kept[48];
    const double z44 = kept[73];
    const double z46 = kept[74];
    const double z47 = kept[75];
    const double z76 = z46 * z70 - z10 * z71 - (z47 * z72 - z18 * z74) - (k44 * z74 + k3 * z71 - (z64 * z44 +
        c_steer * z75));
    const double s1 = kept[4];
    const double c1 = kept[5];
    const double z16 = kept[46];
    const double z19 = kept[49];
    const double z20 = kept[50];
    const double z77 = z20 * z65 + s1 * (z64 * z19 - c_steer * z72) + (z16 * z59 - c1 * (z64 * k9 + z70));
    const double z61 = kept[85];
    const double z78 = z61 - z72;
    const double s_steer = kept[7];
    const double z22 = kept[52];
    const double z63 = kept[87];
    const double z79 = z63 * z22 + s_steer * z78;
    const double e2z = kept[2];
    const double c_roll = kept[3];
    const double z14 = kept[44];
    const double z21 = kept[51];
    const double z23 = kept[53];
    const double z51 = kept[76];
    const double z53 = kept[77];
    const double z54 = kept[78];
    const double z57 = kept[81];
    const double z62 = kept[86];
    const double z80 = z51 * (z63 * z14 + s_steer * z61) + (z54 * (z57 * z21 - c_roll * z77 + (z62 * z23 +
        e2z * z79)) - z53 * z79);
    const double z81 = z76 + z80;
    const double z82 = z63 * z34 + s_steer * z73;
    const double z26 = kept[56];
    const double z27 = kept[57];
    const double z83 = z27 * z65 - s1 * (z63 * z19 + s_steer * z72) + (k9 * (z63 * c1) + z26 * z59);
    const double z84 = z64 * z22 - c_steer * z78;
    const double z28 = kept[58];
    const double z29 = kept[59];
    const double z85 = z51 * (z64 * z14 - c_steer * z61) + (z54 * (z57 * z28 - c_roll * z83 - (z62 * z29 -
        e2z * z84)) - z53 * z84);
    const double z36 = kept[65];
    const double z86 = z36 * z72 - z18 * z82 + (k44 * z82 - (z63 * z44 - s_steer * z75)) + z85;
    const double z87 = z29 * z81 + z23 * z86;
    const double z24 = kept[54];
    const double z30 = kept[60];
    const double z88 = z24 * z86 - z30 * z81;
    const double z4 = kept[36];
    const double z42 = kept[70];
    const double z58 = kept[82];
    const double z66 = kept[90];
    const double z89 = z4 * z58 - z42 * z66;
    const double z11 = kept[42];
    const double z90 = z89 - (z64 * z11 - c_steer * z70);
    const double z12 = kept[43];
    const double z38 = kept[66];
    const double z39 = kept[67];
    const double z91 = z57 * z39 + c_roll * (z38 * z65 - s1 * (z63 * z11 + s_steer * z70)) + (z62 * z12 - e2z
        * z90);
    const double z92 = k3 * z82 - (z36 * z70 - z10 * z82) - (z51 * z89 - (z54 * z91 + z53 * z90));
    const double z15 = kept[45];
    const double z25 = kept[55];
    const double z93 = z15 * z81 + z25 * z86;
    const double z5 = kept[37];
    const double z33 = kept[63];
    const double z94 = z33 * (z12 * z93 + z5 * z87);
    const double z31 = kept[61];
    const double z40 = kept[68];
    const double z95 = z33 * (z40 * z93 - z31 * z92 + z5 * z88) + (z62 * z54 + e2z * z94);
    const double z32 = kept[62];
    const double z96 = z33 * (z40 * z87 - z12 * z88 - z32 * z92) - z95;
    const double z56 = kept[80];
    const double z97 = z5 * z56;
    const double z98 = c_roll * z54;
    const double z41 = kept[69];
    const double z99 = z41 + c1 * z98;
    const double v2_x = kept[72];
    const double z55 = kept[79];
    const double z100 = z56 * z61 - z14 * z96 - (z55 * z97 - v2_x * z99);
    const double k16 = kept[12];
    const double z101 = k16 * z55;
    const double z102 = z34 - s1 * z98;
    const double k15 = kept[11];
    const double z103 = k15 * z102 + k16 * z99;
    const double roll_ddot = dydt[9]; /* roll'' */
    const double z104 = s1 * roll_ddot;
    const double steer_ddot = dydt[10]; /* steer'' */
    const double z105 = steer_ddot + z104;
    const double z106 = c1 * roll_ddot;
    const double z107 = c_steer * z106;
    const double z43 = kept[71];
    const double z108 = roll_ddot * z43;
    const double z109 = k9 * z104 - z108;
    const double z110 = z10 * z105 - z18 * z107 + (k3 * z105 + k44 * z107 - c_steer * z109);
    const double z111 = s_steer * z106;
    const double thF_ddot = dydt[11]; /* thF'' */
    const double z112 = thF_ddot - z111;
    const double z113 = z18 * z112 + (k44 * z111 - s_steer * z109);
    const double z114 = z29 * z110 + z23 * z113;
    const double z115 = z24 * z113 - z30 * z110;
    const double z116 = k3 * z111 - z10 * z112;
    const double z117 = z15 * z110 + z25 * z113;
    const double z118 = z33 * (z12 * z117 + z5 * z114);
    const double z119 = z33 * (z40 * z117 - z31 * z116 + z5 * z115) + e2z * z118;
    const double z120 = z33 * (z40 * z114 - z12 * z115 - z32 * z116) - z119;
    const double z121 = z14 * z120;
    const double k14 = kept[10];
    const double k38 = kept[19];
    const double z2 = kept[35];
    const double z122 = z2 * k38 - (k14 * z100 - k15 * z95 - (z55 * z101 + z99 * z103)) + (k14 * z121 + k15 *
        z119);
    const double h2z = e2z * c_steer + s_steer * z2;
    const double z123 = z57 * z54 - c_roll * z94;
    const double z124 = z71 - (z59 * z98 - c1 * z123);
    const double z125 = z14 * z56;
    const double z126 = z125 * z99 - z97 * z102;
    const double z127 = k9 * z55;
    const double z128 = z126 - (k9 * z124 + z127 * z102);
    const double z129 = k9 * z99;
    const double z130 = z100 - (z55 * z127 + z99 * z129);
    const double z131 = c_steer * z128 - s_steer * z130;
    const double z132 = z73 + (z65 * z98 + s1 * z123);
    const double z133 = z63 * z55 - s_steer * z95 + (z64 * z102 - c_steer * z132);
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double w3_steer = steer_dot + z99;
    const double z134 = c_steer * z55 + s_steer * z102;
    const double k47 = kept[25];
    const double z135 = k47 * z134;
    const double z136 = s_steer * z55 - c_steer * z102;
    const double k34 = kept[18];
    const double z137 = k34 * z134;
    const double k27 = kept[17];
    const double k41 = kept[22];
    const double z138 = h2z * k41 + (k34 * z124 + (k27 * z131 + k47 * z133) - (w3_steer * z135 + z136 *
        z137));
    const double z139 = c_roll * z118;
    const double z140 = z104 + c1 * z139;
    const double z141 = steer_ddot + z140;
    const double z142 = z108 - k9 * z140;
    const double z143 = c_steer * z142 - s_steer * z121;
    const double z144 = z106 - s1 * z139;
    const double z145 = s_steer * z119 + c_steer * z144;
    const double z146 = z138 - (k34 * z141 + (k27 * z143 + k47 * z145));
    const double z147 = c_steer * z130 + s_steer * z128;
    const double z148 = z64 * z55 + c_steer * z95 - (z63 * z102 + s_steer * z132);
    const double z149 = k47 * z136 - k34 * w3_steer;
    const double z150 = c_steer * z121 + s_steer * z142;
    const double z151 = c_steer * z119 - s_steer * z144;
    const double z7 = kept[39];
    const double z152 = z7 * k41 + (k27 * z147 + k47 * z148 + (z134 * z137 - w3_steer * z149)) - (k27 * z150
        - k47 * z151);
    const double z153 = z122 + s_steer * z146 - c_steer * z152;
    const double z154 = z56 * z89 - z5 * z96 - (v2_x * z102 - z55 * z125);
    const double z155 = k15 * z55;
    const double z156 = z5 * z120;
    const double z6 = kept[38];
    const double z157 = z6 * k38 + (k14 * z154 - k16 * z95 + (z102 * z103 + z55 * z155)) - (k14 * z156 + k16
        * z119);
    const double z158 = z154 - (k9 * z95 - z102 * z129);
    const double z159 = z156 + k9 * z119;
    const double z160 = z6 * k41 + (k27 * z158 + k34 * z148 - (z136 * z149 + z134 * z135)) - (k27 * z159 -
        k34 * z151);
    const double z161 = z157 + z160;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double z162 = R_yy * (z96 + z120) - z5 * z161 + z14 * z153;
    const double z163 = z33 * z162;
    const double k22 = kept[13];
    const double k23 = kept[14];
    const double z164 = k22 * z102 - k23 * z99;
    const double k26 = kept[16];
    const double z165 = k23 * z102 - k26 * z99;
    const double k25 = kept[15];
    const double k39 = kept[20];
    const double k40 = kept[21];
    const double z166 = z2 * k40 - z6 * k39 + (k25 * z95 - (k15 * z100 + k16 * z154) + (z99 * z164 + z102 *
        z165));
    const double k49 = kept[26];
    const double k50 = kept[27];
    const double z167 = k49 * z136 + k50 * w3_steer;
    const double k53 = kept[29];
    const double z168 = k50 * z136 + k53 * w3_steer;
    const double k42 = kept[23];
    const double k52 = kept[28];
    const double k54 = kept[30];
    const double k55 = kept[31];
    const double k56 = kept[32];
    const double z169 = z7 * k55 + z6 * k54 - (z6 * k42 + z7 * k56) - (k52 * z148 + (k47 * z147 + k34 * z158)
        - (w3_steer * z167 - z136 * z168));
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z170 = z169 - (k52 * z151 - (k47 * z150 + k34 * z159)) - F_yy * (z148 + (thF_ddot + z151));
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double z171 = F_yy * (thF_dot - z134) - k52 * z134;
    const double k57 = kept[33];
    const double z172 = h2z * k57 + (k50 * z124 - (k47 * z131 + k49 * z133) - (z134 * z168 + w3_steer *
        z171));
    const double z173 = z172 - (k50 * z141 - (k47 * z143 + k49 * z145));
    const double z174 = z166 + (k25 * z119 + (k15 * z121 + k16 * z156)) - k9 * z160 - c_steer * z170 +
        s_steer * z173;
    const double z175 = z174 - z162;
    const double z176 = z33 * z175;
    const double z177 = z12 * z163 - z5 * z176;
    const double z178 = R_yy * z56 - k25 * z55;
    const double z179 = e2z * k40 + (k23 * z124 + (k15 * z126 + k22 * z132) + (z55 * z165 - z99 * z178));
    const double z180 = s1 * (z179 - (k23 * z140 + (k15 * z108 - k22 * z144)) + s_steer * z170 + c_steer *
        z173);
    const double k58 = kept[34];
    const double z181 = h2z * k58 + (k53 * z124 + (k34 * z131 - k50 * z133) + (z136 * z171 + z134 * z167));
    const double z182 = e2z * k39 - (k26 * z124 - (k16 * z126 - k23 * z132) - (z102 * z178 + z55 * z164));
    const double z183 = c_steer * z146 + s_steer * z152;
    const double z184 = z181 - (k53 * z141 + (k34 * z143 - k50 * z145)) - (z182 + (k26 * z140 - (k16 * z108 +
        k23 * z144)) + k9 * z183);
    const double z185 = z33 * (c_roll * (z180 + c1 * z184) - e2z * z175);
    const double z186 = z40 * z163 - z5 * z185;
    const double z187 = z40 * z176 - z12 * z185;
    const double z188 = z24 * z177 - z23 * z186 - z25 * z187;
    const double z189 = z30 * z177 + z29 * z186 + z15 * z187;
    const double z190 = c_steer * z188 + s_steer * z189;
    const double z191 = z153 - z190;
    const double z192 = z32 * z163 + z31 * z176;
    const double z193 = z161 + z192;
    const double z194 = s1 * z191 + c1 * z193;
    const double z195 = e2z * k38 - (k16 * z124 - (k14 * z126 + k15 * z132) - (z99 * z155 - z102 * z101));
    const double z196 = s_steer * z188 - c_steer * z189;
    const double z197 = z195 + (k16 * z140 - (k14 * z108 - k15 * z144)) + z183 + z196;
    const double z198 = e2z * z194 - c_roll * z197;
    const double z199 = c1 * z191 - s1 * z193;
    const double s_yaw = kept[0];
    const double c_yaw = kept[1];
    /* (I.4.1) 115:5 */
    lambda[0] = c_yaw * z199 - s_yaw * z198; /* reaction of rear_x: Q_i gains lambda_1 a_1i */
    /* (I.4.1) 116:5 */
    lambda[1] = c_yaw * z198 + s_yaw * z199; /* reaction of rear_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 117:5 */
    lambda[2] = -(c_roll * z194 + e2z * z197); /* reaction of rear_z: Q_i gains lambda_3 a_3i */
    const double z200 = s1 * z190 - c1 * z192;
    const double z201 = e2z * z200 + c_roll * z196;
    const double z202 = c1 * z190 + s1 * z192;
    /* (I.4.1) 118:5 */
    lambda[3] = c_yaw * z202 - s_yaw * z201; /* reaction of front_x: Q_i gains lambda_4 a_4i */
    /* (I.4.1) 119:5 */
    lambda[4] = c_yaw * z201 + s_yaw * z202; /* reaction of front_y: Q_i gains lambda_5 a_5i */
    /* (I.4.1) 120:5 */
    lambda[5] = e2z * z196 - c_roll * z200; /* reaction of front_z: Q_i gains lambda_6 a_6i */
    return BICYCLE_OK;
}

BICYCLE_SLOW
int bicycle_reactions(double t, const double *y, const double *p, double *lambda)
{
    double kept[94]; /* what parts of this function leave for others */
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
    const double roll = y[4]; /* second turn, about x [rad] */
    const double pitch = y[5]; /* third turn, about y [rad] */
    const double steer = y[6]; /* front frame against rear frame [rad] */
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double c_pitch = cos(pitch);
    const double s_pitch = sin(pitch);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);

    /* what else is read */
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double thF_dot = y[11]; /* thF' [rad/s] */
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

    /* from the parameters alone */
    const double k1 = r_R + z_B;
    const double k2 = w + c;
    const double k3 = r_F * s_lam - c * c_lam;
    const double k4 = x_H - k2;
    const double k5 = r_R * s_lam - c_lam * k2;
    const double k6 = z_H * s_lam - c_lam * k4;
    const double k7 = r_R * c_lam + s_lam * k2;
    const double k8 = c_lam * k1 + x_B * s_lam;
    const double k9 = s_lam * k1 - x_B * c_lam;
    const double k10 = fabs(r_R);
    const double k11 = fabs(r_F);
    const double k12 = fabs(w);
    const double k13 = fabs(c);
    const double k14 = 9.0 * k11;
    const double k15 = 6.0 * k13 + (2.0 * k12 + (5.0 * k10 + k14));
    const double k16 = 6.0 * k12;
    const double k17 = k7 + (z_H * c_lam + s_lam * k4);
    const double k18 = r_F * c_lam + c * s_lam - k7;
    const double k19 = 14.0 * k11 + 13.0 * k13;
    const double k20 = k14 + 10.0 * k13;

    /* from the state */
    const double z1 = c_pitch * s_lam + s_pitch * c_lam;
    const double z2 = c_roll * z1;
    const double z3 = 1.0 / fabs(c_roll);
    const double z4 = r_R * z3;
    const double z5 = z2 * z4;
    const double z6 = e2z * s_steer - c_steer * z2;
    const double z7 = c_pitch * c_lam - s_pitch * s_lam;
    const double z8 = c_roll * z7;
    const double z9 = r_F / sqrt(z8 * z8 + z6 * z6);
    const double z10 = z6 * z9;
    const double z11 = k3 + z10;
    const double z12 = k5 - z5 - c_steer * z11;
    const double z13 = z8 * z4;
    const double z14 = c_steer * z13;
    const double z15 = z8 * z9;
    const double z16 = k18 - z15;
    const double z17 = z1 * z16;
    const double z18 = z13 + z16;
    const double z19 = s_steer * z18;
    const double z20 = c_roll * (c_steer * z17 + z7 * (c_steer * k5 - z11)) - e2z * z19;
    const double z21 = c_steer * z18;
    const double z22 = c_roll * (s_steer * z17 + k5 * (s_steer * z7)) + e2z * z21;
    const double z23 = s_steer * z13;
    const double z24 = z14 * z20 + z22 * z23;
    const double z25 = z21 * z20 + z22 * z19;
    const double z26 = z12 * z24 + z5 * z25;
    const double z27 = k16 + k10 * (9.0 + fabs(z3));
    const double z28 = s_pitch * c_roll;
    const double e3z = c_pitch * c_roll;
    const double Sz = z - z28 * k2 + r_R * e3z;
    const double z29 = c_lam * z6 + s_lam * z8;
    const double z30 = c_lam * z8 - s_lam * z6;
    const double z31 = z * m_R + m_B * (z - x_B * z28 + e3z * k1) + m_H * (z_H * z30 + (Sz + k4 * z29));
    const double z32 = z11 * (s_steer * z2) - e2z * z12;
    const double z33 = roll_dot * z1;
    const double z34 = steer_dot + z33;
    const double z35 = roll_dot * z7;
    const double z36 = c_steer * z35;
    const double v2_x = c_roll * (roll_dot * z4);
    const double z37 = v2_x - k5 * z33;
    const double z38 = z34 * z10 - z36 * z15 + (k3 * z34 + k18 * z36 + c_steer * z37);
    const double z39 = s_steer * z35;
    const double z40 = thF_dot - z39;
    const double z41 = z40 * z15 + (k18 * z39 + s_steer * z37);
    const double z42 = z14 * z38 + z23 * z41;
    const double z43 = k3 * z39 - z40 * z10;
    const double z44 = z20 * z41 - z22 * z38;
    const double z45 = 1.0 / z26;
    const double z46 = z21 * z38 + z19 * z41;
    const double z47 = z45 * (z12 * z42 + z5 * z46);
    const double w2 = (z32 * z42 - z24 * z43 + z5 * z44) * z45 + e2z * z47;
    const double z48 = c_roll * z47;
    const double z49 = z35 - z1 * z48;
    const double z50 = c_steer * w2 - s_steer * z49;
    const double z51 = thF_dot + z50;
    const double z52 = (z32 * z46 - z12 * z44 - z25 * z43) * z45 - w2;
    const double z53 = z13 * z52;
    const double z54 = z33 + z7 * z48;
    const double z55 = v2_x - k5 * z54;
    const double z56 = c_steer * z53 + s_steer * z55;
    const double z57 = z56 - k18 * z50;
    const double z58 = c_steer * z55 - s_steer * z53;
    const double w3_steer = steer_dot + z54;
    const double z59 = s_steer * w2 + c_steer * z49;
    const double z60 = z58 + (k3 * w3_steer + k18 * z59);
    const double z61 = z5 * z52;
    const double z62 = z61 + k5 * w2;
    const double z63 = z62 - k3 * z50;
    const double z64 = c_lam * z59 + s_lam * w3_steer;
    const double z65 = z64 * z64;
    const double z66 = c_lam * w3_steer - s_lam * z59;
    const double z67 = z66 * z66;
    const double z68 = F_yy * (z51 * z51) + (m_F * (z57 * z57 + z60 * z60 + z63 * z63) + F_xx * (z65 + z67));
    const double z69 = z56 + k17 * z50;
    const double z70 = z58 - (k6 * w3_steer + k17 * z59);
    const double z71 = z62 + k6 * z50;
    const double z72 = m_H * (z69 * z69 + z70 * z70 + z71 * z71) + (H_xx * z65 + H_yy * (z50 * z50) + H_zz *
        z67);
    const double z73 = c_lam * z49 + s_lam * z54;
    const double z74 = z73 * z73;
    const double z75 = c_lam * z54 - s_lam * z49;
    const double z76 = z75 * z75;
    const double z77 = R_yy * (z52 * z52) + (m_R * (v2_x * v2_x + z53 * z53 + z61 * z61) + R_xx * (z74 +
        z76));
    const double z78 = z53 + k8 * w2;
    const double z79 = v2_x - (k9 * z54 + k8 * z49);
    const double z80 = z61 + k9 * w2;
    const double z81 = m_B * (z78 * z78 + z79 * z79 + z80 * z80) + (B_yy * (w2 * w2) + B_xx * z74 + B_zz *
        z76);
    const double z82 = 0.5 * z72 + H_xz * (z64 * z66) + (0.5 * z77 + (0.5 * z81 + B_xz * (z73 * z75)));
    /* the coframe is singular, if -z26 is nearly 0 */
    if (!(fabs(-z26) > 1e-12 * (k15 * ((z27 + k19) * (z27 + k20))))) {
        return (double)NAN;
    }
    return 0.5 * z68 + z82 - g * (m_F * (Sz - c * z29 - r_F * z30) + z31);
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
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
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

    /* what else is read */

    /* from the parameters alone */
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
    const double k10 = r_R * s_lam - c_lam * k2;
    kept[9] = k10;
    const double k11 = r_R * c_lam;
    const double k12 = s_lam * k2;
    const double x_B = p[8]; /* rear frame and rider, ahead of the rear contact [m] */
    const double k13 = c_lam * k1 + x_B * s_lam;
    const double k14 = s_lam * k1 - x_B * c_lam;
    const double k15 = k12 + (z_H * c_lam - s_lam * k3 + k11);
    const double k16 = k12 - (r_F * c_lam + c * s_lam - k11);
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
    const double k27 = m_B * k13;
    kept[15] = k27;
    const double k28 = m_B * k14;
    kept[16] = k28;
    const double B_xz = p[12]; /* [kg*m^2] */
    const double k29 = B_xz * c_lam;
    const double k30 = s_lam * k8 - k29;
    const double k31 = B_xz * s_lam;
    const double k32 = c_lam * k7 - k31;
    const double k33 = k13 * k27;
    const double k34 = s_lam * k30 + c_lam * k32 + k33;
    kept[17] = k34;
    const double k35 = c_lam * k30 - s_lam * k32 - k14 * k27;
    kept[18] = k35;
    const double k36 = k14 * k28;
    const double B_yy = p[13]; /* [kg*m^2] */
    const double k37 = k33 + (B_yy + k36);
    kept[19] = k37;
    const double k38 = k36 + (c_lam * (k31 + c_lam * k8) + s_lam * (k29 + s_lam * k7));
    kept[20] = k38;
    const double m_F = p[23]; /* mass of the front wheel [kg] */
    const double k39 = m_F * k16;
    const double m_H = p[17]; /* [kg] */
    const double k40 = m_H + m_F;
    kept[21] = k40;
    const double k41 = m_H * k15;
    const double k42 = k39 + k41;
    kept[22] = k42;
    const double k43 = m_F * k4;
    const double k44 = m_H * k9;
    const double k45 = k43 - k44;
    kept[23] = k45;
    const double H_xz = p[19]; /* [kg*m^2] */
    const double k46 = H_xz * c_lam;
    const double k47 = s_lam * k5 - k46;
    const double k48 = H_xz * s_lam;
    const double k49 = c_lam * k6 - k48;
    const double k50 = k16 * k39;
    const double k51 = k15 * k41;
    const double k52 = s_lam * k47 + c_lam * k49 + k50 + k51;
    kept[24] = k52;
    const double k53 = c_lam * k47 - s_lam * k49 + k4 * k39 - k9 * k41;
    kept[25] = k53;
    const double k54 = k4 * k43;
    const double k55 = k9 * k44;
    const double H_yy = p[20]; /* [kg*m^2] */
    const double k56 = k51 + (k50 + (H_yy + k54) + k55);
    kept[26] = k56;
    const double k57 = k55 + (k54 + (c_lam * (k48 + c_lam * k5) + s_lam * (k46 + s_lam * k6)));
    kept[27] = k57;
    const double g = p[3]; /* acceleration of gravity [m/s^2] */
    const double k58 = g * m_F;
    const double k59 = g * m_H;
    const double k60 = g * m_B;
    const double k61 = g * k26;
    kept[28] = k61;
    const double k62 = k14 * k60;
    kept[29] = k62;
    const double k63 = k13 * k60;
    kept[30] = k63;
    const double k64 = k9 * k59;
    kept[31] = k64;
    const double k65 = k15 * k59;
    kept[32] = k65;
    const double k66 = g * k40;
    kept[33] = k66;
    const double k67 = k4 * k58;
    kept[34] = k67;
    const double k68 = k16 * k58;
    kept[35] = k68;
    const double k69 = k65 + k68;
    kept[36] = k69;
    const double k70 = k64 - k67;
    kept[37] = k70;

    /* from the state */
    const double z2 = c_roll * c1;
    kept[38] = z2;
    const double z3 = c_roll * s1;
    kept[39] = z3;
    const double z4 = e2z * s_steer - c_steer * z3;
    kept[40] = z4;
    const double z5 = 1.0 / sqrt(z2 * z2 + z4 * z4);
    kept[41] = z5;
    const double z6 = r_F * z4;
    kept[42] = z6;
    const double z7 = z5 * z6;
    kept[43] = z7;
    const double z8 = k4 + z7;
    kept[44] = z8;
    const double z9 = s_steer * z8;
    kept[45] = z9;
    const double z10 = s1 * z9;
    kept[46] = z10;
    const double z11 = 1.0 / fabs(c_roll);
    kept[47] = z11;
    const double z12 = r_R * z3;
    kept[48] = z12;
    const double z13 = z11 * z12;
    kept[49] = z13;
    const double z14 = k10 - z13 - c_steer * z8;
    kept[50] = z14;
    const double z15 = c_roll * z10 - e2z * z14;
    kept[51] = z15;
    const double z16 = r_R * z2;
    kept[52] = z16;
    const double z17 = z11 * z16;
    kept[53] = z17;
    const double z18 = c_steer * z17;
    kept[54] = z18;
    const double z19 = r_F * z2;
    kept[55] = z19;
    const double z20 = z5 * z19;
    kept[56] = z20;
    const double z21 = k16 + z20;
    kept[57] = z21;
    const double z22 = z17 - z21;
    kept[58] = z22;
    const double z23 = s_steer * z22;
    kept[59] = z23;
    const double z24 = c_steer * z22;
    kept[60] = z24;
    const double z25 = s_steer * z17;
    kept[61] = z25;
    const double z26 = z18 * z23 - z24 * z25;
    kept[62] = z26;
    const double z27 = c_steer * z21;
    kept[63] = z27;
    const double z28 = c_steer * k10 - z8;
    kept[64] = z28;
    const double z29 = s1 * z27 - c1 * z28;
    kept[65] = z29;
    const double z30 = c_roll * z29 + e2z * z23;
    kept[66] = z30;
    const double z31 = s_steer * z21;
    kept[67] = z31;
    const double z32 = s_steer * k10;
    kept[68] = z32;
    const double z33 = s1 * z31 - c1 * z32;
    kept[69] = z33;
    const double z34 = c_roll * z33 - e2z * z24;
    kept[70] = z34;
    const double z35 = z18 * z30 + z34 * z25;
    kept[71] = z35;
    const double z36 = z24 * z30 + z34 * z23;
    kept[72] = z36;
    const double z37 = z15 * z26 + z14 * z35 + z13 * z36;
    kept[73] = z37;
    const double z38 = k17 * (9.0 + fabs(z11));
    kept[74] = z38;
    const double z39 = 1.0 / z37;
    kept[75] = z39;
    const double z40 = s_steer * c1;
    kept[76] = z40;
    const double z41 = z8 * z40;
    kept[77] = z41;
    const double z42 = c_steer * c1;
    kept[78] = z42;
    const double z43 = r_R * c_roll;
    kept[79] = z43;
    const double z44 = z11 * z43;
    kept[80] = z44;
    const double z45 = k10 * s1 - z44;
    kept[81] = z45;
    const double z46 = s1 * z7 - z20 * z42 - (k16 * z42 - k4 * s1 + c_steer * z45);
    kept[82] = z46;
    const double z47 = z20 * z40 + (k16 * z40 + s_steer * z45);
    kept[83] = z47;
    const double z48 = z18 * z46 - z25 * z47;
    kept[84] = z48;
    const double z49 = z24 * z46 - z23 * z47;
    kept[85] = z49;
    const double z50 = z26 * z41 - z14 * z48 - z13 * z49;
    kept[86] = z50;
    const double z51 = z39 * z50;
    kept[87] = z51;
    const double z52 = c_roll * z51;
    kept[88] = z52;
    const double z53 = s1 + c1 * z52;
    kept[89] = z53;
    const double z54 = z44 - k10 * z53;
    kept[90] = z54;
    const double z55 = z30 * z47 + z34 * z46;
    kept[91] = z55;
    const double z56 = z15 * z49 - z14 * z55 + z36 * z41;
    kept[92] = z56;
    const double z57 = z39 * z56;
    kept[93] = z57;
    const double z58 = z15 * z48 + z35 * z41 + z13 * z55;
    kept[94] = z58;
    const double z59 = z39 * z58;
    kept[95] = z59;
    const double z60 = z59 - e2z * z51;
    kept[96] = z60;
    const double z61 = z57 - z60;
    kept[97] = z61;
    const double z62 = z17 * z61;
    kept[98] = z62;
    const double z63 = c_steer * z54 + s_steer * z62;
    kept[99] = z63;
    const double z64 = c1 - s1 * z52;
    kept[100] = z64;
    const double z65 = s_steer * z60 - c_steer * z64;
    kept[101] = z65;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part2(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)t;
    const double k45 = kept[23];
    const double k53 = kept[25];
    const double k57 = kept[27];
    const double z53 = kept[89];
    const double z63 = kept[99];
    const double z65 = kept[101];
    const double z66 = k57 * z53 + (k45 * z63 + k53 * z65);
    kept[102] = z66;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double z60 = kept[96];
    const double z64 = kept[100];
    const double z67 = c_steer * z60 + s_steer * z64;
    kept[103] = z67;
    const double z54 = kept[90];
    const double z62 = kept[98];
    const double z68 = c_steer * z62 - s_steer * z54;
    kept[104] = z68;
    const double z13 = kept[49];
    const double z61 = kept[97];
    const double z69 = z13 * z61;
    kept[105] = z69;
    const double k10 = kept[9];
    const double z70 = z69 + k10 * z60;
    kept[106] = z70;
    const double k42 = kept[22];
    const double k56 = kept[26];
    const double z71 = k56 * z67 + (k42 * z68 - k45 * z70);
    kept[107] = z71;
    const double k52 = kept[24];
    const double z72 = k53 * z53 + (k42 * z63 + k52 * z65);
    kept[108] = z72;
    const double k40 = kept[21];
    const double z73 = k40 * z70 - k45 * z67;
    kept[109] = z73;
    const double z74 = k45 * z53 + (k40 * z63 + k42 * z65);
    kept[110] = z74;
    const double z75 = k40 * z68 + k42 * z67;
    kept[111] = z75;
    const double k28 = kept[16];
    const double k35 = kept[18];
    const double k38 = kept[20];
    const double z44 = kept[80];
    const double z76 = k38 * z53 - (z44 * k28 + k35 * z64);
    kept[112] = z76;
    const double k27 = kept[15];
    const double k37 = kept[19];
    const double z77 = z60 * k37 + (z62 * k27 + z69 * k28);
    kept[113] = z77;
    const double k34 = kept[17];
    const double z78 = k35 * z53 + (z44 * k27 - k34 * z64);
    kept[114] = z78;
    const double k26 = kept[14];
    const double z79 = z69 * k26 + z60 * k28;
    kept[115] = z79;
    const double z80 = z62 * k26 + z60 * k27;
    kept[116] = z80;
    const double z81 = k28 * z53 - (z44 * k26 - k27 * z64);
    kept[117] = z81;
    const double z82 = z53 * z76 + (z60 * z77 - (z64 * z78 - (z69 * z79 + (z62 * z80 - z44 * z81))));
    const double z83 = z53 * z66 + (z67 * z71 + (z65 * z72 + (z70 * z73 + (z63 * z74 + (z68 * z75 + z82)))));
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z84 = z83 + R_yy * (z61 * z61) + F_yy * (z67 * z67);
    kept[118] = z84;
    const double z8 = kept[44];
    const double z18 = kept[54];
    const double z85 = z18 * z8;
    kept[119] = z85;
    const double z24 = kept[60];
    const double z86 = z24 * z8;
    kept[120] = z86;
    const double z14 = kept[50];
    const double z87 = z14 * z85 + z13 * z86;
    kept[121] = z87;
    const double z39 = kept[75];
    const double z88 = z39 * z87;
    kept[122] = z88;
    const double c_roll = kept[0];
    const double z89 = c_roll * z88;
    kept[123] = z89;
    const double c1 = kept[3];
    const double z90 = c1 * z89;
    kept[124] = z90;
    const double z91 = 1.0 - z90;
    kept[125] = z91;
    const double z92 = k10 * z90;
    kept[126] = z92;
    const double z34 = kept[70];
    const double z93 = z34 * z8;
    kept[127] = z93;
    const double z15 = kept[51];
    const double z94 = z15 * z86 - z14 * z93;
    kept[128] = z94;
    const double z95 = z39 * z94;
    const double z96 = z15 * z85 + z13 * z93;
    kept[129] = z96;
    const double z97 = z39 * z96;
    const double e2z = kept[1];
    const double z98 = z97 + e2z * z88;
    kept[130] = z98;
    const double z99 = z95 - z98;
    kept[131] = z99;
    const double z17 = kept[53];
    const double z100 = z17 * z99;
    kept[132] = z100;
    const double z101 = c_steer * z92 + s_steer * z100;
    kept[133] = z101;
    const double s1 = kept[2];
    const double z102 = s1 * z89;
    kept[134] = z102;
    const double z103 = s_steer * z98 - c_steer * z102;
    kept[135] = z103;
    const double z104 = k57 * z91 + (k45 * z101 + k53 * z103);
    kept[136] = z104;
    const double z105 = c_steer * z98 + s_steer * z102;
    kept[137] = z105;
    const double z106 = c_steer * z100 - s_steer * z92;
    kept[138] = z106;
    const double z107 = z13 * z99;
    kept[139] = z107;
    const double z108 = z107 + k10 * z98;
    kept[140] = z108;
    const double z109 = k56 * z105 + (k42 * z106 - k45 * z108);
    kept[141] = z109;
    const double z110 = k53 * z91 + (k42 * z101 + k52 * z103);
    kept[142] = z110;
    const double z111 = k40 * z108 - k45 * z105;
    kept[143] = z111;
    const double z112 = k45 * z91 + (k40 * z101 + k42 * z103);
    kept[144] = z112;
    const double z113 = k40 * z106 + k42 * z105;
    kept[145] = z113;
    const double z114 = k35 * z102 + k38 * z90;
    kept[146] = z114;
    const double z115 = z98 * k37 + (z100 * k27 + z107 * k28);
    kept[147] = z115;
    const double z116 = k34 * z102 + k35 * z90;
    kept[148] = z116;
    const double z117 = z100 * k26 + z98 * k27;
    kept[149] = z117;
    const double z118 = z107 * k26 + z98 * k28;
    kept[150] = z118;
    const double z119 = z106 * z113 + (z90 * z114 + (z98 * z115 + (z102 * z116 + (z100 * z117 + z107 *
        z118))));
    const double z120 = z91 * z104 + (z105 * z109 + (z103 * z110 + (z108 * z111 + (z101 * z112 + z119)))) +
        R_yy * (z99 * z99);
    const double z121 = z120 + F_yy * (z105 * z105);
    kept[151] = z121;
    const double z122 = z106 * z75 - (z90 * z76 - (z98 * z77 - (z102 * z78 - (z100 * z80 + z107 * z79))));
    const double z123 = z91 * z66 + (z105 * z71 + (z103 * z72 + (z108 * z73 + (z101 * z74 + z122)))) + R_yy *
        (z61 * z99);
    const double z124 = z123 + F_yy * (z67 * z105);
    const double z125 = 1.0 / z84;
    kept[152] = z125;
    const double z126 = z124 * z125;
    kept[153] = z126;
    const double z127 = z121 - z124 * z126;
    kept[154] = z127;
    const double z20 = kept[56];
    const double z25 = kept[61];
    const double z128 = z20 * z25;
    kept[155] = z128;
    const double z23 = kept[59];
    const double z129 = z20 * z23;
    kept[156] = z129;
    const double z7 = kept[43];
    const double z26 = kept[62];
    const double z130 = z7 * z26 + z14 * z128 + z13 * z129;
    kept[157] = z130;
    const double z131 = z39 * z130;
    kept[158] = z131;
    const double z132 = c_roll * z131;
    kept[159] = z132;
    const double z133 = c1 * z132;
    kept[160] = z133;
    const double z134 = k10 * z133;
    kept[161] = z134;
    const double z30 = kept[66];
    const double z135 = z20 * z30;
    kept[162] = z135;
    const double z36 = kept[72];
    const double z136 = z15 * z129 + z14 * z135 - z7 * z36;
    kept[163] = z136;
    const double z137 = z39 * z136;
    const double z35 = kept[71];
    const double z138 = z15 * z128 - z7 * z35 - z13 * z135;
    kept[164] = z138;
    const double z139 = z39 * z138;
    const double z140 = z139 + e2z * z131;
    kept[165] = z140;
    const double z141 = z137 - z140;
    kept[166] = z141;
    const double z142 = z17 * z141;
    kept[167] = z142;
    const double z143 = c_steer * z134 + s_steer * z142;
    kept[168] = z143;
    const double z144 = s1 * z132;
    kept[169] = z144;
    const double z145 = s_steer * z140 - c_steer * z144;
    kept[170] = z145;
    const double z146 = k57 * z133 - (k45 * z143 + k53 * z145);
    kept[171] = z146;
    const double z147 = c_steer * z140 + s_steer * z144;
    kept[172] = z147;
    const double z148 = c_steer * z142 - s_steer * z134;
    kept[173] = z148;
    const double z149 = z13 * z141;
    kept[174] = z149;
    const double z150 = z149 + k10 * z140;
    kept[175] = z150;
    const double z151 = k56 * z147 + (k42 * z148 - k45 * z150);
    kept[176] = z151;
    const double z152 = k53 * z133 - (k42 * z143 + k52 * z145);
    kept[177] = z152;
    const double z153 = k40 * z150 - k45 * z147;
    kept[178] = z153;
    const double z154 = k45 * z133 - (k40 * z143 + k42 * z145);
    kept[179] = z154;
    const double z155 = k40 * z148 + k42 * z147;
    kept[180] = z155;
    const double z156 = k35 * z144 + k38 * z133;
    kept[181] = z156;
    const double z157 = z140 * k37 + (z142 * k27 + z149 * k28);
    kept[182] = z157;
    const double z158 = k34 * z144 + k35 * z133;
    kept[183] = z158;
    const double z159 = z142 * k26 + z140 * k27;
    kept[184] = z159;
    const double z160 = z149 * k26 + z140 * k28;
    kept[185] = z160;
    const double z161 = z148 * z155 + (z133 * z156 + (z140 * z157 + (z144 * z158 + (z142 * z159 + z149 *
        z160))));
    const double z162 = z133 * z146 + (z147 * z151 - (z145 * z152 - (z150 * z153 - (z143 * z154 - z161)))) +
        R_yy * (z141 * z141);
    const double z163 = 1.0 - z147;
    kept[186] = z163;
    const double z164 = z162 + F_yy * (z163 * z163);
    kept[187] = z164;
    const double z165 = z148 * z75 - (z133 * z76 - (z140 * z77 - (z144 * z78 - (z142 * z80 + z149 * z79))));
    const double z166 = z133 * z66 - (z147 * z71 + (z145 * z72 + (z150 * z73 + (z143 * z74 + z165)))) - R_yy
        * (z61 * z141);
    const double z167 = z166 + F_yy * (z67 * z163);
    const double z168 = z167 * z125;
    kept[188] = z168;
    const double z169 = z148 * z113 + (z133 * z114 + (z140 * z115 + (z144 * z116 + (z142 * z117 + z149 *
        z118))));
    const double z170 = z133 * z104 - (z147 * z109 + (z145 * z110 + (z150 * z111 + (z143 * z112 + z169)))) -
        R_yy * (z99 * z141);
    const double z171 = z170 + F_yy * (z105 * z163) - z124 * z168;
    const double z172 = 1.0 / z127;
    kept[189] = z172;
    const double z173 = z171 * z172;
    kept[190] = z173;
    const double z174 = z164 - z167 * z168 - z171 * z173;
    kept[191] = z174;
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
    const double z51 = kept[87];
    J[45] = z51;
    J[46] = -z88;
    J[47] = -z131;
    J[57] = 1.0;
    const double z59 = kept[95];
    J[69] = -z59;
    J[70] = -z97;
    J[71] = -z139;
    J[82] = 1.0;
    const double z57 = kept[93];
    J[93] = z57;
    J[94] = z95;
    J[95] = z137;
    J[107] = 1.0;
    const double z11 = kept[47];
    const double z184 = z11 * z11;
    kept[192] = z184;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z185 = roll_dot * r_R;
    kept[193] = z185;
    const double z186 = c_roll * z185;
    kept[194] = z186;
    const double z5 = kept[41];
    const double z187 = z5 * z5;
    kept[195] = z187;
    const double v2_x = z11 * z186;
    kept[196] = v2_x;
    const double z188 = z39 * z39;
    kept[197] = z188;
    const double z189 = roll_dot * c1;
    kept[198] = z189;
    const double z190 = s_steer * z189;
    kept[199] = z190;
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double z191 = thF_dot - z190;
    kept[200] = z191;
    const double z192 = roll_dot * s1;
    kept[201] = z192;
    return BICYCLE_OK;
}

BICYCLE_SLOW static int bicycle_jacobian_part3(double t, const double *y, const double *p, double *kept,
    double *J)
{
    (void)J;
    (void)t;
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double z192 = kept[201];
    const double z193 = steer_dot + z192;
    kept[202] = z193;
    const double c_steer = kept[5];
    const double z189 = kept[198];
    const double z194 = c_steer * z189;
    kept[203] = z194;
    const double k10 = kept[9];
    const double v2_x = kept[196];
    const double z195 = v2_x - k10 * z192;
    kept[204] = z195;
    const double k4 = kept[8];
    const double z7 = kept[43];
    const double z190 = kept[199];
    const double z191 = kept[200];
    const double z196 = k4 * z190 - z7 * z191;
    kept[205] = z196;
    const double k16 = kept[10];
    const double z20 = kept[56];
    const double z197 = z7 * z193 - z20 * z194 - (k16 * z194 - k4 * z193 - c_steer * z195);
    kept[206] = z197;
    const double s_steer = kept[4];
    const double z198 = z20 * z191 - (k16 * z190 - s_steer * z195);
    kept[207] = z198;
    const double z18 = kept[54];
    const double z25 = kept[61];
    const double z199 = z18 * z197 + z25 * z198;
    kept[208] = z199;
    const double z23 = kept[59];
    const double z24 = kept[60];
    const double z200 = z24 * z197 + z23 * z198;
    kept[209] = z200;
    const double z13 = kept[49];
    const double z14 = kept[50];
    const double z26 = kept[62];
    const double z201 = z26 * z196 - z14 * z199 - z13 * z200;
    kept[210] = z201;
    const double z30 = kept[66];
    const double z34 = kept[70];
    const double z202 = z30 * z198 - z34 * z197;
    kept[211] = z202;
    const double z15 = kept[51];
    const double z35 = kept[71];
    const double z203 = z15 * z199 + z35 * z196 - z13 * z202;
    kept[212] = z203;
    const double z36 = kept[72];
    const double z204 = z15 * z200 + z14 * z202 + z36 * z196;
    kept[213] = z204;
    const double z39 = kept[75];
    const double z205 = z39 * z201;
    kept[214] = z205;
    const double z206 = z39 * z204;
    kept[215] = z206;
    const double z207 = z39 * z203;
    kept[216] = z207;
    const double e2z = kept[1];
    const double z208 = z207 - e2z * z205;
    kept[217] = z208;
    const double z209 = z206 - z208;
    kept[218] = z209;
    const double z17 = kept[53];
    const double z210 = z17 * z209;
    kept[219] = z210;
    const double z211 = z13 * z209;
    kept[220] = z211;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const double z212 = s1 * z210 - c1 * z211;
    kept[221] = z212;
    const double z213 = s1 * z211 + c1 * z210;
    kept[222] = z213;
    const double c_roll = kept[0];
    const double z214 = c_roll * v2_x - e2z * z212;
    kept[223] = z214;
    const double z174 = kept[191];
    const double z272 = 1.0 / z174;
    kept[224] = z272;
    const double z273 = steer_dot * s_steer;
    kept[225] = z273;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double z274 = roll_dot * e2z;
    kept[226] = z274;
    const double z275 = s1 * z207;
    kept[227] = z275;
    const double z276 = z274 * c1 - c_roll * z275;
    kept[228] = z276;
    const double z277 = roll_dot * c_roll;
    kept[229] = z277;
    const double z278 = steer_dot * c_steer;
    kept[230] = z278;
    const double z279 = c1 * z207;
    kept[231] = z279;
    const double z280 = z274 * s1 + c_roll * z279;
    kept[232] = z280;
    const double z3 = kept[39];
    const double z281 = s_steer * z277 + e2z * z278 + (z273 * z3 + c_steer * z280);
    kept[233] = z281;
    const double z2 = kept[38];
    const double z4 = kept[40];
    const double z282 = z2 * z276 - z4 * z281;
    kept[234] = z282;
    const double z5 = kept[41];
    const double z283 = z5 * z282;
    kept[235] = z283;
    const double z187 = kept[195];
    const double z284 = z187 * z283;
    kept[236] = z284;
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z285 = r_F * z281;
    kept[237] = z285;
    const double z6 = kept[42];
    const double z286 = z6 * z284 + z5 * z285;
    kept[238] = z286;
    const double z287 = roll_dot * z279;
    kept[239] = z287;
    const double z288 = r_F * z276;
    kept[240] = z288;
    const double z19 = kept[55];
    const double z289 = z19 * z284 - z5 * z288;
    kept[241] = z289;
    const double z290 = roll_dot * z275;
    kept[242] = z290;
    const double z291 = z273 * z189 - c_steer * z290;
    kept[243] = z291;
    const double z292 = c_roll * z274;
    kept[244] = z292;
    const double z11 = kept[47];
    const double z293 = z11 * z292;
    kept[245] = z293;
    const double z184 = kept[192];
    const double z294 = z293 * z184;
    kept[246] = z294;
    const double z185 = kept[193];
    const double z295 = z274 * z185;
    kept[247] = z295;
    const double z186 = kept[194];
    const double z296 = z186 * z294 - z11 * z295 + k10 * z287;
    kept[248] = z296;
    const double z297 = z193 * z286 - z7 * z287 - (z194 * z289 - z20 * z291) + (k16 * z291 - k4 * z287 -
        (z273 * z195 - c_steer * z296));
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z298 = r_R * z276;
    kept[249] = z298;
    const double z16 = kept[52];
    const double z299 = z16 * z294 - z11 * z298;
    kept[250] = z299;
    const double z300 = z278 * z17 + s_steer * z299;
    kept[251] = z300;
    const double z21 = kept[57];
    const double z301 = z273 * z21 - c_steer * z289;
    kept[252] = z301;
    const double z302 = z273 * k10 + z286;
    kept[253] = z302;
    const double z27 = kept[63];
    const double z28 = kept[64];
    const double z303 = z27 * z279 + s1 * z301 + (z28 * z275 - c1 * z302);
    kept[254] = z303;
    const double z304 = z299 - z289;
    kept[255] = z304;
    const double z22 = kept[58];
    const double z305 = z278 * z22 + s_steer * z304;
    kept[256] = z305;
    const double z29 = kept[65];
    const double z306 = z274 * z29 + c_roll * z303 - (z277 * z23 + e2z * z305);
    kept[257] = z306;
    const double z307 = z297 + (z206 * z300 - (z205 * z306 + z207 * z305));
    kept[258] = z307;
    const double z308 = z278 * z189 + s_steer * z290;
    kept[259] = z308;
    const double z309 = z273 * z17 - c_steer * z299;
    kept[260] = z309;
    const double z310 = z278 * z21 + s_steer * z289;
    kept[261] = z310;
    const double z311 = z278 * k10;
    kept[262] = z311;
    const double z31 = kept[67];
    const double z32 = kept[68];
    const double z312 = z31 * z279 - s1 * z310 + (c1 * z311 + z32 * z275);
    kept[263] = z312;
    const double z313 = z273 * z22 - c_steer * z304;
    kept[264] = z313;
    const double z33 = kept[69];
    const double z314 = z274 * z33 + c_roll * z312 + (z277 * z24 - e2z * z313);
    kept[265] = z314;
    const double z315 = z191 * z289 - z20 * z308 - (k16 * z308 - (z278 * z195 + s_steer * z296)) + (z206 *
        z309 - (z205 * z314 + z207 * z313));
    kept[266] = z315;
    const double z316 = z18 * z307 + z25 * z315;
    kept[267] = z316;
    const double z317 = r_R * z280;
    kept[268] = z317;
    const double z12 = kept[48];
    const double z318 = z12 * z294 - z11 * z317;
    kept[269] = z318;
    const double z8 = kept[44];
    const double z319 = z278 * z8 + s_steer * z286;
    kept[270] = z319;
    const double z9 = kept[45];
    const double z320 = z9 * z279 - s1 * z319;
    kept[271] = z320;
    const double z321 = z318 - (z273 * z8 - c_steer * z286);
    kept[272] = z321;
    const double z10 = kept[46];
    const double z322 = z274 * z10 + c_roll * z320 + (z277 * z14 - e2z * z321);
    kept[273] = z322;
    const double z323 = k4 * z308 - (z191 * z286 - z7 * z308) - (z206 * z318 - (z205 * z322 + z207 * z321));
    kept[274] = z323;
    const double z324 = z30 * z315 - z34 * z307;
    kept[275] = z324;
    const double z325 = z15 * z316 + z35 * z323 - z13 * z324;
    kept[276] = z325;
    const double z326 = z24 * z307 + z23 * z315;
    kept[277] = z326;
    const double z327 = z26 * z323 - z14 * z316 - z13 * z326;
    kept[278] = z327;
    const double z328 = z39 * z327;
    kept[279] = z328;
    const double z329 = z39 * z325 - (z277 * z205 + e2z * z328);
    kept[280] = z329;
    const double z330 = c_roll * z205;
    kept[281] = z330;
    const double z331 = z189 - s1 * z330;
    kept[282] = z331;
    const double z332 = z274 * z205 - c_roll * z328;
    kept[283] = z332;
    const double z333 = z290 + (z330 * z279 + s1 * z332);
    kept[284] = z333;
    const double z334 = z273 * z208 - c_steer * z329 - (z278 * z331 + s_steer * z333);
    kept[285] = z334;
    const double z335 = z15 * z326 + z14 * z324 + z36 * z323;
    kept[286] = z335;
    const double z336 = z39 * z335 - z329;
    kept[287] = z336;
    const double z44 = kept[80];
    const double v2_x_2 = roll_dot * z44;
    kept[288] = v2_x_2;
    const double z337 = z192 + c1 * z330;
    kept[289] = z337;
    const double z338 = z209 * z299 + z17 * z336 - (z208 * z211 - v2_x_2 * z337);
    const double z339 = k10 * z208;
    kept[290] = z339;
    const double z340 = k10 * z337;
    kept[291] = z340;
    const double z341 = z338 - (z208 * z339 + z337 * z340);
    kept[292] = z341;
    const double z342 = r_R * z274;
    kept[293] = z342;
    const double z43 = kept[79];
    const double z343 = z43 * z294 - z11 * z342;
    kept[294] = z343;
    const double z344 = roll_dot * z343 - (z210 * z337 - z211 * z331);
    const double z345 = z287 - (z330 * z275 - c1 * z332);
    const double z346 = z344 + (k10 * z345 + z339 * z331);
    kept[295] = z346;
    const double z347 = c_steer * z341 - s_steer * z346;
    const double z348 = z209 * z318 + z13 * z336 - (v2_x_2 * z331 - z208 * z210);
    const double z349 = z348 + (k10 * z329 + z331 * z340);
    const double w3_steer = steer_dot + z337;
    kept[296] = w3_steer;
    const double z350 = s_steer * z208 - c_steer * z331;
    kept[297] = z350;
    const double k52 = kept[24];
    const double k53 = kept[25];
    const double z351 = k52 * z350 + k53 * w3_steer;
    kept[298] = z351;
    const double k57 = kept[27];
    const double z352 = k53 * z350 + k57 * w3_steer;
    kept[299] = z352;
    const double k42 = kept[22];
    const double k45 = kept[23];
    const double k56 = kept[26];
    const double k64 = kept[31];
    const double k65 = kept[32];
    const double k67 = kept[34];
    const double k68 = kept[35];
    const double z353 = z4 * k65 + z2 * k64 + (z4 * k68 - z2 * k67) - (k56 * z334 - (k42 * z347 - k45 * z349)
        - (w3_steer * z351 - z350 * z352));
    kept[300] = z353;
    const double h2z = e2z * c_steer + s_steer * z3;
    const double z354 = c_steer * z346 + s_steer * z341;
    const double z355 = z278 * z208 + s_steer * z329 + (z273 * z331 - c_steer * z333);
    const double z356 = c_steer * z208 + s_steer * z331;
    kept[301] = z356;
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z357 = F_yy * (thF_dot - z356) - k56 * z356;
    kept[302] = z357;
    const double k69 = kept[36];
    const double z358 = h2z * k69 + (k53 * z345 - (k42 * z354 + k52 * z355) - (z356 * z352 + w3_steer *
        z357));
    kept[303] = z358;
    const double z359 = k42 * z350 + k45 * w3_steer;
    kept[304] = z359;
    const double z360 = k42 * z356;
    kept[305] = z360;
    const double k40 = kept[21];
    const double k66 = kept[33];
    const double z361 = z2 * k66 + (k40 * z349 + k45 * z334 + (z350 * z359 + z356 * z360));
    kept[306] = z361;
    const double z362 = k45 * z356;
    kept[307] = z362;
    const double z363 = h2z * k66 + (k45 * z345 - (k40 * z354 + k42 * z355) + (w3_steer * z360 - z350 *
        z362));
    kept[308] = z363;
    const double z364 = z4 * k66 + (k40 * z347 - k42 * z334 + (z356 * z362 + w3_steer * z359));
    kept[309] = z364;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const double k37 = kept[19];
    const double z365 = R_yy * z209 - k37 * z208;
    kept[310] = z365;
    const double k34 = kept[17];
    const double k35 = kept[18];
    const double z366 = k34 * z331 - k35 * z337;
    kept[311] = z366;
    const double k28 = kept[16];
    const double k38 = kept[20];
    const double k62 = kept[29];
    const double z367 = e2z * k62 - (k38 * z345 + (k28 * z344 + k35 * z333) - (z331 * z365 + z208 * z366));
    kept[312] = z367;
    const double k70 = kept[37];
    const double z368 = h2z * k70 - (k57 * z345 - (k45 * z354 + k53 * z355) + (z350 * z357 + z356 * z351));
    kept[313] = z368;
    const double z369 = z367 + z368;
    kept[314] = z369;
    const double z370 = k35 * z331 - k38 * z337;
    kept[315] = z370;
    const double k27 = kept[15];
    const double k63 = kept[30];
    const double z371 = z3 * k63 - z2 * k62 - (k37 * z329 + (k27 * z338 + k28 * z348) - (z337 * z366 + z331 *
        z370));
    kept[316] = z371;
    const double z372 = e2z * k63 + (k35 * z345 - (k27 * z344 - k34 * z333) + (z208 * z370 - z337 * z365));
    kept[317] = z372;
    const double z373 = k27 * z331 + k28 * z337;
    kept[318] = z373;
    const double z374 = k27 * z208;
    kept[319] = z374;
    const double k26 = kept[14];
    const double k61 = kept[28];
    const double z375 = z2 * k61 + (k26 * z348 + k28 * z329 + (z331 * z373 + z208 * z374));
    kept[320] = z375;
    const double z376 = k28 * z208;
    kept[321] = z376;
    const double z377 = z3 * k61 - (k26 * z338 + k27 * z329 - (z208 * z376 + z337 * z373));
    kept[322] = z377;
    const double z378 = e2z * k61 - (k28 * z345 + (k26 * z344 - k27 * z333) - (z337 * z374 - z331 * z376));
    kept[323] = z378;
    const double z379 = z184 * (1.0 / c_roll);
    kept[324] = z379;
    const double z380 = z187 * z187;
    kept[325] = z380;
    const double z133 = kept[160];
    const double z140 = kept[165];
    const double z142 = kept[167];
    const double z144 = kept[169];
    const double z148 = kept[173];
    const double z149 = kept[174];
    const double z381 = z148 * z364 - (z133 * z367 + (z140 * z371 - (z144 * z372 - (z142 * z377 - z149 *
        z375))));
    const double z141 = kept[166];
    const double z143 = kept[168];
    const double z145 = kept[170];
    const double z147 = kept[172];
    const double z150 = kept[175];
    const double z382 = z133 * z368 - (z147 * z353 - (z145 * z358 - (z150 * z361 - (z143 * z363 - z381)))) -
        R_yy * (z141 * z336);
    const double z53 = kept[89];
    const double z60 = kept[96];
    const double z62 = kept[98];
    const double z64 = kept[100];
    const double z69 = kept[105];
    const double z383 = z53 * z367 - (z60 * z371 - (z64 * z372 + (z69 * z375 - (z62 * z377 + z44 * z378))));
    const double z63 = kept[99];
    const double z65 = kept[101];
    const double z67 = kept[103];
    const double z68 = kept[104];
    const double z70 = kept[106];
    const double z384 = z53 * z368 + (z67 * z353 - (z65 * z358 - (z70 * z361 - (z63 * z363 - (z68 * z364 +
        z383)))));
    const double z61 = kept[97];
    const double z385 = z384 + R_yy * (z61 * z336) - F_yy * (z67 * z334);
    const double z90 = kept[124];
    const double z98 = kept[130];
    const double z100 = kept[132];
    const double z102 = kept[134];
    const double z106 = kept[138];
    const double z107 = kept[139];
    const double z386 = z106 * z364 - (z90 * z367 + (z98 * z371 - (z102 * z372 - (z100 * z377 - z107 *
        z375))));
    const double z91 = kept[125];
    const double z99 = kept[131];
    const double z101 = kept[133];
    const double z103 = kept[135];
    const double z105 = kept[137];
    const double z108 = kept[140];
    const double z387 = z91 * z368 + (z105 * z353 - (z103 * z358 - (z108 * z361 - (z101 * z363 - z386)))) +
        R_yy * (z99 * z336);
    const double z126 = kept[153];
    const double z388 = z387 - F_yy * (z105 * z334) - z385 * z126;
    const double z163 = kept[186];
    const double z168 = kept[188];
    const double z173 = kept[190];
    const double z389 = z272 * (z382 - F_yy * (z163 * z334) - z385 * z168 - z173 * z388);
    kept[326] = z389;
    const double z172 = kept[189];
    const double z390 = z172 * z388 - z173 * z389;
    kept[327] = z390;
    const double z125 = kept[152];
    const double z391 = z385 * z125 - z126 * z390 - z168 * z389;
    kept[328] = z391;
    const double k22 = kept[11];
    const double k24 = kept[12];
    const double k25 = kept[13];
    const double z37 = kept[73];
    const double z38 = kept[74];
    /* the coframe is singular, if z37 is nearly 0 */
    if (!(fabs(z37) > 1e-12 * ((z38 + k25) * (k22 * (z38 + k24))))) {
        return bicycle_refuse(fabs(z37), 1e-12 * ((z38 + k25) * (k22 * (z38 + k24))), BICYCLE_SINGULAR_1);
    }
    const double z84 = kept[118];
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z84 is 0 */
    if (!(fabs(z84) > 0.0)) {
        return bicycle_refuse(fabs(z84), 0.0, BICYCLE_SINGULAR_2);
    }
    const double z121 = kept[151];
    const double z127 = kept[154];
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z127 is nearly 0 */
    if (!(fabs(z127) > 1e-13 * z121)) {
        return bicycle_refuse(fabs(z127), 1e-13 * z121, BICYCLE_SINGULAR_2);
    }
    const double z164 = kept[187];
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z174 is nearly 0 */
    if (!(fabs(z174) > 1e-13 * z164)) {
        return bicycle_refuse(fabs(z174), 1e-13 * z164, BICYCLE_SINGULAR_2);
    }
    return BICYCLE_OK;
}

BICYCLE_SLOW static void bicycle_jacobian_sweep1(double t, const double *y, const double *p,
    const double *kept, const double *seed, double *slope)
{
    (void)t;
    const double s_yaw = kept[6];
    const bicycle_lanes turn_3 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes z215 = s_yaw * turn_3;
    const double c1 = kept[3];
    const bicycle_lanes turn_5 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z216 = c1 * turn_5;
    const double e2z = kept[1];
    const bicycle_lanes turn_4 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z217 = e2z * turn_4;
    const double c_roll = kept[0];
    const double z11 = kept[47];
    const double z184 = kept[192];
    const bicycle_lanes z218 = z184 * (z11 * (c_roll * z217));
    const double s1 = kept[2];
    const bicycle_lanes z219 = s1 * z217 - c_roll * z216;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z12 = kept[48];
    const bicycle_lanes z220 = z12 * z218 - z11 * (r_R * z219);
    const double c_steer = kept[5];
    const bicycle_lanes turn_6 = bicycle_get(seed + 3 * BICYCLE_LANES);
    const bicycle_lanes z221 = c_steer * turn_6;
    const bicycle_lanes z222 = s1 * turn_5;
    const bicycle_lanes z223 = c1 * z217 + c_roll * z222;
    const bicycle_lanes z224 = c_roll * turn_4;
    const double s_steer = kept[4];
    const bicycle_lanes z225 = s_steer * turn_6;
    const double z3 = kept[39];
    const bicycle_lanes z226 = s_steer * z224 + e2z * z221 + (z3 * z225 + c_steer * z219);
    const double z2 = kept[38];
    const double z4 = kept[40];
    const double z5 = kept[41];
    const double z187 = kept[195];
    const bicycle_lanes z227 = z187 * (z5 * (z2 * z223 - z4 * z226));
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z6 = kept[42];
    const bicycle_lanes z228 = z6 * z227 + z5 * (r_F * z226);
    const double z8 = kept[44];
    const bicycle_lanes z229 = z220 - (z8 * z225 - c_steer * z228);
    const double z9 = kept[45];
    const double z10 = kept[46];
    const double z14 = kept[50];
    const bicycle_lanes z230 = z10 * z217 - c_roll * (z9 * z216 + s1 * (z8 * z221 + s_steer * z228)) + (z14 *
        z224 - e2z * z229);
    const double z16 = kept[52];
    const bicycle_lanes z231 = z16 * z218 - z11 * (r_R * z223);
    const double z17 = kept[53];
    const bicycle_lanes z232 = z17 * z225 - c_steer * z231;
    const double z19 = kept[55];
    const bicycle_lanes z233 = z19 * z227 - z5 * (r_F * z223);
    const bicycle_lanes z234 = z231 - z233;
    const double z22 = kept[58];
    const bicycle_lanes z235 = z22 * z221 + s_steer * z234;
    const bicycle_lanes z236 = z22 * z225 - c_steer * z234;
    const bicycle_lanes z237 = z17 * z221 + s_steer * z231;
    const double z18 = kept[54];
    const double z23 = kept[59];
    const double z24 = kept[60];
    const double z25 = kept[61];
    const bicycle_lanes z238 = z23 * z232 - z18 * z235 - (z25 * z236 - z24 * z237);
    const double k10 = kept[9];
    const double z21 = kept[57];
    const double z27 = kept[63];
    const double z28 = kept[64];
    const bicycle_lanes z239 = z27 * z216 - s1 * (z21 * z225 - c_steer * z233) + (z28 * z222 + c1 * (z228 +
        k10 * z225));
    const double z29 = kept[65];
    const bicycle_lanes z240 = z29 * z217 - c_roll * z239 - (z23 * z224 + e2z * z235);
    const double z31 = kept[67];
    const double z32 = kept[68];
    const bicycle_lanes z241 = z31 * z216 + s1 * (z21 * z221 + s_steer * z233) + (z32 * z222 - c1 * (k10 *
        z221));
    const double z33 = kept[69];
    const bicycle_lanes z242 = z33 * z217 - c_roll * z241 + (z24 * z224 - e2z * z236);
    const double z30 = kept[66];
    const double z34 = kept[70];
    const bicycle_lanes z243 = z30 * z232 + z18 * z240 + (z25 * z242 - z34 * z237);
    const bicycle_lanes z244 = z30 * z236 + z24 * z240 + (z23 * z242 - z34 * z235);
    const double z13 = kept[49];
    const double z15 = kept[51];
    const double z26 = kept[62];
    const double z35 = kept[71];
    const double z36 = kept[72];
    const bicycle_lanes z245 = z26 * z230 + z15 * z238 + (z35 * z229 + z14 * z243) - (z36 * z220 - z13 *
        z244);
    const double z188 = kept[197];
    const bicycle_lanes z246 = z188 * z245;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const bicycle_lanes z247 = roll_dot * z216;
    const bicycle_lanes z248 = roll_dot * z222;
    const double z189 = kept[198];
    const bicycle_lanes z249 = z189 * z225 + c_steer * z248;
    const double z185 = kept[193];
    const double z186 = kept[194];
    const bicycle_lanes z250 = z186 * z218 - z11 * (z185 * z217);
    const bicycle_lanes z251 = z250 - k10 * z247;
    const double k4 = kept[8];
    const double k16 = kept[10];
    const double z7 = kept[43];
    const double z20 = kept[56];
    const double z193 = kept[202];
    const double z194 = kept[203];
    const double z195 = kept[204];
    const bicycle_lanes z252 = z193 * z228 + z7 * z247 - (z194 * z233 - z20 * z249) + (k16 * z249 + k4 * z247
        - (z195 * z225 - c_steer * z251));
    const bicycle_lanes z253 = z189 * z221 - s_steer * z248;
    const double z191 = kept[200];
    const bicycle_lanes z254 = z191 * z233 - z20 * z253 - (k16 * z253 - (z195 * z221 + s_steer * z251));
    const double z197 = kept[206];
    const double z198 = kept[207];
    const bicycle_lanes z255 = z197 * z236 - z24 * z252 - (z198 * z235 + z23 * z254);
    const bicycle_lanes z256 = z198 * z240 - z30 * z254 - (z197 * z242 - z34 * z252);
    const bicycle_lanes z257 = k4 * z253 - (z191 * z228 - z7 * z253);
    const double z196 = kept[205];
    const double z200 = kept[209];
    const double z202 = kept[211];
    const bicycle_lanes z258 = z200 * z230 + z15 * z255 + (z202 * z229 + z14 * z256) + (z196 * z244 - z36 *
        z257);
    const double z39 = kept[75];
    const double z204 = kept[213];
    const bicycle_lanes z259 = z204 * z246 - z39 * z258;
    const bicycle_lanes z260 = z197 * z232 - z18 * z252 - (z198 * z237 + z25 * z254);
    const double z199 = kept[208];
    const bicycle_lanes z261 = z199 * z230 + z15 * z260 + (z196 * z243 - z35 * z257) + (z202 * z220 - z13 *
        z256);
    const double z203 = kept[212];
    const bicycle_lanes z262 = z203 * z246 - z39 * z261;
    const bicycle_lanes z263 = z196 * z238 - z26 * z257 - (z199 * z229 + z14 * z260) + (z200 * z220 - z13 *
        z255);
    const double z201 = kept[210];
    const bicycle_lanes z264 = z201 * z246 - z39 * z263;
    const double z205 = kept[214];
    const bicycle_lanes z265 = z259 - (z262 - (z205 * z224 + e2z * z264));
    const double z209 = kept[218];
    const bicycle_lanes z266 = z209 * z220 + z13 * z265;
    const bicycle_lanes z267 = z209 * z231 + z17 * z265;
    const double z210 = kept[219];
    const double z211 = kept[220];
    const bicycle_lanes z268 = z211 * z216 + s1 * z266 - (z210 * z222 - c1 * z267);
    const double c_yaw = kept[7];
    const bicycle_lanes z269 = c_yaw * turn_3;
    const bicycle_lanes z270 = z210 * z216 + s1 * z267 + (z211 * z222 - c1 * z266);
    const double v2_x = kept[196];
    const double z212 = kept[221];
    const bicycle_lanes z271 = v2_x * z217 - c_roll * z250 + (z212 * z224 + e2z * z270);
    const double z213 = kept[222];
    const double z214 = kept[223];
    bicycle_put(slope + 0 * BICYCLE_LANES, z213 * z215 - c_yaw * z268 - (z214 * z269 - s_yaw * z271));
    bicycle_put(slope + 1 * BICYCLE_LANES, -(z213 * z269 + s_yaw * z268 + (z214 * z215 + c_yaw * z271)));
    bicycle_put(slope + 2 * BICYCLE_LANES, v2_x * z224 + e2z * z250 - (z212 * z217 - c_roll * z270));
    bicycle_put(slope + 3 * BICYCLE_LANES, z264);
    bicycle_put(slope + 4 * BICYCLE_LANES, -z262);
    bicycle_put(slope + 5 * BICYCLE_LANES, z259);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part1(double t, const double *y, const double *p,
    const double *kept, const double *seed, double *carried, double *slope)
{
    (void)slope;
    (void)t;
    const double z126 = kept[153];
    const bicycle_lanes row_0 = bicycle_get(seed + 0 * BICYCLE_LANES);
    const bicycle_lanes row_1 = bicycle_get(seed + 1 * BICYCLE_LANES);
    const bicycle_lanes z392 = row_1 - z126 * row_0;
    const double z168 = kept[188];
    const double z173 = kept[190];
    const double z272 = kept[224];
    const bicycle_lanes row_2 = bicycle_get(seed + 2 * BICYCLE_LANES);
    const bicycle_lanes z393 = z272 * (row_2 + z168 * row_0 + z173 * z392);
    bicycle_put(carried + 0 * BICYCLE_LANES, z393);
    const double z172 = kept[189];
    const bicycle_lanes z394 = z172 * z392 + z173 * z393;
    bicycle_put(carried + 1 * BICYCLE_LANES, z394);
    const double z125 = kept[152];
    const bicycle_lanes z395 = z125 * row_0 - z126 * z394 + z168 * z393;
    bicycle_put(carried + 2 * BICYCLE_LANES, z395);
    const double z60 = kept[96];
    const double z98 = kept[130];
    const double z140 = kept[165];
    const bicycle_lanes z396 = z140 * z393 + z98 * z394 + z60 * z395;
    bicycle_put(carried + 3 * BICYCLE_LANES, z396);
    const double z69 = kept[105];
    const double z107 = kept[139];
    const double z149 = kept[174];
    const bicycle_lanes z397 = z149 * z393 + z107 * z394 + z69 * z395;
    bicycle_put(carried + 4 * BICYCLE_LANES, z397);
    const double z62 = kept[98];
    const double z100 = kept[132];
    const double z142 = kept[167];
    const bicycle_lanes z398 = z142 * z393 + z100 * z394 + z62 * z395;
    bicycle_put(carried + 5 * BICYCLE_LANES, z398);
    const double z67 = kept[103];
    const double z105 = kept[137];
    const double z147 = kept[172];
    const bicycle_lanes z399 = z147 * z393 + z105 * z394 + z67 * z395;
    bicycle_put(carried + 6 * BICYCLE_LANES, z399);
    const double z70 = kept[106];
    const double z108 = kept[140];
    const double z150 = kept[175];
    const bicycle_lanes z400 = z150 * z393 + z108 * z394 + z70 * z395;
    bicycle_put(carried + 7 * BICYCLE_LANES, z400);
    const double k40 = kept[21];
    const double k45 = kept[23];
    const bicycle_lanes z401 = k45 * z399 - k40 * z400;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const bicycle_lanes z402 = F_yy * z393;
    const bicycle_lanes z403 = F_yy * z394;
    const bicycle_lanes z404 = F_yy * z395;
    bicycle_put(carried + 8 * BICYCLE_LANES, z404);
    const double z68 = kept[104];
    const double z106 = kept[138];
    const double z148 = kept[173];
    const bicycle_lanes z405 = z148 * z393 + z106 * z394 + z68 * z395;
    bicycle_put(carried + 9 * BICYCLE_LANES, z405);
    const double k42 = kept[22];
    const double k56 = kept[26];
    const double z163 = kept[186];
    const bicycle_lanes z406 = z163 * z402 - z105 * z403 - z67 * z404 - k56 * z399 + k45 * z400 - k42 * z405;
    bicycle_put(carried + 10 * BICYCLE_LANES, z406);
    const double z133 = kept[160];
    const bicycle_lanes z407 = z133 * z393;
    const double z53 = kept[89];
    const bicycle_lanes z408 = z53 * z395;
    const double z91 = kept[125];
    const bicycle_lanes z409 = z407 - z91 * z394 - z408;
    bicycle_put(carried + 11 * BICYCLE_LANES, z409);
    const double z65 = kept[101];
    const double z103 = kept[135];
    const double z145 = kept[170];
    const bicycle_lanes z410 = z145 * z393 + z103 * z394 + z65 * z395;
    bicycle_put(carried + 12 * BICYCLE_LANES, z410);
    const double z63 = kept[99];
    const double z101 = kept[133];
    const double z143 = kept[168];
    const bicycle_lanes z411 = z143 * z393 + z101 * z394 + z63 * z395;
    bicycle_put(carried + 13 * BICYCLE_LANES, z411);
    const double k52 = kept[24];
    const double k53 = kept[25];
    const bicycle_lanes z412 = k53 * z409 - k52 * z410 - k42 * z411;
    bicycle_put(carried + 14 * BICYCLE_LANES, z412);
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const double k10 = kept[9];
    const double k27 = kept[15];
    const double k28 = kept[16];
    const double k37 = kept[19];
    const bicycle_lanes z413 = k37 * z396 + k28 * z397 + k27 * z398 - k10 * z401 - c_steer * z406 - s_steer *
        z412;
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z414 = R_yy * z393;
    bicycle_put(carried + 15 * BICYCLE_LANES, z414);
    const bicycle_lanes z415 = R_yy * z394;
    bicycle_put(carried + 16 * BICYCLE_LANES, z415);
    const bicycle_lanes z416 = R_yy * z395;
    bicycle_put(carried + 17 * BICYCLE_LANES, z416);
    const double k26 = kept[14];
    const bicycle_lanes z417 = z401 - (k28 * z396 + k26 * z397);
    bicycle_put(carried + 18 * BICYCLE_LANES, z417);
    const bicycle_lanes z418 = k45 * z409 - k42 * z410 - k40 * z411;
    bicycle_put(carried + 19 * BICYCLE_LANES, z418);
    const bicycle_lanes z419 = k42 * z399 + k40 * z405;
    bicycle_put(carried + 20 * BICYCLE_LANES, z419);
    const bicycle_lanes z420 = s_steer * z418 - c_steer * z419;
    const bicycle_lanes z421 = k27 * z396 + k26 * z398 - z420;
    bicycle_put(carried + 21 * BICYCLE_LANES, z421);
    const double z13 = kept[49];
    const double z17 = kept[53];
    const double z61 = kept[97];
    const double z99 = kept[131];
    const double z141 = kept[166];
    const bicycle_lanes z422 = z141 * z414 + z99 * z415 + z61 * z416 - z13 * z417 + z17 * z421;
    bicycle_put(carried + 22 * BICYCLE_LANES, z422);
    const bicycle_lanes z423 = z413 - z422;
    bicycle_put(carried + 23 * BICYCLE_LANES, z423);
    const double z39 = kept[75];
    const bicycle_lanes z424 = z39 * z422;
    bicycle_put(carried + 24 * BICYCLE_LANES, z424);
    const bicycle_lanes z425 = z39 * z423;
    bicycle_put(carried + 25 * BICYCLE_LANES, z425);
    const double z90 = kept[124];
    const bicycle_lanes z426 = z407 + z90 * z394 - z408;
    bicycle_put(carried + 26 * BICYCLE_LANES, z426);
    const double z64 = kept[100];
    const double z102 = kept[134];
    const double z144 = kept[169];
    const bicycle_lanes z427 = z144 * z393 + z102 * z394 + z64 * z395;
    bicycle_put(carried + 27 * BICYCLE_LANES, z427);
    const double z44 = kept[80];
    const bicycle_lanes z428 = z44 * z395;
    bicycle_put(carried + 28 * BICYCLE_LANES, z428);
    const double k34 = kept[17];
    const double k35 = kept[18];
    const bicycle_lanes z429 = k35 * z426 + k34 * z427 - k27 * z428 - s_steer * z406 + c_steer * z412;
    bicycle_put(carried + 29 * BICYCLE_LANES, z429);
    const double k38 = kept[20];
    const double k57 = kept[27];
    const bicycle_lanes z430 = k57 * z409 - k53 * z410 - k45 * z411 + k38 * z426 + k35 * z427 + k28 * z428;
    const bicycle_lanes z431 = c_steer * z418 + s_steer * z419;
    const bicycle_lanes z432 = z430 - k10 * z431;
    bicycle_put(carried + 30 * BICYCLE_LANES, z432);
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z433 = s1 * z429 + c1 * z432;
    bicycle_put(carried + 31 * BICYCLE_LANES, z433);
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z434 = c_roll * z433 + e2z * z423;
    bicycle_put(carried + 32 * BICYCLE_LANES, z434);
    const bicycle_lanes z435 = z39 * z434;
    bicycle_put(carried + 33 * BICYCLE_LANES, z435);
    const double z26 = kept[62];
    const double z35 = kept[71];
    const double z36 = kept[72];
    const bicycle_lanes z436 = z36 * z424 + z35 * z425 - z26 * z435;
    bicycle_put(carried + 34 * BICYCLE_LANES, z436);
    const double z205 = kept[214];
    const bicycle_lanes z437 = z205 * z436;
    bicycle_put(carried + 35 * BICYCLE_LANES, z437);
    const double z14 = kept[50];
    const bicycle_lanes z438 = z14 * z424 - z13 * z425;
    bicycle_put(carried + 36 * BICYCLE_LANES, z438);
    const double z15 = kept[51];
    const bicycle_lanes z439 = z15 * z424 + z13 * z435;
    bicycle_put(carried + 37 * BICYCLE_LANES, z439);
    const bicycle_lanes z440 = z15 * z425 + z14 * z435;
    bicycle_put(carried + 38 * BICYCLE_LANES, z440);
    const double z18 = kept[54];
    const double z24 = kept[60];
    const double z34 = kept[70];
    const bicycle_lanes z441 = z34 * z438 - z24 * z439 - z18 * z440;
    bicycle_put(carried + 39 * BICYCLE_LANES, z441);
    const bicycle_lanes z442 = z205 * z441;
    bicycle_put(carried + 40 * BICYCLE_LANES, z442);
    const double z23 = kept[59];
    const double z25 = kept[61];
    const double z30 = kept[66];
    const bicycle_lanes z443 = z30 * z438 + z23 * z439 + z25 * z440;
    bicycle_put(carried + 41 * BICYCLE_LANES, z443);
    const bicycle_lanes z444 = z205 * z443;
    bicycle_put(carried + 42 * BICYCLE_LANES, z444);
    const double z207 = kept[216];
    const bicycle_lanes z445 = z207 * z436 - e2z * z437;
    bicycle_put(carried + 43 * BICYCLE_LANES, z445);
    const bicycle_lanes z446 = c_roll * z437;
    bicycle_put(carried + 44 * BICYCLE_LANES, z446);
    const bicycle_lanes z447 = s1 * z446;
    bicycle_put(carried + 45 * BICYCLE_LANES, z447);
    const bicycle_lanes z448 = c_roll * z442;
    bicycle_put(carried + 46 * BICYCLE_LANES, z448);
    const bicycle_lanes z449 = c1 * z448;
    bicycle_put(carried + 47 * BICYCLE_LANES, z449);
    const double z191 = kept[200];
    const double z193 = kept[202];
    const bicycle_lanes z450 = z193 * z441 + z191 * z436 - c_steer * z445 + s_steer * z447 + z449;
    bicycle_put(carried + 48 * BICYCLE_LANES, z450);
    const bicycle_lanes z451 = z207 * z441 - e2z * z442;
    bicycle_put(carried + 49 * BICYCLE_LANES, z451);
    const bicycle_lanes z452 = z207 * z443 - e2z * z444;
    bicycle_put(carried + 50 * BICYCLE_LANES, z452);
    const bicycle_lanes z453 = s_steer * z451 + c_steer * z452;
    const bicycle_lanes z454 = s1 * z448;
    bicycle_put(carried + 51 * BICYCLE_LANES, z454);
    const bicycle_lanes z455 = c_roll * z444;
    bicycle_put(carried + 52 * BICYCLE_LANES, z455);
    const bicycle_lanes z456 = s1 * z455;
    bicycle_put(carried + 53 * BICYCLE_LANES, z456);
    const double z194 = kept[203];
    const bicycle_lanes z457 = z453 - (z191 * z443 + z194 * z441 - c_steer * z454 + s_steer * z456);
    bicycle_put(carried + 54 * BICYCLE_LANES, z457);
    const double z6 = kept[42];
    const double z19 = kept[55];
    const bicycle_lanes z458 = z6 * z450 + z19 * z457;
    bicycle_put(carried + 55 * BICYCLE_LANES, z458);
    const double z187 = kept[195];
    const bicycle_lanes z459 = z187 * z458;
    bicycle_put(carried + 56 * BICYCLE_LANES, z459);
    const double z5 = kept[41];
    const bicycle_lanes z460 = z5 * z459;
    bicycle_put(carried + 57 * BICYCLE_LANES, z460);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double z4 = kept[40];
    const bicycle_lanes z461 = r_F * (z5 * z450) - z4 * z460;
    bicycle_put(carried + 58 * BICYCLE_LANES, z461);
    const bicycle_lanes z462 = z205 * z423 - z14 * z437 + z23 * z442 + z24 * z444 + s_steer * z461;
    bicycle_put(carried + 59 * BICYCLE_LANES, z462);
    const bicycle_lanes z463 = s_steer * z443 - c_steer * z441;
    bicycle_put(carried + 60 * BICYCLE_LANES, z463);
    const double z331 = kept[282];
    const double z337 = kept[289];
    const bicycle_lanes z464 = z331 * z426 + z337 * z427;
    const bicycle_lanes z465 = k28 * z426 - k27 * z427 + k26 * z428 - z431;
    bicycle_put(carried + 61 * BICYCLE_LANES, z465);
    const double z208 = kept[217];
    const bicycle_lanes z466 = z331 * z465 - z208 * z421;
    bicycle_put(carried + 62 * BICYCLE_LANES, z466);
    const bicycle_lanes z467 = z208 * z417 + z337 * z465;
    bicycle_put(carried + 63 * BICYCLE_LANES, z467);
    const double z299 = kept[250];
    const double z318 = kept[269];
    const bicycle_lanes z468 = R_yy * z464 + z318 * z417 - z299 * z421 - z13 * z466 + z17 * z467;
    const double z300 = kept[251];
    const double z309 = kept[260];
    const bicycle_lanes z469 = z309 * z443 - z300 * z441 - z318 * z436 - z468;
    bicycle_put(carried + 64 * BICYCLE_LANES, z469);
    const bicycle_lanes z470 = z39 * z469;
    bicycle_put(carried + 65 * BICYCLE_LANES, z470);
    const double z21 = kept[57];
    const bicycle_lanes z471 = z21 * z441;
    bicycle_put(carried + 66 * BICYCLE_LANES, z471);
    const double k4 = kept[8];
    const double z7 = kept[43];
    const bicycle_lanes z472 = z21 * z443 - z7 * z436 - k4 * z436;
    bicycle_put(carried + 67 * BICYCLE_LANES, z472);
    const bicycle_lanes z473 = z429 + c_steer * z471 - s_steer * z472;
    bicycle_put(carried + 68 * BICYCLE_LANES, z473);
    const double z206 = kept[215];
    const bicycle_lanes z474 = z206 * z441;
    bicycle_put(carried + 69 * BICYCLE_LANES, z474);
    const bicycle_lanes z475 = z206 * z443;
    bicycle_put(carried + 70 * BICYCLE_LANES, z475);
    const double z209 = kept[218];
    const bicycle_lanes z476 = z209 * z421 - s_steer * z474 + z453 - c_steer * z475;
    bicycle_put(carried + 71 * BICYCLE_LANES, z476);
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z2 = kept[38];
    const double z11 = kept[47];
    const bicycle_lanes z477 = r_F * (z5 * z457) - r_R * (z11 * z476) - z2 * z460;
    bicycle_put(carried + 72 * BICYCLE_LANES, z477);
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double z28 = kept[64];
    const double z32 = kept[68];
    const double z330 = kept[281];
    const bicycle_lanes z478 = z330 * z432 - z28 * z448 + z32 * z455 - roll_dot * z473 + c_roll * z477;
    bicycle_put(carried + 73 * BICYCLE_LANES, z478);
    const bicycle_lanes z479 = z432 + z7 * z441 + k4 * z441 + k10 * z463;
    bicycle_put(carried + 74 * BICYCLE_LANES, z479);
    const bicycle_lanes z480 = z209 * z417 + z206 * z436 - z445;
    bicycle_put(carried + 75 * BICYCLE_LANES, z480);
    const bicycle_lanes z481 = r_R * (z11 * z480) - c_steer * z461;
    bicycle_put(carried + 76 * BICYCLE_LANES, z481);
    const double z9 = kept[45];
    const double z27 = kept[63];
    const double z31 = kept[67];
    const bicycle_lanes z482 = z330 * z429 + z9 * z446 + z27 * z448 - z31 * z455 + roll_dot * z479 + c_roll *
        z481;
    bicycle_put(carried + 77 * BICYCLE_LANES, z482);
    const double z366 = kept[311];
    const double z370 = kept[315];
    const double z374 = kept[319];
    const double z376 = kept[321];
    const bicycle_lanes z483 = z374 * z397 - z376 * z398 - z366 * z426 + z370 * z427 + k37 * z464 + k28 *
        (z331 * z428 - z208 * z398);
    const double z210 = kept[219];
    const double z211 = kept[220];
    const double z339 = kept[290];
    const bicycle_lanes z484 = z483 + k27 * (z208 * z397 - z337 * z428) + z339 * z420 - z210 * z417 - z211 *
        z421;
    const double w3_steer = kept[296];
    const double z350 = kept[297];
    const bicycle_lanes z485 = z350 * z409 + w3_steer * z410;
    const double z351 = kept[298];
    const double z352 = kept[299];
    const double z356 = kept[301];
    const double z360 = kept[305];
    const double z362 = kept[307];
    const bicycle_lanes z486 = z360 * z400 + z362 * z405 + z351 * z409 + z352 * z410 - k56 * z485 + k45 *
        (z350 * z411 + z356 * z405);
    const bicycle_lanes z487 = F_yy * z485;
    bicycle_put(carried + 78 * BICYCLE_LANES, z487);
    const bicycle_lanes z488 = z486 + k42 * (z356 * z400 - w3_steer * z411) - z487;
    bicycle_put(carried + 79 * BICYCLE_LANES, z488);
    const double z273 = kept[225];
    const double z278 = kept[230];
    const bicycle_lanes z489 = z484 + z273 * z406 - z278 * z412 - k10 * (z331 * z431 - z208 * z420) + c_steer
        * z488;
    const bicycle_lanes z490 = z350 * z399 - z356 * z410;
    const bicycle_lanes z491 = z356 * z409 + w3_steer * z399;
    const double z357 = kept[302];
    const double z359 = kept[304];
    const bicycle_lanes z492 = z359 * z400 + z362 * z411 + z357 * z409 - z352 * z399 - k53 * z490 + k52 *
        z491;
    const bicycle_lanes z493 = z350 * z400 + w3_steer * z405;
    const bicycle_lanes z494 = z492 + k42 * z493;
    bicycle_put(carried + 80 * BICYCLE_LANES, z494);
    const bicycle_lanes z495 = z489 + s_steer * z494 + z468;
    bicycle_put(carried + 81 * BICYCLE_LANES, z495);
    const double z305 = kept[256];
    const double z313 = kept[264];
    const double z321 = kept[272];
    const bicycle_lanes z496 = z313 * z443 - z305 * z441 - z321 * z436 + s1 * z478 - c1 * z482 - z495;
    bicycle_put(carried + 82 * BICYCLE_LANES, z496);
    const bicycle_lanes z497 = z39 * z496;
    bicycle_put(carried + 83 * BICYCLE_LANES, z497);
    const bicycle_lanes z498 = z14 * z470 + z13 * z497;
    bicycle_put(carried + 84 * BICYCLE_LANES, z498);
    const bicycle_lanes z499 = z331 * z396 - z208 * z427;
    const bicycle_lanes z500 = z208 * z426 + z337 * z396;
    const double z365 = kept[310];
    const double z373 = kept[318];
    const bicycle_lanes z501 = z373 * z397 + z376 * z428 - z365 * z426 - z370 * z396 - k35 * z499 - k34 *
        z500;
    const bicycle_lanes z502 = z331 * z397 - z337 * z398;
    const double v2_x_2 = kept[288];
    const double z340 = kept[291];
    const bicycle_lanes z503 = z501 + k27 * z502 - z340 * z401 - z339 * z431 + v2_x_2 * z417 + z211 * z465 -
        z278 * z406;
    const bicycle_lanes z504 = z503 - z273 * z412 + s_steer * z488 - c_steer * z494;
    bicycle_put(carried + 85 * BICYCLE_LANES, z504);
    const bicycle_lanes z505 = z360 * z411 - z359 * z405 - z351 * z399 - z357 * z410 + k57 * z490 - k53 *
        z491;
    const bicycle_lanes z506 = z505 - k45 * z493;
    bicycle_put(carried + 86 * BICYCLE_LANES, z506);
    const bicycle_lanes z507 = z374 * z428 + z373 * z398 + z366 * z396 + z365 * z427 - k38 * z499 - k35 *
        z500;
    const bicycle_lanes z508 = z507 - k28 * z502 - z340 * z420 + z210 * z465 - v2_x_2 * z421 + k10 * (z331 *
        z401 - z337 * z420);
    const bicycle_lanes z509 = z506 + z508;
    bicycle_put(carried + 87 * BICYCLE_LANES, z509);
    const double z275 = kept[227];
    const double z279 = kept[231];
    const bicycle_lanes z510 = z279 * z429 - z275 * z432 - s1 * z504 - c1 * z509;
    bicycle_put(carried + 88 * BICYCLE_LANES, z510);
    const double z274 = kept[226];
    const double z277 = kept[229];
    const double z306 = kept[257];
    const double z314 = kept[265];
    const double z322 = kept[273];
    const bicycle_lanes z511 = z274 * z433 - z277 * z423 - z314 * z443 + z306 * z441 + z322 * z436 + c_roll *
        z510;
    const bicycle_lanes z512 = z511 - e2z * z495;
    bicycle_put(carried + 89 * BICYCLE_LANES, z512);
    const bicycle_lanes z513 = z39 * z512;
    bicycle_put(carried + 90 * BICYCLE_LANES, z513);
    const bicycle_lanes z514 = z15 * z470 - z13 * z513;
    bicycle_put(carried + 91 * BICYCLE_LANES, z514);
    const bicycle_lanes z515 = z15 * z497 + z14 * z513;
    bicycle_put(carried + 92 * BICYCLE_LANES, z515);
    const bicycle_lanes z516 = z30 * z498 + z23 * z514 - z25 * z515;
    bicycle_put(carried + 93 * BICYCLE_LANES, z516);
    const bicycle_lanes z517 = z34 * z498 - z24 * z514 + z18 * z515;
    bicycle_put(carried + 94 * BICYCLE_LANES, z517);
    const bicycle_lanes z518 = z278 * z443 + z273 * z441 + s_steer * z516 - c_steer * z517;
    bicycle_put(carried + 95 * BICYCLE_LANES, z518);
    const double z294 = kept[246];
    const bicycle_lanes z519 = z294 * z463 + z11 * z518;
    bicycle_put(carried + 96 * BICYCLE_LANES, z519);
    const bicycle_lanes z520 = roll_dot * z465;
    bicycle_put(carried + 97 * BICYCLE_LANES, z520);
    const double z12 = kept[48];
    const double z16 = kept[52];
    const double z43 = kept[79];
    const double z186 = kept[194];
    const bicycle_lanes z521 = z43 * z520 + z186 * z463 - z12 * z480 + z16 * z476;
    bicycle_put(carried + 98 * BICYCLE_LANES, z521);
    const double z184 = kept[192];
    const bicycle_lanes z522 = z184 * z521;
    bicycle_put(carried + 99 * BICYCLE_LANES, z522);
    const bicycle_lanes z523 = z11 * z522;
    bicycle_put(carried + 100 * BICYCLE_LANES, z523);
    const double z303 = kept[254];
    const double z312 = kept[263];
    const double z320 = kept[271];
    const double z328 = kept[279];
    const bicycle_lanes z524 = z328 * z433 - z320 * z437 - z303 * z442 + z312 * z444 - z279 * z481 + z275 *
        z477;
    bicycle_put(carried + 101 * BICYCLE_LANES, z524);
    const double z389 = kept[326];
    const bicycle_lanes z525 = z389 * z393;
    bicycle_put(carried + 102 * BICYCLE_LANES, z525);
    const bicycle_lanes z526 = z133 * z525;
    const bicycle_lanes z527 = z145 * z525;
    const bicycle_lanes z528 = z143 * z525;
    const double z146 = kept[171];
    const double z156 = kept[181];
    const double z369 = kept[314];
    const bicycle_lanes z529 = z393 * z369 - z146 * z525 - z156 * z525 - k57 * z526 + k53 * z527 + k45 * z528;
    const bicycle_lanes z530 = z144 * z525;
    const double z390 = kept[327];
    const bicycle_lanes z531 = z390 * z393 - z389 * z394;
    bicycle_put(carried + 103 * BICYCLE_LANES, z531);
    const double z391 = kept[328];
    const bicycle_lanes z532 = z391 * z393 - z389 * z395;
    bicycle_put(carried + 104 * BICYCLE_LANES, z532);
    const double z66 = kept[102];
    const double z76 = kept[112];
    const double z104 = kept[136];
    const double z114 = kept[146];
    const bicycle_lanes z533 = z529 - k38 * z526 - k35 * z530 - z104 * z531 + z114 * z531 - z66 * z532 - z76
        * z532;
    const double z112 = kept[144];
    const double z154 = kept[179];
    const double z363 = kept[308];
    const bicycle_lanes z534 = z363 * z393 + z154 * z525 + k45 * z526 - k42 * z527 - k40 * z528 + z112 * z531;
    const double z74 = kept[110];
    const bicycle_lanes z535 = z534 + z74 * z532;
    bicycle_put(carried + 105 * BICYCLE_LANES, z535);
    const bicycle_lanes z536 = z147 * z525;
    bicycle_put(carried + 106 * BICYCLE_LANES, z536);
    const bicycle_lanes z537 = z148 * z525;
    const double z75 = kept[111];
    const double z113 = kept[145];
    const double z155 = kept[180];
    const double z364 = kept[309];
    const bicycle_lanes z538 = z364 * z393 + z155 * z525 + k42 * z536 + k40 * z537 - z113 * z531 - z75 * z532;
    bicycle_put(carried + 107 * BICYCLE_LANES, z538);
    const bicycle_lanes z539 = z533 + k10 * (c_steer * z535 + s_steer * z538);
    bicycle_put(carried + 108 * BICYCLE_LANES, z539);
    const double z78 = kept[114];
    const double z116 = kept[148];
    const double z158 = kept[183];
    const double z372 = kept[317];
    const bicycle_lanes z540 = z372 * z393 + z158 * z525 + k35 * z526 + k34 * z530 - z116 * z531 + z78 * z532;
    const bicycle_lanes z541 = F_yy * z531;
    const bicycle_lanes z542 = F_yy * z532;
    bicycle_put(carried + 109 * BICYCLE_LANES, z542);
    const bicycle_lanes z543 = z150 * z525;
    bicycle_put(carried + 110 * BICYCLE_LANES, z543);
    const double z109 = kept[141];
    const double z151 = kept[176];
    const double z353 = kept[300];
    const bicycle_lanes z544 = z353 * z393 + z151 * z525 + k56 * z536 - k45 * z543 + k42 * z537 - z109 * z531;
    const double z71 = kept[107];
    const double z334 = kept[285];
    const bicycle_lanes z545 = z334 * z402 + 2.0 * (z163 * (F_yy * z525)) + z105 * z541 + z67 * z542 - (z544
        - z71 * z532);
    bicycle_put(carried + 111 * BICYCLE_LANES, z545);
    const double z110 = kept[142];
    const double z152 = kept[177];
    const double z358 = kept[303];
    const bicycle_lanes z546 = z358 * z393 + z152 * z525 + k53 * z526 - k52 * z527 - k42 * z528 + z110 * z531;
    const double z72 = kept[108];
    const bicycle_lanes z547 = z546 + z72 * z532;
    bicycle_put(carried + 112 * BICYCLE_LANES, z547);
    const bicycle_lanes z548 = z540 - s_steer * z545 + c_steer * z547;
    bicycle_put(carried + 113 * BICYCLE_LANES, z548);
    const bicycle_lanes z549 = c1 * z539 - s1 * z548;
    bicycle_put(carried + 114 * BICYCLE_LANES, z549);
    const bicycle_lanes z550 = z390 * z394;
    bicycle_put(carried + 115 * BICYCLE_LANES, z550);
    const bicycle_lanes z551 = z133 * z531;
    const bicycle_lanes z552 = z551 - z91 * z550;
    const bicycle_lanes z553 = z145 * z531 + z103 * z550;
    const bicycle_lanes z554 = z143 * z531 + z101 * z550;
    const bicycle_lanes z555 = z391 * z394 + z390 * z395;
    bicycle_put(carried + 116 * BICYCLE_LANES, z555);
    const double z368 = kept[313];
    const bicycle_lanes z556 = z368 * z394 - z104 * z550 + k57 * z552 - k53 * z553 - k45 * z554 - z66 * z555;
    const bicycle_lanes z557 = z551 + z90 * z550;
    const bicycle_lanes z558 = z144 * z531 + z102 * z550;
    const bicycle_lanes z559 = z363 * z394 + z112 * z550 - k45 * z552 + k42 * z553 + k40 * z554 + z74 * z555;
    bicycle_put(carried + 117 * BICYCLE_LANES, z559);
    const bicycle_lanes z560 = z147 * z531 + z105 * z550;
    bicycle_put(carried + 118 * BICYCLE_LANES, z560);
    const bicycle_lanes z561 = z148 * z531 + z106 * z550;
    const bicycle_lanes z562 = z364 * z394 - z113 * z550 - k42 * z560 - k40 * z561 - z75 * z555;
    bicycle_put(carried + 119 * BICYCLE_LANES, z562);
    const double z367 = kept[312];
    const bicycle_lanes z563 = z367 * z394 + z114 * z550 + k38 * z557 + k35 * z558 - z76 * z555 + k10 *
        (c_steer * z559 + s_steer * z562);
    const bicycle_lanes z564 = z556 + z563;
    bicycle_put(carried + 120 * BICYCLE_LANES, z564);
    const bicycle_lanes z565 = z334 * z403 - z353 * z394 - z163 * z541 + 2.0 * (z105 * (F_yy * z550)) + z109
        * z550;
    const bicycle_lanes z566 = z150 * z531 + z108 * z550;
    bicycle_put(carried + 121 * BICYCLE_LANES, z566);
    const bicycle_lanes z567 = F_yy * z555;
    bicycle_put(carried + 122 * BICYCLE_LANES, z567);
    const bicycle_lanes z568 = z565 + k56 * z560 - k45 * z566 + k42 * z561 + z67 * z567 + z71 * z555;
    bicycle_put(carried + 123 * BICYCLE_LANES, z568);
    const bicycle_lanes z569 = z372 * z394 - z116 * z550 - k35 * z557 - k34 * z558 + z78 * z555 - s_steer *
        z568;
    const bicycle_lanes z570 = z358 * z394 + z110 * z550 - k53 * z552 + k52 * z553 + k42 * z554 + z72 * z555;
    bicycle_put(carried + 124 * BICYCLE_LANES, z570);
    const bicycle_lanes z571 = z569 + c_steer * z570;
    bicycle_put(carried + 125 * BICYCLE_LANES, z571);
    const bicycle_lanes z572 = c1 * z564 - s1 * z571;
    bicycle_put(carried + 126 * BICYCLE_LANES, z572);
    const bicycle_lanes z573 = z391 * z395;
    bicycle_put(carried + 127 * BICYCLE_LANES, z573);
}

BICYCLE_SLOW static void bicycle_jacobian_sweep2_part2(double t, const double *y, const double *p,
    const double *kept, const double *seed, double *carried, double *slope)
{
    (void)seed;
    (void)t;
    const double z133 = kept[160];
    const bicycle_lanes z532 = bicycle_get(carried + 104 * BICYCLE_LANES);
    const bicycle_lanes z574 = z133 * z532;
    const double z53 = kept[89];
    const bicycle_lanes z573 = bicycle_get(carried + 127 * BICYCLE_LANES);
    const bicycle_lanes z575 = z53 * z573;
    const double z91 = kept[125];
    const bicycle_lanes z555 = bicycle_get(carried + 116 * BICYCLE_LANES);
    const bicycle_lanes z576 = z574 - z91 * z555 - z575;
    const double z65 = kept[101];
    const double z103 = kept[135];
    const double z145 = kept[170];
    const bicycle_lanes z577 = z145 * z532 + z103 * z555 + z65 * z573;
    const double z63 = kept[99];
    const double z101 = kept[133];
    const double z143 = kept[168];
    const bicycle_lanes z578 = z143 * z532 + z101 * z555 + z63 * z573;
    const double k45 = kept[23];
    const double k53 = kept[25];
    const double k57 = kept[27];
    const double z66 = kept[102];
    const double z76 = kept[112];
    const double z369 = kept[314];
    const bicycle_lanes z395 = bicycle_get(carried + 2 * BICYCLE_LANES);
    const bicycle_lanes z579 = z395 * z369 - z66 * z573 - z76 * z573 + k57 * z576 - k53 * z577 - k45 * z578;
    const double z90 = kept[124];
    const bicycle_lanes z580 = z574 + z90 * z555 - z575;
    const double z64 = kept[100];
    const double z102 = kept[134];
    const double z144 = kept[169];
    const bicycle_lanes z581 = z144 * z532 + z102 * z555 + z64 * z573;
    const double z44 = kept[80];
    const bicycle_lanes z582 = z44 * z573;
    const double k40 = kept[21];
    const double k42 = kept[22];
    const double z74 = kept[110];
    const double z363 = kept[308];
    const bicycle_lanes z583 = z363 * z395 + z74 * z573 - k45 * z576 + k42 * z577 + k40 * z578;
    const double z67 = kept[103];
    const double z105 = kept[137];
    const double z147 = kept[172];
    const bicycle_lanes z584 = z147 * z532 + z105 * z555 + z67 * z573;
    const double z68 = kept[104];
    const double z106 = kept[138];
    const double z148 = kept[173];
    const bicycle_lanes z585 = z148 * z532 + z106 * z555 + z68 * z573;
    const double z75 = kept[111];
    const double z364 = kept[309];
    const bicycle_lanes z586 = z364 * z395 - z75 * z573 - k42 * z584 - k40 * z585;
    const double s_steer = kept[4];
    const double c_steer = kept[5];
    const bicycle_lanes z587 = c_steer * z583 + s_steer * z586;
    const double k10 = kept[9];
    const double k28 = kept[16];
    const double k35 = kept[18];
    const double k38 = kept[20];
    const bicycle_lanes z588 = z579 + k38 * z580 + k35 * z581 + k28 * z582 + k10 * z587;
    const double F_yy = p[25]; /* front wheel, about the axle [kg*m^2] */
    const double z163 = kept[186];
    const double z334 = kept[285];
    const double z353 = kept[300];
    const bicycle_lanes z404 = bicycle_get(carried + 8 * BICYCLE_LANES);
    const bicycle_lanes z542 = bicycle_get(carried + 109 * BICYCLE_LANES);
    const bicycle_lanes z567 = bicycle_get(carried + 122 * BICYCLE_LANES);
    const bicycle_lanes z589 = z334 * z404 - z353 * z395 - z163 * z542 + z105 * z567 + 2.0 * (z67 * (F_yy *
        z573));
    const double z70 = kept[106];
    const double z108 = kept[140];
    const double z150 = kept[175];
    const bicycle_lanes z590 = z150 * z532 + z108 * z555 + z70 * z573;
    const double k56 = kept[26];
    const double z71 = kept[107];
    const bicycle_lanes z591 = z589 + z71 * z573 + k56 * z584 - k45 * z590 + k42 * z585;
    const double k27 = kept[15];
    const double k34 = kept[17];
    const double z78 = kept[114];
    const double z372 = kept[317];
    const bicycle_lanes z592 = z372 * z395 + z78 * z573 - k35 * z580 - k34 * z581 + k27 * z582 - s_steer *
        z591;
    const double k52 = kept[24];
    const double z72 = kept[108];
    const double z358 = kept[303];
    const bicycle_lanes z593 = z358 * z395 + z72 * z573 - k53 * z576 + k52 * z577 + k42 * z578;
    const bicycle_lanes z594 = z592 + c_steer * z593;
    const double s1 = kept[2];
    const double c1 = kept[3];
    const bicycle_lanes z595 = c1 * z588 - s1 * z594;
    const double z51 = kept[87];
    const double z88 = kept[122];
    const double z131 = kept[158];
    const double z205 = kept[214];
    const double z293 = kept[245];
    const double z379 = kept[324];
    const bicycle_lanes z510 = bicycle_get(carried + 88 * BICYCLE_LANES);
    const bicycle_lanes z521 = bicycle_get(carried + 98 * BICYCLE_LANES);
    const bicycle_lanes z524 = bicycle_get(carried + 101 * BICYCLE_LANES);
    const bicycle_lanes z549 = bicycle_get(carried + 114 * BICYCLE_LANES);
    const bicycle_lanes z572 = bicycle_get(carried + 126 * BICYCLE_LANES);
    const bicycle_lanes z596 = 2.0 * (z293 * z521 * z379) + (z524 - z205 * z510 + z131 * z549 + z88 * z572 -
        z51 * z595);
    const double z331 = kept[282];
    const double z337 = kept[289];
    const bicycle_lanes z417 = bicycle_get(carried + 18 * BICYCLE_LANES);
    const bicycle_lanes z421 = bicycle_get(carried + 21 * BICYCLE_LANES);
    const bicycle_lanes z597 = z331 * z417 + z337 * z421;
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double k26 = kept[14];
    const double z81 = kept[117];
    const double z378 = kept[323];
    const bicycle_lanes z598 = roll_dot * z597 - (z378 * z395 - z81 * z573 + k28 * z580 - k27 * z581 + k26 *
        z582);
    const double R_yy = p[7]; /* rear wheel, about the axle [kg*m^2] */
    const bicycle_lanes z599 = R_yy * z532;
    const bicycle_lanes z600 = R_yy * z555;
    const double z73 = kept[109];
    const double z361 = kept[306];
    const bicycle_lanes z601 = z361 * z395 - z73 * z573 + k45 * z584 - k40 * z590;
    const double z60 = kept[96];
    const double z98 = kept[130];
    const double z140 = kept[165];
    const bicycle_lanes z602 = z140 * z532 + z98 * z555 + z60 * z573;
    const double z69 = kept[105];
    const double z107 = kept[139];
    const double z149 = kept[174];
    const bicycle_lanes z603 = z149 * z532 + z107 * z555 + z69 * z573;
    const double z79 = kept[115];
    const double z375 = kept[320];
    const bicycle_lanes z604 = z601 + (z375 * z395 - z79 * z573 - k28 * z602 - k26 * z603);
    const double z13 = kept[49];
    const double z61 = kept[97];
    const double z99 = kept[131];
    const double z141 = kept[166];
    const double z336 = kept[287];
    const bicycle_lanes z416 = bicycle_get(carried + 17 * BICYCLE_LANES);
    const bicycle_lanes z605 = z336 * z416 - z141 * z599 - z99 * z600 - 2.0 * (z61 * (R_yy * z573)) + z13 *
        z604;
    const double z62 = kept[98];
    const double z100 = kept[132];
    const double z142 = kept[167];
    const bicycle_lanes z606 = z142 * z532 + z100 * z555 + z62 * z573;
    const double z80 = kept[116];
    const double z377 = kept[322];
    const bicycle_lanes z607 = z377 * z395 + z80 * z573 + k27 * z602 + k26 * z606 + s_steer * z583 - c_steer
        * z586;
    const double z17 = kept[53];
    const bicycle_lanes z608 = z605 - z17 * z607;
    const double z39 = kept[75];
    const bicycle_lanes z609 = z39 * z608;
    const double k37 = kept[19];
    const double z77 = kept[113];
    const double z371 = kept[316];
    const bicycle_lanes z610 = z371 * z395 + z77 * z573 + k37 * z602 + k28 * z603 + k27 * z606 + c_steer *
        z591;
    const bicycle_lanes z611 = z610 + s_steer * z593 - k10 * z601 + z608;
    const bicycle_lanes z612 = z39 * z611;
    const double z14 = kept[50];
    const bicycle_lanes z613 = z14 * z609 + z13 * z612;
    const double c_roll = kept[0];
    const double e2z = kept[1];
    const bicycle_lanes z614 = c_roll * z595 + e2z * z611;
    const bicycle_lanes z615 = z39 * z614;
    const double z15 = kept[51];
    const bicycle_lanes z616 = z15 * z609 - z13 * z615;
    const bicycle_lanes z617 = z15 * z612 + z14 * z615;
    const double z23 = kept[59];
    const double z25 = kept[61];
    const double z30 = kept[66];
    const bicycle_lanes z618 = z30 * z613 + z23 * z616 - z25 * z617;
    const double z18 = kept[54];
    const double z24 = kept[60];
    const double z34 = kept[70];
    const bicycle_lanes z619 = z34 * z613 - z24 * z616 + z18 * z617;
    const bicycle_lanes z620 = s_steer * z618 - c_steer * z619;
    const bicycle_lanes z621 = z598 - z587 + z620;
    const bicycle_lanes z531 = bicycle_get(carried + 103 * BICYCLE_LANES);
    const bicycle_lanes z622 = R_yy * z531;
    const double z111 = kept[143];
    const double z153 = kept[178];
    const bicycle_lanes z393 = bicycle_get(carried + 0 * BICYCLE_LANES);
    const bicycle_lanes z525 = bicycle_get(carried + 102 * BICYCLE_LANES);
    const bicycle_lanes z536 = bicycle_get(carried + 106 * BICYCLE_LANES);
    const bicycle_lanes z543 = bicycle_get(carried + 110 * BICYCLE_LANES);
    const bicycle_lanes z623 = z361 * z393 + z153 * z525 - k45 * z536 + k40 * z543 - z111 * z531 - z73 * z532;
    const bicycle_lanes z624 = z140 * z525;
    const bicycle_lanes z625 = z149 * z525;
    const double z118 = kept[150];
    const double z160 = kept[185];
    const bicycle_lanes z626 = z375 * z393 + z160 * z525 + k28 * z624 + k26 * z625 - z118 * z531 - z79 * z532;
    const bicycle_lanes z627 = z623 + z626;
    const bicycle_lanes z414 = bicycle_get(carried + 15 * BICYCLE_LANES);
    const bicycle_lanes z628 = z336 * z414 + 2.0 * (z141 * (R_yy * z525)) - z99 * z622 - z61 * z599 + z13 *
        z627;
    const bicycle_lanes z629 = z142 * z525;
    const double z117 = kept[149];
    const double z159 = kept[184];
    const bicycle_lanes z630 = z377 * z393 - z159 * z525 - k27 * z624 - k26 * z629 + z117 * z531 + z80 * z532;
    const bicycle_lanes z535 = bicycle_get(carried + 105 * BICYCLE_LANES);
    const bicycle_lanes z538 = bicycle_get(carried + 107 * BICYCLE_LANES);
    const bicycle_lanes z631 = z630 + s_steer * z535 - c_steer * z538;
    const bicycle_lanes z632 = z628 - z17 * z631;
    const bicycle_lanes z633 = z39 * z632;
    const double z115 = kept[147];
    const double z157 = kept[182];
    const bicycle_lanes z634 = z371 * z393 - z157 * z525 - k37 * z624 - k28 * z625 - k27 * z629 + z115 * z531;
    const bicycle_lanes z545 = bicycle_get(carried + 111 * BICYCLE_LANES);
    const bicycle_lanes z547 = bicycle_get(carried + 112 * BICYCLE_LANES);
    const bicycle_lanes z635 = z634 + z77 * z532 + c_steer * z545 + s_steer * z547 - k10 * z623 + z632;
    const bicycle_lanes z636 = z39 * z635;
    const double z128 = kept[155];
    const double z129 = kept[156];
    const double z199 = kept[208];
    const double z200 = kept[209];
    const double z316 = kept[267];
    const double z326 = kept[277];
    const bicycle_lanes z424 = bicycle_get(carried + 24 * BICYCLE_LANES);
    const bicycle_lanes z425 = bicycle_get(carried + 25 * BICYCLE_LANES);
    const bicycle_lanes z470 = bicycle_get(carried + 65 * BICYCLE_LANES);
    const bicycle_lanes z497 = bicycle_get(carried + 83 * BICYCLE_LANES);
    const bicycle_lanes z637 = z326 * z424 + z316 * z425 + z200 * z470 - z199 * z497 + z129 * z633 - z128 *
        z636;
    const bicycle_lanes z394 = bicycle_get(carried + 1 * BICYCLE_LANES);
    const bicycle_lanes z550 = bicycle_get(carried + 115 * BICYCLE_LANES);
    const bicycle_lanes z560 = bicycle_get(carried + 118 * BICYCLE_LANES);
    const bicycle_lanes z566 = bicycle_get(carried + 121 * BICYCLE_LANES);
    const bicycle_lanes z638 = z361 * z394 - z111 * z550 + k45 * z560 - k40 * z566 - z73 * z555;
    const bicycle_lanes z639 = z140 * z531 + z98 * z550;
    const bicycle_lanes z640 = z149 * z531 + z107 * z550;
    const bicycle_lanes z641 = z638 + (z375 * z394 - z118 * z550 - k28 * z639 - k26 * z640 - z79 * z555);
    const bicycle_lanes z415 = bicycle_get(carried + 16 * BICYCLE_LANES);
    const bicycle_lanes z642 = z336 * z415 - z141 * z622 - 2.0 * (z99 * (R_yy * z550)) - z61 * z600 + z13 *
        z641;
    const bicycle_lanes z643 = z142 * z531 + z100 * z550;
    const bicycle_lanes z559 = bicycle_get(carried + 117 * BICYCLE_LANES);
    const bicycle_lanes z644 = z377 * z394 + z117 * z550 + k27 * z639 + k26 * z643 + z80 * z555 + s_steer *
        z559;
    const bicycle_lanes z562 = bicycle_get(carried + 119 * BICYCLE_LANES);
    const bicycle_lanes z645 = z644 - c_steer * z562;
    const bicycle_lanes z646 = z642 - z17 * z645;
    const bicycle_lanes z647 = z39 * z646;
    const bicycle_lanes z648 = z371 * z394 + z115 * z550 + k37 * z639 + k28 * z640 + k27 * z643 + z77 * z555;
    const bicycle_lanes z568 = bicycle_get(carried + 123 * BICYCLE_LANES);
    const bicycle_lanes z570 = bicycle_get(carried + 124 * BICYCLE_LANES);
    const bicycle_lanes z649 = z648 + c_steer * z568 + s_steer * z570 - k10 * z638 + z646;
    const bicycle_lanes z650 = z39 * z649;
    const double z201 = kept[210];
    const double z203 = kept[212];
    const double z204 = kept[213];
    const double z325 = kept[276];
    const double z327 = kept[278];
    const double z335 = kept[286];
    const bicycle_lanes z422 = bicycle_get(carried + 22 * BICYCLE_LANES);
    const bicycle_lanes z423 = bicycle_get(carried + 23 * BICYCLE_LANES);
    const bicycle_lanes z434 = bicycle_get(carried + 32 * BICYCLE_LANES);
    const bicycle_lanes z469 = bicycle_get(carried + 64 * BICYCLE_LANES);
    const bicycle_lanes z496 = bicycle_get(carried + 82 * BICYCLE_LANES);
    const bicycle_lanes z512 = bicycle_get(carried + 89 * BICYCLE_LANES);
    const bicycle_lanes z651 = z335 * z422 + z325 * z423 - z327 * z434 + z204 * z469 - z203 * z496 + z201 *
        z512;
    const bicycle_lanes z652 = c_roll * z549 + e2z * z635;
    const bicycle_lanes z653 = c_roll * z572 + e2z * z649;
    const double z87 = kept[121];
    const double z94 = kept[128];
    const double z96 = kept[129];
    const double z130 = kept[157];
    const double z136 = kept[163];
    const double z138 = kept[164];
    const bicycle_lanes z654 = z651 + z136 * z632 - z138 * z635 - z130 * z652 + z94 * z646 - z96 * z649 - z87
        * z653;
    const double z50 = kept[86];
    const double z56 = kept[92];
    const double z58 = kept[94];
    const double z188 = kept[197];
    const bicycle_lanes z655 = z188 * (z654 + z56 * z608 - z58 * z611 + z50 * z614);
    const double z26 = kept[62];
    const double z48 = kept[84];
    const double z49 = kept[85];
    const double z85 = kept[119];
    const double z86 = kept[120];
    const bicycle_lanes z656 = z637 + z86 * z647 - z85 * z650 + z49 * z609 - z48 * z612 - z26 * z655;
    const bicycle_lanes z657 = z14 * z633 + z13 * z636;
    const double z7 = kept[43];
    const double z41 = kept[77];
    const double z196 = kept[205];
    const double z323 = kept[274];
    const bicycle_lanes z658 = z323 * z424 + z196 * z470 - z7 * z633 + z41 * z609 - z13 * z655;
    const bicycle_lanes z659 = z323 * z425 - z196 * z497 + z7 * z636 - z41 * z612 - z14 * z655;
    const double z20 = kept[56];
    const double z47 = kept[83];
    const double z198 = kept[207];
    const double z315 = kept[266];
    const bicycle_lanes z438 = bicycle_get(carried + 36 * BICYCLE_LANES);
    const bicycle_lanes z498 = bicycle_get(carried + 84 * BICYCLE_LANES);
    const bicycle_lanes z660 = z315 * z438 + z198 * z498 + z20 * z657 - z47 * z613 + z24 * z658 + z18 * z659;
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double z10 = kept[46];
    const double z11 = kept[47];
    const double z29 = kept[65];
    const double z274 = kept[226];
    const double z294 = kept[246];
    const bicycle_lanes z520 = bicycle_get(carried + 97 * BICYCLE_LANES);
    const bicycle_lanes z523 = bicycle_get(carried + 100 * BICYCLE_LANES);
    const bicycle_lanes z661 = z274 * z523 - z596 + r_R * (z294 * z520 + z11 * z621) + z10 * z656 + z29 *
        z660;
    const bicycle_lanes z662 = z14 * z647 + z13 * z650;
    const double z8 = kept[44];
    const double z46 = kept[82];
    const double z197 = kept[206];
    const double z307 = kept[258];
    const bicycle_lanes z663 = z307 * z438 + z197 * z498 + z8 * z662 + z46 * z613 - z23 * z658 - z25 * z659;
    const double k66 = kept[33];
    const double k69 = kept[36];
    const double k70 = kept[37];
    const bicycle_lanes z409 = bicycle_get(carried + 11 * BICYCLE_LANES);
    const bicycle_lanes z410 = bicycle_get(carried + 12 * BICYCLE_LANES);
    const bicycle_lanes z411 = bicycle_get(carried + 13 * BICYCLE_LANES);
    const bicycle_lanes z664 = k70 * z409 + k69 * z410 + k66 * z411;
    const double z202 = kept[211];
    const double z209 = kept[218];
    const double z324 = kept[275];
    const bicycle_lanes z435 = bicycle_get(carried + 33 * BICYCLE_LANES);
    const bicycle_lanes z466 = bicycle_get(carried + 62 * BICYCLE_LANES);
    const bicycle_lanes z513 = bicycle_get(carried + 90 * BICYCLE_LANES);
    const bicycle_lanes z665 = z336 * z417 + z324 * z425 - z326 * z435 - z209 * z466 - z202 * z497 + z200 *
        z513;
    const bicycle_lanes z666 = z39 * z652;
    const bicycle_lanes z667 = z39 * z653;
    const double z93 = kept[127];
    const double z135 = kept[162];
    const bicycle_lanes z668 = z665 - z141 * z627 - z135 * z636 + z129 * z666 - z99 * z641 + z93 * z650 + z86
        * z667;
    const double z277 = kept[229];
    const bicycle_lanes z437 = bicycle_get(carried + 35 * BICYCLE_LANES);
    const bicycle_lanes z669 = z324 * z424 + z316 * z435 + z277 * z437 + z202 * z470 - z199 * z513 + z135 *
        z633;
    const double z35 = kept[71];
    const double z55 = kept[91];
    const bicycle_lanes z670 = z669 - z128 * z666 - z93 * z647 - z85 * z667 - z55 * z609 - z48 * z615 - z35 *
        z655;
    const bicycle_lanes z671 = z670 - e2z * z656;
    const double z36 = kept[72];
    const bicycle_lanes z672 = z668 - z61 * z604 + z55 * z612 + z49 * z615 + z36 * z655 + z671;
    const double k61 = kept[28];
    const double k63 = kept[30];
    const double z273 = kept[225];
    const bicycle_lanes z396 = bicycle_get(carried + 3 * BICYCLE_LANES);
    const bicycle_lanes z398 = bicycle_get(carried + 5 * BICYCLE_LANES);
    const bicycle_lanes z461 = bicycle_get(carried + 58 * BICYCLE_LANES);
    const bicycle_lanes z480 = bicycle_get(carried + 75 * BICYCLE_LANES);
    const bicycle_lanes z673 = z273 * z461 + (s_steer * z664 + (k63 * z396 + k61 * z398 + r_R * (z294 * z480
        + z11 * z672)));
    const bicycle_lanes z674 = z36 * z470 - z35 * z497 + z26 * z513;
    const double z191 = kept[200];
    const double z193 = kept[202];
    const double z287 = kept[239];
    const double z308 = kept[259];
    const bicycle_lanes z436 = bicycle_get(carried + 34 * BICYCLE_LANES);
    const bicycle_lanes z441 = bicycle_get(carried + 39 * BICYCLE_LANES);
    const bicycle_lanes z517 = bicycle_get(carried + 94 * BICYCLE_LANES);
    const bicycle_lanes z675 = z287 * z441 + z308 * z436 - z193 * z517 - z191 * z674 - z36 * z633 + z35 *
        z636;
    const bicycle_lanes z676 = z15 * z647 - z13 * z667;
    const bicycle_lanes z677 = z15 * z650 + z14 * z667;
    const bicycle_lanes z678 = z36 * z609 - z35 * z612 + z26 * z615;
    const double z40 = kept[76];
    const double z278 = kept[230];
    const bicycle_lanes z445 = bicycle_get(carried + 43 * BICYCLE_LANES);
    const bicycle_lanes z447 = bicycle_get(carried + 45 * BICYCLE_LANES);
    const bicycle_lanes z679 = z273 * z445 + z278 * z447 + z34 * z662 - z24 * z676 + z18 * z677 - z40 * z678;
    const bicycle_lanes z680 = z274 * z437 + c_roll * z656;
    const double z279 = kept[231];
    const bicycle_lanes z446 = bicycle_get(carried + 44 * BICYCLE_LANES);
    const bicycle_lanes z681 = z279 * z446 + s1 * z680;
    const bicycle_lanes z442 = bicycle_get(carried + 40 * BICYCLE_LANES);
    const bicycle_lanes z682 = z274 * z442 + c_roll * z660;
    const double z275 = kept[227];
    const bicycle_lanes z448 = bicycle_get(carried + 46 * BICYCLE_LANES);
    const bicycle_lanes z683 = z275 * z448 - c1 * z682;
    const bicycle_lanes z684 = z675 - z26 * z666 - s1 * z619 - (z679 + c_steer * z671 - s_steer * z681 +
        z683);
    const double r_F = p[22]; /* radius of the front wheel [m] */
    const double k65 = kept[32];
    const double k68 = kept[35];
    const double z5 = kept[41];
    const double z281 = kept[233];
    const double z284 = kept[236];
    const bicycle_lanes z399 = bicycle_get(carried + 6 * BICYCLE_LANES);
    const bicycle_lanes z405 = bicycle_get(carried + 9 * BICYCLE_LANES);
    const bicycle_lanes z450 = bicycle_get(carried + 48 * BICYCLE_LANES);
    const bicycle_lanes z460 = bicycle_get(carried + 57 * BICYCLE_LANES);
    const bicycle_lanes z685 = z281 * z460 + k68 * z399 + k66 * z405 + k65 * z399 - r_F * (z284 * z450 - z5 *
        z684);
    const bicycle_lanes z686 = z15 * z633 - z13 * z666;
    const double z194 = kept[203];
    const double z291 = kept[243];
    const bicycle_lanes z443 = bicycle_get(carried + 41 * BICYCLE_LANES);
    const bicycle_lanes z516 = bicycle_get(carried + 93 * BICYCLE_LANES);
    const bicycle_lanes z687 = z308 * z443 + z291 * z441 - z191 * z516 - z194 * z517 - z30 * z657 - z23 *
        z686;
    const bicycle_lanes z688 = z15 * z636 + z14 * z666;
    const bicycle_lanes z439 = bicycle_get(carried + 37 * BICYCLE_LANES);
    const bicycle_lanes z514 = bicycle_get(carried + 91 * BICYCLE_LANES);
    const bicycle_lanes z689 = z315 * z439 - z277 * z442 + z198 * z514 + z20 * z686 - z47 * z616 + z34 * z658;
    const bicycle_lanes z690 = z323 * z435 - z196 * z513 + z7 * z666 - z41 * z615 + z15 * z655;
    const bicycle_lanes z691 = z689 - z18 * z690 + e2z * z660;
    const bicycle_lanes z444 = bicycle_get(carried + 42 * BICYCLE_LANES);
    const bicycle_lanes z692 = z307 * z439 - z277 * z444 + z197 * z514 + z8 * z676 + z46 * z616 + z30 * z658;
    const bicycle_lanes z693 = z692 + z25 * z690 + e2z * z663;
    const bicycle_lanes z451 = bicycle_get(carried + 49 * BICYCLE_LANES);
    const bicycle_lanes z452 = bicycle_get(carried + 50 * BICYCLE_LANES);
    const bicycle_lanes z694 = z278 * z451 - z273 * z452 + s_steer * z691 + c_steer * z693;
    const bicycle_lanes z695 = z279 * z448 + s1 * z682;
    const bicycle_lanes z696 = z274 * z444 + c_roll * z663;
    const bicycle_lanes z455 = bicycle_get(carried + 52 * BICYCLE_LANES);
    const bicycle_lanes z697 = z279 * z455 + s1 * z696;
    const double z42 = kept[78];
    const bicycle_lanes z454 = bicycle_get(carried + 51 * BICYCLE_LANES);
    const bicycle_lanes z456 = bicycle_get(carried + 53 * BICYCLE_LANES);
    const bicycle_lanes z698 = z687 + z25 * z688 + z40 * z618 - z42 * z619 + (z694 - (z273 * z454 + z278 *
        z456 + c_steer * z695 - s_steer * z697));
    const double z6 = kept[42];
    const double z19 = kept[55];
    const double z187 = kept[195];
    const double z282 = kept[234];
    const double z285 = kept[237];
    const double z288 = kept[240];
    const bicycle_lanes z457 = bicycle_get(carried + 54 * BICYCLE_LANES);
    const bicycle_lanes z459 = bicycle_get(carried + 56 * BICYCLE_LANES);
    const bicycle_lanes z699 = z5 * (z187 * (z285 * z450 - z288 * z457 + z282 * z459 - z6 * z684 + z19 *
        z698));
    const double z283 = kept[235];
    const double z380 = kept[325];
    const bicycle_lanes z458 = bicycle_get(carried + 55 * BICYCLE_LANES);
    const bicycle_lanes z700 = z283 * z458 * z380 + 0.5 * z699;
    const double z4 = kept[40];
    const bicycle_lanes z701 = z685 + 2.0 * (z4 * z700);
    const bicycle_lanes z702 = z673 + c_steer * z701;
    const double k62 = kept[29];
    const double k64 = kept[31];
    const double k67 = kept[34];
    const double z276 = kept[228];
    const bicycle_lanes z397 = bicycle_get(carried + 4 * BICYCLE_LANES);
    const bicycle_lanes z400 = bicycle_get(carried + 7 * BICYCLE_LANES);
    const bicycle_lanes z703 = z276 * z460 + k67 * z399 - k66 * z400 - k64 * z399 - k62 * z396 - k61 * z397;
    const bicycle_lanes z467 = bicycle_get(carried + 63 * BICYCLE_LANES);
    const bicycle_lanes z474 = bicycle_get(carried + 69 * BICYCLE_LANES);
    const bicycle_lanes z475 = bicycle_get(carried + 70 * BICYCLE_LANES);
    const bicycle_lanes z704 = z336 * z421 - z209 * z467 - z278 * z474 + z273 * z475 - z141 * z631 - z99 *
        z645;
    const bicycle_lanes z440 = bicycle_get(carried + 38 * BICYCLE_LANES);
    const bicycle_lanes z515 = bicycle_get(carried + 92 * BICYCLE_LANES);
    const bicycle_lanes z705 = z315 * z440 - z198 * z515 - z20 * z688 + z47 * z617 + z34 * z659 + z24 * z690;
    const bicycle_lanes z706 = z307 * z440 - z197 * z515 - z8 * z677 - z46 * z617 + z30 * z659 - z23 * z690;
    const bicycle_lanes z707 = z704 - z61 * z607 + s_steer * z705 + z694 + c_steer * z706;
    const double z2 = kept[38];
    const bicycle_lanes z476 = bicycle_get(carried + 71 * BICYCLE_LANES);
    const bicycle_lanes z708 = z703 + r_F * (z284 * z457 + z5 * z698) - r_R * (z294 * z476 + z11 * z707) -
        2.0 * (z2 * z700);
    const double z43 = kept[79];
    const double z292 = kept[244];
    const double z295 = kept[247];
    const double z298 = kept[249];
    const double z317 = kept[268];
    const double z342 = kept[293];
    const bicycle_lanes z463 = bicycle_get(carried + 60 * BICYCLE_LANES);
    const bicycle_lanes z522 = bicycle_get(carried + 99 * BICYCLE_LANES);
    const bicycle_lanes z709 = z317 * z480 - z298 * z476 - z342 * z520 - z295 * z463 + z292 * z522 + z43 *
        z621;
    const double z12 = kept[48];
    const double z16 = kept[52];
    const double z33 = kept[69];
    const double z184 = kept[192];
    const double z185 = kept[193];
    const double z186 = kept[194];
    const bicycle_lanes z518 = bicycle_get(carried + 95 * BICYCLE_LANES);
    const bicycle_lanes z519 = bicycle_get(carried + 96 * BICYCLE_LANES);
    const bicycle_lanes z710 = z185 * z519 + (z661 - z33 * z663) - s1 * z702 - c1 * z708 - c_roll * (z11 *
        (z184 * (z186 * z518 + z709 - z12 * z672 + z16 * z707)));
    const bicycle_lanes z711 = z11 * z463;
    const bicycle_lanes z433 = bicycle_get(carried + 31 * BICYCLE_LANES);
    const bicycle_lanes z712 = z205 * z433 - r_R * (z11 * z520) + z10 * z437 + z29 * z442 - z33 * z444 - z185
        * z711;
    const bicycle_lanes z477 = bicycle_get(carried + 72 * BICYCLE_LANES);
    const bicycle_lanes z481 = bicycle_get(carried + 76 * BICYCLE_LANES);
    const bicycle_lanes z713 = z712 + c_roll * z523 + s1 * z481 + c1 * z477;
    const double z305 = kept[256];
    const double z313 = kept[264];
    const double z321 = kept[272];
    const double z328 = kept[279];
    const bicycle_lanes z426 = bicycle_get(carried + 26 * BICYCLE_LANES);
    const bicycle_lanes z495 = bicycle_get(carried + 81 * BICYCLE_LANES);
    const bicycle_lanes z714 = z328 * z423 + z321 * z437 + z305 * z442 - z313 * z444 + z205 * z495 + k62 *
        z426;
    const bicycle_lanes z427 = bicycle_get(carried + 27 * BICYCLE_LANES);
    const bicycle_lanes z428 = bicycle_get(carried + 28 * BICYCLE_LANES);
    const bicycle_lanes z715 = z714 - k63 * z427 + k61 * z428 + z131 * z635 + z88 * z649 - z51 * z611 + z14 *
        z656;
    const bicycle_lanes z716 = c_steer * z664 - (roll_dot * z713 - (z278 * z461 + (z715 - z23 * z660 - z24 *
        z663))) - s_steer * z701;
    const bicycle_lanes z462 = bicycle_get(carried + 59 * BICYCLE_LANES);
    bicycle_put(slope + 0 * BICYCLE_LANES, c_roll * z716 - e2z * (roll_dot * z462 - z710));
    const double k16 = kept[10];
    const double z289 = kept[241];
    const bicycle_lanes z717 = z289 * z441 + z20 * z517 + k16 * z517;
    const double z286 = kept[238];
    const bicycle_lanes z718 = z289 * z443 - z286 * z436 + z20 * z516 - z7 * z674;
    const double k4 = kept[8];
    const bicycle_lanes z719 = z718 + (k16 * z516 - k4 * z674);
    const bicycle_lanes z471 = bicycle_get(carried + 66 * BICYCLE_LANES);
    const bicycle_lanes z472 = bicycle_get(carried + 67 * BICYCLE_LANES);
    const bicycle_lanes z504 = bicycle_get(carried + 85 * BICYCLE_LANES);
    const bicycle_lanes z720 = z504 - z273 * z471 - z278 * z472 + c_steer * z717 - s_steer * z719;
    const double z89 = kept[123];
    const double z132 = kept[159];
    const double z207 = kept[216];
    const double z302 = kept[253];
    const double z330 = kept[281];
    const double z332 = kept[283];
    const bicycle_lanes z432 = bicycle_get(carried + 30 * BICYCLE_LANES);
    const bicycle_lanes z482 = bicycle_get(carried + 77 * BICYCLE_LANES);
    const bicycle_lanes z509 = bicycle_get(carried + 87 * BICYCLE_LANES);
    const bicycle_lanes z539 = bicycle_get(carried + 108 * BICYCLE_LANES);
    const bicycle_lanes z564 = bicycle_get(carried + 120 * BICYCLE_LANES);
    const bicycle_lanes z721 = z332 * z432 - z302 * z448 + z207 * z482 - z330 * z509 - z132 * z539 - z89 *
        z564;
    const double z21 = kept[57];
    const bicycle_lanes z722 = z21 * z619;
    const bicycle_lanes z723 = z8 * z678 - z20 * z618 - k16 * z618;
    const double z28 = kept[64];
    const double z52 = kept[88];
    const double z311 = kept[262];
    const bicycle_lanes z724 = z311 * z455 - (z594 + (z721 + z52 * z588)) - c_steer * z722 - s_steer * z723 +
        z28 * z682;
    const bicycle_lanes z725 = z286 * z441 + z7 * z517 + k4 * z517;
    const bicycle_lanes z726 = z725 + (z509 + k10 * z518);
    const double z301 = kept[252];
    const double z310 = kept[261];
    const double z319 = kept[270];
    const bicycle_lanes z429 = bicycle_get(carried + 29 * BICYCLE_LANES);
    const bicycle_lanes z478 = bicycle_get(carried + 73 * BICYCLE_LANES);
    const bicycle_lanes z727 = z332 * z429 - z319 * z446 + z301 * z448 + z310 * z455 - z207 * z478 - z330 *
        z504;
    const bicycle_lanes z548 = bicycle_get(carried + 113 * BICYCLE_LANES);
    const bicycle_lanes z571 = bicycle_get(carried + 125 * BICYCLE_LANES);
    const bicycle_lanes z728 = z727 + z132 * z548 + z89 * z571 + z588 - z52 * z594 - z7 * z619 - k4 * z619;
    const double z9 = kept[45];
    const double z27 = kept[63];
    const double z31 = kept[67];
    const bicycle_lanes z729 = z274 * z481 - (roll_dot * z726 - (z728 + z9 * z680 + z27 * z682 - z31 * z696)
        + k10 * z620);
    const double z32 = kept[68];
    const bicycle_lanes z730 = s1 * (z274 * z477 + (roll_dot * z720 - (z724 - z32 * z696)) - c_roll * z708) -
        c1 * (z729 - c_roll * z702);
    bicycle_put(slope + 1 * BICYCLE_LANES, z730);
    const double z189 = kept[198];
    const double z195 = kept[204];
    const double z208 = kept[217];
    const bicycle_lanes z406 = bicycle_get(carried + 10 * BICYCLE_LANES);
    const bicycle_lanes z412 = bicycle_get(carried + 14 * BICYCLE_LANES);
    const bicycle_lanes z449 = bicycle_get(carried + 47 * BICYCLE_LANES);
    const bicycle_lanes z731 = z331 * z412 - z208 * z406 - z195 * z441 + z189 * z471 + z8 * z445 + k10 * z449;
    const double z3 = kept[39];
    const double z22 = kept[58];
    const bicycle_lanes z732 = z731 + z22 * z452 - z21 * z454 - z17 * z475 + z3 * z461;
    const double z296 = kept[248];
    const double z329 = kept[280];
    const double z333 = kept[284];
    const double z341 = kept[292];
    const double z346 = kept[295];
    const bicycle_lanes z418 = bicycle_get(carried + 19 * BICYCLE_LANES);
    const bicycle_lanes z419 = bicycle_get(carried + 20 * BICYCLE_LANES);
    const bicycle_lanes z488 = bicycle_get(carried + 79 * BICYCLE_LANES);
    const bicycle_lanes z733 = z341 * z418 + z346 * z419 + z333 * z406 + z329 * z412 - z331 * z488 - z296 *
        z443;
    const double z290 = kept[242];
    const double z299 = kept[250];
    const double z304 = kept[255];
    const bicycle_lanes z494 = bicycle_get(carried + 80 * BICYCLE_LANES);
    const bicycle_lanes z734 = z733 + z290 * z472 + z286 * z447 - z304 * z451 + z299 * z474 - z289 * z456 -
        z208 * z494;
    const double z134 = kept[161];
    const bicycle_lanes z735 = z734 + z144 * z545 + z140 * z547 + z142 * z535 + z134 * z538 + z102 * z568 +
        z98 * z570;
    const double z54 = kept[90];
    const double z92 = kept[126];
    const bicycle_lanes z736 = z735 + z100 * z559 + z92 * z562 + z64 * z591 + z60 * z593 + z62 * z583 + z54 *
        z586;
    const double z45 = kept[81];
    const bicycle_lanes z737 = z189 * z719 - (z195 * z516 - z736) + z45 * z618 - c1 * z723 - z8 * z681 - z22
        * z691;
    const bicycle_lanes z738 = z3 * z664 + (z737 - z17 * z705 + z21 * z697 + k10 * (z275 * z455 - c1 * z696));
    const bicycle_lanes z739 = z331 * z406 + z208 * z412 - z195 * z443 + z189 * z472 + z8 * z447 - z22 * z451;
    const bicycle_lanes z740 = z739 + z17 * z474 - z21 * z456 + k10 * (c1 * z455) + e2z * z461;
    const bicycle_lanes z741 = z346 * z418 - z341 * z419 - z333 * z412 + z329 * z406 + z331 * z494 + z296 *
        z441;
    const double z280 = kept[232];
    const bicycle_lanes z742 = z741 - z290 * z471 - z286 * z445 - z304 * z452 + z289 * z454 + z299 * z475 +
        z280 * z461;
    const bicycle_lanes z743 = z742 - z208 * z488 + z140 * z545 - z144 * z547 + z134 * z535 - z142 * z538 +
        z98 * z568;
    const bicycle_lanes z744 = z743 - z102 * z570 + z92 * z559 - z100 * z562 + z60 * z591 - z64 * z593 + z54
        * z583;
    const bicycle_lanes z745 = z189 * z717 - (z195 * z517 + (z744 - z62 * z586)) + z45 * z619 + c1 * z722 -
        z8 * z671;
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const bicycle_lanes z746 = steer_dot * z740 - (z745 + k10 * z683 + z22 * z693 + z21 * z695 + z17 * z706 -
        z3 * z701);
    const bicycle_lanes z747 = c_steer * (steer_dot * z732 + (z277 * z461 + z738) - e2z * z701) - s_steer *
        (e2z * z664 + z746);
    bicycle_put(slope + 2 * BICYCLE_LANES, z747);
    const double z343 = kept[294];
    const bicycle_lanes z465 = bicycle_get(carried + 61 * BICYCLE_LANES);
    const bicycle_lanes z473 = bicycle_get(carried + 68 * BICYCLE_LANES);
    const bicycle_lanes z479 = bicycle_get(carried + 74 * BICYCLE_LANES);
    const bicycle_lanes z748 = z275 * z473 + z279 * z479 + z343 * z465 + z44 * z597 - r_R * (z274 * z711 -
        c_roll * z519);
    bicycle_put(slope + 3 * BICYCLE_LANES, c_roll * z462 - (z748 + c1 * z720 - s1 * z726 + e2z * z713));
    const bicycle_lanes z506 = bicycle_get(carried + 86 * BICYCLE_LANES);
    bicycle_put(slope + 4 * BICYCLE_LANES, z506 + z725 + c_steer * z740 + s_steer * z732);
    const bicycle_lanes z487 = bicycle_get(carried + 78 * BICYCLE_LANES);
    bicycle_put(slope + 5 * BICYCLE_LANES, -(z487 + z718));
}

BICYCLE_SLOW
int bicycle_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[329]; /* what parts of this function leave for others */
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
    const double lam = p[2]; /* tilt of the steering axis, 18 degrees [rad] */

    /* sines and cosines */
    const double s_lam = sin(lam);
    const double c_lam = cos(lam);
    const double c_roll = cos(roll);
    const double e2z = sin(roll);
    const double c_pitch = cos(pitch);
    const double s_pitch = sin(pitch);
    const double c_steer = cos(steer);
    const double s_steer = sin(steer);

    /* what else is read */
    const double z = y[2]; /* centre of the rear wheel, downwards [m] */
    const double roll_dot = y[9]; /* roll' [rad/s] */
    const double steer_dot = y[10]; /* steer' [rad/s] */
    const double thF_dot = y[11]; /* thF' [rad/s] */
    const double w = p[0]; /* wheelbase [m] */
    const double c = p[1]; /* trail [m] */
    const double r_R = p[4]; /* radius of the rear wheel [m] */
    const double r_F = p[22]; /* radius of the front wheel [m] */

    /* from the parameters alone */
    const double k1 = w + c;
    const double k2 = r_F * s_lam - c * c_lam;
    const double k3 = r_R * s_lam - c_lam * k1;
    const double k4 = s_lam * k1 - (r_F * c_lam + c * s_lam - r_R * c_lam);
    const double k5 = fabs(r_R);
    const double k6 = fabs(r_F);
    const double k7 = fabs(w);
    const double k8 = fabs(c);
    const double k9 = 9.0 * k6;
    const double k10 = 6.0 * k8 + (2.0 * k7 + (5.0 * k5 + k9));
    const double k11 = 6.0 * k7;
    const double k12 = 14.0 * k6 + 13.0 * k8;
    const double k13 = k9 + 10.0 * k8;

    /* from the state */
    const double z1 = c_pitch * s_lam + s_pitch * c_lam;
    const double z2 = c_roll * z1;
    const double z3 = c_roll * c_roll;
    const double z4 = 1.0 / sqrt(z3);
    const double z5 = r_R * z4;
    const double z6 = z2 * z5;
    const double z7 = e2z * s_steer - c_steer * z2;
    const double z8 = c_pitch * c_lam - s_pitch * s_lam;
    const double z9 = c_roll * z8;
    const double z10 = c_lam * z7 + s_lam * z9;
    const double z11 = c_lam * z9 - s_lam * z7;
    const double z12 = 1.0 / sqrt(z10 * z10 + z11 * z11);
    const double z13 = r_F * z12;
    const double z14 = z7 * z13;
    const double z15 = k2 + z14;
    const double z16 = k3 - z6 - c_steer * z15;
    const double z17 = z9 * z5;
    const double z18 = z9 * z13;
    const double z19 = k4 + z18;
    const double z20 = z1 * z19;
    const double z21 = z17 - z19;
    const double z22 = s_steer * z21;
    const double z23 = c_roll * (c_steer * z20 - z8 * (c_steer * k3 - z15)) + e2z * z22;
    const double z24 = c_steer * z21;
    const double z25 = c_roll * (k3 * (s_steer * z8) - s_steer * z20) + e2z * z24;
    const double z26 = z24 * z23 - z25 * z22;
    const double z27 = z16 * (c_steer * z17 * z23 - s_steer * z17 * z25) + z6 * z26;
    const double z28 = k11 + k5 * (9.0 + fabs(z4));
    const double z29 = roll_dot * z8;
    const double z30 = c_steer * z29;
    const double z31 = roll_dot * z1;
    const double z32 = steer_dot + z31;
    const double z33 = c_roll * (roll_dot * z5) - k3 * z31;
    const double z34 = k4 * z30 - k2 * z32 - c_steer * z33 - (z32 * z14 - z30 * z18);
    const double z35 = s_steer * z29;
    const double z36 = thF_dot - z35;
    const double z37 = k4 * z35 - s_steer * z33 - z36 * z18;
    const double z38 = (s_steer * z2 * z15 - e2z * z16) * (z24 * z34 + z22 * z37) + z16 * (z23 * z37 + z25 *
        z34);
    const double z39 = r_F * z11;
    const double z40 = z - s_pitch * c_roll * k1 + r_R * (c_pitch * c_roll) - c * z10 - z39 + z10 * (z10 *
        z13);
    /* 123:10 */
    out[0] = r_R * ((z38 - z26 * (k2 * z35 - z36 * z14)) / z27); /* speed */
    /* 124:16 */
    out[1] = z + z3 * z5; /* rear_height */
    /* 125:17 */
    out[2] = z40 + z12 * (z11 * z39); /* front_height */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0] + out[1] + out[2]) <= DBL_MAX
        && fabs(z27) > 1e-12 * (k10 * ((z28 + k12) * (z28 + k13))))) {
        /* the coframe is singular, if z27 is nearly 0 */
        if (!(fabs(z27) > 1e-12 * (k10 * ((z28 + k12) * (z28 + k13))))) {
            return bicycle_refuse(fabs(z27), 1e-12 * (k10 * ((z28 + k12) * (z28 + k13))), BICYCLE_SINGULAR_1);
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
    const double k3 = fixed[5];
    const double k9 = fixed[6];
    const double k14 = fixed[7];
    const double k19 = fixed[8];
    const double k20 = fixed[9];
    const double k21 = fixed[10];
    const double k22 = fixed[11];
    const double k23 = fixed[12];
    const double k29 = fixed[13];
    const double k30 = fixed[14];
    const double k32 = fixed[15];
    const double k33 = fixed[16];
    const double k34 = fixed[17];
    const double k41 = fixed[18];
    const double k45 = fixed[19];
    const double k46 = fixed[20];
    const double k47 = fixed[21];
    const double k48 = fixed[22];
    const double k50 = fixed[23];
    const double k51 = fixed[24];
    const double k52 = fixed[25];
    const double k55 = fixed[26];
    const double k57 = fixed[27];
    const double k58 = fixed[28];
    const double k60 = fixed[29];
    const double k61 = fixed[30];
    const double k62 = fixed[31];
    const double k63 = fixed[32];
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
    const bicycle_lanes z1 = 1.0 / bicycle_size(BICYCLE_SPREAD(c_roll));
    const bicycle_lanes z2 = pitch + lam;
    bicycle_lanes sine2, cosine2;
    bicycle_turn_lanes(BICYCLE_SPREAD(z2), &far, &sine2, &cosine2);
    const bicycle_lanes s1 = sine2;
    const bicycle_lanes z3 = c_roll * s1;
    const bicycle_lanes z4 = r_R * z3;
    const bicycle_lanes z5 = z1 * z4;
    const bicycle_lanes z6 = k9 - z5;
    bicycle_lanes sine3, cosine3;
    bicycle_turn_lanes(BICYCLE_SPREAD(steer), &far, &sine3, &cosine3);
    const bicycle_lanes c_steer = cosine3;
    const bicycle_lanes c1 = cosine2;
    const bicycle_lanes z7 = c_roll * c1;
    const bicycle_lanes e2z = sine1;
    const bicycle_lanes s_steer = sine3;
    const bicycle_lanes z8 = e2z * s_steer - c_steer * z3;
    const bicycle_lanes z9 = 1.0 / bicycle_each_sqrt(BICYCLE_SPREAD(z7 * z7 + z8 * z8));
    const bicycle_lanes z10 = r_F * z8;
    const bicycle_lanes z11 = z9 * z10;
    const bicycle_lanes z12 = k3 + z11;
    const bicycle_lanes z13 = z6 - c_steer * z12;
    const bicycle_lanes z14 = r_R * z7;
    const bicycle_lanes z15 = z1 * z14;
    const bicycle_lanes z16 = c_steer * z15;
    const bicycle_lanes z17 = c_steer * k9;
    const bicycle_lanes z18 = z17 - z12;
    const bicycle_lanes z19 = r_F * z7;
    const bicycle_lanes z20 = z9 * z19;
    const bicycle_lanes z21 = z20 - k50;
    const bicycle_lanes z22 = c_steer * z21;
    const bicycle_lanes z23 = c1 * z18 - s1 * z22;
    const bicycle_lanes z24 = z15 - z21;
    const bicycle_lanes z25 = s_steer * z24;
    const bicycle_lanes z26 = c_roll * z23 - e2z * z25;
    const bicycle_lanes z27 = s_steer * z15;
    const bicycle_lanes z28 = s_steer * k9;
    const bicycle_lanes z29 = s_steer * z21;
    const bicycle_lanes z30 = c1 * z28 - s1 * z29;
    const bicycle_lanes z31 = c_steer * z24;
    const bicycle_lanes z32 = c_roll * z30 + e2z * z31;
    const bicycle_lanes z33 = z16 * z26 + z27 * z32;
    const bicycle_lanes z34 = z31 * z26 + z32 * z25;
    const bicycle_lanes z35 = z13 * z33 + z5 * z34;
    const bicycle_lanes z36 = k20 + k14 * (9.0 + bicycle_size(BICYCLE_SPREAD(z1)));
    /* the coframe is singular, if -z35 is nearly 0 */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(-z35)), 1e-12 * (k19 * ((z36 + k51) * (z36 + k52))));
    const bicycle_lanes z37 = r_R * z1;
    const bicycle_lanes z38 = c_roll * z37;
    const bicycle_lanes z39 = 1.0 / z35;
    const bicycle_lanes z40 = k9 * s1 - z38;
    const bicycle_lanes z41 = s1 * z12 - (c_steer * z40 + c1 * z22);
    const bicycle_lanes z42 = s_steer * c1;
    const bicycle_lanes z43 = s_steer * z40 + z42 * z21;
    const bicycle_lanes z44 = z16 * z41 - z27 * z43;
    const bicycle_lanes z45 = z39 * (z13 * z44 + z5 * (z31 * z41 - z25 * z43));
    const bicycle_lanes z46 = c_roll * z45;
    const bicycle_lanes z47 = s1 + c1 * z46;
    const bicycle_lanes z48 = c1 - s1 * z46;
    const bicycle_lanes z49 = s_steer * z12;
    const bicycle_lanes z50 = s1 * z49;
    const bicycle_lanes z51 = c_roll * z50 - e2z * z13;
    const bicycle_lanes z52 = (z42 * (z12 * z33) - z51 * z44 + z5 * (z26 * z43 + z32 * z41)) * z39 - e2z *
        z45;
    const bicycle_lanes z53 = c_steer * z52 + s_steer * z48;
    const bicycle_lanes z54 = z15 * z52;
    const bicycle_lanes z55 = z38 - k9 * z47;
    const bicycle_lanes z56 = c_steer * z54 + s_steer * z55;
    const bicycle_lanes z57 = z6 * z52;
    const bicycle_lanes z58 = k60 * z53 + (k55 * z56 - k41 * z57);
    const bicycle_lanes z59 = F_yy * z53;
    const bicycle_lanes z60 = k33 * z47 - (k23 * z38 + k30 * z48);
    const bicycle_lanes z61 = c_steer * z55 - s_steer * z54;
    const bicycle_lanes z62 = s_steer * z52 - c_steer * z48;
    const bicycle_lanes z63 = k61 * z47 + (k41 * z61 + k58 * z62);
    const bicycle_lanes z64 = z60 + z63;
    const bicycle_lanes z65 = k58 * z47 - (k55 * z61 - k57 * z62);
    const bicycle_lanes z66 = k34 * z57 - k41 * z53;
    const bicycle_lanes z67 = k41 * z47 + (k34 * z61 - k55 * z62);
    const bicycle_lanes z68 = k34 * z56 + k55 * z53;
    const bicycle_lanes z69 = z5 * z52;
    const bicycle_lanes z70 = k32 * z52 - (k22 * z54 + k23 * z69);
    const bicycle_lanes z71 = k21 * z69 - k23 * z52;
    const bicycle_lanes z72 = k21 * z54 - k22 * z52;
    const bicycle_lanes z73 = k30 * z47 + (k22 * z38 - k29 * z48);
    const bicycle_lanes z74 = z56 * z68 + (z52 * z70 + (z69 * z71 + (z54 * z72 - (z48 * z73 - R_yy * (z52 *
        z52)))));
    const bicycle_lanes z75 = z53 * (z58 + z59) + (z47 * z64 + (z62 * z65 + (z57 * z66 + (z61 * z67 + z74))));
    const bicycle_lanes z76 = z38 * (k23 * z47 - (k21 * z38 - k22 * z48)) - z75;
    const bicycle_lanes z77 = z16 * z12;
    const bicycle_lanes z78 = z12 * z31;
    const bicycle_lanes z79 = (z13 * z77 + z5 * z78) * z39;
    const bicycle_lanes z80 = c_roll * z79;
    const bicycle_lanes z81 = c1 * z80;
    const bicycle_lanes z82 = 1.0 + z81;
    const bicycle_lanes z83 = z12 * z32;
    const bicycle_lanes z84 = (z51 * z77 - z5 * z83) * z39 + e2z * z79;
    const bicycle_lanes z85 = (z51 * z78 + z13 * z83) * z39 - z84;
    const bicycle_lanes z86 = z15 * z85;
    const bicycle_lanes z87 = z17 * z81 + s_steer * z86;
    const bicycle_lanes z88 = s1 * z80;
    const bicycle_lanes z89 = s_steer * z84 - c_steer * z88;
    const bicycle_lanes z90 = k61 * z82 - (k41 * z87 + k58 * z89);
    const bicycle_lanes z91 = k58 * z82 + (k55 * z87 - k57 * z89);
    const bicycle_lanes z92 = k41 * z82 - (k34 * z87 - k55 * z89);
    const bicycle_lanes z93 = k30 * z88 + k33 * z81;
    const bicycle_lanes z94 = z5 * z85;
    const bicycle_lanes z95 = k32 * z84 + (k22 * z86 + k23 * z94);
    const bicycle_lanes z96 = k29 * z88 + k30 * z81;
    const bicycle_lanes z97 = k21 * z86 + k22 * z84;
    const bicycle_lanes z98 = k21 * z94 + k23 * z84;
    const bicycle_lanes z99 = z81 * z93 + (z84 * z95 + (z88 * z96 + (z86 * z97 + (z94 * z98 + R_yy * (z85 *
        z85)))));
    const bicycle_lanes z100 = z82 * z90 - (z89 * z91 + (z87 * z92 - z99));
    const bicycle_lanes z101 = z81 * z60 - (z84 * z70 - (z88 * z73 + (z86 * z72 + (z94 * z71 + R_yy * (z85 *
        z52)))));
    const bicycle_lanes z102 = z82 * z63 - (z89 * z65 + (z87 * z67 - z101));
    const bicycle_lanes z103 = 1.0 / z76;
    const bicycle_lanes z104 = z102 * z103;
    const bicycle_lanes z105 = z100 + z102 * z104;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z105 is nearly 0 */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z105)), 1e-13 * z100);
    const bicycle_lanes z106 = z20 * z13;
    const bicycle_lanes z107 = z20 * z25;
    const bicycle_lanes z108 = z39 * (z27 * z106 + z5 * z107);
    const bicycle_lanes z109 = c_roll * z108;
    const bicycle_lanes z110 = c1 * z109;
    const bicycle_lanes z111 = k9 * z110;
    const bicycle_lanes z112 = e2z * z108;
    const bicycle_lanes z113 = (z51 * z107 - z26 * z106 + z11 * z34) * z39 - z112;
    const bicycle_lanes z114 = z15 * z113;
    const bicycle_lanes z115 = c_steer * z111 + s_steer * z114;
    const bicycle_lanes z116 = s1 * z109;
    const bicycle_lanes z117 = s_steer * z112 - c_steer * z116;
    const bicycle_lanes z118 = c_steer * z112 + s_steer * z116;
    const bicycle_lanes z119 = c_steer * z114 - s_steer * z111;
    const bicycle_lanes z120 = z5 * z113;
    const bicycle_lanes z121 = z120 + k9 * z112;
    const bicycle_lanes z122 = z116 * (k29 * z116 + k30 * z110) + (z114 * (k21 * z114 + k22 * z112) + z120 *
        (k21 * z120 + k23 * z112));
    const bicycle_lanes z123 = z110 * (k30 * z116 + k33 * z110) + (z112 * (k32 * z112 + (k22 * z114 + k23 *
        z120)) + z122);
    const bicycle_lanes z124 = z115 * (k41 * z110 - (k34 * z115 - k55 * z117)) - (z119 * (k34 * z119 - k55 *
        z118) + z123);
    const bicycle_lanes z125 = z117 * (k58 * z110 + (k55 * z115 - k57 * z117)) - (z121 * (k34 * z121 - k41 *
        z118) - z124);
    const bicycle_lanes z126 = z110 * (k61 * z110 - (k41 * z115 + k58 * z117)) + (z118 * (k60 * z118 - (k55 *
        z119 + k41 * z121)) - z125);
    const bicycle_lanes z127 = 1.0 + z118;
    const bicycle_lanes z128 = z126 + R_yy * (z113 * z113) + F_yy * (z127 * z127);
    const bicycle_lanes z129 = R_yy * z113;
    const bicycle_lanes z130 = z112 * z70 - (z116 * z73 + (z114 * z72 + (z120 * z71 + (z129 * z52 - z127 *
        z59))));
    const bicycle_lanes z131 = z110 * z64 - (z118 * z58 + (z117 * z65 + (z121 * z66 + (z115 * z67 - (z119 *
        z68 - z130)))));
    const bicycle_lanes z132 = z131 * z103;
    const bicycle_lanes z133 = z112 * z95 + (z116 * z96 + (z114 * z97 + (z120 * z98 + (z102 * z132 + z85 *
        z129))));
    const bicycle_lanes z134 = z110 * (z93 + z90) - (z117 * z91 + (z115 * z92 - z133));
    const bicycle_lanes z135 = 1.0 / z105;
    const bicycle_lanes z136 = z134 * z135;
    const bicycle_lanes z137 = z128 + z131 * z132 - z134 * z136;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z137 is nearly 0 */
    bad |= bicycle_misses(bicycle_size(BICYCLE_SPREAD(z137)), 1e-13 * z128);
    bicycle_lanes sine4, cosine4;
    bicycle_turn_lanes(BICYCLE_SPREAD(yaw), &far, &sine4, &cosine4);
    const bicycle_lanes c_yaw = cosine4;
    const bicycle_lanes z138 = roll_dot * c1;
    const bicycle_lanes z139 = s_steer * z138;
    const bicycle_lanes z140 = thF_dot - z139;
    const bicycle_lanes z141 = k3 * z139 - z11 * z140;
    const bicycle_lanes z142 = roll_dot * s1;
    const bicycle_lanes v2_x = roll_dot * z38;
    const bicycle_lanes z143 = k9 * z142 - v2_x;
    const bicycle_lanes z144 = z20 * z140 + (z139 * k50 - s_steer * z143);
    const bicycle_lanes z145 = steer_dot + z142;
    const bicycle_lanes z146 = c_steer * z138;
    const bicycle_lanes z147 = z145 * z12 - (c_steer * z143 + z146 * z21);
    const bicycle_lanes z148 = z25 * z144 + z31 * z147;
    const bicycle_lanes z149 = z26 * z144 - z32 * z147;
    const bicycle_lanes z150 = (z141 * z34 - (z51 * z148 - z13 * z149)) * z39;
    const bicycle_lanes z151 = z27 * z144 + z16 * z147;
    const bicycle_lanes z152 = (z141 * z33 - z51 * z151 - z5 * z149) * z39;
    const bicycle_lanes z153 = z39 * (z13 * z151 + z5 * z148);
    const bicycle_lanes z154 = z152 - e2z * z153;
    const bicycle_lanes z155 = z150 - z154;
    const bicycle_lanes z156 = z5 * z155;
    const bicycle_lanes z157 = z15 * z155;
    const bicycle_lanes z158 = s1 * z156 + c1 * z157;
    const bicycle_lanes s_yaw = sine4;
    const bicycle_lanes z159 = c_roll * v2_x;
    const bicycle_lanes z160 = c1 * z152;
    const bicycle_lanes z161 = roll_dot * z160;
    const bicycle_lanes z162 = c_roll * z153;
    const bicycle_lanes z163 = s1 * z152;
    const bicycle_lanes z164 = roll_dot * e2z;
    const bicycle_lanes z165 = steer_dot * s_steer;
    const bicycle_lanes z166 = z164 * c1 - c_roll * z163;
    const bicycle_lanes z167 = roll_dot * c_roll;
    const bicycle_lanes z168 = steer_dot * c_steer;
    const bicycle_lanes z169 = z164 * s1 + c_roll * z160;
    const bicycle_lanes z170 = s_steer * z167 + e2z * z168 + (z165 * z3 + c_steer * z169);
    const bicycle_lanes z171 = (z7 * z166 - z8 * z170) * (z9 * (z9 * z9));
    const bicycle_lanes z172 = r_F * z9;
    const bicycle_lanes z173 = z19 * z171 - z172 * z166;
    const bicycle_lanes z174 = z10 * z171 + z172 * z170;
    const bicycle_lanes z175 = s1 * (z165 * z21 - c_steer * z173) - (c1 * (z165 * k9 + z174) - (z22 * z160 +
        z18 * z163));
    const bicycle_lanes z176 = z1 * (c_roll * z164) * (z1 * z1);
    const bicycle_lanes z177 = z14 * z176 - z37 * z166;
    const bicycle_lanes z178 = z177 - z173;
    const bicycle_lanes z179 = z168 * z24 + s_steer * z178;
    const bicycle_lanes z180 = roll_dot * z163;
    const bicycle_lanes z181 = k9 * z161;
    const bicycle_lanes z182 = z21 * (z165 * z138 - c_steer * z180) - (z146 * z173 - (z165 * z143 + (z145 *
        z174 + (c_steer * z181 - z152 * z179))));
    const bicycle_lanes z183 = z153 * (c_roll * z175 - (z164 * z23 + (z167 * z25 + e2z * z179))) - (z150 *
        (z168 * z15 + s_steer * z177) - (z12 * z161 - z182));
    const bicycle_lanes z184 = s1 * (z168 * z21 + s_steer * z173) - (z29 * z160 + (k9 * (z168 * c1) + z28 *
        z163));
    const bicycle_lanes z185 = z165 * z24 - c_steer * z178;
    const bicycle_lanes z186 = z168 * z138 + s_steer * z180;
    const bicycle_lanes z187 = z150 * (z165 * z15 - c_steer * z177) - (z21 * z186 - (z140 * z173 - (z168 *
        z143 - (s_steer * z181 - z152 * z185))));
    const bicycle_lanes z188 = z153 * (c_roll * z184 + (z164 * z30 - (z167 * z31 - e2z * z185))) + z187;
    const bicycle_lanes z189 = z16 * z183 - z27 * z188;
    const bicycle_lanes z190 = z31 * z183 - z25 * z188;
    const bicycle_lanes z191 = z39 * (z13 * z189 + z5 * z190);
    const bicycle_lanes z192 = z164 * z153 + c_roll * z191;
    const bicycle_lanes z193 = z161 - (z162 * z163 - c1 * z192);
    const bicycle_lanes z194 = z142 + c1 * z162;
    const bicycle_lanes z195 = z138 - s1 * z162;
    const bicycle_lanes z196 = z157 * z194 - z156 * z195;
    const bicycle_lanes z197 = z180 + (z162 * z160 + s1 * z192);
    const bicycle_lanes z198 = k22 * z154;
    const bicycle_lanes z199 = k23 * z154;
    const bicycle_lanes z200 = k23 * z193 - (k21 * z196 + (k22 * z197 + (z194 * z198 + (e2z * k45 - z195 *
        z199))));
    const bicycle_lanes z201 = z4 * z176 - z37 * z169;
    const bicycle_lanes z202 = z201 - (z165 * z12 - c_steer * z174);
    const bicycle_lanes z203 = c_roll * (z49 * z160 - s1 * (z168 * z12 + s_steer * z174)) + (z164 * z50 +
        (z167 * z13 - e2z * z202));
    const bicycle_lanes z204 = z153 * z203 + (z12 * z186 - (z150 * z201 + (z140 * z174 - z152 * z202)));
    const bicycle_lanes z205 = z26 * z188 + z32 * z183;
    const bicycle_lanes z206 = z39 * (z51 * z189 + z33 * z204 - z5 * z205) - (z167 * z153 - e2z * z191);
    const bicycle_lanes z207 = z165 * z154 - c_steer * z206 - (z168 * z195 + s_steer * z197);
    const bicycle_lanes z208 = z39 * (z51 * z190 + z13 * z205 + z34 * z204) - z206;
    const bicycle_lanes z209 = z155 * z177 + z15 * z208 - (z154 * z156 - v2_x * z194);
    const bicycle_lanes z210 = k9 * z154;
    const bicycle_lanes z211 = k9 * z194;
    const bicycle_lanes z212 = z209 - (z154 * z210 + z194 * z211);
    const bicycle_lanes z213 = z196 - (k9 * z193 + z210 * z195);
    const bicycle_lanes z214 = c_steer * z212 + s_steer * z213;
    const bicycle_lanes z215 = z155 * z201 + z5 * z208 - (v2_x * z195 - z154 * z157);
    const bicycle_lanes z216 = z215 + (k9 * z206 + z195 * z211);
    const bicycle_lanes w3_steer = steer_dot + z194;
    const bicycle_lanes z217 = s_steer * z154 - c_steer * z195;
    const bicycle_lanes z218 = k57 * z217 + k58 * w3_steer;
    const bicycle_lanes z219 = k58 * z217 + k61 * w3_steer;
    const bicycle_lanes z220 = z8 * k62 - (k60 * z207 + (k55 * z214 + (k41 * z216 - (w3_steer * z218 - z217 *
        z219))));
    const bicycle_lanes z221 = z7 * k63 - z220;
    const bicycle_lanes z222 = F_yy * z207;
    const bicycle_lanes z223 = R_yy * z155 - k32 * z154;
    const bicycle_lanes z224 = k29 * z195 - k30 * z194;
    const bicycle_lanes z225 = e2z * k46 - (k33 * z193 - (k23 * z196 - k30 * z197) - (z195 * z223 + z154 *
        z224));
    const bicycle_lanes h2z = e2z * c_steer + s_steer * z3;
    const bicycle_lanes z226 = c_steer * z213 - s_steer * z212;
    const bicycle_lanes z227 = z168 * z154 + s_steer * z206 + (z165 * z195 - c_steer * z197);
    const bicycle_lanes z228 = c_steer * z154 + s_steer * z195;
    const bicycle_lanes z229 = F_yy * (thF_dot - z228) - k60 * z228;
    const bicycle_lanes z230 = h2z * k63 + (k61 * z193 + (k41 * z226 - k58 * z227) + (z217 * z229 + z228 *
        z218));
    const bicycle_lanes z231 = z225 - z230;
    const bicycle_lanes z232 = h2z * k62 + (k58 * z193 - (k55 * z226 + k57 * z227) - (z228 * z219 + w3_steer
        * z229));
    const bicycle_lanes z233 = k55 * z217 - k41 * w3_steer;
    const bicycle_lanes z234 = k55 * z228;
    const bicycle_lanes z235 = z7 * k48 + (k34 * z216 + k41 * z207 - (z217 * z233 + z228 * z234));
    const bicycle_lanes z236 = k41 * z228;
    const bicycle_lanes z237 = h2z * k48 + (k41 * z193 + (k34 * z226 + k55 * z227) - (w3_steer * z234 + z217
        * z236));
    const bicycle_lanes z238 = z8 * k48 + (k34 * z214 + k55 * z207 + (z228 * z236 - w3_steer * z233));
    const bicycle_lanes z239 = k30 * z195 - k33 * z194;
    const bicycle_lanes z240 = z3 * k47 - z7 * k46 - (k32 * z206 + (k22 * z209 + k23 * z215) - (z194 * z224 +
        z195 * z239));
    const bicycle_lanes z241 = e2z * k47 + (k30 * z193 + (k22 * z196 + k29 * z197) + (z154 * z239 - z194 *
        z223));
    const bicycle_lanes z242 = k22 * z195 + k23 * z194;
    const bicycle_lanes z243 = z7 * k45 + (k21 * z215 + k23 * z206 + (z195 * z242 + z154 * z198));
    const bicycle_lanes z244 = z3 * k45 - (k21 * z209 + k22 * z206 - (z154 * z199 + z194 * z242));
    const bicycle_lanes z245 = R_yy * z208;
    const bicycle_lanes z246 = z56 * z238 + (z52 * z240 - (z48 * z241 - (z69 * z243 - (z54 * z244 - z52 *
        z245))));
    const bicycle_lanes z247 = z53 * (z221 + z222) - (z47 * z231 - (z62 * z232 - (z57 * z235 - (z61 * z237 +
        z246))));
    const bicycle_lanes z248 = z38 * z200 - z247;
    const bicycle_lanes z249 = z84 * z240 - (z88 * z241 - (z86 * z244 - (z94 * z243 - (z248 * z104 - z85 *
        z245))));
    const bicycle_lanes z250 = z82 * z230 - (z89 * z232 + (z87 * z237 + (z81 * z225 + z249)));
    const bicycle_lanes z251 = z114 * z244 - (z120 * z243 - (z248 * z132 + (z136 * z250 - (z113 * z245 - z127
        * z222))));
    const bicycle_lanes z252 = z117 * z232 - (z121 * z235 - (z115 * z237 - (z119 * z238 - (z112 * z240 -
        (z116 * z241 - z251)))));
    const bicycle_lanes z253 = (z110 * z231 + (z118 * z221 + z252)) / z137;
    const bicycle_lanes z254 = z135 * z250 + z136 * z253;
    /* (I.2.4) */
    const bicycle_lanes slope1 = -(c_yaw * z158 + s_yaw * z159);
    sum += slope1;
    bicycle_put(dydt, slope1);
    const bicycle_lanes slope2 = c_yaw * z159 - s_yaw * z158;
    sum += slope2;
    bicycle_put(dydt + 1 * stride, slope2);
    const bicycle_lanes slope3 = e2z * v2_x;
    bicycle_put(dydt + 2 * stride, slope3);
    const bicycle_lanes slope4 = z153;
    bicycle_put(dydt + 3 * stride, slope4);
    const bicycle_lanes slope5 = roll_dot;
    bicycle_put(dydt + 4 * stride, slope5);
    const bicycle_lanes slope6 = -z152;
    bicycle_put(dydt + 5 * stride, slope6);
    const bicycle_lanes slope7 = steer_dot;
    bicycle_put(dydt + 6 * stride, slope7);
    const bicycle_lanes slope8 = z150;
    bicycle_put(dydt + 7 * stride, slope8);
    const bicycle_lanes slope9 = thF_dot;
    bicycle_put(dydt + 8 * stride, slope9);
    /* (I.2.15) 112:4 */
    const bicycle_lanes slope10 = z248 * z103 + z104 * z254 - z132 * z253;
    sum += slope10;
    bicycle_put(dydt + 9 * stride, slope10);
    const bicycle_lanes slope11 = z254;
    bicycle_put(dydt + 10 * stride, slope11);
    const bicycle_lanes slope12 = -z253;
    sum += slope12;
    bicycle_put(dydt + 11 * stride, slope12);
    bicycle_put(check, bicycle_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void bicycle_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
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
    const double k6 = R_xx + B_xx;
    const double k7 = R_xx + B_zz;
    const double k8 = x_H - k2;
    const double k9 = r_R * s_lam - c_lam * k2;
    const double k10 = z_H * s_lam - c_lam * k8;
    const double k11 = r_R * c_lam + s_lam * k2;
    const double k12 = c_lam * k1 + x_B * s_lam;
    const double k13 = s_lam * k1 - x_B * c_lam;
    const double k14 = fabs(r_R);
    const double k15 = fabs(r_F);
    const double k16 = fabs(w);
    const double k17 = fabs(c);
    const double k18 = 9.0 * k15;
    const double k19 = 6.0 * k17 + (2.0 * k16 + (5.0 * k14 + k18));
    const double k20 = 6.0 * k16;
    const double k21 = m_R + m_B;
    const double k22 = m_B * k12;
    const double k23 = m_B * k13;
    const double k24 = B_xz * c_lam;
    const double k25 = s_lam * k7 - k24;
    const double k26 = B_xz * s_lam;
    const double k27 = c_lam * k6 - k26;
    const double k28 = k12 * k22;
    const double k29 = s_lam * k25 + c_lam * k27 + k28;
    const double k30 = c_lam * k25 - s_lam * k27 - k13 * k22;
    const double k31 = k13 * k23;
    const double k32 = k28 + (B_yy + k31);
    const double k33 = k31 + (c_lam * (k26 + c_lam * k7) + s_lam * (k24 + s_lam * k6));
    const double k34 = m_H + m_F;
    const double k35 = m_F * k3;
    const double k36 = H_xz * c_lam;
    const double k37 = s_lam * k4 - k36;
    const double k38 = H_xz * s_lam;
    const double k39 = c_lam * k5 - k38;
    const double k40 = m_H * k10;
    const double k41 = k35 - k40;
    const double k42 = g * m_F;
    const double k43 = g * m_H;
    const double k44 = g * m_B;
    const double k45 = g * k21;
    const double k46 = k13 * k44;
    const double k47 = k12 * k44;
    const double k48 = g * k34;
    const double k49 = k11 + (z_H * c_lam + s_lam * k8);
    const double k50 = r_F * c_lam + c * s_lam - k11;
    const double k51 = 14.0 * k15 + 13.0 * k17;
    const double k52 = k18 + 10.0 * k17;
    const double k53 = m_F * k50;
    const double k54 = m_H * k49;
    const double k55 = k53 - k54;
    const double k56 = k50 * k53 + k49 * k54;
    const double k57 = s_lam * k37 + c_lam * k39 + k56;
    const double k58 = c_lam * k37 - s_lam * k39 - k3 * k53 - k10 * k54;
    const double k59 = k3 * k35 + k10 * k40;
    const double k60 = k59 + (H_yy + k56);
    const double k61 = c_lam * (k38 + c_lam * k4) + s_lam * (k36 + s_lam * k5) + k59;
    const double k62 = k43 * k49 - k42 * k50;
    const double k63 = k3 * k42 - k10 * k43;
    const double fixed[] = {lam, r_R, R_yy, r_F, F_yy, k3, k9, k14, k19, k20, k21, k22, k23, k29, k30, k32,
        k33, k34, k41, k45, k46, k47, k48, k50, k51, k52, k55, k57, k58, k60, k61, k62, k63};
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
