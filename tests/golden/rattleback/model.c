/*
 * rattleback.c: rattleback, emitted by nhc 0.1.0 (nhc:78ae1504638d9441)
 * A loaded ellipsoid that rolls on a plane and prefers one sense of spin (celt, wobblestone).
 * Equations of motion: euler-lagrange (I.2.15)
 * Why: quasi-velocities of the spec
 * rattleback.h says what each function does.
 */
#include "rattleback.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if defined(__SSE2__) && !defined(__NO_MATH_ERRNO__)
#include <emmintrin.h>
#define RATTLEBACK_SSE2
#endif

const char *const rattleback_coordinate_names[RATTLEBACK_NQ] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma"
};
const char *const rattleback_state_names[RATTLEBACK_NY] = {
    "x",
    "y",
    "z",
    "alpha",
    "beta",
    "gamma",
    "w1",
    "w2",
    "w3"
};
const char *const rattleback_parameter_names[RATTLEBACK_NP] = {
    "a",
    "b",
    "c",
    "h",
    "I_a",
    "I_b",
    "I_c",
    "I_d",
    "g"
};
const char *const rattleback_constraint_names[RATTLEBACK_NC] = {
    "roll_x",
    "roll_y",
    "roll_z"
};
const char *const rattleback_output_names[RATTLEBACK_NOUT] = {
    "spin"
};
const double rattleback_parameter_defaults[RATTLEBACK_NP] = {
    20.0,
    3.0,
    2.0,
    1.0,
    2.0,
    16.0,
    17.0,
    -0.2,
    981.0
};

/* long functions that are called seldom: gcc is to take less time over them (other compilers do so by themselves) */
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define RATTLEBACK_SLOW __attribute__((cold, optimize("O1")))
#else
#define RATTLEBACK_SLOW
#endif

/* the machine's own root: it sets no errno, so that no call of libm's stands behind it, which would cost its caller registers */
static inline double rattleback_root(double x)
{
#ifdef RATTLEBACK_SSE2
    const __m128d v = _mm_set_sd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(v, v));
#else
    return sqrt(x);
#endif
}

#if defined(__GNUC__)
__attribute__((noinline)) /* seldom called; inlined, it would cost its callers registers */
#endif
static int rattleback_finish(int count, const double *values)
{
    double sum = 0.0; /* not finite if any of the values is not */
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    if (fabs(sum) <= DBL_MAX) {
        return RATTLEBACK_OK;
    }
    for (int i = 0; i < count; ++i) { /* finite values may have an infinite sum */
        if (!(fabs(values[i]) <= DBL_MAX)) {
            return RATTLEBACK_NOT_FINITE;
        }
    }
    return RATTLEBACK_OK;
}

/* the status where a pivot or determinant is not above its bound: singular, or not finite where one is a NaN */
static int rattleback_refuse(double value, double bound, int singular)
{
    return value <= bound && bound <= DBL_MAX ? singular : RATTLEBACK_NOT_FINITE;
}

/* several doubles at once, as many as the machine's vectors hold; one where the compiler has no vectors */
#ifndef RATTLEBACK_LANES
#if !defined(__GNUC__)
#define RATTLEBACK_LANES 1
#elif defined(__AVX512F__)
#define RATTLEBACK_LANES 8
#elif defined(__AVX__)
#define RATTLEBACK_LANES 4
#else
#define RATTLEBACK_LANES 2
#endif
#endif
#if RATTLEBACK_LANES > 1
typedef double rattleback_lanes __attribute__((vector_size(8 * RATTLEBACK_LANES)));
#else
typedef double rattleback_lanes;
#endif

#if RATTLEBACK_LANES >= 2
static inline rattleback_lanes rattleback_get(const double *from)
{
    rattleback_lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

static inline void rattleback_put(double *to, rattleback_lanes value)
{
    memcpy(to, &value, sizeof value);
}
#endif

/* states first, first + 1, ... through rhs, one by one; the first status that is not OK */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static int rattleback_one_by_one(size_t count, size_t first, size_t number,
    const double *t, const double *y, const double *p, double *dydt)
{
    int status = RATTLEBACK_OK;
    for (size_t i = first; i < first + number; ++i) {
        double state[RATTLEBACK_NY];
        double slope[RATTLEBACK_NY];
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            state[k] = y[k * count + i];
            slope[k] = (double)NAN;
        }
        const int one = rattleback_rhs(t[i], state, p, slope);
        status = status == RATTLEBACK_OK ? one : status;
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            dydt[k * count + i] = slope[k];
        }
    }
    return status;
}

#if RATTLEBACK_LANES >= 2
#define RATTLEBACK_SPREAD(x) ((x) - (rattleback_lanes){0}) /* a number in each lane; lanes stay what they are */

typedef unsigned long long rattleback_bits __attribute__((vector_size(8 * RATTLEBACK_LANES)));

/* all bits where value is not above bound, or is no number */
static inline rattleback_bits rattleback_misses(rattleback_lanes value, rattleback_lanes bound)
{
    return ~(rattleback_bits)(value > bound);
}

/* makes a NaN of each lane whose bits are set */
static inline rattleback_lanes rattleback_mark(rattleback_lanes value, rattleback_bits bad)
{
    return (rattleback_lanes)((rattleback_bits)value | bad);
}

static inline rattleback_lanes rattleback_size(rattleback_lanes x)
{
    return (rattleback_lanes)((rattleback_bits)x & 0x7fffffffffffffffULL);
}

/* whether all states are done: no singular block, no infinity, no angle near 1e5; otherwise they go through rhs one by one */
static inline int rattleback_is_good(int count, const double *check)
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
static inline void rattleback_fill(size_t left, size_t count, const double *t, const double *y,
    double *time, double *state)
{
    for (size_t l = 0; l < RATTLEBACK_LANES; ++l) {
        const size_t i = l < left ? l : left - 1;
        time[l] = t[i];
        for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
            state[k * RATTLEBACK_LANES + l] = y[k * count + i];
        }
    }
}

/* the results of the last states */
static inline void rattleback_pour(size_t left, size_t count, const double *slope, double *dydt)
{
    for (size_t k = 0; k < RATTLEBACK_NY; ++k) {
        for (size_t l = 0; l < left; ++l) {
            dydt[k * count + l] = slope[k * RATTLEBACK_LANES + l];
        }
    }
}

/* libm's sine and cosine, lane by lane */
static inline void rattleback_turn_lanes(rattleback_lanes x, rattleback_lanes *far,
    rattleback_lanes *sine, rattleback_lanes *cosine)
{
    double angle[RATTLEBACK_LANES];
    double up[RATTLEBACK_LANES];
    double along[RATTLEBACK_LANES];
    (void)far;
    memcpy(angle, &x, sizeof x);
    for (int l = 0; l < RATTLEBACK_LANES; ++l) {
        up[l] = sin(angle[l]);
        along[l] = cos(angle[l]);
    }
    memcpy(sine, up, sizeof x);
    memcpy(cosine, along, sizeof x);
}

static inline rattleback_lanes rattleback_each_sqrt(rattleback_lanes a)
{
    double value[RATTLEBACK_LANES];
    memcpy(value, &a, sizeof a);
    for (int l = 0; l < RATTLEBACK_LANES; ++l) {
        value[l] = sqrt(value[l]);
    }
    memcpy(&a, value, sizeof a);
    return a;
}
#endif

int rattleback_rhs(double t, const double *y, const double *p, double *restrict dydt)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* gamma: heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);

    /* what else is read */
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / rattleback_root(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = r3 * w1 - r1 * w3;
    const double u1 = r3 * w2 + z6 * w3;
    const double z24 = r1 * w2 + z6 * w1;
    const double z25 = s_beta * u1 + c_beta * z24;
    const double z26 = c_alpha * z23 - mu2 * z25;
    const double z27 = s_beta * z24 - c_beta * u1;
    const double z28 = c_beta * w1 + s_beta * w3;
    const double z29 = s_beta * w1 - c_beta * w3;
    const double z30 = z29 / c_alpha;
    const double z31 = w2 + mu2 * z30;
    const double z32 = I_c * w3;
    const double z33 = I_b * w2 + I_d * w1;
    const double z34 = z28 * z33;
    const double z35 = z29 * z33;
    const double z36 = mu2 * z28;
    const double z37 = s_beta * z36 - mu3 * z31;
    const double z38 = c_alpha * z28;
    const double z39 = c_beta * z36 + z1 * z31;
    const double z40 = (z9 * z37 - z5 * z38 + z3 * z39) * (z2 * (z2 * z2));
    const double z41 = z24 + (z3 * z40 - k3 * (z2 * z39));
    const double z42 = u1 - (k1 * (z2 * z37) - z9 * z40);
    const double z43 = w1 * z41 - (g * mu2 - w3 * z42);
    const double z44 = z23 + (z5 * z40 + k2 * (z2 * z38));
    const double z45 = w2 * z42 + (g * mu3 + w1 * z44);
    const double z46 = w2 * z32 - (s_beta * z34 - (c_beta * z35 - (r3 * z43 - z6 * z45)));
    const double z47 = I_d * w2 + I_a * w1;
    const double z48 = w2 * z41 - (g * z1 + w3 * z44);
    const double z49 = w3 * z47 - w1 * z32 - (r3 * z48 - r1 * z45) - z14 * z46;
    const double z50 = w2 * z47 - (c_beta * z34 + (s_beta * z35 - (z6 * z48 - r1 * z43))) - z18 * z46;
    const double z51 = (z50 + z21 * z49) / z22;
    const double z52 = z20 * z49 + z21 * z51;
    /* (I.2.4) */
    dydt[0] = s_gamma * z26 - c_gamma * z27; /* x' */
    dydt[1] = -(s_gamma * z27 + c_gamma * z26); /* y' */
    dydt[2] = -(mu2 * z23 + c_alpha * z25); /* z' */
    dydt[3] = z28; /* alpha' */
    dydt[4] = z31; /* beta' */
    dydt[5] = -z30; /* gamma' */
    /* (I.2.15) 41:4 */
    dydt[6] = z18 * z51 - (z13 * z46 - z14 * z52); /* w1' */
    dydt[7] = -z52; /* w2' */
    dydt[8] = z51; /* w3' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(dydt[0] + dydt[1] + dydt[2] + dydt[6] + dydt[7]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-13 * z11
        && fabs(z22) > 1e-13 * z16)) {
        /* the coframe is singular, if c_alpha is nearly 0 */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return rattleback_refuse(fabs(z8), 0.0, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
        if (!(fabs(z15) > 1e-13 * z11)) {
            return rattleback_refuse(fabs(z15), 1e-13 * z11, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z22 is nearly 0 */
        if (!(fabs(z22) > 1e-13 * z16)) {
            return rattleback_refuse(fabs(z22), 1e-13 * z16, RATTLEBACK_SINGULAR_2);
        }
        return rattleback_finish(9, dydt);
    }
    return RATTLEBACK_OK;
}

int rattleback_velocities(double t, const double *y, const double *p, double *qdot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* gamma: heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);

    /* what else is read */
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double r1 = z1 * k1 * z2;
    const double z3 = r3 * w1 - r1 * w3;
    const double z4 = z2 * (mu2 * k2);
    const double u1 = r3 * w2 + z4 * w3;
    const double z5 = r1 * w2 + z4 * w1;
    const double z6 = s_beta * u1 + c_beta * z5;
    const double z7 = c_alpha * z3 - mu2 * z6;
    const double z8 = s_beta * z5 - c_beta * u1;
    const double z9 = (s_beta * w1 - c_beta * w3) / c_alpha;
    /* (I.2.4) */
    qdot[0] = s_gamma * z7 - c_gamma * z8; /* x' */
    qdot[1] = -(s_gamma * z8 + c_gamma * z7); /* y' */
    qdot[2] = -(mu2 * z3 + c_alpha * z6); /* z' */
    qdot[3] = c_beta * w1 + s_beta * w3; /* alpha' */
    qdot[4] = w2 + mu2 * z9; /* beta' */
    qdot[5] = -z9; /* gamma' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qdot[0] + qdot[1] + qdot[2] + qdot[3] + qdot[4] + qdot[5]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0)) {
        /* the coframe is singular, if c_alpha is nearly 0 */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
        }
        return rattleback_finish(6, qdot);
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_accelerations(double t, const double *y, const double *p, double *qddot)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* gamma: heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);

    /* what else is read */
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = r3 * w1 - r1 * w3;
    const double u1 = r3 * w2 + z6 * w3;
    const double z24 = r1 * w2 + z6 * w1;
    const double z25 = s_beta * u1 + c_beta * z24;
    const double z26 = c_alpha * z23 - mu2 * z25;
    const double z27 = 1.0 / c_alpha;
    const double z28 = s_beta * w1 - c_beta * w3;
    const double z29 = z27 * z28;
    const double z30 = c_gamma * z29;
    const double z31 = c_beta * w1 + s_beta * w3;
    const double z32 = mu2 * z31;
    const double z33 = c_alpha * z31;
    const double z34 = w2 + mu2 * z29;
    const double z35 = c_beta * z34;
    const double z36 = s_beta * z32 - c_alpha * z35;
    const double z37 = s_beta * z34;
    const double z38 = c_alpha * z37 + c_beta * z32;
    const double z39 = z2 * (z2 * z2) * (z5 * z33 - z9 * z36 - z3 * z38);
    const double z40 = z3 * z39 + k3 * (z2 * z38);
    const double z41 = k1 * (z2 * z36) + z9 * z39;
    const double z42 = w1 * z40 + w3 * z41;
    const double z43 = I_c * w3;
    const double z44 = I_b * w2 + I_d * w1;
    const double z45 = z31 * z44;
    const double z46 = z28 * z44;
    const double z47 = z42 - (w1 * z24 - (g * mu2 - w3 * u1));
    const double z48 = k2 * (z2 * z33) - z5 * z39;
    const double z49 = w2 * z41 - w1 * z48;
    const double z50 = z49 - (w2 * u1 + (g * mu3 + w1 * z23));
    const double z51 = w2 * z43 - (s_beta * z45 - (c_beta * z46 + (r3 * z47 - z6 * z50)));
    const double z52 = I_d * w2 + I_a * w1;
    const double z53 = w2 * z40 + w3 * z48;
    const double z54 = z53 + (w3 * z23 + (g * z1 - w2 * z24));
    const double z55 = w3 * z52 - w1 * z43 + (r3 * z54 - r1 * z50) - z14 * z51;
    const double z56 = w2 * z52 - (c_beta * z45 + (s_beta * z46 + (z6 * z54 - r1 * z47))) - z18 * z51;
    const double z57 = (z56 + z21 * z55) / z22;
    const double z58 = z20 * z55 + z21 * z57;
    const double z59 = z13 * z51 - z14 * z58 - z18 * z57;
    const double z60 = z42 - (r3 * z59 + r1 * z57);
    const double z61 = z53 - (r3 * z58 - z6 * z57);
    const double z62 = z49 + (r1 * z58 + z6 * z59);
    const double z63 = z35 * u1 + s_beta * z61 - (z37 * z24 + c_beta * z62);
    const double z64 = z32 * z23 - c_alpha * z60 + (z33 * z25 + mu2 * z63);
    const double z65 = s_beta * z24 - c_beta * u1;
    const double z66 = s_gamma * z29;
    const double z67 = z35 * z24 - s_beta * z62 + (z37 * u1 - c_beta * z61);
    const double z68 = z27 * z27 * (z28 * z32) + z27 * (w1 * z35 - s_beta * z59 + (w3 * z37 - c_beta * z57));
    /* (I.2.15) */
    qddot[0] = -(z26 * z30 + s_gamma * z64 + (z65 * z66 + c_gamma * z67)); /* x'' */
    qddot[1] = z65 * z30 - s_gamma * z67 - (z26 * z66 - c_gamma * z64); /* y'' */
    qddot[2] = z32 * z25 - c_alpha * z63 - (z33 * z23 + mu2 * z60); /* z'' */
    qddot[3] = w3 * z35 + s_beta * z57 - (w1 * z37 + c_beta * z59); /* alpha'' */
    qddot[4] = z29 * z33 + mu2 * z68 - z58; /* beta'' */
    qddot[5] = -z68; /* gamma'' */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(qddot[0] + qddot[1] + qddot[2] + qddot[3] + qddot[4] + qddot[5]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-13 * z11
        && fabs(z22) > 1e-13 * z16)) {
        /* the coframe is singular, if c_alpha is nearly 0 */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return rattleback_refuse(fabs(z8), 0.0, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
        if (!(fabs(z15) > 1e-13 * z11)) {
            return rattleback_refuse(fabs(z15), 1e-13 * z11, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z22 is nearly 0 */
        if (!(fabs(z22) > 1e-13 * z16)) {
            return rattleback_refuse(fabs(z22), 1e-13 * z16, RATTLEBACK_SINGULAR_2);
        }
        return rattleback_finish(6, qddot);
    }
    return RATTLEBACK_OK;
}

int rattleback_state(double t, const double *q, const double *qdot, const double *p, double *y)
{
    (void)t;
    (void)p;
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */

    /* sines and cosines */
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);

    /* what else is read */
    const double x = q[0]; /* centre of mass [cm] */
    const double y_2 = q[1]; /* y: centre of mass [cm] */
    const double z = q[2]; /* centre of mass, downwards [cm] */
    const double gamma_ = q[5]; /* gamma: heading [rad] */
    const double alpha_dot = qdot[3]; /* alpha' [rad/s] */
    const double beta_dot = qdot[4]; /* beta' [rad/s] */
    const double gamma_dot = qdot[5]; /* gamma' [rad/s] */

    /* from the coordinates and velocities */
    const double z1 = gamma_dot * c_alpha;
    y[0] = x;
    y[1] = y_2;
    y[2] = z;
    y[3] = alpha;
    y[4] = beta;
    y[5] = gamma_;
    y[6] = alpha_dot * c_beta - s_beta * z1;
    y[7] = beta_dot + gamma_dot * mu2;
    y[8] = alpha_dot * s_beta + c_beta * z1;
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(y[0] + y[1] + y[2] + y[5] + y[6] + y[7] + y[8]) <= DBL_MAX)) {
        return rattleback_finish(9, y);
    }
    return RATTLEBACK_OK;
}

int rattleback_residuals(double t, const double *q, const double *qdot, const double *p, double *r)
{
    (void)t;
    const double alpha = q[3]; /* roll about the long axis [rad] */
    const double beta = q[4]; /* pitch [rad] */
    const double gamma_ = q[5]; /* gamma: heading [rad] */

    /* sines and cosines */
    const double c_beta = cos(beta);
    const double s_beta = sin(beta);
    const double mu2 = sin(alpha);
    const double c_alpha = cos(alpha);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);

    /* what else is read */
    const double x_dot = qdot[0]; /* x' [cm/s] */
    const double y_dot = qdot[1]; /* y' [cm/s] */
    const double z_dot = qdot[2]; /* z' [cm/s] */
    const double alpha_dot = qdot[3]; /* alpha' [rad/s] */
    const double beta_dot = qdot[4]; /* beta' [rad/s] */
    const double gamma_dot = qdot[5]; /* gamma' [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the coordinates and velocities */
    const double omega2 = beta_dot + gamma_dot * mu2;
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double omega3 = alpha_dot * s_beta + gamma_dot * mu3;
    const double z3 = z2 * (mu2 * k2);
    const double u1 = omega2 * r3 + omega3 * z3;
    const double omega1 = alpha_dot * c_beta - gamma_dot * z1;
    const double r1 = z1 * k1 * z2;
    const double z4 = omega1 * z3 + omega2 * r1;
    const double v1 = c_beta * u1 - s_beta * z4;
    const double u2 = omega3 * r1 - omega1 * r3;
    const double z5 = s_beta * u1 + c_beta * z4;
    const double e2 = c_alpha * u2 + mu2 * z5;
    /* (I.1.1) 44:5 */
    r[0] = x_dot - v1 * c_gamma + e2 * s_gamma; /* roll_x = 0 */
    /* (I.1.1) 45:5 */
    r[1] = y_dot - v1 * s_gamma - e2 * c_gamma; /* roll_y = 0 */
    /* (I.1.1) 46:5 */
    r[2] = z_dot - (mu2 * u2 - c_alpha * z5); /* roll_z = 0 */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(r[0] + r[1] + r[2]) <= DBL_MAX)) {
        return rattleback_finish(3, r);
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_reactions(double t, const double *y, const double *p, double *lambda)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */
    const double gamma_ = y[5]; /* gamma: heading [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);
    const double c_gamma = cos(gamma_);
    const double s_gamma = sin(gamma_);

    /* what else is read */
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double z3 = mu3 * k3;
    const double r3 = h - z2 * z3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    const double z6 = z2 * z5;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    const double z9 = z1 * k1;
    const double r1 = z9 * z2;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    const double z12 = I_d + r1 * z6;
    const double z13 = 1.0 / z8;
    const double z14 = z12 * z13;
    const double z15 = z11 - z12 * z14;
    const double z16 = I_c + (z7 + z10);
    const double z17 = r1 * r3;
    const double z18 = z17 * z13;
    const double z19 = z6 * r3 + z12 * z18;
    const double z20 = 1.0 / z15;
    const double z21 = z19 * z20;
    const double z22 = z16 - z17 * z18 - z19 * z21;
    const double z23 = mu2 * s_gamma;
    const double z24 = s_beta * c_gamma + c_beta * z23;
    const double z25 = r3 * w1 - r1 * w3;
    const double u1 = r3 * w2 + z6 * w3;
    const double z26 = c_beta * w1 + s_beta * w3;
    const double z27 = mu2 * z26;
    const double z28 = s_beta * w1 - c_beta * w3;
    const double z29 = w2 + z28 * (mu2 / c_alpha);
    const double z30 = s_beta * z27 - mu3 * z29;
    const double z31 = c_alpha * z26;
    const double z32 = c_beta * z27 + z1 * z29;
    const double z33 = z2 * (z2 * z2) * (z5 * z31 - z9 * z30 - z3 * z32);
    const double z34 = k1 * (z2 * z30) + z9 * z33;
    const double z35 = k2 * (z2 * z31) - z5 * z33;
    const double z36 = g * mu3 + (w1 * z25 + w2 * u1 - (w2 * z34 - w1 * z35));
    const double z37 = c_beta * c_gamma - s_beta * z23;
    const double z38 = r1 * w2 + z6 * w1;
    const double z39 = z3 * z33 + k3 * (z2 * z32);
    const double z40 = g * z1 - (w2 * z38 - w3 * z25 - (w2 * z39 + w3 * z35));
    const double z41 = c_alpha * s_gamma;
    const double z42 = g * mu2 - (w3 * u1 + w1 * z38 - (w1 * z39 + w3 * z34));
    const double z43 = I_d * w2 + I_a * w1;
    const double z44 = I_b * w2 + I_d * w1;
    const double z45 = z26 * z44;
    const double z46 = z28 * z44;
    const double z47 = I_c * w3;
    const double z48 = w2 * z47 - (s_beta * z45 - (c_beta * z46 + (r3 * z42 + z6 * z36)));
    const double z49 = w2 * z43 - (c_beta * z45 + (s_beta * z46 + (z6 * z40 - r1 * z42))) - z18 * z48;
    const double z50 = w3 * z43 - w1 * z47 + (r3 * z40 + r1 * z36) - z14 * z48;
    const double z51 = (z49 + z21 * z50) / z22;
    const double z52 = z20 * z50 + z21 * z51;
    const double z53 = z13 * z48 - z14 * z52 - z18 * z51;
    const double z54 = (r1 * z41 - z6 * z37) * z51 - ((z6 * z24 - r3 * z41) * z53 + (r1 * z24 - r3 * z37) *
        z52);
    const double z55 = mu2 * c_gamma;
    const double z56 = s_beta * s_gamma - c_beta * z55;
    const double z57 = c_beta * s_gamma + s_beta * z55;
    const double z58 = c_alpha * c_gamma;
    const double z59 = (r1 * z58 + z6 * z57) * z51 + ((z6 * z56 + r3 * z58) * z53 + (r1 * z56 - r3 * z57) *
        z52);
    const double z60 = (mu2 * r1 - z1 * z6) * z51 + ((mu3 * z6 + mu2 * r3) * z53 + (mu3 * r1 + z1 * r3) *
        z52);
    /* (I.4.1) 44:5 */
    /* reaction of roll_x: Q_i gains lambda_1 a_1i */
    lambda[0] = -(z24 * z36 - (z37 * z40 + z41 * z42) + z54);
    /* (I.4.1) 45:5 */
    lambda[1] = z59 - (z56 * z36 - (z57 * z40 - z58 * z42)); /* reaction of roll_y: Q_i gains lambda_2 a_2i */
    /* (I.4.1) 46:5 */
    lambda[2] = z60 - (mu3 * z36 + (z1 * z40 + mu2 * z42)); /* reaction of roll_z: Q_i gains lambda_3 a_3i */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(lambda[0] + lambda[1] + lambda[2]) <= DBL_MAX
        && fabs(c_alpha) > 1e-12 * 4.0
        && fabs(z15) > 1e-13 * z11
        && fabs(z22) > 1e-13 * z16)) {
        /* the coframe is singular, if c_alpha is nearly 0 */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z8 is 0 */
        if (!(fabs(z8) > 0.0)) {
            return rattleback_refuse(fabs(z8), 0.0, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
        if (!(fabs(z15) > 1e-13 * z11)) {
            return rattleback_refuse(fabs(z15), 1e-13 * z11, RATTLEBACK_SINGULAR_2);
        }
        /* the mass matrix is singular, or the velocities that are kept do not suffice, if z22 is nearly 0 */
        if (!(fabs(z22) > 1e-13 * z16)) {
            return rattleback_refuse(fabs(z22), 1e-13 * z16, RATTLEBACK_SINGULAR_2);
        }
        return rattleback_finish(3, lambda);
    }
    return RATTLEBACK_OK;
}

double rattleback_energy(double t, const double *y, const double *p)
{
    (void)t;
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double beta = y[4]; /* pitch [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);
    const double mu2 = sin(alpha);
    const double s_beta = sin(beta);
    const double c_beta = cos(beta);

    /* what else is read */
    const double z = y[2]; /* centre of mass, downwards [cm] */
    const double w1 = y[6]; /* [rad/s] */
    const double w2 = y[7]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */

    /* from the parameters alone */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    const double mu3 = c_beta * c_alpha;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    const double r3 = h - z2 * (mu3 * k3);
    const double z3 = z2 * (mu2 * k2);
    const double u1 = r3 * w2 + z3 * w3;
    const double r1 = z1 * k1 * z2;
    const double z4 = r3 * w1 - r1 * w3;
    const double z5 = r1 * w2 + z3 * w1;
    const double z6 = u1 * u1 + z4 * z4 + z5 * z5 + (I_c * (w3 * w3) + (I_b * (w2 * w2) + I_a * (w1 * w1)));
    return 0.5 * z6 + w2 * (I_d * w1) - z * g;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part1(double t, const double *y, const double *p,
    double *kept, double *J)
{
    (void)t;

    /* sines and cosines */
    const double alpha = y[3]; /* roll about the long axis [rad] */
    const double c_alpha = cos(alpha);
    kept[0] = c_alpha;
    const double mu2 = sin(alpha);
    kept[1] = mu2;
    const double beta = y[4]; /* pitch [rad] */
    const double s_beta = sin(beta);
    kept[2] = s_beta;
    const double c_beta = cos(beta);
    kept[3] = c_beta;
    const double gamma_ = y[5]; /* gamma: heading [rad] */
    const double s_gamma = sin(gamma_);
    const double c_gamma = cos(gamma_);

    /* what else is read */

    /* from the parameters alone */
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double k1 = a * a;
    kept[4] = k1;
    const double b = p[1]; /* half axis 2 [cm] */
    const double k2 = b * b;
    kept[5] = k2;
    const double c = p[2]; /* half axis 3 [cm] */
    const double k3 = c * c;
    kept[6] = k3;
    const double k4 = k1 - k3;
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double k5 = I_b - I_c;
    kept[7] = k5;
    const double I_a = p[4]; /* [cm^2] */
    const double k6 = I_a - I_c;
    kept[8] = k6;

    /* from the state */
    const double z1 = c_alpha * s_beta;
    kept[9] = z1;
    const double mu3 = c_beta * c_alpha;
    kept[10] = mu3;
    const double z2 = 1.0 / sqrt(k1 * (z1 * z1) + k2 * (mu2 * mu2) + k3 * (mu3 * mu3));
    kept[11] = z2;
    const double z3 = mu3 * k3;
    kept[12] = z3;
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double r3 = h - z2 * z3;
    kept[13] = r3;
    const double z4 = r3 * r3;
    const double z5 = mu2 * k2;
    kept[14] = z5;
    const double z6 = z2 * z5;
    kept[15] = z6;
    const double z7 = z6 * z6;
    const double z8 = I_a + (z4 + z7);
    kept[16] = z8;
    const double z9 = z1 * k1;
    kept[17] = z9;
    const double r1 = z9 * z2;
    kept[18] = r1;
    const double z10 = r1 * r1;
    const double z11 = I_b + (z4 + z10);
    kept[19] = z11;
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z12 = I_d + r1 * z6;
    kept[20] = z12;
    const double z13 = 1.0 / z8;
    kept[21] = z13;
    const double z14 = z12 * z13;
    kept[22] = z14;
    const double z15 = z11 - z12 * z14;
    kept[23] = z15;
    const double z16 = I_c + (z7 + z10);
    kept[24] = z16;
    const double z17 = r1 * r3;
    kept[25] = z17;
    const double z18 = z17 * z13;
    kept[26] = z18;
    const double z19 = z6 * r3;
    kept[27] = z19;
    const double z20 = z19 + z12 * z18;
    const double z21 = 1.0 / z15;
    kept[28] = z21;
    const double z22 = z20 * z21;
    kept[29] = z22;
    const double z23 = z16 - z17 * z18 - z20 * z22;
    kept[30] = z23;
    const double w1 = y[6]; /* [rad/s] */
    const double z24 = r3 * w1;
    kept[31] = z24;
    const double w3 = y[8]; /* [rad/s] */
    const double z25 = r1 * w3;
    kept[32] = z25;
    const double z26 = z24 - z25;
    kept[33] = z26;
    const double z27 = z2 * z2;
    kept[34] = z27;
    const double z28 = z2 * z27;
    kept[35] = z28;
    const double z29 = s_beta * mu2;
    const double z30 = c_beta * mu2;
    const double z31 = z28 * (z9 * z29 - c_alpha * z5 + z3 * z30);
    const double z32 = k3 * z2;
    kept[36] = z32;
    const double z33 = z3 * z31 - z30 * z32;
    const double z34 = k1 * z2;
    kept[37] = z34;
    const double z35 = z29 * z34 - z9 * z31;
    const double z36 = w1 * z33 - w3 * z35;
    const double w2 = y[7]; /* [rad/s] */
    const double z37 = r3 * w2;
    kept[38] = z37;
    const double z38 = z6 * w3;
    kept[39] = z38;
    const double u1 = z37 + z38;
    kept[40] = u1;
    const double z39 = r1 * w2;
    kept[41] = z39;
    const double z40 = z6 * w1;
    kept[42] = z40;
    const double z41 = z39 + z40;
    kept[43] = z41;
    const double z42 = s_beta * u1 + c_beta * z41;
    const double z43 = k2 * z2;
    kept[44] = z43;
    const double z44 = z5 * z31 + c_alpha * z43;
    const double z45 = w2 * z33 - w3 * z44;
    const double z46 = w2 * z35 - w1 * z44;
    const double z47 = s_beta * z45 + c_beta * z46;
    const double z48 = mu2 * z26 + c_alpha * z36 + (c_alpha * z42 - mu2 * z47);
    const double z49 = s_beta * z46 - c_beta * z45;
    /* (I.2.15) */
    J[3] = c_gamma * z49 - s_gamma * z48;
    const double z50 = k4 * (mu3 * (z1 * z28));
    const double z51 = z3 * z50 + z1 * z32;
    const double z52 = mu3 * z34 - z9 * z50;
    const double z53 = w1 * z51 - w3 * z52;
    const double z54 = s_beta * z41 - c_beta * u1;
    const double z55 = z5 * z50;
    const double z56 = w2 * z51 - w3 * z55;
    const double z57 = w2 * z52 - w1 * z55;
    const double z58 = z54 - (s_beta * z56 + c_beta * z57);
    const double z59 = c_alpha * z53 + mu2 * z58;
    const double z60 = z42 + (s_beta * z57 - c_beta * z56);
    J[4] = s_gamma * z59 - c_gamma * z60;
    const double z61 = c_alpha * z26 - mu2 * z42;
    J[5] = s_gamma * z54 + c_gamma * z61;
    const double z62 = c_beta * z6;
    const double z63 = mu2 * z62 - c_alpha * r3;
    const double z64 = s_beta * z6;
    J[6] = -(s_gamma * z63 + c_gamma * z64);
    const double z65 = s_beta * r3 + c_beta * r1;
    const double z66 = mu2 * z65;
    const double z67 = s_beta * r1 - c_beta * r3;
    J[7] = -(s_gamma * z66 + c_gamma * z67);
    const double z68 = mu2 * z64 + c_alpha * r1;
    J[8] = c_gamma * z62 - s_gamma * z68;
    J[12] = s_gamma * z49 + c_gamma * z48;
    J[13] = -(s_gamma * z60 + c_gamma * z59);
    J[14] = s_gamma * z61 - c_gamma * z54;
    J[15] = c_gamma * z63 - s_gamma * z64;
    J[16] = c_gamma * z66 - s_gamma * z67;
    J[17] = s_gamma * z62 + c_gamma * z68;
    J[21] = mu2 * z36 + c_alpha * z47 - z61;
    J[22] = c_alpha * z58 - mu2 * z53;
    J[24] = -(mu2 * r3 + c_alpha * z62);
    J[25] = -c_alpha * z65;
    J[26] = mu2 * r1 - c_alpha * z64;
    const double z69 = s_beta * w1 - c_beta * w3;
    kept[45] = z69;
    J[31] = -z69;
    J[33] = c_beta;
    J[35] = s_beta;
    const double z70 = 1.0 / c_alpha;
    kept[46] = z70;
    const double z71 = z69 * (z70 * z70);
    kept[47] = z71;
    const double z72 = mu2 * z71;
    J[39] = z69 + mu2 * z72;
    const double z73 = c_beta * w1 + s_beta * w3;
    kept[48] = z73;
    const double z74 = z70 * z73;
    J[40] = mu2 * z74;
    const double z75 = s_beta * z70;
    J[42] = mu2 * z75;
    J[43] = 1.0;
    const double z76 = c_beta * z70;
    J[44] = -mu2 * z76;
    J[48] = -z72;
    J[49] = -z74;
    J[51] = -z75;
    J[53] = z76;
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double z77 = g * r3;
    kept[49] = z77;
    const double z78 = c_alpha * z73;
    kept[50] = z78;
    const double z79 = z6 * w2;
    kept[51] = z79;
    const double z80 = r3 * w3;
    kept[52] = z80;
    const double z81 = z79 - z80;
    kept[53] = z81;
    const double z82 = z3 * z24 - z5 * z40 - z9 * z81;
    kept[54] = z82;
    const double z83 = z27 * z82;
    kept[55] = z83;
    const double z84 = z2 * z83;
    const double z85 = k2 * z84;
    kept[56] = z85;
    const double z86 = z70 * z69;
    kept[57] = z86;
    const double z87 = c_beta * z17;
    kept[58] = z87;
    const double z88 = z87 + s_beta * z8;
    kept[59] = z88;
    const double z89 = c_beta * z88;
    const double z90 = k3 * z84;
    kept[60] = z90;
    const double z91 = z86 * z89 - (mu3 * z90 - z24 * z32);
    kept[61] = z91;
    const double z92 = s_beta * z88;
    const double z93 = k1 * z84;
    kept[62] = z93;
    const double z94 = z86 * z92 - (z1 * z93 + z81 * z34);
    kept[63] = z94;
    const double z95 = z86 * z88 - c_beta * z91 - s_beta * z94;
    kept[64] = z95;
    const double z96 = s_beta * z17;
    kept[65] = z96;
    const double z97 = z69 * z8 - z73 * (z17 - z89) - c_alpha * z94;
    kept[66] = z97;
    const double z98 = z69 * z17;
    kept[67] = z98;
    const double z99 = z98 + z73 * (z8 - z92) - c_alpha * z91;
    kept[68] = z99;
    const double z100 = z69 * (z96 - c_beta * z8) + c_beta * z97 - s_beta * z99;
    kept[69] = z100;
    const double z101 = mu2 * z73;
    kept[70] = z101;
    const double z102 = w2 + mu2 * z86;
    kept[71] = z102;
    const double z103 = c_beta * z102;
    kept[72] = z103;
    const double z104 = s_beta * z101 - c_alpha * z103;
    kept[73] = z104;
    const double z105 = s_beta * z102;
    kept[74] = z105;
    const double z106 = c_alpha * z105 + c_beta * z101;
    kept[75] = z106;
    const double z107 = z5 * z78 - z9 * z104 - z3 * z106;
    kept[76] = z107;
    const double z108 = z2 * z107;
    kept[77] = z108;
    const double z109 = z27 * z108;
    kept[78] = z109;
    const double z110 = I_c * w3;
    kept[79] = z110;
    const double z111 = I_d * w1;
    kept[80] = z111;
    const double z112 = I_b * w2 + z111;
    kept[81] = z112;
    const double z113 = z73 * z112;
    kept[82] = z113;
    const double z114 = z69 * z112;
    kept[83] = z114;
    const double z115 = k3 * z106;
    kept[84] = z115;
    const double z116 = z2 * z115 + z3 * z109;
    kept[85] = z116;
    const double z117 = k1 * z104;
    kept[86] = z117;
    const double z118 = z2 * z117 + z9 * z109;
    kept[87] = z118;
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW static int rattleback_jacobian_part2(double t, const double *y, const double *p,
    double *kept, double *J)
{
    (void)t;
    const double w1 = y[6]; /* [rad/s] */
    const double w3 = y[8]; /* [rad/s] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double mu2 = kept[1];
    const double u1 = kept[40];
    const double z41 = kept[43];
    const double z116 = kept[85];
    const double z118 = kept[87];
    const double z119 = g * mu2 - (w3 * u1 + w1 * z41 - (w1 * z116 + w3 * z118));
    const double k2 = kept[5];
    const double z78 = kept[50];
    const double z120 = k2 * z78;
    const double z2 = kept[11];
    const double z5 = kept[14];
    const double z109 = kept[78];
    const double z121 = z2 * z120 - z5 * z109;
    const double w2 = y[7]; /* [rad/s] */
    const double mu3 = kept[10];
    const double z26 = kept[33];
    const double z122 = g * mu3 + (w1 * z26 + w2 * u1 - (w2 * z118 - w1 * z121));
    const double s_beta = kept[2];
    const double c_beta = kept[3];
    const double r3 = kept[13];
    const double z6 = kept[15];
    const double z110 = kept[79];
    const double z113 = kept[82];
    const double z114 = kept[83];
    const double z123 = w2 * z110 - (s_beta * z113 - (c_beta * z114 + (r3 * z119 + z6 * z122)));
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double z124 = I_d * w2;
    const double I_a = p[4]; /* [cm^2] */
    const double z125 = z124 + I_a * w1;
    const double z1 = kept[9];
    const double z126 = g * z1 - (w2 * z41 - w3 * z26 - (w2 * z116 + w3 * z121));
    const double r1 = kept[18];
    const double z14 = kept[22];
    const double z127 = w3 * z125 - w1 * z110 + (r3 * z126 + r1 * z122) - z14 * z123;
    const double z23 = kept[30];
    const double z128 = 1.0 / z23;
    const double z18 = kept[26];
    const double z129 = w2 * z125 - (c_beta * z113 + (s_beta * z114 + (z6 * z126 - r1 * z119))) - z18 * z123;
    const double z22 = kept[29];
    const double z130 = z128 * (z129 + z22 * z127);
    const double z21 = kept[28];
    const double z131 = z21 * z127 + z22 * z130;
    const double z13 = kept[21];
    const double z132 = z13 * z123 - z14 * z131 - z18 * z130;
    const double z133 = z6 * z132;
    const double z134 = r1 * z131;
    const double z24 = kept[31];
    const double z81 = kept[53];
    const double z135 = w3 * z81 - (w1 * z24 + (2.0 * z133 - (z122 - z134)));
    const double z40 = kept[42];
    const double z73 = kept[48];
    const double z77 = kept[49];
    const double z85 = kept[56];
    const double z86 = kept[57];
    const double z95 = kept[64];
    const double z100 = kept[69];
    const double z136 = z77 + (z78 * z85 - z73 * z95 + z86 * z100) - k2 * (z40 * z109 - z2 * z135);
    const double z27 = kept[34];
    const double z108 = kept[77];
    const double z137 = z27 * z27 * z108;
    const double z138 = r3 * z132;
    const double z139 = r1 * z130;
    const double z140 = w2 * z81 + (w1 * z40 - (2.0 * z138 - (z119 - z139)));
    const double z3 = kept[12];
    const double z83 = kept[55];
    const double z107 = kept[76];
    const double z115 = kept[84];
    const double z117 = kept[86];
    const double z141 = z115 * z24 + z120 * z40 - z117 * z81 + z107 * z83 - z3 * z140 + z5 * z135;
    const double z142 = w2 * z24;
    const double z143 = w3 * z40;
    const double z144 = r3 * z130;
    const double z145 = z6 * z131;
    const double z146 = z142 + (z143 + (z144 + z145));
    const double z9 = kept[17];
    const double z28 = kept[35];
    const double z82 = kept[54];
    const double z147 = z82 * z137 + 0.5 * (z28 * (z141 - z9 * z146));
    const double z43 = kept[44];
    const double z148 = mu2 * z85 + z40 * z43;
    const double z149 = mu2 * z100;
    const double z150 = g * z6;
    const double k3 = kept[6];
    const double z90 = kept[60];
    const double z106 = kept[75];
    const double z151 = z150 - z106 * z90 + k3 * (z24 * z109 - z2 * z140) - 2.0 * (z3 * z147);
    const double k1 = kept[4];
    const double z93 = kept[62];
    const double z104 = kept[73];
    const double z152 = z104 * z93 + k1 * (z81 * z109 + z2 * z146) + 2.0 * (z9 * z147);
    const double z71 = kept[47];
    const double z91 = kept[61];
    const double z94 = kept[63];
    const double z103 = kept[72];
    const double z105 = kept[74];
    const double z153 = z73 * z148 + z105 * z91 - z103 * z94 - z71 * z149 + c_beta * z151 - s_beta * z152;
    const double c_alpha = kept[0];
    const double z154 = c_alpha * (z136 - 2.0 * (z5 * z147)) - mu2 * z153;
    const double z155 = r1 * w1;
    const double z80 = kept[52];
    const double z156 = z80 + z155;
    const double z37 = kept[38];
    const double z39 = kept[41];
    const double z157 = z9 * z39 - (z3 * z37 - z5 * z156);
    const double z158 = z27 * z157;
    const double z159 = z2 * z158;
    const double z160 = k2 * z159;
    const double z12 = kept[20];
    const double z19 = kept[27];
    const double z161 = s_beta * z12 - c_beta * z19;
    const double z162 = c_beta * z161;
    const double z163 = k3 * z159;
    const double z32 = kept[36];
    const double z164 = z86 * z162 + (mu3 * z163 + z37 * z32);
    const double z165 = s_beta * z161;
    const double z166 = k1 * z159;
    const double z34 = kept[37];
    const double z167 = z86 * z165 + (z1 * z166 - z39 * z34);
    const double z168 = z86 * z161 - c_beta * z164 - s_beta * z167;
    const double z69 = kept[45];
    const double z169 = z69 * z12 + z73 * (z19 + z162) - c_alpha * z167;
    const double z170 = z69 * z19 - z73 * (z12 - z165) + c_alpha * z164;
    const double z171 = z69 * (c_beta * z12 + s_beta * z19) - c_beta * z169 - s_beta * z170;
    const double z172 = w3 * z39;
    const double z173 = r1 * z132;
    const double z174 = z172 - (z142 - (z144 - z173));
    const double z175 = r3 * z131;
    const double z176 = z6 * z130;
    const double z177 = w2 * z39 + (w1 * z156 - (2.0 * z175 - (z126 + z176)));
    const double z178 = z39 * z117 - (z37 * z115 + z120 * z156) + z107 * z158 + z3 * z177 - z5 * z174;
    const double z179 = w2 * z37 + (w3 * z156 + (z133 - (z122 - 2.0 * z134)));
    const double z180 = z157 * z137 + 0.5 * (z28 * (z178 + z9 * z179));
    const double z181 = z78 * z160 + z73 * z168 + z86 * z171 + k2 * (z156 * z109 - z2 * z174) - 2.0 * (z5 *
        z180);
    const double z182 = mu2 * z160 - z43 * z156;
    const double z183 = mu2 * z171;
    const double z184 = g * r1;
    const double z185 = z184 + z106 * z163 + k3 * (z37 * z109 - z2 * z177) + 2.0 * (z3 * z180);
    const double z186 = z77 + z104 * z166 - k1 * (z39 * z109 + z2 * z179) + 2.0 * (z9 * z180);
    const double z187 = z73 * z182 - z105 * z164 + z103 * z167 - z71 * z183 - c_beta * z185 - s_beta * z186;
    const double z188 = c_alpha * z181 - mu2 * z187 + z14 * z154;
    const double z79 = kept[51];
    const double z189 = z79 - z155;
    const double z25 = kept[32];
    const double z38 = kept[39];
    const double z190 = z3 * z189 - z5 * z38 - z9 * z25;
    const double z191 = z27 * z190;
    const double z192 = z2 * z191;
    const double z193 = k2 * z192;
    const double z16 = kept[24];
    const double z96 = kept[65];
    const double z194 = z96 + c_beta * z16;
    const double z195 = c_beta * z194;
    const double z196 = k3 * z192;
    const double z197 = z86 * z195 + (mu3 * z196 - z189 * z32);
    const double z198 = s_beta * z194;
    const double z199 = k1 * z192;
    const double z200 = z86 * z198 + (z1 * z199 + z25 * z34);
    const double z201 = z86 * z194 - c_beta * z197 - s_beta * z200;
    const double z98 = kept[67];
    const double z202 = z98 - z73 * (z16 - z195) - c_alpha * z200;
    const double z17 = kept[25];
    const double z203 = z69 * z16 + z73 * (z17 - z198) - c_alpha * z197;
    const double z87 = kept[58];
    const double z204 = z69 * (z87 - s_beta * z16) - c_beta * z202 + s_beta * z203;
    const double z205 = w3 * z25 - (w1 * z189 - (2.0 * z176 + (z126 - z175)));
    const double z206 = z184 - (z78 * z193 + z73 * z201 + z86 * z204) + k2 * (z38 * z109 - z2 * z205);
    const double z207 = z172 + (z143 - (z145 - z173));
    const double z208 = z115 * z189 + z120 * z38 - z117 * z25 + z107 * z191 - z3 * z207 + z5 * z205;
    const double z209 = w2 * z189 + (w3 * z38 - (z138 - (z119 - 2.0 * z139)));
    const double z210 = z190 * z137 + 0.5 * (z28 * (z208 - z9 * z209));
    const double z211 = mu2 * z193 + z38 * z43;
    const double z212 = mu2 * z204;
    const double z213 = z106 * z196 - k3 * (z189 * z109 - z2 * z207) + 2.0 * (z3 * z210);
    const double z214 = z150 - z104 * z199 - k1 * (z25 * z109 + z2 * z209) - 2.0 * (z9 * z210);
    const double z215 = z73 * z211 - z105 * z197 + z103 * z200 - z71 * z212 - c_beta * z213 + s_beta * z214;
    const double z216 = z128 * (c_alpha * (z206 + 2.0 * (z5 * z210)) + mu2 * z215 - z18 * z154 - z22 * z188);
    const double z217 = z21 * z188 - z22 * z216;
    /* (I.2.15) */
    J[57] = z18 * z216 - (z13 * z154 + z14 * z217);
    const double z102 = kept[71];
    const double z218 = z69 * z102;
    const double z219 = z218 * z17;
    const double z220 = z73 * z105 + z86 * z104;
    const double z221 = z73 * z103 + z86 * z106;
    const double z101 = kept[70];
    const double z222 = s_beta * z220 + c_beta * z221 - z86 * z101;
    const double z223 = z6 * z121;
    const double z224 = I_d * w3 - z6 * z26;
    const double z225 = r3 * z41;
    const double z226 = r3 * z116;
    const double z227 = z223 - (z224 + z225 - z226);
    const double z8 = kept[16];
    const double z88 = kept[59];
    const double z99 = kept[68];
    const double z228 = z219 - (z113 - z222 * z8) + z220 * z88 + z101 * z94 - z102 * z99 + z69 * z227;
    const double I_c = p[6]; /* [cm^2] */
    const double z229 = z6 * z81 - (r1 * z40 - (I_c * w2 - r3 * u1 + r3 * z118));
    const double z112 = kept[81];
    const double z230 = c_beta * z112;
    const double z70 = kept[46];
    const double z231 = z230 + s_beta * z227 - c_beta * z229 + z70 * z149;
    const double z232 = s_beta * z112 - c_alpha * z148 + mu2 * z95 - c_beta * z227 - s_beta * z229;
    const double z233 = z222 * z17;
    const double z97 = kept[66];
    const double z234 = z233 + (z114 - z218 * z8) + z221 * z88 + z101 * z91 + z102 * z97 + z73 * z227;
    const double z235 = c_beta * (z228 + z73 * z229 + w1 * z231 - w3 * z232 - c_alpha * z152) - s_beta *
        (z234 - z69 * z229 - w3 * z231 - w1 * z232 + c_alpha * z151);
    const double k6 = kept[8];
    const double z236 = z6 * z37 - (r3 * z156 + (w3 * k6 + r1 * z26 + r1 * z121));
    const double z237 = z222 * z12 - z218 * z19 + z220 * z161 + z101 * z167 + z102 * z170 - z69 * z236;
    const double z238 = z6 * z39 - (r1 * z156 - (z125 - I_c * w1 + r3 * z26 + r3 * z121));
    const double z239 = s_beta * z236 + c_beta * z238 + z70 * z183;
    const double z240 = c_alpha * z182 + mu2 * z168 + c_beta * z236 - s_beta * z238;
    const double z241 = z218 * z12 + z222 * z19 - z221 * z161 - z101 * z164 - z102 * z169 + z73 * z236;
    const double z242 = c_beta * (z237 + z73 * z238 - w1 * z239 - w3 * z240 + c_alpha * z186) + s_beta *
        (z241 + z69 * z238 - w3 * z239 + w1 * z240 - c_alpha * z185);
    const double z243 = z242 - z14 * z235;
    const double z111 = kept[80];
    const double z244 = z6 * z189 - (r3 * z38 + (z111 - I_a * w2 + r1 * z41 - r1 * z116));
    const double z245 = z114 - z233 - z218 * z16 - z220 * z194 - z101 * z200 + z102 * z203 - z69 * z244;
    const double z246 = r1 * z118;
    const double z247 = z223 + (z225 - z246);
    const double z248 = s_beta * (z112 - z244) - c_beta * z247 + z70 * z212;
    const double z249 = z230 + c_alpha * z211 + mu2 * z201 - c_beta * z244 + s_beta * z247;
    const double z250 = z113 + z219 - z222 * z16 - z221 * z194 - z101 * z197 - z102 * z202 - z73 * z244;
    const double z251 = c_beta * (z245 + z73 * z247 + w1 * z248 + w3 * z249 + c_alpha * z214) - s_beta *
        (z250 - z69 * z247 - w3 * z248 + w1 * z249 - c_alpha * z213);
    const double z252 = z128 * (z251 + z18 * z235 - z22 * z243);
    const double z253 = z21 * z243 - z22 * z252;
    J[58] = -(z13 * z235 - z14 * z253 + z18 * z252);
    const double z254 = s_beta * z231 - c_beta * z232;
    const double z255 = s_beta * z239 + c_beta * z240 + z14 * z254;
    const double z256 = z128 * (s_beta * z248 + c_beta * z249 + z18 * z254 + z22 * z255);
    const double z257 = z21 * z255 + z22 * z256;
    J[60] = -(z13 * z254 + z14 * z257 + z18 * z256);
    const double k5 = kept[7];
    const double z258 = r3 * z81 - (r1 * z24 + (w3 * k5 - z6 * u1 + z6 * z118 - z100));
    const double z259 = z226 + (z224 - z246) - z171 - z14 * z258;
    const double I_b = p[5]; /* [cm^2] */
    const double z260 = r3 * z25 - (r1 * z189 + (z124 + (z125 - I_b * w1) + z6 * z41 - z6 * z116 - z204));
    const double z261 = z128 * (z260 + z18 * z258 - z22 * z259);
    const double z262 = z21 * z259 - z22 * z261;
    J[61] = -(z13 * z258 - z14 * z262 + z18 * z261);
    const double z263 = c_beta * z231 + s_beta * z232;
    const double z264 = c_beta * z239 - s_beta * z240 + z14 * z263;
    const double z265 = z128 * (c_beta * z248 - s_beta * z249 + z18 * z263 + z22 * z264);
    const double z266 = z21 * z264 + z22 * z265;
    J[62] = z13 * z263 + z14 * z266 + z18 * z265;
    J[66] = z217;
    J[67] = -z253;
    J[69] = z257;
    J[70] = -z262;
    J[71] = -z266;
    J[75] = z216;
    J[76] = -z252;
    J[78] = -z256;
    J[79] = -z261;
    J[80] = z265;
    /* the coframe is singular, if c_alpha is nearly 0 */
    if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
        return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
    }
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z8 is 0 */
    if (!(fabs(z8) > 0.0)) {
        return rattleback_refuse(fabs(z8), 0.0, RATTLEBACK_SINGULAR_2);
    }
    const double z11 = kept[19];
    const double z15 = kept[23];
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
    if (!(fabs(z15) > 1e-13 * z11)) {
        return rattleback_refuse(fabs(z15), 1e-13 * z11, RATTLEBACK_SINGULAR_2);
    }
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z23 is nearly 0 */
    if (!(fabs(z23) > 1e-13 * z16)) {
        return rattleback_refuse(fabs(z23), 1e-13 * z16, RATTLEBACK_SINGULAR_2);
    }
    return RATTLEBACK_OK;
}

RATTLEBACK_SLOW
int rattleback_jacobian(double t, const double *y, const double *p, double *J)
{
    double kept[88]; /* what parts of this function leave for others */
    memset(J, 0, 81 * sizeof *J);
    int status = rattleback_jacobian_part1(t, y, p, kept, J);
    if (status == RATTLEBACK_OK) {
        status = rattleback_jacobian_part2(t, y, p, kept, J);
    }
    if (status != RATTLEBACK_OK) {
        return status;
    }
    return rattleback_finish(81, J);
}

int rattleback_outputs(double t, const double *y, const double *p, double *out)
{
    (void)t;
    (void)p;
    const double alpha = y[3]; /* roll about the long axis [rad] */

    /* sines and cosines */
    const double c_alpha = cos(alpha);

    /* what else is read */
    const double w3 = y[8]; /* [rad/s] */

    /* from the state */
    /* 53:9 */
    out[0] = w3; /* spin */
    /* an infinity, a NaN or a division by zero anywhere above stays in this sum */
    if (!(fabs(out[0]) <= DBL_MAX && fabs(c_alpha) > 1e-12 * 4.0)) {
        /* the coframe is singular, if c_alpha is nearly 0 */
        if (!(fabs(c_alpha) > 1e-12 * 4.0)) {
            return rattleback_refuse(fabs(c_alpha), 1e-12 * 4.0, RATTLEBACK_SINGULAR_1);
        }
        return rattleback_finish(1, out);
    }
    return RATTLEBACK_OK;
}

#if RATTLEBACK_LANES >= 2
static __attribute__((noinline)) void rattleback_rhs_lanes(const double *fixed, size_t stride,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    (void)t;
    rattleback_lanes far = {0}; /* the squares of the angles */
    rattleback_lanes sum = {0}; /* an infinity or a NaN among the results stays in it */
    rattleback_bits bad = {0}; /* singular blocks */
    const double h = fixed[0];
    const double I_a = fixed[1];
    const double I_b = fixed[2];
    const double I_c = fixed[3];
    const double I_d = fixed[4];
    const double g = fixed[5];
    const double k1 = fixed[6];
    const double k2 = fixed[7];
    const double k3 = fixed[8];
    const rattleback_lanes alpha = rattleback_get(y + 3 * stride);
    const rattleback_lanes beta = rattleback_get(y + 4 * stride);
    const rattleback_lanes gamma_ = rattleback_get(y + 5 * stride);
    const rattleback_lanes w1 = rattleback_get(y + 6 * stride);
    const rattleback_lanes w2 = rattleback_get(y + 7 * stride);
    const rattleback_lanes w3 = rattleback_get(y + 8 * stride);
    rattleback_lanes sine1, cosine1;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(alpha), &far, &sine1, &cosine1);
    const rattleback_lanes c_alpha = cosine1;
    /* the coframe is singular, if c_alpha is nearly 0 */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(c_alpha)), RATTLEBACK_SPREAD(1e-12 * 4.0));
    rattleback_lanes sine2, cosine2;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(beta), &far, &sine2, &cosine2);
    const rattleback_lanes s_beta = sine2;
    const rattleback_lanes z1 = c_alpha * s_beta;
    const rattleback_lanes mu2 = sine1;
    const rattleback_lanes c_beta = cosine2;
    const rattleback_lanes mu3 = c_beta * c_alpha;
    const rattleback_lanes z2 = 1.0 / rattleback_each_sqrt(RATTLEBACK_SPREAD(k1 * (z1 * z1) + k2 * (mu2 *
        mu2) + k3 * (mu3 * mu3)));
    const rattleback_lanes z3 = mu3 * k3;
    const rattleback_lanes r3 = h - z2 * z3;
    const rattleback_lanes z4 = r3 * r3;
    const rattleback_lanes z5 = mu2 * k2;
    const rattleback_lanes z6 = z2 * z5;
    const rattleback_lanes z7 = z6 * z6;
    const rattleback_lanes z8 = I_a + (z4 + z7);
    const rattleback_lanes z9 = z1 * k1;
    const rattleback_lanes r1 = z9 * z2;
    const rattleback_lanes z10 = r1 * r1;
    const rattleback_lanes z11 = I_b + (z4 + z10);
    const rattleback_lanes z12 = I_d + r1 * z6;
    const rattleback_lanes z13 = 1.0 / z8;
    const rattleback_lanes z14 = z12 * z13;
    const rattleback_lanes z15 = z11 - z12 * z14;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z15 is nearly 0 */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z15)), 1e-13 * z11);
    const rattleback_lanes z16 = I_c + (z7 + z10);
    const rattleback_lanes z17 = r1 * r3;
    const rattleback_lanes z18 = z17 * z13;
    const rattleback_lanes z19 = z6 * r3 + z12 * z18;
    const rattleback_lanes z20 = 1.0 / z15;
    const rattleback_lanes z21 = z19 * z20;
    const rattleback_lanes z22 = z16 - z17 * z18 - z19 * z21;
    /* the mass matrix is singular, or the velocities that are kept do not suffice, if z22 is nearly 0 */
    bad |= rattleback_misses(rattleback_size(RATTLEBACK_SPREAD(z22)), 1e-13 * z16);
    rattleback_lanes sine3, cosine3;
    rattleback_turn_lanes(RATTLEBACK_SPREAD(gamma_), &far, &sine3, &cosine3);
    const rattleback_lanes s_gamma = sine3;
    const rattleback_lanes z23 = r3 * w1 - r1 * w3;
    const rattleback_lanes u1 = r3 * w2 + z6 * w3;
    const rattleback_lanes z24 = r1 * w2 + z6 * w1;
    const rattleback_lanes z25 = s_beta * u1 + c_beta * z24;
    const rattleback_lanes z26 = c_alpha * z23 - mu2 * z25;
    const rattleback_lanes c_gamma = cosine3;
    const rattleback_lanes z27 = s_beta * z24 - c_beta * u1;
    const rattleback_lanes z28 = c_beta * w1 + s_beta * w3;
    const rattleback_lanes z29 = s_beta * w1 - c_beta * w3;
    const rattleback_lanes z30 = z29 / c_alpha;
    const rattleback_lanes z31 = w2 + mu2 * z30;
    const rattleback_lanes z32 = I_c * w3;
    const rattleback_lanes z33 = I_b * w2 + I_d * w1;
    const rattleback_lanes z34 = z28 * z33;
    const rattleback_lanes z35 = z29 * z33;
    const rattleback_lanes z36 = mu2 * z28;
    const rattleback_lanes z37 = s_beta * z36 - mu3 * z31;
    const rattleback_lanes z38 = c_alpha * z28;
    const rattleback_lanes z39 = c_beta * z36 + z1 * z31;
    const rattleback_lanes z40 = (z9 * z37 - z5 * z38 + z3 * z39) * (z2 * (z2 * z2));
    const rattleback_lanes z41 = z24 + (z3 * z40 - k3 * (z2 * z39));
    const rattleback_lanes z42 = u1 - (k1 * (z2 * z37) - z9 * z40);
    const rattleback_lanes z43 = w1 * z41 - (g * mu2 - w3 * z42);
    const rattleback_lanes z44 = z23 + (z5 * z40 + k2 * (z2 * z38));
    const rattleback_lanes z45 = w2 * z42 + (g * mu3 + w1 * z44);
    const rattleback_lanes z46 = w2 * z32 - (s_beta * z34 - (c_beta * z35 - (r3 * z43 - z6 * z45)));
    const rattleback_lanes z47 = I_d * w2 + I_a * w1;
    const rattleback_lanes z48 = w2 * z41 - (g * z1 + w3 * z44);
    const rattleback_lanes z49 = w3 * z47 - w1 * z32 - (r3 * z48 - r1 * z45) - z14 * z46;
    const rattleback_lanes z50 = w2 * z47 - (c_beta * z34 + (s_beta * z35 - (z6 * z48 - r1 * z43))) - z18 *
        z46;
    const rattleback_lanes z51 = (z50 + z21 * z49) / z22;
    const rattleback_lanes z52 = z20 * z49 + z21 * z51;
    /* (I.2.4) */
    const rattleback_lanes slope1 = s_gamma * z26 - c_gamma * z27;
    sum += slope1;
    rattleback_put(dydt, slope1);
    const rattleback_lanes slope2 = -(s_gamma * z27 + c_gamma * z26);
    sum += slope2;
    rattleback_put(dydt + 1 * stride, slope2);
    const rattleback_lanes slope3 = -(mu2 * z23 + c_alpha * z25);
    sum += slope3;
    rattleback_put(dydt + 2 * stride, slope3);
    const rattleback_lanes slope4 = z28;
    rattleback_put(dydt + 3 * stride, slope4);
    const rattleback_lanes slope5 = z31;
    rattleback_put(dydt + 4 * stride, slope5);
    const rattleback_lanes slope6 = -z30;
    rattleback_put(dydt + 5 * stride, slope6);
    /* (I.2.15) 41:4 */
    const rattleback_lanes slope7 = z18 * z51 - (z13 * z46 - z14 * z52);
    sum += slope7;
    rattleback_put(dydt + 6 * stride, slope7);
    const rattleback_lanes slope8 = -z52;
    sum += slope8;
    rattleback_put(dydt + 7 * stride, slope8);
    const rattleback_lanes slope9 = z51;
    rattleback_put(dydt + 8 * stride, slope9);
    rattleback_put(check, rattleback_mark(far + (sum - sum), bad));
}

static __attribute__((noinline)) void rattleback_rhs_tail(const double *fixed, size_t left, size_t count,
    const double *t, const double *y, double *restrict dydt, double *check)
{
    double time[RATTLEBACK_LANES];
    double state[9 * RATTLEBACK_LANES];
    double slope[9 * RATTLEBACK_LANES];
    rattleback_fill(left, count, t, y, time, state);
    rattleback_rhs_lanes(fixed, RATTLEBACK_LANES, time, state, slope, check);
    rattleback_pour(left, count, slope, dydt);
}
#endif

int rattleback_rhs_batch(size_t count, const double *t, const double *y, const double *p,
    double *restrict dydt)
{
#if RATTLEBACK_LANES >= 2
    const double a = p[0]; /* half axis 1 of the ellipsoid [cm] */
    const double b = p[1]; /* half axis 2 [cm] */
    const double c = p[2]; /* half axis 3 [cm] */
    const double h = p[3]; /* from the centre of the ellipsoid down to the centre of mass [cm] */
    const double I_a = p[4]; /* [cm^2] */
    const double I_b = p[5]; /* [cm^2] */
    const double I_c = p[6]; /* [cm^2] */
    const double I_d = p[7]; /* product of inertia, what makes it a rattleback [cm^2] */
    const double g = p[8]; /* acceleration of gravity [cm/s^2] */
    const double k1 = a * a;
    const double k2 = b * b;
    const double k3 = c * c;
    const double fixed[] = {h, I_a, I_b, I_c, I_d, g, k1, k2, k3};
    double check[1 * RATTLEBACK_LANES];
    int status = RATTLEBACK_OK;
    for (size_t i = 0; i < count; i += RATTLEBACK_LANES) {
        const size_t left = count - i < RATTLEBACK_LANES ? count - i : RATTLEBACK_LANES;
        if (left == RATTLEBACK_LANES) {
            rattleback_rhs_lanes(fixed, count, t + i, y + i, dydt + i, check);
        } else {
            rattleback_rhs_tail(fixed, left, count, t + i, y + i, dydt + i, check);
        }
        if (!rattleback_is_good(1 * RATTLEBACK_LANES, check)) {
            const int one = rattleback_one_by_one(count, i, left, t, y, p, dydt);
            status = status == RATTLEBACK_OK ? one : status;
        }
    }
    return status;
#else
    return rattleback_one_by_one(count, 0, count, t, y, p, dydt);
#endif
}
